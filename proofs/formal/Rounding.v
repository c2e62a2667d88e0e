(* The rounding error of the central difference. *)

From Coq Require Import Reals Lra Psatz Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Relative Plus_error Mult_error Pff2Flocq.
From Formal Require Import Preliminaries Formulas Float Float64 Claim Clamped.
From Formal Require Statements.
Open Scope R_scope.

(* What a size says, both ways. *)
Ltac both_ways H := apply Rabs_le_between in H.
(* What is left of a difference of two heights, each off, over the span s, times a factor. *)
Lemma of_two_heights (argument evaluation excess growth mean plus minus steepest s d : R) : s > 0 ->
  excess - (growth - 1) >= 0 -> excess + growth - 1 >= 0 -> argument * steepest + evaluation - plus >= 0 -> plus + argument * steepest + evaluation >= 0 ->
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
  red. intros. destruct (of_two_heights argument evaluation excess growth mean off_plus off_minus steepest (2 * epsilon) h_u) as (N & R); try assumption; [lra | | ].
  - unfold h_u, h_u_plus, h_u_minus. field. lra.
  - repeat split; try apply R; lra.
Qed.
Theorem roundoff_bound__in_v : Statements.roundoff_bound__in_v.
Proof.
  red. intros. assert (S : span_v = 2 * epsilon) by (unfold span_v; destruct both as [|[A|A]]; lra).
  destruct (of_two_heights argument evaluation excess growth mean off_plus off_minus steepest (2 * epsilon) h_v) as (N & R); try assumption; [lra | | ].
  - unfold h_v, h_v_plus, h_v_minus. rewrite S. field. lra.
  - repeat split; try apply R; lra.
Qed.
Theorem roundoff_bound__clamped : Statements.roundoff_bound__clamped.
Proof.
  red. intros. at_the_pole span_v.
  destruct (of_two_heights argument evaluation excess growth mean off_plus off_minus steepest (epsilon + v) h_v) as (N & R); try assumption.
  - unfold h_v, h_v_plus, h_v_minus. rewrite H12. field. lra.
  - rewrite (Rmult_comm mean (epsilon + v)). repeat split; try apply R; lra.
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

Lemma moved_by_at_most (h h1 : R -> R) (L a b : R) : (forall w, is_derive h w (h1 w)) -> (forall w, Rabs (h1 w) <= L) -> Rabs (h b - h a) <= L * Rabs (b - a).
Proof. intros D B. apply (bounded_variation h h1). intros t _. split; [apply D | apply B]. Qed.
(* So of any height with slopes of at most L: its samples off by at most eta, its arguments by at most alpha, and a factor in 1 +- kappa. *)
Theorem roundoff_bound__of_any_height (h h1 : R -> R) (L a b S kappa eta alpha a' b' h_a h_b t : R) :
  (forall w, is_derive h w (h1 w)) -> (forall w, Rabs (h1 w) <= L) -> 0 < S -> a - b = S -> Rabs (t - 1) <= kappa ->
  Rabs (a' - a) <= alpha -> Rabs (b' - b) <= alpha -> Rabs (h_a - h a') <= eta -> Rabs (h_b - h b') <= eta ->
  Rabs ((h_a - h_b) / S * t - (h a - h b) / S) <= 2 * (eta + L * alpha) / S * (1 + kappa) + L * kappa.
Proof.
  intros D B P AB T A1 A2 H1 H2. assert (L0 : 0 <= L) by (eapply Rle_trans; [apply Rabs_pos | apply (B 0)]).
  assert (E : forall x x' y, Rabs (x' - x) <= alpha -> Rabs (y - h x') <= eta -> - (alpha * L + eta) <= y - h x <= alpha * L + eta).
  { intros x x' y X Y. apply Rabs_le_between. replace (y - h x) with (y - h x' + (h x' - h x)) by ring. eapply Rle_trans; [apply Rabs_triang|].
    generalize (moved_by_at_most h h1 L x x' D B). nra. }
  generalize (E _ _ _ A1 H1) (E _ _ _ A2 H2) (moved_by_at_most h h1 L b a D B). rewrite AB, (Rabs_pos_eq S) by lra. intros E1 E2 M. both_ways M. both_ways T.
  assert (Q : (h a - h b) / S * S = h a - h b) by (field; lra). set (mean := (h a - h b) / S) in *.
  assert (M1 : L - mean >= 0) by (apply (over_a_span S _ (L * S - (h a - h b))); lra). assert (M2 : mean + L >= 0) by (apply (over_a_span S _ (L * S + (h a - h b))); lra).
  destruct (of_two_heights alpha eta kappa t mean (h_a - h a) (h_b - h b) L S ((h_a - h_b) / S)) as (_ & _ & _ & _ & _ & _ & _ & _ & _ & _ & X & Y); try lra; [unfold mean; field; lra|].
  replace (2 * (eta + L * alpha) / S * (1 + kappa) + L * kappa) with (kappa * L + (kappa + 1) * (2 * alpha * L + 2 * eta) / S) by (field; lra). apply Rabs_le. lra.
Qed.
Theorem roundoff_bound__of_any_height__false : ~ forall (h h1 : R -> R) (L a b S kappa t : R), (forall w, is_derive h w (h1 w)) -> (forall w, Rabs (h1 w) <= L) -> 0 < S -> a - b = S ->
  Rabs (t - 1) <= kappa -> Rabs ((h a - h b) / S * t - (h a - h b) / S) <= 0.
Proof.
  intro H. generalize (H (fun w => w) (fun _ => 1) 1 1 0 1 1 2 ltac:(intro; auto_derive; trivial) ltac:(intro; cbv beta; rewrite Rabs_R1; lra) ltac:(lra) ltac:(lra)).
  intro K. specialize (K ltac:(rewrite Rabs_pos_eq; lra)). rewrite Rabs_pos_eq in K; lra.
Qed.

(* Float64 *)

(* The standard model: an operation that does not underflow is exact but for a factor 1 + d, |d| <= 2^-53. *)
Lemma standard_model (x : R) : bpow radix2 (-1022) <= Rabs x -> exists d, Rabs d <= unit_roundoff /\ rounded x = x * (1 + d).
Proof. intro H. apply (relative_error_N_FLT_ex radix2 (-1074) 53); [easy | exact H]. Qed.

(* The difference of two float64 numbers needs no such condition. *)
Lemma rounded_difference (a b : R) : float64 a -> float64 b -> exists d, Rabs d <= unit_roundoff /\ rounded (a - b) = (a - b) * (1 + d).
Proof.
  intros A B. destruct (FLT_plus_error_N_ex radix2 (-1074) 53 (fun n => negb (Z.even n)) a (- b) A (generic_format_opp _ _ _ B)) as (d & D & E).
  exists d. split; [|exact E]. eapply Rle_trans; [exact D|]. change (u_ro radix2 53) with unit_roundoff.
  assert (P : 0 < unit_roundoff) by (unfold unit_roundoff; generalize (bpow_gt_0 radix2 (-53 + 1)); lra).
  apply Rmult_le_reg_r with (1 + unit_roundoff); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra.
Qed.

(* Dekker's product: the printed sum and its error are the product itself, where nothing underflows. *)
Theorem elementary_functions__two_product (a b : R) : float64 a -> float64 b -> a * b = 0 \/ bpow radix2 (-1074 + 2 * 53 - 1) <= Rabs (a * b) ->
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
  f_equal. f_equal. rewrite Rplus_comm. f_equal. f_equal. rewrite Rplus_comm. f_equal. f_equal. rewrite Rplus_comm. f_equal. f_equal. unfold two_product_float64.product. ring.
Qed.

Lemma float64_is_whole (x : R) : float64 x -> exists m : Z, x = IZR m * bpow radix2 (-1074).
Proof.
  intro F. apply FLT_format_generic in F; [|easy]. destruct F as [[m e] -> _ E]. cbn [Fnum Fexp] in *. exists (m * radix2 ^ (e + 1074))%Z.
  unfold F2R. cbn [Fnum Fexp]. rewrite mult_IZR, IZR_Zpower by lia. rewrite Rmult_assoc, <- bpow_plus. do 2 f_equal. lia.
Qed.
Lemma rounded_is_float64 (x : R) : float64 (rounded x).
Proof. apply generic_format_round; typeclasses eauto. Qed.
Lemma whole_is_float64 (n e : Z) : (Z.abs n < 2 ^ 53)%Z -> (-1074 <= e)%Z -> float64 (IZR n * bpow radix2 e).
Proof. intros N E. apply generic_format_FLT. exists (Float radix2 n e); [reflexivity | exact N | exact E]. Qed.
Lemma one_is_float64 : float64 1.
Proof. apply (generic_format_bpow radix2 (FLT_exp (-1074) 53) 0). easy. Qed.
Lemma kept (x : R) : float64 x -> rounded x = x.
Proof. intro F. apply round_generic; [typeclasses eauto | exact F]. Qed.
(* What is left of a float64 by multiples of a power of two, and is no larger than it, nor than that power, is exact. *)
Lemma part_is_float64 (x : R) (q k : Z) : float64 x -> (-1074 <= k)%Z -> Rabs (x - IZR q * bpow radix2 k) <= Rabs x -> Rabs (x - IZR q * bpow radix2 k) <= bpow radix2 k ->
  float64 (x - IZR q * bpow radix2 k).
Proof.
  intros F K S T. apply FLT_format_generic in F; [|easy]. destruct F as [[m e] E M L]. unfold F2R in E; cbn [Fnum Fexp] in *.
  assert (W : forall n j : Z, (-1074 <= j)%Z -> x - IZR q * bpow radix2 k = IZR n * bpow radix2 j -> Rabs (x - IZR q * bpow radix2 k) < bpow radix2 53 * bpow radix2 j -> float64 (x - IZR q * bpow radix2 k)).
  { intros n j J X B. rewrite X in *. apply whole_is_float64; [|exact J]. rewrite Rabs_mult, (Rabs_pos_eq (bpow _ j)) in B by apply bpow_ge_0.
    apply Rmult_lt_reg_r in B; [|apply bpow_gt_0]. rewrite <- abs_IZR in B. apply lt_IZR, B. }
  destruct (Z_le_gt_dec k e) as [N|N].
  - apply (W (m * 2 ^ (e - k) - q)%Z k K); [|generalize (bpow_gt_0 radix2 k); simpl (bpow radix2 53); lra].
    rewrite minus_IZR, mult_IZR, (IZR_Zpower radix2) by lia. rewrite Rmult_minus_distr_r, Rmult_assoc, <- bpow_plus, E. do 4 f_equal. lia.
  - apply (W (m - q * 2 ^ (k - e))%Z e L).
    + rewrite minus_IZR, mult_IZR, (IZR_Zpower radix2) by lia. rewrite Rmult_minus_distr_r, Rmult_assoc, <- bpow_plus, E. do 4 f_equal. lia.
    + eapply Rle_lt_trans; [exact S|]. rewrite E, Rabs_mult, (Rabs_pos_eq (bpow _ e)) by apply bpow_ge_0. apply Rmult_lt_compat_r; [apply bpow_gt_0|]. rewrite <- abs_IZR. apply IZR_lt, M.
Qed.
Theorem elementary_functions__two_product__false : ~ forall a b, float64 a -> float64 b -> two_product_float64.product a b + two_product_float64.product_error a b = a * b.
Proof.
  intro H. assert (F : float64 (bpow radix2 (-1074))) by (apply generic_format_bpow; easy). generalize (H _ _ F F).
  destruct (float64_is_whole (two_product_float64.product (bpow radix2 (-1074)) (bpow radix2 (-1074))) ltac:(apply rounded_is_float64)) as [m ->].
  destruct (float64_is_whole (two_product_float64.product_error (bpow radix2 (-1074)) (bpow radix2 (-1074))) ltac:(apply rounded_is_float64)) as [n ->].
  generalize (bpow_gt_0 radix2 (-1074)). intros B E. assert (S : bpow radix2 (-1074) < bpow radix2 0) by (apply bpow_lt; easy). change (bpow radix2 0) with 1 in S.
  set (b := bpow radix2 (-1074)) in *. assert (K : IZR (m + n) = b) by (rewrite plus_IZR; apply Rmult_eq_reg_r with b; lra).
  assert (0 < m + n < 1)%Z by (split; apply lt_IZR; lra). lia.
Qed.
