// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/audit/contact_formula.hpp"
#include "tests/audit/small_ledger.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::small_ledger;

namespace {

Sample tilted_sample(Edge edge, const char* fraction) {
    Sample sample;
    sample.scene.family = "tilted";
    sample.scene.profile = "tilted-flat-and-rounded";
    for (const auto& [name, text] : std::map<std::string, const char*>{{"alpha", "pi/100"},
                                                                       {"t", "1/2"},
                                                                       {"R", "3"},
                                                                       {"a", "5/4"},
                                                                       {"Es", "7/3"},
                                                                       {"Q", "3/10"},
                                                                       {"sig0", "-2/7"}}) {
        sample.scene.parameters.emplace(name, Exact::parse(text));
    }
    sample.fraction = Exact::parse(fraction);
    sample.edge = edge;
    return sample;
}

/// The value in Real must lie in the ball, up to its own error, and the ball must be narrow.
std::string fault_of(const std::string& text, const Sample& sample) {
    const unsigned digits = 40;
    const Expr e = contact_formula(text);
    const EvaluatedScene scene_values(sample.scene, digits);
    const Place place = scene_values.place(sample.edge, *sample.fraction);
    const Real value = scene_values.evaluate(e, &place).value;
    const Enclosed ball = enclosed(e, sample, digits);
    if (!ball.ball) {
        return text + ": " + ball.problem;
    }
    const PrecisionScope scope(digits + 20);
    const Real slack = abs(value) * pow(Real(10), -static_cast<int>(digits) + 3);
    if (disjoint(*ball.ball, Ball::around(value, slack, 400))) {
        return text + " = " + value_text(value, 30) + " is not in " + ball_text(*ball.ball, 30);
    }
    return ball.ball->relative_accuracy_bits() < bits_for(digits) ? text + " is wide" : "";
}

const Evidence& enclosures_of(const ClaimResult& r) {
    const EvidenceItem* item = r.outcome.evidence.find("enclosures");
    REQUIRE(item != nullptr);
    return std::get<Evidence>(item->value());
}

std::string value_claim(const std::string& says) {
    return "kind = \"value\"\nover = \"hertz\"\nof = \"p(x)\"\nsays = \"" + says + "\"\n";
}

} // namespace

TEST_CASE("a sample's names and functions in balls hold the values found in Real") {
    for (const Edge edge : {Edge::right, Edge::left}) {
        for (const char* fraction : {"1e-20", "1/7", "2/3"}) {
            const Sample sample = tilted_sample(edge, fraction);
            CAPTURE(sample.text());
            for (const char* text : {"a",
                                     "b",
                                     "L",
                                     "x",
                                     "u",
                                     "P",
                                     "M",
                                     "P1",
                                     "P2",
                                     "P3",
                                     "P5",
                                     "b1",
                                     "b2",
                                     "b3",
                                     "right_c0",
                                     "right_c2",
                                     "left_c0",
                                     "left_c3",
                                     "right_s0",
                                     "left_s1",
                                     "p(x)",
                                     "p(a - u/3)",
                                     "q(x)",
                                     "g1(x)",
                                     "right_local(2, x)",
                                     "left_local(3, x)",
                                     "Pof(a*9/10)",
                                     "P1of(a*11/10)",
                                     "bof(a)",
                                     "bof(a + u/3)",
                                     "Pof(a*(1 + b1/7))",
                                     "P1of(L)",
                                     "binv(b)",
                                     "binv(b*21/20 + u/9)",
                                     "bof(binv(b + u/8) + a/9)"}) {
                CHECK(fault_of(text, sample) == "");
            }
        }
    }
}

TEST_CASE("confirmed states how many digits are proved, refuted shows two disjoint balls") {
    const ClaimResult right = result_of(value_claim("Es*C/2*sqrt(a^2-x^2)"));
    CHECK(right.outcome.verdict == Verdict::confirmed);
    CHECK(enclosures_of(right).find("digits_proved")->text() == "34.0");
    CHECK_FALSE(std::get<bool>(enclosures_of(right).find("disjoint")->value()));
    const ClaimResult wrong = result_of(value_claim("Es*C/2*sqrt(a^2-x^2)*(1+1e-25)"));
    CHECK(wrong.outcome.verdict == Verdict::refuted);
    CHECK(std::get<bool>(enclosures_of(wrong).find("disjoint")->value()));
    CHECK(basis_of(wrong) == Basis::enclosures);
}

TEST_CASE("a pair of enclosures in the evidence, or the reason that there is none") {
    const Ball third(Rational(1, 3), 100);
    const Evidence pair = pair_evidence("anywhere", "printed", third, "exact", third, 20);
    CHECK_FALSE(std::get<bool>(pair.find("disjoint")->value()));
    const Evidence none = pair_evidence("anywhere", "printed", Enclosed{third, ""}, "exact",
                                        Enclosed{std::nullopt, "no closed form"}, 20);
    CHECK(none.find("none")->text() == "no closed form");
}

TEST_CASE("a value that agrees to D - 5 digits, but is certainly different, is confirmed so") {
    // 34 digits are asked for.
    const ClaimResult near = result_of(value_claim("Es*C/2*sqrt(a^2-x^2)*(1+1e-32)"));
    CHECK(near.outcome.verdict == Verdict::confirmed);
    CHECK(near.outcome.note.find("; not identical: differs by 1.0e-32 of the value, ") !=
          std::string::npos);
    CHECK(std::get<bool>(enclosures_of(near).find("disjoint")->value()));
    const ClaimResult far = result_of(value_claim("Es*C/2*sqrt(a^2-x^2)*(1+1e-28)"));
    CHECK(far.outcome.verdict == Verdict::refuted);
}

TEST_CASE("a correction is never a formula that only agrees to the digits asked") {
    // The sum of seven terms is another formula; p of Hertz in two exact forms may correct it.
    const ClaimResult wrong = result_of(value_claim("right_local(7, x)"));
    CHECK(wrong.outcome.verdict == Verdict::refuted);
    const std::string correct = wrong.outcome.correct.value_or("");
    CAPTURE(correct);
    CHECK((correct.empty() || correct == "Es*C/2*sqrt(a^2 - x^2)" ||
           correct == "2*P/(Pi*a)*sqrt(1 - (x/a)^2)"));
}
