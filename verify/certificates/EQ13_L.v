(* Claim EQ13.L of the ledger moore-hills, lines 151 to 156 of its source.
   Printed: \frac{E^{*}C}{\sqrt{\pi}}\frac{1+m}{2+m}\frac{\Gamma(2+m/2)}{\Gamma((3+m)/2)}a^{m}\left[\sqrt{\frac{2}{a}}\sqrt{a-x}
   Says: Es*C/sqrt(Pi)*(1+m)/(2+m)*gamma(2+m/2)/gamma((3+m)/2)*a^m*sqrt(2/a) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics Gamma PowerLaw.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ13_L (Es C m a : R) : forall Gam, is_gamma Gam ->
  0 < C /\ 0 <= m /\ 0 < a ->
  exists r0 r1 r2,
  is_the_right_series Es (power_slope C m) a r0 r1 r2 /\
  Es * C / sqrt PI * (1 + m) / (2 + m) * Gam (2 + m / 2) / Gam ((3 + m) / 2) * Rpower a m * sqrt (2 / a) = r0.
Proof.
  intros Gam is_gamma_G form.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ 0); [apply power_slope_rises; lra | lra | apply right_edge with (1 := power_smooth_contact Es C m ltac:(lra) a ltac:(lra))]. }
  identity_of_power_law is_gamma_G Gam m a.
Qed.

