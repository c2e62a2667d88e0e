(* The difference that is clamped at the pole v = 0. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Camera Preliminaries Formulas Fields Claim Derivatives.
From Formal Require Statements.
Open Scope R_scope.

Lemma over_a_span s x y : 0 < s -> y = s * x -> y >= 0 -> x >= 0.
Proof. intros S -> Y. nra. Qed.

Theorem clamped_difference__clamp : Statements.clamped_difference__clamp.
Proof. red. intros. lines. rewrite Rmin_right, Rmax_right by lra. destruct both; lra. Qed.
Theorem clamped_difference__at_the_pole_itself : Statements.clamped_difference__at_the_pole_itself.
Proof. claim. Qed.

Definition derives_to (f f1 : R -> R) := forall w, is_derive f w (f1 w).
(* The mean value theorem, for b on either side of a. *)
Lemma mean_value f f1 (a b : R) : derives_to f f1 -> exists c, Rmin a b <= c <= Rmax a b /\ f b - f a = f1 c * (b - a).
Proof. intro D. apply MVT_gen; intros x _; auto. apply continuity_pt_filterlim, (ex_derive_continuous f). exists (f1 x). apply D. Qed.
(* The derivative of an expression in a function whose derivative is at hand. *)
Ltac derives D := auto_derive; [repeat split; eexists; apply D | rewrite ?(is_derive_unique _ _ _ (D _)); field].
Lemma times_its_sign w : w * sign w = Rabs w.
Proof. destruct (Rtotal_order w 0) as [L|[->|L]]; [rewrite sign_eq_m1, Rabs_left by lra | rewrite Rabs_R0 | rewrite sign_eq_1, Rabs_pos_eq by lra];
  ring. Qed.
Lemma slope_of_half_square (v w : R) : is_derive (fun w => (w - v) * Rabs (w - v) / 2) w (Rabs (w - v)).
Proof.
  destruct (Req_dec w v) as [->|N].
  - rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. apply is_derive_Reals. intros e E. exists (mkposreal e E). intros t T B. simpl in B.
    replace (v + t - v) with t by ring. replace (v - v) with 0 by ring. replace (_ - 0) with (Rabs t / 2) by (field; exact T).
    generalize (Rabs_pos t). intro. rewrite Rabs_pos_eq; lra.
  - auto_derive; [lra|]. fold (w - v). rewrite <- times_its_sign. field.
Qed.

(* The printed lines' difference of any height, *)
Definition clamped (h : R -> R) (v epsilon : R) := (h (central_sine.v_plus v epsilon) - h (central_sine.v_minus v epsilon)) / central_sine.span_v
  v epsilon.
Lemma clamped_is h v epsilon : 0 <= v < epsilon -> v + epsilon <= 1 -> clamped h v epsilon = (h (v + epsilon) - h 0) / (v + epsilon).
Proof.
  intros. destruct (clamped_difference__clamp epsilon v) as (A & B & C); try lra. unfold clamped. rewrite Rplus_comm.
  change (central_sine.v_plus v epsilon = epsilon + v) in A. change (central_sine.v_minus v epsilon = 0) in B. change (central_sine.span_v v epsilon
    = epsilon + v) in C.
  rewrite A, B, C. reflexivity.
Qed.
(* those of the book among them. *)
Theorem clamped_difference__of_the_fields u v k_u k_v epsilon : central_sine.h_v u v k_u k_v epsilon = clamped (fun v => height_sine.h u v k_u
  k_v) v epsilon /\ central_ridges.h_v u v k_u k_v epsilon = clamped (fun v => height_ridges.h u v k_u k_v) v epsilon /\ central_rings.h_v v k_v
  epsilon = clamped (fun v => height_rings.h v k_v) v epsilon.
Proof. easy. Qed.
Theorem clamped_difference__of_the_fields__false : ~ forall v k_v epsilon, 0 < epsilon -> central_rings.h_v v k_v epsilon = clamped (fun v =>
  height_ridges.h (1/2) v 1 k_v) v epsilon.
Proof.
  intro H. generalize (H 0 1 (1/2) ltac:(lra)). rewrite (proj2 (proj2 (clamped_difference__of_the_fields 0 0 0 1 _))), !clamped_is by lra.
    unfold_fields.
  replace (_ * _) with PI by field. replace (_ + _) with (1/2) by ring. rewrite half_sine, !Rmult_0_r, sin_0, sin_PI, Rmult_1_l, Rmult_0_r, Rabs_R1,
    Rabs_R0. lra.
Qed.

(* Whatever h, if its slope moves by at most S over each unit of length of the step, as it does where |h''| <= S. *)
Theorem clamped_difference__of_any_height (h h1 : R -> R) (v epsilon S : R) : (forall w, is_derive h w (h1 w)) -> 0 <= v < epsilon -> v + epsilon <= 1 ->
  (forall w x, 0 <= w <= v + epsilon -> 0 <= x <= v + epsilon -> Rabs (h1 w - h1 x) <= S * Rabs (w - x)) ->
  Rabs (clamped h v epsilon - h1 v) <= (epsilon ^ 2 + v ^ 2) / (2 * (epsilon + v)) * S.
Proof.
  intros D V W B. rewrite clamped_is by assumption. set (a := v + epsilon) in *.
  assert (A : forall c, Rabs c = 1 -> 0 <= S * (epsilon ^ 2 + v ^ 2) / 2 + c * (h a - h 0 - a * h1 v)).
  { intros c C. destruct (mean_value (fun w => S * ((w - v) * Rabs (w - v) / 2) + c * (h w - w * h1 v)) (fun w => S * Rabs (w - v) + c * (h1 w - h1
    v)) 0 a) as (w & R & E).
    - intro w. apply (is_derive_plus _ (fun w => c * _)); [apply is_derive_scal, slope_of_half_square | derives D].
    - unfold a in *. rewrite Rmin_left, Rmax_right in R by lra. rewrite Rabs_pos_eq, (Rabs_left1 (0 - v)) in E by lra.
      generalize (B w v ltac:(lra) ltac:(lra)) (Rabs_maj2 (c * (h1 w - h1 v))). rewrite Rabs_mult, C. intros. assert (0 <= (S * Rabs (w - v) + c *
        (h1 w - h1 v)) * (v + epsilon - 0)) by (apply Rmult_le_pos; lra). lra. }
  generalize (A 1 Rabs_R1) (A (-1) Rabs_m1). intros. assert (0 < a) by (unfold a; lra). replace (_ * _) with (S * (epsilon ^ 2 + v ^ 2) / 2 / a) by
    (unfold a; field; lra).
  apply Rabs_le. split; apply Rmult_le_reg_r with a; field_simplify; lra.
Qed.
(* No smaller factor will do: h(w) = (w - v)|w - v|/2, whose derivative |w - v| is 1-Lipschitz, attains it. *)
Theorem clamped_difference__attained (v epsilon : R) : 0 <= v < epsilon -> v + epsilon <= 1 -> let h w := (w - v) * Rabs (w - v) / 2 in
  (forall w, is_derive h w (Rabs (w - v))) /\ (forall w x, Rabs (Rabs (w - v) - Rabs (x - v)) <= 1 * Rabs (w - x)) /\
  clamped h v epsilon - Rabs (v - v) = (epsilon ^ 2 + v ^ 2) / (2 * (epsilon + v)) * 1.
Proof.
  split; [apply slope_of_half_square | split].
  - intros w x. rewrite Rmult_1_l. replace (w - x) with (w - v - (x - v)) by ring. apply Rabs_triang_inv2.
  - rewrite clamped_is by assumption. replace (0 - v) with (- v) by ring. replace (v - v) with 0 by ring.
    rewrite Rabs_Ropp, !Rabs_pos_eq by lra. field. lra.
Qed.
Theorem clamped_difference__attained__false : ~ forall v epsilon, 0 <= v < epsilon -> v + epsilon <= 1 ->
  clamped (fun w => (w - v) * Rabs (w - v) / 2) v epsilon - Rabs (v - v) = 0.
Proof. intro H. generalize (H 0 1 ltac:(lra) ltac:(lra)) (proj2 (proj2 (clamped_difference__attained 0 1 ltac:(lra) ltac:(lra)))). cbv beta zeta.
  lra. Qed.
Theorem clamped_difference__of_any_height__false : ~ forall h h1 (v epsilon S : R), derives_to h h1 -> 0 <= v < epsilon -> v + epsilon <= 1 ->
  (forall w x, Rabs (h1 w - h1 x) <= S * Rabs (w - x)) -> Rabs (clamped h v epsilon - h1 v) <= (epsilon ^ 2 + v ^ 2) / (3 * (epsilon + v)) * S.
Proof.
  intro H. destruct (clamped_difference__attained 0 1 ltac:(lra) ltac:(lra)) as (D & L & E). generalize (H _ _ 0 1 1 D ltac:(lra) ltac:(lra) L).
  rewrite Rabs_pos_eq; lra.
Qed.

(* Where the field is odd *)

Theorem clamped_difference_of_odd__odd : Statements.clamped_difference_of_odd__odd.
Proof.
  red. intros. unfold h_sine, h_rings, h_ridge. replace (PI * (k_v * - v)) with (- (PI * (k_v * v))) by ring. replace (PI * (2 * -1 * k_v * v)) with
    (- (PI * (2 * k_v * v))) by ring.
  replace (- v * PI * k_v) with (- (v * PI * k_v)) by ring. rewrite !sin_neg. lra.
Qed.
Lemma sine_on_a_hump x : 0 <= x <= 1 -> 0 <= sin (PI * x).
Proof. intro. generalize PI_RGT_0. intro. apply sin_ge_0; nra. Qed.
Theorem clamped_difference_of_odd__first_ridge : Statements.clamped_difference_of_odd__first_ridge.
Proof.
  intros k_u k_v u v K V L. generalize (sine_on_a_hump (k_v * v) ltac:(nra)) (Rabs_pos (sin (u * PI * k_u))).
  printed_angles. intros S U.
  rewrite Rabs_mult, (Rabs_pos_eq _ S). nra.
Qed.
Theorem clamped_difference_of_odd__second_order_sharp : Statements.clamped_difference_of_odd__second_order_sharp.
Proof. claim. Qed.

Section odd.
Variables f0 f1 f2 f3 : R -> R.
Hypotheses (D1 : derives_to f0 f1) (D2 : derives_to f1 f2) (D3 : derives_to f2 f3).
(* A function with f0(0) = f''(0) = 0 whose third derivative is not negative up to a has a f'(v) <= f0(a) for v <= a/2. *)
Lemma middle_slope a v : 0 <= v <= a / 2 -> f0 0 = 0 -> f2 0 = 0 -> (forall w, 0 <= w <= a -> 0 <= f3 w) -> a * f1 v <= f0 a.
Proof.
  intros V Z Z2 P. destruct (mean_value f2 f3 0 v D3) as (b & B & E). rewrite Rmin_left, Rmax_right in B by lra. pose proof P b ltac:(lra) as F.
  destruct (mean_value (fun t => f0 t - t * f1 v - f2 v * ((t - v) ^ 2 / 2)) (fun t => f1 t - f1 v - f2 v * (t - v)) 0 a) as (t & T & G); [intro;
    derives D1|].
  destruct (mean_value f1 f2 v t D2) as (c & C & H). destruct (mean_value f2 f3 v c D3) as (w & W & I). rewrite Rmin_left, Rmax_right in T by lra.
  assert (0 <= f3 w * ((c - v) * (t - v))) by (unfold Rmin, Rmax in *; repeat destruct Rle_dec; apply Rmult_le_pos; first [apply P; lra | nra]).
  assert (0 <= f2 v * (a * (a - 2 * v))) by (repeat apply Rmult_le_pos; nra). assert (0 <= f3 w * ((c - v) * (t - v)) * a) by (apply Rmult_le_pos;
    lra).
  replace (f1 t - f1 v - f2 v * (t - v)) with (f3 w * ((c - v) * (t - v))) in G by (rewrite H; transitivity ((f2 c - f2 v) * (t - v)); [rewrite I|];
    ring). lra.
Qed.
End odd.
(* The derivative of an odd function is even, and the other way round. *)
Lemma mirrored g g1 (s : R) : derives_to g g1 -> (forall w, g (- w) = s * g w) -> forall w, g1 (- w) = - s * g1 w.
Proof.
  intros D E w. assert (A : is_derive (fun t => g (- t)) w (- g1 (- w))) by derives D. apply is_derive_unique in A. rewrite (Derive_ext _ _ _ E),
    Derive_scal, (is_derive_unique _ _ _ (D w)) in A. lra.
Qed.

(* The clamp costs no order where h is odd about v = 0. *)
Theorem clamped_difference_of_odd__of_any_height (h h1 h2 h3 : R -> R) (v epsilon S : R) :
  (forall w, is_derive h w (h1 w)) -> (forall w, is_derive h1 w (h2 w)) -> (forall w, is_derive h2 w (h3 w)) ->
  (forall w, h (- w) = - h w) -> 0 <= v < epsilon -> v + epsilon <= 1 -> (forall w, 0 <= w <= v + epsilon -> Rabs (h3 w) <= S) ->
  Rabs (clamped h v epsilon - h1 v) <= (epsilon ^ 2 + 2 * epsilon * v - 2 * v ^ 2) / 6 * S.
Proof.
  intros D1 D2 D3 O V Top B. rewrite clamped_is by assumption.
  assert (Z : h 0 = 0) by (generalize (O 0); rewrite Ropp_0; lra).
  assert (Z2 : h2 0 = 0) by (generalize (mirrored h1 h2 (- (-1)) D2 (mirrored h h1 (-1) D1 ltac:(intro; rewrite O; ring)) 0); rewrite Ropp_0; lra).
  assert (A : forall c, Rabs c = 1 -> (v + epsilon) * (S * (v ^ 2 / 2) + c * h1 v) <= S * ((v + epsilon) ^ 3 / 6) + c * h (v + epsilon)).
  { intros c C.
    apply (middle_slope (fun w => S * (w ^ 3 / 6) + c * h w) (fun w => S * (w ^ 2 / 2) + c * h1 w) (fun w => S * w + c * h2 w) (fun w => S + c * h3
      w)); try lra.
    - intro. derives D1.
    - intro. derives D2.
    - intro. derives D3.
    - rewrite Z. field.
    - rewrite Z2. ring.
    - intros w W. generalize (B w). rewrite <- (Rmult_1_l (Rabs (h3 w))), <- C, <- Rabs_mult. generalize (Rabs_maj2 (c * h3 w)). lra. }
  generalize (A 1 Rabs_R1) (A _ Rabs_m1). rewrite Z, Rminus_0_r. intros L U.
  set (a := v + epsilon) in *. assert (0 < a) by (unfold a; lra). set (q := h a / a). assert (Q : h a = q * a) by (unfold q; field; lra).
  replace (_ * _) with (S * (a ^ 2 / 6) - S * (v ^ 2 / 2)) by (unfold a; field).
  apply Rabs_le. nra.
Qed.
Theorem clamped_difference_of_odd__of_any_height__false : ~ forall h h1 h2 h3 (v epsilon S : R), derives_to h h1 -> derives_to h1 h2 -> derives_to
  h2 h3 -> (forall w, h (- w) = - h w) -> 0 <= v < epsilon -> v + epsilon <= 1 -> (forall w, Rabs (h3 w) <= S) -> Rabs (clamped h v epsilon - h1
  v) <= (epsilon ^ 2 + 2 * epsilon * v - 2 * v ^ 2) / 7 * S.
Proof.
  intro H. generalize (H (fun w => w ^ 3) (fun w => 3 * w ^ 2) (fun w => 6 * w) (fun _ => 6) 0 1 6). intro K. assert (B : Rabs (clamped (fun w => w ^
    3) 0 1 - 3 * 0 ^ 2) <= 6 / 7).
  - replace (6 / 7) with ((1 ^ 2 + 2 * 1 * 0 - 2 * 0 ^ 2) / 7 * 6) by field.
    apply K; try lra; try red; intros; try (auto_derive; trivial; ring); [ring | rewrite Rabs_pos_eq; lra].
  - rewrite clamped_is, Rabs_pos_eq in B by lra. lra.
Qed.
(* Sine, rings and the first hump of ridges, against its slope upwards, are odd sines. *)
Lemma of_an_odd_sine a k v epsilon slope f : Rabs a <= 1 -> 0 <= k -> 0 <= v < epsilon -> v + epsilon <= 1 -> (forall w, 0 <= w <= v + epsilon ->
  f w = a * sin (PI * (k * w))) -> slope = a * (PI * k * cos (PI * (k * v))) -> Rabs (clamped f v epsilon - slope) <= (epsilon ^ 2 + 2 * epsilon *
  v - 2 * v ^ 2) / 6 * (PI * k) ^ 3.
Proof.
  intros A K V W F ->. generalize PI_RGT_0. intro P. rewrite clamped_is, !F, <- (clamped_is (fun v => a * sin (PI * (k * v)))) by lra.
  apply (clamped_difference_of_odd__of_any_height _ (fun v => a * (PI * k * cos (PI * (k * v)))) (fun v => - (a * ((PI * k) ^ 2 * sin (PI * (k *
    v))))) (fun v => - (a * ((PI * k) ^ 3 * cos (PI * (k * v)))))); trivial; intro w; try (auto_derive; trivial; ring).
  - rewrite !Ropp_mult_distr_r_reverse, sin_neg. ring.
  - intros _. rewrite Rabs_Ropp. replace (a * _) with ((PI * k) ^ 3 * (a * cos (PI * (k * w)))) by ring. apply at_most; [apply pow_le; nra | lra |
    apply cosine_at_most_1].
Qed.
Theorem clamped_difference_of_odd__of_the_fields u v k_u k_v epsilon : 0 < k_v -> 0 <= v < epsilon -> v + epsilon <= 1 -> let bound k := (epsilon
  ^ 2 + 2 * epsilon * v - 2 * v ^ 2) / 6 * (PI * k) ^ 3 in Rabs (central_sine.h_v u v k_u k_v epsilon - gradient_sine.h_v u v k_u k_v) <= bound
  k_v /\ Rabs (central_rings.h_v v k_v epsilon - gradient_rings.h_v v k_v) <= bound (2 * k_v) /\ (k_v * (v + epsilon) <= 1 -> Rabs
  (central_ridges.h_v u v k_u k_v epsilon - Rabs (sin (PI * (k_u * u))) * (PI * k_v * cos (PI * (k_v * v)))) <= bound k_v).
Proof.
  destruct (clamped_difference__of_the_fields u v k_u k_v epsilon) as (A & B & C). rewrite A, B, C. unfold_fields.
  repeat split; [| | intro]; [apply of_an_odd_sine with (sin (PI * (k_u * u))) | apply of_an_odd_sine with 1 | apply of_an_odd_sine with (Rabs (sin
    (PI * (k_u * u))))]; rewrite ?Rabs_Rabsolu, ?Rabs_R1; try apply sine_at_most_1; try lra; intros; try (rewrite Rabs_mult, (Rabs_pos_eq (sin (PI *
      (k_v * w)))) by (apply sine_on_a_hump; nra)); ring.
Qed.
(* The rule of creases has the slope 0 at the pole, from which ridges' difference is far. *)
Theorem clamped_difference_of_odd__of_the_fields__false : ~ forall u v k_u k_v epsilon, 0 < k_v -> 0 <= v < epsilon -> v + epsilon <= 1 -> k_v * (v +
  epsilon) <= 1 ->
  Rabs (central_ridges.h_v u v k_u k_v epsilon - gradient_ridges.h_v u v k_u k_v) <= (epsilon ^ 2 + 2 * epsilon * v - 2 * v ^ 2) / 6 * (PI * k_v) ^ 3.
Proof.
  intro H. generalize (H (1/2) 0 1 1 (1/2) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). rewrite (proj1 (proj2 (clamped_difference__of_the_fields _ 0
    1 1 (1/2)))), clamped_is by lra.
  unfold_fields. rewrite Rplus_0_l, half_sine, !Rmult_0_r, sin_0, Rmult_0_r, sign_0, Rmult_1_l, Rabs_R0, Rabs_R1. apply Rlt_not_le. interval.
Qed.
