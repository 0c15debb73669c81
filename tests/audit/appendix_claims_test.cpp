// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/run.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

const std::string appendix_head = R"(
[ledger]
name = "appendix"
[[family]]
name = "punch"
profile = "tilted-flat-and-rounded"
count = 1
[family.parameters]
alpha = ["1/10"]
t = ["1"]
R = ["2"]
a = ["1/4"]
Es = ["7/3"]
[[family]]
name = "wedge"
profile = "tilted-wedge"
count = 1
[family.parameters]
phi = ["1/5"]
alpha = ["1/10"]
a = ["3/2"]
Es = ["1"]
)";

Outcome appendix_outcome(const std::string& fields) {
    const Ledger ledger = parse_ledger(
        appendix_head + "[[claim]]\nid = \"A\"\nedge = \"left\"\n" + fields, "appendix.toml");
    AuditOptions options;
    options.digits = 34;
    options.threads = 1;
    return run_audit(ledger, options).claims[0].outcome;
}
Verdict appendix_verdict(const std::string& fields) { return appendix_outcome(fields).verdict; }

std::string dependence(const std::string& of, const std::string& from, const std::string& says) {
    return "kind = \"dependence\"\nover = \"punch\"\nof = \"" + of + "\"\nfrom = [" + from +
           "]\nsays = \"" + says + "\"\n";
}

std::string uniformity(const std::string& of, const std::string& approximation,
                       const std::string& says) {
    return "kind = \"uniformity\"\nover = \"wedge\"\nof = \"" + of + "\"\napproximation = \"" +
           approximation + "\"\nsays = \"" + says +
           "\"\nsmall = \"eps\"\norder = 2\nvariable = \"s\"\ntowards = \"1\"\nvary = { eps = "
           "[\"1e-30\"], s = [\"1/2\"] }\n";
}

} // namespace

TEST_CASE("dependence: a function of others is told from what is none") {
    // The first multipliers of the two edges differ by b' alone.
    CHECK(appendix_verdict(dependence("left.c0", "\"right.c0\", \"b1\"", "function")) ==
          Verdict::confirmed);
    CHECK(appendix_verdict(dependence("left.c0", "\"right.c0\", \"b1\"", "independent")) ==
          Verdict::refuted);
    CHECK(appendix_verdict(dependence("left.c0", "\"right.c0\"", "independent")) ==
          Verdict::confirmed);
    const Outcome second = appendix_outcome(
        dependence("left.c1", "\"right.c0\", \"right.c1\", \"b1\", \"a\", \"b\"", "independent"));
    CHECK(second.verdict == Verdict::confirmed);
    CHECK(second.note.find("b2") != std::string::npos);
    // With b'' given it is one: P' and P'' follow from the right edge.
    CHECK(appendix_verdict(dependence("left.c1",
                                      "\"right.c0\", \"right.c1\", \"b1\", \"b2\", \"a\", \"b\"",
                                      "function")) == Verdict::confirmed);
    // Products and quotients hide nothing.
    CHECK(appendix_verdict(dependence("P1*P2", "\"P1/P2\", \"P2^3\"", "function")) ==
          Verdict::confirmed);
    CHECK(appendix_verdict(dependence("P1*P2", "\"P1/P2\"", "independent")) == Verdict::confirmed);
}

TEST_CASE("uniformity: a pole is told from a bounded rest") {
    const char* with_pole = "1 + eps*s + eps^2*s^2/(1-s)";
    CHECK(appendix_verdict(uniformity(with_pole, "1 + eps*s", "breaks down")) ==
          Verdict::confirmed);
    CHECK(appendix_verdict(uniformity(with_pole, "1 + eps*s", "uniform")) == Verdict::refuted);
    const char* without = "1 + eps*s + eps^2*(1-s^3)/(1-s)";
    CHECK(appendix_verdict(uniformity(without, "1 + eps*s", "breaks down")) == Verdict::refuted);
    CHECK(appendix_verdict(uniformity(without, "1 + eps*s", "uniform")) == Verdict::confirmed);
    // The term that is said to break down is held to what is left, in balls.
    const Outcome refuted = appendix_outcome(uniformity(without, "1 + eps*s", "breaks down") +
                                             "term = \"s^3/(1-s)\"\n");
    CHECK(refuted.verdict == Verdict::refuted);
    const EvidenceItem* balls = refuted.evidence.find("enclosures");
    REQUIRE(balls != nullptr);
    CHECK(std::get<bool>(std::get<Evidence>(balls->value()).find("disjoint")->value()));
    CHECK(appendix_outcome(uniformity(without, "1 + eps*s", "breaks down") + "term = \"s^3\"\n")
              .evidence.find("enclosures") == nullptr);
    // A rest with half a pole is neither.
    CHECK(appendix_verdict(uniformity("1 + eps^2/sqrt(1-s)", "1", "breaks down")) ==
          Verdict::undecided);
}

TEST_CASE("split: the terms of a cut cancel if the integrand is the one that is expanded") {
    const auto claim = [](const std::string& of, const std::string& as_if) {
        return "kind = \"split\"\nover = \"wedge\"\nvariable = \"s\"\nsmall = \"eps\"\nthrough = "
               "\"1\"\nvary = { eps = [\"1/1000\"], delta = [\"1/5\"], s = [\"1/2\"] }\nof = \"" +
               of + "\"\nas_if = { \"another integrand\" = \"" + as_if + "\" }\n";
    };
    const std::string integrand = "1/sqrt((1-s)*(1+eps*s))";
    const Outcome same = appendix_outcome(claim(integrand, integrand));
    CHECK(same.verdict == Verdict::confirmed);
    CHECK(same.evidence.find("as_if")->text().find("the terms cancel") != std::string::npos);
    // Wrong at eps^1: what is left is of that order.
    const Outcome other = appendix_outcome(claim(integrand, "1/sqrt((1-s)*(1+eps*s^2))"));
    CHECK(other.evidence.find("as_if")->text().find("they do not cancel") != std::string::npos);
    // With a pole at the end nothing can cancel it.
    const Outcome pole =
        appendix_outcome(claim(integrand, "1/sqrt(1-s)*(1 - eps*s/2 + eps/(1-s))"));
    CHECK(pole.evidence.find("as_if")->text().find("not integrable") != std::string::npos);
}
