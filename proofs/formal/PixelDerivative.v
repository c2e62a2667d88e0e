(* The image's derivative by beta, composed: from the bumped normal through the lines of the shading to the clip. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas Vectors Fields Displacement ImageDerivative.
Open Scope R_scope.

(* A light's share on top of a channel, and the clip of both. *)
Lemma one_more_light (mu base printed before : R -> R) (beta mu' base' slope i albedo kd ks p : R) :
  let lit b := light_term.lit_red (before b) i albedo kd ks (mu b) (highlight.specular (printed b) p) in
  let total := slope + term_derivative.term_by_beta (mu beta) mu' (printed beta) base' p kd ks albedo i in
  is_derive before beta slope -> is_derive mu beta mu' -> is_derive base beta base' -> (forall b, printed b = Rmax 0 (base b)) -> mu beta <> 0 -> base
    beta <> 0 ->
  is_derive lit beta total /\ (lit beta <> 0 -> lit beta <> 1 -> is_derive (fun b => clip.clipped (lit b)) beta (clip_derivative.clipped (lit beta) total)).
Proof.
  intros lit total S M B E NM NB. assert (D : is_derive lit beta total).
  - unfold total. rewrite E. apply (is_derive_ext (fun b => before b + light_term.lit_red 0 i albedo kd ks (mu b) (highlight_of (Rmax 0 (base b)) p))).
    + intro b. unfold lit, light_term.lit_red. rewrite E. unfold highlight_of. match goal with |- ?x = ?y => change (x = y :> R) end. ring.
    + apply (is_derive_plus before); [exact S | apply share_derives; assumption].
  - split; [exact D | intros; apply clip_derives; assumption].
Qed.

(* The lines composed: a channel's derivative by beta, light upon light, from the bumped normal to the clip, for both models. *)
Theorem image_derivative__pixel (nx ny nz gx gy gz beta px py pz lx ly lz vx vy vz i albedo kd ks p slope : R) (before : R -> R) :
  let x b := perturbed.bumped_x nx ny nz gx gy gz b in let y b := perturbed.bumped_y nx ny nz gx gy gz b in let z b := perturbed.bumped_z nx ny nz gx gy gz b in
  let dx := normal_by_beta.bumped_by_beta_x nx ny nz gx gy gz beta in let dy := normal_by_beta.bumped_by_beta_y nx ny nz gx gy gz beta in
  let dz := normal_by_beta.bumped_by_beta_z nx ny nz gx gy gz beta in
  let tx := light_direction.towards_x px py pz lx ly lz in let ty := light_direction.towards_y px py pz lx ly lz in let tz :=
    light_direction.towards_z px py pz lx ly lz in
  let mu b := light_direction.mu px py pz lx ly lz (x b) (y b) (z b) in let mu' := mu_derivative.mu_by_beta tx ty tz dx dy dz in
  let r := blinn.halfway_length px py pz lx ly lz vx vy vz in
  let derives base base' := let lit b := light_term.lit_red (before b) i albedo kd ks (mu b) (highlight.specular (base b) p) in
    let total := slope + term_derivative.term_by_beta (mu beta) mu' (base beta) base' p kd ks albedo i in
    is_derive lit beta total /\ (lit beta <> 0 -> lit beta <> 1 -> is_derive (fun b => clip.clipped (lit b)) beta (clip_derivative.clipped (lit beta) total)) in
  0 < (beta * gx + nx) ^ 2 + (beta * gy + ny) ^ 2 + (beta * gz + nz) ^ 2 -> is_derive before beta slope -> mu beta <> 0 ->
  (0 < r -> x beta * (tx + vx) + y beta * (ty + vy) + z beta * (tz + vz) <> 0 ->
    derives (fun b => blinn.specular_base px py pz lx ly lz (x b) (y b) (z b) vx vy vz) (blinn_base_derivative.base_by_beta (tx + vx) (ty + vy) (tz +
      vz) r dx dy dz)) /\
  (2 * mu beta * (x beta * vx + y beta * vy + z beta * vz) - tx * vx - ty * vy - tz * vz <> 0 ->
    derives (fun b => phong.specular_base px py pz lx ly lz (x b) (y b) (z b) vx vy vz) (phong_base_derivative.base_by_beta vx vy vz (x beta) (y beta)
      (z beta) dx dy dz (mu beta) mu')).
Proof.
  intros x y z dx dy dz tx ty tz mu mu' r derives Z S N. destruct (bumped_derives nx ny nz gx gy gz beta Z) as (X & Y & W).
  destruct (blinn_base_derives x y z beta dx dy dz X Y W px py pz lx ly lz vx vy vz) as [B B'].
  destruct (phong_base_derives x y z beta dx dy dz X Y W px py pz lx ly lz vx vy vz) as [P P'].
  generalize (mu_derives x y z beta dx dy dz X Y W px py pz lx ly lz). intro M. split; intros; eapply one_more_light; try eassumption.
  - apply B'. assumption.
  - cbv beta. intro E. apply Rmult_integral in E. destruct E as [E|E]; [contradiction | revert E; apply Rinv_neq_0_compat, Rgt_not_eq; assumption].
Qed.

(* N = (0, 0, 1) tilted by 45 degrees, under a light straight above. *)
Lemma tilted : let z := perturbed.bumped_z 0 0 1 1 0 0 1 in 0 < z /\ normal_by_beta.bumped_by_beta_z 0 0 1 1 0 0 1 < 0 /\
  light_direction.mu 0 0 0 0 0 1 (perturbed.bumped_x 0 0 1 1 0 0 1) (perturbed.bumped_y 0 0 1 1 0 0 1) z = z.
Proof.
  unfold light_direction.mu. destruct above as (-> & -> & ->). normal_by_beta.lines; perturbed.lines. replace ((1 * 1 + 0) ^ 2 + (1 * 0 + 0) ^ 2 + (1
    * 0 + 1) ^ 2) with 2 by ring.
  assert (I : 0 < / sqrt 2) by (apply Rinv_0_lt_compat, sqrt_lt_R0; lra). unfold Rdiv. set (j := / sqrt 2) in *. clearbody j. assert (0 < j * j * j)
    by (repeat apply Rmult_lt_0_compat; exact I).
  repeat split; lra.
Qed.
Theorem image_derivative__pixel__point : exists nx ny nz gx gy gz beta px py pz lx ly lz vx vy vz,
  let x := perturbed.bumped_x nx ny nz gx gy gz beta in let y := perturbed.bumped_y nx ny nz gx gy gz beta in let z := perturbed.bumped_z nx ny nz gx
    gy gz beta in
  0 < (beta * gx + nx) ^ 2 + (beta * gy + ny) ^ 2 + (beta * gz + nz) ^ 2 /\ light_direction.mu px py pz lx ly lz x y z <> 0 /\ 0 <
    blinn.halfway_length px py pz lx ly lz vx vy vz.
Proof.
  exists 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1. cbv zeta. destruct tilted as (Z & _ & ->). rewrite halfway_above. lra.
Qed.
(* The light's share moves with N'. *)
Theorem image_derivative__pixel__false : ~ forall nx ny nz gx gy gz beta px py pz lx ly lz vx vy vz i albedo kd ks p,
  let x b := perturbed.bumped_x nx ny nz gx gy gz b in let y b := perturbed.bumped_y nx ny nz gx gy gz b in let z b := perturbed.bumped_z nx ny nz gx gy gz b in
  let mu b := light_direction.mu px py pz lx ly lz (x b) (y b) (z b) in 0 < (beta * gx + nx) ^ 2 + (beta * gy + ny) ^ 2 + (beta * gz + nz) ^ 2 -> mu
    beta <> 0 ->
  is_derive (fun b => light_term.lit_red 0 i albedo kd ks (mu b) (highlight.specular (blinn.specular_base px py pz lx ly lz (x b) (y b) (z b) vx vy
    vz) p)) beta 0.
Proof.
  destruct tilted as (Z & D & M). destruct above as (X & Y & W). intro H. generalize (H 0 0 1 1 0 0 1 0 0 0 0 0 1 0 0 1 1 1 1 0 1 ltac:(lra) ltac:(cbv
    beta; rewrite M; lra)).
  destruct (proj1 (image_derivative__pixel 0 0 1 1 0 0 1 0 0 0 0 0 1 0 0 1 1 1 1 0 1 0 (fun _ => 0) ltac:(lra) (is_derive_const 0 1) ltac:(cbv beta;
    rewrite M; lra))) as [E _].
  - rewrite halfway_above. lra.
  - rewrite X, Y, W. lra.
  - intro F. generalize (eq_trans (eq_sym (is_derive_unique _ _ _ E)) (is_derive_unique _ _ _ F)). rewrite M, X, Y, W.
    term_derivative.lines; unfold mu_derivative.mu_by_beta.
    destruct (Rlt_dec 0 (perturbed.bumped_z 0 0 1 1 0 0 1)); [|contradiction]. destruct (Rlt_dec 0 _); lra.
Qed.
