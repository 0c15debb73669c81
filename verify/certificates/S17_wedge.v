(* Claim S17.wedge of the ledger moore-hills, lines 186 to 186 of its source.
   Printed: We see clear confirmation that we under-estimate the contact pressure in the former case, while we over-estimate it in the latter case. This trend is maintained even for the higher-order estimates.
   Says: right_local(1, x) < p(x) and right_local(2, x) < p(x) and right_local(3, x) < p(x) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric TiltedWedge Shear Unique Tactics Sides.
Open Scope R_scope.

Theorem S17_wedge (Es C a : R) : 0 < Es /\ 0 < C /\ 0 < a ->
  exists r0 r1 r2, is_the_right_series Es (TiltedWedge.slope C 0) a r0 r1 r2 /\
  forall u, 0 < u < a -> exists p0, is_the_pressure Es (TiltedWedge.slope C 0) a (a - u) p0 /\
  (r0 * sqrt u < p0 /\ r0 * sqrt u + r1 * (u * sqrt u) < p0 /\ r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u) < p0).
Proof.
  intros form. by_first_terms (wedge_symmetric Es C a form).
Qed.

