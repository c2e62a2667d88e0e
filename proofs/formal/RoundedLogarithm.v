(* The kernels' logarithm as float64 carries it out: doublings and mantissa, node, quotient in two parts, series. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Relative Mult_error Pff2Flocq.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Float Float64 RoundedHalfTurns Rounding RoundedGradient RoundedAngle.
Open Scope R_scope.

(* Twice the quotient and the series are within 13/1000 2^-53 of its logarithm, relative to the quotient. *)
Lemma series_relative (q : R) : Rabs q <= 59/1000 -> Rabs (2 * q + logarithm_polynomial.log_tail q - (ln (1 + q) - ln (1 - q))) <= 13/1000 / 2 ^ 53 * Rabs q.
Proof.
  intro B. set (g := fun t => 2 * t + logarithm_polynomial.log_tail t - (ln (1 + t) - ln (1 - t))). change (Rabs (g q) <= 13/1000 / 2 ^ 53 * Rabs q). destruct (Rle_lt_dec (3/64) (Rabs q)) as [L|L].
  - apply Rle_trans with (13/1000 / 2 ^ 53 * (3/64)); [|lra]. apply Rabs_le_between in B. unfold g; logarithm_polynomial.lines.
    unfold Rabs in L; destruct Rcase_abs in L; [assert (- (59/1000) <= q <= - (3/64)) by lra | assert (3/64 <= q <= 59/1000) by lra]; interval with (i_taylor q, i_degree 20, i_prec 120).
  - assert (G : g 0 = 0) by (unfold g; logarithm_polynomial.lines; rewrite Rplus_0_r, Rminus_0_r; ring).
    replace (g q) with (g q - g 0) by (rewrite G; ring). rewrite <- (Rminus_0_r q) at 2. evar (h : R -> R). apply (bounded_variation g h). intros t T.
    assert (T' : - (3/64) <= t <= 3/64) by (rewrite !Rminus_0_r in T; apply Rabs_le_between; lra). clear T. split.
    + unfold g; logarithm_polynomial.lines. auto_derive; [lra|]. unfold h. reflexivity.
    + unfold h. clear - T'. interval with (i_taylor t, i_degree 20, i_prec 120).
Qed.

Definition least_float64 : R := bpow radix2 (-1074).
Lemma bounded_product (x y X Y : R) : Rabs x <= X -> Rabs y <= Y -> Rabs (x * y) <= X * Y.
Proof. intros A B. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; assumption. Qed.
Lemma within_rounding (x X : R) : Rabs x <= X -> Rabs (rounded x - x) <= / 2 ^ 53 * X + least_float64.
Proof. unfold least_float64. generalize (one_rounding x). lra. Qed.
(* The part of 26 digits, which is split off by a multiplication. *)
Lemma high_part (x : R) : float64 x -> let h := rounded (rounded (134217729 * x) - rounded (rounded (134217729 * x) - x)) in
  generic_format radix2 (FLT_exp (-1074) 26) h /\ Rabs (h - x) <= / 2 ^ 26 * Rabs x + least_float64.
Proof.
  intros F h. assert (H := Veltkamp_Even radix2 (-1074) 53 (fun n => negb (Z.even n)) 27 ltac:(easy) ltac:(easy) ltac:(easy) ltac:(easy) x F eq_refl).
  assert (C : bpow radix2 27 + 1 = 134217729) by (simpl; lra). rewrite C in H. change (round radix2 (FLT_exp (-1074) 53) (Znearest (fun n => negb (Z.even n)))) with rounded in H.
  assert (E : h = round radix2 (FLT_exp (-1074) (53 - 27)) (Znearest (fun n => negb (Z.even n))) x).
  { rewrite <- H. unfold h. rewrite (Rmult_comm x). f_equal. replace (x - rounded (134217729 * x)) with (- (rounded (134217729 * x) - x)) by ring. rewrite rounded_opp. ring. }
  assert (P : Prec_gt_0 26) by easy. rewrite E. split; [apply generic_format_round; typeclasses eauto|].
  destruct (error_N_FLT radix2 (-1074) (53 - 27) ltac:(easy) (fun n => negb (Z.even n)) x) as (d & t & D & T & _ & ->). replace (x * (1 + d) + t - x) with (d * x + t) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult. apply Rplus_le_compat; [apply Rmult_le_compat_r; [apply Rabs_pos|] | unfold least_float64; generalize (bpow_gt_0 radix2 (-1074)); lra].
  eapply Rle_trans; [exact D | unfold u_ro; simpl; lra].
Qed.
(* Its product with a number of 27 digits is exact. *)
Lemma short_product (h : R) (k e : Z) : generic_format radix2 (FLT_exp (-1074) 26) h -> (Z.abs k <= 2 ^ 27)%Z -> h = 0 \/ k = 0%Z \/ bpow radix2 (-1022) <= Rabs (h * (IZR k * bpow radix2 e)) -> float64 (h * (IZR k * bpow radix2 e)).
Proof.
  intros F K [-> | [-> | L]]; [rewrite Rmult_0_l; apply generic_format_0 | rewrite Rmult_0_l, Rmult_0_r; apply generic_format_0|].
  apply generic_format_FLT_FLX; [exact L|]. apply generic_format_FLX_FLT, FLX_format_generic in F; [|easy]. destruct F as [[n j] E N]. cbn [Fnum] in N.
  apply generic_format_FLX. exists (Float radix2 (n * k) (j + e)); [|cbn [Fnum]; change (radix_val radix2 ^ 26)%Z with (2 ^ 26)%Z in N; rewrite Z.abs_mul; apply Z.le_lt_trans with (Z.abs n * 2 ^ 27)%Z; [apply Z.mul_le_mono_nonneg_l; lia | change (radix_val radix2 ^ 53)%Z with (2 ^ 26 * 2 ^ 27)%Z; lia]].
  rewrite E. unfold F2R. cbn [Fnum Fexp]. rewrite mult_IZR, bpow_plus. ring.
Qed.
Lemma units_below (z e k : Z) : (0 <= k)%Z -> Rabs (IZR z * bpow radix2 e) < bpow radix2 (k + e) -> (Z.abs z < 2 ^ k)%Z.
Proof.
  intros K B. apply lt_IZR. rewrite abs_IZR, (IZR_Zpower radix2) by exact K. apply Rmult_lt_reg_r with (bpow radix2 e); [apply bpow_gt_0|].
  rewrite <- bpow_plus. rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)) in B by apply bpow_ge_0. exact B.
Qed.
Ltac by_sides := repeat match goal with B : Rabs _ <= _ |- _ => apply Rabs_le_between in B end; try apply Rabs_le; lra.

Section doublings.
Variable x : R.
Hypothesis F : float64 x.
Hypothesis P : 0 < x < bpow radix2 1024.
Let m := natural_logarithm_float64.mantissa x.
(* The mantissa and the doublings are exact. *)
Lemma doublings_and_mantissa : exists n : Z, natural_logarithm_float64.doublings x = IZR n /\ (-1075 <= n <= 1025)%Z /\ float64 m /\ 7071067/10000000 <= m <= 14142137/10000000 /\ x = m * bpow radix2 n.
Proof.
  assert (L := generic_format_ge_bpow radix2 (FLT_exp (-1074) 53) (-1074) ltac:(intro; apply Z.le_max_r) x (proj1 P) F).
  set (b := if Rlt_dec x 1 then 200%Z else (-200)%Z). set (s := x * bpow radix2 b).
  assert (K : exists k, bpow radix2 k <= x /\ (-1022 - k <= b)%Z /\ (-874 <= k + b)%Z /\ natural_logarithm_float64.scaled_by x = IZR b).
  { unfold natural_logarithm_float64.scaled_by, b. destruct Rlt_dec as [W|W]; [exists (-1074)%Z | exists 0%Z; apply Rnot_lt_le in W]; repeat split; assumption || easy. }
  destruct K as (k & K & Kb & Ks & B). assert (S : natural_logarithm_float64.scaled x = s).
  { unfold natural_logarithm_float64.scaled, power_of_two. rewrite B, Zfloor_IZR. apply kept, (scaled_float64 x k); [exact F | rewrite Rabs_pos_eq; lra | exact Kb]. }
  assert (Sl : bpow radix2 (-874) <= s).
  { apply Rle_trans with (bpow radix2 (k + b)); [apply bpow_le, Ks|]. rewrite bpow_plus. apply Rmult_le_compat_r; [apply bpow_ge_0 | exact K]. }
  assert (S0 := bpow_gt_0 radix2 (-874)). set (c := 6369051672525773 / 4503599627370496). destruct (standard_model (c * s)) as (d & D & W).
  { rewrite Rabs_pos_eq by (unfold c; lra). apply Rle_trans with (bpow radix2 (-874)); [apply bpow_le; easy | unfold c; lra]. }
  replace unit_roundoff with (/ 2 ^ 53) in D by (unfold unit_roundoff; simpl; lra). apply Rabs_le_between in D. set (e := (mag radix2 (c * s * (1 + d)) - 1)%Z).
  assert (Wp : 0 < c * s * (1 + d)) by (apply Rmult_lt_0_compat; [unfold c|]; lra). assert (M := bpow_mag_gt radix2 (c * s * (1 + d))). assert (N := bpow_mag_le radix2 (c * s * (1 + d)) ltac:(lra)).
  rewrite Rabs_pos_eq in M, N by lra. fold e in N. replace (mag radix2 (c * s * (1 + d)) : Z) with (e + 1)%Z in M by (unfold e; lia). rewrite bpow_plus in M. change (bpow radix2 1) with 2 in M.
  assert (E0 := bpow_gt_0 radix2 e). set (g := c * (1 + d)). assert (G : 14142135/10000000 <= g <= 14142136/10000000) by (unfold g, c; lra). replace (c * s * (1 + d)) with (s * g) in M, N by (unfold g; ring).
  assert (Bi : natural_logarithm_float64.binary x = IZR e) by (unfold natural_logarithm_float64.binary; rewrite S; fold c; rewrite W; reflexivity).
  assert (Mm : m = s * bpow radix2 (- e)).
  { unfold m, natural_logarithm_float64.mantissa, power_of_two. rewrite S, Bi, <- opp_IZR, Zfloor_IZR. apply kept, (scaled_float64 s (e - 1)); [rewrite <- S; apply rounded_is_float64 | | lia].
    unfold Z.sub. rewrite bpow_plus. change (bpow radix2 (- (1))) with (/ 2). rewrite Rabs_pos_eq by lra. nra. }
  assert (Ms : m * bpow radix2 e = s) by (rewrite Mm, Rmult_assoc, <- bpow_plus, Z.add_opp_diag_l; apply Rmult_1_r).
  assert (X : x = m * bpow radix2 (e - b)) by (unfold Z.sub; rewrite bpow_plus, <- Rmult_assoc, Ms; unfold s; rewrite Rmult_assoc, <- bpow_plus, Z.add_opp_diag_r; symmetry; apply Rmult_1_r).
  assert (Bm : 7071067/10000000 <= m <= 14142137/10000000) by (rewrite <- Ms in M, N; clearbody g; split; nra).
  assert (Q : (-1075 <= e - b <= 1025)%Z).
  { assert (E1 := bpow_gt_0 radix2 (e - b)). assert (U : bpow radix2 (e - b) < bpow radix2 (1 + 1024)) by (rewrite (bpow_plus radix2 1); change (bpow radix2 1) with 2; nra). apply lt_bpow in U.
    assert (V : bpow radix2 (-1 + -1074) < bpow radix2 (e - b)) by (rewrite (bpow_plus radix2 (-1)); change (bpow radix2 (-1)) with (/ 2); nra). apply lt_bpow in V. lia. }
  exists (e - b)%Z. split; [|split; [exact Q | split; [apply rounded_is_float64 | split; [exact Bm | exact X]]]].
  unfold natural_logarithm_float64.doublings. rewrite Bi, B, <- minus_IZR. apply kept. replace (IZR (e - b)) with (IZR (e - b) * bpow radix2 0) by apply Rmult_1_r. apply whole_is_float64; lia.
Qed.
End doublings.

Section logarithm.
Variable x : R.
Let m := natural_logarithm_float64.mantissa x.
Let W := natural_logarithm_float64.log_whole x.
Let d := natural_logarithm_float64.node x.
Let v := natural_logarithm_float64.node_short x.
Let r := natural_logarithm_float64.node_rest x.
Hypothesis M : float64 m /\ 7071067/10000000 <= m <= 14142137/10000000.

Lemma node_of_mantissa : Rabs (m - d) <= 589/10000 * (m + d) /\ 79/100 <= d <= 127/100 /\ Rabs (v + r - ln d) <= 1 / 2 ^ 70 /\ Rabs r <= 8/1000000 /\
  (exists k j, d = IZR k * bpow radix2 (-8) /\ v = IZR j * bpow radix2 (-16) /\ (0 <= k <= 400 /\ Z.abs j <= 2 ^ 14)%Z) /\ (d = 1 /\ v = 0 /\ r = 0 \/ 1/5 <= Rabs v <= 24/100 /\ 115/1000 <= Rabs (ln m)).
Proof.
  destruct M as [_ B]. unfold d, v, r, natural_logarithm_float64.node, natural_logarithm_float64.node_short, natural_logarithm_float64.node_rest. fold m.
  destruct Rlt_dec as [C|C]; [|destruct Rlt_dec as [D|D]]; clear d v r M; clearbody m; (split; [apply Rabs_le; lra | split; [lra|]]).
  - split; [interval with (i_prec 120)|]. split; [interval|]. split; [exists 203%Z, (-15202)%Z; simpl bpow; repeat split; lra || lia|]. right. split; [split; interval|]. rewrite Rabs_left by interval. interval.
  - rewrite ln_1, Rplus_0_r, Rminus_0_r, Rabs_R0. split; [lra|]. split; [lra|]. split; [exists 256%Z, 0%Z; simpl bpow; repeat split; lra || lia|]. left. lra.
  - apply Rnot_lt_le in D. split; [interval with (i_prec 120)|]. split; [interval|]. split; [exists 323%Z, 15235%Z; simpl bpow; repeat split; lra || lia|]. right. split; [split; interval|]. rewrite Rabs_pos_eq by interval. interval.
Qed.
Lemma log_whole_exact (n : Z) : natural_logarithm_float64.doublings x = IZR n -> (-1075 <= n <= 1025)%Z ->
  W = 22713/32768 * IZR n + v /\ exists k, W = IZR k * bpow radix2 (-16) /\ (Z.abs k < 2 ^ 26)%Z.
Proof.
  intros D N. destruct node_of_mantissa as (_ & _ & _ & _ & (_ & j & _ & V & _ & J) & _). unfold W, natural_logarithm_float64.log_whole. fold v. rewrite D.
  assert (A : 22713/32768 * IZR n = IZR (45426 * n) * bpow radix2 (-16)) by (rewrite mult_IZR; simpl bpow; lra).
  assert (H : rounded (22713/32768 * IZR n) = 22713/32768 * IZR n) by (apply kept; rewrite A; apply whole_is_float64; lia).
  assert (B : 22713/32768 * IZR n + v = IZR (45426 * n + j) * bpow radix2 (-16)) by (rewrite A, V, plus_IZR; ring).
  rewrite H, (kept (_ + v)) by (rewrite B; apply whole_is_float64; lia). split; [reflexivity|]. exists (45426 * n + j)%Z. split; [exact B | lia].
Qed.
(* The two parts of the quotient of the mantissa less its node by their sum. *)
Let h := natural_logarithm_float64.a_high x.
Let e := natural_logarithm_float64.quotient_rest x.
Let q := (m - d) / (m + d).
Lemma above_node_exact : natural_logarithm_float64.above_node x = m - d /\ (m - d = 0 \/ bpow radix2 (-53) <= Rabs (m - d)).
Proof.
  destruct node_of_mantissa as (_ & Bd & _ & _ & (k & _ & D & _ & K & _) & _). destruct M as [Fm Bm]. fold d in Bd, D.
  destruct (multiple_of_power m (-53) Fm) as [j J]; [rewrite Rabs_pos_eq by lra; apply Rle_trans with (bpow radix2 (-1)); [apply bpow_le; easy | simpl; lra]|].
  assert (A : m - d = IZR (j - k * 2 ^ 45) * bpow radix2 (-53)) by (rewrite J, D, minus_IZR, mult_IZR; change (IZR (2 ^ 45)) with (bpow radix2 45); replace (bpow radix2 (-8)) with (bpow radix2 45 * bpow radix2 (-53)) by (rewrite <- bpow_plus; reflexivity); ring).
  assert (P53 := bpow_gt_0 radix2 (-53)). split.
  - unfold natural_logarithm_float64.above_node. fold m d. apply kept. rewrite A. apply whole_is_float64; [|easy]. apply lt_IZR. rewrite abs_IZR. apply Rmult_lt_reg_r with (bpow radix2 (-53)); [exact P53|].
    rewrite <- (Rabs_pos_eq (bpow radix2 (-53))) at 1 by lra. rewrite <- Rabs_mult, <- A. change (IZR (2 ^ 53)) with (bpow radix2 53). rewrite <- bpow_plus. change (bpow radix2 (53 + -53)) with 1. apply Rabs_lt. lra.
  - rewrite A. destruct (Z.eq_dec (j - k * 2 ^ 45) 0) as [-> | Z]; [left; ring | right]. rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)), <- abs_IZR by lra.
    rewrite <- (Rmult_1_l (bpow radix2 (-53))) at 1. apply Rmult_le_compat_r; [lra|]. apply IZR_le. lia.
Qed.
Lemma quotient_in_two : generic_format radix2 (FLT_exp (-1074) 26) h /\ (h = 0 \/ bpow radix2 (-56) <= Rabs h) /\ Rabs (h - q) <= 101/100 / 2 ^ 26 * Rabs q + 3 * least_float64 /\ Rabs (e - (q - h)) <= 20 / 2 ^ 79 * Rabs q + 60 * least_float64 /\ Rabs q <= 589/10000.
Proof.
  destruct node_of_mantissa as (Bq & Bd & _ & _ & (k & _ & D & _ & K & _) & _). destruct above_node_exact as [A A0]. destruct M as [Fm Bm]. fold m d in Bq, Bd, D.
  assert (Fd : float64 d) by (rewrite D; apply whole_is_float64; lia). set (S := m + d) in *. assert (BS : 1497/1000 <= S <= 26843/10000) by (unfold S; lra).
  assert (T0 : 0 <= least_float64 <= 1 / 2 ^ 100) by apply underflow_is_less. set (I := natural_logarithm_float64.inverse x).
  assert (EI : Rabs (I - 1 / S) <= 203/100 / 2 ^ 53).
  { unfold I, natural_logarithm_float64.inverse. fold m d. destruct (sum_float64 m d Fm Fd) as (t & B & ->). fold S. assert (X := quotient_error 1 S 0 t (672/1000) ltac:(lra)).
    rewrite Rplus_0_r, Rmult_1_r in X. eapply Rle_trans; [apply X|lra]; [clear - BS; clearbody S; interval | lra | rewrite Rabs_R0; unfold unit_roundoff; simpl; lra | exact B]. }
  assert (ES : Rabs (S * I - 1) <= 55/10 / 2 ^ 53).
  { replace (S * I - 1) with (S * (I - 1 / S)) by (field; lra). eapply Rle_trans; [apply bounded_product; [apply Rabs_le with (1 := conj (ltac:(lra) : - (26843/10000) <= S) (proj2 BS)) | exact EI] | lra]. }
  assert (qS : m - d = q * S) by (unfold q; fold S; field; lra). assert (Q : Rabs q <= 589/10000).
  { apply Rmult_le_reg_r with S; [lra|]. rewrite <- (Rabs_pos_eq S) at 1 by lra. rewrite <- Rabs_mult, <- qS. exact Bq. }
  assert (Q0 := Rabs_pos q). set (a := natural_logarithm_float64.a x). assert (Ea : Rabs (a - q) <= 66/10 / 2 ^ 53 * Rabs q + least_float64).
  { assert (X : Rabs ((m - d) * I - q) <= Rabs q * (55/10 / 2 ^ 53)) by (rewrite qS; replace (q * S * I - q) with (q * (S * I - 1)) by ring; apply bounded_product; [apply Rle_refl | exact ES]).
    unfold a, natural_logarithm_float64.a. rewrite A. fold I. generalize (through _ _ _ _ _ (within_rounding _ _ (size _ _ _ _ (Rle_refl (Rabs q)) X)) X). lra. }
  destruct (high_part a) as [Fh Eh]; [apply rounded_is_float64|]. change (generic_format radix2 (FLT_exp (-1074) 26) h) in Fh. change (Rabs (h - a) <= / 2 ^ 26 * Rabs a + least_float64) in Eh.
  assert (Eq : Rabs (h - q) <= 101/100 / 2 ^ 26 * Rabs q + 3 * least_float64).
  { generalize (through _ _ _ _ _ Eh Ea) (size _ _ _ _ (Rle_refl (Rabs q)) Ea). lra. }
  assert (h0 : h = 0 \/ bpow radix2 (-56) <= Rabs h).
  { destruct A0 as [Z|Z].
    - left. assert (a0 : a = 0) by (unfold a, natural_logarithm_float64.a; rewrite A, Z, Rmult_0_l; apply rounded_0).
      unfold h, natural_logarithm_float64.a_high, natural_logarithm_float64.a_excess, natural_logarithm_float64.a_split. fold a. rewrite a0, Rmult_0_r, !rounded_0, Rminus_0_r, !rounded_0, Rminus_0_r. apply rounded_0.
    - right. rewrite qS, Rabs_mult, (Rabs_pos_eq S) in Z by lra. assert (Rabs q <= Rabs h + Rabs (h - q)) by (generalize (Rabs_triang_inv q h); rewrite (Rabs_minus_sym q h); lra).
      assert (U : 1000 * least_float64 <= bpow radix2 (-53)) by (apply Rle_trans with (bpow radix2 10 * least_float64); [simpl (bpow radix2 10); lra | unfold least_float64; rewrite <- bpow_plus; apply bpow_le; easy]).
      replace (bpow radix2 (-53)) with (8 * bpow radix2 (-56)) in Z, U by (simpl; lra). assert (B56 := bpow_gt_0 radix2 (-56)). nra. }
  split; [exact Fh | split; [exact h0 | split; [exact Eq | split; [|exact Q]]]].
  set (l := natural_logarithm_float64.lifted x). assert (El : Rabs (l - (m + 134217728)) <= 1001/1000 / 2 ^ 26).
  { assert (B : Rabs (m + 134217728) <= 134217730) by (apply Rabs_le; lra). eapply Rle_trans; [exact (rounded_error _ _ B) | lra]. }
  destruct (multiple_of_power l (-25)) as [i L]; [apply rounded_is_float64 | change (bpow radix2 (-25 + 52)) with 134217728; rewrite Rabs_pos_eq; by_sides|].
  set (p := natural_logarithm_float64.mantissa_short x). assert (Lp : l - 134217728 = IZR (i - 2 ^ 52) * bpow radix2 (-25)) by (rewrite L, minus_IZR; simpl bpow; lra).
  assert (Ip : (Z.abs (i - 2 ^ 52) < 2 ^ 26)%Z) by (apply (units_below _ (-25)); [easy|]; rewrite <- Lp; apply Rabs_lt; simpl bpow; by_sides).
  assert (Pl : p = l - 134217728) by (unfold p, natural_logarithm_float64.mantissa_short; fold l; apply kept; rewrite Lp; apply whole_is_float64; lia).
  assert (Ps : p + d = IZR (i - 2 ^ 52 + k * 2 ^ 17) * bpow radix2 (-25)) by (rewrite Pl, Lp, D, plus_IZR, mult_IZR; simpl bpow; lra).
  assert (Ss : natural_logarithm_float64.sum_short x = p + d) by (unfold natural_logarithm_float64.sum_short; fold p d; apply kept; rewrite Ps; apply whole_is_float64; lia).
  assert (H1 : rounded (h * natural_logarithm_float64.sum_short x) = h * (p + d)).
  { rewrite Ss. apply kept. rewrite Ps. apply short_product; [exact Fh | lia |]. destruct h0 as [h0 | h0]; [left; exact h0 | right; right]. rewrite <- Ps, Rabs_mult. apply Rle_trans with (bpow radix2 (-56) * 1); [rewrite Rmult_1_r; apply bpow_le; easy|].
    apply Rmult_le_compat; [apply bpow_ge_0 | lra | exact h0 | rewrite Rabs_pos_eq; rewrite Pl; by_sides]. }
  assert (Em : Rabs (m - p) <= 1001/1000 / 2 ^ 26) by (rewrite Pl; replace (m - (l - 134217728)) with (- (l - (m + 134217728))) by ring; rewrite Rabs_Ropp; exact El).
  assert (Er := within_rounding _ _ Em). change (rounded (m - p)) with (natural_logarithm_float64.mantissa_rest x) in Er. set (mr := natural_logarithm_float64.mantissa_rest x) in *.
  assert (Bh : Rabs h <= 101/100 * Rabs q + 3 * least_float64) by (generalize (size _ _ _ _ (Rle_refl (Rabs q)) Eq); lra).
  assert (X1 : Rabs ((h - q) * S) <= 272/100 / 2 ^ 26 * Rabs q + 9 * least_float64) by (eapply Rle_trans; [apply bounded_product; [exact Eq | apply Rabs_le with (1 := conj (ltac:(lra) : - (26843/10000) <= S) (proj2 BS))] | lra]).
  assert (X2 : Rabs (h * (m - p)) <= 102/100 / 2 ^ 26 * Rabs q + least_float64) by (eapply Rle_trans; [exact (bounded_product _ _ _ _ Bh Em) | lra]).
  assert (X3 : Rabs (h * (mr - (m - p))) <= 2 / 2 ^ 79 * Rabs q + 3 * least_float64) by (eapply Rle_trans; [apply (bounded_product _ _ _ (11/10 / 2 ^ 79) Bh); lra | lra]).
  set (un := natural_logarithm_float64.undivided_near x). assert (E1 : Rabs (un - ((q - h) * S + h * (m - p))) <= 4 / 2 ^ 79 * Rabs q + 3 * least_float64).
  { unfold un, natural_logarithm_float64.undivided_near. fold h. rewrite H1, A, qS. replace (q * S - h * (p + d)) with ((q - h) * S + h * (m - p)) by (unfold S; ring). eapply Rle_trans; [apply within_rounding with (X := 4 / 2 ^ 26 * Rabs q + 11 * least_float64); by_sides | lra]. }
  set (b := rounded (h * mr)). assert (E2 : Rabs (b - h * (m - p)) <= 4 / 2 ^ 79 * Rabs q + 6 * least_float64).
  { assert (B : Rabs (h * mr) <= 104/100 / 2 ^ 26 * Rabs q + 4 * least_float64) by (replace (h * mr) with (h * (m - p) + h * (mr - (m - p))) by ring; by_sides). assert (Y := within_rounding _ _ B). fold b in Y. replace (h * (mr - (m - p))) with (h * mr - h * (m - p)) in X3 by ring. by_sides. }
  set (U := natural_logarithm_float64.undivided x). assert (E3 : Rabs (U - (q - h) * S) <= 12 / 2 ^ 79 * Rabs q + 30 * least_float64).
  { assert (B : Rabs (un - b) <= 3 / 2 ^ 26 * Rabs q + 20 * least_float64) by by_sides. assert (Y := within_rounding _ _ B). change (rounded (un - b)) with U in Y. by_sides. }
  assert (E4 : Rabs (I * (U - (q - h) * S)) <= 9 / 2 ^ 79 * Rabs q + 22 * least_float64).
  { eapply Rle_trans; [apply bounded_product; [|exact E3]|]. apply Rle_trans with (7/10); [|apply Rle_refl]. 2: lra. assert (Rabs (1 / S) <= 67/100) by (clear - BS; clearbody S; interval). by_sides. }
  assert (E5 : Rabs ((q - h) * (S * I - 1)) <= 6 / 2 ^ 79 * Rabs q + least_float64) by (rewrite Rabs_minus_sym in Eq; eapply Rle_trans; [exact (bounded_product _ _ _ _ Eq ES) | lra]).
  assert (B : Rabs (I * U) <= 102/100 / 2 ^ 26 * Rabs q + 30 * least_float64).
  { replace (I * U) with (I * (U - (q - h) * S) + (q - h) * (S * I - 1) + (q - h)) by ring. by_sides. }
  assert (Y := within_rounding _ _ B). change (rounded (I * U)) with e in Y. replace (I * U) with (I * (U - (q - h) * S) + (q - h) * (S * I - 1) + (q - h)) in Y by ring. by_sides.
Qed.
Lemma quotient_logarithm : ln (1 + q) - ln (1 - q) = ln m - ln d.
Proof.
  destruct node_of_mantissa as (_ & Bd & _). destruct M as [_ Bm]. assert (S : 0 < 2 / (m + d)) by (apply Rdiv_lt_0_compat; lra).
  replace (1 + q) with (m * (2 / (m + d))) by (unfold q; field; lra). replace (1 - q) with (d * (2 / (m + d))) by (unfold q; field; lra). rewrite !ln_mult by lra. ring.
Qed.
Lemma tail_near : Rabs q <= 589/10000 -> Rabs (e - (q - h)) <= 20 / 2 ^ 79 * Rabs q + 60 * least_float64 ->
  Rabs (natural_logarithm_float64.log_tail x - logarithm_polynomial.log_tail q) <= 171/10000 / 2 ^ 53 * Rabs q + 10 * least_float64 /\ Rabs (logarithm_polynomial.log_tail q) <= 24/10000 * Rabs q.
Proof.
  intros Q E. assert (Q0 := Rabs_pos q). assert (T0 : 0 <= least_float64 <= 1 / 2 ^ 100) by apply underflow_is_less. unfold natural_logarithm_float64.log_tail. set (p := natural_logarithm_float64.quotient x).
  assert (Ep : Rabs (p - q) <= 101/100 / 2 ^ 53 * Rabs q + 62 * least_float64).
  { assert (E' : Rabs (h + e - q) <= 20 / 2 ^ 79 * Rabs q + 60 * least_float64) by (replace (h + e - q) with (e - (q - h)) by ring; exact E).
    generalize (through _ _ _ _ _ (within_rounding _ _ (size _ _ _ _ (Rle_refl (Rabs q)) E')) E'). change (rounded (h + e)) with p. lra. }
  assert (Ep' : Rabs (p - q) <= 595/10000 / 2 ^ 53) by lra. set (z := logarithm_polynomial.quotient_squared q). set (zh := natural_logarithm_float64.quotient_squared x).
  assert (Z : 0 <= z <= 347/100000) by (clear - Q; apply Rabs_le_between in Q; clearbody q; unfold z, logarithm_polynomial.quotient_squared; split; [apply pow2_ge_0 | interval]).
  assert (Ez : Rabs (zh - z) <= 106/10000 / 2 ^ 53) by (unfold z, logarithm_polynomial.quotient_squared; replace (q ^ 2) with (q * q) by ring; eapply Rle_trans; [exact (times_error _ _ _ _ _ _ _ _ Q Q Ep' Ep') | lra]).
  assert (E1 : Rabs (rounded (p * zh) - q * z) <= 18/1000 / 2 ^ 53 * Rabs q + 3 * least_float64).
  { assert (X : Rabs (p * zh - q * z) <= 143/10000 / 2 ^ 53 * Rabs q + least_float64).
    { assert (Bz : Rabs zh <= 348/100000) by by_sides. replace (p * zh - q * z) with ((p - q) * zh + q * (zh - z)) by ring. generalize (bounded_product _ _ _ _ Ep Bz) (bounded_product _ _ _ _ (Rle_refl (Rabs q)) Ez). intros. by_sides. }
    assert (B : Rabs (q * z) <= Rabs q * (347/100000)) by (apply bounded_product; [apply Rle_refl | apply Rabs_le; lra]). generalize (through _ _ _ _ _ (within_rounding _ _ (size _ _ _ _ B X)) X). lra. }
  unfold logarithm_polynomial.log_tail. fold z. lazymatch goal with |- context [rounded (rounded (p * zh) * ?f)] => set (F := f) end. lazymatch goal with |- context [q * z * ?f] => set (G := f) end.
  assert (Bg : 66/100 <= G <= 669/1000) by (unfold G; clearbody z; clear - Z; split; interval).
  assert (Ef : Rabs (F - G) <= 7/10 / 2 ^ 53) by (unfold F, G; clearbody z zh; clear - Z Ez; eapply Rle_trans; [find_error | interval]).
  assert (B : Rabs (q * z) <= Rabs q * (347/100000)) by (apply bounded_product; [apply Rle_refl | apply Rabs_le; lra]). assert (Bf : Rabs F <= 67/100) by by_sides.
  assert (X : Rabs (rounded (p * zh) * F - q * z * G) <= 146/10000 / 2 ^ 53 * Rabs q + 3 * least_float64).
  { set (w := rounded _) in *. replace (w * F - q * z * G) with ((w - q * z) * F + q * z * (F - G)) by ring. generalize (bounded_product _ _ _ _ E1 Bf) (bounded_product _ _ _ _ B Ef). intros. by_sides. }
  assert (Bt : Rabs (q * z * G) <= 24/10000 * Rabs q) by (eapply Rle_trans; [apply (bounded_product _ _ _ (669/1000) B); apply Rabs_le; lra | lra]).
  split; [|exact Bt]. generalize (through _ _ _ _ _ (within_rounding _ _ (size _ _ _ _ Bt X)) X). lra.
Qed.
Section parts.
Variable n : Z.
Hypothesis D : natural_logarithm_float64.doublings x = IZR n /\ (-1075 <= n <= 1025)%Z.
Let y := IZR n * ln 2 + ln m.
Let N := Rabs (IZR n).
Lemma by_doublings : n = 0%Z /\ d = 1 /\ v = 0 /\ r = 0 \/ 115/1000 + N / 5 <= Rabs y /\ 1/5 <= Rabs W.
Proof.
  destruct node_of_mantissa as (_ & _ & _ & _ & _ & C). destruct (log_whole_exact n (proj1 D) (proj2 D)) as [H _]. fold m in C. destruct M as [_ Bm].
  assert (Y : Rabs (ln m) <= 3466/10000) by (clear - Bm; clearbody m; interval). assert (L : 693/1000 <= ln 2 <= 694/1000) by (split; interval). unfold y, N. destruct (Z.eq_dec n 0) as [Z | Z].
  - rewrite Z in *. destruct C as [C | [C C']]; [left; split; [reflexivity | exact C] | right]. rewrite H, Rmult_0_l, Rmult_0_r, Rplus_0_l, Rabs_R0, Rplus_0_l. split; lra.
  - right. assert (O : 1 <= Rabs (IZR n)) by (rewrite <- abs_IZR; apply IZR_le; lia). assert (V : Rabs v <= 24/100) by (destruct C as [(_ & -> & _) | C]; [rewrite Rabs_R0|]; lra).
    rewrite H. clear - Y L O V. clearbody m v. split; unfold Rabs in *; repeat destruct Rcase_abs; nra.
Qed.
Lemma logarithm_in_three : natural_logarithm_float64.log_quotient x = 2 * h /\ (W = 0 \/ Rabs (2 * h) <= Rabs W) /\
  Rabs (natural_logarithm_float64.log_rest x) <= 14/10000 * Rabs y + 400 * least_float64 /\ Rabs (W + 2 * h + natural_logarithm_float64.log_rest x - y) <= 19/1000 / 2 ^ 53 * Rabs y + 400 * least_float64.
Proof.
  destruct quotient_in_two as (_ & _ & Eh & Ee & Q).  destruct (tail_near Q Ee) as [Et Bt]. 
  assert (Es := series_relative q ltac:(lra)). rewrite quotient_logarithm in Es.
  destruct node_of_mantissa as (_ & _ & Ev & Br & _). destruct (log_whole_exact n (proj1 D) (proj2 D)) as [HW _].  assert (Q0 := Rabs_pos q). assert (N0 := Rabs_pos (IZR n)). assert (r0 := Rabs_pos r). fold N in N0.
  assert (T0 : 0 <= least_float64 <= 1 / 2 ^ 100) by apply underflow_is_less. set (t := natural_logarithm_float64.log_tail x) in *. set (s := logarithm_polynomial.log_tail q) in *.
  assert (H2 : natural_logarithm_float64.log_quotient x = 2 * h).
  { unfold natural_logarithm_float64.log_quotient. fold h. apply kept. rewrite Rmult_comm. change 2 with (bpow radix2 1). apply mult_bpow_pos_exact_FLT; [apply rounded_is_float64 | easy]. }
  split; [exact H2|]. set (L := 3373202482714085 / 2361183241434822606848).
  assert (Nn : Rabs (IZR n) <= N) by apply Rle_refl. assert (BL : Rabs L <= 1429/1000000000) by (unfold L; interval).
  assert (Bw := bounded_product _ _ _ _ BL Nn). assert (Ew := within_rounding _ _ Bw).
  assert (EL : Rabs ((22713/32768 + L - ln 2) * IZR n) <= 1 / 2 ^ 72 * N) by (apply bounded_product; [unfold L; interval with (i_prec 120) | exact Nn]).
  set (w := natural_logarithm_float64.log_whole_rest x). assert (Ew2 : Rabs (w - (L * IZR n + r)) <= (3 / 1000000 * N + 101/100 * Rabs r) / 2 ^ 53 + 3 * least_float64).
  { unfold w, natural_logarithm_float64.log_whole_rest. fold L r. rewrite (proj1 D). set (a := rounded _) in *. assert (B : Rabs (a + r) <= 1430/1000000000 * N + Rabs r + least_float64) by (eapply Rle_trans; [apply Rabs_triang|]; generalize (size _ _ _ _ Bw Ew); lra).
    assert (X : Rabs (a + r - (L * IZR n + r)) <= / 2 ^ 53 * (1429/1000000000 * N) + least_float64) by (replace (_ - _) with (a - L * IZR n) by ring; exact Ew). generalize (through _ _ _ _ _ (within_rounding _ _ B) X). lra. }
  assert (Bw2 : Rabs w <= 1430/1000000000 * N + 101/100 * Rabs r + 3 * least_float64).
  { assert (B : Rabs (L * IZR n + r) <= 1429/1000000000 * N + Rabs r) by (eapply Rle_trans; [apply Rabs_triang | lra]). generalize (size _ _ _ _ B Ew2). lra. }
  assert (Be : Rabs (2 * e) <= 21/10 / 2 ^ 26 * Rabs q + 150 * least_float64) by by_sides. assert (E2 := within_rounding _ _ Be). set (e2 := rounded (2 * e)) in *.
  assert (Btw : Rabs (t + w) <= 241/100000 * Rabs q + 1430/1000000000 * N + 101/100 * Rabs r + 20 * least_float64) by by_sides. assert (E3 := within_rounding _ _ Btw). set (tw := rounded (t + w)) in *.
  assert (Bs : Rabs (tw + e2) <= 242/100000 * Rabs q + 1431/1000000000 * N + 102/100 * Rabs r + 200 * least_float64) by by_sides. assert (E4 := within_rounding _ _ Bs). change (rounded (tw + e2)) with (natural_logarithm_float64.log_rest x) in E4. set (R := natural_logarithm_float64.log_rest x) in *.
  assert (BR : Rabs R <= 243/100000 * Rabs q + 1432/1000000000 * N + 103/100 * Rabs r + 210 * least_float64) by by_sides.
  assert (G : Rabs (W + 2 * h + R - y) <= (361/10000 * Rabs q + 8/1000000 * N + 4 * Rabs r) / 2 ^ 53 + Rabs (v + r - ln d) + 400 * least_float64).
  { replace (W + 2 * h + R - y) with ((22713/32768 + L - ln 2) * IZR n + (v + r - ln d) + (2 * q + s - (ln m - ln d)) + (R - (tw + e2)) + (tw - (t + w)) + (e2 - 2 * e) + (t - s) + (w - (L * IZR n + r)) + 2 * (e - (q - h))) by (rewrite HW; unfold y; ring).
    clear - EL Es Et Ew2 E2 E3 E4 Ee T0 Q0 N0 r0. clearbody R tw e2 t s w h e q L v r N. generalize (Rle_abs (v + r - ln d)) (Rle_abs (- (v + r - ln d))). rewrite Rabs_Ropp. intros. by_sides. }
  assert (Y := Rabs_pos y). destruct by_doublings as [(n0 & d1 & v0 & z0) | [By BW]].
  - split; [left; rewrite HW, n0, v0; ring|]. rewrite v0, z0, d1, ln_1, Rplus_0_r, Rminus_0_r, Rabs_R0 in *. assert (N1 : N = 0) by (unfold N; rewrite n0; apply Rabs_R0). rewrite N1 in *.
    assert (K : 1995/1000 * Rabs q <= Rabs y).
    { unfold y. rewrite n0, Rmult_0_l, Rplus_0_l. assert (Z := Rabs_triang_inv (2 * q) (2 * q - ln m)). replace (2 * q - (2 * q - ln m)) with (ln m) in Z by ring. rewrite Rabs_mult, (Rabs_pos_eq 2) in Z by lra.
      assert (Rabs (2 * q - ln m) <= 3/1000 * Rabs q) by (replace (2 * q - ln m) with (2 * q + s - ln m - s) by ring; by_sides). lra. }
    split; lra.
  - split; [right; rewrite Rabs_mult, (Rabs_pos_eq 2) by lra; generalize (size _ _ _ _ (Rle_refl (Rabs q)) Eh); lra|]. split; lra.
Qed.
End parts.
End logarithm.

Lemma ln_of_doublings (x : R) (n : Z) : 0 < natural_logarithm_float64.mantissa x -> x = natural_logarithm_float64.mantissa x * bpow radix2 n -> ln x = IZR n * ln 2 + ln (natural_logarithm_float64.mantissa x).
Proof. intros P E. rewrite E at 1. rewrite ln_mult, (bpow_exp radix2 n), ln_exp by (exact P || apply bpow_gt_0). apply Rplus_comm. Qed.


(* What is added in two operations, the sum and what it loses, is the sum where the first is not the smaller, or 0. *)
Lemma sum_in_two (a b : R) : float64 a -> float64 b -> a = 0 \/ Rabs b <= Rabs a -> rounded (b + a) + rounded (rounded (a - rounded (b + a)) + b) = a + b.
Proof.
  intros A B [-> | S].
  - rewrite Rplus_0_r, (kept b B), Rminus_0_l, (kept (- b) (generic_format_opp _ _ _ B)). rewrite Rplus_opp_l, rounded_0. ring.
  - rewrite (Rplus_comm b a), (Rplus_comm (rounded _) b). apply (Fast2Sum_correct (-1074) 53 (fun n => negb (Z.even n))); [easy | easy | | exact A | exact B | exact S].
    intro n. rewrite Z.even_opp, Z.even_add. destruct (Z.even n); reflexivity.
Qed.
(* The logarithm of a float64 above 0 is within 41/40 2^-53 of its logarithm, relative to that, and 2^-1060. *)
Theorem elementary_functions__log (x : R) : float64 x -> 0 < x <= IZR (2 ^ 1024 - 2 ^ 971) ->
  Rabs (natural_logarithm_float64.logarithm x - ln x) <= 41/40 * (1 / 2 ^ 53) * Rabs (ln x) + bpow radix2 (-1060).
Proof.
  intros F [P L]. assert (U : x < bpow radix2 1024) by (eapply Rle_lt_trans; [exact L | change (bpow radix2 1024) with (IZR (2 ^ 1024)); apply IZR_lt; easy]).
  destruct (doublings_and_mantissa x F (conj P U)) as (n & D & N & Fm & Bm & X). destruct (logarithm_in_three x (conj Fm Bm) n (conj D N)) as (H & S & BR & E).
  rewrite <- (ln_of_doublings x n ltac:(lra) X) in BR, E.
  unfold natural_logarithm_float64.logarithm. destruct both as [_ | [C | C]]; [|destruct C; exact L | destruct C; exact P]. clear L U F.
  assert (T : 0 <= least_float64 <= 1 / 2 ^ 100) by apply underflow_is_less. assert (B : 10000 * least_float64 <= bpow radix2 (-1060)) by (apply Rle_trans with (bpow radix2 14 * least_float64); [simpl; lra | unfold least_float64; rewrite <- bpow_plus; apply bpow_le; easy]).
  rewrite <- H in S, E. set (w := natural_logarithm_float64.log_whole x) in *. set (q := natural_logarithm_float64.log_quotient x) in *. set (r := natural_logarithm_float64.log_rest x) in *.
  assert (Q := sum_in_two w q ltac:(apply rounded_is_float64) ltac:(apply rounded_is_float64) S). set (c := rounded (rounded _ + q)) in Q.
  unfold natural_logarithm_float64.log_near, natural_logarithm_float64.log_low. change (natural_logarithm_float64.log_sum_rest x) with c. change (natural_logarithm_float64.log_sum x) with (rounded (q + w)). fold r.
  assert (Y := Rabs_pos (ln x)). set (y := ln x) in *. clearbody y r w q c.
  assert (Bs : Rabs (q + w) <= 1002/1000 * Rabs y + 900 * least_float64).
  { replace (q + w) with (w + q + r - y + y - r) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. generalize (Rabs_triang (w + q + r - y) y). lra. }
  assert (Es := within_rounding _ _ Bs). set (s := rounded (q + w)) in *. clearbody s.
  assert (Bl : Rabs (r + c) <= 15/10000 * Rabs y + 1400 * least_float64) by (replace c with (q + w - s) by lra; by_sides). assert (El := within_rounding _ _ Bl). set (l := rounded (r + c)) in *. clearbody l.
  assert (El' : Rabs (l + s - y) <= 205/10000 / 2 ^ 53 * Rabs y + 1000 * least_float64) by (replace (l + s - y) with (l - (r + c) + (w + q + r - y)) by lra; by_sides).
  generalize (through _ _ _ _ _ (within_rounding _ _ (size _ _ _ _ (Rle_refl (Rabs y)) El')) El'). lra.
Qed.
Theorem elementary_functions__log__point : exists x : R, float64 x /\ 0 < x <= IZR (2 ^ 1024 - 2 ^ 971).
Proof. exists 1. split; [exact one_is_float64 | split; [lra | apply IZR_le; easy]]. Qed.
(* It is not so near its tangent at 1. *)
Theorem elementary_functions__log__false : ~ forall x, float64 x -> 0 < x <= IZR (2 ^ 1024 - 2 ^ 971) ->
  Rabs (natural_logarithm_float64.logarithm x - (x - 1)) <= 41/40 * (1 / 2 ^ 53) * Rabs (x - 1) + bpow radix2 (-1060).
Proof.
  intro H. assert (F : float64 2) by (apply (generic_format_bpow radix2 (FLT_exp (-1074) 53) 1); easy). assert (P : 0 < 2 <= IZR (2 ^ 1024 - 2 ^ 971)) by (split; [lra | apply IZR_le; easy]).
  generalize (H 2 F P) (elementary_functions__log 2 F P). assert (T : bpow radix2 (-1060) <= bpow radix2 (-10)) by (apply bpow_le; easy). change (bpow radix2 (-10)) with (/ 1024) in T.
  assert (L : 69/100 <= ln 2 <= 7/10) by (split; interval). replace (2 - 1) with 1 by ring. rewrite Rabs_R1, (Rabs_pos_eq (ln 2)) by lra. clear H. intros. by_sides.
Qed.
