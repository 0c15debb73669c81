(* Claim S45 of the ledger moore-hills, lines 349 to 349 of its source.
   Printed: the punch being locally Hertzian in $x>0$
   Says: x/R *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S45 (alpha t R0 : R) : 0 < alpha /\ 0 < t /\ 0 < R0 -> forall x, 0 < x ->
  x / R0 = tilted_rounded_slope alpha t R0 x.
Proof.
  intros form. apply parabola_to_the_right; lra.
Qed.

