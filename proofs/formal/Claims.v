(* Claims whose printed form follows without a theory of its own: frames, the chart, seams and light. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Camera Claim Hits Derivatives.
From Formal Require Statements.
Open Scope R_scope.

Ltac given := first [assumption | lra | nra | apply Rgt_not_eq; lra].

Theorem stable_frame__angles : Statements.stable_frame__angles.
Proof.
  hit.
  assert (I : rho_inverse * rho = 1) by (unfold rho_inverse; destruct Rlt_dec; [field |]; lra).
  assert (Z : eye ^ 2 + root_a > 0) by nra. assert (V : t1 = tangent_squared / (eye ^ 2 + root_a)) by (rewrite T, <- TR; field; lra).
  assert (F1 : radius * sin_phi = rho * t1) by (unfold sin_phi, hit_scale; rewrite V; field; lra).
  assert (F2 : cos_phi * radius = eye * (1 - t1)) by (unfold cos_phi, hit_scale; rewrite V, T; field; lra).
  assert (F3 : cos_theta * radius * sin_phi = t1 * x) by (unfold cos_theta; transitivity (rho_inverse * x * (radius * sin_phi)); [ring | rewrite F1;
    transitivity (rho_inverse * rho * t1 * x); [ring | rewrite I; ring]]).
  assert (F4 : radius * sin_phi * sin_theta = t1 * y) by (unfold sin_theta; rewrite F1; transitivity (rho_inverse * rho * t1 * y); [ring | rewrite I; ring]).
  assert (F5 : cos_theta ^ 2 + sin_theta ^ 2 = 1) by (transitivity (rho_inverse ^ 2 * rho ^ 2); [rewrite RS; unfold cos_theta, sin_theta; ring |
    rewrite <- Rpow_mult_distr, I; ring]).
  assert (F6 : cos_phi ^ 2 + sin_phi ^ 2 = 1).
  { apply (Rmult_eq_reg_l (radius ^ 2)); [|nra]. transitivity ((cos_phi * radius) ^ 2 + (radius * sin_phi) ^ 2); [ring|]. rewrite F1, F2. transitivity
    (eye ^ 2 * (1 - t1) ^ 2 + rho ^ 2 * t1 ^ 2); [ring | rewrite RS; lra]. }
  assert (sin_phi > 0) by (assert (radius * sin_phi > 0) by (rewrite F1; nra); nra).
  each ltac:(first [assumption | lra | nra | intros; apply Rgt_not_eq; lra]).
Qed.
Theorem stable_frame__seed_frame : Statements.stable_frame__seed_frame.
Proof. claim. Qed.

Theorem seam__parity : Statements.seam__parity.
Proof.
  red. intros a A S n. assert (C : cos (PI * INR n) = a n /\ sin (PI * INR n) = 0).
  { induction n as [|n [C Z]]; [rewrite Rmult_0_r, cos_0, sin_0; auto|]. rewrite S, S_INR, Rmult_plus_distr_l, Rmult_1_r, cos_plus, sin_plus, C, Z,
    cos_PI, sin_PI. split; ring. }
  destruct C as [C Z]. repeat split; [exact C | exact Z |]. replace (2 * PI * INR n) with (2 * (PI * INR n)) by ring. rewrite cos_2a_sin, Z. ring.
Qed.
Theorem seam__even : Statements.seam__even.
Proof.
  red. intros ku kv u v C. assert (Z : sin (PI * ku) = 0) by (generalize (sin2_cos2 (PI * ku)); unfold Rsqr; rewrite C; nra).
  replace (PI * (0 * ku)) with 0 by ring. replace (PI * (1 * ku)) with (PI * ku) by ring.
  replace (PI * (ku * (u + 1))) with (PI * (ku * u) + PI * ku) by ring. rewrite sin_plus, sin_0, cos_0, C, Z. repeat split; ring.
Qed.
Theorem seam__ridges_crease : Statements.seam__ridges_crease.
Proof.
  red. intros ku kv s v Z. assert (C : cos (PI * ku) ^ 2 = 1) by (generalize (sin2_cos2 (PI * ku)); unfold Rsqr; rewrite Z; nra).
  replace (s * PI * ku) with (PI * (ku * s)) by ring. replace (PI * (ku * (1 - s))) with (PI * ku - PI * (ku * s)) by ring. rewrite sin_minus, Z.
  assert (E : (0 * cos (PI * (ku * s)) - cos (PI * ku) * sin (PI * (ku * s))) ^ 2 = sin (PI * (ku * s)) ^ 2) by (transitivity (cos (PI * ku) ^ 2 * sin
    (PI * (ku * s)) ^ 2); [ring | rewrite C; ring]).
  assert (F : Rabs (sin (PI * (ku * s)) * sin (PI * (kv * v))) = Rabs ((0 * cos (PI * (ku * s)) - cos (PI * ku) * sin (PI * (ku * s))) * sin (PI * (kv * v)))).
  { apply Rsqr_eq_abs_0. rewrite !Rsqr_pow2, !Rpow_mult_distr, E. reflexivity. }
  rewrite <- F. repeat split; try lra. rewrite pow2_abs. ring.
Qed.

Theorem kink_loci__projection : Statements.kink_loci__projection.
Proof.
  red. intros. unfold point_x, point_y, point_z in *. assert (C : cos_phi <= 1) by nra. assert (P : eye - cos_phi * radius > 0) by nra.
  assert (T : eye * t = eye - cos_phi * radius) by lra. assert (T0 : t > 0) by nra.
  assert (S : cos_theta * x + sin_theta * y = eye * radius * sin_phi / (eye - cos_phi * radius)).
  { rewrite <- T. apply (Rmult_eq_reg_l t); [|lra]. transitivity (cos_theta * (t * x) + sin_theta * (t * y)); [ring|]. put (t * x). put (t * y).
    transitivity ((cos_theta ^ 2 + sin_theta ^ 2) * radius * sin_phi); [ring | put (cos_theta ^ 2 + sin_theta ^ 2); field; lra]. }
  assert (N : sin_theta * x = cos_theta * y).
  { apply (Rmult_eq_reg_l t); [|lra]. transitivity (sin_theta * (t * x)); [ring|]. transitivity (cos_theta * (t * y)); [put (t * x); put (t * y); ring
    | ring]. }
  assert (G : eye * radius * sin_phi / (eye - cos_phi * radius) >= 0).
  { unfold Rdiv. apply Rle_ge, Rmult_le_pos; [apply Rmult_le_pos; nra | apply Rlt_le, Rinv_0_lt_compat; lra]. }
  assert (Q : x ^ 2 + y ^ 2 = (eye * radius * sin_phi / (eye - cos_phi * radius)) ^ 2).
  { rewrite <- S. transitivity ((cos_theta ^ 2 + sin_theta ^ 2) * (x ^ 2 + y ^ 2)); [rewrite H; ring|].
    transitivity ((cos_theta * x + sin_theta * y) ^ 2 + (sin_theta * x - cos_theta * y) ^ 2); [ring | rewrite N; ring]. }
  assert (Q2 : x ^ 2 + y ^ 2 = eye ^ 2 * radius ^ 2 * sin_phi ^ 2 / (eye - cos_phi * radius) ^ 2) by (rewrite Q; field; lra).
  assert (sqrt (x ^ 2 + y ^ 2) = eye * radius * sin_phi / (eye - cos_phi * radius)) by (rewrite Q; apply sqrt_pow2; lra).
  each ltac:(first [assumption | lra | nra | apply Rgt_not_eq; lra]).
Qed.

Theorem occlusion_by_signs__if : Statements.occlusion_by_signs__if.
Proof.
  red. intros. pose proof (sqrt_pos d) as R0. assert (RR : sqrt d ^ 2 = d) by (apply pow2_sqrt; lra). set (q := sqrt d) in *.
  assert (A : a > 0) by lra. assert (I : / a > 0) by (apply Rinv_0_lt_compat; lra). assert (N : (b - q) * (b + q) = a * c) by nra.
  assert (B : b - q > 0) by nra. assert (F1 : (a - b - q) * (q + a - b) = a * (c + a - 2 * b)) by nra. assert (F2 : (b - q) / a > 0) by (unfold Rdiv; nra).
  assert (F3 : (b - q) / a * a = b - q) by (field; lra). assert (F4 : 1 > (b - q) / a) by nra.
  assert (F5 : c + a * ((b - q) / a) ^ 2 - 2 * b * (b - q) / a = 0) by (apply (Rmult_eq_reg_l a); [field_simplify; nra | lra]).
  each ltac:(first [assumption | lra | apply Rgt_not_eq; lra]).
Qed.
Theorem occlusion_by_signs__only_if : Statements.occlusion_by_signs__only_if.
Proof.
  red. intros. assert (a * s ^ 2 >= 0) by nra. assert (b > 0) by nra. assert (a * (1 + s) - 2 * b > 0) by nra.
  assert ((a * s - b) ^ 2 = d) by (transitivity (a * (c + a * s ^ 2 - 2 * b * s) + (b ^ 2 - a * c)); [ring | put (c + a * s ^ 2 - 2 * b * s); lra]).
  pose proof (pow2_ge_0 (a * s - b)). each given.
Qed.

Theorem image_derivative__power_rule : Statements.image_derivative__power_rule.
Proof.
  red. intros slope x p b k P0 PS B0 BS K0 KS n. induction n as [|n I]; [rewrite B0, K0; ring|].
  rewrite BS, PS, KS. transitivity (b n * x * x + p n * slope * x); [ring | rewrite I; ring].
Qed.
Theorem pixels_off_the_pole__linear : Statements.pixels_off_the_pole__linear.
Proof.
  red. intros. assert (C : cos_phi <= 1) by nra. assert (P : eye - cos_phi * radius > 0) by nra.
  assert (R : rho * (eye - cos_phi * radius) = eye * radius * sin_phi) by (unfold rho; field; lra).
  assert (0 <= eye * radius * sin_phi) by (apply Rmult_le_pos; nra). assert (G : rho >= 0) by nra. assert (rho * radius * (1 - cos_phi) >= 0) by
    (apply Rle_ge, Rmult_le_pos; nra).
  each ltac:(first [assumption | lra | apply Rgt_not_eq; lra]).
Qed.
Theorem visible_parallels__falling : Statements.visible_parallels__falling.
Proof.
  red. intros a b A B C. pose proof PI_RGT_0. assert (E : cos (PI * a) - cos (PI * b) = sin (PI * (b - a) / 2) * 2 * sin (PI * (a + b) / 2)).
  { rewrite (form2 (PI * a) (PI * b)). replace ((PI * a - PI * b) / 2) with (- (PI * (b - a) / 2)) by field. rewrite sin_neg.
    replace ((PI * a + PI * b) / 2) with (PI * (a + b) / 2) by field. ring. }
  assert (sin (PI * (b - a) / 2) > 0) by (apply sin_gt_0; nra). assert (sin (PI * (a + b) / 2) > 0) by (apply sin_gt_0; nra).
  split; [exact E | nra].
Qed.

Theorem chart__range : Statements.chart__range.
Proof. red. intros. pose proof PI_RGT_0. assert (phi = v * PI) by (unfold v; field; lra). clearbody v. each shown. Qed.
Theorem chart__inside : Statements.chart__inside.
Proof. claim. Qed.
Theorem chart__seam : Statements.chart__seam.
Proof. claim. Qed.
Theorem chart__round_trip : Statements.chart__round_trip.
Proof.
  red. intros. unfold cos_theta, sin_theta, cos_phi, sin_phi. replace (PI * (2 * (1 / 2 * turn + 1 / 2))) with (PI * turn + PI) by field.
  replace (PI * (phi / PI)) with phi by (field; exact PI_neq0). rewrite neg_cos, neg_sin. repeat split; ring.
Qed.
Theorem chart__on_the_seam : Statements.chart__on_the_seam.
Proof. claim. Qed.
Theorem chart_inverse__formula : Statements.chart_inverse__formula.
Proof. claim. Qed.
Theorem chart_inverse__unit : Statements.chart_inverse__unit.
Proof. claim. Qed.
Theorem chart_inverse__recovered : Statements.chart_inverse__recovered.
Proof. claim. Qed.
Theorem tangent_frame__derivatives : Statements.tangent_frame__derivatives.
Proof. slopes. Qed.
Theorem tangent_frame__orthonormal : Statements.tangent_frame__orthonormal.
Proof. claim. Qed.
Theorem tangent_frame__right_handed : Statements.tangent_frame__right_handed.
Proof. claim. Qed.
Theorem unit_length__g_is_tangent : Statements.unit_length__g_is_tangent.
Proof. claim. Qed.
Theorem seam__sine : Statements.seam__sine.
Proof.
  red. intros. unfold h_jump, slope_jump. replace (PI * (0 * k_u)) with 0 by ring. replace (PI * (1 * k_u)) with (PI * k_u) by ring.
  replace (u * PI * k_u) with (PI * (k_u * u)) by ring. replace (PI * (k_u * (u + 1))) with (PI * (k_u * u) + PI * k_u) by ring.
  rewrite sin_plus, sin_0, cos_0. repeat split; ring.
Qed.
Theorem seam__odd : Statements.seam__odd.
Proof. claim. Qed.
Theorem seam__ridges : Statements.seam__ridges.
Proof. claim. Qed.
Theorem seam__ridges_jump : Statements.seam__ridges_jump.
Proof.
  red. intros. replace (PI * (0 * k_u)) with 0 by ring. replace (PI * (1 * k_u)) with (PI * k_u) by ring. rewrite sin_0, Rmult_0_l, Rabs_R0.
  assert (0 < Rabs (sin (PI * k_u) * sin (PI * (k_v * v)))); [|lra]. apply Rabs_pos_lt, Rmult_integral_contrapositive_currified; intro Z; rewrite Z in *; lra.
Qed.
Theorem seam__rings : Statements.seam__rings.
Proof. slopes. Qed.
Theorem kink_loci__elsewhere_above : Statements.kink_loci__elsewhere_above.
Proof. red; intros. each ltac:(first [slope | derivatives; shown]). Qed.
Theorem kink_loci__elsewhere_below : Statements.kink_loci__elsewhere_below.
Proof. red; intros. each ltac:(first [slope | derivatives; shown]). Qed.
Theorem lagrange_identity__of_b : Statements.lagrange_identity__of_b.
Proof. claim. Qed.
Theorem lagrange_identity__of_shadow : Statements.lagrange_identity__of_shadow.
Proof. claim. Qed.
Theorem shadow_of_a_on_floor__of_a : Statements.shadow_of_a_on_floor__of_a.
Proof. claim. Qed.
Theorem shadow_of_a_on_floor__behind_a : Statements.shadow_of_a_on_floor__behind_a.
Proof. claim. Qed.
Theorem mean_keeps_the_bound__one_more : Statements.mean_keeps_the_bound__one_more.
Proof. claim. Qed.
Theorem shadow_along_a_row__row : Statements.shadow_along_a_row__row.
Proof. slopes. Qed.
Theorem shadow_along_a_row__leading : Statements.shadow_along_a_row__leading.
Proof.
  red. intros. match goal with |- ex_derive_n ?f _ _ /\ _ => assert (T : is_derive_n f 2 x (2 * (body_radius ^ 2 - (light_y - center_y) ^ 2 - (light_z
    - center_z) ^ 2))) end.
  { eapply (next_derivative 1); [intro; simpl; auto_derive; [trivial | reflexivity] | auto_derive; [trivial | ring]]. }
  split; [eexists; exact T | exact (is_derive_n_unique _ _ _ _ T)].
Qed.
Theorem shadow_along_a_row__away : Statements.shadow_along_a_row__away.
Proof. claim. Qed.
Theorem difference_bound__light_0 : Statements.difference_bound__light_0.
Proof. claim. Qed.
Theorem difference_bound__clip : Statements.difference_bound__clip.
Proof. claim. Qed.
Theorem image_derivative__mu : Statements.image_derivative__mu.
Proof. red. intros. subst s. repeat split; slope. Qed.
Theorem image_derivative__blinn : Statements.image_derivative__blinn.
Proof. red. intros. subst s. repeat split; slope. Qed.
Theorem image_derivative__phong : Statements.image_derivative__phong.
Proof. red. intros. subst s. repeat split; slope. Qed.
Ltac pixel := red; intros; subst; derivatives; repeat match goal with |- context [Rmax 0 ?x] => first [rewrite (Rmax_right 0 x) by lra | rewrite
  (Rmax_left 0 x) by lra] end; repeat (destruct Rlt_dec; try lra);
  try match goal with H : ?d * ?b = ?r |- _ => replace d with (r / b) by (rewrite <- H; field; lra) end;
  repeat split; first [differentiable | intro; lra | ring | field; lra].
Theorem image_derivative__lit_shiny : Statements.image_derivative__lit_shiny.
Proof. pixel. Qed.
Theorem image_derivative__lit_dull : Statements.image_derivative__lit_dull.
Proof. pixel. Qed.
Theorem image_derivative__unlit_shiny : Statements.image_derivative__unlit_shiny.
Proof. pixel. Qed.
Theorem image_derivative__unlit_dull : Statements.image_derivative__unlit_dull.
Proof. pixel. Qed.
Theorem image_derivative__inside : Statements.image_derivative__inside.
Proof. claim. Qed.
Theorem image_derivative__above : Statements.image_derivative__above.
Proof. claim. Qed.
Theorem image_derivative__below : Statements.image_derivative__below.
Proof. claim. Qed.
Lemma extent_of_a : (5 / 4 * 4 * 1 / (sqrt (1 + 4) * sqrt (4 - 1))) ^ 2 = 5 / 3.
Proof.
  assert (Q : sqrt (1 + 4) ^ 2 = 5) by (rewrite pow2_sqrt; lra). assert (S : sqrt (4 - 1) ^ 2 = 3) by (rewrite pow2_sqrt; lra).
  assert (sqrt (1 + 4) > 0) by (apply sqrt_lt_R0; lra). assert (sqrt (4 - 1) > 0) by (apply sqrt_lt_R0; lra).
  transitivity (25 / (sqrt (1 + 4) ^ 2 * sqrt (4 - 1) ^ 2)); [field; split; lra | rewrite Q, S; field].
Qed.
Ltac of_raster m n := match goal with |- _ /\ _ /\ (?e * ?a) ^ 2 + (?e * ?b / 256) ^ 2 + 0 >= _ =>
  replace ((e * a) ^ 2 + (e * b / 256) ^ 2 + 0) with (e ^ 2 * ((1083 - 10 * n) ^ 2 / 1638400 + (2 * m - 255) ^ 2 / 65536)) by (set (extent := e); field);
  rewrite extent_of_a; assert ((2 * m - 255) ^ 2 >= 1) by nra; assert ((1083 - 10 * n) ^ 2 >= 9) by nra; repeat split; lra end.
Theorem pixels_off_the_pole__raster_above : Statements.pixels_off_the_pole__raster_above.
Proof. red. intros. of_raster m n. Qed.
Theorem pixels_off_the_pole__raster_below : Statements.pixels_off_the_pole__raster_below.
Proof. red. intros. of_raster m n. Qed.
Theorem pixels_off_the_pole__far : Statements.pixels_off_the_pole__far.
Proof. claim. Qed.
Theorem visible_parallels__nearer : Statements.visible_parallels__nearer.
Proof. claim. Qed.
Theorem visible_parallels__pole : Statements.visible_parallels__pole.
Proof. claim. Qed.
Theorem visible_parallels__count : Statements.visible_parallels__count.
Proof.
  red. assert (S : 1 < sqrt 2) by (rewrite <- sqrt_1; apply sqrt_lt_1; lra).
  assert (Q : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (F : cos (PI / 4) > 1 / 4) by (rewrite cos_PI4; unfold Rdiv; apply Rmult_lt_compat_l; [lra | apply Rinv_lt_contravar; nra]).
  assert (T : cos (3 * PI / 4) = - cos (PI / 4)) by (replace (3 * PI / 4) with (- (PI / 4) + PI) by field; rewrite neg_cos, cos_neg; reflexivity).
  pose proof (COS_bound (PI / 4)). rewrite T, cos_PI2, cos_PI. repeat split; try lra.
  assert (cos (PI / 4) < 1); [|lra]. rewrite <- cos_0. pose proof PI_RGT_0. apply cos_decreasing_1; lra.
Qed.
