(* Claim EQ19.N of the ledger moore-hills, lines 213 to 217 of its source.
   Printed: N_{I} & \, = && \,-\frac{E^{*}}{16\sqrt{2}a^{3/2}\pi R}\left(\frac{\pi}{2}-\mbox{arcsin}\frac{t}{a} + \frac{16t}{5(a^{2}-t^{2})^{3/2}}\left(3a^{2} - \frac{t^{2}}{3}\right)\right).
   Says: -(Es/(16*sqrt(2)*a^(3/2)*Pi*R)*(Pi/2 - asin(t/a) + 16*t/(5*(a^2-t^2)^(3/2))*(3*a^2 - t^2/3))) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics FlatAndRounded.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ19_N (Es t R0 a : R) : 0 < t < a /\ 0 < R0 ->
  exists r0 r1 r2,
  is_the_right_series Es (slope (cons (Part t 0 (1 / R0)) nil)) a r0 r1 r2 /\
  - (Es / (16 * sqrt 2 * Rpower a (3 / 2) * PI * R0) * (PI / 2 - asin (t / a) + 16 * t / (5 * Rpower (a ^ 2 - t ^ 2) (3 / 2)) * (3 * a ^ 2 - t ^ 2 / 3))) = r2.
Proof.
  intros form. assert (0 < 1 / R0) by (apply Rdiv_lt_0_compat; lra).
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ (first (cons (Part t 0 (1 / R0)) nil))); [apply punch_rises; convex constants | before constants | apply right_edge with (1 := smooth_contact Es (cons (Part t 0 (1 / R0)) nil) ((t + a) / 2) a ltac:(sides constants) ltac:(sides constants))]. }
  identity_of_rounded t a.
Qed.

