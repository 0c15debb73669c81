// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/loads.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/audit/small_ledger.hpp"

#include <doctest/doctest.h>

TEST_CASE("linear loads: a second load that has no effect is refused") {
    const Ledger ledger = small_ledger::ledger_of(R"(kind = "definition"
over = "sheared")",
                                                  R"([ledger]
name = "shear"
[[family]]
name = "sheared"
profile = "tilted-wedge"
count = 1
[family.parameters]
phi = ["pi/16"]
alpha = ["phi/3"]
a = ["3/2"]
Es = ["7/3"]
Q = ["3/10"]
sig0 = ["1/3"]
)");
    const AuditContext context(ledger, 34);
    const Claim& claim = ledger.claims.front();
    EnclosedLoads loads(context.scenes(claim).front(), {"Q", "sig0"}, 200);
    CHECK_FALSE(loads.second_for_zero(parse_formula("Q", claim.vocabulary)).is_finite());
    CHECK_THROWS_AS((void)loads.parts(parse_formula("Q*sig0", claim.vocabulary)), DomainError);
    CHECK_THROWS_AS(EnclosedLoads(context.scenes(claim).front(), {"Q", "sigma"}, 200), InputError);
}
