(* Claim EQ25.L of the ledger moore-hills, lines 275 to 283 of its source.
   Printed: L_{I,b} & \, = && \, \frac{2P'(a)}{\pi b'(a)\sqrt{a+b(a)}}, \label{eqn:LI_NonSym_Left}
   Says: 2*P1/(Pi*b1*sqrt(a+b)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem EQ25_L (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  exists l0 l1 l2,
  is_the_left_series Es g1 (b a) l0 l1 l2 /\
  2 * (P1 a) / (PI * (b1 a) * sqrt (a + (b a))) =
  l0.
Proof.
  intros contact left convex.
  eexists. eexists. eexists. 
  split. { apply (the_left_series _ _ z); [apply convex | apply convex | exact (left_edge_of_a _ _ _ _ _ _ _ _ _ _ _ _ contact left)]. }
  identity contact left a b b1.
Qed.
