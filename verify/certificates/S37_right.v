(* Claim S37.right of the ledger moore-hills, lines 334 to 334 of its source.
   Printed: We plot the first three asymptotes alongside the exact pressure profile for each side of the wedge in figure \ref{fig:PressureWedge1}; we see that each approximation under-estimates the pressure.
   Says: right_local(1, x) < p(x) and right_local(2, x) < p(x) and right_local(3, x) < p(x) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric TiltedWedge Shear Unique Tactics Sides.
Open Scope R_scope.

Theorem S37_right (Es phi gam a : R) : 0 < Es /\ 0 < phi /\ 0 < gam /\ 0 < a ->
  exists r0 r1 r2, is_the_right_series Es (TiltedWedge.slope phi (tilt phi gam)) a r0 r1 r2 /\
  forall u, 0 < u < a -> exists p0, is_the_pressure Es (TiltedWedge.slope phi (tilt phi gam)) a (a - u) p0 /\
  (r0 * sqrt u < p0 /\ r0 * sqrt u + r1 * (u * sqrt u) < p0 /\ r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u) < p0).
Proof.
  intros form. by_first_terms (wedge_right Es phi gam a form).
Qed.

