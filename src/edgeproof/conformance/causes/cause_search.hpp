// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::conformance {

/// Searches rows with wrong values for questions interpreted differently (readings.hpp) and for
/// factors, as infer_conventions() describes. `known`: as there.
[[nodiscard]] std::vector<Convention> causes_of_wrong_rows(const Answers& answers,
                                                           const Agreements& agreements,
                                                           const std::vector<std::size_t>& failing,
                                                           const ReferenceOptions& options,
                                                           KnownReadings& known);

} // namespace edgeproof::conformance
