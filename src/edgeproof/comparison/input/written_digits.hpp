// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/input/result_table.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

/// Returns half a unit of the last digit of each number of a column. Numbers with an exponent have
/// as many digits as the longest of the column, those without as many decimals: "0.5" among
/// "0.333333" is taken to have six. Hexadecimal numbers, and zero with an exponent, are exact: 0.
[[nodiscard]] std::vector<double> column_rounding(const std::vector<std::string_view>& column);

/// Returns the digits that the numbers carry.
[[nodiscard]] CarriedDigits carried_digits(const std::vector<std::string_view>& column);

} // namespace edgeproof::comparison
