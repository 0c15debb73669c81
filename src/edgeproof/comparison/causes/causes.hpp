// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/causes/suspects.hpp"
#include "edgeproof/comparison/input/result_table.hpp"
#include "edgeproof/comparison/measures/alignment.hpp"
#include "edgeproof/comparison/measures/exact_contact.hpp"
#include "edgeproof/comparison/measures/measures.hpp"

#include <optional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// A mistake that explains wrong data.
struct Cause {
    std::string name;   ///< a fixed name: "e-for-e-star", "factor-2", ...
    std::string what;   ///< a description
    double factor = 1;  ///< data over exact pressure: the median over the nodes used
    double scatter = 0; ///< rms of the remaining error, relative to the largest pressure
    std::vector<std::string> equally_likely = {}; ///< others that fit equally well
};

/// The ratio of the data to the exact values, with its standard error from their scatter.
struct CommonFactor {
    double value = 1;
    double error = 0;
    bool of_x = false; ///< of the places, not of the values
};

struct Diagnosis {
    /// The error without any cause, and the scatter of the data: rms, relative to the largest
    /// pressure, over nodes at least two elements and a fiftieth of the contact away from the
    /// edges.
    double unexplained = 0;
    double inside = 0; ///< the same, over those of the nodes that lie in the exact contact
    double noise = 0;
    bool at_edges_only = false; ///< those nodes agree to three thousandths, as in a correct mesh
                                ///< solution: the error is not due to a mistake
    bool too_few = false;       ///< fewer than eight of those nodes lie in the exact contact
    Worst worst = Worst::near_edge;
    std::vector<Cause> causes; ///< the most likely first
    /// If no cause is found: a factor of p, q or x that explains the data as a cause would.
    std::optional<CommonFactor> factor;
};

/// Finds pressures that carry fewer digits than are written: rounded to a number of significant
/// digits or decimals, or numbers of binary32; accepted if the errors away from the edges (by a
/// fiftieth of the contact, on either side) are no larger than this rounding explains. For
/// binary32, 16 units in the last place of the largest pressure are allowed for a computation.
[[nodiscard]] std::optional<Cause>
cause_in_digits(const ResultTable& table, const AlignedResult& data, const ExactContact& exact);

/// Compares data with the pressures that a program with each known mistake would compute
/// (pressure_suspects()), at nodes away from the edges, by diagnose/fit.hpp. In
/// addition to noise, the mesh's own error `mesh_error` (measures/measures.hpp) is allowed, at most
/// three hundredths of the largest pressure. Data that carry too few digits, or are binary32, and
/// otherwise agree, have that cause. Data that none of these explains, but the scene under the
/// force that they carry, have the cause another-force. No cause is proved.
/// Throws Interrupted.
[[nodiscard]] Diagnosis diagnose_pressure(const ResultTable& table, const AlignedResult& data,
                                          const DataContact& contact, SuspectContacts& suspects,
                                          const ExactContact& exact, double mesh_error);
/// Diagnoses the shear traction, if the pressure is right.
[[nodiscard]] Diagnosis diagnose_shear(const AlignedResult& data, const DataContact& contact,
                                       SuspectContacts& suspects, const ExactContact& exact,
                                       double mesh_error);

} // namespace edgeproof::comparison
