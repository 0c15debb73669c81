// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/contact/witness/witness.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/input/load_history.hpp"
#include "edgeproof/scene/input/place.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/units.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::scene {

using contact::Load;
using contact::Profile;
using contact::Route;
using contact::ShearSpec;

/// The kinds of TOML files that the program reads.
enum class FileKind { scene, recipe, ledger };

/// Returns the kind of a file by its sections; nothing if they do not decide.
[[nodiscard]] std::optional<FileKind> file_kind(const io::TomlSection& top);

/// Throws InputError if the file is certainly of another kind (a scene given for a recipe). The
/// message names both kinds and the commands that take the file.
void expect_file_kind(const io::TomlSection& top, FileKind expected);

struct AskedPoint {
    Exact u; ///< the distance from the edge, unless `place` gives it
    std::size_t line = 0;
    std::optional<Place> place = {};
    std::string written = {}; ///< as the scene writes it, if that is not a plain number
    bool computed = false;    ///< a point between the ends of a range

    [[nodiscard]] Distance distance(Edge edge) const {
        return place ? place->distance(edge) : Distance(u);
    }
    /// The text of the request: "1e-3", "a/2", "x = 0".
    [[nodiscard]] std::string text() const {
        return place ? place->text() : written.empty() ? u.text() : written;
    }
    /// The same for a table: a point that the scene does not write is a decimal.
    [[nodiscard]] std::string text(const Digits& digits) const {
        return !computed ? text()
               : place   ? "x = " + decimal_text(*place->number(), digits)
                         : decimal_text(u, digits);
    }
};

struct Ask {
    std::vector<Edge> edges{Edge::right};
    bool edges_given = false;       ///< by the file, so that they override a command's default
    std::vector<std::size_t> terms; ///< numbers of terms, in the order of the request
    std::vector<AskedPoint> u;      ///< in the order of the request; those of x come last
    std::vector<BodyPoint>
        in_bodies; ///< points of the bodies, of body A until a command asks for B
    /// The place of the surface whose displacement is 0, and the body of the surface.
    std::optional<Distance> reference;
    Body surface_of = Body::A;
    std::set<QuantityGroup> quantities;
    std::optional<Exact> tolerance;
    std::optional<Exact> process_zone; ///< a length from the edge
    contact::ExtentRange part;         ///< the part over which extents are measured
    std::optional<Route> route;        ///< a second route by which p is estimated
    Digits digits;

    [[nodiscard]] bool wants(QuantityGroup group) const { return quantities.contains(group); }
    /// The length of the longest expansion requested; 0: none.
    [[nodiscard]] std::size_t most_terms() const;
};

struct Bodies {
    Exact E1;
    Exact nu1;
    Exact E2;
    Exact nu2;
};

/// The radii of two bodies that touch; a negative one is that of a hollow.
struct Radii {
    Exact R1;
    Exact R2;
};

/// The data of an axisymmetric contact that the plane contact with the same pressure does not have
/// (docs/axisymmetric.md). The force and the approach are those of a power law, or as given; those
/// of other profiles are computed with the contact.
struct Axisymmetric {
    Profile profile; ///< as the scene gives it
    Load load;       ///< the same
    std::optional<contact::AxisymmetricPowerLaw> law = {};
    std::optional<Exact> force = {};    ///< P, the total force
    std::optional<Exact> approach = {}; ///< delta (length)
};

/// A scene as its file gives it: exact, complete, and checked as far as possible without solving
/// anything.
struct Scene {
    std::string file;
    std::string title;
    /// The profile, or (for a load of P and M) the punch whose tilt is to be found.
    std::optional<Profile> profile;
    std::optional<contact::TiltedPunch> punch;
    std::optional<Radii> radii; ///< if the profile follows from both
    Exact contact_modulus;
    std::optional<Bodies> bodies; ///< if contact_modulus follows from them
    std::optional<Exact> nu;      ///< Poisson's ratio of both, if it is given alone
    Load load;                    ///< a or P
    std::optional<Exact> moment;  ///< M, with `punch`
    std::optional<ShearSpec> shear;
    /// If the scene is axisymmetric, with x for r. The profile and the load of a power law are then
    /// those of the plane contact that has the same edge a and the same pressure.
    std::optional<Axisymmetric> round;
    /// The steps of a load history, and the state after the last one that counts, if there is
    /// friction. The load and the shear are then those at the end of that step.
    std::vector<LoadStep> steps;
    std::size_t pass = 0; ///< the number of the last steps that `cycles` repeats; 0: none
    std::size_t step = 0; ///< the number of the step that counts, from 1; 0: there are no steps
    std::optional<LoadHistory> history;
    std::optional<Units> units; ///< labels for all numbers above
    Ask ask;
    std::size_t profile_line = 0;
    std::size_t load_line = 0;
    std::size_t ask_line = 0;
    std::size_t friction_line = 0;
    std::size_t tension_line = 0; ///< the line of the friction if there is no tension

    /// True if there is friction, so that part of the contact slips.
    [[nodiscard]] bool slips() const { return shear && shear->friction; }
    /// True if the whole contact slides: q = f p or -f p.
    [[nodiscard]] bool slides() const { return shear && shear->sliding; }
    /// True if q = (Q/P) p: P and Q grow in proportion, or the whole contact slides.
    [[nodiscard]] bool proportional() const {
        return slides() || (shear && shear->path == contact::LoadingPath::together);
    }
    [[nodiscard]] const char* shear_state() const {
        return slides() ? "in full sliding" : slips() ? "in partial slip" : "under full stick";
    }
    /// Poisson's ratio of a body, if it is given.
    [[nodiscard]] std::optional<Exact> poisson(Body body) const {
        return !bodies ? nu : body == Body::A ? bodies->nu1 : bodies->nu2;
    }
    /// True for an axisymmetric contact with curved slopes, other than a power law.
    [[nodiscard]] bool curved_body() const {
        return profile && profile->axisymmetric() && !profile->piecewise_linear();
    }
    /// True for a sphere: a power law of revolution with m = 1.
    [[nodiscard]] bool is_sphere() const {
        const Rational* m = round && round->law ? round->law->m.rational() : nullptr;
        return m != nullptr && *m == 1;
    }
    /// The profile and the load as the scene gives them, also of an axisymmetric power law.
    [[nodiscard]] const Profile& given_profile() const { return round ? round->profile : *profile; }
    [[nodiscard]] const Load& given_load() const { return round ? round->load : load; }
    /// True if pressures have a closed form; otherwise they are integrals.
    [[nodiscard]] bool closed() const { return !profile || profile->has_closed_form(); }
    /// True if b = a without solving.
    [[nodiscard]] bool symmetric() const { return profile && profile->symmetric(); }
    /// The same contact under the same normal load, without a shear load and its history.
    [[nodiscard]] Scene without_shear() const {
        Scene normal = *this;
        normal.shear.reset();
        normal.history.reset();
        normal.steps.clear();
        return normal;
    }
};

/// Reads a scene (examples/README.md describes the format). Throws InputError with file and line
/// for malformed input: unknown keys and kinds, a load given twice or not at all, malformed
/// numbers. `instead`: keys that replace those of the file; errors in them name no file.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file,
                               const std::vector<io::TomlTable>& instead = {});
/// Like read_scene, but from text; errors name `file`.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::string& file,
                                const std::vector<io::TomlTable>& instead = {});
/// Like parse_scene, but from the sections of a file.
[[nodiscard]] Scene scene_of(const io::TomlSection& top);

/// Sets the state of a scene with steps, as it was read, to that after the first `count` of them;
/// without a shear load until then, the friction and the questions about shear are left out. Throws
/// InputError, with the line of the step, where the contact opens or slides, and for a bulk tension
/// that is not applied once, in the last step and at constant P.
void set_step(Scene& scene, std::size_t count);
/// Changes all steps of a scene that has them, and sets its state again. Throws as set_step().
void change_steps(Scene& scene, const std::function<void(LoadStep&)>& change);

/// Reads [profile], [load] and [shear] of `top` and ignores other sections; the request is empty.
[[nodiscard]] Scene read_contact(const io::TomlSection& top);

/// Reads a tolerance exactly: "1%", "0.01", "1/100". Throws InputError unless it is positive.
[[nodiscard]] Exact parse_tolerance(std::string_view text);

/// Returns the scene with the keys of a scene file (docs/file-formats.md), checked as if it was
/// read from a file; tables without entries are left out. Throws InputError, without file and line,
/// in the same cases as read_scene. All lines of the scene are 0.
[[nodiscard]] Scene make_scene(const std::vector<io::TomlTable>& tables,
                               const std::string& title = "");

/// The kinds of profiles.
[[nodiscard]] const std::vector<std::string_view>& profile_kinds();
/// The keys of [profile] with a number for a kind of profile; none for other names.
[[nodiscard]] std::vector<std::string_view> keys_of_profile(std::string_view kind);

/// Returns the text of the equivalent scene file, to be shown or saved.
[[nodiscard]] std::string scene_text(const std::vector<io::TomlTable>& tables,
                                     const std::string& title = "");

/// Makes a scene axisymmetric whose profile and load are given: sets Scene::round, and replaces the
/// profile and the load of a power law by those of the plane contact with the same pressure.
void revolve(Scene& scene);
/// Applies a change to the profile, the load or the modulus as the scene gives them, and derives
/// those of an axisymmetric scene from them again.
void change_given(Scene& scene, const std::function<void(Scene&)>& change);

/// Refuses a scene with |Q| >= f P, with the line of the friction; `force` is P.
[[noreturn]] void refuse_sliding(const Scene& scene, const Real& force);
/// Refuses a scene whose stick zone would extend beyond an edge (or reaches it: `reached`), with
/// the line of the bulk tension: sigma_0 has to lie between the two limits.
[[noreturn]] void refuse_tension(const Scene& scene, Edge edge, bool reached, const Real& least,
                                 const Real& most);

} // namespace edgeproof::scene
