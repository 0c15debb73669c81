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

} // namespace edgeproof::validation
