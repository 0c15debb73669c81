// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/causes/causes.hpp"

#include <optional>

namespace edgeproof::comparison {

/// Pressures that carry fewer digits than they are written with: rounded to so many significant
/// ones, or decimals, or numbers of binary32; where the errors away from the edges (by a fiftieth
/// of the contact) are no larger than that explains. Of binary32: 16 units in the last place of the
/// largest pressure, for a computation in it.
[[nodiscard]] std::optional<Cause>
cause_in_digits(const ResultTable& table, const AlignedResult& data, const ExactContact& exact);

} // namespace edgeproof::comparison
