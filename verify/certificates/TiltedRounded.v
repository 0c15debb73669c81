(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* g'(x) of a flat punch with rounded edges that is tilted by alpha, by the distance from its lowest
   point. *)
Definition tilted_rounded_slope (alpha t R0 x : R) : R :=
  - alpha + Rmax (x + alpha * R0) 0 / R0 + Rmin (x + 2 * t + alpha * R0) 0 / R0.

Section Slope.
Variables alpha t R0 : R.
Hypothesis form : 0 < alpha /\ 0 < t /\ 0 < R0.
Lemma slope_right x : - (alpha * R0) <= x -> tilted_rounded_slope alpha t R0 x = x / R0.
Proof. intros H. unfold tilted_rounded_slope. rewrite Rmax_left, Rmin_right by lra. field. lra. Qed.
Lemma slope_left x : x < 0 -> tilted_rounded_slope alpha t R0 x < 0.
Proof.
  intros H. assert (I := Rinv_0_lt_compat R0 ltac:(lra)). destruct (Rle_lt_dec (- (alpha * R0)) x) as [L | L].
  - rewrite slope_right by exact L. unfold Rdiv. nra.
  - unfold tilted_rounded_slope. rewrite Rmax_right by lra. unfold Rdiv. rewrite Rmult_0_l.
    assert (Rmin (x + 2 * t + alpha * R0) 0 <= 0) by apply Rmin_r. nra.
Qed.
Theorem lowest_at_origin : tilted_rounded_slope alpha t R0 0 = 0.
Proof. assert (0 < alpha * R0) by (apply Rmult_lt_0_compat; lra). rewrite slope_right by lra. unfold Rdiv. ring. Qed.
Theorem parabola_to_the_right x : 0 < x -> x / R0 = tilted_rounded_slope alpha t R0 x.
Proof. intros H. assert (0 < alpha * R0) by (apply Rmult_lt_0_compat; lra). rewrite slope_right by lra. reflexivity. Qed.
Theorem falls_and_rises x : Rabs (tilted_rounded_slope alpha t R0 x) = sign x * tilted_rounded_slope alpha t R0 x.
Proof.
  destruct (Rtotal_order x 0) as [H | [-> | H]].
  - rewrite sign_eq_m1 by exact H. rewrite Rabs_left by (apply slope_left, H). ring.
  - rewrite lowest_at_origin, Rabs_R0. ring.
  - rewrite sign_eq_1, <- parabola_to_the_right by exact H. rewrite Rabs_pos_eq by (apply Rlt_le, Rdiv_lt_0_compat; lra). ring.
Qed.
End Slope.
