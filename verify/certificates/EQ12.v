(* Claim EQ12 of the ledger moore-hills, lines 147 to 149 of its source.
   Printed: p(x) = \frac{E^{*}C}{\sqrt{\pi}}\frac{1+m}{2+m}\frac{\Gamma(2+m/2)}{\Gamma((3+m)/2)}\int_{x}^{a}\frac{s^{m}}{\sqrt{s^{2}-x^{2}}}\,\mbox{d}s.
   Says: Es*C/sqrt(Pi)*(1+m)/(2+m)*gamma(2+m/2)/gamma((3+m)/2)*integral(s^m/sqrt(s^2-x^2), s, x, a) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics Gamma PowerLaw.
Open Scope R_scope.

Ltac constants := idtac.
Ltac positive := constants; repeat split; lra.

Theorem EQ12 (Es C m a x : R) : forall Gam, is_gamma Gam ->
  0 < C /\ 0 <= m /\ 0 < a /\ 0 < x < a ->
  exists p0 l0,
  is_the_pressure Es (power_slope C m) a x p0 /\
  is_improper_integral (fun s => Rpower s m / sqrt (s ^ 2 - x ^ 2)) (x) (a) l0 /\
  Es * C / sqrt PI * (1 + m) / (2 + m) * Gam (2 + m / 2) / Gam ((3 + m) / 2) * l0 = p0.
Proof.
  intros Gam is_gamma_G form.
  eexists. eexists. 
  split. { apply power_the_pressure; lra. }
  split. { apply power_integral; lra. }
  identity_of_power_law is_gamma_G Gam m a.
Qed.

