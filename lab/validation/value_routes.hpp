// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <string>
#include <vector>

/// One number of a scene: by balls, and by two routes in Real.
namespace edgeproof::validation {

/// Returns the same scene with zero tilt. Throws InputError if the profile has no tilt.
[[nodiscard]] scene::Scene upright(const scene::Scene& scene);

/// Returns the value as Edgeproof prints it: by the route that a plan of the scene chooses; an
/// enclosure if `proved`. A residual and a tilt difference, which are computed from other values,
/// use as many additional digits as cancel. Throws as scene::SceneValues does.
[[nodiscard]] scene::BoundedValue enclosed_value(const scene::Scene& scene,
                                                 const scene::AskedValue& asked, unsigned digits);

/// A value in Real with the absolute error that its route claims.
struct SecondRoute {
    std::string route;
    Real value;
    Real error;
};

/// Computes the same number by two routes in Real that share only the edges of the contact:
///   pressure          Barber-Mossakovskii; the singular integral
///   coefficient       the series of the contact law; divided differences of p/sqrt(u)
///   residual          p minus its first terms, at more digits; the rest of the series over p
///   shear, its coefficients, load, left edge
///                     the library's route; the printed formula with more digits than it loses
///   tilt difference   as the pressure
///   extent            the library's scan; an independent scan with the printed pressure
///   stresses of normal contacts
///                     integrals of the printed pressure; integrals of g' (stress_formula.hpp)
///   axisymmetric contacts: pressure
///                     nested integrals of g'; elliptic integrals
///   axisymmetric contacts: load, approach
///                     integrals of g'; the printed formula
/// Each aims at about `digits` correct digits. Throws as the routes do; Error for a quantity
/// without two routes.
[[nodiscard]] std::vector<SecondRoute>
second_routes(const scene::Scene& scene, const scene::AskedValue& asked, unsigned digits);

/// Returns the quantities that have two routes, in the order used in messages; hard cases are
/// limited to these.
[[nodiscard]] std::vector<scene::Quantity> second_route_quantities(bool axisymmetric);

} // namespace edgeproof::validation
