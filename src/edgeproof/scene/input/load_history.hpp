// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/exact/exact.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::scene {

using formula::Exact;

/// The loads at the end of a step; they grow linearly from those at its beginning.
struct LoadStep {
    Exact P;
    Exact Q;
    Exact bulk_tension;
    std::size_t line = 0;
};

/// The state after a history of P and Q without a bulk tension (docs/histories.md). The shear
/// traction is
///   q = sum over j of ratio_j (p(x; force_j) - p(x; force_(j-1))),
/// where p(x; L) is the pressure of the same profile under the force L, and |ratio_j| <= f.
struct LoadHistory {
    struct Layer {
        Exact force; ///< at which the layer ends; the last one is P
        Exact ratio; ///< dq/dp in the layer
    };
    std::vector<Layer> layers; ///< by ascending force
    /// The contact under this force is the zone that stuck in the last step; empty if nothing
    /// slipped in it.
    std::optional<Exact> stick = {};
    /// The places that came into contact while P rose, for the last time, from the force of the
    /// entry before to `force`.
    struct Entry {
        Exact force;
        /// The change of dq/dp since then, up to `force`. Nothing if the edges slipped as P rose:
        /// it then depends on the place.
        std::optional<std::vector<Layer>> change;
    };
    std::vector<Entry> entries; ///< by ascending force; the last one ends at P
    /// A part of a step in which one zone slips in one direction: that outside the contact under
    /// the force `inner`. `inner` and P change linearly in time.
    struct Phase {
        Exact inner_from;
        Exact inner_to;
        Exact force_from; ///< P
        Exact force_to;
        Exact change;            ///< |dQ -+ f dP|
        std::vector<Exact> cuts; ///< these forces, ascending, without repetition
    };
    std::vector<Phase> step; ///< the phases of the last step
    /// The phases of the last pass of the steps that are repeated (`cycles`). Nothing if the last
    /// step is not the end of a pass.
    std::optional<std::vector<Phase>> pass = {};
    /// The state at the end of that pass is the one at its beginning, so that all later passes are
    /// alike.
    bool steady = false;
};

/// Returns the state after the first `count` steps, in which no bulk tension acts. `pass` is the
/// number of steps that are repeated, 0 if there are none; all passes end with the last step.
/// Throws InputError, with the line of the step, where the contact opens or slides.
[[nodiscard]] LoadHistory history_after(const std::vector<LoadStep>& steps, std::size_t count,
                                        std::size_t pass, const Exact& friction,
                                        const std::string& file);

} // namespace edgeproof::scene
