(* Claim EQ34.q of the ledger moore-hills, lines 368 to 371 of its source.
   Printed: q(x) = \frac{Q}{\pi\sqrt{(a-x)(x+b)}} + \frac{\sigma_{0}(2x+b-a)}{8\sqrt{(a-x)(x+b)}} \; \mbox{for} \; -b<x<a.
   Says: Q/(Pi*sqrt((a-x)*(x+b))) + sig0*(2*x+b-a)/(8*sqrt((a-x)*(x+b))) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ34_q (Q sig0 a b : R) : 0 < a + b ->
  is_traction (fun x => Q / (PI * sqrt ((a - x) * (x + b))) +
    sig0 * (2 * x + b - a) / (8 * sqrt ((a - x) * (x + b)))) a b Q sig0 /\
  forall A B, is_traction (fun s => (A + B * s) / sqrt ((a - s) * (s + b))) a b Q sig0 ->
  forall x, - b < x < a -> (A + B * x) / sqrt ((a - x) * (x + b)) =
    Q / (PI * sqrt ((a - x) * (x + b))) +
    sig0 * (2 * x + b - a) / (8 * sqrt ((a - x) * (x + b))).
Proof.
  intros HD. split; [exact (full_stick_is_traction Q sig0 a b HD) |].
  intros A B. exact (full_stick_of_form Q sig0 a b A B HD).
Qed.

