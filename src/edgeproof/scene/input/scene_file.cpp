// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/scene_file.hpp"

#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/file_kind.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <utility>

namespace edgeproof::scene {
namespace {

constexpr int shown_digits = 8;

void read_sections(const io::TomlSection& top, Scene& scene) {
    read_steps(top, scene);
    if (top.has("units")) {
        scene.units = read_units(top.section("units"));
    }
    const io::TomlSection load = top.section("load");
    const auto reading = [&](const io::TomlSection& section, const auto& read) {
        io::at_place(section.file(), section.line(), [&] { read(section, scene); });
    };
    reading(load, read_load);
    reading(top.section("profile"), [](const io::TomlSection& profile, Scene& s) {
        read_profile(profile, s.moment.has_value(), s);
    });
    const io::TomlSection profile = top.section("profile");
    if (is_axisymmetric(profile)) {
        reading(profile, [](const io::TomlSection& section, Scene& s) {
            require_axisymmetric(section, s);
            revolve(s);
        });
    } else if (load.has("delta")) {
        load.reject("delta", "the approach delta of a plane contact is undetermined",
                    "give a or P, or write geometry = \"axisymmetric\" in [profile]");
    }
    reading(load, check_reach);
    if (!scene.steps.empty()) {
        read_shear_of_steps(top, scene);
        set_step(scene, scene.steps.size());
    } else if (top.has("shear")) {
        reading(top.section("shear"), read_shear);
    }
}

/// Errors in an [ask] given on the command line, and errors of its points, have no line numbers.
void read_asked_instead(const std::vector<io::TomlEntry>& asked, const io::TomlSection& profile,
                        Scene& scene) {
    const std::vector<AskedPoint> points = std::exchange(scene.ask.u, {});
    const std::size_t line = scene.ask_line;
    try {
        read_ask(io::TomlSection::made({{"ask", 0, asked}}, "").section("ask"), profile, scene);
    } catch (const InputError& error) {
        throw InputError(error.problem(), error.instead());
    }
    scene.ask_line = scene.ask.u.empty() ? line : 0;
    if (scene.ask.u.empty()) {
        scene.ask.u = points;
    }
    for (AskedPoint& point : scene.ask.u) {
        point.line = scene.ask_line == 0 ? 0 : point.line;
    }
}

} // namespace

Scene read_contact(const io::TomlSection& top) {
    Scene scene;
    scene.file = top.file();
    read_sections(top, scene);
    return scene;
}

Scene scene_of(const io::TomlSection& top, const std::vector<io::TomlEntry>& asked) {
    expect_file_kind(top, FileKind::scene);
    top.allow({"title", "units", "profile", "load", "shear", "step", "ask"});
    Scene scene;
    scene.file = top.file();
    if (top.has("title")) {
        scene.title = top.text("title");
    }
    read_sections(top, scene);
    if (top.has("ask")) {
        const io::TomlSection ask = top.section("ask");
        const io::TomlSection profile = top.section("profile");
        io::at_place(ask.file(), ask.line(), [&] { read_ask(ask, profile, scene); });
    }
    if (!asked.empty()) {
        read_asked_instead(asked, top.section("profile"), scene);
    }
    default_quantities(scene.ask, scene.shear.has_value(), scene.slips());
    return scene;
}

Scene parse_scene(std::string_view text, const std::string& file,
                  const std::vector<io::TomlEntry>& asked) {
    return scene_of(io::TomlSection::parse(text, file), asked);
}

Scene read_scene(const std::filesystem::path& file, const std::vector<io::TomlEntry>& asked) {
    return parse_scene(io::read_text(file, "scene (TOML)", io::most_toml_bytes),
                       io::input_name(file), asked);
}

void require_no_history(const Scene& scene, const std::string& command) {
    if (!scene.steps.empty()) {
        throw InputError(command + " computes no load histories",
                         "give P and Q in [load] and [shear] instead of steps")
            .at(scene.file, scene.steps.front().line);
    }
}

void require_plane(const Scene& scene, const std::string& command) {
    if (scene.round) {
        throw InputError(command + " computes plane contacts only",
                         "leave geometry out of [profile], or use edgeproof pressure, expand or "
                         "extent")
            .at(scene.file, scene.profile_line);
    }
}

void refuse_sliding(const Scene& scene, const Real& force) {
    const contact::ShearSpec& shear = *scene.shear;
    const Real most = force * shear.friction->to<Real>();
    throw InputError("the contact slides: Q = " + shear.Q.text() +
                         ", but f P = " + most.str(shown_digits),
                     "give a smaller Q, or a greater friction, so that |Q| < f P")
        .at(scene.file, scene.friction_line);
}

void refuse_tension(const Scene& scene, contact::Edge edge, bool reached, const Real& least,
                    const Real& most) {
    throw InputError("bulk_tension = " + scene.shear->bulk_tension.text() +
                         " moves the stick zone " + (reached ? "to the " : "beyond the ") +
                         edge_name(edge) +
                         (reached ? " edge to within all digits, so that nothing slips there"
                                  : " edge, which would slip in the direction opposite to Q"),
                     "give a bulk_tension between " + least.str(shown_digits) + " and " +
                         most.str(shown_digits) + ", the bounds for this Q")
        .at(scene.file, scene.tension_line);
}

} // namespace edgeproof::scene
