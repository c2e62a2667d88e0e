(* False variants, of statements whose files do not refute one beside them. *)

From Coq Require Import Reals Lra Psatz Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Vectors Fields Bump Creases Algebraic Points.
Open Scope R_scope.

Theorem kink_loci__between__false : ~ forall u v k_u k_v, 0 < height_ridges.h u v k_u k_v.
Proof. intro H. generalize (H 0 0 1 1). unfold_fields. rewrite !Rmult_0_r, sin_0, Rmult_0_r, Rabs_R0. lra. Qed.
Theorem elementary_functions__sine__false : ~ forall r, -1 <= r <= 1 -> Rabs (half_turn_polynomials.sine_near r - sin (PI * r)) <= 1 / 2 ^ 56.
Proof.
  intro H. generalize (H 1 ltac:(lra)). apply Rlt_not_le. unfold half_turn_polynomials.sine_near, half_turn_polynomials.sine_tail, half_turn_polynomials.z.
  rewrite Rmult_1_r, sin_PI. interval with (i_prec 120).
Qed.
Theorem elementary_functions__zero__false : ~ forall r, half_turn_polynomials.sine_near r = 0.
Proof.
  intro H. generalize (H (1/4)). apply Rgt_not_eq. unfold half_turn_polynomials.sine_near, half_turn_polynomials.sine_tail, half_turn_polynomials.z. interval.
Qed.
Theorem roundoff_bound__three_roundings__false : ~ forall mu d1 d2 d3, 0 < mu < 1 -> Rabs d1 <= mu -> Rabs d2 <= mu -> Rabs d3 <= mu ->
  Rabs ((1 + d1) * (1 + d2) / (1 + d3) - 1) <= 2 * mu + mu ^ 2.
Proof.
  assert (A : Rabs (1/2) <= 1/2) by (rewrite Rabs_pos_eq; lra). assert (B : Rabs (- (1/2)) <= 1/2) by (rewrite Rabs_Ropp; exact A).
  intro H. generalize (H (1/2) (1/2) (1/2) (- (1/2)) ltac:(lra) A A B). replace (_ - 1) with (7/2) by field. rewrite Rabs_pos_eq; lra.
Qed.
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
Theorem clamped_difference__first_order_sharp__false : ~ forall v epsilon, 0 <= v < epsilon -> let h w := (w - v) * Rabs (w - v) / 2 in
  (h (v + epsilon) - h 0) / (v + epsilon) - Derive h v = 0.
Proof. intro H. generalize (H 0 1 ltac:(lra)) (proj2 (proj2 (clamped_difference__first_order_sharp 0 1 ltac:(lra)))). cbv beta zeta. intros -> E. lra. Qed.
Theorem clamped_difference_of_odd__second_order_sharp__false : ~ forall v epsilon, 0 <= v < epsilon -> let h w := w ^ 3 / 6 in
  (h (v + epsilon) - h 0) / (v + epsilon) - Derive h v = 0.
Proof. intro H. generalize (H 0 1 ltac:(lra)). generalize (clamped_difference_of_odd__second_order_sharp 0 1 ltac:(lra)). cbv beta zeta. intros -> E. lra. Qed.
Theorem clamped_difference__at_the_pole_itself__false : ~ forall epsilon, 0 < epsilon -> let h w := w ^ 2 / 2 in (h (0 + epsilon) - h 0) / (0 + epsilon) - Derive h 0 = 0.
Proof. intro H. generalize (H 1 ltac:(lra)). generalize (clamped_difference__at_the_pole_itself 1 ltac:(lra)). cbv beta zeta. intros -> E. lra. Qed.
Theorem clamped_difference_of_odd__odd__false : ~ forall u v k_u k_v, height_sine.h u (- v) k_u k_v = height_sine.h u v k_u k_v.
Proof.
  intro H. generalize (H (1/2) (1/2) 1 1). rewrite (proj1 (clamped_difference_of_odd__odd _ _ _ _)). unfold_fields. rewrite sine_of_a_right_angle. lra.
Qed.
Lemma sine_of_one_and_a_half : sin (PI * (1 * (3/2))) = -1.
Proof. rewrite <- sine_of_three_right_angles. f_equal. field. Qed.
Theorem clamped_difference_of_odd__first_ridge__false : ~ forall u v k_u k_v, height_ridges.h u v k_u k_v = Rabs (sin (PI * (k_u * u))) * sin (PI * (k_v * v)).
Proof.
  intro H. generalize (H (1/2) (3/2) 1 1). unfold_fields. rewrite sine_of_a_right_angle, sine_of_one_and_a_half, Rmult_1_l, Rabs_m1, Rabs_R1. lra.
Qed.
Theorem straddling__at_the_crease__false : ~ forall k epsilon, 0 < k -> 0 < epsilon <= 1 / k ->
  (Rabs (sin (PI * (k * (0 / k + epsilon)))) - Rabs (sin (PI * (k * (0 / k - epsilon))))) / (2 * epsilon) = PI * k.
Proof. intro H. generalize (H 1 1 ltac:(lra) ltac:(lra)) (straddling__at_the_crease 1 1 0 ltac:(lra) ltac:(lra)) PI_RGT_0. cbv beta zeta. intros -> E. lra. Qed.
Theorem ridges_on_creases__crease_in_u__false : ~ forall v k_u k_v s, height_ridges.h (0 / k_u + s) v k_u k_v = sin (PI * (k_u * s)) * Rabs (sin (PI * (k_v * v))).
Proof.
  intro H. generalize (H (1/2) 1 1 (3/2)). rewrite (ridges_on_creases__crease_in_u _ _ _ _ 0) by lra. rewrite sine_of_a_right_angle, sine_of_one_and_a_half, Rabs_m1, Rabs_R1. lra.
Qed.
Theorem ridges_on_creases__crease_in_v__false : ~ forall u k_u k_v s, height_ridges.h u (0 / k_v + s) k_u k_v = Rabs (sin (PI * (k_u * u))) * sin (PI * (k_v * s)).
Proof.
  intro H. generalize (H (1/2) 1 1 (3/2)). rewrite (ridges_on_creases__crease_in_v _ _ _ _ 0) by lra. rewrite sine_of_a_right_angle, sine_of_one_and_a_half, Rabs_m1, Rabs_R1. lra.
Qed.
Theorem ridges_on_creases__quotients__false : ~ forall A k s, 0 <= A -> 0 < k -> 0 < s <= 1 / k -> PI * k * A * (1 - (PI * (k * s)) ^ 2 / 12) <= Rabs (sin (PI * (k * s))) * A / s.
Proof.
  intro H. generalize (H 1 1 (1/2) ltac:(lra) ltac:(lra) ltac:(lra)). rewrite sine_of_a_right_angle, Rabs_R1. apply Rlt_not_le. interval.
Qed.
Theorem ridges_on_creases__differ_in_v__false : ~ forall u v k_u k_v, ex_derive (fun v => height_ridges.h u v k_u k_v) v.
Proof. intro H. apply (ridges_on_creases__differ_in_v (1/2) 1 1 0); [lra | rewrite sine_of_a_right_angle; lra | apply H]. Qed.
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
