(* The kernels' sine and cosine of half-turns of one float64, relative to what they are: near a zero, too. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Float Float64 HalfTurns RoundedHalfTurns Rounding RoundedGradient RoundedFunctions.
Open Scope R_scope.

(* The sine's polynomial is off by at most 2^-53 of its argument: its derivative is by 2^-53. *)
Theorem elementary_functions__sine_relative (r : R) : - (1/4) <= r <= 1/4 -> Rabs (half_turn_polynomials.sine_near r - sin (PI * r)) <= 1 / 2 ^ 53 * Rabs r.
Proof.
  intro B. set (g := fun t => half_turn_polynomials.sine_near t - sin (PI * t)). assert (G : g 0 = 0) by (unfold g; rewrite (proj1 elementary_functions__zero), Rmult_0_r, sin_0; ring).
  replace (_ - _) with (g r - g 0) by (rewrite G; unfold g; ring). rewrite <- (Rminus_0_r r) at 2. evar (h : R -> R). apply (bounded_variation g h). intros t T.
  assert (T' : - (1/4) <= t <= 1/4) by (rewrite !Rminus_0_r in T; apply Rabs_le_between; apply Rabs_le in B; lra). clear T. split.
  - unfold g; half_turn_polynomials.lines. auto_derive; [exact I|]. unfold h. reflexivity.
  - unfold h. clear - T'. interval with (i_taylor t, i_degree 20, i_prec 100).
Qed.
Section reduced.
Variable r : R.
Hypothesis B : - (1/4) <= r <= 1/4.
Lemma factor_rounded : let f := rounded (half_turn_polynomials_float64.sine_tail r + 884279719003555 / 281474976710656) in let P := half_turn_polynomials.sine_tail r + 884279719003555 / 281474976710656 in
  Rabs (f - P) <= 45/10 / 2 ^ 53 /\ 28/10 <= P <= 315/100.
Proof.
  intros f P. assert (N : - (1/4 + 1/2^30) <= r <= 1/4 + 1/2^30) by lra. destruct (z_is r N) as [z0 Ez]. unfold f, P. set (c := 884279719003555 / 281474976710656). set (z := r ^ 2) in *. set (zh := rounded (r * r)) in *.
  unfold half_turn_polynomials_float64.sine_tail, half_turn_polynomials.sine_tail. change (half_turn_polynomials_float64.z r) with zh. change (half_turn_polynomials.z r) with z.
  unfold c. clearbody zh z. split; [eapply Rle_trans; [find_error | interval] | split; interval].
Qed.
Lemma sine_near_relative : r = 0 \/ bpow radix2 (-1020) <= Rabs r -> Rabs (half_turn_polynomials_float64.sine_near r - sin (PI * r)) <= 18/5 * (1 / 2 ^ 53) * Rabs (sin (PI * r)).
Proof.
  intros [-> | U].
  { rewrite (proj1 elementary_functions__zero_float64), Rmult_0_r, sin_0, Rminus_0_r, Rabs_R0. lra. }
  assert (X : Rabs (half_turn_polynomials.sine_near r - sin (PI * r)) <= 1 / 2 ^ 53 * Rabs r) by exact (elementary_functions__sine_relative r B). destruct factor_rounded as [F P].
  unfold half_turn_polynomials_float64.sine_near, half_turn_polynomials.sine_near in *. set (f := rounded (_ + _)) in *. set (w := half_turn_polynomials.sine_tail r + _) in *.
  assert (Uf : unit_roundoff = / 2 ^ 53) by (unfold unit_roundoff; simpl; lra). apply Rabs_le_between in F.
  destruct (standard_model (r * f)) as (d & D & ->).
  { rewrite Rabs_mult, (Rabs_pos_eq f) by lra. generalize (bpow_le radix2 (-1022) (-1020) ltac:(easy)) (Rabs_pos r). nra. }
  rewrite Uf in D. apply Rabs_le_between in D. set (s := sin (PI * r)) in *. assert (O := Rabs_pos r).
  assert (S : 279/100 * Rabs r <= Rabs s).
  { replace s with (r * w - (r * w - s)) by ring. generalize (Rabs_triang_inv (r * w) (r * w - s)). rewrite (Rabs_mult r w), (Rabs_pos_eq w) by lra. nra. }
  apply Rle_trans with (9 / 2 ^ 53 * Rabs r); [|lra].
  replace (_ - s) with (r * (f * (1 + d) - w) + (r * w - s)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  assert (K : Rabs (f * (1 + d) - w) <= 8 / 2 ^ 53) by (apply Rabs_le; split; nra).
  replace (9 / 2 ^ 53 * Rabs r) with (Rabs r * (8 / 2 ^ 53) + 1 / 2 ^ 53 * Rabs r) by field. apply Rplus_le_compat; [apply Rmult_le_compat_l; [exact O | exact K] | exact X].
Qed.
End reduced.

Lemma remainder_not_small (x : R) : float64 x -> x = 0 \/ bpow radix2 (-1020) <= Rabs x -> let r := x - IZR (quarters x) / 2 in r = 0 \/ bpow radix2 (-1020) <= Rabs r.
Proof.
  intros F U r. destruct (Rlt_le_dec (Rabs x) (1/4)) as [S|S].
  - assert (Q : quarters x = 0%Z) by (apply Znearest_imp; apply Rabs_def2 in S; apply Rabs_def1; simpl; lra). replace r with x by (unfold r; rewrite Q; lra). exact U.
  - apply FLT_format_generic in F; [|easy]. destruct F as [[m e] E M _]. unfold F2R in E; cbn [Fnum Fexp] in *.
    assert (K := exponent_at_least m e (-2) M ltac:(rewrite <- E; change (bpow radix2 (-2)) with (/ 4); lra)). set (k := (m * 2 ^ (e + 54) - quarters x * 2 ^ 53)%Z).
    assert (W : r = IZR k * bpow radix2 (-54)).
    { unfold r, k. rewrite minus_IZR, !mult_IZR, (IZR_Zpower radix2), Rmult_minus_distr_r, !Rmult_assoc, <- bpow_plus by lia. replace (e + 54 + -54)%Z with e by ring. rewrite <- E.
      f_equal. change (IZR (2 ^ 53)) with (bpow radix2 53). rewrite <- bpow_plus. change (bpow radix2 (53 + -54)) with (/ 2). reflexivity. }
    destruct (Z.eq_dec k 0) as [Z|Z]; [left; rewrite W, Z; ring | right]. rewrite W, Rabs_mult, (Rabs_pos_eq (bpow _ _)), <- abs_IZR by apply bpow_ge_0.
    assert (1 <= IZR (Z.abs k)) by (apply IZR_le; lia). generalize (bpow_le radix2 (-1020) (-54) ltac:(easy)) (bpow_gt_0 radix2 (-54)). nra.
Qed.
(* Those of a float64 that is not near underflow are within 18/5 2^-53 of the sine and the cosine, relative to them. *)
Theorem elementary_functions__half_turns_relative (x : R) : float64 x -> x = 0 \/ bpow radix2 (-1020) <= Rabs x ->
  Rabs (sine_of_half_turns_float64.sine x 0 - sin (PI * x)) <= 18/5 * (1 / 2 ^ 53) * Rabs (sin (PI * x)) /\ Rabs (cosine_of_half_turns_float64.cosine x 0 - cos (PI * x)) <= 18/5 * (1 / 2 ^ 53) * Rabs (cos (PI * x)).
Proof.
  intros F U. destruct (sine_of_float64 x F) as [-> ->]. assert (B := proj2 (remainder_of_float64 x F)). assert (V := remainder_not_small x F U). cbv zeta in V. set (q := quarters x) in *. set (r := x - IZR q / 2) in *.
  assert (S := sine_near_relative r B V). assert (C : Rabs (half_turn_polynomials_float64.cosine_near r - cos (PI * r)) <= 18/5 * (1 / 2 ^ 53) * Rabs (cos (PI * r))).
  { assert (G : forall t, - (1/4) <= t <= 1/4 -> 7071/10000 <= cos (PI * t)) by (intros; interval). specialize (G r B). rewrite (Rabs_pos_eq (cos _)) by lra.
    generalize (elementary_functions__cosine_float64 r ltac:(lra)). lra. }
  replace x with (r + IZR q / 2) by (unfold r; ring). destruct (by_quadrant r q) as [-> ->]. assert (M := Z.mod_pos_bound q 4 ltac:(easy)).
  assert (K : (q mod 4 = 0 \/ q mod 4 = 1 \/ q mod 4 = 2 \/ q mod 4 = 3)%Z) by lia. destruct K as [K|[K|[K|K]]]; rewrite K, ?Rabs_Ropp; split; try apply of_opposites; assumption.
Qed.
Theorem elementary_functions__sine_relative__point : exists r : R, - (1/4) <= r <= 1/4.
Proof. exists 0. lra. Qed.
Theorem elementary_functions__half_turns_relative__point : exists x : R, float64 x /\ (x = 0 \/ bpow radix2 (-1020) <= Rabs x).
Proof. exists 0. split; [apply generic_format_0 | left; reflexivity]. Qed.
(* Over a whole half-turn the polynomial is not so near; nor is the sine the cosine. *)
Theorem elementary_functions__sine_relative__false : ~ forall r, -1 <= r <= 1 -> Rabs (half_turn_polynomials.sine_near r - sin (PI * r)) <= 1 / 2 ^ 53 * Rabs r.
Proof.
  intro H. generalize (H 1 ltac:(lra)). apply Rlt_not_le. half_turn_polynomials.lines. rewrite Rmult_1_r, sin_PI, Rabs_R1. interval with (i_prec 120).
Qed.
Theorem elementary_functions__half_turns_relative__false : ~ forall x, float64 x -> x = 0 \/ bpow radix2 (-1020) <= Rabs x -> Rabs (sine_of_half_turns_float64.sine x 0 - cos (PI * x)) <= 18/5 * (1 / 2 ^ 53) * Rabs (cos (PI * x)).
Proof.
  intro H. generalize (H 0 (generic_format_0 _ _) (or_introl eq_refl)). destruct (elementary_functions__quarters 0 0 (generic_format_0 _ _) ltac:(lra)) as [-> _].
  rewrite Rmult_0_r, sin_0, cos_0, Rabs_R1, Rabs_left; lra.
Qed.
