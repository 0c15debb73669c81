(* Claim EQ21.L of the ledger moore-hills, lines 246 to 251 of its source.
   Printed: \displaystyle{\frac{1}{\pi}\int_{b^{-1}(-x)}^{a}\frac{P'(s)}{\sqrt{(s-x)(x+b(s))}}\,\mbox{d}s} & \mbox{for} \; -b(a)<x<0
   Says: 1/Pi*integral(P1of(s)/sqrt((s-x)*(x+bof(s))), s, binv(-x), a) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ21_L (Es phi gam a : R) : 0 < phi /\ 0 < gam /\ 0 < a -> exists P P1 : R -> R,
  (forall s, 0 < s -> is_the_load Es (TiltedWedge.slope phi (tilt phi gam)) s (gam * s) (P s) /\
    is_derive P s (P1 s)) /\
  (forall x, 0 < x < a ->
    is_improper_integral (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + gam * s)))) x a
      (wedge_pressure Es phi gam a x)) /\
  (forall x, - (gam * a) < x < 0 ->
    is_improper_integral (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + gam * s)))) (- x / gam) a
      (wedge_pressure Es phi gam a x)) /\
  is_integral_about_0 (wedge_pressure Es phi gam a) (gam * a) a (P a) /\
  forall x, - (gam * a) < x < a -> x <> 0 ->
  is_principal_value_about_0 (fun s => wedge_pressure Es phi gam a s / (s - x)) (gam * a) a x
    (- (PI * Es / 2 * TiltedWedge.slope phi (tilt phi gam) x)).
Proof.
  intros (Hphi & Hgam & Ha). exact (wedge_solves_by_loads Es phi gam a Hphi Hgam Ha).
Qed.

