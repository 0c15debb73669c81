(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Stick ClosedForm Dilogarithm.
Open Scope R_scope.

(* The pressure of a corner at t in the contact (-b, a), in units of Es / pi times the jump of g' over 2, and the
   principal value of its integral over s - x. *)

Definition log_pressure (a b t s : R) : R := 2 * ln (kernel_root a b t s) - ln (Rabs (s - t)) - ln (a + b).

Lemma by_inner_derivative (f F : R -> R) l r : l <= r -> (forall s, l < s < r -> is_derive F s (f s)) ->
  (forall s, l <= s <= r -> continuous F s) -> (forall s, l <= s <= r -> continuous f s) -> is_RInt f l r (F r - F l).
Proof.
  intros H HD HF Hf. destruct (Rle_lt_or_eq_dec l r H) as [L | <-]; [| rewrite Rminus_diag_eq by reflexivity; apply (is_RInt_point (V := R_NormedModule))].
  (* An extension that is continuous everywhere. *)
  set (clip := fun s => Rmax l (Rmin r s)). set (k := fun s => f (clip s)).
  assert (Cc : forall s, continuous clip s).
  { intros s. apply (continuous_ext (fun s => (l + (r + s - Rabs (r - s)) / 2 + Rabs (l - (r + s - Rabs (r - s)) / 2)) / 2)).
    - intros z. unfold clip, Rmax, Rmin. destruct (Rle_dec r z); [rewrite (Rabs_left1 (r - z)) by lra | rewrite (Rabs_pos_eq (r - z)) by lra];
        (match goal with |- context [Rle_dec l ?y] => destruct (Rle_dec l y) end; [rewrite Rabs_left1 by lra | rewrite Rabs_pos_eq by lra]; in_R; field).
    - assert (A : forall f : R -> R, continuous f s -> continuous (fun s => Rabs (f s)) s) by (intros h Hh; apply (continuous_comp h Rabs); [exact Hh | apply continuous_Rabs]).
      assert (I : continuous (fun s => (r + s - Rabs (r - s)) / 2) s).
      { apply continuous_quotient; [| apply continuous_const | lra]. apply continuous_sub; [apply continuous_add; [apply continuous_const | apply continuous_id] |].
        apply (A (fun s => r - s)), continuous_sub; [apply continuous_const | apply continuous_id]. }
      apply continuous_quotient; [| apply continuous_const | lra]. apply continuous_add; [apply continuous_add; [apply continuous_const | exact I] |].
      apply (A (fun s => l - (r + s - Rabs (r - s)) / 2)), continuous_sub; [apply continuous_const | exact I]. }
  assert (Range : forall s, l <= clip s <= r) by (intros s; unfold clip, Rmax, Rmin; destruct (Rle_dec r s); (destruct (Rle_dec l r) || idtac); try (destruct (Rle_dec l s)); lra).
  assert (Same : forall s, l <= s <= r -> clip s = s) by (intros s Hs; unfold clip; rewrite Rmin_right, Rmax_right by lra; reflexivity).
  assert (Ck : forall s, continuous k s) by (intros s; apply (continuous_comp clip f); [apply Cc | apply Hf, Range]).
  assert (Ik : forall p q, ex_RInt k p q) by (intros p q; apply (@ex_RInt_continuous R_CompleteNormedModule); intros; apply Ck).
  assert (Dk : forall s, is_derive (fun s => RInt k l s) s (k s)).
  { intros s. apply (is_derive_RInt k (fun s => RInt k l s) l s); [| apply Ck]. apply filter_forall. intros y. apply (@RInt_correct R_CompleteNormedModule), Ik. }
  assert (E : RInt k l l - F l = RInt k l r - F r).
  { apply (constant_between (fun s => RInt k l s - F s)); [exact H | |].
    - intros s Hs. replace 0 with (k s - f s) by (unfold k; rewrite Same by lra; ring).
      apply (is_derive_minus (V := R_NormedModule) (fun s => RInt k l s) F); [apply Dk | apply HD, Hs].
    - intros s Hs. apply continuous_sub; [apply (@ex_derive_continuous R_AbsRing R_NormedModule); eexists; apply Dk | apply HF, Hs]. }
  rewrite RInt_point in E. change (@zero R_CompleteNormedModule) with 0 in E.
  apply (is_RInt_ext k).
  - intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra. unfold k. rewrite Same by lra. reflexivity.
  - replace (F r - F l) with (RInt k l r) by lra. apply (@RInt_correct R_CompleteNormedModule), Ik.
Qed.

Lemma integral_by_ends (f F : R -> R) l r : l < r -> (forall y z, l < y -> y <= z -> z < r -> is_RInt f y z (F z - F y)) ->
  continuous F l -> continuous F r -> is_RInt_gen f (at_right l) (at_left r) (F r - F l).
Proof.
  intros H HI Cl Cr P [e He]. assert (E0 := cond_pos e). set (m := (l + r) / 2).
  assert (H2 : 0 < e / 2) by lra.
  apply (Filter_prod _ _ _ (fun y => l < y < m /\ Rabs (F y - F l) < e / 2) (fun z => m < z < r /\ Rabs (F z - F r) < e / 2)).
  - apply filter_and; [exists (mkposreal (m - l) ltac:(unfold m; lra)); intros y Hy Hly | apply filter_le_within; exact (Cl _ (locally_ball (F l) (mkposreal _ H2)))].
    unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy. apply Rabs_def2 in Hy. lra.
  - apply filter_and; [exists (mkposreal (r - m) ltac:(unfold m; lra)); intros y Hy Hly | apply filter_le_within; exact (Cr _ (locally_ball (F r) (mkposreal _ H2)))].
    unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy. apply Rabs_def2 in Hy. lra.
  - intros y z [Hy Fy] [Hz Fz]. exists (F z - F y). split; [apply HI; simpl; lra |].
    apply He. unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl. apply Rabs_def2 in Fy. apply Rabs_def2 in Fz. apply Rabs_def1; lra.
Qed.

Section Log.
Variables a b t : R.
Hypothesis Ht : - b < t < a.
Let kr := kernel_root a b t.
Let root s := sqrt ((a - s) * (s + b)).
Let T := sqrt ((a - t) * (t + b)).
Let w := log_pressure a b t.
(* exp(- w), with the sign of s - t. *)
Let y s := (s - t) * (a + b) / kr s ^ 2.
Let kappa := (2 * t + b - a) / (a + b).
Let p := sqrt (a - t).
Let q := sqrt (t + b).
Let pq : 0 < p /\ 0 < q /\ p * p = a - t /\ q * q = t + b /\ T = p * q.
Proof.
  unfold p, q, T. repeat split; try (apply sqrt_lt_R0; lra); try (apply sqrt_sqrt; lra). apply sqrt_mult; lra.
Qed.
Let kr_pos s : - b <= s <= a -> 0 < kr s.
Proof. apply (kernel_root_positive a b t Ht). Qed.
Let kr_form s : - b <= s <= a -> kr s = sqrt (a - s) * q + sqrt (s + b) * p.
Proof. intros Hs. unfold kr, kernel_root, p, q. rewrite !sqrt_mult by lra. reflexivity. Qed.
Let kr_continuous s : continuous kr s.
Proof.
  unfold kr, kernel_root. apply continuous_add.
  - apply (continuous_comp (fun s => (a - s) * (t + b)) sqrt); [| apply continuous_sqrt]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - apply (continuous_comp (fun s => (s + b) * (a - t)) sqrt); [| apply continuous_sqrt]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Let y_continuous s : - b <= s <= a -> continuous y s.
Proof.
  intros Hs. assert (H := kr_pos s Hs). apply continuous_quotient.
  - apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - apply continuous_square, kr_continuous.
  - apply pow_nonzero. lra.
Qed.
Let y1 s := T * (a + b) / (root s * kr s ^ 2).
Let y_derive s : - b < s < a -> is_derive y s (y1 s).
Proof.
  intros Hs. destruct pq as (Hp & Hq & Ep & Eq & ET). assert (K0 := kr_pos s ltac:(lra)). assert (K1 := kr_form s ltac:(lra)).
  assert (R3 : 0 < sqrt (a - s)) by (apply sqrt_lt_R0; lra). assert (R4 : 0 < sqrt (s + b)) by (apply sqrt_lt_R0; lra).
  assert (E3 : sqrt (a - s) * sqrt (a - s) = a - s) by (apply sqrt_sqrt; lra).
  assert (E4 : sqrt (s + b) * sqrt (s + b) = s + b) by (apply sqrt_sqrt; lra).
  apply (is_derive_ext_loc (fun s => (s - t) * (a + b) / (sqrt (a - s) * q + sqrt (s + b) * p) ^ 2)).
  { apply (locally_near s (Rmin (s + b) (a - s))); [apply Rmin_pos; lra |]. intros r Hr.
    generalize (Rmin_l (s + b) (a - s)) (Rmin_r (s + b) (a - s)). intros. unfold y. rewrite kr_form by lra. reflexivity. }
  unfold y1, root. rewrite sqrt_mult by lra. rewrite ET. rewrite K1 in K0 |- *.
  auto_derive; change (a + - s) with (a - s).
  - repeat split; try lra. apply Rgt_not_eq, Rmult_lt_0_compat; lra.
  - assert (Est : s - t = sqrt (s + b) * sqrt (s + b) - q * q) by lra. change (s + - t) with (s - t). rewrite Est.
    assert (Eab : a + b = p * p + q * q) by lra. rewrite Eab.
    assert (Eu : sqrt (a - s) * sqrt (a - s) = p * p + q * q - sqrt (s + b) * sqrt (s + b)) by lra.
    set (u := sqrt (a - s)) in *. set (v := sqrt (s + b)) in *. clearbody u v. clear - K0 R3 R4 Hp Hq Eu.
    in_R. field_simplify_eq; [| repeat split; lra]. ring [Eu].
Qed.
Let y_off s : - b <= s <= a -> s <> t -> y s <> 0.
Proof.
  intros Hs N. assert (H := kr_pos s Hs). unfold y, Rdiv. apply Rmult_integral_contrapositive_currified.
  - apply Rmult_integral_contrapositive_currified; lra.
  - apply Rinv_neq_0_compat, pow_nonzero. lra.
Qed.
Let w_of_y s : - b <= s <= a -> s <> t -> w s = - ln (Rabs (y s)).
Proof.
  intros Hs N. assert (H := kr_pos s Hs). unfold y, w, log_pressure. fold kr.
  assert (A : 0 < Rabs (s - t)) by (apply Rabs_pos_lt; lra).
  unfold Rdiv. rewrite !Rabs_mult, (Rabs_pos_eq (a + b)), (Rabs_pos_eq (/ _)) by (try (apply Rlt_le, Rinv_0_lt_compat, pow_lt, H); lra).
  rewrite !ln_mult, ln_Rinv by (try apply Rinv_0_lt_compat; try apply pow_lt; try apply Rmult_lt_0_compat; (exact H || exact A || lra)).
  simpl. rewrite Rmult_1_r, ln_mult by exact H. ring.
Qed.
Let w_derive s : - b < s < a -> s <> t -> is_derive w s (- (y1 s / y s)).
Proof.
  intros Hs N. assert (H := kr_pos s ltac:(lra)). assert (Hr : 0 < root s) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
  destruct pq as (Hp & Hq & _ & _ & ET). assert (T0 : 0 < T) by (rewrite ET; apply Rmult_lt_0_compat; assumption).
  assert (L := log_derive a b t Ht s Hs N). fold T kr in L.
  assert (L2 := is_derive_scal _ s (- T) _ L).
  refine (is_derive_ext (fun s => - T * (/ T * (ln (Rabs (s - t)) - 2 * ln (kr s))) + - ln (a + b)) w s _ _ _).
  - intros z. unfold w, log_pressure. fold kr. in_R. field. lra.
  - refine (eq_ind (- T * / (root s * (s - t)) + 0) (fun v => is_derive _ s v) _ _ _).
    + apply (is_derive_plus (V := R_NormedModule) (fun s => - T * (/ T * (ln (Rabs (s - t)) - 2 * ln (kr s)))) (fun _ => - ln (a + b))); [exact L2 | apply (is_derive_const (V := R_NormedModule))].
    + unfold y1, y. field. repeat split; lra.
Qed.
Lemma log_pressure_derive s : - b < s < a -> s <> t -> is_derive (log_pressure a b t) s (- (T / ((s - t) * root s))).
Proof.
  intros Hs N. replace (T / ((s - t) * root s)) with (y1 s / y s); [apply w_derive; assumption |].
  assert (H := kr_pos s ltac:(lra)). assert (Hr : 0 < root s) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra). unfold y1, y. field. repeat split; lra.
Qed.
Lemma log_pressure_at_ends : log_pressure a b t a = 0 /\ log_pressure a b t (- b) = 0.
Proof.
  assert (E := log_of_ends a b t Ht). assert (G : ln (a - t) - 2 * ln (kernel_root a b t a) = - ln (a + b)).
  { unfold kernel_root. rewrite (Rminus_diag_eq a a), Rmult_0_l, sqrt_0, Rplus_0_l by reflexivity.
    assert (H : forall z, 0 < z -> 2 * ln (sqrt z) = ln z).
    { intros z Hz. rewrite <- (sqrt_sqrt z) at 2 by lra. rewrite ln_mult by (apply sqrt_lt_R0, Hz). ring. }
    rewrite H, ln_mult by (try apply Rmult_lt_0_compat; lra). ring. }
  unfold log_pressure. rewrite (Rabs_pos_eq (a - t)), (Rabs_left (- b - t)) by lra. replace (- (- b - t)) with (t + b) by ring. lra.
Qed.

(* ---- The integral of w ---- *)

Let angle := kernel_angle a b.
Definition log_pressure_integral (s : R) : R := (s - t) * w s + T * angle s.
Let W := log_pressure_integral.
Lemma log_pressure_integral_derive s : - b < s < a -> s <> t -> is_derive W s (w s).
Proof.
  intros Hs N. assert (Hr : 0 < root s) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra). assert (H := kr_pos s ltac:(lra)).
  refine (eq_ind (1 * w s + (s - t) * - (y1 s / y s) + T * / root s) (fun v => is_derive _ s v) _ _ _).
  - apply (is_derive_plus (V := R_NormedModule) (fun s => (s - t) * w s) (fun s => T * angle s)).
    + apply (is_derive_mult (fun s => s - t) w); [auto_derive; [trivial | ring] | apply w_derive; assumption | intros; apply Rmult_comm].
    + apply (is_derive_scal angle). apply (angle_derive a b t Ht s Hs).
  - unfold y1, y. field. repeat split; lra.
Qed.
Let w_times s : continuous (fun s => (s - t) * ln (Rabs (s - t))) s.
Proof.
  destruct (Req_dec s t) as [-> | N].
  - apply (no_log_left (fun s => s) 1 t). auto_derive; trivial.
  - apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply (is_derive_mult (fun s => s - t) (fun s => ln (Rabs (s - t)))).
    + auto_derive; [trivial | reflexivity].
    + apply ln_abs_derive, N.
    + intros; apply Rmult_comm.
Qed.
Let ln_kr_continuous s : - b <= s <= a -> continuous (fun s => 2 * ln (kr s) - ln (a + b)) s.
Proof.
  intros Hs. apply continuous_sub; [| apply continuous_const]. apply continuous_times; [apply continuous_const |]. apply (log_continuous a b t Ht). exact Hs.
Qed.
Lemma moment_continuous s : - b <= s <= a -> continuous (fun s => (s - t) * log_pressure a b t s) s.
Proof.
  intros Hs. apply (continuous_ext (fun s => (s - t) * (2 * ln (kr s) - ln (a + b)) - (s - t) * ln (Rabs (s - t)))).
  - intros z. unfold log_pressure. fold kr. in_R. ring.
  - apply continuous_sub; [| apply w_times]. apply continuous_times; [| apply ln_kr_continuous, Hs].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma log_pressure_integral_continuous s : - b <= s <= a -> continuous W s.
Proof.
  intros Hs. apply continuous_add; [apply moment_continuous, Hs |]. apply continuous_times; [apply continuous_const |]. apply (angle_continuous a b t Ht). exact Hs.
Qed.
Lemma log_pressure_integral_ends : W a - W (- b) = PI * T.
Proof.
  destruct log_pressure_at_ends as [E1 E2]. unfold W, log_pressure_integral, w, angle. rewrite E1, E2, (kernel_angle_left a b), (kernel_angle_right a b t Ht). ring.
Qed.

(* ---- The integral of w / (s - x) ---- *)

Section Pole.
Variable x : R.
Hypothesis Hx : - b < x < a.
Hypothesis N : x <> t.
Let z := y x.
(* (s - x) / (t - x) = (1 - y / z) (1 - y z) / (1 + 2 kappa y + y^2). *)
Let quadratic s : - b <= s <= a -> 1 + 2 * kappa * y s + y s ^ 2 = 4 * (T * T) / kr s ^ 2.
Proof.
  intros Hs. destruct pq as (Hp & Hq & Ep & Eq & ET). assert (K0 := kr_pos s Hs). assert (K1 := kr_form s Hs).
  assert (E3 : sqrt (a - s) * sqrt (a - s) = a - s) by (apply sqrt_sqrt; lra).
  assert (E4 : sqrt (s + b) * sqrt (s + b) = s + b) by (apply sqrt_sqrt; lra).
  unfold kappa, y. rewrite ET. rewrite K1 in K0 |- *.
  replace (2 * t + b - a) with (q * q - p * p) by lra. replace (s - t) with (sqrt (s + b) * sqrt (s + b) - q * q) by lra.
  replace (a + b) with (p * p + q * q) by lra.
  assert (Eu : sqrt (a - s) * sqrt (a - s) = p * p + q * q - sqrt (s + b) * sqrt (s + b)) by lra.
  set (u := sqrt (a - s)) in *. set (v := sqrt (s + b)) in *. clearbody u v. clear - K0 Hp Hq Eu.
  assert (0 < p * p + q * q) by nra. field_simplify_eq; [| repeat split; nra]. ring [Eu].
Qed.
Let identity s : - b <= s <= a -> (s - x) * (1 + 2 * kappa * y s + y s ^ 2) * z = (t - x) * (z - y s) * (1 - y s * z).
Proof.
  intros Hs. rewrite quadratic by exact Hs. destruct pq as (Hp & Hq & Ep & Eq & ET). assert (K0 := kr_pos s Hs). assert (K1 := kr_form s Hs).
  assert (L0 := kr_pos x ltac:(lra)). assert (L1 := kr_form x ltac:(lra)).
  assert (E3 : sqrt (a - s) * sqrt (a - s) = a - s) by (apply sqrt_sqrt; lra).
  assert (E4 : sqrt (s + b) * sqrt (s + b) = s + b) by (apply sqrt_sqrt; lra).
  assert (E5 : sqrt (a - x) * sqrt (a - x) = a - x) by (apply sqrt_sqrt; lra).
  assert (E6 : sqrt (x + b) * sqrt (x + b) = x + b) by (apply sqrt_sqrt; lra).
  unfold z, y. rewrite ET. rewrite K1 in K0 |- *. rewrite L1 in L0 |- *.
  replace (s - x) with (sqrt (s + b) * sqrt (s + b) - sqrt (x + b) * sqrt (x + b)) by lra.
  replace (t - x) with (q * q - sqrt (x + b) * sqrt (x + b)) by lra. replace (x - t) with (sqrt (x + b) * sqrt (x + b) - q * q) by lra.
  replace (s - t) with (sqrt (s + b) * sqrt (s + b) - q * q) by lra. replace (a + b) with (p * p + q * q) by lra.
  assert (Eu : sqrt (a - s) * sqrt (a - s) = p * p + q * q - sqrt (s + b) * sqrt (s + b)) by lra.
  assert (Ev : sqrt (a - x) * sqrt (a - x) = p * p + q * q - sqrt (x + b) * sqrt (x + b)) by lra.
  set (u := sqrt (a - s)) in *. set (v := sqrt (s + b)) in *. set (u0 := sqrt (a - x)) in *. set (v0 := sqrt (x + b)) in *. clearbody u v u0 v0.
  clear - K0 L0 Hp Hq Eu Ev.
  field_simplify_eq; [| repeat split; nra]. ring [Eu Ev].
Qed.

Let kappa_range : -1 < kappa < 1.
Proof. unfold kappa. split; apply (Rmult_lt_reg_r (a + b)); try lra; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra. Qed.
Let y_range s : - b < s < a -> -1 < y s < 1.
Proof.
  intros Hs. destruct pq as (Hp & Hq & Ep & Eq & ET). assert (K0 := kr_pos s ltac:(lra)). assert (K1 := kr_form s ltac:(lra)).
  assert (R3 : 0 < sqrt (a - s)) by (apply sqrt_lt_R0; lra). assert (R4 : 0 < sqrt (s + b)) by (apply sqrt_lt_R0; lra).
  assert (E3 : sqrt (a - s) * sqrt (a - s) = a - s) by (apply sqrt_sqrt; lra).
  assert (E4 : sqrt (s + b) * sqrt (s + b) = s + b) by (apply sqrt_sqrt; lra).
  assert (Y : y s = (sqrt (s + b) * p - sqrt (a - s) * q) / kr s).
  { unfold y. rewrite K1 in *. replace ((s - t) * (a + b)) with ((sqrt (s + b) * p - sqrt (a - s) * q) * (sqrt (a - s) * q + sqrt (s + b) * p)).
    - field. lra.
    - replace ((sqrt (s + b) * p - sqrt (a - s) * q) * (sqrt (a - s) * q + sqrt (s + b) * p)) with ((sqrt (s + b) * sqrt (s + b)) * (p * p) - (sqrt (a - s) * sqrt (a - s)) * (q * q)) by ring.
      rewrite E3, E4, Ep, Eq. ring. }
  assert (0 < sqrt (a - s) * q) by (apply Rmult_lt_0_compat; assumption). assert (0 < sqrt (s + b) * p) by (apply Rmult_lt_0_compat; assumption).
  rewrite Y. split; apply (Rmult_lt_reg_r (kr s)); try lra; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.
Let y_end : y a = 1 /\ y (- b) = -1.
Proof.
  unfold y, kr, kernel_root. rewrite (Rminus_diag_eq a a), Rplus_opp_l, !Rmult_0_l, sqrt_0, Rplus_0_l, Rplus_0_r by reflexivity.
  replace (sqrt ((a + b) * (a - t)) ^ 2) with ((a + b) * (a - t)) by (symmetry; apply pow2_sqrt, Rmult_le_pos; lra).
  replace (sqrt ((a - - b) * (t + b)) ^ 2) with ((a + b) * (t + b)) by (replace (a - - b) with (a + b) by ring; symmetry; apply pow2_sqrt, Rmult_le_pos; lra).
  split; field; lra.
Qed.
Let z_off : z <> 0.
Proof. apply y_off; [lra | exact N]. Qed.
Let z_range : -1 < z < 1.
Proof. apply y_range, Hx. Qed.
Let D := dilogarithm.
Let E := e_integral kappa.
(* An antiderivative is w x ln|s - x| + regular s. *)
Definition regular s := (w s - w x) * ln (Rabs (s - x)) - w s * ln (Rabs (t - x)) - D (y s / z) - D (y s * z) - E (y s).
Let logs s : - b < s < a -> s <> x ->
  ln (Rabs (s - x)) - ln (Rabs (t - x)) = ln (Rabs (1 - y s / z)) + ln (Rabs (1 - y s * z)) - ln (1 + 2 * kappa * y s + y s ^ 2).
Proof.
  intros Hs Nx. assert (I := identity s ltac:(lra)). assert (Q := quadratic_positive kappa (y s) kappa_range). assert (Z := z_off).
  assert (Tx : t - x <> 0) by lra. assert (Sx : s - x <> 0) by lra.
  assert (J : (s - x) * (1 + 2 * kappa * y s + y s ^ 2) = (t - x) * ((1 - y s / z) * (1 - y s * z))).
  { apply (Rmult_eq_reg_r z); [rewrite I; field; exact Z | exact Z]. }
  assert (J0 : (t - x) * ((1 - y s / z) * (1 - y s * z)) <> 0) by (rewrite <- J; apply Rmult_integral_contrapositive_currified; lra).
  assert (A1 : 1 - y s / z <> 0) by (intros Z1; apply J0; rewrite Z1; ring). assert (A2 : 1 - y s * z <> 0) by (intros Z1; apply J0; rewrite Z1; ring).
  assert (J2 := f_equal (fun v => ln (Rabs v)) J). cbv beta in J2. rewrite !Rabs_mult in J2. rewrite (Rabs_pos_eq (1 + 2 * kappa * y s + y s ^ 2)) in J2 by lra.
  rewrite !ln_mult in J2 by (try apply Rmult_lt_0_compat; try apply Rabs_pos_lt; assumption). lra.
Qed.
Lemma pole_derive s : - b < s < a -> s <> t -> s <> x ->
  is_derive (fun s => w x * ln (Rabs (s - x)) + regular s) s (w s / (s - x)).
Proof.
  intros Hs Nt Nx. assert (Yd := y_derive s Hs). assert (Y0 := y_off s ltac:(lra) Nt). assert (Z := z_off). assert (Wd := w_derive s Hs Nt).
  assert (L := logs s Hs Nx). assert (Yr := y_range s Hs). assert (Zr := z_range).
  assert (I := identity s ltac:(lra)). assert (Q := quadratic_positive kappa (y s) kappa_range).
  assert (Y1 : y s / z <> 1).
  { intros E1. assert (E2 : y s = z) by (rewrite <- (Rmult_1_l z), <- E1; field; exact Z). rewrite E2, (Rminus_diag_eq z z), Rmult_0_r, Rmult_0_l in I by reflexivity.
    rewrite <- E2 in I. revert I. apply Rmult_integral_contrapositive_currified; [apply Rmult_integral_contrapositive_currified; lra | exact Y0]. }
  assert (Yz0 : y s / z <> 0) by (unfold Rdiv; apply Rmult_integral_contrapositive_currified; [exact Y0 | apply Rinv_neq_0_compat, Z]).
  assert (Yz1 : y s * z <> 1) by nra. assert (Yn : y s * z <> 0) by (apply Rmult_integral_contrapositive_currified; assumption).
  apply (is_derive_ext (fun s => w s * (ln (Rabs (s - x)) - ln (Rabs (t - x))) - D (y s / z) - D (y s * z) - E (y s))).
  { intros r. unfold regular. in_R. ring. }
  assert (D1 : is_derive (fun s => D (y s / z)) s (y1 s / z * (- ln (Rabs (1 - y s / z)) / (y s / z)))).
  { apply (is_derive_comp D (fun s => y s / z)); [apply dilogarithm_derive; assumption |].
    apply (is_derive_ext (fun s => / z * y s)); [intros r; in_R; unfold Rdiv; ring |]. replace (y1 s / z) with (/ z * y1 s) by (unfold Rdiv; ring).
    apply (is_derive_scal y), Yd. }
  assert (D2 : is_derive (fun s => D (y s * z)) s (y1 s * z * (- ln (Rabs (1 - y s * z)) / (y s * z)))).
  { apply (is_derive_comp D (fun s => y s * z)); [apply dilogarithm_derive; assumption |].
    apply (is_derive_ext (fun s => z * y s)); [intros r; in_R; ring |]. replace (y1 s * z) with (z * y1 s) by ring. apply (is_derive_scal y), Yd. }
  assert (D3 : is_derive (fun s => E (y s)) s (y1 s * e_term kappa (y s))).
  { apply (is_derive_comp E y); [apply e_integral_derive, kappa_range | exact Yd]. }
  assert (D4 : is_derive (fun s => w s * (ln (Rabs (s - x)) - ln (Rabs (t - x)))) s (- (y1 s / y s) * (ln (Rabs (s - x)) - ln (Rabs (t - x))) + w s * (/ (s - x) - 0))).
  { apply (is_derive_mult w (fun s => ln (Rabs (s - x)) - ln (Rabs (t - x)))); [exact Wd | | intros; apply Rmult_comm].
    apply (is_derive_minus (V := R_NormedModule) (fun s => ln (Rabs (s - x))) (fun _ => ln (Rabs (t - x)))); [apply ln_abs_derive, Nx | apply (is_derive_const (V := R_NormedModule))]. }
  assert (S := is_derive_minus (V := R_NormedModule) _ _ _ _ _ (is_derive_minus (V := R_NormedModule) _ _ _ _ _ (is_derive_minus (V := R_NormedModule) _ _ _ _ _ D4 D1) D2) D3).
  refine (eq_ind _ (fun v => is_derive _ s v) S _ _).
  unfold minus, plus, opp; simpl. unfold e_term. rewrite (over_off _ _ _ Y0), L. in_R. field. repeat split; (assumption || lra).
Qed.
Let w_continuous s : - b <= s <= a -> s <> t -> continuous w s.
Proof.
  intros Hs Nt. apply (continuous_ext (fun s => (2 * ln (kr s) - ln (a + b)) - ln (Rabs (s - t)))).
  - intros r. unfold w, log_pressure. fold kr. in_R. ring.
  - apply continuous_sub; [apply ln_kr_continuous, Hs |]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply ln_abs_derive, Nt.
Qed.
Lemma regular_continuous s : - b <= s <= a -> continuous regular s.
Proof.
  intros Hs. assert (Yc := y_continuous s Hs). assert (Z := z_off).
  assert (C1 : continuous (fun s => D (y s / z)) s).
  { apply (continuous_comp (fun s => y s / z) D); [apply continuous_quotient; [exact Yc | apply continuous_const | exact Z] | apply dilogarithm_continuous]. }
  assert (C2 : continuous (fun s => D (y s * z)) s).
  { apply (continuous_comp (fun s => y s * z) D); [apply continuous_times; [exact Yc | apply continuous_const] | apply dilogarithm_continuous]. }
  assert (C3 : continuous (fun s => E (y s)) s).
  { apply (continuous_comp y E); [exact Yc |]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply e_integral_derive, kappa_range. }
  unfold regular. apply continuous_sub; [apply continuous_sub; [apply continuous_sub |] |]; try assumption. clear C1 C2 C3.
  destruct (Req_dec s x) as [-> | Nx].
  - apply continuous_sub.
    + apply (no_log_left w (- (y1 x / y x)) x), w_derive; assumption.
    + apply continuous_times; [apply w_continuous; assumption | apply continuous_const].
  - assert (Lx : forall r, r <> x -> continuous (fun s => ln (Rabs (s - x))) r).
    { intros r Hr. apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply ln_abs_derive, Hr. }
    destruct (Req_dec s t) as [-> | Nt].
    + apply (continuous_ext (fun s => (2 * ln (kr s) - ln (a + b)) * (ln (Rabs (s - x)) - ln (Rabs (t - x))) - w x * ln (Rabs (s - x))
        - (ln (Rabs (s - x)) - ln (Rabs (t - x))) * ln (Rabs (s - t)))).
      * intros r. unfold w, log_pressure. fold kr. in_R. ring.
      * apply continuous_sub; [apply continuous_sub |].
        -- apply continuous_times; [apply ln_kr_continuous, Hs | apply continuous_sub; [apply Lx, Nx | apply continuous_const]].
        -- apply continuous_times; [apply continuous_const | apply Lx, Nx].
        -- apply (no_log_left (fun s => ln (Rabs (s - x))) (/ (t - x)) t), ln_abs_derive, Nx.
    + apply continuous_sub; [apply continuous_times; [apply continuous_sub; [apply w_continuous; assumption | apply continuous_const] | apply Lx, Nx] |].
      apply continuous_times; [apply w_continuous; assumption | apply continuous_const].
Qed.
Lemma pole_ends : w x * ln (a - x) + regular a - (w x * ln (x + b) + regular (- b)) =
  - (PI * asin kappa) + (if Rlt_dec t x then - (PI ^ 2 / 2) else PI ^ 2 / 2).
Proof.
  destruct log_pressure_at_ends as [E1 E2]. destruct y_end as [Y1 Y2]. unfold regular. change (w a) with (log_pressure a b t a). change (w (- b)) with (log_pressure a b t (- b)).
  rewrite E1, E2, Y1, Y2, (Rabs_pos_eq (a - x)), (Rabs_left (- b - x)) by lra. replace (- (- b - x)) with (x + b) by ring.
  replace (1 / z) with (/ z) by (unfold Rdiv; ring). replace (-1 / z) with (- / z) by (unfold Rdiv; ring). replace (-1 * z) with (- z) by ring. rewrite Rmult_1_l.
  assert (Et := e_total kappa kappa_range). fold E in Et. assert (Zr := z_range). assert (K0 := kr_pos x ltac:(lra)). assert (P2 : 0 < / kr x ^ 2) by (apply Rinv_0_lt_compat, pow_lt, K0).
  assert (F : z = (x - t) * ((a + b) * / kr x ^ 2)) by (unfold z, y, Rdiv; ring). assert (G : 0 < (a + b) * / kr x ^ 2) by (apply Rmult_lt_0_compat; lra).
  destruct (Rlt_dec t x) as [L | L].
  - assert (P := dilogarithm_inverse z ltac:(rewrite F in *; split; [apply Rmult_lt_0_compat; lra | lra])). fold D in P. lra.
  - assert (P := dilogarithm_inverse (- z) ltac:(rewrite F in *; split; [nra | lra])). fold D in P.
    rewrite Ropp_involutive in P. replace (/ - z) with (- / z) in P by (field; apply z_off). rewrite Ropp_involutive in P. lra.
Qed.
End Pole.

(* ---- The principal values ---- *)

Definition corner_value (x : R) : R := - (PI * asin ((2 * t + b - a) / (a + b))) + (if Rlt_dec t x then - (PI ^ 2 / 2) else PI ^ 2 / 2).
Let off_pole (f : R -> R) x s : continuous f s -> s <> x -> continuous (fun s => f s / (s - x)) s.
Proof.
  intros C H. apply continuous_quotient; [exact C | | lra]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Let one_sided x (l r m n : R) : - b < x < a -> x <> t -> - b <= l -> r <= a -> (r <= t \/ t <= l) -> l < m -> m <= n -> n < r -> n < x \/ x < m ->
  is_RInt (fun s => w s / (s - x)) m n (w x * ln (Rabs (n - x)) + regular x n - (w x * ln (Rabs (m - x)) + regular x m)).
Proof.
  intros Hx N Hl Hr Side Hy Hyz Hz Off.
  apply (by_inner_derivative (fun s => w s / (s - x)) (fun s => w x * ln (Rabs (s - x)) + regular x s)); [exact Hyz | | |].
  - intros s Hs. apply pole_derive; lra.
  - intros s Hs. apply continuous_add; [apply continuous_times; [apply continuous_const |] | apply regular_continuous; lra].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply ln_abs_derive. lra.
  - intros s Hs. apply off_pole; [| lra]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply w_derive; lra.
Qed.
Let near (F : R -> R) s : continuous F s -> filterlim F (at_right s) (locally (F s)) /\ filterlim F (at_left s) (locally (F s)).
Proof. intros C. split; intros P HP; apply filter_le_within; exact (C P HP). Qed.
(* A corner, at which the pressure is unbounded. *)
Theorem corner_right x : t < x < a -> exists v v', is_RInt_gen (fun s => w s / (s - x)) (at_right (- b)) (at_left t) v /\
  is_principal_value (fun s => w s / (s - x)) t a x v' /\ v + v' = corner_value x.
Proof.
  intros Hx. assert (Hx' : - b < x < a) by lra. assert (N : x <> t) by lra. set (F := fun s => w x * ln (Rabs (s - x)) + regular x s).
  assert (Fc : forall s, - b <= s <= a -> s <> x -> continuous F s).
  { intros s Hs Ns. apply continuous_add; [apply continuous_times; [apply continuous_const |] | apply regular_continuous; (assumption || lra)].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply ln_abs_derive, Ns. }
  exists (F t - F (- b)), (w x * ln (a - x) + regular x a - (w x * ln (x - t) + regular x t)). split; [| split].
  - apply integral_by_ends; [lra | | apply Fc; lra | apply Fc; lra]. intros m n Hy Hyz Hz. apply (one_sided x (- b) t); lra.
  - apply (principal_value _ (regular x) t a x (w x)); [exact Hx | | | | |].
    + intros m n Hy Hyz Hz Off. apply (one_sided x t a); lra.
    + apply near, regular_continuous; lra.
    + apply near, regular_continuous; lra.
    + apply regular_continuous; lra.
    + reflexivity.
  - unfold F. rewrite (Rabs_left (t - x)), (Rabs_left (- b - x)) by lra. replace (- (t - x)) with (x - t) by ring. replace (- (- b - x)) with (x + b) by ring.
    assert (E := pole_ends x Hx' N). unfold kappa in E. unfold corner_value. lra.
Qed.
Theorem corner_left x : - b < x < t -> exists v v', is_principal_value (fun s => w s / (s - x)) (- b) t x v /\
  is_RInt_gen (fun s => w s / (s - x)) (at_right t) (at_left a) v' /\ v + v' = corner_value x.
Proof.
  intros Hx. assert (Hx' : - b < x < a) by lra. assert (N : x <> t) by lra. set (F := fun s => w x * ln (Rabs (s - x)) + regular x s).
  assert (Fc : forall s, - b <= s <= a -> s <> x -> continuous F s).
  { intros s Hs Ns. apply continuous_add; [apply continuous_times; [apply continuous_const |] | apply regular_continuous; (assumption || lra)].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply ln_abs_derive, Ns. }
  exists (w x * ln (t - x) + regular x t - (w x * ln (x - - b) + regular x (- b))), (F a - F t). split; [| split].
  - apply (principal_value _ (regular x) (- b) t x (w x)); [exact Hx | | | | |].
    + intros m n Hy Hyz Hz Off. apply (one_sided x (- b) t); lra.
    + apply near, regular_continuous; lra.
    + apply near, regular_continuous; lra.
    + apply regular_continuous; lra.
    + reflexivity.
  - apply integral_by_ends; [lra | | apply Fc; lra | apply Fc; lra]. intros m n Hy Hyz Hz. apply (one_sided x t a); lra.
  - unfold F. rewrite (Rabs_pos_eq (t - x)), (Rabs_pos_eq (a - x)) by lra. replace (x - - b) with (x + b) by ring.
    assert (E := pole_ends x Hx' N). unfold kappa in E. unfold corner_value. lra.
Qed.
(* A change of curvature, at which it is not. *)
Theorem curvature_everywhere x : - b < x < a ->
  is_principal_value (fun s => (s - t) * w s / (s - x)) (- b) a x (PI * T + (x - t) * corner_value x).
Proof.
  intros Hx. assert (Mc := moment_continuous). assert (Wc := log_pressure_integral_continuous). assert (We := log_pressure_integral_ends).
  assert (Through : forall (f F : R -> R) m n, m <= n -> (forall s, m < s < n -> s <> t -> is_derive F s (f s)) ->
    (forall s, m <= s <= n -> continuous F s) -> (forall s, m <= s <= n -> continuous f s) -> is_RInt f m n (F n - F m)).
  { intros f F m n H HD HF Hf. destruct (Rlt_le_dec m t) as [L | L]; [destruct (Rlt_le_dec t n) as [M | M] |].
    - replace (F n - F m) with (plus (F t - F m) (F n - F t)) by (unfold plus; simpl; ring).
      apply (is_RInt_Chasles (V := R_NormedModule) f m t n); (apply by_inner_derivative; [lra | intros s Hs; apply HD; lra | intros s Hs; apply HF; lra | intros s Hs; apply Hf; lra]).
    - apply by_inner_derivative; [lra | intros s Hs; apply HD; lra | intros s Hs; apply HF; lra | intros s Hs; apply Hf; lra].
    - apply by_inner_derivative; [lra | intros s Hs; apply HD; lra | intros s Hs; apply HF; lra | intros s Hs; apply Hf; lra]. }
  destruct (Req_dec x t) as [-> | N].
  - replace (PI * T + (t - t) * corner_value t) with (PI * T) by ring.
    apply (principal_value _ W (- b) a t 0); [exact Hx | | apply near, Wc; lra | apply near, Wc; lra | apply Wc; lra | lra].
    intros m n Hy Hyz Hz Off. replace (0 * ln (Rabs (n - t)) + W n - (0 * ln (Rabs (m - t)) + W m)) with (W n - W m) by ring.
    apply Through; [exact Hyz | | intros s Hs; apply Wc; lra | intros s Hs; apply (off_pole (fun s => (s - t) * w s)); [apply Mc |]; lra].
    intros s Hs Ns. replace ((s - t) * w s / (s - t)) with (w s) by (field; lra). apply log_pressure_integral_derive; lra.
  - apply (principal_value _ (fun s => W s + (x - t) * regular x s) (- b) a x ((x - t) * w x)); [exact Hx | | | | |].
    + intros m n Hy Hyz Hz Off. set (F := fun s => W s + (x - t) * (w x * ln (Rabs (s - x)) + regular x s)).
      replace ((x - t) * w x * ln (Rabs (n - x)) + (W n + (x - t) * regular x n) - ((x - t) * w x * ln (Rabs (m - x)) + (W m + (x - t) * regular x m)))
        with (F n - F m) by (unfold F; ring).
      apply Through; [exact Hyz | | | intros s Hs; apply (off_pole (fun s => (s - t) * w s)); [apply Mc |]; lra].
      * intros s Hs Ns. replace ((s - t) * w s / (s - x)) with (w s + (x - t) * (w s / (s - x))) by (field; lra).
        apply (is_derive_plus (V := R_NormedModule) W (fun s => (x - t) * (w x * ln (Rabs (s - x)) + regular x s))).
        -- apply log_pressure_integral_derive; lra.
        -- apply (is_derive_scal (fun s => w x * ln (Rabs (s - x)) + regular x s)). apply pole_derive; lra.
      * intros s Hs. apply continuous_add; [apply Wc; lra |]. apply continuous_times; [apply continuous_const |].
        apply continuous_add; [apply continuous_times; [apply continuous_const |] | apply regular_continuous; (assumption || lra)].
        apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply ln_abs_derive. lra.
    + apply (near (fun s => W s + (x - t) * regular x s)), continuous_add; [apply Wc; lra | apply continuous_times; [apply continuous_const | apply regular_continuous; (assumption || lra)]].
    + apply (near (fun s => W s + (x - t) * regular x s)), continuous_add; [apply Wc; lra | apply continuous_times; [apply continuous_const | apply regular_continuous; (assumption || lra)]].
    + apply continuous_add; [apply Wc; lra | apply continuous_times; [apply continuous_const | apply regular_continuous; (assumption || lra)]].
    + assert (E := pole_ends x Hx N). unfold kappa in E. unfold corner_value. replace (x - - b) with (x + b) by ring. rewrite <- We, <- E. ring.
Qed.
End Log.
