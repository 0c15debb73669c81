(* Claim S12 of the ledger moore-hills, lines 182 to 182 of its source.
   Printed: for the special case of $m = 5/8$, the one- and two-term approximations are identical.
   Says: right.c0*sqrt(a-x) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges Unique Tactics Gamma PowerLaw.
Open Scope R_scope.

Theorem S12 (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) (y factor : R) :
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) ->
  (forall s, 0 < s -> P s = factor * Rpower s (13 / 8)) ->
  rises_at g1 y /\ y < a ->
  exists r0 r1 r2,
  is_the_right_series Es g1 a r0 r1 r2 /\
  forall x, x < a ->
  r0 * sqrt (a - x) =
  r0 * sqrt (a - x) + r1 * Rpower (a - x) (3 / 2).
Proof.
  intros contact load convex.
  eexists. eexists. eexists. 
  split. { apply (the_right_series _ _ y); [apply convex | apply convex | exact (right_edge _ _ _ _ _ _ _ _ _ _ contact)]. }
  intros x Hx. identity_of_power contact load a P1 P2 P3.
Qed.

(* The punch |x|^m has such a load. *)
Theorem S12_derived (Es C a : R) : 0 < C /\ 0 < a ->
  exists r0 r1 r2,
  is_the_right_series Es (power_slope C (5 / 8)) a r0 r1 r2 /\
  forall x, x < a ->
  r0 * sqrt (a - x) =
  r0 * sqrt (a - x) + r1 * Rpower (a - x) (3 / 2).
Proof.
  intros form. apply (S12 Es (power_slope C (5 / 8)) a (PowerLaw.power_load Es C (5 / 8)) (power_load_1 Es C (5 / 8))
    (power_load_2 Es C (5 / 8)) (power_load_3 Es C (5 / 8)) 0 (Es * C * wallis ((5 / 8) + 1))).
  - apply power_smooth_contact; lra.
  - intros s Hs. unfold PowerLaw.power_load. do 2 f_equal. field.
  - split; [apply power_slope_rises; lra | lra].
Qed.
