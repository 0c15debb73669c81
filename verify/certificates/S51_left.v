(* Claim S51.left of the ledger moore-hills, lines 410 to 410 of its source.
   Printed: On the side where they are subtractive the second order terms add in magnitude.
   Says: add *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique.
Open Scope R_scope.

Theorem S51_left (a b Q sig0 : R) : 0 < a + b /\ Q <> 0 ->
  exists s0 s1 s2 t0 t1 t2 v0 v1 v2 w0 w1 w2,
  is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
  is_the_left_shear_series (full_stick Q 0 a b) b t0 t1 t2 /\
  is_the_left_shear_series (full_stick 0 sig0 a b) b v0 v1 v2 /\
  is_the_left_shear_series (full_stick Q sig0 a b) b w0 w1 w2 /\
  w1 = t1 + v1 /\
  s1 = t1 - v1 /\
  (s1 = 0 -> 0 < t1 * v1).
Proof.
  intros form.
  eexists. eexists. eexists. eexists. eexists. eexists. eexists. eexists. eexists. eexists. eexists. eexists. 
  split. { apply the_right_shear_series, right_shear; lra. }
  split. { apply the_left_shear_series, left_shear; lra. }
  split. { apply the_left_shear_series, left_shear; lra. }
  split. { apply the_left_shear_series, left_shear; lra. }
  do 2 (split; [unfold shear_0, shear_1, shear_2, Rdiv; ring |]).
  intros H. parts_by_sign H a b sig0.
Qed.

