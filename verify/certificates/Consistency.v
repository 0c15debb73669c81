(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients TiltedWedge Unique Stick TiltedRounded Resultant Places Dilogarithm LogPressure.
Open Scope R_scope.

(* The printed condition of consistency, 0 = int g'(s) / sqrt((a - s)(s + b)) ds, of tilted punches. *)

(* kernel_angle is the angle of a place, from the left edge. *)
Lemma kernel_angle_of_place a b theta : 0 < a + b -> - (PI / 2) <= theta <= PI / 2 -> kernel_angle a b (place a b theta) = theta + PI / 2.
Proof.
  intros H Ht. assert (Hpi := PI_RGT_0). set (m := (a - b) / 2). assert (Hm : - b < m < a) by (unfold m; lra).
  assert (End : kernel_angle a b (place a b (- (PI / 2))) - - (PI / 2) = PI / 2).
  { unfold place. rewrite sin_neg, sin_PI2. replace ((a - b) / 2 + (a + b) / 2 * - (1)) with (- b) by field. rewrite kernel_angle_left. ring. }
  assert (P : forall z, - b <= place a b z <= a) by (intros z; unfold place; generalize (SIN_bound z); intros; nra).
  assert (E := constant_between (fun z => kernel_angle a b (place a b z) - z) (- (PI / 2)) theta ltac:(lra)). cbv beta in E. rewrite End in E.
  rewrite E; [ring | |].
  - intros z Hz. assert (C : 0 < cos z) by (apply cos_gt_0; lra). assert (SC := sin2_cos2 z). unfold Rsqr in SC.
    assert (S : -1 < sin z < 1) by nra. assert (I : - b < place a b z < a) by (unfold place; nra).
    assert (Q : sqrt ((a - place a b z) * (place a b z + b)) = (a + b) / 2 * cos z).
    { assert (E2 : (a - place a b z) * (place a b z + b) = ((a + b) / 2 * cos z) ^ 2).
      { replace ((a - place a b z) * (place a b z + b)) with (((a + b) / 2) ^ 2 * (1 - sin z * sin z)) by (unfold place; field).
        replace (1 - sin z * sin z) with (cos z * cos z) by lra. ring. }
      rewrite E2. apply sqrt_pow2. nra. }
    assert (D0 := angle_derive a b m Hm _ I). rewrite Q in D0.
    assert (D1 : is_derive (place a b) z ((a + b) / 2 * cos z)) by (unfold place; auto_derive; [trivial | ring]).
    assert (D2 := is_derive_comp (kernel_angle a b) (place a b) z _ _ D0 D1).
    assert (D3 := is_derive_minus (V := R_NormedModule) _ _ z _ _ D2 (is_derive_id (K := R_AbsRing) z)).
    refine (eq_ind _ (fun v => is_derive _ z v) D3 0 _). unfold minus, plus, opp, scal, one; simpl; unfold mult; simpl. in_R. field. nra.
  - intros z Hz. apply continuous_sub; [| apply continuous_id]. apply (continuous_comp (place a b) (kernel_angle a b)).
    + unfold place. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
    + apply (angle_continuous a b m Hm), P.
Qed.

Lemma wedge_consistency phi gam a : 0 < phi /\ 0 < gam /\ 0 < a ->
  is_the_left_edge (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) /\
  is_RInt_gen (fun s => TiltedWedge.slope phi (tilt phi gam) s / sqrt ((a - s) * (s + gam * a))) (at_right (- (gam * a))) (at_left a) 0.
Proof.
  intros (Hphi & Hgam & Ha). assert (Hpi := PI_RGT_0). assert (Hb : 0 < gam * a) by (apply Rmult_lt_0_compat; assumption).
  assert (H0 : - (gam * a) < 0 < a) by lra.
  split. { apply (the_left_edge _ 0); [apply wedge_rises, tilt_range; assumption | exact Ha | lra | apply wedge_consistent; assumption]. }
  set (al := tilt phi gam). set (K := kernel_angle a (gam * a)). set (G := fun s => (phi - al) * K (Rmax 0 s) - (phi + al) * K (Rmin 0 s)).
  assert (K0 : K 0 = PI / 2 - asin ((1 - gam) / (1 + gam))).
  { assert (B := asin_bound_lt _ (k_range gam Hgam)). assert (E := kernel_angle_of_place a (gam * a) (- asin ((1 - gam) / (1 + gam))) ltac:(lra) ltac:(lra)).
    rewrite (place_sin gam Hgam a) in E. rewrite sin_neg, sin_asin in E by (generalize (k_range gam Hgam); lra).
    replace (a * (1 + gam) / 2 * ((1 - gam) / (1 + gam) + - ((1 - gam) / (1 + gam)))) with 0 in E by ring. unfold K. rewrite E. ring. }
  assert (Ends : G a - G (- (gam * a)) = 0).
  { unfold G. rewrite (Rmax_right 0 a), (Rmin_left 0 a), (Rmax_left 0 (- (gam * a))), (Rmin_right 0 (- (gam * a))) by lra.
    unfold K at 1 4. rewrite (kernel_angle_right a (gam * a) 0 H0), (kernel_angle_left a (gam * a)). rewrite K0. unfold al, tilt. field. lra. }
  rewrite <- Ends. clear Ends.
  assert (Kc : forall s, - (gam * a) <= s <= a -> continuous K s) by (intros s Hs; apply (angle_continuous a (gam * a) 0 H0); exact Hs).
  assert (Piece : forall c y z, - (gam * a) < y -> y <= z -> z < a -> is_RInt (fun s => c / sqrt ((a - s) * (s + gam * a))) y z (c * K z - c * K y)).
  { intros c y z Hy Hyz Hz. assert (Q : forall s, y <= s <= z -> 0 < sqrt ((a - s) * (s + gam * a))) by (intros s Hs; apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
    apply (is_RInt_antiderivative _ (fun s => c * / sqrt ((a - s) * (s + gam * a))) (fun s => c * K s)); [exact Hyz | reflexivity | |].
    - intros s Hs. apply (is_derive_scal K). apply (angle_derive a (gam * a) 0 H0). lra.
    - intros s Hs. assert (0 < (a - s) * (s + gam * a)) by (apply Rmult_lt_0_compat; lra). assert (Q1 := Q s Hs).
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. change (a + - s) with (a - s). repeat split; lra. }
  assert (Left : forall y z, - (gam * a) < y -> y <= z -> z <= 0 -> is_RInt (fun s => TiltedWedge.slope phi al s / sqrt ((a - s) * (s + gam * a))) y z (G z - G y)).
  { intros y z Hy Hyz Hz. unfold G. rewrite !Rmax_left, !Rmin_right by lra. replace ((phi - al) * K 0 - (phi + al) * K z - ((phi - al) * K 0 - (phi + al) * K y)) with (- (phi + al) * K z - - (phi + al) * K y) by ring.
    refine (is_RInt_ext _ _ _ _ _ _ (Piece (- (phi + al)) y z Hy Hyz ltac:(lra))). intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra.
    unfold TiltedWedge.slope. destruct (Rlt_dec s 0); [reflexivity | lra]. }
  assert (Right : forall y z, 0 <= y -> y <= z -> z < a -> is_RInt (fun s => TiltedWedge.slope phi al s / sqrt ((a - s) * (s + gam * a))) y z (G z - G y)).
  { intros y z Hy Hyz Hz. unfold G. rewrite !Rmax_right, !Rmin_left by lra. replace ((phi - al) * K z - (phi + al) * K 0 - ((phi - al) * K y - (phi + al) * K 0)) with ((phi - al) * K z - (phi - al) * K y) by ring.
    refine (is_RInt_ext _ _ _ _ _ _ (Piece (phi - al) y z ltac:(lra) Hyz Hz)). intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra.
    unfold TiltedWedge.slope. destruct (Rlt_dec s 0); [lra | reflexivity]. }
  apply integral_by_ends.
  - lra.
  - intros y z Hy Hyz Hz. destruct (Rle_lt_dec z 0) as [L | L]; [apply Left; assumption |]. destruct (Rle_lt_dec 0 y) as [M | M]; [apply Right; assumption |].
    replace (G z - G y) with (plus (G 0 - G y) (G z - G 0)) by (unfold plus; simpl; ring).
    apply (is_RInt_Chasles (V := R_NormedModule) _ y 0 z); [apply Left; lra | apply Right; lra].
  - apply (continuous_ext_loc _ (fun s => (phi - al) * K 0 - (phi + al) * K s)).
    + apply (locally_near (- (gam * a)) (gam * a)); [exact Hb |]. intros s Hs. unfold G. rewrite Rmax_left, Rmin_right by lra. reflexivity.
    + apply continuous_sub; [apply continuous_const | apply continuous_times; [apply continuous_const | apply Kc; lra]].
  - apply (continuous_ext_loc _ (fun s => (phi - al) * K s - (phi + al) * K 0)).
    + apply (locally_near a a); [exact Ha |]. intros s Hs. unfold G. rewrite Rmax_right, Rmin_left by lra. reflexivity.
    + apply continuous_sub; [apply continuous_times; [apply continuous_const | apply Kc; lra] | apply continuous_const].
Qed.

Section Rounded.
Variables alpha t R0 a : R.
Hypothesis form : 0 < alpha /\ 0 < t /\ 0 < R0.
Hypothesis Ha : 0 < a.
Let g1 := tilted_rounded_slope alpha t R0.
Let IR : 0 < / R0. Proof. apply Rinv_0_lt_compat. lra. Qed.
Let monotone x y : x <= y -> g1 x <= g1 y.
Proof.
  intros H. unfold g1, tilted_rounded_slope, Rdiv.
  assert (M1 : Rmax (x + alpha * R0) 0 <= Rmax (y + alpha * R0) 0) by (apply Rle_max_compat_r; lra).
  assert (M2 : Rmin (x + 2 * t + alpha * R0) 0 <= Rmin (y + 2 * t + alpha * R0) 0) by (apply Rle_min_compat_r; lra).
  assert (N1 := Rmult_le_compat_r _ _ _ (Rlt_le _ _ IR) M1). assert (N2 := Rmult_le_compat_r _ _ _ (Rlt_le _ _ IR) M2). lra.
Qed.
Let positive x : 0 < x -> 0 < g1 x.
Proof. intros H. unfold g1. rewrite <- (parabola_to_the_right alpha t R0 form x H). apply Rdiv_lt_0_compat; lra. Qed.
Let rises : rises_at g1 0.
Proof.
  split; [intros x z Hxz; apply monotone; lra | split; [exact positive |]]. intros d Hd.
  assert (P := positive (0 + d) ltac:(lra)). assert (N := slope_left alpha t R0 form (0 - d) ltac:(lra)). unfold g1 in *. lra.
Qed.
Let g1_continuous x : continuous g1 x.
Proof.
  assert (A : forall c, continuous (fun x => Rabs (x + c)) x).
  { intros c. apply (continuous_comp (fun x => x + c) Rabs); [| apply continuous_Rabs]. apply continuous_add; [apply continuous_id | apply continuous_const]. }
  assert (I : forall c, continuous (fun x => x + c) x) by (intros c; apply continuous_add; [apply continuous_id | apply continuous_const]).
  apply (continuous_ext (fun x => - alpha + (x + alpha * R0 + Rabs (x + alpha * R0)) / 2 / R0 + (x + (2 * t + alpha * R0) - Rabs (x + (2 * t + alpha * R0))) / 2 / R0)).
  - intros y. unfold g1, tilted_rounded_slope. f_equal; [f_equal |]; f_equal.
    + unfold Rmax. destruct (Rle_dec (y + alpha * R0) 0); [rewrite Rabs_left1 by lra | rewrite Rabs_pos_eq by lra]; in_R; field.
    + unfold Rmin. destruct (Rle_dec (y + 2 * t + alpha * R0) 0); [rewrite Rabs_left1 by lra | rewrite Rabs_pos_eq by lra]; in_R; field.
  - apply continuous_add; [apply continuous_add; [apply continuous_const |] |].
    + apply continuous_quotient; [| apply continuous_const | lra]. apply continuous_quotient; [apply continuous_add; [apply I | apply A] | apply continuous_const | lra].
    + apply continuous_quotient; [| apply continuous_const | lra]. apply continuous_quotient; [apply continuous_sub; [apply I | apply A] | apply continuous_const | lra].
Qed.
Let F b theta := g1 (place a b theta).
Let F_continuous b theta : continuous (F b) theta.
Proof.
  apply (continuous_comp (place a b) g1); [| apply g1_continuous]. unfold place. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Let F_integrable b c d : ex_RInt (F b) c d.
Proof. apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _. apply F_continuous. Qed.
Let total b := RInt (F b) (- (PI / 2)) (PI / 2).
Let total_continuous b : continuous total b.
Proof.
  apply integral_continuous; [generalize PI_RGT_0; lra | | apply filter_forall; intros y; apply F_integrable].
  intros v _. apply continuous_2d. apply (continuous_comp (fun z : R * R => place a (fst z) (snd z)) g1); [| apply g1_continuous].
  unfold place. assert (S : continuous (fun z : R * R => sin (snd z)) (b, v)) by (apply (continuous_comp (fun z : R * R => snd z) sin); [apply continuous_snd | apply continuous_sin]).
  apply continuous_add; [| apply continuous_times; [| exact S]].
  - apply continuous_quotient; [apply continuous_sub; [apply continuous_const | apply continuous_fst] | apply continuous_const | lra].
  - apply continuous_quotient; [apply continuous_add; [apply continuous_const | apply continuous_fst] | apply continuous_const | lra].
Qed.
Let at_0 : 0 <= total 0.
Proof.
  apply RInt_ge_0; [generalize PI_RGT_0; lra | apply F_integrable |]. intros theta _. unfold F.
  assert (P : 0 <= place a 0 theta) by (unfold place; generalize (SIN_bound theta); intros; nra).
  apply Rle_trans with (g1 0); [unfold g1; rewrite (lowest_at_origin alpha t R0 form); lra | apply monotone, P].
Qed.
Let far := a + 2 * (2 * t + a + alpha * R0).
Let at_far : total far <= 0.
Proof.
  assert (Hpi := PI_RGT_0). assert (AR : 0 < alpha * R0) by (apply Rmult_lt_0_compat; lra). unfold total.
  rewrite <- (RInt_Chasles (F far) (- (PI / 2)) 0 (PI / 2)) by apply F_integrable. unfold plus; simpl.
  assert (L : RInt (F far) (- (PI / 2)) 0 <= RInt (fun _ => g1 (- (2 * t + a + alpha * R0))) (- (PI / 2)) 0).
  { apply RInt_le; [lra | apply F_integrable | apply ex_RInt_const |]. intros theta Ht. apply monotone. assert (S : sin theta <= 0) by (rewrite <- sin_0; apply sin_incr_1; lra).
    unfold place, far. nra. }
  assert (R : RInt (F far) 0 (PI / 2) <= RInt (fun _ => g1 a) 0 (PI / 2)).
  { apply RInt_le; [lra | apply F_integrable | apply ex_RInt_const |]. intros theta Ht. apply monotone. generalize (SIN_bound theta). intros. unfold place, far. nra. }
  rewrite RInt_const in L, R. unfold scal in L, R; simpl in L, R; unfold mult in L, R; simpl in L, R.
  assert (E1 : g1 a = a * / R0) by (unfold g1; rewrite <- (parabola_to_the_right alpha t R0 form a Ha); reflexivity).
  assert (E2 : g1 (- (2 * t + a + alpha * R0)) = - ((a + alpha * R0) * / R0)).
  { unfold g1, tilted_rounded_slope. rewrite Rmax_right, Rmin_left by lra. field. lra. }
  rewrite E1, E2 in *. assert (0 < alpha * R0 * / R0) by (apply Rmult_lt_0_compat; assumption). nra.
Qed.
Lemma rounded_consistency : exists b, is_the_left_edge g1 a b /\
  is_RInt_gen (fun s => g1 s / sqrt ((a - s) * (s + b))) (at_right (- b)) (at_left a) 0.
Proof.
  assert (AR : 0 < alpha * R0) by (apply Rmult_lt_0_compat; lra).
  destruct (IVT_gen total 0 far 0) as (b & Hb & E).
  - intros b. apply continuity_pt_filterlim, total_continuous.
  - assert (H0 := at_0). assert (H1 := at_far). rewrite Rmin_right, Rmax_left by lra. lra.
  - unfold far in Hb. rewrite Rmin_left in Hb by lra. exists b.
    assert (C : is_RInt (F b) (- (PI / 2)) (PI / 2) 0) by (rewrite <- E; apply (@RInt_correct R_CompleteNormedModule), F_integrable).
    split; [apply (the_left_edge _ 0); [exact rises | exact Ha | lra | exact C] |].
    apply (integral_over_places g1 a b); [lra | exact g1_continuous | exact C].
Qed.
End Rounded.

Theorem printed_consistency phi gam alpha t R0 a : 0 < a ->
  (0 < phi /\ 0 < gam -> is_the_left_edge (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) /\
    is_RInt_gen (fun s => TiltedWedge.slope phi (tilt phi gam) s / sqrt ((a - s) * (s + gam * a))) (at_right (- (gam * a))) (at_left a) 0) /\
  (0 < alpha /\ 0 < t /\ 0 < R0 -> exists b, is_the_left_edge (tilted_rounded_slope alpha t R0) a b /\
    is_RInt_gen (fun s => tilted_rounded_slope alpha t R0 s / sqrt ((a - s) * (s + b))) (at_right (- b)) (at_left a) 0).
Proof.
  intros Ha. split; [intros [Hphi Hgam]; apply wedge_consistency; repeat split; assumption | intros form; apply rounded_consistency; assumption].
Qed.
