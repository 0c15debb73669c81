// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/validation/second_route.hpp"

namespace edgeproof::validation {

/// Finds the first exit by a scan that uses only the coefficients of the library, not
/// contact/extent.hpp: the pressure is the printed formula with more digits than it loses; every
/// local maximum of the error above half the tolerance is located by trisection; the root is found
/// by bisection. Throws DomainError if there is no exit.
[[nodiscard]] SecondRoute independent_extent(const scene::Scene& scene,
                                             const scene::AskedValue& asked, unsigned digits);

} // namespace edgeproof::validation
