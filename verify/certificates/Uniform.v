(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Tactics Expansions.
Open Scope R_scope.

(* ---- (x + b(a + (b^-1(-x) - a) sigma))/(eps (1 - sigma)), x = -b + eps, for all sigma at once ---- *)

(* A derivative of b is its tangent but for a square. *)
Lemma near_tangent (f f1 f2 : R -> R) a e c :
  0 < e -> (forall s, a - e < s < a + e -> is_derive f s (f1 s)) -> is_derive f1 a c ->
  exists C d, 0 <= C /\ 0 < d /\ forall y, - d < y < d -> Rabs (f (a + y) - f a - f1 a * y) <= C * y ^ 2.
Proof.
  intros He Hf H1. apply is_derive_Reals in H1. destruct (H1 1 Rlt_0_1) as [d Hd].
  exists (Rabs c + 1), (Rmin e d). split; [generalize (Rabs_pos c); lra |].
  split; [apply Rmin_pos; [exact He | apply cond_pos] |]. intros y Hy.
  generalize (Rmin_l e d) (Rmin_r e d). intros Hm1 Hm2.
  assert (Hz : exists z, Rabs z <= Rabs y /\ f (a + y) - f a = f1 (a + z) * y).
  { destruct (MVT_gen f a (a + y) f1) as [z [Hz E]].
    - intros x Hx. apply Hf. unfold Rmin, Rmax in Hx. destruct (Rle_dec a (a + y)); lra.
    - intros x Hx. apply continuity_pt_filterlim. apply (@ex_derive_continuous R_AbsRing R_NormedModule).
      exists (f1 x). apply Hf. unfold Rmin, Rmax in Hx. destruct (Rle_dec a (a + y)); lra.
    - exists (z - a). split.
      + unfold Rmin, Rmax in Hz. unfold Rabs. destruct (Rle_dec a (a + y)), (Rcase_abs (z - a)), (Rcase_abs y); lra.
      + replace (a + (z - a)) with z by ring. rewrite E. ring. }
  destruct Hz as [z [Hzy E]].
  replace (f (a + y) - f a - f1 a * y) with ((f1 (a + z) - f1 a) * y) by (rewrite E; ring).
  assert (Hya : Rabs y < d) by (apply Rabs_def1; lra).
  assert (B : Rabs (f1 (a + z) - f1 a) <= (Rabs c + 1) * Rabs z).
  { destruct (Req_dec z 0) as [-> | Hz0].
    - rewrite Rplus_0_r, Rminus_diag_eq, Rabs_R0 by reflexivity. lra.
    - assert (T := Hd z Hz0 ltac:(lra)). assert (Hza := Rabs_pos_lt z Hz0).
      replace (f1 (a + z) - f1 a) with (((f1 (a + z) - f1 a) / z - c + c) * z) by (field; exact Hz0).
      rewrite Rabs_mult. apply Rmult_le_compat_r; [lra |].
      apply (Rle_trans _ _ _ (Rabs_triang _ _)). lra. }
  rewrite Rabs_mult. replace (y ^ 2) with (Rabs y * Rabs y) by (rewrite <- Rabs_mult, Rabs_pos_eq; [ring | nra]).
  rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [apply Rabs_pos |].
  apply (Rle_trans _ _ _ B). apply Rmult_le_compat_l; [generalize (Rabs_pos c); lra | exact Hzy].
Qed.

Theorem bracket_uniform Es g1 a P P1 P2 P3 b b1 b2 b3 alpha :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 -> is_left_edge a b b1 b2 b3 alpha ->
  exists M d : R, 0 < d /\ forall eps sigma, 0 < eps < d -> 0 < sigma < 1 ->
  Rabs ((- b a + eps + b (a + (alpha (b a - eps) - a) * sigma)) / (eps * (1 - sigma))
    - (1 - eps * b2 a * sigma / (2 * b1 a ^ 2))) <= M * eps ^ 2.
Proof.
  intros contact left. assert (Hb := rate_positive _ _ _ _ _ _ left).
  assert (HI := inverse_through_3 _ _ _ _ _ _ _ _ _ _ _ _ contact left 1).
  destruct contact as [e1 [He1 H1]]. assert (left' := left). destruct left' as [inverse [e2 [He2 [H2 H3]]]].
  assert (Hm : 0 < Rmin e1 e2) by (apply Rmin_pos; lra). generalize (Rmin_l e1 e2) (Rmin_r e1 e2). intros Hm1 Hm2.
  destruct (near_tangent b1 b2 b3 a (Rmin e1 e2) (b3 a) Hm) as (C & d0 & HC & Hd0 & HT).
  { intros s Hs. apply (H1 s). lra. }
  { apply (H2 a). lra. }
  destruct (HI 1 Rlt_0_1) as [d1 [Hd1 B1]].
  set (k := b1 a) in *. set (k2 := b2 a) in *.
  set (c3 := Rabs (1 ^ 3 * (3 * k2 ^ 2 - k * b3 a) / (6 * k ^ 5)) + 1).
  set (c2 := Rabs (k2 / (2 * k ^ 3)) + c3). set (c1 := / k + c2).
  assert (Hk3 : 0 <= c3) by (unfold c3; generalize (Rabs_pos (1 ^ 3 * (3 * k2 ^ 2 - k * b3 a) / (6 * k ^ 5))); lra).
  assert (Hk2 : 0 <= c2) by (unfold c2; generalize (Rabs_pos (k2 / (2 * k ^ 3))); lra).
  assert (Hik : 0 < / k) by (apply Rinv_0_lt_compat; exact Hb).
  assert (Hk1 : 0 < c1) by (unfold c1; lra).
  set (d := Rmin (Rmin d1 1) (Rmin (Rmin e1 e2 / c1) (Rmin (d0 / c1) e2))).
  exists (k * c3 + Rabs k2 * (c2 * (c1 + / k)) + C * c1 ^ 3), d.
  assert (Hq1 : 0 < Rmin e1 e2 / c1) by (apply Rdiv_lt_0_compat; lra).
  assert (Hq2 : 0 < d0 / c1) by (apply Rdiv_lt_0_compat; lra).
  split; [unfold d; repeat apply Rmin_pos; lra |].
  intros u sigma Hu Hs.
  generalize (Rmin_l (Rmin d1 1) (Rmin (Rmin e1 e2 / c1) (Rmin (d0 / c1) e2)))
    (Rmin_r (Rmin d1 1) (Rmin (Rmin e1 e2 / c1) (Rmin (d0 / c1) e2))) (Rmin_l d1 1) (Rmin_r d1 1)
    (Rmin_l (Rmin e1 e2 / c1) (Rmin (d0 / c1) e2)) (Rmin_r (Rmin e1 e2 / c1) (Rmin (d0 / c1) e2))
    (Rmin_l (d0 / c1) e2) (Rmin_r (d0 / c1) e2). fold d. intros.
  set (h := alpha (b a - u) - a).
  assert (Bh := B1 u ltac:(lra)). rewrite Rmult_1_r in Bh. fold h in Bh.
  assert (Hu2 : 0 <= u ^ 2 <= u) by nra. assert (Hu3 : 0 <= u ^ 3 <= u ^ 2) by nra.
  set (r := h + u / k + k2 / (2 * k ^ 3) * u ^ 2).
  assert (Br : Rabs r <= c3 * u ^ 3).
  { set (t := 1 ^ 3 * (3 * k2 ^ 2 - k * b3 a) / (6 * k ^ 5)) in *.
    replace r with ((h - (0 + - (1 / k) * u + - (1 ^ 2 * k2 / (2 * k ^ 3)) * u ^ 2 + - t * u ^ 3)) + - t * u ^ 3)
      by (unfold r; field; lra).
    apply (Rle_trans _ _ _ (Rabs_triang _ _)). rewrite (Rabs_mult (- t)), Rabs_Ropp, (Rabs_pos_eq (u ^ 3)) by lra. unfold c3. lra. }
  assert (B2 : Rabs (h + u / k) <= c2 * u ^ 2).
  { replace (h + u / k) with (r + - (k2 / (2 * k ^ 3)) * u ^ 2) by (unfold r; ring).
    apply (Rle_trans _ _ _ (Rabs_triang _ _)). rewrite (Rabs_mult (- (k2 / (2 * k ^ 3)))), Rabs_Ropp, (Rabs_pos_eq (u ^ 2)) by lra.
    unfold c2. nra. }
  assert (Bhu : Rabs h <= c1 * u).
  { replace h with ((h + u / k) + - (u / k)) by ring. apply (Rle_trans _ _ _ (Rabs_triang _ _)).
    rewrite Rabs_Ropp, (Rabs_pos_eq (u / k)) by (apply Rlt_le, Rdiv_lt_0_compat; lra). unfold c1, Rdiv. nra. }
  assert (Hc1u : forall e, 0 < e -> u < e / c1 -> c1 * u < e).
  { intros e He Hue. apply (Rmult_lt_compat_l c1) in Hue; [| lra]. replace (c1 * (e / c1)) with e in Hue by (field; lra). exact Hue. }
  assert (Hhe := Hc1u _ Hm ltac:(lra)). assert (Hhd := Hc1u _ Hd0 ltac:(lra)).
  assert (Habs : - (c1 * u) <= h <= c1 * u) by (apply Rabs_le_between; exact Bhu).
  assert (Eb : b (a + h) = b a - u).
  { unfold h. replace (a + (alpha (b a - u) - a)) with (alpha (b a - u)) by ring. apply (H3 (b a - u)). lra. }
  (* the mean value theorem between sigma and 1 *)
  set (psi t := b (a + h * t) - k * h * t - k2 * h ^ 2 * t ^ 2 / 2).
  set (psi1 t := h * (b1 (a + h * t) - k - k2 * (h * t))).
  destruct (MVT_cor2 psi psi1 sigma 1 ltac:(lra)) as [t [E Ht]].
  { intros t Ht. apply is_derive_Reals. assert (Hht : a - e1 < a + h * t < a + e1) by (split; nra).
    destruct (H1 (a + h * t) Hht) as (_ & _ & _ & _ & Hd & _). unfold psi, psi1. auto_derive.
    - repeat split. exists (b1 (a + h * t)). exact Hd.
    - replace (Derive (fun x : R => b x) (a + h * t)) with (b1 (a + h * t)) by (symmetry; apply is_derive_unique; exact Hd).
      simpl. field. }
  assert (Bp : Rabs (psi1 t) <= C * c1 ^ 3 * u ^ 3).
  { unfold psi1. rewrite Rabs_mult. assert (Hht : - d0 < h * t < d0) by (split; nra).
    assert (T := HT (h * t) Hht). fold k k2 in T.
    assert (Hh2 : (h * t) ^ 2 <= (c1 * u) ^ 2).
    { rewrite <- (pow2_abs (h * t)). apply pow_incr. split; [apply Rabs_pos |].
      rewrite Rabs_mult, (Rabs_pos_eq t) by lra. generalize (Rabs_pos h). nra. }
    replace (C * c1 ^ 3 * u ^ 3) with ((c1 * u) * (C * (c1 * u) ^ 2)) by ring.
    apply Rmult_le_compat; try apply Rabs_pos; [exact Bhu |]. apply (Rle_trans _ _ _ T). apply Rmult_le_compat_l; assumption. }
  unfold psi in E. rewrite !Rmult_1_r, Eb in E.
  replace ((- b a + u + b (a + h * sigma)) / (u * (1 - sigma)) - (1 - u * k2 * sigma / (2 * k ^ 2)))
    with (- (k * r) / u - k2 * ((h + u / k) * (h - u / k)) * (1 + sigma) / (2 * u) - psi1 t / u).
  2: { assert (E' : b (a + h * sigma) = b a - u - k * h - k2 * h ^ 2 * 1 ^ 2 / 2 + k * h * sigma + k2 * h ^ 2 * sigma ^ 2 / 2 - psi1 t * (1 - sigma)) by lra.
       rewrite E'. unfold r. field. repeat split; lra. }
  assert (Bm : Rabs (h - u / k) <= (c1 + / k) * u).
  { apply (Rle_trans _ _ _ (Rabs_triang _ _)). rewrite Rabs_Ropp, (Rabs_pos_eq (u / k)) by (apply Rlt_le, Rdiv_lt_0_compat; lra). unfold Rdiv. lra. }
  set (A1 := - (k * r) / u). set (A2 := k2 * ((h + u / k) * (h - u / k)) * (1 + sigma) / (2 * u)). set (A3 := psi1 t / u).
  assert (Hiu : 0 < / u) by (apply Rinv_0_lt_compat; lra).
  assert (C1 : Rabs A1 <= k * c3 * u ^ 2).
  { unfold A1, Rdiv. rewrite Rabs_mult, Rabs_Ropp, Rabs_mult, (Rabs_pos_eq k), (Rabs_pos_eq (/ u)) by lra.
    replace (k * c3 * u ^ 2) with (k * (c3 * u ^ 3) * / u) by (field; lra).
    apply Rmult_le_compat_r; [lra |]. apply Rmult_le_compat_l; lra. }
  assert (C3 : Rabs A3 <= C * c1 ^ 3 * u ^ 2).
  { unfold A3, Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ u)) by lra.
    replace (C * c1 ^ 3 * u ^ 2) with (C * c1 ^ 3 * u ^ 3 * / u) by (field; lra). apply Rmult_le_compat_r; lra. }
  assert (C2 : Rabs A2 <= Rabs k2 * (c2 * (c1 + / k)) * u ^ 2).
  { replace A2 with (k2 * ((h + u / k) * (h - u / k)) * (/ u * ((1 + sigma) / 2))) by (unfold A2; field; repeat split; lra).
    rewrite !Rabs_mult, (Rabs_pos_eq (/ u)), (Rabs_pos_eq ((1 + sigma) / 2)) by lra.
    replace (Rabs k2 * (c2 * (c1 + / k)) * u ^ 2) with (Rabs k2 * ((c2 * u ^ 2) * ((c1 + / k) * u)) * (/ u * 1)) by (field; split; lra).
    apply Rmult_le_compat.
    - apply Rmult_le_pos; [apply Rabs_pos |]. apply Rmult_le_pos; apply Rabs_pos.
    - apply Rmult_le_pos; lra.
    - apply Rmult_le_compat_l; [apply Rabs_pos |]. apply Rmult_le_compat; try apply Rabs_pos; assumption.
    - apply Rmult_le_compat_l; lra. }
  assert (T1 := Rabs_triang (A1 - A2) (- A3)). assert (T2 := Rabs_triang A1 (- A2)). rewrite Rabs_Ropp in T1, T2.
  unfold Rminus in *. lra.
Qed.
