(* Claim S10 of the ledger moore-hills, lines 182 to 182 of its source.
   Printed: For example, when we are $1\%$ of the distance from contact edge, when $m = 0$, the relative error of the one-term approximation is $\approx 0.4\%$, while for $m = 10$ it is $\approx6.4\%$.
   Says: in words *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics Scaling.
Open Scope R_scope.

Definition Es : R := 1.
Definition C : R := 1.
Definition a : R := 1.
Definition x : R := (99 / 100).
Definition wedge : list part := cons (Part 0 C 0) nil.
Ltac constants := unfold wedge, x, a, C, Es in *.
Ltac positive := constants; repeat split; lra.

Theorem S10_figure : exists p0 r0 r1 r2,
  is_the_pressure Es (slope wedge) a x p0 /\
  is_the_right_series Es (slope wedge) a r0 r1 r2 /\
  Rabs ((Rabs (1 - (r0 * ((a - x) ^ 0 * sqrt (a - x))) / p0)) - (1 / 250)) < (1 / 2000).
Proof.
  eexists. eexists. eexists. eexists. 
  split. { apply (the_pressure _ _ (first wedge)); [apply punch_rises; convex constants | before constants | apply (pressure Es wedge (x / 2)); sides constants]. }
  split. { apply (the_right_series _ _ (first wedge)); [apply punch_rises; convex constants | before constants | apply right_edge with (1 := smooth_contact Es wedge (x / 2) a ltac:(sides constants) ltac:(sides constants))]. }
  numbers constants.
Qed.

(* The same at every scale: for all slopes h1 that are scaled copies, and all moduli. *)
Theorem S10_figure_similar : forall Fs lam mu h1, 0 < Fs -> 0 < lam -> 0 < mu ->
  (forall x, h1 (lam * x) = mu * slope wedge x) ->
  exists p0 r0 r1 r2, is_the_pressure Fs h1 (lam * a) (lam * x) p0 /\
  is_the_right_series Fs h1 (lam * a) r0 r1 r2 /\
  Rabs (Rabs (1 - r0 * ((lam * a - lam * x) ^ 0 * sqrt (lam * a - lam * x)) / p0) - (1 / 250)) < (1 / 2000).
Proof.
  intros Fs lam mu h1 HFs Hlam Hmu Hh. destruct S10_figure as (p0 & r0 & r1 & r2 & Hp & Hr & H).
  apply (figure_scaled Es Fs (slope wedge) h1 lam mu a x p0 r0 r1 r2 (1 / 250) (1 / 2000)); try assumption; first [sides constants | lra].
Qed.
