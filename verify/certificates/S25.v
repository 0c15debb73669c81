(* Claim S25 of the ledger moore-hills, lines 233 to 233 of its source.
   Printed: Similarly, for a punch with $t/a = 0.8$, the relative error is $<1\%$ for the one-term asymptote only up to $\approx0.5\%$ of the contact, which increases to $\approx6.6\%$ and $\approx 10\%$ of the contact for the two- and three-term asymptotes respectively.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Tactics.
Open Scope R_scope.

Definition Es : R := 210000000000.
Definition a : R := 1.
Definition punch : list part := cons (Part (1 * 4 / 5) 0 (1 / 1)) nil.
Ltac constants := unfold punch, a, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem S25_extent : exists r0 r1 r2,
  right_edge_series Es (slope punch) a r0 r1 r2 /\
  (forall u, 0 < u <= 11390012 / 10 ^ 8 -> exists p0, is_pressure Es (slope punch) a (a - u) p0 /\
    Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u))) <= (1 / 100) * p0) /\
  (forall u, u = 11399988 / 10 ^ 8 -> exists p0, is_pressure Es (slope punch) a (a - u) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u)))) /\
  (1139 / 10000 <= (11390012 / 10 ^ 8) / a /\ (11399988 / 10 ^ 8) / a <= 1140 / 10000).
Proof.
  eexists. eexists. eexists. split. { apply right_edge with (1 := smooth_contact Es punch (9 / 10 ^ 1) a ltac:(sides constants) ltac:(sides constants)). }
  split; [| split].
  - intros u Hu. eexists. split. { apply (pressure Es punch (84300006 / 10 ^ 8)); sides constants. }
    destruct (Rle_lt_dec u (39 / 10 ^ 6)) as [Hn | Hn].
    + rewrite (pressure_scaled Es a u (84300006 / 10 ^ 8)); [| sides constants | sides constants | lra].
      near_the_edge constants u (39 / 10 ^ 6) (49 / 10 ^ 5). interval with (i_prec 90).
    + assert (H : 39 / 10 ^ 6 <= u <= 11390012 / 10 ^ 8) by lra. clear Hu Hn. plain constants. unfold atanh.
      apply Rminus_le. interval with (i_bisect u, i_taylor u, i_prec 90, i_depth 60).
  - intros u ->. eexists. split. { apply (pressure Es punch (84300006 / 10 ^ 8)); sides constants. }
    plain constants. unfold atanh. apply Rminus_lt. interval with (i_prec 90).
  - plain constants. split; interval with (i_prec 90).
Qed.
Print Assumptions S25_extent.

