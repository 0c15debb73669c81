(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients.
Open Scope R_scope.

(* The integral of a pressure over the contact is the load, for contacts whose left edge is in
   proportion to the right one. *)

Lemma integral_continuous (F : R -> R -> R) (c d x : R) : c <= d ->
  (forall v, c <= v <= d -> continuity_2d_pt F x v) ->
  locally x (fun y => ex_RInt (F y) c d) -> continuous (fun x => RInt (F x) c d) x.
Proof.
  intros Hcd HF [r Hr] P [e He].
  assert (He' : 0 < e / (d - c + 1)) by (apply Rdiv_lt_0_compat; [apply cond_pos | lra]).
  destruct (uniform_continuity_2d_1d' F c d x HF (mkposreal _ He')) as [del H].
  exists (mkposreal (Rmin r (del / 2)) ltac:(apply Rmin_pos; [apply cond_pos | generalize (cond_pos del); lra])).
  intros y Hy. apply He.
  assert (Hyr : ball x r y) by (eapply ball_le; [apply Rmin_l | exact Hy]).
  assert (Hyd : Rabs (y - x) < del / 2).
  { unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
    eapply Rlt_le_trans; [exact Hy | apply Rmin_r]. }
  assert (Dp := cond_pos del). apply Rabs_def2 in Hyd.
  assert (Ey := Hr y Hyr). assert (Ex := Hr x (ball_center x r)).
  unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl.
  assert (S := RInt_minus (V := R_CompleteNormedModule) _ _ _ _ Ey Ex). unfold minus, plus, opp in S; simpl in S.
  unfold Rminus in S. rewrite <- S.
  apply Rle_lt_trans with ((d - c) * (e / (d - c + 1))).
  - apply abs_RInt_le_const; [exact Hcd | exact (ex_RInt_minus (V := R_NormedModule) _ _ _ _ Ey Ex) |].
    intros v Hv. apply Rlt_le. change (Rabs (F y v - F x v) < e / (d - c + 1)).
    apply (H v x v y); try lra. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra.
  - assert (E0 := cond_pos e). apply (Rmult_lt_reg_r (d - c + 1)); [lra |]. field_simplify; [| lra]. nra.
Qed.

Lemma squeezed (F : (R -> Prop) -> Prop) (f g : R -> R) : Filter F -> F (fun x => Rabs (f x) <= g x) ->
  filterlim g F (locally 0) -> filterlim f F (locally 0).
Proof.
  intros HF B L. apply (filterlim_le_le (fun x => - g x) f g (Finite 0)); [| | exact L].
  - apply filter_imp with (2 := B). intros x Hx. apply Rabs_le_between, Hx.
  - change (Rbar_locally (Finite 0)) with (locally 0). rewrite <- Ropp_0 at 1.
    exact (filterlim_comp _ _ _ g (fun y => opp y) F (locally 0) _ L (filterlim_opp (V := R_NormedModule) 0)).
Qed.

Section Half.
Variables (P P1 : R -> R) (gam a K : R).
Hypothesis Hg : 0 < gam.
Hypothesis Ha : 0 < a.
Hypothesis HP : forall s, 0 < s -> is_derive P s (P1 s).
Hypothesis HP1 : forall s, 0 < s -> continuous P1 s.
Hypothesis HK : forall s, 0 < s <= a -> Rabs (P s) <= K * s.

(* s = x (1 + v^2), x + gam s = x w (v). *)
Let w v := 1 + gam * (1 + v ^ 2).
Let V x := sqrt ((a - x) / x).
Let k x v := 2 / PI * (P1 (x * (1 + v ^ 2)) / sqrt (w v)).
Definition ray_pressure (x : R) : R := RInt (k x) 0 (V x).

Let w_pos v : 1 < w v.
Proof. unfold w. assert (0 <= v ^ 2) by apply pow2_ge_0. nra. Qed.
Let root_pos v : 0 < sqrt (w v).
Proof. apply sqrt_lt_R0. generalize (w_pos v). lra. Qed.
Let s_pos x v : 0 < x -> 0 < x * (1 + v ^ 2).
Proof. intros H. assert (0 <= v ^ 2) by apply pow2_ge_0. apply Rmult_lt_0_compat; lra. Qed.
Let V_sq x : 0 < x <= a -> V x ^ 2 = (a - x) / x.
Proof. intros H. apply pow2_sqrt. apply Rdiv_le_0_compat; lra. Qed.
Let V_end x : 0 < x <= a -> x * (1 + V x ^ 2) = a.
Proof. intros H. rewrite V_sq by exact H. field. lra. Qed.
Let V_nonneg x : 0 <= V x. Proof. apply sqrt_pos. Qed.

Let s_continuous x v : continuous (fun z : R * R => fst z * (1 + snd z ^ 2)) (x, v).
Proof.
  apply continuous_times; [apply continuous_fst |]. apply continuous_add; [apply continuous_const |].
  apply continuous_square, continuous_snd.
Qed.
Let root_continuous x v : continuous (fun z : R * R => sqrt (w (snd z))) (x, v).
Proof.
  apply (continuous_comp (fun z : R * R => w (snd z)) sqrt); [| apply continuous_sqrt].
  unfold w. apply continuous_add; [apply continuous_const |]. apply continuous_times; [apply continuous_const |].
  apply continuous_add; [apply continuous_const |]. apply continuous_square, continuous_snd.
Qed.
Let k_continuous x v : 0 < x -> continuous (fun z : R * R => k (fst z) (snd z)) (x, v).
Proof.
  intros H. unfold k. apply continuous_times; [apply continuous_const |].
  apply continuous_quotient; [| apply root_continuous | apply Rgt_not_eq, root_pos].
  apply (continuous_comp (fun z : R * R => fst z * (1 + snd z ^ 2)) P1); [apply s_continuous | apply HP1, s_pos, H].
Qed.
Let slice (G : R -> R -> R) x v : continuous (fun z : R * R => G (fst z) (snd z)) (x, v) -> continuous (G x) v.
Proof.
  intros H. apply (continuous_comp (fun v => (x, v)) (fun z : R * R => G (fst z) (snd z))); [| exact H].
  apply (continuous_comp_2 (fun _ : R => x) (fun v : R => v) (fun x v => (x, v))); [apply continuous_const | apply continuous_id |].
  apply (continuous_ext (fun z : R * R => z)); [intros [? ?]; reflexivity | apply continuous_id].
Qed.
Let k_integrable x c d : 0 < x -> ex_RInt (k x) c d.
Proof.
  intros H. apply (@ex_RInt_continuous R_CompleteNormedModule). intros v _. apply (slice k), k_continuous, H.
Qed.

(* It is Barber and Mossakovskii's integral. *)
Lemma ray_pressure_is_improper x : 0 < x < a ->
  is_improper_integral (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + gam * s)))) x a (ray_pressure x).
Proof.
  intros Hx. assert (Hpi := PI_RGT_0). assert (Hrx := sqrt_lt_R0 x ltac:(lra)).
  assert (E : RInt (fun y => 2 / PI * (P1 (x + y ^ 2) / sqrt (x + gam * (x + y ^ 2)))) 0 (sqrt (a - x)) = ray_pressure x).
  { unfold ray_pressure.
    assert (EV : sqrt (a - x) = sqrt x * V x + 0).
    { rewrite Rplus_0_r. unfold V. rewrite <- sqrt_mult_alt by lra. f_equal. field. lra. }
    rewrite EV. replace 0 with (sqrt x * 0 + 0) at 1 by ring.
    rewrite <- (RInt_comp_lin (V := R_CompleteNormedModule) (fun y => 2 / PI * (P1 (x + y ^ 2) / sqrt (x + gam * (x + y ^ 2)))) (sqrt x) 0 0 (V x)).
    - apply RInt_ext. intros v _. unfold scal; simpl; unfold mult; simpl. unfold k.
      replace (x + (sqrt x * v + 0) * ((sqrt x * v + 0) * 1)) with (x * (1 + v ^ 2))
        by (replace ((sqrt x * v + 0) * ((sqrt x * v + 0) * 1)) with ((sqrt x * sqrt x) * v ^ 2) by ring; rewrite sqrt_sqrt by lra; ring).
      replace (x + gam * (x * (1 + v ^ 2))) with (x * w v) by (unfold w; ring).
      rewrite sqrt_mult_alt by lra. change (v * (v * 1)) with (v ^ 2).
      generalize (root_pos v). intros. field. lra.
    - apply (@ex_RInt_continuous R_CompleteNormedModule). intros y _. assert (0 <= y ^ 2) by apply pow2_ge_0.
      apply continuous_times; [apply continuous_const |]. apply continuous_quotient.
      + apply (continuous_comp (fun y => x + y ^ 2) P1); [| apply HP1; lra].
        apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
      + apply (continuous_comp (fun y => x + gam * (x + y ^ 2)) sqrt); [| apply continuous_sqrt].
        apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
      + apply Rgt_not_eq, sqrt_lt_R0. nra. }
  rewrite <- E. apply (pressure_by_square P1 (fun s => gam * s)); [lra | | |].
  - intros s Hs. apply HP1. lra.
  - intros s Hs. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - intros s Hs. nra.
Qed.

Lemma ray_pressure_continuous x : 0 < x < a -> continuous ray_pressure x.
Proof.
  intros Hx. set (F := fun x z => V x * k x (V x * z + 0)).
  assert (VC : continuous V x).
  { unfold V. apply (continuous_comp (fun x => (a - x) / x) sqrt); [| apply continuous_sqrt].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. lra. }
  assert (N : locally x (fun y => 0 < y)) by (apply (locally_near x x); intros; lra).
  apply (continuous_ext_loc _ (fun x => RInt (F x) 0 1)).
  - apply filter_imp with (2 := N). intros y Hy. unfold ray_pressure, F.
    transitivity (RInt (k y) (V y * 0 + 0) (V y * 1 + 0)); [| f_equal; ring].
    apply (RInt_comp_lin (V := R_CompleteNormedModule) (k y) (V y) 0 0 1). apply k_integrable, Hy.
  - apply integral_continuous; [lra | |].
    + intros v _. apply continuous_2d.
      assert (C1 : continuous (fun z : R * R => V (fst z)) (x, v)).
      { apply (continuous_comp (fun z : R * R => fst z) V); [apply continuous_fst | exact VC]. }
      unfold F. apply continuous_times; [exact C1 |].
      apply (continuous_comp_2 (fun z : R * R => fst z) (fun z : R * R => V (fst z) * snd z + 0) k).
      * apply continuous_fst.
      * apply continuous_add; [| apply continuous_const]. apply continuous_times; [exact C1 | apply continuous_snd].
      * simpl. apply k_continuous. lra.
    + apply filter_imp with (2 := N). intros y Hy. unfold F.
      apply (ex_RInt_comp_lin (V := R_NormedModule) (k y) (V y) 0 0 1). apply k_integrable, Hy.
Qed.

(* An antiderivative. *)
Let f x v := 2 / PI * ((P (x * (1 + v ^ 2)) - P a) / ((1 + v ^ 2) * sqrt (w v))).
Definition ray_total (x : R) : R := RInt (f x) 0 (V x).
Let f_derive x v : 0 < x -> is_derive (fun x => f x v) x (k x v).
Proof.
  intros H. assert (H0 := HP _ (s_pos x v H)). unfold f, k.
  assert (0 <= v ^ 2) by apply pow2_ge_0. generalize (root_pos v). intros Hr.
  assert (E : 2 / PI * (P1 (x * (1 + v ^ 2)) / sqrt (w v)) = 2 / PI * ((1 + v ^ 2) * P1 (x * (1 + v ^ 2)) * / ((1 + v ^ 2) * sqrt (w v)))).
  { generalize PI_RGT_0. intros. field. repeat split; lra. }
  rewrite E.
  apply (is_derive_scal (fun x => (P (x * (1 + v ^ 2)) - P a) / ((1 + v ^ 2) * sqrt (w v)))).
  unfold Rdiv. apply (is_derive_ext (fun x => / ((1 + v ^ 2) * sqrt (w v)) * (P (x * (1 + v ^ 2)) - P a))); [intros z; match goal with |- @eq _ ?l ?r => change (@eq R l r) end; ring |].
  replace ((1 + v ^ 2) * P1 (x * (1 + v ^ 2)) * / ((1 + v ^ 2) * sqrt (w v)))
    with (/ ((1 + v ^ 2) * sqrt (w v)) * ((1 + v ^ 2) * P1 (x * (1 + v ^ 2)))) by ring.
  apply (is_derive_scal (fun x => P (x * (1 + v ^ 2)) - P a)).
  replace ((1 + v ^ 2) * P1 (x * (1 + v ^ 2))) with (minus (scal (1 + v ^ 2) (P1 (x * (1 + v ^ 2)))) 0)
    by (unfold minus, plus, opp, scal; simpl; unfold mult; simpl; ring).
  apply (is_derive_minus (V := R_NormedModule) (fun x => P (x * (1 + v ^ 2))) (fun _ => P a)).
  - apply (is_derive_comp P (fun x => x * (1 + v ^ 2))); [exact H0 |]. auto_derive; [trivial | ring].
  - apply (is_derive_const (V := R_NormedModule)).
Qed.
Let f_continuous x v : 0 < x -> continuous (f x) v.
Proof.
  intros H. unfold f. assert (0 <= v ^ 2) by apply pow2_ge_0. apply continuous_times; [apply continuous_const |].
  apply continuous_quotient.
  - apply continuous_sub; [| apply continuous_const].
    apply (continuous_comp (fun v => x * (1 + v ^ 2)) P).
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply HP, s_pos, H.
  - apply continuous_times.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
    + apply (continuous_comp w sqrt); [| apply continuous_sqrt]. unfold w.
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - apply Rgt_not_eq, Rmult_lt_0_compat; [lra | apply root_pos].
Qed.
Let f_integrable x c d : 0 < x -> ex_RInt (f x) c d.
Proof. intros H. apply (@ex_RInt_continuous R_CompleteNormedModule). intros v _. apply f_continuous, H. Qed.

Lemma ray_total_derive x : 0 < x < a -> is_derive ray_total x (ray_pressure x).
Proof.
  intros Hx. unfold ray_total.
  assert (N : locally x (fun y => 0 < y)) by (apply (locally_near x x); intros; lra).
  assert (C2 : forall y v, 0 < y -> continuity_2d_pt (fun u v : R => Derive (fun z : R => f z v) u) y v).
  { intros y v Hy. apply (continuity_2d_pt_ext_loc k); [| apply continuous_2d, k_continuous, Hy].
    exists (mkposreal y Hy). simpl. intros u z Hu _. symmetry. apply is_derive_unique, f_derive.
    apply Rabs_def2 in Hu. lra. }
  assert (DV : ex_derive V x).
  { unfold V. auto_derive. repeat split; [lra | apply Rdiv_lt_0_compat; lra]. }
  destruct DV as [dV DV].
  assert (D : is_derive (fun x => RInt (f x) 0 (V x)) x (RInt (fun v => Derive (fun u => f u v) x) 0 (V x) + f x (V x) * dV)).
  { apply (is_derive_RInt_param_bound_comp_aux3 f 0 V x dV).
    - apply filter_imp with (2 := N). intros y Hy. apply f_integrable, Hy.
    - exists (mkposreal 1 Rlt_0_1). apply filter_imp with (2 := N). intros y Hy. apply f_integrable, Hy.
    - exact DV.
    - exists (mkposreal 1 Rlt_0_1). apply filter_imp with (2 := N). intros y Hy v _. exists (k y v). apply f_derive, Hy.
    - intros v _. apply C2. lra.
    - exists (mkposreal x ltac:(lra)). simpl. intros u v Hu _. apply C2. apply Rabs_def2 in Hu. lra.
    - apply continuity_pt_filterlim. apply f_continuous. lra. }
  replace (ray_pressure x) with (RInt (fun v => Derive (fun u => f u v) x) 0 (V x) + f x (V x) * dV); [exact D |].
  unfold ray_pressure. replace (f x (V x)) with 0.
  - rewrite Rmult_0_l, Rplus_0_r. apply RInt_ext. intros v _. apply is_derive_unique, f_derive. lra.
  - unfold f. rewrite V_end by lra. rewrite Rminus_diag_eq by reflexivity. unfold Rdiv. ring.
Qed.

Let K_nonneg : 0 <= K.
Proof. generalize (HK a ltac:(lra)) (Rabs_pos (P a)). intros. nra. Qed.
Let within x v : 0 < x < a -> 0 <= v <= V x -> 0 < x * (1 + v ^ 2) <= a.
Proof.
  intros Hx Hv. split; [apply s_pos; lra |]. apply Rle_trans with (x * (1 + V x ^ 2)); [| rewrite V_end; lra].
  apply Rmult_le_compat_l; [lra |]. assert (v ^ 2 <= V x ^ 2) by (apply pow_incr; exact Hv). lra.
Qed.
Let root_ge_1 v : 1 <= sqrt (w v).
Proof. rewrite <- sqrt_1 at 1. apply sqrt_le_1_alt. generalize (w_pos v). lra. Qed.
Let c_bound (A q r : R) : 0 <= A -> 1 <= q -> 1 <= r -> 0 <= A / (q * r) <= A.
Proof.
  intros HA Hq Hr. assert (1 <= q * r) by nra. split; [apply Rdiv_le_0_compat; lra |].
  apply (Rmult_le_reg_r (q * r)); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra.
Qed.

Lemma total_at_edge : filterlim ray_total (at_left a) (locally 0).
Proof.
  assert (Hpi := PI_RGT_0). set (M := 2 / PI * (2 * (K * a))).
  assert (B : forall x, 0 < x < a -> Rabs (ray_total x) <= M * V x).
  { intros x Hx. unfold ray_total.
    replace (M * V x) with ((V x - 0) * M) by ring.
    apply abs_RInt_le_const; [apply V_nonneg | apply f_integrable; lra |]. intros v Hv.
    destruct (within x v Hx Hv) as [S0 S1]. assert (H1 := HK _ (conj S0 S1)). assert (H2 := HK a ltac:(lra)).
    assert (0 <= v ^ 2) by apply pow2_ge_0.
    assert (T := Rabs_triang (P (x * (1 + v ^ 2))) (- P a)). rewrite Rabs_Ropp in T. fold (P (x * (1 + v ^ 2)) - P a) in T.
    assert (T1 : Rabs (P (x * (1 + v ^ 2)) - P a) <= 2 * (K * a)) by nra.
    unfold f, M. rewrite Rabs_mult, (Rabs_pos_eq (2 / PI)) by (apply Rdiv_le_0_compat; lra).
    apply Rmult_le_compat_l; [apply Rdiv_le_0_compat; lra |].
    unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ _)).
    - destruct (c_bound (Rabs (P (x * (1 + v ^ 2)) - P a)) (1 + v ^ 2) (sqrt (w v)) (Rabs_pos _) ltac:(lra) (root_ge_1 v)) as [_ C].
      unfold Rdiv in C. lra.
    - apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; [lra | apply root_pos]. }
  assert (L : filterlim (fun x => M * V x) (at_left a) (locally 0)).
  { assert (C : continuous (fun x => M * V x) a).
    { apply continuous_times; [apply continuous_const |]. unfold V.
      apply (continuous_comp (fun x => (a - x) / x) sqrt); [| apply continuous_sqrt].
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. lra. }
    unfold continuous in C. replace (M * V a) with 0 in C.
    - intros Q HQ. apply filter_le_within. exact (C Q HQ).
    - unfold V. rewrite Rminus_diag_eq by reflexivity. unfold Rdiv. rewrite Rmult_0_l, sqrt_0. ring. }
  apply (squeezed _ ray_total (fun x => M * V x)); [apply within_filter, locally_filter | | exact L].
  exists (mkposreal a Ha). intros x Hb Hxa. unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb.
  apply Rabs_def2 in Hb. apply B. lra.
Qed.

Let angle_derive v : is_derive (fun v => atan (v / sqrt (w v))) v (/ ((1 + v ^ 2) * sqrt (w v))).
Proof.
  generalize (w_pos v) (root_pos v). intros W0 R0. unfold w in *. auto_derive.
  - repeat split; [lra | apply Rgt_not_eq; exact R0].
  - assert (E : sqrt (1 + gam * (1 + v * (v * 1))) ^ 2 = 1 + gam * (1 + v * (v * 1))) by (apply pow2_sqrt; simpl in W0; lra).
    change (v ^ 2) with (v * (v * 1)) in *. set (r := sqrt _) in *. clearbody r.
    assert (0 <= v ^ 2) by apply pow2_ge_0. simpl in H.
    field_simplify_eq; [| repeat split; try lra; nra].
    match goal with |- ?l = ?m => assert (Z : l - m = 0); [| lra] end. ring [E].
Qed.
Let angle_total V0 : is_RInt (fun v => / ((1 + v ^ 2) * sqrt (w v))) 0 V0 (atan (V0 / sqrt (w V0))).
Proof.
  replace (atan (V0 / sqrt (w V0))) with (minus (atan (V0 / sqrt (w V0))) (atan (0 / sqrt (w 0)))).
  - apply (is_RInt_derive (V := R_CompleteNormedModule) (fun v => atan (v / sqrt (w v)))); intros v _; [apply angle_derive |].
    assert (0 <= v ^ 2) by apply pow2_ge_0. assert (R0 := root_pos v).
    apply (continuous_comp (fun v => (1 + v ^ 2) * sqrt (w v)) Rinv).
    + apply continuous_times.
      * apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
      * apply (continuous_comp w sqrt); [| apply continuous_sqrt]. unfold w.
        apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
    + apply continuous_Rinv, Rgt_not_eq, Rmult_lt_0_compat; [lra | exact R0].
  - unfold Rdiv at 2. rewrite Rmult_0_l, atan_0. unfold minus, plus, opp; simpl. ring.
Qed.

Let rest x := ray_total x + 2 / PI * P a * atan (sqrt ((a - x) / (x + gam * a))).
Let rest_bound x : 0 < x < a -> Rabs (rest x) <= 2 / PI * K * sqrt (x * (a - x)).
Proof.
  intros Hx. assert (Hpi := PI_RGT_0).
  set (h := fun v => 2 / PI * P a * / ((1 + v ^ 2) * sqrt (w v))).
  assert (Ih : is_RInt h 0 (V x) (2 / PI * P a * atan (sqrt ((a - x) / (x + gam * a))))).
  { replace (sqrt ((a - x) / (x + gam * a))) with (V x / sqrt (w (V x))).
    - apply (is_RInt_scal (V := R_NormedModule) (fun v => / ((1 + v ^ 2) * sqrt (w v)))), angle_total.
    - unfold w. rewrite V_sq by lra. assert (0 < 1 + gam * (1 + (a - x) / x)).
      { replace (1 + (a - x) / x) with (a / x) by (field; lra). assert (0 < a / x) by (apply Rdiv_lt_0_compat; lra). nra. }
      unfold V. rewrite <- sqrt_div_alt by assumption. f_equal. field. assert (0 < gam * a) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (Ir : is_RInt (fun v => f x v + h v) 0 (V x) (rest x)).
  { apply (is_RInt_plus (V := R_NormedModule) (f x) h); [| exact Ih].
    apply (@RInt_correct R_CompleteNormedModule), f_integrable. lra. }
  rewrite <- (is_RInt_unique (V := R_CompleteNormedModule) _ _ _ _ Ir).
  replace (2 / PI * K * sqrt (x * (a - x))) with ((V x - 0) * (2 / PI * (K * x))).
  - apply abs_RInt_le_const; [apply V_nonneg | eexists; exact Ir |]. intros v Hv.
    assert (0 <= v ^ 2) by apply pow2_ge_0. assert (R0 := root_pos v).
    assert (S := within x v Hx Hv). assert (B := HK _ S).
    replace (f x v + h v) with (2 / PI * (P (x * (1 + v ^ 2)) / (1 + v ^ 2) / sqrt (w v))) by (unfold f, h; field; repeat split; lra).
    rewrite Rabs_mult, (Rabs_pos_eq (2 / PI)) by (apply Rdiv_le_0_compat; lra).
    apply Rmult_le_compat_l; [apply Rdiv_le_0_compat; lra |].
    unfold Rdiv. rewrite !Rabs_mult, !Rabs_inv, (Rabs_pos_eq (1 + v ^ 2)), (Rabs_pos_eq (sqrt _)) by lra.
    assert (H1 : Rabs (P (x * (1 + v ^ 2))) * / (1 + v ^ 2) <= K * x).
    { apply (Rmult_le_reg_r (1 + v ^ 2)); [lra |]. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    assert (H2 : / sqrt (w v) <= 1) by (rewrite <- Rinv_1; apply Rinv_le_contravar; [lra | apply root_ge_1]).
    assert (0 <= Rabs (P (x * (1 + v ^ 2))) * / (1 + v ^ 2)) by (apply Rmult_le_pos; [apply Rabs_pos | apply Rlt_le, Rinv_0_lt_compat; lra]).
    assert (0 < / sqrt (w v)) by (apply Rinv_0_lt_compat; lra). nra.
  - replace (x * (a - x)) with (x ^ 2 * ((a - x) / x)) by (field; lra).
    rewrite sqrt_mult_alt, (sqrt_pow2 x) by (try apply pow2_ge_0; lra). unfold V. ring.
Qed.
Lemma total_at_0 : filterlim ray_total (at_right 0) (locally (- (2 / PI * P a * atan (/ sqrt gam)))).
Proof.
  set (A := fun x => 2 / PI * P a * atan (sqrt ((a - x) / (x + gam * a)))).
  assert (Hga : 0 < gam * a) by (apply Rmult_lt_0_compat; lra).
  assert (LA : filterlim A (at_right 0) (locally (2 / PI * P a * atan (/ sqrt gam)))).
  { assert (C : continuous A 0).
    { unfold A. apply continuous_times; [apply continuous_const |].
      apply (continuous_comp (fun x => sqrt ((a - x) / (x + gam * a))) atan).
      - apply (continuous_comp (fun x => (a - x) / (x + gam * a)) sqrt); [| apply continuous_sqrt].
        apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. lra.
      - apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
    unfold continuous in C. replace (A 0) with (2 / PI * P a * atan (/ sqrt gam)) in C.
    - intros Q HQ. apply filter_le_within. exact (C Q HQ).
    - unfold A. f_equal. f_equal. replace ((a - 0) / (0 + gam * a)) with (1 / gam) by (field; lra).
      rewrite sqrt_div_alt, sqrt_1 by lra. unfold Rdiv. ring. }
  assert (LB : filterlim (fun x => 2 / PI * K * sqrt (x * (a - x))) (at_right 0) (locally 0)).
  { assert (C : continuous (fun x => 2 / PI * K * sqrt (x * (a - x))) 0).
    { apply continuous_times; [apply continuous_const |].
      apply (continuous_comp (fun x => x * (a - x)) sqrt); [| apply continuous_sqrt].
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
    unfold continuous in C. rewrite Rmult_0_l, sqrt_0, Rmult_0_r in C.
    intros Q HQ. apply filter_le_within. exact (C Q HQ). }
  assert (LR : filterlim rest (at_right 0) (locally 0)).
  { apply (squeezed _ rest (fun x => 2 / PI * K * sqrt (x * (a - x)))); [apply within_filter, locally_filter | | exact LB].
    exists (mkposreal a Ha). intros x Hb Hx. unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb.
    apply Rabs_def2 in Hb. apply rest_bound. lra. }
  apply (filterlim_ext (fun x => plus (rest x) (opp (A x)))).
  { intros x. unfold rest, A, plus, opp; simpl. ring. }
  replace (- (2 / PI * P a * atan (/ sqrt gam))) with (plus 0 (opp (2 / PI * P a * atan (/ sqrt gam)))) by (unfold plus, opp; simpl; ring).
  eapply filterlim_comp_2; [exact LR | | apply (filterlim_plus (V := R_NormedModule))].
  exact (filterlim_comp _ _ _ A (fun y => opp y) (at_right 0) (locally _) _ LA (filterlim_opp (V := R_NormedModule) _)).
Qed.

Theorem half_resultant : is_RInt_gen ray_pressure (at_right 0) (at_left a) (2 / PI * P a * atan (/ sqrt gam)).
Proof.
  assert (N : filter_prod (at_right 0) (at_left a) (fun z => 0 < fst z < a /\ 0 < snd z < a)).
  { apply (Filter_prod (at_right 0) (at_left a) _ (fun x => 0 < x < a) (fun x => 0 < x < a)).
    - exists (mkposreal a Ha). intros x Hb Hx. unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb.
      apply Rabs_def2 in Hb. lra.
    - exists (mkposreal a Ha). intros x Hb Hx. unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb.
      apply Rabs_def2 in Hb. lra.
    - intros x y Hx Hy. simpl. split; assumption. }
  assert (In : forall z : R * R, 0 < fst z < a /\ 0 < snd z < a -> forall x, Rmin (fst z) (snd z) <= x <= Rmax (fst z) (snd z) -> 0 < x < a).
  { intros z [H1 H2] x. unfold Rmin, Rmax. destruct (Rle_dec (fst z) (snd z)); lra. }
  apply (is_RInt_gen_ext (Derive ray_total)).
  { apply filter_imp with (2 := N). intros z Hz x Hx. apply is_derive_unique, ray_total_derive. apply (In z Hz). lra. }
  replace (2 / PI * P a * atan (/ sqrt gam)) with (0 - - (2 / PI * P a * atan (/ sqrt gam))) by ring.
  apply is_RInt_gen_Derive.
  - apply filter_imp with (2 := N). intros z Hz x Hx. eexists. apply ray_total_derive, (In z Hz x Hx).
  - apply filter_imp with (2 := N). intros z Hz x Hx. assert (H := In z Hz x Hx).
    apply (continuous_ext_loc _ ray_pressure); [| apply ray_pressure_continuous, H].
    apply (locally_near x (Rmin x (a - x))); [apply Rmin_pos; lra |]. intros r Hr.
    generalize (Rmin_l x (a - x)) (Rmin_r x (a - x)). intros. symmetry. apply is_derive_unique, ray_total_derive. lra.
  - exact total_at_0.
  - exact total_at_edge.
Qed.
End Half.
