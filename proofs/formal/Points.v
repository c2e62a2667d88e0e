(* Points at which hypotheses hold, of statements whose files do not give one beside them. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Formal Require Import Preliminaries Formulas Vectors Fields Bump Float.
Open Scope R_scope.

Theorem kink_loci__between__point : exists u v k_u k_v, height_sine.h u v k_u k_v <> 0.
Proof. exists (1/2), (1/2), 1, 1. unfold_fields. rewrite sine_of_a_right_angle. lra. Qed.
Theorem elementary_functions__sine__point : exists r : R, - (1/4) <= r <= 1/4.
Proof. exists 0. lra. Qed.
Theorem roundoff_bound__standard_model__point : exists x : R, bpow radix2 (-1022) <= Rabs x.
Proof. exists (bpow radix2 (-1022)). apply Rle_abs. Qed.
Theorem elementary_functions__two_product__point : exists a b : R, float64 a /\ float64 b /\ (a * b = 0 \/ bpow radix2 (-1074 + 2 * 53 - 1) <= Rabs (a * b)).
Proof. exists 0, 0. split; [|split]; try apply generic_format_0. left. ring. Qed.
Theorem roundoff_bound__any_span__point : exists (h h1 : R -> R) (L a b S kappa eta alpha : R), (forall w, is_derive h w (h1 w)) /\ (forall w, Rabs (h1 w) <= L) /\
  0 < S /\ a - b = S /\ 0 <= kappa /\ 0 <= eta /\ 0 <= alpha.
Proof.
  exists sin, cos, 1, 1, 0, 1, 0, 0, 0. split; [|split; [|lra]]; intro w; [auto_derive; trivial; ring | apply Rabs_le, COS_bound].
Qed.
Theorem roundoff_bound__three_roundings__point : exists mu d : R, 0 < mu < 1 /\ Rabs d <= mu.
Proof. exists (1/2), 0. rewrite Rabs_R0. lra. Qed.
Theorem chart__round_trip__point : exists theta phi : R, - PI < theta <= PI /\ 0 <= phi <= PI.
Proof. exists 0, 0. generalize PI_RGT_0. lra. Qed.
Theorem clamped_difference__first_order_sharp__point : exists v epsilon : R, 0 <= v < epsilon.
Proof. exists 0, 1. lra. Qed.
Theorem clamped_difference__at_the_pole_itself__point : exists epsilon : R, 0 < epsilon.
Proof. exists 1. lra. Qed.
Theorem clamped_difference_of_odd__second_order__point : exists (h h1 h2 h3 : R -> R) (v epsilon bound : R), (forall w, is_derive h w (h1 w)) /\
  (forall w, is_derive h1 w (h2 w)) /\ (forall w, is_derive h2 w (h3 w)) /\ (forall w, h (- w) = - h w) /\ 0 <= v < epsilon /\
  (forall w, 0 <= w <= v + epsilon -> Rabs (h3 w) <= bound).
Proof.
  exists (fun w => w ^ 3 / 6), (fun w => w ^ 2 / 2), (fun w => w), (fun _ => 1), 0, 1, 1.
  split; [|split; [|split; [|split; [|split]]]]; try lra; intros; try (rewrite Rabs_R1; lra); try (auto_derive; trivial; field). field.
Qed.
Theorem clamped_difference_of_odd__second_order_sharp__point : exists v epsilon : R, 0 <= v < epsilon.
Proof. exists 0, 1. lra. Qed.
Theorem straddling__at_the_crease__point : exists k epsilon : R, 0 < k /\ 0 < epsilon <= 1 / k.
Proof. exists 1, 1. lra. Qed.
Theorem straddling__slope__point : exists k delta : R, 0 < k /\ 0 < Rabs delta < 1 / k.
Proof. exists 1, (1/2). rewrite Rabs_pos_eq; lra. Qed.
Theorem ridges_on_creases__crease_in_u__point : exists k_u : R, k_u <> 0.
Proof. exists 1. lra. Qed.
Theorem ridges_on_creases__crease_in_v__point : exists k_v : R, k_v <> 0.
Proof. exists 1. lra. Qed.
Theorem ridges_on_creases__quotients__point : exists A k s : R, 0 <= A /\ 0 < k /\ 0 < s <= 1 / k.
Proof. exists 1, 1, 1. lra. Qed.
Theorem ridges_on_creases__differ_in_v__point : exists u k_u k_v : R, 0 < k_v /\ sin (PI * (k_u * u)) <> 0.
Proof. exists (1/2), 1, 1. rewrite sine_of_a_right_angle. lra. Qed.
Theorem ridges_at_crossings__crossing__point : exists k_u k_v : R, 0 < k_u /\ 0 < k_v.
Proof. exists 1, 1. lra. Qed.
Theorem ridges_at_crossings__flat__point : exists k_u k_v eta : R, 0 < k_u /\ 0 < k_v /\ 0 < eta.
Proof. exists 1, 1, 1. lra. Qed.
Theorem seam__ridges_jumps__point : exists v k_u k_v : R, sin (PI * k_u) <> 0 /\ sin (PI * (k_v * v)) <> 0.
Proof. exists (1/2), (1/2), 1. rewrite sine_of_a_right_angle. replace (PI * (1/2)) with (PI / 2) by field. rewrite sin_PI2. lra. Qed.
Theorem crease_error_area__tents__point : exists epsilon : R, 0 < epsilon.
Proof. exists 1. lra. Qed.
Theorem crease_error_area__mean_of_a_square__point : exists k : nat, (0 < k)%nat.
Proof. exists 1%nat. lia. Qed.
Theorem crease_error_area__in_u__point : exists k_u epsilon : R, 0 < k_u /\ 0 < epsilon.
Proof. exists 1, 1. lra. Qed.
Theorem displaced_normal__any_field__point : exists (h : R -> R -> R) (u v phi h_u h_v : R), 0 < sin phi /\ is_derive (fun u => h u v) u h_u /\ is_derive (fun v => h u v) v h_v.
Proof. exists (fun u v => u + v), 0, 0, (PI / 2), 1, 1. rewrite sin_PI2. split; [lra | split; auto_derive; trivial; ring]. Qed.
Theorem difference_bound__any_lights__point : exists (f : vector -> R) (l : R), 0 <= l /\ forall n m, Rabs (f n - f m) <= l * magnitude (difference n m).
Proof. exists (fun _ => 0), 0. split; [lra|]. intros. rewrite Rminus_0_r, Rabs_R0. lra. Qed.
