// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/slip/slip_reach.hpp"

#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr long scan_bits_of_slip = 160;
constexpr int most_scans = 4;
constexpr long narrowest = 44; ///< bits to which load ratios are distinguished
constexpr long kept_bits = 24; ///< bits that are lost on the way to a crossing
constexpr int nearest_to_zero = 400;
constexpr int nearest_to_sliding = 60;

} // namespace

struct SlipReachSearch::Place {
    Rational tau;
    BallZone zone;
    Ball d;
};

/// E = d_n/d - 1 of a slip at one precision (docs/partial-slip.md, "How far n terms are good:
/// proved").
class SlipReachSearch::Error {
public:
    Error(SlipReachSearch& search, const BallSlip& slip, Edge edge, std::size_t n,
          const Exact& tolerance)
        : search_(search), slip_(slip), edge_(edge), bits_(slip.zones().bits()),
          tolerance_(formula::enclosed_constant(tolerance, bits_)) {
        const SlipSeries all = slip.series(n);
        kappa_ = edge == Edge::right ? all.right : all.left;
        for (const Ball& k : kappa_) {
            if (!k.is_finite()) {
                throw BudgetError("the expansion of the slip zone is not enclosed at " +
                                  std::to_string(bits_) + " bits");
            }
            rates_.push_back(k * static_cast<long>(rates_.size() + 1));
        }
    }
    [[nodiscard]] const Ball& tolerance() const { return tolerance_; }
    [[nodiscard]] Ball ball(const Rational& tau) const { return {tau, bits_}; }
    [[nodiscard]] Ball hull(const Rational& lo, const Rational& hi) const {
        return Ball::hull(ball(lo), ball(hi));
    }
    /// The place, from which on its zone is kept.
    [[nodiscard]] const Place& place(const Rational& tau) const {
        const auto next = places_.lower_bound(tau);
        if (next != places_.end() && next->first == tau) {
            return next->second;
        }
        search_.count(slip_.zones().cost());
        const BallZone& near =
            next == places_.begin() ? slip_.whole() : std::prev(next)->second.zone;
        Place p{tau, slip_.stick_at(ball(tau), near), Ball(0, bits_)};
        p.d = slip_.whole().at(edge_) - p.zone.at(edge_);
        return places_.emplace_hint(next, tau, std::move(p))->second;
    }
    /// d_n.
    [[nodiscard]] Ball terms(const Ball& tau) const { return terms_over(tau) * tau; }
    /// d_n/tau.
    [[nodiscard]] Ball terms_over(const Ball& tau) const { return horner(kappa_, tau); }
    [[nodiscard]] Ball at(const Rational& tau) const { return terms(ball(tau)) / place(tau).d - 1; }
    [[nodiscard]] Side side_at(const Rational& tau) const { return side(at(tau)); }
    [[nodiscard]] std::pair<Ball, Ball> tangent(const Rational& tau) const {
        return {at(tau), rate(place(tau), place(tau))};
    }
    /// For lo within the tolerance. The rate of E is that of rate() until E has left the tolerance,
    /// and while E is within twice the tolerance: with a rate of one sign E does not return.
    [[nodiscard]] SideOver over(const Rational& lo, const Rational& hi) const {
        const Place& from = place(lo);
        const Place& to = place(hi);
        const Ball slope = rate(from, to);
        if (!slope.is_finite()) {
            return {side(terms(hull(lo, hi)) / Ball::hull(from.d, to.d) - 1), false};
        }
        return {side(at(lo) + slope * hull(Rational(0), Rational(hi - lo))), !contains_zero(slope)};
    }
    /// True if the error is proved to be within the tolerance from 0 to `tau`.
    [[nodiscard]] bool within_from_the_start(const Rational& tau) const {
        // d/tau is a mean of d' between 0 and tau.
        const Ball mean = slip_.rate_between(slip_.whole(), place(tau).zone, edge_);
        return side(terms_over(hull(Rational(0), tau)) / mean - 1) == Side::within;
    }
    /// The same from `tau` up to full sliding.
    [[nodiscard]] bool within_to_sliding(const Rational& tau) const {
        const Ball d = slip_.sizes_to_sliding(place(tau).zone, edge_);
        return side(terms(hull(tau, Rational(1))) / d - 1) == Side::within;
    }

private:
    /// Encloses E' = (d_n' - (1 + E) d')/d over the load ratios between two places, if |E| is at
    /// most twice the tolerance there: over a long interval that bounds d_n/d = 1 + E better than
    /// enclosures of both.
    [[nodiscard]] Ball rate(const Place& lo, const Place& hi) const {
        const Ball tau = hull(lo.tau, hi.tau);
        const Ball d = Ball::hull(lo.d, hi.d);
        const Ball enclosed = terms(tau) / d;
        const Ball twice(Ball(tolerance_ * 2).upper(), bits_);
        const Ball ratio = enclosed.is_finite() && enclosed.radius() < twice.midpoint()
                               ? enclosed
                               : Ball::hull(1 - twice, 1 + twice);
        return (horner(rates_, tau) - ratio * slip_.rate_between(lo.zone, hi.zone, edge_)) / d;
    }
    [[nodiscard]] Side side(const Ball& E) const { return side_of(E, tolerance_); }

    SlipReachSearch& search_;
    const BallSlip& slip_;
    Edge edge_;
    long bits_;
    Ball tolerance_;
    std::vector<Ball> kappa_;
    std::vector<Ball> rates_; ///< the coefficients of d_n'
    mutable std::map<Rational, Place> places_;
};

SlipReachSearch::SlipReachSearch(Slip slip, Edge edge, std::size_t n, Exact tolerance)
    : slip_(std::move(slip)), edge_(edge), n_(n), tolerance_(std::move(tolerance)) {}

void SlipReachSearch::count(std::size_t cost) {
    check_interruption();
    zones_ += cost;
    if (zones_ > most_zones) {
        throw BudgetError("undecided after " + std::to_string(most_zones / cost) + " stick zones");
    }
}

void SlipReachSearch::scan() {
    const Ball decades = -log(formula::enclosed_constant(tolerance_, 64)) / log(Ball(2, 64));
    const long small = std::max(0L, static_cast<long>(decades.midpoint().convert_to<double>()));
    for (int attempt = 0; attempt < most_scans; ++attempt) {
        const long bits = (scan_bits_of_slip + 2 * small) << attempt;
        try {
            const Error f(*this, slip_(bits), edge_, n_, tolerance_);
            Rational tau(1, 2);
            for (int halvings = 1; !f.within_from_the_start(tau); tau /= 2) {
                if (++halvings > nearest_to_zero) {
                    throw BudgetError("the error of the slip zone is not enclosed near Q = 0");
                }
            }
            const Rational last = 1 - power_of_two(-nearest_to_sliding);
            while (!f.within_to_sliding(tau)) {
                if (tau >= last) {
                    throw BudgetError("undecided next to full sliding");
                }
                // At most half of the remaining distance.
                const Rational next =
                    std::min(exact_value(Ball(Rational(tau * Rational(3, 2)), 64).midpoint()),
                             Rational((tau + 1) / 2));
                const bool within =
                    for_each_side(f, tau, next, narrowest, [&](const SidePiece& piece) {
                        if (piece.to == Side::within) { // as it is at the beginning of the piece
                            return true;
                        }
                        if (!piece.root) {
                            throw BudgetError("the error of the slip zone touches the tolerance");
                        }
                        exit_ = piece;
                        return false;
                    });
                if (!within) {
                    break;
                }
                tau = next;
            }
            scanned_ = true;
            return;
        } catch (const BudgetError&) {
            if (zones_ > most_zones || attempt + 1 == most_scans) {
                throw;
            }
        }
    }
}

EnclosedReach SlipReachSearch::at(long bits) {
    if (!scanned_) {
        scan();
    }
    if (!exit_) {
        return {Ball(1, bits), false};
    }
    const Error f(*this, slip_(bits), edge_, n_, tolerance_);
    if (const auto ratio = enclosed_crossing(f, *exit_, bits, kept_bits)) {
        return {*ratio, true};
    }
    throw BudgetError("too few bits to enclose the load at which the tolerance is exceeded");
}

} // namespace edgeproof::contact
