// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/listed_statements.hpp"

#include <array>

namespace edgeproof::certificate {
namespace {

using namespace listed_scenes;

constexpr std::string_view wedge_by_loads =
    R"(0 < phi /\ 0 < gam /\ 0 < a -> exists P P1 : R -> R,
  (forall s, 0 < s -> is_the_load Es (TiltedWedge.slope phi (tilt phi gam)) s (gam * s) (P s) /\
    is_derive P s (P1 s)) /\
  (forall x, 0 < x < a ->
    is_improper_integral (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + gam * s)))) x a
      (wedge_pressure Es phi gam a x)) /\
  (forall x, - (gam * a) < x < 0 ->
    is_improper_integral (fun s => 1 / PI * (P1 s / sqrt ((s - x) * (x + gam * s)))) (- x / gam) a
      (wedge_pressure Es phi gam a x)) /\
  is_integral_about_0 (wedge_pressure Es phi gam a) (gam * a) a (P a) /\
  forall x, - (gam * a) < x < a -> x <> 0 ->
  is_principal_value_about_0 (fun s => wedge_pressure Es phi gam a s / (s - x)) (gam * a) a x
    (- (PI * Es / 2 * TiltedWedge.slope phi (tilt phi gam) x)))";
constexpr std::string_view states_wedge_by_loads =
    "for all tilted wedges, the printed integrals on both sides solve the equation of the contact "
    "problem at every place except the apex, and have the load as their integral";

/// The pressure on one side of the apex by the printed integral.
constexpr Listed wedge_side(std::string_view says, std::string_view where) {
    return {"value",
            {.of = "p(x)", .says = says, .where = where},
            non_symmetric,
            "(Es phi gam a : R)",
            wedge_by_loads,
            "intros (Hphi & Hgam & Ha). exact (wedge_solves_by_loads Es phi gam a Hphi Hgam Ha)",
            states_wedge_by_loads,
            "tilted punches with rounded edges",
            false};
}

constexpr std::array<Listed, 13> pressures{
    {{"value",
      {.of = "p(x)",
       .says = "Es/(2*Pi)*sqrt(a^2-x^2)*pv(g1(s)/sqrt(a^2-s^2)*(1/(s-x)), s, -a, a, x)"},
      symmetric,
      "(Es m a x : R) (l : list part)",
      R"(convex_punch l -> beyond m l -> 0 < m < x -> x < a ->
  exists p0 l0, is_the_pressure Es (Symmetric.slope l) a x p0 /\
  is_principal_value (fun s => Symmetric.slope l s / sqrt (a ^ 2 - s ^ 2) * (1 / (s - x))) (- a) a x l0 /\
  Es / (2 * PI) * sqrt (a ^ 2 - x ^ 2) * l0 = p0)",
      "exact (the_pressure_by_inversion Es l m a x)",
      "for all symmetric punches whose g' is piecewise linear and convex (wedges, parabolas, flat "
      "punches with rounded edges and sums of these), beyond all knots, printed = Barber and "
      "Mossakovskii's integral",
      "power laws with other exponents than 0 and 1; places on the flat",
      false},
     {"value",
      {.of = "p(x)",
       .says = "1/Pi*integral(P1of(s)/sqrt(s^2-x^2), s, x, a)",
       .where = "x > 0 and x < a"},
      symmetric,
      "(Es C phi gam t R0 m a x : R) (l : list part)",
      R"((0 < C /\ 0 < a -> exists P0,
    are_the_pressures Es (Symmetric.slope (parabola C)) a a (fun s => Es * C / 2 * sqrt (a ^ 2 - s ^ 2)) /\
    is_the_load Es (Symmetric.slope (parabola C)) a a P0 /\
    is_integral_about_0 (fun s => Es * C / 2 * sqrt (a ^ 2 - s ^ 2)) a a P0 /\
    forall x, - a < x < a -> is_principal_value (fun s => Es * C / 2 * sqrt (a ^ 2 - s ^ 2) / (s - x)) (- a) a x
      (- (PI * Es / 2 * Symmetric.slope (parabola C) x))) /\
  (0 < phi /\ 0 < gam /\ 0 < a -> exists P0,
    are_the_pressures Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) (wedge_pressure Es phi gam a) /\
    is_the_load Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) P0 /\
    is_integral_about_0 (wedge_pressure Es phi gam a) (gam * a) a P0 /\
    forall x, - (gam * a) < x < a -> x <> 0 ->
    is_principal_value_about_0 (fun s => wedge_pressure Es phi gam a s / (s - x)) (gam * a) a x
      (- (PI * Es / 2 * TiltedWedge.slope phi (tilt phi gam) x))) /\
  (0 < t < a /\ 0 < R0 -> exists P0,
    are_the_pressures Es (Symmetric.slope (rounded t R0)) a a (rounded_pressure Es t R0 a) /\
    is_the_load Es (Symmetric.slope (rounded t R0)) a a P0 /\
    is_integral_about_0 (rounded_pressure Es t R0 a) a a P0 /\
    forall x, - a < x < a -> is_principal_value (fun s => rounded_pressure Es t R0 a s / (s - x)) (- a) a x
      (- (PI * Es / 2 * Symmetric.slope (rounded t R0) x))) /\
  (convex_punch l -> beyond m l -> 0 < m < x -> x < a -> exists P P1 p0 l0,
    (forall s, x <= s <= a -> is_the_load Es (Symmetric.slope l) s s (P s) /\ is_derive P s (P1 s)) /\
    is_principal_value (fun s => Symmetric.slope l s / sqrt (a ^ 2 - s ^ 2) * (1 / (s - x))) (- a) a x l0 /\
    Es / (2 * PI) * sqrt (a ^ 2 - x ^ 2) * l0 = p0 /\
    is_improper_integral (fun s => 1 / PI * (P1 s / sqrt (s ^ 2 - x ^ 2))) x a p0))",
      "split; [intros [HC Ha]; exact (hertz_solves Es C a HC Ha) | split; [intros (Hphi & Hgam & "
      "Ha); exact (wedge_solves Es phi gam a Hphi Hgam Ha) | split; [intros [Ht HR]; exact "
      "(rounded_solves Es t R0 a Ht HR) | exact (inversion_by_loads Es m a x l)]]]",
      "for all parabolas, wedges (also tilted) and flat punches with rounded edges, the pressure "
      "in closed form solves the equation of the contact problem, at every place except the apex "
      "of "
      "a wedge, and has the load as its integral; for all symmetric punches whose g' is piecewise "
      "linear and convex, beyond "
      "all knots, the inversion of that equation is the printed integral",
      "power laws with other exponents than 0 and 1; the printed integral for places on the flat",
      false},
     wedge_side("1/Pi*integral(P1of(s)/sqrt((s-x)*(x+bof(s))), s, x, a)", "x > 0 and x < a"),
     wedge_side("1/Pi*integral(P1of(s)/sqrt((s-x)*(x+bof(s))), s, binv(-x), a)",
                "x < 0 and x > -b"),
     {"value",
      {.of = "-Q/P*Pi*Es/2*g1(x)",
       .says = "pv(Q/P*p(s)/(s-x), s, -b, a, x)",
       .where = "u > 1e-7*L"},
      wedge_under_force,
      "(Es phi gam a Q : R)",
      R"(0 < phi /\ 0 < gam /\ 0 < a -> exists P0,
  are_the_pressures Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) (wedge_pressure Es phi gam a) /\
  is_the_load Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) P0 /\
  is_integral_about_0 (wedge_pressure Es phi gam a) (gam * a) a P0 /\
  forall x, - (gam * a) < x < a -> x <> 0 ->
  is_principal_value_about_0 (fun s => Q / P0 * wedge_pressure Es phi gam a s / (s - x)) (gam * a) a x
    (- Q / P0 * PI * Es / 2 * TiltedWedge.slope phi (tilt phi gam) x))",
      "intros (Hphi & Hgam & Ha). exact (wedge_strain Es phi gam a Hphi Hgam Ha Q)",
      "for all tilted wedges, at every place except the apex, the principal value of Q/P p(s)/(s - "
      "x) is -Q/P pi Es/2 g'(x), which does not depend on the contact's size"},
     {"value",
      {.of = "0", .says = "integral(g1(s)/sqrt((a-s)*(s+b)), s, -b, a)"},
      non_symmetric,
      "(phi gam alpha t R0 a : R)",
      R"(0 < a ->
  (0 < phi /\ 0 < gam -> is_the_left_edge (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) /\
    is_RInt_gen (fun s => TiltedWedge.slope phi (tilt phi gam) s / sqrt ((a - s) * (s + gam * a)))
      (at_right (- (gam * a))) (at_left a) 0) /\
  (0 < alpha /\ 0 < t /\ 0 < R0 -> exists b, is_the_left_edge (tilted_rounded_slope alpha t R0) a b /\
    is_RInt_gen (fun s => tilted_rounded_slope alpha t R0 s / sqrt ((a - s) * (s + b)))
      (at_right (- b)) (at_left a) 0))",
      "exact (printed_consistency phi gam alpha t R0 a)",
      "for all tilted wedges and all tilted punches with rounded edges, there is one left edge, "
      "and with it the printed integral is 0"},
     {"value",
      {.of = "g1(x)",
       .says = "2*(1-nu^2)/(Pi*Ey)*p(x)/sqrt(a^2-x^2)*pv(sqrt(a^2-s^2)/(x-s), s, -a, a, x)"},
      parabola_in_plane_strain,
      "(Ey nu C a x : R)",
      R"(0 < Ey /\ -1 < nu < 1 /\ 0 < C -> 0 < x < a -> exists p0 l0,
  is_the_pressure (Ey / (1 - nu ^ 2)) (Symmetric.slope (parabola C)) a x p0 /\
  is_principal_value (fun s => sqrt (a ^ 2 - s ^ 2) / (x - s)) (- a) a x l0 /\
  2 * (1 - nu ^ 2) / (PI * Ey) * p0 / sqrt (a ^ 2 - x ^ 2) * l0 = Symmetric.slope (parabola C) x /\
  2 * 2 * (1 - nu ^ 2) / (PI * Ey) * p0 / sqrt (a ^ 2 - x ^ 2) * l0 <> Symmetric.slope (parabola C) x)",
      "exact (one_body_or_two Ey nu C a x)",
      "for all parabolas and x > 0, the slope is that of one body, and not those of two",
      "",
      true,
      Verdict::imprecise,
      {{{.of = "g1(x)",
         .says = "2*2*(1-nu^2)/(Pi*Ey)*p(x)/sqrt(a^2-x^2)*pv(sqrt(a^2-s^2)/(x-s), s, -a, a, x)"}}}},
     {"limit",
      {.of = "(p(t+s)-p(t-s))/p(t)", .says = "0", .along = "s", .from = "0", .to = "a-t"},
      beyond_the_flat,
      "(Es t R0 a : R)",
      R"(0 < Es /\ 0 < t < a /\ 0 < R0 -> exists p,
  are_the_pressures Es (Symmetric.slope (rounded t R0)) a a p /\
  (forall x, - a < x < a -> continuous p x) /\
  filterlim (fun s => (p (t + s) - p (t - s)) / p t) (at_right 0) (locally 0))",
      "exact (continuous_everywhere Es t R0 a)",
      "for all flat punches with rounded edges, the pressure is continuous everywhere, and the "
      "difference at the transition tends to 0"},
     {"monotone",
      {.of = "p(s)", .says = "increasing", .along = "s", .from = "0", .to = "t"},
      beyond_the_flat,
      "(Es t R0 a : R)",
      R"(0 < Es /\ 0 < t < a /\ 0 < R0 -> exists p,
  are_the_pressures Es (Symmetric.slope (rounded t R0)) a a p /\
  (forall x, - a < x < a -> continuous p x) /\
  forall x z, 0 <= x < z -> z <= t -> p x < p z)",
      "exact (grows_to_the_transition Es t R0 a)",
      "for all flat punches with rounded edges, the pressure grows from x = 0 to x = t"},
     {"monotone",
      {.of = "p(s)",
       .says = "decreasing",
       .along = "s",
       .from = "(t+a)/2",
       .to = "t+(a-t)*(1-1e-4)"},
      beyond_the_flat,
      "(Es t R0 a : R)",
      R"(0 < Es /\ 0 < t < a /\ 0 < R0 -> exists p,
  are_the_pressures Es (Symmetric.slope (rounded t R0)) a a p /\
  forall x z, (t + a) / 2 <= x < z -> z < a -> p z < p x)",
      "exact (falls_to_the_edge Es t R0 a)",
      "for all flat punches with rounded edges, the pressure falls from x = (t + a)/2 to the edge"},
     {"value",
      {.of = "P", .says = "integral(p(x), x, -a, a)"},
      power_law_or_rounded,
      "(Es C m t R0 a : R)",
      R"(0 < C /\ 0 <= m /\ 0 < t < a /\ 0 < R0 ->
  (exists p P0, are_the_pressures Es (power_slope C m) a a p /\
    is_the_load Es (power_slope C m) a a P0 /\ is_integral_about_0 p a a P0) /\
  (exists p P0, are_the_pressures Es (Symmetric.slope (rounded t R0)) a a p /\
    is_the_load Es (Symmetric.slope (rounded t R0)) a a P0 /\ is_integral_about_0 p a a P0))",
      "exact (integrals_of_pressure Es C m t R0 a)",
      "for all power laws and all flat punches with rounded edges, the integral of the pressure, "
      "also over the flat, is the load"},
     {"value",
      {.of = "P", .says = "Es/2*integral(s*g1(s)/sqrt(a^2-s^2), s, -a, a)"},
      power_law_or_rounded,
      "(Es C m t R0 a : R)",
      R"(0 < C /\ 0 <= m /\ 0 < t < a /\ 0 < R0 ->
  (exists p P0 l, are_the_pressures Es (power_slope C m) a a p /\ is_integral_about_0 p a a P0 /\
    is_RInt_gen (fun s => s * power_slope C m s / sqrt (a ^ 2 - s ^ 2)) (at_right (- a)) (at_left a) l /\
    Es / 2 * l = P0) /\
  (exists p P0 l, are_the_pressures Es (Symmetric.slope (rounded t R0)) a a p /\ is_integral_about_0 p a a P0 /\
    is_RInt_gen (fun s => s * Symmetric.slope (rounded t R0) s / sqrt (a ^ 2 - s ^ 2)) (at_right (- a)) (at_left a) l /\
    Es / 2 * l = P0))",
      "exact (loads_over_places Es C m t R0 a)",
      "for all power laws and all flat punches with rounded edges, the printed integral over the "
      "places is the integral of the pressure"},
     {"value",
      {.of = "integral(p(s), s, -b, a)",
       .says = "Es/2*integral(s*g1(s)/sqrt((a-s)*(s+b)), s, -b, a)"},
      non_symmetric,
      "(Es phi gam a : R)",
      R"(0 < phi /\ 0 < gam /\ 0 < a -> exists p P0 l,
  are_the_pressures Es (TiltedWedge.slope phi (tilt phi gam)) a (gam * a) p /\
  is_integral_about_0 p (gam * a) a P0 /\
  is_RInt_gen (fun s => s * TiltedWedge.slope phi (tilt phi gam) s / sqrt ((a - s) * (s + gam * a)))
    (at_right (- (gam * a))) (at_left a) l /\ Es / 2 * l = P0)",
      "exact (wedge_load_over_places Es phi gam a)",
      "for all tilted wedges, the printed integral over the places is the integral of the pressure",
      "tilted punches with rounded edges",
      false}}};

} // namespace

std::span<const Listed> listed_pressures() { return pressures; }

} // namespace edgeproof::certificate
