(* The kernels' exponential as float64 carries it out: doublings, what remains of the argument in two parts, polynomial. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Formulas Float Float64 RoundedHalfTurns Rounding RoundedGradient RoundedAngle.
Open Scope R_scope.

(* On the reduced argument the polynomial is within 2^-57 of the exponential. *)
Lemma elementary_exponential r : - (3467/10000) <= r <= 3467/10000 -> Rabs (exponential_polynomial.exponential_near r 0 - exp r) <= 1
  / 2 ^ 57.
Proof.
  intro B. exponential_polynomial.lines.
  interval with (i_taylor r, i_degree 18, i_prec 120).
Qed.

Lemma rest_is_float64 p k : float64 p -> Rabs (p - IZR k * bpow radix2 (-15)) < 1/2 -> 1/4 <= Rabs p \/ k = 0%Z -> float64 (p - IZR k * bpow
  radix2 (-15)).
Proof.
  intros F S [B | ->]; [|rewrite Rmult_0_l, Rminus_0_r; exact F]. destruct (multiple_of_power p (-54) F) as [m E]; [simpl; lra|].
  assert (H : p - IZR k * bpow radix2 (-15) = IZR (m - k * 2 ^ 39) * bpow radix2 (-54)) by (rewrite E, minus_IZR, mult_IZR; simpl; lra). rewrite H in
    *. apply whole_is_float64; [|easy].
  apply lt_IZR. rewrite abs_IZR. rewrite Rabs_mult, (Rabs_pos_eq (bpow _ _)) in S by apply bpow_ge_0. simpl in *. lra.
Qed.

Section exponential.
Variables p e : R.
Hypothesis F : float64 p.
Hypothesis B : -708 <= p <= 709.
Hypothesis E : Rabs e <= 1 / 2 ^ 42.
Let scale := 3248660424278399 / 2251799813685248.
Let n := Znearest (fun n => negb (Z.even n)) (rounded (scale * p)).
Let r := p + e - IZR n * ln 2.
Lemma near_doublings : Rabs (IZR n - scale * p) <= 1/2 + 1 / 2 ^ 42 /\ (-1021 <= n <= 1023)%Z.
Proof.
  assert (R : Rabs (rounded (scale * p) - scale * p) <= 1 / 2 ^ 42).
  { eapply Rle_trans; [apply (rounded_error _ 1024); unfold scale; interval | lra]. }
  assert (D : Rabs (IZR n - scale * p) <= 1/2 + 1 / 2 ^ 42).
  { apply through with (rounded (scale * p)); [|exact R]. rewrite Rabs_minus_sym. apply Rle_trans with (/ 2); [apply Znearest_half | lra]. }
  split; [exact D|]. assert (P : -102143/100 <= scale * p <= 10229/10) by (unfold scale; split; lra). both_ways D.
  assert (-1022 < n < 1024)%Z by (split; apply lt_IZR; lra). lia.
Qed.
Lemma doublings_range : -1021 <= IZR n <= 1023.
Proof. destruct near_doublings as [_ N]. split; apply IZR_le, N. Qed.
Lemma doublings_off : Rabs (p - IZR n * ln 2) <= 34658/100000.
Proof.
  destruct near_doublings as [D _]. replace (p - IZR n * ln 2) with (p * (1 - scale * ln 2) - ln 2 * (IZR n - scale * p)) by ring.
  set (d := IZR n - scale * p) in *. clearbody d. both_ways D. unfold scale. interval.
Qed.
Lemma away_high_printed : exponential_of_sum_float64.away_high p = p - IZR n * (22713/32768) /\ Rabs (p - IZR n * (22713/32768)) <= 3481/10000.
Proof.
  assert (S : Rabs (p - IZR n * (22713/32768)) <= 3481/10000).
  { replace (p - _) with (p - IZR n * ln 2 + IZR n * (ln 2 - 22713/32768)) by ring. generalize doublings_off. set (d := p - IZR n * ln 2). intro D.
    generalize doublings_range. clearbody d. generalize (IZR n). intros w W. both_ways D. interval. }
  split; [|exact S]. destruct near_doublings as [D N]. unfold exponential_of_sum_float64.away_high. change (exponential_of_sum_float64.whole p)
    with (IZR n).
  assert (W : IZR n * (22713/32768) = IZR (22713 * n) * bpow radix2 (-15)) by (rewrite mult_IZR; change (bpow radix2 (-15)) with (/ 32768); field).
  assert (K : float64 (IZR n * (22713/32768))) by (rewrite W; apply whole_is_float64; lia).
  rewrite (Rmult_comm (22713/32768)), (kept _ K). apply kept. rewrite W in *. apply rest_is_float64; [exact F | lra|].
  destruct (Rle_lt_dec (1/4) (Rabs p)) as [G|G]; [left; exact G | right]. apply Rabs_def2 in G. both_ways D. unfold scale in D.
  assert (-1 < n < 1)%Z by (split; apply lt_IZR; lra). lia.
Qed.
(* What remains of the argument, in two parts. *)
Lemma away_near : let a := exponential_of_sum_float64.away p e in let b := exponential_of_sum_float64.away_error p e in
  Rabs a <= 3467/10000 /\ Rabs b <= 35/100 / 2 ^ 53 /\ Rabs (a + b - r) <= 7/1000 / 2 ^ 53.
Proof.
  intros a b. destruct away_high_printed as [H S]. set (h := exponential_of_sum_float64.away_high p) in *. set (l :=
    exponential_of_sum_float64.away_low p e).
  set (L := 3373202482714085 / 2361183241434822606848). pose proof doublings_range as W.
  assert (P : Rabs (L * IZR n) <= 1465/1000000) by (generalize W; generalize (IZR n); intros w ?; unfold L; interval). pose proof E as Be. assert (Bl : Rabs
    (L * IZR n - e) <= 147/100000) by by_sides.
  assert (E1 : Rabs (l - (L * IZR n - e)) <= 3/1000 / 2 ^ 53).
  { unfold l, exponential_of_sum_float64.away_low. change (exponential_of_sum_float64.whole p) with (IZR n). fold L.
    eapply Rle_trans; [exact (difference_error _ _ _ _ _ _ _ Bl (rounded_error _ _ P) (no_error e)) | lra]. }
  assert (E2 : Rabs (h - l - r) <= 4/1000 / 2 ^ 53).
  { assert (G : Rabs (IZR n * (ln 2 - 22713/32768 - L)) <= 3/10000 / 2 ^ 53) by (generalize W; generalize (IZR n); intros w ?; unfold L; interval with
    (i_prec 100)).
    unfold r. by_sides. }
  assert (Br : Rabs r <= 34659/100000).
  { pose proof doublings_off. unfold r. by_sides. }
  assert (E3 : Rabs (a - (h - l)) <= 3467/10000 / 2 ^ 53).
  { eapply Rle_trans; [exact (rounded_error _ _ (size _ _ _ _ Br E2)) | lra]. }
  assert (E4 : Rabs (exponential_of_sum_float64.away_gained p e - (h - a)) <= 15/10000 / 2 ^ 53).
  { assert (T : Rabs (h - a) <= 1471/1000000) by by_sides.
    eapply Rle_trans; [exact (rounded_error _ _ T) | lra]. }
  assert (E5 : Rabs (b - (h - a - l)) <= 2/1000 / 2 ^ 53).
  { unfold b, exponential_of_sum_float64.away_error. fold l. assert (T : Rabs (h - a - l) <= 3467/10000 / 2 ^ 53) by by_sides.
    eapply Rle_trans; [eapply difference_error; [exact T | exact E4 | apply no_error] | lra]. }
  repeat split; by_sides.
Qed.
End exponential.

Lemma both_error a ah b bh S ea eb : Rabs (a + b) <= S -> Rabs (ah - a) <= ea -> Rabs (bh - b) <= eb -> Rabs (rounded (ah + bh) - (a + b)) <= (S +
  (ea + eb)) / 2 ^ 53 + 1 / 2 ^ 100 + (ea + eb).
Proof. intros S1 A1 B1. replace (ah + bh) with (ah - - bh) by ring. replace (a + b) with (a - - b) in * by ring. apply difference_error; try
  assumption. apply of_opposites, B1. Qed.
Lemma near_one t : - (3467/10000) <= t <= 3467/10000 -> 7/10 <= exp t <= 15/10.
Proof. split; interval. Qed.

(* What the polynomial loses in float64. *)
Section polynomial.
Variables p e : R.
Let a := exponential_of_sum_float64.away p e.
Let b := exponential_of_sum_float64.away_error p e.
Hypothesis A : - (3467/10000) <= a <= 3467/10000.
Hypothesis B : Rabs b <= 35/100 / 2 ^ 53.
Lemma departure_rounded : Rabs (exponential_of_sum_float64.departure_low p e - (b + exponential_polynomial.departure_low a 0)) <= 31/100 / 2 ^ 53.
Proof.
  unfold exponential_of_sum_float64.departure_low, exponential_polynomial.departure_low, exponential_of_sum_float64.exponential_tail,
    exponential_polynomial.exponential_tail. rewrite Rplus_0_l.
  fold a b. set (zh := exponential_of_sum_float64.away_squared p e). set (z := exponential_polynomial.away_squared a).
  assert (Z : 0 <= z <= 12021/100000).
  { unfold z, exponential_polynomial.away_squared. clearbody a. split; [apply pow2_ge_0 | interval]. }
  assert (Ez : Rabs (zh - z) <= 121/1000 / 2 ^ 53).
  { unfold zh, exponential_of_sum_float64.away_squared. fold a. replace (a * a) with z by (unfold z, exponential_polynomial.away_squared; ring).
    eapply Rle_trans; [apply (rounded_error _ (12021/100000)); apply Rabs_le; lra | lra]. }
  clearbody zh z a b.
  lazymatch goal with |- context [zh * rounded (rounded (rounded (a * ?ph) + rounded (zh * ?qh)) + _)] => lazymatch goal with |- context [z * (a * ?P
    + z * ?Q + _)] =>
    assert (Ep : Rabs (rounded (a * ph) - a * P) <= 14/100 / 2 ^ 53) by (eapply Rle_trans; [find_error | interval]); assert (Eq : Rabs (rounded (zh *
      qh) - z * Q) <= 2/100 / 2 ^ 53) by (eapply Rle_trans; [find_error | interval]);
    assert (Es : Rabs (rounded (rounded (a * ph) + rounded (zh * qh)) - (a * P + z * Q)) <= 23/100 / 2 ^ 53) by (eapply Rle_trans; [eapply both_error;
      [find_bound | exact Ep | exact Eq] | interval]) end end.
  eapply Rle_trans; [eapply both_error; [find_bound | apply no_error | find_error] | interval].
Qed.
Lemma near_rounded : let v := exp a in Rabs (exponential_of_sum_float64.exponential_near p e - (v + b)) <= (v + Rabs (v - 1) + 376/1000) / 2 ^ 53.
Proof.
  intro v. pose proof departure_rounded as M. pose proof elementary_exponential a A as X. fold v in X. pose proof near_one a A as V.
    fold v in V.
  unfold exponential_polynomial.exponential_near, exponential_polynomial.departure in X. set (w := exponential_polynomial.departure_low a 0) in *.
  unfold exponential_of_sum_float64.exponential_near, exponential_of_sum_float64.departure. fold a. set (wh :=
    exponential_of_sum_float64.departure_low p e) in *. clearbody a b v w wh.
  assert (S : Rabs (a + (b + w)) <= Rabs (v - 1) + 1/1000).
  { generalize (Rle_refl (Rabs (v - 1))) B. intros. by_sides. }
  pose proof both_error a a (b + w) wh _ _ _ S (no_error a) M as E1.
  assert (S' : Rabs (a + (b + w) + 1) <= v + 1/1000).
  { pose proof B as Y. by_sides. }
  pose proof sum_error (a + (b + w)) _ 1 _ _ S' E1 as E2. set (near := rounded (_ + 1)) in *. clearbody near.
  both_ways X. both_ways E2. assert (P : Rabs (v - 1) <= 1) by (apply Rabs_le; lra). apply Rabs_le. lra.
Qed.
End polynomial.

Lemma exponential_near_float64 p e : float64 p -> -708 <= p <= 709 -> Rabs e <= 1 / 2 ^ 42 -> let r := p + e - IZR (Znearest (fun n => negb
  (Z.even n)) (rounded (3248660424278399 / 2251799813685248 * p))) * ln 2 in Rabs (exponential_of_sum_float64.exponential_near p e - exp r) <=
  11/5 * (1 / 2 ^ 53) * exp r /\ 1/2 <= exponential_of_sum_float64.exponential_near p e.
Proof.
  intros F B E r. destruct (away_near p e F B E) as (A & C & D). fold r in D. both_ways A. pose proof near_rounded p e A C as N. cbv zeta in N.
  set (a := exponential_of_sum_float64.away p e) in *. set (b := exponential_of_sum_float64.away_error p e) in *. set (near :=
    exponential_of_sum_float64.exponential_near p e) in *.
  pose proof near_one _ A as V.
  assert (G : forall t, Rabs t <= 36/100 / 2 ^ 53 -> Rabs (exp t - 1 - t) <= 1 / 2 ^ 100).
  { intros t T. both_ways T. interval with (i_taylor t, i_degree 4, i_prec 200). }
  assert (Q : Rabs (r - a) <= 36/100 / 2 ^ 53).
  { by_sides. }
  generalize (G _ Q). clear G. replace (exp r) with (exp a * exp (r - a)) by (rewrite <- exp_plus; f_equal; ring). set (t := exp (r - a) - 1 - (r - a)).
  replace (exp (r - a)) with (1 + b - (a + b - r) + t) by (unfold t; ring). intro T. clearbody t near a b r. set (v := exp a) in *. clearbody v. set
    (h := a + b - r) in *. clearbody h.
  assert (I : forall x m y, Rabs x <= m -> 0 <= y -> - (m * y) <= x * y <= m * y).
  { intros x m y K O. both_ways K. split; nra. }
  generalize (I h _ v D ltac:(lra)) (I t _ v T ltac:(lra)) (I b _ v C ltac:(lra)) (I b _ (Rabs (v - 1)) C (Rabs_pos _)). clear I. intros Ih It Ib Ibd.
    both_ways N.
  destruct (Rle_lt_dec 1 v) as [O|O]; [rewrite (Rabs_pos_eq (v - 1)) in * by lra | rewrite (Rabs_left (v - 1)) in * by lra]; (split; [apply
    Rabs_le|]; lra).
Qed.

(* The exponential of a float64 and a correction is within 11/5 2^-53 of the exponential of their sum, relative to that, where it is neither 0 nor infinite.
  *)
Theorem elementary_functions__exp p e : float64 p -> -708 <= p <= 709 -> Rabs e <= 1 / 2 ^ 42 -> Rabs (exponential_of_sum_float64.exponential p e
  - exp (p + e)) <= 11/5 * (1 / 2 ^ 53) * exp (p + e).
Proof.
  intros F B E. destruct (exponential_near_float64 p e F B E) as [N H]. set (n := Znearest _ _) in N. set (near :=
    exponential_of_sum_float64.exponential_near p e) in *.
  destruct (near_doublings p B) as [_ M]. change (-1021 <= n <= 1023)%Z in M.
  assert (X : exp (p + e) = exp (p + e - IZR n * ln 2) * bpow radix2 n) by (rewrite bpow_exp, <- exp_plus; f_equal; change (IZR radix2) with 2; ring).
  assert (Y : exponential_of_sum_float64.exponential p e = near * bpow radix2 n).
  { unfold exponential_of_sum_float64.exponential, power_of_two. fold near. change (exponential_of_sum_float64.whole p) with (IZR n). rewrite
    Zfloor_IZR. repeat destruct Rlt_dec; try lra.
    apply kept, (scaled_float64 near (-1)); [apply rounded_is_float64 | rewrite Rabs_pos_eq; simpl; lra | lia]. }
  rewrite X, Y, <- Rmult_minus_distr_r, Rabs_mult, (Rabs_pos_eq (bpow _ _)), <- Rmult_assoc by apply bpow_ge_0. apply Rmult_le_compat_r; [apply
    bpow_ge_0 | exact N].
Qed.
Theorem elementary_functions__exp__point : exists p e, float64 p /\ -708 <= p <= 709 /\ Rabs e <= 1 / 2 ^ 42.
Proof. exists 0, 0. rewrite Rabs_R0. split; [apply generic_format_0 | lra]. Qed.
Theorem elementary_functions__exp__false : ~ forall p e, float64 p -> -708 <= p <= 709 -> Rabs e <= 1 / 2 ^ 42 ->
  Rabs (exponential_of_sum_float64.exponential p e - exp p) <= 11/5 * (1 / 2 ^ 53) * exp p.
Proof.
  intro H. assert (E : Rabs (1 / 2 ^ 42) <= 1 / 2 ^ 42) by (rewrite Rabs_pos_eq; lra). generalize (H 0 (1 / 2 ^ 42) (generic_format_0 _ _) ltac:(lra)
    E) (elementary_functions__exp 0 (1 / 2 ^ 42) (generic_format_0 _ _) ltac:(lra) E).
  rewrite exp_0, Rplus_0_l. intros X Y. both_ways X. both_ways Y. assert (1 + 9 / 2 ^ 53 < exp (1 / 2 ^ 42) < 2) by
    (split; interval with (i_prec 100)). lra.
Qed.
