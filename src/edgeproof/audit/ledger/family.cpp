// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/family.hpp"

#include "edgeproof/formula/expr.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/bounded_cache.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/split_mix.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <algorithm>
#include <concepts>
#include <iterator>
#include <numeric>

namespace edgeproof::audit {
namespace {

/// Returns the chosen parameters with references to other parameters replaced.
formula::Definitions resolved(const Family& family, const formula::Definitions& chosen) {
    try {
        return put_into_each_other(chosen);
    } catch (const InputError& error) {
        throw InputError("the parameters of family " + family.name + ": " + error.problem(),
                         "give at least one of them as a number");
    }
}

constexpr std::string_view loads[] = {"a", "P", "width", "delta"};
constexpr std::string_view moduli[] = {"E", "nu", "E1", "nu1", "E2", "nu2"};

/// Calls use(key of a scene, parameter) for each parameter that defines a contact without shear.
template <class Has, class Use>
void for_contact(const std::string& profile, const Has& has, const Use& use) {
    const bool punch = is_flat_punch(profile);
    for (const std::string_view key : scene::keys_of_profile(profile)) {
        if (has(key)) {
            use("profile", key, key);
        }
    }
    const auto load = std::ranges::find_if(loads, has);
    if (load != std::end(loads)) {
        use("load", *load, *load);
    }
    if (has("Es") && !punch) {
        use("load", "contact_modulus", "Es");
        return;
    }
    for (const std::string_view key : moduli) {
        if (has(key) && !punch) {
            use("load", key, key);
        }
    }
}

std::vector<io::TomlTable> tables_of(const SceneSpec& spec, bool with_shear = false) {
    std::vector<io::TomlTable> tables{{"profile", 0, {}}, {"load", 0, {}}};
    const auto put = [&](std::size_t table, std::string_view key, auto value) {
        tables[table].entries.push_back({std::string(key), std::move(value)});
    };
    if (spec.flat_punch()) {
        tables[0].entries = {{"kind", "power-law"}, {"m", "1"}, {"C", "1"}};
        put(1, "contact_modulus", std::string("1"));
    } else {
        const bool symmetric = spec.profile == "piecewise-symmetric";
        put(0, "kind", symmetric ? "piecewise" : spec.profile);
        if (symmetric) {
            put(0, "symmetric", true);
        }
    }
    if (!spec.geometry.empty()) {
        put(0, "geometry", spec.geometry);
    }
    const auto put_list = [&](const char* key, const std::vector<Expr>& list) {
        std::vector<std::string> texts;
        std::ranges::transform(list, std::back_inserter(texts), formula::to_text);
        if (!texts.empty()) {
            put(0, key, std::move(texts));
        }
    };
    put_list("knots", spec.knots);
    put_list("slopes", spec.slopes);
    for_contact(
        spec.profile, [&](std::string_view name) { return spec.parameters.contains(name); },
        [&](std::string_view table, std::string_view key, std::string_view name) {
            put(table == "load" ? 1 : 0, key, spec.parameter(name).text());
        });
    const auto has = [&](std::string_view name) { return spec.parameters.contains(name); };
    if (with_shear && has("Es") && has("nu")) {
        put(1, "nu", spec.parameter("nu").text());
    }
    if (with_shear && has("Q") && has("sig0")) { // friction has sig0 = 0 at least
        tables.push_back({"shear", 0, {{"Q", spec.parameter("Q").text()}}});
        if (spec.slips()) {
            put(2, "friction", spec.parameter("friction").text());
        }
        if (spec.parameter("sig0").sign() != 0) {
            put(2, "bulk_tension", spec.parameter("sig0").text());
        }
    }
    return tables;
}

constexpr int digits_of_slip = 8;

} // namespace

std::vector<std::string_view> keys_of_contact(const Family& family) {
    std::vector<std::string_view> names;
    for_contact(
        family.profile, [&](std::string_view name) { return family.has(name); },
        [&](std::string_view, std::string_view, std::string_view name) { names.push_back(name); });
    return names;
}

bool is_flat_punch(std::string_view profile) { return profile == "flat-punch"; }

void require_partial_slip(const SceneSpec& spec) {
    const scene::AskedValue stick{.quantity = scene::Quantity::stick_a};
    try {
        static_cast<void>(spec.parameter("Q"));
        const scene::Scene scene = scene::contact_with_keys(tables_of(spec, true));
        static_cast<void>(
            scene::SceneValues(scene, {stick}, scene::Digits{digits_of_slip}).value(stick));
    } catch (const InputError& error) {
        throw InputError(error.problem() + " (in the scene " + spec.text() + ")", error.instead());
    } catch (const Error& error) {
        throw InputError("no stick zone inside the contact is enclosed in the scene " +
                             spec.text() + ": " + error.what(),
                         "give another Q, sig0 or friction");
    }
}

const Exact& SceneSpec::parameter(std::string_view name) const {
    const auto it = parameters.find(name);
    if (it == parameters.end()) {
        throw InputError("a scene of family " + family + " has no " + std::string(name),
                         "add " + std::string(name) + " = [\"...\"] to the family");
    }
    return it->second;
}

std::map<std::string, Exact, std::less<>> SceneSpec::names() const {
    auto all = parameters;
    if (flat_punch()) {
        all.insert_or_assign("Q", parameter("P"));
        all.insert_or_assign("sig0", Exact());
    }
    return all;
}

std::shared_ptr<const scene::Scene> SceneSpec::as_scene(bool with_shear) const {
    constexpr std::size_t most_kept = 64;
    thread_local BoundedCache<std::string, const scene::Scene> kept(most_kept);
    const auto Es = parameters.find("Es");
    if (Es != parameters.end() && Es->second.sign() <= 0) { // a scene has another word for it
        throw InputError("Es = " + Es->second.text() + " is not positive", "give Es > 0");
    }
    const std::vector<io::TomlTable> tables = tables_of(*this, with_shear);
    return kept.get(scene::scene_text(tables), [&] {
        auto made = std::make_shared<const scene::Scene>(scene::contact_with_keys(tables));
        if (made->round && !made->round->law) {
            throw InputError("of the bodies of revolution a family has power laws only",
                             "write profile = \"sphere\", cone or power-law");
        }
        return made;
    });
}

std::shared_ptr<const scene::GreatestValue> SceneSpec::greatest(scene::Quantity stress,
                                                                unsigned digits) const {
    constexpr std::size_t most_kept = 64;
    thread_local BoundedCache<std::string, const scene::GreatestValue> kept(most_kept);
    const std::string key = scene::scene_text(tables_of(*this, true)) +
                            std::string(scene::row_of(stress).symbol) + std::to_string(digits);
    return kept.get(key, [&] {
        scene::Scene scene = *as_scene(true);
        scene.ask.digits.count = digits;
        if (stress == scene::Quantity::p_max) {
            scene.ask.quantities = {scene::QuantityGroup::peak};
            const scene::BoundedValue peak = scene::run_scene(scene).at(stress);
            return peak.proved ? std::make_shared<const scene::GreatestValue>(
                                     scene::GreatestValue{peak, {}, {}, {}})
                               : throw BudgetError("a greatest pressure that is not proved");
        }
        return std::make_shared<const scene::GreatestValue>(
            scene::greatest_value(scene, stress, scene::Body::A));
    });
}

std::unique_ptr<contact::ProvedContact> SceneSpec::contact(long bits) const {
    const auto made = as_scene();
    return contact::proved_contact(*made->profile, made->contact_modulus, made->load, bits);
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
            std::ranges::find_if(all, [&](const Family& f) { return f.name == member; });
        if (it == all.end()) {
            throw InputError("family " + family.name + " contains the unknown family '" + member +
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
        formula::Definitions chosen;
        for (const auto& [name, values] : family.parameters) {
            const std::size_t k = stratified_index(family.name + '/' + name, values.size(), i);
            chosen.emplace(name, values[k]);
        }
        SceneSpec scene;
        scene.family = family.name;
        scene.profile = family.profile;
        scene.geometry = family.geometry;
        const formula::Definitions parameters = resolved(family, chosen);
        for (const auto& [name, value] : parameters) {
            scene.parameters.emplace(name, Exact(value));
        }
        for (const Expr& knot : family.knots) {
            scene.knots.push_back(put_in(parameters, knot));
        }
        for (const Expr& slope : family.slopes) {
            scene.slopes.push_back(put_in(parameters, slope));
        }
        if (scene.slips()) {
            scene.parameters.try_emplace("sig0");
        }
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

} // namespace edgeproof::audit
