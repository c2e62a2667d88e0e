(* Printed from proofs/formulas by `python -m renderer.generate`. Do not edit: change the formula.
   The float64 operations of kernels, one after the other as they are carried out, each rounded. *)

From Coq Require Import Reals.
From Formal Require Import Float.
Open Scope R_scope.

Module two_product_float64.
Section program.
Variables a b : R.
Definition product := rounded (a * b).
Definition a_split := rounded (134217729 * a).
Definition a_excess := rounded (a_split - a).
Definition a_high := rounded (a_split - a_excess).
Definition a_low := rounded (a - a_high).
Definition b_split := rounded (134217729 * b).
Definition b_excess := rounded (b_split - b).
Definition b_high := rounded (b_split - b_excess).
Definition b_low := rounded (b - b_high).
Definition error_1 := rounded (rounded (a_high * b_high) - product).
Definition error_2 := rounded (rounded (a_high * b_low) + error_1).
Definition error_3 := rounded (rounded (a_low * b_high) + error_2).
Definition product_error := rounded (rounded (a_low * b_low) + error_3).
End program.
End two_product_float64.

Module difference_float64.
Section program.
Variables h_u_plus h_u_minus epsilon : R.
Definition h_u := rounded (rounded ((1 / 2) * rounded (h_u_plus - h_u_minus)) / epsilon).
End program.
End difference_float64.
