(* The gradient at the pole: along each meridian it has a limit, and not the same one. *)

From Coq Require Import Reals Lra Psatz Lia.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Vectors Fields.
Open Scope R_scope.

Lemma limit_is_value (f : R -> R) (x l : R) : ex_derive f x -> f x = l -> filterlim f (locally x) (locally l).
Proof. intros D <-. exact (ex_derive_continuous f x D). Qed.


(* On the meridian theta, where u = (theta + pi)/2pi and phi = pi v. *)
Section meridian.
Variables theta k_u k_v : R.
Let u := (theta + PI) / (2 * PI).
Definition g_of_sine (v : R) : vector := g theta (PI * v) (gradient_sine.h_u u v k_u k_v) (gradient_sine.h_v u v k_u k_v).
Definition g_of_rings (v : R) : vector := g theta (PI * v) gradient_rings.h_u (gradient_rings.h_v v k_v).

Ltac unfold_g := unfold g_of_sine, g_of_rings, g, bumped_normal.g_x, bumped_normal.g_y, bumped_normal.g_z, bumped_normal.e_theta_x, bumped_normal.e_theta_y,
  bumped_normal.e_theta_z, bumped_normal.e_phi_x, bumped_normal.e_phi_y, bumped_normal.e_phi_z, gradient_rings.h_u; unfold_fields; cbn [fst snd].
Ltac limit := apply limit_is_value; [auto_derive; trivial | rewrite ?Rmult_0_r, ?sin_0, ?cos_0; ring].

(* As v -> 0, sine's g tends to pi k_v sin(pi k_u u) (cos theta, sin theta, 0). *)
Theorem (* clause 1 *) pole__sine : let s := PI * k_v * sin (PI * (k_u * u)) in
  filterlim (fun v => fst (fst (g_of_sine v))) (locally 0) (locally (s * cos theta)) /\
  filterlim (fun v => snd (fst (g_of_sine v))) (locally 0) (locally (s * sin theta)) /\
  filterlim (fun v => snd (g_of_sine v)) (locally 0) (locally 0) /\
  magnitude (s * cos theta, s * sin theta, 0) = PI * Rabs (k_v * sin (PI * (k_u * u))).
Proof.
  cbv zeta. unfold_g. split; [limit | split; [limit | split; [limit|]]]. generalize PI_RGT_0. intro P. set (t := k_v * sin (PI * (k_u * u))).
  unfold magnitude, dot. replace (_ + _) with (Rsqr (PI * t)) by (unfold Rsqr, t; ring [(sin_squared theta)]). rewrite sqrt_Rsqr_abs, Rabs_mult, Rabs_pos_eq by lra. reflexivity.
Qed.
(* Rings' tends to 2 pi k_v (cos theta, sin theta, 0): on opposite meridians 4 pi |k_v| apart. *)
Theorem (* clause 2 *) pole__rings : let s := 2 * PI * k_v in
  filterlim (fun v => fst (fst (g_of_rings v))) (locally 0) (locally (s * cos theta)) /\
  filterlim (fun v => snd (fst (g_of_rings v))) (locally 0) (locally (s * sin theta)) /\
  filterlim (fun v => snd (g_of_rings v)) (locally 0) (locally 0) /\
  magnitude (difference (s * cos theta, s * sin theta, 0) (s * cos (theta + PI), s * sin (theta + PI), 0)) = 4 * PI * Rabs k_v.
Proof.
  cbv zeta. unfold_g. split; [limit | split; [limit | split; [limit|]]]. generalize PI_RGT_0. intro P. rewrite neg_cos, neg_sin.
  unfold magnitude, dot, difference, vector_sum, scaled. replace (_ + _) with (Rsqr (4 * PI * k_v)) by (unfold Rsqr; ring [(sin_squared theta)]).
  rewrite sqrt_Rsqr_abs, Rabs_mult, Rabs_pos_eq by lra. reflexivity.
Qed.
End meridian.

(* So sine's g has no limit at the pole unless k_u k_v = 0: it is 0 on u = 0, and not 0 where sin(pi k_u u) is not. *)
Theorem (* clause 1 *) pole__sine_differs (u k_u k_v : R) : k_v <> 0 -> sin (PI * (k_u * u)) <> 0 ->
  PI * Rabs (k_v * sin (PI * (k_u * 0))) = 0 /\ 0 < PI * Rabs (k_v * sin (PI * (k_u * u))).
Proof.
  intros K S. rewrite !Rmult_0_r, sin_0, Rmult_0_r, Rabs_R0, Rmult_0_r. split; [reflexivity|]. generalize PI_RGT_0. intro P.
  apply Rmult_lt_0_compat; [exact P|]. apply Rabs_pos_lt. intro E. apply Rmult_integral in E. destruct E; contradiction.
Qed.
Theorem pole__sine_differs__point : exists u k_u k_v : R, k_v <> 0 /\ sin (PI * (k_u * u)) <> 0.
Proof. exists (1/2), 1, 1. replace (PI * (1 * (1/2))) with (PI / 2) by field. rewrite sin_PI2. lra. Qed.
(* With k_u k_v = 0 it is 0 everywhere. *)
Theorem (* clause 1 *) pole__sine_vanishes (u k_u k_v : R) : k_u * k_v = 0 -> PI * Rabs (k_v * sin (PI * (k_u * u))) = 0.
Proof. intro E. apply Rmult_integral in E. destruct E as [-> | ->]; rewrite ?Rmult_0_l, ?Rmult_0_r, ?sin_0, ?Rmult_0_r, Rabs_R0; ring. Qed.
Theorem pole__sine_vanishes__point : exists k_u k_v : R, k_u * k_v = 0.
Proof. exists 0, 1. ring. Qed.
Theorem pole__sine__false : ~ forall u k_u k_v, PI * Rabs (k_v * sin (PI * (k_u * u))) = 0.
Proof. intro H. generalize (H (1/2) 1 1). replace (PI * (1 * (1/2))) with (PI / 2) by field. rewrite sin_PI2, Rabs_pos_eq by lra. generalize PI_RGT_0. lra. Qed.

(* sin(k t)/sin t tends to k. *)
Lemma ratio_of_sines (k : R) : is_lim (fun v => sin (PI * (k * v)) / sin (PI * v)) 0 k.
Proof.
  generalize PI_RGT_0. intro P.
  assert (D : forall c, is_derive (fun v => sin (PI * (c * v))) 0 (PI * c)) by (intro c; auto_derive; trivial; rewrite !Rmult_0_r, cos_0; ring).
  assert (Q : forall c, is_lim (fun v => sin (PI * (c * v)) / v) 0 (PI * c)).
  { intro c. generalize (D c). intro Dc. apply is_derive_Reals in Dc. intros S [eps HS]. destruct (Dc eps (cond_pos eps)) as [delta H].
    exists delta. intros v B normal_at. apply HS. unfold ball. simpl. unfold AbsRing_ball, abs, minus, plus, opp. simpl.
    unfold ball in B. simpl in B. unfold AbsRing_ball, abs, minus, plus, opp in B. simpl in B. rewrite Ropp_0, Rplus_0_r in B.
    generalize (H v normal_at B). rewrite Rplus_0_l, !Rmult_0_r, sin_0, Rminus_0_r. trivial. }
  apply (is_lim_ext_loc (fun v => (sin (PI * (k * v)) / v) / (sin (PI * (1 * v)) / v))).
  - exists (mkposreal 1 Rlt_0_1). intros v B normal_at. unfold ball in B. simpl in B. unfold AbsRing_ball, abs, minus, plus, opp in B. simpl in B.
    rewrite Ropp_0, Rplus_0_r in B. apply Rabs_def2 in B. assert (E : sin (PI * v) <> 0).
    { destruct (Rdichotomy v 0 normal_at) as [L|L].
      - assert (0 < sin (PI * - v)) by (apply sin_gt_0; nra). rewrite Ropp_mult_distr_r_reverse, sin_neg in *. lra.
      - assert (0 < sin (PI * v)) by (apply sin_gt_0; nra). lra. }
    rewrite Rmult_1_l. field. split; assumption.
  - replace (Finite k) with (Rbar_div (PI * k) (PI * 1)) by (simpl; f_equal; field; lra).
    apply is_lim_div; [apply Q | apply Q | intro E; injection E; lra | simpl; trivial].
Qed.

(* Sine's surface gradient, h_u/(2 pi sin phi) e_theta + h_v/pi e_phi. *)
Section surface.
Variables theta k_u k_v : R.
Let u := (theta + PI) / (2 * PI).
Definition surface_gradient (v : R) : vector :=
  vector_sum (scaled (gradient_sine.h_u u v k_u k_v / (2 * PI * sin (PI * v))) (e_theta theta)) (scaled (gradient_sine.h_v u v k_u k_v / PI) (e_phi theta (PI * v))).
Definition limit : vector :=
  scaled k_v (vector_sum (scaled (k_u / 2 * cos (PI * (k_u * u))) (- sin theta, cos theta, 0)) (scaled (sin (PI * (k_u * u))) (cos theta, sin theta, 0))).

(* It tends to k_v times a vector of squared length k_u^2/4 + (1 - k_u^2/4) sin^2(pi k_u u). *)
Theorem (* clause 3 *) pole__surface_gradient :
  is_lim (fun v => fst (fst (surface_gradient v))) 0 (fst (fst limit)) /\ is_lim (fun v => snd (fst (surface_gradient v))) 0 (snd (fst limit)) /\
  is_lim (fun v => snd (surface_gradient v)) 0 (snd limit) /\
  dot limit limit = k_v ^ 2 * (k_u ^ 2 / 4 + (1 - k_u ^ 2 / 4) * sin (PI * (k_u * u)) ^ 2).
Proof.
  generalize PI_RGT_0. intro P. set (c := cos (PI * (k_u * u))). set (s := sin (PI * (k_u * u))).
  assert (A : is_lim (fun v => k_u / 2 * c * (sin (PI * (k_v * v)) / sin (PI * v))) 0 (k_u / 2 * c * k_v)).
  { apply (is_lim_scal_l (fun v => sin (PI * (k_v * v)) / sin (PI * v)) (k_u / 2 * c) 0 k_v), ratio_of_sines. }
  assert (B : forall (f : R -> R) (l : R), ex_derive f 0 -> f 0 = l -> is_lim f 0 l).
  { intros f l D <-. apply is_lim_continuity, continuity_pt_filterlim, (ex_derive_continuous f 0 D). }
  assert (E : forall v, gradient_sine.h_u u v k_u k_v / (2 * PI * sin (PI * v)) = k_u / 2 * c * (sin (PI * (k_v * v)) / sin (PI * v))).
  { intro v. unfold_fields. fold c. unfold Rdiv. rewrite !Rinv_mult. set (i := / sin (PI * v)). field. lra. }
  assert (F : forall v, gradient_sine.h_v u v k_u k_v / PI = k_v * s * cos (PI * (k_v * v))) by (intro v; unfold_fields; fold s; field; lra).
  unfold surface_gradient, limit, e_theta, e_phi, tangent_frame.e_theta_x, tangent_frame.e_theta_y, tangent_frame.e_theta_z, tangent_frame.e_phi_x,
    tangent_frame.e_phi_y, tangent_frame.e_phi_z, vector_sum, scaled, dot. cbn [fst snd]. fold c s.
  assert (S : forall x (f : R -> R) (l : R), is_lim f 0 l -> is_lim (fun v => gradient_sine.h_u u v k_u k_v / (2 * PI * sin (PI * v)) * x + f v) 0 (k_v * (k_u / 2 * c * x) + l)).
  { intros x f l Hf. apply (is_lim_ext (fun v => k_u / 2 * c * (sin (PI * (k_v * v)) / sin (PI * v)) * x + f v)); [intro v; rewrite E; reflexivity|].
    apply (is_lim_plus' _ f 0 (k_v * (k_u / 2 * c * x)) l); [|exact Hf]. replace (k_v * (k_u / 2 * c * x)) with (k_u / 2 * c * k_v * x) by ring.
    exact (is_lim_scal_r _ x 0 _ A). }
  rewrite !Rmult_plus_distr_l.
  split; [|split; [|split]].
  - apply S, (is_lim_ext (fun v => k_v * s * cos (PI * (k_v * v)) * (cos (PI * v) * cos theta))); [intro v; rewrite F; reflexivity|].
    apply B; [auto_derive; trivial | rewrite !Rmult_0_r, !cos_0; ring].
  - apply S, (is_lim_ext (fun v => k_v * s * cos (PI * (k_v * v)) * (cos (PI * v) * sin theta))); [intro v; rewrite F; reflexivity|].
    apply B; [auto_derive; trivial | rewrite !Rmult_0_r, !cos_0; ring].
  - apply S, (is_lim_ext (fun v => k_v * s * cos (PI * (k_v * v)) * - sin (PI * v))); [intro v; rewrite F; reflexivity|].
    apply B; [auto_derive; trivial | rewrite !Rmult_0_r, !cos_0, sin_0; ring].
  - unfold c, s. field_simplify_eq. ring [(sin_squared theta) (sin_squared (PI * (k_u * u)))].
Qed.
End surface.

(* It is the same on every meridian only if k_u = 0 or k_u = +-2. *)
Theorem (* clause 3 *) pole__one_limit (k_u : R) : (forall u, k_u ^ 2 / 4 + (1 - k_u ^ 2 / 4) * sin (PI * (k_u * u)) ^ 2 = k_u ^ 2 / 4) -> k_u = 0 \/ k_u = 2 \/ k_u = -2.
Proof.
  intro H. destruct (Req_dec k_u 0) as [Z|normal_at]; [left; exact Z|]. right. generalize (H (/ (2 * k_u))).
  replace (PI * (k_u * / (2 * k_u))) with (PI / 2) by (field; exact normal_at). rewrite sin_PI2. intro E.
  assert (Q : (k_u - 2) * (k_u + 2) = 0) by lra. apply Rmult_integral in Q. lra.
Qed.
Theorem (* clause 3 *) pole__at_two (theta k_v : R) : limit theta 0 k_v = zero_vector /\ limit theta 2 k_v = (0, - k_v, 0) /\ limit theta (-2) k_v = (0, k_v, 0).
Proof.
  generalize PI_RGT_0. intro P. unfold limit, zero_vector, vector_sum, scaled.
  replace (PI * (0 * ((theta + PI) / (2 * PI)))) with 0 by ring. replace (PI * (2 * ((theta + PI) / (2 * PI)))) with (theta + PI) by (field; lra).
  replace (PI * (-2 * ((theta + PI) / (2 * PI)))) with (- (theta + PI)) by (field; lra). rewrite sin_neg, cos_neg, neg_cos, neg_sin, sin_0, cos_0.
  split; [|split]; f_equal; try f_equal; field_simplify_eq; ring [(sin_squared theta)].
Qed.

(* For k_u = 2 and whole k_v, h = -y U(z) with a polynomial U (Chebyshev's of the second kind), on the sphere. *)
Fixpoint chebyshev (n : nat) (z : R) : R * R :=
  match n with O => (0, 1) | S n => let (a, b) := chebyshev n z in (b, 2 * z * b - a) end.
Lemma sine_of_a_multiple (n : nat) (phi : R) : sin phi * fst (chebyshev n (cos phi)) = sin (INR n * phi) /\ sin phi * snd (chebyshev n (cos phi)) = sin ((INR n + 1) * phi).
Proof.
  induction n as [|n [A B]]; [simpl; rewrite Rmult_0_l, sin_0; split; [ring | rewrite Rplus_0_l, Rmult_1_l; ring]|].
  cbn [chebyshev]. destruct (chebyshev n (cos phi)) as [a b]. cbn [fst snd] in *. rewrite S_INR. split; [exact B|].
  replace (sin phi * (2 * cos phi * b - a)) with (2 * cos phi * (sin phi * b) - sin phi * a) by ring. rewrite A, B.
  replace ((INR n + 1 + 1) * phi) with ((INR n + 1) * phi + phi) by ring. replace (INR n * phi) with ((INR n + 1) * phi - phi) by ring.
  rewrite sin_plus, sin_minus. ring.
Qed.
Theorem (* clause 4 *) pole__polynomial (theta phi : R) (k : nat) : let '(x, y, z) := normal_at theta phi in
  height_sine.h ((theta + PI) / (2 * PI)) (phi / PI) 2 (INR k) = - y * fst (chebyshev k z).
Proof.
  generalize PI_RGT_0. intro P. unfold normal_at, unit_normal.normal_x, unit_normal.normal_y, unit_normal.normal_z. unfold_fields.
  replace (PI * (2 * ((theta + PI) / (2 * PI)))) with (theta + PI) by (field; lra). replace (PI * (INR k * (phi / PI))) with (INR k * phi) by (field; lra).
  rewrite neg_sin, <- (proj1 (sine_of_a_multiple k phi)). ring.
Qed.
(* False variants. *)
Theorem pole__sine_vanishes__false : ~ forall u k_u k_v, PI * Rabs (k_v * sin (PI * (k_u * u))) = 0.
Proof. exact pole__sine__false. Qed.
Theorem pole__rings__false : ~ forall theta k_v, (2 * PI * k_v * cos theta, 2 * PI * k_v * sin theta, 0) = (2 * PI * k_v * cos (theta + PI), 2 * PI * k_v * sin (theta + PI), 0).
Proof. intro H. generalize (f_equal (fun a => fst (fst a)) (H 0 1)) PI_RGT_0. cbn [fst]. rewrite neg_cos, cos_0. lra. Qed.
Theorem pole__sine_differs__false : ~ forall u k_u k_v, k_v <> 0 -> 0 < PI * Rabs (k_v * sin (PI * (k_u * u))).
Proof. intro H. generalize (H 0 1 1 ltac:(lra)). rewrite !Rmult_0_r, sin_0, Rmult_0_r, Rabs_R0. lra. Qed.
Theorem pole__surface_gradient__false : ~ forall theta k_u k_v, dot (limit theta k_u k_v) (limit theta k_u k_v) = k_v ^ 2 * (k_u ^ 2 / 4).
Proof.
  intro H. generalize (H 0 1 1) (proj2 (proj2 (proj2 (pole__surface_gradient 0 1 1)))) PI_RGT_0. intros -> E P. revert E.
  replace (PI * (1 * ((0 + PI) / (2 * PI)))) with (PI / 2) by (field; lra). rewrite sin_PI2. lra.
Qed.
Theorem pole__one_limit__false : ~ forall k_u, (forall u, k_u ^ 2 / 4 + (1 - k_u ^ 2 / 4) * sin (PI * (k_u * u)) ^ 2 = k_u ^ 2 / 4) -> k_u = 0.
Proof. intro H. assert (2 = 0) by (apply H; intro u; field). lra. Qed.
Theorem pole__at_two__false : ~ forall theta k_v, limit theta 2 k_v = zero_vector.
Proof. intro H. generalize (H 0 1). rewrite (proj1 (proj2 (pole__at_two 0 1))). unfold zero_vector. intro E. apply (f_equal (fun a => snd (fst a))) in E. cbn in E. lra. Qed.
Theorem pole__polynomial__false : ~ forall theta phi k, let '(x, y, z) := normal_at theta phi in height_sine.h ((theta + PI) / (2 * PI)) (phi / PI) 2 (INR k) = y * fst (chebyshev k z).
Proof.
  intro H. generalize (H (PI / 2) (PI / 2) 1%nat) (pole__polynomial (PI / 2) (PI / 2) 1). unfold normal_at, unit_normal.normal_x, unit_normal.normal_y, unit_normal.normal_z.
  cbn [chebyshev fst]. rewrite sin_PI2. intros -> E. lra.
Qed.
