(* Claim S05.punch of the ledger moore-hills, lines 164 to 164 of its source.
   Printed: In fact, at a fixed value of $a-x$, the approximation diverges as $m\rightarrow\infty$: this is consistent with the contact pressure for a rectangular punch being inverse square-root singular at the contact edges (see, for example, \cite{Barber2002}).
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S05_punch (Es C a x : R) : 0 < Es /\ 0 < C /\ 0 < x < a -> exists p P : R -> R,
  (forall m, 0 <= m -> is_the_pressure Es (power_slope C m) a x (p m) /\
    is_the_load Es (power_slope C m) a a (P m)) /\
  filterlim (fun m => p m / (P m / (PI * sqrt (a ^ 2 - x ^ 2)))) (Rbar_locally p_infty) (locally 1).
Proof.
  exact (becomes_rectangular Es C a x).
Qed.

