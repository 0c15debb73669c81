// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rational.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <string_view>

namespace edgeproof::audit {

/// A number modulo the prime p = 2^61 - 1, with which the templates over any field (edge
/// expansions, formulas) run exactly. An expression that does not vanish modulo p for some values
/// of its symbols does not vanish identically over the rationals.
class Residue {
public:
    static constexpr std::uint64_t prime = (std::uint64_t{1} << 61U) - 1;

    constexpr Residue() = default;
    constexpr Residue(int n) // NOLINT: series and polynomials write T(0), T(1)
        : value_(n >= 0 ? static_cast<std::uint64_t>(n)
                        : prime - static_cast<std::uint64_t>(-static_cast<long>(n))) {}
    [[nodiscard]] static constexpr Residue of(std::uint64_t n) {
        Residue r;
        r.value_ = n % prime;
        return r;
    }
    /// Throws DomainError if p divides the denominator.
    [[nodiscard]] static Residue of(const Rational& q) {
        const Integer p(prime);
        const auto reduced = [&](Integer n) {
            n %= p;
            return of((n < 0 ? Integer(n + p) : n).convert_to<std::uint64_t>());
        };
        return reduced(numerator(q)) / reduced(denominator(q));
    }
    [[nodiscard]] constexpr std::uint64_t value() const { return value_; }

    constexpr Residue& operator+=(Residue o) {
        value_ += o.value_;
        value_ -= value_ >= prime ? prime : 0;
        return *this;
    }
    constexpr Residue& operator-=(Residue o) { return *this += -o; }
    constexpr Residue& operator*=(Residue o) {
        __extension__ using Wide = unsigned __int128;
        const Wide product = static_cast<Wide>(value_) * o.value_;
        value_ = static_cast<std::uint64_t>(product & prime);
        Residue high; // less than the prime, as both factors are
        high.value_ = static_cast<std::uint64_t>(product >> 61U);
        return *this += high;
    }
    /// Throws DomainError for o = 0.
    Residue& operator/=(Residue o) {
        if (o.value_ == 0) {
            throw DomainError("a division by zero modulo a prime");
        }
        return *this *= power(o, prime - 2);
    }
    friend constexpr Residue operator-(Residue x) {
        x.value_ = x.value_ == 0 ? 0 : prime - x.value_;
        return x;
    }
    friend constexpr Residue operator+(Residue x, Residue y) { return x += y; }
    friend constexpr Residue operator-(Residue x, Residue y) { return x -= y; }
    friend constexpr Residue operator*(Residue x, Residue y) { return x *= y; }
    friend Residue operator/(Residue x, Residue y) { return x /= y; }
    friend constexpr bool operator==(Residue x, Residue y) { return x.value_ == y.value_; }

    [[nodiscard]] static constexpr Residue power(Residue x, std::uint64_t n) {
        Residue y(1);
        for (; n != 0; n >>= 1U) {
            if ((n & 1U) != 0) {
                y *= x;
            }
            x *= x;
        }
        return y;
    }
    /// Returns a square root of x, if it has one; p = 3 modulo 4.
    [[nodiscard]] static constexpr std::optional<Residue> root(Residue x) {
        const Residue y = power(x, (prime + 1) / 4);
        return y * y == x ? std::optional(y) : std::nullopt;
    }
    /// Returns the fraction n/d with |n|, d < 2^30 that equals x modulo p; there is at most one.
    [[nodiscard]] std::optional<Rational> fraction() const {
        constexpr std::int64_t most = std::int64_t{1} << 30U;
        std::int64_t r0 = static_cast<std::int64_t>(prime);
        std::int64_t r1 = static_cast<std::int64_t>(value_);
        std::int64_t t0 = 0;
        std::int64_t t1 = 1;
        while (r1 >= most) {
            const std::int64_t q = r0 / r1;
            const std::int64_t r2 = r0 - q * r1;
            const std::int64_t t2 = t0 - q * t1;
            r0 = r1;
            r1 = r2;
            t0 = t1;
            t1 = t2;
        }
        if (t1 == 0 || t1 >= most || t1 <= -most) {
            return {};
        }
        return t1 < 0 ? Rational(-r1, -t1) : Rational(r1, t1);
    }

private:
    std::uint64_t value_ = 0;
};

/// Numbers modulo a prime for the free symbols of a contact (a, b, P1, P2, ..., b1, ..., Q, sig0
/// and any others), drawn on first use, and the values computed from them: the multipliers of both
/// edges by the templates of contact/law, and the names for which the case gives formulas. Pi is
/// drawn like a symbol (it is transcendental); the only root, that of a + b, is a root modulo the
/// prime. An environment of formula::evaluate<Residue>; formulas have no other root.
class ResidueSample {
public:
    /// Throws DomainError if a + b is not a square modulo the prime, or for a division by zero;
    /// then use another seed.
    ResidueSample(const SymbolicCase& under, std::uint64_t seed);

    [[nodiscard]] Residue number(const Rational& q) const { return Residue::of(q); }
    [[nodiscard]] Residue pi() const { return pi_; }
    [[nodiscard]] Residue symbol(std::string_view name) const;

private:
    [[nodiscard]] Residue meaning(std::string_view name) const;
    [[nodiscard]] Residue pressure_multiplier(bool right, std::size_t k) const;
    [[nodiscard]] Residue shear_multiplier(bool right, std::size_t k) const;
    [[nodiscard]] Residue draw() const;

    const SymbolicCase& under_;
    mutable std::mt19937_64 random_;
    Residue pi_;
    Residue root_;
    mutable std::map<std::string, Residue, std::less<>> known_;
};

} // namespace edgeproof::audit
