// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/statement.hpp"

#include <fmt/format.h>

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
bool any_contact(const audit::SceneSpec& /*s*/) { return true; }

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

    /// False if the theorem does not contain the whole verdict.
    [[nodiscard]] bool whole() const;
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

constexpr std::array<Listed, 14> listed{
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

// Without uniqueness, another solution of the integral equation may depend on the contact.
bool Listed::whole() const { return leaves_out.empty() || leaves_out == convex_smooth; }

/// The words of a claim, by which it is found in the list; empty if the claim has other fields that
/// change its meaning.
std::string words_of(const audit::Claim& claim) {
    if (!claim.readings.empty() || claim.has("where") || claim.has("vary") || claim.has("with") ||
        claim.has("given")) {
        return "";
    }
    const std::string edge = claim.edge() == contact::Edge::right ? "right" : "left";
    if (claim.kind == "relation") {
        return claim.has("holds") ? "" : claim.text("says");
    }
    if (claim.kind == "limit") {
        return claim.text("of") + " -> " + claim.text("limit") + " along " + claim.text("along");
    }
    if (claim.kind == "monotone") {
        return claim.text("of") + " " + claim.text("sense") + " along " + claim.text("along");
    }
    if (claim.kind == "value") {
        return claim.text("of") + " = " + claim.text("says");
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
    std::vector<double> distances;
    for (const formula::Expr& value : found->second) {
        const formula::Expr share = substitute(value, entry.unit, formula::Expr::number(1));
        if (!free_symbols(share).empty()) {
            return false;
        }
        distances.push_back(std::abs(formula::Exact(share).to<double>() - entry.end));
    }
    return std::is_sorted(distances.rbegin(), distances.rend()) && distances.back() < 1e-6;
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
    theory.imports = {"Contact", "Coefficients", "Edges",  "Symmetric", "TiltedWedge", "Unique",
                      "Shear",   "Sides",        "Limits", "Stick",     "Orders"};
    const std::string name = coq_name(claim.id);
    certificate.text =
        file_head(claim, ledger, theory) +
        theorem_text(fmt::format("{} {}", name, entry->parameters), std::string(entry->statement),
                     fmt::format("  {}.\n", entry->proof));
    certificate.theorems = {{name, std::string(entry->states)}};
    certificate.leaves_out = std::string(entry->leaves_out);
    certificate.whole_verdict = entry->whole();
    return true;
}

} // namespace edgeproof::certificate
