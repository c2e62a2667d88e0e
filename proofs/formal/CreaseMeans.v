(* The tents of the error beside the creases: where they stand, their areas, and the root mean squares over the chart. *)

From Coq Require Import Reals Lra Psatz Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Fields Clamped Creases CreaseError.
Open Scope R_scope.


(* The tent beside a crease at the distance d, and the tents of all creases m/k: of the nearest one. *)
Definition tent (k epsilon d : R) : R := if Rlt_dec (Rabs d) epsilon then sign d * (PI * k * (Rabs d / epsilon - 1)) else 0.
Definition nearest (k x : R) : R := IZR (Int_part (k * x + 1 / 2)) / k.
Lemma nearest_is (k x : R) (m : Z) : 0 < k -> IZR m / k - / (2 * k) <= x < IZR m / k + / (2 * k) -> nearest k x = IZR m / k.
Proof.
  intros K X. assert (B : IZR m <= k * x + 1 / 2 < IZR m + 1).
  { assert (E : IZR m = k * (IZR m / k)) by (field; lra). assert (F : k * / (2 * k) = 1 / 2) by (field; lra). nra. }
  unfold nearest. do 2 f_equal. destruct (base_Int_part (k * x + 1 / 2)) as [L U]. set (i := Int_part _) in *. assert (m - 1 < i < m + 1)%Z by (split; apply lt_IZR; rewrite ?minus_IZR, ?plus_IZR; lra). lia.
Qed.
Lemma near_the_nearest (k x : R) : 0 < k -> exists m : Z, nearest k x = IZR m / k /\ - / (2 * k) <= x - IZR m / k <= / (2 * k).
Proof.
  intro K. exists (Int_part (k * x + 1 / 2)). split; [reflexivity|]. destruct (base_Int_part (k * x + 1 / 2)) as [L U]. set (i := IZR (Int_part _)) in *.
  assert (I : 0 < / k) by (apply Rinv_0_lt_compat, K). rewrite Rinv_mult. replace (x - i / k) with ((k * x - i) * / k) by (field; lra). split; nra.
Qed.

(* Of a half-wave |sin pi k d| the difference is the slope and the tent, up to 2/3 pi k (pi k eps)^2. *)
Definition of_a_hump (k epsilon d : R) : R := (Rabs (sin (PI * (k * (d + epsilon)))) - Rabs (sin (PI * (k * (d - epsilon))))) / (2 * epsilon) - sign d * PI * k * cos (PI * (k * d)).
Definition room (k epsilon : R) : R := 2 / 3 * (PI * k) * (PI * k * epsilon) ^ 2.
Lemma sine_over (x : R) : 0 < x -> Rabs (sin x / x - 1) <= x ^ 2 / 6.
Proof. intro X. assert (E : x * (sin x / x) = sin x) by (field; lra). generalize (cubic_below x X). intro. apply Rabs_le. nra. Qed.
Lemma hump_after (k epsilon d : R) : 0 < k -> 0 < epsilon <= / (2 * k) -> 0 < d <= / (2 * k) -> Rabs (of_a_hump k epsilon d - tent k epsilon d) <= room k epsilon.
Proof.
  intros K E D. generalize PI_RGT_0. intro P. assert (I : k * / (2 * k) = 1 / 2) by (field; lra). assert (Q : 0 < PI * k) by nra.
  unfold of_a_hump, tent. rewrite sign_eq_1, (Rabs_pos_eq d) by lra. destruct (Rlt_dec d epsilon) as [L|L].
  - destruct (straddling__value d epsilon k) as [_ V]; try lra; [nra | nra|]. destruct (crease_error_area__tent d epsilon k) as (_ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & _ & A & B); try lra; [nra|].
    revert V A B. replace (PI * (1 / 2 * 1)) with (PI / 2) by field. rewrite sin_PI2, !Rmult_1_l. set (s := sin (d * PI * k)). set (c := cos (epsilon * PI * k)). set (c' := cos (d * PI * k)).
    set (rest := s * c / epsilon / (PI * k) - c' - _). intros V A B. replace (PI * (k * d)) with (d * PI * k) by ring. fold c'.
    replace (2 / 3 * PI ^ 3 * epsilon ^ 2 * k ^ 3 / (PI * k)) with (2 / 3 * (PI * k * epsilon) ^ 2) in A, B by (field; lra).
    match goal with |- Rabs ?x <= _ => replace x with (PI * k * rest) end.
    + unfold room. replace (2 / 3 * (PI * k) * (PI * k * epsilon) ^ 2) with (PI * k * (2 / 3 * (PI * k * epsilon) ^ 2)) by ring.
      rewrite Rabs_mult, (Rabs_pos_eq (PI * k)) by lra. apply Rmult_le_compat_l; [lra|]. apply Rabs_le. lra.
    + transitivity (s * c / epsilon - PI * k * c' - PI * k * (d / epsilon - 1)); [unfold rest; field; lra|]. rewrite <- V. field. lra.
  - assert (S : forall t, 0 <= t <= 1 / k -> 0 <= sin (PI * (k * t))).
    { intros t T. assert (k * (1 / k) = 1) by (field; lra). replace (PI * (k * t)) with (k * t * PI) by ring. apply sine_on_a_hump. nra. }
    assert (J : 1 / k = / (2 * k) + / (2 * k)) by (field; lra). rewrite (Rabs_pos_eq (sin (PI * (k * (d + epsilon))))), (Rabs_pos_eq (sin (PI * (k * (d - epsilon))))) by (apply S; lra).
    replace (PI * (k * (d + epsilon))) with (PI * (k * d) + PI * (k * epsilon)) by ring. replace (PI * (k * (d - epsilon))) with (PI * (k * d) - PI * (k * epsilon)) by ring.
    rewrite sin_plus, sin_minus. set (x := PI * (k * epsilon)). assert (X : 0 < x) by (unfold x; nra).
    match goal with |- Rabs ?y <= _ => replace y with (PI * k * cos (PI * (k * d)) * (sin x / x - 1)) by (unfold x; field; lra) end.
    unfold room. replace (PI * k * epsilon) with x by (unfold x; ring). rewrite Rabs_mult. apply Rle_trans with (PI * k * (x ^ 2 / 6)).
    + apply Rmult_le_compat; try apply Rabs_pos; [|apply sine_over, X]. rewrite Rabs_mult, (Rabs_pos_eq (PI * k)) by lra. generalize (cosine_at_most_1 (PI * (k * d))). nra.
    + generalize (pow2_ge_0 x). nra.
Qed.
Lemma hump_beside (k epsilon d : R) : 0 < k -> 0 < epsilon <= / (2 * k) -> - / (2 * k) <= d <= / (2 * k) -> Rabs (of_a_hump k epsilon d - tent k epsilon d) <= room k epsilon.
Proof.
  intros K E D. destruct (Rtotal_order d 0) as [L|[->|L]].
  - replace (of_a_hump k epsilon d - tent k epsilon d) with (- (of_a_hump k epsilon (- d) - tent k epsilon (- d))); [rewrite Rabs_Ropp; apply hump_after; lra|].
    unfold of_a_hump, tent. rewrite Rabs_Ropp, sign_opp. replace (PI * (k * (- d + epsilon))) with (- (PI * (k * (d - epsilon)))) by ring.
    replace (PI * (k * (- d - epsilon))) with (- (PI * (k * (d + epsilon)))) by ring. replace (PI * (k * - d)) with (- (PI * (k * d))) by ring.
    rewrite !sin_neg, !Rabs_Ropp, cos_neg. destruct (Rlt_dec _ _); field; lra.
  - unfold of_a_hump, tent. rewrite sign_0, Rabs_R0. replace (PI * (k * (0 - epsilon))) with (- (PI * (k * (0 + epsilon)))) by ring. rewrite sin_neg, Rabs_Ropp.
    destruct (Rlt_dec _ _); [|lra]. match goal with |- Rabs ?x <= _ => replace x with 0 by nra end. rewrite Rabs_R0. generalize PI_RGT_0. intros. apply Rmult_le_pos; nra.
  - apply hump_after; lra.
Qed.


(* What the kernels print beside the nearest crease, in u and, where nothing is clamped, in v. *)
Lemma slope_at (v k_u k_v d : R) (m : Z) : 0 < k_u -> - / (2 * k_u) <= d <= / (2 * k_u) ->
  gradient_ridges.h_u (IZR m / k_u + d) v k_u k_v = sign d * PI * k_u * cos (PI * (k_u * d)) * Rabs (sin (PI * (k_v * v))).
Proof.
  intros K D. assert (I : / (2 * k_u) < 1 / k_u) by (rewrite Rinv_mult; unfold Rdiv; rewrite Rmult_1_l; assert (0 < / k_u) by (apply Rinv_0_lt_compat, K); lra).
  destruct (Req_dec d 0) as [->|N].
  - rewrite sign_0. unfold_fields. replace (PI * (k_u * (IZR m / k_u + 0))) with (PI * IZR m) by (field; lra). rewrite sine_of_whole, Rmult_0_l, sign_0. ring.
  - apply (straddling__of_the_slope 0); trivial. split; [apply Rabs_pos_lt, N | apply Rle_lt_trans with (/ (2 * k_u)); [apply Rabs_le; lra | exact I]].
Qed.
Lemma swapped (u v k_u k_v : R) : gradient_ridges.h_v u v k_u k_v = gradient_ridges.h_u v u k_v k_u.
Proof. unfold_fields. rewrite (Rmult_comm (sin (PI * (k_u * u)))). reflexivity. Qed.
Lemma error_in_u (u v k_v epsilon : R) (k : Z) : 0 < IZR k -> 0 < epsilon -> let k_u := IZR k in
  central_ridges.h_u u v k_u k_v epsilon - gradient_ridges.h_u u v k_u k_v = of_a_hump k_u epsilon (u - nearest k_u u) * Rabs (sin (PI * (k_v * v))).
Proof.
  intros K E k_u. change (0 < k_u) in K. destruct (near_the_nearest k_u u K) as (m & -> & D). set (d := u - IZR m / k_u) in *. replace u with (IZR m / k_u + d) by (unfold d; ring).
  rewrite slope_at by assumption. central_ridges.lines; unfold of_a_hump.
  rewrite !Rabs_mult, !wrapped by (left; exists k; reflexivity). replace (epsilon + (IZR m / k_u + d)) with (d + epsilon + IZR m / k_u) by ring. replace (IZR m / k_u + d - epsilon) with (d - epsilon + IZR m / k_u) by ring.
  rewrite !beyond_a_crease by (apply sine_of_whole || lra). replace ((d + epsilon) * PI * k_u) with (PI * (k_u * (d + epsilon))) by ring. replace ((d - epsilon) * PI * k_u) with (PI * (k_u * (d - epsilon))) by ring.
  field. lra.
Qed.
Lemma error_in_v (u v k_u k_v epsilon : R) : 0 < k_v -> 0 < epsilon -> 0 <= v - epsilon -> v + epsilon <= 1 ->
  central_ridges.h_v u v k_u k_v epsilon - gradient_ridges.h_v u v k_u k_v = of_a_hump k_v epsilon (v - nearest k_v v) * Rabs (sin (PI * (k_u * u))).
Proof.
  intros K E A B. destruct (near_the_nearest k_v v K) as (m & -> & D). set (d := v - IZR m / k_v) in *.
  assert (V : v = IZR m / k_v + d) by (unfold d; ring). rewrite swapped. clearbody d. subst v. rewrite slope_at by assumption.
  central_ridges.lines; unfold of_a_hump.
  destruct (both _ _) as [_|[H|H]]; [|lra|lra]. rewrite Rmin_right, Rmax_left by lra. rewrite !Rabs_mult.
  replace (epsilon + (IZR m / k_v + d)) with (d + epsilon + IZR m / k_v) by ring. replace (IZR m / k_v + d - epsilon) with (d - epsilon + IZR m / k_v) by ring.
  rewrite !beyond_a_crease by (apply sine_of_whole || lra). replace ((d + epsilon) * PI * k_v) with (PI * (k_v * (d + epsilon))) by ring. replace ((d - epsilon) * PI * k_v) with (PI * (k_v * (d - epsilon))) by ring.
  field. lra.
Qed.

(* Clamped at a pole the difference is as good; the upper pole is the lower one, seen from there. *)
Lemma error_at_the_pole (u v k_u k_v epsilon : R) : 0 < k_v -> 0 < epsilon <= / (2 * k_v) -> epsilon <= 1 / 2 -> 0 < v < epsilon ->
  Rabs (central_ridges.h_v u v k_u k_v epsilon - gradient_ridges.h_v u v k_u k_v) <= room k_v epsilon.
Proof.
  intros K E E2 V. generalize PI_RGT_0. intro P. assert (I : k_v * / (2 * k_v) = 1 / 2) by (field; lra).
  destruct (clamped_difference_of_odd__of_the_fields u v k_u k_v epsilon K ltac:(lra) ltac:(lra)) as (_ & _ & H). specialize (H ltac:(nra)).
  rewrite swapped. replace (gradient_ridges.h_u v u k_v k_u) with (gradient_ridges.h_u (IZR 0 / k_v + v) u k_v k_u) by (f_equal; unfold Rdiv; ring). rewrite slope_at by lra. rewrite sign_eq_1 by lra. rewrite !Rmult_1_l, (Rmult_comm (PI * k_v * _)).
  eapply Rle_trans; [exact H|]. unfold room. replace (2 / 3 * (PI * k_v) * (PI * k_v * epsilon) ^ 2) with (2 / 3 * epsilon ^ 2 * (PI * k_v) ^ 3) by ring.
  apply Rmult_le_compat_r; [apply pow_le; nra | nra].
Qed.
Lemma seen_from_the_other_pole (u v k_u epsilon : R) (k : Z) : let k_v := IZR k in
  central_ridges.h_v u (1 - v) k_u k_v epsilon - gradient_ridges.h_v u (1 - v) k_u k_v = - (central_ridges.h_v u v k_u k_v epsilon - gradient_ridges.h_v u v k_u k_v).
Proof.
  intro k_v. rewrite !swapped. unfold_fields.
  assert (C : cos (PI * IZR k) ^ 2 = 1) by (generalize (sin2_cos2 (PI * IZR k)); rewrite sine_of_whole; unfold Rsqr; lra).
  assert (S : forall w, Rabs (sin (PI * (k_v * (1 - w)))) = Rabs (sin (PI * (k_v * w)))).
  { intro w. replace (PI * (k_v * (1 - w))) with (PI * IZR k + - (PI * (k_v * w))) by (unfold k_v; ring). rewrite sine_of_a_shift, sin_neg. apply Rabs_Ropp. }
  unfold central_ridges.h_v, central_ridges.h_v_plus, central_ridges.h_v_minus. rewrite !Rabs_mult.
  assert (A : central_ridges.v_plus (1 - v) epsilon = 1 - central_ridges.v_minus v epsilon) by (central_ridges.lines; unfold Rmin, Rmax; repeat destruct Rle_dec; lra).
  assert (B : central_ridges.v_minus (1 - v) epsilon = 1 - central_ridges.v_plus v epsilon) by (central_ridges.lines; unfold Rmin, Rmax; repeat destruct Rle_dec; lra).
  assert (D : central_ridges.span_v (1 - v) epsilon = central_ridges.span_v v epsilon) by (unfold central_ridges.span_v; rewrite A, B; destruct (both _ _) as [[]|[]], (both _ _) as [[]|[]]; lra).
  rewrite A, B, D, !S. replace (PI * (k_v * (1 - v))) with (- (PI * (k_v * v)) + PI * IZR k) by (unfold k_v; ring). rewrite sin_plus, cos_plus, sin_neg, cos_neg, sine_of_whole.
  set (c := cos (PI * IZR k)) in *. set (s := sin (PI * (k_v * v))). set (w := sin (PI * (k_u * u))). rewrite !Rmult_0_r, Rminus_0_r, Rplus_0_r.
  assert (C1 : c = 1 \/ c = -1) by (assert (Z : (c - 1) * (c + 1) = 0) by lra; apply Rmult_integral in Z; destruct Z; lra).
  destruct C1 as [-> | ->]; rewrite ?Rmult_1_r; [replace (- s * w) with (- (s * w)) by ring; rewrite sign_opp | replace (- s * -1 * w) with (s * w) by ring]; unfold Rdiv; ring.
Qed.


(* Areas: of a squared tent on either side of its crease, eps/3, *)
Lemma integral_is (f : R -> R) (a b l l' : R) : is_RInt f a b l -> l = l' -> is_RInt f a b l'.
Proof. intros H <-. exact H. Qed.
Lemma nothing (f : R -> R) (a b : R) : a <= b -> (forall x, a < x < b -> f x = 0) -> is_RInt f a b 0.
Proof.
  intros L Z. apply (is_RInt_ext (fun _ => 0)); [rewrite Rmin_left, Rmax_right by lra; intros; symmetry; apply Z; assumption|].
  eapply integral_is; [apply is_RInt_const | unfold scal; simpl; unfold mult; simpl; ring].
Qed.
Lemma side_of_a_tent (k epsilon c h : R) : 0 < epsilon <= h ->
  is_RInt (fun x => tent k epsilon (x - c) ^ 2) c (c + h) ((PI * k) ^ 2 * (epsilon / 3)) /\ is_RInt (fun x => tent k epsilon (x - c) ^ 2) (c - h) c ((PI * k) ^ 2 * (epsilon / 3)).
Proof.
  intro E. assert (A : forall s, s * s = 1 -> is_RInt (fun x => (PI * k) ^ 2 * (s * (x - c) / epsilon - 1) ^ 2) c (c + s * epsilon) (s * ((PI * k) ^ 2 * (epsilon / 3)))).
  { intros s Q. eapply integral_is; [apply (is_RInt_derive (fun x => (PI * k) ^ 2 * s * (s * (x - c) - epsilon) ^ 3 / (3 * epsilon ^ 2)))|].
    - intros x _. auto_derive; trivial. transitivity (s * s * ((PI * k) ^ 2 * (s * (x - c) / epsilon - 1) ^ 2)); [field; lra | rewrite Q; ring].
    - intros x _. apply (ex_derive_continuous (fun x => (PI * k) ^ 2 * (s * (x - c) / epsilon - 1) ^ 2)). auto_derive. trivial.
    - unfold minus, plus, opp. simpl. replace (s * (c + s * epsilon - c) - epsilon) with 0 by (replace (s * (c + s * epsilon - c)) with (s * s * epsilon) by ring; rewrite Q; ring). field. lra. }
  assert (T : forall x s, s = 1 \/ s = -1 -> 0 < s * (x - c) < epsilon -> (PI * k) ^ 2 * (s * (x - c) / epsilon - 1) ^ 2 = tent k epsilon (x - c) ^ 2).
  { intros x s [-> | ->] X; unfold tent; [rewrite sign_eq_1, Rabs_pos_eq by lra | rewrite sign_eq_m1, Rabs_left by lra]; destruct (Rlt_dec _ _); try lra; field; lra. }
  assert (Z : forall x, epsilon < Rabs (x - c) -> tent k epsilon (x - c) ^ 2 = 0) by (intros x X; unfold tent; destruct (Rlt_dec _ _); [lra | ring]). split.
  - eapply integral_is; [apply (is_RInt_Chasles _ c (c + 1 * epsilon) (c + h)); [eapply is_RInt_ext; [|apply (A 1); ring]|]|].
    + rewrite Rmin_left, Rmax_right by lra. intros x X. apply T; [left; reflexivity | lra].
    + apply nothing; [lra|]. intros x X. apply Z. rewrite Rabs_pos_eq; lra.
    + unfold plus. simpl. ring.
  - eapply integral_is; [apply (is_RInt_Chasles _ (c - h) (c + -1 * epsilon) c); [|apply is_RInt_swap; eapply is_RInt_ext; [|apply (A (-1)); ring]]|].
    + apply nothing; [lra|]. intros x X. apply Z. rewrite Rabs_left; lra.
    + rewrite Rmin_right, Rmax_left by lra. intros x X. apply T; [right; reflexivity | lra].
    + unfold plus, opp. simpl. ring.
Qed.
(* and of those over the chart: one hump each, without overlap, around the creases between whose middles it lies. *)
Definition tents (k epsilon x : R) : R := tent k epsilon (x - nearest k x).
Section areas.
Variables (k : nat) (epsilon : R).
Hypotheses (K : (0 < k)%nat) (E : 0 < epsilon <= / (2 * INR k)).
Let h := / (2 * INR k).
Let area := (PI * INR k) ^ 2 * (epsilon / 3).
Lemma halves (m : nat) : is_RInt (fun x => tents (INR k) epsilon x ^ 2) (INR m / INR k) (INR m / INR k + h) area /\ is_RInt (fun x => tents (INR k) epsilon x ^ 2) (INR m / INR k - h) (INR m / INR k) area.
Proof.
  assert (P : 0 < INR k) by (apply lt_0_INR, K). assert (H : 0 < h) by (apply Rinv_0_lt_compat; lra).
  assert (N : forall x, INR m / INR k - h < x < INR m / INR k + h -> tent (INR k) epsilon (x - INR m / INR k) ^ 2 = tents (INR k) epsilon x ^ 2).
  { intros x X. unfold tents. rewrite INR_IZR_INZ with (n := m) in *. rewrite (nearest_is _ x (Z.of_nat m)); [reflexivity | exact P | fold h; lra]. }
  destruct (side_of_a_tent (INR k) epsilon (INR m / INR k) h E) as [A B]. split; (eapply is_RInt_ext; [|eassumption]); intros x X; apply N; rewrite Rmin_left, Rmax_right in X; lra.
Qed.
Lemma inner_tents (n : nat) : is_RInt (fun x => tents (INR k) epsilon x ^ 2) h ((2 * INR n + 1) * h) (INR n * (2 * area)).
Proof.
  assert (P : 0 < INR k) by (apply lt_0_INR, K). induction n as [|n IH].
  - simpl. replace ((2 * 0 + 1) * h) with h by ring. eapply integral_is; [apply is_RInt_point | unfold zero; simpl; ring].
  - rewrite S_INR. destruct (halves (S n)) as [A B]. rewrite S_INR in A, B. replace ((INR n + 1) / INR k - h) with ((2 * INR n + 1) * h) in B by (unfold h; field; lra).
    replace ((INR n + 1) / INR k + h) with ((2 * (INR n + 1) + 1) * h) in A by (unfold h; field; lra).
    eapply integral_is; [apply (is_RInt_Chasles _ _ _ _ _ _ IH (is_RInt_Chasles _ _ _ _ _ _ B A))|]. unfold plus. simpl. ring.
Qed.
Lemma tents_in_u : is_RInt (fun x => tents (INR k) epsilon x ^ 2) 0 1 (INR k * (2 * area)).
Proof.
  assert (P : 0 < INR k) by (apply lt_0_INR, K). destruct (halves 0) as [A _]. destruct (halves k) as [_ B]. generalize (inner_tents (k - 1)). rewrite minus_INR by lia. intro C.
  simpl (INR 0) in A. replace (0 / INR k) with 0 in A by (field; lra). rewrite Rplus_0_l in A. replace (INR k / INR k) with 1 in B by (field; lra).
  simpl (INR 1) in C. replace ((2 * (INR k - 1) + 1) * h) with (1 - h) in C by (unfold h; field; lra).
  eapply integral_is; [apply (is_RInt_Chasles _ _ _ _ _ _ A (is_RInt_Chasles _ _ _ _ _ _ C B))|]. unfold plus. simpl. ring.
Qed.
Definition inner (x : R) : R := if both (Rlt_dec h x) (Rlt_dec x (1 - h)) then tents (INR k) epsilon x else 0.
Lemma tents_in_v : is_RInt (fun x => inner x ^ 2) 0 1 ((INR k - 1) * (2 * area)).
Proof.
  assert (P : 0 < INR k) by (apply lt_0_INR, K). assert (P1 : 1 <= INR k) by (apply (le_INR 1); lia). assert (H : 0 < h) by (apply Rinv_0_lt_compat; lra). assert (H1 : INR k * h = 1 / 2) by (unfold h; field; lra).
  assert (H2 : h <= 1 / 2) by nra. generalize (inner_tents (k - 1)). rewrite minus_INR by lia. simpl (INR 1). replace ((2 * (INR k - 1) + 1) * h) with (1 - h) by lra. intro C.
  eapply integral_is; [apply (is_RInt_Chasles _ 0 h 1); [|apply (is_RInt_Chasles _ h (1 - h) 1); [eapply is_RInt_ext; [|exact C]|]]|].
  - apply nothing; [lra|]. intros x X. unfold inner. destruct (both _ _) as [[]|_]; [lra | ring].
  - rewrite Rmin_left, Rmax_right by lra. intros x X. unfold inner. destruct (both _ _) as [_|[]]; [reflexivity | lra | lra].
  - apply nothing; [lra|]. intros x X. unfold inner. destruct (both _ _) as [[]|_]; [lra | ring].
  - unfold plus. simpl. ring.
Qed.
End areas.


(* The mean square of the error is there: it is continuous between creases. *)
Lemma sign_between (k x : R) (j : Z) : IZR j < k * x < IZR j + 1 -> sign (sin (PI * (k * x))) = cos (PI * IZR j).
Proof.
  intro X. generalize PI_RGT_0 (sine_of_whole j). intros P S. assert (0 < sin (PI * (k * x - IZR j))) by (apply sin_gt_0; nra).
  replace (PI * (k * x)) with (PI * (k * x - IZR j) + PI * IZR j) by ring. rewrite sin_plus, S, Rmult_0_r, Rplus_0_r, sign_mult, sign_eq_1, Rmult_1_l by assumption.
  assert (Z : (cos (PI * IZR j) - 1) * (cos (PI * IZR j) + 1) = 0) by (generalize (sin2_cos2 (PI * IZR j)); rewrite S; unfold Rsqr; lra). apply Rmult_integral in Z.
  destruct Z as [Z|Z]; [rewrite sign_eq_1 | rewrite sign_eq_m1]; lra.
Qed.
Lemma square_has_a_mean (k : nat) (f C : R -> R) : (0 < k)%nat -> (forall x, 0 <= x <= 1 -> continuity_pt C x) ->
  (forall x, 0 < x < 1 -> f x = C x - PI * INR k * cos (PI * (INR k * x)) * sign (sin (PI * (INR k * x)))) -> ex_RInt (fun x => f x ^ 2) 0 1.
Proof.
  intros K Cc F. assert (P : 0 < INR k) by (apply lt_0_INR, K). assert (I : forall j, (j <= k)%nat -> ex_RInt (fun x => f x ^ 2) 0 (INR j / INR k)).
  { induction j as [|j IH]; intro J; [simpl; unfold Rdiv; rewrite Rmult_0_l; apply ex_RInt_point|]. apply ex_RInt_Chasles with (INR j / INR k); [apply IH; lia|].
    assert (B : 0 <= INR j /\ INR j + 1 <= INR k) by (split; [apply pos_INR | rewrite <- S_INR; apply le_INR, J]). rewrite S_INR.
    assert (O : INR j / INR k <= (INR j + 1) / INR k) by (apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, P | lra]).
    assert (A1 : INR k * (INR j / INR k) = INR j) by (field; lra). assert (A2 : INR k * ((INR j + 1) / INR k) = INR j + 1) by (field; lra).
    apply (ex_RInt_ext (fun x => (C x - PI * INR k * cos (PI * (INR k * x)) * cos (PI * IZR (Z.of_nat j))) ^ 2)).
    - rewrite Rmin_left, Rmax_right by exact O. intros x X. assert (Y : INR j < INR k * x < INR j + 1).
      { clear - A1 A2 X P. split; nra. }
      rewrite F, (sign_between _ _ (Z.of_nat j)) by (rewrite <- ?INR_IZR_INZ; first [exact Y | split; nra]). reflexivity.
    - apply (ex_RInt_continuous (V := R_CompleteNormedModule)). rewrite Rmin_left, Rmax_right by exact O. intros x X. apply (continuous_comp (fun x => C x - PI * INR k * cos (PI * (INR k * x)) * cos (PI * IZR (Z.of_nat j))) (fun y => y ^ 2)).
      + apply (continuous_minus C); [apply continuity_pt_filterlim, Cc; split; nra|]. apply (ex_derive_continuous (fun x => PI * INR k * cos (PI * (INR k * x)) * cos (PI * IZR (Z.of_nat j)))). auto_derive. trivial.
      + apply (ex_derive_continuous (fun y => y ^ 2)). auto_derive. trivial. }
  specialize (I k (le_n k)). replace (INR k / INR k) with 1 in I by (field; lra). exact I.
Qed.

(* Two functions that are at most b apart have root mean squares at most b apart. *)
Lemma near_in_mean (a m b : R) : 0 <= a -> 0 < b -> (forall l, 0 < l -> m <= (1 + l) * a + (1 + / l) * b ^ 2) -> sqrt m <= sqrt a + b.
Proof.
  intros A B H. generalize (sqrt_pos a) (sqrt_sqrt a A). set (s := sqrt a). intros S Q. clearbody s. rewrite <- (sqrt_pow2 (s + b)) by lra. apply sqrt_le_1_alt.
  destruct (Req_dec s 0) as [Z|N].
  - apply Rnot_lt_le. subst s. rewrite Rplus_0_l. intro L. assert (A0 : a = 0) by lra. assert (B2 : 0 < b ^ 2) by (apply pow_lt, B).
    assert (L0 : 0 < 2 * b ^ 2 / (m - b ^ 2)) by (apply Rdiv_lt_0_compat; lra). assert (U := H _ L0). rewrite A0 in U.
    assert (V : (1 + / (2 * b ^ 2 / (m - b ^ 2))) * b ^ 2 = b ^ 2 + (m - b ^ 2) / 2) by (field; split; lra). lra.
  - generalize (H (b / s) ltac:(apply Rdiv_lt_0_compat; lra)). replace ((1 + b / s) * a + (1 + / (b / s)) * b ^ 2) with ((s + b) ^ 2) by (rewrite <- Q; field; lra). trivial.
Qed.
Lemma at_most_apart (x y b l : R) : Rabs (x - y) <= b -> 0 < l -> x ^ 2 <= (1 + l) * y ^ 2 + (1 + / l) * b ^ 2.
Proof.
  intros D L. apply Rabs_le_between in D. assert (I : 0 < / l) by (apply Rinv_0_lt_compat, L). set (r := x - y) in *. replace x with (y + r) by (unfold r; ring).
  assert (R2 : r ^ 2 <= b ^ 2) by (assert (0 <= (b - r) * (b + r)) by (apply Rmult_le_pos; lra); lra). assert (X : 0 <= / l * (l * y - r) ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]).
  replace (/ l * (l * y - r) ^ 2) with (l * y ^ 2 - 2 * y * r + / l * r ^ 2) in X by (field; lra).
  assert (/ l * r ^ 2 <= / l * b ^ 2) by (apply Rmult_le_compat_l; lra). lra.
Qed.
Lemma square_at_most (f g : R -> R) (F G b l : R) : is_RInt (fun x => f x ^ 2) 0 1 F -> is_RInt (fun x => g x ^ 2) 0 1 G -> (forall x, 0 < x < 1 -> Rabs (f x - g x) <= b) -> 0 < l ->
  F <= (1 + l) * G + (1 + / l) * b ^ 2.
Proof.
  intros IF IG D L. set (c := (1 + / l) * b ^ 2). assert (J := is_RInt_plus _ _ _ _ _ _ (is_RInt_scal _ _ _ (1 + l) _ IG) (is_RInt_const 0 1 c)).
  assert (Q := is_RInt_le _ _ 0 1 _ _ Rle_0_1 IF J). unfold plus, scal in Q. simpl in Q. unfold mult in Q. simpl in Q.
  replace ((1 + l) * G + c) with ((1 + l) * G + (1 - 0) * c) by ring. apply Q. intros x X. apply at_most_apart; [apply D, X | exact L].
Qed.
(* Of f(x) w(y), where w has the mean square 1/2, and g(x) w(y). *)
Lemma mean_squares (f g w : R -> R) (F G b : R) : is_RInt (fun x => f x ^ 2) 0 1 F -> is_RInt (fun x => g x ^ 2) 0 1 G -> (forall x, 0 < x < 1 -> Rabs (f x - g x) <= b) -> 0 < b ->
  is_RInt (fun y => w y ^ 2) 0 1 (1/2) -> (forall y, is_RInt (fun x => (f x * w y) ^ 2) 0 1 (w y ^ 2 * F)) /\ is_RInt (fun y => w y ^ 2 * F) 0 1 (F / 2) /\ Rabs (sqrt (F / 2) - sqrt (G / 2)) <= b.
Proof.
  intros IF IG D B W. split; [|split].
  - intro y. assert (J := is_RInt_scal _ _ _ (w y ^ 2) _ IF). change (is_RInt (fun x => w y ^ 2 * f x ^ 2) 0 1 (w y ^ 2 * F)) in J. revert J. apply is_RInt_ext. intros x _. change (w y ^ 2 * f x ^ 2 = (f x * w y) ^ 2). ring.
  - assert (J := is_RInt_scal _ _ _ F _ W). change (is_RInt (fun y => F * w y ^ 2) 0 1 (F * (1 / 2))) in J. replace (F / 2) with (F * (1 / 2)) by field. revert J. apply is_RInt_ext.
    intros y _. apply Rmult_comm.
  - assert (F0 : 0 <= F) by exact (is_RInt_ge_0 _ 0 1 F Rle_0_1 IF (fun x _ => pow2_ge_0 (f x))). assert (G0 : 0 <= G) by exact (is_RInt_ge_0 _ 0 1 G Rle_0_1 IG (fun x _ => pow2_ge_0 (g x))).
    assert (M : forall a m, (forall l, 0 < l -> m <= (1 + l) * a + (1 + / l) * b ^ 2) -> forall l, 0 < l -> m / 2 <= (1 + l) * (a / 2) + (1 + / l) * b ^ 2).
    { intros a m H l L. generalize (H l L). assert (0 < / l) by (apply Rinv_0_lt_compat, L). assert (0 <= (1 + / l) * b ^ 2) by (apply Rmult_le_pos; [lra | apply pow2_ge_0]). lra. }
    assert (X : sqrt (F / 2) <= sqrt (G / 2) + b) by (apply near_in_mean; [lra | exact B | apply M; intros l L; apply (square_at_most f g); assumption]).
    assert (Y : sqrt (G / 2) <= sqrt (F / 2) + b) by (apply near_in_mean; [lra | exact B | apply M; intros l L; apply (square_at_most g f); trivial; intros x Z; rewrite Rabs_minus_sym; apply D, Z]).
    apply Rabs_le. lra.
Qed.


(* The errors over the chart where the other factor of ridges is 1. *)
Definition error_along_u (k epsilon u : R) : R := central_ridges.h_u u (1/2) k 1 epsilon - gradient_ridges.h_u u (1/2) k 1.
Definition error_along_v (k epsilon v : R) : R := central_ridges.h_v (1/2) v 1 k epsilon - gradient_ridges.h_v (1/2) v 1 k.
Lemma factor_of_u (u v k_u k_v epsilon : R) : central_ridges.h_u u v k_u k_v epsilon - gradient_ridges.h_u u v k_u k_v = error_along_u k_u epsilon u * Rabs (sin (PI * (k_v * v))).
Proof.
  unfold error_along_u, central_ridges.h_u, central_ridges.h_u_plus, central_ridges.h_u_minus. unfold_fields. rewrite !Rabs_mult, sine_of_a_right_angle, Rabs_R1, !Rmult_1_r, sign_mult.
  set (s := sin (PI * (k_v * v))). assert (S := times_its_sign s).
  rewrite <- S at 3. rewrite <- S. central_ridges.lines; unfold Rdiv. ring.
Qed.
Lemma factor_of_v (u v k_u k_v epsilon : R) : central_ridges.h_v u v k_u k_v epsilon - gradient_ridges.h_v u v k_u k_v = error_along_v k_v epsilon v * Rabs (sin (PI * (k_u * u))).
Proof.
  unfold error_along_v. rewrite !swapped. unfold central_ridges.h_v, central_ridges.h_v_plus, central_ridges.h_v_minus. unfold_fields. rewrite !Rabs_mult, sine_of_a_right_angle, Rabs_R1, !Rmult_1_l, !Rmult_1_r, sign_mult.
  set (s := sin (PI * (k_u * u))). assert (S := times_its_sign s).
  rewrite <- S. unfold Rdiv. ring.
Qed.


Section chart.
Variables (k : nat) (epsilon : R).
Hypotheses (K : (0 < k)%nat) (E : 0 < epsilon <= / (2 * INR k)).
Let k_pos : 0 < INR k := lt_0_INR k K.
Lemma whole : INR k = IZR (Z.of_nat k).
Proof. apply INR_IZR_INZ. Qed.
Lemma reach_is : INR k * / (2 * INR k) = 1 / 2 /\ 0 < / (2 * INR k) <= 1 / 2.
Proof.
  generalize k_pos. intro P. assert (P1 : 1 <= INR k) by (apply (le_INR 1), K). assert (I : INR k * / (2 * INR k) = 1 / 2) by (field; lra).
  assert (0 < / (2 * INR k)) by (apply Rinv_0_lt_compat; lra). split; [exact I | split; [assumption|]]. assert (0 <= (INR k - 1) * / (2 * INR k)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma near_tents_in_u (u : R) : Rabs (error_along_u (INR k) epsilon u - tents (INR k) epsilon u) <= room (INR k) epsilon.
Proof.
  generalize k_pos. intro P. unfold error_along_u. rewrite whole in *. rewrite error_in_u by lra. rewrite sine_of_a_right_angle, Rabs_R1, Rmult_1_r. unfold tents.
  destruct (near_the_nearest _ u P) as (m & -> & D). apply hump_beside; lra.
Qed.
Lemma near_inner (v : R) : 0 <= v - epsilon -> v + epsilon <= 1 -> Rabs (error_along_v (INR k) epsilon v - tents (INR k) epsilon v) <= room (INR k) epsilon.
Proof.
  generalize k_pos. intros P A B. unfold error_along_v. rewrite error_in_v by lra. rewrite sine_of_a_right_angle, Rabs_R1, Rmult_1_r. unfold tents.
  destruct (near_the_nearest _ v P) as (m & -> & D). apply hump_beside; lra.
Qed.
Lemma near_the_pole (v : R) : 0 < v <= / (2 * INR k) -> Rabs (error_along_v (INR k) epsilon v) <= room (INR k) epsilon.
Proof.
  generalize k_pos reach_is. intros P [R1 R2] V. destruct (Rlt_le_dec v epsilon) as [L|L].
  - apply error_at_the_pole; lra.
  - assert (Z : tents (INR k) epsilon v = 0).
    { unfold tents, tent. destruct (near_the_nearest _ v P) as (m & -> & D). destruct (Rlt_dec _ _) as [X|_]; [exfalso | reflexivity]. apply Rabs_def2 in X.
      assert (Y : INR k * (IZR m / INR k) = IZR m) by (field; lra). assert (0 < IZR m) by (rewrite <- Y; apply Rmult_lt_0_compat; lra).
      assert (IZR m < 1) by (rewrite <- Y; apply Rlt_le_trans with (INR k * (2 * / (2 * INR k))); [apply Rmult_lt_compat_l; lra | lra]). assert (0 < m < 1)%Z by (split; apply lt_IZR; lra). lia. }
    generalize (near_inner v ltac:(lra) ltac:(lra)). rewrite Z, Rminus_0_r. trivial.
Qed.
Lemma near_tents_in_v (v : R) : 0 < v < 1 -> Rabs (error_along_v (INR k) epsilon v - inner k epsilon v) <= room (INR k) epsilon.
Proof.
  generalize reach_is. intros [R1 R2] V. unfold inner. destruct (both _ _) as [[A B]|[A|A]]; [apply near_inner; lra | rewrite Rminus_0_r; apply near_the_pole; lra |].
  rewrite Rminus_0_r. replace v with (1 - (1 - v)) by ring. unfold error_along_v. rewrite whole, seen_from_the_other_pole, <- whole, Rabs_Ropp. apply near_the_pole. lra.
Qed.
Lemma mean_in_u : ex_RInt (fun u => error_along_u (INR k) epsilon u ^ 2) 0 1.
Proof.
  apply (square_has_a_mean k _ (fun u => (Rabs (sin (PI * (INR k * (epsilon + u)))) - Rabs (sin (PI * (INR k * (u - epsilon))))) * / (2 * epsilon)) K).
  - intros x _. reg.
  - intros u U. unfold error_along_u; central_ridges.lines. unfold_fields.
    rewrite !Rabs_mult, !wrapped, sine_of_a_right_angle, Rabs_R1, !Rmult_1_r by (left; exists (Z.of_nat k); apply whole). field. lra.
Qed.
Lemma mean_in_v : ex_RInt (fun v => error_along_v (INR k) epsilon v ^ 2) 0 1.
Proof.
  set (up v := (1 + epsilon + v - Rabs (1 - epsilon - v)) / 2). set (down v := (v - epsilon + Rabs (v - epsilon)) / 2).
  assert (U : forall v, central_ridges.v_plus v epsilon = up v) by (intro v; unfold up, central_ridges.v_plus, Rmin, Rabs; destruct Rle_dec, Rcase_abs; lra).
  assert (D : forall v, central_ridges.v_minus v epsilon = down v) by (intro v; unfold down, central_ridges.v_minus, Rmax, Rabs; destruct Rle_dec, Rcase_abs; lra).
  assert (S : forall v, 0 < v < 1 -> central_ridges.span_v v epsilon = up v - down v) by (intros v V; unfold central_ridges.span_v; rewrite U, D; unfold up, down, Rabs; destruct both as [[]|[]]; repeat destruct Rcase_abs; lra).
  generalize reach_is. intros [R1 R2].
  apply (square_has_a_mean k _ (fun v => (Rabs (sin (PI * (INR k * up v))) - Rabs (sin (PI * (INR k * down v)))) * / (up v - down v)) K).
  - intros x X. assert (up x - down x <> 0) by (apply Rgt_not_eq; unfold up, down, Rabs; repeat destruct Rcase_abs; lra). unfold up, down in *. reg.
  - intros v V. unfold error_along_v, central_ridges.h_v, central_ridges.h_v_plus, central_ridges.h_v_minus. unfold_fields.
    rewrite U, D, S, !Rabs_mult, sine_of_a_right_angle, Rabs_R1, !Rmult_1_l, !Rmult_1_r by exact V. unfold Rdiv. ring.
Qed.
End chart.


(* Over all of the chart the error is the tents' up to 2/3 pi k (pi k eps)^2, times the other factor. *)
Lemma times_a_sine (x y s b : R) : Rabs (x - y) <= b -> Rabs (x * Rabs (sin s) - y * Rabs (sin s)) <= b.
Proof.
  intro H. rewrite <- Rmult_minus_distr_r, Rabs_mult, Rabs_Rabsolu. generalize (sine_at_most_1 s) (Rabs_pos (x - y)) (Rabs_pos (sin s)). nra.
Qed.
Theorem crease_error_area__near_the_tents (k : nat) (epsilon u v w : R) : (0 < k)%nat -> 0 < epsilon <= / (2 * INR k) ->
  Rabs (central_ridges.h_u u w (INR k) v epsilon - gradient_ridges.h_u u w (INR k) v - tents (INR k) epsilon u * Rabs (sin (PI * (v * w)))) <= room (INR k) epsilon /\
  (0 < v < 1 -> Rabs (central_ridges.h_v u v w (INR k) epsilon - gradient_ridges.h_v u v w (INR k) - inner k epsilon v * Rabs (sin (PI * (w * u)))) <= room (INR k) epsilon).
Proof.
  intros K E. split; [|intro V]; rewrite ?factor_of_u, ?factor_of_v; apply times_a_sine; [apply near_tents_in_u | apply near_tents_in_v]; assumption.
Qed.
Theorem crease_error_area__near_the_tents__point : exists (k : nat) (epsilon v : R), (0 < k)%nat /\ 0 < epsilon <= / (2 * INR k) /\ 0 < v < 1.
Proof. exists 1%nat, (1/2), (1/2). simpl. repeat split; try lra. lia. Qed.
(* It is not that small without the tents. *)
Theorem crease_error_area__near_the_tents__false : ~ forall epsilon u, 0 < epsilon <= / (2 * INR 1) -> Rabs (central_ridges.h_u u (1/2) (INR 1) 1 epsilon - gradient_ridges.h_u u (1/2) (INR 1) 1) <= room (INR 1) epsilon.
Proof.
  intro H. generalize (H (1/8) (1/16) ltac:(simpl; lra)). simpl INR. rewrite (error_in_u _ _ _ _ 1) by lra. rewrite sine_of_a_right_angle, Rabs_R1, (nearest_is 1 (1/16) 0) by lra.
  unfold of_a_hump, room. rewrite sign_eq_1 by lra. apply Rlt_not_le. interval.
Qed.

(* There are k tents in u and k - 1 in v, none over another: these are the areas of their squares, of eps/3 to either side. *)
Theorem crease_error_area__of_all_tents (k : nat) (epsilon : R) : (0 < k)%nat -> 0 < epsilon <= / (2 * INR k) -> let area := (PI * INR k) ^ 2 * (epsilon / 3) in
  is_RInt (fun u => tents (INR k) epsilon u ^ 2) 0 1 (INR k * (2 * area)) /\ is_RInt (fun v => inner k epsilon v ^ 2) 0 1 ((INR k - 1) * (2 * area)).
Proof. intros K E. split; [apply tents_in_u | apply tents_in_v]; assumption. Qed.
Theorem crease_error_area__of_all_tents__point : exists (k : nat) (epsilon : R), (0 < k)%nat /\ 0 < epsilon <= / (2 * INR k).
Proof. exists 1%nat, (1/2). simpl. split; [lia | lra]. Qed.
Theorem crease_error_area__of_all_tents__false : ~ forall k epsilon, (0 < k)%nat -> 0 < epsilon <= / (2 * INR k) -> is_RInt (fun v => inner k epsilon v ^ 2) 0 1 (INR k * (2 * ((PI * INR k) ^ 2 * (epsilon / 3)))).
Proof.
  intro H. assert (E : 0 < 1/2 <= / (2 * INR 1)) by (simpl; lra). generalize (is_RInt_unique _ _ _ _ (H 1%nat (1/2) ltac:(lia) E)).
  rewrite (is_RInt_unique _ _ _ _ (proj2 (crease_error_area__of_all_tents 1 (1/2) ltac:(lia) E))). change (INR 1) with 1. assert (0 < PI ^ 2) by (apply pow_lt, PI_RGT_0). lra.
Qed.

(* So the root mean squares of the printed errors over the chart are pi k_u sqrt(k_u eps/3) and pi k_v sqrt((k_v - 1) eps/3), up to as much. *)
Lemma mean_of_a_sine (k : nat) : (0 < k)%nat -> is_RInt (fun v => Rabs (sin (PI * (INR k * v))) ^ 2) 0 1 (1/2).
Proof.
  intro K. assert (Q : 0 < INR k) by (apply lt_0_INR; exact K). generalize PI_RGT_0. intro P. apply (is_RInt_ext (fun v => sin (PI * (INR k * v)) ^ 2)); [intros; symmetry; apply pow2_abs|].
  replace (1/2) with (minus (1 / 2 - sin (2 * (PI * (INR k * 1))) / (4 * PI * INR k)) (0 / 2 - sin (2 * (PI * (INR k * 0))) / (4 * PI * INR k))).
  - apply (is_RInt_derive (fun v => v / 2 - sin (2 * (PI * (INR k * v))) / (4 * PI * INR k))).
    + intros x _. auto_derive; trivial. rewrite cos_2a_sin. field. split; lra.
    + intros x _. apply (ex_derive_continuous (fun v => sin (PI * (INR k * v)) ^ 2)). auto_derive. trivial.
  - rewrite !Rmult_0_r, sin_0. replace (2 * (PI * (INR k * 1))) with (0 + 2 * INR k * PI) by ring. rewrite sin_period, sin_0. unfold minus, plus, opp. simpl. field. split; lra.
Qed.
Lemma root_of_areas (k : nat) (n epsilon : R) : 0 <= n -> 0 < epsilon -> sqrt (n * (2 * ((PI * INR k) ^ 2 * (epsilon / 3))) / 2) = PI * INR k * sqrt (n * epsilon / 3).
Proof.
  intros N E. generalize PI_RGT_0 (pos_INR k). intros P Q. replace (n * (2 * ((PI * INR k) ^ 2 * (epsilon / 3))) / 2) with ((PI * INR k) ^ 2 * (n * epsilon / 3)) by field.
  rewrite sqrt_mult by (try apply pow2_ge_0; assert (0 <= n * epsilon) by (apply Rmult_le_pos; lra); lra). rewrite sqrt_pow2 by nra. reflexivity.
Qed.
Lemma some_room (k : nat) (epsilon : R) : (0 < k)%nat -> 0 < epsilon -> 0 < room (INR k) epsilon.
Proof. intros K E. assert (0 < PI * INR k) by (apply Rmult_lt_0_compat; [apply PI_RGT_0 | apply lt_0_INR, K]). unfold room. apply Rmult_lt_0_compat; [lra | apply pow_lt, Rmult_lt_0_compat; assumption]. Qed.
Theorem crease_error_area__root_mean_squares (k_u k_v : nat) (epsilon : R) : (0 < k_u)%nat -> (0 < k_v)%nat ->
  (0 < epsilon <= / (2 * INR k_u) -> exists (means : R -> R) (mean : R),
    (forall v, is_RInt (fun u => (central_ridges.h_u u v (INR k_u) (INR k_v) epsilon - gradient_ridges.h_u u v (INR k_u) (INR k_v)) ^ 2) 0 1 (means v)) /\ is_RInt means 0 1 mean /\
    Rabs (sqrt mean - PI * INR k_u * sqrt (INR k_u * epsilon / 3)) <= room (INR k_u) epsilon) /\
  (0 < epsilon <= / (2 * INR k_v) -> exists (means : R -> R) (mean : R),
    (forall u, is_RInt (fun v => (central_ridges.h_v u v (INR k_u) (INR k_v) epsilon - gradient_ridges.h_v u v (INR k_u) (INR k_v)) ^ 2) 0 1 (means u)) /\ is_RInt means 0 1 mean /\
    Rabs (sqrt mean - PI * INR k_v * sqrt ((INR k_v - 1) * epsilon / 3)) <= room (INR k_v) epsilon).
Proof.
  intros K L. split; intro E.
  - destruct (mean_in_u k_u epsilon K E) as [F I]. destruct (mean_squares _ _ _ _ _ _ I (tents_in_u k_u epsilon K E) (fun u _ => near_tents_in_u k_u epsilon K E u) (some_room k_u epsilon K (proj1 E)) (mean_of_a_sine k_v L)) as (A & B & C).
    eexists. eexists. split; [intro v; eapply is_RInt_ext; [|apply (A v)]; intros u _; cbv beta; rewrite factor_of_u; reflexivity | split; [exact B|]].
    rewrite <- root_of_areas by (apply pos_INR || lra). exact C.
  - destruct (mean_in_v k_v epsilon L E) as [F I]. destruct (mean_squares _ _ _ _ _ _ I (tents_in_v k_v epsilon L E) (near_tents_in_v k_v epsilon L E) (some_room k_v epsilon L (proj1 E)) (mean_of_a_sine k_u K)) as (A & B & C).
    eexists. eexists. split; [intro u; eapply is_RInt_ext; [|apply (A u)]; intros v _; cbv beta; rewrite factor_of_v; reflexivity | split; [exact B|]].
    assert (1 <= INR k_v) by (apply (le_INR 1); lia). rewrite <- root_of_areas by lra. exact C.
Qed.
Theorem crease_error_area__root_mean_squares__point : exists (k_u k_v : nat) (epsilon : R), (0 < k_u)%nat /\ (0 < k_v)%nat /\ 0 < epsilon <= / (2 * INR k_u) /\ 0 < epsilon <= / (2 * INR k_v).
Proof. exists 1%nat, 1%nat, (1/2). simpl. repeat split; try lra; lia. Qed.
(* One tent fewer than k_v: where there is none, the error is much less. *)
Theorem crease_error_area__root_mean_squares__false : ~ forall (k_u k_v : nat) (epsilon : R), 0 < epsilon <= / (2 * INR k_v) -> exists (means : R -> R) (mean : R),
  (forall u, is_RInt (fun v => (central_ridges.h_v u v (INR k_u) (INR k_v) epsilon - gradient_ridges.h_v u v (INR k_u) (INR k_v)) ^ 2) 0 1 (means u)) /\ is_RInt means 0 1 mean /\
  Rabs (sqrt mean - PI * INR k_v * sqrt (INR k_v * epsilon / 3)) <= room (INR k_v) epsilon.
Proof.
  intro H. assert (E : 0 < 1/100 <= / (2 * INR 1)) by (simpl; lra). destruct (H 1%nat 1%nat (1/100) E) as (f & m & A & B & C). destruct (proj2 (crease_error_area__root_mean_squares 1 1 (1/100) ltac:(lia) ltac:(lia)) E) as (f' & m' & A' & B' & C').
  assert (F : forall u, f u = f' u) by (intro u; rewrite <- (is_RInt_unique _ _ _ _ (A u)); exact (is_RInt_unique _ _ _ _ (A' u))).
  assert (M : m = m') by (rewrite <- (is_RInt_unique _ _ _ _ B); apply is_RInt_unique; revert B'; apply is_RInt_ext; intros; symmetry; apply F).
  rewrite M in C. unfold room in C, C'. simpl (INR 1) in C, C'. replace ((1 - 1) * (1/100) / 3) with 0 in C' by field. rewrite sqrt_0 in C'. apply Rabs_le_between in C. apply Rabs_le_between in C'.
  assert (PI * 1 * sqrt (1 * (1/100) / 3) > 4 / 3 * (PI * 1) * (PI * 1 * (1/100)) ^ 2) by interval. lra.
Qed.
