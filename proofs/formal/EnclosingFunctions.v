(* The rules of the enclosing machine for the elementary functions: what moves their arguments, and their own errors. *)

From Coq Require Import Reals Lra ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Float Float64 RoundedHalfTurns Rounding RoundedGradient RoundedRelative RoundedExponential EnclosingRules EnclosingBounds.
Open Scope R_scope.

(* Sine and cosine of half-turns: the slope is at most pi, and they move by 2 at most. *)
Section half_turns.
Variables (wave wave_slope : R -> R) (computed_wave : R).
Hypothesis wave_derivative : forall x, is_derive wave x (wave_slope x).
Hypothesis wave_steep : forall x, -1 <= wave_slope x <= 1.
Hypothesis wave_range : forall x, -1 <= wave x <= 1.
Lemma half_turns_rule s x ex x' y ey y' : 1 <= s -> s <= 1 + 3 / 2 ^ 22 -> float64 y -> 0 <= ex -> Rabs (x - x') <= s * (ex / 2 ^ 53) -> 0 <= ey
  -> Rabs (y - y') <= s * (ey / 2 ^ 53) -> ex <= 2 ^ 60 -> near_relative (19/4) computed_wave (wave (PI * (x * y))) -> let moved := rounded
  (7074237752028453 / 2251799813685248 * rounded (ROUNDING * rounded (rounded (Rabs x * ey) + rounded (rounded (Rabs y + rounded (ROUNDING * ey))
  * ex)))) in let c := rounded (9007199254740992 * rounded (rounded ((if Rlt_dec moved 2 then moved else 2) + rounded (rounded (5674535530486825 /
  10141204801825835211973625643008 * Rabs computed_wave) + least)) * SLACK)) in float64 c /\ 0 <= c /\ Rabs (computed_wave - wave (PI * (x' *
  y'))) <= s * (1 + 1 / 2 ^ 49) * (c / 2 ^ 53).
Proof.
  intros S1 S2 Y Px Dx Py Dy L Near moved. destruct (product_moved s x ex x' y ey y') as [M0 M]; try assumption. unfold moved. set (m := rounded
    (rounded (_ * ey) + _)) in *.
  destruct (bound_of s m S1 S2 M0) as [B _]. pose proof proj1 underflow_in_least as T.
  counts b (ROUNDING * m). set (h := 7074237752028453 / 2251799813685248) in *. assert (0 <= h) by (unfold h; lra). counts t (h * b).
  assert (Q : PI <= h * (1 - 2 * unit53)) by (unfold h, unit53; interval with (i_prec 100)).
  assert (D : Rabs (wave (PI * (x * y)) - wave (PI * (x' * y'))) <= t + 2 ^ 12 * underflow).
  { eapply Rle_trans; [exact (moved_by_at_most wave wave_slope 1 _ _ wave_derivative (fun x => Rabs_le _ _ (wave_steep x)))|]. rewrite <-
    Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq PI), Rmult_1_l by (generalize PI_RGT_0; lra).
    apply Rle_trans with (h * (1 - 2 * unit53) * (b + 2 ^ 10 * underflow)); [|unfold h in *; in_units].
    apply Rmult_le_compat; [generalize PI_RGT_0; lra | apply Rabs_pos | exact Q |]. in_units. }
  apply moved_and_own with (wave (PI * (x * y))); [exact S1 | lra | destruct Rlt_dec; [is_float64 | exact two_is_float64] | destruct Rlt_dec; lra | |].
  - at_most_by Near. generalize (Rabs_pos (wave (PI * (x * y)))). unfold underflow in *. lra.
  - destruct Rlt_dec; [lra|]. generalize (wave_range (PI * (x * y))) (wave_range (PI * (x' * y'))). intros. apply Rabs_le. lra.
Qed.
End half_turns.
Ltac of_half_turns f g part := red; intros; eapply (half_turns_rule f g); try eassumption; [| | | eapply part; apply
  elementary_functions__of_product_relative; try assumption; apply not_tiny; assumption].
Theorem enclosing_rules__sine : Statements.enclosing_rules__sine.
Proof. of_half_turns sin cos @proj1. exact is_derive_sin. exact COS_bound. exact SIN_bound. Qed.
Theorem enclosing_rules__cosine : Statements.enclosing_rules__cosine.
Proof. of_half_turns cos (fun x => - sin x) @proj2. exact is_derive_cos. intro t. generalize (SIN_bound t). lra. exact COS_bound. Qed.

(* A function that rises or falls lies between its values at the ends of what its argument can be. *)
Lemma reached s x e : 1 <= s -> s <= 1 + 3 / 2 ^ 22 -> 0 <= e -> let reach := rounded (rounded (rounded (ROUNDING * e) + rounded (1 /
  4503599627370496 * Rabs x)) * SLACK) in (forall x', Rabs (x - x') <= s * (e / 2 ^ 53) -> rounded (x - reach) + Rabs x / 2 ^ 54 - 32 * underflow
  <= x' <= rounded (x + reach) - Rabs x / 2 ^ 54 + 32 * underflow) /\ 0 <= reach <= ROUNDING * e * (1 + 2 ^ 6 * unit53) + 2 ^ 7 * unit53 * Rabs x
  + 32 * underflow.
Proof.
  intros S1 S2 E. destruct (bound_of s e S1 S2 E) as [_ B]. pose proof proj1 underflow_in_least as T. pose proof Rabs_pos x as A. cbv zeta. counts b
    (ROUNDING * e). counts h (1 / 4503599627370496 * Rabs x). rounds q (b + h). counts r (q * SLACK).
  pose proof rounding_error (x - r) as L. pose proof rounding_error (x + r) as U. pose proof Rabs_triang x (- r) as Sl. pose proof Rabs_triang x r as Sh.
    rewrite Rabs_Ropp in Sl. rewrite (Rabs_pos_eq r) in Sl, Sh by assumption. change (x + - r) with (x - r) in Sl.
  both_ways L. both_ways U. clearbody b h q r. split; [intros x' D; both_ways D|]; in_units.
Qed.
Lemma furthest_of a b : float64 a -> float64 b -> 0 <= a -> let first := if Rlt_dec 0 a then a else 0 in let furthest := if Rlt_dec first b then b
  else first in float64 furthest /\ a <= furthest /\ b <= furthest.
Proof. intros A B P. cbv zeta. destruct (Rlt_dec 0 a); destruct Rlt_dec; (split; [assumption || apply generic_format_0 | split; lra]). Qed.
Lemma monotone_rule s f e1 e2 t1 t2 y k V : 1 <= s -> float64 f -> float64 e1 -> float64 e2 -> float64 V -> 0 <= V -> 0 <= k <= 16 * unit53 -> t1
  <= y <= t2 -> Rabs (e1 - t1) + 2 ^ 4 * underflow <= 9/8 * (k * Rabs e1) + 1/2 * (k * Rabs f) + V -> Rabs (e2 - t2) + 2 ^ 4 * underflow <= 9/8 *
  (k * Rabs e2) + 1/2 * (k * Rabs f) + V -> let own e := rounded (rounded (k * Rabs e) + V) in let away e := rounded (Rabs (rounded (e - f)) + own
  e) in let first := if Rlt_dec 0 (away e1) then away e1 else 0 in let furthest := if Rlt_dec first (away e2) then away e2 else first in let c :=
  rounded (9007199254740992 * rounded (rounded (furthest + own f) * SLACK)) in float64 c /\ 0 <= c /\ Rabs (f - y) <= s * (1 + 1 / 2 ^ 49) * (c /
  2 ^ 53).
Proof.
  intros S F E1 E2 Fv Pv K Y T1 T2 own away. pose proof proj1 underflow_in_least as T.
  assert (W : forall e t, float64 e -> Rabs (e - t) + 2 ^ 4 * underflow <= 9/8 * (k * Rabs e) + 1/2 * (k * Rabs f) + V -> float64 (away e) /\ 0 <=
    away e /\ Rabs (f - t) + 8 * underflow <= (away e + (k * Rabs f + V) * (1 - 3 * unit53)) * (1 + 10 * unit53)).
  { intros e t E D. destruct (own_error k V e Fv ltac:(lra) ltac:(lra)) as (Fo & Po & Co). fold (own e) in Fo, Po, Co. pose proof
    own_rounding_of_sum e (- f) E (generic_format_opp _ _ _ F) as O. change (e + - f) with (e - f) in O. unfold away. set (d := rounded (e - f))
    in *.
    counts a (Rabs d + own e). is_count.
    pose proof Rabs_triang_inv (e - f) d as M1. rewrite Rabs_minus_sym in O. pose proof Rabs_triang (f - e) (e - t) as M2. replace (f - e + (e - t)) with
      (f - t) in M2 by ring. rewrite (Rabs_minus_sym f e) in M2. pose proof Rabs_triang_inv e f as M3.
    multiplied (Rabs (e - f)) (proj2 K). multiplied k M3. assert (0 <= k * Rabs f) by is_not_negative. assert (0 <= k * Rabs e) by is_not_negative.
      assert (0 <= Rabs (e - f)) by is_not_negative. in_units. }
  destruct (W e1 t1 E1 T1) as (F1 & P1 & D1). destruct (W e2 t2 E2 T2) as (F2 & P2 & D2). clear W. destruct (own_error k V f Fv ltac:(lra) ltac:(lra))
    as (Fo & Po & Co). fold (own f) in Fo, Po, Co. intros first furthest.
  destruct (furthest_of _ _ F1 F2 P1) as (Ff & G1 & G2). fold first in Ff, G1, G2. fold furthest in Ff, G1, G2.
  apply made_a_count; try assumption; [lra|]. pose proof Rle_abs (f - t1) as K1. pose proof Rle_abs (- (f - t2)) as K2. rewrite Rabs_Ropp in K2.
  assert (0 <= k * Rabs f) by is_not_negative. clearbody own away furthest. unfold Rabs at 1. destruct Rcase_abs; in_units.
Qed.

Lemma vanishing : float64 (1 / 2 ^ 1020) /\ underflow * 2 ^ 20 <= 1 / 2 ^ 1020.
Proof. rewrite inverse_power, underflow_times. split; [apply generic_format_bpow | apply bpow_le]; easy. Qed.
Lemma exponential_rises x y : x <= y -> exp x <= exp y.
Proof. intros [L | ->]; [left; apply exp_increasing, L | apply Rle_refl]. Qed.
(* The exponential at an end, which may lie below what float64 holds. *)
Lemma exponential_at_an_end t d : float64 t -> t <= 709 -> Rabs d <= 1 / 2 ^ 100 -> let e := exponential_of_sum_float64.exponential t 0 in float64
  e /\ Rabs (e - exp (t + d)) + 2 ^ 4 * underflow <= 9/8 * (1 / 4503599627370496 * Rabs e) + 1 / 2 ^ 1020.
Proof.
  intros F L D e. pose proof proj2 vanishing as V. pose proof proj1 underflow_in_least as T. set (v := 1 / 2 ^ 1020) in *. pose proof exp_pos (t +
    d) as X.
    destruct (Rlt_le_dec t (-708)) as [S|S].
  - assert (Z : e = 0) by (unfold e, exponential_of_sum_float64.exponential; repeat destruct Rlt_dec; lra). rewrite Z, Rminus_0_l, Rabs_Ropp, Rabs_R0,
    (Rabs_pos_eq (exp _)) by lra. split; [apply generic_format_0|].
    assert (exp (t + d) <= exp (-7075/10)) by (apply exponential_rises; both_ways D; lra). assert (exp (-7075/10) <= 1 / 2 ^ 1019 * (2/5)) by
      interval. assert (1 / 2 ^ 1019 = 2 * v) by (unfold v; simpl; lra). lra.
  - assert (Z : Rabs 0 <= 1 / 2 ^ 42) by (rewrite Rabs_R0; lra). pose proof elementary_functions__exp t 0 F (conj S L) Z as N. fold e in N. rewrite
    Rplus_0_r in N. split.
    + unfold e, exponential_of_sum_float64.exponential. repeat destruct Rlt_dec; try lra. apply rounded_is_float64.
    + assert (G : Rabs (exp d - 1) <= 1 / 2 ^ 90) by (both_ways D; interval with (i_prec 120)). rewrite exp_plus in *. pose proof exp_pos t as P. set (w
      := exp t) in *. both_ways N. both_ways G. rewrite (Rabs_pos_eq e) by lra.
      assert (- (w * (1 / 2 ^ 90)) <= w * (exp d - 1) <= w * (1 / 2 ^ 90)) by (split; nra). unfold Rabs. destruct Rcase_abs; lra.
Qed.
Theorem enclosing_rules__exponential : Statements.enclosing_rules__exponential.
Proof.
  intros s x e x' S1 S2 X E P D L U T. enclosed_exponential_float64.lines. fold ROUNDING. fold SLACK. pose proof one_is_float64 as F1.
  pose proof elementary_functions__two_product x 1 X F1 as Q. rewrite Rmult_1_r in Q. specialize (Q (not_tiny x T)). assert (Q1 :
    two_product_float64.product x 1 = x) by (unfold two_product_float64.product; rewrite Rmult_1_r; exact (kept x X)).
  rewrite Q1 in *. replace (two_product_float64.product_error x 1) with 0 by lra. clear Q Q1. rewrite !(Rmult_1_r x), !(Rmult_1_l e), !(kept x X),
    !(kept e E). destruct Rbar_lt_dec as [_|N]; [|destruct (N I)].
  generalize (reached s x e S1 S2 P). intros [R M]. specialize (R x' D). set (reach := rounded (rounded (_ + _) * SLACK)) in *. pose proof
    underflow_is_small as W. pose proof proj1 underflow_in_least as W0.
  assert (Top : rounded (x + reach) <= 709).
  { apply round_le_generic; [typeclasses eauto | typeclasses eauto | rewrite <- (Rmult_1_r 709); apply (whole_is_float64 709 0); easy|].
    assert (x + 2 ^ 7 * unit53 * Rabs x <= 7045/10) by (unfold Rabs, unit53; destruct Rcase_abs; lra). in_units. }
  assert (Low : rounded (x - reach) <= 709) by (apply Rle_trans with (rounded (x + reach)); [apply round_le; [typeclasses eauto..| lra] | exact Top]).
  assert (Dl : Rabs (- (32 * underflow)) <= 1 / 2 ^ 100) by (rewrite Rabs_Ropp, Rabs_pos_eq; lra). assert (Dh : Rabs (32 * underflow) <= 1 / 2 ^ 100)
    by (rewrite Rabs_pos_eq; lra).
  generalize (exponential_at_an_end _ _ (rounded_is_float64 _) Low Dl) (exponential_at_an_end _ _ (rounded_is_float64 _) Top Dh). intros [Fl El] [Fh Eh].
  apply monotone_rule with (exp (rounded (x - reach) + - (32 * underflow))) (exp (rounded (x + reach) + 32 * underflow)); try assumption; [apply
    (exponential_at_an_end x 0 X); [lra | rewrite Rabs_R0; lra] | apply vanishing | lra | in_units | split; apply exponential_rises; generalize
    (Rabs_pos x); lra | generalize (Rabs_pos (exponential_of_sum_float64.exponential x 0)); lra..].
Qed.
