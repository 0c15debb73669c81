// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// Comparison of mesh results, tables of x and p with a few correct digits, with the exact contact.
///   input/result_table.hpp      ResultTable: a program's table, with any columns and separators
///   measures/exact_contact.hpp  ExactContact: the scene's own solution
///   measures/measures.hpp       AlignedResult: sign, origin, nodes with their exact pressure;
///                               DataContact: edges and force of the data; EdgeFit: c_0, c_1;
///                               Errors: relative to the peak, to p itself, in the L2 norm;
///                               the error that a correct mesh has by itself
///   causes/causes.hpp           Diagnosis: mistakes that would explain wrong data
/// Only the values of the exact contact are proved, if their routes are; edges, fits and orders of
/// data are estimates.
#include "edgeproof/comparison/causes/causes.hpp"
#include "edgeproof/comparison/input/result_table.hpp"
#include "edgeproof/comparison/measures/exact_contact.hpp"
#include "edgeproof/comparison/measures/measures.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

enum class Norm { peak, local, l2 };
/// Reads peak, local, L2. Throws InputError for other names.
[[nodiscard]] Norm norm_named(std::string_view name);

/// The tolerances for data. Edges, force and c_0 of the data are compared with the results of the
/// same rule for the exact pressure at the same nodes: the difference of these from the exact
/// values is due to the mesh width, not to errors of the data.
struct Tolerances {
    static constexpr double usual = 0.03;
    double pressure = usual;
    bool stated = false; ///< `pressure` is given by the user
    Norm of = Norm::peak;
    EdgeZone zone;
    std::optional<double> edges; ///< for a and b, each relative to its value
    std::optional<double> force;
    std::optional<double> c0;      ///< at both edges
    std::optional<double> q;       ///< in the norm `of`; without it, as for the pressure
    std::optional<double> surface; ///< for gap, slip and sxx, relative to their scales
    /// The data cover only a part of the contact: they need not determine a, b, P and the largest
    /// p, unless these have a tolerance of their own.
    bool partial = false;
};

/// The least number of nodes inside the exact contact for a comparison.
inline constexpr std::size_t fewest_inside = 3;

/// A quantity along the surface that the data have in addition to p and q, compared with that of
/// the scene: the gap outside the contact (0 inside), the slip inside, sxx on the surface of one
/// body.
struct SurfaceErrors {
    std::string name;      ///< gap, slip, sxx
    std::string reference; ///< what `peak` is relative to
    std::string route;     ///< of the exact values
    double scale = 0;
    std::size_t nodes = 0;
    double peak = 0; ///< the largest |error|, relative to `scale`
    std::size_t worst = 0;
    double data = 0; ///< there, in the scene's direction
    double exact = 0;
};

struct FileComparison {
    ResultTable table;
    AlignedResult data;
    DataContact contact;
    DataContact of_exact;        ///< by the same rules for the exact pressure at the same nodes
    Errors errors;               ///< outside the edge zones
    Errors all;                  ///< at all nodes
    std::optional<Errors> shear; ///< of q, outside the edge zones, if there is one
    std::vector<SurfaceErrors> surface; ///< by compare_surface()
    std::optional<double> Q;            ///< by trapezoids, over nodes that have an exact q
    std::optional<double> Q_of_exact;
    std::vector<DistanceErrors> distances;
    std::vector<KnotErrors> knots;
    std::array<std::optional<EdgeFit>, 2> fits; ///< by index_of(edge)
    std::vector<Undetermined> undetermined;
    std::size_t inside = 0;
    std::size_t outside = 0;
    std::size_t pressing_outside = 0;   ///< those with more than 1/500 of the largest pressure
    std::optional<Diagnosis> diagnosis; ///< if there is an error to explain
    std::optional<Diagnosis> shear_diagnosis; ///< of q, if p is right
    std::vector<std::string> failures;        ///< the reasons why it does not pass, a sentence each

    [[nodiscard]] bool passes() const { return failures.empty(); }
    [[nodiscard]] std::vector<std::string> findings() const;
};

/// A quantity of the contact: that of the data, and the exact one.
struct ComparedQuantity {
    std::string name; ///< "a", "b", "P", "largest p", "Q", "c_0", "c_1", "c_0 left", "c_1 left"
    std::optional<contact::Edge> edge = {}; ///< where it is measured, if at one edge
    std::optional<double> data = {};
    std::optional<double> of_exact = {}; ///< the result of the same rule for the exact pressure
    double exact = 0;
    double spread = 0; ///< of the data's value, if a fit gives one
    std::string note = {};
};
[[nodiscard]] std::vector<ComparedQuantity> compared_quantities(const FileComparison& file,
                                                                const ExactContact& exact);

/// The order with which a quantity ("a", "P", "c0", "peak", ...) of finer meshes converges.
struct Convergence {
    std::string quantity;
    std::optional<double> order;
};

struct Comparison {
    Tolerances tolerances;
    std::vector<FileComparison> files;
    std::vector<Convergence> convergence; ///< for two files or more
    [[nodiscard]] bool passes() const;
};

/// `origin`: the x of the data at the scene's origin; if empty, it is fitted, which only the user
/// may request. Data that do not pass, or whose error exceeds 3/1000 of the peak, are diagnosed if
/// the suspects of the scene are given.
[[nodiscard]] FileComparison compare_file(ResultTable table, const ExactContact& exact,
                                          const Tolerances& tolerances,
                                          const std::optional<Rational>& origin,
                                          SuspectContacts* suspects = nullptr);
/// Compares gap, slip and sxx of the data, if they have them, at the nodes outside the edge zones
/// with the exact values of the scene. The direction of the slip, and the body whose sxx the data
/// have, are those that agree better. Adds failures if the tolerances have `surface`. Throws
/// Interrupted.
void compare_surface(FileComparison& file, const scene::Scene& scene, const ExactContact& exact,
                     const Tolerances& tolerances);
/// Orders of a, b, P, c_0, the largest pressure and the errors, if every file has them.
[[nodiscard]] std::vector<Convergence> convergence_of(const std::vector<FileComparison>& files,
                                                      const ExactContact& exact);

/// The error in one of the norms.
[[nodiscard]] double in_norm(const Errors& errors, Norm norm);

/// Adds the reasons for which measured data fail their tolerances.
void judge(FileComparison& file, const ExactContact& exact, const Tolerances& tolerances);

/// Throws InputError, with the file, if fewer than three nodes lie inside the exact contact, or if
/// the edge zones leave none of these: such data cannot be compared. The advice depends on the
/// loaded part of the data and its width: a finer mesh if fewer than three nodes are loaded,
/// another origin if the width is half to twice the contact's, otherwise another unit.
void require_nodes_inside(const FileComparison& file, const ExactContact& exact,
                          const EdgeZone& zone);

/// Compares all tables of a scene, with the mistakes that may explain them, and finds the orders of
/// several. `progress` is called with the number of tables done, and that of all. Throws
/// InputError, with the file, for data with too few nodes inside the contact, or inside and outside
/// the edge zones.
[[nodiscard]] Comparison
compare_tables(std::vector<ResultTable> tables, const scene::Scene& scene,
               const ExactContact& exact, const Tolerances& tolerances,
               const std::optional<Rational>& origin,
               const std::function<void(std::size_t, std::size_t)>& progress);

} // namespace edgeproof::comparison
