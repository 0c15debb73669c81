(* Claim EQ28.P of the ledger moore-hills, lines 300 to 302 of its source.
   Printed: P(a) = \mathcal{P}\sqrt{\gamma}a
   Says: calP*sqrt(gam)*a *)
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

Theorem EQ28_P_agrees : exists P0,
  is_the_load Es (slope phi (tilt phi gam)) a (gam * a) P0 /\
  Rabs ((Es * phi * sqrt gam * a) - (P0)) <= 1 / 10 ^ 12 * Rabs (P0).
Proof.
  eexists. 
  split. { apply (the_load _ _ 0); [apply wedge_rises, tilt_range; positive | positive | positive | apply wedge_consistent; positive | apply wedge_load; positive]. }
  apply Rminus_le. numbers constants.
Qed.
Print Assumptions EQ28_P_agrees.

