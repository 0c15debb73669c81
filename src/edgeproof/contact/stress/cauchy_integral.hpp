// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"

#include <array>

/// The Cauchy integrals of the tractions of a contact, from which all stresses follow
/// (docs/stress.md, "The Cauchy integrals").
namespace edgeproof::contact {

/// T(zeta) = integral of t(s)/(zeta - s) ds over the contact, for a traction t (stress) and a place
/// zeta = x + i z at the depth z >= 0 (length). On the surface it is the limit from z > 0.
struct CauchyIntegral {
    Box value;      ///< stress
    Box derivative; ///< dT/dzeta (stress/length); not finite at an edge or at a corner

    friend CauchyIntegral operator-(CauchyIntegral x, const CauchyIntegral& y) {
        return {std::move(x.value) - y.value, std::move(x.derivative) - y.derivative};
    }
    friend CauchyIntegral operator*(CauchyIntegral x, const Ball& factor) {
        return {std::move(x.value) * factor, std::move(x.derivative) * factor};
    }
};

/// W(zeta) = sqrt((zeta - a)(zeta + b)), with W ~ zeta far from the contact (length). On the
/// contact W = i w.
[[nodiscard]] Box root_outside(const Extent<Ball>& e, const Box& zeta);

/// The Cauchy integral of the pressure of a contact with a closed form, or of a zone of its profile
/// (BallContact::between). Enclosed; not finite on the surface where p is infinite.
[[nodiscard]] CauchyIntegral cauchy_integral(const BallContact& contact, const Box& zeta);

/// The Cauchy integral of the pressure at an edge of the contact, where it is real: pi E*/2 times
/// the slope g' of the contact, which may be tilted, at its edge.
[[nodiscard]] Ball cauchy_integral_at_edge(const BallContact& contact, Edge edge);

/// T and its first three derivatives, enclosed for every zeta of a box with z >= 0. Not finite if
/// the box contains an edge, or a point of the surface at which g' or g'' jumps, or is too wide.
using CauchyDerivatives = std::array<Box, 4>;
[[nodiscard]] CauchyDerivatives cauchy_derivatives(const BallContact& contact, const Box& zeta);

/// T and z dT/dzeta for every zeta of a box with z >= 0. In contrast to cauchy_derivatives they are
/// finite also on small boxes that contain an edge or a knot without a corner: T is continuous
/// there, and z dT/dzeta tends to 0 (docs/stress.md, "The greatest values").
struct CauchyBounds {
    Box value;
    Box with_depth; ///< z dT/dzeta
};
[[nodiscard]] CauchyBounds cauchy_bounds(const BallContact& contact, const Box& zeta);

/// The Cauchy integral of the traction under full stick (law/shear.hpp). Not finite at an edge.
[[nodiscard]] CauchyIntegral cauchy_integral(const Extent<Ball>& e, const ShearLoad<Ball>& load,
                                             const Box& zeta);

} // namespace edgeproof::contact
