// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>
#include <vector>

namespace edgeproof::contact {

/// F(y, b) = 2F1(1, b; 3/2; y), the sum of c_k y^k with c_k = (b)_k/(3/2)_k (DLMF 15.2.1), at many
/// places for one b: the c_k of the last b are kept. One object belongs to one thread.
class EdgeSum {
public:
    /// Encloses F for all numbers of both balls, |y| < 1. Nothing where b may reach 1, where so
    /// few terms are needed that b + k is still negative behind them, and where so many are that
    /// another series is better.
    [[nodiscard]] std::optional<Ball> operator()(const Ball& b, const Ball& y);

private:
    /// c_0 ... c_n.
    void carry(const Ball& b, long n, long bits);

    ArbValue b_;
    long bits_ = 0;
    std::vector<ArbValue> c_;
};

} // namespace edgeproof::contact
