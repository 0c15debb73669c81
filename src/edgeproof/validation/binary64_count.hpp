// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::validation {

/// Where a pressure is asked for.
enum class DrawnPlace : std::uint8_t { by_the_edge, inside, by_a_knot };
inline constexpr std::size_t drawn_places = 3;

/// Pressures in double words (contact/batch/double_word_pressure.hpp), held against balls.
struct Binary64Count {
    struct Cell {
        std::size_t values = 0;
        std::size_t undecided = 0; ///< left to balls
        std::size_t wrong = 0;     ///< not the binary64 that the ball of 320 bits rounds to
    };
    std::array<Cell, drawn_places> cells{};
    std::size_t contacts = 0;
    std::vector<std::string> findings; ///< wrong ones: scene, edge, u, both numbers

    [[nodiscard]] Cell total() const;
};

/// Draws contacts whose slope is piecewise linear (sample.hpp), and 10,000 places in each: u from
/// 1e-60 of the length to all of it, evenly, and by knots to the last bits. The same for the same
/// seed. Throws Interrupted.
[[nodiscard]] Binary64Count
count_binary64(std::uint64_t seed, std::size_t values,
               const std::function<void(std::size_t, std::size_t)>& progress = {});

} // namespace edgeproof::validation
