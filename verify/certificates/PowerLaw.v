(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics Gamma.
Open Scope R_scope.

(* g'(x) of a punch with the gap C |x|^(m+1) / (m+1), for any real m. *)
Definition power_slope (C m x : R) : R :=
  if Rlt_dec 0 x then C * Rpower x m else if Rlt_dec x 0 then - (C * Rpower (- x) m) else 0.

Section PowerLaw.
Variables Es C m : R.
Hypothesis HC : 0 < C.
Hypothesis Hm : 0 <= m.

Lemma power_slope_right x : 0 < x -> power_slope C m x = C * Rpower x m.
Proof. intros H. unfold power_slope. destruct (Rlt_dec 0 x); [reflexivity | contradiction]. Qed.
Lemma power_slope_left x : x < 0 -> power_slope C m x = - (C * Rpower (- x) m).
Proof. intros H. unfold power_slope. destruct (Rlt_dec 0 x); [lra |]. destruct (Rlt_dec x 0); [reflexivity | contradiction]. Qed.
Lemma power_slope_odd x : power_slope C m (- x) = - power_slope C m x.
Proof.
  destruct (Rtotal_order x 0) as [H | [-> | H]].
  - rewrite power_slope_right, power_slope_left by lra. ring.
  - unfold power_slope. rewrite Ropp_0. destruct (Rlt_dec 0 0); lra.
  - rewrite (power_slope_left (- x)), power_slope_right, Ropp_involutive by lra. reflexivity.
Qed.
Lemma power_slope_rises : rises_at (power_slope C m) 0.
Proof.
  assert (Pos : forall x, 0 < x -> 0 < power_slope C m x).
  { intros x H. rewrite power_slope_right by exact H. apply Rmult_lt_0_compat; [exact HC | apply exp_pos]. }
  assert (Neg : forall x, x < 0 -> power_slope C m x < 0).
  { intros x H. rewrite <- (Ropp_involutive x), power_slope_odd. generalize (Pos (- x) ltac:(lra)). lra. }
  assert (Zero : power_slope C m 0 = 0) by (unfold power_slope; destruct (Rlt_dec 0 0); lra).
  assert (Mono : forall x z, 0 < x -> x <= z -> power_slope C m x <= power_slope C m z).
  { intros x z Hx Hxz. rewrite !power_slope_right by lra. apply Rmult_le_compat_l; [lra |]. apply Rle_Rpower_l; lra. }
  split; [| split].
  - intros x z Hxz. destruct (Rtotal_order x 0) as [H | [-> | H]]; destruct (Rtotal_order z 0) as [K | [-> | K]]; try lra.
    + assert (M := Mono (- z) (- x) ltac:(lra) ltac:(lra)). rewrite !power_slope_odd in M. lra.
    + generalize (Neg x H). lra.
    + generalize (Neg x H) (Pos z K). lra.
    + generalize (Pos z K). lra.
    + apply Mono; lra.
  - exact Pos.
  - intros d Hd. rewrite Rminus_0_l, Rplus_0_l. generalize (Neg (- d) ltac:(lra)) (Pos d Hd). lra.
Qed.

Lemma place_middle s theta : place s s theta = s * sin theta.
Proof. unfold place. field. Qed.
Lemma sine_positive theta : 0 < theta < PI / 2 -> 0 < sin theta.
Proof. intros H. apply sin_gt_0; lra. Qed.

Section Contact.
Variable s : R.
Hypothesis Hs : 0 < s.

Lemma half_exists : ex_RInt (fun theta => power_slope C m (place s s theta)) 0 (PI / 2).
Proof.
  assert (Hpi := PI_RGT_0). destruct (Rle_lt_or_eq_dec 0 m Hm) as [H | H].
  - apply (ex_RInt_ext (fun theta => C * power m (s * sin theta))).
    + intros theta Ht. rewrite Rmin_left in Ht by lra. rewrite Rmax_right in Ht by lra.
      assert (0 < s * sin theta) by (apply Rmult_lt_0_compat; [exact Hs | apply sine_positive, Ht]).
      rewrite place_middle, power_slope_right, power_of_positive by assumption. reflexivity.
    + apply (@ex_RInt_continuous R_CompleteNormedModule). intros theta _. apply continuous_times; [apply continuous_const |].
      apply (continuous_comp (fun theta => s * sin theta) (power m)); [| apply power_continuous, H].
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - apply (ex_RInt_ext (fun _ => C)).
    + intros theta Ht. rewrite Rmin_left in Ht by lra. rewrite Rmax_right in Ht by lra.
      assert (0 < s * sin theta) by (apply Rmult_lt_0_compat; [exact Hs | apply sine_positive, Ht]).
      rewrite place_middle, power_slope_right, <- H, Rpower_O, Rmult_1_r by assumption. reflexivity.
    + apply ex_RInt_const.
Qed.
(* An odd function has the integral 0, and an even one twice that of its half. *)
Lemma from_half (f : R -> R) k l : (forall theta, f (- theta) = k * f theta) -> is_RInt f 0 (PI / 2) l ->
  is_RInt f (- (PI / 2)) (PI / 2) (k * l + l).
Proof.
  intros Hk H. apply (is_RInt_Chasles f (- (PI / 2)) 0 (PI / 2) (k * l) l); [| exact H].
  apply (is_RInt_ext (fun theta => opp (- k * f (- theta)))).
  { intros theta _. unfold opp; simpl. assert (E := Hk (- theta)). rewrite Ropp_involutive in E.
    match goal with |- @eq _ ?x ?y => change (@eq R x y) end. rewrite E. ring. }
  apply (is_RInt_comp_opp (fun theta => - k * f theta)). rewrite Ropp_involutive, Ropp_0.
  replace (k * l) with (opp (- k * l)) by (unfold opp; simpl; ring).
  apply (is_RInt_swap (V := R_NormedModule)). apply (is_RInt_scal (V := R_NormedModule) f). exact H.
Qed.
Lemma power_consistent : consistent (power_slope C m) s s.
Proof.
  destruct half_exists as [l Hl]. unfold consistent. replace 0 with (-1 * l + l) by ring.
  apply from_half; [| exact Hl]. intros theta. rewrite !place_middle, sin_neg. replace (s * - sin theta) with (- (s * sin theta)) by ring.
  rewrite power_slope_odd. ring.
Qed.
Lemma power_is_load : is_load Es (power_slope C m) s s (Es * C * wallis (m + 1) * Rpower s (m + 1)).
Proof.
  assert (Hpi := PI_RGT_0). unfold is_load.
  replace (Es * C * wallis (m + 1) * Rpower s (m + 1)) with
    (1 * (Es / 2 * C * Rpower s (m + 1) * wallis (m + 1)) + Es / 2 * C * Rpower s (m + 1) * wallis (m + 1)) by field.
  apply from_half.
  - intros theta. rewrite !place_middle, sin_neg. replace (s * - sin theta) with (- (s * sin theta)) by ring.
    rewrite power_slope_odd. ring.
  - apply (is_RInt_ext (fun theta => scal (Es / 2 * C * Rpower s (m + 1)) (power (m + 1) (sin theta)))).
    + intros theta Ht. rewrite Rmin_left in Ht by lra. rewrite Rmax_right in Ht by lra. assert (P := sine_positive theta Ht).
      assert (0 < s * sin theta) by (apply Rmult_lt_0_compat; assumption).
      rewrite place_middle, power_slope_right, power_of_positive by assumption.
      rewrite <- Rpower_mult_distr by assumption. rewrite !Rpower_plus, !Rpower_1 by assumption.
      match goal with |- @eq _ ?x ?y => change (@eq R x y) end. unfold scal; simpl; unfold mult; simpl. ring.
    + apply (is_RInt_scal (V := R_NormedModule)). apply wallis_correct. lra.
Qed.
End Contact.

Let k := Es * C * wallis (m + 1).
Definition power_load s := Es * C * wallis (m + 1) * Rpower s (m + 1).
Definition power_load_1 s := Es * C * wallis (m + 1) * (m + 1) * Rpower s (m + 1 - 1).
Definition power_load_2 s := Es * C * wallis (m + 1) * (m + 1) * (m + 1 - 1) * Rpower s (m + 1 - 1 - 1).
Definition power_load_3 s := Es * C * wallis (m + 1) * (m + 1) * (m + 1 - 1) * (m + 1 - 1 - 1) * Rpower s (m + 1 - 1 - 1 - 1).

Lemma power_contact_at s : 0 < s -> is_contact_at Es (power_slope C m) power_load power_load_1 (fun s => s) s.
Proof.
  intros Hs. split; [lra | split; [apply power_consistent, Hs | split]].
  - apply (locally_near s s); [exact Hs |]. intros r Hr. apply power_is_load. lra.
  - apply derive_power, Hs.
Qed.
Theorem power_smooth_contact a : 0 < a -> is_smooth_contact Es (power_slope C m) a
  power_load power_load_1 power_load_2 power_load_3 (fun s => s) (fun _ => 1) (fun _ => 0).
Proof.
  intros Ha. exists (a / 2). split; [lra |]. intros s Hs.
  split; [apply power_contact_at; lra | split; [| split; [| split; [| split; [| split; [| split]]]]]].
  - apply derive_power. lra.
  - apply derive_power. lra.
  - apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply derive_power. lra.
  - auto_derive; trivial.
  - auto_derive; trivial.
  - apply continuous_const.
  - lra.
Qed.
Lemma power_the_load a : 0 < a -> is_the_load Es (power_slope C m) a a (power_load a).
Proof.
  intros Ha. apply (the_load _ _ 0); [exact power_slope_rises | exact Ha | lra | apply power_consistent, Ha | apply power_is_load, Ha].
Qed.

(* ---- The pressure ---- *)

Lemma power_integral a x : 0 < x < a -> is_improper_integral (fun s => Rpower s m / sqrt (s ^ 2 - x ^ 2)) x a
  (RInt (fun w => 2 * (Rpower (x + w ^ 2) m / sqrt (x + (x + w ^ 2)))) 0 (sqrt (a - x))).
Proof.
  intros Hx. apply improper_by_square; [lra | | |].
  - intros w Hw. replace ((x + w ^ 2) ^ 2 - x ^ 2) with (w ^ 2 * (x + (x + w ^ 2))) by ring.
    assert (0 < w ^ 2) by (apply pow_lt; lra). rewrite sqrt_mult by lra. rewrite sqrt_pow2 by lra.
    assert (0 < sqrt (x + (x + w ^ 2))) by (apply sqrt_lt_R0; lra). field. lra.
  - intros w _. assert (0 <= w ^ 2) by apply pow2_ge_0. assert (0 < x + w ^ 2) by lra.
    assert (0 < sqrt (x + (x + w ^ 2))) by (apply sqrt_lt_R0; lra).
    apply continuous_times; [apply continuous_const |]. apply continuous_quotient; [| | lra].
    + apply (continuous_comp (fun w => x + w ^ 2) (fun s => Rpower s m)).
      * apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
      * apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold Rpower. auto_derive. assumption.
    + apply (continuous_comp (fun w => x + (x + w ^ 2)) sqrt); [| apply continuous_sqrt].
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - intros s Hs. assert (0 < s ^ 2 - x ^ 2) by nra. assert (0 < sqrt (s ^ 2 - x ^ 2)) by (apply sqrt_lt_R0; assumption).
    apply continuous_quotient; [| | lra].
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold Rpower. auto_derive. lra.
    + apply (continuous_comp (fun s => s ^ 2 - x ^ 2) sqrt); [| apply continuous_sqrt].
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma improper_scaled (f h : R -> R) c x a l : (forall s, x < s < a -> h s = c * f s) -> x < a ->
  is_improper_integral f x a l -> is_improper_integral h x a (c * l).
Proof.
  intros E Hxa [Hex Hl].
  assert (I : forall e, x < e <= a -> is_RInt h e a (c * RInt f e a)).
  { intros e He. apply (is_RInt_ext (fun s => scal c (f s))).
    - intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra. symmetry. apply E. lra.
    - apply (is_RInt_scal (V := R_NormedModule) f). apply (@RInt_correct R_CompleteNormedModule), Hex, He. }
  split; [intros e He; eexists; apply I, He |].
  apply (filterlim_ext_loc (fun e => c * RInt f e a)).
  - exists (mkposreal (a - x) ltac:(lra)). intros e Hb Hxe.
    unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb. apply Rabs_def2 in Hb.
    symmetry. apply (is_RInt_unique (V := R_CompleteNormedModule)), I. lra.
  - refine (filterlim_comp _ _ _ (fun e => RInt f e a) (fun y => c * y) _ (locally l) _ Hl _).
    apply (filterlim_scal_r (K := R_AbsRing) (V := R_NormedModule) c l).
Qed.
Lemma power_is_pressure a x : 0 < x < a -> is_pressure Es (power_slope C m) a x (1 / PI * (Es * C * wallis (m + 1) * (m + 1)) *
  RInt (fun w => 2 * (Rpower (x + w ^ 2) m / sqrt (x + (x + w ^ 2)))) 0 (sqrt (a - x))).
Proof.
  intros Hx. exists power_load, power_load_1, (fun s => s). split; [intros s Hs; apply power_contact_at; lra |].
  apply (improper_scaled (fun s => Rpower s m / sqrt (s ^ 2 - x ^ 2))); [| lra | apply power_integral, Hx].
  intros s Hs. unfold power_load_1. replace ((s - x) * (x + s)) with (s ^ 2 - x ^ 2) by ring. replace (m + 1 - 1) with m by ring.
  unfold Rdiv. ring.
Qed.
Lemma power_the_pressure a x : 0 < x < a -> is_the_pressure Es (power_slope C m) a x (1 / PI * (Es * C * wallis (m + 1) * (m + 1)) *
  RInt (fun w => 2 * (Rpower (x + w ^ 2) m / sqrt (x + (x + w ^ 2)))) 0 (sqrt (a - x))).
Proof. intros Hx. apply (the_pressure _ _ 0); [exact power_slope_rises | lra | apply power_is_pressure, Hx]. Qed.
End PowerLaw.

Lemma wallis_positive q : 1 <= q -> 0 < wallis q.
Proof.
  intros H. assert (V := phi_value gauss_limit gamma_exists q H). cbv zeta beta in V. assert (P := sqrt_lt_R0 PI PI_RGT_0).
  destruct (Rle_lt_or_eq_dec 0 (wallis q) (wallis_nonnegative q ltac:(lra))) as [L | Z]; [exact L |].
  rewrite <- Z, Rmult_0_l in V. lra.
Qed.
(* One term, relative to the pressure. *)
Lemma power_relative_error Es C m a x n : 0 < Es -> 0 < C -> m = INR n -> 0 < x < a -> exists p0 r0 r1 r2,
  is_the_pressure Es (power_slope C m) a x p0 /\ is_the_right_series Es (power_slope C m) a r0 r1 r2 /\
  r0 * ((a - x) ^ 0 * sqrt (a - x)) / p0 =
  a ^ n * sqrt (2 * (a - x) / a) / RInt (fun w => 2 * ((x + w ^ 2) ^ n / sqrt (x + (x + w ^ 2)))) 0 (sqrt (a - x)).
Proof.
  intros HEs HC Hn Hx. assert (Hm : 0 <= m) by (rewrite Hn; apply pos_INR). assert (Hpi := PI_RGT_0).
  do 4 eexists. split; [exact (power_the_pressure Es C m HC Hm a x Hx) |]. split.
  { apply (the_right_series _ _ 0); [apply power_slope_rises; assumption | lra |]. exact (right_edge _ _ _ _ _ _ _ _ _ _ (power_smooth_contact Es C m Hm a ltac:(lra))). }
  assert (W := wallis_positive (m + 1) ltac:(lra)).
  rewrite (RInt_ext (fun w => 2 * (Rpower (x + w ^ 2) m / sqrt (x + (x + w ^ 2)))) (fun w => 2 * ((x + w ^ 2) ^ n / sqrt (x + (x + w ^ 2))))).
  2: { intros w _. rewrite Hn, Rpower_pow; [reflexivity |]. assert (0 <= w ^ 2) by apply pow2_ge_0. lra. }
  unfold c0, power_load_1. replace (m + 1 - 1) with m by ring. replace (Rpower a m) with (a ^ n) by (rewrite Hn, Rpower_pow by lra; reflexivity).
  set (I := RInt _ _ _). clearbody I. rewrite (sqrt_div_alt (2 * (a - x))), (sqrt_mult 2 (a - x)), root_of_twice by lra.
  assert (H2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra). assert (E2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (Ha : 0 < sqrt a) by (apply sqrt_lt_R0; lra). unfold Rdiv. rewrite !Rinv_mult.
  replace (a ^ n * (sqrt 2 * sqrt (a - x) * / sqrt a) * / I) with (a ^ n * ((sqrt 2 * sqrt 2) * / sqrt 2 * sqrt (a - x) * / sqrt a) * / I) by (field_simplify_eq; [reflexivity | lra] || (f_equal; f_equal; field; lra)).
  rewrite E2. simpl. generalize (/ I). intros J. field. repeat split; lra.
Qed.

(* ---- Identities ---- *)

Lemma power_minus a e n : 0 < a -> Rpower a (e - INR n) = Rpower a e / a ^ n.
Proof. intros H. unfold Rminus. rewrite Rpower_plus, Rpower_Ropp, Rpower_pow by exact H. reflexivity. Qed.
Lemma power_minus_half a e n : 0 < a -> Rpower a (e - (INR n + / 2)) = Rpower a e / (a ^ n * sqrt a).
Proof. intros H. unfold Rminus. rewrite Rpower_plus, Rpower_Ropp, Rpower_plus, Rpower_pow, Rpower_sqrt by exact H. reflexivity. Qed.

(* In the power a^m, the root r of a, sqrt 2 and sqrt pi, and by the value of the gamma function. *)
Ltac identity_of_power_law is_gamma_G G m a :=
  let Hpi := fresh "Hpi" in let Hp := fresh "Hp" in let Ha := fresh "Ha" in let E2 := fresh "E2" in let Ep := fresh "Ep" in let Ea := fresh "Ea" in
  let HG := fresh "HG" in let H2 := fresh "H2" in
  assert (Hpi := PI_RGT_0); assert (Hp := sqrt_lt_R0 PI Hpi); assert (Ha : 0 < a) by lra;
  unfold power_load, power_load_1, power_load_2, power_load_3, c0, c1, c2; cbv beta;
  rewrite ?(wallis_by_gamma G is_gamma_G m) by lra;
  assert (HG : 0 < G ((3 + m) / 2)) by (apply (gamma_positive G is_gamma_G); lra);
  replace (m + 1 - 1 - 1 - 1) with (m - INR 2) by (simpl; ring);
  replace (m + 1 - 1 - 1) with (m - INR 1) by (simpl; ring);
  replace (m + 1 - 1) with m by ring;
  replace (m - 1 / 2) with (m - (INR 0 + / 2)) by (simpl; field);
  replace (m - 3 / 2) with (m - (INR 1 + / 2)) by (simpl; field);
  replace (m - 5 / 2) with (m - (INR 2 + / 2)) by (simpl; field);
  rewrite ?(Rpower_plus m 1 a), ?(Rpower_1 a) by exact Ha;
  rewrite ?(power_minus_half a m 0), ?(power_minus_half a m 1), ?(power_minus_half a m 2), ?(power_minus a m 1), ?(power_minus a m 2) by exact Ha;
  replace (INR 1) with 1 by (simpl; ring); replace (INR 2) with 2 by (simpl; ring);
  rewrite ?power_3_2, ?power_5_2 by exact Ha;
  rewrite ?root_of_twice, ?root_of_2_over by exact Ha;
  assert (H2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra);
  assert (E2 : sqrt 2 ^ 2 = 2) by (apply pow2_sqrt; lra);
  assert (Ep : sqrt PI ^ 2 = PI) by (apply pow2_sqrt; lra);
  assert (Ea : a = sqrt a * sqrt a) by (symmetry; apply sqrt_sqrt; lra);
  assert (0 < sqrt a) by (apply sqrt_lt_R0; exact Ha);
  generalize dependent (G ((3 + m) / 2)); intros;
  try (match goal with |- context [RInt ?f ?l ?u] => generalize (RInt f l u); intros end);
  generalize (wallis (m + 1)) (Rpower a m); intros;
  let p := fresh "p" in let q := fresh "q" in let r := fresh "r" in
  set (q := sqrt 2) in *; set (p := sqrt PI) in *; set (r := sqrt a) in *; clearbody q p r;
  rewrite <- ?Ep; rewrite ?Ea; field_simplify_eq; [ring [E2] | repeat split; lra].
