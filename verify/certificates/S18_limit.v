(* Claim S18.limit of the ledger moore-hills, lines 207 to 207 of its source.
   Printed: The solution for $0<a<t$ arises due to the fact that for any $P>0$, the contact immediately consumes the entire flat portion of the punch (i.e. we could equivalently say $a(P)\rightarrow t$ as $P\rightarrow0$).
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem S18_limit (Es t R0 : R) : 0 < Es /\ 0 < t /\ 0 < R0 -> exists P : R -> R,
  (forall a, t < a -> is_the_load Es (Symmetric.slope (rounded t R0)) a a (P a)) /\
  filterlim (fun a => P a / (Es * t)) (at_right t) (locally 0).
Proof.
  intros form. apply load_vanishes; lra.
Qed.

