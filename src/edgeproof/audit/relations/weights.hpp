// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <array>
#include <optional>

namespace edgeproof::audit {

/// The exponents of a formula's scaling with the units of force, of length and of shear force.
using ScalingWeights = std::array<Rational, 3>;

/// Finds the weights from the expression tree. Returns nothing if the terms of a sum have different
/// weights, or if a function other than sqrt is called.
[[nodiscard]] std::optional<ScalingWeights> scaling_weights(const formula::Expr& e);

} // namespace edgeproof::audit
