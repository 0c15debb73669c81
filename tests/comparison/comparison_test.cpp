// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/comparison/hertz_data.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <tuple>

using namespace edgeproof::hertz_data;

TEST_CASE("exact data pass at any tolerance") {
    const FileComparison file = compared(table(mesh, p), within(1e-12));
    CHECK(file.passes());
    CHECK(file.errors.local < 1e-12);
    CHECK(file.inside == 47);
    CHECK(file.outside == 18);
    CHECK(*file.contact.a == doctest::Approx(a).epsilon(1e-9));
    CHECK(*file.contact.b == doctest::Approx(a).epsilon(1e-9));
    REQUIRE(file.fits[0]);
    CHECK(file.fits[0]->c0.value == doctest::Approx(p0 * std::sqrt(2 / a)).epsilon(1e-4));
    CHECK(std::abs(file.fits[0]->c0.value - p0 * std::sqrt(2 / a)) < 3 * file.fits[0]->c0.spread);
    CHECK(file.contact.element[0] == doctest::Approx(1.0 / 16));
    CHECK(file.distances.size() >= 4);
    for (const DistanceErrors& d : file.distances) {
        CHECK(d.errors.digits() > 12);
    }
}

TEST_CASE("an error of known size is found at its size, in each norm") {
    for (const double e : {1e-6, 1e-3, 0.1}) {
        const auto text = table(mesh, [e](double x) { return p(x) * (1 + e); });
        const FileComparison file = compared(text, within(0.99 * e));
        CHECK(file.errors.peak == doctest::Approx(e).epsilon(1e-6)); // a node is at the peak
        CHECK(file.errors.local == doctest::Approx(e).epsilon(1e-6));
        CHECK(file.errors.l2 == doctest::Approx(e).epsilon(1e-6));
        CHECK_FALSE(file.passes());
        CHECK(compared(text, within(1.01 * e)).passes());
    }
    // An error at one node near the edge: small relative to the peak, large relative to p.
    const auto one = table(mesh, [](double x) { return p(x) + (x == 1.4375 ? 0.01 * p0 : 0); });
    const FileComparison file = compared(one, within(0.02));
    CHECK(file.errors.peak == doctest::Approx(0.01).epsilon(1e-9));
    CHECK(file.errors.local == doctest::Approx(0.01 * p0 / p(1.4375)).epsilon(1e-9));
    CHECK(file.data.nodes[*file.errors.worst].x == doctest::Approx(1.4375));
    CHECK(file.passes());
    Tolerances local = within(0.02);
    local.of = Norm::local;
    CHECK_FALSE(compared(one, local).passes());
    local.zone = parse_edge_zone("2e");
    CHECK(compared(one, local).passes()); // u = 1/16, one element from the edge
    local.zone = parse_edge_zone("0.05");
    CHECK_FALSE(compared(one, local).passes());
}

TEST_CASE("pressure outside the contact is an error") {
    const auto text = table(mesh, [](double x) { return x == 1.75 ? 0.1 * p0 : p(x); });
    const FileComparison file = compared(text);
    CHECK_FALSE(file.passes());
    CHECK(file.pressing_outside == 1);
    CHECK(file.errors.peak == doctest::Approx(0.1).epsilon(1e-9));
}

TEST_CASE("the rounding of written digits explains errors of its size, and no larger ones") {
    const auto rounded = [](double value, int digits) {
        char text[40];
        std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
        return std::string(text);
    };
    std::string right = "x,p\n";
    std::string wrong = "x,p\n";
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> place(-1.6, 1.6);
    for (int i = 0; i < 60; ++i) {
        const double x = place(random);
        right += rounded(x, 6) + "," + rounded(p(x), 4) + "\n";
        wrong += rounded(x, 6) + "," + rounded(p(x) * 1.01, 4) + "\n";
    }
    const FileComparison four = compared(right, within(1e-9));
    CHECK(four.passes());
    CHECK(four.errors.peak < 1e-9);
    CHECK(four.errors.digits() > 1);
    CHECK(four.errors.digits() < 6); // at most the number of written digits
    CHECK_FALSE(compared(wrong, within(0.009)).passes());
}

TEST_CASE("the rounding of pressures in the contact does not explain pressures outside it") {
    const auto cause = [](double outside) {
        std::string text = "x,p\n";
        for (const double x : even_places(-2, 2, 96)) {
            char p_text[40];
            std::snprintf(p_text, sizeof p_text, "%.4e", std::abs(x) < a ? p(x) : outside);
            text += number(x) + "," + number(std::stod(p_text)) + "\n"; // digits after the fifth
        }
        return Diagnosed(edgeproof::hertz_data::hertz()).of(text, within(1e-9)).diagnosis;
    };
    CHECK(is_named(cause(0), "rounded-to-5"));
    REQUIRE(cause(0.8 * p0));
    CHECK(cause(0.8 * p0)->causes.empty());
    CHECK(cause(0.8 * p0)->worst == Worst::outside);
}

TEST_CASE("x from any origin, mirrored order, compression negative: the same result") {
    for (const double shift : {1.5, -1.5, 2.0, 100.0, -7.25}) {
        CAPTURE(shift);
        const auto text = table(mesh, p, [=](double x) { return x + shift; });
        const FileComparison file = compared(text, within(1e-6));
        CHECK(file.passes());
        CHECK(file.data.origin == doctest::Approx(shift).epsilon(1e-7));
        CHECK(file.data.origin_found);
        CHECK(has_finding(file, "found from the data"));
        // A given origin is exact.
        const auto given =
            compare_file(parse_result(text, "r"), exact(), within(1e-11), Rational(shift));
        CHECK(given.passes());
        CHECK_FALSE(given.data.origin_found);
    }
    auto reversed = mesh;
    std::ranges::reverse(reversed);
    const FileComparison negative =
        compared(table(reversed, [](double x) { return -p(x); }), within(1e-12));
    CHECK(negative.passes());
    CHECK(negative.data.sign == -1);
    CHECK(has_finding(negative, "compression is negative"));
    // A shift of a hundredth of the contact is an error, and is not removed.
    const FileComparison slight = compared(table(mesh, p, [](double x) { return x + 0.03; }));
    CHECK_FALSE(slight.data.origin_found);
    CHECK(slight.errors.peak > 0.03);
    // A given origin is used even if it is wrong.
    CHECK_FALSE(compare_file(parse_result(table(mesh, p), "r"), exact(), {}, Rational(1)).passes());
}

TEST_CASE("half of a symmetric contact") {
    const FileComparison right = compared(table(even_places(0, 2, 32), p), within(1e-12));
    CHECK(right.passes());
    CHECK(right.data.half == Edge::right);
    CHECK(*right.contact.force == doctest::Approx(P).epsilon(0.01));
    CHECK_FALSE(right.contact.b);
    const FileComparison left = compared(table(even_places(-2, 0, 32), p), within(1e-12));
    CHECK(left.data.half == Edge::left);
    CHECK(left.passes());
    // Data that begin beyond the middle are a part of the contact, not its half, however wide the
    // elements are.
    for (const auto& [from, to, n] :
         {std::tuple{-0.3 * a, 2.0, 32}, {-2.0, 0.3 * a, 32}, {-0.3 * a, 2.0, 6}}) {
        Tolerances part = within(1e-9);
        part.partial = true;
        const FileComparison file = compared(table(even_places(from, to, n), p), part);
        CHECK_FALSE(file.data.half);
        CHECK(file.passes());
    }
}

TEST_CASE("half of a flat pad: the pressure in its middle is a small part of the greatest") {
    for (const std::string t : {"0.3", "0.84", "0.97", "0.999"}) {
        const ExactContact pad(
            scene_of_words("kind=flat-and-rounded R=1 a=1 contact_modulus=1 t=" + t));
        // The nodes end at the edge, within an element of it, or outside; the last are a part only.
        for (const auto& [from, to, half] : {std::tuple{0.0, 1.0, true},
                                             {0.0, 0.9999, true},
                                             {0.0, 1.3, true},
                                             {0.3, 1.3, false},
                                             {-0.3, 1.3, false}}) {
            for (const double side : {1.0, -1.0}) {
                const auto file =
                    compare_file(parse_result(table(
                                                  even_places(from, to, 2000),
                                                  [&](double x) { return pad.pressure(x); },
                                                  [&](double x) { return side * x; }),
                                              "r"),
                                 pad, within(1e-6), Rational(0));
                CAPTURE(t);
                CHECK(file.passes() == half);
            }
        }
    }
}

TEST_CASE("tolerances of a, P and c_0: a contact of another size fails in each") {
    Tolerances each = within(1);
    each.edges = 0.01;
    each.force = 0.01;
    each.c0 = 0.02;
    CHECK(compared(table(mesh, p), each).passes());
    const double s = 1.05; // the contact under a load that is s^2 times as large
    const FileComparison larger =
        compared(table(mesh, [s](double x) { return s * p(x / s); }), each);
    CHECK(larger.failures.size() == 5); // a, b, P and two c_0
    CHECK(*larger.contact.a == doctest::Approx(s * a).epsilon(1e-4));
    REQUIRE(larger.fits[0]); // half an element farther: still measured from the exact edge
    CHECK_FALSE(larger.fits[0]->own_edge);
    const double twice = 2; // twice as large: c_0 is measured from its own edge
    const FileComparison other =
        compared(table(even_places(-4, 4, 128), [=](double x) { return twice * p(x / twice); }));
    REQUIRE(other.fits[0]);
    CHECK(other.fits[0]->own_edge);
    CHECK(other.fits[0]->c0.value ==
          doctest::Approx(twice * p0 * std::sqrt(2 / (twice * a))).epsilon(1e-3));
    CHECK(*larger.contact.force == doctest::Approx(s * s * P).epsilon(0.005));
}

TEST_CASE("noise: c_0 within its spread, a and b within an element") {
    std::mt19937_64 random(20);
    std::normal_distribution<double> noise(0, 0.01);
    std::size_t near = 0;
    for (int run = 0; run < 20; ++run) {
        const FileComparison file = compared(
            table(even_places(-2, 2, 200), [&](double x) { return p(x) * (1 + noise(random)); }));
        CHECK(std::abs(*file.contact.a - a) < file.contact.element[0]);
        REQUIRE(file.fits[0]);
        const double off = std::abs(file.fits[0]->c0.value - p0 * std::sqrt(2 / a));
        near += off < 3 * file.fits[0]->c0.spread ? 1 : 0;
        CHECK(off < 0.05 * p0);
    }
    CHECK(near >= 16);
}

TEST_CASE("data without a usable pressure: failures, not crashes") {
    CHECK_FALSE(compared(table(mesh, [](double) { return 0.0; })).passes());
    CHECK(has_finding(compared(table(mesh, [](double) { return 0.0; })),
                      "every pressure of the data is zero"));
    CHECK_FALSE(compared("x,p\n0,1\n1,1\n").passes());
    CHECK_FALSE(compared("x,p\n-1e300,1\n1e300,1e300\n").passes());
    CHECK_THROWS_AS((void)compared("x,p\n5,1\n5,2\n5,3\n"), InputError);
    // Two contacts next to each other.
    const auto two =
        table(even_places(-4, 4, 128), [](double x) { return p(2 * (std::abs(x) - 2)); });
    const FileComparison file = compared(two);
    CHECK_FALSE(file.passes());
    CHECK(has_finding(file, "falls to zero at 1 place inside"));
    // The data are in other units, which are not stated.
    CHECK_FALSE(compared(table(mesh, p, [](double x) { return x / 1000; })).passes());
    CHECK_FALSE(compared(table(mesh, p, [](double x) { return x * 1000; })).passes());
}

TEST_CASE("a wedge: infinite at its apex, the mean pressure is the scale") {
    // For g' = phi sgn(x), half-width 1, E* = 1: p = (phi/pi) arcosh(a/|x|) (Johnson, eq. 5.7 with
    // cot alpha = phi) and P = phi a E*, so that the mean is phi/2.
    const ExactContact wedge(scene_of_words("kind=power-law m=0 C=0.1 a=1 contact_modulus=1"));
    CHECK(wedge.scale().mean);
    CHECK(wedge.scale().value == doctest::Approx(0.05).epsilon(1e-12));
    const auto pressure = [](double x) {
        return x == 0            ? 9.0
               : std::abs(x) < 1 ? 0.1 / std::numbers::pi * std::acosh(1 / std::abs(x))
                                 : 0;
    };
    const FileComparison file = compare_file(
        parse_result(table(even_places(-1.25, 1.25, 50), pressure), "w"), wedge, within(1e-10), {});
    CHECK(file.passes());
    CHECK(has_finding(file, "infinite at a corner"));
    CHECK(file.errors.nodes == 50); // all but the one at the apex
}

namespace {

FileComparison judged(const std::string& text, const ExactContact& contact,
                      const Tolerances& tolerances = {}) {
    return compare_file(parse_result(text, "drawn.csv"), contact, tolerances, Rational(0));
}

} // namespace

// tests/false-passes/run draws right and wrong meshes.
TEST_CASE("means over elements pass, without two elements at each edge") {
    Tolerances zone;
    zone.zone = parse_edge_zone("2e");
    for (const int n : {16, 20, 25, 32, 47, 64, 101, 200}) {
        CAPTURE(n);
        const double h = 4.0 / n;
        std::vector<double> middles;
        for (int i = 0; i < n; ++i) {
            middles.push_back(-2 + (i + 0.5) * h);
        }
        CHECK(judged(table(middles, [=](double x) { return smeared(x, h); }), exact(), zone)
                  .passes());
    }
}

TEST_CASE("pressures outside count relative to the peak, rows of one x with equal weights") {
    const std::vector<double> places = even_places(-2, 2, 64);
    const auto outside = table(places, [](double x) { return std::abs(x) < a ? p(x) : 0.1 * p0; });
    std::string between = "x,p\n"; // a wrong row between two right ones
    for (const double x : places) {
        for (const double value : {p(x), 2 * p(x), p(x)}) {
            between += number(x) + "," + number(value) + "\n";
        }
    }
    Tolerances t;
    t.of = Norm::local;
    const FileComparison local = judged(outside, exact(), t);
    CHECK(local.errors.local == doctest::Approx(0.1).epsilon(1e-9));
    CHECK(local.failures.front().find("10 % of the peak") != std::string::npos);
    t.of = Norm::l2;
    const FileComparison l2 = judged(between, exact(), t);
    CHECK(l2.errors.l2 == doctest::Approx(std::sqrt(1.0 / 3)).epsilon(1e-9));
    CHECK_FALSE(l2.passes());
}

TEST_CASE("a tolerance of gap, slip and sxx without data fails, with the reason") {
    // Johnson, eq. 4.43: the gap from its slope; without shear sxx = -p on the surface.
    const auto gap = [](double x) {
        const double t = std::max(1.0, std::abs(x) / a);
        return p0 * a / 3 * (t * std::sqrt(t * t - 1) - std::acosh(t));
    };
    const auto judged_with = [&](const char* name, const std::function<std::string(double)>& cell) {
        std::string text = std::string("x,") + name + ",p\n";
        for (const double x : even_places(-2, 2, 64)) {
            text += number(x) + "," + cell(x) + "," + number(p(x)) + "\n";
        }
        Tolerances t;
        t.surface = 0.03;
        t.partial = true;
        FileComparison file = judged(text, exact(), t);
        compare_surface(file, edgeproof::hertz_data::hertz(), exact(), t);
        return file.passes() ? "passes" : file.failures.front();
    };
    const auto right = [&](double x) { return number(gap(x)); };
    CHECK(judged_with("gap", right) == "passes");
    CHECK(judged_with("sxx", [](double x) { return number(-p(x)); }) == "passes");
    struct Case {
        const char* name;
        std::function<std::string(double)> cell;
        const char* reason;
    };
    const Case cases[] = {
        {"other", right, "neither gap nor slip nor sxx is compared"},
        {"gap", [](double) { return ""; }, "neither gap nor slip nor sxx is compared"},
        {"gap", [&](double x) { return x < 1.9 ? "" : right(x); }, "2 of the nodes outside"},
        {"gap", [&](double x) { return std::abs(x) < a ? right(x) : ""; }, "0 of the nodes"},
        {"gap", [&](double x) { return x < 1.9 ? right(x) : "nan"; }, "its cell in line 65"},
        {"gap", [&](double x) { return x > -2 ? right(x) : "open"; }, "its cell in line 2"},
        {"slip", right, "slip is not compared: the scene has no friction"},
        {"slip", [](double) { return "0"; }, "neither gap nor slip nor sxx is compared"},
        {"sxx", [](double x) { return x == 0 ? "-1.125" : ""; }, "1 of the nodes outside the edge"},
    };
    for (const Case& one : cases) {
        CAPTURE(std::string(one.reason));
        const std::string found = judged_with(one.name, one.cell);
        CHECK_MESSAGE(found.find(one.reason) != std::string::npos, found);
    }
}

TEST_CASE("half of a contact must begin in its middle, and --partial compares p alone") {
    const auto late = table(even_places(0.3, 2, 32), p);
    CHECK_FALSE(judged(late, exact()).passes());
    Tolerances part;
    part.partial = true;
    CHECK(judged(late, exact(), part).passes());
    part.force = 0.01; // these data do not determine the force
    CHECK_FALSE(judged(late, exact(), part).passes());
    const auto middle = table(even_places(-0.03, 0.03, 3), p); // the four nodes of a false pass
    part = {};
    const FileComparison four = judged(middle, exact(), part);
    CHECK(four.undetermined.size() == 3); // a, b and P
    part.partial = true;
    CHECK(judged(middle, exact(), part).passes());
    part.edges = 0.01;
    CHECK(judged(middle, exact(), part).failures.size() == 2);
}

TEST_CASE("a mesh that misses the peak of a sharp punch does not determine it") {
    const ExactContact sharp(
        scene_of_words("kind=flat-and-rounded t=0.99 R=1 a=1 contact_modulus=1"));
    const auto text = [&](int n) {
        return table(even_places(-1.05, 1.05, n), [&](double x) { return sharp.pressure(x); });
    };
    const FileComparison coarse = judged(text(21), sharp);
    CHECK_FALSE(coarse.passes());
    CHECK(coarse.failures.front().find("the largest p is not determined") != std::string::npos);
    CHECK(judged(text(2100), sharp).passes());
}

TEST_CASE("digits that hide more than the tolerance do not pass") {
    // The values 0 and 1 for a pressure up to 9/8: half a unit of the last digit is 44 % of the
    // peak.
    const auto whole = [](double x) { return std::round(p(x)); };
    std::string text = "x,p\n";
    for (const double x : even_places(-2, 2, 64)) {
        text += number(x) + "," + std::to_string(static_cast<int>(whole(x))) + "\n";
    }
    const FileComparison file = judged(text, exact());
    CHECK_FALSE(file.passes());
    CHECK(file.failures.front().find("too few digits") != std::string::npos);
}
