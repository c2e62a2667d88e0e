(* Float64, from Flocq: 53 digits, the smallest exponent -1074, to the nearest with ties to even; no largest exponent. *)

From Coq Require Import Reals Lra.
From Flocq Require Import Core Relative.
Open Scope R_scope.

Definition float64 (x : R) : Prop := generic_format radix2 (FLT_exp (-1074) 53) x.
Definition rounded (x : R) : R := round radix2 (FLT_exp (-1074) 53) (Znearest (fun n => negb (Z.even n))) x.
Definition rint (x : R) : R := IZR (Znearest (fun n => negb (Z.even n)) x).
Definition whole_below (x : R) : R := IZR (Zfloor x).
Definition power_of_two (whole : R) : R := bpow radix2 (Zfloor whole).
(* Of a normal number: 2 to this power is the largest that is not above its size. *)
Definition binary_exponent (x : R) : R := IZR (mag radix2 x - 1).
Definition unit_roundoff : R := / 2 * bpow radix2 (-53 + 1).

Global Instance precision : Prec_gt_0 53.
Proof. reflexivity. Qed.

Lemma rounded_opp (x : R) : rounded (- x) = - rounded x.
Proof. unfold rounded. apply (round_NE_opp radix2 (FLT_exp (-1074) 53)). Qed.
