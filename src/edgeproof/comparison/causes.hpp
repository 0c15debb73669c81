// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/alignment.hpp"
#include "edgeproof/comparison/data_edges.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <string>
#include <vector>

namespace edgeproof::comparison {

/// A mistake that explains data which are off.
struct Cause {
    std::string name;   ///< a stable one: "e-for-e-star", "factor-2", ...
    std::string what;   ///< in words
    double factor = 1;  ///< data over exact pressure: the median over the nodes looked at
    double scatter = 0; ///< rms of what it leaves, relative to the largest pressure
    std::vector<std::string> equally_likely; ///< others that leave as little
};

/// What was found of the causes.
struct Diagnosis {
    /// What is left without a cause, and the scatter of the data: rms, relative to the largest
    /// pressure, over nodes two elements and a fiftieth of the contact or more from an edge.
    double unexplained = 0;
    double noise = 0;
    bool at_edges_only =
        false;                 ///< those nodes agree: what is off lies at the edges, as a mesh's is
    std::vector<Cause> causes; ///< the likeliest first
};

/// Holds data against the pressures that a program with each known mistake would compute: another
/// modulus, radius, force or width, a factor of p or x, a mirror, a shift, rows moved by one, terms
/// of the expansion in place of p. A mistake explains the data where what it leaves is within the
/// data's own scatter (of second differences from node to node) and three thousandths for the mesh,
/// its scale is one within four standard errors and the same, and it leaves less than three tenths
/// of what is left without it. Those that leave as little as the best, to a fifth, are equally
/// likely: the data do not tell them apart. None is proved. Throws Interrupted.
[[nodiscard]] Diagnosis diagnose(const AlignedResult& data, const DataContact& contact,
                                 const scene::Scene& scene, const ExactContact& exact);

} // namespace edgeproof::comparison
