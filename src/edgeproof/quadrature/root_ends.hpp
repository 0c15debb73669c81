// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"
#include "edgeproof/quadrature/integrand_ref.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"

#include <optional>

namespace edgeproof::quadrature {

/// The integral of f over an interval of the given length by Gauss-Legendre rules. The integrand
/// must be a power series in the root of the distance from each end (from d^(-1/2) on), and smooth
/// between the ends; maps with a sine remove the roots. `beyond_lo`, `beyond_hi`: the distances of
/// further roots beyond the ends (0: none known); a map with a hyperbolic sine removes one that is
/// near. f is called with the distances from both ends, both with all their digits. They are not
/// smaller than 1e-15 of the interval unless there is a near root beyond. The result has the unit
/// of f times that of `length`.
///
/// The rules have 10, 15, 22, ... nodes (more for more digits). The digits that two rules share
/// grow like the number of nodes (`trefethen2013`, theorem 19.3). The quadrature is converged when
/// this growth predicts that the last rule has the digits of the working precision; `estimate` is
/// the prediction. Returns nothing for an integrand that does not converge like this, which a few
/// small rules show (a logarithm or another power at an end, a kink inside): use integrate_near for
/// these.
[[nodiscard]] std::optional<QuadratureResult<Real>>
integrate_root_ends(const IntegrandRef<Real, Real>& f, const Real& length, const Real& beyond_lo,
                    const Real& beyond_hi);

} // namespace edgeproof::quadrature
