(* Claim S19.minimum of the ledger moore-hills, lines 231 to 231 of its source.
   Printed: It is worth noting that, while the exact solution for the pressure (\ref{eqn:Pressure_FaR_exact}) is continuous everywhere, there is a characteristic peak close to the flat-to-round transition points $x = \pm t$ before the pressure falls to a minimum at the line of symmetry, as shown by the black curves in figure \ref{fig:Over_Under_FaR}.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S19_minimum (Es t R0 a : R) : 0 < Es /\ 0 < t < a /\ 0 < R0 -> exists p,
  are_the_pressures Es (Symmetric.slope (rounded t R0)) a a p /\
  (forall x, - a < x < a -> continuous p x) /\
  forall x z, 0 <= x < z -> z <= t -> p x < p z.
Proof.
  exact (grows_to_the_transition Es t R0 a).
Qed.

