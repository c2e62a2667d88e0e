(* The kernels' logarithm as float64 carries it out: doublings and mantissa, node, quotient in two parts, series. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Relative Mult_error Pff2Flocq.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Float Float64 RoundedHalfTurns Rounding RoundedGradient RoundedAngle.
Open Scope R_scope.

(* Twice the quotient and the series are within 13/1000 2^-53 of its logarithm, relative to the quotient. *)
Lemma series_relative q : Rabs q <= 589/10000 -> Rabs (2 * q + logarithm_polynomial.log_tail q - (ln (1 + q) - ln (1 - q))) <= 13/1000 / 2 ^ 53 *
  Rabs q.
Proof.
  intro B. set (g := fun t => 2 * t + logarithm_polynomial.log_tail t - (ln (1 + t) - ln (1 - t))). change (Rabs (g q) <= 13/1000 / 2 ^ 53 * Rabs q).
    destruct (Rle_lt_dec (3/64) (Rabs q)) as [L|L].
  - apply Rle_trans with (13/1000 / 2 ^ 53 * (3/64)); [|lra]. both_ways B. unfold g; logarithm_polynomial.lines.
    unfold Rabs in L; destruct Rcase_abs in L; [assert (- (59/1000) <= q <= - (3/64)) by lra | assert (3/64 <= q <= 59/1000) by lra]; interval with
      (i_taylor q, i_degree 20, i_prec 120).
  - evar (h : R -> R). apply (at_most_times g h _ (3/64)); [unfold g; logarithm_polynomial.lines; rewrite Rplus_0_r, Rminus_0_r; ring | intros t T; split
      | apply Rabs_le_between; lra].
    + unfold g; logarithm_polynomial.lines. auto_derive; [lra|]. unfold h. reflexivity.
    + unfold h. clear - T. interval with (i_taylor t, i_degree 20, i_prec 120).
Qed.

(* A rounding to so many digits, relative to a number that is not negligible. *)
Definition negligible := bpow radix2 (-900).
Lemma underflow_is_negligible : bpow radix2 (-1074) <= / 2 ^ 100 * negligible.
Proof. replace (/ 2 ^ 100) with (bpow radix2 (-100)) by (simpl; lra). unfold negligible. rewrite <- bpow_plus. apply bpow_le. easy. Qed.
Lemma relative digits b x y : (0 < digits)%Z -> negligible <= b -> y = round radix2 (FLT_exp (-1074) digits) ZnearestE
  x -> exists d t, Rabs d <= bpow radix2 (- digits) /\ Rabs t <= / 2 ^ 100 /\ y = x * (1 + d) + b * t.
Proof.
  intros P B ->. pose proof bpow_gt_0 radix2 (-900) as B0. fold negligible in B0. destruct (error_N_FLT radix2 (-1074) digits P (fun n => negb (Z.even n))
    x) as (d & t & D & T & _ & E). exists d, (t / b). split; [|split].
  - at_most_by D. unfold u_ro. rewrite bpow_plus. simpl (bpow _ 1). lra.
  - apply over_length; [lra|]. at_most_by T. generalize underflow_is_negligible (bpow_gt_0 radix2 (-1074)). lra.
  - rewrite E. field. lra.
Qed.
(* A sum of two needs no such number. *)
Lemma sum_within f g X : float64 f -> float64 g -> Rabs (f + g) <= X -> Rabs (rounded (f + g) - (f + g)) <= / 2 ^ 53 * X.
Proof.
  intros F G B. destruct (rounded_sum f g F G) as (u & U & ->). replace (_ * _ - _) with (u * (f + g)) by ring. apply bounded_product; assumption.
Qed.
(* The sum of two roundings, named s, whose size is at most X. *)
Ltac float_is := first [apply rounded_is_float64 | apply generic_format_opp, rounded_is_float64].
Ltac added s f g X := assert (Rabs (f + g) <= X) by by_sides; let E := fresh in
  pose proof sum_within f g X ltac:(float_is) ltac:(float_is) ltac:(assumption) as E; change (rounded (f + g)) with s in E.
(* The part of 26 digits, which is split off by a multiplication. *)
Lemma high_part x : float64 x -> let h := rounded (rounded (134217729 * x) - rounded (rounded (134217729 * x) - x)) in h = round radix2 (FLT_exp (-1074)
  26) ZnearestE x /\ generic_format radix2 (FLT_exp (-1074) 26) h.
Proof.
  intros F h. assert (G : Prec_gt_0 26) by easy. pose proof Veltkamp_Even radix2 (-1074) 53 (fun n => negb (Z.even n)) 27 ltac:(easy) ltac:(easy) ltac:(easy)
    ltac:(easy) x F eq_refl as H.
  change (round radix2 (FLT_exp (-1074) 53) ZnearestE) with rounded in H. replace (bpow radix2 27 + 1) with 134217729 in H
    by (simpl; lra).
  rewrite (Rmult_comm x), Rplus_comm in H. rewrite <- (Ropp_involutive (rounded (x - _))), <- rounded_opp, Ropp_minus_distr in H. rewrite (H : h = _).
  split; [reflexivity | apply generic_format_round; typeclasses eauto].
Qed.
(* Its product with a number of 27 digits is exact. *)
Lemma short_product h k e : generic_format radix2 (FLT_exp (-1074) 26) h -> (Z.abs k <= 2 ^ 27)%Z -> h * (IZR k * bpow radix2 e) = 0 \/ bpow
  radix2 (-1022) <= Rabs (h * (IZR k * bpow radix2 e)) -> float64 (h * (IZR k * bpow radix2 e)).
Proof.
  intros F K [-> | L]; [apply generic_format_0|].
  apply generic_format_FLT_FLX; [exact L|]. apply generic_format_FLX_FLT, FLX_format_generic in F; [|easy]. destruct F as [[n j] E N]. cbn [Fnum] in N.
  apply generic_format_FLX. exists (Float radix2 (n * k) (j + e)); [|cbn [Fnum]; change (radix_val radix2 ^ 26)%Z with (2 ^ 26)%Z in N; rewrite
    Z.abs_mul; apply Z.le_lt_trans with (Z.abs n * 2 ^ 27)%Z; [apply Z.mul_le_mono_nonneg_l; lia | change (radix_val radix2 ^ 53)%Z with (2 ^ 26 * 2 ^
    27)%Z; lia]].
  rewrite E. unfold F2R. cbn [Fnum Fexp]. rewrite mult_IZR, bpow_plus. ring.
Qed.
Lemma units_below z e k : (0 <= k)%Z -> Rabs (IZR z * bpow radix2 e) < bpow radix2 (k + e) -> (Z.abs z < 2 ^ k)%Z.
Proof.
  intros K B. apply lt_IZR. rewrite abs_IZR, (IZR_Zpower radix2) by exact K. apply Rmult_lt_reg_r with (bpow radix2 e); [apply bpow_gt_0|].
  rewrite <- bpow_plus. rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)) in B by apply bpow_ge_0. exact B.
Qed.
Lemma no_part z e : IZR z * bpow radix2 e = 0 \/ bpow radix2 e <= Rabs (IZR z * bpow radix2 e).
Proof.
  destruct (Z.eq_dec z 0) as [-> | Z]; [left; ring | right]. pose proof bpow_gt_0 radix2 e as P. rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)), <- abs_IZR
    by lra. assert (1 <= IZR (Z.abs z)) by (apply IZR_le; lia). nra.
Qed.
Lemma at_the_scale_of b u U : 0 < b -> Rabs u <= U -> Rabs (u * b) <= U * b.
Proof. intros. apply bounded_product; [assumption | rewrite Rabs_pos_eq; lra]. Qed.

Section doublings.
Variable x : R.
Hypothesis F : float64 x.
Hypothesis P : 0 < x < bpow radix2 1024.
Let m := natural_logarithm_float64.mantissa x.
(* The mantissa and the doublings are exact. *)
Lemma doublings_and_mantissa : exists n : Z, natural_logarithm_float64.doublings x = IZR n /\ (-1075 <= n <= 1025)%Z /\ float64 m /\ 7071067/10000000
  <= m <= 14142137/10000000 /\ ln x = IZR n * ln 2 + ln m.
Proof.
  pose proof generic_format_ge_bpow radix2 (FLT_exp (-1074) 53) (-1074) ltac:(intro; apply Z.le_max_r) x (proj1 P) F as L.
  assert (K : exists b k, natural_logarithm_float64.scaled_by x = IZR b /\ bpow radix2 k <= x /\ (-1022 - k <= b)%Z /\ (-874 <= k + b)%Z).
  { unfold natural_logarithm_float64.scaled_by. destruct Rlt_dec as [W|W]; [exists 200%Z, (-1074)%Z | exists (-200)%Z, 0%Z; apply Rnot_lt_le in W];
    repeat split; assumption || easy. }
  destruct K as (b & k & B & K & Kb & Ks). set (s := x * bpow radix2 b). assert (S : natural_logarithm_float64.scaled x = s).
  { unfold natural_logarithm_float64.scaled, power_of_two. rewrite B, Zfloor_IZR. apply kept, (scaled_float64 x k); [exact F | rewrite Rabs_pos_eq;
    lra | exact Kb]. }
  assert (Sl : bpow radix2 (-874) <= s).
  { apply Rle_trans with (bpow radix2 (k + b)); [apply bpow_le, Ks|]. rewrite bpow_plus. apply Rmult_le_compat_r; [apply bpow_ge_0 | exact K]. }
  pose proof bpow_gt_0 radix2 (-874) as S0. set (c := 6369051672525773 / 4503599627370496). destruct (standard_model (c * s)) as (d & D & W).
  { rewrite Rabs_pos_eq by (unfold c; lra). apply Rle_trans with (bpow radix2 (-874)); [apply bpow_le; easy | unfold c; lra]. }
  replace unit_roundoff with (/ 2 ^ 53) in D by (unfold unit_roundoff; simpl; lra). both_ways D. set (e := (mag radix2 (c * s * (1 + d)) - 1)%Z).
  assert (Wp : 0 < c * s * (1 + d)) by (apply Rmult_lt_0_compat; [unfold c|]; lra). pose proof bpow_mag_gt radix2 (c * s * (1 + d)) as M. pose
    proof bpow_mag_le radix2 (c * s * (1 + d)) ltac:(lra) as N.
  rewrite Rabs_pos_eq in M, N by lra. fold e in N. replace (mag radix2 (c * s * (1 + d)) : Z) with (e + 1)%Z in M by (unfold e; lia). rewrite
    bpow_plus in M. simpl (bpow _ 1) in M.
  pose proof bpow_gt_0 radix2 e as E0. set (g := c * (1 + d)). assert (G : 14142135/10000000 <= g <= 14142136/10000000) by (unfold g, c; lra). replace
    (c * s * (1 + d)) with (s * g) in M, N by (unfold g; ring).
  assert (Bi : natural_logarithm_float64.binary x = IZR e) by (unfold natural_logarithm_float64.binary; rewrite S; fold c; rewrite W; reflexivity).
  assert (Mm : m = s * bpow radix2 (- e)).
  { unfold m, natural_logarithm_float64.mantissa, power_of_two. rewrite S, Bi, <- opp_IZR, Zfloor_IZR. apply kept, (scaled_float64 s (e - 1));
    [rewrite <- S; apply rounded_is_float64 | | lia].
    unfold Z.sub. rewrite bpow_plus. simpl (bpow _ (- (1))). rewrite Rabs_pos_eq by lra. nra. }
  assert (Back : forall i z, z * bpow radix2 i * bpow radix2 (- i) = z) by (intros; rewrite Rmult_assoc, <- bpow_plus, Z.add_opp_diag_r; apply Rmult_1_r).
  assert (Ms : m * bpow radix2 e = s) by (rewrite Mm; rewrite <- (Back (- e)%Z s) at 2; rewrite Z.opp_involutive; reflexivity).
  assert (X : x = m * bpow radix2 (e - b)) by (unfold Z.sub; rewrite bpow_plus, <- Rmult_assoc, Ms; symmetry; apply Back).
  assert (Bm : 7071067/10000000 <= m <= 14142137/10000000) by (rewrite <- Ms in M, N; clearbody g; split; nra).
  assert (Q : (-1075 <= e - b <= 1025)%Z).
  { pose proof bpow_gt_0 radix2 (e - b) as E1. assert (U : bpow radix2 (e - b) < bpow radix2 (1 + 1024)) by (rewrite (bpow_plus radix2 1); change (bpow
    radix2 1) with 2; nra). apply lt_bpow in U.
    assert (V : bpow radix2 (-1 + -1074) < bpow radix2 (e - b)) by (rewrite (bpow_plus radix2 (-1)); change (bpow radix2 (-1)) with (/ 2); nra). apply
      lt_bpow in V. lia. }
  exists (e - b)%Z. split; [|split; [exact Q | split; [apply rounded_is_float64 | split; [exact Bm|]]]].
  2: rewrite X, ln_mult, bpow_exp, ln_exp by (lra || apply bpow_gt_0); apply Rplus_comm.
  unfold natural_logarithm_float64.doublings. rewrite Bi, B, <- minus_IZR. apply kept. replace (IZR (e - b)) with (IZR (e - b) * bpow radix2 0) by
    apply Rmult_1_r. apply whole_is_float64; lia.
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
  (exists k j, d = IZR k * bpow radix2 (-8) /\ v = IZR j * bpow radix2 (-16) /\ (0 <= k <= 400 /\ Z.abs j <= 2 ^ 14)%Z) /\ (d = 1 /\ v = 0 /\ r = 0 \/
    1/5 <= Rabs v <= 24/100 /\ 115/1000 <= Rabs (ln m)).
Proof.
  destruct M as [_ B]. unfold d, v, r, natural_logarithm_float64.node, natural_logarithm_float64.node_short, natural_logarithm_float64.node_rest. fold m.
  destruct Rlt_dec as [C|C]; [|destruct Rlt_dec as [D|D]]; clear d v r M; clearbody m; (split; [apply Rabs_le; lra | split; [lra|]]).
  - split; [interval with (i_prec 120)|]. split; [interval|]. split; [exists 203%Z, (-15202)%Z; simpl bpow; repeat split; lra || lia|]. right. split;
    [split; interval|]. rewrite Rabs_left by interval. interval.
  - rewrite ln_1, Rplus_0_r, Rminus_0_r, Rabs_R0. split; [lra|]. split; [lra|]. split; [exists 256%Z, 0%Z; simpl bpow; repeat split; lra || lia|].
    left. lra.
  - apply Rnot_lt_le in D. split; [interval with (i_prec 120)|]. split; [interval|]. split; [exists 323%Z, 15235%Z; simpl bpow; repeat split; lra ||
    lia|]. right. split; [split; interval|]. rewrite Rabs_pos_eq by interval. interval.
Qed.
Lemma log_whole_exact n : natural_logarithm_float64.doublings x = IZR n -> (-1075 <= n <= 1025)%Z -> W = 22713/32768 * IZR n + v /\ exists k, W =
  IZR k * bpow radix2 (-16) /\ (Z.abs k < 2 ^ 26)%Z.
Proof.
  intros D N. destruct node_of_mantissa as (_ & _ & _ & _ & (_ & j & _ & V & _ & J) & _). unfold W, natural_logarithm_float64.log_whole. fold v.
    rewrite D.
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
  destruct (multiple_of_power m (-53) Fm) as [j J]; [rewrite Rabs_pos_eq by lra; apply Rle_trans with (bpow radix2 (-1)); [apply bpow_le; easy |
    simpl; lra]|].
  assert (A : m - d = IZR (j - k * 2 ^ 45) * bpow radix2 (-53)) by (rewrite J, D, minus_IZR, mult_IZR; change (IZR (2 ^ 45)) with (bpow radix2 45);
    replace (bpow radix2 (-8)) with (bpow radix2 45 * bpow radix2 (-53)) by (rewrite <- bpow_plus; reflexivity); ring).
  split.
  - apply (kept (m - d)). rewrite A. apply whole_is_float64; [apply (units_below _ (-53)); [easy | rewrite <- A; apply Rabs_lt; simpl bpow; lra] | easy].
  - rewrite A. apply no_part.
Qed.

Let b := Rabs q + negligible.
Let c := q / b.
Lemma scale : Rabs q <= 589/10000 /\ 0 < negligible <= bpow radix2 (-100) /\ negligible <= b /\ 0 < b <= 59/1000 /\ q = c * b /\ Rabs c <= 1.
Proof.
  destruct node_of_mantissa as (Bq & Bd & _). destruct M as [_ Bm]. assert (Q : Rabs q <= 589/10000) by (fold m d in Bq, Bd; apply over_length; lra).
  assert (t0 : 0 < negligible <= bpow radix2 (-100)) by (split; [apply bpow_gt_0 | apply bpow_le; easy]). pose proof Rabs_pos q as q0. assert (b0 :
    negligible <= b) by (unfold b; lra).
  refine (conj Q (conj t0 (conj b0 (conj _ (conj _ _))))); [simpl bpow in t0; unfold b; lra | unfold c; field; lra | apply over_length; unfold b; lra].
Qed.
Ltac relatively d t E x y := match goal with b0 : negligible <= ?b |- _ => destruct (relative 53 b x y eq_refl b0 eq_refl) as (d & t & ? & ? & E) end.
Lemma quotient_in_two : generic_format radix2 (FLT_exp (-1074) 26) h /\ (h = 0 \/ bpow radix2 (-60) <= Rabs h) /\ Rabs (h - q) <= 101/100 / 2 ^ 26 * b
  /\ Rabs (e - (q - h)) <= 1 / 2 ^ 70 * b.
Proof.
  destruct node_of_mantissa as (Bq & Bd & _ & _ & (k & _ & D & _ & K & _) & _). destruct above_node_exact as [A A0]. destruct M as [Fm Bm]. fold m d
    in Bq, Bd, D.
  assert (Fd : float64 d) by (rewrite D; apply whole_is_float64; lia). set (S := m + d) in *. assert (BS : 1497/1000 <= S <= 26843/10000) by
    (unfold S; lra).
  assert (qS : m - d = q * S) by (unfold q; fold S; field; lra). destruct scale as (Q & t0 & b0 & Bb & cb & Bc).
  destruct (rounded_sum m d Fm Fd) as (u & Bu & Es). fold S in Es.
  set (J := natural_logarithm_float64.inverse x). relatively u1 t1 F1 (1 / rounded S) J. rewrite Es in F1.
  set (a := natural_logarithm_float64.a x). relatively u2 t2 F2 (natural_logarithm_float64.above_node x * J) a. rewrite A, qS in F2.
  destruct (high_part a (rounded_is_float64 _)) as [Hh Fh]. destruct (relative 26 b a h eq_refl b0 Hh) as (u3 & t3 & D3 & T3 & F3).
  set (f := (h - q) / b). assert (Hf : h = b * (c + f)) by (rewrite Rmult_plus_distr_l, (Rmult_comm b c), <- cb; unfold f; field; lra).
  assert (Bf : Rabs f <= 101/100 / 2 ^ 26).
  { replace f with (c * ((1 + u1) / (1 + u) * (1 + u2) * (1 + u3) - 1) + c * S * b * t1 * (1 + u2) * (1 + u3) + t2 * (1 + u3) + t3).
    - simpl bpow in *. clearbody c b f S. interval with (i_prec 120).
    - apply Rmult_eq_reg_l with b; [|lra]. apply Rplus_eq_reg_l with (b * c). rewrite <- (Rmult_plus_distr_l b c f), <- Hf, F3, F2, F1, cb. field.
      both_ways Bu. split; lra. }
  clearbody f.
  assert (Eh : Rabs (h - q) <= 101/100 / 2 ^ 26 * b) by (rewrite cb, Hf; replace (b * (c + f) - c * b) with (f * b) by ring; apply
    at_the_scale_of, Bf; lra).
  assert (h0 : h = 0 \/ bpow radix2 (-60) <= Rabs h).
  { destruct A0 as [Z|Z].
    - left. assert (a0 : a = 0) by (unfold a, natural_logarithm_float64.a; rewrite A, Z, Rmult_0_l; apply rounded_0).
      unfold h, natural_logarithm_float64.a_high, natural_logarithm_float64.a_excess, natural_logarithm_float64.a_split. fold a. rewrite a0,
        Rmult_0_r, !rounded_0, Rminus_0_r, !rounded_0, Rminus_0_r. apply rounded_0.
    - right. rewrite qS, Rabs_mult, (Rabs_pos_eq S) in Z by lra. generalize (Rabs_triang_inv q h). rewrite (Rabs_minus_sym q h). simpl bpow in *.
      unfold b in Eh. assert (X : Rabs q * S <= Rabs q * (27/10)) by (apply Rmult_le_compat_l; [apply Rabs_pos | lra]). intro. lra. }
  refine (conj Fh (conj h0 (conj Eh _))). set (l := natural_logarithm_float64.lifted x). assert (El : Rabs (l - (m + 134217728))
    <= 1001/1000 / 2 ^ 26).
  { assert (B : Rabs (m + 134217728) <= 134217730) by (apply Rabs_le; lra). eapply Rle_trans; [exact (rounded_error _ _ B) | lra]. }
  destruct (multiple_of_power l (-25)) as [i L]; [apply rounded_is_float64 | change (bpow radix2 (-25 + 52)) with 134217728; rewrite Rabs_pos_eq;
    by_sides|].
  set (p := natural_logarithm_float64.mantissa_short x). assert (Lp : l - 134217728 = IZR (i - 2 ^ 52) * bpow radix2 (-25)) by (rewrite L, minus_IZR;
    simpl bpow; lra).
  assert (Ip : (Z.abs (i - 2 ^ 52) < 2 ^ 26)%Z) by (apply (units_below _ (-25)); [easy|]; rewrite <- Lp; apply Rabs_lt; simpl bpow; by_sides).
  assert (Pl : p = l - 134217728) by (unfold p, natural_logarithm_float64.mantissa_short; fold l; apply kept; rewrite Lp; apply whole_is_float64; lia).
  assert (Ps : p + d = IZR (i - 2 ^ 52 + k * 2 ^ 17) * bpow radix2 (-25)) by (rewrite Pl, Lp, D, plus_IZR, mult_IZR; simpl bpow; lra).
  assert (Ss : natural_logarithm_float64.sum_short x = p + d) by (unfold natural_logarithm_float64.sum_short; fold p d; apply kept; rewrite Ps; apply
    whole_is_float64; lia).
  assert (K1 : rounded (h * natural_logarithm_float64.sum_short x) = h * (p + d)).
  { rewrite Ss. apply kept. rewrite Ps. apply short_product; [exact Fh | lia |]. destruct h0 as [h0 | h0]; [left; rewrite h0; ring | right]. rewrite
    <- Ps, Rabs_mult. apply Rle_trans with (bpow radix2 (-60) * 1); [rewrite Rmult_1_r; apply bpow_le; easy|].
    apply Rmult_le_compat; [apply bpow_ge_0 | lra | exact h0 | rewrite Rabs_pos_eq; rewrite Pl; by_sides]. }
  set (s := p - m). assert (Bs : Rabs s <= 1001/1000 / 2 ^ 26) by (unfold s; rewrite Pl; replace (_ - m) with (l - (m + 134217728)) by ring; exact El).
  set (r1 := natural_logarithm_float64.mantissa_rest x). relatively d4 t4 E4 (m - p) r1. set (w :=
    rounded (h * r1)). relatively d5 t5 E5 (h * r1) w.
  set (n := natural_logarithm_float64.undivided_near x). relatively d6 t6 E6 (natural_logarithm_float64.above_node x - rounded (h *
    natural_logarithm_float64.sum_short x)) n. rewrite A, qS, K1 in E6.
  set (U := natural_logarithm_float64.undivided x). relatively d7 t7 E7 (n - w) U. relatively d8 t8 E8 (J * U) e.
  replace (p + d) with (S + s) in E6 by (unfold S, s; ring). replace (m - p) with (- s) in E4 by (unfold s; ring).
  rewrite E8, E7, E6, E5, E4, Hf, cb. replace (_ - _) with ((J * (- (f * S + (c + f) * s) * d6 + t6 - t5 + (c + f) * (s * ((1 + d4) * (1 + d5) - 1) -
    b * t4 * (1 + d5))) * (1 + d7) * (1 + d8) + f * (1 - J * S * (1 + d7) * (1 + d8)) + J * t7 * (1 + d8) + t8) * b) by ring.
  apply at_the_scale_of; [lra|].
  replace (J * S) with ((1 + u1) / (1 + u) + S * b * t1) by (rewrite F1; field; both_ways Bu; split; lra). rewrite F1. simpl bpow in *.
    clearbody c b s S. interval with (i_prec 120).
Qed.
Lemma quotient_logarithm : ln (1 + q) - ln (1 - q) = ln m - ln d.
Proof.
  destruct node_of_mantissa as (_ & Bd & _). destruct M as [_ Bm]. assert (S : 0 < 2 / (m + d)) by (apply Rdiv_lt_0_compat; lra).
  replace (1 + q) with (m * (2 / (m + d))) by (unfold q; field; lra). replace (1 - q) with (d * (2 / (m + d))) by (unfold q; field; lra). rewrite
    !ln_mult by lra. ring.
Qed.
Lemma tail_near : let s := logarithm_polynomial.log_tail q in Rabs (natural_logarithm_float64.log_tail x - s) <= 17/1000 / 2 ^ 53 * b /\ Rabs s <=
  24/10000 * b.
Proof.
  destruct scale as (Q & t0 & b0 & Bb & cb & Bc). destruct quotient_in_two as (_ & _ & _ & Ee). set (g := (e - (q - h)) / b). assert (Bg : Rabs g <= 1
    / 2 ^ 70) by (apply over_length; lra).
  set (p := natural_logarithm_float64.quotient x). relatively u1 t1 F1 (h + e) p. replace (h + e)
    with (b * (c + g)) in F1 by (rewrite Rmult_plus_distr_l, (Rmult_comm b c), <- cb; unfold g; field; lra). clearbody g.
  set (z := logarithm_polynomial.quotient_squared q). set (zh := natural_logarithm_float64.quotient_squared x). relatively u2 t2 F2 (p * p) zh.
  unfold natural_logarithm_float64.log_tail, logarithm_polynomial.log_tail. fold p z zh. lazymatch goal with |- context [rounded (rounded (p * zh) *
    ?F)] => lazymatch goal with |- context [q * z * ?G] => set (F4 := F); set (G1 := G) end end.
  relatively u3 t3 F3 (p * zh) (rounded (p * zh)). relatively d4 t4 E4 (rounded (p * zh) * F4) (rounded (rounded (p * zh) * F4)). simpl bpow in *.
  set (k := g + (c + g) * u1 + t1). assert (Bk : Rabs k <= 102/100 / 2 ^ 53) by (unfold k; clearbody c; interval). assert (Z : z = b ^ 2 * c ^ 2) by
    (unfold z, logarithm_polynomial.quotient_squared; rewrite cb; ring).
  assert (Bz : 0 <= z <= 349/100000) by (rewrite Z; clearbody b c; split; [apply Rmult_le_pos; apply pow2_ge_0 | interval]).
  assert (Ez : Rabs (zh - z) <= 107/10000 / 2 ^ 53) by (rewrite F2, F1, Z; replace (_ - _) with (b ^ 2 * (c ^ 2 * u2 + (2 * c * k + k ^ 2) * (1 + u2))
    + b * t2) by (unfold k; ring); clearbody b c k; interval).
  assert (BG : 66/100 <= G1 <= 669/1000) by (unfold G1; clearbody z; split; interval). assert (EF : Rabs (F4 - G1) <= 7/10 / 2 ^ 53) by (unfold F4,
    G1; clearbody z zh; clear - Bz Ez; eapply Rle_trans; [find_error | interval]).
  split; [rewrite E4, F3, F1 | rewrite cb; replace (c * b * z * G1) with (c * z * G1 * b) by ring]; [replace (_ - q * z * G1) with ((z * G1 * (c * ((1
    + u3) * (1 + d4) - 1) + k * (1 + u3) * (1 + d4)) + (c + k) * (1 + u3) * (1 + d4) * (z * (F4 - G1) + (zh - z) * (G1 + (F4 - G1))) + t3 * (G1 + (F4
    - G1)) * (1 + d4) + t4) * b) by (rewrite cb; unfold k; ring)|];
    (apply at_the_scale_of; [lra|]); generalize dependent (F4 - G1); generalize dependent (zh - z); clearbody b c z G1 k; intros; interval with
      (i_prec 100).
Qed.

Section parts.
Variable n : Z.
Hypothesis Doublings : natural_logarithm_float64.doublings x = IZR n /\ (-1075 <= n <= 1025)%Z.
Let y := IZR n * ln 2 + ln m.
Let w := natural_logarithm_float64.log_whole_rest x.
Lemma without_quotient : Rabs w <= 8/100000 * Rabs y /\ Rabs (W + w - (IZR n * ln 2 + ln d)) <= 4/10000 / 2 ^ 53 * Rabs y /\ Rabs q <= 52/100 * Rabs y
  + negligible /\ (W = 0 \/ 1/5 <= Rabs W).
Proof.
  destruct scale as (Q & t0 & _). destruct node_of_mantissa as (_ & _ & Ev & Br & _ & C). destruct (log_whole_exact n (proj1 Doublings) (proj2
    Doublings)) as [H _]. fold m in C. unfold y.
  set (L := 3373202482714085 / 2361183241434822606848). assert (E : w = rounded (rounded (L * IZR n) + r)) by (unfold w,
    natural_logarithm_float64.log_whole_rest; rewrite (proj1 Doublings); reflexivity).
  assert (Y : Rabs (ln m) <= 3466/10000) by (clear - M; destruct M as [_ B]; clear M; clearbody m; interval). assert (B : 693/1000 <= ln 2 <=
    694/1000) by (split; interval). assert (Small : n = 0%Z /\ d = 1 /\ v = 0 /\ r = 0 \/ 115/1000 + Rabs (IZR n) / 5 <= Rabs (IZR n * ln 2 + ln m) /\
    1/5 <= Rabs W).
  { rewrite H. destruct (Z.eq_dec n 0) as [-> | Z].
    - destruct C as [C | C]; [left; split; [reflexivity | exact C] | right]. rewrite !Rmult_0_l, Rmult_0_r, !Rplus_0_l, Rabs_R0. lra.
    - right. assert (O : 1 <= Rabs (IZR n)) by (rewrite <- abs_IZR; apply IZR_le; lia). assert (V : Rabs v <= 24/100) by (destruct C as [(_ & -> & _)
      | C]; [rewrite Rabs_R0|]; lra).
      clear - Y B O V. clearbody m v. split; unfold Rabs in *; repeat destruct Rcase_abs; nra. }
  destruct Small as [(n0 & d1 & v0 & r0) | [By BW]].
  - assert (K : w = 0) by (rewrite E, n0, r0, Rmult_0_r, rounded_0, Rplus_0_r; apply rounded_0). pose proof Rabs_pos (ln m) as Y0. pose proof
    series_relative q Q as S. rewrite quotient_logarithm in S. destruct tail_near as [_ T].
    rewrite H, K, n0, v0, d1, ln_1, Rmult_0_r, Rmult_0_l, !Rplus_0_l, ?Rplus_0_r, Rminus_0_r, Rabs_R0 in *. split; [lra | split; [lra | split; [|left;
      reflexivity]]].
    unfold b in T. clear - S T t0. unfold Rabs in *. repeat destruct Rcase_abs; lra.
  - pose proof Rabs_pos (IZR n) as N0. set (N := Rabs (IZR n)) in *. assert (BL : Rabs (L * IZR n) <= 143/100000000 * N) by (apply bounded_product;
    [unfold L; interval | apply Rle_refl]).
    assert (Bs : Rabs (L * IZR n + r) <= 143/100000000 * N + 8/1000000) by (at_most_by Rabs_triang; lra). pose proof sum_error _ _ r
      _ _ Bs (rounded_error _ _ BL) as X. rewrite <- E in X.
    assert (EL : Rabs ((22713/32768 + L - ln 2) * IZR n) <= 1 / 2 ^ 72 * N) by (apply bounded_product; [unfold L; interval with (i_prec 120) |
      apply Rle_refl]).
    split; [generalize (size _ _ _ _ Bs X); lra | split; [|split; [lra | right; exact BW]]].
    by_sides.
Qed.
Lemma logarithm_in_three : natural_logarithm_float64.log_quotient x = 2 * h /\ (W = 0 \/ Rabs (2 * h) <= Rabs W) /\ Rabs (2 * h) <= 11/10 * Rabs y + 3
  * negligible /\
  Rabs (natural_logarithm_float64.log_rest x) <= 14/10000 * Rabs y + negligible /\ Rabs (W + 2 * h + natural_logarithm_float64.log_rest x - y) <=
    19/1000 / 2 ^ 53 * Rabs y + negligible.
Proof.
  destruct scale as (Q & t0 & _ & [_ b1] & _). destruct quotient_in_two as (_ & _ & Eh & Ee). destruct tail_near as [Et Bt]. pose proof
    series_relative q Q as Es. rewrite quotient_logarithm in Es. destruct without_quotient as (Bw & Ew & Bq & BW).
  assert (Doubled : forall z, rounded (2 * rounded z) = 2 * rounded z) by (intro z; apply kept; rewrite Rmult_comm; change 2 with (bpow radix2 1);
    apply mult_bpow_pos_exact_FLT; [apply rounded_is_float64 | easy]).
  split; [exact (Doubled _)|]. set (t := natural_logarithm_float64.log_tail x) in *. set (s := logarithm_polynomial.log_tail q) in *. simpl bpow in
    t0. pose proof Rabs_pos y as Y0.
  assert (Bb : b <= 52/100 * Rabs y + 2 * negligible) by (unfold b; lra). clearbody b.
  assert (Bh : Rabs (2 * h) = 2 * Rabs h) by (rewrite Rabs_mult, (Rabs_pos_eq 2); lra). rewrite Bh.
  split; [destruct BW as [BW | BW]; [left; exact BW | right; eapply Rle_trans; [|exact BW]; generalize (size _ _ _ _ Q Eh); lra]|]. split; [generalize
    (size _ _ _ _ Bq Eh); lra|].
  set (a := rounded (t + w)). added a t w (134/100000 * Rabs y + negligible / 100).
  set (R := natural_logarithm_float64.log_rest x). set (f := rounded (2 * e)). assert (Fe : f = 2 * e) by exact (Doubled _). added R a f (135/100000 * Rabs
    y + negligible / 10). split; [by_sides|].
  assert (Hy : y = IZR n * ln 2 + ln m) by reflexivity. set (z := Rabs q) in *. clearbody z y R f a t s w h e q W. by_sides.
Qed.
End parts.
End logarithm.

(* What is added in two operations, the sum and what it loses, is the sum where the first is not the smaller, or 0. *)
Lemma sum_in_two a b : float64 a -> float64 b -> a = 0 \/ Rabs b <= Rabs a -> rounded (b + a) + rounded (rounded (a - rounded (b + a)) + b) = a +
  b.
Proof.
  intros A B [-> | S].
  - rewrite Rplus_0_r, (kept b B), Rminus_0_l, (kept (- b) (generic_format_opp _ _ _ B)). rewrite Rplus_opp_l, rounded_0. ring.
  - rewrite (Rplus_comm b a), (Rplus_comm (rounded _) b). apply (Fast2Sum_correct (-1074) 53 (fun n => negb (Z.even n))); [easy | easy | | exact A |
    exact B | exact S].
    intro n. rewrite Z.even_opp, Z.even_add. destruct (Z.even n); reflexivity.
Qed.
Lemma parts_of_logarithm x : float64 x -> 0 < x <= IZR (2 ^ 1024 - 2 ^ 971) -> let w := natural_logarithm_float64.log_whole x in let q :=
  natural_logarithm_float64.log_quotient x in let r := natural_logarithm_float64.log_rest x in (w = 0 \/ Rabs q <= Rabs w) /\ Rabs q <= 11/10 *
  Rabs (ln x) + 3 * negligible /\ Rabs r <= 14/10000 * Rabs (ln x) + negligible /\ Rabs (w + q + r - ln x) <= 19/1000 / 2 ^ 53 * Rabs (ln x) +
  negligible /\ (exists k, w = IZR k * bpow radix2 (-16) /\ (Z.abs k < 2 ^ 26)%Z) /\ (exists h, q = 2 * h /\ generic_format radix2 (FLT_exp
  (-1074) 26) h /\ (h = 0 \/ bpow radix2 (-60) <= Rabs h)).
Proof.
  intros F [P L] w q r. assert (U : x < bpow radix2 1024) by (eapply Rle_lt_trans; [exact L | change (bpow radix2 1024) with (IZR (2 ^ 1024)); apply
    IZR_lt; easy]).
  destruct (doublings_and_mantissa x F (conj P U)) as (n & D & N & Fm & Bm & X). destruct (logarithm_in_three x (conj Fm Bm) n (conj D N)) as (H & S &
    Q & BR & E).
  destruct (quotient_in_two x (conj Fm Bm)) as (Fh & Oh & _). rewrite <- X in Q, BR, E. rewrite <- H in S, Q, E.
  split; [exact S | split; [exact Q | split; [exact BR | split; [exact E | split; [exact (proj2 (log_whole_exact x (conj Fm Bm) n D N)) | exists
    (natural_logarithm_float64.a_high x); split; [exact H | split; [exact Fh | exact Oh]]]]]]].
Qed.
(* The logarithm of a float64 above 0 is within 41/40 2^-53 of its logarithm, relative to that, and 2^-896. *)
Theorem elementary_functions__log x : float64 x -> 0 < x <= IZR (2 ^ 1024 - 2 ^ 971) -> Rabs (natural_logarithm_float64.logarithm x - ln x) <=
  41/40 * (1 / 2 ^ 53) * Rabs (ln x) + bpow radix2 (-896).
Proof.
  intros F [P L]. destruct (parts_of_logarithm x F (conj P L)) as (S & _ & BR & E & _).
  unfold natural_logarithm_float64.logarithm. destruct both as [_ | [C | C]]; [|destruct C; exact L | destruct C; exact P]. clear L F.
  set (w := natural_logarithm_float64.log_whole x) in *. set (q := natural_logarithm_float64.log_quotient x) in *. set (r :=
    natural_logarithm_float64.log_rest x) in *.
  pose proof rounded_is_float64 as Fl. pose proof sum_in_two w q (Fl _) (Fl _) S as Q. set (y := ln x) in *. pose proof Rabs_pos y as y0.
  assert (B : 16 * negligible = bpow radix2 (-896)) by (unfold negligible; change 16 with (bpow radix2 4); rewrite <- bpow_plus; reflexivity). rewrite
    <- B. assert (t0 := bpow_gt_0 radix2 (-900) : 0 < negligible).
  set (s := rounded (q + w)). set (c := natural_logarithm_float64.log_sum_rest x). change (s + c = w + q) in Q. set (l := rounded (r + c)). set (z :=
    natural_logarithm_float64.log_near x). pose proof Rle_refl (Rabs y).
  added s q w (1002/1000 * Rabs y + 3 * negligible). added l r c (15/10000 * Rabs y + 2 * negligible). added z l s (1001/1000 * Rabs y + 3 *
    negligible). by_sides.
Qed.
Theorem elementary_functions__log__point : exists x, float64 x /\ 0 < x <= IZR (2 ^ 1024 - 2 ^ 971).
Proof. exists 1. split; [exact one_is_float64 | split; [lra | apply IZR_le; easy]]. Qed.
(* It is not so near its tangent at 1. *)
Theorem elementary_functions__log__false : ~ forall x, float64 x -> 0 < x <= IZR (2 ^ 1024 - 2 ^ 971) ->
  Rabs (natural_logarithm_float64.logarithm x - (x - 1)) <= 41/40 * (1 / 2 ^ 53) * Rabs (x - 1) + bpow radix2 (-896).
Proof.
  intro H. pose proof two_is_float64 as F. assert (P : 0 < 2 <= IZR (2 ^ 1024 - 2 ^ 971)) by (split; [lra | apply IZR_le; easy]).
  generalize (H 2 F P) (elementary_functions__log 2 F P). assert (T : bpow radix2 (-896) <= bpow radix2 (-10)) by (apply bpow_le; easy). change (bpow
    radix2 (-10)) with (/ 1024) in T.
  assert (L : 69/100 <= ln 2 <= 7/10) by (split; interval). replace (2 - 1) with 1 by ring. rewrite Rabs_R1, (Rabs_pos_eq (ln 2)) by lra. clear H.
    intros. by_sides.
Qed.
