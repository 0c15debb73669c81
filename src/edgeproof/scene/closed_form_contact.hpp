// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <functional>
#include <optional>

namespace edgeproof::scene {

/// The contact of a scene in balls of any precision.
struct ClosedFormContact {
    contact::Profile profile; ///< if the tilt was found: that of a tilt near it
    std::function<contact::BallContact(long bits)> at;
};

/// Nothing for curved slopes. An unknown tilt is enclosed with `tilt_bits`. Throws as BallContact
/// and enclose_tilt do.
[[nodiscard]] std::optional<ClosedFormContact> closed_form_contact(const Scene& scene,
                                                                   long tilt_bits);

} // namespace edgeproof::scene
