(* Claim EQ38.Lminus of the ledger moore-hills, lines 390 to 393 of its source.
   Printed: L_{II}^{\pm}\sqrt{d\pm \hat{x}}
   Says: left.s1*sqrt(d - xhat) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique.
Open Scope R_scope.

Definition a : R := 4.
Definition Q : R := 1.
Definition x : R := 2.
Definition b : R := 1.
Definition sig0 : R := 1.
Ltac constants := unfold sig0, b, x, Q, a in *.
Ltac positive := constants; repeat split; lra.

Theorem EQ38_Lminus_refuted : exists v0 v1 v2,
  is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
  311 / 10 ^ 4 <= Rabs ((v1 * sqrt ((a + b) / 2 - (x - (a - b) / 2))) - (v1 * sqrt (b + x))).
Proof.
  eexists. eexists. eexists. 
  split. { apply the_left_shear_series, left_shear; positive. }
  numbers constants.
Qed.

