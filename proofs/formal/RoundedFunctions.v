(* The kernels' functions of one float64, as they are carried out: sine and cosine of half-turns. *)

From Coq Require Import Reals Lra ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Formulas Float Float64 RoundedHalfTurns Rounding RoundedGradient.
Open Scope R_scope.

(* Sine and cosine of any float64. *)
Lemma remainder_of_float64 x : float64 x -> sine_of_half_turns_float64.remainder x 0 = x - IZR (quarters x) / 2 /\ - (1/4) <= x - IZR (quarters x)
  / 2 <= 1/4.
Proof.
  intro F. split; [|apply Rabs_le_between, near_quarters]. rewrite (remainder_printed _ _ F), Rplus_0_r. exact (kept _ (remainder_is_float64 _ F)).
Qed.
Lemma sine_of_float64 x : float64 x -> let s := half_turn_polynomials_float64.sine_near (x - IZR (quarters x) / 2) in let c :=
  half_turn_polynomials_float64.cosine_near (x - IZR (quarters x) / 2) in sine_of_half_turns_float64.sine x 0 = sine_in (quarters x) s c /\
  cosine_of_half_turns_float64.cosine x 0 = cosine_in (quarters x) s c.
Proof. intro F. rewrite <- (proj1 (remainder_of_float64 x F)). exact (sine_printed x 0 F). Qed.

(* Sine and cosine of half-turns of a float64 are exact at every whole number of quarters of a turn. *)
Theorem elementary_functions__quarters x m : float64 x -> 2 * x = IZR m -> sine_of_half_turns_float64.sine x 0 = sin (PI * x) /\
  cosine_of_half_turns_float64.cosine x 0 = cos (PI * x).
Proof.
  intros F H. set (q := quarters x). assert (Q : q = m) by (unfold q, quarters; rewrite H; apply (Zrnd_IZR (Znearest (fun n => negb (Z.even n))))).
  assert (R : x - IZR q / 2 = 0) by (rewrite Q, <- H; field). destruct (sine_of_float64 x F) as [-> ->]. fold q. rewrite R. destruct
    elementary_zero_float64 as [-> ->].
  replace x with (0 + IZR q / 2) by lra. destruct (by_quadrant 0 q) as [-> ->]. rewrite Rmult_0_r, sin_0, cos_0. split; reflexivity.
Qed.
Lemma half_is_float64 : float64 (1/2).
Proof. replace (1/2) with (IZR 1 * bpow radix2 (-1)) by (simpl; lra). apply whole_is_float64; easy. Qed.
Theorem elementary_functions__quarters__point : exists x m, float64 x /\ 2 * x = IZR m.
Proof. exists (1/2), 1%Z. split; [apply half_is_float64 | lra]. Qed.
Theorem elementary_functions__quarters__false : ~ forall x m, float64 x -> 2 * x = IZR m -> sine_of_half_turns_float64.sine x 0 = cos (PI * x).
Proof.
  intro H. destruct (elementary_functions__quarters 0 0 (generic_format_0 _ _) ltac:(lra)) as [S _]. specialize (H 0 0%Z (generic_format_0 _ _)
    ltac:(lra)).
  rewrite S, Rmult_0_r, sin_0, cos_0 in H. lra.
Qed.
