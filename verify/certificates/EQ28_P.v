(* Claim EQ28.P of the ledger moore-hills, lines 300 to 302 of its source.
   Printed: P(a) = \mathcal{P}\sqrt{\gamma}a
   Says: calP*sqrt(gam)*a *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Tactics TiltedWedge Unique.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ28_P (Es phi gam a : R) : 0 < phi /\ 0 < gam /\ 0 < a ->
  exists P0,
  is_the_load Es (slope phi (tilt phi gam)) a (gam * a) P0 /\
  Es * phi * sqrt gam * a = P0.
Proof.
  intros form. assert (0 < gam * a) by (apply Rmult_lt_0_compat; lra).
  eexists. 
  split. { apply (the_load _ _ 0); [apply wedge_rises, tilt_range; positive | positive | positive | apply wedge_consistent; positive | apply wedge_load; positive]. }
  identity_of_wedge a gam.
Qed.

