// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/acb_include.hpp"
#include "edgeproof/quadrature/bernstein.hpp"

#include <functional>
#include <optional>

namespace edgeproof::quadrature {

/// An ellipse about a piece, in which a function is proved to be holomorphic, and a bound of it.
struct HolomorphicReach {
    BernsteinEllipse ellipse;
    double ln_bound;
};

/// F(out, phi) encloses the values of a function of phi over a complex ball, not finite where it
/// may not be holomorphic on all of it. The ellipse among a sweep of them that asks for the fewest
/// nodes at a tolerance of exp(ln_tolerance) of the function, and reaches no further than
/// `most_excess` beyond the interval; nothing where none is proved. Every ellipse is covered with
/// balls: what is found is proved, what is not found may yet be true.
using ComplexFunction = std::function<void(acb_t out, const acb_t phi)>;
[[nodiscard]] std::optional<HolomorphicReach> holomorphic_reach(const ComplexFunction& f,
                                                                double centre, double half,
                                                                double most_excess,
                                                                double ln_tolerance);

} // namespace edgeproof::quadrature
