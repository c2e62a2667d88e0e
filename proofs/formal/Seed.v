(* The seed's false statements, each refuted at a point: ~ (statement), as it is printed. What is added is over the
   printed programs, or about limits and derivatives; its false variant is the refutation of the statement put right:
   that one holds, so ~ ~ (statement put right). *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Camera Claim.
From Formal Require Statements.
Open Scope R_scope.

Theorem seed_quadratic_of_b__constant : Statements.seed_quadratic_of_b__constant.
Proof. intro F. generalize (F 0 0 1 0 1). lra. Qed.

Theorem seed_covers_the_view__covers : Statements.seed_covers_the_view__covers.
Proof. claim. Qed.
Theorem seed_covers_the_view__before : Statements.seed_covers_the_view__before.
Proof.
  red. intros b d B D. pose proof (sqrt_pos d). repeat split; try lra.
  - apply Rdiv_lt_0_compat; lra.
  - apply Rlt_gt, (Rmult_lt_reg_r (b + sqrt d)); [lra |]. field_simplify; lra.
Qed.
Theorem seed_covers_the_view__behind : Statements.seed_covers_the_view__behind.
Proof. red. intros. assert (radius >= eye * (1 - t)) by nra. split; lra. Qed.

(* The default scene's b, and the seed's c = |C|^2 - R_2^2 = 2.0876 in place of |E - C|^2 - R_2^2. *)
Definition scene_b (x y : R) := hit_of_b.toward_b x y 4 (1 / 2) (1 / 2) (13 / 10).
Definition seed_c := dot3 (1 / 2) (1 / 2) (13 / 10) (1 / 2) (1 / 2) (13 / 10) - (8 / 25) ^ 2.
Definition seed_d (x y : R) := scene_b x y ^ 2 - dot3 x y (- (4)) x y (- (4)) * seed_c.

Ltac seed_scene := unfold seed_d, seed_c, scene_b, hit_of_b.toward_b, hit_of_b.distance, dot3 in *.

Lemma seed_root (x y : R) : Rabs x <= 2 -> Rabs y <= 2 -> 0 < seed_c / (scene_b x y + sqrt (seed_d x y)) < 1 / 4.
Proof.
  intros X Y. apply Rabs_le_between in X, Y.
  destruct (seed_covers_the_view__covers x y) as (B & _ & D); try lra.
  destruct (seed_covers_the_view__before _ _ B D) as (_ & _ & _ & P & Q). revert P Q.
  replace (0 + _ + _ + _ - _) with seed_c by (seed_scene; lra). replace (_ + 4 * _) with (scene_b x y) by (seed_scene; lra).
  replace (_ - _ * (_ + _)) with (seed_d x y) by (unfold seed_d, dot3; ring). lra.
Qed.

(* Every pixel of the default view has |x|, |y| <= 2, so the seed's root of B stands before A and before the floor at
   each: B is what is shown, and A is never drawn. *)
Theorem seed_covers_the_view__never (m n : Z) (floor_on : R) : (0 <= m <= 255)%Z -> (0 <= n <= 255)%Z ->
  let seed_t := seed_c / (scene_b (pixel_x m) (pixel_y n) + sqrt (seed_d (pixel_x m) (pixel_y n))) in
  0 < seed_t < 1 / 4 /\
  nearest.surface floor_on (hit_of_a.t_a (pixel_x m) (pixel_y n) 4 1) (Finite seed_t) = 2.
Proof.
  intros M N seed_t.
  assert (V : forall a b : R, a ^ 2 + b ^ 2 < 4 -> Rabs a <= 2 /\ Rabs b <= 2) by (intros; split; apply Rabs_le; nra).
  assert (Q : pixel_x m ^ 2 + pixel_y n ^ 2 < 4).
  { rewrite pixel_value. destruct M as [M1 M2], N as [N1 N2]. apply IZR_le in M1, M2, N1, N2.
    assert (((2 * IZR m - 255) / 256) ^ 2 <= 1) by nra.
    assert (((1083 - 10 * IZR n) / 1280) ^ 2 <= 1345 / 1000) by nra. lra. }
  destruct (V _ _ Q) as [X Y]. pose proof (seed_root _ _ X Y : 0 < seed_t < 1 / 4) as S.
  split; [exact S |]. unfold nearest.surface, nearest.t_floor.
  destruct (Rle_lt_dec 0 (hit_of_a.discriminant_a (pixel_x m) (pixel_y n) 4 1)) as [D | D].
  - destruct (t_a_near _ _ 4 1 ltac:(lra) (pixel_off_axis m n) D) as (t & -> & _ & _ & A & _).
    unfold on_a, distance2 in A. destruct (seed_covers_the_view__behind 4 1 t (pixel_x m) (pixel_y n)) as [_ L]; try lra.
    destruct both as [[[_ B] _] | _]; [simpl in B; lra |].
    destruct both as [_ | [B | B]]; [reflexivity | destruct (B I) | destruct Rlt_dec; simpl in B;
      [lra | destruct (B I)]].
  - rewrite (no_hit_of_a _ _ 4 1 D).
    destruct both as [[[B _] _] | _]; [destruct B |].
    destruct both as [_ | [B | B]]; [reflexivity | destruct (B I) | destruct Rlt_dec; simpl in B;
      [lra | destruct (B I)]].
Qed.

Theorem seed_covers_the_view__never__point : exists m n : Z, (0 <= m <= 255)%Z /\ (0 <= n <= 255)%Z.
Proof. exists 0%Z, 0%Z. lia. Qed.

(* With the true hit A is drawn, at the pixel nearest the axis for one. *)
Theorem seed_covers_the_view__never__false : ~ forall m n : Z, (0 <= m <= 255)%Z -> (0 <= n <= 255)%Z ->
  nearest.surface 1 (hit_of_a.t_a (pixel_x m) (pixel_y n) 4 1)
    (hit_of_b.t_b (pixel_x m) (pixel_y n) 4 (1 / 2) (1 / 2) (13 / 10) (8 / 25) 1) = 2.
Proof.
  intros F. specialize (F 127%Z 108%Z ltac:(lia) ltac:(lia)).
  pose proof (pixel_value 127 108) as Q. set (x := pixel_x 127) in *. set (y := pixel_y 108) in *.
  assert (B : hit_of_b.t_b x y 4 (1 / 2) (1 / 2) (13 / 10) (8 / 25) 1 = p_infty).
  { unfold hit_of_b.t_b. destruct both as [[[_ D] _] | _]; [exfalso | reflexivity].
    unfold hit_of_b.discriminant_b, hit_of_b.distance in D. assert (x ^ 2 <= / 10000) by nra.
    assert (y ^ 2 <= / 10000) by nra.
    assert (-1 / 100 <= x <= 1 / 100) by nra. assert (-1 / 100 <= y <= 1 / 100) by nra. nra. }
  rewrite B in F. destruct (t_a_near x y 4 1 ltac:(lra) (pixel_off_axis 127 108)) as (t & T & _ & L & _).
  { rewrite discriminant_a_value by (lra || apply pixel_off_axis). rewrite Q. lra. }
  rewrite T in F. revert F. unfold nearest.surface, nearest.t_floor. destruct Rlt_dec; [| lra].
  destruct both as [_ | [[A | A] | A]]; [lra | destruct (A I) | destruct (A I) | simpl in A; lra].
Qed.

Theorem seed_pole_rows__beside : Statements.seed_pole_rows__beside.
Proof. intro F. generalize (F 127 108 ltac:(lra) ltac:(lra) ltac:(lra)). lra. Qed.

(* In the two rows beside the axis the fallback, sin phi < 10^-4, is taken: not at the pixel nearest the axis. *)
Theorem seed_pole_rows__fallback : ~ forall m n : Z, (0 <= m <= 255)%Z -> (108 <= n <= 109)%Z ->
  0 <= hit_of_a.discriminant_a (pixel_x m) (pixel_y n) 4 1 ->
    angles_on_a.sin_phi (pixel_x m) (pixel_y n) 4 1 < 1 / 10000.
Proof.
  intros F. assert (D : 0 <= hit_of_a.discriminant_a (pixel_x 127) (pixel_y 108) 4 1).
  { rewrite discriminant_a_value by (lra || apply pixel_off_axis). rewrite pixel_value. lra. }
  apply (proj2 (pixels_off_the_pole_far 127 108 D)). apply F; lia || exact D.
Qed.

(* sin phi is more than 0.0044 there, as everywhere. *)
Theorem seed_pole_rows__fallback__false : ~ ~ forall m n : Z, (0 <= m <= 255)%Z -> (108 <= n <= 109)%Z ->
  0 <= hit_of_a.discriminant_a (pixel_x m) (pixel_y n) 4 1 ->
    44 / 10000 < angles_on_a.sin_phi (pixel_x m) (pixel_y n) 4 1.
Proof. intros N. apply N. intros m n _ _ D. apply (pixels_off_the_pole_far m n D). Qed.

Theorem seed_orientation__left_handed : Statements.seed_orientation__left_handed.
Proof. intro F. generalize (F 0 1 1 0 ltac:(lra)). lra. Qed.

Theorem seed_bump_as_displacement__parallel : Statements.seed_bump_as_displacement__parallel.
Proof. intro F. generalize (F 1 0 1 1 1 1 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). lra. Qed.

Ltac both_normals := unfold displaced_normal.displaced_x, displaced_normal.displaced_y,
  displaced_normal.displaced_z, displaced_normal.lift, displaced_normal.h_theta, displaced_normal.h_phi,
  displaced_normal.normal_x, displaced_normal.normal_y, displaced_normal.normal_z, displaced_normal.e_theta_x,
  displaced_normal.e_theta_y, displaced_normal.e_theta_z, displaced_normal.e_phi_x, displaced_normal.e_phi_y,
  displaced_normal.e_phi_z, bumped_normal.m_x, bumped_normal.m_y, bumped_normal.m_z, bumped_normal.g_x,
  bumped_normal.g_y, bumped_normal.g_z, bumped_normal.normal_x, bumped_normal.normal_y, bumped_normal.normal_z,
  bumped_normal.e_theta_x, bumped_normal.e_theta_y, bumped_normal.e_theta_z, bumped_normal.e_phi_x,
  bumped_normal.e_phi_y, bumped_normal.e_phi_z, unit_normal.normal_x, unit_normal.normal_y, unit_normal.normal_z.

(* N' is the normal of the displaced surface, D = k M with k > 0: not at theta = 0, phi = pi/2,
   h = 0, beta = h_u = h_v = 1. *)
Theorem seed_bump_as_displacement__same_direction : ~ forall theta phi h_u h_v beta h : R,
  0 < sin phi -> 0 < 1 + beta * h -> exists k, 0 < k /\
  displaced_normal.displaced_x (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta h =
    k * bumped_normal.m_x (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta /\
  displaced_normal.displaced_y (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta h =
    k * bumped_normal.m_y (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta /\
  displaced_normal.displaced_z (cos phi) (sin phi) h_u h_v beta h =
    k * bumped_normal.m_z (cos phi) (sin phi) h_u h_v beta.
Proof.
  intros F. destruct (F 0 (PI / 2) 1 1 1 0) as (k & P & _ & Y & _); rewrite ?sin_PI2; try lra. revert Y. both_normals.
  rewrite cos_0, sin_0, cos_PI2, sin_PI2. pose proof PI_RGT_0. intro Y. field_simplify in Y; [| lra].
  assert (0 < 1 / (2 * PI)) by (apply Rdiv_lt_0_compat; lra). lra.
Qed.

(* They have the same direction where h_u = h_v = 0. *)
Theorem seed_bump_as_displacement__same_direction__false : ~ ~ forall theta phi beta h : R,
  0 < sin phi -> 0 < 1 + beta * h -> exists k, 0 < k /\
  displaced_normal.displaced_x (cos theta) (sin theta) (cos phi) (sin phi) 0 0 beta h =
    k * bumped_normal.m_x (cos theta) (sin theta) (cos phi) (sin phi) 0 0 beta /\
  displaced_normal.displaced_y (cos theta) (sin theta) (cos phi) (sin phi) 0 0 beta h =
    k * bumped_normal.m_y (cos theta) (sin theta) (cos phi) (sin phi) 0 0 beta /\
  displaced_normal.displaced_z (cos phi) (sin phi) 0 0 beta h = k * bumped_normal.m_z (cos phi) (sin phi) 0 0 beta.
Proof.
  intros N. apply N. intros theta phi beta h S L. exists (1 + beta * h). pose proof PI_RGT_0. split; [exact L |].
  both_normals. repeat split; field; lra.
Qed.

Theorem seed_step_in_beta__verifies : Statements.seed_step_in_beta__verifies.
Proof.
  (* |M| = (t + 1/t)/2 is rational where beta g_x = (t - 1/t)/2: t = 2 at beta, and 2 + 4 10^-6 at the step's end. *)
  set (t := 2 + 4 / 10 ^ 6). set (b := (t - / t) / 2). set (g := (b - 3 / 4) * 10 ^ 7). set (beta := 3 / 4 / g).
  assert (T : 0 < t) by (unfold t; lra). assert (G : 24 < g < 26) by (unfold g, b, t; split; lra).
  assert (E : beta * g = 3 / 4) by (unfold beta; field; lra).
  assert (E' : g * (beta + 1 / 10000000) = b) by (rewrite Rmult_plus_distr_l, (Rmult_comm g beta), E; unfold g; field).
  assert (L : sqrt ((beta * g + 0) ^ 2 + (beta * 0 + 0) ^ 2 + (beta * 0 + 1) ^ 2) = 5 / 4).
  { rewrite E. replace (_ + _ + _) with ((5 / 4) ^ 2) by field. apply sqrt_pow2. lra. }
  assert (L' : sqrt ((g * (beta + 1 / 10000000) + 0) ^ 2 + (0 * (beta + 1 / 10000000) + 0) ^ 2 + (0 * (beta + 1 / 10000000) + 1) ^ 2) = (t + / t) / 2).
  { rewrite E'. replace (_ + _ + _) with (((t + / t) / 2) ^ 2) by (unfold b; field; lra). apply sqrt_pow2. pose proof (Rinv_0_lt_compat t T). lra. }
  intro F. generalize (F beta g 0 0 0 0 1 ltac:(lra) ltac:(lra)). rewrite L, L', E, E'. clear - T G. intro F. pose proof (Rinv_0_lt_compat t T).
  specialize (F ltac:(nra) ltac:(lra) ltac:(lra) ltac:(lra)). apply Rge_le, Rabs_le_between in F. revert F. clear. unfold g, b, t. intro F. lra.
Qed.

(* The clamped difference at the pole v = 0 of a field h, with the program's samples and span. *)
Definition at_pole (h : R -> R) (epsilon : R) :=
  (h (central_sine.v_plus 0 epsilon) - h (central_sine.v_minus 0 epsilon)) / central_sine.span_v 0 epsilon.

Lemma at_pole_value h epsilon : 0 < epsilon <= 1 -> at_pole h epsilon = (h epsilon - h 0) / epsilon.
Proof.
  intros E. unfold at_pole, central_sine.span_v, central_sine.v_plus, central_sine.v_minus.
  destruct both as [[A B] | _]; [lra |]. rewrite !Rplus_0_r, Rmin_right, Rmax_right by lra. rewrite Rminus_0_r.
  reflexivity.
Qed.

Theorem seed_clamp__costs_an_order : Statements.seed_clamp__costs_an_order.
Proof. intro F. generalize (F (1 / 2) ltac:(lra) ltac:(lra) ltac:(lra)). rewrite Rabs_left; lra. Qed.

(* It is of first order for every field, that of v - v^3 errs by epsilon at least: not at epsilon = 1/2. *)
Theorem seed_clamp__first_order : ~ forall epsilon : R, 0 < epsilon <= 1 ->
  epsilon <= Rabs (at_pole (fun v => v - v ^ 3) epsilon - Derive (fun v => v - v ^ 3) 0).
Proof.
  intros F. specialize (F (1 / 2) ltac:(lra)). rewrite at_pole_value in F by lra.
  rewrite (is_derive_unique _ _ 1) in F by (auto_derive; [exact I | ring]).
  replace (_ - 1) with (- (1 / 4)) in F by field. rewrite Rabs_left in F; lra.
Qed.

(* Its error is epsilon^2. *)
Theorem seed_clamp__first_order__false : ~ ~ forall epsilon : R, 0 < epsilon <= 1 ->
  at_pole (fun v => v - v ^ 3) epsilon - Derive (fun v => v - v ^ 3) 0 = - epsilon ^ 2.
Proof.
  intros N. apply N. intros epsilon E. rewrite at_pole_value by exact E.
  rewrite (is_derive_unique _ _ 1) by (auto_derive; [exact I | ring]). field. lra.
Qed.

Theorem seed_truncation_slope__descends : Statements.seed_truncation_slope__descends.
Proof. intro F. generalize (F (1 / 2) 1 ltac:(lra) ltac:(lra)). rewrite Rabs_Ropp, Rabs_R1. lra. Qed.

Lemma whole_part (x : R) (m : Z) : IZR m <= x < IZR m + 1 -> IZR (Int_part x) = IZR m.
Proof.
  intros H. f_equal. destruct (base_Int_part x) as [A B].
  assert (Int_part x < m + 1)%Z by (apply lt_IZR; rewrite plus_IZR; lra).
  assert (m < Int_part x + 1)%Z by (apply lt_IZR; rewrite plus_IZR; lra). lia.
Qed.

(* The slope after u: the limit of the one-sided quotient. *)
Definition slope_after (h : R -> R) (u l : R) := filterlim (fun s => (h (u + s) - h u) / s) (at_right 0) (locally l).

Lemma slope_after_ridge : slope_after (fun u => height_ridges.h u (1 / 2) 2 1) (1 / 2) (2 * PI).
Proof.
  assert (D : is_derive (fun s => sin (2 * PI * s)) 0 (2 * PI)).
  { auto_derive; [exact I |]. rewrite Rmult_0_r, cos_0. ring. }
  apply is_derive_Reals in D. apply filterlim_locally. intros eps. destruct (D eps (cond_pos eps)) as [d H].
  assert (P : 0 < Rmin d (1 / 2)) by (apply Rmin_glb_lt; [apply cond_pos | lra]). exists (mkposreal _ P).
  intros s B S. change (Rabs (s - 0) < Rmin d (1 / 2)) in B. rewrite Rminus_0_r, Rabs_pos_eq in B by lra.
  pose proof (Rmin_l d (1 / 2)). pose proof (Rmin_r d (1 / 2)).
  specialize (H s ltac:(lra)). rewrite Rabs_pos_eq in H by lra. specialize (H ltac:(lra)).
  change (Rabs ((height_ridges.h (1 / 2 + s) (1 / 2) 2 1 - height_ridges.h (1 / 2) (1 / 2) 2 1) / s - 2 * PI) < eps).
  replace (height_ridges.h (1 / 2 + s) (1 / 2) 2 1) with (sin (2 * PI * s)).
  2: { unfold height_ridges.h. rewrite half_sine, Rmult_1_r.
       replace (PI * (2 * (1 / 2 + s))) with (2 * PI * s + PI) by field.
    rewrite neg_sin, Rabs_Ropp, Rabs_pos_eq; [reflexivity |]. pose proof PI_RGT_0. apply sin_ge_0; nra. }
  replace (height_ridges.h (1 / 2) (1 / 2) 2 1) with 0.
  2: { unfold height_ridges.h. replace (PI * (2 * (1 / 2))) with PI by field. rewrite sin_PI, Rmult_0_l, Rabs_R0.
       reflexivity. }
  rewrite Rplus_0_l, Rmult_0_r, sin_0 in H. exact H.
Qed.

Lemma difference_on_ridge epsilon : 0 < epsilon < 1 / 2 -> central_ridges.h_u (1 / 2) (1 / 2) 2 1 epsilon = 0.
Proof.
  intros E. unfold central_ridges.h_u, central_ridges.h_u_plus, central_ridges.h_u_minus, central_ridges.u_plus,
    central_ridges.u_minus. rewrite !(whole_part _ 0) by lra. rewrite half_sine, !Rmult_1_r, !Rminus_0_r.
  replace (PI * (2 * (epsilon + 1 / 2))) with (2 * PI * epsilon + PI) by field.
  replace (PI * (2 * (1 / 2 - epsilon))) with (- (2 * PI * epsilon) + PI) by field.
  rewrite !neg_sin, sin_neg, !Rabs_Ropp. unfold Rdiv. ring.
Qed.

(* The error of the central difference of ridges is at most epsilon^2 omega^3 / 6, omega = pi k, as for a sine: not at a
   crease, against the slope after it. *)
Theorem seed_truncation_slope__slope_after : ~ forall u v ku kv epsilon l : R, 0 < ku -> 0 < epsilon ->
  slope_after (fun u => height_ridges.h u v ku kv) u l ->
  Rabs (central_ridges.h_u u v ku kv epsilon - l) <= epsilon ^ 2 / 6 * (PI * ku) ^ 3.
Proof.
  intros F. specialize (F (1 / 2) (1 / 2) 2 1 (1 / 4) (2 * PI) ltac:(lra) ltac:(lra) slope_after_ridge).
  rewrite difference_on_ridge in F by lra. pose proof PI_RGT_0. pose proof PI_4.
  rewrite Rminus_0_l, Rabs_Ropp, Rabs_pos_eq in F by lra. nra.
Qed.

(* There the error is omega, whatever the step is. *)
Theorem seed_truncation_slope__slope_after__false : ~ ~ exists u v ku kv l : R, 0 < ku /\
  slope_after (fun u => height_ridges.h u v ku kv) u l /\
  forall epsilon, 0 < epsilon < 1 / 2 -> Rabs (central_ridges.h_u u v ku kv epsilon - l) = PI * ku.
Proof.
  intros N. apply N. exists (1 / 2), (1 / 2), 2, 1, (2 * PI). split; [lra |]. split; [apply slope_after_ridge |].
  intros epsilon E. rewrite difference_on_ridge by exact E. pose proof PI_RGT_0.
  rewrite Rminus_0_l, Rabs_Ropp, Rabs_pos_eq; lra.
Qed.

Theorem ridges_differentiable__one_slope : Statements.ridges_differentiable__one_slope.
Proof.
  intro F. generalize (F 8 4 (1 / 4) (1 / 8)). replace (1 / 4 * PI * 8) with (2 * PI) by field.
  replace (PI * (8 * (1 / 4))) with (2 * PI) by field. replace (PI * (4 * (1 / 8))) with (PI / 2) by field.
  rewrite sin_2PI, cos_2PI, sin_PI2, Rabs_pos_eq; lra.
Qed.

(* Ridges is differentiable in u: not at k_u = 8, k_v = 4, (u, v) = (1/4, 1/8). *)
Theorem ridges_differentiable__derivative : ~ forall u v ku kv : R, ex_derive (fun u => height_ridges.h u v ku kv) u.
Proof.
  intros F. assert (S : sin (PI * (4 * (1 / 8))) = 1) by (replace (PI * (4 * (1 / 8))) with (PI / 2) by field; exact sin_PI2).
  apply (proj1 (kink_loci__creased_in_u (1 / 4) (1 / 8) 8 4 ltac:(lra) ltac:(lra))); [exists 2%Z; lra | apply F].
Qed.

(* It is where it is not 0. *)
Theorem ridges_differentiable__derivative__false : ~ ~ forall u v ku kv : R, height_ridges.h u v ku kv <> 0 ->
  ex_derive (fun u => height_ridges.h u v ku kv) u.
Proof.
  intros N. apply N. intros u v ku kv H. eexists. unfold height_ridges.h.
  apply (is_derive_Rabs (fun u => sin (PI * (ku * u)) * sin (PI * (kv * v))) u
    (PI * ku * cos (PI * (ku * u)) * sin (PI * (kv * v)))).
  - auto_derive; [exact I | ring].
  - intros Z. apply H. unfold height_ridges.h. rewrite Z. apply Rabs_R0.
Qed.

Theorem periodic_u_saves_the_seam__slope : Statements.periodic_u_saves_the_seam__slope.
Proof.
  intro F. generalize (F 1 1 (1 / 2)). replace (PI * (1 * (1 / 2))) with (PI / 2) by field.
  rewrite !Rmult_0_l, !Rmult_1_r, Rmult_0_r, cos_0, sin_PI, cos_PI, sin_PI2. lra.
Qed.

(* For whole k_u sine is differentiable across u = 0, with u wrapped to [0, 1): not for k_u = k_v = 1, v = 1/2. *)
Theorem periodic_u_saves_the_seam__derivative : ~ forall (k : Z) (v kv : R),
  ex_derive (fun u => height_sine.h (u - IZR (Int_part u)) v (IZR k) kv) 0.
Proof.
  intros F. pose proof PI_RGT_0. specialize (F 1%Z (1 / 2) 1).
  apply (corner (fun u => sin (PI * u)) 0 PI); [| | lra |].
  - auto_derive; [exact I |]. rewrite Rmult_0_r, cos_0. ring.
  - rewrite Rmult_0_r. apply sin_0.
  - eapply ex_derive_ext_loc; [| exact F]. exists (mkposreal 1 Rlt_0_1). intros t B. change (Rabs (t - 0) < 1) in B.
    rewrite Rminus_0_r in B. apply Rabs_lt_between in B. unfold height_sine.h. rewrite half_sine, Rmult_1_r, Rmult_1_l.
    destruct (Rle_lt_dec 0 t) as [P | M].
    + rewrite (whole_part t 0) by lra. rewrite Rminus_0_r, Rabs_pos_eq; [reflexivity |]. apply sin_ge_0; nra.
    + rewrite (whole_part t (-1)) by lra. replace (PI * (t - -1)) with (PI * t + PI) by ring.
      rewrite neg_sin, Rabs_left1;
        [reflexivity |]. replace (PI * t) with (- (PI * - t)) by ring. rewrite sin_neg.
      pose proof (sin_ge_0 (PI * - t)). nra.
Qed.

(* It is with k_u = 0. *)
Theorem periodic_u_saves_the_seam__derivative__false : ~ ~ forall v kv : R,
  ex_derive (fun u => height_sine.h (u - IZR (Int_part u)) v 0 kv) 0.
Proof.
  intros N. apply N. intros v kv. apply (ex_derive_ext (fun _ => 0)); [| apply ex_derive_const].
  intros t. unfold height_sine.h. rewrite Rmult_0_l, Rmult_0_r, sin_0, Rmult_0_l. reflexivity.
Qed.

Theorem sine_is_smooth_everywhere__one_limit : Statements.sine_is_smooth_everywhere__one_limit.
Proof.
  intro F. generalize (F 2 1 (PI / 2)). replace (2 * (PI / 2 + PI) / 2) with (PI / 2 + PI) by field.
  rewrite neg_sin, sin_neg, sin_PI, sin_PI2. lra.
Qed.

(* The vector g of sine on the meridian theta, at the distance v from the pole. *)
Section meridian.
Variables ku kv theta v : R.
Let u := (theta + PI) / (2 * PI).
Definition meridian_x := bumped_normal.g_x (cos theta) (sin theta) (cos (PI * v)) (gradient_sine.h_u u v ku kv)
  (gradient_sine.h_v u v ku kv).
Definition meridian_y := bumped_normal.g_y (cos theta) (sin theta) (cos (PI * v)) (gradient_sine.h_u u v ku kv)
  (gradient_sine.h_v u v ku kv).
Definition meridian_z := bumped_normal.g_z (sin (PI * v)) (gradient_sine.h_u u v ku kv) (gradient_sine.h_v u v ku kv).
End meridian.

Definition tends_at_pole (f : R -> R) (l : R) := filterlim f (at_right 0) (locally l).

Lemma tends_continuous f : continuous f 0 -> tends_at_pole f (f 0).
Proof. intros C. eapply filterlim_filter_le_1; [apply filter_le_within | exact C]. Qed.

Ltac meridian_lines := unfold meridian_x, meridian_y, meridian_z, bumped_normal.g_x, bumped_normal.g_y,
  bumped_normal.g_z,
  bumped_normal.e_phi_x, bumped_normal.e_phi_y, bumped_normal.e_phi_z, bumped_normal.e_theta_x, bumped_normal.e_theta_y,
  bumped_normal.e_theta_z, gradient_sine.h_u, gradient_sine.h_v, gradient_sine.cos_u, gradient_sine.cos_v,
  gradient_sine.sin_u, gradient_sine.sin_v.

Lemma meridian_limit theta : tends_at_pole (meridian_y 2 1 theta) (PI * sin theta * sin (theta + PI)).
Proof.
  pose proof PI_RGT_0. replace (PI * sin theta * sin (theta + PI)) with (meridian_y 2 1 theta 0).
  - apply tends_continuous, (ex_derive_continuous (meridian_y 2 1 theta)). meridian_lines. auto_derive. exact I.
  - meridian_lines. rewrite !Rmult_0_r, sin_0, cos_0.
    replace (PI * (2 * ((theta + PI) / (2 * PI)))) with (theta + PI) by (field; lra). ring.
Qed.

(* For sine, g tends to the same vector along every meridian as v -> 0: not for k_u = 2, k_v = 1, where it tends to
   (0, - pi, 0) on theta = pi/2 and to 0 on theta = pi. *)
Theorem sine_is_smooth_everywhere__limits : ~ forall ku kv : R, exists lx ly lz, forall theta, - PI < theta <= PI ->
  tends_at_pole (meridian_x ku kv theta) lx /\ tends_at_pole (meridian_y ku kv theta) ly /\
  tends_at_pole (meridian_z ku kv theta) lz.
Proof.
  intros F. pose proof PI_RGT_0. destruct (F 2 1) as (lx & ly & lz & L).
  destruct (L (PI / 2) ltac:(lra)) as (_ & A & _). destruct (L PI ltac:(lra)) as (_ & B & _).
  pose proof (filterlim_locally_unique _ _ _ A (meridian_limit (PI / 2))) as E.
  pose proof (filterlim_locally_unique _ _ _ B (meridian_limit PI)) as G.
  rewrite neg_sin, sin_PI2 in E. rewrite sin_PI in G. rewrite E in G. lra.
Qed.

(* It does for k_v = 0. *)
Theorem sine_is_smooth_everywhere__limits__false : ~ ~ forall ku : R, exists lx ly lz, forall theta,
  - PI < theta <= PI ->
  tends_at_pole (meridian_x ku 0 theta) lx /\ tends_at_pole (meridian_y ku 0 theta) ly /\
  tends_at_pole (meridian_z ku 0 theta) lz.
Proof.
  intros N. apply N. intros ku. exists 0, 0, 0. intros theta _. repeat split;
    (apply (filterlim_ext (fun _ => 0)); [| apply filterlim_const]); intros v; meridian_lines;
    replace (sin (PI * (0 * v))) with 0 by (rewrite Rmult_0_l, Rmult_0_r, sin_0; reflexivity); ring.
Qed.

Theorem highlight_below_one__root : Statements.highlight_below_one__root.
Proof.
  intro F. generalize (F 32 (1 / 64 ^ 2) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
  replace (1 / 64 ^ 2) with ((1 / 64) ^ 2) by field. rewrite sqrt_pow2; lra.
Qed.

(* For every p > 0 the power x^p is Lipschitz on [0, 1]: not for p = 1/2. *)
Theorem highlight_below_one__power : ~ forall p : R, 0 < p -> exists bound : R, forall x z : R, 0 <= x <= 1 ->
  0 <= z <= 1 ->
  Rabs (highlight.specular x p - highlight.specular z p) <= bound * Rabs (x - z).
Proof.
  intros F. destruct (F (/ 2) ltac:(lra)) as [bound L]. set (m := bound ^ 2 + 1).
  assert (M : 1 <= m /\ bound <= m) by (unfold m; split; nra).
  assert (S : 0 < / (4 * m) <= 1 / 4).
  { split; [apply Rinv_0_lt_compat; lra |]. apply (Rmult_le_reg_r (4 * m)); [lra |]. rewrite Rinv_l; lra. }
  assert (E : / (4 * m) * m = 1 / 4) by (field; lra). set (s := / (4 * m)) in *.
  specialize (L (s ^ 2) ((s / 2) ^ 2) ltac:(nra) ltac:(nra)). unfold highlight.specular in L.
  rewrite !power_positive, !Rpower_sqrt in L by nra.
  rewrite !sqrt_pow2 in L by lra. rewrite !Rabs_pos_eq in L by nra. nra.
Qed.

(* It is for p = 2. *)
Theorem highlight_below_one__power__false : ~ ~ exists bound : R, forall x z : R, 0 <= x <= 1 -> 0 <= z <= 1 ->
  Rabs (highlight.specular x 2 - highlight.specular z 2) <= bound * Rabs (x - z).
Proof.
  intros N. apply N. exists 2. intros x z X Z. unfold highlight.specular.
  assert (P : forall y, 0 <= y <= 1 -> power y 2 = y ^ 2).
  { intros y Y. unfold power. destruct (Rlt_dec 0 y) as [Q | Q]; [| replace y with 0 by lra; ring].
    replace 2 with (INR 2) at 1 by reflexivity. apply Rpower_pow, Q. }
  rewrite !P by lra.
  replace (x ^ 2 - z ^ 2) with ((x + z) * (x - z)) by ring. rewrite Rabs_mult, (Rabs_pos_eq (x + z)) by lra.
  apply Rmult_le_compat_r; [apply Rabs_pos | lra].
Qed.

Theorem attached_shadow__in_light : Statements.attached_shadow__in_light.
Proof.
  intro F. generalize (F (3 / 4) 1 0 0 0 0 1 (-12 / 13) 0 (5 / 13)). cbv zeta. replace ((_ + 0) ^ 2 + _ + _) with ((5 / 4) ^ 2) by field.
  rewrite sqrt_pow2 by lra. lra.
Qed.
