(* The gradient at the pole: along each meridian it has a limit, and not the same one. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Vectors Camera Fields Claim.
From Formal Require Statements.
Open Scope R_scope.

Lemma half_turned k t : PI * (k * (t + PI) / (2 * PI)) = k * (t + PI) / 2.
Proof. field. apply PI_neq0. Qed.
Ltac pole_lines := red; intros; lines; rewrite ?half_turned; repeat rewrite ?Rmult_0_l, ?Rmult_0_r, ?sin_0, ?cos_0.
Ltac on_the_circle t := ring [(sin_squared t)].

Theorem pole__sine : Statements.pole__sine.
Proof. pole_lines. repeat split; on_the_circle theta. Qed.
Theorem pole__sine_seam : Statements.pole__sine_seam.
Proof. pole_lines. replace (PI * (k_u * _ / _)) with 0 by lra. rewrite sin_0. lra. Qed.
Theorem pole__sine_k_u_0 : Statements.pole__sine_k_u_0.
Proof. pole_lines. replace (0 / 2) with 0 by field. rewrite sin_0. lra. Qed.
Theorem pole__sine_k_v_0 : Statements.pole__sine_k_v_0.
Proof. pole_lines. lra. Qed.
Theorem pole__sine_differs : Statements.pole__sine_differs.
Proof.
  red. intros. destruct (pole__sine k_u k_v theta) as (_ & _ & _ & L). pose proof PI_RGT_0.
  assert ((k_v * sin (k_u * (theta + PI) / 2)) ^ 2 > 0) by nra.
  repeat split; auto. match goal with |- ?a > 0 => replace a with (PI ^ 2 * (k_v * sin (k_u * (theta + PI) / 2)) ^ 2) by (symmetry; etransitivity;
    [exact L | ring]) end. apply Rmult_gt_0_compat; nra.
Qed.
Theorem pole__surface_gradient : Statements.pole__surface_gradient.
Proof. red. intros. lines. field_simplify_eq. ring [(sin_squared theta) (sin_squared (k_u * (theta + PI) / 2))]. Qed.
Theorem pole__surface_gradient_0 : Statements.pole__surface_gradient_0.
Proof. red. intros. lines. replace (0 * _ / 2) with 0 by field. rewrite sin_0. lra. Qed.
Theorem pole__surface_gradient_2 : Statements.pole__surface_gradient_2.
Proof. red. intros. lines. replace (2 * _ / 2) with (theta + PI) by field. rewrite neg_cos, neg_sin. split; field_simplify_eq; on_the_circle theta.
  Qed.
Theorem pole__surface_gradient_minus_2 : Statements.pole__surface_gradient_minus_2.
Proof.
  red. intros. lines. replace (-2 * _ / 2) with (- (theta + PI)) by field. rewrite cos_neg, sin_neg, neg_cos, neg_sin. split; field_simplify_eq;
    on_the_circle theta.
Qed.
Theorem pole__polynomial : Statements.pole__polynomial.
Proof.
  intros phi theta a b A0 AS B0 BS n. assert (I : sin (INR n * phi) = a n * sin phi /\ sin (phi * (INR n + 1)) = b n * sin phi).
  { induction n as [|n [A B]]; [rewrite A0, B0, Rmult_0_l, sin_0; split; [ring | rewrite Rplus_0_l, Rmult_1_r; ring]|].
    rewrite S_INR, AS, BS. split; [rewrite Rmult_comm; exact B|]. replace (_ * _) with (phi * (INR n + 1) + phi) by ring.
    transitivity (2 * cos phi * sin (phi * (INR n + 1)) - sin (INR n * phi)); [| nra].
    replace (INR n * phi) with (phi * (INR n + 1) - phi) by ring. rewrite sin_plus, sin_minus. ring. }
  destruct I as [A B]. repeat split; auto. pose proof PI_RGT_0.
  replace (PI * _) with (INR n * phi) by (field; lra). replace (PI * _) with (theta + PI) by (field; lra).
  rewrite neg_sin, A. ring.
Qed.

Lemma limit_is_value (f : R -> R) (x l : R) : ex_derive f x -> f x = l -> filterlim f (locally x) (locally l).
Proof. intros D <-. exact (ex_derive_continuous f x D). Qed.

(* On the meridian theta, where u = (theta + pi)/2pi and phi = pi v. *)
Section meridian.
Variables theta k_u k_v : R.
Let u := (theta + PI) / (2 * PI).
Definition g_of_sine (v : R) : vector := g theta (PI * v) (gradient_sine.h_u u v k_u k_v) (gradient_sine.h_v u v k_u k_v).
Definition g_of_rings (v : R) : vector := g theta (PI * v) gradient_rings.h_u (gradient_rings.h_v v k_v).

Ltac unfold_g := unfold g_of_sine, g_of_rings, g; bumped_normal.lines; unfold gradient_rings.h_u; unfold_fields; cbn [fst snd].
Ltac limit := apply limit_is_value; [auto_derive; trivial | rewrite ?Rmult_0_r, ?sin_0, ?cos_0; ring].

(* As v -> 0, sine's g tends to pi k_v sin(pi k_u u) (cos theta, sin theta, 0). *)
Theorem pole__sine_limit : let s := PI * k_v * sin (PI * (k_u * u)) in
  filterlim (fun v => fst (fst (g_of_sine v))) (locally 0) (locally (s * cos theta)) /\
  filterlim (fun v => snd (fst (g_of_sine v))) (locally 0) (locally (s * sin theta)) /\
  filterlim (fun v => snd (g_of_sine v)) (locally 0) (locally 0) /\
  magnitude (s * cos theta, s * sin theta, 0) = PI * Rabs (k_v * sin (PI * (k_u * u))).
Proof.
  unfold_g. split; [limit | split; [limit | split; [limit|]]]. generalize PI_RGT_0. intro P. set (t := k_v * sin (PI * (k_u * u))).
  unfold magnitude, dot. replace (_ + _) with (Rsqr (PI * t)) by (unfold Rsqr, t; on_the_circle theta). rewrite sqrt_Rsqr_abs, Rabs_mult, Rabs_pos_eq
    by lra. reflexivity.
Qed.
(* Rings' tends to 2 pi k_v (cos theta, sin theta, 0): on opposite meridians 4 pi |k_v| apart. *)
Theorem pole__rings_limit : let s := 2 * PI * k_v in
  filterlim (fun v => fst (fst (g_of_rings v))) (locally 0) (locally (s * cos theta)) /\
  filterlim (fun v => snd (fst (g_of_rings v))) (locally 0) (locally (s * sin theta)) /\
  filterlim (fun v => snd (g_of_rings v)) (locally 0) (locally 0) /\
  magnitude (difference (s * cos theta, s * sin theta, 0) (s * cos (theta + PI), s * sin (theta + PI), 0)) = 4 * PI * Rabs k_v.
Proof.
  unfold_g. split; [limit | split; [limit | split; [limit|]]]. generalize PI_RGT_0. intro P. rewrite neg_cos, neg_sin.
  unfold magnitude, dot, difference, vector_sum, scaled. replace (_ + _) with (Rsqr (4 * PI * k_v)) by (unfold Rsqr; on_the_circle theta).
  rewrite sqrt_Rsqr_abs, Rabs_mult, Rabs_pos_eq by lra. reflexivity.
Qed.
End meridian.

(* A meridian where sine's g is not 0. *)
Lemma another_meridian (k : R) : k <> 0 -> exists u, 0 <= u < 1 /\ sin (PI * (k * u)) <> 0.
Proof.
  intro K. pose proof PI_RGT_0. pose proof (Rabs_pos_lt k K). set (u := / (2 * (1 + Rabs k))). exists u.
  assert (U : 2 * (1 + Rabs k) * u = 1) by (unfold u; field; lra). assert (0 < u) by nra.
  assert (0 < Rabs k * u) by nra. split; [lra|].
  assert (S : 0 < sin (PI * (Rabs k * u))) by (apply sin_gt_0; nra). revert S.
  destruct (Rcase_abs k) as [N|N]; [rewrite (Rabs_left k N); replace (_ * _) with (- (PI * (k * u))) by ring; rewrite sin_neg | rewrite Rabs_right];
    lra.
Qed.
(* So unless k_u k_v = 0 two meridians have two limits: sine's g has none at the pole. *)
Definition one_limit_of_sine (k_u k_v : R) := exists x y, forall theta, - PI <= theta < PI ->
  filterlim (fun v => fst (fst (g_of_sine theta k_u k_v v))) (locally 0) (locally x) /\
  filterlim (fun v => snd (fst (g_of_sine theta k_u k_v v))) (locally 0) (locally y).
Theorem pole__two_limits (k_u k_v : R) : k_u * k_v <> 0 -> ~ one_limit_of_sine k_u k_v.
Proof.
  intros K (x & y & L). pose proof PI_RGT_0. destruct (another_meridian k_u) as (u & U & S); [intro Z; apply K; rewrite Z; ring|].
  assert (E : forall w, 0 <= w < 1 -> let s := PI * k_v * sin (PI * (k_u * w)) in x = s * cos (2 * PI * w - PI) /\ y = s * sin (2 * PI * w - PI)).
  { intros w W s. destruct (L (2 * PI * w - PI)) as [X Y]; [nra|]. destruct (pole__sine_limit (2 * PI * w - PI) k_u k_v) as (X' & Y' & _).
    replace (_ / _) with w in * by (field; lra).
    split; [exact (filterlim_locally_unique _ _ _ X X') | exact (filterlim_locally_unique _ _ _ Y Y')]. }
  destruct (E 0 ltac:(lra)) as [X Y]. rewrite !Rmult_0_r, sin_0, Rmult_0_r in X, Y. destruct (E u U) as [X' Y'].
  assert (N : PI * k_v * sin (PI * (k_u * u)) <> 0).
  { apply Rmult_integral_contrapositive_currified; [apply Rmult_integral_contrapositive_currified |]; [lra | intro Z; apply K; rewrite Z; ring |
    exact S]. }
  set (n := PI * k_v * sin (PI * (k_u * u))) in *. set (c := cos (2 * PI * u - PI)) in *. set (d := sin (2 * PI * u - PI)) in *.
  apply N. replace n with (n * c * c + n * d * d) by (unfold c, d; ring [(sin_squared (2 * PI * u - PI))]). rewrite <- X', <- Y', X, Y. ring.
Qed.
Theorem pole__two_limits__point : exists k_u k_v : R, k_u * k_v <> 0.
Proof. exists 1, 1. lra. Qed.
(* With k_u = 0 it has one. *)
Theorem pole__two_limits__false : ~ forall k_u k_v, k_v <> 0 -> ~ one_limit_of_sine k_u k_v.
Proof.
  intro H. apply (H 0 1 ltac:(lra)). exists 0, 0. intros theta _. destruct (pole__sine_limit theta 0 1) as (X & Y & _).
  rewrite Rmult_0_l, Rmult_0_r, sin_0, Rmult_0_r, Rmult_0_l in X, Y. split; assumption.
Qed.

(* sin(k t)/sin t tends to k. *)
Lemma ratio_of_sines (k : R) : is_lim (fun v => sin (PI * (k * v)) / sin (PI * v)) 0 k.
Proof.
  generalize PI_RGT_0. intro P.
  assert (Q : forall c, is_lim (fun v => sin (PI * (c * v)) / v) 0 (PI * c)).
  { intro c. assert (D : is_derive (fun v => sin (PI * (c * v))) 0 (PI * c)) by (auto_derive; trivial; rewrite !Rmult_0_r, cos_0; ring).
    apply is_derive_Reals in D. apply is_lim_spec. intro eps. destruct (D eps (cond_pos eps)) as [delta H]. exists delta. intros v B N.
    change (Rabs (v - 0) < delta) in B. rewrite Rminus_0_r in B. generalize (H v N B). rewrite Rplus_0_l, !Rmult_0_r, sin_0, Rminus_0_r. trivial. }
  apply (is_lim_ext_loc (fun v => (sin (PI * (k * v)) / v) / (sin (PI * (1 * v)) / v))).
  - exists (mkposreal 1 Rlt_0_1). intros v B N. change (Rabs (v - 0) < 1) in B. apply Rabs_def2 in B. assert (E : sin (PI * v) <> 0).
    { intro Z. apply sine_zero in Z. destruct Z as [m ->]. assert (-1 < m < 1)%Z by (split; apply lt_IZR; lra). apply N. replace m with 0%Z by lia.
      reflexivity. }
    rewrite Rmult_1_l. field. lra.
  - replace (Finite k) with (Rbar_div (PI * k) (PI * 1)) by (simpl; f_equal; field; lra).
    apply is_lim_div; [auto | auto | intro E; injection E; lra | simpl; trivial].
Qed.

(* Sine's surface gradient, h_u/(2 pi sin phi) e_theta + h_v/pi e_phi. *)
Section surface.
Variables theta k_u k_v : R.
Let u := (theta + PI) / (2 * PI).
Definition surface_gradient (v : R) : vector :=
  vector_sum (scaled (gradient_sine.h_u u v k_u k_v / (2 * PI * sin (PI * v))) (e_theta theta)) (scaled (gradient_sine.h_v u v k_u k_v / PI) (e_phi
    theta (PI * v))).
Definition limit : vector :=
  scaled k_v (vector_sum (scaled (k_u / 2 * cos (PI * (k_u * u))) (- sin theta, cos theta, 0)) (scaled (sin (PI * (k_u * u))) (cos theta, sin theta, 0))).

(* It tends to k_v times a vector of squared length k_u^2/4 + (1 - k_u^2/4) sin^2(pi k_u u). *)
Theorem pole__surface_limit :
  is_lim (fun v => fst (fst (surface_gradient v))) 0 (fst (fst limit)) /\ is_lim (fun v => snd (fst (surface_gradient v))) 0 (snd (fst limit)) /\
  is_lim (fun v => snd (surface_gradient v)) 0 (snd limit) /\
  dot limit limit = k_v ^ 2 * (k_u ^ 2 / 4 + (1 - k_u ^ 2 / 4) * sin (PI * (k_u * u)) ^ 2).
Proof.
  pose proof PI_RGT_0. set (c := cos (PI * (k_u * u))). set (s := sin _).
  assert (S : forall x f l, ex_derive f 0 -> k_v * (k_u / 2 * c * x) + k_v * s * f 0 = l -> is_lim (fun v => gradient_sine.h_u u v k_u k_v / (2 * PI
    * sin (PI * v)) * x + gradient_sine.h_v u v k_u k_v / PI * f v) 0 l).
  { intros x f l D <-. apply (is_lim_ext (fun v => k_u / 2 * c * x * (sin (PI * (k_v * v)) / sin (PI * v)) + k_v * s * cos (PI * (k_v * v)) * f v)).
    - intro v. unfold_fields. fold c s. unfold Rdiv. rewrite Rinv_mult. set (i := / sin _). field. lra.
    - rewrite (Rmult_comm k_v (_ * x)). apply is_lim_plus'; [apply (is_lim_scal_l _ _ 0 k_v), ratio_of_sines|].
      replace (k_v * s * f 0) with (k_v * s * cos (PI * (k_v * 0)) * f 0) by (rewrite !Rmult_0_r, cos_0; ring).
      apply (is_lim_continuity (fun v => k_v * s * cos _ * f v)), continuity_pt_filterlim, (ex_derive_continuous (fun v => k_v * s * cos _ * f v)).
        auto_derive. auto. }
  unfold surface_gradient, limit, e_theta, e_phi; tangent_frame.lines; unfold vector_sum, scaled, dot. cbn [fst snd]. fold c s. split; [|split;
    [|split]].
  1, 2, 3: apply S; [auto_derive; trivial | rewrite !Rmult_0_r, ?cos_0, ?sin_0; ring].
  - unfold c, s. field_simplify_eq. ring [(sin_squared theta) (sin_squared (PI * (k_u * u)))].
Qed.
End surface.

(* If k_v is not 0 this is the same on every meridian only if k_u = 0 or k_u = +-2. *)
Theorem pole__one_limit (k_u k_v : R) : k_v <> 0 -> (forall theta, - PI <= theta < PI -> limit theta k_u k_v = limit (- PI) k_u k_v) ->
  k_u = 0 \/ k_u = 2 \/ k_u = -2.
Proof.
  intros V H. pose proof PI_RGT_0. destruct (Req_dec k_u 0) as [Z|K]; auto. destruct (another_meridian k_u K) as (u & U & S).
  pose proof (proj2 (proj2 (proj2 (pole__surface_limit (- PI) k_u k_v)))) as A. pose proof (proj2 (proj2 (proj2 (pole__surface_limit (2 * PI * u -
    PI) k_u k_v)))) as B.
  rewrite H, A in B by nra. replace (PI * _) with 0 in B by lra.
  replace (_ / (2 * PI)) with u in B by (field; lra). rewrite sin_0 in B. apply Rmult_eq_reg_l in B; [|apply pow_nonzero, V].
  assert (E : (1 - k_u ^ 2 / 4) * sin (PI * (k_u * u)) ^ 2 = 0) by lra. apply Rmult_integral in E.
  destruct E as [E|E]; [| nra]. assert (Q : (k_u - 2) * (k_u + 2) = 0) by lra. apply Rmult_integral in Q. lra.
Qed.
Lemma limit_at_two (theta k_v : R) : limit theta 2 k_v = (0, - k_v, 0).
Proof.
  unfold limit, vector_sum, scaled. replace (PI * _) with (theta + PI) by (field; apply PI_neq0).
  rewrite neg_cos, neg_sin. f_equal; f_equal; field_simplify_eq; on_the_circle theta.
Qed.
Theorem pole__one_limit__point : exists k_u k_v, k_v <> 0 /\ forall theta, - PI <= theta < PI -> limit theta k_u k_v = limit (- PI) k_u k_v.
Proof. exists 2, 1. split; auto. intros. rewrite !limit_at_two. reflexivity. Qed.

(* False variants: without the factor of u; with the slope of half the wave number, which sine has; as if u were theta. *)
Theorem pole__sine_limit__false : ~ forall theta k_u k_v, filterlim (fun v => fst (fst (g_of_sine theta k_u k_v v))) (locally 0) (locally (PI * k_v *
  cos theta)).
Proof.
  intro H. generalize (filterlim_locally_unique _ _ _ (H 0 2 1) (proj1 (pole__sine_limit 0 2 1))) PI_RGT_0.
  replace (PI * (2 * ((0 + PI) / (2 * PI)))) with PI by (field; apply PI_neq0). rewrite sin_PI, cos_0. lra.
Qed.
Theorem pole__rings_limit__false : ~ forall theta k_v, filterlim (fun v => fst (fst (g_of_rings theta k_v v))) (locally 0) (locally (PI * k_v * cos theta)).
Proof. intro H. generalize (filterlim_locally_unique _ _ _ (H 0 1) (proj1 (pole__rings_limit 0 1))) PI_RGT_0. rewrite cos_0. lra. Qed.
Theorem pole__surface_limit__false : ~ forall theta k_u k_v, dot (limit theta k_u k_v) (limit theta k_u k_v) = k_v ^ 2 * (k_u ^ 2 + (1 - k_u ^ 2) *
  sin (PI * (k_u * ((theta + PI) / (2 * PI)))) ^ 2).
Proof.
  intro H. generalize (H (- PI) 1 1) (proj2 (proj2 (proj2 (pole__surface_limit (- PI) 1 1)))). intros ->.
  replace (PI * (1 * ((- PI + PI) / (2 * PI)))) with 0 by (field; apply PI_neq0). rewrite sin_0. lra.
Qed.
Theorem pole__one_limit__false : ~ forall k_u k_v, k_v <> 0 -> (forall theta, - PI <= theta < PI -> limit theta k_u k_v = limit (- PI) k_u k_v) -> k_u = 0.
Proof. intro H. assert (2 = 0); [|lra]. apply (H 2 1 ltac:(lra)). intros. rewrite !limit_at_two. reflexivity. Qed.
