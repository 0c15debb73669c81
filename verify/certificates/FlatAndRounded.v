(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact.
Open Scope R_scope.

(* The integral that the pressure of a flat punch with rounded edges is printed with. *)
Lemma rounded_integral t a x : 0 < t < x -> x < a ->
  is_improper_integral (fun s => (PI / 2 - asin (t / s)) * s / sqrt (s ^ 2 - x ^ 2)) (Rmax x t) a
    (RInt (fun w => 2 * (PI / 2 - atan (t / sqrt ((x + w ^ 2) ^ 2 - t ^ 2))) * (x + w ^ 2) / sqrt (2 * x + w ^ 2))
      0 (sqrt (a - x))).
Proof.
  intros Ht Hx. rewrite Rmax_left by lra.
  assert (Hd : forall s, t < s -> 0 < s ^ 2 + - t ^ 2).
  { intros s Hs. replace (s ^ 2 + - t ^ 2) with ((s - t) * (s + t)) by ring. apply Rmult_lt_0_compat; lra. }
  apply (improper_by_square _ (fun w => 2 * (PI / 2 - atan (t / sqrt ((x + w ^ 2) ^ 2 - t ^ 2))) * (x + w ^ 2) / sqrt (2 * x + w ^ 2))).
  - exact Hx.
  - intros w Hw. assert (Hw2 : 0 < w ^ 2) by (apply pow_lt; lra).
    rewrite asin_sqrt by lra.
    replace ((x + w ^ 2) ^ 2 - x ^ 2) with (w ^ 2 * (2 * x + w ^ 2)) by ring.
    rewrite (sqrt_mult (w ^ 2) (2 * x + w ^ 2)) by lra. rewrite (sqrt_pow2 w) by lra.
    field. split; [apply Rgt_not_eq, sqrt_lt_R0; lra | lra].
  - intros w Hw. assert (Hw2 : 0 <= w ^ 2) by apply pow2_ge_0.
    assert (Hd1 := Hd (x + w ^ 2) ltac:(lra)).
    assert (Hq : 0 < sqrt ((x + w ^ 2) ^ 2 + - t ^ 2)) by (apply sqrt_lt_R0, Hd1).
    assert (Hp : 0 < sqrt (2 * x + w ^ 2)) by (apply sqrt_lt_R0; lra).
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). unfold Rminus. auto_derive.
    repeat split; try (apply Rgt_not_eq); try exact Hq; try exact Hd1; try exact Hp.
    change (0 < 2 * x + w ^ 2). lra.
  - intros s Hs.
    assert (Hd1 := Hd s ltac:(lra)).
    assert (Hq : 0 < sqrt (s ^ 2 + - t ^ 2)) by (apply sqrt_lt_R0, Hd1).
    assert (Hd2 : 0 < s ^ 2 + - x ^ 2).
    { replace (s ^ 2 + - x ^ 2) with ((s - x) * (s + x)) by ring. apply Rmult_lt_0_compat; lra. }
    assert (Hp : 0 < sqrt (s ^ 2 + - x ^ 2)) by (apply sqrt_lt_R0, Hd2).
    apply (continuous_ext_loc _ (fun s => (PI / 2 - atan (t / sqrt (s ^ 2 + - t ^ 2))) * s / sqrt (s ^ 2 + - x ^ 2))).
    + apply (locally_near s (s - t)); [lra |]. intros r Hr. rewrite asin_sqrt by lra. reflexivity.
    + apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive.
      repeat split; try (apply Rgt_not_eq); try exact Hq; try exact Hd1; try exact Hp; try exact Hd2.
Qed.
