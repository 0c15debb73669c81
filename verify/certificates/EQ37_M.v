(* Claim EQ37.M of the ledger moore-hills, lines 383 to 386 of its source.
   Printed: (b+x)^{3/2}\left[\frac{1}{\sqrt{a+b}}\left(\frac{3Q}{8\pi(a+b)^{2}} + \frac{5\sigma_{0}}{64(a+b)}\right)\right]
   Says: 1/sqrt(a+b)*(3*Q/(8*Pi*(a+b)^2) + 5*sig0/(64*(a+b))) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique Stick.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ37_M (a b Q sig0 : R) : 0 < a + b ->
  exists v0 v1 v2,
  is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
  1 / sqrt (a + b) * (3 * Q / (8 * PI * (a + b) ^ 2) + 5 * sig0 / (64 * (a + b))) = v2.
Proof.
  intros form.
  eexists. eexists. eexists. 
  split. { apply the_left_shear_series, left_shear; positive. }
  identity_of_shear a b.
Qed.

