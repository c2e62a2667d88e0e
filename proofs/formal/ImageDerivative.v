(* The image's derivative by beta: the chain rule through the lines of the shading. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Vectors Fields.
Open Scope R_scope.

Lemma positive_nearby (f : R -> R) (x l : R) : is_derive f x l -> 0 < f x -> locally x (fun t => 0 < f t).
Proof.
  intros D P. apply (ex_derive_continuous f x (ex_intro _ l D) (fun y => 0 < y)). exists (mkposreal _ P). intros y B.
  change (Rabs (y - f x) < f x) in B. apply Rabs_def2 in B. lra.
Qed.

(* What is 0 where a function is below 0 is level there. *)
Lemma level_below (f g : R -> R) (x l : R) : is_derive f x l -> f x < 0 -> (forall t, f t < 0 -> 0 = g t) -> is_derive g x 0.
Proof.
  intros D N Z. apply (is_derive_ext_loc (fun _ => 0)); [|auto_derive; trivial].
  generalize (positive_nearby (fun t => - f t) x (- l) (is_derive_opp f x l D) ltac:(lra)). apply filter_imp. intros t H. apply Z. lra.
Qed.
(* A clamp at 0 keeps the derivative above 0, and makes it 0 below. *)
Lemma clamp_derive (f : R -> R) (x l : R) : is_derive f x l -> f x <> 0 -> is_derive (fun t => Rmax 0 (f t)) x (if Rlt_dec 0 (f x) then l else 0).
Proof.
  intros D N. destruct (Rlt_dec 0 (f x)) as [P|P].
  - apply (is_derive_ext_loc f); [|exact D]. apply (filter_imp _ _ (fun t (H : 0 < f t) => eq_sym (Rmax_right 0 (f t) (Rlt_le _ _ H)))),
    (positive_nearby f x l); assumption.
  - apply (level_below f _ x l); [exact D | lra|]. intros t H. rewrite Rmax_left; lra.
Qed.

(* What is left to show where functions have derivatives that are at hand. *)
Lemma derivative_is (f : R -> R) (x l : R) : is_derive f x l -> Derive (fun t => f t) x = l.
Proof. apply is_derive_unique. Qed.
Ltac by_rules := auto_derive; [repeat split; trivial; eexists; eassumption|]; repeat match goal with D : is_derive ?f ?x ?l |- context [Derive (fun t
  => ?f t) ?x] => rewrite (derivative_is f x l D) end.

(* The printed highlight: base^p, and 0 at base = 0. *)
Definition highlight_of (base p : R) : R := highlight.specular base p.

Lemma power_derive (f : R -> R) (x l p : R) : is_derive f x l -> f x <> 0 ->
  is_derive (fun t => highlight_of (Rmax 0 (f t)) p) x (if Rlt_dec 0 (Rmax 0 (f x)) then p * power (Rmax 0 (f x)) (p - 1) * l else 0).
Proof.
  intros D N. destruct (Rlt_dec 0 (f x)) as [P|P].
  - rewrite Rmax_right by lra. destruct (Rlt_dec 0 (f x)) as [_|H]; [|contradiction].
    apply (is_derive_ext_loc (fun t => exp (p * ln (f t)))).
    + generalize (positive_nearby f x l D P). apply filter_imp. intros t H. unfold highlight_of, highlight.specular, power. rewrite Rmax_right by lra.
      destruct (Rlt_dec 0 (f t)); [reflexivity | contradiction].
    + by_rules. unfold power. destruct (Rlt_dec 0 (f x)) as [_|H]; [|contradiction]. unfold Rpower. rewrite Rmult_minus_distr_r, (Rmult_1_l (ln _)).
      unfold Rminus. rewrite exp_plus, exp_Ropp, exp_ln by exact P. ring.
  - rewrite Rmax_left by lra. destruct (Rlt_dec 0 0); [lra|]. apply (level_below f _ x l); [exact D | lra|]. intros t H. unfold highlight_of,
    highlight.specular, power. rewrite Rmax_left by lra. destruct (Rlt_dec 0 0); [lra | reflexivity].
Qed.

(* Off mu = 0 and base = 0, a light's share of a channel has the derivative that is printed, for every p. *)
Lemma share_derives (mu base : R -> R) (beta mu_by_beta base_by_beta i albedo kd ks p : R) :
  is_derive mu beta mu_by_beta -> is_derive base beta base_by_beta -> mu beta <> 0 -> base beta <> 0 ->
  is_derive (fun b => light_term.lit_red 0 i albedo kd ks (mu b) (highlight_of (Rmax 0 (base b)) p)) beta
    (term_derivative.term_by_beta (mu beta) mu_by_beta (Rmax 0 (base beta)) base_by_beta p kd ks albedo i).
Proof.
  intros DM DB NM NB. light_term.lines; term_derivative.lines.
  set (m b := Rmax 0 (mu b)). set (s b := highlight_of (Rmax 0 (base b)) p).
  assert (A := clamp_derive mu beta mu_by_beta DM NM : is_derive m beta _). assert (B := power_derive base beta base_by_beta p DB NB : is_derive s beta _).
  apply (is_derive_ext (fun b => i * (albedo * (kd * m b) + ks * s b) + 0)); [reflexivity|].
  by_rules. destruct (Rlt_dec 0 (mu beta)), (Rlt_dec 0 (Rmax 0 (base beta))); ring.
Qed.

Section lines.
Variables nx ny nz : R -> R.
Variables beta dx dy dz : R.
Hypotheses (X : is_derive nx beta dx) (Y : is_derive ny beta dy) (W : is_derive nz beta dz).
Lemma product_derive (a b c : R) : is_derive (fun t => nx t * a + ny t * b + nz t * c) beta (dx * a + dy * b + dz * c).
Proof. by_rules. ring. Qed.
Variables px py pz lx ly lz vx vy vz : R.
Let tx := light_direction.towards_x px py pz lx ly lz.
Let ty := light_direction.towards_y px py pz lx ly lz.
Let tz := light_direction.towards_z px py pz lx ly lz.

(* mu' = N'_beta . omega. *)
Lemma mu_derives :
  is_derive (fun b => light_direction.mu px py pz lx ly lz (nx b) (ny b) (nz b)) beta (mu_derivative.mu_by_beta tx ty tz dx dy dz).
Proof. apply product_derive. Qed.

(* Blinn: base' = N'_beta . H/|H|, before the clamp. *)
Lemma blinn_base_derives : let hx := tx + vx in let hy := ty + vy in let hz := tz + vz in let r := blinn.halfway_length px py pz lx ly lz vx vy vz in
  is_derive (fun b => (nx b * hx + ny b * hy + nz b * hz) / r) beta (blinn_base_derivative.base_by_beta hx hy hz r dx dy dz) /\
  (0 < r -> forall b, blinn.specular_base px py pz lx ly lz (nx b) (ny b) (nz b) vx vy vz = Rmax 0 ((nx b * hx + ny b * hy + nz b * hz) / r)).
Proof.
  cbv zeta. split.
  - unfold blinn_base_derivative.base_by_beta. by_rules. unfold Rdiv. ring.
  - intros P b. unfold blinn.specular_base. destruct (Rlt_dec _ _) as [_|H]; [|contradiction]. apply Rmax_comm.
Qed.

(* Phong: base' = 2 (mu' N'.v + mu N'_beta.v), before the clamp. *)
Lemma phong_base_derives : let m := fun b => light_direction.mu px py pz lx ly lz (nx b) (ny b) (nz b) in
  let m' := mu_derivative.mu_by_beta tx ty tz dx dy dz in
  is_derive (fun b => 2 * m b * (nx b * vx + ny b * vy + nz b * vz) - tx * vx - ty * vy - tz * vz) beta
    (phong_base_derivative.base_by_beta vx vy vz (nx beta) (ny beta) (nz beta) dx dy dz (m beta) m') /\
  (forall b, phong.specular_base px py pz lx ly lz (nx b) (ny b) (nz b) vx vy vz = Rmax 0 (2 * m b * (nx b * vx + ny b * vy + nz b * vz) - tx * vx -
    ty * vy - tz * vz)).
Proof.
  intros m m'. split; [|reflexivity]. assert (A := mu_derives : is_derive m beta m'). by_rules. unfold phong_base_derivative.base_by_beta. ring.
Qed.
End lines.

(* The clip keeps the derivative where the channel is inside (0, 1), and makes it 0 outside. *)
Lemma clip_derives (channel : R -> R) (beta slope : R) : is_derive channel beta slope -> channel beta <> 0 -> channel beta <> 1 ->
  is_derive (fun b => clip.clipped (channel b)) beta (clip_derivative.clipped (channel beta) slope).
Proof.
  intros D N0 N1. unfold clip.clipped, clip_derivative.clipped.
  assert (E : forall c, Rmin 1 (Rmax 0 c) = Rmax 0 c - Rmax 0 (c - 1)).
  { intro c. unfold Rmin, Rmax. repeat destruct Rle_dec; lra. }
  apply (is_derive_ext (fun b => Rmax 0 (channel b) - Rmax 0 (channel b - 1))); [intro; symmetry; apply E|].
  eapply is_derive_is.
  - apply (is_derive_minus (fun b => Rmax 0 (channel b)) (fun b => Rmax 0 (channel b - 1))); apply clamp_derive; trivial; [exact D | | lra].
    apply (is_derive_minus channel (fun _ => 1)); [exact D | apply is_derive_const].
  - unfold minus, plus, opp, zero. simpl. destruct (both _ _) as [[A B]|H].
    + destruct (Rlt_dec 0 (channel beta)), (Rlt_dec 0 (channel beta - 1)); try lra; ring.
    + destruct (Rlt_dec 0 (channel beta)), (Rlt_dec 0 (channel beta - 1)); destruct H; try lra; ring.
Qed.
