// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"

#include <cstddef>
#include <utility>
#include <vector>

/// The pressure of a piecewise linear slope in closed form, over any field (docs/pressure.md,
/// "Closed form: piecewise linear slopes"): 2 pi p/E* is the integral of G(x, v) dg'(v) with
/// G = ln |(z_x + z_v)/(z_x - z_v)|, z_s = sqrt((a - s)/(s + b)). The integral of G between two
/// marks is the difference of (v - x) G + w_x h. In the sum over knots, each knot contributes its
/// jump of g' times G and its drop of g'' times (v - x) G.
namespace edgeproof::contact {

/// (e^G - 1) D |v - x| = 2 min(p, q) + 2 sqrt(p q), with p = r_v l_x, q = r_x l_v,
/// p - q = D (x - v) (docs/pressure.md). It contains no difference, so that G = ln(1 + ...) keeps
/// its relative digits near an edge. `root` is sqrt(p q); all in length^2.
template <class U> [[nodiscard]] U green_excess(const U& p, const U& q, const U& root) {
    return Field<U>::twice(U(Field<U>::smaller(p, q) + root));
}
/// The same for the mark of v and the distances `right_x`, `left_x` of x from the edges; w_x =
/// sqrt(right_x left_x). `side` is 1 where v > x, -1 where v < x, 0 where this is not known.
template <class U>
[[nodiscard]] U green_excess(const Mark<U>& v, const U& right_x, const U& left_x, const U& w_x,
                             int side) {
    using F = Field<U>;
    U sum = v.w * w_x;
    if (side == 0) {
        return green_excess(U(v.right * left_x), U(right_x * v.left), sum);
    }
    // The sign of v - x determines which of p and q is smaller.
    if (side > 0) {
        F::add_product(sum, v.right, left_x);
    } else {
        F::add_product(sum, right_x, v.left);
    }
    return F::twice(std::move(sum));
}

/// The integral of g'' over the angle h (1/length). `marks` are those of all knots of `slope`.
template <class Slope, class U>
[[nodiscard]] U arc_of(const Slope& slope, const Extent<U>& e, const std::vector<Mark<U>>& marks) {
    U sum = Field<U>::number(0, e.a);
    U before = Field<U>::pi(e.a);
    for (std::size_t i = 0; i <= marks.size(); ++i) {
        const U here = i < marks.size() ? marks[i].h : Field<U>::number(0, e.a);
        if (!Field<U>::vanishes(slope.rate(i))) {
            sum = std::move(sum) + slope.rate(i) * (before - here);
        }
        before = here;
    }
    return sum;
}

/// 2 pi p/E* (docs/pressure.md, "Closed form: piecewise linear slopes"). `arc` is arc_of times w_x.
/// `bends(i)` is true if knot i is inside the contact and the formula of g' changes there.
/// `green(i)` returns G (`value`) and (v - x) G (`moment`, a length) of such a knot.
template <class Slope, class U, class Bends, class GreenAt>
[[nodiscard]] U logarithmic_sum(const Slope& slope, std::size_t knots, const U& arc,
                                const Bends& bends, const GreenAt& green) {
    U sum = arc;
    for (std::size_t i = 0; i < knots; ++i) {
        if (!bends(i)) {
            continue;
        }
        const auto g = green(i);
        if (slope.has_corner(i)) {
            sum = std::move(sum) + times(slope.jump(i), g.value);
        }
        Field<U>::add_product(sum, slope.rate_drop(i), g.moment);
    }
    return sum;
}

} // namespace edgeproof::contact
