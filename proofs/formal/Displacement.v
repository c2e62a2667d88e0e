(* The derivative of N' by beta, the displaced surface's normal, and why the bumped one is another. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Vectors Claim Bump BumpClaims Derivatives.
From Formal Require Statements.
Open Scope R_scope.

(* The derivative of the printed N' by beta is what is printed for it. *)
Section by_beta.
Variables nx ny nz gx gy gz beta : R.
Let m2 := (beta * gx + nx) ^ 2 + (beta * gy + ny) ^ 2 + (beta * gz + nz) ^ 2.
Lemma bumped_derives : 0 < m2 ->
  is_derive (fun b => perturbed.bumped_x nx ny nz gx gy gz b) beta (normal_by_beta.bumped_by_beta_x nx ny nz gx gy gz beta) /\
  is_derive (fun b => perturbed.bumped_y nx ny nz gx gy gz b) beta (normal_by_beta.bumped_by_beta_y nx ny nz gx gy gz beta) /\
  is_derive (fun b => perturbed.bumped_z nx ny nz gx gy gz b) beta (normal_by_beta.bumped_by_beta_z nx ny nz gx gy gz beta).
Proof.
  intro P. assert (r0 : 0 < sqrt m2) by (apply sqrt_lt_R0; exact P). assert (r2 : sqrt m2 ^ 2 = m2) by (apply pow2_sqrt; lra).
  normal_by_beta.lines; perturbed.lines; unfold m2 in *.
  split; [|split]; auto_derive; simpl in *; set (r := sqrt _) in *;
    try (split; [lra | split; [lra | exact I]]); field_simplify_eq; try lra;
    replace (r ^ 3) with (r * (r * (r * 1))) by ring; replace (r ^ 2) with (r * (r * 1)) by ring; rewrite ?r2; ring.
Qed.
End by_beta.

(* The printed claims *)

Theorem displaced_normal__product : Statements.displaced_normal__product.
Proof.
  red. intros. subst theta_0 phi_0. derivatives. assert (P : cos phi ^ 2 = 1 - sin phi ^ 2) by (rewrite <- !Rsqr_pow2; apply cos2).
  assert (T : cos theta ^ 2 = 1 - sin theta ^ 2) by (rewrite <- !Rsqr_pow2; apply cos2).
  repeat split; first [not_zero | differentiable | field [P T]; lra].
Qed.
Ltac circles_of c d := match goal with _ : c ^ 2 + ?s ^ 2 = 1 |- _ => assert (C' : c ^ 2 = 1 - s ^ 2) by lra end;
  match goal with _ : d ^ 2 + ?s ^ 2 = 1 |- _ => assert (D' : d ^ 2 = 1 - s ^ 2) by lra end.
Theorem displaced_normal__outward : Statements.displaced_normal__outward.
Proof.
  red. intros. circles_of cos_theta cos_phi. assert (E : displaced_z * normal_z + displaced_x * normal_x + displaced_y * normal_y = lift).
  { lines. unfold Rdiv. ring [C' D']. }
  rewrite E. unfold lift. each direct.
Qed.
Theorem displaced_normal__first_order : Statements.displaced_normal__first_order.
Proof.
  red. intros. circles_of cos_theta cos_phi. split; [apply Rgt_not_eq; lra|]. lines. unfold Rdiv. repeat split; ring [C' D'].
Qed.
Theorem bump_is_not_displacement__only_where_flat : Statements.bump_is_not_displacement__only_where_flat.
Proof.
  red. intros. pose proof PI_RGT_0 as P.
  match goal with X : displaced_z * _ - _ = 0, Y : displaced_x * _ - _ = 0, Z : displaced_y * _ - _ = 0 |- _ => rename X into DX, Y into DY, Z into DZ
    end. circles_of cos_theta cos_phi.
  assert (X : 0 < PI * sin_phi) by (apply Rmult_lt_0_compat; lra). assert (Y : 0 < / (2 * PI * sin_phi)) by (apply Rinv_0_lt_compat; lra).
  assert (0 < / sin_phi) by (apply Rinv_0_lt_compat; lra). assert (0 < / PI) by (apply Rinv_0_lt_compat; lra).
  assert (0 < 1 / (PI * sin_phi)) by (apply Rdiv_lt_0_compat; lra).
  assert (UV : beta * h_u * (lift + / (2 * PI * sin_phi)) = 0 /\ beta * h_v * (lift + / PI) = 0).
  { split.
    1: transitivity (e_phi_x * (displaced_z * m_y - displaced_y * m_z) + e_phi_y * (displaced_x * m_z - displaced_z * m_x) + e_phi_z * (displaced_y *
      m_x - displaced_x * m_y)); [|rewrite DX, DY, DZ; ring].
    2: transitivity (- (e_theta_x * (displaced_z * m_y - displaced_y * m_z) + e_theta_y * (displaced_x * m_z - displaced_z * m_x) + e_theta_z *
      (displaced_y * m_x - displaced_x * m_y))); [|rewrite DX, DY, DZ; ring].
    all: clear DX DY DZ; lines; unfold Rdiv; rewrite ?Rinv_mult; ring [C' D']. }
  destruct UV as [U V].
  assert (L : 0 < lift) by (unfold lift; lra).
  assert (A : beta * h_u = 0) by (destruct (Rmult_integral _ _ U); lra). assert (B : beta * h_v = 0) by (destruct (Rmult_integral _ _ V); lra).
  each ltac:(first [assumption | lra | apply Rgt_not_eq; lra]).
Qed.
Theorem bump_is_not_displacement__where_flat : Statements.bump_is_not_displacement__where_flat.
Proof.
  red. intros. lines. unfold Rdiv.
  match goal with U : beta * h_u = 0, V : beta * h_v = 0 |- _ => each ltac:(first [apply Rgt_not_eq; lra | ring [U V]]) end.
Qed.
Theorem bump_is_not_displacement__angle : Statements.bump_is_not_displacement__angle.
Proof.
  red. intros. pose proof PI_RGT_0. circles_of cos_theta cos_phi. split; [lra|]. split; [apply Rgt_not_eq, Rmult_lt_0_compat; lra|].
  lines. unfold Rdiv. rewrite !Rinv_mult. repeat split; ring [C' D'].
Qed.

(* The surface's own bump *)

Ltac selected := repeat match goal with |- context [Rlt_dec 0 ?x] => destruct (Rlt_dec 0 x); try lra end.
Theorem surface_bump__dropped : Statements.surface_bump__dropped.
Proof.
  red. intros. pose proof PI_RGT_0. lines. selected. repeat split; intros; first [lra | apply Rmult_integral_contrapositive_currified; lra | field; lra].
Qed.
Theorem surface_bump__second_order : Statements.surface_bump__second_order.
Proof.
  red. intros. pose proof PI_RGT_0. circles_of cos_theta cos_phi. lines. selected. repeat split; intros; first [lra | apply
    Rmult_integral_contrapositive_currified; lra | field [C' D']; lra].
Qed.
Theorem surface_bump__at_the_pole : Statements.surface_bump__at_the_pole.
Proof. red. intros. lines. selected; repeat split; intros; first [lra | ring]. Qed.

(* The displaced surface *)

Section displaced.
Variables theta phi h_u h_v beta : R.

Definition displaced (h : R) : vector :=
  (displaced_normal.displaced_x (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta h,
   displaced_normal.displaced_y (cos theta) (sin theta) (cos phi) (sin phi) h_u h_v beta h,
   displaced_normal.displaced_z (cos phi) (sin phi) h_u h_v beta h).
Definition G : vector := vector_sum (scaled (h_u / (2 * PI * sin phi)) (e_theta theta)) (scaled (h_v / PI) (e_phi theta phi)).
End displaced.

Ltac unfold_displaced :=
  unfold displaced, G; displaced_normal.lines.

Lemma displaced_in_frame (theta phi h_u h_v beta h : R) : 0 < sin phi ->
  displaced theta phi h_u h_v beta h = vector_sum (scaled (1 + beta * h) (normal_at theta phi)) (scaled (- beta) (G theta phi h_u h_v)).
Proof. intro S. generalize PI_RGT_0. intro. unfold_displaced. unfold_vectors. f_equal; [f_equal|]; field; lra. Qed.

(* The surface (1 + beta h) N over the unit sphere, h over the chart. *)
Definition surface (h : R -> R -> R) (beta theta phi : R) : vector :=
  scaled (1 + beta * h ((theta + PI) / (2 * PI)) (phi / PI)) (normal_at theta phi).
Definition derivative_of (f : R -> vector) (x : R) : vector :=
  (Derive (fun t => fst (fst (f t))) x, Derive (fun t => snd (fst (f t))) x, Derive (fun t => snd (f t)) x).

(* by phi x by theta = (1 + beta h) sin phi D. *)
Theorem displaced_normal__any_field (h : R -> R -> R) (theta phi h_u h_v beta : R) :
  let u := (theta + PI) / (2 * PI) in let v := phi / PI in
  0 < sin phi -> is_derive (fun u => h u v) u h_u -> is_derive (fun v => h u v) v h_v ->
  cross (derivative_of (surface h beta theta) phi) (derivative_of (fun t => surface h beta t phi) theta) =
  scaled ((1 + beta * h u v) * sin phi) (displaced theta phi h_u h_v beta (h u v)).
Proof.
  cbv zeta. intros S U V. generalize PI_RGT_0. intro P.
  assert (W : is_derive (fun t => h ((theta + PI) / (2 * PI)) (t / PI)) phi (h_v / PI)) by (auto_derive; [eexists; exact V | replace (Derive _ _) with
    h_v by (symmetry; apply is_derive_unique, V); field; lra]).
  assert (X : is_derive (fun t => h ((t + PI) / (2 * PI)) (phi / PI)) theta (h_u / (2 * PI))) by (auto_derive; [eexists; exact U | replace (Derive _
    _) with h_u by (symmetry; apply is_derive_unique, U); field; lra]).
  assert (K : forall (f g : R -> R) x a b, is_derive f x a -> is_derive g x b -> Derive (fun t => (1 + beta * f t) * g t) x = beta * a * g x + (1 +
    beta * f x) * b).
  { intros f g x a b Hf Hg. apply is_derive_unique. auto_derive; [split; [exists a | split; [exists b|]]; trivial|]. replace (Derive (fun t => f t) x)
    with a by (symmetry; apply is_derive_unique, Hf). replace (Derive _ x) with b by (symmetry; apply is_derive_unique, Hg). ring. }
  rewrite displaced_in_frame by exact S. generalize (frame_by_phi theta phi) (frame_by_theta theta phi). unfold derivative_of, surface, G.
    unfold_vectors. intros (Px & Py & Pz) (Tx & Ty & Tz).
  rewrite (K _ _ _ _ _ W Px), (K _ _ _ _ _ W Py), (K _ _ _ _ _ W Pz), (K _ _ _ _ _ X Tx), (K _ _ _ _ _ X Ty), (K _ _ _ _ _ X Tz).
  f_equal; [f_equal|]; field_simplify_eq; try lra; ring [(sin_squared theta) (sin_squared phi)].
Qed.

(* A false variant: the product without its lift. *)
Theorem displaced_normal__any_field__false : ~ forall (h : R -> R -> R) (theta phi h_u h_v beta : R), let u := (theta + PI) / (2 * PI) in let v := phi / PI in
  0 < sin phi -> is_derive (fun u => h u v) u h_u -> is_derive (fun v => h u v) v h_v ->
  cross (derivative_of (surface h beta theta) phi) (derivative_of (fun t => surface h beta t phi) theta) = scaled (sin phi) (displaced theta phi h_u
    h_v beta (h u v)).
Proof.
  assert (S : 0 < sin (PI / 2)) by (rewrite sin_PI2; lra).
  assert (K : forall x : R, is_derive (fun _ : R => 1) x 0) by (intro x; apply (is_derive_const 1 x)).
  intro H. generalize (H (fun _ _ => 1) 0 (PI / 2) 0 0 1 S (K _) (K _)) (displaced_normal__any_field (fun _ _ => 1) 0 (PI / 2) 0 0 1 S (K _) (K _)).
    cbv zeta. intros -> E.
  apply (f_equal (fun a => fst (fst a))) in E. rewrite displaced_in_frame in E by exact S. revert E. unfold G. unfold_vectors. rewrite sin_PI2, sin_0,
    cos_0. lra.
Qed.

(* The cosine of the angle between N' and D. *)
Theorem bump_is_not_displacement__cosine (theta phi h_u h_v beta h : R) : 0 < sin phi -> 0 < 1 + beta * h ->
  let bumped := N' theta phi h_u h_v beta in let outward := displaced theta phi h_u h_v beta h in
  let m_length := sqrt (1 + beta ^ 2 * (h_u ^ 2 + h_v ^ 2)) in
  let d_length := sqrt ((1 + beta * h) ^ 2 + beta ^ 2 * (h_u ^ 2 / (4 * PI ^ 2 * sin phi ^ 2) + h_v ^ 2 / PI ^ 2)) in
  0 < magnitude bumped * magnitude outward /\ 0 < m_length * d_length /\
  dot bumped outward / (magnitude bumped * magnitude outward) = (1 + beta * h - beta ^ 2 * (h_u ^ 2 / (2 * PI * sin phi) + h_v ^ 2 / PI)) / (m_length
    * d_length).
Proof.
  cbv zeta. intros S L. generalize PI_RGT_0. intro.
  replace (h_u ^ 2 / (4 * PI ^ 2 * sin phi ^ 2) + h_v ^ 2 / PI ^ 2) with ((h_u / (2 * PI * sin phi)) ^ 2 + (h_v / PI) ^ 2) by (field; lra).
  assert (D : dot (displaced theta phi h_u h_v beta h) (displaced theta phi h_u h_v beta h) = (1 + beta * h) ^ 2 + beta ^ 2 * ((h_u / (2 * PI * sin
    phi)) ^ 2 + (h_v / PI) ^ 2))
    by (unfold_displaced; unfold dot; field [(sin_squared theta) (sin_squared phi)]; lra).
  assert (P : 0 < magnitude (displaced theta phi h_u h_v beta h)).
  { apply sqrt_lt_R0. rewrite D. apply Rplus_lt_le_0_compat; [apply pow_lt, L | apply Rmult_le_pos; [|apply Rplus_le_le_0_compat]; apply pow2_ge_0]. }
  assert (MD : dot (M theta phi h_u h_v beta) (displaced theta phi h_u h_v beta h) = 1 + beta * h - beta ^ 2 * (h_u ^ 2 / (2 * PI * sin phi) + h_v ^ 2 / PI))
    by (unfold_displaced; unfold_vectors; field [(sin_squared theta) (sin_squared phi)]; lra).
  generalize P (m_length_at_least_1 theta phi h_u h_v beta). destruct (unit_length_length theta phi h_u h_v beta) as (_ & _ & ->). rewrite
    bumped_is_scaled, dot_scaled, MD.
  unfold magnitude. rewrite m_squared, D. intros. split; [lra|]. split; [apply Rmult_lt_0_compat; lra | field; lra].
Qed.
Theorem bump_is_not_displacement__cosine__point : exists phi beta h, 0 < sin phi /\ 0 < 1 + beta * h.
Proof. exists (PI / 2), 0, 0. rewrite sin_PI2. lra. Qed.
(* The slopes do not bring the two normals together. *)
Theorem bump_is_not_displacement__cosine__false : ~ forall theta phi h_u h_v beta h, 0 < sin phi -> 0 < 1 + beta * h ->
  let bumped := N' theta phi h_u h_v beta in let outward := displaced theta phi h_u h_v beta h in
  dot bumped outward / (magnitude bumped * magnitude outward) = (1 + beta * h + beta ^ 2 * (h_u ^ 2 / (2 * PI * sin phi) + h_v ^ 2 / PI)) /
    (sqrt (1 + beta ^ 2 * (h_u ^ 2 + h_v ^ 2)) * sqrt ((1 + beta * h) ^ 2 + beta ^ 2 * (h_u ^ 2 / (4 * PI ^ 2 * sin phi ^ 2) + h_v ^ 2 / PI ^ 2))).
Proof.
  assert (S : 0 < sin (PI / 2)) by (rewrite sin_PI2; lra). intro H. generalize (H 0 (PI / 2) 0 1 1 0 S ltac:(lra)).
  destruct (bump_is_not_displacement__cosine 0 (PI / 2) 0 1 1 0 S ltac:(lra)) as (_ & K & E). cbv zeta. rewrite E. intro F.
  apply Rmult_eq_reg_r in F; [|apply Rgt_not_eq, Rinv_0_lt_compat, K]. generalize (Rinv_0_lt_compat _ PI_RGT_0). unfold Rdiv in F. lra.
Qed.
