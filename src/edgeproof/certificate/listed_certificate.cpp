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
bool beyond_the_flat(const audit::SceneSpec& s) {
    return s.profile == "flat-and-rounded" &&
           formula::Exact(s.parameter("a").expr() - s.parameter("t").expr()).sign() > 0;
}
bool within_the_flat(const audit::SceneSpec& s) {
    return s.profile == "flat-and-rounded" &&
           formula::Exact(s.parameter("a").expr() - s.parameter("t").expr()).sign() <= 0;
}
bool without(const audit::SceneSpec& s, const std::string& load) {
    const auto found = s.parameters.find(load);
    return found != s.parameters.end() && found->second.sign() == 0;
}
bool force_alone(const audit::SceneSpec& s) { return without(s, "sig0") && !without(s, "Q"); }
bool tension_alone(const audit::SceneSpec& s) { return without(s, "Q") && !without(s, "sig0"); }
bool tilted_punch(const audit::SceneSpec& s) {
    return s.profile == "tilted-flat-and-rounded" && s.parameter("alpha").sign() > 0 &&
           s.parameter("t").sign() > 0 && s.parameter("R").sign() > 0;
}
bool power_law(const audit::SceneSpec& s) {
    return s.profile == "power-law" && s.parameter("m").sign() >= 0 && s.parameter("C").sign() > 0;
}
bool any_contact(const audit::SceneSpec& /*s*/) { return true; }

/// In place of a unit: the values grow without bound, and the places are to the right of x = 0.
constexpr std::string_view growing = "growing";

/// A claim for which the Coq files have a theorem: its kind, its words (`key_of`), and the scenes
/// that the theorem is about.
struct Listed {
    std::string_view kind;
    std::string_view words;
    bool (*about)(const audit::SceneSpec&);
    /// The parameter of `about` that the claim follows, divided by this one, ends there.
    std::string_view unit;
    double end;
    std::string_view parameters; ///< of the theorem: "phi a : R"
    std::string_view statement;
    std::string_view proof;
    std::string_view states;
    std::string_view leaves_out;
    bool whole = true;
};

constexpr std::string_view convex_smooth =
    "the punch is taken to be convex; the load and the left edge are taken to be smooth functions "
    "of the right edge, as the expansion needs";
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
    "for all contacts, the pressure and what one and two terms leave of it, divided by u^(1/2), "
    "u^(3/2) and u^(5/2), tend to the coefficients";

constexpr std::array<Listed, 23> listed{
    {{"relation", "0 < b/a and b/a < 1", tilted_to_the_left, "", 0, "(phi a alpha : R)",
      "0 < phi /\\ 0 < a /\\ 0 < alpha < phi ->\n"
      "  exists b, is_the_left_edge (slope phi alpha) a b /\\ 0 < b / a /\\ b / a < 1",
      "intros form. apply ratio_in_range; lra",
      "for all wedges tilted by less than their angle, 0 < b/a < 1", ""},
     {"limit", "b/a -> 1 along alpha", tilted_to_the_left, "phi", 0, "(phi a : R)",
      "0 < phi /\\ 0 < a -> exists b : R -> R,\n"
      "  (forall alpha, 0 < alpha < phi -> is_the_left_edge (slope phi alpha) a (b alpha)) /\\\n"
      "  filterlim (fun alpha => b alpha / a) (at_right 0) (locally 1)",
      "intros form. apply ratio_of_a_small_tilt; lra",
      "for all wedges, b/a tends to 1 as the tilt tends to 0", ""},
     {"limit", "b/a -> 0 along alpha", tilted_to_the_left, "phi", 1, "(phi a : R)",
      "0 < phi /\\ 0 < a -> exists b : R -> R,\n"
      "  (forall alpha, 0 < alpha < phi -> is_the_left_edge (slope phi alpha) a (b alpha)) /\\\n"
      "  filterlim (fun alpha => b alpha / a) (at_left phi) (locally 0)",
      "intros form. apply ratio_of_the_largest_tilt; lra",
      "for all wedges, b/a tends to 0 as the tilt tends to the angle", ""},
     {"value", "Es/2*integral(s*g1(s)/sqrt(a^2-s^2), s, -a, a) = 0", within_the_flat, "", 0,
      "(Es t R0 a : R)",
      "0 < t /\\ 0 < R0 /\\ 0 < a <= t ->\n"
      "  is_load Es (Symmetric.slope (rounded t R0)) a a 0 /\\\n"
      "  forall P, is_load Es (Symmetric.slope (rounded t R0)) a a P -> P = 0",
      "intros form. apply no_load_within_flat; lra",
      "for all punches, between edges on the flat the load is 0, and no other", ""},
     {"value", "Pof(a) = 0", within_the_flat, "", 0, "(Es t R0 a : R)",
      "0 < t /\\ 0 < R0 /\\ 0 < a <= t ->\n"
      "  is_load Es (Symmetric.slope (rounded t R0)) a a 0 /\\\n"
      "  forall P, is_load Es (Symmetric.slope (rounded t R0)) a a P -> P = 0",
      "intros form. apply no_load_within_flat; lra",
      "for all punches, between edges on the flat the load is 0, and no other", ""},
     {"monotone", "P decreasing along a", beyond_the_flat, "t", 1, "(Es t R0 a c : R)",
      "0 < Es /\\ 0 < t /\\ 0 < R0 /\\ t < a < c -> exists P Q,\n"
      "  is_the_load Es (Symmetric.slope (rounded t R0)) a a P /\\\n"
      "  is_the_load Es (Symmetric.slope (rounded t R0)) c c Q /\\ P < Q",
      "intros form. apply load_grows; lra",
      "for all punches, of two contacts the one with the edge nearer to the flat has the smaller "
      "load",
      ""},
     {"limit", "P/(Es*t) -> 0 along a", beyond_the_flat, "t", 1, "(Es t R0 : R)",
      "0 < Es /\\ 0 < t /\\ 0 < R0 -> exists P : R -> R,\n"
      "  (forall a, t < a -> is_the_load Es (Symmetric.slope (rounded t R0)) a a (P a)) /\\\n"
      "  filterlim (fun a => P a / (Es * t)) (at_right t) (locally 0)",
      "intros form. apply load_vanishes; lra",
      "for all punches, the load tends to 0 as the edge tends to the end of the flat", ""},
     {"value", "0 = gp(0), gp(s) = -alpha + max(s + alpha*R, 0)/R + min(s + 2*t + alpha*R, 0)/R",
      tilted_punch, "", 0, "(alpha t R0 : R)",
      "0 < alpha /\\ 0 < t /\\ 0 < R0 -> tilted_rounded_slope alpha t R0 0 = 0",
      "intros form. apply lowest_at_origin; lra", "for all such punches, the slope is 0 at x = 0",
      ""},
     {"value",
      "sgn(x)*gp(x) = abs(gp(x)), gp(s) = -alpha + max(s + alpha*R, 0)/R + min(s + 2*t + "
      "alpha*R, 0)/R",
      tilted_punch, "", 0, "(alpha t R0 : R)",
      "0 < alpha /\\ 0 < t /\\ 0 < R0 -> forall x,\n"
      "  Rabs (tilted_rounded_slope alpha t R0 x) = sign x * tilted_rounded_slope alpha t R0 x",
      "intros form. apply falls_and_rises; lra",
      "for all such punches and all x, |g'(x)| = sgn(x) g'(x)", ""},
     {"value", "g1(x) = x/R where x > 0", tilted_punch, "", 0, "(alpha t R0 : R)",
      "0 < alpha /\\ 0 < t /\\ 0 < R0 -> forall x, 0 < x ->\n"
      "  x / R0 = tilted_rounded_slope alpha t R0 x",
      "intros form. apply parabola_to_the_right; lra",
      "for all such punches and all x > 0, g'(x) = x/R", ""},
     {"value", "q(x) = Q/(Pi*sqrt((a-x)*(x+b))) + sig0*(2*x+b-a)/(8*sqrt((a-x)*(x+b)))",
      any_contact, "", 0, "(Q sig0 a b : R)",
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
      "that the integral equation has no solution of another form"},
     {"value", "p(x) = Es/(2*Pi)*sqrt(a^2-x^2)*pv(g1(s)/sqrt(a^2-s^2)*(1/(s-x)), s, -a, a, x)",
      any_contact, "", 0, "(Es m a x : R) (l : list part)",
      "convex_punch l -> beyond m l -> 0 < m < x -> x < a ->\n"
      "  exists p0 l0, is_the_pressure Es (Symmetric.slope l) a x p0 /\\\n"
      "  is_principal_value (fun s => Symmetric.slope l s / sqrt (a ^ 2 - s ^ 2) * (1 / (s - x))) "
      "(- a) a x l0 /\\\n"
      "  Es / (2 * PI) * sqrt (a ^ 2 - x ^ 2) * l0 = p0",
      "exact (the_pressure_by_inversion Es l m a x)",
      "for all symmetric punches whose g' is piecewise linear and convex (wedges, parabolas, flat "
      "punches with rounded edges and sums of these), beyond all knots, printed = Barber and "
      "Mossakovskii's integral",
      "power laws with other exponents than 0 and 1; places on the flat", false},
     {"relation", "the terms 2 to 9 of both edges have the sign of the first", force_alone, "", 0,
      "(a b Q : R)",
      "0 < a + b /\\ Q <> 0 -> exists s v : nat -> R,\n"
      "  are_the_right_terms (full_stick Q 0 a b) a s 9 /\\ are_the_left_terms (full_stick Q 0 a "
      "b) b "
      "v 9 /\\\n  forall k, (1 <= k <= 9)%nat -> 0 < s k * s 0%nat /\\ 0 < v k * v 0%nat",
      "intros form. apply force_signs; apply form",
      "for all contacts under a shear force, the terms 1 to 9 of both edges have the sign of the "
      "first",
      ""},
     {"relation", "the terms 2 to 9 of both edges have the opposite sign of the first",
      tension_alone, "", 0, "(a b sig0 : R)",
      "0 < a + b /\\ sig0 <> 0 -> exists s v : nat -> R,\n"
      "  are_the_right_terms (full_stick 0 sig0 a b) a s 9 /\\ are_the_left_terms (full_stick 0 "
      "sig0 "
      "a b) b v 9 /\\\n  forall k, (1 <= k <= 9)%nat -> s k * s 0%nat < 0 /\\ v k * v 0%nat < 0",
      "intros form. apply tension_signs; apply form",
      "for all contacts under a tension, the terms 1 to 9 of both edges have the opposite sign of "
      "the first",
      ""},
     {"limit", "p(x)/(P/(Pi*sqrt(a^2-x^2))) -> 1 along m", power_law, growing, 0, "(Es C a x : R)",
      "0 < Es /\\ 0 < C /\\ 0 < x < a -> exists p P : R -> R,\n"
      "  (forall m, 0 <= m -> is_the_pressure Es (power_slope C m) a x (p m) /\\\n"
      "    is_the_load Es (power_slope C m) a a (P m)) /\\\n"
      "  filterlim (fun m => p m / (P m / (PI * sqrt (a ^ 2 - x ^ 2)))) (Rbar_locally p_infty) "
      "(locally 1)",
      "exact (becomes_rectangular Es C a x)",
      "at every place x > 0 of all contacts, the pressure divided by that of a rectangular punch "
      "tends to 1 as m grows without bound",
      ""},
     {"limit",
      "right_local(1, x)/p(x) -> infinity along m and right_local(1, x)*a/P -> infinity along m",
      power_law, growing, 0, "(Es C a x : R)",
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
      "grows without bound with m",
      ""},
     {"independence", "q(x)*L/Q", force_alone, "", 0, "(a b c e Q N xi : R)",
      "0 < a + b -> 0 < c + e -> Q <> 0 -> N <> 0 -> 0 < xi < 1 ->\n"
      "  is_traction (full_stick Q 0 a b) a b Q 0 /\\ is_traction (full_stick N 0 c e) c e N 0 "
      "/\\\n"
      "  full_stick Q 0 a b (a - xi * (a + b)) * (a + b) / Q =\n"
      "  full_stick N 0 c e (c - xi * (c + e)) * (c + e) / N",
      "exact (force_independent a b c e Q N xi)",
      "for any two contacts and forces, both tractions solve the integral equation of full stick, "
      "and q L/Q is the same at the same share of the contact",
      "that the integral equation has no other solution"},
     {"independence", "q(x)/sig0", tension_alone, "", 0, "(a b c e sig0 tau xi : R)",
      "0 < a + b -> 0 < c + e -> sig0 <> 0 -> tau <> 0 -> 0 < xi < 1 ->\n"
      "  is_traction (full_stick 0 sig0 a b) a b 0 sig0 /\\\n"
      "  is_traction (full_stick 0 tau c e) c e 0 tau /\\\n"
      "  full_stick 0 sig0 a b (a - xi * (a + b)) / sig0 =\n"
      "  full_stick 0 tau c e (c - xi * (c + e)) / tau",
      "exact (tension_independent a b c e sig0 tau xi)",
      "for any two contacts and tensions, both tractions solve the integral equation of full "
      "stick, "
      "and q/sig0 is the same at the same share of the contact",
      "that the integral equation has no other solution"},
     {"series", "right: 1/2 3/2 5/2 7/2", tilted_wedge, "", 0, "(Es phi gam a : R)",
      "0 < Es /\\ 0 < phi /\\ 0 < gam /\\ 0 < a -> exists r0 r1 r2,\n"
      "  is_the_right_series Es (slope phi (tilt phi gam)) a r0 r1 r2 /\\\n"
      "  has_orders Es (slope phi (tilt phi gam)) a r0 r1 r2 /\\\n"
      "  has_remainder Es (slope phi (tilt phi gam)) a r0 r1 r2",
      "exact (remainder_at_right Es phi gam a)",
      "for all tilted wedges, what three terms leave is at most C u^(7/2); the pressure and what "
      "one "
      "and two terms leave of it, divided by u^(1/2), u^(3/2) and u^(5/2), tend to the "
      "coefficients",
      ""},
     {"series", "left: 1/2 3/2 5/2 7/2", tilted_wedge, "", 0, "(Es phi gam a : R)",
      "0 < Es /\\ 0 < phi /\\ 0 < gam /\\ 0 < a -> exists l0 l1 l2,\n"
      "  is_the_left_series Es (slope phi (tilt phi gam)) (gam * a) l0 l1 l2 /\\\n"
      "  has_orders Es (mirrored (slope phi (tilt phi gam))) (gam * a) l0 l1 l2 /\\\n"
      "  has_remainder Es (mirrored (slope phi (tilt phi gam))) (gam * a) l0 l1 l2",
      "exact (remainder_at_left Es phi gam a)",
      "for all tilted wedges, what three terms leave is at most C u^(7/2); the pressure and what "
      "one "
      "and two terms leave of it, divided by u^(1/2), u^(3/2) and u^(5/2), tend to the "
      "coefficients",
      ""},
     {"series", "right: 1/2 3/2 5/2", any_contact, "", 0, contact_parameters, right_orders,
      "intros contact left convex. eapply orders_at_right; eassumption", states_orders,
      convex_smooth},
     {"series", "left: 1/2 3/2 5/2", any_contact, "", 0, contact_parameters, left_orders,
      "intros contact left convex. eapply orders_at_left; eassumption", states_orders,
      convex_smooth},
     {"series", "right: 1/2 3/2", any_contact, "", 0, contact_parameters, right_orders,
      "intros contact left convex. eapply orders_at_right; eassumption", states_orders,
      convex_smooth}}};

/// Returns how a ledger says that the products of the terms 2 to 9 of a shear traction with the
/// first, at both edges, have a sign.
std::string signs_of_terms(std::string_view sign) {
    std::string all;
    for (const char* edge : {"right", "left"}) {
        for (int k = 2; k <= 9; ++k) {
            all += fmt::format("{0}{1}.s{2}*{1}.s0{3}", all.empty() ? "" : " and ", edge, k, sign);
        }
    }
    return all;
}

/// The words of a claim, by which it is found in the list; empty if the claim has other fields that
/// change its meaning.
std::string words_of(const audit::Claim& claim) {
    if (claim.kind == "limit" && !claim.readings.empty()) {
        std::string all;
        for (const audit::Claim& reading : claim.readings) {
            all += (all.empty() ? "" : " and ") + words_of(reading);
        }
        return all;
    }
    if (!claim.readings.empty() || claim.has("vary") || claim.has("given") ||
        (claim.kind != "value" && (claim.has("where") || claim.has("with")))) {
        return "";
    }
    const std::string edge = claim.edge() == contact::Edge::right ? "right" : "left";
    if (claim.kind == "relation") {
        return claim.has("holds") ? ""
               : claim.text("says") == signs_of_terms(" > 0")
                   ? "the terms 2 to 9 of both edges have "
                     "the sign of the first"
               : claim.text("says") == signs_of_terms(" < 0")
                   ? "the terms 2 to 9 of both edges have the opposite sign of the first"
                   : claim.text("says");
    }
    if (claim.kind == "limit") {
        return claim.text("of") + " -> " + claim.text("limit") + " along " + claim.text("along");
    }
    if (claim.kind == "monotone") {
        return claim.text("of") + " " + claim.text("sense") + " along " + claim.text("along");
    }
    if (claim.kind == "value") {
        std::string words = claim.text("of") + " = " + claim.text("says");
        if (claim.has("with")) {
            for (const auto& [name, meaning] : claim.table("with")) {
                words += fmt::format(", {} = {}", name, fmt::join(meaning, " "));
            }
        }
        return claim.has("where") ? words + " where " + claim.text("where") : words;
    }
    if (claim.kind == "independence") {
        return claim.text("of");
    }
    if (claim.kind == "series") {
        std::string words = edge + ":";
        for (const std::string& order : claim.list("orders")) {
            words += " " + order;
        }
        for (std::size_t k = 0; claim.has("terms") && k < claim.list("terms").size(); ++k) {
            if (claim.list("terms")[k] != fmt::format("{}.c{}", edge, k)) {
                return "";
            }
        }
        return words;
    }
    return "";
}

/// Whether the values that the claim follows end where the theorem's limit is, or approach it.
bool ends_there(const audit::Claim& claim, const audit::Ledger& ledger, const Listed& entry) {
    if (entry.unit.empty()) {
        return true;
    }
    const audit::Family& family = ledger.family(claim.text("over"));
    const std::string along = claim.text("along");
    const auto found = std::find_if(family.parameters.begin(), family.parameters.end(),
                                    [&](const auto& p) { return p.first == along; });
    if (found == family.parameters.end() || found->second.size() < 2) {
        return false;
    }
    const bool grows = entry.unit == growing;
    if (grows && (claim.edge() != contact::Edge::right ||
                  !std::all_of(family.u.begin(), family.u.end(),
                               [](const formula::Exact& u) { return u.to<double>() < 0.5; }))) {
        return false;
    }
    std::vector<double> distances;
    for (const formula::Expr& value : found->second) {
        const formula::Expr share =
            grows ? value : substitute(value, entry.unit, formula::Expr::number(1));
        if (!free_symbols(share).empty()) {
            return false;
        }
        distances.push_back(grows ? 1 / formula::Exact(share).to<double>()
                                  : std::abs(formula::Exact(share).to<double>() - entry.end));
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
    const std::string words = words_of(claim);
    const auto scenes = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    const auto entry = std::find_if(listed.begin(), listed.end(), [&](const Listed& l) {
        return l.kind == claim.kind && l.words == words &&
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
