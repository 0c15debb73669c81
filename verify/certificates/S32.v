(* Claim S32 of the ledger moore-hills, lines 324 to 334 of its source.
   Printed: We plot the relative error of the one-, two- and three-term approximations of the contact pressure at each contact edge for $\alpha = \pi/20$ ($\gamma\approx0.03$) in figure \ref{fig:RelErrorWedge1}.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Edges TiltedWedge Unique Tactics Limits.
Open Scope R_scope.

Theorem S32_figure (a : R) : 0 < a ->
  exists b, is_the_left_edge (slope (PI / 16) (PI / 20)) a b /\ Rabs (b / a - (3 / 100)) < (1 / 200).
Proof.
  intros Ha. assert (Hpi := PI_RGT_0). exists (ratio_of (PI / 16) (PI / 20) * a).
  split; [apply left_edge_by_tilt; first [exact Ha | lra | split; interval] |].
  replace (ratio_of (PI / 16) (PI / 20) * a / a) with (ratio_of (PI / 16) (PI / 20)) by (field; lra).
  unfold ratio_of. interval with (i_prec 60).
Qed.
