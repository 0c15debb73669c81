(* Claim EQ39.Mplus of the ledger moore-hills, lines 395 to 400 of its source.
   Printed: M_{II}^{\pm} = \frac{1}{\sqrt{2d}}\left(\frac{3Q}{32\pi d^{2}} \mp \frac{5\sigma_{0}}{128d}\right)
   Says: 1/sqrt(2*d)*(3*Q/(32*Pi*d^2) - 5*sig0/(128*d)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique Stick.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ39_Mplus (a b Q sig0 : R) : 0 < a + b ->
  exists s0 s1 s2,
  is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
  1 / sqrt (2 * ((a + b) / 2)) * (3 * Q / (32 * PI * ((a + b) / 2) ^ 2) - 5 * sig0 / (128 * ((a + b) / 2))) = s2.
Proof.
  intros form.
  eexists. eexists. eexists. 
  split. { apply the_right_shear_series, right_shear; positive. }
  identity_of_shear a b.
Qed.

