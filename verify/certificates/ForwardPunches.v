(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Unique Stick ClosedForm Limits Similar Inversion Resultant LoadOfPressure Forward Dilogarithm LogPressure.
Open Scope R_scope.

(* The pressures of tilted wedges and of flat punches with rounded edges solve the equation of the contact
   problem itself, pv int p(s) / (s - x) ds = - pi Es / 2 g'(x). *)

(* The principal value of an integral over (-b, a) of a function that may be unbounded at 0, too: on the side of
   the pole x, the limit leaves out a neighbourhood of 0; the integral over the other side is improper. *)
Definition is_principal_value_about_0 (f : R -> R) (b a x v : R) : Prop :=
  (0 < x /\ exists l r, is_RInt_gen f (at_right (- b)) (at_left 0) l /\ is_principal_value f 0 a x r /\ l + r = v) \/
  (x < 0 /\ exists l r, is_principal_value f (- b) 0 x l /\ is_RInt_gen f (at_right 0) (at_left a) r /\ l + r = v).

Lemma same_integral Es g1 a b (p q : R -> R) v : 0 < a -> 0 < b -> are_the_pressures Es g1 a b p -> are_the_pressures Es g1 a b q ->
  is_integral_about_0 p b a v -> is_integral_about_0 q b a v.
Proof.
  intros Ha Hb [Pr Pl] [Qr Ql] (l & r & Il & Ir & E).
  assert (Er : forall x, 0 < x < a -> p x = q x) by (intros x Hx; apply (proj2 (Qr x Hx)), (Pr x Hx)).
  assert (El : forall x, - b < x < 0 -> p x = q x).
  { intros x Hx. rewrite <- (Ropp_involutive x). apply (proj2 (Ql (- x) ltac:(lra))), (Pl (- x) ltac:(lra)). }
  exists l, r. split; [| split; [| exact E]].
  - refine (is_RInt_gen_ext _ _ _ _ Il). apply (Filter_prod _ _ _ (fun x => - b < x < 0) (fun x => - b < x < 0)).
    + exists (mkposreal b Hb). intros x Hx Hl. unfold ball in Hx; simpl in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx; simpl in Hx. apply Rabs_def2 in Hx. lra.
    + exists (mkposreal b Hb). intros x Hx Hl. unfold ball in Hx; simpl in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx; simpl in Hx. apply Rabs_def2 in Hx. lra.
    + intros c d Hc Hd x. simpl. unfold Rmin, Rmax. destruct (Rle_dec c d); intros Hx; apply El; lra.
  - refine (is_RInt_gen_ext _ _ _ _ Ir). apply (Filter_prod _ _ _ (fun x => 0 < x < a) (fun x => 0 < x < a)).
    + exists (mkposreal a Ha). intros x Hx Hl. unfold ball in Hx; simpl in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx; simpl in Hx. apply Rabs_def2 in Hx. lra.
    + exists (mkposreal a Ha). intros x Hx Hl. unfold ball in Hx; simpl in Hx. unfold AbsRing_ball, abs, minus, plus, opp in Hx; simpl in Hx. apply Rabs_def2 in Hx. lra.
    + intros c d Hc Hd x. simpl. unfold Rmin, Rmax. destruct (Rle_dec c d); intros Hx; apply Er; lra.
Qed.

(* ---- Tilted wedges ---- *)

Definition wedge_pressure (Es phi gam a s : R) : R := Es * phi / PI * log_pressure a (gam * a) 0 s.

Lemma as_atanh K s c u v : 0 < K -> 0 < s -> 0 < c -> 0 <= u < v -> K * K * ((v - u) * (v + u)) = K * K * (s * c) ->
  2 * ln (K * (v + u)) - ln s - ln (K * K * c) = 2 * atanh (u / v).
Proof.
  intros HK Hs Hc Hu E. assert (E1 : (v - u) * (v + u) = s * c) by (apply (Rmult_eq_reg_l (K * K)); [exact E | nra]).
  unfold atanh. replace ((1 + u / v) / (1 - u / v)) with ((v + u) / (v - u)) by (field; lra).
  replace (2 * (/ 2 * ln ((v + u) / (v - u)))) with (ln ((v + u) / (v - u))) by field.
  assert (R : (v + u) / (v - u) = (v + u) * (v + u) * / (s * c)) by (rewrite <- E1; field; lra).
  rewrite R, (ln_mult ((v + u) * (v + u))), ln_Rinv, (ln_mult (v + u)), (ln_mult K (v + u)), (ln_mult (K * K)), (ln_mult K K), (ln_mult s c)
    by (try apply Rinv_0_lt_compat; try apply Rmult_lt_0_compat; lra). ring.
Qed.

Section Wedge.
Variables Es phi gam a : R.
Hypothesis Hphi : 0 < phi.
Hypothesis Hgam : 0 < gam.
Hypothesis Ha : 0 < a.
Let g1 := TiltedWedge.slope phi (tilt phi gam).
Let p := wedge_pressure Es phi gam a.
Let Hb : 0 < gam * a. Proof. apply Rmult_lt_0_compat; assumption. Qed.
Let Rg : 0 < sqrt gam. Proof. apply sqrt_lt_R0, Hgam. Qed.
Let Ra : 0 < sqrt a. Proof. apply sqrt_lt_R0, Ha. Qed.
Let Eg : sqrt gam * sqrt gam = gam. Proof. apply sqrt_sqrt. lra. Qed.
Let Ea : sqrt a * sqrt a = a. Proof. apply sqrt_sqrt. lra. Qed.
Let kernel s : - (gam * a) < s < a -> kernel_root a (gam * a) 0 s = sqrt a * (sqrt (s + gam * a) + sqrt gam * sqrt (a - s)).
Proof.
  intros Hs. unfold kernel_root. rewrite Rplus_0_l, Rminus_0_r. rewrite !sqrt_mult by lra. ring.
Qed.
Lemma wedge_pressure_right s : 0 < s < a -> p s = proportional_pressure (Es * phi * sqrt gam) gam a s.
Proof.
  intros Hs. assert (Hpi := PI_RGT_0). unfold p, wedge_pressure, proportional_pressure, log_pressure. rewrite kernel, Rminus_0_r, Rabs_pos_eq by lra.
  assert (E3 : sqrt (a - s) * sqrt (a - s) = a - s) by (apply sqrt_sqrt; lra). assert (E4 : sqrt (s + gam * a) * sqrt (s + gam * a) = s + gam * a) by (apply sqrt_sqrt; lra).
  assert (R3 : 0 < sqrt (a - s)) by (apply sqrt_lt_R0; lra). assert (R4 : 0 < sqrt (s + gam * a)) by (apply sqrt_lt_R0; lra).
  assert (S := as_atanh (sqrt a) s (1 + gam) (sqrt gam * sqrt (a - s)) (sqrt (s + gam * a)) Ra ltac:(lra) ltac:(lra)).
  replace (sqrt a * sqrt a * (1 + gam)) with (a + gam * a) in S by (rewrite Ea; ring). rewrite S.
  - field. lra.
  - split; [apply Rmult_le_pos; lra |]. rewrite <- sqrt_mult by lra. apply sqrt_lt_1_alt. nra.
  - f_equal. replace ((sqrt (s + gam * a) - sqrt gam * sqrt (a - s)) * (sqrt (s + gam * a) + sqrt gam * sqrt (a - s)))
      with (sqrt (s + gam * a) * sqrt (s + gam * a) - (sqrt gam * sqrt gam) * (sqrt (a - s) * sqrt (a - s))) by ring. rewrite E3, E4, Eg. ring.
Qed.
Lemma wedge_pressure_left y : 0 < y < gam * a -> p (- y) = proportional_pressure (Es * phi * sqrt gam / gam) (/ gam) (gam * a) y.
Proof.
  intros Hs. assert (Hpi := PI_RGT_0). unfold p, wedge_pressure, proportional_pressure, log_pressure. rewrite kernel, Rminus_0_r, Rabs_left by lra.
  replace (a - - y) with (a + y) by ring. replace (- y + gam * a) with (gam * a - y) by ring. replace (- - y) with y by ring. replace (y + / gam * (gam * a)) with (a + y) by (field; lra).
  assert (E3 : sqrt (a + y) * sqrt (a + y) = a + y) by (apply sqrt_sqrt; lra). assert (E4 : sqrt (gam * a - y) * sqrt (gam * a - y) = gam * a - y) by (apply sqrt_sqrt; lra).
  assert (R3 : 0 < sqrt (a + y)) by (apply sqrt_lt_R0; lra). assert (R4 : 0 < sqrt (gam * a - y)) by (apply sqrt_lt_R0; lra).
  assert (S := as_atanh (sqrt a) y (1 + gam) (sqrt (gam * a - y)) (sqrt gam * sqrt (a + y)) Ra ltac:(lra) ltac:(lra)).
  replace (sqrt a * sqrt a * (1 + gam)) with (a + gam * a) in S by (rewrite Ea; ring). rewrite (Rplus_comm (sqrt (gam * a - y))). rewrite S.
  - rewrite sqrt_inv. replace (/ sqrt gam * sqrt (gam * a - y) / sqrt (a + y)) with (sqrt (gam * a - y) / (sqrt gam * sqrt (a + y))) by (field; lra).
    rewrite <- Eg at 4. field. repeat split; lra.
  - split; [lra |]. rewrite <- sqrt_mult by lra. apply sqrt_lt_1_alt. nra.
  - f_equal. replace ((sqrt gam * sqrt (a + y) - sqrt (gam * a - y)) * (sqrt gam * sqrt (a + y) + sqrt (gam * a - y)))
      with ((sqrt gam * sqrt gam) * (sqrt (a + y) * sqrt (a + y)) - sqrt (gam * a - y) * sqrt (gam * a - y)) by ring. rewrite E3, E4, Eg. ring.
Qed.
Lemma wedge_pressures : are_the_pressures Es g1 a (gam * a) p.
Proof.
  assert (T := tilt_range phi gam Hphi Hgam). split.
  - intros x Hx. apply (the_pressure _ _ 0); [apply wedge_rises, T | lra |]. rewrite wedge_pressure_right by exact Hx. apply pressure_right_of_apex; assumption.
  - intros y Hy. apply (the_pressure _ _ 0); [apply mirrored_wedge_rises, T | lra |]. rewrite wedge_pressure_left by exact Hy. apply pressure_left_of_apex; assumption.
Qed.
Let value x : x <> 0 -> Es * phi / PI * corner_value a (gam * a) 0 x = - (PI * Es / 2 * g1 x).
Proof.
  intros Hx. assert (Hpi := PI_RGT_0). unfold corner_value, g1, TiltedWedge.slope, tilt.
  replace ((2 * 0 + gam * a - a) / (a + gam * a)) with (- ((1 - gam) / (1 + gam))) by (field; lra). rewrite asin_opp.
  destruct (Rlt_dec 0 x), (Rlt_dec x 0); try lra; field; lra.
Qed.
Theorem wedge_solves : exists P0,
  are_the_pressures Es g1 a (gam * a) p /\ is_the_load Es g1 a (gam * a) P0 /\ is_integral_about_0 p (gam * a) a P0 /\
  forall x, - (gam * a) < x < a -> x <> 0 -> is_principal_value_about_0 (fun s => p s / (s - x)) (gam * a) a x (- (PI * Es / 2 * g1 x)).
Proof.
  destruct (wedge_load_of_pressure Es phi gam a (conj Hphi (conj Hgam Ha))) as (p' & P0 & Hp & HL & HI).
  exists P0. split; [exact wedge_pressures | split; [exact HL | split; [exact (same_integral _ _ _ _ _ _ _ Ha Hb Hp wedge_pressures HI) |]]].
  intros x Hx Nx. rewrite <- value by exact Nx. set (k := Es * phi / PI).
  assert (F : (fun s => p s / (s - x)) = (fun s => k * (log_pressure a (gam * a) 0 s / (s - x)))).
  { apply functional_extensionality. intros s. change (p s) with (k * log_pressure a (gam * a) 0 s). unfold Rdiv. ring. }
  rewrite F. destruct (Rlt_le_dec 0 x) as [L | L].
  - left. split; [exact L |]. destruct (corner_right a (gam * a) 0 ltac:(lra) x ltac:(lra)) as (v & v' & I & I' & E).
    exists (k * v), (k * v'). split; [exact (is_RInt_gen_scal (V := R_NormedModule) _ k v I) | split; [apply principal_value_scal, I' | rewrite <- E; ring]].
  - right. split; [lra |]. destruct (corner_left a (gam * a) 0 ltac:(lra) x ltac:(lra)) as (v & v' & I & I' & E).
    exists (k * v), (k * v'). split; [apply principal_value_scal, I | split; [exact (is_RInt_gen_scal (V := R_NormedModule) _ k v' I') | rewrite <- E; ring]].
Qed.
(* The pressures as printed, by the rate of the load. *)
Theorem wedge_solves_by_loads : exists P P1 : R -> R,
  (forall s, 0 < s -> is_the_load Es g1 s (gam * s) (P s) /\ is_derive P s (P1 s)) /\
  (forall x, 0 < x < a -> is_improper_integral (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + gam * s)))) x a (p x)) /\
  (forall x, - (gam * a) < x < 0 -> is_improper_integral (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + gam * s)))) (- x / gam) a (p x)) /\
  is_integral_about_0 p (gam * a) a (P a) /\
  forall x, - (gam * a) < x < a -> x <> 0 -> is_principal_value_about_0 (fun s => p s / (s - x)) (gam * a) a x (- (PI * Es / 2 * g1 x)).
Proof.
  assert (T := tilt_range phi gam Hphi Hgam). assert (Hpi := PI_RGT_0).
  destruct wedge_solves as (P0 & _ & [_ HL] & HI & HV).
  exists (fun s => Es * phi * sqrt gam * s), (fun _ => Es * phi * sqrt gam). split; [| split; [| split; [| split]]].
  - intros s Hs. split; [| auto_derive; [trivial | ring]].
    apply (the_load _ _ 0); [apply wedge_rises, T | exact Hs | nra | apply wedge_consistent; assumption | apply wedge_load; assumption].
  - intros x Hx. rewrite wedge_pressure_right by exact Hx. apply proportional_integral; assumption.
  - intros x Hx. rewrite <- (Ropp_involutive x), wedge_pressure_left by lra. assert (Hi := Rinv_0_lt_compat gam Hgam).
    assert (I := proportional_integral (Es * phi * sqrt gam / gam) (/ gam) (- x) (gam * a) Hi ltac:(lra)).
    rewrite (Ropp_involutive x). apply (improper_stretched _ (fun s => 1 / PI * (Es * phi * sqrt gam / sqrt ((s - x) * (x + gam * s)))) gam) in I; [| exact Hgam | lra |].
    + replace (gam * a / gam) with a in I by (field; lra). exact I.
    + intros s Hs. assert (H1 : - x < gam * s).
      { destruct Hs as [Hs _]. apply (Rmult_lt_compat_l gam) in Hs; [| exact Hgam]. replace (gam * (- x / gam)) with (- x) in Hs by (field; lra). lra. }
      assert (0 < s) by nra. assert (0 < sqrt ((s - x) * (x + gam * s))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
      replace ((gam * s - - x) * (- x + / gam * (gam * s))) with ((s - x) * (x + gam * s)) by (field; lra). field. repeat split; lra.
  - rewrite <- (load_unique Es g1 a (gam * a) _ _ HL (wedge_load Es phi gam Hgam a Ha)). exact HI.
  - exact HV.
Qed.
(* So does a traction in proportion to the pressure: what it adds to the strain at x does not change while the
   contact grows. *)
Theorem wedge_strain Q : exists P0,
  are_the_pressures Es g1 a (gam * a) p /\ is_the_load Es g1 a (gam * a) P0 /\ is_integral_about_0 p (gam * a) a P0 /\
  forall x, - (gam * a) < x < a -> x <> 0 ->
  is_principal_value_about_0 (fun s => Q / P0 * p s / (s - x)) (gam * a) a x (- Q / P0 * PI * Es / 2 * g1 x).
Proof.
  destruct wedge_solves as (P0 & Hp & HL & HI & HV). exists P0. split; [exact Hp | split; [exact HL | split; [exact HI |]]].
  intros x Hx Nx. replace (- Q / P0 * PI * Es / 2 * g1 x) with (Q / P0 * - (PI * Es / 2 * g1 x)) by (unfold Rdiv; ring).
  replace (fun s => Q / P0 * p s / (s - x)) with (fun s => Q / P0 * (p s / (s - x))) by (apply functional_extensionality; intros s; unfold Rdiv; ring).
  generalize (Q / P0). intros k. destruct (HV x Hx Nx) as [(H0 & v & v' & I & I' & E) | (H0 & v & v' & I & I' & E)]; [left | right]; (split; [exact H0 |]); exists (k * v), (k * v').
  - split; [exact (is_RInt_gen_scal (V := R_NormedModule) _ k v I) | split; [apply principal_value_scal, I' | rewrite <- E; ring]].
  - split; [apply principal_value_scal, I | split; [exact (is_RInt_gen_scal (V := R_NormedModule) _ k v' I') | rewrite <- E; ring]].
Qed.
End Wedge.

(* ---- Flat punches with rounded edges ---- *)

Definition rounded_pressure (Es t R0 a s : R) : R :=
  Es / (PI * R0) * (((s - t) * log_pressure a a t s - (s + t) * log_pressure a a (- t) s) / 2 + atan (sqrt (a ^ 2 - t ^ 2) / t) * sqrt (a ^ 2 - s ^ 2)).

(* By the edge. *)
Lemma log_pressure_of_edge c x s : Rabs c < s -> Rabs x < s ->
  is_derive (fun s => log_pressure s s c x) s ((s ^ 2 + c * x) / (s * sqrt (s ^ 2 - x ^ 2) * sqrt (s ^ 2 - c ^ 2))).
Proof.
  intros Hc Hx. apply Rabs_def2 in Hc. apply Rabs_def2 in Hx. unfold log_pressure, kernel_root.
  replace (s ^ 2 - x ^ 2) with ((s - x) * (x + s)) by ring. replace (s ^ 2 - c ^ 2) with ((c + s) * (s - c)) by ring.
  assert (R1 : 0 < sqrt (s - x)) by (apply sqrt_lt_R0; lra). assert (R2 : 0 < sqrt (c + s)) by (apply sqrt_lt_R0; lra).
  assert (R3 : 0 < sqrt (x + s)) by (apply sqrt_lt_R0; lra). assert (R4 : 0 < sqrt (s - c)) by (apply sqrt_lt_R0; lra).
  assert (E1 : sqrt (s - x) * sqrt (s - x) = s - x) by (apply sqrt_sqrt; lra). assert (E2 : sqrt (c + s) * sqrt (c + s) = c + s) by (apply sqrt_sqrt; lra).
  assert (E3 : sqrt (x + s) * sqrt (x + s) = x + s) by (apply sqrt_sqrt; lra). assert (E4 : sqrt (s - c) * sqrt (s - c) = s - c) by (apply sqrt_sqrt; lra).
  apply (is_derive_ext_loc (fun s => 2 * ln (sqrt (s - x) * sqrt (c + s) + sqrt (x + s) * sqrt (s - c)) - ln (Rabs (x - c)) - ln (s + s))).
  { set (d := Rmin (Rmin (s - x) (c + s)) (Rmin (x + s) (s - c))). assert (Hd : 0 < d) by (unfold d; repeat apply Rmin_pos; lra).
    apply (locally_near s d); [exact Hd |]. intros r Hr.
    generalize (Rmin_l (Rmin (s - x) (c + s)) (Rmin (x + s) (s - c))) (Rmin_r (Rmin (s - x) (c + s)) (Rmin (x + s) (s - c))) (Rmin_l (s - x) (c + s)) (Rmin_r (s - x) (c + s)) (Rmin_l (x + s) (s - c)) (Rmin_r (x + s) (s - c)).
    fold d. intros. rewrite !sqrt_mult by lra. reflexivity. }
  rewrite !sqrt_mult by lra. auto_derive; change (s + - x) with (s - x); change (s + - c) with (s - c).
  - repeat split; try lra. apply Rplus_lt_0_compat; apply Rmult_lt_0_compat; assumption.
  - assert (Es' : s = (sqrt (s - x) * sqrt (s - x) + sqrt (x + s) * sqrt (x + s)) / 2) by lra.
    assert (Ec : c = sqrt (c + s) * sqrt (c + s) - (sqrt (s - x) * sqrt (s - x) + sqrt (x + s) * sqrt (x + s)) / 2) by lra.
    assert (Ex : x = (sqrt (x + s) * sqrt (x + s) - sqrt (s - x) * sqrt (s - x)) / 2) by lra.
    assert (Q : sqrt (s - c) * sqrt (s - c) = sqrt (s - x) * sqrt (s - x) + sqrt (x + s) * sqrt (x + s) - sqrt (c + s) * sqrt (c + s)) by lra.
    assert (S0 : 0 < s) by lra. revert Es' Ec Ex Q. set (e1 := sqrt (s - x)) in *. set (e2 := sqrt (c + s)) in *. set (e3 := sqrt (x + s)) in *. set (e4 := sqrt (s - c)) in *.
    clearbody e1 e2 e3 e4. clear - R1 R2 R3 R4 S0. intros Es' Ec Ex Q. rewrite Ec, Ex. clear Ec Ex. rewrite Es'. clear Es'.
    assert (0 < e1 * e2) by (apply Rmult_lt_0_compat; assumption). assert (0 < e3 * e4) by (apply Rmult_lt_0_compat; assumption). assert (0 < e1 * e1 + e3 * e3) by nra.
    in_R. field_simplify_eq; [| repeat split; lra]. ring [Q].
Qed.

Section Rounded.
Variables Es t R0 a : R.
Hypothesis Ht : 0 < t < a.
Hypothesis HR : 0 < R0.
Let g1 := Symmetric.slope (rounded t R0).
Let p := rounded_pressure Es t R0 a.
Let t0 : 0 < t. Proof. lra. Qed.
Let arc s := atan (sqrt (s ^ 2 - t ^ 2) / t).
Section Place.
Variable x : R.
Hypothesis Hx : 0 < x < a.
Let F s := rounded_pressure Es t R0 s x.
Let f s := 1 / PI * (rounded_rate Es t R0 s / sqrt ((s - x) * (x + 1 * s))).
Let arc_derive s : t < s -> is_derive arc s (t / (s * sqrt (s ^ 2 - t ^ 2))).
Proof.
  intros Hs. assert (H : 0 < s ^ 2 - t ^ 2) by nra. assert (Q := sqrt_lt_R0 _ H). assert (QQ : sqrt (s ^ 2 - t ^ 2) * sqrt (s ^ 2 - t ^ 2) = s ^ 2 - t ^ 2) by (apply sqrt_sqrt; lra).
  unfold arc. auto_derive; change (s * (s * 1)) with (s ^ 2); change (t * (t * 1)) with (t ^ 2); change (s ^ 2 + - t ^ 2) with (s ^ 2 - t ^ 2).
  - repeat split; lra.
  - set (q := sqrt (s ^ 2 - t ^ 2)) in *. clearbody q. replace (1 + q * / t * (q * / t * 1)) with (s ^ 2 / t ^ 2) by (replace (s ^ 2) with (q * q + t ^ 2) by lra; field; lra).
    field. repeat split; lra.
Qed.
Let root_derive s : x < s -> is_derive (fun s => sqrt (s ^ 2 - x ^ 2)) s (s / sqrt (s ^ 2 - x ^ 2)).
Proof.
  intros Hs. assert (H : 0 < s ^ 2 - x ^ 2) by nra. assert (Q := sqrt_lt_R0 _ H).
  auto_derive; change (s * (s * 1)) with (s ^ 2); change (x * (x * 1)) with (x ^ 2); change (s ^ 2 + - x ^ 2) with (s ^ 2 - x ^ 2); [exact H | field; lra].
Qed.
Let F_derive s : t < s -> x < s -> is_derive F s (f s).
Proof.
  intros Hs Hs'. assert (Hpi := PI_RGT_0). assert (Qt := sqrt_lt_R0 (s ^ 2 - t ^ 2) ltac:(nra)). assert (Qx := sqrt_lt_R0 (s ^ 2 - x ^ 2) ltac:(nra)).
  assert (Exx : sqrt (s ^ 2 - x ^ 2) * sqrt (s ^ 2 - x ^ 2) = s ^ 2 - x ^ 2) by (apply sqrt_sqrt; nra).
  assert (D1 := log_pressure_of_edge t x s ltac:(apply Rabs_def1; lra) ltac:(apply Rabs_def1; lra)).
  assert (D2 := log_pressure_of_edge (- t) x s ltac:(apply Rabs_def1; lra) ltac:(apply Rabs_def1; lra)).
  replace ((- t) ^ 2) with (t ^ 2) in D2 by ring.
  assert (D3 : is_derive (fun s => arc s * sqrt (s ^ 2 - x ^ 2)) s (t / (s * sqrt (s ^ 2 - t ^ 2)) * sqrt (s ^ 2 - x ^ 2) + arc s * (s / sqrt (s ^ 2 - x ^ 2)))).
  { apply (is_derive_mult arc (fun s => sqrt (s ^ 2 - x ^ 2))); [apply arc_derive, Hs | apply root_derive, Hs' | intros; apply Rmult_comm]. }
  assert (D4 := is_derive_scal _ s (Es / (PI * R0)) _ (is_derive_plus (V := R_NormedModule) _ _ _ _ _ (is_derive_minus (V := R_NormedModule) _ _ _ _ _
    (is_derive_scal _ s ((x - t) / 2) _ D1) (is_derive_scal _ s ((x + t) / 2) _ D2)) D3)).
  refine (is_derive_ext _ F s _ _ (eq_ind _ (fun v => is_derive _ s v) D4 (f s) _)).
  - intros r. unfold F, rounded_pressure, arc, minus, plus, opp; simpl. in_R. field. repeat split; lra.
  - unfold minus, plus, opp, scal; simpl; unfold mult; simpl. unfold f, rounded_rate. fold (arc s).
    change (s * (s * 1)) with (s ^ 2). change (x * (x * 1)) with (x ^ 2). change (t * (t * 1)) with (t ^ 2).
    replace ((s - x) * (x + 1 * s)) with (s ^ 2 - x ^ 2) by ring. generalize (arc s). intros A.
    set (r := sqrt (s ^ 2 - x ^ 2)) in *. set (w := sqrt (s ^ 2 - t ^ 2)) in *. clearbody r w. in_R. field_simplify_eq; [| repeat split; lra]. ring [Exx].
Qed.
Let f_continuous s : x < s -> continuous f s.
Proof.
  intros Hs. apply continuous_times; [apply continuous_const |]. apply continuous_quotient.
  - apply rounded_rate_continuous, t0.
  - apply (continuous_comp (fun s => (s - x) * (x + 1 * s)) sqrt); [| apply continuous_sqrt]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - apply Rgt_not_eq, sqrt_lt_R0, Rmult_lt_0_compat; lra.
Qed.
Let arc_root_continuous s : continuous (fun s => arc s * sqrt (s ^ 2 - x ^ 2)) s.
Proof.
  assert (R : forall c, continuous (fun s => sqrt (s ^ 2 - c ^ 2)) s).
  { intros c. apply (continuous_comp (fun s => s ^ 2 - c ^ 2) sqrt); [| apply continuous_sqrt]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
  apply continuous_times; [| apply R]. apply (continuous_comp (fun s => sqrt (s ^ 2 - t ^ 2) / t) atan).
  - apply continuous_quotient; [apply R | apply continuous_const | lra].
  - apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Let log_continuous_of_edge c s : 0 < s -> 0 < kernel_root s s c x -> continuous (fun s => log_pressure s s c x) s.
Proof.
  intros Hs HK. apply continuous_sub; [apply continuous_sub; [| apply continuous_const] |].
  - apply continuous_times; [apply continuous_const |]. apply (continuous_comp (fun s => kernel_root s s c x) ln).
    + unfold kernel_root. apply continuous_add.
      * apply (continuous_comp (fun s => (s - x) * (c + s)) sqrt); [| apply continuous_sqrt]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
      * apply (continuous_comp (fun s => (x + s) * (s - c)) sqrt); [| apply continuous_sqrt]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. exact HK.
  - apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. lra.
Qed.
(* The edge at which the integral begins. *)
Let m := Rmax x t.
Let begin c : c = t \/ c = - t -> (c <> x) -> 0 < kernel_root m m c x /\ log_pressure m m c x = 0.
Proof.
  intros Hc N. assert (M : 0 < m /\ ((m = x /\ t <= x) \/ (m = t /\ x <= t))) by (unfold m, Rmax; destruct (Rle_dec x t); lra).
  assert (K : exists k, 0 < k /\ kernel_root m m c x = sqrt k /\ k = Rabs (x - c) * (m + m)).
  { unfold kernel_root. destruct M as [M0 [[-> L] | [-> L]]].
    - exists ((x + x) * (x - c)). assert (0 < x - c) by (destruct Hc as [-> | ->]; lra). split; [apply Rmult_lt_0_compat; lra | split].
      + rewrite (Rminus_diag_eq x x), Rmult_0_l, sqrt_0 by reflexivity. ring.
      + rewrite Rabs_pos_eq by lra. ring.
    - destruct Hc as [-> | ->].
      + exists ((t - x) * (t + t)). split; [apply Rmult_lt_0_compat; lra | split].
        * rewrite (Rminus_diag_eq t t), Rmult_0_r, sqrt_0 by reflexivity. ring.
        * rewrite Rabs_left by lra. ring.
      + exists ((x + t) * (t - - t)). split; [apply Rmult_lt_0_compat; lra | split].
        * rewrite Rplus_opp_l, Rmult_0_r, sqrt_0. ring.
        * rewrite Rabs_pos_eq by lra. ring. }
  destruct K as (k & K0 & K1 & K2). split; [rewrite K1; apply sqrt_lt_R0, K0 |]. unfold log_pressure. rewrite K1.
  replace (2 * ln (sqrt k)) with (ln k) by (rewrite <- (sqrt_sqrt k) at 1 by lra; rewrite ln_mult by (apply sqrt_lt_R0, K0); ring).
  rewrite K2, ln_mult by (try apply Rabs_pos_lt; lra). ring.
Qed.
Let F_begin : continuous F m /\ F m = 0.
Proof.
  assert (Hpi := PI_RGT_0). assert (M0 : 0 < m) by (unfold m; generalize (Rmax_l x t); lra).
  destruct (begin (- t) ltac:(right; reflexivity) ltac:(lra)) as [K1 L1].
  assert (Z : arc m * sqrt (m ^ 2 - x ^ 2) = 0).
  { unfold m, Rmax. destruct (Rle_dec x t); [unfold arc; rewrite (Rminus_diag_eq (t ^ 2)), sqrt_0 by reflexivity; unfold Rdiv; rewrite Rmult_0_l, atan_0; ring |].
    rewrite (Rminus_diag_eq (x ^ 2)), sqrt_0 by reflexivity. ring. }
  assert (P : continuous (fun s => (x - t) * log_pressure s s t x) m /\ (x - t) * log_pressure m m t x = 0).
  { destruct (Req_dec t x) as [E | N].
    - split; [| rewrite E; ring]. apply (continuous_ext (fun _ => 0)); [intros s; rewrite E; in_R; ring | apply continuous_const].
    - destruct (begin t ltac:(left; reflexivity) N) as [K2 L2]. split; [| rewrite L2; ring].
      apply continuous_times; [apply continuous_const | apply log_continuous_of_edge; assumption]. }
  destruct P as [P1 P2]. split.
  - apply (continuous_ext (fun s => Es / (PI * R0) * (((x - t) * log_pressure s s t x - (x + t) * log_pressure s s (- t) x) / 2 + arc s * sqrt (s ^ 2 - x ^ 2)))); [reflexivity |].
    apply continuous_times; [apply continuous_const |]. apply continuous_add; [| apply arc_root_continuous].
    apply continuous_quotient; [| apply continuous_const | lra]. apply continuous_sub; [exact P1 |].
    apply continuous_times; [apply continuous_const | apply log_continuous_of_edge; assumption].
  - unfold F, rounded_pressure. fold (arc m). rewrite Z, L1, P2. field. repeat split; lra.
Qed.
Lemma rounded_pressure_is_improper : is_improper_integral f x a (p x).
Proof.
  destruct F_begin as [C0 Z0]. change (p x) with (F a). destruct (Rlt_le_dec x t) as [L | L].
  - assert (M : m = t) by (unfold m; rewrite Rmax_right; lra). rewrite M in C0, Z0.
    assert (I : is_RInt f t a (F a)).
    { replace (F a) with (F a - F t) by (rewrite Z0; ring). apply by_inner_derivative; [lra | intros s Hs; apply F_derive; lra | | intros s Hs; apply f_continuous; lra].
      intros s Hs. destruct (Req_dec s t) as [-> | N]; [exact C0 |]. apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply F_derive; lra. }
    split.
    + intros e He. apply (@ex_RInt_continuous R_CompleteNormedModule). intros s Hs. rewrite Rmin_left in Hs by lra. apply f_continuous. lra.
    + apply (filterlim_ext_loc (fun _ => F a)); [| apply filterlim_const].
      exists (mkposreal (t - x) ltac:(lra)). intros e He Hxe. unfold ball in He; simpl in He. unfold AbsRing_ball, abs, minus, plus, opp in He; simpl in He. apply Rabs_def2 in He.
      symmetry. apply is_RInt_unique. replace (F a) with (plus 0 (F a)) by (unfold plus; simpl; ring).
      apply (is_RInt_Chasles (V := R_NormedModule) f e t a); [| exact I].
      assert (Zero := is_RInt_const (V := R_NormedModule) e t 0). unfold scal in Zero; simpl in Zero; unfold mult in Zero; simpl in Zero. rewrite Rmult_0_r in Zero.
      refine (is_RInt_ext _ _ _ _ _ _ Zero). intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra.
      unfold f. destruct (rounded_load_within Es t R0 s ltac:(lra)) as [_ ->]. unfold Rdiv. in_R. ring.
  - assert (M : m = x) by (unfold m; rewrite Rmax_left; lra). rewrite M in C0, Z0.
    apply (improper_by_antiderivative f F); [lra | intros s Hs; split; [apply F_derive; lra | apply f_continuous; lra] |].
    rewrite <- Z0. intros P HP. apply filter_le_within. exact (C0 P HP).
Qed.
End Place.
Let Even : mirrored g1 = g1.
Proof. apply slope_odd. repeat constructor; simpl; lra. Qed.
Let p_even s : p (- s) = p s.
Proof.
  unfold p, rounded_pressure, log_pressure, kernel_root. replace ((- s) ^ 2) with (s ^ 2) by ring.
  replace ((a - - s) * (t + a)) with ((s + a) * (a - - t)) by ring. replace ((- s + a) * (a - t)) with ((a - s) * (- t + a)) by ring.
  replace ((a - - s) * (- t + a)) with ((s + a) * (a - t)) by ring. replace ((- s + a) * (a - - t)) with ((a - s) * (t + a)) by ring.
  replace (- s - t) with (- (s - - t)) by ring. replace (- s - - t) with (- (s - t)) by ring. rewrite !Rabs_Ropp.
  rewrite (Rplus_comm (sqrt ((s + a) * (a - - t)))), (Rplus_comm (sqrt ((s + a) * (a - t)))). field. generalize PI_RGT_0. lra.
Qed.
Let is_p x : 0 < x < a -> is_the_pressure Es g1 a x (p x).
Proof.
  intros Hx. apply rounded_the_pressure; try lra. exists (rounded_load Es t R0), (rounded_rate Es t R0), (fun s => 1 * s). split.
  - intros s Hs. apply rounded_contact_at; lra.
  - apply rounded_pressure_is_improper, Hx.
Qed.
Lemma rounded_pressures : are_the_pressures Es g1 a a p.
Proof. split; [exact is_p |]. rewrite Even. intros y Hy. rewrite p_even. apply is_p, Hy. Qed.
Let value x : - a < x < a ->
  Es / (PI * R0) / 2 * (PI * sqrt ((a - t) * (t + a)) + (x - t) * corner_value a a t x) +
  - (Es / (PI * R0) / 2) * (PI * sqrt ((a - - t) * (- t + a)) + (x - - t) * corner_value a a (- t) x) +
  Es / (PI * R0) * arc a * - (PI * x) = - (PI * Es / 2 * g1 x).
Proof.
  intros Hx. assert (Hpi := PI_RGT_0). replace ((a - - t) * (- t + a)) with ((a - t) * (t + a)) by ring.
  unfold corner_value. replace ((2 * t + a - a) / (a + a)) with (t / a) by (field; lra). replace ((2 * - t + a - a) / (a + a)) with (- (t / a)) by (field; lra).
  rewrite asin_opp, asin_sqrt by lra. assert (Q := sqrt_lt_R0 (a ^ 2 - t ^ 2) ltac:(nra)).
  assert (A : arc a = PI / 2 - atan (t / sqrt (a ^ 2 - t ^ 2))).
  { unfold arc. rewrite <- atan_inv by (apply Rdiv_lt_0_compat; lra). f_equal. field. lra. }
  rewrite A. generalize (atan (t / sqrt (a ^ 2 - t ^ 2))). intros al.
  unfold g1, Symmetric.slope, total, rounded, part_slope, from, corner, curvature, fold_right.
  destruct (Rlt_dec t x), (Rlt_dec (- t) x), (Rlt_dec x (- t)); try lra; try (field; lra).
  replace x with (- t) by lra. field. lra.
Qed.
Theorem rounded_solves : exists P0,
  are_the_pressures Es g1 a a p /\ is_the_load Es g1 a a P0 /\ is_integral_about_0 p a a P0 /\
  forall x, - a < x < a -> is_principal_value (fun s => p s / (s - x)) (- a) a x (- (PI * Es / 2 * g1 x)).
Proof.
  assert (Hpi := PI_RGT_0). destruct (rounded_load_of_pressure Es t R0 t0 HR a ltac:(lra)) as (p' & P0 & Hp & HL & HI).
  exists P0. split; [exact rounded_pressures | split; [exact HL | split; [exact (same_integral Es g1 a a p' p P0 ltac:(lra) ltac:(lra) Hp rounded_pressures HI) |]]].
  intros x Hx. rewrite <- value by exact Hx.
  assert (S := principal_value_sum _ _ _ _ _ _ _ (principal_value_sum _ _ _ _ _ _ _
    (principal_value_scal _ (Es / (PI * R0) / 2) _ _ _ _ (curvature_everywhere a a t ltac:(lra) x Hx))
    (principal_value_scal _ (- (Es / (PI * R0) / 2)) _ _ _ _ (curvature_everywhere a a (- t) ltac:(lra) x Hx)))
    (principal_value_scal _ (Es / (PI * R0) * arc a) _ _ _ _ (semicircle_principal_value a x Hx))).
  refine (principal_value_ext _ _ _ _ _ _ Hx _ S). intros s Hs Ns. unfold p, rounded_pressure. fold (arc a). field. repeat split; lra.
Qed.
End Rounded.
