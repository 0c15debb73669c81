(* Claim EQ38.Kplus of the ledger moore-hills, lines 390 to 393 of its source.
   Printed: \frac{K_{II}^{\pm}}{\sqrt{d \mp \hat{x}}}
   Says: right.s0/sqrt(d - xhat) *)
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

Theorem EQ38_Kplus_agrees : exists s0 s1 s2,
  right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
  Rabs ((s0 / sqrt ((a + b) / 2 - (x - (a - b) / 2))) - (s0 / sqrt (a - x))) <= 1 / 10 ^ 12.
Proof.
  eexists. eexists. eexists. 
  split. { apply right_shear; positive. }
  numbers constants.
Qed.
Print Assumptions EQ38_Kplus_agrees.

