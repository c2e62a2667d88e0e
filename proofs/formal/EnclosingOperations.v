(* The operations of programs: to exact numbers, to float64, and to the enclosing machine, which counts roundings; and the rule of each. *)

From Coq Require Import Reals Lra Lia ZArith List Bool.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Mult_error Pff2Flocq.
From Formal Require Import Preliminaries Float Float64 Programs RoundedHalfTurns Rounding EnclosingRules EnclosingFunctions EnclosingAngle
  EnclosingLogarithm.
Open Scope R_scope.
Import ListNotations.

(* What is compared stands in a list, by its places. *)
Inductive test : Type := Less (i j : nat) | Same (i j : nat) | Not (c : test) | Both (c d : test).
(* A literal is m 2^e. Found_sum is a sum of numbers that stay exact: two more sums find its rounding. Scaled is times a literal 2^n. Choose takes
   the first of two numbers where a test holds on those after them, else the second. *)
Inductive operation : Type :=
  | Literal (m e : Z) | Negative | Size | Sum | Found_sum | Difference | Scaled (n : nat) | Product | Quotient | Root | Floor | Nearest | Sine |
    Cosine | Angle | Exponential | Logarithm
  | Choose (c : test).

Definition literal (m e : Z) : R := IZR m * bpow radix2 e.
Fixpoint holds (c : test) (values : list R) : bool :=
  match c with
  | Less i j => if Rlt_dec (nth i values 0) (nth j values 0) then true else false
  | Same i j => if Req_EM_T (nth i values 0) (nth j values 0) then true else false
  | Not c => negb (holds c values)
  | Both c d => holds c values && holds d values
  end.
Definition exactly (o : operation) (given : list R) : R :=
  match o, given with
  | Literal m e, [] => literal m e
  | Negative, [x] => - x
  | Size, [x] => Rabs x
  | Sum, [x; y] | Found_sum, [x; y] => x + y
  | Difference, [x; y] => x - y
  | Scaled n, [x] => x * 2 ^ n
  | Product, [x; y] => x * y
  | Quotient, [x; y] => x / y
  | Root, [x] => sqrt x
  | Floor, [x] => IZR (Int_part x)
  | Nearest, [x] => rint x
  | Sine, [x; y] => sin (PI * (x * y))
  | Cosine, [x; y] => cos (PI * (x * y))
  | Angle, [y; x] => atan2pi y x
  | Exponential, [x] => exp x
  | Logarithm, [x] => ln x
  | Choose c, x :: y :: compared => if holds c compared then x else y
  | _, _ => 0
  end.
Definition in_float64 (o : operation) (given : list R) : R :=
  match o, given with
  | Literal m e, [] => literal m e
  | Negative, [x] => - x
  | Size, [x] => Rabs x
  | Sum, [x; y] | Found_sum, [x; y] => enclosed_sum_float64.total x y
  | Difference, [x; y] => enclosed_sum_float64.total x (- y)
  | Scaled n, [x] => rounded (x * 2 ^ n)
  | Product, [x; y] => enclosed_product_float64.product x y
  | Quotient, [x; y] => enclosed_quotient_float64.quotient x y
  | Root, [x] => enclosed_root_float64.root x
  | Floor, [x] => enclosed_floor_float64.below x
  | Nearest, [x] => enclosed_nearest_float64.nearest x
  | Sine, [x; y] => enclosed_sine_float64.sine x y
  | Cosine, [x; y] => enclosed_cosine_float64.cosine x y
  | Angle, [y; x] => enclosed_angle_float64.angle x y
  | Exponential, [x] => enclosed_exponential_float64.exponential x
  | Logarithm, [x] => enclosed_logarithm_float64.logarithm x
  | Choose c, x :: y :: compared => if holds c compared then x else y
  | _, _ => 0
  end.

(* A number of the enclosing machine has a value and a count. Where two are too near, it is open which is less. *)
Definition too_near (a b : R * R) : bool :=
  if either (Rlt_dec (rounded (rounded (snd a + snd b) * ROUNDING)) (Rabs (rounded (fst a - fst b)))) (Req_EM_T (rounded (snd a + snd b)) 0) then
    false else true.
Fixpoint leaves_open (c : test) (given : list (R * R)) : bool :=
  match c with
  | Less i j | Same i j => too_near (nth i given (0, 0)) (nth j given (0, 0))
  | Not c => leaves_open c given
  | Both c d => leaves_open c given && (holds d (map fst given) || leaves_open d given) || leaves_open d given && (holds c (map fst given) ||
    leaves_open c given)
  end.
(* The rounding of a sum (Knuth). *)
Definition found_rounding (x y : R) : R :=
  let total := rounded (x + y) in let part := rounded (total - x) in rounded (rounded (x - rounded (total - part)) + rounded (y - part)).
Definition counted_roundings (o : operation) (given : list (R * R)) : R :=
  match o, given with
  | Negative, [(_, e)] | Size, [(_, e)] => e
  | Sum, [(x, e); (y, d)] => enclosed_sum_float64.total_error x e y d
  | Found_sum, [(x, e); (y, d)] => rounded (rounded (e + d) + rounded (Rabs (found_rounding x y) * 9007199254740992))
  | Difference, [(x, e); (y, d)] => enclosed_sum_float64.total_error x e (- y) d
  | Scaled n, [(_, e)] => rounded (2 ^ n * e)
  | Product, [(x, e); (y, d)] => enclosed_product_float64.product_error x e y d
  | Quotient, [(x, e); (y, d)] => enclosed_quotient_float64.quotient_error x e y d
  | Root, [(x, e)] => enclosed_root_float64.root_error x e
  | Floor, [(x, e)] => enclosed_floor_float64.below_error x e
  | Nearest, [(x, e)] => enclosed_nearest_float64.nearest_error x e
  | Sine, [(x, e); (y, d)] => enclosed_sine_float64.sine_error x e y d
  | Cosine, [(x, e); (y, d)] => enclosed_cosine_float64.cosine_error x e y d
  | Angle, [(y, d); (x, e)] => enclosed_angle_float64.angle_error x e y d
  | Exponential, [(x, e)] => enclosed_exponential_float64.exponential_error x e
  | Logarithm, [(x, e)] => enclosed_logarithm_float64.logarithm_error x e
  | Choose c, (x, e) :: (y, d) :: compared => if leaves_open c compared then open_count x e y d else if holds c (map fst compared) then e else d
  | _, _ => 0
  end.

(* What a rule asks: of what the machine computed, and of nothing else. *)
Definition turn_allowed (x e y d : R) : Prop := e <= 2 ^ 60 /\ d <= 2 ^ 60 /\ Rabs (x * y) <= 2 ^ 21 /\ (10 ^ 285 * Rabs (x * y) >= 1 \/ x * y = 0).
Definition allowed (o : operation) (given : list (R * R)) : Prop :=
  match o, given with
  | Literal m e, [] => (Z.abs m < 2 ^ 53 /\ -1074 <= e)%Z
  | Negative, [_] | Size, [_] | Sum, [_; _] | Found_sum, [_; _] | Difference, [_; _] | Scaled _, [_] => True
  | Product, [(_, e); (_, d)] => e <= 2 ^ 60 /\ d <= 2 ^ 60
  | Quotient, [_; (y, d)] => Rabs y <= 2 ^ 960 /\ Rabs y - (1 / 9007199254740992) * d * (/ 524288 + 1) >= / 576460752303423488
  | Root, [(x, _)] => x >= 0
  | Floor, [(_, e)] | Nearest, [(_, e)] => e <= 2 ^ 60
  | Sine, [(x, e); (y, d)] | Cosine, [(x, e); (y, d)] => turn_allowed x e y d
  | Angle, [(y, _); (x, _)] => x ^ 2 + y ^ 2 >= / 1024
  | Exponential, [(x, e)] => x <= 704 /\ e <= 2 ^ 55 /\ (10 ^ 285 * Rabs x >= 1 \/ x = 0)
  | Logarithm, [(x, e)] => x <= 2 ^ 1000 /\ e <= 2 ^ 52 * x /\ 10 ^ 285 * x >= 1
  | _, _ => False
  end.

(* That a number of the machine encloses an exact one; s is the slack of the counts, which each operation adds to. *)
Definition encloses (s : R) (n : R * R) (x : R) : Prop := float64 (fst n) /\ float64 (snd n) /\ 0 <= snd n /\ Rabs (fst n - x) <= s * (snd n / 2 ^
  53).
Lemma encloses_weaker s t n x : s <= t -> encloses s n x -> encloses t n x.
Proof. intros L (V & C & P & D). repeat split; try assumption. eapply Rle_trans; [exact D|]. apply Rmult_le_compat_r; lra. Qed.
Lemma not_more s n x : 1 <= s -> encloses s n x -> encloses (s * (1 + 1 / 2 ^ 49)) n x.
Proof. intro S. apply encloses_weaker. lra. Qed.
Lemma encloses_opposite s y d y' : encloses s (y, d) y' -> encloses s (- y, d) (- y').
Proof.
  intros (Y & D & P & N). split; [apply generic_format_opp, Y | split; [exact D | split; [exact P|]]]. cbn [fst snd] in *. replace (- y - - y') with
    (- (y - y')) by ring. rewrite Rabs_Ropp. exact N.
Qed.

Ltac chosen_is_float64 := repeat match goal with |- context [if ?d then _ else _] => destruct d end; repeat apply generic_format_opp; first [apply
  rounded_is_float64 | apply generic_format_0].
Lemma sine_result p q : float64 (sine_of_half_turns_float64.sine p q).
Proof. unfold sine_of_half_turns_float64.sine, sine_of_half_turns_float64.sine_near, sine_of_half_turns_float64.cosine_near. chosen_is_float64. Qed.
Lemma cosine_result p q : float64 (cosine_of_half_turns_float64.cosine p q).
Proof. unfold cosine_of_half_turns_float64.cosine, cosine_of_half_turns_float64.sine_near, cosine_of_half_turns_float64.cosine_near.
  chosen_is_float64. Qed.
Lemma angle_is_float64 y x : float64 (angle_in_half_turns_float64.angle y x).
Proof.
  unfold angle_in_half_turns_float64.angle, angle_in_half_turns_float64.half_plane, angle_in_half_turns_float64.first_quadrant,
    angle_in_half_turns_float64.first_octant. chosen_is_float64.
Qed.
Lemma exponential_is_float64 p q : float64 (exponential_of_sum_float64.exponential p q).
Proof. unfold exponential_of_sum_float64.exponential. chosen_is_float64. Qed.

Lemma found_sum_rule s x e x' y d y' : 1 <= s -> encloses s (x, e) x' -> encloses s (y, d) y' ->
  encloses (s * (1 + 1 / 2 ^ 49)) (rounded (x + y), rounded (rounded (e + d) + rounded (Rabs (found_rounding x y) * 9007199254740992))) (x' + y').
Proof.
  intros S1 (X & E & P & N) (Y & D & Q & M). cbn [fst snd] in *. assert (I : rounded (x + y) + found_rounding x y = x + y).
  { apply (TwoSum_correct (-1074) 53 (fun n => negb (Z.even n))); [easy | easy | | exact X | exact Y]. intro n. rewrite Z.even_opp, Z.even_add.
    destruct (Z.even n); reflexivity. }
  set (b := found_rounding x y) in *. assert (Fb : float64 b) by apply rounded_is_float64. clearbody b. assert (F := distance_as_count (Rabs b)
    ltac:(is_float64)).
  rewrite F. assert (Fc : float64 (Rabs b * 9007199254740992)) by (rewrite <- F; is_float64). assert (T := Rabs_pos b).
  counts k (e + d). counts c (k + Rabs b * 9007199254740992). split; [is_float64 | split; [is_float64 | split; [assumption|]]]. cbn [fst snd].
  apply enough with (e + d + Rabs b * 9007199254740992) 0 0; try lra; [clearbody k c; in_units|].
  replace (rounded (x + y) - (x' + y')) with ((x - x') + (y - y') - b) by lra. assert (0 <= (s - 1) * Rabs b) by (apply Rmult_le_pos; lra).
  assert (G := Rabs_triang (x - x' + (y - y')) (- b)). assert (J := Rabs_triang (x - x') (y - y')). rewrite Rabs_Ropp in G. unfold Rminus at 1. lra.
Qed.
Lemma scaled_rule s n x e x' : 1 <= s -> encloses s (x, e) x' -> encloses (s * (1 + 1 / 2 ^ 49)) (rounded (x * 2 ^ n), rounded (2 ^ n * e)) (x' * 2 ^
  n).
Proof.
  intros S1 (X & E & P & N). cbn [fst snd] in *. assert (L : 0 < 2 ^ n) by (apply pow_lt; lra).
  assert (K : forall y, float64 y -> rounded (y * 2 ^ n) = y * 2 ^ n).
  { intros y F. apply round_generic; [typeclasses eauto|]. rewrite pow_powerRZ, <- (bpow_powerRZ radix2). apply mult_bpow_pos_exact_FLT; [exact F |
    lia]. }
  apply not_more; [exact S1|]. split; [is_float64 | split; [is_float64|]]. cbn [fst snd]. rewrite (Rmult_comm _ e), !K by assumption. split; [apply
    Rmult_le_pos; lra|].
  rewrite <- Rmult_minus_distr_r, Rabs_mult, (Rabs_pos_eq (2 ^ n)) by lra. apply Rle_trans with (s * (e / 2 ^ 53) * 2 ^ n); [apply Rmult_le_compat_r;
    lra | lra].
Qed.
(* Coq's root of what is negative is 0, as of the nearest number that is not. *)
Lemma root_rule s x e x' : 1 <= s -> s <= 1 + 3 / 2 ^ 22 -> encloses s (x, e) x' -> x >= 0 -> encloses (s * (1 + 1 / 2 ^ 49))
  (enclosed_root_float64.root x, enclosed_root_float64.root_error x e) (sqrt x').
Proof.
  intros S1 S2 (X & E & P & D) X0. assert (Q : sqrt x' = sqrt (Rmax 0 x')) by (unfold Rmax; destruct Rle_dec; [reflexivity | rewrite sqrt_0; apply
    sqrt_neg; lra]).
  rewrite Q. split; [apply rounded_is_float64|]. apply (enclosing_rules__root s x e (Rmax 0 x')); try assumption; [|apply Rle_ge, Rmax_l].
  eapply Rle_trans; [|exact D]. cbn [fst snd]. unfold Rmax. destruct Rle_dec; [apply Rle_refl|]. unfold Rabs. repeat destruct Rcase_abs; lra.
Qed.

Ltac by_rule theorem value := split; [value | cbn [fst snd]; (apply theorem || eapply proj2, theorem); assumption].
Ltac is_rounded := apply rounded_is_float64.
Theorem every_rule o s given exact : 1 <= s -> s <= 1 + 3 / 2 ^ 22 -> Forall2 (encloses s) given exact -> allowed o given ->
  encloses (s * (1 + 1 / 2 ^ 49)) (in_float64 o (map fst given), counted_roundings o given) (exactly o exact).
Proof.
  intros S1 S2 A H. destruct o; (destruct A as [|[x ex] x1 given exact X A]; [try (exfalso; exact H)|
    try (destruct A as [|[y ey] y1 given exact Y A]; [try (exfalso; exact H) | destruct A; try (exfalso; exact H)])]).
  all: cbn [in_float64 counted_roundings exactly map fst snd allowed] in *. 5: exact (found_sum_rule s x ex x1 y ey y1 S1 X Y). 6: exact (scaled_rule s
    n x ex x1 S1 X).
  8: exact (root_rule s x ex x1 S1 S2 X H).
  5: apply encloses_opposite in Y; unfold Rminus.
  2: exact (not_more _ _ _ S1 (encloses_opposite _ _ _ _ X)).
  all: unfold turn_allowed in *; try (destruct X as (X & Ex & Px & Dx); cbn [fst snd] in * ); try (destruct Y as (Y & Ey & Py & Dy); cbn [fst snd] in * ).
  - split; [exact (whole_is_float64 m e (proj1 H) (proj2 H)) | split; [apply generic_format_0 | cbn [fst snd]; rewrite Rminus_eq_0, Rabs_R0; lra]].
  - apply not_more; [exact S1|]. split; [apply generic_format_abs, X | split; [exact Ex | split; [exact Px|]]]. eapply Rle_trans; [apply
      Rabs_triang_inv2 | exact Dx].
  - by_rule (enclosing_rules__sum s x ex x1 y ey y1) is_rounded.
  - by_rule (enclosing_rules__sum s x ex x1 (- y) ey (- y1)) is_rounded.
  - destruct H. by_rule (enclosing_rules__product s x ex x1 y ey y1) is_rounded.
  - destruct H. by_rule (enclosing_rules__quotient s x ex x1 y ey y1) is_rounded.
  - by_rule (enclosing_rules__floor s x ex x1) ltac:(apply (whole_part_is_float64 Zfloor); [apply valid_rnd_DN | exact X]).
  - by_rule (enclosing_rules__nearest s x ex x1) ltac:(apply whole_part_is_float64; [apply valid_rnd_N | exact X]).
  - destruct H as (? & ? & ? & ?). by_rule (enclosing_rules__sine s x ex x1 y ey y1) ltac:(apply sine_result).
  - destruct H as (? & ? & ? & ?). by_rule (enclosing_rules__cosine s x ex x1 y ey y1) ltac:(apply cosine_result).
  - by_rule (enclosing_rules__angle s y ey y1 x ex x1) ltac:(apply angle_is_float64).
  - destruct H as (? & ? & ?). by_rule (enclosing_rules__exponential s x ex x1) ltac:(apply exponential_is_float64).
  - destruct H as (? & ? & ?). by_rule (enclosing_rules__logarithm s x ex x1) ltac:(apply logarithm_is_float64).
Qed.
