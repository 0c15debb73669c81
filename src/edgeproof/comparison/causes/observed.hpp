// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/alignment.hpp"
#include "edgeproof/comparison/measures/exact_contact.hpp"
#include "edgeproof/comparison/measures/measures.hpp"
#include "edgeproof/diagnose/fit.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

/// The values that a program with one mistake would write at the nodes used.
struct Suspect {
    std::string name;
    std::string what;
    double a = 0; ///< its contact is -b < x < a
    double b = 0;
    std::vector<double> values; ///< at each of those nodes; NaN where there is no value
};

/// Where the largest error is: near an edge of the exact contact (by two elements or a fiftieth of
/// the contact) or a corner, or elsewhere inside or outside it.
enum class Worst { near_edge, inside, outside };

/// The errors that a suspect leaves.
struct Left {
    /// Relative to the value of the node, or to a tenth of the largest one.
    diagnose::Remainders rows;
    double rms = 0;    ///< relative to the largest value
    double inside = 0; ///< the same, over the nodes in the suspect's contact
    double noise = 0;  ///< the rms scatter from node to node, relative to it
    Worst worst = Worst::near_edge;
};

/// Values of p or q that are diagnosed, and the exact ones.
struct Observed {
    const AlignedResult& data;
    std::vector<std::size_t> nodes; ///< indices of those used, in their order
    std::vector<double> values;
    Suspect right;
    double element = 0;          ///< the widest at an edge
    std::vector<double> corners; ///< where p is infinite

    [[nodiscard]] std::size_t size() const { return nodes.size(); }
    [[nodiscard]] const Node& operator[](std::size_t i) const { return data.nodes[nodes[i]]; }

    /// False at nodes within two elements, or a fiftieth of the suspect's contact, of one of its
    /// edges or of a corner.
    [[nodiscard]] bool counts(const Suspect& suspect, std::size_t i) const;
    [[nodiscard]] bool inside(const Suspect& suspect, std::size_t i) const;
    /// The data over the values of a suspect that are not 0.
    [[nodiscard]] std::vector<double> ratios(const Suspect& to) const;
    /// Every node of one parity, or without it every second of the means over three neighbours with
    /// weights 1/4, 1/2 and 1/4.
    [[nodiscard]] Observed part(std::optional<std::size_t> parity) const;
    /// A suspect on the contact -b < x < a with the values value(i) at the nodes.
    [[nodiscard]] Suspect suspect(std::string_view name, std::string what, double a, double b,
                                  const std::function<double(std::size_t)>& value) const;
    /// Returns nothing if fewer than eight nodes lie inside the suspect's contact.
    [[nodiscard]] std::optional<Left> left_by(const Suspect& suspect) const;
};
/// All nodes, or some at equal steps if there are many.
[[nodiscard]] Observed observed_in(const AlignedResult& data, const DataContact& contact,
                                   const ExactContact& exact, TractionOf of);

} // namespace edgeproof::comparison
