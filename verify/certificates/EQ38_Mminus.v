(* Claim EQ38.Mminus of the ledger moore-hills, lines 390 to 393 of its source.
   Printed: M_{II}^{\pm}(d \mp \hat{x})^{3/2}
   Says: left.s2*(d + xhat)^(3/2) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear.
Open Scope R_scope.

Definition a : R := 4.
Definition Q : R := 1.
Definition x : R := 2.
Definition b : R := 1.
Definition sig0 : R := 1.
Ltac constants := unfold sig0, b, x, Q, a in *.
Ltac positive := constants; repeat split; lra.

Theorem EQ38_Mminus_agrees : exists v0 v1 v2,
  left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
  Rabs ((v2 * Rpower ((a + b) / 2 + (x - (a - b) / 2)) (3 / 2)) - (v2 * Rpower (b + x) (3 / 2))) <= 1 / 10 ^ 12.
Proof.
  eexists. eexists. eexists. 
  split. { apply left_shear; positive. }
  numbers constants.
Qed.
Print Assumptions EQ38_Mminus_agrees.

