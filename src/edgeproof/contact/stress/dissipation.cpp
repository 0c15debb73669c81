// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/dissipation.hpp"

#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"
#include "edgeproof/precision/error.hpp"

#include <array>
#include <cstddef>

namespace edgeproof::contact {
namespace {

using Cut = SlipPhase::Cut;

/// The weight between two cuts. Throws BudgetError if the bits do not distinguish the cuts.
PhaseWeight weight_between(const SlipPhase& s, const Ball& from, const Ball& to) {
    const Ball centre = (from + to) / 2;
    const auto beyond = [&](const Ball& force) { // centre > force
        if (!certainly_less(force, centre) && !certainly_less(centre, force)) {
            throw BudgetError("too few bits to distinguish the forces of a step");
        }
        return certainly_less(force, centre);
    };
    const Ball growth = s.force_to - s.force_from;
    const bool before_slip = !beyond(s.inner_from); // L_s has to decrease to L first
    const bool late = beyond(s.force_from);         // P has to increase to L first
    const bool ends = beyond(s.force_to);           // P decreases below L
    const auto at = [&](const Ball& L) {
        Ball begin(0, L.bits());
        Ball end(1, L.bits());
        if (before_slip) {
            begin = (s.inner_from - L) / (s.inner_from - s.inner_to);
        } else if (late) {
            begin = (L - s.force_from) / growth;
        }
        if (ends) {
            end = (L - s.force_from) / growth;
        }
        return (end - begin) * (s.force_from - L + growth * (begin + end) / 2);
    };
    const Ball half = (to - from) / 2;
    const Ball lower = at(from);
    const Ball mean = at(centre);
    const Ball upper = at(to);
    return {centre,
            {mean, (upper - lower) / (half * 2), (upper - mean * 2 + lower) / (half * half * 2)}};
}

/// c_0, c_1, c_2 of W = c_0 + c_1 L + c_2 L^2.
std::array<Ball, 3> about_zero(const PhaseWeight& w) {
    return {w(Ball(0, w.at.bits())), w.c[1] - w.c[2] * w.at * 2, w.c[2]};
}

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

/// Integrals over the contacts of a profile under the forces up to L, in closed form
/// (docs/partial-slip.md, "The energy of a cycle"). D is the length of a contact. Only differences
/// of `first` between contacts of the profile have a meaning: the integral begins at no contact.
struct ForceGrowth {
    Ball first;  ///< of L d ln D (force/length)
    Ball second; ///< of L^2 d ln D (force/length, squared)
};

/// Enclosed, for a contact, or a zone of its profile, with a piecewise linear slope under the force
/// L (force/length). Between neighbouring contacts the differences lose bits, and the caller uses
/// more.
ForceGrowth force_growth(const BallContact& contact, const Ball& force) {
    const Half right = right_half(contact);
    const Half left = contact.symmetric() ? right : right_half(contact.mirrored());
    const Ball pi = Ball::pi(contact.bits());
    const Ball mean = (right.mean + left.mean) / pi;
    const Ball factor = pi * contact.modulus() / 2;
    return {factor * mean, factor * (force * mean - right.pressed - left.pressed)};
}

} // namespace

GrowthIntegral growth_of(const BallContact& contact) {
    return [&contact](const PhaseWeight& weight, const Cut& from, const Cut& to) {
        const BallContact inner = contact.between(from.zone.a, from.zone.b);
        const BallContact outer = contact.between(to.zone.a, to.zone.b);
        const ForceGrowth lower = force_growth(inner, from.force);
        const ForceGrowth upper = force_growth(outer, to.force);
        const auto c = about_zero(weight);
        return c[0] * log1p((outer.length() - inner.length()) / inner.length()) +
               c[1] * (upper.first - lower.first) + c[2] * (upper.second - lower.second);
    };
}

// d ln D = dL/(power L)
GrowthIntegral similar_growth(const Ball& power) {
    return [power](const PhaseWeight& weight, const Cut& from, const Cut& to) {
        const Ball width = to.force - from.force;
        const auto c = about_zero(weight);
        return (c[0] * log1p(width / from.force) + c[1] * width +
                c[2] * width * (from.force + to.force) / 2) /
               power;
    };
}

Ball dissipated_energy(const Ball& modulus, const Ball& friction,
                       const std::vector<SlipPhase>& phases, const GrowthIntegral& integral) {
    Ball sum(0, modulus.bits());
    for (const SlipPhase& phase : phases) {
        Ball part(0, modulus.bits());
        for (std::size_t i = 0; i + 1 < phase.cuts.size(); ++i) {
            const Cut& from = phase.cuts[i];
            const Cut& to = phase.cuts[i + 1];
            part += integral(weight_between(phase, from.force, to.force), from, to);
        }
        sum += phase.change * part;
    }
    return sum * friction * 2 / (Ball::pi(modulus.bits()) * modulus);
}

// Both ways: Q changes by 2 |Q| = 2 f (P - L_s).
Ball cycle_energy(const BallSlip& slip, const GrowthIntegral& integral) {
    const Ball inner = slip.force() * (1 - slip.load_ratio());
    return dissipated_energy(slip.zones().modulus(), slip.friction(),
                             {{slip.force(),
                               inner,
                               slip.force(),
                               slip.force(),
                               slip.friction() * slip.force() * slip.load_ratio() * 4,
                               {{inner, slip.stick()}, {slip.force(), slip.whole()}}}},
                             integral);
}

} // namespace edgeproof::contact
