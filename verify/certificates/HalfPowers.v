(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges Tactics Expansions.
Open Scope R_scope.

(* f = T + o(eps^(n - 1/2)): expansions in eps^(-1/2), eps^(1/2), ... are stated with both sides
   times the root of eps. *)
Definition agrees_in_halves (n : nat) (f T : R -> R) : Prop :=
  agrees_through n (fun eps => sqrt eps * f eps) (fun eps => sqrt eps * T eps).

Lemma agrees_near n f T g Q d : 0 < d -> (forall u, 0 < u < d -> f u = g u /\ T u = Q u) ->
  agrees_through n f T -> agrees_through n g Q.
Proof.
  intros Hd E H c Hc. destruct (H c Hc) as [e [He Hb]]. exists (Rmin d e). split; [apply Rmin_pos; assumption |].
  intros u Hu. generalize (Rmin_l d e) (Rmin_r d e). intros.
  destruct (E u ltac:(lra)) as [<- <-]. apply Hb. lra.
Qed.
Lemma agrees_trans n f T Q : agrees_through n f T -> agrees_through n T Q -> agrees_through n f Q.
Proof.
  intros HT HQ c Hc. destruct (HT (c / 2) ltac:(lra)) as [d [Hd Hb]]. destruct (HQ (c / 2) ltac:(lra)) as [e [He Hb']].
  exists (Rmin d e). split; [apply Rmin_pos; assumption |]. intros u Hu.
  generalize (Rmin_l d e) (Rmin_r d e). intros.
  replace (f u - Q u) with ((f u - T u) + (T u - Q u)) by ring.
  apply (Rle_trans _ _ _ (Rabs_triang _ _)). assert (H1 := Hb u ltac:(lra)). assert (H2 := Hb' u ltac:(lra)). lra.
Qed.
Lemma agrees_sym n f T : agrees_through n f T -> agrees_through n T f.
Proof.
  intros H c Hc. destruct (H c Hc) as [d [Hd Hb]]. exists d. split; [exact Hd |].
  intros u Hu. rewrite Rabs_minus_sym. apply Hb, Hu.
Qed.

Lemma agrees_equal n f T : (forall u, 0 < u -> f u = T u) -> agrees_through n f T.
Proof.
  intros E c Hc. exists 1. split; [lra |]. intros u Hu. rewrite E by lra. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity.
  assert (0 <= u ^ n) by (apply pow_le; lra). nra.
Qed.

(* ---- The root of a quotient ---- *)

Lemma quadratic_near (g0 g1 g2 : R) : 0 < g0 -> exists d, 0 < d /\
  forall u, - d < u < d -> g0 / 2 < g0 + g1 * u + g2 * u ^ 2.
Proof.
  intros H0. set (k := Rabs g1 + Rabs g2). exists (Rmin 1 (g0 / 2 / (1 + k))).
  assert (Hk : 0 <= k) by (unfold k; generalize (Rabs_pos g1) (Rabs_pos g2); lra).
  assert (Hq : 0 < g0 / 2 / (1 + k)) by (apply Rdiv_lt_0_compat; lra).
  split; [apply Rmin_pos; lra |]. intros u Hu. generalize (Rmin_l 1 (g0 / 2 / (1 + k))) (Rmin_r 1 (g0 / 2 / (1 + k))). intros.
  assert (Hau : Rabs u < g0 / 2 / (1 + k)) by (apply Rabs_def1; lra).
  assert (Hau1 : Rabs u < 1) by (apply Rabs_def1; lra).
  apply (Rmult_lt_compat_r (1 + k)) in Hau; [| lra].
  replace (g0 / 2 / (1 + k) * (1 + k)) with (g0 / 2) in Hau by (field; lra).
  assert (Hp := Rabs_pos u).
  assert (B : Rabs (g1 * u + g2 * u ^ 2) <= Rabs u * k).
  { apply (Rle_trans _ _ _ (Rabs_triang _ _)). rewrite !Rabs_mult, <- RPow_abs. unfold k.
    assert (Rabs u ^ 2 <= Rabs u) by nra. generalize (Rabs_pos g1) (Rabs_pos g2). intros. nra. }
  assert (Hb : Rabs (g1 * u + g2 * u ^ 2) < g0 / 2) by nra.
  apply Rabs_def2 in Hb. lra.
Qed.

Lemma inverse_root_taylor (g0 g1 g2 : R) : 0 < g0 ->
  agrees_through 2 (fun u => 1 / sqrt (g0 + g1 * u + g2 * u ^ 2))
    (fun u => 1 / sqrt g0 + - (g1 / (2 * (g0 * sqrt g0))) * u
      + (3 * g1 ^ 2 / (8 * (g0 ^ 2 * sqrt g0)) - g2 / (2 * (g0 * sqrt g0))) * u ^ 2).
Proof.
  intros H0. destruct (quadratic_near g0 g1 g2 H0) as [d [Hd Hq]].
  assert (Hr : forall u, - d < u < d -> 0 < sqrt (g0 + g1 * u + g2 * u ^ 2)).
  { intros u Hu. apply sqrt_lt_R0. specialize (Hq u Hu). lra. }
  assert (E0 : g0 + g1 * 0 + g2 * 0 ^ 2 = g0) by ring.
  apply (taylor_2 _ (fun u => - (g1 + 2 * g2 * u) /
    (2 * ((g0 + g1 * u + g2 * u ^ 2) * sqrt (g0 + g1 * u + g2 * u ^ 2)))) _ _ _ d Hd).
  - rewrite E0. reflexivity.
  - intros u Hu. specialize (Hr u Hu). specialize (Hq u Hu). auto_derive;
      change (g0 + g1 * u + g2 * (u * (u * 1))) with (g0 + g1 * u + g2 * u ^ 2).
    + repeat split; lra.
    + set (w := g0 + g1 * u + g2 * u ^ 2) in *. assert (E : w = sqrt w * sqrt w) by (symmetry; apply sqrt_sqrt; lra).
      set (q := sqrt w) in *. clearbody q w. subst w. field. lra.
  - rewrite E0. field. split; [apply Rgt_not_eq, sqrt_lt_R0, H0 | lra].
  - specialize (Hr 0 ltac:(lra)). specialize (Hq 0 ltac:(lra)). rewrite E0 in *. auto_derive;
      replace (g0 + g1 * 0 + g2 * (0 * (0 * 1))) with g0 by ring.
    + repeat split; try lra. apply Rgt_not_eq. repeat apply Rmult_lt_0_compat; lra.
    + assert (E : g0 = sqrt g0 * sqrt g0) by (symmetry; apply sqrt_sqrt; lra).
      set (q := sqrt g0) in *. clearbody q. clear Hd Hq E0. subst g0. field. lra.
Qed.

Lemma inverse_roots_near m A B : 0 < m -> m <= A -> m <= B -> Rabs (1 / sqrt A - 1 / sqrt B) <= Rabs (A - B) * (1 / (2 * (m * sqrt m))).
Proof.
  intros Hm HA HB.
  assert (Hs : 0 < sqrt m) by (apply sqrt_lt_R0, Hm).
  assert (Ha : sqrt m <= sqrt A) by (apply sqrt_le_1_alt, HA). assert (Hb : sqrt m <= sqrt B) by (apply sqrt_le_1_alt, HB).
  assert (EA : A = sqrt A * sqrt A) by (symmetry; apply sqrt_sqrt; lra).
  assert (EB : B = sqrt B * sqrt B) by (symmetry; apply sqrt_sqrt; lra).
  assert (Em : m = sqrt m * sqrt m) by (symmetry; apply sqrt_sqrt; lra).
  set (p := sqrt A) in *. set (q := sqrt B) in *. set (r := sqrt m) in *. clearbody p q r. subst A B m.
  assert (H : 1 / p - 1 / q = - (p * p - q * q) * / (p * q * (p + q))) by (field; repeat split; nra).
  rewrite H, Rabs_mult, Rabs_Ropp. apply Rmult_le_compat_l; [apply Rabs_pos |].
  assert (0 < p * q * (p + q)) by (repeat apply Rmult_lt_0_compat; lra).
  rewrite Rabs_pos_eq by (left; apply Rinv_0_lt_compat; assumption).
  unfold Rdiv. rewrite Rmult_1_l. apply Rinv_le_contravar; [repeat apply Rmult_lt_0_compat; lra |].
  assert (r * r <= p * q) by nra. nra.
Qed.

(* 1 / sqrt D, where D = g0 u + g1 u^2 + g2 u^3 + o(u^3). *)
Lemma inverse_root_of D g0 g1 g2 : 0 < g0 ->
  agrees_through 3 D (fun u => 0 + g0 * u + g1 * u ^ 2 + g2 * u ^ 3) ->
  agrees_through 2 (fun u => sqrt u * (1 / sqrt (D u)))
    (fun u => 1 / sqrt g0 + - (g1 / (2 * (g0 * sqrt g0))) * u
      + (3 * g1 ^ 2 / (8 * (g0 ^ 2 * sqrt g0)) - g2 / (2 * (g0 * sqrt g0))) * u ^ 2).
Proof.
  intros H0 HD. refine (agrees_trans _ _ _ _ _ (inverse_root_taylor g0 g1 g2 H0)).
  destruct (quadratic_near g0 g1 g2 H0) as [d [Hd Hq]].
  set (m := g0 / 4). set (L := 1 / (2 * (m * sqrt m))). assert (Hm : 0 < m) by (unfold m; lra).
  assert (HL : 0 < L) by (unfold L; assert (0 < sqrt m) by (apply sqrt_lt_R0, Hm); apply Rdiv_lt_0_compat; nra).
  intros c Hc. destruct (HD (Rmin m (c / L)) ltac:(apply Rmin_pos; [lra | apply Rdiv_lt_0_compat; lra])) as [e [He Hb]].
  exists (Rmin (Rmin d 1) e). split; [repeat apply Rmin_pos; lra |]. intros u Hu.
  generalize (Rmin_l (Rmin d 1) e) (Rmin_r (Rmin d 1) e) (Rmin_l d 1) (Rmin_r d 1). intros.
  specialize (Hb u ltac:(lra)). specialize (Hq u ltac:(lra)).
  set (q := g0 + g1 * u + g2 * u ^ 2) in *.
  assert (B : Rabs (D u / u - q) <= Rmin m (c / L) * u ^ 2).
  { replace (D u / u - q) with ((D u - (0 + g0 * u + g1 * u ^ 2 + g2 * u ^ 3)) * / u) by (unfold q; field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq (/ u)) by (left; apply Rinv_0_lt_compat; lra).
    replace (Rmin m (c / L) * u ^ 2) with (Rmin m (c / L) * u ^ 3 * / u) by (field; lra).
    apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra | exact Hb]. }
  assert (Hu2 : 0 <= u ^ 2 <= 1) by (simpl; nra).
  generalize (Rmin_l m (c / L)) (Rmin_r m (c / L)). intros Hl Hr.
  assert (Hpos : 0 < Rmin m (c / L)) by (apply Rmin_pos; [lra | apply Rdiv_lt_0_compat; lra]).
  assert (Bm : Rabs (D u / u - q) <= m) by nra.
  assert (HDu : m <= D u / u). { unfold m in *. assert (T := Rcomplements.Rabs_le_between (D u / u - q) (g0 / 4)). destruct T as [T _]. specialize (T Bm). lra. }
  assert (E : sqrt u * (1 / sqrt (D u)) = 1 / sqrt (D u / u)).
  { assert (HDp : 0 < D u). { replace (D u) with (D u / u * u) by (field; lra). apply Rmult_lt_0_compat; lra. }
    rewrite sqrt_div_alt by lra. field. split; apply Rgt_not_eq, sqrt_lt_R0; lra. }
  rewrite E. apply (Rle_trans _ _ _ (inverse_roots_near m _ q Hm HDu ltac:(unfold m; lra))). fold L.
  apply (Rle_trans _ (Rmin m (c / L) * u ^ 2 * L)); [apply Rmult_le_compat_r; lra |].
  replace (c * u ^ 2) with (c / L * u ^ 2 * L) by (field; lra).
  apply Rmult_le_compat_r; [lra |]. apply Rmult_le_compat_r; lra.
Qed.

(* What is printed as k A(u)^(-1/2), where A is a polynomial: its coefficients follow from those of the
   expansion. *)
Lemma power_m1_2 x : 0 < x -> Rpower x (- (1 / 2)) = 1 / sqrt x.
Proof.
  intros H. rewrite Rpower_Ropp. replace (1 / 2) with (/ 2) by field.
  rewrite Rpower_sqrt by exact H. unfold Rdiv. ring.
Qed.
Lemma expanded_root T A k k1 k2 : k <> 0 ->
  (forall u, 0 < u -> sqrt u * T u = k * Rpower (A u) (- (1 / 2))) ->
  (forall u, A u = 1 + - (2 * k1 / k) * u + (3 * k1 ^ 2 / k ^ 2 - 2 * k2 / k) * u ^ 2) ->
  agrees_through 2 (fun u => sqrt u * T u) (fun u => k + k1 * u + k2 * u ^ 2).
Proof.
  intros Hk HT HA. set (g1 := - (2 * k1 / k)) in *. set (g2 := 3 * k1 ^ 2 / k ^ 2 - 2 * k2 / k) in *.
  destruct (quadratic_near 1 g1 g2 Rlt_0_1) as [d [Hd Hq]].
  assert (H := inverse_root_taylor 1 g1 g2 Rlt_0_1). rewrite sqrt_1 in H.
  intros c Hc. assert (Hka := Rabs_pos_lt k Hk).
  destruct (H (c / Rabs k) ltac:(apply Rdiv_lt_0_compat; lra)) as [e [He Hb]].
  exists (Rmin d e). split; [apply Rmin_pos; lra |]. intros u Hu. generalize (Rmin_l d e) (Rmin_r d e). intros.
  rewrite HT, HA by lra. specialize (Hq u ltac:(lra)). specialize (Hb u ltac:(lra)).
  rewrite power_m1_2 by lra.
  set (z := 1 / sqrt (1 + g1 * u + g2 * u ^ 2)) in *. clearbody z.
  match type of Hb with Rabs (_ - ?t) <= _ =>
    replace (k * z - (k + k1 * u + k2 * u ^ 2)) with (k * (z - t)) by (unfold g1, g2; field; exact Hk) end.
  rewrite Rabs_mult. apply (Rmult_le_compat_l (Rabs k)) in Hb; [| lra].
  replace (Rabs k * (c / Rabs k * u ^ 2)) with (c * u ^ 2) in Hb by (field; lra). exact Hb.
Qed.

(* An equation in whole and half powers of positive numbers: over the rationals in their roots. *)
Ltac root_out w :=
  let q := fresh "q" in let H := fresh "H" in let E := fresh "E" in
  assert (H : 0 < sqrt w) by (apply sqrt_lt_R0; lra);
  assert (E : sqrt w ^ 2 = w) by (apply pow2_sqrt; lra);
  set (q := sqrt w) in *; clearbody q;
  lazymatch w with
  | 2 => idtac
  | 1 - ?s => let F := fresh in assert (F : s = 1 - q ^ 2) by lra; clear E; subst s
  | ?x + ?y => let r := fresh "r" in let F := fresh in
      set (r := y) in *; clearbody r; assert (F : r = q ^ 2 - x) by lra; clear E; subst r
  | _ => subst w
  end.
Ltac half_powers :=
  repeat match goal with H : agrees_through _ _ _ |- _ => clear H | H : agrees_in_halves _ _ _ |- _ => clear H
    | H : _ <> _ |- _ => clear H | H : @eq R _ _ |- _ => clear H end;
  rewrite ?power_m1_2, ?power_3_2, ?power_5_2 by lra; rewrite ?sqrt_mult by lra; rewrite ?sqrt_1;
  repeat match goal with |- context [sqrt ?w] => root_out w end;
  first [ match goal with H : ?q ^ 2 = 2 |- _ => field_simplify_eq; [ring [H] | repeat split; nra] end
        | field; repeat split; nra ].
(* The printed side, as a polynomial. *)
Ltac in_half_powers :=
  first [ apply agrees_equal; intros; half_powers
        | eapply expanded_root;
          [ apply Rgt_not_eq, Rdiv_lt_0_compat; [lra | apply sqrt_lt_R0; lra]
          | intros; rewrite <- Rmult_assoc; apply (f_equal2 Rmult); [half_powers | reflexivity]
          | intros; cbv beta; half_powers ] ].

Section LeftEdge.
Variables (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R).
Hypothesis contact : is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2.
Hypothesis left : is_left_edge a b b1 b2 b3 alpha.

Ltac known f s d H := replace (Derive (fun x : R => f x) s) with d by (symmetry; apply is_derive_unique; exact H).

(* x + b(a + (b^-1(-x) - a) sigma), x = -b + eps X *)
Lemma width_through_3 X sigma : agrees_through 3 (fun eps => - b a + eps * X + b (a + (alpha ((b a) - eps * X) - a) * sigma))
  (fun u => 0 + X * (1 - sigma) * u + - (X ^ 2 * sigma * (1 - sigma) * b2 a / (2 * b1 a ^ 2)) * u ^ 2
    + X ^ 3 * sigma * (1 - sigma) * ((1 + sigma) * b3 a / (6 * b1 a ^ 3) - b2 a ^ 2 / (2 * b1 a ^ 4)) * u ^ 3).
Proof.
  assert (contact' := contact). destruct contact' as [e1 [He1 H1]]. assert (left' := left). destruct left' as [inverse [e2 [He2 [H2 _]]]].
  set (e := Rmin (Rmin e1 e2 / (1 + Rabs sigma)) (Rmin e1 e2)).
  assert (Hmp : 0 < Rmin e1 e2) by (apply Rmin_pos; lra).
  assert (He : 0 < e) by (generalize (Rabs_pos sigma); intros; apply Rmin_pos; try lra; apply Rdiv_lt_0_compat; lra).
  destruct (inverse_near a b b1 b2 b3 alpha left e He) as [d0 [Hd0 H]].
  assert (Hm1 := Rmin_l (Rmin e1 e2 / (1 + Rabs sigma)) (Rmin e1 e2)). assert (Hm2 := Rmin_r (Rmin e1 e2 / (1 + Rabs sigma)) (Rmin e1 e2)).
  fold e in Hm1, Hm2. generalize (Rmin_l e1 e2) (Rmin_r e1 e2). intros Hm3 Hm4.
  set (d := d0 / (1 + Rabs X)). assert (Hd : 0 < d) by (generalize (Rabs_pos X); intros; apply Rdiv_lt_0_compat; lra).
  assert (E0 : b a - 0 * X = b a) by ring.
  set (s u := a + (alpha (b a - u * X) - a) * sigma).
  assert (N : forall u, - d < u < d -> 0 < b1 (alpha (b a - u * X)) /\ is_derive alpha (b a - u * X) (/ b1 (alpha (b a - u * X))) /\
    is_derive b1 (alpha (b a - u * X)) (b2 (alpha (b a - u * X))) /\ is_derive b2 (alpha (b a - u * X)) (b3 (alpha (b a - u * X))) /\
    is_derive b (s u) (b1 (s u)) /\ is_derive b1 (s u) (b2 (s u)) /\ is_derive b2 (s u) (b3 (s u))).
  { intros u Hu. assert (Hs := small u X d0 Hd0 Hu). destruct (H (b a - u * X) ltac:(lra)) as [Ha Hda].
    assert (Hss := small (alpha (b a - u * X) - a) sigma (Rmin e1 e2) Hmp ltac:(lra)).
    destruct (H1 (alpha (b a - u * X)) ltac:(lra)) as (_ & _ & _ & _ & _ & Hb1 & _).
    destruct (H1 (s u) ltac:(unfold s; lra)) as (_ & _ & _ & _ & Hbs & Hb1s & _).
    destruct (H2 (alpha (b a - u * X)) ltac:(lra)) as (Hp & Hb2 & _).
    destruct (H2 (s u) ltac:(unfold s; lra)) as (_ & Hb2s & _).
    exact (conj Hp (conj Hda (conj Hb1 (conj Hb2 (conj Hbs (conj Hb1s Hb2s)))))). }
  assert (S0 : s 0 = a) by (unfold s; rewrite E0, inverse; ring).
  apply (taylor_3 _ (fun u => X - sigma * X * b1 (s u) / b1 (alpha (b a - u * X)))
    (fun u => sigma ^ 2 * X ^ 2 * b2 (s u) / b1 (alpha (b a - u * X)) ^ 2
      - sigma * X ^ 2 * b1 (s u) * b2 (alpha (b a - u * X)) / b1 (alpha (b a - u * X)) ^ 3) _ _ _ _ d Hd).
  - fold (s 0). rewrite S0. ring.
  - intros u Hu. destruct (N u Hu) as (Hp & Ha & Hb1 & Hb2 & Hbs & _). unfold s in *. auto_derive;
      change (b a + - (u * X)) with (b a - u * X); change (alpha (b a - u * X) + - a) with (alpha (b a - u * X) - a).
    + repeat split; eexists; eassumption.
    + known alpha (b a - u * X) (/ b1 (alpha (b a - u * X))) Ha.
      match type of Hbs with is_derive _ ?x ?y => known b x y Hbs end. field. lra.
  - destruct (N 0 ltac:(lra)) as (Hp & _). rewrite S0, E0, inverse in *. field. lra.
  - intros u Hu. destruct (N u Hu) as (Hp & Ha & Hb1 & Hb2 & Hbs & Hb1s & _). unfold s in *. auto_derive;
      change (b a + - (u * X)) with (b a - u * X); change (alpha (b a - u * X) + - a) with (alpha (b a - u * X) - a).
    + repeat split; try (eexists; eassumption); lra.
    + known alpha (b a - u * X) (/ b1 (alpha (b a - u * X))) Ha.
      known b1 (alpha (b a - u * X)) (b2 (alpha (b a - u * X))) Hb1.
      match type of Hb1s with is_derive _ ?x ?y => known b1 x y Hb1s end. field. lra.
  - destruct (N 0 ltac:(lra)) as (Hp & _). rewrite S0, E0, inverse in *. field. lra.
  - destruct (N 0 ltac:(lra)) as (Hp & Ha & Hb1 & Hb2 & Hbs & Hb1s & Hb2s). unfold s in *. auto_derive;
      change (b a + - (0 * X)) with (b a - 0 * X); change (alpha (b a - 0 * X) + - a) with (alpha (b a - 0 * X) - a).
    + assert (0 < b1 (alpha (b a - 0 * X)) ^ 3) by (apply pow_lt, Hp).
      assert (0 < b1 (alpha (b a - 0 * X)) ^ 2) by (apply pow_lt, Hp).
      repeat split; try (eexists; eassumption); apply Rgt_not_eq; assumption.
    + known alpha (b a - 0 * X) (/ b1 (alpha (b a - 0 * X))) Ha.
      known b1 (alpha (b a - 0 * X)) (b2 (alpha (b a - 0 * X))) Hb1.
      known b2 (alpha (b a - 0 * X)) (b3 (alpha (b a - 0 * X))) Hb2.
      match type of Hb1s with is_derive _ ?x ?y => known b1 x y Hb1s; known b2 x (b3 x) Hb2s end.
      rewrite S0, E0, inverse in *. field. lra.
Qed.

Theorem inverse_root_through_2 X sigma : 0 < X -> 0 < sigma < 1 ->
  agrees_through 2 (fun eps => sqrt eps * (1 / sqrt (- b a + eps * X + b (a + (alpha ((b a) - eps * X) - a) * sigma))))
    (fun u => 1 / (sqrt X * sqrt (1 - sigma)) + b2 a * sigma * sqrt X / (4 * b1 a ^ 2 * sqrt (1 - sigma)) * u
      + sigma * (X * sqrt X) * (24 * b2 a ^ 2 + 9 * b2 a ^ 2 * sigma - 8 * b1 a * b3 a - 8 * b1 a * b3 a * sigma)
        / (96 * b1 a ^ 4 * sqrt (1 - sigma)) * u ^ 2).
Proof.
  intros HX Hs. assert (Hb := rate_positive _ _ _ _ _ _ left).
  assert (Hg : 0 < X * (1 - sigma)) by (apply Rmult_lt_0_compat; lra).
  assert (T := inverse_root_of _ _ _ _ Hg (width_through_3 X sigma)).
  apply (agrees_ext _ _ _ _ T). intros u. rewrite sqrt_mult by lra.
  assert (Hx := sqrt_lt_R0 X HX). assert (Hr := sqrt_lt_R0 (1 - sigma) ltac:(lra)).
  assert (EX : X = sqrt X * sqrt X) by (symmetry; apply sqrt_sqrt; lra).
  assert (ER : sigma = 1 - sqrt (1 - sigma) * sqrt (1 - sigma)) by (rewrite sqrt_sqrt; lra).
  set (x := sqrt X) in *. set (r := sqrt (1 - sigma)) in *. clearbody x r. subst X sigma. field. lra.
Qed.
Theorem inverse_root_at_1 sigma : 0 < sigma < 1 ->
  agrees_through 2 (fun eps => sqrt eps * (1 / sqrt (- b a + eps + b (a + (alpha ((b a) - eps) - a) * sigma))))
    (fun u => 1 / sqrt (1 - sigma) + b2 a * sigma / (4 * b1 a ^ 2 * sqrt (1 - sigma)) * u
      + sigma * (24 * b2 a ^ 2 + 9 * b2 a ^ 2 * sigma - 8 * b1 a * b3 a - 8 * b1 a * b3 a * sigma)
        / (96 * b1 a ^ 4 * sqrt (1 - sigma)) * u ^ 2).
Proof.
  intros Hs. assert (Hb := rate_positive _ _ _ _ _ _ left). assert (Hr := sqrt_lt_R0 (1 - sigma) ltac:(lra)).
  refine (agrees_near _ _ _ _ _ 1 Rlt_0_1 _ (inverse_root_through_2 1 sigma Rlt_0_1 Hs)).
  intros u _. rewrite !Rmult_1_r, sqrt_1. split; [reflexivity | field; lra].
Qed.
End LeftEdge.
