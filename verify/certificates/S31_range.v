(* Claim S31.range of the ledger moore-hills, lines 303 to 303 of its source.
   Printed: Note that $0<\gamma<1$, with $\gamma\rightarrow1$ as $\alpha\rightarrow0$ and $\gamma\rightarrow0$ as $\alpha\rightarrow\phi$.
   Says: 0 < b/a and b/a < 1 *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S31_range (phi a alpha : R) : 0 < phi /\ 0 < a /\ 0 < alpha < phi ->
  exists b, is_the_left_edge (slope phi alpha) a b /\ 0 < b / a /\ b / a < 1.
Proof.
  intros form. apply ratio_in_range; lra.
Qed.

