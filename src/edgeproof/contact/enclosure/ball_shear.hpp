// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::contact {

/// Q per unit length and sigma_0, signs as in shear.hpp.
struct BallShearLoad {
    Ball Q;
    Ball bulk_tension;
};

/// q under full stick (moore-hills.tex eqn:Shear_Adhered) at the distance u from an edge of a
/// contact of `length` a + b; an enclosure, a stress. Not finite where u may be an end.
[[nodiscard]] Ball full_stick_traction(const Ball& length, const BallShearLoad& load, Edge edge,
                                       const Ball& u);

/// K_II, L_II, M_II, ... of u^(-1/2), u^(1/2), u^(3/2), ..., each enclosed. Written out, not by the
/// series of shear.hpp: with (1 - z)^(-1/2) = sum beta_k z^k and u = length z,
///     s_k length^(k + 1/2) = (Q/pi +- sigma_0 length/8) beta_k -+ (sigma_0 length/4) beta_{k-1}.
[[nodiscard]] std::vector<Ball> full_stick_expansion(const Ball& length, const BallShearLoad& load,
                                                     Edge edge, std::size_t terms);

} // namespace edgeproof::contact
