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

Module half_turn_polynomials_float64.
Section program.
Variables remainder : R.
Definition z := rounded (remainder * remainder).
Definition sine_tail := rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded ((7510502657307481 / 9444732965739290427392) * z) - (1617067665348049 / 73786976294838206464))) + (8601768518847843 / 18446744073709551616))) - (8497528335533855 / 1152921504606846976))) + (2959617474655169 / 36028797018963968))) - (2698847510945475 / 4503599627370496))) + (2871229454931313 / 1125899906842624))) - (5818327337647699 / 1125899906842624))) + (4967757600021511 / 40564819207303340847894502572032)).
Definition sine_near := rounded (remainder * rounded (sine_tail + (884279719003555 / 281474976710656))).
Definition cosine_near := rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded ((5080167897815029 / 1180591620717411303424) * z) - (7720929367626383 / 73786976294838206464))) + (8898590864194755 / 4611686018427387904))) - (1859582503162531 / 72057594037927936))) + (8478679513545403 / 36028797018963968))) - (3006744454127613 / 2251799813685248))) + (1142425901258417 / 281474976710656))) - (2778046668940015 / 562949953421312))) + 1).
End program.
End half_turn_polynomials_float64.

Module difference_float64.
Section program.
Variables h_u_plus h_u_minus epsilon : R.
Definition h_u := rounded (rounded ((1 / 2) * rounded (h_u_plus - h_u_minus)) / epsilon).
End program.
End difference_float64.

Module gradient_from_factors_sine_float64.
Section program.
Variables sin_u cos_u sin_v cos_v k_u k_v : R.
Definition h_u := rounded (rounded (rounded (rounded PI * cos_u) * k_u) * sin_v).
Definition h_v := rounded (rounded (rounded (rounded PI * cos_v) * k_v) * sin_u).
End program.
End gradient_from_factors_sine_float64.
