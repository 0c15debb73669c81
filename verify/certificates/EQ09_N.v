(* Claim EQ09.N of the ledger moore-hills, lines 126 to 129 of its source.
   Printed: N_{I} = \frac{\sqrt{2}}{480a^{5/2}\pi}\left(129P'(a) - 144aP''(a)+128a^{2}P'''(a)\right)
   Says: sqrt(2)/(480*a^(5/2)*Pi)*(129*P1 - 144*a*P2 + 128*a^2*P3) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem EQ09_N (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) (y : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) ->
  rises_at g1 y /\ y < a ->
  exists r0 r1 r2,
  is_the_right_series Es g1 a r0 r1 r2 /\
  sqrt 2 / (480 * Rpower a (5 / 2) * PI) * (129 * (P1 a) - 144 * a * (P2 a) + 128 * a ^ 2 * (P3 a)) =
  r2.
Proof.
  intros contact convex.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ y); [apply convex | apply convex | exact (right_edge _ _ _ _ _ _ _ _ _ _ contact)]. }
  identity_symmetric contact a P1 P2 P3.
Qed.
