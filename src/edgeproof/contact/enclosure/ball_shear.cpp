// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_shear.hpp"

namespace edgeproof::contact {
namespace {

/// The tension as it acts at an edge: it draws the right one outwards.
Ball tension_at(const BallShearLoad& load, Edge edge) {
    return edge == Edge::right ? load.bulk_tension : -load.bulk_tension;
}

} // namespace

Ball full_stick_traction(const Ball& length, const BallShearLoad& load, Edge edge, const Ball& u) {
    const Ball other = length - u;
    return (load.Q / Ball::pi(length.bits()) + tension_at(load, edge) * (other - u) / 8) /
           sqrt(u * other);
}

std::vector<Ball> full_stick_expansion(const Ball& length, const BallShearLoad& load, Edge edge,
                                       std::size_t terms) {
    const Ball by_tension = tension_at(load, edge) * length;
    const Ball lead = load.Q / Ball::pi(length.bits()) + by_tension / 8;
    Ball scale = sqrt(length);
    Ball beta(1, length.bits());
    Ball beta_before(0, length.bits());
    std::vector<Ball> s;
    for (std::size_t k = 0; k < terms; ++k) {
        s.push_back((lead * beta - by_tension / 4 * beta_before) / scale);
        beta_before = beta;
        const long next = static_cast<long>(k) + 1;
        beta = beta * (2 * next - 1) / (2 * next);
        scale *= length;
    }
    return s;
}

} // namespace edgeproof::contact
