(* What float64 loses of the forward and of the fourth-order difference, clamped and at the seam too. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Float Float64 RoundedHalfTurns Rounding RoundedGradient Binades Fields RoundedFunctions
  RoundedDifference Orders.
Open Scope R_scope.

(* A computed height at x: that of an argument p, at most alpha off, and at most eta from h there. *)
Definition sample (h : R -> R) (eta alpha x a : R) := exists p, Rabs (p - x) <= alpha /\ Rabs (a - h p) <= eta.
Lemma sample_near (h : R -> R) (L eta alpha x a : R) : steep h L -> sample h eta alpha x a -> Rabs (a - h x) <= eta + L * alpha.
Proof.
  intros (h1 & D & S) (p & P & A). apply through with (h p); auto. at_most_by (moved_by_at_most h h1 L x p D S).
  apply Rmult_le_compat_l; [at_most_by Rabs_pos; apply (S 0) | lra].
Qed.
Lemma heights_apart (h : R -> R) (L x y s : R) : steep h L -> x - y = s -> 0 <= s -> Rabs (h x - h y) <= L * s.
Proof. intros (h1 & D & S) E P. rewrite <- (Rabs_pos_eq s), <- E by lra. exact (moved_by_at_most h h1 L y x D S). Qed.
Lemma off_and_grown x y t k off most : Rabs (x - y) <= off -> Rabs y <= most -> Rabs (t - 1) <= k -> Rabs (x * t - y) <= off * (1 + k) + most * k.
Proof.
  intros O M T. replace (_ - _) with ((x - y) * t + y * (t - 1)) by ring. at_most_by Rabs_triang. rewrite !Rabs_mult.
  apply Rplus_le_compat; factors; try assumption. both_ways T. apply Rabs_le. lra.
Qed.
Lemma difference_of a b c d x y : Rabs (a - c) <= x -> Rabs (b - d) <= y -> Rabs (a - b - (c - d)) <= x + y.
Proof. intros A B. both_ways A. both_ways B. apply Rabs_le. lra. Qed.

(* Whatever the height, if its slope is at most L. *)
Lemma fourth_of_any_height (h : R -> R) (L x e growth eta alpha beta a b c d s t : R) : steep h L -> 0 < e -> Rabs (s - 1) <= growth ->
  Rabs (t - 1) <= growth ->
  sample h eta alpha (e + x) a -> sample h eta alpha (x - e) b -> sample h eta beta (2 * e + x) c -> sample h eta beta (x - 2 * e) d ->
  Rabs (1 / 12 * ((d - c) * s + 8 * ((a - b) * t)) / e - fourth h x e) <= (9 * eta + L * (8 * alpha + beta)) / (6 * e) * (1 + growth) + 5 / 3 * L *
    growth.
Proof.
  intros S E K T A B C D. pose proof off_and_grown _ _ _ _ _ _ (difference_of _ _ _ _ _ _ (sample_near _ _ _ _ _ _ S A) (sample_near _ _ _ _ _ _
    S B)) (heights_apart h L (e + x) (x - e) (2 * e) S ltac:(ring) ltac:(lra)) T as near.
  pose proof off_and_grown _ _ _ _ _ _ (difference_of _ _ _ _ _ _ (sample_near _ _ _ _ _ _ S C) (sample_near _ _ _ _ _ _ S D)) (heights_apart h L
    (2 * e + x) (x - 2 * e) (4 * e) S ltac:(ring) ltac:(lra)) K as far.
  replace (_ - _) with (((d - c) * s + 8 * ((a - b) * t) - (h (x - 2 * e) - h (2 * e + x) + 8 * (h (e + x) - h (x - e)))) / (12 * e)) by (unfold
    fourth; field; lra). apply over_length; [lra|].
  replace (_ * (12 * e)) with ((2 * (9 * eta + L * (8 * alpha + beta))) * (1 + growth) + 20 * L * e * growth) by (field;
    lra). both_ways near. both_ways far. apply Rabs_le. lra.
Qed.

(* The kernels' quotients *)
Definition grown (n : nat) := (1 + / 2 ^ 53) ^ n - 1.
Lemma grows n t d : Rabs (t - 1) <= grown n -> Rabs d <= / 2 ^ 53 -> Rabs (t * (1 + d) - 1) <= grown (S n).
Proof.
  intros T D. unfold grown in *. replace (_ - _) with ((t - 1) * (1 + d) + d) by ring. at_most_by Rabs_triang. rewrite Rabs_mult, <- tech_pow_Rmult.
    set (p := (1 + / 2 ^ 53) ^ n) in *. clearbody p.
  assert (Rabs (1 + d) <= 1 + / 2 ^ 53) by (both_ways D; apply Rabs_le; lra). assert (Rabs (t - 1) * Rabs (1 + d) <= (p - 1) * (1 + / 2 ^ 53)) by
    (factors; assumption). lra.
Qed.
Lemma grows_once d : Rabs d <= / 2 ^ 53 -> Rabs (1 + d - 1) <= grown 1.
Proof. unfold grown. replace (_ - _) with d by ring. lra. Qed.
Definition twelfth := 6004799503160661 / 72057594037927936.
Lemma fourth_quotient a b c d e : float64 a -> float64 b -> float64 c -> float64 d -> 0 < e <= 1 -> exists s t, Rabs (s - 1) <= grown 5 /\ Rabs (t
  - 1) <= grown 5 /\ Rabs (rounded (rounded (twelfth * rounded (rounded (d - c) + rounded (8 * rounded (a - b)))) / e) - 1 / 12 * ((d - c) * s + 8
  * ((a - b) * t)) / e) <= 3 / 2 ^ 100 / e.
Proof.
  intros A B C D E. assert (F8 : float64 (8 * rounded _)) by (replace (8 * _) with (2 * (2 * (2 * rounded (a - b)))) by ring; repeat apply
    twice_float64; apply rounded_is_float64). rewrite (kept _ F8).
  destruct (rounded_sum (rounded (d - c)) _ (rounded_is_float64 _) F8) as (d3 & D3 & ->). destruct (difference_near a b A B) as (d1 & D1 & ->).
    destruct (difference_near d c D C) as (d2 & D2 & ->).
  set (g := 12 * twelfth - 1). assert (Rabs g <= / 2 ^ 53) by (unfold g, twelfth; apply Rabs_le; lra). assert (K : twelfth = (1 + g) / 12) by (unfold
    g; field). clearbody g. rewrite K.
  destruct (rounded_near ((1 + g) / 12 * (((d - c) * (1 + d2) + 8 * ((a - b) * (1 + d1))) * (1 + d3)))) as (d4 & y & D4 & Y & ->).
  set (z := _ / 12 * _ * _). destruct (rounded_near ((z + y) / e)) as (d5 & x & D5 & X & ->).
    exists ((1 + d2) * (1 + d3) * (1 + g) * (1 + d4) * (1 + d5)), ((1 + d1) * (1 + d3) * (1 + g) * (1 + d4) * (1 + d5)).
  split; [|split]; [repeat (apply grows; auto); apply grows_once; assumption..|].
  replace (_ - _) with (y / e * (1 + d5) + x) by (unfold z; field; lra). assert (1 <= / e) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra).
  at_most_by Rabs_triang. unfold Rdiv. rewrite !Rabs_mult, (Rabs_pos_eq (/ e)) by lra.
    assert (Rabs (1 + d5) <= 2) by (both_ways D5; apply Rabs_le; lra).
  assert (Rabs y * / e * Rabs (1 + d5) <= / 2 ^ 100 * / e * 2) by (repeat apply Rmult_le_compat; try apply Rmult_le_pos; try apply Rabs_pos; lra).
    nra.
Qed.

Definition height_error := 76/10 / 2 ^ 53.
Definition forward_bound (L alpha e : R) := e / 2 * L ^ 2 + arguments_part L alpha (e / 2) + evaluation_part L (e / 2).
Definition fourth_bound (L alpha beta e : R) := e ^ 4 / 30 * L ^ 5 + L * (8 * alpha + beta) / (6 * e) * (1 + grown 5) + 12 / 2 ^ 53 / e * (1 +
  grown 5) + 5 / 3 * L * grown 5.
(* A wave of at most one, and its slope. *)
Definition wave (k a w : R) := sin (PI * (k * w)) * a.
Definition wave_slope (k a w : R) := PI * k * (cos (PI * (k * w)) * a).
Lemma forward_float64 a k x y e alpha A B : Rabs a <= 1 -> 0 < k -> 0 < e <= 1 -> y = x \/ y = x - e -> float64 A -> float64 B -> sample (wave k
  a) height_error alpha (e + y) A -> sample (wave k a) height_error alpha y B -> Rabs (rounded (rounded (A - B) / e) - wave_slope k a x) <=
  forward_bound (PI * k) alpha e.
Proof.
  intros Ha K E Z FA FB (p & P & HA) (m & M & HB). pose proof sine_is_steep _ a k K Ha (fun _ => eq_refl).
    destruct (orders_of_a_sine _ a k x e Ha ltac:(lra) (fun _ => eq_refl) ltac:(lra)) as [T _].
  pose proof quotient_in_v A B (e / 2) FA FB ltac:(lra) as Q. replace (_ * _) with e in Q by field.
  apply (three_parts (wave k a) _ (y + e / 2) (e / 2) p m alpha A B); try assumption; [lra | replace (e / 2 + _) with (e + y) by field; exact P |
    replace (y + e / 2 - e / 2) with y by ring; exact M | replace (_ * _) with e by field; exact Q |].
  replace (_ + _) with (e + y) by field. replace (y + e / 2 - e / 2) with y by ring. replace (_ * _) with e by field.
    unfold forward in T. destruct Z as [-> | ->]; [specialize (T 1 (or_introl eq_refl)); rewrite !Rmult_1_l, Rplus_comm in T; exact T | specialize (T
      _ (or_intror eq_refl))].
  replace (_ + _) with x by ring. replace (_ + _) with (x - e) in T by ring.
    replace (_ - wave k a _) with (-1 * (wave k a (x - e) - wave k a x)) by ring. exact T.
Qed.
Lemma fourth_float64 a k x e alpha beta A B C D q : Rabs a <= 1 -> 0 < k -> 0 < e <= 1 -> float64 A -> float64 B -> float64 C -> float64 D ->
  sample (wave k a) height_error alpha (e + x) A -> sample (wave k a) height_error alpha (x - e) B -> sample (wave k a) height_error beta (2 * e +
  x) C -> sample (wave k a) height_error beta (x - 2 * e) D -> q = rounded (rounded (twelfth * rounded (rounded (D - C) + rounded (8 * rounded (A
  - B)))) / e) -> Rabs (q - wave_slope k a x) <= fourth_bound (PI * k) alpha beta e.
Proof.
  intros Ha K E FA FB FC FD HA HB HC HD ->. pose proof sine_is_steep _ a k K Ha (fun _ => eq_refl) as S.
    destruct (orders_of_a_sine _ a k x e Ha ltac:(lra) (fun _ => eq_refl) ltac:(lra)) as [_ T]. fold (wave_slope k a x) in T.
  destruct (fourth_quotient A B C D e FA FB FC FD E) as (s & t & G & G' & Q).
    pose proof fourth_of_any_height _ _ x e _ _ _ _ _ _ _ _ s t S ltac:(lra) G G' HA HB HC HD as R.
  generalize (through _ _ _ _ _ (through _ _ _ _ _ Q R) T). assert (0 < / e) by (apply Rinv_0_lt_compat; lra). assert (0 <= grown 5) by (unfold
    grown; lra).
  unfold fourth_bound, height_error. replace (_ / (6 * e)) with (114 / 10 / 2 ^ 53 * / e + PI * k * (8 * alpha + beta) / (6 * e)) by (field; lra).
  nra.
Qed.

(* Where height is computed as a wave's are. *)
Definition computed_wave (height : R -> R) (k a w : R) := float64 (height w) /\ Rabs (height w - wave k a w) <= height_error.
(* In u: nothing wraps, or k is even, when a whole turn less is the same height. *)
Definition in_turn (k x : R) := 0 <= rounded x < 1 \/ exists n : Z, k = IZR (2 * n).
Lemma sample_in_turn height k a x : Rabs x <= 2 -> in_turn k x -> let m := rounded (rounded x - whole_below (rounded x)) in computed_wave height k
  a m -> sample (wave k a) height_error (4 / 2 ^ 53) x (height m).
Proof.
  intros X [N | [j ->]] m [_ A].
  - exists m. split; auto. unfold m. rewrite not_wrapped by lra. at_most_by (rounded_error x 2); lra.
  - destruct (wrapped_near x X) as [n P]. exists (m + IZR n). split; auto. replace (wave _ a _) with (wave (IZR (2 * j)) a m); auto.
    unfold wave. rewrite <- (proj1 (turn _ (j * n))). f_equal. f_equal. rewrite !mult_IZR. ring.
Qed.
Lemma sample_here height k a x alpha : 0 <= alpha -> computed_wave height k a x -> sample (wave k a) height_error alpha x (height x).
Proof. intros P [_ A]. exists x. split; [rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; exact P | lra]. Qed.
Lemma sample_moved height k a x y : float64 x -> float64 y -> 0 <= x -> 0 <= y -> (computed_wave height k a (rounded (y + x)) -> sample (wave k a)
  height_error ((x + y) / 2 ^ 53) (y + x) (height (rounded (y + x)))) /\ (computed_wave height k a (rounded (x - y)) -> sample (wave k a)
  height_error ((x + y) / 2 ^ 53) (x - y) (height (rounded (x - y)))).
Proof.
  intros X Y Px Py. destruct (rounded_sum y x Y X) as (d & D & E). destruct (difference_near x y X Y) as (c & C & F).
  split; intros [_ A]; eexists; (split; [|exact A]); [rewrite E; replace (_ - _) with ((y + x) * d) by ring | rewrite F;
    replace (_ - _) with ((x - y) * c) by ring];
    rewrite Rabs_mult; factors; try assumption; apply Rabs_le; lra.
Qed.

Theorem forward_and_fourth_order__forward_in_float64_u height a u v k_u k_v epsilon : let computed_at := computed_wave (fun w => height w v k_u
  k_v) k_u a in Rabs a <= 1 -> 0 < k_u -> 0 <= u <= 1 -> 0 < epsilon <= 1 -> in_turn k_u (epsilon + u) -> computed_at u -> computed_at
  (forward_any_float64.u_plus u epsilon) -> Rabs (forward_any_float64.h_u height u v k_u k_v epsilon - wave_slope k_u a u) <= forward_bound (PI *
  k_u) (4 / 2 ^ 53) epsilon.
Proof.
  intros at_ A K U E T Q P. apply (forward_float64 a k_u u u epsilon _ _ _ A K E (or_introl eq_refl) (proj1 P) (proj1 Q)); [| apply (sample_here (fun
    w => height w v k_u k_v)); [lra | auto]].
  apply (sample_in_turn (fun w => height w v k_u k_v)); [apply Rabs_le; lra | auto | auto].
Qed.
(* In v backward where v + epsilon is above 1; k is the wave's number there: rings have twice theirs. *)
Theorem forward_and_fourth_order__forward_in_float64_v height a u v k_u k_v k epsilon : let computed_at := computed_wave (fun w => height u w k_u
  k_v) k a in Rabs a <= 1 -> 0 < k -> float64 v -> float64 epsilon -> 0 <= v <= 1 -> 0 < epsilon <= 1 -> computed_at v -> computed_at
  (forward_any_float64.stepped v epsilon) -> Rabs (forward_any_float64.h_v height u v k_u k_v epsilon - wave_slope k a v) <= forward_bound (PI *
  k) ((v + epsilon) / 2 ^ 53) epsilon.
Proof.
  intros at_ A K V F B E Q P. assert (N : 0 <= (v + epsilon) / 2 ^ 53) by lra.
    destruct (sample_moved (fun w => height u w k_u k_v) k a v epsilon V F ltac:(lra) ltac:(lra)) as [Sp Sm].
  unfold forward_any_float64.h_v, forward_any_float64.h_v_plus, forward_any_float64.h_here. unfold forward_any_float64.stepped in *.
    destruct Rle_dec.
  - exact (forward_float64 a k v v epsilon _ _ _ A K E (or_introl eq_refl) (proj1 P) (proj1 Q) (Sp P) (sample_here _ _ _ _ _ N Q)).
  - apply (forward_float64 a k v _ epsilon _ _ _ A K E (or_intror eq_refl) (proj1 Q) (proj1 P)); auto. replace (epsilon + _) with v by ring. exact
    (sample_here _ _ _ _ _ N Q).
Qed.
Theorem forward_and_fourth_order__fourth_in_float64_u height a u v k_u k_v epsilon : let computed_at := computed_wave (fun w => height w v k_u
  k_v) k_u a in Rabs a <= 1 -> 0 < k_u -> float64 epsilon -> 0 <= u <= 1 -> 0 < epsilon <= 1 / 2 -> in_turn k_u (epsilon + u) -> in_turn k_u (u -
  epsilon) -> in_turn k_u (2 * epsilon + u) -> in_turn k_u (u - 2 * epsilon) -> computed_at (central4_any_float64.u_plus u epsilon) -> computed_at
  (central4_any_float64.u_minus u epsilon) -> computed_at (central4_any_float64.u_plus_2 u epsilon) -> computed_at (central4_any_float64.u_minus_2
  u epsilon) -> Rabs (central4_any_float64.h_u height u v k_u k_v epsilon - wave_slope k_u a u) <= fourth_bound (PI * k_u) (4 / 2 ^ 53) (4 / 2 ^
  53) epsilon.
Proof.
  intros at_ A K F U E T1 T2 T3 T4 P M P2 M2. pose proof kept _ (twice_float64 _ F) as Q.
    unfold central4_any_float64.u_plus_2, central4_any_float64.u_minus_2 in P2, M2. rewrite Q in P2, M2.
  apply (fourth_float64 a k_u u epsilon _ _ _ _ _ _ _ A K ltac:(lra) (proj1 P) (proj1 M) (proj1 P2) (proj1 M2)); [| | | | central4_any_float64.lines;
    rewrite Q; reflexivity];
  apply (sample_in_turn (fun w => height w v k_u k_v)); first [assumption | apply Rabs_le; lra].
Qed.
(* Where a far sample would leave the chart, it is the central difference in v. *)
Theorem forward_and_fourth_order__fourth_in_float64_v height a u v k_u k_v k epsilon : let computed_at := computed_wave (fun w => height u w k_u
  k_v) k a in float64 v -> float64 epsilon -> 0 < epsilon -> (Rabs a <= 1 -> 0 < k -> 2 * epsilon <= v -> 2 * epsilon + v <= 1 -> computed_at
  (rounded (epsilon + v)) -> computed_at (rounded (v - epsilon)) -> computed_at (rounded (2 * epsilon + v)) -> computed_at (rounded (v - 2 *
  epsilon)) -> Rabs (central4_any_float64.h_v height u v k_u k_v epsilon - wave_slope k a v) <= fourth_bound (PI * k) ((v + epsilon) / 2 ^ 53) ((v
  + 2 * epsilon) / 2 ^ 53) epsilon) /\ (1 < rounded (2 * epsilon + v) \/ 0 < rounded (2 * epsilon - v) -> central4_any_float64.h_v height u v k_u
  k_v epsilon = central_any_float64.h_v height u v k_u k_v epsilon).
Proof.
  intros at_ V F E. pose proof kept _ (twice_float64 _ F) as Q. split.
  2: { central4_any_float64.lines; central_any_float64.lines. rewrite Q. destruct both as [H | _]; nra. }
  intros A K B W P M P2 M2. destruct (in_order v epsilon ltac:(lra)) as [O _]. destruct (in_order v (2 * epsilon) ltac:(lra)) as [O2 _].
    pose proof proj1 (up_to_1 (epsilon + v)) ltac:(lra) as O'. pose proof proj1 (up_to_1 (2 * epsilon + v)) W as O2'.
  destruct (sample_moved (fun w => height u w k_u k_v) k a v epsilon V F ltac:(lra) ltac:(lra)) as [Sp Sm].
    destruct (sample_moved (fun w => height u w k_u k_v) k a v (2 * epsilon) V (twice_float64 _ F) ltac:(lra) ltac:(lra)) as [Sp2 Sm2].
  central4_any_float64.lines. rewrite Q, !Rmin_right, !Rmax_right by lra. destruct both as [_ | [N | N]]; [| lra |].
  2: { replace (_ - _) with (- (v - 2 * epsilon)) in N by ring. rewrite rounded_opp in N. lra. }
  exact (fourth_float64 a k v epsilon _ _ _ _ _ _ _ A K ltac:(lra) (proj1 P) (proj1 M) (proj1 P2) (proj1 M2) (Sp P) (Sm M) (Sp2 P2) (Sm2 M2) eq_refl).
Qed.

(* Sine's heights are so, ridges' on one side of its creases, of which s is the sign of sine, and rings'; and their slopes are the waves'. *)
Theorem forward_and_fourth_order__heights_in_float64 u v k_u k_v : carried k_u u -> carried k_v v -> let a_u := sin (PI * (k_v * v)) in let a_v :=
  sin (PI * (k_u * u)) in (computed_wave (fun w => height_sine_float64.h w v k_u k_v) k_u a_u u /\ computed_wave (fun w => height_sine_float64.h u
  w k_u k_v) k_v a_v v) /\ (gradient_sine.h_u u v k_u k_v = wave_slope k_u a_u u /\ gradient_sine.h_v u v k_u k_v = wave_slope k_v a_v v) /\
  (forall s, s = 1 \/ s = -1 -> 0 <= s * height_sine.h u v k_u k_v -> computed_wave (fun w => height_ridges_float64.h w v k_u k_v) k_u (s * a_u) u
  /\ computed_wave (fun w => height_ridges_float64.h u w k_u k_v) k_v (s * a_v) v) /\ (forall s, s = 1 \/ s = -1 -> 0 < s * height_sine.h u v k_u
  k_v -> gradient_ridges.h_u u v k_u k_v = wave_slope k_u (s * a_u) u /\ gradient_ridges.h_v u v k_u k_v = wave_slope k_v (s * a_v) v) /\ forall
  k, float64 k -> 2 * k = k_v -> computed_wave (fun w => height_rings_float64.h w k) k_v 1 v /\ gradient_rings.h_v v k = wave_slope k_v 1 v.
Proof.
  intros U V a_u a_v. pose proof sine_height_near _ _ _ _ U V as N. unfold computed_wave, wave, wave_slope, height_sine.h, a_u, a_v in *. split;
    [|split; [|split; [|split]]].
  - split; (split; [apply rounded_is_float64 |]); [| rewrite Rmult_comm]; exact N.
  - unfold_fields. lra.
  - intros s S H. rewrite (ridges_height s) by assumption. assert (F : float64 (s * height_sine_float64.h u v k_u k_v)) by (destruct S as [-> | ->];
    [rewrite Rmult_1_l | replace (-1 * _) with (- height_sine_float64.h u v k_u k_v) by ring; apply generic_format_opp]; apply rounded_is_float64).
    split; (split; [exact F|]); apply (other_side s _ _ _ _ _ S eq_refl) with (2 := N); ring.
  - intros s S H. rewrite (sign_of_height s _ S H). unfold_fields. lra.
  - intros k F <-. destruct (rings_height_near k F v V). rewrite Rmult_1_r. split; auto. unfold_fields. ring.
Qed.

(* False variants: of heights that are no wave's, which a constant is not; and of ridges beyond a crease. *)
Lemma quarter_is_float64 : float64 (1/4).
Proof. replace (1/4) with (bpow radix2 (-2)) by (simpl; lra). apply power_float64. easy. Qed.
(* A wave of 0, and what holds of it or of figures. *)
Lemma still k w : computed_wave (fun _ => 0) k 0 w.
Proof. split; [apply generic_format_0|]. unfold wave. rewrite Rmult_0_r, Rminus_0_r, Rabs_R0. unfold height_error. lra. Qed.
Ltac held := solve [apply still | intro; apply still | exact one_is_float64 | exact half_is_float64 | exact quarter_is_float64 | lra | split; lra
  | rewrite ?Rabs_R0, ?Rabs_R1; lra | right; exists 1%Z; reflexivity | intro; right; exists 1%Z; reflexivity].
Ltac fed H := repeat (specialize (H ltac:(held))); revert H.
Ltac flat := rewrite ?Rminus_eq_0, ?rounded_0, ?Rmult_0_r, ?rounded_0, ?Rplus_0_l, ?rounded_0, ?Rmult_0_r, ?rounded_0; unfold Rdiv at 1;
  rewrite Rmult_0_l, rounded_0.
Ltac too_steep H := revert H; unfold wave_slope, forward_bound, arguments_part, evaluation_part, kappa_unclamped, fourth_bound, grown;
  apply Rlt_not_le;
  interval with (i_prec 80).
Theorem forward_and_fourth_order__forward_in_float64_u__false : ~ forall height a u v k_u k_v epsilon, Rabs a <= 1 -> 0 < k_u -> 0 <= u <= 1 -> 0
  < epsilon <= 1 -> in_turn k_u (epsilon + u) -> Rabs (forward_any_float64.h_u height u v k_u k_v epsilon - wave_slope k_u a u) <= forward_bound
  (PI * k_u) (4 / 2 ^ 53) epsilon.
Proof.
  intro H. specialize (H (fun _ _ _ _ => 0) 1 1 0 2 0 (1/4)). fed H.
    unfold forward_any_float64.h_u, forward_any_float64.h_u_plus, forward_any_float64.h_here. intro K. too_steep K.
Qed.
Theorem forward_and_fourth_order__forward_in_float64_v__false : ~ forall height a u v k_u k_v k epsilon, Rabs a <= 1 -> 0 < k -> float64 v ->
  float64 epsilon -> 0 <= v <= 1 -> 0 < epsilon <= 1 -> Rabs (forward_any_float64.h_v height u v k_u k_v epsilon - wave_slope k a v) <=
  forward_bound (PI * k) ((v + epsilon) / 2 ^ 53) epsilon.
Proof.
  intro H. specialize (H (fun _ _ _ _ => 0) 1 0 1 0 0 (1/4) 1). fed H.
    unfold forward_any_float64.h_v, forward_any_float64.h_v_plus, forward_any_float64.h_here.
  destruct Rle_dec; intro K; too_steep K.
Qed.
Theorem forward_and_fourth_order__fourth_in_float64_u__false : ~ forall height a u v k_u k_v epsilon, Rabs a <= 1 -> 0 < k_u -> float64 epsilon ->
  0 <= u <= 1 -> 0 < epsilon <= 1 / 2 -> in_turn k_u (epsilon + u) -> in_turn k_u (u - epsilon) -> Rabs (central4_any_float64.h_u height u v k_u
  k_v epsilon - wave_slope k_u a u) <= fourth_bound (PI * k_u) (4 / 2 ^ 53) (4 / 2 ^ 53) epsilon.
Proof. intro H. specialize (H (fun _ _ _ _ => 0) 1 1 0 2 0 (1/4)). fed H. central4_any_float64.lines. intro K. too_steep K. Qed.
Theorem forward_and_fourth_order__fourth_in_float64_v__false : ~ forall height a u v k_u k_v k epsilon, float64 v -> float64 epsilon -> 0 <
  epsilon -> Rabs a <= 1 -> 0 < k -> 2 * epsilon <= v -> 2 * epsilon + v <= 1 -> Rabs (central4_any_float64.h_v height u v k_u k_v epsilon -
  wave_slope k a v) <= fourth_bound (PI * k) ((v + epsilon) / 2 ^ 53) ((v + 2 * epsilon) / 2 ^ 53) epsilon.
Proof.
  intro H. specialize (H (fun _ _ _ _ => 0) 1 0 (1/2) 0 0 2 (1/4)). fed H.
  central4_any_float64.lines. destruct both; flat; intro K; too_steep K.
Qed.
Theorem forward_and_fourth_order__heights_in_float64__false : ~ forall u v k_u k_v, carried k_u u -> carried k_v v ->
  computed_wave (fun w => height_ridges_float64.h w v k_u k_v) k_u (sin (PI * (k_v * v))) u.
Proof.
  intro H. assert (C : forall n, (0 < n < 4)%Z -> carried 1 (IZR n / 2)).
  { intros n N. assert (1 <= IZR n <= 4) by (split; apply IZR_le; lia). split; [exact one_is_float64|]. split; [replace (_ / _) with (IZR n * bpow
    radix2 (-1)) by easy; apply whole_is_float64; lia|].
    generalize (bpow_le radix2 (-969) (-1) ltac:(easy)). simpl (bpow radix2 (-1)). rewrite Rabs_pos_eq by lra. lra. }
  destruct (H _ _ _ _ (C 3%Z ltac:(lia)) (C 1%Z ltac:(lia))) as [_ K]. unfold height_ridges_float64.h in K. both_ways K.
    match type of K with _ <= Rabs ?x - ?y <= _ => generalize (Rabs_pos x); assert (y < - / 2) by interval end. unfold height_error in K. lra.
Qed.

(* Points *)
Ltac each_held := cbv zeta; repeat (split; [held|]); held.
Theorem forward_and_fourth_order__forward_in_float64_u__point : exists (height : R -> R -> R -> R -> R) a u v k_u k_v epsilon, let computed_at :=
  computed_wave (fun w =>
  height w v k_u k_v) k_u a in Rabs a <= 1 /\ 0 < k_u /\ 0 <= u <= 1 /\ 0 < epsilon <= 1 /\ in_turn k_u (epsilon + u) /\ computed_at u /\
  computed_at (forward_any_float64.u_plus u epsilon).
Proof. exists (fun _ _ _ _ => 0), 0, 0, 0, 2, 0, 1. each_held. Qed.
Theorem forward_and_fourth_order__forward_in_float64_v__point : exists (height : R -> R -> R -> R -> R) a u v k_u k_v k epsilon, let computed_at :=
  computed_wave (fun w =>
  height u w k_u k_v) k a in Rabs a <= 1 /\ 0 < k /\ float64 v /\ float64 epsilon /\ 0 <= v <= 1 /\ 0 < epsilon <= 1 /\ computed_at v /\
  computed_at (forward_any_float64.stepped v epsilon).
Proof. exists (fun _ _ _ _ => 0), 0, 0, 1, 0, 0, 1, 1. each_held. Qed.
Theorem forward_and_fourth_order__fourth_in_float64_u__point : exists (height : R -> R -> R -> R -> R) a u v k_u k_v epsilon, let computed_at :=
  computed_wave (fun w =>
  height w v k_u k_v) k_u a in Rabs a <= 1 /\ 0 < k_u /\ float64 epsilon /\ 0 <= u <= 1 /\ 0 < epsilon <= 1 / 2 /\ (forall x, in_turn k_u x) /\
  forall w, computed_at w.
Proof. exists (fun _ _ _ _ => 0), 0, 0, 0, 2, 0, (1/2). each_held. Qed.
Theorem forward_and_fourth_order__fourth_in_float64_v__point : exists (height : R -> R -> R -> R -> R) a u v k_u k_v k epsilon, float64 v /\ float64
  epsilon /\ 0 < epsilon
  /\ Rabs a <= 1 /\ 0 < k /\ 2 * epsilon <= v /\ 2 * epsilon + v <= 1 /\ forall w, computed_wave (fun w => height u w k_u k_v) k a w.
Proof. exists (fun _ _ _ _ => 0), 0, 0, (1/2), 0, 0, 1, (1/4). each_held. Qed.
Theorem forward_and_fourth_order__heights_in_float64__point : exists u v k_u k_v, carried k_u u /\ carried k_v v.
Proof. exists 0, 0, 1, 1. assert (C : carried 1 0) by (split; [exact one_is_float64 | split; [apply generic_format_0|]]; rewrite Rmult_0_r, Rabs_R0;
  lra). easy. Qed.
