// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/load.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::contact {

/// Where the n-term approximation at an edge is within a tolerance of the pressure:
/// |1 - p_local(u)/p(u)| < tolerance. All distances are u from that edge, in units of length.
///
/// Each crossing is refined to the digits of the contact, `estimate` relative. That there are no
/// more of them is *sampled*, not proved: on several hundred points, geometric towards both edges
/// and both sides of every knot, with the extrema between them searched. At a corner of the profile
/// p is infinite, so the approximation is outside every tolerance below 1 there.
struct Extents {
    Real first_exit; ///< the first u of the range at which the tolerance is reached
    Real measure;    ///< length of the set within the tolerance, over the whole range
    std::vector<Real> crossings;
    bool leaves = true; ///< false: within the tolerance all over; first_exit is the range's end
    Real length;        ///< a + b
    Real range_from;
    Real range_to;
    Real estimate;             ///< relative error of the worst crossing, estimated
    std::size_t samples = 0;   ///< points of the scan
    std::size_t pressures = 0; ///< pressures computed, scan and refinement
};

/// Throws InputError for a tolerance <= 0, n = 0, or a range that is not 0 <= from < to <= 1.
[[nodiscard]] Extents within_tolerance(const NormalContact& contact, Edge edge, std::size_t n,
                                       const formula::Exact& tolerance,
                                       const ExtentRange& range = {});

} // namespace edgeproof::contact
