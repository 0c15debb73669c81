(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric TiltedWedge Unique Tactics.
Open Scope R_scope.

(* ---- The left edge of a tilted wedge, by the tilt ---- *)

Section Tilt.
Variables phi a : R.
Hypothesis Hphi : 0 < phi.
Hypothesis Ha : 0 < a.

Lemma left_edge_by_tilt alpha : - phi < alpha < phi ->
  is_the_left_edge (TiltedWedge.slope phi alpha) a (ratio_of phi alpha * a).
Proof.
  intros H. destruct (tilt_of_ratio phi alpha H) as [Hg E].
  assert (0 < ratio_of phi alpha * a) by (apply Rmult_lt_0_compat; assumption).
  apply (the_left_edge _ 0); [apply wedge_rises, H | exact Ha | lra |].
  rewrite <- E at 1. apply wedge_consistent; assumption.
Qed.
Lemma angle_of_tilt alpha : 0 < alpha < phi -> 0 < PI / 2 * (alpha / phi) < PI / 2.
Proof.
  intros H. assert (Hpi := PI_RGT_0). assert (0 < alpha / phi < 1).
  { split; [apply Rdiv_lt_0_compat; lra |]. apply (Rmult_lt_reg_r phi); [exact Hphi |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  split; nra.
Qed.

Theorem ratio_in_range alpha : 0 < alpha < phi -> exists b,
  is_the_left_edge (TiltedWedge.slope phi alpha) a b /\ 0 < b / a /\ b / a < 1.
Proof.
  intros H. exists (ratio_of phi alpha * a). split; [apply left_edge_by_tilt; lra |].
  replace (ratio_of phi alpha * a / a) with (ratio_of phi alpha) by (field; lra).
  split; [apply (tilt_of_ratio phi alpha); lra |].
  assert (Hz := angle_of_tilt alpha H). assert (Hpi := PI_RGT_0).
  assert (0 < sin (PI / 2 * (alpha / phi))) by (apply sin_gt_0; lra). unfold ratio_of.
  apply (Rmult_lt_reg_r (1 + sin (PI / 2 * (alpha / phi)))); [lra |]. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Lemma ratio_continuous alpha : 0 <= alpha <= phi -> continuous (fun z => ratio_of phi z * a / a) alpha.
Proof.
  intros H. assert (Hpi := PI_RGT_0). assert (0 <= alpha / phi <= 1).
  { split; [apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, Hphi] |].
    apply (Rmult_le_reg_r phi); [exact Hphi |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (0 <= sin (PI / 2 * (alpha / phi))) by (apply sin_ge_0; nra).
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold ratio_of. auto_derive.
  change (alpha * / phi) with (alpha / phi). change (PI * / 2) with (PI / 2). repeat split; lra.
Qed.

Theorem ratio_of_a_small_tilt : exists b : R -> R,
  (forall alpha, 0 < alpha < phi -> is_the_left_edge (TiltedWedge.slope phi alpha) a (b alpha)) /\
  filterlim (fun alpha => b alpha / a) (at_right 0) (locally 1).
Proof.
  exists (fun alpha => ratio_of phi alpha * a). split; [intros; apply left_edge_by_tilt; lra |].
  assert (C := ratio_continuous 0 ltac:(lra)). unfold continuous in C.
  replace (ratio_of phi 0 * a / a) with 1 in C; [intros P HP; apply filter_le_within; exact (C P HP) |].
  unfold ratio_of. replace (PI / 2 * (0 / phi)) with 0 by (unfold Rdiv; ring). rewrite sin_0. field. lra.
Qed.
Theorem ratio_of_the_largest_tilt : exists b : R -> R,
  (forall alpha, 0 < alpha < phi -> is_the_left_edge (TiltedWedge.slope phi alpha) a (b alpha)) /\
  filterlim (fun alpha => b alpha / a) (at_left phi) (locally 0).
Proof.
  exists (fun alpha => ratio_of phi alpha * a). split; [intros; apply left_edge_by_tilt; lra |].
  assert (C := ratio_continuous phi ltac:(lra)). unfold continuous in C.
  replace (ratio_of phi phi * a / a) with 0 in C; [intros P HP; apply filter_le_within; exact (C P HP) |].
  unfold ratio_of. replace (PI / 2 * (phi / phi)) with (PI / 2) by (field; lra). rewrite sin_PI2. field. lra.
Qed.
End Tilt.

(* ---- A flat punch with rounded edges, near the size at which the flat is in contact ---- *)

Definition rounded (t R0 : R) : list part := cons (Part t 0 (1 / R0)) nil.

Section Rounded.
Variables Es t R0 : R.
Hypothesis HEs : 0 < Es.
Hypothesis Ht : 0 < t.
Hypothesis HR : 0 < R0.

Lemma slope_within_flat x : - t <= x <= t -> Symmetric.slope (rounded t R0) x = 0.
Proof.
  intros H. unfold Symmetric.slope, total, rounded, part_slope, from, corner, curvature, fold_right.
  destruct (Rlt_dec t x); [lra |]. destruct (Rlt_dec x (- t)); lra.
Qed.
Theorem no_load_within_flat a : 0 < a <= t ->
  is_load Es (Symmetric.slope (rounded t R0)) a a 0 /\ forall P, is_load Es (Symmetric.slope (rounded t R0)) a a P -> P = 0.
Proof.
  intros H. assert (L : is_load Es (Symmetric.slope (rounded t R0)) a a 0).
  { unfold is_load. apply (is_RInt_ext (fun _ => 0)).
    - intros theta _. rewrite place_symmetric, slope_within_flat.
      + match goal with |- @eq _ ?x ?y => change (@eq R x y) end. ring.
      + assert (B := SIN_bound theta). split; nra.
    - assert (I := is_RInt_const (V := R_NormedModule) (- (PI / 2)) (PI / 2) 0).
      unfold scal in I; simpl in I; unfold mult in I; simpl in I. rewrite Rmult_0_r in I. exact I. }
  split; [exact L |]. intros P HP. exact (load_unique _ _ _ _ _ _ HP L).
Qed.

Lemma load_beyond_flat a : t < a -> is_the_load Es (Symmetric.slope (rounded t R0)) a a (Symmetric.load Es (rounded t R0) a).
Proof.
  intros H. assert (0 < 1 / R0) by (apply Rdiv_lt_0_compat; lra).
  assert (B : beyond a (rounded t R0)) by (repeat constructor; simpl; lra).
  apply (the_load _ _ (first (rounded t R0))).
  - apply punch_rises. unfold rounded. split; [| simpl; lra]. repeat constructor; simpl; lra.
  - exact H.
  - lra.
  - apply consistent_total, B.
  - apply load_total, B.
Qed.

Theorem load_grows a c : t < a < c -> exists P Q,
  is_the_load Es (Symmetric.slope (rounded t R0)) a a P /\ is_the_load Es (Symmetric.slope (rounded t R0)) c c Q /\ P < Q.
Proof.
  intros H. exists (Symmetric.load Es (rounded t R0) a), (Symmetric.load Es (rounded t R0) c).
  split; [apply load_beyond_flat; lra |]. split; [apply load_beyond_flat; lra |].
  destruct (MVT_cor2 (Symmetric.load Es (rounded t R0)) (Symmetric.rate Es (rounded t R0)) a c ltac:(lra)) as (s & E & Hs).
  - intros s Hs. apply is_derive_Reals, total_derive. apply Forall_cons; [apply part_load_derive; lra | apply Forall_nil].
  - enough (0 < Symmetric.rate Es (rounded t R0) s) by nra.
    unfold Symmetric.rate, total, rounded, part_rate, from, corner, curvature, fold_right, angle.
    assert (B := atan_bound (t / sqrt (s ^ 2 - t ^ 2))). assert (0 < 1 / R0) by (apply Rdiv_lt_0_compat; lra).
    replace (Es * (0 * s / sqrt (s ^ 2 - t ^ 2) + 1 / R0 * s * (PI / 2 - atan (t / sqrt (s ^ 2 - t ^ 2)))) + 0)
      with (Es * (1 / R0 * s * (PI / 2 - atan (t / sqrt (s ^ 2 - t ^ 2))))) by (unfold Rdiv; ring).
    repeat apply Rmult_lt_0_compat; lra.
Qed.

Theorem load_vanishes : exists P : R -> R,
  (forall a, t < a -> is_the_load Es (Symmetric.slope (rounded t R0)) a a (P a)) /\
  filterlim (fun a => P a / (Es * t)) (at_right t) (locally 0).
Proof.
  exists (Symmetric.load Es (rounded t R0)). split; [apply load_beyond_flat |].
  set (f := fun a => (a ^ 2 / 2 * atan (sqrt (a ^ 2 - t ^ 2) / t) - t / 2 * sqrt (a ^ 2 - t ^ 2)) / (R0 * t)).
  apply (filterlim_ext_loc f).
  - exists (mkposreal t Ht). intros a _ Ha. unfold f, Symmetric.load, total, rounded, part_load, from, corner, curvature, fold_right, angle.
    assert (Hd : 0 < a ^ 2 - t ^ 2) by nra. assert (Hq := sqrt_lt_R0 _ Hd).
    replace (sqrt (a ^ 2 - t ^ 2) / t) with (/ (t / sqrt (a ^ 2 - t ^ 2))) by (field; lra).
    rewrite atan_inv by (apply Rdiv_lt_0_compat; lra). field. lra.
  - assert (E : f t = 0) by (unfold f; rewrite (Rminus_diag_eq (t ^ 2)), sqrt_0 by reflexivity; unfold Rdiv; rewrite !Rmult_0_l, atan_0; ring).
    assert (C : continuous f t).
    { unfold f. assert (Cs : continuous (fun a => sqrt (a ^ 2 - t ^ 2)) t).
      { apply (continuous_comp (fun a => a ^ 2 - t ^ 2) sqrt); [| apply continuous_sqrt].
        apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
      apply continuous_quotient; [| apply continuous_const | apply Rgt_not_eq, Rmult_lt_0_compat; lra].
      apply continuous_sub; apply continuous_times; try (apply continuous_const); try exact Cs.
      - apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
      - apply (continuous_comp (fun a => sqrt (a ^ 2 - t ^ 2) / t) atan).
        + apply continuous_quotient; [exact Cs | apply continuous_const | lra].
        + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
    unfold continuous in C. rewrite E in C. intros P HP. apply filter_le_within. exact (C P HP).
Qed.
End Rounded.
