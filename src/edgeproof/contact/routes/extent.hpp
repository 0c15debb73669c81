// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/load.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::contact {

/// The places where the n-term approximation at an edge is within a tolerance of the pressure:
/// |1 - p_local(u)/p(u)| < tolerance (moore-hills EQ15; docs/extents.md, "Sampled"). All distances
/// are u from this edge, in the unit of length.
///
/// Each crossing is refined to the digits of the contact, with the relative error `estimate`. That
/// there are no others is *sampled*, not proved: at several hundred points, geometric towards both
/// edges and both sides of every knot, with a search for the extrema between them. At a corner of
/// the profile p is infinite, so that the approximation is outside every tolerance below 1 there.
struct Extents {
    Real first_exit; ///< the first u of the range at which the tolerance is reached
    Real measure;    ///< total length within the tolerance, over the whole range
    std::vector<Real> crossings;
    bool leaves = true; ///< false: all within the tolerance; first_exit is the range's end
    Real length;        ///< a + b
    Real range_from;
    Real range_to;
    Real estimate;             ///< estimated relative error of the least accurate crossing
    std::size_t samples = 0;   ///< number of points of the scan
    std::size_t pressures = 0; ///< number of pressures computed by the scan and the refinement
};

/// `tolerance` is relative (dimensionless), `range` in fractions of the contact's length. Throws
/// InputError for a tolerance <= 0, n = 0, or a range that is not 0 <= from < to <= 1.
[[nodiscard]] Extents within_tolerance(const NormalContact& contact, Edge edge, std::size_t n,
                                       const formula::Exact& tolerance,
                                       const ExtentRange& range = {});

} // namespace edgeproof::contact
