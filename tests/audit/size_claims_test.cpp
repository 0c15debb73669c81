// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/sizes.hpp"
#include "edgeproof/audit/run.hpp"
#include "edgeproof/contact/routes/extent.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

const Profile& punch() {
    static const Profile p = Profile::tilted_flat_and_rounded(Exact::parse("pi/16"),
                                                              Exact::parse("1"), Exact::parse("2"));
    return p;
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
           "\ntolerance = \"1/100\"\nunit = \"1/100\"\nbase = \"side\"\nsizes = [\"1/100\", " +
           "\"100\"]\nfigure = \"" + figure + "\"\n" + more;
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

TEST_CASE("sizes: extents in binary128 are those of the multiprecision scan") {
    const ContactsBySize contacts(punch());
    // The left edge is on the right arc, on the flat, near the knot, and on the left arc.
    for (const char* size : {"1/4", "3/5", "0.99", "5/4", "10"}) {
        const Exact a = Exact::parse(size);
        const NormalContact contact(punch(), Exact::parse("1"), Load::right_edge(a), 30);
        ContactsBySize::At at = contacts.at(a.to<Float128>());
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (const std::size_t terms : {1U, 2U, 3U}) {
                CAPTURE(size);
                CAPTURE(terms);
                const ExtentOf of{edge, terms, Float128(1) / 100};
                const auto fine = at.fractions(of);
                const auto rough = at.fractions(of, false);
                const Extents all = within_tolerance(contact, edge, terms, Exact::parse("1/100"));
                const PrecisionScope scope(40);
                CHECK(abs(Real(fine[2]) / (all.first_exit / all.length) - 1) < Real("1e-20"));
                CHECK(abs(Real(fine[3]) / (all.measure / all.length) - 1) < Real("1e-20"));
                for (std::size_t r = 0; r < fine.size(); ++r) {
                    CHECK(abs(Real(rough[r]) / Real(fine[r]) - 1) < Real("1e-11"));
                }
                // For a side, the first exit is the same, unless the side ends before it.
                const Real side = edge == Edge::right ? contact.a() : contact.b();
                const Real first = all.first_exit < side ? all.first_exit : side;
                CHECK(abs(Real(fine[0]) * side / first - 1) < Real("1e-20"));
            }
        }
    }
}

TEST_CASE("sizes: the search finds intervals, extrema and jumps of a known function") {
    const SizeScan scan(punch(), Exact::parse("1/10"), Exact::parse("50"));
    const auto set_of = [&](const SizeScan::Function& f, const char* lower, const char* upper) {
        std::vector<Float128> values;
        for (const Float128& a : scan.sizes()) {
            values.push_back(f(a));
        }
        return scan.between(f, values, Float128(lower), Float128(upper));
    };
    const SizeSet parabola =
        set_of([](const Float128& a) { return Float128((a - 3) * (a - 3)); }, "1", "4");
    REQUIRE(parabola.size() == 2);
    const auto near = [](const Float128& x, const char* y) {
        return abs(Float128(x - Float128(y))) < Float128("1e-13");
    };
    CHECK(near(parabola[0].from, "1"));
    CHECK(near(parabola[0].to, "2"));
    CHECK(near(parabola[1].from, "4"));
    CHECK(near(parabola[1].to, "5"));
    // The bottom of the parabola, which lies between the tried sizes.
    CHECK(set_of([](const Float128& a) { return Float128((a - 3) * (a - 3)); }, "-1", "1e-8")
              .size() == 1);
    // A jump across the interval gives no interval of sizes.
    CHECK(set_of([](const Float128& a) { return Float128(a < 7 ? 0 : 1); }, "0.4", "0.6").empty());
    const SizeSet step =
        set_of([](const Float128& a) { return Float128(a < 7 ? 0 : 1); }, "0.5", "2");
    REQUIRE(step.size() == 1);
    CHECK(near(step[0].from, "7"));
    CHECK(step[0].open_above);
    CHECK(is_everything(set_of([](const Float128&) { return Float128(1); }, "0", "2")));
    CHECK(intersection(parabola, step).empty());
    CHECK_THROWS_AS(SizeScan(punch(), Exact::parse("2"), Exact::parse("1")), InputError);
}

TEST_CASE("sizes: a figure without its size is underspecified, its sizes are those it holds for") {
    const AuditResult result = run_sizes(extent_claim("A", "left", 2, "10/100"));
    const Outcome& o = result.claims[0].outcome;
    CHECK(o.verdict == Verdict::underspecified);
    // The ends by the multiprecision scan are 9.5 % and 10.5 % of the side.
    const std::string sizes = text_at(o, {first_of_side, "holds_for_a"});
    const std::size_t last = sizes.rfind("; ");
    REQUIRE(last != std::string::npos);
    const std::string interval = sizes.substr(last + 2);
    const std::size_t dots = interval.find(" ... ");
    const auto fraction = [&](const std::string& size) {
        const NormalContact contact(punch(), Exact::parse("1"),
                                    Load::right_edge(Exact::parse(size)), 20);
        const Extents e = within_tolerance(contact, Edge::left, 2, Exact::parse("1/100"));
        return Real(e.first_exit / contact.b());
    };
    const PrecisionScope scope(30);
    CHECK(abs(fraction(interval.substr(0, dots)) - Real("0.095")) < Real("1e-11"));
    CHECK(abs(fraction(interval.substr(dots + 5)) - Real("0.105")) < Real("1e-11"));
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
    CHECK(text_at(result.claims[0].outcome, {"holds_for_a"}).find("... 0.392699081699;") !=
          std::string::npos);
    CHECK(run_sizes(claim("right.c1 < 0")).claims[0].outcome.verdict == Verdict::confirmed);
    // It fails at every tried size, which proves nothing for the sizes between.
    CHECK(run_sizes(claim("b < a")).claims[0].outcome.verdict == Verdict::undecided);
}
