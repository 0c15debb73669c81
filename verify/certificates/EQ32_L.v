(* Claim EQ32.L of the ledger moore-hills, lines 318 to 320 of its source.
   Printed: L_{I,b} = \frac{2\mathcal{P}}{\pi\gamma\sqrt{1+\gamma}\sqrt{a}}
   Says: 2*calP/(Pi*gam*sqrt(1+gam)*sqrt(a)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Tactics TiltedWedge Unique.
Open Scope R_scope.

Module Correction.
Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ32_L_corrected (Es phi gam a : R) : 0 < phi /\ 0 < gam /\ 0 < a ->
  exists l0 l1 l2,
  is_the_left_series Es (slope phi (tilt phi gam)) (gam * a) l0 l1 l2 /\
  2 * (Es * phi) / (PI * sqrt gam * sqrt (1 + gam) * sqrt a) = l0.
Proof.
  intros form. assert (0 < gam * a) by (apply Rmult_lt_0_compat; lra).
  eexists. eexists. eexists. 
  split. { apply (the_left_series _ _ 0); [apply mirrored_wedge_rises, tilt_range; positive | positive | refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ _); [apply smooth_contact | apply left_of_a]; positive]. }
  identity_of_wedge a gam.
Qed.

End Correction.
Definition EQ32_L_corrected := Correction.EQ32_L_corrected.

Definition Es : R := 1.
Definition phi : R := 1.
Definition gam : R := (1 / 9).
Definition a : R := 9.
Definition x : R := 4.
Ltac constants := unfold x, a, gam, phi, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem EQ32_L_refuted : exists l0 l1 l2,
  is_the_left_series Es (slope phi (tilt phi gam)) (gam * a) l0 l1 l2 /\
  120 / 10 ^ 2 <= Rabs ((2 * (Es * phi) / (PI * gam * sqrt (1 + gam) * sqrt a)) - (l0)).
Proof.
  eexists. eexists. eexists. 
  split. { apply (the_left_series _ _ 0); [apply mirrored_wedge_rises, tilt_range; positive | positive | refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ _); [apply smooth_contact | apply left_of_a]; positive]. }
  numbers constants.
Qed.

