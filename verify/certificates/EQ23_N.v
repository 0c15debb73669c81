(* Claim EQ23.N of the ledger moore-hills, lines 259 to 264 of its source.
   Printed: \frac{1}{\pi\sqrt{a+b(a)}}\left[\frac{3P'(a)}{4(a+b(a))^{2}} + \frac{b'(a)P'(a)}{(a+b(a))^{2}} - \frac{2P''(a)}{3(a+b(a))} \right. \nonumber \\
 & \, && \, \left. +\frac{8}{15}\left(P'''(a)-\frac{P''(a)b'(a)}{(a+b(a))} + \frac{3b'(a)^{2}P'(a)}{4(a+b(a))^{2}} - \frac{b''(a)P'(a)}{2(a+b(a))}\right)\right](a-x)^{5/2}
   Says: 1/(Pi*sqrt(a+b))*(3*P1/(4*(a+b)^2) + b1*P1/(a+b)^2 - 2*P2/(3*(a+b)) + 8/15*(P3 - P2*b1/(a+b) + 3*b1^2*P1/(4*(a+b)^2) - b2*P1/(2*(a+b)))) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics.
Open Scope R_scope.

Theorem EQ23_N (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  exists r0 r1 r2,
  is_the_right_series Es g1 a r0 r1 r2 /\
  1 / (PI * sqrt (a + (b a))) * (3 * (P1 a) / (4 * (a + (b a)) ^ 2) + (b1 a) * (P1 a) / (a + (b a)) ^ 2 - 2 * (P2 a) / (3 * (a + (b a))) + 8 / 15 * ((P3 a) - (P2 a) * (b1 a) / (a + (b a)) + 3 * (b1 a) ^ 2 * (P1 a) / (4 * (a + (b a)) ^ 2) - (b2 a) * (P1 a) / (2 * (a + (b a))))) =
  r2.
Proof.
  intros contact left convex.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ y); [apply convex | apply convex | exact (right_edge _ _ _ _ _ _ _ _ _ _ contact)]. }
  identity contact left a b b1.
Qed.
