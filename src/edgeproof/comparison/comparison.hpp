// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Results of meshes, a table of x and p with a few right digits, held against the exact contact.
///   input/result_table.hpp  ResultTable: what a program wrote, whatever its columns and separators
///   exact_contact.hpp       ExactContact: the scene's own solution
///   alignment.hpp           AlignedResult: sign, origin, nodes with their exact pressure
///   origin.hpp              origin_of(): where the data have the scene's origin
///   data_edges.hpp          DataContact: edges, force and elements by the data
///   measures.hpp            Errors: relative to the peak, to p itself, in the L2 norm; by distance
///   coverage.hpp            undetermined(): what the nodes do not determine
///   edge_fit.hpp            EdgeFit: c_0 and c_1 by least squares
///   causes.hpp              Diagnosis: the mistakes that would explain data which are off
///   convergence.hpp         Convergence: orders and extrapolated values of several meshes
/// Only the exact contact's values are proved, where their routes say so; edges, fits and
/// extrapolated values of data are estimates.
#include "edgeproof/comparison/causes/causes.hpp"
#include "edgeproof/comparison/input/result_table.hpp"
#include "edgeproof/comparison/measures/alignment.hpp"
#include "edgeproof/comparison/measures/convergence.hpp"
#include "edgeproof/comparison/measures/coverage.hpp"
#include "edgeproof/comparison/measures/data_edges.hpp"
#include "edgeproof/comparison/measures/edge_fit.hpp"
#include "edgeproof/comparison/measures/exact_contact.hpp"
#include "edgeproof/comparison/measures/measures.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// Which error of the pressure is held against the tolerance.
enum class Norm { peak, local, l2 };

/// What data are held to. Edges, force and c_0 of the data are held against what the same rule
/// makes of the exact pressure at the same nodes: how far that is from the exact value is the
/// mesh's width and no error of the data.
struct Tolerances {
    static constexpr double usual = 0.03;
    double pressure = usual;
    bool stated = false; ///< `pressure` is the user's own
    Norm of = Norm::peak;
    EdgeZone zone;
    std::optional<double> edges; ///< of a and b, each relative to itself
    std::optional<double> force;
    std::optional<double> c0; ///< at both edges
    std::optional<double> q;  ///< in the norm of `of`; without it, as the pressure
    /// The data hold a part of the contact: they need not determine a, b, P and the largest p,
    /// unless they have a tolerance of their own.
    bool partial = false;
};

/// Of nodes inside the exact contact: fewer are too few to judge by.
inline constexpr std::size_t fewest_inside = 3;

/// A result held against a scene.
struct FileComparison {
    ResultTable table;
    AlignedResult data;
    DataContact contact;
    DataContact of_exact; ///< what the same rules make of the exact pressure at the same nodes
    Errors errors;        ///< outside the edge zones
    Errors all;           ///< of all nodes
    std::optional<Errors> shear; ///< of q, outside the edge zones, where there is one
    std::optional<double> Q;     ///< by trapezoids, over nodes that have an exact q
    std::optional<double> Q_of_exact;
    std::vector<DistanceErrors> distances;
    std::vector<KnotErrors> knots;
    std::array<std::optional<EdgeFit>, 2> fits; ///< by index_of(edge)
    std::vector<Undetermined> undetermined;
    std::size_t inside = 0;
    std::size_t outside = 0;
    std::size_t pressing_outside = 0;   ///< of those, with more than 1/500 of the largest pressure
    std::optional<Diagnosis> diagnosis; ///< where there is something to explain
    std::optional<Diagnosis> shear_diagnosis; ///< of q, where p is right
    std::vector<std::string> failures;        ///< why it does not pass, a sentence each

    [[nodiscard]] bool passes() const { return failures.empty(); }
    [[nodiscard]] std::vector<std::string> findings() const;
};

struct Comparison {
    Tolerances tolerances;
    std::vector<FileComparison> files;
    std::vector<Convergence> convergence; ///< of two files or more
    [[nodiscard]] bool passes() const;
};

/// `origin`: where the scene's origin lies in the data's x; none: it is fitted, which only a user
/// can ask for. Data that do not pass, or are off by more than 3/1000 of the peak, are diagnosed
/// where the suspects of the scene are given.
[[nodiscard]] FileComparison compare_file(ResultTable table, const ExactContact& exact,
                                          const Tolerances& tolerances,
                                          const std::optional<Rational>& origin,
                                          SuspectContacts* suspects = nullptr);
/// Orders and limits of a, b, P, c_0, the largest pressure and the errors, where every file has
/// them.
[[nodiscard]] std::vector<Convergence> convergence_of(const std::vector<FileComparison>& files,
                                                      const ExactContact& exact);

} // namespace edgeproof::comparison
