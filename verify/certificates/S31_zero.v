(* Claim S31.zero of the ledger moore-hills, lines 303 to 303 of its source.
   Printed: Note that $0<\gamma<1$, with $\gamma\rightarrow1$ as $\alpha\rightarrow0$ and $\gamma\rightarrow0$ as $\alpha\rightarrow\phi$.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S31_zero (phi a : R) : 0 < phi /\ 0 < a -> exists b : R -> R,
  (forall alpha, 0 < alpha < phi -> is_the_left_edge (slope phi alpha) a (b alpha)) /\
  filterlim (fun alpha => b alpha / a) (at_left phi) (locally 0).
Proof.
  intros form. apply ratio_of_the_largest_tilt; lra.
Qed.

