(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric TiltedWedge Unique Tactics.
Open Scope R_scope.

(* ---- The first terms at an edge lie below the pressure of a wedge ---- *)

(* A function that is 0 at 0 and rises is positive. *)
Lemma rises_from_zero (f f1 : R -> R) c : 0 < c -> f 0 = 0 ->
  (forall s, 0 <= s <= c -> is_derive f s (f1 s)) -> (forall s, 0 < s <= c -> 0 < f1 s) -> 0 < f c.
Proof.
  intros Hc H0 Hd Hp.
  destruct (MVT_cor2 f f1 0 c Hc) as (s & E & Hs).
  - intros s Hs. apply is_derive_Reals, Hd, Hs.
  - assert (P := Hp s ltac:(lra)). rewrite H0 in E. nra.
Qed.

Lemma below_root z : 0 <= z < 1 -> 1 + z / 2 + 3 * z ^ 2 / 8 <= / sqrt (1 - z).
Proof.
  intros Hz. assert (Hq : 0 < sqrt (1 - z)) by (apply sqrt_lt_R0; lra).
  assert (E : sqrt (1 - z) * sqrt (1 - z) = 1 - z) by (apply sqrt_sqrt; lra).
  set (q := sqrt (1 - z)) in *. clearbody q.
  set (k := 1 + z / 2 + 3 * z ^ 2 / 8). assert (Hk : 0 < k) by (unfold k; nra).
  assert (H : (k * q) ^ 2 <= 1).
  { replace ((k * q) ^ 2) with (k ^ 2 * (q * q)) by ring. rewrite E. unfold k.
    replace ((1 + z / 2 + 3 * z ^ 2 / 8) ^ 2 * (1 - z)) with (1 - z ^ 3 * (5 / 8 + 15 * z / 64 + 9 * z ^ 2 / 64)) by field.
    assert (0 <= z ^ 3) by (apply pow_le; lra). nra. }
  assert (Hkq : 0 < k * q) by (apply Rmult_lt_0_compat; lra).
  assert (k * q <= 1) by nra.
  apply (Rmult_le_reg_r q); [exact Hq |]. rewrite Rinv_l by lra. assumption.
Qed.

Lemma below_rate v l : 0 < v < 1 -> 0 < l < 1 ->
  1 + (1 + l / 2) * v + (1 + l / 2 + 3 * l ^ 2 / 8) * v ^ 2 < / ((1 - v) * sqrt (1 - l * v)).
Proof.
  intros Hv Hl. assert (Hz : 0 <= l * v < 1) by nra.
  assert (B := below_root (l * v) Hz).
  assert (Hq : 0 < sqrt (1 - l * v)) by (apply sqrt_lt_R0; lra).
  rewrite Rinv_mult by lra.
  assert (A : 1 + v + v ^ 2 < / (1 - v)).
  { apply (Rmult_lt_reg_r (1 - v)); [lra |]. rewrite Rinv_l by lra.
    replace ((1 + v + v ^ 2) * (1 - v)) with (1 - v ^ 3) by ring. assert (0 < v ^ 3) by (apply pow_lt; lra). lra. }
  set (k := / sqrt (1 - l * v)) in *. set (m := / (1 - v)) in *. clearbody k m.
  apply Rle_lt_trans with ((1 + v + v ^ 2) * (1 + l * v / 2 + 3 * (l * v) ^ 2 / 8)).
  - assert (0 <= l * v ^ 3) by (apply Rmult_le_pos; [lra | apply pow_le; lra]).
    assert (0 <= l ^ 2 * v ^ 3) by (apply Rmult_le_pos; apply pow_le; lra).
    assert (0 <= l ^ 2 * v ^ 4) by (apply Rmult_le_pos; apply pow_le; lra). nra.
  - assert (0 < 1 + l * v / 2 + 3 * (l * v) ^ 2 / 8) by nra.
    apply Rle_lt_trans with ((1 + v + v ^ 2) * k); [apply Rmult_le_compat_l; nra |].
    apply Rmult_lt_compat_r; lra.
Qed.

Lemma above_root z : 0 <= z <= 1 / 2 -> / sqrt (1 - z) <= 1 + z / 2 + 3 * z ^ 2 / 8 + z ^ 3.
Proof.
  intros Hz. assert (Hq : 0 < sqrt (1 - z)) by (apply sqrt_lt_R0; lra).
  assert (E : sqrt (1 - z) * sqrt (1 - z) = 1 - z) by (apply sqrt_sqrt; lra).
  set (q := sqrt (1 - z)) in *. clearbody q.
  assert (0 <= z ^ 2) by (apply pow_le; lra). assert (0 <= z ^ 3) by (apply pow_le; lra).
  set (k := 1 + z / 2 + 3 * z ^ 2 / 8 + z ^ 3). assert (Hk : 1 <= k) by (unfold k; lra).
  assert (H1 : 1 <= (k * q) ^ 2).
  { replace ((k * q) ^ 2) with (k ^ 2 * (q * q)) by ring. rewrite E. unfold k.
    replace ((1 + z / 2 + 3 * z ^ 2 / 8 + z ^ 3) ^ 2 * (1 - z))
      with (1 + z ^ 3 * (11 / 8 - 79 / 64 * z - 25 / 64 * z ^ 2 + z ^ 3 / 4 - z ^ 4)) by field.
    assert (z ^ 2 <= 1 / 4) by nra. assert (z ^ 4 <= 1 / 16) by (replace (z ^ 4) with (z ^ 2 * z ^ 2) by ring; nra).
    assert (0 <= 11 / 8 - 79 / 64 * z - 25 / 64 * z ^ 2 + z ^ 3 / 4 - z ^ 4) by lra.
    assert (0 <= z ^ 3 * (11 / 8 - 79 / 64 * z - 25 / 64 * z ^ 2 + z ^ 3 / 4 - z ^ 4)) by (apply Rmult_le_pos; assumption). lra. }
  assert (Hkq : 0 < k * q) by (apply Rmult_lt_0_compat; lra).
  assert (1 <= k * q) by nra. apply (Rmult_le_reg_r q); [exact Hq |]. rewrite Rinv_l by lra. assumption.
Qed.
Lemma above_rate v l : 0 < v <= 1 / 2 -> 0 < l < 1 ->
  / ((1 - v) * sqrt (1 - l * v)) - (1 + (1 + l / 2) * v + (1 + l / 2 + 3 * l ^ 2 / 8) * v ^ 2) < 6 * v ^ 3.
Proof.
  intros Hv Hl. assert (Hz : 0 <= l * v <= 1 / 2) by nra. assert (B := above_root (l * v) Hz).
  assert (Hq : 0 < sqrt (1 - l * v)) by (apply sqrt_lt_R0; lra). rewrite Rinv_mult by lra.
  assert (A : / (1 - v) <= 1 + v + v ^ 2 + 2 * v ^ 3).
  { apply (Rmult_le_reg_r (1 - v)); [lra |]. rewrite Rinv_l by lra.
    replace ((1 + v + v ^ 2 + 2 * v ^ 3) * (1 - v)) with (1 + v ^ 3 * (1 - 2 * v)) by ring.
    assert (0 <= v ^ 3) by (apply pow_le; lra). assert (0 <= v ^ 3 * (1 - 2 * v)) by (apply Rmult_le_pos; lra). lra. }
  assert (I1 : 0 < / (1 - v)) by (apply Rinv_0_lt_compat; lra). assert (I2 := Rinv_0_lt_compat _ Hq).
  set (k := / sqrt (1 - l * v)) in *. set (m := / (1 - v)) in *. clearbody k m.
  assert (C : m * k <= (1 + v + v ^ 2 + 2 * v ^ 3) * (1 + l * v / 2 + 3 * (l * v) ^ 2 / 8 + (l * v) ^ 3)) by (apply Rmult_le_compat; lra).
  apply (Rle_lt_trans _ _ _ (Rplus_le_compat_r _ _ _ C)).
  assert (L2 : 0 < l ^ 2 < 1) by nra. assert (L3 : 0 < l ^ 3 < 1) by (replace (l ^ 3) with (l ^ 2 * l) by ring; nra).
  assert (V3 : 0 < v ^ 3) by (apply pow_lt; lra). assert (V2 : 0 < v ^ 2 <= 1 / 4) by nra. assert (V33 : v ^ 3 <= 1 / 8) by (replace (v ^ 3) with (v ^ 2 * v) by ring; nra).
  replace ((1 + v + v ^ 2 + 2 * v ^ 3) * (1 + l * v / 2 + 3 * (l * v) ^ 2 / 8 + (l * v) ^ 3) + - (1 + (1 + l / 2) * v + (1 + l / 2 + 3 * l ^ 2 / 8) * v ^ 2))
    with (v ^ 3 * ((2 + l / 2 + 3 / 8 * l ^ 2 + l ^ 3) + (l + 3 / 8 * l ^ 2 + l ^ 3) * v + (3 / 4 * l ^ 2 + l ^ 3) * v ^ 2 + 2 * l ^ 3 * v ^ 3)) by field.
  rewrite (Rmult_comm 6). apply Rmult_lt_compat_l; [exact V3 |].
  assert ((l + 3 / 8 * l ^ 2 + l ^ 3) * v <= 19 / 8 * (1 / 2)) by (apply Rmult_le_compat; lra).
  assert ((3 / 4 * l ^ 2 + l ^ 3) * v ^ 2 <= 7 / 4 * (1 / 4)) by (apply Rmult_le_compat; lra).
  assert (2 * l ^ 3 * v ^ 3 <= 2 * (1 / 8)) by (apply Rmult_le_compat; lra). lra.
Qed.

Section Below.
Variables g c : R.
Hypothesis Hg : 0 < g.
Hypothesis Hc : 0 < c.
Let D := (1 + g) * c.
Let y s := sqrt g * s / sqrt (D - s ^ 2).
Let l := 1 / (1 + g).
Let sum s := sqrt g / sqrt D * (s + (1 + l / 2) * s ^ 3 / (3 * c) + (1 + l / 2 + 3 * l ^ 2 / 8) * s ^ 5 / (5 * c ^ 2)).

Lemma share_range : 0 < l < 1.
Proof.
  unfold l. split; [apply Rdiv_lt_0_compat; lra |]. apply (Rmult_lt_reg_r (1 + g)); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
Let rate v := / ((1 - v) * sqrt (1 - l * v)) - (1 + (1 + l / 2) * v + (1 + l / 2 + 3 * l ^ 2 / 8) * v ^ 2).
Lemma difference_derive r : 0 <= r -> r ^ 2 < c -> is_derive (fun s => atanh (y s) - sum s) r (sqrt g / sqrt D * rate (r ^ 2 / c)).
Proof.
  intros Hr Hr2. assert (HD : 0 < D) by (unfold D; nra). assert (HrD := sqrt_lt_R0 D HD). assert (Hl := share_range). unfold rate.
  assert (HDr : 0 < D - r ^ 2) by (unfold D; nra). assert (Hq := sqrt_lt_R0 _ HDr).
  assert (E : sqrt (D - r ^ 2) * sqrt (D - r ^ 2) = D - r ^ 2) by (apply sqrt_sqrt; lra).
  assert (Eg : sqrt g * sqrt g = g) by (apply sqrt_sqrt; lra). assert (Hgr := sqrt_lt_R0 g Hg).
  assert (ED : sqrt D * sqrt D = D) by (apply sqrt_sqrt; lra).
  assert (Dy : is_derive y r (sqrt g * D / ((D - r ^ 2) * sqrt (D - r ^ 2)))).
  { unfold y. auto_derive.
    - replace (D + - (r * (r * 1))) with (D - r ^ 2) by ring. repeat split; lra.
    - replace (D + - (r * (r * 1))) with (D - r ^ 2) by ring.
      set (q := sqrt (D - r ^ 2)) in *. clearbody q. replace (D - r ^ 2) with (q * q) by exact E.
      replace D with (q * q + r ^ 2) by (rewrite E; ring). field. lra. }
  assert (Y2 : 1 - y r ^ 2 = (1 + g) * (c - r ^ 2) / (D - r ^ 2)).
  { unfold y. replace ((sqrt g * r / sqrt (D - r ^ 2)) ^ 2) with ((sqrt g * sqrt g) * r ^ 2 / (sqrt (D - r ^ 2) * sqrt (D - r ^ 2))) by (field; lra).
    rewrite Eg, E. unfold D in *. field. lra. }
  assert (P2 : 0 < 1 - y r ^ 2) by (rewrite Y2; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra).
  assert (A := atanh_derive _ _ _ r Dy eq_refl ltac:(split; nra)). cbv beta in A.
  assert (S : is_derive sum r (sqrt g / sqrt D * (1 + (1 + l / 2) * (r ^ 2 / c) + (1 + l / 2 + 3 * l ^ 2 / 8) * (r ^ 2 / c) ^ 2))).
  { unfold sum. auto_derive; [trivial |]. field. lra. }
  assert (R := is_derive_minus _ _ _ _ _ A S). cbv beta in R.
  replace (sqrt g / sqrt D * (/ ((1 - r ^ 2 / c) * sqrt (1 - l * (r ^ 2 / c))) - (1 + (1 + l / 2) * (r ^ 2 / c) + (1 + l / 2 + 3 * l ^ 2 / 8) * (r ^ 2 / c) ^ 2)))
    with (minus (sqrt g * D / ((D - r ^ 2) * sqrt (D - r ^ 2)) / (1 - y r ^ 2)) (sqrt g / sqrt D * (1 + (1 + l / 2) * (r ^ 2 / c) + (1 + l / 2 + 3 * l ^ 2 / 8) * (r ^ 2 / c) ^ 2))).
  + exact R.
  + match goal with |- minus ?p ?q = ?z => change (p - q = z) end. rewrite Y2.
    replace (1 - l * (r ^ 2 / c)) with ((D - r ^ 2) / D) by (unfold l, D; field; lra).
    rewrite sqrt_div_alt by exact HD. set (q := sqrt (D - r ^ 2)) in *. set (w := sqrt D) in *. clearbody q w.
    unfold l, D in *. field. repeat split; lra.
Qed.
Lemma share_of s : 0 < s -> s ^ 2 < c -> 0 < s ^ 2 / c < 1.
Proof.
  intros Hs H. assert (0 < s ^ 2) by (apply pow_lt; lra).
  split; [apply Rdiv_lt_0_compat; lra |]. apply (Rmult_lt_reg_r c); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
Lemma difference_at_0 : atanh (y 0) - sum 0 = 0.
Proof.
  assert (HD : 0 < D) by (unfold D; nra). assert (HrD := sqrt_lt_R0 D HD).
  unfold y, sum. rewrite Rmult_0_r. unfold Rdiv at 1. rewrite Rmult_0_l, atanh_0. field. lra.
Qed.
Lemma ratio_positive : 0 < sqrt g / sqrt D.
Proof. apply Rdiv_lt_0_compat; apply sqrt_lt_R0; [exact Hg | unfold D; nra]. Qed.

Lemma below_atanh s : 0 < s -> s ^ 2 < c -> sum s < atanh (y s).
Proof.
  intros Hs Hsc. apply Rminus_gt_0_lt. change (0 < (fun s => atanh (y s) - sum s) s).
  apply (rises_from_zero _ (fun s => sqrt g / sqrt D * rate (s ^ 2 / c)) s Hs).
  - exact difference_at_0.
  - intros r Hr. apply difference_derive; nra.
  - intros r Hr. assert (Hv := share_of r ltac:(lra) ltac:(nra)).
    apply Rmult_lt_0_compat; [exact ratio_positive |]. unfold rate. generalize (below_rate _ _ Hv share_range). lra.
Qed.
(* What the three terms leave, in the half of the contact next to the edge. *)
Lemma above_atanh s : 0 < s -> s ^ 2 <= c / 2 -> atanh (y s) < sum s + sqrt g / sqrt D * (6 * s ^ 7 / (7 * c ^ 3)).
Proof.
  intros Hs Hsc. apply Rminus_gt_0_lt.
  change (0 < (fun s => sum s + sqrt g / sqrt D * (6 * s ^ 7 / (7 * c ^ 3)) - atanh (y s)) s).
  apply (rises_from_zero _ (fun s => sqrt g / sqrt D * (6 * (s ^ 2 / c) ^ 3 - rate (s ^ 2 / c))) s Hs).
  - generalize difference_at_0. cbv beta. unfold Rdiv. rewrite pow_i by lia. lra.
  - intros r Hr. apply (is_derive_ext (fun s => sqrt g / sqrt D * (6 * s ^ 7 / (7 * c ^ 3)) - (atanh (y s) - sum s))).
    { intros z. match goal with |- @eq _ ?x ?y => change (@eq R x y) end. ring. }
    replace (sqrt g / sqrt D * (6 * (r ^ 2 / c) ^ 3 - rate (r ^ 2 / c)))
      with (minus (sqrt g / sqrt D * (6 * (r ^ 2 / c) ^ 3)) (sqrt g / sqrt D * rate (r ^ 2 / c))) by (unfold minus, plus, opp; simpl; ring).
    apply (is_derive_minus (V := R_NormedModule) (fun s => sqrt g / sqrt D * (6 * s ^ 7 / (7 * c ^ 3)))); [| apply difference_derive; nra].
    assert (HD : 0 < D) by (unfold D; nra). assert (HrD := sqrt_lt_R0 D HD). auto_derive; [trivial | field; lra].
  - intros r Hr. assert (Hv := share_of r ltac:(lra) ltac:(nra)).
    assert (Hv2 : r ^ 2 / c <= 1 / 2).
    { apply (Rmult_le_reg_r c); [lra |]. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l by lra. nra. }
    apply Rmult_lt_0_compat; [exact ratio_positive |]. unfold rate.
    generalize (above_rate (r ^ 2 / c) l ltac:(lra) share_range). lra.
Qed.
End Below.

(* The first three terms at the edge c of such a pressure: each is positive, they are below the pressure, and what they leave is known to be small. *)
Section Proportional.
Variables K g c u : R.
Hypothesis HK : 0 < K.
Hypothesis Hg : 0 < g.
Hypothesis Hu : 0 < u < c.
Let r0 := c0 (fun _ => K) (fun s => g * s) c.
Let r1 := c1 (fun _ => K) (fun _ => 0) (fun s => g * s) (fun _ => g) c.
Let r2 := c2 (fun _ => K) (fun _ => 0) (fun _ => 0) (fun s => g * s) (fun _ => g) (fun _ => 0) c.
Let sum := sqrt u + (1 + 1 / (1 + g) / 2) * sqrt u ^ 3 / (3 * c) + (1 + 1 / (1 + g) / 2 + 3 * (1 / (1 + g)) ^ 2 / 8) * sqrt u ^ 5 / (5 * c ^ 2).

Lemma three_terms_proportional : r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u) =
  2 * K / (PI * sqrt g) * (sqrt g / sqrt ((1 + g) * c) * sum).
Proof.
  assert (Hpi := PI_RGT_0). assert (HD : 0 < (1 + g) * c) by nra. assert (HrD := sqrt_lt_R0 _ HD). assert (Hgr := sqrt_lt_R0 g Hg).
  assert (Eu : sqrt u ^ 2 = u) by (apply pow2_sqrt; lra).
  unfold sum, r0, r1, r2, c0, c1, c2. replace (c + g * c) with ((1 + g) * c) by ring.
  replace (sqrt u ^ 3) with (u * sqrt u) by (rewrite <- Eu at 1; ring).
  replace (sqrt u ^ 5) with (u ^ 2 * sqrt u) by (rewrite <- Eu at 1; ring).
  field. repeat split; lra.
Qed.
Lemma below_proportional : 0 < r1 /\ 0 < r2 /\
  r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u) < proportional_pressure K g c (c - u).
Proof.
  assert (Hpi := PI_RGT_0). assert (HD : 0 < (1 + g) * c) by nra. assert (HrD := sqrt_lt_R0 _ HD). assert (Hgr := sqrt_lt_R0 g Hg).
  assert (Eu : sqrt u ^ 2 = u) by (apply pow2_sqrt; lra).
  assert (B := below_atanh g c Hg ltac:(lra) (sqrt u) ltac:(apply sqrt_lt_R0; lra) ltac:(rewrite Eu; lra)). cbv zeta beta in B. rewrite Eu in B.
  split; [| split].
  - unfold r1, c1. replace (c + g * c) with ((1 + g) * c) by ring.
    replace (2 / PI * _) with (2 * K * (1 / 2 + g / 3) / (PI * ((1 + g) * c) * sqrt ((1 + g) * c))) by (field; repeat split; lra).
    apply Rdiv_lt_0_compat; repeat first [lra | apply Rmult_lt_0_compat].
  - unfold r2, c2. replace (c + g * c) with ((1 + g) * c) by ring.
    replace (1 / PI * _) with (3 * K * (1 + 4 / 3 * g + 8 / 15 * g ^ 2) / (4 * PI * ((1 + g) * c) ^ 2 * sqrt ((1 + g) * c))) by (field; repeat split; lra).
    assert (0 < ((1 + g) * c) ^ 2) by (apply pow_lt; lra).
    apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; nra | repeat first [lra | apply Rmult_lt_0_compat]].
  - rewrite three_terms_proportional. unfold proportional_pressure.
    replace (c - (c - u)) with u by ring. replace (c - u + g * c) with ((1 + g) * c - u) by ring.
    apply Rmult_lt_compat_l; [apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra] | exact B].
Qed.
Lemma above_proportional : u <= c / 2 -> proportional_pressure K g c (c - u) <=
  r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u) + 12 * K / (7 * PI * sqrt ((1 + g) * c) * c ^ 3) * (u ^ 3 * sqrt u).
Proof.
  intros Hc. assert (Hpi := PI_RGT_0). assert (HD : 0 < (1 + g) * c) by nra. assert (HrD := sqrt_lt_R0 _ HD). assert (Hgr := sqrt_lt_R0 g Hg).
  assert (Eu : sqrt u ^ 2 = u) by (apply pow2_sqrt; lra).
  assert (B := above_atanh g c Hg ltac:(lra) (sqrt u) ltac:(apply sqrt_lt_R0; lra) ltac:(rewrite Eu; lra)). cbv zeta beta in B. rewrite Eu in B.
  rewrite three_terms_proportional. unfold proportional_pressure.
  replace (c - (c - u)) with u by ring. replace (c - u + g * c) with ((1 + g) * c - u) by ring.
  replace (2 * K / (PI * sqrt g) * (sqrt g / sqrt ((1 + g) * c) * sum) + 12 * K / (7 * PI * sqrt ((1 + g) * c) * c ^ 3) * (u ^ 3 * sqrt u))
    with (2 * K / (PI * sqrt g) * (sqrt g / sqrt ((1 + g) * c) * sum + sqrt g / sqrt ((1 + g) * c) * (6 * sqrt u ^ 7 / (7 * c ^ 3)))).
  - apply Rmult_le_compat_l; [apply Rlt_le, Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra] | unfold sum; lra].
  - replace (sqrt u ^ 7) with (u ^ 3 * sqrt u) by (rewrite <- Eu at 1; ring). field. repeat split; lra.
Qed.
End Proportional.

(* ---- Theorems about contacts ---- *)

(* The sums of one, two and three terms at the distance u from an edge. *)
Definition one_term (r0 r1 r2 u : R) : R := r0 * sqrt u.
Definition two_terms (r0 r1 r2 u : R) : R := r0 * sqrt u + r1 * (u * sqrt u).
Definition three_terms (r0 r1 r2 u : R) : R := r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u).

Definition increase_to (r0 r1 r2 u p : R) : Prop :=
  0 < one_term r0 r1 r2 u < two_terms r0 r1 r2 u /\ two_terms r0 r1 r2 u < three_terms r0 r1 r2 u < p.
Definition decrease_to (r0 r1 r2 u p : R) : Prop :=
  0 < p < three_terms r0 r1 r2 u /\ three_terms r0 r1 r2 u < two_terms r0 r1 r2 u < one_term r0 r1 r2 u.

Lemma increase_to_proportional K g c u : 0 < K -> 0 < g -> 0 < u < c ->
  increase_to (c0 (fun _ => K) (fun s => g * s) c) (c1 (fun _ => K) (fun _ => 0) (fun s => g * s) (fun _ => g) c)
    (c2 (fun _ => K) (fun _ => 0) (fun _ => 0) (fun s => g * s) (fun _ => g) (fun _ => 0) c) u
    (proportional_pressure K g c (c - u)).
Proof.
  intros HK Hg Hu. destruct (below_proportional K g c u HK Hg Hu) as (H1 & H2 & H).
  assert (Hsu : 0 < sqrt u) by (apply sqrt_lt_R0; lra). assert (0 < u * sqrt u) by (apply Rmult_lt_0_compat; lra).
  assert (0 < u ^ 2 * sqrt u) by (apply Rmult_lt_0_compat; [apply pow_lt |]; lra).
  assert (Hc0 : 0 < c0 (fun _ => K) (fun s => g * s) c).
  { unfold c0. assert (Hpi := PI_RGT_0). assert (0 < sqrt (c + g * c)) by (apply sqrt_lt_R0; nra).
    apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]. }
  unfold increase_to, one_term, two_terms, three_terms. repeat split; nra.
Qed.

Section Wedge.
Variables Es phi gam a : R.
Hypothesis form : 0 < Es /\ 0 < phi /\ 0 < gam /\ 0 < a.
Let K := Es * phi * sqrt gam.
Lemma K_positive : 0 < K.
Proof. unfold K. assert (0 < sqrt gam) by (apply sqrt_lt_R0; lra). repeat first [lra | apply Rmult_lt_0_compat]. Qed.

Theorem wedge_right : exists r0 r1 r2, is_the_right_series Es (TiltedWedge.slope phi (tilt phi gam)) a r0 r1 r2 /\
  forall u, 0 < u < a -> exists p0, is_the_pressure Es (TiltedWedge.slope phi (tilt phi gam)) a (a - u) p0 /\ increase_to r0 r1 r2 u p0.
Proof.
  eexists. eexists. eexists.
  split. { apply (the_right_series _ _ 0); [apply wedge_rises, tilt_range; lra | lra | eapply right_edge, TiltedWedge.smooth_contact; lra]. }
  intros u Hu. eexists. split.
  { apply (the_pressure _ _ 0); [apply wedge_rises, tilt_range; lra | lra | apply pressure_right_of_apex; lra]. }
  apply (increase_to_proportional K gam a u K_positive); lra.
Qed.

Theorem wedge_left : exists l0 l1 l2, is_the_left_series Es (TiltedWedge.slope phi (tilt phi gam)) (gam * a) l0 l1 l2 /\
  forall u, 0 < u < gam * a -> exists p0,
    is_the_pressure Es (mirrored (TiltedWedge.slope phi (tilt phi gam))) (gam * a) (gam * a - u) p0 /\ increase_to l0 l1 l2 u p0.
Proof.
  assert (Hc : 0 < gam * a) by (apply Rmult_lt_0_compat; lra). assert (Hi := Rinv_0_lt_compat gam ltac:(lra)).
  eexists. eexists. eexists.
  split. { apply (the_left_series _ _ 0); [apply mirrored_wedge_rises, tilt_range; lra | lra | refine (left_edge_of_a _ _ a _ _ _ _ (fun s => gam * s) _ _ _ _ _ _); [apply TiltedWedge.smooth_contact | apply left_of_a]; lra]. }
  intros u Hu. eexists. split.
  { apply (the_pressure _ _ 0); [apply mirrored_wedge_rises, tilt_range; lra | lra | apply pressure_left_of_apex; lra]. }
  assert (HK : 0 < K / gam) by (apply Rdiv_lt_0_compat; [exact K_positive | lra]).
  assert (B := increase_to_proportional (K / gam) (/ gam) (gam * a) u HK Hi Hu). fold K.
  assert (Hw : 0 < sqrt (a + gam * a)) by (apply sqrt_lt_R0; lra). assert (Hpi := PI_RGT_0).
  match type of B with increase_to ?x ?y ?z _ _ => match goal with |- increase_to ?x' ?y' ?z' _ _ =>
    replace x' with x; [replace y' with y; [replace z' with z; [exact B |] |] |] end end;
  unfold left_c0, left_c1, left_c2, c0, c1, c2; replace (gam * a + / gam * (gam * a)) with (a + gam * a) by (field; lra);
  field; repeat split; lra.
Qed.
End Wedge.

(* A wedge that is not tilted. *)
Theorem wedge_symmetric Es C a : 0 < Es /\ 0 < C /\ 0 < a -> exists r0 r1 r2,
  is_the_right_series Es (TiltedWedge.slope C 0) a r0 r1 r2 /\
  forall u, 0 < u < a -> exists p0, is_the_pressure Es (TiltedWedge.slope C 0) a (a - u) p0 /\ increase_to r0 r1 r2 u p0.
Proof.
  intros H. assert (T : tilt C 1 = 0) by (unfold tilt; replace ((1 - 1) / (1 + 1)) with 0 by field; rewrite asin_0; ring).
  assert (W := wedge_right Es C 1 a ltac:(lra)). rewrite T in W. exact W.
Qed.

(* A parabola: p is half of Es C times the root of u (2 a - u). *)
Lemma parabola_decrease Es C a u : 0 < Es * C -> 0 < u < a ->
  decrease_to (Es * C / 2 * sqrt (2 * a)) (- (Es * C / 2 * sqrt (2 * a) / (4 * a))) (- (Es * C / 2 * sqrt (2 * a) / (32 * a ^ 2))) u
    (Es * C / 2 * sqrt (u * (2 * a - u))).
Proof.
  intros HK Hu. set (K := Es * C / 2). assert (HK2 : 0 < K) by (unfold K; lra). clearbody K.
  assert (Hs : 0 < sqrt u) by (apply sqrt_lt_R0; lra). assert (Hr : 0 < sqrt (2 * a)) by (apply sqrt_lt_R0; lra).
  rewrite (sqrt_mult u) by lra.
  replace (2 * a - u) with (2 * a * (1 - u / (2 * a))) by (field; lra).
  assert (Hz : 0 < u / (2 * a) < 1).
  { split; [apply Rdiv_lt_0_compat; lra |]. apply (Rmult_lt_reg_r (2 * a)); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  rewrite (sqrt_mult (2 * a)) by lra.
  assert (Hq : 0 < sqrt (1 - u / (2 * a))) by (apply sqrt_lt_R0; lra).
  assert (E : sqrt (1 - u / (2 * a)) * sqrt (1 - u / (2 * a)) = 1 - u / (2 * a)) by (apply sqrt_sqrt; lra).
  unfold decrease_to, one_term, two_terms, three_terms.
  replace (K * sqrt (2 * a) * sqrt u + - (K * sqrt (2 * a) / (4 * a)) * (u * sqrt u) + - (K * sqrt (2 * a) / (32 * a ^ 2)) * (u ^ 2 * sqrt u))
    with (K * sqrt (2 * a) * sqrt u * (1 - u / (2 * a) / 2 - (u / (2 * a)) ^ 2 / 8)) by (field; lra).
  replace (K * sqrt (2 * a) * sqrt u + - (K * sqrt (2 * a) / (4 * a)) * (u * sqrt u))
    with (K * sqrt (2 * a) * sqrt u * (1 - u / (2 * a) / 2)) by (field; lra).
  replace (K * (sqrt u * (sqrt (2 * a) * sqrt (1 - u / (2 * a))))) with (K * sqrt (2 * a) * sqrt u * sqrt (1 - u / (2 * a))) by ring.
  assert (HF : 0 < K * sqrt (2 * a) * sqrt u) by (repeat first [lra | apply Rmult_lt_0_compat]).
  set (F := K * sqrt (2 * a) * sqrt u) in *. set (z := u / (2 * a)) in *. set (q := sqrt (1 - z)) in *. clearbody F q z.
  assert (L : q < 1 - z / 2 - z ^ 2 / 8).
  { assert (0 < z ^ 3) by (apply pow_lt; lra). assert (0 < z ^ 4) by (apply pow_lt; lra).
    assert (S : q * q < (1 - z / 2 - z ^ 2 / 8) * (1 - z / 2 - z ^ 2 / 8)).
    { rewrite E. replace ((1 - z / 2 - z ^ 2 / 8) * (1 - z / 2 - z ^ 2 / 8)) with (1 - z + z ^ 3 / 8 + z ^ 4 / 64) by field. lra. }
    assert (0 < 1 - z / 2 - z ^ 2 / 8) by nra. nra. }
  assert (0 < z ^ 2) by (apply pow_lt; lra). repeat split; nra.
Qed.

Definition parabola (C : R) : list part := cons (Part 0 0 C) nil.
Theorem parabola_right Es C a : 0 < Es /\ 0 < C /\ 0 < a -> exists r0 r1 r2,
  is_the_right_series Es (Symmetric.slope (parabola C)) a r0 r1 r2 /\
  forall u, 0 < u < a -> exists p0, is_the_pressure Es (Symmetric.slope (parabola C)) a (a - u) p0 /\ decrease_to r0 r1 r2 u p0.
Proof.
  intros form. assert (Hpi := PI_RGT_0). unfold parabola.
  eexists. eexists. eexists.
  split. { apply (the_right_series _ _ (first (parabola C))); [apply punch_rises; convex ltac:(unfold parabola) | before ltac:(unfold parabola) |
    apply right_edge with (1 := Symmetric.smooth_contact Es (parabola C) (a / 2) a ltac:(sides ltac:(unfold parabola)) ltac:(lra))]. }
  intros u Hu. eexists. split.
  { apply (the_pressure _ _ (first (parabola C))); [apply punch_rises; convex ltac:(unfold parabola) | before ltac:(unfold parabola) |
    apply (pressure Es (parabola C) ((a - u) / 2)); [sides ltac:(unfold parabola) | lra | lra]]. }
  assert (B := parabola_decrease Es C a u ltac:(apply Rmult_lt_0_compat; lra) Hu).
  assert (Hr : 0 < sqrt (2 * a)) by (apply sqrt_lt_R0; lra).
  assert (Er : sqrt (2 * a) ^ 2 = 2 * a) by (apply pow2_sqrt; lra).
  assert (A0 : forall s, angle 0 s = PI / 2) by (intros s; unfold angle, Rdiv; rewrite Rmult_0_l, atan_0; ring).
  assert (Hp : total (part_pressure Es (a - u)) (parabola C) a = Es * C / 2 * sqrt (u * (2 * a - u))).
  { unfold total, parabola, List.fold_right, part_pressure, from, corner, curvature. rewrite A0, Rmult_0_l.
    unfold Rdiv at 4. rewrite Rmult_0_l, atanh_0. replace (a ^ 2 - (a - u) ^ 2) with (u * (2 * a - u)) by ring. field. lra. }
  assert (Ha2 : 0 < a ^ 2 - 0 ^ 2) by nra. assert (H2 := sqrt_lt_R0 _ Ha2).
  rewrite Hp. match type of B with decrease_to ?x ?y ?z _ _ => match goal with |- decrease_to ?x' ?y' ?z' _ _ =>
    replace x' with x; [replace y' with y; [replace z' with z; [exact B |] |] |] end end;
  unfold c0, c1, c2, rate, rate_2, rate_3, total, parabola, List.fold_right, part_rate, part_rate_2, part_rate_3, from, corner, curvature;
  rewrite ?A0; replace (a + a) with (2 * a) by ring;
  (field_simplify_eq; [ring [Er] | repeat split; lra]).
Qed.

(* Errors relative to the pressure. *)
Lemma nearer_below p x y : 0 < x < y -> y < p -> Rabs (1 - y / p) < Rabs (1 - x / p).
Proof.
  intros H Hp. assert (I : 0 < / p) by (apply Rinv_0_lt_compat; lra).
  assert (E : p * / p = 1) by (apply Rinv_r; lra). unfold Rdiv.
  rewrite !Rabs_pos_eq by nra. nra.
Qed.
Lemma nearer_above p x y : 0 < p < y -> y < x -> Rabs (1 - y / p) < Rabs (1 - x / p).
Proof.
  intros H Hp. assert (I : 0 < / p) by (apply Rinv_0_lt_compat; lra).
  assert (E : p * / p = 1) by (apply Rinv_r; lra). unfold Rdiv.
  rewrite !Rabs_left by nra. nra.
Qed.

(* Proves relations between sums of the first terms and the pressure, for all places of a contact,
   from one of these theorems. *)
Ltac by_first_terms theorem :=
  let r0 := fresh "r0" in let r1 := fresh "r1" in let r2 := fresh "r2" in let p0 := fresh "p0" in
  let Hr := fresh "Hr" in let H := fresh "H" in let u := fresh "u" in let Hu := fresh "Hu" in
  let Hp := fresh "Hp" in let Hs := fresh "Hs" in
  destruct theorem as (r0 & r1 & r2 & Hr & H); exists r0, r1, r2; split; [exact Hr |];
  intros u Hu; destruct (H u Hu) as (p0 & Hp & Hs); exists p0; split; [exact Hp |];
  unfold increase_to, decrease_to, one_term, two_terms, three_terms in Hs;
  repeat split; first [lra | apply nearer_below; lra | apply nearer_above; lra].
