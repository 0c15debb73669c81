(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Resultant.
Open Scope R_scope.

(* The real dilogarithm, int_0^z - ln|1 - v| / v dv, and what the equation of the contact problem
   needs of it. *)

Ltac smooth := apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; repeat split; lra.
Ltac in_R := match goal with |- @eq _ ?l ?r => change (@eq R l r) end.

Lemma constant_between (f : R -> R) a b : a <= b -> (forall z, a < z < b -> is_derive f z 0) ->
  (forall z, a <= z <= b -> continuous f z) -> f a = f b.
Proof.
  intros H D C. destruct (MVT_gen f a b (fun _ => 0)) as (c & _ & E).
  - intros z Hz. rewrite Rmin_left, Rmax_right in Hz by lra. apply D, Hz.
  - intros z Hz. rewrite Rmin_left, Rmax_right in Hz by lra. apply continuity_pt_filterlim, C, Hz.
  - lra.
Qed.

(* f(v) / v, with its limit l at 0. *)
Definition over (f : R -> R) (l v : R) : R := if Req_EM_T v 0 then l else f v / v.
Lemma over_off f l v : v <> 0 -> over f l v = f v / v.
Proof. intros H. unfold over. destruct (Req_EM_T v 0); [contradiction | reflexivity]. Qed.
Lemma over_0 f l : over f l 0 = l.
Proof. unfold over. destruct (Req_EM_T 0 0); [reflexivity | contradiction]. Qed.
Lemma times_over f l v : f 0 = 0 -> f v = over f l v * v.
Proof. intros H. destruct (Req_dec v 0) as [-> | N]; [rewrite H; ring | rewrite over_off by exact N; field; exact N]. Qed.
Lemma over_continuous f l v : f 0 = 0 -> is_derive f 0 l -> (v <> 0 -> continuous f v) -> continuous (over f l) v.
Proof.
  intros H0 HD HC. destruct (Req_dec v 0) as [-> | N].
  - intros P [e He]. apply is_derive_Reals in HD. destruct (HD e (cond_pos e)) as [d Hd].
    exists d. intros y Hy. unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
    apply He. rewrite over_0. destruct (Req_dec y 0) as [-> | N]; [rewrite over_0; apply ball_center |].
    rewrite over_off by exact N. unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl.
    rewrite Ropp_0, Rplus_0_r in Hy. specialize (Hd y N Hy). rewrite Rplus_0_l, H0, Rminus_0_r in Hd. exact Hd.
  - assert (A : 0 < Rabs v) by (apply Rabs_pos_lt, N).
    apply (continuous_ext_loc _ (fun v => f v / v)).
    + apply (locally_near v (Rabs v)); [exact A |]. intros r Hr. symmetry. apply over_off. intros E. subst r. revert A Hr. unfold Rabs. destruct (Rcase_abs v); lra.
    + apply continuous_quotient; [apply HC, N | apply continuous_id | exact N].
Qed.

Lemma ln_below v : 0 < v -> ln v < v.
Proof. intros H. assert (E := exp_ineq1_le (ln v)). rewrite exp_ln in E by exact H. lra. Qed.
Lemma u_ln_u : continuous (fun u => u * ln (Rabs u)) 0.
Proof.
  unfold continuous. rewrite Rmult_0_l.
  apply (squeezed _ _ (fun u => 2 * sqrt (Rabs u))); [apply locally_filter | |].
  - apply (locally_near 0 1); [lra |]. intros u Hu. destruct (Req_dec u 0) as [-> | N].
    + rewrite Rmult_0_l, Rabs_R0, sqrt_0. lra.
    + assert (A : 0 < Rabs u) by (apply Rabs_pos_lt, N). assert (B : Rabs u < 1) by (apply Rabs_def1; lra).
      rewrite Rabs_mult. set (w := Rabs u) in *. clearbody w. assert (Q := sqrt_lt_R0 w A). assert (E : sqrt w * sqrt w = w) by (apply sqrt_sqrt; lra).
      assert (L : ln w = - (2 * ln (/ sqrt w))).
      { rewrite ln_Rinv by exact Q. rewrite <- E at 1. rewrite ln_mult by exact Q. ring. }
      assert (M := ln_below (/ sqrt w) ltac:(apply Rinv_0_lt_compat, Q)).
      assert (Neg : ln w <= 0) by (rewrite <- ln_1; apply ln_le; lra).
      rewrite Rabs_left1 by exact Neg. rewrite L, Ropp_involutive.
      replace (2 * sqrt w) with (w * (2 * / sqrt w)) by (rewrite <- E at 1; field; lra). apply Rmult_le_compat_l; lra.
  - replace (locally 0) with (locally (2 * sqrt (Rabs 0))) at 2 by (rewrite Rabs_R0, sqrt_0, Rmult_0_r; reflexivity).
    apply (continuous_times (fun _ => 2) (fun u => sqrt (Rabs u))); [apply continuous_const |].
    apply (continuous_comp Rabs sqrt); [apply continuous_Rabs | apply continuous_sqrt].
Qed.
Lemma no_log_left (f : R -> R) l x : is_derive f x l -> continuous (fun s => (f s - f x) * ln (Rabs (s - x))) x.
Proof.
  intros H. set (g := fun u => f (x + u) - f x).
  assert (Dg : is_derive g 0 l).
  { unfold g. refine (eq_ind (minus (scal 1 l) 0) (fun v => is_derive (fun u => f (x + u) - f x) 0 v) _ l _); [| unfold minus, plus, opp, scal; simpl; unfold mult; simpl; in_R; ring].
    apply (is_derive_minus (V := R_NormedModule) (fun u => f (x + u)) (fun _ => f x)); [| apply (is_derive_const (V := R_NormedModule))].
    apply (is_derive_comp f (fun u => x + u)); [rewrite Rplus_0_r; exact H | auto_derive; [trivial | ring]]. }
  apply (continuous_ext (fun s => over g l (s - x) * ((s - x) * ln (Rabs (s - x))))).
  - intros s. in_R. rewrite <- Rmult_assoc, <- (times_over g l (s - x)) by (unfold g; rewrite Rplus_0_r; ring).
    unfold g. rewrite Rplus_minus. reflexivity.
  - assert (Sub : continuous (fun s => s - x) x) by (apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; trivial).
    apply (continuous_times (fun s => over g l (s - x)) (fun s => (s - x) * ln (Rabs (s - x)))).
    + apply (continuous_comp (fun s => s - x) (over g l)); [exact Sub |]. rewrite Rminus_diag_eq by reflexivity.
      apply over_continuous; [unfold g; rewrite Rplus_0_r; ring | exact Dg | intros N; contradiction].
    + apply (continuous_comp (fun s => s - x) (fun u => u * ln (Rabs u))); [exact Sub |]. rewrite Rminus_diag_eq by reflexivity. exact u_ln_u.
Qed.
Lemma ln_abs_derive c s : s <> c -> is_derive (fun s => ln (Rabs (s - c))) s (/ (s - c)).
Proof.
  intros H. destruct (Rlt_le_dec s c) as [L | L].
  - apply (is_derive_ext_loc (fun s => ln (c - s))).
    + apply (locally_near s (c - s)); [lra |]. intros r Hr. rewrite Rabs_left by lra. f_equal. ring.
    + auto_derive; [lra | field; lra].
  - apply (is_derive_ext_loc (fun s => ln (s - c))).
    + apply (locally_near s (s - c)); [lra |]. intros r Hr. rewrite Rabs_pos_eq by lra. reflexivity.
    + auto_derive; [lra | field; lra].
Qed.

(* ---- The dilogarithm ---- *)

Section Dilogarithm.
Let d0 := over (fun v => - ln (1 - v)) 1.
Let d0_continuous v : v < 1 -> continuous d0 v.
Proof.
  intros H. apply over_continuous.
  - rewrite Rminus_0_r, ln_1. ring.
  - auto_derive; [lra | field].
  - intros _. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. lra.
Qed.
Let D0 z := RInt d0 0 z.
Lemma primitive (f : R -> R) (l r z : R) : l < 0 < r -> (forall v, l < v < r -> continuous f v) -> l < z < r ->
  is_derive (fun z => RInt f 0 z) z (f z).
Proof.
  intros H C Hz. apply (is_derive_RInt f (fun z => RInt f 0 z) 0 z); [| apply C, Hz].
  apply (locally_near z (Rmin (z - l) (r - z))); [apply Rmin_pos; lra |]. intros y Hy.
  generalize (Rmin_l (z - l) (r - z)) (Rmin_r (z - l) (r - z)). intros.
  apply (@RInt_correct R_CompleteNormedModule), (@ex_RInt_continuous R_CompleteNormedModule). intros v Hv. apply C.
  revert Hv. unfold Rmin, Rmax. destruct (Rle_dec 0 y); lra.
Qed.
Let D0_derive z : z < 1 -> is_derive D0 z (d0 z).
Proof.
  intros H. apply (primitive d0 (Rmin z 0 - 1) 1); [| intros v Hv; apply d0_continuous; lra |]; generalize (Rmin_l z 0) (Rmin_r z 0); lra.
Qed.
Let K := 2 * D0 (1 / 2) + ln (1 / 2) * ln (1 / 2).
Let beyond z := K - ln z * ln (Rabs (z - 1)) - D0 (1 - z).
Let beyond_derive z : 0 < z -> z <> 1 -> is_derive beyond z (- ln (Rabs (1 - z)) / z).
Proof.
  intros Hz N. assert (E : Rabs (1 - z) = Rabs (z - 1)) by apply Rabs_minus_sym. rewrite E.
  replace (- ln (Rabs (z - 1)) / z) with (- (/ z * ln (Rabs (z - 1)) + ln z * / (z - 1)) - (-1) * d0 (1 - z))
    by (unfold d0; rewrite over_off by lra; replace (1 - (1 - z)) with z by ring; field; lra).
  apply (is_derive_minus (V := R_NormedModule) (fun z => K - ln z * ln (Rabs (z - 1))) (fun z => D0 (1 - z))).
  - replace (- (/ z * ln (Rabs (z - 1)) + ln z * / (z - 1))) with (minus 0 (/ z * ln (Rabs (z - 1)) + ln z * / (z - 1))) by (unfold minus, plus, opp; simpl; in_R; ring).
    apply (is_derive_minus (V := R_NormedModule) (fun _ => K)); [apply (is_derive_const (V := R_NormedModule)) |].
    apply (is_derive_mult ln (fun z => ln (Rabs (z - 1)))); [auto_derive; [exact Hz | field; lra] | apply ln_abs_derive, N | intros; apply Rmult_comm].
  - apply (is_derive_comp D0 (fun z => 1 - z)); [apply D0_derive; lra | auto_derive; [trivial | ring]].
Qed.
Let same z : 0 < z < 1 -> beyond z = D0 z.
Proof.
  intros Hz. assert (Half : beyond (1 / 2) = D0 (1 / 2)).
  { unfold beyond, K. replace (Rabs (1 / 2 - 1)) with (1 / 2) by (rewrite Rabs_left by lra; field). replace (1 - 1 / 2) with (1 / 2) by field. ring. }
  assert (Der : forall y, 0 < y < 1 -> is_derive (fun y => beyond y - D0 y) y 0).
  { intros y Hy. replace 0 with (- ln (Rabs (1 - y)) / y - d0 y) by (unfold d0; rewrite over_off, Rabs_pos_eq by lra; ring).
    apply (is_derive_minus (V := R_NormedModule) beyond D0); [apply beyond_derive; lra | apply D0_derive; lra]. }
  assert (Cont : forall y, 0 < y < 1 -> continuous (fun y => beyond y - D0 y) y).
  { intros y Hy. apply (@ex_derive_continuous R_AbsRing R_NormedModule). exists 0. apply Der, Hy. }
  destruct (Rle_lt_dec z (1 / 2)) as [L | L].
  - assert (C := constant_between (fun y => beyond y - D0 y) z (1 / 2) L ltac:(intros; apply Der; lra) ltac:(intros; apply Cont; lra)). simpl in C. lra.
  - assert (C := constant_between (fun y => beyond y - D0 y) (1 / 2) z ltac:(lra) ltac:(intros; apply Der; lra) ltac:(intros; apply Cont; lra)). simpl in C. lra.
Qed.
Definition dilogarithm z := if Rlt_dec z 1 then D0 z else beyond z.
Let D := dilogarithm.
Let D_below z : z < 1 -> D z = D0 z.
Proof. intros H. unfold D, dilogarithm. destruct (Rlt_dec z 1); [reflexivity | lra]. Qed.
Let D_above z : 0 < z -> D z = beyond z.
Proof. intros H. unfold D, dilogarithm. destruct (Rlt_dec z 1); [symmetry; apply same; lra | reflexivity]. Qed.
Lemma dilogarithm_derive z : z <> 0 -> z <> 1 -> is_derive dilogarithm z (- ln (Rabs (1 - z)) / z).
Proof.
  intros N0 N1. destruct (Rlt_le_dec z 1) as [L | L].
  - apply (is_derive_ext_loc D0).
    + apply (locally_near z (1 - z)); [lra |]. intros y Hy. symmetry. apply D_below. lra.
    + rewrite Rabs_pos_eq by lra. assert (E : d0 z = - ln (1 - z) / z) by exact (over_off (fun v => - ln (1 - v)) 1 z N0). rewrite <- E. apply D0_derive, L.
  - apply (is_derive_ext_loc beyond).
    + apply (locally_near z z); [lra |]. intros y Hy. symmetry. apply D_above. lra.
    + apply beyond_derive; lra.
Qed.
Lemma dilogarithm_continuous z : continuous dilogarithm z.
Proof.
  destruct (Rlt_le_dec z 1) as [L | L].
  - apply (continuous_ext_loc _ D0).
    + apply (locally_near z (1 - z)); [lra |]. intros y Hy. symmetry. apply D_below. lra.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). exists (d0 z). apply D0_derive, L.
  - apply (continuous_ext_loc _ beyond).
    + apply (locally_near z z); [lra |]. intros y Hy. symmetry. apply D_above. lra.
    + destruct (Rle_lt_or_eq_dec 1 z L) as [M | <-].
      * apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply beyond_derive; lra.
      * apply continuous_sub; [apply continuous_sub; [apply continuous_const |] |].
        -- apply (continuous_ext (fun z => (ln z - ln 1) * ln (Rabs (z - 1)))); [intros y; rewrite ln_1, Rminus_0_r; reflexivity |].
           apply (no_log_left ln 1 1). auto_derive; [lra | field].
        -- apply (continuous_comp (fun z => 1 - z) D0).
           ++ apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
           ++ apply (@ex_derive_continuous R_AbsRing R_NormedModule). exists (d0 (1 - 1)). apply D0_derive. lra.
Qed.
Let X z := D z - D (- z).
Let opp_derive z : z <> 0 -> z <> -1 -> is_derive (fun z => D (- z)) z (- ln (Rabs (1 + z)) / z).
Proof.
  intros N0 N1. replace (- ln (Rabs (1 + z)) / z) with (scal (-1) (- ln (Rabs (1 - - z)) / - z))
    by (unfold scal; simpl; unfold mult; simpl; replace (1 - - z) with (1 + z) by ring; field; exact N0).
  apply (is_derive_comp D (fun z => - z)); [apply dilogarithm_derive; lra | auto_derive; [trivial | ring]].
Qed.
Let X_derive z : z <> 0 -> z <> 1 -> z <> -1 -> is_derive X z ((ln (Rabs (1 + z)) - ln (Rabs (1 - z))) / z).
Proof.
  intros N0 N1 N2. replace ((ln (Rabs (1 + z)) - ln (Rabs (1 - z))) / z) with (- ln (Rabs (1 - z)) / z - - ln (Rabs (1 + z)) / z) by (field; exact N0).
  apply (is_derive_minus (V := R_NormedModule) D (fun z => D (- z))); [apply dilogarithm_derive | apply opp_derive]; assumption.
Qed.
Let X_continuous z : continuous X z.
Proof.
  apply continuous_sub; [apply dilogarithm_continuous |]. apply (continuous_comp (fun z => - z) D); [| apply dilogarithm_continuous].
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma inverse_pair y : 0 < y <= 1 -> X (/ y) + X y = 2 * X 1.
Proof.
  intros Hy. replace (2 * X 1) with (X (/ 1) + X 1) by (rewrite Rinv_1; ring).
  apply (constant_between (fun y => X (/ y) + X y)); [lra | |].
  - intros z Hz. assert (I : 1 < / z) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra).
    replace 0 with (scal (- / z ^ 2) ((ln (Rabs (1 + / z)) - ln (Rabs (1 - / z))) / (/ z)) + (ln (Rabs (1 + z)) - ln (Rabs (1 - z))) / z).
    + apply (is_derive_plus (V := R_NormedModule) (fun y => X (/ y)) X); [| apply X_derive; lra].
      apply (is_derive_comp X Rinv); [apply X_derive; lra |]. auto_derive; [lra | field; lra].
    + unfold scal; simpl; unfold mult; simpl. rewrite (Rabs_pos_eq (1 + / z)), (Rabs_left (1 - / z)), (Rabs_pos_eq (1 + z)), (Rabs_pos_eq (1 - z)) by lra.
      replace (1 + / z) with ((1 + z) * / z) by (field; lra). replace (- (1 - / z)) with ((1 - z) * / z) by (field; lra).
      rewrite !ln_mult by (try apply Rinv_0_lt_compat; lra). field. lra.
  - intros z Hz. apply continuous_add; [| apply X_continuous]. apply (continuous_comp Rinv X); [apply continuous_Rinv; lra | apply X_continuous].
Qed.

(* ---- int ln(1 + 2 k v + v^2) / v dv ---- *)

Definition e_term (k : R) : R -> R := over (fun v => ln (1 + 2 * k * v + v ^ 2)) (2 * k).
Lemma quadratic_positive k v : -1 < k < 1 -> 0 < 1 + 2 * k * v + v ^ 2.
Proof. intros H. replace (1 + 2 * k * v + v ^ 2) with ((v + k) ^ 2 + (1 - k ^ 2)) by ring. assert (0 <= (v + k) ^ 2) by apply pow2_ge_0. nra. Qed.
Lemma e_term_continuous k v : -1 < k < 1 -> continuous (e_term k) v.
Proof.
  intros H. assert (Q := quadratic_positive k v H). apply over_continuous.
  - replace (1 + 2 * k * 0 + 0 ^ 2) with 1 by ring. apply ln_1.
  - auto_derive; [lra | field; lra].
  - intros _. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. simpl in Q. lra.
Qed.
Definition e_integral (k y : R) : R := RInt (e_term k) 0 y.
Lemma e_integral_derive k y : -1 < k < 1 -> is_derive (e_integral k) y (e_term k y).
Proof.
  intros H. apply (primitive (e_term k) (Rmin y 0 - 1) (Rmax y 0 + 1)).
  - generalize (Rmin_r y 0) (Rmax_r y 0). lra.
  - intros v _. apply e_term_continuous, H.
  - generalize (Rmin_l y 0) (Rmax_l y 0). lra.
Qed.
Lemma cubic : 2 / 3 * X 1 = e_integral (1 / 2) 1 - e_integral (1 / 2) (-1).
Proof.
  set (E := e_integral (1 / 2)). set (Z := fun z => X z - / 3 * X (z ^ 3) - (E z - E (- z))).
  assert (Ed : forall z, is_derive E z (e_term (1 / 2) z)) by (intros z; apply e_integral_derive; lra).
  assert (H : Z 0 = Z 1).
  { apply constant_between; [lra | |].
    - intros z Hz. assert (P3 : 0 < z ^ 3 < 1) by (split; [apply pow_lt; lra | nra]).
      assert (D3 : is_derive (fun z => X (z ^ 3)) z (scal (3 * z ^ 2) ((ln (Rabs (1 + z ^ 3)) - ln (Rabs (1 - z ^ 3))) / z ^ 3))).
      { apply (is_derive_comp X (fun z => z ^ 3)); [apply X_derive; lra | auto_derive; [trivial | ring]]. }
      assert (Eo : is_derive (fun z => E (- z)) z (scal (-1) (e_term (1 / 2) (- z)))).
      { apply (is_derive_comp E (fun z => - z)); [apply Ed | auto_derive; [trivial | ring]]. }
      assert (S := is_derive_minus (V := R_NormedModule) _ _ z _ _
        (is_derive_minus (V := R_NormedModule) X (fun z => / 3 * X (z ^ 3)) z _ _ (X_derive z ltac:(lra) ltac:(lra) ltac:(lra)) (is_derive_scal _ z (/ 3) _ D3))
        (is_derive_minus (V := R_NormedModule) E (fun z => E (- z)) z _ _ (Ed z) Eo)).
      refine (eq_ind _ (fun v => is_derive Z z v) S _ _).
      unfold minus, plus, opp, scal; simpl; unfold mult; simpl. unfold e_term. rewrite !over_off by lra.
      change (z * (z * (z * 1))) with (z ^ 3). change (z * (z * 1)) with (z ^ 2).
      rewrite !Rabs_pos_eq by lra.
      replace (1 + z ^ 3) with ((1 + z) * (1 + 2 * (1 / 2) * - z + (- z) ^ 2)) by field.
      replace (1 - z ^ 3) with ((1 - z) * (1 + 2 * (1 / 2) * z + z ^ 2)) by field.
      assert (Q1 := quadratic_positive (1 / 2) z ltac:(lra)). assert (Q2 := quadratic_positive (1 / 2) (- z) ltac:(lra)).
      rewrite !ln_mult by (assumption || lra). in_R. field. lra.
    - intros z _. assert (Ec : forall y, continuous E y) by (intros y; apply (@ex_derive_continuous R_AbsRing R_NormedModule); eexists; apply Ed).
      apply continuous_sub; [apply continuous_sub; [apply X_continuous | apply continuous_times; [apply continuous_const |]] | apply continuous_sub; [apply Ec |]].
      + apply (continuous_comp (fun z => z ^ 3) X); [| apply X_continuous]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
      + apply (continuous_comp (fun z => - z) E); [| apply Ec]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
  unfold Z in H. replace (0 ^ 3) with 0 in H by ring. rewrite pow1, Ropp_0 in H. unfold X at 1 2 in H. rewrite Ropp_0 in H.
  change (- (1)) with (-1) in H. lra.
Qed.
Lemma e_total k : -1 < k < 1 -> e_integral k 1 - e_integral k (-1) = PI * asin k.
Proof.
  assert (Hpi := PI_RGT_0).
  assert (Whole : forall k, -1 < k < 1 -> e_integral k 1 - e_integral k (-1) = RInt (e_term k) (-1) 1).
  { intros c Hc. assert (I : forall p q, ex_RInt (e_term c) p q) by (intros p q; apply (@ex_RInt_continuous R_CompleteNormedModule); intros; apply e_term_continuous, Hc).
    assert (C := RInt_Chasles (e_term c) (-1) 0 1 (I _ _) (I _ _)). unfold e_integral.
    assert (S := opp_RInt_swap (e_term c) (-1) 0 (I _ _)). unfold plus, opp in *; simpl in *. lra. }
  intros Hk. rewrite (Whole k Hk).
  set (F1 := fun k v : R => 2 / (1 + 2 * k * v + v ^ 2)).
  assert (Fd : forall c v, -1 < c < 1 -> is_derive (fun c => e_term c v) c (F1 c v)).
  { intros c v Hc. assert (Q := quadratic_positive c v Hc). unfold e_term, over, F1. destruct (Req_EM_T v 0) as [-> | N].
    - auto_derive; [trivial | field; lra].
    - auto_derive; simpl in *; [lra | field; lra]. }
  assert (Dt : forall c, -1 < c < 1 -> is_derive (fun c => RInt (e_term c) (-1) 1) c (PI / sqrt (1 - c ^ 2))).
  { intros c Hc. assert (P0 : 0 < 1 - c ^ 2) by nra. assert (Q0 := sqrt_lt_R0 _ P0). assert (QQ : sqrt (1 - c ^ 2) * sqrt (1 - c ^ 2) = 1 - c ^ 2) by (apply sqrt_sqrt; lra).
    assert (V : RInt (fun v => Derive (fun c => e_term c v) c) (-1) 1 = PI / sqrt (1 - c ^ 2)).
    { rewrite (RInt_ext _ (F1 c)) by (intros v _; apply is_derive_unique, Fd, Hc).
      set (q := sqrt (1 - c ^ 2)) in *.
      replace (PI / q) with (2 / q * atan ((1 + c) / q) - 2 / q * atan ((-1 + c) / q)).
      - apply is_RInt_unique. apply (is_RInt_antiderivative _ (F1 c) (fun v => 2 / q * atan ((v + c) / q))); [lra | reflexivity | |].
        + intros v _. assert (Q := quadratic_positive c v Hc). unfold F1. auto_derive; [lra |].
          assert (R : 1 + (v + c) * / q * ((v + c) * / q * 1) = (1 + 2 * c * v + v ^ 2) / (q * q)) by (rewrite QQ; replace (1 + (v + c) * / q * ((v + c) * / q * 1)) with ((q * q + (v + c) ^ 2) / (q * q)) by (field; lra); rewrite QQ; f_equal; ring).
          rewrite R. field. lra.
        + intros v _. assert (Q := quadratic_positive c v Hc). unfold F1. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. simpl in Q. lra.
      - replace ((-1 + c) / q) with (- (/ ((1 + c) / q))).
        + rewrite atan_opp, atan_inv by (apply Rdiv_lt_0_compat; lra). field. lra.
        + field_simplify_eq; [| split; lra]. nra. }
    rewrite <- V. apply (is_derive_RInt_param e_term (-1) 1 c).
    - apply (locally_near c (Rmin (1 + c) (1 - c))); [apply Rmin_pos; lra |]. intros z Hz v _. exists (F1 z v). apply Fd.
      generalize (Rmin_l (1 + c) (1 - c)) (Rmin_r (1 + c) (1 - c)). lra.
    - intros v _. apply (continuity_2d_pt_ext_loc F1).
      + exists (mkposreal (Rmin (1 + c) (1 - c)) ltac:(apply Rmin_pos; lra)). simpl. intros z w Hz _. symmetry. apply is_derive_unique, Fd.
        apply Rabs_def2 in Hz. generalize (Rmin_l (1 + c) (1 - c)) (Rmin_r (1 + c) (1 - c)). lra.
      + apply continuous_2d. unfold F1. assert (Q := quadratic_positive c v Hc). apply continuous_quotient; [apply continuous_const | | simpl; simpl in Q; lra].
        apply continuous_add; [apply continuous_add; [apply continuous_const |] | apply continuous_square, continuous_snd].
        apply continuous_times; [apply continuous_times; [apply continuous_const | apply continuous_fst] | apply continuous_snd].
    - apply (locally_near c (Rmin (1 + c) (1 - c))); [apply Rmin_pos; lra |]. intros z Hz. apply (@ex_RInt_continuous R_CompleteNormedModule).
      intros v _. apply e_term_continuous. generalize (Rmin_l (1 + c) (1 - c)) (Rmin_r (1 + c) (1 - c)). lra. }
  assert (Zero : RInt (e_term 0) (-1) 1 = 0).
  { rewrite <- (Whole 0) by lra. unfold e_integral.
    assert (I : forall p q, ex_RInt (e_term 0) p q) by (intros p q; apply (@ex_RInt_continuous R_CompleteNormedModule); intros; apply e_term_continuous; lra).
    assert (C : is_RInt (e_term 0) (- 0) (- (1)) (RInt (e_term 0) 0 (-1))) by (rewrite Ropp_0; apply (@RInt_correct R_CompleteNormedModule), I).
    apply is_RInt_comp_opp in C.
    assert (Odd : is_RInt (e_term 0) 0 1 (RInt (e_term 0) 0 (-1))).
    { refine (is_RInt_ext _ _ _ _ _ _ C). intros v _. unfold e_term, over, opp; simpl.
      destruct (Req_EM_T (- v) 0), (Req_EM_T v 0); try lra. replace (- v * (- v * 1)) with (v * (v * 1)) by ring. replace (2 * 0 * - v) with (2 * 0 * v) by ring. in_R. field. assumption. }
    assert (U := is_RInt_unique (V := R_CompleteNormedModule) _ _ _ _ Odd). simpl in *. lra. }
  set (G := fun c => RInt (e_term c) (-1) 1 - PI * asin c).
  assert (Gd : forall c, -1 < c < 1 -> is_derive G c 0).
  { intros c Hc. replace 0 with (PI / sqrt (1 - c ^ 2) - PI * / sqrt (1 - c²)) by (replace (c²) with (c ^ 2) by (unfold Rsqr; ring); unfold Rdiv; ring).
    apply (is_derive_minus (V := R_NormedModule) (fun c => RInt (e_term c) (-1) 1) (fun c => PI * asin c)); [apply Dt, Hc |].
    apply (is_derive_scal asin). apply is_derive_Reals. replace (/ sqrt (1 - c²)) with (1 / sqrt (1 - c²)) by (unfold Rdiv; ring).
    rewrite <- (derive_pt_asin c Hc). exact (proj2_sig (derivable_pt_asin c Hc)). }
  assert (Gc : forall c, -1 < c < 1 -> continuous G c) by (intros c Hc; apply (@ex_derive_continuous R_AbsRing R_NormedModule); exists 0; apply Gd, Hc).
  assert (E : G k = G 0).
  { destruct (Rle_lt_dec k 0) as [L | L].
    - apply constant_between; [exact L | intros; apply Gd; lra | intros; apply Gc; lra].
    - symmetry. apply constant_between; [lra | intros; apply Gd; lra | intros; apply Gc; lra]. }
  unfold G in E. rewrite Zero, asin_0 in E. lra.
Qed.
Lemma asin_half : asin (1 / 2) = PI / 6.
Proof. rewrite <- sin_PI6. apply asin_sin. generalize PI_RGT_0. lra. Qed.

(* What the equation of the contact problem needs of both functions. *)
Theorem dilogarithm_inverse y : 0 < y <= 1 ->
  dilogarithm (/ y) - dilogarithm (- / y) + (dilogarithm y - dilogarithm (- y)) = PI ^ 2 / 2.
Proof.
  intros Hy. assert (P := inverse_pair y Hy). assert (C := cubic). rewrite e_total, asin_half in C by lra. unfold X, D in *. lra.
Qed.
End Dilogarithm.
