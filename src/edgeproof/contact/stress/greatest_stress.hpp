// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/stress/stress_measure.hpp"

#include <cstddef>
#include <optional>
#include <vector>

/// The place at which tau_max, or the stress of von Mises, of a body is greatest, by branch and
/// bound with proof (docs/stress.md, "The greatest values").
namespace edgeproof::contact {

/// A place at which F of a StressMeasure is greater than everywhere else near it.
struct GreatestPlace {
    enum class Kind {
        inside,  ///< z > 0, where both derivatives vanish
        axis,    ///< the same on the axis x = 0 of a symmetric load
        surface, ///< z = 0, where F increases towards the surface
        edge     ///< an edge of the contact or of another part of the load, where F has a cusp
    };
    Kind kind = Kind::inside;
    std::size_t part = 0; ///< of an edge: the part of the load, 0 is the contact
    Edge edge = Edge::right;
    Box region{}; ///< in which there is no other such place, for kinds that are no edge
    Ball x{};
    Ball z{};
    Ball F{};
};

struct GreatestStress {
    /// One place. Two if the load is such that they are known to be mirror images of each other;
    /// then the first has x > 0.
    std::vector<GreatestPlace> places;
    std::size_t boxes = 0;
};

/// Encloses the place with the precision of the measure, from an enclosure at a lower precision.
/// Returns nothing if the bits do not suffice.
[[nodiscard]] std::optional<GreatestPlace> refined(const StressMeasure& F, GreatestPlace place);

/// Throws BudgetError, with the limits that are proved, if the boxes do not decide which place it
/// is, or if it is not one place. The profile must have no corner inside the contact.
[[nodiscard]] GreatestStress greatest_stress(const StressMeasure& F, std::size_t most_boxes);

} // namespace edgeproof::contact
