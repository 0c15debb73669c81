// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/listed_statements.hpp"

#include <array>

namespace edgeproof::certificate {
namespace {

using namespace listed_scenes;

constexpr std::string_view convex_smooth =
    "that the load and the left edge are smooth functions of the right edge, which is assumed; the "
    "punch is taken to be convex";
constexpr std::string_view contact_parameters =
    "(Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R)";
constexpr std::string_view right_orders =
    R"(is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  exists r0 r1 r2, is_the_right_series Es g1 a r0 r1 r2 /\ has_orders Es g1 a r0 r1 r2)";
constexpr std::string_view left_orders =
    R"(is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->
  is_left_edge a b b1 b2 b3 alpha ->
  rises_at g1 y /\ y < a /\ rises_at (mirrored g1) z /\ z < b a ->
  exists l0 l1 l2, is_the_left_series Es g1 (b a) l0 l1 l2 /\
    has_orders Es (mirrored g1) (b a) l0 l1 l2)";
constexpr std::string_view states_orders =
    "for all smooth contacts, the pressure and what one and two terms leave of it, divided by "
    "u^(1/2), u^(3/2) and u^(5/2), tend to the coefficients";

/// The orders of what the first terms leave of the pressure of any smooth contact.
constexpr Listed smooth_orders(bool right, std::string_view orders) {
    return {"series",
            {.of = right ? "right" : "left", .says = orders},
            any_contact,
            contact_parameters,
            right ? right_orders : left_orders,
            right ? "intros contact left convex. eapply orders_at_right; eassumption"
                  : "intros contact left convex. eapply orders_at_left; eassumption",
            states_orders,
            convex_smooth,
            false};
}

/// A load that is 0, written as an integral or as a function.
constexpr Listed no_load(std::string_view of) {
    return {"value",
            {.of = of, .says = "0"},
            within_the_flat,
            "(Es t R0 a : R)",
            R"(0 < t /\ 0 < R0 /\ 0 < a <= t ->
  is_load Es (Symmetric.slope (rounded t R0)) a a 0 /\
  forall P, is_load Es (Symmetric.slope (rounded t R0)) a a P -> P = 0)",
            "intros form. apply no_load_within_flat; lra",
            "for all punches, between edges on the flat the load is 0, and no other"};
}

constexpr std::array<Listed, 27> listed{
    {{"relation",
      {.says = "0 < b/a and b/a < 1"},
      tilted_to_the_left,
      "(phi a alpha : R)",
      R"(0 < phi /\ 0 < a /\ 0 < alpha < phi ->
  exists b, is_the_left_edge (slope phi alpha) a b /\ 0 < b / a /\ b / a < 1)",
      "intros form. apply ratio_in_range; lra",
      "for all wedges tilted by less than their angle, 0 < b/a < 1"},
     {"limit",
      {.of = "b/a", .says = "1", .along = "alpha", .unit = "phi"},
      tilted_to_the_left,
      "(phi a : R)",
      R"(0 < phi /\ 0 < a -> exists b : R -> R,
  (forall alpha, 0 < alpha < phi -> is_the_left_edge (slope phi alpha) a (b alpha)) /\
  filterlim (fun alpha => b alpha / a) (at_right 0) (locally 1))",
      "intros form. apply ratio_of_a_small_tilt; lra",
      "for all wedges, b/a tends to 1 as the tilt tends to 0"},
     {"limit",
      {.of = "b/a", .says = "0", .along = "alpha", .unit = "phi", .end = 1},
      tilted_to_the_left,
      "(phi a : R)",
      R"(0 < phi /\ 0 < a -> exists b : R -> R,
  (forall alpha, 0 < alpha < phi -> is_the_left_edge (slope phi alpha) a (b alpha)) /\
  filterlim (fun alpha => b alpha / a) (at_left phi) (locally 0))",
      "intros form. apply ratio_of_the_largest_tilt; lra",
      "for all wedges, b/a tends to 0 as the tilt tends to the angle"},
     no_load("Es/2*integral(s*g1(s)/sqrt(a^2-s^2), s, -a, a)"),
     no_load("Pof(a)"),
     {"monotone",
      {.of = "P", .says = "decreasing", .along = "a", .unit = "t", .end = 1},
      beyond_the_flat,
      "(Es t R0 a c : R)",
      R"(0 < Es /\ 0 < t /\ 0 < R0 /\ t < a < c -> exists P Q,
  is_the_load Es (Symmetric.slope (rounded t R0)) a a P /\
  is_the_load Es (Symmetric.slope (rounded t R0)) c c Q /\ P < Q)",
      "intros form. apply load_grows; lra",
      "for all punches, of two contacts the one with the edge nearer to the flat has the smaller "
      "load"},
     {"limit",
      {.of = "P/(Es*t)", .says = "0", .along = "a", .unit = "t", .end = 1},
      beyond_the_flat,
      "(Es t R0 : R)",
      R"(0 < Es /\ 0 < t /\ 0 < R0 -> exists P : R -> R,
  (forall a, t < a -> is_the_load Es (Symmetric.slope (rounded t R0)) a a (P a)) /\
  filterlim (fun a => P a / (Es * t)) (at_right t) (locally 0))",
      "intros form. apply load_vanishes; lra",
      "for all punches, the load tends to 0 as the edge tends to the end of the flat"},
     {"value",
      {.of = "0", .says = "gp(0)"},
      tilted_punch,
      "(alpha t R0 : R)",
      R"(0 < alpha /\ 0 < t /\ 0 < R0 -> tilted_rounded_slope alpha t R0 0 = 0)",
      "intros form. apply lowest_at_origin; lra",
      "for all such punches, the slope is 0 at x = 0"},
     {"value",
      {.of = "sgn(x)*gp(x)", .says = "abs(gp(x))"},
      tilted_punch,
      "(alpha t R0 : R)",
      R"(0 < alpha /\ 0 < t /\ 0 < R0 -> forall x,
  Rabs (tilted_rounded_slope alpha t R0 x) = sign x * tilted_rounded_slope alpha t R0 x)",
      "intros form. apply falls_and_rises; lra",
      "for all such punches and all x, |g'(x)| = sgn(x) g'(x)"},
     {"value",
      {.of = "g1(x)", .says = "x/R", .where = "x > 0"},
      tilted_punch,
      "(alpha t R0 : R)",
      R"(0 < alpha /\ 0 < t /\ 0 < R0 -> forall x, 0 < x ->
  x / R0 = tilted_rounded_slope alpha t R0 x)",
      "intros form. apply parabola_to_the_right; lra",
      "for all such punches and all x > 0, g'(x) = x/R"},
     {"value",
      {.of = "q(x)", .says = "Q/(Pi*sqrt((a-x)*(x+b))) + sig0*(2*x+b-a)/(8*sqrt((a-x)*(x+b)))"},
      any_contact,
      "(Q sig0 a b : R)",
      R"(0 < a + b ->
  is_traction (fun x => Q / (PI * sqrt ((a - x) * (x + b))) +
    sig0 * (2 * x + b - a) / (8 * sqrt ((a - x) * (x + b)))) a b Q sig0 /\
  forall A B, is_traction (fun s => (A + B * s) / sqrt ((a - s) * (s + b))) a b Q sig0 ->
  forall x, - b < x < a -> (A + B * x) / sqrt ((a - x) * (x + b)) =
    Q / (PI * sqrt ((a - x) * (x + b))) +
    sig0 * (2 * x + b - a) / (8 * sqrt ((a - x) * (x + b))))",
      R"(intros HD. split; [exact (full_stick_is_traction Q sig0 a b HD) |].
  intros A B. exact (full_stick_of_form Q sig0 a b A B HD))",
      "for all contacts, the printed traction solves the integral equation of full stick and has "
      "the force Q; of all functions (A + B x)/sqrt((a - x)(x + b)) it is the only one",
      "that the integral equation has no solution of another form",
      false},
     {"order",
      {.of = "abs(1 - right_local(1, x)/p(x))",
       .says = "right.c1*u",
       .along = "of-the-scene",
       .where = "abs(right.c1)*a > right.c0*1e-9"},
      power_law_or_rounded,
      "(Es C m t R0 a K : R)",
      R"(0 < Es /\ 0 < C /\ 0 <= m /\ 0 < t < a /\ 0 < R0 ->
  (exists r0 r1 r2, is_the_right_series Es (power_slope C m) a r0 r1 r2 /\ r0 <> 0 /\
    has_error_of_order Es (power_slope C m) a r0 (Rabs (r1 / r0))) /\
  (exists r0 r1 r2, is_the_right_series Es (Symmetric.slope (rounded t R0)) a r0 r1 r2 /\ r0 <> 0 /\
    has_error_of_order Es (Symmetric.slope (rounded t R0)) a r0 (Rabs (r1 / r0))) /\
  (exists Fs phi c r0 r1 r2 factor,
    is_the_right_series Fs (TiltedWedge.slope phi (tilt phi 1)) c r0 r1 r2 /\ r0 <> 0 /\ r1 <> 0 /\
    has_error_of_order Fs (TiltedWedge.slope phi (tilt phi 1)) c r0 (factor * Rabs r1) /\ factor <> K))",
      "exact (order_in_the_distance Es C m t R0 a K)",
      "for all power laws and all flat punches with rounded edges, the error of one term, divided "
      "by the distance from the edge, tends to |c1/c0|; for no number K is this K |c1| at all "
      "contacts",
      "",
      true,
      Verdict::imprecise,
      {{{.of = "abs(1 - right_local(1, x)/p(x))",
         .says = "right.c1*u",
         .along = "pure-number",
         .where = "abs(right.c1)*a > right.c0*1e-9"}}}},
     {"relation",
      {.says = "right.s0*left.s0 > 0", .where = "sig0*(b+a)/Q < 8/Pi"},
      under_a_force,
      "",
      R"((forall a b Q sig0, 0 < a + b /\ Q <> 0 -> exists s0 s1 s2 v0 v1 v2,
    is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
    is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
    (Rabs (sig0 * (b + a) / Q) < 8 / PI -> 0 < s0 * v0) /\
    (sig0 * (b + a) / Q < 8 / PI /\ 0 < sig0 * Q -> 0 < s0 * v0)) /\
  (exists a b Q sig0 s0 s1 s2 v0 v1 v2, 0 < a + b /\ Q <> 0 /\
    is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
    is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\
    sig0 * (b + a) / Q < 8 / PI /\ s0 * v0 < 0))",
      "exact same_sign",
      "for all contacts, the coefficients have one sign if the relation holds in absolute value, "
      "and if it holds for Q and sig0 of one sign; there is a contact for which it holds as "
      "printed, and they have different signs",
      "",
      true,
      Verdict::imprecise,
      {{{.says = "right.s0*left.s0 > 0", .where = "abs(sig0*(b+a)/Q) < 8/Pi"},
        {.says = "right.s0*left.s0 > 0", .where = "sig0*(b+a)/Q < 8/Pi and sig0*Q > 0"}}}},
     {"vanishing",
      {.of = "left.s1", .says = "4/(3*Pi)"},
      under_a_force,
      "(a b Q sig0 : R)",
      R"(0 < a + b /\ Q <> 0 /\ sig0 * ((a + b) / 2) / Q = 4 / (3 * PI) -> exists s0 s1 s2 v0 v1 v2,
  is_the_right_shear_series (full_stick Q sig0 a b) a s0 s1 s2 /\
  is_the_left_shear_series (full_stick Q sig0 a b) b v0 v1 v2 /\ s1 = 0 /\ v1 <> 0)",
      "exact (vanishes_at_the_right a b Q sig0)",
      "for all contacts, at the printed ratio the coefficient vanishes at the right edge, and not "
      "at the left one",
      "",
      true,
      Verdict::imprecise,
      {{{.of = "right.s1", .says = "4/(3*Pi)"}}}},
     {"relation",
      {.says = ">"},
      force_alone,
      "(a b Q : R)",
      R"(0 < a + b /\ Q <> 0 -> exists s v : nat -> R,
  are_the_right_terms (full_stick Q 0 a b) a s 9 /\ are_the_left_terms (full_stick Q 0 a b) b v 9 /\
  forall k, (1 <= k <= 9)%nat -> 0 < s k * s 0%nat /\ 0 < v k * v 0%nat)",
      "intros form. apply force_signs; apply form",
      "for all contacts under a shear force, the terms 1 to 9 of both edges have the sign of the "
      "first"},
     {"relation",
      {.says = "<"},
      tension_alone,
      "(a b sig0 : R)",
      R"(0 < a + b /\ sig0 <> 0 -> exists s v : nat -> R,
  are_the_right_terms (full_stick 0 sig0 a b) a s 9 /\ are_the_left_terms (full_stick 0 sig0 a b) b v 9 /\
  forall k, (1 <= k <= 9)%nat -> s k * s 0%nat < 0 /\ v k * v 0%nat < 0)",
      "intros form. apply tension_signs; apply form",
      "for all contacts under a tension, the terms 1 to 9 of both edges have the opposite sign of "
      "the first"},
     {"limit",
      {.of = "p(x)/(P/(Pi*sqrt(a^2-x^2)))", .says = "1", .along = "m", .unit = growing},
      power_law,
      "(Es C a x : R)",
      R"(0 < Es /\ 0 < C /\ 0 < x < a -> exists p P : R -> R,
  (forall m, 0 <= m -> is_the_pressure Es (power_slope C m) a x (p m) /\
    is_the_load Es (power_slope C m) a a (P m)) /\
  filterlim (fun m => p m / (P m / (PI * sqrt (a ^ 2 - x ^ 2)))) (Rbar_locally p_infty) (locally 1))",
      "exact (becomes_rectangular Es C a x)",
      "at every place x > 0 of all contacts, the pressure divided by that of a rectangular punch "
      "tends to 1 as m grows without bound"},
     {"limit",
      {.of = "right_local(1, x)/p(x)", .says = "infinity", .along = "m", .unit = growing},
      power_law,
      "(Es C a x : R)",
      R"(0 < Es /\ 0 < C /\ 0 < x < a -> exists p P r : R -> R,
  (forall m, 0 <= m -> is_the_pressure Es (power_slope C m) a x (p m) /\
    is_the_load Es (power_slope C m) a a (P m) /\
    exists r1 r2, is_the_right_series Es (power_slope C m) a (r m) r1 r2) /\
  filterlim (fun m => r m * sqrt (a - x) / p m) (Rbar_locally p_infty) (Rbar_locally p_infty) /\
  filterlim (fun m => r m * sqrt (a - x) * a / P m) (Rbar_locally p_infty) (Rbar_locally p_infty))",
      "exact (one_term_diverges Es C a x)",
      "at every place x > 0 of all contacts, one term divided by the pressure, and divided by P/a, "
      "grows without bound with m",
      "",
      true,
      Verdict::confirmed,
      {{{.of = "right_local(1, x)*a/P", .says = "infinity", .along = "m", .unit = growing}}}},
     {"independence",
      {.of = "q(x)*L/Q"},
      force_alone,
      "(a b c e Q N xi : R)",
      R"(0 < a + b -> 0 < c + e -> Q <> 0 -> N <> 0 -> 0 < xi < 1 ->
  is_traction (full_stick Q 0 a b) a b Q 0 /\ is_traction (full_stick N 0 c e) c e N 0 /\
  full_stick Q 0 a b (a - xi * (a + b)) * (a + b) / Q =
  full_stick N 0 c e (c - xi * (c + e)) * (c + e) / N)",
      "exact (force_independent a b c e Q N xi)",
      "for any two contacts and forces, both tractions solve the integral equation of full stick, "
      "and q L/Q is the same at the same share of the contact",
      "that the integral equation has no other solution",
      false},
     {"independence",
      {.of = "q(x)/sig0"},
      tension_alone,
      "(a b c e sig0 tau xi : R)",
      R"(0 < a + b -> 0 < c + e -> sig0 <> 0 -> tau <> 0 -> 0 < xi < 1 ->
  is_traction (full_stick 0 sig0 a b) a b 0 sig0 /\
  is_traction (full_stick 0 tau c e) c e 0 tau /\
  full_stick 0 sig0 a b (a - xi * (a + b)) / sig0 =
  full_stick 0 tau c e (c - xi * (c + e)) / tau)",
      "exact (tension_independent a b c e sig0 tau xi)",
      "for any two contacts and tensions, both tractions solve the integral equation of full "
      "stick, and q/sig0 is the same at the same share of the contact",
      "that the integral equation has no other solution",
      false},
     {"series",
      {.of = "right", .says = "1/2 3/2 5/2 7/2"},
      tilted_wedge,
      "(Es phi gam a : R)",
      R"(0 < Es /\ 0 < phi /\ 0 < gam /\ 0 < a -> exists r0 r1 r2,
  is_the_right_series Es (slope phi (tilt phi gam)) a r0 r1 r2 /\
  has_orders Es (slope phi (tilt phi gam)) a r0 r1 r2 /\
  has_remainder Es (slope phi (tilt phi gam)) a r0 r1 r2)",
      "exact (remainder_at_right Es phi gam a)",
      "for all tilted wedges, what three terms leave is at most C u^(7/2); the pressure and what "
      "one and two terms leave of it, divided by u^(1/2), u^(3/2) and u^(5/2), tend to the "
      "coefficients"},
     {"series",
      {.of = "left", .says = "1/2 3/2 5/2 7/2"},
      tilted_wedge,
      "(Es phi gam a : R)",
      R"(0 < Es /\ 0 < phi /\ 0 < gam /\ 0 < a -> exists l0 l1 l2,
  is_the_left_series Es (slope phi (tilt phi gam)) (gam * a) l0 l1 l2 /\
  has_orders Es (mirrored (slope phi (tilt phi gam))) (gam * a) l0 l1 l2 /\
  has_remainder Es (mirrored (slope phi (tilt phi gam))) (gam * a) l0 l1 l2)",
      "exact (remainder_at_left Es phi gam a)",
      "for all tilted wedges, what three terms leave is at most C u^(7/2); the pressure and what "
      "one and two terms leave of it, divided by u^(1/2), u^(3/2) and u^(5/2), tend to the "
      "coefficients"},
     smooth_orders(true, "1/2 3/2 5/2"),
     smooth_orders(false, "1/2 3/2 5/2"),
     smooth_orders(true, "1/2 3/2"),
     {"value",
      {.of = "integral(Q/P*P1of(s)/(Pi*sqrt((s-x)*(x+bof(s)))), s, x, a)",
       .says = "Q/P*p(x)",
       .where = "x > 0"},
      wedge_or_power_law_under_force,
      "(Es phi gam C m a Q x : R)",
      R"(0 < Es /\ 0 < phi /\ 0 < gam /\ 0 < C /\ 0 <= m /\ 0 < a -> 0 < x < a ->
  is_similar_on_the_right Es (TiltedWedge.slope phi (tilt phi gam)) a Q x /\
  is_similar_on_the_right Es (power_slope C m) a Q x)",
      "intros form. exact (similar_tractions_right Es phi gam C m a Q form x)",
      "for all tilted wedges and power laws, at every place x > 0, the increments of the traction "
      "sum to Q/P p(x); each is the traction of full stick of the increment Q/P dP of the force "
      "over the contact as it is then"},
     {"value",
      {.of = "integral(Q/P*P1of(s)/(Pi*sqrt((s-x)*(x+bof(s)))), s, binv(-x), a)",
       .says = "Q/P*p(x)",
       .where = "x < 0"},
      wedge_or_power_law_under_force,
      "(Es phi gam C m a Q y : R)",
      R"(0 < Es /\ 0 < phi /\ 0 < gam /\ 0 < C /\ 0 <= m /\ 0 < a ->
  (0 < y < gam * a -> is_similar_on_the_left Es (TiltedWedge.slope phi (tilt phi gam)) a Q y) /\
  (0 < y < a -> is_similar_on_the_left Es (power_slope C m) a Q y))",
      "intros form. exact (similar_tractions_left Es phi gam C m a Q form y)",
      "for all tilted wedges and power laws, at every place x < 0, the increments of the traction "
      "sum to Q/P p(x); each is the traction of full stick of the increment Q/P dP of the force "
      "over the contact as it is then"}}};

} // namespace

std::span<const Listed> listed_statements() { return listed; }

} // namespace edgeproof::certificate
