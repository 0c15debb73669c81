// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace edgeproof::audit {

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
/// u_A - u_B. sxx(x, z), szz(x, z), sxz(x, z) are the stresses in body A, without a bulk stress of
/// A. integral(f, s, lo, hi) and pv(f, s, lo, hi, x) are enclosed as in enclosed_integral.hpp.
/// Not thread-safe: one thread may use an object at a time.
class EnclosedSample {
public:
    /// Throws BudgetError or DomainError if this number of bits does not enclose the contact.
    /// `integral_digits`: the accuracy that integrals aim at; the full accuracy of the bits would
    /// cost too much.
    EnclosedSample(const Sample& sample, long bits, unsigned integral_digits = 20);
    ~EnclosedSample();
    EnclosedSample(EnclosedSample&&) noexcept;

    /// The ball is not finite if a point at which the formula is undefined is not excluded. Throws
    /// Error for parts without an enclosure.
    [[nodiscard]] Ball evaluate(const Expr& e) const;
    /// The same; throws BudgetError if the ball is not finite.
    [[nodiscard]] Ball finite(const Expr& e) const;
    /// True if an integral is proved to diverge at one of its ends.
    [[nodiscard]] bool diverges(const Expr& integral) const;
    /// Replaces the value of a name.
    void set(const std::string& name, const Ball& value);
    /// Moves the place to the distance u from an edge.
    void set_place(Edge edge, const Ball& u);
    /// Returns a + b.
    [[nodiscard]] Ball length() const;
    [[nodiscard]] long bits() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The enclosure of a formula at a sample, right to `digits` digits if the bits are sufficient. If
/// `ball` is empty, `problem` gives the reason.
struct Enclosed {
    std::optional<Ball> ball;
    std::string problem;
};
[[nodiscard]] Enclosed enclosed(const Expr& e, const Sample& sample, unsigned digits);

/// Returns the value of a formula as an exact number, if it contains only parameters of the scene
/// and variables of the sample; nothing for others.
[[nodiscard]] std::optional<Exact> exact_value(Expr e, const Sample& sample);

/// Returns a text such as "0.123456 +- 1.2e-52".
[[nodiscard]] std::string ball_text(const Ball& ball, unsigned digits);

} // namespace edgeproof::audit
