// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/agreement/samples.hpp"

#include <optional>

namespace edgeproof::audit {

/// Why a formula has no value at a sample, if one of these is the cause: division by what is zero
/// (by symbols), or the logarithm or a negative power of it; a root, a logarithm or an inverse
/// function of a number outside its domain, pressure or full-stick traction at a place beyond the
/// contact, or the law of a contact (b, its inverse, P, P') at a size that is not positive,
/// by more than 1e-20 of the terms that the number is the sum of, where some hundred digits are
/// carried; in an integral, at one of some places within its limits. `proved`: by symbols, or a
/// ball bears it out. Nothing where roundoff may be the cause.
[[nodiscard]] std::optional<NoValue> no_value_of(const formula::Expr& e,
                                                 const EvaluatedSample& sample_at);

} // namespace edgeproof::audit
