(* Claim S60.hertz of the ledger moore-hills, lines 184 to 184 of its source.
   Printed: for the wedge and Hertz geometries, including two terms in the local contact pressure asymptote significantly increases the accuracy of the approximation throughout the contact.
   Says: abs(1 - right_local(2, x)/p(x)) < abs(1 - right_local(1, x)/p(x)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric TiltedWedge Shear Unique Tactics Sides.
Open Scope R_scope.

Theorem S60_hertz (Es C a : R) : 0 < Es /\ 0 < C /\ 0 < a ->
  exists r0 r1 r2, is_the_right_series Es (Symmetric.slope (parabola C)) a r0 r1 r2 /\
  forall u, 0 < u < a -> exists p0, is_the_pressure Es (Symmetric.slope (parabola C)) a (a - u) p0 /\
  (Rabs (1 - (r0 * sqrt u + r1 * (u * sqrt u)) / p0) < Rabs (1 - r0 * sqrt u / p0)).
Proof.
  intros form. by_first_terms (parabola_right Es C a form).
Qed.

