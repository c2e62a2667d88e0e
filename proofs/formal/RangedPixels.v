(* A checker that runs a recorded program on ranges: pixels of a range of scenes, and what it certifies of them. *)

From Coq Require Import Reals Lra Lia ZArith NArith List Bool FMapPositive.
From Flocq Require Import Core Operations.
From Formal Require Import Preliminaries Float Float64 Programs RecordedPixel EnclosingRules EnclosingOperations EnclosingPrograms EnclosingPixel
  Ranges.
Open Scope R_scope.
Import ListNotations.

(* A float64 number, and the exact one that it stands for: it is meant, and lies in a range that is found. *)
Definition two_numbers : Type := R * exact_number.
Definition two_zeros : two_numbers := (0, zero_meant).
Definition shows (c : option range) (n : two_numbers) := match c with Some c => fst (snd n) /\ lies c (fst n) (snd (snd n)) | None => True end.
Definition given_at (values : list two_numbers) (places : list N) := taken two_numbers two_zeros values (map N.to_nat places).
Definition two_machines : machine operation two_numbers := fun o given => (in_float64 o (map fst given), exact_machine o (map snd given)).
(* A constant is within half of its last digit of what it stands for. *)
Definition nearest_constants (constants : Z -> Z -> R * R) := forall m e, Rabs (literal m e - fst (constants m e)) <= bpow radix2 (SpecFloat.Zdigits2
  m + e -
  54).

(* Whether a number is less than another, or no more. *)
Definition under (compare : dyadic -> dyadic -> bool) (c d : range) : bool :=
  match c, d with Range _ h e, Range a _ f => compare (Fplus h e) (Fminus a f) end.
Fixpoint test_found (c : test) (given : list (option range)) : option bool :=
  match c with
  | Less i j => match nth i given None, nth j given None with
    | Some c, Some d => if under less c d then Some true else if under no_more d c then Some false else None
    | _, _ => None
    end
  | Same i j => match nth i given None, nth j given None with
    | Some c, Some d => if under no_more c d && under no_more d c then Some true else if under less c d || under less d c then Some false else None
    | _, _ => None
    end
  | Not c => option_map negb (test_found c given)
  | Both c d => match test_found c given, test_found d given with
    | Some false, _ | _, Some false => Some false
    | Some true, Some true => Some true
    | _, _ => None
    end
  end.
(* The lesser or the larger of two numbers, where it is open which it is. *)
Definition clipped (c : recorded_pixel.condition) (places : list N) (given : list (option range)) : option range :=
  match c, places, given with
  | recorded_pixel.Lt 0 1, [p; q; r; s], Some (Range l h e) :: Some (Range a b f) :: _ =>
    let both choose := Some (Range (choose l a) (choose h b) (larger e f)) in
    if ((p =? r) && (q =? s))%N then both smaller else if ((p =? s) && (q =? r))%N then both larger else None
  | _, _, _ => None
  end.
Definition rule_found (o : recorded_pixel.operation) (given : list (option range)) : option range :=
  match o, given with
  | recorded_pixel.Literal m e, [] => Some (point (Float radix2 m e))
  | recorded_pixel.Infinite, [] => Some (point (two_to 1023))
  | recorded_pixel.Constant m e, [] => Some (Range (Float radix2 m e) (Float radix2 m e) (two_to (SpecFloat.Zdigits2 m + e - 54)))
  | recorded_pixel.Neg, [Some c] => Some (negated c)
  | recorded_pixel.Add, [Some c; Some d] => Some (sum_range c d)
  | recorded_pixel.Sub, [Some c; Some d] => Some (sum_range c (negated d))
  | recorded_pixel.Mul, [Some c; Some d] => Some (product_range c d)
  | recorded_pixel.Truediv, [Some c; Some d] => quotient_range c d
  | recorded_pixel.Sqrt, [Some c] => root_range c
  | recorded_pixel.Floor, [Some c] => floor_range c
  | _, _ => None
  end.
Definition found_by (o : recorded_pixel.operation) (places : list N) (given : list (option range)) : option range :=
  match o, given with
  | recorded_pixel.Where c, x :: y :: compared => match test_found (test_of c) compared with
    | Some holds => if holds then x else y
    | None => clipped c places given
    end
  | _, _ => rule_found o given
  end.

Lemma under_means c d v x w y : lies c v x -> lies d w y -> (under less c d = true -> v < w /\ x < y) /\ (under no_more c d = true -> v <= w /\ x <=
  y).
Proof.
  destruct c as [l h e], d as [a b f]. intros [B D] [C F]. pose proof Rabs_pos (v - x). pose proof Rabs_pos (w - y). apply Rabs_le_inv in D, F. unfold
    under.
  split; intro L; [apply is_less in L | apply is_no_more in L]; rewrite F2R_plus, F2R_minus in L; lra.
Qed.
Lemma nth_shows given numbers i : Forall2 shows given numbers -> shows (nth i given None) (nth i numbers two_zeros).
Proof. intro A. revert i. induction A as [|c n given numbers S _ IH]; intros [|i]; try exact I; [exact S | apply IH]. Qed.
Lemma decided_shows given numbers c : Forall2 shows given numbers -> forall b, test_found c given = Some b -> holds c (map fst numbers) = b /\ holds c
  (map snd (map snd numbers)) = b.
Proof.
  intro A. assert (V : forall i, nth i (map fst numbers) 0 = fst (nth i numbers two_zeros)) by (intro i; apply (map_nth fst numbers two_zeros)).
  assert (U : forall i, nth i (map snd (map snd numbers)) 0 = snd (snd (nth i numbers two_zeros))) by (intro i; rewrite map_map; apply (map_nth (fun n
    : two_numbers => snd (snd n)) numbers two_zeros)).
  induction c as [i j | i j | c IH | c IHc d IHd]; intro b; cbn [test_found holds].
  1, 2: rewrite !U, !V; pose proof nth_shows _ _ i A as I; pose proof nth_shows _ _ j A as J; destruct (nth i given _) as [c|], (nth j given _) as
    [d|]; try discriminate; destruct I as [_ I], J as [_ J]; destruct (under_means _ _ _ _ _ _ I J) as [L M], (under_means _ _ _ _ _ _ J I) as [L'
    M']; destruct (under less c d), (under no_more d c), (under no_more c d), (under less d c); cbn [andb orb]; try discriminate; intros [= <-]; try
    specialize (L eq_refl); try specialize (M eq_refl); try specialize (L' eq_refl); try specialize (M' eq_refl); split; (destruct Rlt_dec || destruct
    Req_EM_T); reflexivity || lra.
  - destruct (test_found c given) as [h|]; [|discriminate]. intros [= <-]. destruct (IH h eq_refl) as [-> ->]. split; reflexivity.
  - destruct (test_found c given) as [[]|], (test_found d given) as [[]|]; try discriminate; intros [= <-]; try destruct (IHc _ eq_refl) as [-> ->];
    try destruct (IHd _ eq_refl) as [-> ->]; rewrite ?andb_false_r; split; reflexivity.
Qed.
Lemma lesser_lies l h e a b f v x w y : lies (Range l h e) v x -> lies (Range a b f) w y -> lies (Range (smaller l a) (smaller h b) (larger e f)) (if
  Rlt_dec v w then v else w) (if Rlt_dec x y then x else y).
Proof. unfold lies. intros [B D] [C F]. repeat destruct Rlt_dec; ends. Qed.
Lemma larger_lies l h e a b f v x w y : lies (Range l h e) v x -> lies (Range a b f) w y -> lies (Range (larger l a) (larger h b) (larger e f)) (if
  Rlt_dec w v then v else w) (if Rlt_dec y x then x else y).
Proof. unfold lies. intros [B D] [C F]. repeat destruct Rlt_dec; ends. Qed.
Lemma clipped_shows constants c places given values : Forall2 shows given (given_at values places) -> shows (clipped c places given) (two_machines
  (operation_of constants (recorded_pixel.Where c)) (given_at values places)).
Proof.
  intro A. unfold clipped. destruct c as [[|?] [|[|?]]| | | | | | ]; try exact I. destruct places as [|p [|q [|r [|s [|]]]]]; try exact I. cbn
    [given_at map taken] in A.
  inversion A as [|c n g m X A1]; subst. destruct c as [[l h e]|]; [|exact I]. inversion A1 as [|d n g' m Y A2]; subst. destruct d as [[a b f]|];
    [|exact I].
  clear A A1 A2. cbn [given_at map taken]. cbv zeta. destruct ((p =? r) && (q =? s))%N eqn:E; [|destruct ((p =? s) && (q =? r))%N eqn:F; [clear E;
    rename F into E | exact I]]; apply andb_prop in E; destruct E as [<-%N.eqb_eq <-%N.eqb_eq]; destruct (nth (N.to_nat p) _ _) as [v [P x]], (nth
    (N.to_nat q) _ _) as [w [Q y]]; destruct X as [X1 X], Y as [Y1 Y]; [pose proof lesser_lies _ _ _ _ _ _ _ _ _ _ X Y as K | pose proof larger_lies _
    _ _ _ _ _ _ _ _ _ X Y as K]; revert K; unfold two_machines, exact_machine; cbn [operation_of test_of map nth in_float64 meant exactly holds shows
    fst snd] in *; repeat destruct Rlt_dec; intro K; split; assumption.
Qed.
Lemma rule_shows constants o given numbers : nearest_constants constants -> Forall2 shows given numbers -> shows (rule_found o given) (two_machines
  (operation_of constants o) numbers).
Proof.
  intros N A. destruct o; try exact I; destruct A as [|[c|] [v [P x]] g n X A]; try exact I; try (destruct A as [|[d|] [w [Q y]] g n Y A]; try exact
    I); try (destruct A; try exact I); cbn [rule_found] in *; try (destruct X as [X1 X]); try (destruct Y as [Y1 Y]).
  all: cbn [two_machines operation_of exact_machine meant exactly in_float64 map fst snd] in *.
  - split; [constructor | apply point_lies].
  - split; [constructor | apply (point_lies (two_to 1023))].
  - split; [constructor|]. split; [split; apply Rle_refl | rewrite two_to_is; apply N].
  - split; [repeat constructor; assumption | apply negated_lies, X].
  - split; [repeat constructor; assumption | apply sum_lies; assumption].
  - split; [repeat constructor; assumption | apply sum_lies; [|apply negated_lies]; assumption].
  - split; [repeat constructor; assumption | apply product_lies; assumption].
  - destruct (quotient_range c d) as [r|] eqn:H; [|exact I]. destruct (quotient_lies _ _ _ _ _ _ _ X Y H). repeat split; assumption.
  - destruct (root_range c) as [r|] eqn:H; [|exact I]. split; [repeat constructor; assumption | exact (root_lies _ _ _ _ X H)].
  - destruct (floor_range c) as [r|] eqn:H; [|exact I]. split; [repeat constructor; assumption | exact (floor_lies _ _ _ _ X H)].
Qed.
Lemma line_shows constants o places given values : nearest_constants constants -> Forall2 shows given (given_at values places) -> shows (found_by o
  places given) (two_machines (operation_of constants o) (given_at values places)).
Proof.
  intros N A. pose proof rule_shows constants o _ _ N A as Rule. destruct o; try exact Rule. clear Rule. pose proof clipped_shows constants c _ _ _ A
    as Clip. revert A Clip. generalize (given_at values places). intros numbers A. cbn [found_by]. destruct A as [|x n g m X A]; [intros _; exact I|].
    destruct A as [|y o g m Y A]; [intros _; exact I|]. destruct (test_found _ g) as [b|] eqn:T; [|trivial]. intros _.
  destruct (decided_shows _ _ _ A _ T) as [V W]. unfold two_machines, exact_machine. cbn [operation_of in_float64 meant exactly map shows fst snd].
    rewrite V, W. destruct b; assumption.
Qed.

(* What is found is kept by its place, from 1 on. *)
Definition found_at (m : PositiveMap.t range) (places : list N) : list (option range) := map (fun place => PositiveMap.find (N.succ_pos place) m)
  places.
Definition takes_its_places (o : recorded_pixel.operation) : bool := match o with recorded_pixel.Sinpi | recorded_pixel.Cospi => false | _ => true
  end.
(* The lines that some outputs need, and what is found of these. *)
Fixpoint wanted_by (lines : list (recorded_pixel.operation * list N)) (place : N) (outputs : PositiveMap.t unit) : PositiveMap.t unit :=
  match lines with
  | [] => outputs
  | (_, places) :: rest =>
    let wanted := wanted_by rest (N.succ place) outputs in
    if PositiveMap.mem (N.succ_pos place) wanted then fold_left (fun others one => PositiveMap.add (N.succ_pos one) tt others) places wanted else
      wanted
  end.
Definition kept_at (place : N) (c : option range) (m : PositiveMap.t range) : PositiveMap.t range :=
  match c with Some c => PositiveMap.add (N.succ_pos place) c m | None => m end.
Fixpoint run_found (wanted : PositiveMap.t unit) (lines : list (recorded_pixel.operation * list N)) (place : N) (m : PositiveMap.t range) :
  PositiveMap.t range :=
  match lines with
  | [] => m
  | (o, places) :: rest =>
    let c := if takes_its_places o && PositiveMap.mem (N.succ_pos place) wanted then found_by o places (found_at m places) else None in
    run_found wanted rest (N.succ place) (kept_at place c m)
  end.
Fixpoint with_inputs (inputs : list range) (place : N) (m : PositiveMap.t range) : PositiveMap.t range :=
  match inputs with
  | [] => m
  | c :: rest => with_inputs rest (N.succ place) (kept_at place (Some c) m)
  end.

Definition stored (m : PositiveMap.t range) (values : list two_numbers) := forall place c, PositiveMap.find (N.succ_pos place) m = Some c -> (N.to_nat
  place < length values)%nat /\ shows (Some c) (nth (N.to_nat place) values two_zeros).
Lemma stored_next m values place c n : length values = N.to_nat place -> shows c n -> stored m values -> stored (kept_at place c m) (values ++ n ::
  nil).
Proof.
  intros L C S other d F. rewrite app_length. destruct (N.eq_dec other place) as [->|D].
  - destruct c as [c|]; cbn [kept_at] in F; [|destruct (S _ _ F); lia]. rewrite PositiveMap.gss in F. injection F as <-. rewrite app_nth2, L,
    Nat.sub_diag by lia. split; [cbn; lia | exact C].
  - assert (G : PositiveMap.find (N.succ_pos other) m = Some d). { destruct c; [|exact F]. cbn [kept_at] in F. rewrite PositiveMap.gso in F; [exact
    F|]. intro E. apply D. rewrite <- (N.pos_pred_succ other), E. apply N.pos_pred_succ. } destruct (S _ _ G). rewrite app_nth1 by assumption. split;
    [lia | assumption].
Qed.
Lemma found_show m values places : stored m values -> Forall2 shows (found_at m places) (given_at values places).
Proof. intro S. induction places as [|place places IH]; constructor; [|exact IH]. destruct (PositiveMap.find _ m) eqn:F; [apply S, F | exact I]. Qed.
Lemma inputs_are_stored inputs more : Forall2 (fun c => shows (Some c)) inputs more -> forall place m values, length values = N.to_nat place -> stored
  m values -> stored (with_inputs inputs place m) (values ++ more).
Proof.
  intro A. induction A as [|c n inputs more X A IH]; intros place m values L S; cbn [with_inputs]; [rewrite app_nil_r; exact S|].
  replace (values ++ n :: more) with ((values ++ [n]) ++ more) by (rewrite <- app_assoc; reflexivity). apply IH; [rewrite app_length, N2Nat.inj_succ;
    cbn; lia | apply stored_next; assumption].
Qed.
Definition line_of (constants : Z -> Z -> R * R) (line : recorded_pixel.operation * list N) : operation * list nat :=
  (operation_of constants (fst line), places_of (fst line) (map N.to_nat (snd line))).
Lemma run_is_stored constants wanted lines : nearest_constants constants -> forall place m values, length values = N.to_nat place -> stored m values
  -> stored (run_found wanted lines place m) (run operation two_numbers two_machines two_zeros (map (line_of constants) lines) values).
Proof.
  intro N. induction lines as [|[o places] lines IH]; intros place m values L S; [exact S|]. cbn [run_found map]. unfold line_of at 1. cbn [fst snd
    run].
  apply IH; [rewrite app_length, N2Nat.inj_succ; cbn; lia|]. apply stored_next; [exact L | | exact S]. destruct (takes_its_places o && _)%bool eqn:W;
    [|exact I].
  replace (places_of o _) with (map N.to_nat places) by (destruct o; reflexivity || discriminate). apply line_shows; [exact N | apply found_show, S].
Qed.

(* Ten points of the default scene, each in another chamber; and ranges of scenes and of places around them, and on A by each field's slopes, by each
  model. *)
Definition dyadic_of (n : Z * Z) : dyadic := Float radix2 (fst n) (snd n).
Definition range_of (n : recorded_pixel.number) : range := Range (dyadic_of (fst (fst n))) (dyadic_of (snd (fst n))) (dyadic_of (snd n)).
(* What a channel may be off, in units of 1e-14; the places of the channels; and the inputs. *)
Definition boxes : list (Z * (list nat * list recorded_pixel.number)) := map (pair 18%Z) recorded_pixel.points ++ map (pair 100%Z)
  recorded_pixel.ranges.
Definition ranges_in (box : list nat * list recorded_pixel.number) : PositiveMap.t range :=
  let first := N.of_nat (length (snd box)) in let outputs := fold_left (fun others one => PositiveMap.add (N.succ_pos (N.of_nat one)) tt others) (fst
    box)
    (PositiveMap.empty unit) in
  run_found (wanted_by recorded_pixel.lines first outputs) recorded_pixel.lines first (with_inputs (map range_of (snd box)) 0 (PositiveMap.empty
    range)).
Definition range_at (m : PositiveMap.t range) (place : nat) : option range := PositiveMap.find (N.succ_pos (N.of_nat place)) m.
Definition times_1e14 (x : dyadic) : dyadic := Fmult x (Float radix2 (10 ^ 14) 0).
Definition is_within (allowance : Z) (c : option range) : bool := match c with Some (Range _ _ e) => no_more (times_1e14 e) (Float radix2 allowance 0) | None
  => false end.
Definition first_box : list nat * list recorded_pixel.number := hd ([], []) recorded_pixel.points.
Definition second_box : list nat * list recorded_pixel.number := hd ([], []) (tl recorded_pixel.points).
Definition first_color : nat := hd 0%nat recorded_pixel.drawn.
Definition differ_by_more (c d : option range) : bool :=
  match c, d with Some (Range _ h _), Some (Range l _ _) => less (Float radix2 36 0) (times_1e14 (Fminus l h)) | _, _ => false end.
Definition is_range (n : recorded_pixel.number) : bool := match range_of n with Range l h e => no_more l h && no_more dyadic_zero e end.
Definition box_is_within (box : Z * (list nat * list recorded_pixel.number)) : bool :=
  let m := ranges_in (snd box) in forallb (fun place => is_within (fst box) (range_at m place)) (fst (snd box)).
Lemma boxes_are_within : forallb box_is_within boxes && differ_by_more (range_at (ranges_in first_box) first_color) (range_at (ranges_in second_box)
  first_color) && (forallb is_range (snd first_box) && forallb is_range (snd second_box)) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Definition lie_in (box : list recorded_pixel.number) (numbers : list two_numbers) := Forall2 (fun n => shows (Some (range_of n))) box numbers.
Lemma range_is constants box numbers place : nearest_constants constants -> lie_in (snd box) numbers -> shows (range_at (ranges_in box) place) (nth
  place (run operation two_numbers two_machines two_zeros (pixel_of constants) numbers) two_zeros).
Proof.
  intros N A. assert (P : pixel_of constants = map (line_of constants) recorded_pixel.lines) by apply map_map. rewrite P. clear P. unfold range_at,
    ranges_in. cbv zeta. generalize recorded_pixel.lines. intro lines. generalize (wanted_by lines). intro wanted. destruct (PositiveMap.find _ _) as
    [c|] eqn:F; [|exact I].
  assert (L : length numbers = N.to_nat (N.of_nat (length (snd box)))) by (rewrite Nat2N.id; clear - A; unfold lie_in in A; induction A; cbn;
    congruence).
  assert (B : Forall2 (fun c => shows (Some c)) (map range_of (snd box)) numbers) by (clear - A; induction A; constructor; assumption).
  assert (S : stored (with_inputs (map range_of (snd box)) 0 (PositiveMap.empty range)) numbers).
  { apply (inputs_are_stored _ _ B 0 (PositiveMap.empty range) []); [reflexivity|]. intros other d G. rewrite PositiveMap.gempty in G. discriminate. }
  destruct (run_is_stored constants _ lines N _ _ _ L S _ _ F) as [_ C]. rewrite Nat2N.id in C. exact C.
Qed.
Lemma drawn_is p numbers place : nth place (run operation R in_float64 0 p (map fst numbers)) 0 = fst (nth place (run operation two_numbers
  two_machines two_zeros p numbers) two_zeros).
Proof. rewrite <- (around operation two_numbers R fst two_machines in_float64 two_zeros (fun _ _ => eq_refl)). apply (map_nth fst _ two_zeros). Qed.
Theorem pixel_accuracy__computed constants allowance box numbers place : nearest_constants constants -> In (allowance, box) boxes -> In place (fst box) ->
  lie_in (snd box) numbers -> let x := nth place (run operation exact_number exact_machine zero_meant (pixel_of constants) (map snd numbers))
  zero_meant in fst x /\ Rabs (nth place (run operation R in_float64 0 (pixel_of constants) (map fst numbers)) 0 - snd x) <= IZR allowance / 10 ^ 14.
Proof.
  intros N B D A. destruct (andb_prop _ _ boxes_are_within) as [W _]. apply andb_prop, proj1 in W. pose proof proj1 (forallb_forall _ _) (proj1
    (forallb_forall _ _) W _ B) _ D as V. clear W. cbn [fst snd] in V. rename V into W.
  pose proof range_is constants box numbers place N A as S. destruct (range_at _ place) as [[l h e]|]; [|discriminate]. destruct S as (M & _ & S). cbv
    zeta.
  rewrite drawn_is. change zero_meant with (snd two_zeros). rewrite <- (around operation two_numbers exact_number snd two_machines exact_machine
    two_zeros (fun _ _ => eq_refl)), map_nth. split; [exact M|].
  eapply Rle_trans; [exact S|]. apply is_no_more in W. unfold times_1e14 in W. rewrite F2R_mult in W. unfold F2R at 2 3 in W. simpl in W. lra.
Qed.

Definition lows (box : list recorded_pixel.number) : list two_numbers := map (fun n => let x := F2R (dyadic_of (fst (fst n))) in (x, (True, x))) box.
Lemma lows_lie box : forallb is_range box = true -> lie_in box (lows box).
Proof.
  unfold lie_in, lows. induction box as [|[[l h] e] box IH]; cbn [forallb map]; intro H; constructor; apply andb_prop in H; destruct H as [W H];
    [|apply IH, H].
  apply andb_prop in W. destruct W as [L E]. apply is_no_more in L, E. rewrite zero_is in E. split; [exact I|]. unfold lies, range_of. cbn [fst snd]
    in *. rewrite Rminus_eq_0, Rabs_R0. lra.
Qed.
Lemma written_constants : nearest_constants (fun m e => (literal m e, 0)).
Proof. intros m e. cbn [fst]. rewrite Rminus_eq_0, Rabs_R0. apply bpow_ge_0. Qed.
Lemma two_of_them : (In (18%Z, first_box) boxes /\ In (18%Z, second_box) boxes) /\ In first_color (fst first_box) /\ In first_color (fst second_box).
Proof. unfold boxes. repeat split; try (apply in_or_app; left); cbn; tauto. Qed.
Theorem pixel_accuracy__computed__point : exists constants allowance box numbers place, nearest_constants constants /\ In (allowance, box) boxes /\ In place
  (fst box) /\ lie_in (snd box) numbers.
Proof.
  destruct two_of_them as ([B _] & D & _). destruct (andb_prop _ _ boxes_are_within) as [_ W]. apply andb_prop, proj1 in W. eexists _, _, first_box,
    _, _.
  split; [exact written_constants | split; [exact B | split; [exact D | apply lows_lie, W]]].
Qed.
Lemma they_differ c d n m : differ_by_more c d = true -> shows c n -> shows d m -> 36 / 10 ^ 14 < fst m - fst n.
Proof.
  destruct c as [[l h e]|], d as [[a b f]|]; try discriminate. intros W (_ & R1 & _) (_ & R2 & _). apply is_less in W. unfold times_1e14 in W. rewrite
    F2R_mult, F2R_minus in W. unfold F2R at 1 4 in W. simpl in W. lra.
Qed.
(* Not where the exact numbers are another box's. *)
Theorem pixel_accuracy__computed__false : ~ forall constants allowance box numbers exact place, nearest_constants constants -> In (allowance, box) boxes -> In
  place (fst box) -> lie_in (snd box) numbers -> length numbers = length exact -> Rabs (nth place (run operation R in_float64 0 (pixel_of constants)
  (map fst numbers)) 0 - snd (nth place (run operation exact_number exact_machine zero_meant (pixel_of constants) exact) zero_meant)) <= IZR allowance / 10
  ^ 14.
Proof.
  intro H. destruct two_of_them as ([B C] & D & E). destruct (andb_prop _ _ boxes_are_within) as [W V]. destruct (andb_prop _ _ W) as [_ G],
    (andb_prop _ _ V) as [W1 W2]. clear W V. apply lows_lie in W1, W2. pose proof written_constants as N.
  destruct (pixel_accuracy__computed _ _ _ _ _ N C E W2) as [_ G']. specialize (H _ _ _ _ (map snd (lows (snd second_box))) _ N B D W1
    ltac:(vm_compute; reflexivity)).
  pose proof they_differ _ _ _ _ G (range_is _ _ _ first_color N W1) (range_is _ _ _ first_color N W2) as L. rewrite drawn_is in G', H. revert H G' L.
    set (x := snd (nth _ _ zero_meant)). clearbody x. intros H G' L. apply Rabs_le_inv in H, G'. lra.
Qed.
