(* Claim EQ45 of the ledger moore-hills, lines 449 to 452 of its source.
   Printed: \frac{1}{\sqrt{x+b(a+(b^{-1}(-x)-a)\sigma)}} & \; = && \; \frac{1}{\sqrt{\ve(1-\sigma)}}\left[1 - \ve\frac{b''(a)\sigma}{2b'(a)^{2}} + \frac{\ve^{2}\sigma}{1-\sigma}\left(\frac{b''(a)^{2}(\sigma+1)}{2b'(a)^{4}}-\right.\right. \nonumber \\
 & \; && \; \left. \left. \frac{b'''(a)(\sigma^{2}+1)}{6b'(a)^{3}}\right) + O(\ve^{3})\right]^{-1/2}
   Says: 1/sqrt(eps*(1-sigma))*(1 - eps*b2*sigma/(2*b1^2) + eps^2*sigma/(1-sigma)*(b2^2*(sigma+1)/(2*b1^4) - b3*(sigma^2+1)/(6*b1^3)))^(-1/2) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics Expansions HalfPowers PressureExpansions Curved.
Open Scope R_scope.

Theorem EQ45_refuted_1 (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  forall X sigma : R, 0 < X -> 0 < sigma < 1 ->
  (1 / sqrt (1 - sigma)) - (1 / (sqrt X * sqrt (1 - sigma))) <> 0 ->
  ~ agrees_in_halves 2 (fun eps => 1 / sqrt (- b a + eps * X + b (a + (alpha ((b a) - eps * X) - a) * sigma)))
    (fun eps => 1 / sqrt (eps * (1 - sigma)) * Rpower (1 - eps * (b2 a) * sigma / (2 * (b1 a) ^ 2) + eps ^ 2 * sigma / (1 - sigma) * ((b2 a) ^ 2 * (sigma + 1) / (2 * (b1 a) ^ 4) - (b3 a) * (sigma ^ 2 + 1) / (6 * (b1 a) ^ 3))) (- (1 / 2))).
Proof.
  intros contact left X sigma HX Hs differ.
  edge_facts contact left.
  pose proof (inverse_root_through_2 _ _ _ _ _ _ _ _ _ _ _ _ contact left X sigma HX Hs) as derived.
  intros printed. apply differ, Rminus_diag_eq.
  assert (polynomial : agrees_through 2 (fun eps => sqrt eps * (1 / sqrt (- b a + eps * X + b (a + (alpha ((b a) - eps * X) - a) * sigma)))) (fun u => (1 / sqrt (1 - sigma)) + ((b2 a) * sigma / (4 * (b1 a) ^ 2 * sqrt (1 - sigma))) * u + (- (sigma * (15 * (b2 a) ^ 2 * sigma + 24 * (b2 a) ^ 2 + 9 * (b2 a) ^ 2 * sigma ^ 2 - 8 * (b1 a) * (b3 a) - 8 * (b1 a) * (b3 a) * sigma ^ 2) / (96 * (b1 a) ^ 4 * Rpower (1 - sigma) (3 / 2)))) * u ^ 2)).
  { apply (agrees_trans _ _ _ _ printed). in_half_powers. }
  destruct (unique_2 _ _ _ _ _ _ _ derived polynomial) as (E0 & E1 & E2).
  transitivity_of E0; half_powers.
Qed.

Theorem EQ45_corrected_1 (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  forall X sigma : R, 0 < X -> 0 < sigma < 1 ->
  agrees_in_halves 2 (fun eps => 1 / sqrt (- b a + eps * X + b (a + (alpha ((b a) - eps * X) - a) * sigma)))
    (fun eps => 1 / (sqrt X * sqrt (1 - sigma)) * Rpower eps (- (1 / 2)) + (b2 a) * sigma * sqrt X / (4 * (b1 a) ^ 2 * sqrt (1 - sigma)) * sqrt eps + sigma * Rpower X (3 / 2) * (24 * (b2 a) ^ 2 + 9 * (b2 a) ^ 2 * sigma - 8 * (b1 a) * (b3 a) - 8 * (b1 a) * (b3 a) * sigma) / (96 * (b1 a) ^ 4 * sqrt (1 - sigma)) * Rpower eps (3 / 2)).
Proof.
  intros contact left X sigma HX Hs.
  edge_facts contact left.
  pose proof (inverse_root_through_2 _ _ _ _ _ _ _ _ _ _ _ _ contact left X sigma HX Hs) as derived.
  apply (agrees_trans _ _ _ _ derived). in_half_powers.
Qed.

Theorem EQ45_instance_1 : exists (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R),
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 /\
  is_left_edge a b b1 b2 b3 alpha /\
  (rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a) /\
  exists X sigma : R, 0 < X /\ 0 < sigma < 1 /\
  (1 / sqrt (1 - sigma)) - (1 / (sqrt X * sqrt (1 - sigma))) <> 0.
Proof.
  exists_curved_contact. exists 2, (1 / 2). split; [lra |]. split; [lra |]. apply apart. curved_numbers.
Qed.

Theorem EQ45_refuted_2 (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  forall sigma : R, 0 < sigma < 1 ->
  (- (sigma * (15 * (b2 a) ^ 2 * sigma + 24 * (b2 a) ^ 2 + 9 * (b2 a) ^ 2 * sigma ^ 2 - 8 * (b1 a) * (b3 a) - 8 * (b1 a) * (b3 a) * sigma ^ 2) / (96 * (b1 a) ^ 4 * Rpower (1 - sigma) (3 / 2)))) - (sigma * (24 * (b2 a) ^ 2 + 9 * (b2 a) ^ 2 * sigma - 8 * (b1 a) * (b3 a) - 8 * (b1 a) * (b3 a) * sigma) / (96 * (b1 a) ^ 4 * sqrt (1 - sigma))) <> 0 ->
  ~ agrees_in_halves 2 (fun eps => 1 / sqrt (- b a + eps + b (a + (alpha ((b a) - eps) - a) * sigma)))
    (fun eps => 1 / sqrt (eps * (1 - sigma)) * Rpower (1 - eps * (b2 a) * sigma / (2 * (b1 a) ^ 2) + eps ^ 2 * sigma / (1 - sigma) * ((b2 a) ^ 2 * (sigma + 1) / (2 * (b1 a) ^ 4) - (b3 a) * (sigma ^ 2 + 1) / (6 * (b1 a) ^ 3))) (- (1 / 2))).
Proof.
  intros contact left sigma Hs differ.
  edge_facts contact left.
  pose proof (inverse_root_at_1 _ _ _ _ _ _ _ _ _ _ _ _ contact left sigma Hs) as derived.
  intros printed. apply differ, Rminus_diag_eq.
  assert (polynomial : agrees_through 2 (fun eps => sqrt eps * (1 / sqrt (- b a + eps + b (a + (alpha ((b a) - eps) - a) * sigma)))) (fun u => (1 / sqrt (1 - sigma)) + ((b2 a) * sigma / (4 * (b1 a) ^ 2 * sqrt (1 - sigma))) * u + (- (sigma * (15 * (b2 a) ^ 2 * sigma + 24 * (b2 a) ^ 2 + 9 * (b2 a) ^ 2 * sigma ^ 2 - 8 * (b1 a) * (b3 a) - 8 * (b1 a) * (b3 a) * sigma ^ 2) / (96 * (b1 a) ^ 4 * Rpower (1 - sigma) (3 / 2)))) * u ^ 2)).
  { apply (agrees_trans _ _ _ _ printed). in_half_powers. }
  destruct (unique_2 _ _ _ _ _ _ _ derived polynomial) as (E0 & E1 & E2).
  transitivity_of E2; half_powers.
Qed.

Theorem EQ45_corrected_2 (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  forall sigma : R, 0 < sigma < 1 ->
  agrees_in_halves 2 (fun eps => 1 / sqrt (- b a + eps + b (a + (alpha ((b a) - eps) - a) * sigma)))
    (fun eps => 1 / sqrt (1 - sigma) * Rpower eps (- (1 / 2)) + (b2 a) * sigma / (4 * (b1 a) ^ 2 * sqrt (1 - sigma)) * sqrt eps + sigma * (24 * (b2 a) ^ 2 + 9 * (b2 a) ^ 2 * sigma - 8 * (b1 a) * (b3 a) - 8 * (b1 a) * (b3 a) * sigma) / (96 * (b1 a) ^ 4 * sqrt (1 - sigma)) * Rpower eps (3 / 2)).
Proof.
  intros contact left sigma Hs.
  edge_facts contact left.
  pose proof (inverse_root_at_1 _ _ _ _ _ _ _ _ _ _ _ _ contact left sigma Hs) as derived.
  apply (agrees_trans _ _ _ _ derived). in_half_powers.
Qed.

Theorem EQ45_instance_2 : exists (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R),
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 /\
  is_left_edge a b b1 b2 b3 alpha /\
  (rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a) /\
  exists sigma : R, 0 < sigma < 1 /\
  (- (sigma * (15 * (b2 a) ^ 2 * sigma + 24 * (b2 a) ^ 2 + 9 * (b2 a) ^ 2 * sigma ^ 2 - 8 * (b1 a) * (b3 a) - 8 * (b1 a) * (b3 a) * sigma ^ 2) / (96 * (b1 a) ^ 4 * Rpower (1 - sigma) (3 / 2)))) - (sigma * (24 * (b2 a) ^ 2 + 9 * (b2 a) ^ 2 * sigma - 8 * (b1 a) * (b3 a) - 8 * (b1 a) * (b3 a) * sigma) / (96 * (b1 a) ^ 4 * sqrt (1 - sigma))) <> 0.
Proof.
  exists_curved_contact. exists (1 / 2). split; [lra |]. apply apart. curved_numbers.
Qed.

