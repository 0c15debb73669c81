// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace edgeproof::contact {

/// Estimates of the stresses in a body of an axisymmetric contact, for pictures: h' is a straight
/// line between radii, and the integrals of docs/axisymmetric.md, "Inside the body", have closed
/// forms over each line.
class RevolutionEstimate {
public:
    struct Node {
        double s;    ///< radius (length), ascending; twice where h' jumps
        double rate; ///< h'(s)
    };
    /// @param nodes from the axis, or from the end of a flat, to the edge
    /// @param modulus E* (stress)
    /// @param poisson Poisson's ratio of the body
    RevolutionEstimate(std::vector<Node> nodes, double modulus, double poisson);

    struct State {
        double sxx; ///< radial
        double szz;
        double sxz;
        double across; ///< hoop
    };
    /// At the place x and the depth z > 0 (lengths).
    [[nodiscard]] State at(double x, double z) const;

private:
    std::vector<Node> nodes_;
    double scale_; ///< E*/pi
    double poisson_;
};

} // namespace edgeproof::contact
