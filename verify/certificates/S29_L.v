(* Claim S29.L of the ledger moore-hills, lines 284 to 284 of its source.
   Printed: Again, if $b = a$, these collapse to the symmetric results.
   Says: 2*P1/(Pi*b1*sqrt(a+b)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem S29_L (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) (y : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) ->
  rises_at g1 y /\ y < a ->
  exists r0 r1 r2,
  is_the_right_series Es g1 a r0 r1 r2 /\
  2 * (P1 a) / (PI * 1 * sqrt (a + a)) =
  1 / PI * sqrt (2 / a) * (P1 a) /\
  1 / PI * sqrt (2 / a) * (P1 a) =
  r0.
Proof.
  intros contact convex.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ y); [apply convex | apply convex | exact (right_edge _ _ _ _ _ _ _ _ _ _ contact)]. }
  split; identity_symmetric contact a P1 P2 P3.
Qed.
