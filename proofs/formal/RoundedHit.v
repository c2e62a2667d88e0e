(* Where a ray hits sphere B, as float64 carries it out. *)

From Coq Require Import Reals Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Float Float64 RoundedHalfTurns Rounding RoundedGradient EnclosingRules RoundedColour.
Open Scope R_scope.

(* xh stands for x, of a size of at most s, and is within e units of 2^-53 s of it. *)
Definition near (s e xh x : R) := Rabs x <= s /\ Rabs (xh - x) <= e * unit53 * s.
Lemma near_itself s x : 0 <= s -> x * x <= s * s -> near s 0 x x.
Proof. split; [apply within_length; assumption | rewrite !Rmult_0_l; apply no_error]. Qed.
Lemma near_resized s t e f xh x : near s e xh x -> Rabs x <= t -> e * s <= f * t -> near t f xh x.
Proof. intros [_ E] B L. split; in_units. Qed.
Lemma near_opposite s e xh x : near s e xh x -> near s e (- xh) (- x).
Proof. intros [B E]. split; [rewrite Rabs_Ropp | apply of_opposites]; assumption. Qed.
Lemma near_rounding s e xh x : 1 / 2 ^ 100 <= s -> near s e xh x -> near s (e * (1 + unit53) + 1001/1000) (rounded xh) x.
Proof.
  intros L [B E]. split; [exact B|]. generalize (size _ _ _ _ B E) (rounding_error xh) underflow_is_small. intros X O T.
  replace (rounded xh - x) with ((rounded xh - xh) + (xh - x)) by ring. at_most_by Rabs_triang. in_units.
Qed.
Lemma near_product s e ah a t f bh b : near s e ah a -> near t f bh b -> near (s * t) (e + f + e * f * unit53) (ah * bh) (a * b).
Proof.
  intros [A E] [B F]. pose proof size _ _ _ _ B F as S. split; [rewrite Rabs_mult; auto using Rmult_le_compat, Rabs_pos|].
  replace (ah * bh - a * b) with ((ah - a) * bh + a * (bh - b)) by ring. at_most_by Rabs_triang. rewrite !Rabs_mult.
  generalize (Rmult_le_compat _ _ _ _ (Rabs_pos _) (Rabs_pos _) E S) (Rmult_le_compat _ _ _ _ (Rabs_pos _) (Rabs_pos _) A F). lra.
Qed.
Lemma near_sum s e ah a f bh b : near s e ah a -> near s f bh b -> Rabs (a + b) <= s -> near s (e + f) (ah + bh) (a + b).
Proof. intros [_ E] [_ F] B. split; [exact B|]. replace (_ - _) with ((ah - a) + (bh - b)) by ring. at_most_by Rabs_triang. lra. Qed.
Lemma along a b c d p q : 0 <= p -> 0 <= q -> a * a + b * b <= q * q -> c * c + d * d <= p * p -> Rabs (a * c + b * d) <= q * p.
Proof. intros. apply within_length; [nra | generalize (Rle_0_sqr (a * d - b * c)); unfold Rsqr; nra]. Qed.
Lemma root_moved_less ah a m : 0 <= ah -> 0 <= m <= a / 1000 -> Rabs (ah * ah - a * a) <= 1999/1000 * a * m -> Rabs (ah - a) <= m.
Proof. intros P M E. both_ways E. apply Rabs_le. split; nra. Qed.
Lemma near_square p r z e kh k : near (z * r * p) e kh k -> Rabs k <= p * r -> near (r * r * (p * p)) (z * e + z * e + z * e * (z * e) * unit53)
  (kh * kh) (k * k).
Proof.
  intros [_ E] B. replace (r * r * (p * p)) with (p * r * (p * r)) by ring. apply near_product; split; lra.
Qed.
Lemma near_quotient t ch wh w : 0 < t -> 0 < w -> near (t * w) 28 ch (t * w) -> near w 82 wh w -> near t (1101/10) (ch / wh) t.
Proof.
  intros T W [_ X] [_ Y]. assert (L : w * 9999 / 10000 <= wh) by (both_ways Y; in_units).
  split; [rewrite Rabs_pos_eq; lra|]. replace (ch / wh - t) with (((ch - t * w) - t * (wh - w)) / wh) by (field; lra). apply over_length; [lra|].
    at_most_by Rabs_triang. rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq t) by lra.
  apply (Rmult_le_compat_l t) in Y, L; unfold unit53 in *; nra.
Qed.
Lemma root_of v : 0 <= v -> exists p, 0 <= p /\ p * p = v.
Proof. exists (sqrt v). auto using sqrt_pos, sqrt_sqrt. Qed.
(* Follows a line from its result, whose size is known, to its inputs. *)
Ltac follow := lazymatch goal with
  | |- near _ _ (rounded _) _ => eapply near_rounding; [interval | follow]
  | |- near _ _ (- _) _ => apply near_opposite; follow
  | known : 2 <= ?z <= _ |- near _ _ (rounded ?k * rounded ?k) _ => eapply (near_square _ _ z); [follow | apply within_length; lra]
  | |- near _ _ (_ * _) _ => eapply near_product; follow
  | |- near _ _ ?x ?x => apply near_itself; lra
  | |- _ => eapply near_sum; [follow | follow | first [assumption | apply Rabs_le; lra | rewrite ?Ropp_mult_distr_l; apply along; lra]] end.
Theorem colour_accuracy__hit : Statements.colour_accuracy__hit.
Proof.
  intros x y e cx cy cz r on _ _ _ _ _ _ _ _ P1 P2 R1 _ M1 M2 D B On. hit_of_b_float64.lines; hit_of_b.lines. rewrite <- !Rsqr_pow2 in *. unfold
    Rsqr in *. set (h := e - cz) in *.
  rewrite (Rmult_comm x h), (Rmult_comm y h), (Rmult_comm e h) in *. replace (r + e - cz) with (r + h) by (unfold h; ring). rewrite (Rplus_comm _
    (sqrt _)).
  lazymatch goal with |- context [rounded (?computed / rounded (rounded (sqrt (Rmax 0 ?under)) + ?along))] => set (ch := computed); set (dh := under);
    set (bh := along) end.
  lazymatch goal with |- context [?exact / (sqrt (Rmax 0 ?under) + ?along)] => set (c := exact) in *; set (d := under) in *; set (b := along) in * end.
  generalize (Rle_0_sqr x) (Rle_0_sqr y) (Rle_0_sqr e) (Rle_0_sqr cx) (Rle_0_sqr cy) (Rle_0_sqr h) (Rle_0_sqr r) (Rle_0_sqr (cx * e - h * x))
    (Rle_0_sqr (cx * y - cy * x)) (Rle_0_sqr (h * y - cy * e)). unfold Rsqr. intros.
  destruct (root_of (e * e + x * x + y * y)) as (p & p0 & P); [lra|]. destruct (root_of (cx * cx + cy * cy + h * h)) as (q & q0 & Q); [lra|].
  assert (p1 : 1 / 2 ^ 20 <= p <= 2 ^ 50) by (split; apply less_of_squares; lra). assert (q1 : 2 * r <= q <= 2 ^ 20 * r) by (split; apply
    less_of_squares; lra).
  set (z := q / r). assert (Z : q = z * r) by (unfold z; field; lra). clearbody z. subst q. assert (z0 : 2 <= z <= 2 ^ 20) by (split; apply
    Rmult_le_reg_r with r; lra).
  pose proof f_equal (Rmult (r * r)) P as A. assert (I : z * r * p * (z * r * p) = b * b + r * r * (p * p) - d) by (transitivity (z * r * (z * r) * (p *
    p)); [ring | rewrite P, Q; unfold b, d; ring]).
  pose proof Rmult_le_pos p r p0 ltac:(lra) as pr. assert (qp : 1 / 2 ^ 90 <= z * r * p) by interval.
  assert (T : 0 < r * r * (p * p)) by interval.
  assert (r2 : 4 * (r * r) <= z * r * (z * r)) by nra. assert (Hs : - (z * r) <= h <= z * r) by (apply Rabs_le_between, within_length; lra).
  assert (Bs : Rabs b <= z * r * p) by (apply within_length; unfold d in I; lra).
  eassert (Bn : near (z * r * p) _ bh b) by (unfold bh, b; follow).
  eassert (Cn : near (3/2 * (z * r) * (3/2 * (z * r))) _ ch c) by (unfold ch, c; follow).
  eassert (Dn : near (r * r * (p * p)) _ dh d) by (unfold dh, d in *; follow).
  assert (Bl : 866/1000 * (z * r * p) <= b) by (apply less_of_squares; nra). assert (dr : r * r * (p * p) / 16 <= d <= r * r * (p * p)) by (unfold d
    in *; lra). assert (Cl : 3/4 * (z * r * (z * r)) <= c) by (unfold c; lra).
  assert (L : Rabs (dh - d) <= 31 * z * unit53 * (r * r * (p * p))) by (eapply Rle_trans; [apply Dn | apply Rmult_le_compat_r; [lra | unfold unit53;
    nra]]). assert (d0 : 0 <= dh).
  { assert (31 * z * unit53 * (r * r * (p * p)) <= 1 / 16 * (r * r * (p * p))) by (apply Rmult_le_compat_r; [|unfold unit53]; lra). both_ways L. lra. }
  generalize (sqrt_pos d) (sqrt_sqrt d ltac:(lra)). rewrite !Rmax_right by lra. set (s := sqrt d). intros s0 Sd. assert (s1 : p * r / 4 <= s <= z * r
    * p) by (split; apply less_of_squares; nra).
  assert (Rn : near (z * r * p) 63 (sqrt dh) s).
  { split; [rewrite Rabs_pos_eq; lra|]. apply root_moved_less; [apply sqrt_pos | unfold unit53; nra |]. rewrite sqrt_sqrt, Sd by easy. unfold unit53
    in *; nra. }
  remember (s + b) as w eqn:W. assert (w1 : 866/1000 * (z * r * p) <= w <= 2 * (z * r * p)) by (both_ways Bs; lra).
  apply near_rounding in Rn; [|interval]. apply (near_resized _ w _ (7395/100)) in Rn. apply (near_resized _ w _ 7) in Bn. apply (near_resized _ c _
    28) in Cn. all: try in_units; try (apply Rabs_le; lra).
  pose proof proj2 Bn as Bh. both_ways Bh. repeat destruct both as [_|[[N|N]|N]]; try in_units.
  assert (q2 : 0 <= z * r * (z * r - p / 2 ^ 80)) by (apply Rmult_le_pos; interval).
  assert (t0 : 1 / 2 ^ 100 <= c / w) by (apply (Rle_div_r (1 / 2 ^ 100)); lra).
  assert (E : c = c / w * w) by (field; lra). replace (_ / _ * c / w) with (112 * unit53 * (c / w)) by (unfold unit53; field; lra). set (t := c / w)
    in *. rewrite E in Cn.
  eapply Rle_trans; [apply (near_rounding _ _ _ _ t0 (near_quotient t ch (rounded (rounded (sqrt dh) + bh)) w ltac:(lra) ltac:(lra) Cn ltac:(rewrite W
    in *; eapply (near_resized (s + b)); [apply near_rounding; [|apply near_sum; [exact Rn | exact Bn|]] | |]; try in_units; apply Rabs_le; lra))) |
    in_units].
Qed.
