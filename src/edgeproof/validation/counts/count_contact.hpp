// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/validation/counts/count.hpp"

#include <map>
#include <string>
#include <vector>

namespace edgeproof::validation {

struct CountedContact {
    std::map<std::size_t, CountCell> cells; ///< as in CountState
    std::vector<CountFinding> findings;
};

/// Throws Interrupted; then no value of the contact is counted.
[[nodiscard]] CountedContact count_contact(const CountOptions& options, std::size_t number,
                                           std::size_t values);

/// Returns the faults of one value; empty if there are none. `error` is the rounding error allowed
/// for `second`. Adds to the cell.
[[nodiscard]] std::string held_to(const scene::BoundedValue& first,
                                  const scene::BoundedValue& finer, const Real& second,
                                  const Real& error, unsigned digits, CountCell& cell);

} // namespace edgeproof::validation
