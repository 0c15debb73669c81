// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/precision/ball/ball.hpp"

namespace edgeproof::contact {

/// A tilt enclosed by a ball (a slope, dimensionless), and the profile of a tilt in or near it.
struct EnclosedTilt {
    Ball alpha;
    Profile near;
    bool exactly_zero = false; ///< the tilt is 0, and `near` is its profile
};

/// The proved tilt at which a punch carries P and M: M - M(alpha) has opposite signs, in balls, at
/// two exact tilts, and M(alpha) is monotone, since dM/dalpha > 0 (tilt_solver.hpp). The trial
/// tilts come from solve_tilt, which proves nothing. The units are those of solve_tilt. Throws
/// InputError as solve_tilt does, and BudgetError if these bits do not decide the signs.
[[nodiscard]] EnclosedTilt enclose_tilt(const TiltedPunch& punch,
                                        const formula::Exact& contact_modulus,
                                        const formula::Exact& P, const formula::Exact& M,
                                        long bits);

} // namespace edgeproof::contact
