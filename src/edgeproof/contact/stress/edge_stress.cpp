// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/edge_stress.hpp"

#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::contact {
EdgeStress::EdgeStress(const StressField& field, const std::optional<ShearLoad<Ball>>& stick,
                       Edge edge, std::size_t terms)
    : bits_(field.bits()), first_(stick ? -1 : 0), edge_(edge), bulk_(field.bulk),
      pressure_(terms, Ball(0, bits_)), shear_(terms, Ball(0, bits_)) {
    const StressField turned = edge == Edge::left ? field.reflected() : field;
    const PlaneContact& contact = turned.contact();
    Ball reach(contact.reach(Edge::right).lower(), bits_);
    for (std::size_t i = 1; i < turned.parts.size(); ++i) {
        reach = min(reach, contact.a() - turned.parts[i].contact->a());
    }
    radius_ = Ball(Real((reach * 31 / 32).lower()), bits_);
    if (!certainly_positive(radius_) || contact.edge_may_be_on_knot()) {
        throw BudgetError("too few bits to separate the edge from a knot or from a stick zone");
    }
    add_contact(contact, turned.parts.front().pressure, turned.parts.front().shear);
    for (std::size_t i = 1; i < turned.parts.size(); ++i) {
        add_zone(*turned.parts[i].contact, contact.a(), turned.parts[i].shear);
    }
    if (stick) { // the mirror image of q has the other sign, that of a tension the same
        add_stick({edge == Edge::left ? -stick->Q : stick->Q, stick->bulk_tension},
                  contact.length());
    }
}

// P is pi E* g'/2 - pi sum (-1)^k c_k s^(2k+1).
void EdgeStress::add_contact(const PlaneContact& contact, const Ball& pressure, const Ball& shear) {
    const Ball pi = Ball::pi(bits_);
    const auto terms = static_cast<int>(pressure_.size());
    const auto add = [&](int j, const Ball& A) {
        if (j - first_ < terms) {
            pressure_[entry(j)] += A * pressure;
            shear_[entry(j)] += A * shear;
        }
    };
    const std::vector<Ball> c = contact.expansion(Edge::right, pressure_.size() / 2 + 1);
    for (std::size_t k = 0; k < c.size(); ++k) {
        add(static_cast<int>(2 * k + 1), k % 2 == 0 ? -pi * c[k] : pi * c[k]);
    }
    const std::vector<Ball> slope = contact.edge_slope(c.size());
    for (std::size_t k = 0; k < slope.size(); ++k) {
        add(static_cast<int>(2 * k), slope[k]);
    }
}

void EdgeStress::add_zone(const PlaneContact& zone, const Ball& at, const Ball& shear) {
    const Ball most = zone.force() / (at - zone.a() - radius_);
    const std::vector<Ball> a =
        taylor_on_circle([&](const Box& z) { return zone.cauchy_integral(z + at).value; }, most,
                         radius_, Rational(3, 4), (shear_.size() + 1) / 2);
    for (std::size_t k = 0; 2 * k < shear_.size(); ++k) {
        shear_[2 * k] += a[k] * shear; // first is 0: no zones under full stick
    }
}

// T = -pi sigma_0/4 + pi sum (-1)^k s_k s^(2k-1)
void EdgeStress::add_stick(const ShearLoad<Ball>& load, const Ball& length) {
    const Ball pi = Ball::pi(bits_);
    const auto s = full_stick_expansion(length, load, Edge::right, shear_.size() / 2 + 1);
    for (std::size_t k = 0; 2 * k < shear_.size(); ++k) {
        shear_[2 * k] += k % 2 == 0 ? pi * s[k] : -pi * s[k];
    }
    const Ball tension = load.bulk_tension * pi / 4;
    if (shear_.size() > 1) {
        shear_[1] -= tension;
    }
}

// docs/stress.md, "Near an edge": with h = j/2 and the angle phi from the free surface
std::vector<Ball> EdgeStress::along(StressComponent component, const Exact& angle) const {
    std::optional<Rational> exact; // phi/pi
    if (angle.is_rational()) {
        exact = Rational(1 - angle.rational() / 180);
    }
    const Ball turn = exact ? Ball(*exact, bits_) : 1 - ball_of(angle, bits_) / 180;
    const auto at = [&](const Rational& h, bool sine) {
        Ball x = exact ? Ball(Rational(h * *exact), bits_) : Ball(h, bits_) * turn;
        (sine ? arb_sin_pi : arb_cos_pi)(x.data(), x.data(), bits_);
        return x;
    };
    std::vector<Ball> K;
    for (std::size_t i = 0; i < pressure_.size(); ++i) {
        const Rational h(static_cast<long>(i) + first_, 2);
        const Rational half = h / 2;
        const auto sines = [&](const Rational& u,
                               const Rational& v) { // u sin h phi + v sin (h-2) phi
            return h == 1 ? Ball(Rational(u - v), bits_) * at(h, true)
                          : Ball(u, bits_) * at(h, true) + Ball(v, bits_) * at(h - 2, true);
        };
        // h/2 (cos h phi - cos (h-2) phi), exactly 0 where it vanishes
        const Ball cosines = at(1, true) * at(h - 1, true) * Ball(-h, bits_);
        const Ball& A = pressure_[i];
        const Ball& B = shear_[i];
        Ball k = component == StressComponent::sxx
                     ? A * sines(1 + half, -half) - B * (at(h, false) * 2 + cosines)
                 : component == StressComponent::szz ? A * sines(1 - half, half) + B * cosines
                                                     : A * cosines + B * sines(1 + half, -half);
        k /= Ball::pi(bits_);
        if (component == StressComponent::sxx && h == 0) {
            k += bulk_;
        }
        K.push_back(component == StressComponent::sxz && edge_ == Edge::left ? -k : k);
    }
    return K;
}

} // namespace edgeproof::contact
