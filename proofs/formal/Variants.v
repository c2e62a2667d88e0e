(* False variants, of statements whose files do not refute one beside them. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Vectors Fields Bump Creases.
Open Scope R_scope.

Theorem angle_of_the_bump__arctangent__false : ~ forall theta phi h_u h_v beta,
  acos (dot (normal_at theta phi) (N' theta phi h_u h_v beta)) = Rabs beta * magnitude (g theta phi h_u h_v).
Proof.
  intro H. generalize (H 0 0 1 0 1). rewrite angle_of_the_bump__arctangent, (length_of_unit (g 0 0 1 0)) by (rewrite g_squared; ring).
  rewrite Rabs_R1, Rmult_1_r, atan_1. apply Rlt_not_eq. interval.
Qed.
