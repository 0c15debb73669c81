(* Claim S04.flatness of the ledger moore-hills, lines 164 to 164 of its source.
   Printed: the error in the one-term approximation $p \sim L_{I}\sqrt{a-x}$ increases with both distance from the contact edge and the flatness of the indenter as characterized by $m$ in (\ref{eqn:PowerLaw_Profile}).
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics PowerLaw.
Open Scope R_scope.

Definition Es : R := 1.
Definition C : R := 1.
Definition a : R := 1.
Definition x : R := (1 / 2).
Ltac constants := unfold Es, C, a, x in *.
Ltac positive := constants; repeat split; lra.

Theorem S04_flatness_refuted : exists p0 r0 r1 r2,
  is_pressure Es (slope C 0) a x p0 /\
  right_edge_series Es (slope C 0) a r0 r1 r2 /\
  exists p0' r0' r1' r2',
  is_pressure Es (slope C 1) a x p0' /\
  right_edge_series Es (slope C 1) a r0' r1' r2' /\
  859 / 10 ^ 4 <= (Rabs (1 - (r0 * ((a - x) ^ 0 * sqrt (a - x))) / p0)) - (Rabs (1 - (r0' * ((a - x) ^ 0 * sqrt (a - x))) / p0')).
Proof.
  eexists. eexists. eexists. eexists. 
  split. { apply wedge_pressure; positive. }
  split. { apply wedge_edge; positive. }
    eexists. eexists. eexists. eexists. 
  split. { apply parabola_pressure; positive. }
  split. { apply parabola_edge; positive. }
  repeat split; unfold c0, c1, c2; numbers constants.
Qed.
Print Assumptions S04_flatness_refuted.

