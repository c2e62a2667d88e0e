(* The truncation error of the forward and of the fourth-order difference. *)

From Coq Require Import Reals Lra ZArith.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Formulas Fields Derivatives Clamped Rounding.
Open Scope R_scope.

Lemma rises f f1 (a b : R) : derives_to f f1 -> a <= b -> (forall t, a <= t <= b -> 0 <= f1 t) -> f a <= f b.
Proof.
  intros D B P. destruct (mean_value f f1 a b D) as (c & C & E). rewrite Rmin_left, Rmax_right in C by exact B.
  assert (0 <= f1 c * (b - a)) by (apply Rmult_le_pos; [apply P, C | lra]). lra.
Qed.
(* Of what is 0 at 0. *)
Lemma not_below f f1 : derives_to f f1 -> f 0 = 0 -> (forall t, 0 <= t -> 0 <= f1 t) -> forall t, 0 <= t -> 0 <= f t.
Proof. intros D Z P t T. rewrite <- Z. apply (rises f f1); [exact D | exact T | intros w W; apply P; lra]. Qed.
Lemma both_signs x y : 0 <= y + 1 * x -> 0 <= y + -1 * x -> Rabs x <= y.
Proof. intros. apply Rabs_le. lra. Qed.
Lemma sign_and_size c x y : Rabs c = 1 -> Rabs x <= y -> 0 <= y + c * x.
Proof. intros C X. generalize (Rabs_maj2 (c * x)). rewrite Rabs_mult, C. lra. Qed.

Ltac differentiated D := auto_derive; [repeat split; eexists; apply D | rewrite ?(is_derive_unique _ _ _ (D _)); unfold Rminus; field].
(* Forward, s = 1, or backward, s = -1. *)
Definition forward (h : R -> R) (s x e : R) := s * (h (x + s * e) - h x) / e.
Theorem forward_and_fourth_order__forward (h h1 h2 : R -> R) (s x e S : R) : (forall w, is_derive h w (h1 w)) -> (forall w, is_derive h1 w (h2 w)) ->
  (forall w, Rabs (h2 w) <= S) ->
  s = 1 \/ s = -1 -> 0 < e -> Rabs (forward h s x e - h1 x) <= e / 2 * S.
Proof.
  intros D1 D2 B Z E. assert (A : Rabs s = 1) by (destruct Z as [-> | ->]; [apply Rabs_R1 | apply Rabs_m1]).
  assert (P : forall c, Rabs c = 1 -> 0 <= S * e ^ 2 / 2 + c * (s * (h (x + s * e) - h x) - e * h1 x)).
  { intros c C. refine (not_below (fun t => S * t ^ 2 / 2 + c * (s * (h (x + s * t) - h x) - t * h1 x)) (fun t => S * t + c * (h1 (x + s * t) - h1
    x)) _ _ _ e _); [| | | lra].
    - intro t. destruct Z as [-> | ->]; differentiated D1.
    - rewrite Rmult_0_r, Rplus_0_r. field.
    - intros t T. apply sign_and_size; [exact C|]. eapply Rle_trans; [apply (moved_by_at_most h1 h2 S); assumption|].
      replace (x + s * t - x) with (s * t) by ring. rewrite Rabs_mult, A, Rabs_pos_eq by exact T. right. ring. }
  replace (forward h s x e - h1 x) with ((s * (h (x + s * e) - h x) - e * h1 x) / e) by (unfold forward; field; lra). apply over_length; [exact E|].
  replace (e / 2 * S * e) with (S * e ^ 2 / 2) by field. apply both_signs; apply P; [apply Rabs_R1 | apply Rabs_m1].
Qed.
Definition fourth (h : R -> R) (x e : R) := 1 / 12 * (h (x - 2 * e) - h (2 * e + x) + 8 * (h (e + x) - h (x - e))) / e.
Theorem forward_and_fourth_order__fourth (h h1 h2 h3 h4 h5 : R -> R) (x e S : R) : (forall w, is_derive h w (h1 w)) ->
  (forall w, is_derive h1 w (h2 w)) -> (forall w, is_derive h2 w (h3 w)) ->
  (forall w, is_derive h3 w (h4 w)) -> (forall w, is_derive h4 w (h5 w)) -> (forall w, Rabs (h5 w) <= S) -> 0 < e ->
    Rabs (fourth h x e - h1 x) <= e ^ 4 / 30 * S.
Proof.
  intros D1 D2 D3 D4 D5 B E. set (off t := h (x - 2 * t) - h (2 * t + x) + 8 * (h (t + x) - h (x - t)) - 12 * t * h1 x).
  assert (P : forall c, Rabs c = 1 -> 0 <= 2 / 5 * S * e ^ 5 + c * off e).
  { intros c C. refine (not_below (fun t => 2 / 5 * S * t ^ 5 + c * off t)
      (fun t => 2 * S * t ^ 4 + c * (8 * (h1 (t + x) + h1 (x - t)) - 2 * (h1 (2 * t + x) + h1 (x - 2 * t)) - 12 * h1 x)) _ _ _ e _); [| | | lra].
    { intro t. unfold off. differentiated D1. }
    { unfold off. rewrite !Rmult_0_r, !Rplus_0_l, !Rminus_0_r. ring. }
    apply (not_below _ (fun t => 8 * S * t ^ 3 + c * (8 * (h2 (t + x) - h2 (x - t)) - 4 * (h2 (2 * t + x) - h2 (x - 2 * t))))).
    { intro t. differentiated D2. }
    { rewrite !Rmult_0_r, !Rplus_0_l, !Rminus_0_r. ring. }
    apply (not_below _ (fun t => 24 * S * t ^ 2 + c * (8 * (h3 (t + x) + h3 (x - t)) - 8 * (h3 (2 * t + x) + h3 (x - 2 * t))))).
    { intro t. differentiated D3. }
    { rewrite !Rmult_0_r, !Rplus_0_l, !Rminus_0_r. ring. }
    intros t T. generalize (rises (fun t => S * t ^ 2 + - c * (h3 (t + x) + h3 (x - t))) (fun t => S * (2 * t) + - c * (h4 (t + x) - h4 (x - t))) t
      (2 * t) ltac:(intro; differentiated D4) ltac:(lra)). intro H.
    assert (R : S * t ^ 2 + - c * (h3 (t + x) + h3 (x - t)) <= S * (2 * t) ^ 2 + - c * (h3 (2 * t + x) + h3 (x - 2 * t))); [|lra].
    apply H. intros w W. apply sign_and_size; [rewrite Rabs_Ropp; exact C|]. eapply Rle_trans; [apply (moved_by_at_most h4 h5 S); assumption|].
    replace (w + x - (x - w)) with (2 * w) by ring. rewrite Rabs_pos_eq by lra. lra. }
  replace (fourth h x e - h1 x) with (off e / (12 * e)) by (unfold fourth, off; field; lra). apply over_length; [lra|].
  replace (e ^ 4 / 30 * S * (12 * e)) with (2 / 5 * S * e ^ 5) by field. apply both_signs; apply P; [apply Rabs_R1 | apply Rabs_m1].
Qed.

(* Sine, ridges and rings *)
Lemma orders_of_a_sine f a k x e : Rabs a <= 1 -> 0 <= k -> (forall w, f w = sin (PI * (k * w)) * a) -> 0 < e -> let slope := PI * k * (cos (PI *
  (k * x)) * a) in (forall s, s = 1 \/ s = -1 -> Rabs (forward f s x e - slope) <= e / 2 * (PI * k) ^ 2) /\ Rabs (fourth f x e - slope) <= e ^ 4 /
  30 * (PI * k) ^ 5.
Proof.
  intros A K F E slope. assert (P : 0 <= PI * k) by (generalize PI_RGT_0; nra). set (w1 := PI * k) in *.
  assert (D1 : forall w, is_derive f w (w1 * (cos (PI * (k * w)) * a))) by (intro w; apply is_derive_ext with (fun w => sin (PI * (k * w)) * a);
    [intro; symmetry; apply F | unfold w1; auto_derive; trivial; ring]).
  assert (B : forall n c, Rabs c <= 1 -> Rabs (w1 ^ n * (c * a)) <= w1 ^ n) by (intros; apply at_most; [apply pow_le, P | assumption | exact A]).
  split; [intros s Z; apply (forward_and_fourth_order__forward f (fun w => w1 * (cos (PI * (k * w)) * a)) (fun w => w1 ^ 2 * (- sin (PI * (k * w)) *
    a))); try assumption |
    apply (forward_and_fourth_order__fourth f (fun w => w1 * (cos (PI * (k * w)) * a)) (fun w => w1 ^ 2 * (- sin (PI * (k * w)) * a)) (fun w => w1 ^
      3 * (- cos (PI * (k * w)) * a))
      (fun w => w1 ^ 4 * (sin (PI * (k * w)) * a)) (fun w => w1 ^ 5 * (cos (PI * (k * w)) * a))); try assumption];
  intro w; try (unfold w1; auto_derive; trivial; ring); apply B; rewrite ?Rabs_Ropp; first [apply sine_at_most_1 | apply cosine_at_most_1].
Qed.

(* False variants: constants that are a little smaller. *)
Theorem forward_and_fourth_order__forward__false : ~ forall h h1 h2 (s x e S : R), derives_to h h1 -> derives_to h1 h2 -> (forall w, Rabs (h2 w)
  <= S) -> s = 1 \/ s = -1 -> 0 < e -> Rabs (forward h s x e - h1 x) <= e / 3 * S.
Proof.
  intro H. generalize (H (fun w => w ^ 2) (fun w => 2 * w) (fun _ => 2) 1 0 1 2 ltac:(intro; auto_derive; trivial; ring) ltac:(intro; auto_derive;
    trivial; ring) ltac:(intro; rewrite Rabs_pos_eq; lra) (or_introl eq_refl) ltac:(lra)).
  unfold forward. rewrite Rabs_pos_eq; lra.
Qed.
Theorem forward_and_fourth_order__fourth__false : ~ forall h h1 h2 h3 h4 h5 (x e S : R), derives_to h h1 -> derives_to h1 h2 -> derives_to h2 h3
  -> derives_to h3 h4 -> derives_to h4 h5 -> (forall w, Rabs (h5 w) <= S) -> 0 < e -> Rabs (fourth h x e - h1 x) <= e ^ 4 / 31 * S.
Proof.
  intro H. generalize (H (fun w => w ^ 5) (fun w => 5 * w ^ 4) (fun w => 20 * w ^ 3) (fun w => 60 * w ^ 2) (fun w => 120 * w) (fun _ => 120) 0 1
    120). intro K.
  assert (L : Rabs (fourth (fun w => w ^ 5) 0 1 - 5 * 0 ^ 4) <= 1 ^ 4 / 31 * 120) by (apply K; try lra; intro; try (auto_derive; trivial; ring);
    rewrite Rabs_pos_eq; lra).
  unfold fourth in L. rewrite Rabs_left in L; lra.
Qed.
Lemma no_slope_of_0 (w : R) : is_derive (fun _ : R => 0) w 0.
Proof. auto_derive; trivial. Qed.
Ltac of_0 := repeat (split; [first [exact no_slope_of_0 | intro; rewrite Rabs_R0; lra | left; reflexivity]|]); lra.
Theorem forward_and_fourth_order__forward__point : exists h h1 h2 (s e S : R), derives_to h h1 /\ derives_to h1 h2 /\ (forall w, Rabs (h2 w) <= S)
  /\ (s = 1 \/ s = -1) /\ 0 < e.
Proof. do 3 exists (fun _ => 0). exists 1, 1, 0. of_0. Qed.
Theorem forward_and_fourth_order__fourth__point : exists h h1 h2 h3 h4 h5 (e S : R), derives_to h h1 /\ derives_to h1 h2 /\ derives_to h2 h3 /\
  derives_to h3 h4 /\ derives_to h4 h5 /\ (forall w, Rabs (h5 w) <= S) /\ 0 < e.
Proof. do 6 exists (fun _ => 0). exists 1, 0. of_0. Qed.
