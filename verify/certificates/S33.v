(* Claim S33 of the ledger moore-hills, lines 334 to 334 of its source.
   Printed: Indeed, the one-term asymptote is within a relative error of $1\%$ for $\approx3\%$ of the contact at the left-hand contact edge and $\approx2\%$ at the right-hand contact edge.
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

Theorem S33_extent : exists r0 r1 r2,
  is_the_left_series Es (slope phi alpha) (gam * a) r0 r1 r2 /\
  (forall u, 0 < u <= 736679888 / 10 ^ 12 -> exists p0, is_the_pressure Es (mirrored (slope phi alpha)) (gam * a) ((gam * a) - u) p0 /\
    Rabs (p0 - (r0 * sqrt u)) <= (1 / 100) * p0) /\
  (forall u, u = 738686737 / 10 ^ 12 -> exists p0, is_the_pressure Es (mirrored (slope phi alpha)) (gam * a) ((gam * a) - u) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u))) /\
  ((3 / 100) - (1 / 200) < (736679888 / 10 ^ 12) / (gam * a) /\ (738686737 / 10 ^ 12) / (gam * a) < (3 / 100) + (1 / 200)).
Proof.
  eexists. eexists. eexists. split. { apply (the_left_series _ _ 0); [apply mirrored_wedge_rises; sides constants | sides constants | rewrite <- (proj2 tilted); refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ _); [apply smooth_contact | apply left_of_a]; sides constants]. }
  split; [| split].
  - intros u Hu. eexists. split. { apply (the_pressure _ _ 0); [apply mirrored_wedge_rises; sides constants | sides constants | rewrite <- (proj2 tilted); apply pressure_left_of_apex; sides constants]. }
    destruct (Rle_lt_dec u (5 / 10 ^ 6)) as [Hn | Hn].
    + rewrite proportional_near; [| sides constants | sides constants].
      near_the_edge constants u (5 / 10 ^ 6) (2 / 10 ^ 3). interval with (i_prec 90).
    + assert (H : 5 / 10 ^ 6 <= u <= 736679888 / 10 ^ 12) by lra. clear Hu Hn. plain constants. unfold atanh.
      apply Rminus_le. first [interval with (i_bisect u, i_taylor u, i_depth 60)
        | interval with (i_bisect u, i_taylor u, i_prec 90, i_depth 60)].
  - intros u ->. eexists. split. { apply (the_pressure _ _ 0); [apply mirrored_wedge_rises; sides constants | sides constants | rewrite <- (proj2 tilted); apply pressure_left_of_apex; sides constants]. }
    plain constants. unfold atanh. apply Rminus_lt. interval with (i_prec 90).
  - plain constants. repeat split; interval with (i_prec 90).
Qed.

