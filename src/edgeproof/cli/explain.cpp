// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <memory>

namespace edgeproof::cli {
namespace {

struct ExplainOptions : SceneOptions {
    bool run = false;
};

std::string profile_text(const Scene& scene) {
    if (scene.punch) {
        const TiltedPunch& punch = *scene.punch;
        return punch.kind == Profile::Kind::tilted_wedge
                   ? "tilted-wedge, phi = " + punch.phi.text() + ", alpha to be found"
                   : "tilted-flat-and-rounded, t = " + punch.t.text() + ", R = " + punch.R.text() +
                         ", alpha to be found";
    }
    std::string text = scene.profile->kind_name();
    for (const auto& [name, value] : scene.profile->parameters()) {
        text += fmt::format(", {} = {}", name, value.text());
    }
    return text;
}

std::string asked_text(const Scene& scene) {
    std::string text;
    for (const Quantity q : scene.ask.quantities) {
        text += (text.empty() ? "" : ", ") + quantity_name(q);
    }
    text += scene.ask.edges.size() == 2 ? "; both edges"
                                        : "; the " + edge_name(scene.ask.edges[0]) + " edge";
    if (!scene.ask.u.empty()) {
        text += fmt::format("; u at {} point{}", scene.ask.u.size(),
                            scene.ask.u.size() == 1 ? "" : "s");
    }
    for (std::size_t i = 0; i < scene.ask.terms.size(); ++i) {
        text += (i == 0 ? "; n = " : ", ") + std::to_string(scene.ask.terms[i]);
    }
    return text;
}

std::string planned_text(const Effect& effect, const Counts& counts) {
    return effect.on && effect.counter != nullptr ? std::to_string(counts.*effect.counter)
           : effect.on                            ? ""
                                                  : "0";
}

std::string narrow_text(const Plan& plan) {
    return plan.narrow_bits < plan.bits
               ? fmt::format(" ({} for the contact and pressures)", plan.narrow_bits)
               : "";
}

int explain(const ExplainOptions& o) {
    const Scene scene = asked_scene(o);
    const Plan plan = at_place(scene.file, scene.load_line, [&] { return make_plan(scene); });
    Table table;
    table.title = scene.title.empty() ? scene.file : scene.title;
    const bool force = scene.load.kind == Load::Kind::force;
    std::string load = (force ? "P = " : "a = ") + scene.load.value.text();
    if (scene.moment) {
        load += ", M = " + scene.moment->text();
    }
    table.facts = {{"scene", scene.file},
                   {"profile", profile_text(scene)},
                   {"load", load + ", contact_modulus = " + scene.contact_modulus.text()},
                   {"asked", asked_text(scene)},
                   {"route", route_name(plan.route)},
                   {"bounds", (plan.proved ? "proved: " : "estimated: ") + plan.proved_why},
                   {"precision",
                    plan.proved ? fmt::format("balls of {} bits at first{}, more where {} digits "
                                              "are not settled by them",
                                              plan.bits, narrow_text(plan), plan.digits.count)
                                : fmt::format("{} digits at first for {}, more where edges, knots "
                                              "and points lie close",
                                              plan.working_digits, plan.digits.count)},
                   {"quadratures", std::to_string(plan.counts.quadratures)}};
    table.columns = {{"effect", Column::Kind::text},
                     {"on", Column::Kind::text},
                     {"planned", Column::Kind::count}};
    Work work;
    if (o.run) {
        work = done(scene).work;
        table.columns.push_back({"done", Column::Kind::count});
        table.facts.push_back({"raised", fmt::format("{} time{} to a higher precision", work.raised,
                                                     work.raised == 1 ? "" : "s")});
        table.facts.push_back(
            {"evaluations", std::to_string(work.evaluations) + " of integrands of pressures"});
        table.facts.push_back({"done as planned", work.counts == plan.counts ? "yes" : "no"});
    }
    table.columns.push_back({"why", Column::Kind::text});
    for (const Effect& effect : plan.effects) {
        std::vector<std::string> row{effect.name, effect.on ? "on" : "off",
                                     planned_text(effect, plan.counts)};
        if (o.run) {
            row.push_back(effect.counter == nullptr ? row.back()
                                                    : std::to_string(work.counts.*effect.counter));
        }
        row.push_back(effect.why);
        table.rows.push_back(std::move(row));
    }
    emit(table, o);
    return !o.run || work.counts == plan.counts ? 0 : 1;
}

} // namespace

void add_explain(CLI::App& app, int& code) {
    CLI::App* sub = app.add_subcommand(
        "explain", "what a scene calls for: the effects that are on and off, and why");
    auto o = std::make_shared<ExplainOptions>();
    o->format = "md";
    add_scene_options(*sub, *o);
    sub->add_flag("--run", o->run, "do it, and show what was done beside what was planned");
    sub->callback([o, &code] { code = explain(*o); });
}

} // namespace edgeproof::cli
