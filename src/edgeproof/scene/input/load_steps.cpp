// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a load history: how they are read, and the state after some of them.
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::scene {
namespace {

constexpr long most_cycles = 1000;

} // namespace

void read_steps(const io::TomlSection& top, Scene& scene) {
    const std::vector<io::TomlSection> sections = top.sections_or_none("step");
    std::size_t first = sections.size(); // the step with `cycles`
    std::size_t cycles = 1;
    LoadStep now;
    const auto read = [&](const io::TomlSection& section) {
        for (const auto& [key, member] :
             {std::pair{"P", &LoadStep::P}, std::pair{"Q", &LoadStep::Q},
              std::pair{"bulk_tension", &LoadStep::bulk_tension}}) {
            if (section.has(key)) {
                now.*member = contact_constant(section, key);
                (void)sign_of(section, key, now.*member);
            }
        }
        now.line = section.line();
        scene.steps.push_back(now);
    };
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const io::TomlSection& section = sections[i];
        section.allow({"P", "Q", "bulk_tension", "cycles"});
        if (section.has("cycles")) {
            if (first < i) {
                section.reject("cycles", "cycles is given in two steps", "give it in one");
            }
            first = i;
            cycles = section.count("cycles", 1, most_cycles);
        }
        read(section);
    }
    scene.pass = sections.size() - first;
    for (std::size_t k = 1; k < cycles; ++k) {
        std::for_each(sections.begin() + static_cast<std::ptrdiff_t>(first), sections.end(), read);
    }
}

void set_step(Scene& scene, std::size_t count) {
    const LoadStep& last = scene.steps.at(count - 1);
    const auto none = [](const LoadStep& step) {
        return step.Q.sign() == 0 && step.bulk_tension.sign() == 0;
    };
    const auto reject = [&](const std::string& problem, const std::string& instead) {
        throw InputError("step " + std::to_string(count) + ": " + problem, instead)
            .at(scene.file, last.line);
    };
    scene.load_line = last.line;
    scene.step = count;
    scene.history.reset();
    if (last.P.sign() <= 0) {
        reject("there is no contact: P = " + last.P.text(), "give P > 0");
    }
    change_given(scene, [&](Scene& s) { s.load = contact::Load::force(last.P); });
    const auto begin = scene.steps.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    if (std::all_of(begin, end, none)) {
        if (scene.shear && scene.shear->bulk_A.sign() != 0) {
            reject("bulk_A is given, but no shear load", "leave bulk_A out, or add Q to a step");
        }
        scene.shear.reset();
        scene.ask.quantities.erase(QuantityGroup::shear);
        scene.ask.quantities.erase(QuantityGroup::slip);
        return;
    }
    if (!scene.shear || !scene.shear->friction) {
        reject("a shear load of a history needs a friction", "add [shear] with friction = \"0.6\"");
    }
    scene.shear->Q = last.Q;
    scene.shear->bulk_tension = last.bulk_tension;
    if (std::any_of(begin, end, [](const LoadStep& s) { return s.bulk_tension.sign() != 0; })) {
        const bool once = count > 1 && std::all_of(begin, end - 1, none) &&
                          formula::Exact(last.P.expr() - (end - 2)->P.expr()).sign() == 0;
        if (!once || last.Q.sign() == 0) {
            reject("a bulk tension is computed only where it is applied once, together with Q, in "
                   "the last step and at constant P: the zones of slip that it changes are no "
                   "superposition",
                   "apply P first, then Q and bulk_tension in one step, and ask for the state "
                   "after it");
        }
        return;
    }
    scene.history =
        history_after(scene.steps, count, scene.pass, *scene.shear->friction, scene.file);
}

void change_steps(Scene& scene, const std::function<void(LoadStep&)>& change) {
    std::ranges::for_each(scene.steps, change);
    set_step(scene, scene.step);
}

} // namespace edgeproof::scene
