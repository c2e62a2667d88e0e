(* The rules of slopes compose: however the inputs move, the slope that is computed with a line is the derivative of its value. *)

From Coquelicot Require Import Coquelicot.
From Coq Require Import Reals Lra ZArith List.
From Flocq Require Import Core.
From Formal Require Import Preliminaries Float Programs Fields ImageDerivative EnclosingOperations.
Open Scope R_scope.
Import ListNotations.

(* A number of a program: whether it has a slope, its value, and that slope. *)
Definition sloped : Type := Prop * (R * R).
Definition still_number := (True, (0, 0)).
Definition slope_by_rule (o : operation) (given : list (R * R)) : R :=
  match o, given with
  | Negative, [(_, d)] => - d
  | Size, [(x, d)] => if Rlt_dec x 0 then - d else d
  | Sum, [(_, d); (_, e)] => d + e
  | Difference, [(_, d); (_, e)] => d - e
  | Product, [(x, d); (y, e)] => y * d + x * e
  | Quotient, [(x, d); (y, e)] => 1 / y * (d + - (x / y) * e)
  | Root, [(x, d)] => 1 / 2 / sqrt x * d
  | Sine, [(x, d); (y, e)] => PI * cos (PI * (x * y)) * (y * d + x * e)
  | Cosine, [(x, d); (y, e)] => - PI * sin (PI * (x * y)) * (y * d + x * e)
  | Angle, [(y, e); (x, d)] => 1 / (PI * (x * x + y * y)) * (x * e + - y * d)
  | Exponential, [(x, d)] => exp x * d
  | Logarithm, [(x, d)] => 1 / x * d
  | Raised, [(x, d); (p, e)] => p * power x p / x * d + power x p * ln x * e
  | Choose c, (_, d) :: (_, e) :: compared => if holds c (map fst compared) then d else e
  | _, _ => 0
  end.
(* Numbers that have slopes and differ decide a comparison, and nearby alike. *)
Fixpoint tests_apart (c : test) (given : list sloped) : Prop :=
  match c with
  | Less i j | Same i j => let a := nth i given still_number in let b := nth j given still_number in fst a /\ fst b /\ fst (snd a) <> fst (snd b)
  | Not c => tests_apart c given
  | Both c d => tests_apart c given /\ tests_apart d given
  end.
(* No divisor is 0, no root, logarithm or power is of what is not positive, nothing jumps, no selection is open; of its sides one is asked. *)
Definition has_slope (o : operation) (given : list sloped) : Prop :=
  match o, given with
  | Choose c, x :: y :: compared => tests_apart c compared /\ fst (if holds c (map fst (map snd compared)) then x else y)
  | _, _ => Forall fst given /\ match o, map fst (map snd given) with
    | Size, [x] => x <> 0
    | Quotient, [_; y] => y <> 0
    | Root, [x] | Logarithm, [x] | Raised, [x; _] => 0 < x
    | Floor, [x] => x <> IZR (Int_part x)
    | Nearest, [x] => Rabs (x - rint x) <> / 2
    | Angle, [y; x] => 0 < x \/ x < 0 /\ y <> 0
    | _, _ => True
    end
  end.
Definition sloping (slope : operation -> list (R * R) -> R) : machine operation sloped :=
  fun o given => (has_slope o given, (exactly o (map fst (map snd given)), slope o (map snd given))).
(* What a number is of a function, at t. *)
Definition moves (t : R) (n : sloped) (f : R -> R) : Prop := fst (snd n) = f t /\ (fst n -> is_derive f t (snd (snd n))).
Definition differentiates_programs (slope : operation -> list (R * R) -> R) : Prop :=
  forall (p : program operation) (numbers : list sloped) (inputs : list (R -> R)) (t : R) (output : nat), Forall2 (moves t) numbers inputs ->
  moves t (nth output (run operation sloped (sloping slope) still_number p numbers) still_number)
    (fun s => nth output (run operation R exactly 0 p (map (fun f => f s) inputs)) 0).

Lemma same_side_nearby (f : R -> R) t a : ex_derive f t -> f t <> a -> locally t (fun s => 0 < (f t - a) * (f s - a)).
Proof.
  intros D N. apply (ex_derive_continuous f t D (fun y => 0 < (f t - a) * (y - a))). exists (mkposreal _ (Rabs_pos_lt (f t - a) ltac:(lra))).
    intros y B.
  change (Rabs (y - f t) < Rabs (f t - a)) in B. revert B. unfold Rabs. repeat destruct Rcase_abs; nra.
Qed.
Definition moving : machine operation (R -> R) := fun o fs s => exactly o (map (fun f => f s) fs).
Section at_t.
Variable t : R.
Lemma still_number_moves : moves t still_number (fun _ => 0).
Proof. split; [reflexivity | intros _; apply (is_derive_const 0)]. Qed.
Lemma nth_moves given fs i : Forall2 (moves t) given fs -> moves t (nth i given still_number) (nth i fs (fun _ => 0)).
Proof.
  intro A. revert i. induction A as [|n f given fs M _ IH]; intros [|i]; [apply still_number_moves | apply still_number_moves | exact M | apply IH].
Qed.
Lemma values_move given fs : Forall2 (moves t) given fs -> map fst (map snd given) = map (fun f => f t) fs.
Proof. intro A. induction A as [|n f given fs [E _] _ IH]; [reflexivity|]. cbn [map]. rewrite E, IH. reflexivity. Qed.
Lemma decided_nearby c given fs : Forall2 (moves t) given fs -> tests_apart c given ->
  locally t (fun s => holds c (map (fun f : R -> R => f s) fs) = holds c (map fst (map snd given))).
Proof.
  intro A. rewrite (values_move _ _ A). assert (U : forall i s, nth i (map (fun f => f s) fs) 0 = nth i fs (fun _ => 0) s) by (intros i s; apply
    (map_nth (fun f => f s) fs (fun _ => 0))).
  induction c as [i j | i j | c IH | c IHc d IHd]; cbn [tests_apart holds].
  1, 2: intros (Ki & Kj & N); destruct (nth_moves _ _ i A) as [Ei Di], (nth_moves _ _ j A) as [Ej Dj]; rewrite Ei, Ej in N; generalize
    (same_side_nearby
    (fun s => nth i fs (fun _ => 0) s - nth j fs (fun _ => 0) s) t 0 (ex_intro _ _ (is_derive_minus _ _ _ _ _ (Di Ki) (Dj Kj))) ltac:(lra));
    apply filter_imp; intros s P; rewrite !U; repeat destruct Rlt_dec; repeat destruct Req_EM_T; try reflexivity; nra.
  - intro N. generalize (IH N). apply filter_imp. intros s ->. reflexivity.
  - intros [N M]. generalize (filter_and _ _ (IHc N) (IHd M)). apply filter_imp. intros s [-> ->]. reflexivity.
Qed.
Lemma whole_nearby (f whole : R -> R) d n a b : is_derive f t d -> a < f t < b -> (forall y, a < y < b -> whole y = n) -> is_derive (fun s =>
  whole (f s)) t 0.
Proof.
  intros D B W. apply (is_derive_ext_loc (fun _ => n)); [|apply (is_derive_const n)]. assert (E : ex_derive f t) by (exists d; exact D).
  pose proof same_side_nearby f t a E ltac:(lra) as L. pose proof same_side_nearby f t b E ltac:(lra) as G. generalize (filter_and _ _ L G).
    apply filter_imp. intros s [P Q]. symmetry.
  apply W. nra.
Qed.
Lemma angle_nearby (f g : R -> R) : ex_derive f t -> ex_derive g t -> 0 < g t \/ g t < 0 /\ f t <> 0 ->
  exists c, locally t (fun s => (atan (f s / g s) + c) / PI = atan2pi (f s) (g s)).
Proof.
  intros F G N. exists (if Rlt_dec 0 (g t) then 0 else if Rlt_dec 0 (f t) then PI else - PI). unfold atan2pi, atan2.
  pose proof same_side_nearby g t 0 G as P. destruct N as [N | [N M]].
  - generalize (P ltac:(lra)). apply filter_imp. intros s Q. repeat destruct Rlt_dec; nra.
  - specialize (P ltac:(lra)). generalize (filter_and _ _ P (same_side_nearby f t 0 F M)). apply filter_imp. intros s [Q O]. repeat destruct Rlt_dec;
    try destruct Rle_dec; nra.
Qed.
Ltac given_slopes := repeat match goal with
  | M : moves _ _ _ |- _ => destruct M; cbn [fst snd] in *; subst
  | K : _ /\ _ |- _ => destruct K
  | K : Forall _ (_ :: _) |- _ => apply Forall_cons_iff in K
  | D : ?k -> _, K : ?k |- _ => specialize (D K)
  end.
Lemma one_line_moves o given fs : Forall2 (moves t) given fs -> moves t (sloping slope_by_rule o given) (moving o fs).
Proof.
  intro A. split; [unfold moving; rewrite <- (values_move _ _ A); reflexivity|]. unfold sloping, moving. cbn [fst snd]. intro K.
  destruct o; (destruct A as [|[k [x dx]] f given fs M A]; [try apply (is_derive_const 0)|destruct A as [|[l [y dy]] g given fs N A]; [try apply
    (is_derive_const 0) |
    try (destruct A; [|apply (is_derive_const 0)])]]); try apply is_derive_const.
  all: cbn [has_slope slope_by_rule exactly map fst snd] in *; try apply (is_derive_const 0); try (given_slopes; by_rules; field; lra).
  - given_slopes. by_rules. destruct Rlt_dec; [rewrite sign_eq_m1 | rewrite sign_eq_1]; lra.
  - given_slopes. by_rules. field. apply Rgt_not_eq, sqrt_lt_R0. assumption.
  - given_slopes. pose proof base_Int_part (f t). set (n := IZR _) in *. apply (whole_nearby f (fun y => IZR (Int_part y)) dx n n (n + 1));
    [assumption | lra | intros; apply floor_is; fold n; lra].
  - given_slopes. pose proof Znearest_half (fun n => negb (Z.even n)) (f t) as B. fold (rint (f t)) in B. set (n := rint _) in *.
    apply (whole_nearby f rint dx n (n - / 2) (n + / 2)); [assumption | revert B; unfold Rabs in *; destruct Rcase_abs; lra|].
    intros y Y. unfold n, rint in *. f_equal. apply Znearest_imp, Rabs_def1; lra.
  - given_slopes. destruct (angle_nearby f g) as [c L]; try (eexists; eassumption); try assumption. apply (is_derive_ext_loc _ _ _ _ L).
    assert (g t <> 0) by lra. by_rules. pose proof PI_neq0. field. repeat split; nra.
  - given_slopes. apply (is_derive_ext_loc (fun s => exp (g s * ln (f s)))).
    + assert (E : ex_derive f t) by (eexists; eassumption). generalize (same_side_nearby f t 0 E ltac:(lra)). apply filter_imp. intros s P.
      unfold power.
      destruct Rlt_dec; [reflexivity | nra].
    + unfold power. destruct Rlt_dec; [|lra]. unfold Rpower. by_rules. field. lra.
  - destruct K as [K F]. pose proof decided_nearby c given fs A K as L. set (h := holds c (map fst _)) in *.
    apply (is_derive_ext_loc (fun s => if h then f s else g s)); [revert L; apply filter_imp; intros s ->; reflexivity|].
    destruct h; [apply M | apply N]; exact F.
Qed.
Theorem all_lines_move p : forall given fs, Forall2 (moves t) given fs ->
  Forall2 (moves t) (run operation sloped (sloping slope_by_rule) still_number p given) (run operation (R -> R) moving (fun _ => 0) p fs).
Proof.
  induction p as [|[o places] p IH]; intros given fs A; [exact A|]. apply IH, Forall2_app; [exact A|]. constructor; [|constructor].
  apply one_line_moves. induction places; constructor; [apply nth_moves, A | assumption].
Qed.
End at_t.
Theorem image_derivative__programs : differentiates_programs slope_by_rule.
Proof.
  intros p numbers inputs t output A. destruct (nth_moves t _ _ output (all_lines_move t p _ _ A)) as [E D].
  assert (V : forall s, nth output (run operation R exactly 0 p (map (fun f => f s) inputs)) 0 = nth output (run operation (R -> R) moving (fun
    _ => 0) p inputs) (fun _ => 0) s).
  { intro s. rewrite <- (map_nth (fun f => f s)), (around operation (R -> R) R (fun f => f s) moving exactly (fun _ => 0) (fun _ _ => eq_refl)).
    reflexivity. }
  split; [rewrite V; exact E|]. intro K. apply (is_derive_ext _ _ _ _ (fun s => eq_sym (V s))), D, K.
Qed.

(* Two lines at 1: its square, and 1 over it where the square is not below 1. *)
Theorem image_derivative__programs__point : exists p numbers inputs, Forall2 (moves 1) numbers inputs /\
  fst (nth 2 (run operation sloped (sloping slope_by_rule) still_number p numbers) still_number).
Proof.
  exists [(Product, [0; 0]%nat); (Quotient, [0; 1]%nat)], [(True, (1, 1))], [fun s => s].
  split; [constructor; [split; [reflexivity | intros _; apply (is_derive_id 1)] | constructor]|]. cbn. repeat constructor. intro. lra.
Qed.
(* Not where a factor's slope is taken off. *)
Definition product_wrong (o : operation) (given : list (R * R)) : R := match o, given with Product, [(x, d); (y, e)] => y * d - x * e | _, _ =>
  slope_by_rule o given end.
Theorem image_derivative__programs__false : ~ differentiates_programs product_wrong.
Proof.
  intro H. destruct (H [(Product, [0; 0]%nat)] [(True, (1, 1))] [fun s => s] 1 1%nat) as [_ D]; [constructor; [split; [reflexivity | intros _; apply
    (is_derive_id 1)] | constructor]|].
  cbn in D. specialize (D ltac:(repeat constructor)). apply is_derive_unique in D. assert (E : is_derive (fun s : R => s * s) 1 2) by
    (auto_derive; trivial; ring).
  apply is_derive_unique in E. lra.
Qed.
