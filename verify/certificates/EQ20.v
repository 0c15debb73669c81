(* Claim EQ20 of the ledger moore-hills, lines 240 to 242 of its source.
   Printed: 0 = \int_{-b}^{a}\frac{g'(s)}{\sqrt{(a-s)(s+b)}}\,\mbox{d}s. \label{eqn:Consistency}
   Says: integral(g1(s)/sqrt((a-s)*(s+b)), s, -b, a) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ20 (phi gam alpha t R0 a : R) : 0 < a ->
  (0 < phi /\ 0 < gam -> is_the_left_edge (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) /\
    is_RInt_gen (fun s => TiltedWedge.slope phi (tilt phi gam) s / sqrt ((a - s) * (s + gam * a)))
      (at_right (- (gam * a))) (at_left a) 0) /\
  (0 < alpha /\ 0 < t /\ 0 < R0 -> exists b, is_the_left_edge (tilted_rounded_slope alpha t R0) a b /\
    is_RInt_gen (fun s => tilted_rounded_slope alpha t R0 s / sqrt ((a - s) * (s + b)))
      (at_right (- b)) (at_left a) 0).
Proof.
  exact (printed_consistency phi gam alpha t R0 a).
Qed.

