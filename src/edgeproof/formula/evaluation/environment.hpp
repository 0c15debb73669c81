// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"

#include <functional>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace edgeproof::formula {

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
