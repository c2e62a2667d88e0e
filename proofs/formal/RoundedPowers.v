(* Powers of cos t + i sin t by rounded squarings and products: what n of them cost. *)

From Coq Require Import Reals Lra Psatz Lia.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* What squarings and products make of a computed number, each off by kappa times its result: its n-th power, in any order. *)
Inductive computed (z : C) (kappa : R) : nat -> C -> Prop :=
| itself : computed z kappa 1 z
| product (m n : nat) (a b c : C) : computed z kappa m a -> computed z kappa n b ->
    Cmod (c - a * b)%C <= kappa * Cmod (a * b)%C -> computed z kappa (m + n) c.

Definition on_circle (t : R) : C := (cos t, sin t).

Lemma on_circle_plus (s t : R) : on_circle (s + t) = (on_circle s * on_circle t)%C.
Proof. unfold on_circle, Cmult. simpl. rewrite cos_plus, sin_plus. f_equal; ring. Qed.
Lemma size_on_circle (t : R) : Cmod (on_circle t) = 1.
Proof. unfold Cmod, on_circle. cbn [fst snd]. rewrite <- sqrt_1. f_equal. generalize (sin2_cos2 t). unfold Rsqr. lra. Qed.
Lemma powers_begin (z : C) (kappa : R) (n : nat) (w : C) : computed z kappa n w -> (1 <= n)%nat.
Proof. induction 1; lia. Qed.

(* One product: errors A - 1 and B - 1 become (1 + kappa) A B - 1. *)
Lemma one_product (kappa A B s t : R) (a b c : C) : 0 <= kappa -> Cmod (a - on_circle s)%C <= A - 1 -> Cmod (b - on_circle t)%C <= B - 1 ->
  Cmod (c - a * b)%C <= kappa * Cmod (a * b)%C -> Cmod (c - on_circle (s + t))%C <= (1 + kappa) * (A * B) - 1.
Proof.
  intros K Ha Hb Hc. rewrite on_circle_plus.
  assert (Sa : Cmod a <= A).
  { replace a with ((a - on_circle s) + on_circle s)%C by ring. eapply Rle_trans; [apply Cmod_triangle|]. rewrite size_on_circle. lra. }
  assert (Sb : Cmod b <= B).
  { replace b with ((b - on_circle t) + on_circle t)%C by ring. eapply Rle_trans; [apply Cmod_triangle|]. rewrite size_on_circle. lra. }
  assert (Sab : Cmod (a * b)%C <= A * B) by (rewrite Cmod_mult; apply Rmult_le_compat; try apply Cmod_ge_0; assumption).
  replace (c - on_circle s * on_circle t)%C with ((c - a * b) + ((a - on_circle s) * b + on_circle s * (b - on_circle t)))%C by ring.
  eapply Rle_trans; [apply Cmod_triangle|]. eapply Rle_trans; [apply Rplus_le_compat_l, Cmod_triangle|].
  rewrite !Cmod_mult, size_on_circle. rewrite Cmod_mult in Hc, Sab.
  assert (Cmod (a - on_circle s)%C * Cmod b <= (A - 1) * B) by (apply Rmult_le_compat; try apply Cmod_ge_0; assumption).
  assert (kappa * (Cmod a * Cmod b) <= kappa * (A * B)) by (apply Rmult_le_compat_l; assumption). lra.
Qed.

(* The n-th power of a number within delta of cos t + i sin t is within (1 + delta)^n (1 + kappa)^(n - 1) - 1 of cos nt + i sin nt: by induction. *)
Theorem rounded_powers__error (z : C) (t delta kappa : R) (n : nat) (w : C) : 0 <= kappa -> Cmod (z - on_circle t)%C <= delta -> computed z kappa n w ->
  Cmod (w - on_circle (INR n * t))%C <= (1 + delta) ^ n * (1 + kappa) ^ (n - 1) - 1.
Proof.
  intros K D P. induction P as [|m n a b c Pa IHa Pb IHb Own].
  - replace (INR 1 * t) with t by (simpl; ring). simpl. lra.
  - generalize (powers_begin _ _ _ _ Pa) (powers_begin _ _ _ _ Pb). intros M N.
    rewrite plus_INR, Rmult_plus_distr_r.
    replace ((1 + delta) ^ (m + n) * (1 + kappa) ^ (m + n - 1))
      with ((1 + kappa) * (((1 + delta) ^ m * (1 + kappa) ^ (m - 1)) * ((1 + delta) ^ n * (1 + kappa) ^ (n - 1)))).
    + apply one_product with a b; assumption.
    + rewrite pow_add. replace (m + n - 1)%nat with (S ((m - 1) + (n - 1))) by lia. rewrite <- tech_pow_Rmult, pow_add. ring.
Qed.
Theorem rounded_powers__error__point : exists (z : C) (t delta kappa : R) (w : C), 0 <= kappa /\ Cmod (z - on_circle t)%C <= delta /\ computed z kappa 2 w.
Proof.
  exists (on_circle 0), 0, 0, 0, (on_circle 0 * on_circle 0)%C. split; [lra|]. split.
  - replace (on_circle 0 - on_circle 0)%C with (RtoC 0) by (symmetry; apply Cplus_opp_r). rewrite Cmod_0. lra.
  - apply (product _ _ 1 1 (on_circle 0) (on_circle 0)); [apply itself | apply itself |].
    replace (on_circle 0 * on_circle 0 - on_circle 0 * on_circle 0)%C with (RtoC 0) by (symmetry; apply Cplus_opp_r). rewrite Cmod_0, Rmult_0_l. lra.
Qed.
(* The base's error is not the power's: it grows with n. *)
Theorem rounded_powers__error__false : ~ forall (z : C) (t delta kappa : R) (n : nat) (w : C), 0 <= kappa -> Cmod (z - on_circle t)%C <= delta -> computed z kappa n w ->
  Cmod (w - on_circle (INR n * t))%C <= delta + kappa.
Proof.
  intro H. assert (D : Cmod (RtoC 2 - on_circle 0)%C <= 1).
  { unfold on_circle. rewrite cos_0, sin_0. replace (RtoC 2 - (1, 0))%C with (RtoC 1) by (unfold RtoC, Cminus, Cplus, Copp; simpl; f_equal; ring). rewrite Cmod_1. lra. }
  generalize (H (RtoC 2) 0 1 0 2%nat (RtoC 2 * RtoC 2)%C ltac:(lra) D). intro E.
  assert (P : computed (RtoC 2) 0 2 (RtoC 2 * RtoC 2)%C).
  { apply (product _ _ 1 1 (RtoC 2) (RtoC 2)); [apply itself | apply itself |].
    replace (RtoC 2 * RtoC 2 - RtoC 2 * RtoC 2)%C with (RtoC 0) by (symmetry; apply Cplus_opp_r). rewrite Cmod_0, Rmult_0_l. lra. }
  specialize (E P). revert E. rewrite Rmult_0_r. unfold on_circle. rewrite cos_0, sin_0.
  replace (RtoC 2 * RtoC 2 - (1, 0))%C with (RtoC 3) by (unfold RtoC, Cminus, Cplus, Cmult, Copp; simpl; f_equal; ring).
  rewrite Cmod_R, Rabs_pos_eq by lra. lra.
Qed.
