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
    const auto listed = listed_statements();
    const auto entry = std::find_if(listed.begin(), listed.end(), [&](const Listed& l) {
        return says(claim, l) && !scenes.empty() &&
               std::all_of(scenes.begin(), scenes.end(), l.about) && ends_there(claim, ledger, l);
    });
    if (entry == listed.end()) {
        return false;
    }
    Theory theory;
    theory.imports = {"Contact",  "Coefficients", "Edges",          "Symmetric", "TiltedWedge",
                      "Unique",   "Shear",        "Sides",          "Limits",    "Stick",
                      "Orders",   "ShearTerms",   "TiltedRounded",  "Inversion", "PowerLaw",
                      "Flatness", "Similar",      "LoadOfPressure", "Forward"};
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
