// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// Failing rows with a common property.
struct Group {
    std::string name;              ///< "p", "p, left edge", "c_1"
    std::string family;            ///< "p", "c_k"
    std::vector<std::size_t> rows; ///< questions
};

/// Groups the rows by quantity (c_k and s_k together, and separately), at both edges and at each
/// edge. The largest group comes first; among groups of the same rows, the most specific name.
[[nodiscard]] std::vector<Group> groups_of(const Questions& questions,
                                           const std::vector<std::size_t>& rows);

/// Returns the rows with wrong values, not only with too few digits, that none of `known` explains.
[[nodiscard]] std::vector<std::size_t> rows_that_fail(const Answers& answers,
                                                      const Agreements& agreements,
                                                      const std::vector<Convention>& known);

} // namespace edgeproof::conformance
