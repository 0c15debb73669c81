(* SPDX-License-Identifier: GPL-3.0-or-later *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Sides Symmetric Unique LoadOfPressure Forward.
Open Scope R_scope.

(* The stresses at the depth z > 0 under the pressure p on [-b, a], without shear: integrals of
   those of concentrated forces (Johnson, Contact mechanics, 1985, eqs. 2.23). *)
Definition are_the_stresses (p : R -> R) (b a x z sxx szz sxz : R) : Prop :=
  is_RInt (fun s => p s * (- (2 * z / PI) * (x - s) ^ 2 / ((x - s) ^ 2 + z ^ 2) ^ 2)) (- b) a sxx /\
  is_RInt (fun s => p s * (- (2 * z ^ 3 / PI) / ((x - s) ^ 2 + z ^ 2) ^ 2)) (- b) a szz /\
  is_RInt (fun s => p s * (- (2 * z ^ 2 / PI) * (x - s) / ((x - s) ^ 2 + z ^ 2) ^ 2)) (- b) a sxz.

(* The integral of c sqrt(a^2 - s^2) K(s) by s = a sin t. *)
Lemma over_the_angle (K : R -> R) c a : 0 < a -> (forall s, continuous K s) ->
  is_RInt (fun s => c * sqrt (a ^ 2 - s ^ 2) * K s) (- a) a
    (RInt (fun t => c * (a * cos t) ^ 2 * K (a * sin t)) (- (PI / 2)) (PI / 2)).
Proof.
  intros Ha HK. assert (Hpi := PI_RGT_0).
  set (f := fun s => c * sqrt (a ^ 2 - s ^ 2) * K s).
  assert (Hf : forall s, continuous f s).
  { intros s. apply (continuous_mult (fun s => c * sqrt (a ^ 2 - s ^ 2)) K); [| apply HK].
    apply (continuous_mult (fun _ => c)). { apply continuous_const. }
    apply (continuous_comp (fun s => a ^ 2 - s ^ 2) sqrt); [| apply continuous_sqrt].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial. }
  assert (Hi : ex_RInt f (- a) a) by (apply (@ex_RInt_continuous R_CompleteNormedModule); intros; apply Hf).
  replace (RInt (fun t => c * (a * cos t) ^ 2 * K (a * sin t)) (- (PI / 2)) (PI / 2)) with (RInt f (- a) a).
  { apply (@RInt_correct R_CompleteNormedModule), Hi. }
  transitivity (RInt f (a * sin (- (PI / 2))) (a * sin (PI / 2))).
  { rewrite sin_neg, sin_PI2. f_equal; ring. }
  rewrite <- (RInt_comp f (fun t => a * sin t) (fun t => a * cos t)).
  - apply RInt_ext. intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra.
    unfold scal; simpl; unfold mult; simpl. unfold f.
    replace (a ^ 2 - (a * sin t) ^ 2) with ((a * cos t) ^ 2).
    2:{ assert (E := sin2_cos2 t). unfold Rsqr in E. nra. }
    rewrite sqrt_pow2 by (apply Rlt_le, Rmult_lt_0_compat; [exact Ha | apply cos_gt_0; lra]). ring.
  - intros t _. apply Hf.
  - intros t _. split; [auto_derive; [trivial | ring] |].
    apply (@ex_derive_continuous R_AbsRing R_NormedModule). auto_derive. trivial.
Qed.

(* Under a parabola g' = C x. *)
Theorem stresses_of_parabola Es C a x z : 0 < C -> 0 < a -> 0 < z -> exists p,
  are_the_pressures Es (Symmetric.slope (parabola C)) a a p /\
  are_the_stresses p a a x z
    (RInt (fun t => Es * C / 2 * (a * cos t) ^ 2 * (- (2 * z / PI) * (x - a * sin t) ^ 2 / ((x - a * sin t) ^ 2 + z ^ 2) ^ 2)) (- (PI / 2)) (PI / 2))
    (RInt (fun t => Es * C / 2 * (a * cos t) ^ 2 * (- (2 * z ^ 3 / PI) / ((x - a * sin t) ^ 2 + z ^ 2) ^ 2)) (- (PI / 2)) (PI / 2))
    (RInt (fun t => Es * C / 2 * (a * cos t) ^ 2 * (- (2 * z ^ 2 / PI) * (x - a * sin t) / ((x - a * sin t) ^ 2 + z ^ 2) ^ 2)) (- (PI / 2)) (PI / 2)).
Proof.
  intros HC Ha Hz. assert (Hpi := PI_RGT_0).
  destruct (hertz_solves Es C a HC Ha) as (P & Hp & _). cbv beta zeta in Hp.
  eexists. split; [exact Hp |].
  assert (Hd : forall s, 0 < (x - s) ^ 2 + z ^ 2) by (intros s; assert (0 < z ^ 2) by (apply pow_lt, Hz); assert (0 <= (x - s) ^ 2) by apply pow2_ge_0; lra).
  repeat split; (apply over_the_angle; [exact Ha |]; intros s; apply (@ex_derive_continuous R_AbsRing R_NormedModule); auto_derive; specialize (Hd s); repeat split; trivial; apply Rgt_not_eq; nra).
Qed.
