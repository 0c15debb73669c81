// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/routes/extent.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/shear_traction.hpp"
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/scene/bounded_value.hpp"

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::scene {

/// What may be asked of a scene.
enum class Quantity {
    pressure,     ///< p at points, and its n-term approximations
    coefficients, ///< c_0, c_1, ... at edges (with shear: those of q too)
    shear,        ///< q at points
    extent,       ///< how far n terms stay within a tolerance
    contact       ///< a, b, P and M
};
[[nodiscard]] std::string quantity_name(Quantity quantity);

/// u, and the line of the file that it was asked on.
struct AskedPoint {
    formula::Exact u;
    std::size_t line = 0;
};

struct Ask {
    std::vector<contact::Edge> edges{contact::Edge::right};
    std::vector<std::size_t> terms; ///< numbers of terms, in the order asked
    std::vector<AskedPoint> u;      ///< in the order asked
    std::set<Quantity> quantities;
    std::optional<formula::Exact> tolerance;
    std::optional<formula::Exact> process_zone; ///< a length from the edge
    contact::ExtentRange part;                  ///< that extents are measured over
    contact::Route route = contact::Route::automatic;
    Digits digits;

    [[nodiscard]] bool wants(Quantity quantity) const { return quantities.contains(quantity); }
    /// The longest expansion asked for; 0: none.
    [[nodiscard]] std::size_t most_terms() const;
};

/// A scene as its file gives it: exact, complete, and checked as far as that goes without solving
/// anything.
struct Scene {
    std::string file;
    std::string title;
    /// The profile, or (with a load of P and M) the punch whose tilt is to be found.
    std::optional<contact::Profile> profile;
    std::optional<contact::TiltedPunch> punch;
    formula::Exact contact_modulus;
    contact::Load load;                   ///< a or P
    std::optional<formula::Exact> moment; ///< M, with `punch`
    std::optional<contact::ShearSpec> shear;
    Ask ask;
    std::size_t profile_line = 0;
    std::size_t load_line = 0;
    std::size_t ask_line = 0;

    /// b = a, and nothing is solved for it.
    [[nodiscard]] bool symmetric() const { return profile && profile->symmetric(); }
};

/// Reads a scene (examples/README.md says what goes into one). Throws InputError with file and line
/// for whatever is malformed: unknown keys and kinds, a load given twice or not at all, numbers
/// that are none.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file);
/// The same from text; `file` is what errors name.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::string& file);

/// "right" and "left"; "pressure", "coefficients", ...: as in a scene file. Nothing for other
/// names.
[[nodiscard]] std::string edge_name(contact::Edge edge);
[[nodiscard]] std::optional<Quantity> quantity_named(std::string_view name);

/// "1%", "0.01", "1/100": a tolerance, exactly. Throws InputError unless it is positive.
[[nodiscard]] formula::Exact parse_tolerance(std::string_view text);

} // namespace edgeproof::scene
