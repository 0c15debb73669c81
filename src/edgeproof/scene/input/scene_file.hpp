// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/routes/extent.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/shear_traction.hpp"
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/input/place.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/units.hpp"

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::io {
class TomlSection;
}

namespace edgeproof::scene {

/// A point, and the line of the file that it was asked on.
struct AskedPoint {
    formula::Exact u; ///< the distance from the edge, unless `place` tells it
    std::size_t line = 0;
    std::optional<Place> place = {};
    std::string written = {}; ///< as the scene writes it, where that is no plain number

    [[nodiscard]] Distance distance(contact::Edge edge) const {
        return place ? place->distance(edge) : Distance(u);
    }
    /// As it was asked: "1e-3", "a/2", "x = 0".
    [[nodiscard]] std::string text() const {
        return place ? place->text() : written.empty() ? u.text() : written;
    }
};

struct Ask {
    std::vector<contact::Edge> edges{contact::Edge::right};
    bool edges_given = false;       ///< in the file, so that a command's own choice gives way
    std::vector<std::size_t> terms; ///< numbers of terms, in the order asked
    std::vector<AskedPoint> u;      ///< in the order asked; those of x behind
    std::set<QuantityGroup> quantities;
    std::optional<formula::Exact> tolerance;
    std::optional<formula::Exact> process_zone; ///< a length from the edge
    contact::ExtentRange part;                  ///< that extents are measured over
    contact::Route route = contact::Route::automatic;
    Digits digits;

    [[nodiscard]] bool wants(QuantityGroup group) const { return quantities.contains(group); }
    /// The longest expansion asked for; 0: none.
    [[nodiscard]] std::size_t most_terms() const;
};

/// The elastic constants of the two bodies.
struct Bodies {
    formula::Exact E1;
    formula::Exact nu1;
    formula::Exact E2;
    formula::Exact nu2;
};

/// The radii of two bodies that touch; a negative one is a hollow's.
struct Radii {
    formula::Exact R1;
    formula::Exact R2;
};

/// A scene as its file gives it: exact, complete, and checked as far as that goes without solving
/// anything.
struct Scene {
    std::string file;
    std::string title;
    /// The profile, or (with a load of P and M) the punch whose tilt is to be found.
    std::optional<contact::Profile> profile;
    std::optional<contact::TiltedPunch> punch;
    std::optional<Radii> radii; ///< where the profile follows from both
    formula::Exact contact_modulus;
    std::optional<Bodies> bodies;         ///< where contact_modulus follows from them
    contact::Load load;                   ///< a or P
    std::optional<formula::Exact> moment; ///< M, with `punch`
    std::optional<contact::ShearSpec> shear;
    std::optional<Units> units; ///< of all that is above: labels
    Ask ask;
    std::size_t profile_line = 0;
    std::size_t load_line = 0;
    std::size_t ask_line = 0;
    std::size_t friction_line = 0;
    std::size_t tension_line = 0; ///< that of the friction where there is no tension

    /// There is friction, so that the shear slips in part.
    [[nodiscard]] bool slips() const { return shear && shear->friction; }
    /// b = a, and nothing is solved for it.
    [[nodiscard]] bool symmetric() const { return profile && profile->symmetric(); }
};

/// Reads a scene (examples/README.md says what goes into one). Throws InputError with file and line
/// for whatever is malformed: unknown keys and kinds, a load given twice or not at all, numbers
/// that are none.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file, std::string_view asked = {});
/// The same from text; `file` is what errors name. `asked`: an [ask] of a command line, in TOML;
/// its keys stand for those of the file, and its errors name no file.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::string& file,
                                std::string_view asked = {});

/// [profile], [load] and [shear] of `top`, whatever else it has; nothing is asked.
[[nodiscard]] Scene read_contact(const io::TomlSection& top);

/// "1%", "0.01", "1/100": a tolerance, exactly. Throws InputError unless it is positive.
[[nodiscard]] formula::Exact parse_tolerance(std::string_view text);

} // namespace edgeproof::scene
