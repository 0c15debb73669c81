// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/commands/stress_along_ray.hpp"

#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/scene/stress_near_edge.hpp"

namespace edgeproof::cli {
namespace {

using Kind = report::Column::Kind;

std::string half_power(int halves) { return std::to_string(halves) + "/2"; }

formula::Exact angle_of(const RayOptions& o) {
    formula::Exact angle;
    try {
        angle = formula::Exact::parse(o.angle);
    } catch (const InputError& error) {
        throw InputError("--angle " + o.angle + ": " + error.problem(), error.instead());
    }
    if (angle.sign() < 0 ||
        formula::Exact(angle.expr() - formula::Exact::of(Rational(180)).expr()).sign() > 0) {
        throw InputError(
            "--angle " + o.angle + " does not lie in the body",
            "write degrees from 0 (along the contact) to 180 (along the free surface)");
    }
    return angle;
}

/// The scene and the table, to which the rows are added.
struct Asked {
    explicit Asked(const RayOptions& o)
        : body(o.body.empty() ? "A" : o.body), angle(angle_of(o)), scene(asked_scene(o)) {
        ask_at_edges(scene, o);
        ask_terms(scene);
    }
    report::Table table(const RayOptions& o) {
        ask_for(scene, {}, scene::QuantityGroup::contact, {});
        report::Table made = values_table(scene, done(scene, o));
        made.facts.push_back({"body", body});
        made.facts.push_back({"angle", angle.text()});
        made.notes = {"stresses in body " + body +
                      ", tension positive, along the ray at this angle (degrees) to the surface of "
                      "the contact: x = a - r cos(angle) or -b + r cos(angle), z = r sin(angle)"};
        return made;
    }
    template <class F> auto compute(const F& f) {
        return io::at_place(scene.file, scene.load_line,
                            [&] { return f(scene, body_of(body), angle); });
    }
    std::string body;
    formula::Exact angle;
    scene::Scene scene;
};

} // namespace

void add_ray_options(CLI::App& sub, RayOptions& o) {
    sub.add_option("--angle", o.angle,
                   "stresses instead of the pressure, along a ray into the body at this angle: 0 "
                   "degrees is along the contact, 90 downwards, 180 along the free surface");
    sub.add_option("--body", o.body, "with --angle: the body, A (default; Q acts on it) or B")
        ->type_name("A|B");
}

bool along_ray(const RayOptions& o) {
    if (o.angle.empty()) {
        refuse_options({{"--body", o.body}}, "without --angle no stress is computed");
        return false;
    }
    refuse_options({{"--quantity", o.quantities}, {"--figure", o.figure}},
                   "with --angle only the stresses are computed");
    return true;
}

int expand_stresses(const RayOptions& o) {
    Asked asked(o);
    const auto terms = asked.compute(
        [&](const auto&... all) { return scene::ray_terms(all..., asked.scene.ask.most_terms()); });
    report::Table table = asked.table(o);
    table.notes.emplace_back("each stress is the sum of its coefficients times r^power; |value - "
                             "exact| <= bound");
    table.asked = "coefficients of the stresses near the edges";
    table.remarks.emplace_back("bounds are proved, and every digit printed is right");
    Columns<scene::RayTerm> columns(asked.scene);
    columns.add("edge", Kind::text, [](const auto& t) { return scene::edge_name(t.edge); }).phrase =
        "{} edge";
    columns.add("power", Kind::text, [](const auto& t) { return half_power(t.halves); }).phrase =
        "r^({}):";
    for (std::size_t i = 0; i < scene::ray_stresses.size(); ++i) {
        columns.add_value(std::string(row_of(scene::ray_stresses[i]).name),
                          i + 1 == scene::ray_stresses.size() ? "route" : "",
                          [i](const auto& t) { return t.values[i]; });
    }
    columns.write(table, terms);
    emit(table, o);
    return 0;
}

} // namespace edgeproof::cli
