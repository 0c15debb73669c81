// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/theory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace edgeproof::certificate {
namespace {

/// The exponent, two distances from the edge, a gap.
constexpr std::string_view falling_error = R"(Theorem {0} : exists p0 q0 r0 r1 r2,
  is_the_pressure 1 (power_slope 1 {1}) 1 (1 - {2}) p0 /\
  is_the_pressure 1 (power_slope 1 {1}) 1 (1 - {3}) q0 /\
  is_the_right_series 1 (power_slope 1 {1}) 1 r0 r1 r2 /\
  {4} <= Rabs (1 - r0 * sqrt {2} / p0) - Rabs (1 - r0 * sqrt {3} / q0).
Proof.
  destruct (power_ratios {1} {2} {3} ltac:(lra) ltac:(lra) ltac:(lra))
    as (p0 & q0 & r0 & r1 & r2 & Hp & Hq & Hr & E & F).
  exists p0, q0, r0, r1, r2. split; [exact Hp |]. split; [exact Hq |]. split; [exact Hr |].
  rewrite E, F. square_root_integrals. interval with (i_prec 60).
Qed.
)";

const Evidence& inner(const Evidence& evidence, std::string_view key) {
    const auto* const found = std::get_if<Evidence>(&item(evidence, key).value());
    if (found == nullptr) {
        throw NotStated("the audit computed no counterexample");
    }
    return *found;
}

Rational rational_item(const Evidence& evidence, std::string_view key) {
    const auto value = Exact::parse(item(evidence, key).text());
    if (!value.is_rational()) {
        throw NotStated("the counterexample is not at rational numbers");
    }
    return value.rational();
}

/// States the refutation of "the relative error of one term grows with the distance from the edge"
/// for power laws, by two places of one contact: the counterexample that the audit chose.
void certify_falling_error(const ClaimResult& result, const Ledger& ledger,
                           Certificate& certificate) {
    const Claim& claim = result.claim;
    const Evidence& counterexample = inner(result.outcome.evidence, "clearest");
    const Evidence& contact = inner(counterexample, "with");
    const Rational m = rational_item(contact, "m");
    const Rational u = rational_item(counterexample, "first_at");
    const Rational v = rational_item(counterexample, "second_at");
    const auto scenes = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    if (std::ranges::none_of(scenes, [&](const SceneSpec& scene) {
            return scene.parameter("m").is_rational() && scene.parameter("m").rational() == m;
        })) {
        throw NotStated("the counterexample has an exponent that the family does not have");
    }
    // The theorem is about the contact with Es = C = a = 1, in which u is a share of a.
    if (rational_item(contact, "a") != 1 || m < 0 || m > 100 || u <= 0 || v <= u || v >= 1) {
        throw NotStated("the counterexample is not of a contact with a = 1");
    }
    const Rational falls =
        rational_item(counterexample, "first") - rational_item(counterexample, "second");
    Theory theory;
    theory.imports = {"Contact", "Unique", "Tactics", "PowerLaw", "PowerError"};
    const std::string name = coq_name(claim.id) + "_refuted";
    certificate.text =
        file_head(claim, ledger, theory) +
        fmt::format(fmt::runtime(falling_error), name, coq_number(m), coq_number(u), coq_number(v),
                    fraction_below(0.999 * static_cast<double>(falls)));
    certificate.theorems = {
        {name, fmt::format("for m = {} it is smaller at the distance {} a than at {} a",
                           item(contact, "m").text(), item(counterexample, "second_at").text(),
                           item(counterexample, "first_at").text())}};
    certificate.whole_verdict = true;
    certificate.leaves_out = "all other exponents";
}

} // namespace

// States the refutation of "grows with the exponent m" for power laws, under every reading, by two
// of them: the quantity is larger for a wedge, m = 0, than for a parabola, m = 1. Of what grows
// with the distance from the edge, the relative error of one term is stated.
void certify_monotone(const ClaimResult& result, const Ledger& ledger, Certificate& certificate) {
    const Claim& claim = result.claim;
    const bool power_laws =
        profiles_of(ledger, claim.text("over")) == std::vector<std::string>{"power-law"};
    const bool refuted = result.outcome.verdict == Verdict::refuted;
    if (refuted && power_laws && claim.readings.empty() && claim.text("along") == "s" &&
        claim.text("sense") == "increasing" && claim.edge() == Edge::right &&
        is_formula(claim, "of", "abs(1 - right_local(1, a-s)/p(a-s))")) {
        certify_falling_error(result, ledger, certificate);
        return;
    }
    if (!refuted || claim.text("along") != "m" || claim.text("sense") != "increasing" ||
        !power_laws) {
        throw NotStated(
            "of what grows, only that it does not grow with the exponent of power laws, "
            "or that the error of one term does not with the distance, is stated");
    }
    const SampledTheory wedge = power_law_contact(0, "");
    const SampledTheory parabola = power_law_contact(1, "'");
    Statement of_wedge(wedge.theory);
    Statement of_parabola(parabola.theory);
    std::string conclusion;
    const auto add = [&](const Expr& e) {
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
    for (const Claim& reading : claim.readings) {
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
