(* The kernels' functions of one float64, as they are carried out: sine and cosine of half-turns. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Float Float64 HalfTurns RoundedHalfTurns Rounding RoundedGradient.
Open Scope R_scope.

Lemma exponent_at_least (m e k : Z) : (Z.abs m < 2 ^ 53)%Z -> bpow radix2 k <= Rabs (IZR m * bpow radix2 e) -> (k - 52 <= e)%Z.
Proof.
  intros M B. assert (G : bpow radix2 k < bpow radix2 (53 + e)).
  { eapply Rle_lt_trans; [exact B|]. rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)), bpow_plus by apply bpow_ge_0. apply Rmult_lt_compat_r; [apply bpow_gt_0|].
    rewrite <- abs_IZR. change (bpow radix2 53) with (IZR (2 ^ 53)). apply IZR_lt, M. }
  apply lt_bpow in G. lia.
Qed.

(* Sine and cosine of any float64, however large: the quarters have no more digits than it has. *)
Section half_turns.
Variable x : R.
Hypothesis F : float64 x.
Let q := quarters x.
Lemma digits_of_quarters : exists m k : Z, q = (m * 2 ^ k)%Z /\ (Z.abs m < 2 ^ 53)%Z /\ (0 <= k)%Z.
Proof.
  assert (D := F). apply FLT_format_generic in D; [|easy]. destruct D as [[m e] E M _]. unfold F2R in E; cbn [Fnum Fexp] in *.
  destruct (Z_le_gt_dec (-1) e) as [P|N].
  - exists m, (e + 1)%Z. split; [|split; [exact M | lia]]. unfold q, quarters.
    replace (2 * x) with (IZR (m * 2 ^ (e + 1))) by (rewrite mult_IZR, (IZR_Zpower radix2) by lia; rewrite E, bpow_plus; simpl; lra).
    apply (Zrnd_IZR (Znearest (fun n => negb (Z.even n)))).
  - exists q, 0%Z. split; [ring|]. split; [|easy]. apply lt_IZR. rewrite abs_IZR. assert (S : Rabs x <= 2 ^ 51).
    { rewrite E, Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0. apply Rle_trans with (bpow radix2 53 * bpow radix2 (-2)); [|simpl; lra].
      apply Rmult_le_compat; [apply Rabs_pos | apply bpow_ge_0 | | apply bpow_le; lia]. change (bpow radix2 53) with (IZR (2 ^ 53)). rewrite <- abs_IZR. apply IZR_le, Z.lt_le_incl, M. }
    generalize (near_quarters x). fold q. intro H. apply Rabs_le_between in H. apply Rabs_le_between in S. apply Rabs_def1; simpl; lra.
Qed.
Lemma part_of_all_quarters (f : R) (j : Z) : f = bpow radix2 j -> (-2 <= j)%Z -> rounded (f * IZR q) = f * IZR q.
Proof.
  intros -> J. destruct digits_of_quarters as (m & k & -> & M & K). apply kept. rewrite mult_IZR, (IZR_Zpower radix2) by exact K.
  replace (bpow radix2 j * _) with (IZR m * bpow radix2 (k + j)) by (rewrite bpow_plus; ring). apply whole_is_float64; lia.
Qed.
Lemma remainder_of_float64 : sine_of_half_turns_float64.remainder x 0 = x - IZR q / 2 /\ - (1/4) <= x - IZR q / 2 <= 1/4.
Proof.
  split; [|apply Rabs_le_between, near_quarters].
  unfold sine_of_half_turns_float64.remainder, sine_of_half_turns_float64.remainder_high. rewrite (quarters_printed _ F), (part_of_all_quarters _ (-1)) by (simpl; lra || lia).
  replace (x - 1 / 2 * IZR q) with (x - IZR q / 2) by field. assert (K := remainder_is_float64 _ F : float64 (x - IZR q / 2)). rewrite (kept _ K), Rplus_0_l. exact (kept _ K).
Qed.
Lemma quadrant_of_float64 : sine_of_half_turns_float64.quadrant x = IZR (q mod 4).
Proof.
  unfold sine_of_half_turns_float64.quadrant, whole_below. rewrite (quarters_printed _ F), (part_of_all_quarters _ (-2)) by (simpl; lra || lia).
  replace (1 / 4 * IZR q) with (IZR q / IZR 4) by (simpl; field). rewrite Zfloor_div by easy. fold q.
  assert (D := Z.div_mod q 4 ltac:(easy)). assert (M := Z.mod_pos_bound q 4 ltac:(easy)).
  assert (W : rounded (4 * IZR (q / 4)) = 4 * IZR (q / 4)).
  { apply kept. destruct digits_of_quarters as (m & k & E & S & K). destruct (Z_le_gt_dec 2 k) as [T|T].
    - assert (W4 : q = (m * 2 ^ (k - 2) * 4)%Z).
      { rewrite E. replace k with (k - 2 + 2)%Z at 1 by ring. rewrite Z.pow_add_r by lia. change (2 ^ 2)%Z with 4%Z. ring. }
      rewrite W4, Z.div_mul by easy. rewrite mult_IZR, (IZR_Zpower radix2) by lia.
      replace (4 * _) with (IZR m * bpow radix2 (k - 2 + 2)) by (rewrite bpow_plus; change (bpow radix2 2) with 4; ring). apply whole_is_float64; [exact S | lia].
    - replace (4 * IZR (q / 4)) with (IZR (q / 4) * bpow radix2 2) by (change (bpow radix2 2) with 4; ring). apply whole_is_float64; [|easy].
      assert (k = 0 \/ k = 1)%Z as [-> | ->] by lia; simpl in E; lia. }
  rewrite W. replace (IZR q - 4 * IZR (q / 4)) with (IZR (q mod 4)) by (rewrite D at 2; rewrite plus_IZR, mult_IZR; ring).
  apply kept. rewrite <- (Rmult_1_r (IZR _)). apply (whole_is_float64 _ 0); lia.
Qed.
Lemma sine_of_float64 : let s := half_turn_polynomials_float64.sine_near (x - IZR q / 2) in let c := half_turn_polynomials_float64.cosine_near (x - IZR q / 2) in
  sine_of_half_turns_float64.sine x 0 = match (q mod 4)%Z with 0%Z => s | 1%Z => c | 2%Z => - s | _ => - c end /\
  cosine_of_half_turns_float64.cosine x 0 = match (q mod 4)%Z with 0%Z => c | 1%Z => - s | 2%Z => - c | _ => s end.
Proof.
  intros s c. unfold sine_of_half_turns_float64.sine, cosine_of_half_turns_float64.cosine.
  change (cosine_of_half_turns_float64.quadrant x) with (sine_of_half_turns_float64.quadrant x). rewrite quadrant_of_float64.
  change (cosine_of_half_turns_float64.sine_near x 0) with (half_turn_polynomials_float64.sine_near (sine_of_half_turns_float64.remainder x 0)).
  change (cosine_of_half_turns_float64.cosine_near x 0) with (half_turn_polynomials_float64.cosine_near (sine_of_half_turns_float64.remainder x 0)).
  change (sine_of_half_turns_float64.sine_near x 0) with (half_turn_polynomials_float64.sine_near (sine_of_half_turns_float64.remainder x 0)).
  change (sine_of_half_turns_float64.cosine_near x 0) with (half_turn_polynomials_float64.cosine_near (sine_of_half_turns_float64.remainder x 0)).
  rewrite (proj1 remainder_of_float64). fold s c. assert (M := Z.mod_pos_bound q 4 ltac:(easy)). assert (K : (q mod 4 = 0 \/ q mod 4 = 1 \/ q mod 4 = 2 \/ q mod 4 = 3)%Z) by lia.
  destruct K as [K|[K|[K|K]]]; rewrite K; repeat destruct Rlt_dec; (split; reflexivity) || lra.
Qed.
End half_turns.

(* Sine and cosine of half-turns of any float64 are within 5/2 2^-53 of the sine and the cosine, *)
Theorem elementary_functions__half_turns (x : R) : float64 x -> Rabs (sine_of_half_turns_float64.sine x 0 - sin (PI * x)) <= 5/2 * (1 / 2 ^ 53) /\ Rabs (cosine_of_half_turns_float64.cosine x 0 - cos (PI * x)) <= 5/2 * (1 / 2 ^ 53).
Proof.
  intro F. set (q := quarters x). destruct (sine_of_float64 x F) as [-> ->]. assert (B := proj2 (remainder_of_float64 x F)). fold q in B |- *. set (r := x - IZR q / 2) in *. assert (N : - (1/4 + 1/2^30) <= r <= 1/4 + 1/2^30) by lra.
  assert (C := elementary_functions__cosine_float64 r N). assert (S : Rabs (half_turn_polynomials_float64.sine_near r - sin (PI * r)) <= 5/2 * (1 / 2 ^ 53)) by (generalize (elementary_functions__sine_float64 r N); lra).
  replace x with (r + IZR q / 2) by (unfold r; ring). destruct (by_quadrant r q) as [-> ->]. assert (M := Z.mod_pos_bound q 4 ltac:(easy)).
  assert (K : (q mod 4 = 0 \/ q mod 4 = 1 \/ q mod 4 = 2 \/ q mod 4 = 3)%Z) by lia. destruct K as [K|[K|[K|K]]]; rewrite K; split; try apply of_opposites; assumption.
Qed.
(* and at every whole number of quarters of a turn they are exact. *)
Theorem elementary_functions__quarters (x : R) (m : Z) : float64 x -> 2 * x = IZR m -> sine_of_half_turns_float64.sine x 0 = sin (PI * x) /\ cosine_of_half_turns_float64.cosine x 0 = cos (PI * x).
Proof.
  intros F H. set (q := quarters x). assert (Q : q = m) by (unfold q, quarters; rewrite H; apply (Zrnd_IZR (Znearest (fun n => negb (Z.even n))))).
  assert (R : x - IZR q / 2 = 0) by (rewrite Q, <- H; field). destruct (sine_of_float64 x F) as [-> ->]. fold q. rewrite R. destruct elementary_functions__zero_float64 as [-> ->].
  replace x with (0 + IZR q / 2) by lra. destruct (by_quadrant 0 q) as [-> ->]. rewrite Rmult_0_r, sin_0, cos_0. split; reflexivity.
Qed.
Lemma half_is_float64 : float64 (1/2).
Proof. replace (1/2) with (IZR 1 * bpow radix2 (-1)) by (simpl; lra). apply whole_is_float64; easy. Qed.
Theorem elementary_functions__half_turns__point : exists x : R, float64 x.
Proof. exists 0. apply generic_format_0. Qed.
Theorem elementary_functions__quarters__point : exists (x : R) (m : Z), float64 x /\ 2 * x = IZR m.
Proof. exists (1/2), 1%Z. split; [apply half_is_float64 | lra]. Qed.
(* They are not those of the number itself, and not each other. *)
Theorem elementary_functions__half_turns__false : ~ forall x, float64 x -> Rabs (sine_of_half_turns_float64.sine x 0 - sin x) <= 5/2 * (1 / 2 ^ 53).
Proof.
  intro H. generalize (H _ half_is_float64) (proj1 (elementary_functions__half_turns _ half_is_float64)). intros X Y.
  apply Rabs_le_between in X. apply Rabs_le_between in Y. assert (sin (1/2) < sin (PI * (1/2)) - 6 * (1 / 2 ^ 53)) by interval. lra.
Qed.
Theorem elementary_functions__quarters__false : ~ forall (x : R) (m : Z), float64 x -> 2 * x = IZR m -> sine_of_half_turns_float64.sine x 0 = cos (PI * x).
Proof.
  intro H. destruct (elementary_functions__quarters 0 0 (generic_format_0 _ _) ltac:(lra)) as [S _]. specialize (H 0 0%Z (generic_format_0 _ _) ltac:(lra)).
  rewrite S, Rmult_0_r, sin_0, cos_0 in H. lra.
Qed.
