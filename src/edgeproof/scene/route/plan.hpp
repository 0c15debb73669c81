// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/work.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace edgeproof::scene {

/// Something that a scene may call for.
struct Effect {
    std::string name;
    bool on = false;
    std::string why;                       ///< it is on, or off
    std::size_t contact::Counts::*counter; ///< where it is counted; null: it is part of another
};

/// The effects that a scene calls for, and nothing else: a symmetric scene never solves
/// consistency, a scene without shear never touches shear, one edge asked is one edge computed, an
/// expansion is no longer than asked, and no pressure is computed where only coefficients are
/// wanted. At two edges of a symmetric scene the second is the first in a mirror.
struct Plan {
    Digits digits;
    bool proved = false;          ///< values are enclosures; else they come with estimated errors
    std::string proved_why;       ///< or why not
    long bits = 256;              ///< of the balls, at first
    long narrow_bits = 232;       ///< of what cancels little: the edges, places, pressures
    unsigned working_digits = 70; ///< of the routes in Real, at first; both are raised on the way
    contact::Route route = contact::Route::closed_form;
    std::vector<contact::Edge> edges; ///< as asked
    bool mirrored = false;            ///< the second edge's p is the first's
    std::size_t points = 0;           ///< at each edge
    std::size_t terms = 0;            ///< of the expansions; 0: none
    bool pressure = false;            ///< for itself, or since q is similar to it
    bool print_pressure = false;
    bool expand_pressure = false;
    bool shear = false;
    bool expand_shear = false;
    bool extents = false;
    bool partial_slip = false; ///< q has slip zones
    bool slip = false;         ///< their sizes for themselves
    bool resultants = false;   ///< P and M for themselves
    bool peak = false;         ///< the greatest pressure
    contact::Counts counts;    ///< foretold
    std::vector<Effect> effects;

    /// p at this edge is computed, not copied.
    [[nodiscard]] bool computes(contact::Edge edge) const {
        return !mirrored || edge == edges.front();
    }
    /// Of a relative error, which says how wrong something is: 20 digits, or as many as asked.
    [[nodiscard]] Digits error_digits() const {
        return {digits.count < 20 ? digits.count : 20, digits.rounding, false};
    }
};

/// Throws InputError where the scene gives no means for what it asks: pressures without points,
/// coefficients or extents without a number of terms, extents without a tolerance.
[[nodiscard]] Plan make_plan(const Scene& scene);

} // namespace edgeproof::scene
