(* The rules of the enclosing machine, as it carries them out: what they count bounds how far a result is off. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Relative Plus_error Mult_error Div_sqrt_error.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Float Float64 RoundedHalfTurns Rounding.
Open Scope R_scope.

(* One rounding takes 2^-53 of a result, and below the normal range less than 2^-1074; what is lost there has a count of its own. *)
Definition unit53 := 1 / 2 ^ 53.
Definition underflow := bpow radix2 (-1074).
(* By ROUNDING a count becomes a bound: it makes up for the slack of counts, and for one more rounding; SLACK for a bound's own. *)
Definition ROUNDING := 1048577 / 9444732965739290427392.
Definition SLACK := 562949953421313 / 562949953421312.
Ltac in_units := unfold ROUNDING, SLACK, unit53 in *; lra.
(* How large a sum is. *)
Ltac sizes := repeat match goal with H : Rabs _ <= _ |- _ => both_ways H end; try apply Rabs_le; in_units.
Lemma inverse_power n : 1 / 2 ^ n = bpow radix2 (- Z.of_nat n).
Proof. rewrite bpow_opp, bpow_powerRZ, <- pow_powerRZ. apply Rmult_1_l. Qed.
Lemma least_is_float64 : float64 (1 / 2 ^ 1007).
Proof. rewrite inverse_power. apply generic_format_bpow. easy. Qed.
Lemma underflow_times n : underflow * 2 ^ n = bpow radix2 (Z.of_nat n - 1074).
Proof. unfold Z.sub. rewrite bpow_plus, (bpow_powerRZ _ (Z.of_nat n)), <- pow_powerRZ. apply Rmult_comm. Qed.
Lemma underflow_in_least : 0 < underflow /\ underflow * 2 ^ 67 <= 1 / 2 ^ 1007.
Proof. split; [apply bpow_gt_0|]. rewrite inverse_power, underflow_times. apply Rle_refl. Qed.
Lemma underflow_is_small : underflow <= 1 / 2 ^ 200.
Proof. rewrite inverse_power. apply bpow_le. easy. Qed.

Lemma rounded_below x y : rounded x < rounded y -> x < y.
Proof. intro L. apply Rnot_le_lt. intro G. apply Rlt_not_le in L. apply L. apply round_le; [typeclasses eauto..| exact G]. Qed.
Lemma own_rounding x : Rabs (rounded x - x) <= (1 + 4 * unit53) * unit53 * Rabs (rounded x) + underflow.
Proof.
  destruct (rounding x) as (d & e & D & E & Z & R). rewrite R. replace (x * (1 + d) + e - x) with (x * d + e) by ring.
  at_most_by Rabs_triang. apply Rplus_le_compat; [|exact E]. both_ways D.
  apply Rmult_integral in Z. destruct Z as [-> | ->].
  - rewrite Rmult_0_r, Rabs_R0. apply Rmult_le_pos; [in_units | apply Rabs_pos].
  - rewrite Rplus_0_r, !Rabs_mult, (Rabs_pos_eq (1 + d)) by lra. assert (Rabs d <= unit53) by (unfold unit53; apply Rabs_le; lra).
    generalize (Rabs_pos x). unfold unit53 in *. nra.
Qed.
Lemma own_rounding_of_sum a b : float64 a -> float64 b -> Rabs (rounded (a + b) - (a + b)) <= unit53 * Rabs (rounded (a + b)).
Proof.
  intros A B. destruct (FLT_plus_error_N_round_ex radix2 (-1074) 53 (fun n => negb (Z.even n)) a b A B) as (d & D & E).
  assert (E' : a + b = rounded (a + b) * (1 + d)) by exact E. rewrite E' at 2. replace (_ - _) with (- (rounded (a + b) * d)) by ring. rewrite
    Rabs_Ropp, Rabs_mult, Rmult_comm.
  apply Rmult_le_compat_r; [apply Rabs_pos | at_most_by D; unfold u_ro, unit53; simpl; lra].
Qed.
(* So a count, which is not negative, loses no more than that. *)
Lemma counted_sum a b : float64 a -> float64 b -> 0 <= a -> 0 <= b -> (a + b) * (1 - unit53) <= rounded (a + b).
Proof.
  intros A B P Q. generalize (own_rounding_of_sum a b A B) (not_negative_rounded (a + b) ltac:(lra)). intros O N. rewrite (Rabs_pos_eq (rounded _)) in
    O by exact N.
  both_ways O. unfold unit53 in *. nra.
Qed.
Lemma rounding_error x : Rabs (rounded x - x) <= unit53 * Rabs x + underflow.
Proof. generalize (one_rounding x). unfold unit53, underflow. lra. Qed.
Lemma counted x : 0 <= x -> x * (1 - unit53) - underflow <= rounded x <= x * (1 + unit53) + underflow.
Proof. intro P. generalize (rounding_error x). rewrite (Rabs_pos_eq x) by exact P. intro O. both_ways O. lra. Qed.
Lemma less_of_squares x y : 0 <= y -> x * x <= y * y -> x <= y.
Proof. nra. Qed.
Ltac is_float64 := first [assumption | apply rounded_is_float64 | apply generic_format_abs; is_float64 | apply generic_format_bpow; easy].
Ltac is_not_negative := solve [assumption | apply Rabs_pos | apply sqrt_pos | apply Rle_0_sqr | apply not_negative_rounded; is_not_negative | apply
  Rmult_le_pos; is_not_negative | apply Rplus_le_le_0_compat; is_not_negative | in_units].
(* Names the rounding of what is not negative, and says what is known of it. *)
Ltac counts q x := assert (0 <= x) by is_not_negative; assert (0 <= rounded x) by is_not_negative;
  lazymatch x with ?a + ?b => pose proof (counted_sum a b ltac:(is_float64) ltac:(is_float64) ltac:(is_not_negative) ltac:(is_not_negative)) | _ =>
    pose proof (counted x ltac:(assumption)) end; set (q := rounded x) in *.
Ltac is_count := split; [is_float64 | split; [assumption|]].
Ltac rounds q x := assert (0 <= x) by is_not_negative; assert (0 <= rounded x) by is_not_negative; pose proof (counted x ltac:(assumption)); set (q :=
  rounded x) in *.

(* What is moved by m counts, of which each is a slack more, and rounded once to a result of size t, is within c. *)
Lemma enough s m t c d lost : 1 <= s -> 0 <= t -> 0 <= lost -> m + (1 + 4 * unit53) * t + lost * 2 ^ 53 <= (1 + 1 / 2 ^ 49) * c -> Rabs d <= s *
  (m / 2 ^ 53) + ((1 + 4 * unit53) * unit53 * t + lost) -> Rabs d <= s * (1 + 1 / 2 ^ 49) * (c / 2 ^ 53).
Proof.
  intros S T L E. apply Rmult_le_compat_l with (r := s) in E; [|lra]. assert (K : 0 <= (s - 1) * ((1 + 4 * unit53) * t + lost * 2 ^ 53)) by (apply
    Rmult_le_pos; [lra | in_units]).
  in_units.
Qed.

Theorem enclosing_rules__sum : Statements.enclosing_rules__sum.
Proof.
  intros s x ex x' y ey y' S1 S2 X Ex Px Dx Y Ey Py Dy. enclosed_sum_float64.lines.
  pose proof own_rounding_of_sum x y X Y as O. set (t := rounded (x + y)) in *.
  counts e (ex + ey). counts c (e + Rabs t). is_count.
  apply enough with (ex + ey) (Rabs t) 0; try lra; [apply Rabs_pos | generalize (Rabs_pos t); in_units|].
  pose proof Rabs_pos t as T. sizes.
Qed.

Lemma bound_of s e : 1 <= s -> s <= 1 + 3 / 2 ^ 22 -> 0 <= e -> s * (e / 2 ^ 53) * (1 + 4 * unit53) <= ROUNDING * e * (1 - 4 * unit53) /\ s * (e /
  2 ^ 53) - 2 * underflow <= rounded (ROUNDING * e).
Proof.
  intros S1 S2 E. assert (M : s * e <= (1 + 3 / 2 ^ 22) * e) by nra. generalize (counted (ROUNDING * e)). in_units.
Qed.
(* How far a product moves where its factors do. *)
Lemma product_moved s x ex x' y ey y' : 1 <= s -> s <= 1 + 3 / 2 ^ 22 -> float64 y -> 0 <= ex -> Rabs (x - x') <= s * (ex / 2 ^ 53) -> 0 <= ey ->
  Rabs (y - y') <= s * (ey / 2 ^ 53) -> ex <= 2 ^ 60 -> let m := rounded (rounded (Rabs x * ey) + rounded (rounded (Rabs y + rounded (ROUNDING *
  ey)) * ex)) in 0 <= m /\ Rabs (x * y - x' * y') <= s * (m / 2 ^ 53) * (1 + 4 * unit53) + 2 ^ 9 * underflow.
Proof.
  intros S1 S2 Y Px Dx Py Dy L. pose proof proj1 underflow_in_least as T. cbv zeta. destruct (bound_of s ey S1 S2 Py) as [_ B]. pose proof
    Rabs_triang_inv y' y as Sy. rewrite (Rabs_minus_sym y' y) in Sy.
  counts z (ROUNDING * ey). counts most (Rabs y + z). set (Y1 := Rabs y + s * (ey / 2 ^ 53)) in *.
  counts a (Rabs x * ey). counts b (most * ex). counts m (a + b). split; [assumption|].
  assert (W : Y1 * ex * (1 - unit53) - 2 * underflow * 2 ^ 60 <= most * ex).
  { assert (W : (Y1 * (1 - unit53) - 2 * underflow) * ex <= most * ex) by (apply Rmult_le_compat_r; [exact Px | unfold Y1 in *; in_units]). assert
    (underflow * ex <= underflow * 2 ^ 60) by (apply Rmult_le_compat_l; lra). lra. }
  replace (x * y - x' * y') with (x * (y - y') + y' * (x - x')) by ring.
  assert (M : Rabs (x * (y - y') + y' * (x - x')) <= s * ((Rabs x * ey + Y1 * ex) / 2 ^ 53)).
  { replace (s * _) with (Rabs x * (s * (ey / 2 ^ 53)) + Y1 * (s * (ex / 2 ^ 53))) by field. at_most_by Rabs_triang. rewrite !Rabs_mult. apply
    Rplus_le_compat;
    [apply Rmult_le_compat_l; [apply Rabs_pos | exact Dy] | factors; unfold Y1; lra]. }
  assert (K : (Rabs x * ey + Y1 * ex) / 2 ^ 53 <= m / 2 ^ 53 * (1 + 4 * unit53) + 511 * underflow) by in_units.
  apply Rmult_le_compat_l with (r := s) in K; [|lra]. assert (s * underflow <= (1 + 3 / 2 ^ 22) * underflow) by (apply Rmult_le_compat_r; lra). lra.
Qed.
Theorem enclosing_rules__product : Statements.enclosing_rules__product.
Proof.
  intros s x ex x' y ey y' S1 S2 X Ex Px Dx Y Ey Py Dy Lx Ly. enclosed_product_float64.lines. fold ROUNDING. destruct (product_moved s x ex x' y
    ey y') as [Bm M]; try assumption. set (m := rounded (rounded (_ * ey) + _)) in *.
  pose proof own_rounding (x * y) as O. set (t := rounded (x * y)) in *. destruct underflow_in_least as [T L]. set (least := 1 / 2 ^ 1007) in *. assert
    (F : float64 least) by exact least_is_float64. clearbody least.
  counts o (Rabs t + least). counts c (m + o). is_count.
  apply enough with (m * (1 + 4 * unit53)) (Rabs t) (2 ^ 10 * underflow); try lra; [apply Rabs_pos | generalize (Rabs_pos t); in_units|].
  sizes.
Qed.

Lemma root_moved a b : 0 <= a -> 0 <= b -> Rabs (sqrt a - sqrt b) * sqrt a <= Rabs (a - b) /\ Rabs (sqrt a - sqrt b) <= sqrt (Rabs (a - b)).
Proof.
  intros A B. generalize (sqrt_pos a) (sqrt_pos b) (sqrt_sqrt a A) (sqrt_sqrt b B). intros P Q Ea Eb. assert (E : a - b = (sqrt a - sqrt b) * (sqrt a
    + sqrt b)) by lra.
  assert (R : Rabs (a - b) = Rabs (sqrt a - sqrt b) * (sqrt a + sqrt b)) by (rewrite E, Rabs_mult, (Rabs_pos_eq (_ + _)) by lra; reflexivity).
  pose proof Rabs_pos (sqrt a - sqrt b) as T. split; [nra|]. apply Rsqr_incr_0_var; [|apply sqrt_pos]. unfold Rsqr at 2. rewrite sqrt_sqrt by apply
    Rabs_pos. rewrite R. apply Rmult_le_compat_l; [exact T|].
  unfold Rabs. destruct Rcase_abs; lra.
Qed.
Lemma own_rounding_of_root x : float64 x -> Rabs (rounded (sqrt x) - sqrt x) <= unit53 * sqrt x /\ Rabs (rounded (sqrt x) - sqrt x) <= (1 + 4 *
  unit53) * unit53 * rounded (sqrt x).
Proof.
  intro F. destruct (sqrt_error_N_FLT_ex radix2 53 (fun n => negb (Z.even n)) ltac:(easy) (-1074) ltac:(easy) x F) as (d & D & E). pose proof
    sqrt_pos x as S. assert (A : Rabs (rounded (sqrt x) - sqrt x) <= unit53 * sqrt x).
  { assert (G : rounded (sqrt x) = sqrt x * (1 + d)) by exact E. rewrite G. replace (_ - _) with (d * sqrt x) by ring. rewrite Rabs_mult, (Rabs_pos_eq
    (sqrt x)) by exact S. apply Rmult_le_compat_r; [exact S|].
    at_most_by D. unfold u_ro, unit53. simpl. interval with (i_prec 200). }
  split; [exact A|]. at_most_by A. both_ways A. in_units.
Qed.
Lemma root_of_one : let K := sqrt (1 / 2 ^ 53) * 2 ^ 53 in 0 < K /\ K * (1 + 1 / 2 ^ 26) <= 398065740123893 / 4194304.
Proof. split; interval with (i_prec 100). Qed.
Lemma not_near_zero x : float64 x -> 0 < x -> underflow <= sqrt x / 2 ^ 200.
Proof.
  intros F P. assert (L : underflow <= x) by (apply (generic_format_ge_bpow radix2 (FLT_exp (-1074) 53)); [intro; apply Z.le_max_r | exact P | exact
    F]). destruct underflow_in_least as [T S].
  assert (underflow * (underflow * 2 ^ 400) <= underflow * 1) by (apply Rmult_le_compat_l; lra). assert (underflow * 2 ^ 200 <= sqrt x); [|lra]. apply
    less_of_squares; [apply sqrt_pos | rewrite sqrt_sqrt; lra].
Qed.
Theorem enclosing_rules__root : Statements.enclosing_rules__root.
Proof.
  intros s x e x' S1 S2 X E P D X0 X0'. enclosed_root_float64.lines. destruct underflow_in_least as [T _].
  set (r := rounded (sqrt x)). assert (R0 : 0 <= r) by apply not_negative_rounded, sqrt_pos. destruct (own_rounding_of_root x X) as [A O]. fold r in
    A, O.
  destruct (root_moved x x' ltac:(lra) ltac:(lra)) as [M1 M2]. split; [exact X0'|].
  destruct Rlt_dec as [L|_].
  - assert (Xp : 0 < x) by (apply Rnot_le_lt; intro; replace x with 0 in L by lra; rewrite Rmult_0_l, rounded_0 in L; lra).
    assert (Q0 : 0 < sqrt x) by apply sqrt_lt_R0, Xp. assert (Rp : 0 < r) by (clear O; sizes).
    assert (K0 : 0 <= e / r) by (apply Rmult_le_pos; [assumption | left; apply Rinv_0_lt_compat, Rp]). counts k (e / r). counts c (k + r). is_count.
    apply enough with (e / r * (1 + unit53)) r 0; try lra; [generalize (not_near_zero x X Xp); both_ways A; in_units|].
    assert (V : Rabs (sqrt x - sqrt x') <= s * (e / r * (1 + unit53) / 2 ^ 53)); [|sizes].
    apply Rmult_le_reg_r with (sqrt x); [exact Q0|]. at_most_by M1. at_most_by D. replace (_ * sqrt x) with (s * ((e /
      r * ((1 + unit53) * sqrt x)) / 2 ^ 53)) by (field; lra).
    apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_r; [lra|]. replace e with (e / r * r) at 1 by (field; lra). apply Rmult_le_compat_l; [exact
      K0|]. both_ways A. lra.
  - destruct root_of_one as [Kp Kc]. set (K := sqrt (1 / 2 ^ 53) * 2 ^ 53) in *. set (w := 398065740123893 / 4194304) in *.
    assert (W : 0 <= sqrt e) by apply sqrt_pos. assert (Q : sqrt e * (1 - unit53) <= rounded (sqrt e) /\ underflow * 2 ^ 200 <= sqrt e \/ sqrt e = 0).
    { destruct (Rle_lt_or_eq_dec 0 e P) as [Ep|Ez]; [left | right; rewrite <- Ez; apply sqrt_0]. destruct (own_rounding_of_root e E) as [C _].
      both_ways C. generalize (not_near_zero e E Ep). lra. }
    assert (Wp : 1 <= w) by (unfold w; lra). counts k (rounded (sqrt e) * w). counts c (k + r). is_count.
    apply enough with (sqrt e * K) r 0; try lra.
    + assert (Z : sqrt e * K <= (1 + unit53) * k).
      { destruct Q as [[Q Y]|Q]; [|rewrite Q; in_units]. assert (G1 : sqrt e * (K * (1 + 1 / 2 ^ 26)) <= sqrt e * w) by (apply Rmult_le_compat_l;
        assumption).
        assert (G2 : sqrt e * (1 - unit53) * w <= rounded (sqrt e) * w) by (apply Rmult_le_compat_r; lra). assert (G3 : sqrt e * 1 <= sqrt e * w) by
          (apply Rmult_le_compat_l; assumption).
        clearbody k w K. in_units. }
      in_units.
    + assert (V : Rabs (sqrt x - sqrt x') <= s * (sqrt e * K / 2 ^ 53)); [|sizes]. at_most_by M2. eapply Rle_trans; [apply
      sqrt_le_1_alt; exact D|].
      replace (s * (e / 2 ^ 53)) with (s * (e * (1 / 2 ^ 53))) by field. rewrite sqrt_mult, sqrt_mult by lra. replace (sqrt e * K / 2 ^ 53) with (sqrt
        e * sqrt (1 / 2 ^ 53)) by (unfold K; field).
      apply Rmult_le_compat_r; [apply Rmult_le_pos; apply sqrt_pos|]. rewrite <- (sqrt_square s) at 2 by lra. apply sqrt_le_1_alt. nra.
Qed.

Theorem enclosing_rules__quotient : Statements.enclosing_rules__quotient.
Proof.
  intros s x ex x' y ey y' S1 S2 X Ex Px Dx Y Ey Py Dy U G. enclosed_quotient_float64.lines. fold ROUNDING.
  destruct underflow_in_least as [T L]. pose proof underflow_is_small as Ts. assert (Tl : underflow * (2 ^ 960 * 2) <= 1 / 2 ^ 100) by lra. pose
    proof least_is_float64 as F. set (least := 1 / 2 ^ 1007) in *. clearbody least.
  destruct (bound_of s ey S1 S2 Py) as [_ B]. pose proof own_rounding (ROUNDING * ey) as Oz. counts z (ROUNDING * ey). rewrite (Rabs_pos_eq z) in Oz by
    assumption. both_ways Oz. assert (N : / 2 ^ 59 - 4 * underflow <= Rabs y - z) by in_units.
  pose proof own_rounding_of_sum (Rabs y) (- z) ltac:(is_float64) ltac:(apply generic_format_opp; is_float64) as Ol. change (Rabs y + - z) with (Rabs y
    - z) in Ol.
  pose proof not_negative_rounded (Rabs y - z) ltac:(lra) as L0. set (l := rounded (Rabs y - z)) in *. assert (Fl : float64 l) by is_float64. rewrite
    (Rabs_pos_eq l) in Ol by exact L0. both_ways Ol.
  assert (Ll : / 2 ^ 60 <= l) by (clearbody l z; in_units). assert (Lu : l <= 2 ^ 960 * 2) by (clearbody l z; in_units).
  assert (Sy : l * (1 - 2 * unit53) <= Rabs y') by (generalize (Rabs_triang_inv y y'); clearbody l z; in_units).
  destruct (Rlt_dec 0 l) as [Lp|]; [|lra]. set (J := 1 / l). assert (Jl : J * l = 1) by (unfold J; field; lra). assert (Jp : 0 < J) by (unfold J,
    Rdiv; rewrite Rmult_1_l; apply Rinv_0_lt_compat, Lp).
  assert (Ju : J <= 2 ^ 60) by (apply Rmult_le_reg_r with l; [exact Lp | rewrite Jl; lra]).
  assert (Jt : underflow <= J / 2 ^ 100).
  { apply Rmult_le_reg_r with l; [exact Lp|]. replace (J / 2 ^ 100 * l) with (J * l / 2 ^ 100) by field. rewrite Jl. eapply Rle_trans; [apply
    Rmult_le_compat_l; [lra | exact Lu] | exact Tl]. }
  counts i J.
  assert (Y0 : y <> 0) by (intro E; rewrite E, Rabs_R0 in *; lra). assert (Y0' : y' <> 0) by (intro E; rewrite E, Rabs_R0 in Sy; unfold unit53 in *;
    nra).
  pose proof own_rounding (x / y) as O. set (t := rounded (x / y)) in *. pose proof Rabs_pos t as T0. assert (Ht : Rabs (x / y) <= Rabs t + ((1 + 4 *
    unit53) * unit53 * Rabs t + underflow)) by (generalize (Rabs_triang_inv (x / y) t); rewrite (Rabs_minus_sym (x / y) t); lra).
  counts most (Rabs t + least).
  assert (Hs : Rabs (x / y) <= most * (1 + 3 * unit53)) by (clearbody most t; in_units).
  counts w (most * ey). counts v (ex + w).
  set (E := ex + most * ey). assert (E0 : 0 <= E) by (unfold E; lra). assert (Ve : E * (1 - 22 / 10 * unit53) - 2 * underflow <= v) by (unfold E;
    clearbody w v most; in_units).
  counts p (v * i). counts c (p + most). assert (EJ : 0 <= E * J) by (apply Rmult_le_pos; lra).
  assert (VI : E * J * (1 - 4 * unit53) - 2 ^ 62 * underflow <= v * i).
  { apply Rle_trans with (v * (J * (1 - 12 / 10 * unit53))); [|apply Rmult_le_compat_l; [assumption | clearbody i; in_units]].
    apply Rle_trans with ((E * (1 - 22 / 10 * unit53) - 2 * underflow) * (J * (1 - 12 / 10 * unit53))); [|apply Rmult_le_compat_r; [in_units | exact
      Ve]].
    assert (underflow * J <= underflow * 2 ^ 60) by (apply Rmult_le_compat_l; lra). assert (0 <= underflow * J) by (apply Rmult_le_pos; lra).
      clearbody E. in_units. }
  split; [exact Y0' | is_count].
  apply enough with (E * J * (1 + 7 * unit53)) (Rabs t) underflow; try lra; [set (K := v * i) in *; clearbody K p c most t E J; in_units|].
  replace (t - x' / y') with ((t - x / y) + ((x - x') + x / y * (y' - y)) / y') by (field; split; assumption). at_most_by Rabs_triang.
  assert (Moved : Rabs (((x - x') + x / y * (y' - y)) / y') <= s * (E * J * (1 + 7 * unit53) / 2 ^ 53)); [|lra].
  assert (Ay : 0 < Rabs y') by (apply Rabs_pos_lt, Y0'). unfold Rdiv at 1. rewrite Rabs_mult, Rabs_inv. apply Rmult_le_reg_r with (Rabs y'); [exact
    Ay|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  apply Rle_trans with (s * (E * (1 + 3 * unit53) / 2 ^ 53)).
  - at_most_by Rabs_triang. rewrite Rabs_mult, (Rabs_minus_sym y' y). assert (M : Rabs (x / y) * Rabs (y - y') <= most * (1 + 3 * unit53) * (s *
    (ey / 2 ^ 53))) by
    (factors; assumption).
    assert (0 <= s * ex) by (apply Rmult_le_pos; lra). unfold E. clearbody most. in_units.
  - rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|]. replace (E * J * (1 + 7 * unit53) / 2 ^ 53 * Rabs y') with (E * (J * Rabs y' * (1 + 7 *
    unit53)) / 2 ^ 53) by field. apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_l; [exact E0|].
    assert (J * (l * (1 - 2 * unit53)) <= J * Rabs y') by (apply Rmult_le_compat_l; lra). unfold unit53 in *. nra.
Qed.

(* A comparison that its bounds leave apart is that of the exact numbers. *)
Lemma decided_apart s a ea a' b eb b' : 1 <= s -> s <= 1 + 3 / 2 ^ 22 -> float64 a -> float64 ea -> 0 <= ea -> Rabs (a - a') <= s * (ea / 2 ^ 53)
  -> float64 b -> float64 eb -> 0 <= eb -> Rabs (b - b') <= s * (eb / 2 ^ 53) -> rounded (rounded (ea + eb) * ROUNDING) < Rabs (rounded (a - b))
  \/ rounded (ea + eb) = 0 -> a < b <-> a' < b'.
Proof.
  intros S1 S2 A Ea Pa Da B Eb Pb Db H. pose proof counted_sum ea eb Ea Eb Pa Pb as C. set (e := rounded (ea + eb)) in *. both_ways Da. both_ways Db.
    destruct H as [H|H].
  - assert (G : e * ROUNDING < Rabs (a - b)).
    { unfold rounded in H at 2. rewrite <- round_NE_abs in H by typeclasses eauto. apply rounded_below. exact H. }
    assert (M : s * (ea + eb) <= (1 + 3 / 2 ^ 22) * (ea + eb)) by (apply Rmult_le_compat_r; lra). assert (K : s * (ea / 2 ^ 53) + s * (eb / 2 ^ 53) <
      Rabs (a - b)) by (clearbody e; in_units).
    revert K. unfold Rabs. destruct Rcase_abs; intro K; split; lra.
  - assert (ea = 0) by in_units. assert (eb = 0) by in_units. subst ea eb. split; lra.
Qed.
(* A distance becomes a count exactly. *)
Lemma distance_as_count t : float64 t -> rounded (t * 9007199254740992) = t * 9007199254740992.
Proof.
  intro F. apply round_generic; [typeclasses eauto|]. replace 9007199254740992 with (bpow radix2 53) by (simpl; lra). apply mult_bpow_pos_exact_FLT;
    [exact F | easy].
Qed.
(* Where it is open which of two numbers is chosen, the count covers both, whichever is and whichever should be. *)
Definition open_count (x ex y ey : R) := rounded (rounded (rounded (Rabs (rounded (x - y)) * 9007199254740992) + ex) + ey).
Lemma open_covers s x ex x' y ey y' (is_first should : bool) : 1 <= s -> float64 x -> float64 ex -> 0 <= ex -> Rabs (x - x') <= s * (ex / 2 ^ 53)
  -> float64 y -> float64 ey -> 0 <= ey -> Rabs (y - y') <= s * (ey / 2 ^ 53) -> let c := open_count x ex y ey in float64 c /\ 0 <= c /\ Rabs ((if
  is_first then x else y) - (if should then x' else y')) <= s * (1 + 1 / 2 ^ 49) * (c / 2 ^ 53).
Proof.
  intros S1 X Ex Px Dx Y Ey Py Dy. cbv zeta. unfold open_count. pose proof own_rounding_of_sum x (- y) X ltac:(apply generic_format_opp; exact Y) as O.
    change (x + - y) with (x - y) in O. set (t :=
    rounded (x - y)) in *. pose proof Rabs_pos t as T.
  pose proof distance_as_count (Rabs t) ltac:(is_float64) as F. rewrite F. assert (Ft : float64 (Rabs t * 9007199254740992)) by (rewrite <- F;
    is_float64).
  counts k (Rabs t * 9007199254740992 + ex). counts c (k + ey). is_count.
  assert (Ty : Rabs (x - y) <= (1 + unit53) * Rabs t) by (generalize (Rabs_triang_inv (x - y) t); rewrite (Rabs_minus_sym (x - y) t); in_units).
  apply enough with (Rabs t * (1 + unit53) * 2 ^ 53 + ex + ey) 0 0; try lra; [clearbody k c t; in_units|].
  assert (Q : 0 <= (s - 1) * (Rabs t * (1 + unit53))) by (apply Rmult_le_pos; [lra | in_units]). assert (0 <= s * ex) by (apply Rmult_le_pos; lra).
    assert (0 <= s * ey) by (apply Rmult_le_pos; lra).
  assert (Near : forall v w w' e, Rabs (v - w) <= (1 + unit53) * Rabs t -> Rabs (w - w') <= s * (e / 2 ^ 53) -> s * e <= s * ex + s * ey -> Rabs (v
    - w') <= s * ((Rabs t * (1 + unit53) * 2 ^ 53 + ex + ey) / 2 ^ 53) + ((1 + 4 * unit53) * unit53 * 0 + 0)).
  { intros v w w' e V W L. clearbody t. sizes. }
  assert (Zr : forall r, Rabs (r - r) <= (1 + unit53) * Rabs t) by (intro r; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; apply Rmult_le_pos;
    [in_units | exact T]).
  destruct is_first, should; [apply Near with x ex | apply Near with y ey | apply Near with x ex | apply Near with y ey]; try
    assumption; try apply Zr; try lra.
  rewrite Rabs_minus_sym. exact Ty.
Qed.
Theorem enclosing_rules__selection : Statements.enclosing_rules__selection.
Proof.
  intros s a ea a' b eb b' x ex x' y ey y' S1 S2 A Ea Pa Da B Eb Pb Db X Ex Px Dx Y Ey Py Dy. enclosed_selection_float64.lines. fold ROUNDING.
  pose proof decided_apart s a ea a' b eb b' S1 S2 A Ea Pa Da B Eb Pb Db as H.
  assert (Wx : s * (ex / 2 ^ 53) <= s * (1 + 1 / 2 ^ 49) * (ex / 2 ^ 53)) by (assert (0 <= s * ex) by (apply Rmult_le_pos; lra); lra).
  assert (Wy : s * (ey / 2 ^ 53) <= s * (1 + 1 / 2 ^ 49) * (ey / 2 ^ 53)) by (assert (0 <= s * ey) by (apply Rmult_le_pos; lra); lra).
  destruct (either _ _) as [D|_].
  - specialize (H D). destruct (Rlt_dec a b), (Rlt_dec a' b'); try (exfalso; tauto); repeat split; try assumption; lra.
  - pose proof fun is_first should => open_covers s x ex x' y ey y' is_first should S1 X Ex Px Dx Y Ey Py Dy as W. destruct (Rlt_dec a b), (Rlt_dec a'
      b'); apply (W true true) || apply (W true false) || apply (W false true) || apply (W false false).
Qed.

(* A whole number that is found of x: it changes only where a multiple of a half is in reach. *)
Lemma whole_rule s x e x' away y y' n : 1 <= s -> s <= 1 + 3 / 2 ^ 22 -> float64 e -> 0 <= e -> Rabs (x - x') <= s * (e / 2 ^ 53) -> e <= 2 ^ 60
  -> y - y' = IZR n -> Rabs (y - y') <= Rabs (x - x') + 1 -> (x = x' \/ Rabs (x - x') < away -> y = y') -> let b := rounded (ROUNDING * e) in let
  c := rounded (9007199254740992 * (if both (Rle_dec (rounded away) (rounded (b * (562949953421313 / 562949953421312)))) (Rlt_dec 0 e) then
  rounded (1 + whole_below b) else whole_below b)) in float64 c /\ 0 <= c /\ Rabs (y - y') <= s * (1 + 1 / 2 ^ 49) * (c / 2 ^ 53).
Proof.
  intros S1 S2 E P D U N G H b c. assert (M : s * e <= (1 + 3 / 2 ^ 22) * e) by (apply Rmult_le_compat_r; assumption).
  assert (B0 : 0 <= b) by (apply not_negative_rounded; in_units). assert (B1 : b <= bpow radix2 8).
  { apply round_le_generic; [typeclasses eauto | typeclasses eauto | apply generic_format_bpow; easy | unfold ROUNDING; simpl; lra]. }
  set (w := Zfloor b). assert (W : (0 <= w <= 256)%Z) by (split; [apply Zfloor_lub, B0 | rewrite <- (Zfloor_IZR 256); apply Zfloor_le; exact B1]).
  assert (small : forall m j, (0 <= m <= 257)%Z -> (0 <= j)%Z -> rounded (IZR m * bpow radix2 j) = IZR m * bpow radix2 j) by (intros; apply kept,
    whole_is_float64; lia).
  assert (plain : forall m, (0 <= m <= 257)%Z -> rounded (IZR m) = IZR m) by (intros m L; rewrite <- (Rmult_1_r (IZR m)); exact (small m 0%Z L
    ltac:(easy))).
  assert (K : exists m : Z, (0 <= m <= 257)%Z /\ c = IZR m * bpow radix2 53 /\ Rabs (y - y') <= IZR m).
  { unfold c. change (whole_below b) with (IZR w). rewrite (Rmult_comm 9007199254740992). change 9007199254740992 with (bpow radix2 53). destruct
    (both _ _) as [_|Far].
    - exists (1 + w)%Z. rewrite <- plus_IZR, plain, small by lia. split; [lia | split; [reflexivity|]].
      rewrite N, <- abs_IZR in *. apply IZR_le. destruct (Z_le_gt_dec (Z.abs n) 1) as [|L]; [lia|]. assert (Q : (Z.abs n - 1 <= w)%Z); [|lia].
      assert (T : IZR (Z.abs n - 1) <= ROUNDING * e) by (rewrite minus_IZR; in_units). assert (V : (Z.abs n - 1 <= 256)%Z) by (apply le_IZR; unfold
        ROUNDING in T; lra).
      apply Zfloor_lub. rewrite <- plain by lia. apply round_le; [typeclasses eauto..| exact T].
    - exists w. rewrite small by lia. split; [lia | split; [reflexivity|]]. assert (Y : y = y'); [apply H | rewrite Rminus_diag_eq, Rabs_R0 by exact
      Y; apply IZR_le; lia].
      destruct Far as [Far|Far]; [right | left].
      + apply Rnot_le_lt in Far. apply Rle_lt_trans with (ROUNDING * e); [in_units|]. apply rounded_below. eapply Rle_lt_trans; [|exact Far]. fold b.
        rewrite <- (kept b) at 1 by (apply rounded_is_float64).
        apply round_le; [typeclasses eauto..|]. lra.
      + replace e with 0 in D by lra. unfold Rdiv in D. rewrite Rmult_0_l, Rmult_0_r in D. generalize (Rabs_pos (x - x')). intro. apply
        Rminus_diag_uniq. destruct (Req_dec (x - x') 0) as [|Z]; [assumption|]. apply Rabs_pos_lt in Z. lra. }
  destruct K as (m & Bm & -> & L). assert (0 <= IZR m) by (apply IZR_le; lia). split; [apply whole_is_float64; lia | split; [apply Rmult_le_pos;
    [assumption | apply bpow_ge_0]|]].
  at_most_by L. replace (IZR m * bpow radix2 53 / 2 ^ 53) with (IZR m) by (simpl; lra). assert (0 <= (s - 1) * IZR m) by (apply
    Rmult_le_pos; lra). lra.
Qed.
Lemma nearest_half x : Rabs (x - rint x) <= 1 / 2.
Proof. generalize (Znearest_half (fun n => negb (Z.even n)) x). unfold rint. lra. Qed.
Lemma nearest_is_nearest x m : Rabs (x - rint x) <= Rabs (x - IZR m).
Proof.
  pose proof nearest_half x as H. unfold rint in *. set (n := Znearest _ x) in *. destruct (Z.eq_dec m n) as [->|D]; [apply Rle_refl|].
  assert (G : 1 <= Rabs (IZR n - IZR m)) by (rewrite <- minus_IZR, <- abs_IZR; apply IZR_le; lia). generalize (Rabs_triang (x - IZR m) (- (x - IZR
    n))). rewrite Rabs_Ropp.
  replace (x - IZR m + - (x - IZR n)) with (IZR n - IZR m) by ring. lra.
Qed.
Lemma rounded_abs x : Rabs (rounded x) = rounded (Rabs x).
Proof. symmetry. apply round_NE_abs. typeclasses eauto. Qed.
Theorem enclosing_rules__floor : Statements.enclosing_rules__floor.
Proof.
  intros s x e x' S1 S2 X E P D U. enclosed_floor_float64.lines. fold ROUNDING. change (IZR (Int_part x')) with (whole_below x'). rewrite
    rounded_abs.
  unfold whole_below at 5. unfold whole_below at 5. apply whole_rule with x x' (Zfloor x - Zfloor x')%Z; try assumption; [symmetry; apply minus_IZR |
    |].
  - generalize (Zfloor_lb x) (Zfloor_ub x) (Zfloor_lb x') (Zfloor_ub x') (Rle_abs (x - x')) (Rabs_maj2 (x - x')). intros. apply Rabs_le. lra.
  - intros [->|N]; [reflexivity|]. f_equal. symmetry. apply Zfloor_imp. rewrite plus_IZR. generalize (nearest_is_nearest x (Zfloor x))
    (nearest_is_nearest x (Zfloor x + 1)) (Zfloor_lb x) (Zfloor_ub x) (Rle_abs (x - x')) (Rabs_maj2 (x - x')).
    rewrite plus_IZR. intros A B L H. rewrite (Rabs_pos_eq (x - IZR (Zfloor x))) in A by lra. rewrite (Rabs_left (x - (_ + 1))) in B by lra. lra.
Qed.
Theorem enclosing_rules__nearest : Statements.enclosing_rules__nearest.
Proof.
  intros s x e x' S1 S2 X E P D U. enclosed_nearest_float64.lines. fold ROUNDING. pose proof nearest_half x as H.
  assert (F : rounded (x - rint x) = x - rint x).
  { apply kept. generalize (what_is_left_is_float64 x 1 X one_is_float64). unfold Rdiv. rewrite Rinv_1, !Rmult_1_r. trivial. }
  rewrite F, rounded_abs. apply whole_rule with x x' (Znearest (fun n => negb (Z.even n)) x - Znearest (fun n => negb (Z.even n)) x')%Z; try
    assumption; [symmetry; apply minus_IZR | |].
  - generalize (nearest_half x') (Rle_abs (x - x')) (Rabs_maj2 (x - x')). intros H' A B. both_ways H. both_ways H'. apply Rabs_le. lra.
  - intros [->|N]; [reflexivity|]. unfold rint in *. f_equal. symmetry. apply Znearest_imp. revert N H. unfold Rabs. repeat destruct Rcase_abs; lra.
Qed.

(* So 2^28 operations, one after the other, leave a slack that the rules allow, and that ROUNDING makes up for. *)
Lemma slack_of_counts n : INR n <= 2 ^ 28 -> (1 + 1 / 2 ^ 49) ^ n <= 1 + 3 / 2 ^ 22 /\ (1 + 1 / 2 ^ 49) ^ n / 2 ^ 53 <= ROUNDING.
Proof.
  intro N. assert (P : 0 < 1 + 1 / 2 ^ 49) by lra. assert (B : (1 + 1 / 2 ^ 49) ^ n <= 1 + 3 / 2 ^ 22); [|split; [exact B | in_units]].
  rewrite <- Rpower_pow by exact P. unfold Rpower. apply Rle_trans with (exp (2 ^ 28 * ln (1 + 1 / 2 ^ 49))); [|interval with (i_prec 100)].
  assert (L : INR n * ln (1 + 1 / 2 ^ 49) <= 2 ^ 28 * ln (1 + 1 / 2 ^ 49)) by (apply Rmult_le_compat_r; [interval with (i_prec 100) | exact N]).
  destruct (Rle_lt_or_eq_dec _ _ L) as [S|S]; [left; apply exp_increasing, S | right; rewrite S; reflexivity].
Qed.
