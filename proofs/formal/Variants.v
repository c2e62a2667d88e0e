(* False variants, of statements whose files do not refute one beside them. *)

From Coq Require Import Reals Lra Psatz Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Vectors Fields Bump Creases Algebraic Points.
Open Scope R_scope.

Theorem gradients__rings__false : ~ forall v k_v, gradient_rings.h_v v k_v = PI * k_v * cos (PI * (2 * k_v * v)).
Proof. intro H. generalize (H 0 1) PI_RGT_0. unfold_fields. rewrite !Rmult_0_r, cos_0. lra. Qed.
(* On a crease the kernels do not print sine's slope. *)
Theorem gradients__ridges__false : ~ forall u v k_u k_v, gradient_ridges.h_u u v k_u k_v = gradient_sine.h_u u v k_u k_v.
Proof.
  intro H. generalize (H 0 (1/2) 1 1) PI_RGT_0. unfold_fields. rewrite sine_of_a_right_angle, !Rmult_0_r, cos_0, sin_0, Rmult_0_l, sign_0. lra.
Qed.
Theorem kink_loci__between__false : ~ forall u v k_u k_v, 0 < height_ridges.h u v k_u k_v.
Proof. intro H. generalize (H 0 0 1 1). unfold_fields. rewrite !Rmult_0_r, sin_0, Rmult_0_r, Rabs_R0. lra. Qed.
Theorem third_derivative_at_eight__at_four__false : ~ (4 * PI) ^ 3 < 1728.
Proof. apply Rle_not_lt. left. interval. Qed.

(* The difference is not the derivative, and half the bound is too little: at k = 4, eps = 1/4 the difference is 0. *)
Lemma no_difference_in_v : central_sine.h_v (1/2) (1/2) 1 4 (1/4) = 0 /\ gradient_sine.h_v (1/2) (1/2) 1 4 = 4 * PI.
Proof.
  rewrite central_difference_of_sine__sine_in_v by lra. unfold_fields. rewrite sine_of_a_right_angle.
  replace (PI * (4 * (1/4))) with PI by field. replace (PI * (4 * (1/2))) with (2 * PI) by field. rewrite sin_PI, cos_2PI. unfold Rdiv. split; ring.
Qed.
Lemma no_difference_in_u : central_sine.h_u (1/2) (1/2) 4 1 (1/4) = 0 /\ gradient_sine.h_u (1/2) (1/2) 4 1 = 4 * PI.
Proof.
  rewrite central_difference_of_sine__sine_in_u by lra. unfold_fields. rewrite sine_of_a_right_angle.
  replace (PI * (4 * (1/4))) with PI by field. replace (PI * (4 * (1/2))) with (2 * PI) by field. rewrite sin_PI, cos_2PI. unfold Rdiv. split; ring.
Qed.
Lemma no_difference_of_rings : central_rings.h_v (1/2) 2 (1/4) = 0 /\ gradient_rings.h_v (1/2) 2 = 4 * PI.
Proof.
  rewrite central_difference_of_sine__rings_in_v by lra. unfold_fields.
  replace (PI * (2 * 2 * (1/4))) with PI by field. replace (PI * (2 * 2 * (1/2))) with (2 * PI) by field. rewrite sin_PI, cos_2PI. unfold Rdiv. split; ring.
Qed.
Theorem central_difference_of_sine__sine_in_v__false : ~ forall u v k_u k_v epsilon, 0 < epsilon -> central_sine.h_v u v k_u k_v epsilon = gradient_sine.h_v u v k_u k_v.
Proof. intro H. generalize (H (1/2) (1/2) 1 4 (1/4) ltac:(lra)) PI_RGT_0. destruct no_difference_in_v as [-> ->]. lra. Qed.
Theorem central_difference_of_sine__rings_in_v__false : ~ forall v k_v epsilon, 0 < epsilon -> central_rings.h_v v k_v epsilon = gradient_rings.h_v v k_v.
Proof. intro H. generalize (H (1/2) 2 (1/4) ltac:(lra)) PI_RGT_0. destruct no_difference_of_rings as [-> ->]. lra. Qed.
Theorem truncation_bound__sine__false : ~ forall u v k_u k_v epsilon, 0 < k_u -> 0 < epsilon -> 0 <= u - epsilon -> u + epsilon < 1 ->
  Rabs (central_sine.h_u u v k_u k_v epsilon - gradient_sine.h_u u v k_u k_v) <= epsilon ^ 2 / 12 * (PI * k_u) ^ 3.
Proof.
  intro H. generalize (H (1/2) (1/2) 4 1 (1/4) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). destruct no_difference_in_u as [-> ->].
  rewrite Rminus_0_l, Rabs_Ropp, Rabs_pos_eq by (generalize PI_RGT_0; lra). apply Rlt_not_le. interval.
Qed.
Theorem truncation_bound__sine_in_v__false : ~ forall u v k_u k_v epsilon, 0 < k_v -> 0 < epsilon -> 0 <= v - epsilon -> v + epsilon <= 1 ->
  Rabs (central_sine.h_v u v k_u k_v epsilon - gradient_sine.h_v u v k_u k_v) <= epsilon ^ 2 / 12 * (PI * k_v) ^ 3.
Proof.
  intro H. generalize (H (1/2) (1/2) 1 4 (1/4) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). destruct no_difference_in_v as [-> ->].
  rewrite Rminus_0_l, Rabs_Ropp, Rabs_pos_eq by (generalize PI_RGT_0; lra). apply Rlt_not_le. interval.
Qed.
Theorem truncation_bound__rings__false : ~ forall v k_v epsilon, 0 < k_v -> 0 < epsilon -> 0 <= v - epsilon -> v + epsilon <= 1 ->
  Rabs (central_rings.h_v v k_v epsilon - gradient_rings.h_v v k_v) <= epsilon ^ 2 / 6 * (PI * k_v) ^ 3.
Proof.
  intro H. generalize (H (1/2) 2 (1/4) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). destruct no_difference_of_rings as [-> ->].
  rewrite Rminus_0_l, Rabs_Ropp, Rabs_pos_eq by (generalize PI_RGT_0; lra). apply Rlt_not_le. interval.
Qed.
Theorem elementary_functions__sine__false : ~ forall r, -1 <= r <= 1 -> Rabs (half_turn_polynomials.sine_near r - sin (PI * r)) <= 1 / 2 ^ 56.
Proof.
  intro H. generalize (H 1 ltac:(lra)). apply Rlt_not_le. unfold half_turn_polynomials.sine_near, half_turn_polynomials.sine_tail, half_turn_polynomials.z.
  rewrite Rmult_1_r, sin_PI. interval with (i_prec 120).
Qed.
Theorem elementary_functions__zero__false : ~ forall r, half_turn_polynomials.sine_near r = 0.
Proof.
  intro H. generalize (H (1/4)). apply Rgt_not_eq. unfold half_turn_polynomials.sine_near, half_turn_polynomials.sine_tail, half_turn_polynomials.z. interval.
Qed.
Theorem algebraic_gradient__in_u__false : ~ forall n theta, complex_power n (- cos theta) (- sin theta) =
  (cos (PI * (INR n * ((theta + PI) / (2 * PI)))), sin (PI * (INR n * ((theta + PI) / (2 * PI))))).
Proof.
  intro H. generalize (f_equal fst (H 1%nat 0)). cbn. unfold complex_product.product_real. rewrite sin_0, cos_0.
  replace (PI * (1 * ((0 + PI) / (2 * PI)))) with (PI / 2) by (field; generalize PI_RGT_0; lra). rewrite cos_PI2. lra.
Qed.
Theorem algebraic_gradient__negative_power__false : ~ forall n phi, snd (complex_power n (cos phi) (sin phi)) = sin (- INR n * phi).
Proof. intro H. generalize (H 1%nat (PI / 2)). rewrite de_moivre. simpl. rewrite Ropp_mult_distr_l_reverse, Rmult_1_l, sin_neg, sin_PI2. lra. Qed.
Theorem algebraic_gradient__product__false : ~ forall a b c d, fst (Cmult (a, b) (c, d)) = a * c + b * d.
Proof. intro H. generalize (H 0 1 0 1). simpl. lra. Qed.
Theorem chart__inside__false : ~ forall phi, 0 <= phi <= PI -> chart.v (cos phi) (sin phi) < 1.
Proof.
  intro H. generalize PI_RGT_0. intro P. generalize (H PI ltac:(lra)). destruct (chart_inside 0 PI) as [-> _]; try lra. replace (PI / PI) with 1 by (field; lra). lra.
Qed.
Theorem chart_inverse__unit__false : ~ forall u v, fst (fst (N_of_chart u v)) = sin (PI * v) * cos (PI * (2 * u)).
Proof.
  intro H. generalize (H 0 (1/2)). rewrite (proj1 (chart_inverse_unit 0 (1/2))). cbn [fst]. replace (PI * (1/2)) with (PI / 2) by field.
  rewrite !Rmult_0_r, sin_PI2, cos_0. lra.
Qed.
Theorem tangent_frame__by_phi__false : ~ forall theta phi, is_derive (fun p => snd (normal_at theta p)) phi (sin phi).
Proof.
  intro H. generalize (is_derive_unique _ _ _ (H 0 (PI / 2))). generalize (tangent_frame__by_phi 0 (PI / 2)). unfold_vectors. intros (_ & _ & D).
  rewrite (is_derive_unique _ _ _ D), sin_PI2. lra.
Qed.
Theorem unit_length__g_is_tangent__false : ~ forall theta phi h_u h_v beta, dot (M theta phi h_u h_v beta) (g theta phi h_u h_v) = 0.
Proof. intro H. generalize (H 0 0 1 0 1). rewrite m_is_sum, dot_sum, dot_scaled, g_is_tangent, g_squared. lra. Qed.
Theorem angle_of_the_bump__arctangent__false : ~ forall theta phi h_u h_v beta,
  acos (dot (normal_at theta phi) (N' theta phi h_u h_v beta)) = Rabs beta * magnitude (g theta phi h_u h_v).
Proof.
  intro H. generalize (H 0 0 1 0 1). rewrite angle_of_the_bump__arctangent, (length_of_unit (g 0 0 1 0)) by (rewrite g_squared; ring).
  rewrite Rabs_R1, Rmult_1_r, atan_1. apply Rlt_not_eq. interval.
Qed.
Theorem seam__even_slopes__false : ~ forall v k_u k_v, gradient_sine.h_u 0 v k_u k_v = gradient_sine.h_u 1 v k_u k_v.
Proof. exact seam__sine_jump__false. Qed.
Theorem seam__odd_slopes__false : ~ forall v k_v n, gradient_sine.h_u 0 v (IZR (2 * n + 1)) k_v = gradient_sine.h_u 1 v (IZR (2 * n + 1)) k_v.
Proof.
  intro H. generalize (H (1/2) 1 0%Z) (proj2 (proj2 (seam__odd_slopes (1/2) 1 0))) PI_RGT_0. intros ->. rewrite sine_of_a_right_angle. simpl. lra.
Qed.
Theorem seam__ridges_even__false : ~ forall v k_u k_v, height_ridges.h 1 v k_u k_v = 0.
Proof.
  intro H. generalize (H (1/2) (1/2) 1). unfold_fields. rewrite sine_of_a_right_angle. replace (PI * (1/2 * 1)) with (PI / 2) by field. rewrite sin_PI2, Rmult_1_l, Rabs_R1. lra.
Qed.
Theorem seam__even_period__false : ~ forall u v k_v n, height_sine.h (u + 1) v (INR n) k_v = height_sine.h u v (INR n) k_v.
Proof.
  intro H. generalize (H (1/2) (1/2) 1 1%nat). unfold_fields. rewrite seam_parity. simpl INR. rewrite sine_of_a_right_angle. simpl. lra.
Qed.
Theorem seam__ridges_jumps__false : ~ forall v k_u k_v, 0 < height_ridges.h 1 v k_u k_v.
Proof. intro H. generalize (H 0 1 1). unfold_fields. rewrite !Rmult_0_r, sin_0, Rmult_0_r, Rabs_R0. lra. Qed.
