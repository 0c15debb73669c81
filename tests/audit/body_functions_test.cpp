// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses, the gap and the slip in formulas of ledgers.
#include "edgeproof/precision/error.hpp"
#include "tests/audit/small_ledger.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <string>

namespace {

using namespace small_ledger;

/// `z` is the depth.
const std::string stressed_bodies = R"(
[ledger]
name = "stressed"
[[family]]
name = "cylinder"
profile = "power-law"
count = 2
u = ["1/5", "1e-9"]
[family.parameters]
m = ["1"]
C = ["3/7", "1e-6"]
a = ["3/2", "7e5"]
Es = ["7/3", "2.1e11"]
z = ["a/3", "a*4"]
[[family]]
name = "punch"
profile = "tilted-flat-and-rounded"
count = 1
u = ["1/5"]
[family.parameters]
alpha = ["1/20"]
t = ["1/2"]
R = ["3"]
a = ["1"]
Es = ["7/3"]
z = ["1/3"]
[[family]]
name = "curved"
profile = "piecewise-symmetric"
count = 1
u = ["1/5"]
knots = []
slopes = ["x/6 + x^3/8"]
[family.parameters]
a = ["3/4"]
Es = ["7/3"]
z = ["1/3"]
[[family]]
name = "stuck"
profile = "power-law"
count = 1
u = ["1/5"]
[family.parameters]
m = ["1"]
C = ["3/7"]
a = ["3/2"]
Es = ["7/3"]
Q = ["-1/5"]
sig0 = ["1/9"]
z = ["1/3"]
[[family]]
name = "slipping"
profile = "power-law"
count = 2
u = ["1/50", "1/3"]
[family.parameters]
m = ["1"]
C = ["3/7"]
a = ["3/2"]
Es = ["7/3"]
friction = ["3/5"]
Q = ["friction*pi*Es*C*a^2/4*3/10", "-friction*pi*Es*C*a^2/4*9/10"]
sig0 = ["0"]
z = ["1/4", "3"]
)";

/// The ledger with one family; a depth that the claim does not use is left out.
std::string body_ledger(const std::string& family, bool depth) {
    const std::string all = stressed_bodies;
    const std::size_t name = all.find("name = \"" + family + "\"");
    const std::size_t begin = all.rfind("[[family]]", name);
    std::string text = all.substr(0, all.find("[[family]]")) +
                       all.substr(begin, all.find("[[family]]", name) - begin);
    if (!depth) {
        const std::size_t z = text.find("\nz = ") + 1;
        text.erase(z, text.find('\n', z) + 1 - z);
    }
    return text;
}

std::string verdict_in(const std::string& family, const std::string& of, const std::string& says) {
    const AuditResult result = audit_of(ledger_of(
        "kind = \"value\"\nover = \"" + family + "\"\nof = \"" + of + "\"\nsays = \"" + says + "\"",
        body_ledger(family, (of + says).find("z)") != std::string::npos)));
    return std::string(name_of(result.claims.front().outcome.verdict));
}

/// `johnson1985`, eq. 2.23, for the tractions n (normal) and t (tangential) over lo < s < hi; the
/// powers of z and of x - s of the normal part.
std::string stress_integral(const std::string& n, const std::string& t, int of_z, int of_d,
                            const std::string& lo, const std::string& hi) {
    const std::string d = "(x-s)^" + std::to_string(of_d);
    const std::string normal = "(" + n + ")*z^" + std::to_string(of_z) + "*" + d;
    const std::string shear = "(" + t + ")*z^" + std::to_string(of_z - 1) + "*" + d + "*(x-s)";
    return "-2/Pi*integral((" + normal + (t.empty() ? "" : "+" + shear) + ")/((x-s)^2+z^2)^2, s, " +
           lo + ", " + hi + ")";
}

struct StressKernel {
    const char* name;
    int of_z;
    int of_d;
};
constexpr StressKernel stress_kernels[] = {{"sxx", 1, 2}, {"szz", 3, 0}, {"sxz", 2, 1}};

} // namespace

TEST_CASE("stresses in formulas are integrals of the tractions") {
    for (const StressKernel& k : stress_kernels) {
        CAPTURE(k.name);
        const std::string of = std::string(k.name) + "(x, z)";
        const std::string of_p = stress_integral("p(s)", "", k.of_z, k.of_d, "-a", "a");
        CHECK(verdict_in("cylinder", of, of_p) == "confirmed");
        CHECK(verdict_in("cylinder", of, "101/100*(" + of_p + ")") == "refuted");
        // Cattaneo: q is f times the difference of the pressures over a and over stick_a.
        const std::string load = "Es*C/2*sqrt(a^2-s^2)";
        const std::string less = "sgn(Q)*friction*Es*C/2*sqrt(stick_a^2-s^2)";
        const std::string says =
            stress_integral(load, "sgn(Q)*friction*" + load, k.of_z, k.of_d, "-a", "a") + "-(" +
            stress_integral("0", less, k.of_z, k.of_d, "-stick_a", "stick_a") + ")";
        CHECK(verdict_in("slipping", of, says) == "confirmed");
    }
}

// mpmath at 25 digits: the same integrals, with p = E*/(2 pi) w(x) times the integral of
// (g'(s) - g'(x))/(s - x) over the angle of s; under full stick q = (Q/pi + sig0 x/4)/w(x) in
// addition to the pressure of Hertz.
TEST_CASE("stresses in formulas agree with a second route") {
    const struct {
        const char* family;
        std::array<const char*, 3> values; ///< sxx, szz, sxz
    } bodies[] = {
        {"punch", {"-0.162671508236441513", "-0.306525570442848292", "-0.038441227287582042"}},
        {"curved", {"-0.062550784052640043", "-0.134865688558457392", "-0.034476845739596830"}},
        {"stuck", {"-0.314197390181654992", "-0.567746394278713643", "-0.078025712828152505"}}};
    for (const auto& each : bodies) {
        const auto& family = each.family;
        const auto& values = each.values;
        for (std::size_t i = 0; i < values.size(); ++i) {
            CAPTURE(family);
            CAPTURE(i);
            const std::string of = std::string(stress_kernels[i].name) + "(x, z)";
            CHECK(verdict_in(family, of, values[i]) == "confirmed");
            CHECK(verdict_in(family, of, std::string(values[i]) + "-1/10^16") == "refuted");
        }
    }
}

// johnson1985, eq. 4.49
TEST_CASE("stresses of Hertz in formulas") {
    const std::string root = "sqrt((a^2-x^2+z^2)^2+4*x^2*z^2)";
    const std::string m = "sqrt((" + root + "+(a^2-x^2+z^2))/2)";
    const std::string n = "(sgn(x)*sqrt((" + root + "-(a^2-x^2+z^2))/2))";
    const std::string quotient = "(z^2+" + n + "^2)/(" + m + "^2+" + n + "^2)";
    CHECK(verdict_in("cylinder", "sxx(x, z)", "-p(0)/a*(" + m + "*(1+" + quotient + ")-2*z)") ==
          "confirmed");
    CHECK(verdict_in("cylinder", "szz(x, z)", "-p(0)/a*" + m + "*(1-" + quotient + ")") ==
          "confirmed");
    CHECK(verdict_in("cylinder", "szz(x, z)", "-p(0)/a*" + m + "*(1+" + quotient + ")") ==
          "refuted");
    for (const char* family : {"cylinder", "punch", "stuck", "slipping"}) {
        CAPTURE(family);
        CHECK(verdict_in(family, "szz(x, 0)", "-p(x)") == "confirmed");
    }
    for (const char* family : {"stuck", "slipping"}) {
        CAPTURE(family);
        CHECK(verdict_in(family, "sxz(x, 0)", "-q(x)") == "confirmed");
    }
}

// The slope of the gap of a cylinder outside the half-width c is C sqrt(x^2 - c^2) (johnson1985,
// section 4.2); the slip is f times the gap of the stick zone, against Q.
TEST_CASE("the slip and the gap on both sides in formulas") {
    const std::string gap = "C/2*(abs(x)*sqrt(max(x^2-stick_a^2, 0))-stick_a^2*"
                            "acosh(max(abs(x)/stick_a, 1)))";
    CHECK(verdict_in("slipping", "slip(x)", "-sgn(Q)*friction*" + gap) == "confirmed");
    CHECK(verdict_in("slipping", "slip(0)", "0") == "confirmed");
    CHECK(verdict_in("slipping", "slip(x)", "sgn(Q)*friction*" + gap) == "refuted");
    CHECK(verdict_in("slipping", "gap(-2*a)", "gap(2*a)") == "confirmed");
    CHECK(verdict_in("cylinder", "gap(-2*a)", "C/2*(2*a*sqrt(3)*a-a^2*acosh(2))") == "confirmed");
}

TEST_CASE("functions of the bodies that a family does not have are refused") {
    const auto refusal = [](const std::string& family, const std::string& of) {
        try {
            return verdict_in(family, of, "0");
        } catch (const InputError& error) {
            return std::string(error.what());
        }
    };
    CHECK(refusal("cylinder", "slip(x)").find("slip is a quantity of partial slip") !=
          std::string::npos);
    CHECK(refusal("cylinder", "tau_max").find("functions of the place and the depth") !=
          std::string::npos);
    // Nothing is decided where there is no stress.
    CHECK(refusal("cylinder", "szz(x, -z)") != "confirmed");
    CHECK(refusal("slipping", "slip(2*a)") != "confirmed");
    CHECK(refusal("cylinder", "integral(szz(s, z), s, -a, a)") == "undecided");
}
