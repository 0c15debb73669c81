// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/asked_list.hpp"
#include "edgeproof/precision/error.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::conformance {

/// What is to be held against: the value with its bound, and the place of a point.
struct Reference {
    scene::BoundedValue value;
    std::optional<scene::BoundedValue> x;
};

struct ReferenceOptions {
    scene::Digits digits;
    unsigned threads = 0; ///< 0: as many as the machine has
    /// Values done, of how many; from any thread.
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// The answer to each question, in their order and the same whatever the number of threads.
/// Throws InputError, with the line of the question, for a point outside the contact or on a
/// corner and for a load that no contact carries; of several, always the same one.
/// BudgetError where a quadrature does not reach its digits; Interrupted.
[[nodiscard]] std::vector<Reference> references(const Questions& questions,
                                                const ReferenceOptions& options);

/// The same with nothing where there is no answer. Throws Interrupted.
[[nodiscard]] std::vector<std::optional<Reference>>
references_where_any(const Questions& questions, const ReferenceOptions& options);

/// A reference, or why there is none.
struct ReferenceOrWhy {
    std::optional<Reference> reference;
    std::string why; ///< a point outside the contact, a budget that ran out
};
/// The same with the reason for each that has none. Throws as references() does for a contact that
/// is none; Interrupted.
[[nodiscard]] std::vector<ReferenceOrWhy> references_or_why(const Questions& questions,
                                                            const ReferenceOptions& options);

/// The answers piece by piece in this thread: `take` is given each, with its number, when it is
/// found. Throws as references() does.
void references_in_turn(const Questions& questions, const scene::Digits& digits,
                        const std::function<void(std::size_t, const Reference&)>& take);

/// Questions (by index) that are answered together, of one contact. They are cut alike however many
/// threads there are, and an answer depends on nothing outside its piece.
using Piece = std::vector<std::size_t>;
inline constexpr std::size_t most_in_a_piece = 128;
[[nodiscard]] std::vector<Piece> pieces_of(const Questions& questions);
[[nodiscard]] std::vector<Piece> pieces_of(const AskedList& asked);

} // namespace edgeproof::conformance
