// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/page/errata.hpp"
#include "edgeproof/report/page/html.hpp"
#include "edgeproof/report/text/percent.hpp"
#include "tests/audit/small_ledger.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

/// The errata of a ledger with one claim about Hertz's contact. One term is 1/sqrt(1 - v/2) times
/// the pressure at u = v a, so that it is within 1 % up to v = 2 - 2/1.01^2 = 0.0394: 7 % is wrong.
std::string errata_of_sentence(const std::string& printed, const std::string& quoted) {
    const AuditResult result = small_ledger::audit_of(
        "kind = \"compare\"\nover = \"hertz\"\nof = \"exit(1, 1/100)/a\"\nquoted = \"" + quoted +
        "\"\nprinted = '''" + printed + "'''\n");
    REQUIRE(result.claims.front().outcome.verdict == audit::Verdict::refuted);
    return errata_tex(result, {});
}

} // namespace

TEST_CASE("errata quote a sentence with the figure that is corrected, however late it stands") {
    const std::string start =
        "Similarly, for a contact of this kind, as the reader will by now have come to expect from "
        "the examples that were given above and from those that the appendix contains, and from "
        "the many that the literature has, of which we can cite only a few here for lack of space, "
        "the relative error of the first term alone is $<1\\%$ ";
    const std::string tex =
        errata_of_sentence(start + "for $\\approx 7\\%$ of the half-width, and no more.", "7 %");
    CHECK(test::has(tex, "\\approx 7\\%$ of the half-width"));
    CHECK(test::has(tex, "For $7\\,\\%$ read"));
    // 17 and 7.5 are other numbers than 7.
    const std::string others = errata_of_sentence(
        start + "for the $17\\%$ of Fig. 3 and the $7.5\\%$ of Fig. 4, and for the pads and the "
                "other examples of that section it is for $\\approx 7\\%$, and no more.",
        "7 %");
    CHECK(test::has(others, "\\approx 7\\%$"));
    // A long sentence is cut behind its figure.
    const std::string cut = errata_of_sentence(
        "The error is $<1\\%$ for $\\approx 7\\%$ of the half-width. " + start + "everywhere.",
        "7 %");
    CHECK(test::has(cut, "\\approx 7\\%$ of the half-width"));
    CHECK(test::has(cut, "\\,\\dots''"));
    CHECK_FALSE(test::has(cut, "everywhere"));
}

TEST_CASE("errata set a display of one line within the sentence") {
    const std::string tex = errata_of_sentence(
        "the error is $<1\\%$ for $7\\%$ when\n\\begin{equation}\n\\frac{u}{a}=\\frac{7}{100},",
        "7 %");
    CHECK(test::has(tex, "when\n$\\frac{u}{a}=\\frac{7}{100}$''"));
    CHECK_FALSE(test::has(tex, "begin{equation}"));
}

TEST_CASE("a counterexample whose printed value is zero shows it") {
    // log(1) = 0, whereas the pressure of Hertz's contact is not 0.
    const AuditResult result = small_ledger::audit_of(
        "kind = \"compare\"\nover = \"hertz\"\nof = \"p(x)\"\nprinted = \"p\"\n"
        "says = \"Es*C*a*log(abs((sqrt(a) - sqrt(x))/(sqrt(a) - sqrt(x))))\"\n");
    const audit::ClaimResult& claim = result.claims.front();
    REQUIRE(claim.outcome.verdict == audit::Verdict::refuted);
    const auto steps = counterexample_steps(claim, {});
    REQUIRE(steps.size() == 3);
    CHECK(test::has(steps[1], " = 0$;"));
    CHECK_FALSE(test::has(steps[2], " = 0$"));
}

TEST_CASE("statements of a file for Coq, without its proofs") {
    const std::string file = "(* Claim *)\n"
                             "From Coq Require Import Reals.\n"
                             "Open Scope R_scope.\n"
                             "\n"
                             "Definition a : R := 1.\n"
                             "Ltac sides := lra.\n"
                             "Lemma helper : 0 <\n  1.\n"
                             "Proof.\n  lra.\nQed.\n"
                             "Theorem first (x : R) :\n  0 < x ->\n  0 <= x.\n"
                             "Proof.\n  (* Theorem of order. *)\n  lra.\nQed.\n"
                             "Print Assumptions first.\n"
                             "Theorem second : 0 < 1.\n"
                             "Proof. lra. Qed.\n";
    CHECK(theorem_statements(file) == "Definition a : R := 1.\n"
                                      "Theorem first (x : R) :\n  0 < x ->\n  0 <= x.\n"
                                      "Theorem second : 0 < 1.\n");
}

TEST_CASE("a tolerance in percent") {
    const auto shown = [](const char* text) { return in_percent(formula::Exact::parse(text)); };
    CHECK(shown("1/100") == "1 %");
    CHECK(shown("0.01") == "1 %");
    CHECK(shown("0.025") == "2.5 %");
    CHECK(shown("1e-6") == "0.0001 %");
    CHECK(shown("1/3") == "1/3");
    CHECK(shown("sqrt(2)/100") == "sqrt(2)/100");
}

TEST_CASE("errata call no line a misprint if the ledger does not state what rests on its lines") {
    const AuditResult result = small_ledger::audit_of(
        "kind = \"compare\"\nover = \"hertz\"\nof = \"p(x)\"\nsays = \"Es*C/3*sqrt(a^2 - x^2)\"\n"
        "printed = 'p = \\frac{E^*C}{3}\\sqrt{a^2-x^2}'\n");
    REQUIRE(result.claims.front().outcome.verdict == audit::Verdict::refuted);
    const std::string tex = errata_tex(result, {});
    CHECK(test::has(tex, "1 error found."));
    CHECK_FALSE(test::has(tex, "misprint"));
    CHECK_FALSE(test::has(tex, "matter"));
}

TEST_CASE("errata call only those lines misprints for which the ledger states what rests on them") {
    const std::string value = "kind = \"compare\"\nover = \"hertz\"\nof = \"p(x)\"\n";
    const AuditResult result = small_ledger::audit_of(
        value + "says = \"Es*C/3*sqrt(a^2 - x^2)\"\n[[claim]]\nid = \"D\"\n" + value +
        "says = \"Es*C/4*sqrt(a^2 - x^2)\"\n[[claim]]\nid = \"L\"\n" + value +
        "says = \"Es*C/2*sqrt(a^2 - x^2)\"\n[[later]]\nfrom = \"C\"\nclaim = \"L\"\n"
        "words = \"the pressure\"\nsays = \"printed\"\n");
    const std::vector<Erratum> errata = errata_of(result, {});
    REQUIRE(errata.size() == 2);
    CHECK(errata[0].weight == Weight::slip);
    CHECK(errata[0].parts.front()->claim.id == "C");
    CHECK(errata[1].weight == Weight::line);
    CHECK(errata_count(errata) ==
          "2 errors found. 1 is a misprint; what rests on the other formula is not stated.");
}
