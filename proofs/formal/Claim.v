(* Tactics for the printed claims: what is shown first is there for the next; roots, angles and cases are taken apart. *)

From Coq Require Import Reals Lra Psatz Nsatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* The definitions of a claim's lines, put in their place. *)
Ltac lines := repeat match goal with x := _ |- _ => subst x end.

(* An equation's right side for its left one. *)
Ltac put x := match goal with E : x = _ |- _ => rewrite E end.

Ltac sum_of_squares := apply Rle_ge; repeat apply Rplus_le_le_0_compat; apply pow2_ge_0.

Ltac not_zero := match goal with
  | H : ?x <> 0 |- ?x <> 0 => exact H
  | |- _ * _ <> 0 => apply Rmult_integral_contrapositive_currified; not_zero
  | |- _ ^ _ <> 0 => apply pow_nonzero; not_zero
  | |- sqrt _ <> 0 => apply Rgt_not_eq, sqrt_lt_R0; first [lra | nra]
  | |- _ => apply Rgt_not_eq; first [lra | nra]
  | |- _ => apply Rlt_not_eq; first [lra | nra] end.

(* An equation that follows from equations: `nsatz` stops at whatever is none, and at one that says nothing. *)
Ltac equations := repeat match goal with
  | H : ?a = ?b |- _ => assert_succeeds (assert (a = b) by (clear; ring)); clear H
  | H : ?P |- _ => lazymatch type of P with Prop => lazymatch P with @eq R _ _ => fail | _ => clear H end end end.
Ltac ideal := solve [equations; apply Rminus_diag_uniq; match goal with |- ?x = 0 => ring_simplify x end; nsatz].
Ltac equation := match goal with |- _ = _ => first [ring | field; repeat split; not_zero | ideal | field_simplify_eq; [ideal | repeat split; not_zero ..]] end.

Ltac facts_of_root x := lazymatch goal with H : 0 <= sqrt x |- _ => fail | _ =>
  pose proof (sqrt_pos x); try (assert (sqrt x ^ 2 = x) by (apply pow2_sqrt; first [lra | nra])) end.
Ltac roots := repeat match goal with |- context [sqrt ?x] => facts_of_root x | H : context [sqrt ?x] |- _ => facts_of_root x end.

(* Sines and cosines of sums, and of a difference in parentheses. *)
Ltac angles := repeat match goal with
  | |- context [sin ?a] => progress ring_simplify a | |- context [cos ?a] => progress ring_simplify a end;
  rewrite ?sin_plus, ?cos_plus, ?sin_minus, ?cos_minus, ?sin_neg, ?cos_neg, ?sin_PI, ?cos_PI, ?sin_0, ?cos_0.
Ltac circle a := lazymatch goal with H : sin a ^ 2 + cos a ^ 2 = 1 |- _ => fail | _ =>
  assert (sin a ^ 2 + cos a ^ 2 = 1) by (rewrite <- !Rsqr_pow2; apply sin2_cos2); pose proof (SIN_bound a); pose proof (COS_bound a) end.
Ltac circles := repeat match goal with |- context [sin ?a] => circle a | |- context [cos ?a] => circle a end.

Ltac cases := repeat match goal with
  | |- context [Rabs ?x] => destruct (Rle_dec 0 x); [rewrite (Rabs_pos_eq x) by assumption | rewrite (Rabs_left x) by lra]
  | |- context [Rmax _ _] => unfold Rmax | |- context [Rmin _ _] => unfold Rmin
  | |- context [sign ?x] => let A := fresh in let B := fresh in destruct (Rlt_dec 0 x) as [A | A]; [rewrite (sign_eq_1 x A) |
      destruct (Rlt_dec x 0) as [B | B]; [rewrite (sign_eq_m1 x B) | replace x with 0 by lra; rewrite sign_0]]
  | |- context [if ?d then _ else _] => destruct d
  | H : context [if ?d then _ else _] |- _ => destruct d end.

Ltac plain := match goal with
  | |- True => exact I | H : ?A |- ?A => exact H
  | |- _ ^ 2 >= 0 => apply Rle_ge, pow2_ge_0 | |- sqrt _ >= 0 => apply Rle_ge, sqrt_pos
  | |- _ <> 0 => not_zero | |- _ = _ => first [lra | ring] | |- _ => first [lra | nra] end.
Ltac shown := first [match goal with |- _ = _ => solve [lines; ring] end | plain | equation | solve [lines; first [plain | equation
  | solve [roots; first [plain | equation]] | solve [angles; circles; first [plain | equation]]
  | solve [cases; first [plain | equation | angles; circles; first [plain | equation]]]]]].

(* Each conclusion by a tactic, and those before it at hand. *)
Ltac each by_ := match goal with
  | |- ?A /\ ?B => let H := fresh in assert (H : A) by by_; split; [exact H | each by_]
  | |- _ => by_ end.
Ltac claim := red; intros; pose proof PI_RGT_0; each shown.
