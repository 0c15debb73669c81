// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/loads.hpp"
#include "edgeproof/audit/run.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

const std::string shear_head = R"(
[ledger]
name = "shear"
[define]
d = "(a+b)/2"
[[family]]
name = "sheared"
profile = "tilted-wedge"
count = 4
[family.parameters]
phi = ["pi/16", "1/50"]
alpha = ["phi/3"]
a = ["3/2", "1e-9"]
Es = ["7/3"]
Q = ["3/10", "-2/9"]
sig0 = ["1/3", "-11"]
[[family]]
name = "force-on-wedge"
profile = "tilted-wedge"
count = 2
[family.parameters]
phi = ["pi/16", "1/50"]
alpha = ["phi/3"]
a = ["3/2"]
Es = ["7/3"]
Q = ["3/10", "-2/9"]
sig0 = ["0"]
[[family]]
name = "force-on-flat"
profile = "flat-and-rounded"
count = 2
[family.parameters]
t = ["a/3"]
R = ["3"]
a = ["3/2", "7e5"]
Es = ["7/3"]
Q = ["3/10", "-2/9"]
sig0 = ["0"]
[[family]]
name = "force-alone"
union = ["force-on-wedge", "force-on-flat"]
)";

Outcome shear_outcome(const std::string& fields, unsigned digits = 34) {
    const Ledger ledger =
        parse_ledger(shear_head + "[[claim]]\nid = \"A\"\n" + fields, "shear.toml");
    AuditOptions options;
    options.digits = digits;
    options.threads = 1;
    return run_audit(ledger, options).claims[0].outcome;
}
Verdict shear_verdict(const std::string& fields) { return shear_outcome(fields).verdict; }

std::string vanishing(const std::string& of, const std::string& says) {
    return "kind = \"vanishing\"\nover = \"sheared\"\nloads = [\"Q\", \"sig0\"]\nratio = "
           "\"sig0*d/Q\"\nof = \"" +
           of + "\"\nsays = \"" + says + "\"\n";
}
std::string parts(const std::string& of, const std::string& says, const std::string& more = "") {
    return "kind = \"superposition\"\nover = \"sheared\"\nloads = [\"Q\", \"sig0\"]\nof = \"" + of +
           "\"\nsays = \"" + says + "\"\n" + more;
}

} // namespace

// With D = a + b and z = u/D the traction is [Q/pi +- sigma_0 D (1 - 2z)/8] (1-z)^(-1/2)/sqrt(D u):
// its z^k coefficient vanishes for +-sigma_0 D/Q = -(8/pi) p_k/(p_k - 2 p_{k-1}), where p_k are the
// coefficients 1, 1/2, 3/8, 5/16 of (1-z)^(-1/2). So sigma_0 d/Q = 4/(3 pi) at the right edge for k
// = 1, 12/(5 pi) for k = 2, and the negatives of these at the left edge.
TEST_CASE("vanishing: the ratio of the loads at which a coefficient is zero") {
    CHECK(shear_verdict(vanishing("right.s1", "4/(3*Pi)")) == Verdict::confirmed);
    CHECK(shear_verdict(vanishing("left.s1", "-4/(3*Pi)")) == Verdict::confirmed);
    CHECK(shear_verdict(vanishing("right.s2", "12/(5*Pi)")) == Verdict::confirmed);
    const Outcome wrong =
        shear_outcome(vanishing("left.s1", "4/(3*Pi)") + "elsewhere = [\"right.s1\"]\n");
    CHECK(wrong.verdict == Verdict::refuted);
    REQUIRE(wrong.correct);
    CHECK(wrong.correct->find("-(4/(3*Pi))") != std::string::npos);
    CHECK(wrong.note.find("it is right.s1") != std::string::npos);
    const Outcome factor = shear_outcome(vanishing("right.s1", "8/(3*Pi)"));
    CHECK(factor.verdict == Verdict::refuted);
    REQUIRE(factor.evidence.find("printed_over_exact") != nullptr);
    CHECK(factor.evidence.find("printed_over_exact")->text() == "2");
}

TEST_CASE("superposition: parts that add and parts that subtract, at any signs of the loads") {
    CHECK(shear_verdict(parts("right.s0", "add", "when_zero = \"right.s1\"\n")) ==
          Verdict::confirmed);
    CHECK(shear_verdict(parts("right.s0", "subtract", "when_zero = \"right.s1\"\n")) ==
          Verdict::refuted);
    CHECK(shear_verdict(parts("left.s0", "subtract", "when_zero = \"right.s1\"\n")) ==
          Verdict::confirmed);
    CHECK(shear_verdict(parts("left.s1", "add", "when_zero = \"right.s1\"\n")) ==
          Verdict::confirmed);
    // With arbitrary signs, the loads add in some scenes and subtract in others.
    CHECK(shear_verdict(parts("right.s0", "add")) == Verdict::refuted);
    CHECK(shear_verdict(parts("right.s0", "subtract")) == Verdict::refuted);
    // A quantity that is not linear in the loads has no parts.
    CHECK(shear_verdict(parts("right.s0^2", "add")) == Verdict::undecided);
}

TEST_CASE("independence: quantities that are equal in all scenes, and others") {
    const auto claim = [](const std::string& of) {
        return "kind = \"independence\"\nover = \"force-alone\"\nat = [\"1/1000\", \"1/3\"]\nof = "
               "\"" +
               of + "\"\n";
    };
    CHECK(shear_verdict(claim("q(x)*L/Q")) == Verdict::confirmed);
    CHECK(shear_verdict(claim("q(x)*a/Q")) == Verdict::refuted);
    CHECK(shear_verdict(claim("p(x)*L/P")) == Verdict::refuted);
}

TEST_CASE("linear loads: a second load that has no effect is refused") {
    const Ledger ledger =
        parse_ledger(shear_head + "[[claim]]\nid = \"A\"\nkind = \"definition\"\nover = "
                                  "\"sheared\"\n",
                     "shear.toml");
    const AuditContext context(ledger, 34);
    const Claim& claim = ledger.claims.front();
    EnclosedLoads loads(context.scenes(claim).front(), {"Q", "sig0"}, 200);
    CHECK_FALSE(loads.second_for_zero(parse_formula("Q", claim.vocabulary)).is_finite());
    CHECK_THROWS_AS((void)loads.parts(parse_formula("Q*sig0", claim.vocabulary)), DomainError);
    CHECK_THROWS_AS(EnclosedLoads(context.scenes(claim).front(), {"Q", "sigma"}, 200), InputError);
}
