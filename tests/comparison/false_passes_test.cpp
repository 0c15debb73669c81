// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/comparison/hertz_data.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::hertz_data;

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
