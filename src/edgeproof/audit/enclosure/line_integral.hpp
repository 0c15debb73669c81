// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/integrand.hpp"

namespace edgeproof::audit {

/// The integral of f, as it is counted from its centre, along the straight line from v to w; these
/// may be boxes, and then it holds the integral between any two points of theirs.
[[nodiscard]] Box line_integral(Integrand& f, const Box& v, const Box& w, unsigned digits);

} // namespace edgeproof::audit
