// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/evaluation/real_functions.hpp"

#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/hypot.hpp>

#include <cmath>
#include <string>

namespace edgeproof::formula {
namespace {

[[noreturn]] void outside(Builtin f, const char* domain) {
    throw DomainError(std::string(name_of(f)) + " of a number that is " + domain);
}

// --- Real: MPFR's functions, each correctly rounded

using UnaryMpfr = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using BinaryMpfr = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

/// Returns a new Real with at least the digits of x.
Real as_wide_as(const Real& x) {
    Real y;
    if (mpfr_get_prec(y.backend().data()) < mpfr_get_prec(x.backend().data())) {
        mpfr_set_prec(y.backend().data(), mpfr_get_prec(x.backend().data()));
    }
    return y;
}

Real rounded(UnaryMpfr f, const Real& x) {
    Real y = as_wide_as(x);
    f(y.backend().data(), x.backend().data(), MPFR_RNDN);
    return y;
}

Real rounded(BinaryMpfr f, const Real& x1, const Real& x2) {
    const bool first = mpfr_get_prec(x1.backend().data()) > mpfr_get_prec(x2.backend().data());
    Real y = as_wide_as(first ? x1 : x2);
    f(y.backend().data(), x1.backend().data(), x2.backend().data(), MPFR_RNDN);
    return y;
}

Real elementary(Builtin f, std::span<const Real> x) {
    switch (f) {
    case Builtin::sqrt:
        return rounded(mpfr_sqrt, x[0]);
    case Builtin::exp:
        return rounded(mpfr_exp, x[0]);
    case Builtin::log:
        return rounded(mpfr_log, x[0]);
    case Builtin::sin:
        return rounded(mpfr_sin, x[0]);
    case Builtin::cos:
        return rounded(mpfr_cos, x[0]);
    case Builtin::tan:
        return rounded(mpfr_tan, x[0]);
    case Builtin::asin:
        return rounded(mpfr_asin, x[0]);
    case Builtin::acos:
        return rounded(mpfr_acos, x[0]);
    case Builtin::atan:
        return rounded(mpfr_atan, x[0]);
    case Builtin::atan2:
        return rounded(mpfr_atan2, x[0], x[1]);
    case Builtin::sinh:
        return rounded(mpfr_sinh, x[0]);
    case Builtin::cosh:
        return rounded(mpfr_cosh, x[0]);
    case Builtin::tanh:
        return rounded(mpfr_tanh, x[0]);
    case Builtin::asinh:
        return rounded(mpfr_asinh, x[0]);
    case Builtin::acosh:
        return rounded(mpfr_acosh, x[0]);
    case Builtin::atanh:
        return rounded(mpfr_atanh, x[0]);
    case Builtin::gamma:
        return rounded(mpfr_gamma, x[0]);
    case Builtin::hypot:
        return rounded(mpfr_hypot, x[0], x[1]);
    default:
        return x[0];
    }
}

// --- double, long double, Float128

template <class T> T elementary(Builtin f, std::span<const T> x) {
    using std::acos;
    using std::acosh;
    using std::asin;
    using std::asinh;
    using std::atan;
    using std::atan2;
    using std::atanh;
    using std::cos;
    using std::cosh;
    using std::exp;
    using std::log;
    using std::sin;
    using std::sinh;
    using std::sqrt;
    using std::tan;
    using std::tanh;
    switch (f) {
    case Builtin::sqrt:
        return sqrt(x[0]);
    case Builtin::exp:
        return exp(x[0]);
    case Builtin::log:
        return log(x[0]);
    case Builtin::sin:
        return sin(x[0]);
    case Builtin::cos:
        return cos(x[0]);
    case Builtin::tan:
        return tan(x[0]);
    case Builtin::asin:
        return asin(x[0]);
    case Builtin::acos:
        return acos(x[0]);
    case Builtin::atan:
        return atan(x[0]);
    case Builtin::atan2:
        return atan2(x[0], x[1]);
    case Builtin::sinh:
        return sinh(x[0]);
    case Builtin::cosh:
        return cosh(x[0]);
    case Builtin::tanh:
        return tanh(x[0]);
    case Builtin::asinh:
        return asinh(x[0]);
    case Builtin::acosh:
        return acosh(x[0]);
    case Builtin::atanh:
        return atanh(x[0]);
    case Builtin::gamma:
        if constexpr (std::same_as<T, Float128>) {
            return boost::math::tgamma(x[0]);
        } else {
            return std::tgamma(x[0]);
        }
    case Builtin::hypot:
        return boost::math::hypot(x[0], x[1]);
    default:
        return x[0];
    }
}

template <class T> bool is_integer(const T& x) {
    using std::floor;
    return floor(x) == x;
}

template <class T> void check_domain(Builtin f, std::span<const T> x) {
    switch (f) {
    case Builtin::sqrt:
        if (x[0] < 0) {
            outside(f, "negative");
        }
        return;
    case Builtin::log:
        if (!(x[0] > 0)) {
            outside(f, "not positive");
        }
        return;
    case Builtin::asin:
    case Builtin::acos:
        if (x[0] < -1 || x[0] > 1) {
            outside(f, "outside -1 ... 1");
        }
        return;
    case Builtin::acosh:
        if (x[0] < 1) {
            outside(f, "less than 1");
        }
        return;
    case Builtin::atanh:
        if (!(x[0] > -1 && x[0] < 1)) {
            outside(f, "not between -1 and 1");
        }
        return;
    case Builtin::gamma:
        if (!(x[0] > 0) && is_integer(x[0])) {
            outside(f, "zero or a negative integer");
        }
        return;
    case Builtin::atan2:
        if (x[0] == 0 && x[1] == 0) {
            throw DomainError("atan2 of two zeros");
        }
        return;
    default:
        return;
    }
}

template <class T> T sign_of(const T& x) { return x > 0 ? T(1) : x < 0 ? T(-1) : T(0); }

/// Returns x^(n/2) for odd n.
template <class T> T half_integer_power(const T& x, long n) {
    const T root = elementary(Builtin::sqrt, std::span<const T>(&x, 1));
    const long whole = (n < 0 ? -n : n) / 2;
    const T y = whole == 0 ? root : T(pow_int(x, whole) * root);
    return n < 0 ? T(T(1) / y) : y;
}

/// Returns x^q for x > 0. Intermediate results have 64 more bits, so that only the last rounding
/// matters.
Real power_with_guard(const Real& x, const Rational& q) {
    constexpr mpfr_prec_t guard = 64;
    Real y = as_wide_as(x);
    const mpfr_prec_t precision = mpfr_get_prec(y.backend().data());
    Real wide;
    mpfr_set_prec(wide.backend().data(), precision + guard);
    if (const auto small = small_fraction(q); small && small->d == 2) {
        Real whole;
        mpfr_set_prec(whole.backend().data(), precision + guard);
        const long n = small->n;
        mpfr_sqrt(wide.backend().data(), x.backend().data(), MPFR_RNDN);
        mpfr_pow_si(whole.backend().data(), x.backend().data(), (n < 0 ? -n : n) / 2, MPFR_RNDN);
        mpfr_mul(wide.backend().data(), wide.backend().data(), whole.backend().data(), MPFR_RNDN);
        if (n < 0) {
            mpfr_ui_div(y.backend().data(), 1, wide.backend().data(), MPFR_RNDN);
        } else {
            mpfr_set(y.backend().data(), wide.backend().data(), MPFR_RNDN);
        }
    } else {
        mpfr_set_q(wide.backend().data(), q.backend().data(), MPFR_RNDN);
        mpfr_pow(y.backend().data(), x.backend().data(), wide.backend().data(), MPFR_RNDN);
    }
    return y;
}

} // namespace

std::optional<SmallFraction> small_fraction(const Rational& q) {
    constexpr long largest = 1'000'000'000'000;
    const auto* raw = q.backend().data();
    if (mpz_cmpabs_ui(mpq_numref(raw), largest) > 0 || mpz_fits_ulong_p(mpq_denref(raw)) == 0) {
        return std::nullopt;
    }
    return SmallFraction{mpz_get_si(mpq_numref(raw)), mpz_get_ui(mpq_denref(raw))};
}

template <Arithmetic T> T real_call(Builtin f, std::span<const T> x) {
    check_domain(f, x);
    switch (f) {
    case Builtin::abs:
        return x[0] < 0 ? T(-x[0]) : x[0];
    case Builtin::sgn:
        return sign_of(x[0]);
    case Builtin::step:
        return (T(1) + sign_of(x[0])) / T(2);
    case Builtin::max:
    case Builtin::min: {
        const T* best = &x[0];
        for (const T& y : x.subspan(1)) {
            if (f == Builtin::max ? *best < y : y < *best) {
                best = &y;
            }
        }
        return *best;
    }
    case Builtin::none:
        throw Error("a function that is not built in was called as one");
    default:
        return elementary(f, x);
    }
}

template <Arithmetic T> T pow_int(const T& x, long n) {
    if (n < 0 && x == 0) {
        throw DomainError("zero to a negative power");
    }
    if constexpr (std::same_as<T, Real>) {
        Real y = as_wide_as(x);
        mpfr_pow_si(y.backend().data(), x.backend().data(), n, MPFR_RNDN);
        return y;
    } else {
        using std::pow;
        constexpr long few = 8; // beyond this the power function of the C library is more accurate
        constexpr long exact_in_double = 1L << 53U;
        if (n >= 0 && n <= few) {
            return n == 0 ? T(1) : repeated_product(x, static_cast<unsigned long>(n));
        }
        if (n < 0 && n >= -few) {
            return T(1) / repeated_product(x, static_cast<unsigned long>(-n));
        }
        if (n >= -exact_in_double && n <= exact_in_double) {
            return pow(x, static_cast<T>(n));
        }
        const unsigned long size =
            n < 0 ? 0UL - static_cast<unsigned long>(n) : static_cast<unsigned long>(n);
        const T y = repeated_product(x, size);
        return n < 0 ? T(T(1) / y) : y;
    }
}

template <Arithmetic T> T real_power(const T& x, const T& y) {
    if (x == 0 && y < 0) {
        throw DomainError("zero to a negative power");
    }
    if (x < 0 && !is_integer(y)) {
        throw DomainError("a negative number to a power that is not an integer");
    }
    if constexpr (std::same_as<T, Real>) {
        return rounded(mpfr_pow, x, y);
    } else {
        using std::pow;
        return pow(x, y);
    }
}

template <Arithmetic T> T real_power(const T& x, const Rational& q) {
    const auto small = small_fraction(q);
    if (small && small->d == 1) {
        return pow_int(x, small->n);
    }
    if (x < 0 && denominator(q) != 1) {
        throw DomainError("a negative number to a power that is not an integer");
    }
    if (x == 0) {
        if (q < 0) {
            throw DomainError("zero to a negative power");
        }
        return T(0);
    }
    if constexpr (std::same_as<T, Real>) {
        return power_with_guard(x, q);
    } else {
        using std::pow;
        return small && small->d == 2 ? half_integer_power(x, small->n)
                                      : pow(x, from_rational<T>(q));
    }
}

// The four types of Arithmetic, and no others.
template double real_call(Builtin, std::span<const double>);
template long double real_call(Builtin, std::span<const long double>);
template Float128 real_call(Builtin, std::span<const Float128>);
template Real real_call(Builtin, std::span<const Real>);
template double real_power(const double&, const Rational&);
template long double real_power(const long double&, const Rational&);
template Float128 real_power(const Float128&, const Rational&);
template Real real_power(const Real&, const Rational&);
template double real_power(const double&, const double&);
template long double real_power(const long double&, const long double&);
template Float128 real_power(const Float128&, const Float128&);
template Real real_power(const Real&, const Real&);
template double pow_int(const double&, long);
template long double pow_int(const long double&, long);
template Float128 pow_int(const Float128&, long);
template Real pow_int(const Real&, long);

} // namespace edgeproof::formula
