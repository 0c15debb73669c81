// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/work.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::cost {

/// A scene with one thing more than its base, run as `edgeproof pressure` runs it.
struct EffectCost {
    std::string effect; ///< "shear under full stick"
    std::string base;   ///< the effect that it is compared with; empty: it is a base itself
    contact::Work work; ///< what was done, counted
    double seconds = 0; ///< of the processor, for the whole scene, median over repeats
    double ratio = 1;   ///< over the base's
};

/// What a tilt, shear, expansions and extents add to ten pressures of a punch, at so many digits.
/// Throws Interrupted.
[[nodiscard]] std::vector<EffectCost>
effect_costs(unsigned digits, bool timed,
             const std::function<void(std::size_t, std::size_t)>& progress);

} // namespace edgeproof::cost
