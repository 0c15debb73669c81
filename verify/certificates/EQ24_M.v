(* Claim EQ24.M of the ledger moore-hills, lines 266 to 271 of its source.
   Printed: M_{I,a} & \, = && \, \frac{1}{3\pi(a+b(a))^{3/2}}\left[(3+2b'(a))P'(a)- 4(a+b(a))P''(a)\right], \label{eqn:MI_NonSym_Right}
   Says: 1/(3*Pi*(a+b)^(3/2))*((3+2*b1)*P1 - 4*(a+b)*P2) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem EQ24_M (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  exists r0 r1 r2,
  is_the_right_series Es g1 a r0 r1 r2 /\
  1 / (3 * PI * Rpower (a + (b a)) (3 / 2)) * ((3 + 2 * (b1 a)) * (P1 a) - 4 * (a + (b a)) * (P2 a)) =
  r1.
Proof.
  intros contact left convex.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ y); [apply convex | apply convex | exact (right_edge _ _ _ _ _ _ _ _ _ _ contact)]. }
  identity contact left a b b1.
Qed.
