(* Claim S38.origin of the ledger moore-hills, lines 347 to 347 of its source.
   Printed: Note that the coordinate system is aligned with the minimum of the punch
   Says: gp(0) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S38_origin (alpha t R0 : R) : 0 < alpha /\ 0 < t /\ 0 < R0 -> tilted_rounded_slope alpha t R0 0 = 0.
Proof.
  intros form. apply lowest_at_origin; lra.
Qed.

