// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/load.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>

namespace edgeproof::contact {

/// Both edges of a contact as exact numbers: it reaches from -b to a.
struct ExactEdges {
    formula::Exact a;
    formula::Exact b;
};

/// The edges of the contact where one of them lies on a knot exactly, or where g' is odd all over
/// it, which no number of bits tells: `near_a` and `near_b`, known to most of their bits, suggest
/// them, and exact algebra (formula/identity.hpp) proves that they balance (moore-hills.tex,
/// eqn:Consistency) and carry the load (eqn:AppliedNormalForce_NonSym). Nothing where no edge comes
/// near a knot, or where there is no such proof: then it is not known whether one lies on a knot.
[[nodiscard]] std::optional<ExactEdges> exact_edges(const Profile& profile,
                                                    const formula::Exact& contact_modulus,
                                                    const Load& load, const Ball& near_a,
                                                    const Ball& near_b);

/// Proved: g'(-x) = -g'(x) for 0 < x < a.
[[nodiscard]] bool odd_within(const Profile& profile, const formula::Expr& a);

} // namespace edgeproof::contact
