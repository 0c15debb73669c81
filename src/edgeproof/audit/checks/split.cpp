// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

constexpr unsigned split_digits = 18; // sufficient to measure an order

/// The expansion of the integrand up to the cut, term by term, minus the finite part of the whole
/// integral: the terms of the first part that contain the cut.
struct CutTerms {
    std::vector<ExpansionTerm> integrand; ///< as functions of the variable of integration
    std::vector<ExpansionTerm> whole;     ///< their finite parts from 0 to 1
};

CutTerms cut_terms(const formula::Expr& integrand, const std::string& variable,
                   const ExpansionIn& in, const SymbolicCase& under) {
    const formula::Expr whole =
        formula::Expr::call("integral", {integrand, formula::Expr::symbol(variable),
                                         formula::Expr::number(0), formula::Expr::number(1)});
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
                formula::Exact& size = smaller.variables.at(small_);
                size = formula::Exact(size.expr() / formula::Expr::number(Rational(shrink)));
                samples_.emplace_back(smaller, 8 * formula::bits_for(split_digits),
                                      2 * split_digits);
            }
        }
        const formula::Expr second = formula::Expr::call(
            "integral", {of_, formula::Expr::symbol(variable_), cut(), formula::Expr::number(1)});
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
    [[nodiscard]] formula::Expr cut() const {
        return formula::Expr::number(1) - formula::Expr::symbol("delta");
    }
    [[nodiscard]] Ball with_cut(const CutTerms& terms, std::size_t i) const {
        const auto power = [&](const Rational& k) {
            return samples_[i].evaluate(
                pow(formula::Expr::symbol(small_), formula::Expr::number(k)));
        };
        Ball sum(0, samples_[i].bits());
        for (const ExpansionTerm& term : terms.integrand) {
            const formula::Expr first =
                formula::Expr::call("integral", {term.coefficient, formula::Expr::symbol(variable_),
                                                 formula::Expr::number(0), cut()});
            sum += samples_[i].evaluate(first) * power(term.exponent);
        }
        for (const ExpansionTerm& term : terms.whole) {
            sum -= samples_[i].evaluate(term.coefficient) * power(term.exponent);
        }
        return sum;
    }

    std::string variable_;
    std::string small_;
    formula::Expr of_;
    std::vector<std::string> texts_;
    std::vector<EnclosedSample> samples_; ///< two for each text: the small variable, and a tenth
    std::vector<Ball> second_;            ///< the integrals from the cut to 1
};

} // namespace

/// Checks that the terms with the cut cancel between the two parts of an integral.
Outcome check_split(const Claim& claim, const AuditContext& context) {
    const SymbolicCase under = symbolic_case(claim, context);
    const ExpansionIn in{claim.text("small"), claim.edge(),
                         formula::Exact::parse(claim.text("through")).rational()};
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
    const auto hypothesis = [&](const formula::Expr& other) -> std::string {
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
