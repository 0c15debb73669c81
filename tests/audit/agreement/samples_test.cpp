// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "tests/audit/small_ledger.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <type_traits>

TEST_CASE("refuted is made from a refutation, confirmed from a confirmation, by type") {
    // A verdict, also a constant one, cannot be converted or assigned to a judgement.
    static_assert(!std::is_convertible_v<Verdict, Judgement>);
    static_assert(!std::is_constructible_v<Judgement, Verdict>);
    static_assert(!std::is_assignable_v<Judgement&, Verdict>);
    static_assert(!std::is_default_constructible_v<Refutation>);
    static_assert(!std::is_default_constructible_v<Confirmation>);
    // Values in Real cannot make either of them.
    static_assert(!std::is_constructible_v<Refutation, Real>);
    static_assert(!std::is_constructible_v<Confirmation, Real>);
    CHECK(Judgement() == Verdict::undecided);
    CHECK(Judgement(Decision()) == Verdict::undecided);
}

TEST_CASE("balls decide a comparison that holds for all of their numbers") {
    const Ball one(1, 64);
    const Ball two(2, 64);
    const Ball about_one = Ball::around(Real(1), Real("1e-6"), 64);
    const Ball nothing = one / 0;
    CHECK(Refutation::disjoint(one, two));
    CHECK_FALSE(Refutation::disjoint(one, about_one));
    CHECK_FALSE(Refutation::disjoint(one, nothing));
    CHECK(Refutation::less(one, two));
    CHECK_FALSE(Refutation::less(one, one));
    CHECK_FALSE(Refutation::less(nothing, two));
    CHECK(Confirmation::agreement(one, about_one, one, 5));
    CHECK_FALSE(Confirmation::agreement(one, about_one, one, 7));
    // Zero agrees only to a number of digits relative to a scale, or exactly.
    const Ball zero(0, 64);
    const Ball about_zero = Ball::around(Real(0), Real("1e-30"), 64);
    CHECK(Confirmation::agreement(zero, about_zero, two, 29));
    CHECK_FALSE(Confirmation::agreement(zero, about_zero, zero, 1));
    CHECK(Confirmation::agreement(zero, zero, zero, 50));
    CHECK_FALSE(Confirmation::agreement(zero, nothing, one, 1));
    CHECK(Confirmation::within(about_one, Rational(1, 2), Rational(3, 2)));
    CHECK_FALSE(Confirmation::within(about_one, Rational(1), Rational(3, 2)));
    CHECK(Confirmation::within(one, Rational(1), Rational(3, 2)));
    CHECK_FALSE(Confirmation::within(one, Rational(1, 2), Rational(1)));
}

TEST_CASE("all parts must hold, and one that fails refutes") {
    const Ball one(1, 64);
    const Ball two(2, 64);
    const Decision holds(*Confirmation::less(one, two));
    const Decision fails(*Refutation::less(one, two));
    CHECK(Judgement::of_all({holds, holds}) == Verdict::confirmed);
    CHECK(Judgement::of_all({holds, {}}) == Verdict::undecided);
    CHECK(Judgement::of_all({holds, {}, fails}) == Verdict::refuted);
    CHECK(Judgement::of_all({}) == Verdict::undecided);
}

TEST_CASE("a few samples spread evenly over all come first") {
    using Order = std::vector<std::size_t>;
    CHECK(spread_first(11, 6) == Order{0, 2, 4, 6, 8, 10, 1, 3, 5, 7, 9});
    CHECK(spread_first(7, 3) == Order{0, 3, 6, 1, 2, 4, 5});
    for (const std::size_t first : {0U, 1U, 4U, 9U}) {
        CHECK(spread_first(4, first) == Order{0, 1, 2, 3});
    }
    CHECK(spread_first(0, 6).empty());
}

TEST_CASE("an interrupted run stops comparing") {
    const Ledger ledger = parse_ledger(
        small_ledger::head + "[[claim]]\nid = \"C\"\nkind = \"compare\"\nover = \"hertz\"\n"
                             "of = \"p(x)\"\nsays = \"Es*C/2*sqrt(a^2-x^2)\"\n",
        "small.toml");
    const Claim& claim = ledger.claims.front();
    const AuditContext context(ledger, 34);
    const ClaimSamples samples(claim, context);
    const SampledComparison with{samples, claim.formula("of"), std::nullopt, 34};
    CHECK(Agreement(claim.formula("says"), with).worst().digits() > 29);
    request_interruption(2);
    CHECK_THROWS_AS(Agreement(claim.formula("says"), with), Interrupted);
    withdraw_interruption();
}
