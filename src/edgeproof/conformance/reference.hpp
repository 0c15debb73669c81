// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/question.hpp"

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

/// The answer to each question, in their order and the same whatever the number of threads.
/// Throws InputError, with the line of the question, for a point outside the contact or on a
/// corner and for a load that no contact carries; of several, always the same one.
/// BudgetError where a quadrature does not reach its digits; Error where it was stopped.
[[nodiscard]] std::vector<Reference> references(const Questions& questions,
                                                const ReferenceOptions& options);

} // namespace edgeproof
