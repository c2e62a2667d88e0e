(* Vectors of three real numbers, and the chapter's vectors by their angles, out of the printed formulas. *)

From Coq Require Import Reals Lra.
From Formal Require Import Formulas.
Open Scope R_scope.

Definition vector : Type := R * R * R.

Definition dot (a b : vector) := let '(ax, ay, az) := a in let '(bx, by_, bz) := b in ax * bx + ay * by_ + az * bz.

Definition cross (a b : vector) : vector :=
  let '(ax, ay, az) := a in let '(bx, by_, bz) := b in (ay * bz - az * by_, az * bx - ax * bz, ax * by_ - ay * bx).

Definition scaled (s : R) (a : vector) : vector := let '(x, y, z) := a in (s * x, s * y, s * z).
Definition vector_sum (a b : vector) : vector :=
  let '(ax, ay, az) := a in let '(bx, by_, bz) := b in (ax + bx, ay + by_, az + bz).
Definition difference (a b : vector) : vector := vector_sum a (scaled (-1) b).
Definition magnitude (a : vector) := sqrt (dot a a).

(* The unit normal N and the tangent frame of the sphere at the angles theta and phi. *)
Definition normal_at (theta phi : R) : vector :=
  (unit_normal.normal_x (cos theta) (sin phi), unit_normal.normal_y (sin theta) (sin phi),
   unit_normal.normal_z (cos phi)).
Definition e_theta (theta : R) : vector :=
  (tangent_frame.e_theta_x (sin theta), tangent_frame.e_theta_y (cos theta), tangent_frame.e_theta_z).
Definition e_phi (theta phi : R) : vector :=
  (tangent_frame.e_phi_x (cos theta) (cos phi), tangent_frame.e_phi_y (sin theta) (cos phi),
   tangent_frame.e_phi_z (sin phi)).

(* The bump: g, M = N + beta g, and N' = M/|M|, for a height with the slopes h_u and h_v. *)
Section bump.
Variables theta phi h_u h_v beta : R.
Definition g : vector :=
  (bumped_normal.g_x (cos theta) (sin theta) (cos phi) h_u h_v, bumped_normal.g_y (cos theta) (sin theta) (cos phi) h_u h_v,
   bumped_normal.g_z (sin phi) h_u h_v).
Definition M : vector :=
  (bumped_normal.m_x (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta,
   bumped_normal.m_y (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta,
   bumped_normal.m_z (cos phi) (sin phi) h_u h_v beta).
Definition N' : vector :=
  (bumped_normal.bumped_x (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta,
   bumped_normal.bumped_y (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta,
   bumped_normal.bumped_z (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta).
End bump.

Lemma sin_squared a : sin a ^ 2 = 1 - cos a ^ 2.
Proof. generalize (sin2_cos2 a). unfold Rsqr. lra. Qed.

(* The printed directions with the light and the eye straight above. *)
Lemma above : light_direction.towards_x 0 0 0 0 0 1 = 0 /\ light_direction.towards_y 0 0 0 0 0 1 = 0 /\ light_direction.towards_z 0 0 0 0 0 1 = 1.
Proof.
  light_direction.lines. replace ((0 - 0) ^ 2 + (0 - 0) ^ 2 + (1 - 0) ^ 2) with 1 by ring. rewrite sqrt_1, Rinv_1. repeat split; ring.
Qed.
Lemma halfway_above : blinn.halfway_length 0 0 0 0 0 1 0 0 1 = 2.
Proof.
  destruct above as (X & Y & Z). change (sqrt ((light_direction.towards_x 0 0 0 0 0 1 + 0) ^ 2 + (light_direction.towards_y 0 0 0 0 0 1 + 0) ^ 2 +
    (light_direction.towards_z 0 0 0 0 0 1 + 1) ^ 2) = 2).
  rewrite X, Y, Z. replace (_ + _) with (2 ^ 2) by ring. apply sqrt_pow2. lra.
Qed.
