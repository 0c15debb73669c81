// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"
#include "edgeproof/quadrature/integrand_ref.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"

#include <optional>

namespace edgeproof::quadrature {

/// The integral of f over an interval of that length by Gauss-Legendre rules, for an integrand that
/// is a power series in the root of the distance from each end (from d^(-1/2) on), which maps by a
/// sine take away, and smooth between. `beyond_lo`, `beyond_hi`: how far beyond an end there is
/// another root (0: none known); one that is near is taken away by a hyperbolic sine. f is called
/// with the distances from both ends, both exact, none of them smaller than 1e-15 of the interval
/// unless there is a near root beyond.
///
/// Rules of 10, 15, 22, ... nodes (more, for more digits); converged where the digits that the last
/// two share, which grow like the number of nodes, say that the last has those of the working
/// precision. `estimate` is what is foreseen so. Nothing for an integrand that does not converge
/// so, which a few small rules tell (a logarithm or another power at an end, a kink inside): for
/// those there is integrate_near.
[[nodiscard]] std::optional<QuadratureResult<Real>>
integrate_root_ends(const IntegrandRef<Real, Real>& f, const Real& length, const Real& beyond_lo,
                    const Real& beyond_hi);

} // namespace edgeproof::quadrature
