// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <algorithm>
#include <optional>
#include <utility>

/// On which side of a tolerance a function f of one variable x >= 0 lies: the search of
/// docs/expansions.md, "Extents", for extents, for the reach of a design and for the load of a slip
/// zone.
namespace edgeproof::contact {

enum class Side { below, within, above, unknown };
/// The side on which an enclosure f lies.
[[nodiscard]] inline Side side_of(const Ball& f, const Ball& tolerance) {
    if (!f.is_finite()) {
        return Side::unknown;
    }
    return certainly_less(tolerance, f)        ? Side::above
           : certainly_less(f, -tolerance)     ? Side::below
           : certainly_less(abs(f), tolerance) ? Side::within
                                               : Side::unknown;
}
[[nodiscard]] inline bool is_beyond(Side side) {
    return side == Side::above || side == Side::below;
}

/// The side of f over an interval, and whether f is certainly monotone there.
struct SideOver {
    Side side = Side::unknown;
    bool monotone = false;
};

/// An interval with a decision: all on one side, a root of f = level (f monotone), or undecided.
struct SidePiece {
    Rational lo;
    Rational hi;
    Side from;
    Side to;
    std::optional<int> root; ///< +1: a root of f = tolerance, -1: of f = -tolerance
};

/// Divides lo ... hi into such pieces, in ascending order, and calls take(piece) for each; an
/// interval of less than 2^-finest of its place is not divided. Where take returns false, the
/// search ends, and returns false. `f` has over(lo, hi), a SideOver, and side_at(x).
template <class F, class Take>
bool for_each_side(const F& f, const Rational& lo, const Rational& hi, long finest,
                   const Take& take) {
    const SideOver over = f.over(lo, hi);
    if (over.side != Side::unknown) {
        return take(SidePiece{lo, hi, over.side, over.side, {}});
    }
    if (over.monotone) {
        const Side from = f.side_at(lo);
        const Side to = f.side_at(hi);
        const Side outside = from == Side::within ? to : from;
        if (from != Side::unknown && from == to) {
            return take(SidePiece{lo, hi, from, to, {}});
        }
        // Where both levels are crossed, halving separates them.
        if ((from == Side::within || to == Side::within) && is_beyond(outside)) {
            return take(SidePiece{lo, hi, from, to, outside == Side::above ? 1 : -1});
        }
    }
    if ((hi - lo) * power_of_two(finest) < hi) {
        return take(SidePiece{lo, hi, Side::unknown, Side::unknown, {}});
    }
    const Rational m = middle(lo, hi);
    return for_each_side(f, lo, m, finest, take) && for_each_side(f, m, hi, finest, take);
}

/// The same from lo > 0 to `end`, in intervals that grow by a quarter of the distance from 0.
template <class F, class Take>
bool for_each_side_outwards(const F& f, Rational lo, const Rational& end, long finest,
                            const Take& take) {
    while (lo < end) {
        Rational hi = exact_value(Ball(Rational(lo * Rational(5, 4)), 24).midpoint());
        hi = std::min(hi, end);
        if (!for_each_side(f, lo, hi, finest, take)) {
            return false;
        }
        lo = hi;
    }
    return true;
}

/// The place of the root of a piece at a precision of `bits`. Newton's method finds it and proves
/// nothing; then two places with opposite signs enclose it (docs/expansions.md), at least
/// 2^-(bits - kept) times the place away from it. `f` has tangent(x), f and f', at(x) and
/// tolerance(). Returns nothing if the bits do not decide the signs.
template <class F>
std::optional<Ball> enclosed_crossing(const F& f, const SidePiece& of, long bits, long kept) {
    const Ball level = *of.root > 0 ? f.tolerance() : -f.tolerance();
    const bool rises = of.from < of.to;
    Rational lo = of.lo;
    Rational hi = of.hi;
    Rational x = (lo + hi) / 2;
    for (int k = 0; k < 200; ++k) {
        const auto [there, rate] = f.tangent(x);
        const Ball value = there - level;
        if (!contains_zero(value)) {
            (certainly_positive(value) == rises ? hi : lo) = x;
        }
        const Ball step = value / rate;
        Rational next = (lo + hi) / 2;
        if (step.is_finite()) {
            const Rational newton = exact_value(Ball(Ball(x, bits) - step).midpoint());
            const bool refined = abs(Rational(newton - x)) * power_of_two(bits - 24) < hi;
            if (newton >= lo && newton <= hi) {
                next = newton;
            }
            if (refined || contains_zero(value)) {
                x = next;
                break;
            }
        }
        x = exact_value(Ball(next, bits).midpoint());
    }
    for (long k = bits - kept; k > 8; k -= 16) {
        const Rational slack = hi * power_of_two(-k);
        const Rational left = std::max(of.lo, Rational(x - slack));
        const Rational right = std::min(of.hi, Rational(x + slack));
        const Ball at_left = f.at(left) - level;
        const Ball at_right = f.at(right) - level;
        if (rises ? certainly_negative(at_left) && certainly_positive(at_right)
                  : certainly_positive(at_left) && certainly_negative(at_right)) {
            return Ball::hull(Ball(left, bits), Ball(right, bits));
        }
    }
    return {};
}

} // namespace edgeproof::contact
