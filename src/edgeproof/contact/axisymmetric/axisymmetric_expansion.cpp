// SPDX-License-Identifier: GPL-3.0-or-later
// The expansion of the pressure of an axisymmetric contact at its edge.
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"

#include <utility>
#include <vector>

namespace edgeproof::contact {

// docs/axisymmetric.md, "The expansion": p/sqrt(u) is a power series up to the next bend.
Ball AxisymmetricContact::reach(Edge /*edge*/) const {
    Ball least = a_;
    for (const Bend& bend : bends_) {
        if (!bend.at_origin && inside(bend.knot)) {
            least = min(least, a_ - bend.v);
        }
    }
    return least;
}

// p/sqrt(u) = (E*/pi) times the integral of h'(a - u t) (1 - t)^(-1/2) (2a - u (1 + t))^(-1/2) over
// 0 < t < 1: |h'| is bounded over the disk |s - a| <= rho. There v < |s|, so that the angle
// A = arccos(v/s) has |A| <= pi/2 + arcsin(v/|s|) <= pi (the series of arcsin has no negative
// coefficient), and y^2 = (s - v) (s + v).
Ball AxisymmetricContact::majorant(Edge /*edge*/, const Ball& rho) const {
    const Ball pi = Ball::pi(bits_);
    const Ball least = a_ - rho;
    const Ball greatest = a_ + rho;
    Ball most(0, bits_);
    for (const Bend& bend : bends_) {
        const Ball& v = bend.v;
        if (bend.at_origin) {
            most += abs(bend.jump) * pi / 2 + abs(bend.rate) * greatest * 2;
        } else if (inside(bend.knot)) {
            most += abs(bend.rate) * (sqrt((greatest - v) * (greatest + v)) * 2 + v * pi);
            if (!contains_zero(bend.jump)) {
                most += abs(bend.jump) * (pi + v / sqrt((least - v) * (least + v)));
            }
        }
    }
    return modulus_ / pi * most * 2 / sqrt(least * 2);
}

BallSeries AxisymmetricContact::approach_rate_series(std::size_t terms) const {
    const BallSeries s = BallSeries::variable(a_, terms);
    BallSeries rate(Ball(0, bits_), terms);
    for (const Bend& bend : bends_) {
        if (bend.at_origin) {
            rate = rate + s * (bend.rate * 2) + bend.jump * Ball::pi(bits_) / 2;
        } else if (!on_edge_[bend.knot] && !certainly_less(a_, bend.v)) {
            if (!certainly_less(bend.v, a_)) {
                return unknown_series(terms, bits_);
            }
            BallSeries y2 = s * s + -(bend.v * bend.v);
            y2.set(0, (a_ - bend.v) * (a_ + bend.v));
            const BallSeries y = sqrt(y2);
            const BallSeries A = atan(y * (1 / bend.v));
            rate = rate + (y * Ball(2, bits_) - A * bend.v) * bend.rate;
            if (!contains_zero(bend.jump)) {
                rate = rate + (A + BallSeries(bend.v, terms) / y) * bend.jump;
            }
        }
    }
    return rate;
}

std::vector<Ball> AxisymmetricContact::force_rates(std::size_t terms) const {
    const BallSeries rate =
        approach_rate_series(terms) * BallSeries::variable(a_, terms) * (modulus_ * 2);
    std::vector<Ball> rates;
    for (std::size_t k = 0; k < terms; ++k) {
        rates.push_back(k % 2 == 0 ? rate[k] : -rate[k]);
    }
    return rates;
}

std::vector<Ball> AxisymmetricContact::expansion(Edge /*edge*/, std::size_t terms) const {
    if (terms == 0) {
        return {};
    }
    // The plane contact with P'(s) = E* h'(s) has the same pressure.
    const BallSeries rate = approach_rate_series(terms);
    const BallSeries s = BallSeries::variable(a_, terms);
    const auto list = [&](const BallSeries& f) {
        std::vector<Ball> c;
        for (std::size_t k = 0; k < terms; ++k) {
            c.push_back(f[k]);
        }
        return series::Series<Ball>(std::move(c));
    };
    const LawSeries<Ball> law{list(rate * modulus_), list(s)};
    return coefficients_of(right_edge_brackets(law, a_), Ball(a_ * 2));
}

} // namespace edgeproof::contact
