// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/agreement/samples.hpp"

#include <optional>

namespace edgeproof::audit {

/// Returns the reason why a formula has no value at a sample, if it is one of these: a division by
/// an expression that is zero (by symbols), or its logarithm or negative power; a root, a logarithm
/// or an inverse function of a number outside its domain; pressure or full-stick traction at a
/// place outside the contact; the law of a contact (b, its inverse, P, P') at a size that is not
/// positive. A number must be beyond its domain by more than 1e-20 of its terms, while some hundred
/// digits are used. Integrals are checked at some places within their limits. `proved`: by symbols
/// or by a ball. Returns nothing if roundoff may be the cause.
[[nodiscard]] std::optional<NoValue> no_value_of(const formula::Expr& e,
                                                 const EvaluatedSample& sample_at);

} // namespace edgeproof::audit
