(* Claim S21 of the ledger moore-hills, lines 233 to 233 of its source.
   Printed: Indeed, for a punch with $t/a = 0.4$, the relative error is $<1\%$ for the one-term asymptote only up to $\approx2\%$ of the contact, which increases to $\approx21\%$ and $\approx 35\%$ of the contact for the two- and three-term asymptotes respectively.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Scaling Symmetric Unique Tactics.
Open Scope R_scope.

Definition Es : R := 210000000000.
Definition a : R := 1.
Definition punch : list part := cons (Part (1 * 2 / 5) 0 (1 / (3 / 1000))) nil.
Ltac constants := unfold punch, a, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem S21_extent : exists r0 r1 r2,
  is_the_right_series Es (slope punch) a r0 r1 r2 /\
  (forall u, 0 < u <= 212782427 / 10 ^ 9 -> exists p0, is_the_pressure Es (slope punch) a (a - u) p0 /\
    Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u))) <= (1 / 100) * p0) /\
  (forall u, u = 212862426 / 10 ^ 9 -> exists p0, is_the_pressure Es (slope punch) a (a - u) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u)))) /\
  ((21 / 100) - (1 / 200) < (212782427 / 10 ^ 9) / a /\ (212862426 / 10 ^ 9) / a < (21 / 100) + (1 / 200)).
Proof.
  eexists. eexists. eexists. split. { apply (the_right_series _ _ (first punch)); [apply punch_rises; convex constants | before constants | apply right_edge with (1 := smooth_contact Es punch (699999999999999 / 10 ^ 15) a ltac:(sides constants) ltac:(sides constants))]. }
  split; [| split].
  - intros u Hu. eexists. split. { apply (the_pressure _ _ (first punch)); [apply punch_rises; convex constants | before constants | apply (pressure Es punch (593568786999999 / 10 ^ 15)); sides constants]. }
    destruct (Rle_lt_dec u (12 / 10 ^ 5)) as [Hn | Hn].
    + rewrite (pressure_scaled Es a u (593568786999999 / 10 ^ 15)); [| sides constants | sides constants | lra].
      near_the_edge constants u (12 / 10 ^ 5) (2 / 10 ^ 3). interval with (i_prec 90).
    + assert (H : 12 / 10 ^ 5 <= u <= 212782427 / 10 ^ 9) by lra. clear Hu Hn. plain constants. unfold atanh.
      apply Rminus_le. first [interval with (i_bisect u, i_taylor u, i_depth 60)
        | interval with (i_bisect u, i_taylor u, i_prec 90, i_depth 60)].
  - intros u ->. eexists. split. { apply (the_pressure _ _ (first punch)); [apply punch_rises; convex constants | before constants | apply (pressure Es punch (593568786999999 / 10 ^ 15)); sides constants]. }
    plain constants. unfold atanh. apply Rminus_lt. interval with (i_prec 90).
  - plain constants. repeat split; interval with (i_prec 90).
Qed.

(* The same at every scale: for all slopes h1 that are scaled copies, and all moduli. *)
Theorem S21_extent_similar : forall Fs lam mu h1, 0 < Fs -> 0 < lam -> 0 < mu ->
  (forall x, h1 (lam * x) = mu * (slope punch) x) ->
  is_first_exit Scaling.sum_2 Fs h1 (lam * a) (1 / 100) (lam * (212782427 / 10 ^ 9)) (lam * (212862426 / 10 ^ 9)).
Proof.
  intros Fs lam mu h1 HFs Hlam Hmu Hh.
  destruct S21_extent as (r0 & r1 & r2 & Hr & Hwithin & Hbeyond & _).
  apply (first_exit_scaled Scaling.sum_2 Es Fs (slope punch) h1 lam mu);
    [apply homogeneous_2 | sides constants | assumption | assumption | assumption
    | assumption | sides constants | exists r0, r1, r2; exact (conj Hr (conj Hwithin Hbeyond))].
Qed.

