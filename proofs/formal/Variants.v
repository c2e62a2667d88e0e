(* False variants, of statements whose files do not refute one beside them. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Vectors Fields Bump Creases.
Open Scope R_scope.

Theorem elementary_functions__sine__false : ~ forall r, -1 <= r <= 1 -> Rabs (half_turn_polynomials.sine_near r - sin (PI * r)) <= 1 / 2 ^ 56.
Proof.
  intro H. generalize (H 1 ltac:(lra)). apply Rlt_not_le. half_turn_polynomials.lines.
  rewrite Rmult_1_r, sin_PI. interval with (i_prec 120).
Qed.
Theorem elementary_functions__zero__false : ~ forall r, half_turn_polynomials.sine_near r = 0.
Proof.
  intro H. generalize (H (1/4)). apply Rgt_not_eq. half_turn_polynomials.lines. interval.
Qed.
Theorem angle_of_the_bump__arctangent__false : ~ forall theta phi h_u h_v beta,
  acos (dot (normal_at theta phi) (N' theta phi h_u h_v beta)) = Rabs beta * magnitude (g theta phi h_u h_v).
Proof.
  intro H. generalize (H 0 0 1 0 1). rewrite angle_of_the_bump__arctangent, (length_of_unit (g 0 0 1 0)) by (rewrite g_squared; ring).
  rewrite Rabs_R1, Rmult_1_r, atan_1. apply Rlt_not_eq. interval.
Qed.
