(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics Sides Gamma PowerLaw.
Open Scope R_scope.

(* ---- One term lies below the pressure of power laws with m < 5/8 ---- *)

Lemma ln_below y : 0 < y -> ln y <= y - 1.
Proof. intros H. assert (E := exp_ineq1_le (ln y)). rewrite exp_ln in E by exact H. lra. Qed.

Section Place.
Variables a x m : R.
Hypothesis Hx : 0 < x < a.
Hypothesis Hm : 0 <= m < 5 / 8.
Let c := sqrt (a - x).
Let c_positive : 0 < c. Proof. apply sqrt_lt_R0. lra. Qed.
Let c_squared : c ^ 2 = a - x. Proof. apply pow2_sqrt. lra. Qed.
Let f w := 2 * (Rpower (x + w ^ 2) m / sqrt (x + (x + w ^ 2))).
Let K := 2 * (Rpower a m / sqrt (a + a)).

(* f = K exp g >= K (1 + g). *)
Let g w := m * ln ((x + w ^ 2) / a) - / 2 * ln ((x + (x + w ^ 2)) / (a + a)).
Let G w := m * (w * ln ((x + w ^ 2) / a) - 2 * w + 2 * sqrt x * atan (w / sqrt x)) -
  / 2 * (w * ln ((x + (x + w ^ 2)) / (a + a)) - 2 * w + 2 * sqrt (2 * x) * atan (w / sqrt (2 * x))).

Lemma f_above w : K * (1 + g w) <= f w.
Proof.
  assert (0 <= w ^ 2) by apply pow2_ge_0. assert (HK : 0 < K).
  { unfold K. assert (0 < Rpower a m) by apply exp_pos. assert (0 < sqrt (a + a)) by (apply sqrt_lt_R0; lra).
    assert (0 < Rpower a m / sqrt (a + a)) by (apply Rdiv_lt_0_compat; assumption). lra. }
  replace (f w) with (K * exp (g w)); [apply Rmult_le_compat_l; [lra |]; apply exp_ineq1_le |].
  unfold f, K, g. rewrite <- !Rpower_sqrt by lra. unfold Rpower, Rdiv. rewrite !ln_mult, !ln_Rinv by (try apply Rinv_0_lt_compat; lra).
  rewrite <- !exp_Ropp, !Rmult_assoc, <- !exp_plus. f_equal. f_equal. ring.
Qed.
Lemma G_derive w : is_derive G w (g w).
Proof.
  assert (0 <= w ^ 2) by apply pow2_ge_0. assert (R1 : 0 < sqrt x) by (apply sqrt_lt_R0; lra). assert (R2 : 0 < sqrt (2 * x)) by (apply sqrt_lt_R0; lra).
  assert (E1 : sqrt x * sqrt x = x) by (apply sqrt_sqrt; lra). assert (E2 : sqrt (2 * x) * sqrt (2 * x) = 2 * x) by (apply sqrt_sqrt; lra).
  assert (A : 0 < (x + w ^ 2) / a) by (apply Rdiv_lt_0_compat; lra). assert (B : 0 < (x + (x + w ^ 2)) / (a + a)) by (apply Rdiv_lt_0_compat; lra).
  assert (D1 : is_derive (fun w => 2 * sqrt x * atan (w / sqrt x)) w (2 * x / (x + w ^ 2))).
  { auto_derive; [lra |]. set (r := sqrt x) in *. clearbody r. rewrite <- E1. field. repeat split; nra. }
  assert (D2 : is_derive (fun w => 2 * sqrt (2 * x) * atan (w / sqrt (2 * x))) w (2 * (2 * x) / (2 * x + w ^ 2))).
  { auto_derive; [lra |]. set (r := sqrt (2 * x)) in *. clearbody r. rewrite <- E2. field. repeat split; nra. }
  assert (L1 : is_derive (fun w => w * ln ((x + w ^ 2) / a) - 2 * w) w (ln ((x + w ^ 2) / a) + 2 * w ^ 2 / (x + w ^ 2) - 2)).
  { auto_derive; [simpl in *; repeat split; lra |]. replace (w * (w * 1)) with (w ^ 2) by ring. unfold Rdiv. field. lra. }
  assert (L2 : is_derive (fun w => w * ln ((x + (x + w ^ 2)) / (a + a)) - 2 * w) w (ln ((x + (x + w ^ 2)) / (a + a)) + 2 * w ^ 2 / (2 * x + w ^ 2) - 2)).
  { auto_derive; [simpl in *; repeat split; lra |]. replace (w * (w * 1)) with (w ^ 2) by ring. unfold Rdiv. field. lra. }
  assert (S := is_derive_minus (V := R_NormedModule) _ _ _ _ _ (is_derive_scal _ _ m _ (is_derive_plus _ _ _ _ _ L1 D1)) (is_derive_scal _ _ (/ 2) _ (is_derive_plus _ _ _ _ _ L2 D2))).
  match type of S with is_derive _ _ ?v => replace (g w) with v end.
  - exact S.
  - unfold g, minus, plus, opp; simpl. match goal with |- @eq _ ?x ?y => change (@eq R x y) end. field. lra.
Qed.
Lemma g_continuous w : continuous g w.
Proof.
  assert (0 <= w ^ 2) by apply pow2_ge_0. apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold g. auto_derive.
  replace (w * (w * 1)) with (w ^ 2) by ring. split; [apply Rdiv_lt_0_compat; lra | split; [apply Rdiv_lt_0_compat; lra | trivial]].
Qed.
Lemma G_at_0 : G 0 = 0.
Proof. unfold G, Rdiv. rewrite !Rmult_0_l, atan_0. ring. Qed.

(* G c, as a function of c for this x, has the derivative H1. *)
Let H r := m * (- 2 * r + 2 * sqrt x * atan (r / sqrt x)) -
  / 2 * (r * ln ((x + (x + r ^ 2)) / (2 * (x + r ^ 2))) - 2 * r + 2 * sqrt (2 * x) * atan (r / sqrt (2 * x))).
Let H1 r := (1 - 2 * m) * (r ^ 2 / (x + r ^ 2)) - / 2 * ln ((x + (x + r ^ 2)) / (2 * (x + r ^ 2))).
Lemma H_derive r : is_derive H r (H1 r).
Proof.
  assert (0 <= r ^ 2) by apply pow2_ge_0. assert (R1 : 0 < sqrt x) by (apply sqrt_lt_R0; lra). assert (R2 : 0 < sqrt (2 * x)) by (apply sqrt_lt_R0; lra).
  assert (E1 : sqrt x * sqrt x = x) by (apply sqrt_sqrt; lra). assert (E2 : sqrt (2 * x) * sqrt (2 * x) = 2 * x) by (apply sqrt_sqrt; lra).
  assert (D1 : is_derive (fun r => - 2 * r + 2 * sqrt x * atan (r / sqrt x)) r (- 2 + 2 * x / (x + r ^ 2))).
  { auto_derive; [lra |]. set (q := sqrt x) in *. clearbody q. rewrite <- E1. field. repeat split; nra. }
  assert (D2 : is_derive (fun r => 2 * sqrt (2 * x) * atan (r / sqrt (2 * x))) r (2 * (2 * x) / (2 * x + r ^ 2))).
  { auto_derive; [lra |]. set (q := sqrt (2 * x)) in *. clearbody q. rewrite <- E2. field. repeat split; nra. }
  assert (L : is_derive (fun r => r * ln ((x + (x + r ^ 2)) / (2 * (x + r ^ 2))) - 2 * r) r
    (ln ((x + (x + r ^ 2)) / (2 * (x + r ^ 2))) + r * (2 * r / (2 * x + r ^ 2) - 2 * r / (x + r ^ 2)) - 2)).
  { auto_derive.
    - replace (r * (r * 1)) with (r ^ 2) by ring. repeat split; try lra. apply Rdiv_lt_0_compat; lra.
    - replace (r * (r * 1)) with (r ^ 2) by ring. unfold Rdiv. field. lra. }
  assert (S := is_derive_minus (V := R_NormedModule) _ _ _ _ _ (is_derive_scal _ _ m _ D1) (is_derive_scal _ _ (/ 2) _ (is_derive_plus _ _ _ _ _ L D2))).
  match type of S with is_derive _ _ ?v => replace (H1 r) with v end.
  - exact S.
  - unfold H1, minus, plus, opp; simpl. match goal with |- @eq _ ?x ?y => change (@eq R x y) end. field. split; lra.
Qed.
Lemma H1_positive r : 0 < r -> 0 < H1 r.
Proof.
  intros Hr. assert (0 < r ^ 2) by (apply pow_lt; lra). unfold H1.
  assert (L := ln_below ((x + (x + r ^ 2)) / (2 * (x + r ^ 2))) ltac:(apply Rdiv_lt_0_compat; lra)).
  set (t := r ^ 2 / (x + r ^ 2)) in *. assert (0 < t) by (apply Rdiv_lt_0_compat; lra).
  replace ((x + (x + r ^ 2)) / (2 * (x + r ^ 2)) - 1) with (- (t / 2)) in L by (unfold t; field; lra). nra.
Qed.
Lemma G_positive : 0 < G c.
Proof.
  replace (G c) with (H c).
  - apply (rises_from_zero H H1 c c_positive).
    + unfold H, Rdiv. rewrite !Rmult_0_l, atan_0. ring.
    + intros s _. apply H_derive.
    + intros s Hs. apply H1_positive. lra.
  - unfold G, H. rewrite c_squared. replace (x + (a - x)) with a by ring. replace (a / a) with 1 by (field; lra).
    rewrite ln_1. replace (a + a) with (2 * a) by ring. ring.
Qed.

Lemma one_term_below : 2 * (Rpower a m / sqrt (a + a)) * sqrt (a - x) < RInt f 0 (sqrt (a - x)).
Proof.
  assert (HK : 0 < K).
  { unfold K. assert (0 < Rpower a m) by apply exp_pos. assert (0 < sqrt (a + a)) by (apply sqrt_lt_R0; lra).
    assert (0 < Rpower a m / sqrt (a + a)) by (apply Rdiv_lt_0_compat; assumption). lra. }
  assert (J : is_RInt (fun w => K * (1 + g w)) 0 c (K * (c + G c) - K * (0 + G 0))).
  { apply (is_RInt_derive (fun w => K * (w + G w)) (fun w => K * (1 + g w))).
    - intros w _. apply (is_derive_scal (fun w => w + G w)). apply (is_derive_plus (V := R_NormedModule) (fun w => w) G w 1 (g w)).
      + apply (is_derive_id (K := R_AbsRing)).
      + apply G_derive.
    - intros w _. apply continuous_times; [apply continuous_const |]. apply continuous_add; [apply continuous_const | apply g_continuous]. }
  apply Rlt_le_trans with (RInt (fun w => K * (1 + g w)) 0 c).
  - rewrite (is_RInt_unique (V := R_CompleteNormedModule) _ _ _ _ J), G_at_0. assert (P := G_positive). fold c K. nra.
  - apply RInt_le; [apply Rlt_le, c_positive | eexists; exact J | |].
    + apply (@ex_RInt_continuous R_CompleteNormedModule). intros w _. assert (0 <= w ^ 2) by apply pow2_ge_0.
      assert (0 < sqrt (x + (x + w ^ 2))) by (apply sqrt_lt_R0; lra).
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold f, Rpower. auto_derive.
      replace (w * (w * 1)) with (w ^ 2) by ring. repeat split; lra.
    + intros w _. apply f_above.
Qed.
End Place.

Theorem power_one_term_below Es C m a : 0 < Es /\ 0 < C /\ 0 <= m < 5 / 8 /\ 0 < a -> exists r0 r1 r2,
  is_the_right_series Es (power_slope C m) a r0 r1 r2 /\
  forall u, 0 < u < a -> exists p0, is_the_pressure Es (power_slope C m) a (a - u) p0 /\ r0 * sqrt u < p0.
Proof.
  intros form. assert (Hpi := PI_RGT_0). do 3 eexists. split.
  { apply (the_right_series _ _ 0); [apply power_slope_rises; lra | lra |]. exact (right_edge _ _ _ _ _ _ _ _ _ _ (power_smooth_contact Es C m ltac:(lra) a ltac:(lra))). }
  intros u Hu. eexists. split; [apply power_the_pressure; lra |].
  assert (B := one_term_below a (a - u) m ltac:(lra) ltac:(lra)). replace (a - (a - u)) with u in B |- * by ring.
  assert (W := wallis_positive (m + 1) ltac:(lra)). assert (0 < sqrt (a + a)) by (apply sqrt_lt_R0; lra).
  apply (Rmult_lt_compat_l (1 / PI * (Es * C * wallis (m + 1) * (m + 1)))) in B.
  2: { apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra |]. repeat first [lra | apply Rmult_lt_0_compat]. }
  refine (Rle_lt_trans _ _ _ _ B). right. unfold c0, power_load_1. replace (m + 1 - 1) with m by ring. field. repeat split; lra.
Qed.
Ltac near_edge_by theorem :=
  let r0 := fresh "r0" in let r1 := fresh "r1" in let r2 := fresh "r2" in let Hr := fresh "Hr" in let H := fresh "H" in
  destruct theorem as (r0 & r1 & r2 & Hr & H); exists r0, r1, r2; split; [exact Hr |];
  first [exact H | match type of H with forall u, 0 < u < ?c -> _ => exists c; split; [lra | exact H] end].
