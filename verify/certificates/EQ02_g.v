(* Claim EQ02.g of the ledger moore-hills, lines 77 to 80 of its source.
   Printed: \frac{E^{*}}{2}\int_{-a}^{a} \frac{sg'(s)}{\sqrt{a^{2}-s^{2}}}\,\mbox{d}s
   Says: Es/2*integral(s*g1(s)/sqrt(a^2-s^2), s, -a, a) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ02_g (Es C m t R0 a : R) : 0 < C /\ 0 <= m /\ 0 < t < a /\ 0 < R0 ->
  (exists p P0 l, are_the_pressures Es (power_slope C m) a a p /\ is_integral_about_0 p a a P0 /\
    is_RInt_gen (fun s => s * power_slope C m s / sqrt (a ^ 2 - s ^ 2)) (at_right (- a)) (at_left a) l /\
    Es / 2 * l = P0) /\
  (exists p P0 l, are_the_pressures Es (Symmetric.slope (rounded t R0)) a a p /\ is_integral_about_0 p a a P0 /\
    is_RInt_gen (fun s => s * Symmetric.slope (rounded t R0) s / sqrt (a ^ 2 - s ^ 2)) (at_right (- a)) (at_left a) l /\
    Es / 2 * l = P0).
Proof.
  exact (loads_over_places Es C m t R0 a).
Qed.

