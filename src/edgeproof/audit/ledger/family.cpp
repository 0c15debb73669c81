// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/family.hpp"

#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/split_mix.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace edgeproof::audit {
namespace {

/// Puts the parameters chosen into each other until none of their names is left.
std::map<std::string, formula::Exact, std::less<>>
resolved(const Family& family, const std::map<std::string, formula::Expr>& chosen,
         std::vector<formula::Expr>* others) {
    const auto resolve = [&](formula::Expr e, const std::string& what) {
        for (std::size_t round = 0; round <= chosen.size(); ++round) {
            const std::set<std::string> free = free_symbols(e);
            bool changed = false;
            for (const auto& [name, value] : chosen) {
                if (free.contains(name)) {
                    e = substitute(e, name, value);
                    changed = true;
                }
            }
            if (!changed) {
                return e;
            }
        }
        throw InputError("the parameters of family " + family.name +
                             " refer to each other in a circle at " + what,
                         "give at least one of them as a number");
    };
    std::map<std::string, formula::Exact, std::less<>> parameters;
    for (const auto& [name, value] : chosen) {
        parameters.emplace(name, formula::Exact(resolve(value, name)));
    }
    if (others != nullptr) {
        for (formula::Expr& e : *others) {
            e = resolve(e, "a knot or slope");
        }
    }
    return parameters;
}

} // namespace

const formula::Exact& SceneSpec::parameter(std::string_view name) const {
    const auto it = parameters.find(name);
    if (it == parameters.end()) {
        throw InputError("a scene of family " + family + " has no " + std::string(name),
                         "add " + std::string(name) + " = [\"...\"] to the family");
    }
    return it->second;
}

contact::Profile SceneSpec::make_profile() const {
    if (profile == "power-law") {
        return contact::Profile::power_law(parameter("C"), parameter("m"));
    }
    if (profile == "flat-and-rounded") {
        return contact::Profile::flat_and_rounded(parameter("t"), parameter("R"));
    }
    if (profile == "tilted-wedge") {
        return contact::Profile::tilted_wedge(parameter("phi"), parameter("alpha"));
    }
    if (profile == "tilted-flat-and-rounded") {
        return contact::Profile::tilted_flat_and_rounded(parameter("alpha"), parameter("t"),
                                                         parameter("R"));
    }
    if (profile == "piecewise") {
        return contact::Profile::piecewise(knots, slopes);
    }
    if (profile == "piecewise-symmetric") {
        return contact::Profile::piecewise_symmetric(knots, slopes);
    }
    throw InputError("unknown profile '" + profile + "'",
                     "write power-law, flat-and-rounded, tilted-wedge, tilted-flat-and-rounded, "
                     "piecewise or piecewise-symmetric");
}

std::string SceneSpec::text() const {
    std::string text;
    for (const auto& [name, value] : parameters) {
        text += (text.empty() ? "" : ", ") + name + " = " + value.text();
    }
    return text;
}

std::size_t stratified_index(std::string_view name, std::size_t size, std::size_t i) {
    if (size <= 1) {
        return 0;
    }
    SplitMix64 random(io::fnv1a(name) + 0x632be59bd9b4e019ULL * (i / size));
    std::vector<std::size_t> order(size);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t k = size - 1; k > 0; --k) {
        std::swap(order[k], order[random.below(k + 1)]);
    }
    return order[i % size];
}

std::vector<SceneSpec> draw_scenes(const Family& family, const std::vector<Family>& all) {
    std::vector<SceneSpec> scenes;
    for (const std::string& member : family.union_of) {
        const auto it =
            std::find_if(all.begin(), all.end(), [&](const Family& f) { return f.name == member; });
        if (it == all.end()) {
            throw InputError("family " + family.name + " takes in the unknown family '" + member +
                                 "'",
                             "name a family of this ledger");
        }
        std::vector<SceneSpec> drawn = draw_scenes(*it, all);
        if (family.count != 0 && drawn.size() > family.count) {
            drawn.erase(drawn.begin() + static_cast<std::ptrdiff_t>(family.count), drawn.end());
        }
        scenes.insert(scenes.end(), drawn.begin(), drawn.end());
    }
    if (!family.union_of.empty()) {
        return scenes;
    }
    for (std::size_t i = 0; i < family.count; ++i) {
        std::map<std::string, formula::Expr> chosen;
        for (const auto& [name, values] : family.parameters) {
            const std::size_t k = stratified_index(family.name + '/' + name, values.size(), i);
            chosen.emplace(name, values[k]);
        }
        std::vector<formula::Expr> others = family.knots;
        others.insert(others.end(), family.slopes.begin(), family.slopes.end());
        SceneSpec scene;
        scene.family = family.name;
        scene.profile = family.profile;
        scene.parameters = resolved(family, chosen, &others);
        for (std::size_t k = 0; k < others.size(); ++k) {
            if (k < family.knots.size()) {
                scene.knots.emplace_back(others[k]);
            } else {
                scene.slopes.push_back(others[k]);
            }
        }
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

} // namespace edgeproof::audit
