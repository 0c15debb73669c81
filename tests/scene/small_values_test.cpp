// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/scene/scene_text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace edgeproof::scenes;

namespace {

/// Returns rel_1, rel_2, rel_3 at one point.
std::vector<std::string> errors_at(const std::string& profile, const std::string& u,
                                   bool of_shear) {
    const Scene scene =
        parsed("[profile]\n" + profile + "\n[load]\na = \"1\"\ncontact_modulus = \"1\"\n" +
               (of_shear ? "[shear]\nQ = \"0.1\"\nbulk_tension = \"0.2\"\n" : "") +
               "[ask]\nterms = [1, 2, 3]\nu = [\"" + u + "\"]\nquantities = [\"" +
               (of_shear ? "shear" : "pressure") + "\"]\n");
    std::vector<std::string> texts;
    const SceneResult result = run_scene(scene);
    for (const std::size_t n : {1U, 2U, 3U}) {
        const BoundedValue error =
            result.points()[0].at(of_shear ? Quantity::q_rel : Quantity::rel, n);
        CHECK(error.proved);
        texts.push_back(printed(error, {20}).text);
    }
    return texts;
}

/// Returns the digits and the exponent of a text such as 3.125e-802.
std::pair<std::string, long> parts(const std::string& text) {
    const std::size_t e = text.find('e');
    return {text.substr(0, e), e == std::string::npos ? 0 : std::stol(text.substr(e + 1))};
}

} // namespace

TEST_CASE("relative errors far below binary64 are no zeros: Hertz by hand") {
    // p = c_0 sqrt(u) sqrt(1 - u/2), a = 1: the relative remainder of n terms is u/4, u^2/32,
    // u^3/128, ...
    for (const long k : {400L, 1000L, 90000L}) {
        CAPTURE(k);
        const auto texts =
            errors_at("kind = \"hertz\"\nR = \"1\"", "1e-" + std::to_string(k), false);
        CHECK(texts ==
              std::vector<std::string>{"2.5000000000000000000e-" + std::to_string(k + 1),
                                       "3.1250000000000000000e-" + std::to_string(2 * k + 2),
                                       "7.8125000000000000000e-" + std::to_string(3 * k + 3)});
    }
}

TEST_CASE("the omitted terms give the digits that the difference gives at a larger distance") {
    // rel_n = K u^n (1 + O(u)): at 1e-30 from the difference of p and its terms, at 1e-700 from the
    // omitted terms.
    for (const char* const profile : {"kind = \"flat-and-rounded\"\nt = \"1/2\"\nR = \"1\"",
                                      "kind = \"tilted-wedge\"\nphi = \"0.1\"\nalpha = \"0.04\"",
                                      "kind = \"power-law\"\nm = \"5/2\"\nC = \"1\"",
                                      "kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/2\"]\n"
                                      "slopes = [\"x/10\", \"x/10 + (x - 1/2)^3\"]"}) {
        for (const bool of_shear : {false, true}) {
            CAPTURE(std::string(profile));
            CAPTURE(of_shear);
            const auto near = errors_at(profile, "1e-30", of_shear);
            const auto nearer = errors_at(profile, "1e-700", of_shear);
            for (std::size_t n = 0; n < 3; ++n) {
                CHECK(parts(near[n]).first == parts(nearer[n]).first);
                CHECK(parts(near[n]).second - parts(nearer[n]).second ==
                      670 * static_cast<long>(n + 1));
            }
        }
    }
}

TEST_CASE("slip loads of 1e-300 and 1e-1000: d, and what n terms leave out") {
    // d = a (1 - sqrt(1 - tau)), tau = Q/(f P): a (tau/2 + tau^2/8 + tau^3/16 + 5 tau^4/128 + ...).
    // Here tau = 2 Q, and rel_n = tau/4, tau^2/8, 5 tau^3/64.
    for (const long k : {300L, 1000L}) {
        const Scene scene =
            parsed("[profile]\nkind = \"hertz\"\nR = \"1\"\n[load]\nP = \"1\"\n"
                   "contact_modulus = \"1\"\n[shear]\nQ = \"1e-" +
                   std::to_string(k) +
                   "\"\nfriction = \"1/2\"\n[ask]\nterms = [1, 2, 3]\nquantities = [\"slip\"]\n");
        const SceneResult result = run_scene(scene);
        const RowsAt slip = result.at_edges(QuantityGroup::slip).at(0);
        CHECK(printed(slip.at(Quantity::slip), {20}).text == // a = 2/sqrt(pi)
              "1.1283791670955125739e-" + std::to_string(k));
        const std::vector<std::string> expected{
            "5.0000000000000000000e-" + std::to_string(k + 1),
            "5.0000000000000000000e-" + std::to_string(2 * k + 1),
            "6.2500000000000000000e-" + std::to_string(3 * k + 1)};
        for (std::size_t n = 0; n < 3; ++n) {
            CHECK(printed(slip.at(Quantity::slip_rel, n + 1), {20}).text == expected[n]);
        }
    }
}

TEST_CASE("0 has the bound 0 only for values that are known to be 0") {
    const PrecisionScope scope(60);
    const Digits digits{20};
    CHECK(printed({Ball(0, 128), true, "r"}, digits).text == "0");
    CHECK(printed({Ball(0, 128), true, "r"}, digits).complete);
    CHECK(printed({Ball::around(Real(0), Real(1), 64), true, "r", Rational(0)}, digits).text ==
          "0");
    for (const bool proved : {false, true}) {
        const BoundedValue maybe{Ball::around(Real(0), Real("1e-400"), 64), proved, "r"};
        CHECK(printed(maybe, digits).text == "0");
        CHECK(parse_decimal(printed(maybe, digits).bound) >= parse_decimal("1e-400"));
        CHECK(printed_text(maybe, digits) == printed(maybe, digits).text);
        CHECK_FALSE(printed(maybe, digits).complete);
    }
    // c_1 for m = 5/8 vanishes (moore-hills.tex, line 182), and this is proved. c_0 does not
    // vanish, nor does c_1 for an exponent that differs by only 1e-500.
    const auto c1 = [](const std::string& m) {
        const SceneResult result =
            run_scene(parsed("[profile]\nkind = \"power-law\"\nm = \"" + m +
                             "\"\nC = \"1\"\n[load]\na = "
                             "\"pi\"\ncontact_modulus = \"1\"\n[ask]\nterms = 2\nquantities = "
                             "[\"coefficients\"]\n"));
        return result.at_edges(QuantityGroup::coefficients)[0].at(Quantity::c, 1);
    };
    REQUIRE(c1("5/8").exactly);
    CHECK(*c1("5/8").exactly == 0);
    CHECK_FALSE(c1("5/8 + 1e-500").exactly);
    CHECK(printed(c1("5/8 + 1e-500"), digits).text != "0");
}

TEST_CASE("a point is shown as it was given") {
    const Scene scene =
        parsed(hertz("2", "u = [\"a/2\", \"50%\", \"pi/4\", \"1e-3\"]\nx = [\"a/2\", \"-1/3\"]\n"));
    const SceneResult result = run_scene(scene);
    std::vector<std::string> asked;
    for (const RowsAt& point : result.points()) {
        asked.push_back(scene.ask.u[point.point()].text());
    }
    CHECK(asked == std::vector<std::string>{"a/2", "50%", "pi/4", "1e-3", "x = a/2", "x = -1/3"});
    CHECK(result.points()[1].row(Quantity::x).asked.u->text() == "2");
}
