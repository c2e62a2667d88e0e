(* The kernels' sine and cosine of half-turns of one float64, relative to what they are: near a zero, too. *)

From Coq Require Import Reals Lra ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Formulas Float Float64 HalfTurns RoundedHalfTurns Rounding RoundedGradient RoundedFunctions.
Open Scope R_scope.

Section reduced.
Variable r : R.
Hypothesis B : - (1/4 + 1/2^30) <= r <= 1/4 + 1/2^30.
(* The sine's polynomial is off by at most 2^-53 of its argument: its derivative is by 2^-53. *)
Lemma elementary_sine_relative : Rabs (half_turn_polynomials.sine_near r - sin (PI * r)) <= 1 / 2 ^ 53 * Rabs r.
Proof.
  evar (h : R -> R). apply (at_most_times (fun t => half_turn_polynomials.sine_near t - sin (PI * t)) h _ (1/4 + 1/2^30));
    [rewrite (proj1 elementary_zero), Rmult_0_r, sin_0; ring | intros t T; split | exact B].
  - half_turn_polynomials.lines. auto_derive; [exact I|]. unfold h. reflexivity.
  - unfold h. clear - T. interval with (i_taylor t, i_degree 20, i_prec 100).
Qed.
Lemma sine_near_relative : let s := Rabs (sin (PI * r)) in Rabs (half_turn_polynomials_float64.sine_near r - sin (PI * r)) <= 18/5 * (1 / 2 ^ 53) * s
  + bpow radix2 (-1074) /\ 279/100 * Rabs r <= s.
Proof.
  pose proof elementary_sine_relative as X. destruct (factor_rounded r B) as [F P].
  unfold half_turn_polynomials_float64.sine_near, half_turn_polynomials.sine_near in *. set (f := rounded (_ + _)) in *. set (w :=
    half_turn_polynomials.sine_tail r + _) in *.
  both_ways F. destruct (rounding (r * f)) as (d & t & D & T & _ & ->). both_ways D. set (s := sin (PI * r)) in *. pose proof Rabs_pos r as O.
  assert (S : 279/100 * Rabs r <= Rabs s).
  { replace s with (r * w - (r * w - s)) by ring. generalize (Rabs_triang_inv (r * w) (r * w - s)). rewrite (Rabs_mult r w), (Rabs_pos_eq w) by
    lra. nra. }
  split; [|exact S]. apply Rle_trans with (9 / 2 ^ 53 * Rabs r + bpow radix2 (-1074)); [|lra].
  replace (_ - s) with (r * (f * (1 + d) - w) + (r * w - s) + t) by ring. at_most_by Rabs_triang. apply Rplus_le_compat; [|exact T].
    at_most_by Rabs_triang. rewrite Rabs_mult.
  assert (K : Rabs (f * (1 + d) - w) <= 8 / 2 ^ 53) by (apply Rabs_le; split; nra).
  replace (9 / 2 ^ 53 * Rabs r) with (Rabs r * (8 / 2 ^ 53) + 1 / 2 ^ 53 * Rabs r) by field. apply Rplus_le_compat; [apply Rmult_le_compat_l; [exact O
    | exact K] | exact X].
Qed.
End reduced.

Definition near_relative (c x y : R) := Rabs (x - y) <= c * (1 / 2 ^ 53) * Rabs y + bpow radix2 (-1074).
Lemma opposites_near c x y : near_relative c x y -> near_relative c (- x) (- y).
Proof. unfold near_relative. rewrite Rabs_Ropp. apply of_opposites. Qed.
Lemma cosine_not_small t : - (1/4 + 1/2^30) <= t <= 1/4 + 1/2^30 -> 7071/10000 <= cos (PI * t).
Proof. intro. interval. Qed.
(* Sine and cosine of half-turns of a product that is carried in two are within 19/4 2^-53, relative to them. *)
Theorem elementary_functions__of_product_relative a b : float64 a -> float64 b -> a * b = 0 \/ bpow radix2 (-969) <= Rabs (a * b) -> Rabs (a * b)
  <= 2 ^ 21 -> let p := two_product_float64.product a b in let e := two_product_float64.product_error a b in near_relative (19/4)
  (sine_of_half_turns_float64.sine p e) (sin (PI * (a * b))) /\ near_relative (19/4) (cosine_of_half_turns_float64.cosine p e) (cos (PI * (a *
  b))).
Proof.
  intros A B U L p e. destruct (polynomials_near a b A B U L) as [_ C]. destruct (remainder_error a b A B U L) as [_ R]. destruct (remainder_near a b
    A B U L) as [E W].
  fold p e in C, R, E, W. destruct (sine_printed p e (product_is_float64 a b)) as [-> ->]. set (r := sine_of_half_turns_float64.remainder p e) in *.
    set (w := a * b - IZR (quarters p) / 2) in *.
  assert (Wn : - (1/4 + 1/2^30) <= w <= 1/4 + 1/2^30) by (apply Rabs_le_between; lra). clear W. replace (a * b) with (w + IZR (quarters p) / 2) by
    (unfold w; ring). destruct (by_quadrant w (quarters p)) as [-> ->].
  pose proof bpow_ge_0 radix2 (-1074) as P. apply in_each_quadrant; [| | apply opposites_near]; unfold near_relative.
  - destruct (sine_near_relative r R) as [S _]. destruct (sine_near_relative w Wn) as [_ Q].
    assert (D : Rabs (r - w) <= / 2 ^ 53 * Rabs w).
    { replace w with (p - IZR (quarters p) / 2 + e) in * by (unfold w; rewrite <- (in_two a b A B U); unfold p, e; ring). rewrite E. set (y := p - _ + e).
      destruct (rounded_sum (p - IZR (quarters p) / 2) e) as (d & Dd & X); [apply remainder_is_float64, product_is_float64 | apply
        rounded_is_float64|]. fold y in X. rewrite X. replace (y * (1 + d) - y) with (d * y) by ring.
      rewrite Rabs_mult. apply Rmult_le_compat_r; [apply Rabs_pos | exact Dd]. }
    assert (M : Rabs (sin (PI * r) - sin (PI * w)) <= 1127/1000 / 2 ^ 53 * Rabs (sin (PI * w))).
    { eapply Rle_trans; [exact (half_turns_apart sin cos r w is_derive_sin (fun x => Rabs_le _ _ (COS_bound x)))|].
      apply Rle_trans with (PI * (/ 2 ^ 53 * Rabs w)); [apply Rmult_le_compat_l; [generalize PI_RGT_0; lra | exact D]|]. pose proof Rabs_pos w as V. set
        (v := Rabs w) in *. assert (PI <= 31416/10000) by interval. clearbody v. nra. }
    assert (G : Rabs (sin (PI * r)) <= (1 + 2 / 2 ^ 53) * Rabs (sin (PI * w))) by (generalize (Rabs_triang_inv (sin (PI * r)) (sin (PI * w)))
      (Rabs_pos (sin (PI * w))); lra).
    pose proof Rabs_pos (sin (PI * w)) as V. eapply Rle_trans; [exact (through _ _ _ _ _ S M) | lra].
  - pose proof cosine_not_small w Wn as G. rewrite (Rabs_pos_eq (cos _)) by lra. fold r in C. lra.
Qed.


Theorem elementary_functions__of_product_relative__point : exists a b, float64 a /\ float64 b /\ (a * b = 0 \/ bpow radix2 (-969) <= Rabs (a * b))
  /\ Rabs (a * b) <= 2 ^ 21.
Proof. exists 0, 0. rewrite Rmult_0_l, Rabs_R0. repeat split; try apply generic_format_0; [left; reflexivity | lra]. Qed.
Lemma not_near_both c x : c <= 5 -> near_relative c x 0 -> near_relative c x 1 -> False.
Proof.
  unfold near_relative. rewrite Rabs_R0, Rabs_R1. intros C X Y. both_ways X. both_ways Y. generalize (bpow_le radix2 (-1074) (-2) ltac:(easy)). change
    (bpow radix2 (-2)) with (/ 4). lra.
Qed.
Theorem elementary_functions__of_product_relative__false : ~ forall a b, float64 a -> float64 b -> a * b = 0 \/ bpow radix2 (-969) <= Rabs (a * b) ->
  Rabs (a * b) <= 2 ^ 21 ->
  near_relative (19/4) (sine_of_half_turns_float64.sine (two_product_float64.product a b) (two_product_float64.product_error a b)) (cos (PI * (a * b))).
Proof.
  intro H. assert (Z : float64 0) by apply generic_format_0. assert (U : 0 * 0 = 0) by ring. assert (L : Rabs (0 * 0) <= 2 ^ 21) by (rewrite U,
    Rabs_R0; lra).
  generalize (H 0 0 Z Z (or_introl U) L) (proj1 (elementary_functions__of_product_relative 0 0 Z Z (or_introl U) L)). rewrite U, Rmult_0_r, sin_0,
    cos_0. intros X Y. apply (not_near_both (19/4) _ ltac:(lra) Y X).
Qed.
