(* A step so small that u + epsilon and u - epsilon round back to u: what float64 computes for the slope then, of any height. *)

From Coq Require Import Reals Lra Lia ZArith.
From Flocq Require Import Core.
From Formal Require Import Preliminaries Float Float64 RoundedHalfTurns Rounding RoundedGradient.
Open Scope R_scope.

Definition nearest_whole (t : R) : Z := Znearest (fun n => negb (Z.even n)) t.

(* From 2^k up to 2^(k+1) float64 numbers are the multiples of their spacing 2^(k-52). *)
Lemma spacing k x : (-1022 <= k)%Z -> bpow radix2 k <= x < bpow radix2 (k + 1) -> cexp radix2 (FLT_exp (-1074) 53) x = (k - 52)%Z.
Proof.
  intros K B. pose proof bpow_gt_0 radix2 k as P. unfold cexp. rewrite (mag_unique radix2 _ (k + 1)); [unfold FLT_exp; lia|].
  replace (k + 1 - 1)%Z with k by ring. rewrite Rabs_pos_eq; lra.
Qed.
Lemma binade_of_multiple k t : IZR (2 ^ 52) <= t < IZR (2 ^ 53) -> bpow radix2 k <= t * bpow radix2 (k - 52) < bpow radix2 (k + 1).
Proof.
  change (IZR (2 ^ 52)) with (bpow radix2 52). change (IZR (2 ^ 53)) with (bpow radix2 53). pose proof bpow_gt_0 radix2 (k - 52) as S.
  replace k with (52 + (k - 52))%Z at 1 by ring. replace (k + 1)%Z with (53 + (k - 52))%Z by ring. rewrite (bpow_plus _ 52), (bpow_plus _ 53). intro
    T. split; nra.
Qed.
Lemma rounded_in_binade k t : (-1022 <= k)%Z -> IZR (2 ^ 52) <= t < IZR (2 ^ 53) -> rounded (t * bpow radix2 (k - 52)) = IZR (nearest_whole t) *
  bpow radix2 (k - 52).
Proof.
  intros K T. unfold rounded, round, F2R, scaled_mantissa. rewrite (spacing k) by (exact K || apply binade_of_multiple, T). cbn [Fnum Fexp]. unfold
    nearest_whole. do 3 f_equal.
  rewrite Rmult_assoc, <- bpow_plus, Z.add_opp_diag_r. apply Rmult_1_r.
Qed.
Lemma nearest_tie m : nearest_whole (IZR m + / 2) = if Z.even m then m else (m + 1)%Z.
Proof.
  unfold nearest_whole, Znearest. rewrite (Zfloor_imp m), (Zceil_imp (m + 1)) by (rewrite ?plus_IZR, ?minus_IZR, ?plus_IZR; lra). rewrite Rcompare_Eq
    by ring. destruct (Z.even m); reflexivity.
Qed.
(* What a positive step of float64 is added to, or taken from, in units of the spacing s. *)
Lemma float64_step e j : float64 e -> 0 < e -> e <= bpow radix2 j -> (-1074 <= j)%Z.
Proof.
  intros F P L. apply (le_bpow radix2). eapply Rle_trans; [|exact L]. apply (generic_format_ge_bpow radix2 (FLT_exp (-1074) 53)); [|exact P | exact F].
  intro. apply Z.le_max_r.
Qed.
Lemma half_spacing k : bpow radix2 (k - 53) = bpow radix2 (k - 52) / 2.
Proof. replace (k - 52)%Z with (k - 53 + 1)%Z by ring. rewrite (bpow_plus _ _ 1). change (bpow radix2 1) with 2. field. Qed.
Lemma power_float64 e : (-1074 <= e)%Z -> float64 (bpow radix2 e).
Proof. intro E. apply generic_format_bpow. unfold FLT_exp. lia. Qed.
Ltac powers := repeat split; try (apply power_float64 || apply bpow_lt || apply bpow_gt_0); try easy; intros; right; reflexivity.
(* Both sums round back to u: the whole binade dies. *)
Lemma stays k u e : float64 u -> float64 e -> bpow radix2 k <= u < bpow radix2 (k + 1) -> 0 < e < bpow radix2 (k - 53) -> (u = bpow radix2 k -> e
  <= bpow radix2 (k - 54)) -> rounded (e + u) = u /\ rounded (u - e) = u.
Proof.
  intros F E B [P L] A. assert (K : (-1021 <= k)%Z) by (generalize (float64_step e (k - 53) E P (Rlt_le _ _ L)); lia). rewrite half_spacing in L.
  pose proof bpow_gt_0 radix2 k as k0. assert (U : forall x, bpow radix2 k <= x < bpow radix2 (k + 1) -> ulp radix2 (FLT_exp (-1074) 53) x = bpow radix2
    (k - 52)) by (intros; rewrite ulp_neq_0, (spacing k) by (lia || lra); reflexivity).
  split; apply Rle_antisym.
  - apply round_N_le_midp; [typeclasses eauto | exact F |]. rewrite succ_eq_pos, U by lra. lra.
  - apply round_ge_generic; [typeclasses eauto..| exact F | lra].
  - apply round_le_generic; [typeclasses eauto..| exact F | lra].
  - destruct (proj1 B) as [Q | Q].
    + apply round_N_ge_midp; [typeclasses eauto | exact F |]. assert (float64 (bpow radix2 k)) by (apply power_float64; lia).
      assert (bpow radix2 k <= pred radix2 (FLT_exp (-1074) 53) u < u) by (split; [apply pred_ge_gt | apply pred_lt_id]; try assumption; lra || typeclasses
        eauto).
      pose proof pred_plus_ulp radix2 (FLT_exp (-1074) 53) u ltac:(lra) F as D. rewrite U in D by lra. lra.
    + (* a tie, to the even u *)
      assert (R : bpow radix2 k = 9007199254740992 * bpow radix2 (k - 1 - 52)) by (change 9007199254740992 with (bpow radix2 53); rewrite <- bpow_plus;
        f_equal; ring).
      assert (Tie : rounded ((9007199254740991 + / 2) * bpow radix2 (k - 1 - 52)) = u) by (rewrite rounded_in_binade, nearest_tie by (lia || simpl; lra);
        rewrite <- Q, R; reflexivity).
      rewrite <- Tie at 1. apply round_le; [typeclasses eauto..|]. replace (k - 54)%Z with (k - 1 - 53)%Z in A by ring. rewrite half_spacing in A. lra.
Qed.
(* The tie, epsilon = s/2: both sums round back where the significand m is even, and both move by s where it is odd. *)
Lemma tied k m : (-1022 <= k)%Z -> (2 ^ 52 < m < 2 ^ 53 - 1)%Z -> let s := bpow radix2 (k - 52) in let w := IZR m * s in let moved := if Z.even m
  then 0 else s in rounded (s / 2 + w) = w + moved /\ rounded (w - s / 2) = w - moved.
Proof.
  intros K M s w moved. assert (A : IZR (2 ^ 52) + 1 <= IZR m <= IZR (2 ^ 53) - 2) by (rewrite <- plus_IZR, <- minus_IZR; split; apply IZR_le; lia).
  replace (s / 2 + w) with ((IZR m + / 2) * s) by (unfold w; field). replace (w - s / 2) with ((IZR (m - 1) + / 2) * s) by (unfold w; rewrite
    minus_IZR; field).
  unfold s. rewrite !rounded_in_binade, !nearest_tie, Z.even_sub by (lia || rewrite ?minus_IZR; lra). unfold moved, w, s.
  destruct (Z.even m); cbn [Bool.eqb Z.even]; rewrite ?Z.sub_add, ?plus_IZR, ?minus_IZR; split; ring.
Qed.
Lemma below_1 k m : (k <= -1)%Z -> (2 ^ 52 < m < 2 ^ 53 - 1)%Z -> let s := bpow radix2 (k - 52) in 0 < s < IZR m * s /\ IZR m * s + s < 1.
Proof.
  intros K M s. assert (S : 0 < s) by apply bpow_gt_0. assert (T : s <= / 9007199254740992) by (apply (bpow_le radix2 _ (-53)); lia).
  assert (1 < IZR m < 9007199254740991) by (split; apply IZR_lt; lia). nra.
Qed.

(* The arguments, as they are printed. *)
Lemma not_wrapped x : 0 <= rounded x < 1 -> rounded (rounded x - whole_below (rounded x)) = rounded x.
Proof.
  intro B. unfold whole_below. rewrite (Zfloor_imp 0) by (simpl; lra). rewrite Rminus_0_r. apply kept, rounded_is_float64.
Qed.
Lemma unwrapped u e p m : rounded (e + u) = p -> rounded (u - e) = m -> 0 <= p < 1 -> 0 <= m < 1 -> central_any_float64.u_plus u e = p /\
  central_any_float64.u_minus u e = m.
Proof. intros <- <- A B. split; apply not_wrapped; assumption. Qed.
Lemma arguments_in_v v e p m : float64 e -> rounded (e + v) = p -> rounded (v - e) = m -> p <= 1 -> 0 <= m -> central_any_float64.v_plus v e = p /\
  central_any_float64.v_minus v e = m /\ central_any_float64.span_v v e = 2 * e.
Proof.
  intros E <- <- A B. central_any_float64.lines. rewrite Rmin_right, Rmax_right by assumption.
  do 2 (split; [reflexivity|]). destruct (both _ _) as [_|N]; [apply kept, twice_float64, E|]. exfalso.
  replace (e - v) with (- (v - e)) in N by ring. rewrite rounded_opp in N. lra.
Qed.
Lemma clamped_arguments v e : float64 v -> float64 e -> 0 <= v < e -> e + v <= 1 -> central_any_float64.v_plus v e = rounded (e + v) /\
  central_any_float64.v_minus v e = 0 /\ central_any_float64.span_v v e = rounded (e + v).
Proof.
  intros V E B W. apply up_to_1 in W. assert (M : rounded (v - e) < 0).
  { destruct (difference_near v e V E) as (d & D & ->). both_ways D. nra. }
  central_any_float64.lines. rewrite Rmin_right, Rmax_left by lra. repeat split. destruct (both _ _) as [[_ N]|_].
  - rewrite <- Ropp_minus_distr, rounded_opp in N. lra.
  - rewrite Rminus_0_r. apply kept, rounded_is_float64.
Qed.
Ltac unfold_difference := unfold central_any_float64.h_u, central_any_float64.h_u_plus, central_any_float64.h_u_minus, central_any_float64.h_v,
  central_any_float64.h_v_plus, central_any_float64.h_v_minus.
Lemma no_rise a b e : a = b -> rounded (rounded (1 / 2 * rounded (a - b)) / e) = 0 /\ rounded (rounded (a - b) / e) = 0.
Proof. intros ->. unfold Rdiv. rewrite Rminus_diag_eq, rounded_0, Rmult_0_r, rounded_0, Rmult_0_l, rounded_0 by reflexivity. split; reflexivity. Qed.
Lemma none_in_u height w v k_u k_v e : 0 <= w < 1 -> rounded (e + w) = w /\ rounded (w - e) = w -> central_any_float64.u_plus w e = w /\
  central_any_float64.u_minus w e = w /\ central_any_float64.h_u height w v k_u k_v e = 0.
Proof.
  intros B [P M]. destruct (unwrapped _ _ _ _ P M B B) as [P1 M1]. repeat split; trivial. apply no_rise. unfold_difference. rewrite P1, M1. reflexivity.
Qed.
Lemma none_in_v height u w k_u k_v e : 0 <= w <= 1 -> float64 e -> rounded (e + w) = w /\ rounded (w - e) = w -> central_any_float64.v_plus w e =
  w /\ central_any_float64.v_minus w e = w /\ central_any_float64.span_v w e = 2 * e /\ central_any_float64.h_v height u w k_u k_v e = 0.
Proof.
  intros B E [P M]. destruct (arguments_in_v _ _ _ _ E P M) as (P1 & M1 & S1); try lra. repeat split; trivial. apply no_rise. unfold_difference. rewrite P1,
    M1. reflexivity.
Qed.

(* u, epsilon > 0: float64, u from 2^k up to 2^(k+1) and below 1, s = 2^(k-52). Where epsilon < s/2, and epsilon <= s/4 at u = 2^k, the
   slope is 0, whatever the height. *)
Theorem binades__dies_in_u height u v k_u k_v epsilon k : (k <= -1)%Z -> float64 u -> float64 epsilon -> bpow radix2 k <= u < bpow radix2 (k + 1)
  -> 0 < epsilon < bpow radix2 (k - 53) -> (u = bpow radix2 k -> epsilon <= bpow radix2 (k - 54)) -> central_any_float64.u_plus u epsilon = u /\
  central_any_float64.u_minus u epsilon = u /\ central_any_float64.h_u height u v k_u k_v epsilon = 0.
Proof.
  intros K F E B L A. apply none_in_u; [|exact (stays k u epsilon F E B L A)].
  generalize (bpow_gt_0 radix2 k) (bpow_le radix2 (k + 1) 0 ltac:(lia)). simpl (bpow radix2 0). lra.
Qed.
(* In v the same, up to v = 1 = 2^0 itself; the span is 2 epsilon and not 0. *)
Theorem binades__dies_in_v height u v k_u k_v epsilon k : v <= 1 -> float64 v -> float64 epsilon -> bpow radix2 k <= v < bpow radix2 (k + 1) -> 0
  < epsilon < bpow radix2 (k - 53) -> (v = bpow radix2 k -> epsilon <= bpow radix2 (k - 54)) -> central_any_float64.v_plus v epsilon = v /\
  central_any_float64.v_minus v epsilon = v /\ central_any_float64.span_v v epsilon = 2 * epsilon /\ central_any_float64.h_v height u v k_u k_v
  epsilon = 0.
Proof. intros O F E B L A. apply none_in_v; [generalize (bpow_gt_0 radix2 k); lra | exact E | exact (stays k v epsilon F E B L A)]. Qed.

(* At the tie even significands m die, too; odd ones move by s, and the slope of h = u, or h = v, which is 1, is 2 just before it dies. *)
Theorem binades__tie height c k_u k_v k m : (-1021 <= k <= -1)%Z -> (2 ^ 52 < m < 2 ^ 53 - 1)%Z -> let w := IZR m * bpow radix2 (k - 52) in let
  epsilon := bpow radix2 (k - 53) in if Z.even m then central_any_float64.h_u height w c k_u k_v epsilon = 0 /\ central_any_float64.h_v height c w
  k_u k_v epsilon = 0 else central_any_float64.u_plus w epsilon = w + 2 * epsilon /\ central_any_float64.u_minus w epsilon = w - 2 * epsilon /\
  central_any_float64.h_u (fun u _ _ _ => u) w c k_u k_v epsilon = 2 /\ central_any_float64.h_v (fun _ v _ _ => v) c w k_u k_v epsilon = 2.
Proof.
  intros K M w epsilon. assert (F : float64 epsilon) by (apply power_float64; lia). destruct (below_1 k m ltac:(lia) ltac:(lia)) as [L L1]. pose
    proof tied k m ltac:(lia) M as T.
  cbv zeta in T. fold w in L, L1, T. rewrite <- half_spacing in T. fold epsilon in T. replace (bpow radix2 (k - 52)) with (2 * epsilon) in * by
    (unfold epsilon; rewrite half_spacing; field).
  destruct (Z.even m); [rewrite Rplus_0_r, Rminus_0_r in T; split; [apply none_in_u | apply none_in_v]; try assumption; lra|]. destruct T as [P N].
  destruct (unwrapped _ _ _ _ P N) as [P1 N1]; [lra..|]. destruct (arguments_in_v _ _ _ _ F P N) as (P1' & N1' & S); [lra..|].
  assert (D : rounded (w + 2 * epsilon - (w - 2 * epsilon)) = 2 * (2 * epsilon)) by (rewrite <- (kept _ (twice_float64 _ (twice_float64 _ F)));
    f_equal; ring).
  assert (Two : rounded 2 = 2) by exact (kept 2 (power_float64 1 ltac:(easy))). split; [exact P1 | split; [exact N1|]].
  unfold_difference.
  rewrite P1, N1, P1', N1', S, D. replace (1 / 2 * (2 * (2 * epsilon))) with (2 * epsilon) by field. rewrite (kept _ (twice_float64 _ F)). split;
    (transitivity (rounded 2); [f_equal; field; lra | exact Two]).
Qed.

(* The pole v = 0 keeps all of the slope: v - epsilon is clamped to 0, and the span is epsilon. *)
Theorem binades__pole height u k_u k_v epsilon : float64 epsilon -> 0 < epsilon <= 1 -> central_any_float64.v_plus 0 epsilon = epsilon /\
  central_any_float64.v_minus 0 epsilon = 0 /\ central_any_float64.span_v 0 epsilon = epsilon /\ central_any_float64.h_v height u 0 k_u k_v
  epsilon = rounded (rounded (height u epsilon k_u k_v - height u 0 k_u k_v) / epsilon).
Proof.
  intros E B. destruct (clamped_arguments 0 epsilon (generic_format_0 _ _) E) as (P & M & S); [lra..|]. rewrite Rplus_0_r, (kept _ E) in P, S.
  repeat split; trivial. unfold_difference. rewrite P, M, S. reflexivity.
Qed.

(* The seam u = 0 keeps half of it: u - epsilon wraps to 1, not to a number below it, and where h is the same at 1 and at 0 the slope is half of the one-sided
   difference (h(epsilon) - h(0))/epsilon, as float64 computes that. *)
Lemma half_float64 x : bpow radix2 (-1021) <= Rabs x -> rounded (/ 2 * x) = / 2 * rounded x.
Proof.
  intro L. assert (N : x <> 0) by (intro Z; rewrite Z, Rabs_R0 in L; generalize (bpow_gt_0 radix2 (-1021)); lra).
  assert (M : mag radix2 (/ 2 * x) = (mag radix2 x + -1)%Z :> Z) by (rewrite Rmult_comm; exact (mag_mult_bpow radix2 x (-1) N)).
  assert (G : (-1020 <= mag radix2 x)%Z) by (apply (mag_ge_bpow radix2 x (-1020)); exact L).
  assert (C : cexp radix2 (FLT_exp (-1074) 53) (/ 2 * x) = (cexp radix2 (FLT_exp (-1074) 53) x + -1)%Z) by (unfold cexp; rewrite M; unfold FLT_exp; lia).
  unfold rounded, round, F2R, scaled_mantissa. rewrite C. cbn [Fnum Fexp]. rewrite bpow_plus, Z.opp_add_distr, bpow_plus.
  change (bpow radix2 (- -1)) with 2. change (bpow radix2 (-1)) with (/ 2). replace (/ 2 * x * _) with (x * bpow radix2 (- cexp radix2 (FLT_exp
    (-1074) 53) x)) by field. field.
Qed.
Theorem binades__seam height v k_u k_v epsilon : float64 epsilon -> 0 < epsilon <= bpow radix2 (-54) -> let rise := rounded (height epsilon v k_u
  k_v - height 0 v k_u k_v) in height 1 v k_u k_v = height 0 v k_u k_v -> rise = 0 \/ bpow radix2 (-1021) <= Rabs rise ->
  central_any_float64.u_plus 0 epsilon = epsilon /\ central_any_float64.u_minus 0 epsilon = 1 /\ central_any_float64.h_u height 0 v k_u k_v
  epsilon = / 2 * rounded (rise / epsilon).
Proof.
  intros E B rise H R. assert (L : bpow radix2 (-54) < 1) by (apply (bpow_lt radix2 (-54) 0); easy).
  assert (P : central_any_float64.u_plus 0 epsilon = epsilon) by (unfold central_any_float64.u_plus; rewrite Rplus_0_r, not_wrapped; rewrite (kept _
    E); trivial; lra).
  assert (M : central_any_float64.u_minus 0 epsilon = 1).
  { unfold central_any_float64.u_minus. rewrite Rminus_0_l, rounded_opp, (kept _ E). unfold whole_below. rewrite (Zfloor_imp (-1)) by (simpl; lra).
    replace (- epsilon - -1) with (bpow radix2 0 - epsilon) by (simpl; ring). apply (stays 0 (bpow radix2 0) epsilon); [powers | exact E | powers | | intro;
      apply B].
    generalize (bpow_lt radix2 (-54) (-53) ltac:(easy)). simpl Z.sub. lra. }
  split; [exact P | split; [exact M|]]. unfold_difference. rewrite P, M, H. fold rise.
  replace (1 / 2) with (/ 2) by field. destruct R as [R|R].
  - rewrite R. unfold Rdiv. rewrite !Rmult_0_r, Rmult_0_l, !rounded_0, Rmult_0_l, rounded_0. ring.
  - rewrite half_float64, (kept rise) by (exact R || apply rounded_is_float64). replace (/ 2 * rise / epsilon) with (/ 2 * (rise / epsilon)) by
    (field; lra). apply half_float64.
    unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; lra). assert (1 <= / epsilon) by (rewrite <- Rinv_1; apply
      Rinv_le_contravar; lra).
    generalize (Rabs_pos rise). nra.
Qed.

(* Values that the hypotheses have, and false variants: at the tie not every slope dies, nor does it below 2^k: at the pole and at the seam, which does not
   keep all of it. *)
Theorem binades__dies_in_u__point : exists u epsilon k, (k <= -1)%Z /\ float64 u /\ float64 epsilon /\ bpow radix2 k <= u < bpow radix2 (k + 1) /\
  0 < epsilon < bpow radix2 (k - 53) /\ (u = bpow radix2 k -> epsilon <= bpow radix2 (k - 54)).
Proof.
  exists (bpow radix2 (-1)), (bpow radix2 (-55)), (-1)%Z. powers.
Qed.
Theorem binades__dies_in_v__point : exists v epsilon k, v <= 1 /\ float64 v /\ float64 epsilon /\ bpow radix2 k <= v < bpow radix2 (k + 1) /\ 0 <
  epsilon < bpow radix2 (k - 53) /\ (v = bpow radix2 k -> epsilon <= bpow radix2 (k - 54)).
Proof.
  exists (bpow radix2 0), (bpow radix2 (-54)), 0%Z. powers.
Qed.
Theorem binades__tie__point : exists k m : Z, (-1021 <= k <= -1)%Z /\ (2 ^ 52 < m < 2 ^ 53 - 1)%Z /\ Z.even m = true.
Proof. exists (-1)%Z, (2 ^ 52 + 2)%Z. easy. Qed.
Theorem binades__tie__false : ~ forall height c k_u k_v k m, (-1021 <= k <= -1)%Z -> (2 ^ 52 < m < 2 ^ 53 - 1)%Z -> central_any_float64.h_u height
  (IZR m * bpow radix2 (k - 52)) c k_u k_v (bpow radix2 (k - 53)) = 0.
Proof.
  intro H. generalize (H (fun u _ _ _ => u) 0 0 0 (-1)%Z (2 ^ 52 + 3)%Z ltac:(easy) ltac:(easy)).
  destruct (binades__tie (fun u _ _ _ => u) 0 0 0 (-1) (2 ^ 52 + 3) ltac:(easy) ltac:(easy)) as (_ & _ & -> & _). lra.
Qed.
Theorem binades__pole__point : exists epsilon, float64 epsilon /\ 0 < epsilon <= 1.
Proof. exists (bpow radix2 0). split; [apply power_float64; easy | simpl; lra]. Qed.
Theorem binades__pole__false : ~ forall height u k_u k_v epsilon, float64 epsilon -> 0 < epsilon <= bpow radix2 (-54) -> central_any_float64.h_v
  height u 0 k_u k_v epsilon = 0.
Proof.
  intro H. assert (E : float64 (bpow radix2 (-54))) by (apply power_float64; easy). pose proof bpow_gt_0 radix2 (-54) as P. assert (L : bpow radix2
    (-54) <= 1) by (apply (bpow_le radix2 (-54) 0); easy).
  generalize (H (fun _ v _ _ => v) 0 0 0 (bpow radix2 (-54)) E ltac:(lra)). destruct (binades__pole (fun _ v _ _ => v) 0 0 0 (bpow radix2 (-54)) E
    ltac:(lra)) as (_ & _ & _ & ->).
  rewrite Rminus_0_r, (kept _ E). unfold Rdiv. rewrite Rinv_r, rounded_1 by lra. lra.
Qed.
Theorem binades__seam__point : exists (height : R -> R -> R -> R -> R) (v k_u k_v epsilon : R), float64 epsilon /\ 0 < epsilon < bpow radix2 (-54) /\
  height 1 v k_u k_v = height 0 v k_u k_v /\ rounded (height epsilon v k_u k_v - height 0 v k_u k_v) = epsilon /\ bpow radix2 (-1021) <= Rabs epsilon.
Proof.
  assert (E : float64 (bpow radix2 (-55))) by (apply power_float64; easy). pose proof bpow_gt_0 radix2 (-55) as P. pose proof bpow_lt radix2 (-55)
    (-54) ltac:(easy) as Q. assert (L : bpow radix2 (-55) < 1) by (apply (bpow_lt radix2 (-55) 0); easy).
  exists (fun u _ _ _ => if Rlt_dec u 1 then u else 0), 0, 0, 0, (bpow radix2 (-55)). cbv beta.
  destruct (Rlt_dec 1 1), (Rlt_dec 0 1), (Rlt_dec (bpow radix2 (-55)) 1); try lra. rewrite Rminus_0_r, (kept _ E), Rabs_pos_eq by lra.
  repeat split; try trivial; try lra. apply bpow_le. easy.
Qed.
Theorem binades__seam__false : ~ forall height v k_u k_v epsilon, float64 epsilon -> 0 < epsilon <= bpow radix2 (-54) -> height 1 v k_u k_v =
  height 0 v k_u k_v -> let rise := rounded (height epsilon v k_u k_v - height 0 v k_u k_v) in rise = 0 \/ bpow radix2 (-1021) <= Rabs rise ->
  central_any_float64.h_u height 0 v k_u k_v epsilon = rounded (rise / epsilon).
Proof.
  intro H. destruct binades__seam__point as (height & v & k_u & k_v & epsilon & E & [P Q] & S & R & N). pose proof conj P (Rlt_le _ _ Q) as B.
    generalize (H height v k_u k_v epsilon E B S).
  destruct (binades__seam height v k_u k_v epsilon E B S) as (_ & _ & ->); rewrite R; [right; exact N|]. cbv zeta. intro K. specialize (K (or_intror N)).
  unfold Rdiv in K. rewrite Rinv_r, rounded_1 in K by lra. lra.
Qed.
Theorem binades__dies_in_v__false : ~ forall height u v k_u k_v epsilon k, v <= 1 -> float64 v -> float64 epsilon -> 0 <= v < bpow radix2 (k + 1)
  -> 0 < epsilon < bpow radix2 (k - 53) -> central_any_float64.h_v height u v k_u k_v epsilon = 0.
Proof.
  intro H. apply binades__pole__false. intros height u k_u k_v epsilon E B. pose proof bpow_lt radix2 (-54) (0 - 53) ltac:(easy) as L.
  apply (H height u 0 k_u k_v epsilon 0%Z); [lra | apply generic_format_0 | exact E | split; [lra | apply bpow_gt_0] | lra].
Qed.
Theorem binades__dies_in_u__false : ~ forall height u v k_u k_v epsilon k, (k <= -1)%Z -> float64 u -> float64 epsilon -> 0 <= u < bpow radix2 (k
  + 1) -> 0 < epsilon < bpow radix2 (k - 53) -> central_any_float64.h_u height u v k_u k_v epsilon = 0.
Proof.
  intro H. destruct binades__seam__point as (height & v & k_u & k_v & epsilon & E & B & S & R & N).
  generalize (H height 0 v k_u k_v epsilon (-1)%Z ltac:(easy) (generic_format_0 _ _) E ltac:(split; [lra | apply bpow_gt_0]) B).
  destruct (binades__seam height v k_u k_v epsilon E (conj (proj1 B) (Rlt_le _ _ (proj2 B))) S) as (_ & _ & ->); rewrite R; [right; exact N|]. unfold
    Rdiv. rewrite Rinv_r, rounded_1 by lra. lra.
Qed.
