(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients.
Open Scope R_scope.

(* p(a - u) = sqrt(u) K(u), K being differentiable at u = 0: k0, k1, k2 are the first three
   coefficients of its Taylor series, those of u^(1/2), u^(3/2), u^(5/2). *)
Definition right_edge_series (Es : R) (g1 : R -> R) (a k0 k1 k2 : R) : Prop :=
  exists (K K1 : R -> R) (d : R), 0 < d /\
    (forall u, 0 < u < d -> is_pressure Es g1 a (a - u) (sqrt u * K u)) /\
    (forall u, - d < u < d -> is_derive K u (K1 u)) /\
    K 0 = k0 /\ K1 0 = k1 /\ is_derive K1 0 (2 * k2).

(* The same with the derivatives of P' and b, near the right edge a. *)
Definition is_smooth_contact (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 : R -> R) : Prop :=
  exists eta, 0 < eta /\ forall s, a - eta < s < a + eta ->
    is_contact_at Es g1 P P1 b s /\
    is_derive P1 s (P2 s) /\ is_derive P2 s (P3 s) /\ continuous P3 s /\
    is_derive b s (b1 s) /\ is_derive b1 s (b2 s) /\ continuous b2 s /\ 2 * eta < a + b s.

Theorem right_edge (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 : R -> R) :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  right_edge_series Es g1 a (c0 P1 b a) (c1 P1 P2 b b1 a) (c2 P1 P2 P3 b b1 b2 a).
Proof.
  intros [eta [Heta H]].
  assert (HP1 : forall s, a - eta < s < a + eta -> is_derive P1 s (P2 s)) by (intros; apply H; assumption).
  assert (HP2 : forall s, a - eta < s < a + eta -> is_derive P2 s (P3 s)) by (intros; apply H; assumption).
  assert (HP3 : forall s, a - eta < s < a + eta -> continuous P3 s) by (intros; apply H; assumption).
  assert (Hb : forall s, a - eta < s < a + eta -> is_derive b s (b1 s)) by (intros; apply H; assumption).
  assert (Hb1 : forall s, a - eta < s < a + eta -> is_derive b1 s (b2 s)) by (intros; apply H; assumption).
  assert (Hb2 : forall s, a - eta < s < a + eta -> continuous b2 s) by (intros; apply H; assumption).
  assert (Hw : forall u s, - eta < u < eta -> a - eta < s < a + eta -> 0 < a - u + b s).
  { intros u s Hu Hs. destruct (H s Hs) as (_ & _ & _ & _ & _ & _ & _ & Hx). lra. }
  exists (edge_series P1 b a), (edge_series_1 P1 P2 b b1 a), (eta / 4). split; [lra |]. split; [| split; [| split; [| split]]].
  - intros u Hu. exists P, P1, b. split.
    + intros s Hs. apply (H s). lra.
    + rewrite <- (near_edge P1 P2 b b1 a eta Heta HP1 Hb Hw u Hu).
      refine (pressure_by_square P1 b (a - u) a _ _ _ _).
      * lra.
      * intros s Hs. apply (@ex_derive_continuous R_AbsRing R_NormedModule). exists (P2 s). apply HP1; lra.
      * intros s Hs. apply (@ex_derive_continuous R_AbsRing R_NormedModule). exists (b1 s). apply Hb; lra.
      * intros s Hs. apply Hw; lra.
  - apply (edge_series_derive P1 P2 P3 b b1 b2 a eta); assumption.
  - apply (at_edge_0 P1 b a eta); assumption.
  - apply (at_edge_1 P1 P2 b b1 a eta); assumption.
  - rewrite <- (at_edge_2 P1 P2 P3 b b1 b2 a eta) by assumption.
    apply (edge_series_1_derive P1 P2 P3 b b1 b2 a eta); try assumption. lra.
Qed.

(* The left edge is the right edge of the mirrored punch. *)
Definition mirrored (g1 : R -> R) (x : R) : R := - g1 (- x).
Definition left_edge_series (Es : R) (g1 : R -> R) (b k0 k1 k2 : R) : Prop :=
  right_edge_series Es (mirrored g1) b k0 k1 k2.

Lemma place_mirrored a b theta : place b a theta = - place a b (- theta).
Proof. unfold place. rewrite sin_neg. field. Qed.

Lemma consistent_mirrored g1 a b : consistent g1 a b -> consistent (mirrored g1) b a.
Proof.
  unfold consistent. intros H.
  apply (is_RInt_ext (fun theta => opp (g1 (place a b (- theta))))).
  - intros theta _. unfold mirrored. rewrite place_mirrored, Ropp_involutive. reflexivity.
  - apply (is_RInt_comp_opp (fun theta => g1 (place a b theta))).
    rewrite Ropp_involutive.
    replace 0 with (opp 0) by (unfold opp; simpl; ring).
    apply (is_RInt_swap (V := R_NormedModule)). exact H.
Qed.

Lemma load_mirrored Es g1 a b P : is_load Es g1 a b P -> is_load Es (mirrored g1) b a P.
Proof.
  unfold is_load. intros H.
  apply (is_RInt_ext (fun theta => opp (opp (Es / 2 * (place a b (- theta) * g1 (place a b (- theta))))))).
  - intros theta _. rewrite opp_opp. unfold mirrored. rewrite place_mirrored, Ropp_involutive.
    match goal with |- @eq _ ?x ?y => change (@eq R x y) end. ring.
  - rewrite <- (opp_opp (G := R_NormedModule) P). apply (is_RInt_opp (V := R_NormedModule)).
    apply (is_RInt_comp_opp (fun theta => Es / 2 * (place a b theta * g1 (place a b theta)))).
    rewrite Ropp_involutive. apply (is_RInt_swap (V := R_NormedModule)). exact H.
Qed.

(* b grows with a, has one derivative more, and alpha is its inverse. *)
Definition is_left_edge (a : R) (b b1 b2 b3 alpha : R -> R) : Prop :=
  alpha (b a) = a /\ exists eta, 0 < eta /\
  (forall s, a - eta < s < a + eta -> 0 < b1 s /\ is_derive b2 s (b3 s) /\ continuous b3 s) /\
  (forall r, b a - eta < r < b a + eta -> b (alpha r) = r /\ is_derive alpha r (/ b1 (alpha r))).

Section Left.
Variables (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R).
Hypothesis contact : is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2.
Hypothesis left : is_left_edge a b b1 b2 b3 alpha.

Let Q r := P (alpha r).
Let Q1 r := P1 (alpha r) / b1 (alpha r).
Let Q2 r := (P2 (alpha r) * b1 (alpha r) - P1 (alpha r) * b2 (alpha r)) / b1 (alpha r) ^ 3.
Let Q3 r := ((P3 (alpha r) * b1 (alpha r) - P1 (alpha r) * b3 (alpha r)) * b1 (alpha r)
  - 3 * b2 (alpha r) * (P2 (alpha r) * b1 (alpha r) - P1 (alpha r) * b2 (alpha r))) / b1 (alpha r) ^ 5.
Let alpha1 r := / b1 (alpha r).
Let alpha2 r := - b2 (alpha r) / b1 (alpha r) ^ 3.

Ltac known f s d H := replace (Derive (fun x : R => f x) s) with d by (symmetry; apply is_derive_unique; exact H).

Lemma continuous_of_derive (f : R -> R) s d : is_derive f s d -> continuous f s.
Proof. intros H. apply (@ex_derive_continuous R_AbsRing R_NormedModule). exists d. exact H. Qed.

Lemma left_contact : is_smooth_contact Es (mirrored g1) (b a) Q Q1 Q2 Q3 alpha alpha1 alpha2.
Proof.
  destruct contact as [e1 [He1 H1]]. destruct left as [inverse [e2 [He2 [H2 H3]]]].
  assert (Hca : continuous alpha (b a)).
  { destruct (H3 (b a) ltac:(lra)) as [_ Hd]. exact (continuous_of_derive _ _ _ Hd). }
  set (e := Rmin e1 e2).
  assert (He : 0 < e) by (apply Rmin_pos; assumption).
  assert (Hle1 : e <= e1) by apply Rmin_l. assert (Hle2 : e <= e2) by apply Rmin_r.
  assert (Hnear : locally (b a) (fun r => a - e < alpha r < a + e)).
  { apply (Hca (fun y => a - e < y < a + e)). rewrite inverse.
    exists (mkposreal e He). intros y Hy.
    unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
    apply Rabs_def2 in Hy. lra. }
  destruct Hnear as [d Hd].
  assert (Hab : 2 * e1 < a + b a) by (apply (H1 a); lra).
  exists (Rmin (Rmin d e2) (e1 / 2)). 
  assert (Hm1 := Rmin_l (Rmin d e2) (e1 / 2)). assert (Hm2 := Rmin_r (Rmin d e2) (e1 / 2)).
  assert (Hm3 := Rmin_l d e2). assert (Hm4 := Rmin_r d e2). assert (Hd0 := cond_pos d).
  set (m := Rmin (Rmin d e2) (e1 / 2)) in *.
  assert (Hm : 0 < m) by (unfold m; repeat apply Rmin_pos; lra).
  split; [exact Hm |].
  assert (Hin : forall r, b a - m < r < b a + m -> a - e < alpha r < a + e).
  { intros r Hr. apply Hd. unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl.
    apply Rabs_def1; lra. }
  intros r Hr.
  assert (Hs := Hin r Hr).
  destruct (H1 (alpha r) ltac:(lra)) as (Hc & HP1 & HP2 & HP3 & Hb & Hb1 & Hb2 & Hw).
  destruct Hc as (Hpos & Hcons & Hload & HP).
  destruct (H2 (alpha r) ltac:(lra)) as (Hb1pos & Hb2d & Hb3).
  destruct (H3 r ltac:(lra)) as (Hba & Halpha).
  unfold is_contact_at. repeat match goal with |- _ /\ _ => split end.
  - clear - Hba Hpos. rewrite Hba in Hpos. lra.
  - apply consistent_mirrored. rewrite Hba in Hcons. exact Hcons.
  - apply (locally_near r (m - Rabs (r - b a))).
    + assert (Rabs (r - b a) < m) by (apply Rabs_def1; lra). lra.
    + intros z Hz. assert (Hz' : b a - m < z < b a + m).
      { generalize (Rle_abs (r - b a)) (Rle_abs (- (r - b a))). rewrite Rabs_Ropp. lra. }
      assert (Hsz := Hin z Hz'). destruct (H1 (alpha z) ltac:(lra)) as ((_ & _ & Hlz & _) & _).
      destruct (H3 z ltac:(lra)) as (Hbz & _).
      apply load_mirrored. apply locally_singleton in Hlz. rewrite Hbz in Hlz. exact Hlz.
  - unfold Q, Q1. auto_derive.
    + repeat split; eexists; eassumption.
    + known alpha r (/ b1 (alpha r)) Halpha. known P (alpha r) (P1 (alpha r)) HP. field. lra.
  - unfold Q1, Q2. auto_derive.
    + repeat split; try (eexists; eassumption); try lra.
    + known alpha r (/ b1 (alpha r)) Halpha. known P1 (alpha r) (P2 (alpha r)) HP1.
      known b1 (alpha r) (b2 (alpha r)) Hb1. field. lra.
  - unfold Q2, Q3. auto_derive.
    + assert (0 < b1 (alpha r) ^ 3) by (apply pow_lt, Hb1pos).
      repeat split; try (eexists; eassumption). apply Rgt_not_eq. assumption.
    + known alpha r (/ b1 (alpha r)) Halpha. known P1 (alpha r) (P2 (alpha r)) HP1.
      known b1 (alpha r) (b2 (alpha r)) Hb1. known P2 (alpha r) (P3 (alpha r)) HP2.
      known b2 (alpha r) (b3 (alpha r)) Hb2d. field. lra.
  - assert (Ha := continuous_of_derive _ _ _ Halpha).
    assert (CP1 : continuous (fun r => P1 (alpha r)) r) by (apply (continuous_comp alpha P1); [exact Ha | exact (continuous_of_derive _ _ _ HP1)]).
    assert (CP2 : continuous (fun r => P2 (alpha r)) r) by (apply (continuous_comp alpha P2); [exact Ha | exact (continuous_of_derive _ _ _ HP2)]).
    assert (CP3 : continuous (fun r => P3 (alpha r)) r) by (apply (continuous_comp alpha P3); [exact Ha | exact HP3]).
    assert (Cb1 : continuous (fun r => b1 (alpha r)) r) by (apply (continuous_comp alpha b1); [exact Ha | exact (continuous_of_derive _ _ _ Hb1)]).
    assert (Cb2 : continuous (fun r => b2 (alpha r)) r) by (apply (continuous_comp alpha b2); [exact Ha | exact (continuous_of_derive _ _ _ Hb2d)]).
    assert (Cb3 : continuous (fun r => b3 (alpha r)) r) by (apply (continuous_comp alpha b3); [exact Ha | exact Hb3]).
    unfold Q3. apply continuous_quotient.
    + apply continuous_sub.
      * apply continuous_times; [| exact Cb1]. apply continuous_sub; apply continuous_times; assumption.
      * apply continuous_times; [apply continuous_times; [apply continuous_const | exact Cb2] |].
        apply continuous_sub; apply continuous_times; assumption.
    + apply (continuous_comp (fun r => b1 (alpha r)) (fun x => x ^ 5)); [exact Cb1 |].
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
    + apply Rgt_not_eq. apply pow_lt, Hb1pos.
  - exact Halpha.
  - unfold alpha1, alpha2. auto_derive.
    + repeat split; try (eexists; eassumption); try lra.
    + known alpha r (/ b1 (alpha r)) Halpha. known b1 (alpha r) (b2 (alpha r)) Hb1. field. lra.
  - assert (Ha := continuous_of_derive _ _ _ Halpha).
    assert (Cb1 : continuous (fun r => b1 (alpha r)) r) by (apply (continuous_comp alpha b1); [exact Ha | exact (continuous_of_derive _ _ _ Hb1)]).
    assert (Cb2 : continuous (fun r => b2 (alpha r)) r) by (apply (continuous_comp alpha b2); [exact Ha | exact (continuous_of_derive _ _ _ Hb2d)]).
    unfold alpha2. apply continuous_quotient.
    + apply (continuous_opp (fun r => b2 (alpha r))). exact Cb2.
    + apply (continuous_comp (fun r => b1 (alpha r)) (fun x => x ^ 3)); [exact Cb1 |].
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
    + apply Rgt_not_eq. apply pow_lt, Hb1pos.
  - assert (Hax : a - e < alpha r) by lra. 
    assert (H : b a + a - e < b a + alpha r) by lra. lra.
Qed.

Theorem left_edge : left_edge_series Es g1 (b a)
  (c0 Q1 alpha (b a)) (c1 Q1 Q2 alpha alpha1 (b a)) (c2 Q1 Q2 Q3 alpha alpha1 alpha2 (b a)).
Proof. exact (right_edge _ _ _ _ _ _ _ _ _ _ left_contact). Qed.

(* The same, written in the functions of a. *)
Definition left_c0 := 2 * (P1 a / b1 a) / (PI * sqrt (a + b a)).
Definition left_c1 :=
  2 / PI * (- (2 / 3) * ((P2 a * b1 a - P1 a * b2 a) / b1 a ^ 3) / sqrt (a + b a)
    + P1 a / b1 a * (1 / 2 + / b1 a / 3) / ((a + b a) * sqrt (a + b a))).
Definition left_c2 :=
  1 / PI * (8 / 15 * (((P3 a * b1 a - P1 a * b3 a) * b1 a - 3 * b2 a * (P2 a * b1 a - P1 a * b2 a)) / b1 a ^ 5)
      / sqrt (a + b a)
    - (2 / 3 + 8 / 15 * / b1 a) * ((P2 a * b1 a - P1 a * b2 a) / b1 a ^ 3) / ((a + b a) * sqrt (a + b a))
    - 4 / 15 * (- b2 a / b1 a ^ 3) * (P1 a / b1 a) / ((a + b a) * sqrt (a + b a))
    + 3 / 4 * (P1 a / b1 a) * (1 + 4 / 3 * / b1 a + 8 / 15 * (/ b1 a) ^ 2) / ((a + b a) ^ 2 * sqrt (a + b a))).

Lemma left_edge_of_a : left_edge_series Es g1 (b a) left_c0 left_c1 left_c2.
Proof.
  assert (H := left_edge). destruct left as [inverse _].
  unfold c0, c1, c2, Q1, Q2, Q3, alpha1, alpha2 in H. rewrite !inverse, !(Rplus_comm (b a) a) in H. exact H.
Qed.
End Left.
