(* Claim S55 of the ledger moore-hills, lines 453 to 453 of its source.
   Printed: Notably, an asymptotic expansion of this term as $\ve\rightarrow0$ breaks down when $1-\sigma$ is small, due to the $O(\ve^{2}/(1-\sigma))$-term in the square brackets.
   Says: breaks down *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics Expansions Uniform.
Open Scope R_scope.

Theorem S55_refuted (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  exists M d : R, 0 < d /\ forall eps sigma, 0 < eps < d -> 0 < sigma < 1 ->
  Rabs ((- b a + eps + b (a + (alpha (b a - eps) - a) * sigma)) / (eps * (1 - sigma))
    - (1 - eps * (b2 a) * sigma / (2 * (b1 a) ^ 2))) <= M * eps ^ 2.
Proof.
  exact (bracket_uniform Es g1 a P P1 P2 P3 b b1 b2 b3 alpha).
Qed.
