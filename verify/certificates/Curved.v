(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique.
Open Scope R_scope.

(* A contact whose left edge is not proportional to the right one, so that b'' and b''' are not zero:
   g'(x) = x + x^2, continued by a constant where it would fall. *)
Definition curved_slope (x : R) : R := if Rlt_dec x (- (1 / 2)) then - (1 / 4) else x + x ^ 2.

Definition curved_root (s : R) : R := sqrt (1 - 2 * s - 2 * s ^ 2).
(* The middle of the contact with the right edge s, and its derivatives. *)
Definition middle (s : R) : R := (s - 1 + curved_root s) / 3.
Definition middle_1 (s : R) : R := (1 - (1 + 2 * s) / curved_root s) / 3.
Definition middle_2 (s : R) : R := - (1 / curved_root s ^ 3).
Definition middle_3 (s : R) : R := - (3 * (1 + 2 * s) / curved_root s ^ 5).
(* The left edge is at - curved_left s. *)
Definition curved_left (s : R) : R := s - 2 * middle s.
Definition curved_left_1 (s : R) : R := 1 - 2 * middle_1 s.
Definition curved_left_2 (s : R) : R := - (2 * middle_2 s).
Definition curved_left_3 (s : R) : R := - (2 * middle_3 s).
(* The right edge of the contact with the left edge - r. *)
Definition curved_right (r : R) : R := (r - 2 + 2 * sqrt (1 + 2 * r - 2 * r ^ 2)) / 3.
(* The load for the modulus 1, and its derivatives. *)
Definition curved_load (s : R) : R := - (PI / 2 * (middle s + 3 * middle s ^ 2 + 2 * middle s ^ 3)).
Definition curved_load_1 (s : R) : R := - (PI / 2 * ((1 + 6 * middle s + 6 * middle s ^ 2) * middle_1 s)).
Definition curved_load_2 (s : R) : R :=
  - (PI / 2 * ((6 + 12 * middle s) * middle_1 s ^ 2 + (1 + 6 * middle s + 6 * middle s ^ 2) * middle_2 s)).
Definition curved_load_3 (s : R) : R :=
  - (PI / 2 * (12 * middle_1 s ^ 3 + 3 * (6 + 12 * middle s) * middle_1 s * middle_2 s
     + (1 + 6 * middle s + 6 * middle s ^ 2) * middle_3 s)).

Lemma curved_rises : rises_at curved_slope 0.
Proof.
  unfold rises_at, curved_slope. split; [| split].
  - intros x z H. destruct (Rlt_dec x _), (Rlt_dec z _); nra.
  - intros x H. destruct (Rlt_dec x _); nra.
  - intros d H. destruct (Rlt_dec (0 - d) _), (Rlt_dec (0 + d) _); nra.
Qed.
Lemma mirrored_curved_rises : rises_at (mirrored curved_slope) 0.
Proof.
  unfold rises_at, mirrored, curved_slope. split; [| split].
  - intros x z H. destruct (Rlt_dec (- x) _), (Rlt_dec (- z) _); nra.
  - intros x H. destruct (Rlt_dec (- x) _); nra.
  - intros d H. destruct (Rlt_dec (- (0 - d)) _), (Rlt_dec (- (0 + d)) _); nra.
Qed.

(* ---- The contacts with right edges from 0 to 1/4 ---- *)

Section At.
Variable s : R.
Hypothesis Hs : 0 < s < 1 / 4.
Let r := curved_root s.
Lemma root_square : r * r = 1 - 2 * s - 2 * s ^ 2.
Proof. unfold r, curved_root. apply sqrt_sqrt. nra. Qed.
Lemma root_range : 3 / 5 < r < 1 - s.
Proof.
  assert (H := root_square). assert (0 <= r) by apply sqrt_pos. split; nra.
Qed.
Lemma middle_range : - (1 / 10) < middle s < 0.
Proof. unfold middle. fold r. generalize root_range root_square. intros. split; nra. Qed.
Lemma curved_left_range : s < curved_left s < 1 / 2.
Proof. unfold curved_left. generalize middle_range. lra. Qed.

Lemma middle_equation : middle s + middle s ^ 2 + (s - middle s) ^ 2 / 2 = 0.
Proof. unfold middle. fold r. generalize root_square. intros H. field_simplify. nra. Qed.

Lemma root_positive : 0 < r.
Proof. generalize root_range. lra. Qed.
Lemma derive_root : is_derive curved_root s (- ((1 + 2 * s) / curved_root s)).
Proof.
  assert (H := root_square). assert (Hr := root_positive). fold r.
  unfold curved_root. auto_derive.
  - replace (1 + - (2 * s) + - (2 * (s * (s * 1)))) with (r * r) by (rewrite H; ring). nra.
  - replace (1 + - (2 * s) + - (2 * (s * (s * 1)))) with (1 - 2 * s - 2 * s ^ 2) by ring.
    fold (curved_root s). fold r. field. lra.
Qed.
Ltac derive_roots := repeat split; first [exists (- ((1 + 2 * s) / curved_root s)); exact derive_root
  | repeat apply Rmult_integral_contrapositive_currified; first [exact (Rgt_not_eq _ _ root_positive) | lra]].
Ltac derivative H := match goal with |- context [Derive ?f s] => rewrite (is_derive_unique f s _ H) end.
Lemma derive_middle : is_derive middle s (middle_1 s).
Proof.
  assert (Hr := root_positive). unfold middle, middle_1. fold r. auto_derive; [derive_roots |].
  derivative derive_root. fold r. field. lra.
Qed.
Lemma derive_middle_1 : is_derive middle_1 s (middle_2 s).
Proof.
  assert (H := root_square). assert (Hr := root_positive). unfold middle_1, middle_2. auto_derive; [derive_roots |].
  derivative derive_root. fold r. field_simplify_eq; [| lra]. simpl. nra.
Qed.
Lemma derive_middle_2 : is_derive middle_2 s (middle_3 s).
Proof.
  assert (H := root_square). assert (Hr := root_positive). unfold middle_2, middle_3. auto_derive; [derive_roots |].
  derivative derive_root. fold r. field. lra.
Qed.
Lemma continuous_root : continuous curved_root s.
Proof. apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. exact derive_root. Qed.
Lemma ex_derive_middle_3 : ex_derive middle_3 s.
Proof. unfold middle_3. auto_derive. derive_roots. Qed.

Lemma derive_left : is_derive curved_left s (curved_left_1 s).
Proof. unfold curved_left, curved_left_1. auto_derive; [eexists; exact derive_middle |]. derivative derive_middle. ring. Qed.
Lemma derive_left_1 : is_derive curved_left_1 s (curved_left_2 s).
Proof. unfold curved_left_1, curved_left_2. auto_derive; [eexists; exact derive_middle_1 |]. derivative derive_middle_1. ring. Qed.
Lemma derive_left_2 : is_derive curved_left_2 s (curved_left_3 s).
Proof. unfold curved_left_2, curved_left_3. auto_derive; [eexists; exact derive_middle_2 |]. derivative derive_middle_2. ring. Qed.
Lemma left_rate_positive : 0 < curved_left_1 s.
Proof.
  assert (Hr := root_positive). unfold curved_left_1, middle_1. fold r.
  assert (0 < (1 + 2 * s) / r) by (apply Rdiv_lt_0_compat; lra). lra.
Qed.

Ltac derive_load :=
  auto_derive; [repeat split; first [eexists; exact derive_middle | eexists; exact derive_middle_1 | eexists; exact derive_middle_2] |];
  repeat match goal with |- context [Derive ?f s] =>
    first [rewrite (is_derive_unique f s _ derive_middle) | rewrite (is_derive_unique f s _ derive_middle_1) | rewrite (is_derive_unique f s _ derive_middle_2)] end;
  field.
Lemma derive_curved_load : is_derive curved_load s (curved_load_1 s).
Proof. unfold curved_load, curved_load_1. derive_load. Qed.
Lemma derive_curved_load_1 : is_derive curved_load_1 s (curved_load_2 s).
Proof. unfold curved_load_1, curved_load_2. derive_load. Qed.
Lemma derive_curved_load_2 : is_derive curved_load_2 s (curved_load_3 s).
Proof. unfold curved_load_2, curved_load_3. derive_load. Qed.
Lemma ex_derive_curved_load_3 : ex_derive curved_load_3 s.
Proof.
  unfold curved_load_3. auto_derive. repeat split;
    first [eexists; exact derive_middle | eexists; exact derive_middle_1 | eexists; exact derive_middle_2 | exact ex_derive_middle_3].
Qed.

(* The slope at a place of the contact, by its angle. *)
Lemma slope_at theta : curved_slope (place s (curved_left s) theta) =
  (middle s + (s - middle s) * sin theta) + (middle s + (s - middle s) * sin theta) ^ 2.
Proof.
  assert (Hm := middle_range). assert (Hl := curved_left_range). assert (Hsin := SIN_bound theta).
  replace (place s (curved_left s) theta) with (middle s + (s - middle s) * sin theta) by (unfold place, curved_left; field).
  unfold curved_slope. destruct (Rlt_dec _ _) as [H |]; [exfalso | reflexivity].
  unfold curved_left in Hl. nra.
Qed.
Lemma curved_consistent : consistent curved_slope s (curved_left s).
Proof.
  assert (E := middle_equation). set (m := middle s) in *. set (h := s - m) in *.
  apply (is_RInt_ext (fun theta => (m + h * sin theta) + (m + h * sin theta) ^ 2)).
  { intros theta _. symmetry. apply slope_at. }
  replace 0 with (PI * (m + m ^ 2 + h ^ 2 / 2)) by (rewrite E; ring).
  set (F theta := m * theta - h * cos theta + m ^ 2 * theta - 2 * m * h * cos theta + h ^ 2 * (theta / 2 - sin theta * cos theta / 2)).
  replace (PI * (m + m ^ 2 + h ^ 2 / 2)) with (F (PI / 2) - F (- (PI / 2)))
    by (unfold F; rewrite sin_neg, cos_neg, sin_PI2, cos_PI2; field).
  apply (is_RInt_antiderivative _ (fun theta => (m + h * sin theta) + (m + h * sin theta) ^ 2) F).
  - generalize PI_RGT_0. lra.
  - reflexivity.
  - intros theta _. unfold F. auto_derive; [trivial |].
    assert (Q := sin2_cos2 theta). unfold Rsqr in Q. field_simplify. replace (cos theta ^ 2) with (1 - sin theta ^ 2) by nra. field.
  - intros theta _. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
Lemma curved_is_load : is_load 1 curved_slope s (curved_left s) (curved_load s).
Proof.
  assert (E := middle_equation). unfold curved_load, is_load. set (m := middle s) in *. set (h := s - m) in *.
  assert (Eh : h ^ 2 = - 2 * (m + m ^ 2)) by lra.
  apply (is_RInt_ext (fun theta => 1 / 2 * ((m + h * sin theta) * ((m + h * sin theta) + (m + h * sin theta) ^ 2)))).
  { intros theta _. rewrite slope_at. fold m h.
    replace (place s (curved_left s) theta) with (m + h * sin theta) by (unfold place, curved_left, h, m; field). reflexivity. }
  set (F theta := 1 / 2 * ((m ^ 2 + m ^ 3) * theta - (2 * m + 3 * m ^ 2) * h * cos theta
    + (h ^ 2 + 3 * m * h ^ 2) * (theta / 2 - sin theta * cos theta / 2) + h ^ 3 * (cos theta ^ 3 / 3 - cos theta))).
  replace (- (PI / 2 * (m + 3 * m ^ 2 + 2 * m ^ 3))) with (F (PI / 2) - F (- (PI / 2)))
    by (unfold F; rewrite sin_neg, cos_neg, sin_PI2, cos_PI2, Eh; field).
  apply (is_RInt_antiderivative _ (fun theta => 1 / 2 * ((m + h * sin theta) * ((m + h * sin theta) + (m + h * sin theta) ^ 2))) F).
  - generalize PI_RGT_0. lra.
  - reflexivity.
  - intros theta _. unfold F. auto_derive; [trivial |].
    assert (Q := sin2_cos2 theta). unfold Rsqr in Q. field_simplify.
    replace (cos theta ^ 2) with (1 - sin theta ^ 2) by nra. field.
  - intros theta _. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.
End At.

Lemma curved_contact : is_smooth_contact 1 curved_slope (1 / 8) curved_load curved_load_1 curved_load_2 curved_load_3
  curved_left curved_left_1 curved_left_2.
Proof.
  exists (1 / 20). split; [lra |]. intros s Hs. assert (H : 0 < s < 1 / 4) by lra.
  assert (Hl := curved_left_range s H).
  split; [split; [lra | split; [exact (curved_consistent s H) | split; [| exact (derive_curved_load s H)]]] |].
  { apply (locally_near s (1 / 20)); [lra |]. intros r Hr. apply curved_is_load. lra. }
  split; [exact (derive_curved_load_1 s H) | split; [exact (derive_curved_load_2 s H) | split]].
  { apply (@ex_derive_continuous R_AbsRing R_NormedModule), ex_derive_curved_load_3, H. }
  split; [exact (derive_left s H) | split; [exact (derive_left_1 s H) | split; [| lra]]].
  apply (@ex_derive_continuous R_AbsRing R_NormedModule). eexists. exact (derive_left_2 s H).
Qed.

(* ---- The left edge as the given one ---- *)

Section Inverse.
Variable r : R.
Hypothesis Hr : 0 < r < 1 / 5.
Let q := sqrt (1 + 2 * r - 2 * r ^ 2).
Lemma inverse_square : q * q = 1 + 2 * r - 2 * r ^ 2.
Proof. unfold q. apply sqrt_sqrt. nra. Qed.
Lemma inverse_range : 1 < q < 1 + r.
Proof. assert (H := inverse_square). assert (0 <= q) by apply sqrt_pos. split; nra. Qed.
Lemma curved_right_range : 0 < curved_right r < 1 / 4.
Proof. unfold curved_right. fold q. generalize inverse_range. lra. Qed.
Lemma root_of_inverse : curved_root (curved_right r) = (q - 4 * r + 2) / 3.
Proof.
  assert (H := inverse_square). assert (Hq := inverse_range). unfold curved_root, curved_right. fold q.
  replace (1 - 2 * ((r - 2 + 2 * q) / 3) - 2 * ((r - 2 + 2 * q) / 3) ^ 2) with ((q - 4 * r + 2) / 3 * ((q - 4 * r + 2) / 3)) by nra.
  apply sqrt_square. lra.
Qed.
Lemma left_of_right : curved_left (curved_right r) = r.
Proof. unfold curved_left, middle. rewrite root_of_inverse. unfold curved_right. fold q. field. Qed.
Lemma derive_right : is_derive curved_right r (/ curved_left_1 (curved_right r)).
Proof.
  assert (H := inverse_square). assert (Hq := inverse_range). assert (Hp := left_rate_positive _ curved_right_range).
  unfold curved_left_1, middle_1 in *. rewrite root_of_inverse in *. unfold curved_right in *. fold q in Hp |- *. auto_derive.
  - replace (1 + 2 * r + - (2 * (r * (r * 1)))) with (q * q) by (rewrite H; ring). nra.
  - replace (1 + 2 * r + - (2 * (r * (r * 1)))) with (1 + 2 * r - 2 * r ^ 2) by ring. fold q.
    assert (0 < q - 4 * r + 2) by lra.
    apply (Rmult_eq_reg_r (1 - 2 * ((1 - (1 + 2 * ((r - 2 + 2 * q) / 3)) / ((q - 4 * r + 2) / 3)) / 3))); [| lra].
    rewrite Rinv_l by lra. field_simplify_eq; [| lra]. nra.
Qed.
End Inverse.

Lemma curved_left_edge : is_left_edge (1 / 8) curved_left curved_left_1 curved_left_2 curved_left_3 curved_right.
Proof.
  assert (H : 0 < 1 / 8 < 1 / 4) by lra.
  assert (Hb : 1 / 8 < curved_left (1 / 8) < 3 / 20).
  { generalize (curved_left_range _ H) (root_square _ H) (root_positive _ H). unfold curved_left, middle. intros. split; nra. }
  split.
  - assert (E := root_square _ H). assert (Hr := root_range _ H). assert (El : curved_left (1 / 8) = (17 / 8 - 2 * curved_root (1 / 8)) / 3) by (unfold curved_left, middle; field).
    revert E Hr El. generalize (curved_root (1 / 8)). intros q E Hr El.
    unfold curved_right. replace (1 + 2 * curved_left (1 / 8) - 2 * curved_left (1 / 8) ^ 2) with ((5 / 2 + q) / 3 * ((5 / 2 + q) / 3)) by (rewrite El; nra).
    rewrite sqrt_square by lra. rewrite El. field.
  - exists (1 / 20). split; [lra | split].
    + intros s Hs. assert (Hs4 : 0 < s < 1 / 4) by lra.
      split; [exact (left_rate_positive s Hs4) | split; [exact (derive_left_2 s Hs4) |]].
      apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold curved_left_3. auto_derive. exact (ex_derive_middle_3 s Hs4).
    + intros r Hr. split; [apply left_of_right | apply derive_right]; lra.
Qed.

Lemma curved_convex : rises_at curved_slope 0 /\ 0 < 1 / 8 /\ rises_at (mirrored curved_slope) 0 /\ 0 < curved_left (1 / 8).
Proof.
  split; [exact curved_rises | split; [lra | split; [exact mirrored_curved_rises |]]].
  generalize (curved_left_range (1 / 8) ltac:(lra)). lra.
Qed.

(* Proofs that contacts of some kind exist, by this one, and of inequalities of its numbers. *)
Ltac exists_curved_contact :=
  exists 1, curved_slope, (1 / 8), curved_load, curved_load_1, curved_load_2, curved_load_3,
    curved_left, curved_left_1, curved_left_2, curved_left_3, curved_right, 0, 0;
  split; [exact curved_contact | split; [exact curved_left_edge | split; [exact curved_convex |]]].
Ltac curved_numbers :=
  unfold curved_left_3, curved_left_2, curved_left_1, curved_left, curved_load_3, curved_load_2, curved_load_1,
    middle_3, middle_2, middle_1, middle, curved_root, Rpower; interval with (i_prec 90).
