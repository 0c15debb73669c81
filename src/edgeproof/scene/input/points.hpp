// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"

#include <vector>

namespace edgeproof::scene {

/// from, ..., to in equal ratios, `per_decade` to a factor of 10, each an exact number and the same
/// on every machine: from times a power of 10 where that is rational, else the decimal of 12
/// significant digits nearest to from 10^(k/per_decade). Both ends are among them, exactly.
/// Throws InputError unless 0 < from < to, or for more than 100,000 points.
[[nodiscard]] std::vector<formula::Exact>
geometric_points(const formula::Exact& from, const formula::Exact& to, std::size_t per_decade);

/// `count` >= 2 points from, ..., to at equal distances, exact. Throws InputError unless from < to.
[[nodiscard]] std::vector<formula::Exact> even_points(const formula::Exact& from,
                                                      const formula::Exact& to, std::size_t count);

} // namespace edgeproof::scene
