// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/batch/batch_integral.hpp"

#include "edgeproof/contact/law/logarithmic_pressure.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/error.hpp"

/// The closed forms of the batch routes: poles close to a piece, and corners.
namespace edgeproof::contact {
namespace {

/// Returns ln(1 + x).
Real log_one_plus(const Real& x) {
    const long bits = mpfr_get_prec(raw(x)) + 8;
    Real r;
    const Ball l = log1p(Ball(x, bits));
    arf_get_mpfr(raw(r), arb_midref(l.data()), MPFR_RNDN);
    return r;
}

} // namespace

/// Returns the integral of d phi/|S - S_x| over a piece that does not contain x, from
///   dG/dv = w(x)/(w(v) (x - v)) (docs/pressure.md, "Closed form: piecewise linear slopes").
Real BatchIntegral::pole_integral(const BatchPiece& piece, const Task& task) {
    const CircleMark& near = task.above ? *piece.hi : *piece.lo;
    const CircleMark& far = task.above ? *piece.lo : *piece.hi;
    const bool far_is_end = task.above ? piece.at_left_edge : piece.at_right_edge;
    if (at_.left == 0) {
        // x is in the middle of a folded contact, at the left end of the circle:
        // the integral of d phi/S is (2/length) tan(phi/2).
        return Real(2 / circle_.length *
                    (near.root_right / near.root_left -
                     (far_is_end ? Real(0) : Real(far.root_right / far.root_left))));
    }
    const Real root_right = sqrt(at_.right);
    const Real root_left = sqrt(at_.left);
    const auto logarithm = [&](const CircleMark& m, const Real& gap) {
        const Real root = m.root_right * root_left * root_right * m.root_left;
        return log_one_plus(
            Real(green_excess(Real(m.right * at_.left), Real(at_.right * m.left), root) /
                 (circle_.length * gap)));
    };
    Real l = logarithm(near, task.gap);
    if (!far_is_end) {
        l -= logarithm(far, Real(task.gap + piece.span));
    }
    return Real(l / (root_right * root_left));
}

/// Returns the integral of d phi/(s + x) over a piece of a folded contact, which is twice that of
/// ds/(w (s + x)).
Real BatchIntegral::mirror_integral(const BatchPiece& piece) const {
    const Real a = at_working_precision(extent_.a);
    const Real length = 2 * a;
    const Real to_right = a + at_.x; // from -x
    const Real to_left = at_.right / to_right;
    const auto logarithm = [&](const CircleMark& m) {
        // The distances from both edges of the unfolded contact.
        const Real left = a + m.v;
        const Real right = m.right / left;
        const Real p = right * to_left;
        const Real q = to_right * left;
        return log_one_plus(Real(green_excess(p, q, Real(m.root_right * sqrt(at_.right))) /
                                 (length * (m.v + at_.x))));
    };
    Real l = logarithm(*piece.lo);
    if (!piece.at_right_edge) {
        l -= logarithm(*piece.hi);
    }
    return Real(2 * l / sqrt(at_.right));
}

/// Returns the sum of jump times G(x, v) over the corners (docs/pressure.md, "Closed form:
/// piecewise linear slopes").
Real BatchIntegral::corners(const Point<Real>& at) {
    Real sum(0);
    const Real right = at_working_precision(at.right);
    const Real left = at_working_precision(at.left);
    const Real length = at_working_precision(extent_.length());
    for (const Corner& corner : corners_) {
        const auto excess = [&](const Real& v_right, const Real& v_left) {
            const bool by_right = at.right < at.left;
            const Real gap = at_working_precision(abs(circle_.marks[corner.mark].v == 0 ? at.x
                                                      : by_right ? Real(v_right - at.right)
                                                                 : Real(v_left - at.left)));
            if (gap == 0) {
                throw DomainError("the pressure is infinite at a corner of the profile");
            }
            const Real p = at_working_precision(v_right * left);
            const Real q = at_working_precision(right * v_left);
            return Real(green_excess(p, q, Real(sqrt(p) * sqrt(q))) / (length * gap));
        };
        Real e = excess(corner.right, corner.left);
        if (corner.pair) {
            const Real other = excess(corner.left, corner.right);
            e = e + other + e * other;
        }
        sum += corner.jump * log_one_plus(e);
    }
    return sum;
}

} // namespace edgeproof::contact
