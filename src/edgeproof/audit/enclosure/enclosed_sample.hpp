// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/enclosure/contact_formulas.hpp"
#include "edgeproof/audit/enclosure/enclosed_integral.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/contact/curved/curved_slope.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/stress/cauchy_integral.hpp"
#include "edgeproof/contact/stress/plane_stress.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <exception>
#include <memory>
#include <set>
#include <unordered_map>
#include <variant>
#include <vector>

namespace edgeproof::audit {

/// Returns c_0 sqrt(u) + ... + c_{n-1} u^(n-1/2) by Horner's rule.
[[nodiscard]] inline Ball sum_of_terms(std::span<const Ball> c, const Ball& u) {
    Ball sum(0, u.bits());
    for (std::size_t k = c.size(); k-- > 0;) {
        sum = sum * u + c[k];
    }
    return sum * sqrt(u);
}

/// Returns the value of a formula as an exact number, if it contains only parameters of the scene
/// and variables of the sample; nothing for others.
[[nodiscard]] std::optional<Exact> exact_value(Expr e, const Sample& sample);

/// A sample of a claim in ball arithmetic, in which the formulas of a ledger are enclosed.
///
/// Symbols: every parameter of the scene (m, C, t, R, phi, alpha, Es, ...), a, b, P, M, L = a + b,
/// P1, P2, ... (P'(a), P''(a), ...), b1, b2, ..., right_c0, ..., left_c0, ... (the coefficients of
/// the expansions: "right.c0" in a ledger), u and x of the place.
/// Functions: p(x), g1(x) the slope, gap(x), Pof(s), P1of(s), bof(s), binv(y) along the family of
/// contacts, right_local(n, x), left_local(n, x), the n-term approximations, and q(x), the shear
/// traction under full stick if the scene has Q and sig0; right_s0, left_s0, ... are its
/// coefficients. With `friction` as well, q(x) is that of partial slip, right_d and left_d are the
/// sizes of the slip zones, stick_a and stick_b the edges of the stick zone, and slip(x) is
/// u_A - u_B. sxx(x, z), mises(x, z), ... are the stresses in body A, without a bulk stress of A,
/// and greatest_mises, greatest_mises_x and greatest_mises_z the greatest value and its place
/// (tau_max, mises; sxx on the surface; axis_mises and axis_mises_z on the axis of a body of
/// revolution); p_max is the greatest pressure. integral(f, s, lo, hi) and pv(f, s, lo, hi, x) are
/// enclosed as in enclosed_integral.hpp. Not thread-safe: one thread may use an object at a time.
class EnclosedSample {
public:
    /// Throws BudgetError or DomainError if this number of bits does not enclose the contact.
    /// `integral_digits`: the accuracy that integrals aim at; the full accuracy of the bits would
    /// cost too much.
    explicit EnclosedSample(Sample sample, long bits, unsigned integral_digits = 20);

    /// The ball is not finite if a point at which the formula is undefined is not excluded. Throws
    /// Error for parts without an enclosure.
    [[nodiscard]] Ball evaluate(const Expr& e) const { return formula::evaluate<Ball>(e, *this); }
    /// The same; throws BudgetError if the ball is not finite.
    [[nodiscard]] Ball finite(const Expr& e) const;
    /// True if an integral is proved to diverge at one of its ends.
    [[nodiscard]] bool diverges(const Expr& integral) const;
    /// Replaces the value of a name.
    void set(const std::string& name, const Ball& value);
    /// Moves the place to the distance u from an edge.
    void set_place(Edge edge, const Ball& u);
    /// Returns a + b.
    [[nodiscard]] Ball length() const { return contact().a() + contact().b(); }
    [[nodiscard]] long bits() const { return bits_; }

    // The environment of formula::evaluate.
    [[nodiscard]] Ball number(const Rational& q) const { return Ball(q, bits_); }
    [[nodiscard]] Ball pi() const { return Ball::pi(bits_); }
    [[nodiscard]] Ball symbol(std::string_view name) const;
    [[nodiscard]] Ball call(const Expr& node, std::span<const Ball> args) const;
    /// Returns the value of given(f, name, value) or next(f); nothing for other calls.
    [[nodiscard]] std::optional<Ball> elsewhere(const Expr& call) const;

    [[nodiscard]] Ball binder(const Expr& node) const {
        return node.kind() == Expr::Kind::sum ? evaluate_sum<Ball>(node, *this) : integral(node);
    }

private:
    /// The contact, by a closed form or by rigorous integration.
    [[nodiscard]] const contact::ProvedContact& contact() const { return *contact_; }
    /// Of a body of revolution, which is a power law, the plane contact with the same pressure.
    [[nodiscard]] const contact::PlaneContact& plane() const {
        return dynamic_cast<const contact::PlaneContact&>(*contact_);
    }
    /// Throws Error for a curved slope, for which `what` has no enclosure.
    [[nodiscard]] const contact::BallContact& closed_form(std::string_view what) const {
        if (const contact::BallContact* closed = contact_->closed_form()) {
            return *closed;
        }
        throw Error("'" + std::string(what) + "' of a curved slope has no enclosure");
    }
    /// Returns the value of a name of a quantity of the contact; nothing for other names.
    [[nodiscard]] std::optional<Ball> quantity(std::string_view name) const;
    [[nodiscard]] bool axisymmetric() const { return scene_->round.has_value(); }
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
    [[nodiscard]] bool slips() const { return sample_.scene.slips(); }
    [[nodiscard]] Ball x() const {
        return sample_.edge == Edge::right ? contact().a() - *u_ : *u_ - contact().b();
    }
    [[nodiscard]] contact::ShearLoad<Ball> load() const {
        const auto Q = names_.find("Q");
        const auto tension = names_.find("sig0");
        if (Q == names_.end() || tension == names_.end()) {
            throw Error(Q == names_.end() ? "a scene without Q" : "a scene without sig0");
        }
        return {Q->second, tension->second};
    }

    struct PartialSlip {
        contact::ProvedSlip proved;
        std::optional<contact::TractionParts> parts;
    };
    /// For a scene with friction. Throws Error if the slip is proved not to be partial.
    [[nodiscard]] const PartialSlip& partial_slip() const;
    /// Returns the value of a call such as mises(x, z).
    [[nodiscard]] Ball stress(const Expr& call, const Ball& x, const Ball& z) const;
    /// The stresses in body A, which has no bulk stress; tension is positive.
    [[nodiscard]] contact::StressState stresses(const Expr& written, const Ball& x,
                                                const Ball& z) const;
    /// Poisson's ratio of body A.
    [[nodiscard]] Ball poisson() const;
    /// Returns the value of a name without "greatest_" or "axis_".
    [[nodiscard]] Ball greatest(std::string_view name) const;
    /// Returns u_A - u_B at a place in the contact.
    [[nodiscard]] Ball slip(const Ball& x) const;
    [[nodiscard]] Ball gap(const Ball& x) const;
    /// Returns exit(n, tol), measure(n, tol) or best(n, tol, m, lo, hi), proved (ball_extent.hpp,
    /// contact/design). Throws BudgetError if the bits do not decide, and Error if the tolerance is
    /// nowhere reached or the question has no meaning. `best` is up to the middle of the contact,
    /// only for the exponent m of a power law; no other value is better by more than 1e-8.
    [[nodiscard]] Ball reach(const Expr& call) const;
    [[nodiscard]] Ball traction(const Expr& written, const Ball& at) const {
        if (!slips()) {
            const Edge edge = u_ ? sample_.edge : Edge::right;
            return full_stick_traction(length(), load(), edge, distance(edge, written, at));
        }
        const bool own_place = u_ && written == Expr::symbol("x");
        const Edge edge = own_place                ? sample_.edge
                          : certainly_negative(at) ? Edge::left
                                                   : Edge::right;
        return partial_slip().proved.traction(edge, distance(edge, written, at),
                                              own_place ? std::nullopt : constant(written));
    }

    /// Returns the value of an integral or principal value.
    [[nodiscard]] Ball integral(const Expr& node) const;
    /// Returns use(integral, surroundings), with the variables of the sample put in.
    template <class Use> [[nodiscard]] auto in_surroundings(const Expr& node, const Use& use) const;

    /// Returns the exact value of e if it is a constant of the scene.
    [[nodiscard]] std::optional<Exact> constant(const Expr& e) const {
        const std::set<std::string> names_in_e = free_symbols(e);
        return std::ranges::any_of(
                   overridden_, [&](const std::string& name) { return names_in_e.contains(name); })
                   ? std::nullopt
                   : exact_value(e, sample_);
    }
    /// Returns the distance from an edge of the place given by an argument.
    [[nodiscard]] Ball distance(Edge edge, const Expr& written, const Ball& at) const {
        if (u_ && edge == sample_.edge && written == Expr::symbol("x")) {
            return *u_;
        }
        return edge == Edge::right ? contact().a() - at : at + contact().b();
    }
    [[nodiscard]] Ball pressure(const Expr& written, const Ball& at) const {
        if (u_ && written == Expr::symbol("x")) {
            return contact().pressure(sample_.edge, *u_);
        }
        const Edge edge = certainly_negative(at) ? Edge::left : Edge::right;
        const Ball u = distance(edge, written, at);
        const std::optional<Exact> x = constant(written);
        return x ? contact().pressure(edge, u, *x) : contact().pressure(edge, u);
    }
    /// Returns g'(x); if the ball of x contains a knot, the values of the pieces on both sides.
    [[nodiscard]] Ball slope(const Ball& x) const;
    /// Returns a contact of the family with the same profile.
    [[nodiscard]] contact::BallContact with_right_edge(const std::string& function,
                                                       const Expr& written, const Ball& at) const {
        const contact::BallContact& contact = closed_form(function);
        if (const auto edge = constant(written); edge && edge->sign() > 0) {
            return {profile_, scene_->contact_modulus, contact::Load::right_edge(*edge), bits_};
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

    Sample sample_;
    long bits_;
    unsigned integral_digits_;
    std::shared_ptr<const scene::Scene> scene_;
    const contact::Profile& profile_;
    std::unique_ptr<contact::ProvedContact> contact_;
    std::optional<Ball> u_;
    std::map<std::string, Ball, std::less<>> names_;
    std::set<std::string> overridden_; ///< names whose exact value in the sample is no longer valid
    mutable std::unique_ptr<PartialSlip> slip_; ///< computed on first use
    mutable std::unique_ptr<EnclosedSample> next_;
    mutable std::optional<ContactFormulas> formulas_; ///< its constants are names as well
    /// The integrals that were enclosed, or the reasons why they were not, for the many variants of
    /// a formula in a diagnosis.
    mutable std::unordered_map<Expr, std::variant<Ball, std::exception_ptr>, formula::ExprHash>
        integrals_;
};

/// Returns a text such as "0.123456 +- 1.2e-52".
[[nodiscard]] std::string ball_text(const Ball& ball, unsigned digits);

} // namespace edgeproof::audit
