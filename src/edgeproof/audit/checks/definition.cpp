// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"

namespace edgeproof::audit {

CheckKind definition_kind() {
    const auto check = [](const Claim&, const AuditContext&) {
        Outcome outcome;
        outcome.verdict = Judgement::definition();
        return outcome;
    };
    return {"definition", {{.name = "says"}}, check};
}

} // namespace edgeproof::audit
