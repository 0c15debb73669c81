// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <array>
#include <optional>

namespace edgeproof::audit {

/// How a formula scales when forces, lengths and shear forces do, each by a factor of its own.
using ScalingWeights = std::array<Rational, 3>;

/// Read off the tree: the terms of every sum must scale alike. Nothing where they do not, or where
/// a function other than sqrt is called.
[[nodiscard]] std::optional<ScalingWeights> scaling_weights(const formula::Expr& e);

} // namespace edgeproof::audit
