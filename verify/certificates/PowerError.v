(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics Orders Gamma PowerLaw.
Open Scope R_scope.

(* ---- One term of power laws with m > 5/8 ---- *)

(* If the second coefficient is negative, the first term lies above the pressure near the edge. *)
Lemma above_near_edge Es g1 y a r0 r1 r2 : rises_at g1 y -> y < a -> right_edge_series Es g1 a r0 r1 r2 -> r1 < 0 ->
  exists d, 0 < d /\ forall u, 0 < u < d -> exists p0, is_the_pressure Es g1 a (a - u) p0 /\ p0 < r0 * sqrt u.
Proof.
  intros Hg Hy H Hr. destruct (orders_of_series _ _ _ _ _ _ _ Hg Hy H) as (p & d & Hd & Hp & _ & L & _).
  destruct (L (fun z => z < 0)) as [[e He] Near].
  { exists (mkposreal (- r1) ltac:(lra)). intros z Hz. unfold ball in Hz; simpl in Hz.
    unfold AbsRing_ball, abs, minus, plus, opp in Hz; simpl in Hz. apply Rabs_def2 in Hz. lra. }
  exists (Rmin d e). split; [apply Rmin_pos; assumption |]. intros u Hu.
  assert (M1 := Rmin_l d e). assert (M2 := Rmin_r d e). exists (p u). split; [apply Hp; lra |].
  assert (N : (p u - r0 * sqrt u) / (u * sqrt u) < 0).
  { apply Near; [| lra]. unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl. rewrite Rabs_pos_eq; lra. }
  assert (Q : 0 < u * sqrt u) by (apply Rmult_lt_0_compat; [lra | apply sqrt_lt_R0; lra]).
  apply (Rmult_lt_compat_r (u * sqrt u)) in N; [| exact Q].
  unfold Rdiv in N. rewrite Rmult_assoc, Rinv_l, Rmult_0_l in N by lra. lra.
Qed.

Theorem power_above_near_edge Es C m a : 0 < Es /\ 0 < C /\ 5 / 8 < m /\ 0 < a -> exists r0 r1 r2,
  is_the_right_series Es (power_slope C m) a r0 r1 r2 /\
  exists d, 0 < d /\ forall u, 0 < u < d -> exists p0, is_the_pressure Es (power_slope C m) a (a - u) p0 /\ p0 < r0 * sqrt u.
Proof.
  intros form. assert (Hpi := PI_RGT_0). assert (Rise : rises_at (power_slope C m) 0) by (apply power_slope_rises; lra).
  assert (S := right_edge _ _ _ _ _ _ _ _ _ _ (power_smooth_contact Es C m ltac:(lra) a ltac:(lra))).
  do 3 eexists. split; [apply (the_right_series _ _ 0); [exact Rise | lra | exact S] |].
  apply (above_near_edge Es (power_slope C m) 0 a _ _ _ Rise ltac:(lra) S).
  assert (W := wallis_positive (m + 1) ltac:(lra)). assert (0 < sqrt (a + a)) by (apply sqrt_lt_R0; lra).
  assert (Pm : 0 < Rpower a m) by apply exp_pos.
  unfold c1, power_load_1, power_load_2. replace (m + 1 - 1 - 1) with (m - INR 1) by (simpl; ring). replace (m + 1 - 1) with m by ring.
  rewrite power_minus by lra. replace (a ^ 1) with a by ring.
  replace (2 / PI * _) with (- ((2 / 3 * m - 5 / 12) * (2 / PI * (Es * C * wallis (m + 1) * (m + 1) * Rpower a m / (a * sqrt (a + a))))))
    by (field; repeat split; lra).
  enough (0 < (2 / 3 * m - 5 / 12) * (2 / PI * (Es * C * wallis (m + 1) * (m + 1) * Rpower a m / (a * sqrt (a + a))))) by lra.
  apply Rmult_lt_0_compat; [lra |]. apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra |].
  apply Rdiv_lt_0_compat; repeat first [lra | apply Rmult_lt_0_compat].
Qed.

(* The contact with Es = C = a = 1: one term, divided by the pressure at the distance u. *)
Definition square_root_integral (m u : R) : R :=
  RInt (fun w => 2 * (Rpower (1 - u + w ^ 2) m / sqrt (1 - u + (1 - u + w ^ 2)))) 0 (sqrt u).
Lemma power_ratio m u : 0 <= m -> 0 < u < 1 -> exists p0 r0 r1 r2,
  is_the_pressure 1 (power_slope 1 m) 1 (1 - u) p0 /\ is_the_right_series 1 (power_slope 1 m) 1 r0 r1 r2 /\ 0 < p0 /\
  r0 * sqrt u / p0 = sqrt 2 * sqrt u / square_root_integral m u.
Proof.
  intros Hm Hu. assert (Hpi := PI_RGT_0). assert (W := wallis_positive (m + 1) ltac:(lra)). unfold square_root_integral.
  do 4 eexists. split; [exact (power_the_pressure 1 1 m ltac:(lra) Hm 1 (1 - u) ltac:(lra)) |]. split.
  { apply (the_right_series _ _ 0); [apply power_slope_rises; lra | lra |]. exact (right_edge _ _ _ _ _ _ _ _ _ _ (power_smooth_contact 1 1 m Hm 1 ltac:(lra))). }
  replace (1 - (1 - u)) with u by ring.
  assert (Hs : 0 < sqrt u) by (apply sqrt_lt_R0; lra).
  assert (HI : 0 < RInt (fun w => 2 * (Rpower (1 - u + w ^ 2) m / sqrt (1 - u + (1 - u + w ^ 2)))) 0 (sqrt u)).
  { apply RInt_gt_0; [exact Hs | |].
    - intros w _. assert (0 <= w ^ 2) by apply pow2_ge_0. apply Rmult_lt_0_compat; [lra |].
      apply Rdiv_lt_0_compat; [apply exp_pos | apply sqrt_lt_R0; lra].
    - intros w _. assert (0 <= w ^ 2) by apply pow2_ge_0. assert (0 < sqrt (1 - u + (1 - u + w ^ 2))) by (apply sqrt_lt_R0; lra).
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold Rpower. auto_derive.
      replace (w * (w * 1)) with (w ^ 2) by ring. repeat split; lra. }
  set (I := RInt _ _ _) in *. clearbody I. split.
  - apply Rmult_lt_0_compat; [| exact HI]. apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; lra |]. repeat first [lra | apply Rmult_lt_0_compat].
  - assert (H2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (E2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
    unfold c0, power_load_1. replace (m + 1 - 1) with m by ring. replace (1 + 1) with 2 by ring.
    replace (Rpower 1 m) with 1 by (unfold Rpower; rewrite ln_1, Rmult_0_r, exp_0; reflexivity).
    replace (2 * (1 * 1 * wallis (m + 1) * (m + 1) * 1)) with (sqrt 2 * sqrt 2 * (wallis (m + 1) * (m + 1))) by (rewrite E2; ring).
    field. repeat split; lra.
Qed.
(* The same at two distances. *)
Lemma power_ratios m u v : 0 <= m -> 0 < u < 1 -> 0 < v < 1 -> exists p0 q0 r0 r1 r2,
  is_the_pressure 1 (power_slope 1 m) 1 (1 - u) p0 /\ is_the_pressure 1 (power_slope 1 m) 1 (1 - v) q0 /\
  is_the_right_series 1 (power_slope 1 m) 1 r0 r1 r2 /\
  r0 * sqrt u / p0 = sqrt 2 * sqrt u / square_root_integral m u /\
  r0 * sqrt v / q0 = sqrt 2 * sqrt v / square_root_integral m v.
Proof.
  intros Hm Hu Hv. destruct (power_ratio m u Hm Hu) as (p0 & r0 & r1 & r2 & Hp & Hr & _ & E).
  destruct (power_ratio m v Hm Hv) as (q0 & s0 & s1 & s2 & Hq & [Hs _] & _ & F).
  destruct (proj2 Hr _ _ _ Hs) as (-> & _ & _).
  exists p0, q0, r0, r1, r2. split; [exact Hp | split; [exact Hq | split; [exact Hr | split; assumption]]].
Qed.
Lemma below_by_ratio t p : 0 < p -> t / p < 1 -> t < p.
Proof.
  intros Hp H. apply (Rmult_lt_compat_r p) in H; [| exact Hp]. unfold Rdiv in H.
  rewrite Rmult_assoc, Rinv_l, Rmult_1_l, Rmult_1_r in H by lra. exact H.
Qed.
(* Replaces these integrals by numbers with bounds. *)
Ltac square_root_integrals :=
  unfold square_root_integral, Rpower;
  repeat match goal with |- context [RInt ?f ?l ?u] =>
    let H := fresh "H" in
    integral_intro (RInt f l u) with (i_prec 40, i_relwidth 20, i_degree 8, i_fuel 2000) as H;
    revert H; generalize (RInt f l u); intros ? H
  end.
