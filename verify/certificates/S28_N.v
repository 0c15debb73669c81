(* Claim S28.N of the ledger moore-hills, lines 272 to 272 of its source.
   Printed: It is straightforward to check that these reduce to (\ref{eqn:LI}), (\ref{eqn:MI_and_NI}) when $b = a$.
   Says: 1/(60*Pi*(a+b)^(5/2))*((45 - 16*b2*(a+b) + 24*b1^2 + 60*b1)*P1 - 8*(a+b)*(4*b1+5)*P2 + 32*(a+b)^2*P3) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem S28_N (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) (y : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) ->
  rises_at g1 y /\ y < a ->
  exists r0 r1 r2,
  is_the_right_series Es g1 a r0 r1 r2 /\
  1 / (60 * PI * Rpower (a + a) (5 / 2)) * ((45 - 16 * 0 * (a + a) + 24 * 1 ^ 2 + 60 * 1) * (P1 a) - 8 * (a + a) * (4 * 1 + 5) * (P2 a) + 32 * (a + a) ^ 2 * (P3 a)) =
  sqrt 2 / (480 * Rpower a (5 / 2) * PI) * (129 * (P1 a) - 144 * a * (P2 a) + 128 * a ^ 2 * (P3 a)) /\
  sqrt 2 / (480 * Rpower a (5 / 2) * PI) * (129 * (P1 a) - 144 * a * (P2 a) + 128 * a ^ 2 * (P3 a)) =
  r2.
Proof.
  intros contact convex.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ y); [apply convex | apply convex | exact (right_edge _ _ _ _ _ _ _ _ _ _ contact)]. }
  split; identity_symmetric contact a P1 P2 P3.
Qed.
