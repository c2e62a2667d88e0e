(* Counts computed in Coq: the rules of the enclosing machine on dyadic numbers, whole numbers times powers of two. *)

From Coq Require Import Reals Lra Lia ZArith List Bool FMapPositive.
From Flocq Require Import Core Operations Round Div Sqrt Bracket.
From Formal Require Import Preliminaries Float Float64 RecordedPixel RoundedHalfTurns Rounding EnclosingRules EnclosingOperations EnclosingPixel.
Open Scope R_scope.
Import ListNotations.

Definition dyadic : Type := float radix2.
Definition dyadic_zero : dyadic := Float radix2 0 0.
Definition two_to (k : Z) : dyadic := Float radix2 1 k.

(* To the nearest, ties to even; and to k places less. *)
Definition to_nearest (m : Z) (l : SpecFloat.location) : Z := cond_incr (round_N (negb (Z.even m)) l) m.
Definition shortened (k : Z) (x : dyadic) : dyadic :=
  let (m, e) := x in
  if (k <=? 0)%Z then x
  else let q := Z.shiftr m k in Float radix2 (to_nearest q (new_location (Z.shiftl 1 k) (m - Z.shiftl q k) SpecFloat.loc_Exact)) (e + k).
Definition near_dyadic (x : dyadic) : dyadic := shortened (Z.max (SpecFloat.Zdigits2 (Fnum x) - 53) (-1074 - Fexp x)) x.
Definition near_located (located : Z * Z * SpecFloat.location) : dyadic :=
  let '(m, e, l) := truncate radix2 (FLT_exp (-1074) 53) located in Float radix2 (to_nearest m l) e.

Lemma shortened_lies m e k : (0 < k)%Z -> exists n l, shortened k (Float radix2 m e) = Float radix2 (to_nearest n l) (e + k) /\ inbetween_float
  radix2 n (e + k) (F2R (Float radix2 m e)) l.
Proof.
  intro K. unfold shortened. destruct (Z.leb_spec k 0) as [L|_]; [lia|]. eexists _, _. split; [reflexivity|]. rewrite !Z.shiftl_mul_pow2, Z.mul_1_l,
    Z.shiftr_div_pow2 by lia. rewrite (Z.mul_comm (m / 2 ^ k)), <- Z.mod_eq by (apply Z.pow_nonzero; lia).
  apply (inbetween_float_new_location radix2); [exact K|]. constructor. reflexivity.
Qed.
Lemma near_is_rounded x : F2R (near_dyadic x) = rounded (F2R x).
Proof.
  destruct x as [m e]. unfold near_dyadic. rewrite Zdigits2_Zdigits. cbn [Fnum Fexp]. set (k := Z.max _ _).
  assert (C : m <> 0%Z -> cexp radix2 (FLT_exp (-1074) 53) (F2R (Float radix2 m e)) = (e + k)%Z) by (intro M; unfold cexp, FLT_exp; rewrite
    mag_F2R_Zdigits by exact M; lia).
  destruct (Z.le_gt_cases k 0) as [L|L].
  - rewrite kept; [unfold shortened; destruct (Z.leb_spec k 0); [reflexivity | lia]|]. apply generic_format_F2R. intro M. rewrite C by exact M. lia.
  - destruct (Z.eq_dec m 0) as [->|M].
    + unfold shortened. destruct (Z.leb_spec k 0); [lia|]. rewrite Z.shiftr_0_l, Z.shiftl_0_l, !F2R_0, rounded_0.
      unfold new_location, new_location_even, new_location_odd, to_nearest, cond_incr, round_N. destruct (Z.even (Z.shiftl 1 k)), Zeq_bool eqn:Z;
        try discriminate; apply F2R_0.
    + destruct (shortened_lies m e k L) as (n & l & -> & I). symmetry. apply (round_any_correct radix2 (FLT_exp (-1074) 53) ZnearestE to_nearest
        inbetween_int_NE _ _ _ _ I). left. symmetry. apply C, M.
Qed.
Lemma located_is_rounded x m e l : 0 <= x -> inbetween_float radix2 m e x l -> (e <= cexp radix2 (FLT_exp (-1074) 53) x)%Z -> F2R (near_located (m, e,
  l)) = rounded x.
Proof.
  intros P I E. unfold rounded. rewrite (round_trunc_any_correct' radix2 (FLT_exp (-1074) 53) ZnearestE to_nearest inbetween_int_NE x m e l P I
    (or_introl E)).
  unfold near_located. destruct (truncate _ _ _) as [[n k] o]. reflexivity.
Qed.

Definition sum_near (x y : dyadic) : dyadic := near_dyadic (Fplus x y).
Definition subtracted_near (x y : dyadic) : dyadic := near_dyadic (Fminus x y).
Definition product_near_of (x y : dyadic) : dyadic := near_dyadic (Fmult x y).
Definition quotient_near (x y : dyadic) : dyadic :=
  if (Fnum x =? 0)%Z then dyadic_zero
  else let q := near_located (Fdiv (FLT_exp (-1074) 53) (Fabs x) (Fabs y)) in if xorb (Fnum x <? 0)%Z (Fnum y <? 0)%Z then Fopp q else q.
Definition root_near (x : dyadic) : dyadic := if (Fnum x <=? 0)%Z then dyadic_zero else near_located (Fsqrt (FLT_exp (-1074) 53) x).
Definition whole_nearest (x : dyadic) : dyadic := shortened (- Fexp x) x.
Definition whole_under (x : dyadic) : dyadic := if (0 <=? Fexp x)%Z then x else Float radix2 (Z.shiftr (Fnum x) (- Fexp x)) 0.
Definition less (x y : dyadic) : bool := (Fnum (Fminus x y) <? 0)%Z.
Definition no_more (x y : dyadic) : bool := negb (less y x).
Definition equal (x y : dyadic) : bool := (Fnum (Fminus x y) =? 0)%Z.

Lemma sum_is x y : F2R (sum_near x y) = rounded (F2R x + F2R y).
Proof. unfold sum_near. rewrite near_is_rounded, F2R_plus. reflexivity. Qed.
Lemma subtracted_is x y : F2R (subtracted_near x y) = rounded (F2R x - F2R y).
Proof. unfold subtracted_near. rewrite near_is_rounded, F2R_minus. reflexivity. Qed.
Lemma product_is x y : F2R (product_near_of x y) = rounded (F2R x * F2R y).
Proof. unfold product_near_of. rewrite near_is_rounded, F2R_mult. reflexivity. Qed.
Lemma zero_is : F2R dyadic_zero = 0.
Proof. apply F2R_0. Qed.
Lemma sign_is (x : dyadic) : if (Fnum x <? 0)%Z then F2R x < 0 else if (Fnum x =? 0)%Z then F2R x = 0 else 0 < F2R x.
Proof.
  destruct x as [m e]. cbn [Fnum]. destruct (Z.ltb_spec m 0); [apply F2R_lt_0; assumption|]. destruct (Z.eqb_spec m 0) as [->|]; [apply F2R_0 | apply
    F2R_gt_0; cbn; lia].
Qed.
Lemma quotient_is x y : F2R y <> 0 -> F2R (quotient_near x y) = rounded (F2R x / F2R y).
Proof.
  intro Y. unfold quotient_near. pose proof sign_is x as X. pose proof sign_is y as S. destruct (Fnum x =? 0)%Z eqn:Zx.
  { destruct (Fnum x <? 0)%Z eqn:N; [lia|]. rewrite X, zero_is. unfold Rdiv. rewrite Rmult_0_l, rounded_0. reflexivity. }
  pose proof Fdiv_correct (FLT_exp (-1074) 53) (Fabs x) (Fabs y) as D. rewrite !F2R_abs in D. destruct (Fdiv _ _ _) as [[m e] l].
  assert (Px : 0 < Rabs (F2R x)) by (apply Rabs_pos_lt; destruct (Fnum x <? 0)%Z; lra). pose proof Rabs_pos_lt _ Y as Py. destruct (D Px Py) as [C I].
  assert (G : 0 <= Rabs (F2R x) / Rabs (F2R y)) by (apply Rlt_le, Rdiv_lt_0_compat; assumption). pose proof located_is_rounded _ _ _ _ G I C as L.
  destruct (Fnum y <? 0)%Z, (Fnum x <? 0)%Z; cbn [xorb]; try (destruct (Fnum y =? 0)%Z; [lra|]); rewrite ?F2R_opp, L, <- ?rounded_opp; f_equal;
    unfold Rabs; repeat destruct Rcase_abs; try lra; field; lra.
Qed.
Lemma root_is x : F2R (root_near x) = rounded (sqrt (F2R x)).
Proof.
  unfold root_near. pose proof sign_is x as X. destruct (Z.leb_spec (Fnum x) 0) as [L|L].
  - rewrite zero_is, sqrt_neg, rounded_0; [reflexivity|]. destruct (Z.ltb_spec (Fnum x) 0); [lra|]. destruct (Z.eqb_spec (Fnum x) 0); [lra | lia].
  - destruct (Z.ltb_spec (Fnum x) 0); [lia|]. destruct (Z.eqb_spec (Fnum x) 0); [lia|]. pose proof Fsqrt_correct (FLT_exp (-1074) 53) x X as D.
    destruct (Fsqrt _ _) as [[m e] l]. destruct D as [C I]. exact (located_is_rounded _ _ _ _ (sqrt_pos _) I C).
Qed.
Lemma whole_float m e : (0 <= e)%Z -> F2R (Float radix2 m e) = IZR (m * 2 ^ e).
Proof. intro E. unfold F2R. cbn [Fnum Fexp]. rewrite mult_IZR, <- IZR_Zpower by exact E. reflexivity. Qed.
Lemma whole_nearest_is x : F2R (whole_nearest x) = rint (F2R x).
Proof.
  destruct x as [m e]. unfold whole_nearest, rint. cbn [Fexp]. destruct (Z.le_gt_cases 0 e) as [L|L].
  - unfold shortened. destruct (Z.leb_spec (- e) 0); [|lia]. rewrite whole_float by exact L. f_equal. symmetry. apply Zrnd_IZR. apply valid_rnd_N.
  - destruct (shortened_lies m e (- e) ltac:(lia)) as (n & l & -> & I). rewrite Z.add_opp_diag_r in *. unfold inbetween_float in I.
    assert (W : forall w, F2R (Float radix2 w 0) = IZR w) by (intro w; rewrite whole_float, Z.mul_1_r by lia; reflexivity). rewrite !W in *. rewrite
    (inbetween_int_NE _ _ _ I). reflexivity.
Qed.
Lemma under_is x : F2R (whole_under x) = whole_below (F2R x).
Proof.
  destruct x as [m e]. unfold whole_under, whole_below. cbn [Fexp Fnum]. destruct (Z.leb_spec 0 e) as [L|L]; rewrite whole_float by lia; f_equal.
  - rewrite Zfloor_IZR. reflexivity.
  - rewrite Z.mul_1_r, Z.shiftr_div_pow2 by lia. rewrite <- Zfloor_div by (apply Z.pow_nonzero; lia). f_equal. unfold F2R. cbn [Fnum Fexp]. unfold
      Rdiv.
    f_equal. transitivity (/ bpow radix2 (- e)); [rewrite <- IZR_Zpower by lia; reflexivity | rewrite <- bpow_opp, Z.opp_involutive; reflexivity].
Qed.
Lemma less_is x y : less x y = if Rlt_dec (F2R x) (F2R y) then true else false.
Proof.
  unfold less. pose proof sign_is (Fminus x y) as S. rewrite F2R_minus in S. destruct (Fnum (Fminus x y) <? 0)%Z, Rlt_dec; try reflexivity; [lra|].
  destruct (Fnum (Fminus x y) =? 0)%Z; lra.
Qed.
Lemma equal_is x y : equal x y = if Req_EM_T (F2R x) (F2R y) then true else false.
Proof.
  unfold equal. pose proof sign_is (Fminus x y) as S. rewrite F2R_minus in S. destruct (Z.ltb_spec (Fnum (Fminus x y)) 0), (Z.eqb_spec (Fnum (Fminus x
    y)) 0), Req_EM_T; try reflexivity; exfalso; lia || lra.
Qed.

Definition rounding_dyadic : dyadic := Float radix2 1048577 (-73).
Definition slack_dyadic : dyadic := Float radix2 562949953421313 (-49).
Definition least_dyadic : dyadic := two_to (-1007).
Lemma rounding_is : F2R rounding_dyadic = 1048577 / 9444732965739290427392.
Proof. unfold F2R. simpl. lra. Qed.
Lemma slack_is : F2R slack_dyadic = 562949953421313 / 562949953421312.
Proof. unfold F2R. simpl. lra. Qed.
Lemma least_dyadic_is : F2R least_dyadic = 1 / 2 ^ 1007.
Proof. rewrite inverse_power. apply F2R_bpow. Qed.
Lemma two_to_is k : F2R (two_to k) = bpow radix2 k.
Proof. apply F2R_bpow. Qed.
Lemma one_is : F2R (two_to 0) = 1.
Proof. rewrite two_to_is. reflexivity. Qed.
Lemma count_is : F2R (two_to 53) = 9007199254740992.
Proof. rewrite two_to_is. simpl. lra. Qed.

(* A number that is found: its kind, and where it is known, its value and its count. *)
Definition found : Type := kind * option (dyadic * dyadic).
Definition rounding_found (x y : dyadic) : dyadic :=
  let total := sum_near x y in let part := subtracted_near total x in sum_near (subtracted_near x (subtracted_near total part)) (subtracted_near y
      part).
Definition sum_count (a b : kind) (x e y d : dyadic) : dyadic :=
  sum_near (sum_near e d) (if stays_exact a && stays_exact b || is_free a && is_free b then product_near_of (Fabs (rounding_found x y)) (two_to 53)
    else Fabs (sum_near x y)).
Definition zero_exactly (a : kind) (x e : dyadic) : bool := equal (Fplus (Fabs x) e) dyadic_zero && stays_exact a.
Definition scaled_count (a : kind) (k : Z) (x e : dyadic) : dyadic :=
  sum_near (product_near_of (two_to k) e) (if (0 <=? k)%Z then dyadic_zero else if stays_exact a then if no_more (Fabs (product_near_of x (two_to k)))
    (two_to (-1022)) then least_dyadic else dyadic_zero else least_dyadic).
Definition own_size (x : dyadic) : dyadic := sum_near (Fabs x) least_dyadic.
Definition product_count (a b : kind) (x e y d : dyadic) : dyadic :=
  if zero_exactly a x e || zero_exactly b y d then dyadic_zero
  else match scale_of a, scale_of b with
    | Some k, _ => scaled_count b k y d
    | _, Some k => scaled_count a k x e
    | _, _ => sum_near (sum_near (product_near_of (Fabs x) d) (product_near_of (sum_near (Fabs y) (product_near_of rounding_dyadic d)) e)) (own_size
      (product_near_of x y))
    end.
Definition quotient_count (a : kind) (x e y d : dyadic) : option dyadic :=
  let nearest := subtracted_near (Fabs y) (product_near_of rounding_dyadic d) in let size := own_size (quotient_near x y) in
  if zero_exactly a x e then Some dyadic_zero
  else if less dyadic_zero nearest then Some (sum_near (product_near_of (sum_near e (product_near_of size d)) (quotient_near (two_to 0) nearest))
      size)
  else None.
Definition root_count (x e : dyadic) : option dyadic :=
  if less e (product_near_of x (two_to 53)) then if equal (root_near x) dyadic_zero then None else Some (sum_near (quotient_near e (root_near x))
    (root_near x))
  else Some (sum_near (product_near_of (root_near e) (Float radix2 398065740123893 (-22))) (root_near x)).
Definition floor_count (x e : dyadic) : dyadic :=
  let bound := product_near_of rounding_dyadic e in let further := whole_under bound in product_near_of (two_to 53) (if no_more (Fabs
      (subtracted_near x
    (whole_nearest x))) (product_near_of bound slack_dyadic) && less dyadic_zero e then sum_near (two_to 0) further else further).
Definition few (e : dyadic) : bool := no_more e (two_to 60).
Definition scale_fits (a : kind) (x e d : dyadic) : bool :=
  match scale_of a with Some k => equal (Fabs x) (two_to k) && equal e dyadic_zero && ((0 <=? k)%Z || equal d dyadic_zero || no_more least_dyadic
      (Fmult
    (two_to k) d)) | None => true end.
Definition is_written (m e : Z) : bool := ((Z.abs m <? 2 ^ 53) && (-1074 <=? e))%Z.
Definition counted_by (x : dyadic) (count : option dyadic) : option (dyadic * dyadic) := match count with Some e => Some (x, e) | None => None end.
(* What an operation gives, where its rule allows what it takes. *)
Definition rule_found (o : recorded_pixel.operation) (given : list (kind * (dyadic * dyadic))) : option (dyadic * dyadic) :=
  match o, given with
  | recorded_pixel.Literal m e, [] => if is_written m e then Some (Float radix2 m e, dyadic_zero) else None
  | recorded_pixel.Infinite, [] => Some (two_to 1023, dyadic_zero)
  | recorded_pixel.Constant m e, [] => let k := (SpecFloat.Zdigits2 m + e - 1)%Z in if is_written m e && (-1074 <=? k)%Z then Some (Float radix2 m e,
    two_to k) else None
  | recorded_pixel.Neg, [(_, (x, e))] => Some (Fopp x, e)
  | recorded_pixel.Add, [(a, (x, e)); (b, (y, d))] => Some (sum_near x y, sum_count a b x e y d)
  | recorded_pixel.Sub, [(a, (x, e)); (b, (y, d))] => Some (subtracted_near x y, sum_count a b x e (Fopp y) d)
  | recorded_pixel.Mul, [(a, (x, e)); (b, (y, d))] => if few e && few d && scale_fits a x e d && scale_fits b y d e then Some (product_near_of x y,
    product_count a b x e y d) else None
  | recorded_pixel.Truediv, [(a, (x, e)); (_, (y, d))] =>
    if negb (equal y dyadic_zero) && no_more (Fabs y) (two_to 960) && no_more (two_to (-59)) (Fminus (Fabs y) (Fmult (Fmult (two_to (-53)) d) (Fplus
    (two_to (-19)) (two_to 0)))) then
      counted_by (quotient_near x y) (quotient_count a x e y d)
    else None
  | recorded_pixel.Sqrt, [(_, (x, e))] => if no_more dyadic_zero x then counted_by (root_near x) (root_count x e) else None
  | recorded_pixel.Floor, [(_, (x, e))] => if few e then Some (whole_under x, floor_count x e) else None
  | _, _ => None
  end.

(* A constant is a float64 number next to what it stands for: half of its last digit away at most. *)
Definition nearest_constants (constants : Z -> Z -> R * R) := forall m e, snd (constants m e) = bpow radix2 (SpecFloat.Zdigits2 m + e - 1) /\ Rabs
  (literal m e - fst (constants m e)) <= snd (constants m e) / 2 ^ 53.
Definition pair_in_reals (n : dyadic * dyadic) : R * R := (F2R (fst n), F2R (snd n)).
Definition in_reals (n : kind * (dyadic * dyadic)) : kind * (R * R) := (fst n, pair_in_reals (snd n)).

Ltac in_real_numbers := repeat match goal with
  | |- context [F2R (sum_near ?x ?y)] => rewrite (sum_is x y)
  | |- context [F2R (subtracted_near ?x ?y)] => rewrite (subtracted_is x y)
  | |- context [F2R (product_near_of ?x ?y)] => rewrite (product_is x y)
  | |- context [F2R (whole_nearest ?x)] => rewrite (whole_nearest_is x)
  | |- context [F2R (whole_under ?x)] => rewrite (under_is x)
  | |- context [F2R (root_near ?x)] => rewrite (root_is x)
  | |- context [F2R (Fabs ?x)] => rewrite (F2R_abs x)
  | |- context [F2R (Fplus ?x ?y)] => rewrite (F2R_plus x y)
  | |- context [F2R (Fmult ?x ?y)] => rewrite (F2R_mult x y)
  | |- context [F2R rounding_dyadic] => rewrite rounding_is
  | |- context [F2R slack_dyadic] => rewrite slack_is
  | |- context [F2R least_dyadic] => rewrite least_dyadic_is
  | |- context [F2R dyadic_zero] => rewrite zero_is
  | |- context [F2R (two_to 0)] => rewrite one_is
  | |- context [F2R (two_to 53)] => rewrite count_is
  | |- context [F2R (two_to ?k)] => rewrite (two_to_is k)
  end.
Lemma at_most_is x y : no_more x y = if Rle_dec (F2R x) (F2R y) then true else false.
Proof. unfold no_more. rewrite less_is. destruct Rlt_dec, Rle_dec; try reflexivity; lra. Qed.
Lemma is_at_most x y : no_more x y = true -> F2R x <= F2R y.
Proof. rewrite at_most_is. destruct Rle_dec; [trivial | discriminate]. Qed.
Lemma is_few e : few e = true -> F2R e <= 2 ^ 60.
Proof. intro H. apply is_at_most in H. rewrite two_to_is in H. simpl in H. lra. Qed.
Lemma zero_exactly_is a x e : zero_exactly a x e = exact_zero a (F2R x) (F2R e).
Proof. unfold zero_exactly, exact_zero. rewrite equal_is. in_real_numbers. destruct Req_EM_T; reflexivity. Qed.
Lemma sum_count_is a b x e y d : F2R (sum_count a b x e y d) = count_of_sum a b (F2R x) (F2R e) (F2R y) (F2R d).
Proof.
  unfold sum_count, count_of_sum, rounding_found, found_rounding, enclosed_sum_float64.total_error. destruct (_ || _)%bool; in_real_numbers;
      reflexivity.
Qed.
Lemma scaled_count_is a k x e : F2R (scaled_count a k x e) = count_of_scaled a k (F2R x) (F2R e).
Proof.
  unfold scaled_count, count_of_scaled. destruct (0 <=? k)%Z, (stays_exact a); rewrite ?at_most_is; in_real_numbers; try reflexivity. destruct
      Rle_dec;
    in_real_numbers; reflexivity.
Qed.
Lemma product_count_is a b x e y d : F2R (product_count a b x e y d) = count_of_product a b (F2R x) (F2R e) (F2R y) (F2R d).
Proof.
  unfold product_count, count_of_product, own_size, enclosed_product_float64.product_error. rewrite !zero_exactly_is. destruct (_ || _)%bool; [apply
    zero_is|]. destruct (scale_of a), (scale_of b); try apply scaled_count_is. in_real_numbers. reflexivity.
Qed.
Lemma quotient_count_is a x e y d c : F2R y <> 0 -> quotient_count a x e y d = Some c -> F2R c = if exact_zero a (F2R x) (F2R e) then 0 else
  enclosed_quotient_float64.quotient_error (F2R x) (F2R e) (F2R y) (F2R d).
Proof.
  intro Y. unfold quotient_count, own_size, enclosed_quotient_float64.quotient_error. rewrite zero_exactly_is, less_is. destruct (exact_zero _ _ _);
    [intros [= <-]; apply zero_is|]. in_real_numbers. destruct Rlt_dec as [P|]; [|discriminate]. intros [= <-].
  in_real_numbers. rewrite !quotient_is by (in_real_numbers; lra). in_real_numbers. reflexivity.
Qed.
Lemma root_count_is x e c : root_count x e = Some c -> F2R c = enclosed_root_float64.root_error (F2R x) (F2R e).
Proof.
  unfold root_count, enclosed_root_float64.root_error. rewrite less_is. in_real_numbers. destruct Rlt_dec.
  - rewrite equal_is. in_real_numbers. destruct Req_EM_T as [|N]; [discriminate|]. intros [= <-]. in_real_numbers. rewrite quotient_is by
      (in_real_numbers;
      exact N). in_real_numbers. reflexivity.
  - intros [= <-]. in_real_numbers. reflexivity.
Qed.
Lemma floor_count_is x e : F2R (floor_count x e) = enclosed_floor_float64.below_error (F2R x) (F2R e).
Proof.
  unfold floor_count, enclosed_floor_float64.below_error, both, Sumbool.sumbool_and. rewrite at_most_is, less_is. in_real_numbers. destruct Rle_dec,
      Rlt_dec;
    cbn [andb]; in_real_numbers; reflexivity.
Qed.
Lemma scale_is_allowed a x e d : scale_fits a x e d = true -> scale_allowed a (F2R x) (F2R e) (F2R d).
Proof.
  unfold scale_fits, scale_allowed. destruct (scale_of a) as [k|]; [|trivial]. rewrite !equal_is, at_most_is, !andb_true_iff, !orb_true_iff.
  in_real_numbers. intros [[X E] D]. destruct Req_EM_T as [X'|] in X; [|discriminate]. destruct Req_EM_T as [E'|] in E; [|discriminate]. split; [exact
    X' | split; [exact E'|]].
  destruct D as [[D|D]|D]; [left; lia | right; left; destruct Req_EM_T in D; [assumption | discriminate] | right; right; destruct Rle_dec in D;
    [assumption | discriminate]].
Qed.
Lemma power_is n : F2R (two_to (Z.of_nat n)) = 2 ^ n.
Proof. rewrite two_to_is, bpow_powerRZ, <- pow_powerRZ. reflexivity. Qed.
Ltac asked H W := match type of H with (if ?c then _ else _) = _ => destruct c eqn:W; [|discriminate H] end.
Lemma by_rule_is constants o given x e : nearest_constants constants -> rule_found o given = Some (x, e) ->
  let o := operation_of constants o in let given := map in_reals given in
  allowed o given /\ in_float64 o (map fst (map snd given)) = F2R x /\ counted_roundings o given = F2R e.
Proof.
  intros N H. destruct o; destruct given as [|[a [y ey]] [|[b [z ez]] [|third given]]]; try discriminate H; cbn [rule_found operation_of allowed
      in_float64
    counted_roundings map in_reals pair_in_reals fst snd] in *; unfold is_written, counted_by in *.
  - asked H W. injection H as <- <-. rewrite zero_is. repeat split; lia.
  - injection H as <- <-. rewrite zero_is, two_to_is. unfold literal. rewrite Rmult_1_l. repeat split; easy.
  - asked H W. injection H as <- <-. destruct (N m e0) as [C D]. rewrite two_to_is, <- C. split; [|split; reflexivity]. split; [apply
      whole_is_float64;
      lia|]. cbn [fst snd]. rewrite C in *. split; [apply generic_format_bpow; unfold FLT_exp; lia|].
    split; [apply bpow_ge_0 | lra].
  - injection H as <- <-. rewrite F2R_opp. repeat split.
  - injection H as <- <-. rewrite sum_is, sum_count_is. repeat split.
  - injection H as <- <-. rewrite subtracted_is, sum_count_is, F2R_opp. repeat split.
  - asked H W. injection H as <- <-. rewrite !andb_true_iff in W. destruct W as [[[U V] A] B]. rewrite product_is, product_count_is.
    repeat split; (apply is_few || apply scale_is_allowed); assumption.
  - asked H W. rewrite !andb_true_iff, negb_true_iff, equal_is, zero_is in W. destruct W as [[Z U] V]. destruct Req_EM_T as [|Y] in Z;
      [discriminate|].
    apply is_at_most in U, V. change (two_to 960) with (two_to (Z.of_nat 960)) in U. rewrite power_is, F2R_abs in U.
    rewrite F2R_minus, !F2R_mult, F2R_plus, F2R_abs, one_is, !two_to_is in V. pose proof fun n => eq_sym (inverse_power n) as P. rewrite (P 59%nat :
    bpow
      radix2 (-59) = _), (P 53%nat : bpow radix2 (-53) = _), (P 19%nat : bpow radix2 (-19) = _) in V.
    destruct (quotient_count _ _ _ _ _) as [c|] eqn:Q; [|discriminate]. injection H as <- <-. rewrite quotient_is by exact Y. rewrite
    (quotient_count_is
      _ _ _ _ _ _ Y Q).
    split; [split; [exact U | lra] | split; reflexivity].
  - asked H U. apply is_at_most in U. rewrite zero_is in U. destruct (root_count y ey) as [c|] eqn:Q; [|discriminate]. injection H as <- <-.
    rewrite root_is, (root_count_is _ _ _ Q). split; [apply Rle_ge, U | split; reflexivity].
  - asked H U. injection H as <- <-. rewrite under_is, floor_count_is. split; [apply is_few, U | split; reflexivity].
Qed.
