(* Claim EQ34.force of the ledger moore-hills, lines 368 to 371 of its source.
   Printed: q(x) = \frac{Q}{\pi\sqrt{(a-x)(x+b)}} + \frac{\sigma_{0}(2x+b-a)}{8\sqrt{(a-x)(x+b)}} \; \mbox{for} \; -b<x<a.
   Says: integral(Q/(Pi*sqrt((a-s)*(s+b))) + sig0*(2*s+b-a)/(8*sqrt((a-s)*(s+b))), s, -b, a) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique Stick.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ34_force (a b Q sig0 : R) : 0 < a + b ->
  exists l0,
  is_integral_between (fun s => Q / (PI * sqrt ((a - s) * (s + b))) + sig0 * (2 * s + b - a) / (8 * sqrt ((a - s) * (s + b)))) (- b) (a) l0 /\
  l0 = Q.
Proof.
  intros form.
  eexists. 
  split. { apply force_of_traction; lra. }
  identity_of_shear a b.
Qed.

