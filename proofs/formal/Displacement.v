(* The derivative of N' by beta, the displaced surface's normal, and why the bumped one is another. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Vectors Bump.
Open Scope R_scope.

(* The derivative by beta *)

Section by_beta.
Variables nx ny nz gx gy gz beta : R.
Let m2 := (beta * gx + nx) ^ 2 + (beta * gy + ny) ^ 2 + (beta * gz + nz) ^ 2.
Let direction : vector :=
  (perturbed.bumped_x nx ny nz gx gy gz beta, perturbed.bumped_y nx ny nz gx gy gz beta, perturbed.bumped_z nx ny nz gx gy gz beta).
Let by_beta : vector :=
  (normal_by_beta.bumped_by_beta_x nx ny nz gx gy gz beta, normal_by_beta.bumped_by_beta_y nx ny nz gx gy gz beta,
   normal_by_beta.bumped_by_beta_z nx ny nz gx gy gz beta).

Ltac unfold_by_beta :=
  unfold dot, direction, by_beta, normal_by_beta.bumped_by_beta_x, normal_by_beta.bumped_by_beta_y, normal_by_beta.bumped_by_beta_z,
    normal_by_beta.bumped_x, normal_by_beta.bumped_y, normal_by_beta.bumped_z, normal_by_beta.m_scale, normal_by_beta.m_length,
    normal_by_beta.m_x, normal_by_beta.m_y, normal_by_beta.m_z,
    perturbed.bumped_x, perturbed.bumped_y, perturbed.bumped_z, perturbed.m_scale, perturbed.m_length,
    perturbed.m_x, perturbed.m_y, perturbed.m_z.

Lemma root (P : 0 < m2) : 0 < sqrt m2 /\ sqrt m2 ^ 2 = m2.
Proof. split; [apply sqrt_lt_R0; exact P | apply pow2_sqrt; lra]. Qed.

(* The derivative of N' by beta is (g - (N'.g) N')/|M|. *)
Theorem normal_by_beta__derivative : 0 < m2 ->
  let '(x, y, z) := by_beta in
  is_derive (fun b => perturbed.bumped_x nx ny nz gx gy gz b) beta x /\
  is_derive (fun b => perturbed.bumped_y nx ny nz gx gy gz b) beta y /\
  is_derive (fun b => perturbed.bumped_z nx ny nz gx gy gz b) beta z.
Proof.
  intro P. destruct (root P) as [r0 r2]. unfold by_beta. unfold_by_beta. unfold m2 in *.
  split; [|split]; auto_derive; simpl in *; set (r := sqrt _) in *;
    try (split; [lra | split; [lra | exact I]]); field_simplify_eq; try lra;
    replace (r ^ 3) with (r * (r * (r * 1))) by ring; replace (r ^ 2) with (r * (r * 1)) by ring; rewrite ?r2; ring.
Qed.

(* (I - N'N'^T) g / |M|, with M = N + beta g. *)
Theorem normal_by_beta__projection : let m := vector_sum (nx, ny, nz) (scaled beta (gx, gy, gz)) in
  by_beta = scaled (/ magnitude m) (difference (gx, gy, gz) (scaled (dot direction (gx, gy, gz)) direction)) /\ direction = scaled (/ magnitude m) m.
Proof.
  cbv zeta. unfold by_beta, direction, difference, magnitude, vector_sum, scaled. unfold_by_beta.
  replace ((nx + beta * gx) * (nx + beta * gx) + (ny + beta * gy) * (ny + beta * gy) + (nz + beta * gz) * (nz + beta * gz)) with m2 by (unfold m2; ring).
  fold m2. unfold Rdiv. split; repeat apply (f_equal2 pair); ring.
Qed.

(* It is tangent to the sphere of directions. *)
Theorem normal_by_beta__tangent_to_directions : 0 < m2 -> dot direction by_beta = 0.
Proof.
  intro P. destruct (root P) as [r0 r2]. unfold by_beta, direction. unfold_by_beta. unfold m2 in *. simpl in *. set (r := sqrt _) in *.
  field_simplify_eq; [|lra].
  replace (r ^ 3) with (r * (r * (r * 1))) by ring; replace (r ^ 2) with (r * (r * 1)) by ring; rewrite ?r2; ring.
Qed.
End by_beta.

Theorem normal_by_beta__derivative__point : exists nx ny nz gx gy gz beta,
  0 < (beta * gx + nx) ^ 2 + (beta * gy + ny) ^ 2 + (beta * gz + nz) ^ 2.
Proof. exists 1, 0, 0, 0, 0, 0, 0. lra. Qed.
Theorem normal_by_beta__projection__false : ~ forall nx ny nz gx gy gz beta, normal_by_beta.bumped_by_beta_x nx ny nz gx gy gz beta =
  gx / magnitude (vector_sum (nx, ny, nz) (scaled beta (gx, gy, gz))).
Proof.
  intro H. generalize (H 1 0 0 1 0 0 0). unfold normal_by_beta.bumped_by_beta_x, normal_by_beta.bumped_x, normal_by_beta.bumped_y, normal_by_beta.bumped_z, normal_by_beta.m_scale,
    normal_by_beta.m_length, normal_by_beta.m_x, normal_by_beta.m_y, normal_by_beta.m_z.
  replace (vector_sum (1, 0, 0) (scaled 0 (1, 0, 0))) with ((1, 0, 0) : vector) by (unfold vector_sum, scaled; f_equal; [f_equal|]; ring). rewrite (length_of_unit (1, 0, 0)) by (unfold dot; ring).
  replace ((0 * 1 + 1) ^ 2 + (0 * 0 + 0) ^ 2 + (0 * 0 + 0) ^ 2) with 1 by ring. rewrite sqrt_1. lra.
Qed.
(* It is not g/|M|. *)
Theorem normal_by_beta__derivative__false : ~ forall gx beta, is_derive (fun b => perturbed.bumped_x 0 0 1 gx 0 0 b) beta (gx / sqrt (1 + (beta * gx) ^ 2)).
Proof.
  intro H. generalize (H 1 1). intro D. destruct (normal_by_beta__derivative 0 0 1 1 0 0 1) as [E _]; [lra|].
  generalize (is_derive_unique _ _ _ D) (is_derive_unique _ _ _ E). intros -> F.
  unfold normal_by_beta.bumped_by_beta_x, normal_by_beta.bumped_x, normal_by_beta.bumped_y, normal_by_beta.bumped_z, normal_by_beta.m_scale,
    normal_by_beta.m_length, normal_by_beta.m_x, normal_by_beta.m_y, normal_by_beta.m_z in F. 
  replace (1 + (1 * 1) ^ 2) with 2 in F by ring. replace ((1 * 1 + 0) ^ 2 + (1 * 0 + 0) ^ 2 + (1 * 0 + 1) ^ 2) with 2 in F by ring.
  assert (P : 0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (Q : sqrt 2 ^ 2 = 2) by (apply pow2_sqrt; lra).
  apply (f_equal (fun t => t * sqrt 2 ^ 3)) in F. field_simplify in F; lra || nra.
Qed.

(* The displaced surface *)

Section displaced.
Variables theta phi h_u h_v beta : R.

Definition displaced (h : R) : vector :=
  (displaced_normal.displaced_x (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta h,
   displaced_normal.displaced_y (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta h,
   displaced_normal.displaced_z (cos phi) (sin phi) h_u h_v beta h).
Definition B : vector :=
  (blinn_normal.displaced_x (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta,
   blinn_normal.displaced_y (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta,
   blinn_normal.displaced_z (cos phi) (sin phi) h_u h_v beta).
Definition G : vector := vector_sum (scaled (h_u / (2 * PI * sin phi)) (e_theta theta)) (scaled (h_v / PI) (e_phi theta phi)).
End displaced.

Ltac unfold_displaced :=
  unfold displaced, B, G, displaced_normal.displaced_x, displaced_normal.displaced_y, displaced_normal.displaced_z, displaced_normal.lift,
    displaced_normal.normal_x, displaced_normal.normal_y, displaced_normal.normal_z, displaced_normal.e_theta_x, displaced_normal.e_theta_y,
    displaced_normal.e_theta_z, displaced_normal.e_phi_x, displaced_normal.e_phi_y, displaced_normal.e_phi_z, displaced_normal.h_theta,
    displaced_normal.h_phi, blinn_normal.displaced_x, blinn_normal.displaced_y, blinn_normal.displaced_z, blinn_normal.lift,
    blinn_normal.normal_x, blinn_normal.normal_y, blinn_normal.normal_z, blinn_normal.e_theta_x, blinn_normal.e_theta_y,
    blinn_normal.e_theta_z, blinn_normal.e_phi_x, blinn_normal.e_phi_y, blinn_normal.e_phi_z, blinn_normal.h_theta, blinn_normal.h_phi.

Lemma displaced_in_frame (theta phi h_u h_v beta h : R) : 0 < sin phi ->
  displaced theta phi h_u h_v beta h = vector_sum (scaled (1 + beta * h) (normal_at theta phi)) (scaled (- beta) (G theta phi h_u h_v)).
Proof. intro S. generalize PI_RGT_0. intro. unfold_displaced. unfold_vectors. f_equal; [f_equal|]; field; lra. Qed.

Lemma blinn_in_frame (theta phi h_u h_v beta : R) : 0 < sin phi ->
  B theta phi h_u h_v beta = vector_sum (normal_at theta phi) (scaled (- beta) (G theta phi h_u h_v)).
Proof. intro S. generalize PI_RGT_0. intro. unfold_displaced. unfold_vectors. f_equal; [f_equal|]; field; lra. Qed.

Lemma slopes_are_tangent (theta phi h_u h_v : R) : dot (normal_at theta phi) (G theta phi h_u h_v) = 0.
Proof. unfold G. rewrite dot_comm, dot_sum, !dot_scaled, !(dot_comm _ (normal_at _ _)).
  destruct (tangent_frame_orthonormal theta phi) as (_ & _ & _ & _ & E & F).
  rewrite (dot_comm (normal_at _ _)), E, (dot_comm (normal_at _ _)), F. ring.
Qed.

(* D.N = 1 + beta h > 0: outwards. *)
Theorem displaced_normal__outward (theta phi h_u h_v beta h : R) : 0 < sin phi -> 0 < 1 + beta * h ->
  dot (displaced theta phi h_u h_v beta h) (normal_at theta phi) = 1 + beta * h /\ 0 < dot (displaced theta phi h_u h_v beta h) (normal_at theta phi).
Proof.
  intros S L. rewrite displaced_in_frame, dot_sum, !dot_scaled, normal_is_unit, (dot_comm (G _ _ _ _)), slopes_are_tangent by exact S.
  split; lra.
Qed.
Theorem displaced_normal__outward__false : ~ forall theta phi h_u h_v beta h, 0 < sin phi -> 0 < 1 + beta * h -> dot (displaced theta phi h_u h_v beta h) (normal_at theta phi) = 1.
Proof.
  assert (S : 0 < sin (PI / 2)) by (rewrite sin_PI2; lra). intro H. generalize (H 0 (PI / 2) 0 0 1 1 S ltac:(lra)).
  rewrite (proj1 (displaced_normal__outward 0 (PI / 2) 0 0 1 1 S ltac:(lra))). lra.
Qed.
(* D = (1 + beta h)N - beta G, and Blinn's B = N - beta G. *)
Theorem displaced_normal__frame (theta phi h_u h_v beta h : R) : 0 < sin phi ->
  displaced theta phi h_u h_v beta h = vector_sum (scaled (1 + beta * h) (normal_at theta phi)) (scaled (- beta) (G theta phi h_u h_v)) /\
  B theta phi h_u h_v beta = vector_sum (normal_at theta phi) (scaled (- beta) (G theta phi h_u h_v)).
Proof. intro S. split; [apply displaced_in_frame | apply blinn_in_frame]; exact S. Qed.
Theorem displaced_normal__frame__point : exists phi, 0 < sin phi.
Proof. exists (PI / 2). rewrite sin_PI2. lra. Qed.
Theorem displaced_normal__frame__false : ~ forall theta phi h_u h_v beta h, 0 < sin phi -> displaced theta phi h_u h_v beta h = B theta phi h_u h_v beta.
Proof.
  assert (S : 0 < sin (PI / 2)) by (rewrite sin_PI2; lra). intro H. generalize (H 0 (PI / 2) 0 0 1 1 S) (proj1 (displaced_normal__outward 0 (PI / 2) 0 0 1 1 S ltac:(lra))).
  intros ->. rewrite blinn_in_frame, dot_sum, dot_scaled, normal_is_unit, (dot_comm (G _ _ _ _)), slopes_are_tangent by exact S. lra.
Qed.
Theorem displaced_normal__outward__point : exists phi beta h, 0 < sin phi /\ 0 < 1 + beta * h.
Proof. exists (PI / 2), 0, 0. rewrite sin_PI2. lra. Qed.

(* D x B = - beta^2 h N x G: the same direction to first order in beta. *)
Theorem displaced_normal__first_order (theta phi h_u h_v beta h : R) : 0 < sin phi ->
  cross (displaced theta phi h_u h_v beta h) (B theta phi h_u h_v beta) = scaled (- beta ^ 2 * h) (cross (normal_at theta phi) (G theta phi h_u h_v)).
Proof.
  intro S. rewrite displaced_in_frame, blinn_in_frame by exact S. destruct (normal_at theta phi) as [[? ?] ?], (G theta phi h_u h_v) as [[? ?] ?].
  unfold cross, vector_sum, scaled. f_equal; [f_equal|]; ring.
Qed.
Theorem displaced_normal__first_order__false : ~ forall theta phi h_u h_v beta h, 0 < sin phi ->
  cross (displaced theta phi h_u h_v beta h) (B theta phi h_u h_v beta) = zero_vector.
Proof.
  intro H. generalize (H 0 (PI / 2) PI 0 1 1). rewrite displaced_normal__first_order by (rewrite sin_PI2; lra).
  unfold_displaced. unfold zero_vector. unfold_vectors. rewrite sin_PI2, cos_PI2, sin_0, cos_0. intro E. generalize PI_RGT_0. intro P.
  assert (Q : 0 < 1) by lra. specialize (E Q). apply (f_equal snd) in E. cbn [snd] in E. apply (f_equal (fun t => t * 2 * PI)) in E. field_simplify in E; lra.
Qed.

(* The surface (1 + beta h) N over the unit sphere, h over the chart. *)
Definition surface (h : R -> R -> R) (beta theta phi : R) : vector :=
  scaled (1 + beta * h ((theta + PI) / (2 * PI)) (phi / PI)) (normal_at theta phi).
Definition derivative_of (f : R -> vector) (x : R) : vector :=
  (Derive (fun t => fst (fst (f t))) x, Derive (fun t => snd (fst (f t))) x, Derive (fun t => snd (f t)) x).

(* by phi x by theta = (1 + beta h) sin phi D. *)
Theorem displaced_normal__product (h : R -> R -> R) (theta phi h_u h_v beta : R) :
  let u := (theta + PI) / (2 * PI) in let v := phi / PI in
  0 < sin phi -> is_derive (fun u => h u v) u h_u -> is_derive (fun v => h u v) v h_v ->
  cross (derivative_of (surface h beta theta) phi) (derivative_of (fun t => surface h beta t phi) theta) =
  scaled ((1 + beta * h u v) * sin phi) (displaced theta phi h_u h_v beta (h u v)).
Proof.
  cbv zeta. intros S U V. generalize PI_RGT_0. intro P.
  assert (E : forall (f : R -> R) c (b : R), is_derive f b c -> forall x, is_derive (fun t => f x) b 0) by (intros; auto_derive; trivial).
  assert (W : is_derive (fun t => h ((theta + PI) / (2 * PI)) (t / PI)) phi (h_v / PI)).
  { replace (h_v / PI) with (scal (/ PI) h_v) by (unfold scal; simpl; unfold mult; simpl; field; lra).
    apply (is_derive_comp (fun v => h ((theta + PI) / (2 * PI)) v) (fun t => t / PI)); [exact V | auto_derive; trivial; lra]. }
  assert (X : is_derive (fun t => h ((t + PI) / (2 * PI)) (phi / PI)) theta (h_u / (2 * PI))).
  { replace (h_u / (2 * PI)) with (scal (/ (2 * PI)) h_u) by (unfold scal; simpl; unfold mult; simpl; field; lra).
    apply (is_derive_comp (fun u => h u (phi / PI)) (fun t => (t + PI) / (2 * PI))); [exact U | auto_derive; trivial; field; lra]. }
  clear E. set (c := h ((theta + PI) / (2 * PI)) (phi / PI)) in *.
  assert (K : forall (f g : R -> R) x a b, is_derive f x a -> is_derive g x b -> Derive (fun t => (1 + beta * f t) * g t) x = beta * a * g x + (1 + beta * f x) * b).
  { intros f g x a b Hf Hg. apply is_derive_unique. auto_derive; [split; [exists a | split; [exists b|]]; trivial|].
    replace (Derive (fun t => f t) x) with a by (symmetry; apply is_derive_unique; exact Hf).
    replace (Derive (fun t => g t) x) with b by (symmetry; apply is_derive_unique; exact Hg). ring. }
  assert (A : derivative_of (surface h beta theta) phi = vector_sum (scaled (beta * (h_v / PI)) (normal_at theta phi)) (scaled (1 + beta * c) (e_phi theta phi))).
  { destruct (e_phi theta phi) as [[ex ey] ez] eqn:Ee. generalize (tangent_frame__by_phi theta phi). rewrite Ee. intros (Hx & Hy & Hz).
    unfold derivative_of, surface. unfold_vectors.
    rewrite (K _ _ _ _ _ W Hx), (K _ _ _ _ _ W Hy), (K _ _ _ _ _ W Hz). reflexivity. }
  assert (T : derivative_of (fun t => surface h beta t phi) theta = vector_sum (scaled (beta * (h_u / (2 * PI))) (normal_at theta phi)) (scaled ((1 + beta * c) * sin phi) (e_theta theta))).
  { generalize (tangent_frame__by_theta theta phi). unfold derivative_of, surface. unfold_vectors. intros (Hx & Hy & Hz).
    rewrite (K _ _ _ _ _ X Hx), (K _ _ _ _ _ X Hy), (K _ _ _ _ _ X Hz). f_equal; [f_equal|]; fold c; ring. }
  rewrite A, T, displaced_in_frame by exact S. unfold G. unfold_vectors. f_equal; [f_equal|]; field_simplify_eq; try lra; ring [(sin_squared theta) (sin_squared phi)].
Qed.

(* Why the bumped normal is not the displaced one *)

Lemma bump_along_slopes (theta phi h_u h_v : R) : 0 < sin phi ->
  dot (g theta phi h_u h_v) (G theta phi h_u h_v) = h_u ^ 2 / (2 * PI * sin phi) + h_v ^ 2 / PI /\
  dot (G theta phi h_u h_v) (G theta phi h_u h_v) = h_u ^ 2 / (4 * PI ^ 2 * sin phi ^ 2) + h_v ^ 2 / PI ^ 2.
Proof.
  intro S. generalize PI_RGT_0. intro P. destruct (tangent_frame_orthonormal theta phi) as (E & F & _ & H & _ & _).
  assert (I : g theta phi h_u h_v = vector_sum (scaled h_u (e_theta theta)) (scaled h_v (e_phi theta phi))) by (unfold_vectors; f_equal; [f_equal|]; ring).
  rewrite I. unfold G. rewrite !dot_sum, !dot_scaled, !(dot_comm _ (vector_sum _ _)), !dot_sum, !dot_scaled, E, F, (dot_comm (e_phi _ _)), H.
  split; field; lra.
Qed.

(* Where 1 + beta h > 0: the cosine of the angle between M and D. *)
Theorem bump_is_not_displacement__angle (theta phi h_u h_v beta h : R) : 0 < sin phi ->
  dot (M theta phi h_u h_v beta) (displaced theta phi h_u h_v beta h) = 1 + beta * h - beta ^ 2 * (h_u ^ 2 / (2 * PI * sin phi) + h_v ^ 2 / PI) /\
  dot (M theta phi h_u h_v beta) (M theta phi h_u h_v beta) = 1 + beta ^ 2 * (h_u ^ 2 + h_v ^ 2) /\
  dot (displaced theta phi h_u h_v beta h) (displaced theta phi h_u h_v beta h) =
    (1 + beta * h) ^ 2 + beta ^ 2 * (h_u ^ 2 / (4 * PI ^ 2 * sin phi ^ 2) + h_v ^ 2 / PI ^ 2).
Proof.
  intro S. destruct (bump_along_slopes theta phi h_u h_v S) as [E F].
  split; [|split; [apply m_squared|]].
  - rewrite m_is_sum, displaced_in_frame by exact S.
    rewrite dot_sum, !(dot_comm _ (vector_sum _ _)), !dot_sum, !dot_scaled, !(dot_comm _ (scaled _ _)), !dot_scaled, normal_is_unit, ?(dot_comm (G _ _ _ _) (normal_at _ _)),
      ?(dot_comm (g _ _ _ _) (normal_at _ _)), ?(dot_comm (G _ _ _ _) (g _ _ _ _)), slopes_are_tangent, g_is_tangent, E. ring.
  - rewrite displaced_in_frame by exact S.
    rewrite dot_sum, !dot_scaled, !(dot_comm _ (vector_sum _ _)), !dot_sum, !dot_scaled, normal_is_unit, ?(dot_comm (G _ _ _ _) (normal_at _ _)), slopes_are_tangent, F. ring.
Qed.

(* If 1 + beta h > 0, M and D are parallel exactly where beta g = 0. *)
Theorem bump_is_not_displacement__only_where_flat (theta phi h_u h_v beta h : R) : 0 < sin phi -> 0 < 1 + beta * h ->
  (cross (M theta phi h_u h_v beta) (displaced theta phi h_u h_v beta h) = zero_vector <-> scaled beta (g theta phi h_u h_v) = zero_vector).
Proof.
  intros S L. generalize PI_RGT_0. intro P.
  assert (I : g theta phi h_u h_v = vector_sum (scaled h_u (e_theta theta)) (scaled h_v (e_phi theta phi))) by (unfold_vectors; f_equal; [f_equal|]; ring).
  split; intro E.
  - assert (U : dot (cross (M theta phi h_u h_v beta) (displaced theta phi h_u h_v beta h)) (e_phi theta phi) = beta * h_u * (1 + beta * h + / (2 * PI * sin phi))).
    { rewrite displaced_in_frame by exact S. unfold G. unfold_vectors. field_simplify_eq; [|lra]. ring [(sin_squared theta) (sin_squared phi)]. }
    assert (V : dot (cross (M theta phi h_u h_v beta) (displaced theta phi h_u h_v beta h)) (e_theta theta) = - beta * h_v * (1 + beta * h + / PI)).
    { rewrite displaced_in_frame by exact S. unfold G. unfold_vectors. field_simplify_eq; [|lra]. ring [(sin_squared theta) (sin_squared phi)]. }
    rewrite E in U, V. assert (Z : forall a, dot zero_vector a = 0) by (intros [[? ?] ?]; unfold dot, zero_vector; ring). rewrite Z in U, V.
    assert (0 < / (2 * PI * sin phi)) by (apply Rinv_0_lt_compat; nra). assert (0 < / PI) by (apply Rinv_0_lt_compat; lra).
    assert (A : beta * h_u = 0) by (symmetry in U; apply Rmult_integral in U; destruct U; lra).
    assert (C : beta * h_v = 0) by (symmetry in V; apply Rmult_integral in V; destruct V; lra).
    rewrite I. unfold zero_vector. unfold_vectors. f_equal; [f_equal|]; ring [A C].
  - assert (A : beta * h_u = 0 /\ beta * h_v = 0).
    { assert (Q : dot (scaled beta (g theta phi h_u h_v)) (scaled beta (g theta phi h_u h_v)) = (beta * h_u) ^ 2 + (beta * h_v) ^ 2).
      { rewrite dot_scaled, dot_comm, dot_scaled, g_squared. ring. }
      rewrite E in Q. unfold zero_vector, dot in Q. generalize (pow2_ge_0 (beta * h_u)) (pow2_ge_0 (beta * h_v)). intros. split; apply Rsqr_0_uniq; unfold Rsqr; lra. }
    destruct A as [A C]. rewrite displaced_in_frame by exact S. unfold G, zero_vector. unfold_vectors.
    f_equal; [f_equal|]; unfold Rdiv; ring [A C].
Qed.
Theorem bump_is_not_displacement__only_where_flat__point : exists phi beta h, 0 < sin phi /\ 0 < 1 + beta * h.
Proof. exact displaced_normal__outward__point. Qed.
(* The seed's claim that they are always parallel. *)
Theorem bump_is_not_displacement__only_where_flat__false : ~ forall theta phi h_u h_v beta h, 0 < sin phi -> 0 < 1 + beta * h ->
  cross (M theta phi h_u h_v beta) (displaced theta phi h_u h_v beta h) = zero_vector.
Proof.
  intro H. assert (S : 0 < sin (PI / 2)) by (rewrite sin_PI2; lra). assert (L : 0 < 1 + 1 * 0) by lra.
  generalize (proj1 (bump_is_not_displacement__only_where_flat 0 (PI / 2) 1 0 1 0 S L) (H _ _ _ _ _ _ S L)).
  unfold zero_vector. unfold_vectors. rewrite sin_PI2, cos_PI2, sin_0, cos_0. intro E. injection E. lra.
Qed.
(* False variants: N is not normal to the direction's derivative; the product without its lift; the angle without its bump. *)
Theorem normal_by_beta__tangent_to_directions__false : ~ forall nx ny nz gx gy gz beta, 0 < (beta * gx + nx) ^ 2 + (beta * gy + ny) ^ 2 + (beta * gz + nz) ^ 2 ->
  dot (nx, ny, nz) (normal_by_beta.bumped_by_beta_x nx ny nz gx gy gz beta, normal_by_beta.bumped_by_beta_y nx ny nz gx gy gz beta,
    normal_by_beta.bumped_by_beta_z nx ny nz gx gy gz beta) = 0.
Proof.
  intro H. generalize (H 1 0 0 1 0 0 0 ltac:(lra)) (H 1 0 0 0 1 0 1 ltac:(lra)). intros _. unfold dot, normal_by_beta.bumped_by_beta_x, normal_by_beta.bumped_x, normal_by_beta.bumped_y,
    normal_by_beta.bumped_z, normal_by_beta.m_scale, normal_by_beta.m_length, normal_by_beta.m_x, normal_by_beta.m_y, normal_by_beta.m_z.
  replace ((1 * 0 + 1) ^ 2 + (1 * 1 + 0) ^ 2 + (1 * 0 + 0) ^ 2) with 2 by ring. assert (P : 0 < / sqrt 2) by (apply Rinv_0_lt_compat, sqrt_lt_R0; lra).
  unfold Rdiv. set (i := / sqrt 2) in *. clearbody i. assert (0 < i * i * i) by (repeat apply Rmult_lt_0_compat; exact P). lra.
Qed.
Theorem displaced_normal__product__false : ~ forall (h : R -> R -> R) (theta phi h_u h_v beta : R), let u := (theta + PI) / (2 * PI) in let v := phi / PI in
  0 < sin phi -> is_derive (fun u => h u v) u h_u -> is_derive (fun v => h u v) v h_v ->
  cross (derivative_of (surface h beta theta) phi) (derivative_of (fun t => surface h beta t phi) theta) = scaled (sin phi) (displaced theta phi h_u h_v beta (h u v)).
Proof.
  assert (S : 0 < sin (PI / 2)) by (rewrite sin_PI2; lra).
  assert (K : forall x : R, is_derive (fun _ : R => 1) x 0) by (intro x; apply (is_derive_const 1 x)).
  intro H. generalize (H (fun _ _ => 1) 0 (PI / 2) 0 0 1 S (K _) (K _)) (displaced_normal__product (fun _ _ => 1) 0 (PI / 2) 0 0 1 S (K _) (K _)). cbv zeta. intros -> E.
  apply (f_equal (fun a => dot a (normal_at 0 (PI / 2)))) in E. rewrite !dot_scaled, (proj1 (displaced_normal__outward 0 (PI / 2) 0 0 1 1 S ltac:(lra))) in E. rewrite sin_PI2 in E. lra.
Qed.
Theorem bump_is_not_displacement__angle__false : ~ forall theta phi h_u h_v beta h, 0 < sin phi -> dot (M theta phi h_u h_v beta) (displaced theta phi h_u h_v beta h) = 1 + beta * h.
Proof.
  assert (S : 0 < sin (PI / 2)) by (rewrite sin_PI2; lra). intro H. generalize (H 0 (PI / 2) 0 1 1 0 S) (proj1 (bump_is_not_displacement__angle 0 (PI / 2) 0 1 1 0 S)). intros -> E.
  assert (P : 0 < 1 ^ 2 / PI) by (apply Rdiv_lt_0_compat; [lra | apply PI_RGT_0]). unfold Rdiv in *. lra.
Qed.
