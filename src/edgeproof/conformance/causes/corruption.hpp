// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/csv.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// A file of answers that is wrong, and how it came to be.
struct Corruption {
    std::string kind; ///< "one digit of one value", ...
    std::string what; ///< which row and what was there
    std::string text; ///< the file
};

/// `count` files made wrong from the right one, kind by kind in turn, from a seed: the same ones on
/// every machine. Each differs from the right file in what it answers: of a digit, one of the first
/// 15 is changed, which no double within half a unit in its last place survives; edges and rows are
/// exchanged only where their values differ. The file must have the columns id and value, and two
/// rows of different values. Throws InputError where it has not.
[[nodiscard]] std::vector<Corruption> corruptions(const io::Csv& right, std::uint64_t seed,
                                                  std::size_t count);

/// The table as text again, without its notes.
[[nodiscard]] std::string csv_text(const io::Csv& csv);

} // namespace edgeproof::conformance
