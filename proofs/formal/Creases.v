(* Differences across the creases of ridges, its slopes beside them, and the seam. *)

From Coq Require Import Reals Lra ZArith.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Fields Claim Derivatives Camera Clamped.
Open Scope R_scope.

(* A difference that straddles a crease *)

Ltac beside_half := replace (PI * (1 / 2 * 1)) with (PI / 2) by field; rewrite sin_PI2, !Rmult_1_l.
(* Beyond a whole number of half-turns the sine is the same but for its sign. *)
Theorem straddling__every_crease : Statements.straddling__every_crease.
Proof.
  intros d m Z. assert (C : cos (PI * m) ^ 2 = 1) by (generalize (sin2_cos2 (PI * m)); unfold Rsqr; nra).
  rewrite sin_plus, Z. apply Rsqr_eq_abs_0. rewrite !Rsqr_pow2. nra.
Qed.
Lemma beyond_a_crease k m t : k <> 0 -> sin (PI * m) = 0 -> Rabs (sin (PI * (k * (t + m / k)))) = Rabs (sin (t * PI * k)).
Proof. intros K M. rewrite <- (straddling__every_crease (t * PI * k) m M). do 2 f_equal. field. lra. Qed.
Theorem straddling__value : Statements.straddling__value.
Proof.
  intros d e k E K A B C D. generalize (sine_on_a_hump (k * (d + e)) ltac:(nra)) (sine_on_a_hump (k * (e - d)) ltac:(nra)). beside_half. intros S T.
  replace (PI * (k * (d - e))) with (- (PI * (k * (e - d)))) by ring. rewrite sin_neg, Rabs_Ropp, (Rabs_pos_eq _ S), (Rabs_pos_eq _ T). split; [lra|].
    alike. lra.
Qed.

(* Beside any crease of ridges, in u and in v: what the kernels print as difference and as slope. *)
Lemma sine_of_whole n : sin (PI * IZR n) = 0.
Proof. apply sin_eq_0_1. exists n. ring. Qed.
Lemma sine_of_a_shift m x : Rabs (sin (PI * IZR m + x)) = Rabs (sin x).
Proof. rewrite Rplus_comm. apply straddling__every_crease, sine_of_whole. Qed.
Lemma across_a_crease k d e m : 0 < k -> Rabs d < e -> e + Rabs d <= 1 / k -> Rabs (sin (PI * (k * (IZR m / k + d + e)))) - Rabs (sin (PI * (k *
  (IZR m / k + d - e)))) = 2 * (cos (PI * (k * e)) * sin (PI * (k * d))).
Proof.
  intros K A B. apply Rabs_def2 in A as A'. assert (- (1 / k - e) <= d <= 1 / k - e) by (apply Rabs_le_between; lra).
  assert (I : k * (1 / k) = 1) by (field; lra). replace (IZR m / k + d + e) with (d + e + IZR m / k) by ring. replace (IZR m / k + d - e) with (d - e
    + IZR m / k) by ring.
  rewrite !beyond_a_crease by (apply sine_of_whole || lra).
  destruct (straddling__value d e k) as [_ V]; try lra; [nra | nra|]. revert V. beside_half. intro V.
  apply (f_equal (fun x => 2 * e * x)) in V. field_simplify in V; [|lra ..]. revert V. same_angles. lra.
Qed.
(* Whole k_u leaves ridges the same across the seam; any k_u where the sample is inside. *)
Lemma wrapped k w : (exists n, k = IZR n) \/ 0 <= w < 1 -> Rabs (sin (PI * (k * (w - IZR (Int_part w))))) = Rabs (sin (PI * (k * w))).
Proof.
  intros [[n ->]|I]; [|rewrite floor_of_a_fraction, Rminus_0_r by lra; reflexivity]. set (i := Int_part w).
  rewrite <- (sine_of_a_shift (n * i)), mult_IZR. do 2 f_equal. ring.
Qed.
Theorem straddling__of_the_difference u v k_u k_v d epsilon m : Rabs d < epsilon -> (0 < k_u -> epsilon + Rabs d <= 1 / k_u -> (exists n, k_u =
  IZR n) \/ 0 <= IZR m / k_u + d - epsilon /\ IZR m / k_u + d + epsilon < 1 -> central_ridges.h_u (IZR m / k_u + d) v k_u k_v epsilon = cos (PI *
  (k_u * epsilon)) * sin (PI * (k_u * d)) / epsilon * Rabs (sin (PI * (k_v * v)))) /\ (0 < k_v -> epsilon + Rabs d <= 1 / k_v -> 0 <= IZR m / k_v
  + d - epsilon -> IZR m / k_v + d + epsilon <= 1 -> central_ridges.h_v u (IZR m / k_v + d) k_u k_v epsilon = cos (PI * (k_v * epsilon)) * sin (PI
  * (k_v * d)) / epsilon * Rabs (sin (PI * (k_u * u)))).
Proof.
  intro A. assert (E : 0 < epsilon) by (generalize (Rabs_pos d); lra). split; intro K.
  - intros B I. generalize (across_a_crease k_u d epsilon m K A B). set (x := IZR m / k_u + d) in *. intro D.
    central_ridges.lines. rewrite !Rabs_mult.
    rewrite wrapped, wrapped, Rplus_comm, <- Rmult_minus_distr_r, D by (destruct I; [left; assumption | right; lra]). lra.
  - intros B I J. generalize (across_a_crease k_v d epsilon m). set (x := IZR m / k_v + d) in *. intro D.
    central_ridges.lines. rewrite !Rabs_mult.
    destruct both as [_|[H|H]]; [|lra|lra]. rewrite Rmin_right, Rmax_left, (Rplus_comm epsilon), <- Rmult_minus_distr_l, D by lra. field. lra.
Qed.
(* It is not the slope. *)
Theorem straddling__of_the_difference__false : ~ forall v k_v d epsilon, Rabs d < epsilon -> epsilon + Rabs d <= 1 / 1 ->
  central_ridges.h_u (0 / 1 + d) v 1 k_v epsilon = PI * 1 * cos (PI * (1 * d)) * Rabs (sin (PI * (k_v * v))).
Proof.
  assert (Z : Rabs 0 < 1/2) by (rewrite Rabs_R0; lra). assert (B : 1/2 + Rabs 0 <= 1 / 1) by nra.
  intro H. generalize (H (1/2) 1 0 _ Z) PI_RGT_0. rewrite (proj1 (straddling__of_the_difference 0 (1/2) 1 1 0 (1/2) 0 Z) Rlt_0_1 B (or_introl
    (ex_intro _ 1%Z eq_refl))).
  rewrite half_sine, !Rmult_0_r, sin_0, cos_0, Rabs_R1. lra.
Qed.
Lemma cosine_of_whole m : cos (PI * IZR m) = 1 \/ cos (PI * IZR m) = - (1).
Proof. apply Rsqr_eq. rewrite cos2, sine_of_whole. unfold Rsqr. ring. Qed.
(* The slope of a half-wave |sin pi k x|, where it has one. *)
Definition slope_of_wave (k x : R) := PI * k * cos (PI * (k * x)) * sign (sin (PI * (k * x))).
Lemma slope_factors u v k_u k_v : gradient_ridges.h_u u v k_u k_v = slope_of_wave k_u u * Rabs (sin (PI * (k_v * v))) /\ gradient_ridges.h_v u v
  k_u k_v = slope_of_wave k_v v * Rabs (sin (PI * (k_u * u))).
Proof. unfold slope_of_wave. unfold_fields. rewrite sign_mult, <- !times_its_sign. lra. Qed.
Lemma slope_beside k d m : 0 < k -> Rabs d < 1 / k -> slope_of_wave k (IZR m / k + d) = sign d * PI * k * cos (PI * (k * d)).
Proof.
  intros K D. apply Rabs_def2 in D. pose proof PI_RGT_0. assert (k * (1 / k) = 1) by (field; lra).
  assert (S : sign (sin (PI * (k * d))) = sign d).
  { assert (B : -1 < k * d < 1) by nra. rewrite <- (Rmult_1_l (sign d)), <- (sign_eq_1 k K), <- sign_mult. destruct (Rtotal_order (k * d) 0) as
    [L|[->|L]]; [rewrite !sign_eq_m1 | rewrite Rmult_0_r, sin_0 | rewrite !sign_eq_1]; first [reflexivity | lra | apply sin_lt_0_var; nra | apply
      sin_gt_0; nra]. }
  unfold slope_of_wave. replace (PI * (k * _)) with (PI * (k * d) + PI * IZR m) by (field; lra).
  rewrite sin_plus, cos_plus, sine_of_whole, !Rmult_0_r, Rplus_0_r, sign_mult, S.
  destruct (cosine_of_whole m) as [-> | ->]; [rewrite (sign_eq_1 1) by lra | rewrite (sign_eq_m1 (- _)) by lra]; ring.
Qed.
Theorem straddling__of_the_slope u v k_u k_v d m : (0 < k_u -> 0 < Rabs d < 1 / k_u -> gradient_ridges.h_u (IZR m / k_u + d) v k_u k_v = sign d *
  PI * k_u * cos (PI * (k_u * d)) * Rabs (sin (PI * (k_v * v)))) /\ (0 < k_v -> 0 < Rabs d < 1 / k_v -> gradient_ridges.h_v u (IZR m / k_v + d)
  k_u k_v = sign d * PI * k_v * cos (PI * (k_v * d)) * Rabs (sin (PI * (k_u * u)))).
Proof. split; intros K [_ D]; [rewrite (proj1 (slope_factors _ _ _ _)) | rewrite (proj2 (slope_factors _ _ _ _))]; rewrite slope_beside by assumption;
  reflexivity. Qed.
Theorem straddling__of_the_slope__false : ~ forall v k_v d, 0 < Rabs d < 1 -> gradient_ridges.h_u (0 / 1 + d) v 1 k_v = PI * 1 * cos (PI * (1 * d)) *
  Rabs (sin (PI * (k_v * v))).
Proof.
  assert (D : 0 < Rabs (- (1/4)) < 1 / 1) by (rewrite Rabs_left; lra). intro H. generalize (H (1/2) 1 (- (1/4)) ltac:(lra)).
  rewrite (proj1 (straddling__of_the_slope 0 _ 1 1 _ 0) Rlt_0_1 D), sign_eq_m1 by lra. rewrite half_sine, Rabs_R1. apply Rlt_not_eq. interval.
Qed.
(* So the error beside the crease comes to pi k, slope less difference as the distance falls to 0. *)
Theorem straddling__error (v k_v epsilon : R) (k m : Z) : (0 < k)%Z -> 0 < epsilon < 1 / IZR k -> let u d := IZR m / IZR k + d in
  filterlim (fun d => gradient_ridges.h_u (u d) v (IZR k) k_v - central_ridges.h_u (u d) v (IZR k) k_v epsilon) (at_right 0) (locally (PI * IZR k *
    Rabs (sin (PI * (k_v * v))))).
Proof.
  intros K E u. apply IZR_lt in K. set (w := Rabs _).
  set (f d := PI * IZR k * cos (PI * (IZR k * d)) * w - cos (PI * (IZR k * epsilon)) * sin (PI * (IZR k * d)) / epsilon * w). apply
    (filterlim_ext_loc f).
  - assert (P : 0 < Rmin epsilon (1 / IZR k - epsilon)) by (apply Rmin_glb_lt; lra). exists (mkposreal _ P). intros d B D. change (Rabs (d - 0) <
    Rmin epsilon (1 / IZR k - epsilon)) in B.
    rewrite Rminus_0_r in B. apply Rmin_Rgt in B. destruct B as [B1 B2].
    unfold u. rewrite (proj1 (straddling__of_the_slope 0 v _ k_v d m)), (proj1 (straddling__of_the_difference 0 v _ k_v d epsilon m B1)); try lra.
    + rewrite sign_eq_1 by lra. unfold f, w. ring.
    + left. exists k. reflexivity.
    + split; [apply Rabs_pos_lt; lra | lra].
  - apply (filterlim_filter_le_1 (F := locally 0)); [apply filter_le_within|]. replace (_ * _) with (f 0) by (unfold f; rewrite !Rmult_0_r, sin_0,
    cos_0; lra). apply (ex_derive_continuous f). unfold f. auto_derive. trivial.
Qed.
(* It does not come to 0. *)
Theorem straddling__error__false : ~ forall v k_v epsilon (k m : Z), 0 < epsilon < 1 / IZR k -> let u d := IZR m / IZR k + d in
  filterlim (fun d => gradient_ridges.h_u (u d) v (IZR k) k_v - central_ridges.h_u (u d) v (IZR k) k_v epsilon) (at_right 0) (locally 0).
Proof.
  intro H. assert (E : 0 < 1/2 < 1 / 1) by lra. generalize PI_RGT_0 (filterlim_locally_unique _ _ _ (H (1/2) 1 (1/2) 1%Z 0%Z E) (straddling__error
    (1/2) 1 (1/2) 1 0 ltac:(easy) E)).
  rewrite half_sine, Rabs_R1. lra.
Qed.

(* Ridges beside its creases, and where they cross *)

Theorem ridges_at_crossings__crossing : Statements.ridges_at_crossings__crossing.
Proof.
  intros k_u k_v m n a b K L M N. rewrite Rabs_mult, !beyond_a_crease, <- Rabs_mult, pow2_abs by (assumption || lra).
  assert (S : forall x, sin x ^ 2 <= x ^ 2) by (intro x; rewrite <- (pow2_abs x), <- pow2_abs; apply pow_incr; split; [apply Rabs_pos | apply
    sine_below]).
  generalize (S (a * PI * k_u)) (S (b * PI * k_v)) (pow2_ge_0 (sin (a * PI * k_u) ^ 2 - sin (b * PI * k_v) ^ 2)). lra.
Qed.
Theorem ridges_at_crossings__flat : Statements.ridges_at_crossings__flat.
Proof. claim. Qed.

Lemma cubic_below x : 0 < x -> x * (1 - x ^ 2 / 6) <= sin x <= x.
Proof. intro X. generalize (sine_from_below x) (sin_lt_x x). lra. Qed.
(* At the distance t on either side of a crease m/k, where the other factor of ridges is w. *)
Lemma either_side k m t w : k > 0 -> t > 0 -> k * t <= 1 -> sin (PI * m) = 0 -> let f := Rabs (sin (PI * (k * (1 * t + m / k)))) in let g := Rabs
  (sin (PI * (k * (m / k - t)))) in k <> 0 /\ f = sin (t * PI * k) /\ g = sin (t * PI * k) /\ t * PI * k * Rabs w * (1 - 1 / 6 * PI ^ 2 * k ^ 2 *
  t ^ 2) <= sin (t * PI * k) * Rabs w <= t * PI * k * Rabs w.
Proof.
  intros K T L M f g. pose proof PI_RGT_0. assert (X : 0 < t * PI * k <= PI) by (split; [apply Rmult_lt_0_compat; nra | nra]).
  assert (S : Rabs _ = sin (t * PI * k)) by (apply Rabs_pos_eq, sin_ge_0; lra).
  split; [lra | split; [|split]].
  - unfold f. rewrite Rmult_1_l, beyond_a_crease by lra. exact S.
  - unfold g. replace (m / k - t) with (- t + m / k) by ring. rewrite beyond_a_crease by (assumption || lra).
    replace (- t * PI * k) with (- (t * PI * k)) by ring. rewrite sin_neg, Rabs_Ropp. exact S.
  - destruct (cubic_below _ (proj1 X)) as [B C]. generalize (Rabs_pos w). set (x := t * PI * k) in *. intro W.
    replace (1 / 6 * PI ^ 2 * k ^ 2 * t ^ 2) with (x ^ 2 / 6) by (unfold x; field). split; nra.
Qed.
Theorem ridges_on_creases__crease_in_u : Statements.ridges_on_creases__crease_in_u.
Proof.
  red. intros. destruct (either_side k_u m to_u (sin (v * PI * k_v))) as (N & F & G & B); try assumption. rewrite !Rabs_mult, F, G.
  printed_angles. lra.
Qed.
Theorem ridges_on_creases__crease_in_v : Statements.ridges_on_creases__crease_in_v.
Proof.
  red. intros. destruct (either_side k_v m to_v (sin (u * PI * k_u))) as (N & F & G & B); try assumption. rewrite !Rabs_mult, F, G.
  printed_angles. lra.
Qed.
Theorem ridges_on_creases__differ : Statements.ridges_on_creases__differ.
Proof. claim. Qed.

(* Where the other factor of ridges is not 0, it has no derivative across a crease. *)
Theorem ridges_on_creases__no_derivative (u v k_u k_v : R) (m : Z) :
  (0 < k_u -> sin (PI * (k_v * v)) <> 0 -> ~ ex_derive (fun u => height_ridges.h u v k_u k_v) (IZR m / k_u)) /\
  (0 < k_v -> sin (PI * (k_u * u)) <> 0 -> ~ ex_derive (fun v => height_ridges.h u v k_u k_v) (IZR m / k_v)).
Proof. split; intros K S; [apply kink_loci__creased_in_u | apply kink_loci__creased_in_v]; first [lra | exists m; field; lra]. Qed.
(* The seed: ridges is differentiable. *)
Theorem ridges_on_creases__no_derivative__false : ~ forall u v k_u k_v, ex_derive (fun u => height_ridges.h u v k_u k_v) u.
Proof. intro H. apply (proj1 (ridges_on_creases__no_derivative 0 (1/2) 1 1 0)); [lra | rewrite half_sine; lra | auto]. Qed.

(* Where creases cross, ridges is differentiable in both coordinates together, and its derivative is 0. *)
Theorem ridges_at_crossings__differentiable (k_u k_v : R) (m n : Z) : 0 < k_u -> 0 < k_v ->
  (forall a b, 0 <= height_ridges.h (a + IZR m / k_u) (b + IZR n / k_v) k_u k_v <= PI ^ 2 * Rmax k_u k_v ^ 2 * (a ^ 2 + b ^ 2) / 2) /\
  differentiable_pt_lim (fun u v => height_ridges.h u v k_u k_v) (IZR m / k_u) (IZR n / k_v) 0 0.
Proof.
  intros K L. generalize PI_RGT_0. intro P. set (c := Rmax k_u k_v). assert (C : k_u <= c /\ k_v <= c) by (split; [apply Rmax_l | apply Rmax_r]).
  assert (S : forall x k i, 0 < k <= c -> Rabs (sin (PI * (k * (x + IZR i / k)))) <= Rabs x * (PI * c)).
  { intros x k i I. rewrite beyond_a_crease by (apply sine_of_whole || lra). eapply Rle_trans; [apply sine_below|]. rewrite Rmult_assoc, Rabs_mult,
    (Rabs_pos_eq (PI * k)) by nra. apply Rmult_le_compat_l; [apply Rabs_pos | nra]. }
  assert (B : forall a b, 0 <= height_ridges.h (a + IZR m / k_u) (b + IZR n / k_v) k_u k_v <= PI ^ 2 * c ^ 2 * (a ^ 2 + b ^ 2) / 2).
  { split; [apply Rabs_pos|]. unfold height_ridges.h. rewrite Rabs_mult. eapply Rle_trans; [apply Rmult_le_compat; [apply Rabs_pos | apply Rabs_pos |
    apply S; lra | apply S; lra]|].
    rewrite <- (pow2_abs a), <- (pow2_abs b). generalize (pow2_ge_0 (PI * c * (Rabs a - Rabs b))). lra. }
  split; auto. intro e. assert (D : 0 < PI ^ 2 * c ^ 2) by (apply Rmult_lt_0_compat; apply pow_lt; lra).
  exists (mkposreal _ (Rdiv_lt_0_compat _ _ (cond_pos e) D)). cbn [pos]. intros u v U V.
  generalize (B 0 0) (B (u - IZR m / k_u) (v - IZR n / k_v)). rewrite !Rplus_0_l, !(Rplus_comm (_ - _)), !Rplus_minus.
  set (a := u - IZR m / k_u) in *. set (b := v - IZR n / k_v) in *. intros Z [K0 H]. rewrite !Rmult_0_l, Rplus_0_l, Rminus_0_r.
  replace (height_ridges.h (IZR m / k_u) _ k_u k_v) with 0 by lra. rewrite Rminus_0_r, Rabs_pos_eq by nra.
  rewrite <- (pow2_abs a), <- (pow2_abs b) in H. pose proof Rmax_lub_lt _ _ _ U V as Y. apply Rlt_div_r in Y; auto.
  generalize (Rmax_l (Rabs a) (Rabs b)) (Rmax_r (Rabs a) (Rabs b)) (Rabs_pos a) (Rabs_pos b). set (t := Rmax (Rabs a) _) in *. intros.
  eapply Rle_trans; [exact H|]. apply Rle_trans with (t * (PI ^ 2 * c ^ 2) * t); [|apply Rmult_le_compat_r; lra]. assert (Rabs a ^ 2 + Rabs b ^ 2 <=
    2 * t ^ 2) by nra. nra.
Qed.
(* Where one crease runs alone it is not. *)
Theorem ridges_at_crossings__differentiable__false : ~ forall u v, differentiable_pt_lim (fun u v => height_ridges.h u v 1 1) u v 0 0.
Proof.
  intro H. apply (proj1 (ridges_on_creases__no_derivative 0 (1/2) 1 1 0)); [lra | rewrite half_sine; lra|]. exists (0 * 1 + 0 * 0). apply
    is_derive_Reals.
  apply (derivable_pt_lim_comp_2d (fun u v => height_ridges.h u v 1 1)); [auto | apply derivable_pt_lim_id | apply derivable_pt_lim_const].
Qed.
