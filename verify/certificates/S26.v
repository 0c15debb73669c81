(* Claim S26 of the ledger moore-hills, lines 235 to 235 of its source.
   Printed: For both cases, close to the contact edge, we over-estimate the exact solution with each of the first three asymptotes.
   Says: right_local(1, x) > p(x) and right_local(2, x) > p(x) and right_local(3, x) > p(x) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric TiltedWedge Shear Unique Tactics Sides Limits Gamma PowerLaw PowerSides RoundedSides.
Open Scope R_scope.

Theorem S26 (Es t R0 a : R) : 0 < Es /\ 0 < t < a /\ 0 < R0 ->
  exists r0 r1 r2, is_the_right_series Es (Symmetric.slope (rounded t R0)) a r0 r1 r2 /\
  exists d, 0 < d /\ forall u, 0 < u < d -> exists p0, is_the_pressure Es (Symmetric.slope (rounded t R0)) a (a - u) p0 /\
  (p0 < r0 * sqrt u /\ p0 < r0 * sqrt u + r1 * (u * sqrt u) /\ p0 < r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u)).
Proof.
  intros form. near_edge_by (rounded_right Es t R0 a form).
Qed.

