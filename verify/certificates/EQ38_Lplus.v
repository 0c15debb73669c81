(* Claim EQ38.Lplus of the ledger moore-hills, lines 390 to 393 of its source.
   Printed: L_{II}^{\pm}\sqrt{d\pm \hat{x}}
   Says: right.s1*sqrt(d + xhat) *)
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

Theorem EQ38_Lplus_refuted : exists s0 s1 s2,
  is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
  221 / 10 ^ 4 <= Rabs ((s1 * sqrt ((a + b) / 2 + (x - (a - b) / 2))) - (s1 * sqrt (a - x))).
Proof.
  eexists. eexists. eexists. 
  split. { apply the_right_shear_series, right_shear; positive. }
  numbers constants.
Qed.

