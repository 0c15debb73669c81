// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/statement.hpp"

#include <fmt/format.h>

namespace edgeproof::certificate {

namespace {

/// States the same for all contacts that are larger or smaller copies of the one of the theorem.
std::string similar_theorem(const std::string& name, bool wedge, const std::string& figure,
                            const std::string& half) {
    return fmt::format(
        "(* The same at every scale: for all slopes h1 that are scaled copies, and all moduli. *)\n"
        "Theorem {0}_similar : forall Fs lam mu h1, 0 < Fs -> 0 < lam -> 0 < mu ->\n"
        "  (forall x, h1 (lam * x) = mu * slope {1} x) ->\n"
        "  exists p0 r0 r1 r2, is_the_pressure Fs h1 (lam * a) (lam * x) p0 /\\\n"
        "  is_the_right_series Fs h1 (lam * a) r0 r1 r2 /\\\n"
        "  Rabs (Rabs (1 - r0 * ((lam * a - lam * x) ^ 0 * sqrt (lam * a - lam * x)) / p0) - {2}) "
        "< {3}.\nProof.\n"
        "  intros Fs lam mu h1 HFs Hlam Hmu Hh. destruct {0} as (p0 & r0 & r1 & r2 & Hp & Hr & "
        "H).\n"
        "  apply (figure_scaled Es Fs (slope {1}) h1 lam mu a x p0 r0 r1 r2 {2} {3}); try "
        "assumption; "
        "first [sides constants | lra].\nQed.\n",
        name, wedge ? "wedge" : "parabola", figure, half);
}

} // namespace

// States a confirmed figure that is quoted for one place of a wedge or a parabola: the exact value
// is less than half a unit of the last quoted digit away from the figure, so that there is no tie.
void certify_figure(const audit::ClaimResult& result, const audit::Ledger& ledger,
                    Certificate& certificate) {
    const audit::Claim& claim = result.claim;
    if (result.outcome.verdict != audit::Verdict::confirmed) {
        throw NotStated("only confirmed figures are stated");
    }
    const audit::Family& family = ledger.family(claim.text("over"));
    const auto scenes = draw_scenes(family, ledger.families);
    const bool power_law =
        profiles_of(ledger, claim.text("over")) == std::vector<std::string>{"power-law"};
    const formula::Exact m = power_law ? scenes.front().parameter("m") : formula::Exact();
    if (!power_law || !m.is_rational() || (m.rational() != 0 && m.rational() != 1) ||
        family.parameters.empty() || family.u.size() != 1 || !family.u.front().is_rational()) {
        throw NotStated("figures are stated of one place of a wedge or a parabola");
    }
    const bool relative_error = to_text(claim.formula("of")) == "abs(1 - right_local(1, x)/p(x))";
    for (const audit::SceneSpec& scene : scenes) {
        if (scene.parameter("m") != m) {
            throw NotStated("the figure is for several exponents");
        }
    }
    SampledTheory contact = power_law_contact(m.rational() == 0 ? 0 : 1, "",
                                              Rational(1 - 2 * family.u.front().rational()));
    const audit::QuotedFigure figure = audit::QuotedFigure::of(claim);
    const Rational half = figure.within_units(Rational(1, 2)).second - figure.value();
    contact.theory.imports.emplace_back("Scaling");
    Statement statement(contact.theory);
    const std::string conclusion =
        fmt::format("Rabs (({}) - {}) < {}", statement(claim.formula("of")),
                    coq_number(figure.value()), coq_number(half));
    const std::string name = coq_name(claim.id) + "_figure";
    certificate.text =
        file_head(claim, ledger, contact.theory) + constants(contact.theory.constants) +
        theorem_text(name, statement.text(conclusion), statement.proof("numbers constants"));
    certificate.theorems = {{name, fmt::format("at one contact it rounds to what is quoted, {}",
                                               claim.text("quoted"))}};
    certificate.whole_verdict =
        scenes.size() == 1 && scenes.front().parameters == contact.sample.scene.parameters;
    if (relative_error) {
        certificate.text +=
            similar_theorem(name, m.rational() == 0, coq_number(figure.value()), coq_number(half));
        certificate.theorems.push_back(
            {name + "_similar",
             "the same at every contact that is a larger or smaller copy, as all "
             "of the family are"});
        certificate.whole_verdict = true; // all scenes have this exponent and this place
        return;
    }
    certificate.leaves_out = "that it is the same at every scale";
}

} // namespace edgeproof::certificate
