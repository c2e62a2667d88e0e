(* The seed's false statements, each refuted at a point: ~ (statement), as it is printed. What is added is over the
   printed programs, or about limits and derivatives; its false variant is the refutation of the statement put right:
   that one holds, so ~ ~ (statement put right). *)

From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Camera Claim Fields.
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
  split; [exact S |]. nearest.lines.
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
  rewrite T in F. revert F. nearest.lines. destruct Rlt_dec; [| lra].
  destruct both as [_ | [[A | A] | A]]; [lra | destruct (A I) | destruct (A I) | simpl in A; lra].
Qed.

Theorem seed_pole_rows__beside : Statements.seed_pole_rows__beside.
Proof. intro F. generalize (F 127 108 ltac:(lra) ltac:(lra) ltac:(lra)). lra. Qed.

Theorem seed_orientation__left_handed : Statements.seed_orientation__left_handed.
Proof. intro F. generalize (F 0 1 1 0 ltac:(lra)). lra. Qed.

Theorem seed_bump_as_displacement__parallel : Statements.seed_bump_as_displacement__parallel.
Proof. intro F. generalize (F 1 0 1 1 1 1 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). lra. Qed.

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

Theorem seed_clamp__costs_an_order : Statements.seed_clamp__costs_an_order.
Proof. intro F. generalize (F (1 / 2) ltac:(lra) ltac:(lra) ltac:(lra)). rewrite Rabs_left; lra. Qed.

Theorem seed_truncation_slope__descends : Statements.seed_truncation_slope__descends.
Proof. intro F. generalize (F (1 / 2) 1 ltac:(lra) ltac:(lra)). rewrite Rabs_Ropp, Rabs_R1. lra. Qed.

Theorem ridges_differentiable__one_slope : Statements.ridges_differentiable__one_slope.
Proof.
  intro F. generalize (F 8 4 (1 / 4) (1 / 8)). replace (1 / 4 * PI * 8) with (2 * PI) by field.
  replace (PI * (8 * (1 / 4))) with (2 * PI) by field. replace (PI * (4 * (1 / 8))) with (PI / 2) by field.
  rewrite sin_2PI, cos_2PI, sin_PI2, Rabs_pos_eq; lra.
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
    + rewrite (floor_is 0 t) by lra. rewrite Rminus_0_r, Rabs_pos_eq; [reflexivity |]. apply sin_ge_0; nra.
    + rewrite (floor_is (-1) t) by lra. replace (PI * (t - -1)) with (PI * t + PI) by ring.
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

Theorem highlight_below_one__root : Statements.highlight_below_one__root.
Proof.
  intro F. generalize (F 32 (1 / 64 ^ 2) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
  replace (1 / 64 ^ 2) with ((1 / 64) ^ 2) by field. rewrite sqrt_pow2; lra.
Qed.

Theorem attached_shadow__in_light : Statements.attached_shadow__in_light.
Proof.
  intro F. generalize (F (3 / 4) 1 0 0 0 0 1 (-12 / 13) 0 (5 / 13)). cbv zeta. replace ((_ + 0) ^ 2 + _ + _) with ((5 / 4) ^ 2) by field.
  rewrite sqrt_pow2 by lra. lra.
Qed.
