(* What the printed formulas need and Coq's library does not have. Written by hand, and trusted. *)

From Coq Require Import Reals Sumbool.
Open Scope R_scope.

(* Two decisions at once, for the conditions of a selection. *)
Definition both {A B C D : Prop} (p : {A} + {B}) (q : {C} + {D}) : {A /\ C} + {B \/ D} := sumbool_and A B C D p q.
Definition either {A B C D : Prop} (p : {A} + {B}) (q : {C} + {D}) : {A \/ C} + {B /\ D} := sumbool_or A B C D p q.

Definition differ (x y : R) : {x <> y} + {x = y} := sumbool_not _ _ (Req_EM_T x y).

(* A power with any exponent, of a base that is not negative: Coq's own is 1 at the base 0. *)
Definition power (base exponent : R) : R := if Rlt_dec 0 base then Rpower base exponent else 0.

(* The angle of the point (x, y) of the plane: in (-PI, PI], and 0 at the origin. *)
Definition atan2 (y x : R) : R :=
  if Rlt_dec 0 x then atan (y / x)
  else if Rlt_dec x 0 then (if Rle_dec 0 y then atan (y / x) + PI else atan (y / x) - PI)
  else if Rlt_dec 0 y then PI / 2
  else if Rlt_dec y 0 then - PI / 2
  else 0.

Definition atan2pi (y x : R) : R := atan2 y x / PI.
