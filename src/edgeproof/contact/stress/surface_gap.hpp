// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"

/// The gap between the bodies outside a contact, or outside a zone of its profile that is a contact
/// with a tilt (docs/stress.md).
namespace edgeproof::contact {

/// The gap (length) at the distance `beyond` >= 0 (length) outwards from an edge of a contact with
/// a closed form. Enclosed. It grows as beyond^(3/2) at the edge.
[[nodiscard]] Ball gap_beyond(const BallContact& contact, Edge edge, const Ball& beyond);

/// The gap (length) at the place x (length) on either side of a contact with a closed form, or of a
/// zone of its profile; 0 inside. Enclosed.
[[nodiscard]] Ball gap_at(const BallContact& contact, const Ball& x);

} // namespace edgeproof::contact
