(* The light models: how the colour depends on the bumped normal. *)

From Coq Require Import Reals Lra Psatz Lia List.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Vectors Fields Bump.
Import ListNotations.
Open Scope R_scope.

(* For every whole p, x^p is Lipschitz with p on [0, 1]: by induction. *)
Lemma power_lipschitz (p : nat) (a b : R) : 0 <= a <= 1 -> 0 <= b <= 1 -> Rabs (a ^ p - b ^ p) <= INR p * Rabs (a - b).
Proof.
  intros A B. induction p as [|p IH]; [simpl; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; lra|].
  replace (a ^ S p - b ^ S p) with (a * (a ^ p - b ^ p) + b ^ p * (a - b)) by (simpl; ring).
  assert (H : 0 <= b ^ p <= 1). { split; [apply pow_le; lra | rewrite <- (pow1 p); apply pow_incr; lra]. }
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, (Rabs_pos_eq a), (Rabs_pos_eq (b ^ p)), S_INR by lra.
  generalize (Rabs_pos (a ^ p - b ^ p)) (Rabs_pos (a - b)). nra.
Qed.

Lemma clamp_is_lipschitz (a b : R) : Rabs (Rmax 0 a - Rmax 0 b) <= Rabs (a - b).
Proof. unfold Rmax, Rabs. destruct (Rle_dec 0 a), (Rle_dec 0 b); repeat destruct Rcase_abs; lra. Qed.

Lemma dot_is_lipschitz (n m w : vector) : magnitude w = 1 -> Rabs (dot n w - dot m w) <= magnitude (difference n m).
Proof.
  intro W. replace (dot n w - dot m w) with (dot (difference n m) w) by (unfold difference; rewrite dot_sum, dot_scaled; ring).
  destruct (cauchy_schwarz (difference n m) w) as [A B]. rewrite W in A, B. apply Rabs_le. lra.
Qed.

(* The models' numbers at a point P lit from L and seen along v: mu and the highlight's base, as functions of N'. *)
Section models.
Variables P L v : vector.
Definition mu (n : vector) : R :=
  let '(px, py, pz) := P in let '(lx, ly, lz) := L in let '(x, y, z) := n in light_direction.mu px py pz lx ly lz x y z.
Definition blinn_base (n : vector) : R :=
  let '(px, py, pz) := P in let '(lx, ly, lz) := L in let '(x, y, z) := n in let '(vx, vy, vz) := v in
  blinn.specular_base px py pz lx ly lz x y z vx vy vz.
Definition phong_base (n : vector) : R :=
  let '(px, py, pz) := P in let '(lx, ly, lz) := L in let '(x, y, z) := n in let '(vx, vy, vz) := v in
  phong.specular_base px py pz lx ly lz x y z vx vy vz.
Definition omega : vector := scaled (/ magnitude (difference L P)) (difference L P).
End models.

Lemma mu_is_a_product (P L n : vector) : mu P L n = dot n (omega P L).
Proof.
  destruct P as [[px py] pz], L as [[lx ly] lz], n as [[x y] z].
  unfold mu, omega, light_direction.mu, light_direction.towards_x, light_direction.towards_y, light_direction.towards_z, light_direction.light_scale,
    light_direction.light_distance, light_direction.to_light_x, light_direction.to_light_y, light_direction.to_light_z, difference, magnitude, dot, scaled, vector_sum.
  replace ((lx - px) ^ 2 + (ly - py) ^ 2 + (lz - pz) ^ 2) with
    ((lx + -1 * px) * (lx + -1 * px) + (ly + -1 * py) * (ly + -1 * py) + (lz + -1 * pz) * (lz + -1 * pz)) by ring. ring.
Qed.
Lemma direction_is_unit (a : vector) : 0 < magnitude a -> magnitude (scaled (/ magnitude a) a) = 1.
Proof. intro H. rewrite length_scaled, Rabs_pos_eq by (left; apply Rinv_0_lt_compat, H). apply Rinv_l. lra. Qed.

(* mu is Lipschitz with 1 in N'. *)
Theorem (* clause 1 *) specular_lipschitz__along_a_direction (P L n m : vector) : 0 < magnitude (difference L P) ->
  Rabs (mu P L n - mu P L m) <= magnitude (difference n m).
Proof. intro H. rewrite !mu_is_a_product. apply dot_is_lipschitz, direction_is_unit, H. Qed.

Lemma blinn_base_is (P L v n : vector) : let k := vector_sum (omega P L) v in
  blinn_base P L v n = if Rlt_dec 0 (magnitude k) then Rmax 0 (dot n (scaled (/ magnitude k) k)) else 0.
Proof.
  cbv zeta. destruct P as [[px py] pz], L as [[lx ly] lz], n as [[x y] z], v as [[vx vy] vz].
  unfold blinn_base, omega, blinn.specular_base, blinn.halfway_length, blinn.halfway_x, blinn.halfway_y, blinn.halfway_z, blinn.towards_x, blinn.towards_y,
    blinn.towards_z, blinn.light_scale, blinn.light_distance, blinn.to_light_x, blinn.to_light_y, blinn.to_light_z, difference, magnitude, dot, scaled, vector_sum.
  replace ((lx - px) ^ 2 + (ly - py) ^ 2 + (lz - pz) ^ 2) with
    ((lx + -1 * px) * (lx + -1 * px) + (ly + -1 * py) * (ly + -1 * py) + (lz + -1 * pz) * (lz + -1 * pz)) by ring.
  set (s := / sqrt _). replace (lx - px) with (lx + -1 * px) by ring. replace (ly - py) with (ly + -1 * py) by ring. replace (lz - pz) with (lz + -1 * pz) by ring.
  set (a := s * _ + vx). set (b := s * _ + vy). set (c := s * _ + vz). replace (a ^ 2 + b ^ 2 + c ^ 2) with (a * a + b * b + c * c) by ring.
  destruct (Rlt_dec 0 (sqrt (a * a + b * b + c * c))); [|reflexivity]. rewrite Rmax_comm. f_equal. unfold Rdiv. ring.
Qed.

(* Blinn's base is Lipschitz with 1. *)
Theorem (* clause 1 *) specular_lipschitz__blinn (P L v n m : vector) : Rabs (blinn_base P L v n - blinn_base P L v m) <= magnitude (difference n m).
Proof.
  rewrite !blinn_base_is. destruct (Rlt_dec _ _) as [H|H].
  - eapply Rle_trans; [apply clamp_is_lipschitz|]. apply dot_is_lipschitz, direction_is_unit, H.
  - rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. apply length_nonneg.
Qed.

Lemma phong_base_is (P L v n : vector) : phong_base P L v n = Rmax 0 (2 * dot n (omega P L) * dot n v - dot (omega P L) v).
Proof.
  rewrite <- mu_is_a_product. destruct P as [[px py] pz], L as [[lx ly] lz], n as [[x y] z], v as [[vx vy] vz].
  unfold phong_base, mu, omega, phong.specular_base, phong.mu, phong.towards_x, phong.towards_y, phong.towards_z, phong.light_scale, phong.light_distance,
    phong.to_light_x, phong.to_light_y, phong.to_light_z, light_direction.mu, light_direction.towards_x, light_direction.towards_y, light_direction.towards_z,
    light_direction.light_scale, light_direction.light_distance, light_direction.to_light_x, light_direction.to_light_y, light_direction.to_light_z,
    difference, magnitude, dot, scaled, vector_sum.
  replace ((lx - px) ^ 2 + (ly - py) ^ 2 + (lz - pz) ^ 2) with
    ((lx + -1 * px) * (lx + -1 * px) + (ly + -1 * py) * (ly + -1 * py) + (lz + -1 * pz) * (lz + -1 * pz)) by ring. f_equal. ring.
Qed.

Ltac expand_dots :=
  unfold difference;
  repeat first
    [ rewrite dot_sum | rewrite dot_scaled
    | match goal with
      | |- context [dot ?a (vector_sum ?b ?c)] => rewrite (dot_comm a (vector_sum b c))
      | |- context [dot ?a (scaled ?t ?b)] => rewrite (dot_comm a (scaled t b))
      end ].

(* Bessel's inequality for two orthogonal vectors. *)
Lemma bessel (s d w : vector) : dot s d = 0 -> magnitude w = 1 ->
  dot d d * dot s w ^ 2 + dot s s * dot d w ^ 2 <= dot s s * dot d d.
Proof.
  intros O W. assert (W2 : dot w w = 1) by (rewrite <- length_squared, W; ring).
  generalize (dot_nonneg s) (dot_nonneg d) (cauchy_schwarz s w) (cauchy_schwarz d w). intros PS PD CS CD. rewrite W in CS, CD.
  set (k := difference (scaled (dot s s * dot d d) w) (vector_sum (scaled (dot d d * dot s w) s) (scaled (dot s s * dot d w) d))).
  assert (E : dot k k = dot s s * dot d d * (dot s s * dot d d - (dot d d * dot s w ^ 2 + dot s s * dot d w ^ 2))).
  { unfold k. expand_dots. rewrite ?(dot_comm w s), ?(dot_comm w d), ?(dot_comm d s), ?O, W2. ring. }
  generalize (dot_nonneg k). rewrite E. intro K.
  destruct PS as [PS|PS]; [destruct PD as [PD|PD]|].
  - assert (0 < dot s s * dot d d) by nra. nra.
  - assert (magnitude d = 0) by (unfold magnitude; rewrite <- PD; apply sqrt_0). assert (dot d w = 0) by nra. rewrite <- PD. nra.
  - assert (magnitude s = 0) by (unfold magnitude; rewrite <- PS; apply sqrt_0). assert (dot s w = 0) by nra. rewrite <- PS. nra.
Qed.

(* Mirroring w at the unit vectors n and m gives vectors whose product with v differs by at most 2 |n - m|. *)
Theorem (* clause 1 *) specular_lipschitz__mirror (n m w v : vector) : magnitude n = 1 -> magnitude m = 1 -> magnitude w = 1 -> magnitude v = 1 ->
  Rabs ((2 * dot n w * dot n v - dot w v) - (2 * dot m w * dot m v - dot w v)) <= 2 * magnitude (difference n m).
Proof.
  intros Hn Hm Hw Hv. set (s := vector_sum n m). set (d := difference n m).
  replace (2 * dot n w * dot n v - dot w v - (2 * dot m w * dot m v - dot w v)) with (dot s w * dot d v + dot d w * dot s v)
    by (unfold s, d; expand_dots; ring).
  assert (O : dot s d = 0) by (unfold s, d; expand_dots; rewrite (dot_comm m n), <- !length_squared, Hn, Hm; ring).
  assert (Q : dot s s + dot d d = 4) by (unfold s, d; expand_dots; rewrite (dot_comm m n), <- !length_squared, Hn, Hm; ring).
  generalize (bessel s d w O Hw) (bessel s d v O Hv) (length_squared d) (length_nonneg d) (dot_nonneg s) (dot_nonneg d).
  set (A := dot s w). set (A' := dot s v). set (D := dot d w). set (D' := dot d v). intros B B' L L0 PS PD.
  assert (X : (A * D' + D * A') ^ 2 <= dot s s * dot d d).
  { destruct PS as [PS|PS]; [destruct PD as [PD|PD]|].
    - apply Rmult_le_reg_r with (dot s s * dot d d); [nra|].
      assert ((A * D' + D * A') ^ 2 * (dot s s * dot d d) <= (dot d d * A ^ 2 + dot s s * D ^ 2) * (dot s s * D' ^ 2 + dot d d * A' ^ 2)).
      { generalize (pow2_ge_0 (dot d d * A * A' - dot s s * D * D')). nra. }
      eapply Rle_trans; [eassumption|]. apply Rmult_le_compat; nra.
    - rewrite <- PD in *. assert (D = 0) by nra. assert (D' = 0) by nra. subst D D'. rewrite H, H0. nra.
    - rewrite <- PS in *. assert (A = 0) by nra. assert (A' = 0) by nra. subst A A'. rewrite H, H0. nra. }
  assert (Y : (A * D' + D * A') ^ 2 <= (2 * magnitude d) ^ 2) by (rewrite Rpow_mult_distr, L; nra).
  rewrite <- (pow2_abs (A * D' + D * A')) in Y. apply le_of_squares; [lra | exact Y].
Qed.

(* Phong's base is Lipschitz with 2, between unit normals. *)
Theorem (* clause 1 *) specular_lipschitz__phong (P L v n m : vector) : 0 < magnitude (difference L P) -> magnitude n = 1 -> magnitude m = 1 -> magnitude v = 1 ->
  Rabs (phong_base P L v n - phong_base P L v m) <= 2 * magnitude (difference n m).
Proof.
  intros H Hn Hm Hv. rewrite !phong_base_is. eapply Rle_trans; [apply clamp_is_lipschitz|].
  apply specular_lipschitz__mirror; trivial. apply direction_is_unit, H.
Qed.

(* Both bases lie in [0, 1] for unit normals. *)
Lemma product_of_units (n w : vector) : magnitude n = 1 -> magnitude w = 1 -> -1 <= dot n w <= 1.
Proof. intros normal_at W. destruct (cauchy_schwarz n w) as [A B]. rewrite normal_at, W in *. lra. Qed.
Lemma blinn_base_in_unit (P L v n : vector) : magnitude n = 1 -> 0 <= blinn_base P L v n <= 1.
Proof.
  intro normal_at. rewrite blinn_base_is. destruct (Rlt_dec _ _) as [H|H]; [|lra]. generalize (product_of_units n _ normal_at (direction_is_unit _ H)).
  unfold Rmax. destruct (Rle_dec _ _); lra.
Qed.
Lemma phong_base_in_unit (P L v n : vector) : 0 < magnitude (difference L P) -> magnitude n = 1 -> magnitude v = 1 -> 0 <= phong_base P L v n <= 1.
Proof.
  intros H normal_at V. rewrite phong_base_is. generalize (direction_is_unit _ H). fold (omega P L). intro W.
  set (r := difference (scaled (2 * dot n (omega P L)) n) (omega P L)).
  assert (R : magnitude r = 1).
  { apply length_of_unit. unfold r. expand_dots. rewrite (dot_comm (omega P L) n), <- !length_squared, normal_at, W. ring. }
  replace (2 * dot n (omega P L) * dot n v - dot (omega P L) v) with (dot r v) by (unfold r; expand_dots; ring).
  generalize (product_of_units r v R V). unfold Rmax. destruct (Rle_dec _ _); lra.
Qed.

(* So the highlight base^p is Lipschitz with p (Blinn) and 2p (Phong), for every whole p. *)
Theorem (* clause 3 *) specular_lipschitz__power (p : nat) (P L v n m : vector) : 0 < magnitude (difference L P) -> magnitude n = 1 -> magnitude m = 1 -> magnitude v = 1 ->
  Rabs (blinn_base P L v n ^ p - blinn_base P L v m ^ p) <= INR p * magnitude (difference n m) /\
  Rabs (phong_base P L v n ^ p - phong_base P L v m ^ p) <= 2 * INR p * magnitude (difference n m).
Proof.
  intros H Hn Hm Hv. generalize (pos_INR p). intro I. split.
  - eapply Rle_trans; [apply power_lipschitz; apply blinn_base_in_unit; assumption|]. apply Rmult_le_compat_l; [exact I | apply specular_lipschitz__blinn].
  - eapply Rle_trans; [apply power_lipschitz; apply phong_base_in_unit; assumption|].
    replace (2 * INR p * magnitude (difference n m)) with (INR p * (2 * magnitude (difference n m))) by ring.
    apply Rmult_le_compat_l; [exact I | apply specular_lipschitz__phong; assumption].
Qed.
Theorem specular_lipschitz__power__point : exists P L v n : vector, 0 < magnitude (difference L P) /\ magnitude n = 1 /\ magnitude v = 1.
Proof.
  exists (0, 0, 0), (1, 0, 0), (1, 0, 0), (1, 0, 0).
  assert (E : magnitude (1, 0, 0) = 1) by (apply length_of_unit; unfold dot; ring). split; [|split; exact E].
  replace (difference (1, 0, 0) (0, 0, 0)) with ((1, 0, 0) : vector) by (unfold difference, vector_sum, scaled; f_equal; [f_equal|]; ring). rewrite E. lra.
Qed.
(* On [0, 1] itself: |x^p - z^p| <= p |x - z|; one step of the recurrence keeps the factor q of x^p - z^p, and p - q, from being negative. *)
Theorem (* clauses 2, 3 *) specular_lipschitz__whole_power (p : nat) (x z : R) : 0 <= x <= 1 -> 0 <= z <= 1 -> Rabs (x ^ p - z ^ p) <= INR p * Rabs (x - z).
Proof. apply power_lipschitz. Qed.
Theorem specular_lipschitz__whole_power__point : exists x z : R, 0 <= x <= 1 /\ 0 <= z <= 1.
Proof. exists 0, 1. lra. Qed.
Theorem specular_lipschitz__whole_power__false : ~ forall (p : nat) x z, Rabs (x ^ p - z ^ p) <= INR p * Rabs (x - z).
Proof. intro H. generalize (H 2%nat 2 1). rewrite !Rabs_pos_eq; simpl; lra. Qed.
Theorem (* clause 2 *) specular_lipschitz__step (p : nat) (x z q : R) : 0 <= x <= 1 -> 0 <= z <= 1 -> x ^ p - z ^ p = q * (x - z) -> 0 <= q <= INR p ->
  x ^ S p - z ^ S p = (x * q + z ^ p) * (x - z) /\ 0 <= x * q + z ^ p <= INR (S p).
Proof.
  intros X Z E Q. assert (H : 0 <= z ^ p <= 1) by (split; [apply pow_le; lra | rewrite <- (pow1 p); apply pow_incr; lra]). rewrite S_INR. cbn [pow]. split; [|split; nra].
  replace (x * x ^ p) with (x * (z ^ p + q * (x - z))) by (rewrite <- E; ring). ring.
Qed.
Theorem specular_lipschitz__step__point : exists (p : nat) (x z q : R), 0 <= x <= 1 /\ 0 <= z <= 1 /\ x ^ p - z ^ p = q * (x - z) /\ 0 <= q <= INR p.
Proof. exists 0%nat, 1, 0, 0. simpl. lra. Qed.
Theorem specular_lipschitz__step__false : ~ forall (p : nat) (x z q : R), 0 <= x <= 1 -> 0 <= z <= 1 -> x ^ p - z ^ p = q * (x - z) -> x ^ S p - z ^ S p = x * q * (x - z).
Proof. intro H. generalize (H 0%nat 1 0 0 ltac:(lra) ltac:(lra)). simpl. lra. Qed.
(* With p alone Phong's is not. *)
Theorem specular_lipschitz__power__false : ~ forall (p : nat) (a b : R), 0 <= a <= 1 -> 0 <= b <= 1 -> Rabs (a ^ p - b ^ p) <= Rabs (a - b).
Proof.
  intro H. generalize (H 2%nat 1 (1/2) ltac:(lra) ltac:(lra)). rewrite !Rabs_pos_eq; simpl; lra.
Qed.

(* The error of a colour *)

(* A light's share of a channel. *)
Definition share (model : vector -> R) (P L : vector) (i albedo kd ks : R) (p : nat) (n : vector) : R :=
  light_term.lit_red 0 i albedo kd ks (mu P L n) (model n ^ p).

(* It moves by at most i (a k_d + k_s q) |N'_1 - N'_2| where base^p is Lipschitz with q. *)
Theorem difference_bound__light (model : vector -> R) (P L n m : vector) (i albedo kd ks q : R) (p : nat) :
  0 <= i -> 0 <= albedo -> 0 <= kd -> 0 <= ks -> 0 < magnitude (difference L P) ->
  Rabs (model n ^ p - model m ^ p) <= q * magnitude (difference n m) ->
  Rabs (share model P L i albedo kd ks p n - share model P L i albedo kd ks p m) <= i * (albedo * kd + ks * q) * magnitude (difference n m).
Proof.
  intros I A D S H Q. unfold share, light_term.lit_red, light_term.diffuse, light_term.shine.
  set (x := Rmax 0 (mu P L n)). set (y := Rmax 0 (mu P L m)).
  assert (M : Rabs (x - y) <= magnitude (difference n m)).
  { eapply Rle_trans; [apply clamp_is_lipschitz | apply specular_lipschitz__along_a_direction, H]. }
  replace (_ - _) with (i * (albedo * kd * (x - y) + ks * (model n ^ p - model m ^ p))) by ring.
  rewrite Rabs_mult, (Rabs_pos_eq i), (Rmult_assoc i (albedo * kd + ks * q)) by exact I. apply Rmult_le_compat_l; [exact I|].
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, (Rabs_pos_eq albedo), (Rabs_pos_eq kd), (Rabs_pos_eq ks) by assumption.
  assert (albedo * kd * Rabs (x - y) <= albedo * kd * magnitude (difference n m)) by (apply Rmult_le_compat_l; [apply Rmult_le_pos; assumption | exact M]).
  assert (ks * Rabs (model n ^ p - model m ^ p) <= ks * (q * magnitude (difference n m))) by (apply Rmult_le_compat_l; assumption). lra.
Qed.
(* The lines of green and blue are red's. *)
Theorem difference_bound__channels (colour i albedo kd ks mu specular : R) :
  light_term.lit_green colour i albedo kd ks mu specular = light_term.lit_red colour i albedo kd ks mu specular /\
  light_term.lit_blue colour i albedo kd ks mu specular = light_term.lit_red colour i albedo kd ks mu specular.
Proof. unfold light_term.lit_green, light_term.lit_blue, light_term.lit_red. split; ring. Qed.
Theorem difference_bound__channels__false : ~ forall c c' i a kd ks mu s, light_term.lit_green c i a kd ks mu s = light_term.lit_red c' i a kd ks mu s.
Proof. intro H. generalize (H 0 1 0 0 0 0 0 0). unfold light_term.lit_green, light_term.lit_red. lra. Qed.
(* The clip adds nothing. *)
Lemma difference_bound_clip (a b : R) : Rabs (clip.clipped a - clip.clipped b) <= Rabs (a - b).
Proof.
  unfold clip.clipped. eapply Rle_trans; [|apply clamp_is_lipschitz]. unfold Rmin, Rabs. repeat destruct Rle_dec; repeat destruct Rcase_abs; lra.
Qed.
Theorem difference_bound__light__point : exists i a d s : R, 0 <= i /\ 0 <= a /\ 0 <= d /\ 0 <= s.
Proof. exists 1, 1, 1, 1. lra. Qed.

(* The squared highlight *)

(* mu = (N'.d)(k.k)s and base^2 = (N'.k)^2 |d| s where N'.k >= 0: the printed shortcut is the model. *)
Theorem squared_highlight__is_blinn (px py pz lx ly lz x y z vx vy vz : R) :
  0 < (lx - px) ^ 2 + (ly - py) ^ 2 + (lz - pz) ^ 2 -> 0 < blinn.halfway_length px py pz lx ly lz vx vy vz ->
  blinn_squared.mu px py pz lx ly lz x y z vx vy vz = blinn.mu px py pz lx ly lz x y z /\
  blinn_squared.specular_base px py pz lx ly lz x y z vx vy vz = blinn.specular_base px py pz lx ly lz x y z vx vy vz ^ 2.
Proof.
  intros D0 H0. unfold blinn.specular_base. destruct (Rlt_dec _ _) as [_|H]; [|contradiction].
  unfold blinn.halfway_length, blinn.halfway_x, blinn.halfway_y, blinn.halfway_z, blinn.mu, blinn.towards_x, blinn.towards_y, blinn.towards_z, blinn.light_scale,
    blinn.light_distance, blinn.to_light_x, blinn.to_light_y, blinn.to_light_z in *.
  unfold blinn_squared.mu, blinn_squared.specular_base, blinn_squared.light_scale, blinn_squared.along_halfway, blinn_squared.along_light, blinn_squared.halfway_squared,
    blinn_squared.halfway_x, blinn_squared.halfway_y, blinn_squared.halfway_z, blinn_squared.light_distance, blinn_squared.distance_squared, blinn_squared.to_light_x,
    blinn_squared.to_light_y, blinn_squared.to_light_z.
  set (r := sqrt ((lx - px) ^ 2 + (ly - py) ^ 2 + (lz - pz) ^ 2)) in *. assert (R : 0 < r) by (apply sqrt_lt_R0; exact D0). clearbody r. clear D0.
  generalize dependent (lx - px). generalize dependent (ly - py). generalize dependent (lz - pz). intros c b a H0.
  set (q := (/ r * a + vx) ^ 2 + (/ r * b + vy) ^ 2 + (/ r * c + vz) ^ 2) in *.
  assert (Q : 0 < q) by (apply Rnot_le_lt; intro L; rewrite (sqrt_neg_0 q L) in H0; lra).
  assert (E : (r * vx + a) ^ 2 + (r * vy + b) ^ 2 + (r * vz + c) ^ 2 = r ^ 2 * q) by (unfold q; field; lra). rewrite E.
  assert (Q' : 0 < r ^ 2 * q) by (apply Rmult_lt_0_compat; [apply pow_lt, R | exact Q]).
  destruct (Rlt_dec 0 (r ^ 2 * q)) as [_|X]; [|contradiction]. split; [field; lra|].
  assert (S : sqrt q ^ 2 = q) by (apply pow2_sqrt; lra). assert (S0 : 0 < sqrt q) by (apply sqrt_lt_R0; exact Q).
  set (w := x * (/ r * a + vx) + y * (/ r * b + vy) + z * (/ r * c + vz)).
  assert (W : x * (r * vx + a) + y * (r * vy + b) + z * (r * vz + c) = r * w) by (unfold w; field; lra). rewrite W.
  unfold Rmax. destruct (Rle_dec 0 (r * w)) as [T|T], (Rle_dec (w / sqrt q) 0) as [V|V].
  - assert (w = 0). { assert (0 <= w) by nra. assert (w <= 0); [|lra]. apply Rmult_le_reg_r with (/ sqrt q); [apply Rinv_0_lt_compat, S0|]. unfold Rdiv in V. lra. } subst w. rewrite H. field. lra.
  - replace ((w / sqrt q) ^ 2) with (w ^ 2 / q) by (rewrite <- S at 1; field; lra). field. lra.
  - field. lra.
  - exfalso. apply V. assert (w < 0) by nra. unfold Rdiv. assert (0 < / sqrt q) by (apply Rinv_0_lt_compat, S0). nra.
Qed.
Theorem difference_bound__clip__false : ~ forall a b, Rabs (clip.clipped a - clip.clipped b) = Rabs (a - b).
Proof.
  intro H. generalize (H 2 1). unfold clip.clipped. rewrite (Rmax_right 0 2), (Rmax_right 0 1), (Rmin_left 1 2), (Rmin_left 1 1) by lra.
  rewrite Rminus_diag_eq, Rabs_R0, Rabs_pos_eq by lra. lra.
Qed.
(* The printed shortcut is the base's square, not the base. *)
Theorem squared_highlight__is_blinn__false : ~ forall y z,
  blinn_squared.specular_base 0 0 0 0 0 1 0 y z 0 0 1 = blinn.specular_base 0 0 0 0 0 1 0 y z 0 0 1.
Proof.
  assert (R : sqrt ((0 - 0) ^ 2 + (0 - 0) ^ 2 + (1 - 0) ^ 2) = 1) by (replace (_ + _) with 1 by ring; apply sqrt_1).
  generalize halfway_above. intro W.
  intro H. generalize (H (3/5) (4/5)). rewrite (proj2 (squared_highlight__is_blinn 0 0 0 0 0 1 0 (3/5) (4/5) 0 0 1 ltac:(lra) ltac:(rewrite W; lra))).
  assert (E : blinn.specular_base 0 0 0 0 0 1 0 (3/5) (4/5) 0 0 1 = 4/5).
  { unfold blinn.specular_base. rewrite W. destruct (Rlt_dec 0 2) as [_|X]; [|lra]. unfold blinn.halfway_x, blinn.halfway_y, blinn.halfway_z, blinn.towards_x,
      blinn.towards_y, blinn.towards_z, blinn.light_scale, blinn.light_distance, blinn.to_light_x, blinn.to_light_y, blinn.to_light_z.
    rewrite R, Rinv_1. rewrite Rmax_left; field_simplify; lra. }
  rewrite E. lra.
Qed.
(* False variants: each with half its bound, or without what it rests on. *)
Lemma above_is : omega (0, 0, 0) (0, 0, 1) = (0, 0, 1).
Proof.
  unfold omega. replace (difference (0, 0, 1) (0, 0, 0)) with ((0, 0, 1) : vector) by (unfold difference, vector_sum, scaled; f_equal; [f_equal|]; ring).
  rewrite (length_of_unit (0, 0, 1)), Rinv_1 by (unfold dot; ring). unfold scaled. f_equal; [f_equal|]; ring.
Qed.
Lemma above_apart : magnitude (difference (0, 0, 1) (0, 0, 0)) = 1.
Proof. apply length_of_unit. unfold dot, difference, vector_sum, scaled. ring. Qed.
Theorem specular_lipschitz__along_a_direction__false : ~ forall P L n m : vector, 0 < magnitude (difference L P) -> Rabs (mu P L n - mu P L m) <= magnitude (difference n m) / 2.
Proof.
  intro H. generalize (H (0, 0, 0) (0, 0, 1) (0, 0, 1) (0, 0, 0) ltac:(rewrite above_apart; lra)). rewrite !mu_is_a_product, above_is, above_apart. unfold dot. rewrite Rabs_pos_eq; lra.
Qed.
Theorem specular_lipschitz__blinn__false : ~ forall P L v n m : vector, Rabs (blinn_base P L v n - blinn_base P L v m) <= magnitude (difference n m) / 2.
Proof.
  intro H. generalize (H (0, 0, 0) (0, 0, 1) (0, 0, 1) (0, 0, 1) (0, 0, 0)). rewrite !blinn_base_is, above_is, above_apart.
  replace (vector_sum (0, 0, 1) (0, 0, 1)) with (scaled 2 (0, 0, 1)) by (unfold vector_sum, scaled; f_equal; [f_equal|]; ring).
  rewrite length_scaled, (length_of_unit (0, 0, 1)), (Rabs_pos_eq 2) by (try (unfold dot; ring); lra). destruct (Rlt_dec _ _) as [_|X]; [|lra]. unfold dot, scaled.
  rewrite !Rmax_right by lra. rewrite Rabs_pos_eq; lra.
Qed.
Theorem specular_lipschitz__mirror__false : ~ forall n m w v : vector, magnitude n = 1 -> magnitude m = 1 -> magnitude w = 1 -> magnitude v = 1 ->
  Rabs ((2 * dot n w * dot n v - dot w v) - (2 * dot m w * dot m v - dot w v)) <= magnitude (difference n m).
Proof.
  assert (A : magnitude (0, 0, 1) = 1) by (apply length_of_unit; unfold dot; ring). assert (B : magnitude (0, 1, 0) = 1) by (apply length_of_unit; unfold dot; ring).
  intro H. generalize (H (0, 0, 1) (0, 1, 0) (0, 0, 1) (0, 0, 1) A B A A) (length_squared (difference (0, 0, 1) (0, 1, 0))) (length_nonneg (difference (0, 0, 1) (0, 1, 0))).
  set (d := magnitude (difference (0, 0, 1) (0, 1, 0))). unfold dot, difference, vector_sum, scaled. rewrite Rabs_pos_eq by lra. nra.
Qed.
Theorem specular_lipschitz__phong__false : ~ forall P L v n m : vector, 0 < magnitude (difference L P) -> magnitude n = 1 -> magnitude m = 1 -> magnitude v = 1 ->
  Rabs (phong_base P L v n - phong_base P L v m) <= magnitude (difference n m).
Proof.
  assert (A : magnitude (0, 0, 1) = 1) by (apply length_of_unit; unfold dot; ring). assert (B : magnitude (0, 4/5, 3/5) = 1) by (apply length_of_unit; unfold dot; field).
  intro H. generalize (H (0, 0, 0) (0, 0, 1) (0, 0, 1) (0, 0, 1) (0, 4/5, 3/5) ltac:(rewrite above_apart; lra) A B A) (length_squared (difference (0, 0, 1) (0, 4/5, 3/5)))
    (length_nonneg (difference (0, 0, 1) (0, 4/5, 3/5))). rewrite !phong_base_is. fold (omega (0, 0, 0) (0, 0, 1)). rewrite above_is.
  set (d := magnitude (difference (0, 0, 1) (0, 4/5, 3/5))). unfold dot, difference, vector_sum, scaled. rewrite (Rmax_right 0 (2 * _ * _ - _)), (Rmax_left 0 (2 * _ * _ - _)) by lra.
  rewrite Rabs_pos_eq by lra. nra.
Qed.
Theorem difference_bound__light__false : ~ forall (model : vector -> R) (P L n m : vector) (i albedo kd ks q : R) (p : nat),
  0 <= i -> 0 <= albedo -> 0 <= kd -> 0 <= ks -> 0 < magnitude (difference L P) -> Rabs (model n ^ p - model m ^ p) <= q * magnitude (difference n m) ->
  Rabs (share model P L i albedo kd ks p n - share model P L i albedo kd ks p m) <= i * (albedo * kd) * magnitude (difference n m).
Proof.
  intro H. generalize (H snd (0, 0, 0) (0, 0, 1) (0, 0, 1) (0, 0, 0) 1 0 0 1 1 1%nat ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(rewrite above_apart; lra)). rewrite above_apart.
  cbn [snd pow]. unfold share, light_term.lit_red, light_term.diffuse, light_term.shine. cbn [snd pow]. intro K. specialize (K ltac:(rewrite Rabs_pos_eq; lra)). rewrite Rabs_pos_eq in K; lra.
Qed.
