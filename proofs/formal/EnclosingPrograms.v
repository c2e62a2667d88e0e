(* The rules compose: whatever float64 computes by a program lies within what the enclosing machine counts with it, where that is known. *)

From Coq Require Import Reals Lra List Bool.
From Flocq Require Import Core.
From Formal Require Import Preliminaries Float Float64 Programs RoundedHalfTurns Rounding EnclosingRules EnclosingBounds EnclosingOperations.
Open Scope R_scope.
Import ListNotations.

(* A number of a program: whether it is known to be within its count, its kind, its value, and that count. *)
Definition number : Type := Prop * (kind * (R * R)).
Definition value_of (n : number) := fst (snd (snd n)).
Definition zero_known : number := (True, (Written None, (0, 0))).
(* Numbers that are known and not too near decide a comparison; one test that does not hold decides both. *)
Fixpoint test_settled (c : test) (given : list number) : Prop :=
  match c with
  | Less i j | Same i j => let a := nth i given zero_known in let b := nth j given zero_known in fst a /\ fst b /\ too_near (snd (snd a)) (snd (snd
    b)) = false
  | Not c => test_settled c given
  | Both c d => test_settled c given /\ test_settled d given \/ test_settled c given /\ holds c (map value_of given) = false \/ test_settled d given
    /\ holds d (map
    value_of given) = false
  end.
(* A result is known where all that its operation takes is, and its rule allows it; a selection needs no side that it leaves out. *)
Definition known (o : operation) (given : list number) := match o, given with | Choose c, x :: y :: compared => if leaves_open c (map snd (map snd
  compared)) then fst x /\ fst y else test_settled c compared /\ fst (if holds c (map value_of compared) then x else y) | _, _ => Forall (fun n =>
  fst n) given /\ allowed o (map snd given) end.
Definition machine_of (count : operation -> list (kind * (R * R)) -> R) : machine operation number :=
  fun o given => (known o given, (kind_of o (map (fun n => fst (snd n)) given), (in_float64 o (map value_of given), count o (map snd given)))).

(* An exact number has a meaning where no divisor that it needs is 0, and of no logarithm the argument is not positive. *)
Definition exact_number : Type := Prop * R.
Definition zero_meant : exact_number := (True, 0).
Definition meant (o : operation) (given : list exact_number) := match o, given with | Choose c, x :: y :: compared => fst (if holds c (map snd
  compared) then x else y) | Quotient, [x; y] => fst x /\ fst y /\ snd y <> 0 | Logarithm, [x] => fst x /\ 0 < snd x | _, _ => Forall (fun x =>
  fst x) given end.
Definition exact_machine : machine operation exact_number := fun o given => (meant o given, exactly o (map snd given)).

Definition known_encloses (s : R) (n : number) (x : exact_number) := fst n -> fst x /\ encloses s (snd (snd n)) (snd x).
Definition bounds_programs (count : operation -> list (kind * (R * R)) -> R) := forall (p : program operation) (inputs : list number) (exact :
  list exact_number) (output : nat), INR (length p) <= 2 ^ 28 -> Forall2 (known_encloses 1) inputs exact -> let n := nth output (run operation
  number (machine_of count) zero_known p inputs) zero_known in value_of n = nth output (run operation R in_float64 0 p (map value_of inputs)) 0 /\
  (fst n -> let x := nth output (run operation exact_number exact_machine zero_meant p exact) zero_meant in fst x /\ Rabs (value_of n - snd x) <=
  ROUNDING * snd (snd (snd n))).

Section composition.
Variable s : R.
Hypothesis S1 : 1 <= s.
Hypothesis S2 : s <= 1 + 3 / 2 ^ 22.
Lemma nth_enclosed given exact i : Forall2 (known_encloses s) given exact -> known_encloses s (nth i given zero_known) (nth i exact zero_meant).
Proof.
  intro A. revert i. induction A as [|n x given exact E A IH]; intros [|i]; try (intros _; repeat split; cbn; try apply generic_format_0; [lra |
    rewrite Rminus_eq_0, Rabs_R0; lra]); [exact E | apply IH].
Qed.
Lemma taken_enclosed given exact places : Forall2 (known_encloses s) given exact -> Forall2 (known_encloses s) (taken number zero_known given places)
  (taken exact_number zero_meant exact places).
Proof. intro A. induction places; constructor; [apply nth_enclosed, A | assumption]. Qed.
Lemma near_is_symmetric a b : too_near a b = too_near b a.
Proof. unfold too_near. rewrite (Rplus_comm (snd a)), <- (Ropp_minus_distr (fst a)), rounded_opp, Rabs_Ropp. reflexivity. Qed.
Lemma not_near a b a' b' : encloses s a a' -> encloses s b b' -> too_near a b = false -> fst a < fst b <-> a' < b'.
Proof.
  intros (A & Ea & Pa & Da) (B & Eb & Pb & Db) N. apply (decided_apart s (fst a) (snd a) a' (fst b) (snd b) b'); try assumption. unfold too_near in N.
    destruct (either _ _) as [H|]; [exact H | discriminate].
Qed.
Lemma decided_is_right c given exact : Forall2 (known_encloses s) given exact -> test_settled c given -> holds c (map value_of given) = holds c (map
  snd exact).
Proof.
  intro A. assert (U : forall i, nth i (map snd exact) 0 = snd (nth i exact zero_meant)) by (intro i; apply (map_nth snd exact zero_meant)). assert
    (V : forall i, nth i (map value_of given) 0 = value_of (nth i given zero_known)) by (intro i; apply (map_nth value_of given
    zero_known)).
  induction c as [i j | i j | c IH | c IHc d IHd]; cbn [test_settled holds]; [| | intro N; f_equal; apply IH, N |].
  1, 2: intros (Ki & Kj & N); rewrite !V, !U; unfold value_of in *; destruct (nth_enclosed _ _ i A Ki) as [_ Ei]; destruct (nth_enclosed _ _ j A Kj)
    as [_ Ej];
    pose proof not_near _ _ _
    _ Ei Ej N as L; rewrite near_is_symmetric in N;
    pose proof not_near _ _ _ _ Ej Ei N as G.
  - destruct Rlt_dec, Rlt_dec; reflexivity || tauto.
  - destruct Req_EM_T as [E|E], Req_EM_T as [E'|E']; try reflexivity; exfalso; [apply E' | apply E]; apply Rle_antisym; apply Rnot_lt_le; intro H;
      first [apply L in H | apply G in H]; lra.
  - intros [[C D] | [[C F] | [D F]]]; [rewrite IHc, IHd by assumption; reflexivity | rewrite <- IHc, F by exact C; reflexivity | rewrite <- IHd, F by
      exact D; rewrite !andb_false_r; reflexivity].
Qed.
Lemma values given : map value_of given = map fst (map snd (map snd given)).
Proof. rewrite !map_map. reflexivity. Qed.
Lemma all_known given exact : Forall2 (known_encloses s) given exact -> Forall (fun n => fst n) given -> Forall (fun x => fst x) exact /\ Forall2
  (fun n => encloses s (snd n)) (map snd given) (map snd exact).
Proof. intro A. induction A as [|n x given exact E A IH]; intro K; inversion K; split; constructor; try apply E; try apply IH; assumption. Qed.
Lemma rule_means o given exact : Forall2 (fun n => encloses s (snd n)) given (map snd exact) -> allowed o given -> Forall (fun x => fst x) exact ->
  match o with Choose _ => True | _ => meant o exact end.
Proof.
  intros A H F. destruct o; try exact F; try exact I.
  - destruct exact as [|x [|y [|z exact]]]; try exact F. inversion A as [|[a [v e]] x' g1 r1 X A1]; subst. inversion A1 as [|[b [w d]] y' g2 r2 Y
      A2]; subst. inversion A2; subst.
    destruct X as (X & E & P & D), Y as (Y & G & Q & M), H as [U L]. inversion F as [|? ? Fx F1]; subst. inversion F1 as [|? ? Fy _]; subst. cbn [fst
      snd] in *.
    split; [exact Fx | split; [exact Fy | exact (proj1 (enclosing_rules__quotient s v e (snd x) w d (snd y) S1 S2 X E P D Y G Q M U L))]].
  - destruct exact as [|x [|y exact]]; try exact F. inversion A as [|[a [v e]] x' g1 r1 X A1]; subst. inversion A1; subst. destruct X as (X & E & P &
      D), H as (_ & U & L & T).
    inversion F as [|? ? Fx _]; subst. cbn [fst snd] in *. split; [exact Fx|]. apply Rabs_le_inv in D. assert (0 < v) by lra.
    assert (s * e <= s * (2 ^ 52 * v)) by (apply Rmult_le_compat_l; lra). assert (s * v <= (1 + 3 / 2 ^ 22) * v) by (apply Rmult_le_compat_r; lra).
      lra.
Qed.
Lemma one_line o given exact : Forall2 (known_encloses s) given exact -> known_encloses (s * (1 + 1 / 2 ^ 49)) (machine_of counted_roundings o given)
  (exact_machine o exact).
Proof.
  intros A K. assert (Rule : Forall (fun n => fst n) given /\ allowed o (map snd given) ->
    match o with Choose _ => True | _ => meant o exact end /\ encloses (s * (1 + 1 / 2 ^ 49)) (snd (snd (machine_of counted_roundings o given)))
      (exactly o (map snd exact))).
  { intros [F H]. destruct (all_known _ _ A F) as [M E]. split; [exact (rule_means o _ _ E H M)|]. cbn [snd machine_of]. rewrite values. apply
    every_rule; assumption. }
  destruct o; try exact (Rule K). clear Rule. destruct A as [|x x' given exact X A]; [destruct K as [_ []]|]. destruct A as [|y y' compared exact Y
    A]; [destruct K as [_ []]|].
  cbn [machine_of exact_machine meant fst snd known map in_float64 counted_roundings exactly] in *. destruct x as [kx [a [x ex]]], y as [ky [b [y
    ey]]]. change (value_of
    (kx, (a, (x, ex)))) with x. change (value_of (ky, (b, (y, ey)))) with y. cbn [fst snd] in *.
  destruct (leaves_open c (map snd (map snd compared))).
  - destruct K as [Kx Ky]. destruct (X Kx) as (Mx & Fx & Ex & Px & Dx), (Y Ky) as (My & Fy & Ey & Py & Dy). split; [destruct (holds c _);
      assumption|]. split; [destruct (holds c _); assumption | apply open_covers; assumption].
  - destruct K as [D K]. rewrite <- (decided_is_right c compared exact A D), <- values. destruct (holds c (map value_of compared)).
    + destruct (X K) as [M E]. exact (conj M (not_more _ _ _ S1 E)).
    + destruct (Y K) as [M E]. exact (conj M (not_more _ _ _ S1 E)).
Qed.
End composition.

Lemma composition p : forall s given exact, 1 <= s -> s * (1 + 1 / 2 ^ 49) ^ length p <= 1 + 3 / 2 ^ 22 -> Forall2 (known_encloses s) given exact ->
  Forall2 (known_encloses (s * (1 + 1 / 2 ^ 49) ^ length p)) (run operation number (machine_of counted_roundings) zero_known p given) (run operation
    exact_number exact_machine zero_meant p exact).
Proof.
  induction p as [|[o places] p IH]; intros s given exact S1 S2 A; cbn [run length] in *; [rewrite pow_O, Rmult_1_r; exact A|]. rewrite <-
    tech_pow_Rmult, <- Rmult_assoc in *.
  assert (G : 1 <= (1 + 1 / 2 ^ 49) ^ length p) by (apply pow_R1_Rle; lra). assert (s * (1 + 1 / 2 ^ 49) * 1 <= s * (1 + 1 / 2 ^ 49) * (1 + 1 / 2 ^
    49) ^ length p) by (apply Rmult_le_compat_l; lra).
  apply IH; [lra | exact S2|]. apply Forall2_app.
  - clear - A S1. induction A as [|n x given exact E A IH]; [constructor|]. constructor; [|exact IH]. intro K. destruct (E K) as [M N]. exact (conj M
      (not_more _ _ _ S1 N)).
  - constructor; [|constructor]. apply one_line; [exact S1 | lra | apply taken_enclosed, A].
Qed.
Theorem enclosing_rules__whole_programs : bounds_programs counted_roundings.
Proof.
  intros p inputs exact output N A n. split.
  - unfold n. change 0 with (value_of zero_known). rewrite <- (around operation number R value_of (machine_of counted_roundings) in_float64) by
      reflexivity. rewrite map_nth. reflexivity.
  - destruct (slack_of_counts _ N) as [S B]. pose proof composition p 1 inputs exact (Rle_refl 1) as C. rewrite Rmult_1_l in C. specialize (C S
      A). intro K.
    destruct (nth_enclosed _ _ _ output C K) as (M & _ & _ & P & D). split; [exact M|]. at_most_by D.
    fold n. fold n in P. apply Rle_trans with ((1 + 1 / 2 ^ 49) ^ length p / 2 ^ 53 * snd (snd (snd n))); [lra | apply Rmult_le_compat_r; assumption].
Qed.

Lemma exactly_known a v : float64 v -> known_encloses 1 (True, (a, (v, 0))) (True, v).
Proof. intros F _. exact (conj I (exactly_encloses 1 v F)). Qed.
Ltac each_input := repeat apply Forall2_cons; try apply Forall2_nil.
Ltac run_shown := cbn -[too_near Rlt_dec IZR pow]; unfold value_of; cbn [fst snd].
Lemma exactly_apart a b : too_near (a, 0) (b, 0) = false.
Proof. unfold too_near. cbn [fst snd]. rewrite Rplus_0_r, rounded_0. destruct (either _ _) as [|[_ N]]; [reflexivity | destruct (N eq_refl)]. Qed.
(* Two lines: 1/0, unless 0 < 1. The quotient's rule allows nothing, and what takes the other side is known. *)
Definition ordinary : kind := Run false false.
Theorem enclosing_rules__whole_programs__point : exists p inputs exact, INR (length p) <= 2 ^ 28 /\ Forall2 (known_encloses 1) inputs exact /\ let
  results := run operation number (machine_of counted_roundings) zero_known p inputs in fst (nth 3 results zero_known) /\ ~ fst (nth 2 results
  zero_known).
Proof.
  exists ((Quotient, [0; 1]%nat) :: (Choose (Less 0 1), [0; 2; 1; 0]%nat) :: nil), ((True, (ordinary, (1, 0))) :: (True, (ordinary, (0, 0))) :: nil),
    ((True, 1) :: (True, 0) :: nil).
  split; [cbn; lra | split; [each_input; apply exactly_known; [exact one_is_float64 | apply generic_format_0]|]].
  run_shown. rewrite exactly_apart. destruct Rlt_dec; [|lra]. split; [repeat split; apply exactly_apart|]. rewrite Rabs_R0. lra.
Qed.
(* Counts that an open selection adds nothing to, those of products that one factor's count is left to, and those by which a constant may be another
  than what it stands for, bound no programs. *)
Definition without_open (o : operation) (given : list (kind * (R * R))) := match o, given with | Choose c, (_, (_, e)) :: (_, (_, d)) :: compared
  => if holds c (map fst (map snd compared)) then e else d | _, _ => counted_roundings o given end.
Definition without_factor (o : operation) (given : list (kind * (R * R))) := match o, given with Product, [(_, (_, e)); _] => e | _, _ =>
  counted_roundings o given end.
Definition without_constant (o : operation) (given : list (kind * (R * R))) := match o with Constant _ _ _ => 0 | _ => counted_roundings o given
  end.
Theorem enclosing_rules__whole_programs__false : ~ bounds_programs without_open /\ ~ bounds_programs without_factor /\ ~ bounds_programs
    without_constant.
Proof.
  assert (B : 2 ^ 53 = bpow radix2 53) by (simpl; lra). assert (F : float64 (2 ^ 53)) by (rewrite B; apply generic_format_bpow; easy). assert (F0 :
    float64 0) by apply generic_format_0.
  assert (E : forall v x, float64 v -> Rabs (v - x) <= 1 -> known_encloses 1 (True, (ordinary, (v, 2 ^ 53))) (True, x)) by (intros v x V D _; repeat
    split;
    cbn
    -[pow]; [exact V | exact F | lra | lra]).
  repeat split; intro H.
  - specialize (H ((Choose (Less 0 1), [0; 1; 2; 1]%nat) :: nil) ((True, (ordinary, (0, 0))) :: (True, (ordinary, (1, 0))) :: (True, (ordinary, (1, 2
      ^ 53)))
      :: nil) ((True, 0) :: (True, 1) :: (True, 0) :: nil) 3%nat ltac:(cbn; lra)).
    destruct H as [_ H]; [each_input; try apply exactly_known; try (apply E; [|rewrite Rminus_0_r, Rabs_R1; lra]); assumption || exact
      one_is_float64|]. revert H. run_shown.
    assert (N : too_near (1, 2 ^ 53) (1, 0) = true).
    { unfold too_near. cbn [fst snd]. rewrite Rminus_eq_0, rounded_0, Rabs_R0, Rplus_0_r, (kept _ F). destruct (either _ _) as [[L|L]|];
      [|lra|reflexivity].
      assert (0 <= rounded (2 ^ 53 * ROUNDING)) by is_not_negative. lra. }
    rewrite N. repeat (destruct Rlt_dec; try lra). intro H. destruct (H (conj I I)) as [_ G]. clear H. rename G into H. rewrite Rminus_0_r, Rabs_R1
      in H. lra.
  - specialize (H ((Product, [0; 1]%nat) :: nil) ((True, (ordinary, (0, 2 ^ 53))) :: (True, (ordinary, (2, 0))) :: nil) ((True, 1) :: (True, 2) ::
      nil) 2%nat ltac:(cbn; lra)).
    destruct H as [_ H]; [each_input; [apply E; [exact F0 | rewrite Rminus_0_l, Rabs_Ropp, Rabs_R1; lra] | apply exactly_known, two_is_float64]|].
      revert H. run_shown.
    unfold enclosed_product_float64.product. rewrite Rmult_0_l, rounded_0, Rmult_1_l, Rminus_0_l, Rabs_Ropp, Rabs_pos_eq by lra. intro H. destruct (H
      ltac:(repeat constructor; lra)) as [_ G]. in_units.
  - destruct (H ((Constant 1 (2 ^ 53) 0, nil) :: nil) nil nil 0%nat ltac:(cbn; lra) ltac:(constructor)) as [_ G]. revert G. run_shown. intro G. clear
      H.
    destruct G as [_ G]; [split; [constructor|]; split; [exact one_is_float64 | split; [exact F | split; cbn [fst snd]; [lra | rewrite Rminus_0_r,
    Rabs_R1;
      lra]]]|].
    rewrite Rminus_0_r, Rabs_R1 in G. lra.
Qed.
