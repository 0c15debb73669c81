(* SPDX-License-Identifier: BSD-3-Clause *)
From Coq Require Import Reals Lra Lia.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Edgeproof Require Import Contact Coefficients Edges ClosedForm TiltedWedge Symmetric Shear Unique.
Open Scope R_scope.

Lemma power_3_2 x : 0 < x -> Rpower x (3 / 2) = x * sqrt x.
Proof.
  intros H. replace (3 / 2) with (1 + / 2) by field.
  rewrite Rpower_plus, Rpower_1, Rpower_sqrt by exact H. reflexivity.
Qed.
Lemma power_5_2 x : 0 < x -> Rpower x (5 / 2) = x ^ 2 * sqrt x.
Proof.
  intros H. replace (5 / 2) with (INR 2 + / 2) by (simpl; field).
  rewrite Rpower_plus, Rpower_pow, Rpower_sqrt by exact H. reflexivity.
Qed.

Lemma positive_width Es g1 a P P1 P2 P3 b b1 b2 :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 -> 0 < a + b a.
Proof. intros [eta [He H]]. destruct (H a ltac:(lra)) as ((H0 & _) & _). exact H0. Qed.

Lemma rate_positive a b b1 b2 b3 alpha : is_left_edge a b b1 b2 b3 alpha -> 0 < b1 a.
Proof. intros [_ [eta [He [H _]]]]. apply (H a). lra. Qed.

Lemma root_of_twice a : 0 < a -> sqrt (a + a) = sqrt 2 * sqrt a.
Proof. intros H. rewrite <- sqrt_mult by lra. f_equal. ring. Qed.
Lemma root_of_2_over a : 0 < a -> sqrt (2 / a) = sqrt 2 / sqrt a.
Proof. intros H. apply sqrt_div_alt. exact H. Qed.

(* An identity in the derivatives of P and b and the square root of a + b: over the rationals in the
   root r, where a + b = r r. *)
Ltac identity contact left a b b1 :=
  let Hw := fresh "Hw" in let Hb := fresh "Hb" in let Hr := fresh "Hr" in let E := fresh "E" in
  let Hpi := fresh "Hpi" in
  assert (Hw := positive_width _ _ _ _ _ _ _ _ _ _ contact);
  assert (Hb := rate_positive _ _ _ _ _ _ left);
  assert (Hpi := PI_RGT_0);
  unfold c0, c1, c2, left_c0, left_c1, left_c2; cbv beta;
  rewrite ?power_3_2, ?power_5_2 by exact Hw;
  assert (Hr : 0 < sqrt (a + b a)) by (apply sqrt_lt_R0; exact Hw);
  assert (E : a + b a = sqrt (a + b a) * sqrt (a + b a)) by (symmetry; apply sqrt_sqrt; lra);
  set (r := sqrt (a + b a)) in *; clearbody r; rewrite ?E; field; lra.

(* A root of x by its power. *)
Lemma root_power x e n m : 0 < x -> e * INR n = INR m -> Rpower x e ^ n = x ^ m.
Proof.
  intros Hx E. rewrite <- !Rpower_pow by (try exact Hx; apply exp_pos).
  rewrite Rpower_mult, E. reflexivity.
Qed.

(* The same with b = a: over the rationals in r, a = r r, and q = sqrt 2. A remaining root of a, of
   another order than 2, is replaced by a number c with c ^ n = a ^ m. *)
Ltac identity_symmetric contact a P1 P2 P3 :=
  let Hw := fresh "Hw" in let Ha := fresh "Ha" in let Hr := fresh "Hr" in let E := fresh "E" in
  let Hpi := fresh "Hpi" in let Hq := fresh "Hq" in let E2 := fresh "E2" in
  assert (Hw := positive_width _ _ _ _ _ _ _ _ _ _ contact); cbv beta in Hw;
  assert (Ha : 0 < a) by lra; assert (Hpi := PI_RGT_0); clear contact;
  unfold c0, c1, c2; cbv beta;
  generalize (P1 a) (P2 a) (P3 a); intros p1 p2 p3;
  rewrite ?power_3_2, ?power_5_2 by lra;
  rewrite ?root_of_twice, ?root_of_2_over by exact Ha;
  assert (Hr : 0 < sqrt a) by (apply sqrt_lt_R0; exact Ha);
  assert (E : a = sqrt a * sqrt a) by (symmetry; apply sqrt_sqrt; lra);
  assert (Hq : 0 < sqrt 2) by (apply sqrt_lt_R0; lra);
  assert (E2 : sqrt 2 ^ 2 = 2) by (apply pow2_sqrt; lra);
  set (q := sqrt 2) in *; set (r := sqrt a) in *; clearbody r q;
  lazymatch goal with
  | |- context [Rpower a (IZR ?p / IZR ?n)] =>
    let n' := eval compute in (Z.to_nat n) in let m' := eval compute in (Z.to_nat p) in
    let c := fresh "c" in let Ec := fresh "Ec" in let Hc := fresh "Hc" in
    assert (Ec := root_power a (IZR p / IZR n) n' m' Ha ltac:(simpl; field));
    assert (Hc : 0 < Rpower a (IZR p / IZR n)) by apply exp_pos;
    set (c := Rpower a (IZR p / IZR n)) in *; clearbody c; rewrite ?E in Ec; rewrite ?E;
    field_simplify_eq; [ring [E2 Ec] | repeat split; lra]
  | |- _ => rewrite ?E; field_simplify_eq; [ring [E2] | repeat split; lra]
  end.

(* What a load in proportion to a power of a says of its derivatives. *)
Lemma derive_power f q s : 0 < s -> is_derive (fun s => f * Rpower s q) s (f * q * Rpower s (q - 1)).
Proof.
  intros Hs. unfold Rpower. auto_derive; [exact Hs |].
  replace ((q - 1) * ln s) with (q * ln s + - ln s) by ring.
  rewrite exp_plus, exp_Ropp, exp_ln by exact Hs. field. lra.
Qed.
Lemma power_load Es g1 a P P1 P2 P3 b b1 b2 f q :
  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 -> 0 < a ->
  (forall s, 0 < s -> P s = f * Rpower s q) -> P2 a = (q - 1) * P1 a / a.
Proof.
  intros [eta [He H]] Ha HP.
  assert (H1 : forall s, 0 < s -> a - eta < s < a + eta -> P1 s = f * q * Rpower s (q - 1)).
  { intros s Hs Hn. destruct (H s Hn) as ((_ & _ & _ & Hd) & _).
    apply is_derive_unique in Hd. rewrite <- Hd. apply is_derive_unique.
    apply (is_derive_ext_loc (fun s => f * Rpower s q)); [| apply derive_power; exact Hs].
    apply (locally_near s s); [exact Hs |]. intros r Hr. symmetry. apply HP. lra. }
  destruct (H a ltac:(lra)) as (_ & Hd & _).
  apply is_derive_unique in Hd. rewrite <- Hd, (H1 a) by lra.
  rewrite (is_derive_unique P1 a (f * q * (q - 1) * Rpower a (q - 1 - 1))).
  - assert (E : Rpower a (q - 1) = Rpower a (q - 1 - 1) * a).
    { rewrite <- (Rpower_1 a) at 3 by exact Ha. rewrite <- Rpower_plus. f_equal. ring. }
    rewrite E. field. lra.
  - apply (is_derive_ext_loc (fun s => f * q * Rpower s (q - 1))); [| apply derive_power; exact Ha].
    apply (locally_near a (Rmin eta a)); [apply Rmin_pos; lra |]. intros r Hr.
    generalize (Rmin_l eta a) (Rmin_r eta a). intros. symmetry. apply H1; lra.
Qed.

(* An identity of such a load. *)
Ltac identity_of_power contact load a P1 P2 P3 :=
  let Hw := fresh "Hw" in
  assert (Hw := positive_width _ _ _ _ _ _ _ _ _ _ contact); cbv beta in Hw;
  unfold c0, c1, c2; cbv beta;
  rewrite (power_load _ _ _ _ _ _ _ _ _ _ _ _ contact ltac:(lra) load);
  identity_symmetric contact a P1 P2 P3.

(* ---- Identities for all contacts of a form, in their parameters ---- *)

(* Closes an identity over the rationals in numbers whose squares are given by E1, E2 and E3. *)
Ltac by_squares E1 E2 E3 :=
  first [reflexivity | field; repeat split; nra | field_simplify_eq; [ring [E1 E2 E3] | repeat split; nra]].

(* Full stick between the edges a and -b, in the root of a + b. *)
Ltac identity_of_shear a b :=
  let E := fresh "E" in let Hpi := fresh "Hpi" in let Hr := fresh "Hr" in let r := fresh "r" in
  assert (Hpi := PI_RGT_0);
  unfold shear_0, shear_1, shear_2; cbv beta;
  replace (2 * ((a + b) / 2)) with (a + b) by field;
  rewrite ?power_3_2, ?power_5_2 by lra;
  assert (Hr : 0 < sqrt (a + b)) by (apply sqrt_lt_R0; lra);
  assert (E : a + b = sqrt (a + b) * sqrt (a + b)) by (symmetry; apply sqrt_sqrt; lra);
  set (r := sqrt (a + b)) in *; clearbody r; rewrite ?E; field; repeat split; lra.

(* A tilted wedge with the edges a and - gam a, in the roots of a, gam and 1 + gam. *)
Ltac identity_of_wedge a gam :=
  let Hg := fresh "Hg" in let Ha := fresh "Ha" in let Hw := fresh "Hw" in let Hpi := fresh "Hpi" in
  let Eg := fresh "Eg" in let Ea := fresh "Ea" in let Ew := fresh "Ew" in
  let g := fresh "g" in let r := fresh "r" in let w := fresh "w" in
  assert (Hpi := PI_RGT_0);
  unfold c0, c1, c2, left_c0, left_c1, left_c2; cbv beta;
  rewrite ?sin_of_tilt by lra;
  replace (a + gam * a) with ((1 + gam) * a) by ring;
  rewrite ?power_3_2, ?power_5_2 by nra;
  rewrite ?(sqrt_mult (1 + gam) a) by lra;
  assert (Hg : 0 < sqrt gam) by (apply sqrt_lt_R0; lra);
  assert (Ha : 0 < sqrt a) by (apply sqrt_lt_R0; lra);
  assert (Hw : 0 < sqrt (1 + gam)) by (apply sqrt_lt_R0; lra);
  assert (Eg : gam = sqrt gam * sqrt gam) by (symmetry; apply sqrt_sqrt; lra);
  assert (Ea : a = sqrt a * sqrt a) by (symmetry; apply sqrt_sqrt; lra);
  assert (Ew : sqrt (1 + gam) ^ 2 = 1 + gam) by (apply pow2_sqrt; lra);
  set (g := sqrt gam) in *; set (r := sqrt a) in *; set (w := sqrt (1 + gam)) in *;
  clearbody g r w; rewrite ?Eg in Ew; rewrite ?Eg, ?Ea; by_squares Ew Ew Ew.

(* A flat punch with rounded edges, in asin (t / a) and the roots of a, 2 and a^2 - t^2. *)
Ltac identity_of_rounded t a :=
  let Hpi := fresh "Hpi" in let Hd := fresh "Hd" in let Hr := fresh "Hr" in let Hq := fresh "Hq" in
  let Hs := fresh "Hs" in let E := fresh "E" in let E2 := fresh "E2" in let E3 := fresh "E3" in
  let w := fresh "w" in let z := fresh "z" in let r := fresh "r" in let q := fresh "q" in
  assert (Hpi := PI_RGT_0);
  assert (Hd : 0 < a ^ 2 - t ^ 2) by
    (replace (a ^ 2 - t ^ 2) with ((a - t) * (a + t)) by ring; apply Rmult_lt_0_compat; lra);
  unfold c0, c1, c2, load, rate, rate_2, rate_3, total, List.fold_right, part_load, part_rate, part_rate_2,
    part_rate_3, angle, from, corner, curvature; cbv beta;
  rewrite ?asin_sqrt by lra;
  rewrite ?power_3_2, ?power_5_2 by lra;
  replace (2 * a) with (a + a) by ring;
  rewrite ?root_of_twice by lra;
  assert (Hr : 0 < sqrt a) by (apply sqrt_lt_R0; lra);
  assert (Hq : 0 < sqrt 2) by (apply sqrt_lt_R0; lra);
  assert (Hs : 0 < sqrt (a ^ 2 - t ^ 2)) by (apply sqrt_lt_R0; lra);
  generalize (atan (t / sqrt (a ^ 2 - t ^ 2))); intros z;
  assert (E : sqrt a ^ 2 = a) by (apply pow2_sqrt; lra);
  assert (E2 : sqrt 2 ^ 2 = 2) by (apply pow2_sqrt; lra);
  assert (E3 : sqrt (a ^ 2 - t ^ 2) ^ 2 = a ^ 2 - t ^ 2) by (apply pow2_sqrt; lra);
  set (w := sqrt (a ^ 2 - t ^ 2)) in *; set (r := sqrt a) in *; set (q := sqrt 2) in *;
  clearbody w r q; by_squares E E2 E3.

(* What the numbers of a theorem are made of. `constants` unfolds those of its file. *)
Ltac plain constants :=
  constants;
  cbv beta iota zeta delta [c0 c1 c2 left_c0 left_c1 left_c2 shear_0 shear_1 shear_2 total load rate rate_2 rate_3
    List.fold_right part_load part_rate part_rate_2 part_rate_3 part_pressure angle from corner curvature
    proportional_pressure ratio_of scaled part_scaled proportional_scaled].

(* Bounds of the integrals in the goal, then of the rest. *)
Ltac integrals :=
  rewrite ?asin_sqrt by lra; unfold atanh, Rpower;
  repeat match goal with |- context [RInt ?f ?l ?u] =>
    let H := fresh "H" in
    integral_intro (RInt f l u) with (i_prec 80, i_relwidth 46, i_degree 15, i_fuel 5000) as H;
    revert H; generalize (RInt f l u); intros ? H
  end.
Ltac numbers constants := plain constants; integrals; interval with (i_prec 90).

(* That a number made of fractions, pi and roots is zero. *)
Ltac vanishes constants :=
  plain constants; field; repeat split; first [lra | apply Rgt_not_eq; interval | apply Rlt_not_eq; interval].

(* That numbers are in order, knots before places before edges. *)
Ltac sides constants :=
  unfold beyond; constants; repeat apply List.Forall_cons; try apply List.Forall_nil; cbn [from];
  repeat split; first [lra | interval with (i_prec 200)].

(* That a punch is convex, and that it rises at a place before x. *)
Ltac convex constants :=
  constants; hnf; split; repeat apply List.Forall_cons; try apply List.Forall_nil; unfold is_convex_part;
  cbn [from corner curvature]; repeat split; first [lra | interval with (i_prec 200)].
Ltac before constants :=
  constants; unfold first; cbn [from]; repeat split; first [lra | interval with (i_prec 200)].

(* ---- Extents ---- *)

Lemma sum_1 q A : A * q = q * A.
Proof. ring. Qed.
Lemma sum_2 q A B u : A * q + B * (u * q) = q * (A + B * u).
Proof. ring. Qed.
Lemma sum_3 q A B C u : A * q + B * (u * q) + C * (u ^ 2 * q) = q * (A + B * u + C * u ^ 2).
Proof. ring. Qed.

(* |p - sum| <= tolerance p for 0 < u <= d, p being sqrt u times a sum in which y^2 <= e for each
   atanh_ratio y: the root of u is taken out. *)
Ltac near_the_edge constants u d e :=
  let H := fresh "H" in
  assert (H : 0 <= u <= d) by lra;
  first [rewrite (sum_3 (sqrt u)) | rewrite (sum_2 (sqrt u)) | rewrite (sum_1 (sqrt u))];
  apply scaled_within; [apply sqrt_lt_R0; lra |];
  repeat match goal with H0 : _ < u <= _ |- _ => clear H0 | H0 : u <= _ |- _ => clear H0 end;
  plain constants;
  repeat match goal with |- context [atanh_ratio ?y] =>
    let H1 := fresh "H" in
    assert (H1 : 1 <= atanh_ratio y <= 1 + e / 2) by (apply atanh_ratio_near; [interval with (i_prec 60) | lra]);
    revert H1; generalize (atanh_ratio y); intros ? H1
  end;
  apply Rminus_le.
