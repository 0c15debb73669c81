// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/error.hpp"

#include <optional>
#include <span>
#include <string>
#include <tuple>

/// The built-in functions for any number type. A type (a ball, a rational function, an expansion,
/// an interval with a derivative) defines those that it has, which are found by argument-dependent
/// lookup; a formula with a function that the type lacks throws Error when it is evaluated.
namespace edgeproof::formula::detail {
namespace adl {

/// A function of one argument.
template <class Function> struct Unary {
    Builtin id;
    Function of;
};
template <class Function> Unary(Builtin, Function) -> Unary<Function>;

inline constexpr std::tuple unary_functions{
    Unary{Builtin::sqrt, [](auto& x) -> decltype(sqrt(x)) { return sqrt(x); }},
    Unary{Builtin::exp, [](auto& x) -> decltype(exp(x)) { return exp(x); }},
    Unary{Builtin::log, [](auto& x) -> decltype(log(x)) { return log(x); }},
    Unary{Builtin::sin, [](auto& x) -> decltype(sin(x)) { return sin(x); }},
    Unary{Builtin::cos, [](auto& x) -> decltype(cos(x)) { return cos(x); }},
    Unary{Builtin::tan, [](auto& x) -> decltype(tan(x)) { return tan(x); }},
    Unary{Builtin::asin, [](auto& x) -> decltype(asin(x)) { return asin(x); }},
    Unary{Builtin::acos, [](auto& x) -> decltype(acos(x)) { return acos(x); }},
    Unary{Builtin::atan, [](auto& x) -> decltype(atan(x)) { return atan(x); }},
    Unary{Builtin::sinh, [](auto& x) -> decltype(sinh(x)) { return sinh(x); }},
    Unary{Builtin::cosh, [](auto& x) -> decltype(cosh(x)) { return cosh(x); }},
    Unary{Builtin::tanh, [](auto& x) -> decltype(tanh(x)) { return tanh(x); }},
    Unary{Builtin::asinh, [](auto& x) -> decltype(asinh(x)) { return asinh(x); }},
    Unary{Builtin::acosh, [](auto& x) -> decltype(acosh(x)) { return acosh(x); }},
    Unary{Builtin::atanh, [](auto& x) -> decltype(atanh(x)) { return atanh(x); }},
    Unary{Builtin::gamma, [](auto& x) -> decltype(gamma(x)) { return gamma(x); }},
    Unary{Builtin::abs, [](auto& x) -> decltype(abs(x)) { return abs(x); }},
    Unary{Builtin::sgn, [](auto& x) -> decltype(sgn(x)) { return sgn(x); }}};

/// Returns f(x); nothing if the type has no such function of one argument.
template <class T> [[nodiscard]] std::optional<T> unary(Builtin f, const T& x) {
    std::optional<T> y;
    const auto use = [&](const auto& row) {
        if constexpr (requires { T(row.of(x)); }) {
            if (row.id == f) {
                y.emplace(row.of(x));
            }
        }
    };
    std::apply([&](const auto&... row) { (use(row), ...); }, unary_functions);
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
    case Builtin::step:
        if constexpr (requires { T((sgn(x[0]) + 1L) / 2L); }) {
            return T((sgn(x[0]) + 1L) / 2L);
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

} // namespace adl

/// Returns the value of a built-in function.
template <class T> [[nodiscard]] T call_builtin(Builtin f, std::span<const T> x) {
    if constexpr (requires { T::call(f, x); }) { // a type with all functions, by their names
        return T::call(f, x);
    } else {
        return adl::call<T>(f, x);
    }
}

} // namespace edgeproof::formula::detail
