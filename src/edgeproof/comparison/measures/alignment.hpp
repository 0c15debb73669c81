// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/input/result_table.hpp"
#include "edgeproof/comparison/measures/exact_contact.hpp"

#include <optional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// A shear traction of the data, with the exact one beside it.
struct NodeShear {
    double q = 0;                ///< of the data, in the scene's direction
    std::optional<double> exact; ///< nothing where it is infinite
    double error = 0;            ///< q - exact q; 0 where that is infinite
    double rounding = 0;         ///< how far q and x as they are written may move that
};

/// A node of a result, with the exact pressure beside it.
struct Node {
    std::size_t line = 0;
    double x = 0; ///< from the scene's origin
    double p = 0; ///< of the data, positive in compression
    ExactContact::Place exact;
    double error = 0;                    ///< p - exact p, both unrounded; 0 on a corner
    double rounding = 0;                 ///< how far p and x as they are written may move that
    std::optional<NodeShear> shear = {}; ///< where data and scene have one
};

/// Data laid over the exact solution.
struct AlignedResult {
    std::vector<Node> nodes; ///< by x
    double sign = 1;         ///< of compression in the data
    double shear_sign = 1;   ///< of the scene's direction of q in the data
    double origin = 0;       ///< where the scene's origin lies in the data's x
    bool origin_found = false;
    /// Data that begin (or end) in the middle of a symmetric contact.
    std::optional<contact::Edge> half;
    std::vector<std::string> findings;
};

/// `origin`: where the scene's origin lies in the data's x; without it, origin_of() the data, or 0
/// where that finds none. Pass none only where the user asks for a fitted origin: a shift is an
/// error of the data.
[[nodiscard]] AlignedResult align(const ResultTable& table, const ExactContact& exact,
                                  const std::optional<Rational>& origin);

} // namespace edgeproof::comparison
