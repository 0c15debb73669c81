// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"

#include <fmt/format.h>

#include <string_view>

namespace edgeproof::certificate {
namespace {

// The bracket for which Uniform.v has a bound for all sigma at once, before its approximation is
// subtracted.
constexpr std::string_view bracket = "(-b+eps+bof(a+(binv(b-eps)-a)*sigma))/(eps*(1-sigma))";
constexpr std::string_view bracket_in_coq =
    "(- b a + eps + b (a + (alpha (b a - eps) - a) * sigma)) / (eps * (1 - sigma))";

} // namespace

// States the refutation of "breaks down as sigma -> 1" at every contact: the remainder divided by
// eps^2 has a bound that is the same for all sigma.
void certify_uniformity(const audit::ClaimResult& result, const audit::Ledger& ledger,
                        Certificate& certificate) {
    const audit::Claim& claim = result.claim;
    if (result.outcome.verdict != audit::Verdict::refuted || claim.text("of") != bracket ||
        claim.text("small") != "eps" || claim.integer("order") != 2 ||
        claim.text("variable") != "sigma" || claim.text("towards") != "1") {
        throw NotStated(
            "the Coq files have no bound of such an expansion for all values of its variable");
    }
    Theory theory = smooth_contact(false);
    theory.imports.insert(theory.imports.end(), {"Expansions", "Uniform"});
    for (const char* name : {"eps", "sigma"}) {
        theory.names.emplace(name, name);
    }
    const std::string name = coq_name(claim.id) + "_refuted";
    certificate.text =
        file_head(claim, ledger, theory) +
        fmt::format(
            "Theorem {0} (Es : R) (g1 : R -> R) (a : R) (P P1 P2 P3 b b1 b2 b3 alpha : R -> R) :\n"
            "  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->\n"
            "  is_left_edge a b b1 b2 b3 alpha ->\n"
            "  exists M d : R, 0 < d /\\ forall eps sigma, 0 < eps < d -> 0 < sigma < 1 ->\n"
            "  Rabs ({1}\n    - ({2})) <= M * eps ^ 2.\nProof.\n"
            "  exact (bracket_uniform Es g1 a P P1 P2 P3 b b1 b2 b3 alpha).\nQed.\n",
            name, bracket_in_coq, coq_text(claim.formula("approximation"), theory.names));
    certificate.theorems = {
        {name, "for all contacts, what is left is at most M eps^2, for all sigma between 0 and 1"}};
    certificate.whole_verdict = true;
    certificate.leaves_out = std::string(smoothness);
}

} // namespace edgeproof::certificate
