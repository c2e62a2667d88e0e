(* The kernels' power as float64 carries it out: the exponential of a product that is carried in two. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Float Float64 RoundedHalfTurns Rounding RoundedGradient RoundedAngle RoundedExponential RoundedLogarithm.
Open Scope R_scope.

Section raised_in_two.
Variables x p : R.
Hypothesis Fx : float64 x.
Hypothesis Bx : 0 < x <= IZR (2 ^ 1024 - 2 ^ 971).
Hypothesis Fp : float64 p.
Hypothesis Bp : / 2048 <= p <= 2 ^ 20.
Let y := ln x.
Let t := raised_float64.product x p.
Let e := raised_float64.product_error x p.
Lemma same_logarithm : natural_logarithm_float64.log_whole x = raised_float64.log_whole x /\ natural_logarithm_float64.log_quotient x =
  raised_float64.log_quotient x /\ natural_logarithm_float64.log_rest x = raised_float64.log_rest x.
Proof. repeat split. Qed.
(* The product with the logarithm, in two parts. *)
Lemma product_in_two : let z := p * (Rabs y + / 2 ^ 200) in Rabs (t + e - p * y) <= 26/1000 / 2 ^ 53 * z /\ Rabs e <= 2 / 2 ^ 53 * z.
Proof.
  generalize (parts_of_logarithm x Fx Bx). cbv zeta. destruct same_logarithm as (-> & -> & ->). fold y. intros (S & Bq & Br & E & (k & K & Bk) & (h &
    H & Fh & Oh)).
  set (w := raised_float64.log_whole x) in *. set (q := raised_float64.log_quotient x) in *. set (r := raised_float64.log_rest x) in *.
  assert (t0 : 0 < negligible <= bpow radix2 (-300)) by (split; [apply bpow_gt_0 | apply bpow_le; easy]). simpl bpow in t0. set (Y := Rabs y + / 2 ^
    200). pose proof Rabs_pos y as y0. set (z := p * Y).
  assert (Y0 : 0 < Y) by (unfold Y; lra). assert (z0 : negligible <= z) by (unfold z; apply Rle_trans with (/ 2048 * Y); [unfold Y; lra | apply
    Rmult_le_compat_r; lra]).
  assert (Pp : Rabs p <= p) by (rewrite Rabs_pos_eq; lra). pose proof rounded_is_float64 as Fl.
  set (b := raised_float64.b_high p). assert (G : Prec_gt_0 26) by easy. destruct (high_part p Fp : b = _ /\ generic_format _ _ b) as [Hb Fb].
  assert (Eb : Rabs (p - b) <= / 2 ^ 25 * p).
  { destruct (relative 26 p p b eq_refl) as (d1 & t1 & D1 & T1 & ->); [lra | exact Hb |]. simpl bpow in D1. replace (p - _) with (- (d1 +
    t1) * p) by ring. apply at_the_scale_of; [lra | interval]. }
  assert (b0 : / 4096 <= b) by (both_ways Eb; lra).
  assert (Long : forall f, f = 0 \/ bpow radix2 (-70) <= Rabs f -> b * f = 0 \/ bpow radix2 (-1022) <= Rabs (b * f)).
  { intros f [-> | B]; [left; ring | right]. apply Rle_trans with (bpow radix2 (-12 + -70)); [apply bpow_le; easy|]. rewrite bpow_plus, Rabs_mult.
    apply Rmult_le_compat; try apply bpow_ge_0; [|exact B]. rewrite Rabs_pos_eq; simpl bpow; lra. }
  set (u := raised_float64.of_whole x p). assert (Hw : u = b * w).
  { apply (kept (b * w)). rewrite K. apply short_product; [exact Fb | lia | apply Long]. destruct (no_part k (-16)) as [Z | Z]; [left; exact Z |
    right; eapply Rle_trans; [|exact Z]; apply bpow_le; easy]. }
  set (v := raised_float64.of_quotient x p). assert (Hq : v = b * q).
  { apply (kept (b * q)). rewrite H. destruct (FLX_format_generic radix2 26 h (generic_format_FLX_FLT radix2 (-1074) 26 h Fh)) as [[j i] J N]. unfold
    F2R in J. cbn [Fnum Fexp] in J, N. assert (Dh : 2 * h = IZR j * bpow radix2 (i + 1)) by (rewrite J, bpow_plus; change (bpow radix2 1) with 2;
    ring).
    rewrite Dh. apply short_product; [exact Fb | change (radix_val radix2 ^ 26)%Z with (2 ^ 26)%Z in N; lia | apply Long]. rewrite <- Dh, Rabs_mult,
      (Rabs_pos_eq 2) by lra. destruct Oh as [-> | h0]; [left; ring | right]. generalize (bpow_le radix2 (-70) (-60) ltac:(easy)) (Rabs_pos h). lra. }
  set (o := raised_float64.product_near x p). set (g := raised_float64.product_near_rest x p). assert (Og : o + g = u + v).
  { rewrite <- (sum_in_two u v (Fl _) (Fl _)); [unfold g, raised_float64.product_near_rest; fold v; rewrite (Rplus_comm v); reflexivity|]. rewrite Hw,
    Hq, !Rabs_mult. destruct S as [-> | S]; [left; ring | right; apply Rmult_le_compat_l; [apply Rabs_pos | exact S]]. }
  pose proof Rle_refl (Rabs y) as By1. assert (Bqw : Rabs (q + w) <= 1002/1000 * Y) by (unfold Y; by_sides).
  assert (Bw : Rabs w <= 22/10 * Y) by (unfold Y; by_sides). assert (Bv : Rabs q <= 11/10 * Y) by (unfold Y; lra). clear By1.
  assert (Bb : Rabs b <= 10001/10000 * p) by (rewrite Rabs_pos_eq; by_sides). assert (Bu : Rabs (v + u) <= 1003/1000 * z).
  { rewrite Hq, Hw, <- Rmult_plus_distr_l. generalize (bounded_product _ _ _ _ Bb Bqw). unfold z in *. lra. }
  set (c := raised_float64.b_low p). assert (Ec : Rabs (c - (p - b)) <= / 2 ^ 77 * p).
  { destruct (relative 53 p (p - b) c eq_refl ltac:(lra) eq_refl) as (d1 & t1 & D1 & T1 & ->). simpl bpow in D1. replace (_ - (p - b)) with ((p - b) *
    d1 + t1 * p) by ring. at_most_by Rabs_triang.
    generalize (bounded_product _ _ _ _ Eb D1) (bounded_product _ _ _ _ T1 Pp). lra. }
  assert (Any : forall f X, Rabs f <= X -> Rabs (rounded f - f) <= / 2 ^ 53 * X + / 2 ^ 100 * z).
  { intros f X B. generalize (one_rounding f) underflow_is_negligible. lra. }
  assert (Bc : Rabs c <= / 2 ^ 24 * p) by (generalize (size _ _ _ _ Eb Ec); lra).
  assert (Bcq : Rabs (c * q) <= 2 / 2 ^ 24 * z) by (generalize (bounded_product _ _ _ _ Bc Bv); unfold z in *; lra). assert (Bcw :
    Rabs (c * w) <= 3 / 2 ^ 24 * z) by (generalize (bounded_product _ _ _ _ Bc Bw); unfold z in *; lra).
  assert (Bpr : Rabs (p * r) <= 141/100000 * z) by (generalize (bounded_product _ r _ (141/100000 * Y) Pp ltac:(unfold Y; lra)); unfold z; lra).
  assert (E1 : Rabs ((c - (p - b)) * (q + w)) <= 2 / 2 ^ 77 * z) by (generalize (bounded_product _ _ _ _ Ec Bqw); unfold z in *; lra).
  assert (E2 : Rabs (p * (w + q + r - y)) <= 191/10000 / 2 ^ 53 * z) by (generalize (bounded_product _ (w + q + r - y) _ (191/10000 / 2 ^ 53 * Y) Pp
    ltac:(unfold Y; lra)); unfold z; lra).
  pose proof Any _ _ Bcq as E3. pose proof Any _ _ Bcw as E4. pose proof Any _ _ Bpr as E5. pose proof sum_within v u _ (Fl _) (Fl _) Bu as Eo. change
    (rounded (v + u)) with o in Eo.
  set (f1 := rounded (c * q)) in *. set (f2 := rounded (c * w)) in *. set (f3 := rounded (p * r)) in *. set (rest := raised_float64.product_rest x p).
    set (gained := raised_float64.product_gained x p).
  assert (z1 : 0 < z) by lra. clearbody z Y.
  set (f4 := rounded (f1 + f2)). set (f5 := rounded (f4 + f3)). added f4 f1 f2 (6 / 2 ^ 24 * z). added f5 f4 f3 (142/100000 * z).
  assert (Rabs (f5 + g) <= 143/100000 * z) by (replace g with (v + u - o) by lra; by_sides). added rest f5 g (143/100000 * z). added t o rest
    (1005/1000 * z).
  added gained t (- o) (144/100000 * z). added e rest (- gained) (101/100 / 2 ^ 53 * z).
  split; by_sides.
Qed.
Hypothesis By : - (70799/100) <= p * y <= 70899/100.
Lemma power_near : Rabs (raised_float64.power x p - exp (p * y)) <= (5/2 + 3/100 * Rabs (p * y)) * (1 / 2 ^ 53) * exp (p * y).
Proof.
  destruct product_in_two as [E Be]. set (s := p * y) in *. assert (Z : p * (Rabs y + / 2 ^ 200) <= Rabs s + / 2 ^ 100) by (unfold s; rewrite
    Rabs_mult, (Rabs_pos_eq p); lra).
  assert (Bs : Rabs s <= 709) by (apply Rabs_le; lra). assert (E' : Rabs (t + e - s) <= (26/1000 * Rabs s + 1/1000) / 2 ^ 53) by lra. assert (Be' :
    Rabs e <= 1 / 2 ^ 42) by lra.
  assert (Bt : -708 <= t <= 709) by (clear Be E Z; assert (Rabs (t + e - s) <= 20 / 2 ^ 53) by lra; clear E'; by_sides).
  pose proof elementary_functions__exp t e (rounded_is_float64 _) Bt Be' as X. change (exponential_of_sum_float64.exponential t e) with
    (raised_float64.exponential x p) in X.
  unfold raised_float64.power. destruct Rle_dec as [N|_]; [lra|]. set (f := raised_float64.exponential x p) in *.
  replace (t + e) with (s + (t + e - s)) in X by ring. rewrite exp_plus in X. set (v := exp s) in *. assert (V : 0 < v) by apply exp_pos. set (d := t
    + e - s) in *.
  assert (G : Rabs (exp d - 1 - d) <= 1 / 2 ^ 90).
  { assert (B : Rabs d <= 20 / 2 ^ 53) by lra. clearbody d. clear - B. both_ways B. interval with (i_taylor d, i_degree 4, i_prec 200). }
  set (k := exp d) in *. assert (K : Rabs (k - 1) <= (26/1000 * Rabs s + 2/1000) / 2 ^ 53) by (replace (k - 1) with (k - 1 - d + d) by ring;
    at_most_by Rabs_triang; lra).
  assert (K' : v * k <= 1001/1000 * v) by (rewrite Rmult_comm; apply Rmult_le_compat_r; [lra | generalize (Rle_abs (k - 1));
    lra]).
  replace (f - v) with (f - v * k + v * (k - 1)) by ring. at_most_by Rabs_triang. rewrite (Rabs_mult v), (Rabs_pos_eq v) by lra.
  generalize (Rmult_le_compat_l v _ _ (Rlt_le _ _ V) K). assert (0 <= v * Rabs s) by (apply Rmult_le_pos; [lra | apply Rabs_pos]). nra.
Qed.
End raised_in_two.
(* The power of a float64 above 0 is within (5/2 + 3/100 |p ln x|) 2^-53 of the power, relative to that: it errs like the exponential, and by what the
  logarithm's error becomes. *)
Theorem elementary_functions__power x p : float64 x -> 0 < x <= IZR (2 ^ 1024 - 2 ^ 971) -> float64 p -> / 2048 <= p <= 2 ^ 20 -> - (70799/100) <=
  p * ln x <= 70899/100 -> Rabs (raised_float64.power x p - Rpower x p) <= (5/2 + 3/100 * Rabs (p * ln x)) * (1 / 2 ^ 53) * Rpower x p.
Proof. apply power_near. Qed.
Theorem elementary_functions__power__point : exists x p, float64 x /\ 0 < x <= IZR (2 ^ 1024 - 2 ^ 971) /\ float64 p /\ / 2048 <= p <= 2 ^ 20 /\ -
  (70799/100) <= p * ln x <= 70899/100.
Proof. exists 1, 1. rewrite ln_1. repeat split; try apply one_is_float64; try apply IZR_le; lra || easy. Qed.
(* Base and exponent do not change places. *)
Theorem elementary_functions__power__false : ~ forall x p, float64 x -> 0 < x <= IZR (2 ^ 1024 - 2 ^ 971) -> float64 p -> / 2048 <= p <= 2 ^ 20 -> -
  (70799/100) <= p * ln x <= 70899/100 ->
  Rabs (raised_float64.power x p - Rpower p x) <= (5/2 + 3/100 * Rabs (p * ln x)) * (1 / 2 ^ 53) * Rpower p x.
Proof.
  intro H. assert (P : 0 < 1 <= IZR (2 ^ 1024 - 2 ^ 971)) by (split; [lra | apply IZR_le; easy]). assert (B : - (70799/100) <= 2 * ln 1 <= 70899/100)
    by (rewrite ln_1; lra).
  generalize (H 1 2 one_is_float64 P two_is_float64 ltac:(lra) B) (elementary_functions__power 1 2 one_is_float64 P two_is_float64 ltac:(lra) B).
    rewrite Rpower_1 by lra. unfold Rpower. rewrite ln_1, Rmult_0_r, exp_0, Rabs_R0. intros. by_sides.
Qed.
