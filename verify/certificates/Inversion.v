(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Stick.
Open Scope R_scope.

(* The pressure by the inversion of the singular integral equation of the contact problem,
   p(x) = Es / (2 pi) sqrt(a^2 - x^2) pv int g'(s) / (sqrt(a^2 - s^2) (s - x)) ds,
   is Barber and Mossakovskii's integral, for symmetric punches that are piecewise linear, beyond
   their knots. *)

Lemma piece (f g F : R -> R) y z : y <= z -> (forall s, y < s < z -> f s = g s) ->
  (y < z -> forall s, y <= s <= z -> is_derive F s (g s) /\ continuous g s) -> is_RInt f y z (F z - F y).
Proof.
  intros H E D. destruct (Rle_lt_or_eq_dec y z H) as [L | <-].
  - apply (is_RInt_antiderivative f g F); [exact H | exact E | |]; intros s Hs; apply (D L); exact Hs.
  - rewrite Rminus_diag_eq by reflexivity. apply (is_RInt_point (V := R_NormedModule)).
Qed.

Section Part.
Variables t d k a x : R.
Hypothesis Ht : 0 <= t < x.
Hypothesis Hx : x < a.
Let q := Part t d k.
Let X := sqrt ((a - x) * (x + a)).
Let inside : - a < x < a. Proof. lra. Qed.
Let g s := ln (Rabs (s - x)) - 2 * ln (kernel_root a a x s).
Let theta s := kernel_angle a a s.
Let f s := part_slope q s / sqrt ((a - s) * (s + a)) / (s - x).
(* Antiderivatives of A / (root (s - x)) + k / root. *)
Let F A s := A * (/ X * g s) + k * theta s.
Let right := d + k * (x - t).
Let left := - d + k * (x + t).

Let X0 : 0 < X. Proof. apply X_positive. exact inside. Qed.
Lemma F_derive A s : - a < s < a -> s <> x ->
  is_derive (F A) s ((A + k * (s - x)) / sqrt ((a - s) * (s + a)) / (s - x)) /\
  continuous (fun s => (A + k * (s - x)) / sqrt ((a - s) * (s + a)) / (s - x)) s.
Proof.
  intros Hs Hsx. assert (Hr : 0 < sqrt ((a - s) * (s + a))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra). split.
  - replace ((A + k * (s - x)) / sqrt ((a - s) * (s + a)) / (s - x))
      with (A * / (sqrt ((a - s) * (s + a)) * (s - x)) + k * / sqrt ((a - s) * (s + a))) by (field; lra).
    apply (is_derive_plus (V := R_NormedModule) (fun s => A * (/ X * g s)) (fun s => k * theta s)).
    + apply (is_derive_scal (fun s => / X * g s)). apply (log_derive a a x inside); assumption.
    + apply (is_derive_scal theta). apply (angle_derive a a x inside). assumption.
  - assert (0 < (a - s) * (s + a)) by (apply Rmult_lt_0_compat; lra).
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. change (a + - s) with (a - s). change (s + - x) with (s - x). repeat split; lra.
Qed.

Let Phi s := (F left (Rmin s (- t)) - F left (- t)) + (F right (Rmax s t) - F right t).
Lemma Phi_left s : s <= - t -> Phi s = F left s - F left (- t).
Proof. intros H. unfold Phi. rewrite Rmin_left, Rmax_right by lra. ring. Qed.
Lemma Phi_middle s : - t <= s <= t -> Phi s = 0.
Proof. intros H. unfold Phi. rewrite Rmin_right, Rmax_right by lra. ring. Qed.
Lemma Phi_right s : t <= s -> Phi s = F right s - F right t.
Proof. intros H. unfold Phi. rewrite Rmin_right, Rmax_left by lra. ring. Qed.

Lemma part_integral y z : - a < y -> y <= z -> z < a -> z < x \/ x < y -> is_RInt f y z (Phi z - Phi y).
Proof.
  intros Hy Hyz Hz Hside.
  set (p := Rmax y (Rmin z (- t))). set (r := Rmax y (Rmin z t)).
  assert (Hp : y <= p <= z /\ (p = y \/ p <= - t) /\ (p = z \/ - t <= p)).
  { unfold p, Rmax, Rmin. destruct (Rle_dec z (- t)); [destruct (Rle_dec y z) | destruct (Rle_dec y (- t))]; lra. }
  assert (Hr : p <= r <= z /\ (r = y \/ r <= t) /\ (r = z \/ t <= r)).
  { unfold r, p, Rmax, Rmin. destruct (Rle_dec z (- t)), (Rle_dec z t); try lra; repeat match goal with |- context [Rle_dec ?u ?v] => destruct (Rle_dec u v) end; lra. }
  clearbody p r.
  replace (Phi z - Phi y) with (plus (Phi p - Phi y) (plus (Phi r - Phi p) (Phi z - Phi r))) by (unfold plus; simpl; ring).
  apply (is_RInt_Chasles f y p z); [| apply (is_RInt_Chasles f p r z)].
  - destruct (Req_dec y p) as [<- | Hne].
    { rewrite Rminus_diag_eq by reflexivity. apply (is_RInt_point (V := R_NormedModule)). }
    rewrite !Phi_left by lra. replace (F left p - F left (- t) - (F left y - F left (- t))) with (F left p - F left y) by ring.
    apply (piece f (fun s => (left + k * (s - x)) / sqrt ((a - s) * (s + a)) / (s - x))); [lra | |].
    + intros s Hs. unfold f. unfold q. rewrite slope_left by lra. unfold left. f_equal. f_equal. ring.
    + intros _ s Hs. apply F_derive; lra.
  - destruct (Req_dec p r) as [<- | Hne].
    { rewrite Rminus_diag_eq by reflexivity. apply (is_RInt_point (V := R_NormedModule)). }
    rewrite !Phi_middle by lra. replace (0 - 0) with ((fun _ : R => 0) r - (fun _ : R => 0) p) by ring.
    apply (piece f (fun _ => 0) (fun _ => 0)); [lra | |].
    + intros s Hs. unfold f, q. rewrite slope_flat by lra. unfold Rdiv. ring.
    + intros _ s _. split; [auto_derive; trivial | apply continuous_const].
  - destruct (Req_dec r z) as [<- | Hne].
    { rewrite Rminus_diag_eq by reflexivity. apply (is_RInt_point (V := R_NormedModule)). }
    rewrite !Phi_right by lra. replace (F right z - F right t - (F right r - F right t)) with (F right z - F right r) by ring.
    apply (piece f (fun s => (right + k * (s - x)) / sqrt ((a - s) * (s + a)) / (s - x))); [lra | |].
    + intros s Hs. unfold f. unfold q. rewrite slope_right by lra. unfold right. f_equal. f_equal. ring.
    + intros _ s Hs. apply F_derive; lra.
Qed.

Let c := right / X.
Lemma log_continuous_off s : s <> x -> continuous (fun s => ln (Rabs (s - x))) s.
Proof.
  intros H. destruct (Rlt_le_dec s x) as [L | L].
  - apply (continuous_ext_loc _ (fun s => ln (x - s))).
    + apply (locally_near s (x - s)); [lra |]. intros r Hr. rewrite Rabs_left by lra. f_equal. ring.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. lra.
  - apply (continuous_ext_loc _ (fun s => ln (s - x))).
    + apply (locally_near s (s - x)); [lra |]. intros r Hr. rewrite Rabs_pos_eq by lra. reflexivity.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. lra.
Qed.
Lemma F_continuous A s : - a <= s <= a -> s <> x -> continuous (F A) s.
Proof.
  intros Hs H. unfold F. apply continuous_add; apply continuous_times; try apply continuous_const.
  - apply continuous_times; [apply continuous_const |]. apply continuous_sub; [apply log_continuous_off, H |].
    apply continuous_times; [apply continuous_const |]. apply (log_continuous a a x inside s Hs).
  - apply (angle_continuous a a x inside s Hs).
Qed.
Let h s := Phi s - c * ln (Rabs (s - x)).
Lemma h_right s : t <= s -> h s = - (2 * c) * ln (kernel_root a a x s) + k * theta s - F right t.
Proof. intros H. unfold h. rewrite Phi_right by exact H. unfold F, g, c. field. generalize X0. lra. Qed.

Theorem part_principal_value : is_principal_value f (- a) a x (F right a - F right t + (F left (- t) - F left (- a))).
Proof.
  assert (Near_right : forall s, t < s -> s <= a -> continuous h s).
  { intros s H1 H2. apply (continuous_ext_loc _ (fun s => - (2 * c) * ln (kernel_root a a x s) + k * theta s - F right t)).
    - apply (locally_near s (s - t)); [lra |]. intros r Hr. symmetry. apply h_right. lra.
    - apply continuous_sub; [| apply continuous_const]. apply continuous_add; apply continuous_times; try apply continuous_const.
      + apply (log_continuous a a x inside). lra.
      + apply (angle_continuous a a x inside). lra. }
  apply (principal_value f h (- a) a x c); [exact inside | | | | |].
  - intros y z Hy Hyz Hz Hside. replace (c * ln (Rabs (z - x)) + h z - (c * ln (Rabs (y - x)) + h y)) with (Phi z - Phi y) by (unfold h; ring).
    apply part_integral; assumption.
  - assert (C : continuous (fun s => F left s - F left (- t) - c * ln (Rabs (s - x))) (- a)).
    { apply continuous_sub; [apply continuous_sub; [apply F_continuous; lra | apply continuous_const] |].
      apply continuous_times; [apply continuous_const | apply log_continuous_off; lra]. }
    assert (E : h (- a) = F left (- a) - F left (- t) - c * ln (Rabs (- a - x))) by (unfold h; rewrite Phi_left by lra; reflexivity).
    rewrite E. apply (filterlim_ext_loc (fun s => F left s - F left (- t) - c * ln (Rabs (s - x)))).
    + destruct (Req_dec t a) as [Z | Z]; [lra |].
      exists (mkposreal (a - t) ltac:(lra)). intros s Hb Hs. unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb.
      apply Rabs_def2 in Hb. unfold h. rewrite Phi_left by lra. reflexivity.
    + intros P HP. apply filter_le_within. exact (C P HP).
  - intros P HP. apply filter_le_within. exact (Near_right a ltac:(lra) ltac:(lra) P HP).
  - apply Near_right; lra.
  - unfold h. rewrite (Phi_right a), (Phi_left (- a)) by lra. rewrite (Rabs_pos_eq (a - x)), (Rabs_left (- a - x)) by lra.
    replace (- (- a - x)) with (x - - a) by ring. ring.
Qed.

(* ---- Its value ---- *)

Let r := sqrt (a ^ 2 - x ^ 2).
Let w := sqrt (a ^ 2 - t ^ 2).
Let r0 : 0 < r < w.
Proof. unfold r, w. split; [apply sqrt_lt_R0; nra | apply sqrt_lt_1_alt; split; nra]. Qed.
Let r2 : r ^ 2 = a ^ 2 - x ^ 2. Proof. apply pow2_sqrt. nra. Qed.
Let w2 : w ^ 2 = a ^ 2 - t ^ 2. Proof. apply pow2_sqrt. nra. Qed.
Let Xr : X = r. Proof. unfold X, r. f_equal. ring. Qed.

Lemma twice_ln_sqrt y : 0 < y -> 2 * ln (sqrt y) = ln y.
Proof. intros H. rewrite <- (sqrt_sqrt y) at 2 by lra. rewrite ln_mult by (apply sqrt_lt_R0, H). ring. Qed.
Lemma g_at_a : g a = - ln (2 * a).
Proof.
  unfold g, kernel_root. rewrite (Rabs_pos_eq (a - x)) by lra. rewrite (Rminus_diag_eq a a), Rmult_0_l, sqrt_0, Rplus_0_l by reflexivity.
  rewrite twice_ln_sqrt by (apply Rmult_lt_0_compat; lra). rewrite ln_mult by lra. replace (a + a) with (2 * a) by ring. ring.
Qed.
Lemma g_at_ends : g (- a) = g a.
Proof.
  unfold g. rewrite (Rabs_pos_eq (a - x)), (Rabs_left (- a - x)) by lra. replace (- (- a - x)) with (x + a) by ring.
  symmetry. exact (log_of_ends a a x inside).
Qed.
Lemma root_squared s : - a < s < a -> kernel_root a a x s ^ 2 = 2 * (a ^ 2 - s * x + sqrt (a ^ 2 - s ^ 2) * r).
Proof.
  intros Hs. unfold kernel_root.
  assert (E1 : sqrt ((a - s) * (x + a)) ^ 2 = (a - s) * (x + a)) by (apply pow2_sqrt, Rmult_le_pos; lra).
  assert (E2 : sqrt ((s + a) * (a - x)) ^ 2 = (s + a) * (a - x)) by (apply pow2_sqrt, Rmult_le_pos; lra).
  assert (E3 : sqrt ((a - s) * (x + a)) * sqrt ((s + a) * (a - x)) = sqrt (a ^ 2 - s ^ 2) * r).
  { unfold r. rewrite <- !sqrt_mult by (try apply Rmult_le_pos; nra). f_equal. ring. }
  replace ((sqrt ((a - s) * (x + a)) + sqrt ((s + a) * (a - x))) ^ 2)
    with (sqrt ((a - s) * (x + a)) ^ 2 + sqrt ((s + a) * (a - x)) ^ 2 + 2 * (sqrt ((a - s) * (x + a)) * sqrt ((s + a) * (a - x)))) by ring.
  rewrite E1, E2, E3. ring.
Qed.
Lemma log_right : g a - g t = ln ((a ^ 2 - t * x + w * r) / (a * (x - t))).
Proof.
  assert (K := kernel_root_positive a a x inside t ltac:(lra)). assert (K2 := root_squared t ltac:(lra)). fold w in K2.
  assert (0 < kernel_root a a x t ^ 2) by (apply pow_lt, K).
  rewrite g_at_a. unfold g. rewrite (Rabs_left (t - x)) by lra.
  assert (L : 2 * ln (kernel_root a a x t) = ln 2 + ln (a ^ 2 - t * x + w * r)).
  { rewrite <- ln_mult by lra. rewrite <- K2. simpl. rewrite Rmult_1_r, ln_mult by assumption. ring. }
  replace (- (t - x)) with (x - t) by ring. assert (Pa : 0 < a * (x - t)) by (apply Rmult_lt_0_compat; lra).
  unfold Rdiv. rewrite L, (ln_mult 2 a), (ln_mult _ (/ (a * (x - t)))), ln_Rinv, (ln_mult a) by (try apply Rinv_0_lt_compat; lra). ring.
Qed.
Lemma log_left : g a - g (- t) = ln ((a ^ 2 + t * x + w * r) / (a * (x + t))).
Proof.
  assert (K := kernel_root_positive a a x inside (- t) ltac:(lra)). assert (K2 := root_squared (- t) ltac:(lra)).
  replace (a ^ 2 - (- t) ^ 2) with (a ^ 2 - t ^ 2) in K2 by ring. fold w in K2.
  replace (a ^ 2 - - t * x + w * r) with (a ^ 2 + t * x + w * r) in K2 by ring.
  assert (0 < kernel_root a a x (- t) ^ 2) by (apply pow_lt, K).
  rewrite g_at_a. unfold g. rewrite (Rabs_left (- t - x)) by lra.
  assert (L : 2 * ln (kernel_root a a x (- t)) = ln 2 + ln (a ^ 2 + t * x + w * r)).
  { rewrite <- ln_mult by lra. rewrite <- K2. simpl. rewrite Rmult_1_r, ln_mult by assumption. ring. }
  replace (- (- t - x)) with (x + t) by ring. assert (Pa : 0 < a * (x + t)) by (apply Rmult_lt_0_compat; lra).
  unfold Rdiv. rewrite L, (ln_mult 2 a), (ln_mult _ (/ (a * (x + t)))), ln_Rinv, (ln_mult a) by (try apply Rinv_0_lt_compat; lra). ring.
Qed.
Let M1 := (a ^ 2 - t * x + w * r) / (a * (x - t)).
Let M2 := (a ^ 2 + t * x + w * r) / (a * (x + t)).
Let M12 : 0 < M1 /\ 0 < M2.
Proof. unfold M1, M2. assert (0 < w * r) by (apply Rmult_lt_0_compat; lra). split; apply Rdiv_lt_0_compat; try (apply Rmult_lt_0_compat; lra); nra. Qed.
Lemma log_sum : ln M1 + ln M2 = 2 * atanh (r / w).
Proof.
  destruct M12 as [P1 P2]. rewrite <- ln_mult by assumption. unfold atanh. replace (2 * (/ 2 * ln ((1 + r / w) / (1 - r / w)))) with (ln ((1 + r / w) / (1 - r / w))) by field.
  f_equal. unfold M1, M2. assert (0 < w - r) by lra.
  field_simplify_eq; [| repeat split; lra].
  assert (E : (a ^ 2 - t * x + w * r) * (a ^ 2 + t * x + w * r) = a ^ 2 * (w + r) ^ 2).
  { replace ((a ^ 2 - t * x + w * r) * (a ^ 2 + t * x + w * r)) with (a ^ 4 + 2 * a ^ 2 * w * r + w ^ 2 * r ^ 2 - t ^ 2 * x ^ 2) by ring.
    replace (a ^ 2 * (w + r) ^ 2) with (a ^ 2 * w ^ 2 + a ^ 2 * r ^ 2 + 2 * a ^ 2 * w * r) by ring. rewrite w2, r2. ring. }
  assert (N : w ^ 2 - r ^ 2 = x ^ 2 - t ^ 2) by lra.
  generalize w2 r2. intros Ew Er. clear - E N Ew Er. 
  match goal with |- ?l = ?m => assert (Z : l - m = 0); [| lra] end.
  ring_simplify. ring [Ew Er].
Qed.
Lemma log_difference : ln M1 - ln M2 = 2 * atanh (t * r / (x * w)).
Proof.
  destruct M12 as [P1 P2].
  assert (Q : 0 < x * w - t * r) by (assert (t * r <= x * r) by (apply Rmult_le_compat_r; lra); nra).
  assert (0 < x * w) by (apply Rmult_lt_0_compat; lra).
  replace (ln M1 - ln M2) with (ln (M1 * / M2)) by (rewrite ln_mult, ln_Rinv by (try apply Rinv_0_lt_compat; assumption); ring).
  unfold atanh. replace (2 * (/ 2 * ln ((1 + t * r / (x * w)) / (1 - t * r / (x * w))))) with (ln ((1 + t * r / (x * w)) / (1 - t * r / (x * w)))) by field.
  f_equal. unfold M1, M2. assert (0 < w * r) by (apply Rmult_lt_0_compat; lra). assert (0 <= t * x) by (apply Rmult_le_pos; lra).
  assert (a ^ 2 + t * x + w * r <> 0) by nra.
  field_simplify_eq; [| repeat split; lra].
  generalize w2 r2. intros Ew Er. clear - Ew Er. match goal with |- ?l = ?m => assert (Z : l - m = 0); [| lra] end.
  ring_simplify. ring [Ew Er].
Qed.
Lemma angle_difference : theta t - theta (- t) = 2 * atan (t / w).
Proof.
  set (D := fun s => theta s - theta (- s) - 2 * atan (s / sqrt (a ^ 2 - s ^ 2))).
  assert (Dd : forall s, 0 <= s <= t -> is_derive D s 0).
  { intros s Hs. assert (P : 0 < a ^ 2 - s ^ 2) by nra. assert (Q := sqrt_lt_R0 _ P). assert (E : sqrt (a ^ 2 - s ^ 2) ^ 2 = a ^ 2 - s ^ 2) by (apply pow2_sqrt; lra).
    assert (D1 := angle_derive a a x inside s ltac:(lra)). assert (D2 := angle_derive a a x inside (- s) ltac:(lra)).
    replace ((a - s) * (s + a)) with (a ^ 2 - s ^ 2) in D1 by ring. replace ((a - - s) * (- s + a)) with (a ^ 2 - s ^ 2) in D2 by ring.
    unfold D, theta. change (a ^ 2 - s ^ 2) with (a ^ 2 + - s ^ 2) in *. auto_derive; change (s * (s * 1)) with (s ^ 2); change (a * (a * 1)) with (a ^ 2).
    - repeat split; try lra; eexists; [exact D1 | exact D2].
    - replace (Derive (fun x0 => kernel_angle a a x0) s) with (/ sqrt (a ^ 2 + - s ^ 2)) by (symmetry; apply is_derive_unique, D1).
      replace (Derive (fun x0 => kernel_angle a a x0) (- s)) with (/ sqrt (a ^ 2 + - s ^ 2)) by (symmetry; apply is_derive_unique, D2).
      set (v := sqrt (a ^ 2 + - s ^ 2)) in *. clearbody v.
      replace (1 + s * / v * (s * / v * 1)) with (a ^ 2 / v ^ 2) by (field_simplify_eq; [rewrite E; ring | lra]).
      field_simplify_eq; [ring [E] | split; lra]. }
  assert (D0 : D 0 = 0) by (unfold D; rewrite Ropp_0; unfold Rdiv; rewrite Rmult_0_l, atan_0; ring).
  destruct (Rle_lt_or_eq_dec 0 t ltac:(lra)) as [L | <-].
  - destruct (MVT_cor2 D (fun _ => 0) 0 t L) as (s & E & _); [intros s Hs; apply is_derive_Reals, Dd, Hs |].
    rewrite D0 in E. unfold D in E. fold w in E. lra.
  - rewrite Ropp_0. unfold Rdiv. rewrite Rmult_0_l, atan_0. ring.
Qed.

Theorem part_by_inversion Es : Es / (2 * PI) * r * (F right a - F right t + (F left (- t) - F left (- a))) = part_pressure Es x q a.
Proof.
  assert (Hpi := PI_RGT_0). unfold F. rewrite Xr. unfold theta at 1 4. rewrite (kernel_angle_left a a), (kernel_angle_right a a x inside). fold (theta t) (theta (- t)).
  assert (L1 : g t = g a - ln M1) by (unfold M1; rewrite <- log_right; ring).
  assert (L2 : g (- t) = g a - ln M2) by (unfold M2; rewrite <- log_left; ring).
  rewrite g_at_ends, L1, L2. unfold part_pressure, q, from, corner, curvature. fold r w.
  assert (S := log_sum). assert (T := log_difference). assert (A := angle_difference).
  replace (ln M1) with (atanh (r / w) + atanh (t * r / (x * w))) by lra.
  replace (ln M2) with (atanh (r / w) - atanh (t * r / (x * w))) by lra.
  unfold angle. fold w. replace (atan (t / w)) with ((theta t - theta (- t)) / 2) by lra.
  unfold right, left. field. generalize r0. lra.
Qed.
End Part.

(* ---- Sums of parts ---- *)

Lemma principal_value_ext (f h : R -> R) l r x v : l < x < r -> (forall s, l < s < r -> s <> x -> f s = h s) ->
  is_principal_value f l r x v -> is_principal_value h l r x v.
Proof.
  intros Hx E (d & Hd & He & Hl). set (m := Rmin d (Rmin (x - l) (r - x) / 2)).
  assert (Hm : 0 < m) by (unfold m; apply Rmin_pos; [exact Hd | assert (0 < Rmin (x - l) (r - x)) by (apply Rmin_pos; lra); lra]).
  assert (M : m <= d /\ m <= (x - l) / 2 /\ m <= (r - x) / 2).
  { unfold m. generalize (Rmin_l d (Rmin (x - l) (r - x) / 2)) (Rmin_r d (Rmin (x - l) (r - x) / 2)) (Rmin_l (x - l) (r - x)) (Rmin_r (x - l) (r - x)). lra. }
  exists m. split; [exact Hm | split].
  - intros e Hem. destruct (He e ltac:(lra)) as [H1 H2]. split.
    + refine (ex_RInt_ext _ _ _ _ _ H1). intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra. apply E; lra.
    + refine (ex_RInt_ext _ _ _ _ _ H2). intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra. apply E; lra.
  - refine (filterlim_ext_loc _ _ _ Hl). exists (mkposreal m Hm). intros e Hb H0.
    unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb. apply Rabs_def2 in Hb.
    f_equal; apply RInt_ext; intros s Hs; rewrite Rmin_left in Hs by lra; rewrite Rmax_right in Hs by lra; apply E; lra.
Qed.
Lemma principal_value_sum (f h : R -> R) l r x v u :
  is_principal_value f l r x v -> is_principal_value h l r x u -> is_principal_value (fun s => f s + h s) l r x (v + u).
Proof.
  intros (d & Hd & He & Hl) (e & Hee & Hh & Hu). exists (Rmin d e). split; [apply Rmin_pos; assumption |].
  assert (M1 := Rmin_l d e). assert (M2 := Rmin_r d e). split.
  - intros z Hz. destruct (He z ltac:(lra)), (Hh z ltac:(lra)). split; apply (ex_RInt_plus (V := R_NormedModule)); assumption.
  - apply (filterlim_ext_loc (fun z => (RInt f (l + z) (x - z) + RInt f (x + z) (r - z)) + (RInt h (l + z) (x - z) + RInt h (x + z) (r - z)))).
    + exists (mkposreal (Rmin d e) (Rmin_pos _ _ Hd Hee)). intros z Hb H0.
      unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb. apply Rabs_def2 in Hb.
      destruct (He z ltac:(lra)), (Hh z ltac:(lra)).
      assert (S : forall p q, ex_RInt f p q -> ex_RInt h p q -> RInt (fun s => f s + h s) p q = RInt f p q + RInt h p q).
      { intros p q P1 P2. apply (RInt_plus (V := R_CompleteNormedModule) f h p q P1 P2). }
      rewrite !S by assumption. ring.
    + refine (filterlim_comp_2 _ _ Rplus Hl Hu _). apply (filterlim_plus (V := R_NormedModule) v u).
Qed.
Lemma principal_value_zero l r x : is_principal_value (fun _ => 0) l r x 0.
Proof.
  exists 1. split; [lra |]. split; [intros e _; split; apply ex_RInt_const |].
  apply (filterlim_ext (fun _ => 0)); [| apply filterlim_const].
  intros e. rewrite !RInt_const. unfold scal; simpl; unfold mult; simpl. ring.
Qed.

Theorem pressure_by_inversion Es l m a x : beyond m l -> 0 < m < x -> x < a -> exists v,
  is_principal_value (fun s => slope l s / sqrt (a ^ 2 - s ^ 2) * (1 / (s - x))) (- a) a x v /\
  Es / (2 * PI) * sqrt (a ^ 2 - x ^ 2) * v = total (part_pressure Es x) l a.
Proof.
  intros Hl Hm Hx. induction Hl as [| [t d k] l Ht _ (v & HI & E)].
  - exists 0. split; [| unfold total; simpl; ring].
    refine (principal_value_ext _ _ _ _ _ _ _ _ (principal_value_zero (- a) a x)); [lra |].
    intros s Hs Hsx. unfold slope, total; simpl. unfold Rdiv. ring.
  - simpl in Ht. eexists. split.
    + refine (principal_value_ext _ _ _ _ _ _ _ _ (principal_value_sum _ _ _ _ _ _ _
        (part_principal_value t d k a x ltac:(lra) Hx) HI)); [lra |].
      intros s Hs Hsx. cbv beta. replace ((a - s) * (s + a)) with (a ^ 2 - s ^ 2) by ring.
      assert (0 < sqrt (a ^ 2 - s ^ 2)) by (apply sqrt_lt_R0; nra).
      unfold slope, total; simpl. change (a * (a * 1)) with (a ^ 2). change (s * (s * 1)) with (s ^ 2). field. lra.
    + rewrite Rmult_plus_distr_l, E, (part_by_inversion t d k a x ltac:(lra) Hx Es). reflexivity.
Qed.
Theorem the_pressure_by_inversion Es l m a x : convex_punch l -> beyond m l -> 0 < m < x -> x < a -> exists p0 l0,
  is_the_pressure Es (slope l) a x p0 /\
  is_principal_value (fun s => slope l s / sqrt (a ^ 2 - s ^ 2) * (1 / (s - x))) (- a) a x l0 /\
  Es / (2 * PI) * sqrt (a ^ 2 - x ^ 2) * l0 = p0.
Proof.
  intros Hc Hl Hm Hx. destruct (pressure_by_inversion Es l m a x Hl Hm Hx) as (v & Hv & E).
  exists (total (part_pressure Es x) l a), v. split; [| split; assumption].
  apply (the_pressure _ _ (first l)); [apply punch_rises, Hc | | apply (pressure Es l m); assumption].
  split; [| exact Hx]. destruct Hl as [| q l Hq _]; [destruct Hc |]. simpl in *. lra.
Qed.
