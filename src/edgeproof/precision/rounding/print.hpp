// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

#include <iosfwd>

namespace edgeproof {

/// Prints a ball as "0.785398 +/- 1.7e-07": its number, rounded correctly to as many significant
/// digits as the precision of the stream (std::setprecision; 6 by default), or to those that are
/// certain, and the bound of |that number - x| for every x in the ball, rounded up. A ball without
/// a certain digit is printed as "[lower, upper]", one that is not finite as "nan".
std::ostream& operator<<(std::ostream& out, const Ball& x);

} // namespace edgeproof
