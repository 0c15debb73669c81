(* Claim EQ35 of the ledger moore-hills, lines 373 to 375 of its source.
   Printed: \frac{\sigma_{0}(b+a)}{Q}<\frac{8}{\pi}
   Says: right.s0*left.s0 > 0 *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ35  : (forall a b Q sig0, 0 < a + b /\ Q <> 0 -> exists s0 s1 s2 v0 v1 v2,
    is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
    is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
    (Rabs (sig0 * (b + a) / Q) < 8 / PI -> 0 < s0 * v0) /\
    (sig0 * (b + a) / Q < 8 / PI /\ 0 < sig0 * Q -> 0 < s0 * v0)) /\
  (exists a b Q sig0 s0 s1 s2 v0 v1 v2, 0 < a + b /\ Q <> 0 /\
    is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
    is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
    sig0 * (b + a) / Q < 8 / PI /\ s0 * v0 < 0).
Proof.
  exact same_sign.
Qed.

