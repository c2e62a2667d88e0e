(* The camera's theorems: hits with both spheres, their silhouettes, what is seen, creases in the image, the pole's pixels. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas.
Open Scope R_scope.

(* The square of the distance from C to the point P(t) = (t x, t y, e (1 - t)) of the ray through the image point (x, y). *)
Definition distance2 (t x y e cx cy cz : R) := (t * x - cx) ^ 2 + (t * y - cy) ^ 2 + (e * (1 - t) - cz) ^ 2.
Definition on_a (t x y e r : R) := distance2 t x y e 0 0 0 = r ^ 2.
Definition on_b (t x y e cx cy cz r : R) := distance2 t x y e cx cy cz = r ^ 2.

Definition dot (ax ay az bx by_ bz : R) := ax * bx + ay * by_ + az * bz.
Definition cross2 (ax ay az bx by_ bz : R) :=
  (ay * bz - az * by_) ^ 2 + (az * bx - ax * bz) ^ 2 + (ax * by_ - ay * bx) ^ 2.

(* Where the program does not take a ray for the axis itself: rho is not below 10^-150 e. *)
Definition tiny := 1 / IZR (10 ^ 150).
Definition off_axis (x y e : R) := tiny * e <= sqrt (x ^ 2 + y ^ 2).

Lemma tiny_pos : 0 < tiny.
Proof. unfold tiny, Rdiv. rewrite Rmult_1_l. apply Rinv_0_lt_compat, (IZR_lt 0). reflexivity. Qed.

Lemma off_axis_pos x y e : 0 < e -> off_axis x y e -> 0 < x ^ 2 + y ^ 2.
Proof.
  unfold off_axis. intros He H. pose proof (Rmult_lt_0_compat _ _ tiny_pos He).
  destruct (Rle_lt_dec (x ^ 2 + y ^ 2) 0) as [L | L]; [rewrite sqrt_neg_0 in H by exact L; lra | exact L].
Qed.

Lemma off_axis_far x y e : e <= 10 -> / 1000000 <= x ^ 2 + y ^ 2 -> off_axis x y e.
Proof.
  unfold off_axis. intros He H. pose proof tiny_pos. apply Rle_trans with (/ 1000).
  - assert (tiny <= / 10000); [| nra].
    unfold tiny, Rdiv. rewrite Rmult_1_l. apply Rinv_le_contravar; [lra | apply IZR_le; vm_compute; discriminate].
  - rewrite <- (sqrt_pow2 (/ 1000)) by lra. apply sqrt_le_1_alt. lra.
Qed.

Lemma rho_a x y e : off_axis x y e -> hit_of_a.rho x y e = sqrt (x ^ 2 + y ^ 2).
Proof.
  intros H. unfold hit_of_a.rho, hit_of_a.rho_raw. destruct Rle_dec as [_ | N]; [reflexivity | destruct N; exact H].
Qed.

Lemma rho_a_squared x y e : off_axis x y e -> hit_of_a.rho x y e ^ 2 = x ^ 2 + y ^ 2.
Proof. intros H. rewrite rho_a, pow2_sqrt by (assumption || nra). reflexivity. Qed.

Lemma tangent_pos e r : 0 < r < e -> 0 < e ^ 2 - r ^ 2.
Proof. nra. Qed.

Lemma rho_silhouette_squared e r : 0 < r < e ->
  0 < silhouette_of_a.rho_silhouette e r /\ silhouette_of_a.rho_silhouette e r ^ 2 * (e ^ 2 - r ^ 2) = e ^ 2 * r ^ 2.
Proof.
  intros H. unfold silhouette_of_a.rho_silhouette, silhouette_of_a.tangent_squared.
  assert (P : 0 < (e - r) * (e + r)) by nra. pose proof (sqrt_lt_R0 _ P). pose proof (sqrt_sqrt _ (Rlt_le _ _ P)).
  split; [apply Rdiv_lt_0_compat; nra |].
  replace (e ^ 2 - r ^ 2) with ((e - r) * (e + r)) by ring. rewrite <- H1 at 2. field. lra.
Qed.

Lemma discriminant_a_value x y e r : 0 < r < e -> off_axis x y e ->
  hit_of_a.discriminant_a x y e r = (e ^ 2) ^ 2 - (x ^ 2 + y ^ 2 + e ^ 2) * (e ^ 2 - r ^ 2).
Proof.
  intros H O. destruct (rho_silhouette_squared e r H) as [_ S]. pose proof (rho_a_squared x y e O) as Q.
  unfold hit_of_a.discriminant_a. change (hit_of_a.rho_silhouette e r) with (silhouette_of_a.rho_silhouette e r).
  unfold hit_of_a.tangent_squared. nra.
Qed.

(* A quadratic a s^2 - 2 b s + c with b, c > 0, and its near root c / (b + sqrt d). *)
Lemma near_root a b c d : 0 < a -> 0 < b -> 0 < c -> d = b ^ 2 - a * c -> 0 <= d ->
  let t := c / (b + sqrt d) in
  0 < t /\ a * t = b - sqrt d /\ a * t ^ 2 - 2 * b * t + c = 0 /\
  (forall s, a * s ^ 2 - 2 * b * s + c = 0 -> t <= s) /\
  (forall s, a * s ^ 2 - 2 * b * s + c = 0 -> a * s <= b -> s = t).
Proof.
  intros Ha Hb Hc E Hd t. pose proof (sqrt_pos d). pose proof (sqrt_sqrt d Hd). set (q := sqrt d) in *.
  assert (T : t * (b + q) = c) by (unfold t; field; lra).
  assert (P : 0 < t) by (apply Rdiv_lt_0_compat; lra).
  assert (A : a * t = b - q) by (apply (Rmult_eq_reg_r (b + q)); [nra | lra]).
  repeat split; try assumption.
  - replace c with (t * (b + q)) by exact T. nra.
  - intros s S. assert (S2 : (a * s - b) ^ 2 = q ^ 2) by nra.
    apply (Rmult_le_reg_l a); [exact Ha |]. rewrite A. nra.
  - intros s S L. assert (S2 : (a * s - b) ^ 2 = q ^ 2) by nra. apply (Rmult_eq_reg_l a); [| lra]. rewrite A. nra.
Qed.

(* P(t) lies on A exactly if t is a root of A's quadratic. *)
Lemma quadratic_a t x y e r :
  on_a t x y e r <-> (x ^ 2 + y ^ 2 + e ^ 2) * t ^ 2 - 2 * e ^ 2 * t + (e ^ 2 - r ^ 2) = 0.
Proof. unfold on_a, distance2. split; intros; nra. Qed.

Lemma t_a_value x y e r : 0 < r < e -> off_axis x y e -> 0 <= hit_of_a.discriminant_a x y e r ->
  hit_of_a.t_a x y e r = Finite ((e ^ 2 - r ^ 2) / (e ^ 2 + sqrt (hit_of_a.discriminant_a x y e r))).
Proof.
  intros H O D. unfold hit_of_a.t_a, hit_of_a.root_a. destruct Rle_dec as [_ | N]; [| contradiction].
  rewrite Rmax_right by exact D. unfold hit_of_a.tangent_squared. do 2 f_equal. ring.
Qed.

Lemma t_a_near x y e r : 0 < r < e -> off_axis x y e -> 0 <= hit_of_a.discriminant_a x y e r ->
  exists t, hit_of_a.t_a x y e r = Finite t /\ 0 < t /\ t < 1 /\ on_a t x y e r /\
  (forall s, on_a s x y e r -> t <= s) /\
  (forall s, on_a s x y e r -> (x ^ 2 + y ^ 2 + e ^ 2) * s <= e ^ 2 -> s = t).
Proof.
  intros H O D. rewrite t_a_value by assumption. eexists; split; [reflexivity |].
  pose proof (tangent_pos e r H). pose proof (pow2_ge_0 x). pose proof (pow2_ge_0 y).
  destruct (near_root (x ^ 2 + y ^ 2 + e ^ 2) (e ^ 2) (e ^ 2 - r ^ 2) (hit_of_a.discriminant_a x y e r))
    as (P & A & S & N & F); try nra. { apply discriminant_a_value; assumption. }
  split; [exact P |]. split.
  - apply (Rdiv_lt_1 (e ^ 2 - r ^ 2)); pose proof (sqrt_pos (hit_of_a.discriminant_a x y e r)); nra.
  - repeat split; intros; [apply quadratic_a; lra | apply N | apply F]; try apply quadratic_a in H3; lra.
Qed.

(* The program's discriminant is d = (e^2 - R^2) (rho_s^2 - rho^2). *)
Theorem hit_of_a__discriminant (x y e r : R) : 0 < r < e -> off_axis x y e ->
  hit_of_a.discriminant_a x y e r =
    (e ^ 2 - r ^ 2) * (silhouette_of_a.rho_silhouette e r ^ 2 - sqrt (x ^ 2 + y ^ 2) ^ 2).
Proof.
  intros H O. rewrite discriminant_a_value, pow2_sqrt by (assumption || nra).
  destruct (rho_silhouette_squared e r H) as [_ S]. nra.
Qed.

Lemma point_a : 0 < 1 < 4 /\ off_axis (1 / 2) 0 4 /\ hit_of_a.discriminant_a (1 / 2) 0 4 1 = 49 / 4.
Proof.
  assert (O : off_axis (1 / 2) 0 4) by (apply off_axis_far; lra).
  repeat split; try lra. { exact O. } rewrite discriminant_a_value by (lra || exact O). lra.
Qed.

Theorem hit_of_a__discriminant__point : exists x y e r, 0 < r < e /\ off_axis x y e.
Proof. exists (1 / 2), 0, 4, 1. split; apply point_a. Qed.

(* Without the factor e^2 - R^2 it is not. *)
Theorem hit_of_a__discriminant__false : ~ forall x y e r : R, 0 < r < e -> off_axis x y e ->
  hit_of_a.discriminant_a x y e r = silhouette_of_a.rho_silhouette e r ^ 2 - sqrt (x ^ 2 + y ^ 2) ^ 2.
Proof.
  intros F. destruct point_a as (H & O & D). specialize (F _ _ _ _ H O). rewrite D, pow2_sqrt in F by lra.
  destruct (rho_silhouette_squared 4 1 H) as [_ S]. lra.
Qed.

(* If e > R and d >= 0, then t = (e^2 - R^2) / (e^2 + sqrt d) is the least root of |P(t)|^2 = R^2, and t > 0. *)
Theorem hit_of_a__near (x y e r : R) : 0 < r < e -> off_axis x y e -> 0 <= hit_of_a.discriminant_a x y e r ->
  exists t, hit_of_a.t_a x y e r = Finite t /\
  t = (e ^ 2 - r ^ 2) / (e ^ 2 + sqrt (hit_of_a.discriminant_a x y e r)) /\
  0 < t /\ on_a t x y e r /\ forall s, on_a s x y e r -> t <= s.
Proof.
  intros H O D. destruct (t_a_near x y e r H O D) as (t & T & P & _ & S & N & _).
  exists t. rewrite T. rewrite t_a_value in T by assumption. injection T as T. repeat split; auto.
Qed.

Theorem hit_of_a__near__point :
  exists x y e r, 0 < r < e /\ off_axis x y e /\ 0 <= hit_of_a.discriminant_a x y e r.
Proof. exists (1 / 2), 0, 4, 1. destruct point_a as (H & O & D). repeat split; try lra; exact O. Qed.

(* It is not the far root. *)
Theorem hit_of_a__near__false : ~ forall x y e r : R,
  0 < r < e -> off_axis x y e -> 0 <= hit_of_a.discriminant_a x y e r ->
  exists t, hit_of_a.t_a x y e r = Finite t /\ forall s, on_a s x y e r -> s <= t.
Proof.
  intros F. destruct point_a as (H & O & D). destruct (F (1 / 2) 0 4 1) as (t & T & N); [lra | exact O | lra |].
  rewrite t_a_value in T by (lra || exact O). injection T as T. pose proof (sqrt_pos (hit_of_a.discriminant_a (1 / 2) 0 4 1)).
  assert (t < 1) by (rewrite <- T; apply (Rdiv_lt_1 (4 ^ 2 - 1 ^ 2)); lra).
  specialize (N (6 / 5)). unfold on_a, distance2 in N. lra.
Qed.

(* If d < 0 there is no hit. *)
Theorem hit_of_a__misses (x y e r : R) : 0 < r < e -> off_axis x y e -> hit_of_a.discriminant_a x y e r < 0 ->
  hit_of_a.t_a x y e r = p_infty /\ forall t, ~ on_a t x y e r.
Proof.
  intros H O D. split.
  - unfold hit_of_a.t_a. destruct Rle_dec; [lra | reflexivity].
  - intros t T. apply quadratic_a in T. rewrite discriminant_a_value in D by assumption. 
    pose proof (pow2_ge_0 ((x ^ 2 + y ^ 2 + e ^ 2) * t - e ^ 2)). nra.
Qed.

Theorem hit_of_a__misses__point :
  exists x y e r, 0 < r < e /\ off_axis x y e /\ hit_of_a.discriminant_a x y e r < 0.
Proof.
  assert (O : off_axis 2 0 4) by (apply off_axis_far; lra).
  exists 2, 0, 4, 1. repeat split; try lra; try exact O. rewrite discriminant_a_value by (lra || exact O). lra.
Qed.

Lemma rim : off_axis (15 / 16) 0 (5 / 4) /\ hit_of_a.discriminant_a (15 / 16) 0 (5 / 4) (3 / 4) = 0.
Proof.
  assert (O : off_axis (15 / 16) 0 (5 / 4)) by (apply off_axis_far; lra).
  split; [exact O |]. rewrite discriminant_a_value by (lra || exact O). lra.
Qed.

(* At d = 0 there is one. *)
Theorem hit_of_a__misses__false : ~ forall x y e r : R,
  0 < r < e -> off_axis x y e -> hit_of_a.discriminant_a x y e r <= 0 -> forall t, ~ on_a t x y e r.
Proof.
  intros F. destruct rim as [O D]. apply (F (15 / 16) 0 (5 / 4) (3 / 4)) with (16 / 25); try lra; try exact O.
  unfold on_a, distance2. lra.
Qed.

(* Lagrange's identity for sphere B: with a = (x, y, -e), w = C - E, the program's discriminant is both
   |a|^2 r^2 - |a x w|^2 and (a.w)^2 - |a|^2 (|w|^2 - r^2). *)
Theorem lagrange_identity__of_b (x y e cx cy cz r : R) :
  hit_of_b.discriminant_b x y e cx cy cz r =
    dot x y (- e) x y (- e) * r ^ 2 - cross2 x y (- e) cx cy (cz - e) /\
  hit_of_b.discriminant_b x y e cx cy cz r =
    dot x y (- e) cx cy (cz - e) ^ 2
    - dot x y (- e) x y (- e) * (dot cx cy (cz - e) cx cy (cz - e) - r ^ 2).
Proof. unfold hit_of_b.discriminant_b, hit_of_b.distance, dot, cross2. split; ring. Qed.

(* Not with w = C in place of C - E. *)
Theorem lagrange_identity__of_b__false : ~ forall x y e cx cy cz r : R,
  hit_of_b.discriminant_b x y e cx cy cz r =
    dot x y (- e) cx cy (cz - e) ^ 2 - dot x y (- e) x y (- e) * (dot cx cy cz cx cy cz - r ^ 2).
Proof. intros F. specialize (F 0 0 1 0 0 0 1). unfold hit_of_b.discriminant_b, hit_of_b.distance, dot in F. lra. Qed.

(* The same for a shadow, with a = L - P, w = C - P. *)
Theorem lagrange_identity__of_shadow (px py pz lx ly lz cx cy cz r : R) :
  let ax := lx - px in let ay := ly - py in let az := lz - pz in
  let wx := cx - px in let wy := cy - py in let wz := cz - pz in
  let d := shadow.shadow_discriminant px py pz lx ly lz cx cy cz r in
  d = dot ax ay az ax ay az * r ^ 2 - cross2 ax ay az wx wy wz /\
  d = dot ax ay az wx wy wz ^ 2 - dot ax ay az ax ay az * (dot wx wy wz wx wy wz - r ^ 2).
Proof.
  intros. unfold d, shadow.shadow_discriminant, shadow.segment_squared, shadow.segment_x, shadow.segment_y,
    shadow.segment_z, shadow.offset_x, shadow.offset_y, shadow.offset_z, dot, cross2, ax, ay, az, wx, wy, wz.
  split; ring.
Qed.

(* Not with + |a x w|^2. *)
Theorem lagrange_identity__of_shadow__false : ~ forall px py pz lx ly lz cx cy cz r : R,
  shadow.shadow_discriminant px py pz lx ly lz cx cy cz r =
  dot (lx - px) (ly - py) (lz - pz) (lx - px) (ly - py) (lz - pz) * r ^ 2
  + cross2 (lx - px) (ly - py) (lz - pz) (cx - px) (cy - py) (cz - pz).
Proof.
  intros F. specialize (F 0 0 0 1 0 0 0 1 0 0).
  unfold shadow.shadow_discriminant, shadow.segment_squared, shadow.segment_x, shadow.segment_y,
    shadow.segment_z, shadow.offset_x, shadow.offset_y, shadow.offset_z, dot, cross2 in F. lra.
Qed.

(* A ray meets A exactly if rho <= rho_s = e R / sqrt (e^2 - R^2). *)
Theorem silhouette_of_a__meets (x y e r : R) : 0 < r < e -> off_axis x y e ->
  (exists t, on_a t x y e r) <-> sqrt (x ^ 2 + y ^ 2) <= silhouette_of_a.rho_silhouette e r.
Proof.
  intros H O. destruct (rho_silhouette_squared e r H) as [P S]. pose proof (hit_of_a__discriminant x y e r H O) as D.
  pose proof (tangent_pos e r H) as T. pose proof (sqrt_pos (x ^ 2 + y ^ 2)) as Q.
  set (rho := sqrt (x ^ 2 + y ^ 2)) in *. set (edge := silhouette_of_a.rho_silhouette e r) in *. split.
  - intros [t M]. destruct (Rle_lt_dec rho edge) as [L | L]; [exact L | exfalso].
    assert (edge ^ 2 < rho ^ 2) by nra. apply (proj2 (hit_of_a__misses x y e r H O ltac:(rewrite D; nra)) t M).
  - intros L. assert (rho ^ 2 <= edge ^ 2) by nra. destruct (hit_of_a__near x y e r H O) as (t & _ & _ & _ & M & _); [rewrite D; nra | exists t; exact M].
Qed.

Theorem silhouette_of_a__meets__point : exists x y e r, 0 < r < e /\ off_axis x y e.
Proof. exists (1 / 2), 0, 4, 1. split; apply point_a. Qed.

(* Not exactly if rho <= R: the silhouette lies outside that circle. *)
Theorem silhouette_of_a__meets__false : ~ forall x y e r : R, 0 < r < e -> off_axis x y e ->
  (exists t, on_a t x y e r) -> sqrt (x ^ 2 + y ^ 2) <= r.
Proof.
  intros F. destruct rim as [O D]. specialize (F (15 / 16) 0 (5 / 4) (3 / 4) ltac:(lra) O).
  replace ((15 / 16) ^ 2 + 0 ^ 2) with ((15 / 16) ^ 2) in F by ring. rewrite sqrt_pow2 in F by lra.
  enough (15 / 16 <= 3 / 4) by lra. apply F. exists (16 / 25). unfold on_a, distance2. lra.
Qed.

(* The definition: rho_s = e R / sqrt (e^2 - R^2). *)
Theorem silhouette_of_a__radius (e r : R) : 0 < r < e ->
  silhouette_of_a.rho_silhouette e r = e * r / sqrt (e ^ 2 - r ^ 2).
Proof.
  intros _. unfold silhouette_of_a.rho_silhouette, silhouette_of_a.tangent_squared.
  replace ((e - r) * (e + r)) with (e ^ 2 - r ^ 2) by ring. reflexivity.
Qed.

Theorem silhouette_of_a__radius__point : exists e r, 0 < r < e.
Proof. exists 4, 1. lra. Qed.

(* Not with e^2 + R^2. *)
Theorem silhouette_of_a__radius__false : ~ forall e r : R, 0 < r < e ->
  silhouette_of_a.rho_silhouette e r = e * r / sqrt (e ^ 2 + r ^ 2).
Proof.
  intros F. specialize (F 4 1 ltac:(lra)). destruct (rho_silhouette_squared 4 1 ltac:(lra)) as [_ S].
  rewrite F in S. unfold Rdiv in S. rewrite Rpow_mult_distr, pow_inv, pow2_sqrt in S by lra. lra.
Qed.

(* The near hit then has 0 < t < 1: it is in front of the floor. *)
Theorem silhouette_of_a__in_front (x y e r : R) : 0 < r < e -> off_axis x y e ->
  sqrt (x ^ 2 + y ^ 2) <= silhouette_of_a.rho_silhouette e r ->
  exists t, hit_of_a.t_a x y e r = Finite t /\ on_a t x y e r /\ 0 < t < 1.
Proof.
  intros H O L. destruct (rho_silhouette_squared e r H) as [P S]. pose proof (hit_of_a__discriminant x y e r H O) as D.
  pose proof (tangent_pos e r H). assert (Q := pow_incr _ _ 2 (conj (sqrt_pos (x ^ 2 + y ^ 2)) L)).
  destruct (t_a_near x y e r H O) as (t & T & A & B & M & _); [rewrite D; nra |]. exists t. auto.
Qed.

Theorem silhouette_of_a__in_front__point : exists x y e r,
  0 < r < e /\ off_axis x y e /\ sqrt (x ^ 2 + y ^ 2) <= silhouette_of_a.rho_silhouette e r.
Proof.
  destruct point_a as (H & O & D). exists (1 / 2), 0, 4, 1. repeat split; try lra; try exact O.
  apply silhouette_of_a__meets; try lra; try exact O. destruct (hit_of_a__near (1 / 2) 0 4 1) as (t & _ & _ & _ & M & _);
    [lra | exact O | lra | exists t; exact M].
Qed.

(* Not as near as half way. *)
Theorem silhouette_of_a__in_front__false : ~ forall x y e r : R, 0 < r < e -> off_axis x y e ->
  sqrt (x ^ 2 + y ^ 2) <= silhouette_of_a.rho_silhouette e r ->
  exists t, hit_of_a.t_a x y e r = Finite t /\ t < 1 / 2.
Proof.
  intros F. destruct point_a as (H & O & D).
  destruct (F (1 / 2) 0 4 1) as (t & T & L); [lra | exact O | |].
  - apply silhouette_of_a__meets; try lra; try exact O. destruct (hit_of_a__near (1 / 2) 0 4 1) as (t & _ & _ & _ & M & _);
      [lra | exact O | lra | exists t; exact M].
  - destruct (hit_of_a__near (1 / 2) 0 4 1) as (s & U & _ & _ & M & _); [lra | exact O | lra |].
    rewrite T in U. injection U as <-. unfold on_a, distance2 in M. nra.
Qed.

(* At rho = rho_s the ray touches A in one point, P.D = 0, at height R^2 / e, that is cos phi = R / e. *)
Theorem silhouette_of_a__tangent (x y e r : R) : 0 < r < e -> off_axis x y e ->
  sqrt (x ^ 2 + y ^ 2) = silhouette_of_a.rho_silhouette e r ->
  exists t, hit_of_a.t_a x y e r = Finite t /\ on_a t x y e r /\ (forall s, on_a s x y e r -> s = t) /\
  dot (t * x) (t * y) (e * (1 - t)) x y (- e) = 0 /\ e * (1 - t) = r ^ 2 / e /\
  forall phi, e * (1 - t) = r * cos phi -> cos phi = r / e.
Proof.
  intros H O E. destruct (rho_silhouette_squared e r H) as [P S]. rewrite <- E, pow2_sqrt in S by nra.
  pose proof (tangent_pos e r H). pose proof (discriminant_a_value x y e r H O) as D.
  assert (Z : hit_of_a.discriminant_a x y e r = 0) by (rewrite D; nra).
  pose proof (t_a_value x y e r H O ltac:(lra)) as T. rewrite Z, sqrt_0 in T.
  exists ((e ^ 2 - r ^ 2) / (e ^ 2 + 0)). set (t := (e ^ 2 - r ^ 2) / (e ^ 2 + 0)) in *.
  assert (I : t * e ^ 2 = e ^ 2 - r ^ 2) by (unfold t; field; nra).
  assert (J : (x ^ 2 + y ^ 2 + e ^ 2) * t = e ^ 2) by (apply (Rmult_eq_reg_r (e ^ 2)); nra).
  assert (K : e * (1 - t) = r ^ 2 / e) by (apply (Rmult_eq_reg_r e); [field_simplify; lra | lra]).
  repeat split; try assumption.
  - apply quadratic_a. nra.
  - intros s M. apply quadratic_a in M. assert (((x ^ 2 + y ^ 2 + e ^ 2) * s - e ^ 2) ^ 2 = 0) by nra.
    assert ((x ^ 2 + y ^ 2 + e ^ 2) * s = e ^ 2) by nra.
    apply (Rmult_eq_reg_l (x ^ 2 + y ^ 2 + e ^ 2)); [lra | nra].
  - unfold dot. nra.
  - intros phi Q. rewrite K in Q. apply (Rmult_eq_reg_l r); [rewrite <- Q; field; lra | lra].
Qed.

Lemma on_rim : sqrt ((15 / 16) ^ 2 + 0 ^ 2) = silhouette_of_a.rho_silhouette (5 / 4) (3 / 4).
Proof.
  unfold silhouette_of_a.rho_silhouette, silhouette_of_a.tangent_squared.
  replace ((15 / 16) ^ 2 + 0 ^ 2) with ((15 / 16) ^ 2) by ring. rewrite sqrt_pow2 by lra.
  replace ((5 / 4 - 3 / 4) * (5 / 4 + 3 / 4)) with (1 ^ 2) by field. rewrite sqrt_pow2 by lra. field.
Qed.

Theorem silhouette_of_a__tangent__point : exists x y e r,
  0 < r < e /\ off_axis x y e /\ sqrt (x ^ 2 + y ^ 2) = silhouette_of_a.rho_silhouette e r.
Proof.
  exists (15 / 16), 0, (5 / 4), (3 / 4). destruct rim as [O _]. repeat split; try lra; [exact O | apply on_rim].
Qed.

(* Not at height 0. *)
Theorem silhouette_of_a__tangent__false : ~ forall x y e r : R, 0 < r < e -> off_axis x y e ->
  sqrt (x ^ 2 + y ^ 2) = silhouette_of_a.rho_silhouette e r ->
  exists t, on_a t x y e r /\ e * (1 - t) = 0.
Proof.
  intros F. destruct rim as [O _]. destruct (F (15 / 16) 0 (5 / 4) (3 / 4)) as (t & M & Z);
    [lra | exact O | apply on_rim |]. unfold on_a, distance2 in M. nra.
Qed.

(* The point P(t) of A at polar angle phi is the near hit where cos phi >= R / e; on the rim, cos phi = R / e,
   the two hits are one. *)
Theorem visible_iff__visible (t x y e r phi : R) : 0 < r < e -> off_axis x y e -> on_a t x y e r ->
  e * (1 - t) = r * cos phi -> r / e <= cos phi ->
  hit_of_a.t_a x y e r = Finite t /\ (cos phi = r / e -> forall s, on_a s x y e r -> s = t).
Proof.
  intros H O M C L. assert (D : 0 <= hit_of_a.discriminant_a x y e r).
  { destruct (Rle_lt_dec 0 (hit_of_a.discriminant_a x y e r)) as [D | D]; [exact D |].
    destruct (proj2 (hit_of_a__misses x y e r H O D) t M). }
  destruct (t_a_near x y e r H O D) as (s & T & P & _ & S & N & F). pose proof (N t M) as G.
  assert (K : r <= e * cos phi) by (apply (Rmult_le_compat_l e) in L; [field_simplify in L |]; lra).
  pose proof M as Q. apply quadratic_a in Q.
  assert (A : t * ((x ^ 2 + y ^ 2 + e ^ 2) * t - e ^ 2) = r * (r - e * cos phi)) by nra.
  assert (B : (x ^ 2 + y ^ 2 + e ^ 2) * t <= e ^ 2) by nra.
  split; [rewrite T, (F t M B); reflexivity |].
  intros E u U. assert (Z : e * cos phi = r) by (rewrite E; field; lra). apply quadratic_a in U.
  assert (W : (x ^ 2 + y ^ 2 + e ^ 2) * t = e ^ 2) by nra.
  assert (V : ((x ^ 2 + y ^ 2 + e ^ 2) * u - e ^ 2) ^ 2 = 0) by nra.
  apply (Rmult_eq_reg_l (x ^ 2 + y ^ 2 + e ^ 2)); nra.
Qed.

Lemma point_visible : off_axis (15 / 16) 0 (5 / 4) /\ on_a (16 / 25) (15 / 16) 0 (5 / 4) (3 / 4) /\
  cos (acos (3 / 5)) = 3 / 5.
Proof. destruct rim as [O _]. repeat split; [exact O | unfold on_a, distance2; lra | apply cos_acos; lra]. Qed.

Theorem visible_iff__visible__point : exists t x y e r phi, 0 < r < e /\ off_axis x y e /\ on_a t x y e r /\
  e * (1 - t) = r * cos phi /\ r / e <= cos phi.
Proof.
  exists (16 / 25), (15 / 16), 0, (5 / 4), (3 / 4), (acos (3 / 5)). destruct point_visible as (O & M & C).
  rewrite C. repeat split; try lra; assumption.
Qed.

Lemma point_hidden : off_axis 1 0 4 /\ on_a 1 1 0 4 1 /\ on_a (15 / 17) 1 0 4 1.
Proof. repeat split; [apply off_axis_far | unfold on_a, distance2 | unfold on_a, distance2]; lra. Qed.

(* Not where cos phi >= 0. *)
Theorem visible_iff__visible__false : ~ forall t x y e r phi : R, 0 < r < e -> off_axis x y e -> on_a t x y e r ->
  e * (1 - t) = r * cos phi -> 0 <= cos phi -> hit_of_a.t_a x y e r = Finite t.
Proof.
  intros F. destruct point_hidden as (O & M & N). pose proof cos_PI2 as C.
  specialize (F 1 1 0 4 1 (PI / 2) ltac:(lra) O M ltac:(lra) ltac:(lra)).
  destruct (hit_of_a__near 1 0 4 1 ltac:(lra) O) as (t & T & _ & _ & _ & L).
  { rewrite discriminant_a_value by (lra || exact O). lra. }
  rewrite F in T. injection T as <-. specialize (L _ N). lra.
Qed.

(* The point P(t) of A lies behind the near hit, t > t_A, where cos phi < R / e. *)
Theorem visible_iff__hidden (t x y e r phi : R) : 0 < r < e -> off_axis x y e -> on_a t x y e r ->
  e * (1 - t) = r * cos phi -> cos phi < r / e -> Rbar_lt (hit_of_a.t_a x y e r) t.
Proof.
  intros H O M C L. assert (D : 0 <= hit_of_a.discriminant_a x y e r).
  { destruct (Rle_lt_dec 0 (hit_of_a.discriminant_a x y e r)) as [D | D]; [exact D |].
    destruct (proj2 (hit_of_a__misses x y e r H O D) t M). }
  destruct (t_a_near x y e r H O D) as (s & T & P & _ & S & N & _). rewrite T. simpl.
  destruct (Rle_lt_or_eq_dec _ _ (N t M)) as [G | <-]; [exact G | exfalso].
  assert (K : e * cos phi < r) by (apply (Rmult_lt_compat_l e) in L; [field_simplify in L |]; lra).
  rewrite t_a_value in T by assumption. apply Rbar_finite_eq in T.
  destruct (near_root (x ^ 2 + y ^ 2 + e ^ 2) (e ^ 2) (e ^ 2 - r ^ 2) (hit_of_a.discriminant_a x y e r))
    as (_ & A & _); try nra. { apply discriminant_a_value; assumption. }
  rewrite T in A. pose proof (sqrt_pos (hit_of_a.discriminant_a x y e r)). apply quadratic_a in M. nra.
Qed.

Theorem visible_iff__hidden__point : exists t x y e r phi, 0 < r < e /\ off_axis x y e /\ on_a t x y e r /\
  e * (1 - t) = r * cos phi /\ cos phi < r / e.
Proof.
  exists 1, 1, 0, 4, 1, (PI / 2). destruct point_hidden as (O & M & _). rewrite cos_PI2.
  repeat split; try lra; assumption.
Qed.

(* Not on the rim. *)
Theorem visible_iff__hidden__false : ~ forall t x y e r phi : R, 0 < r < e -> off_axis x y e -> on_a t x y e r ->
  e * (1 - t) = r * cos phi -> cos phi <= r / e -> Rbar_lt (hit_of_a.t_a x y e r) t.
Proof.
  intros F. destruct point_visible as (O & M & C).
  specialize (F (16 / 25) (15 / 16) 0 (5 / 4) (3 / 4) (acos (3 / 5)) ltac:(lra) O M). rewrite C in F. specialize (F ltac:(lra) ltac:(lra)).
  destruct (visible_iff__visible (16 / 25) (15 / 16) 0 (5 / 4) (3 / 4) (acos (3 / 5)) ltac:(lra) O M) as [T _]; try (rewrite C; lra).
  rewrite T in F. simpl in F. lra.
Qed.

(* The constant of B's quadratic: the eye is outside B where it is positive. *)
Definition c_of_b (e cx cy cz r : R) := dot cx cy (cz - e) cx cy (cz - e) - r ^ 2.

(* |P(t) - C|^2 - R_2^2 = |D|^2 t^2 - 2 b t + c and d = b^2 - |D|^2 c, with D = (x, y, -e), b = -D.(E - C). *)
Theorem hit_of_b__quadratic (t x y e cx cy cz r : R) :
  hit_of_b.toward_b x y e cx cy cz = - dot x y (- e) (- cx) (- cy) (e - cz) /\
  distance2 t x y e cx cy cz - r ^ 2 =
    dot x y (- e) x y (- e) * t ^ 2 - 2 * hit_of_b.toward_b x y e cx cy cz * t + c_of_b e cx cy cz r /\
  hit_of_b.discriminant_b x y e cx cy cz r =
    hit_of_b.toward_b x y e cx cy cz ^ 2 - dot x y (- e) x y (- e) * c_of_b e cx cy cz r.
Proof.
  unfold distance2, hit_of_b.discriminant_b, hit_of_b.toward_b, hit_of_b.distance, c_of_b, dot.
  repeat split; ring.
Qed.

(* Not with the seed's constant, |C|^2 - R_2^2. *)
Theorem hit_of_b__quadratic__false : ~ forall t x y e cx cy cz r : R, distance2 t x y e cx cy cz - r ^ 2 =
  dot x y (- e) x y (- e) * t ^ 2 - 2 * hit_of_b.toward_b x y e cx cy cz * t + (dot cx cy cz cx cy cz - r ^ 2).
Proof.
  intros F. specialize (F 0 0 0 1 0 0 0 0). unfold distance2, hit_of_b.toward_b, hit_of_b.distance, dot in F. lra.
Qed.

Lemma quadratic_b t x y e cx cy cz r : on_b t x y e cx cy cz r <->
  dot x y (- e) x y (- e) * t ^ 2 - 2 * hit_of_b.toward_b x y e cx cy cz * t + c_of_b e cx cy cz r = 0.
Proof. destruct (hit_of_b__quadratic t x y e cx cy cz r) as (_ & Q & _). unfold on_b. split; intros; lra. Qed.

(* If c > 0, d >= 0 and b > 0, then t = c / (b + sqrt d) is the least root of |P(t) - C|^2 = R_2^2, and t > 0. *)
Theorem hit_of_b__near (x y e cx cy cz r on : R) : 0 < on -> 0 < c_of_b e cx cy cz r ->
  0 <= hit_of_b.discriminant_b x y e cx cy cz r -> 0 < hit_of_b.toward_b x y e cx cy cz ->
  exists t, hit_of_b.t_b x y e cx cy cz r on = Finite t /\
  t = c_of_b e cx cy cz r
      / (hit_of_b.toward_b x y e cx cy cz + sqrt (hit_of_b.discriminant_b x y e cx cy cz r)) /\
  0 < t /\ on_b t x y e cx cy cz r /\ forall s, on_b s x y e cx cy cz r -> t <= s.
Proof.
  intros On C D B. destruct (hit_of_b__quadratic 0 x y e cx cy cz r) as (_ & _ & Q).
  set (b := hit_of_b.toward_b x y e cx cy cz) in *. set (d := hit_of_b.discriminant_b x y e cx cy cz r) in *.
  assert (A : 0 < dot x y (- e) x y (- e)).
  { destruct (Rle_lt_dec (dot x y (- e) x y (- e)) 0) as [N | P]; [exfalso | exact P]. unfold dot in N.
    assert (x = 0 /\ y = 0 /\ e = 0) as (-> & -> & ->) by (repeat split; nra).
    unfold b, hit_of_b.toward_b in B. lra. }
  destruct (near_root _ b _ d A B C Q D) as (P & _ & S & N & _).
  eexists. split; [| split; [reflexivity | split; [exact P | split]]].
  - unfold hit_of_b.t_b, hit_of_b.root_b. fold b. fold d. rewrite Rmax_right by exact D.
    destruct both as [_ | [[N1 | N1] | N1]]; [do 2 f_equal; [unfold c_of_b, dot, hit_of_b.distance |]; ring | | |]; lra.
  - apply quadratic_b. exact S.
  - intros s M. apply N, quadratic_b. exact M.
Qed.
