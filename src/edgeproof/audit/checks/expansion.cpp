// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/decimal_fit.hpp"
#include "edgeproof/audit/checks/parts/residual_fit.hpp"
#include "edgeproof/audit/diagnosis/diagnosis.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <functional>
#include <memory>

namespace edgeproof::audit {
namespace {

constexpr int most_power = 20;

std::string power_text(const std::string& variable, const Rational& exponent) {
    return variable + "^(" + exponent.str() + ")";
}

std::vector<Evidence> terms_evidence(const ExpansionComparison& comparison,
                                     const std::string& variable) {
    std::vector<Evidence> list;
    for (const auto& term : comparison.terms) {
        Evidence e;
        e.update({{"power", power_text(variable, term.exponent)}, {"equal", term.equal}});
        if (!term.equal) {
            e["printed"] = to_text(term.printed);
        }
        e[term.equal ? "both" : "derived"] = to_text(term.derived);
        list.emplace_back(std::move(e));
    }
    return list;
}

/// The exact function minus the printed terms in real contacts: the least order over the samples,
/// measured by enclosures without a series.
struct Remainder {
    std::optional<Ball> order;
    std::string at;

    /// True if it is proved that the remainder is larger than the printed terms allow.
    [[nodiscard]] bool contradicts(const Rational& through) const {
        return order &&
               certainly_less(*order, Ball(through, order->bits()) + Ball(Rational(1, 4), 64));
    }
};

/// Returns the order of exact - printed, from a value of the variable to a thousandth of it; not
/// finite if the balls of the differences contain zero.
Ball order_of_rest(EnclosedSample& at, const Sample& sample, const Expr& printed, const Expr& exact,
                   const std::string& variable) {
    constexpr long decades = 14; // of u, which may be left out of `vary`
    const auto it = sample.variables.find(variable);
    const Ball far_at = it != sample.variables.end()
                            ? ball_of(it->second, at.bits())
                            : sample.scene.contact(at.bits())->reach(sample.edge) *
                                  pow_int(Ball(10, at.bits()), -decades);
    const auto left_over = [&](const Ball& value) {
        at.set(variable, value);
        if (variable == "u") {
            at.set_place(sample.edge, value);
        }
        return abs(at.evaluate(exact) - at.evaluate(printed));
    };
    const Ball far = left_over(far_at);
    const Ball near = left_over(far_at / 1000);
    return log(far / near) / log(Ball(1000, at.bits()));
}

Remainder measure_remainder(const Claim& claim, const std::vector<Sample>& samples,
                            const Expr& printed, const Expr& exact, const std::string& variable) {
    Remainder remainder;
    for (const Sample& sample : samples) {
        if (variable != "u" && !sample.variables.contains(variable)) {
            claim.reject("vary", "vary does not state where " + variable + " runs",
                         "write vary = { " + variable + " = [\"a*1e-14\"] }");
        }
        std::optional<Ball> order;
        SampleInBalls in_balls(sample, 30);
        static_cast<void>(in_balls.until([&](EnclosedSample& at) {
            const Ball found = order_of_rest(at, sample, printed, exact, variable);
            if (!found.is_finite() || found.radius() > Real(1) / 100) {
                return false;
            }
            order = found;
            return true;
        }));
        if (order && (!remainder.order || order->midpoint() < remainder.order->midpoint())) {
            remainder.order = order;
            remainder.at = sample.text();
        }
    }
    return remainder;
}

/// Every coefficient at every sample of the claim, by enclosures: the lowest power that differs
/// refutes. Equal powers of both expansions are compared in the contacts of the claim, where a
/// coefficient may vanish that does not vanish in general.
struct ComparedTerms {
    std::vector<Decision> decisions;
    const ExpansionComparison::Term* wrong = nullptr; ///< the first that is proved to differ
    std::string problem;
};

ComparedTerms compare_terms(const ExpansionComparison& comparison,
                            const std::vector<Sample>& samples, unsigned digits,
                            Evidence& evidence) {
    const double needed = AuditContext::digits_needed(digits);
    ComparedTerms found;
    for (const auto& term : comparison.terms) {
        for (const Sample& sample : samples) {
            if (term.equal) {
                continue;
            }
            // A part such as 1e-300 is a difference, too.
            const EnclosedSample first(sample, formula::bits_for(digits));
            const long spread = std::max(spread_of_parts(term.printed, first),
                                         spread_of_parts(term.derived, first));
            SampleInBalls in_balls(
                sample,
                digits + (spread > first.bits() ? static_cast<unsigned>(spread) * 3 / 10 : 0));
            Decision one;
            static_cast<void>(in_balls.until([&](const EnclosedSample& at) {
                const Ball x = at.evaluate(term.printed);
                const Ball y = at.evaluate(term.derived);
                const auto apart = Refutation::disjoint(x, y);
                if (apart) {
                    const std::string place = full_text(sample);
                    evidence["enclosures"] = pair_evidence(place, "printed_coefficient", x,
                                                           "derived_coefficient", y, digits);
                }
                const Ball scale =
                    scale_of_terms(term.printed, at) + scale_of_terms(term.derived, at);
                one = decision(apart, Confirmation::agreement(x, y, scale, needed));
                return !is_open(one);
            }));
            found.decisions.push_back(one);
            if (refutes(one)) {
                found.wrong = &term;
                return found;
            }
            if (is_open(one) && found.problem.empty()) {
                found.problem = in_balls.problem();
            }
        }
    }
    return found;
}

/// Tests candidates of the diagnosis at a few samples: true for a formula that leaves a remainder
/// of a higher order than `through`. Integrals would take too long.
std::function<bool(const Expr&)>
order_screening(const Claim& claim, const std::vector<Sample>& samples, const ExpansionIn& in) {
    constexpr std::size_t most = 2;
    constexpr long bits = 2000;
    auto contacts = std::make_shared<std::vector<std::pair<Sample, EnclosedSample>>>();
    for (std::size_t i = 0; i < std::min(samples.size(), most); ++i) {
        contacts->emplace_back(samples[i], EnclosedSample(samples[i], bits));
    }
    return [&claim, in, contacts](const Expr& written) {
        const Expr e = expand_definitions(written, claim.vocabulary);
        return !has_binder(e) && std::ranges::all_of(*contacts, [&](auto& contact) {
            auto& [sample, at] = contact;
            const Ball order = order_of_rest(at, sample, e, claim.formula("of"), in.variable);
            return !certainly_less(order, Ball(in.through, bits) + Ball(Rational(1, 4), bits));
        });
    };
}

/// Returns the slopes of log |p - printed terms| against log u after each printed term, as an
/// illustration of the orders; none if they are not enclosed.
std::vector<std::string> fitted_slopes(const Sample& sample, const ExpansionComparison& comparison,
                                       const Rational& through) {
    const auto count =
        static_cast<std::size_t>(numerator(Rational(through * 2 + 1)).convert_to<long>() / 2);
    const ResidualFitOptions options{.orders = count + 1, .digits = 20};
    std::vector<std::string> slopes;
    try {
        const auto contact = sample.scene.contact(options.bits());
        const EnclosedSample at(sample, options.bits());
        std::vector<Ball> c(count, Ball(0, options.bits()));
        for (const auto& term : comparison.terms) {
            if (denominator(term.exponent) == 1 && !(term.printed == Expr::number(0))) {
                return {}; // p has no such power
            }
            for (std::size_t n = 0; n < count; ++n) {
                if (term.exponent == Rational(static_cast<long>(2 * n + 1), 2)) {
                    c[n] = at.evaluate(term.printed);
                }
            }
        }
        for (const Real& slope :
             fit_residuals(*contact, sample.edge, options, std::move(c)).slopes) {
            slopes.push_back(to_decimal(slope, 8));
        }
    } catch (const Error&) {
        return {};
    }
    return slopes;
}

/// Judges a printed expansion with decimals: one equation for every coefficient at every sample.
Judgement judge_with_decimals(const PrintedFormula& printed, const Expr& exact,
                              const ExpansionIn& in, const SymbolicCase& under,
                              const std::vector<Sample>& samples, unsigned digits,
                              Outcome& outcome) {
    const unsigned fitted = std::min(digits, 100U);
    const long bits = formula::bits_for(2 * fitted + 30);
    std::vector<DecimalEquation> equations;
    for (const auto& term : compare_expansions(printed.named, exact, in, under).terms) {
        for (const Sample& sample : samples) {
            equations.push_back(
                equation_at(sample, bits, 20, term.printed, term.derived, {}, term.derived));
        }
    }
    return judge_decimals(printed, equations, fitted, bits, outcome);
}

} // namespace

Outcome check_expansion(const Claim& claim, const AuditContext& context) {
    const Expr printed = claim.formula("says");
    const Expr exact = claim.formula("of");
    const std::string variable = claim.text("variable");
    const SymbolicCase under = symbolic_case(claim, context);
    const ExpansionIn in{variable, claim.edge(), Exact::parse(claim.text("through")).rational()};
    if (abs(in.through) > most_power) {
        claim.reject("through", "expansions are computed through the power 20",
                     "give a smaller power");
    }
    Outcome outcome;
    outcome.evidence["of"] = claim.text("of");
    const ExpansionComparison comparison = compare_expansions(printed, exact, in, under);
    outcome.evidence["terms"] = terms_evidence(comparison, variable);

    const std::vector<Sample> samples = ClaimSamples(claim, context).all();
    if (samples.empty()) {
        outcome.note = "no sample fulfils the condition";
        return outcome;
    }
    const Remainder remainder = measure_remainder(claim, samples, printed, exact, variable);
    outcome.evidence["samples"] = samples.size();
    outcome.evidence["order_of_the_rest"] =
        remainder.order ? remainder.order->midpoint().str(6, std::ios_base::fixed)
                        : "not enclosed, or no rest";
    if (variable == "u" && claim.written("of") == Expr::call("p", {Expr::symbol("x")}) &&
        in.through > 0) {
        outcome.evidence["slopes"] = fitted_slopes(samples.front(), comparison, in.through);
    }
    if (comparison.equal()) {
        const bool contradicted = remainder.contradicts(in.through);
        outcome.verdict = contradicted ? Judgement() : Judgement::proved_by_symbols();
        outcome.note =
            contradicted      ? "equal in symbols, but the remainder is larger at " + remainder.at
            : remainder.order ? "equal power by power; the remainder has the order claimed"
                              : "equal power by power";
        return outcome;
    }
    const auto unequal =
        std::ranges::find(comparison.terms, false, &ExpansionComparison::Term::equal);
    outcome.wrong_coefficient = {power_text(variable, unequal->exponent), unequal->printed,
                                 unequal->derived};
    const PrintedFormula as_printed = printed_formula(claim);
    if (!as_printed.is_exact()) {
        outcome.verdict =
            judge_with_decimals(as_printed, exact, in, under, samples, context.digits(), outcome);
        return outcome;
    }
    const ComparedTerms compared =
        compare_terms(comparison, samples, context.digits(), outcome.evidence);
    outcome.verdict = Judgement::of_all(compared.decisions);
    if (compared.wrong == nullptr && outcome.verdict == Verdict::undecided &&
        compare_expansions(printed, exact, in, case_of_powers(claim, context)).equal()) {
        outcome.verdict = Judgement::proved_by_symbols();
        outcome.note = "equal power by power for this power of the slope";
        return outcome;
    }
    if (compared.wrong == nullptr) {
        outcome.note = outcome.verdict == Verdict::confirmed
                           ? "the coefficients agree at the samples; not proved in symbols"
                           : "not proved in symbols; " + compared.problem;
        return outcome;
    }
    const auto* wrong = compared.wrong;
    const std::string first = "departs at " + power_text(variable, wrong->exponent);
    outcome.evidence["first_departure"] = power_text(variable, wrong->exponent);
    if (!remainder.at.empty()) {
        outcome.evidence["worst_at"] = remainder.at;
    }
    Evidence hypotheses;
    for (const auto& [words, other] : named_formulas(claim, "as_if")) {
        const bool equal = compare_expansions(printed, other, in, under).equal();
        outcome.as_if.push_back({words, equal});
        hypotheses[words] = outcome.as_if.back().text();
    }
    if (!hypotheses.empty()) {
        outcome.evidence["as_if"] = std::move(hypotheses);
    }
    RefutedFormula refuted;
    refuted.printed = claim.written("says");
    refuted.exact = claim.written("of");
    refuted.alphabet = alphabet_for(claim, refuted.printed, exact);
    std::erase(refuted.alphabet.symbols, variable);
    refuted.derived = comparison.derived(variable);
    if (wrong->derived == Expr::number(0)) {
        // An edit that moves a term beyond `through` is no correction: the derived form is given.
        refuted.passes_screening = [](const Expr&) { return false; };
    } else {
        refuted.passes_screening = order_screening(claim, samples, in);
    }
    refuted.is_right = [&](const Expr& e) {
        return compare_expansions(expand_definitions(e, claim.vocabulary), exact, in, under)
            .equal();
    };
    diagnose(refuted, outcome);
    outcome.note = first + "; " + outcome.note;
    return outcome;
}

} // namespace edgeproof::audit
