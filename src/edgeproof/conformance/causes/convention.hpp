// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/answers/agreement.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// What one convention, another than ours, would explain: still a failure, but one with a way out.
struct Convention {
    std::string of;       ///< the quantities that it explains: "p", "p, left edge", "c_1", "p; P"
    std::string relation; ///< "2 times ours"
    double digits = 0;    ///< to which that holds in the worst of the rows explained
    std::size_t rows = 0; ///< explained
    std::size_t failing = 0;
    std::string hint; ///< what may be behind it and what to do
    /// Other relations that leave as little: the answers do not tell them apart.
    std::vector<std::string> also = {};
    double held = 0; ///< digits to which nine of ten rows hold it
};

/// Looks in the failing rows for numbers of few digits, for questions read otherwise
/// (unit_mistake.hpp), and for a uniform factor (2, 1/2, pi, units of other systems, ... or any
/// other), a sign, and the edges taken for one another (factor_mistake.hpp): quantity by quantity,
/// at both edges, else at one. A convention counts when at least 3 failing rows, and 9 of 10, hold
/// it to within their own scatter, that scatter is below 3 %, and less than a quarter is left of
/// what is off without it. One that explains several quantities is said once, of all of them.
[[nodiscard]] std::vector<Convention> infer_conventions(const Answers& answers,
                                                        const Agreements& agreements,
                                                        const ReferenceOptions& options);

/// The quantities of failing rows, three or more of each, that none of the conventions explains.
[[nodiscard]] std::vector<std::string> unexplained(const Answers& answers,
                                                   const Agreements& agreements,
                                                   const std::vector<Convention>& conventions);

} // namespace edgeproof::conformance
