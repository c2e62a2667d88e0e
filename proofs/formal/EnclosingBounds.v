(* What the rules of the enclosing machine for the elementary functions share: a bound that becomes a count, and a function's own error. *)

From Coq Require Import Reals Lra.
From Flocq Require Import Core Mult_error.
From Formal Require Import Float Float64 EnclosingRules.
Open Scope R_scope.

(* That a number of the machine encloses an exact one; s is the slack of the counts, which each operation adds to. *)
Definition encloses (s : R) (n : R * R) (x : R) := float64 (fst n) /\ float64 (snd n) /\ 0 <= snd n /\ Rabs (fst n - x) <= s * (snd n / 2 ^ 53).
Definition least := 1 / 2 ^ 1060.
Lemma least_is : least = underflow * 2 ^ 14.
Proof. rewrite underflow_times. apply inverse_power. Qed.
(* An inequality, times what is not negative. *)
Ltac multiplied k H := pose proof (Rmult_le_compat_l k _ _ ltac:(apply Rabs_pos || lra) H).
(* A bound becomes a count exactly. *)
Lemma count_of b : float64 b -> rounded (9007199254740992 * b) = 9007199254740992 * b.
Proof. rewrite Rmult_comm. apply distance_as_count. Qed.
(* What both add up to is made a count; SLACK makes up for the roundings. *)
Lemma made_a_count s v p d : 1 <= s -> float64 v -> 0 <= v -> float64 p -> 0 <= p -> Rabs d + 4 * underflow <= (v + p) * (1 + 10 * unit53) -> let
  c := rounded (9007199254740992 * rounded (rounded (v + p) * SLACK)) in float64 c /\ 0 <= c /\ Rabs d <= s * (1 + 1 / 2 ^ 49) * (c / 2 ^ 53).
Proof.
  intros S V V0 P P0 D. pose proof proj1 underflow_in_least as T. cbv zeta. counts q (v + p). counts b (q * SLACK). rewrite count_of by is_float64.
    split; [rewrite <- count_of by is_float64; is_float64 | split; [lra|]].
  apply Rle_trans with (1 * (1 + 1 / 2 ^ 49) * (9007199254740992 * b / 2 ^ 53)); [|repeat apply Rmult_le_compat_r; lra].
  clearbody b q. in_units.
Qed.
Lemma least_is_float64_too : float64 least.
Proof. unfold least. rewrite inverse_power. apply generic_format_bpow. easy. Qed.
(* A function's own error: a part of the result, and what is lost where that vanishes. *)
Lemma own_error k V f : float64 V -> 0 <= V -> 0 <= k -> let own := rounded (rounded (k * Rabs f) + V) in float64 own /\ 0 <= own /\ (k * Rabs f +
  V) * (1 - 3 * unit53) - 2 * underflow <= own.
Proof.
  intros F P K. pose proof proj1 underflow_in_least as T. cbv zeta. counts o (k * Rabs f). counts w (o + V). split; [is_float64 | split;
    [assumption | in_units]].
Qed.
(* So a result is within a count that is made of its own error, and of how far what it stands for is moved. *)
Lemma moved_and_own s k v f e t : 1 <= s -> 5 / 2 ^ 53 <= k -> float64 v -> 0 <= v -> Rabs (f - e) <= 49 / 10 / 2 ^ 53 * Rabs e + 2 ^ 4 *
  underflow -> Rabs (e - t) <= v + 2 ^ 13 * underflow -> let c := rounded (9007199254740992 * rounded (rounded (v + rounded (rounded (k * Rabs f)
  + least)) * SLACK)) in float64 c /\ 0 <= c /\ Rabs (f - t) <= s * (1 + 1 / 2 ^ 49) * (c / 2 ^ 53).
Proof.
  intros S K F P N M. pose proof proj1 underflow_in_least as T. destruct (own_error k least f) as (Fo & Po & Co); [exact least_is_float64_too | rewrite
    least_is; lra | lra|]. rewrite least_is in Co at 1.
  apply made_a_count; try assumption. multiplied (Rabs f) K. generalize (Rabs_pos f) (Rabs_triang (f - e) (e - t)) (Rabs_triang_inv e f). rewrite
    (Rabs_minus_sym e f). replace (f - e + (e - t)) with (f - t) by ring. in_units.
Qed.
Lemma same s x x' : encloses s (x, 0) x' -> x = x'.
Proof. intros (_ & _ & _ & D). cbn [fst snd] in D. apply Rabs_le_inv in D. lra. Qed.
