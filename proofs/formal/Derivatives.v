(* Tactics for printed claims with sines and derivatives: Coq takes these itself. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Claim.
Open Scope R_scope.

(* A derivative is there: beside corners, and where nothing is divided by 0. *)
Ltac beside := repeat split; solve [trivial | lra | nra].
Ltac differentiable := auto_derive; beside.
Ltac derivatives := repeat match goal with |- context [Derive ?f ?x] =>
  erewrite (is_derive_unique f x) by (auto_derive; [beside | reflexivity]) end.
(* One after the other. *)
Lemma next_derivative (n : nat) (f g : R -> R) (x l : R) : (forall t, is_derive_n f n t (g t)) -> is_derive g x l -> is_derive_n f (S n) x l.
Proof. intros F G. apply (is_derive_ext g); [intro; symmetry; apply is_derive_n_unique, F | exact G]. Qed.

(* Angles that are equal, written alike: what is like one of them is out of sight when the next is looked at. *)
Ltac angle f := match f with sin => idtac | cos => idtac end.
Ltac same_angles := repeat match goal with |- context [?f ?a] => angle f;
  repeat match goal with |- context [?g ?b] => angle g; assert_fails (constr_eq a b); replace b with a by ring end; set (sin a); set (cos a) end;
  repeat match goal with x := sin _ |- _ => subst x | x := cos _ |- _ => subst x end.
Ltac alike := angles; same_angles.
(* And as the claims write those of fields. *)
Ltac printed_angles := repeat match goal with |- context [PI * (?k * ?w)] => replace (PI * (k * w)) with (w * PI * k) by ring end.
(* Sizes and signs, where a sign is given. *)
Ltac signs := repeat match goal with
  | |- context [Rabs ?x] => first [rewrite (Rabs_pos_eq x) by lra | rewrite (Rabs_left1 x) by lra]
  | |- context [sign ?x] => first [rewrite (sign_eq_1 x) by lra | rewrite (sign_eq_m1 x) by lra] end.
Ltac slope := first [not_zero | differentiable | derivatives; lines; signs; first [ring | alike; first [ring | field; repeat split; not_zero]]].
Ltac slopes := red; intros; pose proof PI_RGT_0; rewrite ?Rplus_0_r in *; repeat split; slope.
