(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Tactics.
Open Scope R_scope.

(* f(eps) = T(eps) + o(eps^n) as eps -> 0 from above. Printed as f = T + O(eps^(n+1)), an expansion
   says this and more. *)
Definition agrees_through (n : nat) (f T : R -> R) : Prop :=
  forall c, 0 < c -> exists d, 0 < d /\ forall eps, 0 < eps < d -> Rabs (f eps - T eps) <= c * eps ^ n.

(* ---- Taylor's theorem with a remainder of little order ---- *)

Lemma little_1 (G : R -> R) : G 0 = 0 -> is_derive G 0 0 -> agrees_through 1 G (fun _ => 0).
Proof.
  intros H0 HG c Hc. apply is_derive_Reals in HG. destruct (HG c Hc) as [d Hd].
  exists d. split; [apply cond_pos |]. intros u Hu.
  assert (H := Hd u ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra)).
  rewrite Rplus_0_l, H0, !Rminus_0_r in H. unfold Rdiv in H.
  rewrite Rabs_mult, (Rabs_pos_eq (/ u)) in H by (left; apply Rinv_0_lt_compat; lra).
  rewrite Rminus_0_r, pow_1. apply (Rmult_le_reg_r (/ u)); [apply Rinv_0_lt_compat; lra |].
  replace (c * u * / u) with c by (field; lra). lra.
Qed.
Lemma little_S (G G1 : R -> R) n d :
  0 < d -> (forall u, - d < u < d -> is_derive G u (G1 u)) -> G 0 = 0 ->
  agrees_through n G1 (fun _ => 0) -> agrees_through (S n) G (fun _ => 0).
Proof.
  intros Hd HG H0 H1 c Hc. destruct (H1 c Hc) as [e [He H]].
  exists (Rmin d e). split; [apply Rmin_pos; lra |]. intros u Hu.
  assert (Hm1 := Rmin_l d e). assert (Hm2 := Rmin_r d e).
  destruct (MVT_cor2 G G1 0 u ltac:(lra)) as [z [E Hz]].
  - intros z Hz. apply is_derive_Reals, HG. lra.
  - rewrite H0, !Rminus_0_r in E. rewrite Rminus_0_r, E.
    assert (Hb := H z ltac:(lra)). rewrite Rminus_0_r in Hb.
    assert (Hp : z ^ n <= u ^ n) by (apply pow_incr; lra).
    rewrite Rabs_mult, (Rabs_pos_eq u) by lra. simpl.
    assert (Rabs (G1 z) <= c * u ^ n) by nra. nra.
Qed.
Lemma agrees_difference n f T : agrees_through n (fun u => f u - T u) (fun _ => 0) -> agrees_through n f T.
Proof.
  intros H c Hc. destruct (H c Hc) as [d [Hd Hb]]. exists d. split; [exact Hd |].
  intros u Hu. assert (E := Hb u Hu). rewrite Rminus_0_r in E. exact E.
Qed.

Section Taylor.
Variables (f f1 f2 : R -> R) (t0 t1 t2 t3 d : R).
Hypothesis Hd : 0 < d.
Hypothesis H0 : f 0 = t0.

Lemma taylor_1 : is_derive f 0 t1 -> agrees_through 1 f (fun u => t0 + t1 * u).
Proof.
  intros H. apply agrees_difference, little_1.
  - rewrite H0. ring.
  - replace 0 with (t1 - t1) at 2 by ring.
    apply (is_derive_minus f (fun u => t0 + t1 * u) 0 t1 t1 H). auto_derive; [trivial | ring].
Qed.
Hypothesis Hf : forall u, - d < u < d -> is_derive f u (f1 u).
Hypothesis H1 : f1 0 = t1.
Lemma taylor_2 : is_derive f1 0 (2 * t2) -> agrees_through 2 f (fun u => t0 + t1 * u + t2 * u ^ 2).
Proof.
  intros H. apply agrees_difference. apply (little_S _ (fun u => f1 u - (t1 + 2 * t2 * u)) 1 d Hd).
  - intros u Hu. apply (is_derive_minus f (fun u => t0 + t1 * u + t2 * u ^ 2) u (f1 u)); [apply Hf, Hu |].
    auto_derive; [trivial | ring].
  - rewrite H0. ring.
  - apply little_1.
    + rewrite H1. ring.
    + replace 0 with (2 * t2 - 2 * t2) at 2 by ring.
      apply (is_derive_minus f1 (fun u => t1 + 2 * t2 * u) 0 (2 * t2) (2 * t2) H). auto_derive; [trivial | ring].
Qed.
Hypothesis Hf1 : forall u, - d < u < d -> is_derive f1 u (f2 u).
Hypothesis H2 : f2 0 = 2 * t2.
Lemma taylor_3 : is_derive f2 0 (6 * t3) -> agrees_through 3 f (fun u => t0 + t1 * u + t2 * u ^ 2 + t3 * u ^ 3).
Proof.
  intros H. apply agrees_difference.
  apply (little_S _ (fun u => f1 u - (t1 + 2 * t2 * u + 3 * t3 * u ^ 2)) 2 d Hd).
  - intros u Hu. apply (is_derive_minus f (fun u => t0 + t1 * u + t2 * u ^ 2 + t3 * u ^ 3) u (f1 u)); [apply Hf, Hu |].
    auto_derive; [trivial | ring].
  - rewrite H0. ring.
  - apply (little_S _ (fun u => f2 u - (2 * t2 + 6 * t3 * u)) 1 d Hd).
    + intros u Hu. apply (is_derive_minus f1 (fun u => t1 + 2 * t2 * u + 3 * t3 * u ^ 2) u (f2 u)); [apply Hf1, Hu |].
      auto_derive; [trivial | ring].
    + rewrite H1. ring.
    + apply little_1.
      * rewrite H2. ring.
      * replace 0 with (6 * t3 - 6 * t3) at 2 by ring.
        apply (is_derive_minus f2 (fun u => 2 * t2 + 6 * t3 * u) 0 (6 * t3) (6 * t3) H). auto_derive; [trivial | ring].
Qed.
End Taylor.

(* ---- An expansion is unique ---- *)

Lemma agrees_ext n f T Q : agrees_through n f T -> (forall u, T u = Q u) -> agrees_through n f Q.
Proof.
  intros H E c Hc. destruct (H c Hc) as [d [Hd Hb]]. exists d. split; [exact Hd |].
  intros u Hu. rewrite <- E. apply Hb, Hu.
Qed.
Lemma agrees_twice n f T Q : agrees_through n f T -> agrees_through n f Q -> agrees_through n (fun u => T u - Q u) (fun _ => 0).
Proof.
  intros HT HQ c Hc. destruct (HT (c / 2) ltac:(lra)) as [d [Hd Hb]]. destruct (HQ (c / 2) ltac:(lra)) as [e [He Hb']].
  exists (Rmin d e). split; [apply Rmin_pos; assumption |]. intros u Hu.
  assert (Hm1 := Rmin_l d e). assert (Hm2 := Rmin_r d e).
  rewrite Rminus_0_r. replace (T u - Q u) with ((f u - Q u) - (f u - T u)) by ring.
  apply (Rle_trans _ _ _ (Rabs_triang _ _)). rewrite Rabs_Ropp.
  assert (H1 := Hb u ltac:(lra)). assert (H2 := Hb' u ltac:(lra)). lra.
Qed.
Lemma divided n (p q : R -> R) : agrees_through (S n) p (fun _ => 0) -> (forall u, p u = u * q u) -> agrees_through n q (fun _ => 0).
Proof.
  intros H E c Hc. destruct (H c Hc) as [d [Hd Hb]]. exists d. split; [exact Hd |].
  intros u Hu. assert (B := Hb u Hu). rewrite E, !Rminus_0_r, Rabs_mult, (Rabs_pos_eq u) in B by lra.
  rewrite Rminus_0_r. simpl in B. apply (Rmult_le_reg_l u); lra.
Qed.
Lemma first_zero n (p : R -> R) t k1 k2 k3 :
  agrees_through n p (fun _ => 0) -> (forall u, p u = t + k1 * u + k2 * u ^ 2 + k3 * u ^ 3) -> t = 0.
Proof.
  intros H E. destruct (Req_dec t 0) as [| Ht]; [assumption | exfalso].
  assert (Ha := Rabs_pos_lt t Ht). set (M := 1 + Rabs k1 + Rabs k2 + Rabs k3).
  assert (HM : 0 < M) by (unfold M; generalize (Rabs_pos k1) (Rabs_pos k2) (Rabs_pos k3); lra).
  destruct (H (Rabs t / 4) ltac:(lra)) as [d [Hd Hb]].
  set (u := Rmin (Rmin (d / 2) (1 / 2)) (Rabs t / 4 / M)).
  assert (Hq : 0 < Rabs t / 4 / M) by (apply Rdiv_lt_0_compat; lra).
  assert (Hu : 0 < u) by (unfold u; repeat apply Rmin_pos; lra).
  assert (Hu1 := Rmin_l (Rmin (d / 2) (1 / 2)) (Rabs t / 4 / M)). assert (Hu2 := Rmin_r (Rmin (d / 2) (1 / 2)) (Rabs t / 4 / M)).
  assert (Hu3 := Rmin_l (d / 2) (1 / 2)). assert (Hu4 := Rmin_r (d / 2) (1 / 2)). fold u in Hu1, Hu2.
  assert (HuM : u * M <= Rabs t / 4).
  { apply (Rmult_le_compat_r M) in Hu2; [| lra]. replace (Rabs t / 4 / M * M) with (Rabs t / 4) in Hu2 by (field; lra). exact Hu2. }
  assert (B := Hb u ltac:(lra)). rewrite Rminus_0_r, E in B.
  assert (Hn : u ^ n <= 1) by (rewrite <- (pow1 n); apply pow_incr; lra).
  assert (Hr : Rabs (k1 * u + k2 * u ^ 2 + k3 * u ^ 3) <= u * M).
  { replace (k1 * u + k2 * u ^ 2 + k3 * u ^ 3) with (u * (k1 + k2 * u + k3 * u ^ 2)) by ring.
    rewrite Rabs_mult, (Rabs_pos_eq u) by lra. apply Rmult_le_compat_l; [lra |].
    apply (Rle_trans _ _ _ (Rabs_triang _ _)). assert (T2 := Rabs_triang k1 (k2 * u)).
    rewrite !Rabs_mult, (Rabs_pos_eq u), (Rabs_pos_eq (u ^ 2)) in * by (try apply pow_le; lra).
    assert (u ^ 2 <= 1) by (rewrite <- (pow1 2); apply pow_incr; lra).
    generalize (Rabs_pos k1) (Rabs_pos k2) (Rabs_pos k3). unfold M. nra. }
  assert (Rabs t <= Rabs (t + k1 * u + k2 * u ^ 2 + k3 * u ^ 3) + Rabs (k1 * u + k2 * u ^ 2 + k3 * u ^ 3)).
  { replace t with ((t + k1 * u + k2 * u ^ 2 + k3 * u ^ 3) - (k1 * u + k2 * u ^ 2 + k3 * u ^ 3)) at 1 by ring.
    apply (Rle_trans _ _ _ (Rabs_triang _ _)). rewrite Rabs_Ropp. lra. }
  assert (0 <= u ^ n) by (apply pow_le; lra). nra.
Qed.

Lemma unique_3 f t0 t1 t2 t3 q0 q1 q2 q3 :
  agrees_through 3 f (fun u => t0 + t1 * u + t2 * u ^ 2 + t3 * u ^ 3) ->
  agrees_through 3 f (fun u => q0 + q1 * u + q2 * u ^ 2 + q3 * u ^ 3) -> t0 = q0 /\ t1 = q1 /\ t2 = q2 /\ t3 = q3.
Proof.
  intros HT HQ. assert (H := agrees_twice _ _ _ _ HT HQ). cbv beta in H.
  assert (E0 : t0 - q0 = 0) by (apply (first_zero _ _ _ (t1 - q1) (t2 - q2) (t3 - q3) H); intros u; ring).
  assert (G1 := divided _ _ (fun u => (t1 - q1) + (t2 - q2) * u + (t3 - q3) * u ^ 2) H ltac:(intros u; cbv beta; replace t0 with q0 by lra; ring)).
  assert (E1 : t1 - q1 = 0) by (apply (first_zero _ _ _ (t2 - q2) (t3 - q3) 0 G1); intros u; ring).
  assert (G2 := divided _ _ (fun u => (t2 - q2) + (t3 - q3) * u) G1 ltac:(intros u; cbv beta; replace t1 with q1 by lra; ring)).
  assert (E2 : t2 - q2 = 0) by (apply (first_zero _ _ _ (t3 - q3) 0 0 G2); intros u; ring).
  assert (G3 := divided _ _ (fun u => t3 - q3) G2 ltac:(intros u; cbv beta; replace t2 with q2 by lra; ring)).
  assert (E3 : t3 - q3 = 0) by (apply (first_zero _ _ _ 0 0 0 G3); intros u; ring).
  lra.
Qed.
Lemma unique_2 f t0 t1 t2 q0 q1 q2 :
  agrees_through 2 f (fun u => t0 + t1 * u + t2 * u ^ 2) ->
  agrees_through 2 f (fun u => q0 + q1 * u + q2 * u ^ 2) -> t0 = q0 /\ t1 = q1 /\ t2 = q2.
Proof.
  intros HT HQ. assert (H := agrees_twice _ _ _ _ HT HQ). cbv beta in H.
  assert (E0 : t0 - q0 = 0) by (apply (first_zero _ _ _ (t1 - q1) (t2 - q2) 0 H); intros u; ring).
  assert (G1 := divided _ _ (fun u => (t1 - q1) + (t2 - q2) * u) H ltac:(intros u; cbv beta; replace t0 with q0 by lra; ring)).
  assert (E1 : t1 - q1 = 0) by (apply (first_zero _ _ _ (t2 - q2) 0 0 G1); intros u; ring).
  assert (G2 := divided _ _ (fun u => t2 - q2) G1 ltac:(intros u; cbv beta; replace t1 with q1 by lra; ring)).
  assert (E2 : t2 - q2 = 0) by (apply (first_zero _ _ _ 0 0 0 G2); intros u; ring).
  lra.
Qed.

(* ---- What the printed expansions are of ---- *)

Lemma small (u k e : R) : 0 < e -> - (e / (1 + Rabs k)) < u < e / (1 + Rabs k) -> - e < u * k < e.
Proof.
  intros He Hu. assert (Hk := Rabs_pos k).
  assert (H : Rabs u * (1 + Rabs k) < e).
  { assert (Ha : Rabs u < e / (1 + Rabs k)) by (apply Rabs_def1; lra).
    apply (Rmult_lt_compat_r (1 + Rabs k)) in Ha; [| lra].
    replace (e / (1 + Rabs k) * (1 + Rabs k)) with e in Ha by (field; lra). exact Ha. }
  assert (Hp := Rabs_pos u). assert (Hb : Rabs (u * k) < e) by (rewrite Rabs_mult; nra).
  apply Rabs_def2 in Hb. lra.
Qed.

Ltac known f s d H := replace (Derive (fun x : R => f x) s) with d by (symmetry; apply is_derive_unique; exact H).

(* P'(a - eps S) / sqrt(1 - eps (X + S)/(2 a)), under the integral of a symmetric contact. *)
Section Integrand.
Variables (P1 P2 P3 : R -> R) (a eta S k : R).
Hypothesis Heta : 0 < eta.
Hypothesis HP1 : forall s, a - eta < s < a + eta -> is_derive P1 s (P2 s).
Hypothesis HP2 : forall s, a - eta < s < a + eta -> is_derive P2 s (P3 s).
Let f u := P1 (a - u * S) / sqrt (1 - u * k).
Let f1 u := - S * P2 (a - u * S) / sqrt (1 - u * k) + k * P1 (a - u * S) / (2 * ((1 - u * k) * sqrt (1 - u * k))).
Let d := Rmin (eta / (1 + Rabs S)) (1 / (1 + Rabs k)).
Lemma near_0 u : - d < u < d -> a - eta < a - u * S < a + eta /\ 0 < 1 - u * k.
Proof.
  intros Hu. assert (Hm1 := Rmin_l (eta / (1 + Rabs S)) (1 / (1 + Rabs k))).
  assert (Hm2 := Rmin_r (eta / (1 + Rabs S)) (1 / (1 + Rabs k))). fold d in Hm1, Hm2.
  assert (H1 := small u S eta Heta ltac:(lra)). assert (H2 := small u k 1 ltac:(lra) ltac:(lra)). lra.
Qed.
Lemma integrand_taylor : agrees_through 2 f (fun u => P1 a + (k * P1 a / 2 - S * P2 a) * u
  + (3 * k ^ 2 * P1 a / 8 - S * k * P2 a / 2 + S ^ 2 * P3 a / 2) * u ^ 2).
Proof.
  assert (Hd : 0 < d).
  { generalize (Rabs_pos S) (Rabs_pos k). intros. apply Rmin_pos; apply Rdiv_lt_0_compat; lra. }
  assert (E0 : forall x, a - 0 * x = a) by (intros; ring). assert (E1 : 1 - 0 * k = 1) by ring.
  apply (taylor_2 f f1 _ _ _ d Hd).
  - unfold f. rewrite E0, E1, sqrt_1. field.
  - intros u Hu. destruct (near_0 u Hu) as [HS Hk]. assert (HdP := HP1 _ HS).
    assert (Hq : 0 < sqrt (1 - u * k)) by (apply sqrt_lt_R0, Hk).
    unfold f, f1. auto_derive; change (a + - (u * S)) with (a - u * S); change (1 + - (u * k)) with (1 - u * k).
    + repeat split; try lra. exists (P2 (a - u * S)). exact HdP.
    + known P1 (a - u * S) (P2 (a - u * S)) HdP.
      set (w := 1 - u * k) in *. assert (E : w = sqrt w * sqrt w) by (symmetry; apply sqrt_sqrt; lra).
      set (q := sqrt w) in *. clearbody q w. subst w. field. lra.
  - unfold f1. rewrite E0, E1, sqrt_1. field.
  - destruct (near_0 0 ltac:(lra)) as [HS Hk]. assert (HdP := HP1 _ HS). assert (HdP2 := HP2 _ HS).
    rewrite E0 in *. 
    unfold f1. auto_derive; change (a + - (0 * S)) with (a - 0 * S); change (1 + - (0 * k)) with (1 - 0 * k); rewrite E0, E1, sqrt_1.
    + repeat split; try lra; eexists; eassumption.
    + known P1 a (P2 a) HdP. known P2 a (P3 a) HdP2. field.
Qed.
End Integrand.

Theorem integrand_through_2 Es g1 a P P1 P2 P3 S X :
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) ->
  agrees_through 2 (fun eps => P1 (a - eps * S) / sqrt (1 - eps * (X + S) / (2 * a)))
    (fun u => P1 a + ((X + S) / (2 * a) * P1 a / 2 - S * P2 a) * u
      + (3 * ((X + S) / (2 * a)) ^ 2 * P1 a / 8 - S * ((X + S) / (2 * a)) * P2 a / 2 + S ^ 2 * P3 a / 2) * u ^ 2).
Proof.
  intros contact. assert (Hw := positive_width _ _ _ _ _ _ _ _ _ _ contact). cbv beta in Hw.
  destruct contact as [eta [He H]].
  assert (T := integrand_taylor P1 P2 P3 a eta S ((X + S) / (2 * a)) He
    ltac:(intros s Hs; apply (H s Hs)) ltac:(intros s Hs; apply (H s Hs))).
  intros c Hc. destruct (T c Hc) as [d [Hd Hb]]. exists d. split; [exact Hd |]. intros u Hu.
  replace (1 - u * (X + S) / (2 * a)) with (1 - u * ((X + S) / (2 * a))) by (field; lra). apply Hb, Hu.
Qed.

Section Inverse.
Variables (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R).
Hypothesis contact : is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2.
Hypothesis left : is_left_edge a b b1 b2 b3 alpha.

Lemma inverse_near e : 0 < e -> exists d, 0 < d /\ forall r, b a - d < r < b a + d ->
  a - e < alpha r < a + e /\ is_derive alpha r (/ b1 (alpha r)).
Proof.
  intros He. destruct left as [inverse [e2 [He2 [_ H3]]]].
  assert (Hca : continuous alpha (b a)).
  { destruct (H3 (b a) ltac:(lra)) as [_ Hd]. exact (continuous_of_derive _ _ _ Hd). }
  assert (Hnear : locally (b a) (fun r => a - e < alpha r < a + e)).
  { apply (Hca (fun y => a - e < y < a + e)). rewrite inverse.
    exists (mkposreal e He). intros y Hy.
    unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
    apply Rabs_def2 in Hy. lra. }
  destruct Hnear as [d Hd]. exists (Rmin d e2). split; [apply Rmin_pos; [apply cond_pos | lra] |].
  intros r Hr. generalize (Rmin_l d e2) (Rmin_r d e2). intros Hm1 Hm2. split.
  - apply Hd. unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl. apply Rabs_def1; lra.
  - apply H3. lra.
Qed.

(* b^-1(b - eps X) - a *)
Theorem inverse_through_3 X : agrees_through 3 (fun eps => alpha ((b a) - eps * X) - a)
  (fun u => 0 + - (X / b1 a) * u + - (X ^ 2 * b2 a / (2 * b1 a ^ 3)) * u ^ 2
    + - (X ^ 3 * (3 * b2 a ^ 2 - b1 a * b3 a) / (6 * b1 a ^ 5)) * u ^ 3).
Proof.
  assert (contact' := contact). destruct contact' as [e1 [He1 H1]]. assert (left' := left). destruct left' as [inverse [e2 [He2 [H2 _]]]].
  destruct (inverse_near (Rmin e1 e2)) as [d0 [Hd0 H]]; [apply Rmin_pos; lra |].
  generalize (Rmin_l e1 e2) (Rmin_r e1 e2). intros Hm1 Hm2.
  set (d := d0 / (1 + Rabs X)). assert (Hd : 0 < d) by (generalize (Rabs_pos X); intros; apply Rdiv_lt_0_compat; lra).
  assert (E0 : b a - 0 * X = b a) by ring.
  assert (N : forall u, - d < u < d -> 0 < b1 (alpha (b a - u * X)) /\ is_derive alpha (b a - u * X) (/ b1 (alpha (b a - u * X))) /\
    is_derive b1 (alpha (b a - u * X)) (b2 (alpha (b a - u * X))) /\ is_derive b2 (alpha (b a - u * X)) (b3 (alpha (b a - u * X)))).
  { intros u Hu. assert (Hs := small u X d0 Hd0 Hu). destruct (H (b a - u * X) ltac:(lra)) as [Ha Hda].
    destruct (H1 (alpha (b a - u * X)) ltac:(lra)) as (_ & _ & _ & _ & _ & Hb1 & _).
    destruct (H2 (alpha (b a - u * X)) ltac:(lra)) as (Hp & Hb2 & _). exact (conj Hp (conj Hda (conj Hb1 Hb2))). }
  apply (taylor_3 _ (fun u => - X / b1 (alpha (b a - u * X))) (fun u => - X ^ 2 * b2 (alpha (b a - u * X)) / b1 (alpha (b a - u * X)) ^ 3) _ _ _ _ d Hd).
  - rewrite E0, inverse. ring.
  - intros u Hu. destruct (N u Hu) as (Hp & Ha & Hb1 & Hb2). auto_derive; change (b a + - (u * X)) with (b a - u * X).
    + exists (/ b1 (alpha (b a - u * X))). exact Ha.
    + known alpha (b a - u * X) (/ b1 (alpha (b a - u * X))) Ha. field. lra.
  - rewrite E0, inverse. field. apply Rgt_not_eq. destruct (N 0 ltac:(lra)) as (Hp & _). rewrite E0, inverse in Hp. exact Hp.
  - intros u Hu. destruct (N u Hu) as (Hp & Ha & Hb1 & Hb2). auto_derive; change (b a + - (u * X)) with (b a - u * X).
    + repeat split; try (eexists; eassumption); lra.
    + known alpha (b a - u * X) (/ b1 (alpha (b a - u * X))) Ha.
      known b1 (alpha (b a - u * X)) (b2 (alpha (b a - u * X))) Hb1. field. lra.
  - rewrite E0, inverse. field. apply Rgt_not_eq. destruct (N 0 ltac:(lra)) as (Hp & _). rewrite E0, inverse in Hp. exact Hp.
  - destruct (N 0 ltac:(lra)) as (Hp & Ha & Hb1 & Hb2). auto_derive; change (b a + - (0 * X)) with (b a - 0 * X).
    + assert (0 < b1 (alpha (b a - 0 * X)) ^ 3) by (apply pow_lt, Hp).
      repeat split; try (eexists; eassumption). apply Rgt_not_eq. assumption.
    + known alpha (b a - 0 * X) (/ b1 (alpha (b a - 0 * X))) Ha.
      known b1 (alpha (b a - 0 * X)) (b2 (alpha (b a - 0 * X))) Hb1.
      known b2 (alpha (b a - 0 * X)) (b3 (alpha (b a - 0 * X))) Hb2.
      rewrite E0, inverse in *. field. lra.
Qed.

(* F(a + (b^-1(b - eps X) - a) sigma), where F = P'/pi *)
Theorem rate_through_2 X sigma : agrees_through 2 (fun eps => P1 (a + (alpha ((b a) - eps * X) - a) * sigma) / PI)
  (fun u => P1 a / PI + - (X * P2 a * sigma / (PI * b1 a)) * u
    + - (X ^ 2 * sigma * (b2 a * P2 a - b1 a * sigma * P3 a) / (2 * PI * b1 a ^ 3)) * u ^ 2).
Proof.
  assert (Hpi := PI_RGT_0).
  assert (contact' := contact). destruct contact' as [e1 [He1 H1]]. assert (left' := left). destruct left' as [inverse [e2 [He2 [H2 _]]]].
  set (e := Rmin (e1 / (1 + Rabs sigma)) (Rmin e1 e2)).
  assert (He : 0 < e) by (generalize (Rabs_pos sigma); intros; repeat apply Rmin_pos; try lra; apply Rdiv_lt_0_compat; lra).
  destruct (inverse_near e He) as [d0 [Hd0 H]].
  assert (Hm1 := Rmin_l (e1 / (1 + Rabs sigma)) (Rmin e1 e2)). assert (Hm2 := Rmin_r (e1 / (1 + Rabs sigma)) (Rmin e1 e2)).
  fold e in Hm1, Hm2. generalize (Rmin_l e1 e2) (Rmin_r e1 e2). intros Hm3 Hm4.
  set (d := d0 / (1 + Rabs X)). assert (Hd : 0 < d) by (generalize (Rabs_pos X); intros; apply Rdiv_lt_0_compat; lra).
  assert (E0 : b a - 0 * X = b a) by ring.
  assert (N : forall u, - d < u < d -> 0 < b1 (alpha (b a - u * X)) /\ is_derive alpha (b a - u * X) (/ b1 (alpha (b a - u * X))) /\
    is_derive b1 (alpha (b a - u * X)) (b2 (alpha (b a - u * X))) /\
    is_derive P1 (a + (alpha (b a - u * X) - a) * sigma) (P2 (a + (alpha (b a - u * X) - a) * sigma)) /\
    is_derive P2 (a + (alpha (b a - u * X) - a) * sigma) (P3 (a + (alpha (b a - u * X) - a) * sigma))).
  { intros u Hu. assert (Hs := small u X d0 Hd0 Hu). destruct (H (b a - u * X) ltac:(lra)) as [Ha Hda].
    assert (Hss := small (alpha (b a - u * X) - a) sigma e1 He1 ltac:(lra)).
    destruct (H1 (alpha (b a - u * X)) ltac:(lra)) as (_ & _ & _ & _ & _ & Hb1 & _).
    destruct (H1 (a + (alpha (b a - u * X) - a) * sigma) ltac:(lra)) as (_ & HP1 & HP2 & _).
    destruct (H2 (alpha (b a - u * X)) ltac:(lra)) as (Hp & _). exact (conj Hp (conj Hda (conj Hb1 (conj HP1 HP2)))). }
  apply (taylor_2 _ (fun u => - X * sigma * P2 (a + (alpha (b a - u * X) - a) * sigma) / (PI * b1 (alpha (b a - u * X)))) _ _ _ d Hd).
  - rewrite E0, inverse. replace (a + (a - a) * sigma) with a by ring. reflexivity.
  - intros u Hu. destruct (N u Hu) as (Hp & Ha & Hb1 & HP1 & HP2). auto_derive; change (b a + - (u * X)) with (b a - u * X);
      change (alpha (b a - u * X) + - a) with (alpha (b a - u * X) - a).
    + repeat split; eexists; eassumption.
    + known alpha (b a - u * X) (/ b1 (alpha (b a - u * X))) Ha.
      known P1 (a + (alpha (b a - u * X) - a) * sigma) (P2 (a + (alpha (b a - u * X) - a) * sigma)) HP1. field. lra.
  - destruct (N 0 ltac:(lra)) as (Hp & _). rewrite E0, inverse in *. replace (a + (a - a) * sigma) with a by ring. field. lra.
  - destruct (N 0 ltac:(lra)) as (Hp & Ha & Hb1 & HP1 & HP2). auto_derive; change (b a + - (0 * X)) with (b a - 0 * X);
      change (alpha (b a - 0 * X) + - a) with (alpha (b a - 0 * X) - a).
    + repeat split; try (eexists; eassumption). apply Rgt_not_eq, Rmult_lt_0_compat; lra.
    + known alpha (b a - 0 * X) (/ b1 (alpha (b a - 0 * X))) Ha.
      known P2 (a + (alpha (b a - 0 * X) - a) * sigma) (P3 (a + (alpha (b a - 0 * X) - a) * sigma)) HP2.
      known b1 (alpha (b a - 0 * X)) (b2 (alpha (b a - 0 * X))) Hb1.
      rewrite E0, inverse in *. replace (a + (a - a) * sigma) with a by ring. field. lra.
Qed.
End Inverse.

(* What the identities between coefficients divide by. *)
Ltac symmetric_facts contact :=
  let Hw := fresh "Hw" in let Ha := fresh "Ha" in let Hpi := fresh "Hpi" in
  assert (Hw := positive_width _ _ _ _ _ _ _ _ _ _ contact); cbv beta in Hw;
  lazymatch type of Hw with 0 < ?a + ?a => assert (Ha : 0 < a) by lra end;
  assert (Hpi := PI_RGT_0).
Ltac edge_facts contact left :=
  let Hw := fresh "Hw" in let Hb := fresh "Hb" in let Hpi := fresh "Hpi" in
  assert (Hw := positive_width _ _ _ _ _ _ _ _ _ _ contact);
  assert (Hb := rate_positive _ _ _ _ _ _ left); assert (Hpi := PI_RGT_0).
Ltac transitivity_of E := etransitivity; [exact (eq_sym E) |].
