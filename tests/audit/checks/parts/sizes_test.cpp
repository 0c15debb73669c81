// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/sizes.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/audit/small_ledger.hpp"

#include <doctest/doctest.h>

namespace {

SceneSpec punch_scene() {
    SceneSpec scene{"punch", "tilted-flat-and-rounded", {}, {}, {}};
    for (const auto& [name, text] :
         {std::pair{"alpha", "pi/16"}, {"t", "1"}, {"R", "2"}, {"a", "1"}, {"Es", "1"}}) {
        scene.parameters.emplace(name, Exact::parse(text));
    }
    return scene;
}

} // namespace

TEST_CASE("sizes: the search finds intervals and jumps of a known function") {
    const SizeScan scan(punch_scene(), Exact::parse("1/10"), Exact::parse("50"));
    const auto set_of = [&](const std::function<Rational(const Rational&)>& f, const char* lower,
                            const char* upper) {
        const auto side = [&](const Rational& a) {
            const Rational y = f(a);
            return y < parse_decimal(lower)   ? contact::Side::below
                   : y < parse_decimal(upper) ? contact::Side::within
                                              : contact::Side::above;
        };
        std::vector<contact::Side> sides;
        std::ranges::transform(scan.sizes(), std::back_inserter(sides), side);
        return scan.where(sides, side);
    };
    const auto parabola = [](const Rational& a) { return Rational((a - 3) * (a - 3)); };
    const auto jump = [](const Rational& a) { return Rational(a < 7 ? 0 : 1); };
    CHECK(to_text(set_of(parabola, "1", "4")) == "1.00 ... 2.00; 4.00 ... 5.00");
    // Both ends lie between two sizes of the list.
    CHECK(to_text(set_of(parabola, "16", "16.5")) == "7.00 ... 7.06");
    CHECK(to_text(set_of(jump, "0.4", "0.6")) == "none");
    CHECK(to_text(set_of(jump, "0.5", "2")) == "7.00 ... 50.0 (end of the search)");
    CHECK(to_text(set_of([](const Rational&) { return Rational(1); }, "0", "2")) ==
          "0.100 (start of the search) ... 50.0 (end of the search)");
    CHECK(intersection(set_of(parabola, "1", "4"), set_of(jump, "0.5", "2")).empty());
    CHECK_THROWS_AS(SizeScan(punch_scene(), Exact::parse("2"), Exact::parse("1")), InputError);
}

TEST_CASE("sizes: a figure without its size is underspecified, its sizes are those it holds for") {
    const ClaimResult result = small_ledger::audit_of(small_ledger::ledger_of(R"(over = "punch"
kind = "size-extent"
edge = "left"
terms = 2
tolerance = "1/100"
unit = "1/100"
base = "side"
sizes = ["1/4", "16"]
figure = "10/100")",
                                                                              R"([ledger]
name = "sizes"
[[family]]
name = "punch"
profile = "tilted-flat-and-rounded"
count = 1
[family.parameters]
alpha = ["pi/16"]
t = ["1"]
R = ["2"]
a = ["1"]
Es = ["1"]
)"))
                                   .claims.front();
    const Outcome& o = result.outcome;
    CHECK(o.verdict == Verdict::underspecified);
    // The ends are 9.5 % and 10.5 % of the side.
    const EvidenceItem* side =
        o.evidence.find("first exit, of the side from the edge to the origin");
    REQUIRE(side != nullptr);
    const std::string sizes = std::get<Evidence>(side->value()).find("holds_for_a")->text();
    const std::size_t last = sizes.rfind("; ");
    REQUIRE(last != std::string::npos);
    const std::string interval = sizes.substr(last + 2);
    const std::size_t dots = interval.find(" ... ");
    const auto fraction = [&](const std::string& size) {
        SceneSpec scene = punch_scene();
        scene.parameters.insert_or_assign("a", Exact::parse(size));
        const EnclosedReach reach =
            enclosed_reach(scene, {Edge::left, 2, Exact::parse("1/100"), {}}, 20);
        REQUIRE(reach.extents);
        const EnclosedSample at({scene, std::nullopt, Edge::left, {}}, reach.bits);
        return (reach.extents->first_exit / at.evaluate(Expr::symbol("b"))).midpoint();
    };
    const PrecisionScope scope(30);
    CHECK(abs(fraction(interval.substr(0, dots)) - Real("0.095")) < Real("1e-3"));
    CHECK(abs(fraction(interval.substr(dots + 5)) - Real("0.105")) < Real("1e-3"));
}
