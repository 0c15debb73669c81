// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/question.hpp"
#include "edgeproof/precision/error.hpp"

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace edgeproof {

/// What is to be held against: the value with its bound, and the place of a point.
struct Reference {
    Vouched value;
    std::optional<Vouched> x;
};

struct ReferenceOptions {
    Digits digits;
    unsigned threads = 0; ///< 0: as many as the machine has
    const std::atomic<bool>* stop = nullptr;
    /// Values done, of how many; from any thread.
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// Thrown where `stop` was set.
class Stopped : public Error {
public:
    using Error::Error;
};

/// The answer to each question, in their order and the same whatever the number of threads.
/// Throws InputError, with the line of the question, for a point outside the contact or on a
/// corner and for a load that no contact carries; of several, always the same one.
/// BudgetError where a quadrature does not reach its digits; Stopped.
[[nodiscard]] std::vector<Reference> references(const Questions& questions,
                                                const ReferenceOptions& options);

/// The same with nothing where there is no answer. Throws Stopped.
[[nodiscard]] std::vector<std::optional<Reference>>
references_where_any(const Questions& questions, const ReferenceOptions& options);

/// Questions (by index) that are answered together. They are cut alike however many threads there
/// are, and an answer depends on nothing outside its piece: a table that is made piece by piece is
/// the same in every byte.
using Piece = std::vector<std::size_t>;
[[nodiscard]] std::vector<Piece> pieces_of(const Questions& questions);

/// Answers the pieces listed (by index), each handed to `take` when it is done, one at a time and
/// in any order: nothing is kept. Throws as references() does, and what `take` throws.
void answer_pieces(const Questions& questions, const std::vector<Piece>& pieces,
                   const std::vector<std::size_t>& wanted, const ReferenceOptions& options,
                   const std::function<void(std::size_t, std::vector<Reference>)>& take);

} // namespace edgeproof
