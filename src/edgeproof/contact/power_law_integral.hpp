// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact.hpp"
#include "edgeproof/precision/ball.hpp"

namespace edgeproof {

/// I_m(q), the integral of s^m/sqrt(s^2 - q^2) over q < s < 1, for m >= 0 and 0 <= q < 1: what the
/// pressure of a power law is made of (moore-hills.tex eqn:MossakovskiiPressure), q = |x|/a. An
/// enclosure for every m, the largest included: sums of positive terms, each with a proved
/// remainder. `y` is 1 - q^2, given beside q so that it keeps its digits near the edge;
/// `enclosed_m` holds m.
///
/// Not finite for m = 0 where q may be 0, and where more than some millions of terms would be
/// needed (m beyond about 1e10).
[[nodiscard]] Ball power_law_integral(const Exact& m, const Ball& enclosed_m, const Ball& q,
                                      const Ball& y);

} // namespace edgeproof
