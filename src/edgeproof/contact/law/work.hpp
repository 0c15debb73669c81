// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>

namespace edgeproof::contact {

/// The number of steps of each kind in a computation. A plan predicts the counts, and the mechanics
/// counts each step where it is done. The object is passed as an argument, is never global, and
/// belongs to one thread.
struct Counts {
    std::size_t tilts = 0;            ///< tilts solved for from P and M
    std::size_t load_inversions = 0;  ///< contacts whose size was solved for from P
    std::size_t consistency = 0;      ///< contacts whose other edge was solved for
    std::size_t expansions = 0;       ///< edges at which p was expanded
    std::size_t closed_forms = 0;     ///< pressures in closed form
    std::size_t quadratures = 0;      ///< pressures by quadrature
    std::size_t shear_points = 0;     ///< shear tractions
    std::size_t shear_expansions = 0; ///< edges at which q was expanded
    std::size_t resultants = 0;       ///< forces and moments
    std::size_t extents = 0;          ///< edges and numbers of terms whose extent was searched for
    std::size_t stick_zones = 0;      ///< stick zones solved
    std::size_t slip_sizes = 0;       ///< edges at which the size of the slip zone was computed
    std::size_t stresses = 0;         ///< points at which the stresses were computed
    std::size_t displacements = 0;    ///< places at which the gap and the slip were computed

    friend bool operator==(const Counts&, const Counts&) = default;
};

/// The counts, and numbers that depend on the cancelled digits and cannot be predicted.
struct Work {
    Counts counts;
    std::size_t raised = 0;      ///< contacts solved again at a higher precision
    std::size_t evaluations = 0; ///< evaluations of the integrands of pressures
};

} // namespace edgeproof::contact
