// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/integrand.hpp"

namespace edgeproof::audit {

/// Returns the integral of f, in the variable of its centre, along the straight line from v to w.
/// For boxes v and w, the result contains the integral between any two of their points.
[[nodiscard]] Box line_integral(Integrand& f, const Box& v, const Box& w, unsigned digits);

} // namespace edgeproof::audit
