// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/slip/stick_zone.hpp"

#include <memory>

namespace edgeproof::contact {

/// Returns the solver for zones of any slope that IntegratedContact handles, by rigorous
/// integration. It keeps a copy of `contact`.
[[nodiscard]] std::unique_ptr<ZoneSolver> integrated_zones(const IntegratedContact& contact);

/// Returns the solver for zones of a power law under a tilt. The integrals are Gauss's 2F1 where
/// the zone contains the origin; elsewhere they, and all pressures, follow from rigorous
/// integration.
/// @param profile a power law
/// @param contact_modulus E* (stress)
/// @param a,b distances of the edges of the contact from the origin (length)
/// @param bits working precision
[[nodiscard]] std::unique_ptr<ZoneSolver> power_law_zones(const Profile& profile,
                                                          const formula::Exact& contact_modulus,
                                                          const Ball& a, const Ball& b, long bits);

} // namespace edgeproof::contact
