// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"

#include "edgeproof/audit/enclosure/contact_formulas.hpp"
#include "edgeproof/audit/enclosure/enclosed_integral.hpp"
#include "edgeproof/audit/enclosure/enclosed_reach.hpp"
#include "edgeproof/audit/sample/body_fields.hpp"
#include "edgeproof/contact/curved/curved_slope.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <concepts>
#include <exception>
#include <functional>
#include <iterator>
#include <memory>
#include <set>
#include <unordered_map>
#include <variant>
#include <vector>

namespace edgeproof::audit {

namespace {

/// The names that ContactFormulas use.
constexpr const char* names_of_formulas[] = {"a", "b", "Q", "sig0"};

} // namespace

struct EnclosedSample::State {
    State(const Sample& of, long at_bits, unsigned aim)
        : sample(of), bits(at_bits), integral_digits(aim), profile(of.scene.make_profile()) {
        const auto load = contact::Load::right_edge(of.scene.parameter("a"));
        contact_ = contact::proved_contact(profile, of.scene.parameter("Es"), load, bits);
        if (contact_->closed_form() == nullptr &&
            contact::monotonicity_of_slope(profile, contact_->a(), contact_->b()).kind !=
                contact::SlopeMonotonicity::Kind::rises) {
            throw Error("a slope that is not proved to rise over the contact has no enclosure");
        }
        for (const auto& [name, value] : of.scene.names()) {
            names.emplace(name, ball_of(value, bits));
        }
        for (const auto& [name, value] : of.variables) {
            names.insert_or_assign(name, ball_of(value, bits));
        }
        if (of.fraction) {
            u.emplace(ball_of(*of.fraction, bits) * length());
        }
    }

    /// The contact, by a closed form or by rigorous integration.
    [[nodiscard]] const contact::ProvedContact& contact() const { return *contact_; }
    /// Throws Error for a curved slope, for which `what` has no enclosure.
    [[nodiscard]] const contact::BallContact& closed_form(std::string_view what) const {
        if (const contact::BallContact* closed = contact_->closed_form()) {
            return *closed;
        }
        throw Error("'" + std::string(what) + "' of a curved slope has no enclosure");
    }
    /// Returns the value of a name of a quantity of the contact; nothing for other names.
    [[nodiscard]] std::optional<Ball> quantity(std::string_view name) const;
    [[nodiscard]] Ball length() const { return contact().a() + contact().b(); }
    [[nodiscard]] bool axisymmetric() const { return sample.scene.axisymmetric; }
    [[nodiscard]] Ball force_derivative(std::size_t k) const {
        if (k == 1 && contact().closed_form() == nullptr) {
            // c_0 = 2 P'(a)/(pi sqrt(a + b)): docs/expansions.md
            return coefficient(Edge::right, 0) * pi() * sqrt(length()) / 2;
        }
        return closed_form("P" + std::to_string(k)).force_derivatives(k + 1).back();
    }
    [[nodiscard]] Ball left_edge_derivative(std::size_t k) const {
        if (k == 1 && contact().closed_form() == nullptr) {
            // The coefficients c_0 of the edges have the ratio b'(a).
            return coefficient(Edge::right, 0) / coefficient(Edge::left, 0);
        }
        return closed_form("b" + std::to_string(k)).left_edge_derivatives(k + 1).back();
    }
    [[nodiscard]] Ball coefficient(Edge edge, std::size_t k) const {
        return contact().expansion(edge, k + 1).back();
    }
    [[nodiscard]] bool slips() const { return sample.scene.slips(); }
    [[nodiscard]] Ball x() const {
        return sample.edge == Edge::right ? contact().a() - *u : *u - contact().b();
    }
    [[nodiscard]] contact::ShearLoad<Ball> load() const {
        const auto Q = names.find("Q");
        const auto tension = names.find("sig0");
        if (Q == names.end() || tension == names.end()) {
            throw Error("a scene without shear");
        }
        return {Q->second, tension->second};
    }

    [[nodiscard]] const BodyFields& fields() const {
        if (!fields_) {
            const bool sheared = names.contains("Q") || names.contains("sig0");
            fields_.emplace(sample.scene, sheared ? std::optional(load()) : std::nullopt,
                            slips() ? std::optional(symbol("friction")) : std::nullopt, bits);
        }
        return *fields_;
    }
    mutable std::optional<BodyFields> fields_; ///< computed on first use
    mutable std::unique_ptr<EnclosedSample> next_;
    /// The integrals that were enclosed, or the reasons why they were not, for the many variants of
    /// a formula in a diagnosis.
    mutable std::unordered_map<Expr, std::variant<Ball, std::exception_ptr>, formula::ExprHash>
        integrals_;
    /// For a scene with friction.
    [[nodiscard]] const contact::ProvedSlip& partial_slip() const {
        return fields().partial_slip();
    }
    [[nodiscard]] Ball traction(const Expr& written, const Ball& at) const {
        if (!slips()) {
            const Edge edge = u ? sample.edge : Edge::right;
            return full_stick_traction(length(), load(), edge, distance(edge, written, at));
        }
        const bool own_place = u && written == Expr::symbol("x");
        const Edge edge = own_place                ? sample.edge
                          : certainly_negative(at) ? Edge::left
                                                   : Edge::right;
        return partial_slip().traction(edge, distance(edge, written, at));
    }

    [[nodiscard]] Ball number(const Rational& q) const { return Ball(q, bits); }
    [[nodiscard]] Ball pi() const { return Ball::pi(bits); }
    [[nodiscard]] Ball symbol(std::string_view name) const;
    [[nodiscard]] Ball call(const Expr& node, std::span<const Ball> args) const;
    /// Returns the value of given(f, name, value) or next(f); nothing for other calls.
    [[nodiscard]] std::optional<Ball> elsewhere(const Expr& call) const;

    template <class Scope> [[nodiscard]] Ball binder(const Expr& node, const Scope& scope) const {
        if (node.kind() == Expr::Kind::sum) {
            return evaluate_sum<Ball>(node, scope);
        }
        const auto value = [&] {
            Ball found;
            integral(
                node, [&](std::string_view name) { return Ball(scope.symbol(name)); },
                [&](const Expr& e, const IntegralSurroundings& around) {
                    found = enclosed_integral(e, around, integral_digits);
                });
            return found;
        };
        if constexpr (!std::same_as<Scope, State>) {
            return value(); // an integral inside another depends on more than its own text
        } else {
            const auto [known, added] = integrals_.try_emplace(node);
            if (added) {
                try {
                    known->second = value();
                } catch (...) {
                    known->second = std::current_exception();
                }
            }
            if (const auto* problem = std::get_if<std::exception_ptr>(&known->second)) {
                std::rethrow_exception(*problem);
            }
            return std::get<Ball>(known->second);
        }
    }
    /// Calls use(integral, surroundings) with the variables of the sample put in.
    using UseOfIntegral = std::function<void(const Expr&, const IntegralSurroundings&)>;
    void integral(const Expr& node, const std::function<Ball(std::string_view)>& symbol_of,
                  const UseOfIntegral& use) const;

    /// Returns the exact value of e if it is a constant of the scene.
    [[nodiscard]] std::optional<Exact> constant(const Expr& e) const {
        const std::set<std::string> names_in_e = free_symbols(e);
        return std::ranges::any_of(
                   overridden, [&](const std::string& name) { return names_in_e.contains(name); })
                   ? std::nullopt
                   : exact_value(e, sample);
    }
    /// Returns the distance from an edge of the place given by an argument.
    [[nodiscard]] Ball distance(Edge edge, const Expr& written, const Ball& at) const {
        if (u && edge == sample.edge && written == Expr::symbol("x")) {
            return *u;
        }
        return edge == Edge::right ? contact().a() - at : at + contact().b();
    }
    [[nodiscard]] Ball pressure(const Expr& written, const Ball& at) const {
        if (u && written == Expr::symbol("x")) {
            return contact().pressure(sample.edge, *u);
        }
        const Edge edge = certainly_negative(at) ? Edge::left : Edge::right;
        return contact().pressure(edge, distance(edge, written, at));
    }
    /// Returns g'(x); if the ball of x contains a knot, the values of the pieces on both sides.
    [[nodiscard]] Ball slope(const Ball& at) const {
        const auto in_piece = [&](std::size_t piece) {
            return formula::evaluate<Ball>(profile.pieces()[piece].slope,
                                           formula::with_symbol(*this, "x", at));
        };
        std::size_t first = 0;
        std::size_t last = 0;
        for (const Exact& knot : profile.knots()) {
            const Ball k = ball_of(knot, bits);
            first += certainly_less(k, at) ? 1 : 0;
            last += certainly_less(at, k) ? 0 : 1;
        }
        Ball g = in_piece(first);
        while (first < last) {
            g = Ball::hull(g, in_piece(++first));
        }
        return g;
    }
    /// Returns a contact of the family with the same profile.
    [[nodiscard]] contact::BallContact with_right_edge(const std::string& function,
                                                       const Expr& written, const Ball& at) const {
        const contact::BallContact& contact = closed_form(function);
        if (const auto edge = constant(written); edge && edge->sign() > 0) {
            return {profile, sample.scene.parameter("Es"), contact::Load::right_edge(*edge), bits};
        }
        if (!certainly_positive(at)) {
            throw Error(function + " of an argument that may not be positive");
        }
        return contact.with_right_edge(at);
    }
    [[nodiscard]] Ball local(Edge edge, const Expr& node, std::span<const Ball> args) const {
        const Rational* n = node.arg(0).rational();
        if (n == nullptr || denominator(*n) != 1 || *n < 0 || *n > 1000) {
            throw Error(node.name() + " of a number of terms that is not from 0 to 1000");
        }
        const Ball at = distance(edge, node.arg(1), args[1]);
        const std::vector<Ball> c = contact().expansion(edge, n->convert_to<std::size_t>());
        return sum_of_terms(c, at);
    }

    Sample sample;
    long bits;
    unsigned integral_digits;
    contact::Profile profile;
    std::unique_ptr<contact::ProvedContact> contact_;
    std::optional<Ball> u;
    std::map<std::string, Ball, std::less<>> names;
    std::set<std::string> overridden; ///< names whose exact value in the sample is no longer valid
};

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

EnclosedSample::EnclosedSample(const Sample& sample, long bits, unsigned integral_digits)
    : state_(std::make_unique<State>(sample, bits, integral_digits)) {}
EnclosedSample::~EnclosedSample() = default;
EnclosedSample::EnclosedSample(EnclosedSample&&) noexcept = default;

Ball EnclosedSample::evaluate(const Expr& e) const { return formula::evaluate<Ball>(e, *state_); }

Ball EnclosedSample::finite(const Expr& e) const {
    Ball value = evaluate(e);
    if (!value.is_finite()) {
        throw BudgetError("the balls do not exclude a point where it is undefined");
    }
    return value;
}

bool EnclosedSample::diverges(const Expr& integral) const {
    bool found = false;
    try {
        state_->integral(
            integral, [&](std::string_view name) { return state_->symbol(name); },
            [&](const Expr& e, const IntegralSurroundings& around) {
                found = certainly_divergent(e, around);
            });
    } catch (const Error&) {
        return false; // no enclosure of the integrand
    }
    return found;
}

void EnclosedSample::set(const std::string& name, const Ball& value) {
    state_->names.insert_or_assign(name, value);
    state_->overridden.insert(name);
    state_->fields_.reset();
    state_->integrals_.clear();
}

void EnclosedSample::set_place(Edge edge, const Ball& u) {
    state_->sample.edge = edge;
    state_->u = u;
    state_->integrals_.clear();
}

Ball EnclosedSample::length() const { return state_->length(); }
long EnclosedSample::bits() const { return state_->bits; }

std::optional<Exact> exact_value(Expr e, const Sample& sample) {
    for (const auto& [name, value] : sample.variables) {
        e = substitute(e, name, value.expr());
    }
    for (const auto& [name, value] : sample.scene.parameters) {
        e = substitute(e, name, value.expr());
    }
    if (!free_symbols(e).empty() || holds_function(e)) {
        return std::nullopt;
    }
    return Exact(e);
}

Enclosed enclosed(const Expr& e, const Sample& sample, unsigned digits) {
    Enclosed best;
    const long needed = formula::bits_for(digits);
    best.problem = look_closer(
        [&](long bits) {
            best.ball = EnclosedSample(sample, bits).finite(e);
            return best.ball->relative_accuracy_bits() >= needed;
        },
        {2 * needed, 16 * needed});
    return best;
}

std::string ball_text(const Ball& ball, unsigned digits) {
    // These exponents are not allowed for numbers in a text.
    constexpr long most_exponent = 330'000; // of two: about 1e100000
    const long exponent = arf_abs_bound_lt_2exp_si(arb_midref(ball.data()));
    if (exponent > most_exponent || (exponent < -most_exponent && !contains_zero(ball))) {
        return exponent > 0 ? "beyond 1e100000" : "within 1e-100000 of 0";
    }
    if (!ball.is_exact() && contains_zero(ball)) {
        return "0 +- " + bound_text(abs(ball).upper());
    }
    // Only two digits that the radius makes uncertain are shown.
    const long known =
        std::min(ball.relative_accuracy_bits(), formula::bits_for(digits)) * 301 / 1000 + 2;
    const Rounded middle =
        round_ball(Ball(ball.midpoint(), ball.bits()),
                   static_cast<unsigned>(std::clamp(known, 1L, static_cast<long>(digits))));
    // The rounding of the middle for the text is part of the error.
    const Ball off = abs(ball - Ball(middle.value.value(), ball.bits()));
    return middle.text + " +- " + bound_text(off.upper());
}

} // namespace edgeproof::audit
