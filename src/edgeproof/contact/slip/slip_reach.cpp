// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/slip/slip_reach.hpp"

#include "edgeproof/contact/enclosure/isolate_zero.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace edgeproof::contact {
namespace {

constexpr long scan_bits_of_slip = 160;
constexpr int most_scans = 4;
constexpr int narrowest_step = 44; ///< bits to which load ratios are distinguished
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
    Error(const BallSlip& slip, Edge edge, std::size_t n, const Exact& tolerance)
        : slip_(slip), edge_(edge), bits_(slip.zones().bits()),
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
    [[nodiscard]] long bits() const { return bits_; }
    [[nodiscard]] const BallSlip& slip() const { return slip_; }
    [[nodiscard]] std::size_t cost() const { return slip_.zones().cost(); }
    [[nodiscard]] const Ball& tolerance() const { return tolerance_; }
    [[nodiscard]] Ball ball(const Rational& tau) const { return {tau, bits_}; }
    [[nodiscard]] Ball hull(const Rational& lo, const Rational& hi) const {
        return Ball::hull(ball(lo), ball(hi));
    }
    [[nodiscard]] Place place(const Rational& tau, const BallZone& near) const {
        Place p{tau, slip_.stick_at(ball(tau), near), Ball(0, bits_)};
        p.d = slip_.whole().at(edge_) - p.zone.at(edge_);
        return p;
    }
    /// d_n.
    [[nodiscard]] Ball terms(const Ball& tau) const { return terms_over(tau) * tau; }
    /// d_n/tau.
    [[nodiscard]] Ball terms_over(const Ball& tau) const { return horner(kappa_, tau); }
    [[nodiscard]] Ball at(const Place& p) const { return terms(ball(p.tau)) / p.d - 1; }
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
    [[nodiscard]] bool within(const Ball& E) const { return side(E) == Side::within; }
    [[nodiscard]] bool within_to_sliding(const Place& p) const {
        const Ball d = slip_.sizes_to_sliding(p.zone, edge_);
        return within(terms(hull(p.tau, Rational(1))) / d - 1);
    }

private:
    const BallSlip& slip_;
    Edge edge_;
    long bits_;
    Ball tolerance_;
    std::vector<Ball> kappa_;
    std::vector<Ball> rates_; ///< the coefficients of d_n'
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

bool SlipReachSearch::within_from_the_start(const Error& f, const Rational& tau) const {
    const Place p = f.place(tau, f.slip().whole());
    // d/tau is a mean of d' between 0 and tau.
    const Ball mean = f.slip().rate_between(f.slip().whole(), p.zone, edge_);
    return f.within(f.terms_over(f.hull(Rational(0), tau)) / mean - 1);
}

void SlipReachSearch::scan() {
    const Ball decades = -log(formula::enclosed_constant(tolerance_, 64)) / log(Ball(2, 64));
    const long small = std::max(0L, static_cast<long>(decades.midpoint().convert_to<double>()));
    for (int attempt = 0; attempt < most_scans; ++attempt) {
        const long bits = (scan_bits_of_slip + 2 * small) << attempt;
        try {
            const Error f(slip_(bits), edge_, n_, tolerance_);
            Rational tau(1, 2);
            int halvings = 1;
            while (!within_from_the_start(f, tau)) {
                count(f.cost());
                tau /= 2;
                if (++halvings > nearest_to_zero) {
                    throw BudgetError("the error of the slip zone is not enclosed near Q = 0");
                }
            }
            Place lo = f.place(tau, f.slip().whole());
            Rational step(1, 4); // relative to lo, at first
            const Rational last = 1 - power_of_two(-nearest_to_sliding);
            for (;;) {
                count(f.cost());
                if (f.within_to_sliding(lo)) {
                    leaves_ = false;
                    scanned_ = true;
                    return;
                }
                if (lo.tau >= last) {
                    throw BudgetError("undecided next to full sliding");
                }
                Rational next = lo.tau * (1 + step);
                next = exact_value(f.ball(next).with_bits(64).midpoint());
                // A step towards 1 is at most half of the remaining distance.
                const Rational nearer = (lo.tau + 1) / 2;
                const Rational to = std::min(next, nearer);
                const Place hi = f.place(to, lo.zone);
                const Ball at_lo = f.at(lo);
                const Ball at_hi = f.at(hi);
                // The rate of E is in this ball until E has left the tolerance, and while E is
                // within twice the tolerance. With a rate of one sign E therefore does not return.
                const Ball rate = f.rate(lo, hi);
                const bool monotone = rate.is_finite() && !contains_zero(rate);
                const Ball over =
                    rate.is_finite() ? at_lo + rate * Ball::hull(Ball(0, bits), f.ball(to - lo.tau))
                                     : f.terms(f.hull(lo.tau, to)) / Ball::hull(lo.d, hi.d) - 1;
                if (f.within(over) || (monotone && f.within(at_lo) && f.within(at_hi))) {
                    lo = hi;
                    step = std::min(Rational(1, 2), Rational(step * Rational(3, 2)));
                    continue;
                }
                if (monotone && f.within(at_lo) && f.side(at_hi) != Side::unknown) {
                    lo_ = lo.tau;
                    hi_ = to;
                    side_ = f.side(at_hi) == Side::above ? 1 : -1;
                    scanned_ = true;
                    return;
                }
                step = (to - lo.tau) / lo.tau / 2;
                if (step < power_of_two(-narrowest_step)) {
                    throw BudgetError("the error of the slip zone touches the tolerance");
                }
            }
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
    if (!leaves_) {
        return {Ball(1, bits), false};
    }
    const Error f(slip_(bits), edge_, n_, tolerance_);
    const Ball level = side_ > 0 ? f.tolerance() : -f.tolerance();
    Place p = f.place(lo_, f.slip().whole());
    const auto gap_at = [&](const Rational& tau) {
        count(f.cost());
        p = f.place(tau, p.zone);
        return f.at(p) - level;
    };
    const auto ratio = enclosed_crossing(
        {lo_, hi_, side_ > 0}, bits, 24,
        [&](const Rational& tau) {
            const Ball gap = gap_at(tau);
            return std::pair(gap, f.rate(p, p));
        },
        gap_at);
    if (ratio) {
        return {*ratio, true};
    }
    throw BudgetError("too few bits to enclose the load at which the tolerance is exceeded");
}

} // namespace edgeproof::contact
