// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/exact/exact.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::contact {
class ProvedSlip;
}

namespace edgeproof::audit {

/// One scene of a family: exact.
struct SceneSpec {
    std::string family;  ///< the family that it was drawn from (not the union of families)
    std::string profile; ///< "power-law", ...
    /// Every parameter of the family: those of the profile, `a` (or `P`), `Es` (E*), and its own.
    std::map<std::string, formula::Exact, std::less<>> parameters;
    /// For profile "piecewise": slopes in x between ascending knots.
    std::vector<formula::Exact> knots;
    std::vector<formula::Expr> slopes;

    [[nodiscard]] const formula::Exact& parameter(std::string_view name) const;
    [[nodiscard]] contact::Profile make_profile() const;
    /// There is friction, so that the contact slips at its edges and q(x) is the traction of that.
    [[nodiscard]] bool slips() const { return parameters.contains("friction"); }
    /// That partial slip, enclosed. Throws as ProvedSlip does.
    [[nodiscard]] contact::ProvedSlip partial_slip(long bits) const;
    /// "a = 3/7, m = 5/8": the parameters in the order of their names.
    [[nodiscard]] std::string text() const;
};

/// A family of scenes, as data: lists of exact texts for each parameter, in which other parameters
/// of the family may stand ("a*2/5"). Unions hold the members of other families.
struct Family {
    std::string name;
    std::string profile;
    std::vector<std::pair<std::string, std::vector<formula::Expr>>> parameters;
    std::vector<formula::Expr> knots;
    std::vector<formula::Expr> slopes;
    /// Fractions of the contact's length, from the edge that a claim names, at which it is asked.
    std::vector<formula::Exact> u;
    std::size_t count = 0;  ///< scenes drawn from it
    std::size_t points = 1; ///< places in each scene
    std::vector<std::string> union_of;
    std::size_t line = 0;
    std::map<std::string, std::size_t, std::less<>> lines; ///< of the parameters

    [[nodiscard]] bool has(std::string_view parameter) const { return lines.contains(parameter); }
};

/// The parameters that a profile needs. Throws InputError for a profile that does not exist.
[[nodiscard]] const std::vector<std::string_view>& profile_keys(const std::string& profile);
/// Its slope is given piece by piece, by `knots` and `slopes`.
[[nodiscard]] bool is_piecewise(std::string_view profile);

/// Throws InputError where the scene has no partial slip as docs/partial-slip.md defines it: the
/// contact slides, or the bulk tension draws the stick zone to an edge.
void require_partial_slip(const SceneSpec& scene);

/// A deterministic walk through a list of `size` values for sample i: every value comes up before
/// any comes again, in an order that the name decides (SplitMix64; the same on every machine).
[[nodiscard]] std::size_t stratified_index(std::string_view name, std::size_t size, std::size_t i);

/// `family.count` scenes (for a union: those of all members). Throws InputError for parameters
/// that refer to each other in a circle or that no profile admits. A scene with friction and
/// without sig0 has sig0 = 0.
[[nodiscard]] std::vector<SceneSpec> draw_scenes(const Family& family,
                                                 const std::vector<Family>& all);

} // namespace edgeproof::audit
