// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/run.hpp"
#include "edgeproof/report/html.hpp"
#include "edgeproof/report/verdict_writers.hpp"

#include <doctest/doctest.h>

using namespace edgeproof;

TEST_CASE("a formula of no source: nothing that is written names its lines") {
    const auto run = [](const std::string& lines) {
        const Ledger ledger = parse_ledger(R"toml([ledger]
name = "mine"
[[family]]
name = "hertz"
profile = "power-law"
count = 1
u = ["1/3"]
[family.parameters]
m = ["1"]
C = ["3/7"]
a = ["3/2"]
Es = ["7/3"]
[[claim]]
id = "H"
kind = "value"
over = "hertz"
of = "p(x)"
says = "Es*C*sqrt(a^2 - x^2)"
)toml" + lines,
                                           "mine.toml");
        AuditOptions options;
        options.digits = 20;
        options.threads = 1;
        return run_audit(ledger, options);
    };
    const auto contains = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos;
    };
    const AuditResult mine = run("");
    const AuditResult printed = run("lines = [12, 15]\nprinted = \"p\"\n");
    CHECK(contains(html_page(printed, {}), "lines 12–15 of the source"));
    CHECK_FALSE(contains(html_page(mine, {}), "line 0"));
    CHECK_FALSE(contains(html_page(mine, {}), "of the source"));
    CHECK(contains(verdicts_json(printed), "\"lines\": \"12-15\""));
    CHECK(contains(verdicts_json(mine), "\"lines\": null"));
    CHECK(contains(verdicts_csv(printed), "H,12-15,"));
    CHECK(contains(verdicts_csv(mine), "H,,"));
    CHECK(contains(verdicts_markdown(mine), "| H |  |"));
    CHECK(contains(verdicts_latex(mine), "H &  &"));
}
