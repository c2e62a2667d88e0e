(* The kernels' atan2 in half-turns as float64 carries it out: node, ratio, polynomial, octant. *)

From Coq Require Import Reals Lra Lia ZArith Machin.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Mult_error.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Float Float64 RoundedHalfTurns Rounding RoundedGradient.
Open Scope R_scope.

(* The arctangent rises, and moves by no more than what it is of. *)
Lemma atan_rises a b : a <= b -> atan a <= atan b.
Proof. intros [L | ->]; [left; apply atan_increasing, L | apply Rle_refl]. Qed.
Lemma atan_moves a b : Rabs (atan b - atan a) <= Rabs (b - a).
Proof.
  rewrite <- (Rmult_1_l (Rabs (b - a))). apply (bounded_variation atan (fun t => / (1 + Rsqr t))). intros t _. split; [apply is_derive_atan|].
  pose proof Rle_0_sqr t as Q. rewrite Rabs_pos_eq by (left; apply Rinv_0_lt_compat; lra). rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
Qed.

(* Of a smaller one it is nearer, and it is relative to the ratio. *)
Lemma arctangent_nearer r : -183/1000 <= r <= 183/1000 -> Rabs (arctangent_polynomial.small_part r 0 - atan r / PI) <= 1 / 2 ^ 60.
Proof. intro B. arctangent_polynomial.lines. interval with (i_taylor r, i_degree 30, i_prec 120). Qed.
Lemma arctangent_relative r : - (5/16 + 1/2^30) <= r <= 5/16 + 1/2^30 -> Rabs (arctangent_polynomial.small_part r 0 - atan r / PI) <= 1/4 / 2 ^ 53
  * Rabs r.
Proof.
  intro B. evar (h : R -> R). apply (at_most_times (fun t => arctangent_polynomial.small_part t 0 - atan t / PI) h _ (5/16 + 1/2^30));
    [unfold arctangent_polynomial.small_part; rewrite atan_0; unfold Rdiv; ring | intros t T; split | exact B].
  - arctangent_polynomial.lines. auto_derive; [exact I|]. unfold h. reflexivity.
  - unfold h. clear - T. interval with (i_taylor t, i_degree 36, i_prec 80).
Qed.

(* A rule for division: of two that were rounded before. *)
Lemma quotient_error n d dn dd Q : d <> 0 -> Rabs (n / d) <= Q -> Q <= 1 -> Rabs dn <= unit_roundoff -> Rabs dd <= unit_roundoff -> Rabs (rounded
  (n * (1 + dn) / (d * (1 + dd))) - n / d) <= 3001/1000 * Q / 2 ^ 53 + 1 / 2 ^ 100.
Proof.
  intros D B Q1 N E. assert (U : unit_roundoff = / 2 ^ 53) by (unfold unit_roundoff; simpl; lra). rewrite U in N, E. both_ways N. both_ways E.
  assert (P : 0 <= Q) by (at_most_by Rabs_pos; exact B). set (q := n / d) in *.
  assert (M : Rabs (n * (1 + dn) / (d * (1 + dd)) - q) <= 20001/10000 / 2 ^ 53 * Q).
  { replace (_ - q) with (((1 + dn) / (1 + dd) - 1) * q) by (unfold q; field; lra). rewrite Rabs_mult. factors;
    [interval with (i_prec 120) | exact B]. }
  generalize (through _ _ _ _ _ (rounded_error _ _ (size _ _ _ _ B M)) M). intro T. at_most_by T. lra.
Qed.
Lemma scaled_float64 x k e : float64 x -> bpow radix2 k <= Rabs x -> (-1022 - k <= e)%Z -> float64 (x * bpow radix2 e).
Proof. intros F B E. apply mult_bpow_exact_FLT; [exact F|]. assert (k + 1 <= mag radix2 x)%Z by (apply mag_ge_bpow; replace (k + 1 - 1)%Z with k by
  ring; exact B). lia. Qed.
Lemma multiple_of_power x j : float64 x -> bpow radix2 (j + 52) <= Rabs x -> exists m : Z, x = IZR m * bpow radix2 j.
Proof.
  intros F B. apply (generic_inclusion_ge radix2 (FLT_exp (-1074) 53) (FIX_exp j) (j + 52)) in F; [|intros; unfold FLT_exp, FIX_exp; lia | exact B].
    apply FIX_format_generic in F. destruct F as [[m e] -> E]. exists m. simpl in E. rewrite E. reflexivity.
Qed.

(* What the polynomial loses in float64. *)
Lemma difference_error a ah b bh S ea eb : Rabs (a - b) <= S -> Rabs (ah - a) <= ea -> Rabs (bh - b) <= eb -> Rabs (rounded (ah - bh) - (a - b))
  <= (S + (ea + eb)) / 2 ^ 53 + 1 / 2 ^ 100 + (ea + eb).
Proof.
  intros B A E. assert (M : Rabs (ah - bh - (a - b)) <= ea + eb).
  { by_sides. }
  apply through with (ah - bh); [|exact M]. exact (rounded_error _ _ (size _ _ _ _ B M)).
Qed.
Section ratio.
Variables y x : R.
Let r := angle_in_half_turns_float64.ratio y x.
Let k := angle_in_half_turns_float64.node_correction y x.
Let factor := rounded (angle_in_half_turns_float64.arctangent_tail y x + 5734161139222659 / 18014398509481984).
Let P (t : R) := arctangent_polynomial.arctangent_tail t + 5734161139222659 / 18014398509481984.
Lemma factor_of_ratio t : - (5/16 + 1/2^30) <= t <= 5/16 + 1/2^30 -> 307/1000 <= P t <= 3184/10000 /\ arctangent_polynomial.small_part t 0 = t * P
  t.
Proof. intro T. split; [unfold P, arctangent_polynomial.arctangent_tail, arctangent_polynomial.ratio_squared; split; interval | unfold
  arctangent_polynomial.small_part, P; ring]. Qed.
Hypothesis B : - (5/16 + 1/2^30) <= r <= 5/16 + 1/2^30.
Lemma factor_near : Rabs (factor - P r) <= 38/100 / 2 ^ 53.
Proof.
  unfold factor, P, angle_in_half_turns_float64.arctangent_tail, arctangent_polynomial.arctangent_tail. set (zh :=
    angle_in_half_turns_float64.ratio_squared y x). set (z := arctangent_polynomial.ratio_squared r).
  assert (Z : 0 <= z <= 98/1000) by (unfold z, arctangent_polynomial.ratio_squared; split; [apply pow2_ge_0 | interval]).
  assert (E : Rabs (zh - z) <= 99/1000 / 2 ^ 53).
  { unfold zh, angle_in_half_turns_float64.ratio_squared. fold r. replace (r * r) with z by (unfold z, arctangent_polynomial.ratio_squared; ring).
    eapply Rle_trans; [apply (rounded_error _ (98/1000)); apply Rabs_le; lra | interval]. }
  clearbody zh z r. clear factor P.
  match goal with |- context [rounded (?c - rounded (?d * zh))] =>
    assert (I : Rabs (rounded (c - rounded (d * zh)) - (c - d * z)) <= 2/100 / 2 ^ 53)
      by (eapply Rle_trans; [eapply difference_error; [find_bound | apply no_error | find_error] | interval]) end.
  eapply Rle_trans; [find_error | interval].
Qed.
Lemma small_part_rounded Q : Rabs r <= Q -> Q <= 1/2 -> 0 <= k <= 1 / 2 ^ 56 -> Rabs (angle_in_half_turns_float64.small_part y x - (k +
  arctangent_polynomial.small_part r 0)) <= 102/100 * Q / 2 ^ 53 + 1 / 2 ^ 97.
Proof.
  intros S1 S2 K. destruct (factor_of_ratio r B) as [Bp ->]. pose proof factor_near as E. unfold angle_in_half_turns_float64.small_part. fold r k
    factor. clearbody factor r k. set (p := P r) in *. clearbody p.
  assert (Sp : Rabs p <= 3184/10000) by (apply Rabs_le; lra). pose proof times_error r r p factor Q (3184/10000) 0 _ S1 Sp (no_error r) E as E1. assert
    (S3 : Rabs (r * p + k) <= 3184/10000 * Q + 1 / 2 ^ 56).
  { at_most_by Rabs_triang. rewrite Rabs_mult, (Rabs_pos_eq k) by lra. generalize (Rmult_le_compat _ _ _ _ (Rabs_pos r) (Rabs_pos p)
    S1 Sp). lra. }
  rewrite !(Rplus_comm k). eapply Rle_trans; [exact (sum_error _ _ _ _ _ S3 E1)|]. assert (0 <= Q) by (at_most_by Rabs_pos; exact S1). lra.
Qed.
End ratio.

Section angle.
Variables y x : R.
Hypothesis Y : float64 y.
Hypothesis X : float64 x.
Let l := angle_in_half_turns_float64.larger y x.
Let s := angle_in_half_turns_float64.smaller y x.
Hypothesis not_small : bpow radix2 (-1018) <= l.
Lemma sides : float64 l /\ float64 s /\ 0 <= s <= l /\ 0 < l.
Proof.
  pose proof generic_format_abs _ _ _ X as A. pose proof generic_format_abs _ _ _ Y as B. pose proof bpow_gt_0 radix2 (-1018) as P.
  split; [|split; [|split; [split|]]]; [| | | |lra]; unfold l, s; angle_in_half_turns_float64.lines; unfold Rmax, Rmin;
    destruct Rle_dec; try assumption; try apply Rabs_pos; lra.
Qed.
Lemma quarter_of_larger : bpow radix2 (-1020) <= 1/4 * l.
Proof. change (bpow radix2 (-2 + -1018) <= 1/4 * l). rewrite bpow_plus. change (bpow radix2 (-2)) with (/ 4). lra. Qed.
Lemma part_of_larger c : 1/4 <= c <= 1 -> c * l * (1 - / 2 ^ 53) <= rounded (c * l) <= c * l * (1 + / 2 ^ 53).
Proof.
  intro C. destruct sides as (_ & _ & _ & P). assert (U : unit_roundoff = / 2 ^ 53) by (unfold unit_roundoff; simpl; lra).
  destruct (standard_model (c * l)) as (d & D & ->).
  - rewrite Rabs_pos_eq by nra. eapply Rle_trans; [|apply Rle_trans with (1/4 * l); [exact quarter_of_larger | nra]]. apply bpow_le. easy.
  - rewrite U in D. both_ways D. assert (0 < c * l) by nra. split; nra.
Qed.
(* The ratio that stands for s/l, once the node n is taken off. *)
Let n := angle_in_half_turns_float64.node y x.
Let k := angle_in_half_turns_float64.node_correction y x.
Let rho := (s - n * l) / (l + n * s).
Lemma taken_off m Q : (m = 1/2 \/ m = 1) -> n = m -> 1/4 * l <= s -> Rabs ((s - m * l) / (l + m * s)) <= Q -> Q <= 1 -> Rabs
  (angle_in_half_turns_float64.ratio y x - rho) <= 3001/1000 * Q / 2 ^ 53 + 1 / 2 ^ 100.
Proof.
  intros M E T B Q1. destruct sides as (L & S & O & P). unfold angle_in_half_turns_float64.ratio, angle_in_half_turns_float64.denominator. unfold rho.
    fold l s n. rewrite E.
  destruct Rlt_dec as [_|W]; [|contradiction].
  pose proof Rle_trans _ _ _ quarter_of_larger T as G.
  assert (F : forall z, float64 z -> bpow radix2 (-1020) <= z -> float64 (m * z)).
  { intros z Z Zb. destruct M as [-> | ->]; [|rewrite Rmult_1_l; exact Z]. replace (1/2 * z) with (z * bpow radix2 (-1)) by (simpl; lra). apply
    (scaled_float64 z (-1020)); [exact Z | at_most_by Zb; apply Rle_abs | easy]. }
  pose proof F s S G as Fs. pose proof F l L (Rle_trans _ _ _ G (proj2 O)) as Fl. rewrite (Rmult_comm l), (kept _ Fs), (kept _ Fl).
  replace (l + m * s) with (l - - (m * s)) in * by ring. destruct (rounded_difference _ _ L (generic_format_opp _ _ _ Fs)) as (dd & Dd & ->). destruct
    (rounded_difference _ _ S Fl) as (dn & Dn & ->).
  apply quotient_error; try assumption. destruct M as [-> | ->]; lra.
Qed.
Lemma between_rates a b Q : 0 < b -> - Q * b <= a <= Q * b -> Rabs (a / b) <= Q.
Proof. intros P B. apply Rabs_le. split; [apply Rle_div_r | apply Rle_div_l]; lra. Qed.
Let v := angle_in_half_turns_float64.node_value y x.
Let r := angle_in_half_turns_float64.ratio y x.
Lemma by_node : 0 <= n <= 1 /\ 0 <= k <= 1 / 2 ^ 56 /\ 0 <= v <= 1/4 /\ Rabs (v + k - atan n / PI) <= 1 / 2 ^ 100 /\
  (n = 0 /\ k = 0 /\ v = 0 /\ Rabs rho <= 5/16 + 1 / 2 ^ 31 /\ Rabs (r - rho) <= / 2 ^ 53 * Rabs rho + bpow radix2 (-1074) \/ Rabs rho <= 182/1000 /\
    Rabs (r - rho) <= 547/1000 / 2 ^ 53 /\ 312/1000 * l <= s).
Proof.
  destruct sides as (L & S & O & P). generalize (part_of_larger (5/16) ltac:(lra)) (part_of_larger (3/4) ltac:(lra)). intros C5 C3.
  pose proof taken_off as G. unfold r, rho in *. assert (En : n = n) by reflexivity. unfold n at 2, angle_in_half_turns_float64.node in En.
  unfold k, v, angle_in_half_turns_float64.node_correction, angle_in_half_turns_float64.node_value.
  unfold angle_in_half_turns_float64.steep, angle_in_half_turns_float64.middle in *. fold l s in En |- *.
  destruct (Rlt_dec (rounded (3/4 * l)) s) as [St|St]; [|destruct (Rlt_dec (rounded (5/16 * l)) s) as [Mi|Mi]]; repeat destruct Rlt_dec; try lra;
    rewrite En; (split; [lra | split; [lra | split; [lra | split; [interval with (i_prec 150)|]]]]).
  - assert (R : Rabs ((s - 1 * l) / (l + 1 * s)) <= 15/100) by (apply between_rates; lra). right. split; [lra | split; [|lra]]. rewrite <- En. eapply
    Rle_trans; [apply (G 1 (15/100)); try assumption; lra | lra].
  - assert (R : Rabs ((s - 1/2 * l) / (l + 1/2 * s)) <= 182/1000) by (apply between_rates; lra). right. split; [exact R | split; [|lra]]. rewrite <-
    En. eapply Rle_trans; [apply (G (1/2) (182/1000)); try assumption; lra | lra].
  - assert (Z : (s - 0 * l) / (l + 0 * s) = s / l) by (f_equal; ring). rewrite Z. left. do 3 (split; [reflexivity|]). split; [apply between_rates;
    lra|]. unfold angle_in_half_turns_float64.ratio, angle_in_half_turns_float64.denominator. fold l s n. rewrite En. destruct Rlt_dec as [_|W];
    [|contradiction].
      rewrite Rmult_0_l, Rmult_0_r, !rounded_0, Rplus_0_r, Rminus_0_r, (kept _ S), (kept _ L). apply one_rounding.
Qed.
Lemma first_octant_near : let o := atan (s / l) / PI in let d := Rabs (angle_in_half_turns_float64.first_octant y x - o) in d <= 85/100 / 2 ^ 53 /\ d
  <= 49/10 / 2 ^ 53 * o + 8 * bpow radix2 (-1074) /\ 0 <= o <= 26/100.
Proof.
  intro o. cbv zeta. destruct sides as (L & S & O & P). destruct by_node as (N & K & V & A & C). pose proof underflow_is_less as U.
  assert (T : 0 <= s / l <= 1) by (split; [apply Rle_div_r | apply Rle_div_l]; lra).
  assert (Rabs rho <= 5/16 + 1 / 2 ^ 31 /\ Rabs (r - rho) <= 6/10 / 2 ^ 53) as [Rh Er] by (destruct C as [(_ & _ & _ & Wr & Wd)|(Wr & Wd & _)]; lra).
  assert (Br : - (5/16 + 1/2^30) <= r <= 5/16 + 1/2^30).
  { apply Rabs_le_between. generalize (size _ _ _ _ Rh Er). lra. }
  assert (Add : atan (s / l) = atan n + atan rho).
  { assert (n0 : 0 <= n <= 1) by lra. assert (n1 : 0 <= n * s) by nra. replace rho with (atan_sub (s / l) n) by (unfold rho, atan_sub; field; lra).
    assert (0 <= s / l * n) by nra. set (t := s / l) in *. apply atan_sub_correct; [lra | split; interval | apply atan_bound]. }
  assert (B : 0 <= o <= 26/100).
  { unfold o. set (t := s / l) in *. split; [|interval]. apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat, PI_RGT_0].
    rewrite <- atan_0. apply atan_rises, T. }
  assert (E3 : Rabs ((atan r - atan rho) / PI) <= 3184/10000 * Rabs (r - rho)).
  { unfold Rdiv at 1. rewrite Rabs_mult, Rmult_comm. factors; [interval | apply atan_moves]. }
  assert (F : o = atan n / PI + atan r / PI - (atan r - atan rho) / PI) by (unfold o; rewrite Add; field; apply PI_neq0). set (g := (atan r - atan
    rho) / PI) in *.
  unfold angle_in_half_turns_float64.first_octant. fold v. destruct C as [(N0 & K0 & V0 & Wr & Wd)|(Wr & Wd & Z)].
  - assert (Q : rho = s / l) by (unfold rho; rewrite N0; f_equal; ring). assert (Bo : - (5/16 + 1/2^30) <= rho <= 5/16 + 1/2^30) by (both_ways Wr;
    lra). pose proof arctangent_relative rho Bo as E0. destruct (factor_of_ratio rho Bo) as [Bp Fo]. rewrite Fo, Q in E0. fold o in E0. rewrite Q in Bp,
    Wr, Wd.
    pose proof factor_near y x Br as E2. fold r in E2. pose proof arctangent_relative r Br as E4. destruct (factor_of_ratio r Br) as [Br' Fr]. rewrite Fr
      in E4. unfold angle_in_half_turns_float64.small_part. fold k r. set (f := rounded (_ + _)) in *. set (p := _ + _) in Br', E2, E4. set (p' := _ +
      _) in Bp, E0.
    rewrite V0, K0, !Rplus_0_l, !(kept _ (rounded_is_float64 _)). pose proof one_rounding (r * f) as E1. rewrite N0, atan_0 in F. unfold Rdiv at 1 in F.
      rewrite Rmult_0_l, Rplus_0_l in F.
    assert (M1 : Rabs (r * f - r * p) <= Rabs r * (38/100 / 2 ^ 53)) by (rewrite <- Rmult_minus_distr_l, Rabs_mult; apply Rmult_le_compat_l; [apply
      Rabs_pos | exact E2]).
    assert (M2 : Rabs (r * p) <= Rabs r * (3184/10000)) by (rewrite Rabs_mult, (Rabs_pos_eq p) by lra; apply Rmult_le_compat_l; [apply Rabs_pos | lra]).
    assert (M3 : 307/1000 * (s / l) <= s / l * p') by (rewrite Rmult_comm; apply Rmult_le_compat_l; lra). pose proof Rabs_triang_inv (r * f) (r *
      p) as M4. pose proof Rabs_triang_inv r (s / l) as M5. rewrite Q in Er, E3. rewrite (Rabs_pos_eq (s / l)) in * by lra.
    set (a := s / l) in *. set (R := Rabs r) in *. set (q := rounded (r * f)) in *. set (e := Rabs (r * f)) in *. set (w := Rabs (r - a)) in *. assert
      (M6 : e <= R * (38/100 / 2 ^ 53) + R * (3184/10000)) by lra. both_ways E0. both_ways M1. both_ways E1. both_ways E3. both_ways E4.
    assert (G : Rabs (q - o) <= 13/10 / 2 ^ 53 * a + 4 * bpow radix2 (-1074)) by (clearbody a R q e w g o p p'; apply Rabs_le; lra). clearbody a. lra.
  - assert (Q : Rabs r <= 1821/10000) by (generalize (Rabs_triang_inv r rho); lra). assert (Qr : -183/1000 <= r <= 183/1000) by (both_ways Q; lra).
    pose proof small_part_rounded y x Br _ Q ltac:(lra) K as E1. pose proof arctangent_nearer r Qr as E2. fold r k in E1. set (m :=
    angle_in_half_turns_float64.small_part y x) in *.
    assert (E : Rabs (v + m - o) <= 37/100 / 2 ^ 53) by (both_ways E1; both_ways E2; both_ways E3; both_ways A; apply Rabs_le; lra).
    assert (Ol : 962/10000 <= o).
    { apply Rle_trans with (atan (312/1000) / PI); [interval|]. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, PI_RGT_0 | apply atan_rises;
      apply -> Rle_div_r; lra]. }
    pose proof one_rounding (v + m) as E4. pose proof Rabs_triang_inv (v + m) o as E5. rewrite (Rabs_pos_eq o) in E5 by lra. pose proof through _ _ _ _
      _ E4 E as G. lra.
Qed.
(* The octant, of the exact angle and of the computed one. *)
Lemma octants : let o := atan (s / l) / PI in let q := if Rlt_dec (Rabs x) (Rabs y) then 1/2 - o else o in let h := if Rlt_dec x 0 then 1 - q else q
  in atan2pi y x = if Rlt_dec y 0 then - h else h.
Proof.
  destruct sides as (_ & _ & _ & L). pose proof Rabs_pos x as Px. pose proof Rabs_pos y as Py. unfold l, s, angle_in_half_turns_float64.larger,
    angle_in_half_turns_float64.smaller in *. cbv zeta. unfold atan2pi, atan2. destruct (Req_EM_T x 0) as [Z|Z].
  - rewrite Z, Rabs_R0, Rmax_right, Rmin_left in * by lra. unfold Rdiv. rewrite !Rmult_0_l, atan_0. revert L. unfold Rabs. destruct Rcase_abs; intro;
    repeat destruct Rlt_dec; try lra; field; apply PI_neq0.
  - pose proof Rabs_pos_lt x Z as Z'. assert (Q : atan (Rabs y / Rabs x) / PI = if Rlt_dec (Rabs x) (Rabs y) then 1/2 - atan (Rmin (Rabs x) (Rabs y) /
    Rmax (Rabs x) (Rabs y)) / PI else atan (Rmin (Rabs x) (Rabs y) / Rmax (Rabs x) (Rabs y)) / PI).
    { destruct Rlt_dec; [rewrite Rmin_left, Rmax_right by lra | rewrite Rmin_right, Rmax_left by lra; reflexivity].
      replace (Rabs y / Rabs x) with (/ (Rabs x / Rabs y)) by (field; lra). rewrite atan_inv by (apply Rdiv_lt_0_compat; lra). field. apply PI_neq0. }
    rewrite <- Q.
    assert (A : forall a b, atan (- a / b) = - atan (a / b)) by (intros a b; rewrite <- atan_opp; f_equal; unfold Rdiv; ring).
    assert (A' : forall a b, b <> 0 -> atan (a / - b) = - atan (a / b)) by (intros a b H; rewrite <- atan_opp; f_equal; field; lra).
    unfold Rabs; destruct (Rcase_abs x); destruct (Rcase_abs y); repeat destruct Rlt_dec; try destruct Rle_dec; try lra; rewrite ?A', ?A,
      ?Ropp_involutive by lra; field; apply PI_neq0.
Qed.
Lemma angle_near : let d := Rabs (angle_in_half_turns_float64.angle y x - atan2pi y x) in d <= 5/2 * (1 / 2 ^ 53) /\ d <= 49/10 / 2 ^ 53 * Rabs
  (atan2pi y x) + 2 ^ 4 * bpow radix2 (-1074).
Proof.
  destruct first_octant_near as (E & E' & B). rewrite octants. unfold angle_in_half_turns_float64.angle, angle_in_half_turns_float64.half_plane,
    angle_in_half_turns_float64.first_quadrant.
  set (o := atan (s / l) / PI) in *. set (oh := angle_in_half_turns_float64.first_octant y x) in *. pose proof underflow_is_less as U.
  assert (Q : forall a b c, 0 <= c - b -> Rabs (rounded (c - a) - (c - b)) <= / 2 ^ 53 * (c - b + Rabs (a - b)) + bpow radix2 (-1074) + Rabs (a - b)).
  { intros a b c H. assert (M : Rabs (c - a - (c - b)) <= Rabs (a - b)) by (rewrite <- Rabs_Ropp; apply Req_le; f_equal; ring). apply through with (c
    - a); [|exact M]. at_most_by one_rounding. generalize (Rabs_triang_inv (c - a) (c - b)). rewrite (Rabs_pos_eq (c - b)) by exact H.
    lra. }
  set (q := if Rlt_dec (Rabs x) (Rabs y) then 1/2 - o else o). set (qh := if Rlt_dec (Rabs x) (Rabs y) then _ else oh).
  assert (Eq : Rabs (qh - q) <= 136/100 / 2 ^ 53 /\ Rabs (qh - q) <= 49/10 / 2 ^ 53 * q + 8 * bpow radix2 (-1074) /\ 0 <= q <= 1/2).
  { unfold qh, q. destruct Rlt_dec; [|lra]. generalize (Q oh o (1/2) ltac:(lra)). lra. }
  clearbody q qh. pose proof Q qh q 1 ltac:(lra) as Eh. cbv zeta. assert (F : forall a b, Rabs (- a - - b) = Rabs (a - b)) by (intros; rewrite <-
    Rabs_Ropp; f_equal; ring).
  repeat destruct Rlt_dec; rewrite ?F, ?Rabs_Ropp, ?(Rabs_pos_eq q), ?(Rabs_pos_eq (1 - q)) by lra; lra.
Qed.
End angle.

(* The angle of a point whose coordinates float64 holds, the larger of them not near underflow, is within 5/2 2^-53 of the angle; *)
Theorem elementary_functions__atan2pi y x : float64 y -> float64 x -> bpow radix2 (-1018) <= Rmax (Rabs x) (Rabs y) -> Rabs
  (angle_in_half_turns_float64.angle y x - atan2pi y x) <= 5/2 * (1 / 2 ^ 53).
Proof. apply angle_near. Qed.
(* of the origin it is 0. *)
Lemma no_octant y x : Rmin (Rabs x) (Rabs y) = 0 -> angle_in_half_turns_float64.first_octant y x = 0.
Proof.
  intro Z. unfold angle_in_half_turns_float64.first_octant, angle_in_half_turns_float64.small_part.
  (* its polynomial is left as it is: written out, it takes long *)
  set (tail := angle_in_half_turns_float64.arctangent_tail y x). clearbody tail. angle_in_half_turns_float64.lines. rewrite Z. pose proof
    Rle_trans _ _ _ (Rabs_pos x) (Rmax_l (Rabs x) (Rabs y)) as L. set (l := Rmax _ _) in *.
  pose proof not_negative_rounded (5 / 16 * l) ltac:(lra). pose proof not_negative_rounded (3 / 4 * l) ltac:(lra). repeat destruct Rlt_dec; try lra;
    unfold Rdiv; repeat progress rewrite ?Rmult_0_r, ?Rmult_0_l, ?Rminus_0_r, ?Rplus_0_l, ?rounded_0; reflexivity.
Qed.
Theorem elementary_functions__origin : angle_in_half_turns_float64.angle 0 0 = 0.
Proof.
  unfold angle_in_half_turns_float64.angle, angle_in_half_turns_float64.half_plane, angle_in_half_turns_float64.first_quadrant. rewrite no_octant by
    (rewrite Rabs_R0; apply Rmin_left, Rle_refl). repeat destruct Rlt_dec; lra.
Qed.
Lemma side_of_1 x y : Rabs x = 1 \/ Rabs y = 1 -> bpow radix2 (-1018) <= Rmax (Rabs x) (Rabs y).
Proof. intros [-> | ->]; eapply Rle_trans; [| apply Rmax_l | | apply Rmax_r]; apply (bpow_le radix2 (-1018) 0); easy. Qed.
Theorem elementary_functions__atan2pi__point : exists y x, float64 y /\ float64 x /\ bpow radix2 (-1018) <= Rmax (Rabs x) (Rabs y).
Proof.
  exists 0, 1. exact (conj (generic_format_0 _ _) (conj one_is_float64 (side_of_1 1 0 (or_introl Rabs_R1)))).
Qed.
Theorem elementary_functions__atan2pi__false : ~ forall y x, float64 y -> float64 x -> bpow radix2 (-1018) <= Rmax (Rabs x) (Rabs y) -> Rabs
  (angle_in_half_turns_float64.angle y x - atan (y / x) / PI) <= 5/2 * (1 / 2 ^ 53).
Proof.
  intro H. assert (F := generic_format_opp _ _ _ one_is_float64 : float64 (-1)).
  pose proof side_of_1 (-1) 0 (or_introl Rabs_m1) as M.
  generalize (H 0 (-1) (generic_format_0 _ _) F M) (elementary_functions__atan2pi 0 (-1) (generic_format_0 _ _) F M).
  unfold atan2pi, atan2. repeat destruct Rlt_dec; try lra. destruct Rle_dec; try lra. unfold Rdiv. rewrite Rmult_0_l, atan_0, Rmult_0_l, Rplus_0_l,
    Rinv_r by apply PI_neq0.
  intros A B. both_ways A. both_ways B. lra.
Qed.
Theorem elementary_functions__origin__false : ~ forall y, float64 y -> angle_in_half_turns_float64.angle y 0 = 0.
Proof.
  intro H. pose proof one_is_float64 as F.
  generalize (elementary_functions__atan2pi 1 0 F (generic_format_0 _ _) (side_of_1 0 1 (or_intror Rabs_R1))). rewrite (H 1 F). unfold atan2pi, atan2. repeat
    destruct Rlt_dec; try lra.
  replace (0 - PI / 2 / PI) with (- (1/2)) by (field; apply PI_neq0). rewrite Rabs_Ropp, Rabs_pos_eq; lra.
Qed.
