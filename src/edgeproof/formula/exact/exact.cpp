// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/exact/exact.hpp"

#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <limits>
#include <string>
#include <utility>

namespace edgeproof::formula {

namespace {

constexpr long most_bits = 4096;
constexpr std::size_t most_shown = 100; ///< bytes of an expression in a message

template <class T> mpfr_prec_t bits_of_arithmetic() {
    if constexpr (std::same_as<T, Real>) {
        return mpfr_get_prec(Real().backend().data());
    } else {
        return std::numeric_limits<T>::digits;
    }
}

/// Encloses a constant with more bits until look(ball) is true; false if it is true for none.
/// `offset` is added to the bits.
template <class Look> bool look_closer_at(const Expr& e, const Look& look, long offset = 0) {
    for (long bits = 64; bits <= most_bits; bits *= 2) {
        if (const auto x = enclose(e, bits + offset); x && look(*x)) {
            return true;
        }
    }
    return false;
}

/// Throws Error if e contains a name or an integral; DomainError, with the innermost part in
/// question, if balls do not prove that e has a real value.
void check_defined(const Expr& e) {
    if (e.rational() != nullptr || look_closer_at(e, [](const Ball&) { return true; })) {
        return;
    }
    if (!e.is_binder()) {
        for (const Expr& part : e.args()) {
            check_defined(part);
        }
    }
    // With the operands these have values, which are enclosed unless they overflow.
    const bool overflows =
        e.builtin() == Builtin::exp ||
        (e.kind() == Expr::Kind::pow && certainly_positive(enclosed_constant(e.arg(0), most_bits)));
    throw DomainError(
        shortened(to_text(e), most_shown) +
        (overflows ? " is beyond the range of numbers" : " has no value that can be enclosed"));
}

/// Throws for much smaller or larger numbers, which would take unlimited time elsewhere. The limit
/// is far beyond any practical number.
void check_magnitude(const Expr& e, std::string_view text) {
    const Ball greatest = pow_int(Ball(10, 64), 100'000);
    const Ball least = 1 / greatest;
    static_cast<void>(look_closer_at(e, [&](const Ball& x) {
        const Ball size = abs(x);
        if (certainly_less(greatest, size) ||
            (certainly_less(size, least) && !contains_zero(size))) {
            throw FormulaError("'" + shortened(text, 60) + "' is beyond the range of numbers",
                               "write a number between 1e-100000 and 1e100000");
        }
        return x.is_exact() || (certainly_less(least, size) && certainly_less(size, greatest));
    }));
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
        throw FormulaError(error.what(), "write a constant with a real value");
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
    T rounded{};
    const auto both_ends_round_to_it = [&](const Ball& x) {
        const Real lower = x.lower();
        rounded = rounded_to<T>(lower);
        const bool same = rounded == rounded_to<T>(x.upper());
        if (same) {
            check_range(rounded, lower);
        }
        return same;
    };
    if (!look_closer_at(expr_, both_ends_round_to_it, bits)) {
        throw BudgetError(std::to_string(most_bits) + " bits do not decide the rounding of '" +
                          shortened(text_, most_shown) + "'");
    }
    return rounded;
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
    int sign = 0;
    const auto has_sign = [&](const Ball& x) {
        sign = x.midpoint().sign();
        return certainly_positive(x) || certainly_negative(x) || x.is_exact();
    };
    if (!look_closer_at(expr_, has_sign)) {
        throw BudgetError(std::to_string(most_bits) + " bits do not distinguish '" +
                          shortened(text_, most_shown) + "' from zero");
    }
    return sign;
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
