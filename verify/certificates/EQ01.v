(* Claim EQ01 of the ledger moore-hills, lines 72 to 75 of its source.
   Printed: p(x) = \frac{E^{*}}{2\pi}\sqrt{a^{2}-x^{2}}\dashint_{-a}^{a}\frac{g'(s)}{\sqrt{a^{2}-s^{2}}}\frac{\mbox{d}s}{s-x}
   Says: Es/(2*Pi)*sqrt(a^2-x^2)*pv(g1(s)/sqrt(a^2-s^2)*(1/(s-x)), s, -a, a, x) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ01 (Es m a x : R) (l : list part) : convex_punch l -> beyond m l -> 0 < m < x -> x < a ->
  exists p0 l0, is_the_pressure Es (Symmetric.slope l) a x p0 /\
  is_principal_value (fun s => Symmetric.slope l s / sqrt (a ^ 2 - s ^ 2) * (1 / (s - x))) (- a) a x l0 /\
  Es / (2 * PI) * sqrt (a ^ 2 - x ^ 2) * l0 = p0.
Proof.
  exact (the_pressure_by_inversion Es l m a x).
Qed.

