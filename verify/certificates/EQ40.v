(* Claim EQ40 of the ledger moore-hills, lines 405 to 409 of its source.
   Printed: i.e. at the left hand contact edge when
\begin{equation}
\frac{\sigma_{0}d}{Q}=\frac{4}{3\pi},
   Says: 4/(3*Pi) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ40 (a b Q sig0 : R) : 0 < a + b /\ Q <> 0 /\ sig0 * ((a + b) / 2) / Q = 4 / (3 * PI) -> exists s0 s1 s2 v0 v1 v2,
  is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
  is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\ s1 = 0 /\ v1 <> 0.
Proof.
  exact (vanishes_at_the_right a b Q sig0).
Qed.

