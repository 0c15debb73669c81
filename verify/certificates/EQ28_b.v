(* Claim EQ28.b of the ledger moore-hills, lines 300 to 302 of its source.
   Printed: b(a) = \gamma a
   Says: gam*a *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Tactics TiltedWedge Unique.
Open Scope R_scope.

Definition Es : R := 1.
Definition phi : R := 1.
Definition gam : R := (1 / 4).
Definition a : R := 1.
Definition x : R := (1 / 2).
Ltac constants := unfold x, a, gam, phi, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem EQ28_b_agrees : 
  is_the_left_edge (slope phi (tilt phi gam)) a (gam * a) /\
  Rabs ((gam * a) - ((gam * a))) <= 1 / 10 ^ 12 * Rabs ((gam * a)).
Proof.
  split. { apply (the_left_edge _ 0); [apply wedge_rises, tilt_range; positive | positive | positive | apply wedge_consistent; positive]. }
  apply Rminus_le. numbers constants.
Qed.
Print Assumptions EQ28_b_agrees.

