// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/statement.hpp"

#include <fmt/format.h>

namespace edgeproof::certificate {

// States the refutation of "grows with the exponent m" for power laws, under every reading, by two
// of them: the quantity is larger for a wedge, m = 0, than for a parabola, m = 1.
void certify_monotone(const audit::ClaimResult& result, const audit::Ledger& ledger,
                      Certificate& certificate) {
    const audit::Claim& claim = result.claim;
    const bool power_laws =
        profiles_of(ledger, claim.text("over")) == std::vector<std::string>{"power-law"};
    const bool refuted = result.outcome.verdict == audit::Verdict::refuted;
    if (refuted && power_laws && claim.text("along") != "m") {
        throw NotStated("of power laws the Coq files have the pressures of the wedge and the "
                        "parabola alone, and no counterexample of them");
    }
    if (!refuted || claim.text("along") != "m" || claim.text("sense") != "increasing" ||
        !power_laws) {
        throw NotStated("of what grows, only that it does not grow with the exponent of power laws "
                        "is stated");
    }
    const SampledTheory wedge = power_law_contact(0, "");
    const SampledTheory parabola = power_law_contact(1, "'");
    Statement of_wedge(wedge.theory);
    Statement of_parabola(parabola.theory);
    std::string conclusion;
    const auto add = [&](const formula::Expr& e) {
        const auto least = excess(e, wedge.sample, e, parabola.sample);
        if (!least) {
            throw NotStated("a wedge and a parabola are not a counterexample");
        }
        conclusion += fmt::format("{}{} <= ({}) - ({})", conclusion.empty() ? "" : " /\\\n  ",
                                  fraction_below(*least), of_wedge(e), of_parabola(e));
    };
    if (claim.readings.empty()) {
        add(claim.formula("of"));
    }
    for (const audit::Claim& reading : claim.readings) {
        add(reading.formula("of"));
    }
    const std::string name = coq_name(claim.id) + "_refuted";
    std::string inner = of_parabola.proof("repeat split; numbers constants");
    inner.erase(inner.rfind('.')); // of_wedge.proof adds the final dot
    Theory both = wedge.theory;
    both.constants.push_back(parabola.theory.constants.back());
    certificate.text =
        file_head(claim, ledger, both) + constants(both.constants) +
        theorem_text(name, of_wedge.text(of_parabola.text(conclusion)), of_wedge.proof(inner));
    certificate.theorems = {{name, "it is larger of a wedge, m = 0, than of a parabola, m = 1"}};
    certificate.whole_verdict = true;
    certificate.leaves_out = "all other exponents";
}

} // namespace edgeproof::certificate
