// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/sizes.hpp"
#include "edgeproof/audit/run.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/support/namespaces.hpp"

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

const std::string sizes_head = R"(
[ledger]
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
)";

std::string extent_claim(const std::string& id, const std::string& edge, int terms,
                         const std::string& figure, const std::string& more = "") {
    return "[[claim]]\nid = \"" + id + "\"\nkind = \"size-extent\"\nover = \"punch\"\nedge = \"" +
           edge + "\"\nterms = " + std::to_string(terms) +
           "\ntolerance = \"1/100\"\nunit = \"1/100\"\nbase = \"side\"\nsizes = [\"1/4\", " +
           "\"16\"]\nfigure = \"" + figure + "\"\n" + more;
}

AuditResult run_sizes(const std::string& claims) {
    const Ledger ledger = parse_ledger(sizes_head + claims, "sizes.toml");
    AuditOptions options;
    options.digits = 34;
    options.threads = 1;
    return run_audit(ledger, options);
}

std::string text_at(const Outcome& o, std::initializer_list<const char*> path) {
    const Evidence* e = &o.evidence;
    const EvidenceItem* item = nullptr;
    for (const char* key : path) {
        item = e->find(key);
        REQUIRE(item != nullptr);
        if (const auto* nested = std::get_if<Evidence>(&item->value())) {
            e = nested;
        }
    }
    return item->text();
}

const char* const first_of_side = "first exit, of the side from the edge to the origin";

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
    const AuditResult result = run_sizes(extent_claim("A", "left", 2, "10/100"));
    const Outcome& o = result.claims[0].outcome;
    CHECK(o.verdict == Verdict::underspecified);
    // The ends are 9.5 % and 10.5 % of the side.
    const std::string sizes = text_at(o, {first_of_side, "holds_for_a"});
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

TEST_CASE("sizes: a figure that no size gives is refuted, one that all sizes give is confirmed") {
    CHECK(run_sizes(extent_claim("A", "right", 2, "70/100")).claims[0].outcome.verdict ==
          Verdict::refuted);
    CHECK(run_sizes(extent_claim("A", "right", 1, "4/100")).claims[0].outcome.verdict ==
          Verdict::confirmed);
}

TEST_CASE("sizes: figures that hold together, and figures that do not") {
    const std::string together = "together = [\"A\", \"B\"]\n";
    // 42 % and 71 % both hold near a = 3/2; 43 % and 80 % hold together nowhere.
    const AuditResult both = run_sizes(extent_claim("A", "right", 2, "42/100", together) +
                                       extent_claim("B", "right", 3, "71/100", together));
    CHECK(text_at(both.claims[0].outcome, {first_of_side, "all_hold_for_a"}) != "none");
    CHECK(text_at(both.claims[1].outcome, {first_of_side, "together"}).find("A, B") !=
          std::string::npos);
    const AuditResult not_both = run_sizes(extent_claim("A", "right", 2, "42/100", together) +
                                           extent_claim("B", "right", 3, "80/100", together));
    CHECK(text_at(not_both.claims[0].outcome, {first_of_side, "all_hold_for_a"}) == "none");
    CHECK_THROWS_AS(
        (void)run_sizes(extent_claim("A", "right", 2, "42/100", "together = [\"Z\"]\n")),
        InputError);
}

TEST_CASE("sizes: a quotient of extents") {
    const std::string quotient = "over_terms = 1\n";
    CHECK(run_sizes(extent_claim("A", "right", 2, "12", quotient)).claims[0].outcome.verdict ==
          Verdict::underspecified);
    CHECK(run_sizes(extent_claim("A", "right", 2, "10", quotient)).claims[0].outcome.verdict ==
          Verdict::refuted);
}

TEST_CASE("sizes: a condition on the coefficients holds up to where an edge meets a knot") {
    const auto claim = [](const std::string& says) {
        return "[[claim]]\nid = \"A\"\nkind = \"size-condition\"\nover = \"punch\"\nsizes = "
               "[\"1/100\", \"100\"]\nsays = \"" +
               says + "\"\n";
    };
    const AuditResult result = run_sizes(claim("left.c1 < 0"));
    CHECK(result.claims[0].outcome.verdict == Verdict::underspecified);
    // At a = alpha R = pi/8 the left edge reaches the flat: for smaller sizes b = a.
    CHECK(text_at(result.claims[0].outcome, {"holds_for_a"}).find("... 0.393;") !=
          std::string::npos);
    CHECK(run_sizes(claim("right.c1 < 0")).claims[0].outcome.verdict == Verdict::confirmed);
    // It fails at every tried size, which proves nothing for the sizes between.
    CHECK(run_sizes(claim("b < a")).claims[0].outcome.verdict == Verdict::undecided);
}
