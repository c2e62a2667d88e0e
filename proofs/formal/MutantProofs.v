(* What Mutants.v prints: that the variants of claims are false, and those of false statements true. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Camera Claim Hits Claims.
From Formal Require Mutants.
Open Scope R_scope.

Theorem attached_shadow__in_light_2__true : Mutants.attached_shadow__in_light_2__true.
Proof.
  red. intros beta gx gy gz nx ny nz wx wy wz mx my mz l s bx by_ bz U T F _ G.
  assert (S : mx ^ 2 + my ^ 2 + mz ^ 2 = beta ^ 2 * (gx ^ 2 + gy ^ 2 + gz ^ 2) + 1) by (rewrite <- U; transitivity (beta ^ 2 * (gx ^ 2 + gy ^ 2 + gz ^ 2) + 2 * beta * (gz * nz + gx * nx + gy * ny) + (nz * nz + nx * nx + ny * ny)); [lines; ring | rewrite T; ring]).
  assert (0 <= beta ^ 2 * (gx ^ 2 + gy ^ 2 + gz ^ 2)) by (apply Rmult_le_pos; nra). assert (L : 0 < l) by (apply sqrt_lt_R0; lra).
  split; [lra | split; [lra |]]. replace (bz * wz + bx * wx + by_ * wy) with (/ l * (beta * (gz * wz + gx * wx + gy * wy) + (nz * wz + nx * wx + ny * wy))) by (unfold bx, by_, bz, s, mx, my, mz; ring).
  apply Rmult_gt_0_compat; [apply Rinv_0_lt_compat, L | lra].
Qed.
Theorem attached_shadow__in_light_1__true : Mutants.attached_shadow__in_light_1__true.
Proof. red. intros. apply attached_shadow__in_light_2__true; trivial. subst beta. lra. Qed.
Theorem highlight_below_one__root_1__true : Mutants.highlight_below_one__root_1__true.
Proof. red. intros b x X _ B S. pose proof (sqrt_pos x). assert (E : sqrt x * sqrt x = x) by (apply sqrt_sqrt; lra). split; [exact X | nra]. Qed.
Theorem highlight_below_one__any_bound_2__true : Mutants.highlight_below_one__any_bound_2__true.
Proof. red. intros b z B Z E. assert (0 < z) by nra. rewrite sqrt_pow2 by lra. repeat split; nra. Qed.
Theorem periodic_u_saves_the_seam__slope_1__true : Mutants.periodic_u_saves_the_seam__slope_1__true.
Proof. red. intros. rewrite Rmult_0_l, Rmult_1_l, Rmult_0_r, cos_0, H. ring. Qed.
Theorem periodic_u_saves_the_seam__height_2__true : Mutants.periodic_u_saves_the_seam__height_2__true.
Proof. red. intros. rewrite Rmult_0_l, Rmult_1_l, Rmult_0_r, sin_0, H. ring. Qed.
Theorem ridges_differentiable__one_slope_1__true : Mutants.ridges_differentiable__one_slope_1__true.
Proof. red. intros ku kv u v _ Z. replace (PI * (kv * v)) with (v * PI * kv) by ring. rewrite Z, Rmult_0_r, Rabs_R0. ring. Qed.
Theorem ridges_differentiable__one_slope_2__true : Mutants.ridges_differentiable__one_slope_2__true.
Proof. red. intros ku kv u v _ ->. rewrite !Rmult_0_l, Rabs_R0. ring. Qed.
Theorem seed_bump_as_displacement__parallel_1__true : Mutants.seed_bump_as_displacement__parallel_1__true.
Proof. red. intros. subst beta. split; [lra | lines; field; lra]. Qed.
Theorem seed_bump_as_displacement__parallel_2__true : Mutants.seed_bump_as_displacement__parallel_2__true.
Proof. red. intros. subst h_u. split; [lra | lines; field; lra]. Qed.
Theorem seed_clamp__odd_1__true : Mutants.seed_clamp__odd_1__true.
Proof. red. intros. split; [lra | field; lra]. Qed.
Theorem seed_clamp__not_odd_2__true : Mutants.seed_clamp__not_odd_2__true.
Proof. red. intros. split; [lra | field; lra]. Qed.
Theorem seed_covers_the_view__covers_1__false : Mutants.seed_covers_the_view__covers_1__false.
Proof. intro F. generalize (F 0 0). lra. Qed.
Theorem seed_covers_the_view__before_2__false : Mutants.seed_covers_the_view__before_2__false.
Proof. intro F. generalize (F 9 1). rewrite sqrt_1. lra. Qed.
Theorem seed_covers_the_view__behind_3__false : Mutants.seed_covers_the_view__behind_3__false.
Proof. intro F. generalize (F 4 1 (3 / 4) 0 0). lra. Qed.
Theorem seed_orientation__right_handed_2__true : Mutants.seed_orientation__right_handed_2__true.
Proof. claim. Qed.
Theorem seed_pole_rows__raster_below_far_2__true : Mutants.seed_pole_rows__raster_below_far_2__true.
Proof. red. intros m n M N. destruct (pixels_off_the_pole__raster_below m n M N) as (_ & _ & R). lra. Qed.
Theorem seed_pole_rows__only_near_3__true : Mutants.seed_pole_rows__only_near_3__true.
Proof. red. intros. nra. Qed.
Theorem seed_quadratic_of_b__agree_2__true : Mutants.seed_quadratic_of_b__agree_2__true.
Proof. red. intros. subst eye. ring. Qed.
Theorem seed_step_in_beta__linear_1__true : Mutants.seed_step_in_beta__linear_1__true.
Proof. red. intros. field. Qed.
Theorem seed_truncation_slope__descends_1__true : Mutants.seed_truncation_slope__descends_1__true.
Proof. red. intros. rewrite Rabs_Ropp, Rabs_pos_eq; lra. Qed.
Theorem seed_truncation_slope__descends_2__true : Mutants.seed_truncation_slope__descends_2__true.
Proof. red. intros e w W E S. rewrite Rabs_Ropp, Rabs_pos_eq by lra. replace (1 / 6 * e ^ 2 * w ^ 3) with (w * (e ^ 2 * w ^ 2) / 6) by field. nra. Qed.
Theorem sine_is_smooth_everywhere__one_limit_1__true : Mutants.sine_is_smooth_everywhere__one_limit_1__true.
Proof. red. intros. subst k_v. ring. Qed.
Theorem specular_lipschitz__twice_1__false : Mutants.specular_lipschitz__twice_1__false.
Proof. intro F. assert (S : sqrt 2 ^ 2 = 2) by (apply pow2_sqrt; lra). pose proof (sqrt_pos 2). generalize (F 1 (sqrt 2) 0 0 2). nra. Qed.
Theorem specular_lipschitz__mirror_2__false : Mutants.specular_lipschitz__mirror_2__false.
Proof. intro F. generalize (F 0 1 0 0 0 1 0 0 1). lra. Qed.
Theorem specular_lipschitz__power_3__false : Mutants.specular_lipschitz__power_3__false.
Proof. intro F. generalize (F 0 0 1 0 1 1 1 0). lra. Qed.
(* At x = 1, z = 0, after one step. *)
Theorem specular_lipschitz__factors_4__false : Mutants.specular_lipschitz__factors_4__false.
Proof.
  intro F. set (run := nat_rect (fun _ => R)). set (z := run 1 (fun _ s => s * 0)). set (p := run 0 (fun _ s => s + 1)). set (g := run 0 (fun n s => s + z n)).
  destruct (F 1 0 (run 1 (fun _ s => s * 1)) z p (run 0 (fun _ s => s * 1)) g (run 0 (fun n s => s * 1 + p n)) (run 0 (fun n s => s * 1 + g n))
    eq_refl ltac:(reflexivity) eq_refl ltac:(reflexivity) eq_refl ltac:(reflexivity) eq_refl ltac:(reflexivity) eq_refl ltac:(reflexivity) eq_refl ltac:(reflexivity) eq_refl ltac:(reflexivity) 1%nat) as [E _].
  simpl in E. lra.
Qed.
Lemma two_away : sqrt ((2 - 0) ^ 2 + (0 - 0) ^ 2 + (0 - 0) ^ 2) = 2.
Proof. replace (_ + _) with (2 ^ 2) by ring. apply sqrt_pow2. lra. Qed.
Theorem squared_highlight__halfway_1__false : Mutants.squared_highlight__halfway_1__false.
Proof. intro F. generalize (F 2 0 0 0 0 0 0). cbv zeta. rewrite two_away. lra. Qed.
Theorem squared_highlight__base_2__false : Mutants.squared_highlight__base_2__false.
Proof. intro F. generalize (F 2 1 1 1 1 2). lra. Qed.
Theorem squared_highlight__opposite_3__false : Mutants.squared_highlight__opposite_3__false.
Proof. intro F. generalize (F 1 0 0 2 0 0 0 0 0 1 0 0). cbv zeta. rewrite two_away. destruct Rlt_dec; lra. Qed.

Lemma sine_of_minus_right : sin (- (PI / 2)) = -1.
Proof. rewrite sin_neg, sin_PI2. ring. Qed.
Lemma cosine_of_minus_right : cos (- (PI / 2)) = 0.
Proof. rewrite cos_neg. apply cos_PI2. Qed.
Lemma half_turn : 31 / 10 < PI < 32 / 10 /\ 31 < PI ^ 3 < 311 / 10.
Proof. repeat split; interval. Qed.
(* A variant at a point: sines and cosines of right angles, roots of squares, and cases of numbers are known. *)
Ltac right_angle f a b value law := replace (f a) with value by (replace a with b by (field; try apply Rgt_not_eq, PI_RGT_0); symmetry; exact law).
Ltac known_angle := match goal with
  | |- context [sin ?a] => first [right_angle sin a 0 0 sin_0 | right_angle sin a (PI / 2) 1 sin_PI2 | right_angle sin a PI 0 sin_PI | right_angle sin a (3 * (PI / 2)) (-1) sin_3PI2
      | right_angle sin a (2 * PI) 0 sin_2PI | right_angle sin a (- (PI / 2)) (-1) sine_of_minus_right]
  | |- context [cos ?a] => first [right_angle cos a 0 1 cos_0 | right_angle cos a (PI / 2) 0 cos_PI2 | right_angle cos a PI (-1) cos_PI | right_angle cos a (3 * (PI / 2)) 0 cos_3PI2
      | right_angle cos a (2 * PI) 1 cos_2PI | right_angle cos a (- (PI / 2)) 0 cosine_of_minus_right] end.
Ltac known_root r := match goal with |- context [sqrt ?x] => replace (sqrt x) with r by (symmetry; apply sqrt_lem_1; lra) end.
Ltac refuted_at point := generalize point half_turn; cbv beta zeta; repeat known_angle; repeat first [known_root 1 | known_root 2 | known_root 0 | known_root 3 | known_root (1 / 2) | known_root (5 / 4) | known_root (5 / 3) | known_root 4 | known_root 5 | known_root (3 / 5) | known_root (4 / 5)];
  solve [lra | unfold Rmax, Rmin, Rabs; repeat (match goal with |- context [if ?d then _ else _] => destruct d end; try lra) | cases; lra].

Theorem algebraic_gradient__square_5__false : Mutants.algebraic_gradient__square_5__false.
Proof. intro F. refuted_at (F (PI)). Qed.
Theorem chart__range_1__false : Mutants.chart__range_1__false.
Proof. intro F. refuted_at (F (1/2) (1/2)). Qed.
Theorem chart__seam_2__false : Mutants.chart__seam_2__false.
Proof. intro F. refuted_at (F 1). Qed.
Theorem chart_inverse__formula_1__false : Mutants.chart_inverse__formula_1__false.
Proof. intro F. refuted_at (F (1/2) (1/2)). Qed.
Theorem clamped_difference__first_order_1__false : Mutants.clamped_difference__first_order_1__false.
Proof. intro F. refuted_at (F 0 (1/2) (1/2) (1/4) (3/5) (-1) (1/4)). Qed.
Theorem clamped_difference__at_the_pole_itself_2__false : Mutants.clamped_difference__at_the_pole_itself_2__false.
Proof. intro F. refuted_at (F (3/4) (1/4)). Qed.
Theorem clamped_difference__clamp_3__false : Mutants.clamped_difference__clamp_3__false.
Proof. intro F. refuted_at (F 1 0). Qed.
Theorem straddling__value_1__false : Mutants.straddling__value_1__false.
Proof. intro F. refuted_at (F 0 (1/2) 1). Qed.
Theorem straddling__every_crease_4__false : Mutants.straddling__every_crease_4__false.
Proof. intro F. refuted_at (F 0 (1/2)). Qed.
Theorem tangent_frame__right_handed_1__false : Mutants.tangent_frame__right_handed_1__false.
Proof. intro F. refuted_at (F (-1) 1 1 0). Qed.
Theorem central_difference_of_sine__no_clamp_4__false : Mutants.central_difference_of_sine__no_clamp_4__false.
Proof. intro F. refuted_at (F (1/4) (4/5)). Qed.
Theorem gradients__sine_2__false : Mutants.gradients__sine_2__false.
Proof. intro F. refuted_at (F 1 (1/2) 1 0 (1/2)). Qed.
Theorem gradients__rings_3__false : Mutants.gradients__rings_3__false.
Proof. intro F. refuted_at (F (1/2) (-1) (-1)). Qed.
Theorem hit_of_b__quadratic_1__false : Mutants.hit_of_b__quadratic_1__false.
Proof. intro F. refuted_at (F (-1) 0 1 0 (-1) 0 (-1)). Qed.
Theorem hit_of_b__behind_4__false : Mutants.hit_of_b__behind_4__false.
Proof. intro F. refuted_at (F (3/5) 0 1 2 (3/5) (-1) 2 0 0). Qed.
Theorem ridges_on_creases__crease_in_u_1__false : Mutants.ridges_on_creases__crease_in_u_1__false.
Proof. intro F. refuted_at (F 1 (-1) 1 1 (-1)). Qed.
Theorem ridges_on_creases__differ_3__false : Mutants.ridges_on_creases__differ_3__false.
Proof. intro F. refuted_at (F 1 0 0 0). Qed.
Theorem rounded_powers__product_1__false : Mutants.rounded_powers__product_1__false.
Proof. intro F. refuted_at (F (217/512) (17/64) 0 0 (17/64) 0 0 1 1 0 0 (1/8)). Qed.
Theorem rounded_powers__power_2__false : Mutants.rounded_powers__power_2__false.
Proof. intro F. refuted_at (F 1 2 2 7 1 1 2 4 2). Qed.
Theorem rounded_powers__factors_3__false : Mutants.rounded_powers__factors_3__false.
Proof. intro F. refuted_at (F (1/2) 2 4 (3/4) (-2) (3/2)). Qed.
Theorem roundoff_bound__in_u_1__false : Mutants.roundoff_bound__in_u_1__false.
Proof. intro F. refuted_at (F 0 1 1 0 1 0 0 (-1) 1 0). Qed.
Theorem roundoff_bound__in_u_2__false : Mutants.roundoff_bound__in_u_2__false.
Proof. intro F. refuted_at (F 1 1 0 0 1 0 0 (-1) 1 1). Qed.
Theorem roundoff_bound__two_roundings_3__false : Mutants.roundoff_bound__two_roundings_3__false.
Proof. intro F. refuted_at (F (1/4) (25/16) (1/4) (1/4)). Qed.
Theorem roundoff_bound__three_roundings_4__false : Mutants.roundoff_bound__three_roundings_4__false.
Proof. intro F. refuted_at (F (1/4) (25/12) (1/4) (-1/4) (1/4)). Qed.
Theorem lagrange_identity__of_b_1__false : Mutants.lagrange_identity__of_b_1__false.
Proof. intro F. refuted_at (F 1 1 1 1 1 0 0). Qed.
Theorem lagrange_identity__of_shadow_2__false : Mutants.lagrange_identity__of_shadow_2__false.
Proof. intro F. refuted_at (F (-1) 0 0 1 0 1 1 1 1 1). Qed.
Theorem shadow_out_of_reach__turns_between_2__false : Mutants.shadow_out_of_reach__turns_between_2__false.
Proof. intro F. refuted_at (F (-1) 1 2 (-1) 1). Qed.
Theorem shadow_out_of_reach__quadratic_3__false : Mutants.shadow_out_of_reach__quadratic_3__false.
Proof. intro F. refuted_at (F 1 (-1) 1 1 (-1) 0 1 (-1) 0 1 0 (-1)). Qed.
Theorem pole__sine_1__false : Mutants.pole__sine_1__false.
Proof. intro F. refuted_at (F (-1) 1 (-PI/2)). Qed.
Theorem pole__rings_2__false : Mutants.pole__rings_2__false.
Proof. intro F. refuted_at (F (-1) (-PI/2)). Qed.
Theorem ridges_at_crossings__flat_1__false : Mutants.ridges_at_crossings__flat_1__false.
Proof. intro F. refuted_at (F 1 (-1) 1 1 2 2). Qed.
Theorem ridges_at_crossings__crossing_3__false : Mutants.ridges_at_crossings__crossing_3__false.
Proof. intro F. refuted_at (F 1 1 2 1 0 (1/2)). Qed.
Theorem best_step__least_1__false : Mutants.best_step__least_1__false.
Proof. intro F. refuted_at (F 1 1 2 2). Qed.
Theorem best_step__least_2__false : Mutants.best_step__least_2__false.
Proof. intro F. refuted_at (F 1 1 1 (1/2)). Qed.
Theorem mean_keeps_the_bound__one_more_1__false : Mutants.mean_keeps_the_bound__one_more_1__false.
Proof. intro F. refuted_at (F 1 1 0 0). Qed.
Theorem mean_keeps_the_bound__one_more_2__false : Mutants.mean_keeps_the_bound__one_more_2__false.
Proof. intro F. refuted_at (F 1 (3/5) (-1) 2). Qed.
Theorem mean_keeps_the_bound__one_more_3__false : Mutants.mean_keeps_the_bound__one_more_3__false.
Proof. intro F. refuted_at (F 0 0 1 1). Qed.
Theorem clamped_difference_of_odd__second_order_1__false : Mutants.clamped_difference_of_odd__second_order_1__false.
Proof. intro F. refuted_at (F (-2) (-1) (1/3) 2 3 (1/8)). Qed.
Theorem clamped_difference_of_odd__second_order_2__false : Mutants.clamped_difference_of_odd__second_order_2__false.
Proof. intro F. refuted_at (F 1 (-1) 1 (-1) 1 (-1) 0). Qed.
Theorem clamped_difference_of_odd__odd_3__false : Mutants.clamped_difference_of_odd__odd_3__false.
Proof. intro F. refuted_at (F 0). Qed.
Theorem clamped_difference_of_odd__second_order_sharp_4__false : Mutants.clamped_difference_of_odd__second_order_sharp_4__false.
Proof. intro F. refuted_at (F (1/2) (1/4)). Qed.
Theorem unit_length__length_1__false : Mutants.unit_length__length_1__false.
Proof. intro F. refuted_at (F (-1) 1 (-1) 0 0 0 (-1)). Qed.
Theorem unit_length__length_2__false : Mutants.unit_length__length_2__false.
Proof. intro F. refuted_at (F (-1) 0 (-1) 1 (-1) 0 0). Qed.
Theorem unit_length__length_3__false : Mutants.unit_length__length_3__false.
Proof. intro F. refuted_at (F 2 0 0 0 0 0 1). Qed.
Theorem unit_length__length_4__false : Mutants.unit_length__length_4__false.
Proof. intro F. refuted_at (F 1 (-1) 0 (-1) 1 0 0). Qed.
Theorem silhouette_of_a__tangent_3__false : Mutants.silhouette_of_a__tangent_3__false.
Proof. intro F. refuted_at (F (3/4) (3/5) (-3/5) (-4/5)). Qed.
Theorem seam__sine_2__false : Mutants.seam__sine_2__false.
Proof. intro F. refuted_at (F (1/2) (1/2) 1). Qed.
Theorem seam__ridges_3__false : Mutants.seam__ridges_3__false.
Proof. intro F. refuted_at (F (1/2) (1/2) (-1)). Qed.
Theorem silhouette_of_b__conic_1__false : Mutants.silhouette_of_b__conic_1__false.
Proof. intro F. refuted_at (F (-1) 1 1 (-1) 0). Qed.
Theorem silhouette_of_b__hyperbola_2__false : Mutants.silhouette_of_b__hyperbola_2__false.
Proof. intro F. refuted_at (F 1 (-1) 1 1 1). Qed.
Theorem crease_error_area__in_v_1__false : Mutants.crease_error_area__in_v_1__false.
Proof. intro F. refuted_at (F 3 1). Qed.
Theorem bump_is_not_displacement__only_where_flat_1__false : Mutants.bump_is_not_displacement__only_where_flat_1__false.
Proof. intro F. refuted_at (F 0 0 1 0 1 1 1 0). Qed.
Theorem angle_of_the_bump__angle_3__false : Mutants.angle_of_the_bump__angle_3__false.
Proof. intro F. refuted_at (F 0 0 0 0 1 0 0). Qed.
Theorem chart__round_trip_3__false : Mutants.chart__round_trip_3__false.
Proof. intro F. refuted_at (F 0). Qed.
Theorem gradients__sine_1__false : Mutants.gradients__sine_1__false.
Proof. intro F. refuted_at (F 1 1 0 (1/2)). Qed.
Theorem truncation_bound__rings_1__false : Mutants.truncation_bound__rings_1__false.
Proof. intro F. refuted_at (F (1/4) 1 (1/2)). Qed.
Theorem truncation_bound__apart_3__false : Mutants.truncation_bound__apart_3__false.
Proof. intro F. refuted_at (F 1 3 (-3)). Qed.
Theorem third_derivative_at_eight__at_eight_1__false : Mutants.third_derivative_at_eight__at_eight_1__false.
Proof. intro F. refuted_at F. Qed.
Theorem third_derivative_at_eight__at_four_2__false : Mutants.third_derivative_at_eight__at_four_2__false.
Proof. intro F. refuted_at F. Qed.
Theorem straddling__value_2__false : Mutants.straddling__value_2__false.
Proof. intro F. refuted_at (F (1/2) 1 1). Qed.
Theorem central_difference_of_sine__sine_in_u_3__false : Mutants.central_difference_of_sine__sine_in_u_3__false.
Proof. intro F. refuted_at (F (1/4) 2 (1/2) (1/2) 3). Qed.
Theorem silhouette_of_b__branch_3__false : Mutants.silhouette_of_b__branch_3__false.
Proof. intro F. refuted_at (F 0 1 1 1 (1/2) 0 0). Qed.
