// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/statement.hpp"

#include <fmt/format.h>

#include <optional>

namespace edgeproof::certificate {
namespace {

/// Returns the corrected ratio sig0 d/Q, read from "sig0*d/Q = -(4/(3*Pi)) for left.s1".
std::optional<formula::Expr> corrected_ratio(const audit::ClaimResult& result) {
    const std::string& ratio = result.claim.text("ratio");
    if (!result.outcome.correct || !result.outcome.correct->starts_with(ratio + " = ")) {
        return std::nullopt;
    }
    const std::string rest = result.outcome.correct->substr(ratio.size() + 3);
    return parse_formula(rest.substr(0, rest.find(" for ")), result.claim.vocabulary);
}

/// A contact whose bulk tension is `ratio` times Q/d.
SampledTheory contact_of_ratio(const audit::Claim& claim, const std::string& name,
                               const formula::Expr& ratio) {
    return sheared_contact(claim.edge(),
                           {name, fmt::format("({}) * Q / ((a + b) / 2)", coq_text(ratio, {})),
                            formula::Exact::parse("(" + to_text(ratio) + ")*2/5")});
}

std::string size_theorem(const std::string& name, const SampledTheory& t, const formula::Expr& e,
                         const std::optional<std::string>& least) {
    Statement statement(t.theory);
    const std::string value = statement(e);
    const std::string conclusion =
        least ? fmt::format("{} <= Rabs ({})", *least, value) : value + " = 0";
    return theorem_text(name, statement.text(conclusion),
                        statement.proof(least ? "numbers constants" : "vanishes constants"));
}

} // namespace

// The claim is that a coefficient of the shear traction vanishes at one ratio of tension to force.
// States that it does not, and that it does at the corrected ratio.
void certify_vanishing(const audit::ClaimResult& result, const audit::Ledger& ledger,
                       Certificate& certificate) {
    const audit::Claim& claim = result.claim;
    if (result.outcome.verdict != audit::Verdict::refuted || !claim.readings.empty() ||
        !is_formula(claim, "ratio", "sig0*((a+b)/2)/Q")) {
        throw NotStated("of what vanishes, only that it does not at a ratio sig0*d/Q, where d is "
                        "(a+b)/2, is stated");
    }
    const formula::Expr of = claim.formula("of");
    const SampledTheory printed = contact_of_ratio(claim, "sig0", claim.formula("says"));
    const auto gap = gap_at(of, formula::Expr(), printed.sample);
    if (!gap || gap->least <= 0) {
        throw NotStated("there is no enclosure of the coefficient");
    }
    const std::string name = coq_name(claim.id);
    const std::string least = fraction_below(gap->least);
    Theory all = printed.theory;
    std::string more;
    const auto ratio = corrected_ratio(result);
    if (ratio) {
        const SampledTheory corrected = contact_of_ratio(claim, "sig0_corrected", *ratio);
        all.constants.push_back(corrected.theory.constants.back());
        more = size_theorem(name + "_corrected", corrected, of, std::nullopt);
    }
    certificate.text = file_head(claim, ledger, all) + constants(all.constants) +
                       size_theorem(name + "_refuted", printed, of, least) + more;
    certificate.theorems = {
        {name + "_refuted",
         fmt::format("at the printed ratio of one contact, |{}| >= {}", claim.text("of"), least)}};
    if (ratio) {
        certificate.theorems.push_back(
            {name + "_corrected",
             fmt::format("at the corrected ratio of the same contact, {} = 0", claim.text("of"))});
    }
    certificate.whole_verdict = true;
    certificate.leaves_out = "that the correction holds for all contacts";
}

} // namespace edgeproof::certificate
