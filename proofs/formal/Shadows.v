(* Shadows: the test by signs, its conics on the floor, its degree along a row, and the bodies that cast none. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Camera Claim Outlines Derivatives.
From Formal Require Statements.
Open Scope R_scope.

Ltac shadow_lines := shadow.lines; unfold dot3, cross2.

(* The square of the distance of two points. *)
Definition apart2 (px py pz qx qy qz : R) := (px - qx) ^ 2 + (py - qy) ^ 2 + (pz - qz) ^ 2.

Ltac squares := repeat apply Rplus_le_le_0_compat; apply pow2_ge_0.

(* A parabola that is positive at 0 and at 1. *)
Lemma root_between a b c d : 0 <= a -> 0 < c -> 0 < a - 2 * b + c -> d = b ^ 2 - a * c ->
  (exists s, 0 < s < 1 /\ a * s ^ 2 - 2 * b * s + c = 0) <-> (0 <= d /\ 0 < b < a).
Proof.
  intros A C E D. split.
  - intros (s & [S0 S1] & Q). pose proof Rmult_le_pos _ _ A (pow2_ge_0 s) as V.
    pose proof Rmult_le_pos _ _ A (pow2_ge_0 (1 - s)) as W.
    assert (0 < b) by (apply (Rmult_lt_reg_r s); lra). assert (b < a) by (apply (Rmult_lt_reg_r (1 - s)); lra).
    assert (d = (a * s - b) ^ 2) by (replace ((a * s - b) ^ 2) with (b ^ 2 - a * c + a * (a * s ^ 2 - 2 * b * s + c)) by ring; rewrite Q, D; ring).
    pose proof (pow2_ge_0 (a * s - b)). lra.
  - intros. destruct (near_root a b c d) as (T & V & Q & _); try lra.
    pose proof (sqrt_pos d). eexists. split; [split; [exact T |] | lra].
    apply (Rmult_lt_reg_l a); [lra |]. lra.
Qed.

(* |P + s a - C|^2 - r^2 = |a|^2 s^2 - 2 (a.w) s + |w|^2 - r^2, with a = L - P, w = C - P: a quadratic whose
   discriminant
   is the program's. *)
Lemma occlusion_by_signs_quadratic s px py pz lx ly lz cx cy cz r : let a2 := shadow.segment_squared px py pz lx ly lz in let aw :=
  shadow.toward_center px py pz lx ly lz cx cy cz in a2 = dot3 (lx - px) (ly - py) (lz - pz) (lx - px) (ly - py) (lz - pz) /\ aw = dot3 (lx - px)
  (ly - py) (lz - pz) (cx - px) (cy - py) (cz - pz) /\ apart2 (px + s * (lx - px)) (py + s * (ly - py)) (pz + s * (lz - pz)) cx cy cz - r ^ 2 = a2
  * s ^ 2 - 2 * aw * s + (apart2 cx cy cz px py pz - r ^ 2) /\ shadow.shadow_discriminant px py pz lx ly lz cx cy cz r = aw ^ 2 - a2 * (apart2 cx
  cy cz px py pz - r ^ 2).
Proof. intros a2 aw. unfold a2, aw, apart2. shadow_lines. lra. Qed.

(* P and L are outside the sphere about C: then |P + s (L - P) - C| = r for some s in (0, 1) exactly if d >= 0 and
   0 < a.w < |a|^2. *)
Theorem occlusion_by_signs__iff px py pz lx ly lz cx cy cz r : 0 < r -> r < sqrt (apart2 cx cy cz px py pz) -> r < sqrt (apart2 cx cy cz lx ly lz)
  -> (exists s, 0 < s < 1 /\ sqrt (apart2 (px + s * (lx - px)) (py + s * (ly - py)) (pz + s * (lz - pz)) cx cy cz) = r) <-> (0 <=
  shadow.shadow_discriminant px py pz lx ly lz cx cy cz r /\ 0 < shadow.toward_center px py pz lx ly lz cx cy cz < shadow.segment_squared px py pz
  lx ly lz).
Proof.
  intros Hr P L. assert (Z : forall a b c d e f, 0 <= apart2 a b c d e f) by (intros; squares).
  assert (O : forall n, 0 <= n -> r < sqrt n -> 0 < n - r ^ 2).
  { intros n N S. pose proof (sqrt_sqrt n). nra. }
  destruct (occlusion_by_signs_quadratic 1 px py pz lx ly lz cx cy cz r) as (_ & _ & E & D).
  rewrite <- (root_between _ _ (apart2 cx cy cz px py pz - r ^ 2) _); [| shadow_lines; squares | apply O; auto | | lra].
  - split; intros (s & S & Q); exists s; (split; auto); destruct (occlusion_by_signs_quadratic s px py pz lx ly lz cx cy cz r) as (_ & _ & K & _).
    + rewrite <- K, <- Q, pow2_sqrt by auto. ring.
    + apply sqrt_is; lra.
  - replace (apart2 _ _ _ cx cy cz) with (apart2 cx cy cz lx ly lz) in E by (unfold apart2; ring).
    pose proof (O _ (Z cx cy cz lx ly lz)). lra.
Qed.

Lemma apart_axis x : 0 <= x -> sqrt (apart2 0 0 0 x 0 0) = x.
Proof. intros X. apply sqrt_is; [lra | unfold apart2; ring]. Qed.

Theorem occlusion_by_signs__iff__point : exists px py pz lx ly lz cx cy cz r, 0 < r /\ r < sqrt (apart2 cx cy cz px py pz) /\ r < sqrt (apart2 cx
  cy cz lx ly lz).
Proof. exists 2, 0, 0, 3, 0, 0, 0, 0, 0, 1. rewrite !apart_axis; lra. Qed.

(* Not with d >= 0 alone. *)
Theorem occlusion_by_signs__iff__false : ~ forall px py pz lx ly lz cx cy cz r, 0 < r -> r < sqrt (apart2 cx cy cz px py pz) -> r < sqrt (apart2
  cx cy cz lx ly lz) -> 0 <= shadow.shadow_discriminant px py pz lx ly lz cx cy cz r -> exists s, 0 < s < 1 /\ sqrt (apart2 (px + s * (lx - px))
  (py + s * (ly - py)) (pz + s * (lz - pz)) cx cy cz) = r.
Proof.
  intros F. specialize (F 2 0 0 3 0 0 0 0 0 1 ltac:(lra)). rewrite !apart_axis in F by lra.
  specialize (F ltac:(lra) ltac:(lra)). destruct F as (s & S & E); [shadow_lines; lra |].
  replace (apart2 _ _ _ _ _ _) with ((2 + s * (3 - 2)) ^ 2) in E by (unfold apart2; ring). rewrite sqrt_pow2 in E; lra.
Qed.

(* The program reports exactly these signs. *)
Theorem occlusion_by_signs__numerators px py pz lx ly lz cx cy cz r : let signs := 0 <= shadow.shadow_discriminant px py pz lx ly lz cx cy cz r /\
  0 < shadow.toward_center px py pz lx ly lz cx cy cz < shadow.segment_squared px py pz lx ly lz in (shadow.occluded px py pz lx ly lz cx cy cz r
  = 1 <-> signs) /\ (shadow.occluded px py pz lx ly lz cx cy cz r = 0 <-> ~ signs).
Proof. intros signs. unfold signs, shadow.occluded. destruct both; lra. Qed.

(* Not the first alone. *)
Theorem occlusion_by_signs__numerators__false : ~ forall px py pz lx ly lz cx cy cz r, 0 <= shadow.shadow_discriminant px py pz lx ly lz cx cy cz
  r -> shadow.occluded px py pz lx ly lz cx cy cz r = 1.
Proof.
  intros F. specialize (F 0 0 0 0 0 0 0 0 0 0). rewrite (proj1 (occlusion_by_signs__numerators _ _ _ _ _ _ _ _ _ _)) in F.
  destruct F as (_ & A & _); [| revert A]; shadow_lines; lra.
Qed.

Theorem shadow_of_b_on_floor__conic : Statements.shadow_of_b_on_floor__conic.
Proof. red. intros. subst foot_x foot_y. repeat split; slope. Qed.
Theorem shadow_of_b_on_floor__ellipse : Statements.shadow_of_b_on_floor__ellipse.
Proof. claim. Qed.
Theorem shadow_of_b_on_floor__parabola : Statements.shadow_of_b_on_floor__parabola.
Proof. claim. Qed.
Theorem shadow_of_b_on_floor__hyperbola : Statements.shadow_of_b_on_floor__hyperbola.
Proof. claim. Qed.
Theorem shadow_of_b_on_floor__away : Statements.shadow_of_b_on_floor__away.
Proof. claim. Qed.
Ltac outline_from_the_light outline := red; intros r cx cy cz lx ly lz x y; intros; destruct (outline (cx - lx) (cy - ly) r (lz - cz) lz (x - lx) (y -
  ly)); lra.
Theorem shadow_of_b_on_floor__all_seen : Statements.shadow_of_b_on_floor__all_seen.
Proof. outline_from_the_light silhouette_of_b__all_seen. Qed.
Theorem shadow_of_b_on_floor__none_seen : Statements.shadow_of_b_on_floor__none_seen.
Proof. outline_from_the_light silhouette_of_b__none_seen. Qed.

(* The part cast away from the light has a.w' < |a|^2, that is (P - L).(C - L) > 0. *)
Definition cast_away (x y lx ly lz cx cy cz : R) :=
  shadow.toward_center x y 0 lx ly lz cx cy cz < shadow.segment_squared x y 0 lx ly lz.
Definition cast_back (x y lx ly lz cx cy cz : R) :=
  shadow.segment_squared x y 0 lx ly lz < shadow.toward_center x y 0 lx ly lz cx cy cz.

(* The shadow is the sphere's outline, seen from the light: cast away is in front of it. *)
Lemma from_the_light x y lx ly lz cx cy cz r :
  let b := hit_of_b.toward_b (x - lx) (y - ly) lz (cx - lx) (cy - ly) cz in
  shadow.shadow_discriminant x y 0 lx ly lz cx cy cz r = hit_of_b.discriminant_b (x - lx) (y - ly) lz (cx - lx) (cy - ly) cz r /\
  (cast_away x y lx ly lz cx cy cz <-> 0 < b) /\ (cast_back x y lx ly lz cx cy cz <-> b < 0).
Proof.
  intro b. assert (shadow.segment_squared x y 0 lx ly lz - shadow.toward_center x y 0 lx ly lz cx cy cz = b) by (unfold b; hit_of_b.lines;
    shadow_lines; ring).
  unfold cast_away, cast_back. split; [hit_of_b.lines; shadow_lines; ring | lra].
Qed.

Ltac moved_by_the_light x y := match goal with |- context [x + ?lx - ?lx] => replace (x + lx - lx) with x by ring end;
  match goal with |- context [y + ?ly - ?ly] => replace (y + ly - ly) with y by ring end; assumption.

(* If |L_z - C_z| >= r the shadow has a point, so that what is called an ellipse is one. *)
Theorem shadow_of_b_on_floor__real lx ly lz cx cy cz r : 0 < lz -> 0 < r -> 0 < c_of_b lz (cx - lx) (cy - ly) cz r -> r ^ 2 <= (lz - cz) ^ 2 ->
  exists x y, shadow.shadow_discriminant x y 0 lx ly lz cx cy cz r = 0.
Proof.
  intros L P C H. destruct (silhouette_of_b__real lz _ _ cz r L P C H) as (x & y & D). exists (x + lx), (y + ly).
  rewrite (proj1 (from_the_light _ _ _ _ _ _ _ _ _)). moved_by_the_light x y.
Qed.

Theorem shadow_of_b_on_floor__real__point : exists lx ly lz cx cy cz r, 0 < lz /\ 0 < r /\ 0 < c_of_b lz (cx - lx) (cy - ly) cz r /\ r ^ 2 <= (lz
  - cz) ^ 2.
Proof. exists 0, 0, 3, 0, 0, 0, 1. unfold c_of_b, dot3. lra. Qed.

(* Not with the light on the sphere. *)
Theorem shadow_of_b_on_floor__real__false : ~ forall lx ly lz cx cy cz r, 0 < lz -> 0 < r -> r ^ 2 <= (lz - cz) ^ 2 -> exists x y,
  shadow.shadow_discriminant x y 0 lx ly lz cx cy cz r = 0.
Proof. intros F. destruct (F 0 0 4 0 0 3 1) as (x & y & D); try lra. revert D. shadow_lines. lra. Qed.

(* If the light is between top and lowest point, there are points cast away and others, and each is one or the other. *)
Theorem shadow_of_b_on_floor__two_branches lx ly lz cx cy cz r : 0 < lz -> 0 < c_of_b lz (cx - lx) (cy - ly) cz r -> cz - r < lz < cz + r ->
  (exists x y, shadow.shadow_discriminant x y 0 lx ly lz cx cy cz r = 0 /\ cast_away x y lx ly lz cx cy cz) /\ (exists x y,
  shadow.shadow_discriminant x y 0 lx ly lz cx cy cz r = 0 /\ cast_back x y lx ly lz cx cy cz) /\ (forall x y, 0 <= shadow.shadow_discriminant x y
  0 lx ly lz cx cy cz r -> cast_away x y lx ly lz cx cy cz \/ cast_back x y lx ly lz cx cy cz).
Proof.
  intros L C H. destruct (silhouette_of_b__two_branches lz _ (cy - ly) cz r L C) as [(x1 & y1 & D1) (x2 & y2 & D2)]; [nra |].
  split; [exists (x1 + lx), (y1 + ly) | split; [exists (x2 + lx), (y2 + ly) |]].
  - destruct (from_the_light (x1 + lx) (y1 + ly) lx ly lz cx cy cz r) as (-> & -> & _). moved_by_the_light x1 y1.
  - destruct (from_the_light (x2 + lx) (y2 + ly) lx ly lz cx cy cz r) as (-> & _ & ->). moved_by_the_light x2 y2.
  - intros x y. destruct (from_the_light x y lx ly lz cx cy cz r) as (-> & -> & ->).
    destruct (quadratic_of_b 0 (x - lx) (y - ly) lz (cx - lx) (cy - ly) cz r) as (_ & _ & ->). intro D.
    assert (0 < dot3 (x - lx) (y - ly) (- lz) (x - lx) (y - ly) (- lz)) by (unfold dot3; pose proof (pow2_ge_0 (x - lx)); pose proof (pow2_ge_0 (y -
      ly)); nra).
    set (b := hit_of_b.toward_b (x - lx) _ _ _ _ _) in *. destruct (Rtotal_order b 0) as [N | [Z | P]]; auto.
    nra.
Qed.

Theorem shadow_of_b_on_floor__two_branches__point : exists lx ly lz cx cy cz r, 0 < lz /\ 0 < c_of_b lz (cx - lx) (cy - ly) cz r /\ cz - r < lz <
  cz + r.
Proof. exists 0, 0, 2, 2, 0, 2, 1. unfold c_of_b, dot3. lra. Qed.

(* Not if it is level with the top. *)
Theorem shadow_of_b_on_floor__two_branches__false : ~ forall lx ly lz cx cy cz r, 0 < lz -> 0 < c_of_b lz (cx - lx) (cy - ly) cz r -> cz - r < lz
  <= cz + r -> exists x y, shadow.shadow_discriminant x y 0 lx ly lz cx cy cz r = 0 /\ cast_back x y lx ly lz cx cy cz.
Proof.
  intros F. specialize (F 0 0 3 2 0 2 1). unfold c_of_b, dot3 in F. destruct F as (x & y & D & B); try lra.
  revert D B. unfold cast_back. shadow_lines. nra.
Qed.

(* Sphere A's shadow is an ellipse if L_z > R: of positive determinant, and with points. *)
Theorem shadow_of_a_on_floor__ellipse lx ly lz r : 0 < r < lz -> let c := lx ^ 2 + ly ^ 2 + lz ^ 2 - r ^ 2 in 0 < (lx ^ 2 - c) * (ly ^ 2 - c) -
  (lx * ly) ^ 2 /\ exists x y, shadow.shadow_discriminant x y 0 lx ly lz 0 0 0 r = 0.
Proof.
  intros H c. assert (0 < c) by (unfold c; nra). split.
  - replace (_ - _) with (c * (lz ^ 2 - r ^ 2)) by (unfold c; ring). apply Rmult_lt_0_compat; nra.
  - apply shadow_of_b_on_floor__real; try nra. unfold c_of_b, dot3. unfold c in *. lra.
Qed.

Theorem shadow_of_a_on_floor__ellipse__point : exists r lz, 0 < r < lz.
Proof. exists 1, 2. lra. Qed.

(* Not if L_z = R. *)
Theorem shadow_of_a_on_floor__ellipse__false : ~ forall lx ly lz r, 0 < r <= lz -> let c := lx ^ 2 + ly ^ 2 + lz ^ 2 - r ^ 2 in 0 < (lx ^ 2 - c) *
  (ly ^ 2 - c) - (lx * ly) ^ 2.
Proof. intros F. generalize (F 1 0 1 1). lra. Qed.

(* The shadow is its part with 0 < a.w' < |a|^2, beyond A: 0 < a.w' says P.L < |P|^2. *)
Theorem shadow_of_a_on_floor__beyond_a x y lx ly lz r : 0 < r -> r < sqrt (lx ^ 2 + ly ^ 2 + lz ^ 2) -> r < sqrt (x ^ 2 + y ^ 2) ->
  shadow.toward_center x y 0 lx ly lz 0 0 0 = dot3 x y 0 x y 0 - dot3 x y 0 lx ly lz /\ ((exists s, 0 < s < 1 /\ sqrt (apart2 (x + s * (lx - x))
  (y + s * (ly - y)) (0 + s * (lz - 0)) 0 0 0) = r) <-> (0 <= shadow.shadow_discriminant x y 0 lx ly lz 0 0 0 r /\ dot3 x y 0 lx ly lz < dot3 x y
  0 x y 0 /\ cast_away x y lx ly lz 0 0 0)) /\ (r <= lz -> (exists s, 0 < s < 1 /\ sqrt (apart2 (x + s * (lx - x)) (y + s * (ly - y)) (0 + s * (lz
  - 0)) 0 0 0) = r) <-> (0 <= shadow.shadow_discriminant x y 0 lx ly lz 0 0 0 r /\ dot3 x y 0 lx ly lz < dot3 x y 0 x y 0)).
Proof.
  intros R L P. assert (T : shadow.toward_center x y 0 lx ly lz 0 0 0 = dot3 x y 0 x y 0 - dot3 x y 0 lx ly lz) by (shadow_lines; ring). split; auto.
  rewrite (occlusion_by_signs__iff x y 0 lx ly lz 0 0 0 r R).
  2: { replace (apart2 0 0 0 x y 0) with (x ^ 2 + y ^ 2) by (unfold apart2; ring). exact P. }
  2: { replace (apart2 0 0 0 lx ly lz) with (lx ^ 2 + ly ^ 2 + lz ^ 2) by (unfold apart2; ring). lra. }
  unfold cast_away. split; [lra |]. intros H. split; [intros; lra |]. intros [D B].
  assert (N : 0 <= lx ^ 2 + ly ^ 2 + lz ^ 2) by squares. pose proof (sqrt_sqrt _ N).
  assert (A : cast_away x y lx ly lz 0 0 0).
  { apply (from_the_light x y lx ly lz 0 0 0 r). rewrite (proj1 (from_the_light _ _ _ _ _ _ _ _ _)) in D.
    apply (seen_of_b _ _ _ _ _ _ r); try lra. unfold c_of_b, dot3. nra. }
  unfold cast_away in A. lra.
Qed.

Theorem shadow_of_a_on_floor__beyond_a__point : exists x y lx ly lz r, 0 < r /\ r < sqrt (lx ^ 2 + ly ^ 2 + lz ^ 2) /\ r < sqrt (x ^ 2 + y ^ 2).
Proof. exists 2, 0, 0, 0, 2, 1. rewrite !(sqrt_is _ 2); lra. Qed.

(* Not with |P|^2 < P.L, on the light's side. *)
Theorem shadow_of_a_on_floor__beyond_a__false : ~ forall x y lx ly lz, 0 < shadow.toward_center x y 0 lx ly lz 0 0 0 <-> dot3 x y 0 x y 0 < dot3 x
  y 0 lx ly lz.
Proof. intros F. destruct (F 1 0 0 0 1) as [G _]. revert G. shadow_lines. lra. Qed.

(* The length of a vector. *)
Definition len (x y z : R) := sqrt (x ^ 2 + y ^ 2 + z ^ 2).

Lemma len_pos x y z : 0 <= len x y z.
Proof. apply sqrt_pos. Qed.

Lemma len_squared x y z : len x y z ^ 2 = x ^ 2 + y ^ 2 + z ^ 2.
Proof. apply pow2_sqrt. squares. Qed.

Theorem shadow_out_of_reach__within : Statements.shadow_out_of_reach__within.
Proof. claim. Qed.
Theorem shadow_out_of_reach__cone : Statements.shadow_out_of_reach__cone.
Proof.
  red. intros. assert (N : distance ^ 2 * wander ^ 2 - product ^ 2 = (aside_y * axis_x - aside_x * axis_y) ^ 2 + (aside_x * axis_z - aside_z *
    axis_x) ^ 2 + (aside_z * axis_y - aside_y * axis_z) ^ 2) by (put (distance ^ 2); put (wander ^ 2); put product; ring).
  assert (distance ^ 2 * wander ^ 2 - product ^ 2 >= 0) by (rewrite N; sum_of_squares). assert (distance * wander >= 0) by nra.
  assert (distance * wander + product >= 0) by nra. each ltac:(first [assumption | lra | nra]).
Qed.
Theorem shadow_out_of_reach__quadratic : Statements.shadow_out_of_reach__quadratic.
Proof. claim. Qed.
Theorem shadow_out_of_reach__turns_before : Statements.shadow_out_of_reach__turns_before.
Proof. claim. Qed.
Theorem shadow_out_of_reach__turns_between : Statements.shadow_out_of_reach__turns_between.
Proof. red. intros. assert (0 <= bend * (share - at_) ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]). replace slope with (- (at_ * bend)) by
  lra. lra. Qed.
Theorem shadow_out_of_reach__turns_after : Statements.shadow_out_of_reach__turns_after.
Proof. red. intros. assert (0 <= (1 - share) * (bend * (1 - share) - 2 * (bend + slope))) by (apply Rmult_le_pos; nra). lra. Qed.
Theorem shadow_out_of_reach__bends_down : Statements.shadow_out_of_reach__bends_down.
Proof. red. intros. assert (0 <= share * (1 - share) * - bend) by (repeat apply Rmult_le_pos; lra). lra. Qed.

Lemma len_axis x : 0 <= x -> len x 0 0 = x.
Proof. intros X. apply sqrt_is; lra. Qed.

(* On [0, 1] the program's shortest is the least value of its quadratic: at an end or where it turns. *)
Lemma least_of_quadratic low slope bend t : 0 <= t <= 1 -> let turning := if Rle_dec 0 slope then 0 else if Rle_dec (bend + slope) 0 then 1 else -
  slope / bend in let at_ball := low + bend + 2 * slope in let at_turning := low + turning * (bend * turning + 2 * slope) in let at_an_end := if
  Rlt_dec at_ball low then at_ball else low in (if Rlt_dec at_turning at_an_end then at_turning else at_an_end) <= low + t * (bend * t + 2 *
  slope).
Proof.
  assert (L : forall x y, (if Rlt_dec x y then x else y) <= x /\ (if Rlt_dec x y then x else y) <= y) by (split; destruct Rlt_dec; lra). intros [T0
    T1] turning at_ball at_turning at_an_end.
  destruct (L at_ball low) as [M M']. fold at_an_end in M, M'. generalize (L at_turning at_an_end). set (least := if Rlt_dec at_turning _ then _ else
    _). intros [U V]. destruct (Rle_lt_dec bend 0) as [N|P].
  - generalize (shadow_out_of_reach__bends_down bend low t slope). unfold at_ball in M. nra.
  - revert U. unfold at_turning, turning. destruct Rle_dec; [|destruct Rle_dec as [B|B]].
    + generalize (shadow_out_of_reach__turns_before bend low t slope). lra.
    + generalize (shadow_out_of_reach__turns_after bend low t slope). lra.
    + generalize (shadow_out_of_reach__turns_between (- slope / bend) bend low t slope P ltac:(field; lra)). lra.
Qed.

(* So where the program's clearance is positive, no segment from the light to a point of the ball meets the body. *)
Theorem shadow_out_of_reach__program lx ly lz cx cy cz r bx by_ bz s : 0 < r -> 0 < s -> r < len (lx - cx) (ly - cy) (lz - cz) -> 0 <
  shadow_clearance.clearance lx ly lz cx cy cz r bx by_ bz s -> forall t qx qy qz, 0 <= t <= 1 -> len (qx - bx) (qy - by_) (qz - bz) <= s -> r <
  len (lx + t * (qx - lx) - cx) (ly + t * (qy - ly) - cy) (lz + t * (qz - lz) - cz).
Proof.
  intros R S O C t qx qy qz T Q. set (n := len (lx - cx + t * (bx - lx)) (ly - cy + t * (by_ - ly)) (lz - cz + t * (bz - lz))).
  assert (P : 0 < shadow_clearance.shortest lx ly lz cx cy cz r bx by_ bz s).
  { unfold shadow_clearance.clearance in C. pose proof (len_squared (lx - cx) (ly - cy) (lz - cz)).
    match type of C with 0 < ?a / ?b => assert (0 < b); [| apply (Rmult_lt_reg_r (/ b)); [apply Rinv_0_lt_compat; assumption | lra]] end.
    assert (0 < (lx - cx) ^ 2 + (ly - cy) ^ 2 + (lz - cz) ^ 2) by nra.
    pose proof (pow2_ge_0 (bx - lx)). pose proof (pow2_ge_0 (by_ - ly)). pose proof (pow2_ge_0 (bz - lz)).
    shadow_clearance.lines. lra. }
  assert (r + t * s < n).
  { assert (0 <= n) by apply len_pos. assert (0 < n ^ 2 - (r + t * s) ^ 2); [|nra].
    eapply Rlt_le_trans; [exact P|]. eapply Rle_trans; [exact (least_of_quadratic _ _ _ t T)|]. unfold n. rewrite len_squared.
      shadow_clearance.lines. lra. }
  pose proof (len_pos (qx - bx) (qy - by_) (qz - bz)).
  epose proof (shadow_out_of_reach__cone (t * (qx - bx)) (t * (qy - by_)) (t * (qz - bz)) (lx - cx + t * (bx - lx)) (ly - cy + t * (by_ - ly)) (lz -
    cz + t * (bz - lz)) r n _ (t * s) (t * len (qx - bx) (qy - by_) (qz - bz)) R) as E. destruct E as (_ & _ & _ & _ & _ & _ & _ & E); try nra; try
      reflexivity; try (unfold n; rewrite ?Rpow_mult_distr, len_squared; ring).
  rewrite <- (sqrt_pow2 r) by lra. apply sqrt_lt_1_alt. split; [apply pow2_ge_0 | lra].
Qed.

Theorem shadow_out_of_reach__program__point : exists lx ly lz cx cy cz r bx by_ bz s, 0 < r /\ 0 < s /\ r < len (lx - cx) (ly - cy) (lz - cz) /\ 0
  < shadow_clearance.clearance lx ly lz cx cy cz r bx by_ bz s.
Proof.
  exists 3, 0, 0, 0, 0, 0, 1, 4, 0, 0, 1. rewrite !Rminus_0_r, len_axis by lra. repeat split; try lra.
  shadow_clearance.lines.
  destruct Rle_dec; [| lra]. destruct Rlt_dec; destruct Rlt_dec; lra.
Qed.

(* Not wherever the light is outside the body. *)
Theorem shadow_out_of_reach__program__false : ~ forall lx cx r bx s, 0 < r -> 0 < s -> r < len (lx - cx) 0 0 -> forall t qx, 0 <= t <= 1 -> len
  (qx - bx) 0 0 <= s -> r < len (lx + t * (qx - lx) - cx) 0 0.
Proof.
  intros F. assert (H : 1 < len (3 + 1 / 2 * (-3 - 3) - 0) 0 0).
  { apply (F 3 0 1 (-3) 1); try lra; unfold len; [rewrite (sqrt_is _ 3) | rewrite (sqrt_is _ 0)]; lra. }
  rewrite len_axis in H; lra.
Qed.

