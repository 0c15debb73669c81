// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/evaluated_scene_state.hpp"
#include "edgeproof/formula/evaluation/environment.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"

#include <algorithm>
#include <concepts>
#include <functional>

namespace edgeproof::audit {

/// The formula environment of an EvaluatedScene: names, functions along the family of contacts, and
/// integrals evaluated as printed.
class EvaluatedSceneEnvironment {
public:
    EvaluatedSceneEnvironment(EvaluatedSceneState& state, const Place* place,
                              const Variables& variables, IntegralCache* cache)
        : state_(state), place_(place), variables_(variables), cache_(cache) {}

    [[nodiscard]] Real number(const Rational& q) const { return formula::number_of<Real>(q); }
    [[nodiscard]] Real pi() const { return edgeproof::pi<Real>(); }
    [[nodiscard]] Real symbol(std::string_view name) const;
    [[nodiscard]] Real call(const formula::Expr& node, std::span<const Real> args) const {
        return state_.call(node.name(), args, place_);
    }
    template <class Scope>
    [[nodiscard]] Real binder(const formula::Expr& node, const Scope& scope) const {
        if (node.kind() == formula::Expr::Kind::sum) {
            return evaluate_sum<Real>(node, scope);
        }
        // An integral inside another depends on more than its own text.
        constexpr bool outermost = std::same_as<Scope, EvaluatedSceneEnvironment>;
        if (outermost && cache_ != nullptr) {
            if (const auto it = cache_->find(node); it != cache_->end()) {
                return take(it->second);
            }
        }
        const std::string& name = node.arg(1).name();
        const Real lo = evaluate<Real>(node.arg(2), scope);
        const Real hi = evaluate<Real>(node.arg(3), scope);
        const auto along = [&](const formula::Expr& e) {
            return [&](const Real& s) {
                return evaluate<Real>(e, formula::with_symbol(scope, name, s));
            };
        };
        std::vector<Real> cuts = places(lo, hi);
        collect_cuts(
            node.arg(0), name, lo, hi,
            [&](const formula::Expr& e, const Real& s) { return along(e)(s); }, cuts);
        NaivePrecision precision = state_.precision;
        precision.roots =
            !called_functions(node.arg(0)).contains("p"); // p has logarithms at the knots
        const NaiveIntegral result =
            node.kind() == formula::Expr::Kind::pv
                ? principal_value_naively(along(node.arg(0)), lo, hi,
                                          evaluate<Real>(node.arg(4), scope), std::move(cuts),
                                          std::move(precision))
                : integrate_naively(along(node.arg(0)), lo, hi, std::move(cuts),
                                    std::move(precision));
        const FormulaValue value{result.value, result.estimate, result.converged, 0};
        if (outermost && cache_ != nullptr) {
            cache_->emplace(node, value);
        }
        return take(value);
    }

    [[nodiscard]] const Real& worst_estimate() const noexcept { return worst_; }
    [[nodiscard]] bool converged() const noexcept { return converged_; }

private:
    Real take(const FormulaValue& integral) const {
        worst_ = std::max(worst_, integral.estimate);
        converged_ = converged_ && integral.converged;
        return integral.value;
    }

    using At = std::function<Real(const formula::Expr&, const Real&)>;
    /// Returns places where printed integrands have their branch points. Those inside an interval
    /// are not cuts; those outside show that a branch point is near an end.
    [[nodiscard]] std::vector<Real> places(const Real& lo, const Real& hi) const;
    /// Collects the values of the bound variable at which a function in f is not analytic.
    void collect_cuts(const formula::Expr& f, const std::string& variable, const Real& lo,
                      const Real& hi, const At& at, std::vector<Real>& cuts) const;
    static void add_preimage(const std::function<Real(const Real&)>& argument, const Real& critical,
                             const Real& lo, const Real& hi, std::vector<Real>& cuts);

    EvaluatedSceneState& state_;
    const Place* place_;
    const Variables& variables_;
    IntegralCache* cache_;
    mutable Real worst_{0};
    mutable bool converged_ = true;
};

} // namespace edgeproof::audit
