// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace edgeproof::scene {

/// The number of steps of each kind in a computation. The route of a scene counts
/// each step where it is done. The object is passed as an argument and belongs to one thread.
struct Counts {
    std::size_t tilts = 0;           ///< tilts solved for from P and M
    std::size_t load_inversions = 0; ///< contacts whose size was solved for from P
    std::size_t consistency = 0;     ///< contacts whose other edge was solved for
    std::size_t expansions = 0;      ///< edges at which p, or q, was expanded
    std::size_t closed_forms = 0;    ///< pressures in closed form
    std::size_t quadratures = 0;     ///< pressures by quadrature
    std::size_t extents = 0;         ///< edges and numbers of terms whose extent was searched for
    std::size_t stick_zones = 0;     ///< stick zones solved

    friend bool operator==(const Counts&, const Counts&) = default;
};

/// The counts, and the number of repetitions, which depends on the digits that cancel.
struct Work {
    Counts counts;
    std::size_t raised = 0; ///< contacts solved again with more bits
};

/// What a scene needs, and nothing else. In a symmetric scene no consistency equation is
/// solved; without shear no shear is computed; only the requested edges are computed; an expansion
/// has only the requested terms; no pressure is computed if only coefficients are requested. For
/// two edges of a symmetric scene, the second is the mirror image of the first.
struct Plan {
    Digits digits;
    long bits = 256;         ///< initial bits of the balls
    long narrow_bits = 232;  ///< for values that cancel little: edges, places, pressures
    bool closed = true;      ///< pressures have a closed form; otherwise they are integrals
    std::vector<Edge> edges; ///< in the order of the request
    bool mirrored = false;   ///< p at the second edge is copied from the first
    std::size_t points = 0;  ///< at each edge
    std::size_t terms = 0;   ///< of the expansions; 0: none
    bool print_pressure = false;
    bool shear = false;
    bool expand_shear = false;
    bool extents = false;
    bool partial_slip = false; ///< q has slip zones
    bool slip = false;         ///< the sizes of slip zones are requested
    bool resultants = false;   ///< P and M are requested
    bool peak = false;         ///< the greatest pressure
    bool stress = false;       ///< stresses at points of the bodies
    bool displacement = false; ///< the gap outside the contact, and the slip inside

    /// True if p at this edge is computed, not copied.
    [[nodiscard]] bool computes(Edge edge) const { return !mirrored || edge == edges.front(); }
    /// The digits of a relative error: 20, or fewer if fewer are requested.
    [[nodiscard]] Digits error_digits() const {
        return {digits.count < 20 ? digits.count : 20, digits.rounding, false};
    }
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
