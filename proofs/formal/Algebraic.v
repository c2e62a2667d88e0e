(* The algebraic gradient. *)

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
