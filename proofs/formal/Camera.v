(* The camera: what the proofs about sphere A share, the true angles, creases, the pixels beside the pole, what is drawn. *)

From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas.
Open Scope R_scope.

(* The square of the distance from C to P(t) = (t x, t y, e (1 - t)), a point of the ray through the image point. *)
Definition distance2 (t x y e cx cy cz : R) := (t * x - cx) ^ 2 + (t * y - cy) ^ 2 + (e * (1 - t) - cz) ^ 2.
Definition on_a (t x y e r : R) := distance2 t x y e 0 0 0 = r ^ 2.

Definition dot3 (ax ay az bx by_ bz : R) := ax * bx + ay * by_ + az * bz.
Definition cross2 (ax ay az bx by_ bz : R) :=
  (ay * bz - az * by_) ^ 2 + (az * bx - ax * bz) ^ 2 + (ax * by_ - ay * bx) ^ 2.

(* Where the program does not take a ray for the axis itself: rho is not below 10^-150 e. *)
Definition tiny := 1 / IZR (10 ^ 150).
Definition off_axis (x y e : R) := tiny * e <= sqrt (x ^ 2 + y ^ 2).

Lemma tiny_pos : 0 < tiny.
Proof. unfold tiny, Rdiv. rewrite Rmult_1_l. apply Rinv_0_lt_compat, IZR_lt. reflexivity. Qed.

Lemma off_axis_pos x y e : 0 < e -> off_axis x y e -> 0 < x ^ 2 + y ^ 2.
Proof.
  unfold off_axis. intros He H. pose proof (Rmult_lt_0_compat _ _ tiny_pos He).
  destruct (Rle_lt_dec (x ^ 2 + y ^ 2) 0); [rewrite sqrt_neg_0 in H; lra | lra].
Qed.

Lemma off_axis_far x y e : e <= 10 -> / 1000000000000 <= x ^ 2 + y ^ 2 -> off_axis x y e.
Proof.
  intros. pose proof tiny_pos. apply Rle_trans with (/ 1000000).
  - unfold tiny, Rdiv. nra.
  - rewrite <- (sqrt_pow2 _) by lra. apply sqrt_le_1_alt. lra.
Qed.

Lemma rho_a x y e : off_axis x y e -> hit_of_a.rho x y e = sqrt (x ^ 2 + y ^ 2).
Proof.
  intros H. hit_of_a.lines. destruct Rle_dec as [_ | N]; [reflexivity | destruct N; exact H].
Qed.

Lemma rho_a_squared x y e : off_axis x y e -> hit_of_a.rho x y e ^ 2 = x ^ 2 + y ^ 2.
Proof. intros. rewrite rho_a, pow2_sqrt by (assumption || nra). reflexivity. Qed.

Lemma tangent_pos e r : 0 < r < e -> 0 < e ^ 2 - r ^ 2.
Proof. nra. Qed.

Lemma rho_silhouette_squared e r : 0 < r < e ->
  0 < silhouette_of_a.rho_silhouette e r /\ silhouette_of_a.rho_silhouette e r ^ 2 * (e ^ 2 - r ^ 2) = e ^ 2 * r ^ 2.
Proof.
  intros. silhouette_of_a.lines.
  assert (P : 0 < (e - r) * (e + r)) by nra. pose proof (sqrt_lt_R0 _ P). pose proof (sqrt_sqrt _ (Rlt_le _ _ P)) as Q.
  split; [apply Rdiv_lt_0_compat; nra |].
  replace (e ^ 2 - r ^ 2) with ((e - r) * (e + r)) by ring. rewrite <- Q at 2. field. lra.
Qed.

Lemma discriminant_a_value x y e r : 0 < r < e -> off_axis x y e ->
  hit_of_a.discriminant_a x y e r = (e ^ 2) ^ 2 - (x ^ 2 + y ^ 2 + e ^ 2) * (e ^ 2 - r ^ 2).
Proof.
  intros H O. destruct (rho_silhouette_squared e r H). pose proof (rho_a_squared x y e O).
  unfold hit_of_a.discriminant_a. change (hit_of_a.rho_silhouette e r) with (silhouette_of_a.rho_silhouette e r).
  unfold hit_of_a.tangent_squared. nra.
Qed.

(* A quadratic a s^2 - 2 b s + c with b > 0, and its root c / (b + sqrt d): the near one where a, c > 0. *)
Lemma root_by_conjugate a b c d : 0 < b -> d = b ^ 2 - a * c -> 0 <= d -> let q := sqrt d in let t := c / (b + q) in
  0 <= q /\ q ^ 2 = d /\ t * (b + q) = c /\ a * t = b - q /\ a * t ^ 2 - 2 * b * t + c = 0.
Proof.
  intros B E D q t. pose proof (sqrt_pos d) as P. pose proof (pow2_sqrt d D) as Q. fold q in P, Q.
  assert (T : t * (b + q) = c) by (unfold t; field; lra).
  assert (a * t = b - q) by nra.
  nra.
Qed.
Lemma near_root a b c d : 0 < a -> 0 < b -> 0 < c -> d = b ^ 2 - a * c -> 0 <= d ->
  let t := c / (b + sqrt d) in
  0 < t /\ a * t = b - sqrt d /\ a * t ^ 2 - 2 * b * t + c = 0 /\
  forall s, a * s ^ 2 - 2 * b * s + c = 0 -> t <= s.
Proof.
  intros Ha B C E D t. destruct (root_by_conjugate a b c d B E D) as (P & Q & T & A & S). fold t in T, A.
  repeat split; trivial; [nra |]. intros. apply (Rmult_le_reg_l a); nra.
Qed.

(* P(t) lies on A exactly if t is a root of A's quadratic. *)
Lemma quadratic_a t x y e r :
  on_a t x y e r <-> (x ^ 2 + y ^ 2 + e ^ 2) * t ^ 2 - 2 * e ^ 2 * t + (e ^ 2 - r ^ 2) = 0.
Proof. unfold on_a, distance2. nra. Qed.

Lemma t_a_value x y e r : 0 < r < e -> off_axis x y e -> 0 <= hit_of_a.discriminant_a x y e r ->
  hit_of_a.t_a x y e r = Finite ((e ^ 2 - r ^ 2) / (e ^ 2 + sqrt (hit_of_a.discriminant_a x y e r))).
Proof.
  intros. unfold hit_of_a.t_a, hit_of_a.root_a. destruct Rle_dec; [| contradiction].
  rewrite Rmax_right by lra. unfold hit_of_a.tangent_squared. do 2 f_equal. ring.
Qed.

Lemma t_a_near x y e r : 0 < r < e -> off_axis x y e -> 0 <= hit_of_a.discriminant_a x y e r ->
  exists t, hit_of_a.t_a x y e r = Finite t /\ 0 < t /\ t < 1 /\ on_a t x y e r /\
  forall s, on_a s x y e r -> t <= s.
Proof.
  intros. rewrite t_a_value by assumption. eexists; split; auto.
  destruct (near_root (x ^ 2 + y ^ 2 + e ^ 2) (e ^ 2) (e ^ 2 - r ^ 2) (hit_of_a.discriminant_a x y e r)) as (P & A & S & N); try nra. { apply
    discriminant_a_value; assumption. }
  split; auto. split.
  - pose proof (sqrt_pos (hit_of_a.discriminant_a x y e r)); nra.
  - split; [apply quadratic_a | intros s S'; apply N; apply quadratic_a in S']; lra.
Qed.

Lemma point_a : 0 < 1 < 4 /\ off_axis (1 / 2) 0 4 /\ hit_of_a.discriminant_a (1 / 2) 0 4 1 = 49 / 4.
Proof.
  assert (O : off_axis (1 / 2) 0 4) by (apply off_axis_far; lra).
  repeat split; try lra. { exact O. } rewrite discriminant_a_value by (lra || exact O). lra.
Qed.

Lemma no_hit_of_a x y e r : hit_of_a.discriminant_a x y e r < 0 -> hit_of_a.t_a x y e r = p_infty.
Proof. unfold hit_of_a.t_a. destruct Rle_dec; [lra | reflexivity]. Qed.

Lemma rim : off_axis (15 / 16) 0 (5 / 4) /\ hit_of_a.discriminant_a (15 / 16) 0 (5 / 4) (3 / 4) = 0.
Proof.
  assert (O : off_axis (15 / 16) 0 (5 / 4)) by (apply off_axis_far; lra).
  split; auto. rewrite discriminant_a_value by (lra || exact O). lra.
Qed.

(* Every point of the unit circle has an angle. *)
Lemma angle_of c s : c ^ 2 + s ^ 2 = 1 -> exists a, - PI < a <= PI /\ cos a = c /\ sin a = s /\ (0 < s -> 0 < a < PI).
Proof.
  intros. assert (C : -1 <= c <= 1) by nra. pose proof (acos_bound c). pose proof PI_RGT_0.
  assert (S : sin (acos c) = Rabs s).
  { rewrite sin_acos by lra. replace (_ - _) with (Rsqr s) by (unfold Rsqr; nra). apply sqrt_Rsqr_abs. }
  destruct (Rle_lt_dec 0 s).
  - exists (acos c). rewrite cos_acos, S, Rabs_pos_eq by assumption. repeat split; try lra.
    + destruct (Req_dec (acos c) 0) as [E |]; [| lra]. rewrite E, sin_0 in S. rewrite Rabs_pos_eq in S; lra.
    + destruct (Req_dec (acos c) PI) as [E |]; [| lra]. rewrite E, sin_PI in S. rewrite Rabs_pos_eq in S; lra.
  - exists (- acos c). rewrite cos_neg, sin_neg, cos_acos, S, Rabs_left by assumption.
    destruct (Req_dec (acos c) PI) as [E |]; [| lra]. rewrite E, sin_PI in S. rewrite Rabs_left in S; lra.
Qed.

(* Off the pole the point hit is R (sin phi cos theta, sin phi sin theta, cos phi) for two angles, whose cosines and
   sines are those of the program: cos theta = x / rho, sin theta = y / rho, sin phi = t rho / R > 0,
   cos phi = e (1 - t) / R. *)
Theorem stable_frame__true_angles x y e r : 0 < r < e -> off_axis x y e -> 0 <= hit_of_a.discriminant_a x y e r -> let rho := sqrt (x ^ 2 + y ^ 2)
  in exists t theta phi, hit_of_a.t_a x y e r = Finite t /\ on_a t x y e r /\ - PI < theta <= PI /\ 0 < phi < PI /\ (cos theta =
  angles_on_a.cos_theta x y e /\ sin theta = angles_on_a.sin_theta x y e /\ cos phi = angles_on_a.cos_phi x y e r /\ sin phi = angles_on_a.sin_phi
  x y e r) /\ (t * x = point_on_a.point_x (cos theta) (sin phi) r /\ t * y = point_on_a.point_y (sin theta) (sin phi) r /\ e * (1 - t) =
  point_on_a.point_z (cos phi) r) /\ (point_on_a.point_x (cos theta) (sin phi) r = r * (sin phi * cos theta) /\ point_on_a.point_y (sin theta)
  (sin phi) r = r * (sin phi * sin theta) /\ point_on_a.point_z (cos phi) r = r * cos phi) /\ cos theta = x / rho /\ sin theta = y / rho /\ sin
  phi = t * rho / r /\ 0 < sin phi /\ cos phi = e * (1 - t) / r.
Proof.
  intros H O D rho. pose proof (off_axis_pos x y e ltac:(lra) O) as P. pose proof (sqrt_lt_R0 _ P) as Q.
  pose proof (sqrt_sqrt _ (Rlt_le _ _ P)) as S. fold rho in Q, S.
  destruct (t_a_near x y e r H O D) as (t & T & A & B & M & _).
  pose proof T as U. rewrite (t_a_value x y e r H O D) in U. apply Rbar_finite_eq in U.
  pose proof (sqrt_pos (hit_of_a.discriminant_a x y e r)).
  assert (K : 0 < e ^ 2 + sqrt (hit_of_a.discriminant_a x y e r)) by nra.
  assert (L : angles_on_a.cos_theta x y e = x / rho /\ angles_on_a.sin_theta x y e = y / rho /\ angles_on_a.sin_phi x y e r = t * rho / r /\
    angles_on_a.cos_phi x y e r = e * (1 - t) / r).
  { unfold angles_on_a.cos_theta, angles_on_a.sin_theta, angles_on_a.sin_phi, angles_on_a.cos_phi, angles_on_a.rho_inverse, angles_on_a.hit_scale.
    change (angles_on_a.rho x y e) with (hit_of_a.rho x y e). rewrite (rho_a x y e O). fold rho.
    change (angles_on_a.root_a x y e r) with (sqrt (Rmax 0 (hit_of_a.discriminant_a x y e r))).
    rewrite Rmax_right by auto. unfold angles_on_a.tangent_squared. rewrite <- U. destruct Rlt_dec; [| lra]. repeat split; field; lra. }
  destruct L as (CT & ST & SP & CP).
  assert (N : 0 < t * rho / r) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra).
  destruct (angle_of (x / rho) (y / rho)) as (theta & R1 & C1 & S1 & _).
  { replace ((x / rho) ^ 2 + (y / rho) ^ 2) with ((x ^ 2 + y ^ 2) / (rho * rho)) by (field; lra). rewrite S. field.
    lra. }
  destruct (angle_of (e * (1 - t) / r) (t * rho / r)) as (phi & _ & C2 & S2 & R2).
  { replace (_ + _) with ((e ^ 2 * (1 - t) ^ 2 + t ^ 2 * (rho * rho)) / r ^ 2) by (field; lra). rewrite S.
    unfold on_a, distance2 in M. replace (_ + _) with (r ^ 2) by nra. field. lra. }
  exists t, theta, phi. point_on_a.lines.
  rewrite CT, ST, SP, CP, C1, S1, C2, S2. split; [exact T |]. split; [exact M |]. split; [exact R1 |].
  split; [apply R2, N |]. repeat split; try exact N; try (field; lra).
Qed.

Theorem stable_frame__true_angles__point : exists x y e r,
  0 < r < e /\ off_axis x y e /\ 0 <= hit_of_a.discriminant_a x y e r.
Proof. exists (1 / 2), 0, 4, 1. destruct point_a as (H & O & D). repeat split; try lra; exact O. Qed.

(* Not cos phi = e t / R. *)
Theorem stable_frame__true_angles__false : ~ forall x y e r, 0 < r < e -> off_axis x y e -> 0 <= hit_of_a.discriminant_a x y e r -> exists t,
  hit_of_a.t_a x y e r = Finite t /\ angles_on_a.cos_phi x y e r = e * t / r.
Proof.
  intros F. destruct rim as [O D]. destruct (F (15 / 16) 0 (5 / 4) (3 / 4)) as (t & T & C); [lra | auto | lra |].
  destruct (stable_frame__true_angles (15 / 16) 0 (5 / 4) (3 / 4)) as (s & a & b & U & M & _ & _ & (_ & _ & V & _) & _ & _ & _ & _ & _ & _ & W); [lra
    | exact O | lra |]. rewrite T in U. apply Rbar_finite_eq in U. subst s.
  assert (t = 1 / 2) by lra. subst t. unfold on_a, distance2 in M. lra.
Qed.

(* |f| has a corner where f = 0 and f' is not 0. *)
Lemma corner f x d : is_derive f x d -> f x = 0 -> d <> 0 -> ~ ex_derive (fun y => Rabs (f y)) x.
Proof.
  intros F Z D [l L]. apply is_derive_Reals in F. apply is_derive_Reals in L. apply D.
  assert (l = 0) as ->.
  { pose (pr := exist _ l L : derivable_pt (fun y => Rabs (f y)) x).
    change l with (derive_pt _ x pr).
    apply (deriv_minimum _ (x - 1) (x + 1)); try lra. intros. rewrite Z, Rabs_R0. apply Rabs_pos. }
  apply (uniqueness_limite f x); auto. intros eps E. destruct (L eps E) as [delta H]. exists delta.
  intros h K0 Hd. specialize (H h K0 Hd). rewrite Z, Rabs_R0, !Rminus_0_r in *.
  unfold Rdiv in *. rewrite Rabs_mult, Rabs_Rabsolu in H. rewrite Rabs_mult. lra.
Qed.

Lemma sine_zero a : sin (PI * a) = 0 <-> exists m : Z, a = IZR m.
Proof.
  pose proof PI_RGT_0. split.
  - intros S. destruct (sin_eq_0_0 _ S) as [m M]. exists m. nra.
  - intros [m ->]. rewrite Rmult_comm. apply sin_eq_0_1. exists m. reflexivity.
Qed.

Lemma creased k a c : k <> 0 -> c <> 0 ->
  (exists m : Z, k * a = IZR m) <-> ~ ex_derive (fun a => Rabs (sin (PI * (k * a)) * c)) a.
Proof.
  rewrite <- sine_zero. assert (D : is_derive (fun a => sin (PI * (k * a)) * c) a (PI * k * cos _ * c)) by (auto_derive; [exact I | ring]). split.
  - intros S. apply (corner _ _ _ D).
    + rewrite S. lra.
    + assert (cos (PI * (k * a)) <> 0) by (pose proof (sin2_cos2 (PI * (k * a))) as Q; unfold Rsqr in Q; nra).
      pose proof PI_RGT_0. do 3 (apply Rmult_integral_contrapositive_currified; [| assumption]). lra.
  - intros N. destruct (Req_dec (sin (PI * (k * a))) 0); [lra | destruct N].
    eexists. apply (is_derive_Rabs _ _ _ D). nra.
Qed.

(* Ridges is creased in u exactly on the rays k_u u = m with m whole, off the circles where it is 0 all along. *)
Theorem kink_loci__creased_in_u (u v ku kv : R) : ku <> 0 -> sin (PI * (kv * v)) <> 0 ->
  (exists m : Z, ku * u = IZR m) <-> ~ ex_derive (fun u => height_ridges.h u v ku kv) u.
Proof. apply creased. Qed.

Lemma half_sine : sin (PI * (1 * (1 / 2))) = 1.
Proof. replace (_ * _) with (PI / 2) by field. apply sin_PI2. Qed.

Theorem kink_loci__creased_in_u__point : exists v ku kv, ku <> 0 /\ sin (PI * (kv * v)) <> 0.
Proof. exists (1 / 2), 1, 1. rewrite half_sine. lra. Qed.

(* Not where sin (pi k_v v) = 0. *)
Ltac level_at_0 := intros F; apply (F 0 0 1 1); [lra | exists 0%Z; lra |]; apply (ex_derive_ext (fun _ => 0)); [| apply ex_derive_const];
  intros t; unfold height_ridges.h; rewrite !Rmult_0_r, sin_0, ?Rmult_0_r, ?Rmult_0_l, Rabs_R0; reflexivity.
Theorem kink_loci__creased_in_u__false : ~ forall u v ku kv : R, ku <> 0 ->
  (exists m : Z, ku * u = IZR m) -> ~ ex_derive (fun u => height_ridges.h u v ku kv) u.
Proof. level_at_0. Qed.

(* Ridges is creased in v exactly on the circles k_v v = m with m whole, off the rays where it is 0 all along. *)
Theorem kink_loci__creased_in_v (u v ku kv : R) : kv <> 0 -> sin (PI * (ku * u)) <> 0 ->
  (exists m : Z, kv * v = IZR m) <-> ~ ex_derive (fun v => height_ridges.h u v ku kv) v.
Proof.
  intros K S. rewrite (creased kv v _ K S).
  split; intros N D; apply N; (eapply ex_derive_ext; [| exact D]); intros; unfold height_ridges.h; rewrite Rmult_comm; reflexivity.
Qed.

Theorem kink_loci__creased_in_v__point : exists u ku kv, kv <> 0 /\ sin (PI * (ku * u)) <> 0.
Proof. exists (1 / 2), 1, 1. rewrite half_sine. lra. Qed.

(* Not where sin (pi k_u u) = 0. *)
Theorem kink_loci__creased_in_v__false : ~ forall u v ku kv : R, kv <> 0 ->
  (exists m : Z, kv * v = IZR m) -> ~ ex_derive (fun v => height_ridges.h u v ku kv) v.
Proof. level_at_0. Qed.

(* The pixel's centre in the default view: e = 4, R = 1, 256^2 pixels. *)
Definition pixel_x (m : Z) := image_point.x (IZR m) 256 256 (image_extent.half 4 1).
Definition pixel_y (n : Z) := image_point.y (IZR n) 256 (image_extent.half 4 1).

Ltac of_pixels := unfold pixel_x, pixel_y; image_point.lines; image_extent.lines;
  replace ((4 - 1) * (4 + 1)) with 15 by ring; pose proof (sqrt_lt_R0 15 ltac:(lra)); pose proof (sqrt_sqrt 15 ltac:(lra)) as Q.
Lemma pixel_value m n : pixel_x m ^ 2 + pixel_y n ^ 2 =
  5 / 3 * (((2 * IZR m - 255) / 256) ^ 2 + ((1083 - 10 * IZR n) / 1280) ^ 2).
Proof.
  of_pixels.
  replace (5 / 3) with (25 / (sqrt 15 * sqrt 15)) by (rewrite Q; field). field. lra.
Qed.

Lemma pixel_far m n : 34 / 15 / 256 ^ 2 <= pixel_x m ^ 2 + pixel_y n ^ 2.
Proof.
  rewrite pixel_value. assert (A : 1 <= (2 * IZR m - 255) ^ 2).
  { assert (m <= 127 \/ 128 <= m)%Z as [L | L] by lia; apply IZR_le in L; nra. }
  assert (9 <= (1083 - 10 * IZR n) ^ 2).
  { assert (n <= 108 \/ 109 <= n)%Z as [L | L] by lia; apply IZR_le in L; nra. }
  lra.
Qed.

(* Every pixel of 256^2 has rho >= sqrt (34/15) / 256. *)
Theorem pixels_off_the_pole__raster m n : sqrt (34 / 15) / 256 <= sqrt (pixel_x m ^ 2 + pixel_y n ^ 2).
Proof.
  replace (_ / _) with (sqrt (34 / 15 / 256 ^ 2)).
  - apply sqrt_le_1_alt, pixel_far.
  - rewrite sqrt_div_alt by lra. rewrite sqrt_pow2 by lra. reflexivity.
Qed.

(* Not rho >= 2 / 256. *)
Theorem pixels_off_the_pole__raster__false : ~ forall m n : Z, 2 / 256 <= sqrt (pixel_x m ^ 2 + pixel_y n ^ 2).
Proof.
  intros F. specialize (F 127%Z 108%Z). rewrite pixel_value in F.
  replace (2 / 256) with (sqrt ((2 / 256) ^ 2)) in F by (apply sqrt_pow2; lra). apply sqrt_le_0 in F; lra.
Qed.

Lemma pixel_off_axis m n : off_axis (pixel_x m) (pixel_y n) 4.
Proof. apply off_axis_far; pose proof (pixel_far m n); lra. Qed.

Lemma sqrt_is a b : 0 <= b -> a = b ^ 2 -> sqrt a = b.
Proof. intros B ->. apply sqrt_pow2, B. Qed.

(* The view direction is the unit vector from the image point (x, y, 0), and so from every point of its ray, to the
   eye. *)
