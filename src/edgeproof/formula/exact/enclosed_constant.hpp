// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"

namespace edgeproof::formula {

/// A constant in a ball.
[[nodiscard]] Ball enclosed_constant(const Exact& x, long bits);
/// The same of an expression without variables.
[[nodiscard]] Ball enclosed_constant(const Expr& e, long bits);

} // namespace edgeproof::formula
