// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <string>
#include <vector>

namespace edgeproof::validation {

/// A value in Real with the absolute error that its route claims.
struct SecondRoute {
    std::string route;
    Real value;
    Real error;
};

/// The same number by two routes in Real that share no formula beyond the contact's own edges:
///   pressure          Barber-Mossakovskii; the singular integral
///   coefficient       the series of the contact law; divided differences of p/sqrt(u)
///   residual          p less its first terms, at more digits; the tail of the series over p
///   shear, its coefficients, load, left edge
///                     the library's route; the printed formula, at so many digits that what it
///                     loses does not matter
///   tilt difference   as the pressure
///   extent            the library's scan; a scan of its own, by the residual's first route
/// Each is right to about `digits` digits if it is right. Throws what the routes throw; Error for a
/// quantity that has no two routes.
[[nodiscard]] std::vector<SecondRoute>
second_routes(const scene::Scene& scene, const scene::AskedValue& asked, unsigned digits);

/// The quantities that have two routes, in the order in which messages name them: those that a hard
/// case may ask for.
[[nodiscard]] std::vector<scene::Quantity> second_route_quantities();

} // namespace edgeproof::validation
