// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <string>
#include <string_view>

/// The readers of the sections of a scene, and what they share.
namespace edgeproof::scene {

/// Returns the contact and the shear of a scene with these keys of its file, without a request. It
/// may end on a flat, so that it carries no load, and have any exponent. Errors name no file.
[[nodiscard]] Scene contact_with_keys(const std::vector<io::TomlTable>& tables);

/// Fills in the profile or the punch of a scene from [profile]; with `tilt_unknown`, alpha must be
/// absent.
void read_profile(const io::TomlSection& section, bool tilt_unknown, Scene& scene);

/// Refuses an exponent of a power law for which searches would not end.
void check_exponent(const io::TomlSection& profile);

/// Fills in the load and the materials of a scene, whose steps are known, from [load].
void read_load(const io::TomlSection& load, Scene& scene);
/// Refuses a load that does not suit the profile: a contact that ends on the flat carries no load,
/// and half the width is an edge only if b = a.
void check_reach(const io::TomlSection& load, const Scene& scene);

/// Fills in the shear of a scene without steps, whose contact is known, from [shear].
void read_shear(const io::TomlSection& shear, Scene& scene);
/// Fills in the friction and bulk_A of a scene with steps, from [shear] of `top`, if it is there.
void read_shear_of_steps(const io::TomlSection& top, Scene& scene);

/// Fills in the steps of a scene from the [[step]] of `top`. What a step leaves out keeps its
/// value; the contact begins unloaded. `cycles` in a step is the number of times that the steps
/// from this one to the last are gone through.
void read_steps(const io::TomlSection& top, Scene& scene);

/// Fills in the request of a scene, whose contact is known, from [ask]. Places may use the keys of
/// `profile` as names, in addition to a and b.
void read_ask(const io::TomlSection& section, const io::TomlSection& profile, Scene& scene);

/// Reads `edges`, each at most once.
[[nodiscard]] std::vector<Edge> read_edges(const io::TomlSection& section);
/// Returns the ascending points of { from, to, per_decade } or { from, to, points }, at most
/// 100,000; with `even`, only the latter. `end` reads from and to.
using EndOfRange = std::function<Exact(const io::TomlSection& range, std::string_view end)>;
[[nodiscard]] std::vector<Exact> points_of_range(const io::TomlSection& section,
                                                 std::string_view key, bool even,
                                                 const EndOfRange& end);

/// The names that places of a scene may use in addition to a and b: the parameters of its profile,
/// a and b themselves if they are given, and b as a if the two are equal.
[[nodiscard]] Place::Names names_of(const Scene& scene);
/// Reads u and x of a section, lists or ranges; places are in these names, a and b.
[[nodiscard]] std::vector<AskedPoint> read_places(const io::TomlSection& ask,
                                                  const Place::Names& names);
/// Returns the point of a body at x and the depth z, which are formulas in the names, a and b.
/// Throws InputError for a number z < 0, too.
[[nodiscard]] BodyPoint body_point(const std::string& x, const std::string& z, Body body,
                                   const Place::Names& names);

/// True if [profile] says geometry = "axisymmetric".
[[nodiscard]] bool is_axisymmetric(const io::TomlSection& profile);
/// Refuses a profile that is not computed as a body of revolution.
void require_axisymmetric(const io::TomlSection& profile, const Scene& scene);

/// Sets the quantities of a scene that does not name them: all for which it gives the data.
void default_quantities(Ask& ask, bool shear, bool friction);

[[nodiscard]] inline Expr whole(long k) { return Expr::number(Rational(k)); }

/// E* of 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
[[nodiscard]] inline Expr composite_modulus(const Expr& E1, const Expr& nu1, const Expr& E2,
                                            const Expr& nu2) {
    return whole(1) / ((whole(1) - nu1 * nu1) / E1 + (whole(1) - nu2 * nu2) / E2);
}

/// True if x < y, for constants.
[[nodiscard]] inline bool is_less(const Expr& x, const Expr& y) { return Exact(x - y).sign() < 0; }

/// Returns the sign of the value of a key, or of a value derived from it.
[[nodiscard]] int sign_of(const io::TomlSection& section, std::string_view key, const Exact& value);

/// Refuses the value of a key unless it is positive.
void require_positive(const io::TomlSection& section, std::string_view key, const Exact& value,
                      const std::string& instead);

/// Throws InputError, with the line of the key, unless every number of the expression and its value
/// (where it has no names) are 0 or between 1e-10000 and 1e10000 in size: the range of what defines
/// a contact. Beyond it, searches and integrals take endless work. `text`: as it is written.
void check_size(const io::TomlSection& section, std::string_view key, const Expr& e,
                std::string_view text);

/// The constant of a key of [profile], [load] or [shear], of a size within that range.
[[nodiscard]] Exact contact_constant(const io::TomlSection& section, std::string_view key);

} // namespace edgeproof::scene
