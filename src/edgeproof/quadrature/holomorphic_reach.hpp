// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/acb_include.hpp"
#include "edgeproof/quadrature/bernstein.hpp"

#include <functional>
#include <optional>

namespace edgeproof::quadrature {

/// An ellipse about an interval in which a function is proved to be holomorphic, and a bound of it.
struct HolomorphicReach {
    BernsteinEllipse ellipse;
    double ln_bound;
};

/// F(out, phi) encloses the values of a function of phi over a complex ball; not finite if the
/// function may not be holomorphic on all of it.
using ComplexFunction = std::function<void(acb_t out, const acb_t phi)>;
/// Returns, among a sequence of ellipses, the one that needs the fewest nodes for a tolerance of
/// exp(ln_tolerance) relative to the function, and extends at most `most_excess` beyond the
/// interval; nothing if no ellipse is proved. Every ellipse is covered with balls, so that the
/// result is proved; an ellipse that is not found may still be valid (docs/pressure.md, "Many
/// points of one contact"). `centre`, `half` and `most_excess` have the unit of phi.
[[nodiscard]] std::optional<HolomorphicReach> holomorphic_reach(const ComplexFunction& f,
                                                                double centre, double half,
                                                                double most_excess,
                                                                double ln_tolerance);

} // namespace edgeproof::quadrature
