(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm TiltedWedge Shear Unique Tactics Stick Gamma PowerLaw.
Open Scope R_scope.

(* The shear traction q at x when the shear force grows in proportion to the load, up to Q: to the
   contact with the right edge s belongs the increment Q/P dP of the force, and each increment is the
   traction of full stick over the contact as it is then, from the contact with the edge e on. *)
Definition is_proportional_traction (Es : R) (g1 P P1 b : R -> R) (Q e a x q : R) : Prop :=
  (forall s, e <= s <= a -> is_contact_at Es g1 P P1 b s /\
    is_traction (full_stick (Q / P a * P1 s) 0 s (b s)) s (b s) (Q / P a * P1 s) 0) /\
  is_improper_integral (fun s => full_stick (Q / P a * P1 s) 0 s (b s) x) e a q.

(* The traction is q(x) = Q/P p(x), at a place x > 0, and at the place - y to the left of the origin. *)
Definition is_similar_on_the_right (Es : R) (g1 : R -> R) (a Q x : R) : Prop := exists (P P1 b : R -> R) (p0 : R),
  is_the_load Es g1 a (b a) (P a) /\ is_the_pressure Es g1 a x p0 /\
  is_proportional_traction Es g1 P P1 b Q x a x (Q / P a * p0).
Definition is_similar_on_the_left (Es : R) (g1 : R -> R) (a Q y : R) : Prop := exists (P P1 b : R -> R) (p0 e : R),
  is_the_load Es g1 a (b a) (P a) /\ is_the_pressure Es (mirrored g1) (b a) y p0 /\ b e = y /\
  is_proportional_traction Es g1 P P1 b Q e a (- y) (Q / P a * p0).

Lemma improper_stretched (f h : R -> R) (k x a l : R) : 0 < k -> x < a ->
  (forall s, x / k < s < a / k -> h s = k * f (k * s)) ->
  is_improper_integral f x a l -> is_improper_integral h (x / k) (a / k) l.
Proof.
  intros Hk Hxa E [Hex Hl].
  assert (T : forall s, k * (s / k) = s) by (intros s; field; lra).
  assert (In : forall e, x / k < e -> x < k * e).
  { intros e He. apply (Rmult_lt_compat_l k) in He; [rewrite T in He; exact He | exact Hk]. }
  assert (Up : forall e, e <= a / k -> k * e <= a).
  { intros e He. apply (Rmult_le_compat_l k) in He; [rewrite T in He; exact He | lra]. }
  assert (I : forall e, x / k < e <= a / k -> is_RInt h e (a / k) (RInt f (k * e) a)).
  { intros e He. apply (is_RInt_ext (fun s => scal k (f (k * s + 0)))).
    - intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra. rewrite Rplus_0_r. symmetry. apply E. lra.
    - apply (is_RInt_comp_lin (V := R_NormedModule) f k 0 e (a / k)). rewrite !Rplus_0_r, T.
      apply (@RInt_correct R_CompleteNormedModule), Hex. split; [apply In | apply Up]; lra. }
  split; [intros e He; eexists; apply I, He |].
  apply (filterlim_ext_loc (fun e => RInt f (k * e) a)).
  - assert (Hd : 0 < a / k - x / k) by (replace (a / k - x / k) with ((a - x) / k) by (field; lra); apply Rdiv_lt_0_compat; lra).
    exists (mkposreal _ Hd). intros e Hb Hxe.
    unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb. apply Rabs_def2 in Hb.
    symmetry. apply (is_RInt_unique (V := R_CompleteNormedModule)), I. lra.
  - refine (filterlim_comp _ _ _ (fun e => k * e) (fun e => RInt f e a) _ (at_right x) _ _ Hl).
    intros A [d HA]. assert (Hd : 0 < d / k) by (apply Rdiv_lt_0_compat; [apply cond_pos | exact Hk]).
    exists (mkposreal _ Hd). intros e Hb Hxe. apply HA; [| apply In, Hxe].
    unfold ball in *; simpl in *. unfold AbsRing_ball, abs, minus, plus, opp in *; simpl in *.
    replace (k * e + - x) with (k * (e + - (x / k))) by (field; lra). rewrite Rabs_mult, (Rabs_pos_eq k) by lra.
    apply (Rmult_lt_compat_l k) in Hb; [rewrite T in Hb; exact Hb | exact Hk].
Qed.

Lemma increments Es g1 P P1 b Q e a : (forall s, e <= s <= a -> is_contact_at Es g1 P P1 b s) ->
  forall s, e <= s <= a -> is_contact_at Es g1 P P1 b s /\
    is_traction (full_stick (Q / P a * P1 s) 0 s (b s)) s (b s) (Q / P a * P1 s) 0.
Proof. intros H s Hs. split; [apply H, Hs |]. apply full_stick_is_traction. apply (H s Hs). Qed.

Lemma similar_right Es g1 a Q x P P1 b p0 : x < a -> is_the_load Es g1 a (b a) (P a) -> is_the_pressure Es g1 a x p0 ->
  (forall s, x <= s <= a -> is_contact_at Es g1 P P1 b s) -> (forall s, x < s < a -> 0 < (s - x) * (x + b s)) ->
  is_improper_integral (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + b s)))) x a p0 -> is_similar_on_the_right Es g1 a Q x.
Proof.
  intros Hx HL Hp HC Hw HI. exists P, P1, b, p0. split; [exact HL | split; [exact Hp | split; [exact (increments _ _ _ _ _ Q _ _ HC) |]]].
  refine (improper_scaled _ _ _ _ _ _ _ Hx HI). intros s Hs. assert (Hpi := PI_RGT_0).
  assert (0 < sqrt ((s - x) * (x + b s))) by (apply sqrt_lt_R0, Hw, Hs). unfold full_stick. generalize (Q / P a). intros k.
  replace (0 * (2 * x + b s - s)) with 0 by ring. unfold Rdiv. rewrite Rmult_0_l, Rplus_0_r. field. lra.
Qed.
(* If the left edge is at gam s: the integral over the right edges s is one over the left edges gam s. *)
Lemma similar_left Es g1 a Q y gam P P1 p0 : 0 < gam -> 0 < y < gam * a ->
  is_the_load Es g1 a (gam * a) (P a) -> is_the_pressure Es (mirrored g1) (gam * a) y p0 ->
  (forall s, y / gam <= s <= a -> is_contact_at Es g1 P P1 (fun s => gam * s) s) ->
  is_improper_integral (fun r => 1 / PI * (P1 (r / gam) / gam / sqrt ((r - y) * (y + r / gam)))) y (gam * a) p0 ->
  is_similar_on_the_left Es g1 a Q y.
Proof.
  intros Hg Hy HL Hp HC HI. assert (Hpi := PI_RGT_0). exists P, P1, (fun s => gam * s), p0, (y / gam).
  split; [exact HL | split; [exact Hp | split; [field; lra | split; [exact (increments _ _ _ _ _ Q _ _ HC) |]]]].
  assert (Ha : y / gam < a).
  { apply (Rmult_lt_reg_l gam); [exact Hg |]. replace (gam * (y / gam)) with y by (field; lra). lra. }
  apply (improper_stretched _ (fun s => 1 / PI * (P1 s / sqrt ((s + y) * (gam * s - y)))) gam) in HI; [| exact Hg | lra |].
  - replace (gam * a / gam) with a in HI by (field; lra). refine (improper_scaled _ _ _ _ _ _ _ Ha HI).
    intros s Hs. assert (y < gam * s).
    { destruct Hs as [Hs _]. apply (Rmult_lt_compat_l gam) in Hs; [| exact Hg]. replace (gam * (y / gam)) with y in Hs by (field; lra). lra. }
    assert (0 < s) by nra. assert (0 < sqrt ((s + y) * (gam * s - y))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
    unfold full_stick. replace (s - - y) with (s + y) by ring. replace (- y + gam * s) with (gam * s - y) by ring.
    generalize (Q / P a). intros k. replace (0 * (2 * - y + gam * s - s)) with 0 by ring. unfold Rdiv. rewrite Rmult_0_l, Rplus_0_r. field. lra.
  - intros s Hs. replace (gam * s / gam) with s by (field; lra).
    replace ((gam * s - y) * (y + s)) with ((s + y) * (gam * s - y)) by ring. unfold Rdiv. field_simplify_eq; [reflexivity |].
    assert (y < gam * s).
    { destruct Hs as [Hs _]. apply (Rmult_lt_compat_l gam) in Hs; [| exact Hg]. replace (gam * (y / gam)) with y in Hs by (field; lra). lra. }
    assert (0 < s) by nra. assert (0 < sqrt ((s + y) * (gam * s - y))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra). repeat split; lra.
Qed.

Section Punches.
Variables Es phi gam C m a Q : R.
Hypothesis form : 0 < Es /\ 0 < phi /\ 0 < gam /\ 0 < C /\ 0 <= m /\ 0 < a.

Lemma wedge_loads : is_the_load Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) (Es * phi * sqrt gam * a).
Proof.
  assert (0 < gam * a) by (apply Rmult_lt_0_compat; lra).
  apply (the_load _ _ 0); [apply wedge_rises, tilt_range; lra | lra | lra | apply wedge_consistent; lra | apply wedge_load; lra].
Qed.
Lemma power_mirrored : mirrored (power_slope C m) = power_slope C m.
Proof. apply FunctionalExtensionality.functional_extensionality. intros x. unfold mirrored. rewrite power_slope_odd. ring. Qed.
Theorem similar_tractions_right x : 0 < x < a ->
  is_similar_on_the_right Es (TiltedWedge.slope phi (tilt phi gam)) a Q x /\ is_similar_on_the_right Es (power_slope C m) a Q x.
Proof.
  intros Hx. split.
  - apply (similar_right _ _ _ _ _ (fun s => Es * phi * sqrt gam * s) (fun _ => Es * phi * sqrt gam) (fun s => gam * s) (proportional_pressure (Es * phi * sqrt gam) gam a x)).
    + lra.
    + exact wedge_loads.
    + apply (the_pressure _ _ 0); [apply wedge_rises, tilt_range; lra | lra | apply pressure_right_of_apex; lra].
    + intros s Hs. apply wedge_contact_at; lra.
    + intros s Hs. apply Rmult_lt_0_compat; nra.
    + apply proportional_integral; lra.
  - eapply (similar_right _ _ _ _ _ (power_load Es C m) (power_load_1 Es C m) (fun s => s)).
    + lra.
    + apply power_the_load; lra.
    + apply power_the_pressure; lra.
    + intros s Hs. apply power_contact_at; lra.
    + intros s Hs. apply Rmult_lt_0_compat; lra.
    + apply (improper_scaled (fun s => Rpower s m / sqrt (s ^ 2 - x ^ 2))); [| lra | apply power_integral; lra].
      intros s Hs. unfold power_load_1. replace ((s - x) * (x + s)) with (s ^ 2 - x ^ 2) by ring. replace (m + 1 - 1) with m by ring.
      unfold Rdiv. ring.
Qed.
Theorem similar_tractions_left y :
  (0 < y < gam * a -> is_similar_on_the_left Es (TiltedWedge.slope phi (tilt phi gam)) a Q y) /\
  (0 < y < a -> is_similar_on_the_left Es (power_slope C m) a Q y).
Proof.
  split; intros Hy.
  - apply (similar_left _ _ _ _ _ gam (fun s => Es * phi * sqrt gam * s) (fun _ => Es * phi * sqrt gam) (proportional_pressure (Es * phi * sqrt gam / gam) (/ gam) (gam * a) y)).
    + lra.
    + exact Hy.
    + exact wedge_loads.
    + apply (the_pressure _ _ 0); [apply mirrored_wedge_rises, tilt_range; lra | lra | apply pressure_left_of_apex; lra].
    + intros s Hs. assert (0 < y / gam) by (apply Rdiv_lt_0_compat; lra). apply wedge_contact_at; lra.
    + assert (Hi := Rinv_0_lt_compat gam ltac:(lra)). rewrite <- Rmult_1_l.
      refine (improper_scaled _ _ 1 _ _ _ _ _ (proportional_integral (Es * phi * sqrt gam / gam) (/ gam) y (gam * a) Hi Hy)); [| lra].
      intros s Hs. replace (s / gam) with (/ gam * s) by (unfold Rdiv; ring). ring.
  - eapply (similar_left _ _ _ _ _ 1 (power_load Es C m) (power_load_1 Es C m)).
    + lra.
    + lra.
    + rewrite Rmult_1_l. apply power_the_load; lra.
    + rewrite Rmult_1_l, power_mirrored. apply power_the_pressure; lra.
    + intros s Hs. assert (H := power_contact_at Es C m ltac:(lra) s ltac:(lra)).
      destruct H as (H1 & H2 & H3 & H4). split; [lra | split; [rewrite Rmult_1_l; exact H2 | split; [| exact H4]]].
      refine (filter_imp _ _ _ H3). intros r Hr. rewrite Rmult_1_l. exact Hr.
    + rewrite Rmult_1_l.
      apply (improper_scaled (fun s => Rpower s m / sqrt (s ^ 2 - y ^ 2))); [| lra | apply power_integral; lra].
      intros s Hs. unfold power_load_1. replace (s / 1) with s by field. replace ((s - y) * (y + s)) with (s ^ 2 - y ^ 2) by ring. replace (m + 1 - 1) with m by ring.
      unfold Rdiv. rewrite Rinv_1. ring.
Qed.
End Punches.
