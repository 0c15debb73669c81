// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/statement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace edgeproof::certificate {
namespace {

using formula::Expr;

/// Returns the theorem `least <= Rabs (...)` or `Rabs (...) <= most`, with its proof.
std::string theorem(const std::string& name, const Theory& theory, const Expr& formula,
                    const Expr& exact, const std::optional<std::string>& least) {
    Statement statement(theory);
    const std::string stated = statement(formula);
    const std::string value = statement(exact);
    const std::string difference = fmt::format("Rabs (({}) - ({}))", stated, value);
    const std::string conclusion =
        least ? fmt::format("{} <= {}", *least, difference)
              : fmt::format("{} <= {} * Rabs ({})", difference, agreement, value);
    return theorem_text(
        name, statement.text(conclusion),
        statement.proof(least ? "numbers constants" : "apply Rminus_le. numbers constants"));
}

std::optional<Expr> correction(const audit::ClaimResult& result) {
    if (!result.outcome.correct) {
        return std::nullopt;
    }
    try {
        return expand_definitions(parse_formula(*result.outcome.correct, result.claim.vocabulary),
                                  result.claim.vocabulary);
    } catch (const Error&) {
        return std::nullopt; // the correction is in words
    }
}

bool is_of_shear(const Expr& e) {
    const auto symbols = free_symbols(e);
    return std::any_of(symbols.begin(), symbols.end(), [](const std::string& name) {
        return name.starts_with("right_s") || name.starts_with("left_s");
    });
}

/// Returns the sample at which the relative difference of the two is largest.
const SampledTheory* clearest(const std::vector<SampledTheory>& theories, const Expr& printed,
                              const Expr& exact, Gap& gap) {
    const SampledTheory* best = nullptr;
    for (const SampledTheory& t : theories) {
        const auto here = gap_at(printed, exact, t.sample);
        if (here && here->relative > gap.relative) {
            gap = *here;
            best = &t;
        }
    }
    return best;
}

} // namespace

void certify_value(const audit::ClaimResult& result, const audit::Ledger& ledger,
                   Certificate& certificate) {
    const audit::Claim& claim = result.claim;
    const bool refuted = result.outcome.verdict == audit::Verdict::refuted;
    if (!refuted && result.outcome.verdict != audit::Verdict::confirmed) {
        throw NotStated("only claims that are refuted or confirmed are stated");
    }
    if (claim.has("vary") || !claim.readings.empty()) {
        throw NotStated("variables of its own and several readings are not stated in Coq");
    }
    const Expr printed = claim.formula("says");
    const Expr exact = claim.formula("of");
    if (is_same_for_all(printed, exact, claim.edge())) {
        throw NotStated(
            "the formula is the quantity itself, whatever the coefficients are: a theorem "
            "would contain no mechanics");
    }
    std::vector<SampledTheory> theories;
    if (is_of_shear(printed) || is_of_shear(exact)) {
        theories.push_back(
            sheared_contact(claim.edge(), {"sig0", "1", formula::Exact::parse("1")}));
    }
    for (const std::string& profile : profiles_of(ledger, claim.text("over"))) {
        for (SampledTheory& t : sampled_theories(profile)) {
            theories.push_back(std::move(t));
        }
    }
    if (theories.empty()) {
        throw NotStated("the Coq files have no theory of the profile");
    }
    const std::string name = coq_name(claim.id);
    if (!refuted) {
        const Theory& theory = theories.front().theory;
        certificate.text = file_head(claim, ledger, theory) + constants(theory.constants) +
                           theorem(name + "_agrees", theory, printed, exact, std::nullopt);
        certificate.theorems = {
            {name + "_agrees", "at one contact, |printed - exact| <= 1e-12 |exact|"}};
        certificate.leaves_out = "all other contacts";
        return;
    }
    Gap gap;
    const SampledTheory* const sample = clearest(theories, printed, exact, gap);
    if (sample == nullptr) {
        throw NotStated("the formula agrees at the samples that the Coq files have");
    }
    const Theory& theory = sample->theory;
    const std::string least = fraction_below(gap.least);
    certificate.text = file_head(claim, ledger, theory) + constants(theory.constants) +
                       theorem(name + "_refuted", theory, printed, exact, least);
    certificate.theorems = {
        {name + "_refuted", fmt::format("at one contact, |printed - exact| >= {}", least)}};
    if (const auto corrected = correction(result)) {
        certificate.text += theorem(name + "_corrected", theory, *corrected, exact, std::nullopt);
        certificate.theorems.push_back(
            {name + "_corrected", "at the same contact, |corrected - exact| <= 1e-12 |exact|"});
    }
    certificate.whole_verdict = true; // for which one contact suffices
    certificate.leaves_out = "that the correction holds for all contacts";
}

} // namespace edgeproof::certificate
