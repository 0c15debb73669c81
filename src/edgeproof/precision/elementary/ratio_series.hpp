// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

#include <array>
#include <compare>
#include <optional>

namespace edgeproof {

/// The sum of c_k x^k over k, c_0 = 1, where c_{k+1}/c_k is a product of two quotients
/// (slope k + over)/(slope k + under) of positive integers: Gauss's 2F1 with rational parameters
/// (DLMF 15.2.1).
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

    /// Returns an enclosure of the sum for every number of the ball x, 0 < x < 1. Nothing if the
    /// ball is wide, reaches 0.999, or lies below 2^-600, or if the numbers do not fit into words;
    /// then the caller uses slower methods.
    /// @param x argument
    /// @param bits working precision
    [[nodiscard]] std::optional<Ball> sum(const Ball& x, long bits) const;
};

} // namespace edgeproof
