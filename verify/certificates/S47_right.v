(* Claim S47.right of the ledger moore-hills, lines 403 to 404 of its source.
   Printed: we note that the single
term --- i.e. $q_{\mathrm{local}} \sim K_{II}^{\pm}/\sqrt{d\mp\hat{x}}$ underestimates the shear traction induced when the excitation comes from a shear force alone.
   Says: abs(right.s0)/sqrt(u) < abs(q(x)) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric TiltedWedge Shear Unique Tactics Sides.
Open Scope R_scope.

Theorem S47_right (a b Q : R) : 0 < a + b /\ Q <> 0 ->
  exists s0 s1 s2, is_the_right_shear_series (full_stick Q 0 a b) a s0 s1 s2 /\
  forall u, 0 < u < a + b -> Rabs s0 / sqrt u < Rabs (full_stick Q 0 a b (a - u)).
Proof.
  intros form. eexists. eexists. eexists.
  split. { apply the_right_shear_series, right_shear; lra. }
  intros u Hu. traction_at_edge. rewrite ?no_tension. apply force_alone; lra.
Qed.

