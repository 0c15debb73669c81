// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/lab/validation/read_file.hpp"

#include "edgeproof/precision/error.hpp"
#include "lab/validation/hard_cases.hpp"
#include "lab/validation/value_routes.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <map>

namespace {

std::vector<HardCase> all_cases() {
    const auto file = test::source_dir() / "reference" / "hard-cases.toml";
    return parse_hard_cases(test::read_file(file), "hard-cases.toml");
}

HardCase hertz(const std::string& u) {
    return parse_hard_cases("[cases.one]\nclass = \"c\"\nreason = \"r\"\nquantity = \"pressure\"\n"
                            "edge = \"right\"\nu = \"" +
                                u +
                                "\"\nprofile = { kind = \"power-law\", m = \"1\", C = \"1\" }\n"
                                "load = { a = \"1\", contact_modulus = \"1\" }\n",
                            "test")
        .front();
}

std::string message_of(const std::string& text) {
    try {
        (void)parse_hard_cases(text, "cases.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("hard-cases.toml: at least 200 cases, at least 10 in each class of the list") {
    std::map<std::string, std::size_t> classes;
    std::size_t unreasoned = 0;
    const auto cases = all_cases();
    for (const HardCase& c : cases) {
        ++classes[c.family];
        unreasoned += c.reason.empty() ? 1 : 0;
    }
    CHECK(cases.size() >= 200);
    CHECK(unreasoned == 0);
    for (const char* name : {"u = 1e-40 a",
                             "u = 1e-300 a",
                             "within 1e-30 of a knot, nearer the edge",
                             "within 1e-30 of a knot, further in",
                             "within 1e-30 of the apex",
                             "t/a = 1 - 1e-15",
                             "t/a = 1e-15",
                             "gamma = 1e-30",
                             "1 - gamma = 1e-30",
                             "m = 1e-10",
                             "m = 5/8 +- 1e-20",
                             "m = 1e4",
                             "b on a knot",
                             "b 1e-25 from a knot",
                             "alpha = 1e-25",
                             "just past the flat",
                             "residual of 20 terms at u = 1e-10",
                             "1e-9 m with 1e12 Pa",
                             "Q and sigma_0 cancel 40 digits",
                             "the error touches the tolerance",
                             "z = 1e-30 at an edge or a knot",
                             "a point at the distance 1e30",
                             "shear: z = 1e-30 at an edge or a knot",
                             "shear: a point at the distance 1e30"}) {
        CAPTURE(name);
        CHECK(classes[name] >= 10);
    }
}

TEST_CASE("Hertz, 3-4-5: p = 3/10; and u = 1e-40, where the textbook formula has no digit") {
    const CaseOutcome easy = run_case(hertz("1/5"), 50);
    CHECK(easy.value == "0.30000000000000000000000000000000000000000000000000");
    CHECK(easy.proved);
    CHECK(easy.fault == "");
    REQUIRE(easy.second_routes.size() == 2);
    CHECK(easy.second_routes[0].route == "barber-mossakovskii");
    CHECK(easy.second_routes[1].route == "singular-integral");
    CHECK(easy.plain[0] >= 14);
    CHECK(easy.plain[3] >= 48);
    // sqrt(u (2 - u))/2 = 1e-20/sqrt(2) (1 - u/4 ...): x = 1 - u is 1 in double and __float128, and
    // keeps 10 of the 50 digits of u.
    const CaseOutcome hard = run_case(hertz("1e-40"), 50);
    CHECK(hard.fault == "");
    CHECK(hard.value.substr(0, 20) == "7.071067811865475244");
    CHECK(hard.plain[0] == 0);
    CHECK(hard.plain[2] == 0);
    CHECK(hard.plain[3] >= 8);
    CHECK(hard.plain[3] <= 13);
}

TEST_CASE("a residual and a tilt difference, which are made of other values, by hand") {
    const Scene hertz =
        parse_scene("[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n[load]\n"
                    "a = \"1\"\ncontact_modulus = \"1\"\n",
                    "hertz");
    // The ratio of one term to p is sqrt(2/(2 - u)): 10/9 at u = 19/50.
    const AskedValue residual{Quantity::residual, 1, Edge::right, Exact::parse("19/50")};
    const BoundedValue one = enclosed_value(hertz, residual, 40);
    CHECK(one.proved);
    CHECK(contains(one.value, Rational(-1, 9)));
    CHECK(one.value.radius() < Real("1e-40"));

    const Scene wedge = parse_scene("[profile]\nkind = \"tilted-wedge\"\nphi = \"1/10\"\n"
                                    "alpha = \"1/20\"\n[load]\na = \"1\"\n"
                                    "contact_modulus = \"1\"\n",
                                    "wedge");
    // The upright wedge has p = (E* phi/pi) arcosh(a/x): at x = 1/3, arcosh 3 = ln(3 + sqrt(8)).
    const AskedValue p{.quantity = Quantity::p, .u = Exact::parse("2/3")};
    AskedValue difference = p;
    difference.quantity = Quantity::tilt_difference;
    const Ball upright_p = log(3 + sqrt(Ball(8, 200))) / (10 * acos(Ball(-1, 200)));
    CHECK(overlaps(enclosed_value(upright(wedge), p, 40).value, upright_p));
    CHECK(overlaps(enclosed_value(wedge, difference, 40).value,
                   Ball(enclosed_value(wedge, p, 40).value - upright_p)));
    CHECK_THROWS_AS((void)upright(hertz), InputError);
}

TEST_CASE("hard cases: one of each class, by ball and by two routes") {
    std::map<std::string, bool> seen;
    std::vector<HardCase> sample;
    for (HardCase& c : all_cases()) {
        // Only the quick ones of the power laws and rounded punches.
        const bool quick = c.asked.quantity != Quantity::c &&
                           c.asked.quantity != Quantity::residual &&
                           c.asked.quantity != Quantity::extent &&
                           c.scene.profile->piecewise_linear() && c.scene.symmetric();
        if (quick && !seen[c.family]) {
            seen[c.family] = true;
            sample.push_back(std::move(c));
        }
    }
    CHECK(sample.size() >= 9);
    const auto outcomes = run_cases(sample, {});
    for (std::size_t i = 0; i < sample.size(); ++i) {
        CAPTURE(sample[i].name);
        CHECK(outcomes[i].fault == "");
        CHECK(outcomes[i].digits >= 50);
    }
}

TEST_CASE("hard cases: malformed input is reported with its line") {
    CHECK(message_of("[cases]\n").find("cases.toml:1: the file has no cases; add a case") == 0);
    CHECK(message_of("[cases.x]\nclass = \"c\"\n").find("cases.toml:1: there is no reason") == 0);
    CHECK(message_of("[cases.x]\nclass = \"c\"\nreason = \"r\"\nquantity = \"heat\"\n"
                     "profile = { kind = \"power-law\", m = \"1\", C = \"1\" }\n"
                     "load = { a = \"1\", contact_modulus = \"1\" }\n")
              .find("cases.toml:4: unknown quantity 'heat'") == 0);
    CHECK(message_of("[cases.x]\nclass = \"c\"\nreason = \"r\"\nquantity = \"measure\"\n"
                     "profile = { kind = \"power-law\", m = \"1\", C = \"1\" }\n"
                     "load = { a = \"1\", contact_modulus = \"1\" }\n") ==
          "cases.toml:4: unknown quantity 'measure'; write pressure, coefficient, residual, shear, "
          "shear-coefficient, load, left-edge, tilt-difference, extent, sxx, szz or sxz");
    const auto stress_case = [](const std::string& load, const std::string& shear) {
        return "[cases.x]\nclass = \"c\"\nreason = \"r\"\nquantity = \"sxx\"\nx = \"0\"\nz = "
               "\"1\"\n"
               "profile = { kind = \"power-law\", m = \"1\", C = \"1\" }\nload = { " +
               load +
               " = \"1\", contact_modulus = \"1\" }\nshear = { Q = \"1/9\", friction = \"1/2\"" +
               shear + " }\n";
    };
    CHECK(message_of(stress_case("P", "")) == "");
    CHECK(message_of(stress_case("a", "")).find("give P instead of a") != std::string::npos);
    CHECK(
        message_of(stress_case("P", ", bulk_tension = \"1/99\"")).find("leave bulk_tension out") !=
        std::string::npos);
    CHECK(message_of("[cases.x]\nclass = \"c\"\nreason = \"r\"\nquantity = \"load\"\n"
                     "profile = { kind = \"power-law\", m = \"-1\", C = \"1\" }\n"
                     "load = { a = \"1\", contact_modulus = \"1\" }\n")
              .find("cases.toml:1:") == 0);
}

TEST_SUITE("slow") {
    TEST_CASE("every hard case, by ball and by two routes") {
        const auto cases = all_cases();
        const auto outcomes = run_cases(cases, {});
        REQUIRE(outcomes.size() == cases.size());
        for (std::size_t i = 0; i < cases.size(); ++i) {
            CAPTURE(cases[i].name);
            CHECK(outcomes[i].fault == "");
        }
    }
}
