(* Ranges of float64 numbers, each with a bound of how far it is from what it stands for: the rules of operations, computed on dyadic numbers, whole
  numbers times powers of two. *)

From Coq Require Import Reals Lra Lia ZArith List Bool.
From Flocq Require Import Core Operations Round Div Sqrt Bracket.
From Formal Require Import Preliminaries Float Float64 RoundedHalfTurns Rounding EnclosingRules.
Open Scope R_scope.
Import ListNotations.

Definition dyadic : Type := float radix2.
Definition dyadic_zero : dyadic := Float radix2 0 0.
Definition two_to (k : Z) : dyadic := Float radix2 1 k.

(* To the nearest, ties to even. *)
Definition to_nearest (m : Z) (l : SpecFloat.location) : Z := cond_incr (round_N (negb (Z.even m)) l) m.
Definition near_located (located : Z * Z * SpecFloat.location) : dyadic :=
  let '(m, e, l) := truncate radix2 (FLT_exp (-1074) 53) located in Float radix2 (to_nearest m l) e.
Definition near_dyadic (x : dyadic) : dyadic :=
  let (m, e) := x in let k := Z.max (SpecFloat.Zdigits2 m - 53) (-1074 - e) in
  if (k <=? 0)%Z then x
  else let q := Z.shiftr m k in Float radix2 (to_nearest q (new_location (Z.shiftl 1 k) (m - Z.shiftl q k) SpecFloat.loc_Exact)) (e + k).
(* No less, of 64 digits at most. *)
Definition no_less (x : dyadic) : dyadic :=
  let (m, e) := x in let k := (SpecFloat.Zdigits2 m - 64)%Z in if (k <=? 0)%Z then x else Float radix2 (Z.shiftr m k + 1) (e + k).

Lemma near_is_rounded x : F2R (near_dyadic x) = rounded (F2R x).
Proof.
  destruct x as [m e]. unfold near_dyadic. rewrite Zdigits2_Zdigits. set (k := Z.max _ _).
  assert (C : m <> 0%Z -> cexp radix2 (FLT_exp (-1074) 53) (F2R (Float radix2 m e)) = (e + k)%Z) by (intro M; unfold cexp, FLT_exp; rewrite
    mag_F2R_Zdigits by exact M; lia).
  destruct (Z.leb_spec k 0) as [L|L]; [symmetry; apply kept, generic_format_F2R; intro M; rewrite C by exact M; lia|].
  destruct (Z.eq_dec m 0) as [->|M].
  - rewrite Z.shiftr_0_l, Z.shiftl_0_l, !F2R_0, rounded_0. unfold new_location, new_location_even, new_location_odd, to_nearest, cond_incr, round_N.
    destruct (Z.even (Z.shiftl 1 k)), Zeq_bool eqn:Z; try discriminate; apply F2R_0.
  - symmetry. apply (round_any_correct radix2 (FLT_exp (-1074) 53) ZnearestE to_nearest inbetween_int_NE); [|left; symmetry; apply C, M]. rewrite
    !Z.shiftl_mul_pow2, Z.mul_1_l, Z.shiftr_div_pow2 by lia. rewrite (Z.mul_comm (m / 2 ^ k)), <- Z.mod_eq by (apply Z.pow_nonzero; lia). apply
    (inbetween_float_new_location radix2); [exact L|]. constructor. reflexivity.
Qed.
Lemma no_less_is x : F2R x <= F2R (no_less x).
Proof.
  destruct x as [m e]. unfold no_less. set (k := (_ - 64)%Z). destruct (Z.leb_spec k 0) as [|L]; [apply Rle_refl|].
  rewrite (F2R_change_exp radix2 e _ (e + k)) by lia. apply F2R_le. rewrite Z.add_simpl_l, Z.shiftr_div_pow2 by lia. change (Zpower _ k) with (2 ^
    k)%Z.
  assert (P : (0 < 2 ^ k)%Z) by (apply Z.pow_pos_nonneg; lia). pose proof Z.div_mod m (2 ^ k). pose proof Z.mod_pos_bound m _ P. nia.
Qed.
Lemma located_is_rounded x m e l : 0 <= x -> inbetween_float radix2 m e x l -> (e <= cexp radix2 (FLT_exp (-1074) 53) x)%Z -> F2R (near_located (m, e,
  l)) = rounded x.
Proof.
  intros P I E. unfold rounded. rewrite (round_trunc_any_correct' radix2 (FLT_exp (-1074) 53) ZnearestE to_nearest inbetween_int_NE x m e l P I
    (or_introl E)).
  unfold near_located. destruct (truncate _ _ _) as [[n k] o]. reflexivity.
Qed.

Definition quotient_near (x y : dyadic) : dyadic :=
  if (Fnum x =? 0)%Z then dyadic_zero
  else let q := near_located (Fdiv (FLT_exp (-1074) 53) (Fabs x) (Fabs y)) in if xorb (Fnum x <? 0)%Z (Fnum y <? 0)%Z then Fopp q else q.
Definition root_near (x : dyadic) : dyadic := if (Fnum x <=? 0)%Z then dyadic_zero else near_located (Fsqrt (FLT_exp (-1074) 53) x).
Definition whole_under (x : dyadic) : dyadic := if (0 <=? Fexp x)%Z then x else Float radix2 (Z.shiftr (Fnum x) (- Fexp x)) 0.
Definition less (x y : dyadic) : bool := (Fnum (Fminus x y) <? 0)%Z.
Definition no_more (x y : dyadic) : bool := negb (less y x).
Definition larger (x y : dyadic) : dyadic := if less x y then y else x.
Definition smaller (x y : dyadic) : dyadic := if less x y then x else y.
Definition size_of (l h : dyadic) : dyadic := larger (Fabs l) (Fabs h).

Lemma zero_is : F2R dyadic_zero = 0.
Proof. apply F2R_0. Qed.
Lemma two_to_is k : F2R (two_to k) = bpow radix2 k.
Proof. apply F2R_bpow. Qed.
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
  destruct (Fnum y <? 0)%Z, (Fnum x <? 0)%Z; cbn [xorb]; try (destruct (Fnum y =? 0)%Z; [lra|]); rewrite ?F2R_opp, L, <- ?rounded_opp; f_equal; unfold
    Rabs; repeat destruct Rcase_abs; try lra; field; lra.
Qed.
Lemma root_is x : F2R (root_near x) = rounded (sqrt (F2R x)).
Proof.
  unfold root_near. pose proof sign_is x as X. destruct (Z.leb_spec (Fnum x) 0) as [L|L].
  - rewrite zero_is, sqrt_neg, rounded_0; [reflexivity|]. destruct (Z.ltb_spec (Fnum x) 0); [lra|]. destruct (Z.eqb_spec (Fnum x) 0); [lra | lia].
  - destruct (Z.ltb_spec (Fnum x) 0); [lia|]. destruct (Z.eqb_spec (Fnum x) 0); [lia|]. pose proof Fsqrt_correct (FLT_exp (-1074) 53) x X as D.
    destruct (Fsqrt _ _) as [[m e] l]. destruct D as [C I]. exact (located_is_rounded _ _ _ _ (sqrt_pos _) I C).
Qed.
Lemma under_is x : F2R (whole_under x) = whole_below (F2R x).
Proof.
  destruct x as [m e]. unfold whole_under, whole_below. cbn [Fexp Fnum].
  assert (W : forall n k, (0 <= k)%Z -> F2R (Float radix2 n k) = IZR (n * 2 ^ k)) by (intros n k K; unfold F2R; cbn [Fnum Fexp]; rewrite mult_IZR, <-
    IZR_Zpower by exact K; reflexivity).
  destruct (Z.leb_spec 0 e) as [L|L]; rewrite W by lia; f_equal; [rewrite Zfloor_IZR; reflexivity|]. rewrite Z.mul_1_r, Z.shiftr_div_pow2 by lia.
    rewrite <- Zfloor_div by (apply Z.pow_nonzero; lia). f_equal. unfold F2R, Rdiv. cbn [Fnum Fexp]. f_equal.
  transitivity (/ bpow radix2 (- e)); [rewrite <- IZR_Zpower by lia; reflexivity | rewrite <- bpow_opp, Z.opp_involutive; reflexivity].
Qed.
Lemma less_is x y : less x y = if Rlt_dec (F2R x) (F2R y) then true else false.
Proof.
  unfold less. pose proof sign_is (Fminus x y) as S. rewrite F2R_minus in S. destruct (Fnum (Fminus x y) <? 0)%Z, Rlt_dec; try reflexivity; [lra|].
  destruct (Fnum (Fminus x y) =? 0)%Z; lra.
Qed.
Lemma is_less x y : less x y = true -> F2R x < F2R y.
Proof. rewrite less_is. destruct Rlt_dec; [trivial | discriminate]. Qed.
Lemma is_no_more x y : no_more x y = true -> F2R x <= F2R y.
Proof. unfold no_more. rewrite less_is. destruct Rlt_dec; [discriminate | lra]. Qed.
Lemma larger_is x y : F2R (larger x y) = Rmax (F2R x) (F2R y).
Proof. unfold larger, Rmax. rewrite less_is. destruct Rlt_dec, Rle_dec; lra. Qed.
Lemma smaller_is x y : F2R (smaller x y) = Rmin (F2R x) (F2R y).
Proof. unfold smaller, Rmin. rewrite less_is. destruct Rlt_dec, Rle_dec; lra. Qed.
Ltac ends := rewrite ?larger_is, ?smaller_is, ?F2R_abs in *; unfold Rmax, Rmin, Rabs in *; repeat destruct Rle_dec; repeat destruct Rcase_abs; lra.
Lemma size_is l h v : F2R l <= v <= F2R h -> Rabs v <= F2R (size_of l h).
Proof. unfold size_of. intro. ends. Qed.

(* A float64 number between two ends, and how far it may be off. *)
Inductive range : Type := Range (low high off : dyadic).
Definition lies (c : range) (v x : R) : Prop := match c with Range l h e => F2R l <= v <= F2R h /\ Rabs (v - x) <= F2R e end.
Definition point (n : dyadic) : range := Range n n dyadic_zero.
Lemma point_lies n : lies (point n) (F2R n) (F2R n).
Proof. unfold lies, point. rewrite zero_is, Rminus_eq_0, Rabs_R0. lra. Qed.

(* A result is rounded once: in a range by a digit of its larger end, and at a point by as much as it is. *)
Definition rounding_of (x : dyadic) : dyadic := Fplus (Fmult (Float radix2 9007199254740996 (-106)) x) (two_to (-200)).
Definition widened (l h e : dyadic) : range := Range l h (no_less (Fplus e (rounding_of (size_of l h)))).
Definition rounded_once (l h e : dyadic) : range :=
  let a := near_dyadic l in let b := near_dyadic h in if less l h then widened a b e else Range a b (no_less (Fplus e (Fabs (Fminus a l)))).
Lemma widened_lies l h e t x : F2R l <= rounded t <= F2R h -> Rabs (t - x) <= F2R e -> lies (widened l h e) (rounded t) x.
Proof.
  intros B D. split; [exact B|]. eapply Rle_trans; [|apply no_less_is]. unfold rounding_of. rewrite !F2R_plus, F2R_mult, two_to_is.
  pose proof own_rounding t as O. pose proof underflow_is_small as U. rewrite (inverse_power 200) in U. change (- Z.of_nat 200)%Z with (-200)%Z in U.
    apply size_is in B. replace (F2R (Float radix2 9007199254740996 (-106))) with ((1 + 4 * unit53) * unit53) by (unfold F2R, unit53; simpl; lra).
  assert ((1 + 4 * unit53) * unit53 * Rabs (rounded t) <= (1 + 4 * unit53) * unit53 * F2R (size_of l h)) by (apply Rmult_le_compat_l; [unfold unit53;
    lra | exact B]).
  replace (rounded t - x) with (rounded t - t + (t - x)) by ring. at_most_by Rabs_triang. lra.
Qed.
Lemma rounded_rises x y : x <= y -> rounded x <= rounded y.
Proof. apply round_le; [typeclasses eauto..]. Qed.
Lemma rounded_once_lies l h e t x : F2R l <= t <= F2R h -> Rabs (t - x) <= F2R e -> lies (rounded_once l h e) (rounded t) x.
Proof.
  intros B D. assert (E : F2R (near_dyadic l) <= rounded t <= F2R (near_dyadic h)) by (rewrite !near_is_rounded; split; apply rounded_rises; lra).
    unfold rounded_once. rewrite less_is. destruct Rlt_dec; [apply widened_lies; assumption|]. split; [exact E|].
  eapply Rle_trans; [|apply no_less_is]. assert (t = F2R l) by lra. subst t. rewrite F2R_plus, F2R_abs, F2R_minus, near_is_rounded. replace (rounded
    (F2R l) - x) with (F2R l - x + (rounded (F2R l) - F2R l)) by ring. at_most_by Rabs_triang. lra.
Qed.

Definition negated (c : range) : range := let (l, h, e) := c in Range (Fopp h) (Fopp l) e.
Definition sum_range (c d : range) : range := let (l, h, e) := c in let (a, b, f) := d in rounded_once (Fplus l a) (Fplus h b) (Fplus e f).
(* What is monotone in each factor has its ends at corners. *)
Definition lowest_corner (f : dyadic -> dyadic -> dyadic) (l h a b : dyadic) : dyadic := smaller (smaller (f l a) (f l b)) (smaller (f h a) (f h b)).
Definition highest_corner (f : dyadic -> dyadic -> dyadic) (l h a b : dyadic) : dyadic := larger (larger (f l a) (f l b)) (larger (f h a) (f h b)).
Definition product_range (c d : range) : range :=
  let (l, h, e) := c in let (a, b, f) := d in
  rounded_once (lowest_corner (Fmult (beta:=radix2)) l h a b) (highest_corner (Fmult (beta:=radix2)) l h a b) (Fplus (Fmult (size_of l h) f) (Fmult (Fplus
    (size_of
    a b) f) e)).
(* A bound is guessed, and then tried. *)
Definition guessed (x : dyadic) : dyadic := Fmult (Float radix2 1099511627777 (-40)) x.
Definition quotient_range (c d : range) : option range :=
  let (l, h, e) := c in let (a, b, f) := d in
  let least := Fminus (smaller (Fabs a) (Fabs b)) f in let moved := Fplus (Fmult least e) (Fmult (size_of l h) f) in
  let off := guessed (quotient_near moved (Fmult least least)) in
  if less dyadic_zero (Fmult a b) && less dyadic_zero least && no_more moved (Fmult off (Fmult least least)) then
    Some (widened (lowest_corner quotient_near l h a b) (highest_corner quotient_near l h a b) off)
  else None.
Definition root_range (c : range) : option range :=
  let (l, h, e) := c in let least := Fmult (Float radix2 1099511627775 (-40)) (root_near l) in
  let off := guessed (if less e l then quotient_near e least else root_near e) in
  if no_more dyadic_zero l && no_more dyadic_zero off && (no_more e (Fmult off off) || less dyadic_zero least && no_more (Fmult least least) l &&
    no_more e
    (Fmult off least)) then Some (widened (root_near l) (root_near h) off)
  else None.
Definition floor_range (c : range) : option range :=
  let (l, h, e) := c in let n := whole_under l in if no_more n (Fminus l e) && less (Fplus h e) (Fplus n (two_to 0)) then Some (point n) else None.

Lemma negated_lies c v x : lies c v x -> lies (negated c) (- v) (- x).
Proof. destruct c as [l h e]. intros [B D]. unfold lies, negated. rewrite !F2R_opp. replace (- v - - x) with (- (v - x)) by ring. rewrite Rabs_Ropp.
  lra. Qed.
Lemma sum_lies c d v x w y : lies c v x -> lies d w y -> lies (sum_range c d) (rounded (v + w)) (x + y).
Proof.
  destruct c as [l h e], d as [a b f]. intros [B D] [C F]. apply rounded_once_lies; rewrite !F2R_plus; [lra|]. replace (v + w - (x + y)) with (v - x
    + (w - y)) by ring. at_most_by Rabs_triang. lra.
Qed.
Lemma corner_under a b c d v w : a <= v <= b -> c <= w <= d -> exists p q, (p = a \/ p = b) /\ (q = c \/ q = d) /\ p * q <= v * w.
Proof.
  intros V W. assert (P : exists p, (p = a \/ p = b) /\ p * w <= v * w).
  { destruct (Rle_lt_dec 0 w); [exists a | exists b]; split; try tauto; [apply Rmult_le_compat_r; lra | nra]. }
  destruct P as (p & P & L). exists p. destruct (Rle_lt_dec 0 p); [exists c | exists d]; repeat split; try tauto; (eapply Rle_trans; [|exact L]); nra.
Qed.
Lemma corners (g : R -> R) a b c d v w : (forall x y, x <= y -> g x <= g y) -> a <= v <= b -> c <= w <= d -> Rmin (Rmin (g (a * c)) (g (a * d))) (Rmin
  (g (b * c)) (g (b * d))) <= g (v * w) <= Rmax (Rmax (g (a * c)) (g (a * d))) (Rmax (g (b * c)) (g (b * d))).
Proof.
  intros M V W. destruct (corner_under a b c d v w V W) as (p & q & P & Q & L). destruct (corner_under (- b) (- a) c d (- v) w ltac:(lra) W) as (r & s
    & T & S & U).
  assert (U' : v * w <= - r * s) by lra. apply M in L, U'. split.
  - eapply Rle_trans; [|exact L]. clear - P Q. destruct P as [-> | ->], Q as [-> | ->]; unfold Rmin; repeat destruct Rle_dec; lra.
  - eapply Rle_trans; [exact U'|]. clear - T S. destruct T as [-> | ->], S as [-> | ->]; rewrite Ropp_involutive; unfold Rmax; repeat destruct
    Rle_dec; lra.
Qed.
Ltac at_corners := unfold lowest_corner, highest_corner; rewrite !smaller_is, !larger_is.
Lemma product_lies c d v x w y : lies c v x -> lies d w y -> lies (product_range c d) (rounded (v * w)) (x * y).
Proof.
  destruct c as [l h e], d as [a b f]. intros [B D] [C F]. apply rounded_once_lies.
  - at_corners. rewrite !F2R_mult. exact (corners (fun x => x) _ _ _ _ v w (fun x y L => L) B C).
  - apply size_is in B, C. rewrite F2R_plus, !F2R_mult, F2R_plus. replace (v * w - x * y) with (v * (w - y) + y * (v - x)) by ring. at_most_by
    Rabs_triang. rewrite !Rabs_mult. assert (Rabs y <= F2R (size_of a b) + F2R f) by (generalize (Rabs_triang_inv y w); rewrite (Rabs_minus_sym y w);
    lra). apply Rplus_le_compat; apply Rmult_le_compat; try apply Rabs_pos; assumption.
Qed.
Lemma inverse_between a b : 0 < a * b -> a <= b -> / b <= / a.
Proof. intros P L. apply Rmult_le_reg_r with (a * b); [exact P|]. replace (/ b * (a * b)) with a by (field; nra). replace (/ a * (a * b)) with b by
  (field; nra).
  exact L. Qed.
Lemma quotient_lies c d v x w y r : lies c v x -> lies d w y -> quotient_range c d = Some r -> y <> 0 /\ lies r (rounded (v / w)) (x / y).
Proof.
  destruct c as [l h e], d as [a b f]. intros [B D] [C F]. unfold quotient_range. set (n := Fminus _ f). set (off := guessed _). destruct (_ &&
    _)%bool eqn:G; [|discriminate]. intros [= <-].
  rewrite !andb_true_iff in G. destruct G as [[S N] M]. apply is_less in S, N. apply is_no_more in M. rewrite zero_is in S, N. rewrite F2R_plus,
    !F2R_mult in *. assert (Nw : F2R n + F2R f <= Rabs w) by (unfold n; rewrite F2R_minus; assert (0 < F2R a \/ F2R b < 0) by nra; ends).
  assert (Ny : F2R n <= Rabs y) by (generalize (Rabs_triang_inv w y); lra). pose proof Rabs_pos (w - y). assert (W : w <> 0) by (intros ->; rewrite
    Rabs_R0 in Nw; lra). assert (Y : y <> 0) by (intros ->; rewrite Rabs_R0 in Ny; lra). split; [exact Y|].
  assert (Aw : 0 < Rabs w) by (apply Rabs_pos_lt, W). assert (Ay : 0 < Rabs y) by (apply Rabs_pos_lt, Y). apply widened_lies.
  - at_corners. assert (P : F2R a <> 0 /\ F2R b <> 0) by nra. rewrite !quotient_is by apply P. unfold Rdiv. apply size_is in B as B'. clear - B C S W.
    assert (T : 0 < F2R a * w /\ 0 < w * F2R b) by nra. pose proof corners rounded (F2R l) (F2R h) (/ F2R b) (/ F2R a) v (/ w) rounded_rises B (conj
    (inverse_between _ _ (proj2 T) (proj2 C)) (inverse_between _ _ (proj1 T) (proj1 C))) as K. rewrite (Rmin_comm (rounded (F2R l * / F2R b))),
    (Rmin_comm (rounded (F2R h * / F2R b))), (Rmax_comm (rounded (F2R l * / F2R b))), (Rmax_comm (rounded (F2R h * / F2R b))) in K. exact K.
  - apply size_is in B. replace (v / w - x / y) with ((v - x) * / y + v * (y - w) * (/ w * / y)) by (field; split; assumption). at_most_by
    Rabs_triang. rewrite !Rabs_mult, !Rabs_inv, (Rabs_minus_sym y w). set (s := F2R (size_of l h)) in *. assert (I : / Rabs y <= / F2R n /\ / Rabs w
    <= / F2R n) by (split; apply Rinv_le_contravar; lra). assert (0 < / Rabs y /\ 0 < / Rabs w) by (split; apply Rinv_0_lt_compat; assumption). apply
    Rle_trans with (F2R e * / F2R n + s * F2R f * (/ F2R n * / F2R n)).
    + pose proof Rabs_pos (v - x). pose proof Rabs_pos v. apply Rplus_le_compat; repeat (apply Rmult_le_compat); try lra; repeat apply Rmult_le_pos;
      lra.
    + apply Rmult_le_reg_r with (F2R n * F2R n); [nra|]. replace (_ * (F2R n * F2R n)) with (F2R n * F2R e + s * F2R f) by (field; lra). exact M.
Qed.
Lemma root_lies c v x r : lies c v x -> root_range c = Some r -> lies r (rounded (sqrt v)) (sqrt x).
Proof.
  destruct c as [l h e]. intros [B D]. unfold root_range. set (s := Fmult _ (root_near l)). set (off := guessed _). destruct (_ && _)%bool eqn:G;
    [|discriminate]. intros [= <-].
  rewrite !andb_true_iff, orb_true_iff, !andb_true_iff in G. destruct G as [[L P] G]. apply is_no_more in L, P. rewrite zero_is in L, P. apply
    widened_lies.
  - rewrite !root_is. split; apply rounded_rises, sqrt_le_1_alt; lra.
  - assert (E : sqrt x = sqrt (Rmax 0 x) /\ Rabs (v - Rmax 0 x) <= F2R e) by (unfold Rmax; destruct Rle_dec; split; try reflexivity; [exact D |
    rewrite sqrt_0; apply sqrt_neg; lra | revert D; unfold Rabs; repeat destruct Rcase_abs; lra]). destruct E as [-> E]. destruct (root_moved v (Rmax
    0 x) ltac:(lra) (Rmax_l 0 x)) as [M1 M2]. destruct G as [G | [[S Q] G]]; apply is_no_more in G; rewrite F2R_mult in G.
    + eapply Rle_trans; [exact M2|]. rewrite <- (sqrt_square (F2R off)) by exact P. apply sqrt_le_1_alt. lra.
    + apply is_less in S. apply is_no_more in Q. rewrite F2R_mult in Q. rewrite zero_is in S. assert (T : F2R s <= sqrt v) by (rewrite <- (sqrt_square
      (F2R s)) by lra; apply sqrt_le_1_alt; lra). pose proof Rabs_pos (sqrt v - sqrt (Rmax 0 x)). apply Rmult_le_reg_r with (F2R s); [exact S|].
      eapply Rle_trans; [|exact G]. eapply Rle_trans; [|exact E]. eapply Rle_trans; [|exact M1]. apply Rmult_le_compat_l; assumption.
Qed.
Lemma floor_lies c v x r : lies c v x -> floor_range c = Some r -> lies r (whole_below v) (whole_below x).
Proof.
  destruct c as [l h e]. intros [B D]. unfold floor_range. destruct (_ && _)%bool eqn:G; [|discriminate]. intros [= <-]. apply andb_prop in G.
    destruct G as [L H]. apply is_no_more in L. apply is_less in H.
  rewrite !F2R_plus, F2R_minus, under_is, two_to_is in *. cbn [bpow] in H. pose proof Rabs_pos (v - x). apply Rabs_le_inv in D. assert (N : forall t,
    F2R l - F2R e <= t <= F2R h + F2R e -> whole_below t = F2R (whole_under l)) by (intros t T; rewrite under_is; unfold whole_below in *; f_equal;
    apply Zfloor_imp; rewrite plus_IZR; lra).
  rewrite !N by lra. apply point_lies.
Qed.
