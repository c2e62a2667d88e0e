(* The error of the central difference beside a crease, and its areas. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Fields Creases.
Open Scope R_scope.

(* Within eps of a crease of |sin(pi k u)| the difference, cos(pi k eps) sin(pi k delta)/eps, less the slope, sign(delta) pi k cos(pi k delta),
   is pi k (|delta|/eps - 1) in size, up to 2/3 pi k (pi k eps)^2. *)
Theorem (* clause 1 *) crease_error_area__tent (k delta epsilon : R) : 0 < k -> 0 < Rabs delta < epsilon ->
  Rabs (cos (PI * (k * epsilon)) * sin (PI * (k * delta)) / epsilon - sign delta * PI * k * cos (PI * (k * delta)) - sign delta * (PI * k * (Rabs delta / epsilon - 1))) <=
  2 / 3 * (PI * k) * (PI * k * epsilon) ^ 2.
Proof.
  intros K D. generalize PI_RGT_0. intro P.
  assert (H : forall t, 0 < t < epsilon -> Rabs (cos (PI * (k * epsilon)) * sin (PI * (k * t)) / epsilon - PI * k * cos (PI * (k * t)) - PI * k * (t / epsilon - 1)) <=
    2 / 3 * (PI * k) * (PI * k * epsilon) ^ 2).
  { intros t T. set (a := PI * (k * t)). set (b := PI * (k * epsilon)). assert (Q : 0 < PI * k) by (apply Rmult_lt_0_compat; assumption).
    assert (A : 0 < a < b) by (unfold a, b; split; nra).
    replace (cos b * sin a / epsilon - PI * k * cos a - PI * k * (t / epsilon - 1)) with ((cos b * sin a - a) / epsilon + PI * k * (1 - cos a)) by (unfold a; field; lra).
    assert (S : a - a ^ 3 / 6 <= sin a <= a) by (split; [apply sine_from_below; lra | left; apply sin_lt_x; lra]).
    assert (Ca : 1 - a ^ 2 / 2 <= cos a <= 1) by (split; [apply cosine_from_below | apply COS_bound]).
    assert (Cb : 1 - b ^ 2 / 2 <= cos b <= 1) by (split; [apply cosine_from_below | apply COS_bound]).
    assert (B3 : a ^ 2 <= b ^ 2) by nra.
    assert (U : cos b * sin a - a <= 0 /\ - (2 / 3 * b ^ 3) <= cos b * sin a - a).
    { destruct (Rle_dec 0 (sin a)) as [Z|Z].
      - split; [nra|]. assert ((1 - b ^ 2 / 2) * sin a <= cos b * sin a) by (apply Rmult_le_compat_r; lra).
        assert (sin a * b ^ 2 <= b ^ 3) by (replace (b ^ 3) with (b * b ^ 2) by ring; apply Rmult_le_compat_r; nra).
        assert (a ^ 3 <= b ^ 3) by (replace (a ^ 3) with (a * a ^ 2) by ring; replace (b ^ 3) with (b * b ^ 2) by ring; apply Rmult_le_compat; nra). nra.
      - assert (-1 <= cos b) by (generalize (COS_bound b); lra). assert (a ^ 3 > 6 * a) by lra. assert (a ^ 3 <= b ^ 3) by (replace (a ^ 3) with (a * a ^ 2) by ring; replace (b ^ 3) with (b * b ^ 2) by ring; apply Rmult_le_compat; nra).
        assert (a ^ 2 > 6) by nra. assert (1 <= b) by nra. assert (X : - sin a <= a ^ 3 / 6 - a) by lra.
        assert (cos b * sin a <= - sin a) by nra. assert (sin a <= cos b * sin a) by nra. assert (- sin a <= 1) by (generalize (SIN_bound a); lra). split; [|nra]. nra. }
    replace (PI * k * epsilon) with b by (unfold b; ring). apply Rabs_le.
    assert (E : (cos b * sin a - a) / epsilon = (cos b * sin a - a) / b * (PI * k)) by (unfold b; field; lra). rewrite E.
    assert (V : - (2 / 3 * b ^ 2) <= (cos b * sin a - a) / b <= 0).
    { assert (W : (cos b * sin a - a) / b * b = cos b * sin a - a) by (field; lra).
      split; apply Rmult_le_reg_r with b; try lra; rewrite W; nra. }
    split; nra. }
  unfold Rabs in D |- *. destruct (Rcase_abs delta) as [n|n].
  - rewrite sign_eq_m1 by exact n. generalize (H (- delta) ltac:(lra)). replace (PI * (k * - delta)) with (- (PI * (k * delta))) by ring. rewrite sin_neg, cos_neg.
    rewrite <- Rabs_Ropp. intro G. match goal with G : Rabs ?x <= _ |- (if Rcase_abs ?y then _ else _) <= _ => replace y with x by (field; lra) end. exact G.
  - rewrite sign_eq_1 by lra. generalize (H delta ltac:(lra)). intro G. rewrite !Rmult_1_l. exact G.
Qed.
Theorem crease_error_area__tent__point : exists k delta epsilon : R, 0 < k /\ 0 < Rabs delta < epsilon.
Proof. exists 1, (1/2), 1. rewrite Rabs_pos_eq by lra. lra. Qed.
Theorem crease_error_area__tent__false : ~ forall k delta epsilon, 0 < k -> 0 < Rabs delta < epsilon ->
  cos (PI * (k * epsilon)) * sin (PI * (k * delta)) / epsilon = sign delta * PI * k * cos (PI * (k * delta)).
Proof.
  intro H. generalize (H 1 (1/2) 1 ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra)). rewrite !Rmult_1_l, Rmult_1_r, cos_PI. replace (PI * (1/2)) with (PI / 2) by field.
  rewrite sin_PI2, cos_PI2. lra.
Qed.

(* The square of the tent has the area eps/3 on either side of the crease. *)
Theorem (* clause 2 *) crease_error_area__tents (epsilon : R) : 0 < epsilon -> is_RInt (fun d => (d / epsilon - 1) ^ 2) 0 epsilon (epsilon / 3).
Proof.
  intro E. replace (epsilon / 3) with (minus ((epsilon - epsilon) ^ 3 / (3 * epsilon ^ 2)) ((0 - epsilon) ^ 3 / (3 * epsilon ^ 2))) by (unfold minus, plus, opp; simpl; field; lra).
  apply (is_RInt_derive (fun d => (d - epsilon) ^ 3 / (3 * epsilon ^ 2))).
  - intros x _. auto_derive; trivial. field. lra.
  - intros x _. apply (ex_derive_continuous (fun d => (d / epsilon - 1) ^ 2)). auto_derive. trivial.
Qed.
(* The mean of sin^2(pi k v) over the chart is 1/2. *)
Theorem (* clause 2 *) crease_error_area__mean_of_a_square (k : nat) : (0 < k)%nat -> is_RInt (fun v => sin (PI * (INR k * v)) ^ 2) 0 1 (1/2).
Proof.
  intro K. assert (Q : 0 < INR k) by (apply lt_0_INR; exact K). generalize PI_RGT_0. intro P.
  replace (1/2) with (minus (1 / 2 - sin (2 * (PI * (INR k * 1))) / (4 * PI * INR k)) (0 / 2 - sin (2 * (PI * (INR k * 0))) / (4 * PI * INR k))).
  - apply (is_RInt_derive (fun v => v / 2 - sin (2 * (PI * (INR k * v))) / (4 * PI * INR k))).
    + intros x _. auto_derive; trivial. rewrite cos_2a_sin. field. split; lra.
    + intros x _. apply (ex_derive_continuous (fun v => sin (PI * (INR k * v)) ^ 2)). auto_derive. trivial.
  - rewrite !Rmult_0_r, sin_0. replace (2 * (PI * (INR k * 1))) with (0 + 2 * INR k * PI) by ring. rewrite sin_period, sin_0. unfold minus, plus, opp. simpl. field. split; lra.
Qed.
(* Tents at k_u creases, of height pi k_u |sin(pi k_v v)| and width 2 eps, have the root mean square pi k_u sqrt(k_u eps/3). *)
Theorem (* clause 2 *) crease_error_area__in_u (k_u epsilon : R) : 0 < k_u -> 0 < epsilon ->
  sqrt (k_u * (2 * (epsilon / 3)) * ((PI * k_u) ^ 2 * (1/2))) = PI * k_u * sqrt (k_u * epsilon / 3).
Proof.
  intros K E. generalize PI_RGT_0. intro P. replace (k_u * (2 * (epsilon / 3)) * ((PI * k_u) ^ 2 * (1/2))) with ((PI * k_u) ^ 2 * (k_u * epsilon / 3)) by field.
  rewrite sqrt_mult by (try apply pow2_ge_0; unfold Rdiv; nra). rewrite sqrt_pow2 by nra. reflexivity.
Qed.
(* False variants of the areas. *)
Theorem crease_error_area__tents__false : ~ forall epsilon, 0 < epsilon -> is_RInt (fun d => (d / epsilon - 1) ^ 2) 0 epsilon (epsilon / 2).
Proof. intro H. generalize (is_RInt_unique _ _ _ _ (H 1 Rlt_0_1)). rewrite (is_RInt_unique _ _ _ _ (crease_error_area__tents 1 Rlt_0_1)). lra. Qed.
Theorem crease_error_area__mean_of_a_square__false : ~ forall k : nat, (0 < k)%nat -> is_RInt (fun v => sin (PI * (INR k * v)) ^ 2) 0 1 1.
Proof.
  intro H. generalize (is_RInt_unique _ _ _ _ (H 1%nat (le_n 1))). rewrite (is_RInt_unique _ _ _ _ (crease_error_area__mean_of_a_square 1 (le_n 1))). lra.
Qed.
Theorem crease_error_area__in_u__false : ~ forall k_u epsilon, 0 < k_u -> 0 < epsilon ->
  sqrt (k_u * (2 * (epsilon / 3)) * ((PI * k_u) ^ 2 * (1/2))) = PI * k_u * sqrt (k_u * epsilon).
Proof.
  intro H. generalize (H 1 3 ltac:(lra) ltac:(lra)). rewrite crease_error_area__in_u by lra. generalize PI_RGT_0. intros P E.
  replace (1 * 3 / 3) with 1 in E by field. rewrite sqrt_1, Rmult_1_r in E. assert (1 < sqrt (1 * 3)) by (rewrite <- sqrt_1 at 1; apply sqrt_lt_1; lra). nra.
Qed.
