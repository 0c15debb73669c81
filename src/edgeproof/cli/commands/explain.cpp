// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/error_place.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>

namespace edgeproof::cli {
namespace {

struct ExplainOptions : SceneOptions {
    bool run = false;
};

std::string profile_text(const scene::Scene& scene) {
    if (scene.punch) {
        const contact::TiltedPunch& punch = *scene.punch;
        return punch.kind == contact::Profile::Kind::tilted_wedge
                   ? "tilted-wedge, phi = " + punch.phi.text() + ", alpha to be found"
                   : "tilted-flat-and-rounded, t = " + punch.t.text() + ", R = " + punch.R.text() +
                         ", alpha to be found";
    }
    const contact::Profile& profile = scene.given_profile();
    std::string text = profile.kind_name();
    for (const auto& [name, value] : profile.parameters()) {
        text += fmt::format(", {} = {}", name, value.text());
    }
    return text + (scene.round ? ", axisymmetric" : "");
}

std::string asked_text(const scene::Scene& scene) {
    std::string text;
    for (const scene::QuantityGroup group : scene.ask.quantities) {
        text += (text.empty() ? "" : ", ") + group_name(group);
    }
    text += scene.ask.edges.size() == 2 ? "; both edges"
                                        : "; the " + scene::edge_name(scene.ask.edges[0]) + " edge";
    if (!scene.ask.u.empty()) {
        text += fmt::format("; u at {} point{}", scene.ask.u.size(),
                            scene.ask.u.size() == 1 ? "" : "s");
    }
    for (std::size_t i = 0; i < scene.ask.terms.size(); ++i) {
        text += (i == 0 ? "; n = " : ", ") + std::to_string(scene.ask.terms[i]);
    }
    return text;
}

std::string planned_text(const scene::Effect& effect, const contact::Counts& counts) {
    return effect.on && effect.counter != nullptr ? std::to_string(counts.*effect.counter)
           : effect.on                            ? ""
                                                  : "0";
}

std::string narrow_text(const scene::Plan& plan) {
    return plan.narrow_bits < plan.bits
               ? fmt::format(" ({} for the contact and pressures)", plan.narrow_bits)
               : "";
}

/// Counts the values by kind and route.
class Tally {
public:
    explicit Tally(const scene::SceneResult& result) {
        for (const scene::Row& row : result.rows) {
            if (row.value && row.reached) {
                ++(row.value->proved ? proved_ : estimated_)[row.value->route];
            }
        }
    }
    [[nodiscard]] bool all_proved() const { return estimated_.empty(); }
    [[nodiscard]] std::string text() const {
        const std::string proved = list("proved", proved_);
        const std::string estimated = list("estimated", estimated_);
        return proved + (proved.empty() || estimated.empty() ? "" : "; ") + estimated;
    }

private:
    using Routes = std::map<std::string, std::size_t>;
    /// Returns a text such as "proved: 6 values (4 by series, 2 by given)".
    static std::string list(const char* kind, const Routes& routes) {
        std::size_t all = 0;
        std::string each;
        for (const auto& [route, count] : routes) {
            all += count;
            each += fmt::format("{}{} {}", each.empty() ? "" : "; ", count, route);
        }
        return all == 0 ? ""
                        : fmt::format("{}: {} value{} ({})", kind, all, all == 1 ? "" : "s", each);
    }

    Routes proved_;
    Routes estimated_;
};

int explain(const ExplainOptions& o) {
    const scene::Scene scene = asked_scene(o);
    const scene::Plan plan =
        io::at_place(scene.file, scene.load_line, [&] { return make_plan(scene); });
    report::Table table;
    table.title = scene.title.empty() ? scene.file : scene.title;
    using Kind = contact::Load::Kind;
    std::string load =
        scene.round ? scene.round->load_text()
                    : (scene.load.kind == Kind::force ? "P = " : "a = ") + scene.load.value.text();
    if (scene.moment) {
        load += ", M = " + scene.moment->text();
    }
    table.facts = {{"scene", scene.file},
                   {"profile", profile_text(scene)},
                   {"load", load + ", contact_modulus = " + scene.contact_modulus.text()},
                   {"asked", asked_text(scene)},
                   {"route", way_of_pressure(scene, plan)},
                   {"bounds", (plan.proved ? "proved: " : "estimated: ") + plan.proved_why},
                   {"precision",
                    plan.proved ? fmt::format("balls of {} bits at first{}, more where {} digits "
                                              "are not determined by them",
                                              plan.bits, narrow_text(plan), plan.digits.count)
                                : fmt::format("{} digits at first for {}, more where edges, knots "
                                              "and points lie close",
                                              plan.working_digits, plan.digits.count)},
                   {"quadratures", std::to_string(plan.counts.quadratures)}};
    table.columns = {{"effect", report::Column::Kind::text},
                     {"on", report::Column::Kind::text},
                     {"planned", report::Column::Kind::count}};
    contact::Work work;
    bool as_planned = true;
    if (o.run) {
        const scene::SceneResult result = done(scene);
        const Tally tally(result);
        work = result.work;
        as_planned = work.counts == plan.counts && (tally.all_proved() || !plan.proved);
        for (report::Fact& fact : table.facts) {
            if (fact.key == "bounds") {
                fact.value = tally.text();
            }
        }
        table.columns.push_back({"done", report::Column::Kind::count});
        table.facts.push_back({"raised", fmt::format("{} time{} to a higher precision", work.raised,
                                                     work.raised == 1 ? "" : "s")});
        table.facts.push_back(
            {"evaluations", std::to_string(work.evaluations) + " of integrands of pressures"});
        table.facts.push_back({"done as planned", as_planned ? "yes" : "no"});
    }
    table.columns.push_back({"why", report::Column::Kind::text});
    for (const scene::Effect& effect : plan.effects) {
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
    return as_planned ? 0 : 1;
}

} // namespace

void add_explain(CLI::App& app, int& code) {
    auto [sub, o] = add_command<ExplainOptions>(
        app, code, "explain", "what a scene calls for: the effects that are on and off, and why",
        explain);
    o.format = "md";
    add_scene_options(sub, o);
    sub.add_flag("--run", o.run, "run the scene, and show the work done next to the plan");
}

} // namespace edgeproof::cli
