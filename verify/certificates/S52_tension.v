(* Claim S52.tension of the ledger moore-hills, lines 410 to 411 of its source.
   Printed: the same pattern of underestimation of the effect of a shear force and over estimation of the effect of bulk tension will continue to apply
   Says: right.s2*right.s0 < 0 and right.s3*right.s0 < 0 and right.s4*right.s0 < 0 and right.s5*right.s0 < 0 and right.s6*right.s0 < 0 and right.s7*right.s0 < 0 and right.s8*right.s0 < 0 and right.s9*right.s0 < 0 and left.s2*left.s0 < 0 and left.s3*left.s0 < 0 and left.s4*left.s0 < 0 and left.s5*left.s0 < 0 and left.s6*left.s0 < 0 and left.s7*left.s0 < 0 and left.s8*left.s0 < 0 and left.s9*left.s0 < 0 *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S52_tension (a b sig0 : R) : 0 < a + b /\ sig0 <> 0 -> exists s v : nat -> R,
  are_the_right_terms (full_stick 0 sig0 a b) a s 9 /\ are_the_left_terms (full_stick 0 sig0 a b) b v 9 /\
  forall k, (1 <= k <= 9)%nat -> s k * s 0%nat < 0 /\ v k * v 0%nat < 0.
Proof.
  intros form. apply tension_signs; apply form.
Qed.

