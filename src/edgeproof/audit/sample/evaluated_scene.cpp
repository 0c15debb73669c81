// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/sample/evaluated_scene.hpp"

#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/sample/body_fields.hpp"
#include "edgeproof/audit/sample/evaluated_scene_environment.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

/// The contact is computed with more digits than needed to compare formulas.
constexpr unsigned contact_guard = 15;
constexpr unsigned quadrature_guard = 20;
constexpr unsigned screening_guard = 6;
constexpr int screening_level = 6;
constexpr long most_local_terms = 1000;
constexpr std::size_t most_pressures = 4096; ///< stored for each edge

/// True for the functions of BodyFields.
bool is_body_function(std::string_view name) {
    return name == "sxx" || name == "szz" || name == "sxz" || name == "slip";
}

} // namespace

EvaluatedSceneLevel::EvaluatedSceneLevel(const SceneSpec& spec, const contact::Profile& profile)
    : law(profile, spec.parameter("Es").to<Real>()) {
    for (const auto& [name, value] : spec.names()) {
        parameters.emplace(name, value.to<Real>());
    }
    extent = law.extent(parameters.at("a"));
}

const contact::Extent<Real>& EvaluatedSceneLevel::extent_at(const Real& s) {
    if (!last_extent || last_extent->a != s) {
        last_extent = law.extent(s);
    }
    return *last_extent;
}

Real EvaluatedSceneLevel::force_rate_at(const Real& s) {
    // Formulas use it in several places of an integrand, some at every node for the same s.
    if (!last_force_rate || last_force_rate->first != s) {
        last_force_rate.emplace(s, law.force_rate(extent_at(s)));
    }
    return last_force_rate->second;
}

Real EvaluatedSceneLevel::right_edge_of(const Real& y) {
    if (y == extent.b) {
        return extent.a;
    }
    // Formulas use the same value at every node of an integral.
    if (!last_right_edge || last_right_edge->first != y) {
        last_right_edge.emplace(y, law.right_edge(y));
    }
    return last_right_edge->second;
}

EvaluatedSceneState::EvaluatedSceneState(SceneSpec scene, unsigned digits_wanted, Effort effort)
    : spec(std::move(scene)),
      digits(digits_wanted), precision{digits_wanted + (effort == Effort::full ? quadrature_guard
                                                                               : screening_guard)},
      profile(spec.make_profile()),
      contact(profile, spec.parameter("Es"), contact::Load::right_edge(spec.parameter("a")),
              digits_wanted + contact_guard) {
    if (effort == Effort::screening) {
        precision.last_level = screening_level;
    }
    const PrecisionScope scope(precision.integrand());
    const contact::Extent<Real>& extent = here().extent;
    precision.scale = std::max(extent.a, extent.b);
}

EvaluatedSceneLevel& EvaluatedSceneState::here() {
    const auto it = levels.find(working_digits());
    return it != levels.end() ? it->second
                              : levels.try_emplace(working_digits(), spec, profile).first->second;
}

const std::vector<Real>& EvaluatedSceneState::expansion(Edge edge, std::size_t terms) {
    auto& known = expansions[index_of(edge)];
    if (known.size() < terms) {
        known = contact.expansion(edge, std::max<std::size_t>(terms, 4));
    }
    return known;
}

Real EvaluatedSceneState::local(Edge edge, std::size_t n, const Real& u) {
    return sum_of_terms(std::span<const Real>(expansion(edge, n)).first(n), u, Real(0));
}

std::optional<Real> EvaluatedSceneState::derived_symbol(std::string_view name) {
    if (name == "b" || name == "L") { // at the working precision
        return named_quantity(*this, name);
    }
    const auto it = derived.find(name);
    if (it != derived.end()) {
        return it->second;
    }
    std::optional<Real> value = named_quantity(*this, name);
    if (value) {
        derived.emplace(std::string(name), *value);
    }
    return value;
}

contact::ShearLoad<Real> EvaluatedSceneState::shear_load() const {
    const auto& parameters = top().parameters;
    const auto Q = parameters.find("Q");
    const auto tension = parameters.find("sig0");
    if (Q == parameters.end() || tension == parameters.end()) {
        throw Error("a scene of family " + spec.family + " has no shear: give it Q and sig0");
    }
    return {Q->second, tension->second};
}

Place EvaluatedSceneState::place_of_x(const Real& x) const {
    const contact::Extent<Real>& extent = top().extent;
    const Real right = extent.a - x;
    const Real left = x + extent.b;
    return right < left ? Place{Edge::right, right, x, {}} : Place{Edge::left, left, x, {}};
}

Real EvaluatedSceneState::pressure_at_node(const Place& at) {
    const PrecisionScope scope(contact.digits() + contact_guard);
    const Edge edge = profile.symmetric() ? Edge::right : at.edge;
    auto& known = pressures[index_of(edge)];
    const Real u = at_working_precision(at.u);
    if (const auto it = known.find(u); it != known.end()) {
        return it->second;
    }
    Real p = contact.pressure(edge, u).value;
    if (known.size() < most_pressures) {
        known.emplace(u, p);
    }
    return p;
}

Real EvaluatedSceneState::call(const std::string& name, std::span<const Real> args,
                               const Place* place) {
    const Real& s = args[0];
    EvaluatedSceneLevel& level = here();
    const auto& law = level.law;
    const auto at_place = [&](const Real& x) {
        return place != nullptr && at_working_precision(place->x) == x;
    };
    if (name == "g1") {
        // At a knot, return the mean of both sides; a single point does not affect an integral.
        const auto& slope = law.slope();
        const std::size_t piece = slope.piece_at(s);
        if (piece > 0 && slope.knots()[piece - 1] == s) {
            return (slope.value(piece - 1, s) + slope.value(piece, s)) / 2;
        }
        return slope.value(piece, s);
    }
    if (name == "Pof") {
        return law.force(level.extent_at(s));
    }
    if (name == "P1of") {
        return level.force_rate_at(s);
    }
    if (name == "bof") {
        return level.extent_at(s).b;
    }
    if (name == "binv") {
        return level.right_edge_of(s);
    }
    if (name == "p") {
        if (at_place(s)) {
            return contact.pressure(place->edge, place->u).value;
        }
        return pressure_at_node(place_of_x(s));
    }
    if (name == "q") {
        return traction(at_place(s) ? *place : place_of_x(s));
    }
    if (name == "gap") {
        return gap(s);
    }
    if (is_body_function(name)) {
        return of_body(name, args, place);
    }
    if (name == "right_local" || name == "left_local") {
        const Edge edge = name == "right_local" ? Edge::right : Edge::left;
        const auto n = args[0].convert_to<long>();
        if (args[0] > most_local_terms) {
            throw BudgetError(name + " of more than " + std::to_string(most_local_terms) +
                              " terms");
        }
        if (n < 0 || Real(n) != args[0]) {
            throw DomainError(name + " has a number of terms that is not a whole number");
        }
        const contact::Extent<Real>& extent = top().extent;
        const Real u = at_place(args[1]) && place->edge == edge
                           ? place->u
                           : Real(edge == Edge::right ? extent.a - args[1] : args[1] + extent.b);
        return local(edge, static_cast<std::size_t>(n), u);
    }
    throw Error("the function '" + name + "' has no meaning here");
}

std::vector<Real> EvaluatedSceneState::critical_arguments(const std::string& function) {
    std::vector<Real> values;
    EvaluatedSceneLevel& level = here();
    const auto& law = level.law;
    for (const Real& knot : law.slope().knots()) {
        if (function == "g1" || function == "p" || function == "q" || is_body_function(function)) {
            values.push_back(knot);
        } else if (function == "binv") {
            values.push_back(knot > 0 ? level.extent_at(knot).b : Real(-knot));
        } else if (knot > 0) {
            values.push_back(knot);
        } else if (knot < 0 && !law.symmetric()) {
            values.push_back(level.right_edge_of(Real(-knot)));
        } else {
            values.emplace_back(0);
        }
    }
    if ((function == "q" || is_body_function(function)) && spec.slips()) {
        values.push_back(*derived_symbol("stick_a"));
        values.push_back(-*derived_symbol("stick_b"));
    }
    return values;
}

EvaluatedScene::EvaluatedScene(SceneSpec spec, unsigned digits, Effort effort)
    : state_(std::make_unique<EvaluatedSceneState>(std::move(spec), digits, effort)) {}
EvaluatedScene::~EvaluatedScene() = default;
EvaluatedScene::EvaluatedScene(EvaluatedScene&&) noexcept = default;

const SceneSpec& EvaluatedScene::spec() const noexcept { return state_->spec; }
unsigned EvaluatedScene::digits() const noexcept { return state_->digits; }
const contact::NormalContact& EvaluatedScene::contact() const { return state_->contact; }
Real EvaluatedScene::a() const { return state_->top().extent.a; }
Real EvaluatedScene::b() const { return state_->top().extent.b; }
Real EvaluatedScene::length() const { return state_->top().extent.length(); }

Real EvaluatedScene::parameter(std::string_view name) const {
    const auto& parameters = state_->top().parameters;
    const auto it = parameters.find(name);
    if (it == parameters.end()) {
        throw Error("a scene of family " + spec().family + " has no '" + std::string(name) + "'");
    }
    return it->second;
}

std::string place_text(Edge edge, const Exact& fraction) {
    return "u = " + fraction.text() + " of the length from the " +
           (edge == Edge::right ? "right" : "left") + " edge";
}

Place EvaluatedScene::place(Edge edge, const Exact& fraction) const {
    const PrecisionScope scope(state_->precision.integrand());
    Place at = place_at_u(edge, Real(fraction.to<Real>() * length()));
    at.text = place_text(edge, fraction);
    return at;
}

Place EvaluatedScene::place_at_u(Edge edge, const Real& u) const {
    const PrecisionScope scope(state_->precision.integrand());
    const auto& e = state_->top().extent;
    return {edge, u, edge == Edge::right ? Real(e.a - u) : Real(u - e.b), {}};
}

Real EvaluatedScene::pressure(Edge edge, const Real& u, contact::Route route) const {
    return state_->contact.pressure(edge, u, route).value;
}

std::vector<Real> EvaluatedScene::expansion(Edge edge, std::size_t terms) const {
    std::vector<Real> c = state_->expansion(edge, terms);
    c.resize(terms);
    return c;
}

Real EvaluatedScene::local(Edge edge, std::size_t n, const Real& u) const {
    const PrecisionScope scope(state_->precision.integrand());
    return state_->local(edge, n, u);
}

Variables
EvaluatedScene::values_of(const std::map<std::string, Exact, std::less<>>& variables) const {
    const PrecisionScope scope(state_->precision.integrand());
    Variables values;
    for (const auto& [name, value] : variables) {
        values.emplace(name, value.to<Real>());
    }
    return values;
}

FormulaValue EvaluatedScene::evaluate(const Expr& e, const Place* place, const Variables& variables,
                                      IntegralCache* cache) const {
    const PrecisionScope scope(state_->precision.integrand());
    EvaluatedSceneEnvironment environment(*state_, place, variables, cache);
    FormulaValue result;
    result.value = formula::evaluate<Real>(e, environment);
    result.estimate = environment.worst_estimate();
    result.converged = environment.converged();
    result.digits = state_->precision.nodes;
    if (result.estimate > 0) {
        const long good = (-floor(log10(result.estimate)) - 1).convert_to<long>();
        result.digits = static_cast<unsigned>(std::clamp(good, 0L, long{result.digits}));
    }
    return result;
}

bool EvaluatedScene::holds(const Condition& condition, const Place* place,
                           const Variables& variables) const {
    return std::ranges::all_of(condition, [&](const Relation& r) {
        return compare(r.op, evaluate(r.lhs, place, variables).value,
                       evaluate(r.rhs, place, variables).value);
    });
}

} // namespace edgeproof::audit
