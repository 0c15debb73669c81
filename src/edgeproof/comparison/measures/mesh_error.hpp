// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/input/result_table.hpp"

#include <optional>
#include <vector>

/// The error that a correct mesh has by itself, away from the edges: the root mean square over
/// nodes two elements or more from an edge, relative to the largest pressure. All are estimates.
namespace edgeproof::comparison {

/// The product of this error and of the number of elements in the contact is at most this in all
/// runs of CalculiX in examples/third-party/solvers/mesh-errors.csv; mesh_errors.py there makes
/// that file, and a test compares the number with it.
inline constexpr double mesh_error_times_elements = 0.06;

/// The same if the profile has a corner, where p is infinite: the greatest error of the scale of p
/// by the boundary elements of spring_bed.hpp with rigid springs, on the contacts of the self-test.
inline constexpr double mesh_error_by_corner_times_elements = 0.15;

/// The error to expect of one mesh, `elements` wide.
[[nodiscard]] inline double expected_mesh_error(double elements, bool corner) {
    return (corner ? mesh_error_by_corner_times_elements : mesh_error_times_elements) /
           (elements > 1 ? elements : 1);
}

/// The errors of several meshes of one contact, from their differences from the finest one: error
/// = C h^q, with q between 1/2 and 4 from the first and the last but one of three meshes or more,
/// and q = 1 of two. In the order of the tables. Nothing for a single mesh, for meshes of the same
/// width, and for data without pressure.
[[nodiscard]] std::optional<std::vector<double>>
mesh_errors(const std::vector<ResultTable>& tables);

} // namespace edgeproof::comparison
