(* Claim S54.stick of the ledger moore-hills, lines 413 to 413 of its source.
   Printed: when full stick conditions apply, the shear traction is geometrically similar to the pressure distribution
   Says: pv(Q/P*p(s)/(s-x), s, -b, a, x) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S54_stick (Es phi gam a Q : R) : 0 < phi /\ 0 < gam /\ 0 < a -> exists P0,
  are_the_pressures Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) (wedge_pressure Es phi gam a) /\
  is_the_load Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) P0 /\
  is_integral_about_0 (wedge_pressure Es phi gam a) (gam * a) a P0 /\
  forall x, - (gam * a) < x < a -> x <> 0 ->
  is_principal_value_about_0 (fun s => Q / P0 * wedge_pressure Es phi gam a s / (s - x)) (gam * a) a x
    (- Q / P0 * PI * Es / 2 * TiltedWedge.slope phi (tilt phi gam) x).
Proof.
  intros (Hphi & Hgam & Ha). exact (wedge_strain Es phi gam a Hphi Hgam Ha Q).
Qed.

