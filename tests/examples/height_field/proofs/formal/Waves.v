From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Formal Require Import Preliminaries Formulas.
Open Scope R_scope.

(* The printed slopes are the height's derivatives, and k_v h_u = k_u h_v. *)
Theorem waves_climb_one_way__direction (u v k_u k_v : R) :
  is_derive (fun u => height_waves.h u v k_u k_v) u (gradient_waves.h_u u v k_u k_v) /\
  is_derive (fun v => height_waves.h u v k_u k_v) v (gradient_waves.h_v u v k_u k_v) /\
  k_v * gradient_waves.h_u u v k_u k_v = k_u * gradient_waves.h_v u v k_u k_v.
Proof. unfold height_waves.h, gradient_waves.h_u, gradient_waves.h_v. split; [|split]; try ring; auto_derive; trivial; ring. Qed.
Theorem waves_climb_one_way__direction__false : ~ forall k_u k_v, k_u * gradient_waves.h_u 0 0 k_u k_v = k_v * gradient_waves.h_v 0 0 k_u k_v.
Proof. intro H. generalize (H 1 0) PI_RGT_0. unfold gradient_waves.h_u, gradient_waves.h_v. rewrite !Rmult_0_r, Rplus_0_r, Rmult_0_r, cos_0. lra. Qed.
