// SPDX-License-Identifier: GPL-3.0-or-later
// The expansion of the pressure of a curved body of revolution at its edge.
#include "edgeproof/contact/curved/curved_body.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"

namespace edgeproof::contact {

// p/sqrt(u) = (E*/pi) times the integral of h'(a - u t) (1 - t)^(-1/2) (2a - u (1 + t))^(-1/2) over
// 0 < t < 1 (docs/axisymmetric.md, "The expansion").
Ball CurvedBody::most_rate(const Ball& rho) const {
    constexpr long across = 6; // boxes from -rho to rho
    const Ball half = rho / across;
    Ball most(0, bits_);
    for (long i = 0; i < across; ++i) {
        for (long j = 0; 2 * j < across; ++j) { // h' is real on the real axis
            const Box z(half * (2 * i + 1 - across) + up_to(half),
                        half * (2 * j + 1) + up_to(half));
            const Ball here = abs(approach_rate(radius_near_edge(z), {}));
            if (!here.is_finite()) {
                return unknown_ball(bits_);
            }
            most = max(most, upper_end(here));
        }
    }
    return most;
}

Ball CurvedBody::reach(Edge /*edge*/) const {
    Ball rho = a_;
    for (const Ring& ring : rings_) {
        if (inside(ring.knot)) {
            rho = min(rho, a_ - ring.v);
        }
    }
    rho = lower_end(rho) * 3 / 4;
    for (int k = 0; k < 40 && certainly_positive(rho); ++k, rho = rho / 2) {
        if (most_rate(rho).is_finite()) {
            return lower_end(rho);
        }
    }
    return {0, bits_};
}

Ball CurvedBody::majorant(Edge /*edge*/, const Ball& rho) const {
    return modulus_ / Ball::pi(bits_) * most_rate(rho) * 2 / sqrt((a_ - rho) * 2);
}

// The Taylor coefficients of h' at a by Cauchy's formula over a circle of a sixteenth of the disk
// on which h' is bounded by M. The mean over N points adds the coefficients k + N, k + 2N, ...
// (`trefethen-weideman2014`), which are at most M/reach^(k + lN).
std::vector<Ball> CurvedBody::approach_rates(std::size_t terms) const {
    constexpr long bits_of_ratio = 4;
    const Ball rho = reach(Edge::right);
    if (!certainly_positive(rho)) {
        return std::vector<Ball>(terms, unknown_ball(bits_));
    }
    const Ball most = upper_end(most_rate(rho));
    const Ball circle = rho / (1L << bits_of_ratio);
    const auto points = bits_ / bits_of_ratio + static_cast<long>(terms) + 2;
    std::vector<Box> sums(terms, Box(bits_));
    for (long j = 0; 2 * j <= points; ++j) { // h' is real on the real axis
        const Ball angle = Ball::pi(bits_) * (2 * j) / points;
        const Box turn(cos(angle), sin(angle));
        const Box z = turn * circle;
        const Box h =
            approach_rate(radius_near_edge(z), {}) * Ball(j == 0 || 2 * j == points ? 1 : 2, bits_);
        Box power(Ball(1, bits_));
        for (std::size_t k = 0; k < terms; ++k) {
            sums[k] = sums[k] + h * power;
            power = power * conj(turn);
        }
    }
    std::vector<Ball> rates;
    Ball scale(1, bits_);
    Ball bound = most * power_of_two(-bits_of_ratio * points, bits_) * 2;
    for (std::size_t k = 0; k < terms; ++k) {
        rates.push_back(sums[k].real() / points / scale + up_to(bound));
        scale *= circle;
        bound /= rho;
    }
    return rates;
}

std::vector<Ball> CurvedBody::force_rates(std::size_t terms) const {
    const std::vector<Ball> h = approach_rates(terms);
    std::vector<Ball> rates;
    for (std::size_t k = 0; k < terms; ++k) {
        const Ball rate = (k == 0 ? h[k] * a_ : h[k] * a_ + h[k - 1]) * modulus_ * 2;
        rates.push_back(k % 2 == 0 ? rate : -rate);
    }
    return rates;
}

} // namespace edgeproof::contact
