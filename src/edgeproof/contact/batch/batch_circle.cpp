// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/batch/batch_circle.hpp"

#include "edgeproof/precision/ball/ball.hpp"

#include <algorithm>
#include <cmath>
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

} // namespace edgeproof::contact
