// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/profile/profile.hpp"

#include <cstddef>
#include <utility>
#include <vector>

/// Integrals over dg' of a piecewise linear slope, in closed form over any field
/// (docs/mechanics.md, "One measure, six kernels"). For other slopes, in Real, by quadrature:
/// measure.hpp.
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

} // namespace edgeproof::contact
