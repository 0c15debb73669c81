// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

namespace edgeproof::scene {

/// True if the profile is a power law x^m, 0 < m <= 1, whose pressure falls from the origin to the
/// edges (docs/pressure.md), so that the greatest pressure is P'(a)/(pi m).
[[nodiscard]] bool peaks_in_the_middle(const Scene& scene);

/// Throws DomainError: the profile has a corner at x inside the contact.
[[noreturn]] void refuse_infinite_peak(const Real& x);

} // namespace edgeproof::scene
