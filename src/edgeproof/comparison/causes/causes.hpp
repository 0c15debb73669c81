// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/causes/suspect_contacts.hpp"
#include "edgeproof/comparison/input/result_table.hpp"
#include "edgeproof/comparison/measures/alignment.hpp"
#include "edgeproof/comparison/measures/data_edges.hpp"

#include <optional>
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

/// What data are of the exact values, with its standard error by their scatter.
struct CommonFactor {
    double value = 1;
    double error = 0;
};

/// What was found of the causes.
struct Diagnosis {
    /// What is left without a cause, and the scatter of the data: rms, relative to the largest
    /// pressure, over nodes two elements and a fiftieth of the contact or more from an edge.
    double unexplained = 0;
    double noise = 0;
    bool at_edges_only = false; ///< those nodes agree to three thousandths, as a mesh's do: what is
                                ///< off is no mistake's
    bool largest_inside = false; ///< the largest error is one of those nodes', and at no edge
    std::vector<Cause> causes;   ///< the likeliest first
    /// Where no cause is known: the factor that explains the data as a cause would.
    std::optional<CommonFactor> factor;
};

/// Holds data against the pressures that a program with each known mistake would compute
/// (suspects.hpp). A mistake explains the data where what it leaves is within the data's own
/// scatter (of second differences from node to node) and an allowance for the mesh, its scale is
/// one within three standard errors (of even noise or of noise that goes with the pressure,
/// whichever is larger) and the same, and it leaves less than three tenths of what is left without
/// it. The allowance is three thousandths, and no more than a twentieth of what is left without the
/// mistake. Those that leave as little as the best, to a fifth, are equally likely: the data do not
/// tell them apart. Data that carry too few digits, or are binary32, and agree but for that, have
/// that cause. None is proved. Throws Interrupted.
[[nodiscard]] Diagnosis diagnose(const ResultTable& table, const AlignedResult& data,
                                 const DataContact& contact, SuspectContacts& suspects,
                                 const ExactContact& exact);
/// The same of the shear traction, where the pressure is right.
[[nodiscard]] Diagnosis diagnose_shear(const AlignedResult& data, const DataContact& contact,
                                       SuspectContacts& suspects, const ExactContact& exact);

} // namespace edgeproof::comparison
