(* Claim S52.together of the ledger moore-hills, lines 410 to 411 of its source.
   Printed: even if the condition given in (\ref{eqn:Vanishing_Adhered_Coefficient}) holds, higher order
terms show that the same pattern of underestimation of the effect of a shear force and over estimation of the effect of bulk tension will continue to apply
   Says: subtract *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Tactics Shear Unique.
Open Scope R_scope.

Theorem S52_together (a b Q sig0 : R) : 0 < a + b /\ Q <> 0 ->
  exists s0 s1 s2 t0 t1 t2 v0 v1 v2,
  is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
  is_the_right_shear_series (full_stick Q 0 a b) a t0 t1 t2 /\
  is_the_right_shear_series (full_stick 0 sig0 a b) a v0 v1 v2 /\
  s2 = t2 + v2 /\
  s1 = t1 + v1 /\
  (s1 = 0 -> t2 * v2 < 0).
Proof.
  intros form.
  eexists. eexists. eexists. eexists. eexists. eexists. eexists. eexists. eexists. 
  split. { apply the_right_shear_series, right_shear; lra. }
  split. { apply the_right_shear_series, right_shear; lra. }
  split. { apply the_right_shear_series, right_shear; lra. }
  do 2 (split; [unfold shear_0, shear_1, shear_2, Rdiv; ring |]).
  intros H. parts_by_sign H a b sig0.
Qed.

