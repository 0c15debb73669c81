(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics Gamma PowerLaw.
Open Scope R_scope.

(* ---- Power laws with an exponent that grows without bound ---- *)

(* (m + 1) q^m tends to 0. *)
Lemma growth_dies q : 0 < q < 1 -> filterlim (fun m => (m + 1) * Rpower q m) (Rbar_locally p_infty) (locally 0).
Proof.
  intros Hq. assert (L : ln q < 0) by (rewrite <- ln_1; apply ln_increasing; lra). set (k := - ln q / 2). assert (Hk : 0 < k) by (unfold k; lra).
  intros P [e He]. destruct e as [e Hep]. simpl in He.
  exists (Rmax 1 (2 / (k ^ 2 * e))). intros m Hm. apply He.
  assert (M1 := Rmax_l 1 (2 / (k ^ 2 * e))). assert (M2 := Rmax_r 1 (2 / (k ^ 2 * e))).
  unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl. rewrite Ropp_0, Rplus_0_r.
  assert (E : Rpower q m = / (exp (k * m) * exp (k * m))).
  { rewrite <- exp_plus, <- exp_Ropp. unfold Rpower, k. f_equal. field. }
  assert (X : k * m < exp (k * m)).
  { assert (Z : k * m <> 0) by (apply Rgt_not_eq, Rmult_lt_0_compat; lra). generalize (exp_ineq1 (k * m) Z). lra. }
  assert (Hkm : 0 < k * m) by (apply Rmult_lt_0_compat; lra).
  assert (X2 : (k * m) * (k * m) < exp (k * m) * exp (k * m)) by (apply Rmult_le_0_lt_compat; lra).
  assert (Pos : 0 < (k * m) * (k * m)) by (apply Rmult_lt_0_compat; lra).
  rewrite Rabs_pos_eq by (apply Rmult_le_pos; [lra | apply Rlt_le, exp_pos]). rewrite E.
  apply Rlt_trans with ((m + 1) * / ((k * m) * (k * m))).
  - apply Rmult_lt_compat_l; [lra |]. apply Rinv_lt_contravar; [apply Rmult_lt_0_compat; lra | exact X2].
  - apply Rle_lt_trans with (2 * m * / ((k * m) * (k * m))); [apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, Pos | lra] |].
    replace (2 * m * / (k * m * (k * m))) with (2 / (k ^ 2) / m) by (field; split; lra).
    assert (K2 : 0 < k ^ 2) by (apply pow_lt, Hk).
    apply (Rmult_lt_reg_r m); [lra |]. replace (2 / k ^ 2 / m * m) with (2 / k ^ 2) by (field; split; lra).
    apply Rle_lt_trans with (e * (2 / (k ^ 2 * e))); [right; field; split; lra |]. apply Rmult_lt_compat_l; lra.
Qed.

Section Place.
Variables a x : R.
Hypothesis Hx : 0 < x < a.
Let c := sqrt (a - x).
Let c0' : 0 < c. Proof. apply sqrt_lt_R0. lra. Qed.
Let c2' : c ^ 2 = a - x. Proof. apply pow2_sqrt. lra. Qed.
Let f m w := 2 * (Rpower (x + w ^ 2) m / sqrt (x + (x + w ^ 2))).
Let I m := RInt (f m) 0 c.
(* The pressure divided by that of a rectangular punch with the same load. *)
Definition flat_share m := (m + 1) * sqrt (a ^ 2 - x ^ 2) / Rpower a (m + 1) * I m.

Lemma f_continuous m w : continuous (f m) w.
Proof.
  assert (0 <= w ^ 2) by apply pow2_ge_0. assert (0 < x + w ^ 2) by lra. assert (0 < sqrt (x + (x + w ^ 2))) by (apply sqrt_lt_R0; lra).
  apply continuous_times; [apply continuous_const |]. apply continuous_quotient; [| | lra].
  - apply (continuous_comp (fun w => x + w ^ 2) (fun s => Rpower s m)).
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold Rpower. auto_derive. assumption.
  - apply (continuous_comp (fun w => x + (x + w ^ 2)) sqrt); [| apply continuous_sqrt].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma f_integrable m l r : ex_RInt (f m) l r.
Proof. apply (@ex_RInt_continuous R_CompleteNormedModule). intros w _. apply f_continuous. Qed.
Let g m w := 2 * w * ((m + 1) * Rpower (x + w ^ 2) m).
Lemma g_integral m l r : l <= r -> is_RInt (g m) l r (Rpower (x + r ^ 2) (m + 1) - Rpower (x + l ^ 2) (m + 1)).
Proof.
  intros H. apply (is_RInt_antiderivative _ (g m) (fun w => Rpower (x + w ^ 2) (m + 1))); [exact H | reflexivity | |].
  - intros w _. assert (0 <= w ^ 2) by apply pow2_ge_0. assert (P : 0 < x + w ^ 2) by lra.
    assert (D := derive_power 1 (m + 1) (x + w ^ 2) P). replace (m + 1 - 1) with m in D by ring.
    unfold g. replace (2 * w * ((m + 1) * Rpower (x + w ^ 2) m)) with ((2 * w) * (1 * (m + 1) * Rpower (x + w ^ 2) m)) by ring.
    apply (is_derive_ext (fun w => 1 * Rpower (x + w ^ 2) (m + 1))).
    { intros z. match goal with |- @eq _ ?x ?y => change (@eq R x y) end. ring. }
    apply (is_derive_comp (fun s => 1 * Rpower s (m + 1)) (fun w => x + w ^ 2) w _ (2 * w) D). auto_derive; [trivial | ring].
  - intros w _. assert (0 <= w ^ 2) by apply pow2_ge_0. unfold g. apply continuous_times.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
    + apply continuous_times; [apply continuous_const |]. apply (continuous_comp (fun w => x + w ^ 2) (fun s => Rpower s m)).
      * apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
      * apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold Rpower. auto_derive. lra.
Qed.
(* f = g k / (m + 1), where k falls with w, down to 1 / sqrt(a^2 - x^2). *)
Let k w := / (w * sqrt (x + (x + w ^ 2))).
Lemma k_falls v w : 0 < v <= w -> 0 < k w <= k v.
Proof.
  intros H. assert (V : 0 < sqrt (x + (x + v ^ 2))) by (apply sqrt_lt_R0; nra).
  assert (W : sqrt (x + (x + v ^ 2)) <= sqrt (x + (x + w ^ 2))) by (apply sqrt_le_1_alt; nra). unfold k.
  assert (0 < v * sqrt (x + (x + v ^ 2))) by (apply Rmult_lt_0_compat; lra).
  split; [apply Rinv_0_lt_compat; apply Rmult_lt_0_compat; lra |]. apply Rinv_le_contravar; [assumption |]. apply Rmult_le_compat; lra.
Qed.
Lemma k_at_c : k c = / sqrt (a ^ 2 - x ^ 2).
Proof.
  unfold k. f_equal. rewrite c2'. unfold c. rewrite <- sqrt_mult by lra. f_equal. ring.
Qed.
Lemma f_by_g m w : 0 <= m -> 0 < w -> f m w = g m w * k w / (m + 1).
Proof.
  intros Hm H. assert (0 < sqrt (x + (x + w ^ 2))) by (apply sqrt_lt_R0; nra). unfold f, g, k. field. repeat split; lra.
Qed.
Let A0 : 0 < sqrt (a ^ 2 - x ^ 2). Proof. apply sqrt_lt_R0. nra. Qed.

Lemma share_above m : 0 <= m -> 1 - x / a * Rpower (x / a) m <= flat_share m.
Proof.
  intros Hm. unfold flat_share. assert (Pa : 0 < Rpower a (m + 1)) by apply exp_pos.
  assert (B : (Rpower (x + c ^ 2) (m + 1) - Rpower (x + 0 ^ 2) (m + 1)) * (k c / (m + 1)) <= I m).
  { assert (G : is_RInt (fun w => k c / (m + 1) * g m w) 0 c (k c / (m + 1) * (Rpower (x + c ^ 2) (m + 1) - Rpower (x + 0 ^ 2) (m + 1))))
      by exact (is_RInt_scal (V := R_NormedModule) _ _ _ (k c / (m + 1)) _ (g_integral m 0 c ltac:(generalize c0'; lra))).
    rewrite Rmult_comm.
    rewrite <- (is_RInt_unique (V := R_CompleteNormedModule) _ _ _ _ G).
    apply RInt_le; [generalize c0'; lra | eexists; exact G | apply f_integrable |].
    intros w Hw. rewrite f_by_g by lra. destruct (k_falls w c ltac:(lra)) as [K1 K2].
    assert (0 <= g m w) by (unfold g; apply Rmult_le_pos; [lra | apply Rmult_le_pos; [lra | apply Rlt_le, exp_pos]]).
    assert (0 < / (m + 1)) by (apply Rinv_0_lt_compat; lra). unfold Rdiv.
    replace (k c * / (m + 1) * g m w) with (g m w * / (m + 1) * k c) by ring. replace (g m w * k w * / (m + 1)) with (g m w * / (m + 1) * k w) by ring.
    apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact K2]. }
  rewrite k_at_c, c2' in B. replace (x + (a - x)) with a in B by ring. replace (x + 0 ^ 2) with x in B by ring.
  apply (Rmult_le_compat_l ((m + 1) * sqrt (a ^ 2 - x ^ 2) / Rpower a (m + 1))) in B.
  2: { apply Rlt_le, Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | exact Pa]. }
  apply Rle_trans with (2 := B). right.
  replace (x / a * Rpower (x / a) m) with (Rpower x (m + 1) / Rpower a (m + 1)).
  - field. repeat split; lra.
  - unfold Rdiv. rewrite <- (Rpower_mult_distr x (/ a)) by (try apply Rinv_0_lt_compat; lra).
    replace (Rpower (/ a) m) with (/ Rpower a m) by (rewrite <- Rpower_Ropp; unfold Rpower; rewrite ln_Rinv by lra; f_equal; ring).
    rewrite !Rpower_plus, !Rpower_1 by lra. assert (0 < Rpower a m) by apply exp_pos. field. lra.
Qed.
Lemma share_below m v : 0 <= m -> 0 < v < c ->
  flat_share m <= k v * sqrt (a ^ 2 - x ^ 2) + (2 * c * sqrt (a ^ 2 - x ^ 2) / (sqrt x * a)) * ((m + 1) * Rpower ((x + v ^ 2) / a) m).
Proof.
  intros Hm Hv. unfold flat_share. assert (Pa : 0 < Rpower a (m + 1)) by apply exp_pos. assert (Pm : 0 < Rpower a m) by apply exp_pos.
  assert (Sx : 0 < sqrt x) by (apply sqrt_lt_R0; lra).
  assert (E : I m = RInt (f m) 0 v + RInt (f m) v c) by (symmetry; apply (RInt_Chasles (V := R_CompleteNormedModule) (f m) 0 v c); apply f_integrable).
  assert (B1 : RInt (f m) 0 v <= v * (2 * (Rpower (x + v ^ 2) m / sqrt x))).
  { replace (v * (2 * (Rpower (x + v ^ 2) m / sqrt x))) with (RInt (fun _ => 2 * (Rpower (x + v ^ 2) m / sqrt x)) 0 v)
      by (rewrite RInt_const; unfold scal; simpl; unfold mult; simpl; ring).
    apply RInt_le; [lra | apply f_integrable | apply ex_RInt_const |]. intros w Hw. unfold f. apply Rmult_le_compat_l; [lra |].
    apply Rmult_le_compat.
    - apply Rlt_le, exp_pos.
    - apply Rlt_le, Rinv_0_lt_compat, sqrt_lt_R0. nra.
    - apply Rle_Rpower_l; [lra |]. nra.
    - apply Rinv_le_contravar; [exact Sx |]. apply sqrt_le_1_alt. nra. }
  assert (B2 : RInt (f m) v c <= Rpower a (m + 1) * (k v / (m + 1))).
  { assert (G : is_RInt (fun w => k v / (m + 1) * g m w) v c (k v / (m + 1) * (Rpower (x + c ^ 2) (m + 1) - Rpower (x + v ^ 2) (m + 1))))
      by exact (is_RInt_scal (V := R_NormedModule) _ _ _ (k v / (m + 1)) _ (g_integral m v c ltac:(lra))).
    apply Rle_trans with (k v / (m + 1) * (Rpower (x + c ^ 2) (m + 1) - Rpower (x + v ^ 2) (m + 1))).
    - rewrite <- (is_RInt_unique (V := R_CompleteNormedModule) _ _ _ _ G).
      apply RInt_le; [lra | apply f_integrable | eexists; exact G |].
      intros w Hw. rewrite f_by_g by lra. destruct (k_falls v w ltac:(lra)) as [K1 K2].
      assert (0 <= g m w) by (unfold g; apply Rmult_le_pos; [lra | apply Rmult_le_pos; [lra | apply Rlt_le, exp_pos]]).
      assert (0 < / (m + 1)) by (apply Rinv_0_lt_compat; lra). unfold Rdiv.
      replace (k v * / (m + 1) * g m w) with (g m w * / (m + 1) * k v) by ring. replace (g m w * k w * / (m + 1)) with (g m w * / (m + 1) * k w) by ring.
      apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact K2].
    - rewrite c2'. replace (x + (a - x)) with a by ring. destruct (k_falls v v ltac:(lra)) as [K1 _].
      assert (0 < Rpower (x + v ^ 2) (m + 1)) by apply exp_pos. assert (0 < k v / (m + 1)) by (apply Rdiv_lt_0_compat; lra).
      rewrite Rmult_comm. apply Rmult_le_compat_r; lra. }
  apply Rle_trans with ((m + 1) * sqrt (a ^ 2 - x ^ 2) / Rpower a (m + 1) * (c * (2 * (Rpower (x + v ^ 2) m / sqrt x)) + Rpower a (m + 1) * (k v / (m + 1)))).
  - apply Rmult_le_compat_l; [apply Rlt_le, Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | exact Pa] |].
    rewrite E. apply Rplus_le_compat; [| exact B2]. apply (Rle_trans _ _ _ B1). apply Rmult_le_compat_r; [| lra].
    apply Rlt_le, Rmult_lt_0_compat; [lra |]. apply Rdiv_lt_0_compat; [apply exp_pos | exact Sx].
  - right. assert (Q : Rpower ((x + v ^ 2) / a) m = Rpower (x + v ^ 2) m / Rpower a m).
    { unfold Rdiv. rewrite <- Rpower_mult_distr by (try apply Rinv_0_lt_compat; nra).
      replace (Rpower (/ a) m) with (/ Rpower a m) by (rewrite <- Rpower_Ropp; unfold Rpower; rewrite ln_Rinv by lra; f_equal; ring). reflexivity. }
    rewrite Q, Rpower_plus, Rpower_1 by lra. field. repeat split; lra.
Qed.

Theorem share_limit : filterlim flat_share (Rbar_locally p_infty) (locally 1).
Proof.
  intros P [e He]. destruct e as [e Hep]. simpl in He.
  assert (Ck : continuous (fun v => k v * sqrt (a ^ 2 - x ^ 2)) c).
  { assert (0 < sqrt (x + (x + c ^ 2))) by (apply sqrt_lt_R0; rewrite c2'; lra).
    apply continuous_times; [| apply continuous_const]. unfold k.
    apply (continuous_comp (fun v => v * sqrt (x + (x + v ^ 2))) Rinv); [| apply continuous_Rinv; apply Rgt_not_eq, Rmult_lt_0_compat; [exact c0' | assumption]].
    apply continuous_times; [apply continuous_id |]. apply (continuous_comp (fun v => x + (x + v ^ 2)) sqrt); [| apply continuous_sqrt].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
  assert (K1 : k c * sqrt (a ^ 2 - x ^ 2) = 1) by (rewrite k_at_c; apply Rinv_l; generalize A0; lra).
  unfold continuous in Ck. rewrite K1 in Ck.
  destruct (Ck (fun y => y < 1 + e / 2)) as [[d Hd] Near].
  { exists (mkposreal (e / 2) ltac:(lra)). intros y Hy. unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
    apply Rabs_def2 in Hy. lra. }
  simpl in Near. set (v := c - Rmin d c / 2). assert (Hm : 0 < Rmin d c) by (apply Rmin_pos; [exact Hd | exact c0']).
  assert (M1 := Rmin_l d c). assert (M2 := Rmin_r d c).
  assert (Hv : 0 < v < c) by (unfold v; lra).
  assert (Kv : k v * sqrt (a ^ 2 - x ^ 2) < 1 + e / 2).
  { apply Near. unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl. rewrite Rabs_left; unfold v; lra. }
  set (N := 2 * c * sqrt (a ^ 2 - x ^ 2) / (sqrt x * a)).
  assert (HN : 0 < N).
  { assert (0 < sqrt x) by (apply sqrt_lt_R0; lra). generalize c0' A0. intros. unfold N. apply Rdiv_lt_0_compat; apply Rmult_lt_0_compat; lra. }
  assert (Hv2 : v ^ 2 < c ^ 2) by nra. rewrite c2' in Hv2.
  assert (Q : 0 < (x + v ^ 2) / a < 1).
  { assert (0 < v ^ 2) by (apply pow_lt; lra). split; [apply Rdiv_lt_0_compat; lra |].
    apply (Rmult_lt_reg_r a); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (Q' : 0 < x / a < 1).
  { split; [apply Rdiv_lt_0_compat; lra |]. apply (Rmult_lt_reg_r a); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  destruct (growth_dies _ Q (fun y => y < e / (2 * N))) as [m1 H1].
  { assert (Hq : 0 < e / (2 * N)) by (apply Rdiv_lt_0_compat; lra). exists (mkposreal _ Hq). intros y Hy.
    unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy. apply Rabs_def2 in Hy. lra. }
  destruct (growth_dies _ Q' (fun y => y < e)) as [m2 H2].
  { exists (mkposreal e Hep). intros y Hy. unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy. apply Rabs_def2 in Hy. lra. }
  exists (Rmax 0 (Rmax m1 m2)). intros m Hmm. assert (L1 := Rmax_l 0 (Rmax m1 m2)). assert (L2 := Rmax_r 0 (Rmax m1 m2)).
  assert (L3 := Rmax_l m1 m2). assert (L4 := Rmax_r m1 m2).
  assert (B1 := share_below m v ltac:(lra) Hv). assert (B2 := share_above m ltac:(lra)). fold N in B1.
  specialize (H1 m ltac:(lra)). specialize (H2 m ltac:(lra)). cbv beta in H1, H2.
  assert (N * ((m + 1) * Rpower ((x + v ^ 2) / a) m) < e / 2).
  { apply Rlt_le_trans with (N * (e / (2 * N))); [apply Rmult_lt_compat_l; assumption | right; field; lra]. }
  assert (R0 : 0 < Rpower (x / a) m) by apply exp_pos.
  assert (x / a * Rpower (x / a) m < e) by nra.
  apply He. unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl. apply Rabs_def1; lra.
Qed.
End Place.

Section Limits.
Variables Es C a x : R.
Hypothesis form : 0 < Es /\ 0 < C /\ 0 < x < a.
Let I (m : R) : R := RInt (fun w => 2 * (Rpower (x + w ^ 2) m / sqrt (x + (x + w ^ 2)))) 0 (sqrt (a - x)).
Let p (m : R) : R := 1 / PI * (Es * C * wallis (m + 1) * (m + 1)) * I m.

Theorem becomes_rectangular : exists p P : R -> R,
  (forall m, 0 <= m -> is_the_pressure Es (power_slope C m) a x (p m) /\ is_the_load Es (power_slope C m) a a (P m)) /\
  filterlim (fun m => p m / (P m / (PI * sqrt (a ^ 2 - x ^ 2)))) (Rbar_locally p_infty) (locally 1).
Proof.
  assert (A0 : 0 < sqrt (a ^ 2 - x ^ 2)) by (apply sqrt_lt_R0; nra). assert (Hpi := PI_RGT_0).
  exists p, (fun m => power_load Es C m a). split.
  - intros m Hm. split; [apply power_the_pressure; lra | apply power_the_load; lra].
  - apply (filterlim_ext_loc (flat_share a x)); [| apply share_limit; lra].
    exists 0. intros m Hm. assert (W := wallis_positive (m + 1) ltac:(lra)). unfold flat_share, p, power_load. fold (I m).
    assert (0 < Rpower a (m + 1)) by apply exp_pos.
    match goal with |- @eq _ ?x ?y => change (@eq R x y) end. field. repeat split; lra.
Qed.
Theorem one_term_diverges : exists p P r : R -> R,
  (forall m, 0 <= m -> is_the_pressure Es (power_slope C m) a x (p m) /\ is_the_load Es (power_slope C m) a a (P m) /\
    exists r1 r2, is_the_right_series Es (power_slope C m) a (r m) r1 r2) /\
  filterlim (fun m => r m * sqrt (a - x) / p m) (Rbar_locally p_infty) (Rbar_locally p_infty) /\
  filterlim (fun m => r m * sqrt (a - x) * a / P m) (Rbar_locally p_infty) (Rbar_locally p_infty).
Proof.
  assert (A0 : 0 < sqrt (a ^ 2 - x ^ 2)) by (apply sqrt_lt_R0; nra). assert (Hpi := PI_RGT_0).
  assert (S1 : 0 < sqrt (a - x)) by (apply sqrt_lt_R0; lra). assert (S2 : 0 < sqrt (a + a)) by (apply sqrt_lt_R0; lra).
  exists p, (fun m => power_load Es C m a), (fun m => c0 (power_load_1 Es C m) (fun s => s) a). split; [| split].
  - intros m Hm. split; [apply power_the_pressure; lra |]. split; [apply power_the_load; lra |]. do 2 eexists.
    apply (the_right_series _ _ 0); [apply power_slope_rises; lra | lra |]. exact (right_edge _ _ _ _ _ _ _ _ _ _ (power_smooth_contact Es C m Hm a ltac:(lra))).
  - set (N := 2 * sqrt (a - x) * sqrt (a ^ 2 - x ^ 2) / (sqrt (a + a) * a)).
    assert (HN : 0 < N) by (unfold N; apply Rdiv_lt_0_compat; repeat first [lra | apply Rmult_lt_0_compat]).
    destruct (share_limit a x ltac:(lra) (fun y => 0 < y < 2)) as [m0 H0].
    { exists (mkposreal (1 / 2) ltac:(lra)). intros y Hy. unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
      apply Rabs_def2 in Hy. lra. }
    intros P [M HM]. exists (Rmax (Rmax 0 m0) (2 * M / N)). intros m Hm.
    assert (L1 := Rmax_l (Rmax 0 m0) (2 * M / N)). assert (L2 := Rmax_r (Rmax 0 m0) (2 * M / N)). assert (L3 := Rmax_l 0 m0). assert (L4 := Rmax_r 0 m0).
    apply HM. specialize (H0 m ltac:(lra)). cbv beta in H0. assert (W := wallis_positive (m + 1) ltac:(lra)).
    assert (Pm : 0 < Rpower a m) by apply exp_pos.
    assert (EI : I m = flat_share a x m * (Rpower a m * a) / ((m + 1) * sqrt (a ^ 2 - x ^ 2))).
    { unfold flat_share. fold (I m). rewrite Rpower_plus, Rpower_1 by lra. match goal with |- @eq _ ?x ?y => change (@eq R x y) end. field. repeat split; lra. }
    set (T := flat_share a x m) in *.
    assert (E : c0 (power_load_1 Es C m) (fun s => s) a * sqrt (a - x) / p m = N * (m + 1) / T).
    { unfold c0, power_load_1, p, N. rewrite EI. replace (m + 1 - 1) with m by ring. match goal with |- @eq _ ?x ?y => change (@eq R x y) end. field. repeat split; lra. }
    rewrite E. apply (Rmult_lt_reg_r T); [lra |]. replace (N * (m + 1) / T * T) with (N * (m + 1)) by (field; lra).
    assert (2 * M < N * m).
    { apply (Rmult_lt_compat_l N) in Hm; [| exact HN]. assert (Q : N * (2 * M / N) <= N * Rmax (Rmax 0 m0) (2 * M / N)) by (apply Rmult_le_compat_l; lra).
      replace (N * (2 * M / N)) with (2 * M) in Q by (field; lra). lra. }
    assert (0 < N * m) by (apply Rmult_lt_0_compat; lra).
    destruct (Rle_lt_dec M 0) as [Z | Z]; [nra |]. assert (M * T < M * 2) by (apply Rmult_lt_compat_l; lra). lra.
  - set (N := 2 * sqrt (a - x) / (PI * sqrt (a + a))).
    assert (HN : 0 < N) by (unfold N; apply Rdiv_lt_0_compat; repeat first [lra | apply Rmult_lt_0_compat]).
    intros Q [M HM]. exists (Rmax 0 (M / N)). intros m Hm. assert (L1 := Rmax_l 0 (M / N)). assert (L2 := Rmax_r 0 (M / N)).
    apply HM. assert (W := wallis_positive (m + 1) ltac:(lra)). assert (Pm : 0 < Rpower a m) by apply exp_pos.
    replace (c0 (power_load_1 Es C m) (fun s => s) a * sqrt (a - x) * a / power_load Es C m a) with (N * (m + 1)).
    2: { unfold c0, power_load_1, power_load, N. replace (m + 1 - 1) with m by ring. rewrite Rpower_plus, Rpower_1 by lra. field. repeat split; lra. }
    apply Rle_lt_trans with (N * (M / N)); [right; field; lra |]. apply Rmult_lt_compat_l; lra.
Qed.
End Limits.
