(* Claim EQ31 of the ledger moore-hills, lines 314 to 316 of its source.
   Printed: p_{\mathrm{local}}(x) = L_{I,b}\sqrt{\gamma a+x} + M_{I,b}(\gamma a+x)^{3/2} + N_{I,b}(\gamma a+x)^{5/2} + O((\gamma a+x)^{7/2})
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ31 (Es phi gam a : R) : 0 < Es /\ 0 < phi /\ 0 < gam /\ 0 < a -> exists l0 l1 l2,
  is_the_left_series Es (slope phi (tilt phi gam)) (gam * a) l0 l1 l2 /\
  has_orders Es (mirrored (slope phi (tilt phi gam))) (gam * a) l0 l1 l2 /\
  has_remainder Es (mirrored (slope phi (tilt phi gam))) (gam * a) l0 l1 l2.
Proof.
  exact (remainder_at_left Es phi gam a).
Qed.

