(* The operations of programs: to exact numbers, to float64, and to the enclosing machine, which counts roundings; and the rule of each. *)

From Coq Require Import Reals Lra Lia ZArith List Bool.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Mult_error Pff2Flocq.
From Formal Require Import Preliminaries Float Float64 RoundedHalfTurns Rounding EnclosingRules EnclosingBounds EnclosingFunctions EnclosingAngle
  EnclosingLogarithm
  EnclosingPower.
Open Scope R_scope.
Import ListNotations.

(* What is compared stands in a list, by its places. *)
Inductive test : Type := Less (i j : nat) | Same (i j : nat) | Not (c : test) | Both (c d : test).
(* A literal is m 2^e. A constant is a float64 number, with the count of what it stands for, a real number. Rest is what rounding takes from a
  product. Choose takes the first of two numbers where a test holds on those after them, else the second. *)
Inductive operation : Type :=
  | Literal (m e : Z) | Constant (value count meant : R) | Negative | Size | Sum | Difference | Product | Quotient | Root | Floor | Nearest | Sine
  | Cosine | Angle | Exponential | Logarithm | Raised | Rest | Choose (c : test).

Definition literal (m e : Z) := IZR m * bpow radix2 e.
Fixpoint holds (c : test) (values : list R) : bool :=
  match c with
  | Less i j => if Rlt_dec (nth i values 0) (nth j values 0) then true else false
  | Same i j => if Req_EM_T (nth i values 0) (nth j values 0) then true else false
  | Not c => negb (holds c values)
  | Both c d => holds c values && holds d values
  end.
Definition exactly (o : operation) (given : list R) := match o, given with | Literal m e, [] => literal m e | Constant _ _ meant, [] => meant |
  Negative, [x] => - x | Size, [x] => Rabs x | Sum, [x; y] => x + y | Difference, [x; y] => x - y | Product, [x; y] => x * y | Quotient, [x; y] =>
  x / y | Root, [x] => sqrt x | Floor, [x] => IZR (Int_part x) | Nearest, [x] => rint x | Sine, [x; y] => sin (PI * (x * y)) | Cosine, [x; y] =>
  cos (PI * (x * y)) | Angle, [y; x] => atan2pi y x | Exponential, [x] => exp x | Logarithm, [x] => ln x | Raised, [x; y] => power x y | Choose c,
  x :: y :: compared => if holds c compared then x else y | _, _ => 0 end.
Definition in_float64 (o : operation) (given : list R) := match o, given with | Literal m e, [] => literal m e | Constant value _ _, [] => value |
  Negative, [x] => - x | Size, [x] => Rabs x | Sum, [x; y] => enclosed_sum_float64.total x y | Difference, [x; y] => enclosed_sum_float64.total x
  (- y) | Product, [x; y] => enclosed_product_float64.product x y | Quotient, [x; y] => enclosed_quotient_float64.quotient x y | Root, [x] =>
  enclosed_root_float64.root x | Floor, [x] => enclosed_floor_float64.below x | Nearest, [x] => enclosed_nearest_float64.nearest x | Sine, [x; y]
  => enclosed_sine_float64.sine x y | Cosine, [x; y] => enclosed_cosine_float64.cosine x y | Angle, [y; x] => enclosed_angle_float64.angle x y |
  Exponential, [x] => enclosed_exponential_float64.exponential x | Logarithm, [x] => enclosed_logarithm_float64.logarithm x | Raised, [x; y] =>
  raised_float64.power x y | Rest, [x; y] => two_product_float64.product_error x y | Choose c, x :: y :: compared => if holds c compared then x
  else y | _, _ => 0 end.

(* What the machine knows of a number before it runs: that it is a literal, perhaps 2^k or -2^k; or whether it detects exact results of it, and
  whether its count is the float 0.0. *)
Inductive kind : Type := Written (k : option Z) | Run (stays free : bool).
Definition stays_exact (a : kind) : bool := match a with Written _ => true | Run stays _ => stays end.
Definition is_free (a : kind) : bool := match a with Written _ => true | Run _ free => free end.
Definition scale_of (a : kind) : option Z := match a with Written k => k | _ => None end.
Definition power_of_literal (m e : Z) : option Z := if (Z.abs m =? 2 ^ Z.log2 (Z.abs m))%Z then Some (Z.log2 (Z.abs m) + e)%Z else None.
Definition kind_of (o : operation) (given : list kind) : kind :=
  match o, given with
  | Literal m e, _ => Written (power_of_literal m e)
  | Negative, [a] | Size, [a] => a
  | Sum, [a; b] | Difference, [a; b] => Run (stays_exact a && stays_exact b) false
  | Product, [a; b] =>
    let scaled k c := (0 <=? k)%Z && is_free c in
    Run (stays_exact a || stays_exact b) match scale_of a, scale_of b with Some k, _ => scaled k b | _, Some k => scaled k a | _, _ => false end
  | Quotient, [a; _] | Root, [a] => Run (stays_exact a) false
  | Angle, [a; b] => Run (stays_exact a && stays_exact b && negb (is_free a && is_free b)) false
  | Floor, [a] | Nearest, [a] => Run true (is_free a)
  | Choose _, a :: b :: compared => Run (stays_exact a && stays_exact b) (forallb is_free given)
  | _, _ => Run false false
  end.

(* A number of the machine has a kind, a value and a count. Where two are too near, it is open which is less. *)
Definition too_near (a b : R * R) : bool :=
  if either (Rlt_dec (rounded (rounded (snd a + snd b) * ROUNDING)) (Rabs (rounded (fst a - fst b)))) (Req_EM_T (rounded (snd a + snd b)) 0) then
    false
  else true.
Fixpoint leaves_open (c : test) (given : list (R * R)) : bool :=
  match c with
  | Less i j | Same i j => too_near (nth i given (0, 0)) (nth j given (0, 0))
  | Not c => leaves_open c given
  | Both c d => leaves_open c given && (holds d (map fst given) || leaves_open d given) || leaves_open d given && (holds c (map fst given) ||
    leaves_open c given)
  end.
(* The rounding of a sum (Knuth). *)
Definition found_rounding (x y : R) := let total := rounded (x + y) in let part := rounded (total - x) in rounded (rounded (x - rounded (total -
  part)) + rounded (y - part)).
Definition count_of_sum (a b : kind) (x e y d : R) := if (stays_exact a && stays_exact b || is_free a && is_free b)%bool then rounded (rounded (e
  + d) + rounded (Rabs (found_rounding x y) * 9007199254740992)) else enclosed_sum_float64.total_error x e y d.
(* A factor or dividend that stays exact and is an exact 0. A power of two moves no bit, above the subnormal range. *)
Definition exact_zero (a : kind) (x e : R) : bool := if Req_EM_T (Rabs x + e) 0 then stays_exact a else false.
Definition count_of_scaled (a : kind) (k : Z) (x e : R) := rounded (rounded (bpow radix2 k * e) + if (0 <=? k)%Z then 0 else if stays_exact a then
  if Rle_dec (Rabs (rounded (x * bpow radix2 k))) (bpow radix2 (-1022)) then 1 / 2 ^ 1007 else 0 else 1 / 2 ^ 1007).
Definition count_of_product (a b : kind) (x e y d : R) := if (exact_zero a x e || exact_zero b y d)%bool then 0 else match scale_of a, scale_of b
  with | Some k, _ => count_of_scaled b k y d | _, Some k => count_of_scaled a k x e | _, _ => enclosed_product_float64.product_error x e y d end.
(* What a product in two parts is moved by: of a factor that stays exact the second part counts what underflows, unless a factor is an exact 0. *)
Definition either_stays (a b : kind) := (stays_exact a || stays_exact b)%bool.
Definition moved_in_two (a b : kind) (x e y d : R) := let size x e := rounded (Rabs x + rounded (ROUNDING * e)) in rounded (product_moves x e y d + if
  either_stays a b then if both (Rlt_dec (Rabs (rounded (x * y))) (1 / 2 ^ 900)) (Rlt_dec 0 (Rmin (size x e) (size y d))) then 1 / 2 ^ 1007 else 0
    else 0).
Definition count_of_wave (a b : kind) (x e y d f : R) := count_of_turn (either_stays a b) f (moved_in_two a b x e y d).
(* On an axis, if both coordinates stay exact, an angle is exact. *)
Definition on_axis (x e y d : R) := both (Req_EM_T (Rabs x + e) 0) (Rlt_dec (rounded (ROUNDING * d)) (Rabs y)).
Definition count_of_angle (a b : kind) (y d x e : R) := if (stays_exact a && stays_exact b && if either (on_axis x e y d) (on_axis y d x e) then true
  else
  false)%bool then 0 else enclosed_angle_float64.angle_error x e y d.
Definition counted_roundings (o : operation) (given : list (kind * (R * R))) := match o, given with | Constant _ count _, [] => count | Negative,
  [(_, (_, e))] | Size, [(_, (_, e))] => e | Sum, [(a, (x, e)); (b, (y, d))] => count_of_sum a b x e y d | Difference, [(a, (x, e)); (b, (y, d))]
  => count_of_sum a b x e (- y) d | Product, [(a, (x, e)); (b, (y, d))] => count_of_product a b x e y d | Quotient, [(a, (x, e)); (_, (y, d))] =>
  if exact_zero a x e then 0 else enclosed_quotient_float64.quotient_error x e y d | Root, [(_, (x, e))] => enclosed_root_float64.root_error x e |
  Floor, [(_, (x, e))] => enclosed_floor_float64.below_error x e | Nearest, [(_, (x, e))] => enclosed_nearest_float64.nearest_error x e | Sine,
  [(a, (x, e)); (b, (y, d))] => count_of_wave a b x e y d (enclosed_sine_float64.sine x y) | Cosine, [(a, (x, e)); (b, (y, d))] =>
  count_of_wave a b x e y d (enclosed_cosine_float64.cosine x y) | Angle, [(a, (y, d)); (b, (x, e))] => count_of_angle a b y d x e | Exponential,
  [(_, (x, e))] => enclosed_exponential_float64.exponential_error x e | Logarithm, [(_, (x, e))] => enclosed_logarithm_float64.logarithm_error x e | Raised,
  [(_, (x, e)); (b, (y, d))] => count_of_power (is_free b) x e y d
  | Choose c, (_, (x, e)) :: (_, (y, d)) :: compared => if leaves_open c (map snd compared) then open_count x e y d else if holds c (map fst (map
  snd compared)) then e else d | _, _ => 0 end.

(* What a rule asks: of what the machine computed, and of nothing else. *)
Definition turn_allowed (a b : kind) (x e y d : R) := e <= 2 ^ 60 /\ d <= 2 ^ 60 /\ Rabs (x * y) <= 2 ^ 21 /\ (10 ^ 285 * Rabs (x * y) >= 1 \/ x * y =
  0) /\ (either_stays a b = true -> 1 / 2 ^ 900 <= moved_in_two a b x e y d \/ x = 0 /\ e = 0 \/ y = 0 /\ d = 0 \/ e = 0 /\ d = 0).
(* A literal power of two is one, and below 1 no count is so small that it vanishes. *)
Definition scale_allowed (a : kind) (x e d : R) := match scale_of a with Some k => Rabs x = bpow radix2 k /\ e = 0 /\ ((0 <= k)%Z \/ d = 0 \/ 1 /
  2 ^ 1007 <= bpow radix2 k * d) | None => True end.
Definition allowed (o : operation) (given : list (kind * (R * R))) := match o, given with | Literal m e, [] => (Z.abs m < 2 ^ 53 /\ -1074 <= e)%Z
  | Constant value count meant, [] => encloses 1 (value, count) meant | Negative, [_] | Size, [_] | Sum, [_; _] | Difference, [_; _] => True |
  Product, [(a, (x, e)); (b, (y, d))] => e <= 2 ^ 60 /\ d <= 2 ^ 60 /\ scale_allowed a x e d /\ scale_allowed b y d e | Quotient, [_; (_, (y, d))]
  => Rabs y <= 2 ^ 960 /\ Rabs y - (1 / 9007199254740992) * d * (/ 524288 + 1) >= / 576460752303423488 | Root, [(_, (x, _))] => x >= 0 | Floor,
  [(_, (_, e))] | Nearest, [(_, (_, e))] => e <= 2 ^ 60 | Sine, [(a, (x, e)); (b, (y, d))] | Cosine, [(a, (x, e)); (b, (y, d))] => turn_allowed a
  b x e y d | Angle, [(a, (y, _)); (b, (x, _))] => x ^ 2 + y ^ 2 >= / 1024 /\ (is_free a && is_free b = true -> 0 <= x \/ y <> 0) | Exponential, [(a,
    (x, e))] => is_free a = false /\ x <= 704 /\ e <= 2 ^ 55 /\ (10 ^ 285 * Rabs
  x >= 1 \/ x = 0) | Logarithm, [(a, (x, e))] => is_free a = false /\ x <= 2 ^ 1000 /\ e <= 2 ^ 52 * x /\ 10 ^ 285 * x >= 1 | Raised, [(a, (x, e));
    (b,
  (y, d))] => is_free a = false /\ (is_free b = true -> d = 0) /\ power_allowed x e y d | _, _ => False end.
Lemma encloses_weaker s t n x : s <= t -> encloses s n x -> encloses t n x.
Proof. intros L (V & C & P & D). repeat split; try assumption. at_most_by D. apply Rmult_le_compat_r; lra. Qed.
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

Lemma exactly_encloses s v : float64 v -> encloses s (v, 0) v.
Proof. intro. split; [assumption | split; [apply generic_format_0 | cbn; rewrite Rminus_eq_0, Rabs_R0; lra]]. Qed.
Ltac opened := repeat match goal with X : encloses _ _ _ |- _ => destruct X | X : _ /\ _ |- _ =>
  destruct X end.
Section rules.
Variable s : R.
Hypotheses (S1 : 1 <= s) (S2 : s <= 1 + 3 / 2 ^ 22).
Lemma found_sum_rule x e x' y d y' : encloses s (x, e) x' -> encloses s (y, d) y' ->
  encloses (s * (1 + 1 / 2 ^ 49)) (rounded (x + y), rounded (rounded (e + d) + rounded (Rabs (found_rounding x y) * 9007199254740992))) (x' + y').
Proof.
  intros (X & E & P & N) (Y & D & Q & M). cbn [fst snd] in *. assert (I : rounded (x + y) + found_rounding x y = x + y).
  { apply (TwoSum_correct (-1074) 53 (fun n => negb (Z.even n))); [easy | easy | | exact X | exact Y]. intro n. rewrite Z.even_opp, Z.even_add.
    destruct (Z.even n); reflexivity. }
  set (b := found_rounding x y) in *. assert (Fb : float64 b) by apply rounded_is_float64. clearbody b. pose proof distance_as_count (Rabs b)
    ltac:(is_float64) as F.
  rewrite F. assert (Fc : float64 (Rabs b * 9007199254740992)) by (rewrite <- F; is_float64). pose proof Rabs_pos b as T.
  counts k (e + d). counts c (k + Rabs b * 9007199254740992). split; [is_float64 | is_count]. cbn [fst snd].
  apply enough with (e + d + Rabs b * 9007199254740992) 0 0; try lra; [clearbody k c; in_units|].
  replace (rounded (x + y) - (x' + y')) with ((x - x') + (y - y') - b) by lra. assert (0 <= (s - 1) * Rabs b) by (apply Rmult_le_pos; lra).
  pose proof Rabs_triang (x - x' + (y - y')) (- b) as G. pose proof Rabs_triang (x - x') (y - y') as J. rewrite Rabs_Ropp in G. unfold Rminus at 1. lra.
Qed.
Lemma sum_rule a b x e x' y d y' :  encloses s (x, e) x' -> encloses s (y, d) y' ->
  encloses (s * (1 + 1 / 2 ^ 49)) (enclosed_sum_float64.total x y, count_of_sum a b x e y d) (x' + y').
Proof.
  intros X Y. unfold count_of_sum. destruct (_ || _)%bool; [apply found_sum_rule; assumption|]. opened. split; [apply rounded_is_float64 | apply
    (enclosing_rules__sum s x e x' y d y'); assumption].
Qed.
Lemma is_zero x e x' : encloses s (x, e) x' -> Rabs x + e = 0 -> x = 0 /\ e = 0 /\ x' = 0.
Proof.
  intros X Z. assert (e = 0 /\ x = 0) as [-> ->]; [destruct X as (_ & _ & P & _); cbn [snd] in P; generalize (Rabs_pos x) (Rabs_eq_0 x); lra |].
    rewrite <-
    (same _ _ _ X). auto.
Qed.
Lemma is_exact_zero a x e x' : encloses s (x, e) x' -> exact_zero a x e = true -> x = 0 /\ e = 0 /\ x' = 0.
Proof. unfold exact_zero. destruct Req_EM_T; [intros; apply is_zero; assumption | discriminate]. Qed.
Lemma scaled_by_power a k x e x' : let q := bpow radix2 k in  encloses s (x, e) x' -> (0 <= k)%Z \/ e = 0 \/ 1 / 2
  ^ 1007 <= q * e ->
  encloses (s * (1 + 1 / 2 ^ 49)) (rounded (x * q), count_of_scaled a k x e) (x' * q).
Proof.
  intros q (X & E & P & D) H. cbn [fst snd] in *. assert (Q : 0 < q) by apply bpow_gt_0. unfold count_of_scaled. fold q. destruct
    underflow_in_least as [T L]. set (least := 1 / 2 ^ 1007) in *.
  assert (Fl : float64 least) by exact least_is_float64. clearbody least.
  assert (Kept : (0 <= k)%Z \/ bpow radix2 (-1022) <= Rabs (x * q) -> rounded (x * q) = x * q).
  { intro N. apply kept. destruct (Req_dec x 0) as [->|Z]; [rewrite Rmult_0_l; apply generic_format_0|]. destruct N as [N|N]; [apply
    mult_bpow_pos_exact_FLT; assumption|].
    apply mult_bpow_exact_FLT; [exact X|]. apply (mag_ge_bpow radix2 _ (-1021)) in N. unfold q in N. rewrite mag_mult_bpow in N by exact Z. lia. }
  assert (Moved : Rabs (x * q - x' * q) <= s * (q * e / 2 ^ 53)).
  { rewrite <- Rmult_minus_distr_r, Rabs_mult, (Rabs_pos_eq q) by lra. replace (s * _) with (s * (e / 2 ^ 53) * q) by (unfold Rdiv; ring). apply
    Rmult_le_compat_r; lra. }
  assert (Q' : 0 <= q) by lra. assert (0 <= q * e) by is_not_negative. split; [is_float64|]. cbn [fst snd].
  assert (Plain : rounded (x * q) = x * q -> q * e <= (1 + 1 / 2 ^ 49) * rounded (q * e) -> let c := rounded (rounded (q * e) + 0) in float64 c /\ 0
    <= c /\ Rabs (rounded (x * q) - x' * q) <= s * (1 + 1 / 2 ^ 49) * (c / 2 ^ 53)).
  { intros K M. cbv zeta. rewrite Rplus_0_r, (kept (rounded _)) by is_float64. split; [is_float64 | split; [is_not_negative|]]. rewrite K. apply
    enough with (q * e) 0 0; lra. }
  destruct (Z.leb_spec 0 k) as [N|_]; [apply Plain; [apply Kept; left; exact N | unfold q; rewrite Rmult_comm, (kept (e * _)) by (apply
    mult_bpow_pos_exact_FLT; assumption); fold q; lra]|].
  assert (Lossy : let c := rounded (rounded (q * e) + least) in float64 c /\ 0 <= c /\ Rabs (rounded (x * q) - x' * q) <= s * (1 + 1 / 2 ^ 49) * (c /
    2 ^ 53)).
  { cbv zeta. counts m (q * e). counts c (m + least). is_count. apply enough with (q * e) 0 (2 * underflow); try
    lra; [in_units|].
    replace (rounded (x * q) - x' * q) with (rounded (x * q) - x * q + (x * q - x' * q)) by ring. at_most_by Rabs_triang. enough (Rabs (rounded
      (x * q) - x * q)
      <= 2 * underflow) by lra.
    destruct (Rle_lt_dec (bpow radix2 (-1022)) (Rabs (x * q))) as [G|G]; [rewrite Kept by (right; exact G); rewrite Rminus_eq_0, Rabs_R0; lra|].
    assert (B : underflow * 2 ^ 52 = bpow radix2 (-1022)) by (rewrite underflow_times; reflexivity). generalize (rounding_error (x * q)). in_units. }
  destruct (stays_exact a); [|exact Lossy]. destruct Rle_dec as [_|G]; [exact Lossy|]. apply Plain; [apply Kept; right | destruct H as [H | [-> |
    H]]].
  - apply Rnot_lt_le. intro W. apply G. unfold rounded. rewrite <- round_NE_abs by typeclasses eauto. apply round_le_generic; [typeclasses eauto..|
      apply generic_format_bpow; easy | lra].
  - unfold q. rewrite Rmult_comm, (kept (e * _)) by (apply mult_bpow_pos_exact_FLT; assumption). fold q. lra.
  - rewrite Rmult_0_r, rounded_0. lra.
  - generalize (counted (q * e) ltac:(assumption)). in_units.
Qed.
Lemma scaled_rule a k x e x' y :  encloses s (x, e) x' -> Rabs y = bpow radix2 k -> (0 <= k)%Z \/ e = 0 \/ 1 / 2 ^
  1007 <= bpow radix2 k * e ->
  encloses (s * (1 + 1 / 2 ^ 49)) (rounded (x * y), count_of_scaled a k x e) (x' * y).
Proof.
  intros X Y H. destruct (Rcase_abs y) as [N|N]; [rewrite Rabs_left in Y by exact N | rewrite Rabs_pos_eq in Y by lra; subst y; apply
    scaled_by_power; assumption].
  replace y with (- bpow radix2 k) by lra. rewrite <- !Ropp_mult_distr_r, rounded_opp. apply encloses_opposite. apply scaled_by_power; assumption.
Qed.
Lemma product_rule a b x e x' y d y' :  encloses s (x, e) x' -> encloses s (y, d) y' -> e <= 2 ^ 60 -> d <= 2 ^ 60
  -> scale_allowed a x e d -> scale_allowed b y d e ->
  encloses (s * (1 + 1 / 2 ^ 49)) (enclosed_product_float64.product x y, count_of_product a b x e y d) (x' * y').
Proof.
  intros X Y U V A B. unfold count_of_product, scale_allowed, enclosed_product_float64.product in *. destruct (exact_zero a x e) eqn:Zx;
    [|destruct (exact_zero b y d) eqn:Zy; cbn [orb]].
  1: destruct (is_exact_zero a x e x' X Zx) as (-> & _ & ->); rewrite !Rmult_0_l, rounded_0; apply exactly_encloses, generic_format_0.
  1: destruct (is_exact_zero b y d y' Y Zy) as (-> & _ & ->); rewrite !Rmult_0_r, rounded_0; apply exactly_encloses, generic_format_0.
  destruct (scale_of a) as [k|]; [|destruct (scale_of b) as [k|]].
  - destruct A as (A & -> & W). rewrite <- (same _ _ _ X), (Rmult_comm x y), (Rmult_comm x y'). apply scaled_rule; assumption.
  - destruct B as (B & -> & W). rewrite <- (same _ _ _ Y). apply scaled_rule; assumption.
  - opened. split; [apply rounded_is_float64 | apply (enclosing_rules__product s x e x' y d y'); assumption].
Qed.
(* Coq's root and power of what is negative are 0, as of the nearest number that is not. *)
Lemma nearest_above x e x' : x >= 0 -> encloses s (x, e) x' -> encloses s (x, e) (Rmax 0 x').
Proof.
  intros X0 (X & E & P & D). cbn [fst snd] in *. repeat split; try assumption. eapply Rle_trans; [|exact D]. cbn [fst snd]. unfold Rmax. destruct
    Rle_dec; [apply Rle_refl|]. unfold Rabs.
    repeat destruct Rcase_abs; lra.
Qed.
Lemma root_rule x e x' :  encloses s (x, e) x' -> x >= 0 -> encloses (s * (1 + 1 / 2 ^ 49))
  (enclosed_root_float64.root x, enclosed_root_float64.root_error x e) (sqrt x').
Proof.
  intros X X0. destruct (nearest_above x e x' X0 X) as (_ & E & P & D). assert (Q : sqrt x' = sqrt (Rmax 0 x')) by (unfold Rmax; destruct Rle_dec;
    [reflexivity | rewrite sqrt_0; apply
    sqrt_neg; lra]).
  rewrite Q. split; [apply rounded_is_float64|]. apply (enclosing_rules__root s x e (Rmax 0 x')); try assumption; [apply X |
    apply Rle_ge, Rmax_l].
Qed.

Lemma wave_rule a b x e x' y d y' : encloses s (x, e) x' -> encloses s (y, d) y' -> turn_allowed a b x e y d -> let enclosed f := encloses (s * (1 + 1
  / 2 ^ 49)) (f, count_of_wave a b x e y d f) in enclosed (enclosed_sine_float64.sine x y) (sin (PI * (x' * y'))) /\ enclosed
  (enclosed_cosine_float64.cosine x y) (cos (PI * (x' * y'))).
Proof.
  intros X Y (L & _ & U & N & Z). pose proof proj1 X as Fx. pose proof proj1 Y as Fy. assert (product_moves x e y
    d <= moved_in_two a b x e y d) by (apply round_ge_generic; [typeclasses eauto..| apply rounded_is_float64 | destruct (either_stays a b);
      [destruct (both _ _)|]; lra]).
  assert (either_stays a b = true -> 1 / 2 ^ 900 <= moved_in_two a b x e y d \/ x * y = x' * y').
  { intro E. destruct (Z E) as [G|G]; [left; exact G | right]. destruct G as [[? ?] | [[? ?] | [? ?]]]; subst; try apply same in X; try apply same in
    Y;
    subst; ring. }
  split; (split; [apply sine_result || apply cosine_result|]); [of_half_turns (either_stays a b) sine_rule @proj1 s x e x' y d y' | of_half_turns
    (either_stays a b) cosine_rule @proj2 s x e x' y d y'].
Qed.

Lemma axis_rule x e x' y d y' : encloses s (x, e) x' -> encloses s (y, d) y' -> Rabs x + e = 0 /\ rounded (ROUNDING * d) < Rabs y -> x = 0 /\ x' = 0
  /\ 0 <
  y * y'.
Proof.
  intros X (Y & _ & P & D) [Z L]. destruct (is_zero x e x' X Z) as (-> & _ & ->). cbn [fst snd] in *. rewrite <- (kept (Rabs y)) in L by is_float64.
    apply
    rounded_below in L. destruct (bound_of s d S1 S2 P) as [B _]. assert (N : Rabs (y - y') < Rabs y) by in_units. repeat split. revert N. unfold
      Rabs.
    repeat destruct Rcase_abs; nra.
Qed.
Lemma angle_rule a b y d y' x e x' : encloses s (y, d) y' -> encloses s (x, e) x' -> x ^ 2 + y ^ 2 >= / 1024 -> encloses (s * (1 + 1 / 2 ^ 49))
  (enclosed_angle_float64.angle x y, count_of_angle a b y d x e) (atan2pi y' x').
Proof.
  intros Y X N. unfold count_of_angle. destruct (_ && _)%bool eqn:Q.
  - apply andb_prop in Q as [_ Q]. destruct (either _ _) as [H|]; [|discriminate]. rewrite <- (on_an_axis y x y' x'); [apply exactly_encloses,
      angle_is_float64|]. destruct H; [right | left]; eapply axis_rule; eassumption.
  - opened. split; [apply angle_is_float64 | apply (enclosing_rules__angle s x e x' y d y'); assumption].
Qed.

(* By a theorem about the parts of what is given. *)
Ltac by_rule theorem value := opened; split; [value | cbn [fst snd]; (apply theorem || eapply proj2, theorem); assumption].
Theorem every_rule o given exact :  Forall2 (fun n => encloses s (snd n)) given exact -> allowed o given ->
  encloses (s * (1 + 1 / 2 ^ 49)) (in_float64 o (map fst (map snd given)), counted_roundings o given) (exactly o exact).
Proof.
  intros A H. destruct o; (destruct A as [|[a [x ex]] x1 given exact X A]; [try (exfalso; exact H)|
    try (destruct A as [|[b [y ey]] y1 given exact Y A]; [try (exfalso; exact H) | destruct A; try (exfalso; exact H)])]).
  all: cbn [in_float64 counted_roundings exactly map fst snd allowed] in *.
  - apply exactly_encloses, whole_is_float64; apply H.
  - apply encloses_weaker with (2 := H). nra.
  - exact (not_more _ _ _ S1 (encloses_opposite _ _ _ _ X)).
  - destruct X as (X & Ex & Px & Dx). apply not_more; [exact S1|]. split; [apply generic_format_abs, X | split; [exact Ex | split; [exact Px|]]].
      at_most_by Rabs_triang_inv2; exact Dx.
  - apply sum_rule; assumption.
  - apply encloses_opposite in Y. apply sum_rule; assumption.
  - destruct H as (? & ? & ? & ?). apply product_rule; assumption.
  - destruct H. destruct (exact_zero a x ex) eqn:Z. + destruct (is_exact_zero a x ex x1 X Z) as (-> & _ & ->). unfold
    enclosed_quotient_float64.quotient, Rdiv. rewrite !Rmult_0_l, rounded_0.
      apply exactly_encloses, generic_format_0.
    + by_rule (enclosing_rules__quotient s x ex x1 y ey y1) ltac:(apply rounded_is_float64).
  - exact (root_rule x ex x1 X H).
  - by_rule (enclosing_rules__floor s x ex x1) ltac:(apply (whole_part_is_float64 Zfloor); [apply valid_rnd_DN | assumption]).
  - by_rule (enclosing_rules__nearest s x ex x1) ltac:(apply whole_part_is_float64; [apply valid_rnd_N | assumption]).
  - apply wave_rule; assumption.
  - apply wave_rule; assumption.
  - apply angle_rule; apply H || assumption.
  - by_rule (enclosing_rules__exponential s x ex x1) ltac:(apply exponential_is_float64).
  - by_rule (enclosing_rules__logarithm s x ex x1) ltac:(apply logarithm_is_float64).
  - assert (Q : power x1 y1 = power (Rmax 0 x1) y1) by (unfold power, Rmax; destruct Rle_dec; repeat destruct Rlt_dec; lra). rewrite Q. eapply proj2,
      (power_rule (is_free b)); try apply H; try assumption; [apply nearest_above; [apply H | exact X] | apply Rle_ge, Rmax_l].
Qed.
End rules.
