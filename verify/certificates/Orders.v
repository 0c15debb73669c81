(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm TiltedWedge Unique Tactics Expansions HalfPowers PressureExpansions Sides.
Open Scope R_scope.

(* The pressure at the distance u from the edge a, divided by u^(1/2), tends to r0; what one term
   leaves, divided by u^(3/2), tends to r1; what two terms leave, divided by u^(5/2), tends to r2. *)
Definition has_orders (Es : R) (g1 : R -> R) (a r0 r1 r2 : R) : Prop :=
  exists (p : R -> R) (d : R), 0 < d /\ (forall u, 0 < u < d -> is_the_pressure Es g1 a (a - u) (p u)) /\
    filterlim (fun u => p u / sqrt u) (at_right 0) (locally r0) /\
    filterlim (fun u => (p u - r0 * sqrt u) / (u * sqrt u)) (at_right 0) (locally r1) /\
    filterlim (fun u => (p u - (r0 * sqrt u + r1 * (u * sqrt u))) / (u ^ 2 * sqrt u)) (at_right 0) (locally r2).
(* What three terms leave is at most C u^(7/2). *)
Definition has_remainder (Es : R) (g1 : R -> R) (a r0 r1 r2 : R) : Prop :=
  exists C d, 0 < d /\ forall u, 0 < u < d -> exists p0, is_the_pressure Es g1 a (a - u) p0 /\
    Rabs (p0 - (r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u))) <= C * (u ^ 3 * sqrt u).

Lemma near_right_0 (d : R) (A : R -> Prop) : 0 < d -> (forall u, 0 < u < d -> A u) -> at_right 0 A.
Proof.
  intros Hd H. exists (mkposreal d Hd). intros u Hb Hu.
  unfold ball in Hb; simpl in Hb. unfold AbsRing_ball, abs, minus, plus, opp in Hb; simpl in Hb.
  apply Rabs_def2 in Hb. apply H. lra.
Qed.
Lemma limit_of_quotient n f T : agrees_through n f T -> filterlim (fun u => (f u - T u) / u ^ n) (at_right 0) (locally 0).
Proof.
  intros H A [e He]. destruct (H (e / 2) ltac:(generalize (cond_pos e); lra)) as (d & Hd & B).
  apply (near_right_0 d _ Hd). intros u Hu. apply He.
  unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl. rewrite Ropp_0, Rplus_0_r.
  assert (Hn : 0 < u ^ n) by (apply pow_lt; lra). assert (I := Rinv_0_lt_compat _ Hn).
  unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ u ^ n)) by lra.
  apply Rle_lt_trans with (e / 2 * u ^ n * / u ^ n); [apply Rmult_le_compat_r; [lra | apply B, Hu] |].
  rewrite Rmult_assoc, Rinv_r by lra. generalize (cond_pos e). lra.
Qed.
Lemma limit_sum (f g : R -> R) m n : filterlim f (at_right 0) (locally m) -> filterlim g (at_right 0) (locally n) ->
  filterlim (fun u => f u + g u) (at_right 0) (locally (m + n)).
Proof. intros H1 H2. refine (filterlim_comp_2 f g Rplus H1 H2 _). apply (filterlim_plus (V := R_NormedModule) m n). Qed.
Lemma limit_product (f g : R -> R) m n : filterlim f (at_right 0) (locally m) -> filterlim g (at_right 0) (locally n) ->
  filterlim (fun u => f u * g u) (at_right 0) (locally (m * n)).
Proof. intros H1 H2. refine (filterlim_comp_2 f g Rmult H1 H2 _). apply (filterlim_mult (K := R_AbsRing) m n). Qed.
Lemma limit_continuous (f : R -> R) : continuous f 0 -> filterlim f (at_right 0) (locally (f 0)).
Proof. intros H A HA. apply filter_le_within. exact (H A HA). Qed.

Theorem orders_of_series Es g1 y a r0 r1 r2 : rises_at g1 y -> y < a ->
  right_edge_series Es g1 a r0 r1 r2 -> has_orders Es g1 a r0 r1 r2.
Proof.
  intros Hg Hy H. destruct (pressures_of_series _ _ _ _ _ _ H) as (p & K & Hp & EK & T).
  destruct (the_pressures_right _ _ _ _ _ Hg Hy Hp) as (d & Hd & HP).
  exists (fun u => p (a - u)), d. split; [exact Hd |]. split; [intros u Hu; apply HP; lra |].
  assert (L := limit_of_quotient _ _ _ T).
  assert (E : forall u, p (a - u) = sqrt u * K u) by (intros u; rewrite EK; replace (a - (a - u)) with u by ring; reflexivity).
  assert (Cont : forall x, continuous (fun u : R => x * u) 0) by (intros x; apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; trivial).
  assert (L2 : filterlim (fun u => (K u - (r0 + r1 * u + r2 * u ^ 2)) / u ^ 2 + r2) (at_right 0) (locally r2)).
  { replace (locally r2) with (locally (0 + r2)) by (f_equal; ring). apply limit_sum; [exact L | apply filterlim_const]. }
  assert (Lu : filterlim (fun u : R => u) (at_right 0) (locally 0)) by (apply (limit_continuous (fun u => u)), continuous_id).
  assert (L1 : filterlim (fun u => u * ((K u - (r0 + r1 * u + r2 * u ^ 2)) / u ^ 2 + r2) + r1) (at_right 0) (locally r1)).
  { replace (locally r1) with (locally (0 * r2 + r1)) by (f_equal; ring). apply limit_sum; [| apply filterlim_const].
    apply limit_product; [exact Lu | exact L2]. }
  assert (L0 : filterlim (fun u => u * (u * ((K u - (r0 + r1 * u + r2 * u ^ 2)) / u ^ 2 + r2) + r1) + r0) (at_right 0) (locally r0)).
  { replace (locally r0) with (locally (0 * r1 + r0)) by (f_equal; ring). apply limit_sum; [| apply filterlim_const].
    apply limit_product; [exact Lu | exact L1]. }
  assert (Q : forall u, 0 < u < 1 -> 0 < sqrt u) by (intros u Hu; apply sqrt_lt_R0; lra).
  repeat split.
  - refine (filterlim_ext_loc _ _ _ L0). apply (near_right_0 1); [lra |]. intros u Hu. rewrite E. assert (S := Q u Hu). field. lra.
  - refine (filterlim_ext_loc _ _ _ L1). apply (near_right_0 1); [lra |]. intros u Hu. rewrite E. assert (S := Q u Hu). field. lra.
  - refine (filterlim_ext_loc _ _ _ L2). apply (near_right_0 1); [lra |]. intros u Hu. rewrite E. assert (S := Q u Hu). field. lra.
Qed.

Section Contacts.
Variables (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R).
Hypothesis contact : is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2.
Hypothesis left : is_left_edge a b b1 b2 b3 alpha.
Hypothesis convex : rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a.

Theorem orders_at_right : exists r0 r1 r2, is_the_right_series Es g1 a r0 r1 r2 /\ has_orders Es g1 a r0 r1 r2.
Proof.
  assert (S := right_edge _ _ _ _ _ _ _ _ _ _ contact). do 3 eexists. split.
  - exact (the_right_series _ _ y _ _ _ _ ltac:(apply convex) ltac:(apply convex) S).
  - exact (orders_of_series _ _ y _ _ _ _ ltac:(apply convex) ltac:(apply convex) S).
Qed.
Theorem orders_at_left : exists l0 l1 l2, is_the_left_series Es g1 (b a) l0 l1 l2 /\ has_orders Es (mirrored g1) (b a) l0 l1 l2.
Proof.
  assert (S := left_edge_of_a _ _ _ _ _ _ _ _ _ _ _ _ contact left). do 3 eexists. split.
  - exact (the_left_series _ _ z _ _ _ _ ltac:(apply convex) ltac:(apply convex) S).
  - exact (orders_of_series _ _ z _ _ _ _ ltac:(apply convex) ltac:(apply convex) S).
Qed.
End Contacts.

(* ---- Tilted wedges, with a bound of the remainder ---- *)

Lemma remainder_proportional K g c u : 0 < K -> 0 < g -> 0 < u < c / 2 ->
  Rabs (proportional_pressure K g c (c - u) - (c0 (fun _ => K) (fun s => g * s) c * sqrt u +
    c1 (fun _ => K) (fun _ => 0) (fun s => g * s) (fun _ => g) c * (u * sqrt u) +
    c2 (fun _ => K) (fun _ => 0) (fun _ => 0) (fun s => g * s) (fun _ => g) (fun _ => 0) c * (u ^ 2 * sqrt u))) <=
  12 * K / (7 * PI * sqrt ((1 + g) * c) * c ^ 3) * (u ^ 3 * sqrt u).
Proof.
  intros HK Hg Hu. destruct (below_proportional K g c u HK Hg ltac:(lra)) as (_ & _ & B).
  assert (A := above_proportional K g c u HK Hg ltac:(lra) ltac:(lra)).
  cbv zeta in A, B. rewrite Rabs_pos_eq; lra.
Qed.

Section Wedge.
Variables Es phi gam a : R.
Hypothesis form : 0 < Es /\ 0 < phi /\ 0 < gam /\ 0 < a.

Theorem remainder_at_right : exists r0 r1 r2, is_the_right_series Es (TiltedWedge.slope phi (tilt phi gam)) a r0 r1 r2 /\
  has_orders Es (TiltedWedge.slope phi (tilt phi gam)) a r0 r1 r2 /\
  has_remainder Es (TiltedWedge.slope phi (tilt phi gam)) a r0 r1 r2.
Proof.
  assert (Rise : rises_at (TiltedWedge.slope phi (tilt phi gam)) 0) by (apply wedge_rises, tilt_range; lra).
  assert (S := right_edge _ _ _ _ _ _ _ _ _ _ (TiltedWedge.smooth_contact Es phi gam a ltac:(lra) ltac:(lra))).
  do 3 eexists. split; [| split].
  - apply (the_right_series _ _ 0); [exact Rise | lra | exact S].
  - apply (orders_of_series _ _ 0); [exact Rise | lra | exact S].
  - exists (12 * (Es * phi * sqrt gam) / (7 * PI * sqrt ((1 + gam) * a) * a ^ 3)), (a / 2). split; [lra |]. intros u Hu.
    eexists. split; [apply (the_pressure _ _ 0); [exact Rise | lra | apply pressure_right_of_apex; lra] |].
    apply remainder_proportional; [apply (K_positive Es phi gam a form) | lra | lra].
Qed.
Theorem remainder_at_left : exists l0 l1 l2, is_the_left_series Es (TiltedWedge.slope phi (tilt phi gam)) (gam * a) l0 l1 l2 /\
  has_orders Es (mirrored (TiltedWedge.slope phi (tilt phi gam))) (gam * a) l0 l1 l2 /\
  has_remainder Es (mirrored (TiltedWedge.slope phi (tilt phi gam))) (gam * a) l0 l1 l2.
Proof.
  assert (Rise : rises_at (mirrored (TiltedWedge.slope phi (tilt phi gam))) 0) by (apply mirrored_wedge_rises, tilt_range; lra).
  assert (Hc : 0 < gam * a) by (apply Rmult_lt_0_compat; lra). assert (Hi := Rinv_0_lt_compat gam ltac:(lra)).
  assert (S := left_edge_of_a _ _ _ _ _ _ _ _ _ _ _ _ (TiltedWedge.smooth_contact Es phi gam a ltac:(lra) ltac:(lra))
    (TiltedWedge.left_of_a gam a ltac:(lra) ltac:(lra))). cbv beta in S.
  do 3 eexists. split; [| split].
  - apply (the_left_series _ _ 0); [exact Rise | exact Hc | exact S].
  - apply (orders_of_series _ _ 0); [exact Rise | exact Hc | exact S].
  - exists (12 * (Es * phi * sqrt gam / gam) / (7 * PI * sqrt ((1 + / gam) * (gam * a)) * (gam * a) ^ 3)), (gam * a / 2). split; [lra |]. intros u Hu.
    eexists. split; [apply (the_pressure _ _ 0); [exact Rise | lra | apply pressure_left_of_apex; lra] |].
    assert (HK : 0 < Es * phi * sqrt gam / gam) by (apply Rdiv_lt_0_compat; [exact (K_positive Es phi gam a form) | lra]).
    assert (B := remainder_proportional (Es * phi * sqrt gam / gam) (/ gam) (gam * a) u HK Hi ltac:(lra)).
    assert (Hw : 0 < sqrt (a + gam * a)) by (apply sqrt_lt_R0; lra). assert (Hpi := PI_RGT_0).
    match type of B with Rabs (_ - (?x * _ + ?y * _ + ?z * _)) <= _ => match goal with |- Rabs (_ - (?x' * _ + ?y' * _ + ?z' * _)) <= _ =>
      replace x' with x; [replace y' with y; [replace z' with z; [exact B |] |] |] end end;
    unfold left_c0, left_c1, left_c2, c0, c1, c2; replace (gam * a + / gam * (gam * a)) with (a + gam * a) by (field; lra);
    field; repeat split; lra.
Qed.
End Wedge.
