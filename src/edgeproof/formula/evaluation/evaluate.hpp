// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/evaluation/functions.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/real.hpp"

#include <concepts>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::formula {

/// The requirements of an evaluation in T on its environment:
///   T number(const Rational&) const        a number, or the value of a rational part
///   T pi() const
///   T symbol(std::string_view) const       throws for an unknown name
/// and, if the formula contains them,
///   T call(const Expr& node, std::span<const T> args) const      functions that are not built in
///   T binder(const Expr& node) const                             integral, pv and sum
template <class Env, class T>
concept EnvironmentOf = requires(const Env& env, const Rational& q, std::string_view name) {
    { env.number(q) } -> std::convertible_to<T>;
    { env.pi() } -> std::convertible_to<T>;
    { env.symbol(name) } -> std::convertible_to<T>;
};

template <class T, class Env> [[nodiscard]] T evaluate(const Expr& e, const Env& env);

/// Returns the message of a DomainError in a formula together with the part in which it occurred.
[[nodiscard]] std::string inside(const std::string& what, const Expr& part);

/// Returns the bounds lo and hi of a sum, which must be exact integers. Throws DomainError for
/// other bounds, BudgetError for more than 100,000 terms.
[[nodiscard]] std::pair<long, long> sum_bounds(const Expr& node);

template <class T, class Env> [[nodiscard]] T evaluate_sum(const Expr& node, const Env& env) {
    const auto [lo, hi] = sum_bounds(node);
    T total = env.number(Rational(0));
    for (long k = lo; k <= hi; ++k) {
        // k is substituted as an exact number, so that an exponent k remains an integer.
        const Expr term = substitute(node.arg(0), node.arg(1).name(), Expr::number(Rational(k)));
        total = T(total + evaluate<T>(term, env));
    }
    return total;
}

namespace detail {

/// Calls operation(); the message of its DomainError then names `part`.
template <class Operation> auto in_part(const Expr& part, const Operation& operation) {
    try {
        return operation();
    } catch (const DomainError& error) {
        throw DomainError(inside(error.what(), part));
    }
}

/// Returns the value of an operation, or a built-in function, from the values x(0), x(1), ... of
/// its operands.
template <class T, class Operands> T value_of(const Expr& e, const Operands& x) {
    using Kind = Expr::Kind;
    switch (e.kind()) {
    case Kind::neg:
        return T(-x(0));
    case Kind::add:
        return T(x(0) + x(1));
    case Kind::sub:
        return T(x(0) - x(1));
    case Kind::mul:
        return T(x(0) * x(1));
    case Kind::div: {
        const auto& over = x(0);
        const auto& under = x(1);
        return in_part(e, [&] { return T(over / under); });
    }
    case Kind::pow: {
        const auto& base = x(0);
        if (const Rational* q = e.arg(1).rational()) {
            return in_part(e, [&] { return T(pow(base, *q)); });
        }
        const auto& exponent = x(1);
        return in_part(e, [&] { return T(pow(base, exponent)); });
    }
    default: {
        if (e.kind() != Kind::call || e.builtin() == Builtin::none) {
            throw Error((e.is_binder() ? "'" : "the function '") + e.name() +
                        "' has no meaning here");
        }
        std::vector<T> args;
        args.reserve(e.args().size());
        for (std::size_t i = 0; i < e.args().size(); ++i) {
            args.push_back(x(i));
        }
        return in_part(e, [&] { return call_builtin<T>(e.builtin(), std::span<const T>(args)); });
    }
    }
}

template <class T, class Env> T evaluate_node(const Expr& e, const Env& env) {
    using Kind = Expr::Kind;
    const auto operand = [&](std::size_t i) { return evaluate<T>(e.args()[i], env); };
    if (e.kind() == Kind::pi) {
        return T(env.pi());
    }
    if (e.kind() == Kind::symbol) {
        return T(env.symbol(e.name()));
    }
    if (e.is_binder()) {
        if constexpr (requires { T(env.binder(e)); }) {
            return T(env.binder(e));
        } else if (e.kind() == Kind::sum) {
            return evaluate_sum<T>(e, env);
        }
    } else if (e.kind() == Kind::call && e.builtin() == Builtin::none) {
        if constexpr (requires { *env.elsewhere(e); }) { // a formula in another scene
            if (const auto value = env.elsewhere(e)) {
                return T(*value);
            }
        }
        if constexpr (requires(std::span<const T> args) { T(env.call(e, args)); }) {
            std::vector<T> args;
            args.reserve(e.args().size());
            for (std::size_t i = 0; i < e.args().size(); ++i) {
                args.push_back(operand(i));
            }
            return T(env.call(e, std::span<const T>(args)));
        }
    }
    return value_of<T>(e, operand);
}

} // namespace detail

/// Returns the value of e. Rational parts are exact until `env.number` rounds them once. Throws
/// DomainError where e is undefined (the message names the part), and Error for a function or
/// binder that neither T nor env defines.
template <class T, class Env> T evaluate(const Expr& e, const Env& env) {
    static_assert(EnvironmentOf<Env, T>);
    check_interruption();
    if (const Rational* q = e.rational()) {
        return T(env.number(*q));
    }
    return detail::evaluate_node<T>(e, env);
}

} // namespace edgeproof::formula
