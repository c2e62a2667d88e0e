(* The claims about sphere A: where rays hit it, its silhouette, and what of it is visible. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Camera Claim.
From Formal Require Statements.
Open Scope R_scope.

(* What a ray off the axis, and the program's lines for it, have in common: all about squares. *)
Lemma lines_of_a (x y e r : R) : e > 0 -> r > 0 -> e > r -> hit_of_a.rho_raw x y >= tiny * e ->
  let tangent := hit_of_a.tangent_squared e r in let edge := hit_of_a.rho_silhouette e r in let rho := hit_of_a.rho x y e in
  0 < r < e /\ off_axis x y e /\ tangent = e ^ 2 - r ^ 2 /\ tangent > 0 /\ edge > 0 /\ edge ^ 2 * tangent = e ^ 2 * r ^ 2 /\
  rho > 0 /\ rho ^ 2 = x ^ 2 + y ^ 2 /\ hit_of_a.discriminant_a x y e r = e ^ 4 - tangent * (e ^ 2 + rho ^ 2).
Proof.
  intros E R G O tangent edge rho. assert (H : 0 < r < e) by lra. apply Rge_le in O. destruct (rho_silhouette_squared e r H) as [P S].
  assert (T : tangent = e ^ 2 - r ^ 2) by (unfold tangent, hit_of_a.tangent_squared; ring).
  assert (Q : rho = sqrt (x ^ 2 + y ^ 2)) by exact (rho_a x y e O). assert (Z : 0 < rho) by (rewrite Q; apply sqrt_lt_R0, (off_axis_pos x y e E O)).
  rewrite (discriminant_a_value x y e r H O), T. unfold rho at 2 3. rewrite (rho_a_squared x y e O).
  repeat split; try lra; try exact O; try nra; try exact P. exact S.
Qed.

Lemma hit_a (x y e r : R) : 0 < r < e -> off_axis x y e -> hit_of_a.discriminant_a x y e r >= 0 ->
  let d := hit_of_a.discriminant_a x y e r in let root := hit_of_a.root_a x y e r in
  Rmax 0 d >= 0 /\ (d >= 0 -> e ^ 2 + root <> 0) /\ is_finite (hit_of_a.t_a x y e r) /\ root >= 0 /\ root ^ 2 = d /\
  exists t, real (hit_of_a.t_a x y e r) = t /\ 0 < t < 1 /\ t * (x ^ 2 + y ^ 2 + e ^ 2) = e ^ 2 - root /\ t * (e ^ 2 + root) = e ^ 2 - r ^ 2 /\
  on_a t x y e r /\ (forall s, on_a s x y e r -> t <= s).
Proof.
  intros H O D d root. apply Rge_le in D. destruct (t_a_near x y e r H O D) as (t & T & P & L & A & N).
  assert (M : root = sqrt d) by (unfold root, hit_of_a.root_a; rewrite Rmax_right by exact D; reflexivity).
  pose proof (sqrt_pos d). pose proof (pow2_sqrt d D). rewrite <- M in *. assert (V : t = (e ^ 2 - r ^ 2) / (e ^ 2 + root)) by (rewrite M; generalize
    (t_a_value x y e r H O D); rewrite T; intro V; apply (f_equal real) in V; exact V).
  pose proof (Rmax_l 0 d). assert (e ^ 2 + root > 0) by nra.
  destruct (near_root (x ^ 2 + y ^ 2 + e ^ 2) (e ^ 2) (e ^ 2 - r ^ 2) d) as (_ & I & _); try nra. { exact (discriminant_a_value x y e r H O). }
  rewrite <- M, <- V in I. rewrite T. unfold is_finite. repeat split; try lra. exists t. repeat split; try lra; try exact A; try exact N. rewrite V. field. lra.
Qed.

(* The same of a claim's lines, by their names there. *)
Ltac of_a := red; intros; match goal with rho := if Rle_dec _ ?raw then ?raw else 0, tangent := (?eye - ?radius) * (?eye + ?radius), edge := ?eye *
  ?radius / _, d := _ * (_ - _) * _, raw := sqrt (?x ^ 2 + ?y ^ 2), R : _ >= _ * ?eye |- _ => change (hit_of_a.rho_raw x y >= tiny * eye) in R;
  destruct (lines_of_a x y eye radius ltac:(assumption) ltac:(assumption) ltac:(assumption) R) as (HA & O & T & TP & EP & ES & RP & RS & DV);
  change (hit_of_a.tangent_squared eye radius) with tangent in *; change (hit_of_a.rho x y eye) with rho in *;
  change (hit_of_a.rho_silhouette eye radius) with edge in *; change (hit_of_a.discriminant_a x y eye radius) with d in * end.
Ltac hit := of_a; match goal with A : 0 < ?radius < ?eye, O : off_axis ?x ?y ?eye, D : ?d >= 0, root := sqrt (Rmax 0 ?d), t := _ / (?eye ^ 2 + _) |- _ =>
  destruct (hit_a x y eye radius A O D) as (M0 & N0 & FT & R0 & RR & t1 & _ & TB & TM & TR & TA & TN);
  change (hit_of_a.root_a x y eye radius) with root in *; change (hit_of_a.discriminant_a x y eye radius) with d in *;
  unfold on_a, distance2 in TA; assert (PR : eye ^ 2 + root > 0) by nra;
  assert (TV : t = t1) by (apply (Rmult_eq_reg_r (eye ^ 2 + root)); [unfold t, Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r |]; lra);
  rewrite TV end.
Ltac decided := match goal with |- ?hits = _ => unfold hits; match goal with |- context [if ?c then _ else _] => destruct c; lra end end.
Ltac settled := first [assumption | lra | nra | apply Rgt_not_eq; lra | decided].

Theorem hit_of_a__solves : Statements.hit_of_a__solves.
Proof. hit. each settled. Qed.
Theorem hit_of_a__near : Statements.hit_of_a__near.
Proof.
  hit.
  assert (L : t1 <= t) by (apply TN; unfold on_a, distance2; lra). each settled.
Qed.
Theorem hit_of_a__misses : Statements.hit_of_a__misses.
Proof.
  of_a.
  assert (G : (eye ^ 2 + rho ^ 2) * (eye ^ 2 * (1 - t) ^ 2 + t ^ 2 * x ^ 2 + t ^ 2 * y ^ 2 - radius ^ 2) =
    ((eye ^ 2 + rho ^ 2) * t - eye ^ 2) ^ 2 - discriminant_a) by (rewrite DV, RS, T; ring).
  pose proof (pow2_ge_0 ((eye ^ 2 + rho ^ 2) * t - eye ^ 2)). assert (eye ^ 2 + rho ^ 2 > 0) by nra. each settled.
Qed.
Theorem silhouette_of_a__quadratic : Statements.silhouette_of_a__quadratic.
Proof. of_a. each settled. Qed.
Theorem silhouette_of_a__inside : Statements.silhouette_of_a__inside.
Proof. of_a. each settled. Qed.
Theorem silhouette_of_a__only_inside : Statements.silhouette_of_a__only_inside.
Proof.
  of_a.
  assert (Q : discriminant_a = tangent_squared * (rho_silhouette ^ 2 - rho ^ 2)) by (unfold discriminant_a; ring).
  assert (rho ^ 2 <= rho_silhouette ^ 2) by nra. each settled.
Qed.
Theorem silhouette_of_a__in_front : Statements.silhouette_of_a__in_front.
Proof. hit. each settled. Qed.
Theorem silhouette_of_a__tangent : Statements.silhouette_of_a__tangent.
Proof.
  of_a.
  assert (E3 : rho ^ 2 = rho_silhouette ^ 2) by (apply (Rmult_eq_reg_r tangent_squared); [rewrite ES, RS, T | ]; lra).
  set (s := 1 - radius ^ 2 / eye ^ 2) in *. assert (Q : eye ^ 2 * (1 - s) = radius ^ 2) by (unfold s; field; lra).
  assert (E2 : (x ^ 2 + y ^ 2) * s = radius ^ 2) by (unfold s; field_simplify_eq; lra). assert (R4 : radius ^ 4 / eye ^ 2 = radius ^ 2 * (1 - s)) by
    (unfold s; field; lra).
  assert (x ^ 2 * s ^ 2 + y ^ 2 * s ^ 2 + radius ^ 4 / eye ^ 2 = radius ^ 2) by (transitivity ((x ^ 2 + y ^ 2) * s * s + radius ^ 4 / eye ^ 2); [ring
    | rewrite E2, R4; ring]).
  assert (eye * (1 - s) * eye * (1 - s) + x * s * x * s + y * s * y * s = radius ^ 2) by (transitivity (eye ^ 2 * (1 - s) * (1 - s) + (x ^ 2 + y ^ 2)
    * s * s); [ring | rewrite Q, E2; ring]).
  assert (- eye * eye * (1 - s) + x * x * s + y * y * s = 0) by (transitivity ((x ^ 2 + y ^ 2) * s - eye ^ 2 * (1 - s)); [ring | rewrite E2, Q; ring]).
  each settled.
Qed.
Ltac from_the_point := match goal with RS : ?rho ^ 2 = ?x ^ 2 + ?y ^ 2 |- context [?eye ^ 2 * (1 - ?t) / ?radius] =>
  assert (W : radius * (radius - eye ^ 2 * (1 - t) / radius) = radius ^ 2 - eye ^ 2 * (1 - t)) by (field; lra);
  assert (V : t ^ 2 * rho ^ 2 = t ^ 2 * x ^ 2 + t ^ 2 * y ^ 2) by (rewrite RS; ring) end; each settled.
Theorem visible_iff__visible : Statements.visible_iff__visible.
Proof.
  hit. assert (Z : eye ^ 2 * (1 - t) >= radius ^ 2) by (match goal with C : _ / radius >= radius |- _ => apply Rge_le in C; apply (Rmult_le_compat_r
    radius) in C; [field_simplify in C; lra | lra] end). from_the_point.
Qed.
Theorem visible_iff__hidden : Statements.visible_iff__hidden.
Proof.
  hit. assert (Z : eye ^ 2 * (1 - t) < radius ^ 2) by (match goal with C : _ / radius < radius |- _ => apply (Rmult_lt_compat_r radius) in C;
    [field_simplify in C; lra | lra] end). from_the_point.
Qed.
