(* Claim EQ18 of the ledger moore-hills, lines 208 to 211 of its source.
   Printed: p(x) = \frac{E^{*}a}{\pi R}\int_{\max(x,t)}^{a}\left(\frac{\pi}{2} - \mathrm{arcsin}\frac{t}{s}\right)\frac{s}{\sqrt{s^{2}-x^{2}}}\,\mbox{d}s
   Says: Es*a/(Pi*R)*integral((Pi/2 - asin(t/s))*s/sqrt(s^2-x^2), s, max(x,t), a) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics FlatAndRounded.
Open Scope R_scope.

Definition Es : R := 1.
Definition t : R := 3.
Definition R0 : R := 1.
Definition a : R := 5.
Definition x : R := 4.
Definition punch : list part := cons (Part t 0 (1 / R0)) nil.
Ltac constants := unfold punch, x, a, R0, t, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem EQ18_refuted : exists l0 p0,
  is_improper_integral (fun s => (PI / 2 - asin (t / s)) * s / sqrt (s ^ 2 - x ^ 2)) (Rmax x t) (a) l0 /\
  is_the_pressure Es (slope punch) a x p0 /\
  306 / 10 ^ 2 <= Rabs ((Es * a / (PI * R0) * l0) - (p0)).
Proof.
  eexists. eexists. 
  split. { apply rounded_integral; positive. }
  split. { apply (the_pressure _ _ (first punch)); [apply punch_rises; convex constants | before constants | apply (pressure Es punch ((t + x) / 2)); sides constants]. }
  numbers constants.
Qed.

Theorem EQ18_corrected : exists l0 p0,
  is_improper_integral (fun s => (PI / 2 - asin (t / s)) * s / sqrt (s ^ 2 - x ^ 2)) (Rmax x t) (a) l0 /\
  is_the_pressure Es (slope punch) a x p0 /\
  Rabs ((Es / (PI * R0) * l0) - (p0)) <= 1 / 10 ^ 12 * Rabs (p0).
Proof.
  eexists. eexists. 
  split. { apply rounded_integral; positive. }
  split. { apply (the_pressure _ _ (first punch)); [apply punch_rises; convex constants | before constants | apply (pressure Es punch ((t + x) / 2)); sides constants]. }
  apply Rminus_le. numbers constants.
Qed.

