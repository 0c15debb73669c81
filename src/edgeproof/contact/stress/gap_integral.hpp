// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/ball/ball.hpp"

/// The gap of a zone, integrated over the slip zones around it (docs/partial-slip.md, "The energy
/// of a cycle").
namespace edgeproof::contact {

/// Returns the integral of h(x) (pressure p(x) + punch/w(x)) dx over the places of `outer` outside
/// `inner`: h (length) is the gap of the contact `inner`, p and w = sqrt((a - x)(x + b)) are those
/// of `outer`. Enclosed, by rigorous integration in x = a_i + (a - a_i) sin^2(pi t/2), which
/// removes the roots at both ends. Wide if the bits do not distinguish the contacts.
/// @param inner a contact with a piecewise linear slope
/// @param outer a contact of the same profile under a greater force
/// @param pressure factor of p
/// @param punch factor of 1/w
[[nodiscard]] Ball gap_integral(const BallContact& inner, const BallContact& outer,
                                const Ball& pressure, const Ball& punch);

} // namespace edgeproof::contact
