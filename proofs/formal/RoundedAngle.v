(* The kernels' atan2 in half-turns as float64 carries it out: node, ratio, polynomial, octant. *)

From Coq Require Import Reals Lra Lia ZArith Machin.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Float Float64 HalfTurns RoundedHalfTurns Rounding RoundedGradient.
Open Scope R_scope.

(* The polynomial of a small ratio is within 2^-57 of the arctangent in half-turns. *)
Theorem elementary_functions__arctangent (r : R) : - (5/16 + 1/2^30) <= r <= 5/16 + 1/2^30 -> Rabs (arctangent_polynomial.small_part r 0 - atan r / PI) <= 1 / 2 ^ 57.
Proof.
  intro B. arctangent_polynomial.lines.
  interval with (i_taylor r, i_degree 40, i_prec 120).
Qed.

(* A rule for division: of two that were rounded before. *)
Lemma quotient_error (n d dn dd Q : R) : d <> 0 -> Rabs (n / d) <= Q -> Q <= 1 -> Rabs dn <= unit_roundoff -> Rabs dd <= unit_roundoff ->
  Rabs (rounded (n * (1 + dn) / (d * (1 + dd))) - n / d) <= 3001/1000 * Q / 2 ^ 53 + 1 / 2 ^ 100.
Proof.
  intros D B Q1 N E. assert (U : unit_roundoff = / 2 ^ 53) by (unfold unit_roundoff; simpl; lra). rewrite U in N, E. apply Rabs_le_between in N. apply Rabs_le_between in E.
  assert (P : 0 <= Q) by (eapply Rle_trans; [apply Rabs_pos | exact B]). set (q := n / d) in *.
  assert (M : Rabs (n * (1 + dn) / (d * (1 + dd)) - q) <= 20001/10000 / 2 ^ 53 * Q).
  { replace (_ - q) with ((dn - dd) / (1 + dd) * q) by (unfold q; field; lra). rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; [|exact B].
    unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ (1 + dd))) by (left; apply Rinv_0_lt_compat; lra). apply Rmult_le_reg_r with (1 + dd); [lra|].
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. apply Rabs_le. lra. }
  generalize (through _ _ _ _ _ (rounded_error _ _ (size _ _ _ _ B M)) M). intro T. eapply Rle_trans; [exact T|]. lra.
Qed.
Lemma half_of_float64 (x : R) : float64 x -> bpow radix2 (-1020) <= Rabs x -> float64 (1/2 * x).
Proof.
  intros F B. apply FLT_format_generic in F; [|easy]. destruct F as [[m e] E M L]. unfold F2R in E; cbn [Fnum Fexp] in *.
  destruct (Z.eq_dec e (-1074)) as [S|S].
  - exfalso. revert B. apply Rlt_not_le. rewrite E, S, Rabs_mult, (Rabs_pos_eq (bpow _ _)) by apply bpow_ge_0.
    apply Rlt_le_trans with (bpow radix2 53 * bpow radix2 (-1074)); [|rewrite <- bpow_plus; apply bpow_le; easy].
    apply Rmult_lt_compat_r; [apply bpow_gt_0|]. rewrite <- abs_IZR. change (bpow radix2 53) with (IZR (2 ^ 53)). apply IZR_lt, M.
  - replace (1/2 * x) with (IZR m * bpow radix2 (e - 1)); [apply whole_is_float64; [exact M | lia]|].
    rewrite E. unfold Zminus. rewrite bpow_plus. change (bpow radix2 (-(1))) with (/ 2). field.
Qed.
Lemma sum_float64 (a b : R) : float64 a -> float64 b -> exists d, Rabs d <= unit_roundoff /\ rounded (a + b) = (a + b) * (1 + d).
Proof. intros A B. destruct (rounded_difference a (- b) A (generic_format_opp _ _ _ B)) as (d & D & E). exists d. split; [exact D|]. replace (a + b) with (a - - b) by ring. exact E. Qed.

(* What the polynomial loses in float64. *)
Lemma difference_error (a ah b bh S ea eb : R) : Rabs (a - b) <= S -> Rabs (ah - a) <= ea -> Rabs (bh - b) <= eb -> Rabs (rounded (ah - bh) - (a - b)) <= (S + (ea + eb)) / 2 ^ 53 + 1 / 2 ^ 100 + (ea + eb).
Proof.
  intros B A E. assert (M : Rabs (ah - bh - (a - b)) <= ea + eb).
  { replace (_ - (a - b)) with ((ah - a) - (bh - b)) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. lra. }
  apply through with (ah - bh); [|exact M]. exact (rounded_error _ _ (size _ _ _ _ B M)).
Qed.
Lemma small_part_rounded (y x : R) : let r := angle_in_half_turns_float64.ratio y x in let k := angle_in_half_turns_float64.node_correction y x in
  - (5/16 + 1/2^30) <= r <= 5/16 + 1/2^30 -> 0 <= k <= 1 / 2 ^ 56 ->
  Rabs (angle_in_half_turns_float64.small_part y x - (k + arctangent_polynomial.small_part r 0)) <= 33/100 / 2 ^ 53.
Proof.
  intros r k B K. unfold angle_in_half_turns_float64.small_part, angle_in_half_turns_float64.arctangent_tail, arctangent_polynomial.small_part, arctangent_polynomial.arctangent_tail.
  rewrite Rplus_0_l. fold r k. set (zh := angle_in_half_turns_float64.ratio_squared y x). set (z := arctangent_polynomial.ratio_squared r).
  assert (Z : 0 <= z <= 98/1000) by (unfold z, arctangent_polynomial.ratio_squared; split; [apply pow2_ge_0 | interval]).
  assert (E : Rabs (zh - z) <= 99/1000 / 2 ^ 53).
  { unfold zh, angle_in_half_turns_float64.ratio_squared. fold r. replace (r * r) with z by (unfold z, arctangent_polynomial.ratio_squared; ring).
    eapply Rle_trans; [apply (rounded_error _ (98/1000)); apply Rabs_le; lra | interval]. }
  clearbody zh z r k.
  match goal with |- context [rounded (?c - rounded (?d * zh))] =>
    assert (I : Rabs (rounded (c - rounded (d * zh)) - (c - d * z)) <= 2/100 / 2 ^ 53)
      by (eapply Rle_trans; [eapply difference_error; [find_bound | apply no_error | find_error] | interval]) end.
  match goal with |- Rabs (rounded (k + ?bh) - (k + ?b)) <= _ => replace (k + bh) with (k - - bh) by ring; replace (k + b) with (k - - b) by ring end.
  eapply Rle_trans; [eapply difference_error; [find_bound | apply no_error | apply of_opposites; find_error] | interval].
Qed.

Section angle.
Variables y x : R.
Hypothesis Y : float64 y.
Hypothesis X : float64 x.
Let l := angle_in_half_turns_float64.larger y x.
Let s := angle_in_half_turns_float64.smaller y x.
Hypothesis not_small : bpow radix2 (-1018) <= l.
Lemma sides : float64 l /\ float64 s /\ 0 <= s <= l /\ 0 < l.
Proof.
  assert (A := generic_format_abs _ _ _ X). assert (B := generic_format_abs _ _ _ Y). assert (P := bpow_gt_0 radix2 (-1018)).
  split; [|split; [|split; [split|]]]; [| | | |lra]; unfold l, s; angle_in_half_turns_float64.lines; unfold Rmax, Rmin;
    destruct Rle_dec; try assumption; try apply Rabs_pos; lra.
Qed.
Lemma part_of_larger (c : R) : 1/4 <= c <= 1 -> c * l * (1 - / 2 ^ 53) <= rounded (c * l) <= c * l * (1 + / 2 ^ 53).
Proof.
  intro C. destruct sides as (_ & _ & _ & P). assert (U : unit_roundoff = / 2 ^ 53) by (unfold unit_roundoff; simpl; lra).
  destruct (standard_model (c * l)) as (d & D & ->).
  - rewrite Rabs_pos_eq by nra. apply Rle_trans with (1/4 * l); [|nra]. apply Rle_trans with (bpow radix2 (-2) * bpow radix2 (-1018)); [rewrite <- bpow_plus; apply bpow_le; easy|].
    change (bpow radix2 (-2)) with (/ 4). lra.
  - rewrite U in D. apply Rabs_le_between in D. assert (0 < c * l) by nra. split; nra.
Qed.
(* The ratio that stands for s/l, once the node n is taken off. *)
Let n := angle_in_half_turns_float64.node y x.
Let k := angle_in_half_turns_float64.node_correction y x.
Let rho := (s - n * l) / (l + n * s).
Lemma taken_off (m : R) (Q : R) : (m = 1/2 \/ m = 1) -> n = m -> 1/4 * l <= s -> Rabs ((s - m * l) / (l + m * s)) <= Q -> Q <= 1 ->
  Rabs (angle_in_half_turns_float64.ratio y x - rho) <= 3001/1000 * Q / 2 ^ 53 + 1 / 2 ^ 100.
Proof.
  intros M E T B Q1. destruct sides as (L & S & O & P). unfold angle_in_half_turns_float64.ratio, angle_in_half_turns_float64.denominator. unfold rho. fold l s n. rewrite E.
  destruct Rlt_dec as [_|W]; [|contradiction].
  assert (G : bpow radix2 (-1020) <= s).
  { apply Rle_trans with (1/4 * l); [|exact T]. apply Rle_trans with (bpow radix2 (-2) * bpow radix2 (-1018)); [rewrite <- bpow_plus; apply bpow_le; easy|].
    change (bpow radix2 (-2)) with (/ 4). lra. }
  assert (F : forall z, float64 z -> bpow radix2 (-1020) <= z -> float64 (m * z)).
  { intros z Z Zb. destruct M as [-> | ->]; [apply half_of_float64; [exact Z | eapply Rle_trans; [exact Zb | apply Rle_abs]] | rewrite Rmult_1_l; exact Z]. }
  assert (Fs := F s S G). assert (Fl := F l L (Rle_trans _ _ _ G (proj2 O))). rewrite (Rmult_comm l), (kept _ Fs), (kept _ Fl).
  destruct (sum_float64 _ _ L Fs) as (dd & Dd & ->). destruct (rounded_difference _ _ S Fl) as (dn & Dn & ->).
  apply quotient_error; try assumption. destruct M as [-> | ->]; lra.
Qed.
Lemma between_rates (a b Q : R) : 0 < b -> - Q * b <= a <= Q * b -> Rabs (a / b) <= Q.
Proof. intros P B. apply Rabs_le. split; apply Rmult_le_reg_r with b; try exact P; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra. Qed.
Lemma by_node : (n = 0 \/ n = 1/2 \/ n = 1) /\ 0 <= k <= 1 / 2 ^ 56 /\ Rabs rho <= 5/16 + 1 / 2 ^ 31 /\
  Rabs (angle_in_half_turns_float64.ratio y x - rho) <= 6/10 / 2 ^ 53 /\ 0 <= angle_in_half_turns_float64.node_value y x <= 1/4 /\
  Rabs (angle_in_half_turns_float64.node_value y x + k - atan n / PI) <= 1 / 2 ^ 100.
Proof.
  destruct sides as (L & S & O & P). generalize (part_of_larger (5/16) ltac:(lra)) (part_of_larger (3/4) ltac:(lra)). intros C5 C3.
  assert (K : forall Q, Q <= 19/100 -> 3001/1000 * Q / 2 ^ 53 + 1 / 2 ^ 100 <= 6/10 / 2 ^ 53) by (intros Q H; lra).
  assert (G := taken_off). unfold rho in *. assert (En : n = n) by reflexivity. unfold n at 2, angle_in_half_turns_float64.node in En.
  unfold k, angle_in_half_turns_float64.node_correction, angle_in_half_turns_float64.node_value.
  unfold angle_in_half_turns_float64.steep, angle_in_half_turns_float64.middle in *. fold l s in En |- *.
  destruct (Rlt_dec (rounded (3/4 * l)) s) as [St|St]; [|destruct (Rlt_dec (rounded (5/16 * l)) s) as [Mi|Mi]]; repeat destruct Rlt_dec; try lra; rewrite En.
  - assert (R : Rabs ((s - 1 * l) / (l + 1 * s)) <= 15/100) by (apply between_rates; lra).
    split; [lra|]. split; [lra|]. split; [lra|]. split; [|split; [lra|]].
    + rewrite <- En. eapply Rle_trans; [apply (G 1 (15/100)); try assumption; lra | apply K; lra].
    + rewrite atan_1. replace (_ - _) with 0 by (field; apply PI_neq0). rewrite Rabs_R0. interval.
  - assert (R : Rabs ((s - 1/2 * l) / (l + 1/2 * s)) <= 19/100) by (apply between_rates; lra).
    split; [lra|]. split; [lra|]. split; [lra|]. split; [|split; [lra|]].
    + rewrite <- En. eapply Rle_trans; [apply (G (1/2) (19/100)); try assumption; lra | apply K; lra].
    + interval with (i_prec 150).
  - assert (Z : (s - 0 * l) / (l + 0 * s) = s / l) by (f_equal; ring). assert (R : Rabs (s / l) <= 5/16 + 1 / 2 ^ 31) by (apply between_rates; lra). rewrite Z.
    split; [lra|]. split; [lra|]. split; [exact R|]. split; [|split; [lra|]].
    + unfold angle_in_half_turns_float64.ratio, angle_in_half_turns_float64.denominator. fold l s n. rewrite En. destruct Rlt_dec as [_|W]; [|contradiction].
      rewrite Rmult_0_l, Rmult_0_r, !rounded_0, Rplus_0_r, Rminus_0_r, (kept _ S), (kept _ L). eapply Rle_trans; [apply (rounded_error _ _ R) | interval].
    + rewrite atan_0. replace (_ - _) with 0 by (field; apply PI_neq0). rewrite Rabs_R0. interval.
Qed.
Lemma first_octant_near : Rabs (angle_in_half_turns_float64.first_octant y x - atan (s / l) / PI) <= 85/100 / 2 ^ 53 /\ 0 <= atan (s / l) / PI <= 26/100.
Proof.
  destruct sides as (L & S & O & P). destruct by_node as (M & K & Rh & Er & V & A). set (r := angle_in_half_turns_float64.ratio y x) in *.
  assert (T : 0 <= s / l <= 1).
  { split; apply Rmult_le_reg_r with l; try exact P; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra. }
  assert (Br : - (5/16 + 1/2^30) <= r <= 5/16 + 1/2^30).
  { apply Rabs_le_between. replace r with (rho + (r - rho)) by ring. eapply Rle_trans; [apply Rabs_triang|]. eapply Rle_trans; [exact (Rplus_le_compat _ _ _ _ Rh Er) | interval]. }
  assert (D : Rabs (atan r - atan rho) <= 1 * Rabs (r - rho)).
  { apply (moved_by_at_most atan (fun t => / (1 + Rsqr t)) 1); [apply is_derive_atan|]. intro t. assert (Q := Rle_0_sqr t).
    rewrite Rabs_pos_eq by (left; apply Rinv_0_lt_compat; lra). rewrite <- Rinv_1 at 2. apply Rinv_le_contravar; lra. }
  assert (Add : atan (s / l) = atan n + atan rho).
  { assert (n0 : 0 <= n <= 1) by lra. assert (n1 : 0 <= n * s) by nra. replace rho with (atan_sub (s / l) n) by (unfold rho, atan_sub; field; lra).
    assert (0 <= s / l * n) by nra. set (t := s / l) in *. apply atan_sub_correct; [lra | split; interval | generalize (atan_bound (atan_sub t n)); lra]. }
  assert (B : 0 <= atan (s / l) / PI <= 26/100).
  { set (t := s / l) in *. split; [|interval]. apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat, PI_RGT_0].
    rewrite <- atan_0. destruct (proj1 T) as [G | <-]; [left; apply atan_increasing, G | apply Rle_refl]. }
  split; [|exact B]. generalize (small_part_rounded y x Br K) (elementary_functions__arctangent r Br). fold r k. intros E1 E2.
  set (d := atan r - atan rho) in *. assert (E3 : Rabs (d / PI) <= 192/1000 / 2 ^ 53).
  { assert (D' : - (6/10 / 2 ^ 53) <= d <= 6/10 / 2 ^ 53) by (apply Rabs_le_between; lra). interval. }
  assert (E : Rabs (angle_in_half_turns_float64.node_value y x + angle_in_half_turns_float64.small_part y x - atan (s / l) / PI) <= 586/1000 / 2 ^ 53).
  { assert (F : atan (s / l) / PI = atan n / PI + atan r / PI - d / PI) by (rewrite Add; unfold d; field; apply PI_neq0). rewrite F.
    apply Rabs_le_between in E1. apply Rabs_le_between in E2. apply Rabs_le_between in E3. apply Rabs_le_between in A. apply Rabs_le. lra. }
  assert (B' : Rabs (atan (s / l) / PI) <= 26/100) by (apply Rabs_le; lra).
  eapply Rle_trans; [exact (through _ _ _ _ _ (rounded_error _ _ (size _ _ _ _ B' E)) E) | interval].
Qed.
(* The octant, of the exact angle and of the computed one. *)
Lemma octants : let o := atan (s / l) / PI in let q := if Rlt_dec (Rabs x) (Rabs y) then 1/2 - o else o in let h := if Rlt_dec x 0 then 1 - q else q in atan2pi y x = if Rlt_dec y 0 then - h else h.
Proof.
  intros o q. assert (Q : q = if Req_EM_T x 0 then 1/2 else atan (Rabs y / Rabs x) / PI).
  { destruct sides as (_ & _ & _ & P). assert (Px := Rabs_pos x). assert (Py := Rabs_pos y). unfold q, o, l, s, angle_in_half_turns_float64.larger, angle_in_half_turns_float64.smaller in *.
    destruct (Req_EM_T x 0) as [Z|Z]; [|apply Rabs_pos_lt in Z]; destruct Rlt_dec as [W|W]; rewrite ?(Rmin_left _ _ (Rlt_le _ _ W)), ?(Rmax_right _ _ (Rlt_le _ _ W)).
    - rewrite Z, Rabs_R0. unfold Rdiv. rewrite Rmult_0_l, atan_0. ring.
    - exfalso. rewrite Z, Rabs_R0 in *. rewrite Rmax_left in P; lra.
    - replace (Rabs y / Rabs x) with (/ (Rabs x / Rabs y)) by (field; lra). rewrite atan_inv by (apply Rdiv_lt_0_compat; lra). field. apply PI_neq0.
    - rewrite Rmin_right, Rmax_left by lra. reflexivity. }
  rewrite Q. clear q Q. unfold atan2pi, atan2. destruct (Req_EM_T x 0) as [Z|Z].
  - destruct sides as (_ & _ & _ & P). unfold l, angle_in_half_turns_float64.larger in P. rewrite Z in *. rewrite Rabs_R0 in P. repeat destruct Rlt_dec; try lra; try (field; apply PI_neq0).
    replace y with 0 in P by lra. rewrite Rabs_R0, Rmax_left in P; lra.
  - assert (A : forall a b, atan (- a / b) = - atan (a / b)) by (intros a b; rewrite <- atan_opp; f_equal; unfold Rdiv; ring).
    assert (A' : forall a b, b <> 0 -> atan (a / - b) = - atan (a / b)) by (intros a b H; rewrite <- atan_opp; f_equal; field; lra).
    repeat destruct Rlt_dec; try destruct Rle_dec; try lra; rewrite ?(Rabs_pos_eq x), ?(Rabs_pos_eq y), ?(Rabs_left x), ?(Rabs_left y) by lra;
      rewrite ?A', ?A, ?Ropp_involutive by lra; field; apply PI_neq0.
Qed.
Lemma angle_near : Rabs (angle_in_half_turns_float64.angle y x - atan2pi y x) <= 5/2 * (1 / 2 ^ 53).
Proof.
  destruct first_octant_near as [E B]. rewrite octants. unfold angle_in_half_turns_float64.angle, angle_in_half_turns_float64.half_plane, angle_in_half_turns_float64.first_quadrant.
  set (o := atan (s / l) / PI) in *. set (oh := angle_in_half_turns_float64.first_octant y x) in *.
  assert (Q : forall a b c e, Rabs (a - b) <= e -> 0 <= c - b <= c -> Rabs (rounded (c - a) - (c - b)) <= (c + e) / 2 ^ 53 + 1 / 2 ^ 100 + e).
  { intros a b c e H K. assert (M : Rabs (c - a - (c - b)) <= e) by (replace (_ - (c - b)) with (- (a - b)) by ring; rewrite Rabs_Ropp; exact H).
    assert (C : Rabs (c - b) <= c) by (apply Rabs_le; lra). exact (through _ _ _ _ _ (rounded_error _ _ (size _ _ _ _ C M)) M). }
  set (q := if Rlt_dec (Rabs x) (Rabs y) then 1/2 - o else o). set (qh := if Rlt_dec (Rabs x) (Rabs y) then _ else oh).
  assert (Eq : Rabs (qh - q) <= 136/100 / 2 ^ 53 /\ 0 <= q <= 1/2).
  { unfold qh, q. destruct Rlt_dec; (split; [|lra]); [|lra]. eapply Rle_trans; [exact (Q _ _ (1/2) _ E ltac:(lra)) | lra]. }
  clearbody q qh. destruct Eq as [Eq Bq]. assert (Eh := Q _ _ 1 _ Eq ltac:(lra)). repeat destruct Rlt_dec; try apply of_opposites; lra.
Qed.
End angle.

(* The angle of a point whose coordinates float64 holds, the larger of them not near underflow, is within 5/2 2^-53 of the angle; *)
Theorem elementary_functions__atan2pi (y x : R) : float64 y -> float64 x -> bpow radix2 (-1018) <= Rmax (Rabs x) (Rabs y) -> Rabs (angle_in_half_turns_float64.angle y x - atan2pi y x) <= 5/2 * (1 / 2 ^ 53).
Proof. apply angle_near. Qed.
(* of the origin it is 0. *)
Theorem elementary_functions__origin : angle_in_half_turns_float64.angle 0 0 = 0.
Proof.
  assert (L : angle_in_half_turns_float64.larger 0 0 = 0) by (unfold angle_in_half_turns_float64.larger; rewrite Rabs_R0; apply Rmax_left; lra).
  assert (S : angle_in_half_turns_float64.smaller 0 0 = 0) by (unfold angle_in_half_turns_float64.smaller; rewrite Rabs_R0; apply Rmin_left; lra).
  unfold angle_in_half_turns_float64.angle, angle_in_half_turns_float64.half_plane, angle_in_half_turns_float64.first_quadrant, angle_in_half_turns_float64.first_octant, angle_in_half_turns_float64.small_part,
    angle_in_half_turns_float64.node_value, angle_in_half_turns_float64.node_correction, angle_in_half_turns_float64.ratio, angle_in_half_turns_float64.steep, angle_in_half_turns_float64.middle.
  rewrite L, S, !Rmult_0_r, rounded_0. repeat destruct Rlt_dec; try lra. rewrite Rmult_0_l, !rounded_0, !Rplus_0_l, !rounded_0. reflexivity.
Qed.
Theorem elementary_functions__arctangent__point : exists r : R, - (5/16 + 1/2^30) <= r <= 5/16 + 1/2^30.
Proof. exists 0. lra. Qed.
Theorem elementary_functions__atan2pi__point : exists y x : R, float64 y /\ float64 x /\ bpow radix2 (-1018) <= Rmax (Rabs x) (Rabs y).
Proof.
  exists 0, 1. split; [apply generic_format_0|]. split; [apply (generic_format_bpow radix2 (FLT_exp (-1074) 53) 0); easy|].
  rewrite Rabs_R1. eapply Rle_trans; [|apply Rmax_l]. apply (bpow_le radix2 (-1018) 0). easy.
Qed.
(* Without the node that is taken off the polynomial is not so near, and where its quotient alone decides, the angle is not. *)
Theorem elementary_functions__arctangent__false : ~ forall r, -1 <= r <= 1 -> Rabs (arctangent_polynomial.small_part r 0 - atan r / PI) <= 1 / 2 ^ 57.
Proof.
  intro H. generalize (H 1 ltac:(lra)). apply Rlt_not_le. arctangent_polynomial.lines. interval with (i_prec 120).
Qed.
Theorem elementary_functions__atan2pi__false : ~ forall y x, float64 y -> float64 x -> bpow radix2 (-1018) <= Rmax (Rabs x) (Rabs y) -> Rabs (angle_in_half_turns_float64.angle y x - atan (y / x) / PI) <= 5/2 * (1 / 2 ^ 53).
Proof.
  intro H. assert (F : float64 (-1)) by (apply generic_format_opp, (generic_format_bpow radix2 (FLT_exp (-1074) 53) 0); easy).
  assert (M : bpow radix2 (-1018) <= Rmax (Rabs (-1)) (Rabs 0)).
  { rewrite Rabs_left by lra. eapply Rle_trans; [|apply Rmax_l]. replace (- -1) with 1 by ring. apply (bpow_le radix2 (-1018) 0). easy. }
  generalize (H 0 (-1) (generic_format_0 _ _) F M) (elementary_functions__atan2pi 0 (-1) (generic_format_0 _ _) F M).
  unfold atan2pi, atan2. repeat destruct Rlt_dec; try lra. destruct Rle_dec; try lra. unfold Rdiv. rewrite Rmult_0_l, atan_0, Rmult_0_l, Rplus_0_l, Rinv_r by apply PI_neq0.
  intros A B. apply Rabs_le_between in A. apply Rabs_le_between in B. lra.
Qed.
Theorem elementary_functions__origin__false : ~ forall y, float64 y -> angle_in_half_turns_float64.angle y 0 = 0.
Proof.
  intro H. assert (F : float64 1) by (apply (generic_format_bpow radix2 (FLT_exp (-1074) 53) 0); easy). assert (M : bpow radix2 (-1018) <= Rmax (Rabs 0) (Rabs 1)).
  { rewrite Rabs_R1. eapply Rle_trans; [|apply Rmax_r]. apply (bpow_le radix2 (-1018) 0). easy. }
  generalize (elementary_functions__atan2pi 1 0 F (generic_format_0 _ _) M). rewrite (H 1 F). unfold atan2pi, atan2. repeat destruct Rlt_dec; try lra.
  replace (0 - PI / 2 / PI) with (- (1/2)) by (field; apply PI_neq0). rewrite Rabs_Ropp, Rabs_pos_eq; lra.
Qed.
