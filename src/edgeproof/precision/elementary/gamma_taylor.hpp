// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof {

/// Returns the first n coefficients of the Taylor series of the gamma function about x, at the
/// working precision, by Arb. Throws DomainError at a pole.
[[nodiscard]] std::vector<Real> gamma_taylor(const Real& x, std::size_t n);

} // namespace edgeproof
