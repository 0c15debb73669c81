(* Claim EQ19.M of the ledger moore-hills, lines 213 to 217 of its source.
   Printed: M_{I} & \, = && \, \frac{-E^{*}}{2\sqrt{2a}\pi R}\left(\frac{\pi}{2} - \mbox{arcsin}\frac{t}{a} + \frac{8t}{3\sqrt{a^{2}-t^{2}}}\right),\\
   Says: -Es/(2*sqrt(2*a)*Pi*R)*(Pi/2 - asin(t/a) + 8*t/(3*sqrt(a^2-t^2))) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics FlatAndRounded.
Open Scope R_scope.

Definition Es : R := 1.
Definition t : R := 1.
Definition R0 : R := 1.
Definition a : R := 2.
Definition x : R := (3 / 2).
Ltac constants := unfold Es, t, R0, a, x in *.
Ltac positive := constants; repeat split; lra.

Theorem EQ19_M_agrees : exists r0 r1 r2,
  right_edge_series Es (slope t R0) a r0 r1 r2 /\
  Rabs ((- Es / (2 * sqrt (2 * a) * PI * R0) * (PI / 2 - asin (t / a) + 8 * t / (3 * sqrt (a ^ 2 - t ^ 2)))) - (r1)) <= 1 / 10 ^ 12.
Proof.
  eexists. eexists. eexists. 
  split. { eapply right_edge, smooth_contact; positive. }
  unfold c0, c1, c2, load_rate, load_rate_2, load_rate_3; numbers constants.
Qed.
Print Assumptions EQ19_M_agrees.

