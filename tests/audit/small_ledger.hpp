// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/run.hpp"
#include "tests/support/namespaces.hpp"

#include <string>

/// A ledger of a few contacts with results known by hand calculation; each test adds one claim.
namespace edgeproof::small_ledger {

/// Hertz: p = Es C/2 sqrt(a^2 - x^2), so that at the distance u = v a the one-term approximation
/// is 1/sqrt(1 - v/2) times the pressure.
inline const std::string head = R"(
[ledger]
name = "small"
[[family]]
name = "hertz"
profile = "power-law"
count = 2
u = ["1/200"]
[family.parameters]
m = ["1"]
C = ["3/7", "1e-6"]
a = ["3/2", "7e5"]
Es = ["7/3", "2.1e11"]
)";

inline Ledger ledger_of(const std::string& claim, const std::string& families = head) {
    return parse_ledger(families + "[[claim]]\nid = \"C\"\n" + claim + '\n', "small.toml");
}

inline AuditResult audit_of(const Ledger& ledger, unsigned digits = 34) {
    AuditOptions options;
    options.digits = digits;
    options.threads = 1;
    return run_audit(ledger, options);
}
inline AuditResult audit_of(const std::string& claim, unsigned digits = 34) {
    return audit_of(ledger_of(claim), digits);
}

} // namespace edgeproof::small_ledger
