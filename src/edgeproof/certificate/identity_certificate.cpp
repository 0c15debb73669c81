// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/statement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace edgeproof::certificate {
namespace {

bool is_symmetric(const std::vector<std::string>& profiles) {
    return std::all_of(profiles.begin(), profiles.end(), [](const std::string& profile) {
        return profile.find("tilted") == std::string::npos && profile != "piecewise";
    });
}

} // namespace

// For all contacts: the coefficients exist, and the printed formula is what is said of them.
void certify_identity(const audit::ClaimResult& result, const audit::Ledger& ledger,
                      Certificate& certificate) {
    const audit::Claim& claim = result.claim;
    if (result.outcome.verdict != audit::Verdict::proved) {
        throw NotStated("only identities that are proved are stated");
    }
    if (claim.has("given")) {
        throw NotStated("an assumption on the load is not stated in Coq");
    }
    const bool symmetric = is_symmetric(profiles_of(ledger, claim.text("over")));
    const Theory theory = smooth_contact(symmetric);
    Statement statement(theory);
    const std::string printed = statement(claim.formula("says"));
    const std::string exact = statement(claim.formula("of"));
    const std::string name = coq_name(claim.id);
    const std::string contact =
        symmetric
            ? "(P P1 P2 P3 : R -> R) :\n"
              "  is_smooth_contact Es g1 a P P1 P2 P3 (fun s => s) (fun _ => 1) (fun _ => 0) ->\n"
            : "(P P1 P2 P3 b b1 b2 b3 alpha : R -> R) :\n"
              "  is_smooth_contact Es g1 a P P1 P2 P3 b b1 b2 ->\n"
              "  is_left_edge a b b1 b2 b3 alpha ->\n";
    certificate.text =
        file_head(claim, ledger, theory) +
        fmt::format("Theorem {0} (Es : R) (g1 : R -> R) (a : R) {1}  {2}.\nProof.\n  intros "
                    "contact{3}.\n{4}Qed.\nPrint Assumptions {0}.\n",
                    name, contact, statement.text(printed + " =\n  " + exact),
                    symmetric ? "" : " left",
                    statement.proof(symmetric ? "identity_symmetric contact a P1 P2 P3"
                                              : "identity contact left a b b1"));
    certificate.theorems = {{name, symmetric ? "for all symmetric contacts, printed = derived"
                                             : "for all contacts, printed = derived"}};
    certificate.leaves_out = "the load and the left edge are taken to be smooth functions of the "
                             "right edge, as the expansion needs";
}

} // namespace edgeproof::certificate
