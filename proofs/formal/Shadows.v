(* Shadows: the test by signs, its conics on the floor, its degree along a row, and the bodies that cast none. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Camera.
Open Scope R_scope.

Ltac shadow_lines := unfold shadow.shadow_discriminant, shadow.toward_center, shadow.segment_squared, shadow.segment_x,
  shadow.segment_y, shadow.segment_z, shadow.offset_x, shadow.offset_y, shadow.offset_z, dot, cross2.

(* The square of the distance of two points. *)
Definition apart2 (px py pz qx qy qz : R) := (px - qx) ^ 2 + (py - qy) ^ 2 + (pz - qz) ^ 2.

Ltac squares := repeat apply Rplus_le_le_0_compat; apply pow2_ge_0.

(* A parabola that is positive at 0 and at 1. *)
Lemma root_between a b c d : 0 <= a -> 0 < c -> 0 < a - 2 * b + c -> d = b ^ 2 - a * c ->
  (exists s, 0 < s < 1 /\ a * s ^ 2 - 2 * b * s + c = 0) <-> (0 <= d /\ 0 < b < a).
Proof.
  intros A C E D. split.
  - intros (s & [S0 S1] & Q). assert (V := Rmult_le_pos _ _ A (pow2_ge_0 s)).
    assert (W := Rmult_le_pos _ _ A (pow2_ge_0 (1 - s))).
    assert (0 < b) by (apply (Rmult_lt_reg_r s); lra). assert (b < a) by (apply (Rmult_lt_reg_r (1 - s)); lra).
    assert (d = (a * s - b) ^ 2) 
      by (replace ((a * s - b) ^ 2) with (b ^ 2 - a * c + a * (a * s ^ 2 - 2 * b * s + c)) by ring; rewrite Q, D; ring).
    pose proof (pow2_ge_0 (a * s - b)). lra.
  - intros (P & B0 & B1). destruct (near_root a b c d) as (T & V & Q & _); try lra.
    pose proof (sqrt_pos d). eexists. split; [split; [exact T |] | exact Q].
    apply (Rmult_lt_reg_l a); [lra |]. rewrite V. lra.
Qed.

(* |P + s a - C|^2 - r^2 = |a|^2 s^2 - 2 (a.w) s + |w|^2 - r^2, with a = L - P, w = C - P: a quadratic whose discriminant
   is the program's. *)
Theorem occlusion_by_signs__quadratic (s px py pz lx ly lz cx cy cz r : R) :
  let a2 := shadow.segment_squared px py pz lx ly lz in
  let aw := shadow.toward_center px py pz lx ly lz cx cy cz in
  a2 = dot (lx - px) (ly - py) (lz - pz) (lx - px) (ly - py) (lz - pz) /\
  aw = dot (lx - px) (ly - py) (lz - pz) (cx - px) (cy - py) (cz - pz) /\
  apart2 (px + s * (lx - px)) (py + s * (ly - py)) (pz + s * (lz - pz)) cx cy cz - r ^ 2 =
    a2 * s ^ 2 - 2 * aw * s + (apart2 cx cy cz px py pz - r ^ 2) /\
  shadow.shadow_discriminant px py pz lx ly lz cx cy cz r = aw ^ 2 - a2 * (apart2 cx cy cz px py pz - r ^ 2).
Proof. intros a2 aw. unfold a2, aw, apart2. shadow_lines. repeat split; ring. Qed.

(* Not with + 2 (a.w) s. *)
Theorem occlusion_by_signs__quadratic__false : ~ forall s px py pz lx ly lz cx cy cz r : R,
  apart2 (px + s * (lx - px)) (py + s * (ly - py)) (pz + s * (lz - pz)) cx cy cz - r ^ 2 =
  shadow.segment_squared px py pz lx ly lz * s ^ 2 + 2 * shadow.toward_center px py pz lx ly lz cx cy cz * s
  + (apart2 cx cy cz px py pz - r ^ 2).
Proof. intros F. specialize (F 1 0 0 0 1 0 0 1 0 0 0). revert F. unfold apart2. shadow_lines. lra. Qed.

(* P and L are outside the sphere about C: then |P + s (L - P) - C| = r for some s in (0, 1) exactly if d >= 0 and
   0 < a.w < |a|^2. *)
Theorem occlusion_by_signs__iff (px py pz lx ly lz cx cy cz r : R) : 0 < r ->
  r < sqrt (apart2 cx cy cz px py pz) -> r < sqrt (apart2 cx cy cz lx ly lz) ->
  (exists s, 0 < s < 1 /\
    sqrt (apart2 (px + s * (lx - px)) (py + s * (ly - py)) (pz + s * (lz - pz)) cx cy cz) = r) <->
  (0 <= shadow.shadow_discriminant px py pz lx ly lz cx cy cz r /\
   0 < shadow.toward_center px py pz lx ly lz cx cy cz < shadow.segment_squared px py pz lx ly lz).
Proof.
  intros Hr P L. assert (Z : forall a b c d e f, 0 <= apart2 a b c d e f) by (intros; unfold apart2; squares).
  assert (O : forall n, 0 <= n -> r < sqrt n -> 0 < n - r ^ 2).
  { intros n N S. pose proof (sqrt_sqrt n N). nra. }
  destruct (occlusion_by_signs__quadratic 1 px py pz lx ly lz cx cy cz r) as (_ & _ & E & D).
  rewrite <- (root_between _ _ (apart2 cx cy cz px py pz - r ^ 2) _); [| shadow_lines; squares | apply O; auto | | exact D].
  - split; intros (s & S & Q); exists s; (split; [exact S |]);
      destruct (occlusion_by_signs__quadratic s px py pz lx ly lz cx cy cz r) as (_ & _ & K & _).
    + rewrite <- K, <- Q, pow2_sqrt by auto. ring.
    + apply sqrt_is; lra.
  - replace (apart2 _ _ _ cx cy cz) with (apart2 cx cy cz lx ly lz) in E by (unfold apart2; ring).
    pose proof (O _ (Z cx cy cz lx ly lz) L). lra.
Qed.

Lemma apart_axis x : 0 <= x -> sqrt (apart2 0 0 0 x 0 0) = x.
Proof. intros X. apply sqrt_is; [exact X | unfold apart2; ring]. Qed.

Lemma apart_behind x : 0 <= x -> sqrt (apart2 0 0 0 (- x) 0 0) = x.
Proof. intros X. apply sqrt_is; [exact X | unfold apart2; ring]. Qed.

Theorem occlusion_by_signs__iff__point : exists px py pz lx ly lz cx cy cz r : R, 0 < r /\
  r < sqrt (apart2 cx cy cz px py pz) /\ r < sqrt (apart2 cx cy cz lx ly lz).
Proof. exists 2, 0, 0, (- (2)), 0, 0, 0, 0, 0, 1. rewrite apart_axis, apart_behind; lra. Qed.

(* Not with d >= 0 alone. *)
Theorem occlusion_by_signs__iff__false : ~ forall px py pz lx ly lz cx cy cz r : R, 0 < r ->
  r < sqrt (apart2 cx cy cz px py pz) -> r < sqrt (apart2 cx cy cz lx ly lz) ->
  0 <= shadow.shadow_discriminant px py pz lx ly lz cx cy cz r -> exists s, 0 < s < 1 /\
    sqrt (apart2 (px + s * (lx - px)) (py + s * (ly - py)) (pz + s * (lz - pz)) cx cy cz) = r.
Proof.
  intros F. specialize (F 2 0 0 3 0 0 0 0 0 1 ltac:(lra)). rewrite !apart_axis in F by lra.
  specialize (F ltac:(lra) ltac:(lra)). destruct F as (s & S & E); [shadow_lines; lra |].
  replace (0 + s * (0 - 0)) with 0 in E by ring. replace (apart2 _ _ _ _ _ _) with ((2 + s * (3 - 2)) ^ 2) in E
    by (unfold apart2; ring). rewrite sqrt_pow2 in E; lra.
Qed.

(* The program reports exactly these signs. *)
Theorem occlusion_by_signs__program (px py pz lx ly lz cx cy cz r : R) :
  let signs := 0 <= shadow.shadow_discriminant px py pz lx ly lz cx cy cz r /\
    0 < shadow.toward_center px py pz lx ly lz cx cy cz < shadow.segment_squared px py pz lx ly lz in
  (shadow.occluded px py pz lx ly lz cx cy cz r = 1 <-> signs) /\
  (shadow.occluded px py pz lx ly lz cx cy cz r = 0 <-> ~ signs).
Proof.
  intros signs. unfold signs, shadow.occluded. destruct both as [[[A B] C] | [[N | N] | N]]; split; split; intros; lra.
Qed.

(* Not the first alone. *)
Theorem occlusion_by_signs__program__false : ~ forall px py pz lx ly lz cx cy cz r : R,
  0 <= shadow.shadow_discriminant px py pz lx ly lz cx cy cz r -> shadow.occluded px py pz lx ly lz cx cy cz r = 1.
Proof.
  intros F. specialize (F 0 0 0 0 0 0 0 0 0 0). rewrite (proj1 (occlusion_by_signs__program _ _ _ _ _ _ _ _ _ _)) in F.
  destruct F as (_ & A & _).
  revert A. shadow_lines. lra.
Qed.
