// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/alignment.hpp"
#include "edgeproof/comparison/measures/data_edges.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

/// What is left out beside each edge, inside and outside: so many elements of the mesh there, or a
/// length.
struct EdgeZone {
    double elements = 0;
    std::optional<double> length = {};

    [[nodiscard]] double at(contact::Edge edge, const DataContact& contact) const {
        return length ? *length : elements * contact.element[index_of(edge)];
    }
};
/// "2e", "0.5e", "0.01". Throws InputError for another form, or a negative one.
[[nodiscard]] EdgeZone parse_edge_zone(std::string_view text);

/// How far data are from the exact p, or q. What the digits explain to which they are written is
/// not counted.
struct Errors {
    std::size_t nodes = 0;
    double peak = 0;  ///< the largest |error|, relative to the scale of p, or of q
    double local = 0; ///< the largest |error/exact|, over nodes inside
    double l2 = 0;    ///< the root of the integral of its square, relative to that of the exact one
    double median_local = 0;
    std::optional<std::size_t> worst; ///< the node of `peak`
    std::optional<std::size_t> worst_local;

    double as_written = 0; ///< as `local`, with what the written digits explain
    /// -log10 of `as_written`, 0 at least and 16 at most.
    [[nodiscard]] double digits() const;
};
[[nodiscard]] double digits_of(double relative_error);

/// Nodes inside, by their distance from the nearer edge as a part of a + b.
struct DistanceErrors {
    contact::Edge edge = contact::Edge::right;
    double from = 0; ///< of u/(a + b)
    double to = 0;
    Errors errors;
};

/// Nodes within a hundredth of a + b, or two elements, of a knot.
struct KnotErrors {
    ContactKnot knot;
    Errors errors;
};

/// Whether a node lies outside the zones beside the edges, and off every corner.
[[nodiscard]] bool is_counted(const Node& node, const EdgeZone& zone, const DataContact& contact);

/// Over all nodes that `zone` does not leave out, those outside the contact too (the exact pressure
/// is 0 there).
[[nodiscard]] Errors measure(const AlignedResult& data, const ExactContact& exact,
                             const DataContact& contact, const EdgeZone& zone);
/// The same of q, over nodes that have an exact one: none without shear. Relative to the scale of
/// ExactShear; L2 over the nodes counted, as under full stick the integral of q^2 is infinite.
[[nodiscard]] std::optional<Errors> measure_shear(const AlignedResult& data,
                                                  const ExactContact& exact,
                                                  const DataContact& contact, const EdgeZone& zone);
/// By decades, each edge from there to the middle; decades without a node are left out.
[[nodiscard]] std::vector<DistanceErrors> by_distance(const AlignedResult& data,
                                                      const ExactContact& exact);
[[nodiscard]] std::vector<KnotErrors>
beside_knots(const AlignedResult& data, const ExactContact& exact, const DataContact& contact);

} // namespace edgeproof::comparison
