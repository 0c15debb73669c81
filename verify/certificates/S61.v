(* Claim S61 of the ledger moore-hills, lines 76 to 76 of its source.
   Printed: for $-a<x<a$ \cite{Barber2002}, where $E^{*}$ is the plane strain elastic modulus.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S61 (Ey nu C a x : R) : 0 < Ey /\ -1 < nu < 1 /\ 0 < C -> 0 < x < a -> exists p0 l0,
  is_the_pressure (Ey / (1 - nu ^ 2)) (Symmetric.slope (parabola C)) a x p0 /\
  is_principal_value (fun s => sqrt (a ^ 2 - s ^ 2) / (x - s)) (- a) a x l0 /\
  2 * (1 - nu ^ 2) / (PI * Ey) * p0 / sqrt (a ^ 2 - x ^ 2) * l0 = Symmetric.slope (parabola C) x /\
  2 * 2 * (1 - nu ^ 2) / (PI * Ey) * p0 / sqrt (a ^ 2 - x ^ 2) * l0 <> Symmetric.slope (parabola C) x.
Proof.
  exact (one_body_or_two Ey nu C a x).
Qed.

