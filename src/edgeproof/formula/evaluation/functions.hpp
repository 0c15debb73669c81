// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/evaluation/real_functions.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"

#include <concepts>
#include <span>
#include <string>

/// The built-in functions for any number type. The four types of Arithmetic have all of them, with
/// checked domains (real_functions.hpp). Any other type (a ball, a series, a divided difference)
/// defines those that it has, which are found by argument-dependent lookup; a formula with a
/// function that the type lacks throws Error when it is evaluated.
namespace edgeproof::formula::detail {

namespace adl {

// Deleted, so that lookup stops here and finds functions only through their arguments. The global
// `gamma(double)` of <math.h>, for example, is the logarithm of the gamma function.
void sqrt() = delete;
void exp() = delete;
void log() = delete;
void sin() = delete;
void cos() = delete;
void tan() = delete;
void asin() = delete;
void acos() = delete;
void atan() = delete;
void atan2() = delete;
void sinh() = delete;
void cosh() = delete;
void tanh() = delete;
void asinh() = delete;
void acosh() = delete;
void atanh() = delete;
void abs() = delete;
void sgn() = delete;
void step() = delete;
void gamma() = delete;
void max() = delete;
void min() = delete;
void hypot() = delete;
void pow() = delete;
void pow_int() = delete;

[[noreturn]] inline void missing(Builtin f) {
    throw Error("'" + std::string(name_of(f)) +
                "' is not defined for the kind of number that a "
                "formula is evaluated in");
}

template <class T> [[nodiscard]] T call(Builtin f, std::span<const T> x) {
    switch (f) {
    case Builtin::sqrt:
        if constexpr (requires { T(sqrt(x[0])); }) {
            return T(sqrt(x[0]));
        }
        break;
    case Builtin::exp:
        if constexpr (requires { T(exp(x[0])); }) {
            return T(exp(x[0]));
        }
        break;
    case Builtin::log:
        if constexpr (requires { T(log(x[0])); }) {
            return T(log(x[0]));
        }
        break;
    case Builtin::sin:
        if constexpr (requires { T(sin(x[0])); }) {
            return T(sin(x[0]));
        }
        break;
    case Builtin::cos:
        if constexpr (requires { T(cos(x[0])); }) {
            return T(cos(x[0]));
        }
        break;
    case Builtin::tan:
        if constexpr (requires { T(tan(x[0])); }) {
            return T(tan(x[0]));
        } else if constexpr (requires { T(sin(x[0]) / cos(x[0])); }) {
            return T(sin(x[0]) / cos(x[0]));
        }
        break;
    case Builtin::asin:
        if constexpr (requires { T(asin(x[0])); }) {
            return T(asin(x[0]));
        }
        break;
    case Builtin::acos:
        if constexpr (requires { T(acos(x[0])); }) {
            return T(acos(x[0]));
        }
        break;
    case Builtin::atan:
        if constexpr (requires { T(atan(x[0])); }) {
            return T(atan(x[0]));
        }
        break;
    case Builtin::atan2:
        if constexpr (requires { T(atan2(x[0], x[1])); }) {
            return T(atan2(x[0], x[1]));
        }
        break;
    case Builtin::sinh:
        if constexpr (requires { T(sinh(x[0])); }) {
            return T(sinh(x[0]));
        }
        break;
    case Builtin::cosh:
        if constexpr (requires { T(cosh(x[0])); }) {
            return T(cosh(x[0]));
        }
        break;
    case Builtin::tanh:
        if constexpr (requires { T(tanh(x[0])); }) {
            return T(tanh(x[0]));
        } else if constexpr (requires { T(sinh(x[0]) / cosh(x[0])); }) {
            return T(sinh(x[0]) / cosh(x[0]));
        }
        break;
    case Builtin::asinh:
        if constexpr (requires { T(asinh(x[0])); }) {
            return T(asinh(x[0]));
        }
        break;
    case Builtin::acosh:
        if constexpr (requires { T(acosh(x[0])); }) {
            return T(acosh(x[0]));
        }
        break;
    case Builtin::atanh:
        if constexpr (requires { T(atanh(x[0])); }) {
            return T(atanh(x[0]));
        }
        break;
    case Builtin::abs:
        if constexpr (requires { T(abs(x[0])); }) {
            return T(abs(x[0]));
        }
        break;
    case Builtin::sgn:
        if constexpr (requires { T(sgn(x[0])); }) {
            return T(sgn(x[0]));
        }
        break;
    case Builtin::step:
        if constexpr (requires { T(step(x[0])); }) {
            return T(step(x[0]));
        } else if constexpr (requires { T(sgn(x[0]) / sgn(x[0])); }) {
            const T s = sgn(x[0]);
            const T one = s * s; // s is 1 or -1 wherever such a type has a sign
            return T((one + s) / (one + one));
        }
        break;
    case Builtin::gamma:
        if constexpr (requires { T(gamma(x[0])); }) {
            return T(gamma(x[0]));
        }
        break;
    case Builtin::max:
        if constexpr (requires { T(max(x[0], x[1])); }) {
            T y = max(x[0], x[1]);
            for (const T& z : x.subspan(2)) {
                y = max(y, z);
            }
            return y;
        }
        break;
    case Builtin::min:
        if constexpr (requires { T(min(x[0], x[1])); }) {
            T y = min(x[0], x[1]);
            for (const T& z : x.subspan(2)) {
                y = min(y, z);
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
    case Builtin::none:
        break;
    }
    missing(f);
}

/// Returns x^n; `one` is 1 of the type.
template <class T> [[nodiscard]] T integer_power(const T& x, long n, const T& one) {
    if constexpr (requires { T(pow_int(x, n)); }) {
        return T(pow_int(x, n));
    } else {
        if (n == 0) {
            return one;
        }
        const unsigned long size =
            n < 0 ? 0UL - static_cast<unsigned long>(n) : static_cast<unsigned long>(n);
        const T y = repeated_product(x, size);
        return n < 0 ? T(one / y) : y;
    }
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
            return integer_power<T>(x, small->n, env.number(Rational(1)));
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

/// Returns x^y. For the four types of Arithmetic 0^0 is 1.
template <class T> [[nodiscard]] T power(const T& x, const T& y) {
    if constexpr (Arithmetic<T>) {
        return real_power(x, y);
    } else {
        return adl::general_power<T>(x, y);
    }
}

/// Returns x/y. Throws DomainError if y is zero, for the four types of Arithmetic.
template <class T> [[nodiscard]] T quotient(const T& x, const T& y) {
    if constexpr (Arithmetic<T>) {
        if (y == 0) {
            throw DomainError("division by zero");
        }
    }
    return T(x / y);
}

} // namespace edgeproof::formula::detail
