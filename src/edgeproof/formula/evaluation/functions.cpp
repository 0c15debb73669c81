// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/evaluation/functions.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/hypot.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace edgeproof::formula {
namespace {

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

/// The functions of one argument, atan2 and hypot.
template <class T> T elementary(Builtin f, std::span<const T> x) {
    using std::atan2;
    if constexpr (std::same_as<T, Real>) {
        if (x.size() == 2) {
            return rounded(f == Builtin::atan2 ? mpfr_atan2 : mpfr_hypot, x[0], x[1]);
        }
        UnaryMpfr of = nullptr;
        detail::adl::for_unary(f, [&](const auto& row) { of = row.mpfr; });
        return rounded(of, x[0]);
    } else if (x.size() == 2) {
        return f == Builtin::atan2 ? T(atan2(x[0], x[1])) : boost::math::hypot(x[0], x[1]);
    } else if (f == Builtin::gamma) {
        return std::tgamma(x[0]);
    } else {
        return detail::adl::unary(f, x[0]).value();
    }
}

template <class T> bool is_integer(const T& x) {
    using std::floor;
    return floor(x) == x;
}

/// Returns a description of x if f is not defined there, else nullptr.
template <class T> const char* outside_domain(Builtin f, const T& x) {
    switch (f) {
    case Builtin::sqrt:
        return x < 0 ? "negative" : nullptr;
    case Builtin::log:
        return x > 0 ? nullptr : "not positive";
    case Builtin::asin:
    case Builtin::acos:
        return x < -1 || x > 1 ? "outside -1 ... 1" : nullptr;
    case Builtin::acosh:
        return x < 1 ? "less than 1" : nullptr;
    case Builtin::atanh:
        return x > -1 && x < 1 ? nullptr : "not between -1 and 1";
    case Builtin::gamma:
        return !(x > 0) && is_integer(x) ? "zero or a negative integer" : nullptr;
    default:
        return nullptr;
    }
}

template <class T> void check_domain(Builtin f, std::span<const T> x) {
    if (f == Builtin::atan2 && x[0] == 0 && x[1] == 0) {
        throw DomainError("atan2 of two zeros");
    }
    if (const char* const domain = outside_domain(f, x[0])) {
        throw DomainError(std::string(name_of(f)) + " of a number that is " + domain);
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
    constexpr auto largest = static_cast<unsigned long>(std::min<std::int64_t>(
        1'000'000'000'000, std::numeric_limits<long>::max())); // long has 32 bits in WebAssembly
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
        constexpr unsigned long few =
            8; // beyond this the power function of the C library is more accurate
        constexpr std::uint64_t exact_in_double = std::uint64_t{1} << 53U;
        const std::uint64_t size =
            n < 0 ? 0UL - static_cast<unsigned long>(n) : static_cast<unsigned long>(n);
        return size <= few || size > exact_in_double ? detail::power_by_products(x, n, T(1))
                                                     : pow(x, static_cast<T>(n));
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

#define EDGEPROOF_INSTANTIATE(T)                                                                   \
    template T real_call(Builtin, std::span<const T>);                                             \
    template T real_power(const T&, const Rational&);                                              \
    template T real_power(const T&, const T&);                                                     \
    template T pow_int(const T&, long);
EDGEPROOF_FOR_EACH_ARITHMETIC(EDGEPROOF_INSTANTIATE)
#undef EDGEPROOF_INSTANTIATE

} // namespace edgeproof::formula
