// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/axisymmetric_stress.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/interval_maximum.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <map>
#include <optional>
#include <utility>

namespace edgeproof::contact {
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

/// tau_max on the axis as a function of w = z^2 (docs/axisymmetric.md, "Stresses"), where each F_n
/// decreases with w.
class AxisymmetricStress::ShearOnAxis {
public:
    explicit ShearOnAxis(const AxisymmetricStress& stress)
        : stress_(stress), nu_(stress.poisson_), a_(stress.contact_.a()),
          scale_(stress.contact_.modulus() / (Ball::pi(bits()) * 2)),
          on_surface_(stress.on_axis_below(a_)) {}
    [[nodiscard]] long bits() const { return stress_.contact_.bits(); }
    /// tau_max falls beyond this depth, since z^2 F_3/F_2 is a mean of z^2/(s^2 + z^2).
    [[nodiscard]] Rational end() const {
        return exact_value(Ball(a_ * a_ * (nu_ * 2 + 5) / (7 - nu_ * 2) * 2).upper());
    }
    [[nodiscard]] Ball value(const Ball& w) const {
        return scale_ * (of_A() * F(1, w) + w * F(2, w) * 3);
    }
    [[nodiscard]] Ball slope(const Ball& w) const {
        return scale_ / 2 * (F(2, w) * (nu_ * 2 + 5) - w * F(3, w) * 12);
    }
    [[nodiscard]] Ball bend(const Ball& w) const {
        return scale_ / 2 * (w * F(4, w) * 36 - F(3, w) * (nu_ * 4 + 22));
    }
    [[nodiscard]] Ball bound(const Rational& lo, const Rational& hi) const {
        const Ball w(hi, bits());
        if (lo > 0) {
            const Ball from(lo, bits());
            return scale_ * (of_A() * F(1, from) + w * F(2, from) * 3);
        }
        // s^2 z^2/(s^2 + z^2)^2 is at most 1/4, and at most z^2/s^2.
        const Ball S = middle(min(sqrt(sqrt(w) * a_), a_));
        return scale_ * (of_A() * on_surface_ +
                         (stress_.on_axis_below(S) / 4 + w / (S * S) * on_surface_) * 3);
    }
    [[nodiscard]] Rational between(const Rational& lo, const Rational& hi) const {
        return lo > 0
                   ? exact_value(sqrt(Ball(lo, bits()) * Ball(hi, bits())).with_bits(53).midpoint())
                   : Rational(hi / 64);
    }
    [[nodiscard]] bool count() const {
        check_interruption();
        return ++counted_ < most_evaluations;
    }

private:
    static constexpr std::size_t most_evaluations = 2000;

    [[nodiscard]] Ball of_A() const { return Ball(1, bits()) / 2 - nu_; }
    /// F_n; those of exact places are kept.
    [[nodiscard]] Ball F(long n, const Ball& w) const {
        if (!w.is_exact()) {
            return Ball::hull(F(n, lower_end(w)), F(n, upper_end(w)));
        }
        if (!certainly_positive(w)) {
            return unknown_ball(bits());
        }
        std::optional<Ball>& known = known_[{n, w.midpoint()}];
        if (!known) {
            known = stress_.moment(w, n);
        }
        return *known;
    }

    const AxisymmetricStress& stress_;
    Ball nu_;
    Ball a_;
    Ball scale_;
    Ball on_surface_;
    mutable std::map<std::pair<long, Real>, std::optional<Ball>> known_;
    mutable std::size_t counted_ = 0;
};

AxisymmetricStress::Greatest AxisymmetricStress::greatest_on_axis() const {
    if (apex_) {
        throw DomainError("the stress is infinite at the apex of the profile");
    }
    const ShearOnAxis shear(*this);
    const IntervalMaximum found = greatest_on_interval(shear, shear.end(), 1);
    if (!found.place) {
        throw BudgetError("branch and bound does not decide at which depth tau_max on the axis is "
                          "greatest");
    }
    return {sqrt(*found.place), found.value, found.intervals};
}

} // namespace edgeproof::contact
