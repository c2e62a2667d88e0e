(* The difference that is clamped at the pole v = 0. *)

From Coq Require Import Reals Lra Psatz Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Fields Claim.
From Formal Require Statements.
Open Scope R_scope.

Lemma over_a_span (s x y : R) : 0 < s -> y = s * x -> y >= 0 -> x >= 0.
Proof. intros S -> Y. apply Rle_ge, Rmult_le_reg_l with s; lra. Qed.

Theorem clamped_difference__clamp : Statements.clamped_difference__clamp.
Proof. claim. Qed.
Ltac at_the_pole span := match goal with E : ?e > 0, V : ?v >= 0, L : ?v - ?e < 0, T : ?e + ?v <= 1 |- _ =>
  assert (span = e + v) by apply (clamped_difference__clamp e v E V L T) end.
Theorem clamped_difference__first_order : Statements.clamped_difference__first_order.
Proof.
  red. intros. at_the_pole span_v. assert (D : (epsilon + v) * (h_v - slope) = bend_plus * epsilon ^ 2 / 2 - bend_minus * v ^ 2 / 2).
  { unfold h_v, h_v_plus, h_v_minus. rewrite H7. field. lra. }
  clearbody h_v. assert (E : 0 <= epsilon ^ 2) by apply pow2_ge_0. assert (V : 0 <= v ^ 2) by apply pow2_ge_0.
  assert (B : largest * (epsilon ^ 2 + v ^ 2) / 2 - (epsilon + v) * (h_v - slope) >= 0) by (rewrite D; nra).
  assert (C : largest * (epsilon ^ 2 + v ^ 2) / 2 + (epsilon + v) * (h_v - slope) >= 0) by (rewrite D; nra).
  repeat split; try lra; [revert B | revert C]; apply (over_a_span (epsilon + v)); try field; lra.
Qed.
Theorem clamped_difference__first_order_sharp : Statements.clamped_difference__first_order_sharp.
Proof. red. intros. at_the_pole span_v. unfold h_v, h_v_plus, h_v_minus. rewrite H3. repeat split; try field; lra. Qed.
Theorem clamped_difference__at_the_pole_itself : Statements.clamped_difference__at_the_pole_itself.
Proof. claim. Qed.


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

(* |h(v + t) - h - t h'| <= S t^2/2 where h' moves by at most S over each unit of length, and the same before v. *)
Lemma value_after (h h1 : R -> R) (v t S : R) : (forall w, is_derive h w (h1 w)) -> 0 <= t ->
  (forall s, 0 <= s <= t -> Rabs (h1 (v + s) - h1 v) <= S * s ^ 1) -> Rabs (h (v + t) - h v - t * h1 v) <= S * (t ^ 2 / 2).
Proof.
  intros D T B. replace (S * (t ^ 2 / 2)) with (S * (t ^ (1 + 1) / INR (1 + 1))) by (simpl; field).
  apply (growth 1 (fun s => h (v + s) - h v - s * h1 v) (fun s => h1 (v + s) - h1 v)); trivial.
  - intro r. auto_derive; [exists (h1 (v + r)); apply D|]. replace (Derive _ _) with (h1 (v + r)) by (symmetry; apply is_derive_unique, D). ring.
  - rewrite Rplus_0_r. ring.
Qed.
Lemma value_before (h h1 : R -> R) (v t S : R) : (forall w, is_derive h w (h1 w)) -> 0 <= t ->
  (forall s, 0 <= s <= t -> Rabs (h1 (v - s) - h1 v) <= S * s ^ 1) -> Rabs (h (v - t) - h v + t * h1 v) <= S * (t ^ 2 / 2).
Proof.
  intros D T B. generalize (value_after (fun w => h (- w)) (fun w => - h1 (- w)) (- v) t S).
  rewrite !Ropp_involutive. replace (- (- v + t)) with (v - t) by ring. replace (h (v - t) - h v - t * - h1 v) with (h (v - t) - h v + t * h1 v) by ring.
  intro G. apply G; trivial.
  - intro w. auto_derive; [exists (h1 (- w)); apply D|]. replace (Derive _ _) with (h1 (- w)) by (symmetry; apply is_derive_unique, D). ring.
  - intros s Hs. replace (- (- v + s)) with (v - s) by ring. replace (- h1 (v - s) - - h1 v) with (- (h1 (v - s) - h1 v)) by ring. rewrite Rabs_Ropp. apply B, Hs.
Qed.

(* The printed lines' difference of any height, *)
Definition clamped (h : R -> R) (v epsilon : R) : R := (h (central_sine.v_plus v epsilon) - h (central_sine.v_minus v epsilon)) / central_sine.span_v v epsilon.
Lemma clamped_is (h : R -> R) (v epsilon : R) : 0 <= v < epsilon -> v + epsilon <= 1 -> clamped h v epsilon = (h (v + epsilon) - h 0) / (v + epsilon).
Proof.
  intros V W. destruct (clamped_difference__clamp epsilon v) as (A & B & C); try lra. unfold clamped. rewrite (Rplus_comm v).
  change (central_sine.v_plus v epsilon = epsilon + v) in A. change (central_sine.v_minus v epsilon = 0) in B. change (central_sine.span_v v epsilon = epsilon + v) in C.
  rewrite A, B, C. reflexivity.
Qed.
(* those of the book among them. *)
Theorem clamped_difference__of_the_fields (u v k_u k_v epsilon : R) : central_sine.h_v u v k_u k_v epsilon = clamped (fun v => height_sine.h u v k_u k_v) v epsilon /\
  central_ridges.h_v u v k_u k_v epsilon = clamped (fun v => height_ridges.h u v k_u k_v) v epsilon /\ central_rings.h_v v k_v epsilon = clamped (fun v => height_rings.h v k_v) v epsilon.
Proof. repeat split; reflexivity. Qed.
Theorem clamped_difference__of_the_fields__false : ~ forall v k_v epsilon, 0 < epsilon -> central_rings.h_v v k_v epsilon = clamped (fun v => height_ridges.h (1/2) v 1 k_v) v epsilon.
Proof.
  intro H. generalize (H 0 1 (1/2) ltac:(lra)). rewrite (proj2 (proj2 (clamped_difference__of_the_fields 0 0 0 1 (1/2)))), !clamped_is by lra. unfold_fields.
  replace (PI * (2 * 1 * (0 + 1/2))) with PI by field. replace (0 + 1/2) with (1/2) by ring. rewrite sine_of_a_right_angle, !Rmult_0_r, sin_0, sin_PI, Rmult_1_l, Rmult_0_r, Rabs_R1, Rabs_R0. lra.
Qed.

(* Whatever h, if its slope moves by at most S over each unit of length of the step, as it does where |h''| <= S. *)
Theorem clamped_difference__of_any_height (h h1 : R -> R) (v epsilon S : R) : (forall w, is_derive h w (h1 w)) -> 0 <= v < epsilon -> v + epsilon <= 1 ->
  (forall w x, 0 <= w <= v + epsilon -> 0 <= x <= v + epsilon -> Rabs (h1 w - h1 x) <= S * Rabs (w - x)) ->
  Rabs (clamped h v epsilon - h1 v) <= (epsilon ^ 2 + v ^ 2) / (2 * (epsilon + v)) * S.
Proof.
  intros D V W B. rewrite clamped_is by assumption.
  assert (A := value_after h h1 v epsilon S D ltac:(lra)). assert (C := value_before h h1 v v S D ltac:(lra)). replace (v - v) with 0 in C by ring.
  assert (P : forall s, 0 <= s -> S * s ^ 1 = S * Rabs (v + s - v)) by (intros s Q; rewrite Rabs_pos_eq; lra).
  assert (M : forall s, 0 <= s -> S * s ^ 1 = S * Rabs (v - s - v)) by (intros s Q; rewrite Rabs_left1; lra).
  specialize (A ltac:(intros s Q; rewrite P by lra; apply B; lra)). specialize (C ltac:(intros s Q; rewrite M by lra; apply B; lra)).
  replace (_ / _ - h1 v) with (((h (v + epsilon) - h v - epsilon * h1 v) - (h 0 - h v + v * h1 v)) / (v + epsilon)) by (field; lra).
  unfold Rdiv at 1. rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; lra).
  replace ((epsilon ^ 2 + v ^ 2) / (2 * (epsilon + v)) * S) with ((S * (epsilon ^ 2 / 2) + S * (v ^ 2 / 2)) * / (v + epsilon)) by (field; lra).
  apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra|]. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
Qed.
(* No smaller factor will do: h(w) = (w - v)|w - v|/2, whose derivative |w - v| is 1-Lipschitz, attains it. *)
Lemma slope_of_half_square (v w : R) : is_derive (fun w => (w - v) * Rabs (w - v) / 2) w (Rabs (w - v)).
Proof.
  destruct (Rtotal_order w v) as [L|[->|G]].
  - rewrite Rabs_left by lra. apply (is_derive_ext_loc (fun w => - (w - v) ^ 2 / 2)); [|auto_derive; trivial; field].
    assert (P : 0 < v - w) by lra. exists (mkposreal _ P). intros y B. change (Rabs (y - w) < v - w) in B.
    apply Rabs_def2 in B. rewrite Rabs_left by lra. match goal with |- ?a = ?b => change (a = b :> R) end; field.
  - rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. apply is_derive_Reals. intros e E. exists (mkposreal e E). intros t T B. simpl in B.
    replace (v + t - v) with t by ring. replace (v - v) with 0 by ring. rewrite Rmult_0_l. replace (_ - 0) with (Rabs t / 2) by (field; exact T).
    generalize (Rabs_pos t). intro. rewrite Rabs_pos_eq; lra.
  - rewrite Rabs_pos_eq by lra. apply (is_derive_ext_loc (fun w => (w - v) ^ 2 / 2)); [|auto_derive; trivial; field].
    assert (P : 0 < w - v) by lra. exists (mkposreal _ P). intros y B. change (Rabs (y - w) < w - v) in B.
    apply Rabs_def2 in B. rewrite Rabs_pos_eq by lra. match goal with |- ?a = ?b => change (a = b :> R) end; field.
Qed.
Theorem clamped_difference__attained (v epsilon : R) : 0 <= v < epsilon -> v + epsilon <= 1 -> let h w := (w - v) * Rabs (w - v) / 2 in
  (forall w, is_derive h w (Rabs (w - v))) /\ (forall w x, Rabs (Rabs (w - v) - Rabs (x - v)) <= 1 * Rabs (w - x)) /\
  clamped h v epsilon - Rabs (v - v) = (epsilon ^ 2 + v ^ 2) / (2 * (epsilon + v)) * 1.
Proof.
  intros V W. cbv zeta. split; [apply slope_of_half_square | split].
  - intros w x. rewrite Rmult_1_l. replace (w - x) with (w - v - (x - v)) by ring. apply Rabs_triang_inv2.
  - rewrite clamped_is by assumption. replace (v + epsilon - v) with epsilon by ring. replace (0 - v) with (- v) by ring. replace (v - v) with 0 by ring.
    rewrite Rabs_Ropp, Rabs_R0, !Rabs_pos_eq by lra. field. lra.
Qed.
Theorem clamped_difference__attained__false : ~ forall v epsilon, 0 <= v < epsilon -> v + epsilon <= 1 ->
  clamped (fun w => (w - v) * Rabs (w - v) / 2) v epsilon - Rabs (v - v) = 0.
Proof. intro H. generalize (H 0 1 ltac:(lra) ltac:(lra)) (proj2 (proj2 (clamped_difference__attained 0 1 ltac:(lra) ltac:(lra)))). cbv beta zeta. intros -> E. lra. Qed.
Theorem clamped_difference__of_any_height__false : ~ forall (h h1 : R -> R) (v epsilon S : R), (forall w, is_derive h w (h1 w)) -> 0 <= v < epsilon -> v + epsilon <= 1 ->
  (forall w x, Rabs (h1 w - h1 x) <= S * Rabs (w - x)) -> Rabs (clamped h v epsilon - h1 v) <= (epsilon ^ 2 + v ^ 2) / (3 * (epsilon + v)) * S.
Proof.
  intro H. destruct (clamped_difference__attained 0 1 ltac:(lra) ltac:(lra)) as (D & L & E). generalize (H _ _ 0 1 1 D ltac:(lra) ltac:(lra) L).
  rewrite E, Rabs_pos_eq; lra.
Qed.

(* Where the field is odd *)

Theorem clamped_difference_of_odd__odd : Statements.clamped_difference_of_odd__odd.
Proof.
  red. intros. unfold h_sine, h_rings, h_ridge. replace (PI * (k_v * - v)) with (- (PI * (k_v * v))) by ring. replace (PI * (2 * -1 * k_v * v)) with (- (PI * (2 * k_v * v))) by ring.
  replace (- v * PI * k_v) with (- (v * PI * k_v)) by ring. rewrite !sin_neg. repeat split; ring.
Qed.
Theorem clamped_difference_of_odd__first_ridge : Statements.clamped_difference_of_odd__first_ridge.
Proof.
  red. intros k_u k_v u v K V L. assert (S : 0 <= sin (v * PI * k_v)) by (generalize PI_RGT_0; intro; apply sin_ge_0; [apply Rmult_le_pos; nra | nra]).
  generalize (Rabs_pos (sin (u * PI * k_u))). intro U. replace (PI * (k_u * u)) with (u * PI * k_u) by ring. replace (PI * (k_v * v)) with (v * PI * k_v) by ring.
  rewrite Rabs_mult, (Rabs_pos_eq _ S). repeat split; nra.
Qed.
Theorem clamped_difference_of_odd__second_order : Statements.clamped_difference_of_odd__second_order.
Proof.
  red. intros. at_the_pole span_v. set (rise := (epsilon + v) ^ 2 / 8 - 1 / 2 * v ^ 2). assert (R0 : rise >= 0) by (unfold rise; nra).
  assert (D : h_v - slope = bend_minus * rise + bend_plus * (epsilon + v) ^ 2 / 24).
  { unfold h_v, h_v_plus, h_v_minus, rise. rewrite H7. field. lra. }
  assert (W : 1 / 6 * epsilon ^ 2 + 1 / 3 * epsilon * v - 1 / 3 * v ^ 2 = rise + (epsilon + v) ^ 2 / 24) by (unfold rise; field). rewrite W.
  clearbody h_v rise. assert (E : 0 <= (epsilon + v) ^ 2) by apply pow2_ge_0. set (q := (epsilon + v) ^ 2) in *. repeat split; try lra; nra.
Qed.
Theorem clamped_difference_of_odd__second_order_sharp : Statements.clamped_difference_of_odd__second_order_sharp.
Proof. claim. Qed.

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

(* The clamp costs no order where h is odd about v = 0. *)
Theorem clamped_difference_of_odd__of_any_height (h h1 h2 h3 : R -> R) (v epsilon S : R) :
  (forall w, is_derive h w (h1 w)) -> (forall w, is_derive h1 w (h2 w)) -> (forall w, is_derive h2 w (h3 w)) ->
  (forall w, h (- w) = - h w) -> 0 <= v < epsilon -> v + epsilon <= 1 -> (forall w, 0 <= w <= v + epsilon -> Rabs (h3 w) <= S) ->
  Rabs (clamped h v epsilon - h1 v) <= (epsilon ^ 2 + 2 * epsilon * v - 2 * v ^ 2) / 6 * S.
Proof.
  intros D1 D2 D3 O V Top B. rewrite clamped_is by assumption.
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
Theorem clamped_difference_of_odd__of_any_height__false : ~ forall (h h1 h2 h3 : R -> R) (v epsilon S : R),
  (forall w, is_derive h w (h1 w)) -> (forall w, is_derive h1 w (h2 w)) -> (forall w, is_derive h2 w (h3 w)) -> (forall w, h (- w) = - h w) -> 0 <= v < epsilon ->
  v + epsilon <= 1 -> (forall w, Rabs (h3 w) <= S) -> Rabs (clamped h v epsilon - h1 v) <= (epsilon ^ 2 + 2 * epsilon * v - 2 * v ^ 2) / 7 * S.
Proof.
  intro H. generalize (H (fun w => w ^ 3) (fun w => 3 * w ^ 2) (fun w => 6 * w) (fun _ => 6) 0 1 6). intro K. assert (Rabs (clamped (fun w => w ^ 3) 0 1 - 3 * 0 ^ 2) <= 6 / 7).
  - replace (6 / 7) with ((1 ^ 2 + 2 * 1 * 0 - 2 * 0 ^ 2) / 7 * 6) by field.
    apply K; try lra; intros; try (auto_derive; trivial; ring); [ring | rewrite Rabs_pos_eq; lra].
  - rewrite clamped_is, Rabs_pos_eq in H0 by lra. lra.
Qed.
(* Sine, rings and the first hump of ridges, against its slope upwards, are odd sines. *)
Lemma of_an_odd_sine (a k v epsilon : R) : Rabs a <= 1 -> 0 <= k -> 0 <= v < epsilon -> v + epsilon <= 1 ->
  Rabs (clamped (fun v => a * sin (PI * (k * v))) v epsilon - a * (PI * k * cos (PI * (k * v)))) <= (epsilon ^ 2 + 2 * epsilon * v - 2 * v ^ 2) / 6 * (PI * k) ^ 3.
Proof.
  intros A K V W. generalize PI_RGT_0. intro P. apply (clamped_difference_of_odd__of_any_height _ (fun v => a * (PI * k * cos (PI * (k * v)))) (fun v => - (a * ((PI * k) ^ 2 * sin (PI * (k * v)))))
    (fun v => - (a * ((PI * k) ^ 3 * cos (PI * (k * v)))))); trivial; intro w; try (auto_derive; trivial; ring).
  - replace (PI * (k * - w)) with (- (PI * (k * w))) by ring. rewrite sin_neg. ring.
  - intros _. rewrite Rabs_Ropp. replace (a * _) with ((PI * k) ^ 3 * (a * cos (PI * (k * w)))) by ring. apply at_most; [apply pow_le; nra | exact A | apply cosine_at_most_1].
Qed.
Theorem clamped_difference_of_odd__of_the_fields (u v k_u k_v epsilon : R) : 0 < k_v -> 0 <= v < epsilon -> v + epsilon <= 1 ->
  let bound k := (epsilon ^ 2 + 2 * epsilon * v - 2 * v ^ 2) / 6 * (PI * k) ^ 3 in
  Rabs (central_sine.h_v u v k_u k_v epsilon - gradient_sine.h_v u v k_u k_v) <= bound k_v /\
  Rabs (central_rings.h_v v k_v epsilon - gradient_rings.h_v v k_v) <= bound (2 * k_v) /\
  (k_v * (v + epsilon) <= 1 -> Rabs (central_ridges.h_v u v k_u k_v epsilon - Rabs (sin (PI * (k_u * u))) * (PI * k_v * cos (PI * (k_v * v)))) <= bound k_v).
Proof.
  intros K V W bound. destruct (clamped_difference__of_the_fields u v k_u k_v epsilon) as (A & B & C). rewrite A, B, C. unfold_fields.
  repeat split; [| | intro L].
  - replace (PI * cos (PI * (k_v * v)) * k_v * sin (PI * (k_u * u))) with (sin (PI * (k_u * u)) * (PI * k_v * cos (PI * (k_v * v)))) by ring. apply of_an_odd_sine; trivial; [apply sine_at_most_1 | lra].
  - generalize (of_an_odd_sine 1 (2 * k_v) v epsilon ltac:(rewrite Rabs_R1; lra) ltac:(lra) V W). rewrite !clamped_is by assumption. rewrite !Rmult_1_l. intro E. eapply Rle_trans; [|exact E].
    right. f_equal. f_equal. ring.
  - generalize (of_an_odd_sine (Rabs (sin (PI * (k_u * u)))) k_v v epsilon ltac:(rewrite Rabs_Rabsolu; apply sine_at_most_1) ltac:(lra) V W). rewrite !clamped_is by assumption.
    assert (F : forall w, 0 <= w -> k_v * w <= 1 -> Rabs (sin (PI * (k_u * u)) * sin (PI * (k_v * w))) = Rabs (sin (PI * (k_u * u))) * sin (PI * (k_v * w))).
    { intros w P Q. destruct (clamped_difference_of_odd__first_ridge k_u k_v u w) as (_ & _ & _ & E); try lra. rewrite E. replace (w * PI * k_v) with (PI * (k_v * w)) by ring. replace (u * PI * k_u) with (PI * (k_u * u)) by ring. ring. }
    rewrite (F (v + epsilon)), (F 0) by lra. trivial.
Qed.
(* The rule of creases has the slope 0 at the pole, from which ridges' difference is far. *)
Theorem clamped_difference_of_odd__of_the_fields__false : ~ forall u v k_u k_v epsilon, 0 < k_v -> 0 <= v < epsilon -> v + epsilon <= 1 -> k_v * (v + epsilon) <= 1 ->
  Rabs (central_ridges.h_v u v k_u k_v epsilon - gradient_ridges.h_v u v k_u k_v) <= (epsilon ^ 2 + 2 * epsilon * v - 2 * v ^ 2) / 6 * (PI * k_v) ^ 3.
Proof.
  intro H. generalize (H (1/2) 0 1 1 (1/2) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). rewrite (proj1 (proj2 (clamped_difference__of_the_fields (1/2) 0 1 1 (1/2)))), clamped_is by lra.
  unfold_fields. rewrite Rplus_0_l, sine_of_a_right_angle, !Rmult_0_r, sin_0, Rmult_0_r, sign_0, Rmult_1_l, Rabs_R0, Rabs_R1. rewrite Rabs_pos_eq by lra. apply Rlt_not_le. interval.
Qed.
