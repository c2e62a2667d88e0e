(* The tents of the error beside the creases: where they stand, their areas, and the root mean squares over the chart. *)

From Coq Require Import Reals Lra Lia ZArith.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Camera Preliminaries Formulas Fields Claim Derivatives Clamped Creases CreaseError.
Open Scope R_scope.

(* The tent beside a crease at the distance d, and the tents of all creases m/k: of the nearest one. *)
Definition tent (k epsilon d : R) := if Rlt_dec (Rabs d) epsilon then sign d * (PI * k * (Rabs d / epsilon - 1)) else 0.
Definition nearest (k x : R) := IZR (Int_part (k * x + 1 / 2)) / k.
Lemma nearest_is k x m : 0 < k -> IZR m / k - / (2 * k) <= x < IZR m / k + / (2 * k) -> nearest k x = IZR m / k.
Proof.
  intros. unfold nearest. rewrite (floor_is m); auto. assert (IZR m = k * (IZR m / k)) by (field; lra). assert (k * / (2 * k) = 1 / 2) by (field;
    lra). nra.
Qed.
Lemma near_the_nearest k x : 0 < k -> exists m : Z, nearest k x = IZR m / k /\ - / (2 * k) <= x - IZR m / k <= / (2 * k).
Proof.
  intro K. exists (Int_part (k * x + 1 / 2)). split; auto. destruct (base_Int_part (k * x + 1 / 2)). set (i := IZR (Int_part _)) in *.
  assert (I : 0 < / k) by (apply Rinv_0_lt_compat, K). rewrite Rinv_mult. replace (_ - _) with ((k * x - i) * / k) by (field; lra). nra.
Qed.

(* Of a half-wave |sin pi k d| the difference is the slope and the tent, up to 2/3 pi k (pi k eps)^2. *)
Definition of_a_hump (k epsilon d : R) := (Rabs (sin (PI * (k * (d + epsilon)))) - Rabs (sin (PI * (k * (d - epsilon))))) / (2 * epsilon) - sign d
  * PI * k * cos (PI * (k * d)).
Definition room (k epsilon : R) := 2 / 3 * (PI * k) * (PI * k * epsilon) ^ 2.
Lemma some_room k epsilon : 0 < k -> 0 < epsilon -> 0 < room k epsilon.
Proof. intros K E. assert (0 < PI * k) by (apply Rmult_lt_0_compat; [apply PI_RGT_0 | lra]). apply Rmult_lt_0_compat; [lra | apply pow_lt,
  Rmult_lt_0_compat; assumption]. Qed.
Lemma sine_over x : 0 < x -> Rabs (sin x / x - 1) <= x ^ 2 / 6.
Proof. intro X. assert (x * (sin x / x) = sin x) by (field; lra). generalize (cubic_below x). intro. apply Rabs_le. nra. Qed.
Lemma hump_after k epsilon d : 0 < k -> 0 < epsilon <= / (2 * k) -> 0 < d <= / (2 * k) -> Rabs (of_a_hump k epsilon d - tent k epsilon d) <= room
  k epsilon.
Proof.
  intros K E D. generalize PI_RGT_0. intro P. assert (I : k * / (2 * k) = 1 / 2) by (field; lra). assert (Q : 0 < PI * k) by nra.
  unfold of_a_hump, tent, room. rewrite sign_eq_1, (Rabs_pos_eq d), Rmult_plus_distr_l, Rmult_minus_distr_l, Rmult_plus_distr_l, Rmult_minus_distr_l,
    Rmult_1_l by lra.
  set (x := PI * (k * epsilon)). set (y := PI * (k * d)). assert (B : forall t, 0 < t <= / (2 * k) -> 0 < PI * (k * t) <= PI / 2) by (intros t T;
    assert (0 < k * t <= 1 / 2) by nra; nra).
  assert (X : 0 < x <= PI / 2) by apply B, E. assert (Y : 0 < y <= PI / 2) by (apply B, D). rewrite (Rabs_pos_eq (sin (y + x))) by (apply sin_ge_0;
    lra).
  replace (PI * k * epsilon) with x by (unfold x; ring). assert (M : forall q, Rabs q <= 2 / 3 * x ^ 2 -> Rabs (PI * k * q) <= 2 / 3 * (PI * k) * x ^
    2) by (intros q H; rewrite Rabs_mult, Rabs_pos_eq by lra; nra).
  destruct Rlt_dec.
  - assert (y < x) by (apply Rmult_lt_compat_l, Rmult_lt_compat_l; lra). rewrite (Rabs_left1 (sin _)) by (generalize (sin_ge_0 (x - y)); rewrite <-
    Ropp_minus_distr, sin_neg; lra).
    replace (_ - _) with (PI * k * (sin y * cos x / x - cos y - (y / x - 1))) by (rewrite sin_plus, sin_minus; unfold x, y; field; lra). apply M,
      beside_the_tent; [lra | apply sin_ge_0; lra].
  - assert (x <= y) by (apply Rmult_le_compat_l, Rmult_le_compat_l; lra). rewrite (Rabs_pos_eq (sin _)) by (apply sin_ge_0; lra).
    replace (_ - _) with (PI * k * (cos y * (sin x / x - 1))) by (rewrite sin_plus, sin_minus; unfold x; field; lra). apply M. rewrite Rabs_mult.
    generalize (sine_over x (proj1 X)) (Rabs_pos (sin x / x - 1)) (cosine_at_most_1 y). nra.
Qed.
Lemma hump_beside k epsilon d : 0 < k -> 0 < epsilon <= / (2 * k) -> - / (2 * k) <= d <= / (2 * k) -> Rabs (of_a_hump k epsilon d - tent k epsilon
  d) <= room k epsilon.
Proof.
  intros. assert (S : of_a_hump k epsilon (- d) - tent k epsilon (- d) = - (of_a_hump k epsilon d - tent k epsilon d)).
  { unfold of_a_hump, tent. rewrite sign_opp. replace (_ + _) with (- (d - epsilon)) by ring. replace (- d - epsilon) with (- (d + epsilon)) by ring.
    rewrite !Ropp_mult_distr_r_reverse, !sin_neg, !Rabs_Ropp, cos_neg. destruct Rlt_dec; unfold Rdiv; ring. }
  destruct (Rtotal_order d 0) as [L|[->|L]]; [rewrite <- Rabs_Ropp, <- S; apply hump_after; lra | | apply hump_after; lra].
  rewrite Ropp_0 in S. replace (_ - _) with 0 by lra. rewrite Rabs_R0. left. apply some_room; lra.
Qed.

(* The error of a half-wave's difference, by the nearest crease. *)
Definition error_along_u (k epsilon x : R) := (Rabs (sin (PI * (k * (x + epsilon)))) - Rabs (sin (PI * (k * (x - epsilon))))) / (2 * epsilon) -
  slope_of_wave k x.
Lemma error_beside k epsilon x m : 0 < k -> - / (2 * k) <= x - IZR m / k <= / (2 * k) -> error_along_u k epsilon x = of_a_hump k epsilon (x - IZR
  m / k).
Proof.
  intros K D. set (d := x - IZR m / k) in *. replace x with (d + IZR m / k) by (unfold d; ring). assert (1 / k = / (2 * k) + / (2 * k)) by (field;
    lra). assert (0 < / (2 * k)) by (apply Rinv_0_lt_compat; lra).
  unfold error_along_u, of_a_hump. rewrite (Rplus_comm d), slope_beside by (exact K || apply Rabs_def1; lra). replace (_ + _) with (d + epsilon + IZR
    m / k) by ring. replace (IZR m / k + d - epsilon) with (d - epsilon + IZR m / k) by ring.
  rewrite !beyond_a_crease by (apply sine_of_whole || lra). same_angles. reflexivity.
Qed.
(* In v, where it may be clamped. *)
Definition error_along_v (k epsilon v : R) := clamped (fun v => Rabs (sin (PI * (k * v)))) v epsilon - slope_of_wave k v.
Lemma not_clamped k epsilon v : 0 < epsilon -> 0 <= v - epsilon -> v + epsilon <= 1 -> error_along_v k epsilon v = error_along_u k epsilon v.
Proof.
  intros E A B. unfold error_along_v, clamped. central_sine.lines. destruct both as [_|[H|H]]; [|lra|lra]. rewrite Rmin_right, Rmax_left, Rplus_comm
    by lra. reflexivity.
Qed.

(* Clamped at a pole the difference is as good; the upper pole is the lower one, seen from there. *)
Lemma error_at_the_pole k epsilon v : 0 < k -> 0 < epsilon <= / (2 * k) -> epsilon <= 1 / 2 -> 0 < v < epsilon -> Rabs (error_along_v k epsilon v)
  <= room k epsilon.
Proof.
  intros. pose proof PI_RGT_0. assert (k * / (2 * k) = 1 / 2) by (field; lra).
  eapply Rle_trans; [apply (of_an_odd_sine 1 k); try lra; [rewrite Rabs_R1; lra | intros; rewrite Rmult_1_l; apply Rabs_pos_eq, sine_on_a_hump;
    nra|]|].
  - unfold slope_of_wave. rewrite sign_eq_1; [ring|]. assert (0 < k * v) by nra. assert (k * v < 1) by nra. apply sin_gt_0; nra.
  - unfold room. replace (2 / 3 * _ * _ ^ 2) with (2 / 3 * epsilon ^ 2 * (PI * k) ^ 3) by ring. apply Rmult_le_compat_r; [apply pow_le; nra | nra].
Qed.
Lemma seen_from_the_other_pole k epsilon v : error_along_v (IZR k) epsilon (1 - v) = - error_along_v (IZR k) epsilon v.
Proof.
  assert (S : forall w, Rabs (sin (PI * (IZR k * (1 - w)))) = Rabs (sin (PI * (IZR k * w)))).
  { intro w. replace (PI * _) with (PI * IZR k + - (PI * (IZR k * w))) by ring. rewrite sine_of_a_shift, sin_neg. apply Rabs_Ropp. }
  assert (A : central_sine.v_plus (1 - v) epsilon = 1 - central_sine.v_minus v epsilon /\ central_sine.v_minus (1 - v) epsilon = 1 -
    central_sine.v_plus v epsilon) by (central_sine.lines; unfold Rmin, Rmax; repeat destruct Rle_dec; lra). destruct A as [A B].
  assert (D : central_sine.span_v (1 - v) epsilon = central_sine.span_v v epsilon) by (unfold central_sine.span_v; destruct both as [[]|[]], both as
    [[]|[]]; lra).
  unfold error_along_v, clamped, slope_of_wave. rewrite A, B, D, !S. replace (PI * (IZR k * (1 - v))) with (- (PI * (IZR k * v)) + PI * IZR k) by
    ring. rewrite sin_plus, cos_plus, sin_neg, cos_neg, sine_of_whole, !Rmult_0_r, Rplus_0_r, sign_mult, sign_opp.
  destruct (cosine_of_whole k) as [-> | ->]; [rewrite (sign_eq_1 1) by lra | rewrite (sign_eq_m1 (- (1))) by lra]; unfold Rdiv; ring.
Qed.

(* The mean square of the error is there: it is continuous between creases. *)
Lemma square_has_a_mean (k : nat) (f C : R -> R) : (0 < k)%nat -> (forall x, 0 <= x <= 1 -> continuity_pt C x) -> (forall x, 0 < x < 1 -> f x = C x -
  slope_of_wave (INR k) x) -> ex_RInt (fun x => f x ^ 2) 0 1.
Proof.
  intros K Cc F. assert (P : 0 < INR k) by apply lt_0_INR, K. assert (I : forall j, (j <= k)%nat -> ex_RInt (fun x => f x ^ 2) 0 (INR j / INR k)).
  { induction j as [|j IH]; intro J; [simpl; unfold Rdiv; rewrite Rmult_0_l; apply ex_RInt_point|]. apply ex_RInt_Chasles with (INR j / INR k);
    [apply IH; lia|].
    assert (B : 0 <= INR j /\ INR j + 1 <= INR k) by (split; [apply pos_INR | rewrite <- S_INR; apply le_INR, J]). rewrite S_INR.
    assert (A1 : INR k * (INR j / INR k) = INR j) by (field; lra). assert (A2 : (INR j + 1) / INR k = INR j / INR k + 1 / INR k) by (field; lra).
      assert (A3 : 0 < 1 / INR k /\ INR k * (1 / INR k) = 1) by (split; [apply Rdiv_lt_0_compat | field]; lra).
    rewrite A2. set (a := INR j / INR k) in *. set (b := 1 / INR k) in *. assert (0 <= a /\ a + b <= 1) by nra.
    apply (ex_RInt_ext (fun x => (C x - PI * INR k * cos (PI * (INR k * (x - a)))) ^ 2)).
    - rewrite Rmin_left, Rmax_right by lra. intros x X. rewrite F by lra. replace x with (IZR (Z.of_nat j) / INR k + (x - a)) at 4 by (rewrite <-
      INR_IZR_INZ; unfold a; ring).
      rewrite slope_beside, sign_eq_1 by first [apply Rabs_def1; unfold b in *; lra | lra]. f_equal. ring.
    - apply (ex_RInt_continuous (V := R_CompleteNormedModule)). rewrite Rmin_left, Rmax_right by lra. intros x X. apply continuity_pt_filterlim.
      assert (continuity_pt C x) by (apply Cc; lra). reg. }
  specialize (I k (le_n k)). replace (_ / _) with 1 in I by (field; lra). exact I.
Qed.

(* Of two functions that are at most b apart, the roots of half the mean squares are. *)
Lemma mean_at_most (f g : R -> R) (F G b : R) : is_RInt (fun x => f x ^ 2) 0 1 F -> is_RInt (fun x => g x ^ 2) 0 1 G -> (forall x, 0 < x < 1 -> Rabs
  (f x - g x) <= b) -> 0 < b -> sqrt (F / 2) <= sqrt (G / 2) + b.
Proof.
  intros IF IG D B. assert (0 <= G) by exact (is_RInt_ge_0 _ 0 1 G Rle_0_1 IG (fun x _ => pow2_ge_0 _)). generalize (sqrt_pos (G / 2)) (pow2_sqrt (G
    / 2)). set (s := sqrt _). intros.
  set (p := s + b). set (i := / p). assert (P : i * p = 1) by (apply Rinv_l; unfold p; lra). assert (0 < i) by (apply Rinv_0_lt_compat; unfold p;
    lra).
  pose proof is_RInt_le _ _ 0 1 _ _ Rle_0_1 IF (is_RInt_plus _ _ _ _ _ _ (is_RInt_scal _ _ _ (1 + b * i) _ IG) (is_RInt_const 0 1 (b * p + b ^ 2)))
    as J.
  unfold plus, scal in J. simpl in J. unfold mult in J. simpl in J. rewrite <- sqrt_pow2 by nra. apply sqrt_le_1_alt. lapply J.
  - replace G with (2 * s ^ 2) by lra. assert (0 <= b * s) by nra. assert (i * s <= 1) by (unfold p in P; nra). assert (b * i * (2 * s ^ 2) <= 2 * b
    * s) by nra. unfold p. lra.
  - intros x X. generalize (D x X). intro Y. apply Rabs_le_between in Y. change (f x ^ 2 <= (1 + b * i) * g x ^ 2 + (b * p + b ^ 2)). rewrite <-
    pow2_abs, <- (pow2_abs (g x)).
    replace (_ + _) with ((Rabs (g x) + b) ^ 2 + b * i * (Rabs (g x) - p) ^ 2) by ring [P]. rewrite <- (Rplus_0_r _).
    apply Rplus_le_compat; [apply pow_incr; unfold Rabs; repeat destruct Rcase_abs; lra | apply Rmult_le_pos; [nra | apply pow2_ge_0]].
Qed.

(* The printed errors are those along u and along v, times the size of the other factor. *)
Lemma factor_of_u u v k_u k_v epsilon : (exists n, k_u = IZR n) -> central_ridges.h_u u v k_u k_v epsilon - gradient_ridges.h_u u v k_u k_v =
  error_along_u k_u epsilon u * Rabs (sin (PI * (k_v * v))).
Proof.
  intro K. rewrite (proj1 (slope_factors _ _ _ _)). unfold error_along_u; central_ridges.lines. rewrite !Rabs_mult, !wrapped, Rplus_comm by auto.
    unfold Rdiv. rewrite Rinv_mult. lra.
Qed.
Lemma factor_of_v u v k_u k_v epsilon : central_ridges.h_v u v k_u k_v epsilon - gradient_ridges.h_v u v k_u k_v = error_along_v k_v epsilon v *
  Rabs (sin (PI * (k_u * u))).
Proof.
  destruct (clamped_difference__of_the_fields u v k_u k_v epsilon) as (_ & -> & _). rewrite (proj2 (slope_factors _ _ _ _)). unfold error_along_v,
    clamped, height_ridges.h. rewrite !Rabs_mult. unfold Rdiv. ring.
Qed.

(* Areas: of a squared tent on either side of its crease, eps/3, *)
Lemma integral_is (f : R -> R) (a b l l' : R) : is_RInt f a b l -> l = l' -> is_RInt f a b l'.
Proof. intros H <-. exact H. Qed.
Lemma nothing (f : R -> R) (a b : R) : (forall x, Rmin a b < x < Rmax a b -> f x = 0) -> is_RInt f a b 0.
Proof.
  intro Z. apply (is_RInt_ext (fun _ => 0)); [symmetry; apply Z; assumption|]. eapply integral_is; [apply is_RInt_const | unfold scal; simpl; unfold
    mult; simpl; ring].
Qed.
Lemma side_of_a_tent (k epsilon c h s : R) : 0 < epsilon <= h -> s = 1 \/ s = -1 -> is_RInt (fun x => tent k epsilon (x - c) ^ 2) c (c + s * h) (s *
  ((PI * k) ^ 2 * (epsilon / 3))).
Proof.
  intros E S. eapply integral_is; [apply (is_RInt_Chasles _ c (c + s * epsilon)); [eapply is_RInt_ext; [|apply (is_RInt_derive (fun x => (PI * k) ^ 2
    * s * (s * (x - c) - epsilon) ^ 3 / (3 * epsilon ^ 2)) (fun x => (PI * k) ^ 2 * (s * (x - c) / epsilon - 1) ^ 2))] | apply nothing]|].
  - intros x X. unfold tent. unfold Rmin, Rmax in X. destruct S as [-> | ->]; cases; lra.
  - intros x _. auto_derive; trivial. destruct S as [-> | ->]; field; lra.
  - intros x _. apply (ex_derive_continuous (fun x => _ ^ 2 * _ ^ 2)). auto_derive. trivial.
  - intros x X. unfold tent. unfold Rmin, Rmax in X. destruct S as [-> | ->]; cases; lra.
  - unfold minus, plus, opp. simpl. destruct S as [-> | ->]; field; lra.
Qed.
(* and of those over the chart: one hump each, without overlap, around the creases between whose middles it lies. *)
Definition tents (k epsilon x : R) := tent k epsilon (x - nearest k x).
Section areas.
Variables (k : nat) (epsilon : R).
Hypotheses (K : (0 < k)%nat) (E : 0 < epsilon <= / (2 * INR k)).
Let k_pos : 0 < INR k := lt_0_INR k K.
Let h := / (2 * INR k).
Lemma reach_is : INR k * h = 1 / 2 /\ 0 < h <= 1 / 2 /\ epsilon <= h.
Proof.
  assert (1 <= INR k) by apply (le_INR 1), K. assert (INR k * h = 1 / 2) by (unfold h; field; lra).
  assert (0 < h) by nra. repeat split; trivial; [nra | apply E].
Qed.
Let area := (PI * INR k) ^ 2 * (epsilon / 3).
Lemma halves (m : nat) (s : R) : s = 1 \/ s = -1 -> is_RInt (fun x => tents (INR k) epsilon x ^ 2) (INR m / INR k) (INR m / INR k + s * h) (s * area).
Proof.
  intro S. generalize k_pos. intro P. eapply is_RInt_ext; [|apply side_of_a_tent; auto]. intros x X.
  unfold tents. rewrite INR_IZR_INZ with (n := m) in *. rewrite (nearest_is _ x (Z.of_nat m)); auto. unfold Rmin, Rmax, h in X.
    destruct S as [-> | ->]; cases; lra.
Qed.
Lemma inner_tents (n : nat) : is_RInt (fun x => tents (INR k) epsilon x ^ 2) h ((2 * INR n + 1) * h) (INR n * (2 * area)).
Proof.
  induction n as [|n IH].
  - simpl. replace (_ * _) with h by ring. eapply integral_is; [apply is_RInt_point | unfold zero; simpl; ring].
  - generalize (halves (S n) 1 ltac:(auto)) (is_RInt_swap _ _ _ _ (halves (S n) _ ltac:(auto))). rewrite S_INR. replace (_ / INR k + -1 * h) with ((2
    * INR n + 1) * h) by (unfold h; field; lra).
    replace (_ / INR k + 1 * h) with ((2 * (INR n + 1) + 1) * h) by (unfold h; field; lra). intros A B.
    eapply integral_is; [apply (is_RInt_Chasles _ _ _ _ _ _ IH (is_RInt_Chasles _ _ _ _ _ _ B A))|]. unfold plus, opp. simpl. ring.
Qed.
Lemma tents_in_u : is_RInt (fun x => tents (INR k) epsilon x ^ 2) 0 1 (INR k * (2 * area)).
Proof.
  generalize (halves 0 1 ltac:(auto)) (is_RInt_swap _ _ _ _ (halves k _ ltac:(auto))) (inner_tents (k - 1)). rewrite minus_INR by lia. simpl (INR 0).
    simpl (INR 1).
  replace (_ + _) with h by lra. replace (_ / _) with 0 by lra. replace (_ / _) with 1 by (field; lra).
    replace ((2 * _ + 1) * h) with (1 + -1 * h) by (unfold h; field; lra). intros A B C.
  eapply integral_is; [apply (is_RInt_Chasles _ _ _ _ _ _ A (is_RInt_Chasles _ _ _ _ _ _ C B))|]. unfold plus, opp. simpl. ring.
Qed.
Definition inner (x : R) := if both (Rlt_dec h x) (Rlt_dec x (1 - h)) then tents (INR k) epsilon x else 0.
Lemma tents_in_v : is_RInt (fun x => inner x ^ 2) 0 1 ((INR k - 1) * (2 * area)).
Proof.
  generalize reach_is. intros []. generalize (inner_tents (k - 1)). rewrite minus_INR by lia. simpl (INR 1). replace (_ * _) with (1 - h) by lra.
    intro C.
  eapply integral_is; [apply (is_RInt_Chasles _ 0 h); [|apply (is_RInt_Chasles _ h (1 - h)); [eapply is_RInt_ext; [|exact C]|]]|].
  1, 3: apply nothing. 1, 2, 3: rewrite Rmin_left, Rmax_right by lra; intros; unfold inner; destruct both; lra.
  unfold plus. simpl. ring.
Qed.

Lemma near_tents_in_u u : Rabs (error_along_u (INR k) epsilon u - tents (INR k) epsilon u) <= room (INR k) epsilon.
Proof.
  generalize k_pos. intro P. unfold tents. destruct (near_the_nearest _ u P) as (m & -> & D). rewrite (error_beside _ _ _ m) by assumption. apply
    hump_beside; lra.
Qed.
Lemma near_the_pole v : 0 < v <= h -> Rabs (error_along_v (INR k) epsilon v) <= room (INR k) epsilon.
Proof.
  generalize k_pos reach_is. unfold h. intros P [] V. destruct (Rlt_le_dec v epsilon); [apply error_at_the_pole; lra|].
  assert (Z : v - 0 / INR k = v) by lra. rewrite not_clamped, (error_beside _ _ v 0), Z by lra. rewrite <- (Rminus_0_r (of_a_hump _ _ _)).
    replace 0 with (tent (INR k) epsilon v); [apply hump_after; lra|].
  unfold tent. rewrite Rabs_pos_eq by lra. destruct Rlt_dec; lra.
Qed.
Lemma near_tents_in_v v : 0 < v < 1 -> Rabs (error_along_v (INR k) epsilon v - inner v) <= room (INR k) epsilon.
Proof.
  generalize reach_is. intros [] V. unfold inner. destruct both as [[]|[A|A]]; [rewrite not_clamped by lra; apply near_tents_in_u | rewrite
    Rminus_0_r; apply near_the_pole; lra |].
  rewrite Rminus_0_r, <- Rabs_Ropp, INR_IZR_INZ, <- seen_from_the_other_pole, <- INR_IZR_INZ. apply near_the_pole. lra.
Qed.
Lemma mean_in_u : ex_RInt (fun u => error_along_u (INR k) epsilon u ^ 2) 0 1.
Proof.
  apply (square_has_a_mean k _ (fun u => (Rabs (sin (PI * (INR k * (u + epsilon)))) - Rabs (sin (PI * (INR k * (u - epsilon))))) * / (2 * epsilon)));
    auto. intros x _. reg.
Qed.
Lemma mean_in_v : ex_RInt (fun v => error_along_v (INR k) epsilon v ^ 2) 0 1.
Proof.
  set (up v := (1 + epsilon + v - Rabs (1 - epsilon - v)) / 2). set (down v := (v - epsilon + Rabs (v - epsilon)) / 2).
  assert (U : forall v, central_sine.v_plus v epsilon = up v) by (intro v; unfold up, central_sine.v_plus, Rmin, Rabs; destruct Rle_dec, Rcase_abs;
    lra).
  assert (D : forall v, central_sine.v_minus v epsilon = down v) by (intro v; unfold down, central_sine.v_minus, Rmax, Rabs; destruct Rle_dec,
    Rcase_abs; lra).
  assert (S : forall v, 0 < v < 1 -> central_sine.span_v v epsilon = up v - down v) by (intros v V; unfold central_sine.span_v; rewrite U, D; unfold
    up, down, Rabs; destruct both; repeat destruct Rcase_abs; lra).
  generalize reach_is. unfold h. intros [R1 R2].
  apply (square_has_a_mean k _ (fun v => (Rabs (sin (PI * (INR k * up v))) - Rabs (sin (PI * (INR k * down v)))) * / (up v - down v)) K).
  - intros x X. assert (up x - down x <> 0) by (unfold up, down, Rabs; repeat destruct Rcase_abs; lra). unfold up, down. reg.
  - intros v V. unfold error_along_v, clamped. rewrite U, D, S by lra. reflexivity.
Qed.
End areas.

(* Over all of the chart the error is the tents' up to 2/3 pi k (pi k eps)^2, times the other factor. *)
Lemma times_a_sine x y s b : Rabs (x - y) <= b -> Rabs (x * Rabs (sin s) - y * Rabs (sin s)) <= b.
Proof. rewrite <- Rmult_minus_distr_r, Rabs_mult, Rabs_Rabsolu. generalize (sine_at_most_1 s) (Rabs_pos (x - y)) Rabs_pos. nra. Qed.
Theorem crease_error_area__near_the_tents k epsilon u v w : (0 < k)%nat -> 0 < epsilon <= / (2 * INR k) -> Rabs (central_ridges.h_u u w (INR k) v
  epsilon - gradient_ridges.h_u u w (INR k) v - tents (INR k) epsilon u * Rabs (sin (PI * (v * w)))) <= room (INR k) epsilon /\ (0 < v < 1 -> Rabs
  (central_ridges.h_v u v w (INR k) epsilon - gradient_ridges.h_v u v w (INR k) - inner k epsilon v * Rabs (sin (PI * (w * u)))) <= room (INR k)
  epsilon).
Proof.
  split; [| intro]; rewrite ?factor_of_v, ?factor_of_u by (exists (Z.of_nat k); apply INR_IZR_INZ); apply times_a_sine; [apply near_tents_in_u |
    apply near_tents_in_v]; assumption.
Qed.
Theorem crease_error_area__near_the_tents__point : exists k epsilon v, (0 < k)%nat /\ 0 < epsilon <= / (2 * INR k) /\ 0 < v < 1.
Proof. exists 1%nat, (1/2), (1/2). simpl. split; try lra. lia. Qed.
(* It is not that small without the tents. *)
Theorem crease_error_area__near_the_tents__false : ~ forall epsilon u, 0 < epsilon <= / (2 * INR 1) -> Rabs (central_ridges.h_u u (1/2) (INR 1) 1
  epsilon - gradient_ridges.h_u u (1/2) (INR 1) 1) <= room (INR 1) epsilon.
Proof.
  intro H. generalize (H (1/8) (1/16) ltac:(simpl; lra)). rewrite factor_of_u by (exists 1%Z; reflexivity). unfold error_along_u, slope_of_wave.
    rewrite half_sine, sign_eq_1 by interval. apply Rlt_not_le. interval.
Qed.

(* There are k tents in u and k - 1 in v, none over another: these are the areas of their squares, of eps/3 to either side. *)
Theorem crease_error_area__of_all_tents (k : nat) (epsilon : R) : (0 < k)%nat -> 0 < epsilon <= / (2 * INR k) -> let area := (PI * INR k) ^ 2 *
  (epsilon / 3) in
  is_RInt (fun u => tents (INR k) epsilon u ^ 2) 0 1 (INR k * (2 * area)) /\ is_RInt (fun v => inner k epsilon v ^ 2) 0 1 ((INR k - 1) * (2 * area)).
Proof. split; [apply tents_in_u | apply tents_in_v]; assumption. Qed.
Theorem crease_error_area__of_all_tents__point : exists k epsilon, (0 < k)%nat /\ 0 < epsilon <= / (2 * INR k).
Proof. exists 1%nat, (1/2). simpl. split; [lia | lra]. Qed.
Theorem crease_error_area__of_all_tents__false : ~ forall k epsilon, (0 < k)%nat -> 0 < epsilon <= / (2 * INR k) -> is_RInt (fun v => inner k epsilon
  v ^ 2) 0 1 (INR k * (2 * ((PI * INR k) ^ 2 * (epsilon / 3)))).
Proof.
  intro H. assert (E : 0 < 1/2 <= / (2 * INR 1)) by (simpl; lra). generalize (is_RInt_unique _ _ _ _ (H 1%nat _ ltac:(lia) E)).
  rewrite (is_RInt_unique _ _ _ _ (proj2 (crease_error_area__of_all_tents 1 _ ltac:(lia) E))). change (INR 1) with 1. assert (0 < PI ^ 2) by apply
    pow_lt, PI_RGT_0. lra.
Qed.

(* So the root mean squares of the printed errors over the chart are pi k_u sqrt(k_u eps/3) and pi k_v sqrt((k_v - 1) eps/3), up to as much. *)
Lemma mean_of_a_sine (k : nat) : (0 < k)%nat -> is_RInt (fun v => Rabs (sin (PI * (INR k * v))) ^ 2) 0 1 (1/2).
Proof.
  intro K. assert (Q : 0 < INR k) by (apply lt_0_INR; exact K). generalize PI_RGT_0. intro P. apply (is_RInt_ext (fun v => sin (PI * (INR k * v)) ^
    2)); [symmetry; apply pow2_abs|].
  replace (1/2) with (minus (1 / 2 - sin (2 * (PI * (INR k * 1))) / (4 * PI * INR k)) (0 / 2 - sin (2 * (PI * (INR k * 0))) / (4 * PI * INR k))).
  - apply (is_RInt_derive (fun v => v / 2 - sin (2 * (PI * (INR k * v))) / (4 * PI * INR k))).
    + intros x _. auto_derive; trivial. rewrite cos_2a_sin. field. split; lra.
    + intros x _. apply (ex_derive_continuous (fun v => sin (PI * (INR k * v)) ^ 2)). auto_derive. trivial.
  - rewrite !Rmult_0_r, sin_0. replace (2 * (PI * (INR k * 1))) with (0 + 2 * INR k * PI) by ring. rewrite sin_period, sin_0. unfold minus, plus, opp.
    simpl. field. split; lra.
Qed.
(* Of an error along x, beside tents, times a half-wave in y, whose mean square is 1/2. *)
Lemma root_mean_square (k k' : nat) (n epsilon : R) (along tent : R -> R) (error : R -> R -> R) : (0 < k)%nat -> (0 < k')%nat -> 0 < epsilon -> 0 <= n ->
  ex_RInt (fun x => along x ^ 2) 0 1 -> is_RInt (fun x => tent x ^ 2) 0 1 (n * (2 * ((PI * INR k) ^ 2 * (epsilon / 3)))) -> (forall x, 0 < x < 1 ->
    Rabs (along x - tent x) <= room (INR k) epsilon) ->
  (forall x y, error x y = along x * Rabs (sin (PI * (INR k' * y)))) -> exists (means : R -> R) (mean : R),
  (forall y, is_RInt (fun x => error x y ^ 2) 0 1 (means y)) /\ is_RInt means 0 1 mean /\ Rabs (sqrt mean - PI * INR k * sqrt (n * epsilon / 3)) <=
    room (INR k) epsilon.
Proof.
  intros K K' E N [F IF] IG D W. set (G := n * _) in IG. assert (P : 0 < INR k) by apply lt_0_INR, K. generalize PI_RGT_0. intro Q. set (w y := Rabs
    (sin (PI * (INR k' * y)))).
  exists (fun y => scal (w y ^ 2) F), (F * (1 / 2)). split; [|split].
  - intro y. eapply is_RInt_ext; [|apply (is_RInt_scal _ _ _ (w y ^ 2) _ IF)]. intros x _. rewrite W. unfold scal. simpl. unfold mult. simpl. fold (w
    y). ring.
  - eapply is_RInt_ext; [|apply (is_RInt_scal _ _ _ F _ (mean_of_a_sine k' K'))]. intros y _. apply Rmult_comm.
  - replace (PI * INR k * sqrt (n * epsilon / 3)) with (sqrt (G / 2)).
    + pose proof some_room _ _ P E as B. generalize (mean_at_most along tent F G _ IF IG D) (mean_at_most tent along G F _ IG IF (fun x X => eq_ind _
      (fun z => z <= _) (D x X) _ (Rabs_minus_sym _ _)) B).
      intros. unfold Rdiv. rewrite Rmult_1_l. apply Rabs_le. lra.
    + replace (G / 2) with ((PI * INR k) ^ 2 * (n * epsilon / 3)) by (unfold G; field). rewrite sqrt_mult, sqrt_pow2 by nra. reflexivity.
Qed.
Theorem crease_error_area__root_mean_squares (k_u k_v : nat) (epsilon : R) : (0 < k_u)%nat -> (0 < k_v)%nat ->
  (0 < epsilon <= / (2 * INR k_u) -> exists (means : R -> R) (mean : R),
    (forall v, is_RInt (fun u => (central_ridges.h_u u v (INR k_u) (INR k_v) epsilon - gradient_ridges.h_u u v (INR k_u) (INR k_v)) ^ 2) 0 1 (means
      v)) /\ is_RInt means 0 1 mean /\
    Rabs (sqrt mean - PI * INR k_u * sqrt (INR k_u * epsilon / 3)) <= room (INR k_u) epsilon) /\
  (0 < epsilon <= / (2 * INR k_v) -> exists (means : R -> R) (mean : R),
    (forall u, is_RInt (fun v => (central_ridges.h_v u v (INR k_u) (INR k_v) epsilon - gradient_ridges.h_v u v (INR k_u) (INR k_v)) ^ 2) 0 1 (means
      u)) /\ is_RInt means 0 1 mean /\
    Rabs (sqrt mean - PI * INR k_v * sqrt ((INR k_v - 1) * epsilon / 3)) <= room (INR k_v) epsilon).
Proof.
  split; intros [E E']; [apply (root_mean_square k_u k_v _ _ (error_along_u (INR k_u) epsilon) (tents (INR k_u) epsilon)) | apply (root_mean_square
    k_v k_u _ _ (error_along_v (INR k_v) epsilon) (inner k_v epsilon))]; trivial.
  - apply pos_INR.
  - apply mean_in_u; auto.
  - apply tents_in_u; auto.
  - intros. apply near_tents_in_u; auto.
  - intros. apply factor_of_u. exists (Z.of_nat k_u). apply INR_IZR_INZ.
  - assert (1 <= INR k_v) by (apply (le_INR 1); lia). lra.
  - apply mean_in_v; auto.
  - apply tents_in_v; auto.
  - apply near_tents_in_v; auto.
  - intros. apply factor_of_v.
Qed.
Theorem crease_error_area__root_mean_squares__point : exists k_u k_v epsilon, (0 < k_u)%nat /\ (0 < k_v)%nat /\ 0 < epsilon <= / (2 * INR k_u) /\
  0 < epsilon <= / (2 * INR k_v).
Proof. exists 1%nat, 1%nat, (1/2). simpl. repeat split; try lra; lia. Qed.
(* One tent fewer than k_v: where there is none, the error is much less. *)
Theorem crease_error_area__root_mean_squares__false : ~ forall (k_u k_v : nat) (epsilon : R), 0 < epsilon <= / (2 * INR k_v) -> exists (means : R ->
  R) (mean : R),
  (forall u, is_RInt (fun v => (central_ridges.h_v u v (INR k_u) (INR k_v) epsilon - gradient_ridges.h_v u v (INR k_u) (INR k_v)) ^ 2) 0 1 (means u))
    /\ is_RInt means 0 1 mean /\
  Rabs (sqrt mean - PI * INR k_v * sqrt (INR k_v * epsilon / 3)) <= room (INR k_v) epsilon.
Proof.
  intro H. assert (E : 0 < 1/100 <= / (2 * INR 1)) by (simpl; lra). destruct (H 1%nat 1%nat _ E) as (f & m & A & B & C). destruct (proj2
    (crease_error_area__root_mean_squares 1 1 _ ltac:(lia) ltac:(lia)) E) as (f' & m' & A' & B' & C').
  assert (F : forall u, f u = f' u) by (intro u; rewrite <- (is_RInt_unique _ _ _ _ (A u)); exact (is_RInt_unique _ _ _ _ (A' u))).
  assert (M : m = m') by (rewrite <- (is_RInt_unique _ _ _ _ B); apply is_RInt_unique; revert B'; apply is_RInt_ext; intros; symmetry; apply F).
  rewrite M in C. unfold room in C, C'. simpl (INR 1) in C, C'. replace (_ * _ / 3) with 0 in C' by field. rewrite sqrt_0 in C'. apply
    Rabs_le_between in C. apply Rabs_le_between in C'.
  assert (PI * 1 * sqrt (1 * (1/100) / 3) > 4 / 3 * (PI * 1) * (PI * 1 * (1/100)) ^ 2) by interval. lra.
Qed.
