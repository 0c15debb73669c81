(* Claim EQ36.L of the ledger moore-hills, lines 378 to 381 of its source.
   Printed: \sqrt{a-x}\left[\frac{1}{\sqrt{a+b}}\left(\frac{Q}{2\pi(a+b)} - \frac{3\sigma_{0}}{16}\right)\right]
   Says: 1/sqrt(a+b)*(Q/(2*Pi*(a+b)) - 3*sig0/16) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique Stick.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ36_L (a b Q sig0 : R) : 0 < a + b ->
  exists s0 s1 s2,
  is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
  1 / sqrt (a + b) * (Q / (2 * PI * (a + b)) - 3 * sig0 / 16) = s1.
Proof.
  intros form.
  eexists. eexists. eexists. 
  split. { apply the_right_shear_series, right_shear; positive. }
  identity_of_shear a b.
Qed.

