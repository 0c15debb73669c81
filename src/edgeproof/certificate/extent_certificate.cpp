// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/certificate/stated_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace edgeproof::certificate {
namespace {

/// Returns a scene of the family whose right edge is at 1, because it is easy to read, or else the
/// first scene.
audit::SceneSpec scene_of(const audit::Ledger& ledger, const audit::Claim& claim) {
    const auto all = draw_scenes(ledger.family(claim.text("over")), ledger.families);
    const auto plain = std::find_if(all.begin(), all.end(), [](const audit::SceneSpec& scene) {
        return scene.parameter("a").to<double>() == 1;
    });
    return plain == all.end() ? all.front() : *plain;
}

} // namespace

// States that |p - local sum| <= tolerance p up to one distance from the edge, and not at another
// just beyond it: the first exit lies between them.
void certify_extent(const audit::ClaimResult& result, const audit::Ledger& ledger,
                    Certificate& certificate) {
    const audit::Claim& claim = result.claim;
    if (claim.text_or("reach", "") != "first-exit" || !result.outcome.computed) {
        throw NotStated("only first exits of extents are stated");
    }
    const audit::SceneSpec scene = scene_of(ledger, claim);
    const StatedContact contact =
        stated_contact(scene.make_profile(), scene.parameter("a"), scene.parameter("Es"));
    const StatedEdge& edge = contact.at(claim.edge());
    const std::string& base = claim.text("base");
    if (base != (claim.edge() == contact::Edge::right ? "a" : "b")) {
        throw NotStated(fmt::format("extents are stated in shares of the edge's distance from the "
                                    "origin, not of {}",
                                    base));
    }
    // The computed value is a rounded figure such as "49.237 %": take whole hundredths of a percent
    // that are certainly below and above the exact value.
    const double hundredths = std::stod(*result.outcome.computed) * 100;
    const auto cut = static_cast<long>(std::floor(hundredths - 0.1));
    const auto top = static_cast<long>(std::ceil(hundredths + 0.1));
    const double unit = edge.distance / 10000;
    const ExtentStatement extent{
        static_cast<std::size_t>(claim.integer("terms")),
        formula::Exact::parse(claim.text("tolerance")),
        coq_decimal(static_cast<double>(cut) * unit * (1 + 1e-6), 8, true),
        coq_decimal(static_cast<double>(top) * unit * (1 - 1e-6), 8, false), ""};
    ExtentStatement shares = extent;
    shares.more = fmt::format("({} / 10000 <= ({}) / {} /\\ ({}) / {} <= {} / 10000)", cut,
                              extent.within.text, edge.edge, extent.beyond.text, edge.edge, top);
    const std::string name = coq_name(claim.id) + "_extent";
    certificate.text =
        contact.head(file_comment(claim, ledger)) + extent_theorem(name, edge, shares);
    certificate.theorems = {
        {name, fmt::format("{} terms stay within {} up to a distance of at least {}/10000 of {}, "
                           "and not at one of at most {}/10000",
                           extent.terms, claim.text("tolerance"), cut, base, top)}};
    certificate.whole_verdict = claim.readings.empty();
    certificate.leaves_out = "that the share is the same at every scale";
    if (!claim.readings.empty()) {
        certificate.leaves_out += "; what else the words may mean";
    }
}

} // namespace edgeproof::certificate
