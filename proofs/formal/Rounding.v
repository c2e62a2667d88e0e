(* The rounding error of the central difference. *)

From Coq Require Import Reals Lra Psatz Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Relative Plus_error Pff2Flocq.
From Formal Require Import Float Float64.
Open Scope R_scope.

Lemma moved_by_at_most (h h1 : R -> R) (L a b : R) : (forall w, is_derive h w (h1 w)) -> (forall w, Rabs (h1 w) <= L) -> Rabs (h b - h a) <= L * Rabs (b - a).
Proof. intros D B. apply (bounded_variation h h1). intros t _. split; [apply D | apply B]. Qed.

(* Of any differentiable h, in the standard model: mu the unit roundoff, heights off by at most eta, arguments by at most alpha. *)
Theorem (* clauses 1, 3 *) roundoff_bound__bound (h h1 : R -> R) (L u epsilon mu eta alpha u_plus u_minus h_plus h_minus d1 d2 : R) :
  (forall w, is_derive h w (h1 w)) -> (forall w, Rabs (h1 w) <= L) -> 0 < epsilon -> 0 < mu < 1 -> Rabs d1 <= mu -> Rabs d2 <= mu ->
  Rabs (u_plus - (u + epsilon)) <= alpha -> Rabs (u_minus - (u - epsilon)) <= alpha ->
  Rabs (h_plus - h u_plus) <= eta -> Rabs (h_minus - h u_minus) <= eta ->
  Rabs ((h_plus - h_minus) * (1 + d1) / (2 * epsilon) * (1 + d2) - (h (u + epsilon) - h (u - epsilon)) / (2 * epsilon)) <=
  (eta + L * alpha) / epsilon * (1 + mu) ^ 2 + L * (2 * mu + mu ^ 2).
Proof.
  intros D B E M D1 D2 A1 A2 H1 H2. assert (L0 : 0 <= L) by (eapply Rle_trans; [apply Rabs_pos | apply (B 0)]).
  assert (E1 : Rabs (h_plus - h (u + epsilon)) <= eta + L * alpha).
  { replace (h_plus - h (u + epsilon)) with (h_plus - h u_plus + (h u_plus - h (u + epsilon))) by ring. eapply Rle_trans; [apply Rabs_triang|].
    generalize (moved_by_at_most h h1 L (u + epsilon) u_plus D B). nra. }
  assert (E2 : Rabs (h_minus - h (u - epsilon)) <= eta + L * alpha).
  { replace (h_minus - h (u - epsilon)) with (h_minus - h u_minus + (h u_minus - h (u - epsilon))) by ring. eapply Rle_trans; [apply Rabs_triang|].
    generalize (moved_by_at_most h h1 L (u - epsilon) u_minus D B). nra. }
  assert (S : Rabs ((h (u + epsilon) - h (u - epsilon)) / (2 * epsilon)) <= L).
  { unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; lra). generalize (moved_by_at_most h h1 L (u - epsilon) (u + epsilon) D B).
    replace (u + epsilon - (u - epsilon)) with (2 * epsilon) by ring. rewrite (Rabs_pos_eq (2 * epsilon)) by lra. intro X.
    apply Rmult_le_reg_r with (2 * epsilon); [lra|]. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  set (a := h (u + epsilon)) in *. set (b := h (u - epsilon)) in *. set (e := eta + L * alpha) in *. set (q := (a - b) / (2 * epsilon)) in *.
  set (t := (1 + d1) * (1 + d2)). apply Rabs_le_between in D1. apply Rabs_le_between in D2.
  assert (T : 0 <= t <= (1 + mu) ^ 2) by (unfold t; split; [nra|]; nra).
  assert (T' : Rabs (t - 1) <= 2 * mu + mu ^ 2) by (apply Rabs_le; unfold t; split; nra).
  replace (_ - q) with (((h_plus - a) - (h_minus - b)) / (2 * epsilon) * t + q * (t - 1)) by (unfold q, t; field; lra).
  eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat.
  - unfold Rdiv. rewrite !Rabs_mult, (Rabs_pos_eq (/ _)), (Rabs_pos_eq t) by (try (left; apply Rinv_0_lt_compat); lra).
    apply Rmult_le_compat; try lra; [apply Rmult_le_pos; [apply Rabs_pos | left; apply Rinv_0_lt_compat; lra]|].
    apply Rmult_le_reg_r with (2 * epsilon); [lra|]. rewrite Rmult_assoc, Rinv_l by lra. replace (e * / epsilon * (2 * epsilon)) with (e + e) by (field; lra).
    rewrite Rmult_1_r. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
  - rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; assumption.
Qed.
Theorem roundoff_bound__bound__point : exists (h h1 : R -> R) (L u epsilon mu : R), (forall w, is_derive h w (h1 w)) /\ (forall w, Rabs (h1 w) <= L) /\ 0 < epsilon /\ 0 < mu < 1.
Proof.
  exists sin, cos, 1, 0, 1, (1/2). split; [|split; [|lra]]; intro w; [auto_derive; trivial; ring | apply Rabs_le, COS_bound].
Qed.
(* Without the heights' error it is not so. *)
Theorem roundoff_bound__bound__false : ~ forall (h : R -> R) (epsilon eta h_plus h_minus : R), 0 < epsilon -> Rabs (h_plus - h epsilon) <= eta -> Rabs (h_minus - h (- epsilon)) <= eta ->
  (h_plus - h_minus) / (2 * epsilon) = (h epsilon - h (- epsilon)) / (2 * epsilon).
Proof.
  intro H. generalize (H (fun _ => 0) 1 1 1 0 ltac:(lra)). rewrite !Rminus_0_r, Rabs_R1, Rabs_R0. intro K. generalize (K ltac:(lra) ltac:(lra)). lra.
Qed.

(* Float64 *)

(* The standard model: an operation that does not underflow is exact but for a factor 1 + d, |d| <= 2^-53. *)
Theorem (* clause 3 *) roundoff_bound__standard_model (x : R) : bpow radix2 (-1022) <= Rabs x -> exists d, Rabs d <= unit_roundoff /\ rounded x = x * (1 + d).
Proof. intro H. apply (relative_error_N_FLT_ex radix2 (-1074) 53); [easy | exact H]. Qed.

(* The difference of two float64 numbers needs no such condition. *)
Theorem (* clause 3 *) roundoff_bound__subtraction (a b : R) : float64 a -> float64 b -> exists d, Rabs d <= unit_roundoff /\ rounded (a - b) = (a - b) * (1 + d).
Proof.
  intros A B. destruct (FLT_plus_error_N_ex radix2 (-1074) 53 (fun n => negb (Z.even n)) a (- b) A (generic_format_opp _ _ _ B)) as (d & D & E).
  exists d. split; [|exact E]. eapply Rle_trans; [exact D|]. change (u_ro radix2 53) with unit_roundoff.
  assert (P : 0 < unit_roundoff) by (unfold unit_roundoff; generalize (bpow_gt_0 radix2 (-53 + 1)); lra).
  apply Rmult_le_reg_r with (1 + unit_roundoff); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra.
Qed.

(* Dekker's product: the printed sum and its error are the product itself, where nothing underflows. *)
Theorem elementary_functions__two_product (a b : R) : float64 a -> float64 b -> a * b = 0 \/ bpow radix2 (-1074 + 2 * 53 - 1) <= Rabs (a * b) ->
  two_product_float64.product a b + two_product_float64.product_error a b = a * b.
Proof.
  intros A B U. etransitivity;
    [|symmetry; exact (proj1 (Dekker radix2 (-1074) 53 (fun n => negb (Z.even n)) ltac:(easy) ltac:(easy) a b A B (or_introl eq_refl)) U)].
  assert (C : bpow radix2 (53 - Z.div2 53) + 1 = 134217729) by (simpl; lra). rewrite C.
  change (round radix2 (FLT_exp (-1074) 53) (Znearest (fun n => negb (Z.even n)))) with rounded.
  assert (N : forall x, rounded (rounded (x - rounded (x * 134217729)) + rounded (x * 134217729)) =
    rounded (rounded (134217729 * x) - rounded (rounded (134217729 * x) - x))).
  { intro x. rewrite (Rmult_comm x). f_equal. rewrite <- (Ropp_involutive (rounded (x - _))), <- rounded_opp, Ropp_minus_distr. ring. }
  rewrite !N.
  unfold two_product_float64.product, two_product_float64.product_error, two_product_float64.error_3, two_product_float64.error_2, two_product_float64.error_1,
    two_product_float64.a_low, two_product_float64.a_high, two_product_float64.a_excess, two_product_float64.a_split, two_product_float64.b_low,
    two_product_float64.b_high, two_product_float64.b_excess, two_product_float64.b_split.
  f_equal. f_equal. rewrite Rplus_comm. f_equal. f_equal. rewrite Rplus_comm. f_equal. f_equal. rewrite Rplus_comm. f_equal. f_equal. unfold two_product_float64.product. ring.
Qed.

(* Over any span S with a factor in 1 +- kappa: in u and in v, S = 2 eps, and clamped at the pole, S = v + eps. *)
Theorem (* clauses 1, 2 *) roundoff_bound__any_span (h h1 : R -> R) (L a b S kappa eta alpha a' b' h_a h_b t : R) :
  (forall w, is_derive h w (h1 w)) -> (forall w, Rabs (h1 w) <= L) -> 0 < S -> a - b = S -> Rabs (t - 1) <= kappa ->
  Rabs (a' - a) <= alpha -> Rabs (b' - b) <= alpha -> Rabs (h_a - h a') <= eta -> Rabs (h_b - h b') <= eta ->
  Rabs ((h_a - h_b) / S * t - (h a - h b) / S) <= 2 * (eta + L * alpha) / S * (1 + kappa) + L * kappa.
Proof.
  intros D B P AB K A1 A2 H1 H2. assert (L0 : 0 <= L) by (eapply Rle_trans; [apply Rabs_pos | apply (B 0)]).
  assert (E : forall x x' y, Rabs (x' - x) <= alpha -> Rabs (y - h x') <= eta -> Rabs (y - h x) <= eta + L * alpha).
  { intros x x' y X Y. replace (y - h x) with (y - h x' + (h x' - h x)) by ring. eapply Rle_trans; [apply Rabs_triang|].
    generalize (moved_by_at_most h h1 L x x' D B). nra. }
  generalize (E _ _ _ A1 H1) (E _ _ _ A2 H2) (moved_by_at_most h h1 L b a D B). rewrite AB, (Rabs_pos_eq S) by lra. intros E1 E2 M.
  set (e := eta + L * alpha) in *. assert (I : 0 < / S) by (apply Rinv_0_lt_compat, P).
  assert (Q : Rabs ((h a - h b) / S) <= L).
  { unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ S)) by lra. apply Rmult_le_reg_r with S; [exact P|]. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (T : Rabs t <= 1 + kappa) by (replace t with (1 + (t - 1)) by ring; eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_R1; lra).
  replace (_ - _) with (((h_a - h a) - (h_b - h b)) / S * t + (h a - h b) / S * (t - 1)) by (field; lra).
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult. apply Rplus_le_compat.
  - apply Rmult_le_compat; try apply Rabs_pos; [|exact T]. unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ S)) by lra. apply Rmult_le_compat_r; [lra|].
    eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra.
  - apply Rmult_le_compat; try apply Rabs_pos; assumption.
Qed.
(* Three roundings, the span's among them: kappa = (3 mu + mu^2)/(1 - mu). *)
Theorem (* clauses 3, 4 *) roundoff_bound__three_roundings (mu d1 d2 d3 : R) : 0 < mu < 1 -> Rabs d1 <= mu -> Rabs d2 <= mu -> Rabs d3 <= mu ->
  Rabs ((1 + d1) * (1 + d2) / (1 + d3) - 1) <= (3 * mu + mu ^ 2) / (1 - mu) /\ Rabs ((1 + d1) * (1 + d2) - 1) <= 2 * mu + mu ^ 2.
Proof.
  intros M D1 D2 D3. apply Rabs_le_between in D1. apply Rabs_le_between in D2. apply Rabs_le_between in D3.
  assert (T : - (2 * mu + mu ^ 2) <= (1 + d1) * (1 + d2) - 1 <= 2 * mu + mu ^ 2) by (split; nra).
  split; [|apply Rabs_le, T]. replace (_ - 1) with (((1 + d1) * (1 + d2) - 1 - d3) / (1 + d3)) by (field; lra).
  unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ (1 + d3))) by (left; apply Rinv_0_lt_compat; lra).
  apply Rmult_le_compat; [apply Rabs_pos | left; apply Rinv_0_lt_compat; lra | apply Rabs_le; lra | apply Rinv_le_contravar; lra].
Qed.
(* False variants: where it underflows, and with the weight alone. *)
Lemma float64_is_whole (x : R) : float64 x -> exists m : Z, x = IZR m * bpow radix2 (-1074).
Proof.
  intro F. apply FLT_format_generic in F; [|easy]. destruct F as [[m e] -> _ E]. cbn [Fnum Fexp] in *. exists (m * radix2 ^ (e + 1074))%Z.
  unfold F2R. cbn [Fnum Fexp]. rewrite mult_IZR, IZR_Zpower by lia. rewrite Rmult_assoc, <- bpow_plus. do 2 f_equal. lia.
Qed.
Lemma rounded_is_float64 (x : R) : float64 (rounded x).
Proof. apply generic_format_round; typeclasses eauto. Qed.
Theorem roundoff_bound__standard_model__false : ~ forall x, exists d, Rabs d <= unit_roundoff /\ rounded x = x * (1 + d).
Proof.
  intro H. destruct (H (bpow radix2 (-1075))) as (d & D & E). destruct (float64_is_whole _ (rounded_is_float64 (bpow radix2 (-1075)))) as [m M]. rewrite E in M.
  replace (-1074)%Z with (-1075 + 1)%Z in M by easy. rewrite bpow_plus in M. generalize (bpow_gt_0 radix2 (-1075)). set (b := bpow radix2 (-1075)) in *. intro B.
  change (bpow radix2 1) with 2 in M. assert (K : 1 + d = 2 * IZR m) by (apply Rmult_eq_reg_l with b; lra).
  assert (U : unit_roundoff < 1/2) by (unfold unit_roundoff; simpl; lra). apply Rabs_le_between in D.
  assert (0 < m < 1)%Z by (split; apply lt_IZR; lra). lia.
Qed.
Theorem roundoff_bound__subtraction__false : ~ forall a b, exists d, Rabs d <= unit_roundoff /\ rounded (a - b) = (a - b) * (1 + d).
Proof. intro H. apply roundoff_bound__standard_model__false. intro x. generalize (H x 0). rewrite Rminus_0_r. trivial. Qed.
Theorem elementary_functions__two_product__false : ~ forall a b, float64 a -> float64 b -> two_product_float64.product a b + two_product_float64.product_error a b = a * b.
Proof.
  intro H. assert (F : float64 (bpow radix2 (-1074))) by (apply generic_format_bpow; easy). generalize (H _ _ F F).
  destruct (float64_is_whole (two_product_float64.product (bpow radix2 (-1074)) (bpow radix2 (-1074))) ltac:(apply rounded_is_float64)) as [m ->].
  destruct (float64_is_whole (two_product_float64.product_error (bpow radix2 (-1074)) (bpow radix2 (-1074))) ltac:(apply rounded_is_float64)) as [n ->].
  generalize (bpow_gt_0 radix2 (-1074)). intros B E. assert (S : bpow radix2 (-1074) < bpow radix2 0) by (apply bpow_lt; easy). change (bpow radix2 0) with 1 in S.
  set (b := bpow radix2 (-1074)) in *. assert (K : IZR (m + n) = b) by (rewrite plus_IZR; apply Rmult_eq_reg_r with b; lra).
  assert (0 < m + n < 1)%Z by (split; apply lt_IZR; lra). lia.
Qed.
Theorem roundoff_bound__any_span__false : ~ forall (h h1 : R -> R) (L a b S kappa t : R), (forall w, is_derive h w (h1 w)) -> (forall w, Rabs (h1 w) <= L) -> 0 < S -> a - b = S ->
  Rabs (t - 1) <= kappa -> Rabs ((h a - h b) / S * t - (h a - h b) / S) <= 0.
Proof.
  intro H. generalize (H (fun w => w) (fun _ => 1) 1 1 0 1 1 2 ltac:(intro; auto_derive; trivial) ltac:(intro; cbv beta; rewrite Rabs_R1; lra) ltac:(lra) ltac:(lra)).
  intro K. specialize (K ltac:(rewrite Rabs_pos_eq; lra)). rewrite Rabs_pos_eq in K; lra.
Qed.
