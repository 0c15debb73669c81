(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Shear.
Open Scope R_scope.

(* ---- Any number of terms of the shear traction at an edge, and their signs ---- *)

Fixpoint polynomial (s : nat -> R) (n : nat) (u : R) : R :=
  match n with O => s O | S k => polynomial s k u + s (S k) * u ^ S k end.
(* q(a - u) = (s_0 + s_1 u + ... + s_n u^n) / sqrt(u) + O(u^(n + 1/2)). *)
Definition right_terms (q : R -> R) (a : R) (s : nat -> R) (n : nat) : Prop :=
  exists C d, 0 < d /\ forall u, 0 < u < d -> Rabs (sqrt u * q (a - u) - polynomial s n u) <= C * u ^ S n.
Definition are_the_right_terms (q : R -> R) (a : R) (s : nat -> R) (n : nat) : Prop :=
  right_terms q a s n /\ forall v, right_terms q a v n -> forall k, (k <= n)%nat -> v k = s k.
Definition are_the_left_terms (q : R -> R) (b : R) (s : nat -> R) (n : nat) : Prop :=
  are_the_right_terms (fun x => q (- x)) b s n.

Lemma polynomial_continuous s n u : continuous (polynomial s n) u.
Proof.
  induction n as [| n IH]; [apply continuous_const |].
  change (continuous (fun u => polynomial s n u + s (S n) * u ^ S n) u). apply continuous_add; [exact IH |].
  apply continuous_times; [apply continuous_const |]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma polynomial_0 s n : polynomial s n 0 = s O.
Proof. induction n as [| n IH]; [reflexivity |]. change (polynomial s n 0 + s (S n) * 0 ^ S n = s O). rewrite IH, pow_i by lia. ring. Qed.
Lemma polynomial_first s n u : polynomial s (S n) u = s O + u * polynomial (fun k => s (S k)) n u.
Proof.
  induction n as [| n IH]; [simpl; ring |].
  change (polynomial s (S n) u + s (S (S n)) * u ^ S (S n) = s O + u * (polynomial (fun k => s (S k)) n u + s (S (S n)) * u ^ S n)).
  rewrite IH. simpl. ring.
Qed.
Lemma first_zero s n C d : 0 < d -> (forall u, 0 < u < d -> Rabs (polynomial s n u) <= C * u ^ S n) -> s O = 0.
Proof.
  intros Hd H. rewrite <- (polynomial_0 s n).
  apply (filterlim_locally_unique (V := R_NormedModule) (F := at_right 0) (polynomial s n)).
  - intros P HP. apply filter_le_within. exact (polynomial_continuous s n 0 P HP).
  - intros P [e He]. set (B := Rabs C + 1). assert (HB : 0 < B) by (unfold B; generalize (Rabs_pos C); lra).
    set (m := Rmin (Rmin d 1) (e / B)).
    assert (Hm : 0 < m) by (unfold m; repeat apply Rmin_pos; try lra; apply Rdiv_lt_0_compat; [apply cond_pos | exact HB]).
    exists (mkposreal m Hm). intros u Hb Hu. unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb.
    apply Rabs_def2 in Hb. assert (M : m <= d /\ m <= 1 /\ m <= e / B).
    { unfold m. generalize (Rmin_l (Rmin d 1) (e / B)) (Rmin_r (Rmin d 1) (e / B)) (Rmin_l d 1) (Rmin_r d 1). lra. }
    apply He. unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl. rewrite Ropp_0, Rplus_0_r.
    apply (Rle_lt_trans _ _ _ (H u ltac:(lra))). assert (U : 0 < u ^ S n <= u).
    { split; [apply pow_lt; lra |]. change (u ^ S n) with (u * u ^ n).
      assert (u ^ n <= 1) by (rewrite <- (pow1 n); apply pow_incr; lra). nra. }
    apply Rle_lt_trans with (Rabs C * u); [generalize (Rle_abs C) (Rabs_pos C); nra |].
    apply Rlt_le_trans with (B * u); [unfold B; nra |].
    apply Rle_trans with (B * (e / B)); [apply Rmult_le_compat_l; lra | right; field; lra].
Qed.
Lemma all_zero n : forall s C d, 0 < d -> (forall u, 0 < u < d -> Rabs (polynomial s n u) <= C * u ^ S n) ->
  forall k, (k <= n)%nat -> s k = 0.
Proof.
  induction n as [| n IH]; intros s C d Hd H k Hk.
  - replace k with O by lia. exact (first_zero s 0 C d Hd H).
  - assert (Z := first_zero s (S n) C d Hd H). destruct k as [| k]; [exact Z |].
    apply (IH (fun k => s (S k)) C d Hd); [| lia]. intros u Hu. specialize (H u Hu).
    rewrite polynomial_first, Z, Rplus_0_l, Rabs_mult, (Rabs_pos_eq u) in H by lra.
    apply (Rmult_le_reg_l u); [lra |]. simpl in *. lra.
Qed.
Lemma polynomial_minus s v n u : polynomial s n u - polynomial v n u = polynomial (fun k => s k - v k) n u.
Proof.
  induction n as [| n IH]; [reflexivity |].
  change (polynomial s n u + s (S n) * u ^ S n - (polynomial v n u + v (S n) * u ^ S n) = polynomial (fun k => s k - v k) n u + (s (S n) - v (S n)) * u ^ S n).
  rewrite <- IH. ring.
Qed.
Lemma the_right_terms q a s n : right_terms q a s n -> are_the_right_terms q a s n.
Proof.
  intros H. split; [exact H |]. intros v (D & e & He & Hv) k Hk. destruct H as (C & d & Hd & Hs).
  apply Rminus_diag_uniq. apply (all_zero n (fun k => v k - s k) (C + D) (Rmin d e)); [apply Rmin_pos; assumption | | exact Hk].
  intros u Hu. generalize (Rmin_l d e) (Rmin_r d e). intros. rewrite <- polynomial_minus.
  replace (polynomial v n u - polynomial s n u) with ((sqrt u * q (a - u) - polynomial s n u) + - (sqrt u * q (a - u) - polynomial v n u)) by ring.
  apply (Rle_trans _ _ _ (Rabs_triang _ _)). rewrite Rabs_Ropp, Rmult_plus_distr_r.
  apply Rplus_le_compat; [apply Hs | apply Hv]; lra.
Qed.

(* The coefficients of (1 - z)^(-1/2). *)
Fixpoint root_coefficient (n : nat) : R :=
  match n with O => 1 | S k => root_coefficient k * ((2 * INR k + 1) / (2 * INR k + 2)) end.
Notation c := root_coefficient.
Lemma c_positive n : 0 < c n.
Proof.
  induction n as [| n IH]; [simpl; lra |]. change (0 < c n * ((2 * INR n + 1) / (2 * INR n + 2))). assert (P := pos_INR n).
  apply Rmult_lt_0_compat; [exact IH | apply Rdiv_lt_0_compat; lra].
Qed.
Lemma c_decreases n : c (S n) < c n.
Proof.
  change (c n * ((2 * INR n + 1) / (2 * INR n + 2)) < c n). assert (P := pos_INR n). assert (Q := c_positive n).
  replace (c n * ((2 * INR n + 1) / (2 * INR n + 2))) with (c n - c n / (2 * INR n + 2)) by (field; lra).
  assert (0 < c n / (2 * INR n + 2)) by (apply Rdiv_lt_0_compat; lra). lra.
Qed.
Fixpoint slope_of (n : nat) (z : R) : R := match n with O => 0 | S k => slope_of k z + c (S k) * (INR (S k) * z ^ k) end.
Lemma slope_of_derive n z : is_derive (polynomial c n) z (slope_of n z).
Proof.
  induction n as [| n IH]; [change (is_derive (fun _ : R => 1) z 0); auto_derive; trivial |].
  change (is_derive (fun z => polynomial c n z + c (S n) * z ^ S n) z (slope_of n z + c (S n) * (INR (S n) * z ^ n))).
  apply (is_derive_plus (V := R_NormedModule) (polynomial c n)); [exact IH |].
  apply (is_derive_scal (fun z => z ^ S n)). auto_derive; [trivial |]. rewrite S_INR. simpl. destruct n; simpl; ring.
Qed.
Lemma slope_equation n z : 2 * (1 - z) * slope_of n z - polynomial c n z = - ((2 * INR n + 1) * c n * z ^ n).
Proof.
  induction n as [| n IH]; [simpl; ring |].
  change (2 * (1 - z) * (slope_of n z + c (S n) * (INR (S n) * z ^ n)) - (polynomial c n z + c (S n) * z ^ S n) = - ((2 * INR (S n) + 1) * c (S n) * z ^ S n)).
  assert (P := pos_INR n). assert (E : c n = c (S n) * ((2 * INR n + 2) / (2 * INR n + 1))).
  { change (c n = c n * ((2 * INR n + 1) / (2 * INR n + 2)) * ((2 * INR n + 2) / (2 * INR n + 1))). field. lra. }
  replace (2 * (1 - z) * (slope_of n z + c (S n) * (INR (S n) * z ^ n)) - (polynomial c n z + c (S n) * z ^ S n))
    with ((2 * (1 - z) * slope_of n z - polynomial c n z) + c (S n) * (2 * (1 - z) * INR (S n) * z ^ n - z ^ S n)) by ring.
  rewrite IH, E, S_INR. simpl. field. lra.
Qed.
Lemma root_series n z : 0 < z <= 1 / 2 -> 0 <= / sqrt (1 - z) - polynomial c n z <= 2 * ((2 * INR n + 1) * c n) * z ^ S n.
Proof.
  intros Hz. assert (P := pos_INR n). assert (Q := c_positive n).
  destruct (MVT_cor2 (fun z => 1 - polynomial c n z * sqrt (1 - z)) (fun z => (2 * INR n + 1) * c n * z ^ n / (2 * sqrt (1 - z))) 0 z ltac:(lra)) as (y & E & Hy).
  { intros y Hy. apply is_derive_Reals. assert (R0 : 0 < sqrt (1 - y)) by (apply sqrt_lt_R0; lra).
    assert (R1 : sqrt (1 - y) * sqrt (1 - y) = 1 - y) by (apply sqrt_sqrt; lra).
    assert (D := slope_of_derive n y). auto_derive.
    - repeat split; try lra. eexists. exact D.
    - change (1 + - y) with (1 - y). replace (Derive (fun x => polynomial c n x) y) with (slope_of n y) by (symmetry; apply is_derive_unique, D).
      assert (S := slope_equation n y). rewrite <- R1 in S. set (r := sqrt (1 - y)) in *. clearbody r.
      assert (T : (2 * INR n + 1) * c n * y ^ n = - (2 * (r * r) * slope_of n y - polynomial c n y)) by (rewrite S; ring).
      rewrite T. field. lra. }
  rewrite polynomial_0, Rminus_0_r, sqrt_1 in E. change (c 0) with 1 in E.
  assert (S0 : 0 < sqrt (1 - z)) by (apply sqrt_lt_R0; lra). assert (Y0 : 0 < sqrt (1 - y)) by (apply sqrt_lt_R0; lra).
  assert (Sq : sqrt (1 - z) * sqrt (1 - z) = 1 - z) by (apply sqrt_sqrt; lra). assert (Yq : sqrt (1 - y) * sqrt (1 - y) = 1 - y) by (apply sqrt_sqrt; lra).
  assert (S1 : 1 / 2 <= sqrt (1 - z)) by nra. assert (Y1 : 1 / 2 <= sqrt (1 - y)) by nra.
  assert (Yn : 0 <= y ^ n <= z ^ n) by (split; [apply pow_le; lra | apply pow_incr; lra]).
  set (A := (2 * INR n + 1) * c n) in *. assert (HA : 0 < A) by (unfold A; apply Rmult_lt_0_compat; lra).
  assert (F : 0 <= 1 - polynomial c n z * sqrt (1 - z) <= A * z ^ S n).
  { replace (1 - polynomial c n z * sqrt (1 - z)) with (A * y ^ n / (2 * sqrt (1 - y)) * z) by (transitivity (A * y ^ n / (2 * sqrt (1 - y)) * (z - 0)); [ring | rewrite <- E; ring]).
    assert (I : 0 < / (2 * sqrt (1 - y)) <= 1).
    { split; [apply Rinv_0_lt_compat; lra |]. apply (Rmult_le_reg_r (2 * sqrt (1 - y))); [lra |]. rewrite Rinv_l by lra. lra. }
    assert (B : 0 <= A * y ^ n <= A * z ^ n) by (split; [apply Rmult_le_pos; lra | apply Rmult_le_compat_l; lra]). unfold Rdiv. simpl. split.
    - apply Rmult_le_pos; [apply Rmult_le_pos; lra | lra].
    - replace (A * (z * z ^ n)) with (A * z ^ n * z) by ring. apply Rmult_le_compat_r; [lra |]. nra. }
  replace (/ sqrt (1 - z) - polynomial c n z) with ((1 - polynomial c n z * sqrt (1 - z)) * / sqrt (1 - z)) by (field; lra).
  assert (I : 0 < / sqrt (1 - z) <= 2).
  { split; [apply Rinv_0_lt_compat; lra |]. apply (Rmult_le_reg_r (sqrt (1 - z))); [lra |]. rewrite Rinv_l by lra. lra. }
  assert (0 <= A * z ^ S n) by lra. split; [apply Rmult_le_pos; lra |]. nra.
Qed.
Lemma scaled_polynomial f v D n u : 0 < D -> polynomial (fun k => f * v k / D ^ k) n u = f * polynomial v n (u / D).
Proof.
  intros HD. induction n as [| n IH]; [simpl; field |].
  change (polynomial (fun k => f * v k / D ^ k) n u + f * v (S n) / D ^ S n * u ^ S n = f * (polynomial v n (u / D) + v (S n) * (u / D) ^ S n)).
  assert (0 < D ^ S n) by (apply pow_lt, HD). rewrite IH. unfold Rdiv. rewrite (Rpow_mult_distr u), pow_inv.
  set (p := D ^ S n) in *. set (y := u ^ S n). field. lra.
Qed.

Section Terms.
Variables D f : R.
Hypothesis HD : 0 < D.
Lemma share_of_half u : 0 < u < D / 2 -> 0 < u / D <= 1 / 2.
Proof.
  intros Hu. split; [apply Rdiv_lt_0_compat; lra |]. apply (Rmult_le_reg_r D); [exact HD |]. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
Lemma force_terms (q : R -> R) a n : (forall u, 0 < u < D / 2 -> sqrt u * q (a - u) = f * / sqrt (1 - u / D)) ->
  right_terms q a (fun k => f * c k / D ^ k) n.
Proof.
  intros Hq. exists (Rabs f * (2 * ((2 * INR n + 1) * c n)) / D ^ S n), (D / 2). split; [lra |]. intros u Hu.
  assert (Hz := share_of_half u Hu). assert (B := root_series n (u / D) Hz). rewrite Hq, scaled_polynomial by assumption.
  rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq (/ sqrt (1 - u / D) - _)) by lra.
  assert (0 < D ^ S n) by (apply pow_lt, HD).
  replace (Rabs f * (2 * ((2 * INR n + 1) * c n)) / D ^ S n * u ^ S n) with (Rabs f * (2 * ((2 * INR n + 1) * c n) * (u / D) ^ S n)).
  - apply Rmult_le_compat_l; [apply Rabs_pos | lra].
  - unfold Rdiv. rewrite (Rpow_mult_distr u), pow_inv. set (p := D ^ S n) in *. set (y := u ^ S n). field. lra.
Qed.
Definition tension_coefficient (k : nat) : R := match k with O => 1 | S j => c (S j) - 2 * c j end.
Lemma tension_polynomial n z : polynomial tension_coefficient n z = (1 - 2 * z) * polynomial c n z + 2 * c n * z ^ S n.
Proof.
  induction n as [| n IH]; [simpl; ring |].
  change (polynomial tension_coefficient n z + (c (S n) - 2 * c n) * z ^ S n = (1 - 2 * z) * (polynomial c n z + c (S n) * z ^ S n) + 2 * c (S n) * z ^ S (S n)).
  rewrite IH. simpl. ring.
Qed.
Lemma tension_terms (q : R -> R) a n : (forall u, 0 < u < D / 2 -> sqrt u * q (a - u) = f * ((1 - 2 * (u / D)) * / sqrt (1 - u / D))) ->
  right_terms q a (fun k => f * tension_coefficient k / D ^ k) n.
Proof.
  intros Hq. exists (Rabs f * (2 * ((2 * INR n + 1) * c n) + 2 * c n) / D ^ S n), (D / 2). split; [lra |]. intros u Hu.
  assert (Hz := share_of_half u Hu). assert (B := root_series n (u / D) Hz). assert (Q := c_positive n).
  rewrite Hq, scaled_polynomial, tension_polynomial by assumption. assert (0 < D ^ S n) by (apply pow_lt, HD).
  assert (Zn : 0 < (u / D) ^ S n) by (apply pow_lt; lra).
  rewrite <- Rmult_minus_distr_l, Rabs_mult.
  replace (Rabs f * (2 * ((2 * INR n + 1) * c n) + 2 * c n) / D ^ S n * u ^ S n) with (Rabs f * (2 * ((2 * INR n + 1) * c n) * (u / D) ^ S n + 2 * c n * (u / D) ^ S n)).
  - apply Rmult_le_compat_l; [apply Rabs_pos |].
    replace ((1 - 2 * (u / D)) * / sqrt (1 - u / D) - ((1 - 2 * (u / D)) * polynomial c n (u / D) + 2 * c n * (u / D) ^ S n))
      with ((1 - 2 * (u / D)) * (/ sqrt (1 - u / D) - polynomial c n (u / D)) + - (2 * c n * (u / D) ^ S n)) by ring.
    apply (Rle_trans _ _ _ (Rabs_triang _ _)). rewrite Rabs_Ropp, Rabs_mult.
    rewrite (Rabs_pos_eq (1 - 2 * (u / D))), (Rabs_pos_eq (/ sqrt (1 - u / D) - _)), (Rabs_pos_eq (2 * c n * (u / D) ^ S n))
      by (try lra; apply Rmult_le_pos; lra).
    apply Rplus_le_compat_r. set (z := u / D) in *. set (g := / sqrt (1 - z) - polynomial c n z) in *. nra.
  - unfold Rdiv. rewrite (Rpow_mult_distr u), pow_inv. set (p := D ^ S n) in *. set (y := u ^ S n). field. lra.
Qed.
Lemma tension_sign k : (1 <= k)%nat -> tension_coefficient k < 0.
Proof. intros H. destruct k as [| k]; [lia |]. simpl. generalize (c_decreases k) (c_positive k). simpl. lra. Qed.
End Terms.

Theorem force_signs a b Q n : 0 < a + b -> Q <> 0 -> exists s v,
  are_the_right_terms (full_stick Q 0 a b) a s n /\ are_the_left_terms (full_stick Q 0 a b) b v n /\
  forall k, (1 <= k <= n)%nat -> 0 < s k * s O /\ 0 < v k * v O.
Proof.
  intros HD HQ. assert (Hpi := PI_RGT_0). set (D := a + b) in *. assert (HrD := sqrt_lt_R0 D HD).
  assert (E : forall u, 0 < u < D / 2 -> sqrt u * (Q / (PI * sqrt (u * (D - u)))) = Q / (PI * sqrt D) * / sqrt (1 - u / D)).
  { intros u Hu. assert (0 < 1 - u / D) by (generalize (share_of_half D HD u Hu); lra).
    replace (u * (D - u)) with (u * (D * (1 - u / D))) by (field; lra). rewrite !sqrt_mult by (try apply Rmult_le_pos; lra).
    assert (0 < sqrt u) by (apply sqrt_lt_R0; lra). assert (0 < sqrt (1 - u / D)) by (apply sqrt_lt_R0; lra). field. repeat split; lra. }
  assert (F : Q / (PI * sqrt D) <> 0) by (apply Rmult_integral_contrapositive_currified; [exact HQ | apply Rinv_neq_0_compat, Rgt_not_eq, Rmult_lt_0_compat; lra]).
  assert (Sign : forall k, 0 < Q / (PI * sqrt D) * c k / D ^ k * (Q / (PI * sqrt D) * c 0 / D ^ 0)).
  { intros k. assert (0 < D ^ k) by (apply pow_lt, HD). assert (P := c_positive k). set (f := Q / (PI * sqrt D)) in *.
    replace (f * c k / D ^ k * (f * c 0 / D ^ 0)) with (f ^ 2 * c k / D ^ k) by (simpl; field; apply pow_nonzero; lra).
    apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [nra | exact P] | assumption]. }
  exists (fun k => Q / (PI * sqrt D) * c k / D ^ k), (fun k => Q / (PI * sqrt D) * c k / D ^ k). split; [| split].
  - apply the_right_terms, (force_terms D _ HD). intros u Hu. rewrite force_at. apply E, Hu.
  - apply the_right_terms, (force_terms D _ HD). intros u Hu. cbv beta. replace (- (b - u)) with (- b + u) by ring. rewrite force_at_left. apply E, Hu.
  - intros k _. split; apply Sign.
Qed.
Theorem tension_signs a b sig0 n : 0 < a + b -> sig0 <> 0 -> exists s v,
  are_the_right_terms (full_stick 0 sig0 a b) a s n /\ are_the_left_terms (full_stick 0 sig0 a b) b v n /\
  forall k, (1 <= k <= n)%nat -> s k * s O < 0 /\ v k * v O < 0.
Proof.
  intros HD HQ. set (D := a + b) in *. assert (HrD := sqrt_lt_R0 D HD).
  assert (E : forall g u, 0 < u < D / 2 -> sqrt u * (g * (D - 2 * u) / (8 * sqrt (u * (D - u)))) = g * sqrt D / 8 * ((1 - 2 * (u / D)) * / sqrt (1 - u / D))).
  { intros g u Hu. assert (0 < 1 - u / D) by (generalize (share_of_half D HD u Hu); lra).
    replace (u * (D - u)) with (u * (D * (1 - u / D))) by (field; lra). rewrite !sqrt_mult by (try apply Rmult_le_pos; lra).
    assert (0 < sqrt u) by (apply sqrt_lt_R0; lra). assert (0 < sqrt (1 - u / D)) by (apply sqrt_lt_R0; lra).
    assert (ED : sqrt D * sqrt D = D) by (apply sqrt_sqrt; lra).
    replace (1 - 2 * (u / D)) with ((D - 2 * u) / (sqrt D * sqrt D)) by (rewrite ED; field; lra). field. repeat split; lra. }
  assert (Sign : forall f k, f <> 0 -> (1 <= k)%nat -> f * tension_coefficient k / D ^ k * (f * tension_coefficient 0 / D ^ 0) < 0).
  { intros f k Hf Hk. assert (0 < D ^ k) by (apply pow_lt, HD). assert (P := tension_sign k Hk).
    replace (f * tension_coefficient k / D ^ k * (f * tension_coefficient 0 / D ^ 0)) with (- (f ^ 2 * - tension_coefficient k / D ^ k)) by (simpl; field; apply pow_nonzero; lra).
    assert (0 < f ^ 2 * - tension_coefficient k / D ^ k) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; nra | assumption]). lra. }
  assert (F1 : sig0 * sqrt D / 8 <> 0) by (assert (sig0 * sqrt D <> 0) by (apply Rmult_integral_contrapositive_currified; lra); lra).
  assert (F2 : - sig0 * sqrt D / 8 <> 0) by lra.
  exists (fun k => sig0 * sqrt D / 8 * tension_coefficient k / D ^ k), (fun k => - sig0 * sqrt D / 8 * tension_coefficient k / D ^ k). split; [| split].
  - apply the_right_terms, (tension_terms D _ HD). intros u Hu. rewrite tension_at. apply E, Hu.
  - apply the_right_terms, (tension_terms D _ HD). intros u Hu. cbv beta. replace (- (b - u)) with (- b + u) by ring. rewrite tension_at_left. apply E, Hu.
  - intros k Hk. split; apply Sign; try assumption; lia.
Qed.
