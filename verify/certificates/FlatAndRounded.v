(* SPDX-License-Identifier: GPL-3.0-or-later *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact.
Open Scope R_scope.

(* g'(x) of a flat punch of half-width t whose edges are rounded with the radius R0. *)
Definition slope (t R0 x : R) : R :=
  if Rlt_dec t x then (x - t) / R0 else if Rlt_dec x (- t) then (x + t) / R0 else 0.

Section Solution.
Variables Es t R0 : R.
Hypothesis Ht : 0 < t.
Hypothesis HR : 0 < R0.

Lemma place_symmetric (s theta : R) : place s s theta = s * sin theta.
Proof. unfold place. field. Qed.

Lemma slope_right x : t < x -> slope t R0 x = (x - t) / R0.
Proof. intros H. unfold slope. destruct (Rlt_dec t x); lra. Qed.
Lemma slope_left x : x < - t -> slope t R0 x = (x + t) / R0.
Proof. intros H. unfold slope. destruct (Rlt_dec t x); [lra|]. destruct (Rlt_dec x (- t)); lra. Qed.
Lemma slope_flat x : - t < x < t -> slope t R0 x = 0.
Proof. intros H. unfold slope. destruct (Rlt_dec t x); [lra|]. destruct (Rlt_dec x (- t)); lra. Qed.

Variable s : R.
Hypothesis Hs : t < s.

Let th := asin (t / s).

Lemma ratio : 0 < t / s < 1.
Proof.
  split. { apply Rdiv_lt_0_compat; lra. }
  apply (Rmult_lt_reg_r s); try lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

Lemma th_sin : s * sin th = t.
Proof. unfold th. rewrite sin_asin by (generalize ratio; lra). field. lra. Qed.

Lemma th_range : 0 < th < PI / 2.
Proof.
  generalize ratio; intros Hr. unfold th. split.
  - apply sin_increasing_0; try (generalize (asin_bound (t / s)) PI_RGT_0; lra).
    rewrite sin_0, sin_asin by lra. lra.
  - apply asin_bound_lt. lra.
Qed.

Lemma above theta : th < theta < PI / 2 -> t < s * sin theta.
Proof.
  intros H. generalize th_range th_sin; intros Hth Hsin. rewrite <- Hsin at 1.
  apply Rmult_lt_compat_l; [lra|]. apply sin_increasing_1; lra.
Qed.
Lemma below theta : - (PI / 2) < theta < - th -> s * sin theta < - t.
Proof.
  intros H. assert (Hn := above (- theta) ltac:(lra)). rewrite sin_neg in Hn. lra.
Qed.
Lemma between theta : - th < theta < th -> - t < s * sin theta < t.
Proof.
  intros H. generalize th_range th_sin; intros Hth Hsin.
  assert (sin theta < sin th) by (apply sin_increasing_1; lra).
  assert (sin (- th) < sin theta) by (apply sin_increasing_1; lra).
  rewrite sin_neg in *. nra.
Qed.

(* The sum of three parts: left arc, flat, right arc. *)
Lemma by_parts (f hl hr Hl Hr : R -> R) (l : R) :
  (forall theta, - (PI / 2) < theta < - th -> f theta = hl theta) ->
  (forall theta, - th < theta < th -> f theta = 0) ->
  (forall theta, th < theta < PI / 2 -> f theta = hr theta) ->
  (forall theta, is_derive Hl theta (hl theta) /\ continuous hl theta) ->
  (forall theta, is_derive Hr theta (hr theta) /\ continuous hr theta) ->
  (Hl (- th) - Hl (- (PI / 2))) + (Hr (PI / 2) - Hr th) = l ->
  is_RInt f (- (PI / 2)) (PI / 2) l.
Proof.
  intros H1 H2 H3 H4 H5 <-. generalize th_range; intros Hth.
  replace (Hl (- th) - Hl (- (PI / 2)) + (Hr (PI / 2) - Hr th))
    with (plus (Hl (- th) - Hl (- (PI / 2))) (plus (0 - 0) (Hr (PI / 2) - Hr th)))
    by (unfold plus; simpl; ring).
  apply (is_RInt_Chasles f _ (- th)).
  { apply (is_RInt_antiderivative f hl Hl); try lra; intros; try apply H4. apply H1; lra. }
  apply (is_RInt_Chasles f _ th).
  { apply (is_RInt_antiderivative f (fun _ => 0) (fun _ => 0)); try lra; intros.
    - apply H2; lra.
    - auto_derive; trivial.
    - apply continuous_const. }
  apply (is_RInt_antiderivative f hr Hr); try lra; intros; try apply H5. apply H3; lra.
Qed.

Ltac derive := split; [auto_derive; [repeat split; lra | field; lra]
                      | apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; repeat split; lra].

Lemma symmetric_consistent : consistent (slope t R0) s s.
Proof.
  apply (by_parts _ (fun theta => (s * sin theta + t) / R0) (fun theta => (s * sin theta - t) / R0)
                    (fun theta => (- s * cos theta + t * theta) / R0) (fun theta => (- s * cos theta - t * theta) / R0)).
  - intros theta H. rewrite place_symmetric. rewrite slope_left; [reflexivity | apply below, H].
  - intros theta H. rewrite place_symmetric. apply slope_flat, between, H.
  - intros theta H. rewrite place_symmetric. rewrite slope_right; [reflexivity | apply above, H].
  - intros theta. derive.
  - intros theta. derive.
  - rewrite !cos_neg. field. lra.
Qed.

Lemma load_value : is_load Es (slope t R0) s s
  (Es * s ^ 2 / R0 * (PI / 4 - asin (t / s) / 2 - t / (2 * s ^ 2) * sqrt (s ^ 2 - t ^ 2))).
Proof.
  unfold is_load.
  replace (Es * s ^ 2 / R0 * (PI / 4 - asin (t / s) / 2 - t / (2 * s ^ 2) * sqrt (s ^ 2 - t ^ 2)))
    with (scal (Es / 2) (2 * (s ^ 2 * (PI / 4 - asin (t / s) / 2) - t / 2 * sqrt (s ^ 2 - t ^ 2)) / R0))
    by (unfold scal; simpl; unfold mult; simpl; field; split; lra).
  apply (is_RInt_scal (fun theta => place s s theta * slope t R0 (place s s theta))).
  apply (by_parts _ (fun theta => s * sin theta * (s * sin theta + t) / R0) (fun theta => s * sin theta * (s * sin theta - t) / R0)
    (fun theta => (s ^ 2 * (theta / 2 - sin theta * cos theta / 2) - s * t * cos theta) / R0)
    (fun theta => (s ^ 2 * (theta / 2 - sin theta * cos theta / 2) + s * t * cos theta) / R0)).
  - intros theta H. rewrite place_symmetric. rewrite slope_left; [field; lra | apply below, H].
  - intros theta H. rewrite place_symmetric. rewrite slope_flat; [ring | apply between, H].
  - intros theta H. rewrite place_symmetric. rewrite slope_right; [field; lra | apply above, H].
  - intros theta. split.
    + auto_derive; [trivial|]. replace (cos theta * cos theta) with (1 - sin theta * sin theta)
        by (generalize (sin2_cos2 theta); unfold Rsqr; lra). field_simplify; [|lra|lra].
      replace (cos theta ^ 2) with (1 - sin theta ^ 2) by (generalize (sin2_cos2 theta); unfold Rsqr; nra). field. lra.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - intros theta. split.
    + auto_derive; [trivial|]. field_simplify; [|lra|lra].
      replace (cos theta ^ 2) with (1 - sin theta ^ 2) by (generalize (sin2_cos2 theta); unfold Rsqr; nra). field. lra.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - rewrite !sin_neg, !cos_neg, sin_PI2, cos_PI2.
    assert (Hcos : s * cos th = sqrt (s ^ 2 - t ^ 2)).
    { unfold th. rewrite cos_asin by (generalize ratio; lra).
      replace s with (sqrt (s ^ 2)) at 1 by (apply sqrt_pow2; lra).
      rewrite <- sqrt_mult by (try nra; generalize ratio; unfold Rsqr; nra).
      f_equal. unfold Rsqr. field. lra. }
    assert (Hsin := th_sin). fold th. rewrite <- Hcos.
    replace (s ^ 2 * (- th / 2 - - sin th * cos th / 2)) with (- s ^ 2 * th / 2 + (s * sin th) * (s * cos th) / 2) by field.
    replace (s ^ 2 * (th / 2 - sin th * cos th / 2)) with (s ^ 2 * th / 2 - (s * sin th) * (s * cos th) / 2) by field.
    rewrite Hsin. field. lra.
Qed.

End Solution.

(* P'(s), in the form that the tactic for real inequalities reads. *)
Definition load_rate (Es t R0 s : R) : R := Es * s / R0 * (PI / 2 - atan (t / sqrt (s ^ 2 - t ^ 2))).

Section Pressure.
Variables Es t R0 : R.
Hypothesis Ht : 0 < t.
Hypothesis HR : 0 < R0.

Definition load_of (s : R) : R :=
  Es * s ^ 2 / R0 * (PI / 4 - atan (t / sqrt (s ^ 2 - t ^ 2)) / 2 - t / (2 * s ^ 2) * sqrt (s ^ 2 - t ^ 2)).

Lemma load_derive s : t < s -> is_derive load_of s (load_rate Es t R0 s).
Proof.
  intros Hs. unfold load_of.
  assert (Hd : 0 < s ^ 2 - t ^ 2).
  { replace (s ^ 2 - t ^ 2) with ((s - t) * (s + t)) by ring. apply Rmult_lt_0_compat; lra. }
    assert (Hq : 0 < sqrt (s ^ 2 - t ^ 2)) by (apply sqrt_lt_R0, Hd).
    unfold load_rate.
    change (s ^ 2 - t ^ 2) with (s ^ 2 + - t ^ 2) in *.
    auto_derive; change (s * (s * 1)) with (s ^ 2) in *; change (t * (t * 1)) with (t ^ 2) in *.
    + repeat split; try lra; try nra; apply Rgt_not_eq; lra.
    + set (q := sqrt (s ^ 2 + - t ^ 2)) in *.
      assert (Hqq : q ^ 2 = s ^ 2 - t ^ 2) by (unfold q; apply pow2_sqrt; lra).
      replace (1 + t * / q * (t * / q * 1)) with (s ^ 2 / q ^ 2) by (rewrite Hqq at 1; field_simplify_eq; [rewrite Hqq; ring | nra]).
      change (t * / q) with (t / q). generalize (atan (t / q)). intros A.
      field_simplify_eq; [| repeat split; lra].
      replace (q ^ 4) with ((q ^ 2) * (q ^ 2)) by ring.
      try ring [Hqq].
Qed.

Lemma load_rate_continuous s : t < s -> continuous (load_rate Es t R0) s.
Proof.
  intros Hs. apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold load_rate.
  assert (Hd : 0 < s ^ 2 + - t ^ 2).
  { replace (s ^ 2 + - t ^ 2) with ((s - t) * (s + t)) by ring. apply Rmult_lt_0_compat; lra. }
  auto_derive. change (s * (s * 1)) with (s ^ 2). change (t * (t * 1)) with (t ^ 2).
  repeat split; try lra. apply Rgt_not_eq, sqrt_lt_R0, Hd.
Qed.

(* The pressure beyond the flat. *)
Theorem pressure_beyond_the_flat a x : t < x < a ->
  is_pressure Es (slope t R0) a x
    (RInt (fun w => 2 / PI * (load_rate Es t R0 (x + w ^ 2) / sqrt (x + (x + w ^ 2)))) 0 (sqrt (a - x))).
Proof.
  intros Hx. exists load_of, (load_rate Es t R0), (fun s => s). split.
  - intros s Hs. split; [| split; [| split]].
    + lra.
    + apply symmetric_consistent; lra.
    + apply (locally_near s (s - t)); [lra |]. intros r Hr. unfold load_of.
      rewrite <- (asin_sqrt t r) by lra. apply load_value; lra.
    + apply load_derive; lra.
  - refine (pressure_by_square (load_rate Es t R0) (fun s => s) x a _ _ _ _).
    + lra.
    + intros s Hs. apply load_rate_continuous; lra.
    + intros s Hs. apply continuous_id.
    + intros s Hs. lra.
Qed.
End Pressure.

(* The integral that the pressure is printed with. *)
Lemma rounded_integral t a x : 0 < t < x -> x < a ->
  is_improper_integral (fun s => (PI / 2 - asin (t / s)) * s / sqrt (s ^ 2 - x ^ 2)) (Rmax x t) a
    (RInt (fun w => 2 * (PI / 2 - atan (t / sqrt ((x + w ^ 2) ^ 2 - t ^ 2))) * (x + w ^ 2) / sqrt (2 * x + w ^ 2))
      0 (sqrt (a - x))).
Proof.
  intros Ht Hx. rewrite Rmax_left by lra.
  assert (Hd : forall s, t < s -> 0 < s ^ 2 + - t ^ 2).
  { intros s Hs. replace (s ^ 2 + - t ^ 2) with ((s - t) * (s + t)) by ring. apply Rmult_lt_0_compat; lra. }
  apply (improper_by_square _ (fun w => 2 * (PI / 2 - atan (t / sqrt ((x + w ^ 2) ^ 2 - t ^ 2))) * (x + w ^ 2) / sqrt (2 * x + w ^ 2))).
  - exact Hx.
  - intros w Hw. assert (Hw2 : 0 < w ^ 2) by (apply pow_lt; lra).
    rewrite asin_sqrt by lra.
    replace ((x + w ^ 2) ^ 2 - x ^ 2) with (w ^ 2 * (2 * x + w ^ 2)) by ring.
    rewrite (sqrt_mult (w ^ 2) (2 * x + w ^ 2)) by lra. rewrite (sqrt_pow2 w) by lra.
    field. split; [apply Rgt_not_eq, sqrt_lt_R0; lra | lra].
  - intros w Hw. assert (Hw2 : 0 <= w ^ 2) by apply pow2_ge_0.
    assert (Hd1 := Hd (x + w ^ 2) ltac:(lra)).
    assert (Hq : 0 < sqrt ((x + w ^ 2) ^ 2 + - t ^ 2)) by (apply sqrt_lt_R0, Hd1).
    assert (Hp : 0 < sqrt (2 * x + w ^ 2)) by (apply sqrt_lt_R0; lra).
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold Rminus. auto_derive.
    repeat split; try (apply Rgt_not_eq); try exact Hq; try exact Hd1; try exact Hp.
    change (0 < 2 * x + w ^ 2). lra.
  - intros s Hs.
    assert (Hd1 := Hd s ltac:(lra)).
    assert (Hq : 0 < sqrt (s ^ 2 + - t ^ 2)) by (apply sqrt_lt_R0, Hd1).
    assert (Hd2 : 0 < s ^ 2 + - x ^ 2).
    { replace (s ^ 2 + - x ^ 2) with ((s - x) * (s + x)) by ring. apply Rmult_lt_0_compat; lra. }
    assert (Hp : 0 < sqrt (s ^ 2 + - x ^ 2)) by (apply sqrt_lt_R0, Hd2).
    apply (continuous_ext_loc _ (fun s => (PI / 2 - atan (t / sqrt (s ^ 2 + - t ^ 2))) * s / sqrt (s ^ 2 + - x ^ 2))).
    + apply (locally_near s (s - t)); [lra |]. intros r Hr. rewrite asin_sqrt by lra. reflexivity.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive.
      repeat split; try (apply Rgt_not_eq); try exact Hq; try exact Hd1; try exact Hp; try exact Hd2.
Qed.

From Edgeproof Require Import Coefficients Edges.

Section Edge.
Variables Es t R0 a : R.
Hypothesis Ht : 0 < t.
Hypothesis HR : 0 < R0.
Hypothesis Ha : t < a.

Definition load_rate_2 (s : R) : R :=
  Es / R0 * (PI / 2 - atan (t / sqrt (s ^ 2 - t ^ 2)) + t / sqrt (s ^ 2 - t ^ 2)).
Definition load_rate_3 (s : R) : R :=
  Es / R0 * (t / (s * sqrt (s ^ 2 - t ^ 2)) - t * s / ((s ^ 2 - t ^ 2) * sqrt (s ^ 2 - t ^ 2))).

Lemma root_positive s : t < s -> 0 < s ^ 2 + - t ^ 2.
Proof.
  intros Hs. replace (s ^ 2 + - t ^ 2) with ((s - t) * (s + t)) by ring. apply Rmult_lt_0_compat; lra.
Qed.

Ltac in_root s Hd Hq q :=
  change (s * (s * 1)) with (s ^ 2) in *; change (t * (t * 1)) with (t ^ 2) in *;
  set (q := sqrt (s ^ 2 + - t ^ 2)) in *.

Theorem smooth_contact : is_smooth_contact Es (slope t R0) a (load_of Es t R0) (load_rate Es t R0)
  load_rate_2 load_rate_3 (fun s => s) (fun _ => 1) (fun _ => 0).
Proof.
  exists ((a - t) / 2). split; [lra |]. intros s Hs.
  assert (Hts : t < s) by lra.
  assert (Hd := root_positive s Hts).
  assert (Hq : 0 < sqrt (s ^ 2 + - t ^ 2)) by (apply sqrt_lt_R0, Hd).
  assert (Hqq : sqrt (s ^ 2 + - t ^ 2) ^ 2 = s ^ 2 - t ^ 2) by (apply pow2_sqrt; lra).
  split; [| split; [| split; [| split; [| split; [| split; [| split]]]]]].
  - split; [lra | split; [| split]].
    + apply symmetric_consistent; lra.
    + apply (locally_near s (s - t)); [lra |]. intros r Hr. unfold load_of.
      rewrite <- (asin_sqrt t r) by lra. apply load_value; lra.
    + apply load_derive; lra.
  - unfold load_rate, load_rate_2. change (s ^ 2 - t ^ 2) with (s ^ 2 + - t ^ 2) in *. auto_derive.
    + change (s * (s * 1)) with (s ^ 2). change (t * (t * 1)) with (t ^ 2). repeat split; try lra. 
    + in_root s Hd Hq q.
      replace (1 + t * / q * (t * / q * 1)) with (s ^ 2 / q ^ 2) by (rewrite Hqq at 1; field_simplify_eq; [rewrite Hqq; ring | nra]).
      change (t * / q) with (t / q). generalize (atan (t / q)). intros A.
      field_simplify_eq; [| repeat split; lra]. ring [Hqq].
  - unfold load_rate_2, load_rate_3. change (s ^ 2 - t ^ 2) with (s ^ 2 + - t ^ 2) in *. auto_derive.
    + change (s * (s * 1)) with (s ^ 2). change (t * (t * 1)) with (t ^ 2). repeat split; try lra.
    + in_root s Hd Hq q.
      replace (1 + t * / q * (t * / q * 1)) with (s ^ 2 / q ^ 2) by (rewrite Hqq at 1; field_simplify_eq; [rewrite Hqq; ring | nra]).
      replace (s ^ 2 + - t ^ 2) with (q ^ 2) by (rewrite Hqq; ring).
      field. repeat split; lra.
  - apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold load_rate_3.
    change (s ^ 2 - t ^ 2) with (s ^ 2 + - t ^ 2) in *. auto_derive.
    change (s * (s * 1)) with (s ^ 2). change (t * (t * 1)) with (t ^ 2).
    assert (0 < s * sqrt (s ^ 2 + - t ^ 2)) by (apply Rmult_lt_0_compat; lra).
    assert (0 < (s ^ 2 + - t ^ 2) * sqrt (s ^ 2 + - t ^ 2)) by (apply Rmult_lt_0_compat; lra).
    repeat split; lra.
  - auto_derive; trivial.
  - auto_derive; trivial.
  - apply continuous_const.
  - lra.
Qed.
End Edge.
