(* Claim EQ22.P of the ledger moore-hills, lines 253 to 256 of its source.
   Printed: P = \frac{E^{*}}{2}\int_{-b}^{a}\frac{sg'(s)}{\sqrt{(a-s)(s+b)}}\,\mbox{d}s
   Says: Es/2*integral(s*g1(s)/sqrt((a-s)*(s+b)), s, -b, a) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ22_P (Es phi gam a : R) : 0 < phi /\ 0 < gam /\ 0 < a -> exists p P0 l,
  are_the_pressures Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) p /\
  is_integral_about_0 p (gam * a) a P0 /\
  is_RInt_gen (fun s => s * TiltedWedge.slope phi (tilt phi gam) s / sqrt ((a - s) * (s + gam * a)))
    (at_right (- (gam * a))) (at_left a) l /\ Es / 2 * l = P0.
Proof.
  exact (wedge_load_over_places Es phi gam a).
Qed.

