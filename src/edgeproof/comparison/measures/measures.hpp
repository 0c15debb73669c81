// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/comparison/input/result_table.hpp"
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

/// The pressure, or the shear traction, at a node.
struct Traction {
    double data = 0;             ///< in the scene's direction; p is positive in compression
    std::optional<double> exact; ///< empty if it is infinite
    double error = 0;            ///< of the data, unrounded; 0 if the exact one is infinite
    double rounding = 0; ///< the change of `error` by the rounding of the written value and x

    /// The error that the rounding does not explain; infinite if the value is not finite.
    [[nodiscard]] double counted() const {
        const double left = std::abs(error) - rounding;
        return std::isfinite(left) ? std::max(0.0, left) : std::numeric_limits<double>::infinity();
    }
};

/// A node of a result with the exact tractions.
struct Node {
    std::size_t line = 0;
    double x = 0; ///< from the scene's origin
    ExactContact::Place place;
    Traction p;
    std::optional<Traction> q; ///< if data and scene have one
};
/// The pressure of a node, or its shear traction; null if there is none.
using TractionOf = const Traction* (*)(const Node&);
[[nodiscard]] inline const Traction* p_of(const Node& node) { return &node.p; }
[[nodiscard]] inline const Traction* q_of(const Node& node) { return node.q ? &*node.q : nullptr; }

/// Data in the coordinates of the exact solution.
struct AlignedResult {
    std::vector<Node> nodes; ///< by x
    double sign = 1;         ///< of compression in the data
    double shear_sign = 1;   ///< of the scene's direction of q in the data
    double origin = 0;       ///< the x of the data at the scene's origin
    bool origin_found = false;
    /// Set if the data begin (or end) in the middle of a symmetric contact.
    std::optional<contact::Edge> half;
    std::vector<std::string> findings;

    /// False for the edge of the missing half.
    [[nodiscard]] bool has(contact::Edge edge) const { return !half || *half == edge; }
};

/// `origin`: the x of the data at the scene's origin; if empty, that of found_shift(), or 0 if it
/// is less than a fiftieth of a + b. Leave it empty only if the user requests a fitted origin: a
/// shift is an error of the data.
[[nodiscard]] AlignedResult align(const ResultTable& table, const ExactContact& exact,
                                  const std::optional<Rational>& origin);

/// The integral over x by trapezoids, over the nodes for which value(node) is not empty.
template <class Nodes, class Value>
[[nodiscard]] double trapezoids(const Nodes& nodes, const Value& value) {
    double sum = 0;
    double last_x = 0;
    std::optional<double> last;
    for (const auto& node : nodes) {
        if (const std::optional<double> y = value(node)) {
            sum += last ? 0.5 * (node.x - last_x) * (*last + *y) : 0;
            last_x = node.x;
            last = y;
        }
    }
    return sum;
}

/// The force of the tractions value(node), by trapezoids; for half a contact, that of both halves.
template <class Value>
[[nodiscard]] double force_of(const AlignedResult& data, const ExactContact& exact,
                              const Value& value) {
    return (data.half ? 2 : 1) * trapezoids(data.nodes, [&](const Node& node) {
               std::optional<double> traction = value(node);
               return traction ? std::optional(*traction * exact.force_width(node.x)) : traction;
           });
}

/// Half the distance between the neighbouring places of node i, divided among the nodes at its
/// place. `nodes`: by x.
template <class Nodes> [[nodiscard]] double width_of_node(const Nodes& nodes, std::size_t i) {
    const double x = nodes[i].x;
    const auto of_x = [](const auto& node) { return node.x; };
    const auto begin = std::ranges::lower_bound(nodes, x, {}, of_x);
    const auto end = std::ranges::upper_bound(nodes, x, {}, of_x);
    const double before = begin != nodes.begin() ? std::prev(begin)->x : x;
    const double after = end != nodes.end() ? end->x : x;
    return 0.5 * (after - before) / static_cast<double>(end - begin);
}

/// A node of the data in double precision, for the search of a shift.
struct RoughPoint {
    double x;
    double p;
};

/// A shift of x: the scene's origin in the x of the data.
struct FoundShift {
    Real exact;             ///< a round number or a usual place, if the fit agrees with it
    double uncertainty = 0; ///< of x, otherwise
    std::string_view what; ///< the usual place: ": x is measured from the left edge of the contact"
    bool clear = false;    ///< it halves the squares of the errors
};
/// Finds the shift with the least squares of p less the exact pressure, at nodes away from edges
/// and corners: within a tenth of a + b of that of the loaded interval (with any factor of p), or
/// of 0 if the former is not clear. Returns nothing if no node is loaded. `points`: by x. `half`:
/// the half of a symmetric contact that the data contain.
[[nodiscard]] std::optional<FoundShift> found_shift(const std::vector<RoughPoint>& points,
                                                    const std::optional<contact::Edge>& half,
                                                    const ExactContact& exact);

/// A node presses if |p| exceeds this share of the greatest pressure of the data.
inline constexpr double pressing_fraction = 0.002;

/// The contact according to the data. All values are estimates: a mesh determines an edge to one
/// element.
struct DataContact {
    std::optional<double> a; ///< empty if no node is loaded, or if the data end inside the contact
    std::optional<double> b;
    /// The width of the element that contains the exact edge, or of the nearest one if the data do
    /// not reach it; 0 if there is none. The index is index_of(edge).
    std::array<double, 2> element{};
    double mean_element = 0; ///< width divided by the number of nodes inside the exact contact
    std::array<bool, 2> reaches{}; ///< the data reach the exact edge, to one element
    std::optional<double> force;   ///< by trapezoids; doubled for half a contact
    double largest = 0;            ///< the largest pressure
    std::size_t gaps = 0;          ///< places inside where the pressure falls to zero

    /// a or b
    [[nodiscard]] const std::optional<double>& at(contact::Edge edge) const {
        return edge == contact::Edge::right ? a : b;
    }
};

/// Near an edge p^2 is smooth and nearly linear in the distance, so an edge of the data is the zero
/// of the parabola through the last three p^2, limited to the interval between the last loaded node
/// and the first unloaded one. A node is loaded if p is more than 1/500 of the largest, and more
/// than four times the scatter of the nodes outside (but at most 1/20 of the largest).
[[nodiscard]] DataContact contact_of(const AlignedResult& data, const ExactContact& exact);

/// A quantity that the nodes do not determine, with the reason as a sentence.
struct Undetermined {
    std::string_view quantity; ///< a, b, P or largest p
    std::string why;
};

/// Returns the quantities that the nodes of the data do not determine, independent of the pressures
/// at them:
/// - an edge, if the nodes end more than one element inside it, or if the rule for edges, applied
///   to the exact pressure at these nodes, has an error of more than a tenth of a + b;
/// - P, if trapezoids of the exact pressure at these nodes have an error of more than a tenth of P,
///   if two neighbours inside the contact are more than a quarter of a + b apart, or if half a
///   contact does not begin in its middle, to one element;
/// - the largest p, if the exact pressure at these nodes is never more than nine tenths of it. A
///   profile with a corner has none.
/// For half a contact, only the edge of that half is checked. `of_exact`: contact_of() the exact
/// pressure at these nodes.
[[nodiscard]] std::vector<Undetermined>
undetermined(const AlignedResult& data, const DataContact& of_exact, const ExactContact& exact);

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

/// The order of convergence: the slope of log |error| over log h, by least squares over meshes of
/// different widths. An error of 0 has no logarithm and is left out. An estimate.
[[nodiscard]] std::optional<double> order_of(std::vector<MeshValue> errors);

/// The error that a correct mesh has by itself, away from the edges, is the root mean square over
/// nodes two elements or more from an edge, relative to the largest pressure: an estimate. The
/// product of this error and of the number of elements in the contact is at most this in all
/// runs of CalculiX in examples/third-party/solvers/mesh-errors.csv; mesh_errors.py there makes
/// that file, and a test compares the number with it.
inline constexpr double mesh_error_times_elements = 0.06;

/// The same if the profile has a corner, where p is infinite: the greatest error of the scale of p
/// by the boundary elements of tests/comparison/spring_bed.cpp with rigid springs.
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

/// A coefficient fitted to the data: an estimate, with the spread of the fit.
struct FittedCoefficient {
    double value = 0;
    double spread = 0;
    double of_exact = 0; ///< the result of the same fit for the exact pressure at the same nodes
};

/// c_0 and c_1 of p = c_0 u^(1/2) + c_1 u^(3/2) + ... by least squares over nodes near an edge.
struct EdgeFit {
    FittedCoefficient c0;
    FittedCoefficient c1;
    std::size_t nodes = 0;
    std::size_t terms = 0; ///< the higher ones are only auxiliary
    double from = 0;       ///< the range of u of the nodes used
    double to = 0;
    bool own_edge = false; ///< u is measured from the data's edge
};

/// u is measured from the exact edge, or, if `own_edge` is given (the data's edge, outwards from
/// the exact one), from the data's edge. `leave_out`: nodes closer to the edge than this are not
/// used. Tries windows from there up to 1/10 ... 9/10 of the expansion's radius of convergence, and
/// three to five terms, and returns the fit with the least spread of c_0; none if there are fewer
/// than three nodes more than terms. The spread combines the standard error of the residuals, the
/// change when one term is omitted, which estimates the effect of the truncated terms, and the
/// change when the place of the data's edge is fitted, too: an edge that a mesh moves by some
/// hundredths of an element changes all nodes alike. In runs of CalculiX and of boundary elements
/// with 20 to 250 elements (docs/third-party.md) the errors of c_0 are at most two spreads.
[[nodiscard]] std::optional<EdgeFit> fit_edge(const AlignedResult& data, const ExactContact& exact,
                                              contact::Edge edge, double leave_out,
                                              const std::optional<double>& own_edge = {});

/// The coefficients of least squares |y - sum of c_k column_k|^2, and their standard errors, by
/// modified Gram-Schmidt of columns and y. Returns nothing if the columns are dependent
/// to double precision, or are not fewer than the rows.
struct LeastSquares {
    std::vector<double> coefficients;
    std::vector<double> standard_errors;
};
[[nodiscard]] std::optional<LeastSquares>
least_squares(const std::vector<std::vector<double>>& columns, std::span<const double> y);

} // namespace edgeproof::comparison
