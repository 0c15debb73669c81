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

/// Where the data press, roughly.
struct Support {
    double left = 0;
    double right = 0;
    bool left_falls = false; ///< p goes down to nothing there, as it does at an edge
    bool right_falls = false;
};
/// Nothing where no node presses. `points`: by x.
[[nodiscard]] std::optional<Support> support_of(const std::vector<RoughPoint>& points);

/// Where the scene's origin lies in the x of data, by the data.
struct FoundOrigin {
    Real exact;             ///< a round number, or a usual place, where it is as near as that
    double uncertainty = 0; ///< of x, where it is neither
    std::string_view what;  ///< the usual place: ": x counts from the left edge of the contact"
};
/// By the middle of what the data press, refined by least squares of p over all nodes. Nothing
/// where it is less than a fiftieth of a + b from 0, or does not fit clearly better than 0.
/// `half`: the half of a symmetric contact that the data hold.
[[nodiscard]] std::optional<FoundOrigin> origin_of(const std::vector<RoughPoint>& points,
                                                   const Support& support,
                                                   const std::optional<contact::Edge>& half,
                                                   const ExactContact& exact);

} // namespace edgeproof::comparison
