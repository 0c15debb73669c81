// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/listed_statements.hpp"
#include "edgeproof/certificate/theory/theory.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace edgeproof::certificate {
namespace listed_scenes {

namespace {

double number(const SceneSpec& scene, const std::string& parameter) {
    return scene.parameter(parameter).to<double>();
}
bool flat_and_rounded(const SceneSpec& s) {
    return s.profile == "flat-and-rounded" && s.parameters.contains("a");
}
bool without(const SceneSpec& s, const std::string& load) {
    const auto found = s.parameters.find(load);
    return found != s.parameters.end() && found->second.sign() == 0;
}
bool under(const SceneSpec& s, const std::string& load) {
    return s.parameters.contains(load) && !without(s, load);
}

} // namespace

bool tilted_wedge(const SceneSpec& s) {
    return s.profile == "tilted-wedge" && std::abs(number(s, "alpha")) < number(s, "phi");
}
bool tilted_to_the_left(const SceneSpec& s) {
    return tilted_wedge(s) && s.parameter("alpha").sign() > 0;
}
bool beyond_the_flat(const SceneSpec& s) {
    return flat_and_rounded(s) &&
           Exact(s.parameter("a").expr() - s.parameter("t").expr()).sign() > 0;
}
bool within_the_flat(const SceneSpec& s) { return flat_and_rounded(s) && !beyond_the_flat(s); }
bool force_alone(const SceneSpec& s) { return without(s, "sig0") && under(s, "Q"); }
bool tension_alone(const SceneSpec& s) { return without(s, "Q") && under(s, "sig0"); }
bool tilted_punch(const SceneSpec& s) {
    return s.profile == "tilted-flat-and-rounded" && s.parameter("alpha").sign() > 0 &&
           s.parameter("t").sign() > 0 && s.parameter("R").sign() > 0;
}
bool power_law(const SceneSpec& s) {
    return s.profile == "power-law" && s.parameter("m").sign() >= 0 && s.parameter("C").sign() > 0;
}
bool symmetric(const SceneSpec& s) {
    return s.profile == "power-law" || s.profile == "flat-and-rounded" ||
           s.profile == "piecewise-symmetric";
}
bool power_law_or_rounded(const SceneSpec& s) { return power_law(s) || beyond_the_flat(s); }
bool non_symmetric(const SceneSpec& s) { return tilted_wedge(s) || tilted_punch(s); }
bool wedge_or_power_law_under_force(const SceneSpec& s) {
    return force_alone(s) && (tilted_wedge(s) || power_law(s));
}
bool wedge_under_force(const SceneSpec& s) { return force_alone(s) && tilted_wedge(s); }
bool under_a_force(const SceneSpec& s) { return under(s, "Q"); }
bool parabola_in_plane_strain(const SceneSpec& s) {
    if (!power_law(s) || !s.parameters.contains("Ey") || !s.parameters.contains("nu")) {
        return false;
    }
    const Expr one = Expr::number(1);
    const Expr nu = s.parameter("nu").expr();
    const Expr rest = one - nu * nu;
    return Exact(s.parameter("m").expr() - one).sign() == 0 && s.parameter("Ey").sign() > 0 &&
           Exact(rest).sign() > 0 &&
           Exact(s.parameter("Es").expr() * rest - s.parameter("Ey").expr()).sign() == 0;
}
bool any_contact(const SceneSpec& /*s*/) { return true; }

} // namespace listed_scenes

namespace {

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
bool is_series(const Claim& claim, const Said& said) {
    const std::string edge = claim.edge() == Edge::right ? "right" : "left";
    const std::size_t terms = claim.has("terms") ? claim.formulas("terms").size() : 0;
    for (std::size_t k = 0; k < terms; ++k) {
        if (claim.formulas("terms")[k] != Expr::symbol(fmt::format("{}_c{}", edge, k))) {
            return false;
        }
    }
    return edge == said.of && fmt::format("{}", fmt::join(claim.list("orders"), " ")) == said.says;
}

/// Whether a claim without readings, or one reading of it, says this. A field that changes what the
/// claim means, and that the theorem does not have, makes it another claim.
bool is_said(const Claim& claim, const Said& said) {
    if (claim.has("vary") == said.to.empty() || claim.has("given") || claim.has("holds") ||
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
    if (claim.kind == "order") {
        return is_formula(claim, "says", said.says) &&
               claim.text_or("factor", "of-the-scene") == said.along;
    }
    if (claim.kind == "vanishing") {
        return is_formula(claim, "says", said.says) &&
               is_formula(claim, "ratio", "sig0*((a+b)/2)/Q");
    }
    const std::string_view key = claim.kind == "limit" ? "limit" : "sense";
    return claim.kind == "independence" ||
           (claim.text(key) == said.says && claim.text("along") == said.along);
}

bool says(const ClaimResult& result, const Listed& entry) {
    const Claim& claim = result.claim;
    if (claim.kind != entry.kind || result.outcome.verdict != entry.verdict) {
        return false;
    }
    const auto* const end = std::ranges::find_if(entry.other_readings, [](const Said& said) {
        return said.of.empty() && said.says.empty();
    });
    const auto others = static_cast<std::size_t>(end - entry.other_readings.begin());
    if (claim.readings.empty()) {
        return others == 0 && is_said(claim, entry.said);
    }
    return claim.readings.size() == others + 1 && is_said(claim.readings.front(), entry.said) &&
           std::equal(entry.other_readings.begin(), end, claim.readings.begin() + 1,
                      [](const Said& said, const Claim& c) { return is_said(c, said); });
}

/// Returns the value of a formula of the parameters of a scene.
Exact value_at(Expr e, const SceneSpec& scene) {
    for (const auto& [name, value] : scene.parameters) {
        e = substitute(e, name, value.expr());
    }
    return Exact(e);
}

/// Whether the places that the claim varies are those of the theorem; those of a limit approach
/// their limit from above.
bool varies_as(const Claim& claim, const Said& said, const std::vector<SceneSpec>& scenes) {
    if (said.to.empty()) {
        return true;
    }
    const auto& varied = claim.table("vary");
    if (varied.size() != 1 || varied.front().first != said.along) {
        return false;
    }
    const auto parsed = [&](std::string_view text) {
        return audit::parse_formula(text, {claim.vocabulary.symbols, {}});
    };
    return std::ranges::all_of(scenes, [&](const SceneSpec& scene) {
        const Expr from = value_at(parsed(said.from), scene).expr();
        const Expr to = value_at(parsed(said.to), scene).expr();
        std::vector<double> shares;
        for (const std::string& value : varied.front().second) {
            const Expr place = value_at(parsed(value), scene).expr();
            if (Exact(place - from).sign() < 0 || Exact(to - place).sign() < 0) {
                return false;
            }
            shares.push_back(Exact((place - from) / (to - from)).to<double>());
        }
        return claim.kind != "limit" || (std::is_sorted(shares.rbegin(), shares.rend()) &&
                                         shares.back() > 0 && shares.back() < 1e-6);
    });
}

/// Whether the values that the claim follows end where the theorem's limit is, or approach it.
bool ends_there(const Claim& claim, const Ledger& ledger, const Listed& entry) {
    if (entry.said.unit.empty()) {
        return true;
    }
    const Family& family = ledger.family(claim.text("over"));
    const std::string along = claim.text("along");
    const auto found =
        std::ranges::find_if(family.parameters, [&](const auto& p) { return p.first == along; });
    if (found == family.parameters.end() || found->second.size() < 2) {
        return false;
    }
    const bool grows = entry.said.unit == growing;
    if (grows && (claim.edge() != Edge::right || !std::ranges::all_of(family.u, [](const Exact& u) {
                      return u.to<double>() < 0.5;
                  }))) {
        return false;
    }
    std::vector<double> distances;
    for (const Expr& value : found->second) {
        const Expr share = grows ? value : substitute(value, entry.said.unit, Expr::number(1));
        const Expr of_two = substitute(value, entry.said.unit, Expr::number(2));
        if (!free_symbols(share).empty() ||
            (!grows && Exact(of_two - Expr::number(2) * share).sign() != 0)) {
            return false; // not a multiple of the unit
        }
        distances.push_back(grows ? 1 / Exact(share).to<double>()
                                  : std::abs(Exact(share).to<double>() - entry.said.end));
    }
    return std::is_sorted(distances.rbegin(), distances.rend()) &&
           distances.back() < (grows ? 1e-3 : 1e-6);
}

} // namespace

bool certify_listed(const ClaimResult& result, const Ledger& ledger, Certificate& certificate) {
    const Claim& claim = result.claim;
    if (!claim.has("over")) {
        return false;
    }
    const auto scenes = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    const auto is_stated = [&](const Listed& l) {
        return says(result, l) && !scenes.empty() && std::ranges::all_of(scenes, l.about) &&
               ends_there(claim, ledger, l) && varies_as(claim, l.said, scenes);
    };
    const Listed* entry = nullptr;
    for (const auto listed : {listed_pressures(), listed_statements()}) {
        const auto found = std::ranges::find_if(listed, is_stated);
        if (entry == nullptr && found != listed.end()) {
            entry = &*found;
        }
    }
    if (entry == nullptr) {
        return false;
    }
    Theory theory;
    theory.imports = {"Contact",       "Coefficients",   "Edges",    "Symmetric",
                      "TiltedWedge",   "Unique",         "Shear",    "Sides",
                      "Limits",        "Stick",          "Orders",   "ShearTerms",
                      "TiltedRounded", "Inversion",      "PowerLaw", "Flatness",
                      "Similar",       "LoadOfPressure", "Forward",  "ForwardPunches",
                      "Consistency",   "RoundedShape",   "Readings"};
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
