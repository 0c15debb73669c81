// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/batch/batch_piece.hpp"

#include "edgeproof/formula/evaluation/complex_taylor.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/ball/acb_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/gauss_legendre.hpp"
#include "edgeproof/quadrature/tanh_sinh_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace edgeproof::contact {

namespace {

/// Returns the mark of v with its distances (length, or length^2 in a folded contact).
CircleMark marked(const Real& v, const Real& inset, const Real& right, const Real& left) {
    CircleMark m;
    m.v = at_working_precision(v);
    m.inset = inset;
    m.right = at_working_precision(right);
    m.left = at_working_precision(left);
    m.root_right = sqrt(m.right);
    m.root_left = sqrt(m.left);
    return m;
}

Real middle_of(const Ball& x) {
    if (!x.is_finite()) {
        throw DomainError("g' has no finite value in the contact");
    }
    return at_working_precision(x.midpoint());
}

} // namespace

BatchCircle::BatchCircle(const Profile& profile, const Extent<Real>& e)
    : folded(profile.symmetric()) {
    const auto smooth = [&](std::size_t i) {
        return !profile.has_corner(i) && profile.pieces()[i].slope == profile.pieces()[i + 1].slope;
    };
    const unsigned fine = std::max(working_digits(), e.a.precision());
    const Real whole = [&] {
        const PrecisionScope scope(fine);
        return folded ? Real(e.a * e.a) : Real(e.a + e.b);
    }();
    length = at_working_precision(whole);
    marks.push_back(marked(folded ? Real(0) : Real(-e.b), folded ? e.a : whole, whole, Real(0)));
    knots.push_back(0);
    std::size_t piece = folded ? profile.origin() + 1 : 0;
    for (std::size_t i = piece; i < profile.knots().size(); ++i) {
        Real v;
        Real inset;
        Real right;
        Real left;
        {
            const PrecisionScope scope(fine);
            v = profile.knots()[i].to<Real>();
            inset = e.a - v;
            right = folded ? Real(inset * (e.a + v)) : inset;
            left = folded ? Real(v * v) : Real(v + e.b);
        }
        if (!(left > 0)) {
            piece = i + 1;
            continue;
        }
        if (!(right > 0)) {
            break;
        }
        // If g' has the same formula on both sides, the knot is no end of a piece.
        if (!smooth(i)) {
            pieces.push_back(piece);
            marks.push_back(marked(v, inset, right, left));
            knots.push_back(i);
        }
        piece = i + 1;
    }
    pieces.push_back(piece);
    marks.push_back(marked(e.a, Real(0), Real(0), whole));
    knots.push_back(0);
}

Real angle_between(const Real& length, const CircleMark& left, const CircleMark& right,
                   const Real& gap) {
    // tan(angle/2) = (z_l - z_r)/(1 + z_l z_r) with z = tan(phi/2) = sqrt(right/left) (DLMF
    // 4.21.4). The difference is replaced by right_l left_r - right_r left_l = length gap.
    const Real upper = length * gap;
    const Real lower = (left.root_right * right.root_left + right.root_right * left.root_left) *
                       (left.root_left * right.root_left + left.root_right * right.root_right);
    return 2 * atan2(upper, lower);
}

void sine_and_cosine(Real& sine, Real& cosine, const Real& x) {
    const long bits = mpfr_get_prec(sine.backend().data()) + 8;
    const Ball angle(x, bits);
    Ball s(0, bits);
    Ball c(0, bits);
    arb_sin_cos(s.data(), c.data(), angle.data(), bits);
    arf_get_mpfr(sine.backend().data(), arb_midref(s.data()), MPFR_RNDN);
    arf_get_mpfr(cosine.backend().data(), arb_midref(c.data()), MPFR_RNDN);
}

double in_units(const Real& x, long exponent) {
    if (x == 0) {
        return 0;
    }
    long e = 0;
    const double mantissa = mpfr_get_d_2exp(&e, x.backend().data(), MPFR_RNDN);
    return std::ldexp(mantissa, static_cast<int>(std::clamp(e - exponent, -3000L, 3000L)));
}

long exponent_of(const Real& x) {
    return x == 0 ? 0 : static_cast<long>(mpfr_get_exp(x.backend().data()));
}

CurvedSlope::CurvedSlope(const SlopeIn<Real>& slopes, std::size_t piece, const Ball& corners,
                         bool folded, long bits)
    : slopes_(&slopes), piece_(piece), slope_(slopes.pieces()[piece].expression),
      program_(slope_, {"x"}),
      constants_(constants_of<Ball>(program_, formula::BallConstants{bits})), corners_(corners),
      folded_(folded) {}

Real CurvedSlope::quotient(const Real& v, const Real& s, const Real& delta) const {
    return slopes_->quotient(piece_, v, s, delta);
}

Ball CurvedSlope::G(const Ball& s) const {
    const std::array<Ball, 1> x{s.with_bits(corners_.bits())};
    const Ball g = run<Ball>(program_, x, constants_) - corners_;
    return folded_ ? x[0] * g : g;
}

BatchPiece::BatchPiece(const BatchCircle& circle, std::size_t index, Real a, Real b,
                       std::unique_ptr<CurvedSlope> curve, bool odd)
    : folded(circle.folded), flat(!curve && a == 0 && b == 0), at_left_edge(index == 0),
      at_right_edge(index + 2 == circle.marks.size()), alpha(std::move(a)), beta(std::move(b)),
      curved(std::move(curve)), lo(&circle.marks[index]), hi(&circle.marks[index + 1]),
      circle_length_(circle.length) {
    // At the middle of a folded contact G is even only if the expression of g' is odd there.
    even_left = at_left_edge && (!folded || odd || (!curved && alpha == 0));
    doubled = at_right_edge || even_left;
    // One difference of each pair cancels; the other is accurate.
    span = lo->right < hi->left ? Real(lo->right - hi->right) : Real(hi->left - lo->left);
    width = folded ? Real(span / (hi->v + lo->v)) : span;
    angle = angle_between(circle.length, *lo, *hi, span);
    phi_hi = 2 * atan2(hi->root_right, hi->root_left);
    // sin(phi) = 2 sqrt(right left)/length, cos(phi) = (left - right)/length.
    sine_hi_ = 2 * hi->root_right * hi->root_left / circle.length;
    cosine_hi_ = (hi->left - hi->right) / circle.length;
    sine_lo_ = 2 * lo->root_right * lo->root_left / circle.length;
    cosine_lo_ = (lo->right - lo->left) / circle.length;
    if (curved) {
        G_lo_ = curved->G(Ball(lo->v, 64));
        G_hi_ = curved->G(Ball(hi->v, 64));
    }
    rise = rise_to_hi(lo->v, width);
}

void BatchPiece::measure(long S_exponent, long G_exponent) {
    angle_double = static_cast<double>(angle);
    phi_right = static_cast<double>(phi_hi);
    span_units = in_units(span, S_exponent);
    rise_units = in_units(rise, G_exponent);
    alpha_units = in_units(Real(abs(alpha) * sqrt(circle_length_)), G_exponent);
    beta_units = in_units(beta, G_exponent - S_exponent);
    length_units_ = in_units(circle_length_, S_exponent);
}

double BatchPiece::largest_rise(const quadrature::BernsteinEllipse& ellipse) const {
    if (reach) {
        return 2 * std::exp(reach->ln_bound);
    }
    // |cos phi - cos phi_v| = 2 |sin((phi - phi_v)/2) sin((phi + phi_v)/2)| (DLMF 4.21.9), where
    // |sin z| is at most cosh Im z and at most sinh |z| (DLMF 4.18.5, 4.18.9).
    const double y = ellipse.height();
    const double across = 2 * ellipse.half + ellipse.excess() + y;
    const double sum = std::min(across + 2 * (phi_right + angle_double),
                                across + 2 * (std::numbers::pi - phi_right));
    const double S = length_units_ * std::min(std::cosh(y / 2), std::sinh(across / 2)) *
                     std::min(std::cosh(y / 2), std::sinh(sum / 2));
    const double s = 2 * std::cosh(y / 4) * std::min(std::cosh(y / 4), std::sinh(across / 4));
    return beta_units * S + (folded ? alpha_units * s : 0);
}

void BatchPiece::find_reach(long G_exponent, double ln_tolerance) {
    constexpr long low = 64;
    const Ball middle_angle(Real(phi_hi + angle / 2), low);
    const Ball half(Real(circle_length_ / 2), low);
    const Ball whole(circle_length_, low);
    // The left end of the circle is s = -b, or s = 0 in a folded contact.
    const Ball left(Real(lo->v - lo->left), low);
    const auto s_of = [&](acb_t s, const acb_t phi) {
        if (folded) {
            acb_mul_2exp_si(s, phi, -1);
            acb_cos(s, s, low);
            acb_mul_arb(s, s, sqrt(whole).data(), low);
        } else {
            acb_cos(s, phi, low);
            acb_add_ui(s, s, 1, low);
            acb_mul_arb(s, s, half.data(), low);
            acb_add_arb(s, s, left.data(), low);
        }
    };
    AcbPolyValue taylor;
    AcbValue s;
    AcbValue middle;
    const Ball corners = curved->corners();
    const auto G = [&](acb_t out, const acb_t phi) {
        s_of(s, phi);
        complex_taylor(taylor, curved->slope(), s, 1, low);
        acb_poly_get_coeff_acb(out, taylor, 0);
        acb_sub_arb(out, out, corners.data(), low);
        if (folded) {
            acb_mul(out, out, s, low);
        }
    };
    AcbValue at;
    acb_set_arb(at, middle_angle.data());
    G(middle, at);
    const double centre =
        doubled ? (at_right_edge ? 0.0 : std::numbers::pi) : phi_right + angle_double / 2;
    const double half_length = doubled ? angle_double : angle_double / 2;
    // The ellipse must not contain the mirror image of a point of the piece.
    double most = 1e9;
    if (!at_right_edge) {
        most = std::min(most, 0.9 * phi_right);
    }
    if (!at_left_edge) {
        most = std::min(most, 0.9 * (std::numbers::pi - phi_right - angle_double));
    }
    // At an apex where G is not even, the image of x is a pole, as close to the apex as x is.
    if (has_complex_taylor(curved->slope()) && (even_left || !at_left_edge)) {
        reach = quadrature::holomorphic_reach(
            [&](acb_t out, const acb_t phi) {
                G(out, phi);
                acb_sub(out, out, middle, low);
                acb_mul_2exp_si(out, out, -G_exponent);
            },
            centre, half_length, most, ln_tolerance);
    }
}

Real BatchPiece::rise_from_lo(const Real& x, const Real& step) const {
    if (curved) {
        return curved_rise(lo->v, G_lo_, x, step);
    }
    return folded ? Real(step * (alpha + beta * (x + lo->v))) : Real(beta * step);
}

Real BatchPiece::rise_to_hi(const Real& x, const Real& step) const {
    if (curved) {
        return -curved_rise(hi->v, G_hi_, x, Real(-step));
    }
    return folded ? Real(step * (alpha + beta * (x + hi->v))) : Real(beta * step);
}

Real BatchPiece::curved_rise(const Real& v, const Ball& G_v, const Real& x,
                             const Real& step) const {
    if (abs(step) * 1024 > width) {
        return middle_of(curved->G(Ball(x, 64)) - G_v);
    }
    // Near the end of the piece a divided difference is accurate:
    //   s g(s) - v g(v) = (s - v) (g(v) + s (g(s) - g(v))/(s - v)).
    const Real q = curved->quotient(v, x, step);
    if (!folded) {
        return step * q;
    }
    return step * (v == 0 ? Real(x * q) : Real(middle_of(G_v) / v + x * q));
}

void BatchPiece::add(BatchNodes& nodes, const Real& from_hi, const Real& from_lo,
                     const Real& weight) const {
    Real sine;
    Real cosine;
    // S_hi - S = 2 h sin(phi_hi + psi/2) sin(psi/2) (DLMF 4.21.9).
    sine_and_cosine(sine, cosine, Real(from_hi / 2));
    nodes.from_hi.push_back(circle_length_ * (sine_hi_ * cosine + cosine_hi_ * sine) * sine);
    sine_and_cosine(sine, cosine, Real(from_lo / 2));
    nodes.from_lo.push_back(circle_length_ * (sine_lo_ * cosine + cosine_lo_ * sine) * sine);
    nodes.weight.push_back(weight);
    const Real& near_lo = nodes.from_lo.back();
    const Real& near_hi = nodes.from_hi.back();
    const Real s = folded ? Real(sqrt(lo->left + near_lo)) : Real(lo->v + near_lo);
    if (folded) {
        nodes.s.push_back(s);
    }
    if (flat) {
        return;
    }
    nodes.rise_lo.push_back(rise_from_lo(s, folded ? Real(near_lo / (s + lo->v)) : near_lo));
    nodes.rise_hi.push_back(rise_to_hi(s, folded ? Real(near_hi / (s + hi->v)) : near_hi));
    nodes.lift_lo.push_back(weight * nodes.rise_lo.back());
    nodes.lift_hi.push_back(weight * nodes.rise_hi.back());
}

const BatchNodes& BatchPiece::gauss(std::size_t n) const {
    const auto known = gauss_.find(n);
    if (known != gauss_.end()) {
        return known->second;
    }
    const long bits = mpfr_get_prec(angle.backend().data());
    const auto rule = quadrature::gauss_legendre_rule(rule_size(n), bits);
    BatchNodes& nodes = gauss_[n];
    for (std::size_t k = 0; k < rule.x.size(); ++k) {
        const Real& x = rule.x[k];
        const Real& rest = rule.from_end[k];
        if (doubled) {
            // x runs from the edge of the contact inwards.
            const Real near = angle * x;
            const Real far = angle * rest;
            const Real weight = angle * rule.weight[k];
            at_right_edge ? add(nodes, near, far, weight) : add(nodes, far, near, weight);
            continue;
        }
        const Real near = angle * rest / 2;
        const Real far = angle * (1 + x) / 2;
        const Real weight = angle * rule.weight[k] / 2;
        add(nodes, near, far, weight);
        if (x != 0) {
            add(nodes, far, near, weight);
        }
    }
    return nodes;
}

const BatchNodes& BatchPiece::level(int level) const {
    const auto known = levels_.find(level);
    if (known != levels_.end()) {
        return known->second;
    }
    BatchNodes& nodes = levels_[level];
    // The integrand is bounded in phi: nodes closer to an end than roundoff contribute nothing.
    const Real least = pow(Real(10), -static_cast<int>(working_digits()) - 2);
    const auto table = quadrature::tanh_sinh_nodes<Real>();
    for (const auto& node : table->level(level)) {
        if (node.near < least) {
            break;
        }
        const Real near = angle * node.near;
        const Real far = angle * node.far;
        const Real weight = angle * node.weight;
        add(nodes, near, far, weight);
        if (node.t != 0) {
            add(nodes, far, near, weight);
        }
    }
    return nodes;
}

} // namespace edgeproof::contact
