// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/double_word/double_word.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::validation {

enum class DrawnPlace : std::uint8_t { by_the_edge, inside, by_a_knot };
inline constexpr std::array<std::string_view, 3> drawn_places{"by the edge", "inside", "by a knot"};

/// The kind of value: p, q in three ways, the sum of 1 to 3 terms and its relative error.
enum class DrawnForm : std::uint8_t { p, full_stick, similar, partial_slip, sum, relative_error };
inline constexpr std::array<std::string_view, 6> drawn_forms{
    "p", "q, full stick", "q, similar to p", "q, partial slip", "sum of terms", "relative error"};

struct Binary64Cell {
    std::size_t values = 0;
    std::size_t undecided = 0; ///< left to balls
    std::size_t wrong = 0;     ///< not the binary64 to which the ball rounds

    void add(const Binary64Cell& o);
};
using Binary64Cells = std::array<std::array<Binary64Cell, drawn_places.size()>, drawn_forms.size()>;

/// The state of a count: the results of the finished contacts.
struct Binary64State {
    std::uint64_t seed = 1;
    std::size_t values = 0;
    std::map<std::size_t, Binary64Cells> contacts;
};

struct Binary64Options {
    std::uint64_t seed = 1;
    std::size_t values = 1'000'000;
    unsigned threads = 0; ///< 0: as many as the machine has
    std::function<void(std::size_t, std::size_t)> progress = {};
    /// Called occasionally, and at the end, with the finished results, from one thread at a time.
    std::function<void(const Binary64State&)> checkpoint = {};
    /// Changes a value in double words before it is rounded, for a test that a wrong bound is
    /// counted.
    std::function<void(DoubleWord&)> changed = {};
};

struct Binary64Count {
    Binary64Cells cells{};
    Binary64Cell total;
    std::size_t contacts = 0;
    std::vector<std::string> findings; ///< wrong values: scene, place, both numbers
};

inline constexpr std::size_t places_a_contact = 10'000;

/// Compares values in double words (contact/double_word/double_word_*.hpp) with balls of 320 bits
/// (for a relative error 1,024). Draws contacts with a form in double words (sample.hpp; power laws
/// only with whole and half exponents), and places in each: u from 1e-60 of the length to the full
/// length, uniformly, and near knots and the edges of stick zones down to the last bits; q at
/// |Q|/(f P) from 9/10 to 1e-10. The result depends only on the seed and the number of values, not
/// on the number of threads. Contacts in `state` are not repeated, unless they had findings. Throws
/// Interrupted.
[[nodiscard]] Binary64Count count_binary64(const Binary64Options& options, Binary64State& state);

struct Binary64Contact {
    Binary64Cells cells{};
    std::vector<std::string> findings;
};
[[nodiscard]] Binary64Contact count_binary64_contact(const Binary64Options& options,
                                                     std::size_t number, std::size_t values);

/// Writes the contacts without findings, one line each.
[[nodiscard]] std::string write_binary64_state(const Binary64State& state);
/// Throws InputError with the line for a text that is not such a state, or one of another seed or
/// number of values than `wanted`.
[[nodiscard]] Binary64State parse_binary64_state(std::string_view text, const std::string& file,
                                                 const Binary64State& wanted);

} // namespace edgeproof::validation
