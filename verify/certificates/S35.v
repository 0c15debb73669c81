(* Claim S35 of the ledger moore-hills, lines 334 to 334 of its source.
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

Theorem S35_extent : exists r0 r1 r2,
  is_the_left_series Es (slope phi alpha) (gam * a) r0 r1 r2 /\
  (forall u, 0 < u <= 533329935 / 10 ^ 11 -> exists p0, is_the_pressure Es (mirrored (slope phi alpha)) (gam * a) ((gam * a) - u) p0 /\
    Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u))) <= (1 / 100) * p0) /\
  (forall u, u = 533530619 / 10 ^ 11 -> exists p0, is_the_pressure Es (mirrored (slope phi alpha)) (gam * a) ((gam * a) - u) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u)))) /\
  ((533530619 / 10 ^ 11) / (gam * a) < (23 / 100) - (3 / 200) /\
   (533530619 / 10 ^ 11) / (a + gam * a) < (23 / 100) - (1 / 200)).
Proof.
  eexists. eexists. eexists. split. { apply (the_left_series _ _ 0); [apply mirrored_wedge_rises; sides constants | sides constants | rewrite <- (proj2 tilted); refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ _); [apply smooth_contact | apply left_of_a]; sides constants]. }
  split; [| split].
  - intros u Hu. eexists. split. { apply (the_pressure _ _ 0); [apply mirrored_wedge_rises; sides constants | sides constants | rewrite <- (proj2 tilted); apply pressure_left_of_apex; sides constants]. }
    destruct (Rle_lt_dec u (5 / 10 ^ 6)) as [Hn | Hn].
    + rewrite proportional_near; [| sides constants | sides constants].
      near_the_edge constants u (5 / 10 ^ 6) (2 / 10 ^ 3). interval with (i_prec 90).
    + assert (H : 5 / 10 ^ 6 <= u <= 533329935 / 10 ^ 11) by lra. clear Hu Hn. plain constants. unfold atanh.
      apply Rminus_le. first [interval with (i_bisect u, i_taylor u, i_depth 60)
        | interval with (i_bisect u, i_taylor u, i_prec 90, i_depth 60)].
  - intros u ->. eexists. split. { apply (the_pressure _ _ 0); [apply mirrored_wedge_rises; sides constants | sides constants | rewrite <- (proj2 tilted); apply pressure_left_of_apex; sides constants]. }
    plain constants. unfold atanh. apply Rminus_lt. interval with (i_prec 90).
  - plain constants. repeat split; interval with (i_prec 90).
Qed.


Definition K : R := Es * phi * sqrt gam.
Lemma gam_a_near : 2459 / 10 ^ 5 < gam * a < 2559 / 10 ^ 5 /\ 5018 / 10 ^ 5 < a + gam * a < 1046 / 10 ^ 3.
Proof. constants. unfold ratio_of. repeat split; apply Rminus_lt; interval with (i_prec 60). Qed.
Lemma positive_factors : 0 < K /\ 0 < K / gam /\ 0 < / gam.
Proof.
  assert (G := proj1 tilted). assert (F : 0 < Es /\ 0 < phi) by sides constants.
  assert (0 < sqrt gam) by (apply sqrt_lt_R0; exact G). assert (0 < / gam) by (apply Rinv_0_lt_compat; exact G).
  assert (0 < K) by (unfold K; apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; apply F | assumption]).
  split; [assumption | split; [apply Rdiv_lt_0_compat; assumption | assumption]].
Qed.
Lemma pressure_on_the_left u : 0 < u < gam * a -> is_the_pressure Es (mirrored (slope phi alpha)) (gam * a) (gam * a - u)
  (proportional_pressure (K / gam) (/ gam) (gam * a) (gam * a - u)).
Proof.
  intros Hu. apply (the_pressure _ _ 0); [apply mirrored_wedge_rises; sides constants | lra |].
  rewrite <- (proj2 tilted). apply pressure_left_of_apex; sides constants.
Qed.
Lemma pressure_on_the_right u : gam * a < u < gam * a + a -> is_the_pressure Es (slope phi alpha) a (u - gam * a)
  (proportional_pressure K gam a (u - gam * a)).
Proof.
  intros Hu. apply (the_pressure _ _ 0); [apply wedge_rises; sides constants | lra |].
  rewrite <- (proj2 tilted). apply pressure_right_of_apex; sides constants.
Qed.
Lemma sum_far_below tol p sum least : 0 < tol <= 1 / 10 -> 0 < least -> least <= p -> sum <= 4 / 5 * least -> tol * p < Rabs (p - sum).
Proof. intros. rewrite Rabs_pos_eq; nra. Qed.
Lemma sum_far_above tol p sum most : 0 < tol <= 1 / 10 -> 0 <= p <= most -> 2 * most < sum -> tol * p < Rabs (p - sum).
Proof. intros. rewrite Rabs_left; nra. Qed.

(* Everywhere else the terms are not within the tolerance. *)
Theorem S35_extent_3 : exists r0 r1 r2,
  is_the_left_series Es (slope phi alpha) (gam * a) r0 r1 r2 /\
  (forall u, 533530619 / 10 ^ 11 <= u < gam * a -> exists p0, is_the_pressure Es (mirrored (slope phi alpha)) (gam * a) (gam * a - u) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u)))) /\
  (forall u, gam * a < u <= 300561 / 10 ^ 7 -> exists p0, is_the_pressure Es (slope phi alpha) a (u - gam * a) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u)))) /\
  (forall u, 303167 / 10 ^ 7 <= u < gam * a + a -> exists p0, is_the_pressure Es (slope phi alpha) a (u - gam * a) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u)))) /\
  (533530619 / 10 ^ 11 + (303167 / 10 ^ 7 - 300561 / 10 ^ 7)) / (gam * a) < (23 / 100) - (1 / 200).
Proof.
  assert (G := gam_a_near). destruct positive_factors as (K1 & K2 & K3). assert (Hg := proj1 tilted).
  eexists. eexists. eexists. split. { apply (the_left_series _ _ 0); [apply mirrored_wedge_rises; sides constants | sides constants | rewrite <- (proj2 tilted); refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ _); [apply smooth_contact | apply left_of_a]; sides constants]. }
  split; [| split; [| split]].
  - intros u Hu. eexists. split; [apply pressure_on_the_left; lra |].
    destruct (Rle_lt_dec u (2308 / 10 ^ 5)) as [H | H].
    + assert (B : 533530619 / 10 ^ 11 <= u <= 2308 / 10 ^ 5) by lra. clear - B. unfold K. plain constants. unfold atanh.
      apply Rminus_lt. interval with (i_bisect u, i_taylor u, i_depth 60).
    + destruct (proportional_falls (K / gam) (/ gam) (gam * a) (gam * a - u) (gam * a - 2308 / 10 ^ 5) K2 K3 ltac:(lra) ltac:(lra)) as [_ F].
      assert (B : 2308 / 10 ^ 5 <= u <= 2559 / 10 ^ 5) by lra. clear - F B.
      apply (sum_far_below _ _ _ (proportional_pressure (K / gam) (/ gam) (gam * a) (gam * a - 2308 / 10 ^ 5)));
        [lra | | exact F |]; clear F; unfold K; plain constants; unfold atanh.
      * interval with (i_prec 60).
      * apply Rminus_le. interval with (i_bisect u, i_prec 60).
  - intros u Hu. eexists. split; [apply pressure_on_the_right; lra |].
    destruct (Rle_lt_dec (276 / 10 ^ 4) u) as [H | H].
    + assert (B : 276 / 10 ^ 4 <= u <= 300561 / 10 ^ 7) by lra. clear - B. unfold K. plain constants. unfold atanh.
      apply Rminus_lt. interval with (i_bisect u, i_taylor u, i_depth 60).
    + destruct (proportional_falls K gam a (u - gam * a) (276 / 10 ^ 4 - gam * a) K1 ltac:(lra) ltac:(lra) ltac:(lra)) as [_ F].
      assert (B : 2459 / 10 ^ 5 <= u <= 276 / 10 ^ 4) by lra. clear - F B.
      apply (sum_far_below _ _ _ (proportional_pressure K gam a (276 / 10 ^ 4 - gam * a)));
        [lra | | exact F |]; clear F; unfold K; plain constants; unfold atanh.
      * interval with (i_prec 60).
      * apply Rminus_le. interval with (i_bisect u, i_prec 60).
  - intros u Hu. eexists. split; [apply pressure_on_the_right; lra |].
    destruct (Rle_lt_dec u (5018 / 10 ^ 5)) as [H | H].
    + assert (B : 303167 / 10 ^ 7 <= u <= 5018 / 10 ^ 5) by lra. clear - B. unfold K. plain constants. unfold atanh.
      apply Rminus_lt. interval with (i_bisect u, i_taylor u, i_depth 60).
    + assert (F := proportional_falls K gam a (5018 / 10 ^ 5 - gam * a) (u - gam * a) K1 Hg ltac:(lra) ltac:(lra)).
      assert (B : 5018 / 10 ^ 5 <= u <= 1046 / 10 ^ 3) by lra. clear - F B.
      apply (sum_far_above _ _ _ (proportional_pressure K gam a (5018 / 10 ^ 5 - gam * a)));
        [lra | exact F |]; clear F; unfold K; plain constants; unfold atanh.
      apply Rminus_lt. interval with (i_bisect u, i_prec 60).
  - clear. plain constants. interval with (i_prec 90).
Qed.

Module Reading_4.
Definition Es : R := 1.
Definition a : R := 1.
Definition phi : R := (PI / 16).
Definition alpha : R := (2 * (PI / 16) / PI * asin ((1 - (3 / 100)) / (1 + (3 / 100)))).
Definition gam : R := (3 / 100).
Ltac constants := unfold gam, alpha, phi, a, Es in *.
Ltac positive := constants; repeat split; lra.

(* The tilt has the left edge at gam a. *)
Lemma tilted : 0 < gam /\ tilt phi gam = alpha.
Proof. split; [sides constants |]. assert (Hpi := PI_RGT_0). unfold tilt. constants.
  replace ((1 - (3 / 100)) / (1 + (3 / 100))) with (97 / 103) by field. field. lra. Qed.

Theorem S35_extent_4 : exists r0 r1 r2,
  is_the_left_series Es (slope phi alpha) (gam * a) r0 r1 r2 /\
  (forall u, 0 < u <= 637138638 / 10 ^ 11 -> exists p0, is_the_pressure Es (mirrored (slope phi alpha)) (gam * a) ((gam * a) - u) p0 /\
    Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u))) <= (1 / 100) * p0) /\
  (forall u, u = 637378637 / 10 ^ 11 -> exists p0, is_the_pressure Es (mirrored (slope phi alpha)) (gam * a) ((gam * a) - u) p0 /\
    (1 / 100) * p0 < Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u)))) /\
  ((637378637 / 10 ^ 11) / (gam * a) < (23 / 100) - (1 / 200)).
Proof.
  eexists. eexists. eexists. split. { apply (the_left_series _ _ 0); [rewrite <- (proj2 tilted); apply mirrored_wedge_rises, tilt_range; sides constants | sides constants | rewrite <- (proj2 tilted); refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ _); [apply smooth_contact | apply left_of_a]; sides constants]. }
  split; [| split].
  - intros u Hu. eexists. split. { apply (the_pressure _ _ 0); [rewrite <- (proj2 tilted); apply mirrored_wedge_rises, tilt_range; sides constants | sides constants | rewrite <- (proj2 tilted); apply pressure_left_of_apex; sides constants]. }
    destruct (Rle_lt_dec u (59 / 10 ^ 7)) as [Hn | Hn].
    + rewrite proportional_near; [| sides constants | sides constants].
      near_the_edge constants u (59 / 10 ^ 7) (2 / 10 ^ 3). interval with (i_prec 90).
    + assert (H : 59 / 10 ^ 7 <= u <= 637138638 / 10 ^ 11) by lra. clear Hu Hn. plain constants. unfold atanh.
      apply Rminus_le. first [interval with (i_bisect u, i_taylor u, i_depth 60)
        | interval with (i_bisect u, i_taylor u, i_prec 90, i_depth 60)].
  - intros u ->. eexists. split. { apply (the_pressure _ _ 0); [rewrite <- (proj2 tilted); apply mirrored_wedge_rises, tilt_range; sides constants | sides constants | rewrite <- (proj2 tilted); apply pressure_left_of_apex; sides constants]. }
    plain constants. unfold atanh. apply Rminus_lt. interval with (i_prec 90).
  - plain constants. repeat split; interval with (i_prec 90).
Qed.

End Reading_4.

