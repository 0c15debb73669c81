(* Claim EQ03 of the ledger moore-hills, lines 85 to 88 of its source.
   Printed: p(x) = \frac{1}{\pi}\int_{x}^{a} \frac{P'(s)}{\sqrt{s^{2}-x^{2}}}\,\mbox{d}s
   Says: 1/Pi*integral(P1of(s)/sqrt(s^2-x^2), s, x, a) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ03 (Es C phi gam t R0 m a x : R) (l : list part) : (0 < C /\ 0 < a -> exists P0,
    are_the_pressures Es (Symmetric.slope (parabola C)) a a (fun s => Es * C / 2 * sqrt (a ^ 2 - s ^ 2)) /\
    is_the_load Es (Symmetric.slope (parabola C)) a a P0 /\
    is_integral_about_0 (fun s => Es * C / 2 * sqrt (a ^ 2 - s ^ 2)) a a P0 /\
    forall x, - a < x < a -> is_principal_value (fun s => Es * C / 2 * sqrt (a ^ 2 - s ^ 2) / (s - x)) (- a) a x
      (- (PI * Es / 2 * Symmetric.slope (parabola C) x))) /\
  (0 < phi /\ 0 < gam /\ 0 < a -> exists P0,
    are_the_pressures Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) (wedge_pressure Es phi gam a) /\
    is_the_load Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) P0 /\
    is_integral_about_0 (wedge_pressure Es phi gam a) (gam * a) a P0 /\
    forall x, - (gam * a) < x < a -> x <> 0 ->
    is_principal_value_about_0 (fun s => wedge_pressure Es phi gam a s / (s - x)) (gam * a) a x
      (- (PI * Es / 2 * TiltedWedge.slope phi (tilt phi gam) x))) /\
  (0 < t < a /\ 0 < R0 -> exists P0,
    are_the_pressures Es (Symmetric.slope (rounded t R0)) a a (rounded_pressure Es t R0 a) /\
    is_the_load Es (Symmetric.slope (rounded t R0)) a a P0 /\
    is_integral_about_0 (rounded_pressure Es t R0 a) a a P0 /\
    forall x, - a < x < a -> is_principal_value (fun s => rounded_pressure Es t R0 a s / (s - x)) (- a) a x
      (- (PI * Es / 2 * Symmetric.slope (rounded t R0) x))) /\
  (convex_punch l -> beyond m l -> 0 < m < x -> x < a -> exists P P1 p0 l0,
    (forall s, x <= s <= a -> is_the_load Es (Symmetric.slope l) s s (P s) /\ is_derive P s (P1 s)) /\
    is_principal_value (fun s => Symmetric.slope l s / sqrt (a ^ 2 - s ^ 2) * (1 / (s - x))) (- a) a x l0 /\
    Es / (2 * PI) * sqrt (a ^ 2 - x ^ 2) * l0 = p0 /\
    is_improper_integral (fun s => 1 / PI * (P1 s / sqrt (s ^ 2 - x ^ 2))) x a p0).
Proof.
  split; [intros [HC Ha]; exact (hertz_solves Es C a HC Ha) | split; [intros (Hphi & Hgam & Ha); exact (wedge_solves Es phi gam a Hphi Hgam Ha) | split; [intros [Ht HR]; exact (rounded_solves Es t R0 a Ht HR) | exact (inversion_by_loads Es m a x l)]]].
Qed.

