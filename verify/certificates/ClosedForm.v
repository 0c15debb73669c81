(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact.
Open Scope R_scope.

(* What closed forms of pressures are made of and proved by. *)
Definition atanh (y : R) : R := / 2 * ln ((1 + y) / (1 - y)).

Lemma atanh_0 : atanh 0 = 0.
Proof. unfold atanh. rewrite Rplus_0_r, Rminus_0_r, Rdiv_1, ln_1. ring. Qed.
Lemma atanh_continuous_0 : continuous atanh 0.
Proof.
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold atanh. auto_derive.
  repeat split; try lra. rewrite Ropp_0, !Rplus_0_r, Rinv_1. lra.
Qed.

Lemma atanh_derive (y y1 : R) (f : R -> R) s : is_derive f s y1 -> f s = y -> -1 < y < 1 ->
  is_derive (fun s => atanh (f s)) s (y1 / (1 - y ^ 2)).
Proof.
  intros Hf E Hy. unfold atanh. auto_derive.
  - rewrite E. repeat split; try (exists y1; exact Hf); try lra. apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra].
  - replace (Derive (fun x : R => f x) s) with y1 by (symmetry; apply is_derive_unique; exact Hf). rewrite E. field. repeat split; nra.
Qed.

Lemma improper_by_antiderivative (f H : R -> R) (x a : R) : x < a ->
  (forall s, x < s <= a -> is_derive H s (f s) /\ continuous f s) ->
  filterlim H (at_right x) (locally 0) -> is_improper_integral f x a (H a).
Proof.
  intros Hxa Hf Hx. split.
  { intros e He. apply (@ex_RInt_continuous R_CompleteNormedModule). intros z Hz. apply Hf.
    rewrite Rmin_left in Hz by lra. rewrite Rmax_right in Hz by lra. lra. }
  apply (filterlim_ext_loc (fun e => H a - H e)).
  - exists (mkposreal (a - x) ltac:(lra)). intros e He Hxe.
    unfold ball in He; simpl in He. unfold AbsRing_ball, abs, minus, plus, opp in He; simpl in He.
    apply Rabs_def2 in He. symmetry. apply is_RInt_unique, is_RInt_antiderivative with (h := f).
    + lra.
    + reflexivity.
    + intros s Hs. apply Hf. lra.
    + intros s Hs. apply Hf. lra.
  - replace (locally (H a)) with (locally (minus (H a) 0)) by (f_equal; unfold minus, plus, opp; simpl; ring).
    apply (filterlim_comp_2 (F := at_right x) (G := locally (H a)) (H := locally (opp 0)) (fun _ => H a) (fun e => opp (H e)) plus).
    + apply filterlim_const.
    + apply (filterlim_comp _ _ _ H opp _ (locally 0)); [exact Hx | apply (filterlim_opp (V := R_NormedModule))].
    + apply (filterlim_plus (V := R_NormedModule) (H a) (opp 0)).
Qed.


(* Of a load that grows in proportion to the edge, P' = K, with the other edge at g times the one. *)
Definition proportional_pressure (K g c x : R) : R :=
  2 * K / (PI * sqrt g) * atanh (sqrt g * sqrt (c - x) / sqrt (x + g * c)).
Lemma proportional_integral K g x c : 0 < g -> 0 < x < c ->
  is_improper_integral (fun s => 1 / PI * (K / sqrt ((s - x) * (x + g * s)))) x c (proportional_pressure K g c x).
Proof.
  unfold proportional_pressure.
  intros Hg Hx. assert (Hpi := PI_RGT_0). assert (Hq : 0 < sqrt g) by (apply sqrt_lt_R0, Hg).
  assert (Eq : sqrt g ^ 2 = g) by (apply pow2_sqrt; lra).
  assert (Hw : forall s, x <= s -> 0 < x + g * s) by (intros s Hs; nra).
  apply (improper_by_antiderivative _ (fun s => 2 * K / (PI * sqrt g) * atanh (sqrt g * sqrt (s - x) / sqrt (x + g * s)))); [lra | |].
  - intros s Hs. assert (W := Hw s ltac:(lra)).
    assert (Hr : 0 < sqrt (s - x)) by (apply sqrt_lt_R0; lra). assert (Er : sqrt (s - x) ^ 2 = s - x) by (apply pow2_sqrt; lra).
    assert (Hv : 0 < sqrt (x + g * s)) by (apply sqrt_lt_R0; lra). assert (Ev : sqrt (x + g * s) ^ 2 = x + g * s) by (apply pow2_sqrt; lra).
    assert (Em : sqrt ((s - x) * (x + g * s)) = sqrt (s - x) * sqrt (x + g * s)) by (apply sqrt_mult; lra). split.
    + assert (Dy : is_derive (fun s => sqrt g * sqrt (s - x) / sqrt (x + g * s)) s
        (sqrt g * (x + g * x) / (2 * sqrt (s - x) * sqrt (x + g * s) ^ 3))).
      { auto_derive; [repeat split; lra |]. change (s + - x) with (s - x).
        clear Em. set (r := sqrt (s - x)) in *. set (v := sqrt (x + g * s)) in *. clearbody r v.
        match goal with |- @eq _ ?x ?y => change (@eq R x y) end.
        field_simplify_eq; [| repeat split; lra]. ring [Ev Er]. }
      assert (Hy : 0 <= sqrt g * sqrt (s - x) / sqrt (x + g * s)).
      { apply Rmult_le_pos; [apply Rmult_le_pos; lra | apply Rlt_le, Rinv_0_lt_compat; lra]. }
      assert (Sq : 1 - (sqrt g * sqrt (s - x) / sqrt (x + g * s)) ^ 2 = x * (1 + g) / sqrt (x + g * s) ^ 2).
      { field_simplify_eq; [| lra]. rewrite Eq, Er, Ev. ring. }
      assert (Hp : 0 < x * (1 + g) / sqrt (x + g * s) ^ 2) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | apply pow_lt, Hv]).
      assert (D := atanh_derive _ _ _ s Dy eq_refl ltac:(split; nra)). cbv beta in D.
      eapply (fun H E => eq_ind _ (fun v => is_derive _ s v) H _ E).
      * apply (is_derive_scal (fun s => atanh (sqrt g * sqrt (s - x) / sqrt (x + g * s)))). exact D.
      * match goal with |- @eq _ ?x ?y => change (@eq R x y) end. unfold scal; simpl; unfold mult; simpl.
        change (sqrt g * sqrt (s - x) / sqrt (x + g * s) * (sqrt g * sqrt (s - x) / sqrt (x + g * s) * 1))
          with ((sqrt g * sqrt (s - x) / sqrt (x + g * s)) ^ 2).
        rewrite Sq, Em. field. repeat split; lra.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. change (s + - x) with (s - x). rewrite Em.
      repeat split; try lra; try (apply Rmult_lt_0_compat; lra).
      apply Rgt_not_eq, Rmult_lt_0_compat; assumption.
  - assert (C : continuous (fun s => 2 * K / (PI * sqrt g) * atanh (sqrt g * sqrt (s - x) / sqrt (x + g * s))) x).
    { apply (continuous_mult (fun _ => 2 * K / (PI * sqrt g))); [apply continuous_const |].
      apply (continuous_comp (fun s => sqrt g * sqrt (s - x) / sqrt (x + g * s)) atanh).
      - apply (continuous_mult (fun s => sqrt g * sqrt (s - x)) (fun s => / sqrt (x + g * s))).
        + apply (continuous_mult (fun _ => sqrt g)); [apply continuous_const |].
          apply (continuous_comp (fun s => s - x) sqrt); [| apply continuous_sqrt].
          apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
        + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive.
          assert (W := Hw x ltac:(lra)). repeat split; try lra. apply Rgt_not_eq, sqrt_lt_R0, W.
      - rewrite (Rminus_diag_eq x), sqrt_0, Rmult_0_r by reflexivity. unfold Rdiv. rewrite Rmult_0_l. apply atanh_continuous_0. }
    assert (Z : 2 * K / (PI * sqrt g) * atanh (sqrt g * sqrt (x - x) / sqrt (x + g * x)) = 0).
    { rewrite (Rminus_diag_eq x), sqrt_0, Rmult_0_r by reflexivity. unfold Rdiv at 2. rewrite Rmult_0_l, atanh_0. ring. }
    unfold continuous in C. rewrite Z in C.
    intros A HA. apply filter_le_within. exact (C A HA).
Qed.

(* ---- Near the edge, whose distance's root is taken out ---- *)

(* atanh y / y, which is near to 1 for small y. *)
Definition atanh_ratio (y : R) : R := if Req_EM_T y 0 then 1 else atanh y / y.
Lemma atanh_of_ratio y : atanh y = y * atanh_ratio y.
Proof.
  unfold atanh_ratio. destruct (Req_EM_T y 0) as [E | E]; [| field; exact E].
  rewrite E, atanh_0. ring.
Qed.
Lemma from_zero (f f1 : R -> R) (y : R) : 0 <= y -> f 0 = 0 ->
  (forall z, 0 <= z <= y -> is_derive f z (f1 z)) -> (forall z, 0 <= z <= y -> 0 <= f1 z) -> 0 <= f y.
Proof.
  intros Hy H0 Hd Hp. destruct (MVT_gen f 0 y f1) as [z [Hz E]].
  - intros z Hz. rewrite Rmin_left, Rmax_right in Hz by lra. apply Hd. lra.
  - intros z Hz. rewrite Rmin_left, Rmax_right in Hz by lra. apply continuity_pt_filterlim.
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). exists (f1 z). apply Hd, Hz.
  - rewrite Rmin_left, Rmax_right in Hz by lra. assert (0 <= f1 z) by (apply Hp, Hz). nra.
Qed.
Lemma atanh_ratio_near_0 y e : 0 <= y -> y ^ 2 <= e <= 1 / 4 -> 1 <= atanh_ratio y <= 1 + e / 2.
Proof.
  intros Hy He. assert (y <= 1 / 2) by nra.
  assert (D : forall z, 0 <= z <= y -> is_derive atanh z (/ (1 - z ^ 2))).
  { intros z Hz. unfold atanh. auto_derive; [| field; repeat split; nra].
    repeat split; try lra. apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra]. }
  assert (A0 := atanh_0).
  assert (Least : 0 <= atanh y - y).
  { apply (from_zero (fun z => atanh z - z) (fun z => / (1 - z ^ 2) - 1)); [exact Hy | lra | |].
    - intros z Hz. apply (is_derive_minus (V := R_NormedModule) atanh (fun z => z)); [apply D, Hz | apply (is_derive_id (K := R_AbsRing))].
    - intros z Hz. replace (/ (1 - z ^ 2) - 1) with (z ^ 2 / (1 - z ^ 2)) by (field; nra).
      apply Rmult_le_pos; [nra | apply Rlt_le, Rinv_0_lt_compat; nra]. }
  assert (Most : 0 <= y + y ^ 3 / 2 - atanh y).
  { apply (from_zero (fun z => z + z ^ 3 / 2 - atanh z) (fun z => 1 + 3 * z ^ 2 / 2 - / (1 - z ^ 2))); [exact Hy | lra | |].
    - intros z Hz. apply (is_derive_minus (V := R_NormedModule) (fun z => z + z ^ 3 / 2) atanh); [| apply D, Hz].
      auto_derive; [trivial | field].
    - intros z Hz. replace (1 + 3 * z ^ 2 / 2 - / (1 - z ^ 2)) with (z ^ 2 * (1 - 3 * z ^ 2) / (2 * (1 - z ^ 2))) by (field; nra).
      apply Rmult_le_pos; [apply Rmult_le_pos; nra | apply Rlt_le, Rinv_0_lt_compat; nra]. }
  unfold atanh_ratio. destruct (Req_EM_T y 0) as [E | E]; [nra |].
  assert (Hp : 0 < y) by lra.
  split; apply (Rmult_le_reg_r y); try exact Hp; replace (atanh y / y * y) with (atanh y) by (field; lra); nra.
Qed.
Lemma atanh_ratio_even y : -1 < y < 1 -> atanh_ratio (- y) = atanh_ratio y.
Proof.
  intros Hy. unfold atanh_ratio. destruct (Req_EM_T (- y) 0), (Req_EM_T y 0); try lra.
  assert (E : atanh (- y) = - atanh y); [| rewrite E; field; lra].
  unfold atanh. replace ((1 + - y) / (1 - - y)) with (/ ((1 + y) / (1 - y))) by (field; lra).
  rewrite ln_Rinv; [ring |]. apply Rmult_lt_0_compat; [lra | apply Rinv_0_lt_compat; lra].
Qed.
Lemma atanh_ratio_near y e : y ^ 2 <= e -> e <= 1 / 4 -> 1 <= atanh_ratio y <= 1 + e / 2.
Proof.
  intros Hy He. destruct (Rle_dec 0 y); [apply atanh_ratio_near_0; lra |].
  rewrite <- atanh_ratio_even by nra. apply atanh_ratio_near_0; nra.
Qed.

Lemma scaled_within q K S t : 0 < q -> Rabs (K - S) <= t * K -> Rabs (q * K - q * S) <= t * (q * K).
Proof. intros Hq H. rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_pos_eq q) by lra. nra. Qed.

Lemma atanh_rises y z : 0 <= y <= z -> z < 1 -> atanh y <= atanh z.
Proof.
  intros H Hz. unfold atanh. apply Rmult_le_compat_l; [lra |]. apply ln_le; [apply Rdiv_lt_0_compat; lra |].
  unfold Rdiv. apply Rmult_le_compat; [lra | apply Rlt_le, Rinv_0_lt_compat; lra | lra |].
  apply Rinv_le_contravar; lra.
Qed.
(* The pressure falls with the distance x from the apex. *)
Lemma proportional_falls K g c x z : 0 < K -> 0 < g -> 0 < x <= z -> z < c ->
  0 <= proportional_pressure K g c z <= proportional_pressure K g c x.
Proof.
  intros HK Hg Hx Hz. assert (Hpi := PI_RGT_0). assert (Hq : 0 < sqrt g) by (apply sqrt_lt_R0, Hg).
  assert (Positive : 0 < 2 * K / (PI * sqrt g)) by (apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]).
  assert (Hw : forall s, 0 < s -> 0 < sqrt (s + g * c)) by (intros s Hs; apply sqrt_lt_R0; nra).
  set (y := fun s => sqrt g * sqrt (c - s) / sqrt (s + g * c)).
  assert (Hy : forall s, 0 < s < c -> 0 <= y s).
  { intros s Hs. apply Rmult_le_pos; [apply Rmult_le_pos; apply sqrt_pos | apply Rlt_le, Rinv_0_lt_compat, Hw; lra]. }
  assert (Falls : y z <= y x).
  { unfold y, Rdiv. apply Rmult_le_compat.
    - apply Rmult_le_pos; apply sqrt_pos.
    - apply Rlt_le, Rinv_0_lt_compat, Hw; lra.
    - apply Rmult_le_compat_l; [lra |]. apply sqrt_le_1_alt; lra.
    - apply Rinv_le_contravar; [apply Hw; lra | apply sqrt_le_1_alt; lra]. }
  assert (Less : y x < 1).
  { unfold y. apply (Rmult_lt_reg_r (sqrt (x + g * c))); [apply Hw; lra |]. unfold Rdiv.
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_1_l by (apply Rgt_not_eq, Hw; lra).
    rewrite <- sqrt_mult by lra. apply sqrt_lt_1_alt. nra. }
  unfold proportional_pressure. fold (y z) (y x). assert (P := Hy z ltac:(lra)). split.
  - apply Rmult_le_pos; [lra |]. rewrite <- atanh_0. apply atanh_rises; lra.
  - apply Rmult_le_compat_l; [lra |]. apply atanh_rises; lra.
Qed.

(* proportional_pressure at the distance u from the edge, over the root of u. *)
Definition proportional_scaled (K g c u : R) : R :=
  2 * K / (PI * sqrt g) * (sqrt g / sqrt ((1 + g) * c - u) * atanh_ratio (sqrt u * (sqrt g / sqrt ((1 + g) * c - u)))).
Lemma proportional_near K g c u : 0 < g -> 0 < u < c ->
  proportional_pressure K g c (c - u) = sqrt u * proportional_scaled K g c u.
Proof.
  intros Hg Hu. unfold proportional_pressure, proportional_scaled.
  replace (c - (c - u)) with u by ring. replace (c - u + g * c) with ((1 + g) * c - u) by ring.
  assert (Hw : 0 < sqrt ((1 + g) * c - u)) by (apply sqrt_lt_R0; nra).
  replace (sqrt g * sqrt u / sqrt ((1 + g) * c - u)) with (sqrt u * (sqrt g / sqrt ((1 + g) * c - u))) by (field; lra).
  rewrite (atanh_of_ratio (sqrt u * (sqrt g / sqrt ((1 + g) * c - u)))). ring.
Qed.
