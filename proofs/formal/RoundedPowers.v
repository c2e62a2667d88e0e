(* Powers of cos t + i sin t by rounded squarings and products: what n of them cost. *)

From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Claim.
From Formal Require Statements.
Open Scope R_scope.

(* What squarings and products make of a computed number, each off by kappa times its result: its n-th power, in any order. *)
Inductive computed (z : C) (kappa : R) : nat -> C -> Prop :=
| itself : computed z kappa 1 z
| product (m n : nat) (a b c : C) : computed z kappa m a -> computed z kappa n b ->
    Cmod (c - a * b)%C <= kappa * Cmod (a * b)%C -> computed z kappa (m + n) c.

Definition on_circle (t : R) : C := (cos t, sin t).

Lemma on_circle_plus s t : on_circle (s + t) = (on_circle s * on_circle t)%C.
Proof. unfold on_circle, Cmult. simpl. rewrite cos_plus, sin_plus. f_equal; ring. Qed.
Lemma size_on_circle t : Cmod (on_circle t) = 1.
Proof. unfold Cmod, on_circle. cbn [fst snd]. rewrite <- sqrt_1. f_equal. generalize (sin2_cos2 t). unfold Rsqr. lra. Qed.
Lemma powers_begin z kappa n w : computed z kappa n w -> (1 <= n)%nat.
Proof. induction 1; lia. Qed.

(* One product: errors A - 1 and B - 1 become (1 + kappa) A B - 1. *)
Lemma one_product kappa A B s t a b c : 0 <= kappa -> Cmod (a - on_circle s)%C <= A - 1 -> Cmod (b - on_circle t)%C <= B - 1 -> Cmod (c - a * b)%C
  <= kappa * Cmod (a * b)%C -> Cmod (c - on_circle (s + t))%C <= (1 + kappa) * (A * B) - 1.
Proof.
  intros K Ha Hb Hc. rewrite on_circle_plus.
  assert (S : forall z r Z, Cmod (z - on_circle r)%C <= Z - 1 -> Cmod z <= Z) by (intros z r Z H; replace z with ((z - on_circle r) + on_circle r)%C
    by ring; eapply Rle_trans; [apply Cmod_triangle | rewrite size_on_circle; lra]).
  pose proof S _ _ _ Ha as Sa. pose proof S _ _ _ Hb as Sb.
  assert (Sab : Cmod (a * b)%C <= A * B) by (rewrite Cmod_mult; apply Rmult_le_compat; try apply Cmod_ge_0; assumption).
  replace (c - on_circle s * on_circle t)%C with ((c - a * b) + ((a - on_circle s) * b + on_circle s * (b - on_circle t)))%C by ring.
  eapply Rle_trans; [apply Cmod_triangle|]. eapply Rle_trans; [apply Rplus_le_compat_l, Cmod_triangle|].
  rewrite !Cmod_mult, size_on_circle. rewrite Cmod_mult in Hc, Sab.
  assert (Cmod (a - on_circle s)%C * Cmod b <= (A - 1) * B) by (apply Rmult_le_compat; try apply Cmod_ge_0; assumption).
  assert (kappa * (Cmod a * Cmod b) <= kappa * (A * B)) by (apply Rmult_le_compat_l; assumption). lra.
Qed.

(* The n-th power of a number within delta of cos t + i sin t is within (1 + delta)^n (1 + kappa)^(n - 1) - 1 of cos nt + i sin nt: by induction. *)
Theorem rounded_powers__error z t delta kappa n w : 0 <= kappa -> Cmod (z - on_circle t)%C <= delta -> computed z kappa n w -> Cmod (w - on_circle
  (INR n * t))%C <= (1 + delta) ^ n * (1 + kappa) ^ (n - 1) - 1.
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
Theorem rounded_powers__error__point : exists z t delta kappa w, 0 <= kappa /\ Cmod (z - on_circle t)%C <= delta /\ computed z kappa 2 w.
Proof.
  assert (N : forall z : C, Cmod (z - z)%C <= 0) by (intro z; replace (z - z)%C with (RtoC 0) by ring; rewrite Cmod_0; lra). exists (on_circle 0), 0,
    0, 0, (on_circle 0 * on_circle 0)%C. repeat split; [lra | apply N|].
  apply (product _ _ 1 1 (on_circle 0) (on_circle 0)); [apply itself | apply itself | rewrite Rmult_0_l; apply N].
Qed.
(* The base's error is not the power's: it grows with n. *)
Theorem rounded_powers__error__false : ~ forall z t delta kappa n w, 0 <= kappa -> Cmod (z - on_circle t)%C <= delta -> computed z kappa n w ->
  Cmod (w - on_circle (INR n * t))%C <= delta + kappa.
Proof.
  assert (U : on_circle 0 = RtoC 1) by (unfold on_circle; rewrite cos_0, sin_0; reflexivity). intro H. generalize (H (RtoC 2) 0 1 0 2%nat (RtoC 2 *
    RtoC 2)%C ltac:(lra)).
  rewrite Rmult_0_r, U, <- RtoC_mult, <- !RtoC_minus, !Cmod_R, !Rabs_pos_eq by lra. intro E. assert (2 * 2 - 1 <= 1 + 0); [|lra]. apply E; [lra|].
    rewrite RtoC_mult.
  apply (product _ _ 1 1 (RtoC 2) (RtoC 2)); [apply itself | apply itself|]. replace (RtoC 2 * RtoC 2 - RtoC 2 * RtoC 2)%C with (RtoC 0) by ring.
    rewrite Cmod_0. lra.
Qed.

(* The printed claims. *)
Lemma square_below m x : m - x >= 0 -> m + x >= 0 -> 0 <= m ^ 2 - x ^ 2.
Proof. intros. replace (m ^ 2 - x ^ 2) with ((m - x) * (m + x)) by ring. apply Rmult_le_pos; lra. Qed.
Lemma two_squares m f s a b : 0 <= m ^ 2 - f ^ 2 -> 0 <= m ^ 2 - s ^ 2 -> (f * a) ^ 2 + (s * b) ^ 2 <= m ^ 2 * (a ^ 2 + b ^ 2).
Proof. intros F S. generalize (Rmult_le_pos _ _ F (pow2_ge_0 a)) (Rmult_le_pos _ _ S (pow2_ge_0 b)). lra. Qed.
Theorem rounded_powers__three_roundings_of_one : Statements.rounded_powers__three_roundings_of_one.
Proof. claim. Qed.
Theorem rounded_powers__square : Statements.rounded_powers__square.
Proof.
  intros e f i o1 o2 r s -> -> F F' S S'. pose proof square_below e f F F' as Ef. pose proof square_below e s S S' as Es.
  repeat split; [ring | lra | lra |]. generalize (two_squares e f s ((r - i) * (i + r)) (2 * i * r) Ef Es).
  replace (((r - i) * (i + r)) ^ 2 + (2 * i * r) ^ 2) with ((i ^ 2 + r ^ 2) ^ 2) by ring. rewrite <- !Rmult_assoc. lra.
Qed.
Theorem rounded_powers__product : Statements.rounded_powers__product.
Proof.
  intros e f1 f4 i o1 o2 oi or r f2 f3 u U -> -> ->. set (m := u ^ 2 + 2 * u). intros. assert (0 <= m) by (unfold m; nra).
  assert (B : forall x, m - x >= 0 -> x + u ^ 2 + 2 * u >= 0 -> 0 <= m ^ 2 - x ^ 2) by (intros x P Q; apply square_below; [exact P | unfold m in *; lra]).
  pose proof B f1 ltac:(assumption) ltac:(assumption) as B1. pose proof B f2 ltac:(assumption) ltac:(assumption) as B2.
  pose proof B f3 ltac:(assumption) ltac:(assumption) as B3. pose proof B f4 ltac:(assumption) ltac:(assumption) as B4.
  assert (X : 2 * m ^ 2 * ((i * oi) ^ 2 + (or * r) ^ 2) >= (f1 * or * r - i * oi * f2) ^ 2).
  { generalize (two_squares m f1 f2 (or * r) (i * oi) B1 B2) (pow2_ge_0 (f1 * (or * r) + f2 * (i * oi))). lra. }
  assert (Y : 2 * m ^ 2 * ((i * or) ^ 2 + (oi * r) ^ 2) >= (f4 * i * or + f3 * oi * r) ^ 2).
  { generalize (two_squares m f4 f3 (i * or) (oi * r) B4 B3) (pow2_ge_0 (f4 * (i * or) - f3 * (oi * r))). lra. }
  assert (E : ((u + 1) ^ 3 - 1) ^ 2 >= 2 * m ^ 2).
  { assert (L : (u + 1) ^ 3 - 1 >= 3 / 2 * m) by (unfold m; generalize (pow_le u 3 ltac:(lra)) (pow2_ge_0 u); lra).
    assert (((u + 1) ^ 3 - 1) ^ 2 >= (3 / 2 * m) ^ 2) by (apply Rle_ge, pow_incr; lra). generalize (pow2_ge_0 m). lra. }
  repeat split; try lra; try ring.
  assert (N : 0 <= (i ^ 2 + r ^ 2) * (oi ^ 2 + or ^ 2)) by (apply Rmult_le_pos; apply Rplus_le_le_0_compat; apply pow2_ge_0).
  assert (Z : 2 * m ^ 2 * ((i * oi) ^ 2 + (or * r) ^ 2) + 2 * m ^ 2 * ((i * or) ^ 2 + (oi * r) ^ 2) = 2 * m ^ 2 * ((i ^ 2 + r ^ 2) * (oi ^ 2 + or ^
    2))) by ring.
  generalize (Rmult_le_compat_r _ _ _ N (Rge_le _ _ E)). lra.
Qed.
Theorem rounded_powers__power : Statements.rounded_powers__power.
Proof. claim. Qed.
Theorem rounded_powers__factors : Statements.rounded_powers__factors.
Proof. claim. Qed.
