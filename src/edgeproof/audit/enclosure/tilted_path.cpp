// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/tilted_path.hpp"

#include <cmath>

namespace edgeproof::audit {
namespace {

struct SinCos {
    Box sin;
    Box cos;
    explicit SinCos(const Box& z) : sin(z.bits()), cos(z.bits()) {
        acb_sin_cos(sin.get(), cos.get(), z.get(), z.bits());
    }
};

Box nowhere(long bits) {
    Box z(bits);
    acb_indeterminate(z.get());
    return z;
}

/// Finds the root in (kappa, pi) by bisection in binary64, as a starting point that proves nothing.
double rough_eta(double kappa, double mu) {
    const double pi = std::acos(-1.0);
    const double fixed = -std::sin(kappa) + kappa * std::cos(kappa) - mu * std::cos(kappa);
    double lo = kappa;
    double hi = pi;
    for (int k = 0; k < 56; ++k) {
        const double eta = (lo + hi) / 2;
        const double f = std::sin(eta) + (pi - eta + mu) * std::cos(eta) + fixed;
        (f > 0 ? lo : hi) = eta;
    }
    return (lo + hi) / 2;
}

} // namespace

TiltedPath::TiltedPath(LeftEdge left_edge, const Ball& r, const Ball& t, const Ball& R,
                       const Ball& modulus)
    : left_edge_(left_edge), r_(r), t_(t), mu_(Ball::pi(r.bits()) * r / (t * 2)),
      rate_(modulus / (R * 2)), pi_(Ball::pi(r.bits())) {}

/// Applies the interval form of Newton's method for each kappa of the box. The box of eta is
/// symmetric about the real axis, so that for a real kappa the only root in it is real. This root
/// is the right one, as the equation is monotone in eta between 0 and pi.
Box TiltedPath::eta_at(const Box& kappa) const {
    const long bits = kappa.bits();
    if (!kappa.is_finite() || !kappa.may_be_real()) {
        return nowhere(bits);
    }
    const Box near(kappa.middle().real());
    const auto fixed_part = [&](const Box& k) {
        const SinCos f(k);
        return k * f.cos - f.sin - f.cos * mu_;
    };
    const auto value = [&](const Box& eta, const Box& fixed) {
        const SinCos f(eta);
        return f.sin + (pi_ + mu_ - eta) * f.cos + fixed;
    };
    const auto rate = [&](const Box& eta) { return -((pi_ + mu_ - eta) * SinCos(eta).sin); };
    const double start = rough_eta(arf_get_d(arb_midref(acb_realref(near.get())), ARF_RND_NEAR),
                                   arf_get_d(arb_midref(mu_.data()), ARF_RND_NEAR));
    Box eta(bits);
    acb_set_d(eta.get(), start);
    const Box near_fixed = fixed_part(near);
    for (long good = 40; good < 2 * bits; good *= 2) {
        eta = (eta - value(eta, near_fixed) / rate(eta)).middle();
    }
    const Box residual = value(eta, fixed_part(kappa));
    const Box step = residual / rate(eta);
    MagValue radius;
    acb_get_mag(radius, step.get());
    Box image = nowhere(bits);
    for (int k = 0; k < 4; ++k) {
        mag_mul_2exp_si(radius, radius, 1);
        Box candidate(eta);
        acb_add_error_mag(candidate.get(), radius);
        const Box next = eta - residual / rate(candidate);
        const Ball re = candidate.real();
        if (next.is_finite() && acb_contains_interior(candidate.get(), next.get()) != 0 &&
            certainly_positive(re) && certainly_less(re, pi_)) {
            image = next;
            break;
        }
    }
    return image;
}

TiltedPath::Point TiltedPath::at(const Box& angle) const {
    const long bits = angle.bits();
    const bool flat = left_edge_ == LeftEdge::on_flat;
    const Box zero(bits);
    const Box eta = flat ? angle : eta_at(angle);
    const Box kappa = flat ? zero : angle;
    const SinCos e(eta);
    const SinCos k(kappa);
    const Box beyond = pi_ - eta;
    const Box spread = k.cos - e.cos;
    // Either condition gives the half-length.
    const Box balance = e.sin + beyond * e.cos;
    const Box d = flat ? Box(pi_ * r_) / balance : Box(t_ * 2) / spread;
    const Box arcs = beyond + kappa;
    const Box sines = e.sin - k.sin;
    // This follows by differentiation of both conditions.
    const Box common = flat ? d * e.sin / balance : d * k.sin / ((beyond + mu_) * spread);
    return {d * (e.cos + 1) - r_, d * (-(e.cos) + 1) + r_, d * (arcs + sines) * rate_,
            common * (arcs - sines), common * (arcs + sines)};
}

Ball TiltedPath::end_of_flat() const { return eta_at(Box(Ball(0, r_.bits()))).real(); }

Ball TiltedPath::angle_of(const Ball& a, const Ball& b) const {
    const Ball v = left_edge_ == LeftEdge::on_flat ? -r_ : -(r_ + t_ * 2);
    return atan(sqrt((b + v) / (a - v))) * 2;
}

} // namespace edgeproof::audit
