// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/statement.hpp"

#include <fmt/format.h>

#include <map>

namespace edgeproof::certificate {
namespace {

/// Ends of the extent, in 1/10000 of the contact's half-width, from the computed percentage.
struct Ends {
    long within; ///< the n terms stay within the tolerance up to here
    long beyond; ///< and leave it here
};

/// From "49.237 %": the figure as it is computed, cut after its last digit.
Ends ends_of(const std::string& computed) {
    const double share = std::stod(computed);
    const auto cut = static_cast<long>(share * 100);
    return {cut, cut + 1};
}

} // namespace

// |p - local sum| <= tolerance p up to one distance from the edge, and not at another just beyond:
// the first exit lies between. For parabolas, whose pressure has a closed form without integrals.
void certify_extent(const audit::ClaimResult& result, const audit::Ledger& ledger,
                    Certificate& certificate) {
    const audit::Claim& claim = result.claim;
    if (claim.text("over") != "hertz" || claim.text_or("reach", "") != "first-exit" ||
        claim.text("base") != "a" || !result.outcome.computed || !claim.readings.empty()) {
        throw NotStated("extents are stated of parabolas alone");
    }
    const long terms = claim.integer("terms");
    if (terms > 3) {
        throw NotStated("extents are stated of up to three terms");
    }
    Theory theory;
    theory.imports = {"Contact", "Coefficients", "Edges", "Tactics", "Hertz"};
    const Ends ends = ends_of(*result.outcome.computed);
    const std::string tolerance =
        coq_number(formula::Exact::parse(claim.text("tolerance")).rational());
    static const char* const sums[] = {"r0 * sqrt u", "r0 * sqrt u + r1 * (u * sqrt u)",
                                       "r0 * sqrt u + r1 * (u * sqrt u) + r2 * (u ^ 2 * sqrt u)"};
    const std::string name = coq_name(claim.id) + "_extent";
    certificate.text =
        file_head(claim, ledger, theory) +
        fmt::format(
            "(* Of a parabola with Es = C = a = 1, up to {0}/10000 of the half-width from the "
            "edge, "
            "and not at {1}/10000. *)\n"
            "Theorem {2} : exists r0 r1 r2,\n"
            "  right_edge_series 1 (slope 1) 1 r0 r1 r2 /\\\n"
            "  (forall u, 0 < u <= {0} / 10000 -> exists p0, is_pressure 1 (slope 1) 1 (1 - u) p0 "
            "/\\\n"
            "    Rabs (p0 - ({3})) <= {4} * p0) /\\\n"
            "  (forall u, u = {1} / 10000 -> exists p0, is_pressure 1 (slope 1) 1 (1 - u) p0 /\\\n"
            "    {4} * p0 < Rabs (p0 - ({3}))).\n"
            "Proof.\n  extent_of_parabola.\nQed.\nPrint Assumptions {2}.\n",
            ends.within, ends.beyond, name, sums[terms - 1], tolerance);
    certificate.theorems = {
        {name, fmt::format(
                   "{} terms stay within {} up to {}/10000 of the half-width, and not at {}/10000",
                   terms, claim.text("tolerance"), ends.within, ends.beyond)}};
    certificate.whole_verdict = true;
    certificate.leaves_out = "that the extent in shares of a is the same for every parabola";
}

} // namespace edgeproof::certificate
