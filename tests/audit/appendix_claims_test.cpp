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

TEST_CASE("dependence: functions of others are distinguished from other quantities") {
    // The first multipliers of the two edges differ only by the factor b'.
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
    // If b'' is given, too, it is a function: P' and P'' follow from the right edge.
    CHECK(appendix_verdict(dependence("left.c1",
                                      "\"right.c0\", \"right.c1\", \"b1\", \"b2\", \"a\", \"b\"",
                                      "function")) == Verdict::confirmed);
    // The quantities may be products and quotients.
    CHECK(appendix_verdict(dependence("P1*P2", "\"P1/P2\", \"P2^3\"", "function")) ==
          Verdict::confirmed);
    CHECK(appendix_verdict(dependence("P1*P2", "\"P1/P2\"", "independent")) == Verdict::confirmed);
}

TEST_CASE("dependence: tiny differences, and quantities that are zero") {
    const auto both = [](const std::string& of, const std::string& from) {
        return std::pair(appendix_verdict(dependence(of, from, "function")),
                         appendix_verdict(dependence(of, from, "independent")));
    };
    const std::pair no_function(Verdict::refuted, Verdict::confirmed);
    const std::pair function(Verdict::confirmed, Verdict::refuted);
    CHECK(both("a + 1e-13*P2", "\"a\"") == no_function);
    CHECK(both("a + 1e-300*P2", "\"a\"") == no_function);
    CHECK(both("a + 1e-300*b1*P2", "\"a\", \"b1\", \"P1*P2\"") == no_function);
    CHECK(both("a + 1e13*P2", "\"a\", \"P2^3\"") == function);
    CHECK(both("right.c0 - 2/(Pi*sqrt(a+b))*P1", "\"b2\"") == function);
    CHECK(both("sin(P1*b1)^2 + cos(P1*b1)^2", "\"a\"") == function);
    // Some of the others depend on each other.
    CHECK(both("P1^2*b1", "\"P1\", \"P1^3\", \"b1\"") == function);
    CHECK(both("P1^2*b1 + 1e-40*b2", "\"P1\", \"P1^3\", \"b1\", \"b1*P1\"") == no_function);
    CHECK(both("P1 + P2", "\"P1*P2\", \"P1^2*P2^2\"") == no_function);
    // These products have nearly parallel gradients.
    CHECK(both("P1*(P2 + 1e-30*b2)", "\"P1*P2\", \"P1*b2*b1\", \"b1\"") == function);
    CHECK(both("P1*(P2 + 1e-30*b2^2)", "\"P1*P2\", \"P1*b2*b1\", \"b1\"") == no_function);
    // This function has no symbolic derivative.
    CHECK(both("asinh(P1)", "\"P1\"") == std::pair(Verdict::undecided, Verdict::undecided));
}

TEST_CASE("uniformity: a pole is distinguished from a bounded remainder") {
    const char* with_pole = "1 + eps*s + eps^2*s^2/(1-s)";
    CHECK(appendix_verdict(uniformity(with_pole, "1 + eps*s", "breaks down")) ==
          Verdict::confirmed);
    CHECK(appendix_verdict(uniformity(with_pole, "1 + eps*s", "uniform")) == Verdict::refuted);
    const char* without = "1 + eps*s + eps^2*(1-s^3)/(1-s)";
    CHECK(appendix_verdict(uniformity(without, "1 + eps*s", "breaks down")) == Verdict::refuted);
    CHECK(appendix_verdict(uniformity(without, "1 + eps*s", "uniform")) == Verdict::confirmed);
    // The term that is stated to break down is compared with the remainder, in balls.
    const Outcome refuted = appendix_outcome(uniformity(without, "1 + eps*s", "breaks down") +
                                             "term = \"s^3/(1-s)\"\n");
    CHECK(refuted.verdict == Verdict::refuted);
    const EvidenceItem* balls = refuted.evidence.find("enclosures");
    REQUIRE(balls != nullptr);
    CHECK(std::get<bool>(std::get<Evidence>(balls->value()).find("disjoint")->value()));
    // A term that stays bounded is not compared.
    const Outcome bounded =
        appendix_outcome(uniformity(without, "1 + eps*s", "breaks down") + "term = \"s^3\"\n");
    const EvidenceItem* others = bounded.evidence.find("enclosures");
    REQUIRE(others != nullptr);
    CHECK(std::get<Evidence>(others->value()).find("printed") == nullptr);
}

TEST_CASE("uniformity: slow growth, boundary layers and exact expansions") {
    struct Case {
        const char* of;
        const char* approximation;
        bool breaks;
    };
    // The remainders are (1-s)^(-1/2), log, 1/(1-s+eps), (1-s)/((1-s)^2 + eps^2), log(1-s+eps). The
    // last three are bounded for each eps, but not uniformly.
    for (const Case& c : {Case{"1 + eps^2/sqrt(1-s)", "1", true},
                          {"1 + eps + eps^2*log(1-s)", "1 + eps", true},
                          {"1 + eps^2/(1-s+eps)", "1", true},
                          {"1 + eps^2*(1-s)/((1-s)^2+eps^2)", "1", true},
                          {"1 + eps^2*cos(1-s)", "1", false},
                          {"1 + eps^2*(2+sqrt(1-s))", "1", false},
                          {"1 + eps^2*(1-s)*log(1-s)", "1", false},
                          {"1 + eps^2*(1-s)/(1-s+eps)", "1", false}}) {
        CAPTURE(c.of);
        const Verdict breaks = appendix_verdict(uniformity(c.of, c.approximation, "breaks down"));
        const Verdict uniform = appendix_verdict(uniformity(c.of, c.approximation, "uniform"));
        CHECK(breaks != (c.breaks ? Verdict::refuted : Verdict::confirmed));
        CHECK(uniform != (c.breaks ? Verdict::confirmed : Verdict::refuted));
    }
    CHECK(appendix_verdict(uniformity("1 + eps^2/sqrt(1-s)", "1", "breaks down")) ==
          Verdict::confirmed);
    CHECK(appendix_verdict(uniformity("1 + eps + eps^2*log(1-s)", "1 + eps", "uniform")) ==
          Verdict::refuted);
    CHECK(appendix_verdict(uniformity("1 + eps^2/(1-s+eps)", "1", "uniform")) == Verdict::refuted);
    CHECK(appendix_verdict(uniformity("1 + eps^2*cos(1-s)", "1", "uniform")) == Verdict::confirmed);
    // The remainder is bounded, but only beyond the distance 1e-400, and by 1e400.
    CHECK(appendix_verdict(uniformity("1 + eps^2/(1-s+1e-400)", "1", "breaks down")) ==
          Verdict::undecided);
    // The remainder has order 1, not 2, for every s: there is no expansion to that order.
    CHECK(appendix_verdict(uniformity("1 + eps + eps^2/(1-s)", "1", "uniform")) ==
          Verdict::refuted);
    CHECK(appendix_verdict(uniformity("1 + eps*s + eps^2", "1", "breaks down")) ==
          Verdict::undecided);
    // The remainder is zero.
    CHECK(appendix_verdict(uniformity("(1+eps*s)^2", "1 + 2*eps*s + eps^2*s^2", "breaks down")) ==
          Verdict::refuted);
    CHECK(appendix_verdict(uniformity("(1+eps*s)^2", "1 + 2*eps*s + eps^2*s^2", "uniform")) ==
          Verdict::proved);
    CHECK(appendix_verdict(uniformity("b/a + eps", "bof(a)/a + eps", "breaks down")) ==
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
    // The expansion is wrong at eps^1, and the remainder is of that order.
    const Outcome other = appendix_outcome(claim(integrand, "1/sqrt((1-s)*(1+eps*s^2))"));
    CHECK(other.evidence.find("as_if")->text().find("they do not cancel") != std::string::npos);
    // No other term can cancel a pole at the end.
    const Outcome pole =
        appendix_outcome(claim(integrand, "1/sqrt(1-s)*(1 - eps*s/2 + eps/(1-s))"));
    CHECK(pole.evidence.find("as_if")->text().find("not integrable") != std::string::npos);
}
