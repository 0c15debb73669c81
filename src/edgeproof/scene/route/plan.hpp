// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace edgeproof::scene {

struct Effect {
    std::string name;
    bool on = false;
    std::string why;              ///< the reason why it is on or off
    std::size_t Counts::*counter; ///< of the effect; null: it is part of another
};

/// The effects that a scene needs, and no others. In a symmetric scene no consistency equation is
/// solved; without shear no shear is computed; only the requested edges are computed; an expansion
/// has only the requested terms; no pressure is computed if only coefficients are requested. For
/// two edges of a symmetric scene, the second is the mirror image of the first.
struct Plan {
    Digits digits;
    bool proved = false;          ///< values are enclosures; otherwise their errors are estimates
    std::string proved_why;       ///< the reason for `proved`
    long bits = 256;              ///< initial bits of the balls
    long narrow_bits = 232;       ///< for values that cancel little: edges, places, pressures
    unsigned working_digits = 70; ///< of the routes in Real, at first; raised as needed
    Route route = Route::closed_form;
    std::vector<Edge> edges; ///< in the order of the request
    bool mirrored = false;   ///< p at the second edge is copied from the first
    std::size_t points = 0;  ///< at each edge
    std::size_t terms = 0;   ///< of the expansions; 0: none
    bool pressure = false;   ///< requested, or needed since q is similar to it
    bool print_pressure = false;
    bool expand_pressure = false;
    bool shear = false;
    bool expand_shear = false;
    bool extents = false;
    bool partial_slip = false; ///< q has slip zones
    bool slip = false;         ///< the sizes of slip zones are requested
    bool resultants = false;   ///< P and M are requested
    bool peak = false;         ///< the greatest pressure
    bool stress = false;       ///< stresses at points of the bodies
    bool displacement = false; ///< the gap outside the contact, and the slip inside
    Counts counts;             ///< predicted counts
    std::vector<Effect> effects;

    /// True if p at this edge is computed, not copied.
    [[nodiscard]] bool computes(Edge edge) const { return !mirrored || edge == edges.front(); }
    /// The digits of a relative error: 20, or fewer if fewer are requested.
    [[nodiscard]] Digits error_digits() const {
        return {digits.count < 20 ? digits.count : 20, digits.rounding, false};
    }
};

/// Returns how the plan computes pressures, in words.
[[nodiscard]] std::string way_of_pressure(const Scene& scene, const Plan& plan);

/// Throws InputError if the scene lacks the data for its request: pressures without points,
/// coefficients or extents without a number of terms, extents without a tolerance.
[[nodiscard]] Plan make_plan(const Scene& scene);

/// True if the profile is a power law x^m, 0 < m <= 1, whose pressure falls from the origin to the
/// edges (docs/pressure.md), so that the greatest pressure is P'(a)/(pi m).
[[nodiscard]] bool peaks_in_the_middle(const Scene& scene);

/// Throws DomainError: the profile has a corner at x inside the contact.
[[noreturn]] void refuse_infinite_peak(const Real& x);

} // namespace edgeproof::scene
