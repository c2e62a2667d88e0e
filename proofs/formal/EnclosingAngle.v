(* The rule of the enclosing machine for the angle: how far it turns where its point moves. *)

From Coq Require Import Reals Lra Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Float Float64 RoundedHalfTurns Rounding RoundedAngle EnclosingRules EnclosingBounds.
From Formal Require Statements.
Open Scope R_scope.

Lemma polar (y x : R) : let t := atan2 y x in exists r, 0 <= r /\ x = r * cos t /\ y = r * sin t /\
  - PI <= t <= PI /\ (0 <= x -> - (PI / 2) <= t <= PI / 2) /\ (0 < y -> 0 <= t) /\ (y < 0 -> t <= 0).
Proof.
  assert (P := PI_RGT_0). unfold atan2. set (q := y / x). assert (B := atan_bound q). assert (C := cos_gt_0 (atan q) ltac:(lra) ltac:(lra)). assert (T := tan_atan q). unfold tan in T.
  assert (S := atan_rises q 0). assert (S' := atan_rises 0 q). rewrite atan_0 in S, S'. set (a := atan q) in *.
  assert (Q : x <> 0 -> y = q * x) by (intro; unfold q; field; assumption). assert (K : sin a = q * cos a) by (rewrite <- T; field; lra). assert (I := Rinv_0_lt_compat _ C).
  assert (H : - PI / 2 = - (PI / 2)) by field.
  destruct (Rlt_dec 0 x) as [X|X]; [|destruct (Rlt_dec x 0) as [X'|X']]; [exists (x * / cos a) | exists (- x * / cos a) |].
  3: assert (Z : x = 0) by lra; rewrite Z; destruct (Rlt_dec 0 y); [exists y | destruct (Rlt_dec y 0); [exists (- y) | exists 0]]; rewrite ?H, ?cos_neg, ?sin_neg, ?cos_PI2, ?sin_PI2, ?cos_0, ?sin_0; lra.
  all: specialize (Q ltac:(lra)); try destruct Rle_dec; unfold Rminus; rewrite ?cos_plus, ?sin_plus, ?cos_neg, ?sin_neg, ?cos_PI, ?sin_PI, ?K.
  all: split; [nra | split; [field; lra | split; [rewrite Q at 1; field; lra | repeat split; intros; try lra]]].
  all: first [enough (0 <= a) by lra; apply S' | enough (a <= 0) by lra; apply S]; nra.
Qed.
(* Where it moves by less than a quarter turn, and not over the cut, it turns by an arctangent. *)
Lemma turned (y x y' x' : R) : let dot := x * x' + y * y' in 0 < dot -> 0 <= x \/ Rabs (y - y') < Rabs y -> Rabs (atan2 y x - atan2 y' x') <= Rabs (y * x' - x * y') / dot.
Proof.
  intros dot D S. destruct (polar y x) as (r & R & X & Y & B & Bx & Bp & Bn). destruct (polar y' x') as (r' & R' & X' & Y' & B' & _ & Bp' & Bn').
  set (t := atan2 y x) in *. set (t' := atan2 y' x') in *. set (d := t - t').
  assert (T : - (3 * (PI / 2)) <= d <= 3 * (PI / 2)).
  { unfold d. destruct S as [S|S]; [specialize (Bx S); lra|]. unfold Rabs in S. destruct (Rcase_abs y); destruct Rcase_abs; try lra.
    all: first [specialize (Bn ltac:(lra)) | specialize (Bp ltac:(lra))]. all: first [specialize (Bn' ltac:(lra)) | specialize (Bp' ltac:(lra))]; lra. }
  assert (E : dot = r * r' * cos d) by (unfold d, dot; rewrite cos_minus, X, X', Y, Y'; ring).
  assert (C : 0 < cos d) by (assert (P := Rmult_le_pos _ _ R R'); nra). assert (C' := C). rewrite <- cos_neg in C'.
  assert (H : - (PI / 2) < d < PI / 2) by (split; apply Rnot_le_lt; intro W; [generalize (cos_le_0 (- d)) | generalize (cos_le_0 d)]; lra).
  rewrite <- (atan_tan d H), <- (Rminus_0_r (atan _)), <- atan_0. apply Rle_div_r; [exact D|]. apply Rle_trans with (Rabs (tan d * dot)).
  - rewrite Rabs_mult, (Rabs_pos_eq dot) by lra. apply Rmult_le_compat_r; [lra|]. rewrite <- (Rminus_0_r (tan d)) at 2. apply atan_moves.
  - right. f_equal. replace (y * x' - x * y') with (r * r' * sin d) by (unfold d; rewrite sin_minus, X, X', Y, Y'; ring). rewrite E. unfold tan. field. lra.
Qed.

Lemma turn_counted (y x y' x' b a : R) : 1 / 1024 <= x * x + y * y -> float64 b -> float64 a -> 0 <= b -> 0 <= a -> Rabs (y - y') * (1 + 4 * unit53) <= b + 2 * underflow -> Rabs (x - x') * (1 + 4 * unit53) <= a + 2 * underflow ->
  0 <= x \/ Rabs (y - y') < Rabs y -> let m := rounded (b + a) in let r := rounded (sqrt (rounded (rounded (x * x) + rounded (y * y)))) in m < rounded (1 / 2 * r) ->
  let s := rounded (rounded (rounded (Rabs x * b) + rounded (Rabs y * a)) / rounded (r * rounded (r - m))) in
  0 <= s /\ Rabs (atan2 y x - atan2 y' x') <= 101/100 * s + 2 ^ 13 * underflow.
Proof.
  intros L B A Pb Pa Dy Dx S. cbv zeta. assert (T := proj1 underflow_in_least). assert (V := underflow_is_small). set (radius := sqrt (x * x + y * y)).
  assert (R2 : radius * radius = x * x + y * y) by (apply sqrt_sqrt; nra). assert (R0 : 0 <= radius) by apply sqrt_pos. assert (Rl : 1 / 32 <= radius) by nra.
  assert (Rx : Rabs x <= radius) by (apply less_of_squares; [exact R0 | rewrite <- Rabs_mult, Rabs_pos_eq by nra; nra]).
  assert (Ry : Rabs y <= radius) by (apply less_of_squares; [exact R0 | rewrite <- Rabs_mult, Rabs_pos_eq by nra; nra]).
  rounds xx (x * x). rounds yy (y * y). rounds z (xx + yy).
  assert (Z : sqrt z * sqrt z = z) by (apply sqrt_sqrt; assumption). 
  assert (Z1 : sqrt z <= radius * (1 + 1 / 2 ^ 40)) by (apply less_of_squares; [nra|]; rewrite Z; replace (_ * _) with (radius * radius * (1 + 1 / 2 ^ 40) ^ 2) by ring; rewrite R2; in_units).
  assert (Z2 : radius * (1 - 1 / 2 ^ 40) <= sqrt z) by (apply less_of_squares; [apply sqrt_pos|]; rewrite Z; replace (_ * _) with (radius * radius * (1 - 1 / 2 ^ 40) ^ 2) by ring; rewrite R2; in_units).
  rounds q (sqrt z). clear Z. clearbody z. intro M. rounds half (1 / 2 * q). counts w (b + a).
  assert (G0 : radius / 4 <= q - w) by in_units. assert (0 <= q - w) by lra. rounds g (q - w). assert (Q1 : q <= radius * (1001/1000)) by in_units. assert (Q2 : radius / 2 <= q) by in_units.
  assert (G1 : g <= (radius - w) * (1001/1000)) by in_units. assert (G2 : radius / 8 <= g) by in_units.
  counts d (q * g). assert (P1 : q * g <= radius * (1001 / 1000) * ((radius - w) * (1001 / 1000))) by (apply Rmult_le_compat; lra). assert (P2 : radius / 2 * (radius / 8) <= q * g) by (apply Rmult_le_compat; lra).
  assert (RR : 1 / 1024 <= radius * radius) by lra. assert (D0 : 0 < d) by in_units.
  counts from_y (Rabs x * b). counts from_x (Rabs y * a). counts across (from_y + from_x).
  set (dy := Rabs (y - y')) in *. set (dx := Rabs (x - x')) in *. assert (0 <= dy) by apply Rabs_pos. assert (0 <= dx) by apply Rabs_pos.
  assert (C : Rabs (y * x' - x * y') <= Rabs x * dy + Rabs y * dx) by (replace (_ - _) with (x * (y - y') - y * (x - x')) by ring; eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_Ropp, !Rabs_mult; fold dx dy; lra).
  set (dot := x * x' + y * y'). assert (E : radius * radius - (Rabs x * dx + Rabs y * dy) <= dot).
  { unfold dot. rewrite R2. generalize (Rle_abs (x * (x - x') + y * (y - y'))) (Rabs_triang (x * (x - x')) (y * (y - y'))). rewrite !Rabs_mult. fold dx dy. lra. }
  assert (Ex := Rmult_le_compat_r dx _ _ ltac:(assumption) Rx). assert (Ey := Rmult_le_compat_r dy _ _ ltac:(assumption) Ry).
  assert (W : dx + dy <= w + 4 * underflow) by in_units. assert (Wr := Rmult_le_compat_l radius _ _ R0 W).
  assert (K : radius * underflow <= radius * (radius / 2 ^ 100)) by (apply Rmult_le_compat_l; in_units). assert (N : radius * w <= radius * (51 / 100 * radius)) by (apply Rmult_le_compat_l; in_units).
  assert (Dd : d <= 1003/1000 * dot) by in_units. assert (Dr : 48/100 * (radius * radius) <= dot) by in_units.
  clearbody across d. assert (I := Rinv_0_lt_compat d D0). assert (0 <= across / d) by (apply Rmult_le_pos; lra). split; [is_not_negative|].
  eapply Rle_trans; [apply turned; [fold dot; lra | exact S]|]. fold dot. apply Rle_div_l; [lra|]. eapply Rle_trans; [exact C|].
  assert (Kx := Rmult_le_compat_l _ _ _ (Rabs_pos x) Dy). assert (Ky := Rmult_le_compat_l _ _ _ (Rabs_pos y) Dx). assert (Ux := Rmult_le_compat_r underflow _ _ ltac:(lra) Rx). assert (Uy := Rmult_le_compat_r underflow _ _ ltac:(lra) Ry).
  assert (Ur := Rmult_le_compat_r (radius * underflow) _ _ ltac:(apply Rmult_le_pos; lra) Rl). assert (Ud := Rmult_le_compat_r underflow _ _ ltac:(lra) Dr). assert (Ul := Rmult_le_compat_r underflow _ _ ltac:(lra) RR).
  assert (Kd := Rmult_le_compat_r (across / d) _ _ ltac:(assumption) Dd). replace (d * (across / d)) with across in Kd by (field; lra).
  assert (Ks := Rmult_le_compat_l dot _ _ ltac:(lra) (proj1 (counted (across / d) ltac:(assumption)))). set (s := rounded (across / d)) in *.
in_units.
Qed.
Lemma half_turns_between (y x : R) : -1 <= atan2pi y x <= 1.
Proof.
  destruct (polar y x) as (r & _ & _ & _ & B & _). assert (P := PI_RGT_0). unfold atan2pi. split; [apply Rle_div_r | apply Rle_div_l]; lra.
Qed.
Theorem enclosing_rules__angle : Statements.enclosing_rules__angle.
Proof.
  red. intros s x ex x' y ey y' S1 S2 X Ex Px Dx Y Ey Py Dy N. enclosed_angle_float64.lines. fold ROUNDING. fold SLACK. fold least. assert (T := proj1 underflow_in_least).
  destruct (bound_of s ey S1 S2 Py) as [By _]. destruct (bound_of s ex S1 S2 Px) as [Bx _]. assert (Lp : 0 <= least) by (rewrite least_is; lra). assert (U := underflow_is_small).
  assert (L : bpow radix2 (-1018) <= Rmax (Rabs x) (Rabs y)).
  { apply Rle_trans with (1 / 64); [replace (1 / 64) with (bpow radix2 (-6)) by (simpl; lra); apply bpow_le; easy|]. 
    generalize (Rabs_pos x) (Rabs_pos y) (Rmax_l (Rabs x) (Rabs y)) (Rmax_r (Rabs x) (Rabs y)). rewrite <- (pow2_abs x), <- (pow2_abs y) in N. nra. }
  destruct (angle_near y x Y X L) as [A1 A2]. set (f := angle_in_half_turns_float64.angle y x) in *. change (bpow radix2 (-1074)) with underflow in A2.
  destruct (own_error (5 / 9007199254740992) least f least_is_float64_too Lp ltac:(lra)) as (Fo & Po & Co). set (own := rounded (rounded (5 / 9007199254740992 * Rabs f) + least)) in *. rewrite least_is in Co.
  assert (H := half_turns_between y x). assert (H' := half_turns_between y' x'). set (u := atan2pi y x) in *. set (u' := atan2pi y' x') in *.
  counts b (ROUNDING * ey). counts a (ROUNDING * ex).
  assert (M : Rabs (f - u') <= Rabs (f - u) + Rabs (u - u')) by (replace (f - u') with ((f - u) + (u - u')) by ring; apply Rabs_triang).
  assert (M2 : Rabs (u - u') <= 2) by (apply Rabs_le; lra). assert (F2 : float64 2) by (apply (generic_format_bpow radix2 (FLT_exp (-1074) 53) 1); easy).
  destruct (both (Rlt_dec x 0) _) as [_|Cut].
  - generalize (made_a_count s 2 0 (f - u') S1 F2 ltac:(lra) (generic_format_0 _ _) ltac:(lra)). rewrite Rplus_0_r, (kept 2 F2). intro K. apply K. in_units.
  - assert (O : Rabs (f - u) + 2 ^ 13 * underflow <= own * (1 + 9 * unit53)) by (generalize (Rabs_pos f) (Rabs_triang_inv u f); rewrite (Rabs_minus_sym u f); in_units).
    destruct (both (Rlt_dec (rounded (b + a)) _) _) as [[Near _]|_]; [|apply made_a_count; try assumption; [lra | in_units]].
    destruct (turn_counted y x y' x' b a) as [P G]; try assumption; try in_units; [is_float64 | is_float64 | |].
    + destruct Cut as [Cut|Cut]; [left; lra | right]. apply Rnot_le_lt in Cut. rewrite <- (kept (Rabs y)) in Cut by is_float64. apply rounded_below in Cut.
      assert (Z : b < rounded (Rabs y)) by (rewrite (kept (Rabs y)) by is_float64; in_units). apply rounded_below in Z. in_units.
    + set (g := rounded (_ / _)) in *. rounds t (g * (731105545250889 / 2251799813685248)). rounds q (t * SLACK).
      assert (Q : Rabs (u - u') <= 3184 / 10000 * Rabs (atan2 y x - atan2 y' x')).
      { unfold u, u', atan2pi. replace (_ - _) with (/ PI * (atan2 y x - atan2 y' x')) by (field; apply PI_neq0). rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos | interval]. }
      apply made_a_count; try assumption; [is_float64 | in_units].
Qed.
