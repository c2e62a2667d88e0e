(* The height fields: their gradients, creases, seam and pole, and the algebraic form. *)

From Coq Require Import Reals Lra Psatz Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas.
Open Scope R_scope.

Ltac unfold_fields :=
  unfold height_sine.h, height_ridges.h, height_rings.h, gradient_sine.h_u, gradient_sine.h_v, gradient_rings.h_u, gradient_rings.h_v,
    gradient_ridges.h_u, gradient_ridges.h_v, gradient_sine.sin_u, gradient_sine.cos_u, gradient_sine.sin_v, gradient_sine.cos_v,
    gradient_ridges.sin_u, gradient_ridges.cos_u, gradient_ridges.sin_v, gradient_ridges.cos_v, gradient_rings.sin_v, gradient_rings.cos_v in *.

Lemma sine_of_a_right_angle : sin (PI * (1 * (1/2))) = 1.
Proof. replace (PI * (1 * (1/2))) with (PI / 2) by field. apply sin_PI2. Qed.

(* The gradients *)

Lemma is_derive_is (f : R -> R) (x a b : R) : is_derive f x a -> a = b -> is_derive f x b.
Proof. intros H <-. exact H. Qed.

(* Sine: h_u = pi k_u cos(pi k_u u) sin(pi k_v v), h_v = pi k_v sin(pi k_u u) cos(pi k_v v), and these are the derivatives. *)
Theorem gradients__sine (u v k_u k_v : R) :
  is_derive (fun u => height_sine.h u v k_u k_v) u (gradient_sine.h_u u v k_u k_v) /\
  is_derive (fun v => height_sine.h u v k_u k_v) v (gradient_sine.h_v u v k_u k_v) /\
  gradient_sine.h_u u v k_u k_v = PI * k_u * cos (PI * (k_u * u)) * sin (PI * (k_v * v)) /\
  gradient_sine.h_v u v k_u k_v = PI * k_v * sin (PI * (k_u * u)) * cos (PI * (k_v * v)).
Proof. unfold_fields. split; [|split; [|split]]; try ring; auto_derive; trivial; ring. Qed.
Theorem gradients__sine__false : ~ forall u v k_u k_v, is_derive (fun u => height_sine.h u v k_u k_v) u (- gradient_sine.h_u u v k_u k_v).
Proof.
  intro H. generalize (is_derive_unique _ _ _ (H 0 (1/2) 1 1)) (is_derive_unique _ _ _ (proj1 (gradients__sine 0 (1/2) 1 1))).
  intros -> E. unfold_fields. replace (PI * (1 * 0)) with 0 in E by ring. replace (PI * (1 * (1/2))) with (PI / 2) in E by field.
  rewrite cos_0, sin_PI2 in E. generalize PI_RGT_0. lra.
Qed.

(* Rings: h_u = 0, h_v = 2 pi k_v cos(2 pi k_v v), and these are the derivatives. *)
Theorem gradients__rings (u v k_u k_v : R) :
  is_derive (fun u : R => height_rings.h v k_v) u gradient_rings.h_u /\
  is_derive (fun v => height_rings.h v k_v) v (gradient_rings.h_v v k_v) /\
  gradient_rings.h_u = 0 /\ gradient_rings.h_v v k_v = 2 * PI * k_v * cos (PI * (2 * k_v * v)).
Proof. unfold_fields. unfold gradient_rings.h_u. split; [|split; [|split]]; try ring; auto_derive; trivial; ring. Qed.

(* Ridges: sign(p) p_u and sign(p) p_v, with p the height of sine; the derivatives where p <> 0. *)
Theorem gradients__ridges (u v k_u k_v : R) : let p := height_sine.h u v k_u k_v in
  gradient_ridges.h_u u v k_u k_v = sign p * gradient_sine.h_u u v k_u k_v /\
  gradient_ridges.h_v u v k_u k_v = sign p * gradient_sine.h_v u v k_u k_v /\
  (p <> 0 -> is_derive (fun u => height_ridges.h u v k_u k_v) u (gradient_ridges.h_u u v k_u k_v) /\
    is_derive (fun v => height_ridges.h u v k_u k_v) v (gradient_ridges.h_v u v k_u k_v)).
Proof.
  unfold_fields. cbv zeta. split; [ring | split; [ring|]]. intro P. destruct (gradients__sine u v k_u k_v) as (U & V & _). unfold_fields.
  split.
  - eapply is_derive_is; [exact (is_derive_Rabs (fun u => sin (PI * (k_u * u)) * sin (PI * (k_v * v))) u _ U P) | cbv beta; ring].
  - eapply is_derive_is; [exact (is_derive_Rabs (fun v => sin (PI * (k_u * u)) * sin (PI * (k_v * v))) v _ V P) | cbv beta; ring].
Qed.
Theorem gradients__ridges__point : exists u v k_u k_v, height_sine.h u v k_u k_v <> 0.
Proof.
  exists (1/2), (1/2), 1, 1. unfold_fields. replace (PI * (1 * (1/2))) with (PI / 2) by field. rewrite sin_PI2. lra.
Qed.

(* On the creases the kernels print 0. *)
Theorem gradients__on_creases (u v k_u k_v : R) : height_sine.h u v k_u k_v = 0 ->
  gradient_ridges.h_u u v k_u k_v = 0 /\ gradient_ridges.h_v u v k_u k_v = 0.
Proof. intro E. unfold_fields. rewrite E, sign_0. split; ring. Qed.

(* Sine's slopes need not be 0 there. *)
Theorem gradients__on_creases__false : ~ forall u v k_u k_v, height_sine.h u v k_u k_v = 0 -> gradient_sine.h_u u v k_u k_v = 0.
Proof.
  intro H. generalize (H 0 (1/2) 1 1) PI_RGT_0. unfold_fields. replace (PI * (1 * (1/2))) with (PI / 2) by field. rewrite !Rmult_0_r, sin_0, cos_0, sin_PI2. lra.
Qed.

(* The third derivative at k = 8 and k = 4 *)
Theorem third_derivative_at_eight__at_eight : (8 * PI) ^ 3 > 13824 /\ 13824 > 6 * 2000.
Proof. split; [interval | lra]. Qed.
Theorem third_derivative_at_eight__at_four : 1728 < (4 * PI) ^ 3 < 1987.
Proof. split; interval. Qed.
(* What the seed gives. *)
Theorem third_derivative_at_eight__at_eight__false : ~ (8 * PI) ^ 3 <= 2000.
Proof. apply Rlt_not_le. interval. Qed.

(* The best step *)

Lemma cube_root (a : R) : 0 < a -> 0 < Rpower a (1/3) /\ Rpower a (1/3) ^ 3 = a.
Proof.
  intro P. split; [apply exp_pos|]. rewrite <- Rpower_pow, Rpower_mult by apply exp_pos.
  replace (1 / 3 * INR 3) with 1 by (simpl; field). apply Rpower_1, P.
Qed.

(* T eps^2 + E/eps is at least 3 T^(1/3) (E/2)^(2/3), and is that at eps = (E/2T)^(1/3). *)
Theorem best_step__least (T E eps : R) : 0 < T -> 0 < E -> 0 < eps ->
  let best := Rpower (E / (2 * T)) (1/3) in let least := 3 * Rpower T (1/3) * Rpower (E / 2) (2/3) in
  T * best ^ 2 + E / best = least /\ least <= T * eps ^ 2 + E / eps.
Proof.
  intros HT HE He. cbv zeta. assert (Q : 0 < E / (2 * T)) by (apply Rdiv_lt_0_compat; lra).
  destruct (cube_root _ Q) as [P C]. set (s := Rpower (E / (2 * T)) (1/3)) in *.
  assert (L : 3 * Rpower T (1/3) * Rpower (E / 2) (2/3) = 3 * T * s ^ 2).
  { assert (S : s ^ 2 = Rpower (E / (2 * T)) (2/3)).
    { unfold s. rewrite <- Rpower_pow, Rpower_mult by apply exp_pos. f_equal. simpl. field. }
    rewrite S. replace (E / 2) with (T * (E / (2 * T))) by (field; lra). rewrite <- Rpower_mult_distr by lra.
    rewrite Rmult_assoc, <- (Rmult_assoc (Rpower T (1/3))), <- Rpower_plus. replace (1/3 + 2/3) with 1 by field. rewrite Rpower_1 by lra. ring. }
  rewrite L. assert (HE' : E = 2 * T * s ^ 3) by (rewrite C; field; lra). clearbody s. subst E. split; [field; lra|].
  apply Rmult_le_reg_r with eps; [exact He|]. field_simplify; try lra.
  assert (0 <= T * ((eps - s) ^ 2 * (eps + 2 * s))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; [apply pow2_ge_0 | lra]]). nra.
Qed.
Theorem best_step__least__point : exists T E eps : R, 0 < T /\ 0 < E /\ 0 < eps.
Proof. exists 1, 1, 1. lra. Qed.
(* A third more is no floor. *)
Theorem best_step__least__false : ~ forall T E eps, 0 < T -> 0 < E -> 0 < eps -> 4 * Rpower T (1/3) * Rpower (E / 2) (2/3) <= T * eps ^ 2 + E / eps.
Proof.
  intro H. generalize (H 1 2 1 ltac:(lra) ltac:(lra) ltac:(lra)). replace (2 / 2) with 1 by field. unfold Rpower. rewrite ln_1, !Rmult_0_r, exp_0. lra.
Qed.

(* The central difference of a sine *)

Lemma floor_of_a_fraction (w : R) : 0 <= w < 1 -> IZR (Int_part w) = 0.
Proof.
  intro H. destruct (base_Int_part w) as [A B]. assert (-1 < Int_part w < 1)%Z by (split; apply lt_IZR; lra). f_equal. lia.
Qed.

(* Away from the seam and the poles nothing wraps and nothing is clamped, and the central difference is the derivative times
   sin(pi k eps)/(pi k eps). *)
Lemma difference_of_sines (k t epsilon : R) : k <> 0 -> 0 < epsilon -> (sin (PI * (k * (epsilon + t))) - sin (PI * (k * (t - epsilon)))) / (2 * epsilon) =
  PI * k * cos (PI * (k * t)) * (sin (PI * (k * epsilon)) / (PI * (k * epsilon))).
Proof.
  intros K E. generalize PI_RGT_0. intro P. replace (PI * (k * (epsilon + t))) with (PI * (k * t) + PI * (k * epsilon)) by ring.
  replace (PI * (k * (t - epsilon))) with (PI * (k * t) - PI * (k * epsilon)) by ring. rewrite sin_plus, sin_minus. field. repeat split; lra.
Qed.
Theorem central_difference_of_sine__sine_in_u (u v k_u k_v epsilon : R) : k_u <> 0 -> 0 < epsilon -> 0 <= u - epsilon -> u + epsilon < 1 ->
  central_sine.h_u u v k_u k_v epsilon = gradient_sine.h_u u v k_u k_v * (sin (PI * (k_u * epsilon)) / (PI * (k_u * epsilon))).
Proof.
  intros K E A B. unfold central_sine.h_u, central_sine.h_u_plus, central_sine.h_u_minus, central_sine.u_plus, central_sine.u_minus.
  rewrite !floor_of_a_fraction, !Rminus_0_r by lra. unfold_fields.
  transitivity ((sin (PI * (k_u * (epsilon + u))) - sin (PI * (k_u * (u - epsilon)))) / (2 * epsilon) * sin (PI * (k_v * v))); [field; lra|].
  rewrite difference_of_sines by lra. ring.
Qed.
Theorem central_difference_of_sine__sine_in_v (u v k_u k_v epsilon : R) : k_v <> 0 -> 0 < epsilon -> 0 <= v - epsilon -> v + epsilon <= 1 ->
  central_sine.h_v u v k_u k_v epsilon = gradient_sine.h_v u v k_u k_v * (sin (PI * (k_v * epsilon)) / (PI * (k_v * epsilon))).
Proof.
  intros K E A B. unfold central_sine.h_v, central_sine.h_v_plus, central_sine.h_v_minus, central_sine.span_v, central_sine.v_plus, central_sine.v_minus.
  rewrite Rmin_right, Rmax_left by lra. destruct (both _ _) as [_|H]; [|exfalso; destruct H; lra]. unfold_fields.
  transitivity (sin (PI * (k_u * u)) * ((sin (PI * (k_v * (epsilon + v))) - sin (PI * (k_v * (v - epsilon)))) / (2 * epsilon))); [field; lra|].
  rewrite difference_of_sines by lra. ring.
Qed.
Theorem central_difference_of_sine__rings_in_v (v k_v epsilon : R) : k_v <> 0 -> 0 < epsilon -> 0 <= v - epsilon -> v + epsilon <= 1 ->
  central_rings.h_v v k_v epsilon = gradient_rings.h_v v k_v * (sin (PI * (2 * k_v * epsilon)) / (PI * (2 * k_v * epsilon))).
Proof.
  intros K E A B. unfold central_rings.h_v, central_rings.h_v_plus, central_rings.h_v_minus, central_rings.span_v, central_rings.v_plus, central_rings.v_minus.
  rewrite Rmin_right, Rmax_left by lra. destruct (both _ _) as [_|H]; [|exfalso; destruct H; lra]. unfold_fields. rewrite difference_of_sines by lra. ring.
Qed.
Theorem central_difference_of_sine__cosine (k u epsilon : R) : k <> 0 -> 0 < epsilon ->
  (cos (PI * (k * (u + epsilon))) - cos (PI * (k * (u - epsilon)))) / (2 * epsilon) =
  Derive (fun u => cos (PI * (k * u))) u * (sin (PI * (k * epsilon)) / (PI * (k * epsilon))).
Proof.
  intros K E. generalize PI_RGT_0. intro P. rewrite (is_derive_unique _ _ (- (PI * k) * sin (PI * (k * u)))) by (auto_derive; trivial; ring).
  replace (PI * (k * (u + epsilon))) with (PI * (k * u) + PI * (k * epsilon)) by ring.
  replace (PI * (k * (u - epsilon))) with (PI * (k * u) - PI * (k * epsilon)) by ring.
  rewrite cos_plus, cos_minus. field. repeat split; lra.
Qed.
Theorem central_difference_of_sine__sine_in_u__point : exists u k_u epsilon : R, k_u <> 0 /\ 0 < epsilon /\ 0 <= u - epsilon /\ u + epsilon < 1.
Proof. exists (1/2), 1, (1/4). lra. Qed.
Theorem central_difference_of_sine__sine_in_v__point : exists v k_v epsilon : R, k_v <> 0 /\ 0 < epsilon /\ 0 <= v - epsilon /\ v + epsilon <= 1.
Proof. exists (1/2), 1, (1/4). lra. Qed.
(* It is not the derivative. *)
Theorem central_difference_of_sine__sine_in_u__false : ~ forall u v k_u k_v epsilon, k_u <> 0 -> 0 < epsilon -> 0 <= u - epsilon -> u + epsilon < 1 ->
  central_sine.h_u u v k_u k_v epsilon = gradient_sine.h_u u v k_u k_v.
Proof.
  intro H. generalize (H (1/2) (1/2) 4 1 (1/4) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). rewrite central_difference_of_sine__sine_in_u by lra. unfold_fields.
  replace (PI * (4 * (1/2))) with (2 * PI) by field. replace (PI * (1 * (1/2))) with (PI / 2) by field. replace (PI * (4 * (1/4))) with PI by field.
  rewrite sin_PI, sin_PI2, cos_2PI. unfold Rdiv. rewrite Rmult_0_l, Rmult_0_r. generalize PI_RGT_0. lra.
Qed.

(* The truncation error *)

Lemma cosine_from_below (x : R) : 1 - x ^ 2 / 2 <= cos x.
Proof.
  assert (H : forall y, 0 <= y -> sin y ^ 2 <= y ^ 2).
  { intros y Y. destruct (Rle_dec y 1) as [L|L]; [|generalize (SIN_bound y); nra].
    assert (0 <= sin y) by (apply sin_ge_0; generalize PI2_1; lra).
    destruct Y as [Y|<-]; [generalize (sin_lt_x y Y); nra | rewrite sin_0; lra]. }
  replace (cos x) with (1 - 2 * sin (Rabs (x / 2)) ^ 2).
  - generalize (H (Rabs (x / 2)) (Rabs_pos _)). rewrite pow2_abs. lra.
  - replace (cos x) with (cos (2 * (x / 2))) by (f_equal; field). rewrite cos_2a_sin.
    unfold Rabs. destruct (Rcase_abs (x / 2)); [rewrite sin_neg|]; ring.
Qed.

Lemma sine_from_below (x : R) : 0 <= x -> x - x ^ 3 / 6 <= sin x.
Proof.
  intro X. destruct (MVT_cor4 (fun t => sin t - (t - t ^ 3 / 6)) (fun t => cos t - (1 - t ^ 2 / 2)) 0 x) with (b := x) as (c & E & _).
  - intros c _. auto_derive; trivial. field.
  - rewrite Rminus_0_r, Rabs_pos_eq; lra.
  - rewrite sin_0 in E. generalize (cosine_from_below c). intro. assert (0 <= (cos c - (1 - c ^ 2 / 2)) * (x - 0)) by (apply Rmult_le_pos; lra).
    simpl in *. lra.
Qed.

(* |sin x / x - 1| <= x^2/6. *)
Lemma sinc_near_1 (x : R) : 0 < x -> Rabs (sin x / x - 1) <= x ^ 2 / 6.
Proof.
  intro X. generalize (sine_from_below x) (sin_lt_x x X). intros A B. rewrite Rabs_minus_sym, Rabs_pos_eq.
  - apply Rmult_le_reg_r with x; [exact X|]. field_simplify; lra.
  - apply Rmult_le_reg_r with x; [exact X|]. field_simplify; lra.
Qed.

(* A slope G of at most pi k, and the difference D that is G sinc(k eps). *)
Lemma near_the_slope (D G k epsilon : R) : 0 < k -> 0 < epsilon -> D = G * (sin (PI * (k * epsilon)) / (PI * (k * epsilon))) -> Rabs G <= PI * k ->
  Rabs (D - G) <= epsilon ^ 2 / 6 * (PI * k) ^ 3.
Proof.
  intros K E -> L. generalize PI_RGT_0. intro P. assert (X : 0 < PI * (k * epsilon)) by (apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]).
  replace (_ - _) with (G * (sin (PI * (k * epsilon)) / (PI * (k * epsilon)) - 1)) by ring.
  replace (epsilon ^ 2 / 6 * (PI * k) ^ 3) with (PI * k * ((PI * (k * epsilon)) ^ 2 / 6)) by field.
  rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; [exact L | apply sinc_near_1; exact X].
Qed.
Lemma at_most (c x y : R) : 0 <= c -> Rabs x <= 1 -> Rabs y <= 1 -> Rabs (c * (x * y)) <= c.
Proof.
  intros C X Y. rewrite !Rabs_mult, (Rabs_pos_eq c C). assert (Rabs x * Rabs y <= 1 * 1) by (apply Rmult_le_compat; try apply Rabs_pos; assumption). nra.
Qed.
Lemma sine_at_most_1 (x : R) : Rabs (sin x) <= 1.
Proof. apply Rabs_le, SIN_bound. Qed.
Lemma cosine_at_most_1 (x : R) : Rabs (cos x) <= 1.
Proof. apply Rabs_le, COS_bound. Qed.
Ltac slope := generalize PI_RGT_0; intro P; unfold_fields;
  match goal with |- Rabs ?x <= PI * ?k =>
    match x with
    | context [cos ?a] => match x with
      | context [sin ?b] => replace x with (PI * k * (cos a * sin b)) by ring
      | _ => replace x with (PI * k * (cos a * 1)) by ring
      end
    end
  end; apply at_most; [apply Rmult_le_pos; lra | apply cosine_at_most_1 | first [apply sine_at_most_1 | rewrite Rabs_R1; lra]].

(* |D_eps h - h'| <= eps^2/6 (pi k)^3: k = k_u for sine in u, k_v in v, 2k_v for rings. *)
Theorem (* clause 1 *) truncation_bound__sine (u v k_u k_v epsilon : R) : 0 < k_u -> 0 < epsilon -> 0 <= u - epsilon -> u + epsilon < 1 ->
  Rabs (central_sine.h_u u v k_u k_v epsilon - gradient_sine.h_u u v k_u k_v) <= epsilon ^ 2 / 6 * (PI * k_u) ^ 3.
Proof. intros K E A B. apply near_the_slope; trivial; [apply central_difference_of_sine__sine_in_u; lra | slope]. Qed.
Theorem (* clause 1 *) truncation_bound__sine_in_v (u v k_u k_v epsilon : R) : 0 < k_v -> 0 < epsilon -> 0 <= v - epsilon -> v + epsilon <= 1 ->
  Rabs (central_sine.h_v u v k_u k_v epsilon - gradient_sine.h_v u v k_u k_v) <= epsilon ^ 2 / 6 * (PI * k_v) ^ 3.
Proof. intros K E A B. apply near_the_slope; trivial; [apply central_difference_of_sine__sine_in_v; lra | slope]. Qed.
Theorem (* clause 1 *) truncation_bound__rings (v k_v epsilon : R) : 0 < k_v -> 0 < epsilon -> 0 <= v - epsilon -> v + epsilon <= 1 ->
  Rabs (central_rings.h_v v k_v epsilon - gradient_rings.h_v v k_v) <= epsilon ^ 2 / 6 * (PI * (2 * k_v)) ^ 3.
Proof. intros K E A B. apply near_the_slope; trivial; [lra | apply central_difference_of_sine__rings_in_v; lra | slope]. Qed.
Theorem truncation_bound__sine__point : exists u k_u epsilon : R, 0 < k_u /\ 0 < epsilon /\ 0 <= u - epsilon /\ u + epsilon < 1.
Proof. exists (1/2), 1, (1/4). lra. Qed.

(* |h'''| <= (pi k)^3. *)
Lemma third_of_a_sine (k t : R) : Derive_n (fun t => sin (PI * (k * t))) 3 t = - (PI * k) ^ 3 * cos (PI * (k * t)).
Proof.
  assert (A : forall t, Derive_n (fun t => sin (PI * (k * t))) 1 t = PI * k * cos (PI * (k * t))) by (intro; apply is_derive_unique; auto_derive; trivial; ring).
  assert (B : forall t, Derive_n (fun t => sin (PI * (k * t))) 2 t = - (PI * k) ^ 2 * sin (PI * (k * t))).
  { intro x. change (Derive (Derive_n (fun t => sin (PI * (k * t))) 1) x = - (PI * k) ^ 2 * sin (PI * (k * x))). rewrite (Derive_ext _ _ _ A). apply is_derive_unique. auto_derive; trivial. ring. }
  change (Derive (Derive_n (fun t => sin (PI * (k * t))) 2) t = - (PI * k) ^ 3 * cos (PI * (k * t))). rewrite (Derive_ext _ _ _ B). apply is_derive_unique. auto_derive; trivial. ring.
Qed.
Lemma third_at_most (k a t : R) : 0 < k -> Rabs a <= 1 -> Rabs (Derive_n (fun t => a * sin (PI * (k * t))) 3 t) <= (PI * k) ^ 3.
Proof.
  intros K A. generalize PI_RGT_0. intro P. rewrite Derive_n_scal_l, third_of_a_sine.
  replace (a * _) with ((PI * k) ^ 3 * (- a * cos (PI * (k * t)))) by ring. apply at_most; [left; apply pow_lt; nra | rewrite Rabs_Ropp; exact A | apply cosine_at_most_1].
Qed.
Theorem (* clause 1 *) truncation_bound__third (u v k_u k_v : R) : 0 < k_u -> 0 < k_v ->
  Rabs (Derive_n (fun u => height_sine.h u v k_u k_v) 3 u) <= (PI * k_u) ^ 3 /\
  Rabs (Derive_n (fun v => height_sine.h u v k_u k_v) 3 v) <= (PI * k_v) ^ 3 /\ Rabs (Derive_n (fun v => height_rings.h v k_v) 3 v) <= (PI * (2 * k_v)) ^ 3.
Proof.
  intros K L. unfold_fields. split; [|split].
  - rewrite (Derive_n_ext _ (fun u : R => sin (PI * (k_v * v)) * sin (PI * (k_u * u)))) by (intro; apply Rmult_comm). apply third_at_most; [exact K | apply sine_at_most_1].
  - apply third_at_most; [exact L | apply sine_at_most_1].
  - rewrite (Derive_n_ext _ (fun v : R => 1 * sin (PI * (2 * k_v * v)))) by (intro; ring). apply third_at_most; [lra | rewrite Rabs_R1; lra].
Qed.
(* Twice as good it is not. *)
Theorem truncation_bound__third__false : ~ forall v k_v, 0 < k_v -> Rabs (Derive_n (fun v : R => height_rings.h v k_v) 3 v) <= (PI * k_v) ^ 3.
Proof.
  intro H. generalize (H 0 1 ltac:(lra)) PI_RGT_0. unfold_fields. intros L P. revert L. rewrite (third_of_a_sine (2 * 1)), !Rmult_0_r, cos_0.
  rewrite Rmult_1_r, Rabs_Ropp, Rabs_pos_eq, !Rmult_1_r by (apply pow_le; lra). assert (0 < PI ^ 3) by (apply pow_lt, P). rewrite Rpow_mult_distr. lra.
Qed.

(* Where p has one sign at the three points, ridges' difference and slope are sine's, or both their negatives: the same bound. *)
Lemma difference_of_sizes (s a b : R) : s = 1 \/ s = -1 -> 0 < s * a -> 0 < s * b -> Rabs a - Rabs b = s * (a - b).
Proof. intros [-> | ->] A B; [rewrite !Rabs_pos_eq by lra | rewrite !Rabs_left by lra]; ring. Qed.
Ltac sizes S A B := match goal with |- context [Rabs ?a - Rabs ?b] => rewrite (difference_of_sizes _ a b S A B) end; field; lra.
Lemma sign_of (s p : R) : s = 1 \/ s = -1 -> 0 < s * p -> sign p = s.
Proof. intros [-> | ->] P; [apply sign_eq_1 | apply sign_eq_m1]; lra. Qed.
Lemma same_bound (s D D' G G' bound : R) : s = 1 \/ s = -1 -> D' = s * D -> G' = s * G -> Rabs (D - G) <= bound ->
  D' = s * D /\ G' = s * G /\ Rabs (D' - G') <= bound.
Proof.
  intros S -> -> B. split; [reflexivity | split; [reflexivity|]]. rewrite <- Rmult_minus_distr_l, Rabs_mult.
  replace (Rabs s) with 1 by (destruct S as [-> | ->]; symmetry; [apply Rabs_R1 | apply Rabs_m1]). lra.
Qed.
Theorem (* clause 2 *) truncation_bound__ridges (u v k_u k_v epsilon s : R) : 0 < k_u -> 0 < epsilon -> 0 <= u - epsilon -> u + epsilon < 1 -> s = 1 \/ s = -1 ->
  0 < s * height_sine.h (u - epsilon) v k_u k_v -> 0 < s * height_sine.h u v k_u k_v -> 0 < s * height_sine.h (u + epsilon) v k_u k_v ->
  central_ridges.h_u u v k_u k_v epsilon = s * central_sine.h_u u v k_u k_v epsilon /\ gradient_ridges.h_u u v k_u k_v = s * gradient_sine.h_u u v k_u k_v /\
  Rabs (central_ridges.h_u u v k_u k_v epsilon - gradient_ridges.h_u u v k_u k_v) <= epsilon ^ 2 / 6 * (PI * k_u) ^ 3.
Proof.
  intros K E A B S P0 P1 P2. apply same_bound; trivial; [| rewrite (proj1 (gradients__ridges u v k_u k_v)), (sign_of s); trivial | apply truncation_bound__sine; assumption].
  unfold central_ridges.h_u, central_ridges.h_u_plus, central_ridges.h_u_minus, central_ridges.u_plus, central_ridges.u_minus,
    central_sine.h_u, central_sine.h_u_plus, central_sine.h_u_minus, central_sine.u_plus, central_sine.u_minus.
  rewrite !floor_of_a_fraction, !Rminus_0_r, (Rplus_comm epsilon u) by lra. sizes S P2 P0.
Qed.
Theorem (* clause 2 *) truncation_bound__ridges_in_v (u v k_u k_v epsilon s : R) : 0 < k_v -> 0 < epsilon -> 0 <= v - epsilon -> v + epsilon <= 1 -> s = 1 \/ s = -1 ->
  0 < s * height_sine.h u (v - epsilon) k_u k_v -> 0 < s * height_sine.h u v k_u k_v -> 0 < s * height_sine.h u (v + epsilon) k_u k_v ->
  central_ridges.h_v u v k_u k_v epsilon = s * central_sine.h_v u v k_u k_v epsilon /\ gradient_ridges.h_v u v k_u k_v = s * gradient_sine.h_v u v k_u k_v /\
  Rabs (central_ridges.h_v u v k_u k_v epsilon - gradient_ridges.h_v u v k_u k_v) <= epsilon ^ 2 / 6 * (PI * k_v) ^ 3.
Proof.
  intros K E A B S P0 P1 P2. apply same_bound; trivial; [| rewrite (proj1 (proj2 (gradients__ridges u v k_u k_v))), (sign_of s); trivial | apply truncation_bound__sine_in_v; assumption].
  unfold central_ridges.h_v, central_ridges.h_v_plus, central_ridges.h_v_minus, central_ridges.span_v, central_ridges.v_plus, central_ridges.v_minus,
    central_sine.h_v, central_sine.h_v_plus, central_sine.h_v_minus, central_sine.span_v, central_sine.v_plus, central_sine.v_minus.
  rewrite Rmin_right, Rmax_left by lra. destruct (both _ _) as [_|H]; [|exfalso; destruct H; lra]. rewrite (Rplus_comm epsilon v). sizes S P2 P0.
Qed.

(* Whatever lies within the step: two numbers of at most pi k are at most 2 pi k apart. *)
Theorem (* clause 3 *) truncation_bound__apart (k quotient slope : R) : Rabs quotient <= PI * k -> Rabs slope <= PI * k ->
  Rabs (quotient - slope) <= 2 * (PI * k).
Proof. intros Q S. unfold Rminus. eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. lra. Qed.

Theorem truncation_bound__apart__point : exists k quotient slope : R, Rabs quotient <= PI * k /\ Rabs slope <= PI * k.
Proof. exists 0, 0, 0. rewrite Rabs_R0. lra. Qed.

(* Not within pi k of each other. *)
Theorem truncation_bound__apart__false : ~ forall k quotient slope : R, Rabs quotient <= PI * k -> Rabs slope <= PI * k ->
  Rabs (quotient - slope) <= PI * k.
Proof.
  intros F. pose proof PI_RGT_0. specialize (F 1 PI (- PI)). rewrite Rabs_Ropp, (Rabs_right PI) in F by lra.
  assert (Rabs (PI - - PI) = 2 * PI) by (rewrite Rabs_right; lra). lra.
Qed.
(* Off the creases h and its gradient are those of p, or of -p: there is no other crease. *)
Theorem (* clause 3 *) kink_loci__between (u v k_u k_v : R) : let p := height_sine.h u v k_u k_v in p <> 0 ->
  0 < height_ridges.h u v k_u k_v /\ exists s, (s = 1 \/ s = -1) /\ height_ridges.h u v k_u k_v = s * p /\
  gradient_ridges.h_u u v k_u k_v = s * gradient_sine.h_u u v k_u k_v /\ gradient_ridges.h_v u v k_u k_v = s * gradient_sine.h_v u v k_u k_v.
Proof.
  cbv zeta. intro N. destruct (gradients__ridges u v k_u k_v) as (U & V & _). split; [apply Rabs_pos_lt, N|]. exists (sign (height_sine.h u v k_u k_v)).
  change (height_ridges.h u v k_u k_v) with (Rabs (height_sine.h u v k_u k_v)). set (p := height_sine.h u v k_u k_v) in *.
  split; [|split; [|split; [exact U | exact V]]]; destruct (Rle_lt_dec 0 p).
  - left. apply sign_eq_1. lra.
  - right. apply sign_eq_m1. assumption.
  - rewrite sign_eq_1, Rabs_pos_eq by lra. ring.
  - rewrite sign_eq_m1, Rabs_left by assumption. ring.
Qed.
(* Ridges is 0 exactly on the rays k_u u = m and the circles k_v v = m: so p is not 0 everywhere else. *)
Theorem (* clauses 2, 3 *) kink_loci__zero (u v k_u k_v : R) : height_ridges.h u v k_u k_v = 0 <-> (exists m : Z, k_u * u = IZR m) \/ (exists m : Z, k_v * v = IZR m).
Proof.
  assert (Z : forall x, sin (PI * x) = 0 <-> exists m : Z, x = IZR m).
  { intro x. generalize PI_RGT_0. intro P. split.
    - intro E. destruct (sin_eq_0_0 _ E) as [m M]. exists m. apply Rmult_eq_reg_l with PI; lra.
    - intros [m ->]. apply sin_eq_0_1. exists m. ring. }
  rewrite <- !Z. unfold_fields. split.
  - intro E. apply Rmult_integral. destruct (Req_dec (sin (PI * (k_u * u)) * sin (PI * (k_v * v))) 0) as [H|H]; [exact H | destruct (Rabs_no_R0 _ H E)].
  - intros [E|E]; rewrite E, ?Rmult_0_l, ?Rmult_0_r; apply Rabs_R0.
Qed.
Theorem kink_loci__zero__false : ~ forall u v k_u k_v, height_ridges.h u v k_u k_v = 0 -> exists m : Z, k_u * u = IZR m.
Proof.
  intro H. destruct (H (1/2) 0 1 1) as [m M]; [unfold_fields; rewrite !Rmult_0_r, sin_0, Rmult_0_r; apply Rabs_R0|].
  assert (0 < m < 1)%Z by (split; apply lt_IZR; lra). lia.
Qed.
(* False variants: the difference of a cosine is not its slope, and the difference of ridges is not sine's. *)
Theorem central_difference_of_sine__cosine__false : ~ forall k u epsilon, k <> 0 -> 0 < epsilon ->
  (cos (PI * (k * (u + epsilon))) - cos (PI * (k * (u - epsilon)))) / (2 * epsilon) = Derive (fun u => cos (PI * (k * u))) u.
Proof.
  intro H. generalize (H 4 (1/8) (1/4) ltac:(lra) ltac:(lra)) (central_difference_of_sine__cosine 4 (1/8) (1/4) ltac:(lra) ltac:(lra)). intros A E. rewrite A in E.
  rewrite (is_derive_unique _ _ (- (PI * 4) * sin (PI * (4 * (1/8))))) in E by (auto_derive; trivial; ring). replace (PI * (4 * (1/4))) with PI in E by field.
  replace (PI * (4 * (1/8))) with (PI / 2) in E by field. rewrite sin_PI, sin_PI2 in E. unfold Rdiv in E. rewrite Rmult_0_l in E. generalize PI_RGT_0. lra.
Qed.
Lemma sine_of_three_right_angles : sin (PI * (3 * (1/2))) = -1.
Proof. replace (PI * (3 * (1/2))) with (PI / 2 + PI) by field. rewrite neg_sin, sin_PI2. ring. Qed.
Theorem truncation_bound__ridges__false : ~ forall u v k_u k_v epsilon, 0 < epsilon -> 0 <= u - epsilon -> u + epsilon < 1 ->
  central_ridges.h_u u v k_u k_v epsilon = central_sine.h_u u v k_u k_v epsilon.
Proof.
  intro H. generalize (H (1/4) (1/2) 1 3 (1/4) ltac:(lra) ltac:(lra) ltac:(lra)).
  unfold central_ridges.h_u, central_ridges.h_u_plus, central_ridges.h_u_minus, central_ridges.u_plus, central_ridges.u_minus,
    central_sine.h_u, central_sine.h_u_plus, central_sine.h_u_minus, central_sine.u_plus, central_sine.u_minus.
  rewrite !floor_of_a_fraction by lra. replace (1/4 + 1/4 - 0) with (1/2) by field. replace (1/4 - 1/4 - 0) with 0 by field.
  rewrite sine_of_a_right_angle, sine_of_three_right_angles, !Rmult_0_r, sin_0, Rmult_0_l, Rabs_R0, Rmult_1_l, Rabs_m1. lra.
Qed.
Theorem truncation_bound__ridges_in_v__false : ~ forall u v k_u k_v epsilon, 0 < epsilon -> 0 <= v - epsilon -> v + epsilon <= 1 ->
  central_ridges.h_v u v k_u k_v epsilon = central_sine.h_v u v k_u k_v epsilon.
Proof.
  intro H. generalize (H (1/2) (1/4) 3 1 (1/4) ltac:(lra) ltac:(lra) ltac:(lra)).
  unfold central_ridges.h_v, central_ridges.h_v_plus, central_ridges.h_v_minus, central_ridges.span_v, central_ridges.v_plus, central_ridges.v_minus,
    central_sine.h_v, central_sine.h_v_plus, central_sine.h_v_minus, central_sine.span_v, central_sine.v_plus, central_sine.v_minus.
  rewrite Rmin_right, Rmax_left by lra. destruct (both _ _) as [_|X]; [|exfalso; destruct X; lra]. replace (1/4 + 1/4) with (1/2) by field. replace (1/4 - 1/4) with 0 by field.
  rewrite sine_of_a_right_angle, sine_of_three_right_angles, !Rmult_0_r, sin_0, Rmult_0_r, Rabs_R0, Rmult_1_r, Rabs_m1. lra.
Qed.
