// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/rounding/print.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"

#include <iosfwd>

namespace edgeproof::scene {

/// Prints a value like a ball, followed by its route: "0.785398 +/- 1.7e-07 (closed-form)". For an
/// estimate, the error is the route's own estimate: "(singular-integral (estimate))".
std::ostream& operator<<(std::ostream& out, const BoundedValue& x);

} // namespace edgeproof::scene
