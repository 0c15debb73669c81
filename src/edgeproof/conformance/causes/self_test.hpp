// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/csv.hpp"
#include "edgeproof/scene/mistakes/scene_mistakes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// Relative, normally distributed noise of the answers.
inline constexpr std::array cause_noise_levels{0.0, 1e-6, 1e-3, 1e-2, 5e-2};
inline constexpr std::size_t least_percent_named = 90;

/// Gives the answers of programs with one mistake each, with noise, to questions about contacts of
/// every kind of profile, each under two loads, and counts the causes that infer_conventions()
/// names. The mistakes are made without the catalogue that is under test: the keys of the contact
/// are changed (scene/mistakes/scene_mistakes.hpp), or places and values as a program would change
/// them. Every cause reported, of any quantity, must have the name of the mistake, alone or among
/// those equally likely. A mistake is hidden if it changes fewer than eight answers by more than
/// five times the noise. The rows without a name are right answers, and errors that no mistake of
/// the catalogue explains. `contacts`: names of contacts, all if empty. Throws Interrupted.
[[nodiscard]] scene::MistakeCounts
test_causes(std::uint64_t seed, unsigned threads = 0, const std::vector<std::string>& contacts = {},
            const std::function<void(std::size_t, std::size_t)>& progress = {});

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
