(* Claim EQ07.integrand of the ledger moore-hills, lines 115 to 118 of its source.
   Printed: \left[P'(a) + \ve\left(\frac{P'(a)}{a}(X+S) - SP''(a)\right) + \right. \nonumber \\
 & \, && \, \left. \ve^{2}\left(\frac{3P'(a)}{32a^{2}}(X+S)^{2} - \frac{SP''(a)}{4a}(X+S) + \frac{S^{2}P'''(a)}{2}\right) + O(\ve^{3})\right] \,\mbox{d}S,
   Says: P1 + eps*(P1/a*(X+S) - S*P2) + eps^2*(3*P1/(32*a^2)*(X+S)^2 - S*P2/(4*a)*(X+S) + S^2*P3/2) *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm Symmetric Unique Tactics Expansions HalfPowers PressureExpansions Curved.
Open Scope R_scope.

Theorem EQ07_integrand_refuted (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) :
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) ->
  forall S X : R,
  (((S + X) * (P1 a) - S * a * (P2 a)) / a) - (((S + X) * (P1 a) - 4 * S * a * (P2 a)) / (4 * a)) <> 0 ->
  ~ agrees_through 2 (fun eps => P1 (a - eps * S) / sqrt (1 - eps * (X + S) / (2 * a)))
    (fun eps => (P1 a) + eps * ((P1 a) / a * (X + S) - S * (P2 a)) + eps ^ 2 * (3 * (P1 a) / (32 * a ^ 2) * (X + S) ^ 2 - S * (P2 a) / (4 * a) * (X + S) + S ^ 2 * (P3 a) / 2)).
Proof.
  intros contact S X differ.
  symmetric_facts contact.
  pose proof (integrand_through_2 _ _ _ _ _ _ _ S X contact) as derived.
  intros printed. apply differ, Rminus_diag_eq.
  assert (polynomial : agrees_through 2 (fun eps => (P1 (a - eps * S) / sqrt (1 - eps * (X + S) / (2 * a)))) (fun u => ((P1 a)) + (((S + X) * (P1 a) - S * a * (P2 a)) / a) * u + ((3 * (S + X) ^ 2 * (P1 a) - 8 * S * a * (S + X) * (P2 a) + 16 * S ^ 2 * a ^ 2 * (P3 a)) / (32 * a ^ 2)) * u ^ 2)).
  { apply (agrees_ext _ _ _ _ printed). intros u. field; repeat split; lra. }
  destruct (unique_2 _ _ _ _ _ _ _ derived polynomial) as (E0 & E1 & E2).
  transitivity_of E1; field; repeat split; lra.
Qed.

Theorem EQ07_integrand_corrected (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) :
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) ->
  forall S X : R,
  agrees_through 2 (fun eps => P1 (a - eps * S) / sqrt (1 - eps * (X + S) / (2 * a)))
    (fun eps => (P1 a) + eps * ((P1 a) / a * (X + S) / 4 - S * (P2 a)) + eps ^ 2 * (3 * (P1 a) / (32 * a ^ 2) * (X + S) ^ 2 - S * (P2 a) / (4 * a) * (X + S) + S ^ 2 * (P3 a) / 2)).
Proof.
  intros contact S X.
  symmetric_facts contact.
  pose proof (integrand_through_2 _ _ _ _ _ _ _ S X contact) as derived.
  apply (agrees_ext _ _ _ _ derived). intros u. field; repeat split; lra.
Qed.

Theorem EQ07_integrand_instance : exists (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) (y : R),
  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) /\
  (rises_at g1 y /\ y < a) /\
  exists S X : R, (((S + X) * (P1 a) - S * a * (P2 a)) / a) - (((S + X) * (P1 a) - 4 * S * a * (P2 a)) / (4 * a)) <> 0.
Proof.
  exists 1, (slope wedge), 1, (load 1 wedge), (rate 1 wedge), (rate_2 1 wedge), (rate_3 1 wedge), (first wedge).
  split; [apply (smooth_contact 1 wedge (1 / 2) 1); sides ltac:(unfold wedge) |].
  split; [split; [apply punch_rises; convex ltac:(unfold wedge) | before ltac:(unfold wedge)] |].
  exists 1, 1. apply apart. numbers ltac:(unfold wedge).
Qed.

