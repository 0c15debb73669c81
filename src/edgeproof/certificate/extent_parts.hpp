// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/certificate/stated_contact.hpp"

#include <string>

namespace edgeproof::certificate {

/// Returns the inequality that a share does not round to the figure that the claim quotes. `lower`
/// and `upper` are bounds of the share, in Coq.
[[nodiscard]] std::string not_rounded_to(const audit::Claim& claim, double share,
                                         const std::string& lower, const std::string& upper);

/// The share of a side, or of the whole contact, that an audit computed for one wedge.
struct WedgeShare {
    const audit::Claim& claim; ///< the reading
    double share = 0;
    const StatedEdge& edge;
    double gam = 0; ///< b/a
    const ExtentStatement& extent;
};

/// Adds the theorem `name`: the measure of all places within the tolerance, as a share of the left
/// side of a tilted wedge, does not round to the figure. It states that the terms are beyond the
/// tolerance everywhere except up to the first exit and in one interval on the other side of the
/// apex, whose length is added. Throws NotStated at a right edge, for gam > 2/5, a tolerance above
/// 1/10, or a share above the figure.
void certify_measure(const std::string& name, const WedgeShare& judged, Certificate& certificate);

} // namespace edgeproof::certificate
