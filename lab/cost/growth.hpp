// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/roots/power_law_fit.hpp"
#include "edgeproof/scene/route/plan.hpp"
#include "lab/cost/measure.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::cost {

/// The growth of the cost of one route in one arithmetic with the digits, over one case.
struct Growth {
    std::string scene;
    std::string route;
    std::string arithmetic;
    roots::PowerLawFit time;                       ///< median seconds for each value
    std::optional<roots::PowerLawFit> evaluations; ///< median
    /// Returns the ratio by which ten more digits raise the cost of a value, at 50 digits by the
    /// fit.
    [[nodiscard]] double ten_more() const;
};
/// Returns the growth of each route measured at two or more numbers of digits, in the order of the
/// cells. Cells that were not timed, or failed at every point, are left out.
[[nodiscard]] std::vector<Growth> growths(const std::vector<CostCell>& cells);

/// The cost of a proof: the median time of an enclosure, compared with that of the bare value.
struct BoundCost {
    std::string scene;
    unsigned digits = 0;
    std::string bare; ///< the fastest route in MPFR that keeps its digits
    double bare_seconds = 0;
    double enclosure_seconds = 0;
    double rounded_seconds = 0; ///< enclosed, and rounded to the digits asked for
};
/// Returns an entry for each case and number of digits that has both.
[[nodiscard]] std::vector<BoundCost> bound_costs(const std::vector<CostCell>& cells);

/// A scene with one thing more than its base, run by the method of `edgeproof pressure`.
struct EffectCost {
    std::string effect; ///< "shear under full stick"
    std::string base;   ///< the effect with which it is compared; empty: it is itself a base
    scene::Work work;   ///< the counted work
    double seconds = 0; ///< of the processor, for the whole scene, median over repeats
    double ratio = 1;   ///< of `seconds` to the base's
};

/// Measures what a tilt, shear, expansions and extents add to ten pressures of a punch, and what
/// ten values of the other quantities cost. Throws Interrupted.
[[nodiscard]] std::vector<EffectCost>
effect_costs(unsigned digits, bool timed,
             const std::function<void(std::size_t, std::size_t)>& progress);

} // namespace edgeproof::cost
