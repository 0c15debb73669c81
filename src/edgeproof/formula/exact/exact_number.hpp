// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/rational.hpp"

#include <optional>
#include <vector>

namespace edgeproof::formula {

/// A real number with an exact form: a sum of terms q R^(1/k) pi^e with q rational, R a positive
/// rational, k a whole number and e rational; or `unknown`, which every operation passes on. It is
/// a field element for the templates of series/ and contact/, as far as the form reaches: a sum of
/// several terms has no quotient and no root here.
///
/// Equality is decided, not estimated. Terms whose quotient is rational are one term, and what is
/// then left is zero only if there are none: positive real radicals of rationals whose quotients
/// are irrational are linearly independent over the rationals (A. S. Besicovitch, J. London Math.
/// Soc. 15 (1940) 3; C. L. Siegel, Acta Arith. 21 (1972) 59), and different powers of pi are so
/// over the algebraic numbers, pi being transcendental (F. Lindemann, Math. Ann. 20 (1882) 213).
class ExactNumber {
public:
    ExactNumber() = default;
    ExactNumber(int n) : ExactNumber(Rational(n)) {} // NOLINT: the templates write T(0), T(1)
    explicit ExactNumber(const Rational& q);
    [[nodiscard]] static ExactNumber pi();
    [[nodiscard]] static ExactNumber unknown();
    /// Of a constant expression; unknown where it has another form, or no real value.
    [[nodiscard]] static ExactNumber of(const Expr& e);

    [[nodiscard]] bool known() const noexcept { return known_; }
    /// Known, and zero.
    [[nodiscard]] bool is_zero() const noexcept { return known_ && terms_.empty(); }
    /// The number itself, where it is known and rational.
    [[nodiscard]] std::optional<Rational> rational() const;
    /// -1, 0 or 1; nothing for what is unknown, and for terms that cancel to thousands of bits.
    [[nodiscard]] std::optional<int> sign() const;
    /// Not finite where it is unknown.
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
    /// Both known, and the same number. Two unknown ones are not equal.
    friend bool operator==(const ExactNumber& x, const ExactNumber& y) {
        return ExactNumber(x - y).is_zero();
    }

    friend ExactNumber abs(const ExactNumber& x);
    /// Unknown for a negative number and for a sum of several terms.
    friend ExactNumber sqrt(const ExactNumber& x);
    /// x^e; unknown for a negative x and an e that is not a whole number, and as above.
    friend ExactNumber pow(const ExactNumber& x, const Rational& e);

private:
    /// radicand^(1/degree), positive; 1^(1/1) where it is rational.
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
/// The angle h, 0 <= h <= pi, with cos h = c, where it is a rational multiple of pi that a cosine
/// or the cosine of twice the angle tells: multiples of pi/12. Unknown otherwise.
[[nodiscard]] ExactNumber angle_of_cosine(const ExactNumber& c);

} // namespace edgeproof::formula
