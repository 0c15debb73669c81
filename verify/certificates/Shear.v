(* SPDX-License-Identifier: GPL-3.0-or-later *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* The shear traction of a contact [-b, a] that nowhere slips, under a shear force Q and a
   differential bulk tension sig0, both applied while the normal load is held. *)
Definition full_stick (Q sig0 a b x : R) : R :=
  Q / (PI * sqrt ((a - x) * (x + b))) + sig0 * (2 * x + b - a) / (8 * sqrt ((a - x) * (x + b))).

(* q(a - u) = K(u) / sqrt(u), K being differentiable at u = 0: k0, k1, k2 are the first three
   coefficients of its Taylor series, those of u^(-1/2), u^(1/2), u^(3/2). *)
Definition right_shear_series (q : R -> R) (a k0 k1 k2 : R) : Prop :=
  exists (K K1 : R -> R) (d : R), 0 < d /\
    (forall u, 0 < u < d -> q (a - u) = K u / sqrt u) /\
    (forall u, - d < u < d -> is_derive K u (K1 u)) /\
    K 0 = k0 /\ K1 0 = k1 /\ is_derive K1 0 (2 * k2).
(* The same of the distance from the left edge -b, u = b + x. *)
Definition left_shear_series (q : R -> R) (b k0 k1 k2 : R) : Prop :=
  right_shear_series (fun x => q (- x)) b k0 k1 k2.

Section Series.
Variables Q sig0 D : R.
Hypothesis HD : 0 < D.

Definition shear_0 := (Q / PI + sig0 * D / 8) / sqrt D.
Definition shear_1 := (Q / PI + sig0 * D / 8) / (2 * (D * sqrt D)) - sig0 / (4 * sqrt D).
Definition shear_2 := 3 * (Q / PI + sig0 * D / 8) / (8 * (D ^ 2 * sqrt D)) - sig0 / (8 * (D * sqrt D)).

Let N u := Q / PI + sig0 * (D - 2 * u) / 8.
Let K u := N u / sqrt (D - u).
Let K1 u := N u / (2 * ((D - u) * sqrt (D - u))) - sig0 / (4 * sqrt (D - u)).

Lemma shear_series (q : R -> R) (a : R) :
  (forall u, 0 < u < D -> q (a - u) = N u / sqrt (u * (D - u))) ->
  right_shear_series q a shear_0 shear_1 shear_2.
Proof.
  intros Hq. exists K, K1, D. assert (Hpi := PI_RGT_0).
  assert (Hr : forall u, u < D -> 0 < sqrt (D - u)) by (intros u Hu; apply sqrt_lt_R0; lra).
  assert (Hrr : forall u, u < D -> D - u = sqrt (D - u) * sqrt (D - u)) by (intros u Hu; symmetry; apply sqrt_sqrt; lra).
  split; [exact HD | split; [| split; [| split; [| split]]]].
  - intros u Hu. rewrite Hq by exact Hu. rewrite sqrt_mult by lra. unfold K.
    assert (0 < sqrt u) by (apply sqrt_lt_R0; lra). assert (Hru := Hr u ltac:(lra)). field. lra.
  - intros u Hu. assert (Hru := Hr u ltac:(lra)). assert (E := Hrr u ltac:(lra)).
    unfold K, K1, N. auto_derive; change (D + - u) with (D - u).
    + repeat split; lra.
    + set (r := sqrt (D - u)) in *. clearbody r. replace u with (D - r * r) by lra. field. lra.
  - unfold K, N, shear_0. rewrite Rmult_0_r, !Rminus_0_r. reflexivity.
  - unfold K1, N, shear_1. rewrite Rmult_0_r, !Rminus_0_r. reflexivity.
  - assert (Hru := Hr 0 HD). assert (E := Hrr 0 HD). rewrite Rminus_0_r in *.
    unfold K1, N, shear_2. auto_derive; change (D + - 0) with (D - 0); rewrite Rminus_0_r.
    + assert (0 < D * sqrt D) by (apply Rmult_lt_0_compat; lra). repeat split; lra.
    + set (r := sqrt D) in *. clearbody r. rewrite E. field. lra.
Qed.
End Series.

Theorem right_shear Q sig0 a b : 0 < a + b -> right_shear_series (full_stick Q sig0 a b) a
  (shear_0 Q sig0 (a + b)) (shear_1 Q sig0 (a + b)) (shear_2 Q sig0 (a + b)).
Proof.
  intros HD. apply shear_series; [exact HD |]. intros u Hu. unfold full_stick.
  replace (a - (a - u)) with u by ring. replace (a - u + b) with (a + b - u) by ring.
  assert (0 < sqrt (u * (a + b - u))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
  assert (Hpi := PI_RGT_0). field. lra.
Qed.
Theorem left_shear Q sig0 a b : 0 < a + b -> left_shear_series (full_stick Q sig0 a b) b
  (shear_0 Q (- sig0) (a + b)) (shear_1 Q (- sig0) (a + b)) (shear_2 Q (- sig0) (a + b)).
Proof.
  intros HD. apply shear_series; [exact HD |]. intros u Hu. unfold full_stick.
  replace ((a - - (b - u)) * (- (b - u) + b)) with (u * (a + b - u)) by ring.
  assert (0 < sqrt (u * (a + b - u))) by (apply sqrt_lt_R0, Rmult_lt_0_compat; lra).
  assert (Hpi := PI_RGT_0). field. lra.
Qed.
