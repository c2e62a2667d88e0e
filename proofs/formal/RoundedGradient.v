(* The whole exact gradient as float64 carries it out, general form: product in two parts, reduction, polynomials, quadrant, slopes. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Plus_error Mult_error.
From Interval Require Import Tactic.
From Formal Require Import Formulas Float Float64 Clamped RoundedHalfTurns Rounding Fields.
Open Scope R_scope.

Lemma twice_float64 x : float64 x -> float64 (2 * x).
Proof. intro F. rewrite Rmult_comm. apply (mult_bpow_pos_exact_FLT radix2 (-1074) 53 x 1); [exact F | easy]. Qed.
Lemma up_to_1 x : (x <= 1 -> rounded x <= 1) /\ (rounded x < 1 -> x < 1).
Proof.
  split; intro X; [|apply Rnot_le_lt; intro; apply (Rlt_not_le _ _ X)]; (apply round_le_generic || apply round_ge_generic); trivial; try typeclasses
    eauto; exact one_is_float64.
Qed.
Lemma difference_near a b : float64 a -> float64 b -> exists d, Rabs d <= / 2 ^ 53 /\ rounded (a - b) = (a - b) * (1 + d).
Proof. intros A B. exact (rounded_sum a (- b) A (generic_format_opp _ _ _ B)). Qed.
Lemma four_quadrants q : (q mod 4 = 0 \/ q mod 4 = 1 \/ q mod 4 = 2 \/ q mod 4 = 3)%Z.
Proof. pose proof Z.mod_pos_bound q 4. lia. Qed.
(* The sine and the cosine after q quarters of a turn, from those before. *)
Definition sine_in (q : Z) (s c : R) := match (q mod 4)%Z with 0%Z => s | 1%Z => c | 2%Z => - s | _ => - c end.
Definition cosine_in (q : Z) (s c : R) := match (q mod 4)%Z with 0%Z => c | 1%Z => - s | 2%Z => - c | _ => s end.
Ltac each_quadrant q := unfold sine_in, cosine_in; destruct (four_quadrants q) as [K|[K|[K|K]]]; rewrite K.
(* The number of quarters of a turn, and what remains of a float64 product: both are exact. *)
Definition quarters (p : R) : Z := Znearest (fun n => negb (Z.even n)) (2 * p).
Lemma near_quarters p : Rabs (p - IZR (quarters p) / 2) <= 1/4.
Proof.
  unfold quarters. pose proof Znearest_half (fun n => negb (Z.even n)) (2 * p). by_sides.
Qed.
Lemma remainder_is_float64 p : float64 p -> float64 (p - IZR (quarters p) / 2).
Proof.
  intro F. generalize (what_is_left_is_float64 p (/ 2) F (generic_format_bpow radix2 (FLT_exp (-1074) 53) (-1) ltac:(easy))). replace (p / / 2) with
    (2 * p) by field. trivial.
Qed.

Section reduction.
Variables p e : R.
Hypothesis F : float64 p.
Let q := quarters p.
Lemma quarters_printed : sine_of_half_turns_float64.quarters p = IZR q.
Proof. unfold sine_of_half_turns_float64.quarters. rewrite (kept _ (twice_float64 _ F)). reflexivity. Qed.
Lemma part_of_quarters f j : f = bpow radix2 j -> (-2 <= j)%Z -> rounded (f * IZR q) = f * IZR q.
Proof.
  intros -> J. apply kept. rewrite Rmult_comm. destruct (Z.eq_dec q 0) as [Z|N]; [rewrite Z, Rmult_0_l; apply generic_format_0|]. apply
    mult_bpow_exact_FLT; [exact (whole_part_is_float64 _ _ (valid_rnd_N _) (twice_float64 _ F))|].
  assert (1 <= mag radix2 (IZR q))%Z by (apply mag_ge_bpow; rewrite <- abs_IZR; apply (IZR_le 1); lia). lia.
Qed.
Lemma remainder_printed : sine_of_half_turns_float64.remainder p e = rounded (p - IZR q / 2 + e).
Proof.
  unfold sine_of_half_turns_float64.remainder, sine_of_half_turns_float64.remainder_high. rewrite quarters_printed, (part_of_quarters _ (-1)) by
    (simpl; lra || lia).
  replace (p - 1 / 2 * IZR q) with (p - IZR q / 2) by field. rewrite (kept (p - IZR q / 2)) by exact
    (remainder_is_float64 _ F). f_equal. ring.
Qed.
Lemma quadrant_printed : sine_of_half_turns_float64.quadrant p = IZR (q mod 4).
Proof.
  unfold sine_of_half_turns_float64.quadrant, whole_below. rewrite quarters_printed, (part_of_quarters _ (-2)) by (simpl; lra || lia).
  assert (W : float64 (IZR (Zfloor (1 / 4 * IZR q)))) by (apply whole_part_is_float64; [typeclasses eauto | rewrite <- (part_of_quarters _ (-2)) by
    (simpl; lra || lia); apply rounded_is_float64]).
  replace (1 / 4 * IZR q) with (IZR q / IZR 4) in * by (simpl; field). rewrite Zfloor_div in * by easy. pose proof Z.div_mod q 4 ltac:(easy) as D.
    pose proof Z.mod_pos_bound q 4 ltac:(easy) as M.
  rewrite Rmult_comm, (kept (_ * 4)) by (apply (mult_bpow_pos_exact_FLT radix2 (-1074) 53 _ 2); [exact W | easy]).
  replace (IZR q - IZR (q / 4) * 4) with (IZR (q mod 4)) by (rewrite D at 2; rewrite plus_IZR, mult_IZR; ring).
  apply kept. rewrite <- (Rmult_1_r (IZR _)). apply (whole_is_float64 _ 0); lia.
Qed.
(* What the sine and the cosine return, by the quadrant. *)
Lemma sine_printed : let r := sine_of_half_turns_float64.remainder p e in let s := half_turn_polynomials_float64.sine_near r in let c :=
  half_turn_polynomials_float64.cosine_near r in
  sine_of_half_turns_float64.sine p e = sine_in q s c /\ cosine_of_half_turns_float64.cosine p e = cosine_in q s c.
Proof.
  intros r s c. unfold sine_of_half_turns_float64.sine, cosine_of_half_turns_float64.cosine.
  change (cosine_of_half_turns_float64.quadrant p) with (sine_of_half_turns_float64.quadrant p).

  rewrite quadrant_printed. each_quadrant q; repeat destruct Rlt_dec; (split; reflexivity) || lra.
Qed.
End reduction.

Lemma turn r n : sin (PI * r + IZR (2 * n) * PI) = sin (PI * r) /\ cos (PI * r + IZR (2 * n) * PI) = cos (PI * r).
Proof.
  assert (Z : sin (IZR n * PI) = 0) by (apply sin_eq_0_1; exists n; reflexivity). rewrite mult_IZR, Rmult_assoc, sin_plus, cos_plus, sin_2a,
    cos_2a_sin, Z. split; ring.
Qed.
Lemma by_quadrant w q : let s := sin (PI * w) in let c := cos (PI * w) in sin (PI * (w + IZR q / 2)) = sine_in q s c /\ cos (PI * (w + IZR q / 2))
  = cosine_in q s c.
Proof.
  intros s c. pose proof Z.div_mod q 4 ltac:(easy) as D. destruct (turn w (q / 4)) as [S C].
  replace (PI * (w + IZR q / 2)) with (PI * w + IZR (2 * (q / 4)) * PI + IZR (q mod 4) * (PI / 2)) by (rewrite D at 3; rewrite plus_IZR, !mult_IZR;
    field). rewrite (sin_plus (_ + _)), (cos_plus (_ + _)), S, C. fold s c.
  each_quadrant q;
    [rewrite Rmult_0_l, sin_0, cos_0 | rewrite Rmult_1_l, sin_PI2, cos_PI2 | replace (2 * (PI / 2)) with PI by field; rewrite sin_PI, cos_PI | rewrite
      sin_3PI2, cos_3PI2]; split; ring.
Qed.

Lemma rounded_pi : Rabs (rounded PI - PI) <= 36/100 / 2 ^ 53 * PI.
Proof.
  set (c := IZR 7074237752028440 * bpow radix2 (-51)). assert (F : float64 c) by (apply whole_is_float64; easy).
  apply Rle_trans with (Rabs (c - PI)); [|unfold c; interval with (i_prec 80)].
  apply (round_N_pt radix2 (FLT_exp (-1074) 53) _ PI), F.
Qed.

Lemma bounded_product a b A B : Rabs a <= A -> Rabs b <= B -> Rabs (a * b) <= A * B.
Proof. intros. rewrite Rabs_mult. factors; assumption. Qed.
Lemma same_sign x y : (0 < x -> 0 < y) -> (x < 0 -> y < 0) -> (x = 0 -> y = 0) -> sign y = sign x.
Proof. intros P N Z. destruct (Rtotal_order x 0) as [L|[L|L]]; [rewrite !sign_eq_m1 | rewrite Z, L | rewrite !sign_eq_1]; auto. Qed.
Lemma of_opposites x y m : Rabs (x - y) <= m -> Rabs (- x - - y) <= m.
Proof. replace (- x - - y) with (- (x - y)) by ring. rewrite Rabs_Ropp. auto. Qed.
(* By the quadrant, what holds of the polynomials holds of the sine and the cosine. *)
Lemma in_each_quadrant (F : R -> R -> Prop) q s c s1 c1 : F s s1 -> F c c1 -> (forall x y, F x y -> F (- x) (- y)) -> F (sine_in q s c) (sine_in q
  s1 c1) /\ F
  (cosine_in q s c) (cosine_in q s1 c1).
Proof.
  intros S C N. each_quadrant q; split; try apply N; assumption.
Qed.
(* A product that is carried in two, its reduction, and the sine and cosine of it. *)
Lemma half_turns_apart f g (x y : R) : derives_to f g -> (forall x, Rabs (g x) <= 1) -> Rabs (f (PI * x) - f (PI * y)) <= PI * Rabs (x - y).
Proof.
  intros D G. pose proof moved_by_at_most f g 1 (PI * y) (PI * x) D G as M. pose proof PI_RGT_0. rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq PI)
    in
    M; lra.
Qed.
Section product.
Variables a b : R.
Hypothesis A : float64 a.
Hypothesis B : float64 b.
Hypothesis U : a * b = 0 \/ bpow radix2 (-969) <= Rabs (a * b).
Hypothesis L : Rabs (a * b) <= 2 ^ 21.
Let p := two_product_float64.product a b.
Let e := two_product_float64.product_error a b.
Let w := a * b - IZR (quarters p) / 2.
Let r := sine_of_half_turns_float64.remainder p e.
Let s := half_turn_polynomials_float64.sine_near r.
Let c := half_turn_polynomials_float64.cosine_near r.
Lemma product_is_float64 : float64 p.
Proof. apply rounded_is_float64. Qed.
Lemma in_two : p + e = a * b.
Proof. exact (elementary_two_product a b A B U). Qed.
Lemma error_is_small : Rabs e <= 1 / 2 ^ 31.
Proof.
  assert (E := rounded_error _ _ L : Rabs (p - a * b) <= _). pose proof in_two. by_sides.
Qed.
Lemma remainder_near : r = rounded w /\ Rabs w <= 1/4 + 1 / 2 ^ 31.
Proof.
  split.
  - unfold r, w. rewrite (remainder_printed p e product_is_float64). f_equal. rewrite <- in_two. ring.
  - replace w with (p - IZR (quarters p) / 2 + e) by (unfold w; rewrite <- in_two; ring).
    at_most_by Rabs_triang. generalize (near_quarters p) error_is_small. lra.
Qed.
Lemma remainder_error : Rabs (r - w) <= 251/1000 / 2 ^ 53 /\ - (1/4 + 1/2^30) <= r <= 1/4 + 1/2^30.
Proof.
  destruct remainder_near as [R W]. assert (E : Rabs (r - w) <= 251/1000 / 2 ^ 53) by (rewrite R; generalize (rounded_error _ _ W); lra).
  split; [exact E|]. apply Rabs_le_between. generalize (size _ _ _ _ W E). lra.
Qed.
Lemma turned f g : derives_to f g -> (forall x, Rabs (g x) <= 1) -> Rabs (f (PI * r) - f (PI * w)) <= 789/1000 / 2 ^ 53.
Proof.
  intros D G. at_most_by (half_turns_apart f g r w D G). destruct remainder_error as [E _]. assert (0 < PI <= 31416/10000) by (split; interval). nra.
Qed.
Lemma polynomials_near : Rabs (s - sin (PI * w)) <= 3289/1000 / 2 ^ 53 /\ Rabs (c - cos (PI * w)) <= 3289/1000 / 2 ^ 53.
Proof.
  destruct remainder_error as [_ R]. split.
  - eapply Rle_trans; [exact (through _ _ _ _ _ (elementary_sine_float64 _ R) (turned sin cos is_derive_sin cosine_at_most_1)) | lra].
  - assert (D : forall x, Rabs (- sin x) <= 1) by (intro x; rewrite Rabs_Ropp; apply sine_at_most_1).
    eapply Rle_trans; [exact (through _ _ _ _ _ (elementary_cosine_float64 _ R) (turned cos (fun x => - sin x) is_derive_cos D)) | lra].
Qed.
Lemma after_quarters (near : R -> R -> Prop) : near s (sin (PI * w)) -> near c (cos (PI * w)) -> (forall x y, near x y -> near (- x) (- y)) -> near
  (sine_of_half_turns_float64.sine p e) (sin (PI * (a * b))) /\ near (cosine_of_half_turns_float64.cosine p e) (cos (PI * (a * b))).
Proof.
  replace (a * b) with (w + IZR (quarters p) / 2) by (unfold w; ring). destruct (by_quadrant w (quarters p)) as [-> ->].
  destruct (sine_printed p e product_is_float64) as [-> ->]. apply in_each_quadrant.
Qed.
(* The side of a crease is never wrong: the sine's sign is that of its argument's. *)
Lemma sign_of_remainder : sign r = sign w.
Proof.
  destruct remainder_near as [-> _]. assert (N : w <> 0 -> rounded w <> 0).
  { replace w with (p - IZR (quarters p) / 2 + e) by (unfold w; rewrite <- in_two; ring). apply round_plus_neq_0; try typeclasses eauto; [apply
    remainder_is_float64, product_is_float64 | apply rounded_is_float64]. }
  apply same_sign; intro S; [pose proof not_negative_rounded w ltac:(lra) as Q | pose proof not_negative_rounded (- w) ltac:(lra) as Q; rewrite
    rounded_opp in Q | rewrite S; apply rounded_0]; apply Rnot_le_lt; intro; apply N; lra.
Qed.
Lemma sign_of_sine : sign s = sign (sin (PI * w)).
Proof.
  destruct remainder_error as [_ R]. destruct remainder_near as [Rw W]. both_ways W. destruct (factor_rounded r R) as [T P]. both_ways T. assert (F :
    float64 r) by (rewrite Rw; apply rounded_is_float64). transitivity (sign r).
  - unfold s, half_turn_polynomials_float64.sine_near. set (t := rounded (half_turn_polynomials_float64.sine_tail r + _)) in *. assert (1 <= t) by
    lra. apply same_sign; intro S.
    + apply Rlt_le_trans with r; [exact S | apply round_ge_generic; [typeclasses eauto..| exact F | nra]].
    + apply Rle_lt_trans with r; [apply round_le_generic; [typeclasses eauto..| exact F | nra] | exact S].
    + rewrite S, Rmult_0_l. apply rounded_0.
  - rewrite sign_of_remainder. symmetry. apply same_sign; intro S; [apply sin_gt_0 | apply sin_lt_0_var | rewrite S, Rmult_0_r; apply sin_0];
    generalize PI_RGT_0; nra.
Qed.
Lemma sign_of_cosine : sign c = sign (cos (PI * w)).
Proof.
  destruct remainder_near as [_ W]. destruct polynomials_near as [_ C]. both_ways C. both_ways W.
  assert (cos (PI * w) > 7/10) by interval. rewrite !sign_eq_1; lra.
Qed.
Lemma signs_of_waves : sign (sine_of_half_turns_float64.sine p e) = sign (sin (PI * (a * b))) /\ sign (cosine_of_half_turns_float64.cosine p e) =
  sign (cos (PI * (a * b))).
Proof. apply (after_quarters (fun x y => sign x = sign y)); [exact sign_of_sine | exact sign_of_cosine | intros x y N; rewrite !sign_opp, N; reflexivity].
  Qed.
End product.

Definition carried (a b : R) := float64 a /\ float64 b /\ (a * b = 0 \/ bpow radix2 (-969) <= Rabs (a * b)) /\ Rabs (a * b) <= 2 ^ 21.
Definition near_turn x y := Rabs (x - y) <= 3289/1000 / 2 ^ 53.
Lemma factors_near a b : carried a b -> let p := two_product_float64.product a b in let e := two_product_float64.product_error a b in let s :=
  sine_of_half_turns_float64.sine p e in near_turn s (sin (PI * (a * b))) /\ near_turn (cosine_of_half_turns_float64.cosine p e) (cos (PI * (a *
  b))) /\ sign s = sign (sin (PI * (a * b))).
Proof.
  intros (A & B & U & L) p e s. destruct (polynomials_near a b A B U L) as [S C]. rewrite <- and_assoc. split.
  - exact (after_quarters a b near_turn S C (fun x y => of_opposites x y _)).
  - exact (proj1 (signs_of_waves a b A B U L)).
Qed.

Definition slope_off (k : R) := 10 / 9007199254740992 * PI * Rmax 1 (Rabs k).
Lemma slope_near P ph k m c s ch sh : near_turn ch c -> PI <= P -> Rabs (ph - P) <= 36/100 / 2 ^ 53 * P -> P * Rabs k = PI * Rabs m -> Rabs c <= 1 -> Rabs s
  <=
  1 -> near_turn sh s -> Rabs (rounded (rounded (rounded (ph * ch) * k) * sh) - P * c * k * s) <= slope_off m.
Proof.
  intros Ec Q E W C S Es. assert (P3 : 3 <= PI) by interval. pose proof Rmax_l 1 (Rabs m). pose proof Rmult_le_compat_l PI _ _ ltac:(lra) (Rmax_r 1 (Rabs
    m)). unfold slope_off. assert (3 <= PI * Rmax 1 (Rabs m)) by nra. assert (3 * Rabs k <= P * Rabs k) by (apply Rmult_le_compat_r; [apply Rabs_pos |
    lra]).
  assert (Bp : Rabs P <= P) by (rewrite Rabs_pos_eq; lra). pose proof bounded_product _ _ _ _ Bp C as B1. pose proof bounded_product _ _ _ _ B1 (Rle_refl
    (Rabs k)) as B2.
  at_most_by (times_error _ _ _ _ _ _ _ _ B2 S (times_error _ _ _ _ _ _ _ _ B1 (Rle_refl _) (times_error _ _ _ _ _ _ _ _ Bp C E Ec) (no_error k)) Es).
  lra.
Qed.
Lemma slopes_of_sine u v k_u k_v : carried k_u u -> carried k_v v -> Rabs (gradient_sine_float64.h_u u v k_u k_v - gradient_sine.h_u u v k_u k_v)
  <= slope_off k_u /\ Rabs (gradient_sine_float64.h_v u v k_u k_v - gradient_sine.h_v u v k_u k_v) <= slope_off k_v.
Proof.
  intros U V. destruct (factors_near _ _ U) as (? & ? & _). destruct (factors_near _ _ V) as (? & ? & _).
  split; apply slope_near; exact rounded_pi || apply sine_at_most_1 || apply cosine_at_most_1 || assumption || apply Rle_refl || reflexivity.
Qed.
Lemma times_sign x s t : float64 x -> rounded (x * rounded (sign s * sign t)) = x * sign (s * t).
Proof.
  intro F. rewrite <- sign_mult. assert (O := rounded_opp 1 : rounded (-1) = - rounded 1). unfold sign. destruct total_order_T as [[|]|]; rewrite ?O,
    ?rounded_1, ?rounded_0, ?Rmult_0_r, ?Rmult_1_r; [apply kept, F | apply rounded_0|].
  replace (x * - (1)) with (- x) by ring. rewrite rounded_opp, (kept x F). ring.
Qed.
Lemma beside_a_sign x y m s : Rabs (x - y) <= m -> Rabs (x * sign s - y * sign s) <= m.
Proof. intro D. pose proof Rle_trans _ _ _ (Rabs_pos _) D. unfold sign. destruct total_order_T as [[|]|]; by_sides. Qed.
Lemma slopes_of_ridges u v k_u k_v : carried k_u u -> carried k_v v -> Rabs (gradient_ridges_float64.h_u u v k_u k_v - gradient_ridges.h_u u v k_u
  k_v) <= slope_off k_u /\ Rabs (gradient_ridges_float64.h_v u v k_u k_v - gradient_ridges.h_v u v k_u k_v) <= slope_off k_v.
Proof.
  intros U V. destruct (slopes_of_sine u v k_u k_v U V). destruct (factors_near _ _ U) as (_ & _ & Su). destruct (factors_near _ _ V) as (_ & _ & Sv).
  unfold gradient_ridges_float64.h_u, gradient_ridges_float64.h_v. rewrite !times_sign, !sign_mult by first [exact 0 | apply rounded_is_float64].
  unfold gradient_ridges_float64.sin_u, gradient_ridges_float64.sin_v. rewrite Su, Sv, <- !sign_mult. split; apply beside_a_sign; assumption.
Qed.
Lemma slope_of_rings v k_v : carried (2 * k_v) v -> float64 k_v -> Rabs (gradient_rings_float64.h_v v k_v - gradient_rings.h_v v k_v) <= slope_off (2 *
  k_v).
Proof.
  intros V F. destruct (factors_near _ _ V) as (_ & C & _). gradient_rings_float64.lines. rewrite (kept _ (twice_float64 _ F)), (kept _ (twice_float64 _
    (rounded_is_float64 PI))).
  generalize PI_RGT_0 rounded_pi. intros. assert (N := slope_near (2 * PI) (2 * rounded PI) k_v (2 * k_v) _ 1 _ 1 C ltac:(lra)). rewrite <-
    Rmult_minus_distr_l, !Rabs_mult,
    (Rabs_pos_eq 2), Rabs_R1, !Rmult_1_r, (kept _ (rounded_is_float64 _)) in N by lra.
  apply N; try lra; [apply cosine_at_most_1 | at_most_by no_error; lra].
Qed.

(* The printed claims: what is carried out exactly, and where nothing underflows. *)
Lemma not_tiny w : 10 ^ 285 * Rabs w >= 1 \/ w = 0 -> w = 0 \/ bpow radix2 (-969) <= Rabs w.
Proof.
  intros [U|U]; [right | left; exact U]. apply Rmult_le_reg_r with (10 ^ 285); [apply pow_lt; lra|]. apply Rle_trans with 1; [|lra].
  change (bpow radix2 (-969)) with (/ IZR (Z.pow_pos 2 969)). rewrite <- (Rinv_l (IZR (Z.pow_pos 2 969))) by (apply not_0_IZR; easy).
  apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat, IZR_lt; easy|]. rewrite pow_IZR. apply IZR_le. apply Z.leb_le. vm_compute. reflexivity.
Qed.
Lemma carried_on_the_chart k x : float64 x -> float64 k -> x >= 0 -> x <= 1 -> Rabs k <= 2 ^ 21 -> (10 ^ 285 * Rabs (k * x) >= 1 \/ k * x = 0) ->
  carried k x.
Proof.
  intros X K L H B U. repeat split; [exact K | exact X | apply not_tiny, U|]. rewrite Rabs_mult, (Rabs_pos_eq x) by lra. generalize (Rabs_pos k). nra.
Qed.
Theorem gradient_accuracy__sine : Statements.gradient_accuracy__sine.
Proof. red. intros. apply slopes_of_sine; apply carried_on_the_chart; try assumption; lra. Qed.
Theorem gradient_accuracy__ridges : Statements.gradient_accuracy__ridges.
Proof. red. intros. apply slopes_of_ridges; apply carried_on_the_chart; try assumption; lra. Qed.
Theorem gradient_accuracy__rings : Statements.gradient_accuracy__rings.
Proof.
  intros v k_v V K L H B U. apply slope_of_rings; [|exact K]. apply carried_on_the_chart; try assumption.
  - apply twice_float64, K.
  - rewrite Rabs_mult, (Rabs_pos_eq 2) by lra. lra.
  - rewrite Rmult_assoc. destruct U as [U|U]; [left | right; rewrite U; ring]. rewrite Rabs_mult, (Rabs_pos_eq 2) by lra.
    generalize (Rabs_pos (k_v * v)) (pow_lt 10 285 ltac:(lra)). nra.
Qed.
