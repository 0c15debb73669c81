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

/// Computes the same number by two routes in Real that share only the edges of the contact:
///   pressure          Barber-Mossakovskii; the singular integral
///   coefficient       the series of the contact law; divided differences of p/sqrt(u)
///   residual          p minus its first terms, at more digits; the rest of the series over p
///   shear, its coefficients, load, left edge
///                     the library's route; the printed formula with more digits than it loses
///   tilt difference   as the pressure
///   extent            the library's scan; an independent scan with the printed pressure
/// Each aims at about `digits` correct digits. Throws as the routes do; Error for a quantity
/// without two routes.
[[nodiscard]] std::vector<SecondRoute>
second_routes(const scene::Scene& scene, const scene::AskedValue& asked, unsigned digits);

/// Returns the quantities that have two routes, in the order used in messages; hard cases are
/// limited to these.
[[nodiscard]] std::vector<scene::Quantity> second_route_quantities();

/// Finds the first exit by a scan that uses only the coefficients of the library, not
/// contact/extent.hpp: the pressure is the printed formula with more digits than it loses; every
/// local maximum of the error above half the tolerance is located by trisection; the root is found
/// by bisection. Throws DomainError if there is no exit.
[[nodiscard]] SecondRoute independent_extent(const scene::Scene& scene,
                                             const scene::AskedValue& asked, unsigned digits);

} // namespace edgeproof::validation
