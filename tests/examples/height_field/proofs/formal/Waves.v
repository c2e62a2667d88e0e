From Formal Require Import Claim.
From Formal Require Statements.

Theorem waves_climb_one_way__direction : Statements.waves_climb_one_way__direction.
Proof. claim. Qed.
Theorem waves_climb_one_way__slope : Statements.waves_climb_one_way__slope.
Proof. claim. Qed.
