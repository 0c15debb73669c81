(* Claim EQ04.right of the ledger moore-hills, lines 92 to 95 of its source.
   Printed: p_{\mathrm{local}}(x) = L_{I}\sqrt{|x\pm a|}+ M_{I}(|x\pm a|)^{3/2} + N_{I}(|x\pm a|)^{5/2} + \dots \; \mbox{as} \; |x\pm a|\rightarrow0.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Shear Sides Limits Stick Orders ShearTerms TiltedRounded Inversion PowerLaw Flatness Similar LoadOfPressure Forward ForwardPunches Consistency RoundedShape Readings.
Open Scope R_scope.

Theorem EQ04_right (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) : is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  exists r0 r1 r2, is_the_right_series Es g1 a r0 r1 r2 /\ has_orders Es g1 a r0 r1 r2.
Proof.
  intros contact left convex. eapply orders_at_right; eassumption.
Qed.

