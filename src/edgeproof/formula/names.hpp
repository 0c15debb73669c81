// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/parse.hpp"

#include <span>
#include <string>
#include <string_view>

/// The messages of the parser about names and characters, separate from the grammar.
namespace edgeproof::formula {

[[nodiscard]] inline bool is_pi(std::string_view name) { return name == "pi" || name == "Pi"; }

/// Increases a depth by one, until its destructor is called.
class Level {
public:
    explicit Level(std::size_t& depth) : depth_(depth) { ++depth_; }
    ~Level() { --depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

private:
    std::size_t& depth_;
};

/// The least and the greatest number of arguments.
struct Arity {
    std::size_t least = 0;
    std::size_t most = 0;
};
/// Returns that of a known function or binder; {0, 0} for others.
[[nodiscard]] Arity arity_of(std::string_view name, const Symbols& allowed);
/// "atan2(x, y)".
[[nodiscard]] std::string usage(std::string_view name, const Symbols& allowed);

[[nodiscard]] std::string instead_of_variable(std::string_view name, const Symbols& allowed,
                                              std::span<const std::string_view> bound);
[[nodiscard]] std::string instead_of_function(std::string_view name, const Symbols& allowed);

/// The advice for a number with a unit.
inline constexpr std::string_view without_units =
    "write the number alone, all values in one consistent set of units";

/// True if a name after a number can only be a unit: in a constant, or because it is in the list of
/// units.
[[nodiscard]] bool is_unit(std::string_view name, const Symbols& allowed);

/// Returns " at column N"; columns count characters from 1.
[[nodiscard]] std::string at_column(std::string_view text, std::size_t offset);
/// Returns the (UTF-8) character at `offset` in quotes, or an escape if it cannot be printed.
[[nodiscard]] std::string quoted_at(std::string_view text, std::size_t offset);
/// Returns what to write instead of a character that may not occur in a formula.
[[nodiscard]] std::string hint_for_character(std::string_view text, std::size_t offset);

} // namespace edgeproof::formula
