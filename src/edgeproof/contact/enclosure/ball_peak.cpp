// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_peak.hpp"

#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr std::size_t first_peak_pieces = 32;
constexpr std::size_t most_peak_halvings = 60;
constexpr std::size_t most_peak_evaluations = 20'000;

struct PeakPiece {
    Rational lo;
    Rational hi;
    std::optional<Real> most; ///< an upper bound of the pressure over the piece, if one is known
};

class PeakSearch {
public:
    PeakSearch(const ProvedPressure& contact, bool symmetric)
        : contact_(contact), symmetric_(symmetric), bits_(contact.bits()) {
        const Ball length = contact.a() + contact.b();
        // The second half of a symmetric contact is the mirror image of the first.
        end_ = exact_value((symmetric ? Ball(length / 2) : length).upper());
    }

    [[nodiscard]] Ball found() {
        std::vector<PeakPiece> pieces;
        for (std::size_t i = 0; i < first_peak_pieces; ++i) {
            const auto part = [&](std::size_t k) {
                return Rational(end_ * Rational(static_cast<long>(k), first_peak_pieces));
            };
            look(part(i), part(i + 1), pieces);
        }
        for (std::size_t depth = 0; depth < most_peak_halvings && spent_ < most_peak_evaluations;
             ++depth) {
            drop_low(pieces);
            if (const auto peak = isolated(pieces)) {
                return *peak;
            }
            std::vector<PeakPiece> halves;
            for (const PeakPiece& piece : pieces) {
                const Rational m = middle(piece.lo, piece.hi);
                look(piece.lo, m, halves);
                look(m, piece.hi, halves);
            }
            pieces = std::move(halves);
        }
        drop_low(pieces);
        if (pieces.empty() || !best_) {
            throw BudgetError("the pressure is not enclosed over the contact");
        }
        Real most = *best_;
        for (const PeakPiece& piece : pieces) {
            if (!piece.most) {
                throw BudgetError("the pressure is not enclosed near u = " +
                                  Ball(piece.hi, 64).midpoint().str(8));
            }
            most = std::max(most, *piece.most);
        }
        return Ball::from_interval(*best_, most, bits_);
    }

private:
    [[nodiscard]] Ball over(const Rational& lo, const Rational& hi) const {
        return Ball::hull(Ball(lo, bits_), Ball(hi, bits_));
    }
    void count() {
        check_interruption();
        spent_ += contact_.cost();
    }
    /// Updates the greatest lower bound by the enclosure of a pressure at a point.
    void take(const Ball& p) {
        if (p.is_finite() && (!best_ || p.lower() > *best_)) {
            best_ = p.lower();
        }
    }
    void look(const Rational& lo, const Rational& hi, std::vector<PeakPiece>& pieces) {
        count();
        const Ball u = over(lo, hi);
        const Rational m = middle(lo, hi);
        const Ball at_middle = contact_.pressure(Edge::right, Ball(m, bits_));
        take(at_middle);
        const BallSeries p = contact_.pressure_series(Edge::right, u, 2);
        if (p[1].is_finite() && (certainly_positive(p[1]) || certainly_negative(p[1]))) {
            return; // monotone: its maximum is at an end, and so also in the adjacent piece
        }
        std::optional<Real> most;
        const auto at_most = [&](const Ball& bound) {
            if (bound.is_finite()) {
                most = most ? std::min(*most, bound.upper()) : bound.upper();
            }
        };
        at_most(contact_.pressure(Edge::right, u));
        at_most(at_middle + p[1] * (u - Ball(m, bits_)));
        pieces.push_back({lo, hi, std::move(most)});
    }
    void drop_low(std::vector<PeakPiece>& pieces) const {
        std::erase_if(pieces, [&](const PeakPiece& piece) {
            return best_ && piece.most && *piece.most < *best_;
        });
    }
    /// The greatest pressure by Newton's method, if p is concave over all remaining pieces.
    [[nodiscard]] std::optional<Ball> isolated(const std::vector<PeakPiece>& pieces) {
        if (pieces.empty()) {
            return {};
        }
        count();
        const Ball left = over(pieces.front().lo, pieces.back().hi);
        const bool to_the_middle = symmetric_ && pieces.back().hi == end_;
        const Ball centre = Ball(contact_.a() + contact_.b()) / 2;
        // A symmetric interval about the middle: if p is concave there, p' = 0 in the middle.
        Ball place = to_the_middle ? Ball::hull(left, centre * 2 - left) : left;
        Ball bend = curvature(place);
        if (!bend.is_finite() || !certainly_negative(bend)) {
            return {};
        }
        if (to_the_middle) {
            return contact_.pressure(Edge::right, centre);
        }
        for (int step = 0; step < 100; ++step) {
            count();
            // The interval form of Newton's method (`moore-kearfott-cloud2009`).
            const Ball m(place.midpoint(), bits_);
            const Ball next = m - contact_.pressure_series(Edge::right, m, 2)[1] / bend;
            if (!next.is_finite() || !overlaps(next, place)) {
                return {};
            }
            if (next.radius() * 2 > place.radius()) {
                break;
            }
            place = next;
            bend = curvature(place);
        }
        if (place.relative_accuracy_bits() < bits_ / 2) {
            return {}; // halving makes more progress
        }
        const Ball m(place.midpoint(), bits_);
        const BallSeries p = contact_.pressure_series(Edge::right, m, 2);
        const Ball off = place - m;
        // Taylor: p(m) + p'(m) z + p'' z^2/2, with p'' enclosed over the whole interval.
        const Ball peak = p[0] + p[1] * off + bend / 2 * off * off;
        return peak.is_finite() ? std::optional(peak) : std::nullopt;
    }
    /// The enclosure of p'' over u.
    [[nodiscard]] Ball curvature(const Ball& u) const {
        return contact_.pressure_series(Edge::right, u, 3)[2] * 2;
    }

    const ProvedPressure& contact_;
    bool symmetric_;
    long bits_;
    Rational end_;
    std::optional<Real> best_; ///< a lower bound of the greatest pressure
    std::size_t spent_ = 0;
};

} // namespace

Ball enclosed_peak(const ProvedPressure& contact, bool symmetric) {
    return PeakSearch(contact, symmetric).found();
}

} // namespace edgeproof::contact
