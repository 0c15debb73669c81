(* Claim S30 of the ledger moore-hills, lines 284 to 284 of its source.
   Printed: we see that $L_{I,b} = L_{I,a}/b'(a)$
   Says: right.c0/b1 *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem S30 (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  exists r0 r1 r2 l0 l1 l2,
  is_the_right_series Es g1 a r0 r1 r2 /\
  is_the_left_series Es g1 (b a) l0 l1 l2 /\
  r0 / (b1 a) =
  l0.
Proof.
  intros contact left convex.
  eexists. eexists. eexists. eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ y); [apply convex | apply convex | exact (right_edge _ _ _ _ _ _ _ _ _ _ contact)]. }
  split. { apply (the_left_series _ _ z); [apply convex | apply convex | exact (left_edge_of_a _ _ _ _ _ _ _ _ _ _ _ _ contact left)]. }
  identity contact left a b b1.
Qed.
