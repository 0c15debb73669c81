// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/reference.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::conformance {

/// How much a value depends on the numbers of its question.
struct Conditioning {
    /// What the value moves by, in parts of itself, when each number of the question (parameters,
    /// u, tolerance) is moved by half a unit in the last place of its binary64: the sum over the
    /// numbers. A program that rounds its inputs once may be off by that much and be right.
    double moved = 0;
    /// The relative condition number: moved in units of 2^-53.
    [[nodiscard]] double number() const { return moved * 0x1p53; }
};

/// An error of so many times `moved` is still put down to the conditioning: a sound program rounds
/// more than once on its way.
inline constexpr double explained_by_conditioning = 8;

/// The conditioning of the questions that are listed (by index), computed from the references at
/// the two neighbours half a unit away (at the one above; at the one below where there is no
/// contact above), at 34 digits. Zeros are not moved: they are exact. Nothing where neither
/// neighbour has a value, or where the value is zero.
[[nodiscard]] std::vector<std::optional<Conditioning>>
conditioning(const Questions& questions, const std::vector<Reference>& references,
             const std::vector<std::size_t>& which, ReferenceOptions options);

} // namespace edgeproof::conformance
