(* Claim EQ32.M of the ledger moore-hills, lines 318 to 320 of its source.
   Printed: M_{I,b} =  \frac{(2+3\gamma)\mathcal{P}}{3\pi\gamma^{2}(1+\gamma)^{3/2}a^{3/2}}
   Says: (2+3*gam)*calP/(3*Pi*gam^2*(1+gam)^(3/2)*a^(3/2)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Tactics TiltedWedge Unique.
Open Scope R_scope.

Module Correction.
Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ32_M_corrected (Es phi gam a : R) : 0 < phi /\ 0 < gam /\ 0 < a ->
  exists l0 l1 l2,
  is_the_left_series Es (slope phi (tilt phi gam)) (gam * a) l0 l1 l2 /\
  (2 + 3 * gam) * (Es * phi) / (3 * PI * Rpower gam (3 / 2) * Rpower (1 + gam) (3 / 2) * Rpower a (3 / 2)) = l1.
Proof.
  intros form. assert (0 < gam * a) by (apply Rmult_lt_0_compat; lra).
  eexists. eexists. eexists. 
  split. { apply (the_left_series _ _ 0); [apply mirrored_wedge_rises, tilt_range; positive | positive | refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ _); [apply smooth_contact | apply left_of_a]; positive]. }
  identity_of_wedge a gam.
Qed.

End Correction.
Definition EQ32_M_corrected := Correction.EQ32_M_corrected.

Definition Es : R := 1.
Definition phi : R := 1.
Definition gam : R := (1 / 9).
Definition a : R := 9.
Definition x : R := 4.
Ltac constants := unfold x, a, gam, phi, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem EQ32_M_refuted : exists l0 l1 l2,
  is_the_left_series Es (slope phi (tilt phi gam)) (gam * a) l0 l1 l2 /\
  422 / 10 ^ 3 <= Rabs (((2 + 3 * gam) * (Es * phi) / (3 * PI * gam ^ 2 * Rpower (1 + gam) (3 / 2) * Rpower a (3 / 2))) - (l1)).
Proof.
  eexists. eexists. eexists. 
  split. { apply (the_left_series _ _ 0); [apply mirrored_wedge_rises, tilt_range; positive | positive | refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ _); [apply smooth_contact | apply left_of_a]; positive]. }
  numbers constants.
Qed.

