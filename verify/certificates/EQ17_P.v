(* Claim EQ17.P of the ledger moore-hills, lines 200 to 206 of its source.
   Printed: \displaystyle{\frac{E^{*}a^{2}}{R}\left(\frac{\pi}{4} - \frac{1}{2}\mathrm{arcsin}\frac{t}{a} - \frac{t}{2a^{2}}\sqrt{a^{2}-t^{2}}\right)} & \mbox{for} \; a>t
   Says: Es*a^2/R*(Pi/4 - 1/2*asin(t/a) - t/(2*a^2)*sqrt(a^2-t^2)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics FlatAndRounded.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ17_P (Es t R0 a : R) : 0 < t < a /\ 0 < R0 ->
  exists P0,
  is_the_load Es (slope (cons (Part t 0 (1 / R0)) nil)) a a P0 /\
  Es * a ^ 2 / R0 * (PI / 4 - 1 / 2 * asin (t / a) - t / (2 * a ^ 2) * sqrt (a ^ 2 - t ^ 2)) = P0.
Proof.
  intros form. assert (0 < 1 / R0) by (apply Rdiv_lt_0_compat; lra).
  eexists. 
  split. { apply (the_load _ _ (first (cons (Part t 0 (1 / R0)) nil))); [apply punch_rises; convex constants | before constants | before constants | apply consistent_total; sides constants | apply load_total; sides constants]. }
  identity_of_rounded t a.
Qed.

