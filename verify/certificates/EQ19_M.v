(* Claim EQ19.M of the ledger moore-hills, lines 213 to 217 of its source.
   Printed: M_{I} & \, = && \, \frac{-E^{*}}{2\sqrt{2a}\pi R}\left(\frac{\pi}{2} - \mbox{arcsin}\frac{t}{a} + \frac{8t}{3\sqrt{a^{2}-t^{2}}}\right),\\
   Says: -Es/(2*sqrt(2*a)*Pi*R)*(Pi/2 - asin(t/a) + 8*t/(3*sqrt(a^2-t^2))) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics FlatAndRounded.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ19_M (Es t R0 a : R) : 0 < t < a /\ 0 < R0 ->
  exists r0 r1 r2,
  is_the_right_series Es (slope (cons (Part t 0 (1 / R0)) nil)) a r0 r1 r2 /\
  - Es / (2 * sqrt (2 * a) * PI * R0) * (PI / 2 - asin (t / a) + 8 * t / (3 * sqrt (a ^ 2 - t ^ 2))) = r1.
Proof.
  intros form. assert (0 < 1 / R0) by (apply Rdiv_lt_0_compat; lra).
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ (first (cons (Part t 0 (1 / R0)) nil))); [apply punch_rises; convex constants | before constants | apply right_edge with (1 := smooth_contact Es (cons (Part t 0 (1 / R0)) nil) ((t + a) / 2) a ltac:(sides constants) ltac:(sides constants))]. }
  identity_of_rounded t a.
Qed.

