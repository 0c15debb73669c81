(* Claim EQ24.N of the ledger moore-hills, lines 266 to 271 of its source.
   Printed: N_{I,a} & \, = && \, \frac{1}{60\pi(a+b(a))^{5/2}}\left[(45 - 16b''(a)(a+b(a)) + 24b'(a)^{2} + 60b'(a))P'(a) \right.\nonumber \\
 & \, && \, \left. - 8(a+b(a))(4b'(a)+5)P''(a) + 32(a+b(a))^{2}P'''(a)\right] \label{eqn:NI_NonSym_Right}
   Says: 1/(60*Pi*(a+b)^(5/2))*((45 - 16*b2*(a+b) + 24*b1^2 + 60*b1)*P1 - 8*(a+b)*(4*b1+5)*P2 + 32*(a+b)^2*P3) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem EQ24_N (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  exists r0 r1 r2,
  is_the_right_series Es g1 a r0 r1 r2 /\
  1 / (60 * PI * Rpower (a + (b a)) (5 / 2)) * ((45 - 16 * (b2 a) * (a + (b a)) + 24 * (b1 a) ^ 2 + 60 * (b1 a)) * (P1 a) - 8 * (a + (b a)) * (4 * (b1 a) + 5) * (P2 a) + 32 * (a + (b a)) ^ 2 * (P3 a)) =
  r2.
Proof.
  intros contact left convex.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ y); [apply convex | apply convex | exact (right_edge _ _ _ _ _ _ _ _ _ _ contact)]. }
  identity contact left a b b1.
Qed.
