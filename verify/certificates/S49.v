(* Claim S49 of the ledger moore-hills, lines 404 to 409 of its source.
   Printed: it follows that the first order solution has its maximum fidelity when $L_{II}=0$,
i.e. at the left hand contact edge when
\begin{equation}
\frac{\sigma_{0}d}{Q}=\frac{4}{3\pi},
   Says: 4/(3*Pi) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique.
Open Scope R_scope.

Definition a : R := 4.
Definition Q : R := 1.
Definition x : R := 2.
Definition b : R := 1.
Definition sig0 : R := (4 / (3 * PI)) * Q / ((a + b) / 2).
Definition sig0_corrected : R := (- (4 / (3 * PI))) * Q / ((a + b) / 2).
Ltac constants := unfold sig0_corrected, sig0, b, x, Q, a in *.
Ltac positive := constants; repeat split; lra.

Theorem S49_refuted : exists v0 v1 v2,
  is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
  284 / 10 ^ 4 <= Rabs (v1).
Proof.
  eexists. eexists. eexists. 
  split. { apply the_left_shear_series, left_shear; positive. }
  numbers constants.
Qed.

Theorem S49_corrected : exists v0 v1 v2,
  is_the_left_shear_series (full_stick Q sig0_corrected a b) b v0 v1 v2 /\
  v1 = 0.
Proof.
  eexists. eexists. eexists. 
  split. { apply the_left_shear_series, left_shear; positive. }
  vanishes constants.
Qed.

