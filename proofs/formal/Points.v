(* Points at which hypotheses hold, of statements whose files do not give one beside them. *)

From Coq Require Import Reals Lra ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Formal Require Import Camera Formulas Fields Clamped Float.
Open Scope R_scope.

Theorem roundoff_bound__of_any_height__point : exists h h1 (L : R), derives_to h h1 /\ forall w, Rabs (h1 w) <= L.
Proof. exists sin, cos, 1. split; intro w; [auto_derive; trivial; ring | apply Rabs_le, COS_bound]. Qed.
Theorem clamped_difference__of_any_height__point : exists h h1 (v epsilon S : R), derives_to h h1 /\ 0 <= v < epsilon /\ v + epsilon <= 1 /\
  forall w x, 0 <= w <= v + epsilon -> 0 <= x <= v + epsilon -> Rabs (h1 w - h1 x) <= S * Rabs (w - x).
Proof. exists (fun w => w ^ 2 / 2), (fun w => w), 0, 1, 1. split; [intro; auto_derive; trivial; field | split; [lra | split; [lra | intros; lra]]]. Qed.
Theorem clamped_difference__attained__point : exists v epsilon, 0 <= v < epsilon /\ v + epsilon <= 1.
Proof. exists 0, 1. lra. Qed.
Theorem clamped_difference_of_odd__of_any_height__point : exists h h1 h2 h3 (v epsilon bound : R), derives_to h h1 /\ derives_to h1 h2 /\
  derives_to h2 h3 /\ (forall w, h (- w) = - h w) /\ 0 <= v < epsilon /\ v + epsilon <= 1 /\ (forall w, 0 <= w <= v + epsilon -> Rabs (h3 w) <=
  bound).
Proof.
  exists (fun w => w ^ 3 / 6), (fun w => w ^ 2 / 2), (fun w => w), (fun _ => 1), 0, 1, 1.
  split; [|split; [|split; [|split; [|split; [|split]]]]]; try lra; try red; intros; try (rewrite Rabs_R1; lra); try (auto_derive; trivial; field). field.
Qed.
Theorem clamped_difference_of_odd__of_the_fields__point : exists v k_v epsilon, 0 < k_v /\ 0 <= v < epsilon /\ v + epsilon <= 1 /\ k_v * (v +
  epsilon) <= 1.
Proof. exists 0, 1, 1. lra. Qed.
Theorem straddling__of_the_difference__point : exists k d epsilon m, Rabs d < epsilon /\ 0 < k /\ epsilon + Rabs d <= 1 / k /\ 0 <= IZR m / k + d
  - epsilon /\ IZR m / k + d + epsilon < 1.
Proof. exists 2, 0, (1/4), 1%Z. rewrite Rabs_R0. lra. Qed.
Theorem straddling__of_the_slope__point : exists k d, 0 < k /\ 0 < Rabs d < 1 / k.
Proof. exists 1, (1/2). rewrite Rabs_pos_eq; lra. Qed.
Theorem straddling__error__point : exists k epsilon, (0 < k)%Z /\ 0 < epsilon < 1 / IZR k.
Proof. exists 1%Z, (1/2). split; [easy | lra]. Qed.
Theorem ridges_on_creases__no_derivative__point : exists u k_u, 0 < k_u /\ sin (PI * (k_u * u)) <> 0.
Proof. exists (1/2), 1. rewrite half_sine. lra. Qed.
Theorem ridges_at_crossings__differentiable__point : exists k_u k_v, 0 < k_u /\ 0 < k_v.
Proof. exists 1, 1. lra. Qed.
Theorem displaced_normal__any_field__point : exists (h : R -> R -> R) (u v phi h_u h_v : R), 0 < sin phi /\ is_derive (fun u => h u v) u h_u /\
  is_derive (fun v => h u v) v h_v.
Proof. exists (fun u v => u + v), 0, 0, (PI / 2), 1, 1. rewrite sin_PI2. split; [lra | split; auto_derive; trivial; ring]. Qed.
