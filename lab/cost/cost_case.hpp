// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace edgeproof::cost {

/// A contact and the points at which its pressure is timed.
struct CostCase {
    std::string name;
    scene::Scene scene;
    contact::Edge edge = contact::Edge::right;
    std::vector<formula::Exact> u;
    /// The place (as u) near which the points lie: 0 for the edge, else a knot or an apex.
    formula::Exact near = {};

    /// Returns |u - near| for a point, in units of a.
    [[nodiscard]] double distance(std::size_t point) const;
};

/// Returns the cases that are timed if no scene is given. In the first, routes are compared: a
/// flat-and-rounded punch, t = 0.4 a, with 40 points in a geometric sequence from u = 1e-8 a to a.
/// The others are a wedge, a power law of fractional exponent, both tilted profiles, and hard
/// points: near the end of a flat, near the apex of a power law, and within 1e-300 of an edge.
[[nodiscard]] std::vector<CostCase> usual_cases();

/// Returns a user's scene with its own points (at its first edge), or else with 40 points as above.
/// Throws InputError for a scene without a given profile (a load of P and M), because the compared
/// routes need one.
[[nodiscard]] CostCase case_of(const scene::Scene& scene);

/// Returns at most `most` of the points, equally spaced, including the first and the last.
[[nodiscard]] std::vector<std::size_t> thinned(std::size_t points, std::size_t most);

} // namespace edgeproof::cost
