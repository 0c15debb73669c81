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

Ball RelativeError::at(const Rational& u) const {
    const Ball x(u, bits_);
    return local(x) / contact_.pressure(edge_, x) - 1;
}
std::pair<Ball, Ball> RelativeError::tangent(const Rational& u) const {
    const BallSeries f = series(Ball(u, bits_), 2);
    return {f[0], f[1]};
}

SideOver RelativeError::over(const Rational& lo, const Rational& hi) const {
    const Ball u = Ball::hull(Ball(lo, bits_), Ball(hi, bits_));
    const Rational m = middle(lo, hi);
    SideOver found;
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
    // |p_local/p| <= |p_local|/least, with the sign of p_local.
    return least.is_finite() && certainly_positive(least)
               ? side(Ball::hull(near / Ball(least.lower(), bits_), Ball(0, bits_)) - 1)
               : Side::unknown;
}

} // namespace edgeproof::contact
