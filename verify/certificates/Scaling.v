(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Unique.
Open Scope R_scope.

(* Similar contacts: the slope h1 is mu times g1 at lengths lam times as large, and the modulus is Fs
   in place of Es. *)
Section Scaling.
Variables (Es Fs : R) (g1 h1 : R -> R) (lam mu : R).
Hypothesis HEs : 0 < Es.
Hypothesis Hlam : 0 < lam.
Hypothesis Hh : forall x, h1 (lam * x) = mu * g1 x.
Let k := Fs / Es * mu.

Lemma place_scaled a b t : place (lam * a) (lam * b) t = lam * place a b t.
Proof. unfold place. field. Qed.
Lemma consistent_scaled a b : consistent g1 a b -> consistent h1 (lam * a) (lam * b).
Proof.
  unfold consistent. intros H. apply (is_RInt_ext (fun t => scal mu (g1 (place a b t)))).
  - intros t _. rewrite place_scaled, Hh. reflexivity.
  - apply (is_RInt_scal (V := R_NormedModule) _ _ _ mu) in H. unfold scal in H at 2; simpl in H.
    unfold mult in H; simpl in H. rewrite Rmult_0_r in H. exact H.
Qed.
Lemma load_scaled a b P : is_load Es g1 a b P -> is_load Fs h1 (lam * a) (lam * b) (k * lam * P).
Proof.
  unfold is_load. intros H.
  apply (is_RInt_ext (fun t => scal (k * lam) (Es / 2 * (place a b t * g1 (place a b t))))).
  - intros t _. rewrite place_scaled, Hh. unfold scal; simpl; unfold mult; simpl. unfold k.
    match goal with |- @eq _ ?x ?y => change (@eq R x y) end. field. lra.
  - exact (is_RInt_scal (V := R_NormedModule) _ _ _ (k * lam) _ H).
Qed.

Lemma contact_scaled P P1 b s : is_contact_at Es g1 P P1 b s ->
  is_contact_at Fs h1 (fun r => k * lam * P (r / lam)) (fun r => k * P1 (r / lam)) (fun r => lam * b (r / lam)) (lam * s).
Proof.
  intros (Hw & Hc & HL & HD). assert (E : lam * s / lam = s) by (field; lra).
  split; [| split; [| split]].
  - rewrite E. replace (lam * s + lam * b s) with (lam * (s + b s)) by ring. apply Rmult_lt_0_compat; assumption.
  - rewrite E. apply consistent_scaled, Hc.
  - assert (C : continuous (fun r => r / lam) (lam * s)).
    { apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. lra. }
    assert (N := C (fun r => is_load Es g1 r (b r) (P r))). cbv beta in N. rewrite E in N. specialize (N HL).
    apply (filter_imp (fun r => is_load Es g1 (r / lam) (b (r / lam)) (P (r / lam)))); [| exact N].
    intros r Hr. apply load_scaled in Hr. replace (lam * (r / lam)) with r in Hr by (field; lra). exact Hr.
  - rewrite E. rewrite <- E in HD.
    replace (k * P1 s) with (k * lam * (/ lam * P1 s)) by (field; lra).
    apply (is_derive_scal (fun r => P (r / lam))).
    assert (HD' : is_derive P (lam * s / lam) (P1 s)) by (rewrite E in HD |- *; exact HD).
    refine (is_derive_comp P (fun r => r / lam) (lam * s) (P1 s) (/ lam) HD' _).
    auto_derive; [exact I | field; lra].
Qed.

Lemma pressure_scaled a x p : x < a -> is_pressure Es g1 a x p -> is_pressure Fs h1 (lam * a) (lam * x) (k * p).
Proof.
  intros Hxa (P & P1 & b & Hp & Ex & Ip).
  exists (fun r => k * lam * P (r / lam)), (fun r => k * P1 (r / lam)), (fun r => lam * b (r / lam)). split.
  - intros s Hs. replace s with (lam * (s / lam)) by (field; lra). apply contact_scaled, Hp.
    split; apply (Rmult_le_reg_l lam); try exact Hlam; replace (lam * (s / lam)) with s by (field; lra); lra.
  - set (f := fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + b s)))) in *.
    set (h := fun s => 1 / PI * (k * P1 (s / lam) / sqrt ((s - lam * x) * (lam * x + lam * b (s / lam))))).
    assert (Hin : forall e, lam * x < e <= lam * a -> x < e / lam <= a).
    { intros e He. split; [apply (Rmult_lt_reg_l lam) | apply (Rmult_le_reg_l lam)]; try exact Hlam;
        replace (lam * (e / lam)) with e by (field; lra); lra. }
    assert (Hfh : forall e, lam * x < e <= lam * a -> is_RInt h e (lam * a) (k * RInt f (e / lam) a)).
    { intros e He. destruct (Hin e He) as [H1 H2].
      assert (If := RInt_correct (V := R_CompleteNormedModule) f (e / lam) a (Ex (e / lam) (conj H1 H2))).
      replace (e / lam) with (/ lam * e + 0) in If at 1 by (field; lra).
      replace a with (/ lam * (lam * a) + 0) in If at 1 by (field; lra).
      apply (is_RInt_comp_lin (V := R_NormedModule) f (/ lam) 0 e (lam * a)) in If.
      apply (is_RInt_scal (V := R_NormedModule) _ _ _ k) in If.
      apply (is_RInt_ext _ h) in If; [exact If |].
      intros s Hs. rewrite Rmin_left in Hs by lra. rewrite Rmax_right in Hs by lra.
      unfold scal; simpl; unfold mult; simpl. unfold f, h.
      replace (/ lam * s + 0) with (s / lam) by (field; lra).
      replace ((s - lam * x) * (lam * x + lam * b (s / lam))) with (lam ^ 2 * ((s / lam - x) * (x + b (s / lam)))) by (field; lra).
      rewrite (sqrt_mult_alt (lam ^ 2)) by (apply pow2_ge_0). rewrite sqrt_pow2 by lra.
      destruct (Hin s ltac:(lra)) as [H3 H4].
      destruct (Hp (s / lam) ltac:(lra)) as (Hw & _).
      match goal with |- @eq _ ?x ?y => change (@eq R x y) end.
      unfold Rdiv. rewrite Rinv_mult. ring. }
    split; [intros e He; exists (k * RInt f (e / lam) a); exact (Hfh e He) |].
    apply (filterlim_ext_loc (fun e => k * RInt f (e / lam) a)).
    + exists (mkposreal (lam * (a - x)) ltac:(apply Rmult_lt_0_compat; lra)). intros e He Hxe.
      unfold ball in He; simpl in He. unfold AbsRing_ball, abs, minus, plus, opp in He; simpl in He.
      apply Rabs_def2 in He. symmetry. apply is_RInt_unique, Hfh. lra.
    + apply (filterlim_comp _ _ _ (fun e => RInt f (e / lam) a) (fun v => k * v) _ (locally p)).
      * apply (filterlim_comp _ _ _ (fun e => e / lam) (fun e => RInt f e a) _ (at_right x)); [| exact Ip].
        intros A [d HA]. exists (mkposreal (lam * d) ltac:(apply Rmult_lt_0_compat; [exact Hlam | apply cond_pos])).
        intros e He Hxe. apply HA.
        -- unfold ball in *; simpl in *. unfold AbsRing_ball, abs, minus, plus, opp in *; simpl in *.
           apply Rabs_def2 in He. destruct He as [He1 He2].
           assert (E : lam * (e / lam + - x) = e + - (lam * x)) by (field; lra).
           apply Rabs_def1; apply (Rmult_lt_reg_l lam); try exact Hlam; rewrite E; lra.
        -- apply (Rmult_lt_reg_l lam); [exact Hlam |]. assert (E : lam * (e / lam) = e) by (field; lra). rewrite E. exact Hxe.
      * exact (filterlim_scal_r (V := R_NormedModule) k p).
Qed.

Lemma right_series_scaled a k0 k1 k2 : right_edge_series Es g1 a k0 k1 k2 ->
  right_edge_series Fs h1 (lam * a) (k / sqrt lam * k0) (k / (lam * sqrt lam) * k1) (k / (lam ^ 2 * sqrt lam) * k2).
Proof.
  intros (K & K1 & d & Hd & HP & HK & <- & <- & HK1).
  assert (Hr : 0 < sqrt lam) by (apply sqrt_lt_R0, Hlam).
  assert (Hin : forall u, - (lam * d) < u < lam * d -> - d < u / lam < d).
  { intros u Hu. split; apply (Rmult_lt_reg_l lam); try exact Hlam; replace (lam * (u / lam)) with u by (field; lra); lra. }
  assert (Z : 0 / lam = 0) by (unfold Rdiv; ring).
  assert (Scaled : forall (f : R -> R) l c u, is_derive f (u / lam) l -> is_derive (fun u => c * f (u / lam)) u (c / lam * l)).
  { intros f l c u H. replace (c / lam * l) with (c * (/ lam * l)) by (field; lra).
    apply (is_derive_scal (fun u => f (u / lam))).
    refine (is_derive_comp f (fun r => r / lam) u l (/ lam) H _). auto_derive; [exact I | field; lra]. }
  exists (fun u => k / sqrt lam * K (u / lam)), (fun u => k / (lam * sqrt lam) * K1 (u / lam)), (lam * d).
  split; [apply Rmult_lt_0_compat; assumption | split; [| split; [| split; [| split]]]].
  - intros u Hu. destruct (Hin u ltac:(lra)) as [_ H2].
    assert (H0 : 0 < u / lam) by (apply Rdiv_lt_0_compat; lra).
    assert (H := pressure_scaled a (a - u / lam) _ ltac:(lra) (HP (u / lam) (conj H0 H2))).
    replace (lam * (a - u / lam)) with (lam * a - u) in H by (field; lra).
    replace (sqrt u * (k / sqrt lam * K (u / lam))) with (k * (sqrt (u / lam) * K (u / lam))); [exact H |].
    rewrite sqrt_div_alt by exact Hlam. field. lra.
  - intros u Hu. replace (k / (lam * sqrt lam)) with (k / sqrt lam / lam) by (field; lra).
    apply Scaled, HK, Hin, Hu.
  - rewrite Z. reflexivity.
  - rewrite Z. reflexivity.
  - match goal with |- is_derive _ _ (2 * (_ * ?k2)) =>
      replace (2 * (k / (lam ^ 2 * sqrt lam) * k2)) with (k / (lam * sqrt lam) / lam * (2 * k2)) by (field; lra) end.
    apply Scaled. rewrite Z. exact HK1.
Qed.
End Scaling.

(* The same for what is the only pressure, and the only coefficients. *)
Section Only.
Variables (Es Fs : R) (g1 h1 : R -> R) (lam mu : R).
Hypothesis HEs : 0 < Es.
Hypothesis HFs : 0 < Fs.
Hypothesis Hlam : 0 < lam.
Hypothesis Hmu : 0 < mu.
Hypothesis Hh : forall x, h1 (lam * x) = mu * g1 x.
Lemma back x : g1 (/ lam * x) = / mu * h1 x.
Proof. replace x with (lam * (/ lam * x)) at 2 by (field; lra). rewrite Hh. field. lra. Qed.

Lemma the_pressure_scaled a x p : x < a ->
  is_the_pressure Es g1 a x p -> is_the_pressure Fs h1 (lam * a) (lam * x) (Fs / Es * mu * p).
Proof.
  intros Hx [H Only]. split; [apply (pressure_scaled Es Fs g1 h1 lam mu); assumption |].
  intros q Hq.
  assert (Hx' : lam * x < lam * a) by (apply Rmult_lt_compat_l; assumption).
  assert (B := pressure_scaled Fs Es h1 g1 (/ lam) (/ mu) HFs (Rinv_0_lt_compat _ Hlam) back _ _ _ Hx' Hq).
  replace (/ lam * (lam * a)) with a in B by (field; lra). replace (/ lam * (lam * x)) with x in B by (field; lra).
  apply Only in B. rewrite <- B. field. lra.
Qed.
Lemma the_right_series_scaled a k0 k1 k2 : is_the_right_series Es g1 a k0 k1 k2 ->
  is_the_right_series Fs h1 (lam * a) (Fs / Es * mu / sqrt lam * k0)
    (Fs / Es * mu / (lam * sqrt lam) * k1) (Fs / Es * mu / (lam ^ 2 * sqrt lam) * k2).
Proof.
  intros [H Only]. assert (Hr : 0 < sqrt lam) by (apply sqrt_lt_R0, Hlam).
  split; [apply (right_series_scaled Es Fs g1 h1 lam mu); assumption |]. intros j0 j1 j2 Hj.
  assert (B := right_series_scaled Fs Es h1 g1 (/ lam) (/ mu) HFs (Rinv_0_lt_compat _ Hlam) back _ _ _ _ Hj).
  replace (/ lam * (lam * a)) with a in B by (field; lra).
  destruct (Only _ _ _ B) as (<- & <- & <-). rewrite sqrt_inv.
  repeat split; field; lra.
Qed.

(* The sums of one, two and three terms, and the first exit: `sum` is within tol p of the pressure p
   up to the distance w from the edge, and not at v. *)
Definition sum_1 (r0 r1 r2 u : R) : R := r0 * sqrt u.
Definition sum_2 (r0 r1 r2 u : R) : R := r0 * sqrt u + r1 * (u * sqrt u).
Definition sum_3 (r0 r1 r2 u : R) : R := r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u).
Definition homogeneous (sum : R -> R -> R -> R -> R) : Prop := forall k l r0 r1 r2 u, 0 < l -> 0 <= u ->
  sum (k / sqrt l * r0) (k / (l * sqrt l) * r1) (k / (l ^ 2 * sqrt l) * r2) (l * u) = k * sum r0 r1 r2 u.
Lemma homogeneous_1 : homogeneous sum_1.
Proof.
  intros k l r0 r1 r2 u Hl Hu. assert (0 < sqrt l) by (apply sqrt_lt_R0, Hl).
  unfold sum_1. rewrite sqrt_mult by lra. field. lra.
Qed.
Lemma homogeneous_2 : homogeneous sum_2.
Proof.
  intros k l r0 r1 r2 u Hl Hu. assert (0 < sqrt l) by (apply sqrt_lt_R0, Hl).
  unfold sum_2. rewrite sqrt_mult by lra. field. lra.
Qed.
Lemma homogeneous_3 : homogeneous sum_3.
Proof.
  intros k l r0 r1 r2 u Hl Hu. assert (0 < sqrt l) by (apply sqrt_lt_R0, Hl).
  unfold sum_3. rewrite sqrt_mult by lra. field. lra.
Qed.
End Only.

Definition is_first_exit (sum : R -> R -> R -> R -> R) (Es : R) (g1 : R -> R) (a tol w v : R) : Prop :=
  exists r0 r1 r2, is_the_right_series Es g1 a r0 r1 r2 /\
  (forall u, 0 < u <= w -> exists p0, is_the_pressure Es g1 a (a - u) p0 /\
    Rabs (p0 - sum r0 r1 r2 u) <= tol * p0) /\
  (forall u, u = v -> exists p0, is_the_pressure Es g1 a (a - u) p0 /\
    tol * p0 < Rabs (p0 - sum r0 r1 r2 u)).

Theorem first_exit_scaled sum Es Fs g1 h1 lam mu a tol w v : homogeneous sum ->
  0 < Es -> 0 < Fs -> 0 < lam -> 0 < mu -> (forall x, h1 (lam * x) = mu * g1 x) -> 0 < v ->
  is_first_exit sum Es g1 a tol w v -> is_first_exit sum Fs h1 (lam * a) tol (lam * w) (lam * v).
Proof.
  intros Hs HEs HFs Hlam Hmu Hh Hv (r0 & r1 & r2 & Hr & Hw & Hx).
  assert (Hk : 0 < Fs / Es * mu) by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat |]; assumption).
  set (k := Fs / Es * mu) in *.
  eexists. eexists. eexists. split; [exact (the_right_series_scaled Es Fs g1 h1 lam mu HEs HFs Hlam Hmu Hh a r0 r1 r2 Hr) |].
  fold k. split.
  - intros u Hu. assert (E : lam * (u / lam) = u) by (field; lra).
    assert (H0 : 0 < u / lam) by (apply Rdiv_lt_0_compat; lra).
    assert (H1 : u / lam <= w) by (apply (Rmult_le_reg_l lam); lra).
    destruct (Hw (u / lam) (conj H0 H1)) as (p & Hp & HR). exists (k * p).
    assert (P := the_pressure_scaled Es Fs g1 h1 lam mu HEs HFs Hlam Hmu Hh a (a - u / lam) p ltac:(lra) Hp).
    replace (lam * (a - u / lam)) with (lam * a - u) in P by (field; lra). split; [exact P |].
    rewrite <- E, Hs by lra. rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_right k) by lra.
    replace (tol * (k * p)) with (k * (tol * p)) by ring. apply Rmult_le_compat_l; lra.
  - intros u ->. destruct (Hx v eq_refl) as (p & Hp & HR). exists (k * p).
    assert (P := the_pressure_scaled Es Fs g1 h1 lam mu HEs HFs Hlam Hmu Hh a (a - v) p ltac:(lra) Hp).
    replace (lam * (a - v)) with (lam * a - lam * v) in P by ring. split; [exact P |].
    rewrite Hs by lra. rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_right k) by lra.
    replace (tol * (k * p)) with (k * (tol * p)) by ring. apply Rmult_lt_compat_l; assumption.
Qed.

(* The relative error of one term, at a place in shares of the contact. *)
Theorem relative_error_scaled Es Fs g1 h1 lam mu a x p r0 r1 r2 : 0 < Es -> 0 < Fs -> 0 < lam -> 0 < mu ->
  (forall x, h1 (lam * x) = mu * g1 x) -> x < a -> p <> 0 ->
  is_the_pressure Es g1 a x p -> is_the_right_series Es g1 a r0 r1 r2 -> exists q s0 s1 s2,
  is_the_pressure Fs h1 (lam * a) (lam * x) q /\ is_the_right_series Fs h1 (lam * a) s0 s1 s2 /\
  s0 * ((lam * a - lam * x) ^ 0 * sqrt (lam * a - lam * x)) / q = r0 * ((a - x) ^ 0 * sqrt (a - x)) / p.
Proof.
  intros HEs HFs Hlam Hmu Hh Hx Hp HP HS. do 4 eexists.
  split; [exact (the_pressure_scaled Es Fs g1 h1 lam mu HEs HFs Hlam Hmu Hh a x p Hx HP) |].
  split; [exact (the_right_series_scaled Es Fs g1 h1 lam mu HEs HFs Hlam Hmu Hh a r0 r1 r2 HS) |].
  replace (lam * a - lam * x) with (lam * (a - x)) by ring. rewrite sqrt_mult by lra.
  assert (0 < sqrt lam) by (apply sqrt_lt_R0, Hlam). simpl. field. repeat split; lra.
Qed.
Theorem figure_scaled Es Fs g1 h1 lam mu a x p r0 r1 r2 figure half : 0 < Es -> 0 < Fs -> 0 < lam -> 0 < mu ->
  (forall x, h1 (lam * x) = mu * g1 x) -> x < a -> figure + half < 1 ->
  is_the_pressure Es g1 a x p -> is_the_right_series Es g1 a r0 r1 r2 ->
  Rabs (Rabs (1 - r0 * ((a - x) ^ 0 * sqrt (a - x)) / p) - figure) < half -> exists q s0 s1 s2,
  is_the_pressure Fs h1 (lam * a) (lam * x) q /\ is_the_right_series Fs h1 (lam * a) s0 s1 s2 /\
  Rabs (Rabs (1 - s0 * ((lam * a - lam * x) ^ 0 * sqrt (lam * a - lam * x)) / q) - figure) < half.
Proof.
  intros HEs HFs Hlam Hmu Hh Hx Hf HP HS H. destruct (Req_dec p 0) as [-> | Hp].
  - exfalso. unfold Rdiv in H. rewrite Rinv_0, Rmult_0_r, Rminus_0_r, Rabs_R1 in H. apply Rabs_def2 in H. lra.
  - destruct (relative_error_scaled Es Fs g1 h1 lam mu a x p r0 r1 r2 HEs HFs Hlam Hmu Hh Hx Hp HP HS) as (q & s0 & s1 & s2 & Hq & Hs & E).
    exists q, s0, s1, s2. split; [exact Hq |]. split; [exact Hs |]. rewrite E. exact H.
Qed.
