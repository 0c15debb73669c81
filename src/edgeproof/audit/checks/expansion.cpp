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

namespace {

constexpr unsigned split_digits = 18; // sufficient to measure an order

/// The expansion of the integrand up to the cut, term by term, minus the finite part of the whole
/// integral: the terms of the first part that contain the cut.
struct CutTerms {
    std::vector<ExpansionTerm> integrand; ///< as functions of the variable of integration
    std::vector<ExpansionTerm> whole;     ///< their finite parts from 0 to 1
};

CutTerms cut_terms(const Expr& integrand, const std::string& variable, const ExpansionIn& in,
                   const SymbolicCase& under) {
    const Expr whole = Expr::call(
        "integral", {integrand, Expr::symbol(variable), Expr::number(0), Expr::number(1)});
    return {expand(integrand, in, under), expand(whole, in, under)};
}

/// The order, in the small variable, of the sum of the second part (from the cut to 1) and the
/// terms of the first part that contain the cut, in balls.
struct Left {
    std::vector<Ball> orders; ///< at each sample
    std::size_t worst = 0;    ///< the sample with the least order
    [[nodiscard]] const Ball& least() const { return orders[worst]; }
};

std::string order_text(const Ball& order, int places) {
    return order.midpoint().str(places, std::ios_base::fixed);
}

class Splitting {
public:
    Splitting(const Claim& claim, const AuditContext& context)
        : variable_(claim.text("variable")), small_(claim.text("small")), of_(claim.formula("of")) {
        for (const Sample& sample : context.samples(claim)) {
            texts_.push_back(sample.text());
            for (const int shrink : {1, 10}) {
                Sample smaller = sample;
                Exact& size = smaller.variables.at(small_);
                size = Exact(size.expr() / Expr::number(Rational(shrink)));
                samples_.emplace_back(smaller, 8 * formula::bits_for(split_digits),
                                      2 * split_digits);
            }
        }
        const Expr second =
            Expr::call("integral", {of_, Expr::symbol(variable_), cut(), Expr::number(1)});
        for (const EnclosedSample& sample : samples_) {
            second_.push_back(sample.evaluate(second));
        }
    }

    [[nodiscard]] Left left(const CutTerms& terms) const {
        Left found;
        for (std::size_t i = 0; i < texts_.size(); ++i) {
            const Ball far = abs(second_[2 * i] + with_cut(terms, 2 * i));
            const Ball near = abs(second_[2 * i + 1] + with_cut(terms, 2 * i + 1));
            found.orders.push_back(log(far / near) / log(Ball(10, far.bits())));
            if (!found.orders.back().is_finite()) {
                throw BudgetError("the remainder is not enclosed at " + texts_[i]);
            }
            if (found.orders.back().midpoint() < found.least().midpoint()) {
                found.worst = i;
            }
        }
        return found;
    }
    [[nodiscard]] std::size_t samples() const { return texts_.size(); }
    [[nodiscard]] const std::string& text(std::size_t sample) const { return texts_[sample]; }

private:
    [[nodiscard]] Expr cut() const { return Expr::number(1) - Expr::symbol("delta"); }
    [[nodiscard]] Ball with_cut(const CutTerms& terms, std::size_t i) const {
        const auto power = [&](const Rational& k) {
            return samples_[i].evaluate(pow(Expr::symbol(small_), Expr::number(k)));
        };
        Ball sum(0, samples_[i].bits());
        for (const ExpansionTerm& term : terms.integrand) {
            const Expr first = Expr::call(
                "integral", {term.coefficient, Expr::symbol(variable_), Expr::number(0), cut()});
            sum += samples_[i].evaluate(first) * power(term.exponent);
        }
        for (const ExpansionTerm& term : terms.whole) {
            sum -= samples_[i].evaluate(term.coefficient) * power(term.exponent);
        }
        return sum;
    }

    std::string variable_;
    std::string small_;
    Expr of_;
    std::vector<std::string> texts_;
    std::vector<EnclosedSample> samples_; ///< two for each text: the small variable, and a tenth
    std::vector<Ball> second_;            ///< the integrals from the cut to 1
};

} // namespace

Outcome check_split(const Claim& claim, const AuditContext& context) {
    const SymbolicCase under = symbolic_case(claim, context);
    const ExpansionIn in{claim.text("small"), claim.edge(),
                         Exact::parse(claim.text("through")).rational()};
    const std::string variable = claim.text("variable");
    const Splitting splitting(claim, context);
    const Left left = splitting.left(cut_terms(claim.formula("of"), variable, in, under));
    const Rational cancelled = in.through + Rational(4, 5);
    const Rational not_cancelled = in.through + Rational(1, 5);
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("through", claim.text("small") + "^(" + claim.text("through") + ")")
        .add("samples", splitting.samples())
        .add("order_of_what_is_left", order_text(left.least(), 3))
        .add("worst_at", splitting.text(left.worst));
    const auto hypothesis = [&](const Expr& other) -> std::string {
        try {
            const Left with = splitting.left(cut_terms(other, variable, in, under));
            const Ball& order = with.least();
            return "the remainder is of order " + order_text(order, 3) + ": " +
                   (certainly_less(Ball(cancelled, order.bits()), order) ? "the terms cancel"
                                                                         : "they do not cancel");
        } catch (const DomainError&) {
            return "its terms are not integrable up to 1: those of the cut grow without bound, "
                   "and the second part is bounded and cannot cancel them";
        }
    };
    add_hypotheses(claim, hypothesis, outcome.evidence);
    std::vector<Decision> decisions;
    for (const Ball& order : left.orders) {
        const auto ball = [&](const Rational& q) { return Ball(q, order.bits()); };
        decisions.push_back(decision(Refutation::less(order, ball(not_cancelled)),
                                     Confirmation::less(ball(cancelled), order)));
    }
    outcome.verdict = Judgement::of_all(decisions);
    const std::string order = order_text(left.least(), 2);
    outcome.note = outcome.verdict == Verdict::confirmed
                       ? "they cancel through " + claim.text("small") + "^(" +
                             claim.text("through") + "); the remainder is of order " + order
                   : outcome.verdict == Verdict::refuted
                       ? "terms of order " + order + " are left"
                       : "the remainder is of order " + order + ", which does not decide";
    return outcome;
}

} // namespace edgeproof::audit
