(* Printed from proofs/theorems by `python -m renderer.generate`. Do not edit: change the claim instead.
   Each definition is one variant: what is written by hand proves it, and is compiled afterwards. *)

From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Float Float64.
Open Scope R_scope.

Definition algebraic_gradient__in_u_1__false : Prop :=
  ~ (
  forall theta : R,
  forall real_part imaginary_part sign_ : nat -> R,
  real_part 0%nat = 1 ->
  (forall n : nat, real_part (S n) = (real_part n) * (-(cos theta)) - (-1) * (imaginary_part n) * (sin theta)) ->
  imaginary_part 0%nat = 0 ->
  (forall n : nat, imaginary_part (S n) = (imaginary_part n) * (-(cos theta)) + (real_part n) * (-(sin theta))) ->
  sign_ 0%nat = 1 ->
  (forall n : nat, sign_ (S n) = -(sign_ n)) ->
  forall n : nat,
  real_part n = cos ((INR n) * theta)).

Definition algebraic_gradient__in_u_2__false : Prop :=
  ~ (
  forall theta : R,
  forall real_part imaginary_part sign_ : nat -> R,
  real_part 0%nat = 1 ->
  (forall n : nat, real_part (S n) = (real_part n) * (-(cos theta)) - (-1) * (imaginary_part n) * (sin theta)) ->
  imaginary_part 0%nat = 0 ->
  (forall n : nat, imaginary_part (S n) = (imaginary_part n) * (-(cos theta)) + (real_part n) * (-(sin theta))) ->
  sign_ 0%nat = 1 ->
  (forall n : nat, sign_ (S n) = -(sign_ n)) ->
  forall n : nat,
  real_part n = cos (PI * ((theta + PI) / (2 * PI) * (2 * (INR n) + 1)))).

Definition algebraic_gradient__rings_in_v_3__false : Prop :=
  ~ (
  forall phi : R,
  forall real_part imaginary_part : nat -> R,
  real_part 0%nat = 1 ->
  (forall n : nat, real_part (S n) = (real_part n) * (cos phi) - (imaginary_part n) * (sin phi)) ->
  imaginary_part 0%nat = 0 ->
  (forall n : nat, imaginary_part (S n) = (imaginary_part n) * (cos phi) + (real_part n) * (sin phi)) ->
  forall n : nat,
  real_part n = cos (PI * (2 * (INR n) * phi / PI))).

Definition algebraic_gradient__negative_power_4__false : Prop :=
  ~ (
  forall alpha : R,
  forall real_part imaginary_part : nat -> R,
  real_part 0%nat = 1 ->
  (forall n : nat, real_part (S n) = (real_part n) * (cos alpha) - (imaginary_part n) * (sin alpha)) ->
  imaginary_part 0%nat = 0 ->
  (forall n : nat, imaginary_part (S n) = (imaginary_part n) * (cos alpha) + (real_part n) * (sin alpha)) ->
  forall n : nat,
  real_part n = cos (alpha * (-(INR n))) /\
  imaginary_part n = sin (alpha * (-(INR n)))).

Definition algebraic_gradient__square_5__false : Prop :=
  ~ (
  forall alpha : R,
  let product_real := (cos alpha - (sin alpha)) * (sin alpha + cos alpha) in
  let product_imaginary := 2 * (sin alpha) * (cos alpha) in
  product_real = cos alpha /\
  product_imaginary = sin alpha).

Definition chart__range_1__false : Prop :=
  ~ (
  forall phi turn : R,
  let u_closed := (1 / 2) * turn + (1 / 2) in
  let u := (if Rlt_dec u_closed 1 then u_closed else 0) in
  turn > -1 ->
  turn <= 1 ->
  phi >= 0 ->
  phi <= PI ->
  (1 / 2) >= u).

Definition chart__seam_2__false : Prop :=
  ~ (
  forall turn : R,
  let u_closed := (1 / 2) * turn + (1 / 2) in
  let u := (if Rlt_dec u_closed 1 then u_closed else 0) in
  turn = 1 ->
  u = u_closed).

Definition chart__round_trip_3__false : Prop :=
  ~ (
  forall turn : R,
  let cos_theta := -(cos (PI * (2 * ((1 / 2) * turn + (1 / 2))))) in
  -cos_theta = cos (PI * turn)).

Definition chart_inverse__formula_1__false : Prop :=
  ~ (
  forall u v : R,
  let cos_theta := -(cos (PI * (2 * u))) in
  let sin_phi := sin (PI * v) in
  let normal_x := cos_theta * sin_phi in
  -normal_x = (-(sin (PI * v))) * (cos (2 * PI * u))).

Definition chart_inverse__recovered_2__false : Prop :=
  ~ (
  forall cos_phi cos_theta sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  normal_x ^ 2 + normal_y ^ 2 >= 0 ->
  sqrt (normal_x ^ 2 + normal_y ^ 2) <> 0 ->
  (sqrt (normal_x ^ 2 + normal_y ^ 2)) ^ 2 = sin_phi ^ 2 /\
  sqrt (normal_x ^ 2 + normal_y ^ 2) = sin_phi /\
  normal_x / sqrt (normal_x ^ 2 + normal_y ^ 2) = cos_theta /\
  normal_y / sqrt (normal_x ^ 2 + normal_y ^ 2) = sin_theta).

Definition clamped_difference__first_order_1__false : Prop :=
  ~ (
  forall bend_minus bend_plus epsilon here largest slope v : R,
  let v_plus := Rmin 1 (epsilon + v) in
  let v_minus := Rmax (v - epsilon) 0 in
  let span_v := (if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus) in
  let h_v_plus := bend_plus * epsilon ^ 2 / 2 + epsilon * slope + here in
  let h_v_minus := bend_minus * v ^ 2 / 2 + here - slope * v in
  let h_v := (h_v_plus - h_v_minus) / span_v in
  epsilon > 0 ->
  v >= 0 ->
  v - epsilon < 0 ->
  epsilon + v <= 1 ->
  bend_plus <= largest ->
  bend_plus >= -largest ->
  bend_minus <= largest ->
  bend_minus >= -largest ->
  span_v <> 0 ->
  2 * (epsilon + v) <> 0 ->
  largest * (epsilon ^ 2 - v ^ 2) / (2 * (epsilon + v)) - (h_v - slope) >= 0 /\
  largest * (epsilon ^ 2 - v ^ 2) / (2 * (epsilon + v)) + h_v - slope >= 0).

Definition clamped_difference__at_the_pole_itself_2__false : Prop :=
  ~ (
  forall epsilon v : R,
  epsilon > 0 ->
  v >= 0 ->
  v - epsilon < 0 ->
  epsilon + v <= 1 ->
  epsilon + v - 0 <> 0 ->
  2 * (epsilon + v) <> 0 ->
  ((1 / 2) * (epsilon + v) ^ 2 - (1 / 2) * 0 ^ 2) / (epsilon + v - 0) - v = (epsilon ^ 2 + v ^ 2) / (2 * (epsilon + v))).

Definition clamped_difference__clamp_3__false : Prop :=
  ~ (
  forall epsilon v : R,
  let v_plus := Rmin 1 (epsilon + v) in
  let v_minus := Rmax (v - epsilon) 0 in
  let span_v := (if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus) in
  epsilon > 0 ->
  v >= 0 ->
  v - epsilon < 0 ->
  epsilon + v <= 1 ->
  span_v = 2 * epsilon).

Definition seed_clamp__odd_1__true : Prop :=
  forall epsilon : R,
  epsilon > 0 ->
  epsilon <= 1 ->
  epsilon + 0 - 0 <> 0 /\
  (epsilon + 0 - (epsilon + 0) ^ 3 - (0 - 0 ^ 3)) / (epsilon + 0 - 0) - (1 - 3 * 0 ^ 2) = -epsilon ^ 2.

Definition seed_clamp__not_odd_2__true : Prop :=
  forall epsilon : R,
  epsilon > 0 ->
  epsilon <= 1 ->
  epsilon + 0 - 0 <> 0 /\
  ((epsilon + 0) ^ 2 + epsilon + 0 - (0 + 0 ^ 2)) / (epsilon + 0 - 0) - (2 * 0 + 1) = epsilon.

Definition colour_accuracy__hit_nearer__false : Prop :=
  ~ (
  forall x y eye ball_center_x ball_center_y ball_center_z ball_radius ball_on : R,
  float64 x ->
  float64 y ->
  float64 eye ->
  float64 ball_center_x ->
  float64 ball_center_y ->
  float64 ball_center_z ->
  float64 ball_radius ->
  float64 ball_on ->
  eye * eye + x * x + y * y >= / 1099511627776 ->
  eye * eye + x * x + y * y <= 2 ^ 100 ->
  ball_radius >= / 1048576 ->
  ball_radius <= 2 ^ 50 ->
  (eye - ball_center_z) * (eye - ball_center_z) + ball_center_x * ball_center_x + ball_center_y * ball_center_y >= 4 * ball_radius ^ 2 ->
  (eye - ball_center_z) * (eye - ball_center_z) + ball_center_x * ball_center_x + ball_center_y * ball_center_y <= 2 ^ 40 * ball_radius ^ 2 ->
  ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - x * (eye - ball_center_z)) ^ 2 - (ball_center_x * y - ball_center_y * x) ^ 2 - (y * (eye - ball_center_z) - ball_center_y * eye) ^ 2 >= ball_radius ^ 2 * (eye * eye + x * x + y * y) / 16 ->
  ball_center_x * x + ball_center_y * y + eye * (eye - ball_center_z) > 0 ->
  ball_on > 0 ->
  Rabs (hit_of_b_float64.t_b x y eye ball_center_x ball_center_y ball_center_z ball_radius ball_on - hit_of_b.t_b x y eye ball_center_x ball_center_y ball_center_z ball_radius ball_on) <= (7 / 72057594037927936) * (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z - ball_radius) * (ball_radius + eye - ball_center_z)) / (ball_center_x * x + ball_center_y * y + eye * (eye - ball_center_z) + sqrt (Rmax 0 (ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - x * (eye - ball_center_z)) ^ 2 - (ball_center_x * y - ball_center_y * x) ^ 2 - (y * (eye - ball_center_z) - ball_center_y * eye) ^ 2)))).

Definition colour_accuracy__normal_nearer__false : Prop :=
  ~ (
  forall normal_x normal_y normal_z g_x g_y g_z beta : R,
  float64 normal_x ->
  float64 normal_y ->
  float64 normal_z ->
  float64 g_x ->
  float64 g_y ->
  float64 g_z ->
  float64 beta ->
  (beta * g_z + normal_z) * (beta * g_z + normal_z) + (beta * g_x + normal_x) * (beta * g_x + normal_x) + (beta * g_y + normal_y) * (beta * g_y + normal_y) >= 1 ->
  (beta * g_z + normal_z) * (beta * g_z + normal_z) + (beta * g_x + normal_x) * (beta * g_x + normal_x) + (beta * g_y + normal_y) * (beta * g_y + normal_y) <= 2 ^ 900 ->
  (beta * g_x) ^ 2 <= (beta * g_z + normal_z) * (beta * g_z + normal_z) + (beta * g_x + normal_x) * (beta * g_x + normal_x) + (beta * g_y + normal_y) * (beta * g_y + normal_y) ->
  (beta * g_y) ^ 2 <= (beta * g_z + normal_z) * (beta * g_z + normal_z) + (beta * g_x + normal_x) * (beta * g_x + normal_x) + (beta * g_y + normal_y) * (beta * g_y + normal_y) ->
  (beta * g_z) ^ 2 <= (beta * g_z + normal_z) * (beta * g_z + normal_z) + (beta * g_x + normal_x) * (beta * g_x + normal_x) + (beta * g_y + normal_y) * (beta * g_y + normal_y) ->
  Rabs (perturbed_float64.bumped_x normal_x normal_y normal_z g_x g_y g_z beta - perturbed.bumped_x normal_x normal_y normal_z g_x g_y g_z beta) <= (3 / 288230376151711744) /\
  Rabs (perturbed_float64.bumped_y normal_x normal_y normal_z g_x g_y g_z beta - perturbed.bumped_y normal_x normal_y normal_z g_x g_y g_z beta) <= (3 / 288230376151711744) /\
  Rabs (perturbed_float64.bumped_z normal_x normal_y normal_z g_x g_y g_z beta - perturbed.bumped_z normal_x normal_y normal_z g_x g_y g_z beta) <= (3 / 288230376151711744)).

Definition colour_accuracy__cosine_nearer__false : Prop :=
  ~ (
  forall point_x point_y point_z light_x light_y light_z bumped_x bumped_y bumped_z : R,
  float64 point_x ->
  float64 point_y ->
  float64 point_z ->
  float64 light_x ->
  float64 light_y ->
  float64 light_z ->
  float64 bumped_x ->
  float64 bumped_y ->
  float64 bumped_z ->
  (light_z - point_z) * (light_z - point_z) + (light_x - point_x) * (light_x - point_x) + (light_y - point_y) * (light_y - point_y) >= / 1099511627776 ->
  (light_z - point_z) * (light_z - point_z) + (light_x - point_x) * (light_x - point_x) + (light_y - point_y) * (light_y - point_y) <= 2 ^ 900 ->
  Rabs bumped_x <= / 1099511627776 + 1 ->
  Rabs bumped_y <= / 1099511627776 + 1 ->
  Rabs bumped_z <= / 1099511627776 + 1 ->
  Rabs (light_direction_float64.mu point_x point_y point_z light_x light_y light_z bumped_x bumped_y bumped_z - light_direction.mu point_x point_y point_z light_x light_y light_z bumped_x bumped_y bumped_z) <= (45 / 1152921504606846976)).

Definition colour_accuracy__blinn_nearer__false : Prop :=
  ~ (
  forall bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z : R,
  float64 bumped_x ->
  float64 bumped_y ->
  float64 bumped_z ->
  float64 halfway_x ->
  float64 halfway_y ->
  float64 halfway_z ->
  halfway_z * halfway_z + halfway_x * halfway_x + halfway_y * halfway_y >= / 1099511627776 ->
  halfway_z * halfway_z + halfway_x * halfway_x + halfway_y * halfway_y <= 2 ^ 900 ->
  Rabs bumped_x <= / 1099511627776 + 1 ->
  Rabs bumped_y <= / 1099511627776 + 1 ->
  Rabs bumped_z <= / 1099511627776 + 1 ->
  Rabs (blinn_highlight_float64.specular_base bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z - blinn_highlight.specular_base bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z) <= (1 / 36028797018963968)).

Definition colour_accuracy__squared_nearer__false : Prop :=
  ~ (
  forall bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z light_distance : R,
  float64 bumped_x ->
  float64 bumped_y ->
  float64 bumped_z ->
  float64 halfway_x ->
  float64 halfway_y ->
  float64 halfway_z ->
  float64 light_distance ->
  halfway_z * halfway_z + halfway_x * halfway_x + halfway_y * halfway_y >= / 1099511627776 ->
  halfway_z * halfway_z + halfway_x * halfway_x + halfway_y * halfway_y <= 2 ^ 400 ->
  light_distance >= / 1048576 ->
  light_distance <= 2 ^ 200 ->
  Rabs bumped_x <= / 1099511627776 + 1 ->
  Rabs bumped_y <= / 1099511627776 + 1 ->
  Rabs bumped_z <= / 1099511627776 + 1 ->
  Rabs (squared_highlight_float64.specular_base bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z light_distance - squared_highlight.specular_base bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z light_distance) <= (5 / 72057594037927936)).

Definition colour_accuracy__phong_nearer__false : Prop :=
  ~ (
  forall bumped_x bumped_y bumped_z view_x view_y view_z towards_x towards_y towards_z mu : R,
  float64 bumped_x ->
  float64 bumped_y ->
  float64 bumped_z ->
  float64 view_x ->
  float64 view_y ->
  float64 view_z ->
  float64 towards_x ->
  float64 towards_y ->
  float64 towards_z ->
  float64 mu ->
  Rabs bumped_x <= / 1099511627776 + 1 ->
  Rabs bumped_y <= / 1099511627776 + 1 ->
  Rabs bumped_z <= / 1099511627776 + 1 ->
  Rabs view_x <= / 1099511627776 + 1 ->
  Rabs view_y <= / 1099511627776 + 1 ->
  Rabs view_z <= / 1099511627776 + 1 ->
  Rabs towards_x <= / 1099511627776 + 1 ->
  Rabs towards_y <= / 1099511627776 + 1 ->
  Rabs towards_z <= / 1099511627776 + 1 ->
  Rabs mu <= / 1099511627776 + 1 ->
  Rabs (phong_highlight_float64.specular_base bumped_x bumped_y bumped_z view_x view_y view_z towards_x towards_y towards_z mu - phong_highlight.specular_base bumped_x bumped_y bumped_z view_x view_y view_z towards_x towards_y towards_z mu) <= (7 / 144115188075855872)).

Definition colour_accuracy__share_red_nearer__false : Prop :=
  ~ (
  forall red light_red albedo_red kd ks mu specular : R,
  float64 red ->
  float64 light_red ->
  float64 albedo_red ->
  float64 kd ->
  float64 ks ->
  float64 mu ->
  float64 specular ->
  red >= 0 ->
  light_red >= 0 ->
  albedo_red >= 0 ->
  kd >= 0 ->
  ks >= 0 ->
  specular >= 0 ->
  light_red <= 2 ^ 20 ->
  albedo_red <= 2 ^ 20 ->
  Rabs (light_term_float64.lit_red red light_red albedo_red kd ks mu specular - light_term.lit_red red light_red albedo_red kd ks mu specular) <= (1 / 128) * ((1 / 1125899906842624) * light_red * (albedo_red * kd * (Rmax 0 mu) + ks * specular) + (1 / 1125899906842624) * red) + (1 / 128000000000000000000000000000000)).

Definition colour_accuracy__share_green_nearer__false : Prop :=
  ~ (
  forall green light_green albedo_green kd ks mu specular : R,
  float64 green ->
  float64 light_green ->
  float64 albedo_green ->
  float64 kd ->
  float64 ks ->
  float64 mu ->
  float64 specular ->
  green >= 0 ->
  light_green >= 0 ->
  albedo_green >= 0 ->
  kd >= 0 ->
  ks >= 0 ->
  specular >= 0 ->
  light_green <= 2 ^ 20 ->
  albedo_green <= 2 ^ 20 ->
  Rabs (light_term_float64.lit_green green light_green albedo_green kd ks mu specular - light_term.lit_green green light_green albedo_green kd ks mu specular) <= (1 / 128) * ((1 / 1125899906842624) * green + (1 / 1125899906842624) * light_green * (albedo_green * kd * (Rmax 0 mu) + ks * specular)) + (1 / 128000000000000000000000000000000)).

Definition colour_accuracy__share_blue_nearer__false : Prop :=
  ~ (
  forall blue light_blue albedo_blue kd ks mu specular : R,
  float64 blue ->
  float64 light_blue ->
  float64 albedo_blue ->
  float64 kd ->
  float64 ks ->
  float64 mu ->
  float64 specular ->
  blue >= 0 ->
  light_blue >= 0 ->
  albedo_blue >= 0 ->
  kd >= 0 ->
  ks >= 0 ->
  specular >= 0 ->
  light_blue <= 2 ^ 20 ->
  albedo_blue <= 2 ^ 20 ->
  Rabs (light_term_float64.lit_blue blue light_blue albedo_blue kd ks mu specular - light_term.lit_blue blue light_blue albedo_blue kd ks mu specular) <= (1 / 128) * ((1 / 1125899906842624) * blue + (1 / 1125899906842624) * light_blue * (albedo_blue * kd * (Rmax 0 mu) + ks * specular)) + (1 / 128000000000000000000000000000000)).

Definition straddling__value_1__false : Prop :=
  ~ (
  forall delta epsilon k_u : R,
  epsilon > 0 ->
  k_u > 0 ->
  epsilon - delta > 0 ->
  delta + epsilon > 0 ->
  1 - k_u * (delta + epsilon) >= 0 ->
  1 - k_u * (epsilon - delta) >= 0 ->
  epsilon <> 0 ->
  (1 / 2) * (Rabs ((sin (PI * ((1 / 2) * 1))) * (sin (PI * (k_u * (delta + epsilon))))) - (Rabs ((sin (PI * ((1 / 2) * 1))) * (sin (PI * (k_u * (delta - epsilon))))))) / epsilon = (sin (epsilon * PI * k_u)) * (cos (delta * PI * k_u)) / epsilon).

Definition straddling__value_2__false : Prop :=
  ~ (
  forall delta epsilon k_u : R,
  epsilon > 0 ->
  k_u > 0 ->
  epsilon - delta > 0 ->
  delta + epsilon > 0 ->
  1 - k_u * (delta + epsilon) + 1 >= 0 ->
  1 - k_u * (epsilon - delta) + 1 >= 0 ->
  epsilon <> 0 ->
  (1 / 2) * (Rabs ((sin (PI * ((1 / 2) * 1))) * (sin (PI * (k_u * (delta + epsilon))))) - (Rabs ((sin (PI * ((1 / 2) * 1))) * (sin (PI * (k_u * (delta - epsilon))))))) / epsilon = (sin (delta * PI * k_u)) * (cos (epsilon * PI * k_u)) / epsilon).

Definition straddling__slope_before_3__false : Prop :=
  ~ (
  forall delta k_u : R,
  -(sin (delta * PI * k_u)) > 0 ->
  PI * k_u * (cos (PI * (delta * k_u))) * (sign ((sin (PI * ((1 / 2) * 1))) * (sin (PI * (delta * k_u))))) * (sin (PI * ((1 / 2) * 1))) = PI * k_u * (cos (delta * PI * k_u))).

Definition straddling__every_crease_4__false : Prop :=
  ~ (
  forall delta m : R,
  m > 0 ->
  Rabs (sin (delta + PI * m)) = Rabs (sin delta)).

Definition seed_truncation_slope__descends_1__true : Prop :=
  forall epsilon omega : R,
  omega > 0 ->
  epsilon > 0 ->
  Rabs (-omega) = omega.

Definition seed_truncation_slope__descends_2__true : Prop :=
  forall epsilon omega : R,
  omega > 0 ->
  epsilon > 0 ->
  epsilon ^ 2 * omega ^ 2 >= 6 ->
  (1 / 6) * epsilon ^ 2 * omega ^ 3 >= Rabs (-omega).

Definition truncation_bound__rings_1__false : Prop :=
  ~ (
  forall epsilon k_v v : R,
  epsilon > 0 ->
  v - epsilon >= 0 ->
  epsilon + v <= 1 ->
  k_v > 0 ->
  2 * epsilon <> 0 ->
  2 * PI * k_v * (cos (PI * (2 * k_v * v))) + (1 / 6) * PI ^ 3 * epsilon ^ 2 * k_v ^ 3 - (1 / 2) / epsilon * (sin (PI * (2 * k_v * (epsilon + v))) - (sin (PI * (2 * k_v * (v - epsilon))))) >= 0).

Definition truncation_bound__sine_2__false : Prop :=
  ~ (
  forall epsilon k_u k_v u v : R,
  epsilon > 0 ->
  u - epsilon >= 0 ->
  epsilon + u < 1 ->
  k_u > 0 ->
  ex_derive_n (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) 3 u ->
  epsilon <> 0 ->
  ex_derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u ->
  1 - (sin (v * PI * k_v)) * (cos (u * PI * k_u)) >= 0 /\
  (sin (v * PI * k_v)) * (cos (u * PI * k_u)) + 1 >= 0 /\
  PI * k_u > 0 /\
  (PI * k_u) ^ 3 > 0 /\
  (Derive_n (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) 3 u) = (-(PI * k_u) ^ 3) * (sin (v * PI * k_v)) * (cos (u * PI * k_u)) /\
  (PI * k_u) ^ 3 - (Derive_n (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) 3 u) >= 0 /\
  (PI * k_u) ^ 3 + (Derive_n (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) 3 u) >= 0 /\
  epsilon * ((1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon - (Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u)) = (sin (v * PI * k_v)) * (cos (u * PI * k_u)) * (sin (epsilon * PI * k_u) - PI * epsilon * k_u) /\
  epsilon * ((6 / 7) * (1 / 6) * epsilon ^ 2 * PI ^ 3 * k_u ^ 3 + 1 * ((1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon - (Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u))) >= 0 /\
  epsilon * ((6 / 7) * (1 / 6) * epsilon ^ 2 * PI ^ 3 * k_u ^ 3 - ((1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon - (Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u))) >= 0 /\
  (6 / 7) * (1 / 6) * epsilon ^ 2 * PI ^ 3 * k_u ^ 3 + 1 * ((1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon - (Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u)) >= 0 /\
  (6 / 7) * (1 / 6) * epsilon ^ 2 * PI ^ 3 * k_u ^ 3 - ((1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon - (Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u)) >= 0).

Definition truncation_bound__apart_3__false : Prop :=
  ~ (
  forall frequency quotient slope : R,
  PI * frequency - quotient >= 0 ->
  PI * frequency + quotient >= 0 ->
  PI * frequency - slope >= 0 ->
  PI * frequency + slope >= 0 ->
  PI * frequency - (quotient - slope) >= 0 /\
  PI * frequency + quotient - slope >= 0).

Definition tangent_frame__right_handed_1__false : Prop :=
  ~ (
  forall cos_phi cos_theta sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  let e_theta_x := -sin_theta in
  let e_theta_y := cos_theta in
  let e_theta_z := 0 in
  let e_phi_x := cos_phi * cos_theta in
  let e_phi_y := cos_phi * sin_theta in
  let e_phi_z := -sin_phi in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  e_phi_z * e_theta_y - e_phi_y * e_theta_z = normal_x /\
  e_phi_x * e_theta_z - e_phi_z * e_theta_x = normal_y /\
  e_phi_y * e_theta_x - e_phi_x * e_theta_y = normal_z).

Definition tangent_frame__derivatives_2__false : Prop :=
  ~ (
  forall phi theta : R,
  ex_derive (fun theta : R => (sin phi) * (cos theta)) theta ->
  ex_derive (fun theta : R => (sin phi) * (sin theta)) theta ->
  ex_derive (fun theta : R => cos phi) theta ->
  -(sin theta) = (Derive (fun theta : R => (sin phi) * (cos theta)) theta) /\
  cos theta = (Derive (fun theta : R => (sin phi) * (sin theta)) theta) /\
  0 = (Derive (fun theta : R => cos phi) theta)).

Definition tangent_frame__orthonormal_3__false : Prop :=
  ~ (
  forall cos_phi cos_theta sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  let e_theta_x := -sin_theta in
  let e_theta_y := cos_theta in
  let e_theta_z := 0 in
  let e_phi_x := cos_phi * cos_theta in
  let e_phi_y := cos_phi * sin_theta in
  let e_phi_z := -sin_phi in
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  e_theta_z * e_theta_z + e_theta_x * e_theta_x + e_theta_y * e_theta_y = 1 /\
  e_phi_z * e_phi_z + e_phi_x * e_phi_x + e_phi_y * e_phi_y = 1 /\
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 /\
  e_phi_z * e_theta_z + e_phi_x * e_theta_x + e_phi_y * e_theta_y = 0 /\
  e_theta_z * normal_z + e_theta_x * normal_x + e_theta_y * normal_y = 0 /\
  e_phi_z * normal_z + e_phi_x * normal_x + e_phi_y * normal_y = 0).

Definition seed_bump_as_displacement__parallel_1__true : Prop :=
  forall beta cos_phi cos_theta h_u h_v sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  let e_theta_x := -sin_theta in
  let e_theta_y := cos_theta in
  let e_theta_z := 0 in
  let e_phi_x := cos_phi * cos_theta in
  let e_phi_y := cos_phi * sin_theta in
  let e_phi_z := -sin_phi in
  let g_x := e_phi_x * h_v + e_theta_x * h_u in
  let g_y := e_phi_y * h_v + e_theta_y * h_u in
  let g_z := e_phi_z * h_v + e_theta_z * h_u in
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi > 0 ->
  beta = 0 ->
  sin_phi <> 0 /\
  normal_z * (m_x * (-beta) * (e_phi_y * h_v + e_theta_y * (1 / 2) * h_u / sin_phi) - (-1) * beta * m_y * (e_phi_x * h_v + e_theta_x * (1 / 2) * h_u / sin_phi)) + normal_x * (m_y * (-beta) * (e_phi_z * h_v + e_theta_z * (1 / 2) * h_u / sin_phi) - (-1) * beta * m_z * (e_phi_y * h_v + e_theta_y * (1 / 2) * h_u / sin_phi)) + normal_y * (m_z * (-beta) * (e_phi_x * h_v + e_theta_x * (1 / 2) * h_u / sin_phi) - (-1) * beta * m_x * (e_phi_z * h_v + e_theta_z * (1 / 2) * h_u / sin_phi)) = 0.

Definition seed_bump_as_displacement__parallel_2__true : Prop :=
  forall beta cos_phi cos_theta h_u h_v sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  let e_theta_x := -sin_theta in
  let e_theta_y := cos_theta in
  let e_theta_z := 0 in
  let e_phi_x := cos_phi * cos_theta in
  let e_phi_y := cos_phi * sin_theta in
  let e_phi_z := -sin_phi in
  let g_x := e_phi_x * h_v + e_theta_x * h_u in
  let g_y := e_phi_y * h_v + e_theta_y * h_u in
  let g_z := e_phi_z * h_v + e_theta_z * h_u in
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi > 0 ->
  h_u = 0 ->
  sin_phi <> 0 /\
  normal_z * (m_x * (-beta) * (e_phi_y * h_v + e_theta_y * (1 / 2) * h_u / sin_phi) - (-1) * beta * m_y * (e_phi_x * h_v + e_theta_x * (1 / 2) * h_u / sin_phi)) + normal_x * (m_y * (-beta) * (e_phi_z * h_v + e_theta_z * (1 / 2) * h_u / sin_phi) - (-1) * beta * m_z * (e_phi_y * h_v + e_theta_y * (1 / 2) * h_u / sin_phi)) + normal_y * (m_z * (-beta) * (e_phi_x * h_v + e_theta_x * (1 / 2) * h_u / sin_phi) - (-1) * beta * m_x * (e_phi_z * h_v + e_theta_z * (1 / 2) * h_u / sin_phi)) = 0.

Definition central_difference_of_sine__rings_in_v_1__false : Prop :=
  ~ (
  forall epsilon k_v v : R,
  epsilon > 0 ->
  v - epsilon >= 0 ->
  epsilon + v <= 1 ->
  k_v > 0 ->
  2 * epsilon <> 0 ->
  PI * k_v <> 0 ->
  epsilon * PI * k_v <> 0 ->
  2 * epsilon * (sin (PI * (2 * k_v * (epsilon + v))) - (sin (PI * (2 * k_v * (v - epsilon))))) / (2 * epsilon) = 2 * 2 * PI * k_v * (cos (PI * (2 * k_v * v))) / (PI * k_v) * (sin (epsilon * PI * k_v)) /\
  (sin (PI * (2 * k_v * (epsilon + v))) - (sin (PI * (2 * k_v * (v - epsilon))))) / (2 * epsilon) = (sin (epsilon * PI * k_v)) / (epsilon * PI * k_v) * 2 * PI * k_v * (cos (PI * (2 * k_v * v)))).

Definition central_difference_of_sine__sine_in_u_2__false : Prop :=
  ~ (
  forall epsilon k_u k_v u v : R,
  epsilon > 0 ->
  u - epsilon >= 0 ->
  epsilon + u < 1 ->
  k_u > 0 ->
  epsilon <> 0 ->
  2 * epsilon * PI * k_u <> 0 ->
  (1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon = (sin (2 * epsilon * PI * k_u)) / (2 * epsilon * PI * k_u) * PI * k_u * (cos (PI * (k_u * u))) * (sin (PI * (k_v * v)))).

Definition central_difference_of_sine__sine_in_u_3__false : Prop :=
  ~ (
  forall epsilon k_u k_v u v : R,
  epsilon > 0 ->
  u - epsilon >= 0 ->
  epsilon + u < 1 ->
  k_u > 0 ->
  epsilon <> 0 ->
  (1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon = PI * k_u * (cos (PI * (k_u * u))) * (sin (PI * (k_v * v)))).

Definition central_difference_of_sine__no_clamp_4__false : Prop :=
  ~ (
  forall epsilon v : R,
  let v_plus := Rmin 1 (epsilon + v) in
  let v_minus := Rmax (v - epsilon) 0 in
  let span_v := (if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus) in
  epsilon > 0 ->
  epsilon < (1 / 2) ->
  v >= 0 ->
  v <= 1 ->
  v_plus = epsilon + v /\
  v_minus = v - epsilon /\
  span_v = 2 * epsilon).

Definition seed_orientation__right_handed_2__true : Prop :=
  forall cos_phi cos_theta sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  let e_theta_x := -sin_theta in
  let e_theta_y := cos_theta in
  let e_theta_z := 0 in
  let e_phi_x := cos_phi * cos_theta in
  let e_phi_y := cos_phi * sin_theta in
  let e_phi_z := -sin_phi in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  e_phi_z * e_theta_y - e_phi_y * e_theta_z = -normal_x /\
  e_phi_x * e_theta_z - e_phi_z * e_theta_x = -normal_y /\
  e_phi_y * e_theta_x - e_phi_x * e_theta_y = -normal_z.

Definition hit_of_a__solves_1__false : Prop :=
  ~ (
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye ->
  discriminant_a >= 0 ->
  x ^ 2 + y ^ 2 >= 0 ->
  tangent_squared >= 0 ->
  tangent_squared <> 0 ->
  Rmax 0 discriminant_a >= 0 ->
  eye ^ 2 + root_a <> 0 ->
  (eye * (1 - t_a / tangent_squared) + 0) ^ 2 + (y * t_a / tangent_squared + 0) ^ 2 + (x * t_a / tangent_squared + 0) ^ 2 + 0 = radius ^ 2).

Definition hit_of_a__near_2__false : Prop :=
  ~ (
  forall eye radius t x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye ->
  discriminant_a >= 0 ->
  (eye * (1 - t) + 0) ^ 2 + (t * y + 0) ^ 2 + (t * x + 0) ^ 2 + 0 = radius ^ 2 ->
  x ^ 2 + y ^ 2 >= 0 ->
  tangent_squared >= 0 ->
  tangent_squared <> 0 ->
  Rmax 0 discriminant_a >= 0 ->
  eye ^ 2 + root_a <> 0 ->
  t <= t_a).

Definition hit_of_a__solves_3__false : Prop :=
  ~ (
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye ->
  discriminant_a >= 0 ->
  x ^ 2 + y ^ 2 >= 0 ->
  tangent_squared >= 0 ->
  tangent_squared <> 0 ->
  Rmax 0 discriminant_a >= 0 ->
  eye ^ 2 + root_a <> 0 ->
  t_a < (1 / 2)).

Definition gradients__sine_1__false : Prop :=
  ~ (
  forall k_u k_v u v : R,
  let cos_u := cos (PI * (k_u * u)) in
  let cos_v := cos (PI * (k_v * v)) in
  let sin_u := sin (PI * (k_u * u)) in
  let sin_v := sin (PI * (k_v * v)) in
  let h_u := PI * cos_u * k_u * sin_v in
  let h_v := PI * cos_v * k_v * sin_u in
  h_u = h_v).

Definition gradients__sine_2__false : Prop :=
  ~ (
  forall epsilon k_u k_v u v : R,
  let cos_u := cos (PI * (k_u * u)) in
  let sin_v := sin (PI * (k_v * v)) in
  let h_u := PI * cos_u * k_u * sin_v in
  PI * k_u * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) - (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) = (-h_u) * (sin (epsilon * PI * k_u)) + PI * k_u * (sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) * (cos (epsilon * PI * k_u) - 1)).

Definition gradients__rings_3__false : Prop :=
  ~ (
  forall epsilon k_v v : R,
  let cos_v := cos (PI * (2 * k_v * v)) in
  let h_v := 2 * PI * cos_v * k_v in
  PI * k_v * (sin (PI * (2 * k_v * (epsilon + v))) - (sin (PI * (2 * k_v * v)))) = h_v * (sin (epsilon * PI * k_v)) + PI * k_v * (sin (PI * (2 * k_v * v))) * (cos (epsilon * PI * k_v) - 1)).

Definition gradients__ridges_below_4__false : Prop :=
  ~ (
  forall k_u k_v u v : R,
  let cos_u := cos (PI * (k_u * u)) in
  let sin_u := sin (PI * (k_u * u)) in
  let sin_v := sin (PI * (k_v * v)) in
  let h_u := PI * cos_u * k_u * sin_v * (sign (sin_u * sin_v)) in
  -(sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) > 0 ->
  ex_derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u ->
  h_u = (Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u)).

Definition specular_lipschitz__twice_1__false : Prop :=
  ~ (
  forall a apart b c turned : R,
  apart >= 0 ->
  c * 2 * a * b + 1 - a ^ 2 - b ^ 2 - c ^ 2 >= 0 ->
  turned ^ 2 = 4 * (a ^ 2 + b ^ 2 - 2 * a * b * c) ->
  apart ^ 2 = 2 - 2 * c ->
  apart >= turned).

Definition specular_lipschitz__mirror_2__false : Prop :=
  ~ (
  forall m_x m_y m_z n_x n_y n_z omega_x omega_y omega_z : R,
  n_z * n_z + n_x * n_x + n_y * n_y = 1 ->
  m_z * m_z + m_x * m_x + m_y * m_y = 1 ->
  (n_x * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y) - omega_x - (m_x * 2 * (m_z * omega_z + m_x * omega_x + m_y * omega_y) - omega_x)) * (n_x * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y) - omega_x - (m_x * 2 * (m_z * omega_z + m_x * omega_x + m_y * omega_y) - omega_x)) + (n_y * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y) - omega_y - (m_y * 2 * (m_z * omega_z + m_x * omega_x + m_y * omega_y) - omega_y)) * (n_y * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y) - omega_y - (m_y * 2 * (m_z * omega_z + m_x * omega_x + m_y * omega_y) - omega_y)) + (n_z * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y) - omega_z - (m_z * 2 * (m_z * omega_z + m_x * omega_x + m_y * omega_y) - omega_z)) * (n_z * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y) - omega_z - (m_z * 2 * (m_z * omega_z + m_x * omega_x + m_y * omega_y) - omega_z)) = (m_z * omega_z + m_x * omega_x + m_y * omega_y) ^ 2 + (n_z * omega_z + n_x * omega_x + n_y * omega_y) ^ 2 - 2 * (m_z * n_z + m_x * n_x + m_y * n_y) * (m_z * omega_z + m_x * omega_x + m_y * omega_y) * (n_z * omega_z + n_x * omega_x + n_y * omega_y)).

Definition specular_lipschitz__power_3__false : Prop :=
  ~ (
  forall by_x by_z of_x of_z power_ quotient x z : R,
  x <= 1 ->
  z <= 1 ->
  x >= z ->
  quotient >= 0 ->
  by_x >= 0 ->
  by_z >= 0 ->
  of_x - of_z = quotient * (x - z) ->
  power_ - quotient = by_x * (1 - x) + by_z * (1 - z) ->
  (power_ - 1) * (x - z) - (of_x - of_z) >= 0 /\
  of_x - of_z + (power_ - 1) * (x - z) >= 0).

Definition specular_lipschitz__factors_4__false : Prop :=
  ~ (
  forall x z : R,
  forall of_x of_z power_ quotient geometric by_x by_z : nat -> R,
  of_x 0%nat = 1 ->
  (forall count : nat, of_x (S count) = (of_x count) * x) ->
  of_z 0%nat = 1 ->
  (forall count : nat, of_z (S count) = (of_z count) * z) ->
  power_ 0%nat = 0 ->
  (forall count : nat, power_ (S count) = power_ count + 1) ->
  quotient 0%nat = 0 ->
  (forall count : nat, quotient (S count) = (quotient count) * x) ->
  geometric 0%nat = 0 ->
  (forall count : nat, geometric (S count) = geometric count + of_z count) ->
  by_x 0%nat = 0 ->
  (forall count : nat, by_x (S count) = (by_x count) * x + power_ count) ->
  by_z 0%nat = 0 ->
  (forall count : nat, by_z (S count) = (by_z count) * x + geometric count) ->
  forall count : nat,
  of_x count - (of_z count) = (quotient count) * (x - z) /\
  1 - (of_z count) = (geometric count) * (1 - z) /\
  power_ count - (quotient count) = (by_x count) * (1 - x) + (by_z count) * (1 - z)).

Definition highlight_below_one__root_1__true : Prop :=
  forall bound x : R,
  x >= 0 ->
  x <= 1 ->
  bound >= 1 ->
  bound * sqrt x >= 1 ->
  x >= 0 /\
  bound * x >= sqrt x.

Definition highlight_below_one__any_bound_2__true : Prop :=
  forall bound z : R,
  bound >= 1 ->
  z >= 0 ->
  2 * bound * z = 1 ->
  z ^ 2 >= 0 /\
  bound > 0 /\
  z > 0 /\
  sqrt (z ^ 2) > bound * z ^ 2.

Definition squared_highlight__halfway_1__false : Prop :=
  ~ (
  forall light_x light_y light_z point_x point_y point_z view_x : R,
  let to_light_x := light_x - point_x in
  let to_light_y := light_y - point_y in
  let to_light_z := light_z - point_z in
  let distance_squared := to_light_x ^ 2 + to_light_y ^ 2 + to_light_z ^ 2 in
  let light_distance := sqrt distance_squared in
  let halfway_x := light_distance * view_x + to_light_x in
  let to_light_x_plain := light_x - point_x in
  let to_light_y_plain := light_y - point_y in
  let to_light_z_plain := light_z - point_z in
  let light_distance_plain := sqrt (to_light_x_plain ^ 2 + to_light_y_plain ^ 2 + to_light_z_plain ^ 2) in
  let light_scale_plain := / light_distance_plain in
  let towards_x_plain := light_scale_plain * to_light_x_plain in
  let halfway_x_plain := towards_x_plain + view_x in
  light_distance > 0 ->
  distance_squared >= 0 ->
  to_light_x_plain ^ 2 + to_light_y_plain ^ 2 + to_light_z_plain ^ 2 >= 0 ->
  light_distance_plain <> 0 ->
  halfway_x = halfway_x_plain).

Definition squared_highlight__base_2__false : Prop :=
  ~ (
  forall along_halfway halfway_length_plain halfway_squared light_distance light_scale specular_base_plain : R,
  halfway_squared * light_distance * light_scale = 1 ->
  halfway_length_plain ^ 2 * light_distance ^ 2 = halfway_squared ->
  specular_base_plain * halfway_length_plain * light_distance = along_halfway ->
  along_halfway ^ 2 * light_distance * light_scale = specular_base_plain).

Definition squared_highlight__opposite_3__false : Prop :=
  ~ (
  forall bumped_x bumped_y bumped_z light_x light_y light_z point_x point_y point_z view_x view_y view_z : R,
  let to_light_x := light_x - point_x in
  let to_light_y := light_y - point_y in
  let to_light_z := light_z - point_z in
  let distance_squared := to_light_x ^ 2 + to_light_y ^ 2 + to_light_z ^ 2 in
  let light_distance := sqrt distance_squared in
  let halfway_x := light_distance * view_x + to_light_x in
  let halfway_y := light_distance * view_y + to_light_y in
  let halfway_z := light_distance * view_z + to_light_z in
  let halfway_squared := halfway_x ^ 2 + halfway_y ^ 2 + halfway_z ^ 2 in
  let along_light := bumped_x * to_light_x + bumped_y * to_light_y + bumped_z * to_light_z in
  let light_scale := (if Rlt_dec 0 halfway_squared then 1 / (halfway_squared * light_distance) else 0) in
  let mu := (if Rlt_dec 0 halfway_squared then along_light * halfway_squared * light_scale else -bumped_x * view_x - bumped_y * view_y - bumped_z * view_z) in
  light_distance > 0 ->
  distance_squared >= 0 ->
  (halfway_squared > 0 -> halfway_squared <> 0) ->
  (halfway_squared > 0 -> light_distance <> 0) ->
  mu = -(bumped_z * view_z + bumped_x * view_x + bumped_y * view_y)).

Definition hit_of_b__quadratic_1__false : Prop :=
  ~ (
  forall ball_center_x ball_center_y ball_center_z ball_radius eye x y : R,
  let distance := eye - ball_center_z in
  let toward_b := ball_center_x * x + ball_center_y * y + distance * eye in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 - (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  discriminant_b = toward_b ^ 2 - (ball_center_z ^ 2 + ball_center_y ^ 2 + ball_center_x ^ 2 + 0 - ball_radius ^ 2) * ((-eye) * (-eye) + x * x + y * y)).

Definition hit_of_b__near_2__false : Prop :=
  ~ (
  forall ball_center_x ball_center_y ball_center_z ball_on ball_radius eye t x y : R,
  let distance := eye - ball_center_z in
  let toward_b := ball_center_x * x + ball_center_y * y + distance * eye in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 - (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  let root_b := sqrt (Rmax 0 discriminant_b) in
  let t_b := (ball_center_x ^ 2 + ball_center_y ^ 2 + (distance - ball_radius) * (ball_radius + distance)) / (root_b + toward_b) in
  eye > 0 ->
  discriminant_b >= 0 ->
  toward_b > 0 ->
  ball_on > 0 ->
  (eye * (1 - t) - ball_center_z) ^ 2 + (t * y - ball_center_y) ^ 2 + (t * x - ball_center_x) ^ 2 + 0 = ball_radius ^ 2 ->
  Rmax 0 discriminant_b >= 0 ->
  root_b + toward_b <> 0 ->
  t <= t_b).

Definition hit_of_b__outward_3__false : Prop :=
  ~ (
  forall ball_center_x ball_center_y ball_center_z ball_on ball_radius eye x y : R,
  let distance := eye - ball_center_z in
  let toward_b := ball_center_x * x + ball_center_y * y + distance * eye in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 - (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  let root_b := sqrt (Rmax 0 discriminant_b) in
  let t_b := (ball_center_x ^ 2 + ball_center_y ^ 2 + (distance - ball_radius) * (ball_radius + distance)) / (root_b + toward_b) in
  let moment_x := distance * y - ball_center_y * eye in
  let moment_y := ball_center_x * eye - distance * x in
  let moment_z := ball_center_x * y - ball_center_y * x in
  let ray_length_squared := eye ^ 2 + x ^ 2 + y ^ 2 in
  let radius_vector_x := (-eye * moment_y - moment_z * y - root_b * x) / ray_length_squared in
  let radius_vector_y := (eye * moment_x + moment_z * x - root_b * y) / ray_length_squared in
  let radius_vector_z := (eye * root_b + moment_x * y - moment_y * x) / ray_length_squared in
  let radius_length := sqrt (radius_vector_x ^ 2 + radius_vector_y ^ 2 + radius_vector_z ^ 2) in
  let normal_x := radius_vector_x / radius_length in
  let normal_y := radius_vector_y / radius_length in
  let normal_z := radius_vector_z / radius_length in
  (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 > ball_radius ^ 2 ->
  discriminant_b >= 0 ->
  toward_b > 0 ->
  ball_on > 0 ->
  ball_radius > 0 ->
  Rmax 0 discriminant_b >= 0 ->
  root_b + toward_b <> 0 ->
  ray_length_squared <> 0 ->
  radius_vector_x ^ 2 + radius_vector_y ^ 2 + radius_vector_z ^ 2 >= 0 ->
  radius_length <> 0 ->
  (-ball_radius) * normal_x = t_b * x - ball_center_x /\
  (-ball_radius) * normal_y = t_b * y - ball_center_y /\
  (-ball_radius) * normal_z = eye * (1 - t_b) - ball_center_z).

Definition hit_of_b__behind_4__false : Prop :=
  ~ (
  forall ball_center_x ball_center_y ball_center_z ball_on ball_radius eye t x y : R,
  let distance := eye - ball_center_z in
  let toward_b := ball_center_x * x + ball_center_y * y + distance * eye in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 - (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  let hits_b := (if both (both (Rlt_dec 0 ball_on) (Rle_dec 0 discriminant_b)) (Rlt_dec 0 toward_b) then 1 else 0) in
  (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 > ball_radius ^ 2 ->
  toward_b >= 0 ->
  (eye * (1 - t) - ball_center_z) ^ 2 + (t * y - ball_center_y) ^ 2 + (t * x - ball_center_x) ^ 2 + 0 = ball_radius ^ 2 ->
  t < 0 /\
  hits_b = 0).

Definition seed_quadratic_of_b__agree_2__true : Prop :=
  forall ball_center_x ball_center_y ball_center_z ball_radius eye : R,
  eye = 2 * ball_center_z ->
  ball_center_z ^ 2 + ball_center_y ^ 2 + ball_center_x ^ 2 + 0 - ball_radius ^ 2 = (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 - ball_radius ^ 2.

Definition ridges_on_creases__crease_in_u_1__false : Prop :=
  ~ (
  forall k_u k_v m to_u v : R,
  k_u > 0 ->
  to_u > 0 ->
  k_u * to_u <= 1 ->
  sin (PI * m) = 0 ->
  k_u <> 0 ->
  (Rabs ((sin (PI * (k_u * (1 * to_u + m / k_u)))) * (sin (PI * (k_v * v))))) ^ 2 > (Rabs ((sin (PI * (k_u * (m / k_u - to_u)))) * (sin (PI * (k_v * v))))) ^ 2).

Definition ridges_on_creases__crease_in_u_2__false : Prop :=
  ~ (
  forall k_u k_v m to_u v : R,
  k_u > 0 ->
  to_u > 0 ->
  k_u * to_u <= 1 ->
  k_u <> 0 ->
  Rabs (sin (PI * (k_u * (1 * to_u + m / k_u)))) >= sin (to_u * PI * k_u) /\
  sin (to_u * PI * k_u) >= Rabs (sin (PI * (k_u * (1 * to_u + m / k_u)))) /\
  Rabs (sin (PI * (k_u * (1 * to_u + m / k_u)))) = sin (to_u * PI * k_u) /\
  Rabs (sin (PI * (k_u * (m / k_u - to_u)))) >= sin (to_u * PI * k_u) /\
  sin (to_u * PI * k_u) >= Rabs (sin (PI * (k_u * (m / k_u - to_u)))) /\
  Rabs (sin (PI * (k_u * (m / k_u - to_u)))) = sin (to_u * PI * k_u) /\
  Rabs ((sin (PI * (k_u * (1 * to_u + m / k_u)))) * (sin (PI * (k_v * v)))) = (sin (to_u * PI * k_u)) * (Rabs (sin (v * PI * k_v))) /\
  Rabs ((sin (PI * (k_u * (m / k_u - to_u)))) * (sin (PI * (k_v * v)))) = (sin (to_u * PI * k_u)) * (Rabs (sin (v * PI * k_v))) /\
  to_u * PI * k_u * (Rabs (sin (v * PI * k_v))) >= Rabs ((sin (PI * (k_u * (1 * to_u + m / k_u)))) * (sin (PI * (k_v * v)))) /\
  Rabs ((sin (PI * (k_u * (1 * to_u + m / k_u)))) * (sin (PI * (k_v * v)))) >= to_u * PI * k_u * (Rabs (sin (v * PI * k_v))) * (1 - (1 / 6) * PI ^ 2 * k_u ^ 2 * to_u ^ 2)).

Definition ridges_on_creases__differ_3__false : Prop :=
  ~ (
  forall angle left right slope : R,
  slope >= 0 ->
  angle ^ 2 <= 1 ->
  6 * right >= slope * (6 - angle ^ 2) ->
  left = -right ->
  6 * right >= 5 * slope /\
  right - left > slope).

Definition gradient_accuracy__sine_nearer__false : Prop :=
  ~ (
  forall u v k_u k_v : R,
  float64 u ->
  float64 v ->
  float64 k_u ->
  float64 k_v ->
  u >= 0 ->
  u <= 1 ->
  Rabs k_u <= 1048576 ->
  (10 ^ 285 * (Rabs (k_u * u)) >= 1 \/ k_u * u = 0) ->
  v >= 0 ->
  v <= 1 ->
  Rabs k_v <= 1048576 ->
  (10 ^ 285 * (Rabs (k_v * v)) >= 1 \/ k_v * v = 0) ->
  Rabs (gradient_sine_float64.h_u u v k_u k_v - gradient_sine.h_u u v k_u k_v) <= (5 / 576460752303423488) * PI * (Rmax 1 (Rabs k_u)) /\
  Rabs (gradient_sine_float64.h_v u v k_u k_v - gradient_sine.h_v u v k_u k_v) <= (5 / 576460752303423488) * PI * (Rmax 1 (Rabs k_v))).

Definition gradient_accuracy__ridges_nearer__false : Prop :=
  ~ (
  forall u v k_u k_v : R,
  float64 u ->
  float64 v ->
  float64 k_u ->
  float64 k_v ->
  u >= 0 ->
  u <= 1 ->
  Rabs k_u <= 1048576 ->
  (10 ^ 285 * (Rabs (k_u * u)) >= 1 \/ k_u * u = 0) ->
  v >= 0 ->
  v <= 1 ->
  Rabs k_v <= 1048576 ->
  (10 ^ 285 * (Rabs (k_v * v)) >= 1 \/ k_v * v = 0) ->
  Rabs (gradient_ridges_float64.h_u u v k_u k_v - gradient_ridges.h_u u v k_u k_v) <= (5 / 576460752303423488) * PI * (Rmax 1 (Rabs k_u)) /\
  Rabs (gradient_ridges_float64.h_v u v k_u k_v - gradient_ridges.h_v u v k_u k_v) <= (5 / 576460752303423488) * PI * (Rmax 1 (Rabs k_v))).

Definition gradient_accuracy__rings_nearer__false : Prop :=
  ~ (
  forall v k_v : R,
  float64 v ->
  float64 k_v ->
  v >= 0 ->
  v <= 1 ->
  Rabs k_v <= 1048576 ->
  (10 ^ 285 * (Rabs (k_v * v)) >= 1 \/ k_v * v = 0) ->
  Rabs (gradient_rings_float64.h_v v k_v - gradient_rings.h_v v k_v) <= (5 / 576460752303423488) * PI * (Rmax 1 (Rabs (2 * k_v)))).

Definition rounded_powers__product_1__false : Prop :=
  ~ (
  forall excess first fourth imaginary_part off_first off_second other_imaginary other_real real_part second third unit : R,
  unit >= 0 ->
  excess = (unit + 1) ^ 3 - 1 ->
  off_first = first * other_real * real_part - imaginary_part * other_imaginary * second ->
  off_second = fourth * imaginary_part * other_real + third * other_imaginary * real_part ->
  unit ^ 2 + 2 * unit - first >= 0 ->
  first + unit ^ 2 + 2 * unit >= 0 ->
  unit ^ 2 + 2 * unit - second >= 0 ->
  second + unit ^ 2 + 2 * unit >= 0 ->
  unit ^ 2 + 2 * unit - third >= 0 ->
  third + unit ^ 2 + 2 * unit >= 0 ->
  unit ^ 2 + 2 * unit - fourth >= 0 ->
  fourth + unit ^ 2 + 2 * unit >= 0 ->
  unit ^ 2 * (imaginary_part ^ 2 + real_part ^ 2) * (other_imaginary ^ 2 + other_real ^ 2) >= off_first ^ 2 + off_second ^ 2).

Definition rounded_powers__power_2__false : Prop :=
  ~ (
  forall excess most most_other off off_first off_second other_size own size : R,
  excess >= 0 ->
  size >= 0 ->
  other_size >= 0 ->
  off_first >= 0 ->
  off_second >= 0 ->
  most - 1 >= off_first ->
  most_other - 1 >= off_second ->
  off_first + 1 >= size ->
  off_second + 1 >= other_size ->
  other_size * excess * size >= own ->
  off_second + off_first * other_size + own >= off ->
  most_other + excess + most - 2 >= off).

Definition rounded_powers__factors_3__false : Prop :=
  ~ (
  forall exact most most_other other_exact other_value value : R,
  1 - exact >= 0 ->
  exact + 1 >= 0 ->
  1 - other_exact >= 0 ->
  other_exact + 1 >= 0 ->
  most - 1 - (value - exact) >= 0 ->
  value - exact + most - 1 >= 0 ->
  most_other - 1 - (other_value - other_exact) >= 0 ->
  most_other - 1 + other_value - other_exact >= 0 ->
  most - 1 - (other_value * value - exact * other_exact) >= 0 /\
  most - 1 + other_value * value - exact * other_exact >= 0).

Definition roundoff_bound__in_u_1__false : Prop :=
  ~ (
  forall argument epsilon evaluation excess growth here mean off_minus off_plus steepest : R,
  let h_u_plus := off_plus + 2 * epsilon * mean + here in
  let h_u_minus := here + off_minus in
  let h_u := (1 / 2) * (h_u_plus - h_u_minus) / epsilon in
  epsilon > 0 ->
  excess - (growth - 1) >= 0 ->
  excess + growth - 1 >= 0 ->
  argument * steepest + evaluation - off_plus >= 0 ->
  off_plus + argument * steepest + evaluation >= 0 ->
  argument * steepest + evaluation - off_minus >= 0 ->
  off_minus + argument * steepest + evaluation >= 0 ->
  steepest - mean >= 0 ->
  mean + steepest >= 0 ->
  epsilon <> 0 ->
  2 * epsilon <> 0 ->
  excess * steepest + (argument * steepest + evaluation) / (2 * epsilon) * (excess + 1) - (growth * h_u - mean) >= 0 /\
  excess * steepest + (argument * steepest + evaluation) / (2 * epsilon) * (excess + 1) + growth * h_u - mean >= 0).

Definition roundoff_bound__in_u_2__false : Prop :=
  ~ (
  forall argument epsilon evaluation excess growth here mean off_minus off_plus steepest : R,
  let h_u_plus := off_plus + 2 * epsilon * mean + here in
  let h_u_minus := here + off_minus in
  let h_u := (1 / 2) * (h_u_plus - h_u_minus) / epsilon in
  epsilon > 0 ->
  excess - (growth - 1) >= 0 ->
  excess + growth - 1 >= 0 ->
  argument * steepest + evaluation - off_plus >= 0 ->
  off_plus + argument * steepest + evaluation >= 0 ->
  argument * steepest + evaluation - off_minus >= 0 ->
  off_minus + argument * steepest + evaluation >= 0 ->
  steepest - mean >= 0 ->
  mean + steepest >= 0 ->
  epsilon <> 0 ->
  excess * steepest + evaluation / epsilon * (excess + 1) - (growth * h_u - mean) >= 0 /\
  excess * steepest + evaluation / epsilon * (excess + 1) + growth * h_u - mean >= 0).

Definition roundoff_bound__two_roundings_3__false : Prop :=
  ~ (
  forall first growth second unit : R,
  unit > 0 ->
  unit < 1 ->
  unit - first >= 0 ->
  first + unit >= 0 ->
  unit - second >= 0 ->
  second + unit >= 0 ->
  growth = (first + 1) * (second + 1) ->
  unit >= growth - 1).

Definition roundoff_bound__three_roundings_4__false : Prop :=
  ~ (
  forall first growth second third unit : R,
  unit > 0 ->
  unit < 1 ->
  unit - first >= 0 ->
  first + unit >= 0 ->
  unit - second >= 0 ->
  second + unit >= 0 ->
  unit - third >= 0 ->
  third + unit >= 0 ->
  growth * (third + 1) = (first + 1) * (second + 1) ->
  unit ^ 2 + 2 * unit >= growth - 1).

Definition elementary_functions__sinpi_nearer__false : Prop :=
  ~ (
  forall x y : R,
  float64 x ->
  float64 y ->
  Rabs (x * y) <= 2 ^ 21 ->
  (10 ^ 285 * (Rabs (x * y)) >= 1 \/ x * y = 0) ->
  10 ^ 285 * (Rabs (sin (PI * (x * y)))) >= 1 ->
  Rabs (enclosed_sine_float64.sine x y - enclosed_sine.sine x y) <= (1 / 1152921504606846976) * (Rmin ((33 / 10)) (5 * (Rabs (sin (PI * (x * y))))))).

Definition elementary_functions__cospi_nearer__false : Prop :=
  ~ (
  forall x y : R,
  float64 x ->
  float64 y ->
  Rabs (x * y) <= 2 ^ 21 ->
  (10 ^ 285 * (Rabs (x * y)) >= 1 \/ x * y = 0) ->
  10 ^ 285 * (Rabs (cos (PI * (x * y)))) >= 1 ->
  Rabs (enclosed_cosine_float64.cosine x y - enclosed_cosine.cosine x y) <= (1 / 1152921504606846976) * (Rmin ((33 / 10)) (5 * (Rabs (cos (PI * (x * y))))))).

Definition elementary_functions__angle_nearer__false : Prop :=
  ~ (
  forall x y : R,
  float64 x ->
  float64 y ->
  10 ^ 285 * (Rmax (Rabs x) (Rabs y)) >= 1 ->
  10 ^ 285 * (Rabs (atan2pi y x)) >= 1 ->
  Rabs (enclosed_angle_float64.angle x y - enclosed_angle.angle x y) <= (5 / 1152921504606846976) * (Rabs (atan2pi y x))).

Definition elementary_functions__exp_nearer__false : Prop :=
  ~ (
  forall product product_error : R,
  float64 product ->
  float64 product_error ->
  product >= -708 ->
  product <= 709 ->
  2 ^ 42 * (Rabs product_error) <= 1 ->
  Rabs (exponential_of_sum_float64.exponential product product_error - exponential_of_sum.exponential product product_error) <= (11 / 5764607523034234880) * (Rabs (exp (product + product_error)))).

Definition elementary_functions__log_nearer__false : Prop :=
  ~ (
  forall x : R,
  float64 x ->
  x > 0 ->
  x <= 2 ^ 1024 - 2 ^ 971 ->
  10 ^ 285 * (Rabs (ln x)) >= 1 ->
  Rabs (enclosed_logarithm_float64.logarithm x - enclosed_logarithm.logarithm x) <= (13 / 14411518807585587200) * (Rabs (ln x))).

Definition elementary_functions__power_nearer__false : Prop :=
  ~ (
  forall number exponent : R,
  float64 number ->
  float64 exponent ->
  number > 0 ->
  number <= 2 ^ 1024 - 2 ^ 971 ->
  2048 * exponent >= 1 ->
  exponent <= 2 ^ 20 ->
  100 * exponent * (ln number) >= -70799 ->
  100 * exponent * (ln number) <= 70899 ->
  Rabs (raised_float64.power number exponent - raised.power number exponent) <= (1 / 1152921504606846976) * ((3 / 100) * (Rabs (exponent * (ln number))) + (5 / 2)) * (Rabs (power number exponent))).

Definition seed_step_in_beta__linear_1__true : Prop :=
  forall beta g_x normal_x : R,
  (g_x * (beta + (1 / 10000000)) + normal_x - (beta * g_x + normal_x)) / ((1 / 10000000)) = g_x.

Definition lagrange_identity__of_b_1__false : Prop :=
  ~ (
  forall ball_center_x ball_center_y ball_center_z ball_radius eye x y : R,
  let distance := eye - ball_center_z in
  let toward_b := ball_center_x * x + ball_center_y * y + distance * eye in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 - (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  discriminant_b = toward_b ^ 2 - ((0 - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 - ball_radius ^ 2) * ((-eye) * (-eye) + x * x + y * y)).

Definition lagrange_identity__of_shadow_2__false : Prop :=
  ~ (
  forall body_radius center_x center_y center_z light_x light_y light_z point_x point_y point_z : R,
  let segment_x := light_x - point_x in
  let segment_y := light_y - point_y in
  let segment_z := light_z - point_z in
  let offset_x := center_x - point_x in
  let offset_y := center_y - point_y in
  let offset_z := center_z - point_z in
  let segment_squared := segment_x ^ 2 + segment_y ^ 2 + segment_z ^ 2 in
  let toward_center := offset_x * segment_x + offset_y * segment_y + offset_z * segment_z in
  let shadow_discriminant := body_radius ^ 2 * segment_squared - (offset_y * segment_x - offset_x * segment_y) ^ 2 - (offset_x * segment_z - offset_z * segment_x) ^ 2 - (offset_z * segment_y - offset_y * segment_z) ^ 2 in
  shadow_discriminant = toward_center ^ 2 - segment_squared * (body_radius ^ 2 + offset_z * offset_z + offset_x * offset_x + offset_y * offset_y)).

Definition shadow_out_of_reach__cone_1__false : Prop :=
  ~ (
  forall aside_x aside_y aside_z axis_x axis_y axis_z body_radius distance product reach wander : R,
  body_radius > 0 ->
  wander >= 0 ->
  reach >= wander ->
  distance > body_radius ->
  distance ^ 2 = axis_z * axis_z + axis_x * axis_x + axis_y * axis_y ->
  wander ^ 2 = aside_z * aside_z + aside_x * aside_x + aside_y * aside_y ->
  product = aside_z * axis_z + aside_x * axis_x + aside_y * axis_y ->
  distance ^ 2 * wander ^ 2 - product ^ 2 = (aside_y * axis_x - aside_x * axis_y) * (aside_y * axis_x - aside_x * axis_y) + (aside_x * axis_z - aside_z * axis_x) * (aside_x * axis_z - aside_z * axis_x) + (aside_z * axis_y - aside_y * axis_z) * (aside_z * axis_y - aside_y * axis_z) /\
  distance ^ 2 * wander ^ 2 - product ^ 2 >= 0 /\
  distance * wander >= 0 /\
  distance * wander + product >= 0 /\
  (aside_z + axis_z) * (aside_z + axis_z) + (aside_x + axis_x) * (aside_x + axis_x) + (aside_y + axis_y) * (aside_y + axis_y) = (distance - wander) ^ 2 + 2 * (distance * wander + product) /\
  distance - wander > body_radius /\
  (distance - wander) ^ 2 > body_radius ^ 2 /\
  (aside_z + axis_z) * (aside_z + axis_z) + (aside_x + axis_x) * (aside_x + axis_x) + (aside_y + axis_y) * (aside_y + axis_y) > body_radius ^ 2).

Definition shadow_out_of_reach__turns_between_2__false : Prop :=
  ~ (
  forall at_ bend low share slope : R,
  bend > 0 ->
  at_ * bend + slope = 0 ->
  low + share * (bend * share + 2 * slope) >= low).

Definition shadow_out_of_reach__quadratic_3__false : Prop :=
  ~ (
  forall ball_center_x ball_center_y ball_center_z ball_radius body_radius center_x center_y center_z light_x light_y light_z share : R,
  let from_body_x := light_x - center_x in
  let from_body_y := light_y - center_y in
  let from_body_z := light_z - center_z in
  let along_x := ball_center_x - light_x in
  let along_y := ball_center_y - light_y in
  let along_z := ball_center_z - light_z in
  let at_light := from_body_x ^ 2 - body_radius ^ 2 + from_body_y ^ 2 + from_body_z ^ 2 in
  let half_slope := along_x * from_body_x + along_y * from_body_y + along_z * from_body_z - ball_radius * body_radius in
  let curvature := along_x ^ 2 + along_y ^ 2 + along_z ^ 2 - ball_radius ^ 2 in
  (along_z * share + from_body_z) * (along_z * share + from_body_z) + (along_x * share + from_body_x) * (along_x * share + from_body_x) + (along_y * share + from_body_y) * (along_y * share + from_body_y) - (ball_radius + body_radius) ^ 2 = at_light + share * (curvature * share + 2 * half_slope)).

Definition pole__sine_1__false : Prop :=
  ~ (
  forall k_u k_v theta : R,
  let cos_u := cos (PI * (k_u * (theta + PI) / (2 * PI))) in
  let cos_v := cos (PI * (0 * k_v)) in
  let sin_u := sin (PI * (k_u * (theta + PI) / (2 * PI))) in
  let sin_v := sin (PI * (0 * k_v)) in
  let h_u := PI * cos_u * k_u * sin_v in
  let h_v := PI * cos_v * k_v * sin_u in
  let e_theta_x := -(sin theta) in
  let e_theta_y := cos theta in
  let e_theta_z := 0 in
  let e_phi_x := 1 * (cos theta) in
  let e_phi_y := 1 * (sin theta) in
  let e_phi_z := -0 in
  let g_x := e_phi_x * h_v + e_theta_x * h_u in
  let g_y := e_phi_y * h_v + e_theta_y * h_u in
  let g_z := e_phi_z * h_v + e_theta_z * h_u in
  PI * k_u * (cos (PI * (k_u * (0 + PI) / (2 * PI)))) * (sin (PI * (0 * k_v))) * (-(sin 0)) + PI * k_v * (cos (PI * (0 * k_v))) * (sin (PI * (k_u * (0 + PI) / (2 * PI)))) * 1 * (cos 0) = g_x /\
  PI * k_u * (cos (PI * (k_u * (0 + PI) / (2 * PI)))) * (sin (PI * (0 * k_v))) * (cos 0) + PI * k_v * (cos (PI * (0 * k_v))) * (sin (PI * (k_u * (0 + PI) / (2 * PI)))) * 1 * (sin 0) = g_y /\
  0 * PI * k_u * (cos (PI * (k_u * (0 + PI) / (2 * PI)))) * (sin (PI * (0 * k_v))) + (-0) * PI * k_v * (cos (PI * (0 * k_v))) * (sin (PI * (k_u * (0 + PI) / (2 * PI)))) = g_z).

Definition pole__rings_2__false : Prop :=
  ~ (
  forall k_v theta : R,
  let cos_v := cos (PI * (2 * 0)) in
  let h_u := 0 in
  let h_v := 2 * PI * cos_v * k_v in
  let e_theta_x := -(sin theta) in
  let e_theta_y := cos theta in
  let e_theta_z := 0 in
  let e_phi_x := 1 * (cos theta) in
  let e_phi_y := 1 * (sin theta) in
  let e_phi_z := -0 in
  let g_x := e_phi_x * h_v + e_theta_x * h_u in
  let g_y := e_phi_y * h_v + e_theta_y * h_u in
  let g_z := e_phi_z * h_v + e_theta_z * h_u in
  g_x - (2 * PI * k_v * (cos (PI * (2 * 0))) * 1 * (cos (theta + PI)) + 0 * (-(sin (theta + PI)))) = 0 /\
  g_y - (2 * PI * k_v * (cos (PI * (2 * 0))) * 1 * (sin (theta + PI)) + 0 * (cos (theta + PI))) = 0 /\
  g_z - ((-0) * 2 * PI * k_v * (cos (PI * (2 * 0))) + 0 * 0) = 0).

Definition pole__surface_gradient_3__false : Prop :=
  ~ (
  forall k_u theta : R,
  let surface_x := k_u / 2 * (cos (k_u * (theta + PI) / 2)) * (-(sin theta)) + (sin (k_u * (theta + PI) / 2)) * (cos theta) in
  let surface_y := k_u / 2 * (cos (k_u * (theta + PI) / 2)) * (cos theta) + (sin theta) * (sin (k_u * (theta + PI) / 2)) in
  k_u / 2 * (cos (k_u * (0 + PI) / 2)) * (-(sin 0)) + (sin (k_u * (0 + PI) / 2)) * (cos 0) = surface_x /\
  k_u / 2 * (cos (k_u * (0 + PI) / 2)) * (cos 0) + (sin 0) * (sin (k_u * (0 + PI) / 2)) = surface_y).

Definition pole__polynomial_4__false : Prop :=
  ~ (
  forall phi theta : R,
  forall chebyshev following : nat -> R,
  chebyshev 0%nat = 0 ->
  (forall n : nat, chebyshev (S n) = following n) ->
  following 0%nat = 1 ->
  (forall n : nat, following (S n) = (following n) * 2 * (cos phi) - (chebyshev n)) ->
  forall n : nat,
  (sin (PI * ((INR n) * phi / PI))) * (sin (PI * (2 * (theta + PI) / (2 * PI)))) = (chebyshev n) * (sin phi) * (sin theta)).

Definition sine_is_smooth_everywhere__one_limit_1__true : Prop :=
  forall k_u k_v theta : R,
  k_v = 0 ->
  k_v * (sin theta) * (sin (k_u * (theta + PI) / 2)) = k_v * (sin (-PI)) * (sin (k_u * (PI - PI) / 2)).

Definition seed_pole_rows__raster_below_far_2__true : Prop :=
  forall m n : R,
  (m - 128) * (m - 127) >= 0 ->
  n >= 109 ->
  ((5 / 4) * 4 * 1 / (sqrt (1 + 4) * sqrt (4 - 1)) * ((-2 * n - 1 + 256) / 256 + (-3 / 20))) ^ 2 + ((5 / 4) * 4 * 1 / (sqrt (1 + 4) * sqrt (4 - 1)) * (2 * m - 256 + 1) / 256) ^ 2 + 0 > ((1 / 10000) * (4 / 3)) ^ 2.

Definition seed_pole_rows__only_near_3__true : Prop :=
  forall rho sin_phi : R,
  4 * sin_phi >= 3 * rho ->
  rho >= 0 ->
  sin_phi < (1 / 10000) ->
  ((1 / 10000) * (4 / 3)) ^ 2 > rho ^ 2.

Definition ridges_at_crossings__flat_1__false : Prop :=
  ~ (
  forall a b distance h small_enough steepest : R,
  h >= 0 ->
  (a ^ 2 + b ^ 2) ^ 2 >= 4 * h ^ 2 ->
  distance * steepest >= a ^ 2 + b ^ 2 ->
  distance >= 0 ->
  4 * small_enough ^ 2 >= distance * steepest ^ 2 ->
  a ^ 2 + b ^ 2 >= 4 * h).

Definition ridges_at_crossings__crossing_2__false : Prop :=
  ~ (
  forall k_u k_v m n to_u to_v : R,
  k_u > 0 ->
  k_v > 0 ->
  sin (PI * m) = 0 ->
  k_u <> 0 ->
  k_v <> 0 ->
  (Rabs ((sin (PI * (k_u * (to_u + m / k_u)))) * (sin (PI * (k_v * (to_v + n / k_v)))))) ^ 2 = ((sin (to_u * PI * k_u)) * (sin (to_v * PI * k_v))) ^ 2 /\
  ((sin (to_u * PI * k_u)) ^ 2 + (sin (to_v * PI * k_v)) ^ 2) ^ 2 >= 4 * (Rabs ((sin (PI * (k_u * (to_u + m / k_u)))) * (sin (PI * (k_v * (to_v + n / k_v)))))) ^ 2 /\
  (to_u * PI * k_u) ^ 2 + (to_v * PI * k_v) ^ 2 >= (sin (to_u * PI * k_u)) ^ 2 + (sin (to_v * PI * k_v)) ^ 2).

Definition ridges_at_crossings__crossing_3__false : Prop :=
  ~ (
  forall k_u k_v m n to_u to_v : R,
  k_u > 0 ->
  k_v > 0 ->
  sin (PI * m) = 0 ->
  sin (PI * n) = 0 ->
  k_u <> 0 ->
  k_v <> 0 ->
  (Rabs ((sin (PI * (k_u * (to_u + m / k_u)))) * (sin (PI * (k_v * (to_v + n / k_v)))))) ^ 2 = (sin (to_u * PI * k_u) + sin (to_v * PI * k_v)) ^ 2).

Definition ridges_differentiable__one_slope_1__true : Prop :=
  forall k_u k_v u v : R,
  sin (u * PI * k_u) = 0 ->
  sin (v * PI * k_v) = 0 ->
  Rabs (k_u * (cos (PI * (k_u * u))) * (sin (PI * (k_v * v)))) = -(Rabs (k_u * (cos (PI * (k_u * u))) * (sin (PI * (k_v * v))))).

Definition ridges_differentiable__one_slope_2__true : Prop :=
  forall k_u k_v u v : R,
  sin (u * PI * k_u) = 0 ->
  k_u = 0 ->
  Rabs (k_u * (cos (PI * (k_u * u))) * (sin (PI * (k_v * v)))) = -(Rabs (k_u * (cos (PI * (k_u * u))) * (sin (PI * (k_v * v))))).

Definition best_step__least_1__false : Prop :=
  ~ (
  forall best epsilon rounding truncation : R,
  truncation > 0 ->
  best > 0 ->
  epsilon > 0 ->
  rounding = best ^ 3 * truncation ->
  epsilon <> 0 ->
  best <> 0 ->
  best * truncation > 0 /\
  best ^ 2 > 0 /\
  rounding > 0 /\
  truncation * (2 * best + epsilon) >= 0 /\
  epsilon * (epsilon ^ 2 * truncation - 3 * best ^ 2 * truncation) + rounding >= 0 /\
  epsilon ^ 2 * truncation + rounding / epsilon >= 3 * best ^ 2 * truncation /\
  best ^ 2 * truncation + rounding / best = 3 * best ^ 2 * truncation /\
  (3 * best ^ 2 * truncation) ^ 3 = rounding ^ 2 * (27 / 4) * truncation).

Definition best_step__least_2__false : Prop :=
  ~ (
  forall best epsilon rounding truncation : R,
  truncation > 0 ->
  best > 0 ->
  epsilon > 0 ->
  rounding = 2 * best ^ 3 * truncation ->
  epsilon <> 0 ->
  epsilon ^ 2 * truncation + rounding / epsilon >= best ^ 2 * 4 * truncation).

Definition periodic_u_saves_the_seam__slope_1__true : Prop :=
  forall k_u k_v v : R,
  cos (PI * k_u) = 1 ->
  k_u * (cos (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - k_u * (cos (PI * (1 * k_u))) * (sin (PI * (k_v * v))) = 0.

Definition periodic_u_saves_the_seam__height_2__true : Prop :=
  forall k_u k_v v : R,
  sin (PI * k_u) = 0 ->
  (sin (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - (sin (PI * (1 * k_u))) * (sin (PI * (k_v * v))) = 0.

Definition mean_keeps_the_bound__one_more_1__false : Prop :=
  ~ (
  forall bound mean sample share : R,
  share >= 0 ->
  share <= 1 ->
  bound - mean >= 0 ->
  bound + mean >= 0 ->
  bound - sample >= 0 ->
  bound + sample >= 0 ->
  bound >= 2 * (mean + share * (sample - mean))).

Definition mean_keeps_the_bound__one_more_2__false : Prop :=
  ~ (
  forall bound mean sample share : R,
  share >= 0 ->
  share <= 2 ->
  bound - mean >= 0 ->
  bound + mean >= 0 ->
  bound - sample >= 0 ->
  bound + sample >= 0 ->
  bound - (mean + share * (sample - mean)) >= 0 /\
  bound + mean + share * (sample - mean) >= 0).

Definition mean_keeps_the_bound__one_more_3__false : Prop :=
  ~ (
  forall bound mean sample share : R,
  share >= 0 ->
  share <= 1 ->
  bound - mean >= 0 ->
  bound + mean >= 0 ->
  bound - (mean + share * (sample - mean)) >= 0 /\
  bound + mean + share * (sample - mean) >= 0).

Definition third_derivative_at_eight__at_eight_1__false : Prop :=
  ~ (
  2100 > (8 * PI) ^ 3).

Definition third_derivative_at_eight__at_four_2__false : Prop :=
  ~ (
  (4 * PI) ^ 3 > 2000).

Definition clamped_difference_of_odd__second_order_1__false : Prop :=
  ~ (
  forall bend_minus bend_plus epsilon largest slope v : R,
  let v_plus := Rmin 1 (epsilon + v) in
  let v_minus := Rmax (v - epsilon) 0 in
  let span_v := (if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus) in
  let h_v_plus := bend_plus * (epsilon + v) ^ 3 / 24 + (epsilon + v) * (bend_minus * ((epsilon + v) ^ 2 / 8 - (1 / 2) * v ^ 2) + slope) in
  let h_v_minus := 0 in
  let h_v := (h_v_plus - h_v_minus) / span_v in
  epsilon > 0 ->
  v >= 0 ->
  v - epsilon < 0 ->
  epsilon + v <= 1 ->
  bend_plus <= largest ->
  bend_plus >= -largest ->
  bend_minus <= largest ->
  bend_minus >= -largest ->
  span_v <> 0 ->
  epsilon ^ 2 * largest / 6 - (h_v - slope) >= 0 /\
  epsilon ^ 2 * largest / 6 + h_v - slope >= 0).

Definition clamped_difference_of_odd__second_order_2__false : Prop :=
  ~ (
  forall bend_minus bend_plus epsilon here largest slope v : R,
  let v_plus := Rmin 1 (epsilon + v) in
  let v_minus := Rmax (v - epsilon) 0 in
  let span_v := (if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus) in
  let h_v_plus := bend_plus * (epsilon + v) ^ 3 / 24 + (epsilon + v) * (bend_minus * ((epsilon + v) ^ 2 / 8 - (1 / 2) * v ^ 2) + slope) in
  let h_v_minus := here in
  let h_v := (h_v_plus - h_v_minus) / span_v in
  epsilon > 0 ->
  v >= 0 ->
  v - epsilon < 0 ->
  epsilon + v <= 1 ->
  bend_plus <= largest ->
  bend_plus >= -largest ->
  bend_minus <= largest ->
  bend_minus >= -largest ->
  span_v <> 0 ->
  h_v - slope = bend_minus * ((epsilon + v) ^ 2 / 8 - (1 / 2) * v ^ 2) + bend_plus * (epsilon + v) ^ 2 / 24 /\
  (epsilon + v) ^ 2 / 8 - (1 / 2) * v ^ 2 >= 0 /\
  (1 * bend_minus + largest) * ((epsilon + v) ^ 2 / 8 - (1 / 2) * v ^ 2) >= 0 /\
  (largest - bend_minus) * ((epsilon + v) ^ 2 / 8 - (1 / 2) * v ^ 2) >= 0 /\
  largest * 1 * ((1 / 6) * epsilon ^ 2 + (1 / 3) * epsilon * v - (1 / 3) * v ^ 2) - (h_v - slope) >= 0 /\
  largest * 1 * ((1 / 6) * epsilon ^ 2 + (1 / 3) * epsilon * v - (1 / 3) * v ^ 2) + h_v - slope >= 0).

Definition clamped_difference_of_odd__odd_3__false : Prop :=
  ~ (
  forall v : R,
  1 - (-v) ^ 2 = v ^ 2 - 1).

Definition clamped_difference_of_odd__second_order_sharp_4__false : Prop :=
  ~ (
  forall epsilon v : R,
  epsilon > 0 ->
  v >= 0 ->
  v - epsilon < 0 ->
  epsilon + v <= 1 ->
  epsilon + v - 0 <> 0 ->
  ((1 / 6) * (epsilon + v) ^ 3 - (1 / 6) * 0 ^ 3) / (epsilon + v - 0) - (1 / 2) * v ^ 2 = epsilon ^ 2 / 6).

Definition displaced_normal__product_1__false : Prop :=
  ~ (
  forall beta h h_phi h_theta phi phi_0 theta theta_0 : R,
  theta = theta_0 ->
  phi = phi_0 ->
  sin phi > 0 ->
  ex_derive (fun theta : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta ->
  ex_derive (fun phi : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) phi ->
  ex_derive (fun theta : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) theta ->
  ex_derive (fun phi : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) phi ->
  sin phi <> 0 ->
  ex_derive (fun phi : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) phi ->
  ex_derive (fun theta : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta ->
  (Derive (fun theta : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta) * (Derive (fun phi : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) phi) - (Derive (fun phi : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) phi) * (Derive (fun theta : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) theta) = (beta * h + 1) * (sin phi) * ((sin phi) * (cos theta) * (beta * h + 1) - beta * (h_phi * (cos phi) * (cos theta) + h_theta * (-(sin theta)) / (sin phi))) /\
  (Derive (fun phi : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) phi) * (Derive (fun theta : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) theta) - (Derive (fun theta : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta) * (Derive (fun phi : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) phi) = (beta * h + 1) * (sin phi) * ((sin phi) * (sin theta) * (beta * h + 1) - beta * (h_phi * (sin theta) * (cos phi) + h_theta * (cos theta) / (sin phi))) /\
  (Derive (fun phi : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) phi) * (Derive (fun theta : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta) - (Derive (fun theta : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta) * (Derive (fun phi : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) phi) = (beta * h + 1) * (sin phi) * ((beta * h + 1) * (cos phi) - beta * (h_phi * (-(sin phi)) + 0 * h_theta / (sin phi)))).

Definition displaced_normal__product_2__false : Prop :=
  ~ (
  forall beta h h_phi h_theta phi phi_0 theta theta_0 : R,
  theta = theta_0 ->
  phi = phi_0 ->
  sin phi > 0 ->
  ex_derive (fun phi : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) phi ->
  ex_derive (fun theta : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) theta ->
  ex_derive (fun phi : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) phi ->
  ex_derive (fun theta : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta ->
  sin phi <> 0 ->
  ex_derive (fun theta : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta ->
  ex_derive (fun phi : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) phi ->
  (Derive (fun phi : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) phi) * (Derive (fun theta : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) theta) - (Derive (fun theta : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta) * (Derive (fun phi : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) phi) = (beta * h + 1) * (sin phi) * ((sin phi) * (cos theta) * (beta * h + 1) - beta * (h_phi * (cos phi) * (cos theta) + h_theta * (-(sin theta)) / (sin phi))) / (sin phi) /\
  (Derive (fun theta : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta) * (Derive (fun phi : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) phi) - (Derive (fun phi : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) phi) * (Derive (fun theta : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) theta) = (beta * h + 1) * (sin phi) * ((sin phi) * (sin theta) * (beta * h + 1) - beta * (h_phi * (sin theta) * (cos phi) + h_theta * (cos theta) / (sin phi))) / (sin phi) /\
  (Derive (fun theta : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta) * (Derive (fun phi : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) phi) - (Derive (fun phi : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) phi) * (Derive (fun theta : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta) = (beta * h + 1) * (sin phi) * ((beta * h + 1) * (cos phi) - beta * (h_phi * (-(sin phi)) + 0 * h_theta / (sin phi))) / (sin phi)).

Definition displaced_normal__first_order_3__false : Prop :=
  ~ (
  forall beta cos_phi cos_theta h h_u h_v sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  let e_theta_x := -sin_theta in
  let e_theta_y := cos_theta in
  let e_theta_z := 0 in
  let e_phi_x := cos_phi * cos_theta in
  let e_phi_y := cos_phi * sin_theta in
  let e_phi_z := -sin_phi in
  let h_theta := (1 / 2) * h_u / PI in
  let h_phi := h_v / PI in
  let lift := beta * h + 1 in
  let displaced_x := lift * normal_x - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi) in
  let displaced_y := lift * normal_y - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi) in
  let displaced_z := lift * normal_z - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi) in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi > 0 ->
  sin_phi <> 0 ->
  displaced_y * (1 * normal_z - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi)) - displaced_z * (1 * normal_y - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi)) = 0 /\
  displaced_z * (1 * normal_x - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi)) - displaced_x * (1 * normal_z - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi)) = 0 /\
  displaced_x * (1 * normal_y - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi)) - displaced_y * (1 * normal_x - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi)) = 0).

Definition displaced_normal__chart_scale_4__false : Prop :=
  ~ (
  forall h_v : R,
  let h_phi := h_v / PI in
  2 * PI * h_phi = h_v).

Definition unit_length__length_1__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  m_z * m_z + m_x * m_x + m_y * m_y = 1 - beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y)).

Definition unit_length__length_2__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  m_z * m_z + m_x * m_x + m_y * m_y = beta * (g_z * g_z + g_x * g_x + g_y * g_y) + 1).

Definition unit_length__length_3__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length > 1).

Definition unit_length__length_4__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length <> 0 ->
  m_z * m_z + m_x * m_x + m_y * m_y = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) + 1 /\
  m_z * m_z + m_x * m_x + m_y * m_y >= 1 /\
  m_length >= 1 /\
  m_length ^ 2 = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) + 1 /\
  bumped_z * bumped_z + bumped_x * bumped_x + bumped_y * bumped_y = 1).

Definition stable_frame__angles_1__false : Prop :=
  ~ (
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  let hit_scale := 1 / (radius * (eye ^ 2 + root_a)) in
  let cos_phi := eye * hit_scale * (radius ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye ->
  discriminant_a >= 0 ->
  x ^ 2 + y ^ 2 >= 0 ->
  tangent_squared >= 0 ->
  tangent_squared <> 0 ->
  Rmax 0 discriminant_a >= 0 ->
  eye ^ 2 + root_a <> 0 ->
  radius <> 0 ->
  cos_phi * radius = eye * t_a).

Definition stable_frame__angles_2__false : Prop :=
  ~ (
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let hit_scale := 1 / (radius * (eye ^ 2 + root_a)) in
  let sin_phi := hit_scale * rho * tangent_squared in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye ->
  discriminant_a >= 0 ->
  x ^ 2 + y ^ 2 >= 0 ->
  tangent_squared >= 0 ->
  tangent_squared <> 0 ->
  Rmax 0 discriminant_a >= 0 ->
  radius <> 0 ->
  eye ^ 2 + root_a <> 0 ->
  radius * sin_phi = rho).

Definition stable_frame__angles_3__false : Prop :=
  ~ (
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  let rho_inverse := (if Rlt_dec 0 rho then / rho else 0) in
  let hit_scale := 1 / (radius * (eye ^ 2 + root_a)) in
  let cos_theta := rho_inverse * x in
  let sin_phi := hit_scale * rho * tangent_squared in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye ->
  discriminant_a >= 0 ->
  x ^ 2 + y ^ 2 >= 0 ->
  tangent_squared >= 0 ->
  tangent_squared <> 0 ->
  Rmax 0 discriminant_a >= 0 ->
  eye ^ 2 + root_a <> 0 ->
  (rho > 0 -> rho <> 0) ->
  radius <> 0 ->
  cos_theta * radius * sin_phi = t_a * y).

Definition stable_frame__seed_frame_4__false : Prop :=
  ~ (
  forall cos_phi cos_theta sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  let e_theta_x := -sin_theta in
  let e_theta_y := cos_theta in
  let e_phi_x := cos_phi * cos_theta in
  let e_phi_y := cos_phi * sin_theta in
  let e_phi_z := -sin_phi in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  1 - normal_z ^ 2 >= 0 ->
  sqrt (1 - normal_z ^ 2) <> 0 ->
  sqrt (1 - normal_z ^ 2) = sin_phi /\
  -normal_y / sqrt (1 - normal_z ^ 2) = e_theta_x /\
  normal_x / sqrt (1 - normal_z ^ 2) = e_theta_y /\
  normal_x * normal_z / sqrt (1 - normal_z ^ 2) = e_phi_x /\
  normal_y * normal_z / sqrt (1 - normal_z ^ 2) = e_phi_y /\
  -sqrt (1 - normal_z ^ 2) = e_phi_z).

Definition silhouette_of_a__only_inside_1__false : Prop :=
  ~ (
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye ->
  discriminant_a >= 0 ->
  x ^ 2 + y ^ 2 >= 0 ->
  tangent_squared >= 0 ->
  tangent_squared <> 0 ->
  eye ^ 2 * radius ^ 2 >= rho ^ 2 * (eye ^ 2 + radius ^ 2)).

Definition silhouette_of_a__in_front_2__false : Prop :=
  ~ (
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye ->
  discriminant_a >= 0 ->
  x ^ 2 + y ^ 2 >= 0 ->
  tangent_squared >= 0 ->
  tangent_squared <> 0 ->
  Rmax 0 discriminant_a >= 0 ->
  eye ^ 2 + root_a <> 0 ->
  (1 / 2) > t_a).

Definition silhouette_of_a__tangent_3__false : Prop :=
  ~ (
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye ->
  (eye ^ 2 - radius ^ 2) * (x ^ 2 + y ^ 2) = eye ^ 2 * radius ^ 2 ->
  x ^ 2 + y ^ 2 >= 0 ->
  eye ^ 2 <> 0 ->
  eye * (1 - (1 - radius ^ 2 / (eye ^ 2))) = 0).

Definition seed_covers_the_view__covers_1__false : Prop :=
  ~ (
  forall x y : R,
  x >= -2 ->
  x <= 2 ->
  y >= -2 ->
  y <= 2 ->
  ((1 / 2) * x + (1 / 2) * y + 4 * (4 - (13 / 10))) ^ 2 - (0 + (0 - (1 / 2)) ^ 2 + (0 - (1 / 2)) ^ 2 + (4 - (13 / 10)) ^ 2 - ((8 / 25)) ^ 2) * (x * x + y * y + (-4) * (-4)) > 0).

Definition seed_covers_the_view__before_2__false : Prop :=
  ~ (
  forall b d : R,
  b > (1 / 4) * 35 ->
  d > 0 ->
  d >= 0 ->
  b + sqrt d <> 0 ->
  (0 + ((1 / 2)) ^ 2 + ((1 / 2)) ^ 2 + ((13 / 10)) ^ 2 - ((8 / 25)) ^ 2) / (b + sqrt d) > (1 / 4)).

Definition seed_covers_the_view__behind_3__false : Prop :=
  ~ (
  forall eye radius t x y : R,
  radius > 0 ->
  eye * (1 - t) * eye * (1 - t) + t * x * t * x + t * y * t * y = radius ^ 2 ->
  t >= 1).

Definition seam__even_1__false : Prop :=
  ~ (
  forall k_u k_v u v : R,
  cos (PI * k_u) = -1 ->
  (sin (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - (sin (PI * (1 * k_u))) * (sin (PI * (k_v * v))) = 0 /\
  PI * k_u * (cos (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - PI * k_u * (cos (PI * (1 * k_u))) * (sin (PI * (k_v * v))) = 0 /\
  PI * k_v * (cos (PI * (k_v * v))) * (sin (PI * (0 * k_u))) - PI * k_v * (cos (PI * (k_v * v))) * (sin (PI * (1 * k_u))) = 0 /\
  (sin (PI * (k_u * (u + 1)))) * (sin (PI * (k_v * v))) = (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))).

Definition seam__sine_2__false : Prop :=
  ~ (
  forall k_u k_v v : R,
  let h_jump := (sin (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - (sin (PI * (1 * k_u))) * (sin (PI * (k_v * v))) in
  h_jump = 0).

Definition seam__ridges_3__false : Prop :=
  ~ (
  forall k_u k_v v : R,
  let h_first := Rabs ((sin (PI * (0 * k_u))) * (sin (PI * (k_v * v)))) in
  let h_last := Rabs ((sin (PI * (1 * k_u))) * (sin (PI * (k_v * v)))) in
  h_first = 0 /\
  h_last = 0).

Definition seam__even_4__false : Prop :=
  ~ (
  forall k_u k_v u v : R,
  sin (PI * k_u) = 0 ->
  (sin (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - (sin (PI * (1 * k_u))) * (sin (PI * (k_v * v))) = 0 /\
  PI * k_u * (cos (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - PI * k_u * (cos (PI * (1 * k_u))) * (sin (PI * (k_v * v))) = 0 /\
  PI * k_v * (cos (PI * (k_v * v))) * (sin (PI * (0 * k_u))) - PI * k_v * (cos (PI * (k_v * v))) * (sin (PI * (1 * k_u))) = 0 /\
  (sin (PI * (k_u * (u + 1)))) * (sin (PI * (k_v * v))) = (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))).

Definition occlusion_by_signs__if_1__false : Prop :=
  ~ (
  forall a b c d : R,
  a >= 0 ->
  c > 0 ->
  d = b ^ 2 - a * c ->
  d >= 0 ->
  b > 0 ->
  d >= 0 ->
  a <> 0 ->
  a > 0 /\
  (b - sqrt d) * (b + sqrt d) = a * c /\
  b + sqrt d > 0 /\
  b - sqrt d > 0 /\
  (a - b - sqrt d) * (sqrt d + a - b) = a * (c + a - 2 * b) /\
  sqrt d + a - b > 0 /\
  / a > 0 /\
  (b - sqrt d) / a > 0 /\
  1 > (b - sqrt d) / a /\
  c + a * ((b - sqrt d) / a) ^ 2 - 2 * b * (b - sqrt d) / a = 0).

Definition occlusion_by_signs__if_2__false : Prop :=
  ~ (
  forall a b c d : R,
  a >= 0 ->
  c > 0 ->
  d = b ^ 2 - a * c ->
  d >= 0 ->
  a > 0 ->
  b < a ->
  d >= 0 ->
  a <> 0 ->
  a > 0 /\
  (b - sqrt d) * (b + sqrt d) = a * c /\
  b + sqrt d > 0 /\
  b - sqrt d > 0 /\
  (a - b - sqrt d) * (sqrt d + a - b) = a * (c + a - 2 * b) /\
  sqrt d + a - b > 0 /\
  / a > 0 /\
  (b - sqrt d) / a > 0 /\
  1 > (b - sqrt d) / a /\
  c + a * ((b - sqrt d) / a) ^ 2 - 2 * b * (b - sqrt d) / a = 0).

Definition occlusion_by_signs__only_if_3__false : Prop :=
  ~ (
  forall a b c d s : R,
  a >= 0 ->
  c > 0 ->
  d = b ^ 2 - a * c ->
  c + a - 2 * b > 0 ->
  s > 0 ->
  s < 1 ->
  c + a * s ^ 2 - 2 * b * s = 0 ->
  d > 0).

Definition silhouette_of_b__conic_1__false : Prop :=
  ~ (
  forall ball_center_x ball_center_y ball_center_z ball_radius eye : R,
  (ball_center_x ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) * (ball_center_y ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) - (ball_center_x * ball_center_y) ^ 2 = (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2) * (ball_radius ^ 2 + (eye - ball_center_z) ^ 2)).

Definition silhouette_of_b__hyperbola_2__false : Prop :=
  ~ (
  forall ball_center_x ball_center_y ball_center_z ball_radius eye : R,
  (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 > ball_radius ^ 2 ->
  (eye - ball_center_z) ^ 2 < ball_radius ^ 2 ->
  (ball_center_x ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) * (ball_center_y ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) - (ball_center_x * ball_center_y) ^ 2 > 0).

Definition silhouette_of_b__branch_3__false : Prop :=
  ~ (
  forall ball_center_x ball_center_y ball_center_z ball_radius eye x y : R,
  let distance := eye - ball_center_z in
  let toward_b := ball_center_x * x + ball_center_y * y + distance * eye in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 - (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  eye > 0 ->
  (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 > ball_radius ^ 2 ->
  discriminant_b = 0 ->
  toward_b > 0).

Definition crease_error_area__in_v_1__false : Prop :=
  ~ (
  forall epsilon k_v : R,
  k_v >= 1 ->
  epsilon > 0 ->
  3 * epsilon ^ 2 <> 0 ->
  epsilon * k_v / 3 >= 0 ->
  (1 / 2) * 2 * (PI * k_v) ^ 2 * (k_v - 1) * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3) >= 0 ->
  PI * k_v > 0 /\
  epsilon * (k_v - 1) >= 0 /\
  (1 / 2) * 2 * (PI * k_v) ^ 2 * (k_v - 1) * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3) >= 0 /\
  sqrt (epsilon * k_v / 3) * PI * k_v >= 0 /\
  (1 / 2) * 2 * (PI * k_v) ^ 2 * (k_v - 1) * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3) = (sqrt (epsilon * k_v / 3) * PI * k_v) ^ 2 /\
  sqrt ((1 / 2) * 2 * (PI * k_v) ^ 2 * (k_v - 1) * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3)) >= sqrt (epsilon * k_v / 3) * PI * k_v /\
  sqrt (epsilon * k_v / 3) * PI * k_v >= sqrt ((1 / 2) * 2 * (PI * k_v) ^ 2 * (k_v - 1) * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3)) /\
  sqrt ((1 / 2) * 2 * (PI * k_v) ^ 2 * (k_v - 1) * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3)) = sqrt (epsilon * k_v / 3) * PI * k_v).

Definition crease_error_area__in_u_2__false : Prop :=
  ~ (
  forall epsilon k_u : R,
  k_u >= 1 ->
  epsilon > 0 ->
  3 * epsilon ^ 2 <> 0 ->
  k_u / 3 >= 0 ->
  (1 / 2) * 2 * k_u * (PI * k_u) ^ 2 * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3) >= 0 ->
  PI * k_u > 0 /\
  epsilon * k_u >= 0 /\
  (1 / 2) * 2 * k_u * (PI * k_u) ^ 2 * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3) >= 0 /\
  sqrt (k_u / 3) * epsilon * PI * k_u >= 0 /\
  (1 / 2) * 2 * k_u * (PI * k_u) ^ 2 * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3) = (sqrt (k_u / 3) * epsilon * PI * k_u) ^ 2 /\
  sqrt ((1 / 2) * 2 * k_u * (PI * k_u) ^ 2 * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3)) >= sqrt (k_u / 3) * epsilon * PI * k_u /\
  sqrt (k_u / 3) * epsilon * PI * k_u >= sqrt ((1 / 2) * 2 * k_u * (PI * k_u) ^ 2 * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3)) /\
  sqrt ((1 / 2) * 2 * k_u * (PI * k_u) ^ 2 * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3)) = sqrt (k_u / 3) * epsilon * PI * k_u).

Definition crease_error_area__mean_of_a_square_3__false : Prop :=
  ~ (
  forall k_v v : R,
  k_v > 0 ->
  4 * PI * k_v <> 0 ->
  ex_derive (fun v : R => v / 2 - (1 / 4) / (PI * k_v) * (sin (v * 2 * PI * k_v))) v ->
  (Derive (fun v : R => v / 2 - (1 / 4) / (PI * k_v) * (sin (v * 2 * PI * k_v))) v) = (sin (v * PI * k_v)) ^ 2 /\
  1 / 2 - (1 / 4) / (PI * k_v) * (sin (1 * 2 * PI * k_v)) - (0 / 2 - (1 / 4) / (PI * k_v) * (sin (0 * 2 * PI * k_v))) = (1 / 2)).

Definition crease_error_area__tent_4__false : Prop :=
  ~ (
  forall delta epsilon k_u : R,
  epsilon > 0 ->
  k_u > 0 ->
  delta > 0 ->
  epsilon - delta >= 0 ->
  1 - k_u * (delta + epsilon) >= 0 ->
  epsilon <> 0 ->
  PI * k_u <> 0 ->
  (epsilon * PI * k_u) ^ 2 / 6 >= cos (delta * PI * k_u) - 1 / (PI * k_u) * (sin (delta * PI * k_u)) * (cos (epsilon * PI * k_u)) / epsilon).

Definition bump_is_not_displacement__only_where_flat_1__false : Prop :=
  ~ (
  forall beta cos_phi cos_theta h h_u h_v sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  let e_theta_x := -sin_theta in
  let e_theta_y := cos_theta in
  let e_theta_z := 0 in
  let e_phi_x := cos_phi * cos_theta in
  let e_phi_y := cos_phi * sin_theta in
  let e_phi_z := -sin_phi in
  let h_theta := (1 / 2) * h_u / PI in
  let h_phi := h_v / PI in
  let lift := beta * h + 1 in
  let displaced_x := lift * normal_x - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi) in
  let displaced_y := lift * normal_y - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi) in
  let displaced_z := lift * normal_z - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi) in
  let g_x := e_phi_x * h_v + e_theta_x * h_u in
  let g_y := e_phi_y * h_v + e_theta_y * h_u in
  let g_z := e_phi_z * h_v + e_theta_z * h_u in
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi > 0 ->
  beta * h + 1 > 0 ->
  displaced_z * m_y - displaced_y * m_z = 0 ->
  displaced_x * m_z - displaced_z * m_x = 0 ->
  displaced_y * m_x - displaced_x * m_y = 0 ->
  sin_phi <> 0 ->
  h_u = 0).

Definition bump_is_not_displacement__angle_2__false : Prop :=
  ~ (
  forall beta cos_phi cos_theta h h_u h_v sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  let e_theta_x := -sin_theta in
  let e_theta_y := cos_theta in
  let e_theta_z := 0 in
  let e_phi_x := cos_phi * cos_theta in
  let e_phi_y := cos_phi * sin_theta in
  let e_phi_z := -sin_phi in
  let h_theta := (1 / 2) * h_u / PI in
  let h_phi := h_v / PI in
  let lift := beta * h + 1 in
  let displaced_x := lift * normal_x - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi) in
  let displaced_y := lift * normal_y - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi) in
  let displaced_z := lift * normal_z - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi) in
  let g_x := e_phi_x * h_v + e_theta_x * h_u in
  let g_y := e_phi_y * h_v + e_theta_y * h_u in
  let g_z := e_phi_z * h_v + e_theta_z * h_u in
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi > 0 ->
  sin_phi <> 0 ->
  2 * PI * sin_phi <> 0 ->
  displaced_z * m_z + displaced_x * m_x + displaced_y * m_y = beta ^ 2 * (h_u ^ 2 / (2 * PI * sin_phi) + h_v ^ 2 / PI) + 1).

Definition bump_is_not_displacement__angle_3__false : Prop :=
  ~ (
  forall beta cos_phi cos_theta h h_u h_v sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  let e_theta_x := -sin_theta in
  let e_theta_y := cos_theta in
  let e_theta_z := 0 in
  let e_phi_x := cos_phi * cos_theta in
  let e_phi_y := cos_phi * sin_theta in
  let e_phi_z := -sin_phi in
  let h_theta := (1 / 2) * h_u / PI in
  let h_phi := h_v / PI in
  let lift := beta * h + 1 in
  let displaced_x := lift * normal_x - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi) in
  let displaced_y := lift * normal_y - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi) in
  let displaced_z := lift * normal_z - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi) in
  let g_x := e_phi_x * h_v + e_theta_x * h_u in
  let g_y := e_phi_y * h_v + e_theta_y * h_u in
  let g_z := e_phi_z * h_v + e_theta_z * h_u in
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi > 0 ->
  sin_phi <> 0 ->
  displaced_z * m_z + displaced_x * m_x + displaced_y * m_y = lift - beta ^ 2 * (h_u ^ 2 / (2 * PI) + h_v ^ 2 / PI)).

Definition attached_shadow__in_light_1__true : Prop :=
  forall beta g_x g_y g_z normal_x normal_y normal_z towards_x towards_y towards_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  normal_z * towards_z + normal_x * towards_x + normal_y * towards_y > 0 ->
  towards_z * towards_z + towards_x * towards_x + towards_y * towards_y = 1 ->
  beta = 0 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 /\
  m_length <> 0 /\
  bumped_z * towards_z + bumped_x * towards_x + bumped_y * towards_y > 0.

Definition attached_shadow__in_light_2__true : Prop :=
  forall beta g_x g_y g_z normal_x normal_y normal_z towards_x towards_y towards_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  normal_z * towards_z + normal_x * towards_x + normal_y * towards_y > 0 ->
  towards_z * towards_z + towards_x * towards_x + towards_y * towards_y = 1 ->
  beta * (g_z * towards_z + g_x * towards_x + g_y * towards_y) >= 0 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 /\
  m_length <> 0 /\
  bumped_z * towards_z + bumped_x * towards_x + bumped_y * towards_y > 0.

Definition normal_by_beta__derivative_1__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  m_z * m_z + m_x * m_x + m_y * m_y > 0 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  (beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2 >= 0 ->
  sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2) <> 0 ->
  (beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2 > 0 ->
  ex_derive (fun beta : R => (beta * g_x + normal_x) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta ->
  m_length <> 0 ->
  ex_derive (fun beta : R => (beta * g_y + normal_y) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta ->
  ex_derive (fun beta : R => (beta * g_z + normal_z) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta ->
  (Derive (fun beta : R => (beta * g_x + normal_x) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta) = g_x / m_length /\
  (Derive (fun beta : R => (beta * g_y + normal_y) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta) = g_y / m_length /\
  (Derive (fun beta : R => (beta * g_z + normal_z) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta) = g_z / m_length).

Definition normal_by_beta__derivative_2__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  let bumped_by_beta_x := (g_x - bumped_x * (bumped_x * g_x + bumped_y * g_y + bumped_z * g_z)) / m_length in
  let bumped_by_beta_y := (g_y - bumped_y * (bumped_x * g_x + bumped_y * g_y + bumped_z * g_z)) / m_length in
  let bumped_by_beta_z := (g_z - bumped_z * (bumped_x * g_x + bumped_y * g_y + bumped_z * g_z)) / m_length in
  m_z * m_z + m_x * m_x + m_y * m_y > 0 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length <> 0 ->
  (beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2 >= 0 ->
  sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2) <> 0 ->
  (beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2 > 0 ->
  ex_derive (fun beta : R => (beta * g_x + normal_x) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta ->
  ex_derive (fun beta : R => (beta * g_y + normal_y) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta ->
  ex_derive (fun beta : R => (beta * g_z + normal_z) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta ->
  (Derive (fun beta : R => (beta * g_x + normal_x) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta) = bumped_by_beta_x * m_length /\
  (Derive (fun beta : R => (beta * g_y + normal_y) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta) = bumped_by_beta_y * m_length /\
  (Derive (fun beta : R => (beta * g_z + normal_z) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta) = bumped_by_beta_z * m_length).

Definition normal_by_beta__derivative_3__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  let bumped_by_beta_x := (g_x - bumped_x * (bumped_x * g_x + bumped_y * g_y + bumped_z * g_z)) / m_length in
  let bumped_by_beta_y := (g_y - bumped_y * (bumped_x * g_x + bumped_y * g_y + bumped_z * g_z)) / m_length in
  let bumped_by_beta_z := (g_z - bumped_z * (bumped_x * g_x + bumped_y * g_y + bumped_z * g_z)) / m_length in
  m_z * m_z + m_x * m_x + m_y * m_y > 0 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length <> 0 ->
  (beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2 >= 0 ->
  sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2) <> 0 ->
  (beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2 > 0 ->
  ex_derive (fun beta : R => (beta * g_x + normal_x) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta ->
  ex_derive (fun beta : R => (beta * g_y + normal_y) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta ->
  ex_derive (fun beta : R => (beta * g_z + normal_z) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta ->
  (Derive (fun beta : R => (beta * g_x + normal_x) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta) = -bumped_by_beta_x /\
  (Derive (fun beta : R => (beta * g_y + normal_y) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta) = -bumped_by_beta_y /\
  (Derive (fun beta : R => (beta * g_z + normal_z) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) beta) = -bumped_by_beta_z).

Definition angle_of_the_bump__angle_1__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length <> 0 ->
  (bumped_y * normal_x - bumped_x * normal_y) * (bumped_y * normal_x - bumped_x * normal_y) + (bumped_x * normal_z - bumped_z * normal_x) * (bumped_x * normal_z - bumped_z * normal_x) + (bumped_z * normal_y - bumped_y * normal_z) * (bumped_z * normal_y - bumped_y * normal_z) = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y)).

Definition angle_of_the_bump__angle_2__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length <> 0 ->
  (bumped_y * normal_x - bumped_x * normal_y) * (bumped_y * normal_x - bumped_x * normal_y) + (bumped_x * normal_z - bumped_z * normal_x) * (bumped_x * normal_z - bumped_z * normal_x) + (bumped_z * normal_y - bumped_y * normal_z) * (bumped_z * normal_y - bumped_y * normal_z) = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) ^ 2 * (bumped_z * normal_z + bumped_x * normal_x + bumped_y * normal_y) ^ 2).

Definition angle_of_the_bump__angle_3__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length <> 0 ->
  2 * (bumped_z * normal_z + bumped_x * normal_x + bumped_y * normal_y) ^ 2 <= 1).

Definition normal_limits__small_beta_1__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z w : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  w = sqrt (g_z * g_z + g_x * g_x + g_y * g_y) * (Rabs beta) ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length <> 0 ->
  g_z * g_z + g_x * g_x + g_y * g_y >= 0 ->
  (bumped_z - normal_z) * (bumped_z - normal_z) + (bumped_x - normal_x) * (bumped_x - normal_x) + (bumped_y - normal_y) * (bumped_y - normal_y) >= 0 ->
  w >= 2 * sqrt ((bumped_z - normal_z) * (bumped_z - normal_z) + (bumped_x - normal_x) * (bumped_x - normal_x) + (bumped_y - normal_y) * (bumped_y - normal_y))).

Definition normal_limits__large_negative_beta_2__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z w : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  -beta > 0 ->
  g_z * g_z + g_x * g_x + g_y * g_y > 0 ->
  w = sqrt (g_z * g_z + g_x * g_x + g_y * g_y) * (Rabs beta) ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length <> 0 ->
  g_z * g_z + g_x * g_x + g_y * g_y >= 0 ->
  bumped_z * g_z + bumped_x * g_x + bumped_y * g_y > 0).

Definition normal_limits__large_beta_3__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z w : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  1 * beta > 0 ->
  g_z * g_z + g_x * g_x + g_y * g_y > 0 ->
  w = sqrt (g_z * g_z + g_x * g_x + g_y * g_y) * (Rabs beta) ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length <> 0 ->
  g_z * g_z + g_x * g_x + g_y * g_y >= 0 ->
  sqrt (g_z * g_z + g_x * g_x + g_y * g_y) <> 0 ->
  1 >= 2 * w ^ 2 * (2 - 2 * (bumped_z * g_z + bumped_x * g_x + bumped_y * g_y) / sqrt (g_z * g_z + g_x * g_x + g_y * g_y))).

Definition shadow_line_moves_within__shadow_line_1__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z towards_x towards_y towards_z w : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  w = sqrt (g_z * g_z + g_x * g_x + g_y * g_y) * (Rabs beta) ->
  towards_z * towards_z + towards_x * towards_x + towards_y * towards_y = 1 ->
  normal_z * towards_z + normal_x * towards_x + normal_y * towards_y > w / 2 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length <> 0 ->
  g_z * g_z + g_x * g_x + g_y * g_y >= 0 ->
  w ^ 2 = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) /\
  w >= 0 /\
  g_z * g_z + g_x * g_x + g_y * g_y - (g_z * towards_z + g_x * towards_x + g_y * towards_y) ^ 2 >= 0 /\
  w ^ 2 - (beta * (g_z * towards_z + g_x * towards_x + g_y * towards_y)) ^ 2 >= 0 /\
  beta * (g_z * towards_z + g_x * towards_x + g_y * towards_y) + w >= 0 /\
  beta * (g_z * towards_z + g_x * towards_x + g_y * towards_y) + normal_z * towards_z + normal_x * towards_x + normal_y * towards_y > 0 /\
  m_length * (bumped_z * towards_z + bumped_x * towards_x + bumped_y * towards_y) = beta * (g_z * towards_z + g_x * towards_x + g_y * towards_y) + normal_z * towards_z + normal_x * towards_x + normal_y * towards_y /\
  bumped_z * towards_z + bumped_x * towards_x + bumped_y * towards_y > 0).

Definition shadow_line_moves_within__shadow_line_2__false : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z towards_x towards_y towards_z w : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  let m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2) in
  let m_scale := / m_length in
  let bumped_x := m_scale * m_x in
  let bumped_y := m_scale * m_y in
  let bumped_z := m_scale * m_z in
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  w = sqrt (g_z * g_z + g_x * g_x + g_y * g_y) * (Rabs beta) ->
  towards_z * towards_z + towards_x * towards_x + towards_y * towards_y = 1 ->
  normal_z * towards_z + normal_x * towards_x + normal_y * towards_y > w ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length <> 0 ->
  g_z * g_z + g_x * g_x + g_y * g_y >= 0 ->
  bumped_z * towards_z + bumped_x * towards_x + bumped_y * towards_y >= normal_z * towards_z + normal_x * towards_x + normal_y * towards_y).

Definition normalising_is_lipschitz__normalise_1__false : Prop :=
  ~ (
  forall a_x a_y a_z apart b_x b_y b_z length_a length_b product turned : R,
  length_a >= 1 ->
  length_b >= 1 ->
  apart >= 0 ->
  length_a ^ 2 = a_z * a_z + a_x * a_x + a_y * a_y ->
  length_b ^ 2 = b_z * b_z + b_x * b_x + b_y * b_y ->
  product = a_z * b_z + a_x * b_x + a_y * b_y ->
  apart ^ 2 = (a_z - b_z) * (a_z - b_z) + (a_x - b_x) * (a_x - b_x) + (a_y - b_y) * (a_y - b_y) ->
  turned ^ 2 = (a_z / length_a - b_z / length_b) * (a_z / length_a - b_z / length_b) + (a_x / length_a - b_x / length_b) * (a_x / length_a - b_x / length_b) + (a_y / length_a - b_y / length_b) * (a_y / length_a - b_y / length_b) ->
  length_a <> 0 ->
  length_b <> 0 ->
  apart >= 2 * turned).

Definition normalising_is_lipschitz__normalise_2__false : Prop :=
  ~ (
  forall a_x a_y a_z apart b_x b_y b_z length_a length_b product turned : R,
  length_a > 0 ->
  length_b > 0 ->
  apart >= 0 ->
  turned >= 0 ->
  length_a ^ 2 = a_z * a_z + a_x * a_x + a_y * a_y ->
  length_b ^ 2 = b_z * b_z + b_x * b_x + b_y * b_y ->
  product = a_z * b_z + a_x * b_x + a_y * b_y ->
  apart ^ 2 = (a_z - b_z) * (a_z - b_z) + (a_x - b_x) * (a_x - b_x) + (a_y - b_y) * (a_y - b_y) ->
  turned ^ 2 = (a_z / length_a - b_z / length_b) * (a_z / length_a - b_z / length_b) + (a_x / length_a - b_x / length_b) * (a_x / length_a - b_x / length_b) + (a_y / length_a - b_y / length_b) * (a_y / length_a - b_y / length_b) ->
  length_a <> 0 ->
  length_b <> 0 ->
  length_a ^ 2 * length_b ^ 2 - product ^ 2 = (a_x * b_y - a_y * b_x) * (a_x * b_y - a_y * b_x) + (a_z * b_x - a_x * b_z) * (a_z * b_x - a_x * b_z) + (a_y * b_z - a_z * b_y) * (a_y * b_z - a_z * b_y) /\
  length_a ^ 2 * length_b ^ 2 - product ^ 2 >= 0 /\
  length_a * length_b - 1 >= 0 /\
  length_a * length_b - product >= 0 /\
  length_a * length_b + product >= 0 /\
  turned ^ 2 * length_a * length_b = 2 * (length_a * length_b - product) /\
  apart ^ 2 = length_a ^ 2 + length_b ^ 2 - 2 * product /\
  length_a * length_b * (apart ^ 2 - turned ^ 2) >= 0 /\
  apart ^ 2 >= turned ^ 2 /\
  apart >= turned /\
  4 >= turned ^ 2 /\
  2 >= turned).

Definition normalising_is_lipschitz__normalise_3__false : Prop :=
  ~ (
  forall a_x a_y a_z apart b_x b_y b_z length_a length_b product turned : R,
  length_a >= 1 ->
  length_b >= 1 ->
  apart >= 0 ->
  length_a ^ 2 = a_z * a_z + a_x * a_x + a_y * a_y ->
  length_b ^ 2 = b_z * b_z + b_x * b_x + b_y * b_y ->
  product = a_z * b_z + a_x * b_x + a_y * b_y ->
  apart ^ 2 = (a_z - b_z) * (a_z - b_z) + (a_x - b_x) * (a_x - b_x) + (a_y - b_y) * (a_y - b_y) ->
  turned ^ 2 = (a_z / length_a - b_z / length_b) * (a_z / length_a - b_z / length_b) + (a_x / length_a - b_x / length_b) * (a_x / length_a - b_x / length_b) + (a_y / length_a - b_y / length_b) * (a_y / length_a - b_y / length_b) ->
  length_a <> 0 ->
  length_b <> 0 ->
  1 >= turned).

Definition kink_loci__projection_1__false : Prop :=
  ~ (
  forall cos_phi cos_theta eye radius sin_phi sin_theta t x y : R,
  let point_x := cos_theta * radius * sin_phi in
  let point_y := radius * sin_phi * sin_theta in
  let point_z := cos_phi * radius in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi >= 0 ->
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  t * x = point_x ->
  t * y = point_y ->
  eye * (1 - t) = point_z ->
  x * (cos_phi * radius + eye) = cos_theta * sin_phi * eye * radius).

Definition kink_loci__projection_2__false : Prop :=
  ~ (
  forall cos_phi cos_theta eye radius sin_phi sin_theta t x y : R,
  let point_x := cos_theta * radius * sin_phi in
  let point_y := radius * sin_phi * sin_theta in
  let point_z := cos_phi * radius in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi >= 0 ->
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  t * x = point_x ->
  t * y = point_y ->
  eye * (1 - t) = point_z ->
  x ^ 2 + y ^ 2 = (radius * sin_phi) ^ 2).

Definition kink_loci__projection_3__false : Prop :=
  ~ (
  forall cos_phi cos_theta eye radius sin_phi sin_theta t x y : R,
  let point_x := cos_theta * radius * sin_phi in
  let point_y := radius * sin_phi * sin_theta in
  let point_z := cos_phi * radius in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi >= 0 ->
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  t * x = point_x ->
  t * y = point_y ->
  eye * (1 - t) = point_z ->
  0 >= cos_theta * x + sin_theta * y).

Definition kink_loci__elsewhere_below_4__false : Prop :=
  ~ (
  forall k_u k_v u v : R,
  let cos_u := cos (PI * (k_u * u)) in
  let sin_u := sin (PI * (k_u * u)) in
  let sin_v := sin (PI * (k_v * v)) in
  let h_u := PI * cos_u * k_u * sin_v * (sign (sin_u * sin_v)) in
  -(sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) > 0 ->
  ex_derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u ->
  h_u = 1 * (Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u)).

Definition visible_iff__visible_1__false : Prop :=
  ~ (
  forall eye radius t x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye ->
  discriminant_a >= 0 ->
  eye * (1 - t) * eye * (1 - t) + t * x * t * x + t * y * t * y = radius ^ 2 ->
  eye * (1 - t) / radius >= 0 ->
  x ^ 2 + y ^ 2 >= 0 ->
  tangent_squared >= 0 ->
  tangent_squared <> 0 ->
  Rmax 0 discriminant_a >= 0 ->
  eye ^ 2 + root_a <> 0 ->
  radius <> 0 ->
  t * (t * (eye ^ 2 + rho ^ 2) - eye ^ 2) = radius * (radius - eye ^ 2 * (1 - t) / radius) /\
  (t * (eye ^ 2 + rho ^ 2) - eye ^ 2) ^ 2 = discriminant_a /\
  2 * eye ^ 2 * t = eye ^ 2 + t ^ 2 * (eye ^ 2 + rho ^ 2) - radius ^ 2 /\
  eye ^ 2 * t > 0 /\
  t > 0 /\
  0 >= t * (eye ^ 2 + rho ^ 2) - eye ^ 2 /\
  -(t * (eye ^ 2 + rho ^ 2) - eye ^ 2) >= root_a /\
  root_a >= -(t * (eye ^ 2 + rho ^ 2) - eye ^ 2) /\
  t >= t_a /\
  t_a >= t).

Definition visible_iff__hidden_2__false : Prop :=
  ~ (
  forall eye radius t x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye ->
  discriminant_a >= 0 ->
  eye * (1 - t) * eye * (1 - t) + t * x * t * x + t * y * t * y = radius ^ 2 ->
  eye * eye * (1 - t) / radius = radius ->
  x ^ 2 + y ^ 2 >= 0 ->
  tangent_squared >= 0 ->
  tangent_squared <> 0 ->
  Rmax 0 discriminant_a >= 0 ->
  eye ^ 2 + root_a <> 0 ->
  radius <> 0 ->
  t * (t * (eye ^ 2 + rho ^ 2) - eye ^ 2) = radius * (radius - eye ^ 2 * (1 - t) / radius) /\
  (t * (eye ^ 2 + rho ^ 2) - eye ^ 2) ^ 2 = discriminant_a /\
  2 * eye ^ 2 * t = eye ^ 2 + t ^ 2 * (eye ^ 2 + rho ^ 2) - radius ^ 2 /\
  eye ^ 2 * t > 0 /\
  t > 0 /\
  t * (eye ^ 2 + rho ^ 2) - eye ^ 2 > 0 /\
  t > t_a).

Definition visible_iff__hidden_3__false : Prop :=
  ~ (
  forall eye radius t x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 / 1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000) * eye ->
  discriminant_a >= 0 ->
  eye * (1 - t) * eye * (1 - t) + t * x * t * x + t * y * t * y = radius ^ 2 ->
  eye * eye * (1 - t) / radius < radius ->
  x ^ 2 + y ^ 2 >= 0 ->
  tangent_squared >= 0 ->
  tangent_squared <> 0 ->
  Rmax 0 discriminant_a >= 0 ->
  eye ^ 2 + root_a <> 0 ->
  radius <> 0 ->
  t < t_a).

Definition shadow_along_a_row__leading_1__false : Prop :=
  ~ (
  forall body_radius center_x center_y center_z light_x light_y light_z x y : R,
  ex_derive_n (fun x : R => body_radius ^ 2 * ((light_x - x) ^ 2 + (light_y - y) ^ 2 + (light_z - 0) ^ 2) - ((center_y - y) * (light_x - x) - (center_x - x) * (light_y - y)) ^ 2 - ((center_x - x) * (light_z - 0) - (center_z - 0) * (light_x - x)) ^ 2 - ((center_z - 0) * (light_y - y) - (center_y - y) * (light_z - 0)) ^ 2) 2 x ->
  (Derive_n (fun x : R => body_radius ^ 2 * ((light_x - x) ^ 2 + (light_y - y) ^ 2 + (light_z - 0) ^ 2) - ((center_y - y) * (light_x - x) - (center_x - x) * (light_y - y)) ^ 2 - ((center_x - x) * (light_z - 0) - (center_z - 0) * (light_x - x)) ^ 2 - ((center_z - 0) * (light_y - y) - (center_y - y) * (light_z - 0)) ^ 2) 2 x) = 2 * (body_radius ^ 2 - (light_z - center_z) ^ 2)).

Definition shadow_along_a_row__leading_2__false : Prop :=
  ~ (
  forall body_radius center_x center_y center_z light_x light_y light_z x y : R,
  ex_derive_n (fun x : R => body_radius ^ 2 * ((light_x - x) ^ 2 + (light_y - y) ^ 2 + (light_z - 0) ^ 2) - ((center_y - y) * (light_x - x) - (center_x - x) * (light_y - y)) ^ 2 - ((center_x - x) * (light_z - 0) - (center_z - 0) * (light_x - x)) ^ 2 - ((center_z - 0) * (light_y - y) - (center_y - y) * (light_z - 0)) ^ 2) 2 x ->
  (Derive_n (fun x : R => body_radius ^ 2 * ((light_x - x) ^ 2 + (light_y - y) ^ 2 + (light_z - 0) ^ 2) - ((center_y - y) * (light_x - x) - (center_x - x) * (light_y - y)) ^ 2 - ((center_x - x) * (light_z - 0) - (center_z - 0) * (light_x - x)) ^ 2 - ((center_z - 0) * (light_y - y) - (center_y - y) * (light_z - 0)) ^ 2) 2 x) = 2 * (body_radius ^ 2 - (light_x - center_x) ^ 2 - (light_z - center_z) ^ 2)).

Definition shadow_of_b_on_floor__conic_1__false : Prop :=
  ~ (
  forall body_radius center_x center_y center_z foot_x foot_y light_x light_y light_z : R,
  foot_x = 0 ->
  foot_y = 0 ->
  ((light_x - center_x) ^ 2 - ((light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y) * (light_y - center_y) - body_radius ^ 2)) * ((light_y - center_y) ^ 2 - ((light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y) * (light_y - center_y) - body_radius ^ 2)) - ((light_x - center_x) * (light_y - center_y)) ^ 2 = ((light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y) * (light_y - center_y) - body_radius ^ 2) * (body_radius ^ 2 + (light_z - center_z) ^ 2)).

Definition shadow_of_b_on_floor__hyperbola_2__false : Prop :=
  ~ (
  forall body_radius center_x center_y center_z light_x light_y light_z : R,
  (light_z - center_z) ^ 2 + (light_y - center_y) ^ 2 + (light_x - center_x) ^ 2 + 0 > body_radius ^ 2 ->
  (light_z - center_z) ^ 2 < body_radius ^ 2 ->
  ((light_x - center_x) ^ 2 - ((light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y) * (light_y - center_y) - body_radius ^ 2)) * ((light_y - center_y) ^ 2 - ((light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y) * (light_y - center_y) - body_radius ^ 2)) - ((light_x - center_x) * (light_y - center_y)) ^ 2 > 0).

Definition shadow_of_b_on_floor__away_3__false : Prop :=
  ~ (
  forall center_x center_y center_z light_x light_y light_z x y : R,
  let point_x := x in
  let point_y := y in
  let point_z := 0 in
  let segment_x := light_x - point_x in
  let segment_y := light_y - point_y in
  let segment_z := light_z - point_z in
  let offset_x := center_x - point_x in
  let offset_y := center_y - point_y in
  let offset_z := center_z - point_z in
  let segment_squared := segment_x ^ 2 + segment_y ^ 2 + segment_z ^ 2 in
  let toward_center := offset_x * segment_x + offset_y * segment_y + offset_z * segment_z in
  segment_squared - toward_center = (light_z - center_z) * (0 - light_z) + (light_x - center_x) * (x - light_x) + (light_y - center_y) * (y - light_y)).

Definition image_derivative__phong_1__false : Prop :=
  ~ (
  forall bumped_by_beta_x bumped_by_beta_y bumped_by_beta_z bumped_x bumped_y bumped_z s towards_x towards_y towards_z view_x view_y view_z : R,
  s = 0 ->
  ex_derive (fun s : R => -towards_x * view_x - towards_y * view_y - towards_z * view_z + 2 * (towards_x * (bumped_by_beta_x * s + bumped_x) + towards_y * (bumped_by_beta_y * s + bumped_y) + towards_z * (bumped_by_beta_z * s + bumped_z)) * (view_x * (bumped_by_beta_x * s + bumped_x) + view_y * (bumped_by_beta_y * s + bumped_y) + view_z * (bumped_by_beta_z * s + bumped_z))) s ->
  2 * (Derive (fun s : R => -towards_x * view_x - towards_y * view_y - towards_z * view_z + 2 * (towards_x * (bumped_by_beta_x * s + bumped_x) + towards_y * (bumped_by_beta_y * s + bumped_y) + towards_z * (bumped_by_beta_z * s + bumped_z)) * (view_x * (bumped_by_beta_x * s + bumped_x) + view_y * (bumped_by_beta_y * s + bumped_y) + view_z * (bumped_by_beta_z * s + bumped_z))) s) = 2 * (bumped_by_beta_x * towards_x + bumped_by_beta_y * towards_y + bumped_by_beta_z * towards_z) * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) + 2 * (bumped_by_beta_x * view_x + bumped_by_beta_y * view_y + bumped_by_beta_z * view_z) * (bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z)).

Definition image_derivative__power_rule_2__false : Prop :=
  ~ (
  forall slope x : R,
  forall of_x by_s power_ : nat -> R,
  of_x 0%nat = 1 ->
  (forall n : nat, of_x (S n) = (of_x n) * x) ->
  by_s 0%nat = 0 ->
  (forall n : nat, by_s (S n) = (by_s n) * x + (of_x n) * slope) ->
  power_ 0%nat = 0 ->
  (forall n : nat, power_ (S n) = power_ n + 1) ->
  forall n : nat,
  (by_s n) * x = slope * (of_x n) * (power_ n + 1)).

Definition image_derivative__unlit_shiny_3__false : Prop :=
  ~ (
  forall albedo_red base_by_beta kd ks light_red mu mu_by_beta raised raised_by_beta red s shininess specular_base : R,
  mu < 0 ->
  specular_base > 0 ->
  s = 0 ->
  raised_by_beta * specular_base = base_by_beta * raised * shininess ->
  ex_derive (fun s : R => light_red * (albedo_red * kd * 1 * (mu + mu_by_beta * s) + ks * 1 * (raised + raised_by_beta * s)) + red) s ->
  (specular_base > 0 -> specular_base <> 0) ->
  (Derive (fun s : R => light_red * (albedo_red * kd * 1 * (mu + mu_by_beta * s) + ks * 1 * (raised + raised_by_beta * s)) + red) s) = light_red * (albedo_red * ((if Rlt_dec 0 mu then kd * mu_by_beta else 0)) + (if Rlt_dec 0 specular_base then base_by_beta * ks * shininess * raised / specular_base else 0))).

Definition difference_bound__clip_1__false : Prop :=
  ~ (
  forall bound_on first second : R,
  bound_on - (first - second) >= 0 ->
  bound_on + first - second >= 0 ->
  bound_on / 2 - (Rmin 1 (Rmax 0 first) - (Rmin 1 (Rmax 0 second))) >= 0 /\
  bound_on / 2 + Rmin 1 (Rmax 0 first) - (Rmin 1 (Rmax 0 second)) >= 0).

Definition difference_bound__all_lights_2__false : Prop :=
  ~ (
  forall change_1 change_2 change_3 change_4 change_5 factor_1 factor_2 factor_3 factor_4 factor_5 slope_error step : R,
  factor_1 * step + 0 >= change_1 ->
  change_1 + factor_2 * step >= change_2 ->
  change_2 + factor_3 * step >= change_3 ->
  change_3 + factor_4 * step >= change_4 ->
  change_4 + factor_5 * step >= change_5 ->
  factor_1 >= 0 ->
  factor_2 >= 0 ->
  factor_3 >= 0 ->
  factor_4 >= 0 ->
  factor_5 >= 0 ->
  slope_error >= step ->
  step * (factor_4 + factor_3 + factor_2 + factor_1 + 0) >= change_5).

Definition difference_bound__light_0_3__false : Prop :=
  ~ (
  forall albedo_red before kd ks light_red mu other_mu other_specular q red so_far specular step : R,
  albedo_red >= 0 ->
  light_red >= 0 ->
  kd >= 0 ->
  ks >= 0 ->
  so_far - (red - before) >= 0 ->
  so_far + red - before >= 0 ->
  step - (Rmax 0 mu - (Rmax 0 other_mu)) >= 0 ->
  step + Rmax 0 mu - (Rmax 0 other_mu) >= 0 ->
  q * step - (specular - other_specular) >= 0 ->
  q * step + specular - other_specular >= 0 ->
  albedo_red * kd >= 0 /\
  kd * albedo_red * light_red >= 0 /\
  ks * light_red >= 0 /\
  step * kd * albedo_red * light_red - albedo_red * kd * light_red * (Rmax 0 mu - (Rmax 0 other_mu)) >= 0 /\
  step * kd * albedo_red * light_red + kd * albedo_red * light_red * (Rmax 0 mu - (Rmax 0 other_mu)) >= 0 /\
  ks * light_red * q * step - ks * light_red * (specular - other_specular) >= 0 /\
  ks * light_red * q * step + ks * light_red * (specular - other_specular) >= 0 /\
  so_far + step * kd * albedo_red * light_red - (light_red * (albedo_red * kd * (Rmax 0 mu) + ks * specular) + red - (before + light_red * (albedo_red * kd * (Rmax 0 other_mu) + ks * other_specular))) >= 0 /\
  so_far + step * kd * albedo_red * light_red + light_red * (albedo_red * kd * (Rmax 0 mu) + ks * specular) + red - (before + light_red * (albedo_red * kd * (Rmax 0 other_mu) + ks * other_specular)) >= 0).

Definition difference_bound__light_0_4__false : Prop :=
  ~ (
  forall albedo_red before kd ks light_red mu other_mu other_specular q red so_far specular step : R,
  albedo_red >= 0 ->
  light_red >= 0 ->
  kd >= 0 ->
  ks >= 0 ->
  so_far - (red - before) >= 0 ->
  so_far + red - before >= 0 ->
  step - (Rmax 0 mu - (Rmax 0 other_mu)) >= 0 ->
  step + Rmax 0 mu - (Rmax 0 other_mu) >= 0 ->
  q * step - (specular - other_specular) >= 0 ->
  q * step + specular - other_specular >= 0 ->
  albedo_red * kd >= 0 /\
  kd * albedo_red * light_red >= 0 /\
  ks * light_red >= 0 /\
  step * kd * albedo_red * light_red - albedo_red * kd * light_red * (Rmax 0 mu - (Rmax 0 other_mu)) >= 0 /\
  step * kd * albedo_red * light_red + kd * albedo_red * light_red * (Rmax 0 mu - (Rmax 0 other_mu)) >= 0 /\
  ks * light_red * q * step - ks * light_red * (specular - other_specular) >= 0 /\
  ks * light_red * q * step + ks * light_red * (specular - other_specular) >= 0 /\
  so_far + step * q * ks * light_red - (light_red * (albedo_red * kd * (Rmax 0 mu) + ks * specular) + red - (before + light_red * (albedo_red * kd * (Rmax 0 other_mu) + ks * other_specular))) >= 0 /\
  so_far + step * q * ks * light_red + light_red * (albedo_red * kd * (Rmax 0 mu) + ks * specular) + red - (before + light_red * (albedo_red * kd * (Rmax 0 other_mu) + ks * other_specular)) >= 0).

Definition pixels_off_the_pole__raster_above_1__false : Prop :=
  ~ (
  forall m n : R,
  (m - 128) * (m - 127) >= 0 ->
  n <= 108 ->
  ((5 / 4) * 4 * 1 / (sqrt (1 + 4) * sqrt (4 - 1)) * ((-2 * n - 1 + 256) / 256 + (-3 / 20))) ^ 2 + ((5 / 4) * 4 * 1 / (sqrt (1 + 4) * sqrt (4 - 1)) * (2 * m - 256 + 1) / 256) ^ 2 + 0 >= (1 / 16384)).

Definition pixels_off_the_pole__linear_2__false : Prop :=
  ~ (
  forall cos_phi eye radius sin_phi : R,
  let rho := eye * radius * sin_phi / (eye - cos_phi * radius) in
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi >= 0 ->
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  eye - cos_phi * radius <> 0 ->
  radius * sin_phi >= rho).

Definition pixels_off_the_pole__far_3__false : Prop :=
  ~ (
  forall rho sin_phi : R,
  4 * sin_phi >= 3 * rho ->
  rho >= 0 ->
  rho ^ 2 >= (34 / 15) / 65536 ->
  sin_phi > (9 / 2000)).

Definition visible_parallels__count_1__false : Prop :=
  ~ (
  cos (PI / 2) > (1 / 4)).

Definition visible_parallels__falling_2__false : Prop :=
  ~ (
  forall a b : R,
  a >= 0 ->
  b - a > 0 ->
  1 - b >= 0 ->
  cos (PI * b) > cos (PI * a)).

Definition visible_parallels__pole_3__false : Prop :=
  ~ (
  forall cos_phi eye radius sin_phi : R,
  let rho := eye * radius * sin_phi / (eye - cos_phi * radius) in
  sin_phi = 0 ->
  cos_phi = 1 ->
  eye > radius ->
  eye - cos_phi * radius <> 0 ->
  rho > 0).

Definition shadow_of_a_on_floor__of_a_1__false : Prop :=
  ~ (
  forall body_radius light_x light_y light_z x y : R,
  body_radius ^ 2 * ((light_x - x) ^ 2 + (light_y - y) ^ 2 + (light_z - 0) ^ 2) - ((light_z - 0) * (0 - x) - (0 - 0) * (light_x - x)) ^ 2 - ((0 - 0) * (light_y - y) - (light_z - 0) * (0 - y)) ^ 2 - ((light_x - x) * (0 - y) - (light_y - y) * (0 - x)) ^ 2 = body_radius ^ 2 + 2 * (body_radius ^ 2 * ((light_x - x) ^ 2 + (light_y - y) ^ 2 + (light_z - 0) ^ 2) - ((light_z - 0) * (0 - x) - (0 - 0) * (light_x - x)) ^ 2 - ((0 - 0) * (light_y - y) - (light_z - 0) * (0 - y)) ^ 2 - ((light_x - x) * (0 - y) - (light_y - y) * (0 - x)) ^ 2) - (body_radius ^ 2 * ((0 - light_z) * (0 - light_z) + (x - light_x) * (x - light_x) + (y - light_y) * (y - light_y)) + (light_x * x + light_y * y) ^ 2 - (x ^ 2 + y ^ 2) * (light_z * light_z + light_x * light_x + light_y * light_y))).

Definition shadow_of_a_on_floor__behind_a_2__false : Prop :=
  ~ (
  forall light_x light_y light_z x y : R,
  -((light_x - x) * (0 - x) + (light_y - y) * (0 - y) + (0 - 0) * (light_z - 0)) = x ^ 2 + y ^ 2 - light_x * x - light_y * y).
