(* The printed claims about the bumped normal: its length, its angle to N, normalising, small and large beta, its derivative, shadow lines. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Claim.
From Formal Require Statements.
Open Scope R_scope.

Lemma three_squares x y z : 0 <= x * x + y * y + z * z.
Proof. nra. Qed.
Ltac direct := first [assumption | lra | nra | apply Rgt_not_eq; lra].
(* M = N + beta g where N is a unit vector and g is tangent: |M|^2 = 1 + beta^2 |g|^2, N.N' = 1/|M|, |N'| = 1. *)
Ltac bump := match goal with
  N : ?nz * ?nz + ?nx * ?nx + ?ny * ?ny = 1, T : ?gz * ?nz + ?gx * ?nx + ?gy * ?ny = 0, x := ?b * ?gx + ?nx, y := ?b * ?gy + ?ny, z := ?b * ?gz + ?nz,
  l := sqrt _, s := / _, bx := _ * _, by_ := _ * _, bz := _ * _ |- _ =>
  assert (S : x ^ 2 + y ^ 2 + z ^ 2 = 1 + b ^ 2 * (gz * gz + gx * gx + gy * gy)) by (transitivity ((nz * nz + nx * nx + ny * ny) +
    2 * b * (gz * nz + gx * nx + gy * ny) + b ^ 2 * (gz * gz + gx * gx + gy * gy)); [unfold x, y, z; ring | rewrite N, T; ring]);
  assert (G : 0 <= gz * gz + gx * gx + gy * gy) by nra;
  assert (W : 0 <= b ^ 2 * (gz * gz + gx * gx + gy * gy)) by (apply Rmult_le_pos; [apply pow2_ge_0 | exact G]);
  assert (L : l ^ 2 = 1 + b ^ 2 * (gz * gz + gx * gx + gy * gy)) by (unfold l; rewrite pow2_sqrt; lra);
  assert (P : 0 <= l) by apply sqrt_pos; assert (O : 1 <= l) by nra; assert (K : l * s = 1) by (apply Rinv_r; lra);
  assert (I : bz * nz + bx * nx + by_ * ny = s) by (transitivity (s * ((nz * nz + nx * nx + ny * ny) + b * (gz * nz + gx * nx + gy * ny)));
    [lines; ring | rewrite N, T; ring]);
  assert (U : bz * bz + bx * bx + by_ * by_ = 1) by (transitivity (s ^ 2 * (x ^ 2 + y ^ 2 + z ^ 2)); [unfold bx, by_, bz; ring |
    rewrite S, <- L, <- Rpow_mult_distr, (Rmult_comm s), K; ring]) end.

Theorem unit_length__length : Statements.unit_length__length.
Proof. red. intros. bump. each direct. Qed.
Theorem angle_of_the_bump__angle : Statements.angle_of_the_bump__angle.
Proof.
  red. intros. bump. rewrite I.
  assert (A : (bumped_y * normal_x - bumped_x * normal_y) * (bumped_y * normal_x - bumped_x * normal_y) + (bumped_x * normal_z - bumped_z * normal_x)
    * (bumped_x * normal_z - bumped_z * normal_x) +
    (bumped_z * normal_y - bumped_y * normal_z) * (bumped_z * normal_y - bumped_y * normal_z) = beta ^ 2 * (g_z * g_z + g_x * g_x + g_y * g_y) *
      m_scale ^ 2).
  { transitivity ((bumped_z * bumped_z + bumped_x * bumped_x + bumped_y * bumped_y) * (normal_z * normal_z + normal_x * normal_x + normal_y * normal_y) -
    (bumped_z * normal_z + bumped_x * normal_x + bumped_y * normal_y) ^ 2); [ring|].
  rewrite U, H, I. replace (1 * 1) with ((m_length * m_scale) ^ 2) by (rewrite K; ring). rewrite Rpow_mult_distr, L. ring. }
  each direct.
Qed.

Theorem normalising_is_lipschitz__moved : Statements.normalising_is_lipschitz__moved.
Proof. red. intros. put other_m_x. put other_m_y. put other_m_z. lines. ring. Qed.

Theorem normalising_is_lipschitz__normalise : Statements.normalising_is_lipschitz__normalise.
Proof.
  red. intros.
  match goal with A : length_a ^ 2 = _, B : length_b ^ 2 = _, P : product = _ |- _ => rename A into LA, B into LB, P into LP end.
  set (l := length_a * length_b). assert (N : length_a ^ 2 * length_b ^ 2 = l ^ 2) by (unfold l; ring).
  assert (Q : l ^ 2 - product ^ 2 = (a_x * b_y - a_y * b_x) * (a_x * b_y - a_y * b_x) + (a_z * b_x - a_x * b_z) * (a_z * b_x - a_x * b_z) + (a_y * b_z
    - a_z * b_y) * (a_y * b_z - a_z * b_y))
    by (rewrite <- N, LA, LB, LP; ring).
  assert (Q0 : 0 <= l ^ 2 - product ^ 2) by (rewrite Q; apply three_squares). assert (L : 1 <= l) by (unfold l; nra). assert (B : - l <= product <= l)
    by (split; nra).
  assert (A : apart ^ 2 = length_a ^ 2 + length_b ^ 2 - 2 * product) by (put (apart ^ 2); rewrite LA, LB, LP; ring).
  assert (T : turned ^ 2 * length_a * length_b = 2 * (l - product)).
  { put (turned ^ 2). apply (Rmult_eq_reg_r l); [|lra]. transitivity (length_b ^ 2 * (a_z * a_z + a_x * a_x + a_y * a_y) + length_a ^ 2 * (b_z * b_z +
    b_x * b_x + b_y * b_y) -
      2 * l * (a_z * b_z + a_x * b_x + a_y * b_y)); [unfold l; field; lra | rewrite <- LA, <- LB, <- LP; unfold l; ring]. }
  assert (T' : l * turned ^ 2 = 2 * (l - product)) by (rewrite <- T; unfold l; ring).
  assert (D : l * (apart ^ 2 - turned ^ 2) >= 0).
  { replace (l * (apart ^ 2 - turned ^ 2)) with (l * (length_a - length_b) ^ 2 + 2 * (l - 1) * (l - product)) by (replace (l * (apart ^ 2 - turned ^
    2)) with (l * apart ^ 2 - l * turned ^ 2) by ring; rewrite T', A; unfold l; ring).
    apply Rle_ge, Rplus_le_le_0_compat; repeat (apply pow2_ge_0 || apply Rmult_le_pos); lra. }
  assert (E : apart ^ 2 >= turned ^ 2) by nra. assert (F : 4 >= turned ^ 2) by nra. rewrite N.
  each direct.
Qed.

(* w = |beta| |g|. *)
Lemma swing_of g2 beta w : 0 <= g2 -> w = sqrt g2 * Rabs beta -> w ^ 2 = beta ^ 2 * g2 /\ w >= 0.
Proof.
  intros G ->. split; [rewrite Rpow_mult_distr, pow2_sqrt, pow2_abs by exact G; ring | apply Rle_ge, Rmult_le_pos; [apply sqrt_pos | apply Rabs_pos]].
Qed.
Theorem shadow_line_moves_within__shadow_line : Statements.shadow_line_moves_within__shadow_line.
Proof.
  red. intros. bump. set (g2 := g_z * g_z + g_x * g_x + g_y * g_y) in *. destruct (swing_of g2 beta w G ltac:(assumption)) as [R W0]. set (swing :=
    beta * (g_z * towards_z + g_x * towards_x + g_y * towards_y)).
  assert (Q : g2 - (g_z * towards_z + g_x * towards_x + g_y * towards_y) ^ 2 >= 0).
  { replace g2 with (g2 * (towards_z * towards_z + towards_x * towards_x + towards_y * towards_y)) by (put (towards_z * towards_z + towards_x *
    towards_x + towards_y * towards_y); ring).
    apply Rle_ge. eapply Rle_trans; [apply (three_squares (g_x * towards_y - g_y * towards_x) (g_y * towards_z - g_z * towards_y) (g_z * towards_x -
      g_x * towards_z)) | right; unfold g2; ring]. }
  assert (V : w ^ 2 - swing ^ 2 >= 0) by (rewrite R; unfold swing; nra). assert (B : swing + w >= 0) by nra.
  assert (F : swing + normal_z * towards_z + normal_x * towards_x + normal_y * towards_y > 0) by lra.
  assert (E : bumped_z * towards_z + bumped_x * towards_x + bumped_y * towards_y = m_scale * (swing + normal_z * towards_z + normal_x * towards_x +
    normal_y * towards_y))
    by (unfold bumped_x, bumped_y, bumped_z, m_x, m_y, m_z, swing; ring).
  rewrite E, <- Rmult_assoc, K. each direct.
Qed.
Ltac unmoved := repeat match goal with H : ?v = 0 |- _ => is_var v; subst v end; bump; match goal with L : ?l ^ 2 = _, K : ?l * ?s = 1 |- _ =>
  assert (l ^ 2 = 1) by (rewrite L; ring); assert (E : l = 1) by nra; assert (F : s = 1) by (rewrite E in K; lra);
  each ltac:(first [direct | lines; rewrite F; ring]) end.
Theorem normal_limits__zero_beta : Statements.normal_limits__zero_beta.
Proof. red. intros. unmoved. Qed.
Theorem normal_limits__zero_height : Statements.normal_limits__zero_height.
Proof. red. intros. unmoved. Qed.
Theorem normal_limits__small_beta : Statements.normal_limits__small_beta.
Proof.
  red. intros. bump. set (g2 := g_z * g_z + g_x * g_x + g_y * g_y) in *. destruct (swing_of g2 beta w G ltac:(assumption)) as [R W0].
  set (d := (bumped_z - normal_z) * _ + _ + _). assert (D0 : 0 <= d) by apply three_squares.
  assert (D : d = 2 - 2 * m_scale) by (rewrite <- I; unfold d; lra).
  assert (M : m_length * d = 2 * (m_length - 1)) by (rewrite D, Rmult_minus_distr_l, <- Rmult_assoc, (Rmult_comm m_length 2), Rmult_assoc, K; ring).
  assert (B : beta ^ 2 * g2 - d >= 0) by nra.
  assert (F : w >= sqrt d) by (rewrite <- (sqrt_pow2 w); [apply Rle_ge, sqrt_le_1_alt |]; lra).
  each direct.
Qed.

Lemma far l w q : l ^ 2 = 1 + w ^ 2 -> 0 < w -> 0 <= l -> 0 <= q -> l * q = 2 * (l - w) -> l >= w /\ l * (l + w) * q = 2 /\ 1 >= w ^ 2 * q /\ 1 >=
  w * sqrt q.
Proof.
  intros L W P Q E. assert (A : w <= l) by nra. assert (T : l * (l + w) * q = 2) by (transitivity ((l + w) * (l * q)); [ring | rewrite E; lra]).
  assert (B : w ^ 2 * q <= 1) by (assert (w * w * q <= l * (l + w) / 2 * q) by (apply Rmult_le_compat_r; nra); lra).
  repeat split; try lra. apply Rle_ge. rewrite <- (sqrt_pow2 w), <- sqrt_mult, <- sqrt_1 by nra. apply sqrt_le_1_alt, B.
Qed.
(* How far N' is from side g/|g|, where side beta = |beta|. *)
Ltac far_away side := match goal with U : ?bz * ?bz + ?bx * ?bx + ?by_ * ?by_ = 1, K : ?l * ?s = 1, L : ?l ^ 2 = _, T : ?gz * ?nz + ?gx * ?nx + ?gy
  * ?ny = 0,
  V : ?w = sqrt ?x * Rabs ?beta |- _ =>
  set (g2 := x) in *; assert (R0 : 0 < sqrt g2) by (apply sqrt_lt_R0; lra); assert (R2 : sqrt g2 ^ 2 = g2) by (apply pow2_sqrt; lra); set (r :=
    sqrt g2) in *;
  assert (A : Rabs beta = side * beta) by (cases; lra); assert (W0 : 0 < w) by (rewrite V, A; apply Rmult_lt_0_compat; lra);
  destruct (swing_of g2 beta w) as [W2 _]; [lra | exact V |];
  assert (J : bz * side * gz / r + bx * side * gx / r + by_ * side * gy / r = s * w) by
    (transitivity (side * s * (beta * r ^ 2 + (gz * nz + gx * nx + gy * ny)) / r); [rewrite R2; unfold g2; lines; field | rewrite T, V, A; field]; lra);
  match goal with |- context [sqrt ?y] => set (q := y) in *; assert (Q0 : 0 <= q) by apply three_squares;
  assert (Q : q = 2 - 2 * (s * w)) by (transitivity ((bz * bz + bx * bx + by_ * by_) - 2 * (bz * side * gz / r + bx * side * gx / r + by_ * side * gy
    / r) + g2 / r ^ 2);
    [unfold q, g2; field; lra | rewrite U, J, R2; field; lra]);
  assert (E : l * q = 2 * (l - w)) by (rewrite Q; transitivity (2 * l - 2 * (l * s) * w); [ring | rewrite K; ring]);
  destruct (far l w q) as (F1 & F2 & F3 & F4); try assumption; [rewrite L, W2; ring|]; rewrite J, <- Rmult_assoc, K end end.
Theorem normal_limits__large_beta : Statements.normal_limits__large_beta.
Proof. red. intros. bump. far_away 1. each direct. Qed.
Theorem normal_limits__large_negative_beta : Statements.normal_limits__large_negative_beta.
Proof. red. intros. bump. far_away (-1). each direct. Qed.

Ltac length_of l := match goal with l := sqrt ?q |- _ => assert (P : 0 < q) by lra; assert (L : 0 < l) by (apply sqrt_lt_R0, P);
  assert (Q : q = l ^ 2) by (unfold l; rewrite pow2_sqrt; lra) end.
Theorem normal_by_beta__derivative : Statements.normal_by_beta__derivative.
Proof.
  red. intros. assert (P : 0 < m_x ^ 2 + m_y ^ 2 + m_z ^ 2) by lra. assert (r0 : 0 < m_length) by (apply sqrt_lt_R0; exact P).
  assert (r2 : m_length ^ 2 = m_x ^ 2 + m_y ^ 2 + m_z ^ 2) by (apply pow2_sqrt; lra).
  assert (D : forall g n, is_derive (fun b : R => (b * g + n) / sqrt ((b * g_x + normal_x) ^ 2 + (b * g_y + normal_y) ^ 2 + (b * g_z + normal_z) ^
    2)) beta
    ((g - m_scale * (beta * g + n) * (bumped_x * g_x + bumped_y * g_y + bumped_z * g_z)) / m_length)).
  { intros. auto_derive; simpl in *; fold m_x m_y m_z; fold m_length; [repeat split; lra|]. unfold bumped_x, bumped_y, bumped_z, m_scale.
    field_simplify_eq; [|lra].
    replace (m_length ^ 3) with (m_length * m_length ^ 2) by ring. simpl. rewrite r2. ring. }
  fold m_x m_y m_z. fold m_length. rewrite (is_derive_unique _ _ _ (D g_x normal_x)), (is_derive_unique _ _ _ (D g_y normal_y)), (is_derive_unique _ _
    _ (D g_z normal_z)).
  repeat split; first [lra | eexists; apply D].
Qed.
Theorem normal_by_beta__tangent_to_directions : Statements.normal_by_beta__tangent_to_directions.
Proof.
  red. intros. length_of m_length.
  each ltac:(first [direct | idtac]).
  transitivity ((m_x * g_x + m_y * g_y + m_z * g_z) * (m_length ^ 2 - (m_x ^ 2 + m_y ^ 2 + m_z ^ 2)) / m_length ^ 4); [|rewrite Q; field; lra].
  unfold bumped_by_beta_x, bumped_by_beta_y, bumped_by_beta_z, bumped_x, bumped_y, bumped_z, m_scale. field. lra.
Qed.
