// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/sample_state.hpp"

#include "edgeproof/audit/enclosure/contact_formulas.hpp"
#include "edgeproof/audit/enclosure/enclosed_reach.hpp"

#include <iterator>

namespace edgeproof::audit {
Ball EnclosedSample::State::symbol(std::string_view name) const {
    if (const auto it = names.find(name); it != names.end()) {
        return it->second;
    }
    if (name == "u" || name == "x") {
        if (!u) {
            throw Error("no place is given");
        }
        return name == "u" ? *u : x();
    }
    if (const auto value = quantity(name)) {
        return *value;
    }
    throw Error("'" + std::string(name) + "' has no enclosure");
}

std::optional<Ball> EnclosedSample::State::quantity(std::string_view name) const {
    if (name == "b") {
        return contact().b();
    }
    if (name == "L") {
        return length();
    }
    if (name == "P") {
        return axisymmetric() ? ball_of(sample.scene.total_force(), bits) : contact().force();
    }
    if (axisymmetric() && name == "delta") {
        return ball_of(sample.scene.approach(), bits);
    }
    if (name == "M") {
        return contact().moment();
    }
    if (const auto k = order_behind(name, "P")) {
        return force_derivative(*k);
    }
    if (const auto k = order_behind(name, "b")) {
        return left_edge_derivative(*k);
    }
    for (const Edge edge : {Edge::right, Edge::left}) {
        const bool right = edge == Edge::right;
        const std::string side = right ? "right_" : "left_";
        if (const auto k = order_behind(name, side + "c")) {
            return coefficient(edge, *k);
        }
        if (const auto k = order_behind(name, side + "s")) {
            return full_stick_expansion(length(), load(), edge, *k + 1).back();
        }
        if (slips() && name == side + "d") {
            return partial_slip().slip().size(edge);
        }
        if (slips() && name == (right ? "stick_a" : "stick_b")) {
            return partial_slip().slip().stick().at(edge);
        }
    }
    return std::nullopt;
}

Ball EnclosedSample::State::call(const Expr& node, std::span<const Ball> args) const {
    const std::string& name = node.name();
    if (name == "p") {
        return pressure(node.arg(0), args[0]);
    }
    if (name == "q") {
        return traction(node.arg(0), args[0]);
    }
    if (name == "g1") {
        return slope(args[0]);
    }
    if (name == "gap") {
        return gap_at(closed_form(name), axisymmetric(), args[0]);
    }
    if (name == "sxx" || name == "szz" || name == "sxz") {
        return fields().stress(name, args[0], args[1]);
    }
    if (name == "slip") {
        return fields().slip(args[0]);
    }
    if (name == "right_local") {
        return local(Edge::right, node, args);
    }
    if (name == "left_local") {
        return local(Edge::left, node, args);
    }
    if (name == "Pof" || name == "P1of" || name == "bof") {
        const contact::BallContact other = with_right_edge(name, node.arg(0), args[0]);
        return name == "Pof"    ? other.force()
               : name == "P1of" ? other.force_derivatives(2).back()
                                : other.b();
    }
    if (name == "exit" || name == "measure" || name == "best") {
        const auto exact = [&](std::size_t i) {
            const auto value = constant(node.arg(i));
            if (!value) {
                throw Error("the arguments of " + name + " are not numbers");
            }
            return *value;
        };
        const ReachQuestion question{sample.edge, exact(0), exact(1)};
        return name != "best"
                   ? enclosed_reach(sample.scene, question, name == "exit", bits)
                   : best_value(sample.scene, question, node.arg(2).name(), exact(3), exact(4));
    }
    if (name == "binv" && certainly_positive(args[0])) {
        return closed_form(name).mirrored().with_right_edge(args[0]).b();
    }
    throw Error("'" + name + "' has no enclosure");
}

std::optional<Ball> EnclosedSample::State::elsewhere(const Expr& call) const {
    if (call.name() == "next") {
        if (!sample.next) {
            throw Error("next(f) has a value only in a claim with the key `along`");
        }
        if (!next_) {
            next_ = std::make_unique<EnclosedSample>(*sample.next, bits, integral_digits);
        }
        return next_->evaluate(call.arg(0));
    }
    if (call.name() != "given") {
        return std::nullopt;
    }
    const std::string name = call.arg(1).kind() == Expr::Kind::symbol ? call.arg(1).name() : "";
    Sample other = sample;
    const bool variable = other.variables.contains(name);
    const auto exact = constant(call.arg(2));
    if (!variable && !other.scene.parameters.contains(name)) {
        throw Error("given(...) needs a parameter of the family or a name of `vary`");
    }
    if (exact) {
        (variable ? other.variables[name] : other.scene.parameters[name]) = *exact;
    } else if (!variable && name != "Q" && name != "sig0") {
        throw Error("given(...) needs a number for a parameter of the profile");
    }
    EnclosedSample there(other, bits, integral_digits);
    for (const std::string& own : overridden) {
        there.set(own, names.at(own));
    }
    there.set(name, formula::evaluate<Ball>(call.arg(2), *this));
    if (u) {
        there.set_place(sample.edge, *u);
    }
    return there.evaluate(call.arg(0));
}

namespace {

/// The names that ContactFormulas use.
constexpr const char* names_of_formulas[] = {"a", "b", "Q", "sig0"};

/// A State with other names. Its type does not grow with nested integrals.
template <class State> struct Renamed {
    const State& state;
    const std::function<Ball(std::string_view)>& symbol_of;
    [[nodiscard]] Ball number(const Rational& q) const { return state.number(q); }
    [[nodiscard]] Ball pi() const { return state.pi(); }
    [[nodiscard]] Ball symbol(std::string_view name) const { return symbol_of(name); }
    [[nodiscard]] Ball call(const Expr& node, std::span<const Ball> args) const {
        return state.call(node, args);
    }
    template <class Scope> [[nodiscard]] Ball binder(const Expr& node, const Scope& scope) const {
        return state.binder(node, scope);
    }
};

} // namespace

void EnclosedSample::State::integral(const Expr& node,
                                     const std::function<Ball(std::string_view)>& symbol_of,
                                     const UseOfIntegral& use) const {
    if (slips() && holds_call(node, "q")) {
        throw Error("q of partial slip has no enclosure inside an integral");
    }
    const bool renamed =
        std::any_of(std::begin(names_of_formulas), std::end(names_of_formulas),
                    [&](const char* name) {
                        return sample.variables.contains(name) || node.arg(1).name() == name;
                    }) ||
        sample.scene.parameters.contains("b");
    std::optional<ContactFormulas> formulas;
    if (!renamed && holds_function(node)) {
        formulas.emplace(profile, closed_form("an integral"),
                         ball_of(sample.scene.parameter("Es"), bits));
    }
    const std::function<Ball(std::string_view)> with_formulas = [&](std::string_view name) {
        if (formulas) {
            const auto it = formulas->constants().find(name);
            if (it != formulas->constants().end()) {
                return it->second;
            }
        }
        return symbol_of(name);
    };
    // Limits such as k*a with k = 1 are compared with the edges by symbols.
    Expr with_values = node;
    for (const auto& [name, value] : sample.variables) {
        if (!overridden.contains(name)) {
            with_values = substitute(with_values, name, value.expr());
        }
    }
    const Renamed<State> scope{*this, with_formulas};
    IntegralSurroundings around;
    around.value = [&](const Expr& e) { return formula::evaluate<Ball>(e, scope); };
    around.rational = [&](const Expr& e) -> std::optional<Rational> {
        const auto exact = constant(e);
        return exact && exact->is_rational() ? std::optional(exact->rational()) : std::nullopt;
    };
    around.contact = formulas ? &*formulas : nullptr;
    around.symmetric = profile.symmetric() && !renamed;
    around.bits = bits;
    use(with_values, around);
}

} // namespace edgeproof::audit
