// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/statement.hpp"

#include <fmt/format.h>

namespace edgeproof::certificate {

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
    for (const audit::SceneSpec& scene : scenes) {
        if (scene.parameter("m") != m) {
            throw NotStated("the figure is for several exponents");
        }
    }
    const SampledTheory contact = power_law_contact(m.rational() == 0 ? 0 : 1, "",
                                                    Rational(1 - 2 * family.u.front().rational()));
    const audit::QuotedFigure figure = audit::QuotedFigure::of(claim);
    const Rational half = figure.within_units(Rational(1, 2)).second - figure.value();
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
    certificate.leaves_out = "that it is the same at every scale";
}

} // namespace edgeproof::certificate
