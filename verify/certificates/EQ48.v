(* Claim EQ48 of the ledger moore-hills, lines 467 to 473 of its source.
   Printed: I_{1} & \, = && \, \frac{1}{\sqrt{\ve}{\sqrt{a+b}}}\left[2F(a) + \ve\left(\frac{(3b'(a)^{2} + 2b'(a) + b''(a)(a+b(a)))F(a) - 4b'(a)(a+b(a))F'(a)}{3b'(a)^{2}(a+b(a))}\right) \right. \nonumber \\ 
 & \, && \, \left. + \frac{\ve^{2}}{60b'(a)^{4}(a+b(a))^{2}}\left(\{45b'(a)^{4} + 60b'(a)^{3} + 2(12+5(a+b(a))b''(a))b'(a)^{2} \right. \right. \nonumber \\ 
 & \, && \, \left. \left. -4(a+b(a))(13b'''(a)(a+b(a))-7b''(a))b'(a)+146b''(a)^{2}(a+b(a))^{2}\}F(a) \right. \right. \nonumber \\
 & \, && \, \left. \left. -8b'(a)(a+b(a))\{5b'(a)^{2} + 4b'(a) + 7b''(a)(a+b(a))\}F'(a)  \right.\right. \nonumber \\
 & \, && \, \left.\left. + 32b'(a)^{2}(a+b(a))^{2}F''(a)\right) + O(\ve^{3}) \right. \bigg] + \; \mbox{terms including} \; \delta
   Says: 1/(sqrt(eps)*sqrt(a+b))*(2*F0 + eps*(((3*b1^2+2*b1+b2*(a+b))*F0 - 4*b1*(a+b)*F1)/(3*b1^2*(a+b))) + eps^2/(60*b1^4*(a+b)^2)*((45*b1^4 + 60*b1^3 + 2*(12+5*(a+b)*b2)*b1^2 - 4*(a+b)*(13*b3*(a+b)-7*b2)*b1 + 146*b2^2*(a+b)^2)*F0 - 8*b1*(a+b)*(5*b1^2+4*b1+7*b2*(a+b))*F1 + 32*b1^2*(a+b)^2*F2)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics Expansions HalfPowers PressureExpansions Curved.
Open Scope R_scope.

Theorem EQ48_refuted_1 (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  forall X : R, 0 < X ->
  (2 * (P1 a) / (PI * sqrt (a + (b a)))) - (2 * (P1 a) / (PI * sqrt X * sqrt (a + (b a)))) <> 0 ->
  exists p, are_the_pressures_left Es g1 (b a) p /\
  ~ agrees_in_halves 2 (fun eps => p (- b a + eps * X) / (a - alpha (b a - eps * X)))
    (fun eps => 1 / (sqrt eps * sqrt (a + (b a))) * (2 * ((P1 a) / PI) + eps * (((3 * (b1 a) ^ 2 + 2 * (b1 a) + (b2 a) * (a + (b a))) * ((P1 a) / PI) - 4 * (b1 a) * (a + (b a)) * ((P2 a) / PI)) / (3 * (b1 a) ^ 2 * (a + (b a)))) + eps ^ 2 / (60 * (b1 a) ^ 4 * (a + (b a)) ^ 2) * ((45 * (b1 a) ^ 4 + 60 * (b1 a) ^ 3 + 2 * (12 + 5 * (a + (b a)) * (b2 a)) * (b1 a) ^ 2 - 4 * (a + (b a)) * (13 * (b3 a) * (a + (b a)) - 7 * (b2 a)) * (b1 a) + 146 * (b2 a) ^ 2 * (a + (b a)) ^ 2) * ((P1 a) / PI) - 8 * (b1 a) * (a + (b a)) * (5 * (b1 a) ^ 2 + 4 * (b1 a) + 7 * (b2 a) * (a + (b a))) * ((P2 a) / PI) + 32 * (b1 a) ^ 2 * (a + (b a)) ^ 2 * ((P3 a) / PI)))).
Proof.
  intros contact left convex X HX differ.
  edge_facts contact left.
  destruct (left_quotient_through_2 _ _ _ _ _ _ _ _ _ _ _ _ X contact left HX) as (p & Hp & derived).
  exists p. split; [apply (the_pressures_left _ _ z); [apply convex | apply convex | exact Hp] |].
  intros printed. apply differ, Rminus_diag_eq.
  assert (polynomial : agrees_through 2 (fun eps => sqrt eps * (p (- b a + eps * X) / (a - alpha (b a - eps * X)))) (fun u => (2 * (P1 a) / (PI * sqrt (a + (b a)))) + (((2 * (b1 a) + 3 * (b1 a) ^ 2 + a * (b2 a) + (b a) * (b2 a)) * (P1 a) - 4 * (b1 a) * (a + (b a)) * (P2 a)) / (3 * PI * (b1 a) ^ 2 * Rpower (a + (b a)) (3 / 2))) * u + (((10 * a * (b2 a) * (b1 a) ^ 2 + 10 * (b a) * (b2 a) * (b1 a) ^ 2 + 146 * a ^ 2 * (b2 a) ^ 2 + 146 * (b a) ^ 2 * (b2 a) ^ 2 + 24 * (b1 a) ^ 2 + 28 * a * (b1 a) * (b2 a) + 28 * (b a) * (b1 a) * (b2 a) + 292 * a * (b a) * (b2 a) ^ 2 + 45 * (b1 a) ^ 4 + 60 * (b1 a) ^ 3 - 104 * a * (b a) * (b1 a) * (b3 a) - 52 * (b1 a) * (b3 a) * a ^ 2 - 52 * (b1 a) * (b3 a) * (b a) ^ 2) * (P1 a) - 8 * (b1 a) * (a + (b a)) * (4 * (b1 a) + 5 * (b1 a) ^ 2 + 7 * a * (b2 a) + 7 * (b a) * (b2 a)) * (P2 a) + 32 * (b1 a) ^ 2 * (a + (b a)) ^ 2 * (P3 a)) / (60 * PI * (b1 a) ^ 4 * Rpower (a + (b a)) (5 / 2))) * u ^ 2)).
  { apply (agrees_trans _ _ _ _ printed). in_half_powers. }
  destruct (unique_2 _ _ _ _ _ _ _ derived polynomial) as (E0 & E1 & E2).
  transitivity_of E0; half_powers.
Qed.

Theorem EQ48_corrected_1 (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  forall X : R, 0 < X ->
  exists p, are_the_pressures_left Es g1 (b a) p /\
  agrees_in_halves 2 (fun eps => p (- b a + eps * X) / (a - alpha (b a - eps * X)))
    (fun eps => 2 * (P1 a) / (PI * sqrt X * sqrt (a + (b a))) * Rpower eps (- (1 / 2)) + sqrt X * ((2 * (b1 a) + 3 * (b1 a) ^ 2 + a * (b2 a) + (b a) * (b2 a)) * (P1 a) - 4 * (b1 a) * (a + (b a)) * (P2 a)) / (3 * PI * (b1 a) ^ 2 * Rpower (a + (b a)) (3 / 2)) * sqrt eps + Rpower X (3 / 2) * ((10 * a * (b2 a) * (b1 a) ^ 2 + 10 * (b a) * (b2 a) * (b1 a) ^ 2 + 24 * (b1 a) ^ 2 + 26 * a ^ 2 * (b2 a) ^ 2 + 26 * (b a) ^ 2 * (b2 a) ^ 2 + 28 * a * (b1 a) * (b2 a) + 28 * (b a) * (b1 a) * (b2 a) + 45 * (b1 a) ^ 4 + 52 * a * (b a) * (b2 a) ^ 2 + 60 * (b1 a) ^ 3 - 12 * (b1 a) * (b3 a) * a ^ 2 - 12 * (b1 a) * (b3 a) * (b a) ^ 2 - 24 * a * (b a) * (b1 a) * (b3 a)) * (P1 a) - 8 * (b1 a) * (a + (b a)) * (4 * (b1 a) + 5 * (b1 a) ^ 2 + 7 * a * (b2 a) + 7 * (b a) * (b2 a)) * (P2 a) + 32 * (b1 a) ^ 2 * (a + (b a)) ^ 2 * (P3 a)) / (60 * PI * (b1 a) ^ 4 * Rpower (a + (b a)) (5 / 2)) * Rpower eps (3 / 2)).
Proof.
  intros contact left convex X HX.
  edge_facts contact left.
  destruct (left_quotient_through_2 _ _ _ _ _ _ _ _ _ _ _ _ X contact left HX) as (p & Hp & derived).
  exists p. split; [apply (the_pressures_left _ _ z); [apply convex | apply convex | exact Hp] |].
  apply (agrees_trans _ _ _ _ derived). in_half_powers.
Qed.

Theorem EQ48_instance_1 : exists (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R),
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 /\
  is_left_edge a b b1 b2 b3 alpha /\
  (rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a) /\
  exists X : R, 0 < X /\
  (2 * (P1 a) / (PI * sqrt (a + (b a)))) - (2 * (P1 a) / (PI * sqrt X * sqrt (a + (b a)))) <> 0.
Proof.
  exists_curved_contact. exists 2. split; [lra |]. apply apart. curved_numbers.
Qed.

Theorem EQ48_refuted_2 (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  (((10 * a * (b2 a) * (b1 a) ^ 2 + 10 * (b a) * (b2 a) * (b1 a) ^ 2 + 146 * a ^ 2 * (b2 a) ^ 2 + 146 * (b a) ^ 2 * (b2 a) ^ 2 + 24 * (b1 a) ^ 2 + 28 * a * (b1 a) * (b2 a) + 28 * (b a) * (b1 a) * (b2 a) + 292 * a * (b a) * (b2 a) ^ 2 + 45 * (b1 a) ^ 4 + 60 * (b1 a) ^ 3 - 104 * a * (b a) * (b1 a) * (b3 a) - 52 * (b1 a) * (b3 a) * a ^ 2 - 52 * (b1 a) * (b3 a) * (b a) ^ 2) * (P1 a) - 8 * (b1 a) * (a + (b a)) * (4 * (b1 a) + 5 * (b1 a) ^ 2 + 7 * a * (b2 a) + 7 * (b a) * (b2 a)) * (P2 a) + 32 * (b1 a) ^ 2 * (a + (b a)) ^ 2 * (P3 a)) / (60 * PI * (b1 a) ^ 4 * Rpower (a + (b a)) (5 / 2))) - (((10 * a * (b2 a) * (b1 a) ^ 2 + 10 * (b a) * (b2 a) * (b1 a) ^ 2 + 24 * (b1 a) ^ 2 + 26 * a ^ 2 * (b2 a) ^ 2 + 26 * (b a) ^ 2 * (b2 a) ^ 2 + 28 * a * (b1 a) * (b2 a) + 28 * (b a) * (b1 a) * (b2 a) + 45 * (b1 a) ^ 4 + 52 * a * (b a) * (b2 a) ^ 2 + 60 * (b1 a) ^ 3 - 12 * (b1 a) * (b3 a) * a ^ 2 - 12 * (b1 a) * (b3 a) * (b a) ^ 2 - 24 * a * (b a) * (b1 a) * (b3 a)) * (P1 a) - 8 * (b1 a) * (a + (b a)) * (4 * (b1 a) + 5 * (b1 a) ^ 2 + 7 * a * (b2 a) + 7 * (b a) * (b2 a)) * (P2 a) + 32 * (b1 a) ^ 2 * (a + (b a)) ^ 2 * (P3 a)) / (60 * PI * (b1 a) ^ 4 * Rpower (a + (b a)) (5 / 2))) <> 0 ->
  exists p, are_the_pressures_left Es g1 (b a) p /\
  ~ agrees_in_halves 2 (fun eps => p (- b a + eps) / (a - alpha (b a - eps)))
    (fun eps => 1 / (sqrt eps * sqrt (a + (b a))) * (2 * ((P1 a) / PI) + eps * (((3 * (b1 a) ^ 2 + 2 * (b1 a) + (b2 a) * (a + (b a))) * ((P1 a) / PI) - 4 * (b1 a) * (a + (b a)) * ((P2 a) / PI)) / (3 * (b1 a) ^ 2 * (a + (b a)))) + eps ^ 2 / (60 * (b1 a) ^ 4 * (a + (b a)) ^ 2) * ((45 * (b1 a) ^ 4 + 60 * (b1 a) ^ 3 + 2 * (12 + 5 * (a + (b a)) * (b2 a)) * (b1 a) ^ 2 - 4 * (a + (b a)) * (13 * (b3 a) * (a + (b a)) - 7 * (b2 a)) * (b1 a) + 146 * (b2 a) ^ 2 * (a + (b a)) ^ 2) * ((P1 a) / PI) - 8 * (b1 a) * (a + (b a)) * (5 * (b1 a) ^ 2 + 4 * (b1 a) + 7 * (b2 a) * (a + (b a))) * ((P2 a) / PI) + 32 * (b1 a) ^ 2 * (a + (b a)) ^ 2 * ((P3 a) / PI)))).
Proof.
  intros contact left convex differ.
  edge_facts contact left.
  destruct (left_quotient_at_1 _ _ _ _ _ _ _ _ _ _ _ _ contact left) as (p & Hp & derived).
  exists p. split; [apply (the_pressures_left _ _ z); [apply convex | apply convex | exact Hp] |].
  intros printed. apply differ, Rminus_diag_eq.
  assert (polynomial : agrees_through 2 (fun eps => sqrt eps * (p (- b a + eps) / (a - alpha (b a - eps)))) (fun u => (2 * (P1 a) / (PI * sqrt (a + (b a)))) + (((2 * (b1 a) + 3 * (b1 a) ^ 2 + a * (b2 a) + (b a) * (b2 a)) * (P1 a) - 4 * (b1 a) * (a + (b a)) * (P2 a)) / (3 * PI * (b1 a) ^ 2 * Rpower (a + (b a)) (3 / 2))) * u + (((10 * a * (b2 a) * (b1 a) ^ 2 + 10 * (b a) * (b2 a) * (b1 a) ^ 2 + 146 * a ^ 2 * (b2 a) ^ 2 + 146 * (b a) ^ 2 * (b2 a) ^ 2 + 24 * (b1 a) ^ 2 + 28 * a * (b1 a) * (b2 a) + 28 * (b a) * (b1 a) * (b2 a) + 292 * a * (b a) * (b2 a) ^ 2 + 45 * (b1 a) ^ 4 + 60 * (b1 a) ^ 3 - 104 * a * (b a) * (b1 a) * (b3 a) - 52 * (b1 a) * (b3 a) * a ^ 2 - 52 * (b1 a) * (b3 a) * (b a) ^ 2) * (P1 a) - 8 * (b1 a) * (a + (b a)) * (4 * (b1 a) + 5 * (b1 a) ^ 2 + 7 * a * (b2 a) + 7 * (b a) * (b2 a)) * (P2 a) + 32 * (b1 a) ^ 2 * (a + (b a)) ^ 2 * (P3 a)) / (60 * PI * (b1 a) ^ 4 * Rpower (a + (b a)) (5 / 2))) * u ^ 2)).
  { apply (agrees_trans _ _ _ _ printed). in_half_powers. }
  destruct (unique_2 _ _ _ _ _ _ _ derived polynomial) as (E0 & E1 & E2).
  transitivity_of E2; half_powers.
Qed.

Theorem EQ48_corrected_2 (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  exists p, are_the_pressures_left Es g1 (b a) p /\
  agrees_in_halves 2 (fun eps => p (- b a + eps) / (a - alpha (b a - eps)))
    (fun eps => 2 * (P1 a) / (PI * sqrt (a + (b a))) * Rpower eps (- (1 / 2)) + ((2 * (b1 a) + 3 * (b1 a) ^ 2 + a * (b2 a) + (b a) * (b2 a)) * (P1 a) - 4 * (b1 a) * (a + (b a)) * (P2 a)) / (3 * PI * (b1 a) ^ 2 * Rpower (a + (b a)) (3 / 2)) * sqrt eps + ((10 * a * (b2 a) * (b1 a) ^ 2 + 10 * (b a) * (b2 a) * (b1 a) ^ 2 + 24 * (b1 a) ^ 2 + 26 * a ^ 2 * (b2 a) ^ 2 + 26 * (b a) ^ 2 * (b2 a) ^ 2 + 28 * a * (b1 a) * (b2 a) + 28 * (b a) * (b1 a) * (b2 a) + 45 * (b1 a) ^ 4 + 52 * a * (b a) * (b2 a) ^ 2 + 60 * (b1 a) ^ 3 - 12 * (b1 a) * (b3 a) * a ^ 2 - 12 * (b1 a) * (b3 a) * (b a) ^ 2 - 24 * a * (b a) * (b1 a) * (b3 a)) * (P1 a) - 8 * (b1 a) * (a + (b a)) * (4 * (b1 a) + 5 * (b1 a) ^ 2 + 7 * a * (b2 a) + 7 * (b a) * (b2 a)) * (P2 a) + 32 * (b1 a) ^ 2 * (a + (b a)) ^ 2 * (P3 a)) / (60 * PI * (b1 a) ^ 4 * Rpower (a + (b a)) (5 / 2)) * Rpower eps (3 / 2)).
Proof.
  intros contact left convex.
  edge_facts contact left.
  destruct (left_quotient_at_1 _ _ _ _ _ _ _ _ _ _ _ _ contact left) as (p & Hp & derived).
  exists p. split; [apply (the_pressures_left _ _ z); [apply convex | apply convex | exact Hp] |].
  apply (agrees_trans _ _ _ _ derived). in_half_powers.
Qed.

Theorem EQ48_instance_2 : exists (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R),
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 /\
  is_left_edge a b b1 b2 b3 alpha /\
  (rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a) /\
  (((10 * a * (b2 a) * (b1 a) ^ 2 + 10 * (b a) * (b2 a) * (b1 a) ^ 2 + 146 * a ^ 2 * (b2 a) ^ 2 + 146 * (b a) ^ 2 * (b2 a) ^ 2 + 24 * (b1 a) ^ 2 + 28 * a * (b1 a) * (b2 a) + 28 * (b a) * (b1 a) * (b2 a) + 292 * a * (b a) * (b2 a) ^ 2 + 45 * (b1 a) ^ 4 + 60 * (b1 a) ^ 3 - 104 * a * (b a) * (b1 a) * (b3 a) - 52 * (b1 a) * (b3 a) * a ^ 2 - 52 * (b1 a) * (b3 a) * (b a) ^ 2) * (P1 a) - 8 * (b1 a) * (a + (b a)) * (4 * (b1 a) + 5 * (b1 a) ^ 2 + 7 * a * (b2 a) + 7 * (b a) * (b2 a)) * (P2 a) + 32 * (b1 a) ^ 2 * (a + (b a)) ^ 2 * (P3 a)) / (60 * PI * (b1 a) ^ 4 * Rpower (a + (b a)) (5 / 2))) - (((10 * a * (b2 a) * (b1 a) ^ 2 + 10 * (b a) * (b2 a) * (b1 a) ^ 2 + 24 * (b1 a) ^ 2 + 26 * a ^ 2 * (b2 a) ^ 2 + 26 * (b a) ^ 2 * (b2 a) ^ 2 + 28 * a * (b1 a) * (b2 a) + 28 * (b a) * (b1 a) * (b2 a) + 45 * (b1 a) ^ 4 + 52 * a * (b a) * (b2 a) ^ 2 + 60 * (b1 a) ^ 3 - 12 * (b1 a) * (b3 a) * a ^ 2 - 12 * (b1 a) * (b3 a) * (b a) ^ 2 - 24 * a * (b a) * (b1 a) * (b3 a)) * (P1 a) - 8 * (b1 a) * (a + (b a)) * (4 * (b1 a) + 5 * (b1 a) ^ 2 + 7 * a * (b2 a) + 7 * (b a) * (b2 a)) * (P2 a) + 32 * (b1 a) ^ 2 * (a + (b a)) ^ 2 * (P3 a)) / (60 * PI * (b1 a) ^ 4 * Rpower (a + (b a)) (5 / 2))) <> 0.
Proof.
  exists_curved_contact. apply apart. curved_numbers.
Qed.

