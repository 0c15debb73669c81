// SPDX-License-Identifier: GPL-3.0-or-later
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
[[family]]
name = "powers"
profile = "power-law"
count = 2
u = ["1/20", "1/5"]
[family.parameters]
m = ["1", "2", "4", "8", "16", "32", "64"]
C = ["3/7", "1e-6"]
a = ["3/2", "7e5"]
Es = ["7/3"]
[[family]]
name = "nine"
profile = "power-law"
count = 9
[family.parameters]
m = ["1", "2", "3"]
C = ["3/7", "1e-6"]
a = ["3/2", "7e5", "0.02"]
Es = ["7/3"]
[[family]]
name = "five-eighths"
profile = "power-law"
count = 1
[family.parameters]
m = ["5/8"]
C = ["1"]
a = ["3/2"]
Es = ["1"]
[[family]]
name = "curved"
profile = "piecewise-symmetric"
count = 1
knots = []
slopes = ["x/6 + x^3/8"]
[family.parameters]
a = ["3/4"]
Es = ["7/3"]
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

inline ClaimResult result_of(const std::string& claim, unsigned digits = 34) {
    return audit_of(claim, digits).claims.front();
}

inline std::string verdict_of(const std::string& claim, unsigned digits = 34) {
    return std::string(name_of(result_of(claim, digits).outcome.verdict));
}

} // namespace edgeproof::small_ledger
