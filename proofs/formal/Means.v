(* A mean of bounded samples. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* One more sample, with the share w, keeps the mean within what bounds each, *)
Lemma mean_keeps_the_bound_one_more b m x w : 0 <= w <= 1 -> Rabs m <= b -> Rabs x <= b -> Rabs (m + w * (x - m)) <= b.
Proof. intros W M X. apply Rabs_le_between in M. apply Rabs_le_between in X. apply Rabs_le. split; nra. Qed.
(* so it does for the mean of any number of them: each comes with the share 1 / (n + 1). *)
Theorem mean_keeps_the_bound__any_number b x n : (forall i, Rabs (x i) <= b) -> Rabs (sum_f_R0 x n / INR (S n)) <= b.
Proof.
  intro B. induction n as [|n I]; [simpl; rewrite Rdiv_1; apply B|].
  assert (P : 0 < INR (S n)) by apply lt_0_INR, Nat.lt_0_succ. rewrite tech5, (S_INR (S n)). set (k := INR (S n)) in *.
  replace (_ / _) with (sum_f_R0 x n / k + / (k + 1) * (x (S n) - sum_f_R0 x n / k)) by (field; lra).
  apply mean_keeps_the_bound_one_more; [split|exact I|apply B].
  - left. apply Rinv_0_lt_compat. lra.
  - rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
Qed.
Theorem mean_keeps_the_bound__any_number__point : exists (b : R) (x : nat -> R), forall i, Rabs (x i) <= b.
Proof. exists 1, (fun _ => 1). intros _. rewrite Rabs_R1. lra. Qed.
(* It does not within half of it. *)
Theorem mean_keeps_the_bound__any_number__false : ~ forall b x n, (forall i, Rabs (x i) <= b) -> Rabs (sum_f_R0 x n / INR (S n)) <= b / 2.
Proof.
  intro H. pose proof H 1 (fun _ => 1) O (fun _ => Req_le _ _ Rabs_R1) as K. simpl in K. rewrite Rabs_pos_eq in K; lra.
Qed.
