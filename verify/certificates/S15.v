(* Claim S15 of the ledger moore-hills, lines 184 to 184 of its source.
   Printed: Similarly, for a Hertzian indenter, a one-term asymptote gives a relative error of $<1\%$ for $\approx4\%$ of the contact, while the two-term asymptote increases this to $\approx 46\%$.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Hertz.
Open Scope R_scope.

(* Of a parabola with Es = C = a = 1, up to 394/10000 of the half-width from the edge, and not at 395/10000. *)
Theorem S15_extent : exists r0 r1 r2,
  right_edge_series 1 (slope 1) 1 r0 r1 r2 /\
  (forall u, 0 < u <= 394 / 10000 -> exists p0, is_pressure 1 (slope 1) 1 (1 - u) p0 /\
    Rabs (p0 - (r0 * sqrt u)) <= (1 / 100) * p0) /\
  (forall u, u = 395 / 10000 -> exists p0, is_pressure 1 (slope 1) 1 (1 - u) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u))).
Proof.
  extent_of_parabola.
Qed.
Print Assumptions S15_extent.
