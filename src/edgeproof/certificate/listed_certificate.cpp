// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/listed_statements.hpp"
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/statement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::certificate {
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

bool says(const audit::ClaimResult& result, const Listed& entry) {
    const audit::Claim& claim = result.claim;
    if (claim.kind != entry.kind || result.outcome.verdict != entry.verdict) {
        return false;
    }
    const auto* const end =
        std::find_if(entry.other_readings.begin(), entry.other_readings.end(),
                     [](const Said& said) { return said.of.empty() && said.says.empty(); });
    const auto others = static_cast<std::size_t>(end - entry.other_readings.begin());
    if (claim.readings.empty()) {
        return others == 0 && is_said(claim, entry.said);
    }
    return claim.readings.size() == others + 1 && is_said(claim.readings.front(), entry.said) &&
           std::equal(entry.other_readings.begin(), end, claim.readings.begin() + 1,
                      [](const Said& said, const audit::Claim& c) { return is_said(c, said); });
}

/// Returns the value of a formula of the parameters of a scene.
formula::Exact value_at(formula::Expr e, const audit::SceneSpec& scene) {
    for (const auto& [name, value] : scene.parameters) {
        e = substitute(e, name, value.expr());
    }
    return formula::Exact(e);
}

/// Whether the places that the claim varies are those of the theorem; those of a limit approach
/// their limit from above.
bool varies_as(const audit::Claim& claim, const Said& said,
               const std::vector<audit::SceneSpec>& scenes) {
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
    return std::all_of(scenes.begin(), scenes.end(), [&](const audit::SceneSpec& scene) {
        const formula::Expr from = value_at(parsed(said.from), scene).expr();
        const formula::Expr to = value_at(parsed(said.to), scene).expr();
        std::vector<double> shares;
        for (const std::string& value : varied.front().second) {
            const formula::Expr place = value_at(parsed(value), scene).expr();
            if (formula::Exact(place - from).sign() < 0 || formula::Exact(to - place).sign() < 0) {
                return false;
            }
            shares.push_back(formula::Exact((place - from) / (to - from)).to<double>());
        }
        return claim.kind != "limit" || (std::is_sorted(shares.rbegin(), shares.rend()) &&
                                         shares.back() > 0 && shares.back() < 1e-6);
    });
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
    if (!claim.has("over")) {
        return false;
    }
    const auto scenes = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    const auto is_stated = [&](const Listed& l) {
        return says(result, l) && !scenes.empty() &&
               std::all_of(scenes.begin(), scenes.end(), l.about) && ends_there(claim, ledger, l) &&
               varies_as(claim, l.said, scenes);
    };
    const Listed* entry = nullptr;
    for (const auto listed : {listed_pressures(), listed_statements()}) {
        const auto found = std::find_if(listed.begin(), listed.end(), is_stated);
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
