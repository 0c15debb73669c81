// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/reference.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::conformance {

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
