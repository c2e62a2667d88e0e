(* The three parts of the error of the central difference, as float64 carries it out: truncation, the rounded arguments, the evaluation. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Clamped Float Float64 RoundedHalfTurns Rounding RoundedGradient Binades Fields.
Open Scope R_scope.

Definition kappa_unclamped := 2 / 2 ^ 53 + (/ 2 ^ 53) ^ 2.
Lemma rounded_near x : exists d y, Rabs d <= / 2 ^ 53 /\ Rabs y <= / 2 ^ 100 /\ rounded x = x * (1 + d) + y.
Proof.
  destruct (rounding x) as (d & y & D & Y & _ & E). exists d, y. repeat split; [exact D | | exact E]. at_most_by Y. replace (/ 2 ^
    100) with (bpow radix2 (-100)) by (simpl; lra). apply bpow_le. easy.
Qed.
Lemma half_near x : float64 x -> Rabs (rounded (1 / 2 * x) - x / 2) <= 2 / 2 ^ 100.
Proof.
  intro F. replace (1 / 2 * x) with (/ 2 * x) by field. replace (x / 2) with (/ 2 * x) by field. destruct (Rle_lt_dec (bpow radix2 (-1021)) (Rabs
    x)) as [L|L].
  - rewrite half_float64, (kept x F) by exact L. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra.
  - eapply Rle_trans; [apply (rounded_error _ (/ 2 ^ 53)) | lra]. rewrite Rabs_mult, Rabs_pos_eq by lra.
    assert (P : bpow radix2 (-53) = / 2 ^ 53) by (simpl; lra). generalize (bpow_le radix2 (-1021) (-53) ltac:(easy)) (Rabs_pos x). lra.
Qed.
(* The difference of two computed heights, over 2 epsilon: two roundings, and what may underflow. *)
Definition within_two_roundings (q D e : R) := exists t, Rabs (t - 1) <= kappa_unclamped /\ Rabs (q - D * t) <= 4 / 2 ^ 100 / e.
Lemma divided_by_the_step a b x q e : float64 a -> float64 b -> 0 < e <= 1 -> Rabs (x - rounded (a - b) / 2) <= 2 / 2 ^ 100 -> q = rounded (x / e) ->
  within_two_roundings q ((a - b) / (2 * e)) e.
Proof.
  intros A B E X ->. destruct (difference_near a b A B) as (d & D & Y). destruct (rounded_near (x / e)) as (d2 & z & D2 & Z & ->). exists ((1 + d) * (1
    + d2)).
  assert (I : 1 <= / e) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra). both_ways D. both_ways D2. split.
  - apply Rabs_le. unfold kappa_unclamped. split; nra.
  - replace (_ - _) with ((x - rounded (a - b) / 2) / e * (1 + d2) + z) by (rewrite Y; field; lra). at_most_by Rabs_triang. unfold Rdiv at 1.
    rewrite !Rabs_mult, (Rabs_pos_eq (/ e)), (Rabs_pos_eq (1 + d2)) by lra. generalize (Rmult_le_pos _ (/ e) (Rabs_pos (x - rounded (a - b) / 2))). nra.
Qed.
Lemma quotient_in_u a b e : float64 a -> float64 b -> 0 < e <= 1 -> within_two_roundings (rounded (rounded (1 / 2 * rounded (a - b)) / e)) ((a -
  b) / (2 * e)) e.
Proof. intros A B E. eapply divided_by_the_step; [exact A | exact B | exact E | apply half_near, rounded_is_float64 | reflexivity]. Qed.
Lemma quotient_in_v a b e : float64 a -> float64 b -> 0 < e <= 1 -> within_two_roundings (rounded (rounded (a - b) / (2 * e))) ((a - b) / (2 * e))
  e.
Proof.
  intros A B E. eapply divided_by_the_step; [exact A | exact B | exact E | at_most_by no_error; lra | f_equal; field; lra].
Qed.
(* Of a height h that is at most L steep, whose computed values a and b are within 76/10 2^-53 of h at p and m, alpha off: the difference is within
   what the arguments' rounding and the evaluation cost of the exact one. *)
Definition arguments_part (L alpha e : R) := L * alpha / e * (1 + kappa_unclamped).
Definition evaluation_part (L e : R) := 8 / 2 ^ 53 / e * (1 + kappa_unclamped) + L * kappa_unclamped.
Lemma argument_near w e : float64 w -> float64 e -> 0 <= e <= w -> Rabs (rounded (e + w) - (e + w)) <= (w + e) / 2 ^ 53 /\ Rabs (rounded (w - e) -
  (w - e)) <= (w + e) / 2 ^ 53.
Proof.
  intros W E B. destruct (rounded_sum e w E W) as (d & D & ->). destruct (difference_near w e W E) as (c & C & ->). split; [replace (_ - _) with ((w +
    e) * d) by ring | replace (_ - _) with ((w - e) * c) by ring];
    rewrite Rabs_mult, Rabs_pos_eq by lra; factors; lra.
Qed.
Definition steep h (L : R) := exists h1, derives_to h h1 /\ forall x, Rabs (h1 x) <= L.
Lemma sine_is_steep (h : R -> R) (a k : R) : 0 < k -> Rabs a <= 1 -> (forall x, h x = sin (PI * (k * x)) * a) -> steep h (PI * k).
Proof.
  intros K A E. exists (fun x => PI * k * (cos (PI * (k * x)) * a)). split; intro x.
  - apply is_derive_ext with (fun x => sin (PI * (k * x)) * a); [intro; symmetry; apply E | auto_derive; trivial; ring].
  - apply at_most; [generalize PI_RGT_0; nra | apply cosine_at_most_1 | exact A].
Qed.
Lemma three_parts (h : R -> R) (L w e p m alpha a b q slope truncation : R) : steep h L -> 0 < e <= 1 ->
  Rabs (p - (e + w)) <= alpha -> Rabs (m - (w - e)) <= alpha -> within_two_roundings q ((a - b) / (2 * e)) e -> Rabs (a - h p) <= 76/10 / 2 ^ 53 ->
    Rabs (b - h m) <= 76/10 / 2 ^ 53 ->
  Rabs ((h (e + w) - h (w - e)) / (2 * e) - slope) <= truncation -> Rabs (q - slope) <= truncation + arguments_part L alpha e + evaluation_part L e.
Proof.
  intros (h1 & D & S) B P M (t & K & Q) A1 B1 T.
  generalize (roundoff_bound__of_any_height h h1 L (e + w) (w - e) (2 * e) kappa_unclamped (76/10 / 2 ^ 53) alpha _ _ a b t D S ltac:(lra) ltac:(ring)
    K P M A1 B1). intro R.
  assert (I : 0 < / e) by (apply Rinv_0_lt_compat; lra). assert (Kp : 0 <= kappa_unclamped) by (unfold kappa_unclamped; lra).
  replace (2 * (76 / 10 / 2 ^ 53 + L * alpha) / (2 * e) * (1 + kappa_unclamped) + L * kappa_unclamped) with (arguments_part L alpha e +
    evaluation_part L e - 4/10 / 2 ^ 53 / e * (1 + kappa_unclamped)) in R
    by (unfold arguments_part, evaluation_part; field; lra).
  assert (X : 4 / 2 ^ 100 / e <= 4/10 / 2 ^ 53 / e * (1 + kappa_unclamped)) by nra.
  generalize (through _ _ _ _ _ Q (through _ _ _ _ _ R T)). lra.
Qed.
Definition error_bound (L w e : R) := e ^ 2 / 6 * L ^ 3 + arguments_part L ((w + e) / 2 ^ 53) e + evaluation_part L e.

(* The arguments where nothing wraps or clamps. *)
Lemma in_order w e : 0 <= e <= w -> 0 <= rounded (w - e) <= rounded (e + w).
Proof. split; [rewrite <- rounded_0|]; apply round_le; try typeclasses eauto; lra. Qed.

(* Nothing wraps or clamps, and nothing of k u underflows: where u and v are looked at. *)
Definition sampled_in_u (k u e : R) := float64 u /\ float64 e /\ 0 < k /\ 0 < e <= u /\ rounded (e + u) < 1 /\ carried k (rounded (e + u)) /\
  carried k (rounded (u - e)).
Definition sampled_in_v (k v e : R) := float64 v /\ float64 e /\ 0 < k /\ 0 < e <= v /\ e + v <= 1 /\ carried k (rounded (e + v)) /\ carried k
  (rounded (v - e)).
Lemma arguments_in_u k u e : sampled_in_u k u e -> central_any_float64.u_plus u e = rounded (e + u) /\ central_any_float64.u_minus u e = rounded
  (u - e).
Proof. intros (_ & _ & _ & B & W & _). pose proof in_order u e ltac:(lra) as O. split; apply not_wrapped; lra. Qed.

(* Sine, ridges and rings *)
Lemma sine_height_near u v k_u k_v : carried k_u u -> carried k_v v -> Rabs (height_sine_float64.h u v k_u k_v - height_sine.h u v k_u k_v) <=
  76/10 / 2 ^ 53.
Proof.
  intros U V. destruct (factors_near _ _ U) as (Su & _). destruct (factors_near _ _ V) as (Sv & _).
  eapply Rle_trans; [exact (times_error _ _ _ _ 1 1 _ _ (sine_at_most_1 _) (sine_at_most_1 _) Su Sv) | lra].
Qed.
Ltac unfold_slopes := unfold height_sine.h, height_rings.h; gradient_sine.lines; gradient_rings.lines.
Ltac truncation H slope e := repeat match type of H with _ /\ _ /\ _ => destruct H as [_ H] end;
  repeat match type of H with context [Derive ?f ?x] => rewrite (is_derive_unique f x slope) in H by (auto_derive; trivial; unfold_slopes; ring) end;
  destruct H as [H I1]; unfold Rdiv in *; revert H I1; unfold_slopes; replace (/ (2 * e)) with (1 / 2 * / e) in * by (field; lra); intros; apply
    Rabs_le; split; lra.
Lemma sine_in_u u v k_u k_v epsilon : sampled_in_u k_u u epsilon -> carried k_v v -> Rabs (central_any_float64.h_u height_sine_float64.h u v k_u
  k_v epsilon - gradient_sine.h_u u v k_u k_v) <= error_bound (PI * k_u) u epsilon.
Proof.
  intros I V. destruct (arguments_in_u _ _ _ I) as [P M]. destruct I as (U & E & K & B & W & Cp & Cm). pose proof proj2 (up_to_1 _) W as W1. pose
    proof truncation_bound__sine epsilon k_u k_v u v ltac:(lra) ltac:(lra) W1 K as T.
  destruct (argument_near u epsilon U E ltac:(lra)) as [Ap Am]. unfold_difference. rewrite P, M.
  refine (three_parts (fun w => height_sine.h w v k_u k_v) _ _ _ _ _ _ _ _ _ _ _ (sine_is_steep _ _ _ K (sine_at_most_1 _) (fun _ => eq_refl)) _ Ap Am
    (quotient_in_u _ _ _ _ _ _) (sine_height_near _ _ _ _ Cp V) (sine_height_near _ _ _ _ Cm V) _);
    try apply rounded_is_float64; [lra..| truncation T (gradient_sine.h_u u v k_u k_v) epsilon].
Qed.
(* In v of any height h whose computed values are near it: sine and rings. *)
Lemma difference_in_v (height : R -> R -> R -> R -> R) (h : R -> R) (L u v k_u k_v k epsilon slope : R) : sampled_in_v k v epsilon -> steep h L ->
  (forall w, carried k w -> Rabs (height u w k_u k_v - h w) <= 76/10 / 2 ^ 53 /\ float64 (height u w k_u k_v)) -> Rabs ((h (epsilon + v) - h (v -
    epsilon)) / (2 * epsilon) - slope) <= epsilon ^ 2 / 6 * L ^ 3 ->
  Rabs (central_any_float64.h_v height u v k_u k_v epsilon - slope) <= error_bound L v epsilon.
Proof.
  intros (V & E & K & B & W & Cp & Cm) S N T. destruct (in_order v epsilon ltac:(lra)) as [M _]. destruct (arguments_in_v v epsilon _ _ E eq_refl eq_refl
    (proj1
    (up_to_1 _) W) M) as (P1 & M1 & S1). destruct (argument_near v epsilon V E ltac:(lra)) as [Ap Am].
  unfold_difference. rewrite P1, M1, S1. destruct (N _ Cp) as [Np Fp].
    destruct (N _ Cm) as [Nm Fm].
  refine (three_parts h L v epsilon _ _ _ _ _ _ _ _ S _ Ap Am (quotient_in_v _ _ _ Fp Fm _) Np Nm T); lra.
Qed.
Lemma sine_in_v u v k_u k_v epsilon : sampled_in_v k_v v epsilon -> carried k_u u -> Rabs (central_any_float64.h_v height_sine_float64.h u v k_u
  k_v epsilon - gradient_sine.h_v u v k_u k_v) <= error_bound (PI * k_v) v epsilon.
Proof.
  intros I U. apply (difference_in_v _ (fun w => height_sine.h u w k_u k_v) _ _ _ _ _ k_v); [exact I | | |]; destruct I as (_ & _ & K & B & W & _).
  - exact (sine_is_steep _ _ _ K (sine_at_most_1 _) (fun _ => Rmult_comm _ _)).
  - intros w C. split; [exact (sine_height_near _ _ _ _ U C) | apply rounded_is_float64].
  - pose proof truncation_bound__sine_in_v epsilon k_u k_v u v ltac:(lra) ltac:(lra) ltac:(lra) K as T. truncation T (gradient_sine.h_v u v k_u
    k_v) epsilon.
Qed.
Lemma sine_is_float64 a b : carried a b -> float64 (sine_of_half_turns_float64.sine (two_product_float64.product a b)
  (two_product_float64.product_error a b)).
Proof.
  assert (O : forall x, float64 x -> float64 (- x)) by (intros x; apply generic_format_opp).
  intro C. unfold sine_of_half_turns_float64.sine. repeat destruct Rlt_dec; try apply O; apply rounded_is_float64.
Qed.
Lemma rings_height_near k : float64 k -> forall w, carried (2 * k) w -> Rabs (height_rings_float64.h w k - height_rings.h w k) <= 76/10 / 2 ^ 53
  /\ float64 (height_rings_float64.h w k).
Proof.
  intros F w C. unfold height_rings_float64.h. rewrite (kept _ (twice_float64 _ F)). split; [|exact (sine_is_float64 _ _ C)]. eapply Rle_trans; [exact
    (proj1 (factors_near _ _ C)) | lra].
Qed.
Theorem difference_bounds__rings_in_float64 u v k_u k_v epsilon : float64 k_v -> sampled_in_v (2 * k_v) v epsilon -> Rabs (central_any_float64.h_v
  (fun _ v _ k_v => height_rings_float64.h v k_v) u v k_u k_v epsilon - gradient_rings.h_v v k_v) <= error_bound (PI * (2 * k_v)) v epsilon.
Proof.
  intros F I. apply (difference_in_v _ (fun w => height_rings.h w k_v) _ _ _ _ _ (2 * k_v)); [exact I | | exact (rings_height_near k_v F) |]; destruct
    I as (_ & _ & K & B & W & _).
  - apply (sine_is_steep _ 1); [exact K | rewrite Rabs_R1; lra | intro; symmetry; apply Rmult_1_r].
  - pose proof truncation_bound__rings epsilon k_v v ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) as T. truncation T (gradient_rings.h_v v k_v) epsilon.
Qed.

(* Ridges between creases: its heights are sine's, or their opposites, as float64 computes them, too: the side of a crease is never wrong. *)
Lemma same_side s x y x1 y1 : s = 1 \/ s = -1 -> sign x1 = sign x -> sign y1 = sign y -> 0 <= s * (x * y) -> Rabs (rounded (x1 * y1)) = s *
  rounded (x1 * y1).
Proof.
  intros S X Y H. assert (Q : 0 <= s * (x1 * y1)).
  { apply Rnot_lt_le. intro N. apply sign_eq_m1 in N. rewrite !sign_mult, X, Y, <- !sign_mult in N. generalize (sign_ge_0 _ H). lra. }
  destruct S as [-> | ->]; [rewrite Rabs_pos_eq | rewrite Rabs_left1]; try ring; rewrite <- rounded_0; (apply round_le; [typeclasses eauto..| lra]).
Qed.
Lemma ridges_height s u v k_u k_v : s = 1 \/ s = -1 -> carried k_u u -> carried k_v v -> 0 <= s * height_sine.h u v k_u k_v ->
  height_ridges_float64.h u v k_u k_v = s * height_sine_float64.h u v k_u k_v.
Proof.
  intros S U V H. destruct (factors_near _ _ U) as (_ & _ & Su). destruct (factors_near _ _ V) as (_ & _ & Sv). exact (same_side _ _ _ _ _ S Su Sv H).
Qed.
Lemma opposite_quotients s a b e S : s = 1 \/ s = -1 -> rounded (rounded (1 / 2 * rounded (s * a - s * b)) / e) = s * rounded (rounded (1 / 2 *
  rounded (a - b)) / e) /\ rounded (rounded (s * a - s * b) / S) = s * rounded (rounded (a - b) / S).
Proof.
  intros [-> | ->]; [rewrite !Rmult_1_l; split; reflexivity|]. replace (-1 * a - -1 * b) with (- (a - b)) by ring. rewrite rounded_opp. unfold Rdiv.
  rewrite <- Ropp_mult_distr_l, <- Ropp_mult_distr_r, !rounded_opp, <- Ropp_mult_distr_l, rounded_opp. split; ring.
Qed.
Lemma other_side s a b c d bound : s = 1 \/ s = -1 -> a = s * b -> c = s * d -> Rabs (b - d) <= bound -> Rabs (a - c) <= bound.
Proof. intros S -> -> B. rewrite <- Rmult_minus_distr_l, Rabs_mult. replace (Rabs s) with 1 by (destruct S as [-> | ->]; symmetry; [apply Rabs_R1 |
  apply Rabs_m1]). lra. Qed.
Lemma sign_of_height s p : s = 1 \/ s = -1 -> 0 < s * p -> s = sign p.
Proof. intros [-> | ->] H; symmetry; [apply sign_eq_1 | apply sign_eq_m1]; lra. Qed.
(* In one: s is the sign of sine's heights, at the point and at both rounded arguments. *)
Theorem difference_bounds__in_float64_u u v k_u k_v epsilon : sampled_in_u k_u u epsilon -> carried k_v v -> Rabs (central_any_float64.h_u
  height_sine_float64.h u v k_u k_v epsilon - gradient_sine.h_u u v k_u k_v) <= error_bound (PI * k_u) u epsilon /\ forall s, s = 1 \/ s = -1 -> 0
  < s * height_sine.h u v k_u k_v -> 0 <= s * height_sine.h (rounded (epsilon + u)) v k_u k_v -> 0 <= s * height_sine.h (rounded (u - epsilon)) v
  k_u k_v -> Rabs (central_any_float64.h_u height_ridges_float64.h u v k_u k_v epsilon - gradient_ridges.h_u u v k_u k_v) <= error_bound (PI *
  k_u) u epsilon.
Proof.
  intros I V. pose proof sine_in_u _ _ _ _ _ I V as N. split; [exact N|]. intros s S H Hp Hm. refine (other_side s _ _ _ _ _ S _ _ N).
  - destruct (arguments_in_u _ _ _ I) as [P M]. destruct I as (_ & _ & _ & _ & _ & Cp & Cm). unfold_difference.
    rewrite P, M, !(ridges_height s) by assumption. exact (proj1 (opposite_quotients s _ _ _ 0 S)).
  - rewrite (sign_of_height s _ S H). unfold_fields. ring.
Qed.
Theorem difference_bounds__in_float64_v u v k_u k_v epsilon : sampled_in_v k_v v epsilon -> carried k_u u -> Rabs (central_any_float64.h_v
  height_sine_float64.h u v k_u k_v epsilon - gradient_sine.h_v u v k_u k_v) <= error_bound (PI * k_v) v epsilon /\ forall s, s = 1 \/ s = -1 -> 0
  < s * height_sine.h u v k_u k_v -> 0 <= s * height_sine.h u (rounded (epsilon + v)) k_u k_v -> 0 <= s * height_sine.h u (rounded (v - epsilon))
  k_u k_v -> Rabs (central_any_float64.h_v height_ridges_float64.h u v k_u k_v epsilon - gradient_ridges.h_v u v k_u k_v) <= error_bound (PI *
  k_v) v epsilon.
Proof.
  intros I U. pose proof sine_in_v _ _ _ _ _ I U as N. split; [exact N|]. intros s S H Hp Hm. refine (other_side s _ _ _ _ _ S _ _ N).
  - destruct I as (_ & E & _ & B & W & Cp & Cm). destruct (in_order v epsilon ltac:(lra)) as [M _]. pose proof proj1 (up_to_1 _) W as P. destruct
    (arguments_in_v v epsilon _ _ E eq_refl eq_refl P M) as (P1 & M1 & _).
    unfold_difference. rewrite P1, M1, !(ridges_height s) by assumption.
      exact (proj2 (opposite_quotients s _ _ 0 _ S)).
  - rewrite (sign_of_height s _ S H). unfold_fields. ring.
Qed.

(* At the seam, or anywhere, for even k_u: each argument is rounded twice at most, and a whole turn less is the same height. *)
Lemma wrapped_near y : Rabs y <= 2 -> let m := rounded (rounded y - whole_below (rounded y)) in exists n : Z, Rabs (m + IZR n - y) <= 4 / 2 ^ 53.
Proof.
  intros Y m. exists (Zfloor (rounded y)). pose proof Zfloor_lb (rounded y) as A. pose proof Zfloor_ub (rounded y) as B. pose proof rounded_error
    y 2 Y as E2.
  pose proof rounded_error (rounded y - whole_below (rounded y)) 1 ltac:(unfold whole_below; apply Rabs_le; lra) as E. fold m in E. unfold
    whole_below in E.
  both_ways E. both_ways E2. apply Rabs_le. lra.
Qed.
Lemma whole_turn k n w v k_v : height_sine.h (w + IZR n) v (IZR (2 * k)) k_v = height_sine.h w v (IZR (2 * k)) k_v.
Proof.
  unfold height_sine.h. f_equal. rewrite <- (proj1 (turn (IZR (2 * k) * w) (k * n))). f_equal. rewrite !mult_IZR. ring.
Qed.
Lemma whole_turn_less k w v k_v : height_sine.h (w - IZR (Int_part w)) v (IZR (2 * k)) k_v = height_sine.h w v (IZR (2 * k)) k_v.
Proof. rewrite <- (whole_turn k (Int_part w)). f_equal. ring. Qed.
Lemma central_around k u v k_v e : 0 < e -> central_sine.h_u u v (IZR (2 * k)) k_v e = (height_sine.h (e + u) v (IZR (2 * k)) k_v - height_sine.h
  (u - e) v (IZR (2 * k)) k_v) / (2 * e).
Proof. intro E. rewrite <- (whole_turn_less k (e + u)), <- (whole_turn_less k (u - e)). unfold height_sine.h. central_sine.lines. field. lra. Qed.
Theorem difference_bounds__seam_in_float64 u v k_v epsilon k : (0 < k)%Z -> 0 <= u <= 1 -> 0 < epsilon <= 1 -> let k_u := IZR (2 * k) in carried
  k_u (central_any_float64.u_plus u epsilon) -> carried k_u (central_any_float64.u_minus u epsilon) -> carried k_v v -> Rabs
  (central_any_float64.h_u height_sine_float64.h u v k_u k_v epsilon - central_sine.h_u u v k_u k_v epsilon) <= arguments_part (PI * k_u) (4 / 2 ^
  53) epsilon + evaluation_part (PI * k_u) epsilon.
Proof.
  intros K U E k_u Cp Cm V. destruct (wrapped_near (epsilon + u)) as [n P]; [apply Rabs_le; lra|]. destruct (wrapped_near (u - epsilon)) as [m M];
    [apply Rabs_le; lra|].
  assert (K1 : 0 < k_u) by (apply IZR_lt; lia). rewrite <- (Rplus_0_l (arguments_part _ _ _)).
  refine (three_parts (fun w => height_sine.h w v k_u k_v) _ _ _ _ _ _ _ _ _ _ _ (sine_is_steep _ _ _ K1 (sine_at_most_1 _) (fun _ => eq_refl)) E P M
    (quotient_in_u _ _ _ (rounded_is_float64 _) (rounded_is_float64 _) E) _ _ _).
  1, 2: unfold k_u; rewrite whole_turn; apply sine_height_near; assumption.
  unfold k_u. rewrite central_around by lra. apply no_error.
Qed.

(* At the pole v - epsilon is clamped to 0: two roundings, and that of the span; what the clamp itself costs is truncation. *)
Definition kappa_clamped := (3 / 2 ^ 53 + (/ 2 ^ 53) ^ 2) / (1 - / 2 ^ 53).
Definition clamped_bound (L w : R) := (16 / w + 2 * L) / 2 ^ 53 * (1 + kappa_clamped) + L * kappa_clamped.
Definition clamped_in_v (k v e : R) := float64 v /\ float64 e /\ 0 < k /\ 0 <= v < e /\ e + v <= 1 /\ carried k (rounded (e + v)).
Lemma zero_carried k w : carried k w -> carried k 0.
Proof. intro C. refine (conj (proj1 C) (conj (generic_format_0 _ _) _)). rewrite Rmult_0_r, Rabs_R0. split; [left; reflexivity | lra]. Qed.
Lemma exact_when_clamped (v e : R) : 0 <= v < e -> e + v <= 1 -> Rmin 1 (e + v) = e + v /\ Rmax (v - e) 0 = 0 /\ forall f g : R, (if both (Rle_dec (e
  + v) 1) (Rle_dec (e - v) 0) then f else g) = g.
Proof. intros B W. rewrite Rmin_right, Rmax_right by lra. repeat split. intros f g. destruct (both _ _) as [[_ F]|_]; [lra | reflexivity]. Qed.
Lemma difference_when_clamped (height : R -> R -> R -> R -> R) (h : R -> R) (L u v k_u k_v k e : R) : clamped_in_v k v e -> steep h L -> (forall w,
  carried k w -> Rabs (height u w k_u k_v - h w) <= 76/10 / 2 ^ 53 /\ float64 (height u w k_u k_v)) ->
  Rabs (central_any_float64.h_v height u v k_u k_v e - (h (e + v) - h 0) / (e + v)) <= clamped_bound L (e + v).
Proof.
  intros (V & E & K & B & W & C) (h1 & D & S) N. destruct (clamped_arguments v e V E B W) as (P & M & Z). destruct (N _ C) as [A1 Fa]. destruct (N _
    (zero_carried _ _ C)) as [B1 Fb].
  unfold_difference. rewrite P, M, Z. set (a := height _ (rounded _) _ _) in
    *. set (b := height _ 0 _ _) in *. set (w := e + v) in *. destruct (difference_near a b Fa Fb) as (d1 & D1 & R1). destruct (rounded_near (rounded
    (a - b) / rounded w)) as (d2 & y & D2 & Y & ->).
  destruct (rounded_sum e v E V) as (d3 & D3 & R3). fold w in R3.
  assert (W0 : 0 < w) by (unfold w; lra). pose proof proj1 (argument_near e v E V ltac:(lra)) as A. rewrite Rplus_comm in A. fold w in A.
  rewrite R1, R3. set (t := (1 + d1) * (1 + d2) / (1 + d3)). both_ways D1. both_ways D2. both_ways D3.
  replace ((a - b) * (1 + d1) / (w * (1 + d3)) * (1 + d2) + y) with ((a - b) / w * t + y) by (unfold t; field; lra). assert (T : Rabs (t - 1) <=
    kappa_clamped).
  { apply Rabs_le. unfold kappa_clamped. destruct (roundoff_bound__three_roundings d1 t d2 d3 (/ 2 ^ 53)) as (_ & _ & _ & _ & _ & H & I1); try lra.
    unfold t. field. lra. }
  pose proof roundoff_bound__of_any_height h h1 L w 0 w kappa_clamped (76/10 / 2 ^ 53) (w / 2 ^ 53) _ 0 a b t D S W0 ltac:(ring) T A ltac:(rewrite
    Rminus_diag_eq, Rabs_R0 by reflexivity; lra) A1 B1 as X.
  assert (Y1 : Rabs ((a - b) / w * t + y - (a - b) / w * t) <= / 2 ^ 100) by (replace (_ - _) with y by ring; exact Y). eapply Rle_trans; [exact
    (through _ _ _ _ _ Y1 X)|].
  assert (I : 1 <= / w) by (rewrite <- Rinv_1; apply Rinv_le_contravar; lra). assert (Q : 0 <= kappa_clamped) by (at_most_by Rabs_pos; exact T).
  replace (2 * (76 / 10 / 2 ^ 53 + L * (w / 2 ^ 53)) / w) with ((152 / 10 * / w + 2 * L) / 2 ^ 53) by (field; lra). unfold clamped_bound, Rdiv in *. nra.
Qed.
(* In one, of sine, ridges and rings, which have twice the wave number: s is the sign of sine's heights at both ends of the span, and at the rounded one. *)
Theorem difference_bounds__clamped_in_float64 u v k_u k_v epsilon : clamped_in_v k_v v epsilon -> carried k_u u -> Rabs (central_any_float64.h_v
  height_sine_float64.h u v k_u k_v epsilon - central_sine.h_v u v k_u k_v epsilon) <= clamped_bound (PI * k_v) (epsilon + v) /\ (forall s, s = 1
  \/ s = -1 -> 0 <= s * height_sine.h u (epsilon + v) k_u k_v -> 0 <= s * height_sine.h u (rounded (epsilon + v)) k_u k_v -> Rabs
  (central_any_float64.h_v height_ridges_float64.h u v k_u k_v epsilon - central_ridges.h_v u v k_u k_v epsilon) <= clamped_bound (PI * k_v)
  (epsilon + v)) /\ forall k, float64 k -> 2 * k = k_v -> Rabs (central_any_float64.h_v (fun _ v _ k => height_rings_float64.h v k) u v k_u k
  epsilon - central_rings.h_v v k epsilon) <= clamped_bound (PI * k_v) (epsilon + v).
Proof.
  intros I U. pose proof I as D. destruct D as (V & E & K & B & W & C). destruct (clamped_arguments v epsilon V E B W) as (P & M & _). destruct
    (exact_when_clamped v epsilon B W) as (P1 & M1 & S1). pose proof zero_carried _ _ C as Z.
  assert (N : Rabs (central_any_float64.h_v height_sine_float64.h u v k_u k_v epsilon - central_sine.h_v u v k_u k_v epsilon) <= clamped_bound (PI *
    k_v) (epsilon + v)).
  { central_sine.lines. rewrite P1, M1, S1, Rminus_0_r. refine (difference_when_clamped _ (fun x => height_sine.h u x k_u k_v) _ _ _ _ _ _ _ I
    (sine_is_steep _ _ _ K (sine_at_most_1 _) (fun _ => Rmult_comm _ _)) _).
    intros w C1. split; [exact (sine_height_near _ _ _ _ U C1) | apply rounded_is_float64]. }
  split; [exact N|]. split.
  2: { intros k F <-. central_rings.lines. rewrite P1, M1, S1, Rminus_0_r. refine (difference_when_clamped _ (fun x => height_rings.h x k) _ _ _ _ _ _
    _ I (sine_is_steep _ 1 _ K _ _) (rings_height_near k F)); [rewrite Rabs_R1; lra | intro; symmetry; apply Rmult_1_r]. }
  intros s G H I1. assert (K0 : s * height_sine.h u 0 k_u k_v = 0) by (unfold height_sine.h; rewrite !Rmult_0_r, sin_0; ring). refine (other_side s _
    _ _ _ _ G _ _ N).
  - unfold_difference. rewrite P, M, !(ridges_height s) by (assumption ||
    lra). exact (proj2 (opposite_quotients s _ _ 0 _ G)).
  - central_ridges.lines; central_sine.lines.
    rewrite P1, M1, !S1. unfold height_sine.h in *. set (x := sin _ * sin (PI * (k_v * (epsilon + v)))) in *. set (z := sin _ * sin (PI * (k_v *
      0))) in *.
    assert (Y : forall t, 0 <= s * t -> Rabs t = s * t) by (destruct G as [-> | ->]; intros; [rewrite Rabs_pos_eq | rewrite Rabs_left1]; lra).
    rewrite (Y x), (Y z) by lra. unfold Rdiv. ring.
Qed.

Ltac in_figures := change (bpow radix2 (-55)) with (/ IZR (2 ^ 55)) in *; change (bpow radix2 (-1)) with (/ 2) in *.
(* False variants: with an eighth of the arguments' part, where the slope dies. *)
Lemma step_lost : rounded (bpow radix2 (-55) + bpow radix2 (-1)) = bpow radix2 (-1) /\ rounded (bpow radix2 (-1) - bpow radix2 (-55)) = bpow radix2 (-1).
Proof. apply (stays (-1)); powers. Qed.
Lemma witness : let k := 201 / 2 in let w := bpow radix2 (-1) in let e := bpow radix2 (-55) in sampled_in_u k w e /\ sampled_in_v k w e /\ carried k w.
Proof.
  intros k w e. assert (F : float64 w) by (apply power_float64; easy). assert (E : float64 e) by (apply power_float64; easy).
  assert (W : w = 1 / 2) by (unfold w; in_figures; lra). assert (E1 : 0 < e <= / 2 ^ 54) by (unfold e; in_figures; simpl; lra).
  destruct step_lost as [P M]. fold w e in P, M.
  assert (C : carried k w).
  { split; [replace k with (IZR 201 * bpow radix2 (-1)) by (unfold k; simpl; lra); apply whole_is_float64; easy|]. split; [exact F|].
    generalize (bpow_le radix2 (-969) 0 ltac:(easy)). simpl (bpow radix2 0). unfold k. rewrite W, Rabs_pos_eq by lra. split; [right|]; lra. }
  unfold sampled_in_u, sampled_in_v. rewrite P, M. unfold k. repeat split; try exact F; try exact E; try apply C; lra.
Qed.
Lemma no_slope height k_u k_v : let w := bpow radix2 (-1) in let e := bpow radix2 (-55) in central_any_float64.h_u height w w k_u k_v e = 0 /\
  central_any_float64.h_v height w w k_u k_v e = 0.
Proof. split; [apply none_in_u | apply none_in_v]; (exact step_lost || apply witness || in_figures; lra). Qed.
Lemma eighth_of_arguments : let L := PI * (201 / 2) in let w := bpow radix2 (-1) in let e := bpow radix2 (-55) in
  e ^ 2 / 6 * L ^ 3 + arguments_part L ((w + e) / 2 ^ 53 / 8) e + evaluation_part L e < 150.
Proof.
  intros L w e. unfold L, w, e, arguments_part, evaluation_part, kappa_unclamped. in_figures. interval with (i_prec 80).
Qed.
Lemma steep_there : let k := 201 / 2 in let w := bpow radix2 (-1) in 150 <= Rabs (0 - PI * cos (PI * (k * w)) * k * sin (PI * (k * w))) /\
  150 <= Rabs (0 - 2 * PI * cos (PI * (k * w)) * (k / 2)).
Proof. intros k w. unfold k, w. in_figures. split; interval. Qed.
Theorem difference_bounds__in_float64_u__point : exists u v k_u k_v epsilon, sampled_in_u k_u u epsilon /\ carried k_v v.
Proof. do 5 eexists. split; apply witness. Qed.
Theorem difference_bounds__in_float64_u__false : ~ forall u v k_u k_v epsilon, sampled_in_u k_u u epsilon -> carried k_v v -> Rabs
  (central_any_float64.h_u height_sine_float64.h u v k_u k_v epsilon - gradient_sine.h_u u v k_u k_v) <= epsilon ^ 2 / 6 * (PI * k_u) ^ 3 +
  arguments_part (PI * k_u) ((u + epsilon) / 2 ^ 53 / 8) epsilon + evaluation_part (PI * k_u) epsilon.
Proof.
  intro H. destruct witness as (U & _ & C). generalize (H _ _ _ _ _ U C) eighth_of_arguments (proj1 steep_there).
  rewrite (proj1 (no_slope height_sine_float64.h (201 / 2) (201 / 2))). unfold_slopes. lra.
Qed.
Theorem difference_bounds__in_float64_v__point : exists u v k_u k_v epsilon, sampled_in_v k_v v epsilon /\ carried k_u u.
Proof. do 5 eexists. split; apply witness. Qed.
Theorem difference_bounds__in_float64_v__false : ~ forall u v k_u k_v epsilon, sampled_in_v k_v v epsilon -> carried k_u u -> Rabs
  (central_any_float64.h_v height_sine_float64.h u v k_u k_v epsilon - gradient_sine.h_v u v k_u k_v) <= epsilon ^ 2 / 6 * (PI * k_v) ^ 3 +
  arguments_part (PI * k_v) ((v + epsilon) / 2 ^ 53 / 8) epsilon + evaluation_part (PI * k_v) epsilon.
Proof.
  intro H. destruct witness as (_ & V & C). generalize (H _ _ _ _ _ V C) eighth_of_arguments (proj1 steep_there).
  rewrite (proj2 (no_slope height_sine_float64.h (201 / 2) (201 / 2))). unfold_slopes. lra.
Qed.
Lemma clamped_witness : clamped_in_v (201 / 2) 0 (bpow radix2 (-1)) /\ carried (201 / 2) (bpow radix2 (-1)).
Proof.
  destruct witness as (_ & _ & C). split; [|exact C]. unfold clamped_in_v. rewrite Rplus_0_r, (kept (bpow radix2 (-1))) by apply C.
  split; [apply generic_format_0 | split; [apply C|]]. change (bpow radix2 (-1)) with (/ 2) at 1 2. repeat split; try apply C; lra.
Qed.
Theorem difference_bounds__clamped_in_float64__point : exists u v k_u k_v epsilon, clamped_in_v k_v v epsilon /\ carried k_u u.
Proof. do 5 eexists. exact clamped_witness. Qed.
(* It is not the slope itself. *)
Theorem difference_bounds__clamped_in_float64__false : ~ forall u v k_u k_v epsilon, clamped_in_v k_v v epsilon -> carried k_u u -> Rabs
  (central_any_float64.h_v height_sine_float64.h u v k_u k_v epsilon - gradient_sine.h_v u v k_u k_v) <= clamped_bound (PI * k_v) (epsilon + v).
Proof.
  intro H. destruct clamped_witness as [V U]. generalize (H _ _ _ _ _ V U) (proj1 (difference_bounds__clamped_in_float64 _ _ _ _ _ V U)). rewrite
    Rabs_minus_sym. intros X Y. generalize (through _ _ _ _ _ X Y). apply Rlt_not_le.
  destruct V as (_ & _ & _ & B & W & _). destruct (exact_when_clamped _ _ B W) as (P & M & S). central_sine.lines. rewrite P, M, S.
  in_figures. unfold height_sine.h, clamped_bound, kappa_clamped. unfold_slopes. interval with (i_prec 80).
Qed.
Lemma for_rings : float64 (201 / 2 / 2) /\ sampled_in_v (2 * (201 / 2 / 2)) (bpow radix2 (-1)) (bpow radix2 (-55)).
Proof.
  split; [replace (201 / 2 / 2) with (IZR 201 * bpow radix2 (-2)) by (simpl; lra); apply whole_is_float64; easy|].
  replace (2 * (201 / 2 / 2)) with (201 / 2) by field. apply witness.
Qed.
Theorem difference_bounds__rings_in_float64__point : exists v k_v epsilon, float64 k_v /\ sampled_in_v (2 * k_v) v epsilon.
Proof. do 3 eexists. exact for_rings. Qed.
Theorem difference_bounds__rings_in_float64__false : ~ forall u v k_u k_v epsilon, float64 k_v -> sampled_in_v (2 * k_v) v epsilon -> Rabs
  (central_any_float64.h_v (fun _ v _ k_v => height_rings_float64.h v k_v) u v k_u k_v epsilon - gradient_rings.h_v v k_v) <= epsilon ^ 2 / 6 *
  (PI * (2 * k_v)) ^ 3 + arguments_part (PI * (2 * k_v)) ((v + epsilon) / 2 ^ 53 / 8) epsilon + evaluation_part (PI * (2 * k_v)) epsilon.
Proof.
  intro H. destruct for_rings as [F V]. generalize (H (bpow radix2 (-1)) _ 0 _ _ F V) eighth_of_arguments (proj2 steep_there).
  rewrite (proj2 (no_slope _ 0 (201 / 2 / 2))). unfold_slopes. replace (2 * (201 / 2 / 2)) with (201 / 2) by field. lra.
Qed.
Lemma seam_witness : carried (IZR (2 * 100)) (central_any_float64.u_plus (bpow radix2 (-1)) (bpow radix2 (-55))) /\ carried (IZR (2 * 100))
  (central_any_float64.u_minus (bpow radix2 (-1)) (bpow radix2 (-55))).
Proof.
  destruct witness as (U & _ & _ & F & _). destruct (arguments_in_u _ _ _ U) as [-> ->]. destruct step_lost as [-> ->].
  assert (C : carried (IZR (2 * 100)) (bpow radix2 (-1))); [|exact (conj C C)]. split; [replace (IZR (2 * 100)) with (IZR 200 * bpow radix2 0) by
    (simpl; lra); apply whole_is_float64; easy|].
  split; [exact F|]. change (bpow radix2 (-1)) with (/ 2). simpl (bpow radix2 0). rewrite Rabs_pos_eq by (simpl; lra). simpl. split; [right|]; lra.
Qed.
Theorem difference_bounds__seam_in_float64__point : exists u v k_v epsilon k, (0 < k)%Z /\ 0 <= u <= 1 /\ 0 < epsilon <= 1 /\ carried (IZR (2 *
  k)) (central_any_float64.u_plus u epsilon) /\ carried (IZR (2 * k)) (central_any_float64.u_minus u epsilon) /\ carried k_v v.
Proof.
  destruct seam_witness as [P M]. destruct witness as (_ & _ & C). exists (bpow radix2 (-1)), (bpow radix2 (-1)), (201 / 2), (bpow radix2 (-55)), 100%Z.
  repeat split; try apply P; try apply M; try apply C; in_figures; simpl; lra.
Qed.
Theorem difference_bounds__seam_in_float64__false : ~ forall u v k_v epsilon k, (0 < k)%Z -> 0 <= u <= 1 -> 0 < epsilon <= 1 -> let k_u := IZR (2
  * k) in carried k_u (central_any_float64.u_plus u epsilon) -> carried k_u (central_any_float64.u_minus u epsilon) -> carried k_v v -> Rabs
  (central_any_float64.h_u height_sine_float64.h u v k_u k_v epsilon - central_sine.h_u u v k_u k_v epsilon) <= evaluation_part (PI * k_u)
  epsilon.
Proof.
  intro H. destruct seam_witness as [P M]. destruct witness as (_ & _ & C). generalize (H (bpow radix2 (-1)) (bpow radix2 (-1)) (201 / 2) (bpow radix2
    (-55)) 100%Z ltac:(easy)
    ltac:(simpl; lra) ltac:(in_figures; simpl; lra) P M C). rewrite (proj1 (no_slope height_sine_float64.h (IZR
      (2 * 100)) (201 / 2))).
  rewrite central_around by apply bpow_gt_0.
  unfold height_sine.h, evaluation_part, kappa_unclamped. in_figures. apply Rlt_not_le. apply Rlt_trans with 100; interval with (i_prec 200).
Qed.
