(* Claim EQ29 of the ledger moore-hills, lines 306 to 308 of its source.
   Printed: p_{\mathrm{local}}(x) = L_{I,a}\sqrt(a-x) + M_{I,a}(a-x)^{3/2} + N_{I,a}(a-x)^{5/2} + O((a-x)^{7/2})
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ29 (Es phi gam a : R) : 0 < Es /\ 0 < phi /\ 0 < gam /\ 0 < a -> exists r0 r1 r2,
  is_the_right_series Es (slope phi (tilt phi gam)) a r0 r1 r2 /\
  has_orders Es (slope phi (tilt phi gam)) a r0 r1 r2 /\
  has_remainder Es (slope phi (tilt phi gam)) a r0 r1 r2.
Proof.
  exact (remainder_at_right Es phi gam a).
Qed.

