(* What Mutants.v prints: that the variants of claims are false, and those of false statements true. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
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
Theorem squared_highlight__halfway_3__false : Mutants.squared_highlight__halfway_3__false.
Proof. intro F. generalize (F 2 0 0 0 0 0 0). cbv zeta. rewrite two_away. lra. Qed.
