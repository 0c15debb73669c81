// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/law/shear.hpp"

namespace edgeproof::contact {

Rational vanishing_ratio(std::size_t k) {
    const Rational zero(0);
    const Rational one(1);
    // The coefficient is linear in Q/pi and sigma_0 D/8.
    const auto by_force = full_stick_brackets<Rational>(one, zero, one, Edge::right, k + 1);
    const auto by_tension =
        full_stick_brackets<Rational>(zero, Rational(8), one, Edge::right, k + 1);
    return -by_force[k] / by_tension[k];
}

} // namespace edgeproof::contact
