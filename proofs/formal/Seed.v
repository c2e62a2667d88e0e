(* The seed's false statements, each refuted at a point: ~ (statement). A refutation shows that the hypotheses hold there.
   Its false variant is the refutation of the statement put right: that one holds, so ~ ~ (statement put right). *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Camera.
Open Scope R_scope.

(* The constant term of sphere B's quadratic is |C|^2 - R_2^2: not in the default scene. *)
Theorem seed_quadratic_of_b__constant : ~ forall t x y e cx cy cz r : R, distance2 t x y e cx cy cz - r ^ 2 =
  dot x y (- e) x y (- e) * t ^ 2 - 2 * hit_of_b.toward_b x y e cx cy cz * t + (dot cx cy cz cx cy cz - r ^ 2).
Proof.
  intros F. specialize (F 0 0 0 4 (1 / 2) (1 / 2) (13 / 10) (8 / 25)). unfold distance2, hit_of_b.toward_b, dot in F. lra.
Qed.

(* It is |E - C|^2 - R_2^2. *)
Theorem seed_quadratic_of_b__constant__false : ~ ~ forall t x y e cx cy cz r : R, distance2 t x y e cx cy cz - r ^ 2 =
  dot x y (- e) x y (- e) * t ^ 2 - 2 * hit_of_b.toward_b x y e cx cy cz * t
  + (dot cx cy (cz - e) cx cy (cz - e) - r ^ 2).
Proof. intros N. apply N. intros. apply hit_of_b__quadratic. Qed.

(* The default scene's b, and the seed's c = |C|^2 - R_2^2 = 2.0876 in place of |E - C|^2 - R_2^2. *)
Definition scene_b (x y : R) := hit_of_b.toward_b x y 4 (1 / 2) (1 / 2) (13 / 10).
Definition seed_c := dot (1 / 2) (1 / 2) (13 / 10) (1 / 2) (1 / 2) (13 / 10) - (8 / 25) ^ 2.
Definition seed_d (x y : R) := scene_b x y ^ 2 - dot x y (- (4)) x y (- (4)) * seed_c.

Ltac seed_scene := unfold seed_d, seed_c, scene_b, hit_of_b.toward_b, hit_of_b.distance, dot in *.

(* Every ray with |x|, |y| <= 2 has b^2 - |D|^2 c > 0 and a root c / (b + sqrt d) in (0, 1/4). *)
Theorem seed_covers_the_view__covers (x y : R) : Rabs x <= 2 -> Rabs y <= 2 ->
  seed_c = 20876 / 10000 /\ 35 / 4 < scene_b x y /\ 0 < seed_d x y /\
  0 < seed_c / (scene_b x y + sqrt (seed_d x y)) < 1 / 4.
Proof.
  intros X Y. apply Rabs_le_between in X, Y. assert (C : seed_c = 20876 / 10000) by (seed_scene; lra).
  assert (B : 35 / 4 < scene_b x y) by (seed_scene; lra).
  assert (D : 0 < seed_d x y) by (unfold seed_d; rewrite C; unfold dot; nra).
  pose proof (sqrt_pos (seed_d x y)). repeat split; try assumption.
  - apply Rdiv_lt_0_compat; lra.
  - apply (Rmult_lt_reg_r (scene_b x y + sqrt (seed_d x y))); [lra |]. field_simplify; lra.
Qed.

Theorem seed_covers_the_view__covers__point : exists x y : R, Rabs x <= 2 /\ Rabs y <= 2.
Proof. exists 0, 0. rewrite Rabs_R0. lra. Qed.

(* Not at |x|, |y| <= 3. *)
Theorem seed_covers_the_view__covers__false : ~ forall x y : R, Rabs x <= 3 -> Rabs y <= 3 -> 35 / 4 < scene_b x y.
Proof.
  intros F. assert (A : Rabs (-3) <= 3) by (rewrite Rabs_left; lra). specialize (F (-3) (-3) A A). seed_scene. lra.
Qed.

(* A's points have t >= 1 - R / e. *)
Theorem seed_covers_the_view__behind (t x y e r : R) : 0 < r < e -> on_a t x y e r -> 1 - r / e <= t.
Proof.
  intros H M. unfold on_a, distance2 in M. assert (e * (1 - t) <= r) by nra.
  apply (Rmult_le_reg_l e); [lra |]. field_simplify; lra.
Qed.

Theorem seed_covers_the_view__behind__point : exists t x y e r : R, 0 < r < e /\ on_a t x y e r.
Proof. exists (3 / 4), 0, 0, 4, 1. unfold on_a, distance2. lra. Qed.

(* Not t >= 1. *)
Theorem seed_covers_the_view__behind__false : ~ forall t x y e r : R, 0 < r < e -> on_a t x y e r -> 1 <= t.
Proof. intros F. specialize (F (3 / 4) 0 0 4 1). unfold on_a, distance2 in F. lra. Qed.

(* Every pixel of the default view has |x|, |y| <= 2: so B, with the seed's root, stands before A at every one of them,
   and A is never drawn. *)
Theorem seed_covers_the_view__never (m n : Z) (t : R) : (0 <= m <= 255)%Z -> (0 <= n <= 255)%Z ->
  on_a t (pixel_x m) (pixel_y n) 4 1 ->
  0 < seed_c / (scene_b (pixel_x m) (pixel_y n) + sqrt (seed_d (pixel_x m) (pixel_y n))) < t.
Proof.
  intros M N A. apply seed_covers_the_view__behind in A; [| lra].
  assert (V : forall a b : R, a ^ 2 + b ^ 2 < 4 -> Rabs a <= 2 /\ Rabs b <= 2) by (intros; split; apply Rabs_le; nra).
  assert (Q : pixel_x m ^ 2 + pixel_y n ^ 2 < 4).
  { rewrite pixel_value. destruct M as [M1 M2], N as [N1 N2]. apply IZR_le in M1, M2, N1, N2.
    assert (((2 * IZR m - 255) / 256) ^ 2 <= 1) by nra. assert (((1083 - 10 * IZR n) / 1280) ^ 2 <= 1345 / 1000) by nra. lra. }
  destruct (V _ _ Q) as [X Y]. destruct (seed_covers_the_view__covers _ _ X Y) as (_ & _ & _ & R). lra.
Qed.

Theorem seed_covers_the_view__never__point : exists (m n : Z) (t : R), (0 <= m <= 255)%Z /\ (0 <= n <= 255)%Z /\
  on_a t (pixel_x m) (pixel_y n) 4 1.
Proof.
  destruct (t_a_near (pixel_x 127) (pixel_y 108) 4 1) as (t & _ & _ & _ & M & _); [lra | apply pixel_off_axis | |].
  - rewrite discriminant_a_value by (lra || apply pixel_off_axis). rewrite pixel_value. lra.
  - exists 127%Z, 108%Z, t. repeat split; try lia. exact M.
Qed.

(* With the true c, in a ray that meets A away from B, there is no root at all. *)
Theorem seed_covers_the_view__never__false : ~ forall x y : R, Rabs x <= 2 -> Rabs y <= 2 ->
  0 <= hit_of_b.discriminant_b x y 4 (1 / 2) (1 / 2) (13 / 10) (8 / 25).
Proof.
  intros F. specialize (F 0 0). rewrite Rabs_R0 in F. unfold hit_of_b.discriminant_b, hit_of_b.distance in F.
  specialize (F ltac:(lra) ltac:(lra)). lra.
Qed.

(* In the two rows beside the axis the fallback, sin phi < 10^-4, is taken: not at the pixel nearest the axis. *)
Theorem seed_pole_rows__beside : ~ forall m n : Z, (0 <= m <= 255)%Z -> (108 <= n <= 109)%Z ->
  0 <= hit_of_a.discriminant_a (pixel_x m) (pixel_y n) 4 1 -> angles_on_a.sin_phi (pixel_x m) (pixel_y n) 4 1 < 1 / 10000.
Proof.
  intros F. assert (D : 0 <= hit_of_a.discriminant_a (pixel_x 127) (pixel_y 108) 4 1).
  { rewrite discriminant_a_value by (lra || apply pixel_off_axis). rewrite pixel_value. lra. }
  apply (proj2 (pixels_off_the_pole__far 127 108 D)). apply F; lia || exact D.
Qed.

(* sin phi is more than 0.0044 there, as everywhere. *)
Theorem seed_pole_rows__beside__false : ~ ~ forall m n : Z, (0 <= m <= 255)%Z -> (108 <= n <= 109)%Z ->
  0 <= hit_of_a.discriminant_a (pixel_x m) (pixel_y n) 4 1 -> 44 / 10000 < angles_on_a.sin_phi (pixel_x m) (pixel_y n) 4 1.
Proof. intros N. apply N. intros m n _ _ D. apply (pixels_off_the_pole__far m n D). Qed.

Lemma near_axis x : / 10 ^ 6 <= x <= / 1000 -> off_axis x 0 4 /\ 0 <= hit_of_a.discriminant_a x 0 4 1 /\
  angles_on_a.sin_phi x 0 4 1 <= 8 / 10 * x.
Proof.
  intros X. assert (O : off_axis x 0 4) by (apply off_axis_far; nra). split; [exact O |].
  assert (D : 15 <= hit_of_a.discriminant_a x 0 4 1) by (rewrite discriminant_a_value by (lra || exact O); nra).
  split; [lra |]. destruct (stable_frame__angles x 0 4 1 ltac:(lra) O ltac:(lra)) as
    (t & a & b & T & _ & _ & _ & (_ & _ & _ & <-) & _ & _ & _ & _ & -> & _).
  rewrite (t_a_value x 0 4 1) in T by (lra || exact O). apply Rbar_finite_eq in T.
  pose proof (sqrt_sqrt (hit_of_a.discriminant_a x 0 4 1) ltac:(lra)).
  pose proof (sqrt_pos (hit_of_a.discriminant_a x 0 4 1)). set (q := sqrt (hit_of_a.discriminant_a x 0 4 1)) in *.
  assert (t <= 8 / 10) by (rewrite <- T; apply (Rmult_le_reg_r (4 ^ 2 + q)); [lra | field_simplify; nra]).
  rewrite (sqrt_is _ x) by lra. unfold Rdiv at 1. rewrite Rinv_1. nra.
Qed.

(* sin phi < 10^-4 needs rho < 4/3 10^-4. *)
Theorem seed_pole_rows__needs (x y : R) : off_axis x y 4 -> 0 <= hit_of_a.discriminant_a x y 4 1 ->
  angles_on_a.sin_phi x y 4 1 < 1 / 10000 -> sqrt (x ^ 2 + y ^ 2) < 4 / 3 * (1 / 10000).
Proof. intros O D S. pose proof (pixels_off_the_pole__linear x y 4 1 ltac:(lra) O D). lra. Qed.

Theorem seed_pole_rows__needs__point : exists x y : R, off_axis x y 4 /\ 0 <= hit_of_a.discriminant_a x y 4 1 /\
  angles_on_a.sin_phi x y 4 1 < 1 / 10000.
Proof. exists (/ 10 ^ 5), 0. destruct (near_axis (/ 10 ^ 5) ltac:(lra)) as (O & D & S). repeat split; try assumption. lra. Qed.

(* Not rho < 10^-4. *)
Theorem seed_pole_rows__needs__false : ~ forall x y : R, off_axis x y 4 -> 0 <= hit_of_a.discriminant_a x y 4 1 ->
  angles_on_a.sin_phi x y 4 1 < 1 / 10000 -> sqrt (x ^ 2 + y ^ 2) < 1 / 10000.
Proof.
  intros F. destruct (near_axis (12 / 10 ^ 5) ltac:(lra)) as (O & D & S). specialize (F _ _ O D ltac:(lra)).
  rewrite (sqrt_is _ (12 / 10 ^ 5)) in F by lra. lra.
Qed.

(* e_theta x e_phi = N: not at theta = 0, phi = pi/2. *)
Theorem seed_orientation__left_handed : ~ forall theta phi : R,
  let ax := tangent_frame.e_theta_x (sin theta) in let ay := tangent_frame.e_theta_y (cos theta) in
  let az := tangent_frame.e_theta_z in let bx := tangent_frame.e_phi_x (cos theta) (cos phi) in
  let by_ := tangent_frame.e_phi_y (sin theta) (cos phi) in let bz := tangent_frame.e_phi_z (sin phi) in
  ay * bz - az * by_ = unit_normal.normal_x (cos theta) (sin phi) /\
  az * bx - ax * bz = unit_normal.normal_y (sin theta) (sin phi) /\
  ax * by_ - ay * bx = unit_normal.normal_z (cos phi).
Proof.
  intros F. destruct (F 0 (PI / 2)) as [G _]. rewrite sin_0, cos_0, sin_PI2, cos_PI2 in G.
  unfold tangent_frame.e_theta_y, tangent_frame.e_theta_z, tangent_frame.e_phi_y, tangent_frame.e_phi_z,
    unit_normal.normal_x in G. lra.
Qed.

(* e_phi x e_theta = N. *)
Theorem seed_orientation__left_handed__false : ~ ~ forall theta phi : R,
  let ax := tangent_frame.e_theta_x (sin theta) in let ay := tangent_frame.e_theta_y (cos theta) in
  let az := tangent_frame.e_theta_z in let bx := tangent_frame.e_phi_x (cos theta) (cos phi) in
  let by_ := tangent_frame.e_phi_y (sin theta) (cos phi) in let bz := tangent_frame.e_phi_z (sin phi) in
  by_ * az - bz * ay = unit_normal.normal_x (cos theta) (sin phi) /\
  bz * ax - bx * az = unit_normal.normal_y (sin theta) (sin phi) /\
  bx * ay - by_ * ax = unit_normal.normal_z (cos phi).
Proof.
  intros N. apply N. intros theta phi. pose proof (sin2_cos2 theta) as T. unfold Rsqr in T.
  unfold tangent_frame.e_theta_x, tangent_frame.e_theta_y, tangent_frame.e_theta_z, tangent_frame.e_phi_x,
    tangent_frame.e_phi_y, tangent_frame.e_phi_z, unit_normal.normal_x, unit_normal.normal_y, unit_normal.normal_z.
  repeat split; try ring. replace (_ - _) with (cos phi * (sin theta * sin theta + cos theta * cos theta)) by ring.
  rewrite T. ring.
Qed.
