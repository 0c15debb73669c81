// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/audit.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

/// One claim about expansions, over a contact with a nonlinear b(a).
Outcome expansion_outcome(const std::string& claim) {
    const std::string text = R"toml([ledger]
name = "own"
source = "a test"
[[family]]
name = "tilted"
profile = "tilted-flat-and-rounded"
count = 2
[family.parameters]
alpha = ["1/10"]
t = ["1/2", "2"]
R = ["2"]
a = ["5/4"]
Es = ["7/3"]
[[claim]]
id = "X"
kind = "expansion"
lines = [1, 1]
printed = "x"
over = "tilted"
edge = "left"
variable = "eps"
)toml" + claim;
    const AuditResult result = run_audit(parse_ledger(text, "own.toml"), {});
    return result.claims.at(0).outcome;
}

} // namespace

// The reversion of b - y = b(a + d) to second order, by hand: d = -y/b' - y^2 b''/(2 b'^3).
TEST_CASE("a right expansion is proved, and the remainder shows its order in a real contact") {
    const Outcome o = expansion_outcome(R"toml(vary = { eps = ["a*1e-14"], X = ["1/3", "5/7"] }
through = "2"
of = "binv(b-eps*X)-a"
says = "-eps*X/b1 - eps^2*X^2*b2/(2*b1^3)"
)toml");
    CHECK(o.verdict == Verdict::proved);
    const EvidenceItem* order = o.evidence.find("order_of_the_rest");
    REQUIRE(order != nullptr);
    CHECK(order->text().substr(0, 4) == "3.00");
}

TEST_CASE("a wrong term is refuted where it departs, and the edit that corrects it is named") {
    const Outcome o = expansion_outcome(R"toml(vary = { eps = ["a*1e-14"], X = ["1/3", "5/7"] }
through = "2"
of = "binv(b-eps*X)-a"
says = "-eps*X/b1 - eps^2*X^2*b2/(2*b1^2)"
)toml");
    CHECK(o.verdict == Verdict::refuted);
    CHECK(o.evidence.find("first_departure")->text() == "eps^(2)");
    CHECK(o.correct == "-eps*X/b1 - eps^2*X^2*b2/(2*b1^3)");
}

TEST_CASE("an expansion with a term too few is refuted at the power that it leaves out") {
    const Outcome o = expansion_outcome(R"toml(vary = { eps = ["a*1e-14"], X = ["1/3", "5/7"] }
through = "2"
of = "P1of(a-eps*X)"
says = "P1 - eps*X*P2"
)toml");
    CHECK(o.verdict == Verdict::refuted);
    CHECK(o.evidence.find("first_departure")->text() == "eps^(2)");
}

TEST_CASE("hypotheses from which a wrong line would follow are tried and reported") {
    const std::string claim = R"toml(vary = { eps = ["a*1e-14"], X = ["1/3", "5/7"] }
through = "2"
of = "P1of(a-eps*X)"
says = "P1 + eps*X*P2 + eps^2*X^2*P3/2"
as_if = { "the sign of u turned" = "P1of(a+eps*X)", "P for P'" = "Pof(a-eps*X)" }
)toml";
    const Outcome o = expansion_outcome(claim);
    CHECK(o.verdict == Verdict::refuted);
    const auto* tried = std::get_if<Evidence>(&o.evidence.find("as_if")->value());
    REQUIRE(tried != nullptr);
    CHECK(tried->find("the sign of u turned")->text() == "gives the printed line");
    CHECK(tried->find("P for P'")->text() == "does not give the printed line");
}
