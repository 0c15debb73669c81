// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/law/logarithmic_pressure.hpp"

#include <utility>

namespace edgeproof::contact {
namespace {

BallSeries integral(const BallSeries& s, const Ball& constant) {
    BallSeries r(constant, s.order());
    for (std::size_t k = 0; k + 1 < s.order(); ++k) {
        r.set(k + 1, s[k] / static_cast<long>(k + 1));
    }
    return r;
}

BallSeries nowhere(std::size_t order, long bits) {
    Ball x(0, bits);
    arb_indeterminate(x.data());
    BallSeries s(x, order);
    for (std::size_t k = 1; k < order; ++k) {
        s.set(k, x);
    }
    return s;
}

} // namespace

BallSeries BallContact::pressure_series(Edge edge, const Ball& u, std::size_t order) const {
    const Ball D = a_ + b_;
    const BallSeries from = BallSeries::variable(u.with_bits(bits_), order);
    const BallSeries other = -from + D;
    if (!certainly_positive(u) || !certainly_positive(other[0])) {
        return nowhere(order, bits_);
    }
    if (power_) {
        const Ball x = a_ - u;
        if (contains_zero(x)) {
            return nowhere(order, bits_);
        }
        const Ball q = abs(x) / a_;
        const Ball y = u * other[0] / (a_ * a_);
        // q I' = m I - 1/sqrt(1 - q^2) (docs/pressure.md, "Closed form: power laws"), term by term.
        const BallSeries at = BallSeries::variable(q, order);
        BallSeries s = -(at * at) + Ball(1, bits_);
        s.set(0, y);
        s = BallSeries(Ball(1, bits_), order) / sqrt(s);
        std::vector<Ball> I{(*power_law_integral_)(q, y)};
        for (std::size_t k = 0; k + 1 < order; ++k) {
            const long n = static_cast<long>(k);
            I.push_back(((power_->exponent - n) * I[k] - s[k]) / (q * (n + 1)));
        }
        const Ball rate = certainly_positive(x) ? -(1 / a_) : 1 / a_;
        Ball scale = fixed_.factor;
        for (Ball& c : I) {
            c *= scale;
            scale *= rate;
        }
        return BallSeries(I);
    }
    const bool right = edge == Edge::right;
    const Ball& right_x = right ? u : other[0];
    const Ball& left_x = right ? other[0] : u;
    const BallSeries w_x = sqrt(from * other);
    const BallSeries zero(Ball(0, bits_), order);
    struct Green {
        BallSeries value;
        BallSeries moment;
    };
    bool on_knot = false;
    const BallSeries sum = logarithmic_sum(
        slope_, slope_.knots.size(), w_x * fixed_.arc,
        [&](std::size_t i) { return fixed_.bends[i] && !on_knot; },
        [&](std::size_t i) {
            const Ball& knot = slope_.knots[i];
            const BallSeries offset = right ? from + (knot - a_) : -from + (b_ + knot); // v - x
            if (contains_zero(offset[0])) {
                on_knot = true;
                return Green{zero, zero};
            }
            // dG/du = w(v)/(w(x) (distance of v - u)) (docs/pressure.md, "Closed form: piecewise
            // linear slopes").
            const Mark<Ball>& v = fixed_.marks[i];
            const BallSeries rate = BallSeries(v.w, order) / (w_x * (right ? -offset : offset));
            BallSeries G = integral(rate, ball_green(v, right_x, left_x, D, offset[0]).value);
            BallSeries moment = offset * G;
            return Green{std::move(G), std::move(moment)};
        });
    return on_knot ? nowhere(order, bits_) : sum * fixed_.factor;
}

std::vector<Ball> BallContact::corners(Edge edge) const {
    std::vector<Ball> distances;
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        if (profile_.has_corner(i) && !fixed_.marks[i].end) {
            distances.push_back(edge == Edge::right ? a_ - slope_.knots[i] : b_ + slope_.knots[i]);
        }
    }
    return distances;
}

Ball BallContact::reach(Edge edge) const {
    Ball least = a_ + b_;
    if (power_) {
        // docs/extents.md: the majorant of a power law holds for rho < a/(m + 4)
        return a_ / (power_->exponent + 4);
    }
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        const Mark<Ball>& m = fixed_.marks[i];
        if (fixed_.bends[i]) {
            least = min(least, edge == Edge::right ? m.right : m.left);
        }
    }
    return least;
}

Ball BallContact::majorant(Edge edge, const Ball& rho) const {
    // docs/extents.md: the size of each coefficient is at most that of the majorant, so that |c_k|
    // rho^k <= M.
    const Ball D = a_ + b_;
    const Ball pi = Ball::pi(bits_);
    if (power_) {
        // p/sqrt(u) = (P'/(pi a)) sqrt(2a - u) 2F1(1, (1 - m)/2; 3/2; y) is bounded with 2 sqrt(2a)
        // for the root and (1 - Y)^(-|1 - m|/2) for 2F1, Y = 2 rho/a + (rho/a)^2.
        const Ball eta = rho / a_;
        const Ball rate = power_->force_rate(a_);
        return rate / (pi * a_) * sqrt(a_ * 2) * 2 *
               pow(1 - eta * 2 - eta * eta, -(abs(1 - power_->exponent) / 2));
    }
    // With z = u (D - u_v)/((D - u) u_v), G = 2 artanh sqrt(z) = 2 (z^(1/2) + z^(3/2)/3 + ...), and
    // G/sqrt(u) has no negative coefficient. The sizes of the coefficients of sqrt(D - u), times
    // rho^k, sum to less than 2 sqrt(D).
    const bool right = edge == Edge::right;
    const Ball other = D - rho;
    Ball sum(0, bits_);
    for (std::size_t i = 0; i < slope_.knots.size(); ++i) {
        if (!fixed_.bends[i]) {
            continue;
        }
        const Mark<Ball>& v = fixed_.marks[i];
        const Ball distance = right ? v.right : v.left;
        const Ball offset = right ? rho - distance : distance - rho;
        const Ball G =
            ball_green(v, right ? rho : other, right ? other : rho, D, offset).value / sqrt(rho);
        sum += abs(slope_.rate_drop(i)) * (rho + distance) * G;
        if (profile_.has_corner(i)) {
            sum += abs(slope_.jump(i)) * G;
        }
    }
    return modulus_ / (pi * 2) * (sum + abs(fixed_.arc) * sqrt(D) * 2);
}

} // namespace edgeproof::contact
