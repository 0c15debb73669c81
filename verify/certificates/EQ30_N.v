(* Claim EQ30.N of the ledger moore-hills, lines 310 to 312 of its source.
   Printed: N_{I,a} = \frac{(15+20\gamma+8\gamma^{2})\mathcal{P}}{20\pi(1+\gamma)^{5/2}a^{5/2}}
   Says: (15+20*gam+8*gam^2)*calP/(20*Pi*(1+gam)^(5/2)*a^(5/2)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Tactics TiltedWedge Unique.
Open Scope R_scope.

Module Correction.
Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ30_N_corrected (Es phi gam a : R) : 0 < phi /\ 0 < gam /\ 0 < a ->
  exists r0 r1 r2,
  is_the_right_series Es (slope phi (tilt phi gam)) a r0 r1 r2 /\
  sqrt gam * ((15 + 20 * gam + 8 * gam ^ 2) * (Es * phi) / (20 * PI * Rpower (1 + gam) (5 / 2) * Rpower a (5 / 2))) = r2.
Proof.
  intros form. assert (0 < gam * a) by (apply Rmult_lt_0_compat; lra).
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ 0); [apply wedge_rises, tilt_range; positive | positive | eapply right_edge, smooth_contact; positive]. }
  identity_of_wedge a gam.
Qed.

End Correction.
Definition EQ30_N_corrected := Correction.EQ30_N_corrected.

Definition Es : R := 1.
Definition phi : R := 1.
Definition gam : R := (1 / 9).
Definition a : R := 9.
Definition x : R := 4.
Ltac constants := unfold x, a, gam, phi, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem EQ30_N_refuted : exists r0 r1 r2,
  is_the_right_series Es (slope phi (tilt phi gam)) a r0 r1 r2 /\
  581 / 10 ^ 6 <= Rabs (((15 + 20 * gam + 8 * gam ^ 2) * (Es * phi) / (20 * PI * Rpower (1 + gam) (5 / 2) * Rpower a (5 / 2))) - (r2)).
Proof.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ 0); [apply wedge_rises, tilt_range; positive | positive | eapply right_edge, smooth_contact; positive]. }
  numbers constants.
Qed.

