// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/work.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::cost {

/// A scene with one thing more than its base, run by the method of `edgeproof pressure`.
struct EffectCost {
    std::string effect; ///< "shear under full stick"
    std::string base;   ///< the effect with which it is compared; empty: it is itself a base
    contact::Work work; ///< the counted work
    double seconds = 0; ///< of the processor, for the whole scene, median over repeats
    double ratio = 1;   ///< of `seconds` to the base's
};

/// Measures what a tilt, shear, expansions and extents add to ten pressures of a punch. Throws
/// Interrupted.
[[nodiscard]] std::vector<EffectCost>
effect_costs(unsigned digits, bool timed,
             const std::function<void(std::size_t, std::size_t)>& progress);

} // namespace edgeproof::cost
