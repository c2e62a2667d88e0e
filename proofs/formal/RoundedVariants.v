(* False variants of what float64 loses: 128 times nearer nothing is, where no float64 is so near to the exact value. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Float Float64 RoundedHalfTurns Rounding Binades.
From Formal Require Mutants.
Open Scope R_scope.

(* Between two neighbours, n s and (n + 1) s, there is none. *)
Lemma none_between (x y d s : R) (n e : Z) : (-1074 <= e)%Z -> (2 ^ 52 <= n < 2 ^ 53)%Z -> bpow radix2 e = s -> float64 x -> Rabs (x - y) <= d -> IZR n * s + d < y < (IZR n + 1) * s - d -> False.
Proof.
  intros E N <- F D Y. both_ways D. assert (P := bpow_gt_0 radix2 e). assert (L : IZR (2 ^ 52) <= IZR n) by (apply IZR_le; lia). assert (U : IZR n + 1 <= IZR (2 ^ 53)) by (rewrite <- plus_IZR; apply IZR_le; lia).
  destruct (multiple_in_binade (e + 52) x) as (m & M & _); [lia | exact F | |].
  - replace (e + 52 + 1)%Z with (53 + e)%Z by ring. rewrite (Z.add_comm e), !bpow_plus. change (bpow radix2 52) with (IZR (2 ^ 52)). change (bpow radix2 53) with (IZR (2 ^ 53)). nra.
  - replace (e + 52 - 52)%Z with e in M by ring. assert (n < m < n + 1)%Z; [|lia]. split; apply lt_IZR; rewrite ?plus_IZR; apply Rmult_lt_reg_r with (bpow radix2 e); lra.
Qed.
Lemma some_float64 : float64 0 /\ float64 1 /\ float64 (1/2) /\ float64 (1/4) /\ float64 (134217727/134217728).
Proof.
  split; [apply generic_format_0|]. split; [exact one_is_float64|]. split; [replace (1/2) with (IZR 1 * bpow radix2 (-1)) by (simpl; lra); apply whole_is_float64; easy|].
  split; [replace (1/4) with (IZR 1 * bpow radix2 (-2)) by (simpl; lra) | replace (134217727/134217728) with (IZR 134217727 * bpow radix2 (-27)) by (simpl; lra)]; apply whole_is_float64; easy.
Qed.
Ltac hypothesis_holds := first [assumption | lra | rewrite Rabs_pos_eq; lra | right; lra | left; rewrite Rabs_pos_eq; lra].
Ltac no_float64 n e := let k := eval compute in (Z.to_nat (- e)) in match goal with X : Rabs _ <= _ |- _ => apply (none_between _ _ _ (/ 2 ^ k) n e) with (5 := X); try easy; [simpl; lra | |]; clear X end.

(* A ray down to B hits it at 1 + 2^-53, which is halfway between two float64 numbers. *)
Theorem colour_accuracy__hit_nearer__false : Mutants.colour_accuracy__hit_nearer__false.
Proof.
  intro H. destruct some_float64 as (F0 & F1 & F2 & _). assert (Z := whole_is_float64 (-4503599627370497) (-53) ltac:(easy) ltac:(easy)). simpl in Z. assert (X := H 0 0 1 0 0 _ (1/2) 1 F0 F0 F1 F0 F0 Z F2 F1). do 9 (lapply X; [clear X; intro X | lra]). rewrite Rmax_right in X by lra.
  no_float64 4503599627370496%Z (-52)%Z; [unfold hit_of_b_float64.t_b; destruct both; [apply rounded_is_float64 | apply generic_format_0]|]. hit_of_b.lines. destruct both as [_|[[N|N]|N]]; [rewrite Rmax_right; [split; interval with (i_prec 100)|] | ..]; lra.
Qed.
(* (1, 1, 0) over its length has no float64 so near. *)
Theorem colour_accuracy__normal_nearer__false : Mutants.colour_accuracy__normal_nearer__false.
Proof.
  intro H. destruct some_float64 as (F0 & F1 & _). destruct (H 1 0 0 0 1 0 1) as [X _]; try hypothesis_holds. no_float64 6369051672525772%Z (-53)%Z; [apply rounded_is_float64 | perturbed.lines; split; interval with (i_prec 100)].
Qed.
Theorem colour_accuracy__cosine_nearer__false : Mutants.colour_accuracy__cosine_nearer__false.
Proof.
  intro H. destruct some_float64 as (F0 & F1 & _). assert (X : Rabs (light_direction_float64.mu 0 0 0 1 1 0 1 0 0 - light_direction.mu 0 0 0 1 1 0 1 0 0) <= 45 / 1152921504606846976) by (apply H; hypothesis_holds).
  no_float64 6369051672525772%Z (-53)%Z; [apply rounded_is_float64 | light_direction.lines; split; interval with (i_prec 100)].
Qed.
Theorem colour_accuracy__blinn_nearer__false : Mutants.colour_accuracy__blinn_nearer__false.
Proof.
  intro H. destruct some_float64 as (F0 & F1 & _). assert (X := H 1 0 0 1 1 0 F1 F0 F0 F1 F1 F0 ltac:(hypothesis_holds) ltac:(hypothesis_holds) ltac:(hypothesis_holds) ltac:(hypothesis_holds) ltac:(hypothesis_holds)). no_float64 6369051672525772%Z (-53)%Z.
  - blinn_highlight_float64.lines. destruct Rlt_dec; [unfold Rmax; destruct Rle_dec; [apply rounded_is_float64|]|]; apply generic_format_0.
  - blinn_highlight.lines. destruct Rlt_dec as [_|N]; [|destruct N; interval]. rewrite Rmax_left by interval. split; interval with (i_prec 100).
Qed.
Theorem colour_accuracy__squared_nearer__false : Mutants.colour_accuracy__squared_nearer__false.
Proof.
  intro H. destruct some_float64 as (F0 & F1 & _). assert (X := H 1 1 0 1 1 1 1 F1 F1 F0 F1 F1 F1 F1). do 7 (lapply X; [clear X; intro X | hypothesis_holds]).
  no_float64 6004799503160661%Z (-52)%Z; [apply rounded_is_float64 | squared_highlight.lines; destruct Rlt_dec; [|lra]; rewrite Rmax_right; lra].
Qed.
(* What is halfway between two has none. *)
Theorem colour_accuracy__phong_nearer__false : Mutants.colour_accuracy__phong_nearer__false.
Proof.
  intro H. destruct some_float64 as (F0 & F1 & _ & _ & F). set (w := 134217727/134217728) in *. assert (X : Rabs (phong_highlight_float64.specular_base 1 0 0 w 0 0 0 0 0 w - phong_highlight.specular_base 1 0 0 w 0 0 0 0 0 w) <= 7 / 144115188075855872) by (unfold w in *; apply H; hypothesis_holds).
  no_float64 9007199120523264%Z (-52)%Z; [phong_highlight_float64.lines; unfold Rmax; destruct Rle_dec; [apply rounded_is_float64 | apply generic_format_0] | phong_highlight.lines; rewrite Rmax_right; unfold w; lra].
Qed.
Ltac halfway_share H := destruct some_float64 as (F0 & F1 & _ & _ & F); generalize (H 0 1 1 (134217727/134217728) 0 (134217727/134217728) 0 F0 F1 F1 F F0 F F0); do 8 (let Y := fresh in intro Y; lapply Y; [clear Y | hypothesis_holds]); let Y := fresh in intro Y;
  no_float64 9007199120523264%Z (-53)%Z; [apply rounded_is_float64 | light_term.lines; rewrite Rmax_right; lra].
Theorem colour_accuracy__share_red_nearer__false : Mutants.colour_accuracy__share_red_nearer__false.
Proof. intro H. halfway_share H. Qed.
Theorem colour_accuracy__share_green_nearer__false : Mutants.colour_accuracy__share_green_nearer__false.
Proof. intro H. halfway_share H. Qed.
Theorem colour_accuracy__share_blue_nearer__false : Mutants.colour_accuracy__share_blue_nearer__false.
Proof. intro H. halfway_share H. Qed.
(* So has pi, and pi over the root of 2. *)
Ltac of_slopes n := rewrite (Rabs_pos_eq 1), Rmax_left in * by lra; no_float64 n (-51)%Z; [apply rounded_is_float64|].
Theorem gradient_accuracy__sine_nearer__false : Mutants.gradient_accuracy__sine_nearer__false.
Proof. intro H. destruct some_float64 as (F0 & F1 & F2 & _). destruct (H 0 (1/2) 1 1) as [X _]; try hypothesis_holds. of_slopes 7074237752028440%Z. gradient_sine.lines. split; interval with (i_prec 100). Qed.
Theorem gradient_accuracy__ridges_nearer__false : Mutants.gradient_accuracy__ridges_nearer__false.
Proof.
  intro H. destruct some_float64 as (_ & F1 & F2 & F4 & _). destruct (H (1/4) (1/2) 1 1) as [X _]; try hypothesis_holds. of_slopes 5002241486185188%Z. gradient_ridges.lines. rewrite sign_eq_1 by interval. split; interval with (i_prec 100).
Qed.
Theorem gradient_accuracy__rings_nearer__false : Mutants.gradient_accuracy__rings_nearer__false.
Proof.
  intro H. destruct some_float64 as (F0 & F1 & _). assert (X := H 0 1 F0 F1 ltac:(hypothesis_holds) ltac:(hypothesis_holds) ltac:(hypothesis_holds) ltac:(hypothesis_holds)). rewrite (Rabs_pos_eq (2 * 1)), Rmax_right in X by lra.
  no_float64 7074237752028440%Z (-50)%Z; [apply rounded_is_float64 | gradient_rings.lines; split; interval with (i_prec 100)].
Qed.
(* So has the sine, or the cosine, of an eighth of a turn, an angle of 1 and 2, e, the logarithm of 2, and its root. *)
Ltac computed_is_float64 := repeat match goal with |- context [if ?d then _ else _] => destruct d end; try apply generic_format_opp; apply generic_format_0 || apply rounded_is_float64.
Ltac of_wave H wave lines := intro H; destruct some_float64 as (_ & F1 & _ & F4 & _); assert (S : 7071/10000 <= wave (PI * (1/4 * 1))) by interval;
  assert (X := H (1/4) 1 F4 F1 ltac:(hypothesis_holds) ltac:(hypothesis_holds) ltac:(rewrite Rabs_pos_eq; lra)); apply Rle_trans with (r3 := 33/10 / 2 ^ 60) in X; [|generalize (Rmin_l (33/10) (5 * Rabs (wave (PI * (1/4 * 1))))); lra];
  no_float64 6369051672525772%Z (-53)%Z; [lines; computed_is_float64 | lines; split; interval with (i_prec 100)].
Theorem elementary_functions__sinpi_nearer__false : Mutants.elementary_functions__sinpi_nearer__false.
Proof. of_wave H sin ltac:(unfold enclosed_sine.sine, enclosed_sine_float64.sine, sine_of_half_turns_float64.sine, sine_of_half_turns_float64.sine_near, sine_of_half_turns_float64.cosine_near). Qed.
Theorem elementary_functions__cospi_nearer__false : Mutants.elementary_functions__cospi_nearer__false.
Proof. of_wave H cos ltac:(unfold enclosed_cosine.cosine, enclosed_cosine_float64.cosine, cosine_of_half_turns_float64.cosine, cosine_of_half_turns_float64.sine_near, cosine_of_half_turns_float64.cosine_near). Qed.
Theorem elementary_functions__angle_nearer__false : Mutants.elementary_functions__angle_nearer__false.
Proof.
  intro H. destruct some_float64 as (_ & F1 & _). assert (A : atan2pi 1 2 = atan (1/2) / PI) by (unfold atan2pi, atan2; destruct Rlt_dec; lra). assert (B : 14/100 <= atan (1/2) / PI <= 15/100) by (split; interval).
  assert (X := H 2 1 two_is_float64 F1). rewrite A, (Rabs_pos_eq 2), (Rabs_pos_eq 1), (Rabs_pos_eq (_ / _)), Rmax_left in X by lra. specialize (X ltac:(lra) ltac:(lra)).
  no_float64 5317260203651848%Z (-55)%Z; [unfold enclosed_angle_float64.angle, angle_in_half_turns_float64.angle, angle_in_half_turns_float64.half_plane, angle_in_half_turns_float64.first_quadrant, angle_in_half_turns_float64.first_octant; computed_is_float64 | unfold enclosed_angle.angle; rewrite A; split; interval with (i_prec 100)].
Qed.
Theorem elementary_functions__exp_nearer__false : Mutants.elementary_functions__exp_nearer__false.
Proof.
  intro H. destruct some_float64 as (F0 & F1 & _). assert (X := H 1 0 F1 F0 ltac:(lra) ltac:(lra) ltac:(rewrite Rabs_R0; lra)). rewrite (Rabs_pos_eq (exp _)) in X by (left; apply exp_pos).
  no_float64 6121026514868073%Z (-51)%Z; [unfold exponential_of_sum_float64.exponential; repeat destruct Rlt_dec; try lra; apply rounded_is_float64 | unfold exponential_of_sum.exponential; split; interval with (i_prec 100)].
Qed.
Theorem elementary_functions__log_nearer__false : Mutants.elementary_functions__log_nearer__false.
Proof.
  intro H. assert (B : 69/100 <= ln 2 <= 7/10) by (split; interval). assert (X := H 2 two_is_float64 ltac:(lra) ltac:(lra)). rewrite (Rabs_pos_eq (ln 2)) in X by lra. specialize (X ltac:(lra)).
  no_float64 6243314768165359%Z (-53)%Z; [unfold enclosed_logarithm_float64.logarithm, natural_logarithm_float64.logarithm; computed_is_float64 | unfold enclosed_logarithm.logarithm; split; interval with (i_prec 100)].
Qed.
Theorem elementary_functions__power_nearer__false : Mutants.elementary_functions__power_nearer__false.
Proof.
  intro H. destruct some_float64 as (_ & _ & F2 & _). assert (B : 69/100 <= ln 2 <= 7/10) by (split; interval). assert (X := H 2 (1/2) two_is_float64 F2 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
  rewrite (Rabs_pos_eq (1/2 * ln 2)) in X by lra. assert (R : power 2 (1/2) = exp (1/2 * ln 2)) by (unfold power; destruct Rlt_dec; [reflexivity | lra]). rewrite R, (Rabs_pos_eq (exp _)) in X by (left; apply exp_pos).
  no_float64 6369051672525772%Z (-52)%Z; [unfold raised_float64.power, raised_float64.exponential; computed_is_float64 | unfold raised.power; rewrite R; split; interval with (i_prec 100)].
Qed.
