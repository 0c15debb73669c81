(* Claim EQ30.L of the ledger moore-hills, lines 310 to 312 of its source.
   Printed: L_{I,a} = \frac{2\mathcal{P}}{\pi\sqrt{1+\gamma}\sqrt{a}}
   Says: 2*calP/(Pi*sqrt(1+gam)*sqrt(a)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Tactics TiltedWedge Unique.
Open Scope R_scope.

Module Correction.
Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ30_L_corrected (Es phi gam a : R) : 0 < phi /\ 0 < gam /\ 0 < a ->
  exists r0 r1 r2,
  is_the_right_series Es (slope phi (tilt phi gam)) a r0 r1 r2 /\
  sqrt gam * (2 * (Es * phi) / (PI * sqrt (1 + gam) * sqrt a)) = r0.
Proof.
  intros form. assert (0 < gam * a) by (apply Rmult_lt_0_compat; lra).
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ 0); [apply wedge_rises, tilt_range; positive | positive | eapply right_edge, smooth_contact; positive]. }
  identity_of_wedge a gam.
Qed.

End Correction.
Definition EQ30_L_corrected := Correction.EQ30_L_corrected.

Definition Es : R := 1.
Definition phi : R := 1.
Definition gam : R := (1 / 9).
Definition a : R := 9.
Definition x : R := 4.
Ltac constants := unfold x, a, gam, phi, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem EQ30_L_refuted : exists r0 r1 r2,
  is_the_right_series Es (slope phi (tilt phi gam)) a r0 r1 r2 /\
  134 / 10 ^ 3 <= Rabs ((2 * (Es * phi) / (PI * sqrt (1 + gam) * sqrt a)) - (r0)).
Proof.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ 0); [apply wedge_rises, tilt_range; positive | positive | eapply right_edge, smooth_contact; positive]. }
  numbers constants.
Qed.

