(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Symmetric Unique Stick ClosedForm Limits LoadOfPressure Dilogarithm LogPressure ForwardPunches.
Open Scope R_scope.

(* The shape of the pressure of flat punches with rounded edges: it is continuous, grows from the middle to the
   transition, and falls in the outer half of the rounded part. *)

Lemma atanh_above z : 0 <= z < 1 -> z <= atanh z.
Proof.
  intros Hz. assert (H := from_zero (fun z => atanh z - z) (fun z => / (1 - z ^ 2) - 1) z ltac:(lra)). cbv beta in H.
  enough (0 <= atanh z - z) by lra. apply H.
  - rewrite atanh_0. ring.
  - intros c Hc. apply (is_derive_minus (V := R_NormedModule) atanh (fun z => z)); [| apply (is_derive_id (K := R_AbsRing))].
    unfold atanh. auto_derive; [| field; repeat split; nra]. repeat split; try lra. apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra].
  - intros c Hc. replace (/ (1 - c ^ 2) - 1) with (c ^ 2 / (1 - c ^ 2)) by (field; nra). apply Rmult_le_pos; [nra | apply Rlt_le, Rinv_0_lt_compat; nra].
Qed.
Lemma atan_below u : 0 < u -> atan u < u.
Proof.
  intros H. destruct (MVT_cor2 atan (fun c => / (1 + c²)) 0 u H) as (c & E & Hc).
  - intros c _. replace (/ (1 + c²)) with (/ (1 + c ^ 2)) by (f_equal; unfold Rsqr; ring). apply derivable_pt_lim_atan.
  - rewrite atan_0, !Rminus_0_r in E. rewrite E. assert (0 < c²) by (apply Rsqr_pos_lt; lra).
    assert (/ (1 + c²) < 1) by (rewrite <- Rinv_1 at 2; apply Rinv_lt_contravar; lra). nra.
Qed.
Lemma ln_below_half q : 1 <= q -> ln q <= (q - / q) / 2.
Proof.
  intros H. destruct (MVT_gen (fun q => (q - / q) / 2 - ln q) 1 q (fun q => (q - 1) ^ 2 / (2 * q ^ 2))) as (c & Hc & E).
  - intros c Hc. rewrite Rmin_left, Rmax_right in Hc by lra. auto_derive; [repeat split; lra | field; lra].
  - intros c Hc. rewrite Rmin_left, Rmax_right in Hc by lra. apply continuity_pt_filterlim, (ex_derive_continuous (V := R_NormedModule) (fun q => (q - / q) / 2 - ln q)). auto_derive. repeat split; lra.
  - rewrite Rmin_left, Rmax_right in Hc by lra. rewrite Rinv_1, ln_1 in E.
    assert (0 <= (c - 1) ^ 2 / (2 * c ^ 2)) by (apply Rdiv_le_0_compat; nra). nra.
Qed.

Section Shape.
Variables Es t R0 a : R.
Hypothesis HE : 0 < Es.
Hypothesis Ht : 0 < t < a.
Hypothesis HR : 0 < R0.
Let p := rounded_pressure Es t R0 a.
Let W := sqrt (a ^ 2 - t ^ 2).
Let A := atan (W / t).
Let r x := sqrt (a ^ 2 - x ^ 2).
Let half x := (log_pressure a a t x - log_pressure a a (- t) x) / 2.
Let W0 : 0 < W /\ W * W = a ^ 2 - t ^ 2.
Proof. split; [apply sqrt_lt_R0; nra | apply sqrt_sqrt; nra]. Qed.
Let r0 x : 0 <= x < a -> 0 < r x /\ r x * r x = a ^ 2 - x ^ 2.
Proof. intros H. split; [apply sqrt_lt_R0; nra | apply sqrt_sqrt; nra]. Qed.
Lemma rounded_pressure_continuous x : - a < x < a -> continuous p x.
Proof.
  intros Hx. apply continuous_times; [apply continuous_const |]. apply continuous_add.
  - apply continuous_quotient; [| apply continuous_const | lra]. apply continuous_sub.
    + apply (moment_continuous a a t); lra.
    + apply (continuous_ext (fun s => (s - - t) * log_pressure a a (- t) s)); [intros s; in_R; ring |]. apply (moment_continuous a a (- t)); lra.
  - apply continuous_times; [apply continuous_const |]. apply (continuous_comp (fun s => a ^ 2 - s ^ 2) sqrt); [| apply continuous_sqrt].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma rounded_pressure_derive x : 0 <= x < a -> x <> t -> is_derive p x (Es / (PI * R0) * (half x - A * x / r x)).
Proof.
  intros Hx N. assert (Hpi := PI_RGT_0). destruct (r0 x Hx) as [Hr _]. assert (Er : sqrt ((a - x) * (x + a)) = r x) by (unfold r; f_equal; ring).
  assert (D1 := log_pressure_derive a a t ltac:(lra) x ltac:(lra) N). assert (D2 := log_pressure_derive a a (- t) ltac:(lra) x ltac:(lra) ltac:(lra)).
  cbv beta zeta in D1, D2. rewrite Er in D1, D2. replace ((a - - t) * (- t + a)) with ((a - t) * (t + a)) in D2 by ring. set (T := sqrt ((a - t) * (t + a))) in *.
  assert (M1 : is_derive (fun s => (s - t) * log_pressure a a t s) x (1 * log_pressure a a t x + (x - t) * - (T / ((x - t) * r x)))).
  { apply (is_derive_mult (fun s => s - t) (log_pressure a a t)); [auto_derive; [trivial | ring] | exact D1 | intros; apply Rmult_comm]. }
  assert (M2 : is_derive (fun s => (s + t) * log_pressure a a (- t) s) x (1 * log_pressure a a (- t) x + (x + t) * - (T / ((x - - t) * r x)))).
  { apply (is_derive_mult (fun s => s + t) (log_pressure a a (- t))); [auto_derive; [trivial | ring] | exact D2 | intros; apply Rmult_comm]. }
  assert (M3 : is_derive r x (- x / r x)).
  { unfold r in *. auto_derive; change (a * (a * 1)) with (a ^ 2); change (x * (x * 1)) with (x ^ 2); change (a ^ 2 + - x ^ 2) with (a ^ 2 - x ^ 2); [nra | field; lra]. }
  assert (S := is_derive_scal _ x (Es / (PI * R0)) _ (is_derive_plus (V := R_NormedModule) _ _ x _ _
    (is_derive_scal _ x (/ 2) _ (is_derive_minus (V := R_NormedModule) _ _ x _ _ M1 M2)) (is_derive_scal r x A _ M3))).
  refine (is_derive_ext _ p x _ _ (eq_ind _ (fun v => is_derive _ x v) S _ _)).
  - intros s. unfold p, rounded_pressure, A, W, r, minus, plus, opp; simpl. in_R. field. repeat split; lra.
  - unfold minus, plus, opp; simpl. unfold half. in_R. field. repeat split; lra.
Qed.
(* half x = ln (Q) / 2, with Q of roots. *)
Let kernels x : - a < x < a -> 2 * half x = ln ((a ^ 2 - t * x + W * r x) * (x + t) / ((a ^ 2 + t * x + W * r x) * Rabs (x - t))) \/ x <= - t \/ x = t.
Proof.
  intros Hx. destruct (Rle_lt_dec x (- t)) as [L | L]; [right; left; exact L |]. destruct (Req_dec x t) as [E | N]; [right; right; exact E |]. left.
  assert (K : forall c, - a < c < a -> 2 * ln (kernel_root a a c x) = ln (2 * (a ^ 2 - c * x + sqrt (a ^ 2 - c ^ 2) * r x)) /\ 0 < a ^ 2 - c * x + sqrt (a ^ 2 - c ^ 2) * r x).
  { intros c Hc. assert (K0 := kernel_root_positive a a c Hc x ltac:(lra)).
    assert (S1 : sqrt ((a - x) * (c + a)) * sqrt ((a - x) * (c + a)) = (a - x) * (c + a)) by (apply sqrt_sqrt, Rmult_le_pos; lra).
    assert (S2 : sqrt ((x + a) * (a - c)) * sqrt ((x + a) * (a - c)) = (x + a) * (a - c)) by (apply sqrt_sqrt, Rmult_le_pos; lra).
    assert (S3 : sqrt ((a - x) * (c + a)) * sqrt ((x + a) * (a - c)) = sqrt (a ^ 2 - c ^ 2) * r x).
    { unfold r. rewrite <- !sqrt_mult by (try apply Rmult_le_pos; nra). f_equal. ring. }
    assert (E2 : kernel_root a a c x * kernel_root a a c x = 2 * (a ^ 2 - c * x + sqrt (a ^ 2 - c ^ 2) * r x)) by (unfold kernel_root in *; nra).
    assert (0 < kernel_root a a c x * kernel_root a a c x) by (apply Rmult_lt_0_compat; exact K0).
    split; [| lra]. rewrite <- E2, ln_mult by exact K0. ring. }
  destruct (K t ltac:(lra)) as [K1 P1]. destruct (K (- t) ltac:(lra)) as [K2 P2]. replace ((- t) ^ 2) with (t ^ 2) in K2, P2 by ring. fold W in K1, P1, K2, P2.
  replace (a ^ 2 - - t * x + W * r x) with (a ^ 2 + t * x + W * r x) in K2, P2 by ring.
  assert (N1 : 0 < Rabs (x - t)) by (apply Rabs_pos_lt; lra).
  unfold half, log_pressure. rewrite K1, K2. rewrite (Rabs_pos_eq (x - - t)) by lra. replace (x - - t) with (x + t) by ring.
  unfold Rdiv. rewrite (ln_mult ((a ^ 2 - t * x + W * r x) * (x + t))), ln_Rinv, (ln_mult (a ^ 2 - t * x + W * r x)), (ln_mult (a ^ 2 + t * x + W * r x)), !(ln_mult 2)
    by (try apply Rinv_0_lt_compat; try apply Rmult_lt_0_compat; lra). field.
Qed.
Let ratio x : 0 <= x < a -> (a ^ 2 - t * x + W * r x) * ((x + t) * (t * r x - x * W)) = (a ^ 2 + t * x + W * r x) * ((t - x) * (t * r x + x * W)).
Proof. intros Hx. destruct W0 as [_ EW]. destruct (r0 x Hx) as [_ Er]. ring [EW Er]. Qed.
Let slope_grows x : 0 < x < t -> A * x / r x < half x.
Proof.
  intros Hx. destruct W0 as [HW EW]. destruct (r0 x ltac:(lra)) as [Hr Er]. set (z := x * W / (t * r x)).
  assert (Sq : (x * W) * (x * W) < (t * r x) * (t * r x)).
  { replace ((x * W) * (x * W)) with (x ^ 2 * (W * W)) by ring. replace ((t * r x) * (t * r x)) with (t ^ 2 * (r x * r x)) by ring. rewrite EW, Er.
    assert (S : 0 < a ^ 2 * (t ^ 2 - x ^ 2)) by (apply Rmult_lt_0_compat; nra). nra. }
  assert (P1 : 0 < x * W) by (apply Rmult_lt_0_compat; lra). assert (P2 : 0 < t * r x) by (apply Rmult_lt_0_compat; lra). assert (P3 : x * W < t * r x) by nra.
  assert (Z : 0 <= z < 1).
  { unfold z. split; [apply Rlt_le, Rdiv_lt_0_compat; assumption |]. apply (Rmult_lt_reg_r (t * r x)); [exact P2 |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (H : half x = atanh z).
  { destruct (kernels x ltac:(lra)) as [K | [K | K]]; [| lra | lra]. unfold atanh. replace (half x) with (/ 2 * (2 * half x)) by field. rewrite K. do 2 f_equal.
    rewrite Rabs_left by lra. replace (- (x - t)) with (t - x) by ring. assert (0 < W * r x) by (apply Rmult_lt_0_compat; assumption).
    assert (P4 : 0 < a ^ 2 + t * x + W * r x) by nra. unfold z. replace ((1 + x * W / (t * r x)) / (1 - x * W / (t * r x))) with ((t * r x + x * W) / (t * r x - x * W)) by (field; lra).
    assert (R := ratio x ltac:(lra)). apply (Rmult_eq_reg_r ((a ^ 2 + t * x + W * r x) * (t - x) * (t * r x - x * W))).
    - transitivity ((a ^ 2 - t * x + W * r x) * ((x + t) * (t * r x - x * W))); [field; lra | rewrite R; field; lra].
    - apply Rgt_not_eq, Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra | lra]. }
  rewrite H. assert (B := atanh_above z Z). assert (C := atan_below (W / t) ltac:(apply Rdiv_lt_0_compat; lra)). fold A in C.
  apply Rlt_le_trans with z; [| exact B]. unfold z. replace (x * W / (t * r x)) with (W / t * x / r x) by (field; lra).
  unfold Rdiv. apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat, Hr |]. apply Rmult_lt_compat_r; [lra | exact C].
Qed.
Let angle_above : 2 * (a - t) <= a * (A * A).
Proof.
  destruct W0 as [HW EW]. assert (A0 : 0 < A) by (unfold A; rewrite <- atan_0; apply atan_increasing, Rdiv_lt_0_compat; lra).
  assert (C : cos A = t / a).
  { unfold A. rewrite cos_atan. replace (1 + (W / t)²) with ((a / t) ^ 2) by (unfold Rsqr; replace (W / t * (W / t)) with (W * W / (t * t)) by (field; lra); rewrite EW; field; lra).
    rewrite sqrt_pow2 by (apply Rlt_le, Rdiv_lt_0_compat; lra). field. lra. }
  assert (S : cos A = 1 - 2 * (sin (A / 2) * sin (A / 2))).
  { replace A with (2 * (A / 2)) at 1 by field. rewrite cos_2a_sin. ring. }
  assert (B := atan_bound (W / t)). fold A in B. assert (Hpi := PI_RGT_0).
  assert (S0 : 0 < sin (A / 2)) by (apply sin_gt_0; lra). assert (S1 : sin (A / 2) < A / 2) by (apply sin_lt_x; lra).
  assert (E : a * cos A = t) by (rewrite C; field; lra). rewrite S in E. assert (sin (A / 2) * sin (A / 2) <= A / 2 * (A / 2)) by nra. nra.
Qed.
Let slope_falls x : (t + a) / 2 <= x < a -> half x < A * x / r x.
Proof.
  intros Hx. destruct W0 as [HW EW]. destruct (r0 x ltac:(lra)) as [Hr Er]. assert (D0 : 0 < x ^ 2 - t ^ 2) by nra. assert (Hd := sqrt_lt_R0 _ D0).
  assert (Ed : sqrt (x ^ 2 - t ^ 2) * sqrt (x ^ 2 - t ^ 2) = x ^ 2 - t ^ 2) by (apply sqrt_sqrt; lra). set (d := sqrt (x ^ 2 - t ^ 2)) in *.
  assert (P1 : 0 < x * W) by (apply Rmult_lt_0_compat; lra). assert (P2 : 0 < t * r x) by (apply Rmult_lt_0_compat; lra).
  assert (Prod : (x * W - t * r x) * (x * W + t * r x) = (a * d) * (a * d)) by (ring_simplify; replace (W ^ 2) with (W * W) by ring; replace (r x ^ 2) with (r x * r x) by ring; replace (d ^ 2) with (d * d) by ring; rewrite EW, Er, Ed; ring).
  assert (P3 : 0 < a * d) by (apply Rmult_lt_0_compat; lra). assert (P4 : 0 < x * W - t * r x) by nra.
  set (q := (x * W + t * r x) / (a * d)).
  assert (Iq : / q = (x * W - t * r x) / (a * d)).
  { apply (Rmult_eq_reg_r ((x * W + t * r x) * (a * d))); [| apply Rgt_not_eq, Rmult_lt_0_compat; lra].
    transitivity ((a * d) * (a * d)); [unfold q; field; lra | rewrite <- Prod; field; lra]. }
  assert (Q1 : 1 <= q).
  { assert (Q0 : 0 < q) by (apply Rdiv_lt_0_compat; lra). assert (Q2 : / q < q) by (rewrite Iq; unfold q, Rdiv; apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat, P3 | lra]).
    destruct (Rle_lt_dec 1 q) as [L | L]; [exact L | exfalso]. assert (1 < / q) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra). lra. }
  assert (H : half x = ln q).
  { destruct (kernels x ltac:(lra)) as [K | [K | K]]; [| lra | lra]. enough (2 * half x = ln (q * q)) by (rewrite ln_mult in * by lra; lra). rewrite K. f_equal.
    rewrite Rabs_pos_eq by lra. assert (0 < W * r x) by (apply Rmult_lt_0_compat; assumption). assert (P5 : 0 < a ^ 2 + t * x + W * r x) by nra.
    assert (R := ratio x ltac:(lra)).
    assert (QQ : q * q = (x * W + t * r x) / (x * W - t * r x)).
    { apply (Rmult_eq_reg_r ((x * W - t * r x) * ((a * d) * (a * d)))); [| apply Rgt_not_eq; repeat apply Rmult_lt_0_compat; lra].
      transitivity ((x * W + t * r x) * (x * W + t * r x) * (x * W - t * r x)); [unfold q; field; lra | rewrite <- Prod; field; lra]. }
    rewrite QQ. apply (Rmult_eq_reg_r ((a ^ 2 + t * x + W * r x) * (x - t) * (x * W - t * r x))).
    - transitivity (- ((a ^ 2 - t * x + W * r x) * ((x + t) * (t * r x - x * W)))); [field; lra | rewrite R; field; lra].
    - apply Rgt_not_eq, Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra | lra]. }
  rewrite H. apply Rle_lt_trans with ((q - / q) / 2); [apply ln_below_half, Q1 |]. rewrite Iq.
  replace ((q - (x * W - t * r x) / (a * d)) / 2) with (t * r x / (a * d)) by (unfold q; field; lra).
  assert (A0 : 0 < A) by (unfold A; rewrite <- atan_0; apply atan_increasing, Rdiv_lt_0_compat; lra).
  assert (Main : (t * (r x * r x)) * (t * (r x * r x)) < (A * x * (a * d)) * (A * x * (a * d))).
  { replace ((A * x * (a * d)) * (A * x * (a * d))) with ((a * (A * A)) * (a * (x ^ 2 * (d * d)))) by ring. rewrite Er, Ed.
    assert (B1 : a ^ 2 - x ^ 2 <= (a - t) * (3 * a + t) / 4) by nra. assert (B0 : 0 < a ^ 2 - x ^ 2) by nra.
    assert (B2 : (a + t) ^ 2 / 4 <= x ^ 2) by nra. assert (B3 : (a - t) * (a + 3 * t) / 4 <= x ^ 2 - t ^ 2) by nra.
    assert (U : t * (a ^ 2 - x ^ 2) * (t * (a ^ 2 - x ^ 2)) <= t ^ 2 * ((a - t) * (3 * a + t) / 4) ^ 2).
    { replace (t * (a ^ 2 - x ^ 2) * (t * (a ^ 2 - x ^ 2))) with (t ^ 2 * (a ^ 2 - x ^ 2) ^ 2) by ring. apply Rmult_le_compat_l; [nra | apply pow_incr; lra]. }
    assert (L1 : (a + t) ^ 2 / 4 * ((a - t) * (a + 3 * t) / 4) <= x ^ 2 * (x ^ 2 - t ^ 2)) by (apply Rmult_le_compat; nra).
    assert (L2 : 2 * (a - t) * (a * ((a + t) ^ 2 / 4 * ((a - t) * (a + 3 * t) / 4))) <= a * (A * A) * (a * (x ^ 2 * (x ^ 2 - t ^ 2)))).
    { apply Rmult_le_compat; [lra | | exact angle_above | apply Rmult_le_compat_l; [lra | exact L1]].
      apply Rmult_le_pos; [lra |]. apply Rmult_le_pos; [nra |]. apply Rdiv_le_0_compat; [apply Rmult_le_pos; lra | lra]. }
    eapply Rle_lt_trans; [exact U |]. eapply Rlt_le_trans; [| exact L2].
    assert (Poly : 0 < 2 * a ^ 4 + 10 * a ^ 3 * t + 5 * a ^ 2 * t ^ 2 - t ^ 4).
    { assert (0 < a ^ 2) by nra. assert (t ^ 2 < a ^ 2) by nra. assert (0 < a ^ 3 * t) by (apply Rmult_lt_0_compat; [apply pow_lt; lra | lra]). assert (0 < a ^ 4) by (apply pow_lt; lra). nra. }
    enough (0 < 2 * (a - t) * (a * ((a + t) ^ 2 / 4 * ((a - t) * (a + 3 * t) / 4))) - t ^ 2 * ((a - t) * (3 * a + t) / 4) ^ 2) by lra.
    replace (2 * (a - t) * (a * ((a + t) ^ 2 / 4 * ((a - t) * (a + 3 * t) / 4))) - t ^ 2 * ((a - t) * (3 * a + t) / 4) ^ 2)
      with ((a - t) ^ 2 / 16 * (2 * a ^ 4 + 10 * a ^ 3 * t + 5 * a ^ 2 * t ^ 2 - t ^ 4)) by field.
    apply Rmult_lt_0_compat; [| exact Poly]. apply Rdiv_lt_0_compat; [nra | lra]. }
  assert (M0 : t * (r x * r x) < A * x * (a * d)).
  { assert (0 < A * x * (a * d)) by (repeat apply Rmult_lt_0_compat; lra). assert (0 < t * (r x * r x)) by (repeat apply Rmult_lt_0_compat; lra). nra. }
  apply (Rmult_lt_reg_r (a * d * r x)); [apply Rmult_lt_0_compat; assumption |].
  replace (t * r x / (a * d) * (a * d * r x)) with (t * (r x * r x)) by (field; lra). replace (A * x / r x * (a * d * r x)) with (A * x * (a * d)) by (field; lra). exact M0.
Qed.
Let k0 : 0 < Es / (PI * R0).
Proof. apply Rdiv_lt_0_compat; [exact HE | apply Rmult_lt_0_compat; [exact PI_RGT_0 | exact HR]]. Qed.
Lemma rounded_pressure_grows x z : 0 <= x < z -> z <= t -> p x < p z.
Proof.
  intros Hx Hz. destruct (MVT_gen p x z (fun x => Es / (PI * R0) * (half x - A * x / r x))) as (c & Hc & E).
  - intros c Hc. rewrite Rmin_left, Rmax_right in Hc by lra. apply rounded_pressure_derive; lra.
  - intros c Hc. rewrite Rmin_left, Rmax_right in Hc by lra. apply continuity_pt_filterlim, rounded_pressure_continuous. lra.
  - (* The mean value may be at an end; a middle place makes the growth strict. *)
    assert (Le : forall y w, 0 < y < w -> w < t -> p y < p w).
    { intros y w Hy Hw. destruct (MVT_gen p y w (fun x => Es / (PI * R0) * (half x - A * x / r x))) as (e & He & Ee).
      - intros e He. rewrite Rmin_left, Rmax_right in He by lra. apply rounded_pressure_derive; lra.
      - intros e He. rewrite Rmin_left, Rmax_right in He by lra. apply continuity_pt_filterlim, rounded_pressure_continuous. lra.
      - rewrite Rmin_left, Rmax_right in He by lra. assert (G := slope_grows e ltac:(lra)). assert (0 < Es / (PI * R0) * (half e - A * e / r e)) by (apply Rmult_lt_0_compat; [exact k0 | lra]). nra. }
    clear c Hc E. set (y := x + (z - x) / 4). set (w := x + (z - x) / 2). set (v := x + 3 * (z - x) / 4).
    assert (Ends : forall c e, x <= c -> c < e -> e <= z -> p c <= p e).
    { intros c e Hc He Hez. destruct (MVT_gen p c e (fun x => if Req_EM_T x t then 0 else if Req_EM_T x 0 then 0 else Es / (PI * R0) * (half x - A * x / r x))) as (f & Hf & Ef).
      - intros f Hf. rewrite Rmin_left, Rmax_right in Hf by lra. destruct (Req_EM_T f t); [lra |]. destruct (Req_EM_T f 0); [lra |]. apply rounded_pressure_derive; lra.
      - intros f Hf. rewrite Rmin_left, Rmax_right in Hf by lra. apply continuity_pt_filterlim, rounded_pressure_continuous. lra.
      - rewrite Rmin_left, Rmax_right in Hf by lra. revert Ef. destruct (Req_EM_T f t); [lra |]. destruct (Req_EM_T f 0); [lra |]. intros Ef.
        assert (G := slope_grows f ltac:(lra)). assert (0 < Es / (PI * R0) * (half f - A * f / r f)) by (apply Rmult_lt_0_compat; [exact k0 | lra]). nra. }
    assert (H1 := Ends x y ltac:(lra) ltac:(unfold y; lra) ltac:(unfold y; lra)). assert (H2 := Le y w ltac:(unfold y, w; lra) ltac:(unfold w; lra)).
    assert (H3 := Ends w z ltac:(unfold w; lra) ltac:(unfold w; lra) ltac:(lra)). lra.
Qed.
Lemma rounded_pressure_falls x z : (t + a) / 2 <= x < z -> z < a -> p z < p x.
Proof.
  intros Hx Hz. destruct (MVT_gen p x z (fun x => Es / (PI * R0) * (half x - A * x / r x))) as (c & Hc & E).
  - intros c Hc. rewrite Rmin_left, Rmax_right in Hc by lra. apply rounded_pressure_derive; lra.
  - intros c Hc. rewrite Rmin_left, Rmax_right in Hc by lra. apply continuity_pt_filterlim, rounded_pressure_continuous. lra.
  - rewrite Rmin_left, Rmax_right in Hc by lra. assert (G := slope_falls c ltac:(lra)).
    assert (0 < Es / (PI * R0) * (A * c / r c - half c)) by (apply Rmult_lt_0_compat; [exact k0 | lra]). nra.
Qed.
End Shape.

Section Statements.
Variables Es t R0 a : R.
Hypothesis form : 0 < Es /\ 0 < t < a /\ 0 < R0.
Let g1 := Symmetric.slope (rounded t R0).
Theorem continuous_everywhere : exists p, are_the_pressures Es g1 a a p /\ (forall x, - a < x < a -> continuous p x) /\
  filterlim (fun s => (p (t + s) - p (t - s)) / p t) (at_right 0) (locally 0).
Proof.
  exists (rounded_pressure Es t R0 a). assert (C := rounded_pressure_continuous Es t R0 a ltac:(lra)).
  split; [apply rounded_pressures; lra | split; [exact C |]].
  set (p := rounded_pressure Es t R0 a) in *. intros P HP. apply filter_le_within.
  assert (K : continuous (fun s => (p (t + s) - p (t - s)) * / p t) 0).
  { apply continuous_times; [| apply continuous_const]. apply continuous_sub.
    - apply (continuous_comp (fun s => t + s) p); [apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; trivial | apply C; lra].
    - apply (continuous_comp (fun s => t - s) p); [apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; trivial | apply C; lra]. }
  apply K. replace ((p (t + 0) - p (t - 0)) * / p t) with 0 by (rewrite Rplus_0_r, Rminus_0_r; ring). exact HP.
Qed.
Theorem grows_to_the_transition : exists p, are_the_pressures Es g1 a a p /\ (forall x, - a < x < a -> continuous p x) /\
  forall x z, 0 <= x < z -> z <= t -> p x < p z.
Proof.
  exists (rounded_pressure Es t R0 a). split; [apply rounded_pressures; lra | split; [apply rounded_pressure_continuous; lra |]].
  apply rounded_pressure_grows; lra.
Qed.
Theorem falls_to_the_edge : exists p, are_the_pressures Es g1 a a p /\
  forall x z, (t + a) / 2 <= x < z -> z < a -> p z < p x.
Proof. exists (rounded_pressure Es t R0 a). split; [apply rounded_pressures; lra | apply rounded_pressure_falls; lra]. Qed.
End Statements.
