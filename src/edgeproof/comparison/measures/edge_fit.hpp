// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/measures/alignment.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgeproof::comparison {

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
