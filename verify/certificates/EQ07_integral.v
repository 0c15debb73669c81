(* Claim EQ07.integral of the ledger moore-hills, lines 115 to 118 of its source.
   Printed:  p(a-\ve X) & \, = && \, \frac{\sqrt{\ve}}{\sqrt{2a}\pi}\int_{0}^{X} \frac{1}{\sqrt{X-S}}\left[P'(a) + \ve\left(\frac{P'(a)}{a}(X+S) - SP''(a)\right) + \right. \nonumber \\
 & \, && \, \left. \ve^{2}\left(\frac{3P'(a)}{32a^{2}}(X+S)^{2} - \frac{SP''(a)}{4a}(X+S) + \frac{S^{2}P'''(a)}{2}\right) + O(\ve^{3})\right] \,\mbox{d}S,
   Says: sqrt(eps)/(sqrt(2*a)*Pi)*integral(1/sqrt(X-S)*(P1 + eps*(P1/a*(X+S) - S*P2) + eps^2*(3*P1/(32*a^2)*(X+S)^2 - S*P2/(4*a)*(X+S) + S^2*P3/2)), S, 0, X) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics Expansions HalfPowers PressureExpansions Curved.
Open Scope R_scope.

Theorem EQ07_integral_refuted (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) (y : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) ->
  rises_at g1 y /\ y < a ->
  forall X : R, 0 < X ->
  (Rpower X (3 / 2) * sqrt 2 * (5 * (P1 a) - 2 * a * (P2 a)) / (3 * PI * Rpower a (3 / 2))) - (Rpower X (3 / 2) * sqrt 2 * (5 * (P1 a) - 8 * a * (P2 a)) / (12 * PI * Rpower a (3 / 2))) <> 0 ->
  exists p, are_the_pressures_right Es g1 a p /\
  forall I, (forall eps, 0 < eps -> is_integral_up_to (fun S => 1 / sqrt (X - S) * ((P1 a) + eps * ((P1 a) / a * (X + S) - S * (P2 a)) + eps ^ 2 * (3 * (P1 a) / (32 * a ^ 2) * (X + S) ^ 2 - S * (P2 a) / (4 * a) * (X + S) + S ^ 2 * (P3 a) / 2))) 0 X (I eps)) ->
  ~ agrees_in_halves 3 (fun eps => p (a - eps * X))
    (fun eps => sqrt eps / (sqrt (2 * a) * PI) * (I eps)).
Proof.
  intros contact convex X HX differ.
  symmetric_facts contact.
  destruct (right_pressure_through_3 _ _ _ _ _ _ _ X contact HX) as (p & Hp & derived).
  exists p. split; [apply (the_pressures_right _ _ y); [apply convex | apply convex | exact Hp] |].
  intros I HI.
  intros printed. apply differ, Rminus_diag_eq.
  assert (polynomial : agrees_through 3 (fun eps => sqrt eps * (p (a - eps * X))) (fun u => (0) + ((P1 a) * sqrt 2 * sqrt X / (PI * sqrt a)) * u + (Rpower X (3 / 2) * sqrt 2 * (5 * (P1 a) - 2 * a * (P2 a)) / (3 * PI * Rpower a (3 / 2))) * u ^ 2 + (Rpower X (5 / 2) * sqrt 2 * (129 * (P1 a) - 144 * a * (P2 a) + 128 * a ^ 2 * (P3 a)) / (480 * PI * Rpower a (5 / 2))) * u ^ 3)).
  { apply (agrees_trans _ _ _ _ printed). with_integral HI. half_powers. }
  destruct (unique_3 _ _ _ _ _ _ _ _ _ derived polynomial) as (E0 & E1 & E2 & E3).
  transitivity_of E2; half_powers.
Qed.

Theorem EQ07_integral_corrected (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) (y : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) ->
  rises_at g1 y /\ y < a ->
  forall X : R, 0 < X ->
  exists p, are_the_pressures_right Es g1 a p /\
  agrees_in_halves 3 (fun eps => p (a - eps * X))
    (fun eps => (P1 a) * sqrt 2 * sqrt X / (PI * sqrt a) * sqrt eps + Rpower X (3 / 2) * sqrt 2 * (5 * (P1 a) - 8 * a * (P2 a)) / (12 * PI * Rpower a (3 / 2)) * Rpower eps (3 / 2) + Rpower X (5 / 2) * sqrt 2 * (129 * (P1 a) - 144 * a * (P2 a) + 128 * a ^ 2 * (P3 a)) / (480 * PI * Rpower a (5 / 2)) * Rpower eps (5 / 2)).
Proof.
  intros contact convex X HX.
  symmetric_facts contact.
  destruct (right_pressure_through_3 _ _ _ _ _ _ _ X contact HX) as (p & Hp & derived).
  exists p. split; [apply (the_pressures_right _ _ y); [apply convex | apply convex | exact Hp] |].
  apply (agrees_trans _ _ _ _ derived). in_half_powers.
Qed.

Theorem EQ07_integral_instance : exists (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) (y : R),
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) /\
  (rises_at g1 y /\ y < a) /\
  exists X : R, 0 < X /\
  (Rpower X (3 / 2) * sqrt 2 * (5 * (P1 a) - 2 * a * (P2 a)) / (3 * PI * Rpower a (3 / 2))) - (Rpower X (3 / 2) * sqrt 2 * (5 * (P1 a) - 8 * a * (P2 a)) / (12 * PI * Rpower a (3 / 2))) <> 0.
Proof.
  exists 1, (slope wedge), 1, (load 1 wedge), (rate 1 wedge), (rate_2 1 wedge), (rate_3 1 wedge), (first wedge).
  split; [apply (smooth_contact 1 wedge (1 / 2) 1); sides ltac:(unfold wedge) |].
  split; [split; [apply punch_rises; convex ltac:(unfold wedge) | before ltac:(unfold wedge)] |].
  exists 1. split; [lra |]. apply apart. numbers ltac:(unfold wedge).
Qed.

