// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <span>

namespace edgeproof::scene {

/// A quantity at many places that are binary64 numbers.
struct Binary64Question {
    Quantity quantity = Quantity::p; ///< p, q, local (n terms of p) or rel
    std::size_t n = 0;               ///< number of terms of local and rel
    contact::Edge edge = contact::Edge::right;
    bool from_origin = false; ///< the places are coordinates x, else distances u from the edge
};

/// Computes a quantity of a scene at each place: the binary64 nearest to the exact value at exactly
/// that place, in units of the contact modulus (rel: a number). The scene's [ask] is ignored.
/// Double words decide most values of contacts with a formula in double words, run_scene computes
/// the others. The values are proved where those of run_scene are (Plan::proved).
///
/// p and q are 0 outside the contact, p is infinite at a corner of the profile. Throws InputError
/// for a load that no contact carries, for places outside the contact (local, rel), at an edge (q
/// under full stick, local, rel) and at a corner (q), and if the scene lacks the data for the
/// quantity; DomainError for NaN; BudgetError if no budget decides the last bit; Interrupted.
/// `places` and `values` have the same size.
void compute_binary64(const Scene& scene, const Binary64Question& question,
                      std::span<const double> places, std::span<double> values);

} // namespace edgeproof::scene
