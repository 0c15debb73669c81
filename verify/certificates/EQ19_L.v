(* Claim EQ19.L of the ledger moore-hills, lines 213 to 217 of its source.
   Printed: L_{I} & \, = && \, \frac{\sqrt{2a}E^{*}}{\pi R}\left(\frac{\pi}{2} - \mathrm{arcsin}\frac{t}{a}\right),\\
   Says: sqrt(2*a)*Es/(Pi*R)*(Pi/2 - asin(t/a)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics FlatAndRounded.
Open Scope R_scope.

Definition Es : R := 1.
Definition t : R := 1.
Definition R0 : R := 1.
Definition a : R := 2.
Definition x : R := (3 / 2).
Definition punch : list part := cons (Part t 0 (1 / R0)) nil.
Ltac constants := unfold punch, x, a, R0, t, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem EQ19_L_agrees : exists r0 r1 r2,
  is_the_right_series Es (slope punch) a r0 r1 r2 /\
  Rabs ((sqrt (2 * a) * Es / (PI * R0) * (PI / 2 - asin (t / a))) - (r0)) <= 1 / 10 ^ 12 * Rabs (r0).
Proof.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ (first punch)); [apply punch_rises; convex constants | before constants | apply right_edge with (1 := smooth_contact Es punch ((t + x) / 2) a ltac:(sides constants) ltac:(sides constants))]. }
  apply Rminus_le. numbers constants.
Qed.
Print Assumptions EQ19_L_agrees.

