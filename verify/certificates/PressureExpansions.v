(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Symmetric Tactics Expansions HalfPowers Unique.
Open Scope R_scope.

(* p is the pressure near the right edge a, near the left edge -b0. *)
Definition are_pressures_right (Es : R) (g1 : R -> R) (a : R) (p : R -> R) : Prop :=
  exists d, 0 < d /\ forall x, a - d < x < a -> is_pressure Es g1 a x (p x).
Definition are_pressures_left (Es : R) (g1 : R -> R) (b0 : R) (p : R -> R) : Prop :=
  are_pressures_right Es (mirrored g1) b0 (fun x => p (- x)).

(* The same with the statement that there are no other pressures there. *)
Definition are_the_pressures_right (Es : R) (g1 : R -> R) (a : R) (p : R -> R) : Prop :=
  exists d, 0 < d /\ forall x, a - d < x < a -> is_the_pressure Es g1 a x (p x).
Definition are_the_pressures_left (Es : R) (g1 : R -> R) (b0 : R) (p : R -> R) : Prop :=
  are_the_pressures_right Es (mirrored g1) b0 (fun x => p (- x)).
Lemma the_pressures_right Es g1 y a p : rises_at g1 y -> y < a ->
  are_pressures_right Es g1 a p -> are_the_pressures_right Es g1 a p.
Proof.
  intros Hg Hy (d & Hd & H). exists (Rmin d (a - y)). split; [apply Rmin_pos; lra |]. intros x Hx.
  generalize (Rmin_l d (a - y)) (Rmin_r d (a - y)). intros.
  apply (the_pressure _ _ y); [exact Hg | lra | apply H; lra].
Qed.
Lemma the_pressures_left Es g1 z b0 p : rises_at (mirrored g1) z -> z < b0 ->
  are_pressures_left Es g1 b0 p -> are_the_pressures_left Es g1 b0 p.
Proof. exact (the_pressures_right Es (mirrored g1) z b0 (fun x => p (- x))). Qed.

Lemma pressures_of_series Es g1 a k0 k1 k2 : right_edge_series Es g1 a k0 k1 k2 ->
  exists p K, are_pressures_right Es g1 a p /\ (forall x, p x = sqrt (a - x) * K (a - x)) /\
    agrees_through 2 K (fun u => k0 + k1 * u + k2 * u ^ 2).
Proof.
  intros (K & K1 & d & Hd & Hp & HK & E0 & E1 & H2).
  exists (fun x => sqrt (a - x) * K (a - x)), K. split; [| split].
  - exists d. split; [exact Hd |]. intros x Hx. replace x with (a - (a - x)) at 1 by ring. apply Hp. lra.
  - reflexivity.
  - exact (taylor_2 K K1 k0 k1 k2 d Hd E0 HK E1 H2).
Qed.

Lemma agrees_scaled n f T X : 0 < X -> agrees_through n f T -> agrees_through n (fun u => f (u * X)) (fun u => T (u * X)).
Proof.
  intros HX H c Hc. assert (Hn : 0 < X ^ n) by (apply pow_lt, HX).
  destruct (H (c / X ^ n) ltac:(apply Rdiv_lt_0_compat; lra)) as [d [Hd Hb]].
  exists (d / X). split; [apply Rdiv_lt_0_compat; lra |]. intros u Hu.
  assert (0 < u * X) by (apply Rmult_lt_0_compat; lra).
  assert (u * X < d). { apply (Rmult_lt_reg_r (/ X)); [apply Rinv_0_lt_compat; lra |]. rewrite Rmult_assoc, Rinv_r by lra. unfold Rdiv in Hu. lra. }
  specialize (Hb (u * X) ltac:(lra)). rewrite Rpow_mult_distr in Hb.
  replace (c / X ^ n * (u ^ n * X ^ n)) with (c * u ^ n) in Hb by (field; lra). exact Hb.
Qed.

(* u N / D, where D = h1 u + h2 u^2 + h3 u^3 + o(u^3) *)
Lemma quotient_of N D n0 n1 n2 h1 h2 h3 : 0 < h1 ->
  agrees_through 2 N (fun u => n0 + n1 * u + n2 * u ^ 2) ->
  agrees_through 3 D (fun u => 0 + h1 * u + h2 * u ^ 2 + h3 * u ^ 3) ->
  let q0 := n0 / h1 in let q1 := (n1 - q0 * h2) / h1 in let q2 := (n2 - q0 * h3 - q1 * h2) / h1 in
  agrees_through 2 (fun u => u * (N u / D u)) (fun u => q0 + q1 * u + q2 * u ^ 2).
Proof.
  intros Hh HN HD q0 q1 q2.
  set (M := Rabs q0 + Rabs q1 + Rabs q2). assert (HM : 0 <= M) by (unfold M; generalize (Rabs_pos q0) (Rabs_pos q1) (Rabs_pos q2); lra).
  set (L := Rabs (q2 * h2 + q1 * h3) + Rabs (q2 * h3)). assert (HL : 0 <= L) by (unfold L; generalize (Rabs_pos (q2 * h2 + q1 * h3)) (Rabs_pos (q2 * h3)); lra).
  set (H := Rabs h2 + Rabs h3 + 1). assert (HH : 0 < H) by (unfold H; generalize (Rabs_pos h2) (Rabs_pos h3); lra).
  intros c Hc.
  assert (Hc1 : 0 < c * h1 / 8) by nra.
  assert (Hc2 : 0 < c * h1 / (8 * (1 + M))) by (apply Rdiv_lt_0_compat; nra).
  destruct (HN (c * h1 / 8) Hc1) as [d1 [Hd1 B1]].
  destruct (HD (Rmin 1 (c * h1 / (8 * (1 + M)))) ltac:(apply Rmin_pos; lra)) as [d2 [Hd2 B2]].
  assert (Hd3 : 0 < h1 / (2 * H)) by (apply Rdiv_lt_0_compat; lra).
  assert (Hd4 : 0 < c * h1 / (8 * (1 + L))) by (apply Rdiv_lt_0_compat; nra).
  exists (Rmin (Rmin (Rmin d1 d2) (Rmin (h1 / (2 * H)) (c * h1 / (8 * (1 + L))))) 1).
  split; [repeat apply Rmin_pos; lra |]. intros u Hu.
  generalize (Rmin_l (Rmin (Rmin d1 d2) (Rmin (h1 / (2 * H)) (c * h1 / (8 * (1 + L))))) 1)
    (Rmin_r (Rmin (Rmin d1 d2) (Rmin (h1 / (2 * H)) (c * h1 / (8 * (1 + L))))) 1)
    (Rmin_l (Rmin d1 d2) (Rmin (h1 / (2 * H)) (c * h1 / (8 * (1 + L)))))
    (Rmin_r (Rmin d1 d2) (Rmin (h1 / (2 * H)) (c * h1 / (8 * (1 + L)))))
    (Rmin_l d1 d2) (Rmin_r d1 d2) (Rmin_l (h1 / (2 * H)) (c * h1 / (8 * (1 + L)))) (Rmin_r (h1 / (2 * H)) (c * h1 / (8 * (1 + L)))).
  intros. specialize (B1 u ltac:(lra)). specialize (B2 u ltac:(lra)).
  generalize (Rmin_l 1 (c * h1 / (8 * (1 + M)))) (Rmin_r 1 (c * h1 / (8 * (1 + M)))). intros Hl Hr.
  set (delta := Rmin 1 (c * h1 / (8 * (1 + M)))) in *.
  set (rN := N u - (n0 + n1 * u + n2 * u ^ 2)) in *. set (rD := D u - (0 + h1 * u + h2 * u ^ 2 + h3 * u ^ 3)) in *.
  set (Q := q0 + q1 * u + q2 * u ^ 2).
  assert (Hu2 : 0 <= u ^ 2 <= u) by nra. assert (Hu3 : 0 <= u ^ 3 <= u ^ 2) by nra.
  assert (HuH : u * H <= h1 / 2).
  { apply (Rle_trans _ (h1 / (2 * H) * H)); [apply Rmult_le_compat_r; lra |]. right. field. lra. }
  assert (HuL : u * (1 + L) <= c * h1 / 8).
  { apply (Rle_trans _ (c * h1 / (8 * (1 + L)) * (1 + L))); [apply Rmult_le_compat_r; lra |]. right. field. lra. }
  assert (HdM : delta * (1 + M) <= c * h1 / 8).
  { apply (Rle_trans _ (c * h1 / (8 * (1 + M)) * (1 + M))); [apply Rmult_le_compat_r; lra |]. right. field. lra. }
  assert (ED : D u = h1 * u + h2 * u ^ 2 + h3 * u ^ 3 + rD) by (unfold rD; ring).
  assert (BD : h1 * u / 2 <= D u).
  { assert (T : Rabs (h2 * u ^ 2 + h3 * u ^ 3 + rD) <= u ^ 2 * H).
    { apply (Rle_trans _ _ _ (Rabs_triang _ _)). assert (T2 := Rabs_triang (h2 * u ^ 2) (h3 * u ^ 3)).
      rewrite !Rabs_mult, (Rabs_pos_eq (u ^ 2)), (Rabs_pos_eq (u ^ 3)) in T2 by lra.
      generalize (Rabs_pos h2) (Rabs_pos h3). intros. unfold H. nra. }
    assert (T3 : u ^ 2 * H <= u * h1 / 2) by nra.
    apply Rabs_le_between in T. lra. }
  assert (HDp : 0 < D u) by nra.
  assert (EQ : u * (N u / D u) - Q = (u * rN - rD * Q - u ^ 4 * ((q2 * h2 + q1 * h3) + q2 * h3 * u)) * / D u).
  { unfold Rdiv. replace (N u) with (n0 + n1 * u + n2 * u ^ 2 + rN) by (unfold rN; ring).
    apply (Rmult_eq_reg_r (D u)); [| lra].
    replace ((u * rN - rD * Q - u ^ 4 * ((q2 * h2 + q1 * h3) + q2 * h3 * u)) * / D u * D u)
      with (u * rN - rD * Q - u ^ 4 * ((q2 * h2 + q1 * h3) + q2 * h3 * u)) by (field; lra).
    replace ((u * ((n0 + n1 * u + n2 * u ^ 2 + rN) * / D u) - Q) * D u)
      with (u * (n0 + n1 * u + n2 * u ^ 2 + rN) - Q * D u) by (field; lra).
    rewrite ED. unfold Q, q2, q1, q0. field. lra. }
  rewrite EQ, Rabs_mult, (Rabs_pos_eq (/ D u)) by (left; apply Rinv_0_lt_compat, HDp).
  apply (Rmult_le_reg_r (D u)); [exact HDp |]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  assert (BQ : Rabs Q <= M).
  { unfold Q. apply (Rle_trans _ _ _ (Rabs_triang _ _)). assert (T2 := Rabs_triang q0 (q1 * u)).
    rewrite !Rabs_mult, (Rabs_pos_eq u), (Rabs_pos_eq (u ^ 2)) in * by lra.
    generalize (Rabs_pos q0) (Rabs_pos q1) (Rabs_pos q2). intros. unfold M. nra. }
  assert (BP : Rabs (u ^ 4 * ((q2 * h2 + q1 * h3) + q2 * h3 * u)) <= u ^ 3 * (c * h1 / 8)).
  { assert (T2 := Rabs_triang (q2 * h2 + q1 * h3) (q2 * h3 * u)). rewrite (Rabs_mult (q2 * h3) u), (Rabs_pos_eq u) in T2 by lra.
    rewrite Rabs_mult.
    rewrite (Rabs_pos_eq (u ^ 4)) by (apply pow_le; lra).
    assert (T3 : Rabs (q2 * h2 + q1 * h3) + Rabs (q2 * h3) * u <= L).
    { unfold L. generalize (Rabs_pos (q2 * h3)). nra. }
    replace (u ^ 4) with (u ^ 3 * u) by ring. rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra |].
    apply (Rle_trans _ (u * L)); [apply Rmult_le_compat_l; lra | nra]. }
  assert (BN : Rabs (u * rN) <= u ^ 3 * (c * h1 / 8)).
  { rewrite Rabs_mult, (Rabs_pos_eq u) by lra. replace (u ^ 3 * (c * h1 / 8)) with (u * (c * h1 / 8 * u ^ 2)) by ring.
    apply Rmult_le_compat_l; lra. }
  assert (BR : Rabs (rD * Q) <= u ^ 3 * (c * h1 / 8)).
  { rewrite Rabs_mult. apply (Rle_trans _ (delta * u ^ 3 * M)); [apply Rmult_le_compat; try apply Rabs_pos; assumption |].
    assert (0 < delta) by (unfold delta; apply Rmin_pos; lra).
    replace (delta * u ^ 3 * M) with (u ^ 3 * (delta * M)) by ring. apply Rmult_le_compat_l; nra. }
  apply (Rle_trans _ (3 * (u ^ 3 * (c * h1 / 8)))).
  - assert (T1 := Rabs_triang (u * rN) (- (rD * Q))). assert (T2 := Rabs_triang (u * rN - rD * Q) (- (u ^ 4 * ((q2 * h2 + q1 * h3) + q2 * h3 * u)))).
    rewrite Rabs_Ropp in *. unfold Rminus in *. lra.
  - apply (Rle_trans _ (c * u ^ 2 * (h1 * u / 2))); [| apply Rmult_le_compat_l; nra].
    assert (0 <= u ^ 3 * (c * h1)) by (apply Rmult_le_pos; nra). 
    replace (c * u ^ 2 * (h1 * u / 2)) with (u ^ 3 * (c * h1) / 2) by (simpl; field).
    replace (3 * (u ^ 3 * (c * h1 / 8))) with (3 / 8 * (u ^ 3 * (c * h1))) by field. lra.
Qed.

(* p(-b + eps X)/(a - b^-1(b - eps X)) *)
Theorem left_quotient_through_2 Es g1 a P P1 P2 P3 b b1 b2 b3 alpha X :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 -> is_left_edge a b b1 b2 b3 alpha -> 0 < X ->
  exists p, are_pressures_left Es g1 (b a) p /\
  agrees_through 2 (fun eps => sqrt eps * (p (- b a + eps * X) / (a - alpha (b a - eps * X))))
    (fun u => 2 * P1 a / (PI * sqrt X * sqrt (a + b a))
      + sqrt X * ((2 * b1 a + 3 * b1 a ^ 2 + (a + b a) * b2 a) * P1 a - 4 * b1 a * (a + b a) * P2 a)
        / (3 * PI * b1 a ^ 2 * ((a + b a) * sqrt (a + b a))) * u
      + X * sqrt X * ((10 * (a + b a) * b2 a * b1 a ^ 2 + 24 * b1 a ^ 2 + 26 * (a + b a) ^ 2 * b2 a ^ 2
          + 28 * (a + b a) * b1 a * b2 a + 45 * b1 a ^ 4 + 60 * b1 a ^ 3 - 12 * b1 a * b3 a * (a + b a) ^ 2) * P1 a
        - 8 * b1 a * (a + b a) * (4 * b1 a + 5 * b1 a ^ 2 + 7 * (a + b a) * b2 a) * P2 a
        + 32 * b1 a ^ 2 * (a + b a) ^ 2 * P3 a)
        / (60 * PI * b1 a ^ 4 * ((a + b a) ^ 2 * sqrt (a + b a))) * u ^ 2).
Proof.
  intros contact left HX. assert (Hb := rate_positive _ _ _ _ _ _ left).
  assert (Hw := positive_width _ _ _ _ _ _ _ _ _ _ contact). assert (Hpi := PI_RGT_0).
  destruct (pressures_of_series _ _ _ _ _ _ (left_edge_of_a _ _ _ _ _ _ _ _ _ _ _ _ contact left)) as (q & K & Hq & Eq & HK).
  exists (fun x => q (- x)). split.
  { destruct Hq as [d [Hd H]]. exists d. split; [exact Hd |]. intros x Hx. rewrite Ropp_involutive. apply H, Hx. }
  assert (HD := inverse_through_3 _ _ _ _ _ _ _ _ _ _ _ _ contact left X).
  assert (HD' : agrees_through 3 (fun u => a - alpha (b a - u * X)) (fun u => 0 + X / b1 a * u + X ^ 2 * b2 a / (2 * b1 a ^ 3) * u ^ 2
    + X ^ 3 * (3 * b2 a ^ 2 - b1 a * b3 a) / (6 * b1 a ^ 5) * u ^ 3)).
  { intros c Hc. destruct (HD c Hc) as [d [Hd H]]. exists d. split; [exact Hd |]. intros u Hu. rewrite <- Rabs_Ropp.
    eapply Rle_trans; [| apply H, Hu]. right. f_equal. field. lra. }
  assert (HN := agrees_scaled _ _ _ X HX HK).
  assert (Hroot : 0 < sqrt X) by (apply sqrt_lt_R0, HX).
  assert (HN' : agrees_through 2 (fun u => K (u * X)) (fun u => left_c0 a P1 b b1 + left_c1 a P1 P2 b b1 b2 * X * u
    + left_c2 a P1 P2 P3 b b1 b2 b3 * X ^ 2 * u ^ 2)).
  { apply (agrees_ext _ _ _ _ HN). intros. ring. }
  assert (Hh : 0 < X / b1 a) by (apply Rdiv_lt_0_compat; lra).
  assert (H := quotient_of _ _ _ _ _ _ _ _ Hh HN' HD'). cbv zeta in H.
  intros c Hc. assert (Hcx : 0 < c / sqrt X) by (apply Rdiv_lt_0_compat; lra).
  destruct (H (c / sqrt X) Hcx) as [d [Hd B]].
  exists d. split; [exact Hd |]. intros u Hu. specialize (B u Hu).
  rewrite Eq. replace (b a - - (- b a + u * X)) with (u * X) by ring.
  rewrite sqrt_mult by lra.
  apply (Rmult_le_compat_l (sqrt X)) in B; [| lra].
  replace (sqrt X * (c / sqrt X * u ^ 2)) with (c * u ^ 2) in B by (field; lra).
  refine (Rle_trans _ _ _ _ B). right.
  match goal with |- _ = sqrt X * Rabs ?z => replace (sqrt X * Rabs z) with (Rabs (sqrt X * z))
    by (rewrite Rabs_mult, (Rabs_pos_eq (sqrt X)); [reflexivity | lra]) end. f_equal.
  replace (sqrt u * (sqrt u * sqrt X * K (u * X) / (a - alpha (b a - u * X))))
    with (sqrt X * (u * (K (u * X) / (a - alpha (b a - u * X))))).
  2: { rewrite <- (sqrt_sqrt u) at 1 by lra. unfold Rdiv. ring. }
  generalize (u * (K (u * X) / (a - alpha (b a - u * X)))). intros z.
  unfold left_c0, left_c1, left_c2.
  assert (Er : sqrt (a + b a) * sqrt (a + b a) = a + b a) by (apply sqrt_sqrt; lra).
  assert (Hr : 0 < sqrt (a + b a)) by (apply sqrt_lt_R0; lra).
  assert (Ex : sqrt X * sqrt X = X) by (apply sqrt_sqrt; lra).
  set (r := sqrt (a + b a)) in *. set (x := sqrt X) in *. clearbody r x. rewrite <- !Er. rewrite <- !Ex.
  field. repeat split; try lra.
Qed.
Theorem left_quotient_at_1 Es g1 a P P1 P2 P3 b b1 b2 b3 alpha :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 -> is_left_edge a b b1 b2 b3 alpha ->
  exists p, are_pressures_left Es g1 (b a) p /\
  agrees_through 2 (fun eps => sqrt eps * (p (- b a + eps) / (a - alpha (b a - eps))))
    (fun u => 2 * P1 a / (PI * sqrt (a + b a))
      + ((2 * b1 a + 3 * b1 a ^ 2 + (a + b a) * b2 a) * P1 a - 4 * b1 a * (a + b a) * P2 a)
        / (3 * PI * b1 a ^ 2 * ((a + b a) * sqrt (a + b a))) * u
      + ((10 * (a + b a) * b2 a * b1 a ^ 2 + 24 * b1 a ^ 2 + 26 * (a + b a) ^ 2 * b2 a ^ 2
          + 28 * (a + b a) * b1 a * b2 a + 45 * b1 a ^ 4 + 60 * b1 a ^ 3 - 12 * b1 a * b3 a * (a + b a) ^ 2) * P1 a
        - 8 * b1 a * (a + b a) * (4 * b1 a + 5 * b1 a ^ 2 + 7 * (a + b a) * b2 a) * P2 a
        + 32 * b1 a ^ 2 * (a + b a) ^ 2 * P3 a)
        / (60 * PI * b1 a ^ 4 * ((a + b a) ^ 2 * sqrt (a + b a))) * u ^ 2).
Proof.
  intros contact left. assert (Hb := rate_positive _ _ _ _ _ _ left).
  assert (Hw := positive_width _ _ _ _ _ _ _ _ _ _ contact). assert (Hpi := PI_RGT_0).
  assert (Hr : 0 < sqrt (a + b a)) by (apply sqrt_lt_R0; lra).
  destruct (left_quotient_through_2 _ _ _ _ _ _ _ _ _ _ _ _ 1 contact left Rlt_0_1) as (p & Hp & H).
  exists p. split; [exact Hp |]. refine (agrees_near _ _ _ _ _ 1 Rlt_0_1 _ H).
  intros u _. rewrite !Rmult_1_r, sqrt_1. split; [reflexivity | field; repeat split; lra].
Qed.

(* p(a - eps X) of a symmetric contact *)
Theorem right_pressure_through_3 Es g1 a P P1 P2 P3 X :
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) -> 0 < X ->
  exists p, are_pressures_right Es g1 a p /\
  agrees_through 3 (fun eps => sqrt eps * p (a - eps * X))
    (fun u => 0 + P1 a * sqrt 2 * sqrt X / (PI * sqrt a) * u
      + X * sqrt X * sqrt 2 * (5 * P1 a - 8 * a * P2 a) / (12 * PI * (a * sqrt a)) * u ^ 2
      + X ^ 2 * sqrt X * sqrt 2 * (129 * P1 a - 144 * a * P2 a + 128 * a ^ 2 * P3 a) / (480 * PI * (a ^ 2 * sqrt a)) * u ^ 3).
Proof.
  intros contact HX. assert (Hw := positive_width _ _ _ _ _ _ _ _ _ _ contact). cbv beta in Hw. assert (Hpi := PI_RGT_0).
  assert (Ha : 0 < a) by lra. assert (Hra := sqrt_lt_R0 a Ha). assert (Hrx := sqrt_lt_R0 X HX).
  destruct (pressures_of_series _ _ _ _ _ _ (right_edge _ _ _ _ _ _ _ _ _ _ contact)) as (p & K & Hp & Ep & HK).
  exists p. split; [exact Hp |]. assert (HN := agrees_scaled _ _ _ X HX HK).
  intros c Hc. assert (Hcx : 0 < c / sqrt X) by (apply Rdiv_lt_0_compat; lra).
  destruct (HN (c / sqrt X) Hcx) as [d [Hd B]]. exists d. split; [exact Hd |]. intros u Hu. specialize (B u Hu).
  rewrite Ep. replace (a - (a - u * X)) with (u * X) by ring. rewrite sqrt_mult by lra.
  generalize dependent (K (u * X)). intros z B.
  assert (Hux : 0 <= u * sqrt X) by (apply Rmult_le_pos; lra).
  apply (Rmult_le_compat_l (u * sqrt X)) in B; [| exact Hux].
  replace (u * sqrt X * (c / sqrt X * u ^ 2)) with (c * u ^ 3) in B by (field; lra).
  refine (Rle_trans _ _ _ _ B). right.
  match goal with |- _ = u * sqrt X * Rabs ?y => replace (u * sqrt X * Rabs y) with (Rabs (u * sqrt X * y))
    by (rewrite Rabs_mult, (Rabs_pos_eq (u * sqrt X)); [reflexivity | exact Hux]) end. f_equal.
  replace (sqrt u * (sqrt u * sqrt X * z)) with (u * sqrt X * z) by (rewrite <- (sqrt_sqrt u) at 1 by lra; ring).
  unfold c0, c1, c2. rewrite root_of_twice by exact Ha.
  assert (Ea : sqrt a ^ 2 = a) by (apply pow2_sqrt; lra).
  assert (Ex : sqrt X ^ 2 = X) by (apply pow2_sqrt; lra).
  assert (E2 : sqrt 2 ^ 2 = 2) by (apply pow2_sqrt; lra).
  assert (H2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  generalize (P1 a) (P2 a) (P3 a). intros p1 p2 p3.
  set (r := sqrt a) in *. set (x := sqrt X) in *. set (q := sqrt 2) in *. clearbody r x q.
  field_simplify_eq; [ring [E2] | repeat split; lra].
Qed.

(* An integral whose integrand is unbounded at its upper end. *)
Definition is_integral_up_to (f : R -> R) (l X I : R) : Prop :=
  filterlim (fun e => RInt f l e) (at_left X) (locally I).

Lemma integral_over_root X (G : R -> R) I : 0 < X ->
  (forall S, G S = G 0 + (4 * G 1 - 3 * G 0 - G 2) / 2 * S + (G 0 - 2 * G 1 + G 2) / 2 * S ^ 2) ->
  is_integral_up_to (fun S => 1 / sqrt (X - S) * G S) 0 X I ->
  I = 2 * sqrt X * (G 0 + (4 * G 1 - 3 * G 0 - G 2) / 2 * (2 * X / 3) + (G 0 - 2 * G 1 + G 2) / 2 * (8 * X ^ 2 / 15)).
Proof.
  intros HX HG HI. set (q0 := G 0) in *. set (q1 := (4 * G 1 - 3 * q0 - G 2) / 2) in *. set (q2 := (q0 - 2 * G 1 + G 2) / 2) in *.
  set (W w := - 2 * (w * (q0 + q1 * X + q2 * X ^ 2) - w ^ 3 / 3 * (q1 + 2 * q2 * X) + q2 * w ^ 5 / 5)).
  set (F S := W (sqrt (X - S))).
  assert (HF : forall S, S < X -> is_derive F S (1 / sqrt (X - S) * G S)).
  { intros S HS. rewrite HG. fold q0 q1 q2. assert (Hr : 0 < sqrt (X - S)) by (apply sqrt_lt_R0; lra).
    unfold F, W. auto_derive; change (X + - S) with (X - S).
    - repeat split; lra.
    - assert (E : S = X - sqrt (X - S) * sqrt (X - S)) by (rewrite sqrt_sqrt; lra).
      set (r := sqrt (X - S)) in *. clearbody r. subst S. field. lra. }
  assert (HE : forall e, 0 < e < X -> RInt (fun S => 1 / sqrt (X - S) * G S) 0 e = F e - F 0).
  { intros e He. apply is_RInt_unique. apply (is_RInt_derive F).
    - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. apply HF. lra.
    - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra.
      assert (Hr : 0 < sqrt (X - x)) by (apply sqrt_lt_R0; lra).
      apply (continuous_ext (fun S => 1 / sqrt (X - S) * (q0 + q1 * S + q2 * S ^ 2))). { intros S. rewrite HG. reflexivity. }
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. repeat split; change (X + - x) with (X - x); lra. }
  assert (HL : filterlim (fun e => F e - F 0) (at_left X) (locally (F X - F 0))).
  { apply (filterlim_filter_le_1 _ (filter_le_within _)).
    change (continuous (fun e => F e - F 0) X).
    apply (continuous_minus F (fun _ => F 0)); [| apply continuous_const].
    apply (continuous_comp (fun e => sqrt (X - e)) W).
    - apply (continuous_comp (fun e => X - e) sqrt); [| apply continuous_sqrt].
      apply (continuous_minus (fun _ => X) (fun e => e)); [apply continuous_const | apply continuous_id].
    - apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold W. auto_derive. trivial. }
  assert (HI' : filterlim (fun e => F e - F 0) (at_left X) (locally I)).
  { apply (filterlim_ext_loc (fun e => RInt (fun S => 1 / sqrt (X - S) * G S) 0 e)); [| exact HI].
    exists (mkposreal X HX). intros e He Hlt. apply HE.
    unfold ball in He; simpl in He. unfold AbsRing_ball, abs, minus, plus, opp in He; simpl in He. apply Rabs_def2 in He. lra. }
  rewrite (filterlim_locally_unique _ _ _ HI' HL). unfold F, W. rewrite Rminus_0_r. replace (X - X) with 0 by ring. rewrite sqrt_0.
  assert (E : X = sqrt X * sqrt X) by (symmetry; apply sqrt_sqrt; lra).
  set (r := sqrt X) in *. clearbody r q0 q1 q2. clear - E. rewrite !E. field.
Qed.
(* The contact at which expansions of symmetric contacts are tried. *)
Definition wedge : list part := cons (Part 0 1 0) nil.
Lemma apart x : 0 < Rabs x -> x <> 0.
Proof. intros H ->. rewrite Rabs_R0 in H. lra. Qed.

(* HI says what each I eps is: its value is put in, for all eps. *)
Ltac with_integral HI :=
  apply agrees_equal; intros u Hu; assert (value := HI u Hu); apply integral_over_root in value;
  [cbv beta in value; rewrite value | assumption | intros; cbv beta; field; lra].
