// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

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

} // namespace edgeproof::comparison
