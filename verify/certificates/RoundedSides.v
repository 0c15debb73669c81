(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Symmetric Unique Limits.
Open Scope R_scope.

(* Near the edge, the first terms lie above the pressure of flat punches with rounded edges. At a fixed
   place x, the pressure and the sum of the terms are functions of the edge: both vanish if the edge is
   at x, and the sum grows faster. *)

Lemma grows_faster (f T T1 : R -> R) x a p : x < a -> is_improper_integral f x a p ->
  (forall e, x < e -> continuous f e) -> (forall e, x < e -> is_derive T e (T1 e)) ->
  (forall e, x < e <= a -> f e < T1 e) -> filterlim T (at_right x) (locally 0) -> p < T a.
Proof.
  intros Hxa [_ Hp] Hf HT Hlt HT0.
  assert (Ex : forall c d, x < c -> x < d -> ex_RInt f c d).
  { intros c d Hc Hd. apply (@ex_RInt_continuous R_CompleteNormedModule). intros z Hz. apply Hf.
    unfold Rmin in Hz. destruct (Rle_dec c d); lra. }
  set (G := fun e => RInt f e a + T e).
  assert (DG : forall e, x < e -> is_derive G e (opp (f e) + T1 e)).
  { intros e He. apply (is_derive_plus (V := R_NormedModule) (fun e => RInt f e a) T); [| apply HT, He].
    apply (is_derive_RInt' f (fun e => RInt f e a) e a); [| apply Hf, He].
    apply (locally_near e (e - x)); [lra |]. intros y Hy. apply (@RInt_correct R_CompleteNormedModule), Ex; lra. }
  assert (Inc : forall c d, x < c -> c < d -> d <= a -> G c < G d).
  { intros c d Hc Hcd Hd. destruct (MVT_cor2 G (fun e => opp (f e) + T1 e) c d Hcd) as (s & E & Hs).
    - intros s Hs. apply is_derive_Reals, DG. lra.
    - assert (L := Hlt s ltac:(lra)). unfold opp in E; simpl in E. assert (0 < (- f s + T1 s) * (d - c)) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (LG : filterlim G (at_right x) (locally p)).
  { replace p with (plus p 0) by (unfold plus; simpl; ring).
    eapply filterlim_comp_2; [exact Hp | exact HT0 | apply (filterlim_plus (V := R_NormedModule))]. }
  set (m := (x + a) / 2). assert (Hm : x < m < a) by (unfold m; lra).
  assert (Lm : p <= G m).
  { apply (filterlim_le (F := at_right x) G (fun _ => G m) (Finite p) (Finite (G m))); [| exact LG | apply filterlim_const].
    exists (mkposreal (m - x) ltac:(lra)). intros e He Hxe. unfold ball in He; simpl in He. unfold AbsRing_ball, abs, minus, plus, opp in He; simpl in He.
    apply Rabs_def2 in He. apply Rlt_le, Inc; lra. }
  assert (E : G a = T a) by (unfold G; rewrite RInt_point; unfold zero; simpl; ring).
  rewrite <- E. apply Rle_lt_trans with (1 := Lm). apply Inc; lra.
Qed.

Lemma root_above z : 0 <= z <= 1 / 6 -> / sqrt (1 - z) <= 1 + z / 2 + 3 * z ^ 2 / 8 + z ^ 3 / 2.
Proof.
  intros Hz. assert (Hq : 0 < sqrt (1 - z)) by (apply sqrt_lt_R0; lra).
  assert (E : sqrt (1 - z) * sqrt (1 - z) = 1 - z) by (apply sqrt_sqrt; lra).
  set (q := sqrt (1 - z)) in *. clearbody q. set (k := 1 + z / 2 + 3 * z ^ 2 / 8 + z ^ 3 / 2).
  assert (0 <= z ^ 2) by (apply pow_le; lra). assert (0 <= z ^ 3) by (apply pow_le; lra).
  assert (Hk : 1 <= k) by (unfold k; lra).
  assert (H1 : 1 <= (k * q) ^ 2).
  { replace ((k * q) ^ 2) with (k ^ 2 * (q * q)) by ring. rewrite E. unfold k.
    replace ((1 + z / 2 + 3 * z ^ 2 / 8 + z ^ 3 / 2) ^ 2 * (1 - z))
      with (1 + z ^ 3 * (3 / 8 - z * (47 / 64 + 17 / 64 * z + z ^ 2 / 8 + z ^ 3 / 4))) by field.
    assert (z * (47 / 64 + 17 / 64 * z + z ^ 2 / 8 + z ^ 3 / 4) <= 3 / 8) by nra. nra. }
  assert (0 < k * q) by (apply Rmult_lt_0_compat; lra). assert (1 <= k * q) by nra.
  apply (Rmult_le_reg_r q); [exact Hq |]. rewrite Rinv_l by lra. assumption.
Qed.

Section Growth.
Variables (P1 P2 P3 P4 : R -> R) (x : R).
Hypothesis Hx : 0 < x.
Hypothesis D1 : forall s, x <= s -> is_derive P1 s (P2 s).
Hypothesis D2 : forall s, x <= s -> is_derive P2 s (P3 s).
Hypothesis D3 : forall s, x <= s -> is_derive P3 s (P4 s).
Hypothesis Sign : forall s, x <= s -> 0 < P1 s /\ P1 s <= s * P2 s /\ P3 s <= 0 /\ 0 <= P4 s.
Let id := fun s : R => s.
Let k0 := c0 P1 id.
Let k1 := c1 P1 P2 id (fun _ => 1).
Let k2 := c2 P1 P2 P3 id (fun _ => 1) (fun _ => 0).
Let T1 e := k0 e * sqrt (e - x).
Let T2 e := T1 e + k1 e * ((e - x) * sqrt (e - x)).
Let T3 e := T2 e + k2 e * ((e - x) ^ 2 * sqrt (e - x)).
Let f s := 1 / PI * (P1 s / sqrt ((s - x) * (x + s))).
(* The derivatives of the coefficients, with r = sqrt (2 e). *)
Let j0 e r := 2 / PI * (P2 e / r - P1 e / r ^ 3).
Let j1 e r := 2 / PI * (- (2 / 3) * P3 e / r + 3 / 2 * P2 e / r ^ 3 - 5 / 2 * P1 e / r ^ 5).
Let j2 e r := 1 / PI * (8 / 15 * P4 e / r - 26 / 15 * P3 e / r ^ 3 + 23 / 4 * P2 e / r ^ 5 - 43 / 4 * P1 e / r ^ 7).

Ltac known g s d H := replace (Derive (fun x : R => g x) s) with d by (symmetry; apply is_derive_unique; exact H).
Ltac by_root e :=
  let Hr := fresh "Hr" in let E := fresh "E" in
  assert (Hr : 0 < sqrt (e + e)) by (apply sqrt_lt_R0; lra);
  assert (E : e + e = sqrt (e + e) * sqrt (e + e)) by (symmetry; apply sqrt_sqrt; lra);
  set (r := sqrt (e + e)) in *; clearbody r.
Lemma k0_derive e : x <= e -> is_derive k0 e (j0 e (sqrt (e + e))).
Proof.
  intros He. assert (H1 := D1 e He). assert (Hpi := PI_RGT_0). unfold k0, c0, id, j0. auto_derive.
  - repeat split; [eexists; exact H1 | lra |]. apply Rgt_not_eq, Rmult_lt_0_compat; [lra | apply sqrt_lt_R0; lra].
  - known P1 e (P2 e) H1. by_root e. field. lra.
Qed.
Lemma k1_derive e : x <= e -> is_derive k1 e (j1 e (sqrt (e + e))).
Proof.
  intros He. assert (H1 := D1 e He). assert (H2 := D2 e He). assert (Hpi := PI_RGT_0).
  assert (Q := sqrt_lt_R0 (e + e) ltac:(lra)). assert (Q1 := Rmult_lt_0_compat (e + e) (sqrt (e + e)) ltac:(lra) Q). unfold k1, c1, id, j1. auto_derive.
  - repeat split; try (eexists; eassumption); lra.
  - known P1 e (P2 e) H1. known P2 e (P3 e) H2. by_root e. rewrite E. field. lra.
Qed.
Lemma k2_derive e : x <= e -> is_derive k2 e (j2 e (sqrt (e + e))).
Proof.
  intros He. assert (H1 := D1 e He). assert (H2 := D2 e He). assert (H3 := D3 e He). assert (Hpi := PI_RGT_0).
  assert (Q := sqrt_lt_R0 (e + e) ltac:(lra)). assert (Q1 := Rmult_lt_0_compat (e + e) (sqrt (e + e)) ltac:(lra) Q).
  assert (Q2 := Rmult_lt_0_compat (e + e) ((e + e) * sqrt (e + e)) ltac:(lra) Q1). unfold k2, c2, id, j2. auto_derive.
  - repeat split; try (eexists; eassumption); lra.
  - known P1 e (P2 e) H1. known P2 e (P3 e) H2. known P3 e (P4 e) H3. by_root e. rewrite E. field. lra.
Qed.

(* With h = sqrt (e - x), r = sqrt (2 e) and z = h^2 / r^2 <= 1/6. *)
Variable a : R.
Hypothesis Ha : x < a.
Hypothesis Hnear : 3 / 4 * a <= x.
Let h e := sqrt (e - x).
Let h_derive e : x < e -> is_derive h e (/ (2 * h e)).
Proof.
  intros He. assert (H := sqrt_lt_R0 (e - x) ltac:(lra)). unfold h. auto_derive; [lra |]. change (e + - x) with (e - x). field. lra.
Qed.
Let T1' e := j0 e (sqrt (e + e)) * h e + k0 e / (2 * h e).
Let T2' e := T1' e + (j1 e (sqrt (e + e)) * h e ^ 3 + 3 / 2 * k1 e * h e).
Let T3' e := T2' e + (j2 e (sqrt (e + e)) * h e ^ 5 + 5 / 2 * k2 e * h e ^ 3).
Let h_square e : x < e -> 0 < h e /\ h e * h e = e - x.
Proof. intros He. split; [apply sqrt_lt_R0; lra | apply sqrt_sqrt; lra]. Qed.
Let T1_derive e : x < e -> is_derive T1 e (T1' e).
Proof.
  intros He. assert (D := k0_derive e ltac:(lra)). assert (Dh := h_derive e He). destruct (h_square e He) as [H0 _].
  unfold T1, T1'. change (fun e => k0 e * sqrt (e - x)) with (fun e => k0 e * h e).
  replace (j0 e (sqrt (e + e)) * h e + k0 e / (2 * h e)) with (plus (mult (j0 e (sqrt (e + e))) (h e)) (mult (k0 e) (/ (2 * h e))))
    by (unfold plus, mult; simpl; field; lra).
  apply (is_derive_mult k0 h e); [exact D | exact Dh | intros; apply Rmult_comm].
Qed.
Let T2_derive e : x < e -> is_derive T2 e (T2' e).
Proof.
  intros He. assert (D := k1_derive e ltac:(lra)). assert (Dh := h_derive e He). destruct (h_square e He) as [H0 E].
  unfold T2, T2'. apply (is_derive_plus (V := R_NormedModule) T1); [apply T1_derive, He |].
  change (fun e => k1 e * ((e - x) * sqrt (e - x))) with (fun e => k1 e * ((e - x) * h e)).
  replace (j1 e (sqrt (e + e)) * h e ^ 3 + 3 / 2 * k1 e * h e) with
    (plus (mult (j1 e (sqrt (e + e))) ((e - x) * h e)) (mult (k1 e) (plus (mult 1 (h e)) (mult (e - x) (/ (2 * h e))))))
    by (unfold plus, mult; simpl; rewrite <- E; field; lra).
  apply (is_derive_mult k1 (fun e => (e - x) * h e) e); [exact D | | intros; apply Rmult_comm].
  apply (is_derive_mult (fun e => e - x) h e); [auto_derive; [trivial | ring] | exact Dh | intros; apply Rmult_comm].
Qed.
Let T3_derive e : x < e -> is_derive T3 e (T3' e).
Proof.
  intros He. assert (D := k2_derive e ltac:(lra)). assert (Dh := h_derive e He). destruct (h_square e He) as [H0 E].
  unfold T3, T3'. apply (is_derive_plus (V := R_NormedModule) T2); [apply T2_derive, He |].
  change (fun e => k2 e * ((e - x) ^ 2 * sqrt (e - x))) with (fun e => k2 e * ((e - x) ^ 2 * h e)).
  replace (j2 e (sqrt (e + e)) * h e ^ 5 + 5 / 2 * k2 e * h e ^ 3) with
    (plus (mult (j2 e (sqrt (e + e))) ((e - x) ^ 2 * h e)) (mult (k2 e) (plus (mult (2 * (e - x)) (h e)) (mult ((e - x) ^ 2) (/ (2 * h e))))))
    by (unfold plus, mult; simpl; rewrite <- E; field; lra).
  apply (is_derive_mult k2 (fun e => (e - x) ^ 2 * h e) e); [exact D | | intros; apply Rmult_comm].
  apply (is_derive_mult (fun e => (e - x) ^ 2) h e); [auto_derive; [trivial | ring] | exact Dh | intros; apply Rmult_comm].
Qed.

Lemma terms_grow_faster e : x < e <= a -> f e < T1' e /\ f e < T2' e /\ f e < T3' e.
Proof.
  intros He. assert (Hpi := PI_RGT_0). destruct (h_square e ltac:(lra)) as [H0 E]. destruct (Sign e ltac:(lra)) as (S1 & S2 & S3 & S4).
  assert (Hr : 0 < sqrt (e + e)) by (apply sqrt_lt_R0; lra). assert (Er : sqrt (e + e) * sqrt (e + e) = e + e) by (apply sqrt_sqrt; lra).
  set (r := sqrt (e + e)) in *. set (g := h e) in *. set (z := (g / r) ^ 2).
  assert (Ez : z * (r * r) = g * g) by (unfold z; field; lra).
  assert (Hz : 0 < z <= 1 / 6).
  { split; [apply pow_lt, Rdiv_lt_0_compat; lra |]. apply (Rmult_le_reg_r (r * r)); [apply Rmult_lt_0_compat; lra |]. rewrite Ez, E, Er. lra. }
  assert (F : f e = P1 e / (PI * g * r) * / sqrt (1 - z)).
  { unfold f. replace ((e - x) * (x + e)) with ((g * r) ^ 2 * (1 - z)) by (replace ((g * r) ^ 2 * (1 - z)) with (g * g * (r * r - z * (r * r))) by ring; rewrite Ez, E, Er; ring).
    assert (0 < sqrt (1 - z)) by (apply sqrt_lt_R0; lra).
    rewrite sqrt_mult_alt by apply pow2_ge_0. rewrite (sqrt_pow2 (g * r)) by (apply Rlt_le, Rmult_lt_0_compat; lra). field. repeat split; lra. }
  assert (B := root_above z ltac:(lra)). set (A := P1 e / (PI * g * r)) in *. assert (HA : 0 < A) by (apply Rdiv_lt_0_compat; [exact S1 | apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat |]; lra]).
  assert (B' : f e <= A * (1 + z / 2 + 3 * z ^ 2 / 8 + z ^ 3 / 2)) by (rewrite F; apply Rmult_le_compat_l; lra). clear B.
  assert (P2' : 2 * P1 e <= r * r * P2 e) by (rewrite Er; lra).
  assert (X1 : T1' e = A * (1 + z * (2 * (r * r * P2 e / P1 e) - 2))).
  { unfold T1', A, z. fold r g. unfold j0, k0, c0, id. fold r. field. repeat split; lra. }
  assert (X2 : T2' e = A * (1 + z / 2 + z ^ 2 * (3 * (r * r * P2 e / P1 e) - 5 - 4 / 3 * (r ^ 4 * P3 e / P1 e)))).
  { unfold T2'. rewrite X1. fold r g. unfold j1, k1, c1, id. fold r. unfold A, z. rewrite <- Er. field. repeat split; lra. }
  assert (X3 : T3' e = A * (1 + z / 2 + 3 * z ^ 2 / 8 + z ^ 3 * (8 / 15 * (r ^ 6 * P4 e / P1 e) - 26 / 15 * (r ^ 4 * P3 e / P1 e) + 23 / 4 * (r * r * P2 e / P1 e) - 43 / 4))).
  { unfold T3'. rewrite X2. fold r g. unfold j2, k2, c2, id. fold r. unfold A, z. rewrite <- Er. field. repeat split; lra. }
  assert (Y2 : 2 <= r * r * P2 e / P1 e) by (apply (Rmult_le_reg_r (P1 e)); [exact S1 |]; unfold Rdiv; rewrite (Rmult_assoc _ (/ P1 e)), Rinv_l by lra; lra).
  assert (Y3 : r ^ 4 * P3 e / P1 e <= 0).
  { apply (Rmult_le_reg_r (P1 e)); [exact S1 |]. unfold Rdiv. rewrite (Rmult_assoc _ (/ P1 e)), Rinv_l by lra. assert (0 < r ^ 4) by (apply pow_lt; lra). nra. }
  assert (Y4 : 0 <= r ^ 6 * P4 e / P1 e) by (apply Rdiv_le_0_compat; [apply Rmult_le_pos; [apply pow_le; lra | exact S4] | exact S1]).
  set (y2 := r * r * P2 e / P1 e) in *. set (y3 := r ^ 4 * P3 e / P1 e) in *. set (y4 := r ^ 6 * P4 e / P1 e) in *.
  assert (Z2 : 0 < z ^ 2) by (apply pow_lt; lra). assert (Z3 : 0 < z ^ 3) by (apply pow_lt; lra).
  rewrite X1, X2, X3. clear - B' HA Hz Y2 Y3 Y4 Z2 Z3.
  repeat split; apply Rle_lt_trans with (1 := B'); apply Rmult_lt_compat_l; try exact HA; nra.
Qed.

Let f_continuous e : x < e -> continuous f e.
Proof.
  intros He. assert (0 < (e - x) * (x + e)) by (apply Rmult_lt_0_compat; lra). unfold f. apply continuous_times; [apply continuous_const |].
  apply continuous_quotient; [| | apply Rgt_not_eq, sqrt_lt_R0; assumption].
  - apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. apply D1. lra.
  - apply (continuous_comp (fun e => (e - x) * (x + e)) sqrt); [| apply continuous_sqrt].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Let vanishes_at_x (T : R -> R) : continuous T x -> T x = 0 -> filterlim T (at_right x) (locally 0).
Proof. intros C E. unfold continuous in C. rewrite E in C. intros Q HQ. apply filter_le_within. exact (C Q HQ). Qed.
Let term_continuous (k g : R -> R) l : is_derive k x l -> continuous g x -> continuous (fun e => k e * (g e * sqrt (e - x))) x.
Proof.
  intros Hk Hg. apply continuous_times; [apply (@ex_derive_continuous R_AbsRing R_NormedModule); eexists; exact Hk |].
  apply continuous_times; [exact Hg |]. apply (continuous_comp (fun e => e - x) sqrt); [| apply continuous_sqrt].
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Let T1_continuous : continuous T1 x.
Proof.
  apply (continuous_ext (fun e => k0 e * (1 * sqrt (e - x)))); [intros e; unfold T1; match goal with |- @eq _ ?l ?r => change (@eq R l r) end; ring |].
  eapply (term_continuous k0 (fun _ => 1)); [apply k0_derive; lra | apply continuous_const].
Qed.
Let T2_continuous : continuous T2 x.
Proof.
  apply continuous_add; [exact T1_continuous |].
  eapply (term_continuous k1 (fun e => e - x)); [apply k1_derive; lra |].
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Let T3_continuous : continuous T3 x.
Proof.
  apply continuous_add; [exact T2_continuous |].
  eapply (term_continuous k2 (fun e => (e - x) ^ 2)); [apply k2_derive; lra |].
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Let root_0 : sqrt (x - x) = 0. Proof. rewrite Rminus_diag_eq by reflexivity. apply sqrt_0. Qed.
Theorem terms_above p : is_improper_integral f x a p ->
  p < k0 a * sqrt (a - x) /\ p < k0 a * sqrt (a - x) + k1 a * ((a - x) * sqrt (a - x)) /\
  p < k0 a * sqrt (a - x) + k1 a * ((a - x) * sqrt (a - x)) + k2 a * ((a - x) ^ 2 * sqrt (a - x)).
Proof.
  intros Hp. change (p < T1 a /\ p < T2 a /\ p < T3 a). repeat split.
  - apply (grows_faster f T1 T1' x a p Ha Hp f_continuous T1_derive); [intros e He; apply terms_grow_faster, He |].
    apply vanishes_at_x; [exact T1_continuous | unfold T1; rewrite root_0; ring].
  - apply (grows_faster f T2 T2' x a p Ha Hp f_continuous T2_derive); [intros e He; apply terms_grow_faster, He |].
    apply vanishes_at_x; [exact T2_continuous | unfold T2, T1; rewrite root_0; ring].
  - apply (grows_faster f T3 T3' x a p Ha Hp f_continuous T3_derive); [intros e He; apply terms_grow_faster, He |].
    apply vanishes_at_x; [exact T3_continuous | unfold T3, T2, T1; rewrite root_0; ring].
Qed.
End Growth.

(* ---- Flat punches with rounded edges ---- *)

Definition rounded_rate_4 (Es t R0 s : R) : R :=
  Es / R0 * t ^ 3 * (1 / (s ^ 2 * sqrt (s ^ 2 - t ^ 2) ^ 3) + 3 / sqrt (s ^ 2 - t ^ 2) ^ 5).
Lemma rounded_rate_3_derive Es t R0 s : 0 < t < s -> is_derive (rate_3 Es (rounded t R0)) s (rounded_rate_4 Es t R0 s).
Proof.
  intros Hs. assert (Q : 0 < s ^ 2 - t ^ 2) by nra. assert (Hq := sqrt_lt_R0 _ Q).
  assert (E : sqrt (s ^ 2 - t ^ 2) * sqrt (s ^ 2 - t ^ 2) = s ^ 2 - t ^ 2) by (apply sqrt_sqrt; lra).
  set (f := fun s => - (Es / R0 * t ^ 3) * / (s * ((s ^ 2 - t ^ 2) * sqrt (s ^ 2 - t ^ 2)))).
  apply (is_derive_ext f).
  { intros x. unfold f, rate_3, total, rounded, part_rate_3, from, corner, curvature, fold_right, Rdiv. rewrite !Rmult_assoc. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
  assert (0 < (s ^ 2 - t ^ 2) * sqrt (s ^ 2 - t ^ 2)) by (apply Rmult_lt_0_compat; lra).
  assert (0 < s * ((s ^ 2 - t ^ 2) * sqrt (s ^ 2 - t ^ 2))) by (apply Rmult_lt_0_compat; lra).
  unfold f, rounded_rate_4. auto_derive.
  - change (s * (s * 1)) with (s ^ 2). change (t * (t * 1)) with (t ^ 2). change (s ^ 2 + - t ^ 2) with (s ^ 2 - t ^ 2). repeat split; lra.
  - change (s * (s * 1)) with (s ^ 2). change (t * (t * 1)) with (t ^ 2). change (s ^ 2 + - t ^ 2) with (s ^ 2 - t ^ 2).
    set (q := sqrt (s ^ 2 - t ^ 2)) in *. clearbody q. rewrite <- E. generalize (Es / R0). intros K. field. repeat split; lra.
Qed.
Lemma rounded_signs Es t R0 s : 0 < Es -> 0 < R0 -> 0 < t < s ->
  0 < rate Es (rounded t R0) s /\ rate Es (rounded t R0) s <= s * rate_2 Es (rounded t R0) s /\
  rate_3 Es (rounded t R0) s <= 0 /\ 0 <= rounded_rate_4 Es t R0 s.
Proof.
  intros HEs HR Hs. assert (Q : 0 < s ^ 2 - t ^ 2) by nra. assert (Hq := sqrt_lt_R0 _ Q).
  assert (Hk : 0 < Es / R0) by (apply Rdiv_lt_0_compat; lra). assert (Ht3 : 0 < t ^ 3) by (apply pow_lt; lra).
  unfold rate, rate_2, rate_3, rounded_rate_4, total, rounded, part_rate, part_rate_2, part_rate_3, from, corner, curvature, fold_right.
  assert (A : 0 < angle t s) by (unfold angle; generalize (atan_bound (t / sqrt (s ^ 2 - t ^ 2))); lra).
  set (q := sqrt (s ^ 2 - t ^ 2)) in *. set (y := angle t s) in *. set (d := s ^ 2 - t ^ 2) in *. clearbody q y d.
  replace (Es * (0 * s / q + 1 / R0 * s * y) + 0) with (Es / R0 * (s * y)) by (field; lra).
  replace (s * (Es * (- 0 * t ^ 2 / (d * q) + 1 / R0 * (y + t / q)) + 0)) with (Es / R0 * (s * y) + Es / R0 * (s * (t / q))) by (field; lra).
  replace (Es * (3 * 0 * t ^ 2 * s / (d ^ 2 * q) - 1 / R0 * t ^ 3 / (s * d * q)) + 0) with (- (Es / R0 * (t ^ 3 / (s * d * q)))) by (field; repeat split; lra).
  assert (0 < s * y) by (apply Rmult_lt_0_compat; lra). assert (0 < t / q) by (apply Rdiv_lt_0_compat; lra).
  assert (0 < s * (t / q)) by (apply Rmult_lt_0_compat; lra).
  assert (0 < Es / R0 * (s * y)) by (apply Rmult_lt_0_compat; lra). assert (0 < Es / R0 * (s * (t / q))) by (apply Rmult_lt_0_compat; lra).
  assert (0 < t ^ 3 / (s * d * q)) by (apply Rdiv_lt_0_compat; [exact Ht3 | apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat |]; lra]).
  assert (0 < Es / R0 * (t ^ 3 / (s * d * q))) by (apply Rmult_lt_0_compat; lra).
  assert (0 < q ^ 3) by (apply pow_lt; lra). assert (0 < q ^ 5) by (apply pow_lt; lra). assert (0 < s ^ 2) by (apply pow_lt; lra).
  assert (0 < 1 / (s ^ 2 * q ^ 3)) by (apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]).
  assert (0 < 3 / q ^ 5) by (apply Rdiv_lt_0_compat; lra).
  assert (0 < Es / R0 * t ^ 3) by (apply Rmult_lt_0_compat; lra).
  repeat split; try lra. apply Rlt_le, Rmult_lt_0_compat; lra.
Qed.
Theorem rounded_right Es t R0 a : 0 < Es /\ 0 < t < a /\ 0 < R0 -> exists r0 r1 r2,
  is_the_right_series Es (Symmetric.slope (rounded t R0)) a r0 r1 r2 /\
  exists d, 0 < d /\ forall u, 0 < u < d -> exists p0, is_the_pressure Es (Symmetric.slope (rounded t R0)) a (a - u) p0 /\
    (p0 < r0 * sqrt u /\ p0 < r0 * sqrt u + r1 * (u * sqrt u) /\ p0 < r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u)).
Proof.
  intros (HEs & Ht & HR). assert (Hpi := PI_RGT_0). set (m := (t + a) / 2).
  assert (Hk : 0 < Es / R0) by (apply Rdiv_lt_0_compat; lra).
  assert (Hcv : 0 < 1 / R0) by (apply Rdiv_lt_0_compat; lra).
  assert (B : forall s, t < s -> beyond s (rounded t R0)) by (intros s Hs; repeat constructor; simpl; lra).
  assert (Rise : rises_at (Symmetric.slope (rounded t R0)) t).
  { apply (punch_rises (rounded t R0)). split; [repeat constructor; simpl; lra | simpl; lra]. }
  assert (S := right_edge _ _ _ _ _ _ _ _ _ _ (smooth_contact Es (rounded t R0) m a (B m ltac:(unfold m; lra)) ltac:(unfold m; lra))).
  do 3 eexists. split; [apply (the_right_series _ _ t); [exact Rise | lra | exact S] |].
  exists (Rmin (a - m) (a / 4)). split; [apply Rmin_pos; unfold m; lra |]. intros u Hu.
  generalize (Rmin_l (a - m) (a / 4)) (Rmin_r (a - m) (a / 4)). intros M1 M2.
  assert (Hx : t < m < a - u) by (unfold m in *; lra).
  assert (Mix : forall s, a - u <= s -> m < s) by (intros s Hs; lra).
  set (P1 := rate Es (rounded t R0)). set (P2 := rate_2 Es (rounded t R0)). set (P3 := rate_3 Es (rounded t R0)).
  assert (D1 : forall s, m < s -> is_derive P1 s (P2 s)).
  { intros s Hs. apply total_derive, (each _ m (B m ltac:(lra))). intros. apply part_rate_derive. lra. }
  assert (D2 : forall s, m < s -> is_derive P2 s (P3 s)).
  { intros s Hs. apply total_derive, (each _ m (B m ltac:(lra))). intros. apply part_rate_2_derive. lra. }
  assert (I := pressure_by_square P1 (fun s => s) (a - u) a ltac:(lra)
    (fun s Hs => ex_derive_continuous (V := R_NormedModule) P1 s (ex_intro _ _ (D1 s ltac:(lra)))) (fun s _ => continuous_id s) (fun s Hs => ltac:(lra))).
  eexists. split.
  { apply (the_pressure _ _ t); [exact Rise | lra |]. exists (load Es (rounded t R0)), P1, (fun s => s). split; [| exact I].
    intros s Hs. apply (contact_at Es (rounded t R0) m (B m ltac:(lra))). lra. }
  assert (T := fun p Hp => terms_above P1 P2 P3 (rounded_rate_4 Es t R0) (a - u) ltac:(lra) (fun s Hs => D1 s (Mix s Hs)) (fun s Hs => D2 s (Mix s Hs))
    (fun s Hs => rounded_rate_3_derive Es t R0 s ltac:(lra)) (fun s Hs => rounded_signs Es t R0 s HEs HR ltac:(lra)) a ltac:(lra) ltac:(lra) p Hp).
  replace (a - (a - u)) with u in T by ring. exact (T _ I).
Qed.
