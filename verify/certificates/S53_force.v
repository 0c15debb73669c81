(* Claim S53.force of the ledger moore-hills, lines 411 to 411 of its source.
   Printed: Finally, we emphasize that the results of this section are independent of the contact geometry.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S53_force (a b c e Q N xi : R) : 0 < a + b -> 0 < c + e -> Q <> 0 -> N <> 0 -> 0 < xi < 1 ->
  is_traction (full_stick Q 0 a b) a b Q 0 /\ is_traction (full_stick N 0 c e) c e N 0 /\
  full_stick Q 0 a b (a - xi * (a + b)) * (a + b) / Q =
  full_stick N 0 c e (c - xi * (c + e)) * (c + e) / N.
Proof.
  exact (force_independent a b c e Q N xi).
Qed.

