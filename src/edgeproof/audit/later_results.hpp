// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/audit_result.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

namespace edgeproof::audit {

/// Adds to the evidence of each claim that does not hold what the source's later results come to
/// when they are computed with that line as it is printed (the ledger's [[later]], and `as_if` of
/// later claims): `later_results`, a list of {claim, what, comes_to, as_printed}. `as_printed`: the
/// later line, or figure, comes out as the source has it; so the error was carried on, or does not
/// show there. Otherwise the source did not compute it with this line.
void add_later_results(AuditResult& result, const AuditContext& context);

} // namespace edgeproof::audit
