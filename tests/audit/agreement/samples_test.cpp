// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "tests/audit/small_ledger.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <type_traits>

namespace {

SampleAgreement values(const char* printed, const char* exact, const char* error, double digits) {
    return ValuePair{Real(printed), Real(exact), digits, Real(error)};
}
SampleAgreement agreeing() { return values("1", "1", "1e-50", 50); }
SampleAgreement apart() { return values("2", "1", "1e-50", 0); }
Judgement judged_at(std::vector<SampleAgreement> samples_at) {
    Agreement a;
    a.samples_at = std::move(samples_at);
    return judge_samples(a, 45);
}
const NoValue no_value{"log of zero", true};
const OurLimit our_limit{"more than 100000 terms"};

} // namespace

TEST_CASE("samples: only two values that differ refute, whatever is missing elsewhere") {
    CHECK(judged_at({agreeing(), agreeing()}) == Verdict::confirmed);
    CHECK(judged_at({agreeing(), apart()}) == Verdict::refuted);
    CHECK(judged_at({no_value, our_limit, apart()}) == Verdict::refuted);
    CHECK(judged_at({no_value, no_value}) == Verdict::underspecified);
    CHECK(judged_at({agreeing(), our_limit, no_value}) == Verdict::underspecified);
    CHECK(judged_at({agreeing(), our_limit}) == Verdict::undecided);
    CHECK(judged_at({our_limit}) == Verdict::undecided);
    CHECK(judged_at({}) == Verdict::undecided);
    // Apart by less than the values are good for; not numbers at all.
    CHECK(judged_at({values("1.001", "1", "0.1", 3)}) == Verdict::undecided);
    CHECK(judged_at({values("nan", "1", "0", -5)}) == Verdict::undecided);
    CHECK(judged_at({values("inf", "1", "0", -5)}) == Verdict::undecided);
    CHECK(judged_at({values("2", "1", "nan", -5)}) == Verdict::undecided);
}

TEST_CASE("refuted is made of a difference, by type") {
    // No verdict, and so no constant either, becomes a judgement; nor can one be assigned.
    static_assert(!std::is_convertible_v<Verdict, Judgement>);
    static_assert(!std::is_constructible_v<Judgement, Verdict>);
    static_assert(!std::is_assignable_v<Judgement&, Verdict>);
    static_assert(!std::is_default_constructible_v<Difference>);
    CHECK(Judgement() == Verdict::undecided);
    CHECK(Judgement(Difference::of(Real(1), Real(1), Real(0))) == Verdict::undecided);
    CHECK(Judgement(Difference::of(Real(1), Real(2), Real(0))) == Verdict::refuted);
    CHECK(Judgement(Difference::of(Ball(1, 64), Ball(2, 64))) == Verdict::refuted);
    CHECK(Judgement(Difference::of(Ball(1, 64), Ball(1, 64) / 0)) == Verdict::undecided);
    CHECK(Judgement(Difference::not_above(Real(1), Real(2))) == Verdict::undecided);
    CHECK(Judgement(Difference::not_above(Real(1), Real(1))) == Verdict::refuted);
}

TEST_CASE("a few that are spread evenly over all come first") {
    using Order = std::vector<std::size_t>;
    CHECK(spread_first(11, 6) == Order{0, 2, 4, 6, 8, 10, 1, 3, 5, 7, 9});
    CHECK(spread_first(7, 3) == Order{0, 3, 6, 1, 2, 4, 5});
    for (const std::size_t first : {0U, 1U, 4U, 9U}) {
        CHECK(spread_first(4, first) == Order{0, 1, 2, 3});
    }
    CHECK(spread_first(0, 6).empty());
}

TEST_CASE("an interrupted run compares no more") {
    const Ledger ledger = parse_ledger(
        small_ledger::head + "[[claim]]\nid = \"C\"\nkind = \"value\"\nover = \"hertz\"\n"
                             "of = \"p(x)\"\nsays = \"Es*C/2*sqrt(a^2-x^2)\"\n",
        "small.toml");
    const Claim& claim = ledger.claims.front();
    const AuditContext context(ledger, 34);
    const auto samples_at = EvaluatedSamples::of(claim, context, 34);
    const Agreement agreement = samples_at->compare(claim.formula("says"), claim.formula("of"));
    CHECK(agreement.digits() > 29);
    request_interruption(2);
    CHECK_THROWS_AS((void)samples_at->compare(claim.formula("says"), claim.formula("of")),
                    Interrupted);
    withdraw_interruption();
}
