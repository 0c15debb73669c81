(* Claim EQ39.Lminus of the ledger moore-hills, lines 395 to 400 of its source.
   Printed: L_{II}^{\pm} = \frac{1}{\sqrt{2d}}\left(\frac{Q}{4\pi d} \mp \frac{3\sigma_{0}}{16}\right)
   Says: 1/sqrt(2*d)*(Q/(4*Pi*d) + 3*sig0/16) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique Stick.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ39_Lminus (a b Q sig0 : R) : 0 < a + b ->
  exists v0 v1 v2,
  is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
  1 / sqrt (2 * ((a + b) / 2)) * (Q / (4 * PI * ((a + b) / 2)) + 3 * sig0 / 16) = v1.
Proof.
  intros form.
  eexists. eexists. eexists. 
  split. { apply the_left_shear_series, left_shear; positive. }
  identity_of_shear a b.
Qed.

