// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/answers/agreement.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// What one convention, another than ours, would explain: still a failure, but one with a way out.
struct Convention {
    std::string of;       ///< the quantities that it explains: "p", "p, left edge", "c_1"
    std::string relation; ///< "ours times 2"
    double digits = 0;    ///< to which that holds in the worst of the rows explained
    std::size_t rows = 0; ///< explained
    std::size_t failing = 0;
    std::string hint; ///< what may be behind it and what to do
};

/// Looks in the failing rows for numbers of few digits, for questions read otherwise
/// (unit_mistake.hpp), and for a uniform factor (2, 1/2, pi, degrees for radians, ... or any
/// other), a sign, and the edges taken for one another: quantity by quantity, at both edges, else
/// at one. A convention counts when at least 3 failing rows, and 9 of 10, agree with it to 6
/// digits.
[[nodiscard]] std::vector<Convention> infer_conventions(const Answers& answers,
                                                        const Agreements& agreements,
                                                        const ReferenceOptions& options);

} // namespace edgeproof::conformance
