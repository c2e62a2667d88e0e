(* What float64 loses between the gradient and the colour: the bumped normal, the light's cosine, a light's share, the clip. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Formal Require Import Formulas Float Float64 RoundedHalfTurns Rounding RoundedAngle RoundedExponential EnclosingRules Shading.
Open Scope R_scope.

Lemma within_length x L : 0 <= L -> x * x <= L * L -> Rabs x <= L.
Proof. intros. apply less_of_squares; [lra | unfold Rabs; destruct Rcase_abs; lra]. Qed.
(* What is rounded at the scale S, far above what underflows, is S times what is rounded at the scale 1. *)
Lemma at_scale S x X : 1 / 2 ^ 600 <= S -> Rabs x <= X -> exists y, rounded (S * x) = S * y /\ Rabs (y - x) <= X / 2 ^ 53 + 1 / 2 ^ 100.
Proof.
  intros L B. assert (P : 0 < S) by lra. assert (underflow <= 1 / 2 ^ 700) by (rewrite inverse_power; apply bpow_le; easy).
  exists (rounded (S * x) / S). split; [field; lra|]. replace (_ - x) with ((rounded (S * x) - S * x) / S) by (field; lra). apply over_length; auto.
  at_most_by rounding_error. rewrite Rabs_mult, Rabs_pos_eq by lra. apply Rmult_le_compat_r with (r := S) in B; in_units.
Qed.

(* A component h near that of the formulas, m, of a vector of length 1. *)
Definition near_unit (h m : R) := Rabs (h - m) <= 12 * unit53 /\ Rabs m <= 1.
(* A vector over its length, as float64 carries it out, of components that are off by 9/4 roundings of the length. *)
Section normalised.
Variables m1 m2 m3 h1 h2 h3 L : R.
Hypothesis LL : L * L = m1 * m1 + m2 * m2 + m3 * m3.
Hypothesis low : 1 / 2 ^ 20 <= L.
Lemma components_short : m1 * m1 <= L * L /\ m2 * m2 <= L * L /\ m3 * m3 <= L * L.
Proof. nra. Qed.
Lemma component_of_unit m : m * m <= L * L -> Rabs (/ L * m) <= 1.
Proof. intro. rewrite Rmult_comm. apply over_length; [lra|]. apply within_length; lra. Qed.
Hypothesis off_by_1 : Rabs (h1 - m1) <= 9/4 * unit53 * L.
Hypothesis off_by_2 : Rabs (h2 - m2) <= 9/4 * unit53 * L.
Hypothesis off_by_3 : Rabs (h3 - m3) <= 9/4 * unit53 * L.
Let q := rounded (rounded (rounded (h1 * h1) + rounded (h2 * h2)) + rounded (h3 * h3)).
Let r := rounded (sqrt q).
Let c := rounded (1 / r).
Lemma square_moved h m : Rabs (h - m) <= 9/4 * unit53 * L -> Rabs (h * h - m * m) <= unit53 * (39/10 * (m * m) + 13/10 * (L * L)).
Proof.
  intro E. both_ways E. assert ((h - m) * (h - m) <= 9/4 * unit53 * L * (9/4 * unit53 * L)) by nra.
  generalize (Rle_0_sqr L) (Rle_0_sqr (39/10 * unit53 * m - (h - m))) (Rle_0_sqr (39/10 * unit53 * m + (h - m))). unfold Rsqr. intros. sizes.
Qed.
Lemma square_of_length : Rabs (q - L * L) <= 111/10 * unit53 * (L * L).
Proof.
  assert (1 / 2 ^ 40 <= L * L) by nra. pose proof underflow_is_small. pose proof square_moved h1 m1 off_by_1. pose proof square_moved h2 m2 off_by_2.
    pose proof square_moved h3 m3 off_by_3.
  unfold q. rounds p1 (h1 * h1). rounds p2 (h2 * h2). rounds p3 (h3 * h3). rounds s (p1 + p2). rounds o (s + p3). sizes.
Qed.
Lemma length_rounded : L * (1 - 67/10 * unit53) <= r <= L * (1 + 67/10 * unit53).
Proof.
  pose proof square_of_length as Q. both_ways Q. pose proof underflow_is_small.
  pose proof sqrt_sqrt q as W. pose proof sqrt_pos q. unfold r. set (w := sqrt q) in *.
  assert (w <= L * (1 + 56/10 * unit53)) by (apply less_of_squares; in_units).
  assert (L * (1 - 56/10 * unit53) <= w) by (apply less_of_squares; [lra | rewrite W; unfold unit53 in *; nra]).
  pose proof counted w. in_units.
Qed.
Hypothesis high : L <= 2 ^ 450.
Lemma scale_of_length : Rabs (c * L - 1) <= 8 * unit53.
Proof.
  pose proof length_rounded. unfold c. assert (0 < r) by in_units. assert (Rabs (L / r - 1) <= 68/10 * unit53) by (replace (_ - 1) with ((L - r) / r)
    by (field; lra); apply over_length; sizes).
  replace (1 / r) with (/ L * (L / r)) by (field; lra). destruct (at_scale (/ L) (L / r) (1 + 68/10 * unit53)) as (y & -> & E); [apply Rmult_le_reg_r
    with L; [|rewrite Rinv_l]; lra | sizes|].
  replace (_ * _) with y by (field; lra). sizes.
Qed.
Lemma component_normalised h m : Rabs (h - m) <= 9/4 * unit53 * L -> m * m <= L * L -> near_unit (rounded (c * h)) (/ L * m).
Proof.
  intros E M. pose proof component_of_unit m M as X. split; auto. assert (Y : Rabs (/ L * h - / L * m) <= 9/4 * unit53) by (replace (_ - _) with ((h
    - m) / L) by lra; apply over_length; lra).
  replace (c * h) with (c * L * (/ L * h)) by (field; lra). replace (/ L * m) with (1 * (/ L * m)) by ring. eapply Rle_trans; [apply (times_error _ _
    _ _ 1 1 _ _ ltac:(rewrite Rabs_R1; lra) X scale_of_length Y) | in_units].
Qed.
Lemma direction_rounded : near_unit (rounded (c * h1)) (/ L * m1) /\ near_unit (rounded (c * h2)) (/ L * m2) /\ near_unit (rounded (c * h3)) (/ L * m3).
Proof. destruct components_short as (? & ? & ?). split; [|split]; apply component_normalised; assumption. Qed.
End normalised.

(* The length L of a vector (x, y, z), in the goal, too. *)
Ltac of_length x y z := set (v := x * x + y * y + z * z); replace (x ^ 2 + y ^ 2 + z ^ 2) with v by (unfold v; ring); assert (V : 1 / 2 ^ 40 <= v <= 2
  ^ 900) by (unfold v; lra);
  set (L := sqrt v); assert (LL : L * L = v) by (apply sqrt_sqrt; lra); assert (L1 : 1 / 2 ^ 20 <= L) by (rewrite <- (sqrt_square (1 / 2 ^ 20)) by
    lra; apply sqrt_le_1_alt; lra);
  assert (Lu : L <= 2 ^ 450) by (apply less_of_squares; [apply pow_le; lra | rewrite LL, <- pow_add; apply V]); destruct (components_short x y z L LL)
    as (Sx & Sy & Sz).
Lemma not_moved h L : 1 / 2 ^ 20 <= L -> Rabs (h - h) <= 9/4 * unit53 * L.
Proof. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. in_units. Qed.
Lemma component_rounded b g n L : 1 / 2 ^ 20 <= L -> (b * g) * (b * g) <= L * L -> (b * g + n) * (b * g + n) <= L * L -> Rabs (rounded (rounded (b
  * g) + n) - (b * g + n)) <= 9/4 * unit53 * L.
Proof.
  intros L1 G M. apply within_length in G; [|lra]. apply within_length in M; [|lra]. eapply Rle_trans; [apply (sum_error _ _ _ _ _ M (rounded_error _
    _ G)) | in_units].
Qed.
(* The bumped normal and the light's direction: near those of the formulas, which are no longer than 1. *)
Lemma normal_near nx ny nz gx gy gz b : let m2 := (b * gx + nx) ^ 2 + (b * gy + ny) ^ 2 + (b * gz + nz) ^ 2 in 1 <= m2 <= 2 ^ 900 -> (b * gx) ^ 2
  <= m2 -> (b * gy) ^ 2 <= m2 -> (b * gz) ^ 2 <= m2 -> near_unit (perturbed_float64.bumped_x nx ny nz gx gy gz b) (perturbed.bumped_x nx ny nz gx
  gy gz b) /\ near_unit (perturbed_float64.bumped_y nx ny nz gx gy gz b) (perturbed.bumped_y nx ny nz gx gy gz b) /\ near_unit
  (perturbed_float64.bumped_z nx ny nz gx gy gz b) (perturbed.bumped_z nx ny nz gx gy gz b).
Proof.
  intros m2 M Bx By Bz. unfold m2 in *. perturbed.lines. of_length (b * gx + nx) (b * gy + ny) (b * gz + nz).
  apply direction_rounded; try apply component_rounded; unfold v in *; lra.
Qed.
Lemma towards_near px py pz lx ly lz : let d2 := (lx - px) ^ 2 + (ly - py) ^ 2 + (lz - pz) ^ 2 in / 1099511627776 <= d2 <= 2 ^ 900 -> near_unit
  (light_direction_float64.towards_x px py pz lx ly lz) (light_direction.towards_x px py pz lx ly lz) /\ near_unit
  (light_direction_float64.towards_y px py pz lx ly lz) (light_direction.towards_y px py pz lx ly lz) /\ near_unit
  (light_direction_float64.towards_z px py pz lx ly lz) (light_direction.towards_z px py pz lx ly lz).
Proof.
  intros d2 D. unfold d2 in *. light_direction.lines. of_length (lx - px) (ly - py) (lz - pz).
  apply direction_rounded; try assumption; (eapply Rle_trans; [apply (rounded_error _ L), within_length; lra | in_units]).
Qed.
Theorem colour_accuracy__normal : Statements.colour_accuracy__normal.
Proof. red. intros. destruct (normal_near normal_x normal_y normal_z g_x g_y g_z beta) as ([] & [] & []); try lra. in_units. Qed.
(* The highlight's base: Phong's is made of sums and products, *)
Ltac sums := lazymatch goal with
  | |- Rabs (rounded (_ + _) - (_ + _)) <= _ => eapply both_error; [find_bound | sums | sums]
  | |- Rabs (rounded (_ - _) - (_ - _)) <= _ => eapply difference_error; [find_bound | sums | sums]
  | |- Rabs (rounded (_ * _) - _ * _) <= _ => eapply Rle_trans; [eapply times_error; [find_bound | find_bound | sums | sums] | find_bound]
  | |- _ => first [eassumption | apply no_error] end.
Theorem colour_accuracy__phong : Statements.colour_accuracy__phong.
Proof. red. intros. at_most_by clamp_is_lipschitz. eapply Rle_trans; [sums | interval]. Qed.
(* The product of a normal and a vector of that length, of any length. *)
Lemma along_rounded nx ny nz hx hy hz L : 1 / 2 ^ 20 <= L -> hx * hx <= L * L -> hy * hy <= L * L -> hz * hz <= L * L -> Rabs nx <= /
  1099511627776 + 1 -> Rabs ny <= / 1099511627776 + 1 -> Rabs nz <= / 1099511627776 + 1 -> let d := rounded (rounded (rounded (nx * hx) + rounded
  (ny * hy)) + rounded (nz * hz)) in let e := nx * hx + ny * hy + nz * hz in Rabs (d - e) <= 81/10 * unit53 * L /\ Rabs e <= 301/100 * L.
Proof.
  intros L1 Sx Sy Sz Bx By Bz. assert (P : forall n h, Rabs n <= / 1099511627776 + 1 -> h * h <= L * L -> Rabs (n * h) <= 1001/1000 * L) by (intros n
    h N S; apply within_length in S; [rewrite Rabs_mult; factors |]; lra).
  pose proof P nx hx Bx Sx as Gx. pose proof P ny hy By Sy as Gy. pose proof P nz hz Bz Sz as Gz. split; [|sizes].
  eapply Rle_trans; [apply (both_error _ _ _ _ (301/100 * L)); [sizes | apply (both_error _ _ _ _ (201/100 * L)); [sizes | apply (rounded_error _ _
    Gx) | apply (rounded_error _ _ Gy)] | apply (rounded_error _ _ Gz)] | in_units].
Qed.
(* and Blinn's divides by a length. *)
Theorem colour_accuracy__blinn : Statements.colour_accuracy__blinn.
Proof.
  intros nx ny nz hx hy hz _ _ _ _ _ _ low high Bx By Bz. blinn_highlight_float64.lines; blinn_highlight.lines. of_length hx hy hz.
  pose proof length_rounded hx hy hz hx hy hz L LL L1 (not_moved hx L L1) (not_moved hy L L1) (not_moved hz L L1). set (l := rounded _) in *. assert
    (l0 : 0 < l) by in_units.
  destruct Rlt_dec as [_|N]; [|contradiction]. destruct (Rlt_dec 0 L) as [_|N]; [|lra]. rewrite (Rmax_comm _ 0).
    at_most_by clamp_is_lipschitz.
  destruct (along_rounded nx ny nz hx hy hz L L1 Sx Sy Sz Bx By Bz) as [D G]. set (d := rounded (_ + rounded (nz * hz))) in *. set (g := nx * hx + ny
    * hy + nz * hz) in *.
  pose proof over_length g _ L ltac:(lra) G as B. assert (Y : Rabs (d / l - g / L) <= 285/10 * unit53).
  { replace (d / l - g / L) with ((d - g - g / L * (l - L)) / l) by (field; lra). apply over_length; [exact l0|]. assert (E : Rabs (g / L * (l - L))
    <= 301/100 * (67/10 * unit53 * L)) by (rewrite Rabs_mult; factors; [exact B | apply Rabs_le; lra]). set (x := g / L * _) in *. sizes. }
  eapply Rle_trans; [exact (through _ _ _ _ _ (rounded_error _ _ (size _ _ _ _ B Y)) Y) | in_units].
Qed.
(* Its square divides by a square, and by a distance with which it was multiplied. *)
Theorem colour_accuracy__squared : Statements.colour_accuracy__squared.
Proof.
  intros nx ny nz hx hy hz d _ _ _ _ _ _ _ low high dl dh Bx By Bz. squared_highlight_float64.lines; squared_highlight.lines. of_length hx hy hz.
  pose proof square_of_length hx hy hz hx hy hz L LL L1 (not_moved hx L L1) (not_moved hy L L1) (not_moved hz L L1) as Q. destruct (along_rounded nx
    ny nz hx hy hz L L1 Sx Sy Sz Bx By Bz) as [D _].
  assert ((nx * hx + ny * hy + nz * hz) * (nx * hx + ny * hy + nz * hz) <= 30001/10000 * v).
  { assert (S : forall n, Rabs n <= / 1099511627776 + 1 -> n * n <= 1 + 1 / 2 ^ 30) by (intros n N; both_ways N; nra). apply Rle_trans with ((nx * nx
    + ny * ny + nz * nz) * v); [|apply Rmult_le_compat_r; [lra | generalize (S _ Bx) (S _ By) (S _ Bz); lra]].
    unfold v. generalize (Rle_0_sqr (nx * hy - ny * hx)) (Rle_0_sqr (nx * hz - nz * hx)) (Rle_0_sqr (ny * hz - nz * hy)). unfold Rsqr. lra. }
  rewrite LL in Q. set (h := rounded (_ + rounded (hz * hz))) in *. set (e := nx * hx + ny * hy + nz * hz) in *. pose proof Rle_trans _ _ _
    (clamp_is_lipschitz _ e) D as M. set (A := Rmax 0 (rounded _)) in *.
  assert (B2 : 0 <= Rmax 0 e /\ Rmax 0 e * Rmax 0 e <= 30001/10000 * v) by (unfold Rmax; destruct Rle_dec; lra). set (B := Rmax 0 e) in *. set (X :=
    v * d). clearbody h A B. assert (Vu : v <= 2 ^ 400) by (unfold v; lra).
  assert (h0 : 0 < h) by sizes. destruct (Rlt_dec 0 h) as [_|N]; [|contradiction]. destruct (Rlt_dec 0 v) as [_|N]; [|lra].
  assert (Xl : 1 / 2 ^ 60 <= X) by (apply Rle_trans with (1 / 2 ^ 40 * / 1048576); [lra | apply Rmult_le_compat; lra]). assert (Xu : X <= 2 ^ 600) by
    (change 600%nat with (400 + 200)%nat; rewrite pow_add; apply Rmult_le_compat; lra).
  set (a := A / L). set (b := B / L). assert (b2 : B * B = v * (b * b)) by (unfold b; rewrite <- LL; field; lra). assert (bb : 0 <= b * b <=
    30001/10000) by (split; [exact (Rle_0_sqr b) | apply Rmult_le_reg_l with v; lra]).
  assert (b1 : 0 <= b <= 1733/1000) by (split; [apply Rdiv_le_0_compat | apply less_of_squares]; lra).
  assert (F : Rabs (a - b) <= 81/10 * unit53) by (unfold a, b; replace (_ - _) with ((A - B) / L) by (field; lra); apply over_length; lra).
  replace (A * A) with (v * (a * a)) by (unfold a; rewrite <- LL; field; lra). replace (B ^ 2 * d * (1 / X)) with (b * b * 1) by (unfold X; replace
    (B ^ 2) with (B * B) by ring; rewrite b2; field; lra).
  assert (F2 : Rabs (a * a - b * b) <= 283/10 * unit53) by (replace (a * a - b * b) with ((2 * b + (a - b)) * (a - b)) by ring; set (o := a - b) in
    *; unfold unit53 in *; interval).
  destruct (at_scale v (a * a) (30002/10000)) as (p & -> & P); [lra | sizes|]. replace (v * p * d) with (X * p) by (unfold X; ring). destruct
    (at_scale X p (30003/10000)) as (y & -> & Y); [lra | sizes|].
  assert (N : Rabs (h / v - 1) <= 111/10 * unit53) by (replace (_ - 1) with ((h - v) / v) by (field; lra); apply over_length; lra). replace (h * d)
    with (X * (h / v)) by (unfold X; field; lra). destruct (at_scale X (h / v) (101/100)) as (q & -> & E); [lra | sizes|]. assert (q0 : 0 < q) by
      sizes. assert (J : Rabs (1 / q - 1) <= 1213/100 * unit53) by (replace (_ - 1) with ((1 - q) / q) by (field; lra); apply over_length; [exact q0
        | sizes]).
  replace (1 / (X * q)) with (/ X * (1 / q)) by (field; lra). destruct (at_scale (/ X) (1 / q) (101/100)) as (k & -> & K); [unfold Rdiv; rewrite
    Rmult_1_l; apply Rinv_le_contravar; lra | sizes|].
  replace (X * y * (/ X * k)) with (y * k) by (field; lra). eapply Rle_trans; [apply (times_error _ _ _ _ (30001/10000) 1 (345/10 * unit53) (132/10 *
    unit53)); sizes | in_units].
Qed.
Theorem colour_accuracy__cosine : Statements.colour_accuracy__cosine.
Proof.
  red. intros. destruct (towards_near point_x point_y point_z light_x light_y light_z) as ([] & [] & []); [simpl; lra|].
  unfold light_direction_float64.mu, light_direction.mu. unfold unit53 in *. eapply Rle_trans; [sums | interval].
Qed.

(* x is within n roundings of a share X, which is not negative, and t times what underflows. *)
Definition near_share (n t X x : R) := 0 <= X /\ 0 <= t /\ Rabs (x - X) <= n * unit53 * X + t * underflow.
Lemma share_exact X : 0 <= X -> near_share 0 0 X X.
Proof. intro P. repeat split; try lra. at_most_by no_error; lra. Qed.
Lemma share_rounded n t X x : near_share n t X x -> 0 <= n <= 8 -> near_share (n + 101/100) (2 * t + 1) X (rounded x).
Proof.
  intros (P & T & E) N. pose proof proj1 underflow_in_least as U. pose proof size X x X _ ltac:(rewrite Rabs_pos_eq; lra) E as S. assert (n * X <= 8 * X)
    by (apply Rmult_le_compat_r; lra). assert (0 <= t * underflow) by (apply Rmult_le_pos; lra).
  repeat split; [exact P | lra |]. eapply Rle_trans; [exact (through _ _ _ _ _ (rounding_error x) E) | in_units].
Qed.
Lemma share_sum n t X x m s Y y : near_share n t X x -> near_share m s Y y -> 0 <= n -> 0 <= m -> near_share (n + m) (t + s) (X + Y) (x + y).
Proof.
  intros (P & T & E) (Q & S & F) N M. assert (0 <= n * Y) by (apply Rmult_le_pos; assumption). assert (0 <= m * X) by (apply Rmult_le_pos;
    assumption). repeat split; try lra. sizes.
Qed.
Lemma share_times a n t X x : near_share n t X x -> 0 <= a <= 2 ^ 20 -> near_share n (2 ^ 20 * t) (a * X) (a * x).
Proof.
  intros (P & T & E) A. pose proof proj1 underflow_in_least as U. repeat split; [apply Rmult_le_pos; lra | lra |]. rewrite <- Rmult_minus_distr_l,
    Rabs_mult, (Rabs_pos_eq a) by lra.
  apply (Rmult_le_compat_l a) in E; [|lra]. assert (a * (t * underflow) <= 2 ^ 20 * (t * underflow)) by (apply Rmult_le_compat_r; [apply
    Rmult_le_pos|]; lra). lra.
Qed.
Ltac shares := lazymatch goal with
  | |- near_share _ _ ?X ?X => apply share_exact
  | |- near_share _ _ _ (rounded _) => eapply share_rounded; [shares|]
  | |- near_share _ _ _ (_ + _) => eapply share_sum; [shares | shares | |]
  | |- near_share _ _ _ (_ * _) => eapply share_times; [shares|] end.
Lemma share_within b i a kd ks w p : b >= 0 -> i >= 0 -> a >= 0 -> kd >= 0 -> ks >= 0 -> 0 <= w -> p >= 0 -> i <= 2 ^ 20 -> a <= 2 ^ 20 -> Rabs
  (rounded (rounded (i * rounded (rounded (a * rounded (kd * w)) + rounded (ks * p))) + b) - (i * (a * (kd * w) + ks * p) + b)) <= 8 /
  9007199254740992 * (i * (a * kd * w + ks * p) + b) + / 1000000000000000000000000000000.
Proof.
  intros. rewrite (Rmult_assoc a). pose proof underflow_is_small as T. assert (Q : 0 <= i * (a * (kd * w) + ks * p)) by (repeat (apply Rmult_le_pos ||
    apply Rplus_le_le_0_compat); lra).
  eapply Rle_trans; [refine (proj2 (proj2 (_ : near_share _ _ _ _))); shares; try apply Rmult_le_pos; lra | in_units].
Qed.
Theorem colour_accuracy__share_red : Statements.colour_accuracy__share_red.
Proof. red. intros. apply share_within; try assumption. apply Rmax_l. Qed.
Theorem colour_accuracy__share_green : Statements.colour_accuracy__share_green.
Proof. intros b. intros. unfold light_term_float64.lit_green, light_term.lit_green. rewrite !(Rplus_comm b). apply share_within; try assumption.
  apply Rmax_l. Qed.
Theorem colour_accuracy__share_blue : Statements.colour_accuracy__share_blue.
Proof. intros b. intros. unfold light_term_float64.lit_blue, light_term.lit_blue. rewrite !(Rplus_comm b). apply share_within; try assumption.
  apply Rmax_l. Qed.
Theorem colour_accuracy__clip : Statements.colour_accuracy__clip.
Proof. red. intros. unfold clip_float64.clipped, clip.clipped. apply no_error. Qed.

(* Composed: from the frame, the gradient and the light to the colour, one light's share without another stage's input in between. *)

(* A cosine that moves by e moves a light's share by at most i a k_d e. *)
Lemma share_moves b i a kd ks p m n e : i >= 0 -> a >= 0 -> kd >= 0 -> Rabs (m - n) <= e -> Rabs (light_term.lit_red b i a kd ks m p -
  light_term.lit_red b i a kd ks n p) <= i * (a * kd * e).
Proof.
  intros I A K E. light_term.lines. replace (_ - _) with (i * (a * kd * (Rmax 0 m - Rmax 0 n))) by ring. rewrite !Rabs_mult, !Rabs_pos_eq by lra.
  apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]. at_most_by clamp_is_lipschitz; exact E.
Qed.
Lemma composed_colour nx ny nz gx gy gz beta px py pz lx ly lz b i a kd ks p : let m2 := (beta * gz + nz) * (beta * gz + nz) + (beta *
  gx + nx) * (beta * gx + nx) + (beta * gy + ny) * (beta * gy + ny) in let d2 := (lz - pz) * (lz - pz) + (lx - px) * (lx - px) + (ly - py) * (ly -
  py) in let mu' := light_direction_float64.mu px py pz lx ly lz (perturbed_float64.bumped_x nx ny nz gx gy gz beta) (perturbed_float64.bumped_y
  nx ny nz gx gy gz beta) (perturbed_float64.bumped_z nx ny nz gx gy gz beta) in let mu := light_direction.mu px py pz lx ly lz
  (perturbed.bumped_x nx ny nz gx gy gz beta) (perturbed.bumped_y nx ny nz gx gy gz beta) (perturbed.bumped_z nx ny nz gx gy gz beta) in m2 >= 1
  -> m2 <= 2 ^ 900 -> (beta * gx) ^ 2 <= m2 -> (beta * gy) ^ 2 <= m2 -> (beta * gz) ^ 2 <= m2 -> d2 >= / 1099511627776 -> d2 <= 2 ^ 900 -> b >= 0
  -> i >= 0 -> a >= 0 -> kd >= 0 -> ks >= 0 -> p >= 0 -> i <= 2 ^ 20 -> a <= 2 ^ 20 -> Rabs (mu' - mu) <= 81 * unit53 /\ Rabs
  (clip_float64.clipped (light_term_float64.lit_red b i a kd ks mu' p) - clip.clipped (light_term.lit_red b i a kd ks mu p)) <= 8 /
  9007199254740992 * (i * (a * kd * Rmax 0 mu' + ks * p) + b) + / 1000000000000000000000000000000 + i * (a * kd * (81 * unit53)).
Proof.
  intros m2 d2 mu' mu M1 M2 Bx By Bz D1 D2 B I A Kd Ks P Iu Au. assert (M : Rabs (mu' - mu) <= 81 * unit53).
  { destruct (normal_near nx ny nz gx gy gz beta) as ([] & [] & []); try (unfold m2 in *; simpl; lra). destruct (towards_near px py pz lx ly lz) as
    ([] & [] & []); [unfold d2 in *; simpl; lra|].
    unfold mu', mu, light_direction_float64.mu, light_direction.mu. unfold unit53 in *. eapply Rle_trans; [sums | interval]. }
  split; [exact M|]. change clip_float64.clipped with clip.clipped. at_most_by difference_bound_clip. apply through with (light_term.lit_red b i
    a kd ks mu' p); [apply share_within; try assumption; apply Rmax_l | apply share_moves; assumption].
Qed.
