// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/comparison.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

bool symmetric_family(const Ledger& ledger, const Family& family) {
    if (!family.union_of.empty()) {
        return std::all_of(
            family.union_of.begin(), family.union_of.end(),
            [&](const std::string& f) { return symmetric_family(ledger, ledger.family(f)); });
    }
    return family.profile == "power-law" || family.profile == "flat-and-rounded" ||
           family.profile == "piecewise-symmetric";
}

/// printed/exact at all samples, recognised; its range goes into the evidence.
std::optional<formula::Expr> ratio_by_samples(const Agreement& agreement,
                                              const EvaluatedSamples& samples_at,
                                              Evidence& evidence) {
    std::vector<RatioSample> samples;
    const PrecisionScope scope(30);
    for (std::size_t i = 0; i < agreement.samples_at.size(); ++i) {
        const ValuePair* s = agreement.samples_at[i].values();
        if (s == nullptr || s->exact == 0) {
            continue;
        }
        const EvaluatedSample& sample_at = samples_at.all()[i];
        Variables parameters = sample_at.variables;
        for (const auto& [name, value] : sample_at.scene_values->spec().parameters) {
            parameters.emplace(name, sample_at.scene_values->parameter(name));
        }
        if (sample_at.scene_values->b() != sample_at.scene_values->a()) {
            parameters.emplace("b", sample_at.scene_values->b());
            parameters.emplace("L", sample_at.scene_values->length());
        }
        samples.push_back({std::move(parameters), at_working_precision(s->printed / s->exact)});
    }
    if (samples.empty()) {
        return std::nullopt;
    }
    const auto [least, most] = std::minmax_element(
        samples.begin(), samples.end(),
        [](const RatioSample& x, const RatioSample& y) { return x.ratio < y.ratio; });
    evidence.add("ratio_range", std::vector<std::string>{value_text(least->ratio, 12),
                                                         value_text(most->ratio, 12)});
    auto ratio = recognise_ratio(samples, 20);
    if (ratio) {
        ratio = substitute(*ratio, "L", formula::Expr::symbol("a") + formula::Expr::symbol("b"));
        evidence.add("ratio", to_text(*ratio));
        evidence.add("ratio_tex", to_tex(*ratio));
    }
    return ratio;
}

} // namespace

SymbolicCase symbolic_case(const Claim& claim, const AuditContext& context) {
    SymbolicCase under;
    under.symmetric =
        claim.has("over") &&
        symmetric_family(context.ledger(), context.ledger().family(claim.text("over")));
    if (claim.has("given")) {
        for (std::size_t i = 0; i < claim.table("given").size(); ++i) {
            const std::string& name = claim.table("given")[i].first;
            if (name != "P" && name != "b") {
                claim.reject("given", "given names " + name + ", which nothing follows from",
                             "write given = { P = \"...\", b = \"...\" }, formulas in a");
            }
            (name == "P" ? under.P : under.b) = claim.formulas("given")[i];
        }
    }
    return under;
}

void report_agreement(const Agreement& agreement, const EvaluatedSamples& samples_at,
                      unsigned digits, Evidence& evidence) {
    evidence.add("samples", samples_at.all().size()).add("scenes", samples_at.scenes());
    if (samples_at.left_out() > 0) {
        evidence.add("samples_left_out", samples_at.left_out());
    }
    if (agreement.samples_at.empty()) {
        return;
    }
    const SampleAgreement& worst = agreement.samples_at[agreement.worst];
    evidence.add("digits", digits_text(std::min(worst.digits(), static_cast<double>(digits))));
    evidence.add("worst_at", samples_at.all()[agreement.worst].text);
    const ValuePair* values = worst.values();
    if (values == nullptr) {
        evidence.add(worst.no_value() != nullptr ? "no_value" : "limit", worst.problem());
        return;
    }
    const unsigned shown = worst.digits() > 12 ? digits : 20;
    // What roundoff has left of a zero has no digit that is right.
    const auto text = [&](const Real& value) {
        return value != 0 && abs(value) <= values->error
                   ? "0 +- " + bound_text(values->error) + " (estimate)"
                   : value_text(value, shown);
    };
    evidence.add("printed_there", text(values->printed));
    evidence.add("exact_there", text(values->exact));
}

Judgement judge_samples(const Agreement& agreement, double needed) {
    if (agreement.to(needed)) {
        return NotRefuted::confirmed;
    }
    if (const auto difference = agreement.difference(needed)) {
        return Judgement(*difference);
    }
    return agreement.without_value() > 0 ? NotRefuted::underspecified : NotRefuted::undecided;
}

RefutedFormula refuted_by_samples(const Claim& claim, const Agreement& agreement,
                                  const EvaluatedSamples& samples_at, Evidence& evidence) {
    RefutedFormula refuted;
    refuted.printed = claim.written("says");
    refuted.exact = claim.written("of");
    refuted.alphabet = alphabet_for(claim, refuted.printed, claim.written("of"),
                                    &samples_at.all().front().sample.scene);
    refuted.ratio = ratio_by_samples(agreement, samples_at, evidence);
    return refuted;
}

QuickSamples::QuickSamples(const Claim& claim, const AuditContext& context,
                           const formula::Expr& exact)
    : claim_(claim),
      samples_at_(EvaluatedSamples::of(claim, context, digits, most_samples, Effort::screening)) {
    for (std::size_t i = 0; i < samples_at_->all().size(); ++i) {
        try {
            targets_.emplace_back(i, samples_at_->known(exact, i).value);
        } catch (const DomainError&) {
            continue;
        } catch (const BudgetError&) {
            continue;
        }
    }
}

bool QuickSamples::passes_screening(const formula::Expr& written) {
    if (targets_.empty()) {
        return false;
    }
    const formula::Expr e = expand_definitions(written, claim_.vocabulary);
    const PrecisionScope scope(digits + 10);
    const Real tolerance = pow(Real(10), -static_cast<int>(digits - 2));
    return std::all_of(targets_.begin(), targets_.end(), [&](const auto& target) {
        const auto& [i, exact] = target;
        const Real value = samples_at_->value(e, i).value;
        return abs(value - exact) <= tolerance * abs(exact);
    });
}

} // namespace edgeproof::audit
