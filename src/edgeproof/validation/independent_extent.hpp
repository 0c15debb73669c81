// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/validation/second_route.hpp"

namespace edgeproof::validation {

/// The first exit by a scan that shares nothing with contact/extent.hpp but the coefficients: the
/// pressure is the printed formula at more digits than it loses, every local maximum of the error
/// on a grid is narrowed down by thirds before it is said to stay inside, the root is halved to.
/// Throws DomainError where no exit is found.
[[nodiscard]] SecondRoute independent_extent(const scene::Scene& scene,
                                             const scene::AskedValue& asked, unsigned digits);

/// The error |1 - (n terms)/p| at the local maximum of it that lies nearest the edge, to `digits`
/// digits: what a tolerance has to be for the curve to touch it.
struct Summit {
    Real u;
    Real error;
};
[[nodiscard]] Summit first_summit(const scene::Scene& scene, contact::Edge edge, std::size_t n,
                                  unsigned digits);

} // namespace edgeproof::validation
