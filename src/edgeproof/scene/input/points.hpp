// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::scene {

using formula::Exact;

/// Ascending exact points, the same on every machine. Each is computed on demand, from any thread.
class PointRange {
public:
    /// Points from, ..., to in equal ratios, `per_decade` per factor of 10: from times a power of
    /// 10 if that is rational, else the decimal of 12 significant digits nearest to from
    /// 10^(k/per_decade). Both ends are included, exactly. Throws InputError unless 0 < from < to,
    /// or for more than 100,000 points.
    [[nodiscard]] static PointRange geometric(const Exact& from, const Exact& to,
                                              std::size_t per_decade);
    /// `count` >= 2 points from, ..., to at equal distances, exact. Throws InputError unless from <
    /// to.
    [[nodiscard]] static PointRange even(const Exact& from, const Exact& to, std::size_t count);

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Exact at(std::size_t k) const;
    [[nodiscard]] std::vector<Exact> all() const;
    [[nodiscard]] std::string text() const;

private:
    PointRange(Exact from, Exact to, std::size_t per_decade);
    [[nodiscard]] Real between(std::size_t k) const;

    Exact from_;
    Exact to_;
    std::size_t per_decade_; ///< 0: at equal distances
    std::size_t size_ = 2;
    Real first_; ///< from_, in the digits used for geometric points
    /// For rational points at equal distances: point k is ((n - k) lower + k upper)/(n under).
    struct Whole {
        Integer lower;
        Integer upper;
        Integer under;
    };
    std::optional<Whole> whole_;
};

} // namespace edgeproof::scene
