// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact/exact.hpp"

#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <cstdlib>
#include <limits>
#include <string>
#include <utility>

namespace edgeproof::formula {

namespace {

Real value_at(const Expr& e, unsigned digits) {
    const PrecisionScope scope(digits);
    return evaluate<Real>(e, Values<Real>{});
}

constexpr long most_bits = 4096;
constexpr std::size_t most_shown = 100; ///< bytes of an expression in a message

template <class T> mpfr_prec_t bits_of_arithmetic() {
    if constexpr (std::same_as<T, Real>) {
        return mpfr_get_prec(Real().backend().data());
    } else {
        return std::numeric_limits<T>::digits;
    }
}

/// Throws Error if e has no value: if it contains a name or an integral, or has no real value
/// (DomainError).
void check_defined(const Expr& e) {
    if (e.rational() != nullptr) {
        return;
    }
    try {
        (void)value_at(e, 30);
    } catch (const DomainError&) {
        // With 30 digits the root of a small positive number may look like that of a negative one.
        for (long bits = 256; bits <= most_bits; bits *= 2) {
            if (enclose(e, bits)) {
                return;
            }
        }
        throw;
    }
}

/// Throws for much smaller or larger numbers, which would take unlimited time elsewhere. The limit
/// is far beyond any practical number.
void check_magnitude(const Expr& e, std::string_view text) {
    constexpr mpfr_exp_t most_bits_of_magnitude = 332'194; // 10^100000
    const PrecisionScope scope(30);
    const Rational* q = e.rational();
    mpfr_clear_flags();
    const Real x = q != nullptr ? from_rational<Real>(*q) : value_at(e, 30);
    const auto* const raw = x.backend().data();
    const bool beyond =
        mpfr_zero_p(raw) != 0
            ? mpfr_underflow_p() != 0 || mpfr_overflow_p() != 0
            : mpfr_number_p(raw) == 0 || std::abs(mpfr_get_exp(raw)) > most_bits_of_magnitude;
    if (beyond) {
        throw FormulaError("'" + shortened(text, 60) + "' is beyond the range of numbers",
                           "write a number between 1e-100000 and 1e100000", 0);
    }
}

template <class T> T rounded_to(const Real& x) {
    if constexpr (std::same_as<T, Real>) {
        return at_working_precision(x);
    } else {
        return mpfr_get_d(x.backend().data(), MPFR_RNDN);
    }
}

template <class T> void check_range(const T& rounded, const Real& x) {
    if (rounded - rounded != 0 || (rounded == 0 && x != 0)) {
        throw DomainError("a number beyond the range of the requested arithmetic");
    }
}

} // namespace

Exact::Exact() : text_("0") {}

Exact Exact::parse(std::string_view text) {
    Expr e = formula::parse(text);
    try {
        check_defined(e);
    } catch (const Error& error) {
        throw FormulaError(error.what(), "write a constant with a real value", 0);
    }
    check_magnitude(e, text);
    return {std::string(text), std::move(e)};
}

Exact::Exact(Expr e) : text_(to_text(e)), expr_(std::move(e)) { check_defined(expr_); }

Exact Exact::of(const Rational& q) {
    Expr e = Expr::number(q);
    std::string text = to_text(e);
    return {std::move(text), std::move(e)};
}

const Rational& Exact::rational() const {
    if (!is_rational()) {
        throw Error("'" + text_ + "' is not a rational number");
    }
    return *expr_.rational();
}

template <Arithmetic T> T Exact::to() const {
    const mpfr_prec_t bits = bits_of_arithmetic<T>();
    if (is_rational()) {
        const Real x = rounded_to_odd(rational(), bits + 2);
        const T y = rounded_to<T>(x);
        check_range(y, x);
        return y;
    }
    for (long more = 32; more <= most_bits; more *= 2) {
        if (const auto x = enclose(expr_, bits + more)) {
            // If both ends round to one number, so do all numbers between them.
            const Real lower = x->lower();
            const T low = rounded_to<T>(lower);
            if (low == rounded_to<T>(x->upper())) {
                check_range(low, lower);
                return low;
            }
        }
    }
    throw BudgetError(std::to_string(most_bits) + " bits do not decide the rounding of '" +
                      shortened(text_, most_shown) + "'");
}

#define EDGEPROOF_EXACT_TO(T) template T Exact::to() const;
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_EXACT_TO)
#undef EDGEPROOF_EXACT_TO

int Exact::sign() const {
    if (is_rational()) {
        return rational().sign();
    }
    if (expr_.kind() == Expr::Kind::sub && expr_.arg(0) == expr_.arg(1)) {
        return 0;
    }
    for (long bits = 64; bits <= most_bits; bits *= 2) {
        if (const auto x = enclose(expr_, bits)) {
            if (certainly_positive(*x) || certainly_negative(*x) || x->is_exact()) {
                return x->midpoint().sign();
            }
        }
    }
    throw BudgetError(std::to_string(most_bits) + " bits do not distinguish '" +
                      shortened(text_, most_shown) + "' from zero");
}

std::optional<Ball> enclose(const Expr& constant, long bits) {
    const Ball ball = enclosed_constant(constant, bits);
    return ball.is_finite() ? std::optional(ball.with_bits(bits + 2)) : std::nullopt;
}

Ball BallConstants::symbol(std::string_view name) {
    throw Error("the constant has a variable " + std::string(name));
}

Ball enclosed_constant(const Expr& e, long bits) { return evaluate<Ball>(e, BallConstants{bits}); }

Ball enclosed_constant(const Exact& x, long bits) { return enclosed_constant(x.expr(), bits); }

Ball ball_of(const Exact& x, long bits) {
    if (x.is_rational()) {
        return Ball(x.rational(), bits);
    }
    const auto e = enclose(x.expr(), bits);
    if (!e) {
        throw BudgetError("'" + x.text() + "' cannot be enclosed");
    }
    return Ball::from_interval(e->lower(), e->upper(), bits);
}

long bits_for(unsigned digits) { return static_cast<long>(digits) * 10 / 3 + 16; }

std::optional<Rational> rational_of(const Exact& x) {
    return x.is_rational() ? std::optional(x.rational()) : std::nullopt;
}

} // namespace edgeproof::formula
