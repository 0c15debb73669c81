// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/contact/enclosure/proved_contact.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// The greatest value of a function of one variable, by branch and bound with proof
/// (docs/pressure.md, "The greatest pressure").
namespace edgeproof::contact {

struct IntervalMaximum {
    Ball value;
    /// The one place; nothing if the intervals that remain do not decide it, as with two equal
    /// maxima: `value` is then wider than the bits allow.
    std::optional<Ball> place;
    std::size_t intervals = 0; ///< examined
};

/// The greatest value of f over 0 ... end. The function is bounded over intervals, at first
/// `first_pieces` equal ones, which are divided, and dropped where f is certainly less than at
/// another place, or certainly monotone. Where f is certainly concave over all that remain, the
/// interval form of Newton's method encloses the one place where f' = 0.
///
/// `f` has bits(), value(x), slope(x) and bend(x), f' and f'' for every x of a ball, bound(lo, hi),
/// whose upper end is at least every value between, between(lo, hi), where an interval is divided,
/// and count(), which is called before evaluations and returns false at the end of the budget.
/// `centre`: f is even about this place, which is the end. Throws BudgetError if f is not bounded
/// over some interval.
template <class F>
[[nodiscard]] IntervalMaximum greatest_on_interval(const F& f, const Rational& end,
                                                   long first_pieces,
                                                   const std::optional<Ball>& centre = {}) {
    constexpr int most_divisions = 60;
    struct Piece {
        Rational lo;
        Rational hi;
        std::optional<Real> most; ///< an upper bound of f over the piece, if one is known
    };
    const long bits = f.bits();
    const auto over = [&](const Rational& lo, const Rational& hi) {
        return Ball::hull(Ball(lo, bits), Ball(hi, bits));
    };
    IntervalMaximum found;
    std::optional<Real> best; // a lower bound of the greatest value
    bool in_budget = true;
    const auto examine = [&](const Rational& lo, const Rational& hi, std::vector<Piece>& pieces) {
        in_budget = f.count() && in_budget;
        ++found.intervals;
        const Ball x = over(lo, hi);
        const Ball m(f.between(lo, hi), bits);
        const Ball there = f.value(m);
        if (there.is_finite() && (!best || there.lower() > *best)) {
            best = there.lower();
        }
        const Ball slope = f.slope(x);
        if (slope.is_finite() && !contains_zero(slope)) {
            return; // monotone: its maximum is at an end, and so also in the adjacent piece
        }
        std::optional<Real> most;
        for (const Ball& bound : {f.bound(lo, hi), there + slope * (x - m)}) {
            if (bound.is_finite()) {
                most = most ? std::min(*most, bound.upper()) : bound.upper();
            }
        }
        pieces.push_back({lo, hi, std::move(most)});
    };
    // The greatest value by Newton's method, if f is concave over all remaining pieces.
    const auto isolated = [&](const std::vector<Piece>& pieces) {
        in_budget = f.count() && in_budget;
        const Ball left = over(pieces.front().lo, pieces.back().hi);
        const bool to_the_centre = centre && pieces.back().hi == end;
        // A symmetric interval about the centre: if f is concave there, f' = 0 in the middle.
        const Ball whole = to_the_centre ? Ball::hull(left, *centre * 2 - left) : left;
        const Ball bend = f.bend(whole);
        if (!bend.is_finite() || !certainly_negative(bend)) {
            return false;
        }
        if (to_the_centre) {
            found.place = centre;
            found.value = f.value(*centre);
            return true;
        }
        try {
            const Ball place = isolate_zero([&](const Ball& x) { return f.slope(x); },
                                            [&](const Ball& x) { return f.bend(x); }, middle(left),
                                            "the place of the greatest value", true);
            if (!contains(left, place) || place.relative_accuracy_bits() < bits / 2) {
                return false;
            }
            // Taylor's formula with f'' over the ball
            const Ball m = middle(place);
            const Ball off = place - m;
            found.place = place;
            found.value = f.value(m) + f.slope(m) * off + f.bend(place) / 2 * off * off;
        } catch (const BudgetError&) { // halving makes more progress
            return false;
        }
        return found.value.is_finite();
    };
    const auto drop_low = [&](std::vector<Piece>& pieces) {
        std::erase_if(
            pieces, [&](const Piece& piece) { return best && piece.most && *piece.most < *best; });
    };
    std::vector<Piece> pieces;
    for (long i = 0; i < first_pieces; ++i) {
        examine(Rational(end * Rational(i, first_pieces)),
                Rational(end * Rational(i + 1, first_pieces)), pieces);
    }
    for (int depth = 0; depth < most_divisions && in_budget; ++depth) {
        drop_low(pieces);
        if (!pieces.empty() && isolated(pieces)) {
            return found;
        }
        std::vector<Piece> parts;
        for (const Piece& piece : pieces) {
            const Rational m = f.between(piece.lo, piece.hi);
            examine(piece.lo, m, parts);
            examine(m, piece.hi, parts);
        }
        pieces = std::move(parts);
    }
    drop_low(pieces);
    if (pieces.empty() || !best) {
        throw BudgetError("the greatest value is not enclosed");
    }
    Real most = *best;
    for (const Piece& piece : pieces) {
        if (!piece.most) {
            throw BudgetError("the values near " + Ball(piece.hi, 64).midpoint().str(8) +
                              " are not enclosed");
        }
        most = std::max(most, *piece.most);
    }
    found.place.reset();
    found.value = Ball::from_interval(*best, most, bits);
    return found;
}

/// Returns an enclosure of the greatest pressure of a contact in the unit of the contact modulus.
/// `symmetric`: p is even about the middle of the contact. The pressure must have no corner inside.
/// Throws BudgetError if the pressure is not bounded over some interval.
[[nodiscard]] Ball enclosed_peak(const ProvedContact& contact, bool symmetric);

} // namespace edgeproof::contact
