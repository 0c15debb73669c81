// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

#include <array>
#include <compare>
#include <optional>

namespace edgeproof {

/// The sum over k of c_k x^k, c_0 = 1, where c_{k+1}/c_k is a product of two quotients
/// (slope k + over)/(slope k + under) of positive integers: Gauss's 2F1 of rational parameters.
struct RatioSeries {
    // clang-tidy 14 takes the 0 of a defaulted <=> for a pointer.
    // NOLINTBEGIN(modernize-use-nullptr)
    struct Quotient {
        long slope;
        long over;
        long under;
        [[nodiscard]] auto operator<=>(const Quotient&) const = default;
    };
    std::array<Quotient, 2> quotients;
    [[nodiscard]] auto operator<=>(const RatioSeries&) const = default;
    // NOLINTEND(modernize-use-nullptr)

    /// Encloses the sum for every number of the ball x, 0 < x < 1. Nothing where the ball is wide,
    /// reaches to 0.999, lies below 2^-600, or the numbers do not fit into words: there the caller
    /// has slower ways.
    [[nodiscard]] std::optional<Ball> sum(const Ball& x, long bits) const;
};

} // namespace edgeproof
