(* Claim EQ14.N of the ledger moore-hills, lines 158 to 162 of its source.
   Printed: N_{I} & \, = && \,\frac{\sqrt{2}E^{*}C}{480\sqrt{\pi}}\frac{1+m}{2+m}\frac{\Gamma(2+m/2)}{\Gamma((3+m)/2)}a^{m-5/2}\left(129-272m+128m^{2}\right)
   Says: sqrt(2)*Es*C/(480*sqrt(Pi))*(1+m)/(2+m)*gamma(2+m/2)/gamma((3+m)/2)*a^(m-5/2)*(129 - 272*m + 128*m^2) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics Gamma PowerLaw.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ14_N (Es C m a : R) : forall Gam, is_gamma Gam ->
  0 < C /\ 0 <= m /\ 0 < a ->
  exists r0 r1 r2,
  is_the_right_series Es (power_slope C m) a r0 r1 r2 /\
  sqrt 2 * Es * C / (480 * sqrt PI) * (1 + m) / (2 + m) * Gam (2 + m / 2) / Gam ((3 + m) / 2) * Rpower a (m - 5 / 2) * (129 - 272 * m + 128 * m ^ 2) = r2.
Proof.
  intros Gam is_gamma_G form.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ 0); [apply power_slope_rises; lra | lra | apply right_edge with (1 := power_smooth_contact Es C m ltac:(lra) a ltac:(lra))]. }
  identity_of_power_law is_gamma_G Gam m a.
Qed.

