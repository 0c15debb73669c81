// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/alignment.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// A coefficient by the data: an estimate, with the spread that the fit has.
struct FittedCoefficient {
    double value = 0;
    double spread = 0;
    double of_exact = 0; ///< what the same fit makes of the exact pressure at the same nodes
};

/// c_0 and c_1 of p = c_0 u^(1/2) + c_1 u^(3/2) + ... by least squares over nodes near an edge.
struct EdgeFit {
    FittedCoefficient c0;
    FittedCoefficient c1;
    std::size_t nodes = 0;
    std::size_t terms = 0; ///< the higher ones are nuisance
    double from = 0;       ///< u of the nodes used
    double to = 0;
    bool own_edge = false; ///< u counts from the data's edge
};

/// u counts from the exact edge; where `own_edge`, the data's distance outwards from there, is
/// given, from the data's. `leave_out`: nodes nearer to the edge than this are left to the mesh. Of
/// windows from there up to 1/10 ... 9/10 of the expansion's radius of convergence, and of three to
/// five terms, the fit with the least spread of c_0; none with less than three nodes more than
/// terms. The spread is the standard error of the residuals together with what one term less
/// changes, which tells of the terms left out.
[[nodiscard]] std::optional<EdgeFit> fit_edge(const AlignedResult& data, const ExactContact& exact,
                                              contact::Edge edge, double leave_out,
                                              const std::optional<double>& own_edge = {});

/// The coefficients of least squares |y - sum of c_k column_k|^2, and their standard errors;
/// Householder's QR of columns scaled to unit length. Nothing where the columns are dependent to
/// double precision, or not fewer than the rows.
struct LeastSquares {
    std::vector<double> coefficients;
    std::vector<double> standard_errors;
};
[[nodiscard]] std::optional<LeastSquares>
least_squares(const std::vector<std::vector<double>>& columns, std::span<const double> y);

} // namespace edgeproof::comparison
