(* Claim S15 of the ledger moore-hills, lines 184 to 184 of its source.
   Printed: Similarly, for a Hertzian indenter, a one-term asymptote gives a relative error of $<1\%$ for $\approx4\%$ of the contact, while the two-term asymptote increases this to $\approx 46\%$.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Scaling Symmetric Unique Tactics.
Open Scope R_scope.

Definition Es : R := 210000000000.
Definition a : R := 1.
Definition punch : list part := cons (Part 0 0 1) nil.
Ltac constants := unfold punch, a, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem S15_extent : exists r0 r1 r2,
  is_the_right_series Es (slope punch) a r0 r1 r2 /\
  (forall u, 0 < u <= 393679012 / 10 ^ 10 -> exists p0, is_the_pressure Es (slope punch) a (a - u) p0 /\
    Rabs (p0 - (r0 * sqrt u)) <= (1 / 100) * p0) /\
  (forall u, u = 394479011 / 10 ^ 10 -> exists p0, is_the_pressure Es (slope punch) a (a - u) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u))) /\
  ((1 / 25) - (1 / 200) < (393679012 / 10 ^ 10) / a /\ (394479011 / 10 ^ 10) / a < (1 / 25) + (1 / 200)).
Proof.
  eexists. eexists. eexists. split. { apply (the_right_series _ _ (first punch)); [apply punch_rises; convex constants | before constants | apply right_edge with (1 := smooth_contact Es punch (499999999999999 / 10 ^ 15) a ltac:(sides constants) ltac:(sides constants))]. }
  split; [| split].
  - intros u Hu. eexists. split. { apply (the_pressure _ _ (first punch)); [apply punch_rises; convex constants | before constants | apply (pressure Es punch (48027604945 / 10 ^ 11)); sides constants]. }
    destruct (Rle_lt_dec u (2 / 10 ^ 4)) as [Hn | Hn].
    + rewrite (pressure_scaled Es a u (48027604945 / 10 ^ 11)); [| sides constants | sides constants | lra].
      near_the_edge constants u (2 / 10 ^ 4) (2 / 10 ^ 3). interval with (i_prec 90).
    + assert (H : 2 / 10 ^ 4 <= u <= 393679012 / 10 ^ 10) by lra. clear Hu Hn. plain constants. unfold atanh.
      apply Rminus_le. first [interval with (i_bisect u, i_taylor u, i_depth 60)
        | interval with (i_bisect u, i_taylor u, i_prec 90, i_depth 60)].
  - intros u ->. eexists. split. { apply (the_pressure _ _ (first punch)); [apply punch_rises; convex constants | before constants | apply (pressure Es punch (48027604945 / 10 ^ 11)); sides constants]. }
    plain constants. unfold atanh. apply Rminus_lt. interval with (i_prec 90).
  - plain constants. repeat split; interval with (i_prec 90).
Qed.

(* The same at every scale: for all slopes h1 that are scaled copies, and all moduli. *)
Theorem S15_extent_similar : forall Fs lam mu h1, 0 < Fs -> 0 < lam -> 0 < mu ->
  (forall x, h1 (lam * x) = mu * (slope punch) x) ->
  is_first_exit Scaling.sum_1 Fs h1 (lam * a) (1 / 100) (lam * (393679012 / 10 ^ 10)) (lam * (394479011 / 10 ^ 10)).
Proof.
  intros Fs lam mu h1 HFs Hlam Hmu Hh.
  destruct S15_extent as (r0 & r1 & r2 & Hr & Hwithin & Hbeyond & _).
  apply (first_exit_scaled Scaling.sum_1 Es Fs (slope punch) h1 lam mu);
    [apply homogeneous_1 | sides constants | assumption | assumption | assumption
    | assumption | sides constants | exists r0, r1, r2; exact (conj Hr (conj Hwithin Hbeyond))].
Qed.

