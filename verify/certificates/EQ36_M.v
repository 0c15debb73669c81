(* Claim EQ36.M of the ledger moore-hills, lines 378 to 381 of its source.
   Printed: (a-x)^{3/2}\left[\frac{1}{\sqrt{a+b}}\left(\frac{3Q}{8\pi(a+b)^{2}} - \frac{5\sigma_{0}}{64(a+b)}\right)\right]
   Says: 1/sqrt(a+b)*(3*Q/(8*Pi*(a+b)^2) - 5*sig0/(64*(a+b))) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique Stick.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ36_M (a b Q sig0 : R) : 0 < a + b ->
  exists s0 s1 s2,
  is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
  1 / sqrt (a + b) * (3 * Q / (8 * PI * (a + b) ^ 2) - 5 * sig0 / (64 * (a + b))) = s2.
Proof.
  intros form.
  eexists. eexists. eexists. 
  split. { apply the_right_shear_series, right_shear; positive. }
  identity_of_shear a b.
Qed.

