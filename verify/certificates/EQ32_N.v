(* Claim EQ32.N of the ledger moore-hills, lines 318 to 320 of its source.
   Printed: N_{I,b} = \frac{(8+20\gamma+15\gamma^{2})\mathcal{P}}{20\pi\gamma^{3}(1+\gamma)^{5/2}a^{5/2}}
   Says: (8+20*gam+15*gam^2)*calP/(20*Pi*gam^3*(1+gam)^(5/2)*a^(5/2)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Tactics TiltedWedge Unique.
Open Scope R_scope.

Module Correction.
Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ32_N_corrected (Es phi gam a : R) : 0 < phi /\ 0 < gam /\ 0 < a ->
  exists l0 l1 l2,
  is_the_left_series Es (slope phi (tilt phi gam)) (gam * a) l0 l1 l2 /\
  (8 + 20 * gam + 15 * gam ^ 2) * (Es * phi) / (20 * PI * Rpower gam (5 / 2) * Rpower (1 + gam) (5 / 2) * Rpower a (5 / 2)) = l2.
Proof.
  intros form. assert (0 < gam * a) by (apply Rmult_lt_0_compat; lra).
  eexists. eexists. eexists. 
  split. { apply (the_left_series _ _ 0); [apply mirrored_wedge_rises, tilt_range; positive | positive | refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ _); [apply smooth_contact | apply left_of_a]; positive]. }
  identity_of_wedge a gam.
Qed.

End Correction.
Definition EQ32_N_corrected := Correction.EQ32_N_corrected.

Definition Es : R := 1.
Definition phi : R := 1.
Definition gam : R := (1 / 9).
Definition a : R := 9.
Definition x : R := 4.
Ltac constants := unfold x, a, gam, phi, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem EQ32_N_refuted : exists l0 l1 l2,
  is_the_left_series Es (slope phi (tilt phi gam)) (gam * a) l0 l1 l2 /\
  254 / 10 ^ 3 <= Rabs (((8 + 20 * gam + 15 * gam ^ 2) * (Es * phi) / (20 * PI * gam ^ 3 * Rpower (1 + gam) (5 / 2) * Rpower a (5 / 2))) - (l2)).
Proof.
  eexists. eexists. eexists. 
  split. { apply (the_left_series _ _ 0); [apply mirrored_wedge_rises, tilt_range; positive | positive | refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ _); [apply smooth_contact | apply left_of_a]; positive]. }
  numbers constants.
Qed.

