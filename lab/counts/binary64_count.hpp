// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/double_word/double_word.hpp"
#include "lab/counts/counting.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace edgeproof::validation {

enum class DrawnPlace : std::uint8_t { by_the_edge, inside, by_a_knot };
inline constexpr std::array<std::string_view, 3> drawn_places{"by the edge", "inside", "by a knot"};

struct Binary64Options : CountOptions {
    /// Changes a value in double words before it is rounded, for a test that a wrong bound is
    /// counted.
    std::function<void(DoubleWord&)> changed = {};
};

inline constexpr std::size_t places_a_contact = 10'000;

/// Compares pressures in double words (contact/double_word) with balls of 320 bits. Draws contacts
/// with a form in double words (sample.hpp; power laws only with whole and half exponents), and
/// places in each: u from 1e-60 of the length to the full length, uniformly, and near knots down to
/// the last bits. The result depends only on the seed and the number of values, not on the number
/// of threads. Values are undecided if they are left to balls. Throws Interrupted.
[[nodiscard]] CountResult<std::string> count_binary64(const Binary64Options& options);
/// The rows are the places.
[[nodiscard]] report::Table binary64_table(const CountResult<std::string>& count);

/// The findings are texts with the scene, the place and both numbers of a wrong value.
[[nodiscard]] CountedContact<std::string>
count_binary64_contact(const Binary64Options& options, std::size_t number, std::size_t values);

} // namespace edgeproof::validation
