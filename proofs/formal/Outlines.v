(* Sphere B: where rays hit it, and its silhouette, which is also a shadow's outline, seen from the light. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Camera Claim.
From Formal Require Statements.
Open Scope R_scope.

Ltac by_squares := repeat match goal with |- context [?a ^ 2] => lazymatch goal with H : 0 <= a ^ 2 |- _ => fail | _ => pose proof (pow2_ge_0 a) end
  end; lra.
Ltac root_of_b a d b t q := match goal with D : d >= 0, B : b > 0, T := ?n / (q + b) |- _ => set (c := n) in *;
  assert (Q : d = b ^ 2 - a * c) by (lines; ring); pose proof (Rmax_l 0 d) as M; assert (RQ : q = sqrt d) by (unfold q; rewrite Rmax_right by lra;
    reflexivity);
  generalize (root_by_conjugate a b c d B Q (Rge_le _ _ D)); cbv zeta; rewrite <- RQ, (Rplus_comm b q); fold t; intros (Q0 & QQ & TM & TA & TQ);
    assert (QB : q + b > 0) by lra end.

Theorem hit_of_b__quadratic : Statements.hit_of_b__quadratic.
Proof. claim. Qed.
Theorem hit_of_b__behind : Statements.hit_of_b__behind.
Proof. claim. Qed.
Theorem hit_of_b__solves : Statements.hit_of_b__solves.
Proof.
  red. intros. root_of_b (eye ^ 2 + x ^ 2 + y ^ 2) discriminant_b toward_b t_b root_b. assert (c > 0) by (unfold c, distance; lra).
  assert (t_b > 0) by (unfold t_b; apply Rdiv_lt_0_compat; lra).
  assert ((eye * (1 - t_b) - ball_center_z) ^ 2 + (t_b * y - ball_center_y) ^ 2 + (t_b * x - ball_center_x) ^ 2 + 0 = ball_radius ^ 2).
  { apply Rminus_diag_uniq. etransitivity; [| exact TQ]. unfold toward_b, c, distance. ring. }
  assert (hits_b = 1) by (unfold hits_b; destruct both; lra). lra.
Qed.

Theorem hit_of_b__outward : Statements.hit_of_b__outward.
Proof.
  red. intros. root_of_b ray_length_squared discriminant_b toward_b t_b root_b.
  assert (c > 0) by (unfold c, distance; lra). assert (A : ray_length_squared > 0).
  { assert (discriminant_b <= ball_radius ^ 2 * ray_length_squared) by (unfold discriminant_b, ray_length_squared; by_squares).
    assert (0 <= ray_length_squared) by (unfold ray_length_squared; by_squares). nra. }
  assert (R : root_b = toward_b - ray_length_squared * t_b) by lra.
  assert (X : radius_vector_x = t_b * x - ball_center_x /\ radius_vector_y = t_b * y - ball_center_y /\ radius_vector_z = eye * (1 - t_b) -
    ball_center_z) by (unfold radius_vector_x, radius_vector_y, radius_vector_z; rewrite R; clearbody t_b root_b; clear - A; lines; repeat split;
      field; lra).
      destruct X as (X & Y & Z).
  assert (S : radius_vector_x ^ 2 + radius_vector_y ^ 2 + radius_vector_z ^ 2 = ball_radius ^ 2).
  { rewrite X, Y, Z. apply Rminus_diag_uniq. etransitivity; [| exact TQ]. unfold ray_length_squared, toward_b, c, distance. ring. }
  assert (L : radius_length = ball_radius) by (unfold radius_length; rewrite S; apply sqrt_pow2; lra).
  assert (N : ball_radius * normal_x = t_b * x - ball_center_x /\ ball_radius * normal_y = t_b * y - ball_center_y /\ ball_radius * normal_z = eye *
    (1 - t_b) - ball_center_z) by (unfold normal_x, normal_y, normal_z; rewrite L, X, Y, Z; repeat split; field; lra). destruct N as (NX & NY & NZ).
  assert (0 <= ball_radius ^ 2) by apply pow2_ge_0. each ltac:(first [assumption | lra | apply Rgt_not_eq; lra | unfold point_x, point_y, point_z;
    lra]).
Qed.

Definition on_b (t x y e cx cy cz r : R) := distance2 t x y e cx cy cz = r ^ 2.
(* The constant of B's quadratic: the eye is outside B where it is positive. *)
Definition c_of_b (e cx cy cz r : R) := dot3 cx cy (cz - e) cx cy (cz - e) - r ^ 2.

(* |P(t) - C|^2 - R_2^2 = |D|^2 t^2 - 2 b t + c and d = b^2 - |D|^2 c, with D = (x, y, -e), b = -D.(E - C). *)
Lemma quadratic_of_b t x y e cx cy cz r : hit_of_b.toward_b x y e cx cy cz = - dot3 x y (- e) (- cx) (- cy) (e - cz) /\ distance2 t x y e cx cy cz
  - r ^ 2 = dot3 x y (- e) x y (- e) * t ^ 2 - 2 * hit_of_b.toward_b x y e cx cy cz * t + c_of_b e cx cy cz r /\ hit_of_b.discriminant_b x y e cx
  cy cz r = hit_of_b.toward_b x y e cx cy cz ^ 2 - dot3 x y (- e) x y (- e) * c_of_b e cx cy cz r.
Proof. unfold distance2; hit_of_b.lines; unfold c_of_b, dot3. lra. Qed.

Lemma quadratic_b t x y e cx cy cz r : on_b t x y e cx cy cz r <->
  dot3 x y (- e) x y (- e) * t ^ 2 - 2 * hit_of_b.toward_b x y e cx cy cz * t + c_of_b e cx cy cz r = 0.
Proof. destruct (quadratic_of_b t x y e cx cy cz r). unfold on_b. lra. Qed.

(* If c > 0, d >= 0 and b > 0, then t = c / (b + sqrt d) is the least root of |P(t) - C|^2 = R_2^2, and t > 0. *)
Theorem hit_of_b__first_hit x y e cx cy cz r on : 0 < on -> 0 < c_of_b e cx cy cz r -> 0 <= hit_of_b.discriminant_b x y e cx cy cz r -> 0 <
  hit_of_b.toward_b x y e cx cy cz -> exists t, hit_of_b.t_b x y e cx cy cz r on = Finite t /\ t = c_of_b e cx cy cz r / (hit_of_b.toward_b x y e
  cx cy cz + sqrt (hit_of_b.discriminant_b x y e cx cy cz r)) /\ 0 < t /\ on_b t x y e cx cy cz r /\ forall s, on_b s x y e cx cy cz r -> t <= s.
Proof.
  intros On C D B. destruct (quadratic_of_b 0 x y e cx cy cz r) as (_ & _ & Q).
  set (b := hit_of_b.toward_b x y e cx cy cz) in *. set (d := hit_of_b.discriminant_b x y e cx cy cz r) in *.
  assert (A : 0 < dot3 x y (- e) x y (- e)).
  { destruct (Rle_lt_dec (dot3 x y (- e) x y (- e)) 0) as [N | P]; auto. unfold dot3 in N.
    assert (x = 0 /\ y = 0 /\ e = 0) as (-> & -> & ->) by (repeat split; nra).
    unfold b, hit_of_b.toward_b in B. lra. }
  destruct (near_root _ b _ d A B C Q D) as (P & _ & S & N).
  eexists. split; [| split; [reflexivity | split; [nra | split]]].
  - unfold hit_of_b.t_b, hit_of_b.root_b. fold b. fold d. rewrite Rmax_right by lra.
    destruct both as [_ | [[N1 | N1] | N1]]; [do 2 f_equal; [unfold c_of_b, dot3, hit_of_b.distance |]; ring | | |]; lra.
  - apply quadratic_b. exact S.
  - intros s M. apply N, quadratic_b. exact M.
Qed.

Lemma point_b : hit_of_b.toward_b 0 0 4 0 0 0 = 16 /\ hit_of_b.discriminant_b 0 0 4 0 0 0 1 = 16 /\
  c_of_b 4 0 0 0 1 = 15.
Proof. hit_of_b.lines; unfold c_of_b, dot3. lra. Qed.

Theorem hit_of_b__first_hit__point : exists x y e cx cy cz r on, 0 < on /\ 0 < c_of_b e cx cy cz r /\
  0 <= hit_of_b.discriminant_b x y e cx cy cz r /\ 0 < hit_of_b.toward_b x y e cx cy cz.
Proof. exists 0, 0, 4, 0, 0, 0, 1, 1. destruct point_b. lra. Qed.

(* Not where the eye is inside B. *)
Theorem hit_of_b__first_hit__false : ~ forall x y e cx cy cz r on, 0 < on -> 0 <= hit_of_b.discriminant_b x y e cx cy cz r -> 0 <
  hit_of_b.toward_b x y e cx cy cz -> exists t, hit_of_b.t_b x y e cx cy cz r on = Finite t /\ 0 < t.
Proof.
  intros F. destruct (F 0 0 4 0 0 3 2 1) as (t & T & P); [lra | | |].
  1, 2: hit_of_b.lines; lra.
  unfold hit_of_b.t_b in T. destruct both; [| discriminate]. apply Rbar_finite_eq in T. subst t.
  set (q := hit_of_b.root_b 0 0 4 0 0 3 2) in P. assert (0 <= q) by apply sqrt_pos.
  unfold hit_of_b.distance in P.
  match type of P with 0 < ?n / ?m => assert (0 < m); pose proof (Rdiv_lt_0_compat (- n) m); nra end.
Qed.

Theorem silhouette_of_b__conic : Statements.silhouette_of_b__conic.
Proof. claim. Qed.
Theorem silhouette_of_b__ellipse : Statements.silhouette_of_b__ellipse.
Proof. claim. Qed.
Theorem silhouette_of_b__parabola : Statements.silhouette_of_b__parabola.
Proof. claim. Qed.
Theorem silhouette_of_b__hyperbola : Statements.silhouette_of_b__hyperbola.
Proof. claim. Qed.
Theorem silhouette_of_b__branch : Statements.silhouette_of_b__branch.
Proof.
  red. intros. set (c := ball_center_x ^ 2 + ball_center_y ^ 2 + _ ^ 2 - ball_radius ^ 2).
  assert (Q : toward_b ^ 2 = c * ((- eye) * (- eye) + x * x + y * y)) by (match goal with D : discriminant_b = 0 |- _ => rewrite <- (Rplus_0_l (c *
    _)), <- D end; lines; ring).
  assert (- eye * - eye + x * x + y * y > 0) by nra. assert (c > 0) by (unfold c; lra).
  nra.
Qed.

(* What both sides of the eye have in common: h is the eye's height above the centre, c >= s, and b = q + e h. *)
Lemma apart e h r s q i c : e > 0 -> h ^ 2 >= r ^ 2 -> c = h ^ 2 + s - r ^ 2 -> c > 0 -> i >= 0 -> s * i >= q ^ 2 -> (h * e + q) ^ 2 >= c * (e ^ 2
  + i) -> i * (c - s) >= 0 /\ e ^ 2 > 0 /\ e ^ 2 * c > 0 /\ c * (e ^ 2 + i) > q ^ 2 /\ h * e * (2 * (h * e + q) - h * e) > 0.
Proof. intros E H C P I Q B. assert (i * (c - s) >= 0) by nra. assert (e ^ 2 > 0) by nra. assert (e ^ 2 * c > 0) by nra. lra. Qed.
Ltac of_outline := red; intros; match goal with E : ?e > 0, R : ?r > 0, H : ?d' >= ?r, B : (?d * ?e + ?cx * ?x + ?cy * ?y) ^ 2 >= ?c * _ |- _ =>
  set (q := cx * x + cy * y); assert (D : d' > 0) by lra; assert (DE : d' * e > 0) by nra; assert (I : x ^ 2 + y ^ 2 >= 0) by nra;
  assert (DR : (d' - r) * (r + d') >= 0) by nra;
  assert (Q : (cx ^ 2 + cy ^ 2) * (x ^ 2 + y ^ 2) >= q ^ 2) by (pose proof (pow2_ge_0 (x * cy - y * cx)); unfold q; lra);
  destruct (apart e d r (cx ^ 2 + cy ^ 2) q (x ^ 2 + y ^ 2) c) as (A1 & A2 & A3 & A4 & A5); try (assumption || unfold q; lra);
  replace (d * e + cx * x + cy * y) with (d * e + q) in * by (unfold q; ring);
  first [assert (2 * (d * e + q) - d * e > 0) by nra | assert (d * e - 2 * (d * e + q) > 0) by nra] end;
  each ltac:(first [assumption | lra]).
Theorem silhouette_of_b__all_seen : Statements.silhouette_of_b__all_seen.
Proof. of_outline. Qed.
Theorem silhouette_of_b__none_seen : Statements.silhouette_of_b__none_seen.
Proof. of_outline. Qed.

Lemma seen_of_b x y e cx cy cz r : 0 < e -> 0 < r -> 0 < c_of_b e cx cy cz r -> r <= e - cz ->
  0 <= hit_of_b.discriminant_b x y e cx cy cz r -> 0 < hit_of_b.toward_b x y e cx cy cz.
Proof.
  unfold c_of_b, dot3; hit_of_b.lines. intros.
  destruct (silhouette_of_b__all_seen cx cy r (e - cz) e x y); lra.
Qed.

(* A quadratic that is negative somewhere and rises has a root on either side. *)
Lemma two_roots a b c s : 0 < a -> a * s ^ 2 + 2 * b * s + c < 0 ->
  exists s1 s2, s1 < s < s2 /\ a * s1 ^ 2 + 2 * b * s1 + c = 0 /\ a * s2 ^ 2 + 2 * b * s2 + c = 0.
Proof.
  intros Ha N. assert (D : (a * s + b) ^ 2 < b ^ 2 - a * c) by nra.
  assert (P : 0 <= b ^ 2 - a * c) by (pose proof (pow2_ge_0 (a * s + b)); lra).
  pose proof (sqrt_pos (b ^ 2 - a * c)). pose proof (sqrt_sqrt _ P) as Q. set (q := sqrt (b ^ 2 - a * c)) in *.
  assert (- q < a * s + b < q) by (split; nra).
  assert (R : forall t, t = q \/ t = - q -> a * ((t - b) / a) ^ 2 + 2 * b * ((t - b) / a) + c = 0).
  { intros t T. replace (_ + _) with ((t * t - (b ^ 2 - a * c)) / a) by (field; lra). rewrite <- Q. destruct T as [-> | ->]; field; lra. }
  exists ((- q - b) / a), ((q - b) / a). repeat split; try (apply R; auto).
  - apply (Rmult_lt_reg_l a); [lra |]. field_simplify; lra.
  - apply (Rmult_lt_reg_l a); auto. field_simplify; lra.
Qed.

(* If |H| >= R_2 the silhouette has a point, so that what is called an ellipse is one: the discriminant is positive at
   the image of B's centre, and has a root on either side along any line (p, q) that leaves the conic. *)
Theorem silhouette_of_b__real e cx cy cz r : 0 < e -> 0 < r -> 0 < c_of_b e cx cy cz r -> r ^ 2 <= (e - cz) ^ 2 -> exists x y,
  hit_of_b.discriminant_b x y e cx cy cz r = 0.
Proof.
  intros. set (h := e - cz) in *. set (c := c_of_b e cx cy cz r) in *. set (w := cx ^ 2 + cy ^ 2).
  assert (W : c = w + h ^ 2 - r ^ 2) by (unfold c, c_of_b, dot3, w, h; ring).
  assert (N : h <> 0) by nra.
  assert (L : forall p q, (p * cx + q * cy) ^ 2 < c * (p ^ 2 + q ^ 2) -> exists x y, hit_of_b.discriminant_b x y e cx cy cz r = 0).
  { intros p q G. set (m := p * cx + q * cy) in *. set (x s := e * cx / h + s * p). set (y s := e * cy / h + s * q).
    set (bend := c * (p ^ 2 + q ^ 2) - m ^ 2). set (slope := e / h * m * (c - w - h ^ 2)). set (height := (e / h) ^ 2 * (w + h ^ 2) * r ^ 2).
    assert (V : forall s, hit_of_b.discriminant_b (x s) (y s) e cx cy cz r = - (bend * s ^ 2 + 2 * slope * s + - height)).
    { intro s. unfold bend, slope, height. rewrite W.
      hit_of_b.lines; unfold x, y, m, w. fold h. field. lra. }
    assert (0 < height).
    { assert (0 < (e / h) ^ 2) by (apply pow2_gt_0, Rmult_integral_contrapositive_currified; [lra | apply Rinv_neq_0_compat, N]).
      apply Rmult_lt_0_compat; nra. }
    destruct (two_roots bend slope (- height) 0) as (s & _ & _ & S & _); [unfold bend; lra | lra |]. exists (x s), (y s). rewrite V, S. ring. }
  destruct (Rlt_dec (cx ^ 2) c); [apply (L 1 0) | apply (L 0 1)]; unfold w in W; lra.
Qed.

Theorem silhouette_of_b__real__point : exists e cx cy cz r, 0 < e /\ 0 < r /\ 0 < c_of_b e cx cy cz r /\ r ^ 2 <= (e - cz) ^ 2.
Proof. exists 4, 0, 0, 0, 1. destruct point_b. lra. Qed.

(* Not with the eye on B. *)
Theorem silhouette_of_b__real__false : ~ forall e cx cy cz r, 0 < e -> 0 < r -> r ^ 2 <= (e - cz) ^ 2 -> exists x y, hit_of_b.discriminant_b x y e
  cx cy cz r = 0.
Proof.
  intros F. destruct (F 4 0 0 3 1) as (x & y & D); try lra. unfold hit_of_b.discriminant_b, hit_of_b.distance in D. lra.
Qed.

(* If |H| < R_2 it has points with b > 0 and points with b < 0. *)
Theorem silhouette_of_b__two_branches e cx cy cz r : 0 < e -> 0 < c_of_b e cx cy cz r -> (e - cz) ^ 2 < r ^ 2 -> (exists x y,
  hit_of_b.discriminant_b x y e cx cy cz r = 0 /\ 0 < hit_of_b.toward_b x y e cx cy cz) /\ (exists x y, hit_of_b.discriminant_b x y e cx cy cz r =
  0 /\ hit_of_b.toward_b x y e cx cy cz < 0).
Proof.
  intros.
  set (w := cx ^ 2 + cy ^ 2). assert (c_of_b e cx cy cz r = w + ((e - cz) ^ 2 - r ^ 2)) by (unfold c_of_b, dot3, w; ring).
  set (c := c_of_b e cx cy cz r) in *. set (h := e - cz) in *.
  assert (T : forall s, hit_of_b.toward_b (s * cx) (s * cy) e cx cy cz = s * w + e * h) by (intros; hit_of_b.lines; unfold w, h; ring).
  assert (V : forall s, hit_of_b.discriminant_b (s * cx) (s * cy) e cx cy cz r = (w ^ 2 - c * w) * s ^ 2 + 2 * (w * e * h) * s + e ^ 2 * (h ^ 2 - c)).
  { intros s. destruct (quadratic_of_b 0 (s * cx) (s * cy) e cx cy cz r) as (_ & _ & ->). rewrite T. fold c.
    unfold dot3, w. ring. }
  assert (P : 0 < w) by lra.
  destruct (two_roots (w ^ 2 - c * w) (w * e * h) (e ^ 2 * (h ^ 2 - c)) (- (e * h) / w)) as (s1 & s2 & O & R1 & R2).
  - nra.
  - replace (_ + _) with (- c * e ^ 2 * (h ^ 2 + w) / w) by (field; lra).
    assert (0 < c * e ^ 2 * (h ^ 2 + w) / w); [| lra].
    apply Rdiv_lt_0_compat; auto. repeat apply Rmult_lt_0_compat; nra.
  - assert (w * (- (e * h) / w) = - (e * h)) by (field; lra).
    split; [exists (s2 * cx), (s2 * cy) | exists (s1 * cx), (s1 * cy)]; rewrite T, V; split; try assumption; nra.
Qed.

Theorem silhouette_of_b__two_branches__point : exists e cx cy cz r, 0 < e /\ 0 < c_of_b e cx cy cz r /\ (e - cz) ^ 2 < r ^ 2.
Proof. exists 3, 2, 0, 3, 1. unfold c_of_b, dot3. lra. Qed.

(* Not if |H| = R_2. *)
Theorem silhouette_of_b__two_branches__false : ~ forall e cx cy cz r, 0 < e -> 0 < c_of_b e cx cy cz r -> (e - cz) ^ 2 <= r ^ 2 -> exists x y,
  hit_of_b.discriminant_b x y e cx cy cz r = 0 /\ hit_of_b.toward_b x y e cx cy cz < 0.
Proof.
  intros F. specialize (F 4 2 0 3 1). unfold c_of_b, dot3 in F. destruct F as (x & y & D & B); try lra.
  unfold hit_of_b.discriminant_b, hit_of_b.toward_b, hit_of_b.distance in *. nra.
Qed.

(* A ray meets B in front of the eye exactly if d >= 0 and b > 0: so the silhouette is seen where b > 0. *)
Theorem silhouette_of_b__meets x y e cx cy cz r : 0 < c_of_b e cx cy cz r -> (exists t, 0 < t /\ on_b t x y e cx cy cz r) <-> 0 <=
  hit_of_b.discriminant_b x y e cx cy cz r /\ 0 < hit_of_b.toward_b x y e cx cy cz.
Proof.
  intros C. split.
  - intros (t & P & M). apply quadratic_b in M.
    destruct (quadratic_of_b t x y e cx cy cz r) as (_ & _ & ->). set (a := dot3 x y (- e) x y (- e)) in *.
    set (b := hit_of_b.toward_b x y e cx cy cz) in *. set (c := c_of_b e cx cy cz r) in *.
    assert (A : 0 <= a * t ^ 2) by (apply Rmult_le_pos; [unfold a, dot3 |]; nra). split.
    + replace (_ - _) with ((a * t - b) ^ 2 - a * (a * t ^ 2 - 2 * b * t + c)) by ring.
      rewrite M. pose proof (pow2_ge_0 (a * t - b)). lra.
    + nra.
  - intros [D B]. destruct (hit_of_b__first_hit x y e cx cy cz r 1 ltac:(lra) C D B) as (t & _ & _ & P & M & _).
    exists t. auto.
Qed.

Theorem silhouette_of_b__meets__point : exists e cx cy cz r, 0 < c_of_b e cx cy cz r.
Proof. exists 4, 0, 0, 0, 1. destruct point_b. lra. Qed.

(* Not if d >= 0 alone. *)
Theorem silhouette_of_b__meets__false : ~ forall x y e cx cy cz r, 0 < c_of_b e cx cy cz r -> 0 <= hit_of_b.discriminant_b x y e cx cy cz r ->
  exists t, 0 < t /\ on_b t x y e cx cy cz r.
Proof.
  intros F. destruct (F 0 0 4 0 0 8 1) as (t & P & M).
  1, 2: unfold c_of_b; hit_of_b.lines; unfold dot3; lra.
  unfold on_b, distance2 in M. nra.
Qed.

