// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/load.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>

namespace edgeproof::contact {

/// Both edges of a contact -b < x < a as exact numbers (lengths).
struct ExactEdges {
    formula::Exact a;
    formula::Exact b;
};

/// The exact edges of the contact, where one of them lies on a knot, or where g' is odd in the
/// whole contact; no number of bits can prove either. `near_a` and `near_b`, which are known to
/// most of their bits, suggest candidates, and exact algebra (formula/exact/identity.hpp) proves
/// that they satisfy the consistency condition (moore-hills EQ20) and carry the load (moore-hills
/// EQ22). Returns nothing if no edge is near a knot, or if there is no such proof: then it is not
/// known whether an edge lies on a knot. Lengths in one unit; forces in the unit of contact_modulus
/// times length.
[[nodiscard]] std::optional<ExactEdges> exact_edges(const Profile& profile,
                                                    const formula::Exact& contact_modulus,
                                                    const Load& load, const Ball& near_a,
                                                    const Ball& near_b);

/// True if g'(-x) = -g'(x) for 0 < x < a is proved.
[[nodiscard]] bool odd_within(const Profile& profile, const formula::Expr& a);

} // namespace edgeproof::contact
