// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "tests/audit/small_ledger.hpp"

#include <doctest/doctest.h>

namespace {

using namespace small_ledger;

/// A sphere, R = 1/C; a cone; and a plane contact.
const std::string bodies = R"(
[ledger]
name = "bodies"
[[family]]
name = "sphere"
profile = "power-law"
geometry = "axisymmetric"
count = 2
u = ["1/200", "2/5"]
[family.parameters]
m = ["1"]
C = ["1/R"]
R = ["3", "1/50"]
a = ["R/9"]
Es = ["7/3", "2.1e11"]
[[family]]
name = "cone"
profile = "power-law"
geometry = "axisymmetric"
count = 2
u = ["1/200", "2/5"]
[family.parameters]
m = ["0"]
C = ["3/7", "1/50"]
a = ["3/2", "7e5"]
Es = ["7/3"]
[[family]]
name = "line"
profile = "power-law"
count = 2
[family.parameters]
m = ["1"]
C = ["3/7"]
a = ["3/2"]
Es = ["7/3"]
)";

std::string verdict_over(const std::string& family, const std::string& says,
                         const std::string& of) {
    const AuditResult result = audit_of(ledger_of(
        "kind = \"value\"\nover = \"" + family + "\"\nof = \"" + of + "\"\nsays = \"" + says + "\"",
        bodies));
    return std::string(name_of(result.claims.front().outcome.verdict));
}

std::string refusal_over(const std::string& claim, const std::string& families = bodies) {
    try {
        static_cast<void>(audit_of(ledger_of(claim, families)));
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

} // namespace

// Hertz: johnson1985, eq. 3.39, 4.22 to 4.24; the cone: sneddon1965, eq. 6.4.
TEST_CASE("a sphere and a cone as families of a ledger") {
    CHECK(verdict_over("sphere", "4*Es*a^3/(3*R)", "P") == "confirmed");
    CHECK(verdict_over("sphere", "a^2/R", "delta") == "confirmed");
    CHECK(verdict_over("sphere", "3*P/(2*Pi*a^2)*sqrt(1-x^2/a^2)", "p(x)") == "confirmed");
    CHECK(verdict_over("sphere", "P", "2*Pi*integral(p(t)*t, t, 0, a)") == "confirmed");
    CHECK(verdict_over("cone", "2/Pi/C*Es*delta^2", "P") == "confirmed");
    CHECK(verdict_over("cone", "Es*C/2*acosh(a/x)", "p(x)") == "confirmed");
    SUBCASE("those of the plane contact with the same pressure are refuted") {
        CHECK(verdict_over("sphere", "Pi*Es*a^2/(4*R)", "P") == "refuted");
        CHECK(verdict_over("sphere", "Es/(2*R)*sqrt(a^2-x^2)", "p(x)") == "refuted");
    }
}

// The surface outside a sphere: johnson1985, eq. 3.42a; outside a line contact the slope of the gap
// is sqrt(x^2 - a^2) C (johnson1985, section 4.2), integrated from a.
TEST_CASE("the gap in formulas") {
    CHECK(verdict_over("sphere",
                       "(4*a^2/(2*R)-delta)+((2*a^2-4*a^2)*asin(1/2)+2*a^2*sqrt(3/4))/(Pi*R)",
                       "gap(2*a)") == "confirmed");
    CHECK(verdict_over("line", "C/2*(2*a*sqrt(3)*a-a^2*acosh(2))", "gap(2*a)") == "confirmed");
}

// Cattaneo and Mindlin: johnson1985, section 7.2; of a cone P is proportional to a^2.
TEST_CASE("partial slip of a sphere and a cone as families of a ledger") {
    std::string slipping = bodies;
    const auto push = [&](const std::string& before, const std::string& Q) {
        slipping.insert(slipping.find(before),
                        "friction = [\"1/2\", \"1/7\"]\nQ = [\"" + Q + "\"]\n");
    };
    push("Es = [\"7/3\", \"2.1e11\"]", "Es*a^3/(9*R)");
    push("Es = [\"7/3\"]\n[[family]]\nname = \"line\"", "Es*C*a^2/9");
    const auto verdict = [&](const std::string& family, const std::string& says,
                             const std::string& of, const std::string& where = "") {
        const AuditResult result =
            audit_of(ledger_of("kind = \"value\"\nover = \"" + family + "\"\nof = \"" + of +
                                   "\"\nsays = \"" + says + "\"" + where,
                               slipping));
        return std::string(name_of(result.claims.front().outcome.verdict));
    };
    CHECK(verdict("sphere", "a*(1-Q/(friction*P))^(1/3)", "stick_a") == "confirmed");
    CHECK(verdict("cone", "a-a*(1-Q/(friction*P))^(1/2)", "right.d") == "confirmed");
    CHECK(verdict("sphere", "3*friction*P/(2*Pi*a^3)*(sqrt(a^2-x^2)-sqrt(stick_a^2-x^2))", "q(x)",
                  "\nwhere = \"x < stick_a\"") == "confirmed");
    CHECK(verdict("sphere", "a*(1-Q/(friction*P))^(1/2)", "stick_a") == "refuted"); // a cylinder
    CHECK(refusal_over("kind = \"value\"\nover = \"sphere\"\nof = \"slip(x)\"\nsays = \"x\"",
                       slipping)
              .find("'slip' is not available") != std::string::npos);
}

TEST_CASE("what axisymmetric families do not have is refused") {
    CHECK(refusal_over("kind = \"value\"\nover = \"sphere\"\nof = \"P1\"\nsays = \"P\"")
              .find("'P1' is not available in the axisymmetric family sphere") !=
          std::string::npos);
    CHECK(refusal_over("kind = \"value\"\nover = \"sphere\"\nof = \"g1(x)\"\nsays = \"x/R\"")
              .find("'g1' is not available") != std::string::npos);
    CHECK(refusal_over("kind = \"identity\"\nover = \"sphere\"\nof = \"P\"\nsays = \"P\"")
              .find("is of kind identity") != std::string::npos);
    std::string punch = bodies;
    punch.replace(punch.find("profile = \"power-law\""), 21, "profile = \"tilted-wedge\"");
    CHECK(refusal_over("kind = \"value\"\nover = \"cone\"\nof = \"P\"\nsays = \"P\"", punch)
              .find("power laws only") != std::string::npos);
    std::string sheared = bodies;
    sheared.insert(sheared.find("Es = "), "sig0 = [\"1/2\"]\n");
    CHECK(refusal_over("kind = \"value\"\nover = \"cone\"\nof = \"P\"\nsays = \"P\"", sheared)
              .find("sig0 has no effect on it") != std::string::npos);
    // delta is a name of axisymmetric families only.
    CHECK(refusal_over("kind = \"value\"\nover = \"line\"\nof = \"P\"\nsays = \"delta\"")
              .find("unknown name 'delta'") != std::string::npos);
}
