(* How far a gradient's error moves a colour, lit by any number of lights. *)

From Coq Require Import Reals Lra List.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Formulas Vectors Bump Shading.
Import ListNotations.
Open Scope R_scope.

(* The printed line adds one light after the other to a channel, at the point P; then it is clipped. *)
Section lights.
Variables (lights : list (vector * R)) (model : vector -> vector -> R) (P : vector) (ambient albedo kd ks : R) (p : nat).
Definition lit (n : vector) := fold_right (fun light before => light_term.lit_red before (snd light) albedo kd ks (mu P (fst light) n) (model (fst
  light) n ^ p)) ambient lights.
Definition most (q : R) := fold_right (fun light others => snd light * (albedo * kd + ks * q) + others) 0 lights.
End lights.

(* So |dI| <= sum over the lights of i (a k_d + k_s q), times min(|beta| |dg|, 2), where base^p moves by at most q |dN'|. *)
Theorem difference_bound__any_lights lights model P ambient albedo kd ks q p theta phi a_u a_v b_u b_v beta : 0 <= albedo -> 0 <= kd -> 0 <= ks ->
  0 <= q -> (forall L i, In (L, i) lights -> 0 <= i /\ 0 < magnitude (difference L P) /\ forall n m, magnitude n = 1 -> magnitude m = 1 -> Rabs
  (model L n ^ p - model L m ^ p) <= q * magnitude (difference n m)) -> let colour n := clip.clipped (lit lights model P ambient albedo kd ks p n)
  in Rabs (colour (N' theta phi a_u a_v beta) - colour (N' theta phi b_u b_v beta)) <= most lights albedo kd ks q * Rmin (Rabs beta * magnitude
  (difference (g theta phi a_u a_v) (g theta phi b_u b_v))) 2.
Proof.
  intros A D S Q. cbv zeta. set (n := N' theta phi a_u a_v beta). set (m := N' theta phi b_u b_v beta).
  assert (Un : magnitude n = 1) by apply unit_length_length. assert (Um : magnitude m = 1) by apply unit_length_length. intro H.
  assert (E : 0 <= most lights albedo kd ks q /\
    Rabs (lit lights model P ambient albedo kd ks p n - lit lights model P ambient albedo kd ks p m) <= most lights albedo kd ks q * magnitude
      (difference n m)).
  { induction lights as [|[L i] rest IH]; [unfold lit, most; simpl; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; lra|].
    destruct (H L i (or_introl eq_refl)) as (I & O & K). destruct IH as [IH0 IH]; [intros L' i' X; apply H; right; exact X|].
    generalize (difference_bound__light (model L) P L n m i albedo kd ks q p I A D S O (K n m Un Um)). unfold share.
    change (most ((L, i) :: rest) albedo kd ks q) with (i * (albedo * kd + ks * q) + most rest albedo kd ks q).
    assert (One : forall n, lit ((L, i) :: rest) model P ambient albedo kd ks p n = light_term.lit_red (lit rest model P ambient albedo kd ks p n) i
      albedo kd ks (mu P L n) (model L n ^ p)) by reflexivity.
    rewrite !One. set (x := lit rest _ _ _ _ _ _ _ n) in *. set (y := lit rest _ _ _ _ _ _ _ m) in *. unfold light_term.lit_red. intro B.
    split; [assert (0 <= i * (albedo * kd + ks * q)) by (apply Rmult_le_pos; [exact I | apply Rplus_le_le_0_compat; apply Rmult_le_pos;
      assumption]); lra|].
    match type of B with Rabs (?s + 0 - (?t + 0)) <= _ => replace (s + x - (t + y)) with (s + 0 - (t + 0) + (x - y)) by ring end.
    eapply Rle_trans; [apply Rabs_triang|]. lra. }
  eapply Rle_trans; [apply difference_bound_clip|]. eapply Rle_trans; [apply E|]. apply Rmult_le_compat_l; [apply E | apply bump_moved].
Qed.
Theorem difference_bound__any_lights__point : exists lights model P q p, 0 <= q /\ forall L i, In (L, i) lights -> 0 <= i /\ 0 < magnitude
  (difference L P) /\ forall n m, magnitude n = 1 -> magnitude m = 1 -> Rabs (model L n ^ p - model L m ^ p) <= q * magnitude (difference n m).
Proof.
  exists [((0, 0, 1), 1)], (fun _ _ => 0), (0, 0, 0), 0, 1%nat. split; [lra|]. intros L i [E|[]]. injection E as <- <-. rewrite above_apart. repeat
    split; try lra.
  intros n m _ _. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra.
Qed.
(* Not without the part that is diffuse. *)
Lemma not_without_the_diffuse_part model : let colour n := clip.clipped (lit [((0, 0, 1), 1)] model (0, 0, 0) 0 1 1 0 1 n) in ~ Rabs (colour (N' 0
  0 0 0 1) - colour (N' 0 0 1 0 1)) <= most [((0, 0, 1), 1)] 0 1 0 1 * Rmin (Rabs 1 * magnitude (difference (g 0 0 0 0) (g 0 0 1 0))) 2.
Proof.
  unfold lit, most. cbn [fold_right fst snd].
  light_term.lines. rewrite !mu_is_a_product, above_is.
  assert (Z : normal_at 0 0 = (0, 0, 1)) by (unfold_vectors; rewrite sin_0, cos_0; repeat f_equal; ring). rewrite <- Z, !(dot_comm _ (normal_at 0 0)),
    !normal_dot_bumped.
  generalize (length_squared (M 0 0 1 0 1)) (m_length_at_least_1 0 0 1 0 1) (length_squared (M 0 0 0 0 1)) (m_length_at_least_1 0 0 0 0 1).
    rewrite !m_squared.
  set (x := magnitude (M 0 0 1 0 1)). set (y := magnitude (M 0 0 0 0 1)). intros X X1 Y Y1. assert (Y2 : y = 1) by nra. rewrite Y2, Rinv_1.
  assert (I : / x * x = 1) by (apply Rinv_l; lra). assert (J : 0 < / x < 1) by (split; nra). rewrite !(Rmax_right 0 _) by lra. unfold clip.clipped.
  rewrite !Rmax_right, !Rmin_right by lra. rewrite Rabs_pos_eq; lra.
Qed.
Theorem difference_bound__any_lights__false : ~ forall lights model P albedo kd ks theta phi a_u a_v b_u b_v beta, let colour n := clip.clipped
  (lit lights model P 0 albedo kd ks 1 n) in Rabs (colour (N' theta phi a_u a_v beta) - colour (N' theta phi b_u b_v beta)) <= most lights 0 kd ks
  1 * Rmin (Rabs beta * magnitude (difference (g theta phi a_u a_v) (g theta phi b_u b_v))) 2.
Proof. intro H. apply (not_without_the_diffuse_part (fun _ _ => 0)), H. Qed.

(* So for the two models, of whose highlights specular_lipschitz says q: p for Blinn's, 2 p for Phong's. *)
Theorem difference_bound__of_both_models lights P v ambient albedo kd ks p theta phi a_u a_v b_u b_v beta : 0 <= albedo -> 0 <= kd -> 0 <= ks ->
  magnitude v = 1 -> (forall L i, In (L, i) lights -> 0 <= i /\ 0 < magnitude (difference L P)) -> let change model := let colour n :=
  clip.clipped (lit lights model P ambient albedo kd ks p n) in Rabs (colour (N' theta phi a_u a_v beta) - colour (N' theta phi b_u b_v beta)) in
  let bound q := most lights albedo kd ks q * Rmin (Rabs beta * magnitude (difference (g theta phi a_u a_v) (g theta phi b_u b_v))) 2 in change
  (fun L => blinn_base P L v) <= bound (INR p) /\ change (fun L => phong_base P L v) <= bound (2 * INR p).
Proof.
  intros A D S V H. assert (0 <= INR p) by apply pos_INR. cbv zeta.
  split; apply difference_bound__any_lights; try assumption; try lra; intros L i X; destruct (H L i X) as [I O];
    (split; [exact I|]; split; [exact O|]; intros n m N M; apply (specular_lipschitz__highlight p P L v n m O N M V)).
Qed.
Theorem difference_bound__of_both_models__point : exists lights P v, magnitude v = 1 /\ forall L i, In (L, i) lights -> 0 <= i /\ 0 < magnitude
  (difference L P).
Proof.
  exists [((0, 0, 1), 1)], (0, 0, 0), (0, 0, 1). split; [transitivity (sqrt 1); [unfold magnitude, dot; f_equal; ring | apply sqrt_1]|].
  intros L i [E|[]]. injection E as <- <-. rewrite above_apart. lra.
Qed.
Theorem difference_bound__of_both_models__false : ~ forall lights P v albedo kd ks theta phi a_u a_v b_u b_v beta, let colour n := clip.clipped
  (lit lights (fun L => blinn_base P L v) P 0 albedo kd ks 1 n) in Rabs (colour (N' theta phi a_u a_v beta) - colour (N' theta phi b_u b_v beta))
  <= most lights 0 kd ks 1 * Rmin (Rabs beta * magnitude (difference (g theta phi a_u a_v) (g theta phi b_u b_v))) 2.
Proof. intro H. apply (not_without_the_diffuse_part (fun L => blinn_base (0, 0, 0) L (0, 0, 1))), H. Qed.
