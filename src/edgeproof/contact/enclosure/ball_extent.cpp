// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_extent.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr long scan_bits = 192;
constexpr long narrowest = 40; ///< intervals are halved to 2^-40 of their distance from the edge
constexpr long kept_bits = 48; ///< bits that are lost on the way to a crossing

Rational power_of_two(long k) {
    const Integer p = Integer(1) << static_cast<unsigned>(k < 0 ? -k : k);
    return k < 0 ? Rational(1, p) : Rational(p);
}

} // namespace

/// An interval with a decision: all on one side, a root of f = level (f monotone), or undecided. It
/// is not in the anonymous namespace because BallExtentSearch::Search, which has such members, is
/// not.
struct DecidedPiece {
    Rational lo;
    Rational hi;
    Side from;
    Side to;
    std::optional<int> root; ///< +1: a root of f = tolerance, -1: of f = -tolerance
};

class BallExtentSearch::Search {
public:
    Search(Contact contact, Edge edge, std::size_t n, formula::Exact tolerance, ExtentRange range)
        : contact_(std::move(contact)), edge_(edge), n_(n), tolerance_(std::move(tolerance)),
          range_(std::move(range)) {}

    [[nodiscard]] EnclosedExtents at(long bits);
    std::size_t evaluations = 0;

private:
    [[nodiscard]] RelativeError error(long bits) {
        const ProvedContact& contact = contact_(bits);
        most_doublings_ = contact.cost() > 1 ? 2 : 5;
        return {contact, edge_, n_, tolerance_};
    }
    void count(const RelativeError& f) {
        check_interruption();
        evaluations += f.cost();
        if (evaluations > most_evaluations) {
            throw BudgetError("undecided after " + std::to_string(most_evaluations / f.cost()) +
                              " enclosures of the error");
        }
    }
    void scan();
    void decide(const RelativeError& f, const Rational& lo, const Rational& hi, long finest,
                std::vector<DecidedPiece>& pieces);
    bool roots_between(const RelativeError& f, const Rational& lo, const Rational& hi,
                       std::vector<DecidedPiece>& pieces);
    [[nodiscard]] Ball refine(const RelativeError& f, const DecidedPiece& piece);

    Contact contact_;
    Edge edge_;
    std::size_t n_;
    formula::Exact tolerance_;
    ExtentRange range_;
    int most_doublings_ = 5;           ///< of the bits of the scan, before it gives up
    std::vector<DecidedPiece> pieces_; ///< of the scan; adjacent undecided pieces are joined
};

namespace {

/// Joins undecided pieces that are adjacent.
void merge_unknown(std::vector<DecidedPiece>& pieces) {
    std::vector<DecidedPiece> merged;
    for (DecidedPiece& piece : pieces) {
        const bool unknown = piece.from == Side::unknown;
        if (!merged.empty() && unknown && merged.back().from == Side::unknown) {
            merged.back().hi = piece.hi;
        } else {
            merged.push_back(std::move(piece));
        }
    }
    pieces = std::move(merged);
}

} // namespace

void BallExtentSearch::Search::scan() {
    long small = 0;
    {
        const Ball decades = log(enclosed_constant(tolerance_, 64)) / log(Ball(2, 64));
        small =
            std::max(0L, -static_cast<long>(arf_get_d(arb_midref(decades.data()), ARF_RND_NEAR)));
    }
    for (long bits = scan_bits + 2 * small;; bits *= 2) {
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
            while (lo < end) {
                Rational hi = exact_value(Ball(Rational(lo * Rational(5, 4)), 24).midpoint());
                hi = hi >= end ? end : hi;
                decide(f, lo, hi, narrowest, pieces_);
                lo = hi;
            }
            merge_unknown(pieces_);
            return;
        } catch (const BudgetError&) {
            if (evaluations > most_evaluations || bits > (scan_bits + small) << most_doublings_) {
                throw;
            }
        }
    }
}

bool BallExtentSearch::Search::roots_between(const RelativeError& f, const Rational& lo,
                                             const Rational& hi,
                                             std::vector<DecidedPiece>& pieces) {
    const Side from = f.side(f.at(lo));
    const Side to = f.side(f.at(hi));
    if (from == Side::unknown || to == Side::unknown) {
        return false;
    }
    if (from == to) {
        pieces.push_back({lo, hi, from, to, {}});
        return true;
    }
    if (from == Side::within || to == Side::within) {
        const Side outside = from == Side::within ? to : from;
        pieces.push_back({lo, hi, from, to, outside == Side::above ? 1 : -1});
        return true;
    }
    // Both levels are crossed: halving separates them.
    return false;
}

void BallExtentSearch::Search::decide(const RelativeError& f, const Rational& lo,
                                      const Rational& hi, long finest,
                                      std::vector<DecidedPiece>& pieces) {
    count(f);
    const RelativeError::Over over = f.over(lo, hi);
    if (over.side != Side::unknown) {
        pieces.push_back({lo, hi, over.side, over.side, {}});
        return;
    }
    if (over.monotone && roots_between(f, lo, hi, pieces)) {
        return;
    }
    if ((hi - lo) * power_of_two(finest) < hi) {
        pieces.push_back({lo, hi, Side::unknown, Side::unknown, {}});
        return;
    }
    const Rational m = middle(lo, hi);
    decide(f, lo, m, finest, pieces);
    decide(f, m, hi, finest, pieces);
}

/// The place where f is equal to a level, f being monotone from lo to hi. Newton's method finds it
/// and proves nothing; then two places with opposite signs enclose it (docs/extents.md).
Ball BallExtentSearch::Search::refine(const RelativeError& f, const DecidedPiece& piece) {
    const Ball level = *piece.root > 0 ? f.tolerance() : -f.tolerance();
    const bool rises = piece.from < piece.to;
    Rational lo = piece.lo;
    Rational hi = piece.hi;
    Rational x = (lo + hi) / 2;
    for (int k = 0; k < 200; ++k) {
        count(f);
        const auto [value, rate] = f.tangent(x);
        const Ball gap = value - level;
        if (certainly_positive(gap) == rises && !contains_zero(gap)) {
            hi = x;
        } else if (!contains_zero(gap)) {
            lo = x;
        }
        const Ball step = gap / rate;
        Rational next = (lo + hi) / 2;
        if (step.is_finite()) {
            const Rational newton = exact_value(Ball(Ball(x, f.bits()) - step).midpoint());
            const bool refined =
                abs(Rational(newton - x)) * power_of_two(f.bits() - kept_bits / 2) < hi;
            if (newton >= lo && newton <= hi) {
                next = newton;
            }
            if (refined || contains_zero(gap)) {
                x = next;
                break;
            }
        }
        x = exact_value(Ball(next, f.bits()).midpoint());
    }
    for (long k = f.bits() - kept_bits; k > 8; k -= 16) {
        count(f);
        const Rational slack = hi * power_of_two(-k);
        const Rational left = std::max(piece.lo, Rational(x - slack));
        const Rational right = std::min(piece.hi, Rational(x + slack));
        const Ball at_left = f.at(left) - level;
        const Ball at_right = f.at(right) - level;
        const bool signs = rises ? certainly_negative(at_left) && certainly_positive(at_right)
                                 : certainly_positive(at_left) && certainly_negative(at_right);
        if (signs) {
            return Ball::hull(Ball(left, f.bits()), Ball(right, f.bits()));
        }
    }
    return Ball::hull(Ball(piece.lo, f.bits()), Ball(piece.hi, f.bits()));
}

EnclosedExtents BallExtentSearch::Search::at(long bits) {
    if (pieces_.empty()) {
        scan();
    }
    const RelativeError f = error(bits);
    // The pieces that the scan did not decide are examined again at this number of bits.
    std::vector<DecidedPiece> pieces;
    for (const DecidedPiece& piece : pieces_) {
        if (piece.from == Side::unknown) {
            decide(f, piece.lo, piece.hi, bits - kept_bits, pieces);
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
    Ball entered = start;
    const auto leave = [&](const Ball& u) {
        found.measure += u - entered;
        if (!std::exchange(found.leaves, true)) {
            found.first_exit = u;
        }
    };
    bool within = pieces.front().from == Side::within;
    found.starts_within = within;
    if (!within) {
        found.leaves = true;
        found.first_exit = start;
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const DecidedPiece& piece = pieces[i];
        Ball place(0, bits);
        if (piece.root) {
            place = refine(f, piece);
        } else if (piece.from == Side::unknown) {
            const bool inner = i > 0 && i + 1 < pieces.size();
            const bool same = inner && pieces[i - 1].to == pieces[i + 1].from;
            const bool changes =
                inner && (pieces[i - 1].to == Side::within) != (pieces[i + 1].from == Side::within);
            place = Ball::hull(Ball(piece.lo, bits), Ball(piece.hi, bits));
            const bool corner = same && f.corner_between(piece.lo, piece.hi);
            if (corner && within) {
                // The error leaves the tolerance and returns on the other side of the corner.
                found.crossings.push_back(place);
                leave(place);
                within = false;
            } else if (corner && pieces[i - 1].to == Side::above) {
                // f passes from above the tolerance to -1 and back: it enters and leaves on either
                // side of the corner.
                found.crossings.insert(found.crossings.end(), 3, place);
                found.measure += place - place;
                entered = place;
                within = true;
            } else if (!changes) {
                throw BudgetError("undecided at " + std::to_string(bits) +
                                  " bits: the error may touch the tolerance at u = " +
                                  Ball(piece.lo, 64).midpoint().str(12));
            }
        } else {
            continue;
        }
        if (!certainly_less(start, place) || !certainly_less(place, end)) {
            throw BudgetError("undecided at " + std::to_string(bits) +
                              " bits: a crossing may lie on an end of the range");
        }
        found.crossings.push_back(place);
        within = !within;
        if (within) {
            entered = place;
        } else {
            leave(place);
        }
        found.single.resize(found.crossings.size(), piece.root.has_value());
    }
    if (within) {
        found.measure += end - entered;
    }
    return found;
}

BallExtentSearch::BallExtentSearch(Contact contact, Edge edge, std::size_t n,
                                   const formula::Exact& tolerance, ExtentRange range)
    : search_(std::make_unique<Search>(std::move(contact), edge, n, tolerance, std::move(range))) {}
BallExtentSearch::~BallExtentSearch() = default;
EnclosedExtents BallExtentSearch::at(long bits) { return search_->at(bits); }
std::size_t BallExtentSearch::evaluations() const { return search_->evaluations; }

} // namespace edgeproof::contact
