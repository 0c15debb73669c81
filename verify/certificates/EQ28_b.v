(* Claim EQ28.b of the ledger moore-hills, lines 300 to 302 of its source.
   Printed: b(a) = \gamma a
   Says: gam*a *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Tactics TiltedWedge Unique.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ28_b (Es phi gam a : R) : 0 < phi /\ 0 < gam /\ 0 < a ->
  
  is_the_left_edge (slope phi (tilt phi gam)) a (gam * a) /\
  gam * a = (gam * a).
Proof.
  intros form. assert (0 < gam * a) by (apply Rmult_lt_0_compat; lra).
  split. { apply (the_left_edge _ 0); [apply wedge_rises, tilt_range; positive | positive | positive | apply wedge_consistent; positive]. }
  identity_of_wedge a gam.
Qed.

