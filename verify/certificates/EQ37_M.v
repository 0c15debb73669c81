(* Claim EQ37.M of the ledger moore-hills, lines 383 to 386 of its source.
   Printed: (b+x)^{3/2}\left[\frac{1}{\sqrt{a+b}}\left(\frac{3Q}{8\pi(a+b)^{2}} + \frac{5\sigma_{0}}{64(a+b)}\right)\right]
   Says: 1/sqrt(a+b)*(3*Q/(8*Pi*(a+b)^2) + 5*sig0/(64*(a+b))) *)
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

Theorem EQ37_M_agrees : exists v0 v1 v2,
  is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
  Rabs ((1 / sqrt (a + b) * (3 * Q / (8 * PI * (a + b) ^ 2) + 5 * sig0 / (64 * (a + b)))) - (v2)) <= 1 / 10 ^ 12 * Rabs (v2).
Proof.
  eexists. eexists. eexists. 
  split. { apply the_left_shear_series, left_shear; positive. }
  apply Rminus_le. numbers constants.
Qed.
Print Assumptions EQ37_M_agrees.

