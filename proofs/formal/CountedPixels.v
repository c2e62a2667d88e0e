(* A checker that runs a recorded program with its counts, and ten pixels of the default scene that it certifies. *)

From Coq Require Import Reals Lra Lia ZArith NArith List Bool FMapPositive.
From Flocq Require Import Core Operations.
From Formal Require Import Preliminaries Programs RecordedPixel Rounding EnclosingRules EnclosingOperations EnclosingPrograms EnclosingPixel
  ComputedCounts.
Open Scope R_scope.
Import ListNotations.

Definition nothing_found : found := (Written None, Some (dyadic_zero, dyadic_zero)).
Definition far_apart (a b : dyadic * dyadic) : bool :=
  let counts := sum_near (snd a) (snd b) in less (product_near_of counts rounding_dyadic) (Fabs (subtracted_near (fst a) (fst b))) || equal counts
    dyadic_zero.
(* Whether a test holds, where what is known decides it. *)
Fixpoint test_found (c : test) (given : list found) : option bool :=
  let compared compare i j := match snd (nth i given nothing_found), snd (nth j given nothing_found) with
    | Some a, Some b => if far_apart a b then Some (compare (fst a) (fst b)) else None
    | _, _ => None
    end in
  match c with
  | Less i j => compared less i j
  | Same i j => compared equal i j
  | Not c => option_map negb (test_found c given)
  | Both c d => match test_found c given, test_found d given with
    | Some false, _ | _, Some false => Some false
    | Some true, Some true => Some true
    | _, _ => None
    end
  end.
Fixpoint all_found (given : list found) : option (list (kind * (dyadic * dyadic))) :=
  match given with
  | [] => Some []
  | (a, Some n) :: rest => option_map (cons (a, n)) (all_found rest)
  | _ => None
  end.
Definition found_by (o : recorded_pixel.operation) (given : list found) : option (dyadic * dyadic) :=
  match o, given with
  | recorded_pixel.Where c, (_, x) :: (_, y) :: compared => match test_found (test_of c) compared with Some true => x | Some false => y | None =>
      None end
  | recorded_pixel.Where _, _ => None
  | _, _ => match all_found given with Some numbers => rule_found o numbers | None => None end
  end.

(* What is found is known of a number of the machine, and is it. *)
Definition shows (c : found) (n : number) := fst (snd n) = fst c /\ match snd c with Some v => fst n /\ snd (snd n) = pair_in_reals v | None =>
  True end.
Lemma shows_zero : shows nothing_found zero_known.
Proof. unfold shows, pair_in_reals. cbn [fst snd nothing_found zero_known]. rewrite zero_is. repeat split. Qed.
Lemma far_is a b : far_apart a b = true -> too_near (pair_in_reals a) (pair_in_reals b) = false.
Proof.
  unfold far_apart, too_near, either, Sumbool.sumbool_or. rewrite less_is, equal_is. in_real_numbers. unfold pair_in_reals. cbn [fst snd]. fold
      ROUNDING.
  destruct Rlt_dec, Req_EM_T; reflexivity || discriminate.
Qed.
Lemma nth_shows given numbers i : Forall2 shows given numbers -> shows (nth i given nothing_found) (nth i numbers zero_known).
Proof. intro A. revert i. induction A as [|c n given numbers S _ IH]; intros [|i]; try exact shows_zero; [exact S | apply IH]. Qed.
Lemma decided_shows given numbers c : Forall2 shows given numbers -> forall b, test_found c given = Some b -> test_settled c numbers /\ leaves_open c
    (map snd (map snd numbers)) = false /\ holds c (map
  value_of numbers) = b.
Proof.
  intro A. assert (U : forall i, nth i (map snd (map snd numbers)) (0, 0) = snd (snd (nth i numbers zero_known))) by (intro i; rewrite map_map; exact
      (map_nth
    (fun n : number => snd (snd n)) numbers zero_known i)).
  assert (V : forall i, nth i (map value_of numbers) 0 = value_of (nth i numbers zero_known)) by (intro i; apply (map_nth value_of numbers
      zero_known)).
  induction c as [i j | i j | c IH | c IHc d IHd]; intro b; cbn [test_found test_settled leaves_open holds].
  1, 2: rewrite !U, !V; destruct (nth_shows _ _ i A) as [_ I], (nth_shows _ _ j A) as [_ J]; destruct (snd (nth i given _)) as [v|], (snd (nth j
      given _)) as [w|];
    try discriminate; destruct I as [Ki I], J as [Kj J]; unfold value_of; rewrite I, J; destruct (far_apart v w) eqn:F; [|discriminate]; intros [=
    <-];
    rewrite ?less_is, ?equal_is; repeat split; try assumption; apply far_is, F.
  - destruct (test_found c given) as [h|]; [|discriminate]. intros [= <-]. destruct (IH h eq_refl) as (S & O & ->). repeat split; assumption.
  - rewrite <- values. destruct (test_found c given) as [[]|], (test_found d given) as [[]|]; try discriminate; intros [= <-];
      try destruct (IHc _ eq_refl) as (S & -> & ->); try destruct (IHd _ eq_refl) as (S' & -> & ->); rewrite ?andb_false_r, ?orb_false_r; repeat
          split;
      tauto.
Qed.
Lemma all_found_are given numbers l : Forall2 shows given numbers -> all_found given = Some l -> Forall (fun n => fst n) numbers /\ map snd numbers =
    map in_reals l.
Proof.
  intro A. revert l. induction A as [|[a [v|]] n given' numbers' [K S] _ IH]; intros l H; cbn in H; try discriminate; [injection H as <-; split;
      [constructor |
    reflexivity]|].
  destruct (all_found given') as [rest|]; [|discriminate]. injection H as <-. destruct (IH _ eq_refl) as [F M]. cbn in K, S. split; [constructor;
    tauto|]. cbn [map]. rewrite M. f_equal. destruct n as [p [k w]]. cbn in *. destruct S as [_ ->]. rewrite K. reflexivity.
Qed.
Lemma computed_shows given numbers constants o : Forall2 shows given numbers -> nearest_constants constants -> shows (kind_of (operation_of (fun _ _
    =>
  (0, 0)) o) (map fst given), found_by o given) (machine_of counted_roundings (operation_of constants o) numbers).
Proof.
  intros A N. assert (K : map (fun n => fst (snd n)) numbers = map fst given) by (induction A as [|c n given numbers [E _] _ IH]; [reflexivity | cbn;
    rewrite IH, E; reflexivity]).
  split; [cbn [machine_of fst snd]; rewrite K; destruct o; reflexivity|]. cbn [fst snd]. clear K.
  assert (Rule : forall l v, all_found given = Some l -> rule_found o l = Some v -> (Forall (fun n => fst n) numbers /\ allowed
    (operation_of constants o) (map snd numbers)) /\ snd (snd (machine_of counted_roundings (operation_of constants o) numbers)) = pair_in_reals v).
  { intros l [x e] G H. destruct (all_found_are _ _ l A G) as [F M]. destruct (by_rule_is
      constants o l x e N H) as (L & X & E). cbn [machine_of snd]. rewrite values, M. repeat split; try assumption. rewrite X, E. reflexivity. }
  destruct o; cbn [found_by]; try (destruct (all_found given) as [l|] eqn:G; [|exact I]; destruct (rule_found _ l) as [v|] eqn:H; [|exact I]; exact
      (Rule
    l v eq_refl H)).
  clear Rule. destruct A as [|[a x] n given numbers X A]; [exact I|]. destruct A as [|[b y] m given numbers Y A]; [exact I|].
  destruct (test_found _ given) as [h|] eqn:D; [|exact I]. destruct (decided_shows _ _ _ A _ D) as (S & O & H). destruct X as [_ X], Y as [_ Y].
  cbn [machine_of operation_of known in_float64 counted_roundings map fst snd] in *. destruct n as [kx [ax [vx ex]]], m as [ky [ay [vy ey]]]. cbn [snd
    fst] in *. rewrite O, <- values, H. change (value_of (kx, (ax, (vx, ex)))) with vx. change (value_of (ky, (ay, (vy, ey)))) with vy.
  destruct h; [destruct x as [v|] | destruct y as [v|]]; try exact I; cbn [fst snd]; tauto.
Qed.

(* What is found is kept by its place, from 1 on. *)
Fixpoint all_at (m : PositiveMap.t found) (places : list N) : option (list found) :=
  match places with
  | [] => Some []
  | place :: rest => match PositiveMap.find (N.succ_pos place) m, all_at m rest with Some c, Some others => Some (c :: others) | _, _ => None end
  end.
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
Fixpoint run_found (wanted : PositiveMap.t unit) (lines : list (recorded_pixel.operation * list N)) (place : N) (m : PositiveMap.t found) :
  PositiveMap.t found :=
  match lines with
  | [] => m
  | (o, places) :: rest =>
    let next := if takes_its_places o && PositiveMap.mem (N.succ_pos place) wanted then match all_at m places with
      | Some given => PositiveMap.add (N.succ_pos place) (kind_of (operation_of (fun _ _ => (0, 0)) o) (map fst given), found_by o given) m
      | None => m
      end
      else m in
    run_found wanted rest (N.succ place) next
  end.
Fixpoint with_inputs (inputs : list (kind * (dyadic * dyadic))) (place : N) (m : PositiveMap.t found) : PositiveMap.t found :=
  match inputs with
  | [] => m
  | c :: rest => with_inputs rest (N.succ place) (PositiveMap.add (N.succ_pos place) (fst c, Some (snd c)) m)
  end.

Definition stored (m : PositiveMap.t found) (values : list number) := forall place c, PositiveMap.find (N.succ_pos place) m = Some c -> (N.to_nat
  place < length values)%nat /\ shows c (nth (N.to_nat place) values zero_known).
Lemma stored_more m values n : stored m values -> stored m (values ++ n :: nil).
Proof. intros S place c F. destruct (S place c F) as [L H]. rewrite app_length, app_nth1 by exact L. split; [lia | exact H]. Qed.
Lemma stored_next m values place c n : length values = N.to_nat place -> shows c n -> stored m values -> stored (PositiveMap.add (N.succ_pos place) c
    m)
  (values ++ n :: nil).
Proof.
  intros L C S other d F. destruct (N.eq_dec other place) as [->|D].
  - rewrite PositiveMap.gss in F. injection F as <-. rewrite app_length, app_nth2, L, Nat.sub_diag by lia. split; [cbn; lia | exact C].
  - rewrite PositiveMap.gso in F by (intro E; apply D; rewrite <- (N.pos_pred_succ other), E; apply N.pos_pred_succ). exact (stored_more _ _ n S
      other d
      F).
Qed.
Lemma all_at_show m values places : forall given, stored m values -> all_at m places = Some given -> Forall2 shows given (taken number zero_known
    values
  (map N.to_nat places)).
Proof.
  induction places as [|place places IH]; intros given S H; cbn in H; [injection H as <-; constructor|]. destruct (PositiveMap.find _ m) as [c|]
      eqn:F;
    [|discriminate]. destruct (all_at m places) as [others|]; [|discriminate]. injection H as <-.
  constructor; [apply S, F | apply IH; [exact S | reflexivity]].
Qed.
Definition number_of (c : kind * (dyadic * dyadic)) : number := (True, in_reals c).
Lemma inputs_are_stored inputs : forall place m values, length values = N.to_nat place -> stored m values -> stored (with_inputs inputs place m)
    (values
  ++ map number_of inputs).
Proof.
  induction inputs as [|c inputs IH]; intros place m values L S; cbn [with_inputs map]; [rewrite app_nil_r; exact S|].
  replace (values ++ _) with ((values ++ [number_of c]) ++ map number_of inputs) by (rewrite <- app_assoc; reflexivity). apply IH; [rewrite
      app_length,
    N2Nat.inj_succ; cbn; lia|].
  apply stored_next; [exact L | | exact S]. repeat split.
Qed.
Definition line_of (constants : Z -> Z -> R * R) (line : recorded_pixel.operation * list N) : operation * list nat :=
  (operation_of constants (fst line), places_of (fst line) (map N.to_nat (snd line))).
Lemma run_is_stored constants wanted lines : nearest_constants constants -> forall place m values, length values = N.to_nat place -> stored m values
    ->
  stored (run_found wanted lines place m) (run operation number (machine_of counted_roundings) zero_known (map (line_of constants) lines) values).
Proof.
  intro N. induction lines as [|[o places] lines IH]; intros place m values L S; [exact S|]. cbn [run_found map]. unfold line_of at 1. cbn [fst snd
      run].
  apply IH; [rewrite app_length, N2Nat.inj_succ; cbn; lia|]. destruct (takes_its_places o && _)%bool eqn:W; [|apply stored_more, S]. destruct (all_at
      m
    places) as [given|] eqn:G; [|apply stored_more, S].
  apply stored_next; [exact L | | exact S]. replace (places_of o _) with (map N.to_nat places) by (destruct o; reflexivity || discriminate).
  apply computed_shows; [exact (all_at_show _ _ _ _ S G) | exact N].
Qed.

(* Ten pixels of the default scene, each in another chamber: their image points, and the scene's numbers. *)
Definition dyadic_of (n : Z * Z) : dyadic := Float radix2 (fst n) (snd n).
Definition input_of (stays : bool) (n : (Z * Z) * (Z * Z)) : kind * (dyadic * dyadic) :=
  (Run stays (negb stays && (fst (snd n) =? 0)%Z), (dyadic_of (fst n), dyadic_of (snd n))).
Definition inputs_at (point : list ((Z * Z) * (Z * Z))) : list (kind * (dyadic * dyadic)) := map (input_of true) point ++ map (input_of false)
  recorded_pixel.scene.
Definition found_at (point : list ((Z * Z) * (Z * Z))) : PositiveMap.t found :=
  let first := N.of_nat (length (inputs_at point)) in let outputs := fold_left (fun others one => PositiveMap.add (N.succ_pos (N.of_nat one)) tt
      others)
    recorded_pixel.drawn (PositiveMap.empty unit) in
  run_found (wanted_by recorded_pixel.lines first outputs) recorded_pixel.lines first (with_inputs (inputs_at point) 0 (PositiveMap.empty found)).
Definition color_in (m : PositiveMap.t found) (place : nat) : option (dyadic * dyadic) :=
  match PositiveMap.find (N.succ_pos (N.of_nat place)) m with Some (_, n) => n | None => None end.
Definition colors_found : list (list (option (dyadic * dyadic))) := map (fun point => map (color_in (found_at point)) recorded_pixel.drawn)
  recorded_pixel.points.
Definition times_1e14 (x : dyadic) : dyadic := Fmult x (Float radix2 (10 ^ 14) 0).
Definition is_within (n : option (dyadic * dyadic)) : bool := match n with Some (_, e) => no_more (times_1e14 (Fmult rounding_dyadic e)) (Float
    radix2 21
  0) | None => false end.
Definition differ_by_more (colors : list (list (option (dyadic * dyadic)))) : bool :=
  match colors with (Some (x, _) :: _) :: (Some (y, _) :: _) :: _ => less (Float radix2 42 0) (times_1e14 (Fabs (Fminus x y))) | _ => false end.
Lemma colors_are_within : forallb (forallb is_within) colors_found && differ_by_more colors_found = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Definition numbers_at (point : list ((Z * Z) * (Z * Z))) : list number := map number_of (inputs_at point).
Lemma color_is constants point place v : nearest_constants constants -> color_in (found_at point) place = Some v ->
  let n := nth place (run operation number (machine_of counted_roundings) zero_known (pixel_of constants) (numbers_at point)) zero_known in
  fst n /\ snd (snd n) = pair_in_reals v.
Proof.
  intros N H. assert (P : pixel_of constants = map (line_of constants) recorded_pixel.lines) by apply map_map. rewrite P. clear P.
  assert (L : length (numbers_at point) = N.to_nat (N.of_nat (length (inputs_at point)))) by (unfold numbers_at; rewrite map_length, Nat2N.id;
    reflexivity).
  assert (S : stored (with_inputs (inputs_at point) 0 (PositiveMap.empty found)) (numbers_at point)).
  { apply (inputs_are_stored (inputs_at point) 0 (PositiveMap.empty found) []); [reflexivity|]. intros other c F. rewrite PositiveMap.gempty in F.
    discriminate. }
  revert H. unfold found_at. cbv zeta. generalize recorded_pixel.lines. intros lines. generalize (wanted_by lines). intros wanted H. unfold color_in
      in H.
  destruct (PositiveMap.find _ (run_found _ _ _ _)) as [[k w]|] eqn:F; [|discriminate]. subst w.
  destruct (run_is_stored constants _ lines N _ _ _ L S _ _ F) as [_ [_ C]]. rewrite Nat2N.id in C. exact C.
Qed.
Theorem pixel_accuracy__ten_pixels constants point exact place : nearest_constants constants -> In point recorded_pixel.points -> In place
  recorded_pixel.drawn -> Forall2 (known_encloses 1) (numbers_at point) exact -> let x := nth place (run operation exact_number exact_machine
  zero_meant (pixel_of constants) exact) zero_meant in fst x /\ Rabs (nth place (run operation R in_float64 0 (pixel_of constants) (map value_of
  (numbers_at point))) 0 - snd x) <= 21 / 10 ^ 14.
Proof.
  intros N P D A. destruct (andb_prop _ _ colors_are_within) as [W _]. unfold colors_found in W. rewrite forallb_forall in W. specialize (W _ (in_map
      _ _
    _ P)). cbv beta in W. rewrite forallb_forall in W. specialize (W _ (in_map _ _ _ D)).
  destruct (color_in (found_at point) place) as [[v e]|] eqn:C; [|discriminate]. destruct (color_is _ _ _ _ N C) as [K E].
  destruct (pixel_accuracy__recorded constants (numbers_at point) exact place A) as [V B]. rewrite <- V. destruct (B K) as [M I]. split; [exact M|].
  eapply Rle_trans; [exact I|]. rewrite E. cbn [snd pair_in_reals]. apply is_at_most in W. unfold times_1e14 in W. rewrite !F2R_mult, rounding_is in
      W.
  unfold F2R at 2 3 in W. simpl in W. unfold ROUNDING. lra.
Qed.

Definition is_number (c : kind * (dyadic * dyadic)) : bool :=
  let (x, e) := snd c in is_written (Fnum x) (Fexp x) && is_written (Fnum e) (Fexp e) && (0 <=? Fnum e)%Z.
Definition taken_for_exact (inputs : list (kind * (dyadic * dyadic))) : list exact_number := map (fun c => (True, F2R (fst (snd c)))) inputs.
Lemma values_are_enclosed inputs : forallb is_number inputs = true -> Forall2 (known_encloses 1) (map number_of inputs) (taken_for_exact inputs).
Proof.
  unfold taken_for_exact. induction inputs as [|[k [[m e] [c d]]] inputs IH]; cbn [forallb map]; intro H; constructor; apply andb_prop in H; destruct
      H as
    [W H]; [|apply IH, H]. clear IH H.
  cbn [is_number snd Fnum Fexp] in W. unfold is_written in W. assert (0 <= F2R (Float radix2 c d)) by (apply F2R_ge_0; cbn; lia). intros _. split;
      [exact
    I|]. unfold encloses. cbn [number_of in_reals pair_in_reals fst snd].
  split; [exact (whole_is_float64 m e ltac:(lia) ltac:(lia)) | split; [exact (whole_is_float64 c d ltac:(lia) ltac:(lia)) | split; [assumption|]]].
      rewrite Rminus_eq_0, Rabs_R0. lra.
Qed.
Lemma written_constants : nearest_constants (fun m e => (literal m e, bpow radix2 (SpecFloat.Zdigits2 m + e - 1))).
Proof. intros m e. cbn [fst snd]. split; [reflexivity|]. rewrite Rminus_eq_0, Rabs_R0. pose proof bpow_ge_0 radix2 (SpecFloat.Zdigits2 m + e - 1) as B.
    lra. Qed.
Definition first_point : list ((Z * Z) * (Z * Z)) := nth 0 recorded_pixel.points [].
Definition second_point : list ((Z * Z) * (Z * Z)) := nth 1 recorded_pixel.points [].
Lemma two_of_them : (In first_point recorded_pixel.points /\ In second_point recorded_pixel.points) /\ forallb is_number (inputs_at first_point) &&
    forallb
  is_number (inputs_at second_point) = true /\ In (hd 0%nat recorded_pixel.drawn) recorded_pixel.drawn.
Proof. split; [split; apply nth_In, Nat.ltb_lt; reflexivity | split; [vm_compute; reflexivity | left; reflexivity]]. Qed.
Theorem pixel_accuracy__ten_pixels__point : exists constants point exact place, nearest_constants constants /\ In point recorded_pixel.points /\ In
    place
  recorded_pixel.drawn /\ Forall2 (known_encloses 1) (numbers_at point) exact.
Proof.
  destruct two_of_them as ([P _] & E & D). apply andb_prop in E. eexists _, first_point, _, _. split; [exact written_constants | split; [exact P |
      split;
    [exact D | apply values_are_enclosed, E]]].
Qed.
Lemma drawn_is constants point place v : nearest_constants constants -> forallb is_number (inputs_at point) = true -> color_in (found_at point) place
    =
  Some v -> nth place (run operation R in_float64 0 (pixel_of constants) (map value_of (numbers_at point))) 0 = F2R (fst v).
Proof.
  intros N I C. destruct (pixel_accuracy__recorded constants (numbers_at point) _ place (values_are_enclosed _ I)) as [<- _]. unfold value_of.
  rewrite (proj2 (color_is _ _ _ _ N C)). reflexivity.
Qed.
Lemma they_differ (colors : list ((Z * Z) * (Z * Z)) -> list (option (dyadic * dyadic))) points : differ_by_more (map colors points) = true -> exists
    v w,
  hd None (colors (nth 0 points [])) = Some v /\ hd None (colors (nth 1 points [])) = Some w /\ 42 / 10 ^ 14 < Rabs (F2R (fst v) - F2R (fst w)).
Proof.
  destruct points as [|p [|q points]]; cbn [map nth]; [discriminate | destruct (colors p) as [|[[x e]|] l]; discriminate|]. destruct (colors p) as
      [|[[x
    e]|] l]; try discriminate. destruct (colors q) as [|[[y d]|] k]; try discriminate.
  cbn [differ_by_more hd]. intro L. exists (x, e), (y, d). repeat split. rewrite less_is in L. destruct Rlt_dec as [G|]; [|discriminate]. unfold
      times_1e14
    in G. rewrite F2R_mult, F2R_abs, F2R_minus in G. cbn [fst]. set (r := Rabs _) in *. unfold F2R in G. simpl in G. lra.
Qed.
(* Not where the numbers are another pixel's. *)
Theorem pixel_accuracy__ten_pixels__false : ~ forall constants point exact place, nearest_constants constants -> In point recorded_pixel.points ->
  In place recorded_pixel.drawn -> length (numbers_at point) = length exact -> Rabs (nth place (run operation R in_float64 0 (pixel_of constants)
  (map value_of (numbers_at point))) 0 - snd (nth place (run operation exact_number exact_machine zero_meant (pixel_of constants) exact)
  zero_meant)) <= 21 / 10 ^ 14.
Proof.
  intro H. destruct two_of_them as ([P Q] & E & D). apply andb_prop in E. destruct E as [E1 E2]. pose proof written_constants as N.
  destruct (pixel_accuracy__ten_pixels _ _ _ _ N Q D (values_are_enclosed _ E2)) as [_ B]. assert (L : length (numbers_at first_point) = length
    (taken_for_exact (inputs_at second_point))) by (vm_compute; reflexivity). specialize (H _ _ _ _ N P D L).
  destruct (andb_prop _ _ colors_are_within) as [_ W]. destruct (they_differ _ _ W) as (v & w & V & U & G). fold first_point in V. fold second_point
      in U.
  assert (K : forall m, hd None (map (color_in m) recorded_pixel.drawn) = color_in m (hd 0%nat recorded_pixel.drawn)) by (intro m; reflexivity).
  rewrite K in V, U. rewrite (drawn_is _ _ _ _ N E1 V) in H. rewrite (drawn_is _ _ _ _ N E2 U) in B. clear - H B G.
  revert H B. set (t := snd _). clearbody t. intros H B. apply Rabs_le_inv in H, B. revert G. unfold Rabs. destruct Rcase_abs; lra.
Qed.
