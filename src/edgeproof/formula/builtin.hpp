// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <span>
#include <string_view>

namespace edgeproof::formula {

/// The functions that every formula may use. `none` stands for a function that the environment of
/// an evaluation has to define.
enum class Builtin {
    none,
    sqrt,
    exp,
    log,
    sin,
    cos,
    tan,
    asin,
    acos,
    atan,
    atan2,
    sinh,
    cosh,
    tanh,
    asinh,
    acosh,
    atanh,
    abs,
    sgn,
    step,
    gamma,
    max,
    min,
    hypot
};

struct BuiltinInfo {
    Builtin id;
    std::string_view name;
    unsigned min_arity;
    unsigned max_arity;
};

/// All except `none`, in the order of the enumeration.
[[nodiscard]] std::span<const BuiltinInfo> builtins();
[[nodiscard]] std::optional<BuiltinInfo> find_builtin(std::string_view name);
[[nodiscard]] std::string_view name_of(Builtin f);

/// The number of arguments of integral, pv and sum, which bind a variable; 0 for other names.
[[nodiscard]] constexpr unsigned binder_arity(std::string_view name) {
    return name == "pv" ? 5 : name == "integral" || name == "sum" ? 4 : 0;
}

} // namespace edgeproof::formula
