(* Vectors, the tangent frame, the bumped normal N' and its angle to N. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Formulas Vectors BumpClaims.
Open Scope R_scope.

Ltac unfold_vectors :=
  unfold magnitude, difference, vector_sum, scaled, cross, dot, normal_at, e_theta, e_phi, g, M, N' in *; cbv [fst snd] in *;
  unfold unit_normal.normal_x, unit_normal.normal_y, unit_normal.normal_z,
    tangent_frame.e_theta_x, tangent_frame.e_theta_y, tangent_frame.e_theta_z,
    tangent_frame.e_phi_x, tangent_frame.e_phi_y, tangent_frame.e_phi_z,
    bumped_normal.bumped_x, bumped_normal.bumped_y, bumped_normal.bumped_z,
    bumped_normal.m_scale, bumped_normal.m_length,
    bumped_normal.m_x, bumped_normal.m_y, bumped_normal.m_z,
    bumped_normal.g_x, bumped_normal.g_y, bumped_normal.g_z,
    bumped_normal.normal_x, bumped_normal.normal_y, bumped_normal.normal_z,
    bumped_normal.e_theta_x, bumped_normal.e_theta_y, bumped_normal.e_theta_z,
    bumped_normal.e_phi_x, bumped_normal.e_phi_y, bumped_normal.e_phi_z in *.
Ltac ring_of_angles theta phi := unfold_vectors; ring [(sin_squared theta) (sin_squared phi)].

(* The tangent frame *)

(* e_phi is the derivative of N by phi. *)
Lemma frame_by_phi (theta phi : R) :
  let '(x, y, z) := e_phi theta phi in
  is_derive (fun p => fst (fst (normal_at theta p))) phi x /\ is_derive (fun p => snd (fst (normal_at theta p))) phi y /\
  is_derive (fun p => snd (normal_at theta p)) phi z.
Proof. unfold_vectors. split; [|split]; auto_derive; trivial; ring. Qed.

(* sin phi e_theta is the derivative of N by theta. *)
Lemma frame_by_theta (theta phi : R) :
  let '(x, y, z) := scaled (sin phi) (e_theta theta) in
  is_derive (fun t => fst (fst (normal_at t phi))) theta x /\ is_derive (fun t => snd (fst (normal_at t phi))) theta y /\
  is_derive (fun t => snd (normal_at t phi)) theta z.
Proof. unfold_vectors. split; [|split]; auto_derive; trivial; ring. Qed.

(* Normalising *)

Lemma length_of_unit a : dot a a = 1 -> magnitude a = 1.
Proof. intro E. unfold magnitude. rewrite E. apply sqrt_1. Qed.

Lemma g_is_tangent theta phi h_u h_v : dot (normal_at theta phi) (g theta phi h_u h_v) = 0.
Proof. ring_of_angles theta phi. Qed.

Lemma g_squared theta phi h_u h_v : dot (g theta phi h_u h_v) (g theta phi h_u h_v) = h_u ^ 2 + h_v ^ 2.
Proof. ring_of_angles theta phi. Qed.

Lemma m_squared theta phi h_u h_v beta : dot (M theta phi h_u h_v beta) (M theta phi h_u h_v beta) = 1 + beta ^ 2 * (h_u ^ 2 + h_v ^ 2).
Proof. ring_of_angles theta phi. Qed.

Lemma m_squared_at_least_1 theta phi h_u h_v beta : 1 <= dot (M theta phi h_u h_v beta) (M theta phi h_u h_v beta).
Proof. rewrite m_squared. generalize (pow2_ge_0 (beta * h_u)) (pow2_ge_0 (beta * h_v)). nra. Qed.

Lemma m_length_at_least_1 theta phi h_u h_v beta : 1 <= magnitude (M theta phi h_u h_v beta).
Proof. unfold magnitude. rewrite <- sqrt_1. apply sqrt_le_1_alt, m_squared_at_least_1. Qed.

Lemma length_squared a : magnitude a ^ 2 = dot a a.
Proof.
  destruct a as [[x y] z]. unfold magnitude, dot. rewrite <- Rsqr_pow2. apply Rsqr_sqrt.
  generalize (Rle_0_sqr x) (Rle_0_sqr y) (Rle_0_sqr z). unfold Rsqr. lra.
Qed.

Lemma bumped_is_scaled theta phi h_u h_v beta : N' theta phi h_u h_v beta = scaled (/ magnitude (M theta phi h_u h_v beta)) (M theta phi h_u h_v
  beta).
Proof.
  assert (E : bumped_normal.m_length (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta =
    magnitude (M theta phi h_u h_v beta)).
  { unfold magnitude, bumped_normal.m_length, dot, M. f_equal. ring. }
  unfold N', scaled, M. unfold bumped_normal.bumped_x, bumped_normal.bumped_y, bumped_normal.bumped_z, bumped_normal.m_scale.
  rewrite E. reflexivity.
Qed.

Lemma dot_scaled s a b : dot (scaled s a) b = s * dot a b.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. unfold dot, scaled. ring. Qed.
Lemma dot_comm a b : dot a b = dot b a.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. unfold dot. ring. Qed.
Lemma dot_sum a b c : dot (vector_sum a b) c = dot a c + dot b c.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?], c as [[? ?] ?]. unfold dot, vector_sum. ring. Qed.
Lemma length_nonneg a : 0 <= magnitude a.
Proof. apply sqrt_pos. Qed.
Lemma m_is_sum theta phi h_u h_v beta : M theta phi h_u h_v beta = vector_sum (normal_at theta phi) (scaled beta (g theta phi h_u h_v)).
Proof. unfold_vectors. f_equal; [f_equal|]; ring. Qed.
Lemma normal_is_unit theta phi : dot (normal_at theta phi) (normal_at theta phi) = 1.
Proof. ring_of_angles theta phi. Qed.

(* |M|^2 = 1 + beta^2 |g|^2 >= 1 and |N'| = 1, for every beta. *)
Lemma unit_length_length theta phi h_u h_v beta : let m := M theta phi h_u h_v beta in dot m m = 1 + beta ^ 2 * dot (g theta phi h_u h_v) (g theta
  phi h_u h_v) /\ 1 <= dot m m /\ magnitude (N' theta phi h_u h_v beta) = 1.
Proof.
  cbv zeta. rewrite g_squared. split; [apply m_squared|]. split; [apply m_squared_at_least_1|].
  unfold magnitude at 1. rewrite bumped_is_scaled, dot_scaled, dot_comm, dot_scaled, <- length_squared.
  generalize (m_length_at_least_1 theta phi h_u h_v beta). intro. rewrite <- sqrt_1. f_equal. field. lra.
Qed.

Lemma cauchy_schwarz a b : dot a b <= magnitude a * magnitude b /\ - (magnitude a * magnitude b) <= dot a b.
Proof.
  assert (L : dot a b ^ 2 <= (magnitude a * magnitude b) ^ 2).
  { rewrite Rpow_mult_distr, !length_squared. destruct a as [[ax ay] az], b as [[bx by_] bz]. unfold dot.
    generalize (pow2_ge_0 (ax * by_ - ay * bx)) (pow2_ge_0 (ay * bz - az * by_)) (pow2_ge_0 (az * bx - ax * bz)). nra. }
  assert (P : 0 <= magnitude a * magnitude b) by (apply Rmult_le_pos; apply length_nonneg).
  split; nra.
Qed.

(* For |a|, |b| >= 1: |a/|a| - b/|b|| <= min(|a - b|, 2). *)
Lemma normalised_apart a b : 1 <= magnitude a -> 1 <= magnitude b -> magnitude (difference (scaled (/ magnitude a) a) (scaled (/ magnitude b) b))
  <= Rmin (magnitude (difference a b)) 2.
Proof.
  destruct a as [[ax ay] az] eqn:A, b as [[bx by_] bz] eqn:B. rewrite <- A, <- B. intros La Lb. set (d := difference (scaled _ _) _).
  destruct (normalising_is_lipschitz__normalise ax ay az (magnitude (difference a b)) bx by_ bz (magnitude a) (magnitude b) (dot a b) (magnitude d))
    as (_ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & E & _ & F);
    try (apply Rle_ge; assumption || apply length_nonneg); rewrite ?length_squared; subst a b; [unfold d, difference, vector_sum, scaled, dot,
      Rdiv; ring..|].
  apply Rmin_glb; lra.
Qed.

(* The change of N' with that of g: |N'_1 - N'_2| <= min(|beta| |g_1 - g_2|, 2). *)
Lemma length_scaled s a : magnitude (scaled s a) = Rabs s * magnitude a.
Proof.
  unfold magnitude. rewrite dot_scaled, dot_comm, dot_scaled, <- Rmult_assoc.
  rewrite sqrt_mult_alt by (generalize (pow2_ge_0 s); nra). f_equal. apply sqrt_Rsqr_abs.
Qed.
Lemma bump_moved theta phi a_u a_v b_u b_v beta : magnitude (difference (M theta phi a_u a_v beta) (M theta phi b_u b_v beta)) = Rabs beta *
  magnitude (difference (g theta phi a_u a_v) (g theta phi b_u b_v)) /\ magnitude (difference (N' theta phi a_u a_v beta) (N' theta phi b_u b_v
  beta)) <= Rmin (Rabs beta * magnitude (difference (g theta phi a_u a_v) (g theta phi b_u b_v))) 2.
Proof.
  rewrite !bumped_is_scaled, <- length_scaled.
  replace (scaled beta (difference (g theta phi a_u a_v) (g theta phi b_u b_v)))
    with (difference (M theta phi a_u a_v beta) (M theta phi b_u b_v beta)) by (unfold_vectors; f_equal; [f_equal|]; ring).
  split; [reflexivity | apply normalised_apart; apply m_length_at_least_1].
Qed.
(* The angle between N and N' *)

(* N.N' = 1/|M| > 0. *)
Lemma normal_dot_bumped theta phi h_u h_v beta : dot (normal_at theta phi) (N' theta phi h_u h_v beta) = / magnitude (M theta phi h_u h_v beta).
Proof.
  rewrite bumped_is_scaled, dot_comm, dot_scaled, dot_comm, m_is_sum, dot_comm, dot_sum, dot_scaled, (dot_comm (g _ _ _ _)), g_is_tangent,
    normal_is_unit. ring.
Qed.

(* The angle is arctan(|beta| |g|): its cosine is N.N'. *)
Theorem angle_of_the_bump__arctangent theta phi h_u h_v beta : acos (dot (normal_at theta phi) (N' theta phi h_u h_v beta)) = atan (Rabs beta *
  magnitude (g theta phi h_u h_v)).
Proof.
  set (t := Rabs beta * magnitude (g theta phi h_u h_v)).
  assert (T : t ^ 2 = beta ^ 2 * (h_u ^ 2 + h_v ^ 2)).
  { unfold t. rewrite Rpow_mult_distr, length_squared, g_squared, <- (pow2_abs beta). reflexivity. }
  assert (T0 : 0 <= t) by (unfold t; apply Rmult_le_pos; [apply Rabs_pos | apply length_nonneg]).
  rewrite normal_dot_bumped. replace (/ magnitude (M theta phi h_u h_v beta)) with (cos (atan t)).
  - apply acos_cos. generalize (atan_bound t). split; [|generalize PI_RGT_0; lra].
    destruct T0 as [P|P]; [left; rewrite <- atan_0; apply atan_increasing; exact P | rewrite <- P, atan_0; lra].
  - rewrite cos_atan. unfold magnitude. rewrite m_squared. unfold Rdiv. rewrite Rmult_1_l. do 2 f_equal. unfold Rsqr. lra.
Qed.
