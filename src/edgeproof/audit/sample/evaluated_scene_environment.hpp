// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/body_fields.hpp"
#include "edgeproof/audit/sample/evaluated_scene.hpp"
#include "edgeproof/audit/sample/naive_integral.hpp"
#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <functional>

namespace edgeproof::audit {

/// The family of contacts of an EvaluatedScene, and its parameters, at one precision.
struct EvaluatedSceneLevel {
    EvaluatedSceneLevel(const SceneSpec& spec, const contact::Profile& profile);

    contact::ContactLaw<Real> law;
    std::map<std::string, Real, std::less<>> parameters;
    contact::Extent<Real> extent;
    std::optional<contact::Extent<Real>> last_extent;     ///< of the contact with right edge at .a
    std::optional<std::pair<Real, Real>> last_right_edge; ///< y and b^{-1}(y)
    std::optional<std::pair<Real, Real>> last_force_rate; ///< s and P'(s)

    /// Returns the contact of the family whose right edge is at s.
    const contact::Extent<Real>& extent_at(const Real& s);
    /// Returns P'(s).
    Real force_rate_at(const Real& s);
    /// Returns b^{-1}(y).
    Real right_edge_of(const Real& y);
};

/// The data of an EvaluatedScene: the exact contact, and its family of contacts.
struct EvaluatedSceneState {
    EvaluatedSceneState(SceneSpec scene, unsigned digits_wanted, Effort effort);

    SceneSpec spec;
    unsigned digits;
    /// Enough for integrals evaluated as printed; plain formulas use the same precision.
    NaivePrecision precision;
    contact::Profile profile;
    contact::NormalContact contact;
    std::map<std::string, Real, std::less<>> derived; ///< P, P1, ..., computed on first use
    std::array<std::vector<Real>, 2> expansions;      ///< right, left
    std::map<unsigned, EvaluatedSceneLevel> levels;   ///< by digits
    /// p by the distance from the right edge and from the left edge; integrals of p share nodes.
    std::array<std::map<Real, Real>, 2> pressures;

    /// The fields by number of bits; null if this number of bits does not give an enclosure.
    std::map<long, std::unique_ptr<BodyFields>> enclosed_fields;

    /// Returns the level of the working precision. Far from their ends, integrands need few digits;
    /// this saves time only if all their parts have as few.
    EvaluatedSceneLevel& here();
    /// Returns the level with the precision of plain formulas.
    [[nodiscard]] const EvaluatedSceneLevel& top() const {
        return levels.at(precision.integrand());
    }
    const std::vector<Real>& expansion(Edge edge, std::size_t terms);
    /// Returns the sum of the first n terms at u.
    Real local(Edge edge, std::size_t n, const Real& u);
    // The quantities of body_fields.hpp.
    Real left_edge() { return here().extent.b; }
    Real length() { return here().extent.length(); }
    [[nodiscard]] bool axisymmetric() const { return spec.axisymmetric; }
    Real force() { return spec.axisymmetric ? spec.total_force().to<Real>() : contact.force(); }
    [[nodiscard]] Real approach() const { return spec.approach().to<Real>(); }
    Real moment() { return contact.moment(); }
    Real force_derivative(std::size_t k) {
        return contact.force_derivative(static_cast<unsigned>(k));
    }
    Real left_edge_derivative(std::size_t k) {
        return contact.left_edge_derivative(static_cast<unsigned>(k));
    }
    Real coefficient(Edge edge, std::size_t k) { return expansion(edge, k + 1)[k]; }
    Real shear_coefficient(Edge edge, std::size_t k) {
        return full_stick_expansion(top().extent.length(), shear_load(), edge, k + 1).back();
    }
    [[nodiscard]] bool slips() const { return spec.slips(); }
    Real slip_size(Edge edge) {
        return of_slip([edge](const contact::ProvedSlip& s) { return s.slip().size(edge); });
    }
    Real stick_edge(Edge edge) {
        return of_slip([edge](const contact::ProvedSlip& s) { return s.slip().stick().at(edge); });
    }
    /// Returns the value of a name that is not a parameter, place or variable; nullopt if unknown.
    std::optional<Real> derived_symbol(std::string_view name);
    /// Returns p at a place other than the sample's: at the nodes of integrals.
    Real pressure_at_node(const Place& at);
    Real call(const std::string& name, std::span<const Real> args, const Place* place);
    /// Returns the values of the argument of a function at which it is not analytic.
    std::vector<Real> critical_arguments(const std::string& function);
    [[nodiscard]] contact::ShearLoad<Real> shear_load() const;
    [[nodiscard]] Place place_of_x(const Real& x) const;
    /// Returns the middle of the enclosure of a quantity of the bodies.
    Real of_fields(const std::function<Ball(const BodyFields&)>& quantity);
    /// The same for a quantity of partial slip.
    Real of_slip(const std::function<Ball(const contact::ProvedSlip&)>& quantity) {
        return of_fields([&](const BodyFields& f) { return quantity(f.partial_slip()); });
    }
    /// Returns a stress or the slip, a function of BodyFields, at a place of the sample or at x.
    Real of_body(const std::string& function, std::span<const Real> args, const Place* place);
    /// Returns the middle of the enclosure of the gap at x > a.
    [[nodiscard]] Real gap(const Real& x) const;
    /// Returns q(x), under partial slip if the scene has friction.
    Real traction(const Place& at);
};

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
    [[nodiscard]] Real call(const Expr& node, std::span<const Real> args) const {
        return state_.call(node.name(), args, place_);
    }
    template <class Scope> [[nodiscard]] Real binder(const Expr& node, const Scope& scope) const {
        if (node.kind() == Expr::Kind::sum) {
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
        const auto along = [&](const Expr& e) {
            return [&](const Real& s) {
                return evaluate<Real>(e, formula::with_symbol(scope, name, s));
            };
        };
        std::vector<Real> cuts = places(lo, hi);
        collect_cuts(
            node.arg(0), name, lo, hi, [&](const Expr& e, const Real& s) { return along(e)(s); },
            cuts);
        NaivePrecision precision = state_.precision;
        precision.roots = !holds_call(node.arg(0), "p"); // p has logarithms at the knots
        const NaiveIntegral result =
            node.kind() == Expr::Kind::pv
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

    using At = std::function<Real(const Expr&, const Real&)>;
    /// Returns places where printed integrands have their branch points. Those inside an interval
    /// are not cuts; those outside show that a branch point is near an end.
    [[nodiscard]] std::vector<Real> places(const Real& lo, const Real& hi) const;
    /// Collects the values of the bound variable at which a function in f is not analytic.
    void collect_cuts(const Expr& f, const std::string& variable, const Real& lo, const Real& hi,
                      const At& at, std::vector<Real>& cuts) const;
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
