// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/run.hpp"

#include "tests/audit/small_ledger.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

const Evidence& clearest_of(const AuditResult& result) {
    const EvidenceItem* item = result.claims.front().outcome.evidence.find("clearest");
    REQUIRE(item != nullptr);
    return std::get<Evidence>(item->value());
}
std::string text_in(const Evidence& evidence, const char* key) {
    const EvidenceItem* item = evidence.find(key);
    return item == nullptr ? "missing" : item->text();
}

} // namespace

TEST_CASE("the clearest counterexample: small numbers, exact values") {
    // Hertz: p = E* C sqrt(a^2 - x^2)/2, so that p(0) = 1/2 if all parameters are 1.
    const AuditResult result = small_ledger::audit_of(
        "kind = \"value\"\nover = \"hertz\"\nof = \"p(x)\"\nsays = \"Es*C*sqrt(a^2 - x^2)\"\n");
    REQUIRE(result.claims.front().outcome.verdict == Verdict::refuted);
    const Evidence& clearest = clearest_of(result);
    const auto& with = std::get<Evidence>(clearest.find("with")->value());
    CHECK(text_in(with, "Es") == "1");
    CHECK(text_in(with, "C") == "1");
    CHECK(text_in(with, "a") == "1");
    CHECK(text_in(with, "x") == "0");
    CHECK(text_in(clearest, "printed_value") == "1");
    CHECK(text_in(clearest, "correct_value") == "1/2");
    CHECK(text_in(clearest, "correct_decimal") == "0.50000000");
}

TEST_CASE("a true claim has no counterexample") {
    const AuditResult result = small_ledger::audit_of(
        "kind = \"value\"\nover = \"hertz\"\nof = \"p(x)\"\nsays = \"Es*C*sqrt(a^2 - x^2)/2\"\n");
    CHECK(result.claims.front().outcome.evidence.find("clearest") == nullptr);
}
