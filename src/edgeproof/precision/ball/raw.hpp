// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"

namespace edgeproof {

/// The pointers that MPFR's functions take: the inner loops of contact/batch call these functions
/// without temporaries.
[[nodiscard]] inline mpfr_ptr raw(Real& x) { return x.backend().data(); }
[[nodiscard]] inline mpfr_srcptr raw(const Real& x) { return x.backend().data(); }

} // namespace edgeproof
