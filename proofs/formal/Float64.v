(* Printed from proofs/formulas by `python -m renderer.generate`. Do not edit: change the formula.
   The float64 operations of kernels, one after the other as they are carried out, each rounded. *)

From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Float.
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
Ltac lines := unfold product_error, error_3, error_2, error_1, b_low, b_high, b_excess, b_split, a_low, a_high,
    a_excess, a_split, product.
End two_product_float64.

Module half_turn_polynomials_float64.
Section program.
Variables remainder : R.
Definition z := rounded (remainder * remainder).
Definition sine_tail := rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded
    (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded ((7510502657307481 /
    9444732965739290427392) * z) - (1617067665348049 / 73786976294838206464))) + (8601768518847843 /
    18446744073709551616))) - (8497528335533855 / 1152921504606846976))) + (2959617474655169 / 36028797018963968))) -
    (2698847510945475 / 4503599627370496))) + (2871229454931313 / 1125899906842624))) - (5818327337647699 /
    1125899906842624))) + (4967757600021511 / 40564819207303340847894502572032)).
Definition sine_near := rounded (remainder * rounded (sine_tail + (884279719003555 / 281474976710656))).
Definition cosine_near := rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z *
    rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded ((5080167897815029 /
    1180591620717411303424) * z) - (7720929367626383 / 73786976294838206464))) + (8898590864194755 /
    4611686018427387904))) - (1859582503162531 / 72057594037927936))) + (8478679513545403 / 36028797018963968))) -
    (3006744454127613 / 2251799813685248))) + (1142425901258417 / 281474976710656))) - (2778046668940015 /
    562949953421312))) + 1).
End program.
Ltac lines := unfold cosine_near, sine_near, sine_tail, z.
End half_turn_polynomials_float64.

Module sine_of_half_turns_float64.
Section program.
Variables product product_error : R.
Definition quarters := rint (rounded (2 * product)).
Definition remainder_high := rounded (product - rounded ((1 / 2) * quarters)).
Definition remainder := rounded (product_error + remainder_high).
Definition quadrant := rounded (quarters - rounded (4 * whole_below (rounded ((1 / 4) * quarters)))).
Definition z := rounded (remainder * remainder).
Definition sine_tail := rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded
    (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded ((7510502657307481 /
    9444732965739290427392) * z) - (1617067665348049 / 73786976294838206464))) + (8601768518847843 /
    18446744073709551616))) - (8497528335533855 / 1152921504606846976))) + (2959617474655169 / 36028797018963968))) -
    (2698847510945475 / 4503599627370496))) + (2871229454931313 / 1125899906842624))) - (5818327337647699 /
    1125899906842624))) + (4967757600021511 / 40564819207303340847894502572032)).
Definition sine_near := rounded (remainder * rounded (sine_tail + (884279719003555 / 281474976710656))).
Definition cosine_near := rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z *
    rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded ((5080167897815029 /
    1180591620717411303424) * z) - (7720929367626383 / 73786976294838206464))) + (8898590864194755 /
    4611686018427387904))) - (1859582503162531 / 72057594037927936))) + (8478679513545403 / 36028797018963968))) -
    (3006744454127613 / 2251799813685248))) + (1142425901258417 / 281474976710656))) - (2778046668940015 /
    562949953421312))) + 1).
Definition sine := (if Rlt_dec quadrant (1 / 2) then sine_near else (if Rlt_dec quadrant (3 / 2) then cosine_near else
    (if Rlt_dec quadrant (5 / 2) then - sine_near else - cosine_near))).
End program.
Ltac lines := unfold sine, cosine_near, sine_near, sine_tail, z, quadrant, remainder, remainder_high, quarters.
End sine_of_half_turns_float64.

Module cosine_of_half_turns_float64.
Section program.
Variables product product_error : R.
Definition quarters := rint (rounded (2 * product)).
Definition remainder_high := rounded (product - rounded ((1 / 2) * quarters)).
Definition remainder := rounded (product_error + remainder_high).
Definition quadrant := rounded (quarters - rounded (4 * whole_below (rounded ((1 / 4) * quarters)))).
Definition z := rounded (remainder * remainder).
Definition sine_tail := rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded
    (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded ((7510502657307481 /
    9444732965739290427392) * z) - (1617067665348049 / 73786976294838206464))) + (8601768518847843 /
    18446744073709551616))) - (8497528335533855 / 1152921504606846976))) + (2959617474655169 / 36028797018963968))) -
    (2698847510945475 / 4503599627370496))) + (2871229454931313 / 1125899906842624))) - (5818327337647699 /
    1125899906842624))) + (4967757600021511 / 40564819207303340847894502572032)).
Definition sine_near := rounded (remainder * rounded (sine_tail + (884279719003555 / 281474976710656))).
Definition cosine_near := rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded (z *
    rounded (rounded (z * rounded (rounded (z * rounded (rounded (z * rounded (rounded ((5080167897815029 /
    1180591620717411303424) * z) - (7720929367626383 / 73786976294838206464))) + (8898590864194755 /
    4611686018427387904))) - (1859582503162531 / 72057594037927936))) + (8478679513545403 / 36028797018963968))) -
    (3006744454127613 / 2251799813685248))) + (1142425901258417 / 281474976710656))) - (2778046668940015 /
    562949953421312))) + 1).
Definition cosine := (if Rlt_dec quadrant (1 / 2) then cosine_near else (if Rlt_dec quadrant (3 / 2) then - sine_near
    else (if Rlt_dec quadrant (5 / 2) then - cosine_near else sine_near))).
End program.
Ltac lines := unfold cosine, cosine_near, sine_near, sine_tail, z, quadrant, remainder, remainder_high, quarters.
End cosine_of_half_turns_float64.

Module angle_in_half_turns_float64.
Section program.
Variables ordinate abscissa : R.
Definition larger := Rmax (Rabs abscissa) (Rabs ordinate).
Definition smaller := Rmin (Rabs abscissa) (Rabs ordinate).
Definition middle := (if Rlt_dec (rounded ((5 / 16) * larger)) smaller then 1 else 0).
Definition steep := (if Rlt_dec (rounded ((3 / 4) * larger)) smaller then 1 else 0).
Definition node := (if Rlt_dec 0 steep then 1 else (if Rlt_dec 0 middle then (1 / 2) else 0)).
Definition node_value := (if Rlt_dec 0 steep then (1 / 4) else (if Rlt_dec 0 middle then (664657525456481 /
    4503599627370496) else 0)).
Definition node_correction := (if Rlt_dec 0 steep then 0 else (if Rlt_dec 0 middle then (1800349617598005 /
    162259276829213363391578010288128) else 0)).
Definition denominator := rounded (larger + rounded (node * smaller)).
Definition ratio := (if Rlt_dec 0 larger then rounded (rounded (smaller - rounded (larger * node)) / denominator) else
    0).
Definition ratio_squared := rounded (ratio * ratio).
Definition arctangent_tail := rounded (rounded (ratio_squared * rounded (rounded (ratio_squared * rounded (rounded
    (ratio_squared * rounded (rounded (ratio_squared * rounded (rounded (ratio_squared * rounded (rounded (ratio_squared
    * rounded (rounded (ratio_squared * rounded (rounded (ratio_squared * rounded (rounded (ratio_squared * rounded
    (rounded (ratio_squared * rounded (rounded (ratio_squared * rounded (rounded (ratio_squared * rounded (rounded
    (ratio_squared * rounded (rounded (ratio_squared * rounded ((790918777823815 / 72057594037927936) - rounded
    ((5919134079197583 / 576460752303423488) * ratio_squared))) - (6796042831671299 / 576460752303423488))) +
    (7339726258205003 / 576460752303423488))) - (7977963324135873 / 576460752303423488))) + (2184442338751489 /
    144115188075855872))) - (2414383637567435 / 144115188075855872))) + (1349214385699449 / 72057594037927936))) -
    (6116438548504169 / 288230376151711744))) + (441089318401743 / 18014398509481984))) - (8340598020687503 /
    288230376151711744))) + (2548516061876737 / 72057594037927936))) - (6553327016254467 / 144115188075855872))) +
    (4587328911378127 / 72057594037927936))) - (1911387046407553 / 18014398509481984))) - (3193047846271019 /
    162259276829213363391578010288128)).
Definition small_part := rounded (node_correction + rounded (ratio * rounded (arctangent_tail + (5734161139222659 /
    18014398509481984)))).
Definition first_octant := rounded (node_value + small_part).
Definition first_quadrant := (if Rlt_dec (Rabs abscissa) (Rabs ordinate) then rounded ((1 / 2) - first_octant) else
    first_octant).
Definition half_plane := (if Rlt_dec abscissa 0 then rounded (1 - first_quadrant) else first_quadrant).
Definition angle := (if Rlt_dec ordinate 0 then - half_plane else half_plane).
End program.
Ltac lines := unfold angle, half_plane, first_quadrant, first_octant, small_part, arctangent_tail, ratio_squared, ratio,
    denominator, node_correction, node_value, node, steep, middle, smaller, larger.
End angle_in_half_turns_float64.

Module exponential_of_sum_float64.
Section program.
Variables product product_error : R.
Definition whole := rint (rounded ((3248660424278399 / 2251799813685248) * product)).
Definition away_high := rounded (product - rounded ((22713 / 32768) * whole)).
Definition away_low := rounded (rounded ((3373202482714085 / 2361183241434822606848) * whole) - product_error).
Definition away := rounded (away_high - away_low).
Definition away_gained := rounded (away_high - away).
Definition away_error := rounded (away_gained - away_low).
Definition away_squared := rounded (away * away).
Definition exponential_tail := rounded (rounded (rounded (away * rounded (rounded (away_squared * rounded (rounded
    (away_squared * rounded (rounded (away_squared * rounded (rounded (away_squared * rounded (rounded
    ((6212541674450185 / 38685626227668133590597632) * away_squared) + (1892883791434041 / 75557863725914323419136))) +
    (1626697008263629 / 590295810358705651712))) + (3660068268593165 / 18446744073709551616))) + (4803839602528529 /
    576460752303423488))) + (6004799503160661 / 36028797018963968))) + rounded (away_squared * rounded (rounded
    (away_squared * rounded (rounded (away_squared * rounded (rounded (away_squared * rounded (rounded ((630961263811347
    / 302231454903657293676544) * away_squared) + (1301357606610903 / 4722366482869645213696))) + (3660068268593165 /
    147573952589676412928))) + (6405119470038039 / 4611686018427387904))) + (6004799503160661 / 144115188075855872)))) +
    (1 / 2)).
Definition departure_low := rounded (away_error + rounded (away_squared * exponential_tail)).
Definition departure := rounded (away + departure_low).
Definition exponential_near := rounded (departure + 1).
Definition exponential := (if Rlt_dec 709 product then (real p_infty) else (if Rlt_dec product (-708) then 0 else
    rounded (exponential_near * power_of_two whole))).
End program.
Ltac lines := unfold exponential, exponential_near, departure, departure_low, exponential_tail, away_squared,
    away_error, away_gained, away, away_low, away_high, whole.
End exponential_of_sum_float64.

Module natural_logarithm_float64.
Section program.
Variables number : R.
Definition scaled_by := (if Rlt_dec number 1 then 200 else (-200)).
Definition scaled := rounded (number * power_of_two scaled_by).
Definition binary := binary_exponent (rounded ((6369051672525773 / 4503599627370496) * scaled)).
Definition mantissa := rounded (scaled * power_of_two (- binary)).
Definition doublings := rounded (binary - scaled_by).
Definition node := (if Rlt_dec mantissa (57 / 64) then (203 / 256) else (if Rlt_dec mantissa (9 / 8) then 1 else (323 /
    256))).
Definition node_short := (if Rlt_dec mantissa (57 / 64) then (-7601 / 32768) else (if Rlt_dec mantissa (9 / 8) then 0
    else (15235 / 65536))).
Definition node_rest := (if Rlt_dec mantissa (57 / 64) then (-8682200230795937 / 1180591620717411303424) else (if
    Rlt_dec mantissa (9 / 8) then 0 else (4266289717532725 / 590295810358705651712))).
Definition above_node := rounded (mantissa - node).
Definition lifted := rounded (mantissa + 134217728).
Definition mantissa_short := rounded (lifted - 134217728).
Definition mantissa_rest := rounded (mantissa - mantissa_short).
Definition sum_short := rounded (mantissa_short + node).
Definition inverse := rounded (1 / rounded (mantissa + node)).
Definition a := rounded (above_node * inverse).
Definition a_split := rounded (134217729 * a).
Definition a_excess := rounded (a_split - a).
Definition a_high := rounded (a_split - a_excess).
Definition undivided_near := rounded (above_node - rounded (a_high * sum_short)).
Definition undivided := rounded (undivided_near - rounded (a_high * mantissa_rest)).
Definition quotient_rest := rounded (inverse * undivided).
Definition quotient := rounded (a_high + quotient_rest).
Definition quotient_squared := rounded (quotient * quotient).
Definition log_tail := rounded (rounded (quotient * quotient_squared) * rounded (rounded (quotient_squared * rounded
    (rounded (quotient_squared * rounded (rounded (quotient_squared * rounded (rounded (quotient_squared * rounded
    (rounded ((1385722962267845 / 9007199254740992) * quotient_squared) + (3275345183542179 / 18014398509481984))) +
    (2001599834386887 / 9007199254740992))) + (2573485501354569 / 9007199254740992))) + (3602879701896397 /
    9007199254740992))) + (6004799503160661 / 9007199254740992))).
Definition log_whole := rounded (rounded ((22713 / 32768) * doublings) + node_short).
Definition log_whole_rest := rounded (rounded ((3373202482714085 / 2361183241434822606848) * doublings) + node_rest).
Definition log_quotient := rounded (2 * a_high).
Definition log_rest := rounded (rounded (log_tail + log_whole_rest) + rounded (2 * quotient_rest)).
Definition log_sum := rounded (log_quotient + log_whole).
Definition log_lost := rounded (log_whole - log_sum).
Definition log_sum_rest := rounded (log_lost + log_quotient).
Definition log_low := rounded (log_rest + log_sum_rest).
Definition log_near := rounded (log_low + log_sum).
Definition logarithm := (if both (Rle_dec number
    179769313486231570814527423731704356798070567525844996598917476803157260780028538760589558632766878171540458953514382464234321326889464182768467546703537516986049910576551282076245490090389328944075868508455133942304583236903222948165808559332123348274797826204144723168738177180919299881250404026184124858368)
    (Rlt_dec 0 number) then log_near else (if Rlt_dec
    179769313486231570814527423731704356798070567525844996598917476803157260780028538760589558632766878171540458953514382464234321326889464182768467546703537516986049910576551282076245490090389328944075868508455133942304583236903222948165808559332123348274797826204144723168738177180919299881250404026184124858368
    number then (real p_infty) else (if Req_EM_T number 0 then (real p_infty) else (real p_infty)))).
End program.
Ltac lines := unfold logarithm, log_near, log_low, log_sum_rest, log_lost, log_sum, log_rest, log_quotient,
    log_whole_rest, log_whole, log_tail, quotient_squared, quotient, quotient_rest, undivided, undivided_near, a_high,
    a_excess, a_split, a, inverse, sum_short, mantissa_rest, mantissa_short, lifted, above_node, node_rest, node_short,
    node, doublings, mantissa, binary, scaled, scaled_by.
End natural_logarithm_float64.

Module raised_float64.
Section program.
Variables number exponent : R.
Definition scaled_by := (if Rlt_dec number 1 then 200 else (-200)).
Definition scaled := rounded (number * power_of_two scaled_by).
Definition binary := binary_exponent (rounded ((6369051672525773 / 4503599627370496) * scaled)).
Definition mantissa := rounded (scaled * power_of_two (- binary)).
Definition doublings := rounded (binary - scaled_by).
Definition node := (if Rlt_dec mantissa (57 / 64) then (203 / 256) else (if Rlt_dec mantissa (9 / 8) then 1 else (323 /
    256))).
Definition node_short := (if Rlt_dec mantissa (57 / 64) then (-7601 / 32768) else (if Rlt_dec mantissa (9 / 8) then 0
    else (15235 / 65536))).
Definition node_rest := (if Rlt_dec mantissa (57 / 64) then (-8682200230795937 / 1180591620717411303424) else (if
    Rlt_dec mantissa (9 / 8) then 0 else (4266289717532725 / 590295810358705651712))).
Definition above_node := rounded (mantissa - node).
Definition lifted := rounded (mantissa + 134217728).
Definition mantissa_short := rounded (lifted - 134217728).
Definition mantissa_rest := rounded (mantissa - mantissa_short).
Definition sum_short := rounded (mantissa_short + node).
Definition inverse := rounded (1 / rounded (mantissa + node)).
Definition a := rounded (above_node * inverse).
Definition a_split := rounded (134217729 * a).
Definition a_excess := rounded (a_split - a).
Definition a_high := rounded (a_split - a_excess).
Definition undivided_near := rounded (above_node - rounded (a_high * sum_short)).
Definition undivided := rounded (undivided_near - rounded (a_high * mantissa_rest)).
Definition quotient_rest := rounded (inverse * undivided).
Definition quotient := rounded (a_high + quotient_rest).
Definition quotient_squared := rounded (quotient * quotient).
Definition log_tail := rounded (rounded (quotient * quotient_squared) * rounded (rounded (quotient_squared * rounded
    (rounded (quotient_squared * rounded (rounded (quotient_squared * rounded (rounded (quotient_squared * rounded
    (rounded ((1385722962267845 / 9007199254740992) * quotient_squared) + (3275345183542179 / 18014398509481984))) +
    (2001599834386887 / 9007199254740992))) + (2573485501354569 / 9007199254740992))) + (3602879701896397 /
    9007199254740992))) + (6004799503160661 / 9007199254740992))).
Definition log_whole := rounded (rounded ((22713 / 32768) * doublings) + node_short).
Definition log_whole_rest := rounded (rounded ((3373202482714085 / 2361183241434822606848) * doublings) + node_rest).
Definition log_quotient := rounded (2 * a_high).
Definition log_rest := rounded (rounded (log_tail + log_whole_rest) + rounded (2 * quotient_rest)).
Definition b := exponent.
Definition b_split := rounded (134217729 * b).
Definition b_excess := rounded (b_split - b).
Definition b_high := rounded (b_split - b_excess).
Definition b_low := rounded (b - b_high).
Definition of_whole := rounded (b_high * log_whole).
Definition of_quotient := rounded (b_high * log_quotient).
Definition product_near := rounded (of_quotient + of_whole).
Definition product_lost := rounded (of_whole - product_near).
Definition product_near_rest := rounded (of_quotient + product_lost).
Definition product_rest := rounded (rounded (rounded (rounded (b_low * log_quotient) + rounded (b_low * log_whole)) +
    rounded (exponent * log_rest)) + product_near_rest).
Definition product := rounded (product_near + product_rest).
Definition product_gained := rounded (product - product_near).
Definition product_error := rounded (product_rest - product_gained).
Definition whole := rint (rounded ((3248660424278399 / 2251799813685248) * product)).
Definition away_high := rounded (product - rounded ((22713 / 32768) * whole)).
Definition away_low := rounded (rounded ((3373202482714085 / 2361183241434822606848) * whole) - product_error).
Definition away := rounded (away_high - away_low).
Definition away_gained := rounded (away_high - away).
Definition away_error := rounded (away_gained - away_low).
Definition away_squared := rounded (away * away).
Definition exponential_tail := rounded (rounded (rounded (away * rounded (rounded (away_squared * rounded (rounded
    (away_squared * rounded (rounded (away_squared * rounded (rounded (away_squared * rounded (rounded
    ((6212541674450185 / 38685626227668133590597632) * away_squared) + (1892883791434041 / 75557863725914323419136))) +
    (1626697008263629 / 590295810358705651712))) + (3660068268593165 / 18446744073709551616))) + (4803839602528529 /
    576460752303423488))) + (6004799503160661 / 36028797018963968))) + rounded (away_squared * rounded (rounded
    (away_squared * rounded (rounded (away_squared * rounded (rounded (away_squared * rounded (rounded ((630961263811347
    / 302231454903657293676544) * away_squared) + (1301357606610903 / 4722366482869645213696))) + (3660068268593165 /
    147573952589676412928))) + (6405119470038039 / 4611686018427387904))) + (6004799503160661 / 144115188075855872)))) +
    (1 / 2)).
Definition departure_low := rounded (away_error + rounded (away_squared * exponential_tail)).
Definition departure := rounded (away + departure_low).
Definition exponential_near := rounded (departure + 1).
Definition exponential := (if Rlt_dec 709 product then (real p_infty) else (if Rlt_dec product (-708) then 0 else
    rounded (exponential_near * power_of_two whole))).
Definition power := (if Rle_dec number 0 then 0 else exponential).
End program.
Ltac lines := unfold power, exponential, exponential_near, departure, departure_low, exponential_tail, away_squared,
    away_error, away_gained, away, away_low, away_high, whole, product_error, product_gained, product, product_rest,
    product_near_rest, product_lost, product_near, of_quotient, of_whole, b_low, b_high, b_excess, b_split, b, log_rest,
    log_quotient, log_whole_rest, log_whole, log_tail, quotient_squared, quotient, quotient_rest, undivided,
    undivided_near, a_high, a_excess, a_split, a, inverse, sum_short, mantissa_rest, mantissa_short, lifted, above_node,
    node_rest, node_short, node, doublings, mantissa, binary, scaled, scaled_by.
End raised_float64.

Module hit_of_b_float64.
Section program.
Variables x y eye ball_center_x ball_center_y ball_center_z ball_radius ball_on : R.
Definition distance := rounded (eye - ball_center_z).
Definition toward_b := rounded (rounded (rounded (ball_center_x * x) + rounded (ball_center_y * y)) + rounded (distance
    * eye)).
Definition discriminant_b := rounded (rounded (rounded (rounded (rounded (ball_radius * ball_radius) * rounded (rounded
    (rounded (eye * eye) + rounded (x * x)) + rounded (y * y))) - rounded (rounded (rounded (ball_center_x * eye) -
    rounded (distance * x)) * rounded (rounded (ball_center_x * eye) - rounded (distance * x)))) - rounded (rounded
    (rounded (ball_center_x * y) - rounded (ball_center_y * x)) * rounded (rounded (ball_center_x * y) - rounded
    (ball_center_y * x)))) - rounded (rounded (rounded (distance * y) - rounded (ball_center_y * eye)) * rounded
    (rounded (distance * y) - rounded (ball_center_y * eye)))).
Definition root_b := rounded (sqrt (Rmax 0 discriminant_b)).
Definition t_b := (if both (both (Rlt_dec 0 ball_on) (Rle_dec 0 discriminant_b)) (Rlt_dec 0 toward_b) then rounded
    (rounded (rounded (rounded (ball_center_x * ball_center_x) + rounded (ball_center_y * ball_center_y)) + rounded
    (rounded (distance - ball_radius) * rounded (ball_radius + distance))) / rounded (root_b + toward_b)) else (real
    p_infty)).
End program.
Ltac lines := unfold t_b, root_b, discriminant_b, toward_b, distance.
End hit_of_b_float64.

Module perturbed_float64.
Section program.
Variables normal_x normal_y normal_z g_x g_y g_z beta : R.
Definition m_x := rounded (rounded (beta * g_x) + normal_x).
Definition m_y := rounded (rounded (beta * g_y) + normal_y).
Definition m_z := rounded (rounded (beta * g_z) + normal_z).
Definition m_length := rounded (sqrt (rounded (rounded (rounded (m_x * m_x) + rounded (m_y * m_y)) + rounded (m_z *
    m_z)))).
Definition m_scale := rounded (1 / m_length).
Definition bumped_x := rounded (m_scale * m_x).
Definition bumped_y := rounded (m_scale * m_y).
Definition bumped_z := rounded (m_scale * m_z).
End program.
Ltac lines := unfold bumped_z, bumped_y, bumped_x, m_scale, m_length, m_z, m_y, m_x.
End perturbed_float64.

Module light_direction_float64.
Section program.
Variables point_x point_y point_z light_x light_y light_z bumped_x bumped_y bumped_z : R.
Definition to_light_x := rounded (light_x - point_x).
Definition to_light_y := rounded (light_y - point_y).
Definition to_light_z := rounded (light_z - point_z).
Definition light_distance := rounded (sqrt (rounded (rounded (rounded (to_light_x * to_light_x) + rounded (to_light_y *
    to_light_y)) + rounded (to_light_z * to_light_z)))).
Definition light_scale := rounded (1 / light_distance).
Definition towards_x := rounded (light_scale * to_light_x).
Definition towards_y := rounded (light_scale * to_light_y).
Definition towards_z := rounded (light_scale * to_light_z).
Definition mu := rounded (rounded (rounded (bumped_x * towards_x) + rounded (bumped_y * towards_y)) + rounded (bumped_z
    * towards_z)).
End program.
Ltac lines := unfold mu, towards_z, towards_y, towards_x, light_scale, light_distance, to_light_z, to_light_y,
    to_light_x.
End light_direction_float64.

Module blinn_highlight_float64.
Section program.
Variables bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z : R.
Definition halfway_length := rounded (sqrt (rounded (rounded (rounded (halfway_x * halfway_x) + rounded (halfway_y *
    halfway_y)) + rounded (halfway_z * halfway_z)))).
Definition specular_base := (if Rlt_dec 0 halfway_length then Rmax 0 (rounded (rounded (rounded (rounded (bumped_x *
    halfway_x) + rounded (bumped_y * halfway_y)) + rounded (bumped_z * halfway_z)) / halfway_length)) else 0).
End program.
Ltac lines := unfold specular_base, halfway_length.
End blinn_highlight_float64.

Module squared_highlight_float64.
Section program.
Variables bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z light_distance : R.
Definition halfway_squared := rounded (rounded (rounded (halfway_x * halfway_x) + rounded (halfway_y * halfway_y)) +
    rounded (halfway_z * halfway_z)).
Definition along_halfway := Rmax 0 (rounded (rounded (rounded (bumped_x * halfway_x) + rounded (bumped_y * halfway_y)) +
    rounded (bumped_z * halfway_z))).
Definition light_scale := (if Rlt_dec 0 halfway_squared then rounded (1 / rounded (halfway_squared * light_distance))
    else 0).
Definition specular_base := rounded (rounded (rounded (along_halfway * along_halfway) * light_distance) * light_scale).
End program.
Ltac lines := unfold specular_base, light_scale, along_halfway, halfway_squared.
End squared_highlight_float64.

Module phong_highlight_float64.
Section program.
Variables bumped_x bumped_y bumped_z view_x view_y view_z towards_x towards_y towards_z mu : R.
Definition specular_base := Rmax 0 (rounded (rounded (rounded (rounded (rounded (2 * mu) * rounded (rounded (rounded
    (bumped_x * view_x) + rounded (bumped_y * view_y)) + rounded (bumped_z * view_z))) - rounded (towards_x * view_x)) -
    rounded (towards_y * view_y)) - rounded (towards_z * view_z))).
End program.
Ltac lines := unfold specular_base.
End phong_highlight_float64.

Module light_term_float64.
Section program.
Variables red green blue light_red light_green light_blue albedo_red albedo_green albedo_blue kd ks mu specular : R.
Definition diffuse := rounded (kd * Rmax 0 mu).
Definition shine := rounded (ks * specular).
Definition lit_red := rounded (rounded (light_red * rounded (rounded (albedo_red * diffuse) + shine)) + red).
Definition lit_green := rounded (green + rounded (light_green * rounded (rounded (albedo_green * diffuse) + shine))).
Definition lit_blue := rounded (blue + rounded (light_blue * rounded (rounded (albedo_blue * diffuse) + shine))).
End program.
Ltac lines := unfold lit_blue, lit_green, lit_red, shine, diffuse.
End light_term_float64.

Module clip_float64.
Section program.
Variables color : R.
Definition clipped := Rmin 1 (Rmax 0 color).
End program.
Ltac lines := unfold clipped.
End clip_float64.

Module height_sine_float64.
Section program.
Variables u v k_u k_v : R.
Definition h := rounded (sine_of_half_turns_float64.sine (two_product_float64.product k_u u)
    (two_product_float64.product_error k_u u) * sine_of_half_turns_float64.sine (two_product_float64.product k_v v)
    (two_product_float64.product_error k_v v)).
End program.
Ltac lines := unfold h.
End height_sine_float64.

Module gradient_from_factors_sine_float64.
Section program.
Variables sin_u cos_u sin_v cos_v k_u k_v : R.
Definition h_u := rounded (rounded (rounded (rounded PI * cos_u) * k_u) * sin_v).
Definition h_v := rounded (rounded (rounded (rounded PI * cos_v) * k_v) * sin_u).
End program.
Ltac lines := unfold h_v, h_u.
End gradient_from_factors_sine_float64.

Module gradient_sine_float64.
Section program.
Variables u v k_u k_v : R.
Definition cos_u := cosine_of_half_turns_float64.cosine (two_product_float64.product k_u u)
    (two_product_float64.product_error k_u u).
Definition cos_v := cosine_of_half_turns_float64.cosine (two_product_float64.product k_v v)
    (two_product_float64.product_error k_v v).
Definition sin_u := sine_of_half_turns_float64.sine (two_product_float64.product k_u u)
    (two_product_float64.product_error k_u u).
Definition sin_v := sine_of_half_turns_float64.sine (two_product_float64.product k_v v)
    (two_product_float64.product_error k_v v).
Definition h_u := rounded (rounded (rounded (rounded PI * cos_u) * k_u) * sin_v).
Definition h_v := rounded (rounded (rounded (rounded PI * cos_v) * k_v) * sin_u).
End program.
Ltac lines := unfold h_v, h_u, sin_v, sin_u, cos_v, cos_u.
End gradient_sine_float64.

Module height_ridges_float64.
Section program.
Variables u v k_u k_v : R.
Definition h := Rabs (rounded (sine_of_half_turns_float64.sine (two_product_float64.product k_u u)
    (two_product_float64.product_error k_u u) * sine_of_half_turns_float64.sine (two_product_float64.product k_v v)
    (two_product_float64.product_error k_v v))).
End program.
Ltac lines := unfold h.
End height_ridges_float64.

Module gradient_from_factors_ridges_float64.
Section program.
Variables sin_u cos_u sin_v cos_v k_u k_v : R.
Definition h_u := rounded (rounded (rounded (rounded (rounded PI * cos_u) * k_u) * sin_v) * rounded (sign sin_u * sign
    sin_v)).
Definition h_v := rounded (rounded (rounded (rounded (rounded PI * cos_v) * k_v) * sin_u) * rounded (sign sin_u * sign
    sin_v)).
End program.
Ltac lines := unfold h_v, h_u.
End gradient_from_factors_ridges_float64.

Module gradient_ridges_float64.
Section program.
Variables u v k_u k_v : R.
Definition cos_u := cosine_of_half_turns_float64.cosine (two_product_float64.product k_u u)
    (two_product_float64.product_error k_u u).
Definition cos_v := cosine_of_half_turns_float64.cosine (two_product_float64.product k_v v)
    (two_product_float64.product_error k_v v).
Definition sin_u := sine_of_half_turns_float64.sine (two_product_float64.product k_u u)
    (two_product_float64.product_error k_u u).
Definition sin_v := sine_of_half_turns_float64.sine (two_product_float64.product k_v v)
    (two_product_float64.product_error k_v v).
Definition h_u := rounded (rounded (rounded (rounded (rounded PI * cos_u) * k_u) * sin_v) * rounded (sign sin_u * sign
    sin_v)).
Definition h_v := rounded (rounded (rounded (rounded (rounded PI * cos_v) * k_v) * sin_u) * rounded (sign sin_u * sign
    sin_v)).
End program.
Ltac lines := unfold h_v, h_u, sin_v, sin_u, cos_v, cos_u.
End gradient_ridges_float64.

Module height_rings_float64.
Section program.
Variables u v k_u k_v : R.
Definition h := sine_of_half_turns_float64.sine (two_product_float64.product (rounded (2 * k_v)) v)
    (two_product_float64.product_error (rounded (2 * k_v)) v).
End program.
Ltac lines := unfold h.
End height_rings_float64.

Module gradient_from_factors_rings_float64.
Section program.
Variables sin_u cos_u sin_v cos_v k_u k_v : R.
Definition h_u := 0.
Definition h_v := rounded (rounded (rounded (2 * rounded PI) * cos_v) * k_v).
End program.
Ltac lines := unfold h_v, h_u.
End gradient_from_factors_rings_float64.

Module gradient_rings_float64.
Section program.
Variables u v k_u k_v : R.
Definition cos_v := cosine_of_half_turns_float64.cosine (two_product_float64.product (rounded (2 * k_v)) v)
    (two_product_float64.product_error (rounded (2 * k_v)) v).
Definition sin_v := sine_of_half_turns_float64.sine (two_product_float64.product (rounded (2 * k_v)) v)
    (two_product_float64.product_error (rounded (2 * k_v)) v).
Definition h_u := 0.
Definition h_v := rounded (rounded (rounded (2 * rounded PI) * cos_v) * k_v).
End program.
Ltac lines := unfold h_v, h_u, sin_v, cos_v.
End gradient_rings_float64.

Module forward_any_float64.
Section program.
Variable height : R -> R -> R -> R -> R.
Variables u v k_u k_v epsilon : R.
Definition u_plus := rounded (rounded (epsilon + u) - whole_below (rounded (epsilon + u))).
Definition stepped := (if Rle_dec (rounded (epsilon + v)) 1 then rounded (epsilon + v) else rounded (v - epsilon)).
Definition h_here := height u v k_u k_v.
Definition h_u_plus := height u_plus v k_u k_v.
Definition h_v_plus := height u stepped k_u k_v.
Definition h_u := rounded (rounded (h_u_plus - h_here) / epsilon).
Definition h_v := (if Rle_dec (rounded (epsilon + v)) 1 then rounded (rounded (h_v_plus - h_here) / epsilon) else
    rounded (rounded (h_here - h_v_plus) / epsilon)).
End program.
Ltac lines := unfold h_v, h_u, h_v_plus, h_u_plus, h_here, stepped, u_plus.
End forward_any_float64.

Module central_any_float64.
Section program.
Variable height : R -> R -> R -> R -> R.
Variables u v k_u k_v epsilon : R.
Definition u_plus := rounded (rounded (epsilon + u) - whole_below (rounded (epsilon + u))).
Definition u_minus := rounded (rounded (u - epsilon) - whole_below (rounded (u - epsilon))).
Definition v_plus := Rmin 1 (rounded (epsilon + v)).
Definition v_minus := Rmax 0 (rounded (v - epsilon)).
Definition span_v := (if both (Rle_dec (rounded (epsilon + v)) 1) (Rle_dec (rounded (epsilon - v)) 0) then rounded (2 *
    epsilon) else rounded (v_plus - v_minus)).
Definition h_u_plus := height u_plus v k_u k_v.
Definition h_u_minus := height u_minus v k_u k_v.
Definition h_v_plus := height u v_plus k_u k_v.
Definition h_v_minus := height u v_minus k_u k_v.
Definition h_u := rounded (rounded ((1 / 2) * rounded (h_u_plus - h_u_minus)) / epsilon).
Definition h_v := rounded (rounded (h_v_plus - h_v_minus) / span_v).
End program.
Ltac lines := unfold h_v, h_u, h_v_minus, h_v_plus, h_u_minus, h_u_plus, span_v, v_minus, v_plus, u_minus, u_plus.
End central_any_float64.

Module central4_any_float64.
Section program.
Variable height : R -> R -> R -> R -> R.
Variables u v k_u k_v epsilon : R.
Definition u_plus := rounded (rounded (epsilon + u) - whole_below (rounded (epsilon + u))).
Definition u_minus := rounded (rounded (u - epsilon) - whole_below (rounded (u - epsilon))).
Definition v_plus := Rmin 1 (rounded (epsilon + v)).
Definition v_minus := Rmax 0 (rounded (v - epsilon)).
Definition span_v := (if both (Rle_dec (rounded (epsilon + v)) 1) (Rle_dec (rounded (epsilon - v)) 0) then rounded (2 *
    epsilon) else rounded (v_plus - v_minus)).
Definition u_plus_2 := rounded (rounded (rounded (2 * epsilon) + u) - whole_below (rounded (rounded (2 * epsilon) +
    u))).
Definition u_minus_2 := rounded (rounded (u - rounded (2 * epsilon)) - whole_below (rounded (u - rounded (2 *
    epsilon)))).
Definition v_plus_2 := Rmin 1 (rounded (rounded (2 * epsilon) + v)).
Definition v_minus_2 := Rmax 0 (rounded (v - rounded (2 * epsilon))).
Definition h_u_plus := height u_plus v k_u k_v.
Definition h_u_minus := height u_minus v k_u k_v.
Definition h_v_plus := height u v_plus k_u k_v.
Definition h_v_minus := height u v_minus k_u k_v.
Definition h_u_plus_2 := height u_plus_2 v k_u k_v.
Definition h_u_minus_2 := height u_minus_2 v k_u k_v.
Definition h_v_plus_2 := height u v_plus_2 k_u k_v.
Definition h_v_minus_2 := height u v_minus_2 k_u k_v.
Definition near_difference_u := rounded (h_u_plus - h_u_minus).
Definition h_u := rounded (rounded ((6004799503160661 / 72057594037927936) * rounded (rounded (h_u_minus_2 - h_u_plus_2)
    + rounded (8 * near_difference_u))) / epsilon).
Definition near_difference_v := rounded (h_v_plus - h_v_minus).
Definition h_v := (if both (Rle_dec (rounded (rounded (2 * epsilon) + v)) 1) (Rle_dec (rounded (rounded (2 * epsilon) -
    v)) 0) then rounded (rounded ((6004799503160661 / 72057594037927936) * rounded (rounded (h_v_minus_2 - h_v_plus_2) +
    rounded (8 * near_difference_v))) / epsilon) else rounded (near_difference_v / span_v)).
End program.
Ltac lines := unfold h_v, near_difference_v, h_u, near_difference_u, h_v_minus_2, h_v_plus_2, h_u_minus_2, h_u_plus_2,
    h_v_minus, h_v_plus, h_u_minus, h_u_plus, v_minus_2, v_plus_2, u_minus_2, u_plus_2, span_v, v_minus, v_plus,
    u_minus, u_plus.
End central4_any_float64.

Module enclosed_sum_float64.
Section program.
Variables x x_error y y_error : R.
Definition total := rounded (x + y).
Definition total_error := rounded ((rounded (x_error + y_error)) + (Rabs (rounded (x + y)))).
End program.
Ltac lines := unfold total_error, total.
End enclosed_sum_float64.

Module enclosed_product_float64.
Section program.
Variables x x_error y y_error : R.
Definition product := rounded (x * y).
Definition product_error := rounded ((rounded ((rounded ((Rabs x) * y_error)) + (rounded ((rounded ((Rabs y) + (rounded
    ((1048577 / 9444732965739290427392) * y_error)))) * x_error)))) + (rounded ((Rabs (rounded (x * y))) + (1 / 2 ^
    1007)))).
End program.
Ltac lines := unfold product_error, product.
End enclosed_product_float64.

Module enclosed_quotient_float64.
Section program.
Variables x x_error y y_error : R.
Definition quotient := rounded (x / y).
Definition quotient_error := rounded ((rounded ((rounded (x_error + (rounded ((rounded ((Rabs (rounded (x / y))) + (1 /
    2 ^ 1007))) * y_error)))) * (if Rlt_dec 0 (rounded ((Rabs y) - (rounded ((1048577 / 9444732965739290427392) *
    y_error)))) then (rounded (1 / (rounded ((Rabs y) - (rounded ((1048577 / 9444732965739290427392) * y_error))))))
    else (real p_infty)))) + (rounded ((Rabs (rounded (x / y))) + (1 / 2 ^ 1007)))).
End program.
Ltac lines := unfold quotient_error, quotient.
End enclosed_quotient_float64.

Module enclosed_root_float64.
Section program.
Variables x x_error : R.
Definition root := rounded (sqrt x).
Definition root_error := rounded ((if Rlt_dec x_error (rounded (x * 9007199254740992)) then (rounded (x_error / (rounded
    (sqrt x)))) else (rounded ((rounded (sqrt x_error)) * (398065740123893 / 4194304)))) + (rounded (sqrt x))).
End program.
Ltac lines := unfold root_error, root.
End enclosed_root_float64.

Module enclosed_floor_float64.
Section program.
Variables x x_error : R.
Definition below := whole_below x.
Definition below_error := rounded (9007199254740992 * (if both (Rle_dec (Rabs (rounded (x - (rint x)))) (rounded
    ((rounded ((1048577 / 9444732965739290427392) * x_error)) * (562949953421313 / 562949953421312)))) (Rlt_dec 0
    x_error) then (rounded (1 + (whole_below (rounded ((1048577 / 9444732965739290427392) * x_error))))) else
    (whole_below (rounded ((1048577 / 9444732965739290427392) * x_error))))).
End program.
Ltac lines := unfold below_error, below.
End enclosed_floor_float64.

Module enclosed_nearest_float64.
Section program.
Variables x x_error : R.
Definition nearest := rint x.
Definition nearest_error := rounded (9007199254740992 * (if both (Rle_dec (Rabs (rounded ((Rabs (rounded (x - (rint
    x)))) - (1 / 2)))) (rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) * (562949953421313 /
    562949953421312)))) (Rlt_dec 0 x_error) then (rounded (1 + (whole_below (rounded ((1048577 / 9444732965739290427392)
    * x_error))))) else (whole_below (rounded ((1048577 / 9444732965739290427392) * x_error))))).
End program.
Ltac lines := unfold nearest_error, nearest.
End enclosed_nearest_float64.

Module enclosed_sine_float64.
Section program.
Variables x x_error y y_error : R.
Definition sine := sine_of_half_turns_float64.sine (two_product_float64.product x y) (two_product_float64.product_error
    x y).
Definition sine_error := rounded (9007199254740992 * (rounded ((rounded ((if Rlt_dec (rounded ((7074237752028453 /
    2251799813685248) * (rounded ((1048577 / 9444732965739290427392) * (rounded ((rounded ((Rabs x) * y_error)) +
    (rounded ((rounded ((Rabs y) + (rounded ((1048577 / 9444732965739290427392) * y_error)))) * x_error)))))))) 2 then
    (rounded ((7074237752028453 / 2251799813685248) * (rounded ((1048577 / 9444732965739290427392) * (rounded ((rounded
    ((Rabs x) * y_error)) + (rounded ((rounded ((Rabs y) + (rounded ((1048577 / 9444732965739290427392) * y_error)))) *
    x_error)))))))) else 2) + (rounded ((rounded ((5674535530486825 / 10141204801825835211973625643008) * (Rabs
    (sine_of_half_turns_float64.sine (two_product_float64.product x y) (two_product_float64.product_error x y))))) + (1
    / 2 ^ 1060))))) * (562949953421313 / 562949953421312)))).
End program.
Ltac lines := unfold sine_error, sine.
End enclosed_sine_float64.

Module enclosed_cosine_float64.
Section program.
Variables x x_error y y_error : R.
Definition cosine := cosine_of_half_turns_float64.cosine (two_product_float64.product x y)
    (two_product_float64.product_error x y).
Definition cosine_error := rounded (9007199254740992 * (rounded ((rounded ((if Rlt_dec (rounded ((7074237752028453 /
    2251799813685248) * (rounded ((1048577 / 9444732965739290427392) * (rounded ((rounded ((Rabs x) * y_error)) +
    (rounded ((rounded ((Rabs y) + (rounded ((1048577 / 9444732965739290427392) * y_error)))) * x_error)))))))) 2 then
    (rounded ((7074237752028453 / 2251799813685248) * (rounded ((1048577 / 9444732965739290427392) * (rounded ((rounded
    ((Rabs x) * y_error)) + (rounded ((rounded ((Rabs y) + (rounded ((1048577 / 9444732965739290427392) * y_error)))) *
    x_error)))))))) else 2) + (rounded ((rounded ((5674535530486825 / 10141204801825835211973625643008) * (Rabs
    (cosine_of_half_turns_float64.cosine (two_product_float64.product x y) (two_product_float64.product_error x y))))) +
    (1 / 2 ^ 1060))))) * (562949953421313 / 562949953421312)))).
End program.
Ltac lines := unfold cosine_error, cosine.
End enclosed_cosine_float64.

Module enclosed_angle_float64.
Section program.
Variables x x_error y y_error : R.
Definition angle := angle_in_half_turns_float64.angle y x.
Definition angle_error := rounded (9007199254740992 * (rounded ((if both (Rlt_dec x 0) (Rle_dec (Rabs y) (rounded
    ((rounded ((1048577 / 9444732965739290427392) * y_error)) * (562949953421313 / 562949953421312)))) then 2 else
    (rounded ((if both (Rlt_dec (rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1048577
    / 9444732965739290427392) * x_error)))) (rounded ((1 / 2) * (rounded (sqrt (rounded ((rounded (x * x)) + (rounded (y
    * y))))))))) (Rlt_dec (rounded ((rounded ((rounded ((Rabs x) * (rounded ((1048577 / 9444732965739290427392) *
    y_error)))) + (rounded ((Rabs y) * (rounded ((1048577 / 9444732965739290427392) * x_error)))))) / (rounded ((rounded
    (sqrt (rounded ((rounded (x * x)) + (rounded (y * y)))))) * (rounded ((rounded (sqrt (rounded ((rounded (x * x)) +
    (rounded (y * y)))))) - (rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1048577 /
    9444732965739290427392) * x_error)))))))))) (2242792614430507 / 9007199254740992)) then (rounded ((rounded ((rounded
    ((rounded ((rounded ((Rabs x) * (rounded ((1048577 / 9444732965739290427392) * y_error)))) + (rounded ((Rabs y) *
    (rounded ((1048577 / 9444732965739290427392) * x_error)))))) / (rounded ((rounded (sqrt (rounded ((rounded (x * x))
    + (rounded (y * y)))))) * (rounded ((rounded (sqrt (rounded ((rounded (x * x)) + (rounded (y * y)))))) - (rounded
    ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1048577 / 9444732965739290427392) *
    x_error)))))))))) * (731105545250889 / 2251799813685248))) * (562949953421313 / 562949953421312))) else 2) +
    (rounded ((rounded ((5 / 9007199254740992) * (Rabs (angle_in_half_turns_float64.angle y x)))) + (1 / 2 ^ 1060))))))
    * (562949953421313 / 562949953421312)))).
End program.
Ltac lines := unfold angle_error, angle.
End enclosed_angle_float64.

Module enclosed_exponential_float64.
Section program.
Variables x x_error : R.
Definition exponential := exponential_of_sum_float64.exponential (two_product_float64.product x 1)
    (two_product_float64.product_error x 1).
Definition exponential_error := rounded (9007199254740992 * (rounded ((rounded ((if Rbar_lt_dec (Finite (rounded
    ((1048577 / 9444732965739290427392) * (rounded (1 * x_error))))) p_infty then (if Rlt_dec (if Rlt_dec 0 (rounded
    ((Rabs (rounded ((exponential_of_sum_float64.exponential (rounded ((rounded (x * 1)) - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * (rounded (1 * x_error)))) + (rounded ((1 / 4503599627370496) * (Rabs (rounded
    (x * 1))))))) * (562949953421313 / 562949953421312))))) 0) - (exponential_of_sum_float64.exponential
    (two_product_float64.product x 1) (two_product_float64.product_error x 1))))) + (rounded ((rounded ((1 /
    4503599627370496) * (Rabs (exponential_of_sum_float64.exponential (rounded ((rounded (x * 1)) - (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * (rounded (1 * x_error)))) + (rounded ((1 / 4503599627370496) * (Rabs
    (rounded (x * 1))))))) * (562949953421313 / 562949953421312))))) 0)))) + (1 / 2 ^ 1020))))) then (rounded ((Rabs
    (rounded ((exponential_of_sum_float64.exponential (rounded ((rounded (x * 1)) - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * (rounded (1 * x_error)))) + (rounded ((1 / 4503599627370496) * (Rabs (rounded
    (x * 1))))))) * (562949953421313 / 562949953421312))))) 0) - (exponential_of_sum_float64.exponential
    (two_product_float64.product x 1) (two_product_float64.product_error x 1))))) + (rounded ((rounded ((1 /
    4503599627370496) * (Rabs (exponential_of_sum_float64.exponential (rounded ((rounded (x * 1)) - (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * (rounded (1 * x_error)))) + (rounded ((1 / 4503599627370496) * (Rabs
    (rounded (x * 1))))))) * (562949953421313 / 562949953421312))))) 0)))) + (1 / 2 ^ 1020))))) else 0) (rounded ((Rabs
    (rounded ((exponential_of_sum_float64.exponential (rounded ((rounded (x * 1)) + (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * (rounded (1 * x_error)))) + (rounded ((1 / 4503599627370496) * (Rabs (rounded
    (x * 1))))))) * (562949953421313 / 562949953421312))))) 0) - (exponential_of_sum_float64.exponential
    (two_product_float64.product x 1) (two_product_float64.product_error x 1))))) + (rounded ((rounded ((1 /
    4503599627370496) * (Rabs (exponential_of_sum_float64.exponential (rounded ((rounded (x * 1)) + (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * (rounded (1 * x_error)))) + (rounded ((1 / 4503599627370496) * (Rabs
    (rounded (x * 1))))))) * (562949953421313 / 562949953421312))))) 0)))) + (1 / 2 ^ 1020))))) then (rounded ((Rabs
    (rounded ((exponential_of_sum_float64.exponential (rounded ((rounded (x * 1)) + (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * (rounded (1 * x_error)))) + (rounded ((1 / 4503599627370496) * (Rabs (rounded
    (x * 1))))))) * (562949953421313 / 562949953421312))))) 0) - (exponential_of_sum_float64.exponential
    (two_product_float64.product x 1) (two_product_float64.product_error x 1))))) + (rounded ((rounded ((1 /
    4503599627370496) * (Rabs (exponential_of_sum_float64.exponential (rounded ((rounded (x * 1)) + (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * (rounded (1 * x_error)))) + (rounded ((1 / 4503599627370496) * (Rabs
    (rounded (x * 1))))))) * (562949953421313 / 562949953421312))))) 0)))) + (1 / 2 ^ 1020))))) else (if Rlt_dec 0
    (rounded ((Rabs (rounded ((exponential_of_sum_float64.exponential (rounded ((rounded (x * 1)) - (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * (rounded (1 * x_error)))) + (rounded ((1 / 4503599627370496) * (Rabs
    (rounded (x * 1))))))) * (562949953421313 / 562949953421312))))) 0) - (exponential_of_sum_float64.exponential
    (two_product_float64.product x 1) (two_product_float64.product_error x 1))))) + (rounded ((rounded ((1 /
    4503599627370496) * (Rabs (exponential_of_sum_float64.exponential (rounded ((rounded (x * 1)) - (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * (rounded (1 * x_error)))) + (rounded ((1 / 4503599627370496) * (Rabs
    (rounded (x * 1))))))) * (562949953421313 / 562949953421312))))) 0)))) + (1 / 2 ^ 1020))))) then (rounded ((Rabs
    (rounded ((exponential_of_sum_float64.exponential (rounded ((rounded (x * 1)) - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * (rounded (1 * x_error)))) + (rounded ((1 / 4503599627370496) * (Rabs (rounded
    (x * 1))))))) * (562949953421313 / 562949953421312))))) 0) - (exponential_of_sum_float64.exponential
    (two_product_float64.product x 1) (two_product_float64.product_error x 1))))) + (rounded ((rounded ((1 /
    4503599627370496) * (Rabs (exponential_of_sum_float64.exponential (rounded ((rounded (x * 1)) - (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * (rounded (1 * x_error)))) + (rounded ((1 / 4503599627370496) * (Rabs
    (rounded (x * 1))))))) * (562949953421313 / 562949953421312))))) 0)))) + (1 / 2 ^ 1020))))) else 0)) else (real
    p_infty)) + (rounded ((rounded ((1 / 4503599627370496) * (Rabs (exponential_of_sum_float64.exponential
    (two_product_float64.product x 1) (two_product_float64.product_error x 1))))) + (1 / 2 ^ 1020))))) *
    (562949953421313 / 562949953421312)))).
End program.
Ltac lines := unfold exponential_error, exponential.
End enclosed_exponential_float64.

Module enclosed_logarithm_float64.
Section program.
Variables x x_error : R.
Definition logarithm := natural_logarithm_float64.logarithm x.
Definition logarithm_error := rounded (9007199254740992 * (rounded ((rounded ((if Rbar_lt_dec (Finite (rounded ((1048577
    / 9444732965739290427392) * x_error))) p_infty then (if Rlt_dec (if Rlt_dec 0 (rounded ((Rabs (rounded
    ((natural_logarithm_float64.logarithm (if Rlt_dec 0 (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error))
    + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) else 0)) -
    (natural_logarithm_float64.logarithm x)))) + (rounded ((rounded ((1170935903116329 /
    10141204801825835211973625643008) * (Rabs (natural_logarithm_float64.logarithm (if Rlt_dec 0 (rounded (x - (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    x))))) * (562949953421313 / 562949953421312))))) then (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) else 0))))) + 0)))) then (rounded ((Rabs (rounded ((natural_logarithm_float64.logarithm (if
    Rlt_dec 0 (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1
    / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (rounded (x - (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) *
    (562949953421313 / 562949953421312))))) else 0)) - (natural_logarithm_float64.logarithm x)))) + (rounded ((rounded
    ((1170935903116329 / 10141204801825835211973625643008) * (Rabs (natural_logarithm_float64.logarithm (if Rlt_dec 0
    (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (rounded (x - (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) *
    (562949953421313 / 562949953421312))))) else 0))))) + 0)))) else 0) (rounded ((Rabs (rounded
    ((natural_logarithm_float64.logarithm (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error))
    + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) else 0)) -
    (natural_logarithm_float64.logarithm x)))) + (rounded ((rounded ((1170935903116329 /
    10141204801825835211973625643008) * (Rabs (natural_logarithm_float64.logarithm (if Rlt_dec 0 (rounded (x + (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    x))))) * (562949953421313 / 562949953421312))))) then (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) else 0))))) + 0)))) then (rounded ((Rabs (rounded ((natural_logarithm_float64.logarithm (if
    Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1
    / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (rounded (x + (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) *
    (562949953421313 / 562949953421312))))) else 0)) - (natural_logarithm_float64.logarithm x)))) + (rounded ((rounded
    ((1170935903116329 / 10141204801825835211973625643008) * (Rabs (natural_logarithm_float64.logarithm (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (rounded (x + (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) *
    (562949953421313 / 562949953421312))))) else 0))))) + 0)))) else (if Rlt_dec 0 (rounded ((Rabs (rounded
    ((natural_logarithm_float64.logarithm (if Rlt_dec 0 (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error))
    + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) else 0)) -
    (natural_logarithm_float64.logarithm x)))) + (rounded ((rounded ((1170935903116329 /
    10141204801825835211973625643008) * (Rabs (natural_logarithm_float64.logarithm (if Rlt_dec 0 (rounded (x - (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    x))))) * (562949953421313 / 562949953421312))))) then (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) else 0))))) + 0)))) then (rounded ((Rabs (rounded ((natural_logarithm_float64.logarithm (if
    Rlt_dec 0 (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1
    / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (rounded (x - (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) *
    (562949953421313 / 562949953421312))))) else 0)) - (natural_logarithm_float64.logarithm x)))) + (rounded ((rounded
    ((1170935903116329 / 10141204801825835211973625643008) * (Rabs (natural_logarithm_float64.logarithm (if Rlt_dec 0
    (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (rounded (x - (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) *
    (562949953421313 / 562949953421312))))) else 0))))) + 0)))) else 0)) else (real p_infty)) + (rounded ((rounded
    ((1170935903116329 / 10141204801825835211973625643008) * (Rabs (natural_logarithm_float64.logarithm x)))) + 0)))) *
    (562949953421313 / 562949953421312)))).
End program.
Ltac lines := unfold logarithm_error, logarithm.
End enclosed_logarithm_float64.

Module enclosed_power_float64.
Section program.
Variables x x_error y y_error : R.
Definition raised := raised_float64.power x y.
Definition raised_error := rounded (9007199254740992 * (rounded ((rounded ((if Rbar_lt_dec (Finite (rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1048577 / 9444732965739290427392) * y_error)))))
    p_infty then (if Rlt_dec (if Rlt_dec (if Rlt_dec (if Rlt_dec 0 (rounded ((Rabs (rounded ((raised_float64.power
    (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) *
    (562949953421313 / 562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded ((if Rlt_dec
    (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else 3) *
    (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then
    (rounded ((Rabs (rounded ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else 0) (rounded ((Rabs (rounded ((raised_float64.power
    (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) *
    (562949953421313 / 562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded ((if Rlt_dec
    (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else 3) *
    (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then
    (rounded ((Rabs (rounded ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else (if Rlt_dec 0 (rounded ((Rabs (rounded
    ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded
    ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) *
    x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else
    3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then
    (rounded ((Rabs (rounded ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else 0)) (rounded ((Rabs (rounded ((raised_float64.power
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) *
    (562949953421313 / 562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded ((if Rlt_dec
    (raised_float64.power (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else 3) *
    (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then
    (rounded ((Rabs (rounded ((raised_float64.power (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x + (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x +
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else (if Rlt_dec (if Rlt_dec 0 (rounded ((Rabs (rounded
    ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded
    ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) *
    x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else
    3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then
    (rounded ((Rabs (rounded ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else 0) (rounded ((Rabs (rounded ((raised_float64.power
    (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) *
    (562949953421313 / 562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded ((if Rlt_dec
    (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else 3) *
    (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then
    (rounded ((Rabs (rounded ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else (if Rlt_dec 0 (rounded ((Rabs (rounded
    ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded
    ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) *
    x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else
    3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then
    (rounded ((Rabs (rounded ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else 0))) (rounded ((Rabs (rounded ((raised_float64.power
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded ((rounded
    ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) *
    (562949953421313 / 562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded ((if Rlt_dec
    (raised_float64.power (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else 3) *
    (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then
    (rounded ((Rabs (rounded ((raised_float64.power (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x + (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x +
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else (if Rlt_dec (if Rlt_dec (if Rlt_dec 0 (rounded ((Rabs
    (rounded ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) *
    x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded
    ((rounded ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then (rounded ((Rabs (rounded ((raised_float64.power (rounded
    (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496)
    * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded ((if Rlt_dec
    (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else 3) *
    (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else 0)
    (rounded ((Rabs (rounded ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then (rounded ((Rabs (rounded ((raised_float64.power (rounded
    (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496)
    * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded ((if Rlt_dec
    (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else 3) *
    (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else (if
    Rlt_dec 0 (rounded ((Rabs (rounded ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then (rounded ((Rabs (rounded ((raised_float64.power (rounded
    (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496)
    * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded ((if Rlt_dec
    (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else 3) *
    (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else 0))
    (rounded ((Rabs (rounded ((raised_float64.power (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x + (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x +
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then (rounded ((Rabs (rounded ((raised_float64.power (rounded
    (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496)
    * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded ((if Rlt_dec
    (raised_float64.power (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else 3) *
    (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else (if
    Rlt_dec (if Rlt_dec 0 (rounded ((Rabs (rounded ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then (rounded ((Rabs (rounded ((raised_float64.power (rounded
    (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496)
    * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded ((if Rlt_dec
    (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else 3) *
    (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else 0)
    (rounded ((Rabs (rounded ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then (rounded ((Rabs (rounded ((raised_float64.power (rounded
    (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496)
    * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded ((if Rlt_dec
    (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y + (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else 3) *
    (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else (if
    Rlt_dec 0 (rounded ((Rabs (rounded ((raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) - (raised_float64.power x
    y)))) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power (rounded (x - (rounded ((rounded ((rounded
    ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313
    / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x -
    (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) *
    (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312))))))))) + (if Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) then (1 / 2 ^ 1020) else 0))))) then (rounded ((Rabs (rounded ((raised_float64.power (rounded
    (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496)
    * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 /
    562949953421312)))))) - (raised_float64.power x y)))) + (rounded ((rounded ((rounded ((if Rlt_dec
    (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) (rounded (y - (rounded
    ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) + (rounded ((1 / 4503599627370496) * (Rabs
    y))))) * (562949953421313 / 562949953421312)))))) (1 / 2 ^ 72) then (6209337986237071 / 281474976710656) else 3) *
    (1 / 9007199254740992))) * (Rabs (raised_float64.power (rounded (x - (rounded ((rounded ((rounded ((1048577 /
    9444732965739290427392) * x_error)) + (rounded ((1 / 4503599627370496) * (Rabs x))))) * (562949953421313 /
    562949953421312))))) (rounded (y - (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * y_error)) +
    (rounded ((1 / 4503599627370496) * (Rabs y))))) * (562949953421313 / 562949953421312))))))))) + (if Rlt_dec 0
    (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1 /
    4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) else
    0)))) else (real p_infty)) + (rounded ((rounded ((rounded ((if Rlt_dec (raised_float64.power x y) (1 / 2 ^ 72) then
    (6209337986237071 / 281474976710656) else 3) * (1 / 9007199254740992))) * (Rabs (raised_float64.power x y)))) + (if
    Rlt_dec 0 (rounded (x + (rounded ((rounded ((rounded ((1048577 / 9444732965739290427392) * x_error)) + (rounded ((1
    / 4503599627370496) * (Rabs x))))) * (562949953421313 / 562949953421312))))) then (1 / 2 ^ 1020) else 0))))) *
    (562949953421313 / 562949953421312)))).
End program.
Ltac lines := unfold raised_error, raised.
End enclosed_power_float64.

Module enclosed_selection_float64.
Section program.
Variables left left_error right right_error x x_error y y_error : R.
Definition chosen := if Rlt_dec left right then x else y.
Definition chosen_error := if either (Rlt_dec (rounded ((rounded (left_error + right_error)) * (1048577 /
    9444732965739290427392))) (Rabs (rounded (left - right)))) (Req_EM_T (rounded (left_error + right_error)) 0) then
    (if Rlt_dec left right then x_error else y_error) else (rounded ((rounded ((rounded ((Rabs (rounded (x - y))) *
    9007199254740992)) + x_error)) + y_error)).
End program.
Ltac lines := unfold chosen_error, chosen.
End enclosed_selection_float64.
