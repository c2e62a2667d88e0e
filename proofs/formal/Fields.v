(* The height fields: their gradients, where ridges is creased, central differences and what these lose. *)

From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Claim Derivatives Camera.
From Formal Require Statements.
Open Scope R_scope.

Ltac unfold_fields :=
  unfold height_sine.h, height_ridges.h, height_rings.h, gradient_sine.h_u, gradient_sine.h_v, gradient_rings.h_u, gradient_rings.h_v,
    gradient_ridges.h_u, gradient_ridges.h_v, gradient_sine.sin_u, gradient_sine.cos_u, gradient_sine.sin_v, gradient_sine.cos_v,
    gradient_ridges.sin_u, gradient_ridges.cos_u, gradient_ridges.sin_v, gradient_ridges.cos_v, gradient_rings.sin_v, gradient_rings.cos_v in *.

(* The gradients *)

Lemma is_derive_is (f : R -> R) (x a b : R) : is_derive f x a -> a = b -> is_derive f x b.
Proof. intros H <-. exact H. Qed.

Theorem gradients__sine : Statements.gradients__sine.
Proof. slopes. Qed.
Theorem gradients__rings : Statements.gradients__rings.
Proof. slopes. Qed.
Theorem gradients__ridges_above : Statements.gradients__ridges_above.
Proof. slopes. Qed.
Theorem gradients__ridges_below : Statements.gradients__ridges_below.
Proof. slopes. Qed.
Theorem gradients__ridges_on_creases : Statements.gradients__ridges_on_creases.
Proof. claim. Qed.
Theorem gradients__same_sign : Statements.gradients__same_sign.
Proof. claim. Qed.
Theorem gradients__same_sign_below : Statements.gradients__same_sign_below.
Proof. claim. Qed.

(* The third derivative at k = 8 and k = 4 *)
Theorem third_derivative_at_eight__at_eight : Statements.third_derivative_at_eight__at_eight.
Proof. split; [interval | lra]. Qed.
Theorem third_derivative_at_eight__at_four : Statements.third_derivative_at_eight__at_four.
Proof. split; interval. Qed.

(* The best step *)

Theorem best_step__least : Statements.best_step__least.
Proof.
  intros best epsilon rounding T HT HB HE ->. pose proof (pow_lt best 2 HB). pose proof (pow_lt best 3 HB).
  assert (S : 0 <= T * ((epsilon - best) ^ 2 * (epsilon + 2 * best))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; [apply pow2_ge_0 | lra]]).
  assert (0 <= T * (2 * best + epsilon)) by (apply Rmult_le_pos; lra). assert (0 < best * T) by (apply Rmult_lt_0_compat; lra). assert (0 < best ^ 3 *
    T) by (apply Rmult_lt_0_compat; lra).
  repeat split; try not_zero; try lra; try (field; lra).
  apply Rle_ge, (Rmult_le_reg_r epsilon); [exact HE|]. field_simplify; lra.
Qed.

(* With the roots that the card has: T eps^2 + E/eps is at least 3 T^(1/3) (E/2)^(2/3), and is that at eps = (E/2T)^(1/3). *)
Theorem best_step__roots T E epsilon : 0 < T -> 0 < E -> 0 < epsilon -> let best := Rpower (E / (2 * T)) (1/3) in let lowest := 3 * Rpower T (1/3)
  * Rpower (E / 2) (2/3) in T * best ^ 2 + E / best = lowest /\ lowest <= T * epsilon ^ 2 + E / epsilon.
Proof.
  intros HT HE He. cbv zeta. assert (Q : 0 < E / (2 * T)) by (apply Rdiv_lt_0_compat; lra). set (q := E / (2 * T)) in *.
  assert (C : forall n : nat, Rpower q (1/3) ^ n = Rpower q (INR n / 3)) by (intro n; rewrite <- Rpower_pow, Rpower_mult by apply exp_pos;
    f_equal; field).
  assert (C3 : Rpower q (1/3) ^ 3 = q) by (rewrite C; replace (INR 3 / 3) with 1 by (simpl; field); apply Rpower_1, Q).
  destruct (best_step__least (Rpower q (1/3)) epsilon E T) as (_ & _ & _ & _ & _ & _ & _ & L & V & _); try apply exp_pos; try lra; [rewrite C3; unfold
    q; field; lra|].
  replace (3 * Rpower T (1/3) * Rpower (E / 2) (2/3)) with (3 * Rpower q (1/3) ^ 2 * T); [split; lra|].
  rewrite C. replace (E / 2) with (T * q) by (unfold q; field; lra). rewrite <- Rpower_mult_distr by lra. replace (INR 2 / 3) with (2/3) by
    (simpl; field).
  rewrite <- (Rpower_1 T) at 1 by lra. replace 1 with (1/3 + 2/3) at 1 by field. rewrite Rpower_plus. ring.
Qed.
Theorem best_step__roots__point : exists T E epsilon, 0 < T /\ 0 < E /\ 0 < epsilon.
Proof. exists 1, 1, 1. lra. Qed.
(* A third more is no floor. *)
Theorem best_step__roots__false : ~ forall T E epsilon, 0 < T -> 0 < E -> 0 < epsilon -> 4 * Rpower T (1/3) * Rpower (E / 2) (2/3) <= T * epsilon ^ 2
  + E / epsilon.
Proof.
  intro H. generalize (H 1 2 1 ltac:(lra) ltac:(lra) ltac:(lra)). replace (2 / 2) with 1 by field. unfold Rpower. rewrite ln_1, !Rmult_0_r, exp_0. lra.
Qed.

(* The central difference of a sine *)

Lemma floor_is n w : IZR n <= w < IZR n + 1 -> IZR (Int_part w) = IZR n.
Proof.
  intro H. destruct (base_Int_part w) as [A B]. assert (n - 1 < Int_part w < n + 1)%Z by (split; apply lt_IZR; rewrite ?minus_IZR, ?plus_IZR; lra).
    f_equal. lia.
Qed.
Lemma floor_of_a_fraction w : 0 <= w < 1 -> IZR (Int_part w) = 0.
Proof. intro H. apply (floor_is 0). lra. Qed.
Theorem central_difference_of_sine__no_clamp : Statements.central_difference_of_sine__no_clamp.
Proof. claim. Qed.
Theorem central_difference_of_sine__sine_in_u : Statements.central_difference_of_sine__sine_in_u.
Proof. slopes. Qed.
Theorem central_difference_of_sine__sine_in_v : Statements.central_difference_of_sine__sine_in_v.
Proof. slopes. Qed.
Theorem central_difference_of_sine__rings_in_v : Statements.central_difference_of_sine__rings_in_v.
Proof. slopes. Qed.
Theorem central_difference_of_sine__cosine : Statements.central_difference_of_sine__cosine.
Proof. slopes. Qed.

(* The kernels' differences, whose lines have floor, Min and Max, are those of the claims where nothing wraps or is clamped. *)
Theorem central_difference_of_sine__nothing_wraps u v k_u k_v epsilon : 0 < epsilon -> 0 <= u - epsilon -> epsilon + u < 1 -> let difference :=
  fun h : R -> R => 1/2 * (h (epsilon + u) - h (u - epsilon)) / epsilon in central_sine.h_u u v k_u k_v epsilon = difference (fun u =>
  height_sine.h u v k_u k_v) /\ central_ridges.h_u u v k_u k_v epsilon = difference (fun u => height_ridges.h u v k_u k_v).
Proof.
  intros E A B. cbv zeta. central_sine.lines; central_ridges.lines.
  rewrite !floor_of_a_fraction, !Rminus_0_r by lra. split; reflexivity.
Qed.
Theorem central_difference_of_sine__nothing_clamps u v k_u k_v epsilon : 0 < epsilon -> 0 <= v - epsilon -> epsilon + v <= 1 -> let difference :=
  fun h : R -> R => (h (epsilon + v) - h (v - epsilon)) / (2 * epsilon) in central_sine.h_v u v k_u k_v epsilon = difference (fun v =>
  height_sine.h u v k_u k_v) /\ central_ridges.h_v u v k_u k_v epsilon = difference (fun v => height_ridges.h u v k_u k_v) /\ central_rings.h_v v
  k_v epsilon = difference (fun v => height_rings.h v k_v).
Proof.
  intros E A B. cbv zeta. destruct (central_difference_of_sine__no_clamp epsilon v) as (P & M & S); try lra.
  central_sine.lines; central_ridges.lines; central_rings.lines.
  rewrite S, P, M. repeat split; reflexivity.
Qed.
Theorem central_difference_of_sine__nothing_wraps__point : exists u epsilon, 0 < epsilon /\ 0 <= u - epsilon /\ epsilon + u < 1.
Proof. exists (1/2), (1/4). lra. Qed.
Theorem central_difference_of_sine__nothing_clamps__point : exists v epsilon, 0 < epsilon /\ 0 <= v - epsilon /\ epsilon + v <= 1.
Proof. exists (1/2), (1/4). lra. Qed.
Theorem central_difference_of_sine__nothing_wraps__false : ~ forall u v k_u k_v epsilon, 0 < epsilon ->
  central_sine.h_u u v k_u k_v epsilon = 1/2 * (height_sine.h (epsilon + u) v k_u k_v - height_sine.h (u - epsilon) v k_u k_v) / epsilon.
Proof.
  intro H. generalize (H 0 (1/2) 1 1 (1/2) ltac:(lra)). central_sine.lines.
  rewrite floor_of_a_fraction, (floor_is (-1)) by lra. replace (0 - 1/2 - -1) with (1/2) by field. replace (1/2 + 0 - 0) with (1/2) by ring.
    unfold_fields.
  replace (PI * (1 * (0 - 1/2))) with (- (PI * (1 * (1/2)))) by field. rewrite Rplus_0_r, sin_neg, !half_sine. lra.
Qed.
Theorem central_difference_of_sine__nothing_clamps__false : ~ forall v k_v epsilon, 0 < epsilon ->
  central_rings.h_v v k_v epsilon = (height_rings.h (epsilon + v) k_v - height_rings.h (v - epsilon) k_v) / (2 * epsilon).
Proof.
  intro H. generalize (H (1/4) (1/2) (3/4) ltac:(lra)).
  central_rings.lines.
  destruct (both _ _) as [[]|_]; [lra|]. rewrite Rmin_left, Rmax_right by lra. unfold_fields. replace (PI * (2 * (1/2) * 1)) with PI by field.
  replace (PI * (2 * (1/2) * (3/4 + 1/4))) with PI by field. replace (PI * (2 * (1/2) * (1/4 - 3/4))) with (- (PI / 2)) by field. rewrite !Rmult_0_r,
    sin_0, sin_neg, sin_PI, sin_PI2. lra.
Qed.

(* The truncation error *)

Lemma sine_below x : Rabs (sin x) <= Rabs x.
Proof. generalize (bounded_variation sin cos 1 0 x). rewrite sin_0, !Rminus_0_r, Rmult_1_l. intro H. apply H. intros t _. split; [apply is_derive_sin
  | apply Rabs_le, COS_bound]. Qed.
Lemma cosine_from_below x : 1 - x ^ 2 / 2 <= cos x.
Proof.
  replace (cos x) with (1 - 2 * sin (x / 2) * sin (x / 2)) by (rewrite <- cos_2a_sin; f_equal; field). generalize (pow_maj_Rabs _ _ 2 (sine_below (x /
    2))). rewrite pow2_abs. lra.
Qed.

Lemma sine_from_below x : 0 <= x -> x - x ^ 3 / 6 <= sin x.
Proof.
  intro X. destruct (MVT_cor4 (fun t => sin t - (t - t ^ 3 / 6)) (fun t => cos t - (1 - t ^ 2 / 2)) 0 x) with (b := x) as (c & E & _).
  - intros c _. auto_derive; trivial. field.
  - rewrite Rminus_0_r, Rabs_pos_eq; lra.
  - rewrite sin_0 in E. generalize (cosine_from_below c). intro. assert (0 <= (cos c - (1 - c ^ 2 / 2)) * (x - 0)) by (apply Rmult_le_pos; lra).
    simpl in *. lra.
Qed.

(* What F sin x lacks of F x is at most x^3/6, over the step too. *)
Lemma slack F x epsilon : -1 <= F <= 1 -> x > 0 -> epsilon > 0 -> 0 <= (x ^ 3 / 6 + F * (sin x - x)) / epsilon /\ 0 <= (x ^ 3 / 6 - F * (sin x -
  x)) / epsilon.
Proof. intros B X E. pose proof (sine_from_below x). pose proof (sin_lt_x x X). split; apply Rdiv_le_0_compat; nra. Qed.
Lemma third_of_a_sine (f : R -> R) (a k : R) : (forall t, a * sin (PI * (k * t)) = f t) -> forall t, is_derive_n f 3 t (- (PI * k) ^ 3 * (a * cos (PI
  * (k * t)))).
Proof.
  intros F t. apply (is_derive_n_ext _ _ _ _ _ F), (next_derivative 2 _ (fun t => - (PI * k) ^ 2 * (a * sin (PI * (k * t))))); [intro|].
  - apply (next_derivative 1 _ (fun t => PI * k * (a * cos (PI * (k * t))))); [intro|]; simpl; auto_derive; trivial; ring.
  - auto_derive; trivial; ring.
Qed.
Lemma at_most c x y : 0 <= c -> Rabs x <= 1 -> Rabs y <= 1 -> Rabs (c * (x * y)) <= c.
Proof.
  intros C X Y. rewrite !Rabs_mult, (Rabs_pos_eq c C). assert (Rabs x * Rabs y <= 1 * 1) by (apply Rmult_le_compat; try apply Rabs_pos; assumption). nra.
Qed.
Lemma sine_at_most_1 x : Rabs (sin x) <= 1.
Proof. apply Rabs_le, SIN_bound. Qed.
Lemma cosine_at_most_1 x : Rabs (cos x) <= 1.
Proof. apply Rabs_le, COS_bound. Qed.
Lemma product_at_most_1 a b : -1 <= sin a * cos b <= 1.
Proof. pose proof (SIN_bound a). pose proof (COS_bound b). nra. Qed.

Ltac over_the_step G epsilon := apply Rle_ge; try (apply Rmult_le_pos; [left; assumption|]); apply (Rle_trans _ _ _ G); right; field; split; lra.
(* F: what the slope has beside pi k, at most 1; T: the third derivative. *)
Ltac truncated F k epsilon T := pose proof T as Third; rewrite (is_derive_n_unique _ _ _ _ Third); split; [eexists; exact Third|]; clear Third;
  derivatives;
  assert (W : PI * k > 0) by (apply Rmult_lt_0_compat; lra); pose proof (pow_lt (PI * k) 3 W); assert (B : -1 <= F <= 1) by first [apply
    product_at_most_1 | apply COS_bound];
  destruct (slack F (PI * k * epsilon) epsilon B ltac:(apply Rmult_lt_0_compat; lra) ltac:(lra)) as [G1 G2];
  assert (0 <= (PI * k) ^ 3 * (1 - F)) by (apply Rmult_le_pos; lra); assert (0 <= (PI * k) ^ 3 * (1 + F)) by (apply Rmult_le_pos; lra).
Ltac conclusions G1 G2 epsilon := repeat split; first [not_zero | differentiable | lra | ring | field; lra | over_the_step G1 epsilon | over_the_step
  G2 epsilon].
Theorem truncation_bound__sine : Statements.truncation_bound__sine.
Proof.
  red. intros. pose proof PI_RGT_0. destruct (central_difference_of_sine__sine_in_u epsilon k_u k_v u v) as (_ & _ & _ & _ & ->); try assumption.
  truncated (sin (v * PI * k_v) * cos (u * PI * k_u)) k_u epsilon
    (third_of_a_sine (fun u => sin (PI * (k_u * u)) * sin (PI * (k_v * v))) (sin (PI * (k_v * v))) k_u ltac:(intro; cbv beta; ring) u).
  printed_angles.
  replace (PI * k_u * epsilon) with (epsilon * PI * k_u) in * by ring. conclusions G1 G2 epsilon.
Qed.
Theorem truncation_bound__sine_in_v : Statements.truncation_bound__sine_in_v.
Proof.
  red. intros. pose proof PI_RGT_0. destruct (central_difference_of_sine__sine_in_v epsilon k_u k_v u v) as (_ & _ & _ & _ & ->); try assumption.
  truncated (sin (u * PI * k_u) * cos (v * PI * k_v)) k_v epsilon
    (third_of_a_sine (fun v => sin (PI * (k_u * u)) * sin (PI * (k_v * v))) (sin (PI * (k_u * u))) k_v ltac:(reflexivity) v).
  printed_angles.
  replace (PI * k_v * epsilon) with (epsilon * PI * k_v) in * by ring. conclusions G1 G2 epsilon.
Qed.
Theorem truncation_bound__rings : Statements.truncation_bound__rings.
Proof.
  red. intros. pose proof PI_RGT_0. destruct (central_difference_of_sine__rings_in_v epsilon k_v v) as (_ & _ & _ & _ & ->); try assumption.
  truncated (cos (v * 2 * PI * k_v)) (2 * k_v) epsilon (third_of_a_sine (fun v => sin (PI * (2 * k_v * v))) 1 (2 * k_v) ltac:(intro; cbv beta; ring) v).
  replace (PI * (2 * k_v * v)) with (v * 2 * PI * k_v) by ring. replace (PI * (2 * k_v) * epsilon) with (epsilon * PI * 2 * k_v) in * by ring.
    conclusions G1 G2 epsilon.
Qed.

(* Ridges between creases *)
Theorem truncation_bound__ridges_u_above : Statements.truncation_bound__ridges_u_above.
Proof. slopes. Qed.
Theorem truncation_bound__ridges_u_below : Statements.truncation_bound__ridges_u_below.
Proof. slopes. Qed.
Theorem truncation_bound__ridges_v_above : Statements.truncation_bound__ridges_v_above.
Proof. slopes. Qed.
Theorem truncation_bound__ridges_v_below : Statements.truncation_bound__ridges_v_below.
Proof. slopes. Qed.
Theorem truncation_bound__apart : Statements.truncation_bound__apart.
Proof. claim. Qed.

(* Ridges is 0 exactly on the rays k_u u = m and the circles k_v v = m: so p is not 0 everywhere else. *)
Theorem kink_loci__zero u v k_u k_v : height_ridges.h u v k_u k_v = 0 <-> (exists m : Z, k_u * u = IZR m) \/ (exists m : Z, k_v * v = IZR m).
Proof.
  rewrite <- !sine_zero. unfold_fields. split.
  - intro E. apply Rmult_integral. destruct (Req_dec (sin (PI * (k_u * u)) * sin (PI * (k_v * v))) 0) as [H|H]; [exact H | destruct (Rabs_no_R0 _ H E)].
  - intros [E|E]; rewrite E, ?Rmult_0_l, ?Rmult_0_r; apply Rabs_R0.
Qed.
Theorem kink_loci__zero__false : ~ forall u v k_u k_v, height_ridges.h u v k_u k_v = 0 -> exists m : Z, k_u * u = IZR m.
Proof.
  intro H. destruct (H (1/2) 0 1 1) as [m M]; [unfold_fields; rewrite !Rmult_0_r, sin_0, Rmult_0_r; apply Rabs_R0|].
  assert (0 < m < 1)%Z by (split; apply lt_IZR; lra). lia.
Qed.
