// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/sampled_statement.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <variant>

namespace edgeproof::certificate {
namespace {

/// A function of eps whose Taylor polynomial Expansions.v derives.
struct Expanded {
    std::string_view of;    ///< as a ledger writes it
    std::string_view exact; ///< in Coq
    std::string_view lemma;
    long order;
    bool symmetric;
    std::string_view variables;
};

constexpr std::array<Expanded, 3> expanded{
    {{"P1of(a-eps*S)/sqrt(1-eps*(X+S)/(2*a))",
      "P1 (a - eps * S) / sqrt (1 - eps * (X + S) / (2 * a))",
      "integrand_through_2 _ _ _ _ _ _ _ S X contact", 2, true, "S X"},
     {"binv(b-eps*X)-a", "alpha ((b a) - eps * X) - a",
      "inverse_through_3 _ _ _ _ _ _ _ _ _ _ _ _ contact left X", 3, false, "X"},
     {"P1of(a+(binv(b-eps*X)-a)*sigma)/Pi", "P1 (a + (alpha ((b a) - eps * X) - a) * sigma) / PI",
      "rate_through_2 _ _ _ _ _ _ _ _ _ _ _ _ contact left X sigma", 2, false, "X sigma"}}};

const Expanded& expanded_of(const audit::Claim& claim) {
    for (const Expanded& e : expanded) {
        if (claim.text("of") == e.of && claim.text("through") == std::to_string(e.order)) {
            return e;
        }
    }
    throw NotStated(fmt::format("Expansions.v derives no expansion of {}", claim.text("of")));
}

/// The printed and the derived coefficient of each power from 0 on, as the audit found them;
/// nothing rests on them but the proof that is proposed.
struct Coefficients {
    std::vector<std::string> printed;
    std::vector<std::string> derived;
    std::optional<std::size_t> departs;
};

class Words {
public:
    Words(const audit::Claim& claim, const Expanded& e)
        : claim_(claim), names_(smooth_contact(e.symmetric).names) {
        for (const char* name : {"eps", "X", "S", "sigma"}) {
            names_.emplace(name, name);
        }
    }
    [[nodiscard]] std::string operator()(const formula::Expr& e) const {
        return coq_text(e, names_);
    }
    [[nodiscard]] std::string operator()(const std::string& text) const {
        return coq_text(
            expand_definitions(parse_formula(text, claim_.vocabulary), claim_.vocabulary), names_);
    }

private:
    const audit::Claim& claim_;
    CoqNames names_;
};

std::string text_at(const audit::Evidence& term, std::string_view key) {
    const audit::EvidenceItem* const item = term.find(key);
    return item == nullptr ? std::string() : item->text();
}

Coefficients coefficients_of(const audit::ClaimResult& result, long order, const Words& words) {
    const audit::EvidenceItem* const item = result.outcome.evidence.find("terms");
    const auto* const terms =
        item == nullptr ? nullptr : std::get_if<std::vector<audit::EvidenceItem>>(&item->value());
    if (terms == nullptr) {
        throw NotStated("the coefficients of the expansion were not found");
    }
    Coefficients all;
    all.printed.assign(static_cast<std::size_t>(order) + 1, "0");
    all.derived = all.printed;
    for (const audit::EvidenceItem& entry : *terms) {
        const auto& term = std::get<audit::Evidence>(entry.value());
        for (std::size_t k = 0; k < all.printed.size(); ++k) {
            if (text_at(term, "power") != fmt::format("eps^({})", k)) {
                continue;
            }
            const std::string both = text_at(term, "both");
            all.printed[k] = words(both.empty() ? text_at(term, "printed") : both);
            all.derived[k] = words(both.empty() ? text_at(term, "derived") : both);
            if (both.empty() && !all.departs) {
                all.departs = k;
            }
        }
    }
    return all;
}

std::string hypotheses(const Expanded& e) {
    return e.symmetric ? "(Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 : R -> R) :\n"
                         "  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ "
                         "=> 0) ->\n"
                       : "(Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) :\n"
                         "  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->\n"
                         "  is_left_edge a b b1 b2 b3 alpha ->\n";
}

std::string agreement_text(const Expanded& e, const std::string& with) {
    return fmt::format("agrees_through {} (fun eps => {})\n    (fun eps => {})", e.order, e.exact,
                       with);
}

std::string begin_of_proof(const Expanded& e, std::string_view more) {
    return fmt::format("  intros contact {}{}{}.\n  {}.\n  pose proof ({}) as derived.\n",
                       e.symmetric ? "" : "left ", e.variables, more,
                       e.symmetric ? "symmetric_facts contact" : "edge_facts contact left",
                       e.lemma);
}

std::string agrees_theorem(const std::string& name, const Expanded& e, const std::string& with) {
    return fmt::format("Theorem {0} {1}  forall {2} : R,\n  {3}.\nProof.\n{4}"
                       "  apply (agrees_ext _ _ _ _ derived). intros u. field; repeat split; lra.\n"
                       "Qed.\nPrint Assumptions {0}.\n\n",
                       name, hypotheses(e), e.variables, agreement_text(e, with),
                       begin_of_proof(e, ""));
}

std::string refuted_theorem(const std::string& name, const Expanded& e, const std::string& printed,
                            const Coefficients& all) {
    std::string polynomial;
    std::string equal;
    for (std::size_t k = 0; k < all.printed.size(); ++k) {
        polynomial += k == 0 ? fmt::format("({})", all.printed[k])
                             : fmt::format(" + ({}) * u{}", all.printed[k],
                                           k == 1 ? "" : fmt::format(" ^ {}", k));
        equal += fmt::format("{}E{}", k == 0 ? "" : " & ", k);
    }
    const std::size_t k = *all.departs;
    std::string unknown;
    for (std::size_t i = 0; i < 2 * all.printed.size() + 1; ++i) {
        unknown += " _";
    }
    return fmt::format(
        "Theorem {0} {1}  forall {2} : R,\n  ({3}) - ({4}) <> 0 ->\n  ~ {5}.\nProof.\n{6}"
        "  apply differ, Rminus_diag_eq.\n"
        "  assert (polynomial : agrees_through {7} (fun eps => {8}) (fun u => {9})).\n"
        "  {{ apply (agrees_ext _ _ _ _ printed). intros u. field; repeat split; lra. }}\n"
        "  destruct (unique_{7}{10} derived polynomial) as ({11}).\n"
        "  transitivity_of E{12}; field; repeat split; lra.\nQed.\nPrint Assumptions {0}.\n\n",
        name, hypotheses(e), e.variables, all.printed[k], all.derived[k],
        agreement_text(e, printed), begin_of_proof(e, " differ printed"), e.order, e.exact,
        polynomial, unknown, equal, k);
}

} // namespace

// Printed as f = T + O(eps^(n+1)): refuted, at every contact at which the first coefficients that
// differ do, f - T is not o(eps^n); proved or corrected, at every contact it is.
void certify_expansion(const audit::ClaimResult& result, const audit::Ledger& ledger,
                       Certificate& certificate) {
    const audit::Claim& claim = result.claim;
    const bool refuted = result.outcome.verdict == audit::Verdict::refuted;
    if (!refuted && result.outcome.verdict != audit::Verdict::proved) {
        throw NotStated("only expansions that are refuted or proved are stated");
    }
    const Expanded& e = expanded_of(claim);
    const Words words(claim, e);
    const std::string printed = words(claim.formula("says"));
    const std::string name = coq_name(claim.id);
    Theory theory;
    theory.imports = {"Contact", "Coefficients", "Edges", "Tactics", "Expansions"};
    certificate.text = file_head(claim, ledger, theory);
    certificate.leaves_out = "the load and the left edge are taken to be smooth functions of the "
                             "right edge; the remainder is o(eps^n), not O(eps^(n+1))";
    if (!refuted) {
        certificate.text += agrees_theorem(name, e, printed);
        certificate.theorems = {
            {name, fmt::format("for all contacts, printed = exact + o(eps^{})", e.order)}};
        certificate.whole_verdict = true;
        return;
    }
    const Coefficients all = coefficients_of(result, e.order, words);
    if (!all.departs) {
        throw NotStated("the coefficients agree");
    }
    certificate.text += refuted_theorem(name + "_refuted", e, printed, all);
    certificate.theorems = {
        {name + "_refuted",
         fmt::format("for all contacts at which the two coefficients of eps^{} differ, printed is "
                     "not exact + o(eps^{})",
                     *all.departs, e.order)}};
    if (result.outcome.correct) {
        certificate.text += agrees_theorem(name + "_corrected", e, words(*result.outcome.correct));
        certificate.theorems.push_back(
            {name + "_corrected",
             fmt::format("for all contacts, corrected = exact + o(eps^{})", e.order)});
    }
    certificate.leaves_out += "; that there are contacts at which the coefficients differ";
}

} // namespace edgeproof::certificate
