(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact.
Open Scope R_scope.

Lemma continuous_2d (F : R -> R -> R) u v :
  continuous (fun z : R * R => F (fst z) (snd z)) (u, v) -> continuity_2d_pt F u v.
Proof. intros H. apply continuity_2d_pt_filterlim. exact H. Qed.

Lemma is_derive_under_integral (F F1 : R -> R -> R) (d : R) :
  0 < d ->
  (forall u v, - d < u < d -> -1 < v < 2 -> is_derive (fun z => F z v) u (F1 u v)) ->
  (forall u v, - d < u < d -> -1 < v < 2 -> continuous (fun z : R * R => F1 (fst z) (snd z)) (u, v)) ->
  (forall u v, - d < u < d -> -1 < v < 2 -> continuous (F u) v) ->
  forall u, - d < u < d -> is_derive (fun u => RInt (F u) 0 1) u (RInt (F1 u) 0 1).
Proof.
  intros Hd HD HC HF u Hu.
  assert (Hu' : exists e : posreal, forall w, ball u e w -> - d < w < d).
  { exists (mkposreal (Rmin (u + d) (d - u)) ltac:(apply Rmin_pos; lra)). intros w Hw.
    unfold ball in Hw; simpl in Hw. unfold AbsRing_ball, abs, minus, plus, opp in Hw; simpl in Hw.
    apply Rabs_def2 in Hw. generalize (Rmin_l (u + d) (d - u)) (Rmin_r (u + d) (d - u)). lra. }
  replace (RInt (F1 u) 0 1) with (RInt (fun t => Derive (fun z => F z t) u) 0 1).
  - apply (is_derive_RInt_param F 0 1 u).
    + destruct Hu' as [e He]. exists e. intros w Hw t Ht.
      rewrite Rmin_left in Ht by lra. rewrite Rmax_right in Ht by lra.
      exists (F1 w t). apply HD; [apply He, Hw | lra].
    + intros t Ht. rewrite Rmin_left in Ht by lra. rewrite Rmax_right in Ht by lra.
      apply (continuity_2d_pt_ext_loc F1).
      * destruct Hu' as [e He].
        exists (mkposreal (Rmin e 1) ltac:(apply Rmin_pos; [apply cond_pos | lra])). simpl.
        intros w z Hw Hz. symmetry. apply is_derive_unique. apply HD.
        -- apply He. unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl.
           eapply Rlt_le_trans; [exact Hw | apply Rmin_l].
        -- assert (Hz' : Rabs (z - t) < 1) by (eapply Rlt_le_trans; [exact Hz | apply Rmin_r]).
           apply Rabs_def2 in Hz'. lra.
      * apply continuous_2d. apply HC; lra.
    + destruct Hu' as [e He]. exists e. intros w Hw.
      apply (@ex_RInt_continuous R_CompleteNormedModule). intros z Hz.
      rewrite Rmin_left in Hz by lra. rewrite Rmax_right in Hz by lra.
      apply HF; [apply He, Hw | lra].
  - apply RInt_ext. intros t Ht. rewrite Rmin_left in Ht by lra. rewrite Rmax_right in Ht by lra.
    apply is_derive_unique. apply HD; lra.
Qed.

Lemma continuous_times {U : UniformSpace} (f g : U -> R) z :
  continuous f z -> continuous g z -> continuous (fun z => f z * g z) z.
Proof. exact (continuous_mult f g z). Qed.
Lemma continuous_add {U : UniformSpace} (f g : U -> R) z :
  continuous f z -> continuous g z -> continuous (fun z => f z + g z) z.
Proof. exact (continuous_plus f g z). Qed.
Lemma continuous_sub {U : UniformSpace} (f g : U -> R) z :
  continuous f z -> continuous g z -> continuous (fun z => f z - g z) z.
Proof. exact (continuous_minus f g z). Qed.
Lemma continuous_quotient {U : UniformSpace} (f g : U -> R) z :
  continuous f z -> continuous g z -> g z <> 0 -> continuous (fun z => f z / g z) z.
Proof.
  intros Hf Hg H0. apply (continuous_times f (fun z => / g z)). { exact Hf. }
  apply (continuous_comp g Rinv); [exact Hg | apply continuous_Rinv, H0].
Qed.
Lemma continuous_square {U : UniformSpace} (f : U -> R) z : continuous f z -> continuous (fun z => f z ^ 2) z.
Proof.
  intros H. apply (continuous_comp f (fun x => x ^ 2)). { exact H. }
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.

Section Series.
Variables (P1 P2 P3 b b1 b2 : R -> R) (a eta : R).
Hypothesis Heta : 0 < eta.
Let near s := a - eta < s < a + eta.
Hypothesis HP1 : forall s, near s -> is_derive P1 s (P2 s).
Hypothesis HP2 : forall s, near s -> is_derive P2 s (P3 s).
Hypothesis HP3 : forall s, near s -> continuous P3 s.
Hypothesis Hb : forall s, near s -> is_derive b s (b1 s).
Hypothesis Hb1 : forall s, near s -> is_derive b1 s (b2 s).
Hypothesis Hb2 : forall s, near s -> continuous b2 s.
Hypothesis Hwidth : forall u s, - eta < u < eta -> near s -> 0 < a - u + b s.

Let S u v := a - u * (1 - v ^ 2).
Let W u v := a - u + b (S u v).
Let F u v := P1 (S u v) / sqrt (W u v).
Let F1 u v := - (1 - v ^ 2) * P2 (S u v) / sqrt (W u v)
  + P1 (S u v) * (1 + (1 - v ^ 2) * b1 (S u v)) / (2 * (W u v * sqrt (W u v))).
Let F2 u v := (1 - v ^ 2) ^ 2 * P3 (S u v) / sqrt (W u v)
  - (1 - v ^ 2) * P2 (S u v) * (1 + (1 - v ^ 2) * b1 (S u v)) / (W u v * sqrt (W u v))
  - P1 (S u v) * (1 - v ^ 2) ^ 2 * b2 (S u v) / (2 * (W u v * sqrt (W u v)))
  + 3 * P1 (S u v) * (1 + (1 - v ^ 2) * b1 (S u v)) ^ 2 / (4 * (W u v ^ 2 * sqrt (W u v))).

Lemma S_near u v : - (eta / 4) < u < eta / 4 -> -1 < v < 2 -> near (S u v).
Proof.
  intros Hu Hv. unfold near, S.
  assert (-3 < 1 - v ^ 2 <= 1) by nra. split; nra.
Qed.
Lemma W_pos u v : - (eta / 4) < u < eta / 4 -> -1 < v < 2 -> 0 < W u v.
Proof. intros Hu Hv. apply Hwidth; [lra | apply S_near; assumption]. Qed.


Ltac known f s d H := replace (Derive (fun x : R => f x) s) with d by (symmetry; apply is_derive_unique; exact H).

Lemma F_derive u v : - (eta / 4) < u < eta / 4 -> -1 < v < 2 -> is_derive (fun z => F z v) u (F1 u v).
Proof.
  intros Hu Hv. assert (HS := S_near u v Hu Hv). assert (HW := W_pos u v Hu Hv).
  assert (Hq : 0 < sqrt (W u v)) by (apply sqrt_lt_R0, HW).
  assert (HdP := HP1 _ HS). assert (Hdb := Hb _ HS).
  unfold F, F1. unfold W, S in *. auto_derive.
  - repeat split.
    + exists (P2 (a - u * (1 - v ^ 2))). exact HdP.
    + exists (b1 (a - u * (1 - v ^ 2))). exact Hdb.
    + exact HW.
    + apply Rgt_not_eq. exact Hq.
  - change (a + - (u * (1 - v * (v * 1)))) with (a - u * (1 - v ^ 2)).
    set (s := a - u * (1 - v ^ 2)) in *. known P1 s (P2 s) HdP. known b s (b1 s) Hdb. change (a + - u + b s) with (a - u + b s).
    set (w := a - u + b s) in *. assert (E : w = sqrt w * sqrt w) by (symmetry; apply sqrt_sqrt; lra).
    set (q := sqrt w) in *. clearbody q w. subst w. field. lra.
Qed.

Lemma F1_derive u v : - (eta / 4) < u < eta / 4 -> -1 < v < 2 -> is_derive (fun z => F1 z v) u (F2 u v).
Proof.
  intros Hu Hv. assert (HS := S_near u v Hu Hv). assert (HW := W_pos u v Hu Hv).
  assert (Hq : 0 < sqrt (W u v)) by (apply sqrt_lt_R0, HW).
  assert (HdP := HP1 _ HS). assert (Hdb := Hb _ HS).
  assert (HdP2 := HP2 _ HS). assert (Hdb1 := Hb1 _ HS).
  unfold F1, F2. unfold W, S in *. auto_derive.
  - repeat split.
    + exists (P3 (a - u * (1 - v ^ 2))). exact HdP2.
    + exists (b1 (a - u * (1 - v ^ 2))). exact Hdb.
    + exact HW.
    + apply Rgt_not_eq. exact Hq.
    + exists (P2 (a - u * (1 - v ^ 2))). exact HdP.
    + exists (b2 (a - u * (1 - v ^ 2))). exact Hdb1.
    + exists (b1 (a - u * (1 - v ^ 2))). exact Hdb.
    + exists (b1 (a - u * (1 - v ^ 2))). exact Hdb.
    + exact HW.
    + apply Rgt_not_eq. apply Rmult_lt_0_compat; [lra |]. apply Rmult_lt_0_compat; [exact HW | exact Hq].
  - change (a + - (u * (1 - v * (v * 1)))) with (a - u * (1 - v ^ 2)).
    set (s := a - u * (1 - v ^ 2)) in *.
    known P1 s (P2 s) HdP. known P2 s (P3 s) HdP2. known b s (b1 s) Hdb. known b1 s (b2 s) Hdb1. change (a + - u + b s) with (a - u + b s).
    set (w := a - u + b s) in *. assert (E : w = sqrt w * sqrt w) by (symmetry; apply sqrt_sqrt; lra).
    set (q := sqrt w) in *. clearbody q w. subst w. field. lra.
Qed.

Let at_pair (u v : R) : R * R := (u, v).

Lemma S_continuous u v : continuous (fun z : R * R => S (fst z) (snd z)) (u, v).
Proof.
  unfold S.
  apply (continuous_minus (fun _ => a) (fun z : R * R => fst z * (1 - snd z ^ 2))). { apply continuous_const. }
  apply (continuous_mult (fun z : R * R => fst z) (fun z => 1 - snd z ^ 2)). { apply continuous_fst. }
  apply (continuous_comp (fun z : R * R => snd z) (fun v => 1 - v ^ 2)). { apply continuous_snd. }
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma y_continuous u v : continuous (fun z : R * R => 1 - snd z ^ 2) (u, v).
Proof.
  apply (continuous_comp (fun z : R * R => snd z) (fun v => 1 - v ^ 2)). { apply continuous_snd. }
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma of_S_continuous (f : R -> R) u v : continuous f (S u v) -> continuous (fun z : R * R => f (S (fst z) (snd z))) (u, v).
Proof. intros H. apply (continuous_comp (fun z : R * R => S (fst z) (snd z)) f); [apply S_continuous | exact H]. Qed.
Lemma W_continuous u v : - (eta / 4) < u < eta / 4 -> -1 < v < 2 -> continuous (fun z : R * R => W (fst z) (snd z)) (u, v).
Proof.
  intros Hu Hv. unfold W.
  apply (continuous_plus (fun z : R * R => a - fst z) (fun z => b (S (fst z) (snd z)))).
  - apply (continuous_minus (fun _ : R * R => a) (fun z => fst z)); [apply continuous_const | apply continuous_fst].
  - apply of_S_continuous. apply (@ex_derive_continuous R_AbsRing R_NormedModule).
    exists (b1 (S u v)). apply Hb, S_near; assumption.
Qed.
Lemma root_continuous u v : - (eta / 4) < u < eta / 4 -> -1 < v < 2 ->
  continuous (fun z : R * R => sqrt (W (fst z) (snd z))) (u, v).
Proof.
  intros Hu Hv. apply (continuous_comp (fun z : R * R => W (fst z) (snd z)) sqrt).
  - apply W_continuous; assumption.
  - apply continuous_sqrt.
Qed.

Ltac joint := repeat match goal with
  | |- continuous (fun z => P1 (S (fst z) (snd z))) _ =>
      apply of_S_continuous, (@ex_derive_continuous R_AbsRing R_NormedModule); eexists; apply HP1, S_near; assumption
  | |- continuous (fun z => P2 (S (fst z) (snd z))) _ =>
      apply of_S_continuous, (@ex_derive_continuous R_AbsRing R_NormedModule); eexists; apply HP2, S_near; assumption
  | |- continuous (fun z => P3 (S (fst z) (snd z))) _ => apply of_S_continuous, HP3, S_near; assumption
  | |- continuous (fun z => b1 (S (fst z) (snd z))) _ =>
      apply of_S_continuous, (@ex_derive_continuous R_AbsRing R_NormedModule); eexists; apply Hb1, S_near; assumption
  | |- continuous (fun z => b2 (S (fst z) (snd z))) _ => apply of_S_continuous, Hb2, S_near; assumption
  | |- continuous (fun z => sqrt (W (fst z) (snd z))) _ => apply root_continuous; assumption
  | |- continuous (fun z => W (fst z) (snd z)) _ => apply W_continuous; assumption
  | |- continuous (fun z => 1 - snd z ^ 2) _ => apply y_continuous
  | |- continuous (fun z => @?f z / @?g z) _ => apply (continuous_quotient f g)
  | |- continuous (fun z => @?f z * @?g z) _ => apply (continuous_times f g)
  | |- continuous (fun z => @?f z + @?g z) _ => apply (continuous_add f g)
  | |- continuous (fun z => @?f z - @?g z) _ => apply (continuous_sub f g)
  | |- continuous (fun z => - @?f z) _ => apply (continuous_opp f)
  | |- continuous (fun z => @?f z ^ 2) _ => apply (continuous_square f)
  | |- continuous _ _ => apply continuous_const
  end.

Lemma F_continuous u v : - (eta / 4) < u < eta / 4 -> -1 < v < 2 -> continuous (fun z : R * R => F (fst z) (snd z)) (u, v).
Proof.
  intros Hu Hv. assert (HW := W_pos u v Hu Hv). assert (Hq : 0 < sqrt (W u v)) by (apply sqrt_lt_R0, HW).
  unfold F. joint. simpl. lra.
Qed.
Lemma F1_continuous u v : - (eta / 4) < u < eta / 4 -> -1 < v < 2 -> continuous (fun z : R * R => F1 (fst z) (snd z)) (u, v).
Proof.
  intros Hu Hv. assert (HW := W_pos u v Hu Hv). assert (Hq : 0 < sqrt (W u v)) by (apply sqrt_lt_R0, HW).
  assert (HWq := Rmult_lt_0_compat _ _ HW Hq).
  unfold F1. joint; simpl; lra.
Qed.
Lemma F2_continuous u v : - (eta / 4) < u < eta / 4 -> -1 < v < 2 -> continuous (fun z : R * R => F2 (fst z) (snd z)) (u, v).
Proof.
  intros Hu Hv. assert (HW := W_pos u v Hu Hv). assert (Hq : 0 < sqrt (W u v)) by (apply sqrt_lt_R0, HW).
  assert (HWq := Rmult_lt_0_compat _ _ HW Hq).
  assert (HWWq := Rmult_lt_0_compat _ _ HW HWq).
  unfold F2. joint; simpl; try lra.
Qed.
Lemma slice (G : R -> R -> R) u v :
  continuous (fun z : R * R => G (fst z) (snd z)) (u, v) -> continuous (G u) v.
Proof.
  intros H. apply (continuous_comp_2 (fun _ : R => u) (fun v => v) G v).
  - apply continuous_const.
  - apply continuous_id.
  - exact H.
Qed.

Definition edge_series u := 2 / PI * RInt (F u) 0 1.
Definition edge_series_1 u := 2 / PI * RInt (F1 u) 0 1.

Lemma edge_series_derive u : - (eta / 4) < u < eta / 4 -> is_derive edge_series u (edge_series_1 u).
Proof.
  intros Hu. unfold edge_series, edge_series_1.
  apply (is_derive_scal (fun u => RInt (F u) 0 1) u (2 / PI)).
  apply (is_derive_under_integral F F1 (eta / 4)); try lra.
  - exact F_derive.
  - exact F1_continuous.
  - intros w v Hw Hv. apply slice, F_continuous; assumption.
Qed.
Lemma edge_series_1_derive u : - (eta / 4) < u < eta / 4 ->
  is_derive edge_series_1 u (2 / PI * RInt (F2 u) 0 1).
Proof.
  intros Hu. unfold edge_series_1.
  apply (is_derive_scal (fun u => RInt (F1 u) 0 1) u (2 / PI)).
  apply (is_derive_under_integral F1 F2 (eta / 4)); try lra.
  - exact F1_derive.
  - exact F2_continuous.
  - intros w v Hw Hv. apply slice, F1_continuous; assumption.
Qed.

(* The coefficients of u^(1/2), u^(3/2), u^(5/2). *)
Definition c0 := 2 * P1 a / (PI * sqrt (a + b a)).
Definition c1 := 2 / PI * (- (2 / 3) * P2 a / sqrt (a + b a)
  + P1 a * (1 / 2 + b1 a / 3) / ((a + b a) * sqrt (a + b a))).
Definition c2 := 1 / PI * (8 / 15 * P3 a / sqrt (a + b a)
  - (2 / 3 + 8 / 15 * b1 a) * P2 a / ((a + b a) * sqrt (a + b a))
  - 4 / 15 * b2 a * P1 a / ((a + b a) * sqrt (a + b a))
  + 3 / 4 * P1 a * (1 + 4 / 3 * b1 a + 8 / 15 * b1 a ^ 2) / ((a + b a) ^ 2 * sqrt (a + b a))).

Lemma S_0 v : S 0 v = a. Proof. unfold S. ring. Qed.
Lemma W_0 v : W 0 v = a + b a. Proof. unfold W. rewrite S_0. ring. Qed.

Ltac polynomial := match goal with |- RInt _ 0 1 = _ => idtac end.

Lemma at_edge_0 : edge_series 0 = c0.
Proof.
  assert (HW := W_pos 0 0 ltac:(lra) ltac:(lra)). rewrite W_0 in HW.
  assert (Hq : 0 < sqrt (a + b a)) by (apply sqrt_lt_R0, HW). assert (Hpi := PI_RGT_0).
  unfold edge_series, c0.
  rewrite (is_RInt_unique _ _ _ (P1 a / sqrt (a + b a) * 1 - P1 a / sqrt (a + b a) * 0)). { field. lra. }
  apply (is_RInt_antiderivative _ (fun _ => P1 a / sqrt (a + b a)) (fun v => P1 a / sqrt (a + b a) * v)); try lra.
  - intros v Hv. unfold F. rewrite S_0, W_0. reflexivity.
  - intros v Hv. auto_derive; [trivial | ring].
  - intros v Hv. apply continuous_const.
Qed.
Lemma at_edge_1 : edge_series_1 0 = c1.
Proof.
  assert (HW := W_pos 0 0 ltac:(lra) ltac:(lra)). rewrite W_0 in HW.
  assert (Hq : 0 < sqrt (a + b a)) by (apply sqrt_lt_R0, HW). assert (Hpi := PI_RGT_0).
  unfold edge_series_1, c1.
  set (A := - P2 a / sqrt (a + b a)). set (B := P1 a / (2 * ((a + b a) * sqrt (a + b a)))).
  set (H := fun v => A * (v - v ^ 3 / 3) + B * (v + b1 a * (v - v ^ 3 / 3))).
  rewrite (is_RInt_unique _ _ _ (H 1 - H 0)). { unfold H, A, B. field. lra. }
  apply (is_RInt_antiderivative _ (fun v => A * (1 - v ^ 2) + B * (1 + (1 - v ^ 2) * b1 a))); try lra.
  - intros v Hv. unfold F1, A, B. rewrite S_0, W_0. field. lra.
  - intros v Hv. unfold H. auto_derive; [trivial | field].
  - intros v Hv. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma at_edge_2 : 2 / PI * RInt (F2 0) 0 1 = 2 * c2.
Proof.
  assert (HW := W_pos 0 0 ltac:(lra) ltac:(lra)). rewrite W_0 in HW.
  assert (Hq : 0 < sqrt (a + b a)) by (apply sqrt_lt_R0, HW). assert (Hpi := PI_RGT_0).
  unfold c2.
  set (A := P3 a / sqrt (a + b a)). set (B := - P2 a / ((a + b a) * sqrt (a + b a))).
  set (C := - P1 a * b2 a / (2 * ((a + b a) * sqrt (a + b a)))).
  set (D := 3 * P1 a / (4 * ((a + b a) ^ 2 * sqrt (a + b a)))).
  set (Y1 := fun v => v - v ^ 3 / 3). set (Y2 := fun v => v - 2 * v ^ 3 / 3 + v ^ 5 / 5).
  set (H := fun v => (A + C) * Y2 v + B * (Y1 v + b1 a * Y2 v) + D * (v + 2 * b1 a * Y1 v + b1 a ^ 2 * Y2 v)).
  rewrite (is_RInt_unique _ _ _ (H 1 - H 0)). { unfold H, Y1, Y2, A, B, C, D. field. lra. }
  apply (is_RInt_antiderivative _ (fun v => (A + C) * (1 - v ^ 2) ^ 2
    + B * ((1 - v ^ 2) + b1 a * (1 - v ^ 2) ^ 2) + D * (1 + (1 - v ^ 2) * b1 a) ^ 2)); try lra.
  - intros v Hv. unfold F2, A, B, C, D. rewrite S_0, W_0. field. lra.
  - intros v Hv. unfold H, Y1, Y2. auto_derive; [trivial | field].
  - intros v Hv. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.

Lemma near_edge u : 0 < u < eta / 4 ->
  RInt (fun w => 2 / PI * (P1 (a - u + w ^ 2) / sqrt (a - u + b (a - u + w ^ 2)))) 0 (sqrt (a - (a - u)))
  = sqrt u * edge_series u.
Proof.
  intros Hu. replace (a - (a - u)) with u by ring.
  assert (Hr : 0 < sqrt u) by (apply sqrt_lt_R0; lra).
  assert (Hrr : sqrt u ^ 2 = u) by (apply pow2_sqrt; lra).
  unfold edge_series.
  set (f := fun w => P1 (a - u + w ^ 2) / sqrt (a - u + b (a - u + w ^ 2))).
  assert (Hf : forall v, 0 <= v <= 1 -> f (sqrt u * v) = F u v).
  { intros v Hv. unfold f, F, W, S. replace (a - u + (sqrt u * v) ^ 2) with (a - u * (1 - v ^ 2)).
    - reflexivity.
    - rewrite Rpow_mult_distr, Hrr. ring. }
  assert (HF : is_RInt (F u) 0 1 (RInt (F u) 0 1)).
  { apply (@RInt_correct R_CompleteNormedModule), (@ex_RInt_continuous R_CompleteNormedModule).
    intros v Hv. rewrite Rmin_left in Hv by lra. rewrite Rmax_right in Hv by lra.
    apply slice, F_continuous; lra. }
  assert (Hback : is_RInt f 0 (sqrt u) (sqrt u * RInt (F u) 0 1)).
  { apply (is_RInt_ext (fun w => sqrt u * (/ sqrt u * F u (/ sqrt u * w + 0)))).
    - intros w Hw. rewrite Rmin_left in Hw by lra. rewrite Rmax_right in Hw by lra.
      match goal with |- @eq _ ?x ?y => change (@eq R x y) end.
      rewrite <- (Hf (/ sqrt u * w + 0)).
      + replace (sqrt u * (/ sqrt u * w + 0)) with w by (field; lra). field. lra.
      + assert (0 < / sqrt u) by (apply Rinv_0_lt_compat, Hr). split; [nra |].
        apply (Rmult_le_reg_l (sqrt u)); [exact Hr |].
        replace (sqrt u * (/ sqrt u * w + 0)) with w by (field; lra). lra.
    - apply (is_RInt_scal (fun w => / sqrt u * F u (/ sqrt u * w + 0)) 0 (sqrt u) (sqrt u)).
      apply (is_RInt_comp_lin (F u) (/ sqrt u) 0 0 (sqrt u)).
      replace (/ sqrt u * 0 + 0) with 0 by ring. replace (/ sqrt u * sqrt u + 0) with 1 by (field; lra).
      exact HF. }
  rewrite (is_RInt_unique _ _ _ (2 / PI * (sqrt u * RInt (F u) 0 1))).
  { match goal with |- @eq _ ?x ?y => change (@eq R x y) end. ring. }
  exact (is_RInt_scal f 0 (sqrt u) (2 / PI) _ Hback).
Qed.
End Series.
