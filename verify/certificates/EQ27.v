(* Claim EQ27 of the ledger moore-hills, lines 296 to 298 of its source.
   Printed: p(x) = -\frac{E^{*}\phi}{\pi}\log\left|\frac{\sqrt{1/\gamma}-\sqrt{(a-x)/(x+b(a))}}{\sqrt{1/\gamma}-\sqrt{(a-x)/(x+b(a))}}\right|
   Says: -(Es*phi/Pi)*log(abs((sqrt(1/gam)-sqrt((a-x)/(x+b)))/(sqrt(1/gam)-sqrt((a-x)/(x+b))))) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Tactics TiltedWedge Unique.
Open Scope R_scope.

Definition Es : R := 1.
Definition phi : R := 1.
Definition gam : R := (1 / 4).
Definition a : R := 1.
Definition x : R := (1 / 2).
Ltac constants := unfold x, a, gam, phi, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem EQ27_refuted : exists p0,
  is_the_left_edge (slope phi (tilt phi gam)) a (gam * a) /\
  is_the_pressure Es (slope phi (tilt phi gam)) a x p0 /\
  275 / 10 ^ 3 <= Rabs ((- (Es * phi / PI) * ln (Rabs ((sqrt (1 / gam) - sqrt ((a - x) / (x + (gam * a)))) / (sqrt (1 / gam) - sqrt ((a - x) / (x + (gam * a))))))) - (p0)).
Proof.
  eexists. 
  split. { apply (the_left_edge _ 0); [apply wedge_rises, tilt_range; positive | positive | positive | apply wedge_consistent; positive]. }
  split. { apply (the_pressure _ _ 0); [apply wedge_rises, tilt_range; positive | positive | apply pressure_right_of_apex; positive]. }
  numbers constants.
Qed.

Theorem EQ27_corrected : exists p0,
  is_the_left_edge (slope phi (tilt phi gam)) a (gam * a) /\
  is_the_pressure Es (slope phi (tilt phi gam)) a x p0 /\
  Rabs ((- (Es * phi / PI) * ln (Rabs ((sqrt (1 / gam) - sqrt ((a - x) / (x + (gam * a)))) / (sqrt (1 / gam) + sqrt ((a - x) / (x + (gam * a))))))) - (p0)) <= 1 / 10 ^ 12 * Rabs (p0).
Proof.
  eexists. 
  split. { apply (the_left_edge _ 0); [apply wedge_rises, tilt_range; positive | positive | positive | apply wedge_consistent; positive]. }
  split. { apply (the_pressure _ _ 0); [apply wedge_rises, tilt_range; positive | positive | apply pressure_right_of_apex; positive]. }
  apply Rminus_le. numbers constants.
Qed.

