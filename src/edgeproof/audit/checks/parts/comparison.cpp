// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/comparison.hpp"

#include "edgeproof/audit/checks/parts/decimal_fit.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
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

/// Recognises printed/exact from all samples, and adds its range to the evidence.
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
                claim.reject("given", "given contains " + name + ", from which nothing is derived",
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
    // If only roundoff is left of a zero, no digit is right.
    const auto text = [&](const Real& value) {
        return value != 0 && abs(value) <= values->error
                   ? "0 +- " + bound_text(values->error) + " (estimate)"
                   : value_text(value, shown);
    };
    evidence.add("printed_there", text(values->printed));
    evidence.add("exact_there", text(values->exact));
}

namespace {

constexpr unsigned most_fitted_digits = 100; ///< for numbers in place of decimals
constexpr std::size_t most_with_integrals = 8;

/// Returns one equation for each sample; none if a sample has no enclosure.
std::vector<DecimalEquation> equations_at(const DecimalFormula& printed,
                                          const EvaluatedSamples& samples_at,
                                          const formula::Expr& exact,
                                          const std::optional<formula::Expr>& scale, long bits,
                                          unsigned digits) {
    std::size_t most = samples_at.all().size();
    if (has_binder(printed.expr()) || has_binder(exact)) {
        most = std::min(most, most_with_integrals);
    }
    std::vector<DecimalEquation> equations;
    std::vector<std::size_t> order = spread_first(samples_at.all().size(), most);
    order.resize(most);
    for (const std::size_t i : order) {
        const auto sample =
            std::make_shared<EnclosedSample>(samples_at.all()[i].sample, bits, digits + 15);
        const Ball target = sample->evaluate(exact);
        const Ball size = scale                   ? abs(sample->evaluate(*scale))
                          : contains_zero(target) ? scale_of_terms(printed.as_printed(), *sample)
                                                  : abs(target);
        equations.push_back({[sample, e = printed.expr()](const Decimals& numbers) {
                                 for (std::size_t k = 0; k < numbers.size(); ++k) {
                                     sample->set(DecimalFormula::name_of_decimal(k), numbers[k]);
                                 }
                                 return sample->evaluate(e);
                             },
                             target, size});
    }
    return equations;
}

Judgement judge_fit(const DecimalFormula& printed, const EvaluatedSamples& samples_at,
                    const formula::Expr& exact, const std::optional<formula::Expr>& scale,
                    unsigned digits, Outcome& outcome) {
    const unsigned fitted = std::min(digits, most_fitted_digits);
    const long bits = formula::bits_for(2 * fitted + 30);
    try {
        const auto equations = equations_at(printed, samples_at, exact, scale, bits, fitted);
        const std::size_t comparisons = equations.size();
        const DecimalFit fit(printed.decimals(), equations, AuditContext::digits_needed(fitted),
                             bits);
        return judge_decimals(
            printed.decimals(), fit,
            [&](const std::vector<Real>& numbers) { return printed.text_with(numbers); },
            comparisons, fitted, outcome);
    } catch (const Error& error) {
        outcome.note = std::string("no enclosure: ") + error.what();
        return {};
    }
}

} // namespace

Judgement judge_formula(const Claim& claim, EvaluatedSamples& samples_at,
                        const Agreement& agreement, const formula::Expr& exact,
                        const std::optional<formula::Expr>& scale, unsigned digits,
                        Outcome& outcome) {
    const PrintedFormula printed = printed_formula(claim);
    if (const auto* with_decimals = std::get_if<DecimalFormula>(&printed)) {
        Outcome as_printed;
        const Decision found = compare_by_enclosures(
            agreement, samples_at, {with_decimals->as_printed(), exact, scale}, digits, as_printed);
        if (const auto* holds = std::get_if<Confirmation>(&found)) {
            outcome.evidence.add("enclosures", *as_printed.evidence.find("enclosures"));
            return Judgement(*holds);
        }
        return judge_fit(*with_decimals, samples_at, exact, scale, digits, outcome);
    }
    return judge_by_enclosures(agreement, samples_at, std::get<ExactFormula>(printed), exact, scale,
                               digits, outcome);
}

bool confirmed_at_samples(EvaluatedSamples& samples_at, const formula::Expr& made,
                          const formula::Expr& exact, const std::optional<formula::Expr>& scale,
                          unsigned digits) {
    Outcome ignored;
    const Agreement agreement = samples_at.compare(made, exact, scale);
    return agreement.to(AuditContext::digits_needed(digits)) &&
           confirms(
               compare_by_enclosures(agreement, samples_at, {made, exact, scale}, digits, ignored));
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
