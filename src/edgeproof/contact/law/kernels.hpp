// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/elementary/elementary.hpp"
#include "edgeproof/series/functions.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

/// Every quantity of the normal contact is an integral over the measure dg'(v), which convexity
/// makes positive: P, M, P'(a), dP/db, the consistency condition and p(x) differ only in the
/// kernel. They follow from moore-hills.tex eqn:SIEPressure and its neighbours (in the form for
/// -b < x < a) by one integration by parts; the boundary terms vanish by eqn:Consistency. No
/// kernel changes sign, so no sum of theirs cancels.
namespace edgeproof::contact {

/// The extent -b < x < a. U is T, or Series<T> where a and b move.
template <class U> struct Extent {
    U a;
    U b;
    [[nodiscard]] U length() const { return a + b; }
};

/// A point v of the contact in the coordinates that the kernels are written in.
template <class U> struct Mark {
    U y; ///< v - c, c = (a - b)/2 the middle
    U w; ///< sqrt((a - v)(v + b))
    U h; ///< integral from v to a of ds/w(s) = 2 atan sqrt((a - v)/(v + b)), between 0 and pi
};

template <class U, class T> [[nodiscard]] Mark<U> mark(const Extent<U>& e, const T& v) {
    using std::sqrt;
    const U right = e.a - v;
    const U left = e.b + v;
    return {U((left - right) / T(2)), U(sqrt(U(right * left))),
            U(arc_tangent(U(sqrt(U(right / left)))) * T(2))};
}
template <class U, class T> [[nodiscard]] Mark<U> right_end(const Extent<U>& e) {
    return {U(e.length() / T(2)), U(e.a * T(0)), U(e.a * T(0))};
}
template <class U, class T> [[nodiscard]] Mark<U> left_end(const Extent<U>& e) {
    return {U(-(e.length() / T(2))), U(e.a * T(0)), U(e.a * T(0) + pi<T>())};
}

/// The marks of a contact at the knots of its profile, each worked out once, when it is first asked
/// for: all the integrals over one contact share them. Holds on to `knots`.
template <class T, class U> class Marks {
public:
    Marks(const Extent<U>& e, const std::vector<T>& knots)
        : extent_(e), knots_(knots), at_(knots.size()) {}
    [[nodiscard]] const Extent<U>& extent() const { return extent_; }
    [[nodiscard]] const Mark<U>& at(std::size_t knot) {
        auto& known = at_[knot];
        if (!known) {
            known = mark<U, T>(extent_, knots_[knot]);
        }
        return *known;
    }

private:
    const Extent<U>& extent_;
    const std::vector<T>& knots_;
    std::vector<std::optional<Mark<U>>> at_;
};

/// A kernel phi: its value at a mark (for corners) and its integral between two marks (for pieces
/// on which g'' is constant). `e` supplies the extent.
template <class U, class T> struct ForceKernel { // P = (E*/2) integral of w dg'
    static U at(const Extent<U>&, const Mark<U>& m) { return m.w; }
    static U between(const Extent<U>& e, const Mark<U>& m, const Mark<U>& n) {
        const U d = e.length() / T(2);
        return (n.y * n.w - m.y * m.w + d * d * (m.h - n.h)) / T(2);
    }
};
template <class U, class T> struct MomentKernel { // M = (E*/4) integral of w (v + c) dg'
    static U at(const Extent<U>& e, const Mark<U>& m) { return m.w * (m.y + e.a - e.b); }
    static U between(const Extent<U>& e, const Mark<U>& m, const Mark<U>& n) {
        return (m.w * m.w * m.w - n.w * n.w * n.w) / T(3) +
               (e.a - e.b) * ForceKernel<U, T>::between(e, m, n);
    }
};
template <class U, class T>
struct RightRateKernel { // dP/da = (E*/2) integral of sqrt((v+b)/(a-v)) dg'
    static U at(const Extent<U>& e, const Mark<U>& m) { return (e.length() / T(2) + m.y) / m.w; }
    static U between(const Extent<U>& e, const Mark<U>& m, const Mark<U>& n) {
        return m.w - n.w + e.length() / T(2) * (m.h - n.h);
    }
};
template <class U, class T>
struct LeftRateKernel { // dP/db = (E*/2) integral of sqrt((a-v)/(v+b)) dg'
    static U at(const Extent<U>& e, const Mark<U>& m) { return (e.length() / T(2) - m.y) / m.w; }
    static U between(const Extent<U>& e, const Mark<U>& m, const Mark<U>& n) {
        return n.w - m.w + e.length() / T(2) * (m.h - n.h);
    }
};
template <class U, class T> struct RightBalanceKernel { // consistency, right of the origin: h
    static U at(const Extent<U>&, const Mark<U>& m) { return m.h; }
    static U between(const Extent<U>&, const Mark<U>& m, const Mark<U>& n) {
        return n.y * n.h - m.y * m.h + m.w - n.w;
    }
};
template <class U, class T> struct LeftBalanceKernel { // consistency, left of it: pi - h
    /// As 2 atan sqrt((v + b)/(a - v)): by the left edge pi - h would cancel, and the integral over
    /// a piece that is all there would have no digits.
    static U at(const Extent<U>& e, const Mark<U>& m) {
        return arc_tangent(U(m.w / U(e.length() / T(2) - m.y))) * T(2);
    }
    static U between(const Extent<U>&, const Mark<U>& m, const Mark<U>& n) {
        return n.y * (pi<T>() - n.h) - m.y * (pi<T>() - m.h) + n.w - m.w;
    }
};

} // namespace edgeproof::contact
