// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/page/html.hpp"
#include "edgeproof/report/verdicts/verdict_writers.hpp"
#include "tests/audit/small_ledger.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

TEST_CASE("a formula without a source: no output states its lines") {
    using small_ledger::audit_of;
    const std::string hertz = "kind = \"compare\"\nover = \"hertz\"\nof = \"p(x)\"\n"
                              "says = \"Es*C*sqrt(a^2 - x^2)\"\n";
    using test::has;
    const AuditResult mine = audit_of(hertz);
    const AuditResult printed = audit_of(hertz + "lines = [12, 15]\nprinted = \"p\"\n");
    CHECK(has(html_page(printed, {}), "lines 12–15 of the source"));
    CHECK_FALSE(has(html_page(mine, {}), "line 0"));
    CHECK_FALSE(has(html_page(mine, {}), "of the source"));
    CHECK(has(verdicts_json(printed), "\"lines\": \"12-15\""));
    CHECK(has(verdicts_json(mine), "\"lines\": null"));
    CHECK(has(verdicts_csv(printed), "C,12-15,"));
    CHECK(has(verdicts_csv(mine), "C,,"));
    CHECK(has(verdicts_markdown(mine), "| C |  |"));
    CHECK(has(verdicts_latex(mine), "C &  &"));
}
