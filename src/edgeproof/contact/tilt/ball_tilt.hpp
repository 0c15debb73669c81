// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/precision/ball/ball.hpp"

namespace edgeproof::contact {

/// A tilt known to lie in a ball, and a profile of a tilt beside it or in it.
struct EnclosedTilt {
    Ball alpha;
    Profile near;
    bool exactly_zero = false; ///< upright: `near` is the profile itself
};

/// The tilt at which a punch carries P and M, proved: M - M(alpha) has opposite signs, in balls, at
/// two exact tilts, and M(alpha) is monotone (tilt_solver.hpp gives dM/dalpha, which is positive).
/// Where to try comes from solve_tilt, which decides nothing. Throws InputError as it does, and
/// BudgetError where so many bits do not tell the signs.
[[nodiscard]] EnclosedTilt enclose_tilt(const TiltedPunch& punch,
                                        const formula::Exact& contact_modulus,
                                        const formula::Exact& P, const formula::Exact& M,
                                        long bits);

} // namespace edgeproof::contact
