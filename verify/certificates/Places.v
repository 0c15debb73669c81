(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients.
Open Scope R_scope.

(* Integrals over the angle of a place are integrals over the place: the load as it is printed. *)

Lemma asin_at_1 : filterlim asin (at_left 1) (locally (PI / 2)).
Proof.
  assert (Hpi := PI_RGT_0). intros P [e He]. set (d := Rmin e 1 / 2).
  assert (Hd : 0 < d <= 1 / 2 /\ d < e).
  { unfold d. generalize (Rmin_l e 1) (Rmin_r e 1) (Rmin_pos e 1 (cond_pos e) Rlt_0_1). lra. }
  assert (Hp2 : 1 < PI / 2) by (generalize PI2_1; lra).
  assert (Hs : sin (PI / 2 - d) < 1) by (rewrite <- sin_PI2; apply sin_increasing_1; lra).
  assert (Hs0 : 0 < sin (PI / 2 - d)) by (apply sin_gt_0; lra).
  exists (mkposreal (1 - sin (PI / 2 - d)) ltac:(lra)). intros y Hy Hy1.
  unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy. apply Rabs_def2 in Hy.
  apply He. unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl.
  assert (B := asin_bound_lt y ltac:(lra)).
  assert (L : PI / 2 - d < asin y).
  { destruct (Rlt_le_dec (PI / 2 - d) (asin y)) as [L | L]; [exact L | exfalso].
    assert (S : sin (asin y) <= sin (PI / 2 - d)) by (apply sin_incr_1; lra). rewrite sin_asin in S by lra. lra. }
  apply Rabs_def1; lra.
Qed.
Lemma asin_at_minus_1 : filterlim asin (at_right (-1)) (locally (- (PI / 2))).
Proof.
  apply (filterlim_ext (fun y => opp (asin (- y)))); [intros y; rewrite asin_opp; unfold opp; simpl; ring |].
  refine (filterlim_comp _ _ _ (fun y => asin (- y)) (fun y => opp y) _ (locally (PI / 2)) _ _ (filterlim_opp (V := R_NormedModule) _)).
  refine (filterlim_comp _ _ _ (fun y => - y) asin _ (at_left 1) _ _ asin_at_1).
  intros P [e He]. exists e. intros y Hy Hl. apply He; [| lra].
  unfold ball in *; simpl in *. unfold AbsRing_ball, abs, minus, plus, opp in *; simpl in *.
  replace (- y + - (1)) with (- (y + - -1)) by ring. rewrite Rabs_Ropp. exact Hy.
Qed.

Section Place.
Variables (f : R -> R) (a b : R).
Hypothesis Hab : 0 < a + b.
Hypothesis Hf : forall s, continuous f s.
Let share s := (2 * s - (a - b)) / (a + b).
Let F theta := f (place a b theta).
Let Phi s := RInt F 0 (asin (share s)).

Let F_continuous theta : continuous F theta.
Proof.
  apply (continuous_comp (place a b) f); [| apply Hf]. unfold place.
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Let F_integrable c d : ex_RInt F c d.
Proof. apply (@ex_RInt_continuous R_CompleteNormedModule). intros z _. apply F_continuous. Qed.
Let Primitive theta : is_derive (fun theta => RInt F 0 theta) theta (F theta).
Proof.
  apply (is_derive_RInt F (fun theta => RInt F 0 theta) 0 theta); [| apply F_continuous].
  apply filter_forall. intros z. apply (@RInt_correct R_CompleteNormedModule), F_integrable.
Qed.
Let share_inside s : - b < s < a -> -1 < share s < 1.
Proof.
  intros Hs. unfold share. split; apply (Rmult_lt_reg_r (a + b)); try lra; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.
Let Phi_derive s : - b < s < a -> is_derive Phi s (f s / sqrt ((a - s) * (s + b))).
Proof.
  intros Hs. assert (Hi := share_inside s Hs).
  assert (Q : 0 < (a - s) * (s + b)) by (apply Rmult_lt_0_compat; lra). assert (Hr := sqrt_lt_R0 _ Q).
  assert (E : F (asin (share s)) = f s).
  { unfold F, place. rewrite sin_asin by lra. f_equal. unfold share. field. lra. }
  replace (f s / sqrt ((a - s) * (s + b))) with (scal (/ sqrt ((a - s) * (s + b))) (F (asin (share s))))
    by (rewrite E; unfold scal; simpl; unfold mult; simpl; field; lra).
  apply (is_derive_comp (fun theta => RInt F 0 theta) (fun s => asin (share s))); [apply Primitive |].
  replace (/ sqrt ((a - s) * (s + b))) with (scal (2 / (a + b)) (/ sqrt (1 - (share s)²))).
  - apply (is_derive_comp asin share).
    + apply is_derive_Reals. replace (/ sqrt (1 - (share s)²)) with (1 / sqrt (1 - (share s)²)) by (unfold Rdiv; ring).
      rewrite <- (derive_pt_asin (share s) Hi). exact (proj2_sig (derivable_pt_asin (share s) Hi)).
    + unfold share. auto_derive; [trivial | field; lra].
  - replace (1 - (share s)²) with ((2 / (a + b)) ^ 2 * ((a - s) * (s + b))) by (unfold share, Rsqr; field; lra).
    assert (0 < 2 / (a + b)) by (apply Rdiv_lt_0_compat; lra).
    rewrite sqrt_mult_alt, sqrt_pow2 by (try apply pow2_ge_0; lra). unfold scal; simpl; unfold mult; simpl. field. lra.
Qed.

Theorem integral_over_places V : is_RInt F (- (PI / 2)) (PI / 2) V ->
  is_RInt_gen (fun s => f s / sqrt ((a - s) * (s + b))) (at_right (- b)) (at_left a) V.
Proof.
  intros HV.
  assert (Ends : V = RInt F 0 (PI / 2) - RInt F 0 (- (PI / 2))).
  { assert (C := RInt_Chasles F (- (PI / 2)) 0 (PI / 2) (F_integrable _ _) (F_integrable _ _)).
    rewrite (is_RInt_unique (V := R_CompleteNormedModule) _ _ _ _ HV) in C. rewrite <- C. rewrite <- (opp_RInt_swap F) by apply F_integrable.
    unfold plus, opp; simpl. ring. }
  assert (Sub : forall x, continuous share x).
  { intros x. unfold share. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
  assert (N : filter_prod (at_right (- b)) (at_left a) (fun z => - b < fst z < a /\ - b < snd z < a)).
  { apply (Filter_prod _ _ _ (fun x => - b < x < a) (fun x => - b < x < a)).
    - exists (mkposreal (a + b) Hab). intros x Hx Hl. unfold ball in Hx; simpl in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx; simpl in Hx.
      apply Rabs_def2 in Hx. lra.
    - exists (mkposreal (a + b) Hab). intros x Hx Hl. unfold ball in Hx; simpl in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx; simpl in Hx.
      apply Rabs_def2 in Hx. lra.
    - intros x y Hx Hy. simpl. split; assumption. }
  assert (In : forall z : R * R, - b < fst z < a /\ - b < snd z < a -> forall x, Rmin (fst z) (snd z) <= x <= Rmax (fst z) (snd z) -> - b < x < a).
  { intros z [H1 H2] x. unfold Rmin, Rmax. destruct (Rle_dec (fst z) (snd z)); lra. }
  apply (is_RInt_gen_ext (Derive Phi)).
  { apply filter_imp with (2 := N). intros z Hz x Hx. apply is_derive_unique, Phi_derive. apply (In z Hz). lra. }
  rewrite Ends. apply is_RInt_gen_Derive.
  - apply filter_imp with (2 := N). intros z Hz x Hx. eexists. apply Phi_derive, (In z Hz x Hx).
  - apply filter_imp with (2 := N). intros z Hz x Hx. assert (H := In z Hz x Hx).
    apply (continuous_ext_loc _ (fun s => f s / sqrt ((a - s) * (s + b)))).
    + apply (locally_near x (Rmin (x + b) (a - x))); [apply Rmin_pos; lra |]. intros r Hr.
      generalize (Rmin_l (x + b) (a - x)) (Rmin_r (x + b) (a - x)). intros. symmetry. apply is_derive_unique, Phi_derive. lra.
    + apply continuous_quotient; [apply Hf | | apply Rgt_not_eq, sqrt_lt_R0, Rmult_lt_0_compat; lra].
      apply (continuous_comp (fun s => (a - s) * (s + b)) sqrt); [| apply continuous_sqrt].
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - assert (C : continuous (fun theta => RInt F 0 theta) (- (PI / 2))).
    { apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply Primitive. }
    refine (filterlim_comp _ _ _ (fun s => asin (share s)) (fun theta => RInt F 0 theta) _ (locally (- (PI / 2))) _ _ C).
    refine (filterlim_comp _ _ _ share asin _ (at_right (-1)) _ _ asin_at_minus_1).
    intros Q [e He]. destruct (Sub (- b) (ball (share (- b)) e)) as [d Hd]; [apply locally_ball |].
    exists d. intros s Hs Hl. replace (-1) with (share (- b)) in He by (unfold share; field; lra). apply He; [apply Hd, Hs |].
    replace (share (- b)) with (-1) by (unfold share; field; lra). unfold share.
    apply (Rmult_lt_reg_r (a + b)); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
  - assert (C : continuous (fun theta => RInt F 0 theta) (PI / 2)).
    { apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply Primitive. }
    refine (filterlim_comp _ _ _ (fun s => asin (share s)) (fun theta => RInt F 0 theta) _ (locally (PI / 2)) _ _ C).
    refine (filterlim_comp _ _ _ share asin _ (at_left 1) _ _ asin_at_1).
    intros Q [e He]. destruct (Sub a (ball (share a) e)) as [d Hd]; [apply locally_ball |].
    exists d. intros s Hs Hl. replace 1 with (share a) in He by (unfold share; field; lra). apply He; [apply Hd, Hs |].
    replace (share a) with 1 by (unfold share; field; lra). unfold share.
    apply (Rmult_lt_reg_r (a + b)); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
End Place.
