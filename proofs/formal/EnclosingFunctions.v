(* The rules of the enclosing machine for the elementary functions: what moves their arguments, and their own errors. *)

From Coq Require Import Reals Lra ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Coq Require Import List.
From Formal Require Import Float Float64 RoundedHalfTurns Rounding RoundedGradient RoundedRelative RoundedExponential EnclosingRules EnclosingBounds.
Open Scope R_scope.
Import ListNotations.

(* Sine and cosine of half-turns: the slope is at most pi, and they move by 2 at most. Where a factor stays exact, the rounding of a 0 counts 0. *)
Definition product_moves x ex y ey := rounded (rounded (Rabs x * ey) + rounded (rounded (Rabs y + rounded (ROUNDING * ey)) * ex)).
Definition count_of_turn (stays : bool) f m := let moved := rounded (7074237752028453 / 2251799813685248 * rounded (ROUNDING * m)) in let own :=
  rounded
  (rounded (5674535530486825 / 10141204801825835211973625643008 * Rabs f) + least) in rounded (9007199254740992 * rounded (rounded ((if Rlt_dec moved
    2
  then moved else 2) + if stays then if Req_EM_T f 0 then 0 else own else own) * SLACK)).
Section half_turns.
Variables (wave wave_slope : R -> R) (computed_wave : R).
Hypothesis wave_derivative : forall x, is_derive wave x (wave_slope x).
Hypothesis wave_steep : forall x, -1 <= wave_slope x <= 1.
Hypothesis wave_range : forall x, -1 <= wave x <= 1.
Lemma half_turns_rule stays m s x ex x' y ey y' : 1 <= s -> s <= 1 + 3 / 2 ^ 22 -> encloses s (x, ex) x' -> encloses s (y, ey) y' -> ex <= 2 ^ 60 ->
  let e
  := wave (PI * (x * y)) in near_relative (19/4) computed_wave e -> sign computed_wave = sign e -> product_moves x ex y ey <= m -> (stays = true -> 1
    / 2
  ^ 900 <= m \/ x * y = x' * y') -> let c := count_of_turn stays computed_wave m in float64 c /\ 0 <= c /\ Rabs (computed_wave - wave (PI * (x' *
    y'))) <= s * (1
  + 1 / 2 ^ 49) * (c / 2 ^ 53).
Proof.
  intros S1 S2 (_ & _ & Px & Dx) (Y & _ & Py & Dy) L e Near Side Lm Z. cbn [fst snd] in *. destruct (product_moved s x ex x' y ey y') as [M0 M]; try
    assumption. fold (product_moves x ex y ey) in
    *. set (m0 := product_moves _ _ _ _) in *. assert (s * m0 <= s * m) by (apply Rmult_le_compat_l; lra).
  destruct (bound_of s m S1 S2 ltac:(lra)) as [B _]. pose proof proj1 underflow_in_least as T. pose proof underflow_is_small as W. assert (0 <= m) by
    lra.
  unfold count_of_turn. counts b (ROUNDING * m). set (h := 7074237752028453 / 2251799813685248) in *. assert (0 <= h) by (unfold h; lra). counts t (h
    * b).
  assert (Q : PI <= h * (1 - 2 * unit53)) by (unfold h, unit53; interval with (i_prec 100)).
  set (e' := wave (PI * (x' * y'))). assert (D : Rabs (e - e') <= t + 2 ^ 12 * underflow).
  { eapply Rle_trans; [exact (moved_by_at_most wave wave_slope 1 _ _ wave_derivative (fun x => Rabs_le _ _ (wave_steep x)))|]. rewrite <-
    Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq PI), Rmult_1_l by (generalize PI_RGT_0; lra).
    apply Rle_trans with (h * (1 - 2 * unit53) * (b + 2 ^ 10 * underflow)); [|unfold h in *; in_units].
    apply Rmult_le_compat; [generalize PI_RGT_0; lra | apply Rabs_pos | exact Q |]. in_units. }
  assert (D' : Rabs (e - e') <= 2) by (generalize (wave_range (PI * (x * y))) (wave_range (PI * (x' * y'))); intros; apply Rabs_le; unfold e, e';
    lra).
  set (v := if Rlt_dec t 2 then t else 2). assert (float64 v) by (unfold v; destruct Rlt_dec; [is_float64 | exact two_is_float64]). assert (V : 0 <=
    v /\
    Rabs (e - e') <= v + 2 ^ 12 * underflow) by (unfold v; destruct Rlt_dec; lra).
  pose proof moved_and_own s (5674535530486825 / 10141204801825835211973625643008) v computed_wave e e' S1 ltac:(lra) ltac:(assumption) ltac:(lra)
    ltac:(at_most_by Near; generalize (Rabs_pos e); unfold underflow in *; lra) ltac:(lra) as Most. destruct stays; [|exact Most]. destruct Req_EM_T
      as
    [F|_]; [|exact Most]. rewrite F, sign_0 in *. destruct (Req_dec e 0) as [E|E]; [|destruct (sign_neq_0 e E (eq_sym Side))]. destruct (Z eq_refl) as
    [G|G].
  - assert (underflow * 2 ^ 174 <= m) by (rewrite underflow_times; rewrite inverse_power in G; exact G). apply (made_a_count s v 0 (0 - e')); try
    apply generic_format_0; try lra; [assumption|].
    rewrite <- E. assert (underflow * 2 ^ 100 <= v) by (unfold v; destruct Rlt_dec; unfold h in *; in_units). in_units.
  - unfold e'. rewrite <- G. fold e. rewrite E, Rminus_eq_0, Rabs_R0. split; [is_float64 | split; is_not_negative].
Qed.
End half_turns.
Lemma slope_of_cosine x : -1 <= - sin x <= 1.
Proof. generalize (SIN_bound x). lra. Qed.
Definition sine_rule f := half_turns_rule sin cos f is_derive_sin COS_bound SIN_bound.
Definition cosine_rule f := half_turns_rule cos (fun x => - sin x) f is_derive_cos slope_of_cosine COS_bound.
Ltac of_half_turns stays rule part s x ex x' y ey y' := eapply (rule _ stays _ s x ex x' y ey y'); try assumption; try (repeat split; assumption);
  [eapply part, (elementary_functions__of_product_relative x y) |
  eapply part, (signs_of_waves x y) | ..]; try apply not_tiny; try assumption.
Theorem enclosing_rules__sine : Statements.enclosing_rules__sine.
Proof. red. intros. of_half_turns false sine_rule @proj1 slack x x_error x_exact y y_error y_exact; [apply Rle_refl | discriminate]. Qed.
Theorem enclosing_rules__cosine : Statements.enclosing_rules__cosine.
Proof. red. intros. of_half_turns false cosine_rule @proj2 slack x x_error x_exact y y_error y_exact; [apply Rle_refl | discriminate]. Qed.

(* A function that rises or falls lies between its values at the ends of what its argument can be. *)
Definition reach x e := rounded (rounded (rounded (ROUNDING * e) + rounded (1 / 4503599627370496 * Rabs x)) * SLACK).
Lemma reached s x e : 1 <= s -> s <= 1 + 3 / 2 ^ 22 -> 0 <= e -> (forall x', Rabs (x - x') <= s * (e / 2 ^ 53) -> rounded (x - reach x e) + (Rabs x /
  2 ^ 54 + e / 2 ^ 76) -
    32 * underflow <= x' <= rounded (x + reach x e) - (Rabs x / 2 ^ 54 + e / 2 ^ 76) + 32 * underflow) /\ 0 <= reach x e <= ROUNDING * e * (1 + 2 ^ 6
    * unit53) + 2 ^ 7 * unit53 * Rabs x
  + 32 * underflow.
Proof.
  intros S1 S2 E. multiplied e S2. pose proof proj1 underflow_in_least as T. pose proof Rabs_pos x as A. unfold reach. counts b
    (ROUNDING * e). counts h (1 / 4503599627370496 * Rabs x). rounds q (b + h). counts r (q * SLACK).
  pose proof rounding_error (x - r) as L. pose proof rounding_error (x + r) as U. pose proof Rabs_triang x (- r) as Sl. pose proof Rabs_triang x r as Sh.
    rewrite Rabs_Ropp in Sl. rewrite (Rabs_pos_eq r) in Sl, Sh by assumption. change (x + - r) with (x - r) in Sl.
  both_ways L. both_ways U. clearbody b h q r. split; [intros x' D; both_ways D|]; in_units.
Qed.
(* The furthest of some distances, and at least m. *)
Lemma furthest_of l : forall m, float64 m -> Forall float64 l -> let furthest := fold_left (fun m a => if Rlt_dec m a then a else m) l m in float64
  furthest /\ m <= furthest /\ Forall (fun a => a <= furthest) l.
Proof.
  induction l as [|a l IH]; intros m M A; cbn [fold_left]; [repeat split; [exact M | lra | constructor]|]. inversion_clear A as [|? ? Fa Fl].
  destruct (IH (if Rlt_dec m a then a else m) ltac:(destruct Rlt_dec; assumption) Fl) as (F & L & U). destruct Rlt_dec; repeat split; try apply Forall_cons; try
    assumption; lra.
Qed.
Lemma end_reached f e t V k l g : float64 f -> float64 e -> float64 V -> 0 <= V -> 0 <= k -> 0 <= g <= 8 * unit53 -> g <= l -> Rabs (e - t) + 2 ^ 4 *
  underflow <= k * Rabs e + 6/10 * (g * Rabs e) + 1/4 * (g * Rabs f) + V -> let a := rounded (Rabs (rounded (e - f)) + rounded (rounded (k * Rabs e) +
  V)) in float64 a /\ Rabs (f - t) + 8 * underflow <= (a + (l * Rabs f + V) * (1 - 3 * unit53)) * (1 + 10 * unit53).
Proof.
  intros F E Fv Pv K [P G] L D a. pose proof proj1 underflow_in_least as T. destruct (own_error k V e Fv Pv K) as (Fo & Po & Co). pose proof
    own_rounding_of_sum e (- f) E (generic_format_opp _ _ _ F) as O. change (e + - f) with (e - f) in O. subst a. set (d := rounded (e - f)) in *. set
    (own := rounded (_ + V)) in *.
  counts a (Rabs d + own). split; [is_float64|].
  pose proof Rabs_triang_inv (e - f) d as M1. rewrite Rabs_minus_sym in O. pose proof Rabs_triang (f - e) (e - t) as M2. replace (f - e + (e - t)) with
    (f - t) in M2 by ring. rewrite (Rabs_minus_sym f e) in M2. pose proof Rabs_triang_inv e f as M3.
  multiplied (Rabs (e - f)) G. multiplied g M3. multiplied (Rabs f) L. assert (0 <= g * Rabs f) by is_not_negative. assert (0 <= k * Rabs e) by
    is_not_negative. assert (0 <= Rabs (e - f)) by is_not_negative. in_units.
Qed.
(* What is charged at an end, and the furthest that some ends are away; of each end, what is computed and what it stands for. *)
Definition charge k V e := rounded (rounded (k e * Rabs e) + V).
Definition furthest f (k : R -> R) V (ends : list (R * R)) := fold_left (fun m a => if Rlt_dec m a then a else m) (map (fun n => rounded (Rabs (rounded
  (fst n - f)) + charge k V (fst n))) ends) 0.
Lemma monotone_rule s f V k g y ends : 1 <= s -> float64 f -> float64 V -> 0 <= V -> (forall e, g <= k e) -> 0 <= g <= 8 * unit53 -> Forall (fun n =>
  float64 (fst n) /\ Rabs (fst n - snd n) + 2 ^ 4 * underflow <= k (fst n) * Rabs (fst n) + 6/10 * (g * Rabs (fst n)) + 1/4 * (g * Rabs f) + V) ends
  -> Exists (fun n => snd n <= y) ends -> Exists (fun n => y <= snd n) ends -> let c := rounded (9007199254740992 * rounded (rounded (furthest f k V ends
  + charge k V f) * SLACK)) in float64 c /\ 0 <= c /\ Rabs (f - y) <= s * (1 + 1 / 2 ^ 49) * (c / 2 ^ 53).
Proof.
  intros S F Fv Pv K G A L1 L2. pose proof proj1 underflow_in_least as T. rewrite Forall_forall in A. rewrite Exists_exists in L1, L2. destruct L1 as (n1
    & I1 & L1), L2 as (n2 & I2 & L2). set (away (n : R * R) := rounded (Rabs (rounded (fst n - f)) + charge k V (fst n))).
  assert (W : forall n, In n ends -> float64 (away n) /\ Rabs (f - snd n) + 8 * underflow <= (away n + (k f * Rabs f + V) * (1 - 3 * unit53)) * (1 + 10
    * unit53)).
  { intros n I. destruct (A n I). apply end_reached with g; try assumption; [generalize (K (fst n)); lra | apply K]. }
  assert (Kf : 0 <= k f) by (generalize (K f); lra). destruct (own_error (k f) V f Fv Pv Kf) as (Fo & Po & Co). fold (charge k V f) in Fo, Po, Co.
  destruct (furthest_of (map away ends) 0) as (Ff & P0 & U); [apply generic_format_0 | apply Forall_map, Forall_forall; intros n I; apply W, I|]. rewrite
    Forall_map, Forall_forall in U. change (fold_left _ (map away ends) 0) with (furthest f k V ends) in Ff, P0, U.
  apply made_a_count; try assumption. destruct (W n1 I1) as [_ D1], (W n2 I2) as [_ D2]. specialize (U n1 I1) as U1. specialize (U n2 I2) as U2. pose
    proof Rle_abs (f - snd n1) as K1. pose proof Rle_abs (- (f - snd n2)) as K2. rewrite Rabs_Ropp in K2.
  assert (0 <= k f * Rabs f) by is_not_negative. set (o := charge k V f) in *. set (m := furthest f k V ends) in *. clearbody o m away. unfold Rabs at 1.
    destruct Rcase_abs; in_units.
Qed.

Lemma vanishing : float64 (1 / 2 ^ 1020) /\ underflow * 2 ^ 20 <= 1 / 2 ^ 1020.
Proof. rewrite inverse_power, underflow_times. split; [apply generic_format_bpow | apply bpow_le]; easy. Qed.
Lemma exponential_rises x y : x <= y -> exp x <= exp y.
Proof. intros [L | ->]; [left; apply exp_increasing, L | apply Rle_refl]. Qed.
(* The exponential at an end, which may lie below what float64 holds. *)
Lemma exponential_at_an_end t d : float64 t -> t <= 709 -> Rabs d <= 1 / 2 ^ 100 -> let e := exponential_of_sum_float64.exponential t 0 in float64
  e /\ Rabs (e - exp (t + d)) + 2 ^ 4 * underflow <= 1 / 4503599627370496 * Rabs e + 6/10 * (1 / 4503599627370496 * Rabs e) + 1 / 2 ^
  1020.
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
  pose proof elementary_two_product x 1 X F1 as Q. rewrite Rmult_1_r in Q. specialize (Q (not_tiny x T)). assert (Q1 :
    two_product_float64.product x 1 = x) by (unfold two_product_float64.product; rewrite Rmult_1_r; exact (kept x X)).
  rewrite Q1 in *. replace (two_product_float64.product_error x 1) with 0 by lra. clear Q Q1. rewrite !(Rmult_1_r x), !(Rmult_1_l e), !(kept x X),
    !(kept e E). destruct Rbar_lt_dec as [_|N]; [|destruct (N I)].
  generalize (reached s x e S1 S2 P). unfold reach. intros [R M]. specialize (R x' D). set (reach := rounded (rounded (_ + _) * SLACK)) in *. pose proof
    underflow_is_small as W. pose proof proj1 underflow_in_least as W0.
  assert (Top : rounded (x + reach) <= 709).
  { apply round_le_generic; [typeclasses eauto | typeclasses eauto | rewrite <- (Rmult_1_r 709); apply (whole_is_float64 709 0); easy|].
    assert (x + 2 ^ 7 * unit53 * Rabs x <= 7045/10) by (unfold Rabs, unit53; destruct Rcase_abs; lra). in_units. }
  assert (Low : rounded (x - reach) <= 709) by (apply Rle_trans with (rounded (x + reach)); [apply round_le; [typeclasses eauto..| lra] | exact Top]).
  assert (Dl : Rabs (- (32 * underflow)) <= 1 / 2 ^ 100) by (rewrite Rabs_Ropp, Rabs_pos_eq; lra). assert (Dh : Rabs (32 * underflow) <= 1 / 2 ^ 100)
    by (rewrite Rabs_pos_eq; lra).
  generalize (exponential_at_an_end _ _ (rounded_is_float64 _) Low Dl) (exponential_at_an_end _ _ (rounded_is_float64 _) Top Dh). intros [Fl El] [Fh Eh].
  set (f := exponential_of_sum_float64.exponential) in *. assert (0 <= Rabs (f x 0)) by is_not_negative. apply (monotone_rule s (f x 0) (1 / 2 ^ 1020)
    (fun _ => 1 / 4503599627370496) (1 / 4503599627370496) (exp x') [(f (rounded (x - reach)) 0, exp (rounded (x - reach) + - (32 * underflow))); (f
    (rounded (x + reach)) 0, exp (rounded (x + reach) + 32 * underflow))]); [exact S1 | apply (exponential_at_an_end x 0 X); [lra | rewrite Rabs_R0; lra] |
    apply vanishing | lra | intro; apply Rle_refl | in_units | | left | right; left]; cbn [fst snd]; [|apply exponential_rises; generalize (Rabs_pos x);
    lra..].
  repeat apply Forall_cons; try apply Forall_nil; (split; [assumption | cbn [fst snd]; lra]).
Qed.
