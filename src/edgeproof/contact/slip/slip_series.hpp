// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::contact {

/// The sizes of the slip zones as power series in the load ratio tau = |Q|/(f P), with P and
/// sigma_0/Q held: d = kappa_1 tau + kappa_2 tau^2 + ... (lengths); element 0 is kappa_1.
struct SlipSeries {
    std::vector<Ball> right;
    std::vector<Ball> left;
};

/// The first `terms` coefficients at both edges, enclosed, from the expansions of p there
/// (docs/partial-slip.md, "The series"). `right` and `left` are the coefficients c_0, c_1, ... of
/// p, at least `terms` of each; `length` D = a + b; `lead` = 2 P/(pi sqrt(D)); `tension` =
/// P (sigma_0/Q)/(4 sqrt(D)). The first term gives d_1 = 2 s_0/(f c_0). The work grows like
/// terms^4.
[[nodiscard]] SlipSeries slip_series(const std::vector<Ball>& right, const std::vector<Ball>& left,
                                     const Ball& length, const Ball& lead, const Ball& tension,
                                     std::size_t terms);

/// The sum of the first n terms at the load ratio tau, by Horner's rule (a length).
[[nodiscard]] Ball slip_sum(const std::vector<Ball>& kappa, std::size_t n, const Ball& tau);

} // namespace edgeproof::contact
