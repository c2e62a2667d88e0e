(* The rule of the enclosing machine for the angle: how far it turns where its point moves. *)

From Coq Require Import Reals Lra ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Float Float64 RoundedHalfTurns Rounding RoundedFunctions RoundedAngle EnclosingRules EnclosingBounds.
Open Scope R_scope.

(* The angle of a point is where its direction lies, on the side that its coordinates say. *)
Lemma polar y x : let t := PI * atan2pi y x in exists r, 0 <= r /\ x = r * cos t /\ y = r * sin t /\ - PI <= t <= PI /\ (0 <= x -> - (PI / 2) <= t
  <= PI / 2) /\ 0 <= y * t.
Proof.
  pose proof PI_RGT_0 as P. replace (PI * atan2pi y x) with (atan2 y x) by (unfold atan2pi; field; lra).
  unfold atan2. set (q := y / x). pose proof atan_bound q as B. pose proof atan_rises q 0 as S. pose proof atan_rises 0 q as S'. rewrite atan_0 in S, S'.
    pose proof sqrt_lt_R0 (1 + Rsqr q) ltac:(generalize (Rle_0_sqr q); lra) as C.
  destruct (Req_EM_T x 0) as [->|X].
  - exists (Rabs y). unfold Rabs. replace (- PI / 2) with (- (PI / 2)) by field. destruct Rcase_abs; repeat destruct Rlt_dec; rewrite ?cos_neg,
    ?sin_neg, ?cos_PI2, ?sin_PI2, ?cos_0, ?sin_0; repeat split; nra.
  - assert (Q : y = q * x) by (unfold q; field; assumption). exists (Rabs x * sqrt (1 + Rsqr q)). unfold Rabs.
    destruct Rcase_abs; destruct (Rle_lt_dec 0 y); first [specialize (S' ltac:(nra)) | specialize (S ltac:(nra))]; repeat destruct Rlt_dec; try
      destruct Rle_dec; try lra; rewrite ?cos_plus, ?sin_plus, ?cos_minus, ?sin_minus, ?cos_PI, ?sin_PI, cos_atan, sin_atan.
    all: split; [nra | split; [field; lra | split; [rewrite Q at 1; field; lra | repeat split; intros; nra]]].
Qed.
(* Where it moves by less than a quarter turn, and not over the cut, the angle turns by an arctangent. *)
Lemma angle_moves y x y' x' : let d := Rabs (atan2pi y x - atan2pi y' x') in let dot := x * x' + y * y' in d <= 2 /\ forall K, 0 < dot -> 0 <= x
  \/ Rabs (y - y') < Rabs y -> Rabs (y * x' - x * y') <= K * dot -> d <= 3184 / 10000 * K.
Proof.
  intros d0 dot. destruct (polar y x) as (r & R & X & Y & B & Bx & By). destruct (polar y' x') as (r' & R' & X' & Y' & B' & _ & By'). unfold d0.
    pose proof PI_RGT_0 as P.
  set (u := atan2pi y x) in *. set (u' := atan2pi y' x') in *. split; [apply Rabs_le; split; nra|]. intros K D S G. set (d := PI * (u - u')).
  assert (T : - (3 * (PI / 2)) <= d <= 3 * (PI / 2)).
  { unfold d. destruct S as [S|S]; [lra|]. unfold Rabs in S. destruct (Rcase_abs y); destruct Rcase_abs; split; nra. }
  assert (dot = r * r' * cos d /\ y * x' - x * y' = r * r' * sin d) as [E F] by (unfold d, dot; rewrite Rmult_minus_distr_l, cos_minus, sin_minus, X,
    X', Y, Y'; split; ring).
  assert (C : 0 < cos d) by (pose proof Rmult_le_pos _ _ R R' as Q; nra).
  assert (H : - (PI / 2) < d < PI / 2) by (generalize (cos_le_0 d) (cos_le_0 (- d)); rewrite cos_neg; lra).
  replace (r * r' * sin d) with (tan d * dot) in F by (rewrite E; unfold tan; field; lra). rewrite F, Rabs_mult, (Rabs_pos_eq dot) in G by lra. apply
    Rmult_le_reg_r in G; [|exact D].
  pose proof atan_moves 0 (tan d) as M. rewrite atan_tan, atan_0, !Rminus_0_r in M by exact H. apply Rle_trans with (3184 / 10000 * Rabs d); [|lra].
  unfold d. rewrite Rabs_mult, (Rabs_pos_eq PI) by lra. assert (I : 1 <= 3184 / 10000 * PI) by interval. generalize (Rmult_le_compat_r _ _ _ (Rabs_pos
    (u - u')) I). lra.
Qed.
Theorem enclosing_rules__angle : Statements.enclosing_rules__angle.
Proof.
  intros s x ex x' y ey y' S1 S2 X Ex Px Dx Y Ey Py Dy N. enclosed_angle_float64.lines. fold ROUNDING. fold SLACK. fold least. pose proof proj1
    underflow_in_least as T. pose proof underflow_is_small as U. assert (0 <= 731105545250889 / 2251799813685248) by lra. assert (0 <= SLACK) by in_units.
  pose proof Rabs_pos x as Ax. pose proof Rabs_pos y as Ay. pose proof pow2_abs x as Nx. pose proof pow2_abs y as Ny. pose proof two_is_float64 as F.
  assert (L : bpow radix2 (-1018) <= Rmax (Rabs x) (Rabs y)) by (apply Rle_trans with (bpow radix2 (-6)); [apply bpow_le; easy | simpl; unfold Rmax;
    destruct Rle_dec; nra]).
  destruct (angle_near y x Y X L) as [O O']. destruct (angle_moves y x y' x') as [W V]. destruct (both (Rlt_dec x 0) _) as [_|Cut].
  { generalize (made_a_count s 2 0 (angle_in_half_turns_float64.angle y x - atan2pi y' x') S1 F ltac:(lra) (generic_format_0 _ _) ltac:(lra)). rewrite
    Rplus_0_r, (kept 2 F). intro K. apply K. replace (_ - _) with (angle_in_half_turns_float64.angle y x - atan2pi y x + (atan2pi y x - atan2pi y'
    x')) by ring. eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang | in_units]. }
  destruct (both (Rlt_dec (rounded _) _) _) as [[Near _]|_]; [|apply moved_and_own with (atan2pi y x); try assumption; lra].
  destruct (bound_of s ey S1 S2 Py) as [By By']. destruct (bound_of s ex S1 S2 Px) as [_ Bx]. counts b (ROUNDING * ey). counts a (ROUNDING * ex).
  assert (S : 0 <= x \/ Rabs (y - y') < Rabs y).
  { destruct Cut as [Cut|Cut]; [left; lra | right]. apply Rnot_le_lt in Cut. rewrite <- (kept (Rabs y)) in Cut by is_float64. apply rounded_below in Cut.
    assert (Z : b < rounded (Rabs y)) by (rewrite (kept (Rabs y)) by is_float64; in_units). apply rounded_below in Z. in_units. }
  set (dx := Rabs (x - x')) in *. set (dy := Rabs (y - y')) in *.
  assert (C : Rabs (y * x' - x * y') <= Rabs x * dy + Rabs y * dx) by (replace (_ - _) with (x * (y - y') - y * (x - x')) by ring; at_most_by
    Rabs_triang; rewrite
    Rabs_Ropp, !Rabs_mult; apply Rle_refl).
  set (dot := x * x' + y * y') in *. assert (E : x ^ 2 + y ^ 2 - (Rabs x * dx + Rabs y * dy) <= dot) by (unfold dx, dy, dot; rewrite <- !Rabs_mult;
    generalize (Rle_abs (x * (x - x'))) (Rle_abs (y * (y - y'))); lra).
  rounds xx (x * x). rounds yy (y * y). rounds z (xx + yy). rounds q (sqrt z). pose proof sqrt_sqrt z ltac:(assumption) as Z. set (radius := sqrt z) in
    *. clearbody radius z.
  assert (1 / 33 <= radius /\ Rabs x <= 1001 / 1000 * radius /\ Rabs y <= 1001 / 1000 * radius) as (R & Rx & Ry) by (repeat split; apply
    less_of_squares; in_units).
  rounds half (1 / 2 * q). counts w (b + a). assert (0 <= q - w) by in_units. rounds g (q - w). counts d (q * g). assert (M : w <= 51 / 100 * radius)
    by in_units. assert (D : dx + dy <= 1001 / 1000 * w + 4 * underflow) by in_units.
  assert (q * g <= 1001 / 1000 * radius * (1001 / 1000 * (radius - w))) by (apply Rmult_le_compat; in_units). assert (radius / 2 * (radius / 8) <= q *
    g) by (apply Rmult_le_compat; in_units).
  multiplied dx Rx. multiplied dy Ry. multiplied radius D. multiplied radius M. multiplied radius R. multiplied radius U. multiplied underflow Rx.
    multiplied underflow Ry. multiplied underflow R. multiplied (radius * underflow) R. multiplied (Rabs x) Dy. multiplied (Rabs y) Dx. multiplied
    (Rabs x) By'. multiplied (Rabs y) Bx.
  assert (d <= 101 / 100 * dot /\ 48 / 100 * (radius * radius) <= dot /\ 0 < d) as (G & G' & P) by in_units. multiplied underflow G'.
  rounds across_y (Rabs x * b). rounds across_x (Rabs y * a). counts across (across_y + across_x). assert (K : 0 <= across / d) by (apply
    Rdiv_le_0_compat; assumption). multiplied (across / d) G. replace (across / d * d) with across in * by (field; lra).
  rounds k (across / d). rounds t' (k * (731105545250889 / 2251799813685248)). rounds t (t' * SLACK).
  apply moved_and_own with (atan2pi y x); try assumption; [lra | is_float64 |]. apply Rle_trans with (3184 / 10000 * (1013 / 1000 * (across / d) + 2 ^
    13 * underflow)); [apply V; try assumption; in_units | in_units].
Qed.
(* On an axis it is exact, and the angle the same of all points of a side. *)
Lemma on_an_axis y x y' x' : y = 0 /\ y' = 0 /\ 0 < x * x' \/ x = 0 /\ x' = 0 /\ 0 < y * y' -> angle_in_half_turns_float64.angle y x = atan2pi y' x'.
Proof.
  intro H. unfold angle_in_half_turns_float64.angle, angle_in_half_turns_float64.half_plane, angle_in_half_turns_float64.first_quadrant. rewrite
    no_octant by (generalize (Rabs_pos x) (Rabs_pos y); destruct H as [(-> & _) | (-> & _)]; rewrite Rabs_R0; intros; apply Rmin_right || apply
      Rmin_left;
    assumption).
  pose proof kept _ half_is_float64 as K. pose proof PI_neq0. unfold atan2pi, atan2. destruct H as [(-> & -> & P) | (-> & -> & P)]; try replace (0 /
    x') with 0 by (unfold Rdiv; ring); rewrite ?atan_0;
    unfold Rabs; repeat (destruct Rcase_abs || destruct Rlt_dec || destruct Rle_dec); try (exfalso; nra); rewrite ?Rminus_0_r, ?K, ?rounded_1; field;
      assumption.
Qed.
