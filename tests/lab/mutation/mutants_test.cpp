// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "lab/mutation/mutants.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

namespace {

/// Returns "kind: formula" of every mutant.
std::set<std::string> mutants(const std::string& text) {
    Symbols symbols;
    for (const char* name : {"a", "b", "P1", "P2", "t", "right_c0"}) {
        symbols.add(name);
    }
    std::set<std::string> all;
    for (const Mutant& m : mutants_of(parse(text, symbols))) {
        all.insert(m.kind + ": " + to_text(m.formula));
    }
    return all;
}

/// Hertz, with enough scenes to distinguish powers of different parameters.
const std::string mutants_head = R"toml([ledger]
name = "small"
[[family]]
name = "hertz"
profile = "power-law"
count = 8
u = ["1/200", "1/3"]
[family.parameters]
m = ["1"]
C = ["3/7", "1e-6", "2"]
a = ["3/2", "7e5", "0.02"]
Es = ["7/3", "2.1e11"]
)toml";

MutationRun run_all(const std::string& claims, int threads, std::size_t count = 1000) {
    const Ledger ledger = parse_ledger(mutants_head + claims, "small.toml");
    MutationOptions options;
    options.audit.digits = 20;
    options.audit.threads = threads;
    options.mutants = count;
    return run_mutants(ledger, options);
}

const std::string hertz_pressure =
    "[[claim]]\nid = \"H\"\nkind = \"value\"\nover = \"hertz\"\nof = \"p(x)\"\n"
    "says = \"Es*C/2*sqrt(a^2 - x^2)\"\n";
/// For a symmetric contact b = a, so that exchanging them has no effect.
const std::string first_claim = "[[claim]]\nid = \"F\"\nkind = \"identity\"\nover = \"hertz\"\n"
                                "of = \"right.c0\"\nsays = \"P1*sqrt(2)/(Pi*sqrt(b))\"\n";

} // namespace

TEST_CASE("every misprint of the eight kinds, and no other") {
    CHECK(mutants("2.5*a - P1") ==
          std::set<std::string>{"sign: 2.5*a + P1", "coefficient: 2.6*a - P1",
                                "coefficient: 2.4*a - P1", "factor: 2.5 - P1", "factor: a - P1",
                                "a for b: 2.5*b - P1", "prime: 2.5*a - P2"});
    CHECK(mutants("sqrt(t)/t^2") == std::set<std::string>{"root: t/t^2", "factor: sqrt(t)",
                                                          "exponent: sqrt(t)/t^2.5",
                                                          "exponent: sqrt(t)/t^1.5"});
    CHECK(mutants("-right_c0") ==
          std::set<std::string>{"sign: right_c0", "left for right: -left_c0"});
    CHECK(mutants("t").empty());
}

TEST_CASE("a ledger without a formula is refused, with the kinds of claim that are changed") {
    const std::string independence =
        "[[claim]]\nid = \"I\"\nkind = \"independence\"\nover = \"hertz\"\n"
        "of = \"p(x) - p(-x)\"\nat = [\"1/5\"]\n";
    CHECK_THROWS_WITH_AS(run_all(independence, 1),
                         doctest::Contains("no formula of small.toml has an id like '*'"),
                         InputError);
}

TEST_CASE("wrong mutants are refuted, equal ones are proved equal, and the edit is named") {
    const MutationRun r = run_all(hertz_pressure + first_claim, 1);
    CHECK(r.claims == 2);
    CHECK(r.fates.size() == r.possible);
    REQUIRE(r.fates.size() > 15);
    std::size_t refuted = 0;
    std::size_t named = 0;
    for (const MutantFate& f : r.fates) {
        CAPTURE(f.mutated);
        CAPTURE(f.note);
        CHECK(f.caught() != f.equivalent);
        refuted += f.verdict == Verdict::refuted ? 1 : 0;
        named += f.named ? 1 : 0;
    }
    CHECK(named * 10 >= refuted * 8);
    const auto a_for_b = std::count_if(r.fates.begin(), r.fates.end(), [](const MutantFate& f) {
        return f.claim == "F" && f.kind == "a for b";
    });
    CHECK(a_for_b == 1);
}

TEST_CASE("the seed chooses the mutants, not the number of threads") {
    const MutationRun one = run_all(hertz_pressure + first_claim, 1, 8);
    const MutationRun two = run_all(hertz_pressure + first_claim, 2, 8);
    REQUIRE(one.fates.size() == 8);
    REQUIRE(two.fates.size() == 8);
    for (std::size_t k = 0; k < 8; ++k) {
        CHECK(one.fates[k].mutated == two.fates[k].mutated);
        CHECK(one.fates[k].verdict == two.fates[k].verdict);
    }
}

TEST_CASE(
    "the second mutant of a claim that is compared with an integral is decided like the first") {
    const MutationRun r = run_all(hertz_pressure + R"toml([[claim]]
id = "P"
kind = "value"
lines = [1, 2]
printed = "P"
over = "hertz"
of = "integral(p(s), s, -a, a)"
says = "Pi*Es*C*a^2/4"
)toml",
                                  1);
    std::size_t different = 0;
    for (const MutantFate& f : r.fates) {
        CAPTURE(f.mutated);
        CHECK((f.equivalent || f.caught()));
        different += f.equivalent ? 0 : 1;
    }
    CHECK(different > 4);
}
