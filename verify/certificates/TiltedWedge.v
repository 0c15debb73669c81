(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm.
Open Scope R_scope.

(* g'(x) of a wedge of the outer angles phi, tilted by alpha. *)
Definition slope (phi alpha x : R) : R :=
  if Rlt_dec x 0 then - (phi + alpha) else phi - alpha.

Section Solution.
Variables Es phi gam : R.
Hypothesis Hphi : 0 < phi.
Hypothesis Hgam : 0 < gam.
(* The tilt by which b/a = gam. *)
Definition tilt : R := 2 * phi / PI * asin ((1 - gam) / (1 + gam)).

Let k := (1 - gam) / (1 + gam).
Lemma k_range : -1 < k < 1.
Proof.
  unfold k. split; apply (Rmult_lt_reg_r (1 + gam)); try lra; unfold Rdiv;
    rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.

Variable s : R.
Hypothesis Hs : 0 < s.
Let th := - asin k.
Lemma th_range : - (PI / 2) < th < PI / 2.
Proof. unfold th. generalize (asin_bound_lt k k_range). lra. Qed.
Lemma th_sin : sin th = - k.
Proof. unfold th. rewrite sin_neg, sin_asin by (generalize k_range; lra). reflexivity. Qed.
Lemma place_sin theta : place s (gam * s) theta = s * (1 + gam) / 2 * (k + sin theta).
Proof. unfold place, k. field. lra. Qed.

Lemma positive theta : th < theta < PI / 2 -> 0 < place s (gam * s) theta.
Proof.
  intros H. generalize th_range th_sin; intros Ht Hsin. rewrite place_sin.
  assert (sin th < sin theta) by (apply sin_increasing_1; lra).
  apply Rmult_lt_0_compat; [| lra]. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra.
Qed.
Lemma negative theta : - (PI / 2) < theta < th -> place s (gam * s) theta < 0.
Proof.
  intros H. generalize th_range th_sin; intros Ht Hsin. rewrite place_sin.
  assert (sin theta < sin th) by (apply sin_increasing_1; lra).
  assert (0 < s * (1 + gam) / 2) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra).
  nra.
Qed.

Lemma by_parts (f hl hr Hl Hr : R -> R) (l : R) :
  (forall theta, - (PI / 2) < theta < th -> f theta = hl theta) ->
  (forall theta, th < theta < PI / 2 -> f theta = hr theta) ->
  (forall theta, is_derive Hl theta (hl theta) /\ continuous hl theta) ->
  (forall theta, is_derive Hr theta (hr theta) /\ continuous hr theta) ->
  (Hl th - Hl (- (PI / 2))) + (Hr (PI / 2) - Hr th) = l ->
  is_RInt f (- (PI / 2)) (PI / 2) l.
Proof.
  intros H1 H3 H4 H5 <-. generalize th_range; intros Hth.
  change (Hl th - Hl (- (PI / 2)) + (Hr (PI / 2) - Hr th)) with (plus (Hl th - Hl (- (PI / 2))) (Hr (PI / 2) - Hr th)).
  apply (is_RInt_Chasles f _ th).
  - apply (is_RInt_antiderivative f hl Hl); try lra; intros; try apply H4. apply H1; lra.
  - apply (is_RInt_antiderivative f hr Hr); try lra; intros; try apply H5. apply H3; lra.
Qed.

Ltac derive := split; [auto_derive; [trivial | field; lra]
                      | apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; trivial].

Lemma th_tilt : tilt = - (2 * phi / PI * th).
Proof. unfold tilt, th. fold k. field. apply PI_neq0. Qed.

Lemma wedge_consistent : consistent (slope phi tilt) s (gam * s).
Proof.
  assert (Hpi := PI_RGT_0).
  apply (by_parts _ (fun _ => - (phi + tilt)) (fun _ => phi - tilt) (fun theta => - (phi + tilt) * theta) (fun theta => (phi - tilt) * theta)).
  - intros theta H. unfold slope. destruct (Rlt_dec _ 0); [reflexivity | generalize (negative theta H); lra].
  - intros theta H. unfold slope. destruct (Rlt_dec _ 0); [generalize (positive theta H); lra | reflexivity].
  - intros theta. derive.
  - intros theta. derive.
  - rewrite th_tilt. field. lra.
Qed.

Lemma wedge_load : is_load Es (slope phi tilt) s (gam * s) (Es * phi * sqrt gam * s).
Proof.
  assert (Hpi := PI_RGT_0). unfold is_load.
  set (m := (s - gam * s) / 2). set (h := (s + gam * s) / 2).
  apply (by_parts _ (fun theta => Es / 2 * ((m + h * sin theta) * - (phi + tilt))) (fun theta => Es / 2 * ((m + h * sin theta) * (phi - tilt)))
    (fun theta => Es / 2 * ((m * theta - h * cos theta) * - (phi + tilt))) (fun theta => Es / 2 * ((m * theta - h * cos theta) * (phi - tilt)))).
  - intros theta H. unfold slope. destruct (Rlt_dec _ 0); [reflexivity | generalize (negative theta H); lra].
  - intros theta H. unfold slope. destruct (Rlt_dec _ 0); [generalize (positive theta H); lra | reflexivity].
  - intros theta. derive.
  - intros theta. derive.
  - rewrite cos_neg, cos_PI2, th_tilt.
    assert (Hc : h * cos th = sqrt gam * s).
    { unfold th. rewrite cos_neg, cos_asin by (generalize k_range; lra).
      replace (1 - k²) with (4 * gam / (1 + gam) ^ 2) by (unfold k, Rsqr; field; lra).
      rewrite sqrt_div_alt by (apply pow_lt; lra). rewrite (sqrt_pow2 (1 + gam)) by lra.
      rewrite sqrt_mult by lra. replace 4 with (2 ^ 2) by ring. rewrite (sqrt_pow2 2) by lra.
      unfold h. field. lra. }
    replace (Es * phi * sqrt gam * s) with (Es * phi * (h * cos th)) by (rewrite Hc; ring).
    unfold m. field. lra.
Qed.
End Solution.

Section Edges.
Variables Es phi gam a : R.
Hypothesis Hphi : 0 < phi.
Hypothesis Hgam : 0 < gam.
Hypothesis Ha : 0 < a.

Lemma wedge_contact_at s : 0 < s ->
  is_contact_at Es (slope phi (tilt phi gam)) (fun s => Es * phi * sqrt gam * s) (fun _ => Es * phi * sqrt gam) (fun s => gam * s) s.
Proof.
  intros Hs. split; [nra | split; [| split]].
  - apply wedge_consistent; assumption.
  - apply (locally_near s s); [lra |]. intros r Hr. apply wedge_load; lra.
  - auto_derive; [trivial | ring].
Qed.

Theorem smooth_contact : is_smooth_contact Es (slope phi (tilt phi gam)) a
  (fun s => Es * phi * sqrt gam * s) (fun _ => Es * phi * sqrt gam) (fun _ => 0) (fun _ => 0)
  (fun s => gam * s) (fun _ => gam) (fun _ => 0).
Proof.
  exists (a / 2). split; [lra |]. intros s Hs.
  split; [apply wedge_contact_at; lra |].
  assert (0 < gam * s) by (apply Rmult_lt_0_compat; lra).
  repeat match goal with |- _ /\ _ => split end; try apply continuous_const; try lra;
    auto_derive; trivial; ring.
Qed.

Theorem left_of_a : is_left_edge a (fun s => gam * s) (fun _ => gam) (fun _ => 0) (fun _ => 0) (fun r => r / gam).
Proof.
  split; [field; lra |]. exists a. split; [exact Ha | split].
  - intros s Hs. split; [exact Hgam | split; [auto_derive; [trivial | ring] | apply continuous_const]].
  - intros r Hr. split; [field; lra |]. auto_derive; [lra | field; lra].
Qed.

(* The pressure right of the apex. *)
Theorem pressure_right_of_apex x : 0 < x < a ->
  is_pressure Es (slope phi (tilt phi gam)) a x (proportional_pressure (Es * phi * sqrt gam) gam a x).
Proof.
  intros Hx. exists (fun s => Es * phi * sqrt gam * s), (fun _ => Es * phi * sqrt gam), (fun s => gam * s). split.
  - intros s Hs. apply wedge_contact_at. lra.
  - apply proportional_integral; assumption.
Qed.

(* The same of the mirrored wedge, whose right edge is at a: left of the apex. *)
Theorem pressure_left_of_apex x : 0 < x < a ->
  is_pressure Es (mirrored (slope phi (tilt phi gam))) a x (proportional_pressure (Es * phi * sqrt gam / gam) (/ gam) a x).
Proof.
  intros Hx. assert (Hi := Rinv_0_lt_compat gam Hgam).
  exists (fun r => Es * phi * sqrt gam * (r / gam)), (fun _ => Es * phi * sqrt gam / gam), (fun r => / gam * r). split.
  - intros r Hr. assert (Hs : 0 < r / gam) by (apply Rdiv_lt_0_compat; lra).
    assert (E : forall z, gam * (z / gam) = z) by (intros z; field; lra).
    destruct (wedge_contact_at (r / gam) Hs) as (_ & Hc & Hload & _).
    split; [nra | split; [| split]].
    + apply consistent_mirrored in Hc. rewrite E in Hc. replace (/ gam * r) with (r / gam) by (field; lra). exact Hc.
    + apply (locally_near r r); [lra |]. intros z Hz. assert (0 < z / gam) by (apply Rdiv_lt_0_compat; lra).
      assert (L := load_mirrored _ _ _ _ _ (wedge_load Es phi gam Hgam (z / gam) ltac:(assumption))). rewrite E in L.
      replace (/ gam * z) with (z / gam) by (field; lra). exact L.
    + auto_derive; [trivial | field; lra].
  - apply proportional_integral; assumption.
Qed.
End Edges.

(* b/a of a wedge tilted by alpha. *)
Definition ratio_of (phi alpha : R) : R :=
  (1 - sin (PI / 2 * (alpha / phi))) / (1 + sin (PI / 2 * (alpha / phi))).
Lemma tilt_of_ratio phi alpha : - phi < alpha < phi -> 0 < ratio_of phi alpha /\ tilt phi (ratio_of phi alpha) = alpha.
Proof.
  intros H. assert (Hpi := PI_RGT_0). unfold ratio_of. set (z := PI / 2 * (alpha / phi)).
  assert (Hz : - (PI / 2) < z < PI / 2).
  { assert (-1 < alpha / phi < 1).
    { split; apply (Rmult_lt_reg_r phi); try lra; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
    unfold z. split; nra. }
  assert (Hs : -1 < sin z < 1).
  { assert (H1 : sin z < sin (PI / 2)) by (apply sin_increasing_1; lra).
    assert (H2 : sin (- (PI / 2)) < sin z) by (apply sin_increasing_1; lra).
    rewrite sin_neg, sin_PI2 in *. lra. }
  split; [apply Rdiv_lt_0_compat; lra |]. unfold tilt.
  replace ((1 - (1 - sin z) / (1 + sin z)) / (1 + (1 - sin z) / (1 + sin z))) with (sin z) by (field; lra).
  rewrite asin_sin by lra. unfold z. field. lra.
Qed.

(* The angle of the tilt in a printed formula for the ratio of the edges. *)
Lemma sin_of_tilt phi gam : 0 < phi -> 0 < gam -> sin (PI * tilt phi gam / (2 * phi)) = (1 - gam) / (1 + gam).
Proof.
  intros Hphi Hgam. assert (Hpi := PI_RGT_0). unfold tilt.
  replace (PI * (2 * phi / PI * asin ((1 - gam) / (1 + gam))) / (2 * phi)) with (asin ((1 - gam) / (1 + gam))) by (field; lra).
  apply sin_asin. generalize (k_range gam Hgam). lra.
Qed.
