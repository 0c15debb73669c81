// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/statement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::certificate {
namespace {

using Scenes = std::vector<audit::SceneSpec>;

double number(const audit::SceneSpec& scene, const std::string& parameter) {
    return scene.parameter(parameter).to<double>();
}

bool tilted_wedge(const audit::SceneSpec& s) {
    return s.profile == "tilted-wedge" && std::abs(number(s, "alpha")) < number(s, "phi");
}
bool tilted_to_the_left(const audit::SceneSpec& s) {
    return tilted_wedge(s) && s.parameter("alpha").sign() > 0;
}
bool flat_and_rounded(const audit::SceneSpec& s) {
    return s.profile == "flat-and-rounded" && s.parameters.contains("a");
}
bool beyond_the_flat(const audit::SceneSpec& s) {
    return flat_and_rounded(s) &&
           formula::Exact(s.parameter("a").expr() - s.parameter("t").expr()).sign() > 0;
}
bool within_the_flat(const audit::SceneSpec& s) {
    return flat_and_rounded(s) && !beyond_the_flat(s);
}
bool without(const audit::SceneSpec& s, const std::string& load) {
    const auto found = s.parameters.find(load);
    return found != s.parameters.end() && found->second.sign() == 0;
}
bool under(const audit::SceneSpec& s, const std::string& load) {
    return s.parameters.contains(load) && !without(s, load);
}
bool force_alone(const audit::SceneSpec& s) { return without(s, "sig0") && under(s, "Q"); }
bool tension_alone(const audit::SceneSpec& s) { return without(s, "Q") && under(s, "sig0"); }
bool tilted_punch(const audit::SceneSpec& s) {
    return s.profile == "tilted-flat-and-rounded" && s.parameter("alpha").sign() > 0 &&
           s.parameter("t").sign() > 0 && s.parameter("R").sign() > 0;
}
bool power_law(const audit::SceneSpec& s) {
    return s.profile == "power-law" && s.parameter("m").sign() >= 0 && s.parameter("C").sign() > 0;
}
bool symmetric(const audit::SceneSpec& s) {
    return s.profile == "power-law" || s.profile == "flat-and-rounded" ||
           s.profile == "piecewise-symmetric";
}
bool any_contact(const audit::SceneSpec& /*s*/) { return true; }

/// In place of a unit: the values grow without bound, and the places are to the right of x = 0.
constexpr std::string_view growing = "growing";

/// What a claim says, in the syntax of ledgers: "gp" is the slope of a tilted punch. Two formulas
/// are equal if they are the same tree, with the definitions of the ledger put in.
struct Said {
    std::string_view of = ""; ///< of a series: the edge
    /// Of a limit: the limit; of a monotone claim: the sense; ">" and "<" as in signs_of_terms().
    std::string_view says = "";
    std::string_view along = ""; ///< a parameter of the family
    std::string_view unit = "";  ///< this parameter, divided by `unit`, ends at `end`
    double end = 0;
    std::string_view where = "";
    std::string_view also = ""; ///< the formula of a second reading
};

/// A claim for which the Coq files have a theorem: its kind, what it says, and the scenes that the
/// theorem is about.
struct Listed {
    std::string_view kind;
    Said said;
    bool (*about)(const audit::SceneSpec&);
    std::string_view parameters; ///< of the theorem: "phi a : R"
    std::string_view statement;
    std::string_view proof;
    std::string_view states;
    std::string_view leaves_out = "";
    bool whole = true;
};

constexpr std::string_view convex_smooth =
    "that the load and the left edge are smooth functions of the right edge, which is assumed; the "
    "punch is taken to be convex";
constexpr std::string_view contact_parameters =
    "(Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R)";
constexpr std::string_view right_orders =
    "is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->\n  is_left_edge a b b1 b2 b3 alpha ->\n"
    "  rises_at g1 y /\\ y < a /\\ rises_at (mirrored g1) z /\\ z < b a ->\n"
    "  exists r0 r1 r2, is_the_right_series Es g1 a r0 r1 r2 /\\ has_orders Es g1 a r0 r1 r2";
constexpr std::string_view left_orders =
    "is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->\n  is_left_edge a b b1 b2 b3 alpha ->\n"
    "  rises_at g1 y /\\ y < a /\\ rises_at (mirrored g1) z /\\ z < b a ->\n"
    "  exists l0 l1 l2, is_the_left_series Es g1 (b a) l0 l1 l2 /\\\n"
    "    has_orders Es (mirrored g1) (b a) l0 l1 l2";
constexpr std::string_view states_orders =
    "for all smooth contacts, the pressure and what one and two terms leave of it, divided by "
    "u^(1/2), u^(3/2) and u^(5/2), tend to the coefficients";

constexpr std::array<Listed, 23> listed{
    {{"relation",
      {.says = "0 < b/a and b/a < 1"},
      tilted_to_the_left,
      "(phi a alpha : R)",
      "0 < phi /\\ 0 < a /\\ 0 < alpha < phi ->\n"
      "  exists b, is_the_left_edge (slope phi alpha) a b /\\ 0 < b / a /\\ b / a < 1",
      "intros form. apply ratio_in_range; lra",
      "for all wedges tilted by less than their angle, 0 < b/a < 1"},
     {"limit",
      {.of = "b/a", .says = "1", .along = "alpha", .unit = "phi"},
      tilted_to_the_left,
      "(phi a : R)",
      "0 < phi /\\ 0 < a -> exists b : R -> R,\n"
      "  (forall alpha, 0 < alpha < phi -> is_the_left_edge (slope phi alpha) a (b alpha)) /\\\n"
      "  filterlim (fun alpha => b alpha / a) (at_right 0) (locally 1)",
      "intros form. apply ratio_of_a_small_tilt; lra",
      "for all wedges, b/a tends to 1 as the tilt tends to 0"},
     {"limit",
      {.of = "b/a", .says = "0", .along = "alpha", .unit = "phi", .end = 1},
      tilted_to_the_left,
      "(phi a : R)",
      "0 < phi /\\ 0 < a -> exists b : R -> R,\n"
      "  (forall alpha, 0 < alpha < phi -> is_the_left_edge (slope phi alpha) a (b alpha)) /\\\n"
      "  filterlim (fun alpha => b alpha / a) (at_left phi) (locally 0)",
      "intros form. apply ratio_of_the_largest_tilt; lra",
      "for all wedges, b/a tends to 0 as the tilt tends to the angle"},
     {"value",
      {.of = "Es/2*integral(s*g1(s)/sqrt(a^2-s^2), s, -a, a)", .says = "0"},
      within_the_flat,
      "(Es t R0 a : R)",
      "0 < t /\\ 0 < R0 /\\ 0 < a <= t ->\n"
      "  is_load Es (Symmetric.slope (rounded t R0)) a a 0 /\\\n"
      "  forall P, is_load Es (Symmetric.slope (rounded t R0)) a a P -> P = 0",
      "intros form. apply no_load_within_flat; lra",
      "for all punches, between edges on the flat the load is 0, and no other"},
     {"value",
      {.of = "Pof(a)", .says = "0"},
      within_the_flat,
      "(Es t R0 a : R)",
      "0 < t /\\ 0 < R0 /\\ 0 < a <= t ->\n"
      "  is_load Es (Symmetric.slope (rounded t R0)) a a 0 /\\\n"
      "  forall P, is_load Es (Symmetric.slope (rounded t R0)) a a P -> P = 0",
      "intros form. apply no_load_within_flat; lra",
      "for all punches, between edges on the flat the load is 0, and no other"},
     {"monotone",
      {.of = "P", .says = "decreasing", .along = "a", .unit = "t", .end = 1},
      beyond_the_flat,
      "(Es t R0 a c : R)",
      "0 < Es /\\ 0 < t /\\ 0 < R0 /\\ t < a < c -> exists P Q,\n"
      "  is_the_load Es (Symmetric.slope (rounded t R0)) a a P /\\\n"
      "  is_the_load Es (Symmetric.slope (rounded t R0)) c c Q /\\ P < Q",
      "intros form. apply load_grows; lra",
      "for all punches, of two contacts the one with the edge nearer to the flat has the smaller "
      "load"},
     {"limit",
      {.of = "P/(Es*t)", .says = "0", .along = "a", .unit = "t", .end = 1},
      beyond_the_flat,
      "(Es t R0 : R)",
      "0 < Es /\\ 0 < t /\\ 0 < R0 -> exists P : R -> R,\n"
      "  (forall a, t < a -> is_the_load Es (Symmetric.slope (rounded t R0)) a a (P a)) /\\\n"
      "  filterlim (fun a => P a / (Es * t)) (at_right t) (locally 0)",
      "intros form. apply load_vanishes; lra",
      "for all punches, the load tends to 0 as the edge tends to the end of the flat"},
     {"value",
      {.of = "0", .says = "gp(0)"},
      tilted_punch,
      "(alpha t R0 : R)",
      "0 < alpha /\\ 0 < t /\\ 0 < R0 -> tilted_rounded_slope alpha t R0 0 = 0",
      "intros form. apply lowest_at_origin; lra",
      "for all such punches, the slope is 0 at x = 0"},
     {"value",
      {.of = "sgn(x)*gp(x)", .says = "abs(gp(x))"},
      tilted_punch,
      "(alpha t R0 : R)",
      "0 < alpha /\\ 0 < t /\\ 0 < R0 -> forall x,\n"
      "  Rabs (tilted_rounded_slope alpha t R0 x) = sign x * tilted_rounded_slope alpha t R0 x",
      "intros form. apply falls_and_rises; lra",
      "for all such punches and all x, |g'(x)| = sgn(x) g'(x)"},
     {"value",
      {.of = "g1(x)", .says = "x/R", .where = "x > 0"},
      tilted_punch,
      "(alpha t R0 : R)",
      "0 < alpha /\\ 0 < t /\\ 0 < R0 -> forall x, 0 < x ->\n"
      "  x / R0 = tilted_rounded_slope alpha t R0 x",
      "intros form. apply parabola_to_the_right; lra",
      "for all such punches and all x > 0, g'(x) = x/R"},
     {"value",
      {.of = "q(x)", .says = "Q/(Pi*sqrt((a-x)*(x+b))) + sig0*(2*x+b-a)/(8*sqrt((a-x)*(x+b)))"},
      any_contact,
      "(Q sig0 a b : R)",
      "0 < a + b ->\n"
      "  is_traction (fun x => Q / (PI * sqrt ((a - x) * (x + b))) +\n"
      "    sig0 * (2 * x + b - a) / (8 * sqrt ((a - x) * (x + b)))) a b Q sig0 /\\\n"
      "  forall A B, is_traction (fun s => (A + B * s) / sqrt ((a - s) * (s + b))) a b Q sig0 ->\n"
      "  forall x, - b < x < a -> (A + B * x) / sqrt ((a - x) * (x + b)) =\n"
      "    Q / (PI * sqrt ((a - x) * (x + b))) +\n"
      "    sig0 * (2 * x + b - a) / (8 * sqrt ((a - x) * (x + b)))",
      "intros HD. split; [exact (full_stick_is_traction Q sig0 a b HD) |].\n"
      "  intros A B. exact (full_stick_of_form Q sig0 a b A B HD)",
      "for all contacts, the printed traction solves the integral equation of full stick and has "
      "the "
      "force Q; of all functions (A + B x)/sqrt((a - x)(x + b)) it is the only one",
      "that the integral equation has no solution of another form",
      false},
     {"value",
      {.of = "p(x)",
       .says = "Es/(2*Pi)*sqrt(a^2-x^2)*pv(g1(s)/sqrt(a^2-s^2)*(1/(s-x)), s, -a, a, x)"},
      symmetric,
      "(Es m a x : R) (l : list part)",
      "convex_punch l -> beyond m l -> 0 < m < x -> x < a ->\n"
      "  exists p0 l0, is_the_pressure Es (Symmetric.slope l) a x p0 /\\\n"
      "  is_principal_value (fun s => Symmetric.slope l s / sqrt (a ^ 2 - s ^ 2) * (1 / (s - x))) "
      "(- a) a x l0 /\\\n"
      "  Es / (2 * PI) * sqrt (a ^ 2 - x ^ 2) * l0 = p0",
      "exact (the_pressure_by_inversion Es l m a x)",
      "for all symmetric punches whose g' is piecewise linear and convex (wedges, parabolas, flat "
      "punches with rounded edges and sums of these), beyond all knots, printed = Barber and "
      "Mossakovskii's integral",
      "power laws with other exponents than 0 and 1; places on the flat",
      false},
     {"relation",
      {.says = ">"},
      force_alone,
      "(a b Q : R)",
      "0 < a + b /\\ Q <> 0 -> exists s v : nat -> R,\n"
      "  are_the_right_terms (full_stick Q 0 a b) a s 9 /\\ are_the_left_terms (full_stick Q 0 a "
      "b) b "
      "v 9 /\\\n  forall k, (1 <= k <= 9)%nat -> 0 < s k * s 0%nat /\\ 0 < v k * v 0%nat",
      "intros form. apply force_signs; apply form",
      "for all contacts under a shear force, the terms 1 to 9 of both edges have the sign of the "
      "first"},
     {"relation",
      {.says = "<"},
      tension_alone,
      "(a b sig0 : R)",
      "0 < a + b /\\ sig0 <> 0 -> exists s v : nat -> R,\n"
      "  are_the_right_terms (full_stick 0 sig0 a b) a s 9 /\\ are_the_left_terms (full_stick 0 "
      "sig0 "
      "a b) b v 9 /\\\n  forall k, (1 <= k <= 9)%nat -> s k * s 0%nat < 0 /\\ v k * v 0%nat < 0",
      "intros form. apply tension_signs; apply form",
      "for all contacts under a tension, the terms 1 to 9 of both edges have the opposite sign of "
      "the first"},
     {"limit",
      {.of = "p(x)/(P/(Pi*sqrt(a^2-x^2)))", .says = "1", .along = "m", .unit = growing},
      power_law,
      "(Es C a x : R)",
      "0 < Es /\\ 0 < C /\\ 0 < x < a -> exists p P : R -> R,\n"
      "  (forall m, 0 <= m -> is_the_pressure Es (power_slope C m) a x (p m) /\\\n"
      "    is_the_load Es (power_slope C m) a a (P m)) /\\\n"
      "  filterlim (fun m => p m / (P m / (PI * sqrt (a ^ 2 - x ^ 2)))) (Rbar_locally p_infty) "
      "(locally 1)",
      "exact (becomes_rectangular Es C a x)",
      "at every place x > 0 of all contacts, the pressure divided by that of a rectangular punch "
      "tends to 1 as m grows without bound"},
     {"limit",
      {.of = "right_local(1, x)/p(x)",
       .says = "infinity",
       .along = "m",
       .unit = growing,
       .also = "right_local(1, x)*a/P"},
      power_law,
      "(Es C a x : R)",
      "0 < Es /\\ 0 < C /\\ 0 < x < a -> exists p P r : R -> R,\n"
      "  (forall m, 0 <= m -> is_the_pressure Es (power_slope C m) a x (p m) /\\\n"
      "    is_the_load Es (power_slope C m) a a (P m) /\\\n"
      "    exists r1 r2, is_the_right_series Es (power_slope C m) a (r m) r1 r2) /\\\n"
      "  filterlim (fun m => r m * sqrt (a - x) / p m) (Rbar_locally p_infty) (Rbar_locally "
      "p_infty) /\\\n"
      "  filterlim (fun m => r m * sqrt (a - x) * a / P m) (Rbar_locally p_infty) (Rbar_locally "
      "p_infty)",
      "exact (one_term_diverges Es C a x)",
      "at every place x > 0 of all contacts, one term divided by the pressure, and divided by P/a, "
      "grows without bound with m"},
     {"independence",
      {.of = "q(x)*L/Q"},
      force_alone,
      "(a b c e Q N xi : R)",
      "0 < a + b -> 0 < c + e -> Q <> 0 -> N <> 0 -> 0 < xi < 1 ->\n"
      "  is_traction (full_stick Q 0 a b) a b Q 0 /\\ is_traction (full_stick N 0 c e) c e N 0 "
      "/\\\n"
      "  full_stick Q 0 a b (a - xi * (a + b)) * (a + b) / Q =\n"
      "  full_stick N 0 c e (c - xi * (c + e)) * (c + e) / N",
      "exact (force_independent a b c e Q N xi)",
      "for any two contacts and forces, both tractions solve the integral equation of full stick, "
      "and q L/Q is the same at the same share of the contact",
      "that the integral equation has no other solution",
      false},
     {"independence",
      {.of = "q(x)/sig0"},
      tension_alone,
      "(a b c e sig0 tau xi : R)",
      "0 < a + b -> 0 < c + e -> sig0 <> 0 -> tau <> 0 -> 0 < xi < 1 ->\n"
      "  is_traction (full_stick 0 sig0 a b) a b 0 sig0 /\\\n"
      "  is_traction (full_stick 0 tau c e) c e 0 tau /\\\n"
      "  full_stick 0 sig0 a b (a - xi * (a + b)) / sig0 =\n"
      "  full_stick 0 tau c e (c - xi * (c + e)) / tau",
      "exact (tension_independent a b c e sig0 tau xi)",
      "for any two contacts and tensions, both tractions solve the integral equation of full "
      "stick, "
      "and q/sig0 is the same at the same share of the contact",
      "that the integral equation has no other solution",
      false},
     {"series",
      {.of = "right", .says = "1/2 3/2 5/2 7/2"},
      tilted_wedge,
      "(Es phi gam a : R)",
      "0 < Es /\\ 0 < phi /\\ 0 < gam /\\ 0 < a -> exists r0 r1 r2,\n"
      "  is_the_right_series Es (slope phi (tilt phi gam)) a r0 r1 r2 /\\\n"
      "  has_orders Es (slope phi (tilt phi gam)) a r0 r1 r2 /\\\n"
      "  has_remainder Es (slope phi (tilt phi gam)) a r0 r1 r2",
      "exact (remainder_at_right Es phi gam a)",
      "for all tilted wedges, what three terms leave is at most C u^(7/2); the pressure and what "
      "one "
      "and two terms leave of it, divided by u^(1/2), u^(3/2) and u^(5/2), tend to the "
      "coefficients"},
     {"series",
      {.of = "left", .says = "1/2 3/2 5/2 7/2"},
      tilted_wedge,
      "(Es phi gam a : R)",
      "0 < Es /\\ 0 < phi /\\ 0 < gam /\\ 0 < a -> exists l0 l1 l2,\n"
      "  is_the_left_series Es (slope phi (tilt phi gam)) (gam * a) l0 l1 l2 /\\\n"
      "  has_orders Es (mirrored (slope phi (tilt phi gam))) (gam * a) l0 l1 l2 /\\\n"
      "  has_remainder Es (mirrored (slope phi (tilt phi gam))) (gam * a) l0 l1 l2",
      "exact (remainder_at_left Es phi gam a)",
      "for all tilted wedges, what three terms leave is at most C u^(7/2); the pressure and what "
      "one "
      "and two terms leave of it, divided by u^(1/2), u^(3/2) and u^(5/2), tend to the "
      "coefficients"},
     {"series",
      {.of = "right", .says = "1/2 3/2 5/2"},
      any_contact,
      contact_parameters,
      right_orders,
      "intros contact left convex. eapply orders_at_right; eassumption",
      states_orders,
      convex_smooth,
      false},
     {"series",
      {.of = "left", .says = "1/2 3/2 5/2"},
      any_contact,
      contact_parameters,
      left_orders,
      "intros contact left convex. eapply orders_at_left; eassumption",
      states_orders,
      convex_smooth,
      false},
     {"series",
      {.of = "right", .says = "1/2 3/2"},
      any_contact,
      contact_parameters,
      right_orders,
      "intros contact left convex. eapply orders_at_right; eassumption",
      states_orders,
      convex_smooth,
      false}}};

/// Returns how a ledger says that the products of the terms 2 to 9 of a shear traction with the
/// first, at both edges, are > 0 or < 0.
std::string signs_of_terms(std::string_view sign) {
    std::string all;
    for (const char* edge : {"right", "left"}) {
        for (int k = 2; k <= 9; ++k) {
            all +=
                fmt::format("{0}{1}.s{2}*{1}.s0 {3} 0", all.empty() ? "" : " and ", edge, k, sign);
        }
    }
    return all;
}

/// Whether the coefficients of a series are the exact ones, and the orders those of the theorem.
bool is_series(const audit::Claim& claim, const Said& said) {
    const std::string edge = claim.edge() == contact::Edge::right ? "right" : "left";
    const std::size_t terms = claim.has("terms") ? claim.formulas("terms").size() : 0;
    for (std::size_t k = 0; k < terms; ++k) {
        if (claim.formulas("terms")[k] != formula::Expr::symbol(fmt::format("{}_c{}", edge, k))) {
            return false;
        }
    }
    return edge == said.of && fmt::format("{}", fmt::join(claim.list("orders"), " ")) == said.says;
}

/// Whether a claim without readings, or one reading of it, says this. A field that changes what the
/// claim means, and that the theorem does not have, makes it another claim.
bool is_said(const audit::Claim& claim, const Said& said) {
    if (claim.has("vary") || claim.has("given") || claim.has("holds") ||
        (said.where.empty() ? claim.has("where") : !is_condition(claim, "where", said.where))) {
        return false;
    }
    if (claim.kind == "series") {
        return is_series(claim, said);
    }
    if (claim.kind == "relation") {
        const bool signs = said.says == ">" || said.says == "<";
        return is_condition(claim, "says", signs ? signs_of_terms(said.says) : said.says);
    }
    if (!is_formula(claim, "of", said.of)) {
        return false;
    }
    if (claim.kind == "value") {
        return is_formula(claim, "says", said.says);
    }
    const std::string_view key = claim.kind == "limit" ? "limit" : "sense";
    return claim.kind == "independence" ||
           (claim.text(key) == said.says && claim.text("along") == said.along);
}

bool says(const audit::Claim& claim, const Listed& entry) {
    if (claim.kind != entry.kind) {
        return false;
    }
    if (claim.readings.empty()) {
        return entry.said.also.empty() && is_said(claim, entry.said);
    }
    Said second = entry.said;
    second.of = second.also;
    return !second.of.empty() && claim.readings.size() == 2 &&
           is_said(claim.readings[0], entry.said) && is_said(claim.readings[1], second);
}

/// Whether the values that the claim follows end where the theorem's limit is, or approach it.
bool ends_there(const audit::Claim& claim, const audit::Ledger& ledger, const Listed& entry) {
    if (entry.said.unit.empty()) {
        return true;
    }
    const audit::Family& family = ledger.family(claim.text("over"));
    const std::string along = claim.text("along");
    const auto found = std::find_if(family.parameters.begin(), family.parameters.end(),
                                    [&](const auto& p) { return p.first == along; });
    if (found == family.parameters.end() || found->second.size() < 2) {
        return false;
    }
    const bool grows = entry.said.unit == growing;
    if (grows && (claim.edge() != contact::Edge::right ||
                  !std::all_of(family.u.begin(), family.u.end(),
                               [](const formula::Exact& u) { return u.to<double>() < 0.5; }))) {
        return false;
    }
    std::vector<double> distances;
    for (const formula::Expr& value : found->second) {
        const formula::Expr share =
            grows ? value : substitute(value, entry.said.unit, formula::Expr::number(1));
        const formula::Expr of_two = substitute(value, entry.said.unit, formula::Expr::number(2));
        if (!free_symbols(share).empty() ||
            (!grows && formula::Exact(of_two - formula::Expr::number(2) * share).sign() != 0)) {
            return false; // not a multiple of the unit
        }
        distances.push_back(grows ? 1 / formula::Exact(share).to<double>()
                                  : std::abs(formula::Exact(share).to<double>() - entry.said.end));
    }
    return std::is_sorted(distances.rbegin(), distances.rend()) &&
           distances.back() < (grows ? 1e-3 : 1e-6);
}

} // namespace

bool certify_listed(const audit::ClaimResult& result, const audit::Ledger& ledger,
                    Certificate& certificate) {
    const audit::Claim& claim = result.claim;
    if (result.outcome.verdict != audit::Verdict::confirmed || !claim.has("over")) {
        return false;
    }
    const auto scenes = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    const auto entry = std::find_if(listed.begin(), listed.end(), [&](const Listed& l) {
        return says(claim, l) && !scenes.empty() &&
               std::all_of(scenes.begin(), scenes.end(), l.about) && ends_there(claim, ledger, l);
    });
    if (entry == listed.end()) {
        return false;
    }
    Theory theory;
    theory.imports = {"Contact",       "Coefficients", "Edges",    "Symmetric",
                      "TiltedWedge",   "Unique",       "Shear",    "Sides",
                      "Limits",        "Stick",        "Orders",   "ShearTerms",
                      "TiltedRounded", "Inversion",    "PowerLaw", "Flatness"};

    const std::string name = coq_name(claim.id);
    certificate.text =
        file_head(claim, ledger, theory) +
        theorem_text(fmt::format("{} {}", name, entry->parameters), std::string(entry->statement),
                     fmt::format("  {}.\n", entry->proof));
    certificate.theorems = {{name, std::string(entry->states)}};
    certificate.leaves_out = std::string(entry->leaves_out);
    certificate.whole_verdict = entry->whole;
    return true;
}

} // namespace edgeproof::certificate
