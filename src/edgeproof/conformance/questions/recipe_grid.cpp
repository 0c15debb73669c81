// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/recipe_grid.hpp"

#include "edgeproof/precision/error.hpp"

#include <set>
#include <utility>

namespace edgeproof::conformance {
namespace {

constexpr std::size_t most_questions = 1'000'000;

/// Returns the indices of the values of contact number `contact` on each axis; the last axis varies
/// fastest.
std::vector<std::size_t> at_contact(const std::vector<GridAxis>& axes, std::size_t contact) {
    std::vector<std::size_t> at(axes.size());
    for (std::size_t i = axes.size(); i-- > 0;) {
        at[i] = contact % axes[i].values.size();
        contact /= axes[i].values.size();
    }
    return at;
}

std::string id_of(const GridScene& scene, const std::vector<std::size_t>& at) {
    std::string id = scene.name;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const GridAxis& axis = scene.axes[i];
        id += axis.grid ? ":" + axis.key + "=" + axis.values[at[i]] : "";
    }
    return id;
}

AskedContact contact_of(const GridScene& scene, const std::vector<std::size_t>& at,
                        const std::string& file) {
    std::vector<Parameter> parameters;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const GridAxis& axis = scene.axes[i];
        parameters.push_back({axis.key, axis.values[at[i]], axis.line});
    }
    return make_asked_contact(std::move(parameters), file, scene.line);
}

[[noreturn]] void asked_twice(const std::string& id, const std::string& file, std::size_t line) {
    throw InputError("the question " + id + " is asked twice",
                     "leave one out, or give the second scene another name")
        .at(file, line);
}

/// The ids consist of the scene's name, the values of its axes and a contact's own part, so that
/// these must be distinct.
void check_names(const std::vector<GridScene>& before, const GridScene& scene,
                 const std::string& file) {
    for (const GridScene& other : before) {
        if (scene.name.starts_with(other.name + ":") || other.name.starts_with(scene.name + ":")) {
            throw InputError("the ids of " + scene.name + " may coincide with those of " +
                                 other.name,
                             "give the second scene another name")
                .at(file, scene.line);
        }
    }
    const std::vector<std::size_t> first(scene.axes.size(), 0);
    std::set<std::string_view> seen;
    for (const Question& q : scene.asked) {
        if (!seen.insert(q.id).second) {
            asked_twice(id_of(scene, first) + q.id, file, q.line);
        }
    }
    for (std::size_t i = scene.axes.size(); i-- > 0;) {
        std::set<std::string_view> values;
        for (std::size_t k = 0; k < scene.axes[i].values.size(); ++k) {
            if (!values.insert(scene.axes[i].values[k]).second) {
                std::vector<std::size_t> at = first;
                at[i] = k;
                asked_twice(id_of(scene, at) + scene.asked.front().id, file,
                            scene.asked.front().line);
            }
        }
    }
}

} // namespace

Questions questions_of(const std::vector<GridScene>& scenes, const std::string& file) {
    Questions all;
    all.file = file;
    std::vector<GridScene> before;
    for (const GridScene& scene : scenes) {
        check_names(before, scene, file);
        std::size_t contacts = 1;
        for (const GridAxis& axis : scene.axes) {
            if (axis.values.size() > most_questions / scene.asked.size() / contacts) {
                throw InputError("more than a million questions", "split the recipe")
                    .at(file, scene.asked.front().line);
            }
            contacts *= axis.values.size();
        }
        if (all.list.size() + contacts * scene.asked.size() > most_questions) {
            throw InputError("more than a million questions", "split the recipe")
                .at(file, scene.asked.front().line);
        }
        for (std::size_t c = 0; c < contacts; ++c) {
            const std::vector<std::size_t> at = at_contact(scene.axes, c);
            all.contacts.push_back(contact_of(scene, at, file));
            for (Question q : scene.asked) {
                if (c == 0) {
                    check_askable(all.contacts.back(), q, file, scene.asked_line);
                }
                q.id = id_of(scene, at) + q.id;
                q.contact = all.contacts.size() - 1;
                all.list.push_back(std::move(q));
            }
        }
        before.push_back(scene);
    }
    return all;
}

} // namespace edgeproof::conformance
