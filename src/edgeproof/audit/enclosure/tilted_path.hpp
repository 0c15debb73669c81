// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"

#include <cmath>

namespace edgeproof::audit {

/// The contacts of a tilted flat and rounded punch whose left edge is beyond the right arc. Each is
/// given by an angle in which all quantities are analytic, although they are not analytic in the
/// right edge s. With the middle c, the half-length d, and v = c + d cos h for a point, the right
/// end of the flat is at h = pi - eta, and its left end, if the contact reaches it, is at
/// h = pi - kappa. With r := R alpha,
///     s = d (1 + cos eta) - r,   b(s) = d (1 - cos eta) + r,
///     P'(s) = (E* d/2R)(sin eta + pi - eta + kappa - sin kappa),
/// and moore-hills.tex eqn:Consistency becomes
///     on the flat (kappa = 0):   d (sin eta + (pi - eta) cos eta) = pi r,
///     on the left arc:           d (cos kappa - cos eta) = 2 t, and
///         sin eta + (pi - eta) cos eta - sin kappa + kappa cos kappa = mu (cos kappa - cos eta),
/// mu = pi r/(2 t), whose eta is enclosed by the interval form of Newton's method.
class TiltedPath {
public:
    enum class LeftEdge { on_flat, on_left_arc };

    /// The angle is eta on the flat and kappa on the left arc. Both increase with s from 0; the
    /// left arc begins where eta is end_of_flat().
    TiltedPath(LeftEdge left_edge, const Ball& r, const Ball& t, const Ball& R, const Ball& modulus)
        : left_edge_(left_edge), r_(r), t_(t), mu_(Ball::pi(r.bits()) * r / (t * 2)),
          rate_(modulus / (R * 2)), pi_(Ball::pi(r.bits())) {}

    struct Point {
        Box s;
        Box b;
        Box rate; ///< P'
        Box ds;   ///< by the angle
        Box db;
    };
    /// For every angle in the box, which must meet the real axis; not finite without an enclosure.
    [[nodiscard]] Point at(const Box& angle) const {
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
    [[nodiscard]] Ball end_of_flat() const { return eta_at(Box(Ball(0, r_.bits()))).real(); }
    /// Returns the angle of the contact with these edges, in this part of the path.
    [[nodiscard]] Ball angle_of(const Ball& a, const Ball& b) const {
        const Ball v = left_edge_ == LeftEdge::on_flat ? -r_ : -(r_ + t_ * 2);
        return atan(sqrt((b + v) / (a - v))) * 2;
    }

private:
    struct SinCos {
        Box sin;
        Box cos;
        explicit SinCos(const Box& z) : sin(z.bits()), cos(z.bits()) {
            acb_sin_cos(sin.get(), cos.get(), z.get(), z.bits());
        }
    };
    /// Finds the root in (kappa, pi) by bisection in binary64, as a starting point that proves
    /// nothing.
    [[nodiscard]] static double rough_eta(double kappa, double mu) {
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
    /// Applies the interval form of Newton's method for each kappa of the box. The box of eta is
    /// symmetric about the real axis, so that for a real kappa the only root in it is real. This
    /// root is the right one, as the equation is monotone in eta between 0 and pi.
    [[nodiscard]] Box eta_at(const Box& kappa) const {
        const long bits = kappa.bits();
        if (!kappa.is_finite() || !kappa.may_be_real()) {
            return contact::unknown_box(bits);
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
        Box image = contact::unknown_box(bits);
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
    LeftEdge left_edge_;
    Ball r_;
    Ball t_;
    Ball mu_;
    Ball rate_; ///< E*/(2R)
    Ball pi_;
};

} // namespace edgeproof::audit
