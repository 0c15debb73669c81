// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {

/// 1/F for the pressure of a power law, which is proportional to sqrt(z (1 - z)) F with z = u/(2a),
/// F = 2F1(1, b; 3/2; y), y = 4 z (1 - z) and b = (1 - m)/2. From Euler's integral (DLMF 15.6.1),
///   F = 1/2 int_0^1 (1 - t)^(-1/2) (1 - y t)^(-b) dt,
/// follows that F and all of its derivatives by b grow with b, and that F grows with y where b > 0
/// and falls where b < 0. Values at the ends of z and b therefore enclose all between, the middle
/// of the contact (y = 1) included, where F has no derivative by z if m < 1.
[[nodiscard]] Ball reciprocal_edge_function(const Ball& z, const Ball& b);
/// The same for series of three terms. At the middle it is finite only if z is a constant.
[[nodiscard]] BallSeries reciprocal_edge_function(const BallSeries& z, const BallSeries& b);

/// F(y, b) = 2F1(1, b; 3/2; y), the sum of c_k y^k with c_k = (b)_k/(3/2)_k (DLMF 15.2.1), at many
/// places for one b: the c_k of the last b are kept. One object belongs to one thread.
class EdgeSum {
public:
    /// Encloses F and its derivatives by y, divided by factorials, `count` numbers, for all numbers
    /// of both balls, |y| < 1. Returns nothing if b may reach 1, if b + k is still negative after
    /// the few terms that are needed, or if another series needs fewer terms.
    [[nodiscard]] std::optional<std::vector<Ball>> operator()(const Ball& b, const Ball& y,
                                                              std::size_t count);

private:
    /// Computes c_0 ... c_n and the coefficients of `count` - 1 derivatives.
    void carry(const Ball& b, long n, long bits, std::size_t count);

    ArbValue b_;
    long bits_ = 0;
    std::vector<std::vector<ArbValue>> c_; ///< c_[d][k] = C(k + d, d) c_(k + d)
};

} // namespace edgeproof::contact
