// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace edgeproof::audit {
namespace {

constexpr unsigned split_digits = 18; // orders are measured: more would show nothing more

/// An expansion of the integrand, term by term up to the cut, less the finite part of the whole
/// integral: the terms of the first part that name the cut.
struct CutTerms {
    std::vector<ExpansionTerm> integrand; ///< in the variable of integration
    std::vector<ExpansionTerm> whole;     ///< their finite parts from 0 to 1
};

CutTerms cut_terms(const formula::Expr& integrand, const std::string& variable,
                   const ExpansionIn& in, const SymbolicCase& under) {
    const formula::Expr whole =
        formula::Expr::call("integral", {integrand, formula::Expr::symbol(variable),
                                         formula::Expr::number(0), formula::Expr::number(1)});
    return {expand(integrand, in, under), expand(whole, in, under)};
}

/// The order in the small variable of what is left when the second part, from the cut to 1, and
/// the terms of the first that name the cut are put together.
struct Left {
    double order = 0;
    std::string at;
};

class Splitting {
public:
    Splitting(const Claim& claim, const AuditContext& context)
        : variable_(claim.text("variable")), small_(claim.text("small")), of_(claim.formula("of")) {
        for (const Sample& sample : context.samples(claim)) {
            scene_values_.emplace_back(sample.scene, split_digits);
            texts_.push_back(sample.text());
            variables_.push_back(scene_values_.back().values_of(sample.variables));
        }
        for (std::size_t i = 0; i < scene_values_.size(); ++i) {
            for (const int shrink : {1, 10}) {
                second_.push_back(second_part(i, shrink));
            }
        }
    }

    [[nodiscard]] Left left(const CutTerms& terms) const {
        const PrecisionScope scope(split_digits + 20);
        Left worst{1e9, {}};
        for (std::size_t i = 0; i < scene_values_.size(); ++i) {
            const Real far = abs(Real(second_[2 * i] + with_cut(terms, i, 1)));
            const Real near = abs(Real(second_[2 * i + 1] + with_cut(terms, i, 10)));
            const double order = Real(log10(Real(far / near))).convert_to<double>();
            if (order < worst.order) {
                worst = {order, texts_[i]};
            }
        }
        return worst;
    }
    [[nodiscard]] std::size_t samples() const { return scene_values_.size(); }

private:
    [[nodiscard]] Variables at(std::size_t i, int shrink) const {
        Variables v = variables_[i];
        const PrecisionScope scope(split_digits + 20);
        v.at(small_) /= shrink;
        return v;
    }
    [[nodiscard]] formula::Expr cut() const {
        return formula::Expr::number(1) - formula::Expr::symbol("delta");
    }
    /// The integral from the cut to 1, as it stands.
    [[nodiscard]] Real second_part(std::size_t i, int shrink) const {
        const formula::Expr e = formula::Expr::call(
            "integral", {of_, formula::Expr::symbol(variable_), cut(), formula::Expr::number(1)});
        const FormulaValue value = scene_values_[i].evaluate(e, nullptr, at(i, shrink));
        if (!value.converged) {
            throw BudgetError("the integral from the cut to 1 did not converge");
        }
        return value.value;
    }
    [[nodiscard]] Real with_cut(const CutTerms& terms, std::size_t i, int shrink) const {
        const PrecisionScope scope(split_digits + 20);
        const Variables v = at(i, shrink);
        const auto power = [&](const Rational& k) {
            return Real(pow(v.at(small_), from_rational<Real>(k)));
        };
        Real sum(0);
        for (const ExpansionTerm& term : terms.integrand) {
            const formula::Expr first =
                formula::Expr::call("integral", {term.coefficient, formula::Expr::symbol(variable_),
                                                 formula::Expr::number(0), cut()});
            sum += scene_values_[i].evaluate(first, nullptr, v).value * power(term.exponent);
        }
        for (const ExpansionTerm& term : terms.whole) {
            sum -= scene_values_[i].evaluate(term.coefficient, nullptr, v).value *
                   power(term.exponent);
        }
        return sum;
    }

    std::string variable_;
    std::string small_;
    formula::Expr of_;
    std::vector<EvaluatedScene> scene_values_;
    std::vector<std::string> texts_;
    std::vector<Variables> variables_;
    std::vector<Real> second_;
};

/// That the terms of a cut cancel between the two parts of an integral.
Outcome check_split(const Claim& claim, const AuditContext& context) {
    const SymbolicCase under = symbolic_case(claim, context);
    const contact::Edge edge = claim.edge();
    const ExpansionIn in{claim.text("small"), edge,
                         formula::Exact::parse(claim.text("through")).rational()};
    const std::string variable = claim.text("variable");
    const Splitting splitting(claim, context);
    const Left left = splitting.left(cut_terms(claim.formula("of"), variable, in, under));
    const double through = in.through.convert_to<double>();
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("through", claim.text("small") + "^(" + claim.text("through") + ")")
        .add("samples", splitting.samples())
        .add("order_of_what_is_left", fmt::format("{:.3f}", left.order))
        .add("worst_at", left.at);
    if (claim.has("as_if")) {
        Evidence hypotheses;
        for (std::size_t i = 0; i < claim.table("as_if").size(); ++i) {
            const std::string& text = claim.table("as_if")[i].first;
            const formula::Expr& other = claim.formulas("as_if")[i];
            std::string found;
            try {
                const Left with = splitting.left(cut_terms(other, variable, in, under));
                found = fmt::format("what is left is of order {:.3f}: {}", with.order,
                                    with.order > through + 0.8 ? "the terms cancel"
                                                               : "they do not cancel");
            } catch (const DomainError&) {
                found = "its terms are not integrable up to 1: those of the cut grow without "
                        "bound, and the second part, which does not, cannot cancel them";
            }
            hypotheses.add(text, found);
        }
        outcome.evidence.add("as_if", std::move(hypotheses));
    }
    const std::string order = fmt::format("{:.2f}", left.order);
    if (left.order > through + 0.8) {
        outcome.verdict = NotRefuted::confirmed;
        outcome.note = "they cancel through " + claim.text("small") + "^(" + claim.text("through") +
                       "); what is left is of order " + order;
    } else if (left.order < through + 0.2) {
        outcome.verdict = Judgement(Difference::of(Real(through), Real(left.order), Real("0.2")));
        outcome.note = "terms of order " + order + " are left";
    } else {
        outcome.note = "what is left is of order " + order + ", which does not decide";
    }
    return outcome;
}

} // namespace

CheckKind split_kind() {
    using Type = KeySpec::Type;
    return {"split",
            {required_formula("of"),
             {.name = "variable", .required = true},
             {.name = "small", .required = true},
             {.name = "through", .type = Type::number, .required = true},
             {.name = "as_if", .type = Type::formula_table},
             {.name = "given", .type = Type::formula_table}},
            check_split};
}

} // namespace edgeproof::audit
