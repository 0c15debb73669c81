(* Claim EQ25.N of the ledger moore-hills, lines 275 to 283 of its source.
   Printed: N_{I,b} & \, = && \, \frac{1}{60\pi b'(a)^{5}(a+b(a))^{5/2}}\left[\{15b'(a)^{3}(3b'(a) + 4) + 8b'(a)^{2}(3+5(a+b(a))b''(a)) \right. \nonumber \\
 & \, && \, \left. - 16b'(a)(a+b(a))(2b'''(a)(a+b(a)) - 3b''(a)) + 96b''(a)^{2}(a+b(a))^{2}\}P'(a) \right.\nonumber \\
 & \, && \, \left. - \{40b'(a)^{3}(a+b(a)) + 32b'(a)^{2}(a+b(a)) + 96b''(a)b'(a)(a+b(a))^{2}\}P''(a) \right. \nonumber \\
 & \, && \, \left. + 32b'(a)^{2}(a+b(a))^{2}P'''(a)\right]
 \label{eqn:NI_NonSym_Left}
   Says: 1/(60*Pi*b1^5*(a+b)^(5/2))*((15*b1^3*(3*b1+4) + 8*b1^2*(3+5*(a+b)*b2) - 16*b1*(a+b)*(2*b3*(a+b) - 3*b2) + 96*b2^2*(a+b)^2)*P1 - (40*b1^3*(a+b) + 32*b1^2*(a+b) + 96*b2*b1*(a+b)^2)*P2 + 32*b1^2*(a+b)^2*P3) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem EQ25_N (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  exists l0 l1 l2,
  is_the_left_series Es g1 (b a) l0 l1 l2 /\
  1 / (60 * PI * (b1 a) ^ 5 * Rpower (a + (b a)) (5 / 2)) * ((15 * (b1 a) ^ 3 * (3 * (b1 a) + 4) + 8 * (b1 a) ^ 2 * (3 + 5 * (a + (b a)) * (b2 a)) - 16 * (b1 a) * (a + (b a)) * (2 * (b3 a) * (a + (b a)) - 3 * (b2 a)) + 96 * (b2 a) ^ 2 * (a + (b a)) ^ 2) * (P1 a) - (40 * (b1 a) ^ 3 * (a + (b a)) + 32 * (b1 a) ^ 2 * (a + (b a)) + 96 * (b2 a) * (b1 a) * (a + (b a)) ^ 2) * (P2 a) + 32 * (b1 a) ^ 2 * (a + (b a)) ^ 2 * (P3 a)) =
  l2.
Proof.
  intros contact left convex.
  eexists. eexists. eexists. 
  split. { apply (the_left_series _ _ z); [apply convex | apply convex | exact (left_edge_of_a _ _ _ _ _ _ _ _ _ _ _ _ contact left)]. }
  identity contact left a b b1.
Qed.
