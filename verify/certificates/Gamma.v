(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients.
Open Scope R_scope.

(* The gamma function by the theorem of Bohr and Mollerup: it is the only function of a positive
   number with these properties. gamma_exists proves that there is one. *)
Definition is_gamma (G : R -> R) : Prop :=
  G 1 = 1 /\
  (forall x, 0 < x -> 0 < G x /\ G (x + 1) = x * G x) /\
  (forall x y l, 0 < x -> 0 < y -> 0 <= l <= 1 -> ln (G (l * x + (1 - l) * y)) <= l * ln (G x) + (1 - l) * ln (G y)).

(* ---- x^p, continued by 0 to the left of 0 ---- *)

Definition power (p x : R) : R := if Rlt_dec 0 x then Rpower x p else 0.
Lemma power_of_positive p x : 0 < x -> power p x = Rpower x p.
Proof. intros H. unfold power. destruct (Rlt_dec 0 x); [reflexivity | contradiction]. Qed.
Lemma power_of_negative p x : x <= 0 -> power p x = 0.
Proof. intros H. unfold power. destruct (Rlt_dec 0 x); [lra | reflexivity]. Qed.
Lemma power_nonnegative p x : 0 <= power p x.
Proof. unfold power. destruct (Rlt_dec 0 x); [left; apply exp_pos | lra]. Qed.
Lemma power_successor p x : power (p + 1) x = x * power p x.
Proof.
  unfold power. destruct (Rlt_dec 0 x) as [H | _]; [| ring]. rewrite Rpower_plus, Rpower_1 by exact H. ring.
Qed.
Lemma power_decreasing p q x : x <= 1 -> p <= q -> power q x <= power p x.
Proof.
  intros Hx Hpq. unfold power. destruct (Rlt_dec 0 x) as [H | _]; [| lra].
  assert (L : ln x <= 0) by (rewrite <- ln_1; destruct (Rle_lt_or_eq_dec x 1 Hx) as [H1 | ->]; [left; apply ln_increasing; lra | lra]).
  unfold Rpower. destruct (Rle_lt_or_eq_dec (q * ln x) (p * ln x) ltac:(nra)) as [H1 | ->]; [left; apply exp_increasing, H1 | lra].
Qed.

Lemma power_small p e : 0 < p -> 0 < e -> exists d, 0 < d /\ forall x, x < d -> power p x < e.
Proof.
  intros Hp He. exists (Rpower e (/ p)). split; [apply exp_pos |]. intros x Hx.
  unfold power. destruct (Rlt_dec 0 x) as [H | _]; [| exact He].
  rewrite <- (Rpower_1 e) by exact He. rewrite <- (Rinv_l p) by lra. rewrite <- Rpower_mult.
  unfold Rpower at 1 2. apply exp_increasing, Rmult_lt_compat_l; [exact Hp |]. apply ln_increasing; assumption.
Qed.
Lemma power_continuous p x : 0 < p -> continuous (power p) x.
Proof.
  intros Hp. destruct (Rtotal_order 0 x) as [H | [H | H]].
  - apply (continuous_ext_loc _ (fun x => Rpower x p)).
    + apply (locally_near x x); [exact H |]. intros r Hr. symmetry. apply power_of_positive. lra.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold Rpower. auto_derive. exact H.
  - subst x. apply (proj2 (filterlim_locally (F := locally 0) (power p) (power p 0))). intros [e He].
    destruct (power_small p e Hp He) as (d & Hd & B). apply (locally_near 0 d _ Hd). intros x Hx.
    unfold ball; simpl. unfold AbsRing_ball, abs, minus, plus, opp; simpl.
    rewrite (power_of_negative p 0), Ropp_0, Rplus_0_r, Rabs_pos_eq by (apply power_nonnegative || lra). apply B. lra.
  - apply (continuous_ext_loc _ (fun _ => 0)); [| apply continuous_const].
    apply (locally_near x (- x)); [lra |]. intros r Hr. symmetry. apply power_of_negative. lra.
Qed.
Lemma power_derive p x : 1 < p -> is_derive (power p) x (p * power (p - 1) x).
Proof.
  intros Hp. destruct (Rtotal_order 0 x) as [H | [H | H]].
  - rewrite power_of_positive by exact H. apply (is_derive_ext_loc (fun x => Rpower x p)).
    + apply (locally_near x x); [exact H |]. intros r Hr. symmetry. apply power_of_positive. lra.
    + unfold Rpower. auto_derive; [exact H |]. replace ((p - 1) * ln x) with (p * ln x + - ln x) by ring.
      rewrite exp_plus, exp_Ropp, exp_ln by exact H. field. lra.
  - subst x. rewrite power_of_negative, Rmult_0_r by lra. apply is_derive_Reals. intros e He.
    destruct (power_small (p - 1) e ltac:(lra) He) as (d & Hd & B). exists (mkposreal d Hd). simpl. intros h Hh0 Hh.
    rewrite Rplus_0_l, (power_of_negative p 0), !Rminus_0_r by lra.
    replace (power p h) with (h * power (p - 1) h) by (rewrite <- power_successor; f_equal; ring).
    replace (h * power (p - 1) h / h) with (power (p - 1) h) by (field; exact Hh0).
    rewrite Rabs_pos_eq by apply power_nonnegative. apply B. apply Rabs_def2 in Hh. lra.
  - rewrite power_of_negative, Rmult_0_r by lra. apply (is_derive_ext_loc (fun _ => 0)).
    + apply (locally_near x (- x)); [lra |]. intros r Hr. symmetry. apply power_of_negative. lra.
    + auto_derive; trivial.
Qed.

(* ---- The integral of a power of the sine, by Wallis ---- *)

Definition wallis (q : R) : R := RInt (fun theta => power q (sin theta)) 0 (PI / 2).
Lemma power_of_sine_continuous q theta : 0 < q -> continuous (fun theta => power q (sin theta)) theta.
Proof.
  intros Hq. apply (continuous_comp sin (power q)); [| apply power_continuous, Hq].
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma wallis_correct q : 0 < q -> is_RInt (fun theta => power q (sin theta)) 0 (PI / 2) (wallis q).
Proof.
  intros Hq. apply (@RInt_correct R_CompleteNormedModule), (@ex_RInt_continuous R_CompleteNormedModule).
  intros theta _. apply power_of_sine_continuous, Hq.
Qed.
Lemma wallis_nonnegative q : 0 < q -> 0 <= wallis q.
Proof.
  intros Hq. assert (Hpi := PI_RGT_0). apply RInt_ge_0; [lra | exists (wallis q); apply wallis_correct, Hq |].
  intros; apply power_nonnegative.
Qed.
Lemma wallis_decreasing p q : 0 < p -> p <= q -> wallis q <= wallis p.
Proof.
  intros Hp Hpq. assert (Hpi := PI_RGT_0).
  apply RInt_le; [lra | exists (wallis q); apply wallis_correct; lra | exists (wallis p); apply wallis_correct; lra |].
  intros theta _. apply power_decreasing; [apply SIN_bound | exact Hpq].
Qed.
Lemma wallis_successor q : 0 < q -> wallis (q + 2) = (q + 1) / (q + 2) * wallis q.
Proof.
  intros Hq. assert (Hpi := PI_RGT_0).
  assert (H : is_RInt (fun theta => minus ((q + 2) * power (q + 2) (sin theta)) ((q + 1) * power q (sin theta))) 0 (PI / 2)
    ((fun theta => - (cos theta * power (q + 1) (sin theta))) (PI / 2) - (fun theta => - (cos theta * power (q + 1) (sin theta))) 0)).
  { apply (is_RInt_antiderivative _ (fun theta => (q + 2) * power (q + 2) (sin theta) - (q + 1) * power q (sin theta))
      (fun theta => - (cos theta * power (q + 1) (sin theta)))); [lra | | |].
    - reflexivity.
    - intros theta _.
      assert (D := power_derive (q + 1) (sin theta) ltac:(lra)). replace (q + 1 - 1) with q in D by ring.
      auto_derive; [eexists; exact D |].
      replace (Derive (fun x => power (q + 1) x) (sin theta)) with ((q + 1) * power q (sin theta)) by (symmetry; apply is_derive_unique, D).
      replace (q + 2) with (q + 1 + 1) by ring. rewrite !power_successor.
      assert (T : cos theta * cos theta = 1 - sin theta * sin theta) by (generalize (sin2_cos2 theta); unfold Rsqr; lra).
      replace (- (1 * - sin theta * (sin theta * power q (sin theta)) + cos theta * (1 * cos theta * ((q + 1) * power q (sin theta)))))
        with (sin theta * (sin theta * power q (sin theta)) - (cos theta * cos theta) * ((q + 1) * power q (sin theta))) by ring.
      match goal with |- ?l = _ => ring_simplify l end. ring [T].
    - intros theta _. apply continuous_sub; apply continuous_times; try apply continuous_const; apply power_of_sine_continuous; lra. }
  cbv beta in H. rewrite cos_PI2, sin_0, (power_of_negative _ 0), Rmult_0_l, Rmult_0_r, Rminus_diag_eq in H by lra.
  assert (I := is_RInt_minus (V := R_NormedModule) _ _ _ _ _ _
    (is_RInt_scal _ _ _ (q + 2) _ (wallis_correct (q + 2) ltac:(lra))) (is_RInt_scal _ _ _ (q + 1) _ (wallis_correct q Hq))).
  assert (E := eq_trans (eq_sym (is_RInt_unique (V := R_CompleteNormedModule) _ _ _ _ H)) (is_RInt_unique (V := R_CompleteNormedModule) _ _ _ _ I)).
  unfold minus, plus, opp, scal in E; simpl in E; unfold mult in E; simpl in E.
  replace (wallis q) with ((q + 2) * wallis (q + 2) / (q + 1)) by (field_simplify_eq; lra). field. lra.
Qed.
Lemma wallis_1 : wallis 1 = 1.
Proof.
  assert (Hpi := PI_RGT_0).
  assert (I : is_RInt (fun theta => power 1 (sin theta)) 0 (PI / 2) ((fun theta => - cos theta) (PI / 2) - (fun theta => - cos theta) 0)).
  { apply (is_RInt_antiderivative _ sin (fun theta => - cos theta)); [lra | | |].
    - intros theta H. assert (0 < sin theta) by (apply sin_gt_0; lra). rewrite power_of_positive, Rpower_1 by assumption. reflexivity.
    - intros theta _. auto_derive; [trivial | ring].
    - intros theta _. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
  apply (is_RInt_unique (V := R_CompleteNormedModule)) in I. unfold wallis. rewrite I, cos_PI2, cos_0. ring.
Qed.
Lemma wallis_2 : wallis 2 = PI / 4.
Proof.
  assert (Hpi := PI_RGT_0). set (F := fun theta => theta / 2 - sin theta * cos theta / 2).
  assert (I : is_RInt (fun theta => power 2 (sin theta)) 0 (PI / 2) (F (PI / 2) - F 0)).
  { apply (is_RInt_antiderivative _ (fun theta => sin theta ^ 2) F); [lra | | |].
    - intros theta H. assert (0 < sin theta) by (apply sin_gt_0; lra). rewrite power_of_positive by assumption.
      replace 2 with (INR 2) at 1 by (simpl; ring). rewrite Rpower_pow by assumption. reflexivity.
    - intros theta _. unfold F. auto_derive; [trivial |]. assert (T := sin2_cos2 theta). unfold Rsqr in T. simpl. field_simplify. nra.
    - intros theta _. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
  apply (is_RInt_unique (V := R_CompleteNormedModule)) in I. unfold wallis. rewrite I. unfold F. rewrite cos_PI2, sin_0. field.
Qed.

(* ---- By the gamma function ---- *)

Section Gamma.
Variable G : R -> R.
Hypothesis HG : is_gamma G.
Lemma gamma_positive x : 0 < x -> 0 < G x.
Proof. intros H. apply HG, H. Qed.
Lemma gamma_successor x : 0 < x -> G (x + 1) = x * G x.
Proof. intros H. apply HG, H. Qed.

Let r q := G (q / 2 + 1) / G ((q + 1) / 2).
Lemma ratio_positive q : 0 < q -> 0 < r q.
Proof. intros H. apply Rdiv_lt_0_compat; apply gamma_positive; lra. Qed.
Lemma ratio_increasing p q : 0 < p -> p <= q -> r p <= r q.
Proof.
  intros Hp Hpq. destruct HG as (_ & _ & Hc). destruct (Rle_lt_or_eq_dec p q Hpq) as [H | ->]; [clear Hpq | lra].
  set (z := (p + 1) / 2). set (w := (q + 1) / 2). assert (Hzw : 0 < z < w) by (unfold z, w; lra).
  assert (Ez : p / 2 + 1 = z + / 2) by (unfold z; field). assert (Ew : q / 2 + 1 = w + / 2) by (unfold w; field).
  unfold r. rewrite Ez, Ew. fold z w.
  set (d := w + / 2 - z). assert (Hd : 0 < d) by (unfold d; lra).
  assert (K : 0 <= / 2 / d <= 1 /\ 0 <= (w - z) / d <= 1).
  { assert (I := Rinv_0_lt_compat d Hd). assert (E : d * / d = 1) by (apply Rinv_r; lra). unfold Rdiv. unfold d in E |- *. fold d in I |- *. fold d in E. split; split; unfold d in *; nra. }
  assert (C1 := Hc z (w + / 2) ((w - z) / d) ltac:(lra) ltac:(lra) ltac:(apply K)).
  assert (C2 := Hc z (w + / 2) (/ 2 / d) ltac:(lra) ltac:(lra) ltac:(apply K)).
  replace ((w - z) / d * z + (1 - (w - z) / d) * (w + / 2)) with (z + / 2) in C1 by (unfold d; field; unfold d in Hd; lra).
  replace (/ 2 / d * z + (1 - / 2 / d) * (w + / 2)) with w in C2 by (unfold d; field; unfold d in Hd; lra).
  assert (S : (w - z) / d + / 2 / d = 1) by (unfold d; field; unfold d in Hd; lra).
  assert (L : ln (G (z + / 2)) + ln (G w) <= ln (G z) + ln (G (w + / 2))).
  { replace (/ 2 / d) with (1 - (w - z) / d) in C2 by lra. set (k := (w - z) / d) in *. set (f := ln (G z)) in *. set (h := ln (G (w + / 2))) in *. nra. }
  assert (P1 := gamma_positive z ltac:(lra)). assert (P2 := gamma_positive w ltac:(lra)).
  assert (P3 := gamma_positive (z + / 2) ltac:(lra)). assert (P4 := gamma_positive (w + / 2) ltac:(lra)).
  rewrite <- !ln_mult in L by assumption.
  assert (M : G (z + / 2) * G w <= G z * G (w + / 2)).
  { destruct (Rle_lt_dec (G (z + / 2) * G w) (G z * G (w + / 2))) as [M | M]; [exact M |].
    apply ln_increasing in M; [lra | apply Rmult_lt_0_compat; assumption]. }
  apply (Rmult_le_reg_r (G z * G w)); [apply Rmult_lt_0_compat; assumption |].
  replace (G (z + / 2) / G z * (G z * G w)) with (G (z + / 2) * G w) by (field; lra).
  replace (G (w + / 2) / G w * (G z * G w)) with (G z * G (w + / 2)) by (field; lra). exact M.
Qed.
Lemma ratio_successor q : 0 < q -> r (q + 2) = (q + 2) / (q + 1) * r q.
Proof.
  intros H. unfold r. replace ((q + 2) / 2 + 1) with (q / 2 + 1 + 1) by field. replace ((q + 2 + 1) / 2) with ((q + 1) / 2 + 1) by field.
  rewrite !gamma_successor by lra. assert (P := gamma_positive ((q + 1) / 2) ltac:(lra)). field. lra.
Qed.

Let phi q := wallis q * r q.
Lemma phi_nonnegative q : 0 < q -> 0 <= phi q.
Proof. intros H. apply Rmult_le_pos; [apply wallis_nonnegative, H | left; apply ratio_positive, H]. Qed.
Lemma phi_successor q : 0 < q -> phi (q + 2) = phi q.
Proof. intros H. unfold phi. rewrite wallis_successor, ratio_successor by exact H. field. lra. Qed.
Lemma phi_further q n : 0 < q -> phi (q + 2 * INR n) = phi q.
Proof.
  intros H. induction n as [| n IH]; [simpl; f_equal; ring |].
  rewrite S_INR. replace (q + 2 * (INR n + 1)) with (q + 2 * INR n + 2) by ring.
  rewrite phi_successor by (generalize (pos_INR n); lra). exact IH.
Qed.
Lemma phi_near p q : 0 < p -> p <= q <= p + 2 -> phi q <= phi p * (1 + / (p + 1)) /\ phi p <= phi q * (1 + / (p + 1)).
Proof.
  intros Hp H. assert (W1 := wallis_decreasing p q Hp ltac:(lra)). assert (W2 := wallis_decreasing q (p + 2) ltac:(lra) ltac:(lra)).
  assert (R1 := ratio_increasing p q Hp ltac:(lra)). assert (R2 := ratio_increasing q (p + 2) ltac:(lra) ltac:(lra)).
  assert (P0 := wallis_nonnegative q ltac:(lra)). assert (P1 := wallis_nonnegative (p + 2) ltac:(lra)).
  assert (P2 := ratio_positive p Hp). assert (P3 := ratio_positive q ltac:(lra)).
  replace (1 + / (p + 1)) with ((p + 2) / (p + 1)) by (field; lra). split.
  - replace (phi p * ((p + 2) / (p + 1))) with (wallis p * r (p + 2)) by (rewrite ratio_successor by exact Hp; unfold phi; ring).
    unfold phi. apply Rmult_le_compat; lra.
  - replace (phi p) with (wallis (p + 2) * r p * ((p + 2) / (p + 1))).
    + apply Rmult_le_compat_r; [apply Rlt_le, Rdiv_lt_0_compat; lra |]. unfold phi. apply Rmult_le_compat; lra.
    + rewrite wallis_successor by exact Hp. unfold phi. field. lra.
Qed.
Lemma beyond_number x : exists n : nat, x < INR n.
Proof.
  destruct (Rle_lt_dec 0 x) as [H | H].
  - destruct (nfloor_ex x H) as [n Hn]. exists (S n). rewrite S_INR. lra.
  - exists O. exact H.
Qed.
Lemma below_all x y : 0 <= y -> (forall n : nat, x <= y * (1 + / (INR n + 1))) -> x <= y.
Proof.
  intros Hy H. destruct (Rle_lt_dec x y) as [L | L]; [exact L | exfalso].
  destruct (beyond_number (y / (x - y))) as [n Hn]. specialize (H n).
  assert (P := pos_INR n). assert (B : y < INR n * (x - y)).
  { apply (Rmult_lt_compat_r (x - y)) in Hn; [| lra]. replace (y / (x - y) * (x - y)) with y in Hn by (field; lra). exact Hn. }
  assert (I : / (INR n + 1) * (INR n + 1) = 1) by (apply Rinv_l; lra).
  assert (I0 : 0 < / (INR n + 1)) by (apply Rinv_0_lt_compat; lra).
  assert (x * (INR n + 1) <= y * (INR n + 2)).
  { replace (y * (INR n + 2)) with (y * (1 + / (INR n + 1)) * (INR n + 1)) by (field; lra). apply Rmult_le_compat_r; lra. }
  nra.
Qed.
Lemma phi_equal p q : 0 < p -> p <= q <= p + 2 -> phi q = phi p.
Proof.
  intros Hp H. assert (B : forall n, phi q <= phi p * (1 + / (INR n + 1)) /\ phi p <= phi q * (1 + / (INR n + 1))).
  { intros n. assert (P := pos_INR n). destruct (phi_near (p + 2 * INR n) (q + 2 * INR n) ltac:(lra) ltac:(lra)) as [B1 B2].
    rewrite !phi_further in B1, B2 by lra.
    assert (I : / (p + 2 * INR n + 1) <= / (INR n + 1)) by (apply Rinv_le_contravar; lra).
    assert (Q1 := phi_nonnegative p Hp). assert (Q2 := phi_nonnegative q ltac:(lra)). split; nra. }
  apply Rle_antisym; apply below_all; try (apply phi_nonnegative; lra); intros n; apply B.
Qed.
Lemma phi_value q : 1 <= q -> phi q = sqrt PI / 2.
Proof.
  intros Hq. assert (Hpi := PI_RGT_0). destruct HG as (G1 & _).
  assert (All : forall n q, 1 <= q <= 1 + 2 * INR n -> phi q = phi 1).
  { induction n as [| n IH]; intros x Hx.
    - simpl in Hx. f_equal. lra.
    - rewrite S_INR in Hx. destruct (Rle_lt_dec x 3) as [H | H]; [apply phi_equal; lra |].
      replace x with (x - 2 + 2) by ring. rewrite phi_successor by lra. apply IH. lra. }
  assert (Q1 : phi 1 = G (3 / 2)).
  { unfold phi, r. rewrite wallis_1. replace (1 / 2 + 1) with (3 / 2) by field. replace ((1 + 1) / 2) with 1 by field. rewrite G1. field. }
  assert (Q2 : phi 2 = PI / 4 / G (3 / 2)).
  { unfold phi, r. rewrite wallis_2. replace (2 / 2 + 1) with (1 + 1) by field. replace ((2 + 1) / 2) with (3 / 2) by field.
    rewrite gamma_successor, G1 by lra. assert (P := gamma_positive (3 / 2) ltac:(lra)). field. lra. }
  assert (P := gamma_positive (3 / 2) ltac:(lra)).
  assert (E := phi_equal 1 2 ltac:(lra) ltac:(lra)). rewrite Q1, Q2 in E.
  assert (S : G (3 / 2) * G (3 / 2) = PI / 4).
  { rewrite <- E at 1. field. lra. }
  destruct (beyond_number q) as [n Hn]. rewrite (All n q) by lra. rewrite Q1.
  replace (sqrt PI / 2) with (sqrt (PI / 4)).
  - rewrite <- S. symmetry. apply sqrt_square. lra.
  - rewrite sqrt_div_alt by lra. f_equal. replace 4 with (2 * 2) by ring. apply sqrt_square. lra.
Qed.

Theorem wallis_by_gamma m : 0 <= m -> G (2 + m / 2) = (2 + m) * wallis (m + 1) / sqrt PI * G ((3 + m) / 2).
Proof.
  intros Hm. assert (V := phi_value (m + 1) ltac:(lra)). unfold phi, r in V.
  replace ((m + 1) / 2 + 1) with ((3 + m) / 2) in V by field. replace ((m + 1 + 1) / 2) with (m / 2 + 1) in V by field.
  replace (2 + m / 2) with (m / 2 + 1 + 1) by ring. rewrite gamma_successor by lra.
  assert (P1 := gamma_positive (m / 2 + 1) ltac:(lra)). assert (P2 := gamma_positive ((3 + m) / 2) ltac:(lra)).
  assert (Hpi := sqrt_lt_R0 PI PI_RGT_0).
  replace (G ((3 + m) / 2)) with (sqrt PI / 2 * G (m / 2 + 1) / wallis (m + 1)).
  - assert (W : wallis (m + 1) <> 0) by (intros Z; rewrite Z, Rmult_0_l in V; lra). field. lra.
  - assert (W : wallis (m + 1) <> 0) by (intros Z; rewrite Z, Rmult_0_l in V; lra). rewrite <- V. field. lra.
Qed.
End Gamma.
(* ---- There is such a function: Gauss' limit ---- *)

Lemma ln_concave x y l : 0 < x -> 0 < y -> 0 <= l <= 1 -> l * ln x + (1 - l) * ln y <= ln (l * x + (1 - l) * y).
Proof.
  intros Hx Hy Hl. set (c := l * x + (1 - l) * y). assert (Hc : 0 < c) by (unfold c; nra).
  assert (T : forall t, 0 < t -> ln t <= ln c + (t - c) / c).
  { intros t Ht. assert (0 < t / c) by (apply Rdiv_lt_0_compat; assumption).
    assert (L : ln (t / c) <= t / c - 1).
    { destruct (Req_dec (ln (t / c)) 0) as [Z | Z].
      - assert (E : exp (ln (t / c)) = t / c) by (apply exp_ln; assumption). rewrite Z, exp_0 in E. lra.
      - assert (E := exp_ineq1 (ln (t / c)) Z). rewrite exp_ln in E by assumption. lra. }
    unfold Rdiv in L at 1. rewrite ln_mult, ln_Rinv in L by (try apply Rinv_0_lt_compat; assumption).
    replace ((t - c) / c) with (t / c - 1) by (field; lra). lra. }
  assert (T1 := T x Hx). assert (T2 := T y Hy).
  assert (S : l * ((x - c) / c) + (1 - l) * ((y - c) / c) = 0) by (unfold c; field; unfold c in Hc; lra). nra.
Qed.
(* (1 + h)^x is at most 1 + x h. *)
Lemma bernoulli h x : -1 < h -> 0 <= x <= 1 -> Rpower (1 + h) x <= 1 + x * h.
Proof.
  intros Hh Hx. assert (L := ln_concave (1 + h) 1 x ltac:(lra) ltac:(lra) Hx). rewrite ln_1 in L.
  replace (x * (1 + h) + (1 - x) * 1) with (1 + x * h) in L by ring.
  assert (P : 0 < 1 + x * h) by (destruct (Rle_lt_dec 0 h); [nra | assert (0 <= (1 - x) * - h) by (apply Rmult_le_pos; lra); nra]). rewrite <- (exp_ln (1 + x * h)) by exact P. unfold Rpower.
  destruct (Rle_lt_or_eq_dec (x * ln (1 + h)) (ln (1 + x * h)) ltac:(lra)) as [H | H]; [left; apply exp_increasing, H | rewrite H; lra].
Qed.

Fixpoint rising (n : nat) (x : R) : R := match n with O => x | S k => rising k x * (x + INR (S k)) end.
Lemma rising_positive n x : 0 < x -> 0 < rising n x.
Proof.
  intros H. induction n as [| n IH]; [exact H |]. change (0 < rising n x * (x + INR (S n))).
  apply Rmult_lt_0_compat; [exact IH | generalize (pos_INR (S n)); lra].
Qed.
Lemma rising_successor n x : x * rising n (x + 1) = rising n x * (x + INR n + 1).
Proof.
  induction n as [| n IH]; [simpl; ring |].
  change (x * (rising n (x + 1) * (x + 1 + INR (S n))) = rising n x * (x + INR (S n)) * (x + INR (S n) + 1)).
  rewrite <- Rmult_assoc, IH, S_INR. ring.
Qed.
(* With n + 1 in place of n, so that it is positive. *)
Definition gauss (x : R) (n : nat) : R := Rpower (INR n + 1) x * INR (fact (S n)) / rising (S n) x.
Lemma gauss_positive x n : 0 < x -> 0 < gauss x n.
Proof.
  intros H. apply Rdiv_lt_0_compat; [| apply rising_positive, H].
  apply Rmult_lt_0_compat; [apply exp_pos | apply INR_fact_lt_0].
Qed.
Lemma gauss_successor x n : 0 < x -> gauss (x + 1) n = gauss x n * (x * ((INR n + 1) / (x + INR n + 2))).
Proof.
  intros H. assert (P := pos_INR n). unfold gauss. rewrite Rpower_plus, Rpower_1 by lra.
  assert (R1 := rising_positive (S n) x H). assert (R2 := rising_positive (S n) (x + 1) ltac:(lra)).
  replace (rising (S n) (x + 1)) with (rising (S n) x * (x + INR n + 2) / x).
  - field. repeat split; lra.
  - apply (Rmult_eq_reg_l x); [| lra]. rewrite rising_successor, S_INR. field. lra.
Qed.
Lemma gauss_step x n : gauss x (S n) = gauss x n * (Rpower (INR n + 2) x / Rpower (INR n + 1) x * ((INR n + 2) / (x + INR n + 2))) \/ x <= 0.
Proof.
  destruct (Rle_lt_dec x 0) as [H | H]; [right; exact H | left]. assert (P := pos_INR n).
  unfold gauss. change (rising (S (S n)) x) with (rising (S n) x * (x + INR (S (S n)))).
  replace (fact (S (S n))) with ((S (S n)) * fact (S n))%nat by reflexivity. rewrite mult_INR, !S_INR.
  replace (INR n + 1 + 1) with (INR n + 2) by ring.
  assert (R1 := rising_positive (S n) x H). assert (Q : 0 < Rpower (INR n + 1) x) by apply exp_pos. field. repeat split; lra.
Qed.
Lemma gauss_grows x n : 0 < x <= 1 -> gauss x n <= gauss x (S n).
Proof.
  intros H. destruct (gauss_step x n) as [E | E]; [rewrite E | lra]. assert (P := pos_INR n). assert (G := gauss_positive x n ltac:(lra)).
  rewrite <- (Rmult_1_r (gauss x n)) at 1. apply Rmult_le_compat_l; [lra |].
  assert (B := bernoulli (- (/ (INR n + 2))) x).
  assert (I : 0 < / (INR n + 2) < 1) by (split; [apply Rinv_0_lt_compat; lra | rewrite <- Rinv_1; apply Rinv_lt_contravar; lra]).
  specialize (B ltac:(lra) ltac:(lra)).
  replace (1 + - / (INR n + 2)) with ((INR n + 1) * / (INR n + 2)) in B by (field; lra).
  rewrite <- Rpower_mult_distr in B by lra.
  assert (Ei : Rpower (/ (INR n + 2)) x = / Rpower (INR n + 2) x).
  { rewrite <- Rpower_Ropp. unfold Rpower. rewrite ln_Rinv by lra. f_equal. ring. }
  rewrite Ei in B. assert (Q1 : 0 < Rpower (INR n + 1) x) by apply exp_pos. assert (Q2 : 0 < Rpower (INR n + 2) x) by apply exp_pos.
  apply (Rmult_le_reg_r (Rpower (INR n + 1) x * / Rpower (INR n + 2) x)); [apply Rmult_lt_0_compat; [| apply Rinv_0_lt_compat]; assumption |].
  replace (Rpower (INR n + 2) x / Rpower (INR n + 1) x * ((INR n + 2) / (x + INR n + 2)) * (Rpower (INR n + 1) x * / Rpower (INR n + 2) x))
    with ((INR n + 2) / (x + INR n + 2)) by (field; repeat split; lra).
  rewrite Rmult_1_l. apply (Rle_trans _ _ _ B).
  apply (Rmult_le_reg_r ((x + INR n + 2) * (INR n + 2))); [apply Rmult_lt_0_compat; lra |].
  replace ((1 + x * - / (INR n + 2)) * ((x + INR n + 2) * (INR n + 2))) with ((INR n + 2 - x) * (INR n + 2 + x)) by (field; lra).
  replace ((INR n + 2) / (x + INR n + 2) * ((x + INR n + 2) * (INR n + 2))) with ((INR n + 2) * (INR n + 2)) by (field; lra). nra.
Qed.
Lemma gauss_bounded x n : 0 < x <= 1 -> gauss x n <= / x.
Proof.
  intros H. assert (B : Rpower (INR n + 2) x * INR (fact (S n)) / rising (S n) x <= Rpower 2 x / (x * (x + 1))).
  { induction n as [| n IH]; [simpl; right; rewrite Rplus_0_l; field; lra |].
    apply (Rle_trans _ (Rpower (INR n + 2) x * INR (fact (S n)) / rising (S n) x)); [| exact IH].
    assert (P := pos_INR n). change (rising (S (S n)) x) with (rising (S n) x * (x + INR (S (S n)))).
    replace (fact (S (S n))) with ((S (S n)) * fact (S n))%nat by reflexivity. rewrite mult_INR, !S_INR.
    assert (R1 := rising_positive (S n) x ltac:(lra)). assert (F := INR_fact_lt_0 (S n)).
    assert (L := bernoulli (/ (INR n + 2)) x). assert (I : 0 < / (INR n + 2)) by (apply Rinv_0_lt_compat; lra). specialize (L ltac:(lra) ltac:(lra)).
    replace (INR n + 1 + 2) with ((INR n + 2) * (1 + / (INR n + 2))) by (field; lra).
    rewrite <- Rpower_mult_distr by lra. assert (Q : 0 < Rpower (INR n + 2) x) by apply exp_pos.
    replace (Rpower (INR n + 2) x * Rpower (1 + / (INR n + 2)) x * ((INR n + 1 + 1) * INR (fact (S n))) / (rising (S n) x * (x + (INR n + 1 + 1))))
      with (Rpower (INR n + 2) x * INR (fact (S n)) / rising (S n) x * (Rpower (1 + / (INR n + 2)) x * ((INR n + 2) / (x + INR n + 2))))
      by (field; repeat split; lra).
    rewrite <- (Rmult_1_r (Rpower (INR n + 2) x * INR (fact (S n)) / rising (S n) x)) at 2. apply Rmult_le_compat_l.
    - apply Rlt_le, Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; assumption.
    - apply (Rmult_le_reg_r ((x + INR n + 2) / (INR n + 2))); [apply Rdiv_lt_0_compat; lra |].
      replace (Rpower (1 + / (INR n + 2)) x * ((INR n + 2) / (x + INR n + 2)) * ((x + INR n + 2) / (INR n + 2))) with (Rpower (1 + / (INR n + 2)) x) by (field; lra).
      apply (Rle_trans _ _ _ L). right. field. lra. }
  assert (P := pos_INR n). assert (L := bernoulli 1 x ltac:(lra) ltac:(lra)). replace (1 + 1) with 2 in L by ring.
  apply Rle_trans with (Rpower 2 x / (x * (x + 1))).
  - apply Rle_trans with (2 := B). unfold gauss. unfold Rdiv. apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, rising_positive; lra |].
    apply Rmult_le_compat_r; [apply Rlt_le, INR_fact_lt_0 |]. apply Rle_Rpower_l; lra.
  - apply (Rmult_le_reg_r (x * (x + 1))); [apply Rmult_lt_0_compat; lra |].
    replace (Rpower 2 x / (x * (x + 1)) * (x * (x + 1))) with (Rpower 2 x) by (field; lra).
    replace (/ x * (x * (x + 1))) with (x + 1) by (field; lra). lra.
Qed.

Definition gauss_limit (x : R) : R := real (Lim_seq (gauss x)).
Lemma gauss_converges_near x : 0 < x <= 1 -> is_lim_seq (gauss x) (gauss_limit x) /\ 0 < gauss_limit x.
Proof.
  intros H. assert (Ex : ex_finite_lim_seq (gauss x)).
  { apply (ex_finite_lim_seq_incr _ (/ x)); intros n; [apply gauss_grows, H | apply gauss_bounded, H]. }
  assert (L := Lim_seq_correct' _ Ex). split; [exact L |].
  apply Rlt_le_trans with (gauss x 0); [apply gauss_positive; lra |].
  apply (is_lim_seq_incr_compare _ _ L). intros n. apply gauss_grows, H.
Qed.
Lemma gauss_converges x : 0 < x -> is_lim_seq (gauss x) (gauss_limit x) /\ 0 < gauss_limit x.
Proof.
  assert (All : forall n x, 0 < x <= INR n + 1 -> is_lim_seq (gauss x) (gauss_limit x) /\ 0 < gauss_limit x).
  { induction n as [| n IH]; intros y Hy.
    - apply gauss_converges_near. simpl in Hy. lra.
    - rewrite S_INR in Hy. destruct (Rle_lt_dec y 1) as [H1 | H1]; [apply gauss_converges_near; lra |].
      destruct (IH (y - 1) ltac:(lra)) as [L P].
      assert (Q : is_lim_seq (fun k => (INR k + 1) / (y - 1 + INR k + 2)) 1).
      { apply (is_lim_seq_ext (fun k => 1 - y * / (INR k + (y + 1)))).
        - intros k. generalize (pos_INR k). intros. field. lra.
        - replace (Finite 1) with (Rbar_minus 1 0) by (simpl; f_equal; ring). apply is_lim_seq_minus'; [apply is_lim_seq_const |].
          replace 0 with (y * 0) by ring. apply (is_lim_seq_scal_l (fun k => / (INR k + (y + 1))) y 0).
          replace (Finite 0) with (Rbar_inv p_infty) by reflexivity. apply is_lim_seq_inv; [| discriminate].
          apply (is_lim_seq_plus _ _ p_infty (y + 1)); [apply is_lim_seq_INR | apply is_lim_seq_const | reflexivity]. }
      assert (M : is_lim_seq (gauss y) (gauss_limit (y - 1) * ((y - 1) * 1))).
      { apply (is_lim_seq_ext (fun k => gauss (y - 1) k * ((y - 1) * ((INR k + 1) / (y - 1 + INR k + 2))))).
        - intros k. rewrite <- gauss_successor by lra. f_equal. ring.
        - apply is_lim_seq_mult'; [exact L |]. apply (is_lim_seq_scal_l _ (y - 1) 1 Q). }
      assert (E : gauss_limit y = gauss_limit (y - 1) * ((y - 1) * 1)) by (unfold gauss_limit at 1; rewrite (is_lim_seq_unique _ _ M); reflexivity).
      rewrite E. split; [exact M |]. apply Rmult_lt_0_compat; lra. }
  intros H. destruct (beyond_number x) as [n Hn]. apply (All n). lra.
Qed.
Lemma gauss_at_1 n : gauss 1 n = (INR n + 1) / (INR n + 2).
Proof.
  assert (F : forall n, rising n 1 = INR (fact (S n))).
  { induction n0 as [| k IH]; [simpl; ring |]. change (rising (S k) 1) with (rising k 1 * (1 + INR (S k))).
    rewrite IH. replace (fact (S (S k))) with ((S (S k)) * fact (S k))%nat by reflexivity. rewrite mult_INR, (S_INR (S k)). ring. }
  assert (P := pos_INR n). unfold gauss. rewrite F, Rpower_1 by lra.
  replace (fact (S (S n))) with ((S (S n)) * fact (S n))%nat by reflexivity. rewrite mult_INR, !S_INR.
  assert (Q := INR_fact_lt_0 (S n)). field. lra.
Qed.
Lemma ln_rising_concave n x y l : 0 < x -> 0 < y -> 0 <= l <= 1 ->
  l * ln (rising n x) + (1 - l) * ln (rising n y) <= ln (rising n (l * x + (1 - l) * y)).
Proof.
  intros Hx Hy Hl. assert (Hz : 0 < l * x + (1 - l) * y) by nra. induction n as [| n IH]; [apply ln_concave; assumption |].
  assert (P := pos_INR (S n)). change (rising (S n)) with (fun x => rising n x * (x + INR (S n))). cbv beta.
  rewrite !ln_mult by (try apply rising_positive; lra).
  assert (C := ln_concave (x + INR (S n)) (y + INR (S n)) l ltac:(lra) ltac:(lra) Hl).
  replace (l * (x + INR (S n)) + (1 - l) * (y + INR (S n))) with (l * x + (1 - l) * y + INR (S n)) in C by ring. lra.
Qed.
Lemma ln_gauss_convex n x y l : 0 < x -> 0 < y -> 0 <= l <= 1 ->
  ln (gauss (l * x + (1 - l) * y) n) <= l * ln (gauss x n) + (1 - l) * ln (gauss y n).
Proof.
  intros Hx Hy Hl. assert (Hz : 0 < l * x + (1 - l) * y) by nra. assert (P := pos_INR n). assert (F := INR_fact_lt_0 (S n)).
  assert (E : forall z, 0 < z -> ln (gauss z n) = z * ln (INR n + 1) + ln (INR (fact (S n))) - ln (rising (S n) z)).
  { intros z H. assert (R := rising_positive (S n) z H). assert (Q : 0 < Rpower (INR n + 1) z) by apply exp_pos.
    unfold gauss, Rdiv. rewrite ln_mult, ln_mult, ln_Rinv by (first [assumption | apply Rinv_0_lt_compat; assumption | apply Rmult_lt_0_compat; assumption]).
    unfold Rpower. rewrite ln_exp. ring. }
  rewrite !E by assumption. assert (C := ln_rising_concave (S n) x y l Hx Hy Hl). nra.
Qed.
Theorem gamma_exists : is_gamma gauss_limit.
Proof.
  split; [| split].
  - unfold gauss_limit. rewrite (is_lim_seq_unique _ 1); [reflexivity |].
    apply (is_lim_seq_ext (fun n => 1 - / (INR n + 2))).
    + intros n. rewrite gauss_at_1. generalize (pos_INR n). intros. field. lra.
    + replace (Finite 1) with (Rbar_minus 1 0) by (simpl; f_equal; ring). apply is_lim_seq_minus'; [apply is_lim_seq_const |].
      replace (Finite 0) with (Rbar_inv p_infty) by reflexivity. apply is_lim_seq_inv; [| discriminate].
      apply (is_lim_seq_plus _ _ p_infty 2); [apply is_lim_seq_INR | apply is_lim_seq_const | reflexivity].
  - intros x Hx. destruct (gauss_converges x Hx) as [L P]. split; [exact P |].
    assert (Q : is_lim_seq (fun k => (INR k + 1) / (x + INR k + 2)) 1).
    { apply (is_lim_seq_ext (fun k => 1 - (x + 1) * / (INR k + (x + 2)))).
      - intros k. generalize (pos_INR k). intros. field. lra.
      - replace (Finite 1) with (Rbar_minus 1 0) by (simpl; f_equal; ring). apply is_lim_seq_minus'; [apply is_lim_seq_const |].
        replace 0 with ((x + 1) * 0) by ring. apply (is_lim_seq_scal_l (fun k => / (INR k + (x + 2))) (x + 1) 0).
        replace (Finite 0) with (Rbar_inv p_infty) by reflexivity. apply is_lim_seq_inv; [| discriminate].
        apply (is_lim_seq_plus _ _ p_infty (x + 2)); [apply is_lim_seq_INR | apply is_lim_seq_const | reflexivity]. }
    assert (M : is_lim_seq (gauss (x + 1)) (gauss_limit x * (x * 1))).
    { apply (is_lim_seq_ext (fun k => gauss x k * (x * ((INR k + 1) / (x + INR k + 2))))).
      - intros k. rewrite <- gauss_successor by lra. reflexivity.
      - apply is_lim_seq_mult'; [exact L |]. apply (is_lim_seq_scal_l _ x 1 Q). }
    unfold gauss_limit at 1. rewrite (is_lim_seq_unique _ _ M). simpl. ring.
  - intros x y l Hx Hy Hl. assert (Hz : 0 < l * x + (1 - l) * y) by nra.
    assert (Ln : forall z, 0 < z -> is_lim_seq (fun n => ln (gauss z n)) (ln (gauss_limit z))).
    { intros z H. destruct (gauss_converges z H) as [L P]. apply (is_lim_seq_continuous ln); [| exact L].
      apply continuity_pt_filterlim. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. exact P. }
    apply (is_lim_seq_le (fun n => ln (gauss (l * x + (1 - l) * y) n)) (fun n => l * ln (gauss x n) + (1 - l) * ln (gauss y n))
      (ln (gauss_limit (l * x + (1 - l) * y))) (l * ln (gauss_limit x) + (1 - l) * ln (gauss_limit y))).
    + intros n. apply ln_gauss_convex; assumption.
    + apply Ln, Hz.
    + apply is_lim_seq_plus'.
      * apply (is_lim_seq_scal_l _ l (ln (gauss_limit x)) (Ln x Hx)).
      * apply (is_lim_seq_scal_l _ (1 - l) (ln (gauss_limit y)) (Ln y Hy)).
Qed.
