// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/stress_field.hpp"

namespace edgeproof::contact {

StressField StressField::reflected() const {
    StressField r = *this;
    for (LoadPart& part : r.parts) {
        part.contact = part.contact.mirrored();
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
        shear += part.shear * (i == 0 ? cauchy_integral_at_edge(part.contact, Edge::right)
                                      : cauchy_integral(part.contact, Box(a)).value.real());
    }
    return {edge, field.bulk - shear * 2 / Ball::pi(field.bits())};
}

} // namespace edgeproof::contact
