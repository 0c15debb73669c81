// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/complex_box.hpp"

namespace edgeproof::audit {

/// The contacts of a tilted flat and rounded punch whose left edge is beyond the right arc. Each is
/// given by an angle in which all quantities are analytic, although they are not analytic in the
/// right edge s. With the middle c, the half-length d, and v = c + d cos h for a point, the right
/// end of the flat is at h = pi - eta, and its left end, if the contact reaches it, is at
/// h = pi - kappa. With r := R alpha,
///     s = d (1 + cos eta) - r,   b(s) = d (1 - cos eta) + r,
///     P'(s) = (E* d/2R)(sin eta + pi - eta + kappa - sin kappa),
/// and moore-hills.tex eqn:Consistency becomes
///     on the flat (kappa = 0):   d (sin eta + (pi - eta) cos eta) = pi r,
///     on the left arc:           d (cos kappa - cos eta) = 2 t, and
///         sin eta + (pi - eta) cos eta - sin kappa + kappa cos kappa = mu (cos kappa - cos eta),
/// mu = pi r/(2 t), whose eta is enclosed by the interval form of Newton's method.
class TiltedPath {
public:
    enum class LeftEdge { on_flat, on_left_arc };

    /// The angle is eta on the flat and kappa on the left arc. Both increase with s from 0; the
    /// left arc begins where eta is end_of_flat().
    TiltedPath(LeftEdge left_edge, const Ball& r, const Ball& t, const Ball& R,
               const Ball& modulus);

    struct Point {
        Box s;
        Box b;
        Box rate; ///< P'
        Box ds;   ///< by the angle
        Box db;
    };
    /// For every angle in the box, which must meet the real axis; not finite without an enclosure.
    [[nodiscard]] Point at(const Box& angle) const;
    [[nodiscard]] Ball end_of_flat() const;
    /// Returns the angle of the contact with these edges, in this part of the path.
    [[nodiscard]] Ball angle_of(const Ball& a, const Ball& b) const;

private:
    [[nodiscard]] Box eta_at(const Box& kappa) const;
    LeftEdge left_edge_;
    Ball r_;
    Ball t_;
    Ball mu_;
    Ball rate_; ///< E*/(2R)
    Ball pi_;
};

} // namespace edgeproof::audit
