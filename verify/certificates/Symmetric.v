(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Coq Require Import List.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm.
Open Scope R_scope.

(* A part of the g' of a symmetric punch: nothing up to the distance `from` from the middle, and
   corner + curvature (x - from) beyond it. A wedge, a parabola and a flat punch with rounded edges
   have one each (Part 0 phi 0, Part 0 0 C, Part t 0 (1 / R)); every symmetric g' that is piecewise
   linear is a sum of such parts. *)
Record part := Part { from : R; corner : R; curvature : R }.
Definition part_slope (q : part) (x : R) : R :=
  if Rlt_dec (from q) x then corner q + curvature q * (x - from q)
  else if Rlt_dec x (- from q) then - (corner q + curvature q * (- x - from q)) else 0.
Definition total (f : part -> R -> R) (l : list part) (x : R) : R :=
  fold_right (fun q sum => f q x + sum) 0 l.
Definition slope : list part -> R -> R := total part_slope.

(* ---- Sums over the parts ---- *)

Lemma total_derive (f f1 : part -> R -> R) (l : list part) (s : R) :
  Forall (fun q => is_derive (f q) s (f1 q s)) l -> is_derive (total f l) s (total f1 l s).
Proof.
  induction 1 as [| q l Hq _ IH]; unfold total in *; simpl.
  - auto_derive; trivial.
  - exact (is_derive_plus _ _ _ _ _ Hq IH).
Qed.
Lemma total_continuous (f : part -> R -> R) (l : list part) (s : R) :
  Forall (fun q => continuous (f q) s) l -> continuous (total f l) s.
Proof.
  induction 1 as [| q l Hq _ IH]; unfold total in *; simpl.
  - apply continuous_const.
  - exact (continuous_add _ _ _ Hq IH).
Qed.
Lemma forall_of {A B : part -> Prop} (l : list part) : (forall q, A q -> B q) -> Forall A l -> Forall B l.
Proof. intros H. apply Forall_impl. exact H. Qed.

(* ---- One part: consistency and load ---- *)

Section Part.
Variables Es t d k s : R.
Hypothesis Ht : 0 <= t.
Hypothesis Hs : t < s.
Let q := Part t d k.
Let th := asin (t / s).

Lemma place_symmetric theta : place s s theta = s * sin theta.
Proof. unfold place. field. Qed.
Lemma ratio : 0 <= t / s < 1.
Proof.
  split. { apply Rmult_le_pos; [lra |]. apply Rlt_le, Rinv_0_lt_compat. lra. }
  apply (Rmult_lt_reg_r s); try lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
Lemma th_sin : s * sin th = t.
Proof. unfold th. rewrite sin_asin by (generalize ratio; lra). field. lra. Qed.
Lemma th_range : 0 <= th < PI / 2.
Proof.
  generalize ratio; intros Hr. assert (Hb := asin_bound_lt (t / s) ltac:(lra)). unfold th in *.
  split; [| lra]. destruct (Rle_lt_or_eq_dec 0 (t / s) ltac:(lra)) as [H | H].
  - apply Rlt_le, sin_increasing_0; try (generalize (asin_bound (t / s)) PI_RGT_0; lra).
    rewrite sin_0, sin_asin by lra. lra.
  - rewrite <- H, asin_0. lra.
Qed.
Lemma above theta : th < theta < PI / 2 -> t < s * sin theta.
Proof.
  intros H. generalize th_range th_sin; intros Hth Hsin. rewrite <- Hsin at 1.
  apply Rmult_lt_compat_l; [lra|]. apply sin_increasing_1; lra.
Qed.
Lemma below theta : - (PI / 2) < theta < - th -> s * sin theta < - t.
Proof. intros H. assert (Hn := above (- theta) ltac:(lra)). rewrite sin_neg in Hn. lra. Qed.
Lemma between theta : - th < theta < th -> - t < s * sin theta < t.
Proof.
  intros H. generalize th_range th_sin; intros Hth Hsin.
  assert (sin theta < sin th) by (apply sin_increasing_1; lra).
  assert (sin (- th) < sin theta) by (apply sin_increasing_1; lra).
  rewrite sin_neg in *. nra.
Qed.

(* The sum over the left side, the middle and the right side. *)
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

Lemma slope_right x : t < x -> part_slope q x = d + k * (x - t).
Proof. intros H. unfold part_slope; simpl. destruct (Rlt_dec t x); lra. Qed.
Lemma slope_left x : x < - t -> part_slope q x = - d + k * (x + t).
Proof. intros H. unfold part_slope; simpl. destruct (Rlt_dec t x); [lra|]. destruct (Rlt_dec x (- t)); lra. Qed.
Lemma slope_flat x : - t < x < t -> part_slope q x = 0.
Proof. intros H. unfold part_slope; simpl. destruct (Rlt_dec t x); [lra|]. destruct (Rlt_dec x (- t)); lra. Qed.

Ltac derive := split; [auto_derive; [trivial | ring]
                      | apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; trivial].

Lemma part_consistent : consistent (part_slope q) s s.
Proof.
  apply (by_parts _ (fun theta => - d + k * (s * sin theta + t)) (fun theta => d + k * (s * sin theta - t))
    (fun theta => - d * theta + k * (- s * cos theta + t * theta)) (fun theta => d * theta + k * (- s * cos theta - t * theta))).
  - intros theta H. rewrite place_symmetric. apply slope_left, below, H.
  - intros theta H. rewrite place_symmetric. apply slope_flat, between, H.
  - intros theta H. rewrite place_symmetric. apply slope_right, above, H.
  - intros theta. derive.
  - intros theta. derive.
  - rewrite !cos_neg. field.
Qed.

Lemma cos_th : s * cos th = sqrt (s ^ 2 - t ^ 2).
Proof.
  unfold th. rewrite cos_asin by (generalize ratio; lra).
  replace s with (sqrt (s ^ 2)) at 1 by (apply sqrt_pow2; lra).
  rewrite <- sqrt_mult by (try nra; generalize ratio; unfold Rsqr; nra).
  f_equal. unfold Rsqr. field. lra.
Qed.
Lemma part_load_value : is_load Es (part_slope q) s s
  (Es * (d * sqrt (s ^ 2 - t ^ 2) + k * (s ^ 2 * (PI / 4 - asin (t / s) / 2) - t / 2 * sqrt (s ^ 2 - t ^ 2)))).
Proof.
  unfold is_load. fold th.
  replace (Es * (d * sqrt (s ^ 2 - t ^ 2) + k * (s ^ 2 * (PI / 4 - th / 2) - t / 2 * sqrt (s ^ 2 - t ^ 2))))
    with (scal (Es / 2) (2 * (d * sqrt (s ^ 2 - t ^ 2) + k * (s ^ 2 * (PI / 4 - th / 2) - t / 2 * sqrt (s ^ 2 - t ^ 2)))))
    by (unfold scal; simpl; unfold mult; simpl; field).
  apply (is_RInt_scal (fun theta => place s s theta * part_slope q (place s s theta))).
  apply (by_parts _ (fun theta => s * sin theta * (- d + k * (s * sin theta + t))) (fun theta => s * sin theta * (d + k * (s * sin theta - t)))
    (fun theta => d * s * cos theta + k * (s ^ 2 * (theta / 2 - sin theta * cos theta / 2) - s * t * cos theta))
    (fun theta => - d * s * cos theta + k * (s ^ 2 * (theta / 2 - sin theta * cos theta / 2) + s * t * cos theta))).
  - intros theta H. rewrite place_symmetric, slope_left; [reflexivity | apply below, H].
  - intros theta H. rewrite place_symmetric, slope_flat; [ring | apply between, H].
  - intros theta H. rewrite place_symmetric, slope_right; [reflexivity | apply above, H].
  - intros theta. split; [| apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; trivial].
    auto_derive; [trivial |]. field_simplify.
    replace (cos theta ^ 2) with (1 - sin theta ^ 2) by (generalize (sin2_cos2 theta); unfold Rsqr; nra). field.
  - intros theta. split; [| apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; trivial].
    auto_derive; [trivial |]. field_simplify.
    replace (cos theta ^ 2) with (1 - sin theta ^ 2) by (generalize (sin2_cos2 theta); unfold Rsqr; nra). field.
  - rewrite !sin_neg, !cos_neg, sin_PI2, cos_PI2, <- cos_th.
    replace (s ^ 2 * (- th / 2 - - sin th * cos th / 2)) with (- s ^ 2 * th / 2 + (s * sin th) * (s * cos th) / 2) by field.
    replace (s ^ 2 * (th / 2 - sin th * cos th / 2)) with (s ^ 2 * th / 2 - (s * sin th) * (s * cos th) / 2) by field.
    rewrite th_sin. field.
Qed.
End Part.

(* ---- Loads and their derivatives, for contacts beyond all knots ---- *)

Definition angle (t s : R) : R := PI / 2 - atan (t / sqrt (s ^ 2 - t ^ 2)).
Definition part_load (Es : R) (q : part) (s : R) : R :=
  Es * (corner q * sqrt (s ^ 2 - from q ^ 2)
    + curvature q * (s ^ 2 / 2 * angle (from q) s - from q / 2 * sqrt (s ^ 2 - from q ^ 2))).
Definition part_rate (Es : R) (q : part) (s : R) : R :=
  Es * (corner q * s / sqrt (s ^ 2 - from q ^ 2) + curvature q * s * angle (from q) s).
Definition part_rate_2 (Es : R) (q : part) (s : R) : R :=
  Es * (- corner q * from q ^ 2 / ((s ^ 2 - from q ^ 2) * sqrt (s ^ 2 - from q ^ 2))
    + curvature q * (angle (from q) s + from q / sqrt (s ^ 2 - from q ^ 2))).
Definition part_rate_3 (Es : R) (q : part) (s : R) : R :=
  Es * (3 * corner q * from q ^ 2 * s / ((s ^ 2 - from q ^ 2) ^ 2 * sqrt (s ^ 2 - from q ^ 2))
    - curvature q * from q ^ 3 / (s * (s ^ 2 - from q ^ 2) * sqrt (s ^ 2 - from q ^ 2))).
Definition load (Es : R) (l : list part) : R -> R := total (part_load Es) l.
Definition rate (Es : R) (l : list part) : R -> R := total (part_rate Es) l.
Definition rate_2 (Es : R) (l : list part) : R -> R := total (part_rate_2 Es) l.
Definition rate_3 (Es : R) (l : list part) : R -> R := total (part_rate_3 Es) l.

(* All knots are nearer to the middle than s. *)
Definition beyond (s : R) (l : list part) : Prop := Forall (fun q => 0 <= from q < s) l.

Lemma root_positive t s : 0 <= t < s -> 0 < s ^ 2 + - t ^ 2.
Proof.
  intros H. replace (s ^ 2 + - t ^ 2) with ((s - t) * (s + t)) by ring. apply Rmult_lt_0_compat; lra.
Qed.
Ltac root t s q Hd Hq Hqq :=
  assert (Hd := root_positive t s ltac:(assumption)); assert (Hq := sqrt_lt_R0 _ Hd);
  assert (Hqq : sqrt (s ^ 2 + - t ^ 2) ^ 2 = s ^ 2 - t ^ 2) by (apply pow2_sqrt; lra).
Ltac in_root t s q Hqq :=
  change (s * (s * 1)) with (s ^ 2) in *; change (t * (t * 1)) with (t ^ 2) in *;
  set (q := sqrt (s ^ 2 + - t ^ 2)) in *.

Section Derivatives.
Variables Es t d k s : R.
Hypothesis H : 0 <= t < s.
Let q := Part t d k.

Lemma angle_derive : is_derive (angle t) s (t / (s * sqrt (s ^ 2 - t ^ 2))).
Proof.
  root t s q Hd Hq Hqq. unfold angle. change (s ^ 2 - t ^ 2) with (s ^ 2 + - t ^ 2) in *. auto_derive.
  - change (s * (s * 1)) with (s ^ 2). change (t * (t * 1)) with (t ^ 2). repeat split; lra.
  - in_root t s r Hqq.
    replace (1 + t * / r * (t * / r * 1)) with (s ^ 2 / r ^ 2) by (rewrite Hqq at 1; field_simplify_eq; [rewrite Hqq; ring | nra]).
    field. repeat split; lra.
Qed.

Lemma part_load_derive : is_derive (part_load Es q) s (part_rate Es q s).
Proof.
  root t s q Hd Hq Hqq. assert (HA := angle_derive).
  unfold part_load, part_rate; simpl. change (t * (t * 1)) with (t ^ 2). change (s * (s * 1)) with (s ^ 2).
  change (s ^ 2 - t ^ 2) with (s ^ 2 + - t ^ 2) in *. auto_derive.
  - change (s * (s * 1)) with (s ^ 2). change (t * (t * 1)) with (t ^ 2). repeat split; try lra. exists (t / (s * sqrt (s ^ 2 + - t ^ 2))). exact HA.
  - replace (Derive (fun x : R => angle t x) s) with (t / (s * sqrt (s ^ 2 + - t ^ 2))) by (symmetry; apply is_derive_unique; exact HA). in_root t s r Hqq. generalize (angle t s). intros A.
    field_simplify_eq; [| repeat split; lra]. ring [Hqq].
Qed.
Lemma part_rate_derive : is_derive (part_rate Es q) s (part_rate_2 Es q s).
Proof.
  root t s q Hd Hq Hqq. assert (HA := angle_derive).
  unfold part_rate, part_rate_2; simpl. change (t * (t * 1)) with (t ^ 2). change (s * (s * 1)) with (s ^ 2).
  change (s ^ 2 - t ^ 2) with (s ^ 2 + - t ^ 2) in *. auto_derive.
  - change (s * (s * 1)) with (s ^ 2). change (t * (t * 1)) with (t ^ 2). repeat split; try lra. exists (t / (s * sqrt (s ^ 2 + - t ^ 2))). exact HA.
  - replace (Derive (fun x : R => angle t x) s) with (t / (s * sqrt (s ^ 2 + - t ^ 2))) by (symmetry; apply is_derive_unique; exact HA). in_root t s r Hqq. generalize (angle t s). intros A.
    replace (s ^ 2 + - t ^ 2) with (r ^ 2) by (rewrite Hqq; ring).
    field_simplify_eq; [| repeat split; lra]. ring [Hqq].
Qed.
Lemma part_rate_2_derive : is_derive (part_rate_2 Es q) s (part_rate_3 Es q s).
Proof.
  root t s q Hd Hq Hqq. assert (HA := angle_derive).
  unfold part_rate_2, part_rate_3; simpl. change (t * (t * 1)) with (t ^ 2). change (s * (s * 1)) with (s ^ 2).
  change (s ^ 2 - t ^ 2) with (s ^ 2 + - t ^ 2) in *. auto_derive.
  - change (s * (s * 1)) with (s ^ 2). change (t * (t * 1)) with (t ^ 2).
    assert (0 < (s ^ 2 + - t ^ 2) * sqrt (s ^ 2 + - t ^ 2)) by (apply Rmult_lt_0_compat; lra).
    repeat split; try lra. exists (t / (s * sqrt (s ^ 2 + - t ^ 2))). exact HA.
  - replace (Derive (fun x : R => angle t x) s) with (t / (s * sqrt (s ^ 2 + - t ^ 2))) by (symmetry; apply is_derive_unique; exact HA). in_root t s r Hqq.
    replace (s ^ 2 + - t ^ 2) with (r ^ 2) by (rewrite Hqq; ring).
    field_simplify_eq; [| repeat split; try lra]. ring [Hqq].
Qed.
Lemma part_rate_3_continuous : continuous (part_rate_3 Es q) s.
Proof.
  root t s q Hd Hq Hqq. apply (@ex_derive_continuous R_AbsRing R_NormedModule).
  unfold part_rate_3; simpl. change (t * (t * 1)) with (t ^ 2). change (s * (s * 1)) with (s ^ 2).
  change (s ^ 2 - t ^ 2) with (s ^ 2 + - t ^ 2) in *. auto_derive.
  change (s * (s * 1)) with (s ^ 2). change (t * (t * 1)) with (t ^ 2).
  assert (0 < (s ^ 2 + - t ^ 2) ^ 2) by (apply pow_lt, Hd).
  assert (0 < (s ^ 2 + - t ^ 2) ^ 2 * sqrt (s ^ 2 + - t ^ 2)) by (apply Rmult_lt_0_compat; lra).
  assert (0 < s * (s ^ 2 + - t ^ 2)) by (apply Rmult_lt_0_compat; lra).
  assert (0 < s * (s ^ 2 + - t ^ 2) * sqrt (s ^ 2 + - t ^ 2)) by (apply Rmult_lt_0_compat; lra).
  repeat split; try lra.
Qed.
End Derivatives.

(* ---- The contact ---- *)

Section Contact.
Variables (Es : R) (l : list part).

Lemma consistent_total s : beyond s l -> consistent (slope l) s s.
Proof.
  unfold consistent, slope. induction 1 as [| [t d k] l Hq _ IH]; unfold total in *; simpl in *.
  - assert (H := is_RInt_const (V := R_NormedModule) (- (PI / 2)) (PI / 2) 0).
    unfold scal in H; simpl in H; unfold mult in H; simpl in H. rewrite Rmult_0_r in H. exact H.
  - assert (H := part_consistent t d k s ltac:(lra) ltac:(lra)). unfold consistent in H.
    assert (E := is_RInt_plus (V := R_NormedModule) _ _ _ _ _ _ H IH). unfold plus in E; simpl in E.
    rewrite Rplus_0_l in E. exact E.
Qed.
Lemma load_total s : beyond s l -> is_load Es (slope l) s s (load Es l s).
Proof.
  unfold slope, load. induction 1 as [| [t d k] l Hq _ IH]; unfold is_load, total in *; simpl in *.
  - apply (is_RInt_ext (fun _ => 0)). { intros. match goal with |- @eq _ ?x ?y => change (@eq R x y) end. ring. }
    assert (H := is_RInt_const (V := R_NormedModule) (- (PI / 2)) (PI / 2) 0).
    unfold scal in H; simpl in H; unfold mult in H; simpl in H. rewrite Rmult_0_r in H. exact H.
  - apply (is_RInt_ext (fun theta => plus (Es / 2 * (place s s theta * part_slope (Part t d k) (place s s theta)))
      (Es / 2 * (place s s theta * fold_right (fun q sum => part_slope q (place s s theta) + sum) 0 l)))).
    { intros theta _. unfold plus; simpl. match goal with |- @eq _ ?x ?y => change (@eq R x y) end. ring. }
    apply (is_RInt_plus (V := R_NormedModule)); [| exact IH].
    assert (H := part_load_value Es t d k s ltac:(lra) ltac:(lra)). unfold is_load in H.
    rewrite asin_sqrt in H by lra.
    replace (part_load Es (Part t d k) s) with (Es * (d * sqrt (s ^ 2 - t ^ 2) +
      k * (s ^ 2 * (PI / 4 - atan (t / sqrt (s ^ 2 - t ^ 2)) / 2) - t / 2 * sqrt (s ^ 2 - t ^ 2)))); [exact H |].
    unfold part_load, angle; simpl. change (t * (t * 1)) with (t ^ 2). change (s * (s * 1)) with (s ^ 2). field.
Qed.

(* All knots are nearer to the middle than m, and s is beyond. *)
Variable m : R.
Hypothesis Hl : beyond m l.
Lemma beyond_further s : m <= s -> beyond s l.
Proof. intros H. refine (forall_of l _ Hl). intros q. simpl. lra. Qed.
Lemma each (A : part -> Prop) : (forall t d k, 0 <= t < m -> A (Part t d k)) -> Forall A l.
Proof. intros H. refine (forall_of l _ Hl). intros [t d k] Hq. apply H, Hq. Qed.

Lemma contact_at s : 0 < m < s -> is_contact_at Es (slope l) (load Es l) (rate Es l) (fun s => s) s.
Proof.
  intros Hs. split; [lra | split; [| split]].
  - apply consistent_total, beyond_further. lra.
  - apply (locally_near s (s - m)); [lra |]. intros r Hr. apply load_total, beyond_further. lra.
  - apply total_derive, each. intros t d k Ht. apply part_load_derive. lra.
Qed.
End Contact.

Theorem smooth_contact Es l m a : beyond m l -> 0 < m < a ->
  is_smooth_contact Es (slope l) a (load Es l) (rate Es l) (rate_2 Es l) (rate_3 Es l) (fun s => s) (fun _ => 1) (fun _ => 0).
Proof.
  intros Hl Hm. exists ((a - m) / 2). split; [lra |]. intros s Hs.
  split; [apply (contact_at Es l m Hl); lra | split; [| split; [| split; [| split; [| split; [| split]]]]]].
  - apply total_derive, (each l m Hl). intros t d k Ht. apply part_rate_derive. lra.
  - apply total_derive, (each l m Hl). intros t d k Ht. apply part_rate_2_derive. lra.
  - apply total_continuous, (each l m Hl). intros t d k Ht. apply part_rate_3_continuous. lra.
  - auto_derive; trivial.
  - auto_derive; trivial.
  - apply continuous_const.
  - lra.
Qed.

(* g' is odd: what holds at the right edge holds at the left one. *)
Lemma slope_odd l : Forall (fun q => 0 <= from q) l -> mirrored (slope l) = slope l.
Proof.
  intros H. apply FunctionalExtensionality.functional_extensionality. intros x. unfold mirrored, slope.
  induction H as [| [t d k] l Ht _ IH]; unfold total in *; simpl in *; [ring |].
  rewrite <- IH, Ropp_plus_distr. f_equal. unfold part_slope; simpl.
  destruct (Rlt_dec t x), (Rlt_dec x (- t)), (Rlt_dec t (- x)), (Rlt_dec (- x) (- t)); lra.
Qed.

(* ---- The pressure in closed form ---- *)

(* The pressure at x of a contact with the edge s, for one part. *)
Definition part_pressure (Es x : R) (q : part) (s : R) : R :=
  let r := sqrt (s ^ 2 - x ^ 2) in let w := sqrt (s ^ 2 - from q ^ 2) in
  Es / PI * ((corner q - curvature q * from q) * atanh (r / w)
    + curvature q * (r * angle (from q) s) + curvature q * x * atanh (from q * r / (x * w))).

Section Antiderivative.
Variables Es t d k x : R.
Hypothesis Ht : 0 <= t < x.
Let q := Part t d k.

Lemma two_roots s : x < s -> 0 < sqrt (s ^ 2 - x ^ 2) < sqrt (s ^ 2 - t ^ 2) /\
  sqrt (s ^ 2 - x ^ 2) ^ 2 = s ^ 2 - x ^ 2 /\ sqrt (s ^ 2 - t ^ 2) ^ 2 = s ^ 2 - t ^ 2.
Proof.
  intros Hs. assert (Hx := root_positive x s ltac:(lra)). assert (t ^ 2 < x ^ 2) by (simpl; nra).
  split; [split |].
  - apply sqrt_lt_R0. lra.
  - apply sqrt_lt_1_alt. lra.
  - split; apply pow2_sqrt; lra.
Qed.

Lemma part_pressure_derive s : x < s ->
  is_derive (part_pressure Es x q) s (1 / PI * (part_rate Es q s / sqrt (s ^ 2 - x ^ 2))).
Proof.
  intros Hs. destruct (two_roots s Hs) as ((Hr & Hrw) & Err & Eww).
  assert (Hpi := PI_RGT_0). assert (HA := angle_derive t s ltac:(lra)).
  set (r := fun s => sqrt (s ^ 2 - x ^ 2)). set (w := fun s => sqrt (s ^ 2 - t ^ 2)).
  assert (Dr : is_derive r s (s / r s)).
  { unfold r in *. change (s ^ 2 - x ^ 2) with (s ^ 2 + - x ^ 2) in *. auto_derive; change (s * (s * 1)) with (s ^ 2) in *; change (x * (x * 1)) with (x ^ 2) in *.
    - apply (root_positive x s). lra.
    - field. lra. }
  assert (Dw : is_derive w s (s / w s)).
  { unfold w in *. change (s ^ 2 - t ^ 2) with (s ^ 2 + - t ^ 2) in *. auto_derive; change (s * (s * 1)) with (s ^ 2) in *; change (t * (t * 1)) with (t ^ 2) in *.
    - apply (root_positive t s). lra.
    - field. lra. }
  fold (r s) in *. fold (w s) in *.
  assert (Hy : 0 <= r s / w s < 1).
  { split. { apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat; lra]. }
    apply (Rmult_lt_reg_r (w s)); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (Hz : 0 <= t * r s / (x * w s) < 1).
  { replace (t * r s / (x * w s)) with (t / x * (r s / w s)) by (field; lra).
    assert (0 <= t / x < 1).
    { split. { apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat; lra]. }
      apply (Rmult_lt_reg_r x); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    split; [apply Rmult_le_pos; lra |]. nra. }
  assert (Dy : is_derive (fun s => r s / w s) s ((s / r s * w s - r s * (s / w s)) / (w s) ^ 2)).
  { apply is_derive_div; [exact Dr | exact Dw | lra]. }
  assert (Dz : is_derive (fun s => t * r s / (x * w s)) s (t / x * ((s / r s * w s - r s * (s / w s)) / (w s) ^ 2))).
  { apply (is_derive_ext (fun s => t / x * (r s / w s))).
    - intros z. match goal with |- @eq _ ?x ?y => change (@eq R x y) end. unfold Rdiv. rewrite Rinv_mult. ring.
    - apply (is_derive_scal (fun s => r s / w s)). exact Dy. }
  assert (Ly := atanh_derive _ _ (fun s => r s / w s) s Dy eq_refl ltac:(lra)).
  assert (Lz := atanh_derive _ _ (fun s => t * r s / (x * w s)) s Dz eq_refl ltac:(lra)).
  cbv beta in Ly, Lz.
  apply (is_derive_ext (fun s => Es / PI * ((d - k * t) * atanh (r s / w s) + k * (r s * angle t s) + k * x * atanh (t * r s / (x * w s))))).
  { intros z. reflexivity. }
  eapply (fun H E => eq_ind _ (fun v => is_derive _ s v) H _ E).
  - apply (is_derive_scal (fun s => (d - k * t) * atanh (r s / w s) + k * (r s * angle t s) + k * x * atanh (t * r s / (x * w s)))).
    apply (is_derive_plus (V := R_NormedModule) (fun s => (d - k * t) * atanh (r s / w s) + k * (r s * angle t s))).
    + apply (is_derive_plus (V := R_NormedModule) (fun s => (d - k * t) * atanh (r s / w s))).
      * apply (is_derive_scal (fun s => atanh (r s / w s))). exact Ly.
      * apply (is_derive_scal (fun s => r s * angle t s)).
        apply (is_derive_mult r (angle t)); [exact Dr | exact HA | intros; apply Rmult_comm].
    + apply (is_derive_scal (fun s => atanh (t * r s / (x * w s)))). exact Lz.
  - unfold part_rate, plus, mult; simpl. fold (w s). fold (r s). change (t * (t * 1)) with (t ^ 2). change (s * (s * 1)) with (s ^ 2). change (x * (x * 1)) with (x ^ 2).
    fold (w s). fold (r s).
    assert (Ew : w s ^ 2 = s ^ 2 - t ^ 2) by exact Eww. assert (Er : r s ^ 2 = s ^ 2 - x ^ 2) by exact Err.
    match goal with |- @eq _ ?x ?y => change (@eq R x y) end.
    assert (Hxt : 0 < x ^ 2 - t ^ 2) by nra.
    assert (N1 : 1 - (r s / w s) ^ 2 = (x ^ 2 - t ^ 2) / w s ^ 2) by (field_simplify_eq; [rewrite Ew, Er; ring | lra]).
    assert (N2 : 1 - (t * r s / (x * w s)) ^ 2 = s ^ 2 * (x ^ 2 - t ^ 2) / (x ^ 2 * w s ^ 2)).
    { field_simplify_eq; [| lra]. ring [Ew Er]. }
    change (r s / w s * (r s / w s * 1)) with ((r s / w s) ^ 2). change (t * r s / (x * w s) * (t * r s / (x * w s) * 1)) with ((t * r s / (x * w s)) ^ 2).
    rewrite N1, N2. generalize (angle t s). intros A. generalize dependent (r s). generalize dependent (w s). intros W. intros. 
    field_simplify_eq; [| repeat split; nra]. ring [Ew Er].
Qed.
End Antiderivative.

Lemma antiderivative_at_x Es t d k x : 0 <= t < x -> filterlim (part_pressure Es x (Part t d k)) (at_right x) (locally 0).
Proof.
  intros Ht. assert (Hw : 0 < sqrt (x ^ 2 - t ^ 2)) by (apply sqrt_lt_R0, root_positive; lra).
  assert (Zero : part_pressure Es x (Part t d k) x = 0).
  { unfold part_pressure; simpl. change (x * (x * 1)) with (x ^ 2). rewrite (Rminus_diag_eq (x ^ 2)), sqrt_0 by reflexivity.
    replace (0 / sqrt (x ^ 2 - t * (t * 1))) with 0 by (unfold Rdiv; ring). rewrite Rmult_0_r.
    replace (0 / (x * sqrt (x ^ 2 - t * (t * 1)))) with 0 by (unfold Rdiv; ring).
    rewrite !atanh_0. ring. }
  assert (Hr : continuous (fun s => sqrt (s ^ 2 - x ^ 2)) x).
  { apply (continuous_comp (fun s => s ^ 2 - x ^ 2) sqrt); [| apply continuous_sqrt].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
  assert (Hwc : continuous (fun s => sqrt (s ^ 2 - t ^ 2)) x).
  { apply (continuous_comp (fun s => s ^ 2 - t ^ 2) sqrt); [| apply continuous_sqrt].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
  assert (HA : continuous (angle t) x).
  { apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply angle_derive. lra. }
  assert (L0 := atanh_continuous_0).
  assert (C : continuous (part_pressure Es x (Part t d k)) x).
  { unfold part_pressure; simpl. apply continuous_times; [apply continuous_const |].
    assert (Y : continuous (fun s => atanh (sqrt (s ^ 2 - x ^ 2) / sqrt (s ^ 2 - t ^ 2))) x).
    { apply (continuous_comp (fun s => sqrt (s ^ 2 - x ^ 2) / sqrt (s ^ 2 - t ^ 2)) atanh).
      - apply continuous_quotient; [exact Hr | exact Hwc | lra].
      - rewrite (Rminus_diag_eq (x ^ 2)), sqrt_0 by reflexivity. replace (0 / sqrt (x ^ 2 - t ^ 2)) with 0 by (unfold Rdiv; ring). exact L0. }
    assert (Z : continuous (fun s => atanh (t * sqrt (s ^ 2 - x ^ 2) / (x * sqrt (s ^ 2 - t ^ 2)))) x).
    { apply (continuous_comp (fun s => t * sqrt (s ^ 2 - x ^ 2) / (x * sqrt (s ^ 2 - t ^ 2))) atanh).
      - apply continuous_quotient; [apply continuous_times; [apply continuous_const | exact Hr] | apply continuous_times; [apply continuous_const | exact Hwc] |].
        apply Rgt_not_eq, Rmult_lt_0_compat; lra.
      - rewrite (Rminus_diag_eq (x ^ 2)), sqrt_0, Rmult_0_r by reflexivity. replace (0 / (x * sqrt (x ^ 2 - t ^ 2))) with 0 by (unfold Rdiv; ring). exact L0. }
    apply continuous_add; [apply continuous_add |]; apply continuous_times; try apply continuous_const.
    - exact Y.
    - apply continuous_times; [exact Hr | exact HA].
    - exact Z. }
  unfold continuous in C. rewrite Zero in C. intros A HA'. apply filter_le_within. exact (C A HA').
Qed.

(* Barber and Mossakovskii's integral beyond all knots. *)
Theorem pressure Es l m a x : beyond m l -> 0 < m < x -> x < a ->
  is_pressure Es (slope l) a x (total (part_pressure Es x) l a).
Proof.
  intros Hl Hm Hx. exists (load Es l), (rate Es l), (fun s => s). split.
  - intros s Hs. apply (contact_at Es l m Hl). lra.
  - apply improper_by_antiderivative; [exact Hx | |].
    + intros s Hs. assert (Hr : 0 < sqrt (s ^ 2 - x ^ 2)) by (apply sqrt_lt_R0, root_positive; lra).
      assert (E : forall s, sqrt ((s - x) * (x + s)) = sqrt (s ^ 2 - x ^ 2)) by (intros z; f_equal; ring). split.
      * apply (is_derive_ext (total (part_pressure Es x) l)); [reflexivity |]. rewrite E.
        replace (1 / PI * (rate Es l s / sqrt (s ^ 2 - x ^ 2)))
          with (total (fun q s => 1 / PI * (part_rate Es q s / sqrt (s ^ 2 - x ^ 2))) l s).
        -- apply total_derive, (each l m Hl). intros t d k Ht. apply part_pressure_derive; lra.
        -- unfold rate. clear. induction l as [| q l IH]; unfold total in *; simpl in *; [unfold Rdiv; ring |].
           rewrite IH. unfold Rdiv. ring.
      * apply continuous_times; [apply continuous_const |].
        apply (continuous_ext (fun s => rate Es l s / sqrt (s ^ 2 - x ^ 2))). { intros z. rewrite <- E. reflexivity. }
        apply continuous_quotient; [| | lra].
        -- apply (@ex_derive_continuous R_AbsRing R_NormedModule). exists (rate_2 Es l s).
           apply total_derive, (each l m Hl). intros t d k Ht. apply part_rate_derive. lra.
        -- apply (continuous_comp (fun s => s ^ 2 - x ^ 2) sqrt); [| apply continuous_sqrt].
           apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
    + assert (H0 : forall l, beyond m l -> filterlim (total (part_pressure Es x) l) (at_right x) (locally 0)).
      { clear l Hl. induction 1 as [| [t d k] l Ht _ IH]; unfold total in *; simpl in *.
        - apply filterlim_const.
        - replace (locally 0) with (locally (0 + 0)) by (f_equal; ring). refine (filterlim_comp_2 (part_pressure Es x (Part t d k)) _ Rplus _ IH _).
          + apply antiderivative_at_x. lra.
          + apply (filterlim_plus (V := R_NormedModule) 0 0). }
      apply H0, Hl.
Qed.

Section Near.
Variables Es a u : R.
Definition part_scaled (q : part) : R :=
  let s := sqrt (2 * a - u) in let w := sqrt (a ^ 2 - from q ^ 2) in
  Es / PI * ((corner q - curvature q * from q) * (s / w * atanh_ratio (sqrt u * (s / w)))
    + curvature q * (s * angle (from q) a)
    + curvature q * from q * (s / w * atanh_ratio (from q * (sqrt u * s) / ((a - u) * w)))).
Definition scaled (l : list part) : R := fold_right (fun q sum => part_scaled q + sum) 0 l.

Lemma pressure_scaled m l : beyond m l -> 0 < m < a - u -> 0 < u ->
  total (part_pressure Es (a - u)) l a = sqrt u * scaled l.
Proof.
  intros Hl Hm Hu. induction Hl as [| [t d k] l Ht _ IH]; unfold total, scaled in *; simpl in *; [ring |].
  rewrite IH. unfold part_pressure, part_scaled; simpl.
  change (t * (t * 1)) with (t ^ 2). change (a * (a * 1)) with (a ^ 2). change ((a - u) * ((a - u) * 1)) with ((a - u) ^ 2).
  replace (sqrt (a ^ 2 - (a - u) ^ 2)) with (sqrt u * sqrt (2 * a - u))
    by (rewrite <- sqrt_mult by lra; f_equal; ring).
  assert (Hw : 0 < sqrt (a ^ 2 - t ^ 2)) by (apply sqrt_lt_R0, root_positive; lra).
  rewrite (atanh_of_ratio (t * (sqrt u * sqrt (2 * a - u)) / ((a - u) * sqrt (a ^ 2 - t ^ 2)))).
  replace (sqrt u * sqrt (2 * a - u) / sqrt (a ^ 2 - t ^ 2)) with (sqrt u * (sqrt (2 * a - u) / sqrt (a ^ 2 - t ^ 2))) by (field; lra).
  rewrite (atanh_of_ratio (sqrt u * (sqrt (2 * a - u) / sqrt (a ^ 2 - t ^ 2)))).
  assert (Hpi := PI_RGT_0). field. repeat split; lra.
Qed.
End Near.

(* At the left edge, the right one of the mirrored punch. *)
Section Left.
Variables (Es : R) (l : list part) (m a : R).
Hypothesis Hl : beyond m l.
Lemma mirrored_slope : mirrored (slope l) = slope l.
Proof. apply slope_odd. refine (forall_of l _ Hl). intros q. simpl. lra. Qed.
Theorem left_edge_series_of k0 k1 k2 : right_edge_series Es (slope l) a k0 k1 k2 -> left_edge_series Es (slope l) a k0 k1 k2.
Proof. intros H. unfold left_edge_series. rewrite mirrored_slope. exact H. Qed.
Theorem left_pressure x p : is_pressure Es (slope l) a x p -> is_pressure Es (mirrored (slope l)) a x p.
Proof. intros H. rewrite mirrored_slope. exact H. Qed.
End Left.
