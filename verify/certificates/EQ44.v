(* Claim EQ44 of the ledger moore-hills, lines 445 to 447 of its source.
   Printed: b^{-1}(-x)-a = -\frac{\ve X}{b'(a)} - \frac{\ve^{2}X^{2}b''(a)}{2b'(a)^{3}} - \frac{\ve^{3}X^{3}(b'(a)b'''(a)-3b''(a)^{2})}{6b'(a)^{5}} + O(\ve^{4})
   Says: -eps*X/b1 - eps^2*X^2*b2/(2*b1^3) - eps^3*X^3*(b1*b3-3*b2^2)/(6*b1^5) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics Expansions HalfPowers PressureExpansions Curved.
Open Scope R_scope.

Theorem EQ44_refuted (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  forall X : R,
  (X ^ 3 * (3 * (b2 a) ^ 2 - (b1 a) * (b3 a)) / (6 * (b1 a) ^ 5)) - (- (X ^ 3 * (3 * (b2 a) ^ 2 - (b1 a) * (b3 a)) / (6 * (b1 a) ^ 5))) <> 0 ->
  ~ agrees_through 3 (fun eps => alpha ((b a) - eps * X) - a)
    (fun eps => - eps * X / (b1 a) - eps ^ 2 * X ^ 2 * (b2 a) / (2 * (b1 a) ^ 3) - eps ^ 3 * X ^ 3 * ((b1 a) * (b3 a) - 3 * (b2 a) ^ 2) / (6 * (b1 a) ^ 5)).
Proof.
  intros contact left X differ.
  edge_facts contact left.
  pose proof (inverse_through_3 _ _ _ _ _ _ _ _ _ _ _ _ contact left X) as derived.
  intros printed. apply differ, Rminus_diag_eq.
  assert (polynomial : agrees_through 3 (fun eps => (alpha ((b a) - eps * X) - a)) (fun u => (0) + (- (X / (b1 a))) * u + (- ((b2 a) * X ^ 2 / (2 * (b1 a) ^ 3))) * u ^ 2 + (X ^ 3 * (3 * (b2 a) ^ 2 - (b1 a) * (b3 a)) / (6 * (b1 a) ^ 5)) * u ^ 3)).
  { apply (agrees_ext _ _ _ _ printed). intros u. field; repeat split; lra. }
  destruct (unique_3 _ _ _ _ _ _ _ _ _ derived polynomial) as (E0 & E1 & E2 & E3).
  transitivity_of E3; field; repeat split; lra.
Qed.

Theorem EQ44_corrected (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  forall X : R,
  agrees_through 3 (fun eps => alpha ((b a) - eps * X) - a)
    (fun eps => - eps * X / (b1 a) - eps ^ 2 * X ^ 2 * (b2 a) / (2 * (b1 a) ^ 3) + eps ^ 3 * X ^ 3 * ((b1 a) * (b3 a) - 3 * (b2 a) ^ 2) / (6 * (b1 a) ^ 5)).
Proof.
  intros contact left X.
  edge_facts contact left.
  pose proof (inverse_through_3 _ _ _ _ _ _ _ _ _ _ _ _ contact left X) as derived.
  apply (agrees_ext _ _ _ _ derived). intros u. field; repeat split; lra.
Qed.

Theorem EQ44_instance : exists (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R),
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 /\
  is_left_edge a b b1 b2 b3 alpha /\
  (rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a) /\
  exists X : R, (X ^ 3 * (3 * (b2 a) ^ 2 - (b1 a) * (b3 a)) / (6 * (b1 a) ^ 5)) - (- (X ^ 3 * (3 * (b2 a) ^ 2 - (b1 a) * (b3 a)) / (6 * (b1 a) ^ 5))) <> 0.
Proof.
  exists_curved_contact. exists 2. apply apart. curved_numbers.
Qed.

