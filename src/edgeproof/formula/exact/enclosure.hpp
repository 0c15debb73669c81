// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/real.hpp"

#include <optional>

namespace edgeproof::formula {

/// Two numbers between which the exact value lies, or one of which it is.
struct Enclosure {
    Real lower;
    Real upper;
};

/// Returns an enclosure of a constant expression by ball arithmetic (Arb) at `bits` bits. Nothing
/// if the balls at that precision do not exclude a point where the expression is undefined. Throws
/// Error for an integral, and for a name without a value.
[[nodiscard]] std::optional<Enclosure> enclose(const Expr& constant, long bits);

} // namespace edgeproof::formula
