(* Claim EQ39.Kplus of the ledger moore-hills, lines 395 to 400 of its source.
   Printed: K_{II}^{\pm} = \frac{1}{\sqrt{2d}}\left(\frac{Q}{\pi} \pm \frac{\sigma_{0}d}{4}\right)
   Says: 1/sqrt(2*d)*(Q/Pi + sig0*d/4) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique Stick.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ39_Kplus (a b Q sig0 : R) : 0 < a + b ->
  exists s0 s1 s2,
  is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
  1 / sqrt (2 * ((a + b) / 2)) * (Q / PI + sig0 * ((a + b) / 2) / 4) = s0.
Proof.
  intros form.
  eexists. eexists. eexists. 
  split. { apply the_right_shear_series, right_shear; positive. }
  identity_of_shear a b.
Qed.

