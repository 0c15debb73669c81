// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

/// A node of the data in double precision, for the search of the origin.
struct RoughPoint {
    double x;
    double p;
};

/// The loaded interval of the data, roughly.
struct Support {
    double left = 0;
    double right = 0;
    bool left_falls = false; ///< p falls to zero there, as at an edge
    bool right_falls = false;
};
/// Returns nothing if no node is loaded. `points`: by x.
[[nodiscard]] std::optional<Support> support_of(const std::vector<RoughPoint>& points);

/// The scene's origin in the x of the data.
struct FoundOrigin {
    Real exact;             ///< a round number or a usual place, if the fit agrees with it
    double uncertainty = 0; ///< of x, otherwise
    std::string_view what; ///< the usual place: ": x is measured from the left edge of the contact"
};
/// Starts from the middle of the loaded interval and refines it by least squares of p over all
/// nodes. Returns nothing if the origin is less than a fiftieth of a + b from 0, or does not fit
/// clearly better than 0. `half`: the half of a symmetric contact that the data contain.
[[nodiscard]] std::optional<FoundOrigin> origin_of(const std::vector<RoughPoint>& points,
                                                   const Support& support,
                                                   const std::optional<contact::Edge>& half,
                                                   const ExactContact& exact);

} // namespace edgeproof::comparison
