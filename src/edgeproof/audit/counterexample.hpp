// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/audit_result.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

#include <optional>

namespace edgeproof::audit {

/// Returns the clearest numbers that show a refuted claim to be wrong. They are small and whole
/// where possible, so that a reader can check them by hand. (The samples used for a verdict are
/// chosen to find errors, not to show them.) All decimals are rounded from enclosures.
///
/// For a formula, the symbols get small numbers; `printed` and `correct` are the formulas,
/// `printed_value` and `correct_value` their exact values (left out where there is no closed form),
/// and decimals are added. For the reach of an approximation: a distance at which the error is on
/// the other side of the tolerance. For a quantity stated to increase or decrease: two values of
/// the parameter. Returns nothing for other kinds, or if no counterexample is found.
[[nodiscard]] std::optional<Evidence> clearest_counterexample(const ClaimResult& result,
                                                              const AuditContext& context);

} // namespace edgeproof::audit
