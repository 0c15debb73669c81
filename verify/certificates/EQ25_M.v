(* Claim EQ25.M of the ledger moore-hills, lines 275 to 283 of its source.
   Printed: M_{I,b} & \, = && \, \frac{1}{3\pi b'(a)^{3}(a+b(a))^{3/2}}\left[(3b'(a)^{2}+2b'(a) + 4b''(a)(a+b(a)))P'(a) - 4(a+b)b'(a)P''(a)\right], \label{eqn:MI_NonSym_Left}
   Says: 1/(3*Pi*b1^3*(a+b)^(3/2))*((3*b1^2 + 2*b1 + 4*b2*(a+b))*P1 - 4*(a+b)*b1*P2) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem EQ25_M (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  exists l0 l1 l2,
  is_the_left_series Es g1 (b a) l0 l1 l2 /\
  1 / (3 * PI * (b1 a) ^ 3 * Rpower (a + (b a)) (3 / 2)) * ((3 * (b1 a) ^ 2 + 2 * (b1 a) + 4 * (b2 a) * (a + (b a))) * (P1 a) - 4 * (a + (b a)) * (b1 a) * (P2 a)) =
  l1.
Proof.
  intros contact left convex.
  eexists. eexists. eexists. 
  split. { apply (the_left_series _ _ z); [apply convex | apply convex | exact (left_edge_of_a _ _ _ _ _ _ _ _ _ _ _ _ contact left)]. }
  identity contact left a b b1.
Qed.
