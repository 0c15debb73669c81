// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/law/field.hpp"
#include "edgeproof/contact/profile/edge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

/// Every quantity of the normal contact is an integral over the measure dg'(v), which is positive
/// because g' does not decrease: P, M, P'(a), dP/db, the consistency condition and p(x) differ only
/// in the kernel. docs/mechanics.md, "One measure, six kernels", derives them from moore-hills EQ20
/// and EQ22 by one integration by parts; the boundary terms vanish by the consistency condition
/// (EQ20). No kernel changes sign, so that no sum cancels. Each kernel below is a row of the table
/// there.
///
/// The kernels apply to every field (field.hpp). In balls the radius depends on the order of the
/// operations: do not change it.
namespace edgeproof::contact {

/// The extent -b < x < a (lengths). U is a number, or a power series where a and b move.
template <class U> struct Extent {
    U a;
    U b;
    [[nodiscard]] U length() const { return a + b; }
};

/// A point v of the contact in the variables of the kernels; all are lengths except the angle h.
template <class U> struct Mark {
    U right;                      ///< a - v
    U left;                       ///< v + b
    U y;                          ///< v - c, with c = (a - b)/2 the middle of the contact
    U w;                          ///< sqrt((a - v)(v + b))
    U h;                          ///< integral from v to a of ds/w(s), between 0 and pi
    std::optional<Edge> end = {}; ///< set if v is at this edge, or certainly beyond it
};

/// The mark at the distances a - v and v + b from the edges.
template <class U> [[nodiscard]] Mark<U> mark_between(const U& right, const U& left) {
    using F = Field<U>;
    return {right, left, F::over(U(left - right), 2), F::root(U(right * left)),
            F::angle(right, left)};
}
/// The mark of the place v of the contact e.
template <class U, class V> [[nodiscard]] Mark<U> mark(const Extent<U>& e, const V& v) {
    return mark_between<U>(U(e.a - v), U(e.b + v));
}
template <class U> [[nodiscard]] Mark<U> right_end(const Extent<U>& e) {
    const U zero = Field<U>::number(0, e.a);
    return {zero, e.length(), Field<U>::over(e.length(), 2), zero, zero, Edge::right};
}
template <class U> [[nodiscard]] Mark<U> left_end(const Extent<U>& e) {
    const U zero = Field<U>::number(0, e.a);
    return {e.length(),        zero,      U(-Field<U>::over(e.length(), 2)), zero,
            Field<U>::pi(e.a), Edge::left};
}
template <class U> [[nodiscard]] Mark<U> end_mark(const Extent<U>& e, Edge edge) {
    return edge == Edge::right ? right_end(e) : left_end(e);
}

/// A kernel phi has two functions: `at` is weight phi(v) at a mark (for corners), `between` is the
/// integral of phi between two marks (for pieces on which g'' is constant). `e` is the extent.
/// Units of phi: length for P, length^2 for M, 1 for the others.
struct ForceKernel { // P = (E*/2) integral of w dg' (moore-hills EQ22)
    template <class U, class W> static U at(const Extent<U>&, const Mark<U>& m, const W& weight) {
        return times(weight, m.w);
    }
    /// Twice the integral of w between two marks.
    template <class U>
    static U twice_between(const Extent<U>& e, const Mark<U>& m, const Mark<U>& n) {
        const U d = Field<U>::over(e.length(), 2);
        return n.y * n.w - m.y * m.w + d * d * (m.h - n.h);
    }
    template <class U> static U between(const Extent<U>& e, const Mark<U>& m, const Mark<U>& n) {
        return Field<U>::over(twice_between(e, m, n), 2);
    }
};
struct MomentKernel { // M = (E*/4) integral of w (v + c) dg'
    template <class U, class W> static U at(const Extent<U>& e, const Mark<U>& m, const W& weight) {
        return times(weight, m.w) * (m.y + (e.a - e.b));
    }
    template <class U> static U between(const Extent<U>& e, const Mark<U>& m, const Mark<U>& n) {
        return Field<U>::over(U(m.w * m.w * m.w - n.w * n.w * n.w), 3) +
               Field<U>::over(U((e.a - e.b) * ForceKernel::twice_between(e, m, n)), 2);
    }
};
struct RightRateKernel { // dP/da = (E*/2) integral of sqrt((v+b)/(a-v)) dg'
    template <class U, class W> static U at(const Extent<U>&, const Mark<U>& m, const W& weight) {
        return times(weight, U(m.left / m.w));
    }
    template <class U> static U between(const Extent<U>& e, const Mark<U>& m, const Mark<U>& n) {
        return m.w - n.w + Field<U>::over(e.length(), 2) * (m.h - n.h);
    }
};
struct LeftRateKernel { // dP/db = (E*/2) integral of sqrt((a-v)/(v+b)) dg'
    template <class U, class W> static U at(const Extent<U>&, const Mark<U>& m, const W& weight) {
        return times(weight, U(m.right / m.w));
    }
    template <class U> static U between(const Extent<U>& e, const Mark<U>& m, const Mark<U>& n) {
        return n.w - m.w + Field<U>::over(e.length(), 2) * (m.h - n.h);
    }
};
struct RightBalanceKernel { // consistency (moore-hills EQ20), right of the origin: h
    template <class U, class W> static U at(const Extent<U>&, const Mark<U>& m, const W& weight) {
        return times(weight, m.h);
    }
    template <class U> static U between(const Extent<U>&, const Mark<U>& m, const Mark<U>& n) {
        return n.y * n.h - m.y * m.h + m.w - n.w;
    }
};
struct LeftBalanceKernel { // consistency, left of the origin: pi - h
    template <class U, class W> static U at(const Extent<U>&, const Mark<U>& m, const W& weight) {
        return times(weight, Field<U>::other_angle(m));
    }
    template <class U> static U between(const Extent<U>&, const Mark<U>& m, const Mark<U>& n) {
        const U pi = Field<U>::pi(m.h);
        return n.y * (pi - n.h) - m.y * (pi - m.h) + n.w - m.w;
    }
};

/// b(a + z) as a power series of type S by Newton's method on the consistency condition
/// (docs/expansions.md, "The series of the law: the consistency condition"). Each step doubles the
/// number of correct terms. `a` is the series a + z, `b` its left edge at z = 0 (lengths).
/// `imbalance(e)` is the right side less the left side of the condition for edges that are series;
/// `left_rate(e)` is the integral of sqrt((a-v)/(v+b)) dg', so that
/// -left_rate/(a + b) is the derivative of the imbalance with respect to b.
template <class S, class T, class Imbalance, class Rate>
[[nodiscard]] S left_edge_by_newton(const S& a, const T& b, const Imbalance& imbalance,
                                    const Rate& left_rate) {
    using F = Field<S>;
    S series(b, 1);
    for (std::size_t known = 1; known < a.order();) {
        known = std::min(2 * known, a.order());
        const Extent<S> trial{F::resized(a, known), F::resized(series, known)};
        S gap = imbalance(trial);
        F::set_constant(gap, Field<T>::number(0, b)); // the condition holds at z = 0
        // Newton's step: b - C/C_b with C_b = -left_rate/(a + b)
        series = trial.b + gap / (left_rate(trial) / trial.length());
        F::set_constant(series, b);
    }
    return series;
}

/// The contact law of g' = C sgn(x) |x|^m: P = factor a^(m+1) with factor = E* C (sqrt(pi)/2)
/// Gamma(1 + m/2)/Gamma((3 + m)/2) (moore-hills EQ11; docs/mechanics.md, "Closed forms of the
/// law"), over any field that has powers.
template <class T> struct PowerLaw {
    T exponent; ///< m
    T factor;   ///< in force per unit length over length^(m+1)

    /// The normal force P per unit length for the half-width a (length).
    [[nodiscard]] T force(const T& a) const {
        using std::pow;
        return T(factor * pow(a, T(exponent + 1)));
    }
    /// dP/da, in force per unit length over length.
    [[nodiscard]] T force_rate(const T& a) const {
        using std::pow;
        return T(factor * (exponent + 1) * pow(a, exponent));
    }
    /// dP/da as a power series, for a half-width that is a power series.
    template <class S> [[nodiscard]] S force_rate_series(const S& a) const {
        return pow(a, exponent) * T(factor * (exponent + 1));
    }
    /// The half-width a (length) for the normal force P per unit length.
    [[nodiscard]] T half_width(const T& P) const {
        using std::pow;
        return T(pow(T(P / factor), T(1 / (exponent + 1))));
    }
};

} // namespace edgeproof::contact
