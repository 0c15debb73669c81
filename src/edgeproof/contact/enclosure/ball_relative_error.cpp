// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::contact {
namespace {

constexpr long fewest_taylor_terms = 8;
constexpr long most_taylor_terms = 200;
constexpr int most_halvings = 8000;

} // namespace

Rational exact_value(const Real& x) {
    Rational q;
    mpfr_get_q(q.backend().data(), x.backend().data());
    return q;
}

Rational middle(const Rational& lo, const Rational& hi) {
    const Ball m(Rational((lo + hi) / 2), 64);
    const Rational near = exact_value(m.midpoint());
    return near > lo && near < hi ? near : Rational((lo + hi) / 2);
}

RelativeError::RelativeError(const ProvedContact& contact, Edge edge, std::size_t n,
                             const Exact& tolerance)
    : contact_(contact), edge_(edge), c_(contact.expansion(edge, n)), bits_(contact.bits()),
      tolerance_(enclosed_constant(tolerance, bits_)) {
    // Enough terms that the remainder is small compared with the tolerance without many halvings.
    const long small = -arf_abs_bound_lt_2exp_si(arb_midref(tolerance_.data()));
    taylor_terms_ = static_cast<std::size_t>(
        std::clamp(fewest_taylor_terms + small / 4, fewest_taylor_terms, most_taylor_terms));
    // A series of many terms loses bits with each of them: intervals of any width would then be
    // undecided.
    const Ball reach(contact.reach(edge).lower(), bits_);
    Ball room = c_[0] * tolerance_ / 256;
    for (const Ball& c : c_) {
        if (!certainly_less(Ball(c.radius(), bits_), room)) {
            throw BudgetError("the expansion at the edge is not enclosed");
        }
        room /= reach;
    }
}

Side side_of(const Ball& f, const Ball& tolerance) {
    if (!f.is_finite()) {
        return Side::unknown;
    }
    return certainly_less(tolerance, f)        ? Side::above
           : certainly_less(f, -tolerance)     ? Side::below
           : certainly_less(abs(f), tolerance) ? Side::within
                                               : Side::unknown;
}
Ball RelativeError::at(const Rational& u) const {
    const Ball x(u, bits_);
    return local(x) / contact_.pressure(edge_, x) - 1;
}
std::pair<Ball, Ball> RelativeError::tangent(const Rational& u) const {
    const BallSeries f = series(Ball(u, bits_), 2);
    return {f[0], f[1]};
}

RelativeError::Over RelativeError::over(const Rational& lo, const Rational& hi) const {
    const Ball u = Ball::hull(Ball(lo, bits_), Ball(hi, bits_));
    const Rational m = middle(lo, hi);
    Over found;
    const bool integrated = contact_.cost() > 1;
    if (integrated) { // p alone costs less than its derivatives
        found.side = side_of_whole(u);
        if (found.side != Side::unknown) {
            return found;
        }
    }
    const BallSeries whole = series(u, taylor_terms_ + 1);
    if (whole[taylor_terms_].is_finite()) {
        const BallSeries at = series(Ball(m, bits_), taylor_terms_);
        const Ball h = u - Ball(m, bits_);
        Ball f = whole[taylor_terms_];
        Ball rate = f * static_cast<long>(taylor_terms_);
        // Taylor's polynomial about m with the remainder over u, by Horner's rule.
        for (std::size_t k = taylor_terms_; k-- > 0;) {
            if (k > 0) {
                rate = rate * h + at[k] * static_cast<long>(k);
            }
            f = f * h + at[k];
        }
        found.side = side(f);
        found.monotone = certainly_positive(rate) || certainly_negative(rate);
        if (found.side != Side::unknown || found.monotone) {
            return found;
        }
    }
    found.side = integrated ? Side::unknown : side_of_whole(u);
    return found;
}
bool RelativeError::corner_between(const Rational& lo, const Rational& hi) const {
    const std::vector<Ball> corners = contact_.corners(edge_);
    return !certainly_less(Ball(1, bits_), tolerance_) &&
           std::any_of(corners.begin(), corners.end(), [&](const Ball& u) {
               return certainly_less(Ball(lo, bits_), u) && certainly_less(u, Ball(hi, bits_));
           });
}

Rational RelativeError::safe_distance() const {
    const Ball reach(contact_.reach(edge_).lower(), bits_);
    Ball rho = reach / 2;
    const Ball M = contact_.majorant(edge_, rho);
    const auto n = static_cast<long>(c_.size());
    Ball u = rho / 2;
    for (int k = 0; k < most_halvings && certainly_positive(u) && M.is_finite(); ++k) {
        // docs/expansions.md, "Next to the edge: a majorant"
        const Ball z = u / rho;
        const Ball tail = M * pow_int(z, n) / (1 - z);
        const Ball least = c_[0] - M * z / (1 - z);
        if (certainly_positive(least) && certainly_less(tail / least, tolerance_)) {
            return exact_value(u.with_bits(32).lower());
        }
        u /= 2;
    }
    throw BudgetError(std::to_string(bits_) + " bits do not separate the edge from a knot");
}

Ball RelativeError::local(const Ball& u) const { return horner(c_, u) * sqrt(u); }
BallSeries RelativeError::series(const Ball& u, std::size_t order) const {
    const BallSeries at = BallSeries::variable(u, order);
    BallSeries sum(c_.back(), order);
    for (std::size_t k = c_.size() - 1; k-- > 0;) {
        sum = sum * at + c_[k];
    }
    return sum * sqrt(at) / contact_.pressure_series(edge_, u, order) + Ball(-1, bits_);
}
Side RelativeError::side_of_whole(const Ball& u) const {
    const Ball near = local(u);
    const Ball p = contact_.pressure(edge_, u);
    if (p.is_finite() && certainly_positive(p)) {
        return side(near / p - 1);
    }
    const Ball one(1, bits_);
    if (p.is_finite()) {
        const Ball most(p.upper(), bits_);
        if (certainly_positive(most) && certainly_positive(near) &&
            certainly_less(tolerance_ + 1, near / most)) {
            return Side::above;
        }
        return certainly_positive(most) && certainly_negative(near) &&
                       certainly_less(near / most, 1 - tolerance_)
                   ? Side::below
                   : Side::unknown;
    }
    const Ball least = contact_.least_pressure(edge_, u);
    if (!least.is_finite() || !certainly_positive(least)) {
        return Side::unknown;
    }
    // |p_local/p| <= |p_local|/least, with the sign of p_local.
    const Ball ratio = near / Ball(least.lower(), bits_);
    return side(Ball::hull(ratio, Ball(0, bits_)) - 1);
}

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
    PeakSearch(const ProvedContact& contact, bool symmetric)
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

    const ProvedContact& contact_;
    bool symmetric_;
    long bits_;
    Rational end_;
    std::optional<Real> best_; ///< a lower bound of the greatest pressure
    std::size_t spent_ = 0;
};

} // namespace

Ball enclosed_peak(const ProvedContact& contact, bool symmetric) {
    return PeakSearch(contact, symmetric).found();
}

} // namespace edgeproof::contact
