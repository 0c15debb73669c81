// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/profile/profile.hpp"

#include <cstddef>
#include <utility>
#include <vector>

/// Integrals over dg' of a piecewise linear slope, in closed form over any field
/// (docs/mechanics.md, "One measure, six kernels").
namespace edgeproof::contact {

/// g' = at_origin + rate x on pieces between knots, in numbers of type W. Knots: lengths; rates:
/// 1/length.
template <class W> struct LinearSlope {
    struct Piece {
        W at_origin;
        W rate;
    };
    std::vector<W> knots;
    std::vector<Piece> pieces; ///< pieces[i] ends at knots[i]
    std::vector<bool> corners; ///< true if g' jumps at the knot
    std::vector<W> jumps;      ///< g'(knot+) - g'(knot-); 0 where there is no corner
    std::size_t origin = 0;    ///< the index of the origin among the knots

    [[nodiscard]] const W& rate(std::size_t piece) const { return pieces[piece].rate; }
    [[nodiscard]] bool has_corner(std::size_t knot) const { return corners[knot]; }
    [[nodiscard]] const W& jump(std::size_t knot) const { return jumps[knot]; }
    /// The decrease of g'' across a knot.
    [[nodiscard]] W rate_drop(std::size_t knot) const { return rate(knot) - rate(knot + 1); }

    void find_jumps() {
        jumps.clear();
        for (std::size_t i = 0; i < knots.size(); ++i) {
            const auto at = [&](const Piece& p) { return W(p.at_origin + p.rate * knots[i]); };
            jumps.push_back(corners[i] ? W(at(pieces[i + 1]) - at(pieces[i]))
                                       : Field<W>::number(0, knots[i]));
        }
    }
};

/// The slope of `profile`; `number` makes a W of a constant expression. For a profile that is not
/// piecewise linear only the knots are set.
template <class W, class Number>
[[nodiscard]] LinearSlope<W> linear_slope(const Profile& profile, const Number& number) {
    LinearSlope<W> slope;
    slope.origin = profile.origin();
    for (std::size_t i = 0; i < profile.knots().size(); ++i) {
        slope.knots.push_back(number(profile.knots()[i].expr()));
        slope.corners.push_back(profile.has_corner(i));
    }
    if (profile.piecewise_linear()) {
        for (const SlopePiece& piece : profile.pieces()) {
            slope.pieces.push_back({number(piece.linear->at_origin), number(piece.linear->rate)});
        }
        slope.find_jumps();
    }
    return slope;
}

/// The sum of at_knot(i, mark) over the corners and of the rate of g' times between(i, mark, next
/// mark) over the pieces. Knots and pieces that are certainly outside do not count.
template <class U, class W, class AtKnot, class Between>
[[nodiscard]] U over_linear_measure(const LinearSlope<W>& slope, const Extent<U>& e,
                                    const std::vector<Mark<U>>& marks, const AtKnot& at_knot,
                                    const Between& between) {
    U sum = Field<U>::number(0, e.a);
    Mark<U> previous = left_end(e);
    for (std::size_t i = 0; i <= marks.size(); ++i) {
        Mark<U> next = i < marks.size() ? marks[i] : right_end(e);
        const bool nothing_inside = previous.end && previous.end == next.end;
        // A piece with a constant g' contributes 0, even if its ends are not known.
        if (!nothing_inside && !Field<W>::vanishes(slope.rate(i))) {
            sum = std::move(sum) + times(slope.rate(i), between(i, previous, next));
        }
        if (i < marks.size() && !next.end && slope.has_corner(i)) {
            sum = std::move(sum) + at_knot(i, next);
        }
        previous = std::move(next);
    }
    return sum;
}

/// The integral of a kernel of kernels.hpp over dg'.
template <class Kernel, class U, class W>
[[nodiscard]] U over_linear_measure(const LinearSlope<W>& slope, const Extent<U>& e,
                                    const std::vector<Mark<U>>& marks) {
    return over_linear_measure(
        slope, e, marks,
        [&](std::size_t i, const Mark<U>& m) { return Kernel::at(e, m, slope.jump(i)); },
        [&](std::size_t, const Mark<U>& m, const Mark<U>& n) { return Kernel::between(e, m, n); });
}

/// The consistency condition (moore-hills EQ20) in the form of docs/mechanics.md: its right side
/// less its left side. It is zero where the edges are in balance, positive if the left edge must
/// lie further out, and in the unit of a slope. A corner at the origin counts with g'(0+) on the
/// right and with -g'(0-) on the left.
template <class U, class W>
[[nodiscard]] U linear_imbalance(const LinearSlope<W>& slope, const Extent<U>& e,
                                 const std::vector<Mark<U>>& marks) {
    const std::size_t o = slope.origin;
    return over_linear_measure(
        slope, e, marks,
        [&](std::size_t i, const Mark<U>& m) {
            if (i != o) {
                return i > o ? RightBalanceKernel::at(e, m, slope.jump(i))
                             : U(-LeftBalanceKernel::at(e, m, slope.jump(i)));
            }
            return U(RightBalanceKernel::at(e, m, slope.pieces[i + 1].at_origin) +
                     LeftBalanceKernel::at(e, m, slope.pieces[i].at_origin));
        },
        [&](std::size_t i, const Mark<U>& m, const Mark<U>& n) {
            return i > o ? RightBalanceKernel::between(e, m, n)
                         : U(-LeftBalanceKernel::between(e, m, n));
        });
}

/// The integral of g'/w over any zone, also where the origin lies outside: of (k + r s)/w between
/// two marks, with s = c + y, h' = -1/w and w' = -y/w (docs/mechanics.md).
template <class U, class W>
[[nodiscard]] U slope_over_angle(const LinearSlope<W>& slope, const Extent<U>& e,
                                 const std::vector<Mark<U>>& marks) {
    const U twice_c = e.a - e.b;
    Mark<U> previous = end_mark(e, Edge::left);
    U sum = previous.w; // 0
    for (std::size_t i = 0; i <= marks.size(); ++i) {
        Mark<U> next = i < marks.size() ? marks[i] : end_mark(e, Edge::right);
        const auto& piece = slope.pieces[i];
        sum = sum + (twice_c * W(piece.rate / 2) + piece.at_origin) * (previous.h - next.h) +
              (previous.w - next.w) * piece.rate;
        previous = std::move(next);
    }
    return sum;
}

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

/// The pressure of a piecewise linear slope over any field: 2 pi p/E* is the integral of
/// G(x, v) dg'(v) with G = ln |(z_x + z_v)/(z_x - z_v)|, z_s = sqrt((a - s)/(s + b)). The integral
/// of G between two marks is the difference of (v - x) G + w_x h. In the sum over knots, each knot
/// contributes its jump of g' times G and its drop of g'' times (v - x) G (docs/pressure.md,
/// "Closed form: piecewise linear slopes"). `arc` is arc_of times w_x. `bends(i)` is true if knot i
/// is inside the contact and the formula of g' changes there. `green(i)` returns G (`value`) and (v
/// - x) G (`moment`, a length) of such a knot.
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
