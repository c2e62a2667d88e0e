(* The kernels' sine and cosine of half-turns as float64 carries them out: how far each operation leads from the exact polynomial. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Relative.
From Interval Require Import Tactic.
From Formal Require Import Formulas Float Float64 HalfTurns.
Open Scope R_scope.

(* What a size says, both ways. *)
Ltac both_ways H := apply Rabs_le_between in H.
(* x <= z by x <= y, which t says; a product by its factors. *)
Ltac at_most_by t := eapply Rle_trans; [apply t|].
Ltac factors := apply Rmult_le_compat; try apply Rabs_pos.
Ltac by_sides := repeat match goal with B : Rabs _ <= _ |- _ => both_ways B end; try apply Rabs_le; lra.
Lemma through a b c x y : Rabs (a - b) <= x -> Rabs (b - c) <= y -> Rabs (a - c) <= x + y.
Proof. intros A B. replace (a - c) with ((a - b) + (b - c)) by ring. at_most_by Rabs_triang; lra. Qed.
Lemma size a ah A e : Rabs a <= A -> Rabs (ah - a) <= e -> Rabs ah <= A + e.
Proof. intros S E. replace ah with (a + (ah - a)) by ring. at_most_by Rabs_triang; lra. Qed.

(* One rounding: a factor, or below the normal range less than 2^-1074. *)
Lemma rounding x : exists d t, Rabs d <= / 2 ^ 53 /\ Rabs t <= bpow radix2 (-1074) /\ d * t = 0 /\ rounded x = x * (1 + d) + t.
Proof.
  destruct (error_N_FLT radix2 (-1074) 53 ltac:(easy) (fun n => negb (Z.even n)) x) as (d & t & D & T & Z & E). exists d, t. split; [at_most_by D;
    unfold u_ro; simpl; lra|].
  split; [at_most_by T; generalize (bpow_gt_0 radix2 (-1074)); lra | split; [exact Z | exact E]].
Qed.
Lemma one_rounding x : Rabs (rounded x - x) <= / 2 ^ 53 * Rabs x + bpow radix2 (-1074).
Proof.
  destruct (rounding x) as (d & e & D & E & _ & ->). replace (x * (1 + d) + e - x) with (d * x + e) by ring. at_most_by Rabs_triang.
    rewrite Rabs_mult.
  apply Rplus_le_compat; [apply Rmult_le_compat_r; [apply Rabs_pos | exact D] | exact E].
Qed.
(* What underflows is off by far less than 2^-100. *)
Lemma underflow_is_less : 0 <= bpow radix2 (-1074) <= 1 / 2 ^ 100.
Proof. split; [apply bpow_ge_0|]. replace (1 / 2 ^ 100) with (bpow radix2 (-100)) by (simpl; lra). apply bpow_le. easy. Qed.
Lemma rounded_error x X : Rabs x <= X -> Rabs (rounded x - x) <= X / 2 ^ 53 + 1 / 2 ^ 100.
Proof.
  intro B. generalize (one_rounding x) underflow_is_less. lra.
Qed.
Lemma sum_error a ah c S e : Rabs (a + c) <= S -> Rabs (ah - a) <= e -> Rabs (rounded (ah + c) - (a + c)) <= (S + e) / 2 ^ 53 + 1 / 2 ^ 100 + e.
Proof.
  intros B A. replace (ah - a) with (ah + c - (a + c)) in A by ring. apply through with (ah + c); [|exact A]. exact (rounded_error _ _ (size _ _ _
    _ B A)).
Qed.
Lemma minus_error a ah c d S e : c = - d -> Rabs (a + d) <= S -> Rabs (ah - a) <= e -> Rabs (rounded (ah - c) - (a + d)) <= (S + e) / 2 ^ 53 + 1 /
  2 ^ 100 + e.
Proof. intros ->. replace (ah - - d) with (ah + d) by ring. apply sum_error. Qed.
Lemma times_error z zh a ah Z A ez ea : Rabs z <= Z -> Rabs a <= A -> Rabs (zh - z) <= ez -> Rabs (ah - a) <= ea -> Rabs (rounded (zh * ah) - z *
  a) <= (Z + ez) * (A + ea) / 2 ^ 53 + 1 / 2 ^ 100 + (ez * (A + ea) + Z * ea).
Proof.
  intros Bz Ba Ez Ea. generalize (size _ _ _ _ Bz Ez) (size _ _ _ _ Ba Ea). intros Sz Sa. apply through with (zh * ah).
  - apply rounded_error. rewrite Rabs_mult. factors; assumption.
  - replace (_ - _) with ((zh - z) * ah + z * (ah - a)) by ring. at_most_by Rabs_triang. rewrite !Rabs_mult.
    apply Rplus_le_compat; factors; assumption.
Qed.
Lemma no_error a : Rabs (a - a) <= 0.
Proof. rewrite Rminus_diag_eq, Rabs_R0; lra. Qed.

(* Bounds that are not given are found: of a number by interval arithmetic, of an error operation by operation. *)
Ltac find_bound := match goal with |- ?x <= _ => let B := fresh in interval_intro x upper as B; exact B end.
Ltac find_error :=
  lazymatch goal with
  | known : Rabs (?ah - ?a) <= _ |- Rabs (?ah - ?a) <= _ => exact known
  | |- Rabs (rounded (_ + _) - _) <= _ => eapply Rle_trans; [eapply sum_error; [find_bound | find_error] | find_bound]
  | |- Rabs (rounded (_ - _) - _) <= _ => eapply Rle_trans; [eapply minus_error; [field | find_bound | find_error] | find_bound]
  | |- Rabs (rounded (_ * _) - _) <= _ => eapply Rle_trans; [eapply times_error; [find_bound | find_bound | find_error | find_error] | find_bound]
  | |- _ => apply no_error
  end.

Section polynomials.
Variable r : R.
Hypothesis B : - (1/4 + 1/2^30) <= r <= 1/4 + 1/2^30.
Let z := r ^ 2.
Let zh := rounded (r * r).
Lemma z_is : 0 <= z <= 1/16 + 1/2^30 /\ Rabs (zh - z) <= 63 / 1000 / 2 ^ 53.
Proof.
  assert (Q : 0 <= z <= 1/16 + 1/2^30) by (unfold z; split; [apply pow2_ge_0 | interval]). split; [exact Q|]. unfold zh. replace (r * r) with z by
    (unfold z; ring).
  eapply Rle_trans; [apply (rounded_error _ (1/16 + 1/2^30)); apply Rabs_le; lra | interval].
Qed.
Lemma cosine_rounded : Rabs (half_turn_polynomials_float64.cosine_near r - half_turn_polynomials.cosine_near r) <= 989 / 500 / 2 ^ 53.
Proof.
  destruct z_is as [z0 Ez]. unfold half_turn_polynomials_float64.cosine_near, half_turn_polynomials.cosine_near.
  change (half_turn_polynomials_float64.z r) with zh. change (half_turn_polynomials.z r) with z. clearbody zh z.
  eapply Rle_trans; [find_error | interval].
Qed.
Lemma factor_rounded : let f := rounded (half_turn_polynomials_float64.sine_tail r + 884279719003555 / 281474976710656) in let P :=
  half_turn_polynomials.sine_tail r + 884279719003555 / 281474976710656 in
  Rabs (f - P) <= 45/10 / 2 ^ 53 /\ 28/10 <= P <= 315/100.
Proof.
  intros f P. destruct z_is as [z0 Ez]. unfold f, P.
  unfold half_turn_polynomials_float64.sine_tail, half_turn_polynomials.sine_tail. change (half_turn_polynomials_float64.z r) with zh. change
    (half_turn_polynomials.z r) with z.
  clearbody zh z. split; [eapply Rle_trans; [find_error | interval] | split; interval].
Qed.
Lemma sine_rounded : Rabs (half_turn_polynomials_float64.sine_near r - half_turn_polynomials.sine_near r) <= 207 / 100 / 2 ^ 53.
Proof.
  destruct factor_rounded as [E P]. eapply Rle_trans; [eapply (times_error r r _ _ (1/4 + 1/2^30) (315/100)); [| | apply no_error | exact E] | lra];
    apply Rabs_le; lra.
Qed.
(* In float64 the cosine of a reduced argument is within 5/2 2^-53 of the cosine, *)
Lemma elementary_cosine_float64 : Rabs (half_turn_polynomials_float64.cosine_near r - cos (PI * r)) <= 5/2 * (1 / 2 ^ 53).
Proof. eapply Rle_trans; [exact (through _ _ _ _ _ cosine_rounded (elementary_cosine r B)) | lra]. Qed.
(* and the sine within 9/4 2^-53 of the sine, *)
Lemma elementary_sine_float64 : Rabs (half_turn_polynomials_float64.sine_near r - sin (PI * r)) <= 9/4 * (1 / 2 ^ 53).
Proof. eapply Rle_trans; [exact (through _ _ _ _ _ sine_rounded (elementary_sine r B)) | lra]. Qed.
End polynomials.

Lemma rounded_0 : rounded 0 = 0.
Proof. apply round_0. typeclasses eauto. Qed.
Lemma rounded_1 : rounded 1 = 1.
Proof. apply round_generic; [typeclasses eauto|]. change 1 with (bpow radix2 0). apply generic_format_bpow. easy. Qed.

(* and at a whole number of half-turns, where the reduced argument is 0, nothing is rounded: a crease's zero is exact. *)
Lemma elementary_zero_float64 : half_turn_polynomials_float64.sine_near 0 = 0 /\ half_turn_polynomials_float64.cosine_near 0 = 1.
Proof.
  unfold half_turn_polynomials_float64.sine_near, half_turn_polynomials_float64.cosine_near, half_turn_polynomials_float64.z.
  rewrite !Rmult_0_l, !rounded_0, !Rmult_0_l, !rounded_0, Rplus_0_l. split; [reflexivity | exact rounded_1].
Qed.

