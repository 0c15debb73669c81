// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/theory/statement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace edgeproof::certificate {
namespace {

/// Returns the exponent q of a load given as c a^q, where c does not depend on a.
Rational exponent_of_load(const audit::Claim& claim) {
    const formula::Expr& load = claim.formulas("given").front();
    const bool is_power =
        claim.table("given").size() == 1 && claim.table("given").front().first == "P" &&
        load.kind() == formula::Expr::Kind::mul && load.arg(1).kind() == formula::Expr::Kind::pow &&
        load.arg(1).arg(0) == formula::Expr::symbol("a") &&
        !free_symbols(load.arg(0)).contains("a");
    if (!is_power || load.arg(1).arg(1).rational() == nullptr) {
        throw NotStated(
            "the only assumption that is stated is a load proportional to a power of a");
    }
    return *load.arg(1).arg(1).rational();
}

/// Whether all contacts of the family are of the power law whose load has this exponent.
bool are_of_power_law(const audit::Claim& claim, const audit::Ledger& ledger,
                      const Rational& exponent) {
    const auto scenes = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    return exponent >= 1 && std::all_of(scenes.begin(), scenes.end(), [&](const auto& scene) {
               return scene.profile == "power-law" && scene.parameter("m").is_rational() &&
                      scene.parameter("m").rational() == exponent - 1 &&
                      scene.parameter("C").sign() > 0;
           });
}

/// Returns the theorem that the punch of the power law has such a load, and therefore the same.
std::string derived_theorem(const std::string& name, const Rational& exponent,
                            const std::string& statement) {
    return fmt::format(
        "(* The punch |x|^m has such a load. *)\n"
        "Theorem {0}_derived (Es C a : R) : 0 < C /\\ 0 < a ->\n  {1}.\nProof.\n"
        "  intros form. apply ({0} Es (power_slope C {2}) a (PowerLaw.power_load Es C {2}) "
        "(power_load_1 Es C {2})\n    (power_load_2 Es C {2}) (power_load_3 Es C {2}) 0 "
        "(Es * C * wallis ({2} + 1))).\n"
        "  - apply power_smooth_contact; lra.\n"
        "  - intros s Hs. unfold PowerLaw.power_load. do 2 f_equal. field.\n"
        "  - split; [apply power_slope_rises; lra | lra].\nQed.\n",
        name, statement, coq_number(Rational(exponent - 1)));
}

/// Returns the coefficient for which the ledger has the other side of the identity as a formula, in
/// an identity of its own; no value if this claim is about a coefficient itself.
std::optional<formula::Expr> coefficient_meant(const audit::Claim& claim,
                                               const audit::Ledger& ledger) {
    for (const audit::Claim& other : ledger.claims) {
        if (other.kind == "identity" && !other.has("given") && other.has("over") &&
            other.text("over") == claim.text("over") &&
            other.formula("says") == claim.formula("of")) {
            for (const char* name : {"right_c0", "right_c1", "right_c2"}) {
                if (other.formula("of") == formula::Expr::symbol(name)) {
                    return other.formula("of");
                }
            }
        }
    }
    return std::nullopt;
}

} // namespace

// States, for all contacts, that the coefficients exist and that the printed formula gives them.
void certify_identity(const audit::ClaimResult& result, const audit::Ledger& ledger,
                      Certificate& certificate) {
    const audit::Claim& claim = result.claim;
    if (result.outcome.verdict != audit::Verdict::proved) {
        throw NotStated("only identities that are proved are stated");
    }
    const bool symmetric = is_symmetric(profiles_of(ledger, claim.text("over")));
    const bool given = claim.has("given");
    if (given && !symmetric) {
        throw NotStated("an assumption on the load is stated for symmetric contacts only");
    }
    if (is_same_for_all(claim.formula("says"), claim.formula("of"), claim.edge())) {
        throw NotStated("both sides are the same, whatever the coefficients are: a theorem would "
                        "contain no mechanics");
    }
    Theory theory = smooth_contact(symmetric);
    if (given) {
        theory.imports.insert(theory.imports.end(), {"Gamma", "PowerLaw"});
    }
    const bool at_x = free_symbols(claim.formula("says")).contains("x");
    if (at_x) {
        theory.names.emplace("x", "x");
    }
    Statement statement(theory);
    const std::string printed = statement(claim.formula("says"));
    std::string exact = statement(claim.formula("of"));
    const auto meant =
        symmetric && !given && !at_x ? coefficient_meant(claim, ledger) : std::nullopt;
    if (meant) {
        exact = fmt::format("{0} /\\\n  {0} =\n  {1}", exact, statement(*meant));
    }
    const std::string name = coq_name(claim.id);
    const std::string load =
        given ? fmt::format("  (forall s, 0 < s -> P s = factor * Rpower s {}) ->\n",
                            coq_number(exponent_of_load(claim)))
              : "";
    const std::string contact = (symmetric ? "(P P1 P2 P3 : R -> R) (y" +
                                                 std::string(given ? " factor" : "") + " : R) :\n" +
                                                 "  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => "
                                                 "s) (fun _ => 1) (fun _ => 0) ->\n"
                                           : "(P P1 P2 P3 b b1 b2 b3 alpha : R -> R) (y z : R) :\n"
                                             "  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->\n"
                                             "  is_left_edge a b b1 b2 b3 alpha ->\n") +
                                load + convex_hypothesis(symmetric);
    certificate.text =
        file_head(claim, ledger, theory) +
        fmt::format(
            "Theorem {0} (Es : R) (g1 : R -> R) (a : R) {1}  {2}.\nProof.\n  intros "
            "contact{3}.\n{4}Qed.\n",
            name, contact,
            statement.text((at_x ? "forall x, x < a ->\n  " : "") + printed + " =\n  " + exact),
            given       ? " load convex"
            : symmetric ? " convex"
                        : " left convex",
            statement.proof((at_x    ? "intros x Hx. "
                             : meant ? "split; "
                                     : "") +
                            std::string(given       ? "identity_of_power contact load a P1 P2 P3"
                                        : symmetric ? "identity_symmetric contact a P1 P2 P3"
                                                    : "identity contact left a b b1")));
    certificate.theorems = {
        {name, given
                   ? "for all symmetric contacts of such a load, with any factor, printed = derived"
               : meant     ? "for all symmetric contacts, both formulas are the coefficient"
               : symmetric ? "for all symmetric contacts, printed = derived"
                           : "for all contacts, printed = derived"}};
    if (given && are_of_power_law(claim, ledger, exponent_of_load(claim))) {
        const Rational exponent = exponent_of_load(claim);
        std::string of_punch =
            statement.text((at_x ? "forall x, x < a ->\n  " : "") + printed + " =\n  " + exact);
        for (std::size_t at = of_punch.find(" g1 "); at != std::string::npos;
             at = of_punch.find(" g1 ")) {
            of_punch.replace(
                at, 4, fmt::format(" (power_slope C {}) ", coq_number(Rational(exponent - 1))));
        }
        certificate.text += "\n" + derived_theorem(name, exponent, of_punch);
        certificate.theorems.push_back(
            {name + "_derived", "the same of every punch |x|^(m+1), whose load is derived"});
    }
    certificate.whole_verdict = true;
    certificate.leaves_out = "the punch is taken to be convex; " + std::string(smoothness);
}

} // namespace edgeproof::certificate
