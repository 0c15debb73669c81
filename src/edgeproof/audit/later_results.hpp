// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/audit_result.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

namespace edgeproof::audit {

/// For each claim that does not hold, computes the later results of the source from that line as it
/// is printed (the ledger's [[later]], and `as_if` of later claims), and adds them to the evidence:
/// `later_results`, a list of {claim, what, comes_to, as_printed}. `as_printed` is true if the
/// computed value agrees with the printed later line or figure: then the error was carried on, or
/// has no effect there. Otherwise the source did not compute the later result from this line.
void add_later_results(AuditResult& result, const AuditContext& context);

} // namespace edgeproof::audit
