(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Symmetric Unique Tactics Sides Stick ClosedForm Inversion Resultant LoadOfPressure.
Open Scope R_scope.

(* The pressure of a parabola solves the equation of the contact problem itself: it displaces the
   surface by the profile, pv int p(s) / (s - x) ds = - pi Es / 2 g'(x), everywhere in the contact. *)

Section Semicircle.
Variables a x : R.
Hypothesis Hx : - a < x < a.
Let root s := sqrt ((a - s) * (s + a)).
(* (a^2 - s^2) / (root (s - x)) = (a^2 - x^2) / (root (s - x)) - (s + x) / root. *)
Let X := sqrt ((a - x) * (x + a)).
Let A := X * X.
Let h s := - (2 * X) * ln (kernel_root a a x s) + root s - x * kernel_angle a a s.
Let root_continuous s : continuous root s.
Proof.
  apply (continuous_comp (fun s => (a - s) * (s + a)) sqrt); [| apply continuous_sqrt].
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Let h_continuous s : - a <= s <= a -> continuous h s.
Proof.
  intros Hs. apply continuous_sub; [apply continuous_add; [| apply root_continuous] |]; apply continuous_times; try apply continuous_const.
  - apply (log_continuous a a x Hx). exact Hs.
  - apply (angle_continuous a a x Hx). exact Hs.
Qed.
Lemma semicircle_principal_value : is_principal_value (fun s => sqrt (a ^ 2 - s ^ 2) / (s - x)) (- a) a x (- (PI * x)).
Proof.
  assert (X0 : 0 < X) by (apply (X_positive a a x Hx)). assert (XX : X * X = (a - x) * (x + a)) by (apply sqrt_sqrt, Rmult_le_pos; lra).
  apply (principal_value _ h (- a) a x X); [exact Hx | | | | |].
  - intros y z Hy Hyz Hz Hside.
    set (F := fun s => X * X * (/ X * (ln (Rabs (s - x)) - 2 * ln (kernel_root a a x s))) + (root s - x * kernel_angle a a s)).
    replace (X * ln (Rabs (z - x)) + h z - (X * ln (Rabs (y - x)) + h y)) with (F z - F y) by (unfold F, h; field; lra).
    assert (Hr : forall s, y <= s <= z -> 0 < root s) by (intros s Hs; apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
    apply (is_RInt_antiderivative _ (fun s => X * X * / (root s * (s - x)) + (- s / root s - x * / root s)) F); [exact Hyz | | |].
    + intros s Hs. assert (R0 := Hr s ltac:(lra)). assert (RR : root s * root s = (a - s) * (s + a)) by (apply sqrt_sqrt, Rmult_le_pos; lra).
      replace (a ^ 2 - s ^ 2) with ((a - s) * (s + a)) by ring. change (sqrt ((a - s) * (s + a))) with (root s).
      rewrite XX. field_simplify_eq; [| split; lra]. replace (root s ^ 2) with (root s * root s) by ring. rewrite RR. ring.
    + intros s Hs. assert (R0 := Hr s ltac:(lra)).
      apply (is_derive_plus (V := R_NormedModule) (fun s => X * X * (/ X * (ln (Rabs (s - x)) - 2 * ln (kernel_root a a x s))))).
      * apply (is_derive_scal (fun s => / X * (ln (Rabs (s - x)) - 2 * ln (kernel_root a a x s)))). apply (log_derive a a x Hx); lra.
      * apply (is_derive_minus (V := R_NormedModule) root (fun s => x * kernel_angle a a s)).
        -- unfold root in *. auto_derive; [apply Rmult_lt_0_compat; lra |]. change (a + - s) with (a - s). field. apply Rgt_not_eq, R0.
        -- apply (is_derive_scal (kernel_angle a a)). apply (angle_derive a a x Hx). lra.
    + intros s Hs. assert (R0 := Hr s ltac:(lra)). assert (root s * (s - x) <> 0) by (apply Rmult_integral_contrapositive_currified; lra).
      assert (I : continuous (fun s => s - x) s) by (apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; trivial).
      assert (J : continuous (fun s => - s) s) by (apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; trivial).
      apply continuous_add.
      * apply continuous_times; [apply continuous_const |]. apply (continuous_comp (fun s => root s * (s - x)) Rinv); [| apply continuous_Rinv; assumption].
        apply continuous_times; [apply root_continuous | exact I].
      * apply continuous_sub; [apply continuous_quotient; [exact J | apply root_continuous | lra] |]. apply continuous_times; [apply continuous_const |].
        apply (continuous_comp root Rinv); [apply root_continuous | apply continuous_Rinv; lra].
  - intros P HP. apply filter_le_within. exact (h_continuous (- a) ltac:(lra) P HP).
  - intros P HP. apply filter_le_within. exact (h_continuous a ltac:(lra) P HP).
  - apply h_continuous. lra.
  - assert (E := log_of_ends a a x Hx). unfold h, root. rewrite (kernel_angle_left a a), (kernel_angle_right a a x Hx).
    rewrite (Rminus_diag_eq a a), (Rplus_opp_l a), Rmult_0_l, Rmult_0_r, sqrt_0 by reflexivity.
    replace (x - - a) with (x + a) by ring.
    replace (X * ln (a - x) + (- (2 * X) * ln (kernel_root a a x a) + 0 - x * PI) - (X * ln (x + a) + (- (2 * X) * ln (kernel_root a a x (- a)) + 0 - x * 0)))
      with (X * (ln (a - x) - 2 * ln (kernel_root a a x a)) - X * (ln (x + a) - 2 * ln (kernel_root a a x (- a))) - PI * x) by ring.
    rewrite E. ring.
Qed.
End Semicircle.

Lemma principal_value_scal (f : R -> R) k l r x v : is_principal_value f l r x v -> is_principal_value (fun s => k * f s) l r x (k * v).
Proof.
  intros (d & Hd & He & Hl). exists d. split; [exact Hd | split].
  - intros z Hz. destruct (He z Hz). split; apply (ex_RInt_scal (V := R_NormedModule)); assumption.
  - apply (filterlim_ext_loc (fun z => k * (RInt f (l + z) (x - z) + RInt f (x + z) (r - z)))).
    + exists (mkposreal d Hd). intros z Hb H0. unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb. apply Rabs_def2 in Hb.
      destruct (He z ltac:(lra)) as [E1 E2].
      assert (S : forall p q, ex_RInt f p q -> RInt (fun s => k * f s) p q = k * RInt f p q) by (intros p q E; exact (RInt_scal (V := R_CompleteNormedModule) f p q k E)).
      rewrite !S by assumption. ring.
    + refine (filterlim_comp _ _ _ _ (fun y => k * y) _ (locally v) _ Hl _). apply (filterlim_scal_r (K := R_AbsRing) (V := R_NormedModule) k v).
Qed.

Section Hertz.
Variables Es C a : R.
Hypothesis HC : 0 < C.
Hypothesis Ha : 0 < a.
Let g1 := Symmetric.slope (parabola C).
Let hertz s := Es * C / 2 * sqrt (a ^ 2 - s ^ 2).
Let angle_0 s : angle 0 s = PI / 2.
Proof. unfold angle, Rdiv. rewrite Rmult_0_l, atan_0. ring. Qed.
Let Rise : rises_at g1 0.
Proof. apply (punch_rises (parabola C)). split; [repeat constructor; simpl; lra | simpl; lra]. Qed.
Let Far s : 0 < s -> beyond s (parabola C).
Proof. intros H. repeat constructor; simpl; lra. Qed.
Let Even : mirrored g1 = g1.
Proof. apply slope_odd. repeat constructor; simpl; lra. Qed.
Let linear x : g1 x = C * x.
Proof.
  unfold g1, Symmetric.slope, total, parabola, part_slope, from, corner, curvature, fold_right.
  destruct (Rlt_dec 0 x); [ring |]. destruct (Rlt_dec x (- 0)); [ring |]. replace x with 0 by lra. ring.
Qed.
Let is_hertz x : 0 < x < a -> is_the_pressure Es g1 a x (hertz x).
Proof.
  intros Hx. apply (the_pressure _ _ 0); [exact Rise | lra |].
  assert (E : total (part_pressure Es x) (parabola C) a = hertz x).
  { unfold total, parabola, fold_right, part_pressure, from, corner, curvature, hertz. rewrite angle_0.
    replace (0 * sqrt (a ^ 2 - x ^ 2) / (x * sqrt (a ^ 2 - 0 ^ 2))) with 0 by (unfold Rdiv; ring). rewrite atanh_0. field. apply PI_neq0. }
  rewrite <- E. apply (pressure Es (parabola C) (x / 2)); [apply Far; lra | lra | lra].
Qed.
Theorem hertz_solves : exists P0,
  are_the_pressures Es g1 a a hertz /\ is_the_load Es g1 a a P0 /\ is_integral_about_0 hertz a a P0 /\
  forall x, - a < x < a -> is_principal_value (fun s => hertz s / (s - x)) (- a) a x (- (PI * Es / 2 * g1 x)).
Proof.
  assert (Hpi := PI_RGT_0).
  set (P := fun s => Es * C * PI / 4 * s ^ 2). set (P1 := fun s => Es * C * PI / 2 * s).
  assert (EP : load Es (parabola C) = P).
  { apply functional_extensionality. intros s. unfold P, load, total, parabola, fold_right, part_load, from, corner, curvature. rewrite angle_0. field. }
  assert (EP1 : rate Es (parabola C) = P1).
  { apply functional_extensionality. intros s. unfold P1, rate, total, parabola, fold_right, part_rate, from, corner, curvature. rewrite angle_0. replace (0 * s / sqrt (s ^ 2 - 0 ^ 2)) with 0 by (unfold Rdiv; ring). field. }
  destruct (load_of_pressure Es g1 P P1 1 a (Rabs (Es * C * PI / 4) * a)) as (Hp & HL & HI).
  - lra.
  - exact Ha.
  - intros s Hs. replace (fun s => 1 * s) with (fun s : R => s) by (apply functional_extensionality; intros; ring).
    rewrite <- EP, <- EP1. apply (contact_at Es (parabola C) (s / 2)); [apply Far; lra | lra].
  - intros s _. apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold P1. auto_derive. trivial.
  - intros s Hs. unfold P. rewrite Rabs_mult, (Rmult_assoc (Rabs _)). apply Rmult_le_compat_l; [apply Rabs_pos |]. rewrite Rabs_pos_eq by apply pow2_ge_0. nra.
  - intros x p Hx. apply (the_pressure _ _ 0); [exact Rise | lra].
  - rewrite Even. intros y p Hy. apply (the_pressure _ _ 0); [exact Rise | lra].
  - rewrite Rmult_1_l in Hp, HL, HI. destruct Hp as [Hr Hl]. rewrite Even in Hl.
    assert (Er : forall x, 0 < x < a -> side_pressure P1 1 a x = hertz x).
    { intros x Hx. symmetry. apply (proj2 (Hr x Hx)). apply is_hertz, Hx. }
    assert (El : forall y, 0 < y < a -> side_pressure P1 1 a (- y) = hertz (- y)).
    { intros y Hy. symmetry. apply (proj2 (Hl y Hy)). replace (hertz (- y)) with (hertz y) by (unfold hertz; do 2 f_equal; ring). apply is_hertz, Hy. }
    exists (P a). split; [| split; [| split]].
    + split; [exact is_hertz |]. rewrite Even. intros y Hy. rewrite <- El by exact Hy. exact (Hl y Hy).
    + apply (the_load _ _ 0); [exact Rise | exact Ha | lra | | exact HL]. apply consistent_total, Far, Ha.
    + destruct HI as (l & r & Il & Ir & E). exists l, r. split; [| split; [| exact E]].
      * refine (is_RInt_gen_ext _ _ _ _ Il). apply (Filter_prod _ _ _ (fun x => - a < x < 0) (fun x => - a < x < 0)).
        -- exists (mkposreal a Ha). intros x Hx Hlx. unfold ball in Hx; simpl in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx; simpl in Hx. apply Rabs_def2 in Hx. lra.
        -- exists (mkposreal a Ha). intros x Hx Hlx. unfold ball in Hx; simpl in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx; simpl in Hx. apply Rabs_def2 in Hx. lra.
        -- intros c d Hc Hd x. simpl. unfold Rmin, Rmax. destruct (Rle_dec c d); intros Hx; rewrite <- (Ropp_involutive x); apply El; lra.
      * refine (is_RInt_gen_ext _ _ _ _ Ir). apply (Filter_prod _ _ _ (fun x => 0 < x < a) (fun x => 0 < x < a)).
        -- exists (mkposreal a Ha). intros x Hx Hlx. unfold ball in Hx; simpl in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx; simpl in Hx. apply Rabs_def2 in Hx. lra.
        -- exists (mkposreal a Ha). intros x Hx Hlx. unfold ball in Hx; simpl in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx; simpl in Hx. apply Rabs_def2 in Hx. lra.
        -- intros c d Hc Hd x. simpl. unfold Rmin, Rmax. destruct (Rle_dec c d); intros Hx; apply Er; lra.
    + intros x Hx. rewrite linear. replace (- (PI * Es / 2 * (C * x))) with (Es * C / 2 * - (PI * x)) by field.
      apply (principal_value_ext (fun s => Es * C / 2 * (sqrt (a ^ 2 - s ^ 2) / (s - x)))); [exact Hx | |].
      * intros s _ Hsx. unfold hertz. unfold Rdiv. ring.
      * apply principal_value_scal, semicircle_principal_value, Hx.
Qed.
End Hertz.

(* The pressure by the inversion of the singular integral equation is the printed integral of the
   rate of the load. *)
Theorem inversion_by_loads Es m a x l : convex_punch l -> beyond m l -> 0 < m < x -> x < a -> exists P P1 p0 l0,
  (forall s, x <= s <= a -> is_the_load Es (Symmetric.slope l) s s (P s) /\ is_derive P s (P1 s)) /\
  is_principal_value (fun s => Symmetric.slope l s / sqrt (a ^ 2 - s ^ 2) * (1 / (s - x))) (- a) a x l0 /\
  Es / (2 * PI) * sqrt (a ^ 2 - x ^ 2) * l0 = p0 /\
  is_improper_integral (fun s => 1 / PI * (P1 s / sqrt (s ^ 2 - x ^ 2))) x a p0.
Proof.
  intros Hc Hl Hm Hx. destruct (the_pressure_by_inversion Es l m a x Hc Hl Hm Hx) as (p0 & l0 & [_ Hp] & Hv & E).
  assert (Contact : forall s, m < s -> is_contact_at Es (Symmetric.slope l) (load Es l) (rate Es l) (fun s => s) s).
  { intros s Hs. apply (contact_at Es l m Hl). lra. }
  assert (D : forall s, m < s -> is_derive (rate Es l) s (rate_2 Es l s)).
  { intros s Hs. apply total_derive, (each l m Hl). intros. apply part_rate_derive. lra. }
  assert (I := pressure_by_square (rate Es l) (fun s => s) x a Hx
    (fun s Hs => ex_derive_continuous (V := R_NormedModule) (rate Es l) s (ex_intro _ _ (D s ltac:(lra)))) (fun s _ => continuous_id s) (fun s Hs => ltac:(lra))).
  assert (F : first l <= m).
  { destruct Hl as [| q l Hq _]; [destruct Hc |]. simpl in *. lra. }
  assert (K : forall s, x <= s <= a -> is_contact_at Es (Symmetric.slope l) (load Es l) (rate Es l) (fun s => s) s) by (intros s Hs; apply Contact; lra).
  exists (load Es l), (rate Es l), p0, l0. split; [| split; [exact Hv | split; [exact E |]]].
  - intros s Hs. destruct (Contact s ltac:(lra)) as (_ & C & L & R). split; [| exact R].
    apply (the_load _ _ (first l)); [apply punch_rises, Hc | lra | lra | exact C | exact (locally_singleton _ _ L)].
  - rewrite <- (Hp _ (ex_intro _ (load Es l) (ex_intro _ (rate Es l) (ex_intro _ (fun s => s) (conj K I))))).
    destruct I as [I1 I2]. assert (Sq : forall s, 1 / PI * (rate Es l s / sqrt ((s - x) * (x + s))) = 1 / PI * (rate Es l s / sqrt (s ^ 2 - x ^ 2))).
    { intros s. do 3 f_equal. ring. }
    split.
    + intros e He. apply (ex_RInt_ext (fun s => 1 / PI * (rate Es l s / sqrt ((s - x) * (x + s))))); [intros s _; apply Sq | apply I1, He].
    + refine (filterlim_ext _ _ _ I2). intros e. apply RInt_ext. intros s _. apply Sq.
Qed.
