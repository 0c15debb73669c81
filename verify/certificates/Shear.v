(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact.
Open Scope R_scope.

(* The shear traction of a contact [-b, a] that nowhere slips, under a shear force Q and a
   differential bulk tension sig0, both applied while the normal load is held. *)
Definition full_stick (Q sig0 a b x : R) : R :=
  Q / (PI * sqrt ((a - x) * (x + b))) + sig0 * (2 * x + b - a) / (8 * sqrt ((a - x) * (x + b))).

(* q(a - u) = K(u) / sqrt(u), K being differentiable at u = 0: k0, k1, k2 are the first three
   coefficients of its Taylor series, those of u^(-1/2), u^(1/2), u^(3/2). *)
Definition right_shear_series (q : R -> R) (a k0 k1 k2 : R) : Prop :=
  exists (K K1 : R -> R) (d : R), 0 < d /\
    (forall u, 0 < u < d -> q (a - u) = K u / sqrt u) /\
    (forall u, - d < u < d -> is_derive K u (K1 u)) /\
    K 0 = k0 /\ K1 0 = k1 /\ is_derive K1 0 (2 * k2).
(* The same of the distance from the left edge -b, u = b + x. *)
Definition left_shear_series (q : R -> R) (b k0 k1 k2 : R) : Prop :=
  right_shear_series (fun x => q (- x)) b k0 k1 k2.

Section Series.
Variables Q sig0 D : R.
Hypothesis HD : 0 < D.

Definition shear_0 := (Q / PI + sig0 * D / 8) / sqrt D.
Definition shear_1 := (Q / PI + sig0 * D / 8) / (2 * (D * sqrt D)) - sig0 / (4 * sqrt D).
Definition shear_2 := 3 * (Q / PI + sig0 * D / 8) / (8 * (D ^ 2 * sqrt D)) - sig0 / (8 * (D * sqrt D)).

Let N u := Q / PI + sig0 * (D - 2 * u) / 8.
Let K u := N u / sqrt (D - u).
Let K1 u := N u / (2 * ((D - u) * sqrt (D - u))) - sig0 / (4 * sqrt (D - u)).

Lemma shear_series (q : R -> R) (a : R) :
  (forall u, 0 < u < D -> q (a - u) = N u / sqrt (u * (D - u))) ->
  right_shear_series q a shear_0 shear_1 shear_2.
Proof.
  intros Hq. exists K, K1, D. assert (Hpi := PI_RGT_0).
  assert (Hr : forall u, u < D -> 0 < sqrt (D - u)) by (intros u Hu; apply sqrt_lt_R0; lra).
  assert (Hrr : forall u, u < D -> D - u = sqrt (D - u) * sqrt (D - u)) by (intros u Hu; symmetry; apply sqrt_sqrt; lra).
  split; [exact HD | split; [| split; [| split; [| split]]]].
  - intros u Hu. rewrite Hq by exact Hu. rewrite sqrt_mult by lra. unfold K.
    assert (0 < sqrt u) by (apply sqrt_lt_R0; lra). assert (Hru := Hr u ltac:(lra)). field. lra.
  - intros u Hu. assert (Hru := Hr u ltac:(lra)). assert (E := Hrr u ltac:(lra)).
    unfold K, K1, N. auto_derive; change (D + - u) with (D - u).
    + repeat split; lra.
    + set (r := sqrt (D - u)) in *. clearbody r. replace u with (D - r * r) by lra. field. lra.
  - unfold K, N, shear_0. rewrite Rmult_0_r, !Rminus_0_r. reflexivity.
  - unfold K1, N, shear_1. rewrite Rmult_0_r, !Rminus_0_r. reflexivity.
  - assert (Hru := Hr 0 HD). assert (E := Hrr 0 HD). rewrite Rminus_0_r in *.
    unfold K1, N, shear_2. auto_derive; change (D + - 0) with (D - 0); rewrite Rminus_0_r.
    + assert (0 < D * sqrt D) by (apply Rmult_lt_0_compat; lra). repeat split; lra.
    + set (r := sqrt D) in *. clearbody r. rewrite E. field. lra.
Qed.
End Series.

Theorem right_shear Q sig0 a b : 0 < a + b -> right_shear_series (full_stick Q sig0 a b) a
  (shear_0 Q sig0 (a + b)) (shear_1 Q sig0 (a + b)) (shear_2 Q sig0 (a + b)).
Proof.
  intros HD. apply shear_series; [exact HD |]. intros u Hu. unfold full_stick.
  replace (a - (a - u)) with u by ring. replace (a - u + b) with (a + b - u) by ring.
  assert (0 < sqrt (u * (a + b - u))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
  assert (Hpi := PI_RGT_0). field. lra.
Qed.
Theorem left_shear Q sig0 a b : 0 < a + b -> left_shear_series (full_stick Q sig0 a b) b
  (shear_0 Q (- sig0) (a + b)) (shear_1 Q (- sig0) (a + b)) (shear_2 Q (- sig0) (a + b)).
Proof.
  intros HD. apply shear_series; [exact HD |]. intros u Hu. unfold full_stick.
  replace ((a - - (b - u)) * (- (b - u) + b)) with (u * (a + b - u)) by ring.
  assert (0 < sqrt (u * (a + b - u))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
  assert (Hpi := PI_RGT_0). field. lra.
Qed.

(* The ratio of the loads at which a coefficient vanishes. *)
Section Ratio.
Variables Q sig0 D : R.
Hypothesis HD : 0 < D.
Let Hpi : PI <> 0 := PI_neq0.
Let Hr : 0 < sqrt D := sqrt_lt_R0 D HD.
Lemma shear_0_zero : shear_0 Q sig0 D = 0 -> Q = - PI * D / 8 * sig0.
Proof.
  intros H. apply Rminus_diag_uniq. replace (Q - _) with (shear_0 Q sig0 D * (PI * sqrt D)); [rewrite H; ring |].
  unfold shear_0. field. lra.
Qed.
Lemma shear_1_zero : shear_1 Q sig0 D = 0 -> Q = 3 * PI * D / 8 * sig0.
Proof.
  intros H. apply Rminus_diag_uniq. replace (Q - _) with (shear_1 Q sig0 D * (2 * PI * D * sqrt D)); [rewrite H; ring |].
  unfold shear_1. field. lra.
Qed.
Lemma shear_2_zero : shear_2 Q sig0 D = 0 -> Q = 5 * PI * D / 24 * sig0.
Proof.
  intros H. apply Rminus_diag_uniq. replace (Q - _) with (shear_2 Q sig0 D * (8 * PI * D ^ 2 * sqrt D / 3)); [rewrite H; ring |].
  unfold shear_2. field. lra.
Qed.
End Ratio.

(* What a shear force and a tension make of a coefficient, where another one vanishes by H: the sign of their product. *)
Ltac parts_by_sign H a b sig0 :=
  let Hpi := fresh "Hpi" in let Hr := fresh "Hr" in let E := fresh "E" in let r := fresh "r" in let Hs := fresh "Hs" in
  assert (Hpi := PI_RGT_0);
  first [apply shear_0_zero in H | apply shear_1_zero in H | apply shear_2_zero in H]; [| lra];
  assert (Hs : 0 < sig0 ^ 2) by (assert (sig0 <> 0) by (intros ->; lra); nra);
  rewrite H; unfold shear_0, shear_1, shear_2; cbv beta;
  assert (Hr : 0 < sqrt (a + b)) by (apply sqrt_lt_R0; lra);
  assert (E : a + b = sqrt (a + b) * sqrt (a + b)) by (symmetry; apply sqrt_sqrt; lra);
  set (r := sqrt (a + b)) in *; clearbody r; rewrite ?E;
  try (match goal with |- _ < 0 => apply Ropp_lt_cancel; rewrite Ropp_0 end);
  field_simplify; [| repeat split; lra ..];
  repeat first [assumption | lra | apply Rdiv_lt_0_compat | apply Rmult_lt_0_compat | apply pow_lt].

(* The first term compared with the traction, at the distance u from an edge. *)
Lemma force_alone Q D u : 0 < u < D -> Q <> 0 ->
  Rabs (shear_0 Q 0 D) / sqrt u < Rabs (Q / (PI * sqrt (u * (D - u)))).
Proof.
  intros Hu HQ. assert (Hpi := PI_RGT_0). unfold shear_0.
  assert (H0 : 0 < sqrt u) by (apply sqrt_lt_R0; lra).
  assert (H1 : 0 < sqrt (D - u)) by (apply sqrt_lt_R0; lra).
  assert (H2 : sqrt (D - u) < sqrt D) by (apply sqrt_lt_1_alt; lra).
  rewrite sqrt_mult by lra.
  replace ((Q / PI + 0 * D / 8) / sqrt D) with (Q * (/ PI * / sqrt D)) by (field; lra).
  replace (Q / (PI * (sqrt u * sqrt (D - u)))) with (Q * (/ PI * (/ sqrt u * / sqrt (D - u)))) by (field; lra).
  assert (I1 : 0 < / PI) by (apply Rinv_0_lt_compat; lra).
  assert (I2 : 0 < / sqrt D) by (apply Rinv_0_lt_compat; lra).
  assert (I3 : 0 < / sqrt u) by (apply Rinv_0_lt_compat; lra).
  assert (I4 : / sqrt D < / sqrt (D - u)) by (apply Rinv_lt_contravar; [apply Rmult_lt_0_compat |]; lra).
  rewrite !Rabs_mult, !(Rabs_pos_eq (/ _)) by lra. unfold Rdiv.
  assert (HQ0 := Rabs_pos_lt Q HQ).
  replace (Rabs Q * (/ PI * / sqrt D) * / sqrt u) with (Rabs Q * / PI * / sqrt u * / sqrt D) by ring.
  replace (Rabs Q * (/ PI * (/ sqrt u * / sqrt (D - u)))) with (Rabs Q * / PI * / sqrt u * / sqrt (D - u)) by ring.
  apply Rmult_lt_compat_l; [repeat apply Rmult_lt_0_compat |]; assumption.
Qed.
Lemma tension_alone sig0 D u : 0 < u < D / 2 -> sig0 <> 0 ->
  Rabs (sig0 * (D - 2 * u) / (8 * sqrt (u * (D - u)))) < Rabs (shear_0 0 sig0 D) / sqrt u.
Proof.
  intros Hu HQ. assert (Hpi := PI_RGT_0). unfold shear_0.
  assert (H0 : 0 < sqrt u) by (apply sqrt_lt_R0; lra).
  assert (H1 : 0 < sqrt (D - u)) by (apply sqrt_lt_R0; lra).
  assert (H2 : 0 < sqrt D) by (apply sqrt_lt_R0; lra).
  assert (H3 : D - 2 * u < sqrt D * sqrt (D - u)).
  { rewrite <- sqrt_mult by lra. rewrite <- (sqrt_pow2 (D - 2 * u)) by lra. apply sqrt_lt_1_alt. split; [apply pow2_ge_0 | nra]. }
  assert (E : sqrt D * sqrt D = D) by (apply sqrt_sqrt; lra).
  rewrite sqrt_mult by lra.
  replace ((0 / PI + sig0 * D / 8) / sqrt D) with (sig0 * (sqrt D / 8)) by (rewrite <- E at 2; field; lra).
  replace (sig0 * (D - 2 * u) / (8 * (sqrt u * sqrt (D - u)))) with (sig0 * ((D - 2 * u) / sqrt (D - u) * / sqrt u / 8)) by (field; lra).
  assert (HQ0 := Rabs_pos_lt sig0 HQ).
  assert (I3 : 0 < / sqrt u) by (apply Rinv_0_lt_compat; lra).
  assert (I4 : 0 < (D - 2 * u) / sqrt (D - u) < sqrt D).
  { split; [apply Rdiv_lt_0_compat; lra |]. apply (Rmult_lt_reg_r (sqrt (D - u))); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  set (k := (D - 2 * u) / sqrt (D - u)) in *. clearbody k.
  rewrite !Rabs_mult, (Rabs_pos_eq (sqrt D / 8)), (Rabs_pos_eq (k * / sqrt u / 8)) by (try nra; apply Rlt_le; repeat apply Rmult_lt_0_compat; lra).
  replace (Rabs sig0 * (sqrt D / 8) / sqrt u) with (Rabs sig0 * / sqrt u / 8 * sqrt D) by (field; lra).
  replace (Rabs sig0 * (k * / sqrt u / 8)) with (Rabs sig0 * / sqrt u / 8 * k) by (field; lra).
  apply Rmult_lt_compat_l; [repeat apply Rmult_lt_0_compat |]; lra.
Qed.

(* The integral of f over (l, r), f being unbounded at both ends: the limit of the integrals over
   [l + e, r - e], which exist. *)
Definition is_integral_between (f : R -> R) (l r v : R) : Prop :=
  (forall e, 0 < e < (r - l) / 2 -> ex_RInt f (l + e) (r - e)) /\
  filterlim (fun e => RInt f (l + e) (r - e)) (at_right 0) (locally v).

Section Force.
Variables Q sig0 a b : R.
Hypothesis HD : 0 < a + b.
Let F x := - (2 * Q / PI * atan (sqrt ((a - x) / (x + b)))) - sig0 / 4 * sqrt ((a - x) * (x + b)).
Let f s := Q / (PI * sqrt ((a - s) * (s + b))) + sig0 * (2 * s + b - a) / (8 * sqrt ((a - s) * (s + b))).

Lemma force_derive x : - b < x < a -> is_derive F x (f x) /\ continuous f x.
Proof.
  intros Hx. assert (Hpi := PI_RGT_0). assert (0 < (a - x) * (x + b)) by (apply Rmult_lt_0_compat; lra).
  assert (0 < (a - x) / (x + b)) by (apply Rdiv_lt_0_compat; lra).
  assert (Hs := sqrt_lt_R0 _ H). split.
  - unfold F, f. auto_derive; change (a + - x) with (a - x); change (2 * x + b + - a) with (2 * x + b - a).
    + repeat split; try lra; exact H0.
    + replace ((a - x) * / (x + b)) with ((a - x) / (x + b)) by reflexivity.
      assert (E : sqrt ((a - x) / (x + b)) = sqrt ((a - x) * (x + b)) / (x + b)).
      { replace ((a - x) / (x + b)) with ((a - x) * (x + b) / (x + b) ^ 2) by (field; lra).
        rewrite sqrt_div_alt by (apply pow_lt; lra). rewrite sqrt_pow2 by lra. reflexivity. }
      rewrite E. assert (E2 : sqrt ((a - x) * (x + b)) * sqrt ((a - x) * (x + b)) = (a - x) * (x + b)) by (apply sqrt_sqrt; lra).
      set (r := sqrt ((a - x) * (x + b))) in *. clearbody r.
      replace (1 + r / (x + b) * (r / (x + b) * 1)) with ((a + b) / (x + b)).
      * field. repeat split; lra.
      * replace (r / (x + b) * (r / (x + b) * 1)) with (r * r / (x + b) ^ 2) by (field; lra). rewrite E2. field. lra.
  - apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold f. auto_derive.
    change (a + - x) with (a - x). repeat split; try apply Rmult_integral_contrapositive_currified; lra.
Qed.

Lemma force_between e : 0 < e < (a + b) / 2 -> is_RInt f (- b + e) (a - e) (Q - 4 * Q / PI * atan (sqrt (e / (a + b - e)))).
Proof.
  intros He. assert (Hpi := PI_RGT_0). assert (Hk : 0 < e / (a + b - e)) by (apply Rdiv_lt_0_compat; lra).
  assert (Hr := sqrt_lt_R0 _ Hk).
  replace (Q - 4 * Q / PI * atan (sqrt (e / (a + b - e)))) with (F (a - e) - F (- b + e)).
  - apply (is_RInt_antiderivative f f F); [lra | reflexivity | |]; intros x Hx; apply force_derive; lra.
  - unfold F. replace (a - (a - e)) with e by ring. replace (a - e + b) with (a + b - e) by ring.
    replace (a - (- b + e)) with (a + b - e) by ring. replace (- b + e + b) with e by ring.
    rewrite (Rmult_comm (a + b - e) e).
    replace (sqrt ((a + b - e) / e)) with (/ sqrt (e / (a + b - e))).
    + rewrite atan_inv by exact Hr. field. lra.
    + rewrite <- sqrt_inv. f_equal. field. lra.
Qed.

Theorem force_of_traction : is_integral_between f (- b) a Q.
Proof.
  assert (Hpi := PI_RGT_0). split.
  - intros e He. exists (Q - 4 * Q / PI * atan (sqrt (e / (a + b - e)))). apply force_between. lra.
  - apply (filterlim_ext_loc (fun e => Q - 4 * Q / PI * atan (sqrt (e / (a + b - e))))).
    + exists (mkposreal ((a + b) / 2) ltac:(lra)). intros e Hb He. symmetry. apply is_RInt_unique, force_between.
      unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb.
      apply Rabs_def2 in Hb. lra.
    + assert (C : continuous (fun e => Q - 4 * Q / PI * atan (sqrt (e / (a + b - e)))) 0).
      { apply (continuous_minus (fun _ => Q)); [apply continuous_const |].
        apply (continuous_mult (fun _ => 4 * Q / PI)); [apply continuous_const |].
        apply (continuous_comp (fun e => sqrt (e / (a + b - e))) atan).
        - apply (continuous_comp (fun e => e / (a + b - e)) sqrt); [| apply continuous_sqrt].
          apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. lra.
        - apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
      assert (E : Q - 4 * Q / PI * atan (sqrt (0 / (a + b - 0))) = Q) by (unfold Rdiv; rewrite Rmult_0_l, sqrt_0, atan_0; ring).
      unfold continuous in C. rewrite E in C. intros P HP. apply filter_le_within. exact (C P HP).
Qed.
End Force.

Lemma tension_signed sig0 D u : 0 < u < D -> sig0 <> 0 ->
  sign (shear_0 0 sig0 D) * (sig0 * (D - 2 * u) / (8 * sqrt (u * (D - u)))) < Rabs (shear_0 0 sig0 D) / sqrt u.
Proof.
  intros Hu Hs. assert (Hpi := PI_RGT_0).
  assert (H0 : 0 < sqrt u) by (apply sqrt_lt_R0; lra).
  assert (H2 : 0 < sqrt D) by (apply sqrt_lt_R0; lra).
  assert (Hp : 0 < u * (D - u)) by (apply Rmult_lt_0_compat; lra).
  assert (H3 := sqrt_lt_R0 _ Hp).
  assert (Hk : shear_0 0 sig0 D = sig0 * (sqrt D / 8)).
  { unfold shear_0. assert (E : sqrt D * sqrt D = D) by (apply sqrt_sqrt; lra). rewrite <- E at 1. field. lra. }
  assert (HR : 0 < Rabs (shear_0 0 sig0 D)).
  { apply Rabs_pos_lt. rewrite Hk. apply Rmult_integral_contrapositive_currified; lra. }
  destruct (Rlt_le_dec u (D / 2)) as [H | H].
  - apply Rle_lt_trans with (Rabs (sig0 * (D - 2 * u) / (8 * sqrt (u * (D - u))))); [| apply tension_alone; lra].
    destruct (Rtotal_order (shear_0 0 sig0 D) 0) as [Hn | [Hn | Hn]].
    + rewrite sign_eq_m1 by exact Hn. rewrite <- Rabs_Ropp. generalize (Rle_abs (- (sig0 * (D - 2 * u) / (8 * sqrt (u * (D - u)))))). lra.
    + rewrite Hn, sign_0. generalize (Rabs_pos (sig0 * (D - 2 * u) / (8 * sqrt (u * (D - u))))). lra.
    + rewrite sign_eq_1 by exact Hn. generalize (Rle_abs (sig0 * (D - 2 * u) / (8 * sqrt (u * (D - u))))). lra.
  - apply Rle_lt_trans with 0; [| apply Rdiv_lt_0_compat; assumption].
    assert (E : sig0 * (D - 2 * u) / (8 * sqrt (u * (D - u))) = - (shear_0 0 sig0 D) * ((2 * u - D) / (sqrt D * sqrt (u * (D - u))))).
    { rewrite Hk. field. lra. }
    rewrite E. assert (Hc : 0 <= (2 * u - D) / (sqrt D * sqrt (u * (D - u)))).
    { apply Rmult_le_pos; [lra |]. apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; lra. }
    set (k := (2 * u - D) / (sqrt D * sqrt (u * (D - u)))) in *. clearbody k.
    destruct (Rtotal_order (shear_0 0 sig0 D) 0) as [Hn | [Hn | Hn]].
    + rewrite sign_eq_m1 by exact Hn. nra.
    + rewrite Hn, sign_0. lra.
    + rewrite sign_eq_1 by exact Hn. nra.
Qed.

(* The traction of one load at the distance u from an edge, in the form of these lemmas. *)
Lemma force_at Q a b u : full_stick Q 0 a b (a - u) = Q / (PI * sqrt (u * ((a + b) - u))).
Proof.
  unfold full_stick. replace ((a - (a - u)) * (a - u + b)) with (u * (a + b - u)) by ring.
  unfold Rdiv. rewrite !Rmult_0_l. ring.
Qed.
Lemma force_at_left Q a b u : full_stick Q 0 a b (- b + u) = Q / (PI * sqrt (u * ((a + b) - u))).
Proof.
  unfold full_stick. replace ((a - (- b + u)) * (- b + u + b)) with (u * (a + b - u)) by ring.
  unfold Rdiv. rewrite !Rmult_0_l. ring.
Qed.
Lemma tension_at sig0 a b u : full_stick 0 sig0 a b (a - u) = sig0 * ((a + b) - 2 * u) / (8 * sqrt (u * ((a + b) - u))).
Proof.
  unfold full_stick. replace ((a - (a - u)) * (a - u + b)) with (u * (a + b - u)) by ring.
  replace (2 * (a - u) + b - a) with (a + b - 2 * u) by ring. unfold Rdiv. rewrite !Rmult_0_l. ring.
Qed.
Lemma tension_at_left sig0 a b u : full_stick 0 sig0 a b (- b + u) = - sig0 * ((a + b) - 2 * u) / (8 * sqrt (u * ((a + b) - u))).
Proof.
  unfold full_stick. replace ((a - (- b + u)) * (- b + u + b)) with (u * (a + b - u)) by ring.
  replace (2 * (- b + u) + b - a) with (- (a + b - 2 * u)) by ring. unfold Rdiv. rewrite !Rmult_0_l. ring.
Qed.
Ltac traction_at_edge := first [rewrite force_at | rewrite force_at_left | rewrite tension_at | rewrite tension_at_left].
(* The sides of a relation do not depend on the sign of a zero. *)
Lemma no_tension Q D : shear_0 Q (- 0) D = shear_0 Q 0 D.
Proof. rewrite Ropp_0. reflexivity. Qed.
