// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/slip/ball_slip.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"

namespace edgeproof::contact {
namespace {

/// A zone whose pressure is integrated: with B_m beta functions and g_j the coefficients of
/// (1 - z)^(root/2), its integral is
///     sum over m of x^(m + lowest) B_m sum over j of c_{m-j} g_j (D - other)^(root/2 - j),
/// where x is the slip zone that is integrated over (DLMF 5.12.1).
struct Zone {
    std::size_t lowest; ///< the lowest power of x
    long root;
    long beta_from; ///< B_m/B_{m-1} = (2 m - 2 + beta_from)/(2 m - 2 + beta_over)
    long beta_over;
};
constexpr Zone of_this_edge{1, 1, 3, 4};  ///< p sqrt((D - other - u)/(x - u)), divided by pi/2
constexpr Zone of_the_other{2, -1, 3, 6}; ///< p sqrt((x - u)/(D - other - u)), divided by 2 pi

/// Divided by D^(root/2).
BallSeries integral(const Zone& zone, const std::vector<Ball>& c, const BallSeries& x,
                    const BallSeries& other, const Ball& D) {
    const Ball one(1, D.bits());
    BallSeries total(one * 0, x.order());
    if (x.order() <= zone.lowest) {
        return total;
    }
    const std::size_t count = x.order() - zone.lowest;
    const BallSeries rest = BallSeries(one, x.order()) - other * (one / D);
    const BallSeries inverse = BallSeries(one / D, x.order()) / rest;
    std::vector<BallSeries> powers{pow(rest, one * zone.root / 2)};
    std::vector<Ball> g{one};
    std::vector<Ball> beta{one};
    for (std::size_t j = 1; j < count; ++j) {
        const long k = static_cast<long>(j);
        powers.push_back(powers.back() * inverse);
        g.push_back(g.back() * (2 * k - 2 - zone.root) / (2 * k));
        beta.push_back(beta.back() * (2 * k - 2 + zone.beta_from) / (2 * k - 2 + zone.beta_over));
    }
    for (std::size_t m = count; m-- > 0;) {
        total = total * x;
        for (std::size_t j = 0; j <= m; ++j) {
            total = total + powers[j] * (c[m - j] * g[j] * beta[m]);
        }
    }
    for (std::size_t k = 0; k < zone.lowest; ++k) {
        total = total * x;
    }
    return total;
}

/// The coefficient of tau^order of the left side of the equation for the slip zones
/// (docs/partial-slip.md, "The series"), divided by sqrt(D) pi/2. d is the slip zone at this edge,
/// e the one at the other edge; c and o are the coefficients of p at these edges.
Ball balance(const std::vector<Ball>& c, const std::vector<Ball>& o, const BallSeries& d,
             const BallSeries& e, const Ball& D, std::size_t order) {
    const BallSeries near = d.resized(order + 1);
    const BallSeries far = e.resized(order + 1);
    return integral(of_this_edge, c, near, far, D)[order] +
           integral(of_the_other, o, far, near, D)[order] / (D * 4);
}

} // namespace

SlipSeries slip_series(const std::vector<Ball>& right, const std::vector<Ball>& left,
                       const Ball& length, const Ball& lead, const Ball& tension,
                       std::size_t terms) {
    const Ball zero(0, length.bits());
    BallSeries d(zero, terms + 1);
    BallSeries e(zero, terms + 1);
    SlipSeries series;
    // Each order follows from the lower ones: the equation is c_0 d plus terms of higher order.
    for (std::size_t n = 1; n <= terms; ++n) {
        // The right side of the equation: tau (lead +- tension (D - d - e)).
        const Ball stick = n == 1 ? length : -(d[n - 1] + e[n - 1]);
        const Ball by_force = n == 1 ? lead : zero;
        series.right.push_back(
            (by_force + tension * stick - balance(right, left, d, e, length, n)) / right[0]);
        series.left.push_back((by_force - tension * stick - balance(left, right, e, d, length, n)) /
                              left[0]);
        d.set(n, series.right.back());
        e.set(n, series.left.back());
    }
    return series;
}

Ball slip_sum(const std::vector<Ball>& kappa, std::size_t n, const Ball& tau) {
    return horner(std::vector<Ball>(kappa.begin(), kappa.begin() + static_cast<std::ptrdiff_t>(n)),
                  tau) *
           tau;
}

} // namespace edgeproof::contact
