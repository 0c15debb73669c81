(* SPDX-License-Identifier: GPL-3.0-or-later *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges.
Open Scope R_scope.

(* g'(x) of a parabola, C = 1/R. *)
Definition slope (C x : R) : R := C * x.

Section Solution.
Variables Es C : R.

Lemma parabola_consistent s : consistent (slope C) s s.
Proof.
  assert (Hpi := PI_RGT_0). unfold consistent, slope, place.
  set (H := fun theta => C * (- s * cos theta)).
  replace 0 with (H (PI / 2) - H (- (PI / 2))) by (unfold H; rewrite cos_neg, cos_PI2; ring).
  apply (is_RInt_antiderivative _ (fun theta => C * (s * sin theta))).
  - lra.
  - intros theta _. field.
  - intros theta _. unfold H. auto_derive; [trivial | ring].
  - intros theta _. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.

Lemma parabola_load s : is_load Es (slope C) s s (PI / 4 * Es * C * s ^ 2).
Proof.
  assert (Hpi := PI_RGT_0). unfold is_load, slope, place.
  set (H := fun theta => Es / 2 * C * s ^ 2 * (theta / 2 - sin theta * cos theta / 2)).
  replace (PI / 4 * Es * C * s ^ 2) with (H (PI / 2) - H (- (PI / 2)))
    by (unfold H; rewrite cos_neg, cos_PI2; field).
  apply (is_RInt_antiderivative _ (fun theta => Es / 2 * (s * sin theta * (C * (s * sin theta))))).
  - lra.
  - intros theta _. field.
  - intros theta _. unfold H. auto_derive; [trivial |]. field_simplify.
    replace (cos theta ^ 2) with (1 - sin theta ^ 2) by (generalize (sin2_cos2 theta); unfold Rsqr; nra). field.
  - intros theta _. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.

Lemma parabola_contact_at s : 0 < s ->
  is_contact_at Es (slope C) (fun s => PI / 4 * Es * C * s ^ 2) (fun s => PI / 2 * Es * C * s) (fun s => s) s.
Proof.
  intros Hs. split; [lra | split; [| split]].
  - apply parabola_consistent.
  - apply (locally_near s s); [lra |]. intros r Hr. apply parabola_load.
  - auto_derive; [trivial | field].
Qed.

Theorem smooth_contact a : 0 < a -> is_smooth_contact Es (slope C) a
  (fun s => PI / 4 * Es * C * s ^ 2) (fun s => PI / 2 * Es * C * s) (fun _ => PI / 2 * Es * C) (fun _ => 0)
  (fun s => s) (fun _ => 1) (fun _ => 0).
Proof.
  intros Ha. exists (a / 2). split; [lra |]. intros s Hs.
  split; [apply parabola_contact_at; lra |].
  repeat match goal with |- _ /\ _ => split end; try apply continuous_const; try lra;
    auto_derive; trivial; ring.
Qed.

(* p(x) = Es C/2 sqrt(a^2 - x^2). *)
Theorem pressure a x : 0 < x < a -> is_pressure Es (slope C) a x (Es * C / 2 * sqrt (a ^ 2 - x ^ 2)).
Proof.
  intros Hx. exists (fun s => PI / 4 * Es * C * s ^ 2), (fun s => PI / 2 * Es * C * s), (fun s => s). split.
  - intros s Hs. apply parabola_contact_at. lra.
  - assert (Hpi := PI_RGT_0).
    replace (Es * C / 2 * sqrt (a ^ 2 - x ^ 2)) with
      (RInt (fun w => 2 / PI * (PI / 2 * Es * C * (x + w ^ 2) / sqrt (x + (x + w ^ 2)))) 0 (sqrt (a - x))).
    + refine (pressure_by_square (fun s => PI / 2 * Es * C * s) (fun s => s) x a _ _ _ _).
      * lra.
      * intros s Hs. apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
      * intros s Hs. apply continuous_id.
      * intros s Hs. lra.
    + set (H := fun w => Es * C / 2 * (w * sqrt (x + (x + w ^ 2)))).
      assert (Hr : sqrt (a - x) ^ 2 = a - x) by (apply pow2_sqrt; lra).
      rewrite (is_RInt_unique _ _ _ (H (sqrt (a - x)) - H 0)).
      * match goal with |- @eq _ ?x ?y => change (@eq R x y) end.
        unfold H. rewrite Hr.
        assert (E : sqrt (a - x) * sqrt (x + (x + (a - x))) = sqrt (a ^ 2 - x ^ 2)).
        { rewrite <- sqrt_mult by lra. f_equal. ring. }
        rewrite <- E. ring.
      * apply (is_RInt_antiderivative _ (fun w => 2 / PI * (PI / 2 * Es * C * (x + w ^ 2) / sqrt (x + (x + w ^ 2))))).
        -- apply sqrt_pos.
        -- reflexivity.
        -- intros w _. assert (Hw : 0 <= w ^ 2) by apply pow2_ge_0.
           assert (Hp : 0 < x + (x + w ^ 2)) by lra.
           assert (Hq : 0 < sqrt (x + (x + w ^ 2))) by (apply sqrt_lt_R0; lra).
           unfold H. auto_derive.
           ++ change (w * (w * 1)) with (w ^ 2). lra.
           ++ change (w * (w * 1)) with (w ^ 2).
              assert (E : sqrt (x + (x + w ^ 2)) ^ 2 = x + (x + w ^ 2)) by (apply pow2_sqrt; lra).
              set (q := sqrt (x + (x + w ^ 2))) in *. field_simplify_eq; [| split; lra].
              replace (q ^ 2) with (x + (x + w ^ 2)). ring.
        -- intros w _. assert (Hw : 0 <= w ^ 2) by apply pow2_ge_0.
           apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive.
           change (w * (w * 1)) with (w ^ 2).
           repeat split; try lra. apply Rgt_not_eq, sqrt_lt_R0. lra.
Qed.
End Solution.

(* p0 and the local sums at a distance u, for Es = C = a = 1, over sqrt u. *)
Lemma parabola_root u : 0 < u < 1 -> sqrt (1 ^ 2 - (1 - u) ^ 2) = sqrt u * sqrt (2 - u).
Proof. intros H. rewrite <- sqrt_mult by lra. f_equal. ring. Qed.

(* The root of u taken out of |p - sum|, for one, two and three terms. *)
Section Scaled.
Variables (q S A B C u t : R).
Hypothesis Hq : 0 < q.
Lemma scaled_within d e : Rabs d <= t * e -> Rabs (q * d) <= t * (q * e).
Proof. intros H. rewrite Rabs_mult, (Rabs_pos_eq q) by lra. nra. Qed.
Lemma scaled_beyond d e : t * e < Rabs d -> t * (q * e) < Rabs (q * d).
Proof. intros H. rewrite Rabs_mult, (Rabs_pos_eq q) by lra. nra. Qed.
End Scaled.
Lemma of_1 q S A : 1 * 1 / 2 * (q * S) - A * q = q * (S / 2 - A).
Proof. field. Qed.
Lemma of_2 q S A B u : 1 * 1 / 2 * (q * S) - (A * q + B * (u * q)) = q * (S / 2 - (A + B * u)).
Proof. field. Qed.
Lemma of_3 q S A B C u : 1 * 1 / 2 * (q * S) - (A * q + B * (u * q) + C * (u ^ 2 * q)) = q * (S / 2 - (A + B * u + C * u ^ 2)).
Proof. field. Qed.
Lemma of_p q S : 1 * 1 / 2 * (q * S) = q * (S / 2).
Proof. field. Qed.

Ltac extent_of_parabola :=
  eexists; eexists; eexists; split; [eapply right_edge, smooth_contact; lra | split; intros u Hu;
    (eexists; split; [apply pressure; lra |]);
    unfold c0, c1, c2; rewrite parabola_root by lra;
    (assert (Hr : 0 < sqrt u) by (apply sqrt_lt_R0; lra));
    first [rewrite of_3 | rewrite of_2 | rewrite of_1]; rewrite of_p;
    [apply scaled_within | apply scaled_beyond]; try exact Hr;
    [apply Rminus_le; interval with (i_bisect u, i_prec 60, i_depth 40) | subst u; apply Rminus_lt; interval with (i_prec 60)]].
