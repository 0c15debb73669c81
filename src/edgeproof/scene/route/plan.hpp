// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>

namespace edgeproof::scene {

/// What the request of a scene needs, in addition to what it names: in a symmetric scene the second
/// edge is the mirror image of the first, an expansion has only the requested terms, and shear is
/// expanded only where that is used.
struct Plan {
    long bits = 256;        ///< initial bits of the balls
    long narrow_bits = 232; ///< for values that cancel little: edges, places, pressures
    std::size_t points = 0; ///< at each edge
    std::size_t terms = 0;  ///< of the expansions; 0: none
    bool expand_shear = false;
    bool partial_slip = false; ///< q has slip zones, and they are computed
};

/// Throws InputError if the scene lacks the data for its request: pressures without points,
/// coefficients or extents without a number of terms, extents without a tolerance.
[[nodiscard]] Plan make_plan(const Scene& scene);

/// True if the profile is a power law x^m, 0 < m <= 1, whose pressure falls from the origin to the
/// edges (docs/pressure.md), so that the greatest pressure is P'(a)/(pi m).
[[nodiscard]] bool peaks_in_the_middle(const Scene& scene);

/// Throws DomainError: the profile has a corner at x inside the contact.
[[noreturn]] void refuse_infinite_peak(const Real& x);

} // namespace edgeproof::scene
