(* The error of the central difference beside the creases of ridges: the claims. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Formulas Fields Creases.
Open Scope R_scope.

(* Across the crease the difference of a half-wave is sin y cos x/x, in units of pi k, its slope is cos y, and the tent is y/x - 1. *)
Lemma beside_the_tent x y : 0 < y <= x -> 0 <= sin y -> 0 <= (1 - cos x) * sin y <= x ^ 3 / 2 /\ Rabs (sin y * cos x / x - cos y - (y / x - 1)) <=
  2 / 3 * x ^ 2.
Proof.
  intros Y S. generalize (cubic_below y ltac:(lra)) (COS_bound y) (COS_bound x) (cosine_from_below y) (cosine_from_below x). intros S1 C C' C2 C2'.
  assert (X2 : y ^ 2 <= x ^ 2) by nra. assert (X3 : y * y ^ 2 <= x * x ^ 2) by (apply Rmult_le_compat; nra).
  assert (F : (1 - cos x) * sin y <= x ^ 2 / 2 * x) by (apply Rmult_le_compat; lra). assert (F0 : 0 <= (1 - cos x) * sin y) by (apply Rmult_le_pos; lra).
  assert (G : 0 <= x * (1 - cos y) <= x ^ 3 / 2) by (split; [apply Rmult_le_pos; lra | nra]). split; [lra|].
  apply Rabs_le. split; apply Rmult_le_reg_l with x; field_simplify; lra.
Qed.
Theorem crease_error_area__tent : Statements.crease_error_area__tent.
Proof.
  intros d e k E K D A B. generalize PI_RGT_0. intro P. assert (Q : PI * k > 0) by nra.
  set (rest := _ / e / (PI * k) - _ - _). set (x := e * PI * k) in *. set (y := d * PI * k) in *.
  assert (Y : 0 < y <= x) by (unfold x, y; split; nra). assert (S0 : 0 <= sin y) by (apply sin_ge_0; unfold x, y in *; nra). destruct (beside_the_tent
    x y Y S0) as [F R].
  generalize (cubic_below y (proj1 Y)) (COS_bound y) (COS_bound x) (cosine_from_below y). intros S C C' C2.
  replace (sin y * cos x / x - cos y - (y / x - 1)) with rest in R by (unfold rest, x, y; field; lra). apply Rabs_le_between in R.
  assert (X : x * rest = x * (1 - cos y) - (y - sin y * cos x)) by (unfold rest, x, y; field; lra).
  replace (x * (2 / 3) * PI ^ 3 * e ^ 2 * k ^ 3 / (PI * k)) with (x * (2 / 3 * x ^ 2)) by (unfold x; field; lra).
  replace (2 / 3 * PI ^ 3 * e ^ 2 * k ^ 3 / (PI * k)) with (2 / 3 * x ^ 2) by (unfold x; field; lra).
  assert (X3 : y * y ^ 2 <= x * x ^ 2) by (apply Rmult_le_compat; nra).
  replace (PI * d * k) with y by (unfold y; ring). replace (PI * e * k) with x by (unfold x; ring). clearbody rest. repeat split; first [lra | nra].
Qed.
Theorem crease_error_area__tents : Statements.crease_error_area__tents.
Proof.
  intros d e k E K. generalize PI_RGT_0. intro P. assert (D : is_derive (fun d : R => (d - e) ^ 3 / (3 * e ^ 2)) d ((d - e) ^ 2 / e ^ 2)) by
    (auto_derive; [trivial | field; lra]).
  rewrite (is_derive_unique _ _ _ D). split; [nra | split; [eexists; exact D|]]. repeat split; try nra; field; lra.
Qed.
Theorem crease_error_area__mean_of_a_square : Statements.crease_error_area__mean_of_a_square.
Proof.
  intros k v K Z. generalize PI_RGT_0. intro P.
  assert (D : is_derive (fun v : R => v / 2 - 1 / 4 / (PI * k) * sin (v * 2 * PI * k)) v (sin (v * PI * k) ^ 2)).
  { auto_derive; [trivial|]. replace (v * 2 * PI * k) with (2 * (v * PI * k)) by ring. rewrite cos_2a_sin. field. lra. }
  rewrite (is_derive_unique _ _ _ D). split; [nra | split; [eexists; exact D | split; [reflexivity|]]].
  replace (1 * 2 * PI * k) with (2 * (PI * k)) by ring. replace (0 * 2 * PI * k) with 0 by ring. rewrite sin_2a, Z, sin_0. field. lra.
Qed.
Lemma mean_square k n e total : k >= 1 -> n >= 0 -> e > 0 -> total = (PI * k) ^ 2 * n * (e / 3) -> let constant := 1 / 3 * sqrt 3 * PI * k * sqrt
  (e * n) in e * n >= 0 /\ total >= 0 /\ PI * k > 0 /\ constant >= 0 /\ total = constant ^ 2 /\ sqrt total = constant.
Proof.
  intros K N E T c. generalize PI_RGT_0 (sqrt_pos 3) (sqrt_pos (e * n)). intros P S3 S. assert (A : e * n >= 0) by nra. assert (Q : PI * k > 0) by nra.
  assert (C : c >= 0) by (unfold c; apply Rle_ge, Rmult_le_pos; [assert (0 <= sqrt 3 * (PI * k)) by (apply Rmult_le_pos; lra); lra | lra]).
  assert (V : total = c ^ 2).
  { rewrite T. unfold c. transitivity (1 / 9 * (sqrt 3 ^ 2) * (PI * k) ^ 2 * sqrt (e * n) ^ 2); [rewrite !pow2_sqrt by lra; field | field]. }
  repeat split; trivial; [rewrite V; nra | rewrite V; apply sqrt_pow2; lra].
Qed.
Ltac of_mean_square k n e total := destruct (mean_square k n e total) as (A & B & C & D & F & G); try lra; [field; lra|];
  rewrite G; repeat split; try assumption; try lra; nra.
Theorem crease_error_area__in_u : Statements.crease_error_area__in_u.
Proof.
  intros e k K E. of_mean_square k k e (1 / 2 * 2 * k * (PI * k) ^ 2 * ((e - e) ^ 3 / (3 * e ^ 2) - 1 / 3 / e ^ 2 * (0 - e) ^ 3)).
Qed.
Theorem crease_error_area__in_v : Statements.crease_error_area__in_v.
Proof.
  intros e k K E. of_mean_square k (k - 1) e (1 / 2 * 2 * (PI * k) ^ 2 * (k - 1) * ((e - e) ^ 3 / (3 * e ^ 2) - 1 / 3 / e ^ 2 * (0 - e) ^ 3)).
Qed.
