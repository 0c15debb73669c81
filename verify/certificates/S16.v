(* Claim S16 of the ledger moore-hills, lines 184 to 184 of its source.
   Printed: Similarly, for a Hertzian indenter, a one-term asymptote gives a relative error of $<1\%$ for $\approx4\%$ of the contact, while the two-term asymptote increases this to $\approx 46\%$.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Tactics.
Open Scope R_scope.

Definition Es : R := 210000000000.
Definition a : R := 1.
Definition punch : list part := cons (Part 0 0 1) nil.
Ltac constants := unfold punch, a, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem S16_extent : exists r0 r1 r2,
  right_edge_series Es (slope punch) a r0 r1 r2 /\
  (forall u, 0 < u <= 4923005 / 10 ^ 7 -> exists p0, is_pressure Es (slope punch) a (a - u) p0 /\
    Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u))) <= (1 / 100) * p0) /\
  (forall u, u = 4923995 / 10 ^ 7 -> exists p0, is_pressure Es (slope punch) a (a - u) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u)))) /\
  (4923 / 10000 <= (4923005 / 10 ^ 7) / a /\ (4923995 / 10 ^ 7) / a <= 4924 / 10000).
Proof.
  eexists. eexists. eexists. split. { apply right_edge with (1 := smooth_contact Es punch (499999999999999 / 10 ^ 15) a ltac:(sides constants) ltac:(sides constants)). }
  split; [| split].
  - intros u Hu. eexists. split. { apply (pressure Es punch (25380025 / 10 ^ 8)); sides constants. }
    destruct (Rle_lt_dec u (2 / 10 ^ 4)) as [Hn | Hn].
    + rewrite (pressure_scaled Es a u (25380025 / 10 ^ 8)); [| sides constants | sides constants | lra].
      near_the_edge constants u (2 / 10 ^ 4) (2 / 10 ^ 3). interval with (i_prec 90).
    + assert (H : 2 / 10 ^ 4 <= u <= 4923005 / 10 ^ 7) by lra. clear Hu Hn. plain constants. unfold atanh.
      apply Rminus_le. interval with (i_bisect u, i_taylor u, i_prec 90, i_depth 60).
  - intros u ->. eexists. split. { apply (pressure Es punch (25380025 / 10 ^ 8)); sides constants. }
    plain constants. unfold atanh. apply Rminus_lt. interval with (i_prec 90).
  - plain constants. split; interval with (i_prec 90).
Qed.
Print Assumptions S16_extent.

