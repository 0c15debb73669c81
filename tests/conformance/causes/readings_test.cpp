// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/convention.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <functional>

namespace {

constexpr double half_turn = 3.14159265358979323846;

/// Returns the conventions that are found if f(index of the contact, u) answers for `quantity` of
/// the contacts; p is at points of the right edge.
std::vector<std::string> found(const std::string& keys, const std::vector<std::string>& contacts,
                               const std::string& quantity,
                               const std::function<double(std::size_t, double)>& f,
                               const char* format = "%.17g", const std::string& name = "") {
    std::string text = "id," + keys + ",quantity,edge,u,value\n";
    const bool point = quantity == "p";
    std::size_t id = 0;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        for (const char* u : point ? std::vector<const char*>{"0.125", "0.25", "0.375"}
                                   : std::vector<const char*>{""}) {
            char value[64];
            std::snprintf(value, sizeof value, format, f(c, point ? std::atof(u) : 0));
            text += std::to_string(id++) + "," + contacts[c] + "," + quantity +
                    (point ? ",right," : ",,") + u + "," + value + "\n";
        }
    }
    const Answers answers = echoed_answers(parse_csv(text, "a.csv"));
    std::vector<std::string> said;
    for (const Convention& k : infer_conventions(answers, compare(answers, {}, {}), {})) {
        said.push_back(k.of + ": " + k.relation);
        CHECK((name.empty() || k.name == name));
    }
    return said;
}

using Said = std::vector<std::string>;

double wedge_pressure(double a, double u) { return std::acosh(a / (a - u)) / half_turn; }
double hertz_pressure(double a, double u) { return std::sqrt(u * (2 * a - u)) / 2; }

const std::vector<std::string> wedges{"power-law,0,1,1,1", "power-law,0,1,2,1"};
const std::vector<std::string> hertzes{"power-law,1,1,1,1", "power-law,1,1,2,1"};
const std::string keys = "kind,m,C,a,contact_modulus";

double a_of(std::size_t contact) { return contact == 0 ? 1 : 2; }

} // namespace

TEST_CASE("a misread question is recognised and reported") {
    CHECK(found(keys, wedges, "p", [](auto c, double u) {
              return wedge_pressure(a_of(c), u);
          }).empty());
    CHECK(found(keys, wedges, "p", [](auto c, double u) {
              return wedge_pressure(a_of(c) / 2, u);
          }) == Said{"p: ours with a quarter of the width instead of a"});
    CHECK(found(keys, wedges, "p", [](auto c, double u) {
              return wedge_pressure(2 * a_of(c), u);
          }) == Said{"p: ours with the width of the contact instead of a"});
    CHECK(found(keys, hertzes, "p", [](auto c, double u) {
              return hertz_pressure(a_of(c), a_of(c) - u);
          }) == Said{"p: ours with u taken for x"});
    CHECK(found(keys, hertzes, "p", [](auto c, double u) {
              return 2 * hertz_pressure(a_of(c), u);
          }) == Said{"p, right edge: 2 times ours"});
}

// Hertz, E* = C = 1: c_0 = sqrt(2 a)/2, c_1 = -c_0/(4 a).
TEST_CASE("terms of the expansion instead of the pressure are recognised") {
    const auto terms = [](std::size_t n) {
        return [n](auto c, double u) {
            const double c0 = std::sqrt(2 * a_of(c)) / 2;
            return c0 * std::sqrt(u) * (n == 1 ? 1 : 1 - u / (4 * a_of(c)));
        };
    };
    CHECK(found(keys, hertzes, "p", terms(1)) == Said{"p: the first term of ours at the edge"});
    CHECK(found(keys, hertzes, "p", terms(2)) ==
          Said{"p: the first two terms of ours at the edge"});
}

TEST_CASE(
    "however many rows fail, the reported cause is checked on all of them, and they are counted") {
    // p of the wedge at 70 points (60 are examined first), where a is taken for the full width;
    // four points after them follow no convention.
    std::string text = "id," + keys + ",quantity,edge,u,value\n";
    for (int i = 1; i <= 74; ++i) {
        const double u = i / 256.0;
        char row[160];
        std::snprintf(row, sizeof row, "%d,%s,p,right,%.17g,%.17g\n", i, wedges[0].c_str(), u,
                      wedge_pressure(0.5, u) * (i > 70 ? 1 + i / 7.0 : 1));
        text += row;
    }
    const Answers answers = echoed_answers(parse_csv(text, "a.csv"));
    const auto found = infer_conventions(answers, compare(answers, {}, {}), {});
    REQUIRE(found.size() == 1);
    CHECK(found[0].relation == "ours with a quarter of the width instead of a");
    CHECK(found[0].rows == 70);
    CHECK(found[0].failing == 74);
}

TEST_CASE("a mean pressure for a force, and the gap's constant for the slope's") {
    // P = E* C a for the wedge; a third contact, because one row for each of two is too few to
    // decide.
    std::vector<std::string> three = wedges;
    three.emplace_back("power-law,0,1,3,1");
    const auto a = [](std::size_t c) { return static_cast<double>(c) + 1; };
    CHECK(found(keys, three, "P", [&](auto c, double) { return a(c) / (2 * a(c)); }) ==
          Said{"P: ours over a + b"});
    // For m = 0 both constants agree; for m = 1 and 2 the ratio is 2 and 3.
    std::vector<std::string> powers{"power-law,1,1,1,1", "power-law,2,1,1,1", "power-law,1,1,2,1"};
    // P = E* C a^(m + 1) I(m) with I(m) = pi/4 and 2/3.
    const double right[] = {half_turn / 4, 2.0 / 3, half_turn};
    CHECK(found(keys, powers, "P", [&](auto c, double) { return right[c] * (c == 1 ? 3 : 2); }) ==
          Said{"P: ours with C taken for the gap's constant, g = C x^(m + 1)"});
}

TEST_CASE("angles in degrees, and the moduli of one body") {
    const std::string tilted = "kind,phi,alpha,a,contact_modulus";
    // If there is no tilt, C = phi, so that p = phi acosh(a/x)/pi. A mistake in the data is more
    // likely than the factor pi/180, which is listed as well.
    CHECK(found(tilted, {"tilted-wedge,0.2,0,1,1", "tilted-wedge,0.2,0,2,1"}, "p",
                [](auto c, double u) {
                    return 0.2 * half_turn / 180 * wedge_pressure(a_of(c), u);
                }) == Said{"p: ours with the angle converted from degrees to radians twice"});
    const std::string bodies = "kind,m,C,a,E1,nu1,E2,nu2";
    const std::vector<std::string> two{"power-law,0,1,1,2,0.25,3,0.5", "power-law,0,1,2,5,0.5,3,0"};
    const double one_body[] = {2 / (1 - 0.0625), 5 / (1 - 0.25)};
    const double no_nu[] = {6.0 / 5, 15.0 / 8};
    CHECK(found(bodies, two, "p", [&](auto c, double u) {
              return one_body[c] * wedge_pressure(a_of(c), u);
          }) == Said{"p: ours with E/(1 - nu^2) of body 1 instead of E*"});
    // A rigid body under one with nu = 0.3: E* = 1 is E/(1 - nu^2). The force is E* C a pi/2.
    CHECK(found(keys, hertzes, "p", [&](auto c, double u) {
              return 0.91 * hertz_pressure(a_of(c), u);
          }) == Said{"p: ours with plane stress, E instead of E/(1 - nu^2), if nu is 3/10"});
    // Bodies alike, R and P given: p depends on E*/R. A recipe without C has no gap's constant.
    const auto line = [](double E, double P) {
        return [=](std::size_t c, double u) {
            const double R = c == 0 ? 10 : 20;
            const double a = std::sqrt(4 * P * R / (half_turn * E));
            return E / (2 * R) * std::sqrt(u * (2 * a - u));
        };
    };
    CHECK(found("kind,R,P,E1,nu1,E2,nu2",
                {"cylinder-on-flat,10,100,182,0.3,182,0.3",
                 "cylinder-on-flat,20,100,182,0.3,182,0.3"},
                "p", line(200, 100)) == Said{"p: ours with E/(1 - nu^2) of body 1 instead of E*"});
    CHECK(found("kind,R,P,E1,nu1,E2,nu2",
                {"cylinder-on-flat,10,100,182,0.3,182,0.3",
                 "cylinder-on-flat,20,100,182,0.3,182,0.3"},
                "p", [&](auto c, double u) { return half_turn / 4 * line(100, 100)(c, u); }) ==
          Said{"p, right edge: pi/4 times ours"});
    // The width of the contact, where nothing else is wrong.
    CHECK(found(
              "kind,R,P,contact_modulus",
              {"cylinder-on-flat,10,100,100", "cylinder-on-flat,20,100,100",
               "cylinder-on-flat,40,100,100"},
              "a",
              [](auto c, double) {
                  return 2 * std::sqrt(4 * 100 * 10 * std::pow(2.0, c) / (half_turn * 100));
              },
              "%.17g", "full-width-for-half") == Said{"a: 2 times ours"});
    CHECK(found(bodies, two, "p", [&](auto c, double u) {
              return no_nu[c] * wedge_pressure(a_of(c), u);
          }) == Said{"p: ours with plane stress, 1/E* = 1/E1 + 1/E2"});
}

TEST_CASE("single precision is named as such, and so are answers cut when written") {
    const auto single = [](auto c, double u) {
        return static_cast<double>(static_cast<float>(wedge_pressure(a_of(c), u)));
    };
    CHECK(found(keys, wedges, "p", single) == Said{"p: in single precision (binary32)"});
    CHECK(found(keys, wedges, "p", single, "%.9g") == Said{"p: in single precision (binary32)"});
    CHECK(found(
              keys, wedges, "p", [](auto c, double u) { return wedge_pressure(a_of(c), u); },
              "%.8g") == Said{"p: right, and cut to 8 digits when written"});
    CHECK(found(keys, wedges, "p", [](auto c, double u) {
              return wedge_pressure(a_of(c), u) * (1 + 1e-7);
          }).empty());
    // Five decimals of values from 0.0003 to 8000.
    const std::vector<std::string> stiff{"power-law,0,1,1,1e4", "power-law,0,1,2,1e-2",
                                         "power-law,0,1,1,1e-3", "power-law,0,1,2,30"};
    CHECK(found(
              keys, stiff, "p",
              [](auto c, double u) {
                  const double modulus[] = {1e4, 1e-2, 1e-3, 30};
                  return modulus[c] * wedge_pressure(c % 2 == 0 ? 1 : 2, u);
              },
              "%.5f") == Said{"p: right, and cut to 5 decimals when written"});
    // Three digits of large values are whole numbers.
    const std::vector<std::string> large{"power-law,0,1,1,1e6", "power-law,0,1,2,1e8"};
    CHECK(found(
              keys, large, "p",
              [](auto c, double u) { return (c == 0 ? 1e6 : 1e8) * wedge_pressure(a_of(c), u); },
              "%.3g") == Said{"p: right, and cut to 3 digits when written"});
}

namespace {

/// The causes found for p = f(u) p of Hertz at 12 distances, E* = C = 1, a = 1 and 2.
std::vector<Convention> causes_of_factor(const std::function<double(double)>& f) {
    std::string text = "id," + keys + ",quantity,edge,u,value\n";
    std::size_t id = 0;
    for (std::size_t c = 0; c < hertzes.size(); ++c) {
        for (int k = 1; k <= 12; ++k) {
            const double u = k / 16.0;
            char row[160];
            std::snprintf(row, sizeof row, "%zu,%s,p,right,%.17g,%.17g\n", ++id, hertzes[c].c_str(),
                          u, f(u) * hertz_pressure(a_of(c), u));
            text += row;
        }
    }
    const Answers answers = echoed_answers(parse_csv(text, "a.csv"));
    return infer_conventions(answers, compare(answers, {}, {}), {});
}

} // namespace

TEST_CASE("a dominant cause is named with what remains; what varies is not called a constant") {
    // A factor 1000, and an error that grows to 4 % at u = 3/4.
    const auto thousand = causes_of_factor([](double u) { return 1000 * (1 + 0.04 * u / 0.75); });
    REQUIRE(thousand.size() == 1);
    CHECK(thousand[0].name == "power-of-ten");
    CHECK(thousand[0].factor == 1000);
    CHECK(thousand[0].remains > 0.03);
    CHECK(thousand[0].remains <= 0.04);
    // Two mistakes have a factor near 1/sqrt(2 pi) = 0.3989 by chance.
    const auto chance =
        causes_of_factor([](double u) { return 0.395 + 0.02 * std::max(0.0, u - 0.5); });
    REQUIRE(chance.size() == 1);
    CHECK(chance[0].equally_likely == std::vector<std::string>{"factor"});
    // The same without the factor, and a factor that varies between 1.26 and 1.3.
    CHECK(causes_of_factor([](double u) { return 1 + 0.04 * u / 0.75; }).empty());
    CHECK(causes_of_factor([](double u) { return 1.26 + 0.04 * u / 0.75; }).empty());
    const auto constant = causes_of_factor([](double) { return 1.28; });
    REQUIRE(constant.size() == 1);
    CHECK(constant[0].name == "factor");
    CHECK(constant[0].remains == 0);
    // A constant near 1/sqrt(2 pi) = 0.3989, of few rows.
    CHECK(found(keys, hertzes, "p", [](auto c, double u) {
              return 0.4054 * hertz_pressure(a_of(c), u);
          }) == Said{"p, right edge: 0.4054 times ours"});
    CHECK(causes_of_factor([](double) { return 1.0; }).empty());
    // A pressure such as that of a wedge, with log10 in place of the natural logarithm.
    const auto decimal = causes_of_factor([](double) { return 1 / std::log(10.0); });
    REQUIRE(decimal.size() == 1);
    CHECK(decimal[0].name == "log10");
}

TEST_CASE(
    "a factor with a name is given with what it leaves, up to a tenth, without being a constant") {
    const auto names = [](const Convention& c) {
        std::vector<std::string> all = c.equally_likely;
        all.push_back(c.name);
        return all;
    };
    const auto has = [](const std::vector<std::string>& list, const std::string& name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    for (const auto& [name, factor] :
         {std::pair{"factor-2", 2.0}, std::pair{"factor-2", 0.5},
          std::pair{"factor-sqrt-2", std::sqrt(2.0)}, std::pair{"factor-pi", half_turn},
          std::pair{"factor-pi", 1 / half_turn}, std::pair{"power-of-ten", 0.1}}) {
        CAPTURE(name);
        CAPTURE(factor);
        for (const double rest : {0.005, 0.02, 0.1, -0.1}) {
            CAPTURE(rest);
            const auto varying =
                causes_of_factor([&, f = factor](double u) { return f * (1 + rest * u / 0.75); });
            REQUIRE(varying.size() == 1);
            CHECK(has(names(varying[0]), name));
            CHECK_FALSE(varying[0].name == "factor");
            const auto constant =
                causes_of_factor([&, f = factor](double) { return f * (1 + rest); });
            REQUIRE(constant.size() == 1);
            CHECK(constant[0].name == "factor");
            CHECK(has(constant[0].equally_likely, name));
        }
    }
    const auto near_two = causes_of_factor([](double u) { return 2 * (1 + 0.1 * u / 0.75); });
    CHECK(near_two[0].name == "varying-factor");
    CHECK(near_two[0].relation == "2.02 to 2.2 times ours");
    CHECK(near_two[0].also.front() == "2 times ours, and up to 10 % that have another cause");
    // Factors that do not contain one with a name, and one that is 15 % off sqrt(2).
    CHECK(causes_of_factor([](double u) { return 1.29 + 0.03 * u / 0.75; }).empty());
    const auto far = causes_of_factor([](double) { return 1.2; });
    REQUIRE(far.size() == 1);
    CHECK(far[0].equally_likely.empty());
}

TEST_CASE("a function of the value is recognised, and x for u where P is given") {
    std::string text = "id,kind,m,C,P,contact_modulus,quantity,edge,u,value\n";
    // P = pi/4 E* C a^2 with a = 1 and 2.
    for (const auto& [a, force] : {std::pair{1, "pi/4"}, std::pair{2, "pi"}}) {
        for (int k = 1; k <= 5; ++k) {
            const double u = k / 8.0;
            char row[160];
            std::snprintf(row, sizeof row, "%d-%d,power-law,1,1,%s,1,p,right,%.17g,%.17g\n", a, k,
                          force, u, hertz_pressure(a, a - u));
            text += row;
        }
    }
    const Answers answers = echoed_answers(parse_csv(text, "a.csv"));
    const auto by_x = infer_conventions(answers, compare(answers, {}, {}), {});
    REQUIRE(by_x.size() == 1);
    CHECK(by_x[0].name == "x-for-u");
    CHECK(found(keys, hertzes, "p", [](auto c, double u) {
              return std::log10(hertz_pressure(a_of(c), u));
          }) == Said{"p: the decimal logarithm of ours"});
}
