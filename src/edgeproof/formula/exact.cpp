// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact.hpp"

#include "edgeproof/formula/environment.hpp"
#include "edgeproof/formula/evaluate.hpp"
#include "edgeproof/formula/parse.hpp"

#include <limits>
#include <utility>

namespace edgeproof {
namespace {

Real value_at(const Expr& e, unsigned digits) {
    const PrecisionScope scope(digits);
    return evaluate<Real>(e, Values<Real>{});
}

constexpr unsigned most_digits = 2500;

template <class T> mpfr_prec_t bits_of_arithmetic() {
    if constexpr (std::same_as<T, Real>) {
        return mpfr_get_prec(Real().backend().data());
    } else {
        return std::numeric_limits<T>::digits;
    }
}

/// q cut off after `bits` bits, the last of them 1 if anything was cut (rounding to odd): rounding
/// this to any shorter format is rounding q.
Real sticky(const Rational& q, mpfr_prec_t bits) {
    Real x;
    mpfr_set_prec(x.backend().data(), bits);
    const int cut = mpfr_set_q(x.backend().data(), q.backend().data(), MPFR_RNDZ);
    if (cut != 0 && mpfr_min_prec(x.backend().data()) < bits) {
        if (q > 0) {
            mpfr_nextabove(x.backend().data());
        } else {
            mpfr_nextbelow(x.backend().data());
        }
    }
    return x;
}

/// x rounded once to T. Throws DomainError if it overflows, or vanishes and x does not.
template <class T> T nearest(const Real& x) {
    T y;
    if constexpr (std::same_as<T, Real>) {
        mpfr_set(y.backend().data(), x.backend().data(), MPFR_RNDN);
    } else if constexpr (std::same_as<T, double>) {
        y = mpfr_get_d(x.backend().data(), MPFR_RNDN);
    } else if constexpr (std::same_as<T, long double>) {
        y = mpfr_get_ld(x.backend().data(), MPFR_RNDN);
    } else {
        Real narrow = x;
        mpfr_prec_round(narrow.backend().data(), bits_of_arithmetic<T>(), MPFR_RNDN);
        y = narrow.convert_to<T>();
    }
    if (y - y != 0 || (y == 0 && x != 0)) {
        throw DomainError("a number beyond the range of the arithmetic asked for");
    }
    return y;
}

} // namespace

Exact::Exact() : text_("0") {}

Exact Exact::parse(std::string_view text) {
    Expr e = edgeproof::parse(text);
    if (e.rational() == nullptr) {
        try {
            (void)value_at(e, 30);
        } catch (const Error& error) { // no real value, or an integral
            throw FormulaError(error.what(), "write a constant with a real value", 0);
        }
    }
    return {std::string(text), std::move(e)};
}

Exact::Exact(Expr e) : text_(to_text(e)), expr_(std::move(e)) {
    if (expr_.rational() == nullptr) {
        (void)value_at(expr_, 30);
    }
}

Exact Exact::of(const Rational& q) {
    Expr e = Expr::number(q);
    return {to_text(e), std::move(e)};
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
        return nearest<T>(sticky(rational(), bits + 2));
    }
    // Digits are added until they change the rounded value no more.
    unsigned digits = digits_of<T>() + 20;
    const unsigned most = digits + most_digits;
    T last = nearest<T>(value_at(expr_, digits));
    for (;;) {
        digits = digits + digits / 2;
        if (digits > most) {
            throw BudgetError("'" + text_ + "' is not settled by 4096 bits");
        }
        const T next = nearest<T>(value_at(expr_, digits));
        if (next == last) {
            return next;
        }
        last = next;
    }
}

template double Exact::to() const;
template long double Exact::to() const;
template Float128 Exact::to() const;
template Real Exact::to() const;

int Exact::sign() const {
    if (is_rational()) {
        return rational().sign();
    }
    if (expr_.kind() == Expr::Kind::sub && expr_.arg(0) == expr_.arg(1)) {
        return 0;
    }
    for (unsigned digits = 40; digits <= most_digits; digits *= 2) {
        const Real x = value_at(expr_, digits);
        const PrecisionScope scope(digits);
        if (abs(x) > pow(Real(10), -static_cast<int>(digits / 2))) {
            return x.sign();
        }
    }
    throw BudgetError("4096 bits do not tell '" + text_ + "' from zero");
}

} // namespace edgeproof
