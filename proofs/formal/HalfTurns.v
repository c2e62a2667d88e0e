(* The polynomials of the kernels' sine and cosine of half-turns. *)

From Coq Require Import Reals Lra.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas.
Open Scope R_scope.

(* On the reduced argument the cosine's polynomial is within 2^-54 of the cosine, *)
Theorem elementary_functions__cosine (r : R) : - (1/4) <= r <= 1/4 ->
  Rabs (half_turn_polynomials.cosine_near r - cos (PI * r)) <= 1 / 2 ^ 54.
Proof.
  intro B. unfold half_turn_polynomials.cosine_near, half_turn_polynomials.z. interval with (i_taylor r, i_degree 20, i_prec 120).
Qed.
(* and the sine's within 2^-56 of the sine. *)
Theorem elementary_functions__sine (r : R) : - (1/4) <= r <= 1/4 ->
  Rabs (half_turn_polynomials.sine_near r - sin (PI * r)) <= 1 / 2 ^ 56.
Proof.
  intro B. unfold half_turn_polynomials.sine_near, half_turn_polynomials.sine_tail, half_turn_polynomials.z. interval with (i_taylor r, i_degree 21, i_prec 120).
Qed.
(* At a whole number of half-turns the reduced argument is 0, and so is the sine: exactly. *)
Theorem elementary_functions__zero : half_turn_polynomials.sine_near 0 = 0 /\ half_turn_polynomials.cosine_near 0 = 1.
Proof. unfold half_turn_polynomials.sine_near, half_turn_polynomials.cosine_near, half_turn_polynomials.z. split; ring. Qed.
Theorem elementary_functions__cosine__point : exists r : R, - (1/4) <= r <= 1/4.
Proof. exists 0. lra. Qed.
(* Over a whole half-turn they are not. *)
Theorem elementary_functions__cosine__false : ~ forall r, -1 <= r <= 1 -> Rabs (half_turn_polynomials.cosine_near r - cos (PI * r)) <= 1 / 2 ^ 54.
Proof.
  intro H. generalize (H 1 ltac:(lra)). apply Rlt_not_le. unfold half_turn_polynomials.cosine_near, half_turn_polynomials.z. rewrite Rmult_1_r, cos_PI. interval with (i_prec 120).
Qed.
