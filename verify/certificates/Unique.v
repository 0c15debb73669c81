(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Shear.
Open Scope R_scope.

(* The slope of a convex punch: it does not decrease, it rises at y, and beyond y it is positive. *)
Definition rises_at (g1 : R -> R) (y : R) : Prop :=
  (forall x z, x <= z -> g1 x <= g1 z) /\
  (forall x, y < x -> 0 < g1 x) /\
  (forall d, 0 < d -> g1 (y - d) < g1 (y + d)).

(* A function that is nowhere negative, and at least c in an interval, has no integral of 0. *)
Lemma positive_integral (f : R -> R) (l r u v c : R) :
  l <= u -> u < v -> v <= r -> 0 < c ->
  (forall t, l < t < r -> 0 <= f t) -> (forall t, u < t < v -> c <= f t) ->
  is_RInt f l r 0 -> False.
Proof.
  intros Hl Huv Hr Hc Hpos Hf HI.
  assert (Hex : ex_RInt f l r) by (exists 0; exact HI).
  assert (Hlr : l <= r) by lra.
  assert (E1 : ex_RInt f l u) by (apply (ex_RInt_Chasles_1 f l u r); [lra | exact Hex]).
  assert (Eur : ex_RInt f u r) by (apply (ex_RInt_Chasles_2 f l u r); [lra | exact Hex]).
  assert (E2 : ex_RInt f u v) by (apply (ex_RInt_Chasles_1 f u v r); [lra | exact Eur]).
  assert (E3 : ex_RInt f v r) by (apply (ex_RInt_Chasles_2 f u v r); [lra | exact Eur]).
  assert (I1 : 0 <= RInt f l u) by (apply RInt_ge_0; [exact Hl | exact E1 | intros t Ht; apply Hpos; lra]).
  assert (I3 : 0 <= RInt f v r) by (apply RInt_ge_0; [exact Hr | exact E3 | intros t Ht; apply Hpos; lra]).
  assert (I2 : RInt (fun _ => c) u v <= RInt f u v).
  { apply RInt_le; [lra | apply ex_RInt_const | exact E2 | intros t Ht; apply Hf, Ht]. }
  rewrite RInt_const in I2. unfold scal in I2; simpl in I2; unfold mult in I2; simpl in I2.
  assert (Hsum : RInt f l r = 0) by (apply is_RInt_unique, HI).
  assert (C1 := RInt_Chasles f l u r E1 Eur). assert (C2 := RInt_Chasles f u v r E2 E3).
  unfold plus in C1, C2; simpl in C1, C2.
  assert (0 < (v - u) * c) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma place_increasing a b t z : 0 < a + b -> - (PI / 2) <= t -> t < z -> z <= PI / 2 -> place a b t < place a b z.
Proof.
  intros H Ht Htz Hz. assert (S : sin t < sin z) by (apply sin_increasing_1; lra). unfold place. nra.
Qed.
(* The place y of the contact, by its angle. *)
Lemma place_of_angle a b y : 0 < a + b -> - b < y < a ->
  exists t, - (PI / 2) < t < PI / 2 /\ place a b t = y.
Proof.
  intros H Hy. set (k := (2 * y - (a - b)) / (a + b)).
  assert (Hk : -1 < k < 1).
  { unfold k. split; apply (Rmult_lt_reg_r (a + b)); try lra; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra. }
  exists (asin k). split; [apply asin_bound_lt, Hk |].
  unfold place. rewrite sin_asin by lra. unfold k. field. lra.
Qed.
Lemma sin_less_1 t : - (PI / 2) < t < PI / 2 -> sin t < 1.
Proof. intros H. rewrite <- sin_PI2. apply sin_increasing_1; lra. Qed.

(* The contact reaches to the left of a place where the slope rises. *)
Lemma reaches_left g1 y a b : rises_at g1 y -> y < a -> 0 < a + b -> consistent g1 a b -> - b < y.
Proof.
  intros (Hmono & Hpos & _) Hya Hab HI. destruct (Rlt_le_dec (- b) y) as [H | H]; [exact H | exfalso].
  assert (Hpi := PI_RGT_0). assert (P0 : forall t, - (PI / 2) < t < PI / 2 -> y < place a b t).
  { intros t Ht. apply Rle_lt_trans with (place a b (- (PI / 2))).
    - unfold place. rewrite sin_neg, sin_PI2. lra.
    - apply place_increasing; lra. }
  refine (positive_integral (fun t => g1 (place a b t)) _ _ 0 (PI / 4) (g1 (place a b 0)) _ _ _ _ _ _ HI); try lra.
  - apply Hpos, P0. lra.
  - intros t Ht. apply Rlt_le, Hpos, P0, Ht.
  - intros t Ht. apply Hmono, Rlt_le, place_increasing; lra.
Qed.

Lemma left_edge_below g1 y a b c : rises_at g1 y -> y < a -> 0 < a + b -> b < c ->
  consistent g1 a b -> consistent g1 a c -> False.
Proof.
  intros Hg Hya Hab Hbc HIb HIc. assert (Hpi := PI_RGT_0).
  assert (Hb := reaches_left g1 y a b Hg Hya Hab HIb).
  assert (Hc : - c < y) by lra.
  destruct (place_of_angle a b y Hab ltac:(lra)) as (t & Ht & Et).
  destruct (place_of_angle a c y ltac:(lra) ltac:(lra)) as (z & Hz & Ez).
  assert (Lower : forall s, - (PI / 2) < s < PI / 2 -> place a c s < place a b s).
  { intros s Hs. assert (S := sin_less_1 s Hs). unfold place. nra. }
  assert (Htz : t < z).
  { destruct (Rlt_le_dec t z) as [H | H]; [exact H | exfalso].
    assert (L := Lower t Ht). rewrite Et in L. destruct (Rle_lt_or_eq_dec z t H) as [H' | H'].
    - assert (Q := place_increasing a c z t ltac:(lra) ltac:(lra) H' ltac:(lra)). lra.
    - subst z. lra. }
  set (u := t + (z - t) / 3). set (v := t + 2 * (z - t) / 3).
  assert (Hu : y < place a b u) by (rewrite <- Et; apply place_increasing; unfold u; lra).
  assert (Hv : place a c v < y) by (rewrite <- Ez; apply place_increasing; unfold v; lra).
  set (d := Rmin (place a b u - y) (y - place a c v)).
  assert (Hd : 0 < d) by (apply Rmin_pos; lra).
  assert (D1 := Rmin_l (place a b u - y) (y - place a c v)).
  assert (D2 := Rmin_r (place a b u - y) (y - place a c v)). fold d in D1, D2.
  destruct Hg as (Hmono & Hpos & Hrise).
  apply (positive_integral (fun s => g1 (place a b s) - g1 (place a c s)) (- (PI / 2)) (PI / 2) u v (g1 (y + d) - g1 (y - d)));
    try (unfold u, v; lra).
  - generalize (Hrise d Hd). lra.
  - intros s Hs. generalize (Hmono _ _ (Rlt_le _ _ (Lower s Hs))). lra.
  - intros s Hs.
    assert (g1 (y + d) <= g1 (place a b s)).
    { apply Hmono. apply Rle_trans with (place a b u); [lra |]. apply Rlt_le, place_increasing; unfold u, v in *; lra. }
    assert (g1 (place a c s) <= g1 (y - d)).
    { apply Hmono. apply Rle_trans with (place a c v); [| lra]. apply Rlt_le, place_increasing; unfold u, v in *; lra. }
    lra.
  - assert (H := is_RInt_minus (V := R_NormedModule) _ _ _ _ _ _ HIb HIc).
    unfold minus, plus, opp in H; simpl in H. rewrite Rplus_opp_r in H. exact H.
Qed.

(* Consistency determines the left edge. *)
Theorem left_edge_unique g1 y a b c : rises_at g1 y -> y < a -> 0 < a + b -> 0 < a + c ->
  consistent g1 a b -> consistent g1 a c -> b = c.
Proof.
  intros Hg Hya Hb Hc HIb HIc. destruct (Rtotal_order b c) as [H | [H | H]]; [exfalso | exact H | exfalso].
  - exact (left_edge_below g1 y a b c Hg Hya Hb H HIb HIc).
  - exact (left_edge_below g1 y a c b Hg Hya Hc H HIc HIb).
Qed.
Definition is_the_left_edge (g1 : R -> R) (a b : R) : Prop :=
  0 < a + b /\ consistent g1 a b /\ forall c, 0 < a + c -> consistent g1 a c -> c = b.
Lemma the_left_edge g1 y a b : rises_at g1 y -> y < a -> 0 < a + b -> consistent g1 a b -> is_the_left_edge g1 a b.
Proof.
  intros Hg Hya Hab HI. split; [exact Hab | split; [exact HI |]]. intros c Hc HIc.
  exact (left_edge_unique g1 y a c b Hg Hya Hc Hab HIc HI).
Qed.

(* The load of the contact with the right edge at a. *)
Definition is_the_load (Es : R) (g1 : R -> R) (a b P : R) : Prop := is_the_left_edge g1 a b /\ is_load Es g1 a b P.
Lemma load_unique Es g1 a b P Q : is_load Es g1 a b P -> is_load Es g1 a b Q -> P = Q.
Proof.
  unfold is_load. intros H1 H2.
  rewrite <- (is_RInt_unique (V := R_CompleteNormedModule) _ _ _ _ H1).
  rewrite <- (is_RInt_unique (V := R_CompleteNormedModule) _ _ _ _ H2). reflexivity.
Qed.

(* Barber and Mossakovskii's integral determines the pressure. *)
Theorem pressure_unique Es g1 y a x p q : rises_at g1 y -> y <= x -> x < a ->
  is_pressure Es g1 a x p -> is_pressure Es g1 a x q -> p = q.
Proof.
  intros Hg Hy Hxa (P & P1 & b & Hp & _ & Ip) (Q & Q1 & c & Hq & _ & Iq).
  assert (Eb : forall s, x < s <= a -> b s = c s).
  { intros s Hs. destruct (Hp s ltac:(lra)) as (Hw & Hc & _). destruct (Hq s ltac:(lra)) as (Hw' & Hc' & _).
    exact (left_edge_unique g1 y s (b s) (c s) Hg ltac:(lra) Hw Hw' Hc Hc'). }
  assert (EP : forall s, x < s < a -> P1 s = Q1 s).
  { intros s Hs. destruct (Hp s ltac:(lra)) as (_ & _ & Lp & Dp). destruct (Hq s ltac:(lra)) as (_ & _ & Lq & Dq).
    apply is_derive_unique in Dq. rewrite <- Dq. symmetry. apply is_derive_unique.
    apply (is_derive_ext_loc P); [| exact Dp].
    assert (In : locally s (fun r => x < r < a)).
    { apply (locally_near s (Rmin (s - x) (a - s))); [apply Rmin_pos; lra |]. intros r Hr.
      generalize (Rmin_l (s - x) (a - s)) (Rmin_r (s - x) (a - s)). lra. }
    apply (filter_imp (fun r => is_load Es g1 r (b r) (P r) /\ is_load Es g1 r (c r) (Q r) /\ x < r < a)).
    - intros r (L1 & L2 & Hr). rewrite <- (Eb r ltac:(lra)) in L2. exact (load_unique _ _ _ _ _ _ L1 L2).
    - exact (filter_and _ _ Lp (filter_and _ _ Lq In)). }
  apply (filterlim_locally_unique (V := R_NormedModule) (F := at_right x) (fun e => RInt (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + b s)))) e a)).
  - exact Ip.
  - apply (filterlim_ext_loc (fun e => RInt (fun s => 1 / PI * (Q1 s / sqrt ((s - x) * (x + c s)))) e a)); [| exact Iq].
    exists (mkposreal (a - x) ltac:(lra)). intros e He Hxe.
    unfold ball in He; simpl in He. unfold AbsRing_ball, abs, minus, plus, opp in He; simpl in He.
    apply Rabs_def2 in He.
    apply RInt_ext. intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra.
    rewrite <- Eb, <- EP by lra. reflexivity.
Qed.
Definition is_the_pressure (Es : R) (g1 : R -> R) (a x p : R) : Prop :=
  is_pressure Es g1 a x p /\ forall q, is_pressure Es g1 a x q -> q = p.
Lemma the_pressure Es g1 y a x p : rises_at g1 y -> y <= x < a -> is_pressure Es g1 a x p -> is_the_pressure Es g1 a x p.
Proof.
  intros Hg Hx H. split; [exact H |]. intros q Hq. apply (pressure_unique Es g1 y a x); try assumption; lra.
Qed.

(* ---- Coefficients ---- *)

(* Two functions that are equal to the right of 0 have the same Taylor polynomial there. *)
Lemma equal_at_0 (f g : R -> R) (d : R) :
  0 < d -> (forall u, 0 < u < d -> f u = g u) -> continuous f 0 -> continuous g 0 -> f 0 = g 0.
Proof.
  intros Hd E Hf Hg.
  apply (filterlim_locally_unique (V := R_NormedModule) (F := at_right 0) f).
  - intros A HA. apply filter_le_within. exact (Hf A HA).
  - apply (filterlim_ext_loc g).
    + exists (mkposreal d Hd). intros e He H0.
      unfold ball in He; simpl in He. unfold AbsRing_ball, abs, minus, plus, opp in He; simpl in He.
      apply Rabs_def2 in He. symmetry. apply E. lra.
    + intros A HA. apply filter_le_within. exact (Hg A HA).
Qed.
Lemma derivative_zero (f : R -> R) (d l : R) :
  0 < d -> (forall u, 0 <= u < d -> f u = 0) -> is_derive f 0 l -> l = 0.
Proof.
  intros Hd E H. apply is_derive_Reals in H.
  destruct (Req_dec l 0) as [H0 | H0]; [exact H0 | exfalso].
  destruct (H (Rabs l) (Rabs_pos_lt l H0)) as [[e He] Hlim].
  simpl in Hlim. set (h := Rmin e d / 2).
  assert (Hm : 0 < Rmin e d) by (apply Rmin_pos; assumption).
  generalize (Rmin_l e d) (Rmin_r e d). intros L1 L2.
  assert (Hh : 0 < h < e /\ h < d) by (unfold h; lra).
  specialize (Hlim h ltac:(lra)). rewrite Rabs_right in Hlim by lra.
  specialize (Hlim ltac:(lra)). rewrite Rplus_0_l, !E in Hlim by lra.
  replace ((0 - 0) / h - l) with (- l) in Hlim by (field; lra). rewrite Rabs_Ropp in Hlim. lra.
Qed.

Lemma taylor_unique (K K1 J J1 : R -> R) (d k2 j2 : R) : 0 < d ->
  (forall u, 0 < u < d -> K u = J u) ->
  (forall u, - d < u < d -> is_derive K u (K1 u)) -> (forall u, - d < u < d -> is_derive J u (J1 u)) ->
  is_derive K1 0 (2 * k2) -> is_derive J1 0 (2 * j2) -> J 0 = K 0 /\ J1 0 = K1 0 /\ j2 = k2.
Proof.
  intros Hd E HK HJ HK1 HJ1.
  assert (Cont : forall (f : R -> R) (s l : R), is_derive f s l -> continuous f s).
  { intros f s l H. apply (@ex_derive_continuous R_AbsRing R_NormedModule). exists l. exact H. }
  assert (E1 : forall u, 0 < u < d -> K1 u = J1 u).
  { intros u Hu. assert (H := HK u ltac:(lra)). apply is_derive_unique in H. rewrite <- H. apply is_derive_unique.
    apply (is_derive_ext_loc J); [| apply HJ; lra].
    apply (locally_near u (Rmin u (d - u))); [apply Rmin_pos; lra |]. intros r Hr.
    generalize (Rmin_l u (d - u)) (Rmin_r u (d - u)). intros. symmetry. apply E. lra. }
  assert (K0 : K 0 = J 0) by (apply (equal_at_0 K J d Hd E); [exact (Cont _ _ _ (HK 0 ltac:(lra))) | exact (Cont _ _ _ (HJ 0 ltac:(lra)))]).
  assert (K10 : K1 0 = J1 0) by (apply (equal_at_0 K1 J1 d Hd E1); [exact (Cont _ _ _ HK1) | exact (Cont _ _ _ HJ1)]).
  split; [symmetry; exact K0 | split; [symmetry; exact K10 |]].
  assert (D := is_derive_minus (V := R_NormedModule) _ _ _ _ _ HK1 HJ1). unfold minus, plus, opp in D; simpl in D.
  apply (derivative_zero _ d) in D; [lra | exact Hd |]. intros u Hu. simpl.
  destruct (Rle_lt_or_eq_dec 0 u ltac:(lra)) as [H | H]; [rewrite E1 by lra | rewrite <- H, K10]; ring.
Qed.

Theorem right_series_unique Es g1 y a k0 k1 k2 j0 j1 j2 : rises_at g1 y -> y < a ->
  right_edge_series Es g1 a k0 k1 k2 -> right_edge_series Es g1 a j0 j1 j2 -> j0 = k0 /\ j1 = k1 /\ j2 = k2.
Proof.
  intros Hg Hya (K & K1 & d & Hd & HP & HK & <- & <- & HK1) (J & J1 & e & He & HQ & HJ & <- & <- & HJ1).
  set (m := Rmin (Rmin d e) (a - y)).
  assert (Hm : 0 < m) by (unfold m; repeat apply Rmin_pos; lra).
  assert (M1 := Rmin_l (Rmin d e) (a - y)). assert (M2 := Rmin_r (Rmin d e) (a - y)).
  assert (M3 := Rmin_l d e). assert (M4 := Rmin_r d e). fold m in M1, M2.
  apply (taylor_unique K K1 J J1 m); try assumption.
  - intros u Hu. assert (Hr : 0 < sqrt u) by (apply sqrt_lt_R0; lra).
    apply (Rmult_eq_reg_l (sqrt u)); [| lra].
    apply (pressure_unique Es g1 y a (a - u)); try lra; try assumption; [apply HP | apply HQ]; lra.
  - intros u Hu. apply HK. lra.
  - intros u Hu. apply HJ. lra.
Qed.
Definition is_the_right_series (Es : R) (g1 : R -> R) (a k0 k1 k2 : R) : Prop :=
  right_edge_series Es g1 a k0 k1 k2 /\
  forall j0 j1 j2, right_edge_series Es g1 a j0 j1 j2 -> j0 = k0 /\ j1 = k1 /\ j2 = k2.
Definition is_the_left_series (Es : R) (g1 : R -> R) (b k0 k1 k2 : R) : Prop :=
  is_the_right_series Es (mirrored g1) b k0 k1 k2.
Lemma the_right_series Es g1 y a k0 k1 k2 : rises_at g1 y -> y < a ->
  right_edge_series Es g1 a k0 k1 k2 -> is_the_right_series Es g1 a k0 k1 k2.
Proof. intros Hg Hya H. split; [exact H |]. intros. exact (right_series_unique Es g1 y a _ _ _ _ _ _ Hg Hya H ltac:(eassumption)). Qed.

Definition is_the_right_shear_series (q : R -> R) (a k0 k1 k2 : R) : Prop :=
  right_shear_series q a k0 k1 k2 /\
  forall j0 j1 j2, right_shear_series q a j0 j1 j2 -> j0 = k0 /\ j1 = k1 /\ j2 = k2.
Definition is_the_left_shear_series (q : R -> R) (b k0 k1 k2 : R) : Prop :=
  is_the_right_shear_series (fun x => q (- x)) b k0 k1 k2.
Lemma the_right_shear_series q a k0 k1 k2 :
  right_shear_series q a k0 k1 k2 -> is_the_right_shear_series q a k0 k1 k2.
Proof.
  intros H. split; [exact H |]. intros j0 j1 j2.
  destruct H as (K & K1 & d & Hd & HP & HK & <- & <- & HK1). intros (J & J1 & e & He & HQ & HJ & <- & <- & HJ1).
  assert (Hm : 0 < Rmin d e) by (apply Rmin_pos; assumption).
  assert (M3 := Rmin_l d e). assert (M4 := Rmin_r d e).
  apply (taylor_unique K K1 J J1 (Rmin d e)); try assumption.
  - intros u Hu. assert (Hr : 0 < sqrt u) by (apply sqrt_lt_R0; lra).
    assert (E : K u / sqrt u = J u / sqrt u) by (rewrite <- HP, <- HQ by lra; reflexivity).
    apply (Rmult_eq_reg_r (/ sqrt u)); [exact E | apply Rinv_neq_0_compat; lra].
  - intros u Hu. apply HK. lra.
  - intros u Hu. apply HJ. lra.
Qed.

(* ---- The slopes of wedges and of symmetric punches rise ---- *)

Lemma wedge_rises phi alpha : - phi < alpha < phi -> rises_at (TiltedWedge.slope phi alpha) 0.
Proof.
  intros H. unfold TiltedWedge.slope. split; [| split].
  - intros x z Hxz. destruct (Rlt_dec x 0), (Rlt_dec z 0); lra.
  - intros x Hx. destruct (Rlt_dec x 0); lra.
  - intros d Hd. destruct (Rlt_dec (0 - d) 0), (Rlt_dec (0 + d) 0); lra.
Qed.
Lemma mirrored_wedge_rises phi alpha : - phi < alpha < phi -> rises_at (mirrored (TiltedWedge.slope phi alpha)) 0.
Proof.
  intros H. unfold mirrored, TiltedWedge.slope. split; [| split].
  - intros x z Hxz. destruct (Rlt_dec (- x) 0), (Rlt_dec (- z) 0); lra.
  - intros x Hx. destruct (Rlt_dec (- x) 0); lra.
  - intros d Hd. destruct (Rlt_dec (- (0 - d)) 0), (Rlt_dec (- (0 + d)) 0); lra.
Qed.
Lemma tilt_range phi gam : 0 < phi -> 0 < gam -> - phi < tilt phi gam < phi.
Proof.
  intros Hphi Hgam. assert (Hpi := PI_RGT_0). assert (Hk := asin_bound_lt _ (k_range gam Hgam)).
  unfold tilt. set (z := asin ((1 - gam) / (1 + gam))) in *.
  replace (2 * phi / PI * z) with (phi * (z / (PI / 2))) by (field; lra).
  assert (-1 < z / (PI / 2) < 1).
  { split; apply (Rmult_lt_reg_r (PI / 2)); try lra; unfold Rdiv at 2; try (rewrite Rmult_assoc, Rinv_l by lra); unfold Rdiv; try (rewrite (Rmult_assoc z), Rinv_l by lra); lra. }
  split; nra.
Qed.

Definition is_convex_part (q : part) : Prop := 0 <= from q /\ 0 <= corner q /\ 0 <= curvature q.
Lemma part_monotone q x z : is_convex_part q -> x <= z -> part_slope q x <= part_slope q z.
Proof.
  destruct q as [t d k]. unfold is_convex_part, part_slope; simpl. intros (Ht & Hd & Hk) Hxz.
  destruct (Rlt_dec t x), (Rlt_dec t z), (Rlt_dec x (- t)), (Rlt_dec z (- t)); try lra; try nra.
Qed.
Lemma part_positive q x : is_convex_part q -> 0 < corner q + curvature q -> from q < x -> 0 < part_slope q x.
Proof.
  destruct q as [t d k]. unfold is_convex_part, part_slope; simpl. intros (Ht & Hd & Hk) Hdk Hx.
  destruct (Rlt_dec t x); [| lra]. destruct (Rle_lt_or_eq_dec 0 d Hd) as [H | H].
  - assert (0 <= k * (x - t)) by (apply Rmult_le_pos; lra). lra.
  - assert (0 < k * (x - t)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma part_rises q d : is_convex_part q -> 0 < corner q + curvature q -> 0 < d ->
  part_slope q (from q - d) < part_slope q (from q + d).
Proof.
  intros Hq Hdk Hd. apply Rle_lt_trans with (part_slope q (from q)).
  - apply part_monotone; [exact Hq | lra].
  - destruct q as [t e k]. assert (H := part_positive (Part t e k) (t + d) Hq Hdk ltac:(simpl; lra)).
    simpl in *. destruct Hq as (Ht & He & Hk); simpl in *.
    apply Rle_lt_trans with 0; [| exact H]. unfold part_slope; simpl.
    destruct (Rlt_dec t t); [lra |]. destruct (Rlt_dec t (- t)); [| lra].
    assert (0 <= k * (- t - t)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma total_monotone l x z : List.Forall is_convex_part l -> x <= z -> Symmetric.slope l x <= Symmetric.slope l z.
Proof.
  intros Hl Hxz. unfold Symmetric.slope, total. induction Hl as [| q l Hq _ IH]; simpl; [lra |].
  generalize (part_monotone q x z Hq Hxz). lra.
Qed.
Lemma total_nonnegative l x : List.Forall is_convex_part l -> 0 < x -> 0 <= Symmetric.slope l x.
Proof.
  intros Hl Hx. unfold Symmetric.slope, total. induction Hl as [| q l Hq _ IH]; simpl; [lra |].
  assert (part_slope q 0 <= part_slope q x) by (apply part_monotone; [exact Hq | lra]).
  destruct q as [t d k]. unfold part_slope in *; simpl in *. destruct Hq as (Ht & _); simpl in Ht.
  destruct (Rlt_dec t 0) in *; destruct (Rlt_dec 0 (- t)) in *; lra.
Qed.
(* A sum of convex parts rises where its first part, with a corner or a curvature, begins. *)
Lemma symmetric_rises q l : List.Forall is_convex_part (cons q l) -> 0 < corner q + curvature q ->
  rises_at (Symmetric.slope (cons q l)) (from q).
Proof.
  intros H Hdk. inversion H as [| q' l' Hq Hl]; subst. split; [| split].
  - intros x z Hxz. apply total_monotone; assumption.
  - intros x Hx. unfold Symmetric.slope, total; simpl. assert (P := part_positive q x Hq Hdk Hx).
    destruct Hq as (Ht & _). assert (N := total_nonnegative l x Hl ltac:(lra)). unfold Symmetric.slope, total in N. lra.
  - intros d Hd. unfold Symmetric.slope, total; simpl. assert (P := part_rises q d Hq Hdk Hd).
    assert (M := total_monotone l (from q - d) (from q + d) Hl ltac:(lra)). unfold Symmetric.slope, total in M. lra.
Qed.
Lemma mirrored_symmetric_rises q l : List.Forall is_convex_part (cons q l) -> 0 < corner q + curvature q ->
  rises_at (mirrored (Symmetric.slope (cons q l))) (from q).
Proof.
  intros H Hdk. rewrite slope_odd; [apply symmetric_rises; assumption |].
  refine (List.Forall_impl _ _ H). intros p Hp. exact (proj1 Hp).
Qed.

Definition first (l : list part) : R := match l with nil => 0 | cons q _ => from q end.
(* A list of parts that begins with a part that is not zero. *)
Definition convex_punch (l : list part) : Prop :=
  match l with nil => False | cons q _ => List.Forall is_convex_part l /\ 0 < corner q + curvature q end.
Lemma punch_rises l : convex_punch l -> rises_at (Symmetric.slope l) (first l).
Proof. destruct l as [| q l]; [intros [] |]. intros [H Hq]. exact (symmetric_rises q l H Hq). Qed.
Lemma mirrored_punch_rises l : convex_punch l -> rises_at (mirrored (Symmetric.slope l)) (first l).
Proof. destruct l as [| q l]; [intros [] |]. intros [H Hq]. exact (mirrored_symmetric_rises q l H Hq). Qed.

Lemma the_left_series Es g1 y b k0 k1 k2 : rises_at (mirrored g1) y -> y < b ->
  left_edge_series Es g1 b k0 k1 k2 -> is_the_left_series Es g1 b k0 k1 k2.
Proof. exact (the_right_series Es (mirrored g1) y b k0 k1 k2). Qed.
Lemma the_left_shear_series q b k0 k1 k2 :
  left_shear_series q b k0 k1 k2 -> is_the_left_shear_series q b k0 k1 k2.
Proof. exact (the_right_shear_series (fun x => q (- x)) b k0 k1 k2). Qed.
Lemma the_load Es g1 y a b P : rises_at g1 y -> y < a -> 0 < a + b -> consistent g1 a b ->
  is_load Es g1 a b P -> is_the_load Es g1 a b P.
Proof. intros Hg Hy Hab HI HP. split; [exact (the_left_edge g1 y a b Hg Hy Hab HI) | exact HP]. Qed.
