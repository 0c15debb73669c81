// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/rational.hpp"

#include <cstddef>
#include <string_view>

namespace edgeproof::formula {

/// A number of an expression, "12.5e-3", and where it ends.
struct DecimalToken {
    Rational value;
    std::size_t end = 0;
};

/// The number that begins at `start`, where there is a digit or a point, exactly. An `e` that no
/// digits follow is left to be a name. `bits`: of all numbers of the expression so far, counted on.
/// Throws FormulaError for a point without digits or a second one, an exponent beyond 100,000, and
/// numbers of more than 4,000,000 bits together.
[[nodiscard]] DecimalToken decimal_token(std::string_view text, std::size_t start,
                                         std::size_t& bits);

} // namespace edgeproof::formula
