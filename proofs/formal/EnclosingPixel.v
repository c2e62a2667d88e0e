(* A pixel's colours lie within the bounds that are counted with them, by the program that is recorded from the shader. *)

From Coq Require Import Reals Lra Lia ZArith List.
From Formal Require Import Programs RecordedPixel Rounding EnclosingRules EnclosingOperations EnclosingPrograms.
Open Scope R_scope.
Import ListNotations.

(* What is no number is not equal to itself; of real numbers that asks nothing. *)
Fixpoint test_of (c : recorded_pixel.condition) : test :=
  match c with
  | recorded_pixel.Lt i j => Less i j
  | recorded_pixel.Le i j => Not (Less j i)
  | recorded_pixel.Eq i j => Same i j
  | recorded_pixel.Ne i j => Not (Same i j)
  | recorded_pixel.Invert c => Not (test_of c)
  | recorded_pixel.And c (recorded_pixel.Eq i j) => if (i =? j)%nat then test_of c else Both (test_of c) (Same i j)
  | recorded_pixel.And c d => Both (test_of c) (test_of d)
  | recorded_pixel.Or c d => Not (Both (Not (test_of c)) (Not (test_of d)))
  end.
(* A constant m 2^e stands for a real number, and has a count. What is missed is 2^1023 away: float64's model here has no infinity. *)
Definition operation_of (constants : Z -> Z -> R * R) (o : recorded_pixel.operation) : operation :=
  match o with
  | recorded_pixel.Literal m e => Literal m e
  | recorded_pixel.Infinite => Literal 1 1023
  | recorded_pixel.Constant m e => Constant (literal m e) (snd (constants m e)) (fst (constants m e))
  | recorded_pixel.Neg => Negative
  | recorded_pixel.Abs => Size
  | recorded_pixel.Add => Sum
  | recorded_pixel.Sub => Difference
  | recorded_pixel.Mul => Product
  | recorded_pixel.Truediv => Quotient
  | recorded_pixel.Sqrt => Root
  | recorded_pixel.Floor => Floor
  | recorded_pixel.Rint => Nearest
  | recorded_pixel.Sinpi => Sine
  | recorded_pixel.Cospi => Cosine
  | recorded_pixel.Atan2pi => Angle
  | recorded_pixel.Product_error => Rest
  | recorded_pixel.Exp => Exponential
  | recorded_pixel.Log => Logarithm
  | recorded_pixel.Power => Raised
  | recorded_pixel.Where c => Choose (test_of c)
  end.
(* A sine takes a product in two parts: its line takes the factors, as its rule does. *)
Definition places_of (o : recorded_pixel.operation) (places : list nat) : list nat :=
  match o, places with
  | recorded_pixel.Sinpi, product :: _ | recorded_pixel.Cospi, product :: _ =>
    match nth (product - recorded_pixel.inputs) recorded_pixel.pixel (recorded_pixel.Infinite, nil) with (recorded_pixel.Mul, factors) => factors | _
      => nil end
  | _, _ => places
  end.
Definition pixel_of (constants : Z -> Z -> R * R) : program operation :=
  map (fun one => (operation_of constants (fst one), places_of (fst one) (snd one))) recorded_pixel.pixel.
Theorem pixel_accuracy__recorded constants inputs exact output : Forall2 (known_encloses 1) inputs exact -> let n := nth output (run operation
  number (machine_of counted_roundings) zero_known (pixel_of constants) inputs) zero_known in value_of n = nth output (run operation R in_float64
  0 (pixel_of constants) (map value_of inputs)) 0 /\ (fst n -> let x := nth output (run operation exact_number exact_machine zero_meant (pixel_of
  constants) exact) zero_meant in fst x /\ Rabs (value_of n - snd x) <= ROUNDING * snd (snd (snd n))).
Proof.
  intro A. apply enclosing_rules__whole_programs; [|exact A]. unfold pixel_of. rewrite map_length.
  assert (L : (Z.of_nat (length recorded_pixel.pixel) <= 2 ^ 28)%Z) by (apply Z.leb_le; vm_compute; reflexivity). rewrite INR_IZR_INZ, (pow_IZR 2
    28). apply IZR_le, L.
Qed.

Lemma inputs_stay (V : Type) m none p : forall values place, (place < length values)%nat -> nth place (run operation V m none p values) none = nth
  place values none.
Proof. induction p as [|[o places] p IH]; intros values place L; cbn [run]; [reflexivity|]. rewrite IH, app_nth1 by (rewrite ?app_length; lia).
  reflexivity. Qed.
Theorem pixel_accuracy__recorded__point : exists inputs exact, Forall2 (known_encloses 1) inputs exact /\ Forall (fun n => fst n) inputs /\ length
  inputs = recorded_pixel.inputs.
Proof.
  exists (repeat (True, (ordinary, (1, 0))) recorded_pixel.inputs), (repeat (True, 1) recorded_pixel.inputs). rewrite repeat_length. generalize
    recorded_pixel.inputs. intro n.
  induction n as [|n (A & K & _)]; repeat split; constructor; try assumption; [apply exactly_known, one_is_float64 | exact I].
Qed.
(* What is not known need not be within its bound. *)
Theorem pixel_accuracy__recorded__false : ~ forall constants inputs exact output, Forall2 (known_encloses 1) inputs exact -> let n := nth output
  (run operation number (machine_of counted_roundings) zero_known (pixel_of constants) inputs) zero_known in Rabs (value_of n - snd (nth output
  (run operation exact_number exact_machine zero_meant (pixel_of constants) exact) zero_meant)) <= ROUNDING * snd (snd (snd n)).
Proof.
  intro H. specialize (H (fun _ _ => (0, 0)) ((False, (ordinary, (1, 0))) :: nil) ((True, 0) :: nil) 0%nat). cbv zeta in H. rewrite !inputs_stay in H
    by
    (simpl; lia). unfold value_of in H. cbn [nth fst snd] in H.
  rewrite Rminus_0_r, Rabs_R1, Rmult_0_r in H. apply Rlt_irrefl with 0. apply Rlt_le_trans with 1; [lra|]. apply H. apply Forall2_cons; [intros [] |
    apply Forall2_nil].
Qed.
