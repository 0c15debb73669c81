(* Claim S53.equation of the ledger moore-hills, lines 411 to 411 of its source.
   Printed: Finally, we emphasize that the results of this section are independent of the contact geometry.
   Says: pv(q(s)/(s-x), s, -b, a, x) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique Stick.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem S53_equation (a b Q sig0 x : R) : 0 < a + b /\ - b < x < a ->
  exists l0,
  is_principal_value (fun s => (full_stick Q sig0 a b s) / (s - x)) (- b) (a) (x) l0 /\
  l0 = PI * sig0 / 4.
Proof.
  intros form.
  eexists. 
  split. { apply strain_of_traction; lra. }
  identity_of_shear a b.
Qed.

