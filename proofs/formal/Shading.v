(* The light models: how the colour depends on the bumped normal. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Formulas Vectors Bump Claim.
From Formal Require Statements.
Open Scope R_scope.

Lemma last_squared x y z : z * z + x * x + y * y = 1 -> z ^ 2 = 1 - x ^ 2 - y ^ 2.
Proof. lra. Qed.
Theorem specular_lipschitz__along_a_direction : Statements.specular_lipschitz__along_a_direction.
Proof.
  intros a mx my mz nx ny nz ox oy oz A G U. set (w := oz * _ + ox * _ + oy * _).
  assert (S : a ^ 2 - w ^ 2 = (ox * (ny - my) - oy * (nx - mx)) ^ 2 + (oy * (nz - mz) - oz * (ny - my)) ^ 2 + (oz * (nx - mx) - ox * (nz - mz)) ^ 2).
  { rewrite G. unfold w. ring [(last_squared _ _ _ U)]. }
  assert (D : a ^ 2 - w ^ 2 >= 0) by (rewrite S; sum_of_squares). assert (- a <= w <= a) by (clear - A D; nra). split; [exact D | unfold w in *; lra].
Qed.
Theorem specular_lipschitz__gram : Statements.specular_lipschitz__gram.
Proof.
  intros mx my mz nx ny nz ox oy oz N M O. ring [(last_squared _ _ _ N) (last_squared _ _ _ M) (last_squared _ _ _ O)].
Qed.
Theorem specular_lipschitz__twice : Statements.specular_lipschitz__twice.
Proof. intros a d b c t D G T A. nra. Qed.
Theorem specular_lipschitz__mirror : Statements.specular_lipschitz__mirror.
Proof.
  intros mx my mz nx ny nz ox oy oz vx vy vz N M. repeat split; ring [(last_squared _ _ _ N) (last_squared _ _ _ M)].
Qed.
Theorem squared_highlight__base : Statements.squared_highlight__base.
Proof. intros a l k d s b S L A. transitivity (b ^ 2 * (k * d * s)); nra. Qed.
Theorem squared_highlight__opposite : Statements.squared_highlight__opposite.
Proof.
  red. intros. assert (halfway_squared = 0) by (unfold halfway_squared; put halfway_x; put halfway_y; put halfway_z; ring).
  unfold mu. destruct Rlt_dec; [lra|].
  split; try lra. sum_of_squares.
Qed.

(* For every whole p, x^p is Lipschitz with p on [0, 1]: by induction. *)
Theorem specular_lipschitz__whole_power p a b : 0 <= a <= 1 -> 0 <= b <= 1 -> Rabs (a ^ p - b ^ p) <= INR p * Rabs (a - b).
Proof.
  intros. induction p as [|p IH]; [simpl; rewrite Rminus_diag_eq, Rabs_R0; lra|].
  replace (_ - _) with (a * (a ^ p - b ^ p) + b ^ p * (a - b)) by (simpl; ring).
  assert (0 <= b ^ p <= 1). { split; [apply pow_le; lra | rewrite <- (pow1 p); apply pow_incr; lra]. }
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, Rabs_pos_eq, (Rabs_pos_eq (b ^ p)), S_INR by lra.
  generalize (Rabs_pos (a ^ p - b ^ p)) (Rabs_pos (a - b)). nra.
Qed.

Theorem specular_lipschitz__whole_power__point : exists x z, 0 <= x <= 1 /\ 0 <= z <= 1.
Proof. exists 0, 1. lra. Qed.
Theorem specular_lipschitz__whole_power__false : ~ forall p x z, Rabs (x ^ p - z ^ p) <= INR p * Rabs (x - z).
Proof. intro H. generalize (H 2%nat 2 1). rewrite !Rabs_pos_eq; simpl; lra. Qed.

Lemma clamp_is_lipschitz a b : Rabs (Rmax 0 a - Rmax 0 b) <= Rabs (a - b).
Proof. unfold Rmax, Rabs. destruct Rle_dec, Rle_dec; repeat destruct Rcase_abs; lra. Qed.

Lemma dot_is_lipschitz n m w : magnitude w = 1 -> Rabs (dot n w - dot m w) <= magnitude (difference n m).
Proof.
  intro W. replace (_ - _) with (dot (difference n m) w) by (unfold difference; rewrite dot_sum, dot_scaled; ring).
  destruct (cauchy_schwarz (difference n m) w) as [A B]. rewrite W in A, B. apply Rabs_le. lra.
Qed.

(* The models' numbers at a point P lit from L and seen along v: mu and the highlight's base, as functions of N'. *)
Section models.
Variables P L v : vector.
Definition mu (n : vector) := let '(px, py, pz) := P in let '(lx, ly, lz) := L in let '(x, y, z) := n in light_direction.mu px py pz lx ly lz x y
  z.
Definition blinn_base (n : vector) := let '(px, py, pz) := P in let '(lx, ly, lz) := L in let '(x, y, z) := n in let '(vx, vy, vz) := v in
  blinn.specular_base px py pz lx ly lz x y z vx vy vz.
Definition phong_base (n : vector) := let '(px, py, pz) := P in let '(lx, ly, lz) := L in let '(x, y, z) := n in let '(vx, vy, vz) := v in
  phong.specular_base px py pz lx ly lz x y z vx vy vz.
Definition omega : vector := scaled (/ magnitude (difference L P)) (difference L P).
End models.

Lemma difference_is x y z px py pz : difference (x, y, z) (px, py, pz) = (x - px, y - py, z - pz).
Proof. unfold difference, vector_sum, scaled. f_equal; [f_equal|]; ring. Qed.
Lemma dot_itself x y z : dot (x, y, z) (x, y, z) = x ^ 2 + y ^ 2 + z ^ 2.
Proof. unfold dot. ring. Qed.
Ltac coordinates := repeat match goal with a : vector |- _ => destruct a as [[? ?] ?] end.
Lemma mu_is_a_product P L n : mu P L n = dot n (omega P L).
Proof. coordinates. unfold omega, magnitude. rewrite difference_is, dot_itself. reflexivity. Qed.
Lemma direction_is_unit a : 0 < magnitude a -> magnitude (scaled (/ magnitude a) a) = 1.
Proof. intro H. rewrite length_scaled, Rabs_pos_eq by (left; apply Rinv_0_lt_compat, H). apply Rinv_l. lra. Qed.

(* mu is Lipschitz with 1 in N'. *)
Lemma mu_is_lipschitz P L n m : 0 < magnitude (difference L P) -> Rabs (mu P L n - mu P L m) <= magnitude (difference n m).
Proof. intro H. rewrite !mu_is_a_product. apply dot_is_lipschitz, direction_is_unit, H. Qed.

Lemma blinn_base_is P L v n : let k := vector_sum (omega P L) v in blinn_base P L v n = if Rlt_dec 0 (magnitude k) then Rmax 0 (dot n (scaled (/
  magnitude k) k)) else 0.
Proof.
  coordinates.
  unfold blinn_base, omega, magnitude; blinn.lines. rewrite difference_is, dot_itself. unfold vector_sum, scaled. rewrite dot_itself.
  destruct Rlt_dec; auto. rewrite Rmax_comm. f_equal. unfold dot, Rdiv. ring.
Qed.

(* Blinn's base is Lipschitz with 1. *)
Lemma blinn_base_is_lipschitz P L v n m : Rabs (blinn_base P L v n - blinn_base P L v m) <= magnitude (difference n m).
Proof.
  rewrite !blinn_base_is. destruct Rlt_dec as [H|H].
  - eapply Rle_trans; [apply clamp_is_lipschitz|]. apply dot_is_lipschitz, direction_is_unit, H.
  - rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. apply length_nonneg.
Qed.

Lemma phong_base_is P L v n : phong_base P L v n = Rmax 0 (2 * dot n (omega P L) * dot n v - dot (omega P L) v).
Proof. coordinates. unfold phong_base, omega, magnitude; phong.lines. rewrite difference_is, dot_itself. unfold dot, scaled. f_equal. ring. Qed.

Ltac expand_dots :=
  unfold difference;
  repeat first
    [ rewrite dot_sum | rewrite dot_scaled
    | match goal with
      | |- context [dot ?a (vector_sum ?b ?c)] => rewrite (dot_comm a (vector_sum b c))
      | |- context [dot ?a (scaled ?t ?b)] => rewrite (dot_comm a (scaled t b))
      end ].

(* w, mirrored at the unit vector n: at two of them it differs by at most twice their difference. *)
Definition reflected (w n : vector) : vector := difference (scaled (2 * dot n w) n) w.
Lemma reflected_product w n v : dot (reflected w n) v = 2 * dot n w * dot n v - dot w v.
Proof. unfold reflected. expand_dots. ring. Qed.
Lemma reflected_apart n m w : magnitude n = 1 -> magnitude m = 1 -> magnitude w = 1 -> magnitude (difference (reflected w n) (reflected w m)) <= 2
  * magnitude (difference n m).
Proof.
  assert (U : forall a, magnitude a = 1 -> dot a a = 1) by (intros a A; rewrite <- length_squared, A; ring). intros N M W. apply U in N, M, W.
    apply Rge_le.
  apply (specular_lipschitz__twice (dot n w) _ (dot m w) (dot n m)); [apply Rle_ge, length_nonneg | | |]; rewrite ?length_squared.
  - apply Rle_ge. destruct n as [[nx ny] nz], m as [[mx my] mz], w as [[wx wy] wz]. unfold dot in *.
    eapply Rle_trans; [apply pow2_ge_0 | right; etransitivity; [apply (specular_lipschitz__gram mx my mz nx ny nz wx wy wz); lra | ring]].
  - unfold reflected. expand_dots. rewrite (dot_comm m n), N, M. ring.
  - expand_dots. rewrite (dot_comm m), N, M. ring.
Qed.

(* Phong's base is Lipschitz with 2, between unit normals. *)
Lemma phong_base_is_lipschitz P L v n m : 0 < magnitude (difference L P) -> magnitude n = 1 -> magnitude m = 1 -> magnitude v = 1 -> Rabs
  (phong_base P L v n - phong_base P L v m) <= 2 * magnitude (difference n m).
Proof.
  intros H Hn Hm Hv. rewrite !phong_base_is, <- !reflected_product. eapply Rle_trans; [apply clamp_is_lipschitz|].
  eapply Rle_trans; [apply dot_is_lipschitz, Hv | apply reflected_apart; trivial]. apply direction_is_unit, H.
Qed.

(* Both bases lie in [0, 1] for unit normals. *)
Lemma product_of_units n w : magnitude n = 1 -> magnitude w = 1 -> -1 <= dot n w <= 1.
Proof. intros N W. destruct (cauchy_schwarz n w). rewrite N in *. lra. Qed.
Lemma blinn_base_in_unit P L v n : magnitude n = 1 -> 0 <= blinn_base P L v n <= 1.
Proof.
  intro N. rewrite blinn_base_is. destruct Rlt_dec as [H|H]; [|lra]. generalize (product_of_units n _ N (direction_is_unit _ H)).
  unfold Rmax. destruct Rle_dec; lra.
Qed.
Lemma phong_base_in_unit P L v n : 0 < magnitude (difference L P) -> magnitude n = 1 -> magnitude v = 1 -> 0 <= phong_base P L v n <= 1.
Proof.
  intros H N V. rewrite phong_base_is. generalize (direction_is_unit _ H). fold (omega P L). intro W.
  assert (R : magnitude (reflected (omega P L) n) = 1).
  { apply length_of_unit. unfold reflected. expand_dots. rewrite dot_comm, <- !length_squared, N, W. ring. }
  generalize (product_of_units _ v R). rewrite reflected_product. unfold Rmax. destruct Rle_dec; lra.
Qed.

(* mu is Lipschitz with 1 in N', and the highlight base^p with p (Blinn) and 2p (Phong), for every whole p. *)
Theorem specular_lipschitz__highlight p P L v n m : 0 < magnitude (difference L P) -> magnitude n = 1 -> magnitude m = 1 -> magnitude v = 1 ->
  Rabs (mu P L n - mu P L m) <= magnitude (difference n m) /\ Rabs (blinn_base P L v n ^ p - blinn_base P L v m ^ p) <= INR p * magnitude
  (difference n m) /\ Rabs (phong_base P L v n ^ p - phong_base P L v m ^ p) <= 2 * INR p * magnitude (difference n m).
Proof.
  generalize (pos_INR p). intro I. split; [apply mu_is_lipschitz, H | split].
  - eapply Rle_trans; [apply specular_lipschitz__whole_power; apply blinn_base_in_unit; assumption|]. apply Rmult_le_compat_l; [lra | apply
    blinn_base_is_lipschitz].
  - eapply Rle_trans; [apply specular_lipschitz__whole_power; apply phong_base_in_unit; assumption|].
    replace (2 * INR p * magnitude _) with (INR p * (2 * magnitude (difference n m))) by ring.
    apply Rmult_le_compat_l; [lra | apply phong_base_is_lipschitz; assumption].
Qed.
Theorem specular_lipschitz__highlight__point : exists P L v n : vector, 0 < magnitude (difference L P) /\ magnitude n = 1 /\ magnitude v = 1.
Proof.
  exists (0, 0, 0), (1, 0, 0), (1, 0, 0), (1, 0, 0).
  assert (E : magnitude (1, 0, 0) = 1) by (apply length_of_unit; unfold dot; ring).
  rewrite difference_is, !Rminus_0_r. lra.
Qed.
(* The error of a colour *)

(* A light's share of a channel. *)
Definition share (model : vector -> R) (P L : vector) (i albedo kd ks : R) (p : nat) (n : vector) := light_term.lit_red 0 i albedo kd ks (mu P L
  n) (model n ^ p).

(* It moves by at most i (a k_d + k_s q) |N'_1 - N'_2| where base^p is Lipschitz with q. *)
Theorem difference_bound__light model P L n m i albedo kd ks q p : 0 <= i -> 0 <= albedo -> 0 <= kd -> 0 <= ks -> 0 < magnitude (difference L P)
  -> Rabs (model n ^ p - model m ^ p) <= q * magnitude (difference n m) -> Rabs (share model P L i albedo kd ks p n - share model P L i albedo kd
  ks p m) <= i * (albedo * kd + ks * q) * magnitude (difference n m).
Proof.
  intros I A D S H Q. unfold share; light_term.lines.
  set (x := Rmax 0 _). set (y := Rmax 0 (mu P L m)).
  assert (M : Rabs (x - y) <= magnitude (difference n m)).
  { eapply Rle_trans; [apply clamp_is_lipschitz | apply mu_is_lipschitz, H]. }
  replace (_ - _) with (i * (albedo * kd * (x - y) + ks * (model n ^ p - model m ^ p))) by ring.
  rewrite Rabs_mult, Rabs_pos_eq, (Rmult_assoc i) by lra. apply Rmult_le_compat_l; auto.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, Rabs_pos_eq, Rabs_pos_eq, (Rabs_pos_eq ks) by assumption.
  assert (albedo * kd * Rabs _ <= albedo * kd * magnitude _) by (apply Rmult_le_compat_l; [nra | exact M]).
  assert (ks * Rabs (model n ^ p - model m ^ p) <= ks * (q * magnitude (difference n m))) by nra. lra.
Qed.
(* The lines of green and blue are red's. *)
Theorem difference_bound__channels colour i albedo kd ks mu specular : light_term.lit_green colour i albedo kd ks mu specular = light_term.lit_red
  colour i albedo kd ks mu specular /\ light_term.lit_blue colour i albedo kd ks mu specular = light_term.lit_red colour i albedo kd ks mu
  specular.
Proof. unfold light_term.lit_green, light_term.lit_blue, light_term.lit_red. lra. Qed.
Theorem difference_bound__channels__false : ~ forall c c' i a kd ks mu s, light_term.lit_green c i a kd ks mu s = light_term.lit_red c' i a kd ks mu s.
Proof. intro H. generalize (H 0 1 0 0 0 0 0 0). unfold light_term.lit_green, light_term.lit_red. lra. Qed.
(* The clip adds nothing. *)
Lemma difference_bound_clip a b : Rabs (clip.clipped a - clip.clipped b) <= Rabs (a - b).
Proof.
  unfold clip.clipped. eapply Rle_trans; [|apply clamp_is_lipschitz]. unfold Rmin, Rabs. repeat destruct Rle_dec; repeat destruct Rcase_abs; lra.
Qed.
Theorem difference_bound__light__point : exists i a d s, 0 <= i /\ 0 <= a /\ 0 <= d /\ 0 <= s.
Proof. exists 1, 1, 1, 1. lra. Qed.

(* The squared highlight *)

Section squared.
Variables P L v n : vector.
Definition mu_squared := let '(px, py, pz) := P in let '(lx, ly, lz) := L in let '(x, y, z) := n in let '(vx, vy, vz) := v in blinn_squared.mu px
  py pz lx ly lz x y z vx vy vz.
Definition base_squared := let '(px, py, pz) := P in let '(lx, ly, lz) := L in let '(x, y, z) := n in let '(vx, vy, vz) := v in
  blinn_squared.specular_base px py pz lx ly lz x y z vx vy vz.
Let d := difference L P.
Let k := vector_sum d (scaled (magnitude d) v).
Let s := / (magnitude d * dot k k).
Lemma squared_is : 0 < dot k k -> mu_squared = dot n d * dot k k * s /\ base_squared = Rmax 0 (dot n k) ^ 2 * magnitude d * s.
Proof.
  unfold s, k, d, mu_squared, base_squared. destruct P as [[px py] pz], L as [[lx ly] lz], n as [[x y] z], v as [[vx vy] vz].
  unfold magnitude; blinn_squared.lines. rewrite difference_is, dot_itself. set (r := sqrt _). unfold vector_sum, scaled. rewrite dot_itself,
    !(Rplus_comm (r * _)). intro K.
  destruct (Rlt_dec _ _) as [_|X]; [|contradiction]. unfold dot, Rdiv. rewrite !Rinv_mult. split; ring.
Qed.
(* With d = L - P, k = d + |d| v and s = 1/(|d| k.k): mu = (N'.d)(k.k)s, and the square of Blinn's base is (N'.k)^2 |d| s where N'.k >= 0.
   The printed shortcut is the model. *)
Theorem squared_highlight__formulas : 0 < magnitude d -> 0 < dot k k -> mu P L n = dot n d * dot k k * s /\
  (0 <= dot n k -> blinn_base P L v n ^ 2 = dot n k ^ 2 * magnitude d * s) /\ mu_squared = mu P L n /\ base_squared = blinn_base P L v n ^ 2.
Proof.
  intros D K. destruct (squared_is K) as [-> ->]. set (h := vector_sum (omega P L) v).
  assert (E : k = scaled (magnitude d) h).
  { unfold k, h, omega. fold d. destruct d as [[a b] c], v as [[x y] z]. unfold vector_sum, scaled. f_equal; [f_equal|]; field; lra. }
  assert (Q : dot k k = magnitude d ^ 2 * dot h h) by (rewrite E, dot_scaled, (dot_comm h), dot_scaled; ring).
  assert (H : 0 < dot h h) by nra. assert (S : magnitude h ^ 2 = dot h h) by apply length_squared. assert (S0 : 0 < magnitude h) by apply sqrt_lt_R0,
    H.
  assert (B : blinn_base P L v n ^ 2 = Rmax 0 (dot n k) ^ 2 * magnitude d * s).
  { rewrite blinn_base_is. fold h. destruct Rlt_dec as [_|X]; [|contradiction]. unfold s. rewrite Q, E, <- S, (dot_comm n (scaled (magnitude d) h)),
    (dot_comm n), !dot_scaled.
    assert (F : forall p x, 0 < p -> Rmax 0 (p * x) = p * Rmax 0 x) by (intros p x X; rewrite <- (Rmult_0_r p) at 1; apply RmaxRmult; lra).
    rewrite !F by (exact D || apply Rinv_0_lt_compat, S0). field. lra. }
  assert (M : mu P L n = dot n d * dot k k * s) by (rewrite mu_is_a_product; unfold omega, s; fold d; rewrite dot_comm, dot_scaled, dot_comm; field;
    lra).
  rewrite M, B. repeat split. intro N. rewrite Rmax_right by lra. reflexivity.
Qed.
End squared.
Lemma above_is : omega (0, 0, 0) (0, 0, 1) = (0, 0, 1).
Proof. unfold omega. rewrite difference_is, length_of_unit, Rinv_1 by (unfold dot; ring). unfold scaled. f_equal; f_equal; ring. Qed.
Lemma above_apart : magnitude (difference (0, 0, 1) (0, 0, 0)) = 1.
Proof. apply length_of_unit. unfold dot, difference, vector_sum, scaled. ring. Qed.
Theorem squared_highlight__formulas__point : exists P L v : vector, let d := difference L P in 0 < magnitude d /\ 0 < dot (vector_sum d (scaled
  (magnitude d) v)) (vector_sum d (scaled (magnitude d) v)).
Proof. exists (0, 0, 0), (0, 0, 1), (0, 0, 1). cbv zeta. rewrite above_apart. unfold difference, dot, vector_sum, scaled. lra. Qed.
(* The square, not the base. *)
Theorem squared_highlight__formulas__false : ~ forall P L v n : vector, let d := difference L P in let k := vector_sum d (scaled (magnitude d) v) in
  0 < magnitude d -> 0 < dot k k -> 0 <= dot n k -> blinn_base P L v n = dot n k ^ 2 * magnitude d * / (magnitude d * dot k k).
Proof.
  intro H. set (n := (0, 3/5, 4/5) : vector). generalize (H (0, 0, 0) (0, 0, 1)) (squared_highlight__formulas (0, 0, 0) (0, 0, 1) (0, 0, 1) n). cbv
    zeta.
  rewrite above_apart. unfold n, difference, dot, vector_sum, scaled. intros E F. rewrite E in F; lra.
Qed.
(* False variants: each with half its bound, or without what it rests on. *)
Theorem specular_lipschitz__highlight__false : ~ forall P L v n m : vector, 0 < magnitude (difference L P) -> magnitude n = 1 -> magnitude m = 1 ->
  magnitude v = 1 ->
  Rabs (phong_base P L v n - phong_base P L v m) <= magnitude (difference n m).
Proof.
  assert (A : magnitude (0, 0, 1) = 1) by (apply length_of_unit; unfold dot; ring). assert (B : magnitude (0, 4/5, 3/5) = 1) by (apply
    length_of_unit; unfold dot; field).
  intro H. generalize (H _ _ _ _ _ ltac:(rewrite above_apart; lra) A B A) (length_squared (difference (0, 0, 1) (0, 4/5, 3/5))) length_nonneg.
    rewrite !phong_base_is. fold (omega (0, 0, 0) (0, 0, 1)). rewrite above_is.
  set (d := magnitude (difference (0, 0, 1) (0, 4/5, 3/5))). unfold dot, difference, vector_sum, scaled. rewrite Rmax_right, Rmax_left by lra.
  rewrite Rabs_pos_eq by lra. nra.
Qed.
Theorem difference_bound__light__false : ~ forall model P L n m i albedo kd ks q p, 0 <= i -> 0 <= albedo -> 0 <= kd -> 0 <= ks -> 0 < magnitude
  (difference L P) -> Rabs (model n ^ p - model m ^ p) <= q * magnitude (difference n m) -> Rabs (share model P L i albedo kd ks p n - share model
  P L i albedo kd ks p m) <= i * (albedo * kd) * magnitude (difference n m).
Proof.
  intro H. generalize (H snd _ _ (0, 0, 1) (0, 0, 0) 1 0 0 1 1 1%nat ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(rewrite above_apart; lra)).
    rewrite above_apart.
  unfold share; light_term.lines. cbn [snd pow]. intro K. specialize (K ltac:(rewrite Rabs_pos_eq; lra)). rewrite Rabs_pos_eq in K; lra.
Qed.
