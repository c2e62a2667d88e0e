(* The algebraic gradient, and the chart of the sphere. *)

From Coq Require Import Reals Lra Psatz Lia.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Vectors Fields Claim.
From Formal Require Statements.
Open Scope R_scope.

Theorem algebraic_gradient__square : Statements.algebraic_gradient__square.
Proof. red. intros. rewrite cos_2a, sin_2a. split; lines; ring. Qed.
Theorem algebraic_gradient__product : Statements.algebraic_gradient__product.
Proof. red. intros. rewrite cos_plus, sin_plus. split; lines; ring. Qed.
Theorem algebraic_gradient__reciprocal : Statements.algebraic_gradient__reciprocal.
Proof. red. intros. split; lines; lra. Qed.

(* The powers of cos t + i sin t. *)
Lemma de_moivre (t : R) (a b : nat -> R) : a 0%nat = 1 -> (forall n, a (S n) = a n * cos t - b n * sin t) -> b 0%nat = 0 ->
  (forall n, b (S n) = b n * cos t + a n * sin t) -> forall n, a n = cos (INR n * t) /\ b n = sin (INR n * t).
Proof.
  intros A0 A B0 B n. induction n as [|n [C D]]; [cbn [INR]; rewrite Rmult_0_l, cos_0, sin_0; auto|].
  rewrite A, B, C, D, S_INR, Rmult_plus_distr_r, Rmult_1_l, cos_plus, sin_plus. split; ring.
Qed.
Ltac powers_of t := match goal with |- context [?b_ ?n = sin _] => match goal with |- context [?a n = cos _] =>
  destruct (de_moivre t a b_) with (n := n) as [C D]; try assumption;
  try (intro; rewrite ?cos_neg, ?sin_neg, ?neg_cos, ?neg_sin; match goal with H : _ |- _ => rewrite H; ring end); rewrite C, D;
  replace (INR n * t) with (t * INR n) by ring end end.
Theorem algebraic_gradient__power : Statements.algebraic_gradient__power.
Proof. red. intros. powers_of alpha. auto. Qed.
Theorem algebraic_gradient__negative_power : Statements.algebraic_gradient__negative_power.
Proof. red. intros. powers_of (- alpha). replace (alpha * - INR n) with (- alpha * INR n) by ring. auto. Qed.
Theorem algebraic_gradient__in_v : Statements.algebraic_gradient__in_v.
Proof. red. intros. powers_of phi. replace (PI * _) with (phi * INR n) by (field; apply PI_neq0). auto. Qed.
Theorem algebraic_gradient__rings_in_v : Statements.algebraic_gradient__rings_in_v.
Proof. red. intros. powers_of phi. replace (PI * _) with (phi * INR n) by (field; apply PI_neq0). auto. Qed.
Theorem algebraic_gradient__in_u : Statements.algebraic_gradient__in_u.
Proof.
  red. intros. powers_of (theta + PI). destruct (de_moivre PI sign_ (fun _ => 0)) with (n := n) as [E F]; trivial; [intro; rewrite ?H4, cos_PI, sin_PI; ring..|].
  replace (PI * (2 * INR n * (theta + PI) / (2 * PI))) with ((theta + PI) * INR n) by (field; apply PI_neq0).
  rewrite E, (Rmult_comm PI), <- F. replace ((theta + PI) * INR n) with (INR n * theta + INR n * PI) by ring.
  rewrite cos_plus, sin_plus, <- F. repeat split; ring.
Qed.

(* The n-th power of a + ib by the printed product. *)
Fixpoint complex_power (n : nat) (a b : R) : R * R :=
  match n with
  | O => (1, 0)
  | S n => let (c, d) := complex_power n a b in (complex_product.product_real c d a b, complex_product.product_imaginary c d a b)
  end.
Lemma complex_power_at (t : R) (n : nat) : complex_power n (cos t) (sin t) = (cos (INR n * t), sin (INR n * t)).
Proof.
  rewrite (surjective_pairing (complex_power n _ _)). destruct (de_moivre t (fun k => fst (complex_power k (cos t) (sin t))) (fun k => snd (complex_power k (cos t) (sin t)))) with (n := n) as [-> ->];
    trivial; intro k; cbn [complex_power]; destruct (complex_power k _ _); unfold complex_product.product_real, complex_product.product_imaginary; cbn [fst snd]; ring.
Qed.

(* Powers of the printed bases, and of their conjugates (s = -1), are the printed factors for the wave numbers 2n and n, and -2n and -n. *)
Theorem algebraic_gradient__printed_bases (n : nat) (s theta phi : R) : s = 1 \/ s = -1 -> let u := (theta + PI) / (2 * PI) in let v := phi / PI in let k := s * INR n in
  complex_power n (algebraic_bases.base_u_real (cos theta)) (s * algebraic_bases.base_u_imaginary (sin theta)) = (gradient_sine.cos_u u (2 * k), gradient_sine.sin_u u (2 * k)) /\
  complex_power n (algebraic_bases.base_v_real (cos phi)) (s * algebraic_bases.base_v_imaginary (sin phi)) = (gradient_sine.cos_v v k, gradient_sine.sin_v v k) /\
  complex_power n (algebraic_bases.base_v_real (cos phi)) (s * algebraic_bases.base_v_imaginary (sin phi)) = (gradient_rings.cos_v v (k / 2), gradient_rings.sin_v v (k / 2)).
Proof.
  intro E. cbv zeta. unfold algebraic_bases.base_u_real, algebraic_bases.base_u_imaginary, algebraic_bases.base_v_real, algebraic_bases.base_v_imaginary.
  assert (C : forall t, cos t = cos (s * t) /\ s * sin t = sin (s * t)) by (intro; destruct E as [-> | ->]; [replace (1 * t) with t by ring | replace (-1 * t) with (- t) by ring; rewrite cos_neg, sin_neg]; split; ring).
  rewrite <- neg_cos, <- neg_sin. rewrite (proj2 (C (theta + PI))), (proj1 (C (theta + PI))), (proj2 (C phi)), (proj1 (C phi)), !complex_power_at. unfold_fields.
  repeat split; f_equal; f_equal; field; apply PI_neq0.
Qed.
Theorem algebraic_gradient__printed_bases__point : exists s : R, s = 1 \/ s = -1.
Proof. exists 1. auto. Qed.
(* Without the conjugate it is not so. *)
Theorem algebraic_gradient__printed_bases__false : ~ forall n phi, complex_power n (algebraic_bases.base_v_real (cos phi)) (algebraic_bases.base_v_imaginary (sin phi)) =
  (gradient_sine.cos_v (phi / PI) (- INR n), gradient_sine.sin_v (phi / PI) (- INR n)).
Proof.
  intro H. generalize (f_equal snd (H 1%nat (PI / 2))). unfold algebraic_bases.base_v_real, algebraic_bases.base_v_imaginary, gradient_sine.sin_v. rewrite complex_power_at. cbn [snd INR].
  replace (PI * (- (1) * (PI / 2 / PI))) with (- (PI / 2)) by (field; apply PI_neq0). rewrite Rmult_1_l, sin_neg, sin_PI2. lra.
Qed.

(* The chart *)

Lemma atan_of_tan (t : R) : - PI / 2 < t < PI / 2 -> atan (sin t / cos t) = t.
Proof. intro T. change (sin t / cos t) with (tan t). apply atan_tan. lra. Qed.

(* atan2 gives an angle back from its sine and cosine. *)
Lemma atan2_of_angle (t : R) : - PI < t <= PI -> atan2 (sin t) (cos t) = t.
Proof.
  intro T. generalize PI_RGT_0. intro P. unfold atan2.
  destruct (Rlt_dec 0 (cos t)) as [C|C].
  - apply atan_of_tan. split; apply Rnot_le_lt; intro L.
    + assert (cos (- t) <= 0) by (apply cos_le_0; lra). rewrite cos_neg in *. lra.
    + assert (cos t <= 0) by (apply cos_le_0; lra). lra.
  - destruct (Rlt_dec (cos t) 0) as [D|D].
    + destruct (Rle_dec 0 (sin t)) as [S|S].
      * assert (A : PI / 2 < t).
        { apply Rnot_le_lt. intro L. destruct (Rle_dec (- (PI / 2)) t) as [Q|Q]; [generalize (cos_ge_0 t ltac:(lra) L); lra|].
          assert (0 < sin (- t)) by (apply sin_gt_0; lra). rewrite sin_neg in *. lra. }
        replace (sin t / cos t) with (sin (t - PI) / cos (t - PI)); [rewrite atan_of_tan by lra; ring|].
        rewrite sin_minus, cos_minus, sin_PI, cos_PI. field. lra.
      * assert (A : t < - (PI / 2)).
        { apply Rnot_le_lt. intro L. destruct (Rle_dec t (PI / 2)) as [Q|Q]; [generalize (cos_ge_0 t ltac:(lra) Q); lra|].
          generalize (sin_ge_0 t ltac:(lra) ltac:(lra)). lra. }
        replace (sin t / cos t) with (sin (t + PI) / cos (t + PI)); [rewrite atan_of_tan by lra; ring|].
        rewrite neg_sin, neg_cos. field. lra.
    + assert (Z : cos t = 0) by lra. destruct (Rlt_dec 0 (sin t)) as [S|S].
      * destruct (Rtotal_order t (PI / 2)) as [L|[->|L]]; [exfalso|reflexivity|exfalso].
        -- destruct (Rlt_dec (- (PI / 2)) t) as [Q|Q]; [generalize (cos_gt_0 t Q L); lra|].
           assert (0 < sin (- t)) by (apply sin_gt_0; lra). rewrite sin_neg in *. lra.
        -- generalize (cos_lt_0 t L ltac:(lra)). lra.
      * destruct (Rlt_dec (sin t) 0) as [S'|S'].
        -- destruct (Rtotal_order t (- PI / 2)) as [L|[->|L]]; [exfalso|reflexivity|exfalso].
           ++ assert (cos (- t) < 0) by (apply cos_lt_0; lra). rewrite cos_neg in *. lra.
           ++ destruct (Rlt_dec t (PI / 2)) as [Q|Q]; [generalize (cos_gt_0 t ltac:(lra) Q); lra|]. generalize (sin_ge_0 t ltac:(lra) ltac:(lra)). lra.
        -- exfalso. generalize (sin_squared t). rewrite Z. assert (E : sin t = 0) by lra. rewrite E. lra.
Qed.

(* For theta in (-pi, pi] and phi in [0, pi]: u is in [0, 1) and v in [0, 1]; u = (theta + pi)/2pi where theta < pi, and 0 where theta = pi. *)
Lemma chart_inside (theta phi : R) : - PI < theta <= PI -> 0 <= phi <= PI ->
  let u := chart.u (cos theta) (sin theta) in let v := chart.v (cos phi) (sin phi) in
  v = phi / PI /\ (theta < PI -> u = (theta + PI) / (2 * PI)) /\ (theta = PI -> u = 0) /\ 0 <= u < 1 /\ 0 <= v <= 1.
Proof.
  intros T F. cbv zeta. generalize PI_RGT_0. intro P. unfold chart.u, chart.v, chart.u_closed, atan2pi. rewrite !atan2_of_angle by lra.
  assert (E : 1 / 2 * (theta / PI) + 1 / 2 = (theta + PI) / (2 * PI)) by (field; lra). rewrite E.
  assert (V : 0 <= phi / PI <= 1). { split; apply Rmult_le_reg_r with PI; trivial; unfold Rdiv; rewrite ?Rmult_assoc, ?Rinv_l by lra; lra. }
  assert (L : theta < PI -> (theta + PI) / (2 * PI) < 1). { intro. apply Rmult_lt_reg_r with (2 * PI); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (G : 0 <= (theta + PI) / (2 * PI)) by (apply Rlt_le, Rdiv_lt_0_compat; lra).
  destruct (Rlt_dec _ 1) as [S|S]; (split; [reflexivity|]); (split; [|split; [|split; [|exact V]]]); try lra; intro Q; try reflexivity.
  - subst theta. exfalso. replace ((PI + PI) / (2 * PI)) with 1 in S by (field; lra). lra.
Qed.
Theorem chart__inside__point : exists theta phi : R, - PI < theta <= PI /\ 0 <= phi <= PI.
Proof. exists 0, 0. generalize PI_RGT_0. lra. Qed.

(* Back from (u, v) come the same cosines and sines, on the seam too. *)
Theorem chart__round_trip__false : ~ forall theta, chart.u (cos theta) (sin theta) = (theta + PI) / (2 * PI).
Proof.
  intro H. generalize (H PI). destruct (chart_inside PI 0) as (_ & _ & S & _); [generalize PI_RGT_0; lra..|]. rewrite S by reflexivity.
  replace ((PI + PI) / (2 * PI)) with 1 by (field; generalize PI_RGT_0; lra). lra.
Qed.

(* N(u, v) = (-sin pi v cos 2 pi u, -sin pi v sin 2 pi u, cos pi v) has length 1. *)
Definition N_of_chart (u v : R) : vector :=
  (unit_normal.normal_x (chart_inverse.cos_theta u) (chart_inverse.sin_phi v), unit_normal.normal_y (chart_inverse.sin_theta u) (chart_inverse.sin_phi v),
   unit_normal.normal_z (chart_inverse.cos_phi v)).
Lemma chart_inverse_unit (u v : R) :
  N_of_chart u v = (- sin (PI * v) * cos (PI * (2 * u)), - sin (PI * v) * sin (PI * (2 * u)), cos (PI * v)) /\ magnitude (N_of_chart u v) = 1.
Proof.
  unfold N_of_chart, magnitude, dot, unit_normal.normal_x, unit_normal.normal_y, unit_normal.normal_z, chart_inverse.cos_theta, chart_inverse.sin_theta,
    chart_inverse.cos_phi, chart_inverse.sin_phi. split; [apply f_equal2; [apply f_equal2; ring | reflexivity]|].
  rewrite <- sqrt_1. f_equal. ring [(sin_squared (PI * v)) (sin_squared (PI * (2 * u)))].
Qed.
(* Where sin phi > 0, N gives back the sines and cosines. *)
Theorem chart_inverse__recovered__point : exists phi, 0 < sin phi.
Proof. exists (PI / 2). rewrite sin_PI2. lra. Qed.
Theorem chart_inverse__recovered__false : ~ forall theta phi, sin phi = sqrt ((cos theta * sin phi) ^ 2 + (sin phi * sin theta) ^ 2).
Proof.
  intro H. generalize (H 0 (- (PI / 2))). rewrite sin_neg, sin_PI2. generalize (sqrt_pos ((cos 0 * - (1)) ^ 2 + (- (1) * sin 0) ^ 2)). lra.
Qed.
