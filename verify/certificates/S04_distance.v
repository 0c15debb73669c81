(* Claim S04.distance of the ledger moore-hills, lines 164 to 164 of its source.
   Printed: the error in the one-term approximation $p \sim L_{I}\sqrt{a-x}$ increases with both distance from the contact edge and the flatness of the indenter as characterized by $m$ in (\ref{eqn:PowerLaw_Profile}).
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Unique Tactics PowerLaw PowerError.
Open Scope R_scope.

Theorem S04_distance_refuted : exists p0 q0 r0 r1 r2,
  is_the_pressure 1 (power_slope 1 (3 / 4)) 1 (1 - (9 / 10)) p0 /\
  is_the_pressure 1 (power_slope 1 (3 / 4)) 1 (1 - (99 / 100)) q0 /\
  is_the_right_series 1 (power_slope 1 (3 / 4)) 1 r0 r1 r2 /\
  714 / 10 ^ 5 <= Rabs (1 - r0 * sqrt (9 / 10) / p0) - Rabs (1 - r0 * sqrt (99 / 100) / q0).
Proof.
  destruct (power_ratios (3 / 4) (9 / 10) (99 / 100) ltac:(lra) ltac:(lra) ltac:(lra))
    as (p0 & q0 & r0 & r1 & r2 & Hp & Hq & Hr & E & F).
  exists p0, q0, r0, r1, r2. split; [exact Hp |]. split; [exact Hq |]. split; [exact Hr |].
  rewrite E, F. square_root_integrals. interval with (i_prec 60).
Qed.
