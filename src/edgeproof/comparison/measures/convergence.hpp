// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// A quantity as meshes of several widths have it.
struct MeshValue {
    double h = 0; ///< width of an element
    double value = 0;
};

/// What the values of finer and finer meshes tell. Everything here is an estimate.
struct Convergence {
    std::string quantity; ///< "a", "P", "c0", "peak", ...
    double exact = 0;
    /// The slope of log |value - exact| over log h, by least squares over all meshes.
    std::optional<double> order;
    /// By the last three meshes alone, without the exact value: p of value = limit + C h^p.
    std::optional<double> own_order;
    std::optional<double> extrapolated;
    /// How far the extrapolated value may be off: the grid convergence index of `roache1998`, 1.25
    /// times what is left of the finest mesh's error, 3 times where the meshes do not show that
    /// their orders agree.
    double extrapolation_error = 0;
    /// Four meshes or more, and the orders of the last two triples agree to a fifth.
    bool trusted = false;
    std::string why_not; ///< trusted, or extrapolated
    /// Whether the extrapolated value comes to the exact one within its own estimate.
    std::optional<bool> agrees;
};

/// The values from the coarsest mesh to the finest.
[[nodiscard]] Convergence converge(std::string quantity, std::vector<MeshValue> values,
                                   double exact);
/// The same of an error, which goes to 0 by itself: no extrapolation.
[[nodiscard]] Convergence converge_error(std::string quantity, std::vector<MeshValue> errors);

} // namespace edgeproof::comparison
