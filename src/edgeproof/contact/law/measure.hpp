// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/profile/slope.hpp"
#include "edgeproof/quadrature/near_singularity.hpp"

#include <cstddef>

namespace edgeproof::contact {

/// The part of the contact over which an integral over dg' extends.
enum class Part { all, left_of_origin, right_of_origin };

template <class U> struct LeadingTerm {
    static const U& of(const U& x) { return x; }
};
template <class T> struct LeadingTerm<series::Series<T>> {
    static const T& of(const series::Series<T>& x) { return x[0]; }
};

/// A kernel of kernels.hpp as three function pointers, so that integrate_measure is compiled once
/// for all kernels.
template <class T, class U> struct MeasureKernel {
    U (*at_knot)(const Extent<U>&, const Mark<U>&, const T& weight);
    U (*at)(const Extent<U>&, const Mark<U>&, const U& weight);
    U (*between)(const Extent<U>&, const Mark<U>&, const Mark<U>&);
};
template <class T, class U, class Kernel> [[nodiscard]] MeasureKernel<T, U> measure_kernel() {
    return {&Kernel::template at<U, T>, &Kernel::template at<U, U>, &Kernel::template between<U>};
}

/// The integral of kernel(v) dg'(v) over the contact or a part of it (docs/mechanics.md, "One
/// measure, six kernels"): corners and pieces with constant g'' in closed form, other pieces by
/// quadrature to `target_digits` (0: to roundoff). U is T, or Series<T> for derivatives of any
/// order with respect to a (b is then a function of a). `marks` are those of the extent.
/// `evaluations` counts the evaluations of the integrand.
template <Arithmetic T, class U>
U integrate_measure(const MeasureKernel<T, U>& kernel, const SlopeIn<T>& slope, Marks<T, U>& marks,
                    Part part, bool symmetric, unsigned target_digits, std::size_t* evaluations) {
    const auto& knots = slope.knots();
    const Extent<U>& e = marks.extent();
    const T a0 = LeadingTerm<U>::of(e.a);
    const T b0 = LeadingTerm<U>::of(e.b);
    U sum = e.a * T(0);

    // A corner at the origin belongs to both sides: g'(0+) to the right, -g'(0-) to the left.
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const bool inside = knots[i] < a0 && -knots[i] < b0;
        if (!inside || slope.jump(i) == T(0)) {
            continue;
        }
        T weight = slope.jump(i);
        if (part != Part::all && i == slope.origin()) {
            weight = part == Part::right_of_origin ? slope.value(i + 1, knots[i])
                                                   : T(-slope.value(i, knots[i]));
        } else if ((part == Part::right_of_origin && i < slope.origin()) ||
                   (part == Part::left_of_origin && i > slope.origin())) {
            continue;
        }
        sum += kernel.at_knot(e, marks.at(i), weight);
    }

    for (std::size_t i = 0; i <= knots.size(); ++i) {
        if ((part == Part::right_of_origin && i <= slope.origin()) ||
            (part == Part::left_of_origin && i > slope.origin())) {
            continue;
        }
        // If an edge lies exactly on a knot, only the piece inside the contact counts: p does not
        // depend on g' beyond the edge, so that the one-sided derivatives are the right ones.
        const bool from_left_edge = i == 0 || !(-knots[i - 1] < b0);
        const bool to_right_edge = i == knots.size() || !(knots[i] < a0);
        if ((i > 0 && !(knots[i - 1] < a0)) || (i < knots.size() && !(-knots[i] < b0))) {
            continue;
        }
        const auto& piece = slope.pieces()[i];
        if (piece.linear && piece.rate == T(0)) {
            continue;
        }
        if (piece.linear) {
            const Mark<U> m = from_left_edge ? left_end(e) : marks.at(i - 1);
            const Mark<U> n = to_right_edge ? right_end(e) : marks.at(i);
            sum += kernel.between(e, m, n) * piece.rate;
            continue;
        }
        // The ends of the piece move with the edges: v = lo + (hi - lo) r, with exact distances
        // from both ends.
        const U lo = from_left_edge ? U(-e.b) : U(e.a * T(0) + knots[i - 1]);
        const U hi = to_right_edge ? e.a : U(e.a * T(0) + knots[i]);
        const U extent = hi - lo;
        const U beyond_right = to_right_edge ? U(e.a * T(0)) : U(e.a - knots[i]);
        const U beyond_left = from_left_edge ? U(e.a * T(0)) : U(e.b + knots[i - 1]);
        const T length = LeadingTerm<U>::of(extent);
        // In a symmetric contact the left half is the mirror image of the right half.
        const bool fold = symmetric && part == Part::all;
        if (fold && i <= slope.origin()) {
            continue;
        }
        const auto f = [&](const T& r_lo, const T& r_hi) {
            // r runs over the leading length of the piece; the fraction r/length applies to the
            // moving length.
            const U from_lo = extent * T(r_lo / length);
            const U from_hi = extent * T(r_hi / length);
            const U left = beyond_left + from_lo;
            const U right = beyond_right + from_hi;
            const Mark<U> m = mark_between(right, left);
            // Near an end that is the origin, v itself is the small distance.
            const U v = i == slope.origin()       ? U(-from_hi)
                        : i == slope.origin() + 1 ? from_lo
                                                  : U(lo + from_lo);
            // The rate in the distance from the nearer end, if that end is a knot.
            const bool by_left = to_right_edge || (!from_left_edge && r_lo < r_hi);
            const U rate = by_left && from_left_edge ? slope.template rate<U>(i, v)
                           : by_left                 ? slope.template rate<U>(i, v, i - 1, from_lo)
                                                     : slope.template rate<U>(i, v, i, U(-from_hi));
            const U weight = rate * U(extent / length);
            U sample = kernel.at(e, m, weight);
            if (fold) {
                sample += kernel.at(
                    e, Mark<U>{m.left, m.right, U(-m.y), m.w, U(Field<U>::pi(m.h) - m.h)}, weight);
            }
            return sample;
        };
        const auto result = quadrature::integrate_near<T>(
            f, length, LeadingTerm<U>::of(beyond_left), LeadingTerm<U>::of(beyond_right),
            {.target_digits = target_digits});
        if (!result.converged) {
            throw BudgetError("the quadrature over a piece of g' did not converge");
        }
        if (evaluations != nullptr) {
            *evaluations += result.evaluations;
        }
        sum += result.value;
    }
    return sum;
}

} // namespace edgeproof::contact
