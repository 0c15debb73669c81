(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Shear.
Open Scope R_scope.

(* The principal value of the integral of f over (l, r), with the pole x: the limit of the integrals
   over [l + e, x - e] and [x + e, r - e], which exist. *)
Definition is_principal_value (f : R -> R) (l r x v : R) : Prop :=
  exists d, 0 < d /\ (forall e, 0 < e < d -> ex_RInt f (l + e) (x - e) /\ ex_RInt f (x + e) (r - e)) /\
  filterlim (fun e => RInt f (l + e) (x - e) + RInt f (x + e) (r - e)) (at_right 0) (locally v).

(* By an antiderivative that is a logarithm and a continuous function. *)
Lemma principal_value (f h : R -> R) (l r x c v : R) : l < x < r ->
  (forall y z, l < y -> y <= z -> z < r -> z < x \/ x < y ->
    is_RInt f y z ((c * ln (Rabs (z - x)) + h z) - (c * ln (Rabs (y - x)) + h y))) ->
  filterlim h (at_right l) (locally (h l)) -> filterlim h (at_left r) (locally (h r)) -> continuous h x ->
  c * ln (r - x) + h r - (c * ln (x - l) + h l) = v ->
  is_principal_value f l r x v.
Proof.
  intros Hx HI Hl Hr Hc <-. set (d := Rmin ((x - l) / 2) ((r - x) / 2)).
  assert (Hd : 0 < d) by (unfold d; apply Rmin_pos; lra).
  assert (D1 := Rmin_l ((x - l) / 2) ((r - x) / 2)). assert (D2 := Rmin_r ((x - l) / 2) ((r - x) / 2)). fold d in D1, D2.
  assert (I1 : forall e, 0 < e < d -> is_RInt f (l + e) (x - e) ((c * ln e + h (x - e)) - (c * ln (x - l - e) + h (l + e)))).
  { intros e He. assert (I := HI (l + e) (x - e) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
    rewrite (Rabs_left (x - e - x)) in I by lra. rewrite (Rabs_left (l + e - x)) in I by lra.
    replace (- (x - e - x)) with e in I by ring. replace (- (l + e - x)) with (x - l - e) in I by ring. exact I. }
  assert (I2 : forall e, 0 < e < d -> is_RInt f (x + e) (r - e) ((c * ln (r - x - e) + h (r - e)) - (c * ln e + h (x + e)))).
  { intros e He. assert (I := HI (x + e) (r - e) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
    rewrite (Rabs_pos_eq (x + e - x)) in I by lra. rewrite (Rabs_pos_eq (r - e - x)) in I by lra.
    replace (x + e - x) with e in I by ring. replace (r - e - x) with (r - x - e) in I by ring. exact I. }
  exists d. split; [exact Hd |]. split.
  { intros e He. split; eexists; [apply I1, He | apply I2, He]. }
  apply (filterlim_ext_loc (fun e => (c * ln (r - x - e) - c * ln (x - l - e)) + (h (x - e) - h (x + e)) + (h (r - e) - h (l + e)))).
  { exists (mkposreal d Hd). intros e Hb He. unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb.
    apply Rabs_def2 in Hb. rewrite (is_RInt_unique _ _ _ _ (I1 e ltac:(lra))), (is_RInt_unique _ _ _ _ (I2 e ltac:(lra))). ring. }
  replace (locally (c * ln (r - x) + h r - (c * ln (x - l) + h l)))
    with (locally ((c * ln (r - x - 0) - c * ln (x - l - 0)) + (h (x - 0) - h (x + 0)) + (h r - h l)))
    by (f_equal; rewrite !Rminus_0_r, Rplus_0_r; ring).
  assert (Sum : forall (f g : R -> R) (m n : R), filterlim f (at_right 0) (locally m) -> filterlim g (at_right 0) (locally n) ->
    filterlim (fun e => f e + g e) (at_right 0) (locally (m + n))).
  { intros f0 g0 m n H1 H2. refine (filterlim_comp_2 f0 g0 Rplus H1 H2 _). apply (filterlim_plus (V := R_NormedModule) m n). }
  assert (Opp : forall (f : R -> R) (m : R), filterlim f (at_right 0) (locally m) -> filterlim (fun e => - f e) (at_right 0) (locally (- m))).
  { intros f0 m H. refine (filterlim_comp _ _ _ f0 Ropp _ _ _ H _). apply (filterlim_opp (V := R_NormedModule) m). }
  assert (Cont : forall (f : R -> R), continuous f 0 -> filterlim f (at_right 0) (locally (f 0))).
  { intros f0 H P HP. apply filter_le_within. exact (H P HP). }
  assert (Near : forall (y k : R), continuous (fun e => y + k * e) 0).
  { intros y k. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
  apply Sum; [apply Sum |].
  - apply (Cont (fun e => c * ln (r - x - e) - c * ln (x - l - e))).
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. repeat split; lra.
  - apply (Cont (fun e => h (x - e) - h (x + e))). apply continuous_sub.
    + apply (continuous_comp (fun e => x - e) h); [| rewrite Rminus_0_r; exact Hc].
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
    + apply (continuous_comp (fun e => x + e) h); [| rewrite Rplus_0_r; exact Hc].
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - apply (Sum (fun e => h (r - e)) (fun e => - h (l + e))); [| apply Opp].
    + refine (filterlim_comp _ _ _ (fun e => r - e) h _ (at_left r) _ _ Hr).
      intros P [e He]. exists e. intros z Hz H0. apply He; [| lra].
      unfold ball in *; simpl in *. unfold AbsRing_ball, abs, minus, plus, opp in *; simpl in *.
      replace (r - z + - r) with (- (z + - 0)) by ring. rewrite Rabs_Ropp. exact Hz.
    + refine (filterlim_comp _ _ _ (fun e => l + e) h _ (at_right l) _ _ Hl).
      intros P [e He]. exists e. intros z Hz H0. apply He; [| lra].
      unfold ball in *; simpl in *. unfold AbsRing_ball, abs, minus, plus, opp in *; simpl in *.
      replace (l + z + - l) with (z + - 0) by ring. exact Hz.
Qed.

(* ---- 1 / (sqrt((a - s)(s + b)) (s - x)) and 1 / sqrt((a - s)(s + b)) ---- *)

Section Kernel.
Variables a b x : R.
Hypothesis Hx : - b < x < a.
Definition kernel_root s := sqrt ((a - s) * (x + b)) + sqrt ((s + b) * (a - x)).
Definition kernel_angle s := 4 * atan (sqrt (s + b) / (sqrt (a + b) + sqrt (a - s))).
Let X := sqrt ((a - x) * (x + b)).

Lemma X_positive : 0 < X.
Proof. apply sqrt_lt_R0, Rmult_lt_0_compat; lra. Qed.
Lemma kernel_root_positive s : - b <= s <= a -> 0 < kernel_root s.
Proof.
  intros Hs. unfold kernel_root. assert (P1 := sqrt_pos ((a - s) * (x + b))). assert (P2 := sqrt_pos ((s + b) * (a - x))).
  destruct (Rlt_le_dec s a) as [H | H].
  - assert (0 < sqrt ((a - s) * (x + b))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra). lra.
  - assert (0 < sqrt ((s + b) * (a - x))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra). lra.
Qed.
Lemma of_root (f : R -> R) s : continuous f s -> continuous (fun s => sqrt (f s)) s.
Proof. intros H. apply (continuous_comp f sqrt); [exact H | apply continuous_sqrt]. Qed.
Ltac smooth := apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; trivial.
Lemma log_continuous s : - b <= s <= a -> continuous (fun s => ln (kernel_root s)) s.
Proof.
  intros Hs. apply (continuous_comp kernel_root ln).
  - unfold kernel_root. apply continuous_add; apply of_root; smooth.
  - assert (H := kernel_root_positive s Hs). smooth.
Qed.
Lemma angle_continuous s : - b <= s <= a -> continuous kernel_angle s.
Proof.
  intros Hs. unfold kernel_angle. apply continuous_times; [apply continuous_const |].
  apply (continuous_comp (fun s => sqrt (s + b) / (sqrt (a + b) + sqrt (a - s))) atan); [| smooth].
  apply continuous_quotient; [apply of_root; smooth | apply continuous_add; [apply continuous_const | apply of_root; smooth] |].
  assert (0 < sqrt (a + b)) by (apply sqrt_lt_R0; lra). generalize (sqrt_pos (a - s)). lra.
Qed.

Lemma log_derive s : - b < s < a -> s <> x ->
  is_derive (fun s => / X * (ln (Rabs (s - x)) - 2 * ln (kernel_root s))) s (/ (sqrt ((a - s) * (s + b)) * (s - x))).
Proof.
  intros Hs Hsx. assert (HX := X_positive). assert (HK := kernel_root_positive s ltac:(lra)).
  assert (EX : X = sqrt (a - x) * sqrt (x + b)) by (apply sqrt_mult; lra).
  assert (R1 : 0 < sqrt (a - x)) by (apply sqrt_lt_R0; lra). assert (R2 : 0 < sqrt (x + b)) by (apply sqrt_lt_R0; lra).
  assert (R3 : 0 < sqrt (a - s)) by (apply sqrt_lt_R0; lra). assert (R4 : 0 < sqrt (s + b)) by (apply sqrt_lt_R0; lra).
  assert (E1 : sqrt (a - x) * sqrt (a - x) = a - x) by (apply sqrt_sqrt; lra).
  assert (E2 : sqrt (x + b) * sqrt (x + b) = x + b) by (apply sqrt_sqrt; lra).
  assert (E3 : sqrt (a - s) * sqrt (a - s) = a - s) by (apply sqrt_sqrt; lra).
  assert (E4 : sqrt (s + b) * sqrt (s + b) = s + b) by (apply sqrt_sqrt; lra).
  assert (L : is_derive (fun s => ln (Rabs (s - x))) s (/ (s - x))).
  { destruct (Rlt_le_dec s x) as [H | H].
    - apply (is_derive_ext_loc (fun s => ln (x - s))).
      + apply (locally_near s (x - s)); [lra |]. intros r Hr. rewrite Rabs_left by lra. f_equal. ring.
      + auto_derive; [lra |]. field. lra.
    - apply (is_derive_ext_loc (fun s => ln (s - x))).
      + apply (locally_near s (s - x)); [lra |]. intros r Hr. rewrite Rabs_pos_eq by lra. reflexivity.
      + auto_derive; [lra |]. field. lra. }
  assert (Kd : is_derive kernel_root s (- sqrt (x + b) / (2 * sqrt (a - s)) + sqrt (a - x) / (2 * sqrt (s + b)))).
  { apply (is_derive_ext_loc (fun s => sqrt (a - s) * sqrt (x + b) + sqrt (s + b) * sqrt (a - x))).
    - apply (locally_near s (Rmin (s + b) (a - s))); [apply Rmin_pos; lra |]. intros r Hr.
      generalize (Rmin_l (s + b) (a - s)) (Rmin_r (s + b) (a - s)). intros. unfold kernel_root. rewrite !sqrt_mult by lra. reflexivity.
    - auto_derive; [lra |]. change (a + - s) with (a - s). change (a + - x) with (a - x). field. lra. }
  assert (EK : kernel_root s = sqrt (a - s) * sqrt (x + b) + sqrt (s + b) * sqrt (a - x)) by (unfold kernel_root; rewrite !sqrt_mult by lra; reflexivity).
  eapply (fun H E => eq_ind _ (fun v => is_derive _ s v) H _ E).
  - apply (is_derive_scal (fun s => ln (Rabs (s - x)) - 2 * ln (kernel_root s))).
    apply (is_derive_minus (V := R_NormedModule) (fun s => ln (Rabs (s - x))) (fun s => 2 * ln (kernel_root s))); [exact L |].
    apply (is_derive_scal (fun s => ln (kernel_root s))).
    apply (is_derive_comp ln kernel_root s (/ kernel_root s)); [| exact Kd].
    auto_derive; [exact HK |]. ring.
  - unfold minus, plus, opp, scal; simpl; unfold mult; simpl. match goal with |- @eq _ ?x ?y => change (@eq R x y) end.
    rewrite EX, (sqrt_mult (a - s)) by lra. rewrite EK in HK |- *.
    assert (Ex : x = sqrt (x + b) * sqrt (x + b) - b) by lra.
    set (p := sqrt (a - x)) in *. set (q := sqrt (x + b)) in *. set (r := sqrt (a - s)) in *. set (w := sqrt (s + b)) in *.
    assert (Esx : s - x = w * w - q * q) by lra. assert (Eab : r * r = p * p + q * q - w * w) by lra.
    assert (Hne : w * w - q * q <> 0) by (rewrite <- Esx; lra). rewrite Esx.
    clearbody p q r w. field_simplify_eq; [ring [Eab] | repeat split; lra].
Qed.
Lemma angle_derive s : - b < s < a -> is_derive kernel_angle s (/ sqrt ((a - s) * (s + b))).
Proof.
  intros Hs. assert (R0 : 0 < sqrt (a + b)) by (apply sqrt_lt_R0; lra).
  assert (R3 : 0 < sqrt (a - s)) by (apply sqrt_lt_R0; lra). assert (R4 : 0 < sqrt (s + b)) by (apply sqrt_lt_R0; lra).
  assert (E0 : sqrt (a + b) * sqrt (a + b) = a + b) by (apply sqrt_sqrt; lra).
  assert (E3 : sqrt (a - s) * sqrt (a - s) = a - s) by (apply sqrt_sqrt; lra).
  assert (E4 : sqrt (s + b) * sqrt (s + b) = s + b) by (apply sqrt_sqrt; lra).
  rewrite (sqrt_mult (a - s)) by lra. unfold kernel_angle. auto_derive; change (a + - s) with (a - s).
  - repeat split; lra.
  - set (m := sqrt (a + b)) in *. set (r := sqrt (a - s)) in *. set (w := sqrt (s + b)) in *.
    assert (E : m * m = r * r + w * w) by lra. clearbody m r w.
    assert (0 < m + r) by lra. assert (N : (m + r) ^ 2 + w ^ 2 <> 0) by nra.
    assert (N' : m * m + 2 * m * r + r * r + w * w <> 0) by nra.
    replace (1 + w * / (m + r) * (w * / (m + r) * 1)) with (((m + r) ^ 2 + w ^ 2) / (m + r) ^ 2) by (field; lra).
    field_simplify_eq; [ring [E] | repeat split; nra].
Qed.
Lemma kernel_angle_left : kernel_angle (- b) = 0.
Proof. unfold kernel_angle. rewrite Rplus_opp_l, sqrt_0. unfold Rdiv. rewrite Rmult_0_l, atan_0. ring. Qed.
Lemma kernel_angle_right : kernel_angle a = PI.
Proof.
  unfold kernel_angle. rewrite (Rminus_diag_eq a a), sqrt_0, Rplus_0_r by reflexivity.
  assert (0 < sqrt (a + b)) by (apply sqrt_lt_R0; lra). replace (sqrt (a + b) / sqrt (a + b)) with 1 by (field; lra).
  rewrite atan_1. field.
Qed.
Lemma log_of_ends : ln (a - x) - 2 * ln (kernel_root a) = ln (x + b) - 2 * ln (kernel_root (- b)).
Proof.
  unfold kernel_root. rewrite (Rminus_diag_eq a a), Rplus_opp_l, !Rmult_0_l, sqrt_0, Rplus_0_l, Rplus_0_r by reflexivity.
  replace (a - - b) with (a + b) by ring.
  assert (H : forall y, 0 < y -> 2 * ln (sqrt y) = ln y).
  { intros y Hy. rewrite <- (sqrt_sqrt y) at 2 by lra. rewrite ln_mult by (apply sqrt_lt_R0, Hy). ring. }
  rewrite !H by (apply Rmult_lt_0_compat; lra). rewrite !ln_mult by lra. ring.
Qed.

(* A linear function over this root, A + B (s - x). *)
Theorem principal_value_linear A B :
  is_principal_value (fun s => (A + B * (s - x)) / sqrt ((a - s) * (s + b)) / (s - x)) (- b) a x (B * PI).
Proof.
  assert (HX := X_positive).
  assert (C : forall s, - b <= s <= a -> continuous (fun s => - (2 * A / X) * ln (kernel_root s) + B * kernel_angle s) s).
  { intros s Hs. apply continuous_add; apply continuous_times; try apply continuous_const; [apply log_continuous | apply angle_continuous]; lra. }
  apply (principal_value _ (fun s => - (2 * A / X) * ln (kernel_root s) + B * kernel_angle s) _ _ _ (A / X)); [lra | | | | |].
  - intros y z Hy Hyz Hz Hside.
    replace (A / X * ln (Rabs (z - x)) + (- (2 * A / X) * ln (kernel_root z) + B * kernel_angle z) -
      (A / X * ln (Rabs (y - x)) + (- (2 * A / X) * ln (kernel_root y) + B * kernel_angle y)))
      with ((fun s => A * (/ X * (ln (Rabs (s - x)) - 2 * ln (kernel_root s))) + B * kernel_angle s) z -
        (fun s => A * (/ X * (ln (Rabs (s - x)) - 2 * ln (kernel_root s))) + B * kernel_angle s) y) by (field; lra).
    assert (Hr : forall s, y <= s <= z -> 0 < sqrt ((a - s) * (s + b))) by (intros s Hs; apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
    apply (is_RInt_antiderivative _ (fun s => A * / (sqrt ((a - s) * (s + b)) * (s - x)) + B * / sqrt ((a - s) * (s + b)))
      (fun s => A * (/ X * (ln (Rabs (s - x)) - 2 * ln (kernel_root s))) + B * kernel_angle s)); [exact Hyz | | |].
    + intros s Hs. assert (H := Hr s ltac:(lra)). field. lra.
    + intros s Hs. apply (is_derive_plus (V := R_NormedModule) (fun s => A * (/ X * (ln (Rabs (s - x)) - 2 * ln (kernel_root s)))) (fun s => B * kernel_angle s)).
      * apply (is_derive_scal (fun s => / X * (ln (Rabs (s - x)) - 2 * ln (kernel_root s)))), log_derive; lra.
      * apply (is_derive_scal kernel_angle), angle_derive. lra.
    + intros s Hs. assert (H := Hr s ltac:(lra)). assert (0 < (a - s) * (s + b)) by (apply Rmult_lt_0_compat; lra).
      assert (sqrt ((a - s) * (s + b)) * (s - x) <> 0) by (apply Rmult_integral_contrapositive_currified; lra).
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. change (a + - s) with (a - s). change (s + - x) with (s - x). repeat split; lra.
  - intros P HP. apply filter_le_within. exact (C (- b) ltac:(lra) P HP).
  - intros P HP. apply filter_le_within. exact (C a ltac:(lra) P HP).
  - apply C. lra.
  - rewrite kernel_angle_left, kernel_angle_right. replace (x - - b) with (x + b) by ring.
    replace (A / X * ln (a - x) + (- (2 * A / X) * ln (kernel_root a) + B * PI) - (A / X * ln (x + b) + (- (2 * A / X) * ln (kernel_root (- b)) + B * 0)))
      with (A / X * (ln (a - x) - 2 * ln (kernel_root a)) - A / X * (ln (x + b) - 2 * ln (kernel_root (- b))) + B * PI) by (field; lra).
    rewrite log_of_ends. ring.
Qed.
End Kernel.

(* The traction of full stick relieves the strain of the tension, everywhere in the contact. *)
Theorem strain_of_traction Q sig0 a b x : - b < x < a ->
  is_principal_value (fun s => full_stick Q sig0 a b s / (s - x)) (- b) a x (PI * sig0 / 4).
Proof.
  intros Hx. replace (PI * sig0 / 4) with (sig0 / 4 * PI) by field.
  assert (Hpi := PI_RGT_0).
  destruct (principal_value_linear a b x Hx (Q / PI + sig0 * (2 * x + b - a) / 8) (sig0 / 4)) as (d & Hd & He & Hl).
  set (m := Rmin d (Rmin ((x + b) / 2) ((a - x) / 2))).
  assert (Hm : 0 < m) by (unfold m; repeat apply Rmin_pos; lra).
  assert (M1 := Rmin_l d (Rmin ((x + b) / 2) ((a - x) / 2))). assert (M2 := Rmin_r d (Rmin ((x + b) / 2) ((a - x) / 2))).
  assert (M3 := Rmin_l ((x + b) / 2) ((a - x) / 2)). assert (M4 := Rmin_r ((x + b) / 2) ((a - x) / 2)). fold m in M1, M2.
  assert (E : forall s, - b < s < a -> s <> x ->
    (Q / PI + sig0 * (2 * x + b - a) / 8 + sig0 / 4 * (s - x)) / sqrt ((a - s) * (s + b)) / (s - x) = full_stick Q sig0 a b s / (s - x)).
  { intros s Hs Hsx. assert (0 < sqrt ((a - s) * (s + b))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
    unfold full_stick. field. repeat split; lra. }
  exists m. split; [exact Hm |]. split.
  - intros e Hem. destruct (He e ltac:(lra)) as [H1 H2]. split.
    + refine (ex_RInt_ext _ _ _ _ _ H1). intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra. apply E; lra.
    + refine (ex_RInt_ext _ _ _ _ _ H2). intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra. apply E; lra.
  - refine (filterlim_ext_loc _ _ _ Hl). exists (mkposreal m Hm). intros e Hb H0.
    unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb. apply Rabs_def2 in Hb.
    f_equal; apply RInt_ext; intros s Hs; rewrite Rmin_left in Hs by lra; rewrite Rmax_right in Hs by lra; apply E; lra.
Qed.

(* What full stick asks of a traction: the strain of the tension is relieved, and the force is Q. *)
Definition is_traction (q : R -> R) (a b Q sig0 : R) : Prop :=
  (forall x, - b < x < a -> is_principal_value (fun s => q s / (s - x)) (- b) a x (PI * sig0 / 4)) /\
  is_integral_between q (- b) a Q.
Theorem full_stick_is_traction Q sig0 a b : 0 < a + b -> is_traction (full_stick Q sig0 a b) a b Q sig0.
Proof. intros H. split; [apply strain_of_traction | exact (force_of_traction Q sig0 a b H)]. Qed.

(* The traction of one load, in units of Q / L or sig0, by the share xi of the contact from the edge. *)
Lemma root_of_share D xi : 0 < D -> 0 < xi < 1 -> sqrt (xi * D * (D - xi * D)) = D * sqrt (xi * (1 - xi)).
Proof.
  intros HD Hxi. replace (xi * D * (D - xi * D)) with (D ^ 2 * (xi * (1 - xi))) by ring.
  assert (0 <= xi * (1 - xi)) by nra. rewrite sqrt_mult by nra. rewrite sqrt_pow2 by lra. reflexivity.
Qed.
Lemma force_by_share Q a b xi : 0 < a + b -> Q <> 0 -> 0 < xi < 1 ->
  full_stick Q 0 a b (a - xi * (a + b)) * (a + b) / Q = 1 / (PI * sqrt (xi * (1 - xi))).
Proof.
  intros HD HQ Hxi. rewrite force_at, root_of_share by assumption.
  assert (0 < sqrt (xi * (1 - xi))) by (apply sqrt_lt_R0; nra). assert (Hpi := PI_RGT_0). field. repeat split; lra.
Qed.
Lemma tension_by_share sig0 a b xi : 0 < a + b -> sig0 <> 0 -> 0 < xi < 1 ->
  full_stick 0 sig0 a b (a - xi * (a + b)) / sig0 = (1 - 2 * xi) / (8 * sqrt (xi * (1 - xi))).
Proof.
  intros HD HQ Hxi. rewrite tension_at, root_of_share by assumption.
  assert (0 < sqrt (xi * (1 - xi))) by (apply sqrt_lt_R0; nra). field. repeat split; lra.
Qed.
Theorem force_independent a b c e Q N xi : 0 < a + b -> 0 < c + e -> Q <> 0 -> N <> 0 -> 0 < xi < 1 ->
  is_traction (full_stick Q 0 a b) a b Q 0 /\ is_traction (full_stick N 0 c e) c e N 0 /\
  full_stick Q 0 a b (a - xi * (a + b)) * (a + b) / Q = full_stick N 0 c e (c - xi * (c + e)) * (c + e) / N.
Proof.
  intros. split; [apply full_stick_is_traction; assumption |]. split; [apply full_stick_is_traction; assumption |].
  rewrite !force_by_share by assumption. reflexivity.
Qed.
Theorem tension_independent a b c e sig0 tau xi : 0 < a + b -> 0 < c + e -> sig0 <> 0 -> tau <> 0 -> 0 < xi < 1 ->
  is_traction (full_stick 0 sig0 a b) a b 0 sig0 /\ is_traction (full_stick 0 tau c e) c e 0 tau /\
  full_stick 0 sig0 a b (a - xi * (a + b)) / sig0 = full_stick 0 tau c e (c - xi * (c + e)) / tau.
Proof.
  intros. split; [apply full_stick_is_traction; assumption |]. split; [apply full_stick_is_traction; assumption |].
  rewrite !tension_by_share by assumption. reflexivity.
Qed.

(* Of all tractions (A + B s) / sqrt((a - s)(s + b)) it is the only one. *)
Lemma principal_value_unique f l r x v u : is_principal_value f l r x v -> is_principal_value f l r x u -> v = u.
Proof.
  intros (_ & _ & _ & H1) (_ & _ & _ & H2).
  exact (filterlim_locally_unique (V := R_NormedModule) (F := at_right 0) _ _ _ H1 H2).
Qed.
Theorem full_stick_of_form Q sig0 a b A B : 0 < a + b ->
  is_traction (fun s => (A + B * s) / sqrt ((a - s) * (s + b))) a b Q sig0 ->
  forall x, - b < x < a -> (A + B * x) / sqrt ((a - x) * (x + b)) = full_stick Q sig0 a b x.
Proof.
  intros HD [HS HF] x Hx. assert (Hpi := PI_RGT_0).
  set (N := PI * (A - B * (b - a) / 2)).
  assert (E : forall s, - b < s < a -> (A + B * s) / sqrt ((a - s) * (s + b)) = full_stick N (4 * B) a b s).
  { intros s Hs. assert (0 < sqrt ((a - s) * (s + b))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
    unfold full_stick, N. field. repeat split; lra. }
  assert (EB : B = sig0 / 4).
  { assert (P := principal_value_linear a b x Hx (A + B * x) B).
    assert (C : is_principal_value (fun s => (A + B * s) / sqrt ((a - s) * (s + b)) / (s - x)) (- b) a x (B * PI)).
    { destruct P as (d & Hd & He & Hl). exists d. split; [exact Hd |].
      assert (G : forall s, (A + B * x + B * (s - x)) / sqrt ((a - s) * (s + b)) / (s - x) = (A + B * s) / sqrt ((a - s) * (s + b)) / (s - x)) by (intros s; f_equal; f_equal; ring).
      split.
      - intros e Hee. destruct (He e Hee) as [H1 H2]. split; [refine (ex_RInt_ext _ _ _ _ _ H1) | refine (ex_RInt_ext _ _ _ _ _ H2)]; intros s _; apply G.
      - refine (filterlim_ext _ _ _ Hl). intros e. f_equal; apply RInt_ext; intros s _; apply G. }
    assert (V := principal_value_unique _ _ _ _ _ _ (HS x Hx) C). apply (Rmult_eq_reg_r PI); lra. }
  assert (EN : N = Q).
  { destruct HF as [_ L1]. destruct (force_of_traction N (4 * B) a b HD) as [_ L2].
    apply (filterlim_locally_unique (V := R_NormedModule) (F := at_right 0) (fun e => RInt (full_stick N (4 * B) a b) (- b + e) (a - e))).
    - exact L2.
    - refine (filterlim_ext_loc _ _ _ L1). exists (mkposreal ((a + b) / 2) ltac:(lra)). intros e Hb He.
      unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb. apply Rabs_def2 in Hb.
      apply RInt_ext. intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra. apply E. lra. }
  rewrite E, EN, EB by exact Hx. f_equal. field.
Qed.
