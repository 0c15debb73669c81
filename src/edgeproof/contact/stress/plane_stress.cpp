// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/plane_stress.hpp"

namespace edgeproof::contact {

// docs/stress.md, "The measures"; a sum of squares, whose root has no negative part.
Ball StressState::mises(const Ball& nu) const {
    if (across) { // the square root of half the sum of the squares of the differences
        return hypot(hypot(half_difference * 2, hypot(sxx - *across, *across - szz)) /
                         sqrt(Ball(2, nu.bits())),
                     sqrt(Ball(3, nu.bits())) * sxz);
    }
    return hypot(sqrt(Ball(3, nu.bits())) * tau_max(), (1 - nu * 2) * mean());
}

std::array<Ball, 3> StressState::principal(const Ball& nu) const {
    const bool along_axes = arb_is_zero(sxz.data()) != 0; // exactly the components, also if zero
    const Ball most = along_axes ? max(sxx, szz) : mean() + shear_in_plane();
    const Ball least = along_axes ? min(sxx, szz) : mean() - shear_in_plane();
    const Ball third = syy(nu);
    return {max(most, third), max(least, min(most, third)), min(least, third)};
}

// Twice tau_max, or the difference of syy = 2 nu mean and the farther of mean -+ tau_max, without
// cancellation.
Ball StressState::tresca(const Ball& nu) const {
    return across ? tau_max() * 2 : tau_max() + max(tau_max(), (1 - nu * 2) * abs(mean()));
}

// johnson1985, eq. 2.23 (docs/stress.md, "The Cauchy integrals")
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

StressField StressField::reflected() const {
    StressField r = *this;
    for (LoadPart& part : r.parts) {
        part.contact = part.contact->mirror_image();
        part.shear = -part.shear;
    }
    return r;
}

SurfaceTension greatest_surface_tension(const StressField& field) {
    // The traction on this body points to the leading edge.
    const Edge edge = certainly_positive(field.parts.front().shear) ? Edge::left : Edge::right;
    const StressField turned = edge == Edge::left ? field.reflected() : field;
    const Ball a = turned.contact().a();
    // sxx = -p - (2/pi) Re T + bulk at z = 0 (docs/stress.md, "The Cauchy integrals"); p = 0 at the
    // edge.
    Ball shear(0, field.bits());
    for (std::size_t i = 0; i < turned.parts.size(); ++i) {
        const LoadPart& part = turned.parts[i];
        shear += part.shear * (i == 0 ? part.contact->cauchy_integral_at(Edge::right)
                                      : part.contact->cauchy_integral(Box(a)).value.real());
    }
    return {edge, field.bulk - shear * 2 / Ball::pi(field.bits())};
}

} // namespace edgeproof::contact
