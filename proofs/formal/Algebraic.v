(* The algebraic gradient, and the chart of the sphere. *)

From Coq Require Import Reals Lra Psatz Lia.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Vectors Fields.
Open Scope R_scope.

(* The n-th power of a + ib by the printed product. *)
Fixpoint complex_power (n : nat) (a b : R) : R * R :=
  match n with
  | O => (1, 0)
  | S n => let (c, d) := complex_power n a b in (complex_product.product_real c d a b, complex_product.product_imaginary c d a b)
  end.

Lemma de_moivre (n : nat) (t : R) : complex_power n (cos t) (sin t) = (cos (INR n * t), sin (INR n * t)).
Proof.
  induction n as [|n IH]; [simpl; rewrite Rmult_0_l, cos_0, sin_0; reflexivity|]. cbn [complex_power]. rewrite IH, S_INR.
  unfold complex_product.product_real, complex_product.product_imaginary. replace ((INR n + 1) * t) with (INR n * t + t) by ring.
  rewrite cos_plus, sin_plus. f_equal; ring.
Qed.
Lemma power_of_negative (n : nat) (a b : R) : complex_power n (- a) (- b) = ((-1) ^ n * fst (complex_power n a b), (-1) ^ n * snd (complex_power n a b)).
Proof.
  induction n as [|n IH]; [simpl; f_equal; ring|]. cbn [complex_power]. rewrite IH. destruct (complex_power n a b) as [c d].
  unfold complex_product.product_real, complex_product.product_imaginary. simpl. f_equal; ring.
Qed.

(* (-cos theta - i sin theta)^n = (-1)^n (cos n theta + i sin n theta), for every whole n. *)
Theorem algebraic_gradient__power (n : nat) (theta : R) :
  complex_power n (algebraic_bases.base_u_real (cos theta)) (algebraic_bases.base_u_imaginary (sin theta)) =
  ((-1) ^ n * cos (INR n * theta), (-1) ^ n * sin (INR n * theta)).
Proof.
  unfold algebraic_bases.base_u_real, algebraic_bases.base_u_imaginary. rewrite power_of_negative, de_moivre. reflexivity.
Qed.
Theorem algebraic_gradient__power__false : ~ forall n theta, complex_power n (- cos theta) (- sin theta) = (cos (INR n * theta), sin (INR n * theta)).
Proof. intro H. generalize (f_equal fst (H 1%nat 0)). cbn. unfold complex_product.product_real. rewrite !Rmult_0_r, cos_0, sin_0. lra. Qed.

(* With pi u = (theta + pi)/2 these are cos(pi k_u u) and sin(pi k_u u) for k_u = 2n. *)
Theorem algebraic_gradient__in_u (n : nat) (theta : R) : let u := (theta + PI) / (2 * PI) in let k_u := 2 * INR n in
  complex_power n (algebraic_bases.base_u_real (cos theta)) (algebraic_bases.base_u_imaginary (sin theta)) =
  (cos (PI * (k_u * u)), sin (PI * (k_u * u))).
Proof.
  cbv zeta. generalize PI_RGT_0. intro P. unfold algebraic_bases.base_u_real, algebraic_bases.base_u_imaginary.
  rewrite <- neg_cos, <- neg_sin, de_moivre. replace (PI * (2 * INR n * ((theta + PI) / (2 * PI)))) with (INR n * (theta + PI)) by (field; lra). reflexivity.
Qed.
(* With pi v = phi, (cos phi + i sin phi)^n has cos(pi k_v v) and sin(pi k_v v) for k_v = n, and the factors of rings for 2 k_v = n. *)
Theorem algebraic_gradient__in_v (n : nat) (phi : R) : let v := phi / PI in let k_v := INR n in
  complex_power n (algebraic_bases.base_v_real (cos phi)) (algebraic_bases.base_v_imaginary (sin phi)) = (gradient_sine.cos_v v k_v, gradient_sine.sin_v v k_v) /\
  complex_power n (algebraic_bases.base_v_real (cos phi)) (algebraic_bases.base_v_imaginary (sin phi)) = (gradient_rings.cos_v v (k_v / 2), gradient_rings.sin_v v (k_v / 2)).
Proof.
  cbv zeta. generalize PI_RGT_0. intro P. unfold algebraic_bases.base_v_real, algebraic_bases.base_v_imaginary. rewrite de_moivre. unfold_fields.
  replace (PI * (INR n * (phi / PI))) with (INR n * phi) by (field; lra).
  replace (PI * (2 * (INR n / 2) * (phi / PI))) with (INR n * phi) by (field; lra). split; reflexivity.
Qed.
(* A negative wave number conjugates. *)
Theorem algebraic_gradient__negative_power (n : nat) (phi : R) :
  (fst (complex_power n (cos phi) (sin phi)), - snd (complex_power n (cos phi) (sin phi))) = (cos (- INR n * phi), sin (- INR n * phi)).
Proof. rewrite de_moivre. simpl. rewrite Ropp_mult_distr_l_reverse, cos_neg, sin_neg. reflexivity. Qed.
(* The printed square and product are those of complex numbers. *)
Theorem algebraic_gradient__product (a b c d : R) :
  Cmult (a, b) (c, d) = (complex_product.product_real a b c d, complex_product.product_imaginary a b c d) /\
  Cmult (a, b) (a, b) = (complex_square.product_real a b, complex_square.product_imaginary a b).
Proof.
  unfold Cmult, complex_product.product_real, complex_product.product_imaginary, complex_square.product_real, complex_square.product_imaginary.
  split; f_equal; simpl; ring.
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
Theorem algebraic_gradient__in_v__false : ~ forall n phi, complex_power n (cos phi) (sin phi) = (gradient_rings.cos_v (phi / PI) (INR n), gradient_rings.sin_v (phi / PI) (INR n)).
Proof.
  intro H. generalize (f_equal fst (H 1%nat (PI / 2))) PI_RGT_0. cbn. unfold complex_product.product_real, gradient_rings.cos_v. intros E P. revert E.
  replace (PI * (2 * 1 * (PI / 2 / PI))) with PI by (field; lra). rewrite cos_PI2, sin_PI2, cos_PI. lra.
Qed.
