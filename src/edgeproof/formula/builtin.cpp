// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/builtin.hpp"

#include <algorithm>
#include <array>

namespace edgeproof::formula {
namespace {

constexpr unsigned any_number = 64;

constexpr std::array table{
    BuiltinInfo{Builtin::sqrt, "sqrt", 1, 1},
    BuiltinInfo{Builtin::exp, "exp", 1, 1},
    BuiltinInfo{Builtin::log, "log", 1, 1},
    BuiltinInfo{Builtin::sin, "sin", 1, 1},
    BuiltinInfo{Builtin::cos, "cos", 1, 1},
    BuiltinInfo{Builtin::tan, "tan", 1, 1},
    BuiltinInfo{Builtin::asin, "asin", 1, 1},
    BuiltinInfo{Builtin::acos, "acos", 1, 1},
    BuiltinInfo{Builtin::atan, "atan", 1, 1},
    BuiltinInfo{Builtin::atan2, "atan2", 2, 2},
    BuiltinInfo{Builtin::sinh, "sinh", 1, 1},
    BuiltinInfo{Builtin::cosh, "cosh", 1, 1},
    BuiltinInfo{Builtin::tanh, "tanh", 1, 1},
    BuiltinInfo{Builtin::asinh, "asinh", 1, 1},
    BuiltinInfo{Builtin::acosh, "acosh", 1, 1},
    BuiltinInfo{Builtin::atanh, "atanh", 1, 1},
    BuiltinInfo{Builtin::abs, "abs", 1, 1},
    BuiltinInfo{Builtin::sgn, "sgn", 1, 1},
    BuiltinInfo{Builtin::step, "step", 1, 1},
    BuiltinInfo{Builtin::gamma, "gamma", 1, 1},
    BuiltinInfo{Builtin::max, "max", 2, any_number},
    BuiltinInfo{Builtin::min, "min", 2, any_number},
    BuiltinInfo{Builtin::hypot, "hypot", 2, 2},
};

} // namespace

std::span<const BuiltinInfo> builtins() { return table; }

std::optional<BuiltinInfo> find_builtin(std::string_view name) {
    const auto it = std::ranges::find(table, name, &BuiltinInfo::name);
    return it == table.end() ? std::nullopt : std::optional(*it);
}

std::string_view name_of(Builtin f) {
    const auto it = std::ranges::find(table, f, &BuiltinInfo::id);
    return it == table.end() ? std::string_view{} : it->name;
}

} // namespace edgeproof::formula
