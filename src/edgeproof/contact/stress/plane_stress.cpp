// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/plane_stress.hpp"

namespace edgeproof::contact {

// docs/stress.md, "The measures"; a sum of squares, whose root has no negative part.
Ball StressState::mises(const Ball& nu) const {
    return hypot(sqrt(Ball(3, nu.bits())) * tau_max(), (1 - nu * 2) * ((sxx + szz) / 2));
}

// johnson1985, eq. 2.23 (docs/stress.md, "Stresses")
StressState stress_of(const CauchyIntegral& p, const CauchyIntegral& q, const Box& zeta,
                      const Ball& bulk) {
    const Ball z = zeta.imaginary();
    const Ball pi = Ball::pi(zeta.bits());
    const Ball P = p.value.imaginary();
    const Ball Q = q.value.imaginary();
    const Ball shear = q.value.real() * 2;
    if (arb_is_zero(z.data()) != 0) { // the derivatives may be infinite
        return {(P - shear) / pi + bulk, P / pi, Q / pi, (bulk - shear / pi) / 2};
    }
    const Ball P_x = z * p.derivative.real();
    const Ball P_z = z * p.derivative.imaginary();
    const Ball Q_x = z * q.derivative.real();
    const Ball Q_z = z * q.derivative.imaginary();
    return {(P + P_x - shear + Q_z) / pi + bulk, (P - P_x - Q_z) / pi, (Q + Q_x - P_z) / pi,
            (P_x + Q_z - shear / 2) / pi + bulk / 2};
}

} // namespace edgeproof::contact
