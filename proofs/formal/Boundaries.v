(* What the shader's own recorded program lets a picture's boundaries depend on: not on the bump, nor on what colours it. *)

From Coq Require Import List Arith.
From Formal Require Import Programs RecordedPixel.
Import ListNotations.

(* The height field, its gradient and its method, wave numbers, step, amplitude, and kind of bump; then colours and materials, too. *)
Definition bump_inputs : list nat := recorded_pixel.h_u ++ recorded_pixel.h_v ++ recorded_pixel.ku ++ recorded_pixel.kv ++ recorded_pixel.beta
  ++ recorded_pixel.eps ++ recorded_pixel.way ++ recorded_pixel.bump.
Definition color_inputs : list nat := recorded_pixel.model ++ recorded_pixel.ka ++ recorded_pixel.kd ++ recorded_pixel.ks ++ recorded_pixel.power
  ++ recorded_pixel.albedo_a ++ recorded_pixel.albedo_b ++ recorded_pixel.ambient_light ++ recorded_pixel.ambient ++ recorded_pixel.floor_light
  ++ recorded_pixel.floor_dark ++ recorded_pixel.light_color ++ recorded_pixel.light_glows.
Definition pixel_without : list nat -> list nat -> Prop := independent recorded_pixel.operation recorded_pixel.pixel recorded_pixel.inputs.

(* The chamber code has the surface, a bit for each light that another body hides, and the checker's square. *)
Theorem bump_moves_no_boundary__program : pixel_without bump_inputs recorded_pixel.code.
Proof. apply independence. vm_compute. reflexivity. Qed.
Theorem edges_add_nothing__program : pixel_without (bump_inputs ++ color_inputs) recorded_pixel.code.
Proof. apply independence. vm_compute. reflexivity. Qed.

(* False variants: a chamber that is chosen by whether N' is lower than the eye, among the boundaries; and what the eye's height moves. *)
Definition by_normal : program recorded_pixel.operation := (recorded_pixel.Where (recorded_pixel.Lt 0 1),
  map (fun places => hd 0 places) [recorded_pixel.code; recorded_pixel.ground; recorded_pixel.normal; recorded_pixel.eye]) :: nil.
Theorem bump_moves_no_boundary__program__false :
  ~ independent recorded_pixel.operation (recorded_pixel.pixel ++ by_normal) recorded_pixel.inputs bump_inputs
      (recorded_pixel.inputs + length recorded_pixel.pixel :: recorded_pixel.code).
Proof. apply dependence. vm_compute. discriminate. Qed.
Theorem edges_add_nothing__program__false : ~ pixel_without (bump_inputs ++ color_inputs ++ recorded_pixel.eye) recorded_pixel.code.
Proof. apply dependence. vm_compute. discriminate. Qed.
