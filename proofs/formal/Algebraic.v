(* The algebraic gradient. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Claim.
From Formal Require Statements.
Open Scope R_scope.

Theorem algebraic_gradient__square : Statements.algebraic_gradient__square.
Proof. red. intros. rewrite cos_2a, sin_2a. split; lines; ring. Qed.
Theorem algebraic_gradient__product : Statements.algebraic_gradient__product.
Proof. red. intros. rewrite cos_plus, sin_plus. split; lines; ring. Qed.
Theorem algebraic_gradient__reciprocal : Statements.algebraic_gradient__reciprocal.
Proof. red. intros. split; lines; lra. Qed.

(* The powers of cos t + i sin t. *)
Lemma de_moivre t a b : a 0%nat = 1 -> (forall n, a (S n) = a n * cos t - b n * sin t) -> b 0%nat = 0 -> (forall n, b (S n) = b n * cos t + a n *
  sin t) -> forall n, a n = cos (INR n * t) /\ b n = sin (INR n * t).
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
  red. intros. powers_of (theta + PI). destruct (de_moivre PI sign_ (fun _ => 0)) with (n := n) as [E F]; trivial; [intro; try match goal with S :
    forall n, sign_ (S n) = _ |- _ => rewrite S end; rewrite cos_PI, sin_PI; ring..|].
  replace (PI * (2 * INR n * (theta + PI) / (2 * PI))) with ((theta + PI) * INR n) by (field; apply PI_neq0).
  rewrite E, (Rmult_comm PI), <- F. replace ((theta + PI) * INR n) with (INR n * theta + INR n * PI) by ring.
  rewrite cos_plus, sin_plus, <- F. repeat split; ring.
Qed.

