// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "lab/counts/count.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

/// The index of a contact that takes little time, with a piecewise linear g'.
constexpr std::size_t quick_contact = 1;

using Result = CountResult<CountFinding>;

EnclosureCountOptions small(std::size_t values, unsigned digits = 20) {
    EnclosureCountOptions o;
    o.values = values;
    o.digits = digits;
    o.threads = 2;
    return o;
}

std::string cells_text(const Result& r) {
    std::string text;
    for (const auto& [cell, c] : r.cells) {
        text += std::to_string(cell) + ": " + std::to_string(c.values) + "/" +
                std::to_string(c.failures()) + "/" + std::to_string(c.undecided) + " ";
    }
    return text;
}

std::string held(const Ball& first, const Ball& finer, const Real& second, CountCell& cell) {
    return held_to({first, true, "closed-form"}, {finer, true, "closed-form"}, second, Real(0), 5,
                   cell);
}

Ball around(const char* middle, int decades) {
    return Ball::around(Ball(parse_decimal(middle), 200).midpoint(), pow(Real(10), -decades), 200);
}

} // namespace

TEST_CASE("the same seed draws the same contacts, another seed others; every value is inside") {
    // Every compiler, in particular GCC 12 and clang 14, must give these, regardless of the order
    // in which it evaluates a sum.
    CHECK(sampled_contact(3, 0, 1).text.find("m = \"10\"\nC = \"5.404e-1\"\n") !=
          std::string::npos);
    CHECK(sampled_contact(3, 0, 1).text.find("Q = \"-1.53e1\"\nbulk_tension = \"3.67e-3\"\n") !=
          std::string::npos);
    CHECK(sampled_contact(7, 12).text == sampled_contact(7, 12).text);
    CHECK(sampled_contact(7, 12).text != sampled_contact(8, 12).text);
    CHECK(sampled_contact(7, 12).text != sampled_contact(7, 13).text);
    CHECK(sampled_contact(1, 7, 5).profile == 5);
    std::size_t profiles[6] = {};
    std::size_t regimes[8] = {};
    for (std::size_t n = 0; n < 100; ++n) {
        const SampledContact c = sampled_contact(1, n);
        ++profiles[c.profile];
        for (const SampledValue& v : c.values) {
            ++regimes[v.regime];
        }
    }
    for (std::size_t p = 0; p < 5; ++p) {
        CHECK(profiles[p] > 0);
    }
    for (const std::size_t n : regimes) {
        CHECK(n > 20);
    }
}

TEST_CASE("a value compared with a second one: excluded, wrong, wide or undecided") {
    const PrecisionScope scope(60);
    const Real third = Real(1) / 3;
    CountCell good;
    CHECK(held(around("0.33333333333333333333", 15), around("0.333333333333333333333333", 20),
               third, good) == "");
    CHECK(good.values == 1);
    CHECK(good.failures() == 0);

    CountCell excluded; // the ball is 1e-15 wide, but the other value is 1e-10 off
    CHECK(held(around("0.33333333333333333333", 15), around("0.333333333333333333333333", 20),
               Real(third + pow(Real(10), -10)), excluded)
              .find("excludes") != std::string::npos);
    CHECK(excluded.excluded == 1);
    CHECK(excluded.wrong == 0);

    CountCell wrong; // 0.33333 and 0.33334
    CHECK(held(around("0.333334", 15), around("0.333336", 15), Real(0.333334), wrong)
              .find("digits printed") != std::string::npos);
    CHECK(wrong.wrong == 1);

    CountCell wide; // 4e-4 wide, while 10 units are 1e-4
    CHECK(held(Ball::around(third, Real(2) / 10000, 200), around("0.333333333333333333333333", 20),
               third, wide)
              .find("too wide") != std::string::npos);
    CHECK(wide.wide == 1);

    CountCell undecided;
    CHECK(held_to({around("0.3", 15), false, "series"}, {around("0.3", 15), true, "series"}, third,
                  Real(0), 5, undecided) == "no enclosure: series (estimate)");
    CHECK(undecided.undecided == 1);
    CHECK(undecided.failures() == 0);
}

TEST_CASE("values drawn: all enclosed, rounded correctly and tight, on one thread or two") {
    EnclosureCountOptions options = small(150, 30);
    const Result two = count_values(options);
    CHECK(two.total.values == 150);
    CHECK(two.total.failures() == 0);
    CHECK(two.total.undecided == 0);
    options.threads = 1;
    CHECK(cells_text(count_values(options)) == cells_text(two));
}

TEST_CASE("a wrong second value is counted, in its cell, with the data that reproduce it") {
    EnclosureCountOptions options = small(50);
    options.second = [](const SampledValue& v, Real& x) {
        if (v.asked.quantity == Quantity::b) {
            x *= 1 + pow(Real(10), -19);
        }
    };
    std::size_t edges = 0;
    for (const SampledValue& v : sampled_contact(options.seed, quick_contact).values) {
        edges += v.asked.quantity == Quantity::b ? 1 : 0;
    }
    CountedContact<CountFinding> found = count_contact(options, quick_contact, 50);
    REQUIRE(edges > 0);
    std::size_t excluded = 0;
    for (const auto& [cell, counted] : found.cells) {
        excluded += counted.excluded;
    }
    CHECK(excluded == edges);
    REQUIRE(found.findings.size() == edges);
    CHECK(found.findings.front().failed);
    CHECK(found.findings.front().asked == "b");
    CHECK(found.findings.front().scene.find("[profile]") == 0);
}

TEST_SUITE("slow") {
    TEST_CASE("2,000 values drawn: none excluded, no wrong digit, none too wide") {
        EnclosureCountOptions options = small(2000, 50);
        const Result result = count_values(options);
        CHECK(result.total.values == 2000);
        CHECK(result.total.failures() == 0);
        CHECK(result.total.undecided == 0);
    }
    TEST_CASE("a curved g': a few values") {
        EnclosureCountOptions options = small(5);
        CountedContact<CountFinding> found = count_contact(options, 7, 5);
        for (const CountFinding& f : found.findings) {
            CAPTURE(f.asked);
            CHECK(f.what == "");
        }
        CHECK(found.findings.empty());
    }
}
