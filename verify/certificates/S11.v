(* Claim S11 of the ledger moore-hills, lines 182 to 182 of its source.
   Printed: For example, when we are $1\%$ of the distance from contact edge, when $m = 0$, the relative error of the one-term approximation is $\approx 0.4\%$, while for $m = 10$ it is $\approx6.4\%$.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Unique Scaling Tactics PowerLaw.
Open Scope R_scope.

Theorem S11_figure : exists p0 r0 r1 r2,
  is_the_pressure 1 (power_slope 1 10) 1 (99 / 100) p0 /\
  is_the_right_series 1 (power_slope 1 10) 1 r0 r1 r2 /\
  Rabs (Rabs (1 - r0 * ((1 - (99 / 100)) ^ 0 * sqrt (1 - (99 / 100))) / p0) - (8 / 125)) < (1 / 2000).
Proof.
  destruct (power_relative_error 1 1 10 1 (99 / 100) 10 ltac:(lra) ltac:(lra) ltac:(simpl; ring) ltac:(lra))
    as (p0 & r0 & r1 & r2 & Hp & Hr & E).
  exists p0, r0, r1, r2. split; [exact Hp |]. split; [exact Hr |].
  rewrite E. integrals. interval with (i_prec 90).
Qed.

(* The same at every scale: for all slopes h1 that are scaled copies, and all moduli. *)
Theorem S11_figure_similar : forall Fs lam mu h1, 0 < Fs -> 0 < lam -> 0 < mu ->
  (forall x, h1 (lam * x) = mu * power_slope 1 10 x) -> exists p0 r0 r1 r2,
  is_the_pressure Fs h1 (lam * 1) (lam * (99 / 100)) p0 /\
  is_the_right_series Fs h1 (lam * 1) r0 r1 r2 /\
  Rabs (Rabs (1 - r0 * ((lam * 1 - lam * (99 / 100)) ^ 0 * sqrt (lam * 1 - lam * (99 / 100))) / p0) - (8 / 125)) < (1 / 2000).
Proof.
  intros Fs lam mu h1 HFs Hlam Hmu Hh. destruct S11_figure as (p0 & r0 & r1 & r2 & Hp & Hr & H).
  apply (figure_scaled 1 Fs (power_slope 1 10) h1 lam mu 1 (99 / 100) p0 r0 r1 r2 (8 / 125) (1 / 2000)); first [assumption | lra].
Qed.
