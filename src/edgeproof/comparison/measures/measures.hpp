// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/input/result_table.hpp"
#include "edgeproof/comparison/measures/alignment.hpp"
#include "edgeproof/comparison/measures/data_edges.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

/// The zones left out at each edge, on both sides of it: a number of elements of the mesh there, or
/// a length.
struct EdgeZone {
    double elements = 0;
    std::optional<double> length = {};

    [[nodiscard]] double at(contact::Edge edge, const DataContact& contact) const {
        return length ? *length : elements * contact.element[index_of(edge)];
    }
};
/// Reads "2e", "0.5e", "0.01". Throws InputError for another form, or a negative value.
[[nodiscard]] EdgeZone parse_edge_zone(std::string_view text);

/// The errors of data relative to the exact p or q. The part of an error that the rounding of the
/// written digits explains is not counted.
struct Errors {
    std::size_t nodes = 0;
    std::size_t inside = 0; ///< of these, inside the exact contact
    double peak = 0;        ///< the largest |error|, relative to the scale of p or q
    /// The largest |error/exact|; where the exact value is 0, as outside, relative to the scale.
    double local = 0;
    double l2 = 0;           ///< the L2 norm of the error, relative to that of the exact value
    double median_local = 0; ///< over nodes inside
    std::optional<std::size_t> worst; ///< the node of `peak`
    std::optional<std::size_t> worst_local;

    /// As `local`, over nodes inside, including the rounding of the written digits.
    double as_written = 0;
    /// -log10 of `as_written`, at least 0 and at most 16.
    [[nodiscard]] double digits() const;
};
[[nodiscard]] double digits_of(double relative_error);

/// The errors of nodes inside, by their distance from the closer edge as a fraction of a + b.
struct DistanceErrors {
    contact::Edge edge = contact::Edge::right;
    double from = 0; ///< the range of u/(a + b)
    double to = 0;
    Errors errors;
};

/// The errors of nodes within a hundredth of a + b, or two elements, of a knot.
struct KnotErrors {
    ContactKnot knot;
    Errors errors;
};

/// True if a node lies outside the zones at the edges, and not on a corner.
[[nodiscard]] bool is_counted(const Node& node, const EdgeZone& zone, const DataContact& contact);

/// The errors at all nodes outside `zone`, including those outside the contact (where the exact
/// pressure is 0).
[[nodiscard]] Errors measure(const AlignedResult& data, const ExactContact& exact,
                             const DataContact& contact, const EdgeZone& zone);
/// The errors of q, at nodes that have an exact one and lie outside `zone`, also at the edges of
/// the stick zone; nothing without shear. Relative to the scale of ExactShear; L2 over the nodes
/// counted, since under full stick the integral of q^2 is infinite.
[[nodiscard]] std::optional<Errors> measure_shear(const AlignedResult& data,
                                                  const ExactContact& exact,
                                                  const DataContact& contact, const EdgeZone& zone);
/// The errors by decades of distance, from each edge to the middle; decades without a node are left
/// out.
[[nodiscard]] std::vector<DistanceErrors> by_distance(const AlignedResult& data,
                                                      const ExactContact& exact);
[[nodiscard]] std::vector<KnotErrors>
errors_near_knots(const AlignedResult& data, const ExactContact& exact, const DataContact& contact);

struct MeshValue {
    double h = 0; ///< width of an element
    double value = 0;
};

/// The convergence of a quantity with finer meshes. All values are estimates.
struct Convergence {
    std::string quantity; ///< "a", "P", "c0", "peak", ...
    double exact = 0;
    /// The slope of log |value - exact| over log h, by least squares over all meshes.
    std::optional<double> order;
    /// The exponent p in value = limit + C h^p for the last three meshes, without the exact value.
    std::optional<double> own_order;
    std::optional<double> extrapolated;
    /// The estimated error of the extrapolated value: the grid convergence index of `roache1998`,
    /// 1.25 times the remaining error of the finest mesh, or 3 times if the meshes do not show that
    /// their orders agree.
    double extrapolation_error = 0;
    /// True for four meshes or more, if the orders of the last two triples agree to a fifth.
    bool trusted = false;
    std::string why_not; ///< the reason why it is not trusted, or not extrapolated
    /// True if the extrapolated value agrees with the exact one within its own estimate.
    std::optional<bool> agrees;
};

/// Analyses the values; the coarsest mesh comes first.
[[nodiscard]] Convergence converge(std::string quantity, std::vector<MeshValue> values,
                                   double exact);
/// Analyses an error, whose limit is 0: no extrapolation.
[[nodiscard]] Convergence converge_error(std::string quantity, std::vector<MeshValue> errors);

/// The error that a correct mesh has by itself, away from the edges, is the root mean square over
/// nodes two elements or more from an edge, relative to the largest pressure: an estimate. The
/// product of this error and of the number of elements in the contact is at most this in all
/// runs of CalculiX in examples/third-party/solvers/mesh-errors.csv; mesh_errors.py there makes
/// that file, and a test compares the number with it.
inline constexpr double mesh_error_times_elements = 0.06;

/// The same if the profile has a corner, where p is infinite: the greatest error of the scale of p
/// by the boundary elements of tests/comparison/spring_bed.hpp with rigid springs.
inline constexpr double mesh_error_by_corner_times_elements = 0.15;

/// The error to expect of one mesh, `elements` wide.
[[nodiscard]] inline double expected_mesh_error(double elements, bool corner) {
    return (corner ? mesh_error_by_corner_times_elements : mesh_error_times_elements) /
           (elements > 1 ? elements : 1);
}

/// The widths of the elements of a mesh, by index_of(edge), if the rows of a table are samples of a
/// line through it: p is linear, to its written digits, except at places farther apart than the
/// rows. Nothing if the rows are nodes.
struct SampledElements {
    std::array<double, 2> at_edge{};
    double mean = 0;
};
[[nodiscard]] std::optional<SampledElements> sampled_elements(const ResultTable& table);

/// The errors of several meshes of one contact, from their differences from the finest one: error
/// = C h^q, with q between 1/2 and 4 from the first and the last but one of three meshes or more,
/// and q = 1 of two. In the order of the tables. Nothing for a single mesh, for meshes of the same
/// width, and for data without pressure.
[[nodiscard]] std::optional<std::vector<double>>
mesh_errors(const std::vector<ResultTable>& tables);

} // namespace edgeproof::comparison
