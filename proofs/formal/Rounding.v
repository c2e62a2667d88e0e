(* The rounding error of the central difference. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Relative Plus_error Mult_error Div_sqrt_error Pff2Flocq.
From Formal Require Import Preliminaries Formulas Float Float64 Claim Clamped RoundedHalfTurns.
From Formal Require Statements.
Open Scope R_scope.

(* What a size says, both ways. *)
(* What is left of a difference of two heights, each off, over the span s, times a factor. *)
Lemma of_two_heights (argument evaluation excess growth mean plus minus steepest s d : R) : s > 0 ->
  excess - (growth - 1) >= 0 -> excess + growth - 1 >= 0 -> argument * steepest + evaluation - plus >= 0 -> plus + argument * steepest +
    evaluation >= 0 ->
  argument * steepest + evaluation - minus >= 0 -> minus + argument * steepest + evaluation >= 0 -> steepest - mean >= 0 -> mean + steepest >= 0 ->
  d = mean + (plus - minus) / s ->
  let each := argument * steepest + evaluation in let most := excess * steepest + (excess + 1) * (2 * argument * steepest + 2 * evaluation) / s in
  s <> 0 /\ 2 * each - (plus - minus) >= 0 /\ plus - minus + 2 * each >= 0 /\
  (excess + 1) * 2 * each - growth * (plus - minus) >= 0 /\ growth * (plus - minus) + (excess + 1) * 2 * each >= 0 /\
  excess * steepest - mean * (growth - 1) >= 0 /\ excess * steepest + mean * (growth - 1) >= 0 /\
  s * (growth * d - mean) = growth * (plus - minus) + s * mean * (growth - 1) /\
  s * most - s * (growth * d - mean) >= 0 /\ s * most + s * (growth * d - mean) >= 0 /\ most - (growth * d - mean) >= 0 /\ most + growth * d - mean >= 0.
Proof.
  intros S K K' P P' M M' L L' -> each most. set (off := plus - minus) in *. fold each in P, P', M, M'.
  assert (A : 2 * each - off >= 0) by (unfold off, each in *; lra). assert (B : off + 2 * each >= 0) by (unfold off, each in *; lra).
  assert (C : (excess + 1) * 2 * each - growth * off >= 0) by nra. assert (D : growth * off + (excess + 1) * 2 * each >= 0) by nra.
  assert (F : excess * steepest - mean * (growth - 1) >= 0) by nra. assert (G : excess * steepest + mean * (growth - 1) >= 0) by nra.
  assert (E : s * (growth * (mean + off / s) - mean) = growth * off + s * mean * (growth - 1)) by (field; lra).
  assert (Q : s * most = s * (excess * steepest) + (excess + 1) * 2 * each) by (unfold most, each; field; lra).
  assert (X : s * most - s * (growth * (mean + off / s) - mean) >= 0) by (rewrite E, Q; nra).
  assert (Y : s * most + s * (growth * (mean + off / s) - mean) >= 0) by (rewrite E, Q; nra).
  repeat split; try assumption; [lra | revert X | revert Y]; apply (over_a_span s); (assumption || ring).
Qed.
Theorem roundoff_bound__in_u : Statements.roundoff_bound__in_u.
Proof.
  red. intros. destruct (of_two_heights argument evaluation excess growth mean off_plus off_minus steepest (2 * epsilon) h_u) as (N & R); try
    assumption; [lra | | ].
  - unfold h_u, h_u_plus, h_u_minus. field. lra.
  - repeat split; try apply R; lra.
Qed.
Theorem roundoff_bound__two_roundings : Statements.roundoff_bound__two_roundings.
Proof. claim. Qed.
Theorem roundoff_bound__three_roundings : Statements.roundoff_bound__three_roundings.
Proof.
  red. intros. assert (A : (unit + 1) ^ 2 - (first + 1) * (second + 1) >= 0) by nra. assert (B : (first + 1) * (second + 1) - (1 - unit) ^ 2 >= 0) by nra.
  assert (E : (unit ^ 2 + 3 * unit) / (1 - unit) * (1 - unit) = unit ^ 2 + 3 * unit) by (field; lra).
  assert (G : (1 + third) * growth >= (1 - unit) ^ 2) by lra. assert (G0 : growth >= 0) by (apply Rnot_gt_ge; intro; nra).
  assert (C : (unit ^ 2 + 3 * unit) / (1 - unit) * (1 - unit) - (1 - unit) * (growth - 1) >= 0) by (rewrite E; nra).
  assert (D : (unit ^ 2 + 3 * unit) / (1 - unit) * (1 - unit) + (1 - unit) * (growth - 1) >= 0) by (rewrite E; nra).
  repeat split; try assumption; [lra | revert C | revert D]; apply (over_a_span (1 - unit)); lra.
Qed.

Lemma over_length x e L : 0 < L -> Rabs x <= e * L -> Rabs (x / L) <= e.
Proof. intros P X. unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq L) by lra. apply Rmult_le_reg_r with L; [exact P|]. rewrite Rmult_assoc,
  Rinv_l, Rmult_1_r by lra. exact X. Qed.
Lemma moved_by_at_most h h1 (L a b : R) : derives_to h h1 -> (forall w, Rabs (h1 w) <= L) -> Rabs (h b - h a) <= L * Rabs (b - a).
Proof. intros D B. apply (bounded_variation h h1). intros t _. split; [apply D | apply B]. Qed.
(* What is 0 at 0 is at most L times its argument where its derivative is at most L. *)
Lemma at_most_times (g h : R -> R) (L a r : R) : g 0 = 0 -> (forall t, - a <= t <= a -> is_derive g t (h t) /\ Rabs (h t) <= L) -> - a <= r <= a ->
  Rabs (g r) <= L * Rabs r.
Proof.
  intros Z D B. replace (g r) with (g r - g 0) by (rewrite Z; ring). rewrite <- (Rminus_0_r r) at 2. apply (bounded_variation g h). intros t T. apply D.
  rewrite !Rminus_0_r in T. apply Rabs_le_between. apply Rabs_le in B. lra.
Qed.
(* So of any height with slopes of at most L: its samples off by at most eta, its arguments by at most alpha, and a factor in 1 +- kappa. *)
Theorem roundoff_bound__of_any_height (h h1 : R -> R) (L a b S kappa eta alpha a' b' h_a h_b t : R) :
  (forall w, is_derive h w (h1 w)) -> (forall w, Rabs (h1 w) <= L) -> 0 < S -> a - b = S -> Rabs (t - 1) <= kappa ->
  Rabs (a' - a) <= alpha -> Rabs (b' - b) <= alpha -> Rabs (h_a - h a') <= eta -> Rabs (h_b - h b') <= eta ->
  Rabs ((h_a - h_b) / S * t - (h a - h b) / S) <= 2 * (eta + L * alpha) / S * (1 + kappa) + L * kappa.
Proof.
  intros D B P AB T A1 A2 K1 K2. assert (E : forall x x' y, Rabs (x' - x) <= alpha -> Rabs (y - h x') <= eta -> Rabs (y - h x) <= eta + L * alpha).
  { intros x x' y X Y. apply through with (h x'); [exact Y|]. at_most_by (moved_by_at_most h h1 L x x' D B). apply Rmult_le_compat_l;
    [at_most_by Rabs_pos; apply (B 0) | exact X]. }
  pose proof E _ _ _ A1 K1 as E1. pose proof E _ _ _ A2 K2 as E2. both_ways E1. both_ways E2. replace (_ - _) with ((h_a - h a - (h_b - h b)) / S * t + (h
    a - h b) / S * (t - 1)) by (field; lra).
  at_most_by Rabs_triang. rewrite !Rabs_mult. apply Rplus_le_compat; factors; try apply over_length;
    try assumption.
  - replace (_ / S * S) with (2 * (eta + L * alpha)) by (field; lra). apply Rabs_le. lra.
  - both_ways T. apply Rabs_le. lra.
  - rewrite <- AB, <- (Rabs_pos_eq (a - b)) by lra. exact (moved_by_at_most h h1 L b a D B).
Qed.
Theorem roundoff_bound__of_any_height__false : ~ forall h h1 (L a b S kappa t : R), derives_to h h1 -> (forall w, Rabs (h1 w) <= L) -> 0 < S -> a
  - b = S -> Rabs (t - 1) <= kappa -> Rabs ((h a - h b) / S * t - (h a - h b) / S) <= 0.
Proof.
  intro H. generalize (H (fun w => w) (fun _ => 1) 1 1 0 1 1 2 ltac:(intro; auto_derive; trivial) ltac:(intro; cbv beta; rewrite Rabs_R1; lra)
    ltac:(lra) ltac:(lra)).
  intro K. specialize (K ltac:(rewrite Rabs_pos_eq; lra)). rewrite Rabs_pos_eq in K; lra.
Qed.

(* Float64 *)

(* The standard model: an operation that does not underflow is exact but for a factor 1 + d, |d| <= 2^-53. *)
Lemma standard_model x : bpow radix2 (-1022) <= Rabs x -> exists d, Rabs d <= unit_roundoff /\ rounded x = x * (1 + d).
Proof. intro H. apply (relative_error_N_FLT_ex radix2 (-1074) 53); [easy | exact H]. Qed.

(* The sum and the difference of two float64 numbers need no such condition. *)
Lemma rounded_sum a b : float64 a -> float64 b -> exists d, Rabs d <= / 2 ^ 53 /\ rounded (a + b) = (a + b) * (1 + d).
Proof.
  intros A B. destruct (FLT_plus_error_N_ex radix2 (-1074) 53 (fun n => negb (Z.even n)) a b A B) as (d & D & E). exists d. split; [|exact E].
    at_most_by D; unfold u_ro; simpl; lra.
Qed.
Lemma rounded_difference a b : float64 a -> float64 b -> exists d, Rabs d <= unit_roundoff /\ rounded (a - b) = (a - b) * (1 + d).
Proof. intros A B. destruct (rounded_sum a (- b) A (generic_format_opp _ _ _ B)) as (d & D & E). exists d. split; [unfold unit_roundoff; simpl; lra |
  exact E]. Qed.

(* Dekker's product: the printed sum and its error are the product itself, where nothing underflows. *)
Lemma elementary_two_product a b : float64 a -> float64 b -> a * b = 0 \/ bpow radix2 (-1074 + 2 * 53 - 1) <= Rabs (a * b) ->
  two_product_float64.product a b + two_product_float64.product_error a b = a * b.
Proof.
  intros A B U. etransitivity;
    [|symmetry; exact (proj1 (Dekker radix2 (-1074) 53 (fun n => negb (Z.even n)) ltac:(easy) ltac:(easy) a b A B (or_introl eq_refl)) U)].
  assert (C : bpow radix2 (53 - Z.div2 53) + 1 = 134217729) by (simpl; lra). rewrite C.
  change (round radix2 (FLT_exp (-1074) 53) (Znearest (fun n => negb (Z.even n)))) with rounded.
  assert (N : forall x, rounded (rounded (x - rounded (x * 134217729)) + rounded (x * 134217729)) =
    rounded (rounded (134217729 * x) - rounded (rounded (134217729 * x) - x))).
  { intro x. rewrite (Rmult_comm x). f_equal. rewrite <- (Ropp_involutive (rounded (x - _))), <- rounded_opp, Ropp_minus_distr. ring. }
  rewrite !N.
  two_product_float64.lines.
  f_equal. f_equal. rewrite Rplus_comm. f_equal. f_equal. rewrite Rplus_comm. f_equal. f_equal. rewrite Rplus_comm. f_equal. f_equal. unfold
    two_product_float64.product. ring.
Qed.

Lemma float64_is_whole x : float64 x -> exists m : Z, x = IZR m * bpow radix2 (-1074).
Proof. intro F. apply generic_format_FIX_FLT, FIX_format_generic in F. destruct F as [[m e] -> E]. exists m. rewrite <- E. reflexivity. Qed.
Lemma not_negative_rounded x : 0 <= x -> 0 <= rounded x.
Proof. intro P. rewrite <- rounded_0. apply round_le; [typeclasses eauto..| exact P]. Qed.
Lemma rounded_is_float64 x : float64 (rounded x).
Proof. apply generic_format_round; typeclasses eauto. Qed.
Lemma whole_is_float64 n e : (Z.abs n < 2 ^ 53)%Z -> (-1074 <= e)%Z -> float64 (IZR n * bpow radix2 e).
Proof. intros N E. apply generic_format_FLT. exists (Float radix2 n e); [reflexivity | exact N | exact E]. Qed.
Lemma one_is_float64 : float64 1.
Proof. apply (generic_format_bpow radix2 (FLT_exp (-1074) 53) 0). easy. Qed.
Lemma two_is_float64 : float64 2.
Proof. apply (generic_format_bpow radix2 (FLT_exp (-1074) 53) 1). easy. Qed.
Lemma kept x : float64 x -> rounded x = x.
Proof. intro F. apply round_generic; [typeclasses eauto | exact F]. Qed.
(* A float64's whole part is one, by any rule; and what is left of it by the nearest multiple of another. *)
Lemma whole_part_is_float64 part x : Valid_rnd part -> float64 x -> float64 (IZR (part x)).
Proof. intros V F. rewrite <- round_FIX_IZR. apply generic_round_generic; [typeclasses eauto..| exact F]. Qed.
Lemma what_is_left_is_float64 x y : float64 x -> float64 y -> float64 (x - rint (x / y) * y).
Proof. apply format_REM_N; typeclasses eauto. Qed.
