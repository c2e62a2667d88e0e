(* The slopes of the error curves of differences on log-log axes, as limits. *)

From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Formulas Clamped Orders.
Open Scope R_scope.

(* As the step e tends to 0 from above. *)
Definition tends_to (f : R -> R) (l : R) := filterlim f (at_right 0) (locally l).
(* An error over e^p tends to C; and where C is not 0, on log-log axes the slope from e to c e, whatever c, to p. *)
Definition falls_like (error : R -> R) (p C : R) := tends_to (fun e => error e / Rpower e p) C /\ (C <> 0 -> forall c, 0 < c -> c <> 1 -> tends_to
  (fun e => (ln (Rabs (error (c * e))) - ln (Rabs (error e))) / (ln (c * e) - ln e)) p).

Lemma tends_ext (f g : R -> R) (d l : R) : 0 < d -> (forall e, 0 < e <= d -> f e = g e) -> tends_to f l -> tends_to g l.
Proof.
  intros D E. apply filterlim_ext_loc. exists (mkposreal d D). intros e B P. apply E. change (Rabs (e - 0) < d) in B. apply Rabs_def2 in B. lra.
Qed.
Lemma tends_sum (f g : R -> R) (a b l m : R) : tends_to f l -> tends_to g m -> tends_to (fun e => a * f e + b * g e) (a * l + b * m).
Proof.
  intros F G. eapply filterlim_comp_2 with (3 := filterlim_plus _ (b * m)); eapply filterlim_comp; [exact F | apply (filterlim_scal_r a l) | exact G
    | apply (filterlim_scal_r b m)].
Qed.
Lemma tends_is (f : R -> R) (l m : R) : tends_to f l -> l = m -> tends_to f m.
Proof. intros F <-. exact F. Qed.
Lemma multiple_of_step (c : R) : 0 < c -> filterlim (fun e => c * e) (at_right 0) (at_right 0).
Proof.
  intros P A [d B]. exists (mkposreal _ (Rdiv_lt_0_compat _ _ (cond_pos d) P)). intros e E Q. apply B; [| nra].
  change (Rabs (e - 0) < d / c) in E. change (Rabs (c * e - 0) < d). rewrite Rminus_0_r in *. rewrite Rabs_mult, Rabs_pos_eq by lra.
  apply (Rmult_lt_compat_l c) in E; auto. replace (c * (d / c)) with (d : R) in E by (field; lra). lra.
Qed.

Lemma slope_of_logarithms (error : R -> R) (p C : R) : tends_to (fun e => error e / Rpower e p) C -> falls_like error p C.
Proof.
  intro T. split; auto. intros N c P U. set (q e := error e / Rpower e p) in *. pose proof multiple_of_step c P as M.
  assert (L : tends_to (fun e => ln (Rabs (q e))) (ln (Rabs C))).
  { apply (filterlim_comp _ _ _ q (fun y => ln (Rabs y)) _ (locally C)); auto. apply (ex_derive_continuous (fun y => ln _)).
    auto_derive. repeat split; [lra | apply Rabs_pos_lt, N]. }
  assert (Z : at_right 0 (fun e => 0 < e /\ q e <> 0)).
  { apply filter_and; [exists (mkposreal 1 Rlt_0_1); trivial|]. apply (T (fun y => y <> 0)). exists (mkposreal _ (Rabs_pos_lt C N)). intros y B E.
    change (Rabs (y - C) < Rabs C) in B. rewrite E, Rminus_0_l, Rabs_Ropp in B. lra. }
  assert (ln c <> 0) by (rewrite <- ln_1; intro E; apply U, ln_inv; lra).
  pose proof tends_sum _ _ (/ ln c) (- / ln c) _ _ (filterlim_comp _ _ _ _ _ _ _ _ M L) L as S.
  apply (tends_is _ (1 * p + 1 * (/ ln c * ln (Rabs C) + - / ln c * ln (Rabs C)))); [|ring].
  eapply filterlim_ext_loc; [|exact (tends_sum _ _ 1 1 _ _ (filterlim_const p) S)].
  apply (filter_imp (fun e => (0 < e /\ q e <> 0) /\ 0 < c * e /\ q (c * e) <> 0)); [|apply filter_and; [exact Z | exact (M _ Z)]].
  assert (G : forall e, 0 < e -> q e <> 0 -> ln (Rabs (error e)) = ln (Rabs (q e)) + p * ln e).
  { intros e E Q. assert (0 < Rpower e p) by apply exp_pos. replace (error e) with (q e * Rpower e p) by (unfold q; field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq (Rpower e p)), ln_mult by (try apply Rabs_pos_lt; lra || exact Q). unfold Rpower. rewrite ln_exp. reflexivity. }
  intros e [[E Q] [E' Q']]. rewrite !G by assumption. rewrite ln_mult by assumption. field. lra.
Qed.

(* A quotient by a power, from that of derivatives (Cauchy). *)
Lemma integrated (F F1 : R -> R) (n : nat) (l : R) : (forall t, is_derive F t (F1 t)) -> F 0 = 0 -> tends_to (fun t => F1 t / t ^ n) l ->
  tends_to (fun t => F t / t ^ S n) (l / INR (S n)).
Proof.
  intros D Z T. assert (1 <= INR (S n)) by (rewrite S_INR; generalize (pos_INR n); lra).
  apply filterlim_locally. intro eps. destruct (proj1 (filterlim_locally _ _) T eps) as [d B]. exists d. intros t Bt P.
  change (Rabs (t - 0) < d) in Bt. rewrite Rminus_0_r, Rabs_pos_eq in Bt by lra.
  destruct (MVT_cor2 (fun w => F w * t ^ S n - F t * w ^ S n) (fun w => F1 w * t ^ S n - F t * (INR (S n) * w ^ n)) 0 t P) as (c & E & C).
  { intros c _. apply is_derive_Reals. auto_derive; [eexists; apply D|]. rewrite (is_derive_unique _ _ _ (D _)). destruct n; simpl; ring. }
  assert (0 < c ^ n) by (apply pow_lt; lra). assert (0 < t ^ S n) by (apply pow_lt; lra). rewrite Z, pow_i in E by lia.
  assert (Q : F1 c * t ^ S n = F t * (INR (S n) * c ^ n)) by (apply (Rmult_eq_reg_r (t - 0)); lra).
  assert (G : F t / t ^ S n - l / INR (S n) = (F1 c / c ^ n - l) / INR (S n)).
  { replace (F t) with (F1 c * t ^ S n / (INR (S n) * c ^ n)) by (rewrite Q; field; lra). field. lra. }
  change (Rabs (F t / t ^ S n - l / INR (S n)) < eps). rewrite G. unfold Rdiv. rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq (INR _)) by lra.
  specialize (B c ltac:(change (Rabs (c - 0) < d); rewrite Rabs_pos_eq; lra) ltac:(lra)). change (Rabs (F1 c / c ^ n - l) < eps) in B.
  apply (Rmult_lt_reg_r (INR (S n))); [lra|]. rewrite Rmult_assoc, Rinv_l by lra. generalize (cond_pos eps). intro. nra.
Qed.
Lemma derived (f : R -> R) (l : R) : is_derive f 0 l -> f 0 = 0 -> tends_to (fun t => f t / t ^ 1) l.
Proof.
  intros D Z. apply is_derive_Reals in D. apply filterlim_locally. intro eps. destruct (D eps (cond_pos eps)) as [d B]. exists d. intros t Bt P.
  change (Rabs (t - 0) < d) in Bt. rewrite Rminus_0_r in Bt. generalize (B t ltac:(lra) Bt). rewrite Rplus_0_l, Z, Rminus_0_r, pow_1. trivial.
Qed.
(* So of an error that is F(e)/(d e). *)
Lemma falls (error F F1 : R -> R) (n : nat) (d l p C : R) : (forall t, is_derive F t (F1 t)) -> F 0 = 0 -> tends_to (fun t => F1 t / t ^ n) l ->
  d <> 0 -> (forall t, 0 < t -> error t = F t / (d * t)) -> p = INR n -> C = l / INR (S n) / d -> falls_like error p C.
Proof.
  intros D Z T N E -> ->. apply slope_of_logarithms.
  apply (tends_ext (fun t => / d * (F t / t ^ S n) + 0 * (F t / t ^ S n)) _ 1); [lra| |].
  - intros t [P _]. rewrite E, Rpower_pow by lra. assert (t ^ n <> 0) by (apply pow_nonzero; lra). simpl pow. field. lra.
  - pose proof integrated F F1 n l D Z T as I. eapply tends_is; [exact (tends_sum _ _ _ 0 _ _ I I) | lra].
Qed.

(* What is 0 at the step 0, and its derivative there. *)
Ltac nothing_at_0 := rewrite ?Rmult_0_r, ?Rplus_0_r, ?Rplus_0_l, ?Rminus_0_r; try match goal with Z : _ 0 = 0 |- _ => rewrite Z end; ring.
Ltac at_0 D := apply derived; [auto_derive; rewrite ?Rmult_0_r, ?Ropp_0, ?Rplus_0_r, ?Rplus_0_l;
  [repeat split; eexists; exact D | erewrite is_derive_unique by exact D; ring] | nothing_at_0].

(* Away from the seam and the poles, order p and coefficient c times the third derivative, *)
Definition central_falls (p c : R) := forall (h h1 h2 : R -> R) (x h3 : R), (forall w, is_derive h w (h1 w)) -> (forall w, is_derive h1 w (h2 w))
  -> is_derive h2 x h3 -> falls_like (fun e => (h (x + e) - h (x - e)) / (2 * e) - h1 x) p (c * h3).
Theorem difference_slopes__central : central_falls 2 (1/6).
Proof.
  intros h h1 h2 x h3 D1 D2 D3. apply (falls _ (fun t => h (x + t) - h (x - t) - 2 * t * h1 x) (fun t => h1 (x + t) + h1 (x - t) - 2 * h1 x) 2 2 (2 *
    h3 / INR 2));
    [intro; differentiated D1 | nothing_at_0 | | lra | intros; field; lra | reflexivity | simpl; field].
  apply (integrated _ (fun t => h2 (x + t) - h2 (x - t))); [intro; differentiated D2 | nothing_at_0 | at_0 D3].
Qed.
(* forward and backward c and - c times the second, *)
Definition forward_falls (p c : R) := forall (h h1 : R -> R) (s x h2 : R), (forall w, is_derive h w (h1 w)) -> is_derive h1 x h2 -> s = 1 \/ s =
  -1 -> falls_like (fun e => forward h s x e - h1 x) p (c * (s * h2)).
Theorem difference_slopes__forward : forward_falls 1 (1/2).
Proof.
  intros h h1 s x h2 D1 D2 S. apply (falls _ (fun t => s * (h (x + s * t) - h x) - t * h1 x) (fun t => h1 (x + s * t) - h1 x) 1 1 (s * h2));
    [intro; destruct S as [-> | ->]; differentiated D1 | nothing_at_0 | at_0 D2 | lra | intros; unfold forward; field; lra | reflexivity | simpl;
      field].
Qed.
(* of fourth order c times the fifth, *)
Definition fourth_falls (p c : R) := forall (h h1 h2 h3 h4 : R -> R) (x h5 : R), (forall w, is_derive h w (h1 w)) -> (forall w, is_derive h1 w (h2
  w)) -> (forall w, is_derive h2 w (h3 w)) -> (forall w, is_derive h3 w (h4 w)) -> is_derive h4 x h5 -> falls_like (fun e => fourth h x e - h1 x)
  p (c * h5).
Theorem difference_slopes__fourth : fourth_falls 4 (-1/30).
Proof.
  intros h h1 h2 h3 h4 x h5 D1 D2 D3 D4 D5. apply (falls _ (fun t => h (x - 2 * t) - h (2 * t + x) + 8 * (h (t + x) - h (x - t)) - 12 * t * h1 x)
    (fun t => 8 * (h1 (t + x) + h1 (x - t)) - 2 * (h1 (2 * t + x) + h1 (x - 2 * t)) - 12 * h1 x) 4 12 (- 48 * h5 / INR 2 / INR 3 / INR 4));
    [intro; differentiated D1 | nothing_at_0 | | lra | intros; unfold fourth; field; lra | simpl; ring | simpl; field].
  apply (integrated _ (fun t => 8 * (h2 (t + x) - h2 (x - t)) - 4 * (h2 (2 * t + x) - h2 (x - 2 * t)))); [intro; differentiated D2 | nothing_at_0 |].
  apply (integrated _ (fun t => 8 * (h3 (t + x) + h3 (x - t)) - 8 * (h3 (2 * t + x) + h3 (x - 2 * t)))); [intro; differentiated D3 | nothing_at_0 |].
  apply (integrated _ (fun t => 8 * (h4 (t + x) - h4 (x - t)) - 16 * (h4 (2 * t + x) - h4 (x - 2 * t)))); [intro; differentiated D4 | nothing_at_0 |
    at_0 D5].
Qed.
(* and clamped at the pole at v = r e c times the second or, where that is 0 at the pole, as an odd field's is, c times the third. *)
Definition clamped_falls (odd : Prop) (p : R) (c : R -> R -> R -> R) := forall (h h1 h2 : R -> R) (r h3 : R), (forall w, is_derive h w (h1 w)) ->
  (forall w, is_derive h1 w (h2 w)) -> is_derive h2 0 h3 -> 0 <= r < 1 -> (odd -> h2 0 = 0) -> falls_like (fun e => clamped h (r * e) e - h1 (r *
  e)) p (c r (h2 0) h3).
Definition of_second (r h2 h3 : R) := (1 - r) / 2 * h2.
Definition of_third (r h2 h3 : R) := (1 + 2 * r - 2 * r ^ 2) / 6 * h3.
Lemma clamped_parts (h h1 : R -> R) (r : R) (n : nat) (l m : R) : (forall w, is_derive h w (h1 w)) -> 0 <= r < 1 ->
  tends_to (fun e => (1 + r) * (h1 ((1 + r) * e) - h1 0) / e ^ n) l -> tends_to (fun e => (h1 (r * e) - h1 0) / e ^ n) m ->
  falls_like (fun e => clamped h (r * e) e - h1 (r * e)) (INR n) (/ (1 + r) * (l / INR (S n)) - m).
Proof.
  intros D B K M. apply slope_of_logarithms. apply (tends_is _ (/ (1 + r) * (l / INR (S n)) + -1 * m)); [|ring].
  assert (L : tends_to (fun e => (h ((1 + r) * e) - h 0 - (1 + r) * e * h1 0) / e ^ S n) _) by (apply (integrated _ (fun e => (1 + r) * (h1 ((1 + r)
    * e) - h1 0))); [intro; differentiated D | nothing_at_0 | exact K]).
  apply (tends_ext (fun e => / (1 + r) * ((h ((1 + r) * e) - h 0 - (1 + r) * e * h1 0) / e ^ S n) + -1 * ((h1 (r * e) - h1 0) / e ^ n)) _ (/ (1 +
    r))); [apply Rinv_0_lt_compat; lra | | exact (tends_sum _ _ _ _ _ _ L M)].
  intros e [P E]. apply (Rmult_le_compat_l (1 + r)) in E; [|lra]. rewrite Rinv_r in E by lra.
  rewrite Rpower_pow, clamped_is by nra. replace (r * e + e) with ((1 + r) * e) by ring. assert (e ^ n <> 0) by (apply pow_nonzero; lra).
  simpl pow. field. lra.
Qed.
Theorem difference_slopes__clamped : clamped_falls False 1 of_second /\ clamped_falls True 2 of_third.
Proof.
  split; intros h h1 h2 r h3 D1 D2 D3 B Z; [unfold of_second | specialize (Z I); unfold of_third].
  - pose proof D2 0 as D. replace ((1 - r) / 2 * h2 0) with (/ (1 + r) * ((1 + r) * ((1 + r) * h2 0) / INR 2) - r * h2 0) by (simpl; field; lra).
    apply (clamped_parts h h1 r 1); [exact D1 | exact B | at_0 D | at_0 D].
  - replace (_ * h3) with (/ (1 + r) * ((1 + r) * (1 + r) * ((1 + r) * h3) / INR 2 / INR 3) - r * (r * h3) / INR 2) by (simpl; field; lra).
    apply clamped_parts; auto.
    + apply (integrated _ (fun e => (1 + r) * (1 + r) * h2 ((1 + r) * e))); [intro; differentiated D2 | nothing_at_0 | at_0 D3].
    + apply (integrated _ (fun e => r * h2 (r * e))); [intro; differentiated D2 | nothing_at_0 | at_0 D3].
Qed.

(* An error has one order, where its coefficient is not 0, and one coefficient: others are false. *)
Lemma one_law error p q C D : falls_like error p C -> falls_like error q D -> (p = q -> C = D) /\ (C <> 0 -> D <> 0 -> p = q).
Proof.
  intros [A S] [B T]. split; [intros <-; exact (filterlim_locally_unique _ _ _ A B) | intros N M].
  assert (two : 0 < 2 /\ 2 <> 1) by (split; lra). destruct two as [P U]. exact (filterlim_locally_unique _ _ _ (S N 2 P U) (T M 2 P U)).
Qed.
Ltac polynomials := try (intro; auto_derive; trivial; ring); try (auto_derive; trivial; ring); try lra.
Lemma two_laws error p q C D : falls_like error p C -> falls_like error q D -> (p = q /\ C <> D) \/ (p <> q /\ C <> 0 /\ D <> 0) -> False.
Proof. intros A B. destruct (one_law _ _ _ _ _ A B). tauto. Qed.
Theorem difference_slopes__central__false : ~ central_falls 2 (1/3) /\ ~ central_falls 1 (1/6).
Proof.
  assert (exists error, forall p c, central_falls p c -> falls_like error p _) as [error A] by (eexists; intros p c H; apply (H (fun w => w ^ 3) (fun
    w => 3 * w ^ 2) (fun w => 6 * w) 0); polynomials).
  split; intro H; apply (two_laws _ _ _ _ _ (A _ _ H) (A _ _ difference_slopes__central)); lra.
Qed.
Theorem difference_slopes__forward__false : ~ forward_falls 1 1 /\ ~ forward_falls 2 (1/2).
Proof.
  assert (exists error, forall p c, forward_falls p c -> falls_like error p _) as [error A] by (eexists; intros p c H; apply (H (fun w => w ^ 2) (fun
    w => 2 * w) 1 0); polynomials).
  split; intro H; apply (two_laws _ _ _ _ _ (A _ _ H) (A _ _ difference_slopes__forward)); lra.
Qed.
Theorem difference_slopes__fourth__false : ~ fourth_falls 4 (1/30) /\ ~ fourth_falls 3 (-1/30).
Proof.
  assert (exists error, forall p c, fourth_falls p c -> falls_like error p _) as [error A] by (eexists; intros p c H; apply (H (fun w => w ^ 5) (fun
    w => 5 * w ^ 4) (fun w => 20 * w ^ 3) (fun w => 60 * w ^ 2) (fun w => 120 * w) 0); polynomials).
  split; intro H; apply (two_laws _ _ _ _ _ (A _ _ H) (A _ _ difference_slopes__fourth)); lra.
Qed.
(* Where the second derivative is not 0 at the pole the order is not 2; where it is 0, not 1. *)
Theorem difference_slopes__clamped__false : ~ clamped_falls False 2 of_third /\ ~ clamped_falls True 1 of_third.
Proof.
  assert (N : forall r h2 h3, r = 0 -> of_second r h2 h3 = h2 / 2 /\ of_third r h2 h3 = h3 / 6) by (unfold of_second, of_third; intros; subst; lra).
  assert (D : forall c, (forall w, is_derive (fun w => c * w ^ 2 + w ^ 3) w (2 * c * w + 3 * w ^ 2)) /\ (forall w, is_derive (fun w => 2 * c * w + 3
    * w ^ 2) w (2 * c + 6 * w)) /\ is_derive (fun w => 2 * c + 6 * w) 0 6).
  { split; [|split]; polynomials. }
  destruct difference_slopes__clamped as [F T]. split; intro H.
  - destruct (D 1) as (D1 & D2 & D3). refine (two_laws _ _ _ _ _ (H _ _ _ 0 6 D1 D2 D3 _ _) (F _ _ _ 0 6 D1 D2 D3 _ _) _); [lra | tauto | lra |
    tauto|].
    destruct (N 0 (2 * 1 + 6 * 0) 6 eq_refl). lra.
  - destruct (D 0) as (D1 & D2 & D3). refine (two_laws _ _ _ _ _ (H _ _ _ 0 6 D1 D2 D3 _ _) (T _ _ _ 0 6 D1 D2 D3 _ _) _); [lra | lra | lra | lra|].
    destruct (N 0 (2 * 0 + 6 * 0) 6 eq_refl). lra.
Qed.
