// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/proved_contact.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::contact {

/// T(zeta) = integral of t(s)/(zeta - s) ds over the contact, for a traction t (stress) and a place
/// zeta = x + i z at the depth z >= 0 (length). On the surface it is the limit from z > 0.
struct CauchyIntegral {
    Box value;      ///< stress
    Box derivative; ///< dT/dzeta (stress/length); not finite at an edge or at a corner

    friend CauchyIntegral operator+(CauchyIntegral x, const CauchyIntegral& y) {
        return {std::move(x.value) + y.value, std::move(x.derivative) + y.derivative};
    }
    friend CauchyIntegral operator*(CauchyIntegral x, const Ball& factor) {
        return {std::move(x.value) * factor, std::move(x.derivative) * factor};
    }
};

/// T and its first three derivatives, enclosed for every zeta of a box with z >= 0.
using CauchyDerivatives = std::array<Box, 4>;

/// T and z dT/dzeta for every zeta of a box with z >= 0.
struct CauchyBounds {
    Box value;
    Box with_depth; ///< z dT/dzeta
};

/// Integrals of a traction t and of its Cauchy integral T along the surface, from which the
/// displacements of a half-plane follow (docs/stress.md, "The displacements").
struct SurfacePotential {
    Ball lift;    ///< the integral of Re T from the right edge to x (force/length)
    Ball carried; ///< the integral of t from x to the right edge (force/length)

    friend SurfacePotential operator-(const SurfacePotential& x, const SurfacePotential& y) {
        return {x.lift - y.lift, x.carried - y.carried};
    }
    friend SurfacePotential operator+(const SurfacePotential& x, const SurfacePotential& y) {
        return {x.lift + y.lift, x.carried + y.carried};
    }
    friend SurfacePotential operator*(const SurfacePotential& x, const Ball& factor) {
        return {x.lift * factor, x.carried * factor};
    }
};

/// A plane contact, or a zone of its profile that is a contact with another tilt: all stresses and
/// displacements follow from the Cauchy integral T of its pressure (docs/stress.md, "The Cauchy
/// integrals"). All values are enclosed.
class PlaneContact : public ProvedContact {
public:
    /// T. Not finite on the surface where p is infinite, nor, of a curved slope, on the surface at
    /// a knot or an edge that is not known exactly. `x`: see ProvedContact::pressure.
    [[nodiscard]] virtual CauchyIntegral cauchy_integral(const Box& zeta,
                                                         const std::optional<Exact>& x) const = 0;
    [[nodiscard]] CauchyIntegral cauchy_integral(const Box& zeta) const {
        return cauchy_integral(zeta, {});
    }
    /// Not finite if the box contains an edge, or a point of the surface at which g' or g'' jumps,
    /// or is too wide.
    [[nodiscard]] virtual CauchyDerivatives cauchy_derivatives(const Box& zeta) const = 0;
    /// In contrast to cauchy_derivatives these are finite also on small boxes that contain an edge
    /// or a knot without a corner: T is continuous there, and z dT/dzeta tends to 0
    /// (docs/stress.md, "The greatest values").
    [[nodiscard]] virtual CauchyBounds cauchy_bounds(const Box& zeta) const = 0;
    /// The first coefficients of pi E*/2 times the slope, which may be tilted, in powers of zeta -
    /// a at the right edge: T is their sum and that of odd powers of sqrt(zeta - a).
    [[nodiscard]] virtual std::vector<Ball> edge_slope(std::size_t terms) const = 0;
    /// That sum without its first term, divided by zeta - a, for |zeta - a| <= radius (length).
    [[nodiscard]] virtual Box edge_slope_rate(const Ball& radius) const = 0;
    /// T at an edge, where it is real.
    [[nodiscard]] Ball cauchy_integral_at(Edge edge) const {
        return edge == Edge::right ? edge_slope(1)[0] : -mirror_image()->edge_slope(1)[0];
    }
    /// The gap (length) between the bodies at the distance `beyond` >= 0 (length) outwards from an
    /// edge. It grows as beyond^(3/2) at the edge.
    [[nodiscard]] virtual Ball gap_beyond(Edge edge, const Ball& beyond) const = 0;
    /// The gap (length) at the place x (length) on either side; 0 inside.
    [[nodiscard]] Ball gap_at(const Ball& x) const;
    /// The potential of the pressure at the place x (length), anywhere on the surface; `known`: the
    /// place, if it is known exactly.
    [[nodiscard]] virtual SurfacePotential
    surface_potential(const Ball& x, const std::optional<Exact>& known) const = 0;
    /// The mirror image, with its edges.
    [[nodiscard]] virtual std::shared_ptr<const PlaneContact> mirror_image() const = 0;
    /// The zone -b < x < a of the same profile, with the tilt that makes it a contact: a tilt does
    /// not change the formula of the pressure (docs/partial-slip.md, "The corrective contact"). For
    /// a power law in closed form only symmetric zones are allowed.
    [[nodiscard]] virtual std::shared_ptr<const PlaneContact> zone(const Ball& a,
                                                                   const Ball& b) const = 0;

protected:
    using ProvedContact::ProvedContact;
};

} // namespace edgeproof::contact
