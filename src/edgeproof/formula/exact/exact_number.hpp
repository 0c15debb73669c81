// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/rational.hpp"

#include <optional>
#include <vector>

namespace edgeproof::formula {

/// A real number with an exact form: a sum of terms q R^(1/k) pi^e with q rational, R a positive
/// rational, k a positive integer and e rational; or `unknown`, which every operation propagates.
/// It is a field element for the templates of series/ and contact/, within limits: a sum of several
/// terms has no quotient and no root here.
///
/// Equality is decided, not estimated. Terms whose quotient is rational are combined, and the rest
/// is zero only if no term is left: positive real radicals of rationals whose quotients are
/// irrational are linearly independent over the rationals (A. S. Besicovitch, J. London Math. Soc.
/// 15 (1940) 3; C. L. Siegel, Acta Arith. 21 (1972) 59), and different powers of pi are linearly
/// independent over the algebraic numbers, because pi is transcendental (F. Lindemann, Math. Ann.
/// 20 (1882) 213).
class ExactNumber {
public:
    ExactNumber() = default;
    ExactNumber(int n) : ExactNumber(Rational(n)) {} // NOLINT: the templates write T(0), T(1)
    explicit ExactNumber(const Rational& q);
    [[nodiscard]] static ExactNumber pi();
    [[nodiscard]] static ExactNumber unknown();
    /// The value of a constant expression; unknown if it has another form, or no real value.
    [[nodiscard]] static ExactNumber of(const Expr& e);

    [[nodiscard]] bool known() const noexcept { return known_; }
    /// True if the number is known and zero.
    [[nodiscard]] bool is_zero() const noexcept { return known_ && terms_.empty(); }
    /// The number, if it is known and rational.
    [[nodiscard]] std::optional<Rational> rational() const;
    /// Returns -1, 0 or 1; nothing if the number is unknown, or if terms cancel to thousands of
    /// bits.
    [[nodiscard]] std::optional<int> sign() const;
    /// Returns a ball that is not finite if the number is unknown.
    [[nodiscard]] Ball enclosure(long bits) const;

    ExactNumber& operator+=(const ExactNumber& o);
    ExactNumber& operator-=(const ExactNumber& o);
    ExactNumber& operator*=(const ExactNumber& o);
    ExactNumber& operator/=(const ExactNumber& o);
    friend ExactNumber operator-(ExactNumber x);
    friend ExactNumber operator+(ExactNumber x, const ExactNumber& y) { return std::move(x += y); }
    friend ExactNumber operator-(ExactNumber x, const ExactNumber& y) { return std::move(x -= y); }
    friend ExactNumber operator*(ExactNumber x, const ExactNumber& y) { return std::move(x *= y); }
    friend ExactNumber operator/(ExactNumber x, const ExactNumber& y) { return std::move(x /= y); }
    /// True if both are known and equal. Two unknown numbers are not equal.
    friend bool operator==(const ExactNumber& x, const ExactNumber& y) {
        return ExactNumber(x - y).is_zero();
    }

    friend ExactNumber abs(const ExactNumber& x);
    /// Unknown for a negative number and for a sum of several terms.
    friend ExactNumber sqrt(const ExactNumber& x);
    /// Returns x^e; unknown for a negative x and an e that is not an integer, and for a sum of
    /// several terms.
    friend ExactNumber pow(const ExactNumber& x, const Rational& e);

private:
    /// radicand^(1/degree), positive; 1^(1/1) if the term has no radical.
    struct Radical {
        Rational radicand = 1;
        unsigned degree = 1;
    };
    struct Term {
        Rational factor;
        Radical root;
        Rational pi_power;
    };
    void add(const Term& t);
    [[nodiscard]] static std::optional<Term> product(const Term& x, const Term& y);
    [[nodiscard]] static std::optional<Term> power(const Term& x, const Rational& e);
    [[nodiscard]] static std::optional<Radical> times(const Radical& x, const Radical& y);

    bool known_ = true;
    std::vector<Term> terms_;
};

[[nodiscard]] ExactNumber abs(const ExactNumber& x);
[[nodiscard]] ExactNumber sqrt(const ExactNumber& x);
[[nodiscard]] ExactNumber pow(const ExactNumber& x, const Rational& e);
/// Returns h/pi for the angle h, 0 <= h <= pi/2, whose cosine has this square, if it is one of the
/// five with a rational square (DLMF table 4.17.1).
[[nodiscard]] std::optional<Rational> part_of_pi(const Rational& square_of_cosine);
/// Returns the angle h, 0 <= h <= pi, with cos h = c, if it is a multiple of pi/12, found from the
/// cosine or from the cosine of twice the angle. Unknown otherwise.
[[nodiscard]] ExactNumber angle_of_cosine(const ExactNumber& c);

} // namespace edgeproof::formula
