(* Claim S03.M of the ledger moore-hills, lines 164 to 164 of its source.
   Printed: both $M_{I}$ and $N_{I}$ grow as $m$ increases
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

Theorem S03_M_refuted : exists r0 r1 r2,
  is_the_right_series Es (slope wedge) a r0 r1 r2 /\
  exists r0' r1' r2',
  is_the_right_series Es (slope parabola) a r0' r1' r2' /\
  364 / 10 ^ 3 <= (r1) - (r1') /\
  107 / 10 ^ 4 <= (Rabs r1) - (Rabs r1') /\
  166 / 10 ^ 3 <= (Rabs (r1 / r0) * a ^ 1) - (Rabs (r1' / r0') * a ^ 1).
Proof.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ (first wedge)); [apply punch_rises; convex constants | before constants | apply right_edge with (1 := smooth_contact Es wedge (x / 2) a ltac:(sides constants) ltac:(sides constants))]. }
    eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ (first parabola)); [apply punch_rises; convex constants | before constants | apply right_edge with (1 := smooth_contact Es parabola (x / 2) a ltac:(sides constants) ltac:(sides constants))]. }
  repeat split; numbers constants.
Qed.

