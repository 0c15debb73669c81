// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/enclosure/proved_contact.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::audit {

using contact::Edge;
using formula::Exact;
using formula::Expr;

/// True for the profile "flat-punch".
[[nodiscard]] bool is_flat_punch(std::string_view profile);

/// One scene of a family; all its numbers are exact.
struct SceneSpec {
    std::string family;  ///< the family from which it was drawn (not the union of families)
    std::string profile; ///< the kind of a scene's profile, "piecewise-symmetric" or "flat-punch"
    /// All parameters of the family: those with names of keys of a scene (`Es` for
    /// `contact_modulus`, `sig0` for `bulk_tension`), and its own.
    std::map<std::string, Exact, std::less<>> parameters;
    std::string geometry; ///< of the scene; may be empty
    /// For the profile "piecewise": slopes as functions of x between ascending knots.
    std::vector<Expr> knots;
    std::vector<Expr> slopes;

    [[nodiscard]] const Exact& parameter(std::string_view name) const;
    /// True for a rigid flat punch with sharp edges under the force P. It has no slope: its
    /// pressure is the traction that the shear force Q = P has under full stick.
    [[nodiscard]] bool flat_punch() const { return is_flat_punch(profile); }
    /// Returns the values of the names in formulas: the parameters, and of a flat punch Q and sig0.
    [[nodiscard]] std::map<std::string, Exact, std::less<>> names() const;
    /// The scene by the reader of scenes, with its shear or without; of a flat punch one with the
    /// same edges. Throws InputError as that reader does, and for bodies of revolution that are no
    /// power laws.
    [[nodiscard]] std::shared_ptr<const scene::Scene> as_scene(bool with_shear = false) const;
    /// The greatest value of a stress in body A, to these digits (scene::greatest_value), or of the
    /// pressure (Quantity::p_max), without its place.
    [[nodiscard]] std::shared_ptr<const scene::GreatestValue> greatest(scene::Quantity stress,
                                                                       unsigned digits) const;
    /// Its contact in balls.
    [[nodiscard]] std::unique_ptr<contact::ProvedContact> contact(long bits) const;
    /// True if there is friction: then q(x) is the traction in partial slip.
    [[nodiscard]] bool slips() const { return parameters.contains("friction"); }
    /// Returns the parameters in the order of their names: "a = 3/7, m = 5/8".
    [[nodiscard]] std::string text() const;
};

/// A family of scenes: lists of exact texts for each parameter, in which other parameters of the
/// family may be used ("a*2/5"). A union has the scenes of other families.
struct Family {
    std::string name;
    std::string profile;
    std::string geometry;
    std::vector<std::pair<std::string, std::vector<Expr>>> parameters;
    std::vector<Expr> knots;
    std::vector<Expr> slopes;
    /// The sampled places: fractions of the contact's length, from the edge of the claim.
    std::vector<Exact> u;
    std::size_t count = 0;  ///< the number of scenes drawn
    std::size_t points = 1; ///< the number of places in each scene
    std::vector<std::string> union_of;
    std::size_t line = 0;
    std::map<std::string, std::size_t, std::less<>> lines; ///< of the parameters

    [[nodiscard]] bool has(std::string_view parameter) const { return lines.contains(parameter); }
    /// True for bodies of revolution, with x for the radius (docs/axisymmetric.md).
    [[nodiscard]] bool axisymmetric() const {
        return geometry == "axisymmetric" || profile == "sphere" || profile == "cone";
    }
};

/// The parameters of a family that define its contact without shear.
[[nodiscard]] std::vector<std::string_view> keys_of_contact(const Family& family);

/// Throws InputError if the scene has no partial slip as docs/partial-slip.md defines it: the
/// contact slides, or the bulk tension moves the stick zone to an edge.
void require_partial_slip(const SceneSpec& scene);

/// Returns the index for sample i in a list of `size` values: every value is used once before any
/// value is used again, in a pseudo-random order given by the name (SplitMix64; the same on every
/// machine).
[[nodiscard]] std::size_t stratified_index(std::string_view name, std::size_t size, std::size_t i);

/// Returns `family.count` scenes (for a union: those of all members). Throws InputError for
/// parameters that refer to each other in a circle or that no profile admits. A scene with friction
/// and without sig0 has sig0 = 0.
[[nodiscard]] std::vector<SceneSpec> draw_scenes(const Family& family,
                                                 const std::vector<Family>& all);

} // namespace edgeproof::audit
