(* Claim EQ34.strain of the ledger moore-hills, lines 368 to 371 of its source.
   Printed: q(x) = \frac{Q}{\pi\sqrt{(a-x)(x+b)}} + \frac{\sigma_{0}(2x+b-a)}{8\sqrt{(a-x)(x+b)}} \; \mbox{for} \; -b<x<a.
   Says: pv((Q/(Pi*sqrt((a-s)*(s+b))) + sig0*(2*s+b-a)/(8*sqrt((a-s)*(s+b))))/(s-x), s, -b, a, x) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique Stick.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ34_strain (a b Q sig0 x : R) : 0 < a + b /\ - b < x < a ->
  exists l0,
  is_principal_value (fun s => (Q / (PI * sqrt ((a - s) * (s + b))) + sig0 * (2 * s + b - a) / (8 * sqrt ((a - s) * (s + b)))) / (s - x)) (- b) (a) (x) l0 /\
  l0 = PI * sig0 / 4.
Proof.
  intros form.
  eexists. 
  split. { apply strain_of_traction; lra. }
  identity_of_shear a b.
Qed.

