// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

#include <array>

namespace edgeproof::contact {

/// A function of x and z with its first and second derivatives.
struct PlaneJet {
    Ball value;
    std::array<Ball, 2> first;  ///< by x, by z
    std::array<Ball, 3> second; ///< by xx, xz, zz
    [[nodiscard]] bool is_finite() const;
    /// True if the function is proved to be strictly concave.
    [[nodiscard]] bool concave() const;
};

[[nodiscard]] Ball square(const Ball& x);
[[nodiscard]] PlaneJet square(const PlaneJet& f);
/// The root of a function, whose value is `size`.
[[nodiscard]] PlaneJet root(const PlaneJet& f, const Ball& size);
/// by f + with g.
[[nodiscard]] PlaneJet sum(const Ball& by, const PlaneJet& f, const Ball& with, const PlaneJet& g);

} // namespace edgeproof::contact
