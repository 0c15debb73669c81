// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/builtin.hpp"

#include <algorithm>
#include <array>

namespace edgeproof::formula {
namespace {

/// In the order of the enumeration, from sqrt on.
constexpr std::array<std::string_view, 23> builtin_names{
    "sqrt", "exp",   "log",  "sin",   "cos",  "tan",   "asin",  "acos",
    "atan", "atan2", "sinh", "cosh",  "tanh", "asinh", "acosh", "atanh",
    "abs",  "sgn",   "step", "gamma", "max",  "min",   "hypot"};

constexpr std::array table = [] {
    std::array<BuiltinInfo, builtin_names.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
        constexpr unsigned any_number = 64;
        const auto f = static_cast<Builtin>(i + 1);
        const bool list = f == Builtin::max || f == Builtin::min;
        const unsigned least = list || f == Builtin::atan2 || f == Builtin::hypot ? 2 : 1;
        all[i] = {f, builtin_names[i], least, list ? any_number : least};
    }
    return all;
}();
static_assert(table.back().id == Builtin::hypot);

} // namespace

std::span<const BuiltinInfo> builtins() { return table; }

std::optional<BuiltinInfo> find_builtin(std::string_view name) {
    const auto it = std::ranges::find(table, name, &BuiltinInfo::name);
    return it == table.end() ? std::nullopt : std::optional(*it);
}

std::string_view name_of(Builtin f) {
    return f == Builtin::none ? std::string_view{} : table[static_cast<std::size_t>(f) - 1].name;
}

} // namespace edgeproof::formula
