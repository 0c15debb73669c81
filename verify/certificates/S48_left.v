(* Claim S48.left of the ledger moore-hills, lines 404 to 404 of its source.
   Printed: On the other hand, it overestimates the local shear tractions when the excitation comes from bulk tension alone.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric TiltedWedge Shear Unique Tactics Sides.
Open Scope R_scope.

Theorem S48_left_1 (a b sig0 : R) : 0 < a + b /\ sig0 <> 0 ->
  exists s0 s1 s2, is_the_left_shear_series (full_stick 0 sig0 a b) b s0 s1 s2 /\
  forall u, 0 < u < (a + b) / 2 -> Rabs (full_stick 0 sig0 a b (- b + u)) < Rabs s0 / sqrt u.
Proof.
  intros form. eexists. eexists. eexists.
  split. { apply the_left_shear_series, left_shear; lra. }
  intros u Hu. traction_at_edge. rewrite ?no_tension. apply tension_alone; lra.
Qed.

Theorem S48_left_2 (a b sig0 : R) : 0 < a + b /\ sig0 <> 0 ->
  exists s0 s1 s2, is_the_left_shear_series (full_stick 0 sig0 a b) b s0 s1 s2 /\
  forall u, 0 < u < a + b -> sign s0 * (full_stick 0 sig0 a b (- b + u)) < Rabs s0 / sqrt u.
Proof.
  intros form. eexists. eexists. eexists.
  split. { apply the_left_shear_series, left_shear; lra. }
  intros u Hu. traction_at_edge. rewrite ?no_tension. apply tension_signed; lra.
Qed.

