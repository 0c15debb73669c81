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
    /// The place (as u) that the points crowd at: 0 for the edge, else a knot or an apex.
    formula::Exact near = {};

    /// |u - near| of a point, in units of a.
    [[nodiscard]] double distance(std::size_t point) const;
};

/// What is timed where no scene is given. First the one that others are compared over: a
/// flat-and-rounded punch, t = 0.4 a, 40 points in equal ratios from u = 1e-8 a to a. Then a wedge,
/// a power law of fractional exponent, both tilted profiles, and the hard points: beside the end of
/// a flat, by the apex of a power law, within 1e-300 of an edge.
[[nodiscard]] std::vector<CostCase> usual_cases();

/// A scene of the user's at its own points (its first edge), else at 40 points as above. Throws
/// InputError where it gives no profile (a load of P and M): the routes that are compared take one.
[[nodiscard]] CostCase case_of(const scene::Scene& scene);

/// So many of the points, the first and the last among them, at equal strides; all where there are
/// no more.
[[nodiscard]] std::vector<std::size_t> thinned(std::size_t points, std::size_t most);

} // namespace edgeproof::cost
