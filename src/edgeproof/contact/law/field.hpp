// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/real.hpp"
#include "edgeproof/series/truncated.hpp"

#include <cmath>
#include <utility>

namespace edgeproof::contact {

/// The operations, in addition to +, -, * and / of two numbers, that the formulas of this folder
/// need. Each formula is written once, as a template over U: binary64 and the other floating-point
/// types, Real, rational numbers, symbols, exact numbers, balls, and power series over any of them.
/// A type with other definitions of these operations specialises this template
/// (enclosure/fields.hpp: balls and exact numbers).
/// A member is compiled only for the types that use it.
template <class U> struct Field {
    /// The integer k; `like` gives the precision and, for series, the order.
    static U number(int k, const U&) { return U(k); }
    static U pi(const U&) {
        if constexpr (Arithmetic<U>) {
            return edgeproof::pi<U>();
        } else {
            return U::pi();
        }
    }
    static U over(const U& x, int k) { return U(x / k); }
    /// True if x is certainly 0; the other factor of a product then need not be known.
    static bool vanishes(const U& x) { return x == U(0); }
    /// weight x; the weight is a number even if U is a series.
    template <class W> static U times(const W& weight, const U& x) { return U(weight * x); }
    /// sum += x y, with a single rounding where the type supports it.
    template <class W> static void add_product(U& sum, const W& x, const U& y) {
        sum = sum + times(x, y);
    }
    static U twice(const U& x) { return U(x * 2); }
    static U smaller(const U& x, const U& y) { return y < x ? y : x; }
    /// The square root of a number that is known not to be negative.
    static U root(const U& x) {
        using std::sqrt;
        return U(sqrt(x));
    }
    /// 2 atan sqrt(near/far), the angle h of docs/mechanics.md; the distances are known not to be
    /// negative.
    static U angle(const U& near, const U& far) {
        using std::atan;
        return U(atan(U(root(U(near / far)))) * 2);
    }
    /// pi - h of a mark inside the contact, as 2 atan sqrt((v + b)/(a - v)): near the left edge the
    /// difference pi - h would lose digits.
    template <class Mark> static U other_angle(const Mark& m) {
        using std::atan;
        return U(atan(U(m.w / m.right)) * 2);
    }
};

template <class T> struct Field<series::Series<T>> {
    using U = series::Series<T>;
    static U number(int k, const U& like) { return U(Field<T>::number(k, like[0]), like.order()); }
    static U pi(const U& like) { return U(Field<T>::pi(like[0]), like.order()); }
    static U over(const U& x, int k) { return x / Field<T>::number(k, x[0]); }
    template <class W> static U times(const W& weight, const U& x) { return weight * x; }
    template <class W> static void add_product(U& sum, const W& x, const U& y) { sum += x * y; }
    static U root(const U& x) { return sqrt(x); }
    static U angle(const U& near, const U& far) {
        // With near = a - v, far = v + b, the angle h has the cosine (far - near)/(far + near) and
        // the sine 2 sqrt(far near)/(far + near); so dh/dz = -(d(cos h)/dz)/sin h.
        const T start = Field<T>::angle(near[0], far[0]);
        if (near.order() < 2) {
            return U(start, near.order());
        }
        const U sum = far + near;
        const U cosine = (far - near) / sum;
        const U over_sine = over(sum, 2) / root(near * far);
        return antiderivative(-(derivative(cosine) * over_sine.truncated(near.order() - 1)), start);
    }
    template <class Mark> static U other_angle(const Mark& m) { return pi(m.h) - m.h; }
    /// x^(-1/2) for x = 1 + ...
    static U inverse_root(const U& x) {
        const T one = Field<T>::number(1, x[0]);
        return pow_with_constant<T>(x, Field<T>::over(T(-one), 2), one);
    }
    /// The series with fewer terms, or with more terms that are 0 (a start for Newton's steps).
    static U resized(const U& x, std::size_t order) {
        std::vector<T> c = x.coefficients();
        c.resize(order, Field<T>::number(0, x[0]));
        return U(std::move(c));
    }
    static void set_constant(U& x, const T& c) { x[0] = c; }
};

/// weight x in the field of the second factor.
template <class W, class U> [[nodiscard]] U times(const W& weight, const U& x) {
    return Field<U>::times(weight, x);
}

} // namespace edgeproof::contact
