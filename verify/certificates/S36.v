(* Claim S36 of the ledger moore-hills, lines 334 to 334 of its source.
   Printed: The difference is accentuated by including a second-term: the relative error is within $1\%$ for $\approx 23\%$ of the contact at the left-hand edge, while only $17\%$ of the contact at the right-hand edge.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm TiltedWedge Unique Scaling Tactics.
Open Scope R_scope.

Definition Es : R := 1.
Definition a : R := 1.
Definition phi : R := (PI / 16).
Definition alpha : R := (PI / 20).
Definition gam : R := ratio_of phi alpha.
Ltac constants := unfold gam, alpha, phi, a, Es in *.
Ltac positive := constants; repeat split; lra.

(* The tilt has the left edge at gam a. *)
Lemma tilted : 0 < gam /\ tilt phi gam = alpha.
Proof. apply tilt_of_ratio. sides constants. Qed.

Theorem S36_extent : exists r0 r1 r2,
  is_the_right_series Es (slope phi alpha) a r0 r1 r2 /\
  (forall u, 0 < u <= 160004732 / 10 ^ 9 -> exists p0, is_the_pressure Es (slope phi alpha) a (a - u) p0 /\
    Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u))) <= (1 / 100) * p0) /\
  (forall u, u = 160084731 / 10 ^ 9 -> exists p0, is_the_pressure Es (slope phi alpha) a (a - u) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u)))) /\
  ((17 / 100) - (3 / 200) < (160004732 / 10 ^ 9) / a /\ (160084731 / 10 ^ 9) / a < (17 / 100) - (1 / 200)).
Proof.
  eexists. eexists. eexists. split. { apply (the_right_series _ _ 0); [apply wedge_rises; sides constants | sides constants | rewrite <- (proj2 tilted); eapply right_edge, smooth_contact; sides constants]. }
  split; [| split].
  - intros u Hu. eexists. split. { apply (the_pressure _ _ 0); [apply wedge_rises; sides constants | sides constants | rewrite <- (proj2 tilted); apply pressure_right_of_apex; sides constants]. }
    destruct (Rle_lt_dec u (2 / 10 ^ 4)) as [Hn | Hn].
    + rewrite proportional_near; [| sides constants | sides constants].
      near_the_edge constants u (2 / 10 ^ 4) (2 / 10 ^ 3). interval with (i_prec 90).
    + assert (H : 2 / 10 ^ 4 <= u <= 160004732 / 10 ^ 9) by lra. clear Hu Hn. plain constants. unfold atanh.
      apply Rminus_le. first [interval with (i_bisect u, i_taylor u, i_depth 60)
        | interval with (i_bisect u, i_taylor u, i_prec 90, i_depth 60)].
  - intros u ->. eexists. split. { apply (the_pressure _ _ 0); [apply wedge_rises; sides constants | sides constants | rewrite <- (proj2 tilted); apply pressure_right_of_apex; sides constants]. }
    plain constants. unfold atanh. apply Rminus_lt. interval with (i_prec 90).
  - plain constants. repeat split; interval with (i_prec 90).
Qed.

