(* Claim EQ37.K of the ledger moore-hills, lines 383 to 386 of its source.
   Printed: \frac{1}{\sqrt{b+x}}\left[\frac{1}{\sqrt{a+b}}\left(\frac{Q}{\pi} - \frac{\sigma_{0}(a+b)}{8}\right)\right]
   Says: 1/sqrt(a+b)*(Q/Pi - sig0*(a+b)/8) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique Stick.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ37_K (a b Q sig0 : R) : 0 < a + b ->
  exists v0 v1 v2,
  is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
  1 / sqrt (a + b) * (Q / PI - sig0 * (a + b) / 8) = v0.
Proof.
  intros form.
  eexists. eexists. eexists. 
  split. { apply the_left_shear_series, left_shear; positive. }
  identity_of_shear a b.
Qed.

