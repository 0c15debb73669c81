// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/plane_contact.hpp"
#include "edgeproof/contact/law/shear.hpp"

/// The Cauchy integrals of the tractions of a contact, from which all stresses follow
/// (docs/stress.md, "The Cauchy integrals").
namespace edgeproof::contact {

/// W(zeta) = sqrt((zeta - a)(zeta + b)), with W ~ zeta far from the contact (length). On the
/// contact W = i w.
[[nodiscard]] Box root_outside(const Extent<Ball>& e, const Box& zeta);
/// W over a box with z >= 0, also if it contains an edge.
[[nodiscard]] Box root_above(const Extent<Ball>& e, const Box& zeta);
/// z/W for every zeta of a box. Where that contains an edge, z <= |zeta - edge| is used.
[[nodiscard]] Box depth_over_root(const Extent<Ball>& e, const Box& zeta);
/// A lower bound of the distance of a box from the contact (length); 0 if they meet.
[[nodiscard]] Ball distance_from(const Extent<Ball>& e, const Box& zeta);
/// A box around 0 that contains all numbers of at most the size of x.
[[nodiscard]] Box box_of_size(const Ball& x);

/// The Cauchy integral of the traction under full stick (law/shear.hpp). Not finite at an edge.
[[nodiscard]] CauchyIntegral cauchy_integral(const Extent<Ball>& e, const ShearLoad<Ball>& load,
                                             const Box& zeta);

/// Returns the potential of the traction under full stick (law/shear.hpp). Enclosed.
/// @param e the contact
/// @param load Q (force/length) and sigma_0 (stress)
/// @param x the place (length)
[[nodiscard]] SurfacePotential surface_potential(const Extent<Ball>& e, const ShearLoad<Ball>& load,
                                                 const Ball& x);

} // namespace edgeproof::contact
