// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"

#include <cmath>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <tuple>

/// The built-in functions for any number type. Both types of Arithmetic have all of them, with
/// checked domains. Any other type (a ball, a series, a divided difference) defines those that it
/// has, which are found by argument-dependent lookup; a formula with a function that the type lacks
/// throws Error when it is evaluated.
namespace edgeproof::formula {

/// An exponent of moderate size in lowest terms.
struct SmallFraction {
    long n;
    unsigned long d;
};
/// Nothing if |numerator| exceeds 10^12 or the denominator does not fit into d.
[[nodiscard]] std::optional<SmallFraction> small_fraction(const Rational& q);

/// The built-in functions on the real line. Each throws DomainError, with its name, outside its
/// real domain (log 0, sqrt(-1), asin 2, gamma(-1), atan2(0, 0)), and does not return nan or inf
/// for finite arguments unless the result overflows. sgn(0) = 0, step(0) = 1/2. Accuracy: `Real`
/// results are correctly rounded (MPFR), at the larger of the working precision and those of the
/// arguments; the others have the accuracy of the C library or of Boost.
template <Arithmetic T> [[nodiscard]] T real_call(Builtin f, std::span<const T> x);

/// Returns x^q for an exact exponent: q is not rounded for integers and half-integers; in `Real`
/// any other q has 64 bits more than the result. 0^0 = 1. Throws DomainError for 0 to a negative
/// power and for a negative x to a power that is not an integer.
template <Arithmetic T> [[nodiscard]] T real_power(const T& x, const Rational& q);
template <Arithmetic T> [[nodiscard]] T real_power(const T& x, const T& y);

/// Returns x^n; correctly rounded in `Real`.
template <Arithmetic T> [[nodiscard]] T pow_int(const T& x, long n);

namespace detail {

/// Returns x^n from products; `one` is 1 of the type.
template <class T> [[nodiscard]] T power_by_products(const T& x, long n, const T& one) {
    if (n == 0) {
        return one;
    }
    const auto size = static_cast<unsigned long>(n);
    const T y = repeated_product(x, n < 0 ? 0UL - size : size);
    return n < 0 ? T(one / y) : y;
}

namespace adl {

// The functions of the C++ library serve double; those of other types are found
// through their arguments.
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
// Deleted, so that lookup stops here and finds functions only through their arguments. The global
// `gamma(double)` of <math.h>, for example, is the logarithm of the gamma function.
void abs() = delete;
void sgn() = delete;
void step() = delete;
void gamma() = delete;
void max() = delete;
void min() = delete;
void hypot() = delete;
void pow() = delete;
void pow_int() = delete;

/// A function of one argument: MPFR's for Real, and that of any other type.
template <class Function> struct Unary {
    Builtin id;
    int (*mpfr)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
    Function of;
};
template <class Function>
Unary(Builtin, int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), Function) -> Unary<Function>;

inline constexpr std::tuple unary_functions{
    Unary{Builtin::sqrt, mpfr_sqrt, [](auto& x) -> decltype(sqrt(x)) { return sqrt(x); }},
    Unary{Builtin::exp, mpfr_exp, [](auto& x) -> decltype(exp(x)) { return exp(x); }},
    Unary{Builtin::log, mpfr_log, [](auto& x) -> decltype(log(x)) { return log(x); }},
    Unary{Builtin::sin, mpfr_sin, [](auto& x) -> decltype(sin(x)) { return sin(x); }},
    Unary{Builtin::cos, mpfr_cos, [](auto& x) -> decltype(cos(x)) { return cos(x); }},
    Unary{Builtin::tan, mpfr_tan, [](auto& x) -> decltype(tan(x)) { return tan(x); }},
    Unary{Builtin::asin, mpfr_asin, [](auto& x) -> decltype(asin(x)) { return asin(x); }},
    Unary{Builtin::acos, mpfr_acos, [](auto& x) -> decltype(acos(x)) { return acos(x); }},
    Unary{Builtin::atan, mpfr_atan, [](auto& x) -> decltype(atan(x)) { return atan(x); }},
    Unary{Builtin::sinh, mpfr_sinh, [](auto& x) -> decltype(sinh(x)) { return sinh(x); }},
    Unary{Builtin::cosh, mpfr_cosh, [](auto& x) -> decltype(cosh(x)) { return cosh(x); }},
    Unary{Builtin::tanh, mpfr_tanh, [](auto& x) -> decltype(tanh(x)) { return tanh(x); }},
    Unary{Builtin::asinh, mpfr_asinh, [](auto& x) -> decltype(asinh(x)) { return asinh(x); }},
    Unary{Builtin::acosh, mpfr_acosh, [](auto& x) -> decltype(acosh(x)) { return acosh(x); }},
    Unary{Builtin::atanh, mpfr_atanh, [](auto& x) -> decltype(atanh(x)) { return atanh(x); }},
    Unary{Builtin::gamma, mpfr_gamma, [](auto& x) -> decltype(gamma(x)) { return gamma(x); }},
    Unary{Builtin::abs, nullptr, [](auto& x) -> decltype(abs(x)) { return abs(x); }},
    Unary{Builtin::sgn, nullptr, [](auto& x) -> decltype(sgn(x)) { return sgn(x); }},
    Unary{Builtin::step, nullptr, [](auto& x) -> decltype(step(x)) { return step(x); }}};

/// Calls use(row) for the row of f, if there is one.
template <class Use> void for_unary(Builtin f, const Use& use) {
    std::apply([&](const auto&... row) { (void)((row.id == f && (use(row), true)) || ...); },
               unary_functions);
}

/// Returns f(x); nothing if the type has no such function of one argument.
template <class T> [[nodiscard]] std::optional<T> unary(Builtin f, const T& x) {
    std::optional<T> y;
    for_unary(f, [&](const auto& row) {
        if constexpr (requires { T(row.of(x)); }) {
            y.emplace(row.of(x));
        }
    });
    return y;
}

template <class T> [[nodiscard]] T call(Builtin f, std::span<const T> x) {
    if (auto y = unary(f, x[0])) {
        return *std::move(y);
    }
    switch (f) {
    case Builtin::tan:
        if constexpr (requires { T(sin(x[0]) / cos(x[0])); }) {
            return T(sin(x[0]) / cos(x[0]));
        }
        break;
    case Builtin::tanh:
        if constexpr (requires { T(sinh(x[0]) / cosh(x[0])); }) {
            return T(sinh(x[0]) / cosh(x[0]));
        }
        break;
    case Builtin::step:
        if constexpr (requires { T((sgn(x[0]) + 1L) / 2L); }) {
            return T((sgn(x[0]) + 1L) / 2L);
        } else if constexpr (requires { T(sgn(x[0]) / sgn(x[0])); }) {
            const T s = sgn(x[0]);
            const T one = s * s; // s is 1 or -1 wherever such a type has a sign
            return T((one + s) / (one + one));
        }
        break;
    case Builtin::atan2:
        if constexpr (requires { T(atan2(x[0], x[1])); }) {
            return T(atan2(x[0], x[1]));
        }
        break;
    case Builtin::max:
    case Builtin::min:
        if constexpr (requires { T(max(x[0], min(x[0], x[1]))); }) {
            T y = x[0];
            for (const T& z : x.subspan(1)) {
                y = f == Builtin::max ? max(y, z) : min(y, z);
            }
            return y;
        }
        break;
    case Builtin::hypot:
        if constexpr (requires { T(hypot(x[0], x[1])); }) {
            return T(hypot(x[0], x[1]));
        } else if constexpr (requires { T(sqrt(x[0] * x[0] + x[1] * x[1])); }) {
            return T(sqrt(x[0] * x[0] + x[1] * x[1]));
        }
        break;
    default:
        break;
    }
    throw Error("'" + std::string(name_of(f)) +
                "' is not defined for the kind of number that a formula is evaluated in");
}

template <class T> [[nodiscard]] T general_power(const T& x, const T& y) {
    if constexpr (requires { T(pow(x, y)); }) {
        return T(pow(x, y));
    } else if constexpr (requires { T(exp(y * log(x))); }) {
        return T(exp(y * log(x)));
    } else {
        throw Error("a power that is not an integer is not defined for the kind of number that a "
                    "formula is evaluated in");
    }
}

template <class T, class Env>
[[nodiscard]] T rational_power(const T& x, const Rational& q, const Env& env) {
    if constexpr (requires { T(pow(x, q)); }) {
        return T(pow(x, q));
    } else {
        const auto small = small_fraction(q);
        if (small && small->d == 1) {
            if constexpr (requires { T(pow_int(x, small->n)); }) {
                return T(pow_int(x, small->n));
            } else {
                return power_by_products<T>(x, small->n, env.number(Rational(1)));
            }
        }
        if constexpr (requires { T(sqrt(x)); }) {
            if (small && small->d == 2) {
                const auto whole =
                    static_cast<unsigned long>(small->n < 0 ? -small->n : small->n) / 2;
                const T root = sqrt(x);
                const T y = whole == 0 ? root : T(repeated_product(x, whole) * root);
                return small->n < 0 ? T(env.number(Rational(1)) / y) : y;
            }
        }
        return general_power<T>(x, env.number(q));
    }
}

} // namespace adl

/// Returns the value of a built-in function. Throws DomainError outside its domain.
template <class T> [[nodiscard]] T call_builtin(Builtin f, std::span<const T> x) {
    if constexpr (Arithmetic<T>) {
        return real_call<T>(f, x);
    } else if constexpr (requires { T::call(f, x); }) { // a type with all functions, by their names
        return T::call(f, x);
    } else {
        return adl::call<T>(f, x);
    }
}

/// Returns x^q for an exact q: integer powers by multiplication, half-integer powers through the
/// square root, others by the power function of T. `env.number` converts a rational to T.
template <class T, class Env> [[nodiscard]] T power(const T& x, const Rational& q, const Env& env) {
    if constexpr (Arithmetic<T>) {
        return real_power(x, q);
    } else {
        return adl::rational_power<T>(x, q, env);
    }
}

/// Returns x^y. For both types of Arithmetic 0^0 is 1.
template <class T> [[nodiscard]] T power(const T& x, const T& y) {
    if constexpr (Arithmetic<T>) {
        return real_power(x, y);
    } else {
        return adl::general_power<T>(x, y);
    }
}

/// Returns x/y. Throws DomainError if y is zero, for both types of Arithmetic.
template <class T> [[nodiscard]] T quotient(const T& x, const T& y) {
    if constexpr (Arithmetic<T>) {
        if (y == 0) {
            throw DomainError("division by zero");
        }
    }
    return T(x / y);
}

} // namespace detail
} // namespace edgeproof::formula
