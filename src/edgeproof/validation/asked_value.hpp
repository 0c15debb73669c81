// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/bounded_value.hpp"
#include "edgeproof/scene/scene_file.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::validation {

/// One number of a scene. Whatever a scene itself asks for is left aside.
struct AskedValue {
    enum class Kind {
        pressure,          ///< p at u
        coefficient,       ///< c_n of u^(n + 1/2) in p
        residual,          ///< 1 - (the first n terms)/p at u, with its sign
        shear,             ///< q at u
        shear_coefficient, ///< s_n of q; n = 0 under full stick is K_II
        load,              ///< P
        left_edge,         ///< b
        tilt_difference,   ///< p at u less that of the same profile and a, upright
        extent             ///< first exit of n terms from the tolerance
    };
    Kind kind = Kind::pressure;
    contact::Edge edge = contact::Edge::right;
    std::size_t n = 0;
    std::optional<formula::Exact> u = {};
    std::optional<formula::Exact> tolerance = {};

    [[nodiscard]] bool at_point() const {
        return kind == Kind::pressure || kind == Kind::residual || kind == Kind::shear ||
               kind == Kind::tilt_difference;
    }
};

/// "pressure", "coefficient", ..., as hard-cases.toml writes them.
[[nodiscard]] std::string kind_name(AskedValue::Kind kind);
[[nodiscard]] std::optional<AskedValue::Kind> asked_kind(std::string_view name);
/// "p at u = 1e-40 from the right edge", "c_1 at the left edge".
[[nodiscard]] std::string asked_text(const AskedValue& asked);

/// The scene asking for that value alone, to `digits` digits.
[[nodiscard]] scene::Scene asking(const scene::Scene& scene, const AskedValue& asked,
                                  unsigned digits);
/// The same scene with a tilt of zero. Throws InputError where the profile has no tilt.
[[nodiscard]] scene::Scene upright(const scene::Scene& scene);

/// The value as Edgeproof prints it: by the route that a plan of the scene chooses, an enclosure
/// where `proved` says so. Throws as run_scene does.
[[nodiscard]] scene::BoundedValue enclosed_value(const scene::Scene& scene, const AskedValue& asked,
                                                 unsigned digits);

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
/// Each is right to about `digits` digits if it is right. Throws what the routes throw.
[[nodiscard]] std::vector<SecondRoute> second_routes(const scene::Scene& scene,
                                                     const AskedValue& asked, unsigned digits);

} // namespace edgeproof::validation
