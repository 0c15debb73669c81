// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/enclosed_integral.hpp"
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/sample/body_fields.hpp"
#include "edgeproof/contact/curved/curved_slope.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <concepts>
#include <exception>
#include <functional>
#include <memory>
#include <set>
#include <unordered_map>
#include <variant>
#include <vector>

namespace edgeproof::audit {

/// The contact of a sample, and the values of the names and functions of formulas in it.
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

} // namespace edgeproof::audit
