// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/axisymmetric_stress.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr std::size_t most_intervals = 2000;

} // namespace

AxisymmetricStress::AxisymmetricStress(const ProvedContact& contact, const Ball& force,
                                       const Ball& poisson)
    : contact_(contact), of_revolution_(dynamic_cast<const AxisymmetricContact*>(&contact)),
      force_(force), poisson_(poisson) {
    if (const BallContact* const plane = contact.closed_form()) {
        const std::optional<PowerLaw<Ball>>& law = plane->power_law();
        apex_ = !law && plane->slope().has_corner(0);
        exponent_ = law ? law->exponent : Ball(apex_ ? 0 : 1, contact.bits());
        rate_ = plane->force_rate() / plane->modulus();
    } else {
        apex_ = of_revolution_->has_apex();
    }
}

// docs/axisymmetric.md, "Stresses"
Ball AxisymmetricStress::moment(const Ball& w, long n) const {
    const Ball& a = contact_.a();
    const auto of_power = [&](const Ball& m) { // h'(s) = (s/a)^m
        return a * a / ((m + 2) * pow_int(w, n)) *
               hypergeometric_2f1(Ball(n, w.bits()), m / 2 + 1, m / 2 + 2, -(a * a) / w);
    };
    if (of_revolution_ == nullptr) {
        return rate_ * of_power(exponent_);
    }
    return of_revolution_->over_approach(
        [&](const Box& s, const Box& s2) {
            Box power = s2 + w;
            acb_pow_si(power.get(), power.get(), n, w.bits());
            return s / power;
        },
        [&](long k) { return pow_int(a, k) * of_power(Ball(k, w.bits())); },
        w.relative_accuracy_bits());
}

Ball AxisymmetricStress::moment_between(const Ball& lo, const Ball& hi, long n) const {
    return Ball::hull(moment(lo, n), moment(hi, n));
}

Ball AxisymmetricStress::on_axis_below(const Ball& S) const {
    if (of_revolution_ == nullptr) {
        return rate_ / exponent_ * pow(S / contact_.a(), exponent_);
    }
    const AxisymmetricContact part = of_revolution_->with_radius(S);
    return part.pressure(Edge::right, S, Exact()) * Ball::pi(S.bits()) / contact_.modulus();
}

// docs/axisymmetric.md, "Stresses": with A = F_1 and B = z^2 F_2.
StressState AxisymmetricStress::on_axis(const Ball& z) const {
    const long bits = contact_.bits();
    const bool on_surface = z.is_exact() && contains_zero(z);
    if (on_surface && apex_) {
        throw DomainError("the stress is infinite at the apex of the profile");
    }
    const Ball w = z * z;
    const Ball A = on_surface ? on_axis_below(contact_.a()) : moment(w, 1);
    const Ball B = on_surface ? Ball(0, bits) : w * moment(w, 2);
    const Ball scale = contact_.modulus() / Ball::pi(bits);
    const Ball radial = scale * (B - A * (poisson_ + Ball(1, bits) / 2));
    return {radial, -scale * (A + B * 2), Ball(0, bits),
            scale * (A * (Ball(1, bits) / 2 - poisson_) + B * 3) / 2, radial};
}

// docs/axisymmetric.md, "Inside the body", with tau = z + i s and R^2 = r^2 + tau^2
StressState AxisymmetricStress::inside(const Ball& radius, const Ball& depth) const {
    const long bits = contact_.bits();
    const auto imaginary_part = [&](const auto& f) {
        const auto integrand = [&](const Box& s) {
            const Box tau = times_i(s) + depth;
            // The cuts of these roots leave the branch points s = +-r + i z at a right angle.
            const Box R = principal_root(times_i(s + radius) + depth) *
                          principal_root(times_i(s - radius) + depth);
            return -times_i(f(tau, R));
        };
        return of_revolution_ != nullptr
                   ? of_revolution_->over_approach(
                         [&](const Box& s, const Box&) { return integrand(s); })
                   : over_approach(*contact_.closed_form(), integrand);
    };
    const Box one(Ball(1, bits));
    const Ball I = imaginary_part([&](const Box&, const Box& R) { return one / R; });
    const Ball J = imaginary_part([&](const Box&, const Box& R) { return one / (R * R * R); });
    const Ball K =
        imaginary_part([](const Box& tau, const Box& R) { return tau / (R * R * R); }) * depth;
    const Ball L =
        imaginary_part([&](const Box& tau, const Box& R) { return one / (R * (R + tau)); }) * depth;
    const Ball M = imaginary_part([&](const Box& tau, const Box& R) { return one / (R + tau); }) *
                   (1 - poisson_ * 2);
    const Ball scale = contact_.modulus() / Ball::pi(bits);
    const Ball hoop = scale * (poisson_ * I * 2 - L + M);
    return {scale * (I - K + L - M), scale * (I + K), scale * depth * radius * J,
            scale * (-K * 2 + L - M) / 2, hoop};
}

// The force inside r is P - 2 E* times the integral of h'(s) sqrt(s^2 - r^2) over r < s < a.
StressState AxisymmetricStress::on_surface(const Ball& radius,
                                           const std::optional<Exact>& known) const {
    const long bits = contact_.bits();
    const Ball beyond = radius - contact_.a();
    const Ball pi = Ball::pi(bits);
    Ball p(0, bits);
    Ball inner = force_ / (pi * 2); // the integral of p r dr up to r
    if (!certainly_positive(beyond)) {
        const Ball& a = contact_.a();
        if (of_revolution_ != nullptr) {
            const Ball u = clamped(-beyond);
            p = known ? of_revolution_->pressure(Edge::right, u, *known)
                      : of_revolution_->pressure(Edge::right, u);
            inner -= contact_.modulus() / pi * of_revolution_->outer_moment(radius, known);
        } else {
            // (m + 2) times the integral is h'(a) a W - r^2 pi p/E*
            const Ball from_edge = clamped(-beyond);
            const Ball W = Field<Ball>::root(from_edge * (a + radius));
            p = contact_.pressure(Edge::right, from_edge);
            inner -=
                (contact_.modulus() / pi * rate_ * a * W - radius * radius * p) / (exponent_ + 2);
        }
        if (!p.is_finite() && !certainly_negative(beyond)) {
            return {p, p, Ball(0, bits), p, p};
        }
    }
    const Ball spread = (1 - poisson_ * 2) * inner / (radius * radius);
    return {spread - p, -p, Ball(0, bits), spread / 2, -spread - poisson_ * p * 2};
}

Ball AxisymmetricStress::shear(const Ball& z) const {
    const Ball w = z * z;
    return contact_.modulus() / (Ball::pi(z.bits()) * 2) *
           (moment(w, 1) * (Ball(1, z.bits()) / 2 - poisson_) + w * moment(w, 2) * 3);
}

Ball AxisymmetricStress::slope(const Ball& lo, const Ball& hi) const {
    return moment_between(lo, hi, 2) * (poisson_ * 2 + 5) -
           Ball::hull(lo, hi) * moment_between(lo, hi, 3) * 12;
}

/// A depth with the integrals there.
struct AxisymmetricStress::AxisPoint {
    Ball z;
    Ball w;
    Ball F1;
    Ball F2;
    Ball F3;
    Ball tau; ///< tau_max 2 pi/E*
};

// With D = (5 + 2 nu) F_2 - 12 z^2 F_3, d tau_max/dz = E* z D/(2 pi). Each F_n decreases with z.
AxisymmetricStress::Greatest AxisymmetricStress::greatest_on_axis() const {
    const long bits = contact_.bits();
    if (apex_) {
        throw DomainError("the stress is infinite at the apex of the profile");
    }
    const Ball& a = contact_.a();
    const Ball of_A = Ball(1, bits) / 2 - poisson_;
    const Ball of_D = poisson_ * 2 + 5;
    const auto at = [&](const Ball& depth) {
        const Ball z = middle(depth);
        const Ball w = z * z;
        AxisPoint p{z, w, moment(w, 1), moment(w, 2), moment(w, 3), Ball(0, bits)};
        p.tau = of_A * p.F1 + w * p.F2 * 3;
        return p;
    };
    // z^2 F_3/F_2 is a mean of z^2/(s^2 + z^2), so that D < 0 beyond this depth.
    const Ball deepest = upper_end(a * sqrt(of_D / (7 - poisson_ * 2))) * 2;
    const Ball on_surface = on_axis_below(a);
    struct Interval {
        std::optional<AxisPoint> lo; ///< nothing: z = 0
        AxisPoint hi;
        bool zero = false; ///< D has exactly one zero in it, and falls there
    };
    std::vector<Interval> open{{{}, at(deepest)}};
    Ball best = of_A * on_surface;
    Greatest found;
    const auto greatest = [&](const Interval& i) {
        const Ball hi2 = i.hi.w * 3;
        if (i.lo) {
            return of_A * i.lo->F1 + hi2 * i.lo->F2;
        }
        // s^2 z^2/(s^2 + z^2)^2 is at most 1/4, and at most z^2/s^2.
        const Ball S = middle(min(sqrt(i.hi.z * a), a));
        return of_A * on_surface + (on_axis_below(S) / 4 + i.hi.w / (S * S) * on_surface) * 3;
    };
    const auto slope_in = [&](const Interval& i) {
        return of_D * Ball::hull(i.lo->F2, i.hi.F2) -
               Ball::hull(i.lo->w, i.hi.w) * Ball::hull(i.lo->F3, i.hi.F3) * 12;
    };
    std::vector<Interval> next;
    while (!(open.size() == 1 && open.front().zero)) {
        next.clear();
        for (Interval& interval : open) {
            check_interruption();
            if (++found.intervals > most_intervals) {
                throw BudgetError("branch and bound does not decide at which depth tau_max on the "
                                  "axis is greatest");
            }
            if (certainly_less(greatest(interval), best)) {
                continue;
            }
            if (interval.lo) {
                if (!contains_zero(slope_in(interval))) {
                    continue; // tau_max has no maximum there
                }
                const Ball F4 = moment_between(interval.lo->w, interval.hi.w, 4);
                const Ball w = Ball::hull(interval.lo->w, interval.hi.w);
                const Ball F3 = Ball::hull(interval.lo->F3, interval.hi.F3);
                interval.zero = certainly_negative(w * F4 * 36 - F3 * (poisson_ * 4 + 22)) &&
                                certainly_positive(slope(interval.lo->w, interval.lo->w)) &&
                                certainly_negative(slope(interval.hi.w, interval.hi.w));
                if (interval.zero) {
                    next.push_back(std::move(interval));
                    continue;
                }
            }
            const AxisPoint middle_point =
                at(interval.lo ? sqrt(interval.lo->z * interval.hi.z) : interval.hi.z / 8);
            best = max(best, lower_end(middle_point.tau));
            next.push_back({interval.lo, middle_point});
            next.push_back({middle_point, interval.hi});
        }
        open.swap(next);
        if (open.empty()) {
            throw BudgetError("the bits do not suffice for the greatest tau_max on the axis");
        }
    }
    const Interval& one = open.front();
    const Ball w =
        isolate_zero([&](const Ball& x) { return slope(x, x); },
                     [&](const Ball& x) {
                         const Ball lo = lower_end(x);
                         const Ball hi = upper_end(x);
                         return Ball::hull(lo, hi) * moment_between(lo, hi, 4) * 36 -
                                moment_between(lo, hi, 3) * (poisson_ * 4 + 22);
                     },
                     middle(sqrt(one.lo->w * one.hi.w)), "the depth of the greatest tau_max");
    if (!certainly_less(one.lo->w, w) || !certainly_less(w, one.hi.w)) {
        throw BudgetError("the search for the depth of the greatest tau_max found another one");
    }
    found.z = sqrt(w);
    const Ball z = middle(found.z);
    const Ball change = contact_.modulus() / (Ball::pi(bits) * 2) * found.z *
                        slope(lower_end(w), upper_end(w)) * (found.z - z);
    found.value = shear(z) + Ball::hull(-change, change);
    return found;
}

} // namespace edgeproof::contact
