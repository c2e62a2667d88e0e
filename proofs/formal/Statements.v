(* Printed from proofs/theorems by `python -m renderer.generate`. Do not edit: change the claim instead.
   Each definition is one claim: what is written by hand proves it, and is compiled afterwards. *)

From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Float Float64.
Open Scope R_scope.

Definition algebraic_gradient__power : Prop :=
  forall alpha : R,
  forall real_part imaginary_part : nat -> R,
  real_part 0%nat = 1 ->
  (forall n : nat, real_part (S n) = (real_part n) * (cos alpha) - (imaginary_part n) * (sin alpha)) ->
  imaginary_part 0%nat = 0 ->
  (forall n : nat, imaginary_part (S n) = (imaginary_part n) * (cos alpha) + (real_part n) * (sin alpha)) ->
  forall n : nat,
  real_part n = cos (alpha * (INR n)) /\
  imaginary_part n = sin (alpha * (INR n)).

Definition algebraic_gradient__negative_power : Prop :=
  forall alpha : R,
  forall real_part imaginary_part : nat -> R,
  real_part 0%nat = 1 ->
  (forall n : nat, real_part (S n) = (real_part n) * (cos alpha) - (-1) * (imaginary_part n) * (sin alpha)) ->
  imaginary_part 0%nat = 0 ->
  (forall n : nat, imaginary_part (S n) = (imaginary_part n) * (cos alpha) + (real_part n) * (-(sin alpha))) ->
  forall n : nat,
  real_part n = cos (alpha * (-(INR n))) /\
  imaginary_part n = sin (alpha * (-(INR n))).

Definition algebraic_gradient__in_u : Prop :=
  forall theta : R,
  forall real_part imaginary_part sign_ : nat -> R,
  real_part 0%nat = 1 ->
  (forall n : nat, real_part (S n) = (real_part n) * (-(cos theta)) - (-1) * (imaginary_part n) * (sin theta)) ->
  imaginary_part 0%nat = 0 ->
  (forall n : nat, imaginary_part (S n) = (imaginary_part n) * (-(cos theta)) + (real_part n) * (-(sin theta))) ->
  sign_ 0%nat = 1 ->
  (forall n : nat, sign_ (S n) = -(sign_ n)) ->
  forall n : nat,
  real_part n = cos (PI * (2 * (INR n) * (theta + PI) / (2 * PI))) /\
  imaginary_part n = sin (PI * (2 * (INR n) * (theta + PI) / (2 * PI))) /\
  real_part n = (sign_ n) * (cos ((INR n) * theta)) /\
  imaginary_part n = (sign_ n) * (sin ((INR n) * theta)) /\
  sign_ n = cos (PI * (INR n)) /\
  sin (PI * (INR n)) = 0.

Definition algebraic_gradient__in_v : Prop :=
  forall phi : R,
  forall real_part imaginary_part : nat -> R,
  real_part 0%nat = 1 ->
  (forall n : nat, real_part (S n) = (real_part n) * (cos phi) - (imaginary_part n) * (sin phi)) ->
  imaginary_part 0%nat = 0 ->
  (forall n : nat, imaginary_part (S n) = (imaginary_part n) * (cos phi) + (real_part n) * (sin phi)) ->
  forall n : nat,
  real_part n = cos (PI * ((INR n) * phi / PI)) /\
  imaginary_part n = sin (PI * ((INR n) * phi / PI)).

Definition algebraic_gradient__rings_in_v : Prop :=
  forall phi : R,
  forall real_part imaginary_part : nat -> R,
  real_part 0%nat = 1 ->
  (forall n : nat, real_part (S n) = (real_part n) * (cos phi) - (imaginary_part n) * (sin phi)) ->
  imaginary_part 0%nat = 0 ->
  (forall n : nat, imaginary_part (S n) = (imaginary_part n) * (cos phi) + (real_part n) * (sin phi)) ->
  forall n : nat,
  real_part n = cos (PI * (2 * (1 / 2) * (INR n) * phi / PI)) /\
  imaginary_part n = sin (PI * (2 * (1 / 2) * (INR n) * phi / PI)).

Definition algebraic_gradient__square : Prop :=
  forall alpha : R,
  let product_real := (cos alpha - (sin alpha)) * (sin alpha + cos alpha) in
  let product_imaginary := 2 * (sin alpha) * (cos alpha) in
  product_real = cos (2 * alpha) /\
  product_imaginary = sin (2 * alpha).

Definition algebraic_gradient__product : Prop :=
  forall alpha gamma : R,
  let product_real := (cos alpha) * (cos gamma) - (sin alpha) * (sin gamma) in
  let product_imaginary := (sin alpha) * (cos gamma) + (sin gamma) * (cos alpha) in
  product_real = cos (alpha + gamma) /\
  product_imaginary = sin (alpha + gamma).

Definition algebraic_gradient__reciprocal : Prop :=
  forall imaginary_part real_part : R,
  let product_real := real_part * real_part - (-1) * imaginary_part ^ 2 in
  let product_imaginary := (-imaginary_part) * real_part + imaginary_part * real_part in
  imaginary_part ^ 2 + real_part ^ 2 = 1 ->
  product_real = 1 /\
  product_imaginary = 0.

Definition chart__range : Prop :=
  forall phi turn : R,
  let u_closed := (1 / 2) * turn + (1 / 2) in
  let u := (if Rlt_dec u_closed 1 then u_closed else 0) in
  let v := phi / PI in
  turn > -1 ->
  turn <= 1 ->
  phi >= 0 ->
  phi <= PI ->
  u >= 0 /\
  1 > u /\
  v >= 0 /\
  1 >= v.

Definition chart__inside : Prop :=
  forall turn : R,
  let u_closed := (1 / 2) * turn + (1 / 2) in
  let u := (if Rlt_dec u_closed 1 then u_closed else 0) in
  turn < 1 ->
  u = u_closed /\
  PI * (2 * u - 1) = PI * turn.

Definition chart__seam : Prop :=
  forall turn : R,
  let u_closed := (1 / 2) * turn + (1 / 2) in
  let u := (if Rlt_dec u_closed 1 then u_closed else 0) in
  turn = 1 ->
  u = 0.

Definition chart__round_trip : Prop :=
  forall phi turn : R,
  let cos_theta := -(cos (PI * (2 * ((1 / 2) * turn + (1 / 2))))) in
  let sin_theta := -(sin (PI * (2 * ((1 / 2) * turn + (1 / 2))))) in
  let cos_phi := cos (PI * (phi / PI)) in
  let sin_phi := sin (PI * (phi / PI)) in
  cos_theta = cos (PI * turn) /\
  sin_theta = sin (PI * turn) /\
  cos_phi = cos phi /\
  sin_phi = sin phi.

Definition chart__on_the_seam : Prop :=
  let cos_theta := -(cos (PI * (2 * 0))) in
  let sin_theta := -(sin (PI * (2 * 0))) in
  cos_theta = cos (PI * 1) /\
  sin_theta = sin (PI * 1).

Definition chart_inverse__formula : Prop :=
  forall u v : R,
  let cos_theta := -(cos (PI * (2 * u))) in
  let sin_theta := -(sin (PI * (2 * u))) in
  let cos_phi := cos (PI * v) in
  let sin_phi := sin (PI * v) in
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  normal_x = (-(sin (PI * v))) * (cos (2 * PI * u)) /\
  normal_y = (-(sin (PI * v))) * (sin (2 * PI * u)) /\
  normal_z = cos (PI * v).

Definition chart_inverse__unit : Prop :=
  forall u v : R,
  (-(cos (PI * (2 * u)))) * (sin (PI * v)) * (-(cos (PI * (2 * u)))) * (sin (PI * v)) + (-(sin (PI * (2 * u)))) * (sin
      (PI * v)) * (-(sin (PI * (2 * u)))) * (sin (PI * v)) + (cos (PI * v)) * (cos (PI * v)) = 1.

Definition chart_inverse__recovered : Prop :=
  forall cos_theta sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  sin_phi > 0 ->
  normal_x ^ 2 + normal_y ^ 2 >= 0 /\
  sqrt (normal_x ^ 2 + normal_y ^ 2) <> 0 /\
  (sqrt (normal_x ^ 2 + normal_y ^ 2)) ^ 2 = sin_phi ^ 2 /\
  sqrt (normal_x ^ 2 + normal_y ^ 2) = sin_phi /\
  normal_x / sqrt (normal_x ^ 2 + normal_y ^ 2) = cos_theta /\
  normal_y / sqrt (normal_x ^ 2 + normal_y ^ 2) = sin_theta.

Definition clamped_difference__clamp : Prop :=
  forall epsilon v : R,
  let v_plus := Rmin 1 (epsilon + v) in
  let v_minus := Rmax (v - epsilon) 0 in
  let span_v := (if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus) in
  epsilon > 0 ->
  v >= 0 ->
  v - epsilon < 0 ->
  epsilon + v <= 1 ->
  v_plus = epsilon + v /\
  v_minus = 0 /\
  span_v = epsilon + v.

Definition clamped_difference__at_the_pole_itself : Prop :=
  forall epsilon v : R,
  let v_plus := epsilon + v in
  let v_minus := 0 in
  let span_v := v_plus - v_minus in
  let h_v_plus := (1 / 2) * v_plus ^ 2 in
  let h_v_minus := (1 / 2) * v_minus ^ 2 in
  let h_v := (h_v_plus - h_v_minus) / span_v in
  epsilon > 0 ->
  v >= 0 ->
  v - epsilon < 0 ->
  epsilon + v <= 1 ->
  span_v <> 0 /\
  h_v - v = (epsilon - v) / 2.

Definition seed_clamp__costs_an_order : Prop :=
  ~ (
  forall epsilon : R,
  epsilon > 0 ->
  epsilon <= 1 ->
  epsilon + 0 - 0 <> 0 ->
  Rabs ((epsilon + 0 - (epsilon + 0) ^ 3 - (0 - 0 ^ 3)) / (epsilon + 0 - 0) - (1 - 3 * 0 ^ 2)) >= epsilon).

Definition colour_accuracy__hit : Prop :=
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
  (eye - ball_center_z) * (eye - ball_center_z) + ball_center_x * ball_center_x + ball_center_y * ball_center_y >= 4 *
      ball_radius ^ 2 ->
  (eye - ball_center_z) * (eye - ball_center_z) + ball_center_x * ball_center_x + ball_center_y * ball_center_y <= 2 ^
      40 * ball_radius ^ 2 ->
  ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - x * (eye - ball_center_z)) ^ 2 - (ball_center_x *
      y - ball_center_y * x) ^ 2 - (y * (eye - ball_center_z) - ball_center_y * eye) ^ 2 >= ball_radius ^ 2 * (eye * eye
      + x * x + y * y) / 16 ->
  ball_center_x * x + ball_center_y * y + eye * (eye - ball_center_z) > 0 ->
  ball_on > 0 ->
  Rabs (hit_of_b_float64.t_b x y eye ball_center_x ball_center_y ball_center_z ball_radius ball_on - hit_of_b.t_b x y
      eye ball_center_x ball_center_y ball_center_z ball_radius ball_on) <= 112 / 9007199254740992 * (ball_center_x ^ 2
      + ball_center_y ^ 2 + (eye - ball_center_z - ball_radius) * (ball_radius + eye - ball_center_z)) / (ball_center_x
      * x + ball_center_y * y + eye * (eye - ball_center_z) + sqrt (Rmax 0 (ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2)
      - (ball_center_x * eye - x * (eye - ball_center_z)) ^ 2 - (ball_center_x * y - ball_center_y * x) ^ 2 - (y * (eye
      - ball_center_z) - ball_center_y * eye) ^ 2))).

Definition colour_accuracy__normal : Prop :=
  forall normal_x normal_y normal_z g_x g_y g_z beta : R,
  float64 normal_x ->
  float64 normal_y ->
  float64 normal_z ->
  float64 g_x ->
  float64 g_y ->
  float64 g_z ->
  float64 beta ->
  (beta * g_z + normal_z) * (beta * g_z + normal_z) + (beta * g_x + normal_x) * (beta * g_x + normal_x) + (beta * g_y +
      normal_y) * (beta * g_y + normal_y) >= 1 ->
  (beta * g_z + normal_z) * (beta * g_z + normal_z) + (beta * g_x + normal_x) * (beta * g_x + normal_x) + (beta * g_y +
      normal_y) * (beta * g_y + normal_y) <= 2 ^ 900 ->
  (beta * g_x) ^ 2 <= (beta * g_z + normal_z) * (beta * g_z + normal_z) + (beta * g_x + normal_x) * (beta * g_x +
      normal_x) + (beta * g_y + normal_y) * (beta * g_y + normal_y) ->
  (beta * g_y) ^ 2 <= (beta * g_z + normal_z) * (beta * g_z + normal_z) + (beta * g_x + normal_x) * (beta * g_x +
      normal_x) + (beta * g_y + normal_y) * (beta * g_y + normal_y) ->
  (beta * g_z) ^ 2 <= (beta * g_z + normal_z) * (beta * g_z + normal_z) + (beta * g_x + normal_x) * (beta * g_x +
      normal_x) + (beta * g_y + normal_y) * (beta * g_y + normal_y) ->
  Rabs (perturbed_float64.bumped_x normal_x normal_y normal_z g_x g_y g_z beta - perturbed.bumped_x normal_x normal_y
      normal_z g_x g_y g_z beta) <= 12 / 9007199254740992 /\
  Rabs (perturbed_float64.bumped_y normal_x normal_y normal_z g_x g_y g_z beta - perturbed.bumped_y normal_x normal_y
      normal_z g_x g_y g_z beta) <= 12 / 9007199254740992 /\
  Rabs (perturbed_float64.bumped_z normal_x normal_y normal_z g_x g_y g_z beta - perturbed.bumped_z normal_x normal_y
      normal_z g_x g_y g_z beta) <= 12 / 9007199254740992.

Definition colour_accuracy__cosine : Prop :=
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
  (light_z - point_z) * (light_z - point_z) + (light_x - point_x) * (light_x - point_x) + (light_y - point_y) * (light_y
      - point_y) >= / 1099511627776 ->
  (light_z - point_z) * (light_z - point_z) + (light_x - point_x) * (light_x - point_x) + (light_y - point_y) * (light_y
      - point_y) <= 2 ^ 900 ->
  Rabs bumped_x <= / 1099511627776 + 1 ->
  Rabs bumped_y <= / 1099511627776 + 1 ->
  Rabs bumped_z <= / 1099511627776 + 1 ->
  Rabs (light_direction_float64.mu point_x point_y point_z light_x light_y light_z bumped_x bumped_y bumped_z -
      light_direction.mu point_x point_y point_z light_x light_y light_z bumped_x bumped_y bumped_z) <= 45 /
      9007199254740992.

Definition colour_accuracy__blinn : Prop :=
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
  Rabs (blinn_highlight_float64.specular_base bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z -
      blinn_highlight.specular_base bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z) <= 32 / 9007199254740992.

Definition colour_accuracy__squared : Prop :=
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
  Rabs (squared_highlight_float64.specular_base bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z light_distance
      - squared_highlight.specular_base bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z light_distance) <= 80 /
      9007199254740992.

Definition colour_accuracy__phong : Prop :=
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
  Rabs (phong_highlight_float64.specular_base bumped_x bumped_y bumped_z view_x view_y view_z towards_x towards_y
      towards_z mu - phong_highlight.specular_base bumped_x bumped_y bumped_z view_x view_y view_z towards_x towards_y
      towards_z mu) <= 56 / 9007199254740992.

Definition colour_accuracy__share_red : Prop :=
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
  Rabs (light_term_float64.lit_red red light_red albedo_red kd ks mu specular - light_term.lit_red red light_red
      albedo_red kd ks mu specular) <= 8 / 9007199254740992 * (light_red * (albedo_red * kd * (Rmax 0 mu) + ks *
      specular) + red) + / 1000000000000000000000000000000.

Definition colour_accuracy__share_green : Prop :=
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
  Rabs (light_term_float64.lit_green green light_green albedo_green kd ks mu specular - light_term.lit_green green
      light_green albedo_green kd ks mu specular) <= 8 / 9007199254740992 * (green + light_green * (albedo_green * kd *
      (Rmax 0 mu) + ks * specular)) + / 1000000000000000000000000000000.

Definition colour_accuracy__share_blue : Prop :=
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
  Rabs (light_term_float64.lit_blue blue light_blue albedo_blue kd ks mu specular - light_term.lit_blue blue light_blue
      albedo_blue kd ks mu specular) <= 8 / 9007199254740992 * (blue + light_blue * (albedo_blue * kd * (Rmax 0 mu) + ks
      * specular)) + / 1000000000000000000000000000000.

Definition colour_accuracy__clip : Prop :=
  forall color : R,
  float64 color ->
  Rabs (clip_float64.clipped color - clip.clipped color) <= 0.

Definition straddling__value : Prop :=
  forall delta epsilon k_u : R,
  epsilon > 0 ->
  k_u > 0 ->
  epsilon - delta > 0 ->
  delta + epsilon > 0 ->
  1 - k_u * (delta + epsilon) >= 0 ->
  1 - k_u * (epsilon - delta) >= 0 ->
  epsilon <> 0 /\
  (1 / 2) * (Rabs ((sin (PI * ((1 / 2) * 1))) * (sin (PI * (k_u * (delta + epsilon))))) - (Rabs ((sin (PI * ((1 / 2) *
      1))) * (sin (PI * (k_u * (delta - epsilon))))))) / epsilon = (sin (delta * PI * k_u)) * (cos (epsilon * PI * k_u))
      / epsilon.

Definition straddling__every_crease : Prop :=
  forall delta m : R,
  sin (PI * m) = 0 ->
  Rabs (sin (delta + PI * m)) = Rabs (sin delta).

Definition seed_truncation_slope__descends : Prop :=
  ~ (
  forall epsilon omega : R,
  omega > 0 ->
  epsilon > 0 ->
  (1 / 6) * epsilon ^ 2 * omega ^ 3 >= Rabs (-omega)).

Definition truncation_bound__sine : Prop :=
  forall epsilon k_u k_v u v : R,
  epsilon > 0 ->
  u - epsilon >= 0 ->
  epsilon + u < 1 ->
  k_u > 0 ->
  ex_derive_n (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) 3 u /\
  epsilon <> 0 /\
  ex_derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u /\
  1 - (sin (v * PI * k_v)) * (cos (u * PI * k_u)) >= 0 /\
  (sin (v * PI * k_v)) * (cos (u * PI * k_u)) + 1 >= 0 /\
  PI * k_u > 0 /\
  (PI * k_u) ^ 3 > 0 /\
  (Derive_n (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) 3 u) = (-(PI * k_u) ^ 3) * (sin (v * PI *
      k_v)) * (cos (u * PI * k_u)) /\
  (PI * k_u) ^ 3 - (Derive_n (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) 3 u) >= 0 /\
  (PI * k_u) ^ 3 + (Derive_n (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) 3 u) >= 0 /\
  epsilon * ((1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) - (sin (PI * (k_u * (u - epsilon))))
      * (sin (PI * (k_v * v)))) / epsilon - (Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u)) =
      (sin (v * PI * k_v)) * (cos (u * PI * k_u)) * (sin (epsilon * PI * k_u) - PI * epsilon * k_u) /\
  epsilon * (1 * (1 / 6) * PI ^ 3 * epsilon ^ 2 * k_u ^ 3 + 1 * ((1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin
      (PI * (k_v * v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon - (Derive (fun u : R =>
      (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u))) >= 0 /\
  epsilon * (1 * (1 / 6) * PI ^ 3 * epsilon ^ 2 * k_u ^ 3 - ((1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI *
      (k_v * v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon - (Derive (fun u : R => (sin
      (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u))) >= 0 /\
  1 * (1 / 6) * PI ^ 3 * epsilon ^ 2 * k_u ^ 3 + 1 * ((1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v *
      v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon - (Derive (fun u : R => (sin (PI *
      (k_u * u))) * (sin (PI * (k_v * v)))) u)) >= 0 /\
  1 * (1 / 6) * PI ^ 3 * epsilon ^ 2 * k_u ^ 3 - ((1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v)))
      - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon - (Derive (fun u : R => (sin (PI * (k_u *
      u))) * (sin (PI * (k_v * v)))) u)) >= 0.

Definition truncation_bound__sine_in_v : Prop :=
  forall epsilon k_u k_v u v : R,
  epsilon > 0 ->
  v - epsilon >= 0 ->
  epsilon + v <= 1 ->
  k_v > 0 ->
  ex_derive_n (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) 3 v /\
  2 * epsilon <> 0 /\
  ex_derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v /\
  1 - (sin (u * PI * k_u)) * (cos (v * PI * k_v)) >= 0 /\
  (sin (u * PI * k_u)) * (cos (v * PI * k_v)) + 1 >= 0 /\
  PI * k_v > 0 /\
  (PI * k_v) ^ 3 > 0 /\
  (Derive_n (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) 3 v) = (-(PI * k_v) ^ 3) * (sin (u * PI *
      k_u)) * (cos (v * PI * k_v)) /\
  (PI * k_v) ^ 3 - (Derive_n (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) 3 v) >= 0 /\
  (PI * k_v) ^ 3 + (Derive_n (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) 3 v) >= 0 /\
  epsilon * (((sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon + v)))) - (sin (PI * (k_u * u))) * (sin (PI * (k_v *
      (v - epsilon))))) / (2 * epsilon) - (Derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v)) =
      (sin (u * PI * k_u)) * (cos (v * PI * k_v)) * (sin (epsilon * PI * k_v) - PI * epsilon * k_v) /\
  epsilon * (1 * (1 / 6) * PI ^ 3 * epsilon ^ 2 * k_v ^ 3 + 1 * (((sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon +
      v)))) - (sin (PI * (k_u * u))) * (sin (PI * (k_v * (v - epsilon))))) / (2 * epsilon) - (Derive (fun v : R => (sin
      (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v))) >= 0 /\
  epsilon * (1 * (1 / 6) * PI ^ 3 * epsilon ^ 2 * k_v ^ 3 - (((sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon +
      v)))) - (sin (PI * (k_u * u))) * (sin (PI * (k_v * (v - epsilon))))) / (2 * epsilon) - (Derive (fun v : R => (sin
      (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v))) >= 0 /\
  1 * (1 / 6) * PI ^ 3 * epsilon ^ 2 * k_v ^ 3 + 1 * (((sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon + v)))) -
      (sin (PI * (k_u * u))) * (sin (PI * (k_v * (v - epsilon))))) / (2 * epsilon) - (Derive (fun v : R => (sin (PI *
      (k_u * u))) * (sin (PI * (k_v * v)))) v)) >= 0 /\
  1 * (1 / 6) * PI ^ 3 * epsilon ^ 2 * k_v ^ 3 - (((sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon + v)))) - (sin
      (PI * (k_u * u))) * (sin (PI * (k_v * (v - epsilon))))) / (2 * epsilon) - (Derive (fun v : R => (sin (PI * (k_u *
      u))) * (sin (PI * (k_v * v)))) v)) >= 0.

Definition truncation_bound__rings : Prop :=
  forall epsilon k_v v : R,
  epsilon > 0 ->
  v - epsilon >= 0 ->
  epsilon + v <= 1 ->
  k_v > 0 ->
  ex_derive_n (fun v : R => sin (PI * (2 * k_v * v))) 3 v /\
  2 * epsilon <> 0 /\
  ex_derive (fun v : R => sin (PI * (2 * k_v * v))) v /\
  1 - (cos (v * 2 * PI * k_v)) >= 0 /\
  cos (v * 2 * PI * k_v) + 1 >= 0 /\
  PI * 2 * k_v > 0 /\
  (PI * 2 * k_v) ^ 3 > 0 /\
  (Derive_n (fun v : R => sin (PI * (2 * k_v * v))) 3 v) = (-(PI * 2 * k_v) ^ 3) * (cos (v * 2 * PI * k_v)) /\
  (PI * 2 * k_v) ^ 3 - (Derive_n (fun v : R => sin (PI * (2 * k_v * v))) 3 v) >= 0 /\
  (PI * 2 * k_v) ^ 3 + (Derive_n (fun v : R => sin (PI * (2 * k_v * v))) 3 v) >= 0 /\
  epsilon * ((sin (PI * (2 * k_v * (epsilon + v))) - (sin (PI * (2 * k_v * (v - epsilon))))) / (2 * epsilon) - (Derive
      (fun v : R => sin (PI * (2 * k_v * v))) v)) = (sin (epsilon * PI * 2 * k_v) - 2 * PI * epsilon * k_v) * (cos (v *
      2 * PI * k_v)) /\
  epsilon * (1 * (1 / 6) * PI ^ 3 * epsilon ^ 2 * 8 * k_v ^ 3 + 1 * ((sin (PI * (2 * k_v * (epsilon + v))) - (sin (PI *
      (2 * k_v * (v - epsilon))))) / (2 * epsilon) - (Derive (fun v : R => sin (PI * (2 * k_v * v))) v))) >= 0 /\
  epsilon * (1 * (1 / 6) * PI ^ 3 * epsilon ^ 2 * 8 * k_v ^ 3 - ((sin (PI * (2 * k_v * (epsilon + v))) - (sin (PI * (2 *
      k_v * (v - epsilon))))) / (2 * epsilon) - (Derive (fun v : R => sin (PI * (2 * k_v * v))) v))) >= 0 /\
  1 * (1 / 6) * PI ^ 3 * epsilon ^ 2 * 8 * k_v ^ 3 + 1 * ((sin (PI * (2 * k_v * (epsilon + v))) - (sin (PI * (2 * k_v *
      (v - epsilon))))) / (2 * epsilon) - (Derive (fun v : R => sin (PI * (2 * k_v * v))) v)) >= 0 /\
  1 * (1 / 6) * PI ^ 3 * epsilon ^ 2 * 8 * k_v ^ 3 - ((sin (PI * (2 * k_v * (epsilon + v))) - (sin (PI * (2 * k_v * (v -
      epsilon))))) / (2 * epsilon) - (Derive (fun v : R => sin (PI * (2 * k_v * v))) v)) >= 0.

Definition truncation_bound__ridges_u_above : Prop :=
  forall epsilon k_u k_v u v : R,
  epsilon > 0 ->
  u - epsilon >= 0 ->
  epsilon + u < 1 ->
  1 * (sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) >= 0 ->
  1 * (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v))) >= 0 ->
  1 * (sin (PI * (k_u * (u + 0)))) * (sin (PI * (k_v * v))) > 0 ->
  epsilon <> 0 /\
  ex_derive (fun u : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) u /\
  ex_derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u /\
  (1 / 2) * (Rabs ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v)))) - (Rabs ((sin (PI * (k_u * (u -
      epsilon)))) * (sin (PI * (k_v * v)))))) / epsilon = 1 * (1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI *
      (k_v * v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon /\
  (Derive (fun u : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) u) = 1 * (Derive (fun u : R => (sin (PI
      * (k_u * u))) * (sin (PI * (k_v * v)))) u).

Definition truncation_bound__ridges_u_below : Prop :=
  forall epsilon k_u k_v u v : R,
  epsilon > 0 ->
  u - epsilon >= 0 ->
  epsilon + u < 1 ->
  -(sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) >= 0 ->
  -(sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v))) >= 0 ->
  -(sin (PI * (k_u * (u + 0)))) * (sin (PI * (k_v * v))) > 0 ->
  epsilon <> 0 /\
  ex_derive (fun u : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) u /\
  ex_derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u /\
  (1 / 2) * (Rabs ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v)))) - (Rabs ((sin (PI * (k_u * (u -
      epsilon)))) * (sin (PI * (k_v * v)))))) / epsilon = -(1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI *
      (k_v * v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI * (k_v * v)))) / epsilon /\
  (Derive (fun u : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) u) = -(Derive (fun u : R => (sin (PI *
      (k_u * u))) * (sin (PI * (k_v * v)))) u).

Definition truncation_bound__ridges_v_above : Prop :=
  forall epsilon k_u k_v u v : R,
  epsilon > 0 ->
  v - epsilon >= 0 ->
  epsilon + v <= 1 ->
  1 * (sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon + v)))) >= 0 ->
  1 * (sin (PI * (k_u * u))) * (sin (PI * (k_v * (v - epsilon)))) >= 0 ->
  1 * (sin (PI * (k_u * u))) * (sin (PI * (k_v * (v + 0)))) > 0 ->
  2 * epsilon <> 0 /\
  ex_derive (fun v : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) v /\
  ex_derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v /\
  (Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon + v))))) - (Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v
      * (v - epsilon))))))) / (2 * epsilon) = 1 * ((sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon + v)))) - (sin
      (PI * (k_u * u))) * (sin (PI * (k_v * (v - epsilon))))) / (2 * epsilon) /\
  (Derive (fun v : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) v) = 1 * (Derive (fun v : R => (sin (PI
      * (k_u * u))) * (sin (PI * (k_v * v)))) v).

Definition truncation_bound__ridges_v_below : Prop :=
  forall epsilon k_u k_v u v : R,
  epsilon > 0 ->
  v - epsilon >= 0 ->
  epsilon + v <= 1 ->
  -(sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon + v)))) >= 0 ->
  -(sin (PI * (k_u * u))) * (sin (PI * (k_v * (v - epsilon)))) >= 0 ->
  -(sin (PI * (k_u * u))) * (sin (PI * (k_v * (v + 0)))) > 0 ->
  2 * epsilon <> 0 /\
  ex_derive (fun v : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) v /\
  ex_derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v /\
  (Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon + v))))) - (Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v
      * (v - epsilon))))))) / (2 * epsilon) = -((sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon + v)))) - (sin (PI *
      (k_u * u))) * (sin (PI * (k_v * (v - epsilon))))) / (2 * epsilon) /\
  (Derive (fun v : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) v) = -(Derive (fun v : R => (sin (PI *
      (k_u * u))) * (sin (PI * (k_v * v)))) v).

Definition truncation_bound__apart : Prop :=
  forall frequency quotient slope : R,
  PI * frequency - quotient >= 0 ->
  PI * frequency + quotient >= 0 ->
  PI * frequency - slope >= 0 ->
  PI * frequency + slope >= 0 ->
  2 * PI * frequency - (quotient - slope) >= 0 /\
  2 * PI * frequency + quotient - slope >= 0.

Definition tangent_frame__derivatives : Prop :=
  forall phi theta : R,
  ex_derive (fun phi : R => (sin phi) * (cos theta)) phi /\
  ex_derive (fun phi : R => (sin phi) * (sin theta)) phi /\
  ex_derive (fun phi : R => cos phi) phi /\
  ex_derive (fun theta : R => (sin phi) * (cos theta)) theta /\
  ex_derive (fun theta : R => (sin phi) * (sin theta)) theta /\
  ex_derive (fun theta : R => cos phi) theta /\
  (cos phi) * (cos theta) = (Derive (fun phi : R => (sin phi) * (cos theta)) phi) /\
  (sin theta) * (cos phi) = (Derive (fun phi : R => (sin phi) * (sin theta)) phi) /\
  -(sin phi) = (Derive (fun phi : R => cos phi) phi) /\
  (sin phi) * (-(sin theta)) = (Derive (fun theta : R => (sin phi) * (cos theta)) theta) /\
  (sin phi) * (cos theta) = (Derive (fun theta : R => (sin phi) * (sin theta)) theta) /\
  0 * (sin phi) = (Derive (fun theta : R => cos phi) theta).

Definition tangent_frame__orthonormal : Prop :=
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
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  e_theta_z * e_theta_z + e_theta_x * e_theta_x + e_theta_y * e_theta_y = 1 /\
  e_phi_z * e_phi_z + e_phi_x * e_phi_x + e_phi_y * e_phi_y = 1 /\
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 /\
  e_phi_z * e_theta_z + e_phi_x * e_theta_x + e_phi_y * e_theta_y = 0 /\
  e_theta_z * normal_z + e_theta_x * normal_x + e_theta_y * normal_y = 0 /\
  e_phi_z * normal_z + e_phi_x * normal_x + e_phi_y * normal_y = 0.

Definition tangent_frame__right_handed : Prop :=
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
  e_phi_y * e_theta_z - e_phi_z * e_theta_y = normal_x /\
  e_phi_z * e_theta_x - e_phi_x * e_theta_z = normal_y /\
  e_phi_x * e_theta_y - e_phi_y * e_theta_x = normal_z.

Definition seed_bump_as_displacement__parallel : Prop :=
  ~ (
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
  sin_phi <> 0 ->
  normal_z * (m_x * (-beta) * (e_phi_y * h_v + e_theta_y * (1 / 2) * h_u / sin_phi) - (-1) * beta * m_y * (e_phi_x * h_v
      + e_theta_x * (1 / 2) * h_u / sin_phi)) + normal_x * (m_y * (-beta) * (e_phi_z * h_v + e_theta_z * (1 / 2) * h_u /
      sin_phi) - (-1) * beta * m_z * (e_phi_y * h_v + e_theta_y * (1 / 2) * h_u / sin_phi)) + normal_y * (m_z * (-beta)
      * (e_phi_x * h_v + e_theta_x * (1 / 2) * h_u / sin_phi) - (-1) * beta * m_x * (e_phi_z * h_v + e_theta_z * (1 / 2)
      * h_u / sin_phi)) = 0).

Definition enclosing_rules__sum : Prop :=
  forall slack x x_error x_exact y y_error y_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  float64 y ->
  float64 y_error ->
  0 <= y_error ->
  Rabs (y - y_exact) <= slack * (y_error / 2 ^ 53) ->
  float64 (enclosed_sum_float64.total_error x x_error y y_error) /\
  0 <= enclosed_sum_float64.total_error x x_error y y_error /\
  Rabs (enclosed_sum_float64.total x y - (x_exact + y_exact)) <= slack * (1 + 1 / 2 ^ 49) *
      (enclosed_sum_float64.total_error x x_error y y_error / 2 ^ 53).

Definition enclosing_rules__product : Prop :=
  forall slack x x_error x_exact y y_error y_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  float64 y ->
  float64 y_error ->
  0 <= y_error ->
  Rabs (y - y_exact) <= slack * (y_error / 2 ^ 53) ->
  x_error <= 2 ^ 60 ->
  y_error <= 2 ^ 60 ->
  float64 (enclosed_product_float64.product_error x x_error y y_error) /\
  0 <= enclosed_product_float64.product_error x x_error y y_error /\
  Rabs (enclosed_product_float64.product x y - (x_exact * y_exact)) <= slack * (1 + 1 / 2 ^ 49) *
      (enclosed_product_float64.product_error x x_error y y_error / 2 ^ 53).

Definition enclosing_rules__quotient : Prop :=
  forall slack x x_error x_exact y y_error y_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  float64 y ->
  float64 y_error ->
  0 <= y_error ->
  Rabs (y - y_exact) <= slack * (y_error / 2 ^ 53) ->
  Rabs y <= 2 ^ 960 ->
  Rabs y - (1 / 9007199254740992) * y_error * (/ 524288 + 1) >= / 576460752303423488 ->
  y_exact <> 0 /\
  float64 (enclosed_quotient_float64.quotient_error x x_error y y_error) /\
  0 <= enclosed_quotient_float64.quotient_error x x_error y y_error /\
  Rabs (enclosed_quotient_float64.quotient x y - (x_exact / y_exact)) <= slack * (1 + 1 / 2 ^ 49) *
      (enclosed_quotient_float64.quotient_error x x_error y y_error / 2 ^ 53).

Definition enclosing_rules__root : Prop :=
  forall slack x x_error x_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  x >= 0 ->
  x_exact >= 0 ->
  x_exact >= 0 /\
  float64 (enclosed_root_float64.root_error x x_error) /\
  0 <= enclosed_root_float64.root_error x x_error /\
  Rabs (enclosed_root_float64.root x - (sqrt x_exact)) <= slack * (1 + 1 / 2 ^ 49) * (enclosed_root_float64.root_error x
      x_error / 2 ^ 53).

Definition enclosing_rules__floor : Prop :=
  forall slack x x_error x_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  x_error <= 2 ^ 60 ->
  float64 (enclosed_floor_float64.below_error x x_error) /\
  0 <= enclosed_floor_float64.below_error x x_error /\
  Rabs (enclosed_floor_float64.below x - (IZR (Int_part x_exact))) <= slack * (1 + 1 / 2 ^ 49) *
      (enclosed_floor_float64.below_error x x_error / 2 ^ 53).

Definition enclosing_rules__nearest : Prop :=
  forall slack x x_error x_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  x_error <= 2 ^ 60 ->
  float64 (enclosed_nearest_float64.nearest_error x x_error) /\
  0 <= enclosed_nearest_float64.nearest_error x x_error /\
  Rabs (enclosed_nearest_float64.nearest x - (rint x_exact)) <= slack * (1 + 1 / 2 ^ 49) *
      (enclosed_nearest_float64.nearest_error x x_error / 2 ^ 53).

Definition enclosing_rules__selection : Prop :=
  forall slack left left_error left_exact right right_error right_exact x x_error x_exact y y_error y_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 left ->
  float64 left_error ->
  0 <= left_error ->
  Rabs (left - left_exact) <= slack * (left_error / 2 ^ 53) ->
  float64 right ->
  float64 right_error ->
  0 <= right_error ->
  Rabs (right - right_exact) <= slack * (right_error / 2 ^ 53) ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  float64 y ->
  float64 y_error ->
  0 <= y_error ->
  Rabs (y - y_exact) <= slack * (y_error / 2 ^ 53) ->
  float64 (enclosed_selection_float64.chosen_error left left_error right right_error x x_error y y_error) /\
  0 <= enclosed_selection_float64.chosen_error left left_error right right_error x x_error y y_error /\
  Rabs (enclosed_selection_float64.chosen left right x y - ((if Rlt_dec left_exact right_exact then x_exact else
      y_exact))) <= slack * (1 + 1 / 2 ^ 49) * (enclosed_selection_float64.chosen_error left left_error right
      right_error x x_error y y_error / 2 ^ 53).

Definition enclosing_rules__sine : Prop :=
  forall slack x x_error x_exact y y_error y_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  float64 y ->
  float64 y_error ->
  0 <= y_error ->
  Rabs (y - y_exact) <= slack * (y_error / 2 ^ 53) ->
  x_error <= 2 ^ 60 ->
  y_error <= 2 ^ 60 ->
  Rabs (x * y) <= 2 ^ 21 ->
  (10 ^ 285 * (Rabs (x * y)) >= 1 \/ x * y = 0) ->
  float64 (enclosed_sine_float64.sine_error x x_error y y_error) /\
  0 <= enclosed_sine_float64.sine_error x x_error y y_error /\
  Rabs (enclosed_sine_float64.sine x y - (sin (PI * (x_exact * y_exact)))) <= slack * (1 + 1 / 2 ^ 49) *
      (enclosed_sine_float64.sine_error x x_error y y_error / 2 ^ 53).

Definition enclosing_rules__cosine : Prop :=
  forall slack x x_error x_exact y y_error y_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  float64 y ->
  float64 y_error ->
  0 <= y_error ->
  Rabs (y - y_exact) <= slack * (y_error / 2 ^ 53) ->
  x_error <= 2 ^ 60 ->
  y_error <= 2 ^ 60 ->
  Rabs (x * y) <= 2 ^ 21 ->
  (10 ^ 285 * (Rabs (x * y)) >= 1 \/ x * y = 0) ->
  float64 (enclosed_cosine_float64.cosine_error x x_error y y_error) /\
  0 <= enclosed_cosine_float64.cosine_error x x_error y y_error /\
  Rabs (enclosed_cosine_float64.cosine x y - (cos (PI * (x_exact * y_exact)))) <= slack * (1 + 1 / 2 ^ 49) *
      (enclosed_cosine_float64.cosine_error x x_error y y_error / 2 ^ 53).

Definition enclosing_rules__angle : Prop :=
  forall slack x x_error x_exact y y_error y_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  float64 y ->
  float64 y_error ->
  0 <= y_error ->
  Rabs (y - y_exact) <= slack * (y_error / 2 ^ 53) ->
  x ^ 2 + y ^ 2 >= / 1024 ->
  float64 (enclosed_angle_float64.angle_error x x_error y y_error) /\
  0 <= enclosed_angle_float64.angle_error x x_error y y_error /\
  Rabs (enclosed_angle_float64.angle x y - (atan2pi y_exact x_exact)) <= slack * (1 + 1 / 2 ^ 49) *
      (enclosed_angle_float64.angle_error x x_error y y_error / 2 ^ 53).

Definition enclosing_rules__exponential : Prop :=
  forall slack x x_error x_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  x <= 704 ->
  x_error <= 2 ^ 55 ->
  (10 ^ 285 * (Rabs x) >= 1 \/ x = 0) ->
  float64 (enclosed_exponential_float64.exponential_error x x_error) /\
  0 <= enclosed_exponential_float64.exponential_error x x_error /\
  Rabs (enclosed_exponential_float64.exponential x - (exp x_exact)) <= slack * (1 + 1 / 2 ^ 49) *
      (enclosed_exponential_float64.exponential_error x x_error / 2 ^ 53).

Definition enclosing_rules__logarithm : Prop :=
  forall slack x x_error x_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  x <= 2 ^ 1000 ->
  x_error <= 2 ^ 52 * x ->
  10 ^ 285 * x >= 1 ->
  float64 (enclosed_logarithm_float64.logarithm_error x x_error) /\
  0 <= enclosed_logarithm_float64.logarithm_error x x_error /\
  Rabs (enclosed_logarithm_float64.logarithm x - (ln x_exact)) <= slack * (1 + 1 / 2 ^ 49) *
      (enclosed_logarithm_float64.logarithm_error x x_error / 2 ^ 53).

Definition enclosing_rules__power : Prop :=
  forall slack x x_error x_exact y y_error y_exact : R,
  1 <= slack ->
  slack <= 1 + 3 / 2 ^ 22 ->
  float64 x ->
  float64 x_error ->
  0 <= x_error ->
  Rabs (x - x_exact) <= slack * (x_error / 2 ^ 53) ->
  float64 y ->
  float64 y_error ->
  0 <= y_error ->
  Rabs (y - y_exact) <= slack * (y_error / 2 ^ 53) ->
  x >= 0 ->
  x_exact >= 0 ->
  y * (x + x_error / 4503599627370496 - 1) <= 32 ->
  (10 ^ 285 * (Rabs (x + x_error)) >= 1 \/ x + x_error = 0) ->
  1024 * y >= 1 ->
  y <= 524288 ->
  y_error <= 2251799813685248 * y ->
  x_exact >= 0 /\
  y_exact > 0 /\
  float64 (enclosed_power_float64.raised_error x x_error y y_error) /\
  0 <= enclosed_power_float64.raised_error x x_error y y_error /\
  Rabs (enclosed_power_float64.raised x y - (power x_exact y_exact)) <= slack * (1 + 1 / 2 ^ 49) *
      (enclosed_power_float64.raised_error x x_error y y_error / 2 ^ 53).

Definition central_difference_of_sine__no_clamp : Prop :=
  forall epsilon v : R,
  let v_plus := Rmin 1 (epsilon + v) in
  let v_minus := Rmax (v - epsilon) 0 in
  let span_v := (if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus) in
  epsilon > 0 ->
  v - epsilon >= 0 ->
  epsilon + v <= 1 ->
  v_plus = epsilon + v /\
  v_minus = v - epsilon /\
  span_v = 2 * epsilon.

Definition central_difference_of_sine__sine_in_u : Prop :=
  forall epsilon k_u k_v u v : R,
  epsilon > 0 ->
  u - epsilon >= 0 ->
  epsilon + u < 1 ->
  k_u > 0 ->
  epsilon <> 0 /\
  PI * k_u <> 0 /\
  epsilon * PI * k_u <> 0 /\
  2 * epsilon * (1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) - (sin (PI * (k_u * (u -
      epsilon)))) * (sin (PI * (k_v * v)))) / epsilon = 2 * PI * k_u * (cos (PI * (k_u * u))) * (sin (PI * (k_v * v))) /
      (PI * k_u) * (sin (epsilon * PI * k_u)) /\
  (1 / 2) * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) - (sin (PI * (k_u * (u - epsilon)))) * (sin (PI
      * (k_v * v)))) / epsilon = (sin (epsilon * PI * k_u)) / (epsilon * PI * k_u) * PI * k_u * (cos (PI * (k_u * u))) *
      (sin (PI * (k_v * v))).

Definition central_difference_of_sine__sine_in_v : Prop :=
  forall epsilon k_u k_v u v : R,
  epsilon > 0 ->
  v - epsilon >= 0 ->
  epsilon + v <= 1 ->
  k_v > 0 ->
  2 * epsilon <> 0 /\
  PI * k_v <> 0 /\
  epsilon * PI * k_v <> 0 /\
  2 * epsilon * ((sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon + v)))) - (sin (PI * (k_u * u))) * (sin (PI * (k_v
      * (v - epsilon))))) / (2 * epsilon) = 2 * PI * k_v * (cos (PI * (k_v * v))) * (sin (PI * (k_u * u))) / (PI * k_v)
      * (sin (epsilon * PI * k_v)) /\
  ((sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon + v)))) - (sin (PI * (k_u * u))) * (sin (PI * (k_v * (v -
      epsilon))))) / (2 * epsilon) = (sin (epsilon * PI * k_v)) / (epsilon * PI * k_v) * PI * k_v * (cos (PI * (k_v *
      v))) * (sin (PI * (k_u * u))).

Definition central_difference_of_sine__rings_in_v : Prop :=
  forall epsilon k_v v : R,
  epsilon > 0 ->
  v - epsilon >= 0 ->
  epsilon + v <= 1 ->
  k_v > 0 ->
  2 * epsilon <> 0 /\
  PI * 2 * k_v <> 0 /\
  epsilon * PI * 2 * k_v <> 0 /\
  2 * epsilon * (sin (PI * (2 * k_v * (epsilon + v))) - (sin (PI * (2 * k_v * (v - epsilon))))) / (2 * epsilon) = 2 * 2
      * PI * k_v * (cos (PI * (2 * k_v * v))) / (PI * 2 * k_v) * (sin (epsilon * PI * 2 * k_v)) /\
  (sin (PI * (2 * k_v * (epsilon + v))) - (sin (PI * (2 * k_v * (v - epsilon))))) / (2 * epsilon) = (sin (epsilon * PI *
      2 * k_v)) / (epsilon * PI * 2 * k_v) * 2 * PI * k_v * (cos (PI * (2 * k_v * v))).

Definition central_difference_of_sine__cosine : Prop :=
  forall epsilon k_u u : R,
  epsilon > 0 ->
  k_u > 0 ->
  2 * epsilon <> 0 /\
  epsilon * PI * k_u <> 0 /\
  (cos (PI * k_u * (epsilon + u)) - (cos (PI * k_u * (u - epsilon)))) / (2 * epsilon) = (-PI) * k_u * (sin (u * PI *
      k_u)) * (sin (epsilon * PI * k_u)) / (epsilon * PI * k_u).

Definition seed_orientation__left_handed : Prop :=
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

Definition hit_of_a__solves : Prop :=
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let hits_a := (if Rle_dec 0 discriminant_a then 1 else 0) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye ->
  discriminant_a >= 0 ->
  x ^ 2 + y ^ 2 >= 0 /\
  tangent_squared >= 0 /\
  tangent_squared <> 0 /\
  Rmax 0 discriminant_a >= 0 /\
  eye ^ 2 + root_a <> 0 /\
  hits_a = 1 /\
  (eye * (1 - t_a) + 0) ^ 2 + (t_a * y + 0) ^ 2 + (t_a * x + 0) ^ 2 + 0 = radius ^ 2 /\
  t_a > 0.

Definition hit_of_a__near : Prop :=
  forall eye radius t x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye ->
  discriminant_a >= 0 ->
  (eye * (1 - t) + 0) ^ 2 + (t * y + 0) ^ 2 + (t * x + 0) ^ 2 + 0 = radius ^ 2 ->
  x ^ 2 + y ^ 2 >= 0 /\
  tangent_squared >= 0 /\
  tangent_squared <> 0 /\
  Rmax 0 discriminant_a >= 0 /\
  eye ^ 2 + root_a <> 0 /\
  eye ^ 2 + rho ^ 2 > 0 /\
  t_a * (eye ^ 2 + rho ^ 2) = eye ^ 2 - root_a /\
  root_a + t * (eye ^ 2 + rho ^ 2) - eye ^ 2 >= 0 /\
  t >= t_a.

Definition hit_of_a__misses : Prop :=
  forall eye radius t x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let hits_a := (if Rle_dec 0 discriminant_a then 1 else 0) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye ->
  discriminant_a < 0 ->
  x ^ 2 + y ^ 2 >= 0 /\
  tangent_squared >= 0 /\
  tangent_squared <> 0 /\
  (eye * (1 - t) + 0) ^ 2 + (t * y + 0) ^ 2 + (t * x + 0) ^ 2 + 0 > radius ^ 2 /\
  hits_a = 0.

Definition gradients__sine : Prop :=
  forall epsilon k_u k_v u v : R,
  let cos_u := cos (PI * (k_u * u)) in
  let cos_v := cos (PI * (k_v * v)) in
  let sin_u := sin (PI * (k_u * u)) in
  let sin_v := sin (PI * (k_v * v)) in
  let h_u := PI * cos_u * k_u * sin_v in
  let h_v := PI * cos_v * k_v * sin_u in
  ex_derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u /\
  ex_derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v /\
  h_u = PI * k_u * (cos (u * PI * k_u)) * (sin (v * PI * k_v)) /\
  h_v = PI * k_v * (sin (u * PI * k_u)) * (cos (v * PI * k_v)) /\
  h_u = (Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u) /\
  h_v = (Derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v) /\
  PI * k_u * ((sin (PI * (k_u * (epsilon + u)))) * (sin (PI * (k_v * v))) - (sin (PI * (k_u * u))) * (sin (PI * (k_v *
      v)))) = h_u * (sin (epsilon * PI * k_u)) + PI * k_u * (sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) * (cos
      (epsilon * PI * k_u) - 1) /\
  PI * k_v * ((sin (PI * (k_u * u))) * (sin (PI * (k_v * (epsilon + v)))) - (sin (PI * (k_u * u))) * (sin (PI * (k_v *
      v)))) = h_v * (sin (epsilon * PI * k_v)) + PI * k_v * (sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) * (cos
      (epsilon * PI * k_v) - 1).

Definition gradients__rings : Prop :=
  forall epsilon k_v u v : R,
  let cos_v := cos (PI * (2 * k_v * v)) in
  let h_u := 0 in
  let h_v := 2 * PI * cos_v * k_v in
  ex_derive (fun u : R => sin (PI * (2 * k_v * v))) u /\
  ex_derive (fun v : R => sin (PI * (2 * k_v * v))) v /\
  h_v = 2 * PI * k_v * (cos (v * 2 * PI * k_v)) /\
  h_u = (Derive (fun u : R => sin (PI * (2 * k_v * v))) u) /\
  h_v = (Derive (fun v : R => sin (PI * (2 * k_v * v))) v) /\
  2 * PI * k_v * (sin (PI * (2 * k_v * (epsilon + v))) - (sin (PI * (2 * k_v * v)))) = h_v * (sin (epsilon * 2 * PI *
      k_v)) + 2 * PI * k_v * (sin (PI * (2 * k_v * v))) * (cos (epsilon * 2 * PI * k_v) - 1).

Definition gradients__ridges_above : Prop :=
  forall k_u k_v u v : R,
  let cos_u := cos (PI * (k_u * u)) in
  let cos_v := cos (PI * (k_v * v)) in
  let sin_u := sin (PI * (k_u * u)) in
  let sin_v := sin (PI * (k_v * v)) in
  let h_u := PI * cos_u * k_u * sin_v * (sign (sin_u * sin_v)) in
  let h_v := PI * cos_v * k_v * sin_u * (sign (sin_u * sin_v)) in
  1 * (sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) > 0 ->
  ex_derive (fun u : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) u /\
  ex_derive (fun v : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) v /\
  ex_derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u /\
  ex_derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v /\
  h_u = (Derive (fun u : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) u) /\
  h_v = (Derive (fun v : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) v) /\
  h_u = 1 * (Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u) /\
  h_v = 1 * (Derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v).

Definition gradients__ridges_below : Prop :=
  forall k_u k_v u v : R,
  let cos_u := cos (PI * (k_u * u)) in
  let cos_v := cos (PI * (k_v * v)) in
  let sin_u := sin (PI * (k_u * u)) in
  let sin_v := sin (PI * (k_v * v)) in
  let h_u := PI * cos_u * k_u * sin_v * (sign (sin_u * sin_v)) in
  let h_v := PI * cos_v * k_v * sin_u * (sign (sin_u * sin_v)) in
  -(sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) > 0 ->
  ex_derive (fun u : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) u /\
  ex_derive (fun v : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) v /\
  ex_derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u /\
  ex_derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v /\
  h_u = (Derive (fun u : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) u) /\
  h_v = (Derive (fun v : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) v) /\
  h_u = -(Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u) /\
  h_v = -(Derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v).

Definition gradients__ridges_on_creases : Prop :=
  forall k_u k_v u v : R,
  let cos_u := cos (PI * (k_u * u)) in
  let cos_v := cos (PI * (k_v * v)) in
  let sin_u := sin (PI * (k_u * u)) in
  let sin_v := sin (PI * (k_v * v)) in
  let h_u := PI * cos_u * k_u * sin_v * (sign (sin_u * sin_v)) in
  let h_v := PI * cos_v * k_v * sin_u * (sign (sin_u * sin_v)) in
  (sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) = 0 ->
  h_u = 0 /\
  h_v = 0.

Definition gradients__same_sign : Prop :=
  forall d p : R,
  p > 0 ->
  d + p >= 0 ->
  Rabs (d + p) = d * (sign p) + Rabs p.

Definition gradients__same_sign_below : Prop :=
  forall d p : R,
  p < 0 ->
  d + p <= 0 ->
  Rabs (d + p) = d * (sign p) + Rabs p.

Definition specular_lipschitz__along_a_direction : Prop :=
  forall apart m_x m_y m_z n_x n_y n_z omega_x omega_y omega_z : R,
  apart >= 0 ->
  apart ^ 2 = (n_z - m_z) * (n_z - m_z) + (n_x - m_x) * (n_x - m_x) + (n_y - m_y) * (n_y - m_y) ->
  omega_z * omega_z + omega_x * omega_x + omega_y * omega_y = 1 ->
  apart ^ 2 - (omega_z * (n_z - m_z) + omega_x * (n_x - m_x) + omega_y * (n_y - m_y)) ^ 2 >= 0 /\
  apart - (n_z * omega_z + n_x * omega_x + n_y * omega_y - (m_z * omega_z + m_x * omega_x + m_y * omega_y)) >= 0 /\
  apart + n_z * omega_z + n_x * omega_x + n_y * omega_y - (m_z * omega_z + m_x * omega_x + m_y * omega_y) >= 0.

Definition specular_lipschitz__gram : Prop :=
  forall m_x m_y m_z n_x n_y n_z omega_x omega_y omega_z : R,
  n_z * n_z + n_x * n_x + n_y * n_y = 1 ->
  m_z * m_z + m_x * m_x + m_y * m_y = 1 ->
  omega_z * omega_z + omega_x * omega_x + omega_y * omega_y = 1 ->
  (n_z * (m_x * omega_y - m_y * omega_x) + n_x * (m_y * omega_z - m_z * omega_y) + n_y * (m_z * omega_x - m_x *
      omega_z)) ^ 2 = (m_z * omega_z + m_x * omega_x + m_y * omega_y) * 2 * (n_z * omega_z + n_x * omega_x + n_y *
      omega_y) * (m_z * n_z + m_x * n_x + m_y * n_y) + 1 - (n_z * omega_z + n_x * omega_x + n_y * omega_y) ^ 2 - (m_z *
      omega_z + m_x * omega_x + m_y * omega_y) ^ 2 - (m_z * n_z + m_x * n_x + m_y * n_y) ^ 2.

Definition specular_lipschitz__mirror : Prop :=
  forall m_x m_y m_z n_x n_y n_z omega_x omega_y omega_z view_x view_y view_z : R,
  n_z * n_z + n_x * n_x + n_y * n_y = 1 ->
  m_z * m_z + m_x * m_x + m_y * m_y = 1 ->
  (n_x * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y) - omega_x - (m_x * 2 * (m_z * omega_z + m_x * omega_x + m_y
      * omega_y) - omega_x)) * (n_x * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y) - omega_x - (m_x * 2 * (m_z *
      omega_z + m_x * omega_x + m_y * omega_y) - omega_x)) + (n_y * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y)
      - omega_y - (m_y * 2 * (m_z * omega_z + m_x * omega_x + m_y * omega_y) - omega_y)) * (n_y * 2 * (n_z * omega_z +
      n_x * omega_x + n_y * omega_y) - omega_y - (m_y * 2 * (m_z * omega_z + m_x * omega_x + m_y * omega_y) - omega_y))
      + (n_z * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y) - omega_z - (m_z * 2 * (m_z * omega_z + m_x * omega_x
      + m_y * omega_y) - omega_z)) * (n_z * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y) - omega_z - (m_z * 2 *
      (m_z * omega_z + m_x * omega_x + m_y * omega_y) - omega_z)) = 4 * ((m_z * omega_z + m_x * omega_x + m_y * omega_y)
      ^ 2 + (n_z * omega_z + n_x * omega_x + n_y * omega_y) ^ 2 - 2 * (m_z * n_z + m_x * n_x + m_y * n_y) * (m_z *
      omega_z + m_x * omega_x + m_y * omega_y) * (n_z * omega_z + n_x * omega_x + n_y * omega_y)) /\
  (n_z - m_z) * (n_z - m_z) + (n_x - m_x) * (n_x - m_x) + (n_y - m_y) * (n_y - m_y) = 2 - 2 * (m_z * n_z + m_x * n_x +
      m_y * n_y) /\
  -omega_x * view_x - omega_y * view_y - omega_z * view_z + 2 * (n_x * omega_x + n_y * omega_y + n_z * omega_z) * (n_x *
      view_x + n_y * view_y + n_z * view_z) = view_z * (n_z * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y) -
      omega_z) + view_x * (n_x * 2 * (n_z * omega_z + n_x * omega_x + n_y * omega_y) - omega_x) + view_y * (n_y * 2 *
      (n_z * omega_z + n_x * omega_x + n_y * omega_y) - omega_y) /\
  -omega_x * view_x - omega_y * view_y - omega_z * view_z + 2 * (m_x * omega_x + m_y * omega_y + m_z * omega_z) * (m_x *
      view_x + m_y * view_y + m_z * view_z) = view_z * (m_z * 2 * (m_z * omega_z + m_x * omega_x + m_y * omega_y) -
      omega_z) + view_x * (m_x * 2 * (m_z * omega_z + m_x * omega_x + m_y * omega_y) - omega_x) + view_y * (m_y * 2 *
      (m_z * omega_z + m_x * omega_x + m_y * omega_y) - omega_y).

Definition specular_lipschitz__twice : Prop :=
  forall a apart b c turned : R,
  apart >= 0 ->
  c * 2 * a * b + 1 - a ^ 2 - b ^ 2 - c ^ 2 >= 0 ->
  turned ^ 2 = 4 * (a ^ 2 + b ^ 2 - 2 * a * b * c) ->
  apart ^ 2 = 2 - 2 * c ->
  4 * apart ^ 2 >= turned ^ 2 /\
  2 * apart >= turned.

Definition highlight_below_one__root : Prop :=
  ~ (
  forall bound x : R,
  x >= 0 ->
  x <= 1 ->
  bound >= 1 ->
  x >= 0 ->
  bound * x >= sqrt x).

Definition squared_highlight__base : Prop :=
  forall along_halfway halfway_length_plain halfway_squared light_distance light_scale specular_base_plain : R,
  halfway_squared * light_distance * light_scale = 1 ->
  halfway_length_plain ^ 2 * light_distance ^ 2 = halfway_squared ->
  specular_base_plain * halfway_length_plain * light_distance = along_halfway ->
  along_halfway ^ 2 * light_distance * light_scale = specular_base_plain ^ 2.

Definition squared_highlight__opposite : Prop :=
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
  let mu := (if Rlt_dec 0 halfway_squared then along_light * halfway_squared * light_scale else -bumped_x * view_x -
      bumped_y * view_y - bumped_z * view_z) in
  light_distance > 0 ->
  halfway_x = 0 ->
  halfway_y = 0 ->
  halfway_z = 0 ->
  distance_squared >= 0 /\
  (halfway_squared > 0 -> halfway_squared <> 0) /\
  (halfway_squared > 0 -> light_distance <> 0) /\
  mu = -(bumped_z * view_z + bumped_x * view_x + bumped_y * view_y).

Definition hit_of_b__quadratic : Prop :=
  forall ball_center_x ball_center_y ball_center_z ball_radius eye t x y : R,
  let distance := eye - ball_center_z in
  let toward_b := ball_center_x * x + ball_center_y * y + distance * eye in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 -
      (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  (eye * (1 - t) - ball_center_z) ^ 2 + (t * y - ball_center_y) ^ 2 + (t * x - ball_center_x) ^ 2 + 0 - ball_radius ^ 2
      = (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 - ball_radius ^ 2 + t ^ 2 *
      ((-eye) * (-eye) + x * x + y * y) - 2 * t * toward_b /\
  discriminant_b = toward_b ^ 2 - ((eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 -
      ball_radius ^ 2) * ((-eye) * (-eye) + x * x + y * y).

Definition hit_of_b__solves : Prop :=
  forall ball_center_x ball_center_y ball_center_z ball_on ball_radius eye x y : R,
  let distance := eye - ball_center_z in
  let toward_b := ball_center_x * x + ball_center_y * y + distance * eye in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 -
      (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  let root_b := sqrt (Rmax 0 discriminant_b) in
  let hits_b := (if both (both (Rlt_dec 0 ball_on) (Rle_dec 0 discriminant_b)) (Rlt_dec 0 toward_b) then 1 else 0) in
  let t_b := (ball_center_x ^ 2 + ball_center_y ^ 2 + (distance - ball_radius) * (ball_radius + distance)) / (root_b +
      toward_b) in
  (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 > ball_radius ^ 2 ->
  discriminant_b >= 0 ->
  toward_b > 0 ->
  ball_on > 0 ->
  Rmax 0 discriminant_b >= 0 /\
  root_b + toward_b <> 0 /\
  hits_b = 1 /\
  (eye * (1 - t_b) - ball_center_z) ^ 2 + (t_b * y - ball_center_y) ^ 2 + (t_b * x - ball_center_x) ^ 2 + 0 =
      ball_radius ^ 2 /\
  t_b > 0.

Definition hit_of_b__behind : Prop :=
  forall ball_center_x ball_center_y ball_center_z ball_on ball_radius eye t x y : R,
  let distance := eye - ball_center_z in
  let toward_b := ball_center_x * x + ball_center_y * y + distance * eye in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 -
      (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  let hits_b := (if both (both (Rlt_dec 0 ball_on) (Rle_dec 0 discriminant_b)) (Rlt_dec 0 toward_b) then 1 else 0) in
  (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 > ball_radius ^ 2 ->
  toward_b <= 0 ->
  (eye * (1 - t) - ball_center_z) ^ 2 + (t * y - ball_center_y) ^ 2 + (t * x - ball_center_x) ^ 2 + 0 = ball_radius ^ 2
     ->
  t < 0 /\
  hits_b = 0.

Definition hit_of_b__outward : Prop :=
  forall ball_center_x ball_center_y ball_center_z ball_on ball_radius eye x y : R,
  let distance := eye - ball_center_z in
  let toward_b := ball_center_x * x + ball_center_y * y + distance * eye in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 -
      (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  let root_b := sqrt (Rmax 0 discriminant_b) in
  let t_b := (ball_center_x ^ 2 + ball_center_y ^ 2 + (distance - ball_radius) * (ball_radius + distance)) / (root_b +
      toward_b) in
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
  let point_x := ball_center_x + ball_radius * normal_x in
  let point_y := ball_center_y + ball_radius * normal_y in
  let point_z := ball_center_z + ball_radius * normal_z in
  (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 > ball_radius ^ 2 ->
  discriminant_b >= 0 ->
  toward_b > 0 ->
  ball_on > 0 ->
  ball_radius > 0 ->
  Rmax 0 discriminant_b >= 0 /\
  root_b + toward_b <> 0 /\
  ray_length_squared <> 0 /\
  radius_vector_x ^ 2 + radius_vector_y ^ 2 + radius_vector_z ^ 2 >= 0 /\
  radius_length <> 0 /\
  ray_length_squared > 0 /\
  radius_vector_x = t_b * x - ball_center_x /\
  radius_vector_y = t_b * y - ball_center_y /\
  radius_vector_z = eye * (1 - t_b) - ball_center_z /\
  radius_length = ball_radius /\
  ball_radius * normal_x = t_b * x - ball_center_x /\
  ball_radius * normal_y = t_b * y - ball_center_y /\
  ball_radius * normal_z = eye * (1 - t_b) - ball_center_z /\
  point_x = t_b * x /\
  point_y = t_b * y /\
  point_z = eye * (1 - t_b).

Definition seed_quadratic_of_b__constant : Prop :=
  ~ (
  forall ball_center_x ball_center_y ball_center_z ball_radius eye : R,
  ball_center_z ^ 2 + ball_center_y ^ 2 + ball_center_x ^ 2 + 0 - ball_radius ^ 2 = (eye - ball_center_z) ^ 2 + (0 -
      ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 - ball_radius ^ 2).

Definition ridges_on_creases__crease_in_u : Prop :=
  forall k_u k_v m to_u v : R,
  k_u > 0 ->
  to_u > 0 ->
  k_u * to_u <= 1 ->
  sin (PI * m) = 0 ->
  k_u <> 0 /\
  Rabs (sin (PI * (k_u * (1 * to_u + m / k_u)))) >= sin (to_u * PI * k_u) /\
  sin (to_u * PI * k_u) >= Rabs (sin (PI * (k_u * (1 * to_u + m / k_u)))) /\
  Rabs (sin (PI * (k_u * (1 * to_u + m / k_u)))) = sin (to_u * PI * k_u) /\
  Rabs (sin (PI * (k_u * (m / k_u - to_u)))) >= sin (to_u * PI * k_u) /\
  sin (to_u * PI * k_u) >= Rabs (sin (PI * (k_u * (m / k_u - to_u)))) /\
  Rabs (sin (PI * (k_u * (m / k_u - to_u)))) = sin (to_u * PI * k_u) /\
  Rabs ((sin (PI * (k_u * (1 * to_u + m / k_u)))) * (sin (PI * (k_v * v)))) = (sin (to_u * PI * k_u)) * (Rabs (sin (v *
      PI * k_v))) /\
  Rabs ((sin (PI * (k_u * (m / k_u - to_u)))) * (sin (PI * (k_v * v)))) = (sin (to_u * PI * k_u)) * (Rabs (sin (v * PI *
      k_v))) /\
  to_u * PI * k_u * (Rabs (sin (v * PI * k_v))) >= Rabs ((sin (PI * (k_u * (1 * to_u + m / k_u)))) * (sin (PI * (k_v *
      v)))) /\
  Rabs ((sin (PI * (k_u * (1 * to_u + m / k_u)))) * (sin (PI * (k_v * v)))) >= to_u * PI * k_u * (Rabs (sin (v * PI *
      k_v))) * (1 - (1 / 6) * PI ^ 2 * k_u ^ 2 * to_u ^ 2).

Definition ridges_on_creases__crease_in_v : Prop :=
  forall k_u k_v m to_v u : R,
  k_v > 0 ->
  to_v > 0 ->
  k_v * to_v <= 1 ->
  sin (PI * m) = 0 ->
  k_v <> 0 /\
  Rabs (sin (PI * (k_v * (1 * to_v + m / k_v)))) >= sin (to_v * PI * k_v) /\
  sin (to_v * PI * k_v) >= Rabs (sin (PI * (k_v * (1 * to_v + m / k_v)))) /\
  Rabs (sin (PI * (k_v * (1 * to_v + m / k_v)))) = sin (to_v * PI * k_v) /\
  Rabs (sin (PI * (k_v * (m / k_v - to_v)))) >= sin (to_v * PI * k_v) /\
  sin (to_v * PI * k_v) >= Rabs (sin (PI * (k_v * (m / k_v - to_v)))) /\
  Rabs (sin (PI * (k_v * (m / k_v - to_v)))) = sin (to_v * PI * k_v) /\
  Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * (1 * to_v + m / k_v))))) = (sin (to_v * PI * k_v)) * (Rabs (sin (u *
      PI * k_u))) /\
  Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * (m / k_v - to_v))))) = (sin (to_v * PI * k_v)) * (Rabs (sin (u * PI *
      k_u))) /\
  to_v * PI * k_v * (Rabs (sin (u * PI * k_u))) >= Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * (1 * to_v + m /
      k_v))))) /\
  Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * (1 * to_v + m / k_v))))) >= to_v * PI * k_v * (Rabs (sin (u * PI *
      k_u))) * (1 - (1 / 6) * PI ^ 2 * k_v ^ 2 * to_v ^ 2).

Definition ridges_on_creases__differ : Prop :=
  forall angle left right slope : R,
  slope > 0 ->
  angle ^ 2 <= 1 ->
  6 * right >= slope * (6 - angle ^ 2) ->
  left = -right ->
  6 * right >= 5 * slope /\
  right - left > slope.

Definition gradient_accuracy__sine : Prop :=
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
  Rabs (gradient_sine_float64.h_u u v k_u k_v - gradient_sine.h_u u v k_u k_v) <= 10 / 9007199254740992 * PI * (Rmax 1
      (Rabs k_u)) /\
  Rabs (gradient_sine_float64.h_v u v k_u k_v - gradient_sine.h_v u v k_u k_v) <= 10 / 9007199254740992 * PI * (Rmax 1
      (Rabs k_v)).

Definition gradient_accuracy__ridges : Prop :=
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
  Rabs (gradient_ridges_float64.h_u u v k_u k_v - gradient_ridges.h_u u v k_u k_v) <= 10 / 9007199254740992 * PI * (Rmax
      1 (Rabs k_u)) /\
  Rabs (gradient_ridges_float64.h_v u v k_u k_v - gradient_ridges.h_v u v k_u k_v) <= 10 / 9007199254740992 * PI * (Rmax
      1 (Rabs k_v)).

Definition gradient_accuracy__rings : Prop :=
  forall v k_v : R,
  float64 v ->
  float64 k_v ->
  v >= 0 ->
  v <= 1 ->
  Rabs k_v <= 1048576 ->
  (10 ^ 285 * (Rabs (k_v * v)) >= 1 \/ k_v * v = 0) ->
  Rabs (gradient_rings_float64.h_v v k_v - gradient_rings.h_v v k_v) <= 10 / 9007199254740992 * PI * (Rmax 1 (Rabs (2 *
      k_v))).

Definition rounded_powers__three_roundings_of_one : Prop :=
  forall first growth second third unit : R,
  unit >= 0 ->
  unit <= (1 / 4) ->
  unit - first >= 0 ->
  first + unit >= 0 ->
  unit - second >= 0 ->
  second + unit >= 0 ->
  unit - third >= 0 ->
  third + unit >= 0 ->
  growth = (first + 1) * (second + 1) * (third + 1) ->
  (unit + 1) ^ 2 - (first + 1) * (second + 1) >= 0 /\
  (first + 1) * (second + 1) - (1 - unit) ^ 2 >= 0 /\
  (unit + 1) ^ 3 - 1 - (growth - 1) >= 0 /\
  growth - 1 + (unit + 1) ^ 3 - 1 >= 0.

Definition rounded_powers__square : Prop :=
  forall excess first imaginary_part off_first off_second real_part second : R,
  off_first = first * (real_part - imaginary_part) * (imaginary_part + real_part) ->
  off_second = second * 2 * imaginary_part * real_part ->
  excess - first >= 0 ->
  excess + first >= 0 ->
  excess - second >= 0 ->
  excess + second >= 0 ->
  (2 * imaginary_part * real_part) ^ 2 + ((real_part - imaginary_part) * (imaginary_part + real_part)) ^ 2 =
      (imaginary_part ^ 2 + real_part ^ 2) ^ 2 /\
  excess ^ 2 - first ^ 2 >= 0 /\
  excess ^ 2 - second ^ 2 >= 0 /\
  excess ^ 2 * (imaginary_part ^ 2 + real_part ^ 2) ^ 2 >= off_first ^ 2 + off_second ^ 2.

Definition rounded_powers__product : Prop :=
  forall excess first fourth imaginary_part off_first off_second other_imaginary other_real real_part second third unit :
    R,
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
  (other_real * real_part - imaginary_part * other_imaginary) ^ 2 + (imaginary_part * other_real + other_imaginary *
      real_part) ^ 2 = (imaginary_part ^ 2 + real_part ^ 2) * (other_imaginary ^ 2 + other_real ^ 2) /\
  (unit ^ 2 + 2 * unit) ^ 2 - first ^ 2 >= 0 /\
  (unit ^ 2 + 2 * unit) ^ 2 - second ^ 2 >= 0 /\
  (unit ^ 2 + 2 * unit) ^ 2 - third ^ 2 >= 0 /\
  (unit ^ 2 + 2 * unit) ^ 2 - fourth ^ 2 >= 0 /\
  2 * (unit ^ 2 + 2 * unit) ^ 2 * ((imaginary_part * other_imaginary) ^ 2 + (other_real * real_part) ^ 2) >= off_first ^
      2 /\
  2 * (unit ^ 2 + 2 * unit) ^ 2 * ((imaginary_part * other_real) ^ 2 + (other_imaginary * real_part) ^ 2) >= off_second
      ^ 2 /\
  excess ^ 2 >= 2 * (unit ^ 2 + 2 * unit) ^ 2 /\
  excess ^ 2 * (imaginary_part ^ 2 + real_part ^ 2) * (other_imaginary ^ 2 + other_real ^ 2) >= off_first ^ 2 +
      off_second ^ 2.

Definition rounded_powers__power : Prop :=
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
  most >= size /\
  most_other >= other_size /\
  most * most_other >= other_size * size /\
  most_other * excess * most >= own /\
  most_other * (most - 1) >= off_first * other_size /\
  most_other * most * (excess + 1) - 1 >= off.

Definition rounded_powers__factors : Prop :=
  forall exact most most_other other_exact other_value value : R,
  1 - exact >= 0 ->
  exact + 1 >= 0 ->
  1 - other_exact >= 0 ->
  other_exact + 1 >= 0 ->
  most - 1 - (value - exact) >= 0 ->
  value - exact + most - 1 >= 0 ->
  most_other - 1 - (other_value - other_exact) >= 0 ->
  most_other - 1 + other_value - other_exact >= 0 ->
  most_other - other_value >= 0 /\
  most_other + other_value >= 0 /\
  most_other * (most - 1) - other_value * (value - exact) >= 0 /\
  most_other * (most - 1) + other_value * (value - exact) >= 0 /\
  most_other - 1 - exact * (other_value - other_exact) >= 0 /\
  exact * (other_value - other_exact) + most_other - 1 >= 0 /\
  most * most_other - 1 - (other_value * value - exact * other_exact) >= 0 /\
  other_value * value - exact * other_exact + most * most_other - 1 >= 0.

Definition roundoff_bound__in_u : Prop :=
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
  epsilon <> 0 /\
  2 * epsilon <> 0 /\
  2 * (argument * steepest + evaluation) - (off_plus - off_minus) >= 0 /\
  off_plus - off_minus + 2 * (argument * steepest + evaluation) >= 0 /\
  (excess + 1) * 2 * (argument * steepest + evaluation) - growth * (off_plus - off_minus) >= 0 /\
  growth * (off_plus - off_minus) + (excess + 1) * 2 * (argument * steepest + evaluation) >= 0 /\
  excess * steepest - mean * (growth - 1) >= 0 /\
  excess * steepest + mean * (growth - 1) >= 0 /\
  2 * epsilon * (growth * h_u - mean) = growth * (off_plus - off_minus) + 2 * epsilon * mean * (growth - 1) /\
  2 * epsilon * (excess * steepest + (excess + 1) * (2 * argument * steepest + 2 * evaluation) / (2 * epsilon)) - 2 *
      epsilon * (growth * h_u - mean) >= 0 /\
  2 * epsilon * (excess * steepest + (excess + 1) * (2 * argument * steepest + 2 * evaluation) / (2 * epsilon)) + 2 *
      epsilon * (growth * h_u - mean) >= 0 /\
  excess * steepest + (excess + 1) * (2 * argument * steepest + 2 * evaluation) / (2 * epsilon) - (growth * h_u - mean)
      >= 0 /\
  excess * steepest + (excess + 1) * (2 * argument * steepest + 2 * evaluation) / (2 * epsilon) + growth * h_u - mean >=
     0.

Definition roundoff_bound__two_roundings : Prop :=
  forall first growth second unit : R,
  unit > 0 ->
  unit < 1 ->
  unit - first >= 0 ->
  first + unit >= 0 ->
  unit - second >= 0 ->
  second + unit >= 0 ->
  growth = (first + 1) * (second + 1) ->
  unit ^ 2 + 2 * unit - (growth - 1) >= 0 /\
  growth - 1 + unit ^ 2 + 2 * unit >= 0.

Definition roundoff_bound__three_roundings : Prop :=
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
  1 - unit <> 0 /\
  (unit + 1) ^ 2 - (first + 1) * (second + 1) >= 0 /\
  (first + 1) * (second + 1) - (1 - unit) ^ 2 >= 0 /\
  (unit ^ 2 + 3 * unit) / (1 - unit) * (1 - unit) - (1 - unit) * (growth - 1) >= 0 /\
  (unit ^ 2 + 3 * unit) / (1 - unit) * (1 - unit) + (1 - unit) * (growth - 1) >= 0 /\
  (unit ^ 2 + 3 * unit) / (1 - unit) - (growth - 1) >= 0 /\
  growth - 1 + (unit ^ 2 + 3 * unit) / (1 - unit) >= 0.

Definition seed_step_in_beta__verifies : Prop :=
  ~ (
  forall beta g_x g_y g_z normal_x normal_y normal_z : R,
  normal_z * normal_z + normal_x * normal_x + normal_y * normal_y = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 ->
  (g_x * (beta + (1 / 10000000)) + normal_x) ^ 2 + (g_y * (beta + (1 / 10000000)) + normal_y) ^ 2 + (g_z * (beta + (1 /
      10000000)) + normal_z) ^ 2 >= 0 ->
  sqrt ((g_x * (beta + (1 / 10000000)) + normal_x) ^ 2 + (g_y * (beta + (1 / 10000000)) + normal_y) ^ 2 + (g_z * (beta +
      (1 / 10000000)) + normal_z) ^ 2) <> 0 ->
  (beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2 >= 0 ->
  sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2) <> 0 ->
  (1 / 1000000000000) >= Rabs (((g_x * (beta + (1 / 10000000)) + normal_x) / sqrt ((g_x * (beta + (1 / 10000000)) +
      normal_x) ^ 2 + (g_y * (beta + (1 / 10000000)) + normal_y) ^ 2 + (g_z * (beta + (1 / 10000000)) + normal_z) ^ 2) -
      (beta * g_x + normal_x) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z +
      normal_z) ^ 2)) / ((1 / 10000000)) - (g_x - (beta * g_x + normal_x) * (g_x * (beta * g_x + normal_x) / sqrt ((beta
      * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2) + g_y * (beta * g_y + normal_y)
      / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2) + g_z * (beta *
      g_z + normal_z) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2))
      / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2)) / sqrt ((beta *
      g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2))).

Definition lagrange_identity__of_b : Prop :=
  forall ball_center_x ball_center_y ball_center_z ball_radius eye x y : R,
  let distance := eye - ball_center_z in
  let toward_b := ball_center_x * x + ball_center_y * y + distance * eye in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 -
      (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  discriminant_b = toward_b ^ 2 - ((eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 -
      ball_radius ^ 2) * ((-eye) * (-eye) + x * x + y * y).

Definition lagrange_identity__of_shadow : Prop :=
  forall body_radius center_x center_y center_z light_x light_y light_z point_x point_y point_z : R,
  let segment_x := light_x - point_x in
  let segment_y := light_y - point_y in
  let segment_z := light_z - point_z in
  let offset_x := center_x - point_x in
  let offset_y := center_y - point_y in
  let offset_z := center_z - point_z in
  let segment_squared := segment_x ^ 2 + segment_y ^ 2 + segment_z ^ 2 in
  let toward_center := offset_x * segment_x + offset_y * segment_y + offset_z * segment_z in
  let shadow_discriminant := body_radius ^ 2 * segment_squared - (offset_y * segment_x - offset_x * segment_y) ^ 2 -
      (offset_x * segment_z - offset_z * segment_x) ^ 2 - (offset_z * segment_y - offset_y * segment_z) ^ 2 in
  shadow_discriminant = toward_center ^ 2 - segment_squared * (offset_z * offset_z + offset_x * offset_x + offset_y *
      offset_y - body_radius ^ 2).

Definition shadow_out_of_reach__within : Prop :=
  forall ball_radius share to_ball_x to_ball_y to_ball_z : R,
  ball_radius ^ 2 >= to_ball_z * to_ball_z + to_ball_x * to_ball_x + to_ball_y * to_ball_y ->
  (ball_radius * share) ^ 2 >= (share * to_ball_z) ^ 2 + (share * to_ball_y) ^ 2 + (share * to_ball_x) ^ 2 + 0.

Definition shadow_out_of_reach__cone : Prop :=
  forall aside_x aside_y aside_z axis_x axis_y axis_z body_radius distance product reach wander : R,
  body_radius > 0 ->
  wander >= 0 ->
  reach >= wander ->
  distance > body_radius + reach ->
  distance ^ 2 = axis_z * axis_z + axis_x * axis_x + axis_y * axis_y ->
  wander ^ 2 = aside_z * aside_z + aside_x * aside_x + aside_y * aside_y ->
  product = aside_z * axis_z + aside_x * axis_x + aside_y * axis_y ->
  distance ^ 2 * wander ^ 2 - product ^ 2 = (aside_y * axis_x - aside_x * axis_y) * (aside_y * axis_x - aside_x *
      axis_y) + (aside_x * axis_z - aside_z * axis_x) * (aside_x * axis_z - aside_z * axis_x) + (aside_z * axis_y -
      aside_y * axis_z) * (aside_z * axis_y - aside_y * axis_z) /\
  distance ^ 2 * wander ^ 2 - product ^ 2 >= 0 /\
  distance * wander >= 0 /\
  distance * wander + product >= 0 /\
  (aside_z + axis_z) * (aside_z + axis_z) + (aside_x + axis_x) * (aside_x + axis_x) + (aside_y + axis_y) * (aside_y +
      axis_y) = (distance - wander) ^ 2 + 2 * (distance * wander + product) /\
  distance - wander > body_radius /\
  (distance - wander) ^ 2 > body_radius ^ 2 /\
  (aside_z + axis_z) * (aside_z + axis_z) + (aside_x + axis_x) * (aside_x + axis_x) + (aside_y + axis_y) * (aside_y +
      axis_y) > body_radius ^ 2.

Definition shadow_out_of_reach__quadratic : Prop :=
  forall ball_center_x ball_center_y ball_center_z ball_radius body_radius center_x center_y center_z light_x light_y
    light_z share : R,
  let from_body_x := light_x - center_x in
  let from_body_y := light_y - center_y in
  let from_body_z := light_z - center_z in
  let along_x := ball_center_x - light_x in
  let along_y := ball_center_y - light_y in
  let along_z := ball_center_z - light_z in
  let at_light := from_body_x ^ 2 - body_radius ^ 2 + from_body_y ^ 2 + from_body_z ^ 2 in
  let half_slope := along_x * from_body_x + along_y * from_body_y + along_z * from_body_z - ball_radius * body_radius in
  let curvature := along_x ^ 2 + along_y ^ 2 + along_z ^ 2 - ball_radius ^ 2 in
  (along_z * share + from_body_z) * (along_z * share + from_body_z) + (along_x * share + from_body_x) * (along_x * share
      + from_body_x) + (along_y * share + from_body_y) * (along_y * share + from_body_y) - (ball_radius * share +
      body_radius) ^ 2 = at_light + share * (curvature * share + 2 * half_slope).

Definition shadow_out_of_reach__turns_before : Prop :=
  forall bend low share slope : R,
  share >= 0 ->
  bend > 0 ->
  slope >= 0 ->
  low + share * (bend * share + 2 * slope) >= low.

Definition shadow_out_of_reach__turns_between : Prop :=
  forall at_ bend low share slope : R,
  bend > 0 ->
  at_ * bend + slope = 0 ->
  low + share * (bend * share + 2 * slope) >= at_ * (at_ * bend + 2 * slope) + low.

Definition shadow_out_of_reach__turns_after : Prop :=
  forall bend low share slope : R,
  share <= 1 ->
  bend > 0 ->
  bend + slope <= 0 ->
  low + share * (bend * share + 2 * slope) >= bend + low + 2 * slope.

Definition shadow_out_of_reach__bends_down : Prop :=
  forall bend low share slope : R,
  share >= 0 ->
  share <= 1 ->
  bend <= 0 ->
  low + share * (bend * share + 2 * slope) >= low * (1 - share) + share * (bend + low + 2 * slope).

Definition pole__sine : Prop :=
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
  g_x = PI * k_v * (sin (k_u * (theta + PI) / 2)) * (cos theta) /\
  g_y = PI * k_v * (sin (k_u * (theta + PI) / 2)) * (sin theta) /\
  g_z = 0 * PI * k_v * (sin (k_u * (theta + PI) / 2)) /\
  g_z * g_z + g_x * g_x + g_y * g_y = (PI * k_v * (sin (k_u * (theta + PI) / 2))) ^ 2.

Definition pole__sine_seam : Prop :=
  forall k_u k_v : R,
  let cos_u := cos (PI * (k_u * (PI - PI) / (2 * PI))) in
  let cos_v := cos (PI * (0 * k_v)) in
  let sin_u := sin (PI * (k_u * (PI - PI) / (2 * PI))) in
  let sin_v := sin (PI * (0 * k_v)) in
  let h_u := PI * cos_u * k_u * sin_v in
  let h_v := PI * cos_v * k_v * sin_u in
  let e_theta_x := -(sin (-PI)) in
  let e_theta_y := cos (-PI) in
  let e_theta_z := 0 in
  let e_phi_x := 1 * (cos (-PI)) in
  let e_phi_y := 1 * (sin (-PI)) in
  let e_phi_z := -0 in
  let g_x := e_phi_x * h_v + e_theta_x * h_u in
  let g_y := e_phi_y * h_v + e_theta_y * h_u in
  let g_z := e_phi_z * h_v + e_theta_z * h_u in
  g_x = 0 /\
  g_y = 0 /\
  g_z = 0.

Definition pole__sine_k_u_0 : Prop :=
  forall k_v theta : R,
  let cos_u := cos (PI * (0 * (theta + PI) / (2 * PI))) in
  let cos_v := cos (PI * (0 * k_v)) in
  let sin_u := sin (PI * (0 * (theta + PI) / (2 * PI))) in
  let sin_v := sin (PI * (0 * k_v)) in
  let h_u := 0 * PI * cos_u * sin_v in
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
  g_x = 0 /\
  g_y = 0 /\
  g_z = 0.

Definition pole__sine_k_v_0 : Prop :=
  forall k_u theta : R,
  let cos_u := cos (PI * (k_u * (theta + PI) / (2 * PI))) in
  let cos_v := cos (PI * (0 * 0)) in
  let sin_u := sin (PI * (k_u * (theta + PI) / (2 * PI))) in
  let sin_v := sin (PI * (0 * 0)) in
  let h_u := PI * cos_u * k_u * sin_v in
  let h_v := 0 * PI * cos_v * sin_u in
  let e_theta_x := -(sin theta) in
  let e_theta_y := cos theta in
  let e_theta_z := 0 in
  let e_phi_x := 1 * (cos theta) in
  let e_phi_y := 1 * (sin theta) in
  let e_phi_z := -0 in
  let g_x := e_phi_x * h_v + e_theta_x * h_u in
  let g_y := e_phi_y * h_v + e_theta_y * h_u in
  let g_z := e_phi_z * h_v + e_theta_z * h_u in
  g_x = 0 /\
  g_y = 0 /\
  g_z = 0.

Definition pole__sine_differs : Prop :=
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
  k_v ^ 2 > 0 ->
  (sin (k_u * (theta + PI) / 2)) ^ 2 > 0 ->
  g_z * g_z + g_x * g_x + g_y * g_y = (PI * k_v * (sin (k_u * (theta + PI) / 2))) ^ 2 /\
  (k_v * (sin (k_u * (theta + PI) / 2))) ^ 2 > 0 /\
  g_z * g_z + g_x * g_x + g_y * g_y > 0.

Definition pole__surface_gradient : Prop :=
  forall k_u theta : R,
  let surface_x := k_u / 2 * (cos (k_u * (theta + PI) / 2)) * (-(sin theta)) + (sin (k_u * (theta + PI) / 2)) * (cos
      theta) in
  let surface_y := k_u / 2 * (cos (k_u * (theta + PI) / 2)) * (cos theta) + (sin theta) * (sin (k_u * (theta + PI) / 2))
      in
  surface_x * surface_x + surface_y * surface_y = k_u ^ 2 / 4 + (1 - (1 / 4) * k_u ^ 2) * (sin (k_u * (theta + PI) / 2))
      ^ 2.

Definition pole__surface_gradient_0 : Prop :=
  forall theta : R,
  let surface_x := 0 / 2 * (cos (0 * (theta + PI) / 2)) * (-(sin theta)) + (sin (0 * (theta + PI) / 2)) * (cos theta) in
  let surface_y := 0 / 2 * (cos (0 * (theta + PI) / 2)) * (cos theta) + (sin theta) * (sin (0 * (theta + PI) / 2)) in
  surface_x = 0 /\
  surface_y = 0.

Definition pole__surface_gradient_2 : Prop :=
  forall theta : R,
  let surface_x := 2 / 2 * (cos (2 * (theta + PI) / 2)) * (-(sin theta)) + (sin (2 * (theta + PI) / 2)) * (cos theta) in
  let surface_y := (sin theta) * (sin (2 * (theta + PI) / 2)) + 2 / 2 * (cos (2 * (theta + PI) / 2)) * (cos theta) in
  surface_x = 0 /\
  surface_y = -1.

Definition pole__surface_gradient_minus_2 : Prop :=
  forall theta : R,
  let surface_x := (-2 / 2) * (cos ((-2 * (theta + PI)) / 2)) * (-(sin theta)) + (sin ((-2 * (theta + PI)) / 2)) * (cos
      theta) in
  let surface_y := (sin theta) * (sin ((-2 * (theta + PI)) / 2)) + (-2 / 2) * (cos ((-2 * (theta + PI)) / 2)) * (cos
      theta) in
  surface_x = 0 /\
  surface_y = 1.

Definition pole__polynomial : Prop :=
  forall phi theta : R,
  forall chebyshev following : nat -> R,
  chebyshev 0%nat = 0 ->
  (forall n : nat, chebyshev (S n) = following n) ->
  following 0%nat = 1 ->
  (forall n : nat, following (S n) = (following n) * 2 * (cos phi) - (chebyshev n)) ->
  forall n : nat,
  sin ((INR n) * phi) = (chebyshev n) * (sin phi) /\
  sin (phi * (INR n + 1)) = (following n) * (sin phi) /\
  (sin (PI * ((INR n) * phi / PI))) * (sin (PI * (2 * (theta + PI) / (2 * PI)))) = (chebyshev n) * (-(sin phi) * (sin
      theta)).

Definition sine_is_smooth_everywhere__one_limit : Prop :=
  ~ (
  forall k_u k_v theta : R,
  k_v * (sin theta) * (sin (k_u * (theta + PI) / 2)) = k_v * (sin (-PI)) * (sin (k_u * (PI - PI) / 2))).

Definition seed_pole_rows__beside : Prop :=
  ~ (
  forall m n : R,
  (m - 128) * (m - 127) >= 0 ->
  (n - 109) * (n - 108) >= 0 ->
  (n - 110) * (n - 107) <= 0 ->
  ((1 / 10000) * (4 / 3)) ^ 2 > (5 / 3) * (((2 * m - 256 + 1) / 256) ^ 2 + 0 + ((-2 * n - 1 + 256) / 256 + (-3 / 20)) ^
      2)).

Definition ridges_at_crossings__crossing : Prop :=
  forall k_u k_v m n to_u to_v : R,
  k_u > 0 ->
  k_v > 0 ->
  sin (PI * m) = 0 ->
  sin (PI * n) = 0 ->
  k_u <> 0 /\
  k_v <> 0 /\
  (Rabs ((sin (PI * (k_u * (to_u + m / k_u)))) * (sin (PI * (k_v * (to_v + n / k_v)))))) ^ 2 = ((sin (to_u * PI * k_u))
      * (sin (to_v * PI * k_v))) ^ 2 /\
  ((sin (to_u * PI * k_u)) ^ 2 + (sin (to_v * PI * k_v)) ^ 2) ^ 2 >= 4 * (Rabs ((sin (PI * (k_u * (to_u + m / k_u)))) *
      (sin (PI * (k_v * (to_v + n / k_v)))))) ^ 2 /\
  (to_u * PI * k_u) ^ 2 + (to_v * PI * k_v) ^ 2 >= (sin (to_u * PI * k_u)) ^ 2 + (sin (to_v * PI * k_v)) ^ 2.

Definition ridges_at_crossings__flat : Prop :=
  forall a b distance h small_enough steepest : R,
  h >= 0 ->
  (a ^ 2 + b ^ 2) ^ 2 >= 4 * h ^ 2 ->
  distance * steepest >= a ^ 2 + b ^ 2 ->
  distance >= 0 ->
  4 * small_enough ^ 2 >= distance * steepest ^ 2 ->
  a ^ 2 + b ^ 2 >= 2 * h /\
  (distance * steepest) ^ 2 >= (2 * h) ^ 2 /\
  distance * small_enough ^ 2 >= h ^ 2.

Definition ridges_differentiable__one_slope : Prop :=
  ~ (
  forall k_u k_v u v : R,
  sin (u * PI * k_u) = 0 ->
  Rabs (k_u * (cos (PI * (k_u * u))) * (sin (PI * (k_v * v)))) = -(Rabs (k_u * (cos (PI * (k_u * u))) * (sin (PI * (k_v
      * v)))))).

Definition best_step__least : Prop :=
  forall best epsilon rounding truncation : R,
  truncation > 0 ->
  best > 0 ->
  epsilon > 0 ->
  rounding = 2 * best ^ 3 * truncation ->
  epsilon <> 0 /\
  best <> 0 /\
  best * truncation > 0 /\
  best ^ 2 > 0 /\
  rounding > 0 /\
  truncation * (2 * best + epsilon) >= 0 /\
  epsilon * (epsilon ^ 2 * truncation - 3 * best ^ 2 * truncation) + rounding >= 0 /\
  epsilon ^ 2 * truncation + rounding / epsilon >= 3 * best ^ 2 * truncation /\
  best ^ 2 * truncation + rounding / best = 3 * best ^ 2 * truncation /\
  (3 * best ^ 2 * truncation) ^ 3 = rounding ^ 2 * (27 / 4) * truncation.

Definition periodic_u_saves_the_seam__slope : Prop :=
  ~ (
  forall k_u k_v v : R,
  sin (PI * k_u) = 0 ->
  k_u * (cos (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - k_u * (cos (PI * (1 * k_u))) * (sin (PI * (k_v * v))) = 0).

Definition mean_keeps_the_bound__one_more : Prop :=
  forall bound mean sample share : R,
  share >= 0 ->
  share <= 1 ->
  bound - mean >= 0 ->
  bound + mean >= 0 ->
  bound - sample >= 0 ->
  bound + sample >= 0 ->
  bound - (mean + share * (sample - mean)) >= 0 /\
  bound + mean + share * (sample - mean) >= 0.

Definition third_derivative_at_eight__at_eight : Prop :=
  (8 * PI) ^ 3 > 13824 /\
  13824 > 12000.

Definition third_derivative_at_eight__at_four : Prop :=
  (4 * PI) ^ 3 > 1728 /\
  1987 > (4 * PI) ^ 3.

Definition clamped_difference_of_odd__odd : Prop :=
  forall k_u k_v u v : R,
  let h_sine := (sin (PI * (k_u * u))) * (sin (PI * (k_v * (-v)))) in
  let h_rings := sin (PI * (2 * (-1) * k_v * v)) in
  let h_ridge := (sin ((-v) * PI * k_v)) * (Rabs (sin (u * PI * k_u))) in
  h_sine = -(sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) /\
  h_rings = -(sin (PI * (2 * k_v * v))) /\
  h_ridge = -(sin (v * PI * k_v)) * (Rabs (sin (u * PI * k_u))).

Definition clamped_difference_of_odd__first_ridge : Prop :=
  forall k_u k_v u v : R,
  k_v > 0 ->
  v >= 0 ->
  1 - k_v * v >= 0 ->
  (sin (v * PI * k_v)) * (Rabs (sin (u * PI * k_u))) >= 0 /\
  (sin (v * PI * k_v)) * (Rabs (sin (u * PI * k_u))) >= Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) /\
  Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) >= (sin (v * PI * k_v)) * (Rabs (sin (u * PI * k_u))) /\
  Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) = (sin (v * PI * k_v)) * (Rabs (sin (u * PI * k_u))).

Definition clamped_difference_of_odd__second_order_sharp : Prop :=
  forall epsilon v : R,
  epsilon > 0 ->
  v >= 0 ->
  v - epsilon < 0 ->
  epsilon + v <= 1 ->
  epsilon + v - 0 <> 0 /\
  ((1 / 6) * (epsilon + v) ^ 3 - (1 / 6) * 0 ^ 3) / (epsilon + v - 0) - (1 / 2) * v ^ 2 = 1 * ((1 / 6) * epsilon ^ 2 +
      (1 / 3) * epsilon * v - (1 / 3) * v ^ 2).

Definition displaced_normal__product : Prop :=
  forall beta h h_phi h_theta phi phi_0 theta theta_0 : R,
  theta = theta_0 ->
  phi = phi_0 ->
  sin phi > 0 ->
  ex_derive (fun phi : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0))
      + 1)) phi /\
  ex_derive (fun theta : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) theta
     /\
  ex_derive (fun phi : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos phi)) phi /\
  ex_derive (fun theta : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta -
      theta_0)) + 1)) theta /\
  sin phi <> 0 /\
  ex_derive (fun theta : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta -
      theta_0)) + 1)) theta /\
  ex_derive (fun phi : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0))
      + 1)) phi /\
  (Derive (fun phi : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) +
      1)) phi) * (Derive (fun theta : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) * (cos
      phi)) theta) - (Derive (fun theta : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta *
      (theta - theta_0)) + 1)) theta) * (Derive (fun phi : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta -
      theta_0)) + 1) * (cos phi)) phi) = (beta * h + 1) * (sin phi) * ((sin phi) * (cos theta) * (beta * h + 1) - beta *
      (h_phi * (cos phi) * (cos theta) + h_theta * (-(sin theta)) / (sin phi))) /\
  (Derive (fun theta : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0))
      + 1)) theta) * (Derive (fun phi : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1) *
      (cos phi)) phi) - (Derive (fun phi : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta *
      (theta - theta_0)) + 1)) phi) * (Derive (fun theta : R => (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta -
      theta_0)) + 1) * (cos phi)) theta) = (beta * h + 1) * (sin phi) * ((sin phi) * (sin theta) * (beta * h + 1) - beta
      * (h_phi * (sin theta) * (cos phi) + h_theta * (cos theta) / (sin phi))) /\
  (Derive (fun theta : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta * (theta - theta_0))
      + 1)) theta) * (Derive (fun phi : R => (sin phi) * (cos theta) * (beta * (h_phi * (phi - phi_0) + h + h_theta *
      (theta - theta_0)) + 1)) phi) - (Derive (fun phi : R => (sin phi) * (sin theta) * (beta * (h_phi * (phi - phi_0) +
      h + h_theta * (theta - theta_0)) + 1)) phi) * (Derive (fun theta : R => (sin phi) * (cos theta) * (beta * (h_phi *
      (phi - phi_0) + h + h_theta * (theta - theta_0)) + 1)) theta) = (beta * h + 1) * (sin phi) * ((beta * h + 1) *
      (cos phi) - beta * (h_phi * (-(sin phi)) + 0 * h_theta / (sin phi))).

Definition displaced_normal__outward : Prop :=
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
  beta * h + 1 > 0 ->
  sin_phi <> 0 /\
  displaced_z * normal_z + displaced_x * normal_x + displaced_y * normal_y = lift /\
  displaced_z * normal_z + displaced_x * normal_x + displaced_y * normal_y > 0.

Definition displaced_normal__first_order : Prop :=
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
  sin_phi <> 0 /\
  lift * (1 * normal_x - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi)) - displaced_x = (-beta ^ 2) * h *
      (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi) /\
  lift * (1 * normal_y - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi)) - displaced_y = (-beta ^ 2) * h *
      (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi) /\
  lift * (1 * normal_z - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi)) - displaced_z = (-beta ^ 2) * h *
      (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi) /\
  (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi) * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi) + (e_phi_x *
      h_phi + e_theta_x * h_theta / sin_phi) * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi) + (e_phi_y * h_phi +
      e_theta_y * h_theta / sin_phi) * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi) = h_phi ^ 2 + (h_theta /
      sin_phi) ^ 2 /\
  displaced_y * (1 * normal_z - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi)) - displaced_z * (1 * normal_y
      - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi)) = (-beta ^ 2) * h * (normal_y * (e_phi_z * h_phi +
      e_theta_z * h_theta / sin_phi) - normal_z * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi)) /\
  displaced_z * (1 * normal_x - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi)) - displaced_x * (1 * normal_z
      - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi)) = (-beta ^ 2) * h * (normal_z * (e_phi_x * h_phi +
      e_theta_x * h_theta / sin_phi) - normal_x * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi)) /\
  displaced_x * (1 * normal_y - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi)) - displaced_y * (1 * normal_x
      - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi)) = (-beta ^ 2) * h * (normal_x * (e_phi_y * h_phi +
      e_theta_y * h_theta / sin_phi) - normal_y * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi)).

Definition unit_length__g_is_tangent : Prop :=
  forall cos_phi cos_theta h_u h_v sin_phi sin_theta : R,
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
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  g_z * normal_z + g_x * normal_x + g_y * normal_y = 0 /\
  g_z * g_z + g_x * g_x + g_y * g_y = h_u ^ 2 + h_v ^ 2.

Definition unit_length__length : Prop :=
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
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 /\
  m_length <> 0 /\
  m_z * m_z + m_x * m_x + m_y * m_y = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) + 1 /\
  m_z * m_z + m_x * m_x + m_y * m_y >= 1 /\
  m_length >= 1 /\
  m_length ^ 2 = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) + 1 /\
  bumped_z * bumped_z + bumped_x * bumped_x + bumped_y * bumped_y = 1.

Definition stable_frame__angles : Prop :=
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  let rho_inverse := (if Rlt_dec 0 rho then / rho else 0) in
  let hit_scale := 1 / (radius * (eye ^ 2 + root_a)) in
  let cos_theta := rho_inverse * x in
  let sin_theta := rho_inverse * y in
  let sin_phi := hit_scale * rho * tangent_squared in
  let cos_phi := eye * hit_scale * (radius ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye ->
  discriminant_a >= 0 ->
  x ^ 2 + y ^ 2 >= 0 /\
  tangent_squared >= 0 /\
  tangent_squared <> 0 /\
  Rmax 0 discriminant_a >= 0 /\
  eye ^ 2 + root_a <> 0 /\
  (rho > 0 -> rho <> 0) /\
  radius <> 0 /\
  rho > 0 /\
  t_a > 0 /\
  radius * sin_phi = rho * t_a /\
  cos_phi * radius = eye * (1 - t_a) /\
  cos_theta * radius * sin_phi = t_a * x /\
  sin_theta * radius * sin_phi = t_a * y /\
  cos_theta ^ 2 + sin_theta ^ 2 = 1 /\
  cos_phi ^ 2 + sin_phi ^ 2 = 1 /\
  sin_phi > 0.

Definition stable_frame__seed_frame : Prop :=
  forall cos_phi cos_theta sin_phi sin_theta : R,
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  let e_theta_x := -sin_theta in
  let e_theta_y := cos_theta in
  let e_phi_x := cos_phi * cos_theta in
  let e_phi_y := cos_phi * sin_theta in
  let e_phi_z := -sin_phi in
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi > 0 ->
  1 - normal_z ^ 2 >= 0 /\
  sqrt (1 - normal_z ^ 2) <> 0 /\
  sqrt (1 - normal_z ^ 2) = sin_phi /\
  -normal_y / sqrt (1 - normal_z ^ 2) = e_theta_x /\
  normal_x / sqrt (1 - normal_z ^ 2) = e_theta_y /\
  normal_x * normal_z / sqrt (1 - normal_z ^ 2) = e_phi_x /\
  normal_y * normal_z / sqrt (1 - normal_z ^ 2) = e_phi_y /\
  -sqrt (1 - normal_z ^ 2) = e_phi_z.

Definition silhouette_of_a__quadratic : Prop :=
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye ->
  x ^ 2 + y ^ 2 >= 0 /\
  tangent_squared >= 0 /\
  tangent_squared <> 0 /\
  discriminant_a = eye ^ 4 - (eye ^ 2 - radius ^ 2) * (eye ^ 2 + rho ^ 2).

Definition silhouette_of_a__inside : Prop :=
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye ->
  rho <= rho_silhouette ->
  x ^ 2 + y ^ 2 >= 0 /\
  tangent_squared >= 0 /\
  tangent_squared <> 0 /\
  tangent_squared > 0 /\
  rho + rho_silhouette > 0 /\
  tangent_squared * (rho_silhouette - rho) >= 0 /\
  discriminant_a >= 0.

Definition silhouette_of_a__only_inside : Prop :=
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye ->
  discriminant_a >= 0 ->
  x ^ 2 + y ^ 2 >= 0 /\
  tangent_squared >= 0 /\
  tangent_squared <> 0 /\
  rho_silhouette > 0 /\
  rho <= rho_silhouette.

Definition silhouette_of_a__in_front : Prop :=
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye ->
  discriminant_a >= 0 ->
  x ^ 2 + y ^ 2 >= 0 /\
  tangent_squared >= 0 /\
  tangent_squared <> 0 /\
  Rmax 0 discriminant_a >= 0 /\
  eye ^ 2 + root_a <> 0 /\
  t_a > 0 /\
  1 > t_a.

Definition silhouette_of_a__tangent : Prop :=
  forall eye radius x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye ->
  (eye ^ 2 - radius ^ 2) * (x ^ 2 + y ^ 2) = eye ^ 2 * radius ^ 2 ->
  x ^ 2 + y ^ 2 >= 0 /\
  tangent_squared >= 0 /\
  tangent_squared <> 0 /\
  eye ^ 2 <> 0 /\
  discriminant_a = 0 /\
  rho ^ 2 = rho_silhouette ^ 2 /\
  eye * (1 - (1 - radius ^ 2 / (eye ^ 2))) * eye * (1 - (1 - radius ^ 2 / (eye ^ 2))) + x * (1 - radius ^ 2 / (eye ^ 2))
      * x * (1 - radius ^ 2 / (eye ^ 2)) + y * (1 - radius ^ 2 / (eye ^ 2)) * y * (1 - radius ^ 2 / (eye ^ 2)) = radius
      ^ 2 /\
  (-eye) * eye * (1 - (1 - radius ^ 2 / (eye ^ 2))) + x * x * (1 - radius ^ 2 / (eye ^ 2)) + y * y * (1 - radius ^ 2 /
      (eye ^ 2)) = 0 /\
  eye * eye * (1 - (1 - radius ^ 2 / (eye ^ 2))) = radius ^ 2.

Definition seed_covers_the_view__covers : Prop :=
  forall x y : R,
  x >= -2 ->
  x <= 2 ->
  y >= -2 ->
  y <= 2 ->
  (1 / 2) * x + (1 / 2) * y + 4 * (4 - (13 / 10)) > (1 / 4) * 35 /\
  ((1 / 2) * x + (1 / 2) * y + 4 * (4 - (13 / 10))) ^ 2 > (1225 / 16) /\
  ((1 / 2) * x + (1 / 2) * y + 4 * (4 - (13 / 10))) ^ 2 - (0 + ((1 / 2)) ^ 2 + ((1 / 2)) ^ 2 + ((13 / 10)) ^ 2 - ((8 /
      25)) ^ 2) * (x * x + y * y + (-4) * (-4)) > 0.

Definition seed_covers_the_view__before : Prop :=
  forall b d : R,
  b > (1 / 4) * 35 ->
  d > 0 ->
  d >= 0 /\
  b + sqrt d <> 0 /\
  b + sqrt d > (1 / 4) * 35 /\
  (0 + ((1 / 2)) ^ 2 + ((1 / 2)) ^ 2 + ((13 / 10)) ^ 2 - ((8 / 25)) ^ 2) / (b + sqrt d) > 0 /\
  (1 / 4) > (0 + ((1 / 2)) ^ 2 + ((1 / 2)) ^ 2 + ((13 / 10)) ^ 2 - ((8 / 25)) ^ 2) / (b + sqrt d).

Definition seed_covers_the_view__behind : Prop :=
  forall eye radius t x y : R,
  radius > 0 ->
  eye * (1 - t) * eye * (1 - t) + t * x * t * x + t * y * t * y = radius ^ 2 ->
  radius >= eye * (1 - t) /\
  eye * t >= eye - radius.

Definition seam__parity : Prop :=
  forall alternating : nat -> R,
  alternating 0%nat = 1 ->
  (forall n : nat, alternating (S n) = -(alternating n)) ->
  forall n : nat,
  cos (PI * (INR n)) = alternating n /\
  sin (PI * (INR n)) = 0 /\
  cos (2 * PI * (INR n)) = 1.

Definition seam__sine : Prop :=
  forall k_u k_v u v : R,
  let h_jump := (sin (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - (sin (PI * (1 * k_u))) * (sin (PI * (k_v * v))) in
  let slope_jump := PI * k_u * (cos (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - PI * k_u * (cos (PI * (1 * k_u))) *
      (sin (PI * (k_v * v))) in
  h_jump = (-(sin (PI * k_u))) * (sin (PI * (k_v * v))) /\
  slope_jump = PI * k_u * (1 - (cos (PI * k_u))) * (sin (PI * (k_v * v))) /\
  (sin (PI * (k_u * (u + 1)))) * (sin (PI * (k_v * v))) = (sin (PI * k_u)) * (cos (u * PI * k_u)) * (sin (PI * (k_v *
      v))) + (sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) * (cos (PI * k_u)).

Definition seam__even : Prop :=
  forall k_u k_v u v : R,
  cos (PI * k_u) = 1 ->
  (sin (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - (sin (PI * (1 * k_u))) * (sin (PI * (k_v * v))) = 0 /\
  PI * k_u * (cos (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - PI * k_u * (cos (PI * (1 * k_u))) * (sin (PI * (k_v *
      v))) = 0 /\
  PI * k_v * (cos (PI * (k_v * v))) * (sin (PI * (0 * k_u))) - PI * k_v * (cos (PI * (k_v * v))) * (sin (PI * (1 *
      k_u))) = 0 /\
  (sin (PI * (k_u * (u + 1)))) * (sin (PI * (k_v * v))) = (sin (PI * (k_u * u))) * (sin (PI * (k_v * v))).

Definition seam__odd : Prop :=
  forall k_u k_v v : R,
  cos (PI * k_u) = -1 ->
  (sin (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - (sin (PI * (1 * k_u))) * (sin (PI * (k_v * v))) = 0 /\
  PI * k_u * (cos (PI * (0 * k_u))) * (sin (PI * (k_v * v))) - PI * k_u * (cos (PI * (1 * k_u))) * (sin (PI * (k_v *
      v))) = 2 * PI * k_u * (sin (PI * (k_v * v))).

Definition seam__ridges : Prop :=
  forall k_u k_v v : R,
  let h_first := Rabs ((sin (PI * (0 * k_u))) * (sin (PI * (k_v * v)))) in
  let h_last := Rabs ((sin (PI * (1 * k_u))) * (sin (PI * (k_v * v)))) in
  sin (PI * k_u) = 0 ->
  h_first = 0 /\
  h_last = 0.

Definition seam__ridges_crease : Prop :=
  forall k_u k_v step v : R,
  sin (PI * k_u) = 0 ->
  (Rabs ((sin (PI * (k_u * step))) * (sin (PI * (k_v * v))))) ^ 2 = (sin (step * PI * k_u)) ^ 2 * (sin (PI * (k_v * v)))
      ^ 2 /\
  (Rabs ((sin (PI * (k_u * (1 - step)))) * (sin (PI * (k_v * v))))) ^ 2 = (Rabs ((sin (PI * (k_u * step))) * (sin (PI *
      (k_v * v))))) ^ 2 /\
  Rabs ((sin (PI * (k_u * step))) * (sin (PI * (k_v * v)))) >= Rabs ((sin (PI * (k_u * (1 - step)))) * (sin (PI * (k_v *
      v)))) /\
  Rabs ((sin (PI * (k_u * (1 - step)))) * (sin (PI * (k_v * v)))) >= Rabs ((sin (PI * (k_u * step))) * (sin (PI * (k_v *
      v)))).

Definition seam__ridges_jump : Prop :=
  forall k_u k_v v : R,
  (sin (PI * k_u)) ^ 2 > 0 ->
  (sin (PI * (k_v * v))) ^ 2 > 0 ->
  -(Rabs ((sin (PI * (0 * k_u))) * (sin (PI * (k_v * v)))) - (Rabs ((sin (PI * (1 * k_u))) * (sin (PI * (k_v * v)))))) >
     0.

Definition seam__rings : Prop :=
  forall k_v u v : R,
  ex_derive (fun u : R => sin (PI * (2 * k_v * v))) u /\
  (Derive (fun u : R => sin (PI * (2 * k_v * v))) u) = 0.

Definition occlusion_by_signs__if : Prop :=
  forall a b c d : R,
  a >= 0 ->
  c > 0 ->
  d = b ^ 2 - a * c ->
  d >= 0 ->
  b > 0 ->
  b < a ->
  d >= 0 /\
  a <> 0 /\
  a > 0 /\
  (b - sqrt d) * (b + sqrt d) = a * c /\
  b + sqrt d > 0 /\
  b - sqrt d > 0 /\
  (a - b - sqrt d) * (sqrt d + a - b) = a * (c + a - 2 * b) /\
  sqrt d + a - b > 0 /\
  / a > 0 /\
  (b - sqrt d) / a > 0 /\
  1 > (b - sqrt d) / a /\
  c + a * ((b - sqrt d) / a) ^ 2 - 2 * b * (b - sqrt d) / a = 0.

Definition occlusion_by_signs__only_if : Prop :=
  forall a b c d s : R,
  a >= 0 ->
  c > 0 ->
  d = b ^ 2 - a * c ->
  c + a - 2 * b > 0 ->
  s > 0 ->
  s < 1 ->
  c + a * s ^ 2 - 2 * b * s = 0 ->
  b > 0 /\
  a - b > 0 /\
  (a * s - b) ^ 2 = d /\
  d >= 0.

Definition silhouette_of_b__conic : Prop :=
  forall ball_center_x ball_center_y ball_center_z ball_radius eye x y : R,
  let distance := eye - ball_center_z in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 -
      (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  discriminant_b = eye ^ 2 * ((eye - ball_center_z) ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z)
      ^ 2 - ball_radius ^ 2)) + y * 2 * ball_center_y * eye * (eye - ball_center_z) + x * 2 * ball_center_x * eye * (eye
      - ball_center_z) + y ^ 2 * (ball_center_y ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2
      - ball_radius ^ 2)) + x ^ 2 * (ball_center_x ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z)
      ^ 2 - ball_radius ^ 2)) + y * x * 2 * ball_center_x * ball_center_y /\
  (ball_center_x ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) *
      (ball_center_y ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) -
      (ball_center_x * ball_center_y) ^ 2 = ((eye - ball_center_z) ^ 2 - ball_radius ^ 2) * (ball_center_x ^ 2 +
      ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2) /\
  ball_center_x * eye * (eye - ball_center_z) * (ball_center_x * ball_center_y * ball_center_y * eye * (eye -
      ball_center_z) - ball_center_x * eye * (ball_center_y ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye -
      ball_center_z) ^ 2 - ball_radius ^ 2)) * (eye - ball_center_z)) + (ball_center_x ^ 2 - (ball_center_x ^ 2 +
      ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) * (eye ^ 2 * ((eye - ball_center_z) ^ 2 -
      (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) * (ball_center_y ^ 2 -
      (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) - (ball_center_y * eye *
      (eye - ball_center_z)) ^ 2) - ball_center_x * ball_center_y * (ball_center_x * ball_center_y * eye ^ 2 * ((eye -
      ball_center_z) ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) -
      ball_center_x * ball_center_y * eye ^ 2 * (eye - ball_center_z) ^ 2) = ball_radius ^ 2 * eye ^ 2 * (ball_center_x
      ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2) ^ 2.

Definition silhouette_of_b__ellipse : Prop :=
  forall ball_center_x ball_center_y ball_center_z ball_radius eye : R,
  (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 > ball_radius ^ 2 ->
  (eye - ball_center_z) ^ 2 > ball_radius ^ 2 ->
  ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2 > 0 /\
  (ball_center_x ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) *
      (ball_center_y ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) -
      (ball_center_x * ball_center_y) ^ 2 > 0.

Definition silhouette_of_b__parabola : Prop :=
  forall ball_center_x ball_center_y ball_center_z ball_radius eye : R,
  (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 > ball_radius ^ 2 ->
  (eye - ball_center_z) ^ 2 = ball_radius ^ 2 ->
  ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2 > 0 /\
  (ball_center_x ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) *
      (ball_center_y ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) -
      (ball_center_x * ball_center_y) ^ 2 = 0.

Definition silhouette_of_b__hyperbola : Prop :=
  forall ball_center_x ball_center_y ball_center_z ball_radius eye : R,
  (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 > ball_radius ^ 2 ->
  (eye - ball_center_z) ^ 2 < ball_radius ^ 2 ->
  ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2 > 0 /\
  0 > (ball_center_x ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) *
      (ball_center_y ^ 2 - (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2)) -
      (ball_center_x * ball_center_y) ^ 2.

Definition silhouette_of_b__branch : Prop :=
  forall ball_center_x ball_center_y ball_center_z ball_radius eye x y : R,
  let distance := eye - ball_center_z in
  let toward_b := ball_center_x * x + ball_center_y * y + distance * eye in
  let discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 -
      (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2 in
  eye > 0 ->
  (eye - ball_center_z) ^ 2 + (0 - ball_center_y) ^ 2 + (0 - ball_center_x) ^ 2 + 0 > ball_radius ^ 2 ->
  discriminant_b = 0 ->
  toward_b ^ 2 = (ball_center_x ^ 2 + ball_center_y ^ 2 + (eye - ball_center_z) ^ 2 - ball_radius ^ 2) * ((-eye) *
      (-eye) + x * x + y * y) /\
  (-eye) * (-eye) + x * x + y * y > 0 /\
  toward_b ^ 2 > 0.

Definition silhouette_of_b__all_seen : Prop :=
  forall ball_center_x ball_center_y ball_radius distance eye x y : R,
  eye > 0 ->
  ball_radius > 0 ->
  distance >= ball_radius ->
  distance ^ 2 + ball_center_x ^ 2 + ball_center_y ^ 2 - ball_radius ^ 2 > 0 ->
  (distance * eye + ball_center_x * x + ball_center_y * y) ^ 2 >= (distance ^ 2 + ball_center_x ^ 2 + ball_center_y ^ 2
      - ball_radius ^ 2) * (eye ^ 2 + x ^ 2 + y ^ 2) ->
  distance > 0 /\
  distance * eye > 0 /\
  (distance - ball_radius) * (ball_radius + distance) >= 0 /\
  x ^ 2 + y ^ 2 >= 0 /\
  (x ^ 2 + y ^ 2) * (distance ^ 2 + ball_center_x ^ 2 + ball_center_y ^ 2 - ball_radius ^ 2 - (ball_center_x ^ 2 +
      ball_center_y ^ 2)) >= 0 /\
  (ball_center_x ^ 2 + ball_center_y ^ 2) * (x ^ 2 + y ^ 2) >= (ball_center_x * x + ball_center_y * y) ^ 2 /\
  eye ^ 2 > 0 /\
  eye ^ 2 * (distance ^ 2 + ball_center_x ^ 2 + ball_center_y ^ 2 - ball_radius ^ 2) > 0 /\
  (distance ^ 2 + ball_center_x ^ 2 + ball_center_y ^ 2 - ball_radius ^ 2) * (eye ^ 2 + x ^ 2 + y ^ 2) > (ball_center_x
      * x + ball_center_y * y) ^ 2 /\
  (distance * eye + ball_center_x * x + ball_center_y * y) ^ 2 - (ball_center_x * x + ball_center_y * y) ^ 2 > 0 /\
  (distance * eye + ball_center_x * x + ball_center_y * y) ^ 2 - (ball_center_x * x + ball_center_y * y) ^ 2 = distance
      * eye * (2 * (distance * eye + ball_center_x * x + ball_center_y * y) - distance * eye) /\
  2 * (distance * eye + ball_center_x * x + ball_center_y * y) - distance * eye > 0 /\
  distance * eye + ball_center_x * x + ball_center_y * y > 0.

Definition silhouette_of_b__none_seen : Prop :=
  forall ball_center_x ball_center_y ball_radius distance eye x y : R,
  eye > 0 ->
  ball_radius > 0 ->
  -distance >= ball_radius ->
  distance ^ 2 + ball_center_x ^ 2 + ball_center_y ^ 2 - ball_radius ^ 2 > 0 ->
  (distance * eye + ball_center_x * x + ball_center_y * y) ^ 2 >= (distance ^ 2 + ball_center_x ^ 2 + ball_center_y ^ 2
      - ball_radius ^ 2) * (eye ^ 2 + x ^ 2 + y ^ 2) ->
  -distance > 0 /\
  distance * (-eye) > 0 /\
  (-ball_radius - distance) * (ball_radius - distance) >= 0 /\
  x ^ 2 + y ^ 2 >= 0 /\
  (x ^ 2 + y ^ 2) * (distance ^ 2 + ball_center_x ^ 2 + ball_center_y ^ 2 - ball_radius ^ 2 - (ball_center_x ^ 2 +
      ball_center_y ^ 2)) >= 0 /\
  (ball_center_x ^ 2 + ball_center_y ^ 2) * (x ^ 2 + y ^ 2) >= (ball_center_x * x + ball_center_y * y) ^ 2 /\
  eye ^ 2 > 0 /\
  eye ^ 2 * (distance ^ 2 + ball_center_x ^ 2 + ball_center_y ^ 2 - ball_radius ^ 2) > 0 /\
  (distance ^ 2 + ball_center_x ^ 2 + ball_center_y ^ 2 - ball_radius ^ 2) * (eye ^ 2 + x ^ 2 + y ^ 2) > (ball_center_x
      * x + ball_center_y * y) ^ 2 /\
  (distance * eye + ball_center_x * x + ball_center_y * y) ^ 2 - (ball_center_x * x + ball_center_y * y) ^ 2 > 0 /\
  (distance * eye + ball_center_x * x + ball_center_y * y) ^ 2 - (ball_center_x * x + ball_center_y * y) ^ 2 = distance
      * eye * (2 * (distance * eye + ball_center_x * x + ball_center_y * y) - distance * eye) /\
  distance * eye - 2 * (distance * eye + ball_center_x * x + ball_center_y * y) > 0 /\
  0 > distance * eye + ball_center_x * x + ball_center_y * y.

Definition crease_error_area__tent : Prop :=
  forall delta epsilon k_u : R,
  epsilon > 0 ->
  k_u > 0 ->
  delta > 0 ->
  epsilon - delta >= 0 ->
  1 - k_u * (delta + epsilon) >= 0 ->
  epsilon <> 0 /\
  PI * k_u <> 0 /\
  1 - (cos (delta * PI * k_u)) >= 0 /\
  1 - (cos (epsilon * PI * k_u)) >= 0 /\
  PI * k_u > 0 /\
  epsilon * PI * k_u > 0 /\
  epsilon * PI * k_u * ((sin (delta * PI * k_u)) * (cos (epsilon * PI * k_u)) / epsilon / (PI * k_u) - (cos (delta * PI
      * k_u)) - (-1) * PI * k_u * 1 / (PI * k_u) * (1 - delta / epsilon)) = epsilon * PI * k_u * (1 - (cos (delta * PI *
      k_u))) - (delta * PI * k_u - (sin (delta * PI * k_u)) * (cos (epsilon * PI * k_u))) /\
  epsilon * PI * k_u - PI * delta * k_u >= 0 /\
  (epsilon * PI * k_u) ^ 2 - (delta * PI * k_u) ^ 2 >= 0 /\
  (epsilon * PI * k_u) ^ 3 / 6 - (delta * PI * k_u - (sin (delta * PI * k_u))) >= 0 /\
  (epsilon * PI * k_u) ^ 2 / 2 - (1 - (cos (delta * PI * k_u))) >= 0 /\
  (1 - (cos (epsilon * PI * k_u))) * (sin (delta * PI * k_u)) >= 0 /\
  (epsilon * PI * k_u) ^ 3 / 2 - (1 - (cos (epsilon * PI * k_u))) * (sin (delta * PI * k_u)) >= 0 /\
  epsilon * PI * k_u * (2 / 3) * PI ^ 3 * epsilon ^ 2 * k_u ^ 3 / (PI * k_u) - PI * epsilon * k_u * ((sin (delta * PI *
      k_u)) * (cos (epsilon * PI * k_u)) / epsilon / (PI * k_u) - (cos (delta * PI * k_u)) - (-1) * PI * k_u * 1 / (PI *
      k_u) * (1 - delta / epsilon)) >= 0 /\
  epsilon * PI * k_u * (2 / 3) * PI ^ 3 * epsilon ^ 2 * k_u ^ 3 / (PI * k_u) + epsilon * PI * k_u * ((sin (delta * PI *
      k_u)) * (cos (epsilon * PI * k_u)) / epsilon / (PI * k_u) - (cos (delta * PI * k_u)) - (-1) * PI * k_u * 1 / (PI *
      k_u) * (1 - delta / epsilon)) >= 0 /\
  (2 / 3) * PI ^ 3 * epsilon ^ 2 * k_u ^ 3 / (PI * k_u) - ((sin (delta * PI * k_u)) * (cos (epsilon * PI * k_u)) /
      epsilon / (PI * k_u) - (cos (delta * PI * k_u)) - (-1) * PI * k_u * 1 / (PI * k_u) * (1 - delta / epsilon)) >= 0
      /\
  (sin (delta * PI * k_u)) * (cos (epsilon * PI * k_u)) / epsilon / (PI * k_u) - (cos (delta * PI * k_u)) - (-1) * PI *
      k_u * 1 / (PI * k_u) * (1 - delta / epsilon) + (2 / 3) * PI ^ 3 * epsilon ^ 2 * k_u ^ 3 / (PI * k_u) >= 0.

Definition crease_error_area__tents : Prop :=
  forall delta epsilon k_u : R,
  epsilon > 0 ->
  k_u > 0 ->
  3 * epsilon ^ 2 <> 0 /\
  ex_derive (fun delta : R => (delta - epsilon) ^ 3 / (3 * epsilon ^ 2)) delta /\
  epsilon <> 0 /\
  PI * k_u <> 0 /\
  (Derive (fun delta : R => (delta - epsilon) ^ 3 / (3 * epsilon ^ 2)) delta) = ((-PI * k_u * (1 - delta / epsilon)) /
      (PI * k_u)) ^ 2 /\
  (epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3 = epsilon / 3.

Definition crease_error_area__mean_of_a_square : Prop :=
  forall k_v v : R,
  k_v > 0 ->
  sin (PI * k_v) = 0 ->
  4 * PI * k_v <> 0 /\
  ex_derive (fun v : R => v / 2 - (1 / 4) / (PI * k_v) * (sin (v * 2 * PI * k_v))) v /\
  (Derive (fun v : R => v / 2 - (1 / 4) / (PI * k_v) * (sin (v * 2 * PI * k_v))) v) = (sin (v * PI * k_v)) ^ 2 /\
  1 / 2 - (1 / 4) / (PI * k_v) * (sin (1 * 2 * PI * k_v)) - (0 / 2 - (1 / 4) / (PI * k_v) * (sin (0 * 2 * PI * k_v))) =
      (1 / 2).

Definition crease_error_area__in_u : Prop :=
  forall epsilon k_u : R,
  k_u >= 1 ->
  epsilon > 0 ->
  3 * epsilon ^ 2 <> 0 /\
  epsilon * k_u >= 0 /\
  (1 / 2) * 2 * k_u * (PI * k_u) ^ 2 * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 -
      epsilon) ^ 3) >= 0 /\
  PI * k_u > 0 /\
  epsilon * k_u >= 0 /\
  (1 / 2) * 2 * k_u * (PI * k_u) ^ 2 * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 -
      epsilon) ^ 3) >= 0 /\
  (1 / 3) * sqrt 3 * PI * k_u * sqrt (epsilon * k_u) >= 0 /\
  (1 / 2) * 2 * k_u * (PI * k_u) ^ 2 * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 -
      epsilon) ^ 3) = ((1 / 3) * sqrt 3 * PI * k_u * sqrt (epsilon * k_u)) ^ 2 /\
  sqrt ((1 / 2) * 2 * k_u * (PI * k_u) ^ 2 * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0
      - epsilon) ^ 3)) >= (1 / 3) * sqrt 3 * PI * k_u * sqrt (epsilon * k_u) /\
  (1 / 3) * sqrt 3 * PI * k_u * sqrt (epsilon * k_u) >= sqrt ((1 / 2) * 2 * k_u * (PI * k_u) ^ 2 * ((epsilon - epsilon)
      ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3)) /\
  sqrt ((1 / 2) * 2 * k_u * (PI * k_u) ^ 2 * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0
      - epsilon) ^ 3)) = (1 / 3) * sqrt 3 * PI * k_u * sqrt (epsilon * k_u).

Definition crease_error_area__in_v : Prop :=
  forall epsilon k_v : R,
  k_v >= 1 ->
  epsilon > 0 ->
  3 * epsilon ^ 2 <> 0 /\
  epsilon * (k_v - 1) >= 0 /\
  (1 / 2) * 2 * (PI * k_v) ^ 2 * (k_v - 1) * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0
      - epsilon) ^ 3) >= 0 /\
  PI * k_v > 0 /\
  epsilon * (k_v - 1) >= 0 /\
  (1 / 2) * 2 * (PI * k_v) ^ 2 * (k_v - 1) * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0
      - epsilon) ^ 3) >= 0 /\
  (1 / 3) * sqrt 3 * PI * k_v * sqrt (epsilon * (k_v - 1)) >= 0 /\
  (1 / 2) * 2 * (PI * k_v) ^ 2 * (k_v - 1) * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0
      - epsilon) ^ 3) = ((1 / 3) * sqrt 3 * PI * k_v * sqrt (epsilon * (k_v - 1))) ^ 2 /\
  sqrt ((1 / 2) * 2 * (PI * k_v) ^ 2 * (k_v - 1) * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^
      2) * (0 - epsilon) ^ 3)) >= (1 / 3) * sqrt 3 * PI * k_v * sqrt (epsilon * (k_v - 1)) /\
  (1 / 3) * sqrt 3 * PI * k_v * sqrt (epsilon * (k_v - 1)) >= sqrt ((1 / 2) * 2 * (PI * k_v) ^ 2 * (k_v - 1) * ((epsilon
      - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^ 2) * (0 - epsilon) ^ 3)) /\
  sqrt ((1 / 2) * 2 * (PI * k_v) ^ 2 * (k_v - 1) * ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2) - (1 / 3) / (epsilon ^
      2) * (0 - epsilon) ^ 3)) = (1 / 3) * sqrt 3 * PI * k_v * sqrt (epsilon * (k_v - 1)).

Definition bump_is_not_displacement__only_where_flat : Prop :=
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
  sin_phi <> 0 /\
  2 * PI * sin_phi <> 0 /\
  / sin_phi > 0 /\
  / PI > 0 /\
  1 / (PI * sin_phi) > 0 /\
  lift + / (2 * PI * sin_phi) > 0 /\
  lift + / PI > 0 /\
  beta * h_u * (lift + / (2 * PI * sin_phi)) = 0 /\
  beta * h_v * (lift + / PI) = 0 /\
  beta * h_u = 0 /\
  beta * h_v = 0.

Definition bump_is_not_displacement__where_flat : Prop :=
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
  sin_phi > 0 ->
  beta * h_u = 0 ->
  beta * h_v = 0 ->
  sin_phi <> 0 /\
  displaced_x = lift * m_x /\
  displaced_y = lift * m_y /\
  displaced_z = lift * m_z.

Definition bump_is_not_displacement__angle : Prop :=
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
  sin_phi <> 0 /\
  2 * PI * sin_phi <> 0 /\
  displaced_z * m_z + displaced_x * m_x + displaced_y * m_y = lift - beta ^ 2 * (h_u ^ 2 / (2 * PI * sin_phi) + h_v ^ 2
      / PI) /\
  m_z * m_z + m_x * m_x + m_y * m_y = beta ^ 2 * (h_u ^ 2 + h_v ^ 2) + 1 /\
  displaced_z * displaced_z + displaced_x * displaced_x + displaced_y * displaced_y = beta ^ 2 * ((h_v / PI) ^ 2 + (h_u
      / (2 * PI * sin_phi)) ^ 2) + lift ^ 2.

Definition surface_bump__dropped : Prop :=
  forall beta cos_phi cos_theta h h_u h_v radius sin_phi sin_theta : R,
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
  let lift := h * beta / radius + 1 in
  let displaced_x := lift * normal_x - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi) / radius in
  let displaced_y := lift * normal_y - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi) / radius in
  let displaced_z := lift * normal_z - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi) / radius in
  let arc := -PI * radius in
  let slope_theta := (if Rlt_dec 0 sin_phi then (1 / 2) * h_u / (arc * sin_phi) else 0) in
  let slope_phi := (if Rlt_dec 0 sin_phi then h_v / arc else 0) in
  let g_x := e_phi_x * slope_phi + e_theta_x * slope_theta in
  let g_y := e_phi_y * slope_phi + e_theta_y * slope_theta in
  let g_z := e_phi_z * slope_phi + e_theta_z * slope_theta in
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi > 0 ->
  radius > 0 ->
  radius <> 0 /\
  sin_phi <> 0 /\
  (sin_phi > 0 -> arc <> 0) /\
  (sin_phi > 0 -> sin_phi <> 0) /\
  lift * radius = beta * h + radius /\
  displaced_x - m_x = normal_x * h * beta / radius /\
  displaced_y - m_y = normal_y * h * beta / radius /\
  displaced_z - m_z = normal_z * h * beta / radius.

Definition surface_bump__second_order : Prop :=
  forall beta cos_phi cos_theta h h_u h_v radius sin_phi sin_theta : R,
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
  let lift := h * beta / radius + 1 in
  let displaced_x := lift * normal_x - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi) / radius in
  let displaced_y := lift * normal_y - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi) / radius in
  let displaced_z := lift * normal_z - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi) / radius in
  let arc := -PI * radius in
  let slope_theta := (if Rlt_dec 0 sin_phi then (1 / 2) * h_u / (arc * sin_phi) else 0) in
  let slope_phi := (if Rlt_dec 0 sin_phi then h_v / arc else 0) in
  let g_x := e_phi_x * slope_phi + e_theta_x * slope_theta in
  let g_y := e_phi_y * slope_phi + e_theta_y * slope_theta in
  let g_z := e_phi_z * slope_phi + e_theta_z * slope_theta in
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi > 0 ->
  radius > 0 ->
  radius <> 0 /\
  sin_phi <> 0 /\
  (sin_phi > 0 -> arc <> 0) /\
  (sin_phi > 0 -> sin_phi <> 0) /\
  displaced_z * m_z + displaced_x * m_x + displaced_y * m_y = beta ^ 2 * (slope_phi ^ 2 + slope_theta ^ 2) + lift /\
  (displaced_y * m_x - displaced_x * m_y) * (displaced_y * m_x - displaced_x * m_y) + (displaced_x * m_z - displaced_z *
      m_x) * (displaced_x * m_z - displaced_z * m_x) + (displaced_z * m_y - displaced_y * m_z) * (displaced_z * m_y -
      displaced_y * m_z) = (beta ^ 2 * h / radius) ^ 2 * (slope_phi ^ 2 + slope_theta ^ 2).

Definition surface_bump__at_the_pole : Prop :=
  forall beta cos_phi cos_theta h_u h_v radius sin_phi sin_theta : R,
  let arc := -PI * radius in
  let slope_theta := (if Rlt_dec 0 sin_phi then (1 / 2) * h_u / (arc * sin_phi) else 0) in
  let slope_phi := (if Rlt_dec 0 sin_phi then h_v / arc else 0) in
  let normal_x := cos_theta * sin_phi in
  let normal_y := sin_phi * sin_theta in
  let normal_z := cos_phi in
  let e_theta_x := -sin_theta in
  let e_theta_y := cos_theta in
  let e_theta_z := 0 in
  let e_phi_x := cos_phi * cos_theta in
  let e_phi_y := cos_phi * sin_theta in
  let e_phi_z := -sin_phi in
  let g_x := e_phi_x * slope_phi + e_theta_x * slope_theta in
  let g_y := e_phi_y * slope_phi + e_theta_y * slope_theta in
  let g_z := e_phi_z * slope_phi + e_theta_z * slope_theta in
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  cos_theta ^ 2 + sin_theta ^ 2 = 1 ->
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi = 0 ->
  (sin_phi > 0 -> arc <> 0) /\
  (sin_phi > 0 -> sin_phi <> 0) /\
  g_x = 0 /\
  g_y = 0 /\
  g_z = 0 /\
  m_x = normal_x /\
  m_y = normal_y /\
  m_z = normal_z.

Definition attached_shadow__in_light : Prop :=
  ~ (
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
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 ->
  m_length <> 0 ->
  bumped_z * towards_z + bumped_x * towards_x + bumped_y * towards_y > 0).

Definition normal_by_beta__derivative : Prop :=
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
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 /\
  m_length <> 0 /\
  (beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2 >= 0 /\
  sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2) <> 0 /\
  (beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 + (beta * g_z + normal_z) ^ 2 > 0 /\
  ex_derive (fun beta : R => (beta * g_x + normal_x) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 +
      (beta * g_z + normal_z) ^ 2)) beta /\
  ex_derive (fun beta : R => (beta * g_y + normal_y) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 +
      (beta * g_z + normal_z) ^ 2)) beta /\
  ex_derive (fun beta : R => (beta * g_z + normal_z) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 +
      (beta * g_z + normal_z) ^ 2)) beta /\
  (Derive (fun beta : R => (beta * g_x + normal_x) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 +
      (beta * g_z + normal_z) ^ 2)) beta) = bumped_by_beta_x /\
  (Derive (fun beta : R => (beta * g_y + normal_y) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 +
      (beta * g_z + normal_z) ^ 2)) beta) = bumped_by_beta_y /\
  (Derive (fun beta : R => (beta * g_z + normal_z) / sqrt ((beta * g_x + normal_x) ^ 2 + (beta * g_y + normal_y) ^ 2 +
      (beta * g_z + normal_z) ^ 2)) beta) = bumped_by_beta_z.

Definition normal_by_beta__tangent_to_directions : Prop :=
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
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 /\
  m_length <> 0 /\
  bumped_by_beta_z * bumped_z + bumped_by_beta_x * bumped_x + bumped_by_beta_y * bumped_y = 0.

Definition angle_of_the_bump__angle : Prop :=
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
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 /\
  m_length <> 0 /\
  m_length * (bumped_z * normal_z + bumped_x * normal_x + bumped_y * normal_y) = 1 /\
  bumped_z * normal_z + bumped_x * normal_x + bumped_y * normal_y > 0 /\
  (bumped_y * normal_x - bumped_x * normal_y) * (bumped_y * normal_x - bumped_x * normal_y) + (bumped_x * normal_z -
      bumped_z * normal_x) * (bumped_x * normal_z - bumped_z * normal_x) + (bumped_z * normal_y - bumped_y * normal_z) *
      (bumped_z * normal_y - bumped_y * normal_z) = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) * (bumped_z *
      normal_z + bumped_x * normal_x + bumped_y * normal_y) ^ 2.

Definition normal_limits__small_beta : Prop :=
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
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 /\
  m_length <> 0 /\
  g_z * g_z + g_x * g_x + g_y * g_y >= 0 /\
  (bumped_z - normal_z) * (bumped_z - normal_z) + (bumped_x - normal_x) * (bumped_x - normal_x) + (bumped_y - normal_y)
      * (bumped_y - normal_y) >= 0 /\
  m_length >= 1 /\
  m_length * ((bumped_z - normal_z) * (bumped_z - normal_z) + (bumped_x - normal_x) * (bumped_x - normal_x) + (bumped_y
      - normal_y) * (bumped_y - normal_y)) = 2 * (m_length - 1) /\
  beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) - ((bumped_z - normal_z) * (bumped_z - normal_z) + (bumped_x -
      normal_x) * (bumped_x - normal_x) + (bumped_y - normal_y) * (bumped_y - normal_y)) >= 0 /\
  w ^ 2 = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) /\
  w >= 0 /\
  w >= sqrt ((bumped_z - normal_z) * (bumped_z - normal_z) + (bumped_x - normal_x) * (bumped_x - normal_x) + (bumped_y -
      normal_y) * (bumped_y - normal_y)).

Definition normal_limits__large_beta : Prop :=
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
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 /\
  m_length <> 0 /\
  g_z * g_z + g_x * g_x + g_y * g_y >= 0 /\
  sqrt (g_z * g_z + g_x * g_x + g_y * g_y) <> 0 /\
  (bumped_z - g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_z - g_z / sqrt (g_z * g_z + g_x * g_x + g_y *
      g_y)) + (bumped_x - g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_x - g_x / sqrt (g_z * g_z + g_x *
      g_x + g_y * g_y)) + (bumped_y - g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_y - g_y / sqrt (g_z *
      g_z + g_x * g_x + g_y * g_y)) >= 0 /\
  sqrt (g_z * g_z + g_x * g_x + g_y * g_y) > 0 /\
  w > 0 /\
  w ^ 2 = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) /\
  m_length ^ 2 = w ^ 2 + 1 /\
  m_length >= w /\
  m_length * (bumped_z * 1 * g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y) + bumped_x * 1 * g_x / sqrt (g_z * g_z + g_x
      * g_x + g_y * g_y) + bumped_y * 1 * g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) = w /\
  m_length * ((bumped_z - g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_z - g_z / sqrt (g_z * g_z + g_x *
      g_x + g_y * g_y)) + (bumped_x - g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_x - g_x / sqrt (g_z *
      g_z + g_x * g_x + g_y * g_y)) + (bumped_y - g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_y - g_y /
      sqrt (g_z * g_z + g_x * g_x + g_y * g_y))) = 2 * (m_length - w) /\
  m_length * (m_length + w) * ((bumped_z - g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_z - g_z / sqrt (g_z
      * g_z + g_x * g_x + g_y * g_y)) + (bumped_x - g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_x - g_x /
      sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) + (bumped_y - g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) *
      (bumped_y - g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y))) = 2 /\
  1 >= w ^ 2 * ((bumped_z - g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_z - g_z / sqrt (g_z * g_z + g_x *
      g_x + g_y * g_y)) + (bumped_x - g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_x - g_x / sqrt (g_z *
      g_z + g_x * g_x + g_y * g_y)) + (bumped_y - g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_y - g_y /
      sqrt (g_z * g_z + g_x * g_x + g_y * g_y))) /\
  1 >= w * sqrt ((bumped_z - g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_z - g_z / sqrt (g_z * g_z + g_x *
      g_x + g_y * g_y)) + (bumped_x - g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_x - g_x / sqrt (g_z *
      g_z + g_x * g_x + g_y * g_y)) + (bumped_y - g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_y - g_y /
      sqrt (g_z * g_z + g_x * g_x + g_y * g_y))).

Definition normal_limits__large_negative_beta : Prop :=
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
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 /\
  m_length <> 0 /\
  g_z * g_z + g_x * g_x + g_y * g_y >= 0 /\
  sqrt (g_z * g_z + g_x * g_x + g_y * g_y) <> 0 /\
  (bumped_z - (-1) * g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_z - (-1) * g_z / sqrt (g_z * g_z + g_x *
      g_x + g_y * g_y)) + (bumped_x - (-1) * g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_x - (-1) * g_x /
      sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) + (bumped_y - (-1) * g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) *
      (bumped_y - (-1) * g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) >= 0 /\
  sqrt (g_z * g_z + g_x * g_x + g_y * g_y) > 0 /\
  w > 0 /\
  w ^ 2 = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) /\
  m_length ^ 2 = w ^ 2 + 1 /\
  m_length >= w /\
  m_length * (bumped_z * (-1) * g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y) + bumped_x * (-1) * g_x / sqrt (g_z * g_z
      + g_x * g_x + g_y * g_y) + bumped_y * (-1) * g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) = w /\
  m_length * ((bumped_z - (-1) * g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_z - (-1) * g_z / sqrt (g_z *
      g_z + g_x * g_x + g_y * g_y)) + (bumped_x - (-1) * g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_x -
      (-1) * g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) + (bumped_y - (-1) * g_y / sqrt (g_z * g_z + g_x * g_x +
      g_y * g_y)) * (bumped_y - (-1) * g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y))) = 2 * (m_length - w) /\
  m_length * (m_length + w) * ((bumped_z - (-1) * g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_z - (-1) *
      g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) + (bumped_x - (-1) * g_x / sqrt (g_z * g_z + g_x * g_x + g_y *
      g_y)) * (bumped_x - (-1) * g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) + (bumped_y - (-1) * g_y / sqrt (g_z *
      g_z + g_x * g_x + g_y * g_y)) * (bumped_y - (-1) * g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y))) = 2 /\
  1 >= w ^ 2 * ((bumped_z - (-1) * g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_z - (-1) * g_z / sqrt (g_z
      * g_z + g_x * g_x + g_y * g_y)) + (bumped_x - (-1) * g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_x -
      (-1) * g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) + (bumped_y - (-1) * g_y / sqrt (g_z * g_z + g_x * g_x +
      g_y * g_y)) * (bumped_y - (-1) * g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y))) /\
  1 >= w * sqrt ((bumped_z - (-1) * g_z / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_z - (-1) * g_z / sqrt (g_z
      * g_z + g_x * g_x + g_y * g_y)) + (bumped_x - (-1) * g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) * (bumped_x -
      (-1) * g_x / sqrt (g_z * g_z + g_x * g_x + g_y * g_y)) + (bumped_y - (-1) * g_y / sqrt (g_z * g_z + g_x * g_x +
      g_y * g_y)) * (bumped_y - (-1) * g_y / sqrt (g_z * g_z + g_x * g_x + g_y * g_y))).

Definition normal_limits__zero_beta : Prop :=
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
  beta = 0 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 /\
  m_length <> 0 /\
  bumped_x = normal_x /\
  bumped_y = normal_y /\
  bumped_z = normal_z.

Definition normal_limits__zero_height : Prop :=
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
  g_x = 0 ->
  g_y = 0 ->
  g_z = 0 ->
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 /\
  m_length <> 0 /\
  bumped_x = normal_x /\
  bumped_y = normal_y /\
  bumped_z = normal_z.

Definition shadow_line_moves_within__shadow_line : Prop :=
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
  m_x ^ 2 + m_y ^ 2 + m_z ^ 2 >= 0 /\
  m_length <> 0 /\
  g_z * g_z + g_x * g_x + g_y * g_y >= 0 /\
  w ^ 2 = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) /\
  w >= 0 /\
  g_z * g_z + g_x * g_x + g_y * g_y - (g_z * towards_z + g_x * towards_x + g_y * towards_y) ^ 2 >= 0 /\
  w ^ 2 - (beta * (g_z * towards_z + g_x * towards_x + g_y * towards_y)) ^ 2 >= 0 /\
  beta * (g_z * towards_z + g_x * towards_x + g_y * towards_y) + w >= 0 /\
  beta * (g_z * towards_z + g_x * towards_x + g_y * towards_y) + normal_z * towards_z + normal_x * towards_x + normal_y
      * towards_y > 0 /\
  m_length * (bumped_z * towards_z + bumped_x * towards_x + bumped_y * towards_y) = beta * (g_z * towards_z + g_x *
      towards_x + g_y * towards_y) + normal_z * towards_z + normal_x * towards_x + normal_y * towards_y /\
  bumped_z * towards_z + bumped_x * towards_x + bumped_y * towards_y > 0.

Definition normalising_is_lipschitz__normalise : Prop :=
  forall a_x a_y a_z apart b_x b_y b_z length_a length_b product turned : R,
  length_a >= 1 ->
  length_b >= 1 ->
  apart >= 0 ->
  length_a ^ 2 = a_z * a_z + a_x * a_x + a_y * a_y ->
  length_b ^ 2 = b_z * b_z + b_x * b_x + b_y * b_y ->
  product = a_z * b_z + a_x * b_x + a_y * b_y ->
  apart ^ 2 = (a_z - b_z) * (a_z - b_z) + (a_x - b_x) * (a_x - b_x) + (a_y - b_y) * (a_y - b_y) ->
  turned ^ 2 = (a_z / length_a - b_z / length_b) * (a_z / length_a - b_z / length_b) + (a_x / length_a - b_x / length_b)
      * (a_x / length_a - b_x / length_b) + (a_y / length_a - b_y / length_b) * (a_y / length_a - b_y / length_b) ->
  length_a <> 0 /\
  length_b <> 0 /\
  length_a ^ 2 * length_b ^ 2 - product ^ 2 = (a_x * b_y - a_y * b_x) * (a_x * b_y - a_y * b_x) + (a_z * b_x - a_x *
      b_z) * (a_z * b_x - a_x * b_z) + (a_y * b_z - a_z * b_y) * (a_y * b_z - a_z * b_y) /\
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
  2 >= turned.

Definition normalising_is_lipschitz__moved : Prop :=
  forall beta g_x g_y g_z normal_x normal_y normal_z other_g_x other_g_y other_g_z other_m_x other_m_y other_m_z : R,
  let m_x := beta * g_x + normal_x in
  let m_y := beta * g_y + normal_y in
  let m_z := beta * g_z + normal_z in
  other_m_x = beta * other_g_x + normal_x ->
  other_m_y = beta * other_g_y + normal_y ->
  other_m_z = beta * other_g_z + normal_z ->
  (m_z - other_m_z) * (m_z - other_m_z) + (m_x - other_m_x) * (m_x - other_m_x) + (m_y - other_m_y) * (m_y - other_m_y)
      = beta ^ 2 * ((g_z - other_g_z) * (g_z - other_g_z) + (g_x - other_g_x) * (g_x - other_g_x) + (g_y - other_g_y) *
      (g_y - other_g_y)).

Definition kink_loci__projection : Prop :=
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
  eye - cos_phi * radius <> 0 /\
  x ^ 2 + y ^ 2 >= 0 /\
  1 - cos_phi >= 0 /\
  eye - cos_phi * radius > 0 /\
  eye * t = eye - cos_phi * radius /\
  t > 0 /\
  cos_theta * x + sin_theta * y = eye * radius * sin_phi / (eye - cos_phi * radius) /\
  sin_theta * x = cos_theta * y /\
  cos_theta * x + sin_theta * y >= 0 /\
  x ^ 2 + y ^ 2 = (eye * radius * sin_phi / (eye - cos_phi * radius)) ^ 2 /\
  eye * radius * sin_phi / (eye - cos_phi * radius) >= 0 /\
  sqrt (x ^ 2 + y ^ 2) = eye * radius * sin_phi / (eye - cos_phi * radius).

Definition kink_loci__elsewhere_above : Prop :=
  forall k_u k_v u v : R,
  let h := Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) in
  let cos_u := cos (PI * (k_u * u)) in
  let cos_v := cos (PI * (k_v * v)) in
  let sin_u := sin (PI * (k_u * u)) in
  let sin_v := sin (PI * (k_v * v)) in
  let h_u := PI * cos_u * k_u * sin_v * (sign (sin_u * sin_v)) in
  let h_v := PI * cos_v * k_v * sin_u * (sign (sin_u * sin_v)) in
  1 * (sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) > 0 ->
  ex_derive (fun u : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) u /\
  ex_derive (fun v : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) v /\
  ex_derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u /\
  ex_derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v /\
  h = 1 * (sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) /\
  h > 0 /\
  (Derive (fun u : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) u) = h_u /\
  (Derive (fun v : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) v) = h_v /\
  h_u = 1 * (Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u) /\
  h_v = 1 * (Derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v).

Definition kink_loci__elsewhere_below : Prop :=
  forall k_u k_v u v : R,
  let h := Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) in
  let cos_u := cos (PI * (k_u * u)) in
  let cos_v := cos (PI * (k_v * v)) in
  let sin_u := sin (PI * (k_u * u)) in
  let sin_v := sin (PI * (k_v * v)) in
  let h_u := PI * cos_u * k_u * sin_v * (sign (sin_u * sin_v)) in
  let h_v := PI * cos_v * k_v * sin_u * (sign (sin_u * sin_v)) in
  -(sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) > 0 ->
  ex_derive (fun u : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) u /\
  ex_derive (fun v : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) v /\
  ex_derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u /\
  ex_derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v /\
  h = -(sin (PI * (k_u * u))) * (sin (PI * (k_v * v))) /\
  h > 0 /\
  (Derive (fun u : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) u) = h_u /\
  (Derive (fun v : R => Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v))))) v) = h_v /\
  h_u = -(Derive (fun u : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) u) /\
  h_v = -(Derive (fun v : R => (sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))) v).

Definition visible_iff__visible : Prop :=
  forall eye radius t x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye ->
  discriminant_a >= 0 ->
  eye * (1 - t) * eye * (1 - t) + t * x * t * x + t * y * t * y = radius ^ 2 ->
  eye * eye * (1 - t) / radius >= radius ->
  x ^ 2 + y ^ 2 >= 0 /\
  tangent_squared >= 0 /\
  tangent_squared <> 0 /\
  Rmax 0 discriminant_a >= 0 /\
  eye ^ 2 + root_a <> 0 /\
  radius <> 0 /\
  t * (t * (eye ^ 2 + rho ^ 2) - eye ^ 2) = radius * (radius - eye ^ 2 * (1 - t) / radius) /\
  (t * (eye ^ 2 + rho ^ 2) - eye ^ 2) ^ 2 = discriminant_a /\
  2 * eye ^ 2 * t = eye ^ 2 + t ^ 2 * (eye ^ 2 + rho ^ 2) - radius ^ 2 /\
  eye ^ 2 * t > 0 /\
  t > 0 /\
  0 >= t * (eye ^ 2 + rho ^ 2) - eye ^ 2 /\
  -(t * (eye ^ 2 + rho ^ 2) - eye ^ 2) >= root_a /\
  root_a >= -(t * (eye ^ 2 + rho ^ 2) - eye ^ 2) /\
  t >= t_a /\
  t_a >= t.

Definition visible_iff__hidden : Prop :=
  forall eye radius t x y : R,
  let rho_raw := sqrt (x ^ 2 + y ^ 2) in
  let rho := (if Rle_dec ((1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye) rho_raw then rho_raw else 0) in
  let tangent_squared := (eye - radius) * (eye + radius) in
  let rho_silhouette := eye * radius / sqrt tangent_squared in
  let discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette) in
  let root_a := sqrt (Rmax 0 discriminant_a) in
  let t_a := tangent_squared / (eye ^ 2 + root_a) in
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  rho_raw >= (1 /
      1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
      * eye ->
  discriminant_a >= 0 ->
  eye * (1 - t) * eye * (1 - t) + t * x * t * x + t * y * t * y = radius ^ 2 ->
  eye * eye * (1 - t) / radius < radius ->
  x ^ 2 + y ^ 2 >= 0 /\
  tangent_squared >= 0 /\
  tangent_squared <> 0 /\
  Rmax 0 discriminant_a >= 0 /\
  eye ^ 2 + root_a <> 0 /\
  radius <> 0 /\
  t * (t * (eye ^ 2 + rho ^ 2) - eye ^ 2) = radius * (radius - eye ^ 2 * (1 - t) / radius) /\
  (t * (eye ^ 2 + rho ^ 2) - eye ^ 2) ^ 2 = discriminant_a /\
  2 * eye ^ 2 * t = eye ^ 2 + t ^ 2 * (eye ^ 2 + rho ^ 2) - radius ^ 2 /\
  eye ^ 2 * t > 0 /\
  t > 0 /\
  t * (eye ^ 2 + rho ^ 2) - eye ^ 2 > 0 /\
  t > t_a.

Definition shadow_along_a_row__row : Prop :=
  forall body_radius center_x center_y center_z light_x light_y light_z x y : R,
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
  let shadow_discriminant := body_radius ^ 2 * segment_squared - (offset_y * segment_x - offset_x * segment_y) ^ 2 -
      (offset_x * segment_z - offset_z * segment_x) ^ 2 - (offset_z * segment_y - offset_y * segment_z) ^ 2 in
  ex_derive (fun x : R => (center_x - x) * (light_x - x) + (center_y - y) * (light_y - y) + (center_z - 0) * (light_z -
      0)) x /\
  shadow_discriminant = body_radius ^ 2 * (light_z ^ 2 + light_x ^ 2 + (light_y - y) ^ 2) + x ^ 2 * (body_radius ^ 2 -
      (light_y - center_y) ^ 2 - (light_z - center_z) ^ 2) - 2 * x * (body_radius ^ 2 * light_x + (0 * (light_x -
      center_x) - (light_z - center_z)) * (center_x * light_z - center_z * light_x - (0 * (light_z - center_z) - 0)) +
      (0 * (light_y - center_y) + 0 * (light_z - center_z)) * (center_z * light_y - center_y * light_z - (0 * (light_y -
      center_y) - y * (light_z - center_z))) + (0 * (light_x - center_x) + 1 * (light_y - center_y)) * (center_y *
      light_x - center_x * light_y - (y * (light_x - center_x) - 0))) - ((center_x * light_z - center_z * light_x - (0 *
      (light_z - center_z) - 0)) * (center_x * light_z - center_z * light_x - (0 * (light_z - center_z) - 0)) +
      (center_z * light_y - center_y * light_z - (0 * (light_y - center_y) - y * (light_z - center_z))) * (center_z *
      light_y - center_y * light_z - (0 * (light_y - center_y) - y * (light_z - center_z))) + (center_y * light_x -
      center_x * light_y - (y * (light_x - center_x) - 0)) * (center_y * light_x - center_x * light_y - (y * (light_x -
      center_x) - 0))) /\
  segment_squared = light_z ^ 2 + light_x ^ 2 + x ^ 2 - 2 * light_x * x + (light_y - y) ^ 2 /\
  (Derive (fun x : R => (center_x - x) * (light_x - x) + (center_y - y) * (light_y - y) + (center_z - 0) * (light_z -
      0)) x) = 2 * x - light_x - center_x.

Definition shadow_along_a_row__leading : Prop :=
  forall body_radius center_x center_y center_z light_x light_y light_z x y : R,
  ex_derive_n (fun x : R => body_radius ^ 2 * ((light_x - x) ^ 2 + (light_y - y) ^ 2 + (light_z - 0) ^ 2) - ((center_y -
      y) * (light_x - x) - (center_x - x) * (light_y - y)) ^ 2 - ((center_x - x) * (light_z - 0) - (center_z - 0) *
      (light_x - x)) ^ 2 - ((center_z - 0) * (light_y - y) - (center_y - y) * (light_z - 0)) ^ 2) 2 x /\
  (Derive_n (fun x : R => body_radius ^ 2 * ((light_x - x) ^ 2 + (light_y - y) ^ 2 + (light_z - 0) ^ 2) - ((center_y -
      y) * (light_x - x) - (center_x - x) * (light_y - y)) ^ 2 - ((center_x - x) * (light_z - 0) - (center_z - 0) *
      (light_x - x)) ^ 2 - ((center_z - 0) * (light_y - y) - (center_y - y) * (light_z - 0)) ^ 2) 2 x) = 2 *
      (body_radius ^ 2 - (light_y - center_y) ^ 2 - (light_z - center_z) ^ 2).

Definition shadow_along_a_row__away : Prop :=
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
  segment_squared - toward_center = -((light_z - center_z) * (0 - light_z) + (light_x - center_x) * (x - light_x) +
      (light_y - center_y) * (y - light_y)).

Definition shadow_of_b_on_floor__conic : Prop :=
  forall body_radius center_x center_y center_z foot_x foot_y light_x light_y light_z x y : R,
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
  let shadow_discriminant := body_radius ^ 2 * segment_squared - (offset_y * segment_x - offset_x * segment_y) ^ 2 -
      (offset_x * segment_z - offset_z * segment_x) ^ 2 - (offset_z * segment_y - offset_y * segment_z) ^ 2 in
  foot_x = 0 ->
  foot_y = 0 ->
  ex_derive (fun foot_x : R => body_radius ^ 2 * ((light_x - foot_x) ^ 2 + (light_y - foot_y) ^ 2 + (light_z - 0) ^ 2) -
      ((center_y - foot_y) * (light_x - foot_x) - (center_x - foot_x) * (light_y - foot_y)) ^ 2 - ((center_x - foot_x) *
      (light_z - 0) - (center_z - 0) * (light_x - foot_x)) ^ 2 - ((center_z - 0) * (light_y - foot_y) - (center_y -
      foot_y) * (light_z - 0)) ^ 2) foot_x /\
  ex_derive (fun foot_y : R => body_radius ^ 2 * ((light_x - foot_x) ^ 2 + (light_y - foot_y) ^ 2 + (light_z - 0) ^ 2) -
      ((center_y - foot_y) * (light_x - foot_x) - (center_x - foot_x) * (light_y - foot_y)) ^ 2 - ((center_x - foot_x) *
      (light_z - 0) - (center_z - 0) * (light_x - foot_x)) ^ 2 - ((center_z - 0) * (light_y - foot_y) - (center_y -
      foot_y) * (light_z - 0)) ^ 2) foot_y /\
  shadow_discriminant = ((light_z - center_z) * (0 - light_z) + (light_x - center_x) * (x - light_x) + (light_y -
      center_y) * (y - light_y)) ^ 2 - ((light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x -
      center_x) + (light_y - center_y) * (light_y - center_y) - body_radius ^ 2) * ((0 - light_z) * (0 - light_z) + (x -
      light_x) * (x - light_x) + (y - light_y) * (y - light_y)) /\
  shadow_discriminant - x ^ 2 * ((light_x - center_x) ^ 2 - ((light_z - center_z) * (light_z - center_z) + (light_x -
      center_x) * (light_x - center_x) + (light_y - center_y) * (light_y - center_y) - body_radius ^ 2)) - 2 * x * y *
      (light_x - center_x) * (light_y - center_y) - y ^ 2 * ((light_y - center_y) ^ 2 - ((light_z - center_z) * (light_z
      - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y) * (light_y - center_y) -
      body_radius ^ 2)) = x * (Derive (fun foot_x : R => body_radius ^ 2 * ((light_x - foot_x) ^ 2 + (light_y - foot_y)
      ^ 2 + (light_z - 0) ^ 2) - ((center_y - foot_y) * (light_x - foot_x) - (center_x - foot_x) * (light_y - foot_y)) ^
      2 - ((center_x - foot_x) * (light_z - 0) - (center_z - 0) * (light_x - foot_x)) ^ 2 - ((center_z - 0) * (light_y -
      foot_y) - (center_y - foot_y) * (light_z - 0)) ^ 2) foot_x) + y * (Derive (fun foot_y : R => body_radius ^ 2 *
      ((light_x - foot_x) ^ 2 + (light_y - foot_y) ^ 2 + (light_z - 0) ^ 2) - ((center_y - foot_y) * (light_x - foot_x)
      - (center_x - foot_x) * (light_y - foot_y)) ^ 2 - ((center_x - foot_x) * (light_z - 0) - (center_z - 0) * (light_x
      - foot_x)) ^ 2 - ((center_z - 0) * (light_y - foot_y) - (center_y - foot_y) * (light_z - 0)) ^ 2) foot_y) +
      body_radius ^ 2 * ((light_x - foot_x) ^ 2 + (light_y - foot_y) ^ 2 + (light_z - 0) ^ 2) - ((center_y - foot_y) *
      (light_x - foot_x) - (center_x - foot_x) * (light_y - foot_y)) ^ 2 - ((center_x - foot_x) * (light_z - 0) -
      (center_z - 0) * (light_x - foot_x)) ^ 2 - ((center_z - 0) * (light_y - foot_y) - (center_y - foot_y) * (light_z -
      0)) ^ 2 /\
  ((light_x - center_x) ^ 2 - ((light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x)
      + (light_y - center_y) * (light_y - center_y) - body_radius ^ 2)) * ((light_y - center_y) ^ 2 - ((light_z -
      center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y) * (light_y -
      center_y) - body_radius ^ 2)) - ((light_x - center_x) * (light_y - center_y)) ^ 2 = ((light_z - center_z) ^ 2 -
      body_radius ^ 2) * ((light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) +
      (light_y - center_y) * (light_y - center_y) - body_radius ^ 2).

Definition shadow_of_b_on_floor__ellipse : Prop :=
  forall body_radius center_x center_y center_z light_x light_y light_z : R,
  (light_z - center_z) ^ 2 + (light_y - center_y) ^ 2 + (light_x - center_x) ^ 2 + 0 > body_radius ^ 2 ->
  (light_z - center_z) ^ 2 > body_radius ^ 2 ->
  (light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y) *
      (light_y - center_y) - body_radius ^ 2 > 0 /\
  ((light_x - center_x) ^ 2 - ((light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x)
      + (light_y - center_y) * (light_y - center_y) - body_radius ^ 2)) * ((light_y - center_y) ^ 2 - ((light_z -
      center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y) * (light_y -
      center_y) - body_radius ^ 2)) - ((light_x - center_x) * (light_y - center_y)) ^ 2 > 0.

Definition shadow_of_b_on_floor__parabola : Prop :=
  forall body_radius center_x center_y center_z light_x light_y light_z : R,
  (light_z - center_z) ^ 2 + (light_y - center_y) ^ 2 + (light_x - center_x) ^ 2 + 0 > body_radius ^ 2 ->
  (light_z - center_z) ^ 2 = body_radius ^ 2 ->
  (light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y) *
      (light_y - center_y) - body_radius ^ 2 > 0 /\
  ((light_x - center_x) ^ 2 - ((light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x)
      + (light_y - center_y) * (light_y - center_y) - body_radius ^ 2)) * ((light_y - center_y) ^ 2 - ((light_z -
      center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y) * (light_y -
      center_y) - body_radius ^ 2)) - ((light_x - center_x) * (light_y - center_y)) ^ 2 = 0.

Definition shadow_of_b_on_floor__hyperbola : Prop :=
  forall body_radius center_x center_y center_z light_x light_y light_z : R,
  (light_z - center_z) ^ 2 + (light_y - center_y) ^ 2 + (light_x - center_x) ^ 2 + 0 > body_radius ^ 2 ->
  (light_z - center_z) ^ 2 < body_radius ^ 2 ->
  (light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y) *
      (light_y - center_y) - body_radius ^ 2 > 0 /\
  0 > ((light_x - center_x) ^ 2 - ((light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x -
      center_x) + (light_y - center_y) * (light_y - center_y) - body_radius ^ 2)) * ((light_y - center_y) ^ 2 -
      ((light_z - center_z) * (light_z - center_z) + (light_x - center_x) * (light_x - center_x) + (light_y - center_y)
      * (light_y - center_y) - body_radius ^ 2)) - ((light_x - center_x) * (light_y - center_y)) ^ 2.

Definition shadow_of_b_on_floor__away : Prop :=
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
  segment_squared - toward_center = -((light_z - center_z) * (0 - light_z) + (light_x - center_x) * (x - light_x) +
      (light_y - center_y) * (y - light_y)).

Definition shadow_of_b_on_floor__all_seen : Prop :=
  forall body_radius center_x center_y center_z light_x light_y light_z x y : R,
  light_z > 0 ->
  body_radius > 0 ->
  light_z - center_z >= body_radius ->
  (light_z - center_z) ^ 2 + (center_x - light_x) ^ 2 + (center_y - light_y) ^ 2 - body_radius ^ 2 > 0 ->
  (light_z * (light_z - center_z) + (center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) ^ 2 >=
      ((light_z - center_z) ^ 2 + (center_x - light_x) ^ 2 + (center_y - light_y) ^ 2 - body_radius ^ 2) * (light_z ^ 2
      + (x - light_x) ^ 2 + (y - light_y) ^ 2) ->
  light_z - center_z > 0 /\
  light_z * (light_z - center_z) > 0 /\
  (light_z - center_z - body_radius) * (body_radius + light_z - center_z) >= 0 /\
  (x - light_x) ^ 2 + (y - light_y) ^ 2 >= 0 /\
  ((light_z - center_z) ^ 2 + (center_x - light_x) ^ 2 + (center_y - light_y) ^ 2 - body_radius ^ 2 - ((center_x -
      light_x) ^ 2 + (center_y - light_y) ^ 2)) * ((x - light_x) ^ 2 + (y - light_y) ^ 2) >= 0 /\
  ((center_x - light_x) ^ 2 + (center_y - light_y) ^ 2) * ((x - light_x) ^ 2 + (y - light_y) ^ 2) >= ((center_x -
      light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) ^ 2 /\
  light_z ^ 2 > 0 /\
  light_z ^ 2 * ((light_z - center_z) ^ 2 + (center_x - light_x) ^ 2 + (center_y - light_y) ^ 2 - body_radius ^ 2) > 0
    /\
  ((light_z - center_z) ^ 2 + (center_x - light_x) ^ 2 + (center_y - light_y) ^ 2 - body_radius ^ 2) * (light_z ^ 2 + (x
      - light_x) ^ 2 + (y - light_y) ^ 2) > ((center_x - light_x) * (x - light_x) + (center_y - light_y) * (y -
      light_y)) ^ 2 /\
  (light_z * (light_z - center_z) + (center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) ^ 2 -
      ((center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) ^ 2 > 0 /\
  (light_z * (light_z - center_z) + (center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) ^ 2 -
      ((center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) ^ 2 = light_z * (light_z - center_z)
      * (2 * (light_z * (light_z - center_z) + (center_x - light_x) * (x - light_x) + (center_y - light_y) * (y -
      light_y)) - light_z * (light_z - center_z)) /\
  2 * (light_z * (light_z - center_z) + (center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) -
      light_z * (light_z - center_z) > 0 /\
  light_z * (light_z - center_z) + (center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y) > 0.

Definition shadow_of_b_on_floor__none_seen : Prop :=
  forall body_radius center_x center_y center_z light_x light_y light_z x y : R,
  light_z > 0 ->
  body_radius > 0 ->
  -(light_z - center_z) >= body_radius ->
  (light_z - center_z) ^ 2 + (center_x - light_x) ^ 2 + (center_y - light_y) ^ 2 - body_radius ^ 2 > 0 ->
  (light_z * (light_z - center_z) + (center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) ^ 2 >=
      ((light_z - center_z) ^ 2 + (center_x - light_x) ^ 2 + (center_y - light_y) ^ 2 - body_radius ^ 2) * (light_z ^ 2
      + (x - light_x) ^ 2 + (y - light_y) ^ 2) ->
  -(light_z - center_z) > 0 /\
  (-light_z) * (light_z - center_z) > 0 /\
  (-body_radius - (light_z - center_z)) * (body_radius - (light_z - center_z)) >= 0 /\
  (x - light_x) ^ 2 + (y - light_y) ^ 2 >= 0 /\
  ((light_z - center_z) ^ 2 + (center_x - light_x) ^ 2 + (center_y - light_y) ^ 2 - body_radius ^ 2 - ((center_x -
      light_x) ^ 2 + (center_y - light_y) ^ 2)) * ((x - light_x) ^ 2 + (y - light_y) ^ 2) >= 0 /\
  ((center_x - light_x) ^ 2 + (center_y - light_y) ^ 2) * ((x - light_x) ^ 2 + (y - light_y) ^ 2) >= ((center_x -
      light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) ^ 2 /\
  light_z ^ 2 > 0 /\
  light_z ^ 2 * ((light_z - center_z) ^ 2 + (center_x - light_x) ^ 2 + (center_y - light_y) ^ 2 - body_radius ^ 2) > 0
    /\
  ((light_z - center_z) ^ 2 + (center_x - light_x) ^ 2 + (center_y - light_y) ^ 2 - body_radius ^ 2) * (light_z ^ 2 + (x
      - light_x) ^ 2 + (y - light_y) ^ 2) > ((center_x - light_x) * (x - light_x) + (center_y - light_y) * (y -
      light_y)) ^ 2 /\
  (light_z * (light_z - center_z) + (center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) ^ 2 -
      ((center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) ^ 2 > 0 /\
  (light_z * (light_z - center_z) + (center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) ^ 2 -
      ((center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y)) ^ 2 = light_z * (light_z - center_z)
      * (2 * (light_z * (light_z - center_z) + (center_x - light_x) * (x - light_x) + (center_y - light_y) * (y -
      light_y)) - light_z * (light_z - center_z)) /\
  light_z * (light_z - center_z) - 2 * (light_z * (light_z - center_z) + (center_x - light_x) * (x - light_x) +
      (center_y - light_y) * (y - light_y)) > 0 /\
  0 > light_z * (light_z - center_z) + (center_x - light_x) * (x - light_x) + (center_y - light_y) * (y - light_y).

Definition image_derivative__mu : Prop :=
  forall bumped_by_beta_x bumped_by_beta_y bumped_by_beta_z bumped_x bumped_y bumped_z s towards_x towards_y towards_z :
    R,
  s = 0 ->
  ex_derive (fun s : R => towards_x * (bumped_by_beta_x * s + bumped_x) + towards_y * (bumped_by_beta_y * s + bumped_y)
      + towards_z * (bumped_by_beta_z * s + bumped_z)) s /\
  (Derive (fun s : R => towards_x * (bumped_by_beta_x * s + bumped_x) + towards_y * (bumped_by_beta_y * s + bumped_y) +
      towards_z * (bumped_by_beta_z * s + bumped_z)) s) = bumped_by_beta_x * towards_x + bumped_by_beta_y * towards_y +
      bumped_by_beta_z * towards_z.

Definition image_derivative__blinn : Prop :=
  forall bumped_by_beta_x bumped_by_beta_y bumped_by_beta_z bumped_x bumped_y bumped_z halfway_length halfway_x halfway_y
    halfway_z s : R,
  halfway_length > 0 ->
  s = 0 ->
  halfway_length <> 0 /\
  ex_derive (fun s : R => (halfway_x * (bumped_by_beta_x * s + bumped_x) + halfway_y * (bumped_by_beta_y * s + bumped_y)
      + halfway_z * (bumped_by_beta_z * s + bumped_z)) / halfway_length) s /\
  (Derive (fun s : R => (halfway_x * (bumped_by_beta_x * s + bumped_x) + halfway_y * (bumped_by_beta_y * s + bumped_y) +
      halfway_z * (bumped_by_beta_z * s + bumped_z)) / halfway_length) s) = (bumped_by_beta_x * halfway_x +
      bumped_by_beta_y * halfway_y + bumped_by_beta_z * halfway_z) / halfway_length.

Definition image_derivative__phong : Prop :=
  forall bumped_by_beta_x bumped_by_beta_y bumped_by_beta_z bumped_x bumped_y bumped_z s towards_x towards_y towards_z
    view_x view_y view_z : R,
  s = 0 ->
  ex_derive (fun s : R => -towards_x * view_x - towards_y * view_y - towards_z * view_z + 2 * (towards_x *
      (bumped_by_beta_x * s + bumped_x) + towards_y * (bumped_by_beta_y * s + bumped_y) + towards_z * (bumped_by_beta_z
      * s + bumped_z)) * (view_x * (bumped_by_beta_x * s + bumped_x) + view_y * (bumped_by_beta_y * s + bumped_y) +
      view_z * (bumped_by_beta_z * s + bumped_z))) s /\
  (Derive (fun s : R => -towards_x * view_x - towards_y * view_y - towards_z * view_z + 2 * (towards_x *
      (bumped_by_beta_x * s + bumped_x) + towards_y * (bumped_by_beta_y * s + bumped_y) + towards_z * (bumped_by_beta_z
      * s + bumped_z)) * (view_x * (bumped_by_beta_x * s + bumped_x) + view_y * (bumped_by_beta_y * s + bumped_y) +
      view_z * (bumped_by_beta_z * s + bumped_z))) s) = 2 * (bumped_by_beta_x * towards_x + bumped_by_beta_y * towards_y
      + bumped_by_beta_z * towards_z) * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) + 2 *
      (bumped_by_beta_x * view_x + bumped_by_beta_y * view_y + bumped_by_beta_z * view_z) * (bumped_x * towards_x +
      bumped_y * towards_y + bumped_z * towards_z).

Definition image_derivative__power_rule : Prop :=
  forall slope x : R,
  forall of_x by_s power_ : nat -> R,
  of_x 0%nat = 1 ->
  (forall n : nat, of_x (S n) = (of_x n) * x) ->
  by_s 0%nat = 0 ->
  (forall n : nat, by_s (S n) = (by_s n) * x + (of_x n) * slope) ->
  power_ 0%nat = 0 ->
  (forall n : nat, power_ (S n) = power_ n + 1) ->
  forall n : nat,
  (by_s n) * x = slope * (of_x n) * (power_ n).

Definition image_derivative__lit_shiny : Prop :=
  forall albedo_red base_by_beta kd ks light_red mu mu_by_beta raised raised_by_beta red s shininess specular_base : R,
  mu > 0 ->
  specular_base > 0 ->
  s = 0 ->
  raised_by_beta * specular_base = base_by_beta * raised * shininess ->
  ex_derive (fun s : R => light_red * (albedo_red * kd * 1 * (mu + mu_by_beta * s) + ks * 1 * (raised + raised_by_beta *
      s)) + red) s /\
  (specular_base > 0 -> specular_base <> 0) /\
  Rmax 0 mu = 1 * mu /\
  Rmax 0 specular_base = 1 * specular_base /\
  (Derive (fun s : R => light_red * (albedo_red * kd * 1 * (mu + mu_by_beta * s) + ks * 1 * (raised + raised_by_beta *
      s)) + red) s) = light_red * (albedo_red * ((if Rlt_dec 0 mu then kd * mu_by_beta else 0)) + (if Rlt_dec 0
      specular_base then base_by_beta * ks * shininess * raised / specular_base else 0)).

Definition image_derivative__lit_dull : Prop :=
  forall albedo_red base_by_beta kd ks light_red mu mu_by_beta raised raised_by_beta red s shininess specular_base : R,
  mu > 0 ->
  specular_base < 0 ->
  s = 0 ->
  ex_derive (fun s : R => light_red * (ks * 0 * (raised + raised_by_beta * s) + albedo_red * kd * 1 * (mu + mu_by_beta *
      s)) + red) s /\
  (specular_base > 0 -> specular_base <> 0) /\
  Rmax 0 mu = 1 * mu /\
  Rmax 0 specular_base = 0 * specular_base /\
  (Derive (fun s : R => light_red * (ks * 0 * (raised + raised_by_beta * s) + albedo_red * kd * 1 * (mu + mu_by_beta *
      s)) + red) s) = light_red * (albedo_red * ((if Rlt_dec 0 mu then kd * mu_by_beta else 0)) + (if Rlt_dec 0
      specular_base then base_by_beta * ks * shininess * raised / specular_base else 0)).

Definition image_derivative__unlit_shiny : Prop :=
  forall albedo_red base_by_beta kd ks light_red mu mu_by_beta raised raised_by_beta red s shininess specular_base : R,
  mu < 0 ->
  specular_base > 0 ->
  s = 0 ->
  raised_by_beta * specular_base = base_by_beta * raised * shininess ->
  ex_derive (fun s : R => light_red * (albedo_red * kd * 0 * (mu + mu_by_beta * s) + ks * 1 * (raised + raised_by_beta *
      s)) + red) s /\
  (specular_base > 0 -> specular_base <> 0) /\
  Rmax 0 mu = 0 * mu /\
  Rmax 0 specular_base = 1 * specular_base /\
  (Derive (fun s : R => light_red * (albedo_red * kd * 0 * (mu + mu_by_beta * s) + ks * 1 * (raised + raised_by_beta *
      s)) + red) s) = light_red * (albedo_red * ((if Rlt_dec 0 mu then kd * mu_by_beta else 0)) + (if Rlt_dec 0
      specular_base then base_by_beta * ks * shininess * raised / specular_base else 0)).

Definition image_derivative__unlit_dull : Prop :=
  forall albedo_red base_by_beta kd ks light_red mu mu_by_beta raised raised_by_beta red s shininess specular_base : R,
  mu < 0 ->
  specular_base < 0 ->
  s = 0 ->
  ex_derive (fun s : R => light_red * (albedo_red * kd * 0 * (mu + mu_by_beta * s) + ks * 0 * (raised + raised_by_beta *
      s)) + red) s /\
  (specular_base > 0 -> specular_base <> 0) /\
  Rmax 0 mu = 0 * mu /\
  Rmax 0 specular_base = 0 * specular_base /\
  (Derive (fun s : R => light_red * (albedo_red * kd * 0 * (mu + mu_by_beta * s) + ks * 0 * (raised + raised_by_beta *
      s)) + red) s) = light_red * (albedo_red * ((if Rlt_dec 0 mu then kd * mu_by_beta else 0)) + (if Rlt_dec 0
      specular_base then base_by_beta * ks * shininess * raised / specular_base else 0)).

Definition image_derivative__inside : Prop :=
  forall color term_by_beta : R,
  color > 0 ->
  color < 1 ->
  Rmin 1 (Rmax 0 color) = color /\
  (if both (Rlt_dec color 1) (Rlt_dec 0 color) then term_by_beta else 0) = term_by_beta.

Definition image_derivative__above : Prop :=
  forall color term_by_beta : R,
  color > 1 ->
  Rmin 1 (Rmax 0 color) = 1 /\
  (if both (Rlt_dec color 1) (Rlt_dec 0 color) then term_by_beta else 0) = 0.

Definition image_derivative__below : Prop :=
  forall color term_by_beta : R,
  color < 0 ->
  Rmax 0 color = 0 /\
  (if both (Rlt_dec color 1) (Rlt_dec 0 color) then term_by_beta else 0) = 0.

Definition difference_bound__light_0 : Prop :=
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
  so_far + step * (kd * albedo_red * light_red + q * ks * light_red) - (light_red * (albedo_red * kd * (Rmax 0 mu) + ks
      * specular) + red - (before + light_red * (albedo_red * kd * (Rmax 0 other_mu) + ks * other_specular))) >= 0 /\
  so_far + step * (kd * albedo_red * light_red + q * ks * light_red) + light_red * (albedo_red * kd * (Rmax 0 mu) + ks *
      specular) + red - (before + light_red * (albedo_red * kd * (Rmax 0 other_mu) + ks * other_specular)) >= 0.

Definition difference_bound__clip : Prop :=
  forall bound_on first second : R,
  bound_on - (first - second) >= 0 ->
  bound_on + first - second >= 0 ->
  bound_on - (Rmin 1 (Rmax 0 first) - (Rmin 1 (Rmax 0 second))) >= 0 /\
  bound_on + Rmin 1 (Rmax 0 first) - (Rmin 1 (Rmax 0 second)) >= 0.

Definition pixels_off_the_pole__raster_above : Prop :=
  forall m n : R,
  (m - 128) * (m - 127) >= 0 ->
  n <= 108 ->
  (2 * m - 255) ^ 2 >= 1 /\
  (1083 - 10 * n) ^ 2 >= 9 /\
  ((5 / 4) * 4 * 1 / (sqrt (1 + 4) * sqrt (4 - 1)) * ((-2 * n - 1 + 256) / 256 + (-3 / 20))) ^ 2 + ((5 / 4) * 4 * 1 /
      (sqrt (1 + 4) * sqrt (4 - 1)) * (2 * m - 256 + 1) / 256) ^ 2 + 0 >= (34 / 15) / 65536.

Definition pixels_off_the_pole__raster_below : Prop :=
  forall m n : R,
  (m - 128) * (m - 127) >= 0 ->
  n >= 109 ->
  (2 * m - 255) ^ 2 >= 1 /\
  (1083 - 10 * n) ^ 2 >= 9 /\
  ((5 / 4) * 4 * 1 / (sqrt (1 + 4) * sqrt (4 - 1)) * ((-2 * n - 1 + 256) / 256 + (-3 / 20))) ^ 2 + ((5 / 4) * 4 * 1 /
      (sqrt (1 + 4) * sqrt (4 - 1)) * (2 * m - 256 + 1) / 256) ^ 2 + 0 >= (34 / 15) / 65536.

Definition pixels_off_the_pole__linear : Prop :=
  forall cos_phi eye radius sin_phi : R,
  let rho := eye * radius * sin_phi / (eye - cos_phi * radius) in
  cos_phi ^ 2 + sin_phi ^ 2 = 1 ->
  sin_phi >= 0 ->
  eye > 0 ->
  radius > 0 ->
  eye > radius ->
  eye - cos_phi * radius <> 0 /\
  1 - cos_phi >= 0 /\
  eye - cos_phi * radius > 0 /\
  rho >= 0 /\
  sin_phi * eye * radius >= rho * (eye - radius).

Definition pixels_off_the_pole__far : Prop :=
  forall rho sin_phi : R,
  4 * sin_phi >= 3 * rho ->
  rho >= 0 ->
  rho ^ 2 >= (34 / 15) / 65536 ->
  sin_phi > (11 / 2500) /\
  sin_phi > (1 / 10000).

Definition visible_parallels__falling : Prop :=
  forall a b : R,
  a >= 0 ->
  b - a > 0 ->
  1 - b >= 0 ->
  cos (PI * a) - (cos (PI * b)) = (sin (PI * (b - a) / 2)) * 2 * (sin (PI * (a + b) / 2)) /\
  cos (PI * a) > cos (PI * b).

Definition visible_parallels__nearer : Prop :=
  forall a b eye radius : R,
  eye > 0 ->
  cos (PI * a) > cos (PI * b) ->
  eye * (cos (PI * b)) >= radius ->
  eye * (cos (PI * a)) > radius.

Definition visible_parallels__pole : Prop :=
  forall cos_phi eye radius sin_phi : R,
  let rho := eye * radius * sin_phi / (eye - cos_phi * radius) in
  sin_phi = 0 ->
  cos_phi = 1 ->
  eye > radius ->
  eye - cos_phi * radius <> 0 /\
  rho = 0.

Definition visible_parallels__count : Prop :=
  cos (PI / 4) > (1 / 4) /\
  (1 / 4) > cos (PI / 2) /\
  cos (PI / 2) > cos (3 * PI / 4) /\
  cos (3 * PI / 4) > cos PI.

Definition shadow_of_a_on_floor__of_a : Prop :=
  forall body_radius light_x light_y light_z x y : R,
  body_radius ^ 2 * ((light_x - x) ^ 2 + (light_y - y) ^ 2 + (light_z - 0) ^ 2) - ((light_z - 0) * (0 - x) - (0 - 0) *
      (light_x - x)) ^ 2 - ((0 - 0) * (light_y - y) - (light_z - 0) * (0 - y)) ^ 2 - ((light_x - x) * (0 - y) - (light_y
      - y) * (0 - x)) ^ 2 = body_radius ^ 2 * ((0 - light_z) * (0 - light_z) + (x - light_x) * (x - light_x) + (y -
      light_y) * (y - light_y)) + (light_x * x + light_y * y) ^ 2 - (x ^ 2 + y ^ 2) * (light_z * light_z + light_x *
      light_x + light_y * light_y).

Definition shadow_of_a_on_floor__behind_a : Prop :=
  forall light_x light_y light_z x y : R,
  (light_x - x) * (0 - x) + (light_y - y) * (0 - y) + (0 - 0) * (light_z - 0) = x ^ 2 + y ^ 2 - light_x * x - light_y *
    y.
