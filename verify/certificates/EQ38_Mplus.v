(* Claim EQ38.Mplus of the ledger moore-hills, lines 390 to 393 of its source.
   Printed: M_{II}^{\pm}(d \mp \hat{x})^{3/2}
   Says: right.s2*(d - xhat)^(3/2) *)
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

Theorem EQ38_Mplus_agrees : exists s0 s1 s2,
  right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
  Rabs ((s2 * Rpower ((a + b) / 2 - (x - (a - b) / 2)) (3 / 2)) - (s2 * Rpower (a - x) (3 / 2))) <= 1 / 10 ^ 12.
Proof.
  eexists. eexists. eexists. 
  split. { apply right_shear; positive. }
  numbers constants.
Qed.
Print Assumptions EQ38_Mplus_agrees.

