(* Claim S28.M of the ledger moore-hills, lines 272 to 272 of its source.
   Printed: It is straightforward to check that these reduce to (\ref{eqn:LI}), (\ref{eqn:MI_and_NI}) when $b = a$.
   Says: 1/(3*Pi*(a+b)^(3/2))*((3+2*b1)*P1 - 4*(a+b)*P2) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem S28_M (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) (y : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) ->
  rises_at g1 y /\ y < a ->
  exists r0 r1 r2,
  is_the_right_series Es g1 a r0 r1 r2 /\
  1 / (3 * PI * Rpower (a + a) (3 / 2)) * ((3 + 2 * 1) * (P1 a) - 4 * (a + a) * (P2 a)) =
  2 * sqrt 2 / (3 * Rpower a (3 / 2) * PI) * (5 * (P1 a) / 8 - a * (P2 a)) /\
  2 * sqrt 2 / (3 * Rpower a (3 / 2) * PI) * (5 * (P1 a) / 8 - a * (P2 a)) =
  r1.
Proof.
  intros contact convex.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ y); [apply convex | apply convex | exact (right_edge _ _ _ _ _ _ _ _ _ _ contact)]. }
  split; identity_symmetric contact a P1 P2 P3.
Qed.
