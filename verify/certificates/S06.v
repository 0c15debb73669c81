(* Claim S06 of the ledger moore-hills, lines 164 to 164 of its source.
   Printed: Secondly, by considering the coefficient $M_{I}$, we can see that we under-estimate the contact pressure with the one-term approximation when $m < 5/8$, which includes, for example, a wedge-shaped body, while for $m>5/8$ --- including the Hertzian geometry --- the one-term approximation overestimates the contact pressure.
   Says: right_local(1, x) < p(x) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric TiltedWedge Shear Unique Tactics Sides Gamma PowerLaw PowerSides.
Open Scope R_scope.

Theorem S06_1 (Es C m a : R) : 0 < Es /\ 0 < C /\ 0 <= m < 5 / 8 /\ 0 < a ->
  exists r0 r1 r2, is_the_right_series Es (power_slope C m) a r0 r1 r2 /\
  exists d, 0 < d /\ forall u, 0 < u < d -> exists p0, is_the_pressure Es (power_slope C m) a (a - u) p0 /\
  (r0 * sqrt u < p0).
Proof.
  intros form. near_edge_by (power_one_term_below Es C m a form).
Qed.

Theorem S06_2 (Es C m a : R) : 0 < Es /\ 0 < C /\ 0 <= m < 5 / 8 /\ 0 < a ->
  exists r0 r1 r2, is_the_right_series Es (power_slope C m) a r0 r1 r2 /\
  forall u, 0 < u < a -> exists p0, is_the_pressure Es (power_slope C m) a (a - u) p0 /\
  (r0 * sqrt u < p0).
Proof.
  intros form. by_first_terms (power_one_term_below Es C m a form).
Qed.

