// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/real.hpp"

#include <optional>

namespace edgeproof::formula {

/// Two numbers with the exact value between them, or at one of them.
struct Enclosure {
    Real lower;
    Real upper;
};

/// An enclosure of a constant expression, by ball arithmetic (Arb) with balls of `bits` bits.
/// Nothing if the ball arithmetic at that precision cannot exclude a point where the expression
/// is undefined. Throws Error for an integral, and for a name without a value.
[[nodiscard]] std::optional<Enclosure> enclose(const Expr& constant, long bits);

} // namespace edgeproof::formula
