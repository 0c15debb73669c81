// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/evaluation/functions.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <concepts>
#include <functional>
#include <initializer_list>
#include <map>
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
///   T binder(const Expr& node, const Scope& scope) const         integral, pv and sum: a template
/// in `Scope`, which is an environment, too; `with_symbol` adds the bound variable to it.
template <class Env, class T>
concept EnvironmentOf = requires(const Env& env, const Rational& q, std::string_view name) {
    { env.number(q) } -> std::convertible_to<T>;
    { env.pi() } -> std::convertible_to<T>;
    { env.symbol(name) } -> std::convertible_to<T>;
};

template <class T, class Env> [[nodiscard]] T evaluate(const Expr& e, const Env& env);

/// An environment with one more name, which hides an equal name of an outer scope.
template <class T, class Env> class Scoped {
public:
    Scoped(const Env& env, const Scoped* outer, std::string_view name, const T& value)
        : env_(env), outer_(outer), name_(name), value_(value) {}

    [[nodiscard]] T number(const Rational& q) const { return env_.number(q); }
    [[nodiscard]] T pi() const { return env_.pi(); }
    [[nodiscard]] T symbol(std::string_view name) const {
        if (name == name_) {
            return value_;
        }
        return outer_ != nullptr ? outer_->symbol(name) : T(env_.symbol(name));
    }
    [[nodiscard]] T call(const Expr& node, std::span<const T> args) const requires
        requires(const Env& env) {
        env.call(node, args);
    }
    { return env_.call(node, args); }
    [[nodiscard]] T binder(const Expr& node, const Scoped& scope) const requires
        requires(const Env& env) {
        env.binder(node, scope);
    }
    { return env_.binder(node, scope); }
    [[nodiscard]] const Env& base() const { return env_; }

private:
    const Env& env_;
    const Scoped* outer_;
    std::string_view name_;
    const T& value_;
};

/// Returns `scope` with `name` = `value`. The result refers to all three, which must live longer.
template <class T, class Env>
[[nodiscard]] Scoped<T, Env> with_symbol(const Env& scope, std::string_view name, const T& value) {
    return Scoped<T, Env>(scope, nullptr, name, value);
}
template <class T, class Env>
[[nodiscard]] Scoped<T, Env> with_symbol(const Scoped<T, Env>& scope, std::string_view name,
                                         const T& value) {
    return Scoped<T, Env>(scope.base(), &scope, name, value);
}

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

template <class T, class Env> T evaluate_call(const Expr& e, const Env& env) {
    std::vector<T> args;
    args.reserve(e.args().size());
    for (const Expr& x : e.args()) {
        args.push_back(evaluate<T>(x, env));
    }
    if (e.builtin() != Builtin::none) {
        return in_part(
            e, [&] { return detail::call_builtin<T>(e.builtin(), std::span<const T>(args)); });
    }
    if constexpr (requires { T(env.call(e, std::span<const T>(args))); }) {
        return T(env.call(e, std::span<const T>(args)));
    } else {
        throw Error("the function '" + e.name() + "' has no meaning here");
    }
}

template <class T, class Env> T evaluate_binder(const Expr& e, const Env& env) {
    if constexpr (requires { T(env.binder(e, env)); }) {
        return T(env.binder(e, env));
    } else {
        if (e.kind() == Expr::Kind::sum) {
            return evaluate_sum<T>(e, env);
        }
        throw Error("'" + e.name() + "' has no meaning here");
    }
}

template <class T, class Env> T evaluate_node(const Expr& e, const Env& env) {
    using Kind = Expr::Kind;
    const auto x = [&](std::size_t i) { return evaluate<T>(e.args()[i], env); };
    switch (e.kind()) {
    case Kind::pi:
        return T(env.pi());
    case Kind::symbol:
        return T(env.symbol(e.name()));
    case Kind::neg:
        return T(-x(0));
    case Kind::add:
        return T(x(0) + x(1));
    case Kind::sub:
        return T(x(0) - x(1));
    case Kind::mul:
        return T(x(0) * x(1));
    case Kind::div: {
        const T over = x(0);
        const T under = x(1);
        return in_part(e, [&] { return quotient<T>(over, under); });
    }
    case Kind::pow: {
        const T base = x(0);
        if (const Rational* q = e.arg(1).rational()) {
            return in_part(e, [&] { return power<T>(base, *q, env); });
        }
        const T exponent = x(1);
        return in_part(e, [&] { return power<T>(base, exponent); });
    }
    case Kind::call:
        return evaluate_call<T>(e, env);
    default:
        return evaluate_binder<T>(e, env);
    }
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

/// Converts an exact number to T, at the working precision. Throws DomainError for a number that
/// overflows in T or becomes zero.
template <Arithmetic T> [[nodiscard]] T number_of(const Rational& q) {
    const T x = from_rational<T>(q);
    if ((x == 0 && q != 0) || x - x != 0) {
        throw DomainError("a number beyond the range of the requested arithmetic");
    }
    return x;
}

/// An environment with the values of names, and with functions that are not built in.
template <Arithmetic T> class Values {
public:
    using Function = std::function<T(std::span<const T>)>;

    Values() = default;
    Values(std::initializer_list<std::pair<std::string_view, T>> values) {
        for (const auto& [name, value] : values) {
            set(name, value);
        }
    }

    Values& set(std::string_view name, const T& value) {
        values_.insert_or_assign(std::string(name), value);
        return *this;
    }
    Values& define(std::string_view name, Function f) {
        functions_.insert_or_assign(std::string(name), std::move(f));
        return *this;
    }

    [[nodiscard]] T number(const Rational& q) const { return number_of<T>(q); }
    [[nodiscard]] T pi() const { return edgeproof::pi<T>(); }
    /// Throws Error for a name that has no value.
    [[nodiscard]] T symbol(std::string_view name) const {
        const auto it = values_.find(name);
        if (it == values_.end()) {
            throw Error("'" + std::string(name) + "' has no value here");
        }
        return it->second;
    }
    [[nodiscard]] T call(const Expr& node, std::span<const T> args) const {
        const auto it = functions_.find(node.name());
        if (it == functions_.end()) {
            throw Error("the function '" + node.name() + "' has no meaning here");
        }
        return it->second(args);
    }

private:
    std::map<std::string, T, std::less<>> values_;
    std::map<std::string, Function, std::less<>> functions_;
};

} // namespace edgeproof::formula
