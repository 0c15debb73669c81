// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/csv.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// A file of wrong answers, and its error.
struct Corruption {
    std::string kind; ///< "one digit of one value", ...
    std::string what; ///< the row and its previous content
    std::string text; ///< the file
};

/// Returns `count` wrong files made from a correct one; the kinds of errors take turns. The seed
/// determines the files on every machine. Each file differs in its answers: a changed digit is one
/// of the first 15, so that the value differs by more than half a unit in the last place of a
/// double; edges and rows are exchanged only if their values differ. The file must have the columns
/// id and value, and two rows with different values; otherwise throws InputError.
[[nodiscard]] std::vector<Corruption> corruptions(const io::Csv& right, std::uint64_t seed,
                                                  std::size_t count);

/// Returns the table as text, without its notes.
[[nodiscard]] std::string csv_text(const io::Csv& csv);

} // namespace edgeproof::conformance
