// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals over the approach: the gap outside the contact, and the energy of a cycle.
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

namespace edgeproof::contact {

namespace {

/// The part of a bend at v in the gap at r: the integral of h'(s) arccos(s/r) over s0 < s < r,
/// s = v + (r - v) cos^2(psi), psi = t psi_0 (docs/axisymmetric.md, "The gap").
/// @param beyond r - s0 (length)
/// @param before s0 - v, 0 or more (length)
/// @param rate h'(s) cos(psi) for s, cos(psi)
Ball gap_integral(const Ball& v, const Ball& r, const Ball& beyond, const Ball& before,
                  const std::function<Box(const Box& s, const Box& cosine)>& rate) {
    const long bits = r.bits();
    const Ball span = r - v;
    const Ball angle = atan2(sqrt(beyond), Field<Ball>::root(before)); // psi_0
    const Ball ratio = sqrt(span / (r * 2));
    const IntegralGoal goal{bits, useful_accuracy(beyond.relative_accuracy_bits(), bits),
                            Ball(0, bits), Ball(1, bits)};
    return integral_of(
               [&](const Box& t) {
                   Box sine(bits);
                   Box cosine(bits);
                   acb_sin_cos(sine.get(), cosine.get(), (t * angle).get(), bits);
                   Box arc = sine * ratio;
                   if (!certainly_less(abs(arc), Ball(1, bits))) {
                       return unknown_box(bits); // near a cut
                   }
                   acb_asin(arc.get(), arc.get(), bits);
                   const Box s = cosine * cosine * span + v;
                   return sine * arc * rate(s, cosine);
               },
               goal) *
           angle * span * 8 / Ball::pi(bits);
}

} // namespace

Ball AxisymmetricContact::gap_beyond(const Ball& beyond) const {
    const Ball r = a_ + beyond;
    Ball sum(0, bits_);
    for (const Bend& bend : bends_) {
        if (bend.at_origin) {
            sum += gap_integral(bend.v, r, beyond, a_, [&](const Box& s, const Box& cosine) {
                return (s * (bend.rate * 2) + bend.jump * Ball::pi(bits_) / 2) * cosine;
            });
        } else if (certainly_less(bend.v, r)) {
            const Ball from = min(beyond, r - bend.v);
            const Ball before = clamped(a_ - bend.v);
            sum += gap_integral(bend.v, r, from, before, [&](const Box& s, const Box& cosine) {
                const Box root = principal_root((s + bend.v) * (r - bend.v)); // y/cos(psi)
                const Box y = root * cosine;
                const Box A = principal_arctangent(y / bend.v);
                return (y * Ball(2, bits_) - A * bend.v) * bend.rate * cosine +
                       (A * cosine + Box(bend.v) / root) * bend.jump;
            });
        } else if (!certainly_less(r, bend.v)) {
            // At most the greatest arccos times h(r).
            const Ball y = Field<Ball>::root(clamped(r - bend.v) * (r + bend.v));
            const Ball A = atan2(y, bend.v);
            const Ball most = r * A * (abs(bend.jump) * A + abs(bend.rate) * y);
            sum += Ball::hull(-most, most) * 2 / Ball::pi(bits_);
        }
    }
    return sum;
}

Ball axisymmetric_gap(const BallContact& plane, const Ball& beyond) {
    const long bits = plane.bits();
    const Ball& a = plane.a();
    const Ball rate = plane.force_rate() / plane.modulus(); // h'(a)
    const std::optional<PowerLaw<Ball>>& power = plane.power_law();
    const Box exponent(power ? power->exponent : Ball(plane.slope().has_corner(0) ? 0 : 1, bits));
    return gap_integral(Ball(0, bits), a + beyond, beyond, a, [&](const Box& s, const Box& cosine) {
        if (!certainly_positive(s.real())) {
            return unknown_box(bits); // near a cut
        }
        Box grown(bits);
        acb_pow(grown.get(), (s / a).get(), exponent.get(), bits);
        return grown * rate * cosine;
    });
}

namespace {

/// The integrals of s/(s^2 + w)^n and of s^2/(s^2 + w)^n over 0 < s < a.
struct OriginMoments {
    Ball first;
    Ball second;
};
OriginMoments origin_moments(const Ball& a, const Ball& w, long n) {
    const Ball root = sqrt(w);
    const Ball end = a * a + w;
    Ball even = atan2(a, root) / root; // the integral of 1/(s^2 + w)^n, by parts from n = 1 on
    if (n == 1) {
        return {log(end / w) / 2, a - w * even};
    }
    for (long k = 1; k + 1 < n; ++k) {
        even = (a / pow_int(end, k) + even * (2 * k - 1)) / (w * (2 * k));
    }
    const long twice = 2 * (n - 1);
    return {(1 / pow_int(w, n - 1) - 1 / pow_int(end, n - 1)) / twice,
            (even - a / pow_int(end, n - 1)) / twice};
}

} // namespace

// docs/axisymmetric.md, "Stresses", with s^2 = v^2 + Y^2 t^2
Ball AxisymmetricContact::approach_moment(const Ball& w, long n) const {
    Ball sum(0, bits_);
    for (const Bend& bend : bends_) {
        if (bend.at_origin) {
            const OriginMoments of = origin_moments(a_, w, n);
            sum += bend.jump * Ball::pi(bits_) / 2 * of.first + bend.rate * 2 * of.second;
        } else if (inside(bend.knot)) {
            const Ball& v = bend.v;
            const Ball Y = Field<Ball>::root(clamped(a_ - v) * (a_ + v));
            const Ball from = v * v + w;
            const long known = std::min(w.relative_accuracy_bits(), Y.relative_accuracy_bits());
            const long accuracy = useful_accuracy(known, bits_);
            const IntegralGoal goal{std::min(bits_, accuracy + 64), accuracy, Ball(0, bits_),
                                    Ball(1, bits_)};
            sum += Y * Y *
                   integral_of(
                       [&](const Box& t) {
                           const Box y = t * Y;
                           const Box A = principal_arctangent(y / v);
                           const Box rate = (A * t + Box(v / Y)) * bend.jump +
                                            (y * Ball(2, bits_) - A * v) * t * bend.rate;
                           Box power = y * y + from;
                           acb_pow_si(power.get(), power.get(), n, bits_);
                           return rate / power;
                       },
                       goal);
        }
    }
    return sum;
}

// docs/axisymmetric.md, "Stresses", with s^2 = v^2 + Y^2 t^2
Ball AxisymmetricContact::over_approach(const std::function<Box(const Box& s)>& f) const {
    const IntegralGoal goal{bits_, useful_accuracy(a_.relative_accuracy_bits(), bits_),
                            Ball(0, bits_), Ball(1, bits_)};
    Ball sum(0, bits_);
    for (const Bend& bend : bends_) {
        const Ball& v = bend.v;
        if (bend.at_origin) {
            sum +=
                a_ * integral_of(
                         [&](const Box& t) {
                             const Box s = t * a_;
                             return f(s) * (s * (bend.rate * 2) + bend.jump * Ball::pi(bits_) / 2);
                         },
                         goal);
        } else if (inside(bend.knot)) {
            const Ball Y = Field<Ball>::root(clamped(a_ - v) * (a_ + v));
            sum += Y * integral_of(
                           [&](const Box& t) {
                               const Box y = t * Y;
                               const Box s = principal_root(y * y + v * v);
                               const Box A = principal_arctangent(y / v);
                               const Box rate = (A * y + v) * bend.jump +
                                                (y * Ball(2, bits_) - A * v) * y * bend.rate;
                               return f(s) * rate / s; // ds = y dy/s
                           },
                           goal);
        }
    }
    return sum;
}

// With s = a exp(-x) the power is an exponential. Beyond x = X the integrand is bounded by its
// values in the box of the remaining s.
Ball over_approach(const BallContact& plane, const std::function<Box(const Box& s)>& f) {
    const long bits = plane.bits();
    const std::optional<PowerLaw<Ball>>& law = plane.power_law();
    const Ball power =
        law ? law->exponent + 1 : Ball(plane.slope().has_corner(0) ? 1 : 2, bits); // m + 1
    const Ball& a = plane.a();
    const Ball scale = plane.force_rate() / plane.modulus() * a; // a h'(a)
    const Ball X = middle(log(Ball(2, bits)) * (bits + 16) / power);
    const auto place = [&](const Box& x) {
        Box s(bits);
        acb_exp(s.get(), (-x).get(), bits);
        return s * a;
    };
    const Ball whole = X * integral_of(
                               [&](const Box& t) {
                                   const Box x = t * X;
                                   Box weight(bits);
                                   acb_exp(weight.get(), (x * -power).get(), bits);
                                   return f(place(x)) * weight;
                               },
                               {bits, bits, Ball(0, bits), Ball(1, bits)});
    const Ball rest = place(Box(X)).real();
    const Ball end = upper_end(exp(-power * X)) / power;
    return scale * (whole + up_to(end * upper_end(abs(f(Box(Ball::hull(Ball(0, bits), rest)))))));
}

// docs/axisymmetric.md, "The energy of a cycle"
Ball AxisymmetricContact::loop_integral(const Ball& from, const Ball& tau) const {
    // Between two bends h' is analytic, and with s = s0 + t^2 (s1 - s0) also at a bend at s0.
    std::vector<Ball> ends{from};
    std::vector<std::size_t> begins{bends_.size()}; // the bend at which a part begins
    for (std::size_t i = 0; i < bends_.size(); ++i) {
        const Ball& v = bends_[i].v;
        if (bends_[i].at_origin || !inside(bends_[i].knot) || certainly_less(v, from)) {
            continue;
        }
        if (!certainly_less(from, v)) {
            return unknown_ball(bits_);
        }
        ends.push_back(v);
        begins.push_back(i);
    }
    ends.push_back(a_);
    const Ball whole = force();
    const Ball mean = whole * (1 - tau / 2);
    const Ball scale = whole * tau * (approach() - approach_at(from)) / (a_ - from);
    const long known = std::min((a_ - from).relative_accuracy_bits(), tau.relative_accuracy_bits());
    const IntegralGoal goal{bits_, useful_accuracy(known, bits_), scale, a_ - from};
    Ball sum(0, bits_);
    for (std::size_t part = 0; part + 1 < ends.size(); ++part) {
        const Ball& begin = ends[part];
        const Ball width = ends[part + 1] - begin;
        sum += width * 2 *
               integral_of(
                   [&](const Box& t) {
                       const Box beyond = t * t * width; // s - s0
                       const Box s = beyond + begin;
                       Box rate(bits_);    // t h'(s)
                       Box carried(bits_); // L/E*
                       for (std::size_t i = 0; i < bends_.size(); ++i) {
                           const Bend& bend = bends_[i];
                           const Ball& v = bend.v;
                           const bool begun =
                               bend.at_origin || i == begins[part] || certainly_less(v, begin);
                           if (!begun) {
                               break;
                           }
                           const bool here = i == begins[part];
                           const Box root = bend.at_origin ? s
                                            : here         ? principal_root((s + v) * width)
                                                           : principal_root(beyond + (begin - v)) *
                                                         principal_root(s + v);
                           const Box y = here ? root * t : root;
                           const Box A = bend.at_origin ? Box(Ball::pi(bits_) / 2)
                                                        : principal_arctangent(y / v);
                           const Box slope = bend.at_origin ? A * t
                                             : here         ? A * t + Box(v) / root
                                                            : (A + Box(v) / y) * t;
                           rate = rate + (y * Ball(2, bits_) - A * v) * t * bend.rate +
                                  slope * bend.jump;
                           const Box s2A = s * s * A;
                           carried =
                               carried + (s2A + y * v) * bend.jump +
                               (y * y * y * (Ball(4, bits_) / 3) - (s2A - y * v) * v) * bend.rate;
                       }
                       return (Box(mean) - carried * modulus_) * rate;
                   },
                   goal);
    }
    return sum;
}

} // namespace edgeproof::contact
