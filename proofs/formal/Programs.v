(* Straight-line programs as data, machines that run them, and what an input reaches: the same on every machine. *)

From Coq Require Import List Bool Arith Lia.
Import ListNotations.

Section programs.
Variable operation : Type.
(* A line has an operation and the places of what it takes. *)
Definition line : Type := operation * list nat.
Definition program : Type := list line.
Definition machine (V : Type) : Type := operation -> list V -> V.
Definition taken (V : Type) (nothing : V) (values : list V) (places : list nat) : list V := map (fun place => nth place values nothing) places.
(* The inputs stand first; each line puts its value at the end. *)
Fixpoint run (V : Type) (m : machine V) (nothing : V) (p : program) (values : list V) : list V :=
  match p with
  | nil => values
  | (o, places) :: rest => run V m nothing rest (values ++ [m o (taken V nothing values places)])
  end.

(* The values of a machine are those of the machine that it is built around, whatever else it carries with them. *)
Theorem around (V W : Type) inside outer inner nothing : (forall o given, inside (outer o given) = inner o (map inside given)) -> forall p values,
  map inside (run V outer nothing p values) = run W inner (inside nothing) p (map inside values).
Proof.
  intros H p. induction p as [|[o places] p IH]; intro values; simpl; [reflexivity|]. rewrite IH, map_app. simpl. rewrite H. unfold taken.
  rewrite map_map. do 4 f_equal. apply map_ext. intro. symmetry. apply map_nth.
Qed.

(* A machine of truth values: a line's value may change if one that it takes may. *)
Definition changing : machine bool := fun _ => existsb (fun changes => changes).
(* Of so many inputs, those at the given places. *)
Definition at_places (inputs : nat) (places : list nat) : list bool := map (fun i => existsb (Nat.eqb i) places) (seq 0 inputs).
Definition reached_from (p : program) (marked : list bool) : list bool := run bool changing false p marked.
Definition reaches (p : program) (inputs : nat) (places outputs : list nat) : bool :=
  existsb (fun changes => changes) (taken bool false (reached_from p (at_places inputs places)) outputs).

Section independence.
Variable V : Type.
Variable m : machine V.
Variable nothing : V.
(* Two lists of values may differ where they are marked. *)
Definition agree (marked : list bool) (values others : list V) := length values = length marked /\ length others = length marked /\ forall i, nth
  i marked false = false -> nth i values nothing = nth i others nothing.

Lemma agree_taken marked values others places : agree marked values others -> existsb (fun b => b) (taken bool false marked places) = false ->
  taken V nothing values places = taken V nothing others places.
Proof.
  intros (_ & _ & A). induction places as [|i places IH]; simpl; [reflexivity|]. intros [N M]%orb_false_iff. f_equal; auto.
Qed.
Lemma agree_line marked values others b v w :
  agree marked values others -> (b = false -> v = w) -> agree (marked ++ b :: nil) (values ++ v :: nil) (others ++ w :: nil).
Proof.
  intros (L & K & A) H. unfold agree. rewrite !app_length, L, K. repeat split. intro i. destruct (Nat.lt_ge_cases i (length marked)).
  - rewrite !app_nth1 by lia. apply A.
  - rewrite !app_nth2, L, K by lia. destruct (i - length marked) as [|[|?]]; simpl; auto.
Qed.
Theorem independence_of_all p : forall marked values others,
  agree marked values others -> agree (reached_from p marked) (run V m nothing p values) (run V m nothing p others).
Proof.
  induction p as [|[o places] p IH]; intros marked values others A; simpl; [exact A|]. apply IH, agree_line; [exact A|]. unfold changing.
  intro N. rewrite (agree_taken _ _ _ _ A N). reflexivity.
Qed.
End independence.

(* On no machine do some outputs change with some of so many inputs. *)
Definition independent (p : program) (inputs : nat) (places outputs : list nat) := forall (V : Type) (m : machine V) (nothing : V) (values others
  : list V), length values = inputs -> length others = inputs -> (forall i, ~ In i places -> nth i values nothing = nth i others nothing) -> taken
  V nothing (run V m nothing p values) outputs = taken V nothing (run V m nothing p others) outputs.

Lemma at_place inputs places i : nth i (at_places inputs places) false = (i <? inputs) && existsb (Nat.eqb i) places.
Proof.
  unfold at_places. destruct (Nat.ltb_spec i inputs).
  - rewrite nth_indep with (d' := existsb (Nat.eqb 0) places) by (rewrite map_length, seq_length; assumption).
    rewrite (map_nth (fun j => existsb (Nat.eqb j) places)), seq_nth by assumption. reflexivity.
  - apply nth_overflow. rewrite map_length, seq_length. assumption.
Qed.
Lemma is_in i places : In i places <-> existsb (Nat.eqb i) places = true.
Proof. rewrite existsb_exists. split; [exists i; rewrite Nat.eqb_refl; auto | intros (j & I & ->%Nat.eqb_eq); exact I]. Qed.
(* That is computed on the program: the machine of truth values is one of them. *)
Theorem independence p inputs places outputs : reaches p inputs places outputs = false -> independent p inputs places outputs.
Proof.
  intros N V m nothing values others A B D. apply agree_taken with (2 := N), independence_of_all. unfold agree, at_places.
  rewrite map_length, seq_length. repeat split; [exact A | exact B|]. intros i E. fold (at_places inputs places) in E. rewrite at_place in E.
  destruct (Nat.ltb_spec i inputs); [|rewrite !nth_overflow by lia; reflexivity]. apply D. simpl in E. rewrite is_in, E. discriminate.
Qed.
Theorem dependence p inputs places outputs :
  taken bool false (reached_from p (at_places inputs nil)) outputs <> taken bool false (reached_from p (at_places inputs places)) outputs ->
  ~ independent p inputs places outputs.
Proof.
  intros N U. apply N, (U bool changing false); try (unfold at_places; rewrite map_length; apply seq_length).
  intros i I. rewrite is_in in I. rewrite !at_place, (not_true_is_false _ I). reflexivity.
Qed.
End programs.
