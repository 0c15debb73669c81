(* Claim EQ11 of the ledger moore-hills, lines 143 to 145 of its source.
   Printed: P(a) = \frac{E^{*}C\sqrt{\pi}}{2+m}\frac{\Gamma(2+m/2)}{\Gamma((3+m)/2)} a^{m+1},
   Says: Es*C*sqrt(Pi)/(2+m)*gamma(2+m/2)/gamma((3+m)/2)*a^(m+1) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics Gamma PowerLaw.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ11 (Es C m a : R) : forall Gam, is_gamma Gam ->
  0 < C /\ 0 <= m /\ 0 < a ->
  exists P0,
  is_the_load Es (power_slope C m) a a P0 /\
  Es * C * sqrt PI / (2 + m) * Gam (2 + m / 2) / Gam ((3 + m) / 2) * Rpower a (m + 1) = P0.
Proof.
  intros Gam is_gamma_G form.
  eexists. 
  split. { apply power_the_load; lra. }
  identity_of_power_law is_gamma_G Gam m a.
Qed.

