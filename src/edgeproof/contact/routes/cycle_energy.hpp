// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/partial_slip.hpp"

namespace edgeproof::contact {

/// The energy per unit length that friction dissipates in a cycle of the shear force, from -|Q| to
/// |Q| and back, with P held and without bulk tension (docs/partial-slip.md, "The energy of a
/// cycle"), by tanh-sinh over the right edge:
///     W = 8 f^2/(pi E*) times the integral of (P - L)(L - L_s) dD/D over L_s < L < P.
/// The unit is that of a force. This is an estimate. Throws BudgetError if the quadrature does not
/// converge.
[[nodiscard]] Real cycle_energy(const NormalContact& contact, const PartialSlip& slip,
                                const formula::Exact& friction);

} // namespace edgeproof::contact
