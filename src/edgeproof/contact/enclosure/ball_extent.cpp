// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/ball_extent.hpp"

#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr long scan_bits = 192;
constexpr long scan_bits_of_integrals = 96; ///< which cost more at more bits
constexpr long narrowest = 40; ///< intervals are halved to 2^-40 of their distance from the edge
constexpr long kept_bits = 48; ///< bits that are lost on the way to a crossing

/// Adds pieces to a list.
auto into(std::vector<SidePiece>& pieces) {
    return [&pieces](SidePiece piece) {
        pieces.push_back(std::move(piece));
        return true;
    };
}

} // namespace

/// The error, with its enclosures over intervals and its tangents counted.
struct BallExtentSearch::Counted {
    const RelativeError& f;
    BallExtentSearch& search;
    [[nodiscard]] const Ball& tolerance() const { return f.tolerance(); }
    [[nodiscard]] Ball at(const Rational& u) const { return f.at(u); }
    [[nodiscard]] Side side_at(const Rational& u) const { return f.side_at(u); }
    [[nodiscard]] SideOver over(const Rational& lo, const Rational& hi) const {
        search.count(f);
        return f.over(lo, hi);
    }
    [[nodiscard]] std::pair<Ball, Ball> tangent(const Rational& u) const {
        search.count(f);
        return f.tangent(u);
    }
};

RelativeError BallExtentSearch::error(long bits) {
    const ProvedContact& contact = contact_(bits);
    most_doublings_ = contact.cost() > 1 ? 2 : 5;
    return {contact, edge_, n_, tolerance_};
}

void BallExtentSearch::count(const RelativeError& f) {
    check_interruption();
    evaluations_ += f.cost();
    if (evaluations_ > most_evaluations) {
        throw BudgetError("undecided after " + std::to_string(most_evaluations / f.cost()) +
                          " enclosures of the error");
    }
}

void BallExtentSearch::merge_unknown(std::vector<SidePiece>& pieces) {
    std::vector<SidePiece> merged;
    for (SidePiece& piece : pieces) {
        const bool unknown = piece.from == Side::unknown;
        if (!merged.empty() && unknown && merged.back().from == Side::unknown) {
            merged.back().hi = piece.hi;
        } else {
            merged.push_back(std::move(piece));
        }
    }
    pieces = std::move(merged);
}

// docs/expansions.md, "Extents"
void BallExtentSearch::scan() {
    const Ball decades = log(enclosed_constant(tolerance_, 64)) / log(Ball(2, 64));
    const long small = std::max(0L, -static_cast<long>(approximate(decades)));
    bool integrated = false;
    try {
        integrated = contact_(scan_bits).cost() > 1;
    } catch (const BudgetError&) { // more bits are tried
    }
    const long first = (integrated ? scan_bits_of_integrals : scan_bits) + 2 * small;
    for (long bits = first;; bits *= 2) {
        try {
            const RelativeError f = error(bits);
            const Ball length = f.length();
            const Ball to = length * enclosed_constant(range_.to, bits);
            Rational lo = exact_value(
                Ball(length * enclosed_constant(range_.from, bits)).with_bits(bits).lower());
            const Rational end = exact_value(to.upper());
            pieces_.clear();
            const Rational safe = f.safe_distance();
            if (safe > lo) {
                const Rational stop = std::min(safe, end);
                pieces_.push_back({lo, stop, Side::within, Side::within, {}});
                lo = stop;
            }
            for_each_side_outwards(Counted{f, *this}, lo, end, narrowest, into(pieces_));
            merge_unknown(pieces_);
            return;
        } catch (const BudgetError&) {
            if (evaluations_ > most_evaluations || bits > (first - small) << most_doublings_) {
                throw;
            }
        }
    }
}

EnclosedExtents BallExtentSearch::at(long bits) {
    if (pieces_.empty()) {
        scan();
    }
    const RelativeError f = error(bits);
    const Counted counted{f, *this};
    // The pieces that the scan did not decide are examined again at this number of bits.
    std::vector<SidePiece> pieces;
    for (const SidePiece& piece : pieces_) {
        if (piece.from == Side::unknown) {
            for_each_side(counted, piece.lo, piece.hi, bits - kept_bits, into(pieces));
        } else {
            pieces.push_back(piece);
        }
    }
    merge_unknown(pieces);
    EnclosedExtents found;
    found.length = f.length();
    const Ball start = found.length * enclosed_constant(range_.from, bits);
    const Ball end = found.length * enclosed_constant(range_.to, bits);
    found.measure = Ball(0, bits);
    found.first_exit = end;
    found.leaves = false;
    bool within = pieces.front().from == Side::within;
    found.starts_within = within;
    if (!within) {
        found.leaves = true;
        found.first_exit = start;
    }
    Ball entered = start;
    const auto cross = [&](const Ball& place, bool single) {
        found.crossings.push_back(place);
        found.single.push_back(single);
        within = !within;
        if (within) {
            entered = place;
            return;
        }
        found.measure += place - entered;
        if (!std::exchange(found.leaves, true)) {
            found.first_exit = place;
        }
    };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const SidePiece& piece = pieces[i];
        if (!piece.root && piece.from != Side::unknown) {
            continue;
        }
        const auto root =
            piece.root ? enclosed_crossing(counted, piece, bits, kept_bits) : std::nullopt;
        const Ball place = root ? *root : Ball::hull(Ball(piece.lo, bits), Ball(piece.hi, bits));
        std::size_t times = 1;
        if (!piece.root) {
            const bool inner = i > 0 && i + 1 < pieces.size();
            const Side before = inner ? pieces[i - 1].to : Side::unknown;
            const Side after = inner ? pieces[i + 1].from : Side::unknown;
            if (inner && before == after && f.corner_between(piece.lo, piece.hi)) {
                // The error goes to -1 at the corner and back: from above the tolerance it enters
                // and leaves on either side; of a tolerance of 1 it is there at the corner only.
                times = within ? 2 : before == Side::above ? 4 : 0;
            } else if ((before == Side::within) == (after == Side::within)) {
                throw BudgetError("undecided at " + std::to_string(bits) +
                                  " bits: the error may touch the tolerance at u = " +
                                  Ball(piece.lo, 64).midpoint().str(12));
            }
        }
        if (times > 0 && (!certainly_less(start, place) || !certainly_less(place, end))) {
            throw BudgetError("undecided at " + std::to_string(bits) +
                              " bits: a crossing may lie on an end of the range");
        }
        for (; times > 0; --times) {
            cross(place, piece.root.has_value());
        }
    }
    if (within) {
        found.measure += end - entered;
    }
    return found;
}

} // namespace edgeproof::contact
