(* The rule of the enclosing machine for the power: it lies between its values at four ends, of base and exponent. *)

From Coq Require Import Reals Lra ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Coq Require Import List.
From Formal Require Import Preliminaries Float Float64 RoundedHalfTurns Rounding RoundedGradient RoundedExponential RoundedPower EnclosingRules EnclosingBounds
  EnclosingFunctions.
Open Scope R_scope.
Import ListNotations.

Lemma power_is_float64 x p : float64 (raised_float64.power x p).
Proof. unfold raised_float64.power, raised_float64.exponential. repeat match goal with |- context [if ?d then _ else _] => destruct d end; apply
  rounded_is_float64 || apply generic_format_0. Qed.
Lemma nothing_raised x p : x <= 0 -> raised_float64.power x p = 0 /\ power x p = 0.
Proof. intro X. unfold raised_float64.power, power. destruct Rle_dec, Rlt_dec; lra. Qed.
Lemma logarithm_below x : 0 < x -> ln x <= x - 1.
Proof. intro P. pose proof exp_ineq1_le (ln x) as E. rewrite exp_ln in E by exact P. lra. Qed.
(* The relative error that is charged, as it is rounded. *)
Definition charged e := rounded ((if Rlt_dec e (1 / 2 ^ 72) then 6209337986237071 / 281474976710656 else 3) * (1 / 9007199254740992)).
Lemma charged_is e : 299/100 * unit53 <= charged e /\ (e < 1 / 2 ^ 72 -> 2205/100 * unit53 <= charged e).
Proof.
  pose proof proj1 underflow_in_least as T. pose proof underflow_is_small as W. unfold charged. destruct Rlt_dec; match goal with |- context [rounded ?x] =>
    pose proof counted x ltac:(lra) end; split; intros; in_units.
Qed.
(* A power that vanishes in float64, or nearly. *)
Lemma nearly_vanished x p : float64 x -> 0 < x <= IZR (2 ^ 1024 - 2 ^ 971) -> float64 p -> / 2048 <= p <= 2 ^ 20 -> p * ln x < - (70799/100) -> 0 <=
  raised_float64.power x p <= 3/4 * (1 / 2 ^ 1020).
Proof.
  intros X Bx P Bp B. destruct (product_in_two x p X Bx P Bp) as [E Be]. set (t := raised_float64.product x p) in *. set (r :=
    raised_float64.product_error x p) in *. rewrite Rmult_plus_distr_l, <- (Rabs_pos_eq p), <- Rabs_mult, (Rabs_pos_eq p) in E, Be by lra. rewrite
    (Rabs_left (p * ln x)) in E, Be by lra. set (z := p * ln x) in *.
  both_ways E. both_ways Be. unfold raised_float64.power. destruct Rle_dec as [|_]; [lra|]. unfold raised_float64.exponential. fold t. destruct Rlt_dec as
    [|_]; [exfalso; lra|]. destruct Rlt_dec as [|L]; [lra|].
  assert (F : exponential_of_sum_float64.exponential t r = rounded (raised_float64.exponential_near x p * power_of_two (raised_float64.whole x p))) by
    (unfold exponential_of_sum_float64.exponential; destruct Rlt_dec; [lra|]; destruct Rlt_dec; [lra | reflexivity]).
  pose proof elementary_functions__exp t r (rounded_is_float64 _) ltac:(lra) ltac:(apply Rabs_le; lra) as N. rewrite F in N. clear F. pose proof exp_pos
    (t + r). assert (G : exp (t + r) <= exp (-7077/10)) by (apply exponential_rises; lra). assert (exp (-7077/10) <= 1 / 2 ^ 1020 * (3/5)) by
    interval. both_ways N. split; lra.
Qed.
Lemma power_at_an_end x p : float64 x -> x <= 2 ^ 20 -> float64 p -> / 2048 <= p <= 2 ^ 20 -> (0 < x -> p * ln x <= 50) -> let e :=
  raised_float64.power x p in Rabs (e - power x p) + 2 ^ 4 * underflow <= charged e * Rabs e + 6/10 * (299/100 * unit53 * Rabs e) + 1 / 2 ^ 1020.
Proof.
  intros X U P Bp Bz. cbv zeta. pose proof proj1 underflow_in_least as T. pose proof proj2 vanishing as V. set (v := 1 / 2 ^ 1020) in *. set (e :=
    raised_float64.power x p). destruct (charged_is e) as [C1 C2].
  assert (T0 : 0 <= Rabs e) by apply Rabs_pos. destruct (Rle_lt_dec x 0) as [N|N]; [destruct (nothing_raised x p N) as [E ->]; unfold e; rewrite E,
    Rminus_0_r, Rabs_R0; lra|].
  specialize (Bz N). assert (Most : 2 ^ 20 <= IZR (2 ^ 1024 - 2 ^ 971)) by (rewrite (pow_IZR 2 20); apply IZR_le; vm_compute; discriminate). unfold power.
  destruct Rlt_dec as [_|]; [|lra]. assert (Bx : 0 < x <= IZR (2 ^ 1024 - 2 ^ 971)) by lra. assert (t0 : 0 < Rpower x p) by apply exp_pos. multiplied
    (Rabs e) C1.
  destruct (Rlt_le_dec (p * ln x) (- (70799/100))) as [B|B].
  - destruct (nearly_vanished x p X Bx P Bp B) as [E0 E1]. fold e v in E0, E1. assert (Rpower x p <= v * (3/5)).
    { apply Rle_trans with (exp (-7077/10)); [apply exponential_rises; lra | unfold v; interval]. }
    rewrite (Rabs_pos_eq e) in * by exact E0. assert (Rabs (e - Rpower x p) <= 3/4 * v) by (apply Rabs_le; lra). unfold unit53 in *. nra.
  - pose proof elementary_functions__power x p X Bx P Bp ltac:(lra) as E. fold e in E. set (t := Rpower x p) in *. assert (K : forall c, Rabs
      (p * ln x) <= c -> Rabs (e - t) <= (5/2 + 3/100 * c) * unit53 * t).
    { intros c L. at_most_by E. apply Rmult_le_compat_r; [lra|]. unfold unit53. lra. }
    destruct (Rle_lt_dec (-50) (p * ln x)) as [S|S].
    + specialize (K 50 ltac:(apply Rabs_le; lra)). both_ways K. rewrite (Rabs_pos_eq e) in * by in_units. assert (Rabs (e - t) <= 4 * unit53 * t) by
        (apply Rabs_le; in_units). in_units.
    + specialize (K (70799/100) ltac:(apply Rabs_le; lra)). assert (t <= 92/100 * (1 / 2 ^ 72)) by (apply Rle_trans with (exp (-50)); [apply
        exponential_rises; lra | interval]). both_ways K. assert (e < 1 / 2 ^ 72) by in_units. specialize (C2 ltac:(assumption)). multiplied (Rabs e) C2.
      rewrite (Rabs_pos_eq e) in * by in_units. assert (Rabs (e - t) <= 23745/1000 * unit53 * t) by (apply Rabs_le; in_units). in_units.
Qed.
Lemma power_rises x z p : x <= z -> 0 <= p -> power x p <= power z p.
Proof. intros L P. unfold power. repeat destruct Rlt_dec; try lra; [apply Rle_Rpower_l; lra | left; apply exp_pos]. Qed.
(* In its exponent a power rises, or falls. *)
Lemma power_between x p y q : p <= y <= q -> (power x p <= power x y \/ power x q <= power x y) /\ (power x y <= power x p \/ power x y <= power x q).
Proof.
  intro L. unfold power. destruct Rlt_dec; [|split; left; apply Rle_refl]. destruct (Rle_lt_dec 0 (ln x)); split; [left | right | right | left]; apply
    exponential_rises; nra.
Qed.
Lemma nowhere_further k ends : Forall (fun n => fst n = 0) ends -> furthest 0 k 0 ends = 0.
Proof.
    unfold furthest. induction 1 as [|n l E _ IH]; cbn [map fold_left]; [reflexivity|]. assert (Z : charge k 0 (fst n) = 0) by (unfold charge; rewrite
    E, Rabs_R0, Rmult_0_r, rounded_0, Rplus_0_r; apply rounded_0). rewrite Z, E, Rminus_0_r, rounded_0, Rabs_R0, Rplus_0_r, rounded_0. destruct
    Rlt_dec; exact IH.
Qed.
Definition raised_at x y := (raised_float64.power x y, power x y).
(* What is printed, by these names; of a free exponent, which is exact, there is one end. *)
Definition count_of_power (free : bool) x ex y ey := let x1 := rounded (x - reach x ex) in let x2 := rounded (x + reach x ex) in let r := if free
  then 0
  else reach y ey in let y1 := rounded (y - r) in let y2 := rounded (y + r) in let V := if Rlt_dec 0 x2 then 1 / 2 ^ 1020 else 0 in rounded
  (9007199254740992 * rounded (rounded ((if Rbar_lt_dec (Finite (rounded (rounded (ROUNDING * ex) + rounded (ROUNDING * ey)))) p_infty then furthest
  (raised_float64.power x y) charged V [raised_at x1 y1; raised_at x1 y2; raised_at x2 y1; raised_at x2 y2] else real p_infty) + charge charged V
  (raised_float64.power x y)) * SLACK)).
Definition power_allowed (x ex y ey : R) := x >= 0 /\ y * (x + ex / 4503599627370496 - 1) <= 32 /\ (10 ^ 285 * Rabs (x + ex) >= 1 \/ x + ex = 0) /\
  1024 *
  y >= 1 /\ y <= 524288 /\ ey <= 2251799813685248 * y.
Lemma power_rule free s x ex x' y ey y' : 1 <= s -> s <= 1 + 3 / 2 ^ 22 -> encloses s (x, ex) x' -> encloses s (y, ey) y' -> power_allowed x ex y ey
  -> x'
  >= 0 -> (free = true -> ey = 0) -> y' > 0 /\ encloses (s * (1 + 1 / 2 ^ 49)) (raised_float64.power x y, count_of_power free x ex y ey) (power x'
    y').
Proof.
  intros S1 S2 (X & Ex & Px & Dx) (Y & Ey & Py & Dy) (X0 & H & N & L & U & M) X0' F. cbn [fst snd] in *. unfold count_of_power. destruct Rbar_lt_dec
    as [_|I']; [|destruct (I' I)]. pose proof proj1
    underflow_in_least as T. pose proof underflow_is_small as W.
  destruct (reached s x ex S1 S2 Px) as [Rx Mx]. destruct (reached s y ey S1 S2 Py) as [Ry My]. specialize (Rx x' Dx). specialize (Ry y' Dy). assert
    (P : 0 <= y) by lra. rewrite
    (Rabs_pos_eq y) in * by exact P.
  set (r := if free then 0 else reach y ey). assert (By' : rounded (y - r) <= y' <= rounded (y + r) /\ 0 <= r <= reach y ey).
  { unfold r. destruct free; [|in_units]. specialize (F eq_refl). subst ey. rewrite Rminus_0_r, Rplus_0_r, kept by assumption. both_ways Dy. lra. }
  pose proof counted (y + r) ltac:(in_units) as Cy. pose proof counted (y - r) ltac:(in_units) as By. set (y1 := rounded (y - r)) in *. set (y2 :=
    rounded (y + r)) in *.
  assert (Y1 : / 2048 <= y1) by in_units. assert (Y2 : y2 <= 126/100 * y) by in_units. destruct By' as [By' _]. split; [lra | split;
    [apply power_is_float64|]]. cbn [fst snd].
  destruct (not_tiny _ N) as [Z|G].
    { assert (x = 0) by lra. assert (ex = 0) by lra. subst x ex. both_ways Dx. assert (x' = 0) by lra. subst x'. assert (Q : reach 0 0 = 0) by (unfold
    reach; rewrite
    Rmult_0_r, rounded_0, Rabs_R0, Rmult_0_r, rounded_0, Rplus_0_r, rounded_0, Rmult_0_l; apply rounded_0). rewrite Q, Rplus_0_r, Rminus_0_r, rounded_0.
    destruct (Rlt_dec 0 0) as [I'|_]; [lra|]. destruct (nothing_raised 0 y (Rle_refl 0)) as [-> _]. destruct (nothing_raised 0 y' (Rle_refl 0)) as [_ ->].
    rewrite nowhere_further by (repeat apply Forall_cons; try apply Forall_nil; apply nothing_raised; lra). unfold charge. rewrite Rabs_R0, Rmult_0_r,
    rounded_0, Rplus_0_r, rounded_0, Rplus_0_r, rounded_0, Rmult_0_l, rounded_0, Rmult_0_r, rounded_0, Rminus_0_r, Rabs_R0. split; [apply generic_format_0 |
    lra]. }
  rewrite (Rabs_pos_eq x), (Rabs_pos_eq (x + ex)) in * by lra. change (bpow radix2 (-969)) with (bpow radix2 (Z.of_nat 105 - 1074)) in G. rewrite <-
    underflow_times in G.
  pose proof counted (x + reach x ex) ltac:(lra) as Cx. set (x1 := rounded (x - reach x ex)) in *. set (x2 := rounded (x + reach x ex)) in *.
  assert (Bx : x1 <= x' <= x2) by lra. destruct (Rlt_dec 0 x2) as [_|N']; [|lra].
  assert (Wx : x2 - 1 <= x + ex / 4503599627370496 - 1 + x / 2 ^ 40 + underflow * 2 ^ 7) by in_units. clear Rx Ry Mx My Cx Cy By.
  assert (Top : y2 * (x2 - 1) <= 50).
  { destruct (Rle_lt_dec x2 1) as [K|K]; [nra|]. apply Rle_trans with (126/100 * (y * (x + ex / 4503599627370496 - 1 + x / 2 ^ 40 + underflow * 2 ^ 7))).
    - rewrite <- Rmult_assoc. apply Rmult_le_compat; lra.
    - assert (0 <= y * ex) by is_not_negative. multiplied y W. lra. }
  assert (X2 : x2 <= 2 ^ 20) by (destruct (Rle_lt_dec x2 1); [lra|]; assert (/ 2048 * (x2 - 1) <= y2 * (x2 - 1)) by (apply Rmult_le_compat_r; lra); lra).
  assert (End : forall a b, float64 a -> a <= x2 -> float64 b -> y1 <= b <= y2 -> let e := raised_float64.power a b in Rabs (e -
    power a b) + 2 ^ 4 * underflow <= charged e * Rabs e + 6/10 * (299/100 * unit53 * Rabs e) + 1 / 2 ^ 1020).
  { intros a b Fa La Fb Lb. apply power_at_an_end; try assumption; try lra. intro Pa. pose proof logarithm_below a Pa. destruct (Rle_lt_dec x2 1);
    [assert (b * ln a <= b * 0) by (apply Rmult_le_compat_l; lra); lra|]. apply Rle_trans with (b * (x2 - 1)); [apply Rmult_le_compat_l; lra|]. apply
    Rle_trans with (2 := Top). apply Rmult_le_compat_r; lra. }
  apply monotone_rule with (299/100 * unit53); try apply vanishing; try apply power_is_float64; try apply charged_is; [exact S1 | lra | in_units | | |].
  - assert (0 <= 299/100 * unit53 * Rabs (raised_float64.power x y)) by is_not_negative. repeat apply Forall_cons; try apply Forall_nil; (split; [apply
      power_is_float64|]); cbn [raised_at fst snd]; (eapply Rle_trans; [apply End; apply rounded_is_float64 || lra | lra]).
  - destruct (proj1 (power_between x1 y1 y' y2 By')); pose proof power_rises x1 x' y' ltac:(lra) ltac:(lra); [left | right; left]; cbn [raised_at snd]; lra.
  - destruct (proj2 (power_between x2 y1 y' y2 By')); pose proof power_rises x' x2 y' ltac:(lra) ltac:(lra); [right; right; left | right; right; right;
      left]; cbn [raised_at snd]; lra.
Qed.
Theorem enclosing_rules__power : Statements.enclosing_rules__power.
Proof.
  red. intros. destruct (power_rule false slack x x_error x_exact y y_error y_exact) as (P & _ & Q); repeat split; assumption || discriminate ||
    apply Q.
Qed.
