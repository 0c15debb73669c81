// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/checks/parts/decimal_fit.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/audit/sample/formal_values.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::audit {
namespace {

constexpr std::size_t formal_draws = 3;

/// Returns the names in two formulas, and the derivatives in the expansions of contact functions.
std::set<std::string> names_of(const Expr& x, const Expr& y) {
    std::set<std::string> names = free_symbols(x);
    names.merge(free_symbols(y));
    for (unsigned k = 1; k <= 9; ++k) {
        names.insert("P" + std::to_string(k));
        names.insert("b" + std::to_string(k));
    }
    return names;
}

std::string power_text(const std::string& variable, const Rational& exponent) {
    return variable + "^(" + exponent.str() + ")";
}

std::vector<EvidenceItem> terms_evidence(const ExpansionComparison& comparison,
                                         const std::string& variable) {
    std::vector<EvidenceItem> list;
    for (const auto& term : comparison.terms) {
        Evidence e;
        e.add("power", power_text(variable, term.exponent)).add("equal", term.equal);
        if (!term.equal) {
            e.add("printed", to_text(term.printed));
        }
        e.add(term.equal ? "both" : "derived", to_text(term.derived));
        list.emplace_back(std::move(e));
    }
    return list;
}

/// The exact function minus the printed terms in real contacts: the least order over the samples,
/// measured by enclosures without a series.
struct Remainder {
    std::optional<Ball> order;
    std::string at;
    std::size_t samples = 0;

    /// True if it is proved that the remainder is larger than the printed terms allow.
    [[nodiscard]] bool contradicts(const Rational& through) const {
        return order &&
               certainly_less(*order, Ball(through, order->bits()) + Ball(Rational(1, 4), 64));
    }
};

Remainder measure_remainder(const Claim& claim, const std::vector<Sample>& samples,
                            const Expr& printed, const Expr& exact, const std::string& variable) {
    Remainder remainder;
    for (const Sample& sample : samples) {
        const auto it = sample.variables.find(variable);
        if (it == sample.variables.end()) {
            claim.reject("vary", "vary does not state where " + variable + " runs",
                         "write vary = { " + variable + " = [\"a*1e-14\"] }");
        }
        ++remainder.samples;
        std::optional<Ball> order;
        SampleInBalls in_balls(sample, 30);
        static_cast<void>(in_balls.until([&](EnclosedSample& at) {
            const Ball far_at = ball_of(it->second, at.bits());
            const auto left_over = [&](const Ball& value) {
                at.set(variable, value);
                if (variable == "u") {
                    at.set_place(sample.edge, value);
                }
                return abs(at.evaluate(exact) - at.evaluate(printed));
            };
            const Ball far = left_over(far_at);
            const Ball near = left_over(far_at / 1000);
            const Ball found = log(far / near) / log(Ball(1000, at.bits()));
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
            SampleInBalls in_balls(sample, digits);
            Decision one;
            static_cast<void>(in_balls.until([&](const EnclosedSample& at) {
                const Ball x = at.evaluate(term.printed);
                const Ball y = at.evaluate(term.derived);
                const auto apart = Refutation::disjoint(x, y);
                if (apart) {
                    const std::string place = full_text(sample);
                    evidence.add("enclosures", pair_evidence(place, "printed_coefficient", x,
                                                             "derived_coefficient", y, digits));
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

/// Tests candidates of the diagnosis in numbers: the variable is 1e-30, so that a correct formula
/// leaves the next power of it, and a wrong one the power where it differs.
Screening formal_expansion_screening(const Claim& claim, const ExpansionIn& in,
                                     const ExpansionComparison& comparison,
                                     const std::set<std::string>& names,
                                     const SymbolicCase& under) {
    constexpr unsigned decades = 30;
    const Rational span = in.through - comparison.terms.front().exponent;
    const auto power = static_cast<unsigned>(ceil(span.convert_to<double>()));
    const unsigned digits = decades * (power + 1) + 40;
    const PrecisionScope scope(digits);
    const Real small = pow(Real(10), -static_cast<int>(decades));
    Screening screening(claim, digits,
                        pow(small, from_rational<Real>(Rational(span + Rational(1, 4)))));
    for (std::size_t k = 0; k < formal_draws; ++k) {
        FormalValues values(names, under, k, digits);
        values.set(in.variable, small);
        Real exact(0);
        try {
            for (const auto& term : comparison.terms) {
                exact +=
                    values.evaluate(term.derived) * pow(small, from_rational<Real>(term.exponent));
            }
        } catch (const DomainError&) {
            continue; // a drawn point outside the domain of a root
        }
        screening.add_point([values](const Expr& e) { return values.evaluate(e); }, exact);
    }
    return screening;
}

/// Judges a printed expansion with decimals: one equation for every coefficient at every sample.
Judgement judge_with_decimals(const DecimalFormula& printed, const Expr& exact,
                              const ExpansionIn& in, const SymbolicCase& under,
                              const std::vector<Sample>& samples, unsigned digits,
                              Outcome& outcome) {
    const unsigned fitted = std::min(digits, 100U);
    const long bits = formula::bits_for(2 * fitted + 30);
    std::vector<DecimalEquation> equations;
    for (const auto& term : compare_expansions(printed.expr(), exact, in, under).terms) {
        for (const Sample& sample : samples) {
            const auto at = std::make_shared<EnclosedSample>(sample, bits);
            const Ball target = at->evaluate(term.derived);
            equations.push_back(equation_at(
                at, term.printed, target,
                contains_zero(target) ? scale_of_terms(term.derived, *at) : abs(target)));
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
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"));
    const ExpansionComparison comparison = compare_expansions(printed, exact, in, under);
    outcome.evidence.add("terms", terms_evidence(comparison, variable));

    const std::vector<Sample> samples = context.samples(claim);
    const Remainder remainder = measure_remainder(claim, samples, printed, exact, variable);
    outcome.evidence.add("samples", remainder.samples);
    outcome.evidence.add("order_of_the_rest",
                         remainder.order ? remainder.order->midpoint().str(6, std::ios_base::fixed)
                                         : "no rest");
    if (comparison.equal()) {
        const bool contradicted = remainder.contradicts(in.through);
        outcome.verdict = contradicted ? Judgement() : Judgement::proved_by_symbols();
        outcome.note = contradicted
                           ? "equal in symbols, but the remainder is larger at " + remainder.at
                           : "equal power by power; the remainder has the order claimed";
        return outcome;
    }
    const PrintedFormula as_printed = printed_formula(claim);
    if (const auto* with_decimals = std::get_if<DecimalFormula>(&as_printed)) {
        outcome.verdict = judge_with_decimals(*with_decimals, exact, in, under, samples,
                                              context.digits(), outcome);
        return outcome;
    }
    const ComparedTerms compared =
        compare_terms(comparison, samples, context.digits(), outcome.evidence);
    outcome.verdict = Judgement::of_all(compared.decisions);
    if (compared.wrong == nullptr) {
        outcome.note = outcome.verdict == Verdict::confirmed
                           ? "the coefficients agree at the samples; not proved in symbols"
                           : "not proved in symbols; " + compared.problem;
        return outcome;
    }
    const auto* wrong = compared.wrong;
    const std::string first = "departs at " + power_text(variable, wrong->exponent);
    outcome.evidence.add("first_departure", power_text(variable, wrong->exponent));
    if (!remainder.at.empty()) {
        outcome.evidence.add("worst_at", remainder.at);
    }
    add_hypotheses(
        claim,
        [&](const Expr& other) {
            return compare_expansions(printed, other, in, under).equal()
                       ? "gives the printed line"
                       : "does not give the printed line";
        },
        outcome.evidence);
    RefutedFormula refuted;
    refuted.printed = claim.written("says");
    refuted.exact = claim.written("of");
    refuted.alphabet = alphabet_for(claim, refuted.printed, exact);
    std::erase(refuted.alphabet.symbols, variable);
    std::vector<ExpansionTerm> derived;
    for (const auto& term : comparison.terms) {
        derived.push_back({term.exponent, term.derived});
    }
    refuted.derived = sum_of(derived, variable);
    refuted.passes_screening =
        formal_expansion_screening(claim, in, comparison, names_of(printed, exact), under);
    refuted.verdict_of = [&](const Expr& e) -> std::optional<Verdict> {
        return compare_expansions(expand_definitions(e, claim.vocabulary), exact, in, under).equal()
                   ? Verdict::proved
                   : Verdict::refuted;
    };
    diagnose(refuted, outcome);
    outcome.note = first + "; " + outcome.note;
    return outcome;
}

} // namespace edgeproof::audit
