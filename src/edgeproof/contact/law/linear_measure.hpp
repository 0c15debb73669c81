// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/contact/profile/profile.hpp"

#include <cstddef>
#include <utility>
#include <vector>

/// Integrals over dg' of a piecewise linear slope, in closed form over any field. (measure.hpp has
/// those over any slope, in Real, with quadrature.)
namespace edgeproof::contact {

/// g' in numbers of W: at_origin + rate x on pieces that meet at knots.
template <class W> struct LinearSlope {
    struct Piece {
        W at_origin;
        W rate;
    };
    std::vector<W> knots;
    std::vector<Piece> pieces; ///< pieces[i] ends at knots[i]
    std::vector<bool> corners; ///< whether g' jumps at a knot
    std::vector<W> jumps;      ///< g'(knot+) - g'(knot-), where there is a corner
    std::size_t origin = 0;    ///< its index among the knots

    [[nodiscard]] const W& rate(std::size_t piece) const { return pieces[piece].rate; }
    [[nodiscard]] bool has_corner(std::size_t knot) const { return corners[knot]; }
    [[nodiscard]] const W& jump(std::size_t knot) const { return jumps[knot]; }
    /// Of g'' across a knot.
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

/// `number` makes a W of a constant expression. Of a profile that is not piecewise linear only the
/// knots.
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

/// The sum of at_knot(i, mark) over the corners and of the rate of g' times
/// between(i, mark, next mark) over the pieces; what is certainly outside counts nothing.
template <class U, class W, class AtKnot, class Between>
[[nodiscard]] U over_linear_measure(const LinearSlope<W>& slope, const Extent<U>& e,
                                    const std::vector<Mark<U>>& marks, const AtKnot& at_knot,
                                    const Between& between) {
    U sum = Field<U>::number(0, e.a);
    Mark<U> previous = left_end(e);
    for (std::size_t i = 0; i <= marks.size(); ++i) {
        Mark<U> next = i < marks.size() ? marks[i] : right_end(e);
        const bool nothing_inside = previous.end && previous.end == next.end;
        // A piece with a constant g' weighs nothing, whatever is not known of its ends.
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

template <class Kernel, class U, class W>
[[nodiscard]] U over_linear_measure(const LinearSlope<W>& slope, const Extent<U>& e,
                                    const std::vector<Mark<U>>& marks) {
    return over_linear_measure(
        slope, e, marks,
        [&](std::size_t i, const Mark<U>& m) { return Kernel::at(e, m, slope.jump(i)); },
        [&](std::size_t, const Mark<U>& m, const Mark<U>& n) { return Kernel::between(e, m, n); });
}

/// eqn:Consistency: the right side less the left, zero where the edges balance, positive where the
/// left edge lies further out. g'(0+) weighs on the right, -g'(0-) on the left.
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
