(* Claim S03.M of the ledger moore-hills, lines 164 to 164 of its source.
   Printed: both $M_{I}$ and $N_{I}$ grow as $m$ increases
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

Theorem S03_M_refuted : exists r0 r1 r2,
  right_edge_series Es (slope C 0) a r0 r1 r2 /\
  exists r0' r1' r2',
  right_edge_series Es (slope C 1) a r0' r1' r2' /\
  364 / 10 ^ 3 <= (r1) - (r1') /\
  107 / 10 ^ 4 <= (Rabs r1) - (Rabs r1') /\
  166 / 10 ^ 3 <= (Rabs (r1 / r0) * a ^ 1) - (Rabs (r1' / r0') * a ^ 1).
Proof.
  eexists. eexists. eexists. 
  split. { apply wedge_edge; positive. }
    eexists. eexists. eexists. 
  split. { apply parabola_edge; positive. }
  repeat split; unfold c0, c1, c2; numbers constants.
Qed.
Print Assumptions S03_M_refuted.

