// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/audit_result.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

#include <optional>

namespace edgeproof::audit {

/// The clearest numbers that show a refuted claim to be wrong: small and whole where they can be,
/// so that a reader checks them by hand. (The samples that a verdict rests on are chosen to find
/// errors, not to show them.) All decimals are rounded from enclosures.
///
/// A formula: its symbols are small numbers; `printed`, `correct` are the formulas,
/// `printed_value`, `correct_value` what they come to exactly (in symbols; missing where that is no
/// closed form), and their decimals. A figure for how far an approximation reaches: a distance at
/// which the error is on the other side of the tolerance. A quantity that is said to grow or to
/// fall: two values of the parameter. Nothing for other kinds, or where none is found.
[[nodiscard]] std::optional<Evidence> clearest_counterexample(const ClaimResult& result,
                                                              const AuditContext& context);

} // namespace edgeproof::audit
