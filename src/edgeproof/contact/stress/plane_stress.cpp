// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/plane_stress.hpp"

namespace edgeproof::contact {

Ball StressState::mises(const Ball& nu) const {
    const Ball y = syy(nu);
    const auto square = [](const Ball& x) { return x * x; };
    return sqrt((square(sxx - szz) + square(szz - y) + square(y - sxx)) / 2 + square(sxz) * 3);
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
        return {(P - shear) / pi + bulk, P / pi, Q / pi};
    }
    const Ball P_x = z * p.derivative.real();
    const Ball P_z = z * p.derivative.imaginary();
    const Ball Q_x = z * q.derivative.real();
    const Ball Q_z = z * q.derivative.imaginary();
    return {(P + P_x - shear + Q_z) / pi + bulk, (P - P_x - Q_z) / pi, (Q + Q_x - P_z) / pi};
}

} // namespace edgeproof::contact
