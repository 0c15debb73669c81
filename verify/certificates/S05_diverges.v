(* Claim S05.diverges of the ledger moore-hills, lines 164 to 164 of its source.
   Printed: In fact, at a fixed value of $a-x$, the approximation diverges as $m\rightarrow\infty$: this is consistent with the contact pressure for a rectangular punch being inverse square-root singular at the contact edges (see, for example, \cite{Barber2002}).
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S05_diverges (Es C a x : R) : 0 < Es /\ 0 < C /\ 0 < x < a -> exists p P r : R -> R,
  (forall m, 0 <= m -> is_the_pressure Es (power_slope C m) a x (p m) /\
    is_the_load Es (power_slope C m) a a (P m) /\
    exists r1 r2, is_the_right_series Es (power_slope C m) a (r m) r1 r2) /\
  filterlim (fun m => r m * sqrt (a - x) / p m) (Rbar_locally p_infty) (Rbar_locally p_infty) /\
  filterlim (fun m => r m * sqrt (a - x) * a / P m) (Rbar_locally p_infty) (Rbar_locally p_infty).
Proof.
  exact (one_term_diverges Es C a x).
Qed.

