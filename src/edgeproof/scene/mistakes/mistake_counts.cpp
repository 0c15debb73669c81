// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/mistakes/scene_mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>
#include <sstream>

namespace edgeproof::scene {

namespace {

std::string cell_of(const MistakeCount& count) {
    std::string text = count.cases > 0 ? fmt::format("{}/{}", count.named, count.cases) : "-";
    text += count.beyond > 0 ? fmt::format(" +{}", count.beyond) : "";
    return text + (count.wrong > 0 ? fmt::format(" WRONG {}", count.wrong) : "");
}

using Change = std::function<std::optional<SceneKeys>(const SceneKeys&)>;

double number_in(const SceneKeys& keys, const std::string& key) { return std::stod(keys.at(key)); }

/// Changes contacts that have one of the keys.
Change with(const std::vector<std::string>& names, const std::function<void(SceneKeys&)>& change) {
    return [=](const SceneKeys& keys) -> std::optional<SceneKeys> {
        if (std::ranges::none_of(names, [&](const auto& name) { return keys.contains(name); })) {
            return {};
        }
        SceneKeys changed = keys;
        change(changed);
        return changed;
    };
}
/// Changes the numbers of those keys that the scene has.
Change with_key(const std::vector<std::string>& names,
                const std::function<double(double)>& change) {
    return with(names, [=](SceneKeys& keys) {
        for (const std::string& name : names) {
            if (keys.contains(name)) {
                keys[name] = fmt::format("{:.17g}", change(number_in(keys, name)));
            }
        }
    });
}
Change times_key(const std::string& name, double k) {
    return with_key({name}, [k](double x) { return k * x; });
}

/// Replaces E* by a function of the bodies' constants.
Change with_modulus(const std::function<double(double, double, double, double)>& modulus) {
    return with({"load.E1"}, [=](SceneKeys& keys) {
        const double E = modulus(number_in(keys, "load.E1"), number_in(keys, "load.nu1"),
                                 number_in(keys, "load.E2"), number_in(keys, "load.nu2"));
        for (const char* const key : {"load.E1", "load.nu1", "load.E2", "load.nu2"}) {
            keys.erase(key);
        }
        keys["load.contact_modulus"] = fmt::format("{:.17g}", E);
    });
}
double first_of(double E1, double nu1) { return E1 / (1 - nu1 * nu1); }

} // namespace

void MistakeCounts::count(const MistakeTrial& trial) {
    auto row = std::ranges::find(rows, trial.mistake, &MistakeRow::name);
    if (row == rows.end()) {
        row = rows.insert(rows.end(), MistakeRow{trial.mistake});
    }
    const bool right = trial.mistake.empty();
    const auto is_it = [&](const std::string& name) { return name == trial.mistake; };
    const bool named = right ? trial.named.empty() : std::ranges::any_of(trial.named, is_it);
    const bool found = named && !trial.hidden;
    const bool wrong = trial.misled || (!named && !trial.named.empty());
    MistakeCount& count = row->at.at(trial.level);
    count.cases += trial.hidden ? 0 : 1;
    count.beyond += trial.hidden ? 1 : 0;
    count.named += found ? 1 : 0;
    count.alone += found && std::ranges::all_of(trial.named, is_it) ? 1 : 0;
    count.wrong += wrong ? 1 : 0;
    if (wrong || (!named && !trial.hidden)) {
        misses.push_back(
            fmt::format("{} in {}, noise {:g}: {} ({})", right ? "right data" : trial.mistake,
                        trial.contact, noise.at(trial.level),
                        trial.named.empty() ? "nothing is named"
                                            : fmt::format("named {}", fmt::join(trial.named, ", ")),
                        trial.measured));
    }
}

MistakeCount MistakeCounts::total() const {
    MistakeCount sum;
    for (const MistakeRow& row : rows) {
        for (const MistakeCount& count : row.at) {
            sum.wrong += count.wrong;
            if (row.name.empty()) {
                continue;
            }
            sum.cases += count.cases;
            sum.named += count.named;
            sum.alone += count.alone;
            sum.beyond += count.beyond;
        }
    }
    return sum;
}

bool MistakeCounts::passes(std::size_t percent) const {
    const MistakeCount sum = total();
    return sum.cases > 0 && sum.wrong == 0 && 100 * sum.named >= percent * sum.cases;
}

std::string MistakeCounts::text() const {
    std::string out = "| mistake |";
    std::string rule = "|---|";
    for (const double level : noise) {
        out += fmt::format(" {:g} |", level);
        rule += "---|";
    }
    out += "\n" + rule + "\n";
    for (const MistakeRow& row : rows) {
        out += "| " + (row.name.empty() ? "none" : "`" + row.name + "`") + " |";
        for (std::size_t level = 0; level < noise.size(); ++level) {
            out += " " + cell_of(row.at.at(level)) + " |";
        }
        out += "\n";
    }
    out += "\n";
    for (const std::string& miss : misses) {
        out += miss + "\n";
    }
    const MistakeCount sum = total();
    return out + fmt::format("{} of {} cases named ({} of them alone), {} hidden by the noise, {} "
                             "wrongly named, in {} contacts\n",
                             sum.named, sum.cases, sum.alone, sum.beyond, sum.wrong, contacts);
}

/// Reads "profile.R=2 load.P=3".
SceneKeys keys_of(const std::string& text) {
    SceneKeys keys;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const std::size_t equals = word.find('=');
        keys.emplace(word.substr(0, equals), word.substr(equals + 1));
    }
    return keys;
}

Scene scene_of(const SceneKeys& keys) {
    SceneEntries entries;
    for (const auto& [key, value] : keys) {
        const std::size_t dot = key.find('.');
        const std::string section = key.substr(0, dot);
        (section == "profile" ? entries.profile
         : section == "load"  ? entries.load
                              : entries.shear)
            .push_back({key.substr(dot + 1), value});
    }
    return make_scene(entries);
}

const std::vector<InjectedKeys>& injected_keys() {
    static const auto tangent = [](double x) { return std::tan(x); };
    static const auto degrees = [](double x) { return x * 180 / std::numbers::pi; };
    static const std::vector<std::string> angles{"profile.phi", "profile.alpha"};
    static const std::vector<InjectedKeys> list{
        {"e-for-e-star", false, with_modulus([](double E1, double, double, double) { return E1; })},
        {"one-body-modulus", false,
         with_modulus([](double E1, double nu1, double, double) { return first_of(E1, nu1); })},
        {"one-body-modulus", false,
         with_modulus([](double, double, double E2, double nu2) { return first_of(E2, nu2) / 2; })},
        {"nu-not-squared", false, with_modulus([](double E1, double nu1, double E2, double nu2) {
             return 1 / ((1 - nu1) / E1 + (1 - nu2) / E2);
         })},
        {"plane-stress", false,
         with_modulus([](double E1, double, double E2, double) { return 1 / (1 / E1 + 1 / E2); })},
        {"shear-modulus", false, with_modulus([](double E1, double nu1, double E2, double nu2) {
             return 1 / ((1 + nu1) / E1 + (1 + nu2) / E2);
         })},
        {"shear-modulus", false, with_modulus([](double E1, double nu1, double E2, double nu2) {
             const auto with_g = [](double E, double nu) {
                 return 2 * (1 + nu) * (1 - nu * nu) / E;
             };
             return 1 / (with_g(E1, nu1) + with_g(E2, nu2));
         })},
        {"sum-of-moduli", false, with_modulus([](double E1, double nu1, double E2, double nu2) {
             return first_of(E1, nu1) + first_of(E2, nu2);
         })},
        {"sum-of-moduli", false,
         with_modulus([](double E1, double, double E2, double) { return E1 + E2; })},
        {"factor-2", false, with_modulus([](double E1, double nu1, double E2, double nu2) {
             return 0.5 / ((1 - nu1 * nu1) / E1 + (1 - nu2 * nu2) / E2);
         })},
        {"radius-as-diameter", false, times_key("profile.R", 2)},
        {"radius-as-diameter", false,
         with_key({"profile.R1", "profile.R2"}, [](double R) { return R / 2; })},
        {"one-body-radius", false, with_key({"profile.R2"}, [](double) { return 1e30; })},
        {"flat-as-full-width", false, times_key("profile.t", 0.5)},
        {"half-force", false, times_key("load.P", 0.5)},
        {"force-per-radian", false,
         [](const SceneKeys& keys) -> std::optional<SceneKeys> {
             return keys.contains("profile.geometry")
                        ? times_key("load.P", 1 / (2 * std::numbers::pi))(keys)
                        : std::nullopt;
         }},
        {"plane-for-axisymmetric", false,
         with({"profile.geometry"}, [](SceneKeys& keys) { keys.erase("profile.geometry"); })},
        {"half-approach", false, times_key("load.delta", 0.5)},
        {"full-width-for-half", false, times_key("load.a", 2)},
        {"sign-of-moment", false, times_key("load.M", -1)},
        {"half-moment", false, times_key("load.M", 0.5)},
        {"tangent-of-angle", false, with_key(angles, tangent)},
        {"degrees", false, with_key(angles, degrees)},
        {"no-tilt", false, times_key("profile.alpha", 0)},
        {"half-shear-force", true, times_key("shear.Q", 0.5)},
        {"half-tension", true, times_key("shear.bulk_tension", 0.5)},
        {"no-tension", true, times_key("shear.bulk_tension", 0)},
        {"sign-of-tension", true, times_key("shear.bulk_tension", -1)},
        {"no-slip", true,
         with({"shear.friction"}, [](SceneKeys& keys) { keys.erase("shear.friction"); })},
    };
    return list;
}

} // namespace edgeproof::scene
