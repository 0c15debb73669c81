(* Claim S14 of the ledger moore-hills, lines 184 to 184 of its source.
   Printed: For a wedge, a one-term asymptote gives a relative error of $<1\%$ for $\approx2\%$ of the contact, while the two-term asymptote increases this to $\approx 18\%$ of the contact.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Tactics.
Open Scope R_scope.

Definition Es : R := 210000000000.
Definition a : R := 1.
Definition punch : list part := cons (Part 0 (3 / 7000) 0) nil.
Ltac constants := unfold punch, a, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem S14_extent : exists r0 r1 r2,
  right_edge_series Es (slope punch) a r0 r1 r2 /\
  (forall u, 0 < u <= 18670019 / 10 ^ 8 -> exists p0, is_pressure Es (slope punch) a (a - u) p0 /\
    Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u))) <= (1 / 100) * p0) /\
  (forall u, u = 18679981 / 10 ^ 8 -> exists p0, is_pressure Es (slope punch) a (a - u) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u)))) /\
  (1867 / 10000 <= (18670019 / 10 ^ 8) / a /\ (18679981 / 10 ^ 8) / a <= 1868 / 10000).
Proof.
  eexists. eexists. eexists. split. { apply right_edge with (1 := smooth_contact Es punch (499999999999999 / 10 ^ 15) a ltac:(sides constants) ltac:(sides constants)). }
  split; [| split].
  - intros u Hu. eexists. split. { apply (pressure Es punch (406600094999999 / 10 ^ 15)); sides constants. }
    destruct (Rle_lt_dec u (2 / 10 ^ 4)) as [Hn | Hn].
    + rewrite (pressure_scaled Es a u (406600094999999 / 10 ^ 15)); [| sides constants | sides constants | lra].
      near_the_edge constants u (2 / 10 ^ 4) (2 / 10 ^ 3). interval with (i_prec 90).
    + assert (H : 2 / 10 ^ 4 <= u <= 18670019 / 10 ^ 8) by lra. clear Hu Hn. plain constants. unfold atanh.
      apply Rminus_le. interval with (i_bisect u, i_taylor u, i_prec 90, i_depth 60).
  - intros u ->. eexists. split. { apply (pressure Es punch (406600094999999 / 10 ^ 15)); sides constants. }
    plain constants. unfold atanh. apply Rminus_lt. interval with (i_prec 90).
  - plain constants. split; interval with (i_prec 90).
Qed.
Print Assumptions S14_extent.

