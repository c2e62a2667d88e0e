(* The rule of the enclosing machine for the logarithm: where it vanishes, the number is 1. *)

From Coq Require Import Reals Lra ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Coq Require Import List.
From Formal Require Import Float Float64 RoundedHalfTurns Rounding RoundedGradient RoundedAngle RoundedLogarithm EnclosingRules EnclosingFunctions.
Open Scope R_scope.
Import ListNotations.

Lemma logarithm_away_from_one x : float64 x -> 0 < x -> x = 1 \/ 1 / 2 ^ 54 <= Rabs (ln x).
Proof.
  intros F P. destruct (Rle_lt_dec (1 / 2 ^ 54) (Rabs (ln x))) as [L|L]; [right; exact L | left].
  assert (B : Rabs (x - 1) < bpow radix2 (-53)) by (rewrite <- (exp_ln x P); apply Rlt_le in L; set (y := ln x) in *; simpl bpow; interval with
    (i_prec 100)).
  destruct (multiple_of_power x (-53) F) as [m M]; [rewrite Rabs_pos_eq by lra; apply Rabs_def2 in B; simpl bpow in *; lra|].
  assert (Z : x - 1 = IZR (m - 2 ^ 53) * bpow radix2 (-53)) by (rewrite M, minus_IZR; simpl; lra).
  destruct (no_part (m - 2 ^ 53) (-53)) as [N|N]; rewrite <- Z in N; lra.
Qed.
Lemma logarithm_is_float64 x : float64 (natural_logarithm_float64.logarithm x).
Proof. unfold natural_logarithm_float64.logarithm. repeat match goal with |- context [if ?d then _ else _] => destruct d end; apply rounded_is_float64
  || apply generic_format_0. Qed.
(* At an end its error is part of it, or, where that is 1, of what it is elsewhere. *)
Lemma logarithm_at_an_end x t : float64 x -> float64 t -> x <> t -> 0 < x <= IZR (2 ^ 1024 - 2 ^ 971) -> 0 < t <= IZR (2 ^ 1024 - 2 ^ 971) -> let
  size y := 1170935903116329 / 10141204801825835211973625643008 * Rabs (natural_logarithm_float64.logarithm y) in Rabs
  (natural_logarithm_float64.logarithm t - ln t) + 2 ^ 4 * underflow <= size t + 6/10 * size t + 1/4 * size x + 0.
Proof.
  intros X T N Px Pt. cbv zeta. pose proof underflow_is_small as W. assert (V : bpow radix2 (-896) <= 1 / 2 ^ 200) by (rewrite inverse_power; apply
    bpow_le; easy).
  generalize (elementary_functions__log x X Px) (elementary_functions__log t T Pt) (Rabs_triang_inv (ln x) (natural_logarithm_float64.logarithm x))
    (Rabs_triang_inv (ln t) (natural_logarithm_float64.logarithm t)) (Rabs_pos (natural_logarithm_float64.logarithm x)) (Rabs_pos
    (natural_logarithm_float64.logarithm t)).
  rewrite !(Rabs_minus_sym (ln _)). destruct (logarithm_away_from_one t T (proj1 Pt)) as [-> | A]; [|lra].
  destruct (logarithm_away_from_one x X (proj1 Px)) as [E | A]; [destruct (N E)|]. rewrite ln_1, Rabs_R0. lra.
Qed.
Theorem enclosing_rules__logarithm : Statements.enclosing_rules__logarithm.
Proof.
  intros s x e x' S1 S2 X E P D U L T. enclosed_logarithm_float64.lines. fold ROUNDING. fold SLACK. destruct Rbar_lt_dec as [_|N]; [|destruct (N I)].
  assert (A : Rabs x = x) by (apply Rabs_pos_eq; lra). rewrite <- A in T. destruct (not_tiny x (or_introl T)) as [Z|G]; [lra|]. rewrite A in G.
  assert (G' : underflow * 2 ^ 105 <= x) by (rewrite underflow_times; exact G). clear T G. pose proof proj1 underflow_in_least as W. rewrite pow_IZR in
    U. assert (Most : 2 * IZR (2 ^ Z.of_nat 1000) <= IZR (2 ^ 1024 - 2 ^ 971)) by (rewrite <- mult_IZR; apply IZR_le; vm_compute; discriminate).
  generalize (reached s x e S1 S2 P). unfold reach. intros [R M]. set (reach := rounded (rounded (_ + _) * SLACK)) in *. rewrite A in *. pose proof R x
    ltac:(rewrite Rminus_eq_0, Rabs_R0; is_not_negative) as R1. specialize (R x' D).
  pose proof counted (x - reach) ltac:(in_units) as B. pose proof counted (x + reach) ltac:(in_units) as C. set (low := rounded (x - reach)) in *. set
    (high := rounded (x + reach)) in *.
  assert (0 < low) by in_units. assert (high <= IZR (2 ^ 1024 - 2 ^ 971)) by in_units. assert (low < x < high) by in_units.
  destruct (Rlt_dec 0 low) as [_|N]; [|destruct (N ltac:(assumption))]. destruct (Rlt_dec 0 high) as [_|N]; [|lra].
  apply (monotone_rule s (natural_logarithm_float64.logarithm x) 0 (fun _ => 1170935903116329 / 10141204801825835211973625643008) (1170935903116329 /
        10141204801825835211973625643008) (ln x') [(natural_logarithm_float64.logarithm low, ln low); (natural_logarithm_float64.logarithm high, ln
    high)]); try apply logarithm_is_float64; [lra | apply generic_format_0 | lra | intro; apply
    Rle_refl | in_units | | left | right; left]; cbn [snd]; [|apply ln_le; lra..]. repeat apply Forall_cons; try apply Forall_nil; (split; [apply
    logarithm_is_float64 | apply logarithm_at_an_end; try is_float64; cbn [fst]; lra]).
Qed.
