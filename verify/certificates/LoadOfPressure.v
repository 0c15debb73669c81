(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Limits Gamma PowerLaw Resultant Places.
Open Scope R_scope.

(* The load is the integral of the pressure over the contact: power laws, flat punches with rounded
   edges, tilted wedges. *)

(* p is the pressure of the contact (-b, a) on both sides of the origin. *)
Definition are_the_pressures (Es : R) (g1 : R -> R) (a b : R) (p : R -> R) : Prop :=
  (forall x, 0 < x < a -> is_the_pressure Es g1 a x (p x)) /\
  (forall y, 0 < y < b -> is_the_pressure Es (mirrored g1) b y (p (- y))).
(* The integral of p over (-b, a), where p may be unbounded at 0 and at both ends. *)
Definition is_integral_about_0 (p : R -> R) (b a v : R) : Prop :=
  exists l r, is_RInt_gen p (at_right (- b)) (at_left 0) l /\ is_RInt_gen p (at_right 0) (at_left a) r /\ l + r = v.

Lemma integral_mirrored (q : R -> R) (b l : R) :
  is_RInt_gen q (at_right 0) (at_left b) l -> is_RInt_gen (fun x => q (- x)) (at_right (- b)) (at_left 0) l.
Proof.
  intros H A HA. destruct (H A HA) as [Q S HQ HS HQS].
  apply (Filter_prod _ _ _ (fun x => S (- x)) (fun x => Q (- x))).
  - destruct HS as [e He]. exists e. intros x Hx Hb. apply He; [| lra].
    unfold ball in *; simpl in *. unfold AbsRing_ball, abs, minus, plus, opp in *; simpl in *.
    replace (- x + - b) with (- (x + - - b)) by ring. rewrite Rabs_Ropp. exact Hx.
  - destruct HQ as [e He]. exists e. intros x Hx Hb. apply He; [| lra].
    unfold ball in *; simpl in *. unfold AbsRing_ball, abs, minus, plus, opp in *; simpl in *.
    replace (- x + - 0) with (- (x + - 0)) by ring. rewrite Rabs_Ropp. exact Hx.
  - intros c d Hc Hd. destruct (HQS (- d) (- c) Hd Hc) as (y & Iy & Ay). exists y. split; [| exact Ay]. simpl in *.
    apply (is_RInt_ext (fun x => opp (opp (q (- x))))); [intros x _; unfold opp; simpl; match goal with |- @eq _ ?x ?y => change (@eq R x y) end; ring |].
    replace y with (opp (opp y)) by (unfold opp; simpl; ring).
    apply (is_RInt_opp (V := R_NormedModule)). apply (is_RInt_comp_opp (V := R_NormedModule) q).
    apply (is_RInt_swap (V := R_NormedModule)). exact Iy.
Qed.

(* A function of two halves. *)
Definition two_sides (p q : R -> R) (x : R) : R := if Rlt_dec 0 x then p x else q (- x).
Lemma two_sides_integral p q b a l r : 0 < a -> 0 < b -> is_RInt_gen q (at_right 0) (at_left b) l -> is_RInt_gen p (at_right 0) (at_left a) r ->
  is_integral_about_0 (two_sides p q) b a (l + r).
Proof.
  intros Ha Hb Hl Hr. exists l, r. split; [| split; [| reflexivity]].
  - apply (is_RInt_gen_ext (fun x => q (- x))); [| apply integral_mirrored, Hl].
    apply (Filter_prod _ _ _ (fun x => x < 0) (fun x => x < 0)).
    + exists (mkposreal b Hb). intros x Hx _. unfold ball in Hx; simpl in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx; simpl in Hx.
      apply Rabs_def2 in Hx. lra.
    + exists (mkposreal 1 Rlt_0_1). intros x _ Hx. exact Hx.
    + intros c d Hc Hd x. simpl. unfold Rmin, Rmax. destruct (Rle_dec c d); intros Hx; unfold two_sides; destruct (Rlt_dec 0 x); (reflexivity || lra).
  - apply (is_RInt_gen_ext p); [| exact Hr].
    apply (Filter_prod _ _ _ (fun x => 0 < x) (fun x => 0 < x)).
    + exists (mkposreal 1 Rlt_0_1). intros x _ Hx. exact Hx.
    + exists (mkposreal a Ha). intros x Hx _. unfold ball in Hx; simpl in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx; simpl in Hx.
      apply Rabs_def2 in Hx. lra.
    + intros c d Hc Hd x. simpl. unfold Rmin, Rmax. destruct (Rle_dec c d); intros Hx; unfold two_sides; destruct (Rlt_dec 0 x); (reflexivity || lra).
Qed.

(* Contacts with the left edge gam s: the two halves of the load. *)
Lemma halves_add gam : 0 < gam -> atan (/ sqrt gam) + atan (/ sqrt (/ gam)) = PI / 2.
Proof.
  intros H. assert (R0 := sqrt_lt_R0 gam H). rewrite sqrt_inv, Rinv_inv by lra.
  rewrite atan_inv by exact R0. ring.
Qed.
Section Proportional.
Variables (Es : R) (g1 P P1 : R -> R) (gam a K : R).
Hypothesis Hg : 0 < gam.
Hypothesis Ha : 0 < a.
Hypothesis Hcontact : forall s, 0 < s -> is_contact_at Es g1 P P1 (fun s => gam * s) s.
Hypothesis HP1 : forall s, 0 < s -> continuous P1 s.
Hypothesis HK : forall s, 0 < s <= a -> Rabs (P s) <= K * s.
Hypothesis Hright : forall x p, 0 < x < a -> is_pressure Es g1 a x p -> is_the_pressure Es g1 a x p.
Hypothesis Hleft : forall y p, 0 < y < gam * a -> is_pressure Es (mirrored g1) (gam * a) y p -> is_the_pressure Es (mirrored g1) (gam * a) y p.

Let Q s := P (s / gam).
Let Q1 s := P1 (s / gam) / gam.
Definition side_pressure : R -> R := two_sides (ray_pressure P1 gam a) (ray_pressure Q1 (/ gam) (gam * a)).

Let left_contact s : 0 < s -> is_contact_at Es (mirrored g1) Q Q1 (fun s => / gam * s) s.
Proof.
  intros Hs. assert (Hs' : 0 < s / gam) by (apply Rdiv_lt_0_compat; lra).
  assert (E : forall z, gam * (z / gam) = z) by (intros z; field; lra).
  assert (E' : forall z, / gam * z = z / gam) by (intros z; field; lra).
  destruct (Hcontact (s / gam) Hs') as (Hw & Hc & _ & Hd).
  split; [rewrite E'; lra | split; [| split]].
  - apply consistent_mirrored in Hc. rewrite E in Hc. rewrite E'. exact Hc.
  - apply (locally_near s s); [exact Hs |]. intros z Hz. assert (Hz' : 0 < z / gam) by (apply Rdiv_lt_0_compat; lra).
    destruct (Hcontact (z / gam) Hz') as (_ & _ & Hload & _). apply locally_singleton in Hload.
    apply load_mirrored in Hload. rewrite E in Hload. rewrite E'. exact Hload.
  - unfold Q, Q1. replace (P1 (s / gam) / gam) with (scal (/ gam) (P1 (s / gam))) by (unfold scal; simpl; unfold mult; simpl; field; lra).
    apply (is_derive_comp P (fun s => s / gam)); [exact Hd |]. auto_derive; [trivial | field; lra].
Qed.

Theorem load_of_pressure : are_the_pressures Es g1 a (gam * a) side_pressure /\ is_load Es g1 a (gam * a) (P a) /\
  is_integral_about_0 side_pressure (gam * a) a (P a).
Proof.
  assert (Hpi := PI_RGT_0). assert (Hga : 0 < gam * a) by (apply Rmult_lt_0_compat; assumption). assert (Hi := Rinv_0_lt_compat gam Hg).
  assert (HP : forall s, 0 < s -> is_derive P s (P1 s)) by (intros s Hs; apply (Hcontact s Hs)).
  assert (HQ : forall s, 0 < s -> is_derive Q s (Q1 s)) by (intros s Hs; apply (left_contact s Hs)).
  assert (HQ1 : forall s, 0 < s -> continuous Q1 s).
  { intros s Hs. unfold Q1. apply continuous_quotient; [| apply continuous_const | lra].
    apply (continuous_comp (fun s => s / gam) P1); [| apply HP1, Rdiv_lt_0_compat; lra].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
  assert (HKQ : forall s, 0 < s <= gam * a -> Rabs (Q s) <= K / gam * s).
  { intros s Hs. unfold Q. replace (K / gam * s) with (K * (s / gam)) by (field; lra). apply HK. split; [apply Rdiv_lt_0_compat; lra |].
    apply (Rmult_le_reg_r gam); [exact Hg |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  split; [split |split].
  - intros x Hx. unfold side_pressure, two_sides. destruct (Rlt_dec 0 x) as [_ |]; [| lra]. apply Hright; [exact Hx |].
    exists P, P1, (fun s => gam * s). split; [intros s Hs; apply Hcontact; lra |]. apply ray_pressure_is_improper; assumption.
  - intros y Hy. unfold side_pressure, two_sides. destruct (Rlt_dec 0 (- y)) as [| _]; [lra |]. rewrite Ropp_involutive. apply Hleft; [exact Hy |].
    exists Q, Q1, (fun s => / gam * s). split; [intros s Hs; apply left_contact; lra |]. apply ray_pressure_is_improper; assumption.
  - destruct (Hcontact a Ha) as (_ & _ & L & _). exact (locally_singleton _ _ L).
  - assert (I1 := half_resultant P P1 gam a K Hg Ha HP HP1 HK).
    assert (I2 := half_resultant Q Q1 (/ gam) (gam * a) (K / gam) Hi Hga HQ HQ1 HKQ).
    replace (P a) with (2 / PI * Q (gam * a) * atan (/ sqrt (/ gam)) + 2 / PI * P a * atan (/ sqrt gam)).
    + apply two_sides_integral; assumption.
    + unfold Q. replace (gam * a / gam) with a by (field; lra). assert (S := halves_add gam Hg).
      replace (atan (/ sqrt (/ gam))) with (PI / 2 - atan (/ sqrt gam)) by lra. field. lra.
Qed.
End Proportional.

(* ---- Tilted wedges ---- *)

Theorem wedge_load_of_pressure Es phi gam a : 0 < phi /\ 0 < gam /\ 0 < a -> exists p P0,
  are_the_pressures Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) p /\
  is_the_load Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) P0 /\ is_integral_about_0 p (gam * a) a P0.
Proof.
  intros (Hphi & Hgam & Ha). assert (T := tilt_range phi gam Hphi Hgam). assert (Hga : 0 < gam * a) by (apply Rmult_lt_0_compat; lra).
  set (P := fun s => Es * phi * sqrt gam * s). set (P1 := fun _ : R => Es * phi * sqrt gam).
  destruct (load_of_pressure Es (TiltedWedge.slope phi (tilt phi gam)) P P1 gam a (Rabs (Es * phi * sqrt gam))) as (Hp & HL & HI); try assumption.
  - intros s Hs. apply wedge_contact_at; assumption.
  - intros s _. apply continuous_const.
  - intros s Hs. unfold P. rewrite Rabs_mult, (Rabs_pos_eq s) by lra. lra.
  - intros x p Hx. apply (the_pressure _ _ 0); [apply wedge_rises, T | lra].
  - intros y p Hy. apply (the_pressure _ _ 0); [apply mirrored_wedge_rises, T | lra].
  - eexists _, (P a). split; [exact Hp |]. split; [| exact HI].
    apply (the_load _ _ 0); [apply wedge_rises, T | exact Ha | lra | | exact HL].
    destruct (wedge_contact_at Es phi gam Hgam a Ha) as (_ & C & _). exact C.
Qed.

(* ---- Power laws ---- *)

Theorem power_load_of_pressure Es C m a : 0 < C /\ 0 <= m /\ 0 < a -> exists p P0,
  are_the_pressures Es (power_slope C m) a a p /\ is_the_load Es (power_slope C m) a a P0 /\ is_integral_about_0 p a a P0.
Proof.
  intros (HC & Hm & Ha). assert (Hr := power_slope_rises C m HC Hm).
  assert (Hmir : mirrored (power_slope C m) = power_slope C m).
  { apply functional_extensionality. intros x. unfold mirrored. rewrite power_slope_odd. ring. }
  destruct (load_of_pressure Es (power_slope C m) (power_load Es C m) (power_load_1 Es C m) 1 a
    (Rabs (Es * C * wallis (m + 1)) * Rpower a m)) as (Hp & HL & HI).
  - lra.
  - exact Ha.
  - intros s Hs. replace (fun s => 1 * s) with (fun s : R => s) by (apply functional_extensionality; intros; ring).
    apply power_contact_at; assumption.
  - intros s Hs. unfold power_load_1. apply continuous_times; [apply continuous_const |].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold Rpower. auto_derive. exact Hs.
  - intros s Hs. unfold power_load. rewrite Rabs_mult. rewrite Rpower_plus, Rpower_1 by lra.
    assert (0 < Rpower s m) by apply exp_pos. rewrite (Rabs_pos_eq (Rpower s m * s)) by (apply Rmult_le_pos; lra).
    rewrite (Rmult_assoc (Rabs _)). apply Rmult_le_compat_l; [apply Rabs_pos |]. apply Rmult_le_compat_r; [lra |].
    apply Rle_Rpower_l; lra.
  - intros x p Hx. apply (the_pressure _ _ 0); [exact Hr | lra].
  - rewrite Hmir. intros y p Hy. apply (the_pressure _ _ 0); [exact Hr | lra].
  - rewrite Rmult_1_l in Hp, HI. eexists _, _. split; [exact Hp |]. split; [apply power_the_load; assumption | exact HI].
Qed.

(* ---- Flat punches with rounded edges ---- *)

Section Rounded.
Variables Es t R0 : R.
Hypothesis Ht : 0 < t.
Hypothesis HR : 0 < R0.
Let g1 := Symmetric.slope (rounded t R0).
Let h s := sqrt (s ^ 2 - t ^ 2).
(* The load and its rate: zero as long as the contact is within the flat, since the root is then. *)
Definition rounded_load s := Es / R0 * (s ^ 2 / 2 * atan (h s / t) - t / 2 * h s).
Definition rounded_rate s := Es / R0 * s * atan (h s / t).

Let h_within s : 0 < s <= t -> h s = 0.
Proof. intros H. apply sqrt_neg_0. nra. Qed.
Let h_beyond s : t < s -> 0 < h s /\ h s ^ 2 = s ^ 2 - t ^ 2.
Proof. intros H. assert (0 < s ^ 2 - t ^ 2) by nra. split; [apply sqrt_lt_R0; lra | apply pow2_sqrt; lra]. Qed.
Let h_continuous s : continuous h s.
Proof.
  apply (continuous_comp (fun s => s ^ 2 - t ^ 2) sqrt); [| apply continuous_sqrt].
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Let angle_continuous s : continuous (fun s => atan (h s / t)) s.
Proof.
  apply (continuous_comp (fun s => h s / t) atan).
  - apply continuous_quotient; [apply h_continuous | apply continuous_const | lra].
  - apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma rounded_rate_continuous s : continuous rounded_rate s.
Proof.
  apply continuous_times; [| apply angle_continuous]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma rounded_load_continuous s : continuous rounded_load s.
Proof.
  apply continuous_times; [apply continuous_const |]. apply continuous_sub.
  - apply continuous_times; [| apply angle_continuous]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - apply continuous_times; [apply continuous_const | apply h_continuous].
Qed.
Lemma rounded_load_within s : 0 < s <= t -> rounded_load s = 0 /\ rounded_rate s = 0.
Proof.
  intros H. unfold rounded_load, rounded_rate. rewrite (h_within s H). unfold Rdiv. rewrite Rmult_0_l, atan_0. split; ring.
Qed.
Lemma rounded_load_beyond s : t < s -> rounded_load s = Symmetric.load Es (rounded t R0) s.
Proof.
  intros H. destruct (h_beyond s H) as [Hh _]. unfold rounded_load, Symmetric.load, total, rounded, part_load, from, corner, curvature, fold_right, angle.
  change (sqrt (s ^ 2 - t ^ 2)) with (h s). replace (h s / t) with (/ (t / h s)) by (field; lra).
  rewrite atan_inv by (apply Rdiv_lt_0_compat; lra). field. lra.
Qed.
Lemma rounded_load_derive_off s : 0 < s -> s <> t -> is_derive rounded_load s (rounded_rate s).
Proof.
  intros Hs Hne. destruct (Rlt_le_dec s t) as [H | H].
  - destruct (rounded_load_within s ltac:(lra)) as [_ ->]. apply (is_derive_ext_loc (fun _ => 0)).
    + apply (locally_near s (Rmin s (t - s))); [apply Rmin_pos; lra |]. intros r Hr. generalize (Rmin_l s (t - s)) (Rmin_r s (t - s)). intros.
      symmetry. apply rounded_load_within. lra.
    + apply (is_derive_const (V := R_NormedModule)).
  - destruct (h_beyond s ltac:(lra)) as [Hh E]. unfold rounded_load, rounded_rate, h in *. assert (0 < s ^ 2 - t ^ 2) by nra.
    auto_derive; [repeat split; lra |]. change (s * (s * 1)) with (s ^ 2) in *. change (t * (t * 1)) with (t ^ 2) in *.
    change (s ^ 2 + - t ^ 2) with (s ^ 2 - t ^ 2) in *.
    change (sqrt (s ^ 2 - t ^ 2) / t) with (sqrt (s ^ 2 - t ^ 2) * / t).
    set (q := sqrt (s ^ 2 - t ^ 2)) in *. generalize (atan (q * / t)). intros A. clearbody q.
    replace (1 + q * / t * (q * / t * 1)) with (s ^ 2 / t ^ 2) by (replace (s ^ 2) with (q ^ 2 + t ^ 2) by lra; field; lra).
    field. repeat split; lra.
Qed.
Lemma rounded_load_derive s : 0 < s -> is_derive rounded_load s (rounded_rate s).
Proof.
  intros Hs. destruct (Req_dec s t) as [-> | Hne]; [| apply rounded_load_derive_off; assumption].
  destruct (rounded_load_within t ltac:(lra)) as [E0 E1].
  apply is_derive_Reals. intros e He.
  destruct (rounded_rate_continuous t (fun y => Rabs (y - rounded_rate t) < e)) as [d Hd].
  { exists (mkposreal e He). intros y Hy. exact Hy. }
  assert (Dp := cond_pos d). exists (mkposreal (Rmin d (t / 2)) ltac:(apply Rmin_pos; lra)). intros k Hk Hkd. simpl in Hkd.
  assert (H1 : Rabs k < d) by (eapply Rlt_le_trans; [exact Hkd | apply Rmin_l]).
  assert (H2 : Rabs k < t / 2) by (eapply Rlt_le_trans; [exact Hkd | apply Rmin_r]).
  assert (H1' := Rabs_def2 _ _ H1). assert (H2' := Rabs_def2 _ _ H2). rewrite E0, E1.
  destruct (Rlt_le_dec k 0) as [L | L].
  - destruct (rounded_load_within (t + k) ltac:(lra)) as [-> _]. replace ((0 - 0) / k - 0) with 0 by (field; exact Hk). rewrite Rabs_R0. exact He.
  - destruct (MVT_gen rounded_load t (t + k) rounded_rate) as (c & Hc & Ec).
    + intros z Hz. rewrite Rmin_left in Hz by lra. apply rounded_load_derive_off; lra.
    + intros z _. apply continuity_pt_filterlim, rounded_load_continuous.
    + rewrite Rmin_left, Rmax_right in Hc by lra. rewrite E0 in Ec. rewrite Ec. replace (rounded_rate c * (t + k - t) / k - 0) with (rounded_rate c - rounded_rate t) by (rewrite E1; field; exact Hk).
      apply Hd. unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl. apply Rle_lt_trans with (Rabs k); [| exact H1].
      rewrite (Rabs_pos_eq k) by exact L. apply Rabs_le. lra.
Qed.

Let beyond_flat s : t < s -> beyond s (rounded t R0).
Proof. intros H. repeat constructor; simpl; lra. Qed.
Let within_flat a b theta : 0 < a + b -> a <= t -> b <= t -> g1 (place a b theta) = 0.
Proof.
  intros H Ha Hb. apply slope_within_flat. unfold place. assert (B := SIN_bound theta). split; nra.
Qed.
Let is_load_within a b : 0 < a + b -> a <= t -> b <= t -> is_load Es g1 a b 0.
Proof.
  intros H Ha Hb. unfold is_load. apply (is_RInt_ext (fun _ => 0)).
  - intros theta _. rewrite within_flat by assumption. match goal with |- @eq _ ?x ?y => change (@eq R x y) end. ring.
  - assert (I := is_RInt_const (V := R_NormedModule) (- (PI / 2)) (PI / 2) 0).
    unfold scal in I; simpl in I; unfold mult in I; simpl in I. rewrite Rmult_0_r in I. exact I.
Qed.
Lemma rounded_contact_at s : 0 < s -> is_contact_at Es g1 rounded_load rounded_rate (fun s => 1 * s) s.
Proof.
  intros Hs. split; [lra | split; [| split]].
  - rewrite Rmult_1_l. destruct (Rlt_le_dec t s) as [H | H].
    + apply consistent_total, beyond_flat, H.
    + unfold consistent. apply (is_RInt_ext (fun _ => 0)).
      * intros theta _. symmetry. apply within_flat; lra.
      * assert (I := is_RInt_const (V := R_NormedModule) (- (PI / 2)) (PI / 2) 0).
        unfold scal in I; simpl in I; unfold mult in I; simpl in I. rewrite Rmult_0_r in I. exact I.
  - apply (locally_near s s); [exact Hs |]. intros r Hr. rewrite Rmult_1_l. destruct (Rlt_le_dec t r) as [H | H].
    + rewrite rounded_load_beyond by exact H. apply load_total, beyond_flat, H.
    + destruct (rounded_load_within r ltac:(lra)) as [-> _]. apply is_load_within; lra.
  - apply rounded_load_derive, Hs.
Qed.

(* A contact with the right edge within the flat has its left edge there, too, and carries no load. *)
Let odd x : g1 (- x) = - g1 x.
Proof.
  assert (E : mirrored g1 = g1) by (apply slope_odd; repeat constructor; simpl; lra).
  assert (Ex : mirrored g1 x = g1 x) by (rewrite E; reflexivity). unfold mirrored in Ex. lra.
Qed.
Let curved : 0 < 1 / R0. Proof. apply Rdiv_lt_0_compat; lra. Qed.
Let g1_rises : rises_at g1 t.
Proof. apply (punch_rises (rounded t R0)). split; [repeat constructor; simpl; lra | simpl; lra]. Qed.
Let within_left s b : 0 < s <= t -> 0 < s + b -> consistent g1 s b -> b <= t.
Proof.
  intros Hs Hw Hc. destruct (Rle_lt_dec b t) as [H | H]; [exact H | exfalso]. assert (Hpi := PI_RGT_0).
  destruct g1_rises as (Mono & Pos & _).
  destruct (place_of_angle s b (- t) Hw ltac:(lra)) as (z & Hz & Ez).
  set (m := (- (PI / 2) + z) / 2). assert (Hm : - (PI / 2) < m < z) by (unfold m; lra).
  assert (Pm : place s b m < - t) by (rewrite <- Ez; apply place_increasing; lra).
  apply (positive_integral (fun y => - g1 (place s b y)) (- (PI / 2)) (PI / 2) (- (PI / 2)) m (g1 (- place s b m))); try lra.
  - apply Pos. lra.
  - intros y Hy. assert (g1 (place s b y) <= g1 t).
    { apply Mono. unfold place. assert (B := SIN_bound y). nra. }
    assert (g1 t = 0) by (apply slope_within_flat; lra). lra.
  - intros y Hy. rewrite odd. apply Ropp_le_contravar, Mono, Rlt_le, place_increasing; lra.
  - replace 0 with (opp 0) by (unfold opp; simpl; ring). apply (is_RInt_opp (V := R_NormedModule)). exact Hc.
Qed.
Let no_rate P P1 b x s : (forall s, x <= s <= t -> is_contact_at Es g1 P P1 b s) -> 0 < x -> x < s < t -> P1 s = 0.
Proof.
  intros Hp Hx Hs. destruct (Hp s ltac:(lra)) as (_ & _ & _ & D). apply is_derive_unique in D. rewrite <- D. apply is_derive_unique.
  apply (is_derive_ext_loc (fun _ => 0)); [| apply (is_derive_const (V := R_NormedModule))].
  apply (locally_near s (Rmin (s - x) (t - s))); [apply Rmin_pos; lra |]. intros r Hr.
  generalize (Rmin_l (s - x) (t - s)) (Rmin_r (s - x) (t - s)). intros.
  destruct (Hp r ltac:(lra)) as (Hw & Hc & L & _). apply locally_singleton in L.
  apply (load_unique Es g1 r (b r)); [| exact L]. apply is_load_within; [exact Hw | lra |]. apply (within_left r); [lra | exact Hw | exact Hc].
Qed.
Lemma rounded_the_pressure a x p : t < a -> 0 < x < a -> is_pressure Es g1 a x p -> is_the_pressure Es g1 a x p.
Proof.
  intros Ha Hx Hp. destruct (Rlt_le_dec x t) as [L | L]; [| apply (the_pressure _ _ t); [exact g1_rises | lra | exact Hp]].
  split; [exact Hp |]. intros q Hq. revert Hp Hq. intros (P & P1 & b & Hp & Xp & Ip) (Q & Q1 & c & Hq & Xq & Iq).
  assert (Eb : forall s, t < s <= a -> b s = c s).
  { intros s Hs. destruct (Hp s ltac:(lra)) as (Hw & Hc & _). destruct (Hq s ltac:(lra)) as (Hw' & Hc' & _).
    exact (left_edge_unique g1 t s (b s) (c s) g1_rises ltac:(lra) Hw Hw' Hc Hc'). }
  assert (EP : forall s, t < s < a -> P1 s = Q1 s).
  { intros s Hs. destruct (Hp s ltac:(lra)) as (_ & _ & Lp & Dp). destruct (Hq s ltac:(lra)) as (_ & _ & Lq & Dq).
    apply is_derive_unique in Dq. rewrite <- Dq. symmetry. apply is_derive_unique.
    apply (is_derive_ext_loc P); [| exact Dp].
    assert (In : locally s (fun r => t < r < a)).
    { apply (locally_near s (Rmin (s - t) (a - s))); [apply Rmin_pos; lra |]. intros r Hr.
      generalize (Rmin_l (s - t) (a - s)) (Rmin_r (s - t) (a - s)). lra. }
    apply (filter_imp (fun r => is_load Es g1 r (b r) (P r) /\ is_load Es g1 r (c r) (Q r) /\ t < r < a)).
    - intros r (L1 & L2 & Hr). rewrite <- (Eb r ltac:(lra)) in L2. exact (load_unique _ _ _ _ _ _ L1 L2).
    - exact (filter_and _ _ Lp (filter_and _ _ Lq In)). }
  symmetry.
  apply (filterlim_locally_unique (V := R_NormedModule) (F := at_right x) (fun e => RInt (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + b s)))) e a)).
  - exact Ip.
  - apply (filterlim_ext_loc (fun e => RInt (fun s => 1 / PI * (Q1 s / sqrt ((s - x) * (x + c s)))) e a)); [| exact Iq].
    exists (mkposreal (t - x) ltac:(lra)). intros e He Hxe.
    unfold ball in He; simpl in He. unfold AbsRing_ball, abs, minus, plus, opp in He; simpl in He.
    apply Rabs_def2 in He.
    assert (Same : forall s, e < s < a -> s <> t -> 1 / PI * (Q1 s / sqrt ((s - x) * (x + c s))) = 1 / PI * (P1 s / sqrt ((s - x) * (x + b s)))).
    { intros s Hs Hne. destruct (Rlt_le_dec s t) as [M | M].
      - rewrite (no_rate P P1 b x s), (no_rate Q Q1 c x s) by (try lra; intros; (apply Hp || apply Hq); lra). unfold Rdiv. ring.
      - rewrite Eb, EP by lra. reflexivity. }
    assert (X1 : ex_RInt (fun s => 1 / PI * (Q1 s / sqrt ((s - x) * (x + c s)))) e a) by (apply Xq; lra).
    assert (X2 : ex_RInt (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + b s)))) e a) by (apply Xp; lra).
    assert (e < t) by lra.
    rewrite <- (RInt_Chasles _ e t a) by (apply (ex_RInt_Chasles_1 _ e t a) || apply (ex_RInt_Chasles_2 _ e t a); (lra || exact X1)).
    rewrite <- (RInt_Chasles (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + b s)))) e t a) by (apply (ex_RInt_Chasles_1 _ e t a) || apply (ex_RInt_Chasles_2 _ e t a); (lra || exact X2)).
    f_equal; apply RInt_ext; intros s Hs; rewrite Rmin_left in Hs by lra; rewrite Rmax_right in Hs by lra; apply Same; lra.
Qed.
Theorem rounded_load_of_pressure a : t < a -> exists p P0,
  are_the_pressures Es g1 a a p /\ is_the_load Es g1 a a P0 /\ is_integral_about_0 p a a P0.
Proof.
  intros Ha. assert (Hpi := PI_RGT_0).
  assert (Hmir : mirrored g1 = g1) by (apply slope_odd; repeat constructor; simpl; lra).
  destruct (load_of_pressure Es g1 rounded_load rounded_rate 1 a (Rabs (Es / R0) * (a * PI / 4 + t / 2))) as (Hp & HL & HI).
  - lra.
  - lra.
  - exact rounded_contact_at.
  - intros s _. apply rounded_rate_continuous.
  - intros s Hs. unfold rounded_load. rewrite Rabs_mult, Rmult_assoc. apply Rmult_le_compat_l; [apply Rabs_pos |].
    assert (A := atan_bound (h s / t)).
    assert (A0 : 0 <= atan (h s / t)).
    { rewrite <- atan_0. assert (0 <= h s / t) by (apply Rdiv_le_0_compat; [apply sqrt_pos | exact Ht]).
      destruct (Rle_lt_or_eq_dec 0 (h s / t) H) as [M | M]; [apply Rlt_le, atan_increasing, M | rewrite <- M; lra]. }
    assert (Hh : 0 <= h s <= s).
    { split; [apply sqrt_pos |]. rewrite <- (sqrt_pow2 s) at 2 by lra. apply sqrt_le_1_alt. nra. }
    apply Rabs_le. assert (0 <= s ^ 2 / 2) by nra.
    assert (s ^ 2 / 2 * atan (h s / t) <= s ^ 2 / 2 * (PI / 2)) by (apply Rmult_le_compat_l; lra).
    assert (0 <= s ^ 2 / 2 * atan (h s / t)) by (apply Rmult_le_pos; lra).
    assert (t / 2 * h s <= t / 2 * s) by (apply Rmult_le_compat_l; lra).
    assert (0 <= t / 2 * h s) by (apply Rmult_le_pos; lra).
    assert (s ^ 2 / 2 * (PI / 2) <= a * PI / 4 * s) by (replace (s ^ 2 / 2 * (PI / 2)) with (PI / 4 * s * s) by field; replace (a * PI / 4 * s) with (PI / 4 * s * a) by field; apply Rmult_le_compat_l; nra).
    assert (0 <= a * PI / 4 * s) by nra.
    split; nra.
  - intros x p Hx. apply rounded_the_pressure; [exact Ha | exact Hx].
  - rewrite Hmir, Rmult_1_l. intros y p Hy. apply rounded_the_pressure; [exact Ha | exact Hy].
  - rewrite Rmult_1_l in Hp, HI. eexists _, _. split; [exact Hp |]. split; [| exact HI].
    rewrite rounded_load_beyond by exact Ha. apply load_beyond_flat; assumption.
Qed.
End Rounded.

(* The load by the printed integral over the places, P = Es / 2 int s g'(s) / sqrt((a - s)(s + b)) ds. *)
Lemma load_over_places Es g1 a b P : 0 < a + b -> (forall s, continuous (fun s => s * g1 s) s) ->
  is_load Es g1 a b P -> exists l, is_RInt_gen (fun s => s * g1 s / sqrt ((a - s) * (s + b))) (at_right (- b)) (at_left a) l /\ Es / 2 * l = P.
Proof.
  intros Hab Hf HL. set (F := fun theta => place a b theta * g1 (place a b theta)).
  assert (X : ex_RInt F (- (PI / 2)) (PI / 2)).
  { apply (@ex_RInt_continuous R_CompleteNormedModule). intros theta _.
    apply (continuous_comp (place a b) (fun s => s * g1 s)); [| apply Hf]. unfold place.
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
  destruct X as [l Hl]. exists l. split; [exact (integral_over_places (fun s => s * g1 s) a b Hab Hf l Hl) |].
  assert (I := is_RInt_scal (V := R_NormedModule) F (- (PI / 2)) (PI / 2) (Es / 2) l Hl). exact (load_unique Es g1 a b _ _ I HL).
Qed.
Lemma over_symmetric_places (f : R -> R) a l : is_RInt_gen (fun s => f s / sqrt ((a - s) * (s + a))) (at_right (- a)) (at_left a) l ->
  is_RInt_gen (fun s => f s / sqrt (a ^ 2 - s ^ 2)) (at_right (- a)) (at_left a) l.
Proof.
  apply is_RInt_gen_ext. apply (Filter_prod _ _ _ (fun _ => True) (fun _ => True)); try apply filter_true.
  intros x y _ _ s _. f_equal. f_equal. ring.
Qed.
Ltac in_R := match goal with |- @eq _ ?x ?y => change (@eq R x y) end.
Lemma power_moment_continuous C m s : 0 <= m -> continuous (fun s => s * power_slope C m s) s.
Proof.
  intros Hm. apply (continuous_ext (fun s => C * power (m + 1) (Rabs s))).
  - intros x. destruct (Rtotal_order x 0) as [H | [-> | H]].
    + rewrite power_slope_left, Rabs_left, power_of_positive, Rpower_plus, Rpower_1 by lra. in_R. ring.
    + rewrite Rabs_R0. unfold power. destruct (Rlt_dec 0 0); [lra | in_R; ring].
    + rewrite power_slope_right, Rabs_pos_eq, power_of_positive, Rpower_plus, Rpower_1 by lra. in_R. ring.
  - apply continuous_times; [apply continuous_const |]. apply (continuous_comp Rabs (power (m + 1))).
    + apply continuous_Rabs.
    + apply power_continuous. lra.
Qed.
Lemma rounded_moment_continuous t R0 s : 0 < t -> 0 < R0 -> continuous (fun s => s * Symmetric.slope (rounded t R0) s) s.
Proof.
  intros Ht HR. apply continuous_times; [apply continuous_id |].
  apply (continuous_ext (fun x => / R0 * (Rmax x t - t + (Rmin x (- t) + t)))).
  - intros x. unfold Symmetric.slope, total, rounded, part_slope, from, corner, curvature, fold_right.
    destruct (Rlt_dec t x); [| destruct (Rlt_dec x (- t))].
    + rewrite Rmax_left, Rmin_right by lra. in_R. field. lra.
    + rewrite Rmax_right, Rmin_left by lra. in_R. field. lra.
    + rewrite Rmax_right, Rmin_right by lra. in_R. field. lra.
  - apply continuous_times; [apply continuous_const |]. apply continuous_add; [apply continuous_sub | apply continuous_add]; try apply continuous_const.
    + apply (continuous_ext (fun x => (x + t + Rabs (x - t)) / 2)).
      * intros x. unfold Rmax. destruct (Rle_dec x t); [rewrite Rabs_left1 by lra | rewrite Rabs_pos_eq by lra]; in_R; field.
      * apply continuous_quotient; [| apply continuous_const | lra]. apply continuous_add.
        -- apply continuous_add; [apply continuous_id | apply continuous_const].
        -- apply (continuous_comp (fun x => x - t) Rabs); [| apply continuous_Rabs]. apply continuous_sub; [apply continuous_id | apply continuous_const].
    + apply (continuous_ext (fun x => (x - t - Rabs (x + t)) / 2)).
      * intros x. unfold Rmin. destruct (Rle_dec x (- t)); [rewrite Rabs_left1 by lra | rewrite Rabs_pos_eq by lra]; in_R; field.
      * apply continuous_quotient; [| apply continuous_const | lra]. apply continuous_sub.
        -- apply continuous_sub; [apply continuous_id | apply continuous_const].
        -- apply (continuous_comp (fun x => x + t) Rabs); [| apply continuous_Rabs]. apply continuous_add; [apply continuous_id | apply continuous_const].
Qed.
Lemma wedge_moment_continuous phi alpha s : continuous (fun s => s * TiltedWedge.slope phi alpha s) s.
Proof.
  apply (continuous_ext (fun x => phi * Rabs x - alpha * x)).
  - intros x. unfold TiltedWedge.slope. destruct (Rlt_dec x 0); [rewrite Rabs_left by lra | rewrite Rabs_pos_eq by lra]; in_R; ring.
  - apply continuous_sub; apply continuous_times; try apply continuous_const; [apply continuous_Rabs | apply continuous_id].
Qed.

(* ---- Both integrals ---- *)

Theorem integrals_of_pressure Es C m t R0 a : 0 < C /\ 0 <= m /\ 0 < t < a /\ 0 < R0 ->
  (exists p P0, are_the_pressures Es (power_slope C m) a a p /\
    is_the_load Es (power_slope C m) a a P0 /\ is_integral_about_0 p a a P0) /\
  (exists p P0, are_the_pressures Es (Symmetric.slope (rounded t R0)) a a p /\
    is_the_load Es (Symmetric.slope (rounded t R0)) a a P0 /\ is_integral_about_0 p a a P0).
Proof.
  intros (HC & Hm & Ht & HR). split; [apply power_load_of_pressure; lra |].
  apply (rounded_load_of_pressure Es t R0); lra.
Qed.
Theorem loads_over_places Es C m t R0 a : 0 < C /\ 0 <= m /\ 0 < t < a /\ 0 < R0 ->
  (exists p P0 l, are_the_pressures Es (power_slope C m) a a p /\ is_integral_about_0 p a a P0 /\
    is_RInt_gen (fun s => s * power_slope C m s / sqrt (a ^ 2 - s ^ 2)) (at_right (- a)) (at_left a) l /\ Es / 2 * l = P0) /\
  (exists p P0 l, are_the_pressures Es (Symmetric.slope (rounded t R0)) a a p /\ is_integral_about_0 p a a P0 /\
    is_RInt_gen (fun s => s * Symmetric.slope (rounded t R0) s / sqrt (a ^ 2 - s ^ 2)) (at_right (- a)) (at_left a) l /\ Es / 2 * l = P0).
Proof.
  intros form. destruct form as (HC & Hm & Ht & HR).
  destruct (integrals_of_pressure Es C m t R0 a ltac:(repeat split; lra)) as [(p & P0 & Hp & [_ HP] & HI) (q & Q0 & Hq & [_ HQ] & HJ)]. split.
  - destruct (load_over_places Es _ a a P0 ltac:(lra) (fun s => power_moment_continuous C m s Hm) HP) as (l & Hl & E).
    exists p, P0, l. split; [exact Hp |]. split; [exact HI |]. split; [| exact E].
    exact (over_symmetric_places (fun s => s * power_slope C m s) a l Hl).
  - destruct (load_over_places Es _ a a Q0 ltac:(lra) (fun s => rounded_moment_continuous t R0 s ltac:(lra) HR) HQ) as (l & Hl & E).
    exists q, Q0, l. split; [exact Hq |]. split; [exact HJ |]. split; [| exact E].
    exact (over_symmetric_places (fun s => s * Symmetric.slope (rounded t R0) s) a l Hl).
Qed.
Theorem wedge_load_over_places Es phi gam a : 0 < phi /\ 0 < gam /\ 0 < a -> exists p P0 l,
  are_the_pressures Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) p /\ is_integral_about_0 p (gam * a) a P0 /\
  is_RInt_gen (fun s => s * TiltedWedge.slope phi (tilt phi gam) s / sqrt ((a - s) * (s + gam * a))) (at_right (- (gam * a))) (at_left a) l /\
  Es / 2 * l = P0.
Proof.
  intros form. destruct (wedge_load_of_pressure Es phi gam a form) as (p & P0 & Hp & [_ HP] & HI). destruct form as (_ & Hg & Ha).
  assert (0 < gam * a) by (apply Rmult_lt_0_compat; assumption).
  destruct (load_over_places Es _ a (gam * a) P0 ltac:(lra) (wedge_moment_continuous phi (tilt phi gam)) HP) as (l & Hl & E).
  exists p, P0, l. split; [exact Hp |]. split; [exact HI |]. split; [exact Hl | exact E].
Qed.
