// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/slip/stick_zone.hpp"

#include <memory>

namespace edgeproof::contact {

/// Zones of any slope that IntegratedContact handles, by rigorous integration. Keeps a copy.
[[nodiscard]] std::unique_ptr<ZoneSolver> integrated_zones(const IntegratedContact& contact);

/// Zones of a power law under a tilt: its integrals by Gauss's 2F1 where the zone holds the origin,
/// by rigorous integration elsewhere, as its pressures. `a`, `b`: of the contact.
[[nodiscard]] std::unique_ptr<ZoneSolver> power_law_zones(const Profile& profile,
                                                          const formula::Exact& contact_modulus,
                                                          const Ball& a, const Ball& b, long bits);

} // namespace edgeproof::contact
