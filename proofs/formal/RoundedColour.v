(* What float64 loses between the gradient and the colour: the bumped normal, the light's cosine, a light's share, the clip. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Relative.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Float Float64 RoundedHalfTurns Rounding RoundedAngle RoundedExponential EnclosingRules.
From Formal Require Statements.
Open Scope R_scope.

Lemma within_length (x L : R) : 0 <= L -> x * x <= L * L -> Rabs x <= L.
Proof. intros P S. apply less_of_squares; [exact P | unfold Rabs; destruct Rcase_abs; lra]. Qed.
Lemma over_length (x e L : R) : 0 < L -> Rabs x <= e * L -> Rabs (x / L) <= e.
Proof. intros P X. unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq L) by lra. apply Rmult_le_reg_r with L; [exact P|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. exact X. Qed.
Lemma length_at_least (v : R) : / 1099511627776 <= v -> 1 / 2 ^ 20 <= sqrt v.
Proof. intro P. rewrite <- (sqrt_square (1 / 2 ^ 20)) by lra. apply sqrt_le_1_alt. lra. Qed.
Lemma far_below : underflow * 2 ^ 600 <= 1 / 2 ^ 200.
Proof.
  replace (2 ^ 600) with (bpow radix2 600) by (change (bpow radix2 600) with (IZR (Z.pow_pos 2 600)); rewrite pow_IZR; reflexivity).
  unfold underflow. rewrite <- bpow_plus. replace (1 / 2 ^ 200) with (bpow radix2 (-200)) by (simpl; lra). apply bpow_le. easy.
Qed.
(* The inverse of a number that is a part e off. *)
Lemma inverse_rounded (q X e : R) : 0 <= e <= 20 * unit53 -> 1 / 2 ^ 60 <= X -> X <= 2 ^ 600 -> X * (1 - e) <= q <= X * (1 + e) -> Rabs (rounded (1 / q) * X - 1) <= e + 11/10 * unit53.
Proof.
  intros E L H B. assert (T := Rmult_le_compat_l _ _ _ (Rlt_le _ _ (proj1 underflow_in_least)) H). assert (F := far_below). assert (X * e <= X * (20 * unit53)) by (apply Rmult_le_compat_l; lra). assert (q0 : 0 < q) by in_units.
  assert (J : 1 / q * q = 1) by (field; lra). assert (0 < 1 / q) by (apply Rdiv_lt_0_compat; lra). rounds k (1 / q). set (j := 1 / q) in *. assert (j * (X * (1 - e)) <= j * q) by (apply Rmult_le_compat_l; lra). assert (j * q <= j * (X * (1 + e))) by (apply Rmult_le_compat_l; lra).
  assert ((j * (1 - unit53) - underflow) * X <= k * X) by (apply Rmult_le_compat_r; lra). assert (k * X <= (j * (1 + unit53) + underflow) * X) by (apply Rmult_le_compat_r; lra). assert (0 <= e * e <= 1 / 2 ^ 90) by (split; [is_not_negative | apply Rle_trans with (20 * unit53 * (20 * unit53)); [apply Rmult_le_compat; lra | in_units]]).
  assert (Y : 1 - e <= j * X <= 1 + e + 1 / 2 ^ 89) by (split; [apply Rmult_le_reg_r with (1 + e) | apply Rmult_le_reg_r with (1 - e)]; in_units). clearbody k. apply Rabs_le. in_units.
Qed.

(* A vector over its length, as float64 carries it out, of components that are off by 9/4 roundings of the length. *)
Section normalised.
Variables m1 m2 m3 h1 h2 h3 L : R.
Hypothesis LL : L * L = m1 * m1 + m2 * m2 + m3 * m3.
Hypothesis low : 1 / 2 ^ 20 <= L.
Hypothesis high : L <= 2 ^ 450.
Hypothesis off_by_1 : Rabs (h1 - m1) <= 9/4 * unit53 * L.
Hypothesis off_by_2 : Rabs (h2 - m2) <= 9/4 * unit53 * L.
Hypothesis off_by_3 : Rabs (h3 - m3) <= 9/4 * unit53 * L.
Let q := rounded (rounded (rounded (h1 * h1) + rounded (h2 * h2)) + rounded (h3 * h3)).
Let r := rounded (sqrt q).
Let c := rounded (1 / r).
Lemma square_moved (h m : R) : Rabs (h - m) <= 9/4 * unit53 * L -> Rabs (h * h - m * m) <= Rabs m * (9/2 * unit53 * L) + 6 * unit53 * unit53 * (L * L).
Proof.
  intro E. replace (h * h - m * m) with (2 * m * (h - m) + (h - m) * (h - m)) by ring. sizes_add. rewrite !Rabs_mult, (Rabs_pos_eq 2) by lra.
  assert (P := Rabs_pos (h - m)). assert (K : Rabs m * Rabs (h - m) <= Rabs m * (9/4 * unit53 * L)) by (apply Rmult_le_compat_l; [apply Rabs_pos | exact E]).
  assert (Q : Rabs (h - m) * Rabs (h - m) <= (9/4 * unit53 * L) * (9/4 * unit53 * L)) by (apply Rmult_le_compat; assumption). assert (0 <= L * L) by nra. in_units.
Qed.
Lemma square_of_length : Rabs (q - L * L) <= 111/10 * unit53 * (L * L).
Proof.
  assert (V : 1 / 2 ^ 40 <= L * L) by (apply Rle_trans with (1 / 2 ^ 20 * (1 / 2 ^ 20)); [lra | apply Rmult_le_compat; lra]). assert (T := underflow_is_small).
  assert (S1 := square_moved h1 m1 off_by_1). assert (S2 := square_moved h2 m2 off_by_2). assert (S3 := square_moved h3 m3 off_by_3).
  assert (W : (Rabs m1 + Rabs m2 + Rabs m3) * L <= 7/4 * (L * L)).
  { replace (7/4 * (L * L)) with (7/4 * L * L) by ring. apply Rmult_le_compat_r; [lra|]. apply less_of_squares; [lra|].
    assert (A : forall a, a * a = Rabs a * Rabs a) by (intro a; unfold Rabs; destruct Rcase_abs; ring). rewrite (A m1), (A m2), (A m3) in LL.
    assert (0 <= (Rabs m1 - Rabs m2) * (Rabs m1 - Rabs m2)) by apply Rle_0_sqr. assert (0 <= (Rabs m1 - Rabs m3) * (Rabs m1 - Rabs m3)) by apply Rle_0_sqr. assert (0 <= (Rabs m2 - Rabs m3) * (Rabs m2 - Rabs m3)) by apply Rle_0_sqr. nra. }
  both_ways S1. both_ways S2. both_ways S3.
  unfold q. rounds p1 (h1 * h1). rounds p2 (h2 * h2). rounds p3 (h3 * h3). rounds s (p1 + p2). rounds o (s + p3). clearbody p1 p2 p3 s o.
  assert (Cross : Rabs m1 * (9/2 * unit53 * L) + Rabs m2 * (9/2 * unit53 * L) + Rabs m3 * (9/2 * unit53 * L) <= 63/8 * unit53 * (L * L)) by in_units.
  set (x1 := Rabs m1 * _) in *. set (x2 := Rabs m2 * _) in *. set (x3 := Rabs m3 * _) in *. set (v := L * L) in *. set (a1 := h1 * h1) in *. set (a2 := h2 * h2) in *. set (a3 := h3 * h3) in *. set (b1 := m1 * m1) in *. set (b2 := m2 * m2) in *. set (b3 := m3 * m3) in *.
  clearbody x1 x2 x3 v a1 a2 a3 b1 b2 b3. assert (G : v * (1 - 79/10 * unit53) <= a1 + a2 + a3 <= v * (1 + 79/10 * unit53)) by in_units.
  assert (K : (a1 + a2 + a3) * (1 - unit53) - 3 * underflow <= p1 + p2 + p3 <= (a1 + a2 + a3) * (1 + unit53) + 3 * underflow) by lra.
  assert (M : (p1 + p2 + p3) * (1 - unit53) - underflow <= s + p3 <= (p1 + p2 + p3) * (1 + unit53) + underflow) by in_units.
  apply Rabs_le. in_units.
Qed.
Lemma length_rounded : L * (1 - 67/10 * unit53) <= r <= L * (1 + 67/10 * unit53).
Proof.
  assert (Q := square_of_length). both_ways Q. assert (V : 0 < L * L) by (apply Rmult_lt_0_compat; lra). assert (T := underflow_is_small). assert (Tp := proj1 underflow_in_least).
  assert (q0 : 0 <= q) by in_units. assert (W := sqrt_sqrt q q0). assert (Wp := sqrt_pos q). unfold r. set (w := sqrt q) in *.
  assert (U : w <= L * (1 + 56/10 * unit53)) by (apply less_of_squares; [in_units | rewrite W; unfold unit53 in *; nra]).
  assert (D : L * (1 - 56/10 * unit53) <= w) by (apply less_of_squares; [exact Wp | rewrite W; unfold unit53 in *; nra]).
  assert (R := counted w Wp). set (l := rounded w) in *. clearbody l w. in_units.
Qed.
Lemma scale_of_length : Rabs (c * L - 1) <= 8 * unit53.
Proof.
  assert (B := length_rounded). unfold c. replace (8 * unit53) with (69/10 * unit53 + 11/10 * unit53) by lra. apply inverse_rounded; [in_units | lra | eapply Rle_trans; [exact high | apply Rle_pow; lra || lia] | in_units].
Qed.
Lemma component_normalised (h m : R) : Rabs (h - m) <= 9/4 * unit53 * L -> m * m <= L * L -> Rabs (rounded (c * h) - m / L) <= 12 * unit53.
Proof.
  intros E M. assert (S := scale_of_length). assert (T := underflow_is_small). assert (X : Rabs (m / L) <= 1) by (apply over_length; [lra | rewrite Rmult_1_l; apply within_length; lra]).
  assert (Y : Rabs (h / L - m / L) <= 9/4 * unit53) by (replace (h / L - m / L) with ((h - m) / L) by (field; lra); apply over_length; [lra | exact E]).
  replace (c * h) with (c * L * (h / L)) by (field; lra). set (k := c * L) in *. set (x := m / L) in *. set (y := h / L) in *. assert (O := rounding_error (k * y)).
  assert (Z : Rabs (k * y - x) <= 104/10 * unit53).
  { replace (k * y - x) with ((k - 1) * y + (y - x)) by ring. sizes_add. rewrite Rabs_mult. assert (Yy : Rabs y <= 1 + 9/4 * unit53) by (replace y with (x + (y - x)) by ring; eapply Rle_trans; [apply Rabs_triang | lra]).
    assert (Rabs (k - 1) * Rabs y <= 8 * unit53 * (1 + 9/4 * unit53)) by (apply Rmult_le_compat; try apply Rabs_pos; assumption). in_units. }
  assert (G : Rabs (k * y) <= 1 + 104/10 * unit53) by (replace (k * y) with (x + (k * y - x)) by ring; eapply Rle_trans; [apply Rabs_triang | lra]).
  replace (rounded (k * y) - x) with ((rounded (k * y) - k * y) + (k * y - x)) by ring. sizes_add. in_units.
Qed.
End normalised.

Lemma component_rounded (b g n L : R) : float64 n -> 1 <= L -> (b * g) * (b * g) <= L * L -> (b * g + n) * (b * g + n) <= L * L -> Rabs (rounded (rounded (b * g) + n) - (b * g + n)) <= 9/4 * unit53 * L.
Proof.
  intros N L1 G M. apply within_length in G; [|lra]. apply within_length in M; [|lra]. assert (O := rounding_error (b * g)). assert (T := underflow_is_small). set (p := rounded (b * g)) in *. assert (S := own_rounding_of_sum p n ltac:(apply rounded_is_float64) N). set (h := rounded (p + n)) in *.
  assert (K : Rabs (p + n - (b * g + n)) <= unit53 * L + underflow) by (replace (p + n - (b * g + n)) with (p - b * g) by ring; in_units).
  assert (H : Rabs h <= Rabs (h - (p + n)) + (Rabs (p + n - (b * g + n)) + Rabs (b * g + n))).
  { replace h with ((h - (p + n)) + ((p + n - (b * g + n)) + (b * g + n))) at 1 by ring. eapply Rle_trans; [apply Rabs_triang | apply Rplus_le_compat_l, Rabs_triang]. }
  replace (h - (b * g + n)) with ((h - (p + n)) + (p + n - (b * g + n))) by ring. sizes_add. in_units.
Qed.
Ltac of_length v := set (L := sqrt v); assert (LL : L * L = v) by (apply sqrt_sqrt; lra); assert (L1 : 1 / 2 ^ 20 <= L) by (apply length_at_least; lra).
Lemma not_moved (h L : R) : 1 / 2 ^ 20 <= L -> Rabs (h - h) <= 9/4 * unit53 * L.
Proof. intro P. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. in_units. Qed.
Lemma length_at_most (x : R) : 0 <= x -> x <= 2 ^ 900 -> sqrt x <= 2 ^ 450.
Proof. intros P U. replace (2 ^ 450) with (sqrt (2 ^ 900)); [apply sqrt_le_1_alt, U|]. change 900%nat with (450 + 450)%nat. rewrite pow_add. apply sqrt_square, pow_le. lra. Qed.
Theorem colour_accuracy__normal : Statements.colour_accuracy__normal.
Proof.
  red. intros nx ny nz gx gy gz b Nx Ny Nz _ _ _ _ low high Bx By Bz. set (v := _ + _ * _) in low, high, Bx, By, Bz. assert (V : v = (b * gx + nx) * (b * gx + nx) + (b * gy + ny) * (b * gy + ny) + (b * gz + nz) * (b * gz + nz)) by (unfold v; ring). clearbody v.
  set (L := sqrt v). assert (LL : L * L = v) by (apply sqrt_sqrt; lra). assert (L1 : 1 <= L) by (rewrite <- sqrt_1; apply sqrt_le_1_alt; lra). assert (Lu : L <= 2 ^ 450) by (apply length_at_most; lra).
  assert (Sx := Rle_0_sqr (b * gx + nx)). assert (Sy := Rle_0_sqr (b * gy + ny)). assert (Sz := Rle_0_sqr (b * gz + nz)). unfold Rsqr in Sx, Sy, Sz.
  assert (Ex := component_rounded b gx nx L Nx L1 ltac:(lra) ltac:(lra)). assert (Ey := component_rounded b gy ny L Ny L1 ltac:(lra) ltac:(lra)). assert (Ez := component_rounded b gz nz L Nz L1 ltac:(lra) ltac:(lra)).
  assert (H := component_normalised _ _ _ _ _ _ L (eq_trans LL V) ltac:(lra) Lu Ex Ey Ez).
  perturbed_float64.lines; perturbed.lines.
  replace (sqrt (_ ^ 2 + _ ^ 2 + _ ^ 2)) with L by (unfold L; rewrite V; f_equal; ring). replace (12 / 9007199254740992) with (12 * unit53) by in_units.
  cbv zeta in H. rewrite !(Rmult_comm (/ L)). split; [|split]; (apply H; [assumption | lra]).
Qed.
Lemma positive_part (a b : R) : Rabs (Rmax 0 a - Rmax 0 b) <= Rabs (a - b).
Proof. unfold Rmax, Rabs. repeat destruct Rle_dec; repeat destruct Rcase_abs; lra. Qed.
(* The highlight's base: Phong's is made of sums and products, *)
Ltac sums := lazymatch goal with
  | |- Rabs (rounded (_ + _) - (_ + _)) <= _ => eapply both_error; [find_bound | sums | sums]
  | |- Rabs (rounded (_ - _) - (_ - _)) <= _ => eapply difference_error; [find_bound | sums | sums]
  | |- Rabs (rounded (_ * _) - _ * _) <= _ => eapply times_error; [find_bound | find_bound | sums | sums]
  | |- _ => first [eassumption | apply no_error] end.
Theorem colour_accuracy__phong : Statements.colour_accuracy__phong.
Proof. red. intros. phong_highlight_float64.lines; phong_highlight.lines. eapply Rle_trans; [apply positive_part|]. eapply Rle_trans; [sums | interval]. Qed.
(* The product of a normal and a vector of that length, of any length. *)
Lemma along_rounded (nx ny nz hx hy hz L : R) : 1 / 2 ^ 20 <= L -> L * L = hx * hx + hy * hy + hz * hz -> Rabs nx <= / 1099511627776 + 1 -> Rabs ny <= / 1099511627776 + 1 -> Rabs nz <= / 1099511627776 + 1 ->
  let d := rounded (rounded (rounded (nx * hx) + rounded (ny * hy)) + rounded (nz * hz)) in let e := nx * hx + ny * hy + nz * hz in Rabs (d - e) <= 81/10 * unit53 * L /\ Rabs e <= 301/100 * L.
Proof.
  intros L1 V Bx By Bz. assert (Sx := Rle_0_sqr hx). assert (Sy := Rle_0_sqr hy). assert (Sz := Rle_0_sqr hz). unfold Rsqr in Sx, Sy, Sz. assert (T := underflow_is_small).
  assert (P : forall n h, Rabs n <= / 1099511627776 + 1 -> h * h <= L * L -> Rabs (rounded (n * h) - n * h) <= 101/100 * unit53 * L /\ Rabs (n * h) <= 1001/1000 * L).
  { intros n h N S. assert (A := within_length h L ltac:(lra) S). assert (G : Rabs (n * h) <= 1001/1000 * L) by (rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; lra).
    split; [|exact G]. assert (E := rounding_error (n * h)). in_units. }
  destruct (P nx hx Bx ltac:(lra)) as [Ax Gx]. destruct (P ny hy By ltac:(lra)) as [Ay Gy]. destruct (P nz hz Bz ltac:(lra)) as [Az Gz].
  both_ways Ax. both_ways Ay. both_ways Az. both_ways Gx. both_ways Gy. both_ways Gz.
  set (a := rounded (nx * hx)) in *. set (b := rounded (ny * hy)) in *. set (c := rounded (nz * hz)) in *. set (gx := nx * hx) in *. set (gy := ny * hy) in *. set (gz := nz * hz) in *. cbv zeta. clearbody a b c gx gy gz. clear - Ax Ay Az Gx Gy Gz T L1.
  assert (O1 := rounding_error (a + b)). assert (B1 : Rabs (a + b) <= 201/100 * L) by (apply Rabs_le; in_units). both_ways O1. set (s := rounded (a + b)) in *.
  assert (O2 := rounding_error (s + c)). assert (B2 : Rabs (s + c) <= 302/100 * L) by (apply Rabs_le; in_units). both_ways O2. split; apply Rabs_le; in_units.
Qed.
(* and Blinn's divides by a length. *)
Theorem colour_accuracy__blinn : Statements.colour_accuracy__blinn.
Proof.
  red. intros nx ny nz hx hy hz _ _ _ _ _ _ low high Bx By Bz. set (v := _ + _ * _) in low, high. assert (V : v = hx * hx + hy * hy + hz * hz) by (unfold v; ring). clearbody v.
  of_length v.
  assert (T := underflow_is_small).
  assert (R := length_rounded hx hy hz hx hy hz L (eq_trans LL V) L1 (not_moved hx L L1) (not_moved hy L L1) (not_moved hz L L1)). blinn_highlight_float64.lines; blinn_highlight.lines. replace (sqrt (_ ^ 2 + _ ^ 2 + _ ^ 2)) with L by (unfold L; rewrite V; f_equal; ring).
  set (l := rounded (sqrt _)) in *. assert (l0 : 0 < l) by in_units. destruct (Rlt_dec 0 l) as [_|N]; [|contradiction]. destruct (Rlt_dec 0 L) as [_|N]; [|lra]. rewrite (Rmax_comm _ 0). eapply Rle_trans; [apply positive_part|].
  destruct (along_rounded nx ny nz hx hy hz L L1 (eq_trans LL V) Bx By Bz) as [D Bg]. set (d := rounded (_ + rounded (nz * hz))) in *. set (g := nx * hx + ny * hy + nz * hz) in *. both_ways D. both_ways Bg. clearbody d g l. clear - D Bg T R L1 l0.
  set (z := g / L). assert (Z : z * L = g) by (unfold z; field; lra). assert (Bz : Rabs z <= 301/100) by (apply Rabs_le; split; apply Rmult_le_reg_r with L; lra). rewrite <- Z in D. assert (E : Rabs (z * (L - l)) <= 301/100 * (67/10 * unit53 * L)) by (rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; [exact Bz | apply Rabs_le; lra]). both_ways Bz. both_ways E.
  assert (Y : - (285/10 * unit53) <= d / l - z <= 285/10 * unit53).
  { assert (I : (d / l - z) * l = (d - z * L) + z * (L - l)) by (field; lra). set (w := d / l - z) in *. clearbody w z. unfold unit53 in *. split; apply Rmult_le_reg_r with l; lra. }
  assert (O3 := rounding_error (d / l)). assert (B3 : Rabs (d / l) <= 302/100) by (apply Rabs_le; in_units). both_ways O3. apply Rabs_le. in_units.
Qed.
(* Its square divides by a square, and by a distance with which it was multiplied. *)
Theorem colour_accuracy__squared : Statements.colour_accuracy__squared.
Proof.
  red. intros nx ny nz hx hy hz d _ _ _ _ _ _ _ low high dl dh Bx By Bz. set (v := _ + _ * _) in low, high. assert (V : v = hx * hx + hy * hy + hz * hz) by (unfold v; ring). clearbody v.
  of_length v. assert (T := underflow_is_small). assert (Tp := proj1 underflow_in_least).
  assert (Q := square_of_length hx hy hz hx hy hz L (eq_trans LL V) L1 (not_moved hx L L1) (not_moved hy L L1) (not_moved hz L L1)). rewrite LL in Q. destruct (along_rounded nx ny nz hx hy hz L L1 (eq_trans LL V) Bx By Bz) as [D _]. assert (C : (nx * hx + ny * hy + nz * hz) * (nx * hx + ny * hy + nz * hz) <= 30001/10000 * v).
  { assert (S : forall n, Rabs n <= / 1099511627776 + 1 -> n * n <= 1 + 1 / 2 ^ 30) by (intros n N; both_ways N; nra). apply Rle_trans with ((nx * nx + ny * ny + nz * nz) * v); [|apply Rmult_le_compat_r; [lra | generalize (S _ Bx) (S _ By) (S _ Bz); lra]].
    rewrite V. generalize (Rle_0_sqr (nx * hy - ny * hx)) (Rle_0_sqr (nx * hz - nz * hx)) (Rle_0_sqr (ny * hz - nz * hy)). unfold Rsqr. lra. }
  squared_highlight_float64.lines; squared_highlight.lines. replace (hx ^ 2 + hy ^ 2 + hz ^ 2) with v by (rewrite V; ring). set (h := rounded (_ + rounded (hz * hz))) in *. set (e := nx * hx + ny * hy + nz * hz) in *. both_ways Q.
  assert (M := Rle_trans _ _ _ (positive_part _ e) D). assert (A0 := Rmax_l 0 (rounded (rounded (rounded (nx * hx) + rounded (ny * hy)) + rounded (nz * hz)))). set (A := Rmax 0 (rounded _)) in *. assert (B0 := Rmax_l 0 e). assert (B2 : Rmax 0 e * Rmax 0 e <= 30001/10000 * v) by (unfold Rmax; destruct Rle_dec; lra). set (B := Rmax 0 e) in *. both_ways M.
  destruct (Rlt_dec 0 h) as [_|N]; [|destruct N; in_units]. destruct (Rlt_dec 0 v) as [_|N]; [|lra]. set (X := v * d). assert (Xl : 1 / 2 ^ 60 <= X) by (apply Rle_trans with (/ 1099511627776 * / 1048576); [lra | apply Rmult_le_compat; lra]).
  assert (Xu : X <= 2 ^ 600) by (change 600%nat with (400 + 200)%nat; rewrite pow_add; apply Rmult_le_compat; lra).
  set (E := B * B / v). set (F := A * A / v). assert (Ev : E * v = B * B) by (unfold E; field; lra). assert (Fv : F * v = A * A) by (unfold F; field; lra). replace (B ^ 2 * d * (1 / X)) with E by (unfold E, X; field; lra).
  assert (B1 : B <= 1733/1000 * L) by (apply less_of_squares; lra). assert (FE : - (283/10 * unit53) <= F - E <= 283/10 * unit53).
  { assert (G : Rabs ((A - B) * (A + B)) <= 81/10 * unit53 * L * (3467/1000 * L)) by (rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; apply Rabs_le; in_units). both_ways G. split; apply Rmult_le_reg_r with v; in_units. }
  assert (Eu : 0 <= E <= 30001/10000) by (split; apply Rmult_le_reg_r with v; lra || (assert (0 <= B * B) by is_not_negative; lra)).
  rounds a (A * A). assert (Ad : F * X * (1 - unit53) - X / 2 ^ 150 <= a * d <= F * X * (1 + unit53) + X / 2 ^ 150).
  { assert (W : underflow * d <= v / 2 ^ 150 * d) by (apply Rmult_le_compat_r; lra). unfold X. replace (F * (v * d)) with (A * A * d) by (rewrite <- Fv; ring). assert ((A * A * (1 - unit53) - underflow) * d <= a * d) by (apply Rmult_le_compat_r; lra). assert (a * d <= (A * A * (1 + unit53) + underflow) * d) by (apply Rmult_le_compat_r; lra). lra. }
  rounds b (a * d). assert (Hd : X * (1 - 111/10 * unit53) <= h * d <= X * (1 + 111/10 * unit53)).
  { assert (v * (1 - 111/10 * unit53) * d <= h * d) by (apply Rmult_le_compat_r; lra). assert (h * d <= v * (1 + 111/10 * unit53) * d) by (apply Rmult_le_compat_r; lra). unfold X. lra. }
  rounds q (h * d). assert (Qx : X * (1 - 1211/100 * unit53) <= q <= X * (1 + 1211/100 * unit53)) by (clearbody q X; in_units). assert (KX := inverse_rounded q X (1211/100 * unit53) ltac:(in_units) ltac:(lra) Xu Qx). set (k := rounded (1 / q)) in *. both_ways KX.
  set (y := b / X). assert (Yx : y * X = b) by (unfold y; field; lra). assert (Y : - (345/10 * unit53) <= y - E <= 345/10 * unit53).
  { assert (G : - (61/10 * unit53) <= y - F <= 61/10 * unit53); [|in_units]. assert (F * X <= 30002/10000 * X) by (apply Rmult_le_compat_r; in_units). assert (0 <= F * X) by (apply Rmult_le_pos; [apply Rmult_le_reg_r with v; [lra | rewrite Fv; lra] | lra]). clearbody b X y. split; apply Rmult_le_reg_r with X; in_units. }
  replace (b * k) with (y * (k * X)) by (rewrite <- Yx; ring). set (c := k * X) in *. assert (G : Rabs (y * c - E) <= 747/10 * unit53).
  { replace (y * c - E) with ((y - E) * c + E * (c - 1)) by ring. sizes_add. rewrite !Rabs_mult. assert (Rabs (y - E) * Rabs c <= 345/10 * unit53 * (1 + 1322/100 * unit53)) by (apply Rmult_le_compat; try apply Rabs_pos; apply Rabs_le; in_units).
    assert (Rabs E * Rabs (c - 1) <= 30001/10000 * (1322/100 * unit53)) by (apply Rmult_le_compat; try apply Rabs_pos; apply Rabs_le; in_units). in_units. }
  assert (R := rounding_error (y * c)). assert (S := Rabs_triang_inv (y * c) E). rewrite (Rabs_pos_eq E) in S by lra. eapply Rle_trans; [exact (through _ _ _ _ _ R G)|]. in_units.
Qed.
Theorem colour_accuracy__cosine : Statements.colour_accuracy__cosine.
Proof.
  red. intros px py pz lx ly lz nx ny nz Px Py Pz Lx Ly Lz _ _ _ low high Bx By Bz. set (v := _ + _ * _) in low, high. assert (V : v = (lx - px) * (lx - px) + (ly - py) * (ly - py) + (lz - pz) * (lz - pz)) by (unfold v; ring). clearbody v.
  of_length v.
  assert (Lu : L <= 2 ^ 450) by (apply length_at_most; lra).
  assert (Sx := Rle_0_sqr (lx - px)). assert (Sy := Rle_0_sqr (ly - py)). assert (Sz := Rle_0_sqr (lz - pz)). unfold Rsqr in Sx, Sy, Sz.
  assert (K : forall a b, float64 a -> float64 b -> (a - b) * (a - b) <= L * L -> Rabs (rounded (a - b) - (a - b)) <= 9/4 * unit53 * L).
  { intros a b A B S. destruct (rounded_difference a b A B) as (d & D & ->). replace ((a - b) * (1 + d) - (a - b)) with (d * (a - b)) by ring. rewrite Rabs_mult. assert (D' : Rabs d <= unit53) by (eapply Rle_trans; [exact D | unfold unit_roundoff, unit53; simpl; lra]).
    assert (R := within_length (a - b) L ltac:(lra) S). apply Rle_trans with (unit53 * L); [apply Rmult_le_compat; try apply Rabs_pos; assumption | in_units]. }
  assert (Ex := K _ _ Lx Px ltac:(lra)). assert (Ey := K _ _ Ly Py ltac:(lra)). assert (Ez := K _ _ Lz Pz ltac:(lra)).
  assert (H := component_normalised _ _ _ _ _ _ L (eq_trans LL V) L1 Lu Ex Ey Ez). cbv zeta in H.
  assert (Tx := H _ _ Ex ltac:(lra)). assert (Ty := H _ _ Ey ltac:(lra)). assert (Tz := H _ _ Ez ltac:(lra)). clear H K Ex Ey Ez.
  assert (I : forall m, m * m <= L * L -> Rabs (m / L) <= 1) by (intros m M; apply over_length; [lra | rewrite Rmult_1_l; apply within_length; lra]).
  assert (Ix := I (lx - px) ltac:(lra)). assert (Iy := I (ly - py) ltac:(lra)). assert (Iz := I (lz - pz) ltac:(lra)). clear I.
  light_direction_float64.lines; light_direction.lines.
  replace (sqrt (_ ^ 2 + _ ^ 2 + _ ^ 2)) with L by (unfold L; rewrite V; f_equal; ring). rewrite !(Rmult_comm (/ L)). fold (Rdiv (lx - px) L) (Rdiv (ly - py) L) (Rdiv (lz - pz) L).
  set (tx := (lx - px) / L) in *. set (ty := (ly - py) / L) in *. set (tz := (lz - pz) / L) in *. set (k := rounded (1 / rounded (sqrt _))) in *. set (hx := rounded (k * rounded (lx - px))) in *. set (hy := rounded (k * rounded (ly - py))) in *. set (hz := rounded (k * rounded (lz - pz))) in *.
  clearbody tx ty tz hx hy hz. unfold unit53 in *. eapply Rle_trans; [sums | interval].
Qed.

Lemma share_rounded (b i a kd ks w p : R) : 0 <= b -> 0 <= i -> 0 <= a -> 0 <= kd -> 0 <= ks -> 0 <= w -> 0 <= p -> i <= 2 ^ 20 -> a <= 2 ^ 20 ->
  Rabs (rounded (rounded (i * rounded (rounded (a * rounded (kd * w)) + rounded (ks * p))) + b) - (i * (a * (kd * w) + ks * p) + b)) <= 6 * unit53 * (i * (a * (kd * w) + ks * p) + b) + / 10 ^ 30.
Proof.
  intros B I A Kd Ks W P Iu Au. assert (T := underflow_is_small). assert (Tp := proj1 underflow_in_least). assert (X0 : 0 <= kd * w) by (apply Rmult_le_pos; assumption). assert (Y0 : 0 <= ks * p) by (apply Rmult_le_pos; assumption).
  set (X := kd * w) in *. set (Y := ks * p) in *. rounds d X. rounds s Y. rounds g (a * d).
  assert (AD : a * X * (1 - unit53) - 2 ^ 20 * underflow <= a * d <= a * X * (1 + unit53) + 2 ^ 20 * underflow).
  { assert (a * (X * (1 - unit53) - underflow) <= a * d) by (apply Rmult_le_compat_l; lra). assert (a * d <= a * (X * (1 + unit53) + underflow)) by (apply Rmult_le_compat_l; lra). assert (a * underflow <= 2 ^ 20 * underflow) by (apply Rmult_le_compat_r; lra). lra. }
  rounds e (g + s). assert (aX : 0 <= a * X) by (apply Rmult_le_pos; assumption). set (Z := a * X) in *. set (ad := a * d) in *.
  assert (Eb : (Z + Y) * (1 - 31/10 * unit53) - 2 ^ 22 * underflow <= e <= (Z + Y) * (1 + 31/10 * unit53) + 2 ^ 22 * underflow) by (clearbody e g s ad Z Y d; in_units).
  rounds r (i * e).
  assert (IE : i * (Z + Y) * (1 - 31/10 * unit53) - 2 ^ 42 * underflow <= i * e <= i * (Z + Y) * (1 + 31/10 * unit53) + 2 ^ 42 * underflow).
  { assert (i * ((Z + Y) * (1 - 31/10 * unit53) - 2 ^ 22 * underflow) <= i * e) by (apply Rmult_le_compat_l; lra). assert (i * e <= i * ((Z + Y) * (1 + 31/10 * unit53) + 2 ^ 22 * underflow)) by (apply Rmult_le_compat_l; lra). assert (i * underflow <= 2 ^ 20 * underflow) by (apply Rmult_le_compat_r; lra). lra. }
  assert (iZ : 0 <= i * (Z + Y)) by (apply Rmult_le_pos; lra). set (Q := i * (Z + Y)) in *. set (ie := i * e) in *. rounds o (r + b). clearbody o r ie Q. clear AD Eb. apply Rabs_le. in_units.
Qed.
Lemma share_within (b i a kd ks w p : R) : b >= 0 -> i >= 0 -> a >= 0 -> kd >= 0 -> ks >= 0 -> 0 <= w -> p >= 0 -> i <= 2 ^ 20 -> a <= 2 ^ 20 ->
  Rabs (rounded (rounded (i * rounded (rounded (a * rounded (kd * w)) + rounded (ks * p))) + b) - (i * (a * (kd * w) + ks * p) + b)) <= 8 / 9007199254740992 * (i * (a * kd * w + ks * p) + b) + / 1000000000000000000000000000000.
Proof.
  intros B I A Kd Ks W P Iu Au. eapply Rle_trans; [apply share_rounded; lra|]. assert (X : 0 <= i * (a * (kd * w) + ks * p)) by (repeat (apply Rmult_le_pos || apply Rplus_le_le_0_compat); lra).
  replace (a * kd * w) with (a * (kd * w)) by ring. set (Q := i * _) in *. clearbody Q. in_units.
Qed.
Theorem colour_accuracy__share_red : Statements.colour_accuracy__share_red.
Proof. red. intros. apply share_within; try assumption. apply Rmax_l. Qed.
Theorem colour_accuracy__share_green : Statements.colour_accuracy__share_green.
Proof. red. intros b. intros. unfold light_term_float64.lit_green, light_term.lit_green. rewrite !(Rplus_comm b). apply share_within; try assumption. apply Rmax_l. Qed.
Theorem colour_accuracy__share_blue : Statements.colour_accuracy__share_blue.
Proof. red. intros b. intros. unfold light_term_float64.lit_blue, light_term.lit_blue. rewrite !(Rplus_comm b). apply share_within; try assumption. apply Rmax_l. Qed.
Theorem colour_accuracy__clip : Statements.colour_accuracy__clip.
Proof. red. intros. unfold clip_float64.clipped, clip.clipped. apply no_error. Qed.

(* Composed: from the frame, the gradient and the light to the colour, one light's share without another stage's input in between. *)
Lemma unit_component (x v : R) : 0 < v -> x * x <= v -> Rabs (/ sqrt v * x) <= 1.
Proof. intros V X. rewrite Rmult_comm. apply over_length; [apply sqrt_lt_R0, V|]. rewrite Rmult_1_l. apply within_length; [apply sqrt_pos | rewrite sqrt_sqrt; lra]. Qed.
Lemma clip_moves (x y : R) : Rabs (clip.clipped x - clip.clipped y) <= Rabs (x - y).
Proof. unfold clip.clipped, Rabs, Rmin, Rmax. repeat destruct Rle_dec; repeat destruct Rcase_abs; lra. Qed.
Theorem colour_accuracy__composed (nx ny nz gx gy gz beta px py pz lx ly lz b i a kd ks p : R) :
  let m2 := (beta * gz + nz) * (beta * gz + nz) + (beta * gx + nx) * (beta * gx + nx) + (beta * gy + ny) * (beta * gy + ny) in let d2 := (lz - pz) * (lz - pz) + (lx - px) * (lx - px) + (ly - py) * (ly - py) in
  let mu' := light_direction_float64.mu px py pz lx ly lz (perturbed_float64.bumped_x nx ny nz gx gy gz beta) (perturbed_float64.bumped_y nx ny nz gx gy gz beta) (perturbed_float64.bumped_z nx ny nz gx gy gz beta) in
  let mu := light_direction.mu px py pz lx ly lz (perturbed.bumped_x nx ny nz gx gy gz beta) (perturbed.bumped_y nx ny nz gx gy gz beta) (perturbed.bumped_z nx ny nz gx gy gz beta) in
  float64 nx -> float64 ny -> float64 nz -> float64 gx -> float64 gy -> float64 gz -> float64 beta -> float64 px -> float64 py -> float64 pz -> float64 lx -> float64 ly -> float64 lz ->
  m2 >= 1 -> m2 <= 2 ^ 900 -> (beta * gx) ^ 2 <= m2 -> (beta * gy) ^ 2 <= m2 -> (beta * gz) ^ 2 <= m2 -> d2 >= / 1099511627776 -> d2 <= 2 ^ 900 ->
  b >= 0 -> i >= 0 -> a >= 0 -> kd >= 0 -> ks >= 0 -> p >= 0 -> i <= 2 ^ 20 -> a <= 2 ^ 20 ->
  Rabs (mu' - mu) <= 81 * unit53 /\
  Rabs (clip_float64.clipped (light_term_float64.lit_red b i a kd ks mu' p) - clip.clipped (light_term.lit_red b i a kd ks mu p)) <=
    8 / 9007199254740992 * (i * (a * kd * Rmax 0 mu' + ks * p) + b) + / 1000000000000000000000000000000 + i * (a * kd * (81 * unit53)).
Proof.
  intros m2 d2 mu' mu Nx Ny Nz Gx Gy Gz Fb Px Py Pz Lx Ly Lz M1 M2 Bx By Bz D1 D2 B I A Kd Ks P Iu Au.
  destruct (colour_accuracy__normal nx ny nz gx gy gz beta Nx Ny Nz Gx Gy Gz Fb M1 M2 Bx By Bz) as (Ex & Ey & Ez).
  assert (Ux : Rabs (perturbed.bumped_x nx ny nz gx gy gz beta) <= 1 /\ Rabs (perturbed.bumped_y nx ny nz gx gy gz beta) <= 1 /\ Rabs (perturbed.bumped_z nx ny nz gx gy gz beta) <= 1).
  { perturbed.lines. unfold m2 in M1.
    generalize (Rle_0_sqr (beta * gx + nx)) (Rle_0_sqr (beta * gy + ny)) (Rle_0_sqr (beta * gz + nz)). unfold Rsqr. intros Sx Sy Sz. repeat split; apply unit_component; simpl; lra. }
  assert (T : Rabs (light_direction.towards_x px py pz lx ly lz) <= 1 /\ Rabs (light_direction.towards_y px py pz lx ly lz) <= 1 /\ Rabs (light_direction.towards_z px py pz lx ly lz) <= 1).
  { light_direction.lines. unfold d2 in D1.
    generalize (Rle_0_sqr (lx - px)) (Rle_0_sqr (ly - py)) (Rle_0_sqr (lz - pz)). unfold Rsqr. intros Sx Sy Sz. repeat split; apply unit_component; simpl; lra. }
  destruct Ux as (Ux & Uy & Uz). destruct T as (Tx & Ty & Tz). set (x := perturbed.bumped_x _ _ _ _ _ _ _) in *. set (y := perturbed.bumped_y _ _ _ _ _ _ _) in *. set (z := perturbed.bumped_z _ _ _ _ _ _ _) in *.
  assert (Fx : float64 (perturbed_float64.bumped_x nx ny nz gx gy gz beta)) by exact (rounded_is_float64 _). assert (Fy : float64 (perturbed_float64.bumped_y nx ny nz gx gy gz beta)) by exact (rounded_is_float64 _).
  assert (Fz : float64 (perturbed_float64.bumped_z nx ny nz gx gy gz beta)) by exact (rounded_is_float64 _).
  set (x' := perturbed_float64.bumped_x _ _ _ _ _ _ _) in *. set (y' := perturbed_float64.bumped_y _ _ _ _ _ _ _) in *. set (z' := perturbed_float64.bumped_z _ _ _ _ _ _ _) in *. clearbody x y z x' y' z'.
  assert (W : forall v w, Rabs (v - w) <= 12 / 9007199254740992 -> Rabs w <= 1 -> Rabs v <= / 1099511627776 + 1) by (intros v w E U; replace v with ((v - w) + w) by ring; eapply Rle_trans; [apply Rabs_triang | lra]).
  assert (C := colour_accuracy__cosine px py pz lx ly lz x' y' z' Px Py Pz Lx Ly Lz Fx Fy Fz D1 D2 (W _ _ Ex Ux) (W _ _ Ey Uy) (W _ _ Ez Uz)). fold mu' in C.
  assert (K : Rabs (light_direction.mu px py pz lx ly lz x' y' z' - mu) <= 36 * unit53).
  { unfold mu, light_direction.mu. set (tx := light_direction.towards_x _ _ _ _ _ _) in *. set (ty := light_direction.towards_y _ _ _ _ _ _) in *. set (tz := light_direction.towards_z _ _ _ _ _ _) in *. clearbody tx ty tz.
    replace (_ - _) with ((x' - x) * tx + (y' - y) * ty + (z' - z) * tz) by ring. set (dx := x' - x) in *. set (dy := y' - y) in *. set (dz := z' - z) in *. clearbody dx dy dz. unfold unit53. interval with (i_prec 100). }
  assert (M : Rabs (mu' - mu) <= 81 * unit53).
  { replace (mu' - mu) with ((mu' - light_direction.mu px py pz lx ly lz x' y' z') + (light_direction.mu px py pz lx ly lz x' y' z' - mu)) by ring. sizes_add. in_units. }
  split; [exact M|]. clearbody mu mu'. clear - M B I A Kd Ks P Iu Au. change clip_float64.clipped with clip.clipped. eapply Rle_trans; [apply clip_moves|].
  assert (S := share_within b i a kd ks (Rmax 0 mu') p B I A Kd Ks (Rmax_l 0 mu') P Iu Au). light_term_float64.lines; light_term.lines.
  match goal with |- Rabs (?h - ?e) <= _ => replace (h - e) with ((h - (i * (a * (kd * Rmax 0 mu') + ks * p) + b)) + (i * (a * kd * (Rmax 0 mu' - Rmax 0 mu)))) by ring end.
  sizes_add. apply Rplus_le_compat; [exact S|]. rewrite Rabs_mult, (Rabs_pos_eq i) by lra. apply Rmult_le_compat_l; [lra|]. assert (0 <= a * kd) by (apply Rmult_le_pos; lra). rewrite Rabs_mult, (Rabs_pos_eq (a * kd)) by assumption.
  apply Rmult_le_compat_l; [assumption|]. eapply Rle_trans; [|exact M]. unfold Rmax, Rabs. repeat destruct Rle_dec; repeat destruct Rcase_abs; lra.
Qed.
Theorem colour_accuracy__composed__point : exists nx ny nz gx gy gz beta : R, float64 nx /\ float64 ny /\ float64 nz /\ float64 gx /\ float64 gy /\ float64 gz /\ float64 beta /\
  1 <= (beta * gz + nz) * (beta * gz + nz) + (beta * gx + nx) * (beta * gx + nx) + (beta * gy + ny) * (beta * gy + ny) <= 2 ^ 900.
Proof.
  assert (Z : float64 0) by apply generic_format_0. assert (U := one_is_float64). assert (1 <= 2 ^ 900) by (apply pow_R1_Rle; lra).
  exists 0, 0, 1, 0, 0, 0, 0. repeat split; try assumption; lra.
Qed.
(* It is not the cosine of another normal: a light above a level place is not grazing. *)
Theorem colour_accuracy__composed__false : ~ forall lz, float64 lz -> lz >= 1 ->
  Rabs (light_direction_float64.mu 0 0 0 0 0 lz (perturbed_float64.bumped_x 0 0 1 0 0 0 0) (perturbed_float64.bumped_y 0 0 1 0 0 0 0) (perturbed_float64.bumped_z 0 0 1 0 0 0 0)) <= 81 * unit53.
Proof.
  assert (Z : float64 0) by apply generic_format_0. assert (U := one_is_float64). assert (G : 1 <= 2 ^ 900) by (apply pow_R1_Rle; lra). intro H. specialize (H 1 U ltac:(lra)).
  destruct (colour_accuracy__composed 0 0 1 0 0 0 0 0 0 0 0 0 1 0 0 0 0 0 0) as [M _]; try assumption; try lra. revert M H. set (mu' := light_direction_float64.mu _ _ _ _ _ _ _ _ _).
  light_direction.lines; perturbed.lines.
  replace ((0 * 0 + 0) ^ 2 + (0 * 0 + 0) ^ 2 + (0 * 0 + 1) ^ 2) with 1 by ring. replace ((0 - 0) ^ 2 + (0 - 0) ^ 2 + (1 - 0) ^ 2) with 1 by ring. rewrite sqrt_1, Rinv_1. intros M H. both_ways M. both_ways H. in_units.
Qed.
