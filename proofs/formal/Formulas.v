(* Printed from proofs/formulas by `python -m renderer.generate`. Do not edit: change the formula instead.
   Each module is one program of the chapter; each definition is one line of its derivation. *)

From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries.
Open Scope R_scope.

Module image_extent.
Section program.
Variables eye radius : R.
Definition tangent_squared := (eye - radius) * (eye + radius).
Definition half := (5 / 4) * eye * radius / sqrt tangent_squared.
End program.
Ltac lines := unfold half, tangent_squared.
End image_extent.

Module image_point.
Section program.
Variables column row width height half : R.
Definition x := half * (2 * column - width + 1) / height.
Definition y := half * ((-3 / 20) + (height - 2 * row - 1) / height).
End program.
Ltac lines := unfold y, x.
End image_point.

Module image_radius.
Section program.
Variables x y eye : R.
Definition rho_raw := sqrt (x ^ 2 + y ^ 2).
Definition rho := if Rle_dec ((1 /
    1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
    * eye) rho_raw then rho_raw else 0.
End program.
Ltac lines := unfold rho, rho_raw.
End image_radius.

Module silhouette_of_a.
Section program.
Variables eye radius : R.
Definition tangent_squared := (eye - radius) * (eye + radius).
Definition rho_silhouette := eye * radius / sqrt tangent_squared.
End program.
Ltac lines := unfold rho_silhouette, tangent_squared.
End silhouette_of_a.

Module hit_of_a.
Section program.
Variables x y eye radius : R.
Definition rho_raw := sqrt (x ^ 2 + y ^ 2).
Definition rho := if Rle_dec ((1 /
    1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
    * eye) rho_raw then rho_raw else 0.
Definition tangent_squared := (eye - radius) * (eye + radius).
Definition rho_silhouette := eye * radius / sqrt tangent_squared.
Definition discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette).
Definition root_a := sqrt (Rmax 0 discriminant_a).
Definition t_a := if Rle_dec 0 discriminant_a then Finite (tangent_squared / (eye ^ 2 + root_a)) else p_infty.
End program.
Ltac lines := unfold t_a, root_a, discriminant_a, rho_silhouette, tangent_squared, rho, rho_raw.
End hit_of_a.

Module hit_of_b.
Section program.
Variables x y eye ball_center_x ball_center_y ball_center_z ball_radius ball_on : R.
Definition distance := eye - ball_center_z.
Definition toward_b := ball_center_x * x + ball_center_y * y + distance * eye.
Definition discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 -
    (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2.
Definition root_b := sqrt (Rmax 0 discriminant_b).
Definition t_b := if both (both (Rlt_dec 0 ball_on) (Rle_dec 0 discriminant_b)) (Rlt_dec 0 toward_b) then Finite
    ((ball_center_x ^ 2 + ball_center_y ^ 2 + (distance - ball_radius) * (ball_radius + distance)) / (root_b +
    toward_b)) else p_infty.
End program.
Ltac lines := unfold t_b, root_b, discriminant_b, toward_b, distance.
End hit_of_b.

Module nearest.
Section program.
Variables floor_on : R.
Variables t_a t_b : Rbar.
Definition t_floor := if Rlt_dec 0 floor_on then Finite 1 else p_infty.
Definition surface := if both (both (Rbar_lt_dec t_a p_infty) (Rbar_le_dec t_a t_b)) (Rbar_le_dec t_a t_floor) then 1
    else if both (Rbar_lt_dec t_b p_infty) (Rbar_le_dec t_b t_floor) then 2 else if Rbar_lt_dec t_floor p_infty then 3
    else 0.
End program.
Ltac lines := unfold surface, t_floor.
End nearest.

Module visible_surface.
Section program.
Variables x y eye radius ball_center_x ball_center_y ball_center_z ball_radius ball_on floor_on : R.
Definition rho_raw := sqrt (x ^ 2 + y ^ 2).
Definition rho := if Rle_dec ((1 /
    1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
    * eye) rho_raw then rho_raw else 0.
Definition tangent_squared := (eye - radius) * (eye + radius).
Definition rho_silhouette := eye * radius / sqrt tangent_squared.
Definition discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette).
Definition root_a := sqrt (Rmax 0 discriminant_a).
Definition t_a := if Rle_dec 0 discriminant_a then Finite (tangent_squared / (eye ^ 2 + root_a)) else p_infty.
Definition distance := eye - ball_center_z.
Definition toward_b := ball_center_x * x + ball_center_y * y + distance * eye.
Definition discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 -
    (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2.
Definition root_b := sqrt (Rmax 0 discriminant_b).
Definition t_b := if both (both (Rlt_dec 0 ball_on) (Rle_dec 0 discriminant_b)) (Rlt_dec 0 toward_b) then Finite
    ((ball_center_x ^ 2 + ball_center_y ^ 2 + (distance - ball_radius) * (ball_radius + distance)) / (root_b +
    toward_b)) else p_infty.
Definition t_floor := if Rlt_dec 0 floor_on then Finite 1 else p_infty.
Definition surface := if both (both (Rbar_lt_dec t_a p_infty) (Rbar_le_dec t_a t_b)) (Rbar_le_dec t_a t_floor) then 1
    else if both (Rbar_lt_dec t_b p_infty) (Rbar_le_dec t_b t_floor) then 2 else if Rbar_lt_dec t_floor p_infty then 3
    else 0.
End program.
Ltac lines := unfold surface, t_floor, t_b, root_b, discriminant_b, toward_b, distance, t_a, root_a, discriminant_a,
    rho_silhouette, tangent_squared, rho, rho_raw.
End visible_surface.

Module angles_on_a.
Section program.
Variables x y eye radius : R.
Definition rho_raw := sqrt (x ^ 2 + y ^ 2).
Definition rho := if Rle_dec ((1 /
    1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
    * eye) rho_raw then rho_raw else 0.
Definition tangent_squared := (eye - radius) * (eye + radius).
Definition rho_silhouette := eye * radius / sqrt tangent_squared.
Definition discriminant_a := tangent_squared * (rho_silhouette - rho) * (rho + rho_silhouette).
Definition root_a := sqrt (Rmax 0 discriminant_a).
Definition t_a := if Rle_dec 0 discriminant_a then Finite (tangent_squared / (eye ^ 2 + root_a)) else p_infty.
Definition rho_inverse := if Rlt_dec 0 rho then / rho else 0.
Definition hit_scale := 1 / (radius * (eye ^ 2 + root_a)).
Definition cos_theta := rho_inverse * x.
Definition sin_theta := rho_inverse * y.
Definition sin_phi := hit_scale * rho * tangent_squared.
Definition cos_phi := eye * hit_scale * (radius ^ 2 + root_a).
End program.
Ltac lines := unfold cos_phi, sin_phi, sin_theta, cos_theta, hit_scale, rho_inverse, t_a, root_a, discriminant_a,
    rho_silhouette, tangent_squared, rho, rho_raw.
End angles_on_a.

Module point_on_a.
Section program.
Variables cos_theta sin_theta cos_phi sin_phi radius : R.
Definition point_x := cos_theta * radius * sin_phi.
Definition point_y := radius * sin_phi * sin_theta.
Definition point_z := cos_phi * radius.
End program.
Ltac lines := unfold point_z, point_y, point_x.
End point_on_a.

Module point_on_b.
Section program.
Variables x y eye ball_center_x ball_center_y ball_center_z ball_radius ball_on : R.
Definition distance := eye - ball_center_z.
Definition toward_b := ball_center_x * x + ball_center_y * y + distance * eye.
Definition discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 -
    (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2.
Definition root_b := sqrt (Rmax 0 discriminant_b).
Definition t_b := if both (both (Rlt_dec 0 ball_on) (Rle_dec 0 discriminant_b)) (Rlt_dec 0 toward_b) then Finite
    ((ball_center_x ^ 2 + ball_center_y ^ 2 + (distance - ball_radius) * (ball_radius + distance)) / (root_b +
    toward_b)) else p_infty.
Definition point_x := (real t_b) * x.
Definition point_y := (real t_b) * y.
Definition point_z := eye * (1 - (real t_b)).
End program.
Ltac lines := unfold point_z, point_y, point_x, t_b, root_b, discriminant_b, toward_b, distance.
End point_on_b.

Module normal_of_b.
Section program.
Variables x y eye ball_center_x ball_center_y ball_center_z ball_radius : R.
Definition distance := eye - ball_center_z.
Definition discriminant_b := ball_radius ^ 2 * (eye ^ 2 + x ^ 2 + y ^ 2) - (ball_center_x * eye - distance * x) ^ 2 -
    (ball_center_x * y - ball_center_y * x) ^ 2 - (distance * y - ball_center_y * eye) ^ 2.
Definition root_b := sqrt (Rmax 0 discriminant_b).
Definition moment_x := distance * y - ball_center_y * eye.
Definition moment_y := ball_center_x * eye - distance * x.
Definition moment_z := ball_center_x * y - ball_center_y * x.
Definition ray_length_squared := eye ^ 2 + x ^ 2 + y ^ 2.
Definition radius_vector_x := (-eye * moment_y - moment_z * y - root_b * x) / ray_length_squared.
Definition radius_vector_y := (eye * moment_x + moment_z * x - root_b * y) / ray_length_squared.
Definition radius_vector_z := (eye * root_b + moment_x * y - moment_y * x) / ray_length_squared.
Definition radius_length := sqrt (radius_vector_x ^ 2 + radius_vector_y ^ 2 + radius_vector_z ^ 2).
Definition normal_x := radius_vector_x / radius_length.
Definition normal_y := radius_vector_y / radius_length.
Definition normal_z := radius_vector_z / radius_length.
Definition point_x := ball_center_x + ball_radius * normal_x.
Definition point_y := ball_center_y + ball_radius * normal_y.
Definition point_z := ball_center_z + ball_radius * normal_z.
End program.
Ltac lines := unfold point_z, point_y, point_x, normal_z, normal_y, normal_x, radius_length, radius_vector_z,
    radius_vector_y, radius_vector_x, ray_length_squared, moment_z, moment_y, moment_x, root_b, discriminant_b,
    distance.
End normal_of_b.

Module point_on_floor.
Section program.
Variables x y : R.
Definition point_x := x.
Definition point_y := y.
Definition point_z := 0.
End program.
Ltac lines := unfold point_z, point_y, point_x.
End point_on_floor.

Module normal_of_floor.
Section program.
Variables x y : R.
Definition point_x := x.
Definition point_y := y.
Definition point_z := 0.
Definition bumped_x := 0.
Definition bumped_y := 0.
Definition bumped_z := 1.
End program.
Ltac lines := unfold bumped_z, bumped_y, bumped_x, point_z, point_y, point_x.
End normal_of_floor.

Module view_length.
Section program.
Variables x y eye : R.
Definition view_scale := / (sqrt (eye ^ 2 + x ^ 2 + y ^ 2)).
End program.
Ltac lines := unfold view_scale.
End view_length.

Module view_direction.
Section program.
Variables x y eye view_scale : R.
Definition view_x := -view_scale * x.
Definition view_y := -view_scale * y.
Definition view_z := eye * view_scale.
End program.
Ltac lines := unfold view_z, view_y, view_x.
End view_direction.

Module parallel_radius.
Section program.
Variables sin_phi cos_phi eye radius : R.
Definition rho := eye * radius * sin_phi / (eye - cos_phi * radius).
End program.
Ltac lines := unfold rho.
End parallel_radius.

Module chart.
Section program.
Variables cos_theta sin_theta cos_phi sin_phi : R.
Definition u_closed := (1 / 2) * (atan2pi sin_theta cos_theta) + (1 / 2).
Definition u := if Rlt_dec u_closed 1 then u_closed else 0.
Definition v := atan2pi sin_phi cos_phi.
End program.
Ltac lines := unfold v, u, u_closed.
End chart.

Module chart_inverse.
Section program.
Variables u v : R.
Definition cos_theta := -(cos (PI * (2 * u))).
Definition sin_theta := -(sin (PI * (2 * u))).
Definition cos_phi := cos (PI * v).
Definition sin_phi := sin (PI * v).
End program.
Ltac lines := unfold sin_phi, cos_phi, sin_theta, cos_theta.
End chart_inverse.

Module chart_radians.
Section program.
Variables u v : R.
Definition theta := PI * (2 * u - 1).
Definition phi := PI * v.
End program.
Ltac lines := unfold phi, theta.
End chart_radians.

Module seed_chart.
Section program.
Variables normal_x normal_y normal_z : R.
Definition u := (1 / 2) * (atan2 normal_y normal_x + PI) / PI.
Definition v := (acos normal_z) / PI.
End program.
Ltac lines := unfold v, u.
End seed_chart.

Module unit_normal.
Section program.
Variables cos_theta sin_theta cos_phi sin_phi : R.
Definition normal_x := cos_theta * sin_phi.
Definition normal_y := sin_phi * sin_theta.
Definition normal_z := cos_phi.
End program.
Ltac lines := unfold normal_z, normal_y, normal_x.
End unit_normal.

Module tangent_frame.
Section program.
Variables cos_theta sin_theta cos_phi sin_phi : R.
Definition e_theta_x := -sin_theta.
Definition e_theta_y := cos_theta.
Definition e_theta_z := 0.
Definition e_phi_x := cos_phi * cos_theta.
Definition e_phi_y := cos_phi * sin_theta.
Definition e_phi_z := -sin_phi.
End program.
Ltac lines := unfold e_phi_z, e_phi_y, e_phi_x, e_theta_z, e_theta_y, e_theta_x.
End tangent_frame.

Module seed_frame.
Section program.
Variables normal_x normal_y normal_z : R.
Definition seed_sin_phi := sqrt (1 - normal_z ^ 2).
Definition e_theta_x := -normal_y / seed_sin_phi.
Definition e_theta_y := normal_x / seed_sin_phi.
Definition e_theta_z := 0.
Definition e_phi_x := normal_x * normal_z / seed_sin_phi.
Definition e_phi_y := normal_y * normal_z / seed_sin_phi.
Definition e_phi_z := -seed_sin_phi.
End program.
Ltac lines := unfold e_phi_z, e_phi_y, e_phi_x, e_theta_z, e_theta_y, e_theta_x, seed_sin_phi.
End seed_frame.

Module perturbed.
Section program.
Variables normal_x normal_y normal_z g_x g_y g_z beta : R.
Definition m_x := beta * g_x + normal_x.
Definition m_y := beta * g_y + normal_y.
Definition m_z := beta * g_z + normal_z.
Definition m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2).
Definition m_scale := / m_length.
Definition bumped_x := m_scale * m_x.
Definition bumped_y := m_scale * m_y.
Definition bumped_z := m_scale * m_z.
End program.
Ltac lines := unfold bumped_z, bumped_y, bumped_x, m_scale, m_length, m_z, m_y, m_x.
End perturbed.

Module bumped_normal.
Section program.
Variables cos_theta sin_theta cos_phi sin_phi h_u h_v beta : R.
Definition normal_x := cos_theta * sin_phi.
Definition normal_y := sin_phi * sin_theta.
Definition normal_z := cos_phi.
Definition e_theta_x := -sin_theta.
Definition e_theta_y := cos_theta.
Definition e_theta_z := 0.
Definition e_phi_x := cos_phi * cos_theta.
Definition e_phi_y := cos_phi * sin_theta.
Definition e_phi_z := -sin_phi.
Definition g_x := e_phi_x * h_v + e_theta_x * h_u.
Definition g_y := e_phi_y * h_v + e_theta_y * h_u.
Definition g_z := e_phi_z * h_v + e_theta_z * h_u.
Definition m_x := beta * g_x + normal_x.
Definition m_y := beta * g_y + normal_y.
Definition m_z := beta * g_z + normal_z.
Definition m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2).
Definition m_scale := / m_length.
Definition bumped_x := m_scale * m_x.
Definition bumped_y := m_scale * m_y.
Definition bumped_z := m_scale * m_z.
End program.
Ltac lines := unfold bumped_z, bumped_y, bumped_x, m_scale, m_length, m_z, m_y, m_x, g_z, g_y, g_x, e_phi_z, e_phi_y,
    e_phi_x, e_theta_z, e_theta_y, e_theta_x, normal_z, normal_y, normal_x.
End bumped_normal.

Module normal_by_beta.
Section program.
Variables normal_x normal_y normal_z g_x g_y g_z beta : R.
Definition m_x := beta * g_x + normal_x.
Definition m_y := beta * g_y + normal_y.
Definition m_z := beta * g_z + normal_z.
Definition m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2).
Definition m_scale := / m_length.
Definition bumped_x := m_scale * m_x.
Definition bumped_y := m_scale * m_y.
Definition bumped_z := m_scale * m_z.
Definition bumped_by_beta_x := (g_x - bumped_x * (bumped_x * g_x + bumped_y * g_y + bumped_z * g_z)) / m_length.
Definition bumped_by_beta_y := (g_y - bumped_y * (bumped_x * g_x + bumped_y * g_y + bumped_z * g_z)) / m_length.
Definition bumped_by_beta_z := (g_z - bumped_z * (bumped_x * g_x + bumped_y * g_y + bumped_z * g_z)) / m_length.
End program.
Ltac lines := unfold bumped_by_beta_z, bumped_by_beta_y, bumped_by_beta_x, bumped_z, bumped_y, bumped_x, m_scale,
    m_length, m_z, m_y, m_x.
End normal_by_beta.

Module light_direction.
Section program.
Variables point_x point_y point_z light_x light_y light_z bumped_x bumped_y bumped_z : R.
Definition to_light_x := light_x - point_x.
Definition to_light_y := light_y - point_y.
Definition to_light_z := light_z - point_z.
Definition light_distance := sqrt (to_light_x ^ 2 + to_light_y ^ 2 + to_light_z ^ 2).
Definition light_scale := / light_distance.
Definition towards_x := light_scale * to_light_x.
Definition towards_y := light_scale * to_light_y.
Definition towards_z := light_scale * to_light_z.
Definition mu := bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z.
End program.
Ltac lines := unfold mu, towards_z, towards_y, towards_x, light_scale, light_distance, to_light_z, to_light_y,
    to_light_x.
End light_direction.

Module height_of_light.
Section program.
Variables point_x point_y point_z light_x light_y light_z normal_x normal_y normal_z : R.
Definition above := normal_x * (light_x - point_x) + normal_y * (light_y - point_y) + normal_z * (light_z - point_z).
End program.
Ltac lines := unfold above.
End height_of_light.

Module halfway_vector.
Section program.
Variables point_x point_y point_z light_x light_y light_z bumped_x bumped_y bumped_z view_x view_y view_z : R.
Definition to_light_x := light_x - point_x.
Definition to_light_y := light_y - point_y.
Definition to_light_z := light_z - point_z.
Definition light_distance := sqrt (to_light_x ^ 2 + to_light_y ^ 2 + to_light_z ^ 2).
Definition light_scale := / light_distance.
Definition towards_x := light_scale * to_light_x.
Definition towards_y := light_scale * to_light_y.
Definition towards_z := light_scale * to_light_z.
Definition mu := bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z.
Definition halfway_x := towards_x + view_x.
Definition halfway_y := towards_y + view_y.
Definition halfway_z := towards_z + view_z.
End program.
Ltac lines := unfold halfway_z, halfway_y, halfway_x, mu, towards_z, towards_y, towards_x, light_scale, light_distance,
    to_light_z, to_light_y, to_light_x.
End halfway_vector.

Module blinn.
Section program.
Variables point_x point_y point_z light_x light_y light_z bumped_x bumped_y bumped_z view_x view_y view_z : R.
Definition to_light_x := light_x - point_x.
Definition to_light_y := light_y - point_y.
Definition to_light_z := light_z - point_z.
Definition light_distance := sqrt (to_light_x ^ 2 + to_light_y ^ 2 + to_light_z ^ 2).
Definition light_scale := / light_distance.
Definition towards_x := light_scale * to_light_x.
Definition towards_y := light_scale * to_light_y.
Definition towards_z := light_scale * to_light_z.
Definition mu := bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z.
Definition halfway_x := towards_x + view_x.
Definition halfway_y := towards_y + view_y.
Definition halfway_z := towards_z + view_z.
Definition halfway_length := sqrt (halfway_x ^ 2 + halfway_y ^ 2 + halfway_z ^ 2).
Definition specular_base := if Rlt_dec 0 halfway_length then Rmax ((bumped_x * halfway_x + bumped_y * halfway_y +
    bumped_z * halfway_z) / halfway_length) 0 else 0.
End program.
Ltac lines := unfold specular_base, halfway_length, halfway_z, halfway_y, halfway_x, mu, towards_z, towards_y,
    towards_x, light_scale, light_distance, to_light_z, to_light_y, to_light_x.
End blinn.

Module blinn_squared.
Section program.
Variables point_x point_y point_z light_x light_y light_z bumped_x bumped_y bumped_z view_x view_y view_z : R.
Definition to_light_x := light_x - point_x.
Definition to_light_y := light_y - point_y.
Definition to_light_z := light_z - point_z.
Definition distance_squared := to_light_x ^ 2 + to_light_y ^ 2 + to_light_z ^ 2.
Definition light_distance := sqrt distance_squared.
Definition halfway_x := light_distance * view_x + to_light_x.
Definition halfway_y := light_distance * view_y + to_light_y.
Definition halfway_z := light_distance * view_z + to_light_z.
Definition halfway_squared := halfway_x ^ 2 + halfway_y ^ 2 + halfway_z ^ 2.
Definition along_light := bumped_x * to_light_x + bumped_y * to_light_y + bumped_z * to_light_z.
Definition along_halfway := Rmax 0 (bumped_x * halfway_x + bumped_y * halfway_y + bumped_z * halfway_z).
Definition light_scale := if Rlt_dec 0 halfway_squared then 1 / (halfway_squared * light_distance) else 0.
Definition mu := if Rlt_dec 0 halfway_squared then along_light * halfway_squared * light_scale else -bumped_x * view_x -
    bumped_y * view_y - bumped_z * view_z.
Definition specular_base := along_halfway ^ 2 * light_distance * light_scale.
End program.
Ltac lines := unfold specular_base, mu, light_scale, along_halfway, along_light, halfway_squared, halfway_z, halfway_y,
    halfway_x, light_distance, distance_squared, to_light_z, to_light_y, to_light_x.
End blinn_squared.

Module phong.
Section program.
Variables point_x point_y point_z light_x light_y light_z bumped_x bumped_y bumped_z view_x view_y view_z : R.
Definition to_light_x := light_x - point_x.
Definition to_light_y := light_y - point_y.
Definition to_light_z := light_z - point_z.
Definition light_distance := sqrt (to_light_x ^ 2 + to_light_y ^ 2 + to_light_z ^ 2).
Definition light_scale := / light_distance.
Definition towards_x := light_scale * to_light_x.
Definition towards_y := light_scale * to_light_y.
Definition towards_z := light_scale * to_light_z.
Definition mu := bumped_x * towards_x + bumped_y * towards_y + bumped_z * towards_z.
Definition specular_base := Rmax 0 (2 * mu * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) - towards_x *
    view_x - towards_y * view_y - towards_z * view_z).
End program.
Ltac lines := unfold specular_base, mu, towards_z, towards_y, towards_x, light_scale, light_distance, to_light_z,
    to_light_y, to_light_x.
End phong.

Module blinn_highlight.
Section program.
Variables bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z : R.
Definition halfway_length := sqrt (halfway_x ^ 2 + halfway_y ^ 2 + halfway_z ^ 2).
Definition specular_base := if Rlt_dec 0 halfway_length then Rmax ((bumped_x * halfway_x + bumped_y * halfway_y +
    bumped_z * halfway_z) / halfway_length) 0 else 0.
End program.
Ltac lines := unfold specular_base, halfway_length.
End blinn_highlight.

Module phong_highlight.
Section program.
Variables bumped_x bumped_y bumped_z view_x view_y view_z towards_x towards_y towards_z mu : R.
Definition specular_base := Rmax 0 (2 * mu * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z) - towards_x *
    view_x - towards_y * view_y - towards_z * view_z).
End program.
Ltac lines := unfold specular_base.
End phong_highlight.

Module squared_highlight.
Section program.
Variables bumped_x bumped_y bumped_z halfway_x halfway_y halfway_z light_distance : R.
Definition halfway_squared := halfway_x ^ 2 + halfway_y ^ 2 + halfway_z ^ 2.
Definition along_halfway := Rmax 0 (bumped_x * halfway_x + bumped_y * halfway_y + bumped_z * halfway_z).
Definition light_scale := if Rlt_dec 0 halfway_squared then 1 / (halfway_squared * light_distance) else 0.
Definition specular_base := along_halfway ^ 2 * light_distance * light_scale.
End program.
Ltac lines := unfold specular_base, light_scale, along_halfway, halfway_squared.
End squared_highlight.

Module highlight.
Section program.
Variables specular_base shininess : R.
Definition specular := power specular_base shininess.
End program.
Ltac lines := unfold specular.
End highlight.

Module ambient_term.
Section program.
Variables ka ambient : R.
Definition color := ambient * ka.
End program.
Ltac lines := unfold color.
End ambient_term.

Module light_term.
Section program.
Variables red green blue light_red light_green light_blue albedo_red albedo_green albedo_blue kd ks mu specular : R.
Definition diffuse := kd * (Rmax 0 mu).
Definition shine := ks * specular.
Definition lit_red := light_red * (albedo_red * diffuse + shine) + red.
Definition lit_green := green + light_green * (albedo_green * diffuse + shine).
Definition lit_blue := blue + light_blue * (albedo_blue * diffuse + shine).
End program.
Ltac lines := unfold lit_blue, lit_green, lit_red, shine, diffuse.
End light_term.

Module clip.
Section program.
Variables color : R.
Definition clipped := Rmin 1 (Rmax 0 color).
End program.
Ltac lines := unfold clipped.
End clip.

Module floor_albedo.
Section program.
Variables floor_dark floor_tint : R.
Definition floor_base := if Rlt_dec 0 floor_dark then (3 / 20) else (17 / 20).
Definition floor_red := floor_base * (1 - floor_tint).
Definition floor_blue := floor_base.
End program.
Ltac lines := unfold floor_blue, floor_red, floor_base.
End floor_albedo.

Module shadow.
Section program.
Variables point_x point_y point_z light_x light_y light_z center_x center_y center_z body_radius : R.
Definition segment_x := light_x - point_x.
Definition segment_y := light_y - point_y.
Definition segment_z := light_z - point_z.
Definition offset_x := center_x - point_x.
Definition offset_y := center_y - point_y.
Definition offset_z := center_z - point_z.
Definition segment_squared := segment_x ^ 2 + segment_y ^ 2 + segment_z ^ 2.
Definition toward_center := offset_x * segment_x + offset_y * segment_y + offset_z * segment_z.
Definition shadow_discriminant := body_radius ^ 2 * segment_squared - (offset_y * segment_x - offset_x * segment_y) ^ 2
    - (offset_x * segment_z - offset_z * segment_x) ^ 2 - (offset_z * segment_y - offset_y * segment_z) ^ 2.
Definition occluded := if both (both (Rlt_dec toward_center segment_squared) (Rle_dec 0 shadow_discriminant)) (Rlt_dec 0
    toward_center) then 1 else 0.
End program.
Ltac lines := unfold occluded, shadow_discriminant, toward_center, segment_squared, offset_z, offset_y, offset_x,
    segment_z, segment_y, segment_x.
End shadow.

Module checker.
Section program.
Variables point_x point_y : R.
Definition square := IZR (Int_part point_x) + IZR (Int_part point_y).
Definition dark := if both (both (differ point_x (IZR (Int_part point_x))) (differ point_y (IZR (Int_part point_y))))
    (differ square (2 * (IZR (Int_part ((1 / 2) * square))))) then 1 else 0.
End program.
Ltac lines := unfold dark, square.
End checker.

Module shadow_clearance.
Section program.
Variables light_x light_y light_z center_x center_y center_z body_radius ball_center_x ball_center_y ball_center_z
    ball_radius : R.
Definition from_body_x := light_x - center_x.
Definition from_body_y := light_y - center_y.
Definition from_body_z := light_z - center_z.
Definition along_x := ball_center_x - light_x.
Definition along_y := ball_center_y - light_y.
Definition along_z := ball_center_z - light_z.
Definition at_light := from_body_x ^ 2 - body_radius ^ 2 + from_body_y ^ 2 + from_body_z ^ 2.
Definition half_slope := along_x * from_body_x + along_y * from_body_y + along_z * from_body_z - ball_radius *
    body_radius.
Definition curvature := along_x ^ 2 + along_y ^ 2 + along_z ^ 2 - ball_radius ^ 2.
Definition turning := if Rle_dec 0 half_slope then 0 else if Rle_dec (curvature + half_slope) 0 then 1 else -half_slope
    / curvature.
Definition at_ball := at_light + curvature + 2 * half_slope.
Definition at_turning := at_light + turning * (curvature * turning + 2 * half_slope).
Definition at_an_end := if Rlt_dec at_ball at_light then at_ball else at_light.
Definition shortest := if Rlt_dec at_turning at_an_end then at_turning else at_an_end.
Definition clearance := shortest / (along_x ^ 2 + along_y ^ 2 + along_z ^ 2 + from_body_x ^ 2 + from_body_y ^ 2 +
    from_body_z ^ 2).
End program.
Ltac lines := unfold clearance, shortest, at_an_end, at_turning, at_ball, turning, curvature, half_slope, at_light,
    along_z, along_y, along_x, from_body_z, from_body_y, from_body_x.
End shadow_clearance.

Module complex_square.
Section program.
Variables real_part imaginary_part : R.
Definition product_real := (real_part - imaginary_part) * (imaginary_part + real_part).
Definition product_imaginary := 2 * imaginary_part * real_part.
End program.
Ltac lines := unfold product_imaginary, product_real.
End complex_square.

Module complex_product.
Section program.
Variables real_part imaginary_part other_real other_imaginary : R.
Definition product_real := other_real * real_part - imaginary_part * other_imaginary.
Definition product_imaginary := imaginary_part * other_real + other_imaginary * real_part.
End program.
Ltac lines := unfold product_imaginary, product_real.
End complex_product.

Module algebraic_bases.
Section program.
Variables cos_theta sin_theta cos_phi sin_phi : R.
Definition base_u_real := -cos_theta.
Definition base_u_imaginary := -sin_theta.
Definition base_v_real := cos_phi.
Definition base_v_imaginary := sin_phi.
End program.
Ltac lines := unfold base_v_imaginary, base_v_real, base_u_imaginary, base_u_real.
End algebraic_bases.

Module angular_slopes.
Section program.
Variables h_u h_v : R.
Definition h_theta := (1 / 2) * h_u / PI.
Definition h_phi := h_v / PI.
End program.
Ltac lines := unfold h_phi, h_theta.
End angular_slopes.

Module displaced_normal.
Section program.
Variables cos_theta sin_theta cos_phi sin_phi h_u h_v beta h : R.
Definition normal_x := cos_theta * sin_phi.
Definition normal_y := sin_phi * sin_theta.
Definition normal_z := cos_phi.
Definition e_theta_x := -sin_theta.
Definition e_theta_y := cos_theta.
Definition e_theta_z := 0.
Definition e_phi_x := cos_phi * cos_theta.
Definition e_phi_y := cos_phi * sin_theta.
Definition e_phi_z := -sin_phi.
Definition h_theta := (1 / 2) * h_u / PI.
Definition h_phi := h_v / PI.
Definition lift := beta * h + 1.
Definition displaced_x := lift * normal_x - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi).
Definition displaced_y := lift * normal_y - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi).
Definition displaced_z := lift * normal_z - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi).
End program.
Ltac lines := unfold displaced_z, displaced_y, displaced_x, lift, h_phi, h_theta, e_phi_z, e_phi_y, e_phi_x, e_theta_z,
    e_theta_y, e_theta_x, normal_z, normal_y, normal_x.
End displaced_normal.

Module blinn_normal.
Section program.
Variables cos_theta sin_theta cos_phi sin_phi h_u h_v beta : R.
Definition normal_x := cos_theta * sin_phi.
Definition normal_y := sin_phi * sin_theta.
Definition normal_z := cos_phi.
Definition e_theta_x := -sin_theta.
Definition e_theta_y := cos_theta.
Definition e_theta_z := 0.
Definition e_phi_x := cos_phi * cos_theta.
Definition e_phi_y := cos_phi * sin_theta.
Definition e_phi_z := -sin_phi.
Definition h_theta := (1 / 2) * h_u / PI.
Definition h_phi := h_v / PI.
Definition lift := 1.
Definition displaced_x := lift * normal_x - beta * (e_phi_x * h_phi + e_theta_x * h_theta / sin_phi).
Definition displaced_y := lift * normal_y - beta * (e_phi_y * h_phi + e_theta_y * h_theta / sin_phi).
Definition displaced_z := lift * normal_z - beta * (e_phi_z * h_phi + e_theta_z * h_theta / sin_phi).
End program.
Ltac lines := unfold displaced_z, displaced_y, displaced_x, lift, h_phi, h_theta, e_phi_z, e_phi_y, e_phi_x, e_theta_z,
    e_theta_y, e_theta_x, normal_z, normal_y, normal_x.
End blinn_normal.

Module surface_slopes.
Section program.
Variables sin_phi radius h_u h_v : R.
Definition arc := -PI * radius.
Definition slope_theta := if Rlt_dec 0 sin_phi then (1 / 2) * h_u / (arc * sin_phi) else 0.
Definition slope_phi := if Rlt_dec 0 sin_phi then h_v / arc else 0.
End program.
Ltac lines := unfold slope_phi, slope_theta, arc.
End surface_slopes.

Module surface_normal.
Section program.
Variables sin_phi radius h_u h_v cos_theta sin_theta cos_phi beta : R.
Definition arc := -PI * radius.
Definition slope_theta := if Rlt_dec 0 sin_phi then (1 / 2) * h_u / (arc * sin_phi) else 0.
Definition slope_phi := if Rlt_dec 0 sin_phi then h_v / arc else 0.
Definition normal_x := cos_theta * sin_phi.
Definition normal_y := sin_phi * sin_theta.
Definition normal_z := cos_phi.
Definition e_theta_x := -sin_theta.
Definition e_theta_y := cos_theta.
Definition e_theta_z := 0.
Definition e_phi_x := cos_phi * cos_theta.
Definition e_phi_y := cos_phi * sin_theta.
Definition e_phi_z := -sin_phi.
Definition g_x := e_phi_x * slope_phi + e_theta_x * slope_theta.
Definition g_y := e_phi_y * slope_phi + e_theta_y * slope_theta.
Definition g_z := e_phi_z * slope_phi + e_theta_z * slope_theta.
Definition m_x := beta * g_x + normal_x.
Definition m_y := beta * g_y + normal_y.
Definition m_z := beta * g_z + normal_z.
Definition m_length := sqrt (m_x ^ 2 + m_y ^ 2 + m_z ^ 2).
Definition m_scale := / m_length.
Definition bumped_x := m_scale * m_x.
Definition bumped_y := m_scale * m_y.
Definition bumped_z := m_scale * m_z.
End program.
Ltac lines := unfold bumped_z, bumped_y, bumped_x, m_scale, m_length, m_z, m_y, m_x, g_z, g_y, g_x, e_phi_z, e_phi_y,
    e_phi_x, e_theta_z, e_theta_y, e_theta_x, normal_z, normal_y, normal_x, slope_phi, slope_theta, arc.
End surface_normal.

Module mu_derivative.
Section program.
Variables towards_x towards_y towards_z bumped_by_beta_x bumped_by_beta_y bumped_by_beta_z : R.
Definition mu_by_beta := bumped_by_beta_x * towards_x + bumped_by_beta_y * towards_y + bumped_by_beta_z * towards_z.
End program.
Ltac lines := unfold mu_by_beta.
End mu_derivative.

Module term_derivative.
Section program.
Variables mu mu_by_beta specular_base base_by_beta shininess kd ks albedo_red light_red : R.
Definition diffuse_by_beta := if Rlt_dec 0 mu then kd * mu_by_beta else 0.
Definition shine_by_beta := if Rlt_dec 0 specular_base then base_by_beta * ks * shininess * power specular_base
    (shininess - 1) else 0.
Definition term_by_beta := light_red * (albedo_red * diffuse_by_beta + shine_by_beta).
End program.
Ltac lines := unfold term_by_beta, shine_by_beta, diffuse_by_beta.
End term_derivative.

Module clip_derivative.
Section program.
Variables color term_by_beta : R.
Definition clipped := if both (Rlt_dec color 1) (Rlt_dec 0 color) then term_by_beta else 0.
End program.
Ltac lines := unfold clipped.
End clip_derivative.

Module blinn_base_derivative.
Section program.
Variables halfway_x halfway_y halfway_z halfway_length bumped_by_beta_x bumped_by_beta_y bumped_by_beta_z : R.
Definition base_by_beta := (bumped_by_beta_x * halfway_x + bumped_by_beta_y * halfway_y + bumped_by_beta_z * halfway_z)
    / halfway_length.
End program.
Ltac lines := unfold base_by_beta.
End blinn_base_derivative.

Module phong_base_derivative.
Section program.
Variables view_x view_y view_z bumped_x bumped_y bumped_z bumped_by_beta_x bumped_by_beta_y bumped_by_beta_z mu
    mu_by_beta : R.
Definition base_by_beta := 2 * mu * (bumped_by_beta_x * view_x + bumped_by_beta_y * view_y + bumped_by_beta_z * view_z)
    + 2 * mu_by_beta * (bumped_x * view_x + bumped_y * view_y + bumped_z * view_z).
End program.
Ltac lines := unfold base_by_beta.
End phong_base_derivative.

Module half_turn_polynomials.
Section program.
Variables remainder : R.
Definition z := remainder ^ 2.
Definition sine_tail := z * (z * (z * (z * (z * (z * (z * ((7510502657307481 / 9444732965739290427392) * z +
    (-1617067665348049 / 73786976294838206464)) + (8601768518847843 / 18446744073709551616)) + (-8497528335533855 /
    1152921504606846976)) + (2959617474655169 / 36028797018963968)) + (-2698847510945475 / 4503599627370496)) +
    (2871229454931313 / 1125899906842624)) + (-5818327337647699 / 1125899906842624)) + (4967757600021511 /
    40564819207303340847894502572032).
Definition sine_near := remainder * (sine_tail + (884279719003555 / 281474976710656)).
Definition cosine_near := z * (z * (z * (z * (z * (z * (z * ((5080167897815029 / 1180591620717411303424) * z +
    (-7720929367626383 / 73786976294838206464)) + (8898590864194755 / 4611686018427387904)) + (-1859582503162531 /
    72057594037927936)) + (8478679513545403 / 36028797018963968)) + (-3006744454127613 / 2251799813685248)) +
    (1142425901258417 / 281474976710656)) + (-2778046668940015 / 562949953421312)) + 1.
End program.
Ltac lines := unfold cosine_near, sine_near, sine_tail, z.
End half_turn_polynomials.

Module arctangent_polynomial.
Section program.
Variables ratio node_correction : R.
Definition ratio_squared := ratio ^ 2.
Definition arctangent_tail := ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared *
    (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared * (ratio_squared
    * (ratio_squared * (ratio_squared * ((790918777823815 / 72057594037927936) - (5919134079197583 / 576460752303423488)
    * ratio_squared) + (-6796042831671299 / 576460752303423488)) + (7339726258205003 / 576460752303423488)) +
    (-7977963324135873 / 576460752303423488)) + (2184442338751489 / 144115188075855872)) + (-2414383637567435 /
    144115188075855872)) + (1349214385699449 / 72057594037927936)) + (-6116438548504169 / 288230376151711744)) +
    (441089318401743 / 18014398509481984)) + (-8340598020687503 / 288230376151711744)) + (2548516061876737 /
    72057594037927936)) + (-6553327016254467 / 144115188075855872)) + (4587328911378127 / 72057594037927936)) +
    (-1911387046407553 / 18014398509481984)) + (-3193047846271019 / 162259276829213363391578010288128).
Definition small_part := node_correction + ratio * (arctangent_tail + (5734161139222659 / 18014398509481984)).
End program.
Ltac lines := unfold small_part, arctangent_tail, ratio_squared.
End arctangent_polynomial.

Module exponential_polynomial.
Section program.
Variables away away_error : R.
Definition away_squared := away ^ 2.
Definition exponential_tail := away * (away_squared * (away_squared * (away_squared * (away_squared * ((6212541674450185
    / 38685626227668133590597632) * away_squared + (1892883791434041 / 75557863725914323419136)) + (1626697008263629 /
    590295810358705651712)) + (3660068268593165 / 18446744073709551616)) + (4803839602528529 / 576460752303423488)) +
    (6004799503160661 / 36028797018963968)) + away_squared * (away_squared * (away_squared * (away_squared *
    ((630961263811347 / 302231454903657293676544) * away_squared + (1301357606610903 / 4722366482869645213696)) +
    (3660068268593165 / 147573952589676412928)) + (6405119470038039 / 4611686018427387904)) + (6004799503160661 /
    144115188075855872)) + (1 / 2).
Definition departure_low := away_error + away_squared * exponential_tail.
Definition departure := away + departure_low.
Definition exponential_near := departure + 1.
End program.
Ltac lines := unfold exponential_near, departure, departure_low, exponential_tail, away_squared.
End exponential_polynomial.

Module logarithm_polynomial.
Section program.
Variables quotient : R.
Definition quotient_squared := quotient ^ 2.
Definition log_tail := quotient * quotient_squared * (quotient_squared * (quotient_squared * (quotient_squared *
    (quotient_squared * ((1385722962267845 / 9007199254740992) * quotient_squared + (3275345183542179 /
    18014398509481984)) + (2001599834386887 / 9007199254740992)) + (2573485501354569 / 9007199254740992)) +
    (3602879701896397 / 9007199254740992)) + (6004799503160661 / 9007199254740992)).
End program.
Ltac lines := unfold log_tail, quotient_squared.
End logarithm_polynomial.

Module height_sine.
Section program.
Variables u v k_u k_v : R.
Definition h := (sin (PI * (k_u * u))) * (sin (PI * (k_v * v))).
End program.
Ltac lines := unfold h.
End height_sine.

Module gradient_sine.
Section program.
Variables u v k_u k_v : R.
Definition cos_u := cos (PI * (k_u * u)).
Definition cos_v := cos (PI * (k_v * v)).
Definition sin_u := sin (PI * (k_u * u)).
Definition sin_v := sin (PI * (k_v * v)).
Definition h_u := PI * cos_u * k_u * sin_v.
Definition h_v := PI * cos_v * k_v * sin_u.
End program.
Ltac lines := unfold h_v, h_u, sin_v, sin_u, cos_v, cos_u.
End gradient_sine.

Module forward_sine.
Section program.
Variables u v k_u k_v epsilon : R.
Definition u_plus := epsilon + u - (IZR (Int_part (epsilon + u))).
Definition stepped := if Rle_dec (epsilon + v) 1 then epsilon + v else v - epsilon.
Definition h_here := (sin (PI * (k_u * u))) * (sin (PI * (k_v * v))).
Definition h_u_plus := (sin (PI * (k_u * u_plus))) * (sin (PI * (k_v * v))).
Definition h_v_plus := (sin (PI * (k_u * u))) * (sin (PI * (k_v * stepped))).
Definition h_u := (h_u_plus - h_here) / epsilon.
Definition h_v := if Rle_dec (epsilon + v) 1 then (h_v_plus - h_here) / epsilon else (h_here - h_v_plus) / epsilon.
End program.
Ltac lines := unfold h_v, h_u, h_v_plus, h_u_plus, h_here, stepped, u_plus.
End forward_sine.

Module central_sine.
Section program.
Variables u v k_u k_v epsilon : R.
Definition u_plus := epsilon + u - (IZR (Int_part (epsilon + u))).
Definition u_minus := u - epsilon - (IZR (Int_part (u - epsilon))).
Definition v_plus := Rmin 1 (epsilon + v).
Definition v_minus := Rmax (v - epsilon) 0.
Definition span_v := if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus.
Definition h_u_plus := (sin (PI * (k_u * u_plus))) * (sin (PI * (k_v * v))).
Definition h_u_minus := (sin (PI * (k_u * u_minus))) * (sin (PI * (k_v * v))).
Definition h_v_plus := (sin (PI * (k_u * u))) * (sin (PI * (k_v * v_plus))).
Definition h_v_minus := (sin (PI * (k_u * u))) * (sin (PI * (k_v * v_minus))).
Definition h_u := (1 / 2) * (h_u_plus - h_u_minus) / epsilon.
Definition h_v := (h_v_plus - h_v_minus) / span_v.
End program.
Ltac lines := unfold h_v, h_u, h_v_minus, h_v_plus, h_u_minus, h_u_plus, span_v, v_minus, v_plus, u_minus, u_plus.
End central_sine.

Module central4_sine.
Section program.
Variables u v k_u k_v epsilon : R.
Definition u_plus := epsilon + u - (IZR (Int_part (epsilon + u))).
Definition u_minus := u - epsilon - (IZR (Int_part (u - epsilon))).
Definition v_plus := Rmin 1 (epsilon + v).
Definition v_minus := Rmax (v - epsilon) 0.
Definition span_v := if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus.
Definition u_plus_2 := 2 * epsilon + u - (IZR (Int_part (2 * epsilon + u))).
Definition u_minus_2 := u - 2 * epsilon - (IZR (Int_part (u - 2 * epsilon))).
Definition v_plus_2 := Rmin 1 (2 * epsilon + v).
Definition v_minus_2 := Rmax (v - 2 * epsilon) 0.
Definition h_u_plus := (sin (PI * (k_u * u_plus))) * (sin (PI * (k_v * v))).
Definition h_u_minus := (sin (PI * (k_u * u_minus))) * (sin (PI * (k_v * v))).
Definition h_v_plus := (sin (PI * (k_u * u))) * (sin (PI * (k_v * v_plus))).
Definition h_v_minus := (sin (PI * (k_u * u))) * (sin (PI * (k_v * v_minus))).
Definition h_u_plus_2 := (sin (PI * (k_u * u_plus_2))) * (sin (PI * (k_v * v))).
Definition h_u_minus_2 := (sin (PI * (k_u * u_minus_2))) * (sin (PI * (k_v * v))).
Definition h_v_plus_2 := (sin (PI * (k_u * u))) * (sin (PI * (k_v * v_plus_2))).
Definition h_v_minus_2 := (sin (PI * (k_u * u))) * (sin (PI * (k_v * v_minus_2))).
Definition near_difference_u := h_u_plus - h_u_minus.
Definition h_u := (1 / 12) * (h_u_minus_2 - h_u_plus_2 + 8 * near_difference_u) / epsilon.
Definition near_difference_v := h_v_plus - h_v_minus.
Definition h_v := if both (Rle_dec (2 * epsilon + v) 1) (Rle_dec (2 * epsilon - v) 0) then (1 / 12) * (h_v_minus_2 -
    h_v_plus_2 + 8 * near_difference_v) / epsilon else near_difference_v / span_v.
End program.
Ltac lines := unfold h_v, near_difference_v, h_u, near_difference_u, h_v_minus_2, h_v_plus_2, h_u_minus_2, h_u_plus_2,
    h_v_minus, h_v_plus, h_u_minus, h_u_plus, v_minus_2, v_plus_2, u_minus_2, u_plus_2, span_v, v_minus, v_plus,
    u_minus, u_plus.
End central4_sine.

Module height_ridges.
Section program.
Variables u v k_u k_v : R.
Definition h := Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))).
End program.
Ltac lines := unfold h.
End height_ridges.

Module gradient_ridges.
Section program.
Variables u v k_u k_v : R.
Definition cos_u := cos (PI * (k_u * u)).
Definition cos_v := cos (PI * (k_v * v)).
Definition sin_u := sin (PI * (k_u * u)).
Definition sin_v := sin (PI * (k_v * v)).
Definition h_u := PI * cos_u * k_u * sin_v * (sign (sin_u * sin_v)).
Definition h_v := PI * cos_v * k_v * sin_u * (sign (sin_u * sin_v)).
End program.
Ltac lines := unfold h_v, h_u, sin_v, sin_u, cos_v, cos_u.
End gradient_ridges.

Module forward_ridges.
Section program.
Variables u v k_u k_v epsilon : R.
Definition u_plus := epsilon + u - (IZR (Int_part (epsilon + u))).
Definition stepped := if Rle_dec (epsilon + v) 1 then epsilon + v else v - epsilon.
Definition h_here := Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v)))).
Definition h_u_plus := Rabs ((sin (PI * (k_u * u_plus))) * (sin (PI * (k_v * v)))).
Definition h_v_plus := Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * stepped)))).
Definition h_u := (h_u_plus - h_here) / epsilon.
Definition h_v := if Rle_dec (epsilon + v) 1 then (h_v_plus - h_here) / epsilon else (h_here - h_v_plus) / epsilon.
End program.
Ltac lines := unfold h_v, h_u, h_v_plus, h_u_plus, h_here, stepped, u_plus.
End forward_ridges.

Module central_ridges.
Section program.
Variables u v k_u k_v epsilon : R.
Definition u_plus := epsilon + u - (IZR (Int_part (epsilon + u))).
Definition u_minus := u - epsilon - (IZR (Int_part (u - epsilon))).
Definition v_plus := Rmin 1 (epsilon + v).
Definition v_minus := Rmax (v - epsilon) 0.
Definition span_v := if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus.
Definition h_u_plus := Rabs ((sin (PI * (k_u * u_plus))) * (sin (PI * (k_v * v)))).
Definition h_u_minus := Rabs ((sin (PI * (k_u * u_minus))) * (sin (PI * (k_v * v)))).
Definition h_v_plus := Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v_plus)))).
Definition h_v_minus := Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v_minus)))).
Definition h_u := (1 / 2) * (h_u_plus - h_u_minus) / epsilon.
Definition h_v := (h_v_plus - h_v_minus) / span_v.
End program.
Ltac lines := unfold h_v, h_u, h_v_minus, h_v_plus, h_u_minus, h_u_plus, span_v, v_minus, v_plus, u_minus, u_plus.
End central_ridges.

Module central4_ridges.
Section program.
Variables u v k_u k_v epsilon : R.
Definition u_plus := epsilon + u - (IZR (Int_part (epsilon + u))).
Definition u_minus := u - epsilon - (IZR (Int_part (u - epsilon))).
Definition v_plus := Rmin 1 (epsilon + v).
Definition v_minus := Rmax (v - epsilon) 0.
Definition span_v := if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus.
Definition u_plus_2 := 2 * epsilon + u - (IZR (Int_part (2 * epsilon + u))).
Definition u_minus_2 := u - 2 * epsilon - (IZR (Int_part (u - 2 * epsilon))).
Definition v_plus_2 := Rmin 1 (2 * epsilon + v).
Definition v_minus_2 := Rmax (v - 2 * epsilon) 0.
Definition h_u_plus := Rabs ((sin (PI * (k_u * u_plus))) * (sin (PI * (k_v * v)))).
Definition h_u_minus := Rabs ((sin (PI * (k_u * u_minus))) * (sin (PI * (k_v * v)))).
Definition h_v_plus := Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v_plus)))).
Definition h_v_minus := Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v_minus)))).
Definition h_u_plus_2 := Rabs ((sin (PI * (k_u * u_plus_2))) * (sin (PI * (k_v * v)))).
Definition h_u_minus_2 := Rabs ((sin (PI * (k_u * u_minus_2))) * (sin (PI * (k_v * v)))).
Definition h_v_plus_2 := Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v_plus_2)))).
Definition h_v_minus_2 := Rabs ((sin (PI * (k_u * u))) * (sin (PI * (k_v * v_minus_2)))).
Definition near_difference_u := h_u_plus - h_u_minus.
Definition h_u := (1 / 12) * (h_u_minus_2 - h_u_plus_2 + 8 * near_difference_u) / epsilon.
Definition near_difference_v := h_v_plus - h_v_minus.
Definition h_v := if both (Rle_dec (2 * epsilon + v) 1) (Rle_dec (2 * epsilon - v) 0) then (1 / 12) * (h_v_minus_2 -
    h_v_plus_2 + 8 * near_difference_v) / epsilon else near_difference_v / span_v.
End program.
Ltac lines := unfold h_v, near_difference_v, h_u, near_difference_u, h_v_minus_2, h_v_plus_2, h_u_minus_2, h_u_plus_2,
    h_v_minus, h_v_plus, h_u_minus, h_u_plus, v_minus_2, v_plus_2, u_minus_2, u_plus_2, span_v, v_minus, v_plus,
    u_minus, u_plus.
End central4_ridges.

Module height_rings.
Section program.
Variables u v k_u k_v : R.
Definition h := sin (PI * (2 * k_v * v)).
End program.
Ltac lines := unfold h.
End height_rings.

Module gradient_rings.
Section program.
Variables u v k_u k_v : R.
Definition cos_v := cos (PI * (2 * k_v * v)).
Definition sin_v := sin (PI * (2 * k_v * v)).
Definition h_u := 0.
Definition h_v := 2 * PI * cos_v * k_v.
End program.
Ltac lines := unfold h_v, h_u, sin_v, cos_v.
End gradient_rings.

Module forward_rings.
Section program.
Variables u v k_u k_v epsilon : R.
Definition u_plus := epsilon + u - (IZR (Int_part (epsilon + u))).
Definition stepped := if Rle_dec (epsilon + v) 1 then epsilon + v else v - epsilon.
Definition h_here := sin (PI * (2 * k_v * v)).
Definition h_u_plus := sin (PI * (2 * k_v * v)).
Definition h_v_plus := sin (PI * (2 * k_v * stepped)).
Definition h_u := (h_u_plus - h_here) / epsilon.
Definition h_v := if Rle_dec (epsilon + v) 1 then (h_v_plus - h_here) / epsilon else (h_here - h_v_plus) / epsilon.
End program.
Ltac lines := unfold h_v, h_u, h_v_plus, h_u_plus, h_here, stepped, u_plus.
End forward_rings.

Module central_rings.
Section program.
Variables u v k_u k_v epsilon : R.
Definition u_plus := epsilon + u - (IZR (Int_part (epsilon + u))).
Definition u_minus := u - epsilon - (IZR (Int_part (u - epsilon))).
Definition v_plus := Rmin 1 (epsilon + v).
Definition v_minus := Rmax (v - epsilon) 0.
Definition span_v := if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus.
Definition h_u_plus := sin (PI * (2 * k_v * v)).
Definition h_u_minus := sin (PI * (2 * k_v * v)).
Definition h_v_plus := sin (PI * (2 * k_v * v_plus)).
Definition h_v_minus := sin (PI * (2 * k_v * v_minus)).
Definition h_u := (1 / 2) * (h_u_plus - h_u_minus) / epsilon.
Definition h_v := (h_v_plus - h_v_minus) / span_v.
End program.
Ltac lines := unfold h_v, h_u, h_v_minus, h_v_plus, h_u_minus, h_u_plus, span_v, v_minus, v_plus, u_minus, u_plus.
End central_rings.

Module central4_rings.
Section program.
Variables u v k_u k_v epsilon : R.
Definition u_plus := epsilon + u - (IZR (Int_part (epsilon + u))).
Definition u_minus := u - epsilon - (IZR (Int_part (u - epsilon))).
Definition v_plus := Rmin 1 (epsilon + v).
Definition v_minus := Rmax (v - epsilon) 0.
Definition span_v := if both (Rle_dec (epsilon + v) 1) (Rle_dec (epsilon - v) 0) then 2 * epsilon else v_plus - v_minus.
Definition u_plus_2 := 2 * epsilon + u - (IZR (Int_part (2 * epsilon + u))).
Definition u_minus_2 := u - 2 * epsilon - (IZR (Int_part (u - 2 * epsilon))).
Definition v_plus_2 := Rmin 1 (2 * epsilon + v).
Definition v_minus_2 := Rmax (v - 2 * epsilon) 0.
Definition h_u_plus := sin (PI * (2 * k_v * v)).
Definition h_u_minus := sin (PI * (2 * k_v * v)).
Definition h_v_plus := sin (PI * (2 * k_v * v_plus)).
Definition h_v_minus := sin (PI * (2 * k_v * v_minus)).
Definition h_u_plus_2 := sin (PI * (2 * k_v * v)).
Definition h_u_minus_2 := sin (PI * (2 * k_v * v)).
Definition h_v_plus_2 := sin (PI * (2 * k_v * v_plus_2)).
Definition h_v_minus_2 := sin (PI * (2 * k_v * v_minus_2)).
Definition near_difference_u := h_u_plus - h_u_minus.
Definition h_u := (1 / 12) * (h_u_minus_2 - h_u_plus_2 + 8 * near_difference_u) / epsilon.
Definition near_difference_v := h_v_plus - h_v_minus.
Definition h_v := if both (Rle_dec (2 * epsilon + v) 1) (Rle_dec (2 * epsilon - v) 0) then (1 / 12) * (h_v_minus_2 -
    h_v_plus_2 + 8 * near_difference_v) / epsilon else near_difference_v / span_v.
End program.
Ltac lines := unfold h_v, near_difference_v, h_u, near_difference_u, h_v_minus_2, h_v_plus_2, h_u_minus_2, h_u_plus_2,
    h_v_minus, h_v_plus, h_u_minus, h_u_plus, v_minus_2, v_plus_2, u_minus_2, u_plus_2, span_v, v_minus, v_plus,
    u_minus, u_plus.
End central4_rings.
