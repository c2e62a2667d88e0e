(* The kernels' sine and cosine of half-turns as float64 carries them out: the error after each operation, in units u of 2^-53.
   q is what float64 has, p what is exact; the bounds are found by addition, and checked here. *)

From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core Relative.
From Interval Require Import Tactic.
From Formal Require Import Preliminaries Formulas Float Float64 HalfTurns.
Open Scope R_scope.

(* What underflows is off by far less than 2^-100. *)
Lemma rounded_error (x X : R) : Rabs x <= X -> Rabs (rounded x - x) <= X / 2 ^ 53 + 1 / 2 ^ 100.
Proof.
  intro B. unfold rounded. destruct (error_N_FLT radix2 (-1074) 53 ltac:(easy) (fun n => negb (Z.even n)) x) as (d & e & D & E & _ & ->).
  replace (x * (1 + d) + e - x) with (x * d + e) by ring. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  assert (D' : Rabs d <= 1 / 2 ^ 53) by (eapply Rle_trans; [exact D|]; unfold u_ro; simpl; lra).
  assert (E' : Rabs e <= 1 / 2 ^ 100).
  { eapply Rle_trans; [exact E|]. apply Rle_trans with (bpow radix2 (-100)); [|simpl; lra]. generalize (bpow_le radix2 (-1074) (-100) ltac:(easy)) (bpow_gt_0 radix2 (-1074)). lra. }
  apply Rplus_le_compat; [|exact E']. replace (X / 2 ^ 53) with (X * (1 / 2 ^ 53)) by (field; apply pow_nonzero; lra). apply Rmult_le_compat; try apply Rabs_pos; assumption.
Qed.
Lemma plus_error (a ah c S ea : R) : Rabs (a + c) <= S -> Rabs (ah - a) <= ea -> Rabs (rounded (ah + c) - (a + c)) <= ea + ((S + ea) / 2 ^ 53 + 1 / 2 ^ 100).
Proof.
  intros B A. replace (_ - _) with ((ah - a) + (rounded (ah + c) - (ah + c))) by ring. eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; [exact A|].
  apply rounded_error. replace (ah + c) with ((a + c) + (ah - a)) by ring. eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.
Lemma minus_error (a ah c S ea : R) : Rabs (a - c) <= S -> Rabs (ah - a) <= ea -> Rabs (rounded (ah - c) - (a - c)) <= ea + ((S + ea) / 2 ^ 53 + 1 / 2 ^ 100).
Proof. apply plus_error. Qed.
Lemma times_error (z zh a ah Z A ez ea : R) : Rabs a <= A -> Rabs z <= Z -> Rabs (zh - z) <= ez -> Rabs (ah - a) <= ea ->
  Rabs (rounded (zh * ah) - z * a) <= Z * ea + (A + ea) * ez + ((Z + ez) * (A + ea) / 2 ^ 53 + 1 / 2 ^ 100).
Proof.
  intros Ba Bz Ez Ea. replace (_ - _) with ((z * (ah - a) + ah * (zh - z)) + (rounded (zh * ah) - zh * ah)) by ring.
  assert (H : forall x xh X e, Rabs x <= X -> Rabs (xh - x) <= e -> Rabs xh <= X + e).
  { intros x xh X e Bx Ex. replace xh with (x + (xh - x)) by ring. eapply Rle_trans; [apply Rabs_triang|]. lra. }
  eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat.
  - eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult. apply Rplus_le_compat; apply Rmult_le_compat; try apply Rabs_pos; trivial. apply (H a); assumption.
  - apply rounded_error. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; [apply (H z) | apply (H a)]; assumption.
Qed.
Lemma scaled_error (c z zh Z ez : R) : Rabs z <= Z -> Rabs (zh - z) <= ez -> Rabs (rounded (c * zh) - c * z) <= Rabs c * ez + (Rabs c * (Z + ez) / 2 ^ 53 + 1 / 2 ^ 100).
Proof.
  intros Bz Ez. replace (_ - _) with (c * (zh - z) + (rounded (c * zh) - c * zh)) by ring. eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat.
  - rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos | exact Ez].
  - apply rounded_error. rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|]. replace zh with (z + (zh - z)) by ring. eapply Rle_trans; [apply Rabs_triang|]. lra.
Qed.
Definition u : R := 1 / 2 ^ 53.

Section polynomials.
Variable r : R.
Hypothesis B : - (1/4) <= r <= 1/4.
Let z := r ^ 2.
Let zh := rounded (r * r).
Lemma z_is : Rabs z <= 1/16 /\ Rabs (zh - z) <= (63 / 1000) * u.
Proof.
  assert (Q : Rabs z <= 1/16) by (unfold z; apply Rabs_le; nra). split; [exact Q|]. unfold zh. replace (r * r) with z by (unfold z; ring).
  eapply Rle_trans; [apply (rounded_error _ _ Q) | unfold u; interval].
Qed.
Lemma cosine_rounded : Rabs (half_turn_polynomials_float64.cosine_near r - half_turn_polynomials.cosine_near r) <= (989 / 500) * u.
Proof.
  destruct z_is as [Bz Ez]. assert (z0 : 0 <= z <= 1/16) by (split; [apply pow2_ge_0 | generalize (Rle_abs z); lra]).
  unfold half_turn_polynomials_float64.cosine_near, half_turn_polynomials.cosine_near, half_turn_polynomials_float64.z, half_turn_polynomials.z. fold zh z. clearbody zh z.
  assert (Pc0 : Rabs (rounded ((5080167897815029 / 1180591620717411303424) * zh) - (5080167897815029 / 1180591620717411303424) * z) <= (2701 / 5000000000) * u) by (unfold u; eapply Rle_trans; [apply (scaled_error _ z zh (1/16) ((63 / 1000) * u)); assumption | unfold u; interval]).
  pose (qc1 := rounded (rounded ((5080167897815029 / 1180591620717411303424) * zh) - (7720929367626383 / 73786976294838206464))). pose (pc1 := (((5080167897815029 / 1180591620717411303424) * z) - (7720929367626383 / 73786976294838206464))).
  assert (Bc1 : Rabs pc1 <= (53 / 500000)) by (unfold pc1; interval).
  assert (Sc1 : Rabs (qc1 - pc1) <= (1067 / 10000000) * u) by (eapply Rle_trans; [apply (minus_error _ _ _ (53 / 500000) ((2701 / 5000000000) * u)); assumption | unfold u; interval]).
  assert (Pc1 : Rabs (rounded (zh * qc1) - z * pc1) <= (1999 / 100000000) * u) by (eapply Rle_trans; [apply (times_error z zh pc1 qc1 (1/16) (53 / 500000) ((63 / 1000) * u) ((1067 / 10000000) * u)); assumption | unfold u; interval]).
  pose (qc2 := rounded (rounded (zh * qc1) + (8898590864194755 / 4611686018427387904))). pose (pc2 := (z * pc1 + (8898590864194755 / 4611686018427387904))).
  assert (Bc2 : Rabs pc2 <= (1931 / 1000000)) by (unfold pc2, pc1; interval).
  assert (Sc2 : Rabs (qc2 - pc2) <= (61 / 31250) * u) by (eapply Rle_trans; [apply (plus_error _ _ _ (1931 / 1000000) ((1999 / 100000000) * u)); assumption | unfold u; interval]).
  assert (Pc2 : Rabs (rounded (zh * qc2) - z * pc2) <= (729 / 2000000) * u) by (eapply Rle_trans; [apply (times_error z zh pc2 qc2 (1/16) (1931 / 1000000) ((63 / 1000) * u) ((61 / 31250) * u)); assumption | unfold u; interval]).
  pose (qc3 := rounded (rounded (zh * qc2) - (1859582503162531 / 72057594037927936))). pose (pc3 := (z * pc2 - (1859582503162531 / 72057594037927936))).
  assert (Bc3 : Rabs pc3 <= (1613 / 62500)) by (unfold pc3, pc2, pc1; interval).
  assert (Sc3 : Rabs (qc3 - pc3) <= (2619 / 100000) * u) by (eapply Rle_trans; [apply (minus_error _ _ _ (1613 / 62500) ((729 / 2000000) * u)); assumption | unfold u; interval]).
  assert (Pc3 : Rabs (rounded (zh * qc3) - z * pc3) <= (4877 / 1000000) * u) by (eapply Rle_trans; [apply (times_error z zh pc3 qc3 (1/16) (1613 / 62500) ((63 / 1000) * u) ((2619 / 100000) * u)); assumption | unfold u; interval]).
  pose (qc4 := rounded (rounded (zh * qc3) + (8478679513545403 / 36028797018963968))). pose (pc4 := (z * pc3 + (8478679513545403 / 36028797018963968))).
  assert (Bc4 : Rabs pc4 <= (58833 / 250000)) by (unfold pc4, pc3, pc2, pc1; interval).
  assert (Sc4 : Rabs (qc4 - pc4) <= (601 / 2500) * u) by (eapply Rle_trans; [apply (plus_error _ _ _ (58833 / 250000) ((4877 / 1000000) * u)); assumption | unfold u; interval]).
  assert (Pc4 : Rabs (rounded (zh * qc4) - z * pc4) <= (4457 / 100000) * u) by (eapply Rle_trans; [apply (times_error z zh pc4 qc4 (1/16) (58833 / 250000) ((63 / 1000) * u) ((601 / 2500) * u)); assumption | unfold u; interval]).
  pose (qc5 := rounded (rounded (zh * qc4) - (3006744454127613 / 2251799813685248))). pose (pc5 := (z * pc4 - (3006744454127613 / 2251799813685248))).
  assert (Bc5 : Rabs pc5 <= (41727 / 31250)) by (unfold pc5, pc4, pc3, pc2, pc1; interval).
  assert (Sc5 : Rabs (qc5 - pc5) <= (1381 / 1000) * u) by (eapply Rle_trans; [apply (minus_error _ _ _ (41727 / 31250) ((4457 / 100000) * u)); assumption | unfold u; interval]).
  assert (Pc5 : Rabs (rounded (zh * qc5) - z * pc5) <= (127 / 500) * u) by (eapply Rle_trans; [apply (times_error z zh pc5 qc5 (1/16) (41727 / 31250) ((63 / 1000) * u) ((1381 / 1000) * u)); assumption | unfold u; interval]).
  pose (qc6 := rounded (rounded (zh * qc5) + (1142425901258417 / 281474976710656))). pose (pc6 := (z * pc5 + (1142425901258417 / 281474976710656))).
  assert (Bc6 : Rabs pc6 <= (2029357 / 500000)) by (unfold pc6, pc5, pc4, pc3, pc2, pc1; interval).
  assert (Sc6 : Rabs (qc6 - pc6) <= (2157 / 500) * u) by (eapply Rle_trans; [apply (plus_error _ _ _ (2029357 / 500000) ((127 / 500) * u)); assumption | unfold u; interval]).
  assert (Pc6 : Rabs (rounded (zh * qc6) - z * pc6) <= (7791 / 10000) * u) by (eapply Rle_trans; [apply (times_error z zh pc6 qc6 (1/16) (2029357 / 500000) ((63 / 1000) * u) ((2157 / 500) * u)); assumption | unfold u; interval]).
  pose (qc7 := rounded (rounded (zh * qc6) - (2778046668940015 / 562949953421312))). pose (pc7 := (z * pc6 - (2778046668940015 / 562949953421312))).
  assert (Bc7 : Rabs pc7 <= (1233701 / 250000)) by (unfold pc7, pc6, pc5, pc4, pc3, pc2, pc1; interval).
  assert (Sc7 : Rabs (qc7 - pc7) <= (1143 / 200) * u) by (eapply Rle_trans; [apply (minus_error _ _ _ (1233701 / 250000) ((7791 / 10000) * u)); assumption | unfold u; interval]).
  assert (Pc7 : Rabs (rounded (zh * qc7) - z * pc7) <= (9767 / 10000) * u) by (eapply Rle_trans; [apply (times_error z zh pc7 qc7 (1/16) (1233701 / 250000) ((63 / 1000) * u) ((1143 / 200) * u)); assumption | unfold u; interval]).
  pose (qc8 := rounded (rounded (zh * qc7) + 1)). pose (pc8 := (z * pc7 + 1)).
  assert (Bc8 : Rabs pc8 <= (1000001 / 1000000)) by (unfold pc8, pc7, pc6, pc5, pc4, pc3, pc2, pc1; interval).
  assert (Sc8 : Rabs (qc8 - pc8) <= (989 / 500) * u) by (eapply Rle_trans; [apply (plus_error _ _ _ (1000001 / 1000000) ((9767 / 10000) * u)); assumption | unfold u; interval]).
  match goal with |- Rabs (?a - ?b) <= _ => change a with qc8; replace b with pc8 by (unfold pc8, pc7, pc6, pc5, pc4, pc3, pc2, pc1; field) end. exact Sc8.
Qed.
Lemma sine_tail_rounded : Rabs (half_turn_polynomials_float64.sine_tail r - half_turn_polynomials.sine_tail r) <= (166 / 125) * u.
Proof.
  destruct z_is as [Bz Ez]. assert (z0 : 0 <= z <= 1/16) by (split; [apply pow2_ge_0 | generalize (Rle_abs z); lra]).
  unfold half_turn_polynomials_float64.sine_tail, half_turn_polynomials.sine_tail, half_turn_polynomials_float64.z, half_turn_polynomials.z. fold zh z. clearbody zh z.
  assert (Ps0 : Rabs (rounded ((7510502657307481 / 9444732965739290427392) * zh) - (7510502657307481 / 9444732965739290427392) * z) <= (9981 / 100000000000) * u) by (unfold u; eapply Rle_trans; [apply (scaled_error _ z zh (1/16) ((63 / 1000) * u)); assumption | unfold u; interval]).
  pose (qs1 := rounded (rounded ((7510502657307481 / 9444732965739290427392) * zh) - (1617067665348049 / 73786976294838206464))). pose (ps1 := (((7510502657307481 / 9444732965739290427392) * z) - (1617067665348049 / 73786976294838206464))).
  assert (Bs1 : Rabs ps1 <= (23 / 1000000)) by (unfold ps1; interval).
  assert (Ss1 : Rabs (qs1 - ps1) <= (2311 / 100000000) * u) by (eapply Rle_trans; [apply (minus_error _ _ _ (23 / 1000000) ((9981 / 100000000000) * u)); assumption | unfold u; interval]).
  assert (Ps1 : Rabs (rounded (zh * qs1) - z * ps1) <= (1083 / 250000000) * u) by (eapply Rle_trans; [apply (times_error z zh ps1 qs1 (1/16) (23 / 1000000) ((63 / 1000) * u) ((2311 / 100000000) * u)); assumption | unfold u; interval]).
  pose (qs2 := rounded (rounded (zh * qs1) + (8601768518847843 / 18446744073709551616))). pose (ps2 := (z * ps1 + (8601768518847843 / 18446744073709551616))).
  assert (Bs2 : Rabs ps2 <= (117 / 250000)) by (unfold ps2, ps1; interval).
  assert (Ss2 : Rabs (qs2 - ps2) <= (189 / 400000) * u) by (eapply Rle_trans; [apply (plus_error _ _ _ (117 / 250000) ((1083 / 250000000) * u)); assumption | unfold u; interval]).
  assert (Ps2 : Rabs (rounded (zh * qs2) - z * ps2) <= (2207 / 25000000) * u) by (eapply Rle_trans; [apply (times_error z zh ps2 qs2 (1/16) (117 / 250000) ((63 / 1000) * u) ((189 / 400000) * u)); assumption | unfold u; interval]).
  pose (qs3 := rounded (rounded (zh * qs2) - (8497528335533855 / 1152921504606846976))). pose (ps3 := (z * ps2 - (8497528335533855 / 1152921504606846976))).
  assert (Bs3 : Rabs ps3 <= (1843 / 250000)) by (unfold ps3, ps2, ps1; interval).
  assert (Ss3 : Rabs (qs3 - ps3) <= (3731 / 500000) * u) by (eapply Rle_trans; [apply (minus_error _ _ _ (1843 / 250000) ((2207 / 25000000) * u)); assumption | unfold u; interval]).
  assert (Ps3 : Rabs (rounded (zh * qs3) - z * ps3) <= (1393 / 1000000) * u) by (eapply Rle_trans; [apply (times_error z zh ps3 qs3 (1/16) (1843 / 250000) ((63 / 1000) * u) ((3731 / 500000) * u)); assumption | unfold u; interval]).
  pose (qs4 := rounded (rounded (zh * qs3) + (2959617474655169 / 36028797018963968))). pose (ps4 := (z * ps3 + (2959617474655169 / 36028797018963968))).
  assert (Bs4 : Rabs ps4 <= (82147 / 1000000)) by (unfold ps4, ps3, ps2, ps1; interval).
  assert (Ss4 : Rabs (qs4 - ps4) <= (2089 / 25000) * u) by (eapply Rle_trans; [apply (plus_error _ _ _ (82147 / 1000000) ((1393 / 1000000) * u)); assumption | unfold u; interval]).
  assert (Ps4 : Rabs (rounded (zh * qs4) - z * ps4) <= (311 / 20000) * u) by (eapply Rle_trans; [apply (times_error z zh ps4 qs4 (1/16) (82147 / 1000000) ((63 / 1000) * u) ((2089 / 25000) * u)); assumption | unfold u; interval]).
  pose (qs5 := rounded (rounded (zh * qs4) - (2698847510945475 / 4503599627370496))). pose (ps5 := (z * ps4 - (2698847510945475 / 4503599627370496))).
  assert (Bs5 : Rabs ps5 <= (299633 / 500000)) by (unfold ps5, ps4, ps3, ps2, ps1; interval).
  assert (Ss5 : Rabs (qs5 - ps5) <= (123 / 200) * u) by (eapply Rle_trans; [apply (minus_error _ _ _ (299633 / 500000) ((311 / 20000) * u)); assumption | unfold u; interval]).
  assert (Ps5 : Rabs (rounded (zh * qs5) - z * ps5) <= (569 / 5000) * u) by (eapply Rle_trans; [apply (times_error z zh ps5 qs5 (1/16) (299633 / 500000) ((63 / 1000) * u) ((123 / 200) * u)); assumption | unfold u; interval]).
  pose (qs6 := rounded (rounded (zh * qs5) + (2871229454931313 / 1125899906842624))). pose (ps6 := (z * ps5 + (2871229454931313 / 1125899906842624))).
  assert (Bs6 : Rabs ps6 <= (1275083 / 500000)) by (unfold ps6, ps5, ps4, ps3, ps2, ps1; interval).
  assert (Ss6 : Rabs (qs6 - ps6) <= (533 / 200) * u) by (eapply Rle_trans; [apply (plus_error _ _ _ (1275083 / 500000) ((569 / 5000) * u)); assumption | unfold u; interval]).
  assert (Ps6 : Rabs (rounded (zh * qs6) - z * ps6) <= (1217 / 2500) * u) by (eapply Rle_trans; [apply (times_error z zh ps6 qs6 (1/16) (1275083 / 500000) ((63 / 1000) * u) ((533 / 200) * u)); assumption | unfold u; interval]).
  pose (qs7 := rounded (rounded (zh * qs6) - (5818327337647699 / 1125899906842624))). pose (ps7 := (z * ps6 - (5818327337647699 / 1125899906842624))).
  assert (Bs7 : Rabs ps7 <= (2583857 / 500000)) by (unfold ps7, ps6, ps5, ps4, ps3, ps2, ps1; interval).
  assert (Ss7 : Rabs (qs7 - ps7) <= (707 / 125) * u) by (eapply Rle_trans; [apply (minus_error _ _ _ (2583857 / 500000) ((1217 / 2500) * u)); assumption | unfold u; interval]).
  assert (Ps7 : Rabs (rounded (zh * qs7) - z * ps7) <= (251 / 250) * u) by (eapply Rle_trans; [apply (times_error z zh ps7 qs7 (1/16) (2583857 / 500000) ((63 / 1000) * u) ((707 / 125) * u)); assumption | unfold u; interval]).
  pose (qs8 := rounded (rounded (zh * qs7) + (4967757600021511 / 40564819207303340847894502572032))). pose (ps8 := (z * ps7 + (4967757600021511 / 40564819207303340847894502572032))).
  assert (Bs8 : Rabs ps8 <= (40373 / 125000)) by (unfold ps8, ps7, ps6, ps5, ps4, ps3, ps2, ps1; interval).
  assert (Ss8 : Rabs (qs8 - ps8) <= (166 / 125) * u) by (eapply Rle_trans; [apply (plus_error _ _ _ (40373 / 125000) ((251 / 250) * u)); assumption | unfold u; interval]).
  match goal with |- Rabs (?a - ?b) <= _ => change a with qs8; replace b with ps8 by (unfold ps8, ps7, ps6, ps5, ps4, ps3, ps2, ps1; field) end. exact Ss8.
Qed.
End polynomials.

Lemma rounded_0 : rounded 0 = 0.
Proof. apply round_0. typeclasses eauto. Qed.
Lemma rounded_1 : rounded 1 = 1.
Proof. apply round_generic; [typeclasses eauto|]. change 1 with (bpow radix2 0). apply generic_format_bpow. easy. Qed.

(* In float64 the cosine of a reduced argument is within 5/2 2^-53 of the cosine, *)
Theorem elementary_functions__cosine_float64 (r : R) : - (1/4) <= r <= 1/4 -> Rabs (half_turn_polynomials_float64.cosine_near r - cos (PI * r)) <= 5/2 * (1 / 2 ^ 53).
Proof.
  intro B. replace (_ - _) with ((half_turn_polynomials_float64.cosine_near r - half_turn_polynomials.cosine_near r) + (half_turn_polynomials.cosine_near r - cos (PI * r))) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. eapply Rle_trans; [apply Rplus_le_compat; [apply cosine_rounded, B | apply elementary_functions__cosine, B]|]. unfold u. interval.
Qed.
(* and the sine within 9/4 2^-53 of the sine, *)
Theorem elementary_functions__sine_float64 (r : R) : - (1/4) <= r <= 1/4 -> Rabs (half_turn_polynomials_float64.sine_near r - sin (PI * r)) <= 9/4 * (1 / 2 ^ 53).
Proof.
  intro B. replace (_ - _) with ((half_turn_polynomials_float64.sine_near r - half_turn_polynomials.sine_near r) + (half_turn_polynomials.sine_near r - sin (PI * r))) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. eapply Rle_trans; [apply Rplus_le_compat; [|apply elementary_functions__sine, B]|].
  - unfold half_turn_polynomials_float64.sine_near, half_turn_polynomials.sine_near. assert (R1 : Rabs r <= 1/4) by (apply Rabs_le; lra).
    assert (T : Rabs (half_turn_polynomials.sine_tail r + (884279719003555 / 281474976710656)) <= (3464577 / 1000000)).
    { unfold half_turn_polynomials.sine_tail, half_turn_polynomials.z. assert (0 <= r ^ 2 <= 1/16) by (split; [apply pow2_ge_0 | nra]). set (z := r ^ 2) in *. clearbody z. interval. }
    assert (Q := plus_error _ _ _ _ _ T (sine_tail_rounded r B)).
    refine (times_error r r _ _ _ _ 0 _ T R1 _ Q). rewrite Rminus_diag_eq, Rabs_R0; lra.
  - unfold u. interval.
Qed.
(* and at a whole number of half-turns, where the reduced argument is 0, nothing is rounded: a crease's zero is exact. *)
Theorem elementary_functions__zero_float64 : half_turn_polynomials_float64.sine_near 0 = 0 /\ half_turn_polynomials_float64.cosine_near 0 = 1.
Proof.
  unfold half_turn_polynomials_float64.sine_near, half_turn_polynomials_float64.cosine_near, half_turn_polynomials_float64.z.
  rewrite !Rmult_0_l, !rounded_0, !Rmult_0_l, !rounded_0, Rplus_0_l. split; [reflexivity | exact rounded_1].
Qed.
Theorem elementary_functions__cosine_float64__point : exists r : R, - (1/4) <= r <= 1/4.
Proof. exists 0. lra. Qed.
Theorem elementary_functions__sine_float64__point : exists r : R, - (1/4) <= r <= 1/4.
Proof. exists 0. lra. Qed.
(* They are not so near 1 and 0. *)
Theorem elementary_functions__cosine_float64__false : ~ forall r, - (1/4) <= r <= 1/4 -> Rabs (half_turn_polynomials_float64.cosine_near r - 1) <= 5/2 * (1 / 2 ^ 53).
Proof.
  intro H. generalize (H (1/4) ltac:(lra)) (elementary_functions__cosine_float64 (1/4) ltac:(lra)). intros X Y. apply Rabs_le_between in X. apply Rabs_le_between in Y.
  assert (cos (PI * (1/4)) < 1/1 - 6 * (1 / 2 ^ 53)) by interval. lra.
Qed.
Theorem elementary_functions__sine_float64__false : ~ forall r, - (1/4) <= r <= 1/4 -> Rabs (half_turn_polynomials_float64.sine_near r) <= 9/4 * (1 / 2 ^ 53).
Proof.
  intro H. generalize (H (1/4) ltac:(lra)) (elementary_functions__sine_float64 (1/4) ltac:(lra)). intros X Y. apply Rabs_le_between in X. apply Rabs_le_between in Y.
  assert (6 * (1 / 2 ^ 53) < sin (PI * (1/4))) by interval. lra.
Qed.
Theorem elementary_functions__zero_float64__false : ~ forall r, - (1/4) <= r <= 1/4 -> half_turn_polynomials_float64.sine_near r = 0.
Proof. intro H. apply elementary_functions__sine_float64__false. intros r B. rewrite (H r B), Rabs_R0. interval. Qed.
