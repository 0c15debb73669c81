// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/real.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace edgeproof::formula {

/// A constant with an exact value, given as text ("0.4", "pi/16", "3/2", "1e-30", "sqrt(2)/3").
class Exact {
public:
    /// The number 0.
    Exact();
    /// Throws FormulaError for a text that is not a constant expression, or that has no real value
    /// ("1/0", "sqrt(-1)").
    [[nodiscard]] static Exact parse(std::string_view text);
    /// A rational constant; its text is a decimal or a quotient.
    [[nodiscard]] static Exact of(const Rational& q);
    /// An expression without variables; its text is `to_text` of it. Throws Error if it has a
    /// variable, DomainError if it has no real value.
    explicit Exact(Expr e);

    /// The text as given.
    [[nodiscard]] const std::string& text() const noexcept { return text_; }
    [[nodiscard]] const Expr& expr() const noexcept { return expr_; }
    [[nodiscard]] bool is_rational() const noexcept { return expr_.rational() != nullptr; }
    /// Throws Error if it is not rational, or not recognised as rational.
    [[nodiscard]] const Rational& rational() const;

    /// Returns the nearest T (`Real`: at the working precision). Throws DomainError beyond the
    /// range of T, BudgetError if 4096 bits more than those of T do not decide the rounding.
    template <Arithmetic T> [[nodiscard]] T to() const;
    /// Returns -1, 0 or 1. Throws BudgetError if 4096 bits do not decide the sign.
    [[nodiscard]] int sign() const;

    /// Compares the expressions: "0.5" and "1/2" differ.
    friend bool operator==(const Exact& x, const Exact& y) { return x.expr_ == y.expr_; }

private:
    Exact(std::string text, Expr expr) : text_(std::move(text)), expr_(std::move(expr)) {}
    std::string text_;
    Expr expr_;
};

/// Returns a finite enclosure of a constant expression, by ball arithmetic at `bits` bits; its ends
/// have 2 bits more. Nothing if the balls do not exclude a point where the expression is undefined.
/// Throws Error for an integral, and for a name without a value.
[[nodiscard]] std::optional<Ball> enclose(const Expr& constant, long bits);

/// The environment in which an expression without variables is evaluated in balls (evaluate.hpp).
struct BallConstants {
    long bits;
    [[nodiscard]] Ball number(const Rational& q) const { return {q, bits}; }
    [[nodiscard]] Ball pi() const { return Ball::pi(bits); }
    /// Throws Error, because there are no variables.
    [[noreturn]] static Ball symbol(std::string_view name);
};

/// Returns an enclosure of a constant at a working precision of `bits`.
[[nodiscard]] Ball enclosed_constant(const Exact& x, long bits);
/// The same for an expression without variables.
[[nodiscard]] Ball enclosed_constant(const Expr& e, long bits);

/// Returns an enclosure of a constant. Throws BudgetError if ball arithmetic finds none.
[[nodiscard]] Ball ball_of(const Exact& x, long bits);

/// Returns the number of bits for `digits` decimal digits, with a few guard bits.
[[nodiscard]] long bits_for(unsigned digits);

/// Returns the value if it is recognised as rational.
[[nodiscard]] std::optional<Rational> rational_of(const Exact& x);

} // namespace edgeproof::formula
