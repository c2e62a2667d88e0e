(* Differences at the pole and across creases, the creases of ridges, and the seam. *)

From Coq Require Import Reals Lra Psatz Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Fields.
Open Scope R_scope.

(* The difference clamped at the pole *)

Section clamp.
Variables u v k_u k_v epsilon : R.
Hypotheses (E : 0 < epsilon) (V : 0 <= v < epsilon) (W : v + epsilon <= 1).

(* For 0 <= v < eps the central difference is (h(v + eps) - h(0))/(v + eps). *)
Theorem clamped_difference__clamp :
  central_sine.h_v u v k_u k_v epsilon = (height_sine.h u (v + epsilon) k_u k_v - height_sine.h u 0 k_u k_v) / (v + epsilon) /\
  central_ridges.h_v u v k_u k_v epsilon = (height_ridges.h u (v + epsilon) k_u k_v - height_ridges.h u 0 k_u k_v) / (v + epsilon) /\
  central_rings.h_v v k_v epsilon = (height_rings.h (v + epsilon) k_v - height_rings.h 0 k_v) / (v + epsilon).
Proof.
  unfold central_sine.h_v, central_sine.h_v_plus, central_sine.h_v_minus, central_sine.span_v, central_sine.v_plus, central_sine.v_minus.
  unfold central_ridges.h_v, central_ridges.h_v_plus, central_ridges.h_v_minus, central_ridges.span_v, central_ridges.v_plus, central_ridges.v_minus.
  unfold central_rings.h_v, central_rings.h_v_plus, central_rings.h_v_minus, central_rings.span_v, central_rings.v_plus, central_rings.v_minus.
  rewrite !Rmin_right, !Rmax_right by lra. destruct (both _ _) as [H|_]; [exfalso; lra|]. unfold_fields.
  rewrite (Rplus_comm v epsilon), Rminus_0_r. repeat split; reflexivity.
Qed.
End clamp.
Theorem clamped_difference__clamp__point : exists v epsilon : R, 0 < epsilon /\ 0 <= v < epsilon /\ v + epsilon <= 1.
Proof. exists 0, (1/4). lra. Qed.

(* A function that is 0 at 0, and whose derivative is at most S t^n in size, is at most S t^(n+1)/(n+1). *)
Lemma nonnegative_growth (f f1 : R -> R) (t : R) : 0 <= t -> (forall s, is_derive f s (f1 s)) -> 0 <= f 0 ->
  (forall s, 0 <= s <= t -> 0 <= f1 s) -> 0 <= f t.
Proof.
  intros T D Z P. destruct (MVT_gen f 0 t f1) as (c & C & Ec).
  - intros. apply D.
  - intros x _. apply continuity_pt_filterlim. apply (ex_derive_continuous f). exists (f1 x). apply D.
  - rewrite Rmin_left, Rmax_right in C by lra. assert (0 <= f1 c * (t - 0)) by (apply Rmult_le_pos; [apply P; lra | lra]). lra.
Qed.

Lemma growth (n : nat) (f f1 : R -> R) (S t : R) : 0 <= t -> (forall s, is_derive f s (f1 s)) -> f 0 = 0 ->
  (forall s, 0 <= s <= t -> Rabs (f1 s) <= S * s ^ n) -> Rabs (f t) <= S * (t ^ (n + 1) / INR (n + 1)).
Proof.
  intros T D Z B. assert (N : 0 < INR (n + 1)) by (apply lt_0_INR; lia).
  assert (D' : forall c s, is_derive (fun s => S * (s ^ (n + 1) / INR (n + 1)) + c * f s) s (S * s ^ n + c * f1 s)).
  { intros c s. generalize (D s). intro Ds. auto_derive; [exists (f1 s); exact Ds|].
    replace (Derive (fun x => f x) s) with (f1 s) by (symmetry; apply is_derive_unique; exact Ds).
    replace (pred (n + 1)) with n by lia. field. lra. }
  assert (A : forall c, Rabs c = 1 -> 0 <= S * (t ^ (n + 1) / INR (n + 1)) + c * f t).
  { intros c C. apply (nonnegative_growth (fun s => S * (s ^ (n + 1) / INR (n + 1)) + c * f s) (fun s => S * s ^ n + c * f1 s)); trivial.
    - rewrite Z, pow_i by lia. unfold Rdiv. lra.
    - intros s Hs. generalize (B s Hs). rewrite <- (Rmult_1_l (Rabs (f1 s))), <- C, <- Rabs_mult. generalize (Rabs_maj2 (c * f1 s)). lra. }
  generalize (A 1 Rabs_R1) (A (-1) Rabs_m1). intros. apply Rabs_le. lra.
Qed.

Lemma value_after (h h1 h2 : R -> R) (v t S : R) : (forall w, is_derive h w (h1 w)) -> (forall w, is_derive h1 w (h2 w)) -> 0 <= t ->
  (forall w, v <= w <= v + t -> Rabs (h2 w) <= S) -> Rabs (h (v + t) - h v - t * h1 v) <= S * (t ^ 2 / 2).
Proof.
  intros D1 D2 T B.
  assert (F : forall s, 0 <= s <= t -> Rabs (h1 (v + s) - h1 v) <= S * s ^ 1).
  { intros s Hs. replace (S * s ^ 1) with (S * (s ^ (0 + 1) / INR (0 + 1))) by (simpl; field).
    apply (growth 0 (fun s => h1 (v + s) - h1 v) (fun s => h2 (v + s))); try lra.
    - intro r. auto_derive; [exists (h2 (v + r)); apply D2|]. replace (Derive _ _) with (h2 (v + r)) by (symmetry; apply is_derive_unique, D2). ring.
    - rewrite Rplus_0_r. ring.
    - intros r Hr. simpl. rewrite Rmult_1_r. apply B. lra. }
  replace (S * (t ^ 2 / 2)) with (S * (t ^ (1 + 1) / INR (1 + 1))) by (simpl; field).
  apply (growth 1 (fun s => h (v + s) - h v - s * h1 v) (fun s => h1 (v + s) - h1 v)); trivial.
  - intro r. auto_derive; [exists (h1 (v + r)); apply D1|]. replace (Derive _ _) with (h1 (v + r)) by (symmetry; apply is_derive_unique, D1). ring.
  - rewrite Rplus_0_r. ring.
Qed.

Lemma value_before (h h1 h2 : R -> R) (v t S : R) : (forall w, is_derive h w (h1 w)) -> (forall w, is_derive h1 w (h2 w)) -> 0 <= t ->
  (forall w, v - t <= w <= v -> Rabs (h2 w) <= S) -> Rabs (h (v - t) - h v + t * h1 v) <= S * (t ^ 2 / 2).
Proof.
  intros D1 D2 T B. generalize (value_after (fun w => h (- w)) (fun w => - h1 (- w)) (fun w => h2 (- w)) (- v) t S).
  rewrite !Ropp_involutive. replace (- (- v + t)) with (v - t) by ring. replace (h (v - t) - h v - t * - h1 v) with (h (v - t) - h v + t * h1 v) by ring.
  intro G. apply G; trivial.
  - intro w. auto_derive; [exists (h1 (- w)); apply D1|]. replace (Derive _ _) with (h1 (- w)) by (symmetry; apply is_derive_unique, D1). ring.
  - intro w. auto_derive; [exists (h2 (- w)); apply D2|]. replace (Derive _ _) with (h2 (- w)) by (symmetry; apply is_derive_unique, D2). ring.
  - intros w Hw. apply B. lra.
Qed.

(* |D_eps h - h'(v)| <= (eps^2 + v^2)/(2 (eps + v)) sup |h''|: first order. *)
Theorem clamped_difference__first_order (h h1 h2 : R -> R) (v epsilon S : R) :
  (forall w, is_derive h w (h1 w)) -> (forall w, is_derive h1 w (h2 w)) -> 0 <= v < epsilon ->
  (forall w, 0 <= w <= v + epsilon -> Rabs (h2 w) <= S) ->
  Rabs ((h (v + epsilon) - h 0) / (v + epsilon) - h1 v) <= (epsilon ^ 2 + v ^ 2) / (2 * (epsilon + v)) * S.
Proof.
  intros D1 D2 V B.
  assert (A := value_after h h1 h2 v epsilon S D1 D2 ltac:(lra) ltac:(intros; apply B; lra)).
  assert (C := value_before h h1 h2 v v S D1 D2 ltac:(lra) ltac:(intros; apply B; lra)).
  replace (v - v) with 0 in C by ring.
  replace (_ / _ - h1 v) with (((h (v + epsilon) - h v - epsilon * h1 v) - (h 0 - h v + v * h1 v)) / (v + epsilon)) by (field; lra).
  unfold Rdiv at 1. rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; lra).
  replace ((epsilon ^ 2 + v ^ 2) / (2 * (epsilon + v)) * S) with ((S * (epsilon ^ 2 / 2) + S * (v ^ 2 / 2)) * / (v + epsilon)) by (field; lra).
  apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|]. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
Qed.
Theorem clamped_difference__first_order__point : exists (h h1 h2 : R -> R) (v epsilon S : R),
  (forall w, is_derive h w (h1 w)) /\ (forall w, is_derive h1 w (h2 w)) /\ 0 <= v < epsilon /\ (forall w, 0 <= w <= v + epsilon -> Rabs (h2 w) <= S).
Proof.
  exists (fun w => w ^ 2 / 2), (fun w => w), (fun _ => 1), 0, 1, 1.
  split; [|split; [|split]]; try lra; intros; try (rewrite Rabs_R1; lra); auto_derive; trivial; field.
Qed.

(* No smaller factor will do: h(w) = (w - v)|w - v|/2, whose derivative |w - v| is 1-Lipschitz, attains it; at v = 0 so does w^2/2. *)
Lemma slope_of_half_square (v w : R) : is_derive (fun w => (w - v) * Rabs (w - v) / 2) w (Rabs (w - v)).
Proof.
  destruct (Rtotal_order w v) as [L|[->|G]].
  - rewrite Rabs_left by lra. apply (is_derive_ext_loc (fun w => - (w - v) ^ 2 / 2)); [|auto_derive; trivial; field].
    assert (P : 0 < v - w) by lra. exists (mkposreal _ P). intros y B. unfold ball in B. simpl in B. unfold AbsRing_ball, abs, minus, plus, opp in B. simpl in B.
    apply Rabs_def2 in B. rewrite Rabs_left by lra. match goal with |- ?a = ?b => change (a = b :> R) end; field.
  - rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. apply is_derive_Reals. intros e E. exists (mkposreal e E). intros t T B. simpl in B.
    replace (v + t - v) with t by ring. replace (v - v) with 0 by ring. rewrite Rmult_0_l. replace (_ - 0) with (Rabs t / 2) by (field; exact T).
    generalize (Rabs_pos t). intro. rewrite Rabs_pos_eq; lra.
  - rewrite Rabs_pos_eq by lra. apply (is_derive_ext_loc (fun w => (w - v) ^ 2 / 2)); [|auto_derive; trivial; field].
    assert (P : 0 < w - v) by lra. exists (mkposreal _ P). intros y B. unfold ball in B. simpl in B. unfold AbsRing_ball, abs, minus, plus, opp in B. simpl in B.
    apply Rabs_def2 in B. rewrite Rabs_pos_eq by lra. match goal with |- ?a = ?b => change (a = b :> R) end; field.
Qed.
Theorem clamped_difference__first_order_sharp (v epsilon : R) : 0 <= v < epsilon -> let h w := (w - v) * Rabs (w - v) / 2 in
  (forall w, is_derive h w (Rabs (w - v))) /\ (forall w x, Rabs (Rabs (w - v) - Rabs (x - v)) <= 1 * Rabs (w - x)) /\
  (h (v + epsilon) - h 0) / (v + epsilon) - Derive h v = (epsilon ^ 2 + v ^ 2) / (2 * (epsilon + v)).
Proof.
  intro V. cbv beta zeta. split; [apply slope_of_half_square | split].
  - intros w x. rewrite Rmult_1_l. replace (w - x) with (w - v - (x - v)) by ring. apply Rabs_triang_inv2.
  - replace (Derive _ v) with (Rabs (v - v)) by (symmetry; apply is_derive_unique, slope_of_half_square). replace (v + epsilon - v) with epsilon by ring. replace (0 - v) with (- v) by ring. replace (v - v) with 0 by ring.
    rewrite Rabs_Ropp, Rabs_R0, !Rabs_pos_eq by lra. field. lra.
Qed.
Theorem clamped_difference__at_the_pole_itself (epsilon : R) : 0 < epsilon -> let h w := w ^ 2 / 2 in
  (h (0 + epsilon) - h 0) / (0 + epsilon) - Derive h 0 = (epsilon ^ 2 + 0 ^ 2) / (2 * (epsilon + 0)).
Proof. intro E. cbv beta zeta. rewrite (is_derive_unique _ _ 0) by (auto_derive; trivial; field). field. lra. Qed.
Theorem clamped_difference__first_order__false : ~ forall (h h1 h2 : R -> R) (v epsilon S : R),
  (forall w, is_derive h w (h1 w)) -> (forall w, is_derive h1 w (h2 w)) -> 0 <= v < epsilon ->
  (forall w, 0 <= w <= v + epsilon -> Rabs (h2 w) <= S) ->
  Rabs ((h (v + epsilon) - h 0) / (v + epsilon) - h1 v) <= (epsilon ^ 2 + v ^ 2) / (3 * (epsilon + v)) * S.
Proof.
  intro H. generalize (H (fun w => w ^ 2 / 2) (fun w => w) (fun _ => 1) 0 1 1). intro K.
  assert (K' := K ltac:(intro; auto_derive; trivial; field) ltac:(intro; auto_derive; trivial) ltac:(lra) ltac:(intros; rewrite Rabs_R1; lra)). clear K.
  generalize (Rle_abs ((((0 + 1) ^ 2 / 2 - 0 ^ 2 / 2) / (0 + 1)) - 0)). lra.
Qed.

(* Where the field is odd *)

(* If h is odd about v = 0: |D_eps h - h'| <= (eps^2 + 2 eps v - 2 v^2)/6 sup |h'''|. *)
Section odd.
Variables f0 f1 f2 f3 : R -> R.
Hypotheses (D1 : forall w, is_derive f0 w (f1 w)) (D2 : forall w, is_derive f1 w (f2 w)) (D3 : forall w, is_derive f2 w (f3 w)).

Lemma shifted (g g1 : R -> R) (c m s : R) : (forall w, is_derive g w (g1 w)) -> is_derive (fun t => g (m + c * t)) s (c * g1 (m + c * s)).
Proof.
  intro D. auto_derive; [exists (g1 (m + c * s)); apply D|]. replace (Derive _ _) with (g1 (m + c * s)) by (symmetry; apply is_derive_unique, D). ring.
Qed.

(* A function with f0(0) = f''(0) = 0 whose third derivative is not negative up to a has a f'(v) <= f0(a) for v <= a/2. *)
Lemma middle_slope (a v : R) : 0 <= v <= a / 2 -> f0 0 = 0 -> f2 0 = 0 -> (forall w, 0 <= w <= a -> 0 <= f3 w) -> a * f1 v <= f0 a.
Proof.
  intros V Z Z2 P.
  assert (P2 : forall w s, 0 <= w -> 0 <= s -> w + s <= a -> f2 w <= f2 (w + s)).
  { intros w s W S L. assert (0 <= f2 (w + 1 * s) - f2 w); [|rewrite Rmult_1_l in *; lra].
    apply (nonnegative_growth (fun t => f2 (w + 1 * t) - f2 w) (fun t => 1 * f3 (w + 1 * t) - 0)); trivial.
    - intro t. apply (is_derive_minus (fun t => f2 (w + 1 * t)) (fun _ => f2 w)); [apply shifted, D3 | auto_derive; trivial].
    - rewrite Rmult_0_r, Rplus_0_r. lra.
    - intros t T. rewrite Rmult_1_l, Rminus_0_r, Rmult_1_l. apply P. lra. }
  assert (P1 : f1 v <= f1 (a / 2)).
  { assert (0 <= f1 (v + 1 * (a / 2 - v)) - f1 v); [|replace (v + 1 * (a / 2 - v)) with (a / 2) in * by ring; lra].
    apply (nonnegative_growth (fun t => f1 (v + 1 * t) - f1 v) (fun t => 1 * f2 (v + 1 * t) - 0)); try lra.
    - intro t. apply (is_derive_minus (fun t => f1 (v + 1 * t)) (fun _ => f1 v)); [apply shifted, D2 | auto_derive; trivial].
    - rewrite Rmult_0_r, Rplus_0_r. lra.
    - intros t T. rewrite Rmult_1_l, Rminus_0_r, Rmult_1_l. rewrite <- Z2. replace (v + t) with (0 + (v + t)) by ring. apply P2; lra. }
  set (m := a / 2) in *.
  assert (Q1 : forall t, 0 <= t <= m -> 0 <= f1 (m + 1 * t) + f1 (m + -1 * t) - 2 * f1 m).
  { intros t T. apply (nonnegative_growth (fun t => f1 (m + 1 * t) + f1 (m + -1 * t) - 2 * f1 m) (fun t => 1 * f2 (m + 1 * t) + -1 * f2 (m + -1 * t) - 0)); try lra.
    - intro s. apply (is_derive_minus (fun t => f1 (m + 1 * t) + f1 (m + -1 * t)) (fun _ => 2 * f1 m)); [|auto_derive; trivial].
      apply (is_derive_plus (fun t => f1 (m + 1 * t)) (fun t => f1 (m + -1 * t))); apply shifted, D2.
    - rewrite !Rmult_0_r, !Rplus_0_r. lra.
    - intros s S. assert (f2 (m + -1 * s) <= f2 (m + -1 * s + 2 * s)) by (apply P2; unfold m in *; lra).
      replace (m + -1 * s + 2 * s) with (m + 1 * s) in * by ring. lra. }
  assert (Q : 0 <= f0 (m + 1 * m) - f0 (m + -1 * m) - 2 * f1 m * m).
  { apply (nonnegative_growth (fun t => f0 (m + 1 * t) - f0 (m + -1 * t) - 2 * f1 m * t) (fun t => 1 * f1 (m + 1 * t) - -1 * f1 (m + -1 * t) - 2 * f1 m)); try lra.
    - intro s. apply (is_derive_minus (fun t => f0 (m + 1 * t) - f0 (m + -1 * t)) (fun t => 2 * f1 m * t)); [|auto_derive; trivial; ring].
      apply (is_derive_minus (fun t => f0 (m + 1 * t)) (fun t => f0 (m + -1 * t))); apply shifted, D1.
    - rewrite !Rmult_0_r, !Rplus_0_r. lra.
    - intros t T. generalize (Q1 t T). lra. }
  replace (m + 1 * m) with a in Q by (unfold m; field). replace (m + -1 * m) with 0 in Q by ring. rewrite Z in Q.
  assert (a * f1 v <= a * f1 m) by (apply Rmult_le_compat_l; [unfold m in V; lra | lra]). unfold m in *. lra.
Qed.
End odd.

Theorem clamped_difference_of_odd__second_order (h h1 h2 h3 : R -> R) (v epsilon S : R) :
  (forall w, is_derive h w (h1 w)) -> (forall w, is_derive h1 w (h2 w)) -> (forall w, is_derive h2 w (h3 w)) ->
  (forall w, h (- w) = - h w) -> 0 <= v < epsilon -> (forall w, 0 <= w <= v + epsilon -> Rabs (h3 w) <= S) ->
  Rabs ((h (v + epsilon) - h 0) / (v + epsilon) - h1 v) <= (epsilon ^ 2 + 2 * epsilon * v - 2 * v ^ 2) / 6 * S.
Proof.
  intros D1 D2 D3 O V B.
  assert (Z : h 0 = 0) by (generalize (O 0); rewrite Ropp_0; lra).
  assert (O1 : forall w, h1 (- w) = h1 w).
  { intro w. generalize (is_derive_unique _ _ _ (shifted h h1 (-1) 0 w D1)). rewrite (Derive_ext _ (fun t => - h t)).
    - rewrite Derive_opp, (is_derive_unique _ _ _ (D1 w)). replace (0 + -1 * w) with (- w) by ring. lra.
    - intro t. rewrite <- O. f_equal. ring. }
  assert (Z2 : h2 0 = 0).
  { generalize (is_derive_unique _ _ _ (shifted h1 h2 (-1) 0 0 D2)). rewrite (Derive_ext _ h1).
    - rewrite (is_derive_unique _ _ _ (D2 0)). replace (0 + -1 * 0) with 0 by ring. lra.
    - intro t. rewrite <- (O1 t). f_equal. ring. }
  assert (A : forall c, Rabs c = 1 -> (v + epsilon) * (S * (v ^ 2 / 2) + c * h1 v) <= S * ((v + epsilon) ^ 3 / 6) + c * h (v + epsilon)).
  { intros c C.
    apply (middle_slope (fun w => S * (w ^ 3 / 6) + c * h w) (fun w => S * (w ^ 2 / 2) + c * h1 w) (fun w => S * w + c * h2 w) (fun w => S + c * h3 w)); try lra.
    - intro w. apply (is_derive_plus (fun w => S * (w ^ 3 / 6)) (fun w => c * h w)); [auto_derive; trivial; field | apply (is_derive_scal h), D1].
    - intro w. apply (is_derive_plus (fun w => S * (w ^ 2 / 2)) (fun w => c * h1 w)); [auto_derive; trivial; field | apply (is_derive_scal h1), D2].
    - intro w. apply (is_derive_plus (fun w => S * w) (fun w => c * h2 w)); [auto_derive; trivial; field | apply (is_derive_scal h2), D3].
    - rewrite Z. field.
    - rewrite Z2. ring.
    - intros w W. generalize (B w W). rewrite <- (Rmult_1_l (Rabs (h3 w))), <- C, <- Rabs_mult. generalize (Rabs_maj2 (c * h3 w)). lra. }
  generalize (A 1 Rabs_R1) (A (-1) Rabs_m1). rewrite Z, Rminus_0_r. intros L U.
  set (a := v + epsilon) in *. assert (P : 0 < a) by (unfold a; lra). set (q := h a / a). assert (Q : h a = q * a) by (unfold q; field; lra). rewrite Q in L, U.
  replace ((epsilon ^ 2 + 2 * epsilon * v - 2 * v ^ 2) / 6 * S) with (S * (a ^ 2 / 6) - S * (v ^ 2 / 2)) by (unfold a; field).
  apply Rabs_le. split; apply Rmult_le_reg_r with a; trivial; nra.
Qed.
(* w^3/6 attains the bound. *)
Theorem clamped_difference_of_odd__second_order_sharp (v epsilon : R) : 0 <= v < epsilon -> let h w := w ^ 3 / 6 in
  (h (v + epsilon) - h 0) / (v + epsilon) - Derive h v = (epsilon ^ 2 + 2 * epsilon * v - 2 * v ^ 2) / 6.
Proof. intro V. cbv beta zeta. rewrite (is_derive_unique _ _ (v ^ 2 / 2)) by (auto_derive; trivial; field). field. lra. Qed.
(* Sine and rings are odd about v = 0. *)
Theorem clamped_difference_of_odd__odd (u v k_u k_v : R) :
  height_sine.h u (- v) k_u k_v = - height_sine.h u v k_u k_v /\ height_rings.h (- v) k_v = - height_rings.h v k_v.
Proof. unfold_fields. split; rewrite ?(Ropp_mult_distr_r_reverse k_v), ?(Ropp_mult_distr_r_reverse (2 * k_v)), ?Ropp_mult_distr_r_reverse, sin_neg; ring. Qed.
(* On [0, 1/k_v] ridges is |sin(pi k_u u)| sin(pi k_v v), which is odd. *)
Theorem clamped_difference_of_odd__first_ridge (u v k_u k_v : R) : 0 < k_v -> 0 <= v <= 1 / k_v ->
  height_ridges.h u v k_u k_v = Rabs (sin (PI * (k_u * u))) * sin (PI * (k_v * v)).
Proof.
  intros K V. unfold_fields. rewrite Rabs_mult. f_equal. apply Rabs_pos_eq. generalize PI_RGT_0. intro P.
  assert (0 <= k_v * v <= 1). { split; [nra|]. apply Rmult_le_reg_l with (/ k_v); [apply Rinv_0_lt_compat, K|]. rewrite <- Rmult_assoc, Rinv_l by lra. lra. }
  apply sin_ge_0; nra.
Qed.
Theorem clamped_difference_of_odd__first_ridge__point : exists v k_v : R, 0 < k_v /\ 0 <= v <= 1 / k_v.
Proof. exists 0, 1. lra. Qed.
Theorem clamped_difference_of_odd__second_order__false : ~ forall (h h1 : R -> R) (v epsilon : R),
  (forall w, is_derive h w (h1 w)) -> (forall w, h (- w) = - h w) -> 0 <= v < epsilon ->
  (h (v + epsilon) - h 0) / (v + epsilon) = h1 v.
Proof.
  intro H. generalize (H (fun w => w ^ 3) (fun w => 3 * w ^ 2) 0 1 ltac:(intro; auto_derive; trivial; simpl; ring) ltac:(intro; simpl; ring) ltac:(lra)). lra.
Qed.

(* Creases *)

(* sin(pi m + x) is sin x but for its sign. *)
Lemma sine_of_a_shift (m : Z) (x : R) : Rabs (sin (PI * IZR m + x)) = Rabs (sin x).
Proof.
  assert (N : forall n : nat, Rabs (sin (PI * INR n + x)) = Rabs (sin x)).
  { induction n as [|n IH]; [f_equal; f_equal; simpl; ring|]. rewrite S_INR.
    replace (PI * (INR n + 1) + x) with (PI * INR n + x + PI) by ring. rewrite neg_sin, Rabs_Ropp. exact IH. }
  assert (N' : forall n : nat, Rabs (sin (PI * - INR n + x)) = Rabs (sin x)).
  { induction n as [|n IH]; [f_equal; f_equal; simpl; ring|]. rewrite S_INR, <- IH.
    replace (PI * - INR n + x) with (PI * - (INR n + 1) + x + PI) by ring. rewrite neg_sin, Rabs_Ropp. reflexivity. }
  destruct (Z_le_gt_dec 0 m) as [H|H].
  - rewrite <- (Z2Nat.id m H), <- INR_IZR_INZ. apply N.
  - replace m with (- Z.of_nat (Z.to_nat (- m)))%Z by lia. rewrite opp_IZR, <- INR_IZR_INZ. apply N'.
Qed.

(* At distance delta from a crease m/k of |sin(pi k u)|: D_eps h = cos(pi k eps) sin(pi k delta)/eps. *)
Theorem straddling__value (k delta epsilon : R) (m : Z) : 0 < k -> Rabs delta < epsilon -> epsilon + Rabs delta <= 1 / k ->
  let h u := Rabs (sin (PI * (k * u))) in let u := IZR m / k + delta in
  (h (u + epsilon) - h (u - epsilon)) / (2 * epsilon) = cos (PI * (k * epsilon)) * sin (PI * (k * delta)) / epsilon.
Proof.
  intros K A B. cbv beta zeta. generalize PI_RGT_0. intro P. apply Rabs_def2 in A as A'. assert (E : 0 < epsilon) by lra.
  assert (S : forall t, 0 <= t <= 1 / k -> 0 <= sin (PI * (k * t))).
  { intros t T. assert (0 <= k * t <= 1). { split; [nra|]. apply Rmult_le_reg_l with (/ k); [apply Rinv_0_lt_compat, K|]. rewrite <- Rmult_assoc, Rinv_l; lra. }
    apply sin_ge_0; nra. }
  assert (L : - (1 / k - epsilon) <= delta <= 1 / k - epsilon) by (apply Rabs_le_between; lra).
  replace (PI * (k * (IZR m / k + delta + epsilon))) with (PI * IZR m + PI * (k * (delta + epsilon))) by (field; lra).
  replace (PI * (k * (IZR m / k + delta - epsilon))) with (PI * IZR m + - (PI * (k * (epsilon - delta)))) by (field; lra).
  rewrite !sine_of_a_shift, sin_neg, Rabs_Ropp, !Rabs_pos_eq by (apply S; lra).
  replace (PI * (k * (delta + epsilon))) with (PI * (k * epsilon) + PI * (k * delta)) by ring.
  replace (PI * (k * (epsilon - delta))) with (PI * (k * epsilon) - PI * (k * delta)) by ring.
  rewrite sin_plus, sin_minus. field. lra.
Qed.
Theorem straddling__value__point : exists k delta epsilon : R, 0 < k /\ Rabs delta < epsilon /\ epsilon + Rabs delta <= 1 / k.
Proof. exists 1, 0, (1/2). rewrite Rabs_R0. lra. Qed.
(* At the crease it is 0, for every eps. *)
Theorem straddling__at_the_crease (k epsilon : R) (m : Z) : 0 < k -> 0 < epsilon <= 1 / k ->
  let h u := Rabs (sin (PI * (k * u))) in (h (IZR m / k + epsilon) - h (IZR m / k - epsilon)) / (2 * epsilon) = 0.
Proof.
  intros K E. generalize (straddling__value k 0 epsilon m K). rewrite Rabs_R0. cbv beta zeta. intro H. rewrite !Rplus_0_r in H. rewrite H by lra.
  rewrite !Rmult_0_r, sin_0. field. lra.
Qed.
(* On either side the slope is +-pi k cos(pi k delta) for 0 < |delta| < 1/k. *)
Theorem straddling__slope (k delta : R) (m : Z) : 0 < k -> 0 < Rabs delta < 1 / k ->
  is_derive (fun u => Rabs (sin (PI * (k * u)))) (IZR m / k + delta) (sign delta * PI * k * cos (PI * (k * delta))).
Proof.
  intros K H. generalize PI_RGT_0. intro P.
  assert (Q : forall u, Rabs (sin (PI * (k * u))) = Rabs (sin (PI * (k * (u - IZR m / k))))).
  { intro u. replace (PI * (k * u)) with (PI * IZR m + PI * (k * (u - IZR m / k))) by (field; lra). apply sine_of_a_shift. }
  apply (is_derive_ext (fun u => Rabs (sin (PI * (k * (u - IZR m / k)))))); [intro; symmetry; apply Q|].
  assert (S : sin (PI * (k * delta)) <> 0 /\ sign (sin (PI * (k * delta))) = sign delta).
  { assert (T : forall t, 0 < t < 1 / k -> 0 < sin (PI * (k * t))).
    { intros t T. assert (0 < k * t < 1). { split; [nra|]. apply Rmult_lt_reg_l with (/ k); [apply Rinv_0_lt_compat, K|]. rewrite <- Rmult_assoc, Rinv_l; lra. }
      apply sin_gt_0; nra. }
    unfold Rabs in H. destruct (Rcase_abs delta) as [n|n].
    - assert (L : sin (PI * (k * delta)) < 0) by (generalize (T (- delta) H); replace (PI * (k * - delta)) with (- (PI * (k * delta))) by ring; rewrite sin_neg; lra).
      rewrite !sign_eq_m1 by assumption. lra.
    - generalize (T delta H). intro L. rewrite !sign_eq_1 by lra. lra. }
  destruct S as [S1 S2].
  eapply is_derive_is; [apply (is_derive_Rabs (fun u => sin (PI * (k * (u - IZR m / k)))) (IZR m / k + delta) (PI * k * cos (PI * (k * delta))))|].
  - auto_derive; trivial. replace (IZR m / k + delta + - (IZR m / k)) with delta by ring. ring.
  - replace (IZR m / k + delta - IZR m / k) with delta by ring. exact S1.
  - cbv beta. replace (IZR m / k + delta - IZR m / k) with delta by ring. rewrite S2. ring.
Qed.
Theorem straddling__value__false : ~ forall (k delta epsilon : R), 0 < k -> Rabs delta < epsilon -> epsilon + Rabs delta <= 1 / k ->
  (Rabs (sin (PI * (k * (delta + epsilon)))) - Rabs (sin (PI * (k * (delta - epsilon))))) / (2 * epsilon) = PI * k * cos (PI * (k * delta)).
Proof.
  intro H. generalize (H 1 0 (1/2)). rewrite Rabs_R0. intro K. specialize (K ltac:(lra) ltac:(lra) ltac:(lra)).
  replace (PI * (1 * (0 + 1/2))) with (PI / 2) in K by field. replace (PI * (1 * (0 - 1/2))) with (- (PI / 2)) in K by field.
  rewrite sin_neg, Rabs_Ropp, !Rmult_0_r, cos_0 in K. generalize PI_RGT_0. lra.
Qed.

(* So the error beside the crease comes to pi k, slope less difference as delta falls to 0. *)
Theorem straddling__error (k epsilon : R) : 0 < epsilon ->
  filterlim (fun delta => sign delta * PI * k * cos (PI * (k * delta)) - cos (PI * (k * epsilon)) * sin (PI * (k * delta)) / epsilon) (at_right 0) (locally (PI * k)).
Proof.
  intro E. apply (filterlim_ext_loc (fun delta => PI * k * cos (PI * (k * delta)) - cos (PI * (k * epsilon)) * sin (PI * (k * delta)) / epsilon)).
  - exists (mkposreal 1 Rlt_0_1). intros d _ D. rewrite sign_eq_1 by exact D. ring.
  - apply (filterlim_filter_le_1 (F := locally 0)); [intros Q H; unfold at_right, within; revert H; apply filter_imp; auto|].
    replace (PI * k) with (PI * k * cos (PI * (k * 0)) - cos (PI * (k * epsilon)) * sin (PI * (k * 0)) / epsilon) at 1 by (rewrite !Rmult_0_r, sin_0, cos_0; field; lra).
    apply (ex_derive_continuous (fun delta => PI * k * cos (PI * (k * delta)) - cos (PI * (k * epsilon)) * sin (PI * (k * delta)) / epsilon) 0). auto_derive. trivial.
Qed.
Theorem straddling__error__point : exists epsilon : R, 0 < epsilon.
Proof. exists 1. lra. Qed.
(* It does not come to 0. *)
Theorem straddling__error__false : ~ forall k epsilon, 0 < epsilon ->
  filterlim (fun delta => sign delta * PI * k * cos (PI * (k * delta)) - cos (PI * (k * epsilon)) * sin (PI * (k * delta)) / epsilon) (at_right 0) (locally 0).
Proof.
  intro H. generalize PI_RGT_0 (filterlim_locally_unique _ _ _ (H 1 1 Rlt_0_1) (straddling__error 1 1 Rlt_0_1)). lra.
Qed.

(* Ridges beside its creases *)

(* On a crease u = m/k_u: h(m/k_u +- s, v) = |sin(pi k_u s)| |sin(pi k_v v)|. *)
Theorem (* clause 1 *) ridges_on_creases__crease_in_u (v k_u k_v s : R) (m : Z) : k_u <> 0 ->
  height_ridges.h (IZR m / k_u + s) v k_u k_v = Rabs (sin (PI * (k_u * s))) * Rabs (sin (PI * (k_v * v))).
Proof.
  intro K. unfold_fields. rewrite Rabs_mult. f_equal.
  replace (PI * (k_u * (IZR m / k_u + s))) with (PI * IZR m + PI * (k_u * s)) by (field; exact K). apply sine_of_a_shift.
Qed.
Theorem (* clause 1 *) ridges_on_creases__crease_in_v (u k_u k_v s : R) (m : Z) : k_v <> 0 ->
  height_ridges.h u (IZR m / k_v + s) k_u k_v = Rabs (sin (PI * (k_u * u))) * Rabs (sin (PI * (k_v * s))).
Proof.
  intro K. unfold_fields. rewrite Rabs_mult. f_equal.
  replace (PI * (k_v * (IZR m / k_v + s))) with (PI * IZR m + PI * (k_v * s)) by (field; exact K). apply sine_of_a_shift.
Qed.

(* |sin(pi t)| >= pi t/2 for 0 <= t <= 1/2. *)
Lemma sine_above_half (t : R) : 0 <= t <= 1/2 -> PI * t / 2 <= sin (PI * t).
Proof.
  intro T. generalize PI_RGT_0. intro P. generalize (sine_from_below (PI * t) ltac:(nra)). intro L.
  assert (Q : PI ^ 2 < 12) by interval. assert (U : (PI * t) ^ 2 <= 3).
  { rewrite Rpow_mult_distr. assert (t ^ 2 <= 1/4) by nra. assert (0 <= PI ^ 2) by apply pow2_ge_0. nra. }
  assert (0 <= PI * t) by nra. assert (PI * t * (PI * t) ^ 2 <= PI * t * 3) by (apply Rmult_le_compat_l; lra). simpl in *. lra.
Qed.

(* h(m/k_u +- s, v)/s >= pi k_u |sin(pi k_v v)|/2 for 0 < s <= 1/(2 k_u). *)
Lemma beside_a_crease (v k_u k_v s : R) (m : Z) : 0 < k_u -> 0 < s <= / (2 * k_u) ->
  PI * k_u * Rabs (sin (PI * (k_v * v))) / 2 * s <= height_ridges.h (IZR m / k_u + s) v k_u k_v /\
  PI * k_u * Rabs (sin (PI * (k_v * v))) / 2 * s <= height_ridges.h (IZR m / k_u + - s) v k_u k_v.
Proof.
  intros K S. rewrite !ridges_on_creases__crease_in_u by lra. replace (PI * (k_u * - s)) with (- (PI * (k_u * s))) by ring. rewrite sin_neg, Rabs_Ropp.
  assert (T : 0 <= k_u * s <= 1/2). { split; [nra|]. apply Rmult_le_reg_l with (/ k_u); [apply Rinv_0_lt_compat, K|]. rewrite <- Rmult_assoc, Rinv_l, Rmult_1_l by lra.
    replace (/ k_u * (1/2)) with (/ (2 * k_u)) by (field; lra). lra. }
  generalize (sine_above_half (k_u * s) T) (Rabs_pos (sin (PI * (k_v * v)))) (Rle_abs (sin (PI * (k_u * s)))). intros A B C.
  assert (PI * (k_u * s) / 2 * Rabs (sin (PI * (k_v * v))) <= Rabs (sin (PI * (k_u * s))) * Rabs (sin (PI * (k_v * v)))) by (apply Rmult_le_compat_r; lra).
  split; lra.
Qed.

(* Where sin(pi k_v v) is not 0, ridges has no derivative by u there. *)
Theorem (* clause 2 *) ridges_on_creases__differ (v k_u k_v : R) (m : Z) : 0 < k_u -> sin (PI * (k_v * v)) <> 0 ->
  ~ ex_derive (fun u => height_ridges.h u v k_u k_v) (IZR m / k_u).
Proof.
  intros K S [d D]. generalize PI_RGT_0. intro P. apply is_derive_Reals in D.
  set (c := PI * k_u * Rabs (sin (PI * (k_v * v)))). assert (C : 0 < c) by (apply Rmult_lt_0_compat; [nra | apply Rabs_pos_lt, S]).
  destruct (D (c / 4) ltac:(lra)) as [delta L]. set (s := Rmin (delta / 2) (/ (2 * k_u))).
  assert (I : 0 < / (2 * k_u)) by (apply Rinv_0_lt_compat; lra). generalize (cond_pos delta). intro P'.
  assert (Q : 0 < s) by (apply Rmin_glb_lt; lra). assert (Q1 : s <= delta / 2) by apply Rmin_l. assert (Q2 : s <= / (2 * k_u)) by apply Rmin_r. clearbody s.
  destruct (beside_a_crease v k_u k_v s m K ltac:(lra)) as [A B]. fold c in A, B.
  assert (Z : height_ridges.h (IZR m / k_u) v k_u k_v = 0).
  { rewrite <- (Rplus_0_r (IZR m / k_u)), ridges_on_creases__crease_in_u by lra. rewrite !Rmult_0_r, sin_0, Rabs_R0. ring. }
  generalize (L s ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra)) (L (- s) ltac:(lra) ltac:(rewrite Rabs_Ropp, Rabs_pos_eq; lra)).
  rewrite Z, !Rminus_0_r. intros X Y. apply Rabs_def2 in X. apply Rabs_def2 in Y.
  assert (X' : height_ridges.h (IZR m / k_u + s) v k_u k_v / s >= c / 2).
  { apply Rle_ge, Rmult_le_reg_r with s; [exact Q|]. unfold Rdiv at 2. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (Y' : height_ridges.h (IZR m / k_u + - s) v k_u k_v / - s <= - (c / 2)).
  { replace (_ / - s) with (- (height_ridges.h (IZR m / k_u + - s) v k_u k_v / s)) by (field; lra). apply Ropp_le_contravar.
    apply Rmult_le_reg_r with s; [exact Q|]. unfold Rdiv at 2. rewrite Rmult_assoc, Rinv_l; lra. }
  lra.
Qed.
Theorem ridges_on_creases__differ__point : exists v k_u k_v : R, 0 < k_u /\ sin (PI * (k_v * v)) <> 0.
Proof. exists (1/2), 1, 1. replace (PI * (1 * (1/2))) with (PI / 2) by field. rewrite sin_PI2. lra. Qed.
(* The seed: ridges is differentiable. *)
Theorem ridges_on_creases__differ__false : ~ forall u v k_u k_v, ex_derive (fun u => height_ridges.h u v k_u k_v) u.
Proof.
  intro H. apply (ridges_on_creases__differ (1/2) 1 1 0); try lra; [|apply H]. replace (PI * (1 * (1/2))) with (PI / 2) by field. rewrite sin_PI2. lra.
Qed.

(* Where creases cross *)

Lemma sine_below (x : R) : Rabs (sin x) <= Rabs x.
Proof.
  assert (H : forall y, 0 <= y -> Rabs (sin y) <= y).
  { intros y Y. generalize (growth 0 sin cos 1 y Y). rewrite pow_1. replace (1 * (y / INR (0 + 1))) with y by (simpl; field). intro G. apply G.
    - intro s. auto_derive; trivial. ring.
    - apply sin_0.
    - intros s _. simpl. rewrite Rmult_1_r. apply Rabs_le, COS_bound. }
  unfold Rabs at 2. destruct (Rcase_abs x); [|apply H; lra]. rewrite <- Rabs_Ropp, <- sin_neg. apply H. lra.
Qed.

(* At (a, b) from a crossing: 0 <= h <= pi^2 (k_u^2 a^2 + k_v^2 b^2)/2 <= K (a^2 + b^2)/2. *)
Theorem (* clause 1 *) ridges_at_crossings__crossing (k_u k_v a b : R) (m n : Z) : 0 < k_u -> 0 < k_v ->
  0 <= height_ridges.h (IZR m / k_u + a) (IZR n / k_v + b) k_u k_v <= PI ^ 2 * (k_u ^ 2 * a ^ 2 + k_v ^ 2 * b ^ 2) / 2 /\
  PI ^ 2 * (k_u ^ 2 * a ^ 2 + k_v ^ 2 * b ^ 2) / 2 <= PI ^ 2 * Rmax k_u k_v ^ 2 * (a ^ 2 + b ^ 2) / 2.
Proof.
  intros K L. split; [split; [apply Rabs_pos|]|].
  - rewrite ridges_on_creases__crease_in_u by lra.
    replace (PI * (k_v * (IZR n / k_v + b))) with (PI * IZR n + PI * (k_v * b)) by (field; lra). rewrite sine_of_a_shift.
    generalize (sine_below (PI * (k_u * a))) (sine_below (PI * (k_v * b))) (Rabs_pos (sin (PI * (k_u * a)))) (Rabs_pos (sin (PI * (k_v * b)))). intros A B C D.
    assert (Rabs (sin (PI * (k_u * a))) * Rabs (sin (PI * (k_v * b))) <= Rabs (PI * (k_u * a)) * Rabs (PI * (k_v * b))) by (apply Rmult_le_compat; assumption).
    generalize (pow2_ge_0 (Rabs (PI * (k_u * a)) - Rabs (PI * (k_v * b)))). intro Q.
    assert (E : Rabs (PI * (k_u * a)) ^ 2 + Rabs (PI * (k_v * b)) ^ 2 = PI ^ 2 * (k_u ^ 2 * a ^ 2 + k_v ^ 2 * b ^ 2)) by (rewrite !pow2_abs; ring). nra.
  - assert (A : k_u ^ 2 <= Rmax k_u k_v ^ 2) by (apply pow_incr; split; [lra | apply Rmax_l]). assert (B : k_v ^ 2 <= Rmax k_u k_v ^ 2) by (apply pow_incr; split; [lra | apply Rmax_r]).
    unfold Rdiv. rewrite Rmult_assoc with (r1 := PI ^ 2) (r2 := Rmax k_u k_v ^ 2). apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_l; [apply pow2_ge_0|].
    generalize (pow2_ge_0 a) (pow2_ge_0 b). nra.
Qed.
(* So h is differentiable there, with derivative 0: it is at most eta times the distance wherever K times the distance is at most 2 eta. *)
Theorem (* clause 2 *) ridges_at_crossings__flat (k_u k_v : R) (m n : Z) : 0 < k_u -> 0 < k_v -> forall eta, 0 < eta -> let K := PI ^ 2 * Rmax k_u k_v ^ 2 in
  0 < 2 * eta / K /\ forall a b, K * sqrt (a ^ 2 + b ^ 2) <= 2 * eta -> Rabs (height_ridges.h (IZR m / k_u + a) (IZR n / k_v + b) k_u k_v) <= eta * sqrt (a ^ 2 + b ^ 2).
Proof.
  intros K L eta Hn. cbv zeta. assert (C : 0 < PI ^ 2 * Rmax k_u k_v ^ 2).
  { apply Rmult_lt_0_compat; apply pow_lt; [apply PI_RGT_0 | apply Rlt_le_trans with k_u; [exact K | apply Rmax_l]]. }
  split; [apply Rdiv_lt_0_compat; lra|]. intros a b H. destruct (ridges_at_crossings__crossing k_u k_v a b m n K L) as [[A B] B'].
  rewrite Rabs_pos_eq by exact A. eapply Rle_trans; [exact B|]. eapply Rle_trans; [exact B'|].
  assert (R2 : sqrt (a ^ 2 + b ^ 2) ^ 2 = a ^ 2 + b ^ 2) by (apply pow2_sqrt; generalize (pow2_ge_0 a) (pow2_ge_0 b); lra). rewrite <- R2 at 1.
  generalize (sqrt_pos (a ^ 2 + b ^ 2)). nra.
Qed.
(* Where one crease runs alone it is not: on v = 0 about v = 1/2. *)
Theorem ridges_at_crossings__flat__false : ~ forall k_u k_v (m : Z), 0 < k_u -> 0 < k_v -> forall eta, 0 < eta -> exists delta, 0 < delta /\
  forall a, Rabs a < delta -> Rabs (height_ridges.h (IZR m / k_u + a) (1/2) k_u k_v) <= eta * Rabs a.
Proof.
  intro H. destruct (H 1 1 0%Z ltac:(lra) ltac:(lra) 1 ltac:(lra)) as (delta & D & L). set (s := Rmin (delta / 2) (1/2)).
  assert (S : 0 < s) by (apply Rmin_glb_lt; lra). assert (S1 : s <= delta / 2) by apply Rmin_l. assert (S2 : s <= 1/2) by apply Rmin_r. clearbody s.
  generalize (L s ltac:(rewrite Rabs_pos_eq; lra)). rewrite ridges_on_creases__crease_in_u by lra. replace (PI * (1 * (1/2))) with (PI / 2) by field.
  rewrite sin_PI2, Rabs_R1, Rmult_1_r, Rabs_Rabsolu, Rmult_1_l, Rmult_1_l, (Rabs_pos_eq s) by lra. generalize (sine_above_half s ltac:(lra)) (Rle_abs (sin (PI * s))).
  assert (PI > 3) by interval. nra.
Qed.

(* The seam *)

(* sin(pi k (u + 1)) = (-1)^k sin(pi k u) for whole k. *)
Lemma seam_parity (k : nat) (u : R) : sin (PI * (INR k * (u + 1))) = (-1) ^ k * sin (PI * (INR k * u)).
Proof.
  assert (H : forall n x, sin (PI * INR n + x) = (-1) ^ n * sin x).
  { induction n as [|n IH]; intro x; [simpl; rewrite Rmult_1_l; f_equal; ring|]. rewrite S_INR.
    replace (PI * (INR n + 1) + x) with (PI * INR n + x + PI) by ring. rewrite neg_sin, IH. simpl. ring. }
  rewrite <- H. f_equal. ring.
Qed.
Theorem seam__parity__false : ~ forall k u, sin (PI * (INR k * (u + 1))) = sin (PI * (INR k * u)).
Proof.
  intro H. generalize (H 1%nat (1/2)). rewrite seam_parity. simpl INR. replace (PI * (1 * (1/2))) with (PI / 2) by field. rewrite sin_PI2. simpl. lra.
Qed.
(* Across u = 0 sine's height jumps by -sin(pi k_u) sin(pi k_v v), and its slope by pi k_u (1 - cos(pi k_u)) sin(pi k_v v). *)
Theorem (* clause 2 *) seam__sine_jump (v k_u k_v : R) :
  height_sine.h 0 v k_u k_v - height_sine.h 1 v k_u k_v = - sin (PI * k_u) * sin (PI * (k_v * v)) /\
  gradient_sine.h_u 0 v k_u k_v - gradient_sine.h_u 1 v k_u k_v = PI * k_u * (1 - cos (PI * k_u)) * sin (PI * (k_v * v)).
Proof. unfold_fields. rewrite !Rmult_0_r, !Rmult_1_r, sin_0, cos_0. split; ring. Qed.
Theorem seam__sine_jump__false : ~ forall v k_u k_v, gradient_sine.h_u 0 v k_u k_v = gradient_sine.h_u 1 v k_u k_v.
Proof.
  intro H. generalize (H (1/2) 1 1) (proj2 (seam__sine_jump (1/2) 1 1)). intros -> E. replace (PI * (1 * (1/2))) with (PI / 2) in E by field.
  rewrite Rmult_1_r, sin_PI2, cos_PI in E. generalize PI_RGT_0. lra.
Qed.
(* cos(pi n) = (-1)^n and sin(pi n) = 0 for whole n. *)
Theorem (* clause 1 *) seam__whole (n : nat) : cos (PI * INR n) = (-1) ^ n /\ sin (PI * INR n) = 0.
Proof.
  induction n as [|n [C S]]; [simpl; rewrite Rmult_0_r, sin_0, cos_0; split; reflexivity|]. rewrite S_INR, Rmult_plus_distr_l, Rmult_1_r, neg_cos, neg_sin, C, S. simpl. split; ring.
Qed.
Theorem seam__whole__false : ~ forall n, cos (PI * INR n) = 1.
Proof. intro H. generalize (H 1%nat). rewrite (proj1 (seam__whole 1)). simpl. lra. Qed.
Lemma sine_of_whole (n : Z) : sin (PI * IZR n) = 0.
Proof. apply sin_eq_0_1. exists n. ring. Qed.
Lemma cosine_of_even (n : Z) : cos (PI * IZR (2 * n)) = 1.
Proof. rewrite mult_IZR. replace (PI * (2 * IZR n)) with (2 * (PI * IZR n)) by ring. rewrite cos_2a_sin, sine_of_whole. ring. Qed.
Lemma cosine_of_odd (n : Z) : cos (PI * IZR (2 * n + 1)) = -1.
Proof. rewrite plus_IZR, Rmult_plus_distr_l, Rmult_1_r, neg_cos, cosine_of_even. reflexivity. Qed.
(* For even k_u, of either sign, nothing jumps; for odd k_u the slope in u alone does, by 2 pi k_u sin(pi k_v v). *)
Theorem (* clause 3 *) seam__even_slopes (v k_v : R) (n : Z) : let k_u := IZR (2 * n) in
  height_sine.h 0 v k_u k_v = height_sine.h 1 v k_u k_v /\ gradient_sine.h_u 0 v k_u k_v = gradient_sine.h_u 1 v k_u k_v /\
  gradient_sine.h_v 0 v k_u k_v = gradient_sine.h_v 1 v k_u k_v.
Proof. cbv zeta. unfold_fields. rewrite !Rmult_0_r, !Rmult_1_r, sine_of_whole, cosine_of_even, sin_0, cos_0. repeat split; ring. Qed.
Theorem (* clause 4 *) seam__odd_slopes (v k_v : R) (n : Z) : let k_u := IZR (2 * n + 1) in
  height_sine.h 0 v k_u k_v = height_sine.h 1 v k_u k_v /\ gradient_sine.h_v 0 v k_u k_v = gradient_sine.h_v 1 v k_u k_v /\
  gradient_sine.h_u 0 v k_u k_v - gradient_sine.h_u 1 v k_u k_v = 2 * PI * k_u * sin (PI * (k_v * v)).
Proof. cbv zeta. unfold_fields. rewrite !Rmult_0_r, !Rmult_1_r, sine_of_whole, cosine_of_odd, sin_0, cos_0. repeat split; ring. Qed.
(* Ridges is 0 on the seam for whole k_u, and even about it, as on a crease. *)
Theorem (* clause 5 *) seam__ridges_even (s v k_v : R) (k : Z) :
  height_ridges.h 0 v (IZR k) k_v = 0 /\ height_ridges.h 1 v (IZR k) k_v = 0 /\ height_ridges.h (1 - s) v (IZR k) k_v = height_ridges.h s v (IZR k) k_v /\
  height_ridges.h s v (IZR k) k_v ^ 2 = sin (PI * (IZR k * s)) ^ 2 * sin (PI * (k_v * v)) ^ 2.
Proof.
  assert (H : forall t, Rabs (sin (PI * (IZR k * (1 - t)))) = Rabs (sin (PI * (IZR k * t)))).
  { intro t. replace (PI * (IZR k * (1 - t))) with (PI * IZR k + - (PI * (IZR k * t))) by ring. rewrite sine_of_a_shift, sin_neg, Rabs_Ropp. reflexivity. }
  unfold_fields. rewrite pow2_abs, !Rabs_mult, (H s), <- (H 1). replace (1 - 1) with 0 by ring. rewrite !Rmult_0_r, sin_0, Rabs_R0. repeat split; ring.
Qed.
(* Rings does not depend on u: u is in no line of its height, and its slope in u and its central difference are 0. *)
Theorem (* clause 7 *) seam__rings_whole (v k_v epsilon : R) : height_rings.h v k_v = sin (PI * (2 * k_v * v)) /\ gradient_rings.h_u = 0 /\ central_rings.h_u v k_v epsilon = 0.
Proof. unfold central_rings.h_u, central_rings.h_u_plus, central_rings.h_u_minus, Rdiv. repeat split; ring. Qed.
(* Sine does. *)
Theorem seam__rings_whole__false : ~ forall u v k_u k_v, gradient_sine.h_u u v k_u k_v = 0.
Proof. intro H. apply gradients__on_creases__false. intros u v k_u k_v _. apply H. Qed.
Theorem ridges_at_crossings__crossing__false : ~ forall k_u k_v a b, height_ridges.h a b k_u k_v = PI ^ 2 * (k_u ^ 2 * a ^ 2 + k_v ^ 2 * b ^ 2) / 2.
Proof.
  intro H. generalize (H 1 1 1 0). unfold_fields. rewrite !Rmult_1_l, Rmult_0_r, sin_0, Rmult_0_r, Rabs_R0. assert (0 < PI ^ 2) by (apply pow_lt, PI_RGT_0). lra.
Qed.

(* Sine's height is periodic for even k_u: h(u + 1, v) = h(u, v). *)
Theorem (* clause 3 *) seam__even_period (u v k_v : R) (n : Z) : height_sine.h (u + 1) v (IZR (2 * n)) k_v = height_sine.h u v (IZR (2 * n)) k_v.
Proof. unfold_fields. rewrite Rmult_plus_distr_l, Rmult_1_r, Rmult_plus_distr_l, sin_plus, sine_of_whole, cosine_of_even. ring. Qed.
(* Ridges jumps where neither sin(pi k_u) nor sin(pi k_v v) is 0. *)
Theorem (* clause 6 *) seam__ridges_jumps (v k_u k_v : R) : sin (PI * k_u) <> 0 -> sin (PI * (k_v * v)) <> 0 -> height_ridges.h 0 v k_u k_v = 0 /\ 0 < height_ridges.h 1 v k_u k_v.
Proof.
  intros A B. unfold_fields. rewrite !Rmult_0_r, sin_0, Rmult_0_l, Rabs_R0, Rmult_1_r. split; [reflexivity|].
  apply Rabs_pos_lt. intro E. apply Rmult_integral in E. destruct E; contradiction.
Qed.

(* At s on either side of a crease, 0 < s <= 1/k: h = sin x A/(pi k), x = pi k s, and A (1 - x^2/6) <= h/s <= A with the slope A. *)
Theorem (* clauses 1, 2 *) ridges_on_creases__quotients (A k s : R) : 0 <= A -> 0 < k -> 0 < s <= 1 / k -> let x := PI * (k * s) in let h := Rabs (sin x) * A in
  PI * k * A * (1 - x ^ 2 / 6) <= h / s <= PI * k * A /\ (x <= 1 -> 0 < A -> PI * k * A < h / s - - (h / s)).
Proof.
  intros HA K S. cbv zeta. generalize PI_RGT_0. intro P. assert (T : 0 < k * s <= 1).
  { split; [nra|]. apply Rmult_le_reg_l with (/ k); [apply Rinv_0_lt_compat, K|]. rewrite <- Rmult_assoc, Rinv_l by lra. lra. }
  set (x := PI * (k * s)). assert (X : 0 < x) by (unfold x; nra). rewrite Rabs_pos_eq by (apply sin_ge_0; unfold x; nra).
  generalize (sine_from_below x ltac:(lra)) (sin_lt_x x X). intros L U.
  assert (E : sin x * A / s = sin x / x * (PI * k * A)) by (unfold x; field; repeat split; lra). rewrite E.
  assert (Q : 1 - x ^ 2 / 6 <= sin x / x <= 1).
  { assert (W : sin x / x * x = sin x) by (field; lra). split; apply Rmult_le_reg_r with x; trivial; rewrite W; nra. }
  assert (0 <= PI * k * A) by (apply Rmult_le_pos; [nra | exact HA]). split; [split; nra|]. intros X1 A0.
  assert (0 < PI * k * A) by (apply Rmult_lt_0_compat; [nra | exact A0]). assert (x ^ 2 <= 1) by nra. nra.
Qed.
(* The same crease in v has no derivative either. *)
Theorem (* clause 2 *) ridges_on_creases__differ_in_v (u k_u k_v : R) (n : Z) : 0 < k_v -> sin (PI * (k_u * u)) <> 0 ->
  ~ ex_derive (fun v => height_ridges.h u v k_u k_v) (IZR n / k_v).
Proof.
  intros K S E. apply (ridges_on_creases__differ u k_v k_u n K S). destruct E as [d D]. exists d. revert D. apply is_derive_ext.
  intro t. unfold_fields. rewrite Rmult_comm. reflexivity.
Qed.
(* False variants: the clamped difference has not the span 2 eps, and the slope beside a crease has the side's sign. *)
Theorem clamped_difference__clamp__false : ~ forall v k_v epsilon, 0 < epsilon -> 0 <= v < epsilon -> v + epsilon <= 1 ->
  central_rings.h_v v k_v epsilon = (height_rings.h (v + epsilon) k_v - height_rings.h 0 k_v) / (2 * epsilon).
Proof.
  intro H. generalize (H 0 1 (1/4) ltac:(lra) ltac:(lra) ltac:(lra)). rewrite (proj2 (proj2 (clamped_difference__clamp 0 0 0 1 (1/4) ltac:(lra) ltac:(lra)))).
  unfold_fields. replace (PI * (2 * 1 * (0 + 1/4))) with (PI / 2) by field. rewrite !Rmult_0_r, sin_0, sin_PI2. lra.
Qed.
Theorem straddling__slope__false : ~ forall k delta (m : Z), 0 < k -> 0 < Rabs delta < 1 / k ->
  is_derive (fun u => Rabs (sin (PI * (k * u)))) (IZR m / k + delta) (PI * k * cos (PI * (k * delta))).
Proof.
  intro H. assert (D : 0 < Rabs (- (1/4)) < 1 / 1) by (rewrite Rabs_left; lra).
  generalize (is_derive_unique _ _ _ (H 1 (- (1/4)) 0%Z ltac:(lra) D)) (is_derive_unique _ _ _ (straddling__slope 1 (- (1/4)) 0 ltac:(lra) D)). intros A B.
  assert (C := eq_trans (eq_sym A) B). rewrite sign_eq_m1 in C by lra. generalize PI_RGT_0. intro P.
  assert (Q : 0 < cos (PI * (1 * - (1/4)))) by (apply cos_gt_0; lra). assert (0 < PI * 1 * cos (PI * (1 * - (1/4)))) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
