(* Claim EQ24.L of the ledger moore-hills, lines 266 to 271 of its source.
   Printed: L_{I,a} & \, = && \, \frac{2P'(a)}{\pi\sqrt{a+b(a)}}, \label{eqn:LI_NonSym_Right}
   Says: 2*P1/(Pi*sqrt(a+b)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem EQ24_L (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  exists r0 r1 r2,
  is_the_right_series Es g1 a r0 r1 r2 /\
  2 * (P1 a) / (PI * sqrt (a + (b a))) =
  r0.
Proof.
  intros contact left convex.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ y); [apply convex | apply convex | exact (right_edge _ _ _ _ _ _ _ _ _ _ contact)]. }
  identity contact left a b b1.
Qed.
