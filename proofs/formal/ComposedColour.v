(* From the central difference to the colour: what the step, the roundings of the difference and those of the colour cost in all. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Formal Require Import Formulas Float Float64 Vectors Bump Shading RoundedHalfTurns RoundedGradient RoundedDifference EnclosingRules RoundedColour.
Open Scope R_scope.

Lemma slopes_apart theta phi a_u a_v b_u b_v E F : Rabs (a_u - b_u) <= E -> Rabs (a_v - b_v) <= F -> magnitude (difference (g theta phi a_u a_v)
  (g theta phi b_u b_v)) <= sqrt (E ^ 2 + F ^ 2).
Proof.
  intros U V. replace (difference _ _) with (g theta phi (a_u - b_u) (a_v - b_v)) by (unfold_vectors; f_equal; [f_equal|]; ring).
  unfold magnitude. rewrite g_squared. apply sqrt_le_1_alt, Rplus_le_compat; apply pow_maj_Rabs; assumption.
Qed.
(* Wherever the difference is taken. *)
Lemma error_anywhere L w e : 0 <= L -> 0 < e -> e + w <= 1 -> error_bound L w e <= error_bound L (1 - e) e.
Proof.
  intros P E W. apply Rplus_le_compat_r, Rplus_le_compat_l. apply Rmult_le_compat_r; [unfold kappa_unclamped; lra|]. apply Rmult_le_compat_r; [left;
    apply Rinv_0_lt_compat, E|]. apply Rmult_le_compat_l; lra.
Qed.
(* The colour of sine by the float64 difference, and that of its exact slopes: apart by what the step and the wave numbers say, and by delta, what the
  roundings of the frame and of the gradient cost N + beta g. *)
Theorem colour_accuracy__of_the_difference theta phi u v k_u k_v epsilon nx ny nz gx gy gz beta px py pz lx ly lz b i a kd ks p : let m2 := (beta
  * gz + nz) * (beta * gz + nz) + (beta * gx + nx) * (beta * gx + nx) + (beta * gy + ny) * (beta * gy + ny) in let d2 := (lz - pz) * (lz - pz) +
  (lx - px) * (lx - px) + (ly - py) * (ly - py) in let h_u := central_any_float64.h_u height_sine_float64.h u v k_u k_v epsilon in let h_v :=
  central_any_float64.h_v height_sine_float64.h u v k_u k_v epsilon in let m := (beta * gx + nx, beta * gy + ny, beta * gz + nz) in let delta :=
  magnitude (difference m (M theta phi h_u h_v beta)) in let mu' := light_direction_float64.mu px py pz lx ly lz (perturbed_float64.bumped_x nx ny
  nz gx gy gz beta) (perturbed_float64.bumped_y nx ny nz gx gy gz beta) (perturbed_float64.bumped_z nx ny nz gx gy gz beta) in let exact := mu
  (px, py, pz) (lx, ly, lz) (N' theta phi (gradient_sine.h_u u v k_u k_v) (gradient_sine.h_v u v k_u k_v) beta) in let slopes := sqrt (error_bound
  (PI * k_u) (1 - epsilon) epsilon ^ 2 + error_bound (PI * k_v) (1 - epsilon) epsilon ^ 2) in sampled_in_u k_u u epsilon -> sampled_in_v k_v v
  epsilon -> carried k_u u -> carried k_v v -> m2 >= 1 -> m2 <= 2 ^ 900 -> (beta * gx) ^ 2 <= m2 -> (beta * gy) ^ 2 <= m2 -> (beta * gz) ^ 2 <= m2
  -> d2 >= / 1099511627776 -> d2 <= 2 ^ 900 -> b >= 0 -> i >= 0 -> a >= 0 -> kd >= 0 -> ks >= 0 -> p >= 0 -> i <= 2 ^ 20 -> a <= 2 ^ 20 -> Rabs
  (clip_float64.clipped (light_term_float64.lit_red b i a kd ks mu' p) - clip.clipped (light_term.lit_red b i a kd ks exact p)) <= 8 /
  9007199254740992 * (i * (a * kd * Rmax 0 mu' + ks * p) + b) + / 1000000000000000000000000000000 + i * (a * kd * (81 * unit53)) + i * (a * kd *
  (delta + Rabs beta * slopes)).
Proof.
  intros m2 d2 h_u h_v m delta mu' exact slopes Su Sv Cu Cv. intros. pose proof proj1 (difference_bounds__in_float64_u _ _ _ _ _ Su Cv) as Eu.
    pose proof proj1 (difference_bounds__in_float64_v _ _ _ _ _ Sv Cu) as Ev.
  eapply through; [apply (composed_colour nx ny nz gx gy gz beta px py pz lx ly lz b i a kd ks p); assumption|]. at_most_by difference_bound_clip;
    apply share_moves; try assumption.
  change (light_direction.mu _ _ _ _ _ _ _ _ _) with (mu (px, py, pz) (lx, ly, lz) (perturbed.bumped_x nx ny nz gx gy gz beta, perturbed.bumped_y nx
    ny nz gx gy gz beta, perturbed.bumped_z nx ny nz gx gy gz beta)).
  replace (perturbed.bumped_x _ _ _ _ _ _ _, _, _) with (scaled (/ magnitude m) m) by (perturbed.lines; rewrite <- !Rsqr_pow2; reflexivity).
  apply through with (mu (px, py, pz) (lx, ly, lz) (N' theta phi h_u h_v beta)); (eapply Rle_trans; [apply mu_is_lipschitz, sqrt_lt_R0; unfold
    difference, vector_sum, scaled, dot; unfold d2 in *; lra|]).
  - rewrite bumped_is_scaled. eapply Rle_trans; [apply normalised_apart; [|apply m_length_at_least_1] | apply Rmin_l]. rewrite <- sqrt_1. apply
    sqrt_le_1_alt. unfold m, dot. unfold m2 in *. lra.
  - eapply Rle_trans; [apply bump_moved | at_most_by Rmin_l]. apply Rmult_le_compat_l; [apply Rabs_pos|]. pose proof PI_RGT_0 as pi.
    destruct Su as (_ & _ & ? & ? & W & _), Sv as (_ & _ & ? & ? & ? & _). apply up_to_1 in W. apply slopes_apart; (eapply Rle_trans; [eassumption |
      apply error_anywhere; nra]).
Qed.
Theorem colour_accuracy__of_the_difference__point : exists u v k_u k_v epsilon, sampled_in_u k_u u epsilon /\ sampled_in_v k_v v epsilon /\
  carried k_u u /\ carried k_v v.
Proof. destruct witness as (U & V & C). do 5 eexists. exact (conj U (conj V (conj C C))). Qed.
(* Not without what the difference costs: where its step is lost it sees no slope at all. *)
Theorem colour_accuracy__of_the_difference__false : ~ forall u v k_u k_v epsilon, sampled_in_u k_u u epsilon -> sampled_in_v k_v v epsilon ->
  carried k_u u -> carried k_v v -> Rabs (mu (0, 0, 0) (0, 0, 1) (N' 0 0 (central_any_float64.h_u height_sine_float64.h u v k_u k_v epsilon)
  (central_any_float64.h_v height_sine_float64.h u v k_u k_v epsilon) 1) - mu (0, 0, 0) (0, 0, 1) (N' 0 0 (gradient_sine.h_u u v k_u k_v)
  (gradient_sine.h_v u v k_u k_v) 1)) <= 81 * unit53.
Proof.
  intro H. destruct witness as (U & V & C). generalize (H _ _ _ _ _ U V C C) (proj1 steep_there). cbv zeta. destruct (no_slope height_sine_float64.h
    (201 / 2) (201 / 2)) as [-> ->].
  assert (Z : normal_at 0 0 = (0, 0, 1)) by (unfold_vectors; rewrite sin_0, cos_0; repeat f_equal; ring). rewrite !mu_is_a_product, above_is, <- Z,
    !(dot_comm _ (normal_at 0 0)), !normal_dot_bumped. unfold magnitude. rewrite !m_squared.
  rewrite Rminus_0_l, Rabs_Ropp. change (_ * sin _) with (gradient_sine.h_u (bpow radix2 (-1)) (bpow radix2 (-1)) (201 / 2) (201 / 2)). rewrite <-
    (pow2_abs (gradient_sine.h_u _ _ _ _)). replace (1 + 1 ^ 2 * (0 ^ 2 + 0 ^ 2)) with 1 by ring. rewrite sqrt_1, Rinv_1.
  intros X Y. set (s := sqrt _) in X. assert (S : 100 <= s) by (rewrite <- (sqrt_pow2 100) by lra; apply sqrt_le_1_alt; generalize (pow2_ge_0
    (gradient_sine.h_v (bpow radix2 (-1)) (bpow radix2 (-1)) (201 / 2) (201 / 2))); nra). apply Rinv_le_contravar in S; [|lra]. sizes.
Qed.
