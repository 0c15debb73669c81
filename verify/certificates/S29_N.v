(* Claim S29.N of the ledger moore-hills, lines 284 to 284 of its source.
   Printed: Again, if $b = a$, these collapse to the symmetric results.
   Says: 1/(60*Pi*b1^5*(a+b)^(5/2))*((15*b1^3*(3*b1+4) + 8*b1^2*(3+5*(a+b)*b2) - 16*b1*(a+b)*(2*b3*(a+b)-3*b2) + 96*b2^2*(a+b)^2)*P1 - (40*b1^3*(a+b) + 32*b1^2*(a+b) + 96*b2*b1*(a+b)^2)*P2 + 32*b1^2*(a+b)^2*P3) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem S29_N (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) (y : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) ->
  rises_at g1 y /\ y < a ->
  exists r0 r1 r2,
  is_the_right_series Es g1 a r0 r1 r2 /\
  1 / (60 * PI * 1 ^ 5 * Rpower (a + a) (5 / 2)) * ((15 * 1 ^ 3 * (3 * 1 + 4) + 8 * 1 ^ 2 * (3 + 5 * (a + a) * 0) - 16 * 1 * (a + a) * (2 * 0 * (a + a) - 3 * 0) + 96 * 0 ^ 2 * (a + a) ^ 2) * (P1 a) - (40 * 1 ^ 3 * (a + a) + 32 * 1 ^ 2 * (a + a) + 96 * 0 * 1 * (a + a) ^ 2) * (P2 a) + 32 * 1 ^ 2 * (a + a) ^ 2 * (P3 a)) =
  sqrt 2 / (480 * Rpower a (5 / 2) * PI) * (129 * (P1 a) - 144 * a * (P2 a) + 128 * a ^ 2 * (P3 a)) /\
  sqrt 2 / (480 * Rpower a (5 / 2) * PI) * (129 * (P1 a) - 144 * a * (P2 a) + 128 * a ^ 2 * (P3 a)) =
  r2.
Proof.
  intros contact convex.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ y); [apply convex | apply convex | exact (right_edge _ _ _ _ _ _ _ _ _ _ contact)]. }
  split; identity_symmetric contact a P1 P2 P3.
Qed.
