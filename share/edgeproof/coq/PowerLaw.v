(* SPDX-License-Identifier: GPL-3.0-or-later *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges.
From Edgeproof Require TiltedWedge Hertz.
Open Scope R_scope.

(* g'(x) = C sgn(x) |x|^m, for whole m: a wedge (m = 0), a parabola (m = 1). *)
Definition slope (C : R) (m : nat) (x : R) : R :=
  if Rlt_dec x 0 then - (C * (- x) ^ m) else C * x ^ m.

Lemma slope_parabola C : slope C 1 = Hertz.slope C.
Proof.
  apply FunctionalExtensionality.functional_extensionality. intros x.
  unfold slope, Hertz.slope. destruct (Rlt_dec x 0); ring.
Qed.
Lemma slope_wedge C : slope C 0 = TiltedWedge.slope C (TiltedWedge.tilt C 1).
Proof.
  apply FunctionalExtensionality.functional_extensionality. intros x.
  unfold slope, TiltedWedge.slope, TiltedWedge.tilt.
  replace ((1 - 1) / (1 + 1)) with 0 by field. rewrite asin_0. destruct (Rlt_dec x 0); ring.
Qed.

Section Contacts.
Variables Es C a : R.
Hypothesis HC : 0 < C.
Hypothesis Ha : 0 < a.

Theorem parabola_edge : right_edge_series Es (slope C 1) a
  (c0 (fun s => PI / 2 * Es * C * s) (fun s => s) a)
  (c1 (fun s => PI / 2 * Es * C * s) (fun _ => PI / 2 * Es * C) (fun s => s) (fun _ => 1) a)
  (c2 (fun s => PI / 2 * Es * C * s) (fun _ => PI / 2 * Es * C) (fun _ => 0) (fun s => s) (fun _ => 1) (fun _ => 0) a).
Proof. rewrite slope_parabola. eapply right_edge, Hertz.smooth_contact. exact Ha. Qed.
Theorem wedge_edge : right_edge_series Es (slope C 0) a
  (c0 (fun _ => Es * C * sqrt 1) (fun s => 1 * s) a)
  (c1 (fun _ => Es * C * sqrt 1) (fun _ => 0) (fun s => 1 * s) (fun _ => 1) a)
  (c2 (fun _ => Es * C * sqrt 1) (fun _ => 0) (fun _ => 0) (fun s => 1 * s) (fun _ => 1) (fun _ => 0) a).
Proof. rewrite slope_wedge. eapply right_edge, TiltedWedge.smooth_contact; lra. Qed.

Theorem parabola_pressure x : 0 < x < a ->
  is_pressure Es (slope C 1) a x (Es * C / 2 * sqrt (a ^ 2 - x ^ 2)).
Proof. rewrite slope_parabola. apply Hertz.pressure. Qed.
Theorem wedge_pressure x : 0 < x < a -> is_pressure Es (slope C 0) a x
  (RInt (fun w => 2 / PI * (Es * C * sqrt 1 / sqrt (x + 1 * (x + w ^ 2)))) 0 (sqrt (a - x))).
Proof. rewrite slope_wedge. apply TiltedWedge.pressure_right_of_apex; lra. Qed.
End Contacts.
