// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/run.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/audit/small_ledger.hpp"

#include <doctest/doctest.h>

// The formulas of partial slip are from the literature or derived by hand, independently of the
// code: Cattaneo 1938 and Mindlin 1949 for Hertz; Hills and Nowell 1994 for the shift sigma_0/(2 f
// E* C) of the stick zone by a tension (e/a = sigma_0/(4 f p_0) with p_0 = E* C a/2). For a
// symmetric profile, the pressure increments between the loads P - |Q|/f and P add up to q/f
// (Jaeger 1998, Ciavarella 1998), so that inside the stick zone q = (f/pi) times the integral of
// P'(s)/sqrt(s^2 - x^2) over stick_a < s < a. For the flat-and-rounded punch, the stick zone ends
// at z, where P(z) = E* z^2/(4 R) (pi - 2 w - sin(2 w)), sin(w) = t/z: F = (E*/2) times the
// integral of sqrt(z^2 - x^2) dg' over t < |x| < z.
namespace {

const std::string slip_head = R"toml(
[ledger]
name = "slip"
[define]
c = "a*sqrt(1 - abs(Q)/(friction*P))"
"k(z)" = "sgn(Q)*friction*Es*C/2*sqrt(max(z, 0))"
shift = "sgn(Q)*sig0/(2*friction*Es*C)"
tau = "abs(Q)/(friction*P)"
[[family]]
name = "hertz"
profile = "power-law"
count = 6
u = ["1e-30", "1e-3", "1/20", "1/3", "1/2", "4/5"]
[family.parameters]
m = ["1"]
C = ["3/7", "1e-6"]
a = ["3/2", "0.02"]
Es = ["7/3", "2.1e11"]
friction = ["3/5", "1/10"]
Q = ["friction*pi*Es*C*a^2/4*3/10", "-friction*pi*Es*C*a^2/4*9/10", "friction*pi*Es*C*a^2/4*1e-9"]
[[family]]
name = "hertz-in-tension"
profile = "power-law"
count = 6
u = ["1e-30", "1e-3", "1/20", "1/3", "1/2", "4/5"]
[family.parameters]
m = ["1"]
C = ["3/7", "1e-6"]
a = ["3/2", "0.02"]
Es = ["7/3", "2.1e11"]
friction = ["3/5", "1/10"]
Q = ["friction*pi*Es*C*a^2/4*3/10", "-friction*pi*Es*C*a^2/4*9/10"]
sig0 = ["friction*Es*C*a/10", "-friction*Es*C*a/11"]
[[family]]
name = "on-the-edge-of-stick"
profile = "power-law"
count = 2
u = ["1/4", "3/4"]
[family.parameters]
m = ["1"]
C = ["3/7", "1e-6"]
a = ["3/2"]
Es = ["7/3"]
friction = ["3/5"]
Q = ["friction*pi*Es*C*a^2/4*3/4"]
[[family]]
name = "wedge-on-the-edge-of-stick"
profile = "power-law"
count = 2
u = ["1/6", "5/6"]
[family.parameters]
m = ["0"]
C = ["1/7"]
a = ["3/2"]
Es = ["7/3"]
friction = ["3/5"]
Q = ["friction*Es*C*a/3"]
[[family]]
name = "wedge"
profile = "power-law"
count = 4
u = ["1e-30", "1/20", "1/3", "4/5"]
[family.parameters]
m = ["0"]
C = ["1/7", "1e-6"]
a = ["3/2", "0.02"]
Es = ["7/3"]
friction = ["3/5"]
Q = ["friction*Es*C*a/3", "-friction*Es*C*a/5"]
[[family]]
name = "tilted-wedge"
profile = "tilted-wedge"
count = 4
u = ["1e-30", "1/20", "1/3", "4/5"]
[family.parameters]
phi = ["pi/16", "1/50"]
alpha = ["phi/3"]
a = ["3/2"]
Es = ["7/3"]
friction = ["3/5"]
Q = ["1/100", "-1/90"]
[[family]]
name = "curved"
profile = "power-law"
count = 2
u = ["1/3", "2/5"]
[family.parameters]
m = ["2", "3/2"]
C = ["1/7"]
a = ["3/2"]
Es = ["7/3"]
friction = ["3/5"]
Q = ["1/50", "-1/40"]
[[family]]
name = "flat-and-rounded"
profile = "flat-and-rounded"
count = 4
u = ["1e-3", "2/5", "1/2", "13/20"]
[family.parameters]
a = ["3/2", "1/50"]
t = ["a/3", "a/2"]
R = ["3"]
Es = ["7/3"]
friction = ["3/5"]
z = ["a*4/5", "a*9/10"]
Q = ["friction*Es/(4*R)*(a^2*(pi - 2*asin(t/a) - sin(2*asin(t/a))) - z^2*(pi - 2*asin(t/z) - sin(2*asin(t/z))))"]
)toml";

Ledger slip_ledger(const std::string& claim) {
    return small_ledger::ledger_of("kind = \"value\"\n" + claim, slip_head);
}

Outcome slip_outcome(const std::string& over, const std::string& of, const std::string& says,
                     const std::string& more = "") {
    const Ledger ledger = slip_ledger("over = \"" + over + "\"\nof = \"" + of + "\"\nsays = \"" +
                                      says + "\"\n" + more);
    return small_ledger::audit_of(ledger, 30).claims[0].outcome;
}

void stands(const std::string& over, const std::string& of, const std::string& says,
            const std::string& more = "") {
    CAPTURE(over);
    CAPTURE(says);
    const Outcome right = slip_outcome(over, of, says, more);
    CHECK(holds(right.verdict));
    for (const char* factor : {"2*", "-1*", "1.0001*"}) {
        CAPTURE(factor);
        const Outcome wrong =
            slip_outcome(over, of, factor + ("(" + says + ")"), more + "decimals = \"exact\"\n");
        CHECK(wrong.verdict == Verdict::refuted);
    }
}

} // namespace

TEST_CASE("partial slip of Hertz: traction, stick zone, sizes") {
    stands("hertz", "q(x)", "k(a^2 - x^2) - k(c^2 - x^2)");
    stands("hertz", "stick_a", "c");
    stands("hertz", "stick_b", "c");
    stands("hertz", "right.d", "a - c");
    stands("hertz", "left.d", "a*tau/(1 + sqrt(1 - tau))");
}

TEST_CASE("partial slip of Hertz under a bulk tension") {
    stands("hertz-in-tension", "q(x)", "k(a^2 - x^2) - k(c^2 - (x + shift)^2)");
    stands("hertz-in-tension", "right.d", "a - c + shift");
    stands("hertz-in-tension", "left.d", "a - c - shift");
    stands("hertz-in-tension", "stick_a", "c - shift");
    // The tension must have an effect.
    CHECK(slip_outcome("hertz-in-tension", "q(x)", "k(a^2 - x^2) - k(c^2 - x^2)").verdict ==
          Verdict::refuted);
}

TEST_CASE("partial slip of wedges: the stick zone is the contact, 1 - tau times as large") {
    const std::string p = "sgn(Q)*friction*Es*C/Pi*";
    stands("wedge", "q(x)", p + "(acosh(a/abs(x)) - acosh(max(a*(1 - tau)/abs(x), 1)))");
    stands("wedge", "left.d", "a*tau");
    stands("tilted-wedge", "right.d", "a*tau");
    stands("tilted-wedge", "left.d", "b*tau");
    stands("tilted-wedge", "q(x)", "sgn(Q)*friction*p(x)", "where = \"x > stick_a\"\n");
    stands("tilted-wedge", "q(x)", "sgn(Q)*friction*(p(x) - p(x/(1 - tau)))",
           "where = \"x < stick_a and x > -stick_b\"\n");
}

TEST_CASE("partial slip of curved slopes and of a punch, by increments of the pressure") {
    const std::string inside = "where = \"abs(x) < stick_a\"\n";
    stands("curved", "stick_a", "a*(1 - tau)^(1/(m + 1))");
    stands("curved", "q(x)", "sgn(Q)*friction/Pi*integral(P1of(s)/sqrt(s^2 - x^2), s, stick_a, a)",
           inside);
    stands("flat-and-rounded", "stick_b", "z");
    stands("flat-and-rounded", "right.d", "a - z");
    stands("flat-and-rounded", "q(x)",
           "friction*Es/(Pi*R)*integral(s*acos(t/s)/sqrt(s^2 - x^2), s, z, a)", inside);
    stands("flat-and-rounded", "q(x)", "sgn(Q)*friction*p(x)", "where = \"x > stick_a\"\n");
}

// x = c for u = (a - c)/(2 a): p* vanishes there, and a printed formula takes the root, or the
// inverse hyperbolic cosine, of a ball that contains the end of its domain.
TEST_CASE("a place exactly on an edge of the stick zone has an enclosure") {
    const std::pair<const char*, const char*> cases[] = {
        {"on-the-edge-of-stick", "k(a^2 - x^2) - k(c^2 - x^2)"},
        {"wedge-on-the-edge-of-stick",
         "friction*Es*C/Pi*(acosh(a/abs(x)) - acosh(max(a*(1 - tau)/abs(x), 1)))"}};
    for (const auto& [name, says] : cases) {
        const char* family = name; // clang 14: lambdas capture no structured bindings
        CAPTURE(family);
        const Ledger ledger = slip_ledger("over = \"" + std::string(family) +
                                          "\"\nof = \"q(x)\"\nsays = \"" + says + '"');
        const Claim& claim = ledger.claims[0];
        const AuditContext context(ledger, 30);
        for (const Sample& sample : context.samples(claim)) {
            const Enclosed q = enclosed(claim.formula("of"), sample, 30);
            const Enclosed printed = enclosed(claim.formula("says"), sample, 30);
            const Enclosed limit =
                enclosed(parse_formula("friction*p(x)", claim.vocabulary), sample, 30);
            REQUIRE(q.ball);
            REQUIRE(printed.ball);
            CHECK(q.ball->relative_accuracy_bits() >= 100);
            CHECK(printed.ball->relative_accuracy_bits() >= 100);
            CHECK(overlaps(*q.ball, *printed.ball));
            CHECK(overlaps(*q.ball, *limit.ball));
        }
    }
}

// P = pi/4 for a = 1, so that the contact slides for Q = 4/10: no scene of the family has both
// values, but the sweep does.
TEST_CASE("a load without partial slip along a sweep is refused at the line of the claim") {
    const Ledger ledger = parse_ledger(R"toml([ledger]
name = "sweep"
[[family]]
name = "sweep"
profile = "power-law"
count = 1
[family.parameters]
m = ["1"]
C = ["1"]
a = ["1"]
Es = ["1"]
friction = ["1/2"]
Q = ["1/10", "1/5", "3/10", "4/10"]
[[claim]]
id = "A"
kind = "monotone"
over = "sweep"
of = "right.d"
along = "Q"
sense = "increasing"
)toml",
                                       "sweep.toml");
    std::string refusal;
    try {
        static_cast<void>(run_audit(ledger, {}));
    } catch (const InputError& error) {
        refusal = error.what();
    }
    CHECK(refusal.starts_with("sweep.toml:14: the contact slides in the scene"));
}

TEST_CASE("a union of families with friction and without: q by the scene, no names of either") {
    const std::string stick = R"toml([[family]]
name = "stick"
profile = "power-law"
count = 2
u = ["1/3", "1/50"]
[family.parameters]
m = ["1"]
C = ["3/7"]
a = ["3/2"]
Es = ["7/3"]
Q = ["1/10"]
sig0 = ["0"]
[[family]]
name = "both"
union = ["on-the-edge-of-stick", "stick"]
)toml";
    const auto both = [&](const std::string& of, const std::string& says) {
        return parse_ledger(slip_head + stick + "[[claim]]\nid = \"A\"\nkind = \"value\"\nover = " +
                                "\"both\"\nof = \"" + of + "\"\nsays = \"" + says + "\"\n",
                            "both.toml");
    };
    AuditOptions options;
    options.digits = 30;
    // The full-stick traction is right in only one of the two families.
    CHECK(run_audit(both("q(x)", "Q/(Pi*sqrt(a^2 - x^2))"), options).claims[0].outcome.verdict ==
          Verdict::refuted);
    CHECK_THROWS_AS(both("right.d", "a"), InputError);
    CHECK_THROWS_AS(both("right.s0", "a"), InputError);
}
