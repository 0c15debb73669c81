(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* The integral of f over (x, a], f being unbounded at x: the limit of the integrals over [e, a],
   which exist. *)
Definition is_improper_integral (f : R -> R) (x a l : R) : Prop :=
  (forall e, x < e <= a -> ex_RInt f e a) /\
  filterlim (fun e => RInt f e a) (at_right x) (locally l).

Lemma improper_by_square (f g : R -> R) (x a : R) :
  x < a ->
  (forall w, 0 < w <= sqrt (a - x) -> 2 * w * f (x + w ^ 2) = g w) ->
  (forall w, - sqrt (a - x) <= w <= sqrt (a - x) -> continuous g w) ->
  (forall s, x < s <= a -> continuous f s) ->
  is_improper_integral f x a (RInt g 0 (sqrt (a - x))).
Proof.
  intros Hxa Hfg Hg Hf.
  assert (Hc : 0 < sqrt (a - x)) by (apply sqrt_lt_R0; lra).
  set (c := sqrt (a - x)) in *.
  assert (Hcc : c ^ 2 = a - x) by (unfold c; simpl; rewrite Rmult_1_r; apply sqrt_sqrt; lra).
  split.
  { intros e He. apply (@ex_RInt_continuous R_CompleteNormedModule). intros z Hz. apply Hf.
    rewrite Rmin_left in Hz by lra. rewrite Rmax_right in Hz by lra. lra. }
  apply filterlim_ext_loc with (f := fun e => RInt g (sqrt (e - x)) c).
  - exists (mkposreal (a - x) ltac:(lra)). intros e He Hxe.
    assert (Hea : e < a).
    { unfold ball in He; simpl in He. unfold AbsRing_ball, abs, minus, plus, opp in He; simpl in He.
      apply Rabs_def2 in He. lra. }
    assert (Hs : 0 < sqrt (e - x)) by (apply sqrt_lt_R0; lra).
    assert (Hsc : sqrt (e - x) < c) by (unfold c; apply sqrt_lt_1_alt; lra).
    assert (Hss : sqrt (e - x) ^ 2 = e - x) by (simpl; rewrite Rmult_1_r; apply sqrt_sqrt; lra).
    transitivity (RInt (fun w => scal (2 * w) (f (x + w ^ 2))) (sqrt (e - x)) c).
    + apply RInt_ext. intros w Hw. rewrite Rmin_left in Hw by lra. rewrite Rmax_right in Hw by lra.
      unfold scal; simpl; unfold mult; simpl. symmetry. apply Hfg. lra.
    + rewrite (RInt_comp f (fun w => x + w ^ 2) (fun w => 2 * w)).
      * rewrite Hss, Hcc. f_equal; ring.
      * intros w Hw. rewrite Rmin_left in Hw by lra. rewrite Rmax_right in Hw by lra.
        apply Hf.
        assert (sqrt (e - x) ^ 2 <= w ^ 2) by (apply pow_incr; lra).
        assert (w ^ 2 <= c ^ 2) by (apply pow_incr; lra).
        lra.
      * intros w Hw. split.
        -- auto_derive; [trivial | ring].
        -- apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
  - assert (Hcont : continuous (fun y => RInt g y c) 0).
    { apply (@ex_derive_continuous R_AbsRing R_NormedModule).
      exists (opp (g 0)).
      apply (is_derive_RInt' g (fun y => RInt g y c) 0 c).
      - exists (mkposreal c Hc). intros y Hy.
        unfold ball in Hy; simpl in Hy. unfold AbsRing_ball, abs, minus, plus, opp in Hy; simpl in Hy.
        apply Rabs_def2 in Hy.
        apply (@RInt_correct R_CompleteNormedModule).
        apply (@ex_RInt_continuous R_CompleteNormedModule). intros z Hz. apply Hg.
        rewrite Rmin_left in Hz by lra. rewrite Rmax_right in Hz by lra. lra.
      - apply Hg. lra. }
    apply (filterlim_comp _ _ _ (fun e => sqrt (e - x)) (fun y => RInt g y c) (at_right x) (locally 0)).
    + assert (Hroot : filterlim (fun e => sqrt (e - x)) (locally x) (locally 0)).
      { replace 0 with (sqrt (x - x)) by (rewrite Rminus_diag_eq by reflexivity; apply sqrt_0).
        change (continuous (fun e => sqrt (e - x)) x).
        apply (continuous_comp (fun e => e - x) sqrt).
        - apply (continuous_minus (fun e => e) (fun _ => x)); [apply continuous_id | apply continuous_const].
        - apply continuous_sqrt. }
      intros P HP. apply filter_le_within. exact (Hroot P HP).
    + exact Hcont.
Qed.

(* ---- The contact problem ---- *)

(* A place of the contact [-b, a] by its angle, theta in [-pi/2, pi/2]. *)
Definition place (a b theta : R) : R := (a - b) / 2 + (a + b) / 2 * sin theta.

(* P(a) = Es/2 int_{-b}^{a} s g'(s) / sqrt((a - s)(s + b)) ds, by s = place a b theta. *)
Definition is_load (Es : R) (g1 : R -> R) (a b P : R) : Prop :=
  is_RInt (fun theta => Es / 2 * (place a b theta * g1 (place a b theta))) (- (PI / 2)) (PI / 2) P.

(* The condition of consistency, 0 = int_{-b}^{a} g'(s) / sqrt((a - s)(s + b)) ds. *)
Definition consistent (g1 : R -> R) (a b : R) : Prop :=
  is_RInt (fun theta => g1 (place a b theta)) (- (PI / 2)) (PI / 2) 0.

(* The contacts through which a growing load passes: left edge b(s) and rate of the load P'(s), by
   the right edge s. *)
Definition is_contact_at (Es : R) (g1 : R -> R) (P P1 b : R -> R) (s : R) : Prop :=
  0 < s + b s /\ consistent g1 s (b s) /\
  locally s (fun r => is_load Es g1 r (b r) (P r)) /\ is_derive P s (P1 s).

(* Barber and Mossakovskii: p(x) = 1/pi int_x^a P'(s) / sqrt((s - x)(x + b(s))) ds, for 0 < x < a. *)
Definition is_pressure (Es : R) (g1 : R -> R) (a x p : R) : Prop :=
  exists P P1 b, (forall s, x <= s <= a -> is_contact_at Es g1 P P1 b s) /\
    is_improper_integral (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + b s)))) x a p.

Lemma pressure_by_square (P1 b : R -> R) (x a : R) :
  x < a ->
  (forall s, x <= s <= a -> continuous P1 s) ->
  (forall s, x <= s <= a -> continuous b s) ->
  (forall s, x <= s <= a -> 0 < x + b s) ->
  is_improper_integral (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + b s)))) x a
    (RInt (fun w => 2 / PI * (P1 (x + w ^ 2) / sqrt (x + b (x + w ^ 2)))) 0 (sqrt (a - x))).
Proof.
  intros Hxa HP Hb Hpos.
  assert (Hcc : sqrt (a - x) ^ 2 = a - x) by (simpl; rewrite Rmult_1_r; apply sqrt_sqrt; lra).
  assert (Hin : forall w, - sqrt (a - x) <= w <= sqrt (a - x) -> x <= x + w ^ 2 <= a).
  { intros w Hw. split; [nra|]. assert (w ^ 2 <= sqrt (a - x) ^ 2) by nra. lra. }
  apply improper_by_square.
  - exact Hxa.
  - intros w Hw. destruct (Hin w ltac:(lra)) as [_ Hle].
    assert (H0 : 0 < x + b (x + w ^ 2)) by (apply Hpos; nra).
    replace ((x + w ^ 2 - x) * (x + b (x + w ^ 2))) with (w ^ 2 * (x + b (x + w ^ 2))) by ring.
    rewrite sqrt_mult by nra.
    replace (sqrt (w ^ 2)) with w by (symmetry; apply sqrt_pow2; lra).
    assert (0 < sqrt (x + b (x + w ^ 2))) by (apply sqrt_lt_R0; lra).
    field. repeat split; try lra. apply PI_neq0.
  - intros w Hw.
    assert (Hsq : continuous (fun w => x + w ^ 2) w).
    { apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
    apply (continuous_mult (fun _ => 2 / PI)). { apply continuous_const. }
    apply (continuous_mult (fun w => P1 (x + w ^ 2)) (fun w => / sqrt (x + b (x + w ^ 2)))).
    + apply (continuous_comp (fun w => x + w ^ 2) P1); [exact Hsq | apply HP, Hin, Hw].
    + apply (continuous_comp (fun w => sqrt (x + b (x + w ^ 2))) Rinv).
      * apply (continuous_comp (fun w => x + b (x + w ^ 2)) sqrt); [| apply continuous_sqrt].
        apply (continuous_plus (fun _ => x)). { apply continuous_const. }
        apply (continuous_comp (fun w => x + w ^ 2) b); [exact Hsq | apply Hb, Hin, Hw].
      * apply continuous_Rinv. apply Rgt_not_eq, sqrt_lt_R0, Hpos, Hin, Hw.
  - intros s Hs.
    apply (continuous_mult (fun _ => 1 / PI)). { apply continuous_const. }
    apply (continuous_mult P1 (fun s => / sqrt ((s - x) * (x + b s)))). { apply HP; lra. }
    apply (continuous_comp (fun s => sqrt ((s - x) * (x + b s))) Rinv).
    + apply (continuous_comp (fun s => (s - x) * (x + b s)) sqrt); [| apply continuous_sqrt].
      apply (continuous_mult (fun s => s - x) (fun s => x + b s)).
      * apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
      * apply (continuous_plus (fun _ => x) b). { apply continuous_const. } apply Hb; lra.
    + apply continuous_Rinv. apply Rgt_not_eq, sqrt_lt_R0.
      apply Rmult_lt_0_compat; [lra | apply Hpos; lra].
Qed.

(* An integral by an antiderivative of a function that f is equal to inside. *)
Lemma is_RInt_antiderivative (f h H : R -> R) (a b : R) :
  a <= b ->
  (forall x, a < x < b -> f x = h x) ->
  (forall x, a <= x <= b -> is_derive H x (h x)) ->
  (forall x, a <= x <= b -> continuous h x) ->
  is_RInt f a b (H b - H a).
Proof.
  intros Hab Hfh HH Hh.
  apply (is_RInt_ext h).
  - intros x Hx. rewrite Rmin_left in Hx by lra. rewrite Rmax_right in Hx by lra.
    symmetry. apply Hfh, Hx.
  - apply (is_RInt_derive H h); intros x Hx; rewrite Rmin_left in Hx by lra; rewrite Rmax_right in Hx by lra.
    + apply HH; lra.
    + apply Hh; lra.
Qed.

Lemma asin_sqrt (t s : R) : 0 < s -> - s < t < s -> asin (t / s) = atan (t / sqrt (s ^ 2 - t ^ 2)).
Proof.
  intros Hs Ht.
  assert (Hr : -1 < t / s < 1).
  { split; apply (Rmult_lt_reg_r s); try lra; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra. }
  rewrite asin_atan by exact Hr. f_equal.
  replace (1 - (t / s)²) with ((s ^ 2 - t ^ 2) / s ^ 2) by (unfold Rsqr; field; lra).
  rewrite sqrt_div_alt by (apply pow_lt; lra). rewrite (sqrt_pow2 s) by lra. field.
  split; [| lra]. apply Rgt_not_eq, sqrt_lt_R0.
  replace (s ^ 2 - t ^ 2) with ((s - t) * (s + t)) by ring. apply Rmult_lt_0_compat; lra.
Qed.

Lemma locally_near (s d : R) (P : R -> Prop) : 0 < d -> (forall r, s - d < r < s + d -> P r) -> locally s P.
Proof.
  intros Hd H. exists (mkposreal d Hd). intros r Hr.
  unfold ball in Hr; simpl in Hr. unfold AbsRing_ball, abs, minus, plus, opp in Hr; simpl in Hr.
  apply Rabs_def2 in Hr. apply H. lra.
Qed.
