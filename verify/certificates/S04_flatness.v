(* Claim S04.flatness of the ledger moore-hills, lines 164 to 164 of its source.
   Printed: the error in the one-term approximation $p \sim L_{I}\sqrt{a-x}$ increases with both distance from the contact edge and the flatness of the indenter as characterized by $m$ in (\ref{eqn:PowerLaw_Profile}).
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics.
Open Scope R_scope.

Definition Es : R := 1.
Definition C : R := 1.
Definition a : R := 1.
Definition x : R := (1 / 2).
Definition wedge : list part := cons (Part 0 C 0) nil.
Definition parabola : list part := cons (Part 0 0 C) nil.
Ltac constants := unfold parabola, wedge, x, a, C, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem S04_flatness_refuted : exists p0 r0 r1 r2,
  is_the_pressure Es (slope wedge) a x p0 /\
  is_the_right_series Es (slope wedge) a r0 r1 r2 /\
  exists p0' r0' r1' r2',
  is_the_pressure Es (slope parabola) a x p0' /\
  is_the_right_series Es (slope parabola) a r0' r1' r2' /\
  859 / 10 ^ 4 <= (Rabs (1 - (r0 * ((a - x) ^ 0 * sqrt (a - x))) / p0)) - (Rabs (1 - (r0' * ((a - x) ^ 0 * sqrt (a - x))) / p0')).
Proof.
  eexists. eexists. eexists. eexists. 
  split. { apply (the_pressure _ _ (first wedge)); [apply punch_rises; convex constants | before constants | apply (pressure Es wedge (x / 2)); sides constants]. }
  split. { apply (the_right_series _ _ (first wedge)); [apply punch_rises; convex constants | before constants | apply right_edge with (1 := smooth_contact Es wedge (x / 2) a ltac:(sides constants) ltac:(sides constants))]. }
    eexists. eexists. eexists. eexists. 
  split. { apply (the_pressure _ _ (first parabola)); [apply punch_rises; convex constants | before constants | apply (pressure Es parabola (x / 2)); sides constants]. }
  split. { apply (the_right_series _ _ (first parabola)); [apply punch_rises; convex constants | before constants | apply right_edge with (1 := smooth_contact Es parabola (x / 2) a ltac:(sides constants) ltac:(sides constants))]. }
  repeat split; numbers constants.
Qed.

