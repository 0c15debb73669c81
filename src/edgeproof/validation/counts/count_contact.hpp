// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/validation/counts/count.hpp"

#include <map>
#include <string>
#include <vector>

namespace edgeproof::validation {

/// One contact of a count, done.
struct CountedContact {
    std::map<std::size_t, CountCell> cells; ///< as in CountState
    std::vector<CountFinding> findings;
};

/// Throws Interrupted: nothing of it counts then.
[[nodiscard]] CountedContact count_contact(const CountOptions& options, std::size_t number,
                                           std::size_t values);

/// What is wrong with one value, empty where nothing is. `error` is what `second` may owe to its
/// own rounding. Adds to the cell.
[[nodiscard]] std::string held_to(const scene::BoundedValue& first,
                                  const scene::BoundedValue& finer, const Real& second,
                                  const Real& error, unsigned digits, CountCell& cell);

} // namespace edgeproof::validation
