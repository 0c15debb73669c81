// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/plane_contact.hpp"
#include "edgeproof/contact/law/shear.hpp"

namespace edgeproof::contact {

/// Returns the potential of the traction under full stick (law/shear.hpp). Enclosed.
/// @param e the contact
/// @param load Q (force/length) and sigma_0 (stress)
/// @param x the place (length)
[[nodiscard]] SurfacePotential surface_potential(const Extent<Ball>& e, const ShearLoad<Ball>& load,
                                                 const Ball& x);

} // namespace edgeproof::contact
