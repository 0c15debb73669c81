// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/statement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgeproof::certificate {
namespace {

using formula::Expr;

/// What agreement is stated to.
constexpr std::string_view agreement = "1 / 10 ^ 12";

/// |printed - exact| at a sample, as far as the enclosures have it, and beside the larger of both.
struct Gap {
    double least = 0;
    double relative = 0;
};

std::optional<Gap> gap_at(const Expr& printed, const Expr& exact, const audit::Sample& sample) {
    const auto x = audit::enclosed(printed, sample, 25);
    const auto y = audit::enclosed(exact, sample, 25);
    if (!x.ball || !y.ball) {
        return std::nullopt;
    }
    const Ball difference = abs(*x.ball - *y.ball);
    const double size = std::max(std::abs(static_cast<double>(x.ball->midpoint())),
                                 std::abs(static_cast<double>(y.ball->midpoint())));
    const auto least = static_cast<double>(difference.lower());
    return Gap{least, size > 0 ? least / size : 0};
}

/// "253 / 1000": three digits, a little below.
std::string fraction_below(double gap) {
    const double lowered = gap * (1 - 1e-6);
    const int places = std::max(0, 2 - static_cast<int>(std::floor(std::log10(lowered))));
    const double count = std::floor(lowered * std::pow(10.0, places));
    return places == 0 ? fmt::format("{:.0f}", count)
                       : fmt::format("{:.0f} / 10 ^ {}", count, places);
}

/// `least <= Rabs (...)` or `Rabs (...) <= most`, with its proof.
std::string theorem(const std::string& name, const Theory& theory, const Expr& formula,
                    const Expr& exact, const std::optional<std::string>& least) {
    Statement statement(theory);
    const std::string difference =
        fmt::format("Rabs (({}) - ({}))", statement(formula), statement(exact));
    const std::string conclusion = least ? fmt::format("{} <= {}", *least, difference)
                                         : fmt::format("{} <= {}", difference, agreement);
    return fmt::format("Theorem {} : {}.\nProof.\n{}Qed.\nPrint Assumptions {}.\n\n", name,
                       statement.text(conclusion),
                       statement.proof(fmt::format("unfold {}; numbers constants", theory.unfold)),
                       name);
}

std::string constants(const Theory& theory) {
    std::string text;
    std::string names;
    for (const auto& [name, value] : theory.constants) {
        text += fmt::format("Definition {} : R := {}.\n", name, value);
        names += (names.empty() ? "" : ", ") + name;
    }
    return text + fmt::format("Ltac constants := unfold {} in *.\n"
                              "Ltac positive := constants; repeat split; lra.\n\n",
                              names);
}

std::optional<Expr> correction(const audit::ClaimResult& result) {
    if (!result.outcome.correct) {
        return std::nullopt;
    }
    try {
        return expand_definitions(parse_formula(*result.outcome.correct, result.claim.vocabulary),
                                  result.claim.vocabulary);
    } catch (const Error&) {
        return std::nullopt; // a correction in words
    }
}

/// The sample at which the two differ most, beside their size.
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
    if (claim.has("vary") || claim.has("with") || !claim.readings.empty()) {
        throw NotStated("variables of its own and several readings are not stated in Coq");
    }
    const Expr printed = claim.formula("says");
    const Expr exact = claim.formula("of");
    std::vector<SampledTheory> theories;
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
        certificate.text = file_head(claim, ledger, theory) + constants(theory) +
                           theorem(name + "_agrees", theory, printed, exact, std::nullopt);
        certificate.theorems = {{name + "_agrees", "at one contact, |printed - exact| <= 1e-12"}};
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
    certificate.text = file_head(claim, ledger, theory) + constants(theory) +
                       theorem(name + "_refuted", theory, printed, exact, least);
    certificate.theorems = {
        {name + "_refuted", fmt::format("at one contact, |printed - exact| >= {}", least)}};
    if (const auto corrected = correction(result)) {
        certificate.text += theorem(name + "_corrected", theory, *corrected, exact, std::nullopt);
        certificate.theorems.push_back(
            {name + "_corrected", "at the same contact, |corrected - exact| <= 1e-12"});
    }
    certificate.leaves_out = "that the correction holds for all contacts";
}

} // namespace edgeproof::certificate
