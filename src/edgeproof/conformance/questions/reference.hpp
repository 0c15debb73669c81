// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/precision/error.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::conformance {

/// The reference for an answer: the value with its bound, and the coordinate x of a point.
struct Reference {
    scene::BoundedValue value;
    std::optional<scene::BoundedValue> x;
};

struct ReferenceOptions {
    scene::Digits digits;
    unsigned threads = 0; ///< 0: as many as the machine has
    /// Called with the number of values done, and their total; from any thread.
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// Returns the answer to each question, in order, independent of the number of threads. Throws
/// InputError, with the line of the question, for a point outside the contact or on a corner and
/// for a load that no contact carries; of several such errors, always the same one. Throws
/// BudgetError if a quadrature does not reach its digits; Interrupted.
[[nodiscard]] std::vector<Reference> references(const Questions& questions,
                                                const ReferenceOptions& options);

struct ReferenceOrWhy {
    std::optional<Reference> reference;
    std::string why; ///< a point outside the contact, or an exhausted budget
};
/// Like references, with a reason for each missing answer. With `strict`, throws as references()
/// does for an invalid contact; without it, such questions have no answer either. Throws
/// Interrupted.
[[nodiscard]] std::vector<ReferenceOrWhy>
references_or_why(const Questions& questions, const ReferenceOptions& options, bool strict = true);

/// A question (by index) asked in another way, by its number.
using Way = std::pair<std::size_t, std::size_t>;
/// Returns the values of questions asked in other ways, where they have one. `change` changes the
/// contact, once for all questions about it that are asked in the same way; `place` the question.
/// Both may return false, or throw Error, for a way that is none.
[[nodiscard]] std::map<Way, Ball>
values_otherwise(const Questions& questions, const std::vector<Way>& ways,
                 const std::function<bool(const Way&, AskedContact&)>& change,
                 const std::function<bool(const Way&, Question&, const scene::Scene&)>& place,
                 const ReferenceOptions& options);

/// The dependence of a value on the numbers of its question.
struct Conditioning {
    /// The relative change of the value when each number of the question (parameters, u, tolerance)
    /// changes by half a unit in the last place of its binary64: the sum over the numbers. A
    /// correct program that rounds its inputs once may have this error.
    double moved = 0;
    /// The relative condition number: `moved` in units of 2^-53.
    [[nodiscard]] double number() const { return moved * 0x1p53; }
};

/// An error of up to this multiple of `moved` is attributed to the conditioning: a correct program
/// rounds more than once.
inline constexpr double explained_by_conditioning = 8;

/// Computes the conditioning of the questions listed (by index) from the references at the two
/// neighbours half a unit away (at the upper one, or at the lower one if there is no contact
/// above), at 34 digits. Zeros are exact and are not changed. Returns nothing if neither neighbour
/// has a value, or if the value is zero.
[[nodiscard]] std::vector<std::optional<Conditioning>>
conditioning(const Questions& questions, const std::vector<Reference>& references,
             const std::vector<std::size_t>& which, ReferenceOptions options);

} // namespace edgeproof::conformance
