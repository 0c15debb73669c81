(* Claim S07 of the ledger moore-hills, lines 164 to 164 of its source.
   Printed: Secondly, by considering the coefficient $M_{I}$, we can see that we under-estimate the contact pressure with the one-term approximation when $m < 5/8$, which includes, for example, a wedge-shaped body, while for $m>5/8$ --- including the Hertzian geometry --- the one-term approximation overestimates the contact pressure.
   Says: right_local(1, x) > p(x) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric TiltedWedge Shear Unique Tactics Sides Gamma PowerLaw PowerSides PowerError.
Open Scope R_scope.

Theorem S07_1 (Es C m a : R) : 0 < Es /\ 0 < C /\ 5 / 8 < m /\ 0 < a ->
  exists r0 r1 r2, is_the_right_series Es (power_slope C m) a r0 r1 r2 /\
  exists d, 0 < d /\ forall u, 0 < u < d -> exists p0, is_the_pressure Es (power_slope C m) a (a - u) p0 /\
  (p0 < r0 * sqrt u).
Proof.
  intros form. near_edge_by (power_above_near_edge Es C m a form).
Qed.

Theorem S07_2 : exists p0 r0 r1 r2,
  is_the_pressure 1 (power_slope 1 (13 / 20)) 1 (1 - 9 / 10) p0 /\
  is_the_right_series 1 (power_slope 1 (13 / 20)) 1 r0 r1 r2 /\
  r0 * sqrt (9 / 10) < p0.
Proof.
  destruct (power_ratio (13 / 20) (9 / 10) ltac:(lra) ltac:(lra)) as (p0 & r0 & r1 & r2 & Hp & Hr & H0 & E).
  exists p0, r0, r1, r2. split; [exact Hp |]. split; [exact Hr |].
  apply (below_by_ratio _ _ H0). rewrite E. square_root_integrals. interval with (i_prec 60).
Qed.

