// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/force_growth.hpp"

#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"

#include <array>
#include <cstddef>

namespace edgeproof::contact {
namespace {

/// The integrals of y^k/w from the place of a mark to the right edge, k = 0 ... 4, where y is the
/// distance from the middle of the contact.
std::array<Ball, 5> moments(const Mark<Ball>& v, const Ball& half) {
    std::array<Ball, 5> J{v.h, v.w};
    Ball power = v.y;
    for (int k = 2; k < 5; ++k) {
        const auto i = static_cast<std::size_t>(k);
        J[i] = (power * v.w + half * half * J[i - 2] * (k - 1)) / k;
        power *= v.y;
    }
    return J;
}

/// The integrals of a weight f(s) from x to the right edge, with (s - x) for a corner of g' at x,
/// and with (s - x)^2/2 for a change of g''.
struct Raised {
    Ball corner;
    Ball change;
};

/// f = y^power/w.
Raised raised(const std::array<Ball, 5>& J, std::size_t power, const Ball& x) {
    return {J[power + 1] - x * J[power],
            (J[power + 2] - x * J[power + 1] * 2 + x * x * J[power]) / 2};
}

/// Integrals of p and of 1/w, times g on the right of the origin.
struct Half {
    Ball pressed;
    Ball mean;
};

// docs/partial-slip.md, "The energy of a cycle"
Half right_half(const BallContact& contact) {
    const LinearSlope<Ball>& slope = contact.slope();
    const std::size_t origin = slope.origin;
    const Ball half = contact.length() / 2;
    const long bits = contact.bits();
    Half sum{Ball(0, bits), Ball(0, bits)};
    const auto add = [&](std::size_t i, const Ball& jump, const Ball& rate) {
        const Mark<Ball>& x = contact.knot_marks()[i];
        const std::array<Ball, 5> J = moments(x, half);
        const Raised mean = raised(J, 0, x.y);
        const Raised square = raised(J, 2, x.y);
        sum.mean += jump * mean.corner + rate * mean.change;
        // w = (half^2 - y^2)/w
        Raised pressed{(half * half * mean.corner - square.corner) * contact.arc(),
                       (half * half * mean.change - square.change) * contact.arc()};
        for (const std::size_t j : contact.bends_inside()) {
            const Mark<Ball>& v = contact.knot_marks()[j];
            // The integrals of (v - s)^n/w
            const Ball& y = v.y;
            const std::array<Ball, 4> R{J[0], y * J[0] - J[1], y * (y * J[0] - J[1] * 2) + J[2],
                                        y * (y * (y * J[0] - J[1] * 3) + J[2] * 3) - J[3]};
            const Ball d = i == j ? Ball(0, bits) : slope.knots[j] - slope.knots[i];
            const Ball G = ball_green(v, x.right, x.left, x.w, contact.length(), d).moment; // d G
            const Ball d2 = d * d;
            if (slope.has_corner(j)) {
                pressed.corner += slope.jump(j) * (d * G / 2 + v.w * (d * R[0] - R[1] / 2));
                pressed.change +=
                    slope.jump(j) * (d2 * G / 6 + v.w * (d2 * R[0] - d * R[1] + R[2] / 3) / 2);
            }
            const Ball drop = slope.rate_drop(j);
            pressed.corner += drop * (d2 * G / 6 + v.w * (d * R[1] / 2 - R[2] / 3));
            pressed.change +=
                drop * (d2 * d * G / 24 + v.w * (d2 * R[1] / 4 - d * R[2] / 3 + R[3] / 8));
        }
        sum.pressed += (jump * pressed.corner + rate * pressed.change) * contact.pressure_factor();
    };
    add(origin, slope.pieces[origin + 1].at_origin, slope.rate(origin + 1));
    for (const std::size_t i : contact.bends_inside()) {
        if (i > origin) {
            add(i, slope.jump(i), -slope.rate_drop(i));
        }
    }
    return sum;
}

} // namespace

ForceGrowth force_growth(const BallContact& contact, const Ball& force) {
    const Half right = right_half(contact);
    const Half left = contact.symmetric() ? right : right_half(contact.mirrored());
    const Ball pi = Ball::pi(contact.bits());
    const Ball mean = (right.mean + left.mean) / pi;
    const Ball factor = pi * contact.modulus() / 2;
    return {factor * mean, factor * (force * mean - right.pressed - left.pressed)};
}

} // namespace edgeproof::contact
