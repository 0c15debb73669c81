(* Claim EQ02.p of the ledger moore-hills, lines 77 to 80 of its source.
   Printed: P = \int_{-a}^{a} p(x)\,\mbox{d}x
   Says: integral(p(x), x, -a, a) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ02_p (Es C m t R0 a : R) : 0 < C /\ 0 <= m /\ 0 < t < a /\ 0 < R0 ->
  (exists p P0, are_the_pressures Es (power_slope C m) a a p /\
    is_the_load Es (power_slope C m) a a P0 /\ is_integral_about_0 p a a P0) /\
  (exists p P0, are_the_pressures Es (Symmetric.slope (rounded t R0)) a a p /\
    is_the_load Es (Symmetric.slope (rounded t R0)) a a P0 /\ is_integral_about_0 p a a P0).
Proof.
  exact (integrals_of_pressure Es C m t R0 a).
Qed.

