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

Sample wedge_sample(Edge edge, const char* fraction) {
    Sample sample;
    sample.scene.family = "wedge";
    sample.scene.profile = "tilted-wedge";
    for (const auto& [name, text] : std::map<std::string, const char*>{
             {"phi", "1/3"}, {"alpha", "1/7"}, {"a", "3/2"}, {"Es", "7/3"}}) {
        sample.scene.parameters.emplace(name, Exact::parse(text));
    }
    sample.fraction = Exact::parse(fraction);
    sample.edge = edge;
    return sample;
}

/// The balls of both formulas must be narrow and overlap.
std::string fault_of(const std::string& text, const std::string& known, const Sample& sample) {
    const unsigned digits = 40;
    const Enclosed x = enclosed(contact_formula(text), sample, digits);
    const Enclosed y = enclosed(contact_formula(known), sample, digits);
    if (!x.ball || !y.ball) {
        return text + ": " + x.problem + y.problem;
    }
    if (disjoint(*x.ball, *y.ball)) {
        return text + " = " + ball_text(*x.ball, 30) + ", not " + ball_text(*y.ball, 30);
    }
    return x.ball->relative_accuracy_bits() < bits_for(digits) ? text + " is wide" : "";
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

TEST_CASE("a sample's names and functions have the values of the closed form of a tilted wedge") {
    // moore-hills, section 3.2: everything scales with a; b, p and the force in closed form.
    const std::string s = "sin(3*Pi/14)";
    const std::string k = "sqrt(b*(a - x)/(a*(x + b)))";
    const std::pair<const char*, std::string> known[] = {
        {"b", "a*(1 - " + s + ")/(1 + " + s + ")"},
        {"L", "a + b"},
        {"edge_distance", ""},
        {"p(x)", "Es/(3*Pi)*log(abs((1 + " + k + ")/(1 - " + k + ")))"},
        {"P1", "P/a"},
        {"b1", "b/a"},
        {"right_c0", "2*P1/(Pi*sqrt(L))"},
        {"left_c0", "right_c0/b1"},
        {"right_c1", "(2*b1 + 3)*P1/(3*Pi*L^(3/2))"},
        {"Pof(a*9/10)", "P*9/10"},
        {"P1of(a*11/10)", "P1"},
        {"bof(a + u/3)", "b*(a + u/3)/a"},
        {"binv(b*21/20 + u/9)", "a*(b*21/20 + u/9)/b"},
        {"bof(binv(b + u/8) + a/9)", "b + u/8 + b/9"},
        {"right_local(2, x)", "right_c0*sqrt(a - x) + right_c1*(a - x)^(3/2)"},
        {"left_local(1, x)", "left_c0*sqrt(x + b)"}};
    for (const Edge edge : {Edge::right, Edge::left}) {
        for (const char* fraction : {"1e-20", "1/7", "2/3"}) {
            const Sample sample = wedge_sample(edge, fraction);
            CAPTURE(sample.text());
            for (const auto& [text, value] : known) {
                const bool distance = value.empty();
                CHECK(fault_of(distance ? "u" : text,
                               distance ? (edge == Edge::right ? "a - x" : "x + b") : value,
                               sample) == "");
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

TEST_CASE("the note counts the samples that were enclosed") {
    const ClaimResult integral = result_of(
        value_claim("Es/(2*Pi)*sqrt(a^2-x^2)*pv(g1(s)/sqrt(a^2-s^2)*(1/(s-x)), s, -a, a, x)"));
    const std::string enclosed = enclosures_of(integral).find("samples")->text();
    CHECK(integral.outcome.note == "agrees at " + enclosed + " samples");
}

TEST_CASE("P'(a) and b'(a) of a curved slope are enclosed") {
    const auto verdict = [](const std::string& of, const std::string& says) {
        return verdict_of("kind = \"value\"\nover = \"curved\"\nof = \"" + of + "\"\nsays = \"" +
                          says + "\"\n");
    };
    // Derived by hand: P = Es/2 (pi a^2/12 + 3 pi a^4/64), differentiated.
    CHECK(verdict("P1", "Es*Pi/2*(a/6 + 3*a^3/16)") == "confirmed");
    CHECK(verdict("P1", "Es*Pi/2*(a/6 + 3*a^3/16)*(1 + 1e-20)") == "refuted");
    CHECK(verdict("b1", "1") == "confirmed");
}

TEST_CASE("where the value is zero, digits are proved relative to the claim's scale") {
    const std::string zero = "kind = \"value\"\nover = \"hertz\"\nof = \"0\"\nsays = "
                             "\"integral(g1(s)/sqrt(a^2-s^2), s, -a, a)\"\n";
    const ClaimResult result = result_of(zero + "scale = \"C*a\"\n");
    const Evidence& scaled = enclosures_of(result);
    CHECK(scaled.find("digits_proved")->text() == "34.0");
    CHECK(scaled.find("samples")->text() == "2");
}

TEST_CASE("integrals of the contact are proved to the digits of the run, never rounded up") {
    const ClaimResult force = result_of(
        value_claim("Es/(2*Pi)*sqrt(a^2-x^2)*pv(g1(s)/sqrt(a^2-s^2)*(1/(s-x)), s, -a, a, x)"));
    CHECK(force.outcome.verdict == Verdict::confirmed);
    CHECK(std::stod(enclosures_of(force).find("digits_proved")->text()) > 30);
    const ClaimResult wrong =
        result_of(value_claim("Es/2*sqrt(a^2-x^2)*pv(g1(s)/sqrt(a^2-s^2)*(1/(s-x)), s, -a, a, x)"));
    CHECK(wrong.outcome.verdict == Verdict::refuted);
    CHECK(basis_of(wrong) == Basis::enclosures);
}

TEST_CASE("past 100 digits an integral is proved to 100 at every sample, and to all at some") {
    const std::string of_pressure = "kind = \"value\"\nover = \"nine\"\nof = \"P\"\nsays = \"";
    const ClaimResult right = result_of(of_pressure + "integral(p(s), s, -a, a)\"\n", 130);
    CHECK(right.outcome.verdict == Verdict::confirmed);
    CHECK(right.outcome.evidence.find("digits")->text() == "100.0");
    const auto& all = std::get<Evidence>(right.outcome.evidence.find("all_digits")->value());
    CHECK(std::stod(all.find("digits")->text()) > 125);
    CHECK(all.find("samples")->text() == "6");
    CHECK(right.outcome.evidence.find("samples")->text() == "9");
    const ClaimResult wrong =
        result_of(of_pressure + "integral(p(s), s, -a, a)*(1 + 1e-115)\"\n", 130);
    CHECK(wrong.outcome.verdict == Verdict::refuted);
    CHECK(basis_of(wrong) == Basis::enclosures);
}

TEST_CASE("a ball's text holds all of the ball") {
    const Ball ball = Ball::around(Real(2) / 3, Real("0.001"), 200);
    CHECK(ball_text(ball, 2) == "0.67 +- 0.0044");
    CHECK(ball_text(Ball(5, 100), 3) == "5.00 +- 0");
}

TEST_CASE("a ball's text shows no digit that the ball does not know") {
    const Real thousandth = Real(1) / 1000;
    CHECK(ball_text(Ball::around(Real(1) / 8, Real(2), 200), 50) == "0 +- 2.2");
    const std::string wide = ball_text(Ball::around(Real(2) / 3, thousandth, 200), 50);
    CHECK(wide.substr(0, 10) == "0.6667 +- ");
}
