(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Symmetric TiltedWedge Shear Unique Stick Sides Orders Gamma PowerLaw Limits Inversion LoadOfPressure Forward.
Open Scope R_scope.

(* Claims that hold in one reading and not in another. *)

Lemma first_coefficients Q sig0 D : 0 < D -> shear_0 Q sig0 D * shear_0 Q (- sig0) D = ((Q / PI) ^ 2 - (sig0 * D / 8) ^ 2) / D.
Proof.
  intros H. assert (Hpi := PI_RGT_0). assert (R := sqrt_lt_R0 D H). assert (E : sqrt D * sqrt D = D) by (apply sqrt_sqrt; lra).
  transitivity (((Q / PI) ^ 2 - (sig0 * D / 8) ^ 2) / (sqrt D * sqrt D)); [unfold shear_0; field; lra | rewrite E; reflexivity].
Qed.
Theorem same_sign :
  (forall a b Q sig0, 0 < a + b /\ Q <> 0 -> exists s0 s1 s2 v0 v1 v2,
    is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\ is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
    (Rabs (sig0 * (b + a) / Q) < 8 / PI -> 0 < s0 * v0) /\ (sig0 * (b + a) / Q < 8 / PI /\ 0 < sig0 * Q -> 0 < s0 * v0)) /\
  (exists a b Q sig0 s0 s1 s2 v0 v1 v2, 0 < a + b /\ Q <> 0 /\
    is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\ is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
    sig0 * (b + a) / Q < 8 / PI /\ s0 * v0 < 0).
Proof.
  assert (Hpi := PI_RGT_0). split.
  - intros a b Q sig0 [HD HQ]. exists (shear_0 Q sig0 (a + b)), (shear_1 Q sig0 (a + b)), (shear_2 Q sig0 (a + b)), (shear_0 Q (- sig0) (a + b)), (shear_1 Q (- sig0) (a + b)), (shear_2 Q (- sig0) (a + b)).
    split; [apply the_right_shear_series, right_shear, HD | split; [apply the_left_shear_series, left_shear, HD |]].
    assert (Main : Rabs (sig0 * (b + a) / Q) < 8 / PI -> 0 < shear_0 Q sig0 (a + b) * shear_0 Q (- sig0) (a + b)).
    { intros H. rewrite first_coefficients by exact HD. apply Rdiv_lt_0_compat; [| exact HD].
      set (q := sig0 * (b + a) / Q) in *. assert (E : sig0 * (a + b) / 8 = Q * (q / 8)) by (unfold q; field; exact HQ). rewrite E.
      replace ((Q / PI) ^ 2 - (Q * (q / 8)) ^ 2) with (Q ^ 2 / 64 * ((8 / PI) ^ 2 - q ^ 2)) by (field; lra).
      apply Rabs_def2 in H. apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat; [nra | lra] | nra]. }
    split; [exact Main |]. intros [H HS]. apply Main. rewrite Rabs_pos_eq; [exact H |].
    replace (sig0 * (b + a) / Q) with (sig0 * Q * (b + a) / Q ^ 2) by (field; exact HQ). apply Rlt_le, Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | nra].
  - exists 1, 0, 1, (-8), (shear_0 1 (-8) (1 + 0)), (shear_1 1 (-8) (1 + 0)), (shear_2 1 (-8) (1 + 0)), (shear_0 1 (- -8) (1 + 0)), (shear_1 1 (- -8) (1 + 0)), (shear_2 1 (- -8) (1 + 0)).
    split; [lra | split; [lra |]]. split; [apply the_right_shear_series, right_shear; lra | split; [apply the_left_shear_series, left_shear; lra | split]].
    + assert (0 < 8 / PI) by (apply Rdiv_lt_0_compat; lra). lra.
    + rewrite first_coefficients by lra. assert (I : / PI < 1) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; generalize PI2_1; lra).
      assert (0 < / PI) by (apply Rinv_0_lt_compat; lra). unfold Rdiv. rewrite Rmult_1_l. nra.
Qed.

Theorem vanishes_at_the_right a b Q sig0 : 0 < a + b /\ Q <> 0 /\ sig0 * ((a + b) / 2) / Q = 4 / (3 * PI) ->
  exists s0 s1 s2 v0 v1 v2,
  is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\ is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
  s1 = 0 /\ v1 <> 0.
Proof.
  intros (HD & HQ & H). assert (Hpi := PI_RGT_0). assert (R := sqrt_lt_R0 _ HD).
  assert (E : sig0 * (a + b) = 8 / (3 * PI) * Q) by (replace (sig0 * (a + b)) with (2 * Q * (sig0 * ((a + b) / 2) / Q)) by (field; exact HQ); rewrite H; field; lra).
  exists (shear_0 Q sig0 (a + b)), (shear_1 Q sig0 (a + b)), (shear_2 Q sig0 (a + b)), (shear_0 Q (- sig0) (a + b)), (shear_1 Q (- sig0) (a + b)), (shear_2 Q (- sig0) (a + b)).
  split; [apply the_right_shear_series, right_shear, HD | split; [apply the_left_shear_series, left_shear, HD | split]].
  - unfold shear_1. assert (S : sig0 = 8 / (3 * PI) * Q / (a + b)) by (rewrite <- E; field; lra). rewrite S. field. repeat split; lra.
  - intros Z. apply shear_1_zero in Z; [| exact HD]. replace (3 * PI * (a + b) / 8 * - sig0) with (- (3 * PI / 8 * (sig0 * (a + b)))) in Z by field.
    rewrite E in Z. replace (3 * PI / 8 * (8 / (3 * PI) * Q)) with Q in Z by (field; lra). lra.
Qed.

(* The slopes of the surfaces of one or two bodies of the modulus Ey and Poisson's ratio nu, under the pressure of a parabola. *)
Theorem one_body_or_two Ey nu C a x : 0 < Ey /\ -1 < nu < 1 /\ 0 < C -> 0 < x < a -> exists p0 l0,
  is_the_pressure (Ey / (1 - nu ^ 2)) (Symmetric.slope (parabola C)) a x p0 /\
  is_principal_value (fun s => sqrt (a ^ 2 - s ^ 2) / (x - s)) (- a) a x l0 /\
  2 * (1 - nu ^ 2) / (PI * Ey) * p0 / sqrt (a ^ 2 - x ^ 2) * l0 = Symmetric.slope (parabola C) x /\
  2 * 2 * (1 - nu ^ 2) / (PI * Ey) * p0 / sqrt (a ^ 2 - x ^ 2) * l0 <> Symmetric.slope (parabola C) x.
Proof.
  intros (HE & Hnu & HC) Hx. assert (Hpi := PI_RGT_0). assert (N : 0 < 1 - nu ^ 2) by nra. assert (R := sqrt_lt_R0 (a ^ 2 - x ^ 2) ltac:(nra)).
  destruct (hertz_solves (Ey / (1 - nu ^ 2)) C a HC ltac:(lra)) as (P0 & [Hp _] & _).
  assert (L : Symmetric.slope (parabola C) x = C * x).
  { unfold Symmetric.slope, total, parabola, part_slope, from, corner, curvature, fold_right. destruct (Rlt_dec 0 x); [ring | lra]. }
  exists (Ey / (1 - nu ^ 2) * C / 2 * sqrt (a ^ 2 - x ^ 2)), (-1 * - (PI * x)). split; [exact (Hp x Hx) | split; [| split]].
  - apply (principal_value_ext (fun s => -1 * (sqrt (a ^ 2 - s ^ 2) / (s - x)))); [lra | | apply principal_value_scal, semicircle_principal_value; lra].
    intros s _ Ns. field. lra.
  - rewrite L. field. repeat split; lra.
  - rewrite L. replace (2 * 2 * (1 - nu ^ 2) / (PI * Ey) * (Ey / (1 - nu ^ 2) * C / 2 * sqrt (a ^ 2 - x ^ 2)) / sqrt (a ^ 2 - x ^ 2) * (-1 * - (PI * x))) with (2 * (C * x)) by (field; repeat split; lra).
    assert (0 < C * x) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(* The relative error of one term is r1 / r0 times the distance from the edge, to the first order. *)
Definition has_error_of_order (Es : R) (g1 : R -> R) (a r0 factor : R) : Prop :=
  exists (p : R -> R) (d : R), 0 < d /\ (forall u, 0 < u < d -> is_the_pressure Es g1 a (a - u) (p u)) /\
    filterlim (fun u => Rabs (1 - r0 * sqrt u / p u) / u) (at_right 0) (locally factor).
Lemma error_of_orders Es g1 a r0 r1 r2 : r0 <> 0 -> has_orders Es g1 a r0 r1 r2 -> has_error_of_order Es g1 a r0 (Rabs (r1 / r0)).
Proof.
  intros N (p & d & Hd & Hp & L0 & L1 & _). exists p, d. split; [exact Hd | split; [exact Hp |]].
  assert (I : filterlim (fun u => / (p u / sqrt u)) (at_right 0) (locally (/ r0))).
  { refine (filterlim_comp _ _ _ (fun u => p u / sqrt u) Rinv _ _ _ L0 _). apply continuous_Rinv, N. }
  assert (S := limit_product _ _ _ _ L1 I). assert (A := filterlim_comp _ _ _ _ Rabs _ _ _ S (continuous_Rabs _)).
  refine (filterlim_ext_loc _ _ _ A).
  assert (Away : at_right 0 (fun u => p u / sqrt u <> 0)).
  { apply (L0 (fun y => y <> 0)). exists (mkposreal (Rabs r0) (Rabs_pos_lt r0 N)). intros y Hy ->. unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
    rewrite Rplus_0_l, Rabs_Ropp in Hy. lra. }
  assert (Pos : at_right 0 (fun u => 0 < u)) by (apply (near_right_0 1); [lra | intros u Hu; lra]).
  refine (filter_imp _ _ _ (filter_and _ _ Away Pos)). intros u [Nu Hu]. assert (Q := sqrt_lt_R0 u Hu).
  assert (P : p u <> 0) by (intros Z; apply Nu; rewrite Z; unfold Rdiv; ring).
  unfold Rdiv at 3. rewrite <- (Rabs_pos_eq (/ u)) by (apply Rlt_le, Rinv_0_lt_compat, Hu). rewrite <- Rabs_mult. f_equal. field. repeat split; (assumption || lra).
Qed.
Lemma order_of_the_error Es g1 a (P P1 P2 P3 b b1 b2 : R -> R) y : is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  rises_at g1 y -> y < a -> 0 < a + b a -> 0 < P1 a -> exists r0 r1 r2,
  is_the_right_series Es g1 a r0 r1 r2 /\ r0 <> 0 /\ has_error_of_order Es g1 a r0 (Rabs (r1 / r0)).
Proof.
  intros contact Rise Hy Hw HP. assert (S := right_edge _ _ _ _ _ _ _ _ _ _ contact). assert (Hpi := PI_RGT_0).
  assert (N : c0 P1 b a <> 0).
  { unfold c0. apply Rgt_not_eq, Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; [exact Hpi | apply sqrt_lt_R0, Hw]]. }
  do 3 eexists. split; [exact (the_right_series _ _ y _ _ _ _ Rise Hy S) | split; [exact N |]].
  exact (error_of_orders _ _ _ _ _ _ N (orders_of_series _ _ y _ _ _ _ Rise Hy S)).
Qed.
(* The factor of r1 is not the same for all contacts. *)
Theorem factor_of_the_error K : exists Es phi a r0 r1 r2 factor,
  is_the_right_series Es (TiltedWedge.slope phi (tilt phi 1)) a r0 r1 r2 /\ r0 <> 0 /\ r1 <> 0 /\
  has_error_of_order Es (TiltedWedge.slope phi (tilt phi 1)) a r0 (factor * Rabs r1) /\ factor <> K.
Proof.
  assert (Hpi := PI_RGT_0).
  assert (Main : forall Es, 0 < Es -> exists r0 r1 r2, is_the_right_series Es (TiltedWedge.slope 1 (tilt 1 1)) 1 r0 r1 r2 /\ r0 = Es * (2 / (PI * sqrt 2)) /\ r1 <> 0 /\
    has_error_of_order Es (TiltedWedge.slope 1 (tilt 1 1)) 1 r0 (/ r0 * Rabs r1)).
  { intros Es HE. destruct (remainder_at_right Es 1 1 1 ltac:(lra)) as (r0 & r1 & r2 & HS & HO & _).
    assert (S := right_edge _ _ _ _ _ _ _ _ _ _ (TiltedWedge.smooth_contact Es 1 1 1 ltac:(lra) ltac:(lra))).
    destruct HS as [HS U]. destruct (U _ _ _ S) as (E0 & E1 & _). exists r0, r1, r2. split; [exact (conj HS U) |].
    assert (R := sqrt_lt_R0 2 ltac:(lra)).
    assert (V0 : r0 = Es * (2 / (PI * sqrt 2))) by (rewrite <- E0; unfold c0; rewrite sqrt_1; replace (1 + 1 * 1) with 2 by ring; field; lra).
    assert (V1 : 0 < r1).
    { rewrite <- E1. unfold c1. rewrite sqrt_1. replace (1 + 1 * 1) with 2 by ring. 
      match goal with |- 0 < ?e => replace e with (Es * (5 / (6 * (PI * sqrt 2)))) by (field; lra) end.
      apply Rmult_lt_0_compat; [exact HE |]. apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; assumption]]. }
    assert (P0 : 0 < r0) by (rewrite V0; apply Rmult_lt_0_compat; [exact HE | apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; assumption]]).
    split; [exact V0 | split; [lra |]]. replace (/ r0 * Rabs r1) with (Rabs (r1 / r0)); [apply (error_of_orders _ _ _ _ r1 r2); [lra | exact HO] |].
    unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ r0)) by (apply Rlt_le, Rinv_0_lt_compat, P0). ring. }
  set (k := 2 / (PI * sqrt 2)) in *. assert (K0 : 0 < k) by (apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; [lra | apply sqrt_lt_R0; lra]]).
  destruct (Req_dec (/ k) K) as [E | N].
  - destruct (Main 2 ltac:(lra)) as (r0 & r1 & r2 & HS & E0 & N1 & HO). exists 2, 1, 1, r0, r1, r2, (/ r0).
    split; [exact HS | split; [lra | split; [exact N1 | split; [exact HO |]]]]. rewrite E0, <- E. rewrite Rinv_mult. assert (0 < / k) by (apply Rinv_0_lt_compat, K0). lra.
  - destruct (Main 1 ltac:(lra)) as (r0 & r1 & r2 & HS & E0 & N1 & HO). exists 1, 1, 1, r0, r1, r2, (/ r0).
    split; [exact HS | split; [lra | split; [exact N1 | split; [exact HO |]]]]. rewrite E0, Rmult_1_l. exact N.
Qed.

Theorem order_in_the_distance Es C m t R0 a K : 0 < Es /\ 0 < C /\ 0 <= m /\ 0 < t < a /\ 0 < R0 ->
  (exists r0 r1 r2, is_the_right_series Es (power_slope C m) a r0 r1 r2 /\ r0 <> 0 /\
    has_error_of_order Es (power_slope C m) a r0 (Rabs (r1 / r0))) /\
  (exists r0 r1 r2, is_the_right_series Es (Symmetric.slope (rounded t R0)) a r0 r1 r2 /\ r0 <> 0 /\
    has_error_of_order Es (Symmetric.slope (rounded t R0)) a r0 (Rabs (r1 / r0))) /\
  (exists Fs phi c r0 r1 r2 factor, is_the_right_series Fs (TiltedWedge.slope phi (tilt phi 1)) c r0 r1 r2 /\ r0 <> 0 /\ r1 <> 0 /\
    has_error_of_order Fs (TiltedWedge.slope phi (tilt phi 1)) c r0 (factor * Rabs r1) /\ factor <> K).
Proof.
  intros (HE & HC & Hm & Ht & HR). assert (IR : 0 < 1 / R0) by (apply Rdiv_lt_0_compat; lra). split; [| split; [| exact (factor_of_the_error K)]].
  - apply (order_of_the_error _ _ _ _ _ _ _ _ _ _ 0 (power_smooth_contact Es C m Hm a ltac:(lra))); [apply power_slope_rises; assumption | lra | lra |].
    unfold power_load_1. repeat apply Rmult_lt_0_compat; first [exact HE | exact HC | apply wallis_positive; lra | apply exp_pos | lra].
  - apply (order_of_the_error _ _ _ _ _ _ _ _ _ _ t (Symmetric.smooth_contact Es (rounded t R0) ((t + a) / 2) a ltac:(repeat constructor; simpl; lra) ltac:(lra))); [| lra | lra |].
    + apply (punch_rises (rounded t R0)). split; [repeat constructor; simpl; lra | simpl; lra].
    + unfold rate, total, rounded, part_rate, from, corner, curvature, fold_right, angle. assert (0 < a ^ 2 - t ^ 2) by nra.
      assert (Q := sqrt_lt_R0 (a ^ 2 - t ^ 2) ltac:(assumption)). assert (B := atan_bound (t / sqrt (a ^ 2 - t ^ 2))).
      assert (P : 0 < Es * (1 / R0 * a * (PI / 2 - atan (t / sqrt (a ^ 2 - t ^ 2))))) by (repeat apply Rmult_lt_0_compat; lra).
      match goal with |- 0 < ?e => replace e with (Es * (1 / R0 * a * (PI / 2 - atan (t / sqrt (a ^ 2 - t ^ 2))))); [exact P |] end. field. lra.
Qed.
