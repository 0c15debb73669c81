// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/causes/causes.hpp"
#include "edgeproof/diagnose/fit.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::comparison {

/// Values of the data that are diagnosed, and the exact ones.
struct Observed {
    UsedNodes nodes;
    std::vector<double> values;
    Suspect right;
    double element = 0;          ///< the widest at an edge
    std::vector<double> corners; ///< where p is infinite

    /// False at nodes within two elements, or a fiftieth of the suspect's contact, of one of its
    /// edges or of a corner.
    [[nodiscard]] bool counts(const Suspect& suspect, std::size_t i) const;
    [[nodiscard]] bool inside(const Suspect& suspect, std::size_t i) const;
    /// The data over the exact values of the nodes.
    [[nodiscard]] std::vector<double> ratios() const;
    /// Every node of one parity, or without it every second of the means over three neighbours with
    /// weights 1/4, 1/2 and 1/4.
    [[nodiscard]] Observed part(std::optional<std::size_t> parity) const;
};
/// All nodes, or some at equal steps if there are many; without values.
[[nodiscard]] Observed observed_in(const AlignedResult& data, const DataContact& contact,
                                   const ExactContact& exact);

inline constexpr double share_left = 0.3; ///< of the error, that a cause may leave

/// The errors that a suspect leaves.
struct Left {
    /// Relative to the value of the node, or to a tenth of the largest one.
    diagnose::Remainders rows;
    double rms = 0;               ///< relative to the largest value
    double noise = 0;             ///< the rms scatter from node to node, relative to it
    bool largest_counted = false; ///< the largest of all errors is at a node that counts
};
/// Returns nothing if fewer than eight nodes lie inside the suspect's contact.
[[nodiscard]] std::optional<Left> left_by(const Observed& data, const Suspect& suspect);

/// Recognises data that alternate from node to node, as those at the corners and in the middles of
/// the sides of quadratic elements do: every second node is right, or the means over neighbours
/// are. `unexplained`: the error of all nodes.
[[nodiscard]] std::optional<Cause> alternation(const Observed& data, double allowance,
                                               double unexplained);

} // namespace edgeproof::comparison
