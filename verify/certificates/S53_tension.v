(* Claim S53.tension of the ledger moore-hills, lines 411 to 411 of its source.
   Printed: Finally, we emphasize that the results of this section are independent of the contact geometry.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S53_tension (a b c e sig0 tau xi : R) : 0 < a + b -> 0 < c + e -> sig0 <> 0 -> tau <> 0 -> 0 < xi < 1 ->
  is_traction (full_stick 0 sig0 a b) a b 0 sig0 /\
  is_traction (full_stick 0 tau c e) c e 0 tau /\
  full_stick 0 sig0 a b (a - xi * (a + b)) / sig0 =
  full_stick 0 tau c e (c - xi * (c + e)) / tau.
Proof.
  exact (tension_independent a b c e sig0 tau xi).
Qed.

