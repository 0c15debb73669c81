(* Claim EQ28.gamma of the ledger moore-hills, lines 300 to 302 of its source.
   Printed: \gamma = \left(1-\sin\left(\frac{\pi\alpha}{2\phi}\right)\right)\left(1 + \sin\left(\frac{\pi\alpha}{2\phi}\right)\right)^{-1}
   Says: (1-sin(Pi*alpha/(2*phi)))*(1+sin(Pi*alpha/(2*phi)))^(-1) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Tactics TiltedWedge Unique.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ28_gamma (Es phi gam a : R) : 0 < phi /\ 0 < gam /\ 0 < a ->
  
  is_the_left_edge (slope phi (tilt phi gam)) a (gam * a) /\
  (1 - sin (PI * (tilt phi gam) / (2 * phi))) * (/ (1 + sin (PI * (tilt phi gam) / (2 * phi))) ^ 1) = (gam * a) / a.
Proof.
  intros form. assert (0 < gam * a) by (apply Rmult_lt_0_compat; lra).
  split. { apply (the_left_edge _ 0); [apply wedge_rises, tilt_range; positive | positive | positive | apply wedge_consistent; positive]. }
  identity_of_wedge a gam.
Qed.

