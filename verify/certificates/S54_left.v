(* Claim S54.left of the ledger moore-hills, lines 413 to 413 of its source.
   Printed: in problems where the normal and shear force change together, when full stick conditions apply, the shear traction is geometrically similar to the pressure distribution
   Says: Q/P*p(x) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S54_left (Es phi gam C m a Q y : R) : 0 < Es /\ 0 < phi /\ 0 < gam /\ 0 < C /\ 0 <= m /\ 0 < a ->
  (0 < y < gam * a -> is_similar_on_the_left Es (TiltedWedge.slope phi (tilt phi gam)) a Q y) /\
  (0 < y < a -> is_similar_on_the_left Es (power_slope C m) a Q y).
Proof.
  intros form. exact (similar_tractions_left Es phi gam C m a Q form y).
Qed.

