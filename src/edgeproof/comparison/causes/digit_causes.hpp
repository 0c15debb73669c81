// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/causes/causes.hpp"

#include <optional>

namespace edgeproof::comparison {

/// Finds pressures that carry fewer digits than are written: rounded to a number of significant
/// digits or decimals, or numbers of binary32; accepted if the errors away from the edges (by a
/// fiftieth of the contact) are no larger than this rounding explains. For binary32, 16 units in
/// the last place of the largest pressure are allowed for a computation.
[[nodiscard]] std::optional<Cause>
cause_in_digits(const ResultTable& table, const AlignedResult& data, const ExactContact& exact);

} // namespace edgeproof::comparison
