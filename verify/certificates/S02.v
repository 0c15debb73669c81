(* Claim S02 of the ledger moore-hills, lines 105 to 105 of its source.
   Printed: Generally speaking, the relative error in the approximation is then naturally $O(M_{I}|a\pm x|)$.
   Says: right.c1*u *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S02 (Es C m t R0 a K : R) : 0 < Es /\ 0 < C /\ 0 <= m /\ 0 < t < a /\ 0 < R0 ->
  (exists r0 r1 r2, is_the_right_series Es (power_slope C m) a r0 r1 r2 /\ r0 <> 0 /\
    has_error_of_order Es (power_slope C m) a r0 (Rabs (r1 / r0))) /\
  (exists r0 r1 r2, is_the_right_series Es (Symmetric.slope (rounded t R0)) a r0 r1 r2 /\ r0 <> 0 /\
    has_error_of_order Es (Symmetric.slope (rounded t R0)) a r0 (Rabs (r1 / r0))) /\
  (exists Fs phi c r0 r1 r2 factor,
    is_the_right_series Fs (TiltedWedge.slope phi (tilt phi 1)) c r0 r1 r2 /\ r0 <> 0 /\ r1 <> 0 /\
    has_error_of_order Fs (TiltedWedge.slope phi (tilt phi 1)) c r0 (factor * Rabs r1) /\ factor <> K).
Proof.
  exact (order_in_the_distance Es C m t R0 a K).
Qed.

