(* Claim EQ47.F of the ledger moore-hills, lines 460 to 465 of its source.
   Printed: F(a + (b^{-1}(-x)-a)\sigma) &\, \sim && \, F(a) - \frac{\ve XF'(a)}{b'}\sigma + \ve^{2}X^{2}\left(\frac{\sigma^{2}F''(a)}{2b'^{2}} - \frac{b''F'(a)\sigma}{2b'^{3}}\right) + O(\ve^{3}) \\
   Says: P1/Pi - eps*X*(P2/Pi)/b1*sigma + eps^2*X^2*(sigma^2*(P3/Pi)/(2*b1^2) - b2*(P2/Pi)*sigma/(2*b1^3)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics Expansions HalfPowers PressureExpansions Curved.
Open Scope R_scope.

Theorem EQ47_F (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  forall X sigma : R,
  agrees_through 2 (fun eps => P1 (a + (alpha ((b a) - eps * X) - a) * sigma) / PI)
    (fun eps => (P1 a) / PI - eps * X * ((P2 a) / PI) / (b1 a) * sigma + eps ^ 2 * X ^ 2 * (sigma ^ 2 * ((P3 a) / PI) / (2 * (b1 a) ^ 2) - (b2 a) * ((P2 a) / PI) * sigma / (2 * (b1 a) ^ 3))).
Proof.
  intros contact left X sigma.
  edge_facts contact left.
  pose proof (rate_through_2 _ _ _ _ _ _ _ _ _ _ _ _ contact left X sigma) as derived.
  apply (agrees_ext _ _ _ _ derived). intros u. field; repeat split; lra.
Qed.

